//! Fractions that stop growing at a limit: what text is read into.

use std::ops::{Add, Div, Mul, Neg, Sub};

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::{Real, Sign};

/// An exact fraction, not in lowest terms, or one that has become too large.
///
/// Numerator and denominator have at most as many bits as the context says. What would need more is too large
/// from then on, and costs nothing more: text of others is evaluated in bounded time and memory. Sums are
/// brought to a common denominator: the larger one where it is a multiple of the other, else the product.
/// Only [`reduced`](BoundedFraction::reduced) looks for common factors, so that no operation on b bits costs
/// more than a product or quotient of b bits.
///
/// ```
/// use grazing_number::{BoundedFraction, Real, parse_rational};
/// let x = BoundedFraction::ratio(&parse_rational("2/3")?, &100);
/// assert_eq!(x.power(5).reduced(), Some(parse_rational("32/243")?));
/// assert!(x.power(1_000_000_000).is_too_large());
/// assert_eq!(x.reciprocal().reduced(), Some(parse_rational("3/2")?));
/// # Ok::<(), grazing_number::ParseError>(())
/// ```
#[derive(Debug, Clone)]
pub struct BoundedFraction {
    /// Numerator and denominator, which is positive; `None` if too large.
    value: Option<(BigInt, BigInt)>,
    /// The most bits.
    limit: u64,
}

impl BoundedFraction {
    pub(crate) fn new(numerator: BigInt, denominator: BigInt, limit: u64) -> Self {
        debug_assert!(denominator.is_positive());
        let fits = numerator.bits().max(denominator.bits()) <= limit;
        BoundedFraction { value: fits.then_some((numerator, denominator)), limit }
    }

    /// The same number in lowest terms; `None` if it is too large. Cost: O(b²) bit operations for b bits. An
    /// example of this and what follows is at the [type](BoundedFraction).
    pub fn reduced(self) -> Option<BigRational> {
        self.value.map(|(numerator, denominator)| BigRational::new(numerator, denominator))
    }

    /// Whether it needed more bits than the limit, here or at some step before.
    pub fn is_too_large(&self) -> bool {
        self.value.is_none()
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.value.as_ref().is_some_and(|(numerator, _)| numerator.is_zero())
    }

    /// The k-th power. Refused before it is computed if it will be too large, which bounds k unless this is 0
    /// or ±1.
    pub fn power(&self, k: u64) -> Self {
        let limit = self.limit;
        let Some((numerator, denominator)) = &self.value else { return self.clone() };
        // |x| ≥ 2^(b−1), so that x^k has more than (b − 1)k bits.
        let fits = |x: &BigInt| x.bits().saturating_sub(1).checked_mul(k).is_some_and(|bits| bits < limit);
        if !fits(numerator) || !fits(denominator) {
            return BoundedFraction { value: None, limit };
        }
        let raised = |x: &BigInt| match x.bits() {
            0 | 1 if k > 2 => num_traits::pow(x.clone(), 2 - (k % 2) as usize),
            _ => num_traits::pow(x.clone(), k as usize),
        };
        BoundedFraction::new(raised(numerator), raised(denominator), limit)
    }

    /// 1/x; too large for 0, which the caller excludes.
    pub fn reciprocal(self) -> Self {
        let value =
            self.value.filter(|(numerator, _)| !numerator.is_zero()).map(|(numerator, denominator)| {
                if numerator.is_negative() { (-denominator, -numerator) } else { (denominator, numerator) }
            });
        BoundedFraction { value, limit: self.limit }
    }
}

impl Neg for BoundedFraction {
    type Output = Self;

    fn neg(self) -> Self {
        BoundedFraction { value: self.value.map(|(n, d)| (-n, d)), ..self }
    }
}

impl Add<&BoundedFraction> for BoundedFraction {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        let limit = self.limit;
        let (Some((a, b)), Some((c, d))) = (self.value, &other.value) else {
            return BoundedFraction { value: None, limit };
        };
        if b == *d {
            return BoundedFraction::new(a + c, b, limit);
        }
        let (times, rest) = b.div_rem(d);
        if rest.is_zero() {
            return BoundedFraction::new(a + c * times, b, limit);
        }
        let (times, rest) = d.div_rem(&b);
        if rest.is_zero() {
            return BoundedFraction::new(a * times + c, d.clone(), limit);
        }
        // The product of the denominators has at least one bit less than both together.
        if b.bits() + d.bits() > limit + 1 {
            return BoundedFraction { value: None, limit };
        }
        BoundedFraction::new(a * d + c * &b, b * d, limit)
    }
}

