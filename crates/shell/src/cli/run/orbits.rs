//! Orbits of branches in the plane of displacement and velocity: some of each, and those with labels.

use super::Job;
use crate::{
    continuation::{BranchPoint, OrbitBranch},
    error::Result,
    figure::{self, DrawnBranch, FigurePlace, Said},
    run::JudgedOrbit,
};

/// Places on an orbit, in each of its periods.
pub(super) const PLACES: u32 = 400;

/// The places of an orbit in order, from impact to impact.
pub(super) type Path<'p, O> = &'p dyn Fn(&BranchPoint<O>) -> Result<Vec<Vec<(f64, f64)>>>;

/// Writes `NAME-orbits`, a picture and its data: as many orbits of each branch as are asked for, evenly along
/// it, and all with labels; the names of both files.
pub(super) fn keep<O: JudgedOrbit>(
    (all, wanted): (&[OrbitBranch<O>], usize),
    (job, parameter): (&Job, &str),
    axes: [&str; 2],
    path: Path<O>,
) -> Result<Vec<String>> {
    let across = job.axis(parameter);
    let mut curves = Vec::new();
    for branch in all {
        let last = branch.points.len().saturating_sub(1);
        let even = |k: usize| k * last / wanted.saturating_sub(1).max(1);
        let chosen: Vec<usize> = (0..wanted).map(even).collect();
        for (i, point) in branch.points.iter().enumerate() {
            let kind = point.kind();
            if kind.is_none() && !chosen.contains(&i) {
                continue;
            }
            let value = format!("{parameter} = {}", across.at(point.parameters[0]));
            let name = kind.map_or(value.clone(), |kind| format!("{kind}, {value}"));
            let stable = Some(point.orbit.stable(point.event));
            for at in path(point)? {
                let at = at.into_iter().map(|(q, u)| (q, u, Said { stable, proved: None })).collect();
                curves.push(DrawnBranch { name: name.clone(), at, labels: Vec::new() });
            }
            // Told where it goes farthest, once.
            let told = kind.is_some() || i == 0 || i == last;
            if let Some(curve) = curves.last_mut().filter(|_| told)
                && let Some((q, u, _)) = curve.at.iter().copied().max_by(|a, b| a.0.total_cmp(&b.0))
            {
                curve.labels.push((q, u, kind.map_or(value, |kind| kind.to_string())));
            }
        }
    }
    let name = format!("{}-orbits", job.task.name);
    figure::orbits_of_branches(&curves, axes, &FigurePlace { name: &name, ..job.place() })?;
    Ok([job.format.ending(), "csv"].map(|end| format!("{name}.{end}")).to_vec())
}
