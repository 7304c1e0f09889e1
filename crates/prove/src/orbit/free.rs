//! Proofs about the motion without impacts, which is the response to the forcing: that no other one has its
//! period, that it is clear of every wall, and that it is stable or not.

use num_rational::BigRational;

use super::{
    Bounded, Jet, Stability, Units, Verdict, admissible, coefficient::bounded, equations::Equations,
    event::is_alone, linear::Linear, solution::stability,
};
use crate::{
    error::Result,
    motion::System,
    number::{Ball, Elementary, Precision, Real},
};

/// A proved motion without impacts.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct ProvedFreeMotion {
    /// The trace of the motion between impacts over a period.
    pub trace: Ball,
    /// Its determinant.
    pub determinant: Ball,
    /// Where its eigenvalues are, if the enclosures tell.
    pub stability: Option<Stability>,
    /// In what it was proved.
    pub units: Units,
    /// The pieces of the period by which it was proved.
    pub(super) pieces: Vec<BigRational>,
}

/// Proves that the response to the forcing is the only motion of its period without impacts and that every
/// gap is positive on it. Cost: O(1) evaluations of the motion, more of them the nearer it comes to a wall.
///
/// # Errors
/// An input error: the system is not linear, no stiffness, an undamped resonance.
pub fn free_motion(
    system: &System<impl Bounded>,
    precision: &Precision,
) -> Result<Verdict<ProvedFreeMotion>> {
    let units = Units::of(&bounded(system), std::iter::empty());
    let linear = Linear::of(&units.bounded(system), precision)?;
    if !is_alone(&linear) {
        return Ok(Verdict::Undecided("1 may be a multiplier of the motion without impacts".into()));
    }
    let equations = Equations { linear: &linear, impacts: &[] };
    admissible::prove(&equations, &[], None)?.and_then(|mut pieces| {
        let turn = Jet::pi(precision) * &Jet::integer(2, precision);
        let [[a, b], [c, d]] = linear.propagator(&turn);
        let determinant = (a.clone() * &d - &(b * &c)).value;
        let trace = (a + &d).value;
        let stability = stability(&trace, &determinant, precision);
        let pieces = pieces.swap_remove(0);
        Ok(Verdict::Proved(ProvedFreeMotion { trace, determinant, stability, units, pieces }))
    })
}
