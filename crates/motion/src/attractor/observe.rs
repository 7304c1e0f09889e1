//! What motions lead to: a transient passes, recurrence is looked for, points of the section are kept.

use num_integer::Integer;

use super::{
    cycle::Cycle,
    detection::{Detection, Fate, wait},
    dynamics::{Dynamics, Motion, SectionState},
    section::section,
};
use crate::{error::Result, monitor::Monitor, motion::RunEnd};

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
    /// Whether a periodic one is looked at until each point that is kept of it was met; else its cycle is
    /// enough.
    pub round: bool,
    /// Of every this many of them the first is kept, counted from the end of the transient; at least 1.
    pub every: u32,
}

/// What was seen of a motion that goes on.
#[derive(Debug, Clone, PartialEq)]
pub struct Observed<S, P> {
    /// Where the motion was at the end of the transient; if it was still on its way to a cycle, the point of
    /// the cycle nearest to it.
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

impl<S, P: SectionState> Observed<S, P> {
    /// Of a motion on its way to a cycle, the cycle in its place: a motion can be told to tend there long
    /// before it comes there, and no number is to depend on how far it was.
    ///
    /// # Errors
    /// Those of [`Dynamics::begin`].
    pub(crate) fn on_its_cycle<D: Dynamics<Start = S, Point = P>>(
        self,
        dynamics: &D,
        Observation { phase, every, .. }: &Observation,
    ) -> Result<Observed<S, P>> {
        let Some(cycle) = &self.cycle else { return Ok(self) };
        let here = dynamics.begin(&self.settled)?.point();
        if cycle.passes(&here) {
            return Ok(self);
        }
        let far = |point: &P| apart(point.coordinates(), here.coordinates());
        let on = cycle.points.iter().min_by(|a, b| far(a).total_cmp(&far(b))).expect("a cycle has points");
        let drawn: Vec<[f64; 2]> = cycle.points.iter().map(|point| dynamics.drawn(point)).collect();
        let points = fitted(&drawn, &self.points, *every as usize);
        Ok(Observed { settled: dynamics.at(on.coordinates(), *phase), points, ..self })
    }
}

/// The greatest difference of two lists.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Every so many points of a cycle, from the one from which on they are nearest to points that were seen. Far
/// from the cycle two of these can have one that is nearest to both: the way as a whole tells where they are.
fn fitted(cycle: &[[f64; 2]], seen: &[[f64; 2]], every: usize) -> Vec<[f64; 2]> {
    let from = |first: usize| {
        cycle.iter().cycle().skip(first).step_by(every).take(seen.len()).copied().collect::<Vec<_>>()
    };
    let off = |way: &[[f64; 2]]| way.iter().zip(seen).map(|(a, b)| apart(a, b)).fold(0.0, f64::max);
    let ways = (0..cycle.len()).map(from);
    ways.min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or_default()
}

impl Observation {
    pub(crate) fn detection(&self) -> Detection {
        let (phase, longest) = (self.phase, self.longest as usize);
        Detection { phase, transient: 0, longest, ..Detection::default() }
    }

    /// Points looked at once it is known what the motion is on.
    pub(crate) fn looks<P: SectionState>(&self, cycle: Option<&Cycle<P>>) -> u32 {
        match (cycle, self.round) {
            (None, _) => self.points,
            // Then the points that are kept come again: which they are is not to go with when the motion is
            // told to be periodic.
            (Some(cycle), true) => {
                u64::from(self.every).lcm(&(cycle.period() as u64)).try_into().unwrap_or(u32::MAX)
            }
            (Some(_), false) => 0,
        }
    }

