//! An event followed in two parameters: the pattern equations with one more, that the event's function is
//! zero.

use std::f64::consts::{PI, TAU};

use super::{
    Bifurcation, Degeneracy, OrbitCurve, Singularity,
    curve::{Curve, CurvePoint, Equations},
    follow::{Followed, Settled},
    orbits::monitors,
};
use crate::{
    error::{Error, Result},
    oscillator::{
        grazing::{LocalMap, is_mirrored},
        orbit::{
            Derivatives, Itinerary, Multipliers, Orbit, Oscillator, Root, Unknowns, check, describe,
            linearise, monodromy, return_map,
        },
    },
};

/// Oscillators that differ in two parameters.
pub trait TwoParameterFamily: Sync {
    /// The oscillator at both values.
    ///
    /// # Errors
    /// An input error where the system is not defined.
    fn at(&self, parameters: [f64; 2]) -> Result<Oscillator>;
}

impl<F: Fn([f64; 2]) -> Result<Oscillator> + Sync> TwoParameterFamily for F {
    fn at(&self, parameters: [f64; 2]) -> Result<Oscillator> {
        self(parameters)
    }
}

/// The orbits of a pattern at which one event happens: the unknowns are those of the pattern and both
/// parameters as fractions of their ranges.
pub struct Events<'a> {
    /// The oscillators.
    pub plane: &'a dyn TwoParameterFamily,
    /// The pattern.
    pub itinerary: Itinerary,
    /// What happens.
    pub event: Bifurcation,
    /// The bounds of both parameters.
    pub ranges: [(f64, f64); 2],
}

impl Events<'_> {
    fn split<'u>(&self, u: &'u [f64]) -> (&'u [f64], [f64; 2]) {
        let (z, last) = u.split_at(u.len() - 2);
        (z, [0, 1].map(|i| self.ranges[i].0 + last[i] * (self.ranges[i].1 - self.ranges[i].0)))
    }

    /// The point near an orbit at both parameter values, on the way to larger values of the second.
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
        let u: Vec<f64> = z.iter().copied().chain([fraction(0)?, fraction(1)?]).collect();
        options.corrector().start(self, &u, u.len() - 1)
    }

    /// F and the event's function.
    fn values(&self, u: &[f64]) -> Result<Vec<f64>> {
        let (z, parameters) = self.split(u);
        let oscillator = self.plane.at(parameters)?;
        let mut values = linearise(&oscillator, &self.itinerary, z)?.residual;
        if self.event == Bifurcation::Crossing {
            self.symmetric(&oscillator, z, &mut values)?;
        }
        let unknowns = Unknowns::new(&self.itinerary, z)?;
        let speeds = || unknowns.speeds();
        let scale: f64 = speeds().product();
        let multipliers = || {
            let matrix = monodromy(&oscillator, &self.itinerary, z)?;
            Ok::<_, Error>(Multipliers::new(&matrix, &oscillator, &self.itinerary))
        };
        values.push(match self.event {
            Bifurcation::SaddleNode | Bifurcation::Crossing => multipliers()?.fold() * scale,
            Bifurcation::Flip => multipliers()?.flip() * scale,
            Bifurcation::Torus => multipliers()?.determinant - 1.0,
            Bifurcation::Grazing => {
                let least = check(&oscillator, &self.itinerary, z).least;
                least.ok_or_else(|| Error::input("no minimum of a gap to graze at"))?.gap
            }
            Bifurcation::Fade => speeds().min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(0.0),
        });
        Ok(values)
    }
}

