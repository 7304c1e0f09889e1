//! Signs of u_n and N_{n,k} = u_n − u_k − a₂ᵏ u_{n−k} on a whole rectangle of the (a₁, a₂) plane, by Taylor's
//! formula of second order.
//!
//! |u_n| ≤ nρⁿ where no eigenvalue exceeds ρ ≥ 1, and with U = Σ u_n zⁿ, ∂U/∂a₁ = U², ∂U/∂a₂ = −zU². So the
//! second derivatives of N_{n,k} are at most n⁵ρⁿ/10 on the rectangle, half widths h₁, h₂, and N differs from
//! its value at the middle by at most |∂₁N| h₁ + |∂₂N| h₂ + (h₁ + h₂)² n⁵ρⁿ/20, the derivatives being those
//! at the middle; the same holds of u_n. Balls enclose all of it.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, pow};

use super::Realm;
use crate::{
    error::{Error, Result},
    local::{Plane, Region},
    number::{Ball, Precision, Real, Sign},
};

/// The largest index of a sign on a rectangle.
const LONGEST: u64 = 512;

/// Bits of the balls for each index: u_{n+1} = a₁u_n − a₂u_{n−1} loses up to 1.3 bits per step.
const BITS: u32 = 2;

/// A closed rectangle of the (a₁, a₂) plane with 0 < a₂ ≤ 1.
#[derive(Debug, Clone)]
pub struct Rectangle {
    a1: [BigRational; 2],
    a2: [BigRational; 2],
    half: [Ball; 2],
    rho: BigRational,
    /// u_n, ∂u_n/∂a₁ and a₂ⁿ at the middle.
    u: Vec<Ball>,
    slope: Vec<Ball>,
    power: Vec<Ball>,
    precision: Precision,
}

impl Rectangle {
    /// The points with a₁ and a₂ between these bounds, both included. Cost: 512 steps of recurrences, five
    /// products of balls of 1024 bits each; memory: 1536 balls.
    ///
    /// # Errors
    /// An input error unless lower ≤ upper and 0 < a₂ ≤ 1.
    pub fn new(a1: [BigRational; 2], a2: [BigRational; 2]) -> Result<Rectangle> {
        Rectangle::reaching(a1, a2, LONGEST)
    }

    /// The same, whose signs are told for indices below `longest`. Cost: that many steps, with balls of twice
    /// as many bits, 128 at least.
    pub(crate) fn reaching(a1: [BigRational; 2], a2: [BigRational; 2], longest: u64) -> Result<Rectangle> {
        for (name, [lower, upper]) in [("a1", &a1), ("a2", &a2)] {
            if lower > upper {
                return Err(Error::input(format!(
                    "{name} from {lower} to {upper}: the lower end comes first"
                )));
            }
        }
        if !a2[0].is_positive() || a2[1] > BigRational::one() {
            return Err(Error::input(format!(
                "a2 from {} to {}: a box lies in 0 < a2 <= 1 (for a2 > 1 reverse time: a1/a2 and 1/a2)",
                a2[0], a2[1]
            )));
        }
        let precision = Precision::new((BITS * longest as u32).max(128));
        let two = BigRational::from_integer(2.into());
        let middle = [&a1, &a2].map(|[lower, upper]| (lower + upper) / &two);
        let half = [&a1, &a2].map(|[lower, upper]| Ball::ratio(&((upper - lower) / &two), &precision));
        let greatest = a1[0].abs().max(a1[1].abs());
        let inside = greatest <= BigRational::one() + &a2[0];
        let rho = if inside { BigRational::one() } else { greatest };
        let [c1, c2] = middle.map(|c| Ball::ratio(&c, &precision));
        let integer = |value| Ball::integer(value, &precision);
        let (mut u, mut slope) = (vec![integer(0), integer(1)], vec![integer(0), integer(0)]);
        let mut power = vec![integer(1)];
        let step = |x: &[Ball], n: usize| c1.clone() * &x[n] - &(c2.clone() * &x[n - 1]);
        for n in 1..longest as usize {
            slope.push(step(&slope, n) + &u[n]);
            u.push(step(&u, n));
            power.push(power[n - 1].clone() * &c2);
        }
        Ok(Rectangle { a1, a2, half, rho, u, slope, power, precision })
    }

