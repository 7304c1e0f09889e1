//! A parameter along an axis of a picture, in the unit in which the scene has it written. Tables beside the
//! picture are in the scene's own units, as JSON is.

use crate::{
    figure::{DrawnBranch, Scatter},
    scene::WrittenUnit,
};

/// An axis of a parameter.
pub(super) struct Axis<'s> {
    /// What it is called, with its unit.
    pub name: String,
    unit: Option<&'s WrittenUnit>,
}

impl<'s> Axis<'s> {
    pub fn new(parameter: &str, unit: Option<&'s WrittenUnit>) -> Axis<'s> {
        let name = match unit {
            Some(unit) if !unit.text.is_empty() => format!("{parameter} ({})", unit.text),
            _ => parameter.to_string(),
        };
        Axis { name, unit }
    }

    /// Where a value in the scene's own unit is.
    pub fn at(&self, value: f64) -> f64 {
        self.unit.map_or(value, |unit| unit.of(value))
    }

    /// Puts curves and points over this axis.
    pub fn convert(&self, curves: &mut [DrawnBranch], sets: &mut [Scatter]) {
        for curve in curves {
            for (x, _, said) in &mut curve.at {
                *x = self.at(*x);
                said.proved = said.proved.map(|ends| ends.map(|end| self.at(end)));
            }
            curve.labels.iter_mut().for_each(|(x, ..)| *x = self.at(*x));
        }
        sets.iter_mut().flat_map(|set| &mut set.at).for_each(|(x, _)| *x = self.at(*x));
    }
}
