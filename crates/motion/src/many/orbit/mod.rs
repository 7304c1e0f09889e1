//! Periodic orbits of machines with a given impact pattern, by Newton's method on the impacts; their
//! multipliers; whether they are orbits.
//!
//! The unknowns are the state X just after the first impact, 2n numbers, and time and incoming speed t_i, V_i
//! of each impact; impact i changes the velocities by (1 + τ) V_i M⁻¹wᵀ/(w M⁻¹wᵀ), Newton's law for one stop.
//! The equations: at t_{i+1} + 2π n_i the gap is 0 and its rate −V_{i+1}; after the last leg and the first
//! impact the state is X again. They are the equations (19) of the paper for any number of degrees of
//! freedom, and as those they are smooth where an impact has V = 0. That the speeds are unknowns of their
//! own, by which the velocities jump, keeps the equations well conditioned near grazing, where the flow with
//! its impacts expands by 1/V.
//!
//! Soft stops take no part in the pattern: a leg passes through contact with them (`leg`), and a branch
//! through their grazing. Neither does dry friction (`rubbing`): where something sticks, a direction is lost,
//! and the motion once around has multipliers 0; the equations stay regular.
//!
//! `pattern` is the pattern, `equations` the equations with all derivatives, that in a parameter by `change`,
//! `admissible` what tells an orbit from another solution, `surface` the Poincaré map to third order. Not
//! here: rest on stops, and several stops hit at one instant, an orbit with which is not found; how orbits
//! continue (`branch`).

mod admissible;
mod change;
mod equations;
mod leg;
mod rough;
mod rubbing;
mod slides;
mod starts;
mod surface;

use std::f64::consts::TAU;

pub use admissible::{Admissibility, Minimum, Obstacle, Touches};
pub(super) use change::Change;
pub(super) use equations::StopEquations;
pub(super) use leg::Between;
use slides::{held, told};
pub use starts::FreeStarts;
pub(super) use surface::{Image, Surface};

use super::{
    Grip, State,
    algebra::eigenvalues,
    contact::{Contacts, StopContact},
    friction::check_given,
    simulate::Simulator,
};
use crate::{
    continuation::{KnownOrbits, Root, newton, project},
    error::{Error, Result},
};

/// An impact of an orbit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrbitImpact {
    /// The stop.
    pub stop: usize,
    /// t_i, near the phase: within one turn of [0, 2π).
    pub time: f64,
    /// V_i, per radian of the forcing.
    pub speed: f64,
}

/// A solution of the equations.
#[derive(Debug, Clone, PartialEq)]
pub struct Orbit {
    /// Its pattern.
    pub itinerary: Itinerary,
    /// Just after the first impact; at phase 0 for an orbit without impacts.
    pub state: State,
    /// Its impacts.
    pub impacts: Vec<OrbitImpact>,
    /// The unknowns of the equations: X, then t_1, V_1, …, the lengths and speeds in units of `scale`.
    pub z: Vec<f64>,
    /// The unit of lengths and speeds among them, which is about the size of the gaps' motion.
    pub scale: f64,
    /// What is left of the equations, relative to the size of the motion.
    pub residual: f64,
    /// Newton steps taken.
    pub steps: usize,
    /// Real and imaginary part of each, by modulus, the largest first; the 1 of each drift is left out.
    pub multipliers: Vec<(f64, f64)>,
    /// Whether it is an orbit.
    pub admissibility: Admissibility,
    /// The least minimum of a gap away from the impacts; none if no gap has one.
    pub least: Option<Minimum>,
    /// How it touches stops that give way.
    pub touches: Touches,
    /// How each row with friction moves, one after the other.
    pub(crate) grips: Vec<Vec<Grip>>,
    /// How it moves at each where the orbit begins.
    pub(crate) begins: Vec<Grip>,
    /// The first row with friction that sticks all the time.
    pub held: Option<usize>,
    /// How far each coordinate of the scene comes per forcing period, along directions in which nothing holds
    /// the machine; empty where all is held.
    pub drift: Vec<f64>,
}

/// The orbit of a pattern nearest to times and incoming speeds t_1, V_1, …, t_m, V_m (none without impacts):
/// Newton's method with exact derivatives.
///
/// # Errors
/// An input error if the start has another length, a stop is not there, friction is under the force of a
/// stop, or Newton's method does not end.
pub fn find(simulator: &Simulator, pattern: &Itinerary, start: &[f64]) -> Result<Orbit> {
    find_beside(simulator, pattern, start, None, &[])
}

