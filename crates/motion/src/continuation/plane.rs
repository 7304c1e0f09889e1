//! An event followed in two parameters: the pattern equations with one more, that the event's function is
//! zero, or another function of the orbits at its value.

use super::{
    Bifurcation, Degeneracy, OrbitCurve, Singularity,
    criticality::Estimate,
    crossing::DIFFERENCE,
    curve::{Curve, CurvePoint, Equations},
    follow::{Followed, Settled},
    level::Level,
    orbits::changes_sign,
    problem::{FollowedOrbit, PatternOf, PatternPlane, monitors},
};
use crate::{
    continuation::Root,
    error::{Error, Result},
};

/// The orbits of a pattern at which one event happens, or a function has a value: the unknowns are those of
/// the pattern and both parameters as fractions of their ranges.
pub struct EventCurve<'a, P: PatternPlane + ?Sized> {
    /// The systems.
    pub plane: &'a P,
    /// The pattern.
    pub itinerary: PatternOf<P::Orbit>,
    /// What happens all along; none where the first of `levels` keeps its value.
    pub event: Option<Bifurcation>,
    /// The bounds of both parameters.
    pub ranges: [(f64, f64); 2],
    /// What is told along it beside bifurcations.
    pub levels: &'a [Level<'a, P::Orbit>],
}

impl<'a, P: PatternPlane + ?Sized> EventCurve<'a, P> {
    /// What is told along it.
    fn told(&self) -> &'a [Level<'a, P::Orbit>] {
        &self.levels[usize::from(self.event.is_none())..]
    }

    fn split<'u>(&self, u: &'u [f64]) -> (&'u [f64], [f64; 2]) {
        let (z, last) = u.split_at(u.len() - 2);
        (z, [0, 1].map(|i| self.ranges[i].0 + last[i] * (self.ranges[i].1 - self.ranges[i].0)))
    }

    /// The point near an orbit, its unknowns in the units of a [`Label`](super::Label), at both parameter
    /// values, on the way to larger values of the second.
    ///
    /// # Errors
    /// An input error if Newton's method does not end, or outside the ranges.
    pub fn start(&self, z: &[f64], parameters: [f64; 2], options: &super::Options) -> Result<CurvePoint> {
        let fraction = |i: usize| {
            let (low, high) = self.ranges[i];
            let at = (parameters[i] - low) / (high - low);
            if (0.0..=1.0).contains(&at) {
                Ok(at)
            } else {
                Err(Error::input(format!(
                    "the start, {}, is not in the range from {low} to {high}",
                    parameters[i]
                )))
            }
        };
        let count = self.plane.count(&self.itinerary);
        if z.len() != count {
            let found = z.len();
            return Err(Error::input(format!(
                "the label has {found} unknowns; its pattern takes {count} here"
            )));
        }
        let own = z.iter().enumerate().map(|(i, x)| x / self.plane.unit(&self.itinerary, i));
        let u: Vec<f64> = own.chain([fraction(0)?, fraction(1)?]).collect();
        options.corrector().start(self, &u, u.len() - 1)
    }
}

impl<P: PatternPlane + ?Sized> Curve for EventCurve<'_, P> {
    /// Derivatives by central differences: the zeros are as exact as the functions, only the approach is
    /// slower.
    fn equations(&self, u: &[f64]) -> Result<Equations> {
        let residual = self.values(u)?;
        let mut jacobian = vec![vec![0.0; u.len()]; residual.len()];
        for column in 0..u.len() {
            let shifted = |by: f64| {
                let mut u = u.to_vec();
                u[column] += by;
                self.values(&u)
            };
            // Where the functions end (a restitution of 0), from one side only: (4 f(h) − f(2h) − 3 f(0))/2h.
            let (a, b) = match (shifted(DIFFERENCE), shifted(-DIFFERENCE)) {
                (Ok(ahead), Ok(behind)) => (ahead, behind),
                (Ok(_), Err(_)) => (one_sided(&residual, shifted, 1.0)?, vec![0.0; residual.len()]),
                (Err(_), Ok(_)) => (vec![0.0; residual.len()], one_sided(&residual, shifted, -1.0)?),
                (Err(error), Err(_)) => return Err(error),
            };
            for (row, (a, b)) in jacobian.iter_mut().zip(a.iter().zip(&b)) {
                row[column] = (a - b) / (2.0 * DIFFERENCE);
            }
        }
        Ok(Equations { residual, jacobian })
    }
}

