//! Forces with kinks and jumps: abs, sign, max, min, and stops whose force is a formula.
//!
//! Each has a switch, a function of the motion, and is one smooth formula where that is positive and another
//! where it is negative. With the sign of every switch known the forces are smooth: a mode, and a stage of
//! the machine. The switches that a mode looks at are outputs of its program, after all others; when one of
//! them changes its sign is found as an impact is (`simulate`). Equal switches are one.

use std::{f64::consts::FRAC_PI_2, sync::Arc};

use num_rational::BigRational;
use num_traits::Zero;

use super::{Smooth, laws::laws};
use crate::{
    error::Result,
    formula::{Choice, Formula, Operation},
    many::{Grip, Machine, RealVector, State},
    motion::{
        SmoothForce,
        flow::{Gradient, value},
    },
};

/// A function whose sign chooses.
#[derive(Debug, Clone)]
pub struct Switch {
    /// Of displacements and velocities of all points and of the time.
    formula: Formula,
    /// The same with coefficients, and the force whose they are.
    written: Formula,
    force: usize,
    /// What it stands in, as it was written.
    pub text: String,
    pub(crate) of: SwitchOf,
}

/// What a switch decides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum SwitchOf {
    /// A kink or jump in a formula.
    Kink,
    /// Whether a stop with a law is in contact.
    Depth(usize),
    /// Whether it would push.
    Push(usize),
    /// Which way a row with friction slides: its grip tells, and nothing is watched.
    Slide(usize),
}

/// The switches of a machine, those inside others first.
fn switches(formulas: &[(usize, SmoothForce<f64>)], points: usize) -> Vec<Switch> {
    let mut all = Vec::new();
    for (place, (_, force)) in formulas.iter().enumerate() {
        collect(&force.formula, (place, &known(force, 2 * points + 1)), &mut all);
    }
    all
}

fn collect(formula: &Formula, own: (usize, &dyn Fn(usize) -> Formula), all: &mut Vec<Switch>) {
    match formula {
        Formula::Number(_) | Formula::Variable(_) | Formula::Pi => {}
        Formula::Negated(inner)
        | Formula::Power(inner, _)
        | Formula::Call(_, inner)
        | Formula::Raised(inner, _) => collect(inner, own, all),
        Formula::Binary(_, parts) => parts.iter().for_each(|part| collect(part, own, all)),
        Formula::Choice(choice) => {
            choice.parts().into_iter().for_each(|part| collect(part, own, all));
            let (force, numbers) = own;
            let formula = choice.switch.substituted(numbers);
            if all.iter().all(|known| known.formula != formula) {
                let (written, text) = (choice.switch.clone(), choice.text.clone());
                let of = SwitchOf::Kink;
                all.push(Switch { formula, written, force, text, of });
            }
        }
    }
}

/// A number as a formula.
pub(in crate::many) fn number(value: f64) -> Formula {
    Formula::Number(BigRational::from_float(value).unwrap_or_else(BigRational::zero))
}

pub(in crate::many) fn joined(operation: Operation, x: Formula, y: Formula) -> Formula {
    Formula::Binary(operation, Box::new([x, y]))
}

/// The numbers in the place of a force's coefficients: `variables` come before them.
pub(in crate::many) fn known(force: &SmoothForce<f64>, variables: usize) -> impl Fn(usize) -> Formula {
    move |place: usize| match place.checked_sub(variables) {
        Some(coefficient) => number(force.coefficients[coefficient]),
        None => Formula::Variable(place),
    }
}

/// The same with numbers for the coefficients of its switches, so that equal switches of two forces are one.
fn closed(formula: &Formula, known: &dyn Fn(usize) -> Formula) -> Formula {
    match formula {
        Formula::Choice(choice) => {
            let Choice { text, above, below, .. } = choice.mapped(|part| closed(part, known));
            let switch = choice.switch.substituted(known);
            Formula::Choice(Box::new(Choice { text, switch, above, below }))
        }
        _ => formula.mapped(&mut |part| closed(part, known)),
    }
}

impl Smooth {
    /// Adds the forces of stops with laws and of friction with one, and finds all switches.
    pub(super) fn with_kinks(mut self, machine: &Machine<f64>) -> Result<Smooth> {
        let variables = 2 * machine.points() + 1;
        let (laws, stops) = laws(machine, None)?;
        self.without_friction = self.formulas.len() + stops;
        let mut roles = Vec::new();
        for law in laws {
            let closed =
                |(formula, of): (Formula, SwitchOf)| (formula.substituted(&known(&law.force, variables)), of);
            roles.extend(law.roles.into_iter().map(closed));
            self.formulas.push((machine.points() + self.laws.len(), law.force));
            self.laws.push((self.shape.tr_mul(&law.row[0]), law.name));
        }
        let mut all = switches(&self.formulas, machine.points());
        for (formula, of) in roles {
            all.iter_mut().filter(|known| known.formula == formula).for_each(|known| known.of = of);
        }
        self.switches = Arc::new(all);
        for (_, force) in self.formulas.iter_mut().filter(|(_, force)| force.formula.chooses()) {
            let own = closed(&force.formula, &known(force, variables));
            force.formula = Arc::new(own);
        }
        Ok(self)
    }

