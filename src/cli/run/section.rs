//! Tasks of kind `section`: the stroboscopic section of attractors and of chosen orbits.

use std::f64::consts::TAU;

use rayon::prelude::*;

use super::{
    Job, Report, ended,
    report::{Rows, number},
    settings,
};
use crate::{
    cli::progress::Progress,
    error::Result,
    figure::{self, Mark, Points},
    monitor::Monitor,
    oscillator::{
        Contact, Side, Time,
        attractor::{
            detection::{Detection, Fate},
            lyapunov::lyapunov,
            section::section,
            touching,
        },
        flow::State,
        orbit::Oscillator,
        simulate::{End, Simulator},
    },
    scene::{Section, phase},
};

/// Points of the section nearer than this are one, when orbits are compared with attractors.
const NEAR: f64 = 1e-4;

/// What a motion came to after the transient.
struct Seen {
    fate: Fate,
    /// Its points (q, u), for a periodic motion once round.
    points: Vec<[f64; 2]>,
    /// Impacts, and the Lyapunov exponent, in a forcing period.
    impacts: f64,
    exponent: f64,
}

pub(super) fn run(task: &Section, job: &Job, report: &mut Report) -> Result<()> {
    let simulator = Simulator::new(&job.system, &settings(&job.scene))?;
    let phase = phase(&task.phase);
    let starts = task.starts.iter().map(|start| job.scene.state(start)).collect::<Result<Vec<State>>>()?;
    let progress = Progress::new(job.interrupt, starts.len() as u64 * task.transient, "periods");
    let seen: Vec<Seen> = starts
        .into_par_iter()
        .map(|start| look(task, &simulator, start, phase, &progress))
        .collect::<Result<_>>()?;
    let mut attractors: Vec<&Seen> = Vec::new();
    for one in &seen {
        let same = |other: &&Seen| match (&other.fate, &one.fate) {
            (Fate::Periodic(a), Fate::Periodic(b)) => a.is(b, NEAR),
            _ => false,
        };
        if !one.points.is_empty() && !attractors.iter().any(same) {
            attractors.push(one);
        }
    }
    let orbits = orbits(task, job, &attractors, phase)?;

    let walls: Vec<Contact> = simulator.contacts().cloned().collect();
    let frame = Frame { wall: walls.iter().find(|wall| Some(wall.side) == task.frame.side()), phase };
    let mut sets: Vec<Points> = Vec::new();
    for wall in walls.iter().filter(|_| task.grazing_curve) {
        for piece in touching(simulator.flow(), &walls, wall, phase) {
            let name = format!("where the next period grazes the {} wall", wall.side.name());
            let piece: Vec<[f64; 2]> = piece.iter().map(|state| [state.q, state.u]).collect();
            sets.push(frame.points(name, Mark::Curve, &piece));
        }
    }
    for one in &attractors {
        let (mark, name) = describe(&one.fate);
        sets.push(frame.points(name, mark, &one.points));
    }
    for (pattern, stable, points) in &orbits {
        // A stable one is there already, unless no start led to it.
        let (mark, kind) = if *stable { (Mark::Ring, "stable") } else { (Mark::Star, "unstable") };
        sets.push(frame.points(format!("{kind}, impact pattern ({pattern})"), mark, points));
    }
    figure::section(&sets, frame.axes(), job.folder, &job.task.name)?;

    let mut rows = Rows::new(&["attractor", "impacts_per_period", "lyapunov_per_period"]);
    for one in &attractors {
        let exponent = if one.exponent.is_finite() { number(one.exponent) } else { "-inf".into() };
        rows.push([describe(&one.fate).1.into(), number(one.impacts), exponent]);
    }
    report.table("attractors", rows);
    if !task.orbits.is_empty() {
        let mut rows = Rows::new(&["pattern", "stable"]);
        for (pattern, stable, _) in &orbits {
            rows.push([pattern.as_str().into(), (*stable).into()]);
        }
        report.table("further_orbits", rows);
    }
    for one in &seen {
        if let Fate::Ended(end) = one.fate {
            report.say("ended", ended(end));
        }
    }
    report.say("files", ["svg", "csv"].map(|end| format!("{}.{end}", job.task.name)).to_vec());
    Ok(())
}

