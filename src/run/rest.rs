//! Tasks of kind `rest`: periodic motions that rest on a stop.

use std::f64::consts::TAU;

use serde::Serialize;

use super::{
    Finding, Job, Judgement, Lines, Status,
    engine::{Engine, by_engine},
    orbit::{MissingRow, places, status},
    row,
};
use crate::{
    attractor::rest::{Flight, NoRest, RestOrbit, Rests},
    error::Result,
    scene::rest::RestTask,
};

row! {
    /// A periodic motion that rests.
    pub struct RestOrbitRow {
        /// The parameter's value, if the task goes through some.
        pub value: Option<f64>,
        /// Its period, in forcing periods.
        pub period: u64,
        /// The stops that it rests on, in order.
        pub stops: Vec<String>,
        /// The phases at which these let go, as fractions of the period.
        pub released: Vec<f64>,
        /// The phases at which its rests begin, the one before each release.
        pub rested: Vec<f64>,
        /// The part of the time in which it rests.
        pub resting: f64,
        /// Impacts in a period, as far as they are followed one by one: those of a bounce lower than the
        /// minimum depth are left out.
        pub impacts: u64,
        /// The greatest speed of an impact, in the scene's units.
        pub fastest: f64,
        /// Whether motions near come to it: they do, all multipliers being 0, but where a minimum of a gap,
        /// or the beginning of a rest, is not told from what ends it.
        pub stable: Judgement,
    }
}

row! {
    /// What becomes of a motion that a stop has let go.
    pub struct ReleaseRow {
        /// The parameter's value, if the task goes through some.
        pub value: Option<f64>,
        /// The stop.
        pub stop: String,
        /// When it lets go, as a fraction of the period.
        pub phase: f64,
        /// The stop of the next rest that ends.
        pub next_stop: Option<String>,
        /// When that lets go, as a fraction of the period.
        pub next_phase: Option<f64>,
        /// After how many periods.
        pub after: Option<f64>,
        /// Impacts on the way, as far as they are followed one by one.
        pub impacts: u64,
        /// Why there is no such rest.
        pub reason: Option<String>,
    }
}

/// The periodic motions that rest, and what follows each release.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RestFindings {
    /// Periodic motions, by value, then by release.
    pub orbits: Vec<RestOrbitRow>,
    /// Releases, by value, then by stop and phase.
    pub releases: Vec<ReleaseRow>,
    /// Values without such a motion.
    pub(crate) missing: Vec<MissingRow>,
    /// How many values were asked for.
    #[serde(skip)]
    values: usize,
}

/// A rest that lasts no longer than this part of the period may be none.
const SHORT: f64 = 1e-9;

impl Finding for RestFindings {
    fn status(&self) -> Status {
        status("periodic motion that rests", &self.missing, self.values)
    }

    fn lines(&self, lines: &mut Lines) {
        if !self.orbits.is_empty() {
            lines.table("orbits", &self.orbits);
        }
        if !self.releases.is_empty() {
            lines.table("releases", &self.releases);
        }
        if !self.missing.is_empty() {
            lines.table("missing", &self.missing);
        }
    }
}

/// Finds the periodic motions that rest, at each value of a parameter if there is one.
///
/// # Errors
/// Where the system is not defined; an interruption.
pub(crate) fn rest(task: &RestTask, job: &Job) -> Result<RestFindings> {
    by_engine!(job, engine => of(task, job, &engine))
}

fn of<E: Engine>(task: &RestTask, job: &Job, engine: &E) -> Result<RestFindings> {
    let places = places(task.parameter.as_deref(), &task.values);
    let mut found =
        RestFindings { orbits: Vec::new(), releases: Vec::new(), missing: Vec::new(), values: places.len() };
    job.monitor.begin(places.len() as u64, "values");
    for place in places {
        let value = place.map(|(_, value)| value);
        let (machine, names, rate) = engine.resting(place)?;
        let rests = Rests::of(machine.as_ref(), task.periods)?;
        if rests.orbits.is_empty() {
            found.missing.push(MissingRow { value, reason: none(&rests, &names, task.periods) });
        }
        let rows = rests.orbits.iter().map(|orbit| orbit_row(value, orbit, &rests, &names, rate));
        found.orbits.extend(rows);
        let all = rests.releases.iter().zip(&rests.flights);
        found.releases.extend(all.map(|(release, flight)| {
            let next = flight.next.ok().map(|next| rests.releases[next]);
            ReleaseRow {
                value,
                stop: names[release.stop].clone(),
                phase: release.phase / TAU,
                next_stop: next.map(|next| names[next.stop].clone()),
                next_phase: next.map(|next| next.phase / TAU),
                after: next.map(|_| flight.duration / TAU),
                impacts: flight.impacts,
                reason: flight.next.err().map(|why| reason(why, &names, task.periods)),
            }
        }));
        job.monitor.advance(1)?;
    }
    Ok(found)
}

fn orbit_row(
    value: Option<f64>,
    orbit: &RestOrbit,
    rests: &Rests,
    names: &[String],
    rate: f64,
) -> RestOrbitRow {
    let flights: Vec<&Flight> = orbit.releases.iter().map(|&i| &rests.flights[i]).collect();
    // The rest at the end of a flight is before the next release.
    let before: Vec<[f64; 2]> = (0..flights.len())
        .map(|i| flights[(i + flights.len() - 1) % flights.len()].rest.unwrap_or_default())
        .collect();
    let resting = before.iter().map(|[_, length]| length / TAU).sum::<f64>();
    let clear = flights.iter().all(|flight| flight.tangencies == 0)
        && before.iter().all(|[_, length]| *length > SHORT * TAU);
    RestOrbitRow {
        value,
        period: orbit.periods,
        stops: orbit.releases.iter().map(|&i| names[rests.releases[i].stop].clone()).collect(),
        released: orbit.releases.iter().map(|&i| rests.releases[i].phase / TAU).collect(),
        rested: before.iter().map(|[begin, _]| begin / TAU).collect(),
        resting: resting / orbit.periods as f64,
        impacts: flights.iter().map(|flight| flight.impacts).sum(),
        fastest: flights.iter().map(|flight| flight.fastest).fold(0.0, f64::max) * rate,
        stable: if clear { Judgement::Yes } else { Judgement::Marginal },
    }
}

/// Why nothing rests periodically.
fn none(rests: &Rests, names: &[String], periods: u32) -> String {
    let ever = rests.for_ever.first().map(|&stop| format!("stop {} presses at all phases", names[stop]));
    match (rests.flights.first(), ever) {
        (None, Some(ever)) => format!("nothing that rests is let go: {ever}"),
        (None, None) => "nothing rests: no stop presses at any phase".into(),
        (Some(flight), _) => match flight.next {
            Err(why) => format!(
                "no motion that a stop lets go comes back to its rest: {}",
                reason(why, names, periods)
            ),
            Ok(_) => "no motion that a stop lets go comes back to its rest".into(),
        },
    }
}

fn reason(why: NoRest, names: &[String], periods: u32) -> String {
    match why {
        NoRest::ForEver(stop) => format!("it rests on stop {} for ever", names[stop]),
        NoRest::Held => "it is not let go there: the stop presses least at that phase, to rounding".into(),
        NoRest::Late => format!("it does not come to rest within {periods} periods"),
        NoRest::Ended(end) => format!("it ended {}", end.why()),
    }
}
