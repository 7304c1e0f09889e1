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

/// What a monitor may ask of an orbit: of an impact or a coordinate counted from 0, or of all.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Quantity {
    /// How long it is.
    Period,
    /// Its least gap away from impacts.
    LeastGap,
    /// The speed of an impact, or the greatest.
    Speed(Option<usize>),
    /// The phase of an impact, a fraction of the forcing period.
    Phase(usize),
    /// The impulse of an impact, or the sum.
    Impulse(Option<usize>),
    /// The modulus of a multiplier, the largest first.
    Multiplier(usize),
    /// The least, the greatest displacement of a coordinate, or half of what is between them.
    Extent(Option<usize>, Extent),
}

/// What of a coordinate's extent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Extent {
    Least,
    Greatest,
    Swing,
}

/// The columns of a branch's table.
pub(crate) const COLUMNS: [&str; 19] = [
    "branch",
    "label",
    "parameters",
    "pattern",
    "phases",
    "speeds",
    "multipliers",
    "stable",
    "admissible",
    "reason",
    "drift",
    "nearest_stop",
    "least_gap",
    "residual",
    "newton_steps",
    "coefficient",
    "criticality",
    "length",
    "certificate",
];

/// Names without a number.
const PLAIN: [&str; 9] =
    ["period", "speed", "phase", "impulse", "multiplier", "least_gap", "swing", "q_min", "q_max"];

impl Quantity {
    /// The one that a word names, as `speed`, `speed2`, `q1_max`.
    fn named(word: &str) -> Option<Quantity> {
        let (stem, end) = match word.split_once('_') {
            Some((stem, end @ ("min" | "max"))) => (stem, end),
            _ => (word, ""),
        };
        let base = stem.trim_end_matches(|c: char| c.is_ascii_digit());
        let number = match &stem[base.len()..] {
            "" => None,
            digits => Some(digits.parse::<usize>().ok()?.checked_sub(1)?),
        };
        Some(match (base, end) {
            ("q", "min") => Quantity::Extent(number, Extent::Least),
            ("q", "max") => Quantity::Extent(number, Extent::Greatest),
            ("swing", "") => Quantity::Extent(number, Extent::Swing),
            ("speed", "") => Quantity::Speed(number),
            ("impulse", "") => Quantity::Impulse(number),
            ("phase", "") => Quantity::Phase(number.unwrap_or(0)),
            ("multiplier", "") => Quantity::Multiplier(number.unwrap_or(0)),
            ("period", "") if number.is_none() => Quantity::Period,
            ("least_gap", "") => Quantity::LeastGap,
            _ => return None,
        })
    }

    /// What it is, of coordinates that are lengths.
    fn dimension(self) -> Dimension {
        match self {
            Quantity::Period => Dimension::of(0, 1, 0),
            Quantity::LeastGap | Quantity::Extent(..) => Dimension::of(1, 0, 0),
            Quantity::Speed(_) => Dimension::of(1, -1, 0),
            Quantity::Impulse(_) => Dimension::of(1, -1, 1),
            Quantity::Phase(_) | Quantity::Multiplier(_) => Dimension::ONE,
        }
    }
}

/// A function of an orbit.
#[derive(Debug, Clone, PartialEq)]
pub struct Monitor {
    /// Its name.
    pub name: String,
    /// In the scene's parameters, in their order, then in `quantities`.
    pub(crate) formula: Formula,
    /// What it is, where that is known.
    pub(crate) dimension: Option<Dimension>,
    /// What it asks of an orbit, with the names.
    pub(crate) quantities: Vec<(String, Quantity)>,
}

/// The monitors of a task, in the order of the file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Monitors(pub(crate) Vec<Monitor>);

/// Values of monitors that are told, each with the monitor's name.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Levels(pub(crate) Vec<(String, f64)>);

/// A monitor's name, and the value that it keeps.
#[derive(Debug, Clone, PartialEq)]
pub struct Hold(pub String, pub f64);

impl Value for Monitors {
    fn shape() -> String {
        "table of expressions".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        let one = |(name, entry): &(String, Entry)| Monitor::read(name, entry);
        Ok(Monitors(entry.named()?.iter().map(one).collect::<Result<_>>()?))
    }
}

impl Value for Levels {
    fn shape() -> String {
        "table of lists of numbers".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        let mut all = Vec::new();
        for (name, entry) in entry.named()? {
            for value in entry.elements()? {
                all.push((name.clone(), level(&name, &value)?));
            }
        }
        Ok(Levels(all))
    }
}