/// Follows one motion.
fn look(
    task: &Section,
    simulator: &Simulator,
    start: State,
    phase: f64,
    progress: &Progress,
) -> Result<Seen> {
    let mut run = simulator.start(Time::new(0, start.t), start.q, start.u)?;
    let over = |end| Seen { fate: Fate::Ended(end), points: Vec::new(), impacts: 0.0, exponent: 0.0 };
    let mut left = task.transient + 1;
    while left > 0 {
        let count = left.min(1000);
        let end = section(&mut run, phase, count, |_| true);
        if end != End::Reached {
            return Ok(over(end));
        }
        progress.advance(count)?;
        left -= count;
    }
    let (time, state) = (run.time(), run.state());
    let detection = Detection { phase, transient: 0, longest: task.longest as usize, ..Detection::default() };
    let fate = detection.detect(&mut run)?;
    let mut points = Vec::new();
    let end = match &fate {
        Fate::Periodic(cycle) => {
            points.clone_from(&cycle.points);
            End::Reached
        }
        Fate::Irregular => section(&mut run, phase, task.points.into(), |point| {
            points.push([point.q, point.u]);
            true
        }),
        Fate::Ended(end) => *end,
    };
    if end != End::Reached {
        return Ok(over(end));
    }
    let exponent = lyapunov(simulator, time, [state.q, state.u], 0, task.points.into())?;
    let impacts = match &fate {
        Fate::Periodic(cycle) => cycle.impacts as f64 / cycle.period() as f64,
        _ => exponent.impacts as f64 / f64::from(task.points),
    };
    Ok(Seen { fate, points, impacts, exponent: TAU * exponent.rate })
}

fn describe(fate: &Fate) -> (Mark, String) {
    match fate {
        Fate::Periodic(cycle) => {
            let (n, impacts) = (cycle.period(), cycle.impacts);
            let mark = if impacts == 0 { Mark::Square } else { Mark::Ring };
            let plural = if impacts == 1 { "" } else { "s" };
            (mark, format!("stable, period {n} with {impacts} impact{plural}"))
        }
        _ => (Mark::Dot, "attractor, not periodic".to_string()),
    }
}

/// From where states are counted.
struct Frame<'a> {
    wall: Option<&'a Contact>,
    phase: f64,
}

impl Frame<'_> {
    fn points(&self, name: String, mark: Mark, states: &[[f64; 2]]) -> Points {
        let (q0, u0) = self.wall.map_or((0.0, 0.0), |wall| {
            let [q, u, _] = wall.position.at(self.phase);
            (q - wall.position.mean(), u)
        });
        Points { name, mark, at: states.iter().map(|[q, u]| (q - q0, u - u0)).collect() }
    }

    fn axes(&self) -> [&'static str; 2] {
        match self.wall.map(|wall| wall.side) {
            None => ["q", "u"],
            Some(Side::Lower) => ["q − (Q₁ − offset)", "u − Q₁′"],
            Some(Side::Upper) => ["q − (Q₂ − offset)", "u − Q₂′"],
        }
    }
}

/// Pattern, whether stable, points (q, u) of the section.
type Found = (String, bool, Vec<[f64; 2]>);

/// The admissible ones of the task's orbits that are no attractor found.
fn orbits(task: &Section, job: &Job, attractors: &[&Seen], phase: f64) -> Result<Vec<Found>> {
    let oscillator = Oscillator::new(job.system.clone(), job.scene.accuracy.tolerance)?;
    let mut all = Vec::new();
    for keys in &task.orbits {
        job.interrupt.check()?;
        for orbit in keys.orbits(&oscillator)? {
            let point = |i: u32| {
                let state = orbit.state(&oscillator, phase + TAU * f64::from(i))?;
                Ok([state.q, state.u])
            };
            let points = (0..orbit.itinerary.periods()).map(point).collect::<Result<Vec<_>>>()?;
            let near = |a: &[f64; 2]| (a[0] - points[0][0]).abs() + (a[1] - points[0][1]).abs() < NEAR;
            let known = |one: &&Seen| matches!(one.fate, Fate::Periodic(_)) && one.points.iter().any(near);
            if orbit.admissibility.is_admissible() && !attractors.iter().any(known) {
                all.push((orbit.itinerary.to_string(), orbit.multipliers.is_stable(), points));
            }
        }
    }
    Ok(all)
}
