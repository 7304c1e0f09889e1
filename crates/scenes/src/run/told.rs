//! A touch in sentences: what it does there and after, how hard it hits, what changes it. The numbers are
//! those of the report, in the scene's names, and in SI units where the scene says what its units are; the
//! task's parameter is in the unit in which the scene has it.

use super::{BandRow, ChaosRow, GrazingMap, HitRow, InfluenceRow, Mark, SeenRow, Sentence, bands};
use crate::{
    many::elements::Short,
    scene::{WrittenUnit, units::SiUnits},
};

/// Most parameters that are named; the table has all.
const NAMED: usize = 3;

/// What is told in units.
#[derive(Clone, Copy)]
enum Dimension {
    Time,
    Speed,
    Impulse,
    Force,
    Energy,
}

use Dimension::{Energy, Force, Impulse, Speed, Time};

/// What a scene's numbers are in: its units, and whether its coordinates are angles, if that is known.
type Units = (Option<SiUnits>, Option<bool>);

/// A number in SI units, or without units as it stands.
fn told(x: f64, dimension: Dimension, (units, turns): Units) -> String {
    let Some(SiUnits { length, time, mass }) = units else { return Short(x).to_string() };
    let energy = mass * (length / time) * (length / time);
    let (factor, word) = match (dimension, turns) {
        (Time, _) => (time, "s"),
        (Energy, _) => (energy, "J"),
        (_, None) => return Short(x).to_string(),
        (Speed, Some(false)) => (length / time, "m/s"),
        (Impulse, Some(false)) => (mass * length / time, "N s"),
        (Force, Some(false)) => (mass * length / (time * time), "N"),
        (Speed, Some(true)) => (1.0 / time, "rad/s"),
        (Impulse, Some(true)) => (energy * time, "N m s"),
        (Force, Some(true)) => (energy, "N m"),
    };
    format!("{} {word}", Short(x * factor))
}

/// The parameter at a value, in the unit in which it was written.
fn parameter(at: &GrazingMap, value: f64, unit: Option<&WrittenUnit>) -> String {
    match unit {
        Some(unit) if !unit.text.is_empty() => {
            format!("{} = {} {}", at.varied, Short(unit.of(value)), unit.text)
        }
        _ => format!("{} = {}", at.varied, Short(value)),
    }
}

/// The value at which a motion that is not periodic is left, if one is.
fn loose(seen: &[SeenRow]) -> Option<f64> {
    seen.iter().find(|row| row.ends == Some("seen")).map(|row| row.value)
}

/// The same as [`parameter`], with few digits at the value that is `loose`.
fn parameter_about(at: &GrazingMap, value: f64, unit: Option<&WrittenUnit>, loose: Option<f64>) -> String {
    if loose != Some(value) {
        return parameter(at, value, unit);
    }
    let own = unit.map_or(value, |unit| unit.of(value));
    if own == 0.0 {
        return parameter(at, value, unit);
    }
    let rounded = format!("{own:.2e}").parse().map_or(value, |few: f64| few * value / own);
    format!("about {}", parameter(at, rounded, unit))
}

/// The sentences; `period` is that of the forcing; of the parameter the unit and the value in the scene.
pub(super) fn sentences(
    at: &GrazingMap,
    (period, units, unit, given): (f64, Units, Option<&WrittenUnit>, f64),
    (born, seen): (&[ChaosRow], &[SeenRow]),
    (bands, in_bands): (&[BandRow], Option<&str>),
    hits: &[HitRow],
) -> Vec<Sentence> {
    let loose = loose(seen);
    let value = |value: f64| parameter_about(at, value, unit, loose);
    let touch = first(at, &value(at.parameter), &told(at.phase * period, Time, units));
    let order = unit.and_then(|_| far(at, given, &value(given)));
    let apart = if seen.is_empty() { None } else { chaos(born, at.half, &value(at.parameter)) };
    // What is said of one begun at rest stands among the bands.
    let from_rest = bands.iter().any(|row| row.from_rest.is_some());
    let found = seen.iter().filter(|row| !(from_rest && row.place == "rest"));
    let told = |row: &SeenRow| [sight(&value(row.value), row), blows(hits, &row.place, units)];
    // A motion, how hard it hits, and how long it stays are one sentence.
    let one = |rows: &[&SeenRow]| sentence(rows.iter().flat_map(|row| told(row)).flatten());
    let found: Vec<&SeenRow> = found.collect();
    let found = found.chunk_by(|a, b| a.place == "beyond" && b.place == "back").filter_map(one);
    let found = found.chain(in_bands.map(String::from));
    [Some(touch), order, apart]
        .into_iter()
        .flatten()
        .map(|text| Mark::Located.of(text))
        .chain(found.map(|text| Mark::Seen.of(text)))
        .collect()
}

