//! Coefficients as functions of one parameter: quotients of polynomials over the integers, or over intervals
//! of them where a number in it is irrational.

use std::ops::{Add, Div, Mul, Neg, Sub};

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero, pow};

use crate::{
    between::{Between, exactly, is_exact, is_zero, negated, product, sum},
    number::{Real, Sign},
};

/// The highest power that is kept.
const DEGREE: usize = 64;
/// The most bits of a coefficient.
const BITS: u64 = 1 << 14;

/// The bits after the point of a number that is divided by another that is not exact.
const SCALE: u64 = 512;

/// (P₀ + P₁ p + …)/(Q₀ + Q₁ p + …), each exactly or between two numbers; or too large to be kept, as is then
/// all that is made of it.
///
/// Common factors of the two polynomials are kept, those of all their coefficients are not. Equality is that
/// of what is known.
#[derive(Debug, Clone, PartialEq)]
pub struct Quotient {
    /// Numerator and denominator by rising powers, the last of each not 0 (but for a numerator 0).
    value: Option<[Vec<Between>; 2]>,
}

impl Quotient {
    /// The parameter itself.
    pub fn parameter() -> Quotient {
        let [zero, one] = [BigInt::zero(), BigInt::one()].map(exactly);
        Quotient::new([vec![zero, one.clone()], vec![one]])
    }

    /// A number between these two.
    pub fn between([lo, hi]: [&BigRational; 2]) -> Quotient {
        let below = lo.denom() * hi.denom();
        let above = [lo.numer() * hi.denom(), hi.numer() * lo.denom()];
        Quotient::new([vec![above], vec![exactly(below)]])
    }

    /// Two numbers between which it is, if it does not depend on the parameter.
    pub fn constant(&self) -> Option<[BigRational; 2]> {
        let ([above], [below]) = self.value.as_ref().map(|[above, below]| (&above[..], &below[..]))? else {
            return None;
        };
        let ends = || above.iter().flat_map(|x| below.iter().map(|y| BigRational::new(x.clone(), y.clone())));
        ends().min().zip(ends().max()).map(|(lo, hi)| [lo, hi])
    }

    /// The coefficients by rising powers, of numerator and denominator, whose last is positive, if all are
    /// exact; no integer above 1 divides them all, and none of the two ends in a 0 but the numerator 0 = 0/1.
    /// `None` if not, or if it was too large (powers above 64, integers of more than 16384 bits).
    pub fn polynomials(&self) -> Option<[Vec<BigInt>; 2]> {
        let all = self.value.as_ref()?;
        let exact = |list: &Vec<Between>| -> Option<Vec<BigInt>> {
            list.iter().map(|x| is_exact(x).then(|| x[0].clone())).collect()
        };
        let [above, below] = all.each_ref().map(exact);
        Some([above?, below?])
    }

    /// Two numbers between which each coefficient is, as [`polynomials`](Self::polynomials) has them.
    pub(super) fn enclosures(&self) -> Option<&[Vec<Between>; 2]> {
        self.value.as_ref()
    }

    /// The same function of the parameter in this unit, which is positive: u ↦ x(unit·u).
    pub(super) fn in_unit(self, unit: &BigRational) -> Quotient {
        let Some(all) = self.value else { return self };
        let degree = all.iter().map(Vec::len).max().unwrap_or(1) - 1;
        let power = |x: &BigInt, j: usize| pow(x.clone(), j);
        let of = |(j, x): (usize, Between)| {
            x.map(|x| x * power(unit.numer(), j) * power(unit.denom(), degree - j))
        };
        Quotient::new(all.map(|list| list.into_iter().enumerate().map(of).collect()))
    }

    fn new([mut numerator, mut denominator]: [Vec<Between>; 2]) -> Quotient {
        for list in [&mut numerator, &mut denominator] {
            while list.len() > 1 && list.last().is_some_and(is_zero) {
                list.pop();
            }
        }
        if let [below] = &denominator[..]
            && !is_exact(below)
            && below[0].is_positive()
        {
            // A number that is not exact divides what is above.
            let over = |x: &Between| {
                let ends = |round: fn(&BigInt, &BigInt) -> BigInt| {
                    x.iter().flat_map(move |x| below.iter().map(move |below| round(&(x << SCALE), below)))
                };
                let (lo, hi) = (ends(|x, y| x.div_floor(y)).min(), ends(|x, y| x.div_ceil(y)).max());
                [lo.expect("four"), hi.expect("four")]
            };
            let numerator = numerator.iter().map(over).collect();
            return Quotient::new([numerator, vec![exactly(BigInt::one() << SCALE)]]);
        }
        let all = || numerator.iter().chain(&denominator).flatten();
        let divisor = all().fold(BigInt::zero(), |all, x| all.gcd(x));
        if numerator.iter().all(is_zero) {
            return Quotient { value: Some([vec![exactly(BigInt::zero())], vec![exactly(BigInt::one())]]) };
        }
        // The last of the denominator is made positive; of one that may be 0 nothing is known.
        let Some([lo, hi]) = denominator.last() else { return Quotient { value: None } };
        let negative = match (lo.is_positive(), hi.is_negative()) {
            (true, _) => false,
            (_, true) => true,
            _ => return Quotient { value: None },
        };
        for x in numerator.iter_mut().chain(&mut denominator) {
            *x = x.each_ref().map(|x| x / &divisor);
            if negative {
                *x = negated(x);
            }
        }
        let all = || numerator.iter().chain(&denominator).flatten();
        let fits = numerator.len().max(denominator.len()) <= DEGREE + 1 && all().all(|x| x.bits() <= BITS);
        Quotient { value: fits.then_some([numerator, denominator]) }
    }

    fn combined(
        self,
        other: &Quotient,
        combine: impl Fn([Vec<Between>; 2], &[Vec<Between>; 2]) -> [Vec<Between>; 2],
    ) -> Quotient {
        match (self.value, &other.value) {
            (Some(a), Some(b)) => Quotient::new(combine(a, b)),
            _ => Quotient { value: None },
        }
    }
}

impl Neg for Quotient {
    type Output = Quotient;

    fn neg(self) -> Quotient {
        Quotient { value: self.value.map(|[above, below]| [above.iter().map(negated).collect(), below]) }
    }
}

impl Add<&Quotient> for Quotient {
    type Output = Quotient;

    fn add(self, other: &Quotient) -> Quotient {
        self.combined(other, |[a, b], [c, d]| {
            // Two numbers of which the same is known may differ.
            if b == *d && b.iter().all(is_exact) {
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
        Quotient::new([value.numer(), value.denom()].map(|x| vec![exactly(x.clone())]))
    }

    fn integer(value: i32, (): &()) -> Quotient {
        Quotient::new([vec![exactly(value.into())], vec![exactly(BigInt::one())]])
    }

    /// The sign if it is that of a number, whatever the parameter is.
    fn sign(&self) -> Option<Sign> {
        let [above, below] = self.value.as_ref()?;
        let [lo, hi] = &above[0];
        let zero = lo.is_zero() && hi.is_zero();
        match () {
            () if above.len() > 1 || below.len() > 1 && !zero => None,
            () if zero => Some(Sign::Zero),
            () if lo.is_positive() => Some(Sign::Positive),
            () if hi.is_negative() => Some(Sign::Negative),
            () => None,
        }
    }
}