impl Sub<&BoundedFraction> for BoundedFraction {
    type Output = Self;

    fn sub(self, other: &Self) -> Self {
        -(-self + other)
    }
}

impl Mul<&BoundedFraction> for BoundedFraction {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        let limit = self.limit;
        let (Some((a, b)), Some((c, d))) = (self.value, &other.value) else {
            return BoundedFraction { value: None, limit };
        };
        if a.is_zero() || c.is_zero() {
            return BoundedFraction::new(BigInt::ZERO, BigInt::one(), limit);
        }
        if (a.bits() + c.bits()).max(b.bits() + d.bits()) > limit + 1 {
            return BoundedFraction { value: None, limit };
        }
        BoundedFraction::new(a * c, b * d, limit)
    }
}

impl Div<&BoundedFraction> for BoundedFraction {
    type Output = Self;

    #[expect(
        clippy::suspicious_arithmetic_impl,
        reason = "the product with the reciprocal, whose limit is kept"
    )]
    fn div(self, other: &Self) -> Self {
        self * &other.clone().reciprocal()
    }
}

impl Real for BoundedFraction {
    /// The most bits of numerator and denominator.
    type Context = u64;

    fn ratio(value: &BigRational, limit: &u64) -> Self {
        BoundedFraction::new(value.numer().clone(), value.denom().clone(), *limit)
    }

    fn integer(value: i32, limit: &u64) -> Self {
        BoundedFraction::new(value.into(), BigInt::one(), *limit)
    }

    fn sign(&self) -> Option<Sign> {
        self.value.as_ref().map(|(numerator, _)| numerator.into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fraction(p: i64, q: i64) -> BoundedFraction {
        BoundedFraction::new(p.into(), q.into(), 64)
    }

    /// Against arithmetic in lowest terms.
    #[test]
    fn operations_are_exact() {
        let all: Vec<(i64, i64)> = (-6..=6).flat_map(|p| (1..=6).map(move |q| (p, q))).collect();
        let exact = |(p, q): (i64, i64)| BigRational::new(p.into(), q.into());
        for &a in &all {
            for &b in &all {
                let (x, y) = (fraction(a.0, a.1), fraction(b.0, b.1));
                assert_eq!((x.clone() + &y).reduced(), Some(exact(a) + exact(b)));
                assert_eq!((x.clone() - &y).reduced(), Some(exact(a) - exact(b)));
                assert_eq!((x.clone() * &y).reduced(), Some(exact(a) * exact(b)));
                assert_eq!((x / &y).reduced(), (b.0 != 0).then(|| exact(a) / exact(b)));
            }
            for k in 0..7 {
                assert_eq!(
                    fraction(a.0, a.1).power(k).reduced(),
                    Some(num_traits::pow(exact(a), k as usize))
                );
            }
        }
    }

    #[test]
    fn growth_ends_at_the_limit() {
        let two = fraction(2, 1);
        assert!(!two.power(63).is_too_large() && two.power(64).is_too_large());
        assert!(two.clone().reciprocal().power(u64::MAX).is_too_large());
        assert_eq!(fraction(-1, 1).power(u64::MAX).reduced(), Some(BigRational::from_integer((-1).into())));
        assert_eq!(fraction(-1, 3).power(3).reduced(), Some(BigRational::new((-1).into(), 27.into())));
        assert!(fraction(0, 1).power(u64::MAX).is_zero());
        let half = two.power(63).reciprocal();
        // A common denominator where one is a multiple of the other.
        assert!(!(half.clone() + &two.power(40).reciprocal()).is_too_large());
        assert!((half.clone() + &fraction(1, 3)).is_too_large());
        assert!((half.clone() * &half).is_too_large() && ((half.clone() * &half) + &two).is_too_large());
        assert!(fraction(0, 1).reciprocal().is_too_large());
    }
}
