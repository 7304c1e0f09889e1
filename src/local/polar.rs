//! b_{n,k} and c_n from (r, s), with exact arguments and forms that keep their digits.
//!
//! Write σ_j = sin πjs, κ_j = cos πjs, h_j = 1 − r^j, p_j = 1 + r^j, j = n − k. Since
//! 1 − λ^j = e^{iπjs}(h_j κ_j − i p_j σ_j) for λ = r e^{2πis}, the numerator
//! M = −Im (1 − λ^{n−k})(1 − conj λ^k) λ^k / r^k of (62) is
//!
//! ```text
//! M = −(σ_n X + κ_n Y),   X = h_j h_k κ_j κ_k + p_j p_k σ_j σ_k,   Y = h_j κ_j p_k σ_k − p_j σ_j h_k κ_k
//! M = r^j sin 2πns − sin 2πks − rⁿ sin 2πjs
//! b_{n,k} = M / (2 r^j σ_n κ_n),   c_n = −sin 2πs (h_n² + 4 rⁿ σ_n²) / (2 r^{n−1} σ_n κ_n)
//! ```
//!
//! The first form of M is the folded one, the second the direct one. At r = 1 the folded form is (B1), b = −2
//! σ_j σ_k / κ_n, and c_n is (B2). It keeps its digits near poles, near single and double zeros and as r → 1;
//! the direct form does for small r. c_n is a product of sums of positive terms.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use crate::error::{Error, Result};
use crate::number::{Angle, Circular, Real, Sign};

/// A point of region 3 with 0 < r ≤ 1, 0 < s < ½: eigenvalues r·e^{±2πis}.
#[derive(Debug, Clone)]
pub struct Polar {
    r: BigRational,
    s: BigRational,
    /// 1 − r.
    rest: BigRational,
    /// r ≥ ½.
    large: bool,
    circle: bool,
    /// −log₂(1 − r) within 1; 0 if that is negative.
    gap: u64,
    /// πs and 2πs.
    half: Angle,
    full: Angle,
}

/// r^j and h_j = 1 − r^j, each to full relative accuracy.
#[derive(Clone)]
struct Power<T> {
    power: T,
    rest: T,
}

impl Polar {
    /// The point (r, s).
    ///
    /// # Errors
    /// An input error unless 0 < r ≤ 1 and 0 < s < ½.
    pub fn new(r: BigRational, s: BigRational) -> Result<Polar> {
        if !r.is_positive() || r > BigRational::one() {
            return Err(Error::input(format!("r = {r} is outside 0 < r ≤ 1")));
        }
        if !s.is_positive() || s >= BigRational::new(1.into(), 2.into()) {
            return Err(Error::input(format!(
                "s = {s} is outside 0 < s < 1/2 (give a point with real eigenvalues by a1, a2)"
            )));
        }
        let (half, full) = (Angle::new(&s), Angle::new(&(&s * BigInt::from(2))));
        let rest = BigRational::one() - &r;
        let large = rest <= r;
        let circle = r.is_one();
        let gap = rest.denom().bits().saturating_sub(rest.numer().bits());
        Ok(Polar { r, s, rest, large, circle, gap, half, full })
    }

    /// r.
    pub fn r(&self) -> &BigRational {
        &self.r
    }

    /// s.
    pub fn s(&self) -> &BigRational {
        &self.s
    }

    /// Whether r = 1, where every sign is decided in integers.
    pub fn on_circle(&self) -> bool {
        self.circle
    }

    /// Whether u_n = 0: exactly where 2ns is an integer.
    pub fn is_singular(&self, n: u64) -> bool {
        self.half.times(n).is_on_axis()
    }

    /// The sign of u_n, which is that of sin 2πns: exact.
    pub fn u_sign(&self, n: u64) -> Sign {
        self.full.times(n).sin_sign()
    }

    /// The sign of c_n, exact: opposite to that of sin 2πns. Needs u_n ≠ 0.
    pub(super) fn c_sign(&self, n: u64) -> Sign {
        -self.u_sign(n)
    }

    /// The sign of b_{n,k} on r = 1, exact, by (B1). Needs u_n ≠ 0.
    pub(super) fn b_sign_on_circle(&self, n: u64, k: u64) -> Sign {
        let sine = |j| self.half.times(j).sin_sign();
        -(sine(k) * sine(n - k) * self.half.times(n).complement().sin_sign())
    }

