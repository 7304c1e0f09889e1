//! b_{n,k} and c_n from trace and determinant (a₁, a₂), a₂ > 0: every region, real and equal eigenvalues
//! included.
//!
//! Let α = |a₁| and ũ_k, ṽ_k the sequences of (α, a₂): u_k = (±1)^{k−1} ũ_k. With real eigenvalues (α² ≥ 4a₂)
//! every ũ_k is positive, and with e = 1 − α + a₂ and the sums U_m = Σ_{i≤m} ũ_i, P_m = Σ_{i≤m} a₂^{m−i} ũ_i,
//!
//! ```text
//! ũ_n − ũ_k − a₂^k ũ_{n−k} = −e (ũ_{n−k} P_k + ũ_k U_{n−k−1}),   1 − ṽ_n + a₂ⁿ = e (U_n + a₂ P_{n−1}):
//! ```
//!
//! terms of one sign, with e taken exactly, so nothing cancels near a₁ = ±(a₂ + 1), near a₁ = ±2√a₂ or as a₂
//! → 1. With h_k = ṽ_k/2, D = α²/4 − a₂ ≥ 0 (exact, too) and the sums V_m, Q_m of h as U_m, P_m are of ũ, two
//! indices add up by
//!
//! ```text
//! ũ_{i+j} = h_i ũ_j + ũ_i h_j                 h_{i+j} = h_i h_j + D ũ_i ũ_j
//! U_{i+j} = U_i + h_i U_j + ũ_i V_j           V_{i+j} = V_i + h_i V_j + D ũ_i U_j
//! P_{i+j} = a₂^j P_i + h_i P_j + ũ_i Q_j      Q_{i+j} = a₂^j Q_i + h_i Q_j + D ũ_i P_j
//! ```
//!
//! (from λ^k = h_k ± ũ_k √D), sums of products of positive numbers: a doubling doubles the relative error and
//! cancels nothing, so that log₂ n bits are lost. With complex eigenvalues u_k and v_k come from duplication
//! formulas, whose errors grow like n², not like (2.4)ⁿ.

use std::{
    convert::Infallible,
    fmt,
    ops::{Mul, Sub},
};

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed};
use serde::{Serialize, Serializer};

use crate::{
    error::{Error, Result},
    monitor::Monitor,
    number::{Real, Sign},
};

/// A point (a₁, a₂) with a₂ > 0.
#[derive(Debug, Clone)]
pub struct Plane {
    a1: BigRational,
    a2: BigRational,
    /// α² ≥ 4a₂.
    real: bool,
    /// The t of a₁² = t a₂, if it is 0, 1, 2 or 3.
    square: Option<u8>,
    /// e = 1 − |a₁| + a₂. This and the next, not in lowest terms: a greatest common divisor of long integers
    /// would cost more than a sign.
    excess: BigRational,
    /// D = α²/4 − a₂.
    quarter: BigRational,
}

/// The regions of the paper's figure 2; its lines, where they are no part of a region, are `Line`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Region {
    /// a₁ > a₂ + 1.
    One,
    /// 2√a₂ ≤ a₁ < a₂ + 1.
    Two,
    /// |a₁| < 2√a₂: complex eigenvalues.
    Three,
    /// −(a₂ + 1) < a₁ ≤ −2√a₂.
    Four,
    /// a₁ < −(a₂ + 1).
    Five,
    /// |a₁| = a₂ + 1: an eigenvalue 1 or −1.
    Line,
}

impl Region {
    /// All.
    const ALL: [Region; 6] =
        [Region::One, Region::Two, Region::Three, Region::Four, Region::Five, Region::Line];

    /// The one that is written so: `1` to `5`, or `line`.
    pub fn named(text: &str) -> Option<Region> {
        Region::ALL.into_iter().find(|region| region.to_string() == text)
    }

    /// What its eigenvalues are, after its number.
    pub fn words(self) -> String {
        let eigenvalues = match self {
            Region::One => "0 < lambda2 < 1 < lambda1",
            Region::Two => "eigenvalues in (0, 1)",
            Region::Three => "complex eigenvalues",
            Region::Four => "eigenvalues in (-1, 0)",
            Region::Five => "lambda2 < -1 < lambda1 < 0",
            Region::Line => return "on a line |a1| = a2 + 1: an eigenvalue 1 or -1".into(),
        };
        format!("{self}: {eigenvalues}")
    }

