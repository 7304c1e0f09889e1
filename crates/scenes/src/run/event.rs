//! Tasks of kind `event`: the first bifurcation of a kind along the branch of an orbit.

use serde::Serialize;

use super::{
    Analysed, Finding, Job, Judgement, Lines, Status,
    engine::{AnalysedEvent, Engine, OrbitSource, by_engine, linear_touches, no_orbit},
    row,
};
use crate::{
    continuation::{Bifurcation, BranchSearch, Located, Options, SearchReach, nearest},
    error::Result,
    rounding::PLACE,
    scene::orbits::EventTask,
};

row! {
    /// A bifurcation.
    pub struct EventRow {
        /// The parameter there.
        pub parameter: f64,
        with {
            /// The orbit there; at a grazing it is marginal, or none but for the tangency.
            pub orbit: Analysed
        }
        /// The normal form's coefficient.
        pub coefficient: Option<f64>,
        /// Its meaning: "supercritical", "subcritical", "above", "below", "transcritical", "degenerate"; or
        /// why there is none.
        pub criticality: Option<&'static str>,
        /// The stop that is grazed.
        pub stop: Option<String>,
        /// The phase of grazing, as a fraction of the period.
        pub phase: Option<f64>,
        /// a_G: the second derivative of the gap there, in the scene's units.
        pub acceleration: Option<f64>,
        /// The region of the plane of (a₁, a₂), 1 to 5 or `line`; of the engine `one`, and for a₂ > 0.
        pub region: Option<String>,
        /// γ of the local map; of the engine `one`.
        pub gamma: Option<f64>,
        /// e, how fast the least gap opens with the parameter; of the engine `one`.
        pub e: Option<f64>,
        /// How far along the branch, in the norm of times, of states and speeds in units of the motion, and
        /// of the parameter, of a machine in units of its own reach; of a touch beyond a reach that was not
        /// given, in units of the way.
        pub length: f64,
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

/// The bifurcations nearest to the orbits of a pattern.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EventFindings {
    /// What was looked for.
    pub event: &'static str,
    /// The parameter.
    pub varied: String,
    /// Its value at the orbits.
    pub start: f64,
    /// How many admissible orbits there are to begin with.
    pub orbits: usize,
    /// What was found, each once.
    pub found: Vec<EventRow>,
    /// Orbits from which nothing was found, with the reason.
    pub without: Vec<WithoutRow>,
    /// That there are none, and where to look.
    #[serde(skip)]
    pub(super) none: Option<String>,
}

impl Finding for EventFindings {
    fn status(&self) -> Status {
        match self.without.first() {
            _ if !self.found.is_empty() => Status::Done,
            Some(first) => Status::nothing(first.reason.clone()),
            None => Status::nothing(self.none.clone().unwrap_or_default()),
        }
    }

    fn lines(&self, lines: &mut Lines) {
        let meaning = Bifurcation::named(self.event).and_then(Bifurcation::meaning);
        lines.say("event", meaning.map_or(self.event.into(), |meaning| format!("{}: {meaning}", self.event)));
        lines.say("orbits", self.orbits);
        lines.table("found", &self.found);
        if !self.without.is_empty() {
            lines.table("without", &self.without);
        }
    }
}

/// Whether an event was found before, `start` being where the search for it began.
fn is_known(known: impl IntoIterator<Item = f64>, parameter: f64, start: f64) -> bool {
    let near = PLACE * parameter.abs().max((parameter - start).abs());
    known.into_iter().any(|old| (old - parameter).abs() <= near)
}

/// Follows the branch of each admissible orbit both ways to the first bifurcation of the kind.
///
/// # Errors
/// Where the system is not defined at the start; an interruption.
pub(crate) fn event(task: &EventTask, job: &Job) -> Result<EventFindings> {
    by_engine!(job, engine => of(task, job, &engine))
}

fn of<E: Engine>(task: &EventTask, job: &Job, engine: &E) -> Result<EventFindings> {
    let family = engine.family(&task.parameter)?;
    let source = engine.source(&family)?;
    let (start, options) = (source.value(), task.options.checked()?);
    let orbits = source.present(&task.orbit)?;
    let extents = source.reaches(task.reach, &orbits)?;
    let (mut found, mut without) = (Vec::new(), Vec::new());
    let mut known: Vec<f64> = Vec::new();
    job.monitor.begin(orbits.len() as u64, "orbits");
    let touch = task.is_of_free_motion().then(|| linear_touches(engine, &family, None, job)).transpose()?;
    let touch = touch.flatten().and_then(|all| Some(all.found.first()?.parameter));
    for (orbit, extent) in orbits.iter().zip(extents) {
        let mut search = nearest(source.family(), task.event, orbit, start, extent, &options);
        if let (Ok(BranchSearch::Nothing(_)), Some(touch)) = (&search, touch) {
            // Steps are measured by the size of the forces: where little damps, the motion is larger.
            let long = Options { most_step: f64::from(u32::MAX), ..options.clone() };
            search = nearest(source.family(), task.event, orbit, start, SearchReach::to(touch, start), &long);
        }
        job.monitor.advance(1)?;
        let reason = match search {
            Ok(BranchSearch::Found(located)) => {
                if is_known(known.iter().copied(), located.parameter, start) {
                    continue;
                }
                match EventRow::of(&located, &task.parameter, &source) {
                    Ok(row) => {
                        known.push(located.parameter);
                        found.push(row);
                        continue;
                    }
                    Err(error) if error.is_interrupted() => return Err(error),
                    Err(error) => error.to_string(),
                }
            }
            Ok(BranchSearch::Nothing(nothing)) => nothing.to_string(),
            Err(error) => error.to_string(),
        };
        let (pattern, speeds) = source.named_with_speeds(orbit);
        without.push(WithoutRow { pattern, speeds, reason });
    }
    let none = orbits.is_empty().then(|| no_orbit(engine, &family, &task.parameter, job)).transpose()?;
    Ok(EventFindings {
        none,
        event: task.event.name(),
        varied: task.parameter.clone(),
        start,
        orbits: orbits.len(),
        found,
        without,
    })
}

impl EventRow {
    fn of<S: OrbitSource>(found: &Located<S::Orbit>, parameter: &str, source: &S) -> Result<EventRow> {
        let at = [(parameter, found.parameter)];
        let AnalysedEvent { mut orbit, form } =
            source.analysed(&found.orbit, &at, Some(found.bifurcation))?;
        let (coefficient, criticality) = AnalysedEvent::form(form);
        let touch = match found.bifurcation {
            Bifurcation::Grazing => source.grazed(found)?,
            _ => None,
        };
        if let Some(touch) = &touch {
            orbit.residual = touch.residual;
            if !touch.sound {
                orbit.admissible = Judgement::No;
            }
        }
        let parameter = touch.as_ref().map_or(found.parameter, |touch| touch.parameter);
        let [gamma, e] = match touch.as_ref().and_then(|touch| touch.map) {
            Some(map) => map.map(Some),
            None => [None; 2],
        };
        Ok(EventRow {
            parameter,
            orbit,
            coefficient,
            criticality,
            stop: touch.as_ref().map(|touch| touch.stop.clone()),
            phase: touch.as_ref().map(|touch| touch.phase),
            acceleration: touch.as_ref().map(|touch| touch.acceleration),
            region: touch.and_then(|touch| touch.region),
            gamma,
            e,
            length: found.length,
        })
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
