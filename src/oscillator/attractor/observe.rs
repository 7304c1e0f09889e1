//! Motions observed on a section: a transient passes, recurrence is looked for, points are kept. One by one,
//! or those of oscillators many at once, with the same outcome to the bit.

use super::{
    detection::{Cycle, Detection, Fate, Recurrence, wait},
    dynamics::{Dynamics, Motion, SectionState},
    section::section,
};
use crate::{
    error::Result,
    monitor::Monitor,
    oscillator::{
        flow::State,
        simulate::{Run, RunEnd, Simulator, batch::Batch},
    },
};

/// What is looked at of a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Observation {
    /// The phase of the section, 0 ≤ phase < 2π.
    pub phase: f64,
    /// Points of the section that pass first.
    pub transient: u64,
    /// The longest period told from none, at least 1.
    pub longest: u32,
    /// Points looked at of a motion that is not periodic, once it is known not to be.
    pub points: u32,
    /// The same of a periodic one, at least once round; with none its cycle is enough.
    pub round: Option<u32>,
    /// Of every this many of them the first is kept, counted from the end of the transient; at least 1.
    pub every: u32,
}

/// What was seen of a motion that goes on.
#[derive(Debug, Clone, PartialEq)]
pub struct Observed<S, P> {
    /// Where the motion was at the end of the transient.
    pub settled: S,
    /// The periodic orbit that it tends to, if it does.
    pub cycle: Option<Cycle<P>>,
    /// Whether it was not decided if it tends to one.
    pub undecided: bool,
    /// The points kept, as they are drawn.
    pub points: Vec<[f64; 2]>,
    /// Impacts once round; of others while their points were looked at.
    pub impacts: u64,
}

/// What was seen of a motion, or why it ended.
pub type ObservedMotion<S, P> = std::result::Result<Observed<S, P>, RunEnd>;

impl Observation {
    fn detection(&self) -> Detection {
        let (phase, longest) = (self.phase, self.longest as usize);
        Detection { phase, transient: 0, longest, ..Detection::default() }
    }

    /// Points looked at once it is known what the motion is on.
    fn looks<P: SectionState>(&self, cycle: Option<&Cycle<P>>) -> u32 {
        match (cycle, self.round) {
            (None, _) => self.points,
            (Some(cycle), Some(least)) => least.max(cycle.period() as u32),
            (Some(_), None) => 0,
        }
    }

    /// Whether the point in this forcing period is kept: the same component whatever the motion is.
    fn keeps(&self, period: i64) -> bool {
        (period - 1 - self.transient as i64).rem_euclid(self.every.into()) == 0
    }
}

/// Observes motions one after the other: see [`Dynamics::observe`].
///
/// # Errors
/// Those of [`Detection::check`] and of [`Motion::pass`]; the monitor's.
pub(super) fn one_by_one<'a, D: Dynamics>(
    motions: Vec<(&'a D, D::Motion<'a>)>,
    observation: &Observation,
    monitor: &dyn Monitor,
) -> Result<Vec<ObservedMotion<D::Start, D::Point>>> {
    motions.into_iter().map(|(dynamics, mut run)| observe(dynamics, &mut run, observation, monitor)).collect()
}

fn observe<'a, D: Dynamics>(
    dynamics: &'a D,
    run: &mut D::Motion<'a>,
    observation: &Observation,
    monitor: &dyn Monitor,
) -> Result<ObservedMotion<D::Start, D::Point>> {
    let phase = observation.phase;
    let end = wait(run, phase, observation.transient, monitor)?;
    if end != RunEnd::Reached {
        return Ok(Err(end));
    }
    let settled = dynamics.here(run);
    let (cycle, undecided) = match observation.detection().detect(dynamics, run)? {
        Fate::Ended(end) => return Ok(Err(end)),
        Fate::Periodic(cycle) => (Some(cycle), false),
        Fate::Irregular => (None, false),
        Fate::Unsettled => (None, true),
    };
    monitor.advance(0)?;
    let (mut points, before) = (Vec::new(), run.impacts());
    let end = section(run, phase, observation.looks(cycle.as_ref()).into(), |point| {
        if observation.keeps(point.period) {
            points.push(point.at.plane());
        }
        true
    })?;
    if end != RunEnd::Reached {
        return Ok(Err(end));
    }
    let impacts = cycle.as_ref().map_or_else(|| run.impacts() - before, |cycle| cycle.impacts);
    Ok(Ok(Observed { settled, cycle, undecided, points, impacts }))
}

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

/// The same for motions of oscillators, many at once.
///
/// # Errors
/// Those of [`Detection::check`]; the monitor's.
pub(super) fn together(
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
            settled = under_way.iter().map(|&motion| batch.state(motion)).collect();
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
            let recurrence = Recurrence::new(&detection, simulators[motion], batch.point(motion))?;
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
                RunEnd::Reached => match stage.see(&batch, *motion, *settled, observation) {
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
        observation: &Observation,
    ) -> Result<Option<Observed<State, [f64; 2]>>> {
        let (at, impacts) = (batch.point(motion), batch.impacts(motion));
        match self {
            Stage::Recurs(recurrence, before) => {
                if recurrence.see(at, impacts - *before)? {
                    *before = impacts;
                    return Ok(None);
                }
                let (cycle, undecided) = match recurrence.fate() {
                    Fate::Periodic(cycle) => (Some(cycle), false),
                    fate => (None, fate == Fate::Unsettled),
                };
                let left = observation.looks(cycle.as_ref());
                *self = Stage::Shows { cycle, undecided, left, points: Vec::new(), before: impacts };
            }
            Stage::Shows { left, points, .. } => {
                *left -= 1;
                if observation.keeps(batch.period(motion)) {
                    points.push(at);
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