    /// That of (a₁, a₂), taken as they are; after reversing time if a₂ > 1. `None` for a₂ ≤ 0.
    pub fn at(mut a1: f64, mut a2: f64) -> Option<Region> {
        if a2 > 1.0 {
            (a1, a2) = (a1 / a2, 1.0 / a2);
        }
        Some(Plane::new(BigRational::from_float(a1)?, BigRational::from_float(a2)?).ok()?.region())
    }
}

/// The paper's number of the region, or `line`.
impl fmt::Display for Region {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Region::One => "1",
            Region::Two => "2",
            Region::Three => "3",
            Region::Four => "4",
            Region::Five => "5",
            Region::Line => "line",
        })
    }
}

/// As text: `1` to `5`, or `line`.
impl Serialize for Region {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl Plane {
    /// The point (a₁, a₂). Cost: some products of integers of its size.
    ///
    /// # Errors
    /// An input error unless a₂ > 0.
    pub fn new(a1: BigRational, a2: BigRational) -> Result<Plane> {
        if !a2.is_positive() {
            return Err(Error::input(format!("a2 = {a2} is outside a2 > 0")));
        }
        let (p, q, x, y) = (a1.numer(), a1.denom(), a2.numer(), a2.denom());
        // a₁² = t a₂ where p²y = t xq².
        let (left, right) = (p * p * y, q * q * x);
        let square = (0..4u8).find(|&t| left == &right * t);
        let quarter = BigRational::new_raw(&left - &right * 4, q * q * y * 4);
        let excess = BigRational::new_raw(q * y - p.abs() * y + x * q, q * y);
        Ok(Plane { real: !quarter.is_negative(), square, excess, quarter, a1, a2 })
    }

    /// a₁.
    pub fn a1(&self) -> &BigRational {
        &self.a1
    }

    /// a₂.
    pub fn a2(&self) -> &BigRational {
        &self.a2
    }

    /// The region of the point: exact.
    pub fn region(&self) -> Region {
        let negative = self.a1.is_negative();
        match (Sign::of(&self.excess), self.real) {
            (_, false) => Region::Three,
            (Sign::Zero, true) => Region::Line,
            (Sign::Negative, true) => {
                if negative {
                    Region::Five
                } else {
                    Region::One
                }
            }
            (Sign::Positive, true) => {
                if negative {
                    Region::Four
                } else {
                    Region::Two
                }
            }
        }
    }

    /// Whether u_n = 0: by Niven's theorem, exactly where a₁² is 0, a₂, 2a₂ or 3a₂ and 2, 3, 4 or 6 divides
    /// n.
    pub fn is_singular(&self, n: u64) -> bool {
        self.square.is_some_and(|t| n.is_multiple_of([2, 3, 4, 6][usize::from(t)]))
    }

    /// b_{n,k}, 1 ≤ k < n; `None` where u_n = 0.
    ///
    /// O(log n) operations on O(1) numbers. Real eigenvalues: log₂ n bits lost and a few, but where n is odd
    /// and a₁ < 0, as many as the condition number of b_{n,k} says. Complex ones: 2 log₂ n bits lost and
    /// those of the condition number. A ball loses none of these where differences of duplicated u_k by twice
    /// its length keep their digits.
    pub fn b<T: Real>(&self, n: u64, k: u64, context: &T::Context) -> Option<T> {
        if !self.is_singular(n)
            && let Some(quotient) = T::plane_quotient(self.doubling(), [n, k], context)
        {
            return Some(quotient);
        }
        let (numerator, u) = self.numerator::<T>(n, k, context)?;
        Some(numerator / &u)
    }

    /// What the numbers of 2i and i + 1 are made of, beside those of i: a₁, D and a₂.
    pub(super) fn doubling(&self) -> [&BigRational; 3] {
        [&self.a1, &self.quarter, &self.a2]
    }

    /// The sign of b_{n,k} where it is certain; `None` where u_n = 0.
    ///
    /// From real eigenvalues the numerator is a sum of terms of one sign, or e times one, unless n is odd and
    /// a₁ < 0.
    pub(super) fn b_sign<T: Real>(&self, n: u64, k: u64, context: &T::Context) -> Option<Option<Sign>> {
        let cancels = !self.real || (self.a1.is_negative() && n.is_odd());
        if !self.is_singular(n)
            && cancels
            && let Some(sign) = T::plane_sign(self.doubling(), [n, k], context)
        {
            return Some(sign);
        }
        let (numerator, u) = self.numerator::<T>(n, k, context)?;
        Some(numerator.sign().zip(u.sign()).map(|(a, b)| a * b))
    }

