//! Coefficients as functions of one parameter: quotients of polynomials over the integers.

use std::ops::{Add, Div, Mul, Neg, Sub};

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero, pow};

use crate::number::{Real, Sign};

/// The highest power that is kept.
const DEGREE: usize = 64;
/// The most bits of a coefficient.
const BITS: u64 = 1 << 14;

/// (P₀ + P₁ p + …)/(Q₀ + Q₁ p + …), exactly; or too large to be kept, as is then all that is made of it.
///
/// Common factors of the two polynomials are kept, those of all their coefficients are not.
#[derive(Debug, Clone, PartialEq)]
pub struct Quotient {
    /// Numerator and denominator by rising powers, the last of each not 0 (but for a numerator 0).
    value: Option<[Vec<BigInt>; 2]>,
}

impl Quotient {
    /// The parameter itself.
    pub fn parameter() -> Quotient {
        Quotient::new([vec![BigInt::zero(), BigInt::one()], vec![BigInt::one()]])
    }

    /// The coefficients by rising powers, of numerator and denominator, whose last is positive; no integer
    /// above 1 divides them all, and none of the two ends in a 0 but the numerator 0 = 0/1. `None` if it was
    /// too large (powers above 64, integers of more than 16384 bits).
    pub fn polynomials(&self) -> Option<&[Vec<BigInt>; 2]> {
        self.value.as_ref()
    }

    /// The same function of the parameter in this unit: u ↦ x(unit·u).
    pub(super) fn in_unit(self, unit: &BigRational) -> Quotient {
        let Some(all) = self.value else { return self };
        let degree = all.iter().map(Vec::len).max().unwrap_or(1) - 1;
        let power = |x: &BigInt, j: usize| pow(x.clone(), j);
        let of = |(j, x): (usize, BigInt)| x * power(unit.numer(), j) * power(unit.denom(), degree - j);
        Quotient::new(all.map(|list| list.into_iter().enumerate().map(of).collect()))
    }

    fn new([mut numerator, mut denominator]: [Vec<BigInt>; 2]) -> Quotient {
        for list in [&mut numerator, &mut denominator] {
            while list.len() > 1 && list.last().is_some_and(Zero::is_zero) {
                list.pop();
            }
        }
        let divisor = numerator.iter().chain(&denominator).fold(BigInt::zero(), |all, x| all.gcd(x));
        let negative = denominator.last().is_some_and(Signed::is_negative);
        let divisor = if negative { -divisor } else { divisor };
        if numerator.iter().all(Zero::is_zero) {
            return Quotient { value: Some([vec![BigInt::zero()], vec![BigInt::one()]]) };
        }
        for x in numerator.iter_mut().chain(&mut denominator) {
            *x = &*x / &divisor;
        }
        let all = || numerator.iter().chain(&denominator);
        let fits = numerator.len().max(denominator.len()) <= DEGREE + 1 && all().all(|x| x.bits() <= BITS);
        Quotient { value: fits.then_some([numerator, denominator]) }
    }

    fn combined(
        self,
        other: &Quotient,
        combine: impl Fn([Vec<BigInt>; 2], &[Vec<BigInt>; 2]) -> [Vec<BigInt>; 2],
    ) -> Quotient {
        match (self.value, &other.value) {
            (Some(a), Some(b)) => Quotient::new(combine(a, b)),
            _ => Quotient { value: None },
        }
    }
}

fn sum(a: &[BigInt], b: &[BigInt]) -> Vec<BigInt> {
    let part = |list: &[BigInt], i: usize| list.get(i).cloned().unwrap_or_default();
    (0..a.len().max(b.len())).map(|i| part(a, i) + part(b, i)).collect()
}

fn product(a: &[BigInt], b: &[BigInt]) -> Vec<BigInt> {
    let mut all = vec![BigInt::zero(); a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            all[i + j] += x * y;
        }
    }
    all
}

impl Neg for Quotient {
    type Output = Quotient;

    fn neg(self) -> Quotient {
        Quotient {
            value: self.value.map(|[above, below]| [above.into_iter().map(Neg::neg).collect(), below]),
        }
    }
}

impl Add<&Quotient> for Quotient {
    type Output = Quotient;

    fn add(self, other: &Quotient) -> Quotient {
        self.combined(other, |[a, b], [c, d]| {
            if b == *d {
                return [sum(&a, c), b];
            }
            [sum(&product(&a, d), &product(c, &b)), product(&b, d)]
        })
    }
}

impl Sub<&Quotient> for Quotient {
    type Output = Quotient;

    fn sub(self, other: &Quotient) -> Quotient {
        self + &-other.clone()
    }
}

impl Mul<&Quotient> for Quotient {
    type Output = Quotient;

    fn mul(self, other: &Quotient) -> Quotient {
        self.combined(other, |[a, b], [c, d]| [product(&a, c), product(&b, d)])
    }
}

impl Div<&Quotient> for Quotient {
    type Output = Quotient;

    /// Too large to be kept, if the divisor is 0.
    fn div(self, other: &Quotient) -> Quotient {
        if other.sign() == Some(Sign::Zero) {
            return Quotient { value: None };
        }
        self.combined(other, |[a, b], [c, d]| [product(&a, d), product(&b, c)])
    }
}

impl Real for Quotient {
    type Context = ();

    fn ratio(value: &BigRational, (): &()) -> Quotient {
        Quotient::new([vec![value.numer().clone()], vec![value.denom().clone()]])
    }

    fn integer(value: i32, (): &()) -> Quotient {
        Quotient::new([vec![value.into()], vec![BigInt::one()]])
    }

    /// The sign if it is that of a number, whatever the parameter is.
    fn sign(&self) -> Option<Sign> {
        let [above, below] = self.value.as_ref()?;
        let constant = above.len() == 1 && (below.len() == 1 || above[0].is_zero());
        constant.then(|| BigRational::from_integer(above[0].clone()).sign()).flatten()
    }
}
