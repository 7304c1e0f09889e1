//! Coefficients as expressions in named parameters: `"2*d/w"`, `"1/w^2"`, `"(1 + mu)/3"`, `"sqrt(k/m)"`,
//! written as `grammar` says.
//!
//! A value is exact where it is rational (√ of a square, e⁰); other values there are on rungs that have the
//! functions: floats, duals, enclosures. log, tanh, kinks and powers that are not whole have none, and stand
//! in forces alone.

use std::fmt;

use num_rational::BigRational;
use num_traits::Zero;
use serde::{Serialize, Serializer};

use super::{
    dual::Dual,
    grammar::{self, LIMIT_BITS},
};
use crate::{
    error::{Error, Result},
    formula::{Formula, Function, Operation},
    number::{Ball, BoundedFraction, Elementary, FloatInterval, Plain, Precision, Real, Sign},
    search::{chaos::RationalFunction, orbit::Quotient},
};

/// The most bits of an exact value's numerator and denominator, not in lowest terms, at every step of its
/// evaluation.
const LIMIT_VALUE: u32 = 4 * LIMIT_BITS;

/// An expression in a scene's parameters, which it knows by their places in the scene's list.
#[derive(Debug, Clone, PartialEq)]
pub struct Expression {
    pub(super) text: String,
    pub(super) root: Formula,
    /// The key whose value it is, empty if none; an error is reported there.
    pub(super) key: String,
}

/// A function's value on a rung that has the elementary functions.
fn call<T: Elementary>(function: Function, x: &T, context: &T::Context) -> Result<T> {
    if function == Function::Sqrt && x.sign() == Some(Sign::Negative) {
        return Err(Error::input("takes the root of a negative number"));
    }
    Ok(match function {
        Function::Sqrt => x.sqrt(),
        Function::Exp => x.exp(context),
        Function::Sin => x.sin_cos(context).0,
        Function::Cos => x.sin_cos(context).1,
        Function::Log | Function::Tanh => {
            return Err(only_in_forces(&format!("{}(…)", function.name())));
        }
    })
}

impl Expression {
    /// Reads an expression in the named parameters. Cost: linear in the text and in the size of the numbers.
    ///
    /// # Errors
    /// An input error that says at which character what was expected, or which parameter is unknown and the
    /// nearest that is known; also for more than 256 factors and terms or 32 levels of parentheses.
    ///
    /// ```
    /// use grazing_scenes::{number::parse_rational, scene::Expression};
    /// let names = ["d".to_string(), "w".to_string()];
    /// let values = [parse_rational("0.6")?, parse_rational("4.9")?];
    /// let damping = Expression::parse("2*d/w", &names)?;
    /// assert_eq!(damping.evaluate(&values, &())?, parse_rational("12/49")?);
    /// assert!(Expression::parse("2*d/v", &names).is_err());
    /// # Ok::<(), grazing_scenes::Error>(())
    /// ```
    pub fn parse(text: &str, names: &[String]) -> Result<Expression> {
        let root = grammar::formula(text, names)?;
        Ok(Expression { text: text.to_string(), root, key: String::new() })
    }

    /// A part of an expression, reported with the whole's text at its key.
    pub(super) fn of(root: &Formula, text: &str, key: &str) -> Expression {
        Expression { text: text.to_string(), root: root.clone(), key: key.to_string() }
    }

    /// −x, reported at the key of x.
    pub(super) fn negated(&self) -> Expression {
        Expression::of(&Formula::Negated(Box::new(self.root.clone())), &format!("-({self})"), &self.key)
    }

    /// x/y, reported at the key of x.
    pub(super) fn over(&self, other: &Expression) -> Expression {
        let parts = Box::new([self.root.clone(), other.root.clone()]);
        let text = format!("({self})/({other})");
        Expression::of(&Formula::Binary(Operation::Quotient, parts), &text, &self.key)
    }

