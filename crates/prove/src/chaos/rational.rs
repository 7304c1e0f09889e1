//! Rational functions of one variable x > 0 with exact coefficients: how a system's coefficients depend on a
//! parameter.
//!
//! A parameter in a range from `from` (not included) to `to` is (from + to x)/(1 + x), one without an upper
//! end from + x. A quotient of polynomials without negative coefficients is positive for every x > 0: that is
//! the only test of signs here, and it never errs.

use std::ops::{Add, Div, Mul, Neg, Sub};

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero, pow};

use super::fail;
use crate::{
    error::Result,
    number::{Real, Sign},
};

/// A quotient of polynomials in whole numbers without a common divisor, coefficients from the constant one
/// on: as fractions each of them would be reduced, which takes a hundred times as long.
#[derive(Debug, Clone, PartialEq)]
pub struct RationalFunction {
    over: Vec<BigInt>,
    under: Vec<BigInt>,
}

impl RationalFunction {
    fn new(mut over: Vec<BigInt>, mut under: Vec<BigInt>) -> RationalFunction {
        let mut divisor = BigInt::zero();
        for x in over.iter().chain(&under) {
            divisor = divisor.gcd(x);
            if divisor.is_one() {
                return RationalFunction { over, under };
            }
        }
        if !divisor.is_zero() {
            over.iter_mut().chain(&mut under).for_each(|x| *x /= &divisor);
        }
        RationalFunction { over, under }
    }

    /// The function that runs through the numbers above `from`, up to `to` where that is given; the number
    /// itself if both are one.
    pub fn range(from: &BigRational, to: Option<&BigRational>) -> RationalFunction {
        let whole = |x: &BigRational, scale: &BigInt| x.numer() * (scale / x.denom());
        match to {
            // As a quotient of polynomials it would grow by each operation.
            Some(to) if to == from => RationalFunction::ratio(from, &()),
            Some(to) => {
                let scale = from.denom().lcm(to.denom());
                RationalFunction::new(
                    vec![whole(from, &scale), whole(to, &scale)],
                    vec![scale.clone(), scale],
                )
            }
            None => {
                let (p, q) = (from.numer().clone(), from.denom().clone());
                RationalFunction::new(vec![p, q.clone()], vec![q])
            }
        }
    }

    /// Its value if it does not depend on x.
    pub fn constant(&self) -> Option<BigRational> {
        // over = c·under, coefficient by coefficient.
        let at = self.under.iter().position(|x| !x.is_zero())?;
        let zero = BigInt::zero();
        let get = |list: &[BigInt], i: usize| list.get(i).cloned().unwrap_or_else(|| zero.clone());
        let (p, q) = (get(&self.over, at), get(&self.under, at));
        let longest = self.over.len().max(self.under.len());
        let holds = (0..longest).all(|i| get(&self.over, i) * &q == get(&self.under, i) * &p);
        holds.then(|| BigRational::new(p, q))
    }

    /// Whether it is certainly ≥ 0 for every x > 0.
    pub(crate) fn is_nonnegative(&self) -> bool {
        sign(&self.over).zip(sign(&self.under)).is_some_and(|(over, under)| over * under >= 0 && under != 0)
    }

    /// Whether it is certainly > 0 for every x > 0.
    pub(crate) fn is_positive(&self) -> bool {
        self.is_nonnegative() && self.over.iter().any(|x| !x.is_zero())
    }

    /// Whether it certainly increases, or certainly decreases, with x > 0.
    pub(crate) fn runs_one_way(&self) -> bool {
        let slope = |list: &[BigInt]| -> Vec<BigInt> {
            list.iter().enumerate().skip(1).map(|(i, x)| x * BigInt::from(i)).collect()
        };
        let times = |a: &[BigInt], b: &[BigInt]| {
            if a.is_empty() || b.is_empty() { Vec::new() } else { product(a, b) }
        };
        let back: Vec<BigInt> = times(&self.over, &slope(&self.under)).into_iter().map(|x| -x).collect();
        let above = sum(&times(&slope(&self.over), &self.under), &back);
        let one = |list: &[BigInt]| sign(list).is_some_and(|sign| sign != 0);
        one(&above) && one(&product(&self.under, &self.under))
    }