    /// N_{n,k} = u_n b_{n,k} and u_n; `None` where u_n = 0.
    pub(super) fn numerator<T: Real>(&self, n: u64, k: u64, context: &T::Context) -> Option<(T, T)> {
        if self.is_singular(n) {
            return None;
        }
        if self.real {
            let (real, j) = (Eigenvalues::<T>::new(self, context), n - k);
            let (at_k, before_j) = (real.at(k), real.at(j - 1));
            let at_j = real.add(&before_j, &real.one);
            let un = real.u(&at_k, &at_j);
            let numerator = real.numerator((n, k), &un, &at_k, &before_j, &at_j);
            return Some((numerator, real.signed(un, n)));
        }
        let [un, uk, uj] = [n, k, n - k].map(|i| self.lucas::<T>(i, context));
        Some((un.u.clone() - &uk.u - &(uk.power * &uj.u), un.u))
    }

    /// N_{n,1}, …, N_{n,n−1} and u_n; `None` where u_n = 0. Cost: O(n) operations and numbers. From real
    /// eigenvalues some more digits are lost than by [`numerator`](Self::numerator), O(n) bounds being added
    /// up.
    pub(super) fn numerators<T: Real>(&self, n: u64, context: &T::Context) -> Option<(Vec<T>, T)> {
        if self.is_singular(n) {
            return None;
        }
        if self.real {
            let real = Eigenvalues::<T>::new(self, context);
            let all = real.all(n);
            let un = &all[n as usize].u;
            let one = |k: usize| {
                let j = n as usize - k;
                real.numerator((n, k as u64), un, &all[k], &all[j - 1], &all[j])
            };
            return Some(((1..n as usize).map(one).collect(), real.signed(un.clone(), n)));
        }
        let all = self.lucas_up_to::<T>(n, context);
        let un = &all[n as usize].u;
        let one = |k: usize| un.clone() - &all[k].u - &(all[k].power.clone() * &all[n as usize - k].u);
        Some(((1..n as usize).map(one).collect(), un.clone()))
    }

    /// u_1, …, u_n and 2 − v_1, …, 2 − v_n. Cost: O(n) operations and numbers; each loses O(log n) digits,
    /// and those of its condition number.
    pub(crate) fn terms<T: Real>(&self, n: u64, context: &T::Context) -> Vec<(T, T)> {
        let two = T::integer(2, context);
        let all = self.lucas_up_to::<T>(n, context);
        all.into_iter().skip(1).map(|term| (term.u, two.clone() - &term.v)).collect()
    }

    /// u_n. Cost: O(log n) operations.
    pub fn u<T: Real>(&self, n: u64, context: &T::Context) -> T {
        if self.real {
            let real = Eigenvalues::<T>::new(self, context);
            return real.signed(real.at(n).u, n);
        }
        self.lucas::<T>(n, context).u
    }

    /// A positive multiple of u_n as an integer; `None` beyond `limit` bits.
    pub(super) fn exact_u(&self, n: u64, limit: u64, monitor: &dyn Monitor) -> Result<Option<BigInt>> {
        let Some((a, b, _)) = self.integers(n, limit) else { return Ok(None) };
        Ok(Some(lucas(&a, &b, n, BigInt::from, || monitor.advance(0))?.u))
    }

    /// b_{n,1}, …, b_{n,n−1}; `None` where u_n = 0. O(n) operations and numbers for real eigenvalues, O(n log
    /// n) operations for complex ones.
    pub fn b_all<T: Real>(&self, n: u64, context: &T::Context) -> Option<Vec<T>> {
        if self.is_singular(n) {
            return None;
        }
        if self.real {
            let real = Eigenvalues::<T>::new(self, context);
            let all = real.all(n);
            let un = &all[n as usize].u;
            let one = |k: u64| {
                let [k_, j] = [k as usize, (n - k) as usize];
                let numerator = real.numerator((n, k), un, &all[k_], &all[j - 1], &all[j]);
                numerator / &real.signed(un.clone(), n)
            };
            return Some((1..n).map(one).collect());
        }
        let values: Vec<Lucas<T>> = (0..=n).map(|i| self.lucas(i, context)).collect();
        let at = |i: u64| &values[i as usize];
        let numerator = |k| at(n).u.clone() - &at(k).u - &(at(k).power.clone() * &at(n - k).u);
        Some((1..n).map(|k| numerator(k) / &at(n).u).collect())
    }

