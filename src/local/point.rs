//! Points, quantities, and their values on a rung or to as many certain bits as wanted.

use std::fmt;

use serde::{Serialize, Serializer};

use super::{Plane, Polar};
use crate::number::{Ball, Circular, Precision};

/// A point at which the local map is evaluated.
#[derive(Debug, Clone)]
pub enum Point {
    /// By modulus and angle of complex eigenvalues.
    Polar(Polar),
    /// By trace and determinant.
    Plane(Plane),
}

/// A quantity of the single-impact orbit of a period n.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// b_{n,k}, 1 ≤ k < n.
    B {
        /// The period.
        n: u64,
        /// The index.
        k: u64,
    },
    /// c_n.
    C {
        /// The period.
        n: u64,
    },
}

/// `b_{5,2}` or `c_5`.
impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Quantity::B { n, k } => write!(f, "b_{{{n},{k}}}"),
            Quantity::C { n } => write!(f, "c_{n}"),
        }
    }
}

/// As text: `b_{5,2}` or `c_5`.
impl Serialize for Quantity {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// Bits that a close evaluation may lose.
const LOST: u64 = 16;

/// Bits that it may take in between beyond those wanted.
const MOST_GUARD: u64 = 16384;

impl Quantity {
    /// The period n.
    pub fn period(self) -> u64 {
        match self {
            Quantity::B { n, .. } | Quantity::C { n } => n,
        }
    }

    pub(super) fn check(self) {
        match self {
            Quantity::B { n, k } => {
                assert!(1 <= k && k < n, "b_{{n,k}} needs 1 ≤ k < n, not n = {n}, k = {k}")
            }
            Quantity::C { n } => assert!(n >= 1, "c_n needs n ≥ 1"),
        }
    }
}

impl Point {
    /// The quantity on one rung; `None` where u_n = 0. Cost: as [`sign_on`](super::sign_on).
    ///
    /// # Panics
    /// As [`Ladder::sign`](super::Ladder::sign).
    pub fn evaluate<T: Circular>(&self, quantity: Quantity, context: &T::Context) -> Option<T> {
        quantity.check();
        match (self, quantity) {
            (Point::Polar(polar), Quantity::B { n, k }) => polar.b(n, k, context),
            (Point::Polar(polar), Quantity::C { n }) => polar.c(n, context),
            (Point::Plane(plane), Quantity::B { n, k }) => plane.b(n, k, context),
            (Point::Plane(plane), Quantity::C { n }) => plane.c(n, context),
        }
    }

    /// The quantity to at least the precision's bits less 16; `None` where u_n = 0.
    ///
    /// Where balls of this precision lose more, as near u_n = 0 or a zero of the quantity they must (by as
    /// many bits as the condition number has, if the point is rounded), longer ones are taken: the result may
    /// have more bits. Up to 16384 bits more, and then the result is what these show. Cost: mostly one or two
    /// evaluations.
    ///
    /// # Panics
    /// As [`Ladder::sign`](super::Ladder::sign).
    ///
    /// ```
    /// use grazing::{local::{Plane, Point, Quantity}, number::{Ball, Precision, parse_rational}};
    /// // a₁² = 2a₂ would be singular.
    /// let plane = Plane::new(parse_rational("1+1e-400")?, parse_rational("1/2")?)?;
    /// let (point, bits) = (Point::Plane(plane), Precision::new(128));
    /// let b = Quantity::B { n: 4, k: 1 };
    /// assert!(point.evaluate::<Ball>(b, &bits).unwrap().certain_bits() < Some(16));
    /// assert!(point.evaluate_closely(b, &bits).unwrap().certain_bits() >= Some(112));
    /// # Ok::<(), grazing::Error>(())
    /// ```
    pub fn evaluate_closely(&self, quantity: Quantity, precision: &Precision) -> Option<Ball> {
        let bits = u64::from(precision.bits());
        let most = bits + MOST_GUARD;
        let mut working = bits;
        let mut ball = self.evaluate::<Ball>(quantity, precision)?;
        // None: the value is exact.
        while let Some(certain) = ball.certain_bits()
            && certain + LOST < bits
            && working < most
        {
            let lost = working.saturating_sub(certain);
            let wanted = if certain == 0 { bits + 2 * working } else { bits + lost };
            working = wanted.min(most);
            ball = self.evaluate(quantity, &Precision::new(u32::try_from(working).unwrap_or(u32::MAX)))?;
        }
        Some(ball)
    }

    /// Bits of the longest numerator or denominator of its coordinates.
    pub(super) fn length(&self) -> u64 {
        match self {
            Point::Polar(polar) => polar.r().denom().bits().max(polar.s().denom().bits()),
            Point::Plane(plane) => plane.length(),
        }
    }
}
