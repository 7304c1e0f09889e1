//! Tasks of kind `section`: the stroboscopic section of attractors and of chosen orbits.

use std::f64::consts::TAU;

use rayon::prelude::*;
use serde::Serialize;

use super::{
    Finding, Job, Lines, Status,
    engine::{Engine, by_engine},
    row, small_motion,
};
use crate::{
    attractor::{
        cycle::Cycle,
        dynamics::{Dynamics, SectionState},
        lyapunov::{Exponent, exponents},
        observe::{Attraction, Observation, ObservedMotion},
    },
    error::Result,
    motion::{Contact, RunEnd},
    scene::{SectionTask, phase},
};

row! {
    /// An attractor and what its motion amounts to.
    pub struct AttractorRow {
        /// Whether it is periodic; absent where that is not decided: the motion is not settled.
        pub periodic: Option<bool>,
        /// Its period, in forcing periods.
        pub period: Option<usize>,
        /// Impacts in a period.
        pub impacts: Option<u64>,
        /// The mean number of impacts in a forcing period.
        pub impacts_per_period: f64,
        /// How far each coordinate comes in a forcing period, in the mean, along directions in which nothing
        /// holds the machine: motions that differ by that alone are one. Empty where all is held.
        pub drift: Vec<f64>,
        /// The largest Lyapunov exponent times the forcing period, of a periodic motion ln |λ| over its
        /// period; absent where it is −∞, because the motion comes to rest on a wall.
        pub lyapunov_per_period: Option<f64>,
        /// Its standard error; absent where the exponent is, where it is that of multipliers, or for a run
        /// too short.
        pub standard_error: Option<f64>,
        /// How many of the starts lead to it; all motions that are not periodic are told apart by their start
        /// alone.
        pub starts: usize,
    }
}

row! {
    /// An orbit of the task that is no attractor found.
    pub struct SectionOrbitRow {
        /// Its impact pattern.
        pub pattern: String,
        /// Whether it is stable.
        pub stable: bool,
    }
}

row! {
    /// One of the largest Lyapunov exponents of an attractor.
    pub struct ExponentRow {
        /// The attractor, by its place in the list, from 1.
        pub attractor: usize,
        /// Which exponent, from 1: the largest first, with multiplicity.
        pub exponent: usize,
        /// The exponent times the forcing period, of a periodic motion ln |λ| over its period; absent where
        /// it is −∞: a direction that a rest on a stop ends.
        pub per_period: Option<f64>,
        /// Its standard error; absent where the exponent is, where it is that of multipliers, or for a run
        /// too short.
        pub standard_error: Option<f64>,
    }
}

row! {
    /// How often a threshold is passed on an attractor.
    pub struct CrossingRow {
        /// The attractor, by its place in the list, from 1.
        pub attractor: usize,
        /// The threshold's name.
        pub event: String,
        /// How often upwards in a forcing period, in the mean: once round, else in as many periods as the
        /// section has points, or as the motion lasts.
        pub up_per_period: f64,
        /// How often downwards.
        pub down_per_period: f64,
    }
}

/// What of a section belongs together.
#[derive(Debug, Clone, PartialEq)]
pub enum SectionSet {
    /// The points of an attractor, by its place in the list.
    Attractor(usize),
    /// The points of an orbit, by its place in the list.
    Orbit(usize),
}

/// What motions from the starts lead to, and the orbits asked for.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SectionFindings {
    /// The attractors, in the order of the starts that lead there first.
    pub attractors: Vec<AttractorRow>,
    /// Their largest exponents, if more than one for each was asked for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub exponents: Vec<ExponentRow>,
    /// How often its attractors pass the scene's thresholds.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub events: Vec<CrossingRow>,
    /// Of a machine, what the two numbers are by which points are drawn, as in the scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub plane: Option<[String; 2]>,
    /// The admissible orbits of the patterns asked for that are no attractors of the list.
    pub further_orbits: Vec<SectionOrbitRow>,
    /// Why motions of other starts ended, a start each.
    pub(crate) ended: Vec<RunEnd>,
    /// The points (q, u) of each attractor and orbit. Not in JSON: they are the task's CSV file.
    #[serde(skip)]
    pub points: Vec<(SectionSet, Vec<[f64; 2]>)>,
    /// For each piece of the curve on which the next period grazes a wall, the wall and its points.
    #[serde(skip)]
    pub grazing_curve: Vec<(Contact, Vec<[f64; 2]>)>,
    /// Pieces of the stable (true) and unstable manifolds of unstable orbits.
    #[serde(skip)]
    pub manifolds: Vec<(bool, Vec<[f64; 2]>)>,
    /// What counts as contact without impact.
    #[serde(skip)]
    minimum_depth: f64,
    /// Of a machine, the size of the gaps' motion.
    #[serde(skip)]
    size: Option<f64>,
    #[serde(skip)]
    pub(super) notes: Vec<String>,
}

