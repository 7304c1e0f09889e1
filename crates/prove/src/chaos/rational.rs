//! Rational functions of one variable x > 0: how a system's coefficients depend on a parameter. Their
//! coefficients are exact, or between two numbers where what they are made of is not rational, such as π.
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
    between::{Between, exactly, is_exact, is_zero, negated, product, sum, times},
    error::Result,
    number::{Real, Sign},
};

/// A quotient of polynomials in whole numbers, coefficients from the constant one on: as fractions each of
/// them would be reduced, which takes a hundred times as long. Equality is that of what is written down.
#[derive(Debug, Clone, PartialEq)]
pub struct RationalFunction {
    over: Vec<Between>,
    under: Vec<Between>,
}

/// Coefficients of so many bits keep their common divisor but for a power of 2: to find it costs a hundred
/// products.
const SHORT: u64 = 16384;

/// The most bits that coefficients have which are not exact.
const BITS: u64 = 384;

/// What is not exact is bounded with such a part more: 2^-SLACK.
const SLACK: usize = 100;

impl RationalFunction {
    fn new(mut over: Vec<Between>, mut under: Vec<Between>) -> RationalFunction {
        let all = || over.iter().chain(&under);
        if !all().all(is_exact) {
            // Nobody needs all digits; shifts round downwards.
            let bits = all().flatten().map(BigInt::bits).max().unwrap_or(0);
            let shift = bits.saturating_sub(BITS);
            for [lo, hi] in over.iter_mut().chain(&mut under).filter(|_| shift > 0) {
                (*lo, *hi) = (&*lo >> shift, -(-&*hi >> shift));
            }
            return RationalFunction { over, under };
        }
        let twos = all().filter_map(|[x, _]| x.trailing_zeros()).min().unwrap_or(0);
        if twos > 0 {
            over.iter_mut().chain(&mut under).flatten().for_each(|x| *x >>= twos);
        }
        let all = || over.iter().chain(&under);
        if all().all(|[x, _]| x.bits() <= SHORT) {
            return RationalFunction { over, under };
        }
        let mut divisor = BigInt::zero();
        for x in over.iter().chain(&under).flatten() {
            divisor = divisor.gcd(x);
            if divisor.is_one() {
                return RationalFunction { over, under };
            }
        }
        if !divisor.is_zero() {
            over.iter_mut().chain(&mut under).flatten().for_each(|x| *x /= &divisor);
        }
        RationalFunction { over, under }
    }

    /// The function that runs through the numbers above `from`, up to `to` where that is given; the number
    /// itself if both are one.
    pub fn range(from: &BigRational, to: Option<&BigRational>) -> RationalFunction {
        let whole = |x: &BigRational, scale: &BigInt| exactly(x.numer() * (scale / x.denom()));
        match to {
            // As a quotient of polynomials it would grow by each operation.
            Some(to) if to == from => RationalFunction::ratio(from, &()),
            Some(to) => {
                let scale = from.denom().lcm(to.denom());
                let under = vec![exactly(scale.clone()); 2];
                RationalFunction::new(vec![whole(from, &scale), whole(to, &scale)], under)
            }
            None => {
                let q = exactly(from.denom().clone());
                RationalFunction::new(vec![exactly(from.numer().clone()), q.clone()], vec![q])
            }
        }
    }

    /// A number to 2⁻³⁸³ of its size, for what needs no more: by each operation one that is exact gets more
    /// digits, and a divisor common to all of them costs more than the operation.
    pub fn about(x: &BigRational) -> RationalFunction {
        if x.is_zero() {
            return RationalFunction::ratio(x, &());
        }
        let places = BITS + x.denom().bits();
        let places = places.saturating_sub(x.numer().bits());
        let below = (x.numer() << places).div_floor(x.denom());
        RationalFunction {
            over: vec![[below.clone(), below + 1]],
            under: vec![exactly(BigInt::one() << places)],
        }
    }

    /// A number between these two.
    pub fn between([lo, hi]: [&BigRational; 2]) -> RationalFunction {
        let above = [lo.numer() * hi.denom(), hi.numer() * lo.denom()];
        RationalFunction::new(vec![above], vec![exactly(lo.denom() * hi.denom())])
    }

    /// Its value if it does not depend on x, and is exact.
    pub fn constant(&self) -> Option<BigRational> {
        if !self.is_exact() {
            return None;
        }
        // over = c·under, coefficient by coefficient.
        let at = self.under.iter().position(|x| !is_zero(x))?;
        let zero = exactly(BigInt::zero());
        let get = |list: &[Between], i: usize| list.get(i).unwrap_or(&zero).clone();
        let (p, q) = (get(&self.over, at), get(&self.under, at));
        let longest = self.over.len().max(self.under.len());
        let holds = (0..longest).all(|i| times(&get(&self.over, i), &q) == times(&get(&self.under, i), &p));
        let [[p, _], [q, _]] = [p, q];
        holds.then(|| BigRational::new(p, q))
    }