    /// Its limits as x → 0 and x → ∞, where they are finite.
    pub(crate) fn ends(&self) -> Option<[BigRational; 2]> {
        let limit = |over: &mut dyn Iterator<Item = &BigInt>, under: &mut dyn Iterator<Item = &BigInt>| {
            loop {
                let (over, under) = (over.next(), under.next()?);
                if !under.is_zero() {
                    let quotient = |over: &BigInt| BigRational::new(over.clone(), under.clone());
                    return Some(over.map_or_else(BigRational::zero, quotient));
                }
                if over.is_some_and(|over| !over.is_zero()) {
                    return None;
                }
            }
        };
        // As x → ∞ the highest coefficients count: both lists are made as long as the longer.
        let longest = self.over.len().max(self.under.len());
        let padded = |list: &[BigInt]| {
            let mut list = list.to_vec();
            list.resize(longest, BigInt::zero());
            list.reverse();
            list
        };
        let (over, under) = (padded(&self.over), padded(&self.under));
        Some([
            limit(&mut self.over.iter(), &mut self.under.iter())?,
            limit(&mut over.iter(), &mut under.iter())?,
        ])
    }

    /// The least and greatest of its limits, if it certainly lies between them.
    pub(crate) fn bounds(&self) -> Option<[BigRational; 2]> {
        if let Some(value) = self.constant() {
            return Some([value.clone(), value]);
        }
        let [zero, infinity] = self.ends()?;
        let (lo, hi) = if zero <= infinity { (zero, infinity) } else { (infinity, zero) };
        let number = |x: &BigRational| RationalFunction::ratio(x, &());
        let between = (self.clone() - &number(&lo)).is_nonnegative() && (number(&hi) - self).is_nonnegative();
        between.then_some([lo, hi])
    }

    /// The same of what is so called, where it must be so.
    pub(crate) fn bounded(&self, what: &str) -> Result<[BigRational; 2]> {
        let unbounded = || fail(&format!("{what} is not bounded by its values at the range's ends"));
        self.bounds().map_or_else(unbounded, Ok)
    }

    /// Whether it is certainly 0 for every x > 0.
    pub(super) fn is_zero(&self) -> bool {
        self.sign() == Some(Sign::Zero)
    }
}

/// The square root if it is rational, else one of 12 places below or above it.
pub(super) fn root(x: &BigRational, up: bool) -> BigRational {
    let exact = BigRational::new(x.numer().sqrt(), x.denom().sqrt());
    if &exact * &exact == *x {
        return exact;
    }
    let scale = pow(BigInt::from(10), 12);
    let floor = (x * BigRational::from_integer(&scale * &scale)).floor().to_integer().sqrt();
    BigRational::new(if up { floor + 1 } else { floor }, scale)
}

/// 1 or −1 if no coefficient has the other sign, 0 if all are 0.
fn sign(list: &[impl Signed]) -> Option<i32> {
    let (up, down) = (list.iter().any(Signed::is_positive), list.iter().any(Signed::is_negative));
    match (up, down) {
        (true, true) => None,
        (up, down) => Some(i32::from(up) - i32::from(down)),
    }
}

/// p and q with q times the first the same as p times the second, if there are such numbers.
fn alike(a: &[BigInt], b: &[BigInt]) -> Option<[BigInt; 2]> {
    let at = a.iter().position(|x| !x.is_zero())?;
    let (p, q) = (&a[at], b.get(at)?);
    let same = a.len() == b.len() && !q.is_zero() && a.iter().zip(b).all(|(a, b)| a * q == b * p);
    same.then(|| [p.clone(), q.clone()])
}

fn sum(a: &[BigInt], b: &[BigInt]) -> Vec<BigInt> {
    let get = |list: &[BigInt], i: usize| list.get(i).cloned().unwrap_or_default();
    (0..a.len().max(b.len())).map(|i| get(a, i) + get(b, i)).collect()
}

fn product(a: &[BigInt], b: &[BigInt]) -> Vec<BigInt> {
    let mut all = vec![BigInt::zero(); a.len() + b.len() - 1];
    for (i, a) in a.iter().enumerate() {
        for (j, b) in b.iter().enumerate() {
            all[i + j] += a * b;
        }
    }
    all
}

