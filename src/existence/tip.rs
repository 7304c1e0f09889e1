//! The lowest point of an area: below which r, and so which determinant a₂ = r², the orbit cannot exist.
//!
//! The minimum of R is certified without assuming that R has only one. A guess (r*, e*) from Newton's method
//! for h = ∂h/∂e = 0 is surrounded by r₋ < r* < r₊ and e₋ < e* < e₊ such that
//!
//! - h(r₊, e*) > 0, so min R < r₊;
//! - h(r₋, e) < 0 for all e in [e₋, e₊], so R > r₋ there;
//! - h(r₊, e) < 0 for all other e in [0, 1/j], so R > r₊ there: every lowest point has e₋ < e < e₊.
//!
//! The second and third speak of R because h increases with r: for 0 ≤ e ≤ 1/j its powers have coefficients
//! ≥ 0. "For all e" is shown on pieces [a, b] with h(a), h(b) < 0: either max(h(a), h(b)) + (b − a)²/8 ·
//! sup(−∂²h/∂e²) < 0, or h is concave on the piece and falls at a or rises at b, so that it is greatest at an
//! end. ∂²h/∂e² is bounded by the monotonicity of sine on either side of π/2.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::boundary::{Boundary, Enclosure, Section, Sines, bits, float, middle, power, unit};
use crate::number::{Ball, Circular, Precision, Real, Sign};

/// The infimum of r over an area, regions 3 and 4 together. No area attains it: areas are open.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Lowest {
    /// 0, near every s with `left` < s < `right`: on all of the interval (m = 0) or up to s = 1/(2(n − 1)),
    /// where h(0) changes its sign (m = 1, ns < 1).
    Zero {
        /// The left end.
        left: BigRational,
        /// The right end.
        right: BigRational,
    },
    /// 0, in region 4: n odd, the leftmost area, which for a₂ → 0 shrinks to the point a₁ = −1.
    Region4,
    /// The minimum of R over the interval.
    Tip(Tip),
}

/// A certified minimum of R.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Tip {
    /// Contains min R.
    pub r: Enclosure,
    /// Contains every s at which R is least.
    pub s: Enclosure,
}

impl Boundary {
    /// The lowest point of the area, min R no wider than 10^−`digits`.
    ///
    /// `None` if it could not be certified (this has not been met). Cost: O(`digits`) pieces, three sines
    /// each, at 4·`digits` + O(log n) bits.
    ///
    /// ```
    /// use grazing::existence::{Boundary, Lowest, intervals};
    /// use grazing::number::parse_rational;
    /// // Period 4 on (1/4, 1/3), in the case (+,−): there is no orbit below r = 0.866….
    /// let interval = intervals(4)?.nth(2).expect("there are three");
    /// let Some(Lowest::Tip(tip)) = Boundary::new(interval).lowest(12) else { panic!("it has a tip") };
    /// assert!(tip.r.lower > parse_rational("0.866")? && tip.r.upper < parse_rational("0.867")?);
    /// # Ok::<(), grazing::Error>(())
    /// ```
    pub fn lowest(&self, digits: u32) -> Option<Lowest> {
        let interval = self.interval();
        let fraction = |p: u64, q: u64| BigRational::new(p.into(), q.into());
        let [left, right] = [&interval.left, &interval.right].map(|x| fraction(*x.numer(), *x.denom()));
        match self.j() {
            None => Some(Lowest::Zero { left, right }),
            Some(1) => Some(Lowest::Zero { left, right: fraction(1, 2 * (interval.n - 1)) }),
            Some(2) => Some(Lowest::Region4),
            Some(j) => {
                let precision = Precision::new(bits(interval.n, digits));
                let found = Search { n: interval.n, j, precision: &precision }.tip(digits)?;
                let (s, t) = (self.s_at(&found.1.lower), self.s_at(&found.1.upper));
                let (lower, upper) = if s < t { (s, t) } else { (t, s) };
                Some(Lowest::Tip(Tip { r: found.0, s: Enclosure { lower, upper } }))
            }
        }
    }
}

/// The large-n law of the tips, t = k/n for the deciding k: (1 − r_tip) n³ → G(t) and |n s_tip − m| n → D(t),
/// where
///
/// ```text
/// D = 1/(√(1 − t + t²) + 1 − 2t),   G = 2π² (D + (2t − 1) D² − t(1 − t) D³),   0 ≤ t < 1.
/// ```
///
/// Derived to second order and checked numerically, not proved (proofs/tips.md). Returns (D, G) in plain
/// floats.
///
/// ```
/// let (d, g) = grazing::existence::tip_law(0.5);
/// assert!((d - 2.0 / 3f64.sqrt()).abs() < 1e-15);
/// assert!((g - 8.0 * std::f64::consts::PI.powi(2) / (3.0 * 3f64.sqrt())).abs() < 1e-13);
/// ```
pub fn tip_law(t: f64) -> (f64, f64) {
    let d = 1.0 / ((1.0 - t + t * t).sqrt() + 1.0 - 2.0 * t);
    let cubic = d * (1.0 + d * ((2.0 * t - 1.0) - t * (1.0 - t) * d));
    (d, 2.0 * std::f64::consts::PI.powi(2) * cubic)
}

