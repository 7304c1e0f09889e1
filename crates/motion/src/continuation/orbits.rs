//! The curve of orbits with one impact pattern, and the functions whose zeros are its events.

use super::{
    Bifurcation, crossing,
    curve::{Corrector, Curve, CurvePoint, Equations, difference, dot, largest},
    follow::{Followed, Settled},
    level::Level,
    problem::{FollowedOrbit, PatternFamily, PatternOf, monitors},
};
use crate::{
    continuation::Root,
    error::{Error, Result},
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
    /// What is told along it beside bifurcations.
    pub(super) levels: &'a [Level<'a, F::Orbit>],
}

impl<F: PatternFamily + ?Sized> Clone for PatternCurve<'_, F> {
    fn clone(&self) -> Self {
        PatternCurve { itinerary: self.itinerary.clone(), ..*self }
    }
}

impl<'a, F: PatternFamily + ?Sized> PatternCurve<'a, F> {
    /// The orbits of a pattern over a range of the parameter, whose length is the parameter's unit.
    pub fn over(family: &'a F, itinerary: PatternOf<F::Orbit>, (low, high): (f64, f64)) -> Self {
        PatternCurve { family, itinerary, origin: low, unit: high - low, bounds: (0.0, 1.0), levels: &[] }
    }

    /// The same, with labels where functions take values.
    #[must_use]
    pub fn telling(self, levels: &'a [Level<'a, F::Orbit>]) -> Self {
        PatternCurve { levels, ..self }
    }

    /// The orbits of a pattern up to `reach` away from a parameter value: lengths are those of times, speeds
    /// and the parameter over `unit`.
    pub(crate) fn around(
        family: &'a F,
        itinerary: PatternOf<F::Orbit>,
        centre: f64,
        unit: f64,
        reach: f64,
    ) -> Self {
        let bounds = (-reach / unit, reach / unit);
        PatternCurve { family, itinerary, origin: centre, unit, bounds, levels: &[] }
    }

    /// The same with another pattern.
    #[must_use]
    pub(crate) fn with(&self, itinerary: PatternOf<F::Orbit>) -> Self {
        PatternCurve { itinerary, ..*self }
    }

    /// The parameter's bounds.
    pub(crate) fn range(&self) -> (f64, f64) {
        (self.origin + self.bounds.0 * self.unit, self.origin + self.bounds.1 * self.unit)
    }

    /// The parameter at a point.
    pub(crate) fn parameter(&self, u: &[f64]) -> f64 {
        self.origin + u[u.len() - 1] * self.unit
    }

    /// The parameter's unit of length along the curve.
    pub(super) fn unit(&self) -> f64 {
        self.unit
    }

    /// The unknowns of an orbit at a parameter value.
    pub(crate) fn unknowns(&self, z: &[f64], parameter: f64) -> Vec<f64> {
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
        let parameter = self.parameter(&place.u);
        let mut all: Vec<_> = self.levels.iter().map(|level| level.off(orbit, &[parameter])).collect();
        all.extend(monitors(orbit, place.tangent.last().copied()));
        all
    }

    /// Where the branch turns back the tangent alone tells.
    fn monitor(&self, which: usize, place: &CurvePoint) -> Result<Option<f64>> {
        if which == self.levels.len() + Bifurcation::SaddleNode as usize {
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

    fn is_time(&self, unknown: usize) -> bool {
        unknown < self.family.count(&self.itinerary) && self.family.is_time(&self.itinerary, unknown)
    }

    fn differs(&self, before: &F::Orbit, after: &F::Orbit) -> bool {
        !before.slides_as(after)
    }

    fn bends(&self, before: &F::Orbit, after: &F::Orbit) -> bool {
        self.differs(before, after) || !before.begins_as(after)
    }

    fn changed(&self, before: &F::Orbit, after: &F::Orbit) -> usize {
        before.changed(after) as usize
    }

    /// A branch of doubled orbits comes to the flip of the orbit that they are born from: the orbit there
    /// repeats after half its period, those before and after it do not, and a turn round the point is a shift
    /// by half the period.
    fn repeats(&self, event: &CurvePoint, beside: [&CurvePoint; 2]) -> bool {
        let Some(here) = self.asymmetry(&event.u) else { return false };
        let there = beside.map(|place| self.asymmetry(&place.u).unwrap_or(0.0));
        let most = there[0].max(there[1]);
        most > SAME && here <= 1e-4 * most
    }

    /// Where branches cross both monitors of a multiplier 1 may vanish: where one of them crosses another and
    /// turns back there is one event, the crossing.
    fn settle(
        &self,
        monitor: usize,
        mut place: CurvePoint,
        mut orbit: F::Orbit,
    ) -> Result<Settled<F::Orbit>> {
        let Some(monitor) = monitor.checked_sub(self.levels.len()) else {
            let is_at = self.levels[monitor].is_at(&orbit, &[self.parameter(&place.u)]);
            return Ok(is_at.then_some((Bifurcation::ALL.len() + monitor, place, orbit)));
        };
        let impacts = self.itinerary.strikes().len();
        let mut what = Bifurcation::of(monitor, impacts);
        if matches!(what, Bifurcation::SaddleNode | Bifurcation::Crossing) {
            match crossing::locate(self, &place) {
                Ok(found) if what == Bifurcation::Crossing || self.turns_at(&found.place, &place) => {
                    what = Bifurcation::Crossing;
                    place = found.place;
                    orbit = self.view(&place)?;
                }
                Ok(_) => {}
                Err(_) if crossing::is_near(self, &place)? => what = Bifurcation::Crossing,
                Err(_) if what == Bifurcation::Crossing => return Ok(None),
                Err(_) => {}
            }
        }
        if !what.is_at(&orbit) {
            return Ok(None);
        }
        if what == Bifurcation::Torus {
            let circle = (monitor + 1).saturating_sub(Bifurcation::Fade as usize + impacts);
            let circle = if monitor == what as usize { 0 } else { circle };
            let beyond = |place: &CurvePoint| self.view(place).ok()?.circles().get(circle).copied();
            if !changes_sign(self, &place, beyond) {
                return Ok(None);
            }
        }
        Ok(Some((what as usize, place, orbit)))
    }
}

impl<F: PatternFamily + ?Sized> PatternCurve<'_, F> {
    /// Whether a curve that turns back in the parameter does so where it crosses another, and not beside:
    /// near the crossing the equations are nearly singular, and where exactly the tangent's component
    /// vanishes is lost. It is linear there: points on both sides, so far away that the tangents are certain,
    /// tell. A place is known to rounding of its unknowns, a tangent at the distance h from the crossing to
    /// that over h, the zero to that over h², and to how far the curve is from a parabola, which grows with
    /// h: a turn is beside the crossing if the nearest points and the farthest say so.
    fn turns_at(&self, crossing: &CurvePoint, turn: &CurvePoint) -> bool {
        let size = 1.0 + largest(&crossing.u);
        let off = dot(&difference(&turn.u, &crossing.u), &crossing.tangent).abs();
        let slope = |by: f64| {
            let place = CERTAIN.step(self, crossing, by)?;
            Ok::<_, Error>(place.tangent.last().copied().unwrap_or(f64::NAN))
        };
        let beside = |aside: f64| {
            let (Ok(ahead), Ok(behind)) = (slope(aside * size), slope(-aside * size)) else { return false };
            let zero = aside * size * (ahead + behind) / (behind - ahead);
            zero.abs() > off / 2.0
        };
        off <= SAME * size || ![0.1 * APART, APART, 10.0 * APART].into_iter().all(beside)
    }

    /// What is left of the equations of half the pattern, of the first half of the impacts, as a part of what
    /// they are added up from; `None` if the pattern is not twice another.
    fn asymmetry(&self, u: &[f64]) -> Option<f64> {
        let (half, z) = self.family.once(&self.itinerary, &u[..u.len() - 1])?;
        let found = self.family.equations(self.parameter(u), &half, &z).ok()?;
        let size = |row: &Vec<f64>| row.iter().zip(&z).map(|(slope, z)| (slope * z).abs()).sum::<f64>();
        let sizes: Vec<f64> = found.jacobian.iter().map(size).collect();
        let least = FELT * largest(&sizes);
        let parts = found.residual.iter().zip(&sizes).map(|(f, size)| f / size.max(least));
        Some(largest(&parts.collect::<Vec<_>>()))
    }
}

/// So far from a crossing, along the curve, a tenth of that and ten times that, tangents are looked at, as
/// parts of the size of the unknowns.
const APART: f64 = 1e-4;

/// Points of a curve that are closer than this part of the size of the unknowns are one: Newton's method
/// tells them apart no better.
const SAME: f64 = 1e-9;

/// An equation that is added up from less than this part of the largest is measured by that: what nothing
/// moves consists of rounding, 10⁻¹⁵ of the largest, which is [`SAME`] times this.
const FELT: f64 = 1e-6;

/// Newton's method beside events.
const CERTAIN: Corrector = Corrector { tolerance: 1e-11, steps: 20 };

/// Whether a function has opposite signs a little before and after a point, however close one has to go.
pub(super) fn changes_sign(
    curve: &impl Curve,
    place: &CurvePoint,
    function: impl Fn(&CurvePoint) -> Option<f64>,
) -> bool {
    [1e-3, 1e-4, 1e-5, 1e-6].into_iter().any(|by| {
        let at = |by: f64| function(&CERTAIN.step(curve, place, by).ok()?);
        matches!((at(-by), at(by)), (Some(a), Some(b)) if a * b < 0.0)
    })
}