    /// c_n, n ≥ 1; `None` where u_n = 0. Cost and digits as for [`Plane::b`].
    pub fn c<T: Real>(&self, n: u64, context: &T::Context) -> Option<T> {
        let (factor, u) = self.c_parts::<T>(n, context)?;
        Some(-factor / &u)
    }

    /// 1 − v_n + a₂ⁿ and u_n; `None` where u_n = 0.
    pub(super) fn c_parts<T: Real>(&self, n: u64, context: &T::Context) -> Option<(T, T)> {
        if self.is_singular(n) {
            return None;
        }
        if self.real {
            let real = Eigenvalues::<T>::new(self, context);
            let before = real.at(n - 1);
            let here = real.add(&before, &real.one);
            return Some((real.factor(n, &before, &here), real.signed(here.u, n)));
        }
        let lucas = self.lucas::<T>(n, context);
        Some((T::integer(1, context) - &lucas.v + &lucas.power, lucas.u))
    }

    /// u_k, v_k, a₂^k by duplication: O(log k) operations.
    fn lucas<T: Real>(&self, k: u64, context: &T::Context) -> Lucas<T> {
        let (a1, a2) = (T::ratio(&self.a1, context), T::ratio(&self.a2, context));
        let Ok(lucas) = lucas(&a1, &a2, k, |i| T::integer(i, context), || Ok::<(), Infallible>(()));
        lucas
    }

    /// u_k, v_k, a₂^k for k = 0, …, n, each by duplication from those of half its index: O(n) operations.
    fn lucas_up_to<T: Real>(&self, n: u64, context: &T::Context) -> Vec<Lucas<T>> {
        let (a1, a2) = (T::ratio(&self.a1, context), T::ratio(&self.a2, context));
        let integer = |i| T::integer(i, context);
        let mut all = Vec::with_capacity(n as usize + 1);
        all.push(Lucas { u: integer(0), v: integer(2), power: integer(1) });
        all.push(Lucas { u: integer(1), v: a1.clone(), power: a2.clone() });
        for k in 2..=n as usize {
            // For odd k ≥ 3, k/2 + 1 < k.
            let (half, next): (&Lucas<T>, &Lucas<T>) = (&all[k / 2], &all[k / 2 + k % 2]);
            let square = half.power.clone() * &half.power;
            all.push(if k.is_multiple_of(2) {
                let v = half.v.clone() * &half.v - &half.power - &half.power;
                Lucas { u: half.u.clone() * &half.v, v, power: square }
            } else {
                let u = next.u.clone() * &half.v - &half.power;
                let v = half.v.clone() * &next.v - &(a1.clone() * &half.power);
                Lucas { u, v, power: square * &a2 }
            });
        }
        all
    }

    /// The integers of the exact rung: A, B, D with a₁ = A/D, a₂ = B/D²; `None` if by estimate u_n D^{n−1}
    /// has more than `limit` bits.
    fn integers(&self, n: u64, limit: u64) -> Option<(BigInt, BigInt, BigInt)> {
        let (p, q, x, y) = (self.a1.numer(), self.a1.denom(), self.a2.numer(), self.a2.denom());
        let within = |size: u64| n.saturating_mul(size + 1) <= limit;
        // D is no shorter than either: a common multiple of long integers costs more than the balls do.
        if !within(q.bits().max(y.bits())) {
            return None;
        }
        let d = q.lcm(y);
        let (a, b) = (p * (&d / q), x * (&d / y) * &d);
        within(a.bits().max(b.bits().div_ceil(2)).max(d.bits())).then_some((a, b, d))
    }

    /// Bits of the longest denominator or numerator.
    pub(super) fn length(&self) -> u64 {
        let bits = |x: &BigRational| x.numer().bits().max(x.denom().bits());
        bits(&self.a1).max(bits(&self.a2))
    }

