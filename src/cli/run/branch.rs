//! Tasks of kind `branch`: continuation of periodic orbits.

use std::{f64::consts::TAU, fs};

use num_rational::BigRational;
use serde_json::Value;

use super::{
    Job, Report,
    orbit::{admissible, complex, yes},
    report::{Rows, number, numbers},
};
use crate::{
    error::{Error, Result},
    figure,
    number::{Plain, Real},
    oscillator::{
        attractor::{attracting, detection::Detection},
        branch::{Branch, Direction, Event, Events, Label, Options, Orbits, read_label, record},
        orbit::{Family, Orbit, Oscillator},
    },
    output::write_file,
    scene::{
        Frame, SceneFamily,
        branches::{BranchStart, BranchTask, Restart, Way},
        phase,
    },
};

pub(super) fn run(task: &BranchTask, job: &Job, report: &mut Report) -> Result<()> {
    let direction = match task.direction {
        Way::Both => Direction::Both,
        Way::Up => Direction::Forward,
        Way::Down => Direction::Backward,
    };
    let family = SceneFamily::new(&job.scene, &task.parameter)?;
    let range = (task.range[0], task.range[1]);
    let found = match &task.second {
        Some(second) => events(task, second, direction, job)?,
        None => follow(&task.starts, &family, range, direction, &task.options, job)?,
    };
    let names: Vec<&str> = [task.parameter.as_str()].into_iter().chain(task.second.as_deref()).collect();
    let mut files = Vec::new();
    for (i, branch) in (1..).zip(&found) {
        let file = if found.len() == 1 {
            format!("{}.json", job.task.name)
        } else {
            format!("{}-{i}.json", job.task.name)
        };
        let text = serde_json::to_string_pretty(&record(branch, &names)).map_err(std::io::Error::other)?;
        write_file(&job.folder.join(&file), |out| Ok(writeln!(out, "{text}")?))?;
        files.push(file);
    }
    if task.second.is_none() {
        let drawing = Drawing { family: &family, phase: phase(&task.phase), frame: task.frame };
        let curves = found.iter().map(|branch| drawing.curve(branch)).collect::<Result<Vec<_>>>()?;
        figure::branches(&curves, &[], [&task.parameter, drawing.axis()], job.folder, &job.task.name)?;
        files.extend(["svg", "csv"].map(|end| format!("{}.{end}", job.task.name)));
    }
    let mut rows = Rows::new(COLUMNS);
    let mut events = Rows::new(COLUMNS);
    let mut ends = Vec::new();
    for (i, branch) in (1..).zip(&found) {
        let labels = branch.labels();
        for point in &branch.points {
            let label = labels.iter().find(|(_, known)| std::ptr::eq(*known, point)).map(|(label, _)| label);
            let row = row(i, label, &point.parameters, &point.orbit, point.length);
            if label.is_some() {
                events.push(row.clone());
            }
            rows.push(row);
        }
        ends.push(format!("branch {i}: {} and {}", branch.ends[0], branch.ends[1]));
    }
    files.push(format!("{}-points.csv", job.task.name));
    report.say("points", found.iter().map(|branch| branch.points.len()).sum::<usize>());
    report.say("ends", ends);
    report.undecided |= found.is_empty();
    rows.save(job, "-points.csv")?;
    report.table("labels", events);
    report.say("files", files);
    Ok(())
}

const COLUMNS: &[&str] = &[
    "branch",
    "label",
    "parameters",
    "pattern",
    "phases",
    "speeds",
    "lambda1",
    "lambda2",
    "stable",
    "admissible",
    "least_gap",
    "residual",
    "newton_steps",
    "length",
];

fn row(branch: u32, label: Option<&String>, parameters: &[f64], orbit: &Orbit, length: f64) -> [Value; 14] {
    let [first, second] = orbit.multipliers.values().map(complex);
    [
        branch.into(),
        label.map_or("", String::as_str).into(),
        numbers(parameters.iter().copied()),
        orbit.itinerary.to_string().into(),
        numbers(orbit.impacts().map(|impact| impact.phase)),
        numbers(orbit.impacts().map(|impact| impact.speed)),
        first,
        second,
        yes(orbit.multipliers.is_stable()).into(),
        admissible(&orbit.admissibility).into(),
        orbit.least.map_or("none".into(), |least| number(least.gap)),
        number(orbit.residual),
        orbit.steps.into(),
        number(length),
    ]
}

