//! The pattern equations (19) of the true system.
//!
//! The unknowns are the impact times and incoming relative speeds z = (t₁, V₁, …, t_m, V_m), t_i any real
//! number near the phase of impact i. From impact i the motion goes on without impacts for 2π n_i + t_{i+1} −
//! t_i and must arrive at the next wall with the next speed:
//!
//! ```text
//! σ (q − Q(t_{i+1})) = 0,    σ (u − Q′(t_{i+1})) + V_{i+1} = 0      (cyclic in i; σ = ±1: lower, upper wall)
//! ```
//!
//! They are smooth, and their determinant is not small, where an impact has V = 0, where other minima of the
//! gap pass through zero, and for V < 0: whether the solution is an orbit is a separate question
//! (`admissible`). Without impacts the unknowns are (q, u) at t = 0, and the equations say that the period
//! returns them.

use std::f64::consts::PI;

use super::{
    Itinerary, Leg, Oscillator,
    passage::{Arrival, Passage, Unknowns},
};
use crate::{
    continuation::Linearised,
    error::{Error, Result},
    motion::State,
};

/// The equations and their derivatives. Cost: m flows with variations, and O(m²) memory.
///
/// # Errors
/// An input error if a wall is missing, a duration is negative or 0, or z has the wrong length.
pub fn linearise(oscillator: &Oscillator, itinerary: &Itinerary, z: &[f64]) -> Result<Linearised> {
    let unknowns = Unknowns::new(itinerary, z)?;
    let m = itinerary.strikes().len();
    if m == 0 {
        return Ok(free(oscillator, itinerary, z));
    }
    // With room for one unknown and one equation more: those of a branch.
    let zeros = || {
        let mut zeros = Vec::with_capacity(2 * m + 1);
        zeros.resize(2 * m, 0.0);
        zeros
    };
    let mut jacobian = Vec::with_capacity(2 * m + 1);
    jacobian.extend((0..2 * m).map(|_| zeros()));
    let mut found = Linearised { residual: zeros(), jacobian, slope: vec![0.0; 2 * m] };
    for passage in unknowns.passages(oscillator) {
        let passage = passage?;
        let Passage { index, next, duration, .. } = passage;
        if duration.is_nan() || duration <= 0.0 {
            return Err(Error::input(format!("impact {} would come before impact {index}", index + 1)));
        }
        let Arrival { residual, departure, arrival, slope } = passage.equations();
        for row in [0, 1] {
            let r = 2 * index + row;
            (found.residual[r], found.slope[r]) = (residual[row], slope[row]);
            // Added, not set: with m = 1 both ends are the same impact.
            for column in [0, 1] {
                found.jacobian[r][2 * index + column] += departure[row][column];
                found.jacobian[r][2 * next + column] += arrival[row][column];
            }
        }
    }
    Ok(found)
}

fn free(oscillator: &Oscillator, itinerary: &Itinerary, z: &[f64]) -> Linearised {
    let start = State { t: 0.0, q: z[0], u: z[1] };
    let Leg { end, matrix, slope } = oscillator.leg(start, 2.0 * PI * f64::from(itinerary.periods()));
    Linearised {
        residual: vec![z[0] - end.q, z[1] - end.u],
        jacobian: vec![vec![1.0 - matrix[0][0], -matrix[0][1]], vec![-matrix[1][0], 1.0 - matrix[1][1]]],
        slope: vec![-slope[0], -slope[1]],
    }
}
