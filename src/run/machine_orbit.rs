//! Tasks of kind `orbit` on machines: periodic orbits of a pattern.
//!
//! Phases are fractions of the period, speeds in the scene's units.

use std::f64::consts::TAU;

use rayon::prelude::*;

use super::{Complex, Job, Judgement, orbit::OrbitList, row};
use crate::{
    continuation::{Bifurcation, FollowedOrbit},
    error::{Error, Result},
    many::{
        Machine, MachineState, RealVector,
        orbit::{MachineAdmissibility, MachineOrbit, StopPattern, StopStrike, find, find_from},
        simulate::MachineSimulator,
    },
    one::orbit::counted,
    random::Random,
    scene::orbits::{OrbitKeys, OrbitTask},
};

row! {
    /// A solution of the equations of a pattern.
    pub struct MachineOrbitRow {
        /// The parameter's value, if the task goes through some.
        pub value: Option<f64>,
        /// The impact pattern.
        pub pattern: String,
        /// The phases of its impacts, as fractions of the period.
        pub phases: Vec<f64>,
        /// Their incoming speeds, at their stops, in the scene's units.
        pub speeds: Vec<f64>,
        /// The multipliers of largest modulus, at most four.
        pub multipliers: Vec<Complex>,
        /// Whether all are inside the unit circle.
        pub stable: Judgement,
        /// Whether it is an orbit: its impacts come in, and between them the simulator finds no other
        /// contact.
        pub admissible: Judgement,
        /// Why not.
        pub reason: Option<String>,
        /// What is left of the equations, relative to the size of the motion.
        pub residual: f64,
    }
}

/// The orbits of a machine.
pub type MachineOrbitFindings = OrbitList<MachineOrbitRow>;

/// Finds the orbits of a pattern, at each value of a parameter if there is one.
///
/// # Errors
/// Where the machine is not defined; an interruption.
pub fn machine_orbit(task: &OrbitTask, machine: &Machine<f64>, job: &Job) -> Result<MachineOrbitFindings> {
    OrbitList::of(task, job, |place| {
        let machine = match place {
            Some(place) => job.scene.machine(&[place])?,
            None => machine.clone(),
        };
        let simulator = job.machine_simulator(&machine, &[])?;
        let orbits = orbits(&task.orbit, &machine, &simulator, job);
        let row =
            |orbit: &MachineOrbit| MachineOrbitRow::of(orbit, &simulator, place.map(|(_, value)| value));
        Ok(orbits.map(|orbits| orbits.iter().map(row).collect()))
    })
}

/// Starts between two looks at whether to go on.
const CHUNK: u32 = 16;

/// Closer than this, relative to the largest speed and to a radian, two solutions are one.
const NEAR: f64 = 1e-7;

/// The orbits of the keys: the one that Newton's method finds from `start`, or those of a search.
pub(super) fn orbits(
    keys: &OrbitKeys,
    machine: &Machine<f64>,
    simulator: &MachineSimulator,
    job: &Job,
) -> Result<Vec<MachineOrbit>> {
    let pattern = pattern(keys, machine)?;
    let rate = machine.rate();
    let soft = simulator.contacts().all().iter().any(|contact| contact.soft.is_some());
    if (soft || simulator.is_smooth()) && keys.pattern.is_empty() {
        return through_soft_stops(keys, machine, simulator, job);
    }
    if !keys.start.is_empty() || keys.pattern.is_empty() {
        let unit = |(i, x): (usize, &f64)| if i % 2 == 0 { x * TAU } else { x / rate };
        let start: Vec<f64> = keys.start.iter().enumerate().map(unit).collect();
        return Ok(vec![find(simulator, &pattern, &start)?]);
    }
    let m = keys.pattern.len();
    let met = pattern.strikes().iter().map(|strike| strike.stop);
    let greatest = keys.speed.map_or(4.0 * simulator.scale_at(met), |speed| speed / rate);
    let start = |i: u32| -> Vec<f64> {
        let mut random = Random::of_unit(0, u64::from(i));
        let mut part = || random.next() as f64 / u64::MAX as f64;
        (0..2 * m).map(|j| part() * if j % 2 == 0 { TAU } else { greatest }).collect()
    };
    let mut found: Vec<MachineOrbit> = Vec::new();
    for first in (0..keys.starts).step_by(CHUNK as usize) {
        job.check()?;
        let last = first.saturating_add(CHUNK).min(keys.starts);
        let roots: Vec<MachineOrbit> =
            (first..last).into_par_iter().filter_map(|i| find(simulator, &pattern, &start(i)).ok()).collect();
        for orbit in roots {
            let fastest = orbit.impacts.iter().fold(0.0, |most: f64, impact| most.max(impact.speed));
            let moving = orbit.impacts.iter().all(|impact| impact.speed > NEAR * fastest);
            let primitive = (1..m).all(|shift| !same(&orbit, &orbit, shift));
            if moving && primitive && found.iter().all(|old| (0..m).all(|shift| !same(old, &orbit, shift))) {
                found.push(orbit);
            }
        }
    }
    found.sort_by(|a, b| a.impacts[0].speed.total_cmp(&b.impacts[0].speed));
    Ok(found)
}

