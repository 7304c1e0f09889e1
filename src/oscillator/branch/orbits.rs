//! The curve of orbits with one impact pattern, and the functions whose zeros are its events.

use super::{
    Bifurcation, crossing,
    curve::{Curve, CurvePoint, Equations},
    follow::{Followed, Settled},
    problem::{FollowedOrbit, PatternFamily, PatternOf, monitors},
};
use crate::{
    error::Result,
    oscillator::orbit::{Family, Root},
};

/// The solutions of the pattern equations over a range of a parameter: the unknowns are those of the pattern
/// and, last, the parameter in units of its own.
pub struct PatternCurve<'a, F: PatternFamily + ?Sized> {
    /// The systems, with slopes.
    pub family: &'a F,
    /// The pattern.
    pub itinerary: PatternOf<F::Orbit>,
    /// The parameter where the last unknown is 0.
    origin: f64,
    /// The parameter's unit of length along the curve.
    unit: f64,
    /// Bounds of the last unknown.
    bounds: (f64, f64),
}

/// Those of oscillators of one degree of freedom.
pub type Orbits<'a> = PatternCurve<'a, dyn Family + 'a>;

impl<F: PatternFamily + ?Sized> Clone for PatternCurve<'_, F> {
    fn clone(&self) -> Self {
        PatternCurve { itinerary: self.itinerary.clone(), ..*self }
    }
}

impl<'a, F: PatternFamily + ?Sized> PatternCurve<'a, F> {
    /// The orbits of a pattern over a range of the parameter, whose length is the parameter's unit.
    pub fn over(family: &'a F, itinerary: PatternOf<F::Orbit>, (low, high): (f64, f64)) -> Self {
        PatternCurve { family, itinerary, origin: low, unit: high - low, bounds: (0.0, 1.0) }
    }

    /// The orbits of a pattern up to `reach` away from a parameter value: lengths are those of times, speeds
    /// and the parameter over `unit`.
    pub fn around(family: &'a F, itinerary: PatternOf<F::Orbit>, centre: f64, unit: f64, reach: f64) -> Self {
        PatternCurve { family, itinerary, origin: centre, unit, bounds: (-reach / unit, reach / unit) }
    }

    /// The same with another pattern.
    #[must_use]
    pub fn with(&self, itinerary: PatternOf<F::Orbit>) -> Self {
        PatternCurve { itinerary, ..*self }
    }

    /// The parameter's bounds.
    pub fn range(&self) -> (f64, f64) {
        (self.origin + self.bounds.0 * self.unit, self.origin + self.bounds.1 * self.unit)
    }

    /// The parameter at a point.
    pub fn parameter(&self, u: &[f64]) -> f64 {
        self.origin + u[u.len() - 1] * self.unit
    }

    /// The parameter's unit of length along the curve.
    pub(super) fn unit(&self) -> f64 {
        self.unit
    }

    /// The unknowns of an orbit at a parameter value.
    pub fn unknowns(&self, z: &[f64], parameter: f64) -> Vec<f64> {
        z.iter().copied().chain([(parameter - self.origin) / self.unit]).collect()
    }

    /// Whether a parameter value is between the bounds.
    pub(super) fn contains(&self, parameter: f64) -> bool {
        let (low, high) = self.range();
        low < high && (low..=high).contains(&parameter)
    }
}

impl<F: PatternFamily + ?Sized> Curve for PatternCurve<'_, F> {
    fn equations(&self, u: &[f64]) -> Result<Equations> {
        let mut found = self.family.equations(self.parameter(u), &self.itinerary, &u[..u.len() - 1])?;
        for (row, slope) in found.jacobian.iter_mut().zip(&found.slope) {
            row.push(slope * self.unit);
        }
        Ok(Equations { residual: found.residual, jacobian: found.jacobian })
    }
}

impl<F: PatternFamily + ?Sized> Followed for PatternCurve<'_, F> {
    type View = F::Orbit;

    fn view(&self, place: &CurvePoint) -> Result<F::Orbit> {
        let z = place.u[..place.u.len() - 1].to_vec();
        let root = Root { z, residual: place.residual, steps: place.steps as usize };
        self.family.orbit(self.parameter(&place.u), &self.itinerary, root)
    }

    fn monitors(&self, place: &CurvePoint, orbit: &F::Orbit) -> Vec<Option<f64>> {
        monitors(orbit, place.tangent.last().copied())
    }

    /// Where the branch turns back the tangent alone tells.
    fn monitor(&self, which: usize, place: &CurvePoint) -> Result<Option<f64>> {
        if which == Bifurcation::SaddleNode as usize {
            return Ok(place.tangent.last().copied());
        }
        Ok(self.monitors(place, &self.view(place)?)[which])
    }

    fn holds(&self, orbit: &F::Orbit) -> bool {
        orbit.is_orbit()
    }

    fn bounds(&self) -> Vec<(usize, f64, f64)> {
        vec![(self.family.count(&self.itinerary), self.bounds.0, self.bounds.1)]
    }

    /// Where branches cross both monitors of a multiplier 1 may vanish: the Jacobian's rank tells.
    fn settle(
        &self,
        monitor: usize,
        mut place: CurvePoint,
        mut orbit: F::Orbit,
    ) -> Result<Settled<F::Orbit>> {
        let mut what = Bifurcation::of(monitor);
        if matches!(what, Bifurcation::SaddleNode | Bifurcation::Crossing) {
            let crosses = crossing::is_near(self, &place)?;
            if crosses {
                what = Bifurcation::Crossing;
                if let Ok(found) = crossing::locate(self, &place) {
                    place = found.place;
                    orbit = self.view(&place)?;
                }
            } else if what == Bifurcation::Crossing {
                return Ok(None);
            }
        }
        Ok(what.is_at(&orbit).then_some((what as usize, place, orbit)))
    }
}
