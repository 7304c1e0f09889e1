//! A machine without damping, drive and friction: what its backbone curve is of.
//! Of a force that is a formula, terms of the time or the velocity alone are drive and damping, and so is one
//! that is the velocity times something of the displacement.

use super::{Machine, StopLaw};
use crate::{
    error::Result,
    formula::{Formula, Operation},
    motion::{
        Q, TIME,
        backbone::{Conservative, OwnForce},
    },
};

impl Machine<f64> {
    /// Why it has no backbone curve, if it has none.
    pub fn no_backbone(&self) -> Option<&'static str> {
        let (n, alone) = (self.points(), self.points() == 1 && self.size == 1);
        let turns = |&(i, j, x): &(usize, usize, f64)| {
            let other = self.damping.iter().filter(|(k, l, _)| (*k, *l) == (j, i));
            i != j && other.map(|(_, _, y)| y).sum::<f64>() != x
        };
        match () {
            () if self.has_laws() => Some("is of springs and stops, and here a stop pushes by a formula"),
            () if self.smooth.iter().flatten().any(|force| of_displacement(&force.formula, n).is_none()) => {
                Some(
                    "is of smooth forces of the displacement, and here one has kinks, or a term of it with velocity or time",
                )
            }
            () if self.stops.iter().any(|stop| !stop.wall.harmonics.is_empty()) => {
                Some("is of free vibrations, and here a stop moves")
            }
            () if !alone && self.damping.iter().any(turns) => Some(
                "of several coordinates is of motions that are at rest twice, and here gyroscopic forces turn them",
            ),
            () => None,
        }
    }

    /// The machine without damping, drive, friction and rigid stops. Of forces of which it has no backbone
    /// ([`no_backbone`](Self::no_backbone)) none is changed.
    #[must_use]
    pub fn freed(&self) -> Machine<f64> {
        let mut free = Machine {
            damping: Vec::new(),
            damping_ratio: Vec::new(),
            forcing: Vec::new(),
            record: None,
            friction: Vec::new(),
            ..self.clone()
        };
        free.stops.retain_mut(|stop| match &mut stop.law {
            StopLaw::Soft { damping, .. } => {
                *damping = 0.0;
                true
            }
            _ => false,
        });
        for force in free.smooth.iter_mut().flatten() {
            if let Some(formula) = of_displacement(&force.formula, self.points()) {
                force.formula = formula.into();
            }
        }
        free
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
            Some(OwnForce { formula: of_displacement(&force.formula, 1)?, variables, factor: shape })
        });
        let (force, cubic) = (equations.force.mean[0] + shape * constant, cubic + shape.powi(4) * cube);
        Ok((Conservative { mass, stiffness, cubic, force, stops, springs, own }, shape.abs()))
    }
}

/// The terms of a force of n coordinates that are of the displacements; none where they cannot be told from
/// the others, or have kinks.
fn of_displacement(formula: &Formula, n: usize) -> Option<Formula> {
    let has = |formula: &Formula, from: usize, to: usize| formula.mentions(&|x| (from..=to).contains(&x));
    if !has(formula, n, 2 * n) {
        return (!formula.has_kinks()).then(|| formula.clone());
    }
    if !has(formula, 0, n - 1) || damps(formula, n) {
        return Some(Formula::Number(num_traits::Zero::zero()));
    }
    match formula {
        Formula::Negated(inner) => Some(Formula::Negated(Box::new(of_displacement(inner, n)?))),
        Formula::Binary(operation, parts) => {
            let [a, b] = &**parts;
            let parts = match operation {
                Operation::Sum | Operation::Difference => [of_displacement(a, n)?, of_displacement(b, n)?],
                Operation::Product if !has(a, 0, 2 * n) => [a.clone(), of_displacement(b, n)?],
                Operation::Product | Operation::Quotient if !has(b, 0, 2 * n) => {
                    [of_displacement(a, n)?, b.clone()]
                }
                _ => return None,
            };
            Some(Formula::Binary(*operation, Box::new(parts)))
        }
        _ => None,
    }
}

/// Whether it is a velocity times something of the displacements, n of which there are.
fn damps(formula: &Formula, n: usize) -> bool {
    let moved = |formula: &Formula| formula.mentions(&|x| (n..=2 * n).contains(&x));
    match formula {
        Formula::Variable(place) => (n..2 * n).contains(place),
        Formula::Negated(inner) => damps(inner, n),
        Formula::Binary(Operation::Product, parts) => {
            let [a, b] = &**parts;
            damps(a, n) && !moved(b) || damps(b, n) && !moved(a)
        }
        Formula::Binary(Operation::Quotient, parts) => damps(&parts[0], n) && !moved(&parts[1]),
        _ => false,
    }
}
