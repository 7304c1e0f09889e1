//! The files of tasks of kind `section`.

use super::Job;
use crate::{
    error::Result,
    figure::{self, Mark, Points},
    motion::{Contact, Side},
    run::{AttractorRow, Model, SectionFindings, SectionSet},
    scene::{SectionTask, phase},
};

pub(super) fn keep(found: &SectionFindings, task: &SectionTask, job: &Job) -> Result<Vec<String>> {
    let walls = match &job.model {
        Model::Oscillator(system) => Contact::of(system)?,
        Model::Machine(_) => Vec::new(),
    };
    let frame = Frame {
        wall: walls.iter().find(|wall| Some(wall.side) == task.frame.side()),
        phase: phase(&task.phase),
    };
    let mut sets: Vec<Points> = Vec::new();
    for (wall, piece) in &found.grazing_curve {
        let name = format!("where the next period grazes the {} stop", wall.side.name());
        sets.push(frame.points(name, Mark::Curve, piece));
    }
    for (stable, piece) in &found.manifolds {
        let (mark, name) = match stable {
            true => (Mark::StableCurve, "stable manifold"),
            false => (Mark::UnstableCurve, "unstable manifold"),
        };
        sets.push(frame.points(name.to_string(), mark, piece));
    }
    let periodic = found.attractors.iter().filter(|attractor| attractor.periodic == Some(true)).count();
    let alone = periodic + found.further_orbits.len() == 1;
    for (set, points) in &found.points {
        let (mark, name) = match set {
            SectionSet::Attractor(index) => describe(&found.attractors[*index]),
            SectionSet::Orbit(index) => {
                let orbit = &found.further_orbits[*index];
                // A stable one is there already, unless no start led to it. Stars tell orbits apart: alone,
                // one has rings.
                let (mark, kind) = match orbit.stable {
                    true => (Mark::Ring, "stable"),
                    false if alone => (Mark::UnstableRing, "unstable"),
                    false => (Mark::Star, "unstable"),
                };
                (mark, format!("{kind}, impact pattern ({})", orbit.pattern))
            }
        };
        sets.push(frame.points(name, mark, points));
    }
    match &found.plane {
        Some([x, y]) => figure::section(&sets, [x, y], &job.place())?,
        None => figure::section(&sets, frame.axes(), &job.place())?,
    }
    Ok(job.figure())
}

fn describe(attractor: &AttractorRow) -> (Mark, String) {
    if attractor.periodic.is_none() {
        return (Mark::Dot, "not settled".to_string());
    }
    let (Some(n), Some(impacts)) = (attractor.period, attractor.impacts) else {
        return (Mark::Dot, "attractor, not periodic".to_string());
    };
    let mark = if impacts == 0 { Mark::Square } else { Mark::Ring };
    let plural = if impacts == 1 { "" } else { "s" };
    (mark, format!("stable, period {n} with {impacts} impact{plural}"))
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