    /// Two numbers between which it is, one if it is exact, if it certainly does not depend on x.
    pub fn value(&self) -> Option<[BigRational; 2]> {
        let number = || match (&self.over[..], &self.under[..]) {
            ([over], [under]) => quotient(over, under),
            _ => None,
        };
        self.constant().map(|value| [value.clone(), value]).or_else(number)
    }

    fn is_exact(&self) -> bool {
        self.over.iter().chain(&self.under).all(is_exact)
    }

    /// Whether it is certainly ≥ 0 for every x > 0.
    pub(crate) fn is_nonnegative(&self) -> bool {
        let signs = sign(&self.over).zip(sign(&self.under).filter(|_| is_certain(&self.under)));
        signs.is_some_and(|(over, under)| over * under >= 0)
    }

    /// Whether it is certainly > 0 for every x > 0.
    pub(crate) fn is_positive(&self) -> bool {
        self.is_nonnegative() && is_certain(&self.over)
    }

    /// Whether it certainly increases, or certainly decreases, with x > 0.
    pub(crate) fn runs_one_way(&self) -> bool {
        // P′Q − PQ′ = Σ (i − j) pᵢ qⱼ xⁱ⁺ʲ⁻¹: what cancels exactly is not there.
        let mut slope = vec![exactly(BigInt::zero()); self.over.len() + self.under.len()];
        for (i, p) in self.over.iter().enumerate() {
            for (j, q) in self.under.iter().enumerate().filter(|(j, _)| *j != i) {
                let part = times(&times(p, q), &exactly(BigInt::from(i) - BigInt::from(j)));
                slope[i + j] = [0, 1].map(|end| &slope[i + j][end] + &part[end]);
            }
        }
        let one = |list: &[Between]| sign(list).is_some() && is_certain(list);
        one(&slope) && one(&product(&self.under, &self.under))
    }

    /// Its limits as x → 0 and x → ∞, where they are finite, each between two numbers.
    pub(crate) fn ends(&self) -> Option<[[BigRational; 2]; 2]> {
        let limit = |over: &mut dyn Iterator<Item = &Between>, under: &mut dyn Iterator<Item = &Between>| {
            let none = exactly(BigInt::zero());
            loop {
                let (over, under) = (over.next().unwrap_or(&none), under.next()?);
                if !is_zero(under) {
                    return quotient(over, under);
                }
                if !is_zero(over) {
                    return None;
                }
            }
        };
        // As x → ∞ the highest coefficients count: both lists are made as long as the longer.
        let longest = self.over.len().max(self.under.len());
        let padded = |list: &[Between]| {
            let mut list = list.to_vec();
            list.resize(longest, exactly(BigInt::zero()));
            list.reverse();
            list
        };
        let (over, under) = (padded(&self.over), padded(&self.under));
        Some([
            limit(&mut self.over.iter(), &mut self.under.iter())?,
            limit(&mut over.iter(), &mut under.iter())?,
        ])
    }

