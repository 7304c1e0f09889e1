//! Monitors of a task `branch`: functions of an orbit and of the scene's parameters, as they are written, and
//! the values at which they are told or held.

use super::{
    expression::Expression,
    grammar::is_name,
    keys::{Entry, Scope, Value},
};
use crate::{
    continuation::{Bifurcation, Degeneracy},
    error::Result,
    formula::Formula,
    quantity::Dimension,
};

/// What a monitor may ask of an orbit, as `speed2` and `q1_max` without the number; each with the powers of
/// length, time and mass that it has where coordinates are lengths.
const QUANTITIES: [(&str, [i32; 3]); 9] = [
    ("period", [0, 1, 0]),
    ("speed", [1, -1, 0]),
    ("phase", [0, 0, 0]),
    ("impulse", [1, -1, 1]),
    ("multiplier", [0, 0, 0]),
    ("least_gap", [1, 0, 0]),
    ("swing", [1, 0, 0]),
    ("q_min", [1, 0, 0]),
    ("q_max", [1, 0, 0]),
];

/// A quantity of an orbit that a monitor asks for.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Asked {
    /// As it is written.
    pub word: String,
    /// Without the number.
    pub kind: &'static str,
    /// Of which impact, multiplier or coordinate, from 1, if it says that.
    pub number: Option<usize>,
    dimension: Dimension,
}

impl Asked {
    fn read(word: &str) -> Option<Asked> {
        let (digits, stem): (String, String) = word.chars().partition(char::is_ascii_digit);
        let &(kind, [length, time, mass]) = QUANTITIES.iter().find(|known| known.0 == stem)?;
        let number = if digits.is_empty() { None } else { Some(digits.parse().ok().filter(|n| *n > 0)?) };
        Some(Asked { word: word.to_string(), kind, number, dimension: Dimension::of(length, time, mass) })
    }
}

/// A function of an orbit.
#[derive(Debug, Clone, PartialEq)]
pub struct Monitor {
    /// Its name.
    pub name: String,
    /// In the scene's parameters, in their order, then in what is asked for.
    pub(crate) formula: Formula,
    /// What may stand in it.
    pub(crate) asked: Vec<Asked>,
}

/// The monitors of a task, in the order of the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Monitors(pub(crate) Vec<Monitor>);

/// Values of monitors, each with the monitor's name.
#[derive(Debug, Clone, PartialEq)]
pub struct Levels(pub Vec<(String, f64)>);

impl Value for Monitors {
    fn shape() -> String {
        "table of expressions".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        Ok(Monitors(
            entry.named()?.iter().map(|(name, entry)| Monitor::read(name, entry)).collect::<Result<_>>()?,
        ))
    }
}

impl Value for Levels {
    fn shape() -> String {
        "table of numbers, or lists of them".to_string()
    }

    /// Each in units of what its monitor is.
    fn read(entry: &Entry) -> Result<Self> {
        let mut all = Vec::new();
        for (name, list) in entry.named()? {
            let values = if list.item.is_array() { list.elements()? } else { vec![list] };
            for entry in values {
                let value = f64::read(&entry)?;
                let measured = entry.scope.seen.measured.borrow();
                let kind = |path: &str| measured.iter().find(|known| known.0 == path).map(|known| known.1);
                let task = entry.path.split('.').next().unwrap_or_default();
                if let (Some(own), Some(wanted)) =
                    (kind(&entry.path), kind(&format!("{task}.monitors.{name}")))
                    && !own.is_like(wanted)
                {
                    return Err(entry.fail(&format!("is {own}, and {name} is {wanted}")));
                }
                all.push((name.clone(), value));
            }
        }
        Ok(Levels(all))
    }
}

impl Monitor {
    fn read(name: &str, entry: &Entry) -> Result<Monitor> {
        let scope = entry.scope;
        let labels = Bifurcation::ALL.map(Bifurcation::name).into_iter();
        let mut taken = labels.chain(Degeneracy::ALL.map(Degeneracy::name));
        if !is_name(name) || taken.any(|known| known == name) {
            return Err(entry.fail(
                "the name of a monitor is a letter, then letters, digits and _, and no other label's",
            ));
        }
        let words = entry.text()?.split(|c: char| !c.is_alphanumeric() && c != '_');
        let mut asked: Vec<Asked> = Vec::new();
        for found in words.chain(QUANTITIES.map(|known| known.0)).filter_map(Asked::read) {
            if !asked.contains(&found) && !scope.names.contains(&found.word) {
                asked.push(found);
            }
        }
        let names: Vec<String> =
            scope.names.iter().chain(asked.iter().map(|one| &one.word)).cloned().collect();
        // Where coordinates may be angles, or nothing has units, dimensions are not known.
        let is_inertia = |known: &(String, Dimension)| {
            known.0.starts_with("system.mass") && known.1.is_like(Dimension::of(2, 0, 1))
        };
        let known = scope.seen.scaled.get() && !scope.seen.measured.borrow().iter().any(is_inertia);
        let kinds = asked.iter().filter(|_| known).map(|one| (one.word.clone(), one.dimension));
        let kinds =
            scope.quantities.map(|known| (known.0, known.1.clone().into_iter().chain(kinds).collect()));
        let quantities = kinds.as_ref().map(|(scale, kinds)| (*scale, kinds));
        let scope = Scope { source: scope.source.clone(), names: &names, quantities, ..*scope };
        let (path, item) = (entry.path.clone(), entry.item.clone());
        let formula = Expression::read(&Entry { scope: &scope, path, span: entry.span.clone(), item })?.root;
        Ok(Monitor { name: name.to_string(), formula, asked })
    }
}
