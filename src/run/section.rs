//! Tasks of kind `section`: the stroboscopic section of attractors and of chosen orbits.

use std::f64::consts::TAU;

use rayon::prelude::*;
use serde::Serialize;

use super::{
    Finding, Job, Judgement, Lines, Model, Status,
    engine::{JudgedOrbit, machine_orbits},
    row, small_motion,
};
use crate::{
    attractor::{
        cycle::Cycle,
        dynamics::{Dynamics, SectionState},
        lyapunov::{Exponent, exponents},
        observe::{Attraction, Observation, ObservedMotion},
        section::section as follow,
    },
    error::{Error, Result},
    many::{Machine, simulate::MachineSimulator},
    motion::{Contact, RunEnd, State},
    one::{
        attractor::{
            manifold::{ManifoldPlan, reversed, reversed_phase, unstable_manifold},
            touching,
        },
        simulate::Simulator,
    },
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
    /// Of a machine, what the two numbers are by which points are drawn, as in the scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub plane: Option<[String; 2]>,
    /// The admissible orbits of the patterns asked for that are no attractors of the list.
    pub further_orbits: Vec<SectionOrbitRow>,
    /// Why motions of other starts ended, a start each.
    pub ended: Vec<RunEnd>,
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
    notes: Vec<String>,
}

