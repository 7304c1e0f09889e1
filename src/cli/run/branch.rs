//! The files of tasks of kind `branch`: a JSON file for each branch, a table of all points, the picture.

use std::f64::consts::TAU;

use super::Job;
use crate::{
    error::Result,
    figure,
    oscillator::{
        branch::{Branch, record},
        orbit::{Family, Oscillator},
    },
    output::write_file,
    run::BranchFindings,
    scene::{Frame, SceneFamily, branches::BranchTask, phase},
};

pub(super) fn keep(found: &BranchFindings, task: &BranchTask, job: &Job) -> Result<Vec<String>> {
    let family = SceneFamily::new(&job.scene, &task.parameter)?;
    let names: Vec<&str> = found.varied.iter().map(String::as_str).collect();
    let mut files = Vec::new();
    for (i, branch) in (1..).zip(&found.branches) {
        let file = if found.branches.len() == 1 {
            format!("{}.json", job.task.name)
        } else {
            format!("{}-{i}.json", job.task.name)
        };
        let text = serde_json::to_string_pretty(&record(branch, &names)).map_err(std::io::Error::other)?;
        write_file(&job.folder.join(&file), |out| Ok(writeln!(out, "{text}")?))?;
        files.push(file);
    }
    let drawing = Drawing { family: &family, phase: phase(&task.phase), frame: task.frame };
    let (curves, axes) = match &task.second {
        None => {
            let curves =
                found.branches.iter().map(|branch| drawing.curve(branch)).collect::<Result<Vec<_>>>()?;
            (curves, [task.parameter.as_str(), drawing.axis()])
        }
        Some(second) => {
            (found.branches.iter().map(locus).collect(), [task.parameter.as_str(), second.as_str()])
        }
    };
    figure::branches(&curves, &[], axes, job.folder, &job.task.name)?;
    files.extend(job.figure());
    files.push(job.csv(&found.rows, "-points.csv")?);
    Ok(files)
}

/// A curve of bifurcations in the plane of both parameters.
fn locus(branch: &Branch) -> figure::DrawnBranch {
    let place = |point: &crate::oscillator::branch::BranchOrbit| (point.parameters[0], point.parameters[1]);
    figure::DrawnBranch {
        name: format!("{} of the impact pattern ({})", branch.name(), branch.itinerary),
        at: branch.points.iter().map(|point| (place(point).0, place(point).1, true)).collect(),
        labels: branch
            .points
            .iter()
            .filter_map(|point| Some((place(point).0, place(point).1, point.kind()?.to_string())))
            .collect(),
    }
}

/// What of an orbit is drawn: its displacement when `phase` comes first after its first impact.
pub(super) struct Drawing<'a> {
    pub family: &'a SceneFamily<'a>,
    pub phase: f64,
    pub frame: Frame,
}

impl Drawing<'_> {
    pub fn curve(&self, branch: &Branch) -> Result<figure::DrawnBranch> {
        let mut curve = figure::DrawnBranch {
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
            if let Some(kind) = point.kind() {
                curve.labels.push((at.0, at.1, kind.to_string()));
            }
        }
        // At an event rounding decides the stability: the line changes there to that of what follows.
        for i in (0..branch.points.len().saturating_sub(1)).rev() {
            if branch.points[i].kind().is_some() {
                curve.at[i].2 = curve.at[i + 1].2;
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
