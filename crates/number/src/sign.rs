//! Certain signs. An enclosure that cannot tell answers `None`; a `Sign` is never a guess.

use std::{
    fmt,
    ops::{Mul, Neg},
};

use num_bigint::BigInt;
use num_rational::BigRational;

/// The sign of a real number that has been decided.
///
/// There is no order on signs: compare with `==` or match.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Sign {
    /// Certainly below zero.
    Negative,
    /// Certainly zero.
    Zero,
    /// Certainly above zero.
    Positive,
}

impl Sign {
    /// The sign of an exact fraction.
    ///
    /// ```
    /// use grazing_number::{Sign, parse_rational};
    /// let sign = Sign::of(&parse_rational("1/3 - 0.3334")?);
    /// assert_eq!((sign, sign.negated_if(true)), (Sign::Negative, Sign::Positive));
    /// # Ok::<(), grazing_number::ParseError>(())
    /// ```
    #[inline]
    pub fn of(value: &BigRational) -> Sign {
        value.numer().into()
    }

    /// This sign, turned round if `odd`: the sign of (−1)^odd · x. An example is at [`of`](Sign::of).
    #[must_use]
    #[inline]
    pub fn negated_if(self, odd: bool) -> Sign {
        if odd { -self } else { self }
    }
}

/// `-`, `0` or `+`.
impl fmt::Display for Sign {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Sign::Negative => "-",
            Sign::Zero => "0",
            Sign::Positive => "+",
        })
    }
}

/// As text: `-`, `0` or `+`.
#[cfg(feature = "serde")]
impl serde::Serialize for Sign {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl From<&BigInt> for Sign {
    #[inline]
    fn from(value: &BigInt) -> Sign {
        match value.sign() {
            num_bigint::Sign::Minus => Sign::Negative,
            num_bigint::Sign::NoSign => Sign::Zero,
            num_bigint::Sign::Plus => Sign::Positive,
        }
    }
}

impl Neg for Sign {
    type Output = Sign;

    #[inline]
    fn neg(self) -> Sign {
        match self {
            Sign::Negative => Sign::Positive,
            Sign::Zero => Sign::Zero,
            Sign::Positive => Sign::Negative,
        }
    }
}

impl Mul for Sign {
    type Output = Sign;

    /// The sign of a product.
    #[inline]
    fn mul(self, other: Sign) -> Sign {
        match self {
            Sign::Positive => other,
            Sign::Negative => -other,
            Sign::Zero => Sign::Zero,
        }
    }
}
