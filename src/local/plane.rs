//! b_{n,k} and c_n from trace and determinant (a₁, a₂), a₂ > 0: every region, real and equal eigenvalues included.
//!
//! Let α = |a₁| and ũ_k the sequence of (α, a₂): u_k = (±1)^{k−1} ũ_k. With real eigenvalues (α² ≥ 4a₂) every ũ_k is
//! positive, and with e = 1 − α + a₂ and the sums U_m = Σ_{i≤m} ũ_i, P_m = Σ_{i≤m} a₂^{m−i} ũ_i,
//!
//! ```text
//! ũ_n − ũ_k − a₂^k ũ_{n−k} = −e (ũ_{n−k} P_k + ũ_k U_{n−k−1}),   1 − ṽ_n + a₂ⁿ = e (U_n + a₂ P_{n−1}):
//! ```
//!
//! terms of one sign, with e taken exactly, so nothing cancels near a₁ = ±(a₂ + 1), near a₁ = ±2√a₂ or as a₂ → 1. The ratios
//! ρ_k = ũ_{k+1}/ũ_k = α − a₂/ρ_{k−1} contract errors (ρ² ≥ a₂), unlike the recurrence for ũ. With complex
//! eigenvalues u_k and v_k come from duplication formulas, whose errors grow like n², not like (2.4)ⁿ.

use std::ops::{Mul, Sub};

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, pow};

use crate::error::{Error, Result};
use crate::number::{Real, Sign};