/// The same, from the state just after the first impact (at phase 0 without impacts), where one is given:
/// where there are soft stops the state does not follow from times and speeds.
///
/// # Errors
/// As [`find`].
pub fn find_from(
    simulator: &Simulator,
    pattern: &Itinerary,
    start: &[f64],
    state: Option<&State>,
) -> Result<Orbit> {
    find_beside(simulator, pattern, start, state, &[])
}

/// The same, with solutions that are known taken out.
///
/// # Errors
/// As [`find`].
pub fn find_beside(
    simulator: &Simulator,
    pattern: &Itinerary,
    start: &[f64],
    state: Option<&State>,
    known: &[Orbit],
) -> Result<Orbit> {
    let m = pattern.strikes().len();
    if start.len() != 2 * m {
        return Err(Error::input(format!(
            "the start has {} numbers; the pattern takes {}",
            start.len(),
            2 * m
        )));
    }
    check_given(simulator.contacts().rubs().iter().map(|rub| (&rub.name, rub.stop)))?;
    check_stops(pattern, simulator.contacts())?;
    let scale = scale(simulator, pattern, start);
    let soft = simulator.through()?;
    let equations = StopEquations::new(between(simulator, soft.as_ref()), pattern, scale);
    let scaled: Vec<f64> =
        start.iter().enumerate().map(|(i, x)| if i % 2 == 0 { *x } else { x / scale }).collect();
    let state = state.map(|state| equations.between.unmoved(state.clone()));
    let first = match &state {
        None => equations.complete(&scaled)?,
        Some(state) => state.q.iter().chain(state.u.iter()).map(|x| x / scale).chain(scaled).collect(),
    };
    // What sticks all the time from this start may do so at many places: it is to stay where it is.
    let pins: Vec<(usize, f64)> =
        match state.as_ref().map(|state| (state, equations.parts(&first).map(|known| known.0))) {
            Some((state, Ok(parts))) => {
                // Along a drift it is moved to where that is 0.
                let row = |j: usize| &simulator.contacts().rubs()[j].row;
                let is_free = |&j: &usize| simulator.drifts().is_none_or(|known| known.is_unseen(row(j)));
                let rows = held(&parts).into_iter().filter(is_free);
                rows.map(|j| (j, row(j).dot(&state.q))).collect()
            }
            _ => Vec::new(),
        };
    let pinned = StopEquations { pins: &pins, ..equations };
    let points = known.iter().map(|orbit| orbit.z.clone());
    let known = KnownOrbits::new(2 * equations.size(), m, points);
    let mut root = newton(first.clone(), &known, |z| pinned.linearise(z, None))?;
    if !pins.is_empty() {
        let rows = held(&equations.parts(&root.z)?.0);
        if pins.iter().any(|(j, _)| !rows.contains(j)) {
            root = newton(first, &known, |z| equations.linearise(z, None))?;
        }
    }
    describe(simulator, pattern, scale, root)
}

/// The same, of a machine that is linear between impacts and whose motion its forces hold: state and speeds
/// are solved for with the times (variable projection).
///
/// # Errors
/// As [`find`]; an input error where state and speeds are not one solution of the times.
pub fn find_projected(
    simulator: &Simulator,
    pattern: &Itinerary,
    start: &[f64],
    known: &[Orbit],
) -> Result<Orbit> {
    check_stops(pattern, simulator.contacts())?;
    let scale = scale(simulator, pattern, start);
    let equations = StopEquations::new(between(simulator, None), pattern, scale);
    let states = 2 * equations.size();
    let known = known.iter().map(|orbit| orbit.z[states..].to_vec());
    let known = KnownOrbits::of_times(pattern.strikes().len(), known);
    let begin: Vec<f64> = std::iter::repeat_n(0.0, states).chain(start.iter().copied()).collect();
    let times: Vec<usize> = (states..begin.len()).step_by(2).collect();
    let rates: Vec<usize> = (1..start.len()).step_by(2).collect();
    let found = project(&begin, &times, &rates, &known, |z| equations.linearise(z, None))?;
    let impacts: Vec<f64> =
        found[states..].iter().enumerate().map(|(i, x)| if i % 2 == 0 { *x } else { x * scale }).collect();
    find_beside(simulator, pattern, &impacts, None, &[])
}

/// The unit of lengths and speeds: the size of motions at the stops, or the fastest of the start, or 1.
fn scale(simulator: &Simulator, pattern: &Itinerary, start: &[f64]) -> f64 {
    let size = simulator.scale_at(pattern.strikes().iter().map(|strike| strike.place));
    let size = if size > 0.0 { size } else { simulator.size() };
    let fastest = start.iter().skip(1).step_by(2).fold(0.0, |most: f64, v| most.max(v.abs()));
    if size > 0.0 {
        size
    } else if fastest > 0.0 {
        fastest
    } else {
        1.0
    }
}

