//! One pass over n ≤ N at one point (r, s), in plain `f64` with proved error bounds: the record form and the
//! claim.
//!
//! Here u = 2⁻⁵³. The powers z_j ≈ λ^j come from z_{j+1} = fl(z_j λ̃). Cosine and sine of 2πs are floats
//! within 2u of the true value, and multiplying by r, exact, rounds by u relatively: |λ̃ − λ| ≤ √2 (2u + u/2)
//! r < 2⁻⁵¹ r. A complex product is off by at most 4u|z||λ̃|. So the error E_j of z_j, in units of r^j, grows
//! by at most E_j 2⁻⁵¹ + 2⁻⁵¹ + 4u(1 + E_j)(1 + 2⁻⁵¹) < 2⁻⁴⁹ a step, and E_j ≤ j 2⁻⁴⁹ r^j for j ≤ 4096, as
//! long as nothing underflows (r^j > 2⁻⁹⁰⁰ is tested).
//!
//! A comparison whose error bound leaves it open is `None`: the caller decides that period on the ladder.

use crate::{
    existence::Case,
    local::Polar,
    number::{Angle, Circular, FloatInterval, Real},
};
use num_rational::BigRational;

/// The largest N of a sweep.
pub(super) const LONGEST: usize = 4096;

/// Below this, 2⁻⁹⁰⁰, products could underflow.
const SMALLEST: f64 = f64::from_bits((1023 - 900) << 52);

/// What one period's sweep found: the cases by the record form and those claimed; `None` where a bound leaves
/// it open. Some(None): no orbit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Swept {
    pub defined: Option<Option<Case>>,
    pub claimed: Option<Option<Case>>,
}

/// n₊ for each m ≤ n/2 coprime to n, 0 for the others; row n starts at `starts[n]`.
#[derive(Debug, Clone)]
pub(super) struct Neighbours {
    starts: Vec<usize>,
    n_plus: Vec<u16>,
}

impl Neighbours {
    /// The table for n ≤ `last`, by brute force.
    pub(super) fn new(last: usize) -> Self {
        let (mut starts, mut n_plus) = (vec![0], Vec::new());
        for n in 0..=last {
            for m in 0..=n / 2 {
                n_plus.push((1..n).find(|j| n > 2 && m * j % n == 1).unwrap_or(0) as u16);
            }
            starts.push(n_plus.len());
        }
        Neighbours { starts, n_plus }
    }

    fn n_plus(&self, n: usize, m: usize) -> usize {
        usize::from(self.n_plus[self.starts[n] + m])
    }
}

/// The work space of a sweep, kept from point to point.
#[derive(Debug, Clone)]
pub struct Sweep {
    neighbours: Neighbours,
    /// Im z_j, and an upper bound of r^j.
    y: Vec<f64>,
    rho: Vec<f64>,
}

/// The bound j 2⁻⁴⁹ on |z_j − λ^j|/r^j, exact.
fn error(j: usize) -> f64 {
    j as f64 * (1.0 / (1u64 << 49) as f64)
}

impl Sweep {
    pub(super) fn new(last: usize) -> Self {
        assert!(last <= LONGEST);
        Sweep { neighbours: Neighbours::new(last), y: vec![0.0; last + 1], rho: vec![1.0; last + 1] }
    }

