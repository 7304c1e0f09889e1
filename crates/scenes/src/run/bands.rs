//! What motions do over the parameter of a touch, in three bands: rows of the task `grazing`.
//!
//! The end at the touch is a root. That beyond it each motion hits for ever is an argument, of machines whose
//! forces are linear alone: the motion without impacts attracts, so one that hits no more would tend to it,
//! which passes through the stop. Of others there may be a second such motion, and there are no bands. The
//! other end is what motions that were followed have shown.

use super::{GrazingMap, row};
use crate::attractor::{hitting::Hitting, touch::Seen};

row! {
    /// What motions do between two values of the parameter.
    pub struct BandRow {
        /// `free`, where no motion was found that hits for ever; `depends`, where one was, beside the motion
        /// without impacts, so that it depends on how it is begun; `hits`, where each hits for ever, as long
        /// as the motion without impacts would pass through a stop.
        pub band: String,
        /// The least value; none where no end was looked for.
        pub least: Option<f64>,
        /// The greatest.
        pub most: Option<f64>,
        /// The least value over that at the touch, unless this is 0.
        pub least_part: Option<f64>,
        /// The greatest over it.
        pub most_part: Option<f64>,
        /// What is known of the least value: `located` as a root, `seen` by following motions, or `open`: it
        /// is as far as was looked.
        pub least_by: Option<String>,
        /// What is known of the greatest.
        pub most_by: Option<String>,
        /// How many motions were followed, where they decide.
        pub starts: Option<u32>,
        /// Of how many it was not decided what they lead to.
        pub open: Option<u32>,
    }
}

/// An end of a band, and what is known of it.
type End = Option<(f64, &'static str)>;

/// The bands, coming from where nothing hits; none where it was not looked.
pub(super) fn rows<S>(at: &GrazingMap, seen: &Seen<S>) -> Option<Vec<BandRow>> {
    let Hitting { left, stays, starts, open, .. } = seen.hitting?;
    let (touch, rises) = (Some((at.parameter, "located")), at.map.e < 0.0);
    let row = |band: &str, from: End, to: End, known: Option<[u32; 2]>| {
        let [least, most] = if rises { [from, to] } else { [to, from] };
        let part = |end: End| end.map(|end| end.0 / at.parameter).filter(|part| part.is_finite());
        let by = |end: End| end.map(|end| end.1.to_string());
        BandRow {
            band: band.into(),
            least: least.map(|end| end.0),
            most: most.map(|end| end.0),
            least_part: part(least),
            most_part: part(most),
            least_by: by(least),
            most_by: by(most),
            starts: known.map(|known| known[0]),
            open: known.map(|known| known[1]),
        }
    };
    let looked = Some([starts, open + seen.rest.as_ref().map_or(0, |rest| rest.open)]);
    let hits = row("hits", touch, None, None);
    Some(match left {
        None => vec![row("free", None, touch, looked), hits],
        Some(far) if stays => vec![row("depends", Some((far, "open")), touch, looked), hits],
        Some(left) => {
            let left = Some((left, "seen"));
            vec![row("free", None, left, looked), row("depends", left, touch, looked), hits]
        }
    })
}

/// The same in a sentence; `value` says what the parameter is at a value.
pub(super) fn sentence(rows: &[BandRow], value: &dyn Fn(f64) -> String) -> Option<String> {
    let first = rows.first()?;
    let [starts, open] = [first.starts?, first.open?];
    let left = if open > 0 { format!(", of {open} of which it is not decided") } else { String::new() };
    let none = format!("No motion that hits for ever was found, of {starts} that were followed{left},");
    let beyond = "beyond the touch, where the motion without impacts is gone, it always hits";
    Some(match (first.band.as_str(), rows.len(), first.least, first.most) {
        ("free", 3, None, Some(end)) | ("free", 3, Some(end), None) => format!(
            "{none} {} {}; between there and the touch it depends on how it is begun; {beyond}.",
            if first.least.is_none() { "below" } else { "above" },
            value(end)
        ),
        ("free", ..) => format!("{none} before the touch; {beyond}."),
        (.., least, most) => {
            let far = if first.least_by.as_deref() == Some("open") { least? } else { most? };
            format!(
                "As far as was looked, to {}, it depends on how it is begun whether it hits for ever; {beyond}.",
                value(far)
            )
        }
    })
}
