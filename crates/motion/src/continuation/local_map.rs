//! The local map at a grazing: A, B, C, e, γ and a_G of sections 2 and 3.1 of the paper, for any number of
//! coordinates, whichever engine has found it; the leading-order solution of a pattern as a start for
//! Newton's method.
//!
//! The map is that of the stroboscopic section at the phase of grazing, in coordinates x = (q, q′) less those
//! of the orbit that grazes. The engines say what they know of each number; how the orbit that grazes is
//! found is theirs. Not here: what the theory says of the map (`grazing-prove`'s `touch`).

use std::f64::consts::PI;

use super::{Itinerary, Strike};
use crate::{
    error::Result,
    motion::{
        algebra::{IDENTITY, Matrix2, apply, product},
        event::Place,
    },
};

/// A gap smaller than this part of the size of the motion, where another is zero, is zero too: some thousand
/// times what Newton's method leaves.
pub(crate) const TWICE: f64 = 1e-11;

/// The local map of a touch, velocities per radian of the forcing.
#[derive(Debug, Clone, PartialEq)]
pub struct LocalMap {
    /// A: ∂(q, q′) after a period of the orbit by (q, q′) before, its other impacts included.
    pub a: Vec<Vec<f64>>,
    /// B: what an impact of size 1 adds, √(2a_G) (1 + τ) times the change of velocity that turns the gap's by
    /// 1.
    pub b: Vec<f64>,
    /// C: the gap is C x + eµ to first order.
    pub c: Vec<f64>,
    /// e: how fast the least gap opens with the parameter (26).
    pub e: f64,
    /// a_G: the second derivative of the gap there.
    pub acceleration: f64,
    /// How fast the rate of the gap at the phase of grazing changes with the parameter.
    pub rate_drift: f64,
    /// det A, without cancellation.
    pub determinant: f64,
    /// The eigenvalues of A, real and imaginary parts, by modulus, the largest first.
    pub eigenvalues: Vec<(f64, f64)>,
    /// A, B, C and e with what they may be off.
    pub known: Known,
}

/// A number in floats and how far it may be off: 0 for what the structure makes exact.
pub type Near = (f64, f64);

/// A, B, C and e as the local theory takes them, in coordinates y in which they are sharpest.
#[derive(Debug, Clone, PartialEq)]
pub struct Known {
    /// A.
    pub a: Vec<Vec<Near>>,
    /// B.
    pub b: Vec<Near>,
    /// C.
    pub c: Vec<Near>,
    /// e.
    pub e: Near,
    /// x by y, by rows, where y is not x.
    pub outward: Option<Vec<Vec<f64>>>,
}

fn applied(a: &[Vec<f64>], x: &[f64]) -> Vec<f64> {
    a.iter().map(|row| row.iter().zip(x).map(|(a, x)| a * x).sum()).collect()
}

impl LocalMap {
    /// √(2a_G): an impact of size y has the speed V = √(2a_G) y.
    pub(crate) fn speed_scale(&self) -> f64 {
        (2.0 * self.acceleration).sqrt()
    }

    /// A of one degree of freedom.
    pub fn plane(&self) -> Option<Matrix2> {
        match &self.a[..] {
            [first, second] => Some([[first[0], first[1]], [second[0], second[1]]]),
            _ => None,
        }
    }

    /// a₁ = tr A.
    pub fn trace(&self) -> f64 {
        self.a.iter().enumerate().map(|(i, row)| row[i]).sum()
    }

    /// γ = A₁₂ (44), of one degree of freedom.
    pub fn gamma(&self) -> Option<f64> {
        self.plane().map(|a| a[0][1])
    }

    /// L = Π −C A^{n_i} B / (2 Y_i) of a pattern: the large eigenvalue is L (eµ)^{−m} to leading order (36),
    /// by (57) in floats; `None` on a singular boundary and for more degrees of freedom.
    pub fn leading(&self, periods: &[u64]) -> Option<f64> {
        let (a, kick) = (self.plane()?, self.b[1] * self.c[0]);
        let power = |n: u64| (0..n).fold(IDENTITY, |power, _| product(&a, &power));
        let powers: Vec<Matrix2> = periods.iter().map(|&n| power(n)).collect();
        let x = |a: &Matrix2| [-1.0, (a[0][0] - 1.0) / a[0][1]];
        let product: f64 = (0..powers.len())
            .map(|i| {
                let (a, next) = (&powers[i], &powers[(i + 1) % powers.len()]);
                let y = (x(next)[1] - apply(a, x(a))[1]) / kick;
                -a[0][1] * kick / (2.0 * y)
            })
            .product();
        product.is_finite().then_some(product)
    }