    /// How a switch changes at a state that stays, in a parameter in which the formulas change so.
    pub fn switch_slope(&self, switch: usize, state: &State, own: &Smooth) -> f64 {
        let Switch { written, force, .. } = &self.switches[switch];
        let both = |value: f64, slope: f64| Gradient([value, slope]);
        let points = self.shape.nrows();
        let [q, u] = [&state.q, &state.u].map(|x| [&self.shape * x, &own.shape * x]);
        let rate = both(self.rate, own.rate);
        let places = (0..points).map(|i| both(q[0][i], q[1][i]));
        let rates = (0..points).map(|i| rate * both(u[0][i], u[1][i]));
        let numbers = self.formulas[*force].1.coefficients.iter().zip(&own.formulas[*force].1.coefficients);
        let numbers = numbers.map(|(value, slope)| both(*value, *slope));
        let variables: Vec<_> = places.chain(rates).chain([both(state.t, 0.0)]).chain(numbers).collect();
        value(written, &variables).0[1]
    }

    /// Where forces have kinks.
    pub fn switches(&self) -> &[Switch] {
        &self.switches
    }

    /// The switches that this mode looks at: outputs after all others, in this order.
    pub fn reached(&self) -> &[usize] {
        &self.reached
    }

    /// The value of each switch at a state, and the sum of the moduli of what it was added up from.
    pub fn switched(&self, state: &State) -> Vec<[f64; 2]> {
        let (q, u) = (&self.shape * &state.q, &self.shape * &state.u * self.rate);
        let variables: Vec<f64> = q.iter().chain(u.iter()).copied().chain([state.t]).collect();
        self.switches.iter().map(|known| known.formula.at(&variables)).collect()
    }

    /// By how much each switch changes for a displacement, or a velocity per radian, of 1: the most that one
    /// of `size` changes it by, from rest or from that far away. A switch may be of any unit, which is not
    /// known.
    pub fn steepness(&self, size: f64) -> Vec<f64> {
        let points = self.shape.nrows();
        let by = |at: usize| if at < points { size } else { size * self.rate };
        let far: Vec<f64> = (0..2 * points).map(by).collect();
        let one = |known: &Switch| {
            let mut most = 0.0f64;
            let places: Vec<usize> =
                (0..2 * points).filter(|&at| known.formula.mentions(&|p| p == at)).collect();
            for t in [0.0, 1.0, 2.0, 3.0].map(|i| i * FRAC_PI_2) {
                for base in [&vec![0.0; 2 * points], &far] {
                    let mut variables = [&base[..], &[t]].concat();
                    let from = known.formula.at(&variables)[0];
                    for &at in &places {
                        for step in [far[at], -far[at]] {
                            variables[at] = base[at] + step;
                            let changed = (known.formula.at(&variables)[0] - from).abs() / size;
                            most = if changed.is_finite() { most.max(changed) } else { most };
                        }
                        variables[at] = base[at];
                    }
                }
            }
            most
        };
        self.switches.iter().map(one).collect()
    }

    /// The switches that are negative at rest: stops that are just touched are open.
    pub(super) fn below_at_rest(&self, size: usize) -> Vec<usize> {
        let zero = RealVector::zeros(size);
        let values = self.switched(&State { t: 0.0, q: zero.clone(), u: zero });
        let open =
            |k: usize, value: f64| value < 0.0 || value == 0.0 && self.switches[k].of != SwitchOf::Kink;
        values.iter().enumerate().filter(|(k, value)| open(*k, value[0])).map(|(k, _)| k).collect()
    }

    /// The machine where the switches of a list are negative and all others positive, and friction slides so;
    /// without grips there is none.
    pub fn in_mode(&self, below: &[usize], grips: &[Grip]) -> Smooth {
        let backward = |k: &usize| matches!(self.switches[*k].of, SwitchOf::Slide(rub) if grips.get(rub) == Some(&Grip::Backward));
        let below: Vec<usize> =
            below.iter().copied().chain((0..self.switches.len()).filter(backward)).collect();
        let below = &below[..];
        let mut reached = Vec::new();
        let mut resolve = |formula: &Formula| resolved(formula, &self.switches, below, &mut reached);
        let count = if grips.is_empty() { self.without_friction } else { self.formulas.len() };
        let mut formulas = self.formulas[..count].to_vec();
        for (_, force) in &mut formulas {
            if force.formula.chooses() {
                force.formula = Arc::new(resolve(&force.formula));
            }
        }
        let mut inner = Vec::new();
        let sights = reached.iter().map(|&k| {
            let formula = resolved(&self.switches[k].formula, &self.switches, below, &mut inner);
            let text = self.switches[k].text.clone();
            SmoothForce { formula: Arc::new(formula), text, coefficients: vec![] }
        });
        let sights = sights.collect();
        Smooth { formulas, sights, reached, ..self.clone() }
    }
}

/// A formula in a mode, the switches that it looks at being added to `reached`.
fn resolved(formula: &Formula, switches: &[Switch], below: &[usize], reached: &mut Vec<usize>) -> Formula {
    match formula {
        Formula::Choice(choice) => {
            let switch = resolved(&choice.switch, switches, below, reached);
            let above = if switch.mentions(&|_| true) {
                let place = switches.iter().position(|known| known.formula == choice.switch);
                let place = place.unwrap_or(usize::MAX);
                let watched = |known: &Switch| !matches!(known.of, SwitchOf::Slide(_));
                if switches.get(place).is_some_and(watched) && !reached.contains(&place) {
                    reached.push(place);
                }
                !below.contains(&place)
            } else {
                // A constant, such as max(q, 0) where q is negative.
                switch.at(&[])[0] >= 0.0
            };
            resolved(if above { &choice.above } else { &choice.below }, switches, below, reached)
        }
        _ => formula.mapped(&mut |part| resolved(part, switches, below, reached)),
    }
}
