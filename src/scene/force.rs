//! The key `force`: a constant, or a smooth function of displacement, velocity and time.

use std::sync::Arc;

use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use super::{
    expression::Expression,
    keys::{Entry, Value},
};
use crate::{
    error::{Error, Result},
    number::{Formula, Function, Operation},
    oscillator::{Q, SmoothForce, TIME, U},
};

/// What the variables of a force are called, by their places [`Q`], [`U`] and [`TIME`].
const NAMES: [&str; 3] = ["q", "u", "t"];

/// The highest multiple of t in a sine.
const MOST: u32 = 1000;

/// What stands under `force`.
#[derive(Debug, Clone, PartialEq)]
pub enum ForceKey {
    /// An expression in the parameters.
    Constant(Expression),
    /// One in q, u or t, too.
    Smooth(SmoothForce<Expression>),
}

impl ForceKey {
    /// The constant force and the other.
    pub(super) fn parts(self) -> Result<(Expression, Option<SmoothForce<Expression>>)> {
        Ok(match self {
            ForceKey::Constant(constant) => (constant, None),
            ForceKey::Smooth(force) => (Expression::parse("0", &[])?, Some(force)),
        })
    }
}

impl Value for ForceKey {
    fn shape() -> String {
        "expression, also in q, u and t".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        let text = entry.expression()?;
        read(&text, entry.scope.names, &entry.path).map_err(|error| entry.fail(&error.to_string()))
    }
}

fn read(text: &str, parameters: &[String], key: &str) -> Result<ForceKey> {
    let count = parameters.len();
    let names: Vec<String> = parameters.iter().cloned().chain(NAMES.map(String::from)).collect();
    let mut whole = Expression::parse(text, &names)?;
    whole.key = key.to_string();
    if !whole.mentions(&|place| place >= count) {
        return Ok(ForceKey::Constant(whole));
    }
    // A parameter of the same name hides the variable: then nobody knows which is meant.
    let hidden = |place: usize| place < count && NAMES.contains(&parameters[place].as_str());
    if let Some(name) = NAMES.iter().find(|name| parameters.iter().any(|known| known == *name))
        && whole.mentions(&hidden)
    {
        return Err(Error::input(format!(
            "{name} is a parameter of the scene, and the displacement, velocity or time of a force: rename the parameter"
        )));
    }
    if let Some(left) = drift(&whole.root, count + TIME)
        && left.is_zero()
    {
        let mut coefficients = Vec::new();
        let formula = split(&whole.root, count, &whole, &mut coefficients);
        let text = text.split_whitespace().collect();
        return Ok(ForceKey::Smooth(SmoothForce { formula: Arc::new(formula), text, coefficients }));
    }
    Err(Error::input(format!(
        "is not periodic in t: t may stand in sin(k*t + …) and cos(k*t + …), k a whole number up to {MOST} that is \
         written out; t is the angle of the forcing, whose period is 2*pi"
    )))
}

/// What a formula gains while t, at this place, gains 2π, over 2π: 0 if it is periodic, k for kt and
/// something periodic; none if it is not known to be of this kind.
fn drift(formula: &Formula, time: usize) -> Option<BigRational> {
    if !formula.mentions(&|place| place == time) {
        return Some(BigRational::zero());
    }
    let periodic = |inner: &Formula| drift(inner, time).filter(Zero::is_zero);
    match formula {
        Formula::Variable(_) => Some(BigRational::one()),
        Formula::Negated(inner) => drift(inner, time).map(|k| -k),
        Formula::Binary(operation, parts) => {
            let [left, right] = &**parts;
            let both = || Some((drift(left, time)?, drift(right, time)?));
            match operation {
                Operation::Sum => both().map(|(x, y)| x + y),
                Operation::Difference => both().map(|(x, y)| x - y),
                Operation::Product => match (number(left), number(right)) {
                    (Some(factor), _) => drift(right, time).map(|k| k * factor),
                    (_, Some(factor)) => drift(left, time).map(|k| k * factor),
                    _ => periodic(left).and_then(|_| periodic(right)),
                },
                Operation::Quotient => match number(right).filter(|divisor| !divisor.is_zero()) {
                    Some(divisor) => drift(left, time).map(|k| k / divisor),
                    None => periodic(left).and_then(|_| periodic(right)),
                },
            }
        }
        Formula::Power(inner, _) => periodic(inner),
        Formula::Call(Function::Sin | Function::Cos, inner) => {
            let k = drift(inner, time)?;
            let small =
                k.is_integer() && k.to_integer().to_i64().is_some_and(|k| k.unsigned_abs() <= MOST.into());
            small.then(BigRational::zero)
        }
        Formula::Call(_, inner) => periodic(inner),
        Formula::Number(_) | Formula::Pi => None,
    }
}