/// The next term of the law: (1 − r_tip) n³ = G + G₂/n² + O(1/n³). Derived formally, as G was
/// (proofs/tips.md).
pub fn tip_correction(t: f64) -> f64 {
    let (d, _) = tip_law(t);
    // A, B, M of proofs/tips.md.
    let mean = (1.0 - t * (1.0 - t) * d * d) / 2.0;
    let (a, b) = (mean + t * d, mean - (1.0 - t) * d);
    let spread = (1.0 - t) * a.powi(4) + t * b.powi(4) - (1.0 - mean).powi(4);
    4.0 / 3.0 * std::f64::consts::PI.powi(4) * (a.powi(4) - b.powi(4) - d * spread)
}

struct Search<'a> {
    n: u64,
    j: u64,
    precision: &'a Precision,
}

/// One e, its section and the three sines there.
#[derive(Clone)]
struct Place {
    e: BigRational,
    section: Section,
    sines: Sines<Ball>,
}

impl Search<'_> {
    fn place(&self, e: BigRational) -> Place {
        let section = Section::new(self.n, self.j, &e);
        let sines = section.sines(self.precision);
        Place { e, section, sines }
    }

    fn ratio(&self, p: u64, q: u64) -> Ball {
        Ball::ratio(&BigRational::new(p.into(), q.into()), self.precision)
    }

    /// r^j and rⁿ.
    fn powers(&self, r: &BigRational) -> [Ball; 2] {
        let r = Ball::ratio(r, self.precision);
        [self.j, self.n].map(|exponent| power(&r, exponent, self.precision))
    }

    /// Enclosures of min R and of the e where it is taken.
    fn tip(&self, digits: u32) -> Option<(Enclosure, Enclosure)> {
        // Even, so that the root of the unit is a power of ten too.
        let digits = (digits + 3) / 2 * 2;
        let (r, e) = self.guess(digits)?;
        let (below, above, around) = self.margins(&r, &e, digits)?;
        let (low, high) = (r.clone() - below, r + above);
        let (left, right) = (self.place(&e - &around), self.place(&e + &around));
        let (first, last) =
            (self.place(BigRational::zero()), self.place(BigRational::new(1.into(), self.j.into())));
        let at_tip = self.place(e);
        let inside = low.is_positive() && left.e.is_positive() && right.e < last.e;
        let certain = inside
            && at_tip.section.value(&at_tip.sines, &high, self.precision).sign() == Some(Sign::Positive)
            && self.is_negative(&high, &first, &left)
            && self.is_negative(&low, &left, &right)
            && self.is_negative(&high, &right, &last);
        let r = Enclosure { lower: low, upper: high };
        certain.then_some((r, Enclosure { lower: left.e, upper: right.e }))
    }

    /// A multiple of a power of ½ near x, finer than e needs to be known and yet short, which makes fractions
    /// cheap.
    fn place_near(&self, x: &BigRational, digits: u32) -> BigRational {
        let scale = BigInt::from(1) << (2 * digits + 2 * self.n.ilog2() + 16);
        BigRational::new((x * &scale).round().to_integer(), scale)
    }

    /// A solution of h = ∂h/∂e = 0, good to about 10^−`digits` in r and half as many digits in e.
    fn guess(&self, digits: u32) -> Option<(BigRational, BigRational)> {
        let n = self.n as f64;
        let (d, _) = tip_law((n - self.j as f64) / n);
        let mut e = BigRational::from_float(d / n)?;
        let mut r = Section::new(self.n, self.j, &e).guess();
        let pi = BigRational::from_float(std::f64::consts::PI)?;
        let enough = unit(digits / 2 + 2) / BigInt::from(self.n);
        for _ in 0..200 {
            let place = self.place(e.clone());
            for _ in 0..2 {
                r = place.section.newton(&place.sines, &r, self.precision)?;
            }
            let step = middle(&(self.first_derivative(&place, &r) / &self.second_derivative(&place, &r)))?
                / (&pi * BigInt::from(2));
            e = self.place_near(&(e - &step), digits);
            if step.abs() < enough {
                let place = self.place(e.clone());
                for _ in 0..2 {
                    r = place.section.newton(&place.sines, &r, self.precision)?;
                }
                return Some((r, e));
            }
        }
        None
    }

    /// How far to go below r, above r, and to either side of e.
    ///
    /// Near the tip h ≈ h_r (r − r*) − |h_ee| (e − e*)²/2. With u = 10^−`digits` and |h_ee| η²/2 = 2u h_r,
    /// h(r* + u, e* ± η) ≈ −u h_r < 0 and the chord bound of the inner piece at r* − 4u is about −4u h_r < 0.
    /// Only a choice: what follows is checked.
    fn margins(
        &self,
        r: &BigRational,
        e: &BigRational,
        digits: u32,
    ) -> Option<(BigRational, BigRational, BigRational)> {
        let place = self.place(e.clone());
        let slope = middle(&place.section.slope(&place.sines, r, self.precision))? / r;
        let bend = middle(&self.second_derivative(&place, r))?;
        let eta = (float(&slope) / float(&-bend)).sqrt() / std::f64::consts::PI;
        let u = unit(digits);
        let around = BigRational::from_float(eta)? * unit(digits / 2);
        Some((&u * BigInt::from(4), u, self.place_near(&around, digits)))
    }

    /// ∂h/∂e / 2π.
    fn first_derivative(&self, place: &Place, r: &BigRational) -> Ball {
        let [c0, c1, c2] = place.section.angles.each_ref().map(|angle| Ball::cos(angle, self.precision));
        let [short, long] = self.powers(r);
        short * &c0
            - &(long * &c1 * &self.ratio(self.j, self.n))
            - &(c2 * &self.ratio(self.n - self.j, self.n))
    }

    /// ∂²h/∂e² / 4π².
    fn second_derivative(&self, place: &Place, r: &BigRational) -> Ball {
        -self.bend(&self.powers(r), &place.sines)
    }

    /// r^j S₀ + rⁿ (j/n)² S₁ − (k/n)² S₂ for given sines: −∂²h/∂e² / 4π² if they are those of one e.
    fn bend(&self, [short, long]: &[Ball; 2], [s0, s1, s2]: &Sines<Ball>) -> Ball {
        let [j, k] = [self.j, self.n - self.j].map(|i| self.ratio(i, self.n));
        short.clone() * s0 + &(long.clone() * s1 * &j * &j) - &(k.clone() * &k * s2)
    }

    /// Whether h(r, e) < 0 is certain for all e from `first` to `last`, within [0, 1/j].
    fn is_negative(&self, r: &BigRational, first: &Place, last: &Place) -> bool {
        let powers = self.powers(r);
        let value = |place: &Place| place.section.value(&place.sines, r, self.precision);
        let is = |sign: Sign, x: &Ball| x.sign() == Some(sign);
        let mut budget = 10_000;
        let mut pieces = vec![(first.clone(), value(first), last.clone(), value(last))];
        while let Some((a, at_a, b, at_b)) = pieces.pop() {
            if !is(Sign::Negative, &at_a) || !is(Sign::Negative, &at_b) || budget == 0 {
                return false;
            }
            let width = &b.e - &a.e;
            // 4π²/8 < 5.
            let bulge = self.bend(&powers, &self.extreme_sines(&a, &b, true))
                * &Ball::ratio(&(&width * &width * BigInt::from(5)), self.precision);
            if is(Sign::Negative, &(at_a.clone() + &bulge)) && is(Sign::Negative, &(at_b.clone() + &bulge)) {
                continue;
            }
            if is(Sign::Positive, &self.bend(&powers, &self.extreme_sines(&a, &b, false)))
                && (is(Sign::Negative, &self.first_derivative(&a, r))
                    || is(Sign::Positive, &self.first_derivative(&b, r)))
            {
                continue;
            }
            budget -= 1;
            let middle = self.place((&a.e + &b.e) / BigInt::from(2));
            let at_middle = value(&middle);
            pieces.push((a, at_a, middle.clone(), at_middle.clone()));
            pieces.push((middle, at_middle, b, at_b));
        }
        true
    }

    /// The sines that make −∂²h/∂e² largest (or least) over e from a to b: S₀ and S₁ largest and S₂ least (or
    /// the reverse).
    ///
    /// All three angles change monotonically and stay within [0, π], since 0 ≤ je ≤ 1 and j ≥ 3: a sine is
    /// the larger the nearer its angle to π/2.
    fn extreme_sines(&self, a: &Place, b: &Place, largest: bool) -> Sines<Ball> {
        let quarter = BigRational::new(1.into(), 4.into());
        std::array::from_fn(|i| {
            let [x, y] = [a, b].map(|place| &place.section.turns[i] - &quarter);
            let largest = largest == (i != 2);
            if largest && x.is_negative() != y.is_negative() {
                return Ball::integer(1, self.precision);
            }
            let nearer = if x.abs() < y.abs() { a } else { b };
            let farther = if x.abs() < y.abs() { b } else { a };
            (if largest { nearer } else { farther }).sines[i].clone()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// h < 0 on all of [0, 1/j] just below the tip, and not just above it.
    #[test]
    fn the_check_of_a_bound_can_fail() {
        for (n, j) in [(4, 3), (8, 3), (8, 5), (41, 40), (41, 4)] {
            let precision = Precision::new(300);
            let search = Search { n, j, precision: &precision };
            let (r, _) = search.tip(30).unwrap();
            let (first, last) =
                (search.place(BigRational::zero()), search.place(BigRational::new(1.into(), j.into())));
            let shifted = |r: &BigRational, sign: i64| r + unit(20) * BigInt::from(sign);
            assert!(search.is_negative(&shifted(&r.lower, -1), &first, &last), "{n} {j}");
            assert!(!search.is_negative(&shifted(&r.upper, 1), &first, &last), "{n} {j}");
        }
    }
}
