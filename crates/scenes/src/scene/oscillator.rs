//! What a scene says to the engine `one`, if its system qualifies: an oscillator of mass 1 with one degree of
//! freedom, whose forcing has period 2π, between rigid stops.
//!
//! All that is made into it is exact: a mass divides forces as expressions, another period multiplies them by
//! powers of the time in a radian, and a row −1 changes signs. The first rounding is that of a coefficient's
//! value.

use std::sync::Arc;

use num_rational::BigRational;
use num_traits::{One, Zero};

use super::{
    expression::Expression,
    force::{ForceKey, Variables},
    keys::Entry,
    linear::LinearForce,
    machine::{name, negated},
    matrix::{CoordinateList, MatrixValue},
    restitution::RestitutionKey,
    system::{LoadKeys, StopKeys, SystemKeys, harmonics},
};
use crate::{
    error::Result,
    formula::{Formula, Function, Operation},
    motion::{Harmonic, Q, Side, SmoothForce, System, TIME, U, Wall},
};

/// Why a system is not one for `one`: the key that disqualifies it, and what it says.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Disqualified {
    pub key: String,
    pub why: String,
}

type Qualified<T> = Result<std::result::Result<T, Disqualified>>;

fn not<T>(key: impl Into<String>, why: impl Into<String>) -> Qualified<T> {
    Ok(Err(Disqualified { key: key.into(), why: why.into() }))
}

/// The side of each stop and the oscillator, or what disqualifies it; its keys fit one another.
pub(super) fn oscillator(
    file: &Entry,
    keys: &SystemKeys,
    stops: &[StopKeys],
) -> Qualified<(Vec<Side>, System<Expression>)> {
    let has = [
        ("modes", keys.modes.is_some(), "has `modes`"),
        ("measured", keys.measured.is_some(), "has a measured force"),
    ];
    if let Some((key, _, why)) = has.into_iter().find(|known| known.1) {
        return not(format!("system.{key}"), why);
    }
    let size = keys.mass.as_ref().map_or(1, |mass| mass.rows);
    if size > 1 {
        return not("system.mass", format!("has {size} degrees of freedom"));
    }
    let radian = radian(keys);
    // What divides all forces: none for 1, so that nothing is changed.
    let mass = match keys.mass.as_ref().map(|mass| mass.entries.first()) {
        Some(None) => return not("system.mass", "has no mass"),
        Some(Some((_, _, mass))) if !is_one(mass) => Some(mass),
        _ => None,
    };
    // Forces per mass in the unit of time in which a radian takes 1.
    let per_radian = |given: &Expression, times: i32| match &radian {
        Some(radian) if !given.is_zero() => cancelled(&given.times(&radian.to_the(times))),
        _ => given.clone(),
    };
    let over_mass = |given: &Expression, times: i32| {
        per_radian(&mass.map_or_else(|| given.clone(), |mass| given.over(mass)), times)
    };
    let zero = Expression::parse("0", &[])?;
    let or_zero = |given: Option<&Expression>, times: i32| {
        given.map_or_else(|| zero.clone(), |given| over_mass(given, times))
    };
    let coefficient = |given: &Option<MatrixValue>, times: i32| {
        or_zero(given.as_ref().and_then(|all| all.entries.first()).map(|entry| &entry.2), times)
    };
    // c = 2 ζ √(km), per mass.
    let damping = match keys.damping_ratio.as_ref().and_then(|all| all.entries.first()) {
        Some(ratio) => {
            let one = Expression::parse("1", &[])?;
            let own = keys.stiffness.as_ref().and_then(|all| all.entries.first());
            let own = own.map_or_else(|| zero.clone(), |entry| entry.2.over(mass.unwrap_or(&one)));
            per_radian(&ratio.times(&own.root().times(&Expression::parse("2", &[])?)), 1)
        }
        None => coefficient(&keys.damping, 1),
    };
    let load = |given: &CoordinateList| or_zero(given.entries.first(), 2);
    let forcing = |given: &LoadKeys| Harmonic { k: given.k, cos: load(&given.cos), sin: load(&given.sin) };
    let force = match mass {
        Some(mass) => keys.force.mapped(|text| format!("({text})/({mass})")),
        None => keys.force.clone(),
    };
    let force = force.read_all(&file.at("system.force"), &Variables::of(1, file.scope.format))?;
    let force = force.into_iter().next().map_or_else(|| ForceKey::constant("0"), Ok)?;
    let (force, mut smooth) = force.parts()?;
    if smooth.as_ref().is_some_and(SmoothForce::has_kinks) {
        return not("system.force", "has a force with kinks");
    }
    let linear = smooth.as_ref().and_then(|force| LinearForce::of(force, 1));
    if linear.is_some() {
        smooth = None;
    }
    if let (Some(force), Some(radian)) = (&mut smooth, &radian) {
        *force = in_radians(force, radian);
    }
    let mut system = System {
        damping,
        stiffness: coefficient(&keys.stiffness, 2),
        cubic: or_zero(keys.cubic.as_ref(), 2),
        force: per_radian(&force, 2),
        forcing: keys.forcing.iter().map(forcing).collect(),
        smooth,
        lower: None,
        upper: None,
        rate: radian.as_ref().map(|radian| radian.to_the(-1)),
    };
    if let Some(linear) = linear {
        add(&mut system, linear, &per_radian);
    }
    let mut sides = Vec::new();
    for (i, keys) in (1..).zip(stops) {
        let (side, wall) = match wall(file, i, keys)? {
            Ok(found) => found,
            Err(why) => return Ok(Err(why)),
        };
        let place = match side {
            Side::Lower => &mut system.lower,
            Side::Upper => &mut system.upper,
        };
        if place.replace(wall).is_some() {
            return not(format!("stops[{i}]"), format!("has two stops on the {} side", side.name()));
        }
        sides.push(side);
    }
    Ok(Ok((sides, system)))
}