    /// Whether the point in this forcing period is kept: the same component whatever the motion is.
    pub(crate) fn keeps(&self, period: i64) -> bool {
        (period - 1 - self.transient as i64).rem_euclid(self.every.into()) == 0
    }
}

/// A system of whose motions is told what they lead to: one by one, unless an engine follows many together.
pub trait Attraction: Dynamics {
    /// What the motions from these starts lead to, as [`Detection::detect`] says it of each; `None` for a
    /// start behind a stop, or not finite. A motion that stays where the orbits of a cycle `known` to attract
    /// are not told apart, and comes no farther from it, for two times round, may be taken to end on it
    /// before the transient is over.
    ///
    /// # Errors
    /// Those of [`Motion::pass`]; the monitor's.
    fn fates(
        &self,
        starts: &[Self::Start],
        detection: &Detection,
        known: &[Cycle<Self::Point>],
        monitor: &dyn Monitor,
    ) -> Result<Vec<Option<Fate<Self::Point>>>> {
        let _ = known;
        let settled = Detection { transient: 0, ..detection.clone() };
        let fate = |start| {
            monitor.advance(0)?;
            let Ok(mut run) = self.begin(start) else { return Ok(None) };
            match wait(&mut run, detection.phase, detection.transient, monitor)? {
                RunEnd::Reached => settled.detect(self, &mut run, monitor).map(Some),
                end => Ok(Some(Fate::Ended(end))),
            }
        };
        starts.iter().map(fate).collect()
    }

    /// What is seen of each of these motions, each with its system: the same whether they are followed one by
    /// one or together.
    ///
    /// # Errors
    /// Those of [`Detection::check`] and of [`Motion::pass`]; the monitor's.
    fn observe<'a>(
        motions: Vec<(&'a Self, Self::Motion<'a>)>,
        observation: &Observation,
        monitor: &dyn Monitor,
    ) -> Result<Vec<ObservedMotion<Self::Start, Self::Point>>> {
        one_by_one(motions, observation, monitor)
    }
}

/// Observes motions one after the other: see [`Attraction::observe`].
///
/// # Errors
/// Those of [`Detection::check`] and of [`Motion::pass`]; the monitor's.
pub(crate) fn one_by_one<'a, D: Dynamics>(
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
    let (cycle, undecided) = match observation.detection().detect(dynamics, run, monitor)? {
        Fate::Ended(end) => return Ok(Err(end)),
        Fate::Periodic(cycle) => (Some(cycle), false),
        Fate::Irregular => (None, false),
        Fate::Unsettled => (None, true),
    };
    monitor.advance(0)?;
    let (mut points, before) = (Vec::new(), run.impacts());
    let end = section(run, phase, observation.looks(cycle.as_ref()).into(), |point| {
        if observation.keeps(point.period) {
            points.push(dynamics.drawn(&point.at));
        }
        true
    })?;
    if end != RunEnd::Reached {
        return Ok(Err(end));
    }
    let impacts = cycle.as_ref().map_or_else(|| run.impacts() - before, |cycle| cycle.impacts);
    Observed { settled, cycle, undecided, points, impacts }.on_its_cycle(dynamics, observation).map(Ok)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_point_of_a_cycle_is_seen_once_round() {
        let cycle: Vec<[f64; 2]> = [-0.2, 2.9, 7.0, 3.2, -0.1].map(|q| [q, 0.0]).into();
        let turned = |first: usize, every: usize, count: usize| -> Vec<[f64; 2]> {
            cycle.iter().cycle().skip(first).step_by(every).take(count).copied().collect()
        };
        // Near it, and so far that 3 is nearest to what comes to 7.
        for off in [1e-3, 2.5] {
            for (first, every, count) in [(0, 1, 5), (3, 1, 5), (2, 2, 5), (1, 5, 1)] {
                let mut seen = turned(first, every, count);
                seen.iter_mut().filter(|point| point[0] == 7.0).for_each(|point| point[0] -= off);
                assert_eq!(
                    fitted(&cycle, &seen, every),
                    turned(first, every, count),
                    "{off} {first} {every}"
                );
            }
        }
        assert_eq!(fitted(&cycle, &[], 1), Vec::<[f64; 2]>::new());
    }
}
