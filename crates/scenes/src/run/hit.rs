//! How hard the motions that are seen beside a touch hit each stop, for the task `grazing`: each is followed
//! once round.

use num_rational::BigRational;

use super::{
    Job, SimulationFindings,
    engine::{Engine, by_engine},
    proved::StartOf,
    row, seen,
};
use crate::{
    attractor::touch::Seen,
    error::{Error, Result},
    scene::{
        orbits::GrazingTask,
        simulate::{SimulateTask, Start},
    },
};

row! {
    /// How a stop is hit by what is seen beside a touch.
    #[derive(Default)]
    pub struct HitRow {
        /// Where it is seen: `before` the touch, `beyond` it, or swept `back`.
        pub place: String,
        /// The value of the parameter.
        pub value: f64,
        /// Forcing periods of the motion that are followed: once round, or many of one that is not periodic.
        pub periods: u32,
        /// The stop.
        pub stop: Option<String>,
        /// Impacts there, or contacts.
        pub impacts: Option<u64>,
        /// The largest speed of an impact.
        pub fastest: Option<f64>,
        /// The largest impulse; absent for a stop that gives way.
        pub strongest: Option<f64>,
        /// The largest force of a stop that gives way.
        pub peak_force: Option<f64>,
        /// The energy that all of them took.
        pub dissipated: Option<f64>,
        /// Why nothing is told.
        pub reason: Option<String>,
    }
}

/// A state as a scene has it: its phase in radians, displacements, velocities per unit of time.
pub(crate) type StartNumbers = (f64, Vec<f64>, Vec<f64>);

/// The stops that are hit by each motion seen that has impacts.
///
/// # Errors
/// An interruption.
pub(super) fn hits<E: Engine>(
    seen: &Seen<StartOf<E>>,
    task: &GrazingTask,
    job: &Job,
    engine: &E,
) -> Result<Vec<HitRow>> {
    let mut rows = Vec::new();
    for (place, value, _, settled) in seen::sights(seen) {
        let Some(on) = settled.filter(|on| on.portrait.impacts > 0) else { continue };
        let periods = on.portrait.looked;
        let row = HitRow { place: place.into(), value, periods, ..HitRow::default() };
        let exact = BigRational::from_float(value);
        let there = exact.ok_or_else(|| Error::input("the parameter is not finite"));
        let there = there.and_then(|exact| job.with(&[(task.parameter.clone(), exact)]));
        let found = there.and_then(|job| followed(&job, engine.numbers(&on.start), periods));
        match found {
            Err(error) if error.is_interrupted() => return Err(error),
            Err(error) => rows.push(HitRow { reason: Some(error.to_string()), ..row }),
            Ok(found) => {
                rows.extend(found.stops.into_iter().filter(|stop| stop.impacts > 0).map(|stop| HitRow {
                    stop: Some(stop.stop),
                    impacts: Some(stop.impacts),
                    fastest: Some(stop.fastest),
                    strongest: stop.strongest,
                    peak_force: stop.peak_force,
                    dissipated: Some(stop.dissipated),
                    ..row.clone()
                }))
            }
        }
    }
    Ok(rows)
}

/// What a motion does in some periods.
fn followed(job: &Job, (t, q, u): StartNumbers, periods: u32) -> Result<SimulationFindings> {
    let start = Start::at(t, &q, &u)?;
    let task = SimulateTask { start, periods, duration: None, transient: 0, samples: 64 };
    by_engine!(job, engine => engine.simulate(&task, &mut ()))
}
