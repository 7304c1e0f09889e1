//! The local map at a grazing: A, B, C, e, γ and a_G of sections 2 and 3.1 of the paper, for any number of
//! coordinates, whichever engine has found it; the leading-order solution of a pattern as a start for
//! Newton's method.
//!
//! The map is that of the stroboscopic section at the phase of grazing, in coordinates x = (q, q′) less those
//! of the orbit that grazes. The engines say what they know of each number; how the orbit that grazes is
//! found is theirs. Not here: which patterns exist (`pattern`).

use std::f64::consts::PI;

use num_rational::BigRational;

use super::{Itinerary, Strike};
use crate::{
    error::{Error, Result},
    local::Region,
    motion::{
        algebra::{IDENTITY, Matrix2, apply, product},
        event::Place,
    },
    pattern::{Entry, HalfImpact, LeadingImpact, Map, Report, halves},
};

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
    pub(crate) known: Known,
}

/// A number in floats and how far it may be off: 0 for what the structure makes exact.
pub(crate) type Near = (f64, f64);

/// A, B, C and e as the local theory takes them, in coordinates y in which they are sharpest.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Known {
    pub a: Vec<Vec<Near>>,
    pub b: Vec<Near>,
    pub c: Vec<Near>,
    pub e: Near,
    /// x by y, by rows, where y is not x.
    pub outward: Option<Vec<Vec<f64>>>,
}

/// How far entries may be off that were computed in floats, by their size.
pub(crate) const ERROR: f64 = 1e-12;

fn applied(a: &[Vec<f64>], x: &[f64]) -> Vec<f64> {
    a.iter().map(|row| row.iter().zip(x).map(|(a, x)| a * x).sum()).collect()
}

impl LocalMap {
    /// √(2a_G): an impact of size y has the speed V = √(2a_G) y.
    pub(crate) fn speed_scale(&self) -> f64 {
        (2.0 * self.acceleration).sqrt()
    }

    /// A of one degree of freedom.
    pub(crate) fn plane(&self) -> Option<Matrix2> {
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

    /// The region of (a₁, a₂), taken as they are computed; after reversing time if a₂ > 1. `None` for a₂ ≤ 0
    /// and for more degrees of freedom.
    pub fn region(&self) -> Option<Region> {
        self.plane().and_then(|_| Region::at(self.trace(), self.determinant))
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

    /// The map for the local theory, every computed entry widened by far more than its error where Newton's
    /// method has converged, but without proof.
    ///
    /// # Errors
    /// An input error if a_G is not positive, and those of [`Map::new`].
    pub fn to_map(&self) -> Result<Map> {
        if self.acceleration.is_nan() || self.acceleration <= 0.0 {
            let message = format!("a_G = {} at the grazing point; it must be positive", self.acceleration);
            return Err(Error::input(message));
        }
        let exact = |x: f64| BigRational::from_float(x).ok_or_else(|| Error::input("A is not finite"));
        let entry = |&(x, radius): &Near| match radius {
            0.0 => Ok(Entry::from(exact(x)?)),
            _ => Entry::between(exact(x - radius)?, exact(x + radius)?),
        };
        let Known { a, b, c, e, .. } = &self.known;
        let all = |row: &Vec<Near>| row.iter().map(entry).collect::<Result<Vec<Entry>>>();
        Map::new(a.iter().map(all).collect::<Result<_>>()?, all(b)?, all(c)?, entry(e)?, None)
    }

    /// x after an impact, from the solution of [`to_map`](Self::to_map).
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

    /// Times t_i and incoming speeds V_i of the impacts of the pattern (n₁, …, n_m) of `report`, which is of
    /// [`to_map`](Self::to_map), at the distance `away` of the parameter from the grazing at phase `phase`:
    /// the leading-order solution (32). Impact i follows n_{i−1} periods after the one before.
    ///
    /// # Errors
    /// An input error if the report has no solution.
    pub fn start(&self, phase: f64, periods: &[u64], report: &Report, away: f64) -> Result<Vec<f64>> {
        let impacts = report.impacts(periods)?;
        let early = impacts.iter().map(|before| self.impact(before, away));
        Ok(early.flat_map(|(early, speed)| [phase - early, speed]).collect())
    }

    /// The pattern in the true system of one of the map over half of `width` periods and the mirror, and a
    /// start there: as [`start`](Self::start), the stops alternating with the halves, the one that is grazed
    /// first. A pattern with an odd number of halves is gone round twice.
    ///
    /// # Errors
    /// As of [`start`](Self::start).
    pub(crate) fn half_start<P: Place>(
        &self,
        (phase, width): (f64, u64),
        places: [P; 2],
        (periods, report): (&[u64], &Report),
        away: f64,
    ) -> Result<(Itinerary<P>, Vec<f64>)> {
        let once = self.start(phase, periods, report, away)?;
        let (mut strikes, mut z) = (Vec::new(), Vec::new());
        for HalfImpact { impact, late, periods } in halves(periods, width) {
            strikes.push(Strike { place: places[usize::from(late)], periods });
            z.extend([once[2 * impact] + if late { PI } else { 0.0 }, once[2 * impact + 1]]);
        }
        Ok((Itinerary::new(strikes)?, z))
    }
}
