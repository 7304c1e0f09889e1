//! The search for orbits of a pattern of a machine.

use std::f64::consts::TAU;

use rayon::prelude::*;

use super::super::super::Job;
use crate::{
    continuation::Starts,
    error::{Error, Result},
    many::{
        Machine, RealVector, State,
        orbit::{FreeStarts, Itinerary, Orbit, Strike, find, find_from},
        simulate::Simulator,
    },
    scene::orbits::OrbitKeys,
};

/// Starts between two looks at whether to go on.
const CHUNK: u32 = 16;

/// Closer than this, relative to the largest speed and to a radian, two solutions are one.
const NEAR: f64 = 1e-7;

/// The orbits of the keys: the one that Newton's method finds from `start`, or those of a search.
pub(crate) fn machine_orbits(
    keys: &OrbitKeys,
    machine: &Machine<f64>,
    simulator: &Simulator,
    job: &Job,
) -> Result<Vec<Orbit>> {
    let pattern = pattern(keys, machine)?;
    let rate = machine.rate();
    if simulator.is_pieced() && keys.pattern.is_empty() {
        return through_soft_stops(keys, machine, simulator, job);
    }
    if keys.pattern.is_empty() {
        return Ok(vec![find(simulator, &pattern, &[])?]);
    }
    if !keys.start.is_empty() {
        return Ok(vec![find(simulator, &pattern, &keys.unknowns(|speed| speed / rate))?]);
    }
    let m = keys.pattern.len();
    let met = pattern.strikes().iter().map(|strike| strike.place);
    let greatest = keys.speed.map_or(4.0 * simulator.scale_at(met), |speed| speed / rate);
    let begin = Starts::new(greatest, |t| simulator.on_stop(pattern.strikes()[0].place, t));
    let mut found: Vec<Orbit> = Vec::new();
    for first in (0..keys.starts).step_by(CHUNK as usize) {
        job.check()?;
        let last = first.saturating_add(CHUNK).min(keys.starts);
        let roots: Vec<Orbit> = (first..last)
            .into_par_iter()
            .filter_map(|i| find(simulator, &pattern, &begin.of(&keys.pattern, i)).ok())
            .collect();
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

/// Orbits without impacts on rigid stops, where there are soft ones or friction or forces are formulas: from
/// the state at phase 0 of the keys, or those of a search, from the motion that the forces alone bring about
/// and from deflections of it.
fn through_soft_stops(
    keys: &OrbitKeys,
    machine: &Machine<f64>,
    simulator: &Simulator,
    job: &Job,
) -> Result<Vec<Orbit>> {
    let (pattern, rate) = (pattern(keys, machine)?, machine.rate());
    if let Some(state) = state(keys, machine)? {
        return Ok(vec![find_from(simulator, &pattern, &[], Some(&state))?]);
    }
    let scale = simulator.size();
    let greatest = keys.speed.map_or(4.0 * scale, |speed| speed / rate);
    let starts = FreeStarts::new(simulator, &pattern, greatest)?;
    let near = |a: &State, b: &State| {
        let size = a.q.amax().max(a.u.amax());
        (&a.q - &b.q).amax().max((&a.u - &b.u).amax()) <= NEAR * size
    };
    // Where a row sticks all the time, it may do so at all places of a stretch: one of them is enough.
    let rests = |a: &Orbit, b: &Orbit| a.held.is_some() && a.held == b.held;
    let mut found: Vec<Orbit> = Vec::new();
    for first in (0..keys.starts).step_by(CHUNK as usize) {
        job.check()?;
        let last = first.saturating_add(CHUNK).min(keys.starts);
        let roots: Vec<Orbit> = (first..last).into_par_iter().filter_map(|i| starts.find(i).ok()).collect();
        for orbit in roots {
            // Of a shorter period if that period's equations have the same solution: stops that are in the
            // way of the motion, which is listed as such, are no part of them.
            let shorter = |n: u32| -> Result<bool> {
                if !keys.period.is_multiple_of(n) {
                    return Ok(false);
                }
                let again = find_from(simulator, &Itinerary::free(n)?, &[], Some(&orbit.state));
                Ok(again.is_ok_and(|again| near(&orbit.state, &again.state)))
            };
            let known = found.iter().any(|old| near(&old.state, &orbit.state) || rests(old, &orbit));
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

/// The state at phase 0 that the keys give of a motion without impacts, if they give one.
pub(super) fn state(keys: &OrbitKeys, machine: &Machine<f64>) -> Result<Option<State>> {
    if keys.start.is_empty() {
        return Ok(None);
    }
    let (start, points) = (keys.unknowns(|speed| speed), machine.points());
    let part = |from: usize| machine.coordinates(&RealVector::from_column_slice(&start[from..from + points]));
    Ok(Some(State { t: 0.0, q: part(0)?, u: part(points)? / machine.rate() }))
}

/// Whether b is a with impact `shift` called the first.
fn same(a: &Orbit, b: &Orbit, shift: usize) -> bool {
    let (strikes, m) = (a.itinerary.strikes(), a.impacts.len());
    let fastest = a.impacts.iter().fold(0.0, |most: f64, impact| most.max(impact.speed));
    (0..m).all(|i| {
        let (x, y) = (&a.impacts[i], &b.impacts[(i + shift) % m]);
        let turn = (x.time - y.time).rem_euclid(TAU);
        strikes[i].place == strikes[(i + shift) % m].place
            && turn.min(TAU - turn) < NEAR
            && (x.speed - y.speed).abs() < NEAR * fastest
    })
}

/// The pattern of the keys, whose stops go by their names.
fn pattern(keys: &OrbitKeys, machine: &Machine<f64>) -> Result<Itinerary> {
    if keys.pattern.is_empty() {
        return Itinerary::free(keys.period);
    }
    let stop = |i: usize| match keys.stops.get(i) {
        None => Ok(0),
        Some(known) => machine
            .stops
            .iter()
            .position(|stop| stop.name == known.name)
            .ok_or_else(|| Error::input(format!("there is no stop called {:?}", known.name))),
    };
    let strikes = keys.pattern.iter().enumerate();
    Itinerary::new(
        strikes.map(|(i, &periods)| Ok(Strike { place: stop(i)?, periods })).collect::<Result<_>>()?,
    )
}