/// The branches of some starts; an orbit that lies on a branch already followed starts none.
pub(super) fn follow(
    starts: &[BranchStart],
    family: &SceneFamily,
    range: (f64, f64),
    direction: Direction,
    options: &Options,
    job: &Job,
) -> Result<Vec<Branch>> {
    let options = options.checked()?;
    let mut found: Vec<Branch> = Vec::new();
    for start in starts {
        job.interrupt.check()?;
        if let Some(restart) = &start.restart {
            let label = label(restart, job)?;
            let orbits = Orbits { family, itinerary: label.itinerary.clone(), range };
            let foot = orbits.restart(&label, &options)?;
            found.push(if restart.switch {
                let (born, foot) = orbits.switch(label.event, &foot)?;
                let direction = if label.event == Event::Flip { Direction::Forward } else { direction };
                Branch::follow(&born, &foot, direction, &options)?
            } else {
                Branch::follow(&orbits, &foot, direction, &options)?
            });
            continue;
        }
        let at = start.at.as_ref().map_or(family.value(), float);
        for orbit in orbits_at(start, &family.at(at)?, job)? {
            if found.iter().any(|branch| branch.passes(&orbit, at)) {
                continue;
            }
            let orbits = Orbits { family, itinerary: orbit.itinerary.clone(), range };
            let foot = orbits.start(orbit.z, at, &options)?;
            found.push(Branch::follow(&orbits, &foot, direction, &options)?);
        }
    }
    Ok(found)
}

fn float(value: &BigRational) -> f64 {
    Plain::ratio(value, &()).0
}

/// The admissible orbits that a start means.
fn orbits_at(start: &BranchStart, oscillator: &Oscillator, job: &Job) -> Result<Vec<Orbit>> {
    if let Some(state) = &start.attractor {
        let from = job.scene.state(state)?;
        let detection = Detection { phase: from.t, transient: 10_000, longest: 200, ..Detection::default() };
        return Ok(vec![attracting(oscillator, from, &detection, &job.settings())?]);
    }
    let Some(keys) = &start.orbit else { return Ok(Vec::new()) };
    let mut orbits = keys.orbits(oscillator)?;
    orbits.retain(|orbit| orbit.admissibility.is_admissible());
    Ok(orbits)
}

fn label(restart: &Restart, job: &Job) -> Result<Label> {
    let file = job.folder.join(&restart.file);
    let text = fs::read_to_string(&file).map_err(|error| Error::io("read", &file, error))?;
    read_label(&text, &restart.label).map_err(|error| error.context(file.display()))
}

/// The labels of the restarts, followed in two parameters.
fn events(task: &BranchTask, second: &str, direction: Direction, job: &Job) -> Result<Vec<Branch>> {
    let options = task.options.checked()?;
    let plane = |[first, other]: [f64; 2]| {
        let system = job.scene.plain(&[(&task.parameter, first), (second, other)])?;
        Oscillator::new(system, job.scene.accuracy.tolerance)
    };
    let value = SceneFamily::new(&job.scene, second)?.value();
    let mut found = Vec::new();
    for restart in task.starts.iter().filter_map(|start| start.restart.as_ref()) {
        let label = label(restart, job)?;
        let ranges = [(task.range[0], task.range[1]), (task.second_range[0], task.second_range[1])];
        let events = Events { plane: &plane, itinerary: label.itinerary.clone(), event: label.event, ranges };
        let parameters = [label.parameters[0], *label.parameters.get(1).unwrap_or(&value)];
        let foot = events.start(&label.z, parameters, &options)?;
        found.push(Branch::follow(&events, &foot, direction, &options)?);
    }
    Ok(found)
}

/// What of an orbit is drawn: its displacement when `phase` comes first after its first impact.
pub(super) struct Drawing<'a> {
    pub family: &'a SceneFamily<'a>,
    pub phase: f64,
    pub frame: Frame,
}

impl Drawing<'_> {
    pub fn curve(&self, branch: &Branch) -> Result<figure::Curve> {
        let labels = branch.labels();
        let mut curve = figure::Curve {
            name: format!("impact pattern ({})", branch.itinerary),
            at: Vec::new(),
            labels: Vec::new(),
        };
        for point in &branch.points {
            let oscillator = self.family.at(point.parameters[0])?;
            let first = if branch.itinerary.strikes().is_empty() { 0.0 } else { point.orbit.z[0] };
            let wait = (self.phase - first).rem_euclid(TAU);
            let q = point.orbit.state(&oscillator, first + wait)?.q;
            let at = (point.parameters[0], self.displacement(&oscillator, q));
            curve.at.push((at.0, at.1, point.orbit.multipliers.is_stable()));
            if let Some((label, _)) = labels.iter().find(|(_, known)| std::ptr::eq(*known, point)) {
                curve.labels.push((at.0, at.1, label.split(' ').next().unwrap_or_default().to_string()));
            }
        }
        Ok(curve)
    }

    /// q at the phase, from where it is counted.
    pub fn displacement(&self, oscillator: &Oscillator, q: f64) -> f64 {
        let wall = oscillator.walls().iter().find(|wall| Some(wall.side) == self.frame.side());
        wall.map_or(q, |wall| q - (wall.position.at(self.phase)[0] - wall.position.mean()))
    }

    pub fn axis(&self) -> &'static str {
        match self.frame {
            Frame::Fixed => "q",
            Frame::Lower => "q − (Q₁ − offset)",
            Frame::Upper => "q − (Q₂ − offset)",
        }
    }
}
