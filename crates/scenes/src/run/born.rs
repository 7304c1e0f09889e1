//! What is born at a grazing, pattern by pattern: the local theory's verdicts, and the orbits of the true
//! system near by. Not here: all patterns together (`birth`).

use super::{
    Analysed, Complex, GrazingMap, Judgement,
    engine::{GrazingPoint, ResonantBirth},
    row,
};
use crate::{
    error::{Error, Result},
    many::elements::Short,
    pattern::{Pattern, PatternExistence, Report as Verdict},
    scene::orbits::GrazingTask,
};

row! {
    /// What the local theory says of an impact pattern, and the orbit of the true system near by, if it was
    /// looked for and found.
    pub struct BornRow {
        /// The pattern, in periods of the orbit that grazes.
        pub pattern: String,
        /// On which side of the bifurcation an orbit is born, or what is open.
        pub side: String,
        /// L: the large multiplier of one round of the pattern is L µ^{−m} to leading order, µ the parameter
        /// less its value at grazing.
        pub coefficient: Option<f64>,
        /// The parameter at which the orbit was looked for.
        pub found_at: Option<f64>,
        /// The phases of its impacts, as fractions of the period.
        pub phases: Option<Vec<f64>>,
        /// Their incoming relative speeds, in the scene's units.
        pub speeds: Option<Vec<f64>>,
        /// Its multipliers of largest modulus, at most four, the largest first.
        pub multipliers: Option<Vec<Complex>>,
        /// Whether it is stable: what is born at a grazing is mostly not, so not seen.
        pub stable: Option<Judgement>,
        /// Whether it is an orbit.
        pub admissible: Option<Judgement>,
        /// Why it is none, or why nothing is decided.
        pub reason: Option<String>,
    }
}

impl BornRow {
    /// Of a pattern of which nothing is known.
    fn open(pattern: &Pattern) -> BornRow {
        BornRow {
            pattern: pattern.to_string(),
            side: String::new(),
            coefficient: None,
            found_at: None,
            phases: None,
            speeds: None,
            multipliers: None,
            stable: None,
            admissible: None,
            reason: None,
        }
    }
}

/// A side of the bifurcation.
pub(super) fn side_of(at: &GrazingMap, above: bool, size: f64) -> String {
    format!("{} {} {}", at.varied, if above { '>' } else { '<' }, shown(at.parameter, size / at.map.e.abs()))
}

/// A row: what the local theory says of a pattern, and the orbit of the true system at the distance asked
/// for.
pub(super) fn born_at(
    task: &GrazingTask,
    (point, size): (&impl GrazingPoint, f64),
    at: &GrazingMap,
    pattern: &Pattern,
    verdict: &Verdict,
) -> Result<BornRow> {
    let reason = verdict.reason.map(|reason| reason.to_string());
    let mut row = BornRow { reason, ..BornRow::open(pattern) };
    let Some(side) = verdict.side() else {
        row.side = side_open(verdict).into();
        return Ok(row);
    };
    let distance = task.distance_at(size);
    let (periods, away) = (pattern.periods(), if side { distance } else { -distance } / at.map.e);
    row.coefficient =
        point.leading(periods, verdict).map(|leading| leading / at.map.e.powi(periods.len() as i32));
    row.side = side_of(at, away > 0.0, size);
    let parameter = match beside(&at.varied, at.parameter, away) {
        Ok(parameter) => parameter,
        Err(error) => return Ok(BornRow { reason: Some(error.to_string()), ..row }),
    };
    row.found_at = Some(parameter);
    match point.orbit(periods, verdict, parameter, away)? {
        Ok(Analysed { phases, speeds, multipliers, stable, admissible, reason, .. }) => {
            row.reason = row.reason.or(reason);
            (row.phases, row.speeds, row.multipliers) = (Some(phases), Some(speeds), Some(multipliers));
            (row.stable, row.admissible) = (Some(stable), Some(admissible));
        }
        Err(error) => row.reason = Some(error.to_string()),
    }
    Ok(row)
}

/// The same of one impact at a resonance, where that is known; no row if nothing is born.
pub(super) fn at_resonance(
    task: &GrazingTask,
    (point, size): (&impl GrazingPoint, f64),
    at: &GrazingMap,
    pattern: &Pattern,
    known: &ResonantBirth,
) -> Result<Option<BornRow>> {
    let ResonantBirth::Orbit { multiplier, speed } = *known else { return Ok(None) };
    let (distance, periods) = (task.distance_at(size), pattern.periods()[0] as u32);
    let away = -distance / at.map.e;
    let reason = format!(
        "u_{periods} = 0: its speed is like the root of the distance, both multipliers are {}",
        Short(multiplier)
    );
    let row = BornRow {
        side: side_of(at, away > 0.0, size),
        stable: Some(Judgement::Yes),
        reason: Some(reason),
        ..BornRow::open(pattern)
    };
    let parameter = match beside(&at.varied, at.parameter, away) {
        Ok(parameter) => parameter,
        Err(error) => return Ok(Some(BornRow { reason: Some(error.to_string()), ..row })),
    };
    let found = point.orbit_at_resonance((periods, speed), parameter, distance)?;
    let row = BornRow { found_at: Some(parameter), ..row };
    Ok(Some(match found {
        Ok(orbit) => BornRow {
            phases: Some(orbit.phases),
            speeds: Some(orbit.speeds),
            multipliers: Some(orbit.multipliers),
            admissible: Some(orbit.admissible),
            // It is one nearer to the touch.
            reason: row.reason.map(|known| match orbit.reason {
                Some(why) => format!("{known}; so far from the touch: {why}"),
                None => known,
            }),
            ..row
        },
        Err(error) => BornRow { reason: Some(error.to_string()), ..row },
    }))
}

/// The parameter at a distance from a grazing.
///
/// # Errors
/// A distance of which too little is left beside the parameter, rounded.
fn beside(name: &str, parameter: f64, away: f64) -> Result<f64> {
    let there = parameter + away;
    if ((there - parameter) / away - 1.0).abs() < 0.01 {
        return Ok(there);
    }
    let message = format!(
        "not looked for: in floating point {name} = {parameter:?} hardly changes by {away:e}, the task's `distance`: take a larger one"
    );
    Err(Error::input(message))
}

/// What of a pattern is open.
fn side_open(verdict: &Verdict) -> &'static str {
    match (verdict.plus, verdict.minus) {
        (PatternExistence::NoOrbit, _) => "open for e mu < 0",
        (_, PatternExistence::NoOrbit) => "open for e mu > 0",
        _ => "open",
    }
}

/// A parameter value for reading: rounding's leavings at 0 left out, of what moves the gap by the size of the
/// motion.
fn shown(value: f64, unit: f64) -> String {
    match value.abs() {
        size if unit.is_finite() && size <= 1e-14 * unit => "0".into(),
        size if (1e-3..1e9).contains(&size) => format!("{value:.6}"),
        _ => format!("{value:.6e}"),
    }
}