    /// A box that holds a point as computed and its rounding, a₁ and a₂ being known to 10⁻¹² of the larger of
    /// |a₁| and 1; for a₂ > 1, or where it may be, the images by reversal of time too. None where a₂ may not
    /// be positive.
    pub fn about(trace: f64, determinant: f64) -> Option<Rectangle> {
        let one = BigRational::one();
        let (t, d) = (BigRational::from_float(trace)?, BigRational::from_float(determinant)?);
        let size = t.abs().max(one.clone());
        let margin = size / BigRational::from_integer(1_000_000_000_000u64.into());
        let (below, above) = (&d - &margin, &d + &margin);
        let mut heights = vec![below.clone(), above.clone()];
        if below < one && above > one {
            heights.push(one.clone());
        }
        let mut images = Vec::new();
        for t in [&t - &margin, &t + &margin] {
            for d in heights.iter().filter(|d| d.is_positive()) {
                images.push(if *d > one { (&t / d, d.recip()) } else { (t.clone(), d.clone()) });
            }
        }
        let ends = |of: fn(&(BigRational, BigRational)) -> &BigRational| {
            Some([images.iter().map(of).min()?.clone(), images.iter().map(of).max()?.clone()])
        };
        if !below.is_positive() {
            return None;
        }
        Rectangle::new(ends(|image| &image.0)?, ends(|image| &image.1)?).ok()
    }

    /// The bounds of a₁.
    pub(crate) fn a1(&self) -> &[BigRational; 2] {
        &self.a1
    }

    /// The bounds of a₂.
    pub(crate) fn a2(&self) -> &[BigRational; 2] {
        &self.a2
    }

    /// The region that every point lies in, if there is one.
    pub fn region(&self) -> Option<Region> {
        // Each region asks for one or two of a₁² < 4a₂, a₁² ≥ 4a₂ with a₁ of one sign, |a₁| < 1 + a₂, |a₁| >
        // 1 + a₂: each holds on the rectangle if it holds at the corner where it is tightest.
        let corner = |i: usize, j: usize| Plane::new(self.a1[i].clone(), self.a2[j].clone()).ok();
        let region = corner(0, 0)?.region();
        let same = [(0, 1), (1, 0), (1, 1)]
            .into_iter()
            .all(|(i, j)| corner(i, j).is_some_and(|c| c.region() == region));
        (same && region != Region::Line).then_some(region)
    }

    /// What a walk down the path finds here.
    pub(crate) fn realm(&self) -> Realm {
        let one = BigRational::one();
        // a₁ − (a₂ + 1) and a₁ + (a₂ + 1) are largest and least at corners.
        let above = |i: usize, j: usize| &self.a1[i] - &self.a2[j] - &one;
        let below = |i: usize| &self.a1[i] + &self.a2[i] + &one;
        if above(0, 1).is_positive() {
            Realm::One
        } else if !above(1, 0).is_negative() {
            Realm::AcrossAbove
        } else if below(1).is_negative() {
            Realm::Five
        } else if !below(0).is_positive() {
            Realm::AcrossBelow
        } else {
            match self.region() {
                Some(Region::Two) => Realm::Two,
                Some(Region::Four) => Realm::Four,
                _ => Realm::Inside,
            }
        }
    }

    /// The sign of u_n at every point, if it is certain and not 0. Cost: O(1) products of balls, and ρⁿ as a
    /// fraction, where |a₁| may exceed 1 + a₂.
    pub(crate) fn u(&self, n: u64) -> Option<Sign> {
        if n == 2 {
            // u_2 = a₁.
            let [lower, upper] = self.a1.each_ref().map(Sign::of);
            return (lower == upper && lower != Sign::Zero).then_some(lower);
        }
        let i = usize::try_from(n).ok().filter(|&i| i < self.u.len())?;
        self.certain(n, self.u[i].clone(), [self.slope[i].clone(), -self.slope[i - 1].clone()])
    }

    /// The sign of N_{n,k} at every point, if it is certain and not 0. Cost: as [`u`](Rectangle::u).
    ///
    /// # Panics
    /// Unless 1 ≤ k < n.
    pub(crate) fn numerator(&self, n: u64, k: u64) -> Option<Sign> {
        assert!(1 <= k && k < n, "N_{{n,k}} needs 1 ≤ k < n, not n = {n}, k = {k}");
        let i = usize::try_from(n).ok().filter(|&i| i < self.u.len())?;
        let k = k as usize;
        let (u, d, power) = (&self.u, &self.slope, &self.power[k]);
        let value = u[i].clone() - &u[k] - &(power.clone() * &u[i - k]);
        let first = d[i].clone() - &d[k] - &(power.clone() * &d[i - k]);
        let weight = Ball::integer(k as i32, &self.precision) * &(self.power[k - 1].clone() * &u[i - k]);
        let second = d[k - 1].clone() - &d[i - 1] + &(power.clone() * &d[i - k - 1]) - &weight;
        self.certain(n, value, [first, second])
    }

    /// The sign of b_{n,k} at every point, if it is certain and not 0.
    ///
    /// # Panics
    /// As [`numerator`](Rectangle::numerator).
    pub(crate) fn b(&self, n: u64, k: u64) -> Option<Sign> {
        Some(self.u(n)? * self.numerator(n, k)?)
    }

