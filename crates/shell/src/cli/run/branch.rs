//! The files of tasks of kind `branch`: a JSON file for each branch, a table of all points, the picture.

use std::f64::consts::TAU;

use super::{Job, orbits};
use crate::{
    continuation::{BranchPoint, FollowedOrbit, OrbitBranch, record_as},
    error::Result,
    figure::{self, Said},
    many::{self, Family as _, branch::Patterns},
    one::{
        branch::{Branch, record},
        orbit::{Family, Orbit, Oscillator},
    },
    run::{BranchFindings, BranchRow, FoundBranches, JudgedOrbit, form},
    scene::{Frame, MachineSceneFamily, Scene, SceneFamily, branches::BranchTask, phase},
};

pub(super) fn keep(found: &BranchFindings, task: &BranchTask, job: &Job) -> Result<Vec<String>> {
    let scene = &found.scene(&job.scene)?;
    match &found.branches {
        FoundBranches::One(all) => {
            let family = SceneFamily::new(scene, &task.parameter)?;
            let drawing = Drawing { family: &family, phase: phase(&task.phase), frame: task.frame };
            let draw = |branch: &Branch| drawing.curve(branch);
            let named = |branch: &Branch| branch.itinerary.to_string();
            let path = |point: &BranchPoint<Orbit>| drawing.path(point);
            write((found, all), task, job, (&record, &draw, &named, &path), [drawing.axis(), "q", "u"])
        }
        FoundBranches::Many(all) => of_machine((found, all), task, (job, scene)),
    }
}

fn of_machine(
    (found, all): (&BranchFindings, &[many::branch::Branch]),
    task: &BranchTask,
    (job, scene): (&Job, &Scene),
) -> Result<Vec<String>> {
    let machine = scene.machine(&[])?;
    let stops: Vec<&str> = machine.stops.iter().map(|stop| stop.name.as_str()).collect();
    let family = MachineSceneFamily::new(scene, &task.parameter)?;
    let patterns = Patterns::new(&family, family.value(), scene.machine_scene()?.minimum_depth)?;
    // One stop for all branches: that of the first impact of the first that has one.
    let mut first = all.iter().filter_map(|branch| branch.itinerary.strikes().first());
    let stop = first.next().map_or(0, |strike| strike.place);
    let record = |branch: &many::branch::Branch, names: &[&str]| record_as(branch, names, form(&stops));
    let named = |branch: &many::branch::Branch| {
        branch.itinerary.with_names(|stop| (stops.len() > 1).then(|| stops[stop]))
    };
    let at = phase(&task.phase);
    let draw = |branch: &many::branch::Branch| {
        let drawn = |point: &BranchPoint<many::orbit::Orbit>| {
            if stops.is_empty() {
                let state = patterns.state(point.parameters[0], &point.orbit, at)?;
                return Ok(family.at(point.parameters[0])?.0.displaced(state.q())[0]);
            }
            patterns.gap(point.parameters[0], &point.orbit, stop, at)
        };
        curve(branch, &named(branch), &drawn)
    };
    let axis = match stops[..] {
        [] if machine.points() == 1 => "q".to_string(),
        [] => "q1".to_string(),
        [_] => "gap".to_string(),
        _ => format!("gap of {}", stops[stop]),
    };
    let path = |point: &BranchPoint<many::orbit::Orbit>| {
        let own = family.at(point.parameters[0])?.0;
        let shown =
            |state: &many::State| (own.displaced(state.q())[0], own.rate() * own.displaced(state.u())[0]);
        let legs = patterns.legs(point.parameters[0], &point.orbit, orbits::PLACES)?;
        Ok(legs.iter().map(|leg| leg.iter().map(shown).collect()).collect())
    };
    let plane = if machine.points() == 1 { ["q", "u"] } else { ["q1", "u1"] };
    write((found, all), task, job, (&record, &draw, &named, &path), [&axis, plane[0], plane[1]])
}

/// A branch as JSON, as a curve of its picture, and its pattern; the path of an orbit.
type Views<'v, O> = (
    &'v dyn Fn(&OrbitBranch<O>, &[&str]) -> serde_json::Value,
    &'v dyn Fn(&OrbitBranch<O>) -> Result<figure::DrawnBranch>,
    &'v dyn Fn(&OrbitBranch<O>) -> String,
    orbits::Path<'v, O>,
);