    /// b_{n,k}, 1 ≤ k < n; `None` where u_n = 0.
    ///
    /// Digits lost: O(log n) beyond those of rⁿ itself, |n ln r| u, and two where terms of both signs meet:
    /// at a zero of b_{n,k} off its double zeros, as many as its condition number says, and within ε of a
    /// double zero s = m/g for ε ≪ 1 − r, log₂ 1/(n(1 − r)). A ball loses none of these where the direct form
    /// by twice its length keeps its digits. Cost: up to six sines and O(log n) products, for a ball mostly
    /// three; on r = 1 three sines, or two.
    pub fn b<T: Circular>(&self, n: u64, k: u64, context: &T::Context) -> Option<T> {
        let j = n - k;
        let at_n = self.half.times(n);
        if at_n.is_on_axis() {
            return None;
        }
        if self.on_circle() {
            let angles = [&self.half.times(j), &self.half.times(k)];
            return Some(T::sines_over_cosine(angles, &at_n, context));
        }
        Some(
            T::polar_quotient((&self.r, &self.s), [n, k], context)
                .unwrap_or_else(|| self.quotient(n, k, context)),
        )
    }

    /// b_{n,k} for r < 1 and u_n ≠ 0, by the forms that cancel least.
    pub(super) fn quotient<T: Circular>(&self, n: u64, k: u64, context: &T::Context) -> T {
        let at_n = self.half.times(n);
        let (sine, cosine) = (T::sin(&at_n, context), T::cos(&at_n, context));
        let denominator = T::integer(2, context) * &sine * &cosine * &self.power(n - k, context).power;
        self.numerator::<T>(n, k, context) / &denominator
    }

    /// c_n, n ≥ 1; `None` where u_n = 0. Digits lost: O(log n) beyond those of rⁿ. Cost: three sines and
    /// O(log n) products.
    pub fn c<T: Circular>(&self, n: u64, context: &T::Context) -> Option<T> {
        if self.is_singular(n) {
            return None;
        }
        let (sine, cosine) = (T::sin(&self.half.times(n), context), T::cos(&self.half.times(n), context));
        let first = T::sin(&self.full, context);
        if self.on_circle() {
            return Some(T::integer(-2, context) * &first * &sine / &cosine);
        }
        let Power { power, rest } = self.power::<T>(n, context);
        let square = rest.clone() * &rest + &(T::integer(4, context) * &power * &sine * &sine);
        let denominator = T::integer(-2, context) * &self.power::<T>(n - 1, context).power * &sine * &cosine;
        Some(first * &square / &denominator)
    }

    /// b_{n,1}, …, b_{n,n−1}; `None` where u_n = 0.
    ///
    /// Cost: O(n) products; the sines come from a recurrence in k where the rung has one.
    pub fn b_all<T: Circular>(&self, n: u64, context: &T::Context) -> Option<Vec<T>> {
        if self.is_singular(n) {
            return None;
        }
        let sines = T::sines(&self.half, n, context);
        let sine = |j: u64| &sines[j as usize];
        if self.on_circle() {
            let factor = T::integer(-2, context) / &T::cos(&self.half.times(n), context);
            // b_{n,k} = b_{n,n−k} on r = 1.
            let mut values: Vec<T> = (1..=n / 2).map(|k| factor.clone() * sine(k) * sine(n - k)).collect();
            values.extend((n / 2 + 1..n).map(|k| values[(n - k) as usize - 1].clone()).collect::<Vec<_>>());
            return Some(values);
        }
        let cosines = T::cosines(&self.half, n, context);
        let cosine = |j: u64| &cosines[j as usize];
        let powers = self.powers::<T>(n, context);
        let double = T::integer(2, context) * sine(n) * cosine(n);
        let double_sines: Vec<T> = (0..=n).map(|j| T::integer(2, context) * sine(j) * cosine(j)).collect();
        Some(
            (1..n)
                .map(|k| {
                    let j = n - k;
                    let power = |i: u64| &powers[i as usize];
                    let folded = folded(
                        [sine(n), sine(j), sine(k)],
                        [cosine(n), cosine(j), cosine(k)],
                        power(j),
                        power(k),
                        context,
                    );
                    let direct = direct([n, j, k].map(|i| &double_sines[i as usize]), power(n), power(j));
                    self.choose(folded, direct) / &(double.clone() * &power(j).power)
                })
                .collect(),
        )
    }