    /// Visits n = 3, …, last at the point r = `r`/2⁵³, s = `s`/2⁵⁴, 0 < r, s < 2⁵³, s odd (so that u_n ≠ 0
    /// for every n < 2⁵²).
    pub(super) fn run(&mut self, r: u64, s: u64, mut visit: impl FnMut(usize, Swept)) {
        const UNIT: f64 = 1.0 / (1u64 << 53) as f64;
        let last = self.y.len() - 1;
        let angle = Angle::new(&BigRational::new_raw(s.into(), (1u64 << 53).into()));
        let float = |x: FloatInterval| {
            // Neighbouring or equal floats of size ≤ 1, else the bound on λ̃ fails.
            assert!(x.hi() - x.lo() <= 2.0 * UNIT, "the sine of a dyadic angle is enclosed within 2u");
            x.lo()
        };
        let radius = r as f64 * UNIT;
        let (cosine, sine) = (float(FloatInterval::cos(&angle, &())), float(FloatInterval::sin(&angle, &())));
        let (a, b) = (radius * cosine, radius * sine);
        // One unit more than the rounding of a product takes off.
        let growth = radius * (1.0 + 4.0 * UNIT);
        let (mut x, mut y, mut rho) = (a, b, growth);
        (self.y[1], self.rho[1]) = (b, rho);
        let first = ratio(x, y, 1, rho);
        let (mut highest, mut lowest) = (first, first);
        for n in 2..=last {
            (x, y) = (x * a - y * b, x * b + y * a);
            rho *= growth;
            (self.y[n], self.rho[n]) = (y, rho);
            let here = ratio(x, y, n, rho);
            let certain = y.abs() > error(n) * rho && rho > SMALLEST;
            if n > 2 {
                let positive = y > 0.0;
                let record = if certain { Self::record(here, highest, lowest) } else { None };
                let defined = record.map(|record| match record {
                    Record::High => Some(Case::from_signs(positive, !positive)),
                    Record::Low => Some(Case::from_signs(!positive, !positive)),
                    Record::No => None,
                });
                visit(n, Swept { defined, claimed: if certain { self.claim(n, s, positive) } else { None } });
            }
            highest = (highest.0.max(here.0), highest.1.max(here.1));
            lowest = (lowest.0.min(here.0), lowest.1.min(here.1));
        }
    }

    /// Whether f_n is a record, from enclosures of it and of the greatest and least before it.
    fn record(here: (f64, f64), highest: (f64, f64), lowest: (f64, f64)) -> Option<Record> {
        if here.0 > highest.1 {
            Some(Record::High)
        } else if here.1 < lowest.0 {
            Some(Record::Low)
        } else if here.1 < highest.0 && here.0 > lowest.1 {
            Some(Record::No)
        } else {
            None
        }
    }

    /// The claim for period n ≥ 3: the half-cell in integers, then the sign of one b_{n,k}, which is that of
    /// u_n (Im λⁿ − Im λ^k − r^{2k} Im λ^{n−k}) by (59).
    fn claim(&self, n: usize, s: u64, u_positive: bool) -> Option<Option<Case>> {
        let half_turns = ((n as u128 * u128::from(s)) >> 53) as usize;
        let m = half_turns.div_ceil(2);
        if m == 0 {
            return Some(Some(Case::MinusPlus));
        }
        let n_plus = self.neighbours.n_plus(n, m);
        if n_plus == 0 {
            return Some(None);
        }
        let (k, case) =
            if half_turns % 2 == 1 { (n - n_plus, Case::PlusPlus) } else { (n_plus, Case::PlusMinus) };
        let (numerator, bound) = self.numerator(n, k);
        if numerator.abs() <= bound {
            return None;
        }
        Some(((numerator > 0.0) == u_positive).then_some(case))
    }

    /// Im λⁿ − Im λ^k − r^{2k} Im λ^{n−k}, and a bound on its error.
    ///
    /// Every term is at most r^k (1 + E). Errors in units of r^k: E_n + E_k + E_{n−k} = 2n 2⁻⁴⁹ from the
    /// powers, 12k·u from the square of the bound ρ_k, which exceeds r^k by at most 6k·u of it, and 6u from
    /// the sums: below 4n 2⁻⁴⁹.
    fn numerator(&self, n: usize, k: usize) -> (f64, f64) {
        let value = self.y[n] - self.y[k] - self.rho[k] * self.rho[k] * self.y[n - k];
        (value, error(4 * n) * self.rho[k])
    }
}

