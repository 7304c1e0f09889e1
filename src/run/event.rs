//! Tasks of kind `event`: the first bifurcation of a kind along the branch of an orbit.

use serde::Serialize;

use super::{
    Complex, Finding, Job, Judgement, Lines, Status,
    orbit::{admissible, phases, speeds, stable},
    row,
};
use crate::{
    continuation::{Bifurcation, BranchSearch, Located, NormalForm, nearest},
    error::Result,
    one::{
        branch::OscillatorPatterns,
        grazing::{self, Grazing},
        orbit::{Family, Orbit},
    },
    scene::orbits::EventTask,
};

row! {
    /// A bifurcation.
    pub struct EventRow {
        /// The parameter there.
        pub parameter: f64,
        /// The impact pattern.
        pub pattern: String,
        /// The times of its impacts, as its pattern counts them, the first in [0, 2π).
        pub phases: Vec<f64>,
        /// Their incoming relative speeds.
        pub speeds: Vec<f64>,
        /// The larger multiplier.
        pub lambda1: Complex,
        /// The smaller.
        pub lambda2: Complex,
        /// Whether both are inside the unit circle.
        pub stable: Judgement,
        /// Whether it is an orbit.
        pub admissible: Judgement,
        /// The normal form's coefficient.
        pub coefficient: Option<f64>,
        /// "supercritical", "subcritical"; at a saddle-node on which side of it orbits exist, "above" or
        /// "below".
        pub criticality: Option<&'static str>,
        /// How far along the branch, in the norm of times, speeds and parameter.
        pub length: f64,
        /// What is left of the equations.
        pub residual: f64,
    }
}

row! {
    /// A grazing bifurcation with the local map there.
    pub struct GrazingEventRow {
        /// The parameter there.
        pub parameter: f64,
        /// The impact pattern of the orbit that grazes.
        pub pattern: String,
        /// The wall that is grazed.
        pub wall: &'static str,
        /// The phase of grazing, in [0, 2π).
        pub phase: f64,
        /// a_G, the relative acceleration there.
        pub acceleration: f64,
        /// The larger eigenvalue of A.
        pub lambda1: Complex,
        /// The smaller.
        pub lambda2: Complex,
        /// The region of the plane of (a₁, a₂), 1 to 5 or `line`; none for a₂ ≤ 0.
        pub region: Option<String>,
        /// γ.
        pub gamma: f64,
        /// e.
        pub e: f64,
        /// Whether it is an orbit but for the tangency.
        pub admissible: Judgement,
        /// What is left of the equations.
        pub residual: f64,
    }
}

row! {
    /// An orbit from which nothing was found.
    pub struct WithoutRow {
        /// Its pattern.
        pub pattern: String,
        /// Its incoming speeds.
        pub speeds: Vec<f64>,
        /// Why.
        pub reason: String,
    }
}

/// The table of what was found.
pub trait EventTable: Serialize {
    /// Whether it is empty.
    fn is_empty(&self) -> bool;

    /// What a report shows of it.
    fn lines(&self, lines: &mut Lines);
}

/// Bifurcations with multipliers, or grazings with their maps.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum EventRows {
    /// Where multipliers are on the unit circle, or an impact fades.
    Bifurcations(Vec<EventRow>),
    /// Where a wall is touched.
    Grazings(Vec<GrazingEventRow>),
}

impl EventTable for EventRows {
    fn is_empty(&self) -> bool {
        match self {
            EventRows::Bifurcations(rows) => rows.is_empty(),
            EventRows::Grazings(rows) => rows.is_empty(),
        }
    }

    fn lines(&self, lines: &mut Lines) {
        match self {
            EventRows::Bifurcations(rows) => lines.table("found", rows),
            EventRows::Grazings(rows) => lines.table("found", rows),
        }
    }
}

/// The bifurcations nearest to the orbits of a pattern.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EventList<T> {
    /// What was looked for.
    pub event: &'static str,
    /// The parameter.
    pub varied: String,
    /// Its value at the orbits.
    pub start: f64,
    /// How many admissible orbits there are to begin with.
    pub orbits: usize,
    /// What was found, each once.
    pub found: T,
    /// Orbits from which nothing was found, with the reason.
    pub without: Vec<WithoutRow>,
}

/// Those of an oscillator.
pub type EventFindings = EventList<EventRows>;

impl<T: EventTable> Finding for EventList<T> {
    fn status(&self) -> Status {
        match self.without.first() {
            _ if !self.found.is_empty() => Status::Done,
            Some(first) => Status::nothing(first.reason.clone()),
            None => Status::nothing(format!(
                "no admissible orbit to begin with at {} = {}",
                self.varied, self.start
            )),
        }
    }

    fn lines(&self, lines: &mut Lines) {
        lines.say("event", self.event);
        lines.say("orbits", self.orbits);
        self.found.lines(lines);
        if !self.without.is_empty() {
            lines.table("without", &self.without);
        }
    }
}