/// 4 f(h) − f(2h) − 3 f(0), the value of f(0) being given.
fn one_sided(here: &[f64], shifted: impl Fn(f64) -> Result<Vec<f64>>, sign: f64) -> Result<Vec<f64>> {
    let (near, far) = (shifted(sign * DIFFERENCE)?, shifted(2.0 * sign * DIFFERENCE)?);
    Ok(here.iter().zip(near).zip(far).map(|((here, near), far)| 4.0 * near - far - 3.0 * here).collect())
}

impl<P: PatternPlane + ?Sized> Followed for EventCurve<'_, P> {
    type View = P::Orbit;

    fn view(&self, place: &CurvePoint) -> Result<P::Orbit> {
        let (z, parameters) = self.split(&place.u);
        let root = Root { z: z.to_vec(), residual: place.residual, steps: place.steps as usize };
        self.plane.orbit(parameters, &self.itinerary, root)
    }

    /// What makes a point one of codimension two, then the other bifurcations: points where two happen at
    /// once.
    fn monitors(&self, place: &CurvePoint, orbit: &P::Orbit) -> Vec<Option<f64>> {
        let parameters = self.split(&place.u).1;
        let mut all: Vec<_> = self.told().iter().map(|level| level.off(orbit, &parameters)).collect();
        all.extend(self.degeneracies(place, orbit));
        let mut others = monitors(orbit, None);
        match self.event {
            Some(Bifurcation::Fade) => others.truncate(Bifurcation::Fade as usize),
            Some(event) => others[event as usize] = None,
            None => {}
        }
        // Where a multiplier is on the circle all along, these are zero but for rounding; where two of these
        // meet is a resonance, or a fold-flip point, which have names of their own.
        let of = |monitor: usize| Bifurcation::of(monitor, self.itinerary.strikes().len());
        let mute: &[Bifurcation] = match self.event {
            Some(Bifurcation::SaddleNode | Bifurcation::Flip | Bifurcation::Torus) => {
                &[Bifurcation::SaddleNode, Bifurcation::Flip, Bifurcation::Torus]
            }
            Some(Bifurcation::Crossing) => &[Bifurcation::SaddleNode, Bifurcation::Torus],
            _ => &[],
        };
        others
            .iter_mut()
            .enumerate()
            .filter(|(i, _)| mute.contains(&of(*i)))
            .for_each(|(_, one)| *one = None);
        all.extend(others);
        all
    }

    fn leaps(&self, before: &P::Orbit, after: &P::Orbit) -> bool {
        self.event.is_some_and(|event| self.plane.leaps(event, before, after))
    }

    /// A degeneracy's function changes sign at its zeros, and is certain beside them: where a direction of
    /// the normal form has no meaning, as at the ends of a curve, it is neither.
    fn settle(&self, monitor: usize, place: CurvePoint, orbit: P::Orbit) -> Result<Settled<P::Orbit>> {
        let Some(monitor) = monitor.checked_sub(self.told().len()) else {
            let is_at = self.told()[monitor].is_at(&orbit, &self.split(&place.u).1);
            let number = Degeneracy::ALL.len() + Bifurcation::ALL.len() + monitor;
            return Ok(is_at.then_some((number, place, orbit)));
        };
        let Some(which) = monitor.checked_sub(Degeneracy::ALL.len()) else {
            let is = |event| self.plane.is_genuine(event, Degeneracy::ALL[monitor], &orbit);
            let genuine = self.event.is_some_and(is)
                && changes_sign(self, &place, |place| self.certain(monitor, place));
            return Ok(genuine.then_some((monitor, place, orbit)));
        };
        let what = Bifurcation::of(which, self.itinerary.strikes().len());
        let genuine =
            self.event == Some(Bifurcation::Fade) || what == Bifurcation::Fade || what.is_at(&orbit);
        Ok(genuine.then_some((Degeneracy::ALL.len() + what as usize, place, orbit)))
    }

    fn is_time(&self, unknown: usize) -> bool {
        unknown < self.plane.count(&self.itinerary) && self.plane.is_time(&self.itinerary, unknown)
    }

    /// At an event that ends a branch the orbit is just no orbit any more: here that does not count.
    fn holds(&self, orbit: &P::Orbit) -> bool {
        let slowest = orbit.speeds().into_iter().fold(f64::INFINITY, f64::min);
        match self.event {
            Some(Bifurcation::Fade) => slowest > -1e-9,
            Some(Bifurcation::Grazing) => slowest > 0.0,
            Some(Bifurcation::Torus) => orbit.is_orbit() && orbit.rotates(),
            _ => orbit.is_orbit(),
        }
    }

    fn bounds(&self) -> Vec<(usize, f64, f64)> {
        let first = self.plane.count(&self.itinerary);
        vec![(first, 0.0, 1.0), (first + 1, 0.0, 1.0)]
    }
}