impl Events<'_> {
    /// Where branches cross the pattern equations are singular, and in two parameters they cross along a
    /// curve only where a symmetry is lost: at pitchforks of symmetric orbits. Among those the equations are
    /// regular: the second half of the pattern, in place of its own equations, is the mirror of the first,
    /// half a period later.
    fn symmetric(&self, oscillator: &Oscillator, z: &[f64], values: &mut [f64]) -> Result<()> {
        let strikes = self.itinerary.strikes();
        let half = strikes.len() / 2;
        let (first, second) = strikes.split_at(half);
        let opposite = first.iter().zip(second).all(|(a, b)| a.side != b.side);
        let lag = PI * f64::from(self.itinerary.periods());
        let off = |i: usize| {
            let [late, faster] = [0, 1].map(|j| z[2 * (i + half) + j] - z[2 * i + j]);
            [(late - lag + PI).rem_euclid(TAU) - PI, faster]
        };
        let symmetric = (0..half).all(|i| off(i).iter().all(|x| x.abs() < 1e-3));
        if half == 0
            || first.len() != second.len()
            || !opposite
            || !symmetric
            || !is_mirrored(oscillator.system())
        {
            return Err(Error::input(
                "crossings are followed in two parameters only as pitchforks of orbits that are their own mirror image half a period \
                 later, with impacts; this one is not",
            ));
        }
        (0..half).for_each(|i| values[2 * (i + half)..][..2].copy_from_slice(&off(i)));
        Ok(())
    }
}

impl Curve for Events<'_> {
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

/// The cube root of the rounding error, where central differences are best.
const DIFFERENCE: f64 = 6e-6;

impl Followed for Events<'_> {
    type View = Orbit;

    fn view(&self, place: &CurvePoint) -> Result<Orbit> {
        let (z, parameters) = self.split(&place.u);
        let root = Root { z: z.to_vec(), residual: place.residual, steps: place.steps as usize };
        describe(&self.plane.at(parameters)?, &self.itinerary, root)
    }

    /// What makes a point one of codimension two, then the other bifurcations: points where two happen at
    /// once.
    fn monitors(&self, place: &CurvePoint, orbit: &Orbit) -> Vec<Option<f64>> {
        let mut all = self.degeneracies(place, orbit);
        let mut others = monitors(orbit, None);
        match self.event {
            Bifurcation::Fade => others.truncate(Bifurcation::Fade as usize),
            event => others[event as usize] = None,
        }
        if self.event == Bifurcation::Crossing {
            others[Bifurcation::SaddleNode as usize] = None;
        }
        // Where two of these meet is a resonance, which has a name of its own.
        if matches!(self.event, Bifurcation::SaddleNode | Bifurcation::Flip) {
            others[Bifurcation::Torus as usize] = None;
        }
        if self.event == Bifurcation::Torus {
            others[Bifurcation::SaddleNode as usize] = None;
            others[Bifurcation::Flip as usize] = None;
        }
        all.extend(others);
        all
    }

    /// Two zeros of one u_n are not to lie within a step: for n ≤ 6 they are at least π/5 apart in θ, trace =
    /// 2 √det cos θ.
    fn leaps(&self, before: &Orbit, after: &Orbit) -> bool {
        let angle = |orbit: &Orbit| {
            let Multipliers { trace, determinant } = orbit.multipliers;
            (trace / (2.0 * determinant.sqrt())).clamp(-1.0, 1.0).acos()
        };
        self.event == Bifurcation::Grazing && (angle(before) - angle(after)).abs() > PI / 6.0
    }

    /// A degeneracy's function is zero at its zeros, and not just of two signs beside them.
    fn settle(&self, monitor: usize, place: CurvePoint, orbit: Orbit) -> Result<Settled<Orbit>> {
        let genuine = match self.singularity(monitor) {
            Singularity::Degeneracy(what) => {
                self.degeneracies(&place, &orbit)[what as usize].is_some_and(|value| value.abs() <= 1e-6)
            }
            Singularity::Bifurcation(what) => {
                self.event == Bifurcation::Fade || what == Bifurcation::Fade || what.is_at(&orbit)
            }
        };
        Ok(genuine.then_some((monitor, place, orbit)))
    }

    /// At an event that ends a branch the orbit is just no orbit any more: here that does not count.
    fn holds(&self, orbit: &Orbit) -> bool {
        match self.event {
            Bifurcation::Fade => orbit.impacts().all(|impact| impact.speed > -1e-9),
            Bifurcation::Grazing => orbit.impacts().all(|impact| impact.speed > 0.0),
            // Beyond a double multiplier λ and 1/λ are real: a saddle that keeps areas, and no bifurcation.
            Bifurcation::Torus => {
                let Multipliers { trace, determinant } = orbit.multipliers;
                orbit.admissibility.is_admissible() && trace.abs() <= (1.0 + determinant) * (1.0 + 1e-9)
            }
            _ => orbit.admissibility.is_admissible(),
        }
    }

    fn bounds(&self) -> Vec<(usize, f64, f64)> {
        let first = Unknowns::count(&self.itinerary);
        vec![(first, 0.0, 1.0), (first + 1, 0.0, 1.0)]
    }
}

