//! What motions do over a parameter, in three bands: rows of the tasks `grazing` and `diagram`.
//!
//! The end at the touch is a root, enclosed where that can be had. That beyond it each motion hits for ever
//! is an argument, of machines whose forces are linear alone: the motion without impacts attracts, so one
//! that hits no more would tend to it, which passes through the stop. Of others there may be a second such
//! motion, and there are no bands. The other end is what motions that were followed have shown. What is
//! proved is that a motion hits, where a certificate says so. A `diagram` tells what it saw: from several
//! starts, or on both ways of a sweep.

use super::{AttractorProofs, GrazingMap, Lines, row};
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
        /// What is known of the least value: `enclosed`, between the values of `touch`; `located` as a root
        /// in floats; `seen` by following motions; `open`, as far as was looked.
        pub least_by: Option<String>,
        /// What is known of the greatest.
        pub most_by: Option<String>,
        /// The value, the farthest from the touch, from which on one begun at rest is seen to hit for ever,
        /// at all values looked at up to the touch.
        pub from_rest: Option<f64>,
        /// A value in the band at which a certificate proves that a motion hits for ever.
        pub proved_at: Option<f64>,
        /// How many motions were followed, where they decide.
        pub starts: Option<u32>,
        /// Of how many it was not decided what they lead to.
        pub open: Option<u32>,
    }
}

row! {
    /// What the motions do that are seen at neighbouring values of a diagram.
    pub struct DiagramBandRow {
        /// `free`, where none of them hits; `depends`, where one does and another does not, so that it
        /// depends on how it is begun; `hits`, where each does.
        pub band: &'static str,
        /// The least value.
        pub least: f64,
        /// The greatest.
        pub most: f64,
        /// How many values.
        pub values: usize,
    }
}

/// An end of a band, and what is known of it.
type End = Option<(f64, &'static str)>;

/// The bands, coming from where nothing hits; none where it was not looked. The touch may be enclosed.
pub(super) fn rows<S>(
    at: &GrazingMap,
    enclosed: bool,
    seen: &Seen<S>,
    proofs: Option<&AttractorProofs>,
) -> Option<Vec<BandRow>> {
    let Hitting { left, stays, starts, open, .. } = seen.hitting?;
    let touch = Some((at.parameter, if enclosed { "enclosed" } else { "located" }));
    let rises = at.map.e < 0.0;
    let all = seen.rest.as_ref().filter(|rest| rest.hits > 0 && rest.hits == rest.looked);
    let proved: Vec<f64> = proofs.map_or_else(Vec::new, AttractorProofs::hitting);
    let row = |band: &str, from: End, to: End, known: Option<[u32; 2]>| {
        let [least, most] = if rises { [from, to] } else { [to, from] };
        let part = |end: End| end.map(|end| end.0 / at.parameter).filter(|part| part.is_finite());
        let by = |end: End| end.map(|end| end.1.to_string());
        let inside = |value: &&f64| {
            least.is_none_or(|end| **value >= end.0) && most.is_none_or(|end| **value <= end.0)
        };
        BandRow {
            band: band.into(),
            least: least.map(|end| end.0),
            most: most.map(|end| end.0),
            least_part: part(least),
            most_part: part(most),
            least_by: by(least),
            most_by: by(most),
            from_rest: all.map(|rest| rest.parameter).filter(|_| band == DEPENDS),
            proved_at: proved.iter().find(inside).copied(),
            starts: known.map(|known| known[0]),
            open: known.map(|known| known[1]),
        }
    };
    let looked = Some([starts, open + seen.rest.as_ref().map_or(0, |rest| rest.open)]);
    let hits = row(HITS, touch, None, None);
    Some(match left {
        None => vec![row(FREE, None, touch, looked), hits],
        Some(far) if stays => vec![row(DEPENDS, Some((far, "open")), touch, looked), hits],
        Some(left) => {
            let left = Some((left, "seen"));
            vec![row(FREE, None, left, looked), row(DEPENDS, left, touch, looked), hits]
        }
    })
}

const FREE: &str = "free";
const DEPENDS: &str = "depends";
const HITS: &str = "hits";

impl DiagramBandRow {
    /// The bands over ascending values, each with whether the motions seen there hit; none where one of them
    /// is lost or not settled.
    pub(super) fn all(values: impl Iterator<Item = (f64, Option<Vec<bool>>)>) -> Vec<DiagramBandRow> {
        let mut rows: Vec<DiagramBandRow> = Vec::new();
        let mut last = None;
        for (value, hits) in values {
            let band = hits.filter(|hits| !hits.is_empty()).map(|hits| {
                match (hits.contains(&true), hits.contains(&false)) {
                    (true, true) => DEPENDS,
                    (true, false) => HITS,
                    (false, _) => FREE,
                }
            });
            match (band, rows.last_mut().filter(|_| band == last)) {
                (Some(_), Some(row)) => (row.most, row.values) = (value, row.values + 1),
                (Some(band), None) => {
                    rows.push(DiagramBandRow { band, least: value, most: value, values: 1 })
                }
                (None, _) => {}
            }
            last = band;
        }
        rows
    }

    /// The same in a sentence.
    pub(super) fn say(rows: &[DiagramBandRow], varied: &str, lines: &mut Lines) {
        let one = |DiagramBandRow { band, least, most, .. }: &DiagramBandRow| {
            let [from, to] = [least, most].map(|end| lines.told("least", *end));
            let at = if least == most {
                format!("at {varied} = {from}")
            } else {
                format!("for {varied} from {from} to {to}")
            };
            let what = match *band {
                FREE => "no motion that was seen hits for ever",
                DEPENDS => "it depends on how it is begun whether it hits for ever",
                _ => "each motion that was seen hits for ever",
            };
            format!("{at} {what}")
        };
        let said = rows.iter().map(one).collect::<Vec<_>>().join("; ");
        if !said.is_empty() {
            lines.say("seen", format!("Of the values looked at, {said}."));
        }
    }
}

/// The same in a sentence; `value` says what the parameter is at a value.
pub(super) fn sentence(rows: &[BandRow], value: &dyn Fn(f64) -> String) -> Option<String> {
    let first = rows.first()?;
    let [starts, open] = [first.starts?, first.open?];
    let left = if open > 0 { format!(", of {open} of which it is not decided") } else { String::new() };
    let none = format!("No motion that hits for ever was found, of {starts} that were followed{left},");
    let depends = rows.iter().find(|row| row.band == DEPENDS);
    let mut how = String::from("it depends on how it is begun");
    if let Some(from) = depends.and_then(|row| row.from_rest) {
        how += &format!(": from rest, at q = 0, it is seen to hit for ever from {} on", value(from));
    }
    if let Some(at) = depends.and_then(|row| row.proved_at) {
        how += &format!(", and at {} a motion that does is proved", value(at));
    }
    let beyond = "beyond the touch, where the motion without impacts is gone, it always hits";
    Some(match (first.band.as_str(), rows.len(), first.least, first.most) {
        (FREE, 3, None, Some(end)) | (FREE, 3, Some(end), None) => format!(
            "{none} {} {}; between there and the touch {how}; {beyond}.",
            if first.least.is_none() { "below" } else { "above" },
            value(end)
        ),
        (FREE, ..) => format!("{none} before the touch; {beyond}."),
        (.., least, most) => {
            let far = if first.least_by.as_deref() == Some("open") { least? } else { most? };
            format!("As far as was looked, to {}, {how}; {beyond}.", value(far))
        }
    })
}