    /// The least and greatest of its limits, if it certainly lies between them; a little more of what is not
    /// exact.
    pub(crate) fn bounds(&self) -> Option<[BigRational; 2]> {
        if let Some(value) = self.value() {
            return Some(value);
        }
        let [zero, infinity] = self.ends()?;
        let [[a, b], [c, d]] = [zero, infinity];
        let (mut lo, mut hi) = (a.min(c), b.max(d));
        if !self.is_exact() {
            let slack = lo.abs().max(hi.abs()) / BigRational::from_integer(BigInt::one() << SLACK);
            // Up to 0, where that is an end's side.
            let zero = BigRational::zero();
            lo = if lo.is_negative() { lo - &slack } else { zero.clone().max(lo - &slack) };
            hi = if hi.is_positive() { hi + slack } else { zero.min(hi + slack) };
        }
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

/// Two numbers between which a quotient is, if its divisor is certainly not 0.
fn quotient(over: &Between, under: &Between) -> Option<[BigRational; 2]> {
    if !is_certain(std::slice::from_ref(under)) {
        return None;
    }
    let ([lo, hi], under) = match under[0].is_positive() {
        true => (over.clone(), under.clone()),
        false => (negated(over), negated(under)),
    };
    // The least by the greatest divisor if it is not negative, and so on.
    let [least, greatest] = [!lo.is_negative(), hi.is_negative()].map(|far| &under[usize::from(far)]);
    Some([BigRational::new(lo, least.clone()), BigRational::new(hi, greatest.clone())])
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

/// 1 or −1 if no coefficient may have the other sign, 0 if all are 0.
fn sign(list: &[Between]) -> Option<i32> {
    let (up, down) = (list.iter().any(|x| x[1].is_positive()), list.iter().any(|x| x[0].is_negative()));
    match (up, down) {
        (true, true) => None,
        (up, down) => Some(i32::from(up) - i32::from(down)),
    }
}

/// Whether some coefficient is certainly not 0.
fn is_certain(list: &[Between]) -> bool {
    list.iter().any(|[lo, hi]| lo.is_positive() || hi.is_negative())
}

/// p and q with q times the first the same as p times the second, if there are such numbers.
fn alike(a: &[Between], b: &[Between]) -> Option<[Between; 2]> {
    let at = a.iter().position(|x| !is_zero(x))?;
    let (p, q) = (&a[at], b.get(at)?);
    let same = a.len() == b.len()
        && !is_zero(q)
        && a.iter().chain(b).all(is_exact)
        && a.iter().zip(b).all(|(a, b)| times(a, q) == times(b, p));
    same.then(|| [p.clone(), q.clone()])
}

impl Neg for RationalFunction {
    type Output = Self;

    fn neg(self) -> Self {
        RationalFunction { over: self.over.iter().map(negated).collect(), ..self }
    }
}

impl Add<&RationalFunction> for RationalFunction {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        // With divisors that are multiples of each other by a number the powers do not grow.
        if let Some([p, q]) = alike(&self.under, &other.under) {
            let scaled =
                |list: &[Between], by: &Between| list.iter().map(|x| times(x, by)).collect::<Vec<_>>();
            let over = sum(&scaled(&self.over, &q), &scaled(&other.over, &p));
            return RationalFunction::new(over, scaled(&self.under, &q));
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
        let [over, under] = [value.numer(), value.denom()].map(|x| vec![exactly(x.clone())]);
        RationalFunction { over, under }
    }

    fn integer(value: i32, (): &()) -> Self {
        RationalFunction::ratio(&BigRational::from_integer(value.into()), &())
    }

    fn sign(&self) -> Option<Sign> {
        if self.over.iter().all(is_zero) {
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
    fn a_number_is_about_itself() {
        let ten = |power: i32| num_traits::pow(BigInt::from(10), power.unsigned_abs() as usize);
        let huge = BigRational::new(ten(400) + 1, 3.into());
        let tiny = BigRational::new(1.into(), ten(400) + 1);
        let digits = BigRational::new(ten(200) + 7, ten(200) - 9);
        for x in
            [number(1, 3), number(2, 1), number(-7, 10), huge.clone(), -huge, tiny.clone(), -tiny, digits]
        {
            let [lo, hi] = RationalFunction::about(&x).value().unwrap();
            let width = (&hi - &lo) / x.abs();
            let least = BigRational::from_integer(BigInt::one() << (BITS - 2));
            assert!(lo <= x && x <= hi && width <= least.recip(), "{x}");
            assert_eq!(RationalFunction::about(&x).constant(), None, "{x}");
        }
        assert!(RationalFunction::about(&number(0, 1)).is_zero());
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

    /// Each coefficient anywhere in its bounds: what is said holds.
    #[test]
    fn what_is_between_two_numbers_is_bounded_by_both() {
        let [lo, hi] = [number(314, 100), number(315, 100)];
        let pi = RationalFunction::between([&lo, &hi]);
        assert_eq!((pi.value(), pi.constant()), (Some([lo.clone(), hi.clone()]), None));
        assert_eq!((pi.sign(), (pi.clone() - &pi).sign()), (Some(Sign::Positive), None));
        let x = RationalFunction::range(&number(1, 1), Some(&number(2, 1)));
        // −x/π, from −2/3.14 to −1/3.15, and a little more.
        let found = -(x.clone() / &pi);
        let [least, greatest] = found.bounds().unwrap();
        assert!(least <= number(-200, 314) && greatest >= number(-100, 315));
        assert!(least > number(-201, 314) && greatest < number(-99, 315));
        assert!(found.runs_one_way() && !(x.clone() / &pi - &(x.clone() / &pi)).runs_one_way());
        // Of numbers with too many digits what is left holds them.
        let digits =
            BigRational::new(num_traits::pow(BigInt::from(3), 900), num_traits::pow(BigInt::from(2), 1400));
        let short = pi.clone() * &RationalFunction::ratio(&digits, &());
        let [least, greatest] = short.value().unwrap();
        let [below, above] = [&lo * &digits, &hi * &digits];
        let slack = &above / BigRational::from_integer(BigInt::one() << 300);
        assert!(least <= below && least > below - &slack && greatest >= above && greatest < above + &slack);
        assert!(short.over.iter().chain(&short.under).flatten().all(|x| x.bits() <= BITS));
        assert_eq!((x.clone() * &x - &(x.clone() * &x)).sign(), Some(Sign::Zero));
    }
}
