//! What is seen at a grazing, beside what is born there: rows of the task `grazing`.

use num_rational::BigRational;

use super::{
    AttractorProofs, Job,
    engine::Engine,
    proved::{Attractor, Proving, StartOf},
    row,
};
use crate::{
    attractor::{
        diagram::Jump,
        portrait::{OnAttractor, Portrait},
        touch::{Beside, Seen},
    },
    error::Result,
    scene::orbits::GrazingTask,
};

row! {
    /// What attracts at a value of the parameter near a grazing, or on the way back from it.
    pub struct SeenRow {
        /// `before` the touch, where the gap of the orbit that grazes is open, `beyond` it, swept `back`, or
        /// before it from `rest`, q = 0.
        pub place: String,
        /// The value of the parameter; on the way back the first one at which the motion has left; from rest
        /// the one farthest from the touch at which it hits, or the last one looked at.
        pub value: f64,
        /// `stays` near the orbit that grazes, or `jumps` from it; on the way back it `leaves`, or it still
        /// `stays` at the last value looked at; `lost`, if the motion leaves every bound. From rest it `hits`
        /// for ever at all values looked at from there to the touch, at some of them (`partly`), or is `free`
        /// at all; at none that is decided, and some are `open`.
        pub what: String,
        /// Where on the way back it leaves, what ends the motion that it was on, as the jump of a `diagram`
        /// has it; of one that is not periodic "seen": another start may leave a little before or after.
        pub ends: Option<&'static str>,
        /// What is seen there.
        pub motion: Option<String>,
        /// Its least and greatest displacement, where the engine is `one`.
        pub extent: Option<Vec<f64>>,
        /// Where it is `many`, the least and the greatest gap of the stop that is grazed.
        pub gap: Option<Vec<f64>>,
        /// The fastest impact on it.
        pub speed: Option<f64>,
    }
}

/// A place, the parameter there, what the motion does, what it is on.
pub(super) type Sight<'a, S> = (&'static str, f64, &'static str, Option<&'a OnAttractor<S>>);

/// What is seen, in order.
pub(super) fn sights<S>(seen: &Seen<S>) -> Vec<Sight<'_, S>> {
    let sides = [("before", &seen.before), ("beyond", &seen.beyond)];
    let beside = sides.map(|(place, Beside { parameter, settled, near })| {
        (place, *parameter, if *near { "stays" } else { "jumps" }, settled.as_ref())
    });
    let back = match (&seen.back, &seen.back_to) {
        (Some(Jump { left, after, .. }), _) => Some(("back", *left, "leaves", Some(after))),
        (None, Some((value, last))) => {
            let hits = |on: Option<&OnAttractor<S>>| on.is_some_and(|on| on.portrait.range.speed.is_some());
            let left = hits(seen.beyond.settled.as_ref()) && !hits(last.as_ref());
            Some(("back", *value, if left { "leaves" } else { "stays" }, last.as_ref()))
        }
        (None, None) => None,
    };
    beside.into_iter().chain(back).collect()
}

/// What is seen, row by row; of the gap or of the one displacement.
pub(super) fn rows<S>(seen: &Seen<S>, of_gap: bool) -> Vec<SeenRow> {
    let row = |(place, value, what, settled): Sight<S>| {
        let portrait = settled.map(|settled| &settled.portrait);
        let ends = portrait.map(|portrait| portrait.range.extent.to_vec());
        let (extent, gap) = if of_gap { (None, ends) } else { (ends, None) };
        SeenRow {
            place: place.into(),
            value,
            what: if settled.is_some() { what } else { "lost" }.into(),
            ends: seen.back.as_ref().filter(|_| what == "leaves").map(Jump::ends_in),
            motion: portrait.map(Portrait::words),
            extent,
            gap,
            speed: portrait.and_then(|portrait| portrait.range.speed),
        }
    };
    let from_rest = seen.rest.as_ref().map(|rest| {
        let what = match rest.hits {
            0 if rest.open > 0 => "open",
            0 => "free",
            hits if hits == rest.looked => "hits",
            _ => "partly",
        };
        ("rest", rest.parameter, what, Some(&rest.settled))
    });
    sights(seen).into_iter().chain(from_rest).map(row).collect()
}

/// What is proved of it.
///
/// # Errors
/// An interruption.
pub(super) fn proofs<E: Engine>(
    seen: &Seen<StartOf<E>>,
    task: &GrazingTask,
    job: &Job,
    engine: &E,
) -> Result<AttractorProofs> {
    let from_rest = seen.rest.as_ref().filter(|rest| rest.hits > 0);
    let from_rest = from_rest.map(|rest| ("rest", rest.parameter, "hits", Some(&rest.settled)));
    let all: Vec<Attractor<E>> = sights(seen)
        .into_iter()
        .chain(from_rest)
        .filter_map(|(place, value, _, settled)| Some((place, BigRational::from_float(value)?, settled?)))
        .collect();
    let proving = Proving { engine, task: &job.task.name, parameter: &task.parameter, look: &seen.look };
    proving.all(&all, job)
}
