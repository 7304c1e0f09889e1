//! Tasks of kind `event` on machines: the first bifurcation of a kind along the branch of an orbit.
//!
//! Phases are fractions of the period, speeds in the scene's units.

use std::f64::consts::TAU;

use super::{
    Complex, Job, Judgement, Lines,
    branch::BranchSource,
    event::{EventList, EventTable, WithoutRow, is_known},
    machine_branch::MachineSource,
    machine_orbit::{admissible_at, multipliers, orbits, phases, speeds, stable},
    row,
};
use crate::{
    continuation::{Bifurcation, BranchSearch, FollowedOrbit, Located, SearchReach, nearest},
    error::Result,
    many::{Machine, MachineFamily, grazing::own_reach, normal_form::normal_form, orbit::MachineOrbit},
    scene::orbits::EventTask,
};

row! {
    /// A bifurcation of a machine.
    pub struct MachineEventRow {
        /// The parameter there.
        pub parameter: f64,
        /// The impact pattern.
        pub pattern: String,
        /// The phases of its impacts, as fractions of the period.
        pub phases: Vec<f64>,
        /// Their incoming speeds, in the scene's units.
        pub speeds: Vec<f64>,
        /// The multipliers of largest modulus, at most four.
        pub multipliers: Vec<Complex>,
        /// Whether all are inside the unit circle.
        pub stable: Judgement,
        /// Whether it is an orbit.
        pub admissible: Judgement,
        /// The normal form's coefficient.
        pub coefficient: Option<f64>,
        /// Its meaning: "supercritical", "subcritical", "above", "below", "transcritical", "degenerate".
        pub criticality: Option<&'static str>,
        /// Of a grazing, the stop that is grazed.
        pub stop: Option<String>,
        /// Of a grazing, its phase, as a fraction of the period.
        pub phase: Option<f64>,
        /// Of a grazing, the second derivative of the gap there, in the scene's units.
        pub acceleration: Option<f64>,
        /// How far along the branch, in the norm of times, states and speeds in units of the motion, and the
        /// parameter in units of its own reach.
        pub length: f64,
        /// What is left of the equations, relative to the size of the motion.
        pub residual: f64,
    }
}

impl EventTable for Vec<MachineEventRow> {
    fn is_empty(&self) -> bool {
        Vec::is_empty(self)
    }

    fn lines(&self, lines: &mut Lines) {
        lines.table("found", self);
    }
}

/// The bifurcations nearest to the orbits of a pattern of a machine.
pub type MachineEventFindings = EventList<Vec<MachineEventRow>>;

/// Follows the branch of each admissible orbit both ways to the first bifurcation of the kind.
///
/// # Errors
/// Where the machine is not defined at the start; an interruption.
pub fn machine_event(task: &EventTask, machine: &Machine<f64>, job: &Job) -> Result<MachineEventFindings> {
    let family = job.machine_family(&task.parameter)?;
    let source = MachineSource::new(&family, machine, job)?;
    let (start, options) = (family.value(), task.options.checked()?);
    let simulator = job.machine_simulator(machine, &[])?;
    let mut orbits = orbits(&task.orbit, machine, &simulator, job)?;
    orbits.retain(FollowedOrbit::is_orbit);
    let (mut found, mut without) = (Vec::<MachineEventRow>::new(), Vec::new());
    let unit = own_reach(&family, start)?;
    let extent = SearchReach::Parameter { unit, reach: task.reach.unwrap_or(unit) };
    job.monitor.begin(orbits.len() as u64, "orbits");
    for orbit in &orbits {
        let search = nearest(&source.patterns, task.event, orbit, start, extent, &options);
        job.monitor.advance(1)?;
        let reason = match search {
            Ok(BranchSearch::Found(located)) => {
                let at = located.parameter;
                if !is_known(found.iter().map(|old| old.parameter), at, start) {
                    found.push(MachineEventRow::of(&located, &source, &family.at(at)?));
                }
                continue;
            }
            Ok(BranchSearch::Nothing(nothing)) => nothing.to_string(),
            Err(error) => error.to_string(),
        };
        let (pattern, speeds) = (source.named(&orbit.pattern), speeds(orbit, machine.rate()));
        without.push(WithoutRow { pattern, speeds, reason });
    }
    Ok(EventList {
        event: task.event.name(),
        varied: task.parameter.clone(),
        start,
        orbits: orbits.len(),
        found,
        without,
    })
}

impl MachineEventRow {
    fn of(
        found: &Located<MachineOrbit>,
        source: &MachineSource,
        (machine, slope): &(Machine<f64>, Machine<f64>),
    ) -> MachineEventRow {
        let Located { bifurcation, parameter, orbit, length } = found;
        let form = normal_form(machine, slope, orbit, *bifurcation);
        let touch = orbit.least.filter(|_| *bifurcation == Bifurcation::Grazing);
        let rate = machine.rate();
        MachineEventRow {
            parameter: *parameter,
            pattern: source.named(&orbit.pattern),
            phases: phases(orbit),
            speeds: speeds(orbit, rate),
            multipliers: multipliers(&orbit.multipliers),
            stable: stable(orbit, Some(*bifurcation)),
            admissible: admissible_at(orbit, Some(*bifurcation)).0,
            coefficient: form.ok().map(|form| form.coefficient),
            criticality: Some(form.map_or_else(|why| why, |form| form.name())),
            stop: touch.map(|touch| machine.stops[touch.stop].name.clone()),
            phase: touch.map(|touch| (touch.phase / TAU).fract()),
            acceleration: touch.map(|touch| touch.acceleration * rate * rate),
            length: *length,
            residual: orbit.residual,
        }
    }
}