impl Value for Hold {
    fn shape() -> String {
        "table of a number".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        match &entry.named()?[..] {
            [(name, value)] => Ok(Hold(name.clone(), level(name, value)?)),
            _ => Err(entry.fail("does not hold one monitor at one value")),
        }
    }
}

/// A value of a monitor, in units of what that is.
fn level(name: &str, entry: &Entry) -> Result<f64> {
    let value = f64::read(entry)?;
    let measured = entry.scope.seen.measured.borrow();
    let kind = |path: &str| measured.iter().find(|known| known.0 == path).map(|known| known.1);
    let task = entry.path.split('.').next().unwrap_or_default();
    match (kind(&entry.path), kind(&format!("{task}.monitors.{name}"))) {
        (Some(own), Some(wanted)) if !own.is_like(wanted) => {
            Err(entry.fail(&format!("is {own}, and {name} is {wanted}")))
        }
        _ => Ok(value),
    }
}

impl Monitor {
    fn read(name: &str, entry: &Entry) -> Result<Monitor> {
        let labels =
            Bifurcation::ALL.iter().map(|one| one.name()).chain(Degeneracy::ALL.map(Degeneracy::name));
        let parameters = entry.scope.names.iter().map(String::as_str);
        if !is_name(name) || labels.chain(COLUMNS).chain(parameters).any(|known| known == name) {
            let message = "the name of a monitor is a letter, then letters, digits and _, and not that of a parameter, a label or a \
                           column of a branch";
            return Err(entry.fail(message));
        }
        let text = entry.text()?;
        let words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
        let is_both = |word: &&str| {
            Quantity::named(word).is_some() && entry.scope.names.iter().any(|name| name == word)
        };
        if let Some(word) = words.clone().find(is_both) {
            let message = format!(
                "{word} is a parameter of the scene, and a quantity of an orbit: rename the parameter"
            );
            return Err(entry.fail(&message));
        }
        let plain =
            PLAIN.into_iter().chain(words).map(|word| Some((word.to_string(), Quantity::named(word)?)));
        let mut all: Vec<(String, Quantity)> = Vec::new();
        for (word, quantity) in plain.flatten() {
            if !all.iter().any(|known| known.0 == word) && !entry.scope.names.contains(&word) {
                all.push((word, quantity));
            }
        }
        let names: Vec<String> =
            entry.scope.names.iter().chain(all.iter().map(|one| &one.0)).cloned().collect();
        // Where coordinates may be angles, no dimension of theirs is known.
        let (scaled, measured) = (entry.scope.seen.scaled.get(), entry.scope.seen.measured.borrow().clone());
        let turns = measured
            .iter()
            .any(|(path, kind)| path.starts_with("system.mass") && kind.is_like(Dimension::of(2, 0, 1)));
        let kinds = entry.scope.quantities.map(|(scale, kinds)| {
            let known = all.iter().map(|(word, quantity)| (word.clone(), quantity.dimension()));
            let known = known.filter(|(_, kind)| scaled && !(turns && kind.length != 0));
            (scale, kinds.clone().into_iter().chain(known).collect())
        });
        let quantities = kinds.as_ref().map(|(scale, kinds)| (*scale, kinds));
        let scope = Scope { source: entry.scope.source.clone(), names: &names, quantities, ..*entry.scope };
        let inner = Entry {
            scope: &scope,
            path: entry.path.clone(),
            span: entry.span.clone(),
            item: entry.item.clone(),
        };
        let formula = Expression::read(&inner)?.root;
        if !formula.mentions(&|_| true) {
            return Err(entry.fail("is a constant: write a function of an orbit or of parameters"));
        }
        let measured = entry.scope.seen.measured.borrow();
        let dimension = measured.iter().find(|known| known.0 == entry.path).map(|known| known.1);
        Ok(Monitor { name: name.to_string(), formula, dimension, quantities: all })
    }

    /// What it asks of an orbit.
    pub(crate) fn asked(&self, parameters: usize) -> impl Iterator<Item = (usize, &str, Quantity)> {
        let all = self.quantities.iter().enumerate();
        let asked = all.filter(move |(i, _)| self.formula.mentions(&|place| place == parameters + i));
        asked.map(move |(i, (name, quantity))| (parameters + i, name.as_str(), *quantity))
    }
}
