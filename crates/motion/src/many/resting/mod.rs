//! Periodic motions that rest on a stop, of a machine of any size: those that a search finds.
//!
//! While a machine rests on a stop, what it does not hold remembers how it came there. So there is no map of
//! phases alone whose cycles are all such motions, as with one coordinate (`attractor::rest`), and they are
//! looked for. Motions begin at rest on each rigid stop, deflected in all that the stop leaves free. From
//! some of their flights after a release, the 1st, 2nd, 4th, and so on, Newton's method looks for a fixed
//! point of the map round 1, 2, … periods, its derivative carried through bounces, rests and releases
//! (`simulate::Carried`): orbits that do not attract are found, too. Each is followed once round, and counts
//! if it comes back and rests on the way. Not here: what happens once round (`round`).

mod round;

use std::f64::consts::TAU;

use rayon::prelude::*;
use round::{Round, Span, at_once, covered};

use super::{
    State,
    deflected::Deflections,
    section::PlanarMachine,
    simulate::{Event, Simulator},
};
use crate::{
    attractor::{
        FixedPoint,
        dynamics::{Dynamics, Motion},
        fixed_point,
        rest::tell,
    },
    error::{Error, Result},
    monitor::Monitor,
    motion::{RunEnd, Time},
};

/// How far a search goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RestSearch {
    /// Motions that begin at rest on each rigid stop.
    pub starts: u32,
    /// The greatest period looked for, in periods of the forcing.
    pub longest: u32,
    /// For how many periods each motion is followed.
    pub periods: u32,
}

/// A rest of a periodic motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RestSpan {
    /// The stop.
    pub stop: usize,
    /// When it begins, as a phase in radians.
    pub begin: f64,
    /// When the stop lets go, as a phase in radians.
    pub release: f64,
    /// How long it lasts, in radians.
    pub length: f64,
}

/// A periodic motion that rests.
#[derive(Debug, Clone, PartialEq)]
pub struct RestCycle {
    /// In periods of the forcing.
    pub period: u64,
    /// Its rests that end, in order, from the one of the least phase of release on.
    pub rests: Vec<RestSpan>,
    /// The stops that it rests on all the time.
    pub held: Vec<usize>,
    /// The part of the time in which it rests on some stop.
    pub resting: f64,
    /// Where it is as the first of its rests ends; at phase 0 if none does.
    pub begin: State,
    /// Impacts in a period, as far as they are followed one by one.
    pub impacts: u64,
    /// The greatest speed of an impact, per radian.
    pub fastest: f64,
    /// Minima of a gap that are neither clear of the stop nor clearly impacts.
    pub tangencies: u64,
    /// Real and imaginary part, the largest modulus first.
    pub multipliers: Vec<(f64, f64)>,
    /// Its states at phase 0.
    points: Vec<Vec<f64>>,
    /// States this close are the same.
    same: f64,
}

/// What a search found.
pub struct RestsFound {
    /// Periodic motions, by period, then by the phase of the first release.
    pub cycles: Vec<RestCycle>,
    /// How many motions were followed.
    pub followed: u64,
    /// How many of them came to a rest that ended.
    pub rested: u64,
    /// How many could not be followed to their end, or on the way to an orbit.
    pub failed: u64,
    /// Why the first of these could not.
    pub failure: Option<Error>,
}

/// Starts between two looks at whether to go on.
const CHUNK: usize = 16;
/// Flights are looked at in the middle, or as long after their beginning, in radians, if they are long.
const INTO_FLIGHT: f64 = TAU / 8.0;

/// The periodic motions that a search finds. Cost: for each start some log₂ of its releases times `longest`
/// tries of Newton's method, each of about five rounds with vectors.
///
/// # Errors
/// The monitor's.
pub fn search(planar: &PlanarMachine, keys: &RestSearch, monitor: &dyn Monitor) -> Result<RestsFound> {
    let simulator = planar.simulator();
    let all = simulator.contacts().all();
    let rigid: Vec<usize> = (0..all.len()).filter(|&stop| all[stop].soft.is_none()).collect();
    let deflections = Deflections::new(simulator, 4.0 * simulator.size());
    let starts: Vec<(usize, u32)> =
        (0..keys.starts).flat_map(|i| rigid.iter().map(move |&stop| (stop, i))).collect();
    let mut found = RestsFound { cycles: Vec::new(), followed: 0, rested: 0, failed: 0, failure: None };
    for chunk in starts.chunks(CHUNK) {
        monitor.advance(0)?;
        let one = |&(stop, i): &(usize, u32)| {
            Follower { planar, keys }.follow(&on_stop(simulator, stop, deflections.deflected(i)))
        };
        let motions: Vec<Option<Followed>> = chunk.par_iter().map(one).collect();
        for Followed { cycles, rested, failure } in motions.into_iter().flatten() {
            (found.followed, found.rested) = (found.followed + 1, found.rested + u64::from(rested));
            found.failed += u64::from(failure.is_some());
            found.failure = found.failure.take().or(failure);
            for cycle in cycles {
                if !found.cycles.iter().any(|known| known.is(&cycle)) {
                    found.cycles.push(cycle);
                }
            }
        }
    }
    let released = |cycle: &RestCycle| cycle.rests.first().map_or(0.0, |rest| rest.release);
    found.cycles.sort_by(|a, b| a.period.cmp(&b.period).then(released(a).total_cmp(&released(b))));
    Ok(found)
}