/// What Theorem 1 is about: of an oscillator with smooth forces and rigid stops it is proved for the equation
/// itself (`proofs/coq/Headline.v`), where the motion without impacts touches one stop, which is the only one
/// where a force is not linear.
pub(super) fn theorem(at: &GrazingMap) -> Option<Sentence> {
    let is_free = at.open.is_none() && !at.half && at.orbit.as_deref().is_none_or(|orbit| orbit == "free 1");
    (is_free && at.map.acceleration > 0.0 && at.map.e != 0.0 && at.map.gamma? != 0.0).then(|| {
        Mark::Located.in_detail(
            "That near the touch exactly one orbit is born of each pattern that is told with a side, on that side, and none of \
             it on the other, is a theorem about this equation: it asks that the acceleration of the gap is above 0 and that \
             gamma and the numbers that decide are not 0, which are located.",
        )
    })
}

/// What of it is about one impact in n periods at a resonance (`proofs/coq/StatementResonance.v`).
pub(super) fn resonance(n: u64) -> Sentence {
    Mark::Located.in_detail(format!(
        "Of one impact in {n} period{} u_{n} = 0: that exactly one such orbit is born, beyond the touch, and that it is \
         stable is a theorem about this equation, too; the touch is located.",
        if n == 1 { "" } else { "s" }
    ))
}

/// The bands in a sentence.
pub(super) fn of_bands(
    (bands, seen): (&[BandRow], &[SeenRow]),
    at: &GrazingMap,
    unit: Option<&WrittenUnit>,
) -> Option<String> {
    let loose = loose(seen);
    bands::sentence(bands, &|value| parameter_about(at, value, unit, loose))
}

fn first(at: &GrazingMap, value: &str, after: &str) -> String {
    let motion = match at.orbit.as_deref() {
        None | Some("free 1") => "the motion without impacts".to_string(),
        Some(orbit) => format!("the orbit {orbit}"),
    };
    format!(
        "At {value} {motion} touches stop {}, at the phase {} of the period, {after} after its beginning.",
        at.stop,
        Short(at.phase)
    )
}

/// A value that is this many times the touch, or the touch that many times it, is hardly meant.
pub(super) const FAR: f64 = 100.0;

/// What a value of another order of magnitude, as of another unit, is told.
fn far(at: &GrazingMap, given: f64, value: &str) -> Option<String> {
    let times = given / at.parameter;
    let is_far = times.is_finite() && times != 0.0 && !(1.0 / FAR..=FAR).contains(&times.abs());
    is_far.then(|| {
        let begin = format!("In the scene {value}, {} times the touch", Short(times));
        format!("{begin}: check that its unit, and those of masses, stiffnesses and gaps, are meant.")
    })
}

/// That the set that is born is not the one that is seen; of either side on which one is.
fn chaos(rows: &[ChaosRow], half: bool, touch: &str) -> Option<String> {
    let side = |row: &ChaosRow| {
        let entropy: f64 = row.entropy.as_ref().filter(|_| row.chaos == Some(true))?.parse().ok()?;
        let sign = if row.side.contains('<') { "<" } else { ">" };
        let at_least = if row.at_least { "at least " } else { "" };
        let side = touch.replacen('=', sign, 1);
        Some(format!("for {side}, of entropy {at_least}{}", Short(entropy)))
    };
    let sides: Vec<String> = rows.iter().filter_map(side).collect();
    if sides.is_empty() {
        return without_chaos(rows, touch);
    }
    Some(format!(
        "Chaos is born {} per {}. Born and seen are different sets: what is born exists, most of it unstable; what is \
         seen attracts.",
        sides.join(", and "),
        if half { "half period" } else { "period" }
    ))
}

/// That no such set is born, and on which side orbits are; none where that is not decided of a side.
fn without_chaos(rows: &[ChaosRow], touch: &str) -> Option<String> {
    let side = |row: &ChaosRow| {
        let sign = if row.side.contains('<') { "<" } else { ">" };
        let what = match row.entropy {
            _ if row.chaos != Some(false) => return None,
            Some(_) => "orbits, and no chaos",
            None => "nothing",
        };
        Some(format!("for {} {what}", touch.replacen('=', sign, 1)))
    };
    let sides: Vec<String> = rows.iter().map(side).collect::<Option<_>>()?;
    (!sides.is_empty()).then(|| format!("Born there: {}.", sides.join("; ")))
}

