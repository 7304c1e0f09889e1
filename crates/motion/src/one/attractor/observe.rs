//! Motions of oscillators observed on a section many at once: the same as one by one, to the bit.

use crate::{
    attractor::{
        cycle::Cycle,
        detection::{Fate, Recurrence},
        dynamics::Dynamics,
        observe::{Observation, Observed, ObservedMotion, one_by_one},
    },
    error::Result,
    monitor::Monitor,
    motion::{RunEnd, State},
    one::simulate::{Run, Simulator, batch::Batch},
};

/// Fewer motions than this are followed one by one: they would not fill a vector.
const FEW: usize = 8;

/// Periods between two looks at whether to go on.
const PAUSE: u64 = 16;

/// What a motion of a batch is looked at for.
enum Stage<'d> {
    /// For recurrence, with the impacts at the last point.
    Recurs(Recurrence<'d, Simulator>, u64),
    /// For points: how many more, those kept, and the impacts before the first.
    Shows { cycle: Option<Cycle>, undecided: bool, left: u32, points: Vec<[f64; 2]>, before: u64 },
}

/// Observes motions many at once: see
/// [`Attraction::observe`](crate::attractor::observe::Attraction::observe).
///
/// # Errors
/// Those of [`Detection::check`]; the monitor's.
pub(super) fn observe(
    motions: Vec<(&Simulator, Run<'_>)>,
    observation: &Observation,
    monitor: &dyn Monitor,
) -> Result<Vec<ObservedMotion<State, [f64; 2]>>> {
    if motions.len() < FEW {
        return one_by_one(motions, observation, monitor);
    }
    let detection = observation.detection();
    detection.check()?;
    let mut outcomes = vec![Err(RunEnd::Reached); motions.len()];
    let simulators: Vec<&Simulator> = motions.iter().map(|(simulator, _)| *simulator).collect();
    let mut batch = Batch::new(observation.phase, motions);
    let mut under_way: Vec<usize> = (0..outcomes.len()).collect();
    let mut settled = Vec::new();
    for passed in 0..=observation.transient {
        // Where they are before the last pass.
        if passed == observation.transient {
            settled =
                under_way.iter().map(|&motion| simulators[motion].as_start(batch.state(motion))).collect();
        }
        batch.pass();
        if passed % PAUSE == 0 {
            monitor.advance(0)?;
        }
        let mut at = 0;
        under_way.retain(|&motion| {
            let end = batch.end(motion);
            if end == RunEnd::Reached {
                at += 1;
                return true;
            }
            if !settled.is_empty() {
                settled.remove(at);
            }
            outcomes[motion] = Err(end);
            batch.drop(motion);
            false
        });
    }
    let mut seen: Vec<(usize, State, Stage)> = under_way
        .into_iter()
        .zip(settled)
        .map(|(motion, settled)| {
            let recurrence = Recurrence::new(&detection, simulators[motion], batch.point(motion), monitor)?;
            Ok((motion, settled, Stage::Recurs(recurrence, batch.impacts(motion))))
        })
        .collect::<Result<_>>()?;
    let mut passed = 0u64;
    while !seen.is_empty() {
        batch.pass();
        if passed.is_multiple_of(PAUSE) {
            monitor.advance(0)?;
        }
        passed += 1;
        let mut failed = None;
        seen.retain_mut(|(motion, settled, stage)| {
            let outcome = match batch.end(*motion) {
                RunEnd::Reached => match stage
                    .see(&batch, *motion, *settled, (simulators[*motion], observation))
                    .and_then(|seen| {
                        seen.map(|seen| seen.on_its_cycle(simulators[*motion], observation)).transpose()
                    }) {
                    Ok(Some(observed)) => Ok(observed),
                    Ok(None) => return true,
                    Err(error) => {
                        failed = Some(error);
                        return true;
                    }
                },
                end => Err(end),
            };
            outcomes[*motion] = outcome;
            batch.drop(*motion);
            false
        });
        if let Some(error) = failed {
            return Err(error);
        }
    }
    Ok(outcomes)
}

impl Stage<'_> {
    /// The next point; once no other is asked for, what was seen.
    fn see(
        &mut self,
        batch: &Batch,
        motion: usize,
        settled: State,
        (simulator, observation): (&Simulator, &Observation),
    ) -> Result<Option<Observed<State, [f64; 2]>>> {
        let (at, impacts) = (batch.point(motion), batch.impacts(motion));
        match self {
            Stage::Recurs(recurrence, before) => {
                if recurrence.see(at, impacts - *before)? {
                    *before = impacts;
                    return Ok(None);
                }
                let (cycle, undecided) = match recurrence.fate()? {
                    Fate::Periodic(cycle) => (Some(cycle), false),
                    fate => (None, fate == Fate::Unsettled),
                };
                let left = observation.looks(cycle.as_ref());
                *self = Stage::Shows { cycle, undecided, left, points: Vec::new(), before: impacts };
            }
            Stage::Shows { left, points, .. } => {
                *left -= 1;
                if observation.keeps(batch.period(motion)) {
                    points.push(simulator.drawn(&at));
                }
            }
        }
        Ok(match self {
            Stage::Shows { cycle, undecided, left: 0, points, before } => {
                let (cycle, points) = (cycle.take(), std::mem::take(points));
                let impacts = cycle.as_ref().map_or(impacts - *before, |cycle| cycle.impacts);
                Some(Observed { settled, cycle, undecided: *undecided, points, impacts })
            }
            _ => None,
        })
    }
}