impl Finding for SectionFindings {
    fn status(&self) -> Status {
        if self.attractors.is_empty() && self.further_orbits.is_empty() {
            return Status::nothing("no start leads to an attractor: every motion left all bounds");
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
pub fn section(task: &SectionTask, job: &Job) -> Result<SectionFindings> {
    match &job.model {
        Model::Oscillator(_) => of_oscillator(task, job),
        Model::Machine(machine) => of_machine(task, machine, job),
    }
}

/// The attractors that motions from the starts lead to, and of the periodic ones their place in the list and
/// their points.
#[expect(clippy::type_complexity, reason = "both parts are named where they are taken apart")]
fn attractors<D: Attraction>(
    task: &SectionTask,
    job: &Job,
    dynamics: &D,
    starts: Vec<D::Start>,
) -> Result<(SectionFindings, Vec<(usize, Cycle<D::Point>)>)> {
    let observed = observed(task, job, dynamics, &starts)?;
    let mut found = SectionFindings {
        attractors: Vec::new(),
        exponents: Vec::new(),
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
    // Where the exponents of each attractor are followed from.
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
            lyapunov_per_period: None,
            standard_error: None,
            starts: 1,
        };
        found.attractors.push(row);
        let points = match &one.cycle {
            Some(cycle) => cycle.points.iter().map(SectionState::plane).collect(),
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
    Ok((found, cycles))
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
fn growths<D: Dynamics>(
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

fn of_machine(task: &SectionTask, machine: &Machine<f64>, job: &Job) -> Result<SectionFindings> {
    let states = task.starts.iter().map(|start| job.scene.machine_state(start, machine, "starts"));
    let states = states.collect::<Result<Vec<_>>>()?;
    let planar = job.planar(machine, &states, &task.plane)?;
    let starts = states.iter().map(|state| state.start(machine.rate())).collect();
    let (mut found, cycles) = attractors(task, job, &planar, starts)?;
    let simulator = planar.simulator();
    found.plane = Some(job.scene.plane_names(&task.plane));
    (found.minimum_depth, found.size) = (simulator.settings().minimum_depth, Some(gap_size(simulator)));
    for keys in &task.orbits {
        job.check()?;
        for orbit in machine_orbits(keys, machine, simulator, job)? {
            if orbit.admissible(None).0 == Judgement::No {
                continue;
            }
            let start = orbit.state.start(machine.rate());
            let mut run = planar.begin(&start)?;
            let (mut points, mut first) = (Vec::new(), None);
            let end = follow(&mut run, phase(&task.phase), orbit.pattern.periods().into(), |point| {
                points.push(point.at.plane());
                first.get_or_insert(point.at);
                true
            })?;
            let stable = orbit.stable(None) == Judgement::Yes;
            let shown = |point| cycles.iter().any(|(_, cycle)| cycle.passes(point));
            if end != RunEnd::Reached || first.as_ref().is_some_and(shown) {
                continue;
            }
            found.points.push((SectionSet::Orbit(found.further_orbits.len()), points));
            let pattern = orbit.pattern.named(simulator.contacts().all());
            found.further_orbits.push(SectionOrbitRow { pattern, stable });
        }
    }
    Ok(found)
}

/// What the minimum depth is to be small against: the size of the gap to the nearest stop; without stops it
/// decides nothing.
pub(super) fn gap_size(simulator: &MachineSimulator) -> f64 {
    if simulator.contacts().all().is_empty() { f64::INFINITY } else { simulator.gap_scale() }
}

fn of_oscillator(task: &SectionTask, job: &Job) -> Result<SectionFindings> {
    let simulator = job.simulator()?;
    let phase = phase(&task.phase);
    let starts = task.starts.iter().map(|start| job.scene.state(start)).collect::<Result<Vec<State>>>()?;
    let (mut found, cycles) = attractors(task, job, &simulator, starts)?;
    found.minimum_depth = simulator.settings().minimum_depth;
    let oscillator = job.oscillator(job.system()?.clone())?;
    for keys in &task.orbits {
        job.check()?;
        for orbit in keys.orbits(&oscillator)?.iter().filter(|orbit| orbit.admissibility.is_admissible()) {
            let point = |i: u32| {
                let state = orbit.state(&oscillator, phase + TAU * f64::from(i))?;
                Ok([state.q, state.u])
            };
            let points = (0..orbit.itinerary.periods()).map(point).collect::<Result<Vec<_>>>()?;
            if cycles.iter().any(|(_, cycle)| cycle.passes(&points[0])) {
                continue;
            }
            if task.manifolds && !orbit.multipliers.is_stable() {
                let plan = ManifoldPlan::default().sized(orbit.unit);
                manifolds(job, &simulator, (phase, &plan), &points, &mut found)?;
            }
            found.points.push((SectionSet::Orbit(found.further_orbits.len()), points));
            found.further_orbits.push(SectionOrbitRow {
                pattern: orbit.itinerary.to_string(),
                stable: orbit.multipliers.is_stable(),
            });
        }
    }
    let walls: Vec<Contact> = simulator.contacts().cloned().collect();
    for wall in walls.iter().filter(|_| task.grazing_curve) {
        for piece in touching(simulator.flow(), &walls, wall, phase) {
            let piece = piece.iter().map(|state| [state.q, state.u]).collect();
            found.grazing_curve.push((wall.clone(), piece));
        }
    }
    Ok(found)
}

/// Adds the manifolds of an unstable orbit with these points, or why there are none.
fn manifolds(
    job: &Job,
    simulator: &Simulator,
    (phase, plan): (f64, &ManifoldPlan),
    points: &[[f64; 2]],
    found: &mut SectionFindings,
) -> Result<()> {
    let back = reversed(job.system()?).and_then(|system| job.simulator_of(&system));
    let periods = points.len() as u32;
    for &[q, u] in points {
        let unstable = unstable_manifold(simulator, phase, periods, [q, u], plan, job.monitor);
        let stable = match &back {
            Ok(back) => {
                let phase = reversed_phase(phase);
                unstable_manifold(back, phase, periods, [q, -u], plan, job.monitor)
            }
            Err(error) => Err(Error::input(error.to_string())),
        };
        for (is_stable, pieces) in [(false, unstable), (true, stable)] {
            match pieces {
                Ok(pieces) => {
                    let turned = |piece: Vec<[f64; 2]>| -> Vec<[f64; 2]> {
                        piece.into_iter().map(|[q, u]| [q, if is_stable { -u } else { u }]).collect()
                    };
                    found.manifolds.extend(pieces.into_iter().map(|piece| (is_stable, turned(piece))));
                }
                Err(error) if error.is_interrupted() => return Err(error),
                Err(error) => {
                    let which = if is_stable { "stable" } else { "unstable" };
                    let note = format!("no {which} manifold is drawn: {error}");
                    if !found.notes.contains(&note) {
                        found.notes.push(note);
                    }
                }
            }
        }
    }
    Ok(())
}

/// What is looked at of each motion.
fn observation(task: &SectionTask) -> Observation {
    Observation {
        phase: phase(&task.phase),
        transient: task.transient + 1,
        longest: task.longest,
        points: task.points,
        round: None,
        every: 1,
    }
}