    fn certain(&self, n: u64, value: Ball, [first, second]: [Ball; 2]) -> Option<Sign> {
        let sign = value.sign().filter(|&sign| sign != Sign::Zero)?;
        let [h1, h2] = &self.half;
        let magnitude = |x: Ball| match x.sign() {
            Some(Sign::Negative) => -x,
            Some(_) => x,
            // |x| is at most the sum of what it may be on either side.
            None => x.exact_bounds().map_or(x, |(lo, hi)| {
                let most = lo.abs().max(hi.abs());
                Ball::ratio(&most, &self.precision)
            }),
        };
        let scale = BigRational::from_integer(BigInt::from(n).pow(5)) / BigRational::from_integer(20.into());
        let scale = Ball::ratio(&(scale * pow(self.rho.clone(), n as usize)), &self.precision);
        let width = h1.clone() + h2;
        let change = magnitude(first) * h1 + &(magnitude(second) * h2) + &(width.clone() * &width * &scale);
        let least = match sign {
            Sign::Positive => value - &change,
            _ => -value - &change,
        };
        (least.sign() == Some(Sign::Positive)).then_some(sign)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::local::{Answer, Ladder, Point, Quantity};

    fn q(p: i64, d: i64) -> BigRational {
        BigRational::new(p.into(), d.into())
    }

    /// What is told of a rectangle is true at its corners and its middle; something is told, and something is
    /// not.
    #[test]
    fn signs_hold_at_every_point_tried() {
        let ladder = Ladder::default();
        let (mut told, mut untold) = (0, 0);
        for (a1, a2, width) in
            [(-60, 80, 100), (-25, 50, 1000), (30, 90, 300), (130, 40, 500), (-120, 30, 400)]
        {
            let rectangle = Rectangle::new(
                [q(a1, 100), q(a1, 100) + q(1, width)],
                [q(a2, 100) - q(1, width), q(a2, 100)],
            )
            .unwrap();
            for n in 2..=14 {
                for k in 1..n {
                    let Some(sign) = rectangle.b(n, k) else {
                        untold += 1;
                        continue;
                    };
                    told += 1;
                    for (i, j) in [(0, 0), (0, 2), (2, 0), (2, 2), (1, 1), (1, 2)] {
                        let at = |[lo, hi]: &[BigRational; 2], i: i64| lo + (hi - lo) * q(i, 2);
                        let plane = Plane::new(at(rectangle.a1(), i), at(rectangle.a2(), j)).unwrap();
                        let answer = ladder.sign(&Point::Plane(plane), Quantity::B { n, k }).answer;
                        assert_eq!(answer, Answer::Sign(sign), "{a1} {a2} {n} {k}");
                    }
                }
            }
        }
        assert!(told > 150 && untold > 20, "{told} {untold}");
    }

    #[test]
    fn regions_and_ends() {
        let region = |a: [(i64, i64); 4]| {
            let [a, b, c, d] = a.map(|(p, d)| q(p, d));
            Rectangle::new([a, b], [c, d]).unwrap().region()
        };
        assert_eq!(region([(-1, 1), (1, 1), (1, 2), (3, 4)]), Some(Region::Three));
        assert_eq!(region([(-1, 1), (1, 1), (1, 4), (3, 4)]), None);
        assert_eq!(region([(-3, 1), (3, 1), (1, 4), (3, 4)]), None);
        assert_eq!(region([(1, 1), (1, 1), (1, 4), (1, 4)]), Some(Region::Two));
        for (a1, a2) in [([q(1, 1), q(0, 1)], [q(1, 2), q(1, 2)]), ([q(0, 1), q(0, 1)], [q(0, 1), q(1, 2)])] {
            assert!(Rectangle::new(a1, a2).unwrap_err().is_input());
        }
        assert!(Rectangle::new([q(0, 1), q(0, 1)], [q(1, 2), q(3, 2)]).unwrap_err().is_input());
    }

    /// A box about a point with a₂ near 1 holds the point, or its image, whatever side of 1 rounding puts it
    /// on.
    #[test]
    fn boxes_hold_the_point_or_its_image() {
        let exact = |x: f64| BigRational::from_float(x).unwrap();
        for (t, d) in [
            (0.3, 0.5),
            (-1.5, 0.9),
            (0.3, 1.0),
            (0.3, 1.0 + 1e-13),
            (0.3, 1.0 - 1e-13),
            (1.2, 4.0),
            (-3.0, 2.5),
        ] {
            let found = Rectangle::about(t, d).unwrap();
            let (mut t, mut d) = (exact(t), exact(d));
            if d > BigRational::one() {
                (t, d) = (&t / &d, d.recip());
            }
            let [a1, a2] = [found.a1(), found.a2()];
            assert!(a1[0] <= t && t <= a1[1] && a2[0] <= d && d <= a2[1], "{t} {d}");
        }
        assert!(Rectangle::about(0.3, 1e-13).is_none() && Rectangle::about(f64::NAN, 0.5).is_none());
    }
}
