//! What each key of a scene is a mass, a length or a force of, and whether what stands there is that.

use super::{
    keys::Entry,
    quantity::{Kinds, Scale, without_places},
};
use crate::{error::Result, quantity::Dimension};

/// What a key wants: of coordinates that are lengths, of such as are angles.
enum Wanted {
    /// One of these; both where the scene has several coordinates.
    Either([Dimension; 2]),
    /// A plain number.
    Plain,
    /// The dimension of the parameter that a key of the task names.
    Parameter(&'static str),
    /// Whatever there is.
    Anything,
    /// No unit at all.
    Nothing,
}

use Wanted::{Anything, Either, Nothing, Parameter, Plain};

const fn of(length: i32, time: i32, mass: i32) -> Dimension {
    Dimension::of(length, time, mass)
}

/// What does not depend on what coordinates are.
const fn always(dimension: Dimension) -> Wanted {
    Either([dimension, dimension])
}

const LENGTH: Wanted = Either([of(1, 0, 0), of(0, 0, 0)]);
const SPEED: Wanted = Either([of(1, -1, 0), of(0, -1, 0)]);
const FORCE: Wanted = Either([of(1, -2, 1), of(2, -2, 1)]);
const TIME: Wanted = always(of(0, 1, 0));
const FREQUENCY: Wanted = always(of(0, -1, 0));
const MASS: Wanted = Either([of(0, 0, 1), of(2, 0, 1)]);
const DAMPING: Wanted = Either([of(0, -1, 1), of(2, -1, 1)]);
const STIFFNESS: Wanted = Either([of(0, -2, 1), of(2, -2, 1)]);

/// What stands at a path without its places in lists.
fn wanted(path: &str) -> Wanted {
    match path {
        "system.period" | "system.measured.period" | "stops.measured.period" => TIME,
        "system.frequency" | "system.modes.frequencies" => FREQUENCY,
        "system.mass" | "system.mass.diagonal" => MASS,
        "system.damping" | "system.damping.diagonal" | "stops.damping" => DAMPING,
        "system.stiffness" | "system.stiffness.diagonal" | "stops.stiffness" => STIFFNESS,
        "system.cubic" => Either([of(-2, -2, 1), of(2, -2, 1)]),
        "system.force" | "system.forcing.cos" | "system.forcing.sin" => FORCE,
        "stops.law" | "friction.normal" => FORCE,
        "system.damping_ratio" | "system.modes.ratios" | "stops.restitution" => Plain,
        "friction.coefficient" | "friction.static_coefficient" => Plain,
        "stops.offset" | "stops.harmonics.cos" | "stops.harmonics.sin" => LENGTH,
        "friction.harmonics.cos" | "friction.harmonics.sin" | "accuracy.minimum_depth" => LENGTH,
        "stops.wear" => always(of(1, 2, -1)),
        "friction.speed" => SPEED,
        "stops.row" | "friction.row" | "events.of" | "system.modes.shapes" | "system.measured.direction" => {
            Anything
        }
        _ => of_task(path),
    }
}

fn of_task(path: &str) -> Wanted {
    let Some(path) = path.strip_prefix("tasks.") else {
        return if path.starts_with("parameters.") { Anything } else { Nothing };
    };
    if ["set.", "tolerance.", "cell."].iter().any(|table| path.starts_with(table)) {
        return Parameter("");
    }
    if ["monitors.", "levels.", "hold."].iter().any(|table| path.starts_with(table)) {
        return Anything;
    }
    match path {
        "range" | "values" | "bracket" | "from" | "to" | "margins" | "starts.at" => Parameter("parameter"),
        "branches.at" => Parameter("parameter"),
        "second_range" => Parameter("second"),
        "duration" => TIME,
        "minimum_depth" => LENGTH,
        "q.from" | "q.to" | "u.from" | "u.to" | "reach" => Anything,
        _ if path.ends_with("start.q") || path.ends_with("starts.q") || path.ends_with("attractor.q") => {
            LENGTH
        }
        _ if path.ends_with("start.u") || path.ends_with("starts.u") || path.ends_with("attractor.u") => {
            SPEED
        }
        _ if path.ends_with("orbit.start") || path.ends_with("orbits.start") => Anything,
        _ if path.ends_with("orbit.speed") || path.ends_with("orbits.speed") => SPEED,
        _ => Nothing,
    }
}

/// What is known of a scene's coordinates.
#[derive(Debug, Clone, Copy)]
pub(super) struct Coordinates {
    /// Whether there are several, of which each may be a length or an angle.
    pub several: bool,
    /// Whether the one is an angle, as its mass is a moment of inertia.
    pub turns: bool,
}

/// Checks all that was read with units against its keys. `name` is what a key of the task at a path names.
///
/// # Errors
/// An input error at the first key that wants something else.
pub(super) fn check(
    file: &Entry,
    found: &[(String, Dimension)],
    (scale, kinds): (&Scale, &Kinds),
    coordinates: Coordinates,
    name: &dyn Fn(&str, &str) -> Option<String>,
) -> Result<()> {
    for (path, dimension) in found {
        let short = without_places(path);
        let fits = |wanted: &[Dimension]| wanted.iter().any(|one| one.is_like(*dimension));
        let wanted = match wanted(&short) {
            Either([one, two]) if coordinates.several => match &short[..] {
                // Between a length and an angle.
                "system.mass" | "system.damping" | "system.stiffness" => {
                    vec![one, one.times(of(1, 0, 0)), two]
                }
                _ => vec![one, two],
            },
            Either([one, two]) => vec![if coordinates.turns { two } else { one }],
            Plain | Nothing => vec![Dimension::ONE],
            Anything => continue,
            Parameter(key) => {
                let name = match path.rsplit_once('.') {
                    Some((_, last)) if key.is_empty() => {
                        Some(last.split('[').next().unwrap_or(last).to_string())
                    }
                    _ => name(path, key),
                };
                let Some(name) = name else { continue };
                match kinds.get(&name) {
                    Some(known) => vec![*known],
                    None if fits(&[Dimension::ONE]) => continue,
                    None => {
                        let message = format!(
                            "is {dimension}, and {name} has no unit in [parameters]: give it one there"
                        );
                        return Err(file.at(path).fail(&message));
                    }
                }
            }
        };
        if fits(&wanted) {
            continue;
        }
        let mut each: Vec<String> = wanted
            .iter()
            .map(|one| match scale.name(*one) {
                unit if unit.is_empty() => one.to_string(),
                unit => format!("{one}, in {unit} or the like"),
            })
            .collect();
        each.dedup();
        return Err(file.at(path).fail(&format!("is {dimension}; here stands {}", each.join("; or "))));
    }
    Ok(())
}