/// Enclosures of f_1, …, f_n, all times one positive number, as a sweep has them; `None` where its bounds do
/// not hold. Needs n ≤ [`LONGEST`]. Cost: two sines and O(n) operations.
///
/// r is no float here, but within 2u of one, relatively: |λ̃ − λ| ≤ (2u + 2√2 u + u/2) r < 2⁻⁵⁰·⁵ r, and E_j
/// grows by 2⁻⁵⁰·⁵ + 2⁻⁵¹ < 2⁻⁴⁹ a step, as before.
pub(crate) fn quotients(polar: &Polar, n: u64) -> Option<Vec<FloatInterval>> {
    const UNIT: f64 = 1.0 / (1u64 << 53) as f64;
    let angle = Angle::new(&(polar.s() + polar.s()));
    let float = |x: FloatInterval| (x.hi() - x.lo() <= 2.0 * UNIT).then(|| x.lo());
    let (cosine, sine) = (float(FloatInterval::cos(&angle, &()))?, float(FloatInterval::sin(&angle, &()))?);
    let radius = FloatInterval::ratio(polar.r(), &());
    if radius.hi() - radius.lo() > 2.0 * UNIT * radius.lo() {
        return None;
    }
    let (a, b) = (radius.lo() * cosine, radius.lo() * sine);
    let growth = radius.hi() * (1.0 + 4.0 * UNIT);
    let (mut x, mut y, mut rho) = (a, b, growth);
    let all = (1..=n as usize)
        .map(|j| {
            let (low, high) = ratio(x, y, j, rho);
            (x, y) = (x * a - y * b, x * b + y * a);
            rho *= growth;
            FloatInterval::from_bounds(low, high)
        })
        .collect();
    (rho > SMALLEST).then_some(all)
}

enum Record {
    High,
    Low,
    No,
}

/// An enclosure of Im λ^j/(1 − Re λ^j), a positive multiple of f_j, from z_j and ρ ≥ r^j.
///
/// t = y/d with d = fl(1 − x): y is off by e = E_j and d by e + 2u at most, called e'. If d ≥ 4e' the true
/// quotient is within (e + |t|e')/(d − e') ≤ 1.34 (e + |t|e')/d of y/d; the factor 2 and 2⁻⁵⁰|t| cover the
/// roundings of t, of the bound and of t ± bound.
fn ratio(x: f64, y: f64, j: usize, rho: f64) -> (f64, f64) {
    let e = error(j) * rho;
    let e1 = e + error(1);
    let d = 1.0 - x;
    if d < 4.0 * e1 {
        return (f64::NEG_INFINITY, f64::INFINITY);
    }
    let t = y / d;
    let bound = 2.0 * (e + t.abs() * e1) / d + t.abs() * (1.0 / (1u64 << 50) as f64);
    (t - bound, t + bound)
}

#[cfg(test)]
mod tests {
    use num_traits::{One, Signed};

    use super::*;
    use crate::{
        local::{Ladder, Point, Quantity},
        number::{Ball, Precision},
        random::Random,
    };

    const LAST: usize = 60;

    fn fraction(p: u64, bits: u32) -> BigRational {
        BigRational::new_raw(p.into(), (1u64 << bits).into())
    }

    fn exact(x: f64) -> BigRational {
        BigRational::from_float(x).unwrap()
    }

    /// λ^j for the sweep's point, from a sine of an exact angle: another route than products.
    fn power(r: u64, s: u64, j: usize, precision: &Precision) -> [BigRational; 2] {
        let angle = Angle::new(&fraction(s, 53)).times(j as u64);
        let modulus = num_traits::pow(fraction(r, 53), j);
        [Ball::cos(&angle, precision), Ball::sin(&angle, precision)].map(|x| {
            let (low, high) = x.exact_bounds().unwrap();
            (low + high) / BigRational::from_integer(2.into()) * &modulus
        })
    }

    fn points(random: &mut Random, count: usize) -> Vec<(u64, u64)> {
        // From r ≥ ½ on nothing underflows within n ≤ 60.
        (0..count).map(|_| (random.bits() >> 12 | 1 << 52 | 1, random.bits() >> 11 | 1)).collect()
    }

