//! An orbit of the true system: impacts, multipliers, and whether it is one.

use std::f64::consts::PI;

use super::{
    Admissibility, Check, Itinerary, Minimum, Oscillator, admissible::check, equations::linearise,
    passage::Unknowns,
};
use crate::{
    continuation::{KnownOrbits, Linearised, Multipliers, Root, counted, newton, project},
    error::{Error, Result},
    motion::{
        Flow, RunEnd, Side, State,
        algebra::{IDENTITY, Matrix2, product},
        flow::Obstacle,
    },
};

/// A solution of the pattern equations, with all that is known of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Orbit {
    /// Its impacts' walls and periods.
    pub itinerary: Itinerary,
    /// The unknowns (t₁, V₁, …), or (q, u) at t = 0.
    pub z: Vec<f64>,
    /// The eigenvalues of the full period's linearisation.
    pub multipliers: Multipliers,
    /// Whether it is an orbit.
    pub admissibility: Admissibility,
    /// The least minimum of a gap away from the impacts.
    pub least: Option<Minimum>,
    /// The largest |F_i|.
    pub residual: f64,
    /// Newton steps taken.
    pub steps: usize,
    /// The size of motions that strike its walls (`Oscillator::unit`): what lengths and speeds are measured
    /// by where it is decided whether they are 0.
    pub unit: f64,
    /// Radians in a unit of the time in which speeds are shown; those above are per radian.
    pub rate: f64,
}

/// An impact of an orbit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrbitImpact {
    /// The wall.
    pub side: Side,
    /// The phase in [0, 2π).
    pub phase: f64,
    /// V: the relative speed it comes in with.
    pub speed: f64,
}

/// The solution of the pattern equations near `start`, an orbit if [`Orbit::admissibility`] says so.
///
/// # Errors
/// As `newton` and [`linearise`].
pub fn find(oscillator: &Oscillator, itinerary: &Itinerary, start: Vec<f64>) -> Result<Orbit> {
    let found = find_beside(oscillator, itinerary, &start, &[]);
    found.map_err(|error| obstacle(oscillator, itinerary, &start).unwrap_or(error))
}

/// The same, with solutions that are known taken out, and no reason but Newton's where there is none.
///
/// # Errors
/// As `newton` and [`linearise`].
pub(super) fn find_beside(
    oscillator: &Oscillator,
    itinerary: &Itinerary,
    start: &[f64],
    known: &[Orbit],
) -> Result<Orbit> {
    let unit = oscillator.unit(itinerary);
    let points = known.iter().map(|orbit| measured(itinerary, unit, &orbit.z, f64::recip));
    let known = KnownOrbits::new(0, itinerary.strikes().len(), points);
    let root = newton(measured(itinerary, unit, start, f64::recip), &known, |z| {
        measured_equations(oscillator, itinerary, unit, z)
    })?;
    let z = measured(itinerary, unit, &root.z, |own| own);
    describe(oscillator, itinerary, Root { z, residual: root.residual * unit, ..root })
}

/// The same, where the forces are linear and hold the motion: speeds are solved for with the times, as
/// [`project`] does.
///
/// # Errors
/// As [`project`] and [`find`].
pub(super) fn find_projected(
    oscillator: &Oscillator,
    itinerary: &Itinerary,
    start: &[f64],
    known: &[Orbit],
) -> Result<Orbit> {
    let unit = oscillator.unit(itinerary);
    let known = KnownOrbits::of_times(itinerary.strikes().len(), known.iter().map(|orbit| orbit.z.clone()));
    let [times, rows] = [0, 1].map(|first| (first..start.len()).step_by(2).collect::<Vec<_>>());
    let z = project(&measured(itinerary, unit, start, f64::recip), &times, &rows, &known, |z| {
        measured_equations(oscillator, itinerary, unit, z)
    })?;
    find_beside(oscillator, itinerary, &measured(itinerary, unit, &z, |own| own), &[])
}

/// Unknowns, each times a factor of what an unknown of 1 is ([`Unknowns::unit`]).
fn measured(itinerary: &Itinerary, unit: f64, z: &[f64], factor: impl Fn(f64) -> f64) -> Vec<f64> {
    z.iter().enumerate().map(|(i, z)| z * factor(Unknowns::unit(itinerary, i, unit))).collect()
}

/// The equations in such units.
fn measured_equations(
    oscillator: &Oscillator,
    itinerary: &Itinerary,
    unit: f64,
    scaled: &[f64],
) -> Result<Linearised> {
    let z = measured(itinerary, unit, scaled, |own| own);
    Ok(linearise(oscillator, itinerary, &z)?.measured(unit, |i| Unknowns::unit(itinerary, i, unit)))
}