    /// xy, reported at the key of x.
    pub(super) fn times(&self, other: &Expression) -> Expression {
        let parts = Box::new([self.root.clone(), other.root.clone()]);
        Expression::of(&Formula::Binary(Operation::Product, parts), &format!("({self})*({other})"), &self.key)
    }

    /// x + y, reported at the key of x.
    pub(super) fn plus(&self, other: &Expression) -> Expression {
        if self.is_zero() {
            return other.clone();
        }
        let parts = Box::new([self.root.clone(), other.root.clone()]);
        Expression::of(&Formula::Binary(Operation::Sum, parts), &format!("{self} + {other}"), &self.key)
    }

    /// √x, reported at the key of x.
    pub(super) fn root(&self) -> Expression {
        let root = Formula::Call(Function::Sqrt, Box::new(self.root.clone()));
        Expression::of(&root, &format!("sqrt({self})"), &self.key)
    }

    /// x^n, reported at the key of x.
    pub(super) fn to_the(&self, n: i32) -> Expression {
        let root = Formula::Power(Box::new(self.root.clone()), n);
        Expression::of(&root, &format!("({self})^{n}"), &self.key)
    }

    /// Whether its values are rational where its parameters' are.
    pub(crate) fn is_rational(&self) -> bool {
        self.root.is_rational()
    }

    /// Whether it is a zero written out.
    pub(super) fn is_zero(&self) -> bool {
        matches!(&self.root, Formula::Number(value) if value.is_zero())
    }

    /// Its value, `parameters` being the values of the names it was read with, in their order. An enclosure
    /// if they are. Cost: at most 256 operations, on exact fractions of at most 16384 bits.
    ///
    /// # Errors
    /// An input error for a division by what is certainly zero, and where an exact value, or a step on the
    /// way to it, would have more than 16384 bits in its numerator or denominator.
    ///
    /// # Panics
    /// If there are fewer values than there were names.
    pub fn evaluate<T: Coefficient>(&self, parameters: &[T], context: &T::Context) -> Result<T> {
        T::value(self, parameters, context)
    }

    /// Whether one of some parameters, told by their places, stands in it.
    pub(crate) fn mentions(&self, which: &dyn Fn(usize) -> bool) -> bool {
        self.root.mentions(which)
    }
}

/// A rung on which expressions are evaluated.
pub trait Coefficient: Real {
    /// [`Expression::evaluate`].
    ///
    /// # Errors
    /// As [`Expression::evaluate`].
    fn value(expression: &Expression, parameters: &[Self], context: &Self::Context) -> Result<Self> {
        evaluate(&expression.root, parameters, context)
    }

    /// π.
    ///
    /// # Errors
    /// An input error on a rung without it.
    fn pi(_: &Self::Context) -> Result<Self> {
        Err(irrational("pi"))
    }

    /// A function's value.
    ///
    /// # Errors
    /// An input error on a rung that does not have the value, and for the root of a negative number.
    fn call(function: Function, _: &Self, _: &Self::Context) -> Result<Self> {
        Err(irrational(&format!("{}(…)", function.name())))
    }
}

fn irrational(what: &str) -> Error {
    Error::input(format!("{what} is irrational, where an exact value is needed; write a fraction"))
}

/// The elementary functions of a rung that has them.
macro_rules! elementary {
    ($($type:ty),+) => {
        $(impl Coefficient for $type {
            fn pi(context: &Self::Context) -> Result<Self> {
                Ok(<$type as Elementary>::pi(context))
            }

            fn call(function: Function, x: &Self, context: &Self::Context) -> Result<Self> {
                call(function, x, context)
            }
        })+
    };
}
elementary! { Plain, Ball, crate::search::orbit::Jet }

/// Of numbers that are not rational in quotients of polynomials: more than the digits of a certificate take.
const BITS: u32 = 256;