/// Events at parameters that differ by less than this part of them, or of how far they are, are one.
const SAME: f64 = 1e-9;

/// Whether an event was found before, `start` being where the search for it began.
pub(super) fn is_known(known: impl IntoIterator<Item = f64>, parameter: f64, start: f64) -> bool {
    let near = SAME * parameter.abs().max((parameter - start).abs());
    known.into_iter().any(|old| (old - parameter).abs() <= near)
}

/// Follows the branch of each admissible orbit both ways to the first bifurcation of the kind.
///
/// # Errors
/// Where the system is not defined at the start; an interruption.
pub fn event(task: &EventTask, job: &Job) -> Result<EventFindings> {
    let family = job.family(&task.parameter)?;
    let (start, options) = (family.value(), task.options.checked()?);
    let mut orbits = task.orbit.orbits(&family.at(start)?)?;
    orbits.retain(|orbit| orbit.admissibility.is_admissible());
    let patterns = OscillatorPatterns::new(&family, start)?;
    let (mut bifurcations, mut grazings, mut without) = (Vec::new(), Vec::new(), Vec::new());
    let mut known: Vec<f64> = Vec::new();
    job.monitor.begin(orbits.len() as u64, "orbits");
    for orbit in &orbits {
        let extent = task.extent(&family.at(start)?, orbit);
        let found = nearest(&patterns, task.event, orbit, start, extent, &options);
        job.monitor.advance(1)?;
        let mut fail = |reason: String| {
            let pattern = orbit.itinerary.to_string();
            without.push(WithoutRow { pattern, speeds: speeds(orbit), reason });
        };
        let located = match found {
            Ok(BranchSearch::Found(located)) => located,
            Ok(BranchSearch::Nothing(nothing)) => {
                fail(nothing.to_string());
                continue;
            }
            Err(error) => {
                fail(error.to_string());
                continue;
            }
        };
        let parameter = located.parameter;
        if is_known(known.iter().copied(), parameter, start) {
            continue;
        }
        if task.event == Bifurcation::Grazing {
            match grazing::locate(&family, &located.orbit, parameter) {
                Ok(found) => grazings.push(GrazingEventRow::of(&found, orbit)),
                Err(error) => {
                    fail(error.to_string());
                    continue;
                }
            }
        } else {
            bifurcations.push(EventRow::of(&located, &family)?);
        }
        known.push(parameter);
    }
    Ok(EventFindings {
        event: task.event.name(),
        varied: task.parameter.clone(),
        start,
        orbits: orbits.len(),
        found: match task.event {
            Bifurcation::Grazing => EventRows::Grazings(grazings),
            _ => EventRows::Bifurcations(bifurcations),
        },
        without,
    })
}

impl EventRow {
    fn of(found: &Located<Orbit>, family: &dyn Family) -> Result<EventRow> {
        let Located { bifurcation, parameter, orbit, length } = found;
        let [lambda1, lambda2] = orbit.multipliers.values().map(Complex::from);
        let form = NormalForm::at(&family.at(*parameter)?, orbit, *bifurcation);
        Ok(EventRow {
            parameter: *parameter,
            pattern: orbit.itinerary.to_string(),
            phases: phases(orbit),
            speeds: speeds(orbit),
            lambda1,
            lambda2,
            stable: stable(orbit, Some(*bifurcation)),
            admissible: admissible(orbit, Some(*bifurcation)),
            coefficient: form.ok().map(|form| form.coefficient),
            criticality: Some(form.map_or_else(|why| why, |form| form.name())),
            length: *length,
            residual: orbit.residual,
        })
    }
}

impl GrazingEventRow {
    fn of(event: &Grazing, orbit: &Orbit) -> GrazingEventRow {
        let map = &event.map;
        let [lambda1, lambda2] = map.multipliers.values().map(Complex::from);
        GrazingEventRow {
            parameter: event.parameter,
            pattern: orbit.itinerary.to_string(),
            wall: event.side().name(),
            phase: event.phase(),
            acceleration: map.acceleration,
            lambda1,
            lambda2,
            region: map.region().map(|region| region.to_string()),
            gamma: map.gamma(),
            e: map.e(),
            admissible: if event.admissible { Judgement::Yes } else { Judgement::No },
            residual: event.residual,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::is_known;

    /// No unit of the parameter enters, and none is told at 0 from what is nearly 0.
    #[test]
    fn events_are_one_whatever_the_parameter_is_measured_in() {
        for unit in [1e-30, 1.0, 1e30] {
            let at = |x: f64| x * unit;
            assert!(is_known([at(2.0)], at(2.0 + 1e-10), at(1.0)), "{unit}");
            assert!(!is_known([at(2.0)], at(2.0 + 1e-8), at(1.0)), "{unit}");
            // Beside 0, the way from the start is the measure.
            assert!(is_known([0.0], at(1e-12), at(1.0)), "{unit}");
            assert!(!is_known([0.0], at(1e-6), at(1.0)), "{unit}");
        }
    }
}