/// Whether a motion from these times and speeds takes too long to follow.
pub fn is_hopeless(simulator: &Simulator, pattern: &Itinerary, start: &[f64]) -> bool {
    let followed = || {
        let soft = simulator.through()?;
        let equations = StopEquations::new(between(simulator, soft.as_ref()), pattern, 1.0);
        let (state, ..) = equations.split(&equations.complete(start)?);
        equations.between.after(&state, TAU)
    };
    followed().is_err_and(|error: Error| error.is_limit())
}

fn between<'s>(simulator: &'s Simulator, soft: Option<&'s Simulator>) -> Between<'s> {
    let (flow, contacts, drifts) = (simulator.flow(), simulator.contacts(), simulator.drifts());
    Between { flow, contacts, soft, drifts }
}

/// Refuses patterns with impacts at stops that are not there.
pub(super) fn check_stops(pattern: &Itinerary, contacts: &Contacts) -> Result<()> {
    if pattern.strikes().iter().any(|strike| strike.place >= contacts.all().len()) {
        return Err(Error::input("an impact at a stop that the machine does not have"));
    }
    if let Some(strike) = pattern.strikes().iter().find(|strike| contacts.all()[strike.place].soft.is_some())
    {
        return Err(Error::input(format!(
            "stop {} gives way: contact with it is no impact of a pattern and is found without being named",
            contacts.all()[strike.place].name
        )));
    }
    Ok(())
}

/// What there is to know of a root of the equations, with lengths and speeds in units of `scale`; of what is
/// no root, its residual NaN, without asking whether it is an orbit.
///
/// # Errors
/// Legs that do not follow one another; multipliers that are not found.
pub(super) fn describe(simulator: &Simulator, pattern: &Itinerary, scale: f64, root: Root) -> Result<Orbit> {
    let soft = simulator.through()?;
    let equations = StopEquations::new(between(simulator, soft.as_ref()), pattern, scale);
    let Root { z, residual, steps } = root;
    let (state, times, speeds) = equations.split(&z);
    let impacts = pattern.strikes().iter().zip(times.iter().zip(&speeds));
    let (parts, lost) = equations.parts(&z)?;
    let mut multipliers = multipliers(&equations, &z)?;
    let (least, touches) = equations.extremes(&z)?;
    // What is lost where it sticks is 0, whatever rounding leaves of it: its root, of two that are one
    // eigenvector's.
    let rounded = 64.0 * f64::EPSILON.sqrt();
    let kept = multipliers.len().saturating_sub(lost);
    let left = multipliers[kept..].iter_mut().filter(|(re, im)| re.hypot(*im) < rounded);
    left.for_each(|multiplier| *multiplier = (0.0, 0.0));
    Ok(Orbit {
        itinerary: pattern.clone(),
        state,
        impacts: impacts
            .map(|(strike, (&time, &speed))| OrbitImpact { stop: strike.place, time, speed })
            .collect(),
        residual,
        steps,
        multipliers,
        admissibility: match residual.is_nan() {
            true => Admissibility::Admissible,
            false => equations.admissibility(&z, simulator)?,
        },
        least,
        touches,
        held: held(&parts).first().copied(),
        grips: parts.into_iter().map(told).collect(),
        begins: equations.begins(&z)?,
        drift: equations.drifted(&z)?,
        scale,
        z,
    })
}

/// The multipliers of a solution, the largest modulus first.
///
/// # Errors
/// As [`describe`].
pub(super) fn multipliers(equations: &StopEquations, z: &[f64]) -> Result<Vec<(f64, f64)>> {
    let monodromy = equations.monodromy(z)?;
    // Only that of two multipliers is used.
    let determinant = if equations.size() == 1 { equations.determinant(z)? } else { f64::NAN };
    if let Some(drifts) = equations.between.drifts {
        let others = drifts.quotient(&monodromy);
        let determinant = if equations.size() == 1 { determinant } else { others.determinant() };
        return eigenvalues(&others, determinant);
    }
    eigenvalues(&monodromy, determinant)
}

/// The pattern of an orbit with the stop of each impact, by its place in the machine.
pub type Itinerary = crate::continuation::Itinerary<usize>;

/// An impact of a pattern, at a stop.
pub type Strike = crate::continuation::Strike<usize>;

/// A time's phase, in [0, 2π].
fn turned(t: f64) -> f64 {
    t.rem_euclid(TAU)
}
