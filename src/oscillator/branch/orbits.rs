//! The curve of orbits with one impact pattern, and the functions whose zeros are its events.

use super::{
    Bifurcation, crossing,
    curve::{Curve, CurvePoint, Equations},
    follow::{Followed, Settled},
};
use crate::{
    error::Result,
    oscillator::orbit::{Family, Itinerary, Orbit, Root, Unknowns, describe, linearise},
};

/// The solutions of the pattern equations over a range of a parameter: the unknowns are those of the pattern
/// and, last, the parameter in units of its own.
#[derive(Clone)]
pub struct Orbits<'a> {
    /// The oscillators, with slopes.
    pub family: &'a dyn Family,
    /// The pattern.
    pub itinerary: Itinerary,
    /// The parameter where the last unknown is 0.
    origin: f64,
    /// The parameter's unit of length along the curve.
    unit: f64,
    /// Bounds of the last unknown.
    bounds: (f64, f64),
}

impl<'a> Orbits<'a> {
    /// The orbits of a pattern over a range of the parameter, whose length is the parameter's unit.
    pub fn over(family: &'a dyn Family, itinerary: Itinerary, (low, high): (f64, f64)) -> Orbits<'a> {
        Orbits { family, itinerary, origin: low, unit: high - low, bounds: (0.0, 1.0) }
    }

    /// The orbits of a pattern up to `reach` away from a parameter value: lengths are those of times, speeds
    /// and the parameter as they are.
    pub fn around(family: &'a dyn Family, itinerary: Itinerary, centre: f64, reach: f64) -> Orbits<'a> {
        Orbits { family, itinerary, origin: centre, unit: 1.0, bounds: (-reach, reach) }
    }

    /// The same with another pattern.
    #[must_use]
    pub fn with(&self, itinerary: Itinerary) -> Orbits<'a> {
        Orbits { itinerary, ..self.clone() }
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

impl Curve for Orbits<'_> {
    fn equations(&self, u: &[f64]) -> Result<Equations> {
        let oscillator = self.family.at(self.parameter(u))?;
        let mut found = linearise(&oscillator, &self.itinerary, &u[..u.len() - 1])?;
        for (row, slope) in found.jacobian.iter_mut().zip(&found.slope) {
            row.push(slope * self.unit);
        }
        Ok(Equations { residual: found.residual, jacobian: found.jacobian })
    }
}

impl Followed for Orbits<'_> {
    type View = Orbit;

    fn view(&self, place: &CurvePoint) -> Result<Orbit> {
        let oscillator = self.family.at(self.parameter(&place.u))?;
        let z = place.u[..place.u.len() - 1].to_vec();
        describe(
            &oscillator,
            &self.itinerary,
            Root { z, residual: place.residual, steps: place.steps as usize },
        )
    }

    fn monitors(&self, place: &CurvePoint, orbit: &Orbit) -> Vec<Option<f64>> {
        monitors(orbit, place.tangent.last().copied())
    }

    fn holds(&self, orbit: &Orbit) -> bool {
        orbit.admissibility.is_admissible()
    }

    fn bounds(&self) -> Vec<(usize, f64, f64)> {
        vec![(Unknowns::count(&self.itinerary), self.bounds.0, self.bounds.1)]
    }

    /// Where branches cross both monitors of a multiplier 1 may vanish: the Jacobian's rank tells.
    fn settle(&self, monitor: usize, mut place: CurvePoint, mut orbit: Orbit) -> Result<Settled<Orbit>> {
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

/// The functions whose zeros are events, in their order, the speeds last; `turn` is the tangent's parameter
/// component, if there is one parameter. Multipliers grow like 1/V at an impact of small speed V: the product
/// of the speeds takes the poles away. (1−λ₁)(1−λ₂) vanishes with `turn` at a saddle-node, and alone where
/// branches cross.
pub(super) fn monitors(orbit: &Orbit, turn: Option<f64>) -> Vec<Option<f64>> {
    let finite = |x: f64| Some(x).filter(|x| x.is_finite());
    let speeds = || orbit.impacts().map(|impact| impact.speed);
    let scale: f64 = speeds().product();
    let multipliers = &orbit.multipliers;
    let complex = multipliers.trace.abs() < 1.0 + multipliers.determinant;
    let incoming = speeds().all(|speed| speed > 0.0);
    let mut all = vec![
        turn.or_else(|| finite(multipliers.fold() * scale)),
        turn.and_then(|turn| finite(multipliers.fold() * scale / turn)),
        finite(multipliers.flip() * scale),
        complex.then_some(multipliers.determinant - 1.0),
        orbit.least.filter(|_| incoming).map(|least| least.gap),
    ];
    all.extend(speeds().map(Some));
    all
}
