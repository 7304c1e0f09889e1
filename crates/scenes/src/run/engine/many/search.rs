//! The search for orbits of a pattern of a machine.

use std::f64::consts::TAU;

use super::super::super::Job;
use crate::{
    continuation::{NEAR, OrbitSearch, Starts, search_all},
    error::{Error, Result},
    many::{
        Machine, RealVector, State,
        orbit::{
            FreeStarts, Itinerary, Orbit, Strike, find, find_beside, find_from, find_projected, is_hopeless,
        },
        simulate::Simulator,
    },
    scene::orbits::OrbitKeys,
};

/// The orbits of the keys: the one that Newton's method finds from `start`, or those of a search.
pub(crate) fn machine_orbits(
    keys: &OrbitKeys,
    machine: &Machine<f64>,
    simulator: &Simulator,
    job: &Job,
) -> Result<OrbitSearch<Orbit>> {
    let pattern = pattern(keys, machine)?;
    let rate = machine.rate();
    if simulator.is_pieced() && keys.pattern.is_empty() {
        return through_soft_stops(keys, machine, simulator, job);
    }
    if keys.pattern.is_empty() || !keys.start.is_empty() {
        let start = if keys.pattern.is_empty() { Vec::new() } else { keys.unknowns(|speed| speed / rate) };
        return find(simulator, &pattern, &start).map(|orbit| OrbitSearch::of_one(Ok(orbit)));
    }
    let m = keys.pattern.len();
    let met = pattern.strikes().iter().map(|strike| strike.place);
    // What a force that is a formula does to faster ones, the size does not tell.
    let times = if simulator.is_smooth() { 1.0 } else { 4.0 };
    let greatest = keys.speed.map_or(times * simulator.scale_at(met), |speed| speed / rate);
    let begin = Starts::new(greatest, |t| simulator.on_stop(pattern.strikes()[0].place, t));
    // Of several impacts the times alone are spread where state and speeds follow from them.
    let projects = m > 1 && simulator.is_held();
    let look = |i: u32, known: &[Orbit]| {
        let start = begin.of(&keys.pattern, i);
        match projects {
            true => find_projected(simulator, &pattern, &start, known),
            false => find_beside(simulator, &pattern, &start, None, known),
        }
    };
    let whole = |orbit: &Orbit| {
        let fastest = orbit.impacts.iter().fold(0.0, |most: f64, impact| most.max(impact.speed));
        let moving = orbit.impacts.iter().all(|impact| impact.speed > NEAR * fastest);
        Ok(moving && (1..m).all(|shift| !same(orbit, orbit, shift)))
    };
    let alike = |a: &Orbit, b: &Orbit| (0..m).any(|shift| same(a, b, shift));
    let hopeless = || is_hopeless(simulator, &pattern, &begin.of(&keys.pattern, 0));
    let mut all = search_all(keys.starts, look, alike, whole, hopeless, || job.check())?;
    all.found.sort_by(|a, b| a.impacts[0].speed.total_cmp(&b.impacts[0].speed));
    Ok(all)
}

/// Orbits without impacts on rigid stops, where there are soft ones or friction or forces are formulas: from
/// the state at phase 0 of the keys, or those of a search, from the motion that the forces alone bring about
/// and from deflections of it.
fn through_soft_stops(
    keys: &OrbitKeys,
    machine: &Machine<f64>,
    simulator: &Simulator,
    job: &Job,
) -> Result<OrbitSearch<Orbit>> {
    let (pattern, rate) = (pattern(keys, machine)?, machine.rate());
    if let Some(state) = state(keys, machine)? {
        let found = find_from(simulator, &pattern, &[], Some(&state));
        return found.map(|orbit| OrbitSearch::of_one(Ok(orbit)));
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
    // An orbit of several periods is the same one at the next.
    let turned = |a: &Orbit, b: &Orbit| starts.later(a).iter().any(|later| near(later, &b.state));
    let alike = |a: &Orbit, b: &Orbit| near(&a.state, &b.state) || rests(a, b) || turned(a, b);
    // Of a shorter period if that period's equations have the same solution: stops that are in the way of the
    // motion, which is listed as such, are no part of them.
    let shorter = |orbit: &Orbit, n: u32| -> Result<bool> {
        if !keys.period.is_multiple_of(n) {
            return Ok(false);
        }
        let again = find_from(simulator, &Itinerary::free(n)?, &[], Some(&orbit.state));
        Ok(again.is_ok_and(|again| near(&orbit.state, &again.state)))
    };
    let whole = |orbit: &Orbit| {
        let repeats = (1..keys.period).map(|n| shorter(orbit, n)).collect::<Result<Vec<_>>>()?;
        Ok(!repeats.contains(&true))
    };
    let look = |i: u32, known: &[Orbit]| starts.find(i, known);
    let mut all = search_all(keys.starts, look, alike, whole, || starts.is_hopeless(), || job.check())?;
    all.found.sort_by(|a, b| a.state.q[0].total_cmp(&b.state.q[0]));
    Ok(all)
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
