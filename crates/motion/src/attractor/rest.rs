//! Periodic motions that rest on a stop, of a machine with one coordinate: all of them.
//!
//! What rests on a stop moves as the stop does, and is let go when the force of contact falls to 0, at a
//! phase that the machine alone decides: nothing is left of how it came there. So a motion that leaves from
//! there is one motion, and where it comes to rest next it will leave from another such phase, or from the
//! same. The periodic motions with a rest are the cycles of that map of the phases of release to themselves,
//! of which there are few. A motion near one comes to rest a little earlier or later and leaves as the orbit
//! does: all its multipliers are 0. Not here: how motions come to rest (`one`, `many`), several coordinates,
//! of which the others remember (`many::resting`).

use std::f64::consts::TAU;

use crate::{
    error::Result,
    motion::{Event, RunEnd, Time, event::Place},
    rounding::PHASE,
};

/// A machine with one coordinate and rigid stops.
pub trait Resting {
    /// How many stops something may rest on; they are known by their places.
    fn stops(&self) -> usize;

    /// z″ of what moves as a stop does, at a phase in radians, if nothing held it: the stop presses where it
    /// is negative.
    ///
    /// # Errors
    /// Those of the engine.
    fn bend(&self, stop: usize, phase: f64) -> Result<f64>;

    /// Where what rests on a stop is at a phase, and its velocity per radian.
    fn on(&self, stop: usize, phase: f64) -> [f64; 2];

    /// The highest harmonic that is known to act.
    fn order(&self) -> u32;

    /// Follows the motion that rests on a stop at a time until another, each event told, or until it is told
    /// to end.
    ///
    /// # Errors
    /// Those of the engine.
    fn follow(
        &self,
        stop: usize,
        from: Time,
        until: Time,
        each: &mut dyn FnMut(RestEvent) -> bool,
    ) -> Result<RunEnd>;
}

/// What happens on the way from one rest to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RestEvent {
    /// An impact with a speed, per radian of the forcing.
    Impact(Time, f64),
    /// A minimum of a gap within the minimum depth.
    Tangency(Time),
    /// A stop is come to rest on.
    Rest(Time, usize),
    /// A stop lets go.
    Release(Time, usize),
}

/// Tells of an engine's events until it is told to end; `stop` is the place of a stop to rest on.
pub fn tell<P: Place>(
    mut next: impl FnMut() -> Event<P>,
    stop: impl Fn(P) -> Option<usize>,
    each: &mut dyn FnMut(RestEvent) -> bool,
) -> RunEnd {
    loop {
        let event = match next() {
            Event::Impact(impact) => Some(RestEvent::Impact(impact.time, impact.velocity.abs())),
            Event::Tangency(tangency) => Some(RestEvent::Tangency(tangency.time)),
            Event::Stick(stick) => stop(stick.place).map(|stop| RestEvent::Rest(stick.time, stop)),
            Event::Release(release) => stop(release.place).map(|stop| RestEvent::Release(release.time, stop)),
            Event::Touch(_) | Event::Reversal(_) | Event::Kink(_) => None,
            Event::End(end) => return end,
        };
        if event.is_some_and(|event| !each(event)) {
            return RunEnd::Reached;
        }
    }
}

/// Where a stop lets go of what rests on it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Release {
    /// The stop.
    pub stop: usize,
    /// The phase, in radians from 0 to 2π.
    pub phase: f64,
    /// How long the stop has pressed before, in radians.
    pub pressed: f64,
}

/// What becomes of a motion after a release.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Flight {
    /// The place of the next release, or why there is none.
    pub next: std::result::Result<usize, NoRest>,
    /// How long until then, in radians.
    pub duration: f64,
    /// When the rest before the next release begins, as a phase in radians, and how long it lasts.
    pub rest: Option<[f64; 2]>,
    /// Impacts before that, as far as they are followed one by one.
    pub impacts: u64,
    /// The greatest speed of an impact, per radian.
    pub fastest: f64,
    /// Minima of a gap that are neither clear of the stop nor clearly impacts.
    pub tangencies: u64,
}

