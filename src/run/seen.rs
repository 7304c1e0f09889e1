//! What is seen at a grazing, beside what is born there: rows of the task `grazing`.

use super::row;
use crate::attractor::{
    diagram::Jump,
    portrait::Portrait,
    touch::{Beside, Seen},
};

row! {
    /// What attracts at a value of the parameter near a grazing, or on the way back from it.
    pub struct SeenRow {
        /// `before` the touch, where the gap of the orbit that grazes is open, `beyond` it, or swept `back`.
        pub place: String,
        /// The value of the parameter; on the way back the first one at which the motion has left.
        pub value: f64,
        /// `stays` near the orbit that grazes, or `jumps` from it; on the way back it `leaves`, or it still
        /// `stays` at the last value looked at; `lost`, if the motion leaves every bound.
        pub what: String,
        /// What is seen there.
        pub motion: Option<String>,
        /// Its least and greatest displacement; of a machine, the least and the greatest gap of the stop that
        /// is grazed.
        pub extent: Option<Vec<f64>>,
        /// The fastest impact on it.
        pub speed: Option<f64>,
    }
}

fn row(place: &str, value: f64, what: &str, portrait: Option<&Portrait>) -> SeenRow {
    SeenRow {
        place: place.into(),
        value,
        what: what.into(),
        motion: portrait.map(Portrait::words),
        extent: portrait.map(|portrait| portrait.extent.to_vec()),
        speed: portrait.and_then(|portrait| portrait.speed),
    }
}

/// What is seen, row by row.
pub(super) fn rows(seen: &Seen) -> Vec<SeenRow> {
    let beside = |place: &str, Beside { parameter, portrait, near }: &Beside| {
        let what = match (portrait, near) {
            (None, _) => "lost",
            (Some(_), true) => "stays",
            (Some(_), false) => "jumps",
        };
        row(place, *parameter, what, portrait.as_ref())
    };
    let mut rows = vec![beside("before", &seen.before), beside("beyond", &seen.beyond)];
    match (&seen.back, &seen.back_to) {
        (Some(Jump { left, after, .. }), _) => rows.push(row("back", *left, "leaves", Some(after))),
        (None, Some((value, last))) => rows.push(row("back", *value, "stays", last.as_ref())),
        (None, None) => {}
    }
    rows
}