    /// Powers, numerators and quotients lie within their bounds, and not on the floats themselves.
    #[test]
    fn the_error_bounds_hold_and_are_needed() {
        let (precision, mut random) = (Precision::new(300), Random::of_unit(5, 0));
        let mut sweep = Sweep::new(LAST);
        let mut off = 0;
        for (r, s) in points(&mut random, 12) {
            sweep.run(r, s, |_, _| {});
            let powers: Vec<_> = (0..=LAST).map(|j| power(r, s, j, &precision)).collect();
            for (j, power) in powers.iter().enumerate().skip(1) {
                let bound = exact(error(j)) * exact(sweep.rho[j]);
                assert!((exact(sweep.y[j]) - &power[1]).abs() <= bound, "Im λ^{j}");
                assert!(exact(sweep.rho[j]) >= num_traits::pow(fraction(r, 53), j));
                off += usize::from(exact(sweep.y[j]) != power[1]);
                // From a power as far off as it may be.
                let shift = error(j) * sweep.rho[j] * 0.9;
                let [x, y] = power.each_ref().map(|x| num_traits::ToPrimitive::to_f64(x).unwrap());
                for (dx, dy) in [(shift, shift), (shift, -shift), (-shift, shift), (-shift, -shift)] {
                    let (low, high) = ratio(x + dx, y + dy, j, sweep.rho[j]);
                    let true_value = &power[1] / (BigRational::one() - &power[0]);
                    assert!(
                        low == f64::NEG_INFINITY || exact(low) <= true_value && true_value <= exact(high)
                    );
                }
            }
            let polar = Polar::new(fraction(r, 53), fraction(s, 54)).unwrap();
            for (power, found) in powers[1..].iter().zip(quotients(&polar, LAST as u64).unwrap()) {
                assert!(found.contains(&(&power[1] / (BigRational::one() - &power[0]))));
            }
            for n in 3..=LAST {
                for k in [1, n / 2, n - 1] {
                    let weight = num_traits::pow(fraction(r, 53), 2 * k);
                    let true_value = &powers[n][1] - &powers[k][1] - weight * &powers[n - k][1];
                    let (value, bound) = sweep.numerator(n, k);
                    assert!((exact(value) - &true_value).abs() <= exact(bound), "n = {n}, k = {k}");
                    off += usize::from(exact(value) != true_value);
                }
            }
        }
        assert!(off > 1000, "{off}");
    }

    /// On either side of a zero of the deciding b, and next to one of u_n, nothing is decided by floats.
    #[test]
    fn near_zeros_are_left_open() {
        let ladder = Ladder::default();
        let (mut random, mut sweep) = (Random::of_unit(6, 0), Sweep::new(12));
        let mut found = 0;
        for (_, s) in points(&mut random, 60) {
            for n in 3..=12 {
                let half_turns = ((n as u128 * u128::from(s)) >> 53) as usize;
                let k = match sweep.neighbours.n_plus(n, half_turns.div_ceil(2).min(n / 2)) {
                    _ if half_turns == 0 => continue,
                    0 => continue,
                    n_plus if half_turns % 2 == 1 => n - n_plus,
                    n_plus => n_plus,
                };
                let sign = |r: u64| {
                    let point = Point::Polar(Polar::new(fraction(r, 53), fraction(s, 54)).unwrap());
                    ladder.sign(&point, Quantity::B { n: n as u64, k: k as u64 }).answer
                };
                let (mut low, mut high) = (1u64 << 51, (1 << 53) - 1);
                if sign(low) == sign(high) {
                    continue;
                }
                while high - low > 1 {
                    let middle = (low + high) / 2;
                    if sign(middle) == sign(low) { low = middle } else { high = middle }
                }
                for r in [low, high] {
                    sweep.run(r, s, |at, swept| {
                        assert!(at != n || swept.claimed.is_none(), "n = {n}, k = {k}: {swept:?}");
                    });
                    found += 1;
                }
            }
        }
        assert!(found > 20, "{found}");
        // 2ns within 2⁻⁵⁰ of an integer.
        for n in [3u64, 4, 5, 8, 12] {
            for m in 1..n.div_ceil(2) {
                let s = ((m << 54) / (2 * n)) | 1;
                sweep.run((1 << 53) - 1, s, |at, swept| {
                    let open = swept.defined.is_none() && swept.claimed.is_none();
                    assert!(at as u64 != n || open, "n = {n}, m = {m}: {swept:?}");
                });
            }
        }
    }
}