impl<P: PatternPlane + ?Sized> EventCurve<'_, P> {
    fn values(&self, u: &[f64]) -> Result<Vec<f64>> {
        let (z, parameters) = self.split(u);
        let mut values = self.plane.values(self.event, parameters, &self.itinerary, z)?;
        if let (None, Some(level)) = (self.event, self.levels.first()) {
            let root = Root { z: z.to_vec(), residual: f64::NAN, steps: 0 };
            let off = level.off(&self.plane.orbit(parameters, &self.itinerary, root)?, &parameters);
            values.push(off.ok_or_else(|| Error::input(format!("{} has no value", level.name)))?);
        }
        Ok(values)
    }

    /// The function of a degeneracy at a point, if its sign is certain there.
    fn certain(&self, degeneracy: usize, place: &CurvePoint) -> Option<f64> {
        let orbit = self.view(place).ok()?;
        let (z, parameters) = self.split(&place.u);
        let event = self.event?;
        let value = |z: &[f64], factors: &[f64]| {
            let orbit = orbit.moved(z);
            self.plane.degeneracies(event, parameters, &place.tangent, &orbit, factors)[degeneracy]
        };
        let found = Estimate::of_map(z, |unknown| orbit.is_time(unknown), value)?;
        (!found.is_zero()).then_some(found.value)
    }

    fn degeneracies(&self, place: &CurvePoint, orbit: &P::Orbit) -> Vec<Option<f64>> {
        let Some(event) = self.event else { return vec![None; Degeneracy::ALL.len()] };
        self.plane.degeneracies(event, self.split(&place.u).1, &place.tangent, orbit, &[])
    }
}

impl<P: PatternPlane + ?Sized> OrbitCurve for EventCurve<'_, P> {
    fn itinerary(&self) -> &PatternOf<P::Orbit> {
        &self.itinerary
    }

    fn parameters(&self, u: &[f64]) -> Vec<f64> {
        self.split(u).1.to_vec()
    }

    fn units(&self) -> Vec<f64> {
        self.ranges.iter().map(|(low, high)| high - low).collect()
    }

    fn singularity(&self, monitor: usize) -> Singularity {
        let Some(event) = monitor.checked_sub(Degeneracy::ALL.len()) else {
            return Singularity::Degeneracy(Degeneracy::ALL[monitor]);
        };
        match event.checked_sub(Bifurcation::ALL.len()) {
            Some(level) => Singularity::Level(self.told()[level].name.clone()),
            None => Singularity::Bifurcation(Bifurcation::ALL[event]),
        }
    }

    fn subject(&self) -> Option<Bifurcation> {
        self.event
    }
}
