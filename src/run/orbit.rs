//! Tasks of kind `orbit`: periodic orbits of a pattern.

use serde::Serialize;

use super::{Complex, Finding, Job, Judgement, Lines, Status, row};
use crate::{
    error::Result,
    number::{Plain, Real},
    oscillator::{
        branch::Bifurcation,
        orbit::{Admissibility, Orbit, Oscillator},
    },
    scene::orbits::OrbitTask,
};

row! {
    /// A solution of the pattern equations.
    pub struct OrbitRow {
        /// The parameter's value, if the task goes through some.
        pub value: Option<f64>,
        /// The impact pattern.
        pub pattern: String,
        /// The phases of its impacts, in [0, 2π).
        pub phases: Vec<f64>,
        /// Their incoming relative speeds.
        pub speeds: Vec<f64>,
        /// The larger multiplier.
        pub lambda1: Complex,
        /// The smaller.
        pub lambda2: Complex,
        /// Whether both are inside the unit circle.
        pub stable: Judgement,
        /// Whether it is an orbit: impacts come in, no other contact.
        pub admissible: Judgement,
        /// Why not.
        pub reason: Option<String>,
        /// The least minimum of a gap away from the impacts.
        pub least_gap: Option<f64>,
        /// What is left of the equations.
        pub residual: f64,
    }
}

row! {
    /// A value without a solution.
    pub struct MissingRow {
        /// The parameter's value, if the task goes through some.
        pub value: Option<f64>,
        /// Why there is none.
        pub reason: String,
    }
}

/// The orbits that were found, and where there are none.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OrbitFindings {
    /// Solutions, by value, then by speed.
    pub orbits: Vec<OrbitRow>,
    /// Values without any.
    pub missing: Vec<MissingRow>,
}

impl Finding for OrbitFindings {
    fn status(&self) -> Status {
        match self.missing.as_slice() {
            [] => Status::Done,
            [MissingRow { value: None, reason }] => Status::nothing(reason.clone()),
            [first, ..] => Status::nothing(format!(
                "no solution at {} of {} values; at {}: {}",
                self.missing.len(),
                self.values(),
                first.value.unwrap_or(f64::NAN),
                first.reason
            )),
        }
    }

    fn lines(&self, lines: &mut Lines) {
        lines.table("orbits", &self.orbits);
        if !self.missing.is_empty() {
            lines.table("missing", &self.missing);
        }
    }
}

impl OrbitFindings {
    fn values(&self) -> usize {
        let mut values: Vec<f64> = self.orbits.iter().filter_map(|row| row.value).collect();
        values.extend(self.missing.iter().filter_map(|row| row.value));
        values.sort_by(f64::total_cmp);
        values.dedup();
        values.len()
    }
}

/// Finds the orbits of a pattern, at each value of a parameter if there is one.
///
/// # Errors
/// Where the system is not defined; an interruption.
pub fn orbit(task: &OrbitTask, job: &Job) -> Result<OrbitFindings> {
    let mut found = OrbitFindings { orbits: Vec::new(), missing: Vec::new() };
    let tolerance = job.scene.accuracy.tolerance;
    let values: Vec<Option<f64>> = match &task.parameter {
        None => vec![None],
        Some(_) => task.values.iter().map(|value| Some(Plain::ratio(value, &()).0)).collect(),
    };
    job.monitor.begin(values.len() as u64, "values");
    for value in values {
        let system = match (&task.parameter, value) {
            (Some(parameter), Some(value)) => job.scene.plain(&[(parameter, value)])?,
            _ => job.system()?.clone(),
        };
        match task.orbit.orbits(&Oscillator::new(system, tolerance)?) {
            Ok(orbits) if orbits.is_empty() => {
                let reason = format!(
                    "no orbit of the pattern from {} starts with speeds up to {}",
                    task.orbit.starts, task.orbit.speed
                );
                found.missing.push(MissingRow { value, reason });
            }
            Ok(orbits) => found.orbits.extend(orbits.iter().map(|orbit| OrbitRow::of(orbit, value))),
            Err(error) => found.missing.push(MissingRow { value, reason: error.to_string() }),
        }
        job.monitor.advance(1)?;
    }
    Ok(found)
}

impl OrbitRow {
    fn of(orbit: &Orbit, value: Option<f64>) -> OrbitRow {
        let [lambda1, lambda2] = orbit.multipliers.values().map(Complex::from);
        OrbitRow {
            value,
            pattern: orbit.itinerary.to_string(),
            phases: phases(orbit),
            speeds: speeds(orbit),
            lambda1,
            lambda2,
            stable: stable(orbit, None),
            admissible: admissible(orbit, None),
            reason: obstacle(orbit),
            least_gap: orbit.least.map(|least| least.gap),
            residual: orbit.residual,
        }
    }
}

pub(super) fn phases(orbit: &Orbit) -> Vec<f64> {
    orbit.impacts().map(|impact| impact.phase).collect()
}

pub(super) fn speeds(orbit: &Orbit) -> Vec<f64> {
    orbit.impacts().map(|impact| impact.speed).collect()
}

/// Closer than this to a bifurcation, rounding decides on which side of it an orbit is.
const MARGIN: f64 = 1e-11;

/// Whether both multipliers are inside the unit circle; marginal at a bifurcation at which one is on it.
pub(super) fn stable(orbit: &Orbit, at: Option<Bifurcation>) -> Judgement {
    let multipliers = &orbit.multipliers;
    let test = |value: f64, here: bool| match () {
        () if here || value.abs() <= MARGIN * (1.0 + multipliers.trace.abs()) => Judgement::Marginal,
        () if value > 0.0 => Judgement::Yes,
        () => Judgement::No,
    };
    let tests = [
        test(multipliers.fold(), matches!(at, Some(Bifurcation::SaddleNode | Bifurcation::Crossing))),
        test(multipliers.flip(), at == Some(Bifurcation::Flip)),
        test(1.0 - multipliers.determinant, at == Some(Bifurcation::Torus)),
    ];
    match () {
        () if tests.contains(&Judgement::No) => Judgement::No,
        () if tests.contains(&Judgement::Marginal) => Judgement::Marginal,
        () => Judgement::Yes,
    }
}

/// Whether a solution is an orbit; marginal at a grazing or where an impact fades.
pub(super) fn admissible(orbit: &Orbit, at: Option<Bifurcation>) -> Judgement {
    let grazes = orbit.least.is_some_and(|least| least.gap.abs() <= MARGIN);
    let fades = orbit.impacts().any(|impact| impact.speed.abs() <= MARGIN);
    let others = orbit.impacts().all(|impact| impact.speed > -MARGIN)
        && orbit.least.is_none_or(|least| least.gap > -MARGIN);
    match (at, orbit.admissibility) {
        (Some(Bifurcation::Grazing | Bifurcation::Fade), _) => Judgement::Marginal,
        _ if others && (grazes || fades) => Judgement::Marginal,
        (_, Admissibility::Admissible) => Judgement::Yes,
        _ => Judgement::No,
    }
}

/// Why a solution is not an orbit.
pub(super) fn obstacle(orbit: &Orbit) -> Option<String> {
    match orbit.admissibility {
        Admissibility::Admissible => None,
        Admissibility::Outgoing(i) => Some(format!("impact {} does not come in", i + 1)),
        Admissibility::Excursion(at) => {
            Some(format!("behind the {} wall {:.6} after impact {}", at.side.name(), at.after, at.leg + 1))
        }
    }
}