/// Why the pattern equations cannot be asked at z, if a flight there cannot be followed: place, velocity and
/// acceleration where the force is too steep or has a pole.
pub(super) fn obstacle(oscillator: &Oscillator, itinerary: &Itinerary, z: &[f64]) -> Option<Error> {
    let flights: Vec<(State, f64)> = if itinerary.strikes().is_empty() {
        vec![(State { t: 0.0, q: z[0], u: z[1] }, 2.0 * PI * f64::from(itinerary.periods()))]
    } else {
        let passages = Unknowns::new(itinerary, z).ok()?.passages(oscillator);
        passages.flatten().map(|passage| (passage.from, passage.duration)).collect()
    };
    let (at, why) = flights.into_iter().find_map(|(from, duration)| oscillator.obstacle(from, duration))?;
    let what = format!(
        "a motion of the pattern ended {}: at q = {}, u = {} with the acceleration {}",
        RunEnd::from(why).why(),
        at.q,
        at.u,
        oscillator.flow().acceleration(at)
    );
    Some(if why == Obstacle::Steep { Error::limit(what) } else { Error::input(what) })
}

/// What there is to know of a root of the pattern equations.
///
/// # Errors
/// As [`linearise`].
pub fn describe(oscillator: &Oscillator, itinerary: &Itinerary, root: Root) -> Result<Orbit> {
    let Root { z, residual, steps } = root;
    let multipliers = Multipliers::new(&monodromy(oscillator, itinerary, &z)?, oscillator, itinerary, &z)?;
    let Check { admissibility, least } = check(oscillator, itinerary, &z);
    let unit = oscillator.unit(itinerary);
    let (itinerary, rate) = (itinerary.clone(), oscillator.system().shown_rate());
    Ok(Orbit { itinerary, multipliers, admissibility, least, residual, steps, z, unit, rate })
}

/// The full period's linearisation, from just after the first impact (from t = 0 without impacts): flow
/// matrices and saltation matrices. The speeds must not be 0.
///
/// # Errors
/// An input error if a wall is missing.
pub fn monodromy(oscillator: &Oscillator, itinerary: &Itinerary, z: &[f64]) -> Result<Matrix2> {
    if itinerary.strikes().is_empty() {
        let start = State { t: 0.0, q: z[0], u: z[1] };
        return Ok(oscillator.leg(start, 2.0 * PI * f64::from(itinerary.periods())).matrix);
    }
    let mut matrix = IDENTITY;
    for passage in Unknowns::new(itinerary, z)?.passages(oscillator) {
        let passage = passage?;
        matrix = product(&product(&passage.saltation().0, &passage.matrix()), &matrix);
    }
    Ok(matrix)
}

impl Orbit {
    /// The same with other unknowns z, all else as it was.
    #[must_use]
    pub(crate) fn with(&self, z: &[f64]) -> Orbit {
        Orbit { z: z.to_vec(), ..self.clone() }
    }

    /// Its impacts.
    pub fn impacts(&self) -> impl Iterator<Item = OrbitImpact> + '_ {
        self.itinerary.strikes().iter().zip(self.z.chunks(2)).map(|(strike, z)| OrbitImpact {
            side: strike.place,
            phase: z[0].rem_euclid(2.0 * PI),
            speed: z[1],
        })
    }

    /// The times t_1, t_2, … of its impacts, in radians, as its pattern counts them: t_1 in [0, 2π), and
    /// impact i + 1 is 2π n_i + t_{i+1} − t_i after impact i.
    pub fn times(&self) -> Vec<f64> {
        let times = self.itinerary.strikes().iter().zip(self.z.chunks(2)).map(|(_, z)| z[0]);
        counted(&times.collect::<Vec<_>>())
    }

    /// Its state at time t: just after the first impact, if `t` is that impact's time; t counts from the
    /// phase 0 before it.
    pub fn state(&self, oscillator: &Oscillator, t: f64) -> Result<State> {
        let strikes = self.itinerary.strikes();
        if strikes.is_empty() {
            let start = State { t: 0.0, q: self.z[0], u: self.z[1] };
            return Ok(oscillator.flow().advance(start, t.rem_euclid(self.period())));
        }
        let mut left = (t - self.z[0]).rem_euclid(self.period());
        for passage in Unknowns::new(&self.itinerary, &self.z)?.passages(oscillator) {
            let passage = passage?;
            if left <= passage.duration || passage.index + 1 == strikes.len() {
                return Ok(oscillator.flow().advance(passage.from, left));
            }
            left -= passage.duration;
        }
        Err(Error::input("an orbit without passages"))
    }

    /// Its states leg by leg, from just after an impact to just before the next, without impacts once around
    /// from phase 0: both ends, and evenly between, at least `places` for each period. Cost: once around.
    ///
    /// # Errors
    /// As [`state`](Self::state).
    pub fn legs(&self, oscillator: &Oscillator, places: u32) -> Result<Vec<Vec<State>>> {
        let leg = |from: State, duration: f64| {
            let count = (duration / (2.0 * PI) * f64::from(places)).ceil().max(1.0);
            let next = |here: &State| Some(oscillator.flow().advance(*here, duration / count));
            std::iter::successors(Some(from), next).take(count as usize + 1).collect()
        };
        if self.itinerary.strikes().is_empty() {
            return Ok(vec![leg(State { t: 0.0, q: self.z[0], u: self.z[1] }, self.period())]);
        }
        let unknowns = Unknowns::new(&self.itinerary, &self.z)?;
        unknowns.passages(oscillator).map(|passage| passage.map(|one| leg(one.from, one.duration))).collect()
    }

    /// The period.
    pub(crate) fn period(&self) -> f64 {
        2.0 * PI * f64::from(self.itinerary.periods())
    }
}
