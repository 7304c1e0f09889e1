//! Forces that are written as formulas and are linear in displacements and velocities, their time in
//! harmonics: their coefficients, exactly. So a machine is linear however its forces are written.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{expression::Expression, force::MOST};
use crate::{
    formula::{Formula, Function, Operation},
    many::{Load, Machine},
    motion::SmoothForce,
};

/// constant + Σ `state`·(q, u) + Σ (a cos kt + b sin kt), `harmonics` having \[a, b\] by k, `state` what
/// displacements and velocities are multiplied by, by their places in the force.
pub(super) struct LinearForce {
    pub constant: Option<Expression>,
    pub state: BTreeMap<usize, Expression>,
    pub harmonics: BTreeMap<u32, [Option<Expression>; 2]>,
}

/// The machine with its forces in its other coefficients, if all that are formulas are linear; none for what
/// none is, also where damping ratios are of the modes without them.
pub(super) fn coefficients(machine: &Machine<Expression>) -> Option<Machine<Expression>> {
    let (n, points) = (machine.size, machine.points());
    let one = |force: &Option<SmoothForce<Expression>>| {
        force.as_ref().map(|force| LinearForce::of(force, points)).map_or(Some(None), |known| known.map(Some))
    };
    let forces: Vec<Option<LinearForce>> = machine.smooth.iter().map(one).collect::<Option<_>>()?;
    let parts: usize = forces.iter().flatten().map(|force| force.state.len()).sum();
    // By shapes each part is one of every two modes.
    let entries = if machine.shapes.is_empty() { parts } else { parts * n * n };
    if forces.is_empty() || machine.record.is_some() || entries > MOST_ENTRIES {
        return None;
    }
    if parts > 0 && !machine.damping_ratio.is_empty() {
        return None;
    }
    let mut all = Machine { smooth: Vec::new(), ..machine.clone() };
    let zero = Expression::of(&Formula::Number(BigRational::zero()), "0", "");
    let add = |to: &mut Vec<Expression>, i: usize, part: Option<Expression>| {
        to.resize(points, zero.clone());
        if let Some(part) = part {
            to[i] = to[i].plus(&part);
        }
    };
    // What a force on a coordinate is on modes, and how a coordinate is made of them.
    let modes = |i: usize| -> Vec<(usize, Option<&Expression>)> {
        match machine.shapes.get(i) {
            None => vec![(i, None)],
            Some(row) => (0..n)
                .map(|j| (j, Some(&row[j])))
                .filter(|known| !known.1.is_some_and(Expression::is_zero))
                .collect(),
        }
    };
    for (i, force) in forces.into_iter().enumerate() {
        let Some(LinearForce { constant, state, harmonics }) = force else { continue };
        add(&mut all.force, i, constant);
        for (place, part) in state {
            let to = if place < points { &mut all.stiffness } else { &mut all.damping };
            for (row, left) in modes(i) {
                for (column, right) in modes(place % points) {
                    let shaped = [left, right].into_iter().flatten().fold(part.negated(), |x, y| x.times(y));
                    to.push((row, column, shaped));
                }
            }
        }
        for (k, [cos, sin]) in harmonics {
            let place = all.forcing.iter().position(|known| known.k == k).unwrap_or_else(|| {
                all.forcing.push(Load { k, cos: Vec::new(), sin: Vec::new() });
                all.forcing.len() - 1
            });
            add(&mut all.forcing[place].cos, i, cos);
            add(&mut all.forcing[place].sin, i, sin);
        }
    }
    Some(all)
}

/// The most entries of matrices that forces are made into.
const MOST_ENTRIES: usize = 10_000;

impl LinearForce {
    /// The parts of a force; none if it is not known to have only these. Cost: linear in the formula, but for
    /// a factor of the number of harmonics.
    pub(super) fn of(force: &SmoothForce<Expression>, points: usize) -> Option<LinearForce> {
        let time = 2 * points;
        let own = |place: usize| match place.checked_sub(time + 1) {
            Some(coefficient) => force.coefficients[coefficient].root.clone(),
            None if place == time => Formula::Variable(FAR),
            None => Formula::Variable(STATE + place),
        };
        let parts = Parts::of(&force.formula.substituted(&own))?;
        let key = force.coefficients.first().map_or("", |coefficient| &coefficient.key);
        let expression = |formula: Formula| Expression::of(&formula, &force.text, key);
        let given = |formula: Term| formula.map(expression);
        Some(LinearForce {
            constant: given(parts.constant),
            state: parts.state.into_iter().map(|(place, part)| (place, expression(part))).collect(),
            harmonics: parts.harmonics.into_iter().map(|(k, both)| (k, both.map(given))).collect(),
        })
    }
}

/// Where the time of a force, and from where on its state, stand while its coefficients are in terms of
/// parameters.
const FAR: usize = usize::MAX / 2;
const STATE: usize = FAR + 1;

/// A coefficient in parameters; none for 0.
type Term = Option<Formula>;

#[derive(Default)]
struct Parts {
    constant: Term,
    state: BTreeMap<usize, Formula>,
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
            Formula::Variable(FAR) => None,
            Formula::Variable(place) => {
                Some(Parts { state: BTreeMap::from([(place - STATE, one())]), ..Parts::default() })
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
        let term = |term: Term| term.map(&change);
        Parts {
            constant: term(self.constant),
            state: self.state.into_iter().map(|(place, part)| (place, change(part))).collect(),
            harmonics: self.harmonics.into_iter().map(|(k, both)| (k, both.map(term))).collect(),
        }
    }

    fn plus(mut self, other: Parts) -> Parts {
        for (place, part) in other.state {
            let both = sum(self.state.remove(&place), Some(part));
            self.state.extend(both.map(|both| (place, both)));
        }
        for (k, [cos, sin]) in other.harmonics {
            let [own_cos, own_sin] = self.harmonics.remove(&k).unwrap_or_default();
            self.harmonics.insert(k, [sum(own_cos, cos), sum(own_sin, sin)]);
        }
        Parts { constant: sum(self.constant, other.constant), ..self }
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
        Formula::Variable(FAR) => Some((BigRational::one(), None)),
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
