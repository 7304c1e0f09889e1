//! Friction whose coefficient is a law of the sliding speed, as Stribeck's.
//!
//! The coefficient µ(v) is even. It is read where v > 0, there each abs(v) is v, and taken at |v| elsewhere.
//! Beside Coulomb's force −σ µ(0) N, σ the sign of v, such a row feels −σ (µ(|v|) − µ(0)) N, which is
//! continuous and 0 where v is 0. So that part has no say in what sticks, slides and lets go, and stands
//! among the formulas (`smooth`): how the row slides tells its side, as a switch does for a kink. Kinks of µ
//! at other speeds are kinks of a force.

use num_traits::Signed;

use super::smooth::{joined, known, number};
use crate::{
    error::{Error, Result},
    formula::{Choice, Formula, Function, Operation},
    motion::{
        SmoothForce,
        flow::{Gradient, Scalar, value},
    },
};

/// Values at v and −v that differ by no more of their size are the same.
const EVEN: f64 = 1e-9;

/// The force of friction that follows the sliding speed.
#[derive(Debug, Clone, PartialEq)]
pub struct SlidingLaw {
    /// µ of v > 0, the variable at place 0; as it is written, with coefficients, and with their values.
    written: Formula,
    ahead: Formula,
    normal: f64,
    /// Ω.
    rate: f64,
}

impl SlidingLaw {
    /// Of a coefficient in v, a normal force, and Ω, v being velocities per radian times that.
    ///
    /// # Errors
    /// A coefficient that is negative or no number, or not the same both ways, at a speed looked at.
    pub(crate) fn new(law: &SmoothForce<f64>, normal: f64, rate: f64) -> Result<SlidingLaw> {
        let (own, text) = (law.formula.substituted(&known(law, 2)), &law.text);
        for v in speeds() {
            let [ahead, back] = [v, -v].map(|v| own.at(&[v])[0]);
            if ahead.is_nan() || ahead < 0.0 {
                return Err(Error::input(format!(
                    "coefficient = {text} is {ahead} at v = {v}; it is at least 0 at every speed: bound it, as by max(x, 0.1)"
                )));
            }
            let same = ahead == back || (ahead - back).abs() <= EVEN * ahead;
            if !same {
                return Err(Error::input(format!(
                    "coefficient = {text} is {ahead} at v = {v} and {back} at v = -{v}; it is the same both ways: write abs(v)"
                )));
            }
        }
        let (numbers, formula) = (known(law, 2), &law.formula);
        let written = onward(formula, &numbers);
        Ok(SlidingLaw { ahead: written.substituted(&numbers), written, normal, rate })
    }

    /// µ(0).
    pub fn at_rest(&self) -> f64 {
        self.ahead.at(&[0.0])[0]
    }

    /// By how much µ(0) changes with a parameter in which the coefficients of the law change so.
    pub fn slope_at_rest(&self, law: &SmoothForce<f64>, change: &SmoothForce<f64>) -> f64 {
        let own = law.coefficients.iter().zip(&change.coefficients).map(|(x, slope)| Gradient([*x, *slope]));
        let variables: Vec<Gradient<2>> = [Gradient::constant(0.0); 2].into_iter().chain(own).collect();
        value(&self.written, &variables).0[1]
    }

    /// The force at a velocity per radian: µN.
    pub fn at(&self, v: f64) -> f64 {
        self.normal * self.ahead.at(&[(v * self.rate).abs()])[0]
    }

    /// −σ (µ(|v|) − µ(0)) N as a formula, v and N being formulas and `applied` that of µ at a speed; what
    /// chooses by the sign of v has v for its switch. µ(0) is a number there: how it changes counts here, and
    /// not as a change of Coulomb's force.
    pub(crate) fn beside_coulomb(
        &self,
        v: &Formula,
        normal: Formula,
        applied: &mut dyn FnMut(&Formula, Formula) -> Formula,
    ) -> Formula {
        let chosen = |above: Formula, below: Formula| {
            Formula::Choice(Box::new(Choice { text: "abs(v)".into(), switch: v.clone(), above, below }))
        };
        let negated = |x: &Formula| Formula::Negated(Box::new(x.clone()));
        let speed = chosen(v.clone(), negated(v));
        let more = joined(Operation::Difference, applied(&self.written, speed), number(self.at_rest()));
        let force = joined(Operation::Product, normal, more);
        chosen(negated(&force), force)
    }
}

