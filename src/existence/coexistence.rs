//! How many periods coexist at a random s on r = 1, among those up to N: the distribution, by exact cells.
//!
//! Between two neighbours of the Farey sequence F_N the path of the Stern–Brocot tree to s has the same nodes
//! of denominator up to N. These are the periods up to N that exist in one case or another: for eµ > 0 the
//! denominators on the path without the 1/k with 2ks < 1, and for eµ < 0 those k, with 1. A cell between p/q
//! and p′/q′ has the length 1/(q q′).
//!
//! The number has a limit law. With c = (12/π²) ln N, C_N/c − ln c + γ tends in distribution to the standard
//! Landau law (γ is Euler's constant): the sum of partial quotients is attracted to a stable law of exponent
//! 1 (Heinrich 1987).

use num_bigint::BigUint;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::{
    error::{Error, Result},
    monitor::Monitor,
};

/// The largest N: F_N has 6·10⁷ cells in (0, ½) then.
pub const MAX_COEXISTENCE: u64 = 20_000;

/// Bits of a probability.
const BITS: u32 = 100;

/// The probabilities of the numbers of periods.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Coexistence {
    order: u64,
    /// For each number of periods: the sum of the lengths of its cells, each rounded down, and how many.
    classes: Vec<(u128, u64)>,
}

/// Which periods are counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coexisting {
    /// Those that exist in one case or another.
    InSomeCase,
    /// Those that exist for eµ > 0.
    Positive,
}

impl Coexistence {
    /// The distribution of the number of periods from 1 to `order`. Cost: O(N²), 0.15 N² cells; memory O(N).
    ///
    /// # Errors
    /// An input error unless 2 ≤ `order` ≤ [`MAX_COEXISTENCE`]; the monitor's interruption.
    pub fn new(order: u64, counted: Coexisting, monitor: &dyn Monitor) -> Result<Coexistence> {
        if !(2..=MAX_COEXISTENCE).contains(&order) {
            return Err(Error::input(format!(
                "periods that coexist are counted up to N from 2 to {MAX_COEXISTENCE}, not to {order}"
            )));
        }
        let mut found = Coexistence { order, classes: vec![(0, 0); order as usize + 1] };
        // Cells from left to right: the denominator of the left end; numerator and denominator of the right
        // one; nodes on the path, 0/1 and 1/2 being the first.
        let mut cells = vec![(1u64, (1u64, 2u64), 2u64)];
        let mut done = 0u64;
        while let Some((q, (p, right), nodes)) = cells.pop() {
            if q + right <= order {
                // The left end of the right half; its numerator is not needed.
                cells.push((q + right, (p, right), nodes + 1));
                // Right ends of the leftmost cells are 1/k; elsewhere p′ + p by the determinant 1.
                let left_numerator = (p * q - 1) / right;
                cells.push((q, (p + left_numerator, q + right), nodes + 1));
                continue;
            }
            done += 1;
            if done.is_multiple_of(65_536) {
                monitor.advance(0)?;
            }
            match counted {
                Coexisting::InSomeCase => found.add(nodes, 1, u128::from(q) * u128::from(right)),
                // The cell (0, 1/N), where 1/(2k) for k > N/2 lies inside.
                Coexisting::Positive if q == 1 && right == order => found.first(),
                // 2ks < 1 on the cell iff its right end is at most 1/(2k).
                Coexisting::Positive => {
                    let absent = (right / (2 * p)).saturating_sub(1);
                    found.add(nodes - absent, 1, u128::from(q) * u128::from(right));
                }
            }
        }
        Ok(found)
    }

    /// Adds a piece of length a/b of (0, ½).
    fn add(&mut self, periods: u64, a: u128, b: u128) {
        let class = &mut self.classes[periods as usize];
        class.0 += ((2 * a) << BITS) / b;
        class.1 += 1;
    }

    /// The cell (0, 1/N) for eµ > 0: of the periods up to N there are 1 and the k with 2ks > 1.
    fn first(&mut self) {
        let n = u128::from(self.order);
        self.add(1, 1, 2 * n);
        // Between 1/(2(j + 1)) and 1/(2j): those from j + 1 on.
        for j in self.order / 2..self.order {
            let (left, right) = (2 * u128::from(j + 1), (2 * u128::from(j)).max(n));
            if left > right {
                self.add(1 + self.order - j, left - right, left * right);
            }
        }
    }

    /// For each number of periods from 0 to N: bounds of its probability in units of 2⁻¹⁰⁰.
    pub fn bounds(&self) -> Vec<(u128, u128)> {
        self.classes.iter().map(|&(sum, cells)| (sum, sum + u128::from(cells))).collect()
    }

