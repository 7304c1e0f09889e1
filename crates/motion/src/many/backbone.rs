//! A machine of one coordinate as one without damping, drive and friction: what its backbone curve is of.
//! Of a force that is a formula, terms of the time or the velocity alone are drive and damping, and so is one
//! that is the velocity times something of the displacement.

use super::{Machine, StopLaw};
use crate::{
    error::Result,
    formula::{Formula, Operation},
    motion::{
        Q, TIME, U,
        backbone::{Conservative, OwnForce},
    },
};

impl Machine<f64> {
    /// Why it has no backbone curve, if it has none.
    pub fn no_backbone(&self) -> Option<&'static str> {
        match () {
            () if self.size != 1 || self.points() != 1 => {
                Some("is of one coordinate, and here there are several")
            }
            () if self.has_laws() => Some("is of springs and stops, and here a stop pushes by a formula"),
            () if self.smooth.iter().flatten().any(|force| of_displacement(&force.formula).is_none()) => {
                Some(
                    "is of smooth forces of the displacement, and here one has kinks, or a term of it with velocity or time",
                )
            }
            () if self.stops.iter().any(|stop| !stop.wall.harmonics.is_empty()) => {
                Some("is of free vibrations, and here a stop moves")
            }
            () => None,
        }
    }

    /// Whether anything moves it but its start.
    pub fn is_driven(&self) -> bool {
        let walls = self.stops.iter().any(|stop| !stop.wall.harmonics.is_empty());
        let surfaces = self.friction.iter().any(|friction| !friction.harmonics.is_empty());
        let timed = |place: usize| place == 2 * self.points();
        let formulas = self.smooth.iter().flatten().any(|force| force.mentions(&timed));
        !self.forcing.is_empty() || walls || surfaces || formulas || self.record.is_some()
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
        let ([constant, cube], own) = match self.cubic() {
            Some(known) => (known, None),
            None => ([0.0; 2], self.smooth.iter().flatten().next()),
        };
        let own = own.and_then(|force| {
            let none = [0.0; TIME + 1].into_iter();
            let variables = none.chain(force.coefficients().iter().copied()).collect();
            Some(OwnForce { formula: of_displacement(&force.formula)?, variables, factor: shape })
        });
        let (force, cubic) = (equations.force.mean[0] + shape * constant, cubic + shape.powi(4) * cube);
        Ok((Conservative { mass, stiffness, cubic, force, stops, springs, own }, shape.abs()))
    }
}

/// The terms of a force of one coordinate that are of the displacement; none where they cannot be told from
/// the others, or have kinks.
fn of_displacement(formula: &Formula) -> Option<Formula> {
    let has = |formula: &Formula, from: usize, to: usize| formula.mentions(&|x| (from..=to).contains(&x));
    if !has(formula, U, TIME) {
        return (!formula.has_kinks()).then(|| formula.clone());
    }
    if !has(formula, Q, Q) || damps(formula) {
        return Some(Formula::Number(num_traits::Zero::zero()));
    }
    match formula {
        Formula::Negated(inner) => Some(Formula::Negated(Box::new(of_displacement(inner)?))),
        Formula::Binary(operation, parts) => {
            let [a, b] = &**parts;
            let parts = match operation {
                Operation::Sum | Operation::Difference => [of_displacement(a)?, of_displacement(b)?],
                Operation::Product if !has(a, Q, TIME) => [a.clone(), of_displacement(b)?],
                Operation::Product | Operation::Quotient if !has(b, Q, TIME) => {
                    [of_displacement(a)?, b.clone()]
                }
                _ => return None,
            };
            Some(Formula::Binary(*operation, Box::new(parts)))
        }
        _ => None,
    }
}

/// Whether it is the velocity times something of the displacement.
fn damps(formula: &Formula) -> bool {
    let moved = |formula: &Formula| formula.mentions(&|x| x == U || x == TIME);
    match formula {
        Formula::Variable(place) => *place == U,
        Formula::Negated(inner) => damps(inner),
        Formula::Binary(Operation::Product, parts) => {
            let [a, b] = &**parts;
            damps(a) && !moved(b) || damps(b) && !moved(a)
        }
        Formula::Binary(Operation::Quotient, parts) => damps(&parts[0]) && !moved(&parts[1]),
        _ => false,
    }
}
