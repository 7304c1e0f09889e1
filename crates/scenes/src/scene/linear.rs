//! A force that is written as a formula and is linear in displacement and velocity, its time in harmonics:
//! its coefficients, exactly. So a machine is linear however its force is written.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{expression::Expression, force::MOST};
use crate::{
    formula::{Formula, Function, Operation},
    motion::{SmoothForce, TIME},
};

/// constant + q·`displacement` + u·`velocity` + Σ (a cos kt + b sin kt), `harmonics` having \[a, b\] by k.
pub(super) struct LinearForce {
    pub constant: Option<Expression>,
    pub displacement: Option<Expression>,
    pub velocity: Option<Expression>,
    pub harmonics: BTreeMap<u32, [Option<Expression>; 2]>,
}

impl LinearForce {
    /// The parts of a force; none if it is not known to have only these. Cost: linear in the formula, but for
    /// a factor of the number of harmonics.
    pub(super) fn of(force: &SmoothForce<Expression>) -> Option<LinearForce> {
        let own = |place: usize| match place.checked_sub(TIME + 1) {
            Some(coefficient) => force.coefficients[coefficient].root.clone(),
            None => Formula::Variable(FAR + place),
        };
        let parts = Parts::of(&force.formula.substituted(&own))?;
        let key = force.coefficients.first().map_or("", |coefficient| &coefficient.key);
        let given = |formula: Term| formula.map(|formula| Expression::of(&formula, &force.text, key));
        let [q, u] = parts.state;
        Some(LinearForce {
            constant: given(parts.constant),
            displacement: given(q),
            velocity: given(u),
            harmonics: parts.harmonics.into_iter().map(|(k, both)| (k, both.map(given))).collect(),
        })
    }
}

/// Where the variables of a force stand while its coefficients are in terms of parameters.
const FAR: usize = usize::MAX - TIME;

/// A coefficient in parameters; none for 0.
type Term = Option<Formula>;

#[derive(Default)]
struct Parts {
    constant: Term,
    state: [Term; 2],
    harmonics: BTreeMap<u32, [Term; 2]>,
}

fn binary(operation: Operation, left: Formula, right: Formula) -> Formula {
    Formula::Binary(operation, Box::new([left, right]))
}

fn one() -> Formula {
    Formula::Number(BigRational::one())
}

fn sum(left: Term, right: Term) -> Term {
    match (left, right) {
        (Some(left), Some(right)) => Some(binary(Operation::Sum, left, right)),
        (left, right) => left.or(right),
    }
}

fn is_free(formula: &Formula) -> bool {
    !formula.mentions(&|place| place >= FAR)
}

/// Whether it is in parameters alone, and has what a coefficient may have.
fn is_coefficient(formula: &Formula) -> bool {
    match formula {
        Formula::Number(_) | Formula::Pi => true,
        Formula::Variable(place) => *place < FAR,
        Formula::Negated(inner) | Formula::Power(inner, _) => is_coefficient(inner),
        Formula::Binary(_, both) => both.iter().all(is_coefficient),
        Formula::Call(Function::Log | Function::Tanh, _) | Formula::Choice(_) | Formula::Raised(..) => false,
        Formula::Call(_, inner) => is_coefficient(inner),
    }
}

impl Parts {
    fn of(formula: &Formula) -> Option<Parts> {
        if is_free(formula) {
            return is_coefficient(formula)
                .then(|| Parts { constant: Some(formula.clone()), ..Parts::default() });
        }
        match formula {
            Formula::Variable(place) if *place == FAR + TIME => None,
            Formula::Variable(place) => {
                let mut parts = Parts::default();
                parts.state[place - FAR] = Some(one());
                Some(parts)
            }
            Formula::Negated(inner) => {
                Some(Parts::of(inner)?.mapped(|term| Formula::Negated(Box::new(term))))
            }
            Formula::Power(inner, 1) => Parts::of(inner),
            Formula::Binary(operation, both) => {
                let [left, right] = &**both;
                match operation {
                    Operation::Sum => Some(Parts::of(left)?.plus(Parts::of(right)?)),
                    Operation::Difference => {
                        let right = Parts::of(right)?.mapped(|term| Formula::Negated(Box::new(term)));
                        Some(Parts::of(left)?.plus(right))
                    }
                    Operation::Product if is_coefficient(left) => {
                        Some(Parts::of(right)?.mapped(|term| binary(Operation::Product, left.clone(), term)))
                    }
                    _ if is_coefficient(right) => {
                        Some(Parts::of(left)?.mapped(|term| binary(*operation, term, right.clone())))
                    }
                    _ => None,
                }
            }
            Formula::Call(function @ (Function::Sin | Function::Cos), inner) => harmonic(*function, inner),
            _ => None,
        }
    }

