//! One pass over n ≤ N at one point (r, s), in plain `f64` with proved error bounds: the record form and the claim.
//!
//! Here u = 2⁻⁵³. The powers z_j ≈ λ^j come from z_{j+1} = fl(z_j λ̃). Cosine and sine of 2πs are floats within 2u of the
//! true value, and multiplying by r, exact, rounds by u relatively: |λ̃ − λ| ≤ √2 (2u + u/2) r < 2⁻⁵¹ r. A complex product is off
//! by at most 4u|z||λ̃|. So the error E_j of z_j, in units of r^j, grows by at most E_j 2⁻⁵¹ + 2⁻⁵¹ + 4u(1 + E_j)(1 + 2⁻⁵¹) <
//! 2⁻⁴⁹ a step, and E_j ≤ j 2⁻⁴⁹ r^j for j ≤ 4096, as long as nothing underflows (r^j > 2⁻⁹⁰⁰ is tested).
//!
//! A comparison whose error bound leaves it open is `None`: the caller decides that period on the ladder.

use crate::{
    existence::Case,
    number::{Angle, Circular, FloatInterval},
};
use num_rational::BigRational;

/// The largest N of a sweep.
pub(super) const LONGEST: usize = 4096;

/// Below this, 2⁻⁹⁰⁰, products could underflow.
const SMALLEST: f64 = f64::from_bits((1023 - 900) << 52);

/// What one period's sweep found: the cases by the record form and those claimed; `None` where a bound leaves it open.
/// Some(None): no orbit.
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
    pub fn new(last: usize) -> Self {
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
pub(super) struct Sweep {
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
    pub fn new(last: usize) -> Self {
        assert!(last <= LONGEST);
        Sweep { neighbours: Neighbours::new(last), y: vec![0.0; last + 1], rho: vec![1.0; last + 1] }
    }

    /// Visits n = 3, …, last at the point r = `r`/2⁵³, s = `s`/2⁵⁴, 0 < r, s < 2⁵³, s odd (so that u_n ≠ 0 for
    /// every n < 2⁵²).
    pub fn run(&mut self, r: u64, s: u64, mut visit: impl FnMut(usize, Swept)) {
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
        let numerator = self.y[n] - self.y[k] - self.rho[k] * self.rho[k] * self.y[n - k];
        // Every term is at most r^k (1 + E). Errors in units of r^k: E_n + E_k + E_{n−k} = 2n 2⁻⁴⁹ from the powers, 12k·u
        // from the square of the bound ρ_k, which exceeds r^k by at most 6k·u of it, and 6u from the sums: below 4n 2⁻⁴⁹.
        if numerator.abs() <= error(4 * n) * self.rho[k] {
            return None;
        }
        Some(((numerator > 0.0) == u_positive).then_some(case))
    }
}

enum Record {
    High,
    Low,
    No,
}

/// An enclosure of Im λ^j/(1 − Re λ^j), a positive multiple of f_j, from z_j and ρ ≥ r^j.
///
/// t = y/d with d = fl(1 − x): y is off by e = E_j and d by e + 2u at most, called e'. If d ≥ 4e' the true quotient is within
/// (e + |t|e')/(d − e') ≤ 1.34 (e + |t|e')/d of y/d; the factor 2 and 2⁻⁵⁰|t| cover the roundings of t, of the bound and of
/// t ± bound.
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
