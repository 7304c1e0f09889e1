//! What a formula is a mass, a length or a force of, as far as its text says it.
//!
//! Only what has units is compared. A number written out is a plain factor; 0 is of any dimension. So is a
//! parameter without a unit, and q, u, t, d and v in a force: what they stand in is not checked.

use num_traits::Zero;

use crate::{
    error::{Error, Result},
    formula::{Formula, Function, Operation},
    quantity::Dimension,
};

/// What is known of the dimension of a formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Measured {
    /// Nothing: it may be of any dimension.
    Any,
    /// 0, or a number without a unit.
    Plain { zero: bool },
    /// It has units, and this dimension.
    Known(Dimension),
}

use Measured::{Any, Known, Plain};

const NUMBER: Measured = Plain { zero: false };

impl Measured {
    /// What is known of a formula whose variables are this.
    ///
    /// # Errors
    /// For a sum of two that do not go together, and a function of what is no plain number; in the words of a
    /// reader.
    pub(super) fn of(formula: &Formula, variables: &dyn Fn(usize) -> Measured) -> Result<Measured> {
        let of = |inner: &Formula| Measured::of(inner, variables);
        Ok(match formula {
            Formula::Number(value) => Plain { zero: value.is_zero() },
            Formula::Pi => NUMBER,
            Formula::Variable(place) => variables(*place),
            Formula::Negated(inner) => of(inner)?,
            Formula::Binary(operation, parts) => {
                let (left, right) = (of(&parts[0])?, of(&parts[1])?);
                match operation {
                    Operation::Sum => left.joined(right, "adds")?,
                    Operation::Difference => left.joined(right, "subtracts")?,
                    Operation::Product => left.times(right),
                    Operation::Quotient => left.times(right.power(-1)),
                }
            }
            Formula::Power(inner, n) => of(inner)?.power(*n),
            Formula::Call(function, inner) => of(inner)?.under(*function)?,
            Formula::Raised(inner, _) => match of(inner)? {
                Known(dimension) if !dimension.is_like(Dimension::ONE) => Any,
                other => other,
            },
            Formula::Choice(choice) => {
                of(&choice.switch)?;
                of(&choice.above)?.joined(of(&choice.below)?, "chooses between")?
            }
        })
    }

    fn times(self, other: Measured) -> Measured {
        match (self, other) {
            (Plain { zero: true }, _) | (_, Plain { zero: true }) => Plain { zero: true },
            (Any, _) | (_, Any) => Any,
            (Known(one), Known(two)) => Known(one.times(two)),
            (Known(one), Plain { .. }) | (Plain { .. }, Known(one)) => Known(one),
            (Plain { .. }, Plain { .. }) => NUMBER,
        }
    }

    fn power(self, n: i32) -> Measured {
        if let Known(dimension) = self { Known(dimension.power(n)) } else { self }
    }

    fn joined(self, other: Measured, word: &str) -> Result<Measured> {
        let turns = |one: Dimension, two: Dimension| {
            one.angle != two.angle && !one.is_like(Dimension::ONE) && one.is_like(two)
        };
        match (self, other) {
            (Known(one), Known(two)) if turns(one, two) => {
                let why = "an angular frequency is 2*pi times a frequency";
                Err(Error::input(format!("{word} {one} and {two}: {why}")))
            }
            (Known(one), Known(two)) if one.is_like(two) => Ok(self),
            (Known(one), Known(two)) => Err(Error::input(format!("{word} {one} and {two}"))),
            (Known(one), Plain { zero: false }) | (Plain { zero: false }, Known(one))
                if !one.is_like(Dimension::ONE) =>
            {
                Err(Error::input(format!("{word} {one} and a number without a unit: give it one")))
            }
            (known @ Known(_), _) | (_, known @ Known(_)) => Ok(known),
            (Any, _) | (_, Any) => Ok(Any),
            (Plain { zero: one }, Plain { zero: two }) => Ok(Plain { zero: one && two }),
        }
    }

    fn under(self, function: Function) -> Result<Measured> {
        let Known(dimension) = self else { return Ok(self) };
        let even = [dimension.length, dimension.time, dimension.mass].iter().all(|n| n % 2 == 0);
        match function {
            Function::Sqrt if even => Ok(Known(Dimension {
                length: dimension.length / 2,
                time: dimension.time / 2,
                mass: dimension.mass / 2,
                angle: dimension.angle / 2,
            })),
            Function::Sqrt => Ok(Any),
            _ if dimension.is_like(Dimension::ONE) => Ok(Known(Dimension::ONE)),
            _ => {
                let name = function.name();
                Err(Error::input(format!(
                    "takes {name} of {dimension}: that is of a plain number or an angle"
                )))
            }
        }
    }
}

/// The power of π that is a factor of a formula, if it has one that can be told.
pub(super) fn power_of_pi(formula: &Formula) -> Option<i32> {
    match formula {
        Formula::Pi => Some(1),
        Formula::Number(_) | Formula::Variable(_) => Some(0),
        Formula::Negated(inner) => power_of_pi(inner),
        Formula::Power(inner, n) => power_of_pi(inner)?.checked_mul(*n),
        Formula::Binary(Operation::Product, parts) => {
            power_of_pi(&parts[0])?.checked_add(power_of_pi(&parts[1])?)
        }
        Formula::Binary(Operation::Quotient, parts) => {
            power_of_pi(&parts[0])?.checked_sub(power_of_pi(&parts[1])?)
        }
        Formula::Binary(_, parts) => {
            let [one, two] = parts.each_ref().map(power_of_pi);
            (one == two).then_some(one).flatten()
        }
        Formula::Call(_, inner) | Formula::Raised(inner, _) => (power_of_pi(inner) == Some(0)).then_some(0),
        Formula::Choice(_) => None,
    }
}