    fn mapped(self, change: impl Fn(Formula) -> Formula) -> Parts {
        let change = |term: Term| term.map(&change);
        Parts {
            constant: change(self.constant),
            state: self.state.map(change),
            harmonics: self.harmonics.into_iter().map(|(k, both)| (k, both.map(change))).collect(),
        }
    }

    fn plus(mut self, other: Parts) -> Parts {
        let ([q, u], [other_q, other_u]) = (self.state, other.state);
        for (k, [cos, sin]) in other.harmonics {
            let [own_cos, own_sin] = self.harmonics.remove(&k).unwrap_or_default();
            self.harmonics.insert(k, [sum(own_cos, cos), sum(own_sin, sin)]);
        }
        Parts {
            constant: sum(self.constant, other.constant),
            state: [sum(q, other_q), sum(u, other_u)],
            harmonics: self.harmonics,
        }
    }
}

/// sin or cos of kt + φ: cos(kt + φ) = cos φ cos kt − sin φ sin kt and sin(kt + φ) = sin φ cos kt +
/// cos φ sin kt.
fn harmonic(function: Function, angle: &Formula) -> Option<Parts> {
    let (k, phase) = angle_of(angle)?;
    let order = k.is_integer().then(|| k.to_integer().abs().to_u32()).flatten()?;
    if !(1..=MOST).contains(&order) {
        return None;
    }
    let negated = |term: Formula| Formula::Negated(Box::new(term));
    let of_phase = |function| phase.clone().map(|phase| Formula::Call(function, Box::new(phase)));
    let (cos, sin) = (of_phase(Function::Cos).unwrap_or_else(one), of_phase(Function::Sin));
    let both = match function {
        Function::Cos => [Some(cos), sin.map(negated)],
        _ => [sin, Some(cos)],
    };
    // sin kt of a negative k is −sin |k|t.
    let [even, odd] = both;
    let odd = if k.is_negative() { odd.map(negated) } else { odd };
    Some(Parts { harmonics: BTreeMap::from([(order, [even, odd])]), ..Parts::default() })
}

/// k and φ of kt + φ.
fn angle_of(formula: &Formula) -> Option<(BigRational, Term)> {
    if is_free(formula) {
        return is_coefficient(formula).then(|| (BigRational::zero(), Some(formula.clone())));
    }
    let scaled = |inner: &Formula, factor: &Formula, operation: Operation| {
        let known = (!factor.mentions(&|_| true) && factor.is_rational()).then_some(factor)?;
        let value: BigRational = Expression::of(known, "", "").evaluate(&[], &()).ok()?;
        let (k, phase) = angle_of(inner)?;
        let k = match operation {
            Operation::Quotient if value.is_zero() => return None,
            Operation::Quotient => k / value,
            _ => k * value,
        };
        Some((k, phase.map(|phase| binary(operation, phase, factor.clone()))))
    };
    match formula {
        Formula::Variable(place) if *place == FAR + TIME => Some((BigRational::one(), None)),
        Formula::Negated(inner) => {
            let (k, phase) = angle_of(inner)?;
            Some((-k, phase.map(|phase| Formula::Negated(Box::new(phase)))))
        }
        Formula::Binary(operation, both) => {
            let [left, right] = &**both;
            match operation {
                Operation::Sum | Operation::Difference => {
                    let ((left, phase), (right, other)) = (angle_of(left)?, angle_of(right)?);
                    Some(match operation {
                        Operation::Sum => (left + right, sum(phase, other)),
                        _ => (left - right, sum(phase, other.map(|other| Formula::Negated(Box::new(other))))),
                    })
                }
                Operation::Product if is_coefficient(left) => scaled(right, left, Operation::Product),
                _ if is_coefficient(right) => scaled(left, right, *operation),
                _ => None,
            }
        }
        _ => None,
    }
}