impl Finding for SectionFindings {
    fn status(&self) -> Status {
        if self.attractors.is_empty() && self.further_orbits.is_empty() {
            let mut ends: Vec<&str> = self.ended.iter().map(|end| end.why()).collect();
            ends.dedup();
            return Status::nothing(format!(
                "no start leads to an attractor: every motion ended, {}",
                ends.join("; ")
            ));
        }
        let open = self.attractors.iter().filter(|row| row.periodic.is_none()).count();
        if open > 0 {
            return Status::undecided(format!(
                "{open} motions are not settled: it is not decided whether they tend to periodic orbits; raise `transient`"
            ));
        }
        Status::Done
    }

    fn warnings(&self) -> Vec<String> {
        let all = || self.points.iter().flat_map(|(_, points)| points).map(|point| point[0]);
        let (low, high) = (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max));
        // A section of fixed points only has no extent of its own: its distance from 0 counts, too.
        let extent = self.size.unwrap_or((high - low).max(low.abs()).max(high.abs()));
        self.notes.iter().cloned().chain(small_motion(extent, self.minimum_depth)).collect()
    }

    fn lines(&self, lines: &mut Lines) {
        if let Some([first, second]) = &self.plane {
            lines.say("plane", format!("{first}, {second}"));
        }
        lines.table("attractors", &self.attractors);
        if !self.exponents.is_empty() {
            lines.table("exponents", &self.exponents);
        }
        if !self.events.is_empty() {
            lines.table("events", &self.events);
        }
        if !self.further_orbits.is_empty() {
            lines.table("further_orbits", &self.further_orbits);
        }
        for end in &self.ended {
            lines.say("ended", end.why());
        }
    }
}

/// Follows the motions, in parallel, and finds the orbits.
///
/// # Errors
/// Those of the simulator and of the orbits' search; an interruption.
pub(crate) fn section(task: &SectionTask, job: &Job) -> Result<SectionFindings> {
    by_engine!(job, engine => of(task, job, &engine))
}

/// What is said of a section of what nothing drives.
const UNDRIVEN: &str = "nothing drives the motion: a limit cycle has a period of its own, and comes to other points of this section \
                        for ever; a task `orbit` with `cycle = { q = …, u = … }` finds it and its period";

fn of<E: Engine>(task: &SectionTask, job: &Job, engine: &E) -> Result<SectionFindings> {
    let states = engine.states(&task.starts)?;
    let dynamics = engine.dynamics(&states, None, &task.plane)?;
    let (mut found, cycles, settled) = attractors(task, job, &dynamics, engine.begun(&states))?;
    for ((index, row), start) in (1..).zip(&found.attractors).zip(&settled) {
        let periods = row.period.map_or(task.points, |period| period as u32);
        let row = |(event, [up_per_period, down_per_period]): (String, [f64; 2])| CrossingRow {
            attractor: index,
            event,
            up_per_period,
            down_per_period,
        };
        found.events.extend(engine.crossings(start, periods)?.into_iter().map(row));
    }
    found.plane = engine.plane(&task.plane);
    let begun = engine.begun(&states);
    let free =
        begun.iter().any(|start| dynamics.begin(start).is_ok_and(|run| dynamics.field(&run).is_some()));
    if free && found.attractors.iter().any(|row| row.periodic != Some(true)) {
        found.notes.push(UNDRIVEN.into());
    }
    (found.minimum_depth, found.size) = engine.extents(&dynamics);
    engine.further_orbits(task, &dynamics, &cycles, &mut found)?;
    Ok(found)
}