/// Adds a linear force to a system, its parts made into those of the unit of time of a radian.
fn add(
    system: &mut System<Expression>,
    force: LinearForce,
    per_radian: &impl Fn(&Expression, i32) -> Expression,
) {
    let LinearForce { constant, mut state, harmonics } = force;
    let add = |to: &mut Expression, part: Option<Expression>, times: i32| {
        if let Some(part) = part {
            *to = to.plus(&per_radian(&part, times));
        }
    };
    add(&mut system.force, constant, 2);
    add(&mut system.stiffness, state.remove(&Q).map(|part| part.negated()), 2);
    add(&mut system.damping, state.remove(&U).map(|part| part.negated()), 1);
    for (k, [cos, sin]) in harmonics {
        let place = system.forcing.iter().position(|known| known.k == k).unwrap_or_else(|| {
            let zero = Expression::of(&Formula::Number(BigRational::zero()), "0", "");
            system.forcing.push(Harmonic { k, cos: zero.clone(), sin: zero });
            system.forcing.len() - 1
        });
        add(&mut system.forcing[place].cos, cos, 2);
        add(&mut system.forcing[place].sin, sin, 2);
    }
}

/// Stop i, counted from 1, as a wall on one side.
fn wall(file: &Entry, i: usize, keys: &StopKeys) -> Qualified<(Side, Wall<Expression>)> {
    let path = format!("stops[{i}]");
    let (name, word) = (name(keys, i), file.scope.format.stop());
    if keys.law.is_some() {
        return not(format!("{path}.law"), format!("has a {word}, {name}, with a law of its own"));
    }
    let restitution = match &keys.restitution {
        Some(RestitutionKey::Constant(restitution)) => restitution.clone(),
        Some(RestitutionKey::Speed(_)) => {
            return not(
                format!("{path}.restitution"),
                format!("has a {word}, {name}, whose restitution depends on the speed v"),
            );
        }
        None => return not(format!("{path}.stiffness"), format!("has a compliant stop, {name}")),
    };
    let harmonics = harmonics(file, keys.harmonics.clone(), &format!("{path}.harmonics"))?;
    let row = keys.row.as_ref().map(|row| &row.entries[0]);
    Ok(Ok(match (keys.side, row) {
        (Some(side), _) => (side, Wall { offset: keys.offset.clone(), harmonics, restitution }),
        (None, row) if row.is_none_or(is_one) => {
            (Side::Lower, Wall { offset: keys.offset.clone(), harmonics, restitution })
        }
        (None, Some(row)) if is_one(&row.negated()) => {
            let harmonics = negated(&harmonics);
            (Side::Upper, Wall { offset: keys.offset.negated(), harmonics, restitution })
        }
        _ => return not(format!("{path}.row"), format!("has a stop, {name}, whose row is not 1 or −1")),
    }))
}

