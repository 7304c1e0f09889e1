//! Which of three things is near a touch in region 2 with γ > 0, by λ₁ = e^−2πa: above 2/3 chaos that
//! attracts at every small depth; between 1/4 and 2/3 windows, each with a stable orbit, and gaps between
//! them; below 1/4 windows that overlap.

use std::f64::consts::{SQRT_2, TAU};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::{AttractorProblem, constants::Rates};
use crate::{
    chaos::{profile::Profile, span::Span},
    number::{Ball, Elementary, Precision, Real},
};

/// What is near a touch of an overdamped oscillator, to leading order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Case {
    /// λ₁ > 2/3.
    Chaos,
    /// 1/4 < λ₁ < 2/3.
    Windows,
    /// λ₁ < 1/4.
    Overlap,
}

/// Depths at which, to leading order, the orbit of one impact in n periods is stable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    /// n.
    pub periods: u64,
    /// Where it flips, and where it touches the stop once more.
    pub depths: [f64; 2],
}

/// Of the enclosure.
const BITS: u32 = 128;
/// The first window that is told is below this depth.
const SMALL: f64 = 0.02;
/// How many are told.
const TOLD: usize = 3;

/// Between which λ₁ is for all c and k of their ranges; none where the oscillator may not be overdamped.
pub fn eigenvalue([damping, stiffness, _]: &[[BigRational; 2]; 3]) -> Option<[BigRational; 2]> {
    let precision = Precision::new(BITS);
    let ball = |x: &BigRational| Ball::ratio(x, &precision);
    // The slower rate falls as c grows and as k falls.
    let end = |c: &BigRational, k: &BigRational| {
        let four = BigRational::from_integer(4.into());
        let square = c * c - four * k;
        if square <= BigRational::from_integer(0.into()) {
            return None;
        }
        let slow = ball(k) / &(ball(c) + &ball(&square).sqrt());
        let two = Ball::integer(2, &precision);
        let turn = Ball::pi(&precision) * &two;
        (-(slow * &two * &turn)).exp(&precision).exact_bounds()
    };
    let ([c0, c1], [k0, k1]) = (damping, stiffness);
    Some([end(c0, k1)?.0, end(c1, k0)?.1])
}

/// Which case it is, where that is certain.
pub fn case([least, greatest]: &[BigRational; 2]) -> Option<Case> {
    let ratio = |p: i64, q: i64| BigRational::new(BigInt::from(p), BigInt::from(q));
    let (quarter, thirds) = (ratio(1, 4), ratio(2, 3));
    if *least > thirds {
        Some(Case::Chaos)
    } else if *greatest < thirds && *least > quarter {
        Some(Case::Windows)
    } else if *greatest < quarter {
        Some(Case::Overlap)
    } else {
        None
    }
}

/// The next windows, the deepest first, for the middles of all ranges.
pub fn windows(problem: &AttractorProblem) -> Vec<Window> {
    let float = |x: &BigRational| x.to_f64().unwrap_or(f64::NAN);
    let middle = problem.ranges.each_ref().map(|[lo, hi]| [0.5 * (float(lo) + float(hi)); 2]);
    let Some(rates) = Rates::of(middle) else { return Vec::new() };
    let bend = Profile::new(&problem.harmonics).at(Span::point(0.0)).bend.middle();
    let [slow, fast] = [rates.slow[0], rates.fast[0]].map(|rate| (-rate * TAU).exp());
    // CAB/(λ₁ − λ₂), for E₁₂ = (λ₁ − λ₂)/D.
    let size = SQRT_2 * bend.sqrt() * (1.0 + rates.tau[0]) / rates.apart;
    let window = |n: i32| {
        let [p, q] = [slow.powi(n), fast.powi(n)];
        let depth = |c: f64| {
            let beta = c * (1.0 - p) * (1.0 - q) / ((p - q) * (1.0 - c).sqrt());
            (size / beta).powi(2)
        };
        let touches = (p - q) / (p / slow - q / fast + (slow * fast).powi(n - 1) * (slow - fast));
        let flip = 2.0 * (1.0 + p) * (1.0 + q) / ((1.0 - p) * (1.0 - q));
        let flip = flip / (1.0 + flip);
        (touches < flip).then(|| Window { periods: n as u64, depths: [depth(flip), depth(touches)] })
    };
    let told = (2..1000).filter_map(window).filter(|window| window.depths[1] < SMALL);
    told.take(TOLD).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::parse_rational;

    fn ranges(c: &str, k: &str) -> [[BigRational; 2]; 3] {
        [c, k, "4/5"].map(|x| [0, 1].map(|_| parse_rational(x).unwrap()))
    }

    #[test]
    fn the_case_is_certain_or_none() {
        for (c, k, near, expected) in [
            ("3/8", "1/64", 0.740_821_8, Some(Case::Chaos)),
            ("3/5", "1/25", 0.618_788, Some(Case::Windows)),
            ("2", "3/5", 0.099, Some(Case::Overlap)),
        ] {
            let [lo, hi] = eigenvalue(&ranges(c, k)).unwrap();
            let (low, high) = (lo.to_f64().unwrap(), hi.to_f64().unwrap());
            assert!((low - near).abs() < 2e-3 && (high - low).abs() < 1e-15, "{low} {high}");
            assert_eq!(case(&[lo, hi]), expected);
        }
        let about = |x: &str| parse_rational(x).unwrap();
        assert_eq!(case(&[about("0.66"), about("0.67")]), None);
        assert_eq!(case(&[about("0.249"), about("0.25")]), None);
        assert_eq!(eigenvalue(&ranges("1/4", "1/64")), None);
    }

    /// Each is about λ₁² of the one before; the orbit is stable inside, and λ₁ > 2/3 has none.
    #[test]
    fn windows_scale_with_the_square() {
        let problem = |c: &str, k: &str| AttractorProblem {
            ranges: ranges(c, k),
            harmonics: vec![(1, ["1", "0"].map(|x| [0, 1].map(|_| parse_rational(x).unwrap())))],
            deepest: 1.0,
        };
        let found = windows(&problem("3/5", "1/25"));
        assert_eq!(found.len(), 3);
        for two in found.windows(2) {
            let ratio = two[1].depths[0] / two[0].depths[0];
            assert!((ratio / 0.618_788f64.powi(2) - 1.0).abs() < 0.05, "{ratio}");
            // The next one begins below where this one ends.
            assert!(two[0].depths[0] < two[0].depths[1] && two[1].depths[1] < two[0].depths[0], "{two:?}");
        }
        assert!(windows(&problem("3/8", "1/64")).is_empty());
    }
}
