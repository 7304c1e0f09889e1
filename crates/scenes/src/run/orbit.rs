//! Tasks of kind `orbit`: periodic orbits of a pattern.

use std::f64::consts::TAU;

use num_rational::BigRational;
use serde::Serialize;

use super::{
    Analysed, Complex, Finding, Job, Judgement, Lines, Status,
    engine::{Engine, by_engine},
    row,
};
use crate::{
    attractor::{NEUTRAL, dynamics::Dynamics, limit_cycle::limit_cycle},
    continuation::{OrbitSearch, SearchTally},
    error::Result,
    number::{Plain, Real},
    scene::{orbits::OrbitTask, simulate::Start},
};

row! {
    /// A solution of the pattern equations.
    pub struct OrbitRow {
        /// The parameter's value, if the task goes through some.
        pub value: Option<f64>,
        with {
            /// What is known of it.
            pub orbit: Analysed
        }
        /// The period of a limit cycle, in the scene's unit of time; of it `drift` is per this period.
        pub period: Option<f64>,
        /// Its impacts.
        pub impacts: Option<u64>,
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

/// What came of the starts of a search.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SearchRow {
    /// The parameter's value, if the task goes through some.
    pub value: Option<f64>,
    /// How many ended how.
    #[serde(flatten)]
    pub tally: SearchTally,
}

/// How a task ends that looks for something at so many values, or at the scene's own.
pub(super) fn status(what: &str, missing: &[MissingRow], values: usize) -> Status {
    match missing {
        [] => Status::Done,
        [MissingRow { value: None, reason }] => Status::nothing(reason.clone()),
        [first, ..] => Status::nothing(format!(
            "no {what} at {} of {values} values; at {}: {}",
            missing.len(),
            first.value.unwrap_or(f64::NAN),
            first.reason
        )),
    }
}

/// The values of a parameter that a task goes through, or the scene's own.
pub(super) fn places<'t>(parameter: Option<&'t str>, values: &[BigRational]) -> Vec<Option<(&'t str, f64)>> {
    let value = |value| Plain::ratio(value, &()).0;
    parameter.map_or_else(|| vec![None], |name| values.iter().map(|x| Some((name, value(x)))).collect())
}

/// The orbits that were found, and where there are none.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OrbitFindings {
    /// Solutions, by value, then by speed.
    pub orbits: Vec<OrbitRow>,
    /// Values without any.
    pub(crate) missing: Vec<MissingRow>,
    /// What came of the starts, by value.
    pub searches: Vec<SearchRow>,
    /// How many values were asked for.
    #[serde(skip)]
    values: usize,
}

impl Finding for OrbitFindings {
    fn status(&self) -> Status {
        status("solution", &self.missing, self.values)
    }

    fn lines(&self, lines: &mut Lines) {
        lines.table("orbits", &self.orbits);
        if !self.missing.is_empty() {
            lines.table("missing", &self.missing);
        }
        for SearchRow { value, tally } in self.searches.iter().filter(|row| row.tally.starts > 1) {
            let at = value.map_or(String::new(), |value| format!(" at {value}"));
            lines.say("search", format!("{}{at}", tally.told()));
        }
    }
}

/// Finds the orbits of a pattern, at each value of a parameter if there is one.
///
/// # Errors
/// Where the system is not defined; an interruption.
pub(crate) fn orbit(task: &OrbitTask, job: &Job) -> Result<OrbitFindings> {
    by_engine!(job, engine => of(task, job, &engine))
}

/// The limit cycle on which a motion settles.
fn cycle<E: Engine>(
    start: &Start,
    place: Option<(&str, f64)>,
    task: &OrbitTask,
    job: &Job,
    engine: &E,
) -> Result<OrbitRow> {
    let states = engine.states(std::slice::from_ref(start))?;
    let dynamics = engine.dynamics(&states, place, &[])?;
    let start = &engine.begun(&states)[0];
    let found = limit_cycle(&dynamics, start, task.transient, job.monitor)?;
    let largest = found.multipliers.first().map_or(0.0, |(re, im)| re.hypot(*im));
    let orbit = Analysed {
        pattern: "limit cycle".into(),
        phases: Vec::new(),
        speeds: Vec::new(),
        multipliers: found.multipliers.iter().take(4).map(|&one| Complex::from(one)).collect(),
        stable: match () {
            () if (largest - 1.0).abs() <= NEUTRAL => Judgement::Marginal,
            () if largest < 1.0 => Judgement::Yes,
            () => Judgement::No,
        },
        admissible: Judgement::Yes,
        reason: None,
        drift: dynamics.drift(&found.start, found.period)?,
        nearest_stop: None,
        least_gap: None,
        residual: found.residual,
        newton_steps: found.steps,
    };
    let period = Some(found.period / TAU * engine.unit_of_time(place)?);
    Ok(OrbitRow { value: None, orbit, period, impacts: Some(found.impacts) })
}

fn of<E: Engine>(task: &OrbitTask, job: &Job, engine: &E) -> Result<OrbitFindings> {
    let places = places(task.parameter.as_deref(), &task.values);
    let (mut orbits, mut missing, mut searches, values) = (Vec::new(), Vec::new(), Vec::new(), places.len());
    job.monitor.begin(values as u64, "values");
    for place in places {
        let value = place.map(|(_, value)| value);
        if let Some(start) = &task.cycle {
            match cycle(start, place, task, job, engine) {
                Ok(orbit) => orbits.push(OrbitRow { value, ..orbit }),
                Err(error) if error.is_interrupted() => return Err(error),
                Err(error) => missing.push(MissingRow { value, reason: error.to_string() }),
            }
            job.monitor.advance(1)?;
            continue;
        }
        let system = engine.system(place)?;
        match engine.orbits(&task.orbit, &system) {
            Ok(OrbitSearch { found, tally }) => {
                if found.is_empty() {
                    missing.push(MissingRow { value, reason: task.orbit.none(&tally) });
                }
                orbits.extend(found.iter().map(|orbit| OrbitRow {
                    value,
                    orbit: engine.analysed(orbit, &system),
                    period: None,
                    impacts: None,
                }));
                searches.push(SearchRow { value, tally });
            }
            Err(error) if error.is_interrupted() => return Err(error),
            Err(error) => missing.push(MissingRow { value, reason: error.to_string() }),
        }
        job.monitor.advance(1)?;
    }
    Ok(OrbitFindings { orbits, missing, searches, values })
}