impl Events<'_> {
    /// The functions whose zeros are of codimension two, in the order of [`Degeneracy::ALL`]; `None` where
    /// they are not defined or another curve's.
    fn degeneracies(&self, place: &CurvePoint, orbit: &Orbit) -> Vec<Option<f64>> {
        let mut all = vec![None; Degeneracy::ALL.len()];
        let (trace, det) = (orbit.multipliers.trace, orbit.multipliers.determinant);
        let oscillator = || self.plane.at(self.split(&place.u).1).ok();
        let expansion =
            || Some(Derivatives::of(&return_map(&oscillator()?, &self.itinerary, &orbit.z).ok()?));
        let mut set = |what: Degeneracy, value: Option<f64>| {
            all[what as usize] = value.filter(|value| value.is_finite());
        };
        match self.event {
            Bifurcation::SaddleNode => {
                set(Degeneracy::Cusp, expansion().and_then(|map| map.fold_along()));
                set(Degeneracy::Resonance1, Some(det - 1.0));
            }
            Bifurcation::Flip => {
                set(Degeneracy::GeneralisedFlip, expansion().and_then(|map| map.flip()));
                set(Degeneracy::Resonance2, Some(det - 1.0));
            }
            Bifurcation::Torus => {
                set(Degeneracy::Resonance1, Some(trace - 2.0));
                set(Degeneracy::Resonance2, Some(trace + 2.0));
                set(Degeneracy::Resonance3, Some(trace + 1.0));
                set(Degeneracy::Resonance4, Some(trace));
            }
            Bifurcation::Grazing => {
                // Along the curve e dp + e′ dp′ = 0, with e′ that of the second parameter.
                set(Degeneracy::NoDrift, place.tangent.last().copied());
                let gamma = oscillator().and_then(|oscillator| LocalMap::of(&oscillator, orbit).ok());
                set(Degeneracy::NoGamma, gamma.map(|map| map.gamma()));
                // u_n without the factors that it shares with u_d, d a divisor of n.
                let square = trace * trace;
                set(Degeneracy::Resonant2, Some(trace));
                set(Degeneracy::Resonant3, Some(square - det));
                set(Degeneracy::Resonant4, Some(square - 2.0 * det));
                set(Degeneracy::Resonant5, Some(square * square - 3.0 * square * det + det * det));
                set(Degeneracy::Resonant6, Some(square - 3.0 * det));
            }
            Bifurcation::Crossing | Bifurcation::Fade => {}
        }
        all
    }
}

impl OrbitCurve for Events<'_> {
    fn itinerary(&self) -> &Itinerary {
        &self.itinerary
    }

    fn parameters(&self, u: &[f64]) -> Vec<f64> {
        self.split(u).1.to_vec()
    }

    fn units(&self) -> Vec<f64> {
        self.ranges.iter().map(|(low, high)| high - low).collect()
    }

    fn singularity(&self, monitor: usize) -> Singularity {
        match Degeneracy::ALL.get(monitor) {
            Some(what) => Singularity::Degeneracy(*what),
            None => Singularity::Bifurcation(Bifurcation::of(monitor - Degeneracy::ALL.len())),
        }
    }

    fn subject(&self) -> Option<Bifurcation> {
        Some(self.event)
    }
}