    /// For each number of periods from 0 to N its probability, rounded: to within 10⁻¹⁵.
    pub fn probabilities(&self) -> Vec<f64> {
        // Of at most 10⁸ cells each is rounded down by less than 2⁻¹⁰⁰.
        self.classes.iter().map(|&(sum, _)| sum as f64 / (1u128 << BITS) as f64).collect()
    }
}

/// How many periods up to `order` exist at one s on r = 1, s no fraction of a denominator up to 2N: the nodes
/// of the path, counted by partial quotients. Cost: a step of Euclid's algorithm for each.
///
/// # Errors
/// An input error unless 0 < s < ½.
pub fn coexisting(s: &BigRational, order: &BigUint, counted: Coexisting) -> Result<BigUint> {
    let (Some(mut p), Some(mut q)) = (s.numer().to_biguint(), s.denom().to_biguint()) else {
        return Err(Error::input(format!("s = {s} is outside 0 < s < 1/2")));
    };
    if p.is_zero() || &p * 2u32 >= q {
        return Err(Error::input(format!("s = {s} is outside 0 < s < 1/2")));
    }
    // The k from 2 on with 2ks < 1.
    let absent = match counted {
        Coexisting::InSomeCase => BigUint::zero(),
        Coexisting::Positive => (&q / (&p * 2u32)).min(order.clone()) - 1u32,
    };
    // Denominators of two convergents; between them and the next one lie a nodes.
    let (mut before, mut at) = (BigUint::zero(), BigUint::one());
    let mut nodes = BigUint::zero();
    while !p.is_zero() && *order >= before {
        let (a, rest) = q.div_rem(&p);
        nodes += a.clone().min((order - &before) / &at);
        let next = &before + &a * &at;
        (before, at) = (at, next);
        (q, p) = (p, rest);
    }
    Ok(nodes - absent)
}

/// Euler's constant.
const EULER: f64 = 0.577_215_664_901_532_9;

/// C_N/c − ln c + γ, c = (12/π²) ln N: what tends to the standard Landau law. `order` is N ≥ 3. Floating
/// point, for pictures.
pub fn landau_scaled(periods: f64, order: f64) -> f64 {
    let c = 12.0 / std::f64::consts::PI.powi(2) * order.ln();
    periods / c - c.ln() + EULER
}

/// The distribution function of the standard Landau law, characteristic function exp(−π|t|/2 − i t ln|t|):
///
/// ```text
/// F(x) = 1/2 + (1/π) ∫ exp(−πt/2) sin(t (x + ln t))/t dt   over t > 0
/// ```
///
/// Floating point, for pictures: within 10⁻⁸ for −10 ≤ x ≤ 1000. Cost: 20,000 sines.
pub fn landau(x: f64) -> f64 {
    // t = e^y, dt/t = dy: the integrand falls off doubly exponentially on the right, and as t on the left.
    let (from, to, steps) = (-28.0, 3.2, 20_000);
    let step = (to - from) / f64::from(steps);
    let value = |i: i32| {
        let y = from + step * f64::from(i);
        let t = y.exp();
        (-std::f64::consts::FRAC_PI_2 * t).exp() * (t * (x + y)).sin()
    };
    // Both ends are below 10⁻⁹: the trapezoidal rule.
    0.5 + (0..=steps).map(value).sum::<f64>() * step / std::f64::consts::PI
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The tail by another integral, 1 − F(x) = (1/π) ∫ exp(−u ln u − xu) sin(πu)/u du; the median from
    /// tables.
    #[test]
    fn the_landau_law_has_its_tail_and_median() {
        for x in [-2.0, -1.0, 0.0, 0.5, 1.355_780_420_990_4, 3.0, 7.0, 20.0] {
            let (steps, end) = (400_000, 60.0);
            let h = end / f64::from(steps);
            let term = |i: i32| {
                let u = (f64::from(i) + 0.5) * h;
                (-u * u.ln() - x * u).exp() * (std::f64::consts::PI * u).sin() / u
            };
            let tail = (0..steps).map(term).sum::<f64>() * h / std::f64::consts::PI;
            assert!((1.0 - tail - landau(x)).abs() < 1e-7, "{x}: {} {}", 1.0 - tail, landau(x));
        }
        assert!((landau(1.355_780_420_990_4) - 0.5).abs() < 1e-7);
        assert!(landau(-6.0).abs() < 1e-7);
    }
}