    /// x after an impact, from the leading-order solution.
    pub(crate) fn outward(&self, y: &[f64]) -> Vec<f64> {
        self.known.outward.as_ref().map_or_else(|| y.to_vec(), |rows| applied(rows, y))
    }

    /// A x.
    pub(crate) fn round(&self, x: &[f64]) -> Vec<f64> {
        applied(&self.a, x)
    }

    /// How much earlier than the phase of grazing an impact of the leading-order solution (32) is, and its
    /// incoming speed, at the distance `away` of the parameter from the grazing: √(2a_G) η Y with η = e ·
    /// `away`, where the rate of the gap is −V on the parabola of curvature a_G that the gap follows there.
    pub(crate) fn impact(&self, before: &LeadingImpact, away: f64) -> (f64, f64) {
        let (eta, n) = (self.e * away, self.b.len() / 2);
        let arriving = (0..before.periods).fold(self.outward(&before.x), |x, _| self.round(&x));
        let speed = self.speed_scale() * eta * before.y;
        let rate: f64 = self.c[..n].iter().zip(&arriving[n..]).map(|(c, x)| c * x).sum();
        ((eta * rate + self.rate_drift * away + speed) / self.acceleration, speed)
    }

    /// Times t_i and incoming speeds V_i of the impacts of a pattern, in their order, at the distance `away`
    /// of the parameter from the grazing at phase `phase`: the leading-order solution (32). Impact i follows
    /// n_{i−1} periods after the one before.
    pub fn start(&self, phase: f64, impacts: &[LeadingImpact], away: f64) -> Vec<f64> {
        let early = impacts.iter().map(|before| self.impact(before, away));
        early.flat_map(|(early, speed)| [phase - early, speed]).collect()
    }

    /// The pattern in the true system of one of the map over half of `width` periods and the mirror, and a
    /// start there: as [`start`](Self::start), the stops alternating with the halves, the one that is grazed
    /// first. A pattern with an odd number of halves is gone round twice.
    ///
    /// # Errors
    /// Those of [`Itinerary::new`].
    pub(crate) fn half_start<P: Place>(
        &self,
        (phase, width): (f64, u64),
        places: [P; 2],
        impacts: &[LeadingImpact],
        away: f64,
    ) -> Result<(Itinerary<P>, Vec<f64>)> {
        let once = self.start(phase, impacts, away);
        let (mut strikes, mut z) = (Vec::new(), Vec::new());
        for HalfImpact { impact, late, periods } in halves(&pattern_of(impacts), width) {
            strikes.push(Strike { place: places[usize::from(late)], periods });
            z.extend([once[2 * impact] + if late { PI } else { 0.0 }, once[2 * impact + 1]]);
        }
        Ok((Itinerary::new(strikes)?, z))
    }
}

/// What an impact of the leading-order solution (32) of a pattern follows from, over η = eµ.
#[derive(Debug, Clone, PartialEq)]
pub struct LeadingImpact {
    /// X just after the impact before it.
    pub x: Vec<f64>,
    /// The periods since.
    pub periods: u64,
    /// Y at the impact: its speed is √(2a_G) ηY.
    pub y: f64,
}

/// The pattern (n₁, …, n_m) of these impacts: n_i periods pass after the i-th.
pub(crate) fn pattern_of(impacts: &[LeadingImpact]) -> Vec<u64> {
    let after = |i: usize| impacts[(i + 1) % impacts.len()].periods;
    (0..impacts.len()).map(after).collect()
}

/// An impact of a motion that follows a pattern of the map of half a period and its mirror.
struct HalfImpact {
    /// Which of the pattern's impacts, from 0.
    pub impact: usize,
    /// Whether it comes half a period late, on the mirror of the stop.
    pub late: bool,
    /// Whole periods from its phase to that of the next.
    pub periods: u32,
}

/// The impacts of a pattern of the map of half of `width` periods: the stops alternate with the halves, and a
/// pattern with an odd number of halves is gone round twice.
fn halves(pattern: &[u64], width: u64) -> Vec<HalfImpact> {
    let rounds = if pattern.iter().sum::<u64>() % 2 == 1 { 2 } else { 1 };
    // Whole periods before a half: the other half of one is in the phase.
    let begun = |passed: u64| (passed * width - passed % 2) / 2;
    let mut passed = 0;
    let impacts = (0..rounds).flat_map(|_| pattern.iter().enumerate());
    impacts
        .map(|(impact, n)| {
            let (late, before) = (passed % 2 == 1, begun(passed));
            passed += n;
            HalfImpact { impact, late, periods: (begun(passed) - before) as u32 }
        })
        .collect()
}