/// Whether it is the number 1, whatever the parameters are.
fn is_one(expression: &Expression) -> bool {
    !expression.mentions(&|_| true) && expression.evaluate::<BigRational>(&[], &()).is_ok_and(|x| x.is_one())
}

/// The same acceleration in the unit of time in which a radian takes 1.
fn in_radians(force: &SmoothForce<Expression>, radian: &Expression) -> SmoothForce<Expression> {
    let mut coefficients = force.coefficients.clone();
    // After the three variables.
    let first = TIME + 1 + coefficients.len();
    coefficients.extend([radian.to_the(2), radian.to_the(-1)]);
    let times = |a, b| Formula::Binary(Operation::Product, Box::new([a, b]));
    let shown = |place| match Formula::Variable(place) {
        velocity if place == U => times(velocity, Formula::Variable(first + 1)),
        other => other,
    };
    let formula = times(force.formula.substituted(&shown), Formula::Variable(first));
    SmoothForce { formula: Arc::new(formula), text: force.text.clone(), coefficients }
}

/// The time in which the forcing's phase goes on by a radian, T/2π; none where it is 1 for all parameters.
fn radian(keys: &SystemKeys) -> Option<Expression> {
    let two = || Formula::Number(BigRational::from_integer(2.into()));
    let quotient = |a, b| Formula::Binary(Operation::Quotient, Box::new([a, b]));
    let product = |a, b| Formula::Binary(Operation::Product, Box::new([a, b]));
    let one = || Formula::Number(BigRational::one());
    let (key, above, below) = match (&keys.period, &keys.frequency) {
        (Some(period), _) => (period, period.root.clone(), one()),
        (None, Some(frequency)) => match &frequency.root {
            Formula::Binary(Operation::Quotient, parts) => (frequency, parts[1].clone(), parts[0].clone()),
            root => (frequency, one(), root.clone()),
        },
        (None, None) => return None,
    };
    let root = quotient(quotient(above, Formula::Pi), product(two(), below));
    let text = if keys.period.is_some() { format!("({key})/(2*pi)") } else { format!("1/(2*pi*({key}))") };
    Some(cancelled(&Expression::of(&root, &text, &key.key))).filter(|radian| !is_one(radian))
}

/// A formula as another one times a power of π, which is taken out of products, quotients, powers and roots,
/// and out of sums where both parts have the same.
fn without_pi(formula: &Formula) -> (Formula, i32) {
    let taken = match formula {
        Formula::Pi => Some((Formula::Number(BigRational::one()), 1)),
        Formula::Negated(inner) => {
            let (inner, n) = without_pi(inner);
            Some((Formula::Negated(Box::new(inner)), n))
        }
        Formula::Power(inner, exponent) => {
            let (inner, n) = without_pi(inner);
            n.checked_mul(*exponent).map(|n| (Formula::Power(Box::new(inner), *exponent), n))
        }
        Formula::Call(Function::Sqrt, inner) => {
            let (inner, n) = without_pi(inner);
            (n % 2 == 0).then(|| (Formula::Call(Function::Sqrt, Box::new(inner)), n / 2))
        }
        Formula::Binary(operation, parts) => {
            let [(left, i), (right, j)] = parts.each_ref().map(without_pi);
            let n = match operation {
                Operation::Product => i.checked_add(j),
                Operation::Quotient => i.checked_sub(j),
                Operation::Sum | Operation::Difference => (i == j).then_some(i),
            };
            n.map(|n| (Formula::Binary(*operation, Box::new([left, right])), n))
        }
        _ => None,
    };
    taken.unwrap_or_else(|| (formula.clone(), 0))
}

/// The same without π where that cancels: what is rational is computed exactly.
fn cancelled(expression: &Expression) -> Expression {
    match without_pi(&expression.root) {
        (root, 0) => Expression::of(&root, &expression.text, &expression.key),
        _ => expression.clone(),
    }
}
