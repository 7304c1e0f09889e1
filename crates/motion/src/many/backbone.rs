//! A machine of one coordinate as one without damping, drive and friction: what its backbone curve is of.

use super::{Machine, StopLaw};
use crate::{
    error::Result,
    formula::{Formula, Operation},
    motion::{Q, TIME, backbone::Conservative},
};

impl Machine<f64> {
    /// Why it has no backbone curve, if it has none.
    pub fn no_backbone(&self) -> Option<&'static str> {
        match () {
            () if self.size != 1 || self.points() != 1 => {
                Some("is of one coordinate, and here there are several")
            }
            () if self.has_laws() || self.cubic().is_none() => {
                Some("is of springs and stops, and here a force is a formula")
            }
            () if self.stops.iter().any(|stop| !stop.wall.harmonics.is_empty()) => {
                Some("is of free vibrations, and here a stop moves")
            }
            () => None,
        }
    }

    /// The constant force and the coefficient of the displacement cubed, where a formula is no more than
    /// these, as that of `cubic` is: a − b q³.
    fn cubic(&self) -> Option<[f64; 2]> {
        let Some(force) = self.smooth.iter().flatten().next() else { return Some([0.0; 2]) };
        let known = |formula: &Formula| !formula.mentions(&|place| place <= TIME);
        let Formula::Binary(Operation::Difference, both) = &*force.formula else { return None };
        let [constant, Formula::Binary(Operation::Product, product)] = &**both else { return None };
        let [factor, Formula::Power(place, 3)] = &**product else { return None };
        if **place != Formula::Variable(Q) || !known(constant) || !known(factor) {
            return None;
        }
        let none = [0.0; TIME + 1].into_iter();
        let variables: Vec<f64> = none.chain(force.coefficients().iter().copied()).collect();
        Some([constant, factor].map(|part| part.at(&variables)[0]))
    }

    /// The machine without damping, drive and friction, its rigid stops without loss, and the size of its
    /// displacement over that of its coordinate. `cubic` is the coefficient of the displacement cubed.
    ///
    /// # Errors
    /// Those of [`Machine::equations`] and [`Machine::contacts`].
    pub fn conservative(&self, cubic: f64) -> Result<(Conservative, f64)> {
        let (equations, contacts) = (self.equations()?, self.contacts()?);
        let mut stops = [f64::NEG_INFINITY, f64::INFINITY];
        let mut springs = Vec::new();
        for (contact, stop) in contacts.iter().zip(&self.stops) {
            let row = contact.row[0];
            let place = contact.position.mean() / row;
            match (&stop.law, row > 0.0) {
                (StopLaw::Soft { stiffness, .. }, below) => {
                    springs.push([place, if below { -1.0 } else { 1.0 }, stiffness * row * row]);
                }
                (_, true) => stops[0] = stops[0].max(place),
                (_, false) => stops[1] = stops[1].min(place),
            }
        }
        let shape = self.shapes.first().map_or(1.0, |shape| shape[0]);
        let (mass, stiffness) = (equations.mass[(0, 0)], equations.stiffness[(0, 0)]);
        let [constant, own] = self.cubic().unwrap_or_default();
        let (force, cubic) = (equations.force.mean[0] + shape * constant, cubic + shape.powi(4) * own);
        Ok((Conservative { mass, stiffness, cubic, force, stops, springs }, shape.abs()))
    }
}