/// Orbits without impacts on rigid stops, where there are soft ones or forces are formulas: from the state at
/// phase 0 of the keys, or those of a search, from the motion that the forces alone bring about and from
/// random states.
fn through_soft_stops(
    keys: &OrbitKeys,
    machine: &Machine<f64>,
    simulator: &MachineSimulator,
    job: &Job,
) -> Result<Vec<MachineOrbit>> {
    let (pattern, rate, points) = (pattern(keys, machine)?, machine.rate(), machine.points());
    if !keys.start.is_empty() {
        let part = |from: usize| {
            machine.coordinates(&RealVector::from_column_slice(&keys.start[from..from + points]))
        };
        let state = MachineState { t: 0.0, q: part(0)?, u: part(points)? / rate };
        return Ok(vec![find_from(simulator, &pattern, &[], Some(&state))?]);
    }
    let scale = simulator.scale();
    let greatest = keys.speed.map_or(4.0 * scale, |speed| speed / rate);
    let start = |i: u32| -> Result<MachineOrbit> {
        if i == 0 {
            return find(simulator, &pattern, &[]);
        }
        let mut random = Random::of_unit(0, u64::from(i));
        let mut list = |most: f64| {
            RealVector::from_fn(machine.size, |_, _| {
                most * (2.0 * (random.next() as f64 / u64::MAX as f64) - 1.0)
            })
        };
        let state = MachineState { t: 0.0, q: list(2.0 * scale), u: list(greatest) };
        find_from(simulator, &pattern, &[], Some(&state))
    };
    let near = |a: &MachineState, b: &MachineState| {
        let size = a.q.amax().max(a.u.amax());
        (&a.q - &b.q).amax().max((&a.u - &b.u).amax()) <= NEAR * size
    };
    let mut found: Vec<MachineOrbit> = Vec::new();
    for first in (0..keys.starts).step_by(CHUNK as usize) {
        job.check()?;
        let last = first.saturating_add(CHUNK).min(keys.starts);
        let roots: Vec<MachineOrbit> = (first..last).into_par_iter().filter_map(|i| start(i).ok()).collect();
        for orbit in roots {
            // Of a shorter period if that period's equations have the same solution: stops that are in the
            // way of the motion, which is listed as such, are no part of them.
            let shorter = |n: u32| -> Result<bool> {
                if !keys.period.is_multiple_of(n) {
                    return Ok(false);
                }
                let again = find_from(simulator, &StopPattern::free(n)?, &[], Some(&orbit.state));
                Ok(again.is_ok_and(|again| near(&orbit.state, &again.state)))
            };
            let known = found.iter().any(|old| near(&old.state, &orbit.state));
            if !known {
                let repeats = (1..keys.period).map(shorter).collect::<Result<Vec<_>>>()?;
                if !repeats.contains(&true) {
                    found.push(orbit);
                }
            }
        }
    }
    found.sort_by(|a, b| a.state.q[0].total_cmp(&b.state.q[0]));
    Ok(found)
}

/// Whether b is a with impact `shift` called the first.
fn same(a: &MachineOrbit, b: &MachineOrbit, shift: usize) -> bool {
    let (strikes, m) = (a.pattern.strikes(), a.impacts.len());
    let fastest = a.impacts.iter().fold(0.0, |most: f64, impact| most.max(impact.speed));
    (0..m).all(|i| {
        let (x, y) = (&a.impacts[i], &b.impacts[(i + shift) % m]);
        let turn = (x.time - y.time).rem_euclid(TAU);
        strikes[i].stop == strikes[(i + shift) % m].stop
            && turn.min(TAU - turn) < NEAR
            && (x.speed - y.speed).abs() < NEAR * fastest
    })
}

