//! A touch in sentences: what it does there and after, how hard it hits, what changes it. The numbers are
//! those of the report, in the scene's names and units.

use super::{GrazingMap, HitRow, InfluenceRow, SeenRow};
use crate::many::elements::Short;

/// Most parameters that are named; the table has all.
const NAMED: usize = 3;

/// The sentences; `period` is that of the forcing.
pub(super) fn sentences(
    at: &GrazingMap,
    period: f64,
    seen: &[SeenRow],
    hits: &[HitRow],
    influence: &[InfluenceRow],
) -> String {
    let mut all = vec![first(at, period)];
    for row in seen {
        all.extend(sight(at, row));
        all.extend(blows(hits, &row.place));
    }
    all.extend(influences(influence));
    all.join(" ")
}

fn first(at: &GrazingMap, period: f64) -> String {
    let motion = match at.orbit.as_deref() {
        None | Some("free 1") => "the motion without impacts".to_string(),
        Some(orbit) => format!("the orbit {orbit}"),
    };
    format!(
        "At {} = {} {motion} touches stop {}, at the phase {} of the period, {} after its beginning.",
        at.varied,
        Short(at.parameter),
        at.stop,
        Short(at.phase),
        Short(at.phase * period)
    )
}

fn sight(at: &GrazingMap, row: &SeenRow) -> Option<String> {
    let value = format!("{} = {}", at.varied, Short(row.value));
    let motion = row.motion.as_deref().unwrap_or("nothing that stays within bounds");
    Some(match (row.place.as_str(), row.what.as_str()) {
        ("before", "stays") if row.speed.is_none() => return None,
        ("before", "stays") => format!("Just before, at {value}, it is {motion}."),
        ("before", "jumps") => {
            format!("Already just before, at {value}, the motion jumps to another: {motion}.")
        }
        ("beyond", "stays") => format!("Just beyond, at {value}, it stays near: {motion}."),
        ("beyond", "jumps") => format!("Just beyond, at {value}, it jumps to another motion: {motion}."),
        ("back", "leaves") => {
            format!("Turned back, it stays on that until it leaves it at {value}: {motion}.")
        }
        ("back", _) => format!("Turned back, it is still on that at {value}."),
        (place, _) => format!("{place} the touch, at {value}, the motion leaves every bound."),
    })
}

/// How hard what is seen at a place hits.
fn blows(hits: &[HitRow], place: &str) -> Option<String> {
    let each: Vec<String> = hits
        .iter()
        .filter(|row| row.place == place)
        .filter_map(|row| {
            let (stop, fastest) = (row.stop.as_ref()?, row.fastest?);
            let mut text = format!("stop {stop} is hit with a speed of up to {}", Short(fastest));
            if let Some(impulse) = row.strongest {
                text += &format!(", an impulse of up to {}", Short(impulse));
            }
            if let Some(force) = row.peak_force {
                text += &format!(", a force of up to {}", Short(force));
            }
            if let Some(energy) = row.dissipated {
                let periods =
                    if row.periods == 1 { "a period".into() } else { format!("{} periods", row.periods) };
                text += &format!(", which takes the energy {} in {periods}", Short(energy));
            }
            Some(text)
        })
        .collect();
    (!each.is_empty()).then(|| format!("There {}.", each.join("; ")))
}

fn influences(rows: &[InfluenceRow]) -> Option<String> {
    let text = |row: &InfluenceRow| {
        let (percent, change) = (row.percent, row.change?);
        if change == 0.0 {
            return None;
        }
        let by = percent.map_or_else(|| Short(change).to_string(), |percent| format!("{} %", Short(percent)));
        let sign = if by.starts_with('-') { "" } else { "+" };
        Some(format!("{} ({sign}{by})", row.parameter))
    };
    let all: Vec<String> = rows.iter().filter_map(text).collect();
    if all.is_empty() {
        return (!rows.is_empty())
            .then(|| "No parameter of the scene is known to move the touch.".to_string());
    }
    let most = all.iter().take(NAMED).cloned().collect::<Vec<_>>().join(", ");
    Some(format!("One per cent more of a parameter moves the touch most by: {most}."))
}