/// Why a motion does not come to a rest that ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoRest {
    /// It rests on this stop for ever, which presses at all phases.
    ForEver(usize),
    /// It is not let go there: where the stop presses least, nothing is left to throw it off.
    Held,
    /// Not within the time allowed.
    Late,
    /// It is followed no farther.
    Ended(RunEnd),
}

/// A cycle of releases: a periodic motion.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct RestOrbit {
    /// Its releases, in order, the one of the least place first.
    pub releases: Vec<usize>,
    /// Its period, in periods of the forcing.
    pub periods: u64,
}

/// Releases, what follows each, and the cycles.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Rests {
    /// In the order of stops, then of phases.
    pub releases: Vec<Release>,
    /// What follows each.
    pub flights: Vec<Flight>,
    /// All periodic motions that rest, with no more than the time allowed from a release to the next.
    pub orbits: Vec<RestOrbit>,
    /// Stops that press at all phases.
    pub for_ever: Vec<usize>,
}

/// Into how many parts a period is cut to find where a stop presses, and so many for each harmonic if that is
/// more. What presses or lets go for less than such a part may be missed.
const PARTS: u32 = 4096;
const PARTS_OF_HARMONIC: u32 = 64;
/// How often a part is halved.
const HALVINGS: u32 = 60;
/// A motion begins at rest so much before its release, as a part of the period, or half of what is there.
const BEFORE: f64 = 0.01;
impl Rests {
    /// Of a machine; a motion is followed for so many periods after a release.
    ///
    /// Cost: 4096 accelerations for each stop, or 64 for each harmonic up to the highest if these are more,
    /// and one motion of up to `periods` periods for each release.
    ///
    /// # Errors
    /// Those of the engine.
    pub fn of(machine: &dyn Resting, periods: u32) -> Result<Rests> {
        let (mut releases, mut for_ever) = (Vec::new(), Vec::new());
        for stop in 0..machine.stops() {
            match pressing(machine, stop)? {
                Pressing::Always => for_ever.push(stop),
                Pressing::Until(found) => releases.extend(found),
            }
        }
        let flights = (0..releases.len())
            .map(|i| flight(machine, (&releases, i), &for_ever, periods))
            .collect::<Result<Vec<_>>>()?;
        let orbits = cycles(&flights);
        Ok(Rests { releases, flights, orbits, for_ever })
    }
}

/// When a stop presses.
enum Pressing {
    Always,
    Until(Vec<Release>),
}

/// Where it lets go.
fn pressing(machine: &dyn Resting, stop: usize) -> Result<Pressing> {
    let parts = PARTS.max(PARTS_OF_HARMONIC.saturating_mul(machine.order()));
    let at = |i: u32| TAU * f64::from(i) / f64::from(parts);
    let presses = |phase: f64| Ok(machine.bend(stop, phase)? < 0.0);
    let all = (0..parts).map(|i| presses(at(i))).collect::<Result<Vec<bool>>>()?;
    if all.iter().all(|&here| here) {
        return Ok(Pressing::Always);
    }
    // The last phase at which it is as at the first end, by halving.
    let turn = |i: u32| -> Result<f64> {
        let first = presses(at(i))?;
        let (mut lo, mut hi) = (at(i), at(i + 1));
        for _ in 0..HALVINGS {
            let middle = 0.5 * (lo + hi);
            if presses(middle)? == first { lo = middle } else { hi = middle }
        }
        Ok(lo)
    };
    let is = |i: u32| all[(i % parts) as usize];
    let mut found = Vec::new();
    for i in (0..parts).filter(|&i| is(i) && !is(i + 1)) {
        // Back to where it begins to press.
        let begin = (1..parts).find(|&back| !is(i + parts - back)).unwrap_or(parts - 1);
        let begin = turn((i + parts - begin) % parts)?;
        let phase = turn(i)?;
        found.push(Release { stop, phase, pressed: (phase - begin).rem_euclid(TAU) });
    }
    Ok(Pressing::Until(found))
}

