//! Machines that are their own mirror image half a period later, S: (q, u, t) ↦ (−q, −u, t + π): the grazing
//! of two stops at once that mirror each other, as one grazing of the half-period map.
//!
//! H, half a period of motion followed by S's mirror, is a map whose square is the period's, and it sees one
//! stop of the two; the symmetric motion is its fixed point. With Φ the flow over half a period it has A =
//! −Φ, and B, C, a_G and e of either stop alone. Patterns count halves, and the stops alternate with them.

use std::f64::consts::PI;

use super::{
    free::{FreeMotion, LeastGap},
    local_map::local_map,
};
use crate::{
    continuation::LocalMap,
    error::Result,
    many::{RealVector, contact::StopContact},
    motion::Series,
    rounding::PHASE,
};

/// The local map over half a period.
#[derive(Debug, Clone)]
pub struct HalfPeriod {
    /// The map.
    pub(crate) map: LocalMap,
    /// The stop that mirrors the one that is grazed.
    pub(crate) mirror: usize,
}

impl HalfPeriod {
    /// The map where the motion grazes a stop and another at the same time, if the machine is symmetric and
    /// the other is the mirror of the first.
    ///
    /// # Errors
    /// Those of [`local_map`].
    pub(super) fn new(motion: &FreeMotion, at: &LeastGap, others: &[LeastGap]) -> Result<Option<HalfPeriod>> {
        // Of formulas it is not known whether they are their own mirror image.
        if motion.stage.is_some() {
            return Ok(None);
        }
        let ([other], Some(mirror)) = (others, mirror(motion, at.stop)) else { return Ok(None) };
        let apart = (other.phase - at.phase).abs();
        if other.stop != mirror || (apart - PI).abs() > PHASE {
            return Ok(None);
        }
        Ok(Some(HalfPeriod { map: local_map(motion, at, PI)?, mirror }))
    }
}

/// The mirror of a stop, if S takes the machine to itself: a force of odd harmonics, and each stop with its
/// mirror.
fn mirror(motion: &FreeMotion, stop: usize) -> Option<usize> {
    let (force, all) = (&motion.equations.force, motion.contacts().all());
    let still = |v: &RealVector| v.iter().all(|x| *x == 0.0);
    let odd = |(k, a, b): &(u32, RealVector, RealVector)| k % 2 == 1 || still(a) && still(b);
    let of = |one: &StopContact| all.iter().position(|other| mirrored(one, other));
    let symmetric = still(&force.mean) && force.harmonics.iter().all(odd);
    (symmetric && all.iter().all(|one| of(one).is_some())).then(|| of(&all[stop])).flatten()
}

/// Whether the second stop is S of the first: w₂ = −w₁, Q₂(t + π) = Q₁(t).
fn mirrored(one: &StopContact, other: &StopContact) -> bool {
    let amplitude = |series: &Series, k: u32| {
        let all = series.harmonics().iter().filter(|h| h.k == k);
        all.fold([0.0, 0.0], |[cos, sin], h| [cos + h.cos, sin + h.sin])
    };
    let moves = |k: u32| {
        let sign = if k % 2 == 1 { -1.0 } else { 1.0 };
        amplitude(&other.position, k) == amplitude(&one.position, k).map(|x| sign * x)
    };
    one.row == -&other.row
        && one.restitution == other.restitution
        && one.soft == other.soft
        && one.law == other.law
        && one.position.mean() == other.position.mean()
        && one.position.harmonics().iter().chain(other.position.harmonics()).all(|h| moves(h.k))
}
