//! Tasks of kind `section`: the stroboscopic section of attractors and of chosen orbits.

use std::f64::consts::TAU;

use rayon::prelude::*;

use super::{Job, Report, settings};
use crate::{
    error::Result,
    monitor::Monitor,
    oscillator::{
        Attractor, Contact, Look, Side,
        flow::State,
        orbit::{self, Itinerary, Oscillator},
        scene::{Section, phase},
        simulate::{End, Simulator},
        touching,
    },
    output::{
        Progress,
        figure::{self, Mark, Points},
    },
};

/// Starts of Newton's method when orbits of a pattern are looked for.
const SEARCHES: u32 = 200;

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
        let name = format!("unstable, impact pattern ({pattern})");
        // A stable one is there already, unless no start led to it.
        let mark = if *stable { Mark::Ring } else { Mark::Star };
        let name = if *stable { name.replace("unstable", "stable") } else { name };
        sets.push(frame.points(name, mark, points));
    }
    figure::section(&sets, frame.axes(), job.folder, &job.task.name)?;

    let lyapunov = |x: f64| if x == f64::NEG_INFINITY { serde_json::json!("-inf") } else { x.into() };
    let one = |attractor: &&Attractor| {
        serde_json::json!({
            "period": attractor.period,
            "impacts": attractor.impacts,
            "rests": attractor.rests,
            "impacts_per_period": attractor.impacts as f64 / attractor.period.unwrap_or(task.points - 1) as f64,
            "lyapunov": lyapunov(attractor.lyapunov),
        })
    };
    report.say("attractors", attractors.iter().map(one).collect::<Vec<_>>());
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
            Some(Side::Lower) => ["q from the lower wall\u{2019}s motion", "velocity from it"],
            Some(Side::Upper) => ["q from the upper wall\u{2019}s motion", "velocity from it"],
        }
    }
}

/// The admissible orbits of the task's patterns that are no attractor found: pattern, whether stable, states at the phase.
fn orbits(
    task: &Section,
    job: &Job,
    attractors: &[&Attractor],
    phase: f64,
) -> Result<Vec<(String, bool, Vec<State>)>> {
    if task.patterns.is_empty() {
        return Ok(Vec::new());
    }
    let oscillator = Oscillator::new(job.system.clone(), job.scene.accuracy.tolerance)?;
    let side = if job.system.lower.is_some() { Side::Lower } else { Side::Upper };
    let fastest =
        attractors.iter().flat_map(|a| &a.points).fold(1.0, |most: f64, state| most.max(state.u.abs()));
    let mut all = Vec::new();
    for pattern in &task.patterns {
        let itinerary = if pattern.is_empty() { Itinerary::free(1)? } else { Itinerary::at(side, pattern)? };
        job.interrupt.check()?;
        for orbit in orbit::search(&oscillator, &itinerary, SEARCHES, 2.0 * fastest) {
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