/// What is proved of both sides in one sentence; what is not proved stands for itself.
pub(super) fn together(all: impl Iterator<Item = Sentence>) -> Vec<Sentence> {
    let (proved, others): (Vec<Sentence>, Vec<Sentence>) = all.partition(|said| said.mark == Mark::Proved);
    let clauses = proved.iter().map(|said| {
        let mut letters = said.text.trim_end_matches('.').chars();
        let first = letters.next().map_or(String::new(), |first| first.to_lowercase().to_string());
        first + letters.as_str()
    });
    sentence(clauses).map(|text| Mark::Proved.of(text)).into_iter().chain(others).collect()
}

/// Clauses as a sentence, if there are any.
fn sentence(clauses: impl Iterator<Item = String>) -> Option<String> {
    let text = clauses.collect::<Vec<_>>().join("; ");
    let mut letters = text.chars();
    let first = letters.next()?;
    Some(format!("{}{}.", first.to_uppercase(), letters.as_str()))
}

/// What is seen at a value of the parameter, as a clause.
fn sight(value: &str, row: &SeenRow) -> Option<String> {
    let motion = row.motion.as_deref().unwrap_or("nothing that stays within bounds");
    Some(match (row.place.as_str(), row.what.as_str()) {
        ("before", "stays") if row.speed.is_none() => return None,
        ("before", "stays") => format!("just before, at {value}, it is {motion}"),
        ("before", "jumps") => {
            format!("already just before, at {value}, the motion jumps to another: {motion}")
        }
        ("beyond", "stays") => format!("just beyond, at {value}, it stays near: {motion}"),
        ("beyond", "jumps") => format!("just beyond, at {value}, it jumps to another motion: {motion}"),
        ("back", "leaves") => {
            format!("turned back, it stays on that until it leaves it at {value}: {motion}")
        }
        ("back", _) => format!("turned back, it is still on that at {value}"),
        ("rest", "hits") => {
            let at = "at all values looked at";
            format!("begun at rest, at q = 0, it is seen to hit for ever {at} from {value} on: {motion}")
        }
        ("rest", "partly") => {
            let at = "at some of the values looked at";
            format!("begun at rest, at q = 0, it is seen to hit for ever {at} from {value} on, there: {motion}")
        }
        ("rest", "free") => {
            "begun at rest, at q = 0, it is seen to hit for ever at none of the values looked at before the touch"
                .into()
        }
        ("rest", _) => {
            "begun at rest, at q = 0, it is not decided at some values before the touch whether it hits for ever"
                .into()
        }
        (place, _) => format!("{place} the touch, at {value}, the motion leaves every bound"),
    })
}

/// How hard what is seen at a place hits, as a clause.
fn blows(hits: &[HitRow], place: &str, units: Units) -> Option<String> {
    let each: Vec<String> = hits
        .iter()
        .filter(|row| row.place == place)
        .filter_map(|row| {
            let (stop, fastest) = (row.stop.as_ref()?, row.fastest?);
            let mut text =
                format!("stop {stop} is hit with a speed of up to {}", told(fastest, Speed, units));
            if let Some(impulse) = row.strongest {
                text += &format!(", an impulse of up to {}", told(impulse, Impulse, units));
            }
            if let Some(force) = row.peak_force {
                text += &format!(", a force of up to {}", told(force, Force, units));
            }
            if let Some(energy) = row.dissipated {
                let periods =
                    if row.periods == 1 { "a period".into() } else { format!("{} periods", row.periods) };
                text += &format!(", which takes the energy {} in {periods}", told(energy, Energy, units));
            }
            Some(text)
        })
        .collect();
    (!each.is_empty()).then(|| each.join("; "))
}

/// What moves the touch; none where it was not asked for. Of the parameter the unit.
pub(super) fn influences(
    rows: &[InfluenceRow],
    at: &GrazingMap,
    unit: Option<&WrittenUnit>,
) -> Option<Sentence> {
    let text = |row: &InfluenceRow| {
        let (percent, change) = (row.percent, row.change?);
        if change == 0.0 {
            return None;
        }
        let by = percent.map_or_else(|| Short(change).to_string(), |percent| format!("{} %", Short(percent)));
        let sign = if by.starts_with('-') { "" } else { "+" };
        let value = |value: Option<f64>| Some(parameter(at, value?, unit));
        let far = value(row.less).zip(value(row.more));
        let far = far.map(|(less, more)| format!("; {less} with ten less, {more} with ten more"));
        Some(format!("{} ({sign}{by}{})", row.parameter, far.unwrap_or_default()))
    };
    let all: Vec<String> = rows.iter().filter_map(text).collect();
    if all.is_empty() {
        return (!rows.is_empty())
            .then(|| Mark::Located.of("No parameter of the scene is known to move the touch."));
    }
    let most = all.iter().take(NAMED).cloned().collect::<Vec<_>>().join(", ");
    Some(Mark::Located.of(format!("One per cent more of a parameter moves the touch most by: {most}.")))
}
