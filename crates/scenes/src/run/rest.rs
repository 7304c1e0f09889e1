//! Tasks of kind `rest`: periodic motions that rest on a stop.

use std::f64::consts::TAU;

use serde::Serialize;

use super::{
    Complex, Finding, Job, Judgement, Lines, Status,
    engine::{Engine, by_engine},
    orbit::{MissingRow, places, status},
    row,
};
use crate::{
    attractor::rest::{Flight, NoRest, RestOrbit, Resting, Rests},
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
        /// The stops that it rests on all the time.
        pub held: Vec<String>,
        /// The part of the time in which it rests.
        pub resting: f64,
        /// Impacts in a period, as far as they are followed one by one: those of a bounce lower than the
        /// minimum depth are left out.
        pub impacts: u64,
        /// The greatest speed of an impact, in the scene's units.
        pub fastest: f64,
        /// Whether motions near come to it, as the multipliers tell, but where a minimum of a gap, or the
        /// beginning of a rest, is not told from what ends it.
        pub stable: Judgement,
        /// The multipliers of largest modulus, at most four, the largest first. With one coordinate all
        /// are 0.
        pub multipliers: Vec<Complex>,
        /// Its displacements as the first of its rests ends; at phase 0 if none does.
        pub q: Vec<f64>,
        /// Its velocities there.
        pub u: Vec<f64>,
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
    /// Whether these are all periodic motions that rest, with no more than `periods` from a release to the
    /// next: with one coordinate and without dry friction. Else they are those that the search found.
    pub complete: bool,
    /// Periodic motions, by value, then by release.
    pub orbits: Vec<RestOrbitRow>,
    /// Releases, by value, then by stop and phase.
    pub releases: Vec<ReleaseRow>,
    /// Values without such a motion.
    pub(crate) missing: Vec<MissingRow>,
    /// How many values were asked for.
    #[serde(skip)]
    values: usize,
    /// What of a search could not be followed, by value.
    #[serde(skip)]
    unfollowed: Vec<String>,
}

/// A rest that lasts no longer than this part of the period may be none.
const SHORT: f64 = 1e-9;

impl Finding for RestFindings {
    fn status(&self) -> Status {
        status("periodic motion that rests", &self.missing, self.values)
    }

    fn warnings(&self) -> Vec<String> {
        self.unfollowed.clone()
    }

    fn lines(&self, lines: &mut Lines) {
        lines.say("complete", if self.complete { "yes" } else { "no, those that the search found" });
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
    let mut found = RestFindings {
        complete: true,
        orbits: Vec::new(),
        releases: Vec::new(),
        missing: Vec::new(),
        values: places.len(),
        unfollowed: Vec::new(),
    };
    job.monitor.begin(places.len() as u64, "values");
    for place in places {
        let value = place.map(|(_, value)| value);
        let RestsHere { complete, orbits, releases, none, unfollowed } = engine.rests(task, place)?;
        if orbits.is_empty() {
            found.missing.push(MissingRow { value, reason: none });
        }
        found.complete &= complete;
        let at = place.map_or_else(String::new, |(name, value)| format!(" (at {name} = {value})"));
        found.unfollowed.extend(unfollowed.map(|what| format!("{what}{at}")));
        found.orbits.extend(orbits.into_iter().map(|row| RestOrbitRow { value, ..row }));
        found.releases.extend(releases.into_iter().map(|row| ReleaseRow { value, ..row }));
        job.monitor.advance(1)?;
    }
    Ok(found)
}

/// What there is at one value of a parameter; the rows do not yet have it.
pub(crate) struct RestsHere {
    /// Whether these are all orbits.
    pub complete: bool,
    pub orbits: Vec<RestOrbitRow>,
    pub releases: Vec<ReleaseRow>,
    /// Why there are no orbits, if there are none.
    pub none: String,
    /// What of a search could not be followed.
    pub unfollowed: Option<String>,
}

/// All rests of a machine with one coordinate, its stops and its states being told so in the scene's units,
/// in which `rate` radians of the forcing are a unit of time.
///
/// # Errors
/// Those of [`Rests::of`].
pub(crate) fn all_rests(
    machine: &dyn Resting,
    names: &[String],
    rate: f64,
    task: &RestTask,
) -> Result<RestsHere> {
    let rests = Rests::of(machine, task.periods)?;
    let mut orbits: Vec<RestOrbitRow> =
        rests.orbits.iter().map(|orbit| orbit_row(machine, orbit, &rests, names, rate)).collect();
    orbits.extend(rests.for_ever.iter().map(|&stop| {
        let [place, speed] = machine.on(stop, 0.0);
        RestOrbitRow {
            period: 1,
            held: vec![names[stop].clone()],
            resting: 1.0,
            stable: Judgement::Yes,
            ..row_at([place, speed * rate])
        }
    }));
    let none = if orbits.is_empty() { none(&rests, names, task.periods) } else { String::new() };
    let all = rests.releases.iter().zip(&rests.flights);
    let releases = all.map(|(release, flight)| {
        let next = flight.next.ok().map(|next| rests.releases[next]);
        ReleaseRow {
            value: None,
            stop: names[release.stop].clone(),
            phase: release.phase / TAU,
            next_stop: next.map(|next| names[next.stop].clone()),
            next_phase: next.map(|next| next.phase / TAU),
            after: next.map(|_| flight.duration / TAU),
            impacts: flight.impacts,
            reason: flight.next.err().map(|why| reason(why, names, task.periods)),
        }
    });
    Ok(RestsHere { complete: true, orbits, releases: releases.collect(), none, unfollowed: None })
}

/// A row of a motion of one coordinate that is there, with that velocity, of which nothing else is known yet.
fn row_at([place, speed]: [f64; 2]) -> RestOrbitRow {
    RestOrbitRow {
        value: None,
        period: 0,
        stops: Vec::new(),
        released: Vec::new(),
        rested: Vec::new(),
        held: Vec::new(),
        resting: 0.0,
        impacts: 0,
        fastest: 0.0,
        stable: Judgement::Marginal,
        multipliers: vec![Complex(0.0, 0.0); 2],
        q: vec![place],
        u: vec![speed],
    }
}

fn orbit_row(
    machine: &dyn Resting,
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
        && before.iter().all(|[_, length]| is_rest(*length));
    let first = rests.releases[orbit.releases[0]];
    let [place, speed] = machine.on(first.stop, first.phase);
    RestOrbitRow {
        period: orbit.periods,
        stops: orbit.releases.iter().map(|&i| names[rests.releases[i].stop].clone()).collect(),
        released: orbit.releases.iter().map(|&i| rests.releases[i].phase / TAU).collect(),
        rested: before.iter().map(|[begin, _]| begin / TAU).collect(),
        resting: resting / orbit.periods as f64,
        impacts: flights.iter().map(|flight| flight.impacts).sum(),
        fastest: flights.iter().map(|flight| flight.fastest).fold(0.0, f64::max) * rate,
        stable: if clear { Judgement::Yes } else { Judgement::Marginal },
        ..row_at([place, speed * rate])
    }
}

/// Whether a rest so long, in radians, is one: it may end as it begins.
pub(crate) fn is_rest(length: f64) -> bool {
    length > SHORT * TAU
}

/// Why nothing rests periodically.
fn none(rests: &Rests, names: &[String], periods: u32) -> String {
    match rests.flights.first() {
        None => "nothing rests: no stop presses at any phase".into(),
        Some(flight) => match flight.next {
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