/// A state brought to rest on a stop: by the least that does, in the norm of the mass.
fn on_stop(simulator: &Simulator, stop: usize, mut state: State) -> State {
    let contacts = simulator.contacts();
    let [gap, rate] = contacts.all()[stop].gap(&state);
    let push = contacts.push(stop) / contacts.mobility(stop);
    state.q.axpy(-gap, &push, 1.0);
    state.u.axpy(-rate, &push, 1.0);
    state
}

/// What became of a start.
struct Followed {
    cycles: Vec<RestCycle>,
    rested: bool,
    failure: Option<Error>,
}

#[derive(Clone, Copy)]
struct Follower<'s> {
    planar: &'s PlanarMachine,
    keys: &'s RestSearch,
}

impl Follower<'_> {
    fn rigid(&self, stop: usize) -> bool {
        self.planar.simulator().contacts().all().get(stop).is_some_and(|stop| stop.soft.is_none())
    }

    /// None if the start lies behind another stop.
    fn follow(&self, from: &State) -> Option<Followed> {
        let simulator = self.planar.simulator();
        let mut run = simulator.start(Time::new(0, from.t), from.q.as_slice(), from.u.as_slice()).ok()?;
        let mut found = Followed { cycles: Vec::new(), rested: false, failure: None };
        let until = Time::new(i64::from(self.keys.periods), from.t);
        let mut releases = 0u64;
        let tried = |state: &State, found: &mut Followed| {
            if let Err(error) = self.try_from(state, &mut found.cycles) {
                found.failure.get_or_insert(error);
            }
        };
        loop {
            let event = run.next(until);
            let state = State { t: run.time().phase, ..run.state() };
            match event {
                Event::Release(release) if self.rigid(release.place) => {
                    (releases, found.rested) = (releases + 1, true);
                    if releases.is_power_of_two() {
                        self.in_flight_after(&state).iter().for_each(|state| tried(state, &mut found));
                    }
                }
                Event::End(end) => {
                    if end == RunEnd::Reached && !run.resting().is_empty() {
                        // What rests at the end may do so for ever.
                        let flight = match self.next_release(&state) {
                            Some(release) => self.in_flight_after(&release),
                            None => Some(state),
                        };
                        flight.iter().for_each(|state| tried(state, &mut found));
                    }
                    let ended = || Error::input(format!("it ended {}", end.why()));
                    let failed = run.failure().or_else(|| (end != RunEnd::Reached).then(ended));
                    found.failure = found.failure.or(failed);
                    return Some(found);
                }
                _ => {}
            }
        }
    }

    /// Where a stop next lets go, within the periods looked for.
    fn next_release(&self, from: &State) -> Option<State> {
        let simulator = self.planar.simulator();
        let mut run = simulator.start(Time::new(0, from.t), from.q.as_slice(), from.u.as_slice()).ok()?;
        loop {
            match run.next(Time::new(i64::from(self.keys.longest), from.t)) {
                Event::Release(release) if self.rigid(release.place) => {
                    return Some(State { t: run.time().phase, ..run.state() });
                }
                Event::End(_) => return None,
                _ => {}
            }
        }
    }

    /// A state on the flight that begins with a release: beside it, too, nothing is behind the stop.
    fn in_flight_after(&self, release: &State) -> Option<State> {
        let begin = || {
            let (time, simulator) = (Time::new(0, release.t), self.planar.simulator());
            simulator.start(time, release.q.as_slice(), release.u.as_slice())
        };
        let time = Time::new(0, release.t);
        let mut ahead = begin().ok()?;
        // The release itself may be told once more.
        let until = time.after(2.0 * INTO_FLIGHT);
        let left = loop {
            let event = ahead.next(until);
            let left = ahead.time().since(time);
            if left > INTO_FLIGHT * 1e-6 || matches!(event, Event::End(_)) {
                break left;
            }
        };
        let mut run = begin().ok()?;
        run.finish(time.after(left / 2.0));
        Some(State { t: run.time().phase, ..run.state() })
    }

    /// The orbits that Newton's method finds from a state.
    fn try_from(&self, state: &State, cycles: &mut Vec<RestCycle>) -> Result<()> {
        let (phase, whole) = (state.t, self.planar.point(state).whole);
        let mut known: Vec<u64> = Vec::new();
        for period in 1..=u64::from(self.keys.longest) {
            if known.iter().any(|shorter| period.is_multiple_of(*shorter)) {
                continue;
            }
            let Some(fixed) = fixed_point(self.planar, &whole, phase, period)? else { continue };
            let Some(cycle) = self.cycle(fixed, phase, period, true)? else { continue };
            known.push(cycle.period);
            if !cycles.iter().any(|old| old.is(&cycle)) {
                cycles.push(cycle);
            }
        }
        Ok(())
    }

    /// The orbit of a fixed point; none if it does not rest, or does not come back. When a rest began in
    /// which the point may lie is not seen from there: once more, from the flight after it.
    fn cycle(&self, fixed: FixedPoint, phase: f64, period: u64, again: bool) -> Result<Option<RestCycle>> {
        let (planar, simulator) = (self.planar, self.planar.simulator());
        let FixedPoint { x, slope, same } = fixed;
        let start = planar.at(&x, phase);
        let points = (0..period).map(|i| -> Result<Option<Vec<f64>>> {
            let Ok(mut motion) = planar.begin(&start) else { return Ok(None) };
            let end = motion.pass(Time::new(i as i64 + 1, 0.0))?;
            Ok((end == RunEnd::Reached).then(|| motion.point().whole))
        });
        let Some(points) = points.collect::<Result<Option<Vec<_>>>>()? else { return Ok(None) };
        // Of a shorter period, if it comes back sooner.
        for shorter in (1..period).filter(|shorter| period.is_multiple_of(*shorter)) {
            let turned = points.iter().cycle().skip(shorter as usize);
            if points.iter().zip(turned).all(|(a, b)| apart(a, b) <= same) {
                let known = fixed_point(planar, &x, phase, shorter)?;
                return known.map_or(Ok(None), |known| self.cycle(known, phase, shorter, again));
            }
        }
        let state = planar.state(&x, phase);
        let until = Time::new(period as i64, phase);
        let Ok(mut run) = simulator.start(Time::new(0, phase), state.q.as_slice(), state.u.as_slice()) else {
            return Ok(None);
        };
        let mut round = Round::new(run.resting().to_vec());
        let rigid = |stop: usize| self.rigid(stop).then_some(stop);
        let end = tell(|| run.next(until), rigid, &mut |event| {
            round.meet(event);
            true
        });
        run.failure().map_or(Ok(()), Err)?;
        let after = || self.next_release(&state).and_then(|release| self.in_flight_after(&release));
        if let Some(flight) = again.then(after).flatten() {
            let known = fixed_point(planar, &planar.point(&flight).whole, flight.t, period)?;
            return known.map_or(Ok(None), |known| self.cycle(known, flight.t, period, false));
        }
        let back = planar.point(&State { t: phase, ..run.state() });
        let Some((mut rests, held)) = round.rests(period) else { return Ok(None) };
        let least = |i: &usize, j: &usize| {
            turned(rests[*i].release.phase).total_cmp(&turned(rests[*j].release.phase))
        };
        let least = (0..rests.len()).min_by(least).unwrap_or(0);
        rests.rotate_left(least);
        if end != RunEnd::Reached || apart(&back.whole, &x) > same || rests.is_empty() && held.is_empty() {
            return Ok(None);
        }
        let Some(multipliers) = PlanarMachine::multipliers(&slope, None) else { return Ok(None) };
        // What a rest holds is gone: rounding is what is left of it.
        let left = multipliers.len().saturating_sub(2 * at_once(&rests, held.len(), period));
        let told = |(i, one)| if i < left { one } else { (0.0, 0.0) };
        let multipliers = multipliers.into_iter().enumerate().map(told).collect();
        let Some(begin) = self.state_at(&state, rests.first().map(|rest| rest.release)) else {
            return Ok(None);
        };
        let resting = if held.is_empty() { covered(&rests, period) } else { 1.0 };
        let Round { impacts, fastest, tangencies, .. } = round;
        Ok(Some(RestCycle {
            period,
            rests: rests.into_iter().map(Span::phases).collect(),
            held,
            resting,
            begin,
            impacts,
            fastest,
            tangencies,
            multipliers,
            points,
            same,
        }))
    }

    /// Where the motion from a state is so much later; else at phase 0 after it.
    fn state_at(&self, from: &State, release: Option<Time>) -> Option<State> {
        let simulator = self.planar.simulator();
        let mut run = simulator.start(Time::new(0, from.t), from.q.as_slice(), from.u.as_slice()).ok()?;
        let until = release.unwrap_or(Time::new(1, 0.0));
        (run.finish(until) == RunEnd::Reached).then(|| State { t: turned(until.phase), ..run.state() })
    }
}

fn turned(phase: f64) -> f64 {
    phase.rem_euclid(TAU)
}

/// In the largest coordinate.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

impl RestCycle {
    /// Whether the other is the same motion, wherever on it one began.
    fn is(&self, other: &RestCycle) -> bool {
        let close = self.same.max(other.same);
        let same = |shift: usize| {
            let turned = other.points.iter().cycle().skip(shift);
            self.points.iter().zip(turned).all(|(a, b)| apart(a, b) <= close)
        };
        self.points.len() == other.points.len() && (0..self.points.len()).any(same)
    }
}