/// What follows a release.
fn flight(
    machine: &dyn Resting,
    (releases, index): (&[Release], usize),
    for_ever: &[usize],
    periods: u32,
) -> Result<Flight> {
    let release = releases[index];
    let before = (BEFORE * TAU).min(0.5 * release.pressed);
    let begin = Time::new(0, release.phase - before);
    let until = begin.after(before + TAU * f64::from(periods));
    let mut found = Flight {
        next: Err(NoRest::Late),
        duration: 0.0,
        rest: None,
        impacts: 0,
        fastest: 0.0,
        tangencies: 0,
    };
    let is_at = |one: &Release, time: Time, stop: usize| {
        let apart = (one.phase - time.phase + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0;
        one.stop == stop && apart.abs() <= PHASE
    };
    let mut left: Option<Time> = None;
    let mut resting: Option<(Time, usize)> = None;
    let end = machine.follow(release.stop, begin, until, &mut |event| {
        match (event, left) {
            // On its stop still.
            (RestEvent::Release(time, stop), None) if is_at(&release, time, stop) => left = Some(time),
            (_, None) => {}
            (RestEvent::Impact(_, speed), _) => {
                resting = None;
                found.impacts += 1;
                found.fastest = found.fastest.max(speed);
            }
            (RestEvent::Tangency(_), _) => found.tangencies += 1,
            (RestEvent::Rest(time, stop), _) => {
                resting = Some((time, stop));
                if for_ever.contains(&stop) {
                    found.next = Err(NoRest::ForEver(stop));
                    return false;
                }
            }
            (RestEvent::Release(time, stop), Some(left)) => {
                let next = releases.iter().position(|one| is_at(one, time, stop));
                if let (Some(next), Some((begin, _))) = (next, resting) {
                    found.next = Ok(next);
                    found.duration = time.since(left);
                    found.rest = Some([begin.phase, time.since(begin)]);
                    return false;
                }
            }
        }
        true
    })?;
    match (end, left) {
        (RunEnd::Reached, None) => found.next = Err(NoRest::Held),
        (end, _) if end != RunEnd::Reached => found.next = Err(NoRest::Ended(end)),
        _ => {}
    }
    Ok(found)
}

/// The cycles of the map from each release to the next.
fn cycles(flights: &[Flight]) -> Vec<RestOrbit> {
    let next = |i: usize| flights[i].next.ok();
    let mut all = Vec::new();
    for start in 0..flights.len() {
        let mut releases = vec![start];
        let mut at = next(start);
        while let Some(i) = at.filter(|i| !releases.contains(i)) {
            releases.push(i);
            at = next(i);
        }
        // Each once, from its least release on.
        if at == Some(start) && releases.iter().all(|&i| i >= start) {
            let duration: f64 = releases.iter().map(|&i| flights[i].duration).sum();
            all.push(RestOrbit { releases, periods: (duration / TAU).round() as u64 });
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flights(next: &[Option<usize>]) -> Vec<Flight> {
        let one = |next: &Option<usize>| Flight {
            next: next.ok_or(NoRest::Late),
            duration: TAU,
            rest: None,
            impacts: 0,
            fastest: 0.0,
            tangencies: 0,
        };
        next.iter().map(one).collect()
    }

    #[test]
    fn each_cycle_is_told_once() {
        // 0 → 1 → 2 → 1, 3 → 3, 4 → nothing, 5 → 4, 6 → 0.
        let map = [Some(1), Some(2), Some(1), Some(3), None, Some(4), Some(0)];
        let found = cycles(&flights(&map));
        let found: Vec<_> = found.into_iter().map(|orbit| (orbit.releases, orbit.periods)).collect();
        assert_eq!(found, [(vec![1, 2], 2), (vec![3], 1)]);
        assert!(cycles(&[]).is_empty());
    }
}
