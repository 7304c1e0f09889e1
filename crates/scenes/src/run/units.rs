//! What the numbers of a report are in, by the names of its columns: the scene's units, where it has any, and
//! in a report for a reader the varied parameter in the unit in which it is written.
//! Not here: sentences of a touch (`told`), which are in SI units.

use crate::{
    quantity::Dimension,
    scene::{Kind, Scene, WrittenUnit},
};

/// What a column is: of coordinates that are lengths, or angles.
#[derive(Debug, Clone, Copy, PartialEq)]
enum What {
    Length,
    Speed,
    Acceleration,
    Force,
    Impulse,
    Energy,
    Time,
    Frequency,
    Volume,
    Wear,
    /// The parameter that the task varies, its second one.
    Parameter,
    Second,
}

use What::{
    Acceleration, Energy, Force, Frequency, Impulse, Length, Parameter, Second, Speed, Time, Volume, Wear,
};

/// Columns, in reports of these kinds and in their tables; in all where no kind is named.
const COLUMNS: &[(What, &[&str], &[&str])] = &[
    (Length, &[], &["extent", "gap", "least_gap", "largest_gap", "path", "minimum_depth"]),
    (Length, &[], &["extent_before", "extent_after", "gap_before", "gap_after"]),
    (Length, &["simulate"], &["q", "gap_change"]),
    (Length, &["rest"], &["q"]),
    (Length, &["response"], &["swing", "amplitude"]),
    (Length, &["crisis"], &["corner_q", "corner_gap", "offset"]),
    (Speed, &[], &["speed", "speeds", "fastest", "speed_before", "speed_after"]),
    (Speed, &["simulate"], &["u", "velocity"]),
    (Speed, &["rest"], &["u"]),
    (Speed, &["crisis"], &["corner_u"]),
    (Acceleration, &[], &["acceleration"]),
    (Force, &[], &["peak_force"]),
    (Force, &["simulate"], &["force", "residual", "bound"]),
    (Impulse, &[], &["strongest", "impulse"]),
    (Energy, &[], &["dissipated", "energy"]),
    (Time, &["simulate"], &["period", "time", "longest", "duration", "radius", "rest"]),
    (Frequency, &["simulate"], &["frequency"]),
    (Volume, &[], &["volume"]),
    (Wear, &["simulate"], &["rate"]),
    (
        Parameter,
        &["grazing"],
        &[
            "parameter",
            "start",
            "value",
            "found_at",
            "change",
            "touch",
            "touches",
            "end",
            "least",
            "most",
            "from_rest",
            "proved_at",
            "own_value",
            "near",
        ],
    ),
    (Parameter, &["event"], &["parameter", "start"]),
    (Parameter, &["crisis", "validate"], &["parameter"]),
    (Parameter, &["diagram", "response"], &["value", "from", "to", "stays", "left", "not_settled", "lost"]),
    (Parameter, &["diagram"], &["least", "most"]),
    (Parameter, &["response"], &["lower", "upper", "resonant", "floating"]),
    (Parameter, &["branch"], &["parameters", "from", "to", "lower", "upper"]),
    (Parameter, &["orbit", "rest"], &["value"]),
    (Parameter, &["map"], &["first"]),
    (Second, &["map"], &["second"]),
];

/// What a column is in.
#[derive(Debug, Clone, PartialEq)]
pub struct ColumnUnit {
    /// Its name.
    pub column: &'static str,
    /// The scene's unit for it.
    pub own: String,
    /// Of a parameter, the unit in which it is written.
    pub written: Option<WrittenUnit>,
}

/// What the columns of a task's report are in; nothing of a scene without units.
pub(super) fn columns(scene: &Scene, kind: &Kind) -> Vec<ColumnUnit> {
    let of = |what: What, column: &'static str| {
        // A monitor may be called like another column.
        if matches!(kind, Kind::BranchTask(task) if task.monitors.0.iter().any(|one| one.name == column)) {
            return None;
        }
        let written = match what {
            Parameter => kind.parameter().and_then(|name| scene.unit(name)),
            Second => kind.second().and_then(|name| scene.unit(name)),
            _ => None,
        };
        let own = match (what, written) {
            (Parameter | Second, None) => return None,
            // Of two parameters each point has both.
            (Parameter, _) if column == "parameters" && kind.second().is_some() => return None,
            (_, Some(unit)) => unit.own.clone(),
            _ => scene.unit_name(dimension(what, scene.turns)?)?,
        };
        Some(ColumnUnit { column, own, written: written.cloned() })
    };
    let is_of = |kinds: &[&str]| kinds.is_empty() || kinds.contains(&kind.word());
    let rows = COLUMNS.iter().filter(|(_, kinds, _)| is_of(kinds));
    rows.flat_map(|&(what, _, columns)| columns.iter().filter_map(move |column| of(what, column))).collect()
}

/// What a column is where coordinates are lengths, or angles; none where each may be either.
fn dimension(what: What, turns: Option<bool>) -> Option<Dimension> {
    let always = match what {
        Energy => Some(Dimension::of(2, -2, 1)),
        Time => Some(Dimension::of(0, 1, 0)),
        Frequency => Some(Dimension::of(0, -1, 0)),
        Volume => Some(Dimension::of(3, 0, 0)),
        Wear => Some(Dimension::of(3, -1, 0)),
        _ => None,
    };
    let moving = |turns: bool| {
        let place = if turns { Dimension::ANGLE } else { Dimension::of(1, 0, 0) };
        // A moment of force, a force.
        let push = if turns { Dimension::of(2, -2, 1) } else { Dimension::of(1, -2, 1) };
        let per_time = |n: i32| Dimension::of(0, -n, 0);
        Some(match what {
            Length => place,
            Speed => place.times(per_time(1)),
            Acceleration => place.times(per_time(2)),
            Force => push,
            Impulse => push.times(Dimension::of(0, 1, 0)),
            _ => return None,
        })
    };
    always.or_else(|| moving(turns?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_turns_has_angles_and_what_may_be_either_has_no_unit() {
        let name = |what, turns| dimension(what, turns).map(|dimension| dimension.to_string());
        assert_eq!(name(Speed, Some(false)).as_deref(), Some("a speed"));
        assert_eq!(name(Speed, Some(true)).as_deref(), Some("an angular frequency"));
        assert_eq!(name(Force, Some(true)).as_deref(), Some("an energy or a torque"));
        assert_eq!((name(Length, None), name(Time, None).as_deref()), (None, Some("a time")));
    }

    #[test]
    fn every_column_stands_once() {
        let mut all: Vec<(&str, &str)> = Vec::new();
        for (_, kinds, columns) in COLUMNS {
            let kinds = if kinds.is_empty() { &[""][..] } else { kinds };
            all.extend(kinds.iter().flat_map(|kind| columns.iter().map(move |column| (*kind, *column))));
        }
        let twice = |(kind, column): &&(&str, &str)| {
            all.iter().filter(|known| known.1 == *column && (known.0 == *kind || known.0.is_empty())).count()
                > 1
        };
        assert_eq!(all.iter().find(twice), None);
    }
}