/// A point (a₁, a₂) with a₂ > 0.
#[derive(Debug, Clone)]
pub struct Plane {
    a1: BigRational,
    a2: BigRational,
    /// α² ≥ 4a₂.
    real: bool,
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

impl Plane {
    /// The point (a₁, a₂).
    ///
    /// # Errors
    /// An input error unless a₂ > 0.
    pub fn new(a1: BigRational, a2: BigRational) -> Result<Plane> {
        if !a2.is_positive() {
            return Err(Error::input(format!("a2 = {a2} is outside a2 > 0")));
        }
        let real = &a1 * &a1 >= &a2 * BigInt::from(4);
        Ok(Plane { a1, a2, real })
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
        match (Sign::of(&self.excess()), self.real) {
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

    /// Whether u_n = 0: by Niven's theorem, exactly where a₁² is 0, a₂, 2a₂ or 3a₂ and 2, 3, 4 or 6 divides n.
    pub fn is_singular(&self, n: u64) -> bool {
        let square = &self.a1 * &self.a1;
        [(0, 2), (1, 3), (2, 4), (3, 6)]
            .iter()
            .any(|&(times, period)| n.is_multiple_of(period) && square == &self.a2 * BigInt::from(times))
    }

    /// e = 1 − |a₁| + a₂.
    fn excess(&self) -> BigRational {
        BigRational::one() - self.a1.abs() + &self.a2
    }

    /// b_{n,k}, 1 ≤ k < n; `None` where u_n = 0.
    ///
    /// Real eigenvalues: O(n) operations, O(log n) digits lost (2 log₂ n bits at equal eigenvalues), but where n and k
    /// are odd and a₁ < 0, as many as the condition number of b_{n,k} says. Complex ones: O(log n)
    /// operations, 2 log₂ n bits lost and those of the condition number.
    pub fn b<T: Real>(&self, n: u64, k: u64, context: &T::Context) -> Option<T> {
        let (numerator, u) = self.numerator::<T>(n, k, context)?;
        Some(numerator / &u)
    }

    /// N_{n,k} = u_n b_{n,k} and u_n; `None` where u_n = 0.
    pub(super) fn numerator<T: Real>(&self, n: u64, k: u64, context: &T::Context) -> Option<(T, T)> {
        if self.is_singular(n) {
            return None;
        }
        if self.real {
            let sums = Sums::<T>::new(self, n, context);
            return Some((sums.numerator(n, k), sums.u(n)));
        }
        let [un, uk, uj] = [n, k, n - k].map(|i| self.lucas::<T>(i, context));
        Some((un.u.clone() - &uk.u - &(uk.power * &uj.u), un.u))
    }

    /// u_n. Cost: O(log n) operations for complex eigenvalues, O(n) for real ones.
    pub fn u<T: Real>(&self, n: u64, context: &T::Context) -> T {
        if self.real { Sums::<T>::new(self, n, context).u(n) } else { self.lucas::<T>(n, context).u }
    }

    /// A positive multiple of u_n as an integer; `None` beyond `limit` bits.
    pub(super) fn exact_u(&self, n: u64, limit: u64) -> Option<BigInt> {
        let (a, b, _, bits) = self.integers(n);
        (bits <= limit).then(|| lucas(&a, &b, n, BigInt::from).u)
    }

    /// b_{n,1}, …, b_{n,n−1}; `None` where u_n = 0. O(n) operations for real eigenvalues, O(n log n) for complex ones.
    pub fn b_all<T: Real>(&self, n: u64, context: &T::Context) -> Option<Vec<T>> {
        if self.is_singular(n) {
            return None;
        }
        if self.real {
            let sums = Sums::<T>::new(self, n, context);
            return Some((1..n).map(|k| sums.numerator(n, k) / &sums.u(n)).collect());
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
            let sums = Sums::<T>::new(self, n, context);
            return Some((sums.factor(n), sums.u(n)));
        }
        let lucas = self.lucas::<T>(n, context);
        Some((T::integer(1, context) - &lucas.v + &lucas.power, lucas.u))
    }

    /// u_k, v_k, a₂^k by duplication: O(log k) operations.
    fn lucas<T: Real>(&self, k: u64, context: &T::Context) -> Lucas<T> {
        let (a1, a2) = (T::ratio(&self.a1, context), T::ratio(&self.a2, context));
        lucas(&a1, &a2, k, |i| T::integer(i, context))
    }

    /// The integers of the exact rung: A, B, D with a₁ = A/D, a₂ = B/D², and an estimate of the bits of u_n D^{n−1}.
    fn integers(&self, n: u64) -> (BigInt, BigInt, BigInt, u64) {
        let d = self.a1.denom().lcm(self.a2.denom());
        let a = (&self.a1 * &d).to_integer();
        let b = (&self.a2 * (&d * &d)).to_integer();
        let bits = n.saturating_mul(a.bits().max(b.bits().div_ceil(2)).max(d.bits()) + 1);
        (a, b, d, bits)
    }

    /// D^{n+k−1}·N_{n,k} and D^{n+k−1}·u_n as integers, without a fraction anywhere; `None` beyond `limit` bits.
    ///
    /// With W_k = D^{k−1} u_k they are D^k W_n − Dⁿ W_k − B^k W_{n−k} and D^k W_n. Cost: O(log n) products of n·size bits.
    pub fn exact_numerator(&self, n: u64, k: u64, limit: u64) -> Option<(BigInt, BigInt)> {
        let (a, b, d, bits) = self.integers(n);
        if bits.saturating_mul(2) > limit {
            return None;
        }
        let w = |i| lucas(&a, &b, i, BigInt::from);
        let [wn, wk, wj] = [n, k, n - k].map(w);
        let denominator = pow(d.clone(), k as usize) * wn.u;
        let numerator = &denominator - pow(d, n as usize) * wk.u - wk.power * wj.u;
        Some((numerator, denominator))
    }

    /// D^{2n}(1 − v_n + a₂ⁿ) and a positive multiple of u_n as integers; `None` beyond `limit` bits.
    pub fn exact_factor(&self, n: u64, limit: u64) -> Option<(BigInt, BigInt)> {
        let (a, b, d, bits) = self.integers(n);
        if bits.saturating_mul(2) > limit {
            return None;
        }
        let w = lucas(&a, &b, n, BigInt::from);
        let power = pow(d, n as usize);
        Some((&power * &power - &power * w.v + w.power, w.u))
    }
}

/// u_k, v_k and a₂^k.
struct Lucas<T> {
    u: T,
    v: T,
    power: T,
}

/// Duplication: u_{2i} = u_i v_i, u_{2i+1} = u_{i+1} v_i − a₂^i, v_{2i} = v_i² − 2a₂^i, v_{2i+1} = v_i v_{i+1} − a₁ a₂^i.
fn lucas<T>(a1: &T, a2: &T, k: u64, integer: impl Fn(i32) -> T) -> Lucas<T>
where
    T: Clone + for<'a> Mul<&'a T, Output = T> + for<'a> Sub<&'a T, Output = T>,
{
    let times = |a: &T, b: &T| a.clone() * b;
    // u_i, u_{i+1}, v_i, v_{i+1}, a₂^i, from i = 0.
    let (mut u, mut u1, mut v, mut v1, mut power) =
        (integer(0), integer(1), integer(2), a1.clone(), integer(1));
    for bit in (0..64 - k.leading_zeros()).rev() {
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
    Lucas { u, v, power }
}

/// ũ_i, U_i, P_i, a₂^i for i = 0, …, n + 1, real eigenvalues.
struct Sums<T> {
    negative: bool,
    one: T,
    a2: T,
    excess: T,
    u: Vec<T>,
    sum: Vec<T>,
    weighted: Vec<T>,
    power: Vec<T>,
}

impl<T: Real> Sums<T> {
    fn new(point: &Plane, n: u64, context: &T::Context) -> Sums<T> {
        let (zero, one) = (T::integer(0, context), T::integer(1, context));
        let (alpha, a2) = (T::ratio(&point.a1.abs(), context), T::ratio(&point.a2, context));
        let mut sums = Sums {
            negative: point.a1.is_negative(),
            excess: T::ratio(&point.excess(), context),
            u: vec![zero.clone(), one.clone()],
            sum: vec![zero.clone(), one.clone()],
            weighted: vec![zero, one.clone()],
            power: vec![one.clone(), a2.clone()],
            one,
            a2,
        };
        let mut ratio = alpha.clone();
        for i in 1..=n as usize {
            let u = sums.u[i].clone() * &ratio;
            sums.sum.push(sums.sum[i].clone() + &u);
            sums.weighted.push(sums.weighted[i].clone() * &sums.a2 + &u);
            sums.power.push(sums.power[i].clone() * &sums.a2);
            sums.u.push(u);
            ratio = alpha.clone() - &(sums.a2.clone() / &ratio);
        }
        sums
    }

    /// u_k = (±1)^{k−1} ũ_k.
    fn u(&self, k: u64) -> T {
        let u = self.u[k as usize].clone();
        if self.negative && k.is_even() { -u } else { u }
    }

    /// N_{n,k}.
    fn numerator(&self, n: u64, k: u64) -> T {
        let [n_, k_, j_] = [n, k, n - k].map(|i| i as usize);
        let (un, uk, uj) = (&self.u[n_], &self.u[k_], &self.u[j_]);
        let tail = self.power[k_].clone() * uj;
        match (self.negative, n.is_even(), k.is_even()) {
            // u_k, u_n and u_{n−k} all keep their sign, or all change it.
            (false, _, _) | (true, true, true) => {
                let sum = uj.clone() * &self.weighted[k_] + &(uk.clone() * &self.sum[j_ - 1]);
                let product = self.excess.clone() * &sum;
                if self.negative { product } else { -product }
            }
            (true, true, false) => -(un.clone() + uk + &tail),
            (true, false, false) => un.clone() - uk + &tail,
            (true, false, true) => un.clone() + uk - &tail,
        }
    }

    /// 1 − v_n + a₂ⁿ.
    fn factor(&self, n: u64) -> T {
        let n_ = n as usize;
        if self.negative && n.is_odd() {
            // v_n = −ṽ_n, ṽ_n = ũ_{n+1} − a₂ ũ_{n−1}.
            let v = self.u[n_ + 1].clone() - &(self.a2.clone() * &self.u[n_ - 1]);
            return self.one.clone() + &v + &self.power[n_];
        }
        self.excess.clone() * &(self.sum[n_].clone() + &(self.a2.clone() * &self.weighted[n_ - 1]))
    }
}
