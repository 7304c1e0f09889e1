//! The key `force`: a constant, or a smooth function of displacement, velocity and time; of a machine one for
//! each coordinate, of all displacements and velocities.

use std::sync::Arc;

use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use super::{
    expression::Expression,
    format::SceneFormat,
    keys::{Entry, Value},
};
use crate::{
    error::{Error, Result},
    formula::{Formula, Function, Operation},
    motion::{Q, SmoothForce, TIME, U},
};

/// What the variables of a force are called, and the place of each.
pub(super) struct Variables {
    names: Vec<(String, usize)>,
    /// That of the time, which is the last, whether it has a name or not.
    time: usize,
}

impl Variables {
    /// Those of so many coordinates in a format.
    pub(super) fn of(points: usize, format: SceneFormat) -> Variables {
        if format == SceneFormat::One { Variables::of_oscillator() } else { Variables::of_machine(points) }
    }

    /// Those of the force of a stop: the depth and the speed of closing.
    pub(super) fn of_contact() -> Variables {
        Variables {
            names: [("d", 0), ("v", 1)].map(|(name, place)| (name.to_string(), place)).to_vec(),
            time: 2,
        }
    }

    /// That of a coefficient of friction: the sliding speed.
    pub(super) fn of_sliding() -> Variables {
        Variables { names: vec![("v".to_string(), 0)], time: 1 }
    }

    /// Of an oscillator: [`Q`], [`U`] and [`TIME`].
    fn of_oscillator() -> Variables {
        let names = [("q", Q), ("u", U), ("t", TIME)].map(|(name, place)| (name.to_string(), place));
        Variables { names: names.to_vec(), time: TIME }
    }

    /// Of a machine with n coordinates: q1 to qn, u1 to un and t; of one, q and u, too.
    fn of_machine(n: usize) -> Variables {
        let named = |letter: &str, from: usize| -> Vec<(String, usize)> {
            (0..n).map(|i| (format!("{letter}{}", i + 1), from + i)).collect()
        };
        let mut all = if n == 1 { Variables::of_oscillator().names } else { vec![("t".to_string(), 2 * n)] };
        all.extend(named("q", 0));
        all.extend(named("u", n));
        Variables { names: all, time: 2 * n }
    }
}

/// The highest multiple of t in a sine.
pub(super) const MOST: u32 = 1000;

/// What stands under `force`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum ForceKey {
    /// An expression in the parameters.
    Constant(Expression),
    /// One in q, u or t, too.
    Smooth(SmoothForce<Expression>),
}

impl ForceKey {
    /// A number.
    pub(super) fn constant(text: &str) -> Result<ForceKey> {
        Expression::parse(text, &[]).map(ForceKey::Constant)
    }

    /// The constant force and the other.
    pub(super) fn parts(self) -> Result<(Expression, Option<SmoothForce<Expression>>)> {
        Ok(match self {
            ForceKey::Constant(constant) => (constant, None),
            ForceKey::Smooth(force) => (Expression::parse("0", &[])?, Some(force)),
        })
    }
}

/// The forces on the coordinates of a machine, as they are written: how many there are is not known yet.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ForceList {
    /// Each with its key.
    texts: Vec<(String, String)>,
}

impl Value for ForceList {
    fn shape() -> String {
        "expression, or a list of them, also in q1, q2, …, u1, u2, … and t".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        let one = |entry: &Entry| Ok((entry.expression()?, entry.path.clone()));
        let texts = if entry.item.is_array() {
            entry.elements()?.iter().map(one).collect::<Result<_>>()?
        } else {
            vec![one(entry)?]
        };
        Ok(ForceList { texts })
    }
}

/// A function of the motion, as it is written.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FunctionText(ForceList);

impl Value for FunctionText {
    fn shape() -> String {
        "expression in the displacements, the velocities and t".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        Ok(FunctionText(ForceList { texts: vec![(entry.expression()?, entry.path.clone())] }))
    }
}

impl FunctionText {
    /// The function, of these variables.
    pub(super) fn fit(&self, place: &Entry, variables: &Variables) -> Result<SmoothForce<Expression>> {
        match self.0.read_all(place, variables)?.pop() {
            Some(ForceKey::Smooth(function)) => Ok(function),
            _ => Err(place.fail("is a constant, which passes 0 nowhere: write a function of q, u or t")),
        }
    }
}

/// The constant forces, none for all zero, and the others, none if there are none.
type Forces = (Vec<Expression>, Vec<Option<SmoothForce<Expression>>>);

impl ForceList {
    /// The same forces with their texts made into others.
    pub(super) fn mapped(&self, text: impl Fn(&str) -> String) -> ForceList {
        ForceList { texts: self.texts.iter().map(|(old, key)| (text(old), key.clone())).collect() }
    }

