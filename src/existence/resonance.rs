//! What is born on a singular boundary, u_n = 0, where Theorem 1 is silent.
//!
//! In region 3 with a₂ ≠ 1 it is nθ = mπ for a whole m ≥ 1. Then Aⁿ = ζI with ζ = (−1)^m rⁿ ≠ 1, and the
//! orbits with one impact in n periods near grazing lie on one curve in its speed y, with µ = Ky² + o(y²).
//! They are admissible if C Aᵏ (I − Aⁿ)⁻¹ B = γ u_k/(1 − ζ) > 0 for 0 < k < n, and not if one of these is
//! negative. For m = 1 all u_k there are positive; for m ≥ 2 both signs occur. Proved in Coq for 0 < r < 1
//! (`Plane_statement` of `StatementResonance.v`; the exact orbit of a linear oscillator is `Exact_statement`,
//! its stability `Stable_statement`); for r > 1 it is that of the time-reversed system.
//!
//! Not here: the sign of K, on which side of the touch the orbit is. That is of second order, and a₁, a₂ do
//! not tell it.

use std::fmt;

use num_rational::BigRational;
use num_traits::{One, Zero};
use serde::Serialize;

use crate::local::{Plane, Point, Polar};

/// Which resonance nθ = mπ a singular boundary is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Resonance {
    /// m = 1, s = 1/(2n). For γ > 0 one orbit, its speed like √|µ|, on the side sign µ = sign K if K ≠ 0; for
    /// γ < 0 none. Of a linear oscillator with damping and restitution τ ≤ 1 it is beyond the touch (eµ < 0),
    /// and asymptotically stable if τ > 0: both multipliers are τrⁿ.
    First,
    /// m ≥ 2: none, on either side, for either sign of γ, whatever the second order.
    Higher,
}

impl Resonance {
    /// That of period `n` at `point`; `None` where u_n ≠ 0, and for a₂ = 1, of which the theorem does not
    /// speak. Exact. Cost: O(1) operations on the point's numbers.
    ///
    /// ```
    /// use grazing::existence::Resonance;
    /// use grazing::{local::{Plane, Point}, number::parse_rational};
    /// // u_3 = a₁² − a₂ = 0 with a₁ > 0: θ = π/3.
    /// let point = Point::Plane(Plane::new(parse_rational("0.9")?, parse_rational("0.81")?)?);
    /// let all = [2, 3, 6].map(|n| Resonance::at(&point, n));
    /// assert_eq!(all, [None, Some(Resonance::First), Some(Resonance::Higher)]);
    /// # Ok::<(), grazing::Error>(())
    /// ```
    pub fn at(point: &Point, n: u64) -> Option<Resonance> {
        let first = match point {
            Point::Polar(polar) => polar_is_first(polar, n)?,
            Point::Plane(plane) => plane_is_first(plane, n)?,
        };
        Some(if first { Resonance::First } else { Resonance::Higher })
    }

    /// The periods n ≤ `last` with u_n = 0, each with its resonance, of which there is none for a₂ = 1.
    /// Exact. Cost: `last` times that of [`at`](Resonance::at).
    pub fn up_to(point: &Point, last: u64) -> Vec<(u64, Option<Resonance>)> {
        let is_singular = |n: &u64| match point {
            Point::Polar(polar) => polar.is_singular(*n),
            Point::Plane(plane) => plane.is_singular(*n),
        };
        (1..=last).filter(is_singular).map(|n| (n, Resonance::at(point, n))).collect()
    }

    /// What is born at these, a line for each resonance, the least of its periods first.
    ///
    /// ```
    /// use grazing::{existence::Resonance, local::{Point, Polar}, number::parse_rational};
    /// let point = Point::Polar(Polar::new(parse_rational("0.9")?, parse_rational("1/6")?)?);
    /// let lines = Resonance::in_words(&Resonance::up_to(&point, 9));
    /// assert!(lines[0].starts_with("n = 3, u_n = 0, first resonance: for gamma > 0 one orbit"));
    /// assert!(lines[1].starts_with("n = 6, ..., u_n = 0, higher resonance: no orbit"));
    /// # Ok::<(), grazing::Error>(())
    /// ```
    pub fn in_words(found: &[(u64, Option<Resonance>)]) -> Vec<String> {
        let line = |kind: Option<Resonance>| {
            let mut all = found.iter().filter(|(_, own)| *own == kind);
            let (n, _) = all.next()?;
            let more = if all.next().is_some() { ", ..." } else { "" };
            let what = kind.map_or(String::new(), |kind| format!(", {} resonance: {kind}", kind.name()));
            Some(format!("n = {n}{more}, u_n = 0{what}"))
        };
        [Some(Resonance::First), Some(Resonance::Higher), None].into_iter().filter_map(line).collect()
    }

    /// What is born of one impact in n ≥ 2 periods on both sides of s = 1/(2n), and there, for 0 < a₂ < 1.
    pub fn across(n: u64) -> String {
        let first = Resonance::First;
        format!(
            "n = {n}: s = 1/{} may be among them. Below it, for gamma > 0, one orbit with one impact is born for \
             e*mu < 0; above it none is, but next to it one for e*mu > 0; for gamma < 0 none on either side. At it \
             u_n = 0, first resonance: {first}",
            2 * n
        )
    }

    /// The word that tables have for it.
    pub fn name(self) -> &'static str {
        match self {
            Resonance::First => "first",
            Resonance::Higher => "higher",
        }
    }
}

/// What is born there, in words.
impl fmt::Display for Resonance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Resonance::First => {
                "for gamma > 0 one orbit with one impact is born, its speed like sqrt|mu|, on the side that the second \
                 order decides; of a damped linear oscillator for e*mu < 0, with both multipliers tau r^n. For \
                 gamma < 0 none"
            }
            Resonance::Higher => "no orbit with one impact is born, on either side",
        })
    }
}

fn polar_is_first(polar: &Polar, n: u64) -> Option<bool> {
    let resonant = polar.is_singular(n) && !polar.on_circle();
    resonant.then(|| (polar.s() * BigRational::from_integer((2 * n).into())).is_one())
}

/// θ is a multiple of π/q for the least q with u_q = 0, and π/q itself where cos θ is not negative.
fn plane_is_first(plane: &Plane, n: u64) -> Option<bool> {
    let resonant = plane.is_singular(n) && !plane.a2().is_one();
    resonant.then(|| *plane.a1() >= BigRational::zero() && n <= 6 && (2..n).all(|k| !plane.is_singular(k)))
}
