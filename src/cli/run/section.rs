//! Tasks of kind `section`: the stroboscopic section of attractors and of chosen orbits.

use std::f64::consts::TAU;

use rayon::prelude::*;

use super::{
    Job, Report,
    report::{Rows, number},
    settings,
};
use crate::{
    error::Result,
    monitor::Monitor,
    oscillator::{
        Attractor, Contact, Look, Side,
        flow::State,
        orbit::Oscillator,
        scene::{Section, phase},
        simulate::{End, Simulator},
        touching,
    },
    output::{
        Progress,
        figure::{self, Mark, Points},
    },
};

pub(super) fn run(task: &Section, job: &Job, report: &mut Report) -> Result<()> {
    let simulator = Simulator::new(&job.system, &settings(&job.scene))?;
    let look = Look {
        phase: phase(&task.phase),
        transient: task.transient,
        points: task.points,
        longest: task.longest,
    };
    let starts = task.starts.iter().map(|start| job.scene.state(start)).collect::<Result<Vec<State>>>()?;
    let progress = Progress::new(
        job.interrupt,
        starts.len() as u64 * (task.transient + u64::from(task.points)),
        "periods",
    );
    let found: Vec<Attractor> = starts
        .par_iter()
        .map(|&start| Attractor::of(&simulator, start, &look, || progress.advance(1)))
        .collect::<Result<_>>()?;
    let mut attractors: Vec<&Attractor> = Vec::new();
    for attractor in &found {
        if attractor.end == End::Reached && !attractors.iter().any(|other| other.is(attractor)) {
            attractors.push(attractor);
        }
    }
    let walls: Vec<Contact> = simulator.contacts().cloned().collect();
    let frame = Frame { wall: walls.iter().find(|wall| Some(wall.side) == task.frame.side()) };
    let mut sets: Vec<Points> = Vec::new();
    for wall in walls.iter().filter(|_| task.grazing_curve) {
        for piece in touching(simulator.flow(), &walls, wall, look.phase) {
            let name = format!("where the next period grazes the {} wall", wall.side.name());
            sets.push(frame.points(name, Mark::Curve, &piece));
        }
    }
    for attractor in &attractors {
        let (mark, name) = match (attractor.period, attractor.impacts) {
            (Some(n), 0) => (Mark::Square, format!("stable, period {n} without impacts")),
            (Some(n), 1) => (Mark::Ring, format!("stable, period {n} with 1 impact")),
            (Some(n), impacts) => (Mark::Ring, format!("stable, period {n} with {impacts} impacts")),
            (None, _) => (Mark::Dot, "attractor, not periodic".to_string()),
        };
        sets.push(frame.points(name, mark, &attractor.points));
    }
    let orbits = orbits(task, job, &attractors, look.phase)?;
    for (pattern, stable, points) in &orbits {
        // A stable one is there already, unless no start led to it.
        let (mark, kind) = if *stable { (Mark::Ring, "stable") } else { (Mark::Star, "unstable") };
        sets.push(frame.points(format!("{kind}, impact pattern ({pattern})"), mark, points));
    }
    figure::section(&sets, frame.axes(), job.folder, &job.task.name)?;

    let mut rows = Rows::new(&["period", "impacts", "rests", "impacts_per_period", "lyapunov"]);
    for attractor in &attractors {
        let length = attractor.period.unwrap_or(task.points - 1);
        rows.push([
            attractor.period.into(),
            attractor.impacts.into(),
            attractor.rests.into(),
            number(attractor.impacts as f64 / f64::from(length)),
            if attractor.lyapunov.is_finite() { number(attractor.lyapunov) } else { "-inf".into() },
        ]);
    }
    report.table("attractors", rows);
    if !task.orbits.is_empty() {
        let mut rows = Rows::new(&["pattern", "stable"]);
        for (pattern, stable, _) in &orbits {
            rows.push([pattern.as_str().into(), (*stable).into()]);
        }
        report.table("further_orbits", rows);
    }
    for attractor in found.iter().filter(|attractor| attractor.end != End::Reached) {
        report.say("ended", super::ended(attractor.end));
    }
    report.say("files", ["svg", "csv"].map(|end| format!("{}.{end}", job.task.name)).to_vec());
    Ok(())
}

/// From where states are counted.
struct Frame<'a> {
    wall: Option<&'a Contact>,
}

impl Frame<'_> {
    fn points(&self, name: String, mark: Mark, states: &[State]) -> Points {
        let place = |state: &State| match self.wall {
            Some(wall) => {
                let [q, u, _] = wall.position.at(state.t);
                (state.q - (q - wall.position.mean()), state.u - u)
            }
            None => (state.q, state.u),
        };
        Points { name, mark, at: states.iter().map(place).collect() }
    }

    fn axes(&self) -> [&'static str; 2] {
        match self.wall.map(|wall| wall.side) {
            None => ["q", "u"],
            Some(Side::Lower) => ["q − (Q₁ − offset)", "u − Q₁′"],
            Some(Side::Upper) => ["q − (Q₂ − offset)", "u − Q₂′"],
        }
    }
}

/// The admissible ones of the task's orbits that are no attractor found: pattern, whether stable, states at the phase.
fn orbits(
    task: &Section,
    job: &Job,
    attractors: &[&Attractor],
    phase: f64,
) -> Result<Vec<(String, bool, Vec<State>)>> {
    let oscillator = Oscillator::new(job.system.clone(), job.scene.accuracy.tolerance)?;
    let mut all = Vec::new();
    for keys in &task.orbits {
        job.interrupt.check()?;
        for orbit in keys.orbits(&oscillator)? {
            let itinerary = &orbit.itinerary;
            let times = (0..itinerary.periods()).map(|i| phase + TAU * f64::from(i));
            let points = times
                .map(|t| Ok(State { t: phase, ..orbit.state(&oscillator, t)? }))
                .collect::<Result<Vec<_>>>()?;
            let known = attractors.iter().any(|attractor| attractor.goes_through(&points[0]));
            if orbit.admissibility.is_admissible() && !known {
                all.push((itinerary.to_string(), orbit.multipliers.is_stable(), points));
            }
        }
    }
    Ok(all)
}
