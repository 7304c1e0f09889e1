//! A periodic attractor as a section sees it.

use std::cmp::Ordering;

use serde::{Deserialize, Serialize};

use super::dynamics::SectionState;

/// A periodic orbit as the section sees it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Cycle<P = [f64; 2]> {
    /// Its points, from the one of least q (then least u) on; of machines, by the plane that is drawn.
    pub points: Vec<P>,
    /// Impacts in one time round.
    pub impacts: u64,
    /// States this close to it in every coordinate are on it.
    pub(crate) same: f64,
    /// Its multipliers, the largest modulus first; none where they are not known, as the orbit was told by
    /// recurrence to rounding.
    pub multipliers: Vec<(f64, f64)>,
}

impl<P: SectionState> Cycle<P> {
    /// Whether a state of the section is one of its points.
    pub fn passes(&self, state: &P) -> bool {
        self.points.iter().any(|point| point.near(state, self.same))
    }

    /// The period in forcing periods.
    pub fn period(&self) -> usize {
        self.points.len()
    }

    /// Whether the other is the same attractor, wherever on it one began.
    pub fn is(&self, other: &Cycle<P>) -> bool {
        let close = self.same.max(other.same);
        let same = |shift: usize| {
            let turned = other.points.iter().cycle().skip(shift);
            self.points.iter().zip(turned).all(|(a, b)| a.near(b, close))
        };
        self.points.len() == other.points.len()
            && self.impacts == other.impacts
            && (0..self.period()).any(same)
    }

    /// The Lyapunov exponents times the forcing period, ln |λ| over the period, the largest first: −∞ for a
    /// multiplier 0. Empty where the multipliers are not known.
    pub fn exponents(&self) -> Vec<f64> {
        let one = |(re, im): &(f64, f64)| re.hypot(*im).ln() / self.period() as f64;
        self.multipliers.iter().map(one).collect()
    }
}

/// The points of a cycle from the least on, by where they are in the plane.
pub(crate) fn ordered<P>(mut points: Vec<P>, plane: impl Fn(&P) -> [f64; 2]) -> Vec<P> {
    let order =
        |&i: &usize, &j: &usize| plane(&points[i]).partial_cmp(&plane(&points[j])).unwrap_or(Ordering::Equal);
    let least = (0..points.len()).min_by(order).unwrap_or(0);
    points.rotate_left(least);
    points
}