impl Neg for RationalFunction {
    type Output = Self;

    fn neg(self) -> Self {
        RationalFunction { over: self.over.into_iter().map(|x| -x).collect(), ..self }
    }
}

impl Add<&RationalFunction> for RationalFunction {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        // With divisors that are multiples of each other by a number the powers do not grow.
        if let Some([p, q]) = alike(&self.under, &other.under) {
            let times = |list: &[BigInt], by: &BigInt| list.iter().map(|x| x * by).collect::<Vec<_>>();
            let over = sum(&times(&self.over, &q), &times(&other.over, &p));
            return RationalFunction::new(over, times(&self.under, &q));
        }
        let over = sum(&product(&self.over, &other.under), &product(&other.over, &self.under));
        RationalFunction::new(over, product(&self.under, &other.under))
    }
}

impl Sub<&RationalFunction> for RationalFunction {
    type Output = Self;

    fn sub(self, other: &Self) -> Self {
        self + &-other.clone()
    }
}

impl Mul<&RationalFunction> for RationalFunction {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        RationalFunction::new(product(&self.over, &other.over), product(&self.under, &other.under))
    }
}

impl Div<&RationalFunction> for RationalFunction {
    type Output = Self;

    fn div(self, other: &Self) -> Self {
        RationalFunction::new(product(&self.over, &other.under), product(&self.under, &other.over))
    }
}

impl Real for RationalFunction {
    type Context = ();

    fn ratio(value: &BigRational, (): &()) -> Self {
        RationalFunction { over: vec![value.numer().clone()], under: vec![value.denom().clone()] }
    }

    fn integer(value: i32, (): &()) -> Self {
        RationalFunction::ratio(&BigRational::from_integer(value.into()), &())
    }

    fn sign(&self) -> Option<Sign> {
        if self.over.iter().all(Zero::is_zero) {
            return Some(Sign::Zero);
        }
        match (self.is_positive(), (-self.clone()).is_positive()) {
            (true, _) => Some(Sign::Positive),
            (_, true) => Some(Sign::Negative),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(p: i64, q: i64) -> BigRational {
        BigRational::new(p.into(), q.into())
    }

    #[test]
    fn the_depth_of_the_papers_wall_is_bounded_exactly() {
        let one = RationalFunction::integer(1, &());
        for (to, most) in [(Some(number(3, 1000)), number(3, 1003)), (None, number(1, 1))] {
            let mu = RationalFunction::range(&number(0, 1), to.as_ref());
            let depth = one.clone() - &(one.clone() / &(one.clone() + &mu));
            assert_eq!(depth.bounds(), Some([number(0, 1), most]));
            assert_eq!(depth.sign(), Some(Sign::Positive));
            assert_eq!(depth.constant(), None);
            assert_eq!((mu.clone() - &mu).constant(), Some(number(0, 1)));
        }
    }

    #[test]
    fn what_runs_one_way_is_told() {
        let x = RationalFunction::range(&number(1, 2), Some(&number(3, 1)));
        let square = x.clone() * &x;
        let inverse = RationalFunction::integer(1, &()) / &square;
        for function in [&x, &square, &inverse] {
            assert!(function.runs_one_way());
        }
        let turned = x.clone() + &inverse;
        let there_and_back = RationalFunction::range(&number(-1, 1), Some(&number(1, 1)));
        let constant = RationalFunction::integer(1, &());
        for function in [&turned, &(there_and_back.clone() * &there_and_back), &constant] {
            assert!(!function.runs_one_way());
        }
    }

    #[test]
    fn what_is_not_certain_is_not_said() {
        let x = RationalFunction::range(&number(-1, 1), Some(&number(1, 1)));
        assert_eq!((x.sign(), x.clone().sign()), (None, None));
        // x² goes from 1 to 0 to 1: its limits do not bound it.
        assert_eq!((x.clone() * &x).bounds(), None);
        assert_eq!(x.bounds(), Some([number(-1, 1), number(1, 1)]));
        assert_eq!(
            (RationalFunction::integer(1, &()) / &RationalFunction::range(&number(0, 1), None)).bounds(),
            None
        );
    }
}
