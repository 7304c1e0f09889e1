//! Thresholds: functions of the motion whose zeros are told, and change nothing.
//!
//! A threshold is a force with a kink that is 0 on both sides of it: so it is found as kinks are, by the same
//! search, and with what that promises.

use std::sync::Arc;

use super::{
    Machine,
    smooth::{joined, known, number},
};
use crate::{
    formula::{Choice, Formula, Operation},
    motion::SmoothForce,
};

/// What the texts of thresholds among kinks begin with: those of kinks have no space.
const MARK: &str = "event ";

/// The name of a threshold whose text this is; none of a kink of a force.
pub fn threshold(text: &str) -> Option<&str> {
    text.strip_prefix(MARK)
}

impl Machine<f64> {
    /// The same machine, on whose motions zeros of these functions are told, each with a name.
    #[must_use]
    pub fn watching(mut self, functions: &[(String, SmoothForce<f64>)]) -> Machine<f64> {
        if functions.is_empty() {
            return self;
        }
        let (points, zero) = (self.points(), || number(0.0));
        let plus = |x: Formula, y: Formula| joined(Operation::Sum, x, y);
        self.smooth.resize(points, None);
        let slot = &mut self.smooth[points - 1];
        for (i, (name, function)) in functions.iter().enumerate() {
            let own = function.formula.substituted(&known(function, 2 * points + 1));
            // Equal switches are one: this is like none of a kink or of another threshold.
            let switch = (0..=i).fold(own, |sum, _| plus(sum, zero()));
            let text = format!("{MARK}{name}");
            let none = Formula::Choice(Box::new(Choice { text, switch, above: zero(), below: zero() }));
            *slot = Some(match slot.take() {
                None => SmoothForce { formula: Arc::new(none), text: "0".into(), coefficients: vec![] },
                Some(force) => {
                    SmoothForce { formula: Arc::new(plus(force.formula.as_ref().clone(), none)), ..force }
                }
            });
        }
        self
    }
}