/// The value of a formula of numbers alone.
fn number(formula: &Formula) -> Option<BigRational> {
    if !formula.is_rational() || formula.mentions(&|_| true) {
        return None;
    }
    Expression::of(formula, "", "").evaluate(&[], &()).ok()
}

/// The formula in q, u, t and coefficients: each of these is as large a part as has only parameters and
/// numbers in it, joined by + − · / and powers, so that its value is exact.
fn split(formula: &Formula, count: usize, whole: &Expression, coefficients: &mut Vec<Expression>) -> Formula {
    if formula.is_rational() && !formula.mentions(&|place| place >= count) {
        if let Formula::Number(_) = formula {
            return formula.clone();
        }
        let known = coefficients.iter().position(|known| known.root == *formula);
        let place = known.unwrap_or_else(|| {
            coefficients.push(Expression::of(formula, &whole.text, &whole.key));
            coefficients.len() - 1
        });
        return Formula::Variable([Q, U, TIME].len() + place);
    }
    let mut inner = |part: &Formula| Box::new(split(part, count, whole, coefficients));
    match formula {
        Formula::Variable(place) => Formula::Variable(place - count),
        Formula::Negated(part) => Formula::Negated(inner(part)),
        Formula::Power(part, exponent) => Formula::Power(inner(part), *exponent),
        Formula::Call(function, part) => Formula::Call(*function, inner(part)),
        Formula::Binary(operation, parts) => {
            let [left, right] = [&parts[0], &parts[1]].map(|part| *inner(part));
            Formula::Binary(*operation, Box::new([left, right]))
        }
        Formula::Number(_) | Formula::Pi => formula.clone(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn force(text: &str) -> Result<ForceKey> {
        read(text, &["a".to_string(), "w".to_string()], "system.force")
    }

    #[test]
    fn what_depends_on_time_is_periodic() {
        for text in [
            "cos(t)",
            "q*sin(2*t - q)",
            "exp(cos(t))^2/(2 + sin(-3*t + pi/4))",
            "cos((t + q)*2)",
            "cos(6*t/3) + a*cos(2*(t - t) + 1)*q",
            "sin(t/2 + t/2)",
        ] {
            assert!(matches!(force(text), Ok(ForceKey::Smooth(_))), "{text}");
        }
        for text in
            ["t", "q + t", "cos(w*t)", "cos(t/2)", "exp(t)", "cos(t)*t", "t^2", "sin(1001*t)", "cos(t*t)"]
        {
            let error = force(text).unwrap_err().to_string();
            assert!(error.contains("is not periodic in t"), "{text}: {error}");
        }
        for text in ["a*w", "1/3", "sqrt(4)*a"] {
            assert!(matches!(force(text), Ok(ForceKey::Constant(_))), "{text}");
        }
    }

    #[test]
    fn coefficients_are_the_largest_parts_that_have_exact_values() {
        let ForceKey::Smooth(force) = force("-2*a/w*q + (a + 1)^2*sin(q)*3 - 2*a/w*u + pi*a").unwrap() else {
            panic!("depends on q")
        };
        // 2*a/w with its sign once, (a + 1)^2, 2*a/w, a.
        assert_eq!(force.coefficients.len(), 4, "{:?}", force.coefficients);
        assert_eq!(force.text(), "-2*a/w*q+(a+1)^2*sin(q)*3-2*a/w*u+pi*a");
    }

    #[test]
    fn a_parameter_that_hides_a_variable_is_refused() {
        let names = ["q".to_string()];
        assert!(matches!(read("2*q", &names, ""), Ok(ForceKey::Constant(_))));
        assert!(matches!(read("sin(u)", &names, ""), Ok(ForceKey::Smooth(_))));
        assert!(read("q*u", &names, "").unwrap_err().to_string().contains("rename the parameter"));
    }
}