/// Speeds in all units: a law is looked at there for mistakes.
fn speeds() -> impl Iterator<Item = f64> {
    let decades = (-9..=6).map(|power| 10f64.powi(power));
    [0.0].into_iter().chain(decades.flat_map(|decade| [1.0, 2.0, 5.0].map(|digit| digit * decade)))
}

/// A formula where its variable is positive, without the kinks whose side follows from that and from the
/// numbers that are known.
fn onward(formula: &Formula, known: &dyn Fn(usize) -> Formula) -> Formula {
    let Formula::Choice(choice) = formula else { return formula.mapped(&mut |part| onward(part, known)) };
    let Choice { text, switch, above, below } = choice.mapped(|part| onward(part, known));
    match is_positive(&switch.substituted(known)) {
        Some(true) => above,
        Some(false) => below,
        None => Formula::Choice(Box::new(Choice { text, switch, above, below })),
    }
}

/// The sign of a formula where its variable is positive, if its form alone tells that.
fn is_positive(formula: &Formula) -> Option<bool> {
    match formula {
        Formula::Number(value) => Some(!value.is_negative()),
        Formula::Variable(_) | Formula::Pi | Formula::Raised(..) => Some(true),
        Formula::Negated(inner) => is_positive(inner).map(|sign| !sign),
        Formula::Power(_, exponent) if exponent % 2 == 0 => Some(true),
        Formula::Power(inner, _) => is_positive(inner),
        Formula::Call(Function::Exp | Function::Sqrt, _) => Some(true),
        Formula::Call(Function::Tanh, inner) => is_positive(inner),
        Formula::Call(..) | Formula::Choice(_) => None,
        Formula::Binary(operation, parts) => {
            let [x, y] = [is_positive(&parts[0])?, is_positive(&parts[1])?];
            match operation {
                Operation::Product | Operation::Quotient => Some(x == y),
                Operation::Sum => (x == y).then_some(x),
                Operation::Difference => (x != y).then_some(x),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::formula::kink;

    fn law(formula: Formula) -> Result<SlidingLaw> {
        let law = SmoothForce { formula: Arc::new(formula), text: "mu".into(), coefficients: vec![] };
        SlidingLaw::new(&law, 2.0, 0.5)
    }

    fn v() -> Formula {
        Formula::Variable(0)
    }

    fn speed(of: Formula) -> Formula {
        kink("abs", "abs(v)", vec![of]).unwrap()
    }

    /// 0.2 + 0.2 exp(−|−4v|/0.2), however its speed is written.
    #[test]
    fn a_law_is_read_at_positive_speeds_and_has_no_kink_there() {
        let scaled = joined(Operation::Quotient, joined(Operation::Product, number(-4.0), v()), number(0.2));
        let falls = Formula::Call(Function::Exp, Box::new(Formula::Negated(Box::new(speed(scaled)))));
        let own = joined(Operation::Product, number(0.2), joined(Operation::Sum, number(1.0), falls));
        let law = law(own).unwrap();
        assert!(!law.ahead.chooses());
        for v in [0.0f64, 0.1, -0.1, 3.0] {
            let wanted = 2.0 * 0.2 * (1.0 + (-20.0 * (0.5 * v).abs()).exp());
            assert!((law.at(v) - wanted).abs() < 1e-15, "{v}");
            let beside = law
                .beside_coulomb(&Formula::Variable(0), number(2.0), &mut |own, speed| {
                    own.substituted(&|_| speed.clone())
                })
                .at(&[0.5 * v])[0];
            assert!((beside + (wanted - 0.8) * if v < 0.0 { -1.0 } else { 1.0 }).abs() < 1e-15, "{v}");
        }
    }

    #[test]
    fn laws_that_are_negative_or_not_even_are_refused_with_the_speed() {
        let falls = |of| joined(Operation::Difference, number(0.4), of);
        let said = |formula: Formula| law(formula).unwrap_err().to_string();
        assert!(
            said(falls(speed(v()))).contains("at v = 0.5; it is at least 0"),
            "{}",
            said(falls(speed(v())))
        );
        assert!(said(joined(Operation::Sum, number(0.4), v())).contains("write abs(v)"));
        let bounded = kink("max", "max(0.1,0.4-abs(v))", vec![number(0.1), falls(speed(v()))]).unwrap();
        assert!(law(bounded).unwrap().ahead.chooses());
    }
}