/// π, between two numbers.
fn pi_between() -> Result<[BigRational; 2]> {
    let bounds = <Ball as Elementary>::pi(&Precision::new(BITS)).exact_bounds();
    bounds.map(|(lo, hi)| [lo, hi]).ok_or_else(|| irrational("pi"))
}

/// A function's values between two numbers.
fn call_between(function: Function, x: Option<[BigRational; 2]>) -> Result<[BigRational; 2]> {
    let not =
        || Error::input(format!("{}(…) is no quotient of polynomials in the parameter", function.name()));
    let [lo, hi] = x.ok_or_else(not)?;
    if let Some(value) = function.exactly(&lo).filter(|_| lo == hi) {
        return Ok([value.clone(), value]);
    }
    let precision = Precision::new(BITS);
    let bounds = call(function, &Ball::between(&lo, &hi, &precision), &precision)?.exact_bounds();
    bounds.map(|(lo, hi)| [lo, hi]).ok_or_else(not)
}

/// The elementary functions of numbers, of what is a quotient of polynomials in a parameter: a function of
/// the parameter is none.
macro_rules! between {
    ($($type:ty: $value:expr),+) => {
        $(impl Coefficient for $type {
            fn pi((): &()) -> Result<Self> {
                Ok(Self::between(pi_between()?.each_ref()))
            }

            fn call(function: Function, x: &Self, (): &()) -> Result<Self> {
                Ok(Self::between(call_between(function, $value(x))?.each_ref()))
            }
        })+
    };
}
between! { Quotient: Quotient::constant, RationalFunction: RationalFunction::value }

/// Of what lies between floats.
impl Coefficient for FloatInterval {
    fn pi((): &()) -> Result<Self> {
        Ok(wide(pi_between()?))
    }

    fn call(function: Function, x: &Self, (): &()) -> Result<Self> {
        call_between(function, x.exact_bounds().map(|(lo, hi)| [lo, hi])).map(wide)
    }
}

fn wide(ends: [BigRational; 2]) -> FloatInterval {
    let [lo, hi] = ends.map(|x| FloatInterval::ratio(&x, &()));
    FloatInterval::from_bounds(lo.lo(), hi.hi())
}

impl Coefficient for Dual {
    fn pi((): &()) -> Result<Self> {
        Ok(Dual::constant(std::f64::consts::PI))
    }

    fn call(function: Function, x: &Self, (): &()) -> Result<Self> {
        let value = call(function, &Plain(x.value), &())?.0;
        let slope = match function {
            Function::Sqrt => 0.5 / value,
            Function::Exp => value,
            Function::Sin => x.value.cos(),
            Function::Cos => -x.value.sin(),
            Function::Log => 1.0 / x.value,
            Function::Tanh => 1.0 - value * value,
        };
        // The root of 0 does not vary where its argument does not.
        let slope = if x.slope == 0.0 { 0.0 } else { slope * x.slope };
        Ok(Dual { value, slope })
    }
}

/// What is too large stays so.
impl Coefficient for BoundedFraction {
    fn call(function: Function, x: &Self, limit: &u64) -> Result<Self> {
        let Some(exact) = x.clone().reduced() else { return Ok(x.clone()) };
        let value = function.exactly(&exact).ok_or_else(|| irrational(&format!("{}(…)", function.name())))?;
        Ok(BoundedFraction::ratio(&value, limit))
    }
}

/// Without common factors divided out on the way, and no further than the limit on values.
impl Coefficient for BigRational {
    fn value(expression: &Expression, parameters: &[Self], (): &()) -> Result<Self> {
        let limit = u64::from(LIMIT_VALUE);
        let parameters: Vec<BoundedFraction> =
            parameters.iter().map(|x| BoundedFraction::ratio(x, &limit)).collect();
        let value = evaluate(&expression.root, &parameters, &limit)?;
        value.reduced().ok_or_else(|| {
            let message = "has a value, or a step on the way to it, of more than";
            Error::input(format!("{message} {LIMIT_VALUE} bits in numerator or denominator"))
        })
    }
}

