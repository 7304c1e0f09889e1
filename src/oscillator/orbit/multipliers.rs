//! The multipliers of an orbit: the eigenvalues of its 2 × 2 monodromy matrix.

use std::f64::consts::TAU;

use super::{
    super::{
        algebra::{Matrix2, trace},
        flow::State,
    },
    Itinerary, Oscillator, Strike, Unknowns,
};
use crate::error::Result;

/// The two multipliers, by their sum and product.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Multipliers {
    /// λ₁ + λ₂.
    pub trace: f64,
    /// λ₁λ₂.
    pub determinant: f64,
}

impl Multipliers {
    /// Those of the monodromy matrix of the orbit z. The determinant is Π τ² exp ∫ ∂q″/∂q′ dt once round it,
    /// with as many digits where those of the matrix are lost by cancellation.
    ///
    /// # Errors
    /// Those of [`flow_determinant`].
    pub fn new(
        matrix: &Matrix2,
        oscillator: &Oscillator,
        itinerary: &Itinerary,
        z: &[f64],
    ) -> Result<Multipliers> {
        let flow = flow_determinant(oscillator, itinerary, z)?;
        Ok(Multipliers::with(matrix, flow, oscillator, itinerary.strikes()))
    }

    /// The same with the determinant of all motion between impacts, and of these impacts only.
    pub(in super::super) fn with(
        matrix: &Matrix2,
        flow: f64,
        oscillator: &Oscillator,
        impacts: &[Strike],
    ) -> Multipliers {
        let kept = impacts.iter().map(|strike| oscillator.restitution(strike.side).powi(2));
        Multipliers { trace: trace(matrix), determinant: flow * kept.product::<f64>() }
    }

    /// λ₁ and λ₂ as (real, imaginary) parts, the larger modulus or the positive imaginary part first.
    pub fn values(&self) -> [(f64, f64); 2] {
        let half = self.trace / 2.0;
        let discriminant = half * half - self.determinant;
        if discriminant < 0.0 {
            let imaginary = (-discriminant).sqrt();
            return [(half, imaginary), (half, -imaginary)];
        }
        // The larger without cancellation, the smaller from the product.
        let larger = half + discriminant.sqrt().copysign(half);
        let smaller = if larger == 0.0 { 0.0 } else { self.determinant / larger };
        [(larger, 0.0), (smaller, 0.0)]
    }

    /// Whether both are inside the unit circle (Jury): |tr| < 1 + det and det < 1.
    pub fn is_stable(&self) -> bool {
        self.fold().min(self.flip()) > 0.0 && self.determinant < 1.0
    }

    /// (1 − λ₁)(1 − λ₂): 0 where a multiplier is 1, at a saddle-node.
    pub fn fold(&self) -> f64 {
        1.0 - self.trace + self.determinant
    }

    /// (1 + λ₁)(1 + λ₂): 0 where a multiplier is −1, at a flip.
    pub fn flip(&self) -> f64 {
        1.0 + self.trace + self.determinant
    }
}

/// How much the motion between impacts shrinks areas once round the orbit z: exp ∫ ∂q″/∂q′ dt.
///
/// # Errors
/// An input error if a wall is missing or z has the wrong length.
pub fn flow_determinant(oscillator: &Oscillator, itinerary: &Itinerary, z: &[f64]) -> Result<f64> {
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