    /// What stands there, one after the other.
    pub(super) fn read_all(&self, place: &Entry, variables: &Variables) -> Result<Vec<ForceKey>> {
        let one = |(text, key): &(String, String)| {
            read(text, place.scope.names, key, variables)
                .map_err(|error| place.at(key).fail(&error.to_string()))
        };
        self.texts.iter().map(one).collect()
    }

    /// The forces on so many coordinates; `place` is the key of them all.
    pub(super) fn fit(self, place: &Entry, points: usize, variables: &Variables) -> Result<Forces> {
        let keys = self.read_all(place, variables)?;
        let zero = |key: &ForceKey| matches!(key, ForceKey::Constant(constant) if constant.is_zero());
        if keys.len() <= 1 && keys.iter().all(zero) {
            return Ok((Vec::new(), Vec::new()));
        }
        if keys.len() != points {
            let (found, plural) = (keys.len(), if points == 1 { "" } else { "s" });
            return Err(
                place.fail(&format!("has {found} entries; the machine has {points} coordinate{plural}"))
            );
        }
        let parts = keys.into_iter().map(ForceKey::parts).collect::<Result<Vec<_>>>()?;
        let (constant, mut smooth): Forces = parts.into_iter().unzip();
        if smooth.iter().all(Option::is_none) {
            smooth.clear();
        }
        Ok((constant, smooth))
    }
}

pub(super) fn read(text: &str, parameters: &[String], key: &str, variables: &Variables) -> Result<ForceKey> {
    let count = parameters.len();
    let own = variables.names.iter().map(|known| known.0.clone());
    let names: Vec<String> = parameters.iter().cloned().chain(own).collect();
    let mut whole = Expression::parse(text, &names)?;
    whole.key = key.to_string();
    if !whole.mentions(&|place| place >= count) {
        return Ok(ForceKey::Constant(whole));
    }
    // A parameter of the same name hides the variable: then nobody knows which is meant.
    let is_variable = |name: &str| variables.names.iter().any(|known| known.0 == name);
    let hidden = |place: usize| place < count && is_variable(&parameters[place]);
    if let Some(name) = parameters.iter().find(|name| is_variable(name))
        && whole.mentions(&hidden)
    {
        return Err(Error::input(format!(
            "{name} is a parameter of the scene, and a displacement, a depth, a velocity or the time of a force: rename the \
             parameter"
        )));
    }
    let time = variables.names.iter().position(|known| known.1 == variables.time);
    let left = time.map_or_else(|| Some(BigRational::zero()), |time| drift(&whole.root, count + time));
    if left.is_some_and(|left| left.is_zero()) {
        let mut coefficients = Vec::new();
        let formula = split(&whole.root, (count, variables), &whole, &mut coefficients);
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
        Formula::Power(inner, _) | Formula::Raised(inner, _) => periodic(inner),
        Formula::Choice(choice) => {
            let periods = choice.parts().map(periodic);
            periods.iter().all(Option::is_some).then(BigRational::zero)
        }
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

/// The formula in variables and coefficients: each of these is as large a part as has only parameters and
/// numbers in it, joined by + − · / and powers, so that its value is exact.
fn split(
    formula: &Formula,
    (count, variables): (usize, &Variables),
    whole: &Expression,
    coefficients: &mut Vec<Expression>,
) -> Formula {
    if formula.is_rational() && !formula.mentions(&|place| place >= count) {
        if let Formula::Number(_) = formula {
            return formula.clone();
        }
        let known = coefficients.iter().position(|known| known.root == *formula);
        let place = known.unwrap_or_else(|| {
            coefficients.push(Expression::of(formula, &whole.text, &whole.key));
            coefficients.len() - 1
        });
        return Formula::Variable(variables.time + 1 + place);
    }
    let mut inner = |part: &Formula| Box::new(split(part, (count, variables), whole, coefficients));
    match formula {
        Formula::Variable(place) => Formula::Variable(variables.names[place - count].1),
        Formula::Negated(part) => Formula::Negated(inner(part)),
        Formula::Power(part, exponent) => Formula::Power(inner(part), *exponent),
        Formula::Call(function, part) => Formula::Call(*function, inner(part)),
        Formula::Raised(part, exponent) => Formula::Raised(inner(part), exponent.clone()),
        Formula::Choice(choice) => Formula::Choice(Box::new(choice.mapped(|part| *inner(part)))),
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
        read(text, &["a".to_string(), "w".to_string()], "system.force", &Variables::of_oscillator())
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
        assert_eq!(force.text, "-2*a/w*q+(a+1)^2*sin(q)*3-2*a/w*u+pi*a");
    }

    #[test]
    fn a_parameter_that_hides_a_variable_is_refused() {
        let names = ["q".to_string()];
        let read = |text: &str| read(text, &names, "", &Variables::of_oscillator());
        assert!(matches!(read("2*q"), Ok(ForceKey::Constant(_))));
        assert!(matches!(read("sin(u)"), Ok(ForceKey::Smooth(_))));
        assert!(read("q*u").unwrap_err().to_string().contains("rename the parameter"));
    }
}
