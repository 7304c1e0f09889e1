//! Many motions of one oscillator followed together to where they end.

use crate::{
    attractor::{
        cycle::Cycle,
        detection::{Detection, Fate, Recurrence},
        dynamics::Dynamics,
    },
    error::Result,
    monitor::Monitor,
    motion::{RunEnd, State},
    one::simulate::{Simulator, batch::Batch},
};

/// Below this part of the distance at which orbits are not told apart the distance is rounding.
const ROUNDED: f64 = 1e-6;

/// How many times round it must come no farther away.
const ROUNDS: u32 = 2;

/// Periods between two looks for who has arrived, and for whether to go on.
const PAUSE: u64 = 8;

/// What motions from these starts lead to: see
/// [`Attraction::fates`](crate::attractor::observe::Attraction::fates).
///
/// # Errors
/// The monitor's.
pub(super) fn together(
    simulator: &Simulator,
    starts: &[State],
    detection: &Detection,
    known: &[Cycle],
    monitor: &dyn Monitor,
) -> Result<Vec<Option<Fate>>> {
    let mut fates = vec![None; starts.len()];
    // Which start each motion of the batch has.
    let (mut names, mut motions) = (Vec::new(), Vec::new());
    for (name, start) in starts.iter().enumerate() {
        if let Ok(run) = simulator.begin(start) {
            names.push(name);
            motions.push((simulator, run));
        }
    }
    let mut batch = Batch::new(detection.phase, motions);
    let mut under_way: Vec<usize> = (0..names.len()).collect();
    let mut arrivals: Vec<Option<Arrival>> = vec![None; names.len()];
    // When a motion is looked at again, if not before.
    let mut due = u64::MAX;
    for passed in 0..=detection.transient {
        batch.pass();
        let look = passed % PAUSE == 0;
        if look {
            monitor.advance(0)?;
        }
        if !look && passed < due && passed < detection.transient {
            continue;
        }
        due = u64::MAX;
        under_way.retain(|&motion| {
            let fate = match batch.end(motion) {
                RunEnd::Reached => {
                    let arrives = arrivals[motion].as_ref().map(|arrival| arrival.due);
                    if arrives.map_or(!look, |then| then != passed) {
                        due = due.min(arrives.unwrap_or(u64::MAX));
                        return true;
                    }
                    let (at, impacts) = (batch.point(motion), batch.impacts(motion));
                    let arrival = arrivals[motion].take();
                    let next = match arrival {
                        Some(arrival) => arrival.again(known, at, impacts),
                        None => Arrival::new(known, passed, at, impacts),
                    };
                    match next {
                        Some(arrival) if arrival.rounds == ROUNDS => {
                            Fate::Periodic(known[arrival.cycle].clone())
                        }
                        next => {
                            due = due.min(next.as_ref().map_or(u64::MAX, |arrival| arrival.due));
                            arrivals[motion] = next;
                            return true;
                        }
                    }
                }
                end => Fate::Ended(end),
            };
            fates[names[motion]] = Some(fate);
            batch.drop(motion);
            false
        });
        if under_way.is_empty() {
            return Ok(fates);
        }
    }
    recurring(simulator, detection, &mut batch, under_way, monitor, |motion, fate| {
        fates[names[motion]] = Some(fate);
    })?;
    Ok(fates)
}

/// Follows motions that have arrived nowhere until it is known whether they recur, and tells what each leads
/// to.
///
/// # Errors
/// The monitor's; those of [`Recurrence::see`].
fn recurring(
    simulator: &Simulator,
    detection: &Detection,
    batch: &mut Batch,
    under_way: Vec<usize>,
    monitor: &dyn Monitor,
    mut tell: impl FnMut(usize, Fate),
) -> Result<()> {
    let start = |motion| {
        let recurrence = Recurrence::new(detection, simulator, batch.point(motion), monitor)?;
        Ok((motion, recurrence, batch.impacts(motion)))
    };
    let mut seen: Vec<_> = under_way.into_iter().map(start).collect::<Result<_>>()?;
    while !seen.is_empty() {
        batch.pass();
        monitor.advance(0)?;
        let mut failed = None;
        seen.retain_mut(|(motion, recurrence, before)| {
            let fate = match batch.end(*motion) {
                RunEnd::Reached => {
                    let impacts = batch.impacts(*motion);
                    let seen = recurrence.see(batch.point(*motion), impacts - *before);
                    match seen.and_then(|more| if more { Ok(None) } else { recurrence.fate().map(Some) }) {
                        Ok(Some(fate)) => fate,
                        more => {
                            failed = more.err();
                            *before = impacts;
                            return true;
                        }
                    }
                }
                end => Fate::Ended(end),
            };
            tell(*motion, fate);
            batch.drop(*motion);
            false
        });
        if let Some(error) = failed {
            return Err(error);
        }
    }
    Ok(())
}

/// A motion that may have arrived at an attractor.
#[derive(Debug, Clone)]
struct Arrival {
    cycle: usize,
    point: usize,
    distance: f64,
    impacts: u64,
    rounds: u32,
    /// When it is looked at next.
    due: u64,
}

impl Arrival {
    fn new(known: &[Cycle], passed: u64, at: [f64; 2], impacts: u64) -> Option<Arrival> {
        let places = known.iter().enumerate().flat_map(|(cycle, known)| {
            known.points.iter().enumerate().map(move |(point, place)| (cycle, point, place))
        });
        let near = |(cycle, point, place): (usize, usize, &[f64; 2])| {
            let distance = distance(&at, place);
            (distance <= known[cycle].same).then_some((cycle, point, distance))
        };
        let (cycle, point, distance) = places.filter_map(near).next()?;
        let due = passed + known[cycle].period() as u64;
        Some(Arrival { cycle, point, distance, impacts, rounds: 0, due })
    }

    /// Once round later; none if it has come farther away or had other impacts.
    fn again(self, known: &[Cycle], at: [f64; 2], impacts: u64) -> Option<Arrival> {
        let cycle = &known[self.cycle];
        let distance = distance(&at, &cycle.points[self.point]);
        let stays =
            distance <= self.distance.max(ROUNDED * cycle.same) && impacts - self.impacts == cycle.impacts;
        let due = self.due + cycle.period() as u64;
        stays.then_some(Arrival { distance, impacts, rounds: self.rounds + 1, due, ..self })
    }
}

/// In the larger coordinate.
fn distance(a: &[f64; 2], b: &[f64; 2]) -> f64 {
    (a[0] - b[0]).abs().max((a[1] - b[1]).abs())
}