    /// D^{n+k−1}·N_{n,k} and D^{n+k−1}·u_n as integers, without a fraction anywhere; `None` beyond `limit`
    /// bits.
    ///
    /// With W_k = D^{k−1} u_k they are D^k W_n − Dⁿ W_k − B^k W_{n−k} and D^k W_n. Cost: O(log n) products of
    /// n·size bits.
    ///
    /// # Errors
    /// The monitor's interruption, asked for before every step.
    pub fn exact_numerator(
        &self,
        n: u64,
        k: u64,
        limit: u64,
        monitor: &dyn Monitor,
    ) -> Result<Option<(BigInt, BigInt)>> {
        let Some((a, b, d)) = self.integers(n, limit / 2) else { return Ok(None) };
        let w = |i| lucas(&a, &b, i, BigInt::from, || monitor.advance(0));
        let (wn, wk, wj) = (w(n)?, w(k)?, w(n - k)?);
        let denominator = power(&d, k, monitor)? * wn.u;
        let numerator = &denominator - power(&d, n, monitor)? * wk.u - wk.power * wj.u;
        Ok(Some((numerator, denominator)))
    }

    /// D^{2n}(1 − v_n + a₂ⁿ) and a positive multiple of u_n as integers; `None` beyond `limit` bits. Cost:
    /// O(log n) products of integers of up to n times the bits of the point.
    ///
    /// # Errors
    /// As [`Plane::exact_numerator`].
    pub(crate) fn exact_factor(
        &self,
        n: u64,
        limit: u64,
        monitor: &dyn Monitor,
    ) -> Result<Option<(BigInt, BigInt)>> {
        let Some((a, b, d)) = self.integers(n, limit / 2) else { return Ok(None) };
        let w = lucas(&a, &b, n, BigInt::from, || monitor.advance(0))?;
        let power = power(&d, n, monitor)?;
        Ok(Some((&power * &power - &power * w.v + w.power, w.u)))
    }
}

/// d^k.
fn power(d: &BigInt, k: u64, monitor: &dyn Monitor) -> Result<BigInt> {
    let mut power = BigInt::one();
    for bit in (0..64 - k.leading_zeros()).rev() {
        monitor.advance(0)?;
        power = &power * &power;
        if k >> bit & 1 == 1 {
            power *= d;
        }
    }
    Ok(power)
}

/// u_k, v_k and a₂^k.
struct Lucas<T> {
    u: T,
    v: T,
    power: T,
}

/// Before every step `watch` may end it. Duplication: u_{2i} = u_i v_i, u_{2i+1} = u_{i+1} v_i − a₂^i, v_{2i}
/// = v_i² − 2a₂^i, v_{2i+1} = v_i v_{i+1} − a₁ a₂^i.
fn lucas<T, E>(
    a1: &T,
    a2: &T,
    k: u64,
    integer: impl Fn(i32) -> T,
    watch: impl Fn() -> std::result::Result<(), E>,
) -> std::result::Result<Lucas<T>, E>
where
    T: Clone + for<'a> Mul<&'a T, Output = T> + for<'a> Sub<&'a T, Output = T>,
{
    let times = |a: &T, b: &T| a.clone() * b;
    // u_i, u_{i+1}, v_i, v_{i+1}, a₂^i, from i = 0.
    let (mut u, mut u1, mut v, mut v1, mut power) =
        (integer(0), integer(1), integer(2), a1.clone(), integer(1));
    for bit in (0..64 - k.leading_zeros()).rev() {
        watch()?;
        let next = times(&power, a2);
        let odd = (times(&u1, &v) - &power, times(&v, &v1) - &times(a1, &power));
        if k >> bit & 1 == 0 {
            (u, v) = (times(&u, &v), times(&v, &v) - &power - &power);
            (u1, v1) = odd;
            power = times(&power, &power);
        } else {
            (u1, v1) = (times(&u1, &v1), times(&v1, &v1) - &next - &next);
            (u, v) = odd;
            power = times(&power, &next);
        }
    }
    Ok(Lucas { u, v, power })
}

/// ũ_i, h_i, U_i, V_i, P_i, Q_i and a₂^i for one i (see the head of this file).
struct Terms<T> {
    u: T,
    h: T,
    sum_u: T,
    sum_h: T,
    weighted_u: T,
    weighted_h: T,
    power: T,
}

/// What the terms of real eigenvalues are made of.
struct Eigenvalues<T> {
    negative: bool,
    excess: T,
    a2: T,
    /// D = α²/4 − a₂.
    quarter: T,
    nothing: T,
    unit: T,
    /// The terms for i = 1.
    one: Terms<T>,
}

impl<T: Real> Eigenvalues<T> {
    fn new(point: &Plane, context: &T::Context) -> Self {
        let half = BigRational::new_raw(point.a1.numer().abs(), point.a1.denom() * 2);
        let (one, a2, h) = (T::integer(1, context), T::ratio(&point.a2, context), T::ratio(&half, context));
        let terms = Terms {
            u: one.clone(),
            h: h.clone(),
            sum_u: one.clone(),
            sum_h: h.clone(),
            weighted_u: one.clone(),
            weighted_h: h,
            power: a2.clone(),
        };
        Eigenvalues {
            negative: point.a1.is_negative(),
            excess: T::ratio(&point.excess, context),
            a2,
            quarter: T::ratio(&point.quarter, context),
            nothing: T::integer(0, context),
            unit: one,
            one: terms,
        }
    }