    /// M: a positive multiple of u_n b_{n,k}. Needs r < 1.
    pub(super) fn numerator<T: Circular>(&self, n: u64, k: u64, context: &T::Context) -> T {
        let power = self.three_powers::<T>(n, k, context);
        let direct = self.direct_at(n, k, &power, context);
        self.choose(self.folded_at(n, k, &power, context), direct)
    }

    /// The sign of M, of its direct form alone where that is enough: three sines in place of nine. Needs r <
    /// 1.
    ///
    /// The folded form tells more only near r = 1: where n(1 − r) is not small, the direct one loses no bits
    /// but those of the condition number and a few. The rung that has its own way to the direct form has 32
    /// bits more for these.
    pub(super) fn numerator_sign<T: Circular>(&self, n: u64, k: u64, context: &T::Context) -> Option<Sign> {
        match T::polar_sign((&self.r, &self.s), [n, k], context) {
            Some(None) if !self.near_circle(n) => return None,
            Some(sign @ Some(_)) => return sign,
            _ => {}
        }
        let power = self.three_powers::<T>(n, k, context);
        let direct = self.direct_at(n, k, &power, context);
        let sign = if T::CERTAIN { direct.sign() } else { None };
        sign.or_else(|| self.choose(self.folded_at(n, k, &power, context), direct).sign())
    }

    /// Whether n(1 − r) is below 2⁻⁸, but for a factor of 4.
    fn near_circle(&self, n: u64) -> bool {
        self.gap > 8 + u64::from(n.ilog2())
    }

    /// r^i and 1 − r^i for i = n, j, k.
    fn three_powers<T: Real>(&self, n: u64, k: u64, context: &T::Context) -> [Power<T>; 3] {
        [n, n - k, k].map(|i| self.power(i, context))
    }

    fn direct_at<T: Circular>(&self, n: u64, k: u64, power: &[Power<T>; 3], context: &T::Context) -> T {
        let sines = [n, n - k, k].map(|i| T::sin(&self.full.times(i), context));
        direct(sines.each_ref(), &power[0], &power[1])
    }

    fn folded_at<T: Circular>(&self, n: u64, k: u64, power: &[Power<T>; 3], context: &T::Context) -> T {
        let sines = [n, n - k, k].map(|i| T::sin(&self.half.times(i), context));
        let cosines = [n, n - k, k].map(|i| T::cos(&self.half.times(i), context));
        folded(sines.each_ref(), cosines.each_ref(), &power[1], &power[2], context)
    }

    /// The direct form of M alone, for the first pass of a sign: three sines. Needs r < 1.
    pub(super) fn direct_numerators<T: Circular>(&self, n: u64, context: &T::Context) -> Vec<T> {
        let sines = T::sines(&self.full, n, context);
        let powers = self.powers::<T>(n, context);
        let at = |i: u64| &sines[i as usize];
        (1..n)
            .map(|k| direct([at(n), at(n - k), at(k)], &powers[n as usize], &powers[(n - k) as usize]))
            .collect()
    }

    /// The folded form of M alone, for the second pass of a sign: two sines for each k. Needs r < 1.
    pub(super) fn folded_numerators<T: Circular>(&self, n: u64, context: &T::Context) -> Vec<T> {
        let (sines, cosines) = (T::sines(&self.half, n, context), T::cosines(&self.half, n, context));
        let powers = self.powers::<T>(n, context);
        let [sine, cosine] = [&sines, &cosines].map(|all| |i: u64| &all[i as usize]);
        (1..n)
            .map(|k| {
                let at = [n, n - k, k];
                let powers = [at[1], at[2]].map(|i| &powers[i as usize]);
                folded(at.map(sine), at.map(cosine), powers[0], powers[1], context)
            })
            .collect()
    }

