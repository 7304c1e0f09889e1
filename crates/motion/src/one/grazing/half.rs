//! The grazing of a symmetric orbit at both walls at once: the local theory of its half-period map, which has
//! one wall.
//!
//! If the system is its own mirror image half a period later, S: (q, u, t) ↦ (−q, −u, t + π), then H, half a
//! period of motion followed by S's mirror, is a map whose square is the period's, and it sees one wall: a
//! symmetric orbit is its fixed point. With Φ the linearised motion over half of the orbit's period, H has A
//! = −Φ, and the same a_G, τ and e as either wall alone. Here: orbits that have no impacts but the two
//! grazings. Not here: symmetric orbits with further impacts.

use std::f64::consts::PI;

use super::{Grazing, local_map::in_plane};
use crate::{
    continuation::{LeadingImpact, LocalMap, Multipliers},
    error::Result,
    motion::{Flow, Side, System, Wall},
    one::orbit::{Itinerary, Oscillator},
};

/// Whether S takes the system to itself: the force does, as far as its form tells, and the walls mirror each
/// other.
pub(crate) fn is_mirrored(oscillator: &Oscillator) -> bool {
    let System { lower: Some(lower), upper: Some(upper), .. } = oscillator.system() else { return false };
    // Q₂(t + π) = −Q₁(t).
    let amplitude = |wall: &Wall<f64>, k: u32| {
        let all = wall.harmonics.iter().filter(|h| h.k == k);
        all.fold([0.0, 0.0], |[cos, sin], h| [cos + h.cos, sin + h.sin])
    };
    let mirrored = |k: u32| {
        let sign = if k % 2 == 1 { 1.0 } else { -1.0 };
        amplitude(upper, k) == amplitude(lower, k).map(|x| sign * x)
    };
    oscillator.flow().equation().is_mirrored()
        && lower.offset == -upper.offset
        && lower.restitution == upper.restitution
        && lower.harmonics.iter().chain(&upper.harmonics).all(|h| mirrored(h.k))
}

impl Grazing {
    /// The map over half the orbit's period, if the orbit is symmetric and touches each wall once.
    pub fn half_map(&self, oscillator: &Oscillator) -> Option<LocalMap> {
        let periods = self.itinerary.periods();
        let alone = self.itinerary.strikes().len() == 1 && periods % 2 == 1;
        let opposite = self.second.is_some_and(|second| second.side != self.side());
        if !(alone && opposite && is_mirrored(oscillator)) {
            return None;
        }
        let half = PI * f64::from(periods);
        let touch = oscillator.touch(self.side(), self.z[0]).ok()?;
        let start = touch.leaving(self.z[0], 0.0);
        let (end, matrix) = oscillator.flow().advance_linearised(start, half);
        // The motion itself must be symmetric, not just the system.
        let there = oscillator.touch(self.second?.side, self.z[0] + half).ok()?;
        let off = (end.q - there.motion[0]).abs().max((end.u - there.motion[1]).abs());
        if off > 1e-9 * oscillator.unit(&self.itinerary).max(end.q.abs()) {
            return None;
        }
        let a = matrix.map(|row| row.map(|x| -x));
        let flow = oscillator.flow().determinant(start, half);
        let multipliers = Multipliers::with(&a, flow, oscillator, &[]);
        let LocalMap { b, c, e, rate_drift, acceleration, .. } = &self.map;
        Some(in_plane(&a, multipliers, [b[1], c[0]], [*e, *rate_drift, *acceleration]))
    }

    /// The start for Newton's method on the true system for a pattern of the half-period map: as
    /// [`Grazing::start`], the walls alternating with the halves; a pattern with an odd number of halves is
    /// gone round twice.
    ///
    /// # Errors
    /// Those of [`Itinerary::new`].
    pub fn half_start(
        &self,
        map: &LocalMap,
        impacts: &[LeadingImpact],
        parameter: f64,
    ) -> Result<(Itinerary, Vec<f64>)> {
        let other = if self.side() == Side::Lower { Side::Upper } else { Side::Lower };
        let (grazing, width) = (self.z[0], self.itinerary.periods().into());
        let away = parameter - self.parameter;
        map.half_start((grazing, width), [self.side(), other], impacts, away)
    }
}