fn write<O: JudgedOrbit>(
    (found, all): (&BranchFindings, &[OrbitBranch<O>]),
    task: &BranchTask,
    job: &Job,
    (record, draw, named, path): Views<O>,
    [axis, q, u]: [&str; 3],
) -> Result<Vec<String>> {
    let names: Vec<&str> = found.varied.iter().map(String::as_str).collect();
    let mut files = Vec::new();
    for (i, branch) in (1..).zip(all) {
        let file = if all.len() == 1 {
            format!("{}.json", job.task.name)
        } else {
            format!("{}-{i}.json", job.task.name)
        };
        let text = serde_json::to_string_pretty(&record(branch, &names)).map_err(std::io::Error::other)?;
        job.write(&file, |out| Ok(writeln!(out, "{text}")?))?;
        files.push(file);
    }
    let (across, up) = (job.axis(&task.parameter), task.second.as_deref().map(|second| job.axis(second)));
    let (mut curves, axes) = match &task.second {
        None => (all.iter().map(draw).collect::<Result<Vec<_>>>()?, [across.name.as_str(), axis]),
        Some(second) => {
            let kept = task.hold.0.first().map(|(name, value)| format!("{name} = {value}"));
            let locus = |branch: &OrbitBranch<O>| {
                locus(branch, kept.as_deref().unwrap_or(branch.name()), &named(branch))
            };
            (
                all.iter().map(locus).collect(),
                [across.name.as_str(), up.as_ref().map_or(second, |up| &up.name)],
            )
        }
    };
    let over = |row: &BranchRow| {
        let pieces = &found.proofs.as_ref()?.rows;
        pieces
            .iter()
            .find(|piece| piece.certificate.is_some() && piece.certificate == row.certificate)?
            .over()
    };
    for (curve, number) in curves.iter_mut().zip(1..) {
        let rows = found.rows.iter().filter(|row| row.branch == number);
        curve.at.iter_mut().zip(rows).for_each(|((_, _, said), row)| said.proved = over(row));
    }
    across.convert(&mut curves, &mut []);
    if let Some(up) = &up {
        curves.iter_mut().for_each(|curve| curve.at.iter_mut().for_each(|(_, y, _)| *y = up.at(*y)));
        curves.iter_mut().for_each(|curve| curve.labels.iter_mut().for_each(|(_, y, _)| *y = up.at(*y)));
    }
    figure::branches(&curves, &[], axes, &job.place())?;
    files.extend(job.figure());
    files.push(job.csv(&found.rows, "-points.csv")?);
    if task.drawn > 0 {
        files.extend(orbits::keep((all, task.drawn as usize), (job, &task.parameter), [q, u], path)?);
    }
    if let Some(proofs) = &found.proofs {
        files.push(job.csv(&proofs.rows, "-proofs.csv")?);
        files.extend(job.certificates(&proofs.certificates)?);
    }
    Ok(files)
}

/// A curve of bifurcations, or of what is held, in the plane of both parameters.
fn locus<O: FollowedOrbit>(branch: &OrbitBranch<O>, what: &str, pattern: &str) -> figure::DrawnBranch {
    let place = |point: &BranchPoint<O>| (point.parameters[0], point.parameters[1]);
    figure::DrawnBranch {
        name: format!("{what} of the impact pattern ({pattern})"),
        at: branch.points.iter().map(|point| (place(point).0, place(point).1, Said::default())).collect(),
        labels: branch
            .points
            .iter()
            .filter_map(|point| Some((place(point).0, place(point).1, point.kind()?.to_string())))
            .collect(),
    }
}

/// A branch over one parameter, drawn at the heights of its orbits.
pub(super) fn curve<O: JudgedOrbit>(
    branch: &OrbitBranch<O>,
    pattern: &str,
    height: &dyn Fn(&BranchPoint<O>) -> Result<f64>,
) -> Result<figure::DrawnBranch> {
    let name = format!("impact pattern ({pattern})");
    let mut curve = figure::DrawnBranch { name, at: Vec::new(), labels: Vec::new() };
    for point in &branch.points {
        let parameter = point.parameters[0];
        let height = height(point)?;
        let stable = Some(point.orbit.stable(point.event));
        curve.at.push((parameter, height, Said { stable, proved: None }));
        if let Some(kind) = point.kind() {
            curve.labels.push((parameter, height, kind.to_string()));
        }
    }
    Ok(curve)
}

/// What of an orbit is drawn: its displacement when `phase` comes first after its first impact.
pub(super) struct Drawing<'a> {
    pub family: &'a SceneFamily<'a>,
    pub phase: f64,
    pub frame: Frame,
}

impl Drawing<'_> {
    pub fn curve(&self, branch: &Branch) -> Result<figure::DrawnBranch> {
        let drawn = |point: &BranchPoint<Orbit>| {
            let (oscillator, orbit) = (self.family.at(point.parameters[0])?, &point.orbit);
            let first = if orbit.itinerary.strikes().is_empty() { 0.0 } else { orbit.z[0] };
            let wait = (self.phase - first).rem_euclid(TAU);
            let q = orbit.state(&oscillator, first + wait)?.q;
            Ok(self.displacement(&oscillator, q))
        };
        curve(branch, &branch.itinerary.to_string(), &drawn)
    }

    /// (q, u) once around an orbit, leg by leg.
    fn path(&self, point: &BranchPoint<Orbit>) -> Result<Vec<Vec<(f64, f64)>>> {
        let oscillator = self.family.at(point.parameters[0])?;
        let rate = oscillator.system().shown_rate();
        let legs = point.orbit.legs(&oscillator, orbits::PLACES)?;
        Ok(legs.iter().map(|leg| leg.iter().map(|state| (state.q, rate * state.u)).collect()).collect())
    }

    /// q at the phase, from where it is counted.
    pub fn displacement(&self, oscillator: &Oscillator, q: f64) -> f64 {
        let wall = oscillator.walls().iter().find(|wall| Some(wall.side) == self.frame.side());
        wall.map_or(q, |wall| q - (wall.position.at(self.phase)[0] - wall.position.mean()))
    }

    pub fn axis(&self) -> &'static str {
        match self.frame {
            Frame::Fixed | Frame::Other => "q",
            Frame::Lower => "q − (Q₁ − offset)",
            Frame::Upper => "q − (Q₂ − offset)",
        }
    }
}
