//! The determinant of an orbit's monodromy matrix from the divergence of the flow and from its impacts: with
//! as many digits where those of the matrix are lost by cancellation.

use std::f64::consts::TAU;

use super::{Itinerary, Oscillator, Strike, Unknowns};
use crate::{
    continuation::Multipliers,
    error::Result,
    motion::{
        State,
        algebra::{Matrix2, trace},
    },
};

impl Multipliers {
    /// Those of the monodromy matrix of the orbit z. The determinant is Π τ² exp ∫ ∂q″/∂q′ dt once round it,
    /// with as many digits where those of the matrix are lost by cancellation.
    ///
    /// # Errors
    /// Those of [`flow_determinant`].
    pub(crate) fn new(
        matrix: &Matrix2,
        oscillator: &Oscillator,
        itinerary: &Itinerary,
        z: &[f64],
    ) -> Result<Multipliers> {
        let flow = flow_determinant(oscillator, itinerary, z)?;
        Ok(Multipliers::with(matrix, flow, oscillator, itinerary.strikes()))
    }

    /// The same with the determinant of all motion between impacts, and of these impacts only.
    pub(crate) fn with(
        matrix: &Matrix2,
        flow: f64,
        oscillator: &Oscillator,
        impacts: &[Strike],
    ) -> Multipliers {
        let kept = impacts.iter().map(|strike| oscillator.restitution(strike.place).powi(2));
        Multipliers { trace: trace(matrix), determinant: flow * kept.product::<f64>() }
    }
}

/// How much the motion between impacts shrinks areas once round the orbit z: exp ∫ ∂q″/∂q′ dt.
///
/// # Errors
/// An input error if a wall is missing or z has the wrong length.
pub(crate) fn flow_determinant(oscillator: &Oscillator, itinerary: &Itinerary, z: &[f64]) -> Result<f64> {
    let (flow, period) = (oscillator.flow(), TAU * f64::from(itinerary.periods()));
    if let Some(rate) = flow.equation().constant_divergence() {
        return Ok((rate * period).exp());
    }
    if itinerary.strikes().is_empty() {
        return Ok(flow.determinant(State { t: 0.0, q: z[0], u: z[1] }, period));
    }
    let passages = Unknowns::new(itinerary, z)?.passages(oscillator);
    passages.map(|passage| passage.map(|one| flow.determinant(one.from, one.duration))).product()
}