/// The pattern of the keys, whose stops go by their names.
pub(super) fn pattern(keys: &OrbitKeys, machine: &Machine<f64>) -> Result<StopPattern> {
    if keys.pattern.is_empty() {
        return StopPattern::free(keys.period);
    }
    let stop = |i: usize| match keys.stops.get(i) {
        None => Ok(0),
        Some(name) => machine
            .stops
            .iter()
            .position(|stop| stop.name == *name)
            .ok_or_else(|| Error::input(format!("there is no stop called {name:?}"))),
    };
    let strikes = keys.pattern.iter().enumerate();
    StopPattern::new(
        strikes.map(|(i, &periods)| Ok(StopStrike { stop: stop(i)?, periods })).collect::<Result<_>>()?,
    )
}

/// Multipliers that a row shows.
const SHOWN: usize = 4;

impl MachineOrbitRow {
    fn of(orbit: &MachineOrbit, simulator: &MachineSimulator, value: Option<f64>) -> MachineOrbitRow {
        let (admissible, reason) = admissible(orbit);
        MachineOrbitRow {
            value,
            pattern: orbit.pattern.named(simulator.contacts().all()),
            phases: phases(orbit),
            speeds: speeds(orbit, simulator.rate()),
            multipliers: multipliers(&orbit.multipliers),
            stable: stable(orbit, None),
            admissible,
            reason,
            residual: orbit.residual,
        }
    }
}

pub(super) fn multipliers(all: &[(f64, f64)]) -> Vec<Complex> {
    all.iter().take(SHOWN).map(|&one| Complex::from(one)).collect()
}

pub(super) fn phases(orbit: &MachineOrbit) -> Vec<f64> {
    let times: Vec<f64> = orbit.impacts.iter().map(|impact| impact.time).collect();
    counted(&times).into_iter().map(|time| time / TAU).collect()
}

/// In the scene's units, of which `rate` is Ω.
pub(super) fn speeds(orbit: &MachineOrbit, rate: f64) -> Vec<f64> {
    orbit.impacts.iter().map(|impact| impact.speed * rate).collect()
}

/// Closer to the unit circle than this, rounding decides.
const MARGIN: f64 = 1e-11;

/// Whether all multipliers are inside the unit circle; marginal at a bifurcation at which one or two are on
/// it.
pub(crate) fn stable(orbit: &MachineOrbit, at: Option<Bifurcation>) -> Judgement {
    let off = |&(re, im): &(f64, f64)| match at {
        Some(Bifurcation::SaddleNode | Bifurcation::Crossing) => (re - 1.0).hypot(im),
        Some(Bifurcation::Flip) => (re + 1.0).hypot(im),
        _ => (re.hypot(im) - 1.0).abs(),
    };
    let critical = match at {
        Some(Bifurcation::SaddleNode | Bifurcation::Crossing | Bifurcation::Flip) => 1,
        Some(Bifurcation::Torus) => 2,
        _ => 0,
    };
    let mut all = orbit.multipliers.clone();
    all.sort_by(|a, b| off(a).total_cmp(&off(b)));
    let largest = all[critical.min(all.len())..].iter().map(|x| x.0.hypot(x.1)).fold(0.0, f64::max);
    match () {
        () if largest > 1.0 + MARGIN => Judgement::No,
        () if critical > 0 || (largest - 1.0).abs() <= MARGIN => Judgement::Marginal,
        () => Judgement::Yes,
    }
}

/// Whether a solution on a branch is an orbit, and why not; marginal at a grazing or where an impact fades.
pub(super) fn admissible_at(orbit: &MachineOrbit, at: Option<Bifurcation>) -> (Judgement, Option<String>) {
    match at {
        Some(Bifurcation::Grazing | Bifurcation::Fade) => (Judgement::Marginal, None),
        _ => match admissible(orbit) {
            (Judgement::Yes, _) if !orbit.is_orbit() => {
                let why = "the least gap between impacts is not positive, though within the minimum depth";
                (Judgement::Marginal, Some(why.into()))
            }
            found => found,
        },
    }
}

pub(super) fn admissible(orbit: &MachineOrbit) -> (Judgement, Option<String>) {
    match &orbit.admissibility {
        MachineAdmissibility::Admissible => (Judgement::Yes, None),
        MachineAdmissibility::Marginal(why) => (Judgement::Marginal, Some(why.to_string())),
        MachineAdmissibility::No(why) => (Judgement::No, Some(why.to_string())),
    }
}