/// As its text without spaces.
impl Serialize for Expression {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let text: String = self.text.split_whitespace().collect();
        serializer.serialize_str(&text)
    }
}

impl fmt::Display for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.text)
    }
}

/// The value of a formula whose variables have these values.
fn evaluate<T: Coefficient>(formula: &Formula, parameters: &[T], context: &T::Context) -> Result<T> {
    Ok(match formula {
        Formula::Pi => T::pi(context)?,
        Formula::Call(function, inner) => {
            T::call(*function, &evaluate(inner, parameters, context)?, context)?
        }
        Formula::Number(value) => T::ratio(value, context),
        Formula::Variable(index) => parameters[*index].clone(),
        Formula::Negated(inner) => -evaluate(inner, parameters, context)?,
        Formula::Binary(operation, parts) => {
            let left = evaluate(&parts[0], parameters, context)?;
            let right = evaluate(&parts[1], parameters, context)?;
            match operation {
                Operation::Sum => left + &right,
                Operation::Difference => left - &right,
                Operation::Product => left * &right,
                Operation::Quotient => divide(left, &right)?,
            }
        }
        Formula::Power(base, exponent) => {
            let base = evaluate(base, parameters, context)?;
            let one = T::integer(1, context);
            let power = (0..exponent.unsigned_abs()).fold(one.clone(), |power, _| power * &base);
            if *exponent < 0 { divide(one, &power)? } else { power }
        }
        Formula::Choice(choice) => return Err(only_in_forces(&choice.text)),
        Formula::Raised(_, exponent) => return Err(only_in_forces(&format!("x^({exponent})"))),
    })
}

fn only_in_forces(what: &str) -> Error {
    Error::input(format!("{what} stands only in a force that depends on q, u or t"))
}

fn divide<T: Real>(left: T, right: &T) -> Result<T> {
    if right.sign() == Some(Sign::Zero) {
        return Err(Error::input("divides by zero"));
    }
    Ok(left / right)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::parse_rational;

    fn value(text: &str, parameters: &[&str]) -> Result<BigRational> {
        let names = ["a".to_string(), "b".to_string()];
        let values: Vec<_> = parameters.iter().map(|text| parse_rational(text).unwrap()).collect();
        Expression::parse(text, &names)?.evaluate(&values, &())
    }

    /// These had no end, or took minutes.
    #[test]
    fn values_that_would_grow_are_refused_at_once() {
        let long = ["3^2500/7^1400+2^-9", "5^1700/11^1100"];
        for text in ["a^128*b^-128", "(a/b)^128", "a*a*a*a*a*a*b", "1/a+1/b+1/(a+1)+1/(b+1)+1/(a+b)"] {
            let error = value(text, &long).unwrap_err().to_string();
            assert!(error.contains("more than 16384 bits"), "{text}: {error}");
        }
        for literal in ["1e-1300", "1e1300", "0.5e2000"] {
            let error = value(literal, &["0", "0"]).unwrap_err().to_string();
            assert!(error.contains("at most 4096 bits"), "{error}");
        }
    }

    /// Without common factors divided out on the way the values are the same.
    #[test]
    fn exact_values_are_in_lowest_terms() {
        for (text, expected) in [
            ("(a+b)^2-a^2-2*a*b-b^2", "0"),
            ("a/b*b/a", "1"),
            ("a^-3", "8"),
            ("(a-b)/(a+b)^3", "36/125"),
            ("-(1/6)-1/3", "-1/2"),
        ] {
            assert_eq!(value(text, &["1/2", "1/3"]).unwrap(), parse_rational(expected).unwrap(), "{text}");
        }
        assert!(value("1/(a-b)", &["1/2", "1/2"]).unwrap_err().to_string().contains("divides by zero"));
        let sum = vec!["a"; 250].join("+");
        assert_eq!(value(&sum, &["1/3^2000", "0"]).unwrap(), parse_rational("250/3^2000").unwrap());
    }
}