    /// The terms for i = 0.
    fn zero(&self) -> Terms<T> {
        let [u, sum_u, sum_h, weighted_u, weighted_h] = [(); 5].map(|()| self.nothing.clone());
        Terms { u, h: self.unit.clone(), sum_u, sum_h, weighted_u, weighted_h, power: self.unit.clone() }
    }

    /// The terms for 0, 1, …, n, one step at a time.
    fn all(&self, n: u64) -> Vec<Terms<T>> {
        let step = |last: &Terms<T>| Some(self.add(last, &self.one));
        std::iter::successors(Some(self.zero()), step).take(n as usize + 1).collect()
    }

    /// ũ_{i+j}.
    fn u(&self, i: &Terms<T>, j: &Terms<T>) -> T {
        i.h.clone() * &j.u + &(i.u.clone() * &j.h)
    }

    /// The terms for i + j.
    fn add(&self, i: &Terms<T>, j: &Terms<T>) -> Terms<T> {
        // h_i x + ũ_i y.
        let turn = |u: &T, x: &T, y: &T| i.h.clone() * x + &(u.clone() * y);
        let scaled = i.u.clone() * &self.quarter;
        Terms {
            u: turn(&i.u, &j.u, &j.h),
            h: turn(&scaled, &j.h, &j.u),
            sum_u: i.sum_u.clone() + &turn(&i.u, &j.sum_u, &j.sum_h),
            sum_h: i.sum_h.clone() + &turn(&scaled, &j.sum_h, &j.sum_u),
            weighted_u: j.power.clone() * &i.weighted_u + &turn(&i.u, &j.weighted_u, &j.weighted_h),
            weighted_h: j.power.clone() * &i.weighted_h + &turn(&scaled, &j.weighted_h, &j.weighted_u),
            power: i.power.clone() * &j.power,
        }
    }

    /// The terms for k, by doubling: O(log k) operations.
    fn at(&self, k: u64) -> Terms<T> {
        let mut terms = self.zero();
        for bit in (0..64 - k.leading_zeros()).rev() {
            terms = self.add(&terms, &terms);
            if k >> bit & 1 == 1 {
                terms = self.add(&terms, &self.one);
            }
        }
        terms
    }

    /// u_k = (±1)^{k−1} ũ_k.
    fn signed(&self, u: T, k: u64) -> T {
        if self.negative && k.is_even() { -u } else { u }
    }

    /// N_{n,k} from ũ_n and the terms for k, n − k − 1 and n − k.
    fn numerator(
        &self,
        (n, k): (u64, u64),
        un: &T,
        at_k: &Terms<T>,
        before_j: &Terms<T>,
        at_j: &Terms<T>,
    ) -> T {
        let tail = at_k.power.clone() * &at_j.u;
        match (self.negative, n.is_even(), k.is_even()) {
            // u_k, u_n and u_{n−k} all keep their sign, or all change it.
            (false, _, _) | (true, true, true) => {
                let sum = at_j.u.clone() * &at_k.weighted_u + &(at_k.u.clone() * &before_j.sum_u);
                let product = self.excess.clone() * &sum;
                if self.negative { product } else { -product }
            }
            (true, true, false) => -(un.clone() + &at_k.u + &tail),
            (true, false, false) => un.clone() - &at_k.u + &tail,
            (true, false, true) => un.clone() + &at_k.u - &tail,
        }
    }

    /// 1 − v_n + a₂ⁿ from the terms for n − 1 and n.
    fn factor(&self, n: u64, before: &Terms<T>, here: &Terms<T>) -> T {
        if self.negative && n.is_odd() {
            // v_n = −ṽ_n = −2h_n.
            return self.unit.clone() + &here.h + &here.h + &here.power;
        }
        self.excess.clone() * &(here.sum_u.clone() + &(self.a2.clone() * &before.weighted_u))
    }
}