/// The attractors that motions from the starts lead to; of the periodic ones their place in the list and
/// their points; and of each a state on it.
#[expect(clippy::type_complexity, reason = "the parts are named where they are taken apart")]
fn attractors<D: Attraction>(
    task: &SectionTask,
    job: &Job,
    dynamics: &D,
    starts: Vec<D::Start>,
) -> Result<(SectionFindings, Vec<(usize, Cycle<D::Point>)>, Vec<D::Start>)> {
    let observed = observed(task, job, dynamics, &starts)?;
    let mut found = SectionFindings {
        attractors: Vec::new(),
        exponents: Vec::new(),
        events: Vec::new(),
        plane: None,
        further_orbits: Vec::new(),
        ended: Vec::new(),
        points: Vec::new(),
        grazing_curve: Vec::new(),
        manifolds: Vec::new(),
        notes: Vec::new(),
        minimum_depth: f64::NAN,
        size: None,
    };
    let mut cycles: Vec<(usize, Cycle<D::Point>)> = Vec::new();
    // Where each attractor is followed from.
    let mut settled: Vec<D::Start> = Vec::new();
    for outcome in observed {
        let one = match outcome {
            Ok(one) => one,
            Err(end) => {
                found.ended.push(end);
                continue;
            }
        };
        let known =
            |(_, known): &&(usize, Cycle<D::Point>)| one.cycle.as_ref().is_some_and(|cycle| known.is(cycle));
        if let Some((known, _)) = cycles.iter().find(known) {
            found.attractors[*known].starts += 1;
            continue;
        }
        let index = found.attractors.len();
        let row = AttractorRow {
            periodic: (!one.undecided).then_some(one.cycle.is_some()),
            period: one.cycle.as_ref().map(Cycle::period),
            impacts: one.cycle.as_ref().map(|cycle| cycle.impacts),
            impacts_per_period: 0.0,
            drift: {
                let on =
                    |cycle: &Cycle<D::Point>| dynamics.at(cycle.points[0].coordinates(), phase(&task.phase));
                let periods =
                    one.cycle.as_ref().map_or(f64::from(task.points), |cycle| cycle.period() as f64);
                let from = one.cycle.as_ref().map_or_else(|| one.settled.clone(), on);
                dynamics.drift(&from, periods * TAU)?.into_iter().map(|x| x / periods).collect()
            },
            lyapunov_per_period: None,
            standard_error: None,
            starts: 1,
        };
        found.attractors.push(row);
        let points = match &one.cycle {
            Some(cycle) => cycle.points.iter().map(|point| dynamics.drawn(point)).collect(),
            None => one.points,
        };
        found.points.push((SectionSet::Attractor(index), points));
        cycles.extend(one.cycle.map(|cycle| (index, cycle)));
        settled.push(one.settled);
    }
    let all = growths(task, job, dynamics, &settled, &cycles)?;
    for ((index, row), all) in (1..).zip(&mut found.attractors).zip(all) {
        row.impacts_per_period = match (row.period, row.impacts) {
            (Some(period), Some(impacts)) => impacts as f64 / period as f64,
            _ => all.first().map_or(0.0, |first| first.impacts as f64 / f64::from(task.points)),
        };
        if let Some(first) = all.first() {
            (row.lyapunov_per_period, row.standard_error) = (first.per_period, first.standard_error);
        }
        if task.exponents > 1 {
            found.exponents.extend((1..).zip(&all).map(|(exponent, one)| ExponentRow {
                attractor: index,
                exponent,
                per_period: one.per_period,
                standard_error: one.standard_error,
            }));
        }
    }
    Ok((found, cycles, settled))
}

/// What is seen of the motions from the starts, by all threads.
fn observed<D: Attraction>(
    task: &SectionTask,
    job: &Job,
    dynamics: &D,
    starts: &[D::Start],
) -> Result<Vec<ObservedMotion<D::Start, D::Point>>> {
    job.monitor.begin(starts.len() as u64, "motions");
    let together = starts.len().div_ceil(rayon::current_num_threads()).clamp(1, D::TOGETHER);
    let observe = |starts: &[D::Start]| {
        let runs = starts.iter().map(|start| Ok((dynamics, dynamics.begin(start)?)));
        let outcomes = D::observe(runs.collect::<Result<_>>()?, &observation(task), job.monitor)?;
        job.monitor.advance(starts.len() as u64)?;
        Ok(outcomes)
    };
    let all: Vec<Vec<_>> = starts.par_chunks(together).map(observe).collect::<Result<_>>()?;
    Ok(all.into_iter().flatten().collect())
}

/// The exponents of the attractors on which motions settled at these places: of a periodic one those of its
/// multipliers, where they are known.
fn growths<D: Attraction>(
    task: &SectionTask,
    job: &Job,
    dynamics: &D,
    settled: &[D::Start],
    cycles: &[(usize, Cycle<D::Point>)],
) -> Result<Vec<Vec<Growth>>> {
    job.monitor.begin(settled.len() as u64, "exponents");
    let count = (task.exponents as usize).min(dynamics.dimension());
    let known = |index: usize| cycles.iter().find(|(place, _)| *place == index).map(|(_, cycle)| cycle);
    let of = |(index, start): (usize, &D::Start)| {
        let exact = known(index).map(Cycle::exponents).filter(|all| !all.is_empty());
        let all = match exact {
            Some(all) => all.into_iter().take(count).map(Growth::exact).collect(),
            None => {
                let all = exponents(dynamics, start, count, 0, task.points.into(), job.monitor)?;
                all.iter().map(Growth::mean).collect()
            }
        };
        job.monitor.advance(1)?;
        Ok(all)
    };
    settled.par_iter().enumerate().map(of).collect()
}

/// An exponent times the forcing period, with its standard error if it is a mean.
struct Growth {
    per_period: Option<f64>,
    standard_error: Option<f64>,
    impacts: u64,
}

impl Growth {
    fn exact(exponent: f64) -> Growth {
        Growth { per_period: Some(exponent).filter(|x| x.is_finite()), standard_error: None, impacts: 0 }
    }

    fn mean(exponent: &Exponent) -> Growth {
        let finite = |x: f64| Some(TAU * x).filter(|x| x.is_finite());
        let (rate, error) = (exponent.rate, exponent.standard_error);
        Growth { per_period: finite(rate), standard_error: finite(error), impacts: exponent.impacts }
    }
}

/// What is looked at of each motion.
fn observation(task: &SectionTask) -> Observation {
    Observation {
        phase: phase(&task.phase),
        transient: task.transient + 1,
        longest: task.longest,
        points: task.points,
        round: false,
        every: 1,
    }
}