    /// Im λ^j and 1 − Re λ^j over 2, for j = 1, …, n, as r^j σ_j κ_j and h_j/2 + r^j σ_j²: sums of positive
    /// terms. Cost: O(n) products, two sines for each j.
    pub(crate) fn terms<T: Circular>(&self, n: u64, context: &T::Context) -> Vec<(T, T)> {
        let (sines, cosines) = (T::sines(&self.half, n, context), T::cosines(&self.half, n, context));
        let half = T::integer(1, context) / &T::integer(2, context);
        let powers = self.powers::<T>(n, context);
        let all = powers.iter().zip(sines.iter().zip(&cosines)).skip(1);
        all.map(|(at, (sine, cosine))| {
            let swing = at.power.clone() * sine;
            (swing.clone() * cosine, at.rest.clone() * &half + &(swing * sine))
        })
        .collect()
    }

    /// The better of the two forms: the narrower enclosure, or, where there is none, the folded one for r ≥
    /// ½.
    fn choose<T: Circular>(&self, folded: T, direct: T) -> T {
        if self.large { folded.tighter(direct) } else { direct.tighter(folded) }
    }

    /// r^j and 1 − r^j by repeated squaring: O(log j) products.
    ///
    /// h_{2i} = h_i (1 + r^i) and h_{i+1} = h_i + r^i h_1 add positive terms; while h < ½, r^i = 1 − h_i
    /// keeps its digits better than a product does, so that errors do not double at every step as long as i(1
    /// − r) is small.
    fn power<T: Real>(&self, j: u64, context: &T::Context) -> Power<T> {
        let one = T::integer(1, context);
        let step = self.step::<T>(context);
        let mut total = Power { power: one.clone(), rest: T::integer(0, context) };
        for bit in (0..64 - j.leading_zeros()).rev() {
            let rest = total.rest * &(one.clone() + &total.power);
            total = settled(total.power.clone() * &total.power, rest, context);
            if j >> bit & 1 == 1 {
                total = total.next(&step, context);
            }
        }
        total
    }

    /// r^j, 1 − r^j for j = 0, 1, …, n, one step at a time.
    fn powers<T: Real>(&self, n: u64, context: &T::Context) -> Vec<Power<T>> {
        let step = self.step::<T>(context);
        let first = Power { power: T::integer(1, context), rest: T::integer(0, context) };
        std::iter::successors(Some(first), |last| Some(last.next(&step, context)))
            .take(n as usize + 1)
            .collect()
    }

    fn step<T: Real>(&self, context: &T::Context) -> Power<T> {
        Power { power: T::ratio(&self.r, context), rest: T::ratio(&self.rest, context) }
    }
}

impl<T: Real> Power<T> {
    fn next(&self, step: &Power<T>, context: &T::Context) -> Power<T> {
        let rest = self.power.clone() * &step.rest + &self.rest;
        settled(self.power.clone() * &step.power, rest, context)
    }
}

/// r^i from the product, or from 1 − h_i while h_i < ½.
fn settled<T: Real>(product: T, rest: T, context: &T::Context) -> Power<T> {
    let double = rest.clone() + &rest;
    let small = (double - &T::integer(1, context)).sign() == Some(Sign::Negative);
    Power { power: if small { T::integer(1, context) - &rest } else { product }, rest }
}

/// M from sin 2πns, sin 2πjs, sin 2πks.
fn direct<T: Real>([n, j, k]: [&T; 3], power_n: &Power<T>, power_j: &Power<T>) -> T {
    power_j.power.clone() * n - k - &(power_n.power.clone() * j)
}

/// M from σ and κ at n, j, k.
fn folded<T: Real>(
    sines: [&T; 3],
    cosines: [&T; 3],
    power_j: &Power<T>,
    power_k: &Power<T>,
    context: &T::Context,
) -> T {
    let one = T::integer(1, context);
    let falling = |power: &Power<T>, i: usize| power.rest.clone() * cosines[i];
    let rising = |power: &Power<T>, i: usize| (one.clone() + &power.power) * sines[i];
    let (hj, hk, pj, pk) = (falling(power_j, 1), falling(power_k, 2), rising(power_j, 1), rising(power_k, 2));
    let x = hj.clone() * &hk + &(pj.clone() * &pk);
    let y = hj * &pk - &(pj * &hk);
    -(x * sines[0] + &(y * cosines[0]))
}
