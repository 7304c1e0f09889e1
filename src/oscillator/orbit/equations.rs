//! The pattern equations (19) of the true system.
//!
//! The unknowns are the impact times and incoming relative speeds z = (t₁, V₁, …, t_m, V_m), t_i any real number near the
//! phase of impact i. From impact i the motion goes on without impacts for 2π n_i + t_{i+1} − t_i and must arrive at the next
//! wall with the next speed:
//!
//! ```text
//! σ (q − Q(t_{i+1})) = 0,    σ (u − Q′(t_{i+1})) + V_{i+1} = 0      (cyclic in i; σ = ±1: lower, upper wall)
//! ```
//!
//! They are smooth, and their determinant is not small, where an impact has V = 0, where other minima of the gap pass through
//! zero, and for V < 0: whether the solution is an orbit is a separate question (`admissible`). Without
//! impacts the unknowns are (q, u) at t = 0, and the equations say that the period returns them.

use std::f64::consts::PI;

use super::{
    super::{
        algebra::apply,
        flow::{Flow, State},
    },
    Itinerary, Leg, Oscillator,
};
use crate::error::{Error, Result};

/// The equations at one z: F, ∂F/∂z by rows, ∂F/∂p.
#[derive(Debug, Clone)]
pub struct Linearised {
    /// F.
    pub residual: Vec<f64>,
    /// ∂F/∂z.
    pub jacobian: Vec<Vec<f64>>,
    /// ∂F/∂p; zeros if the oscillator has no slope.
    pub slope: Vec<f64>,
}

/// How long impact i's motion lasts.
pub fn duration(itinerary: &Itinerary, z: &[f64], i: usize) -> f64 {
    let m = itinerary.strikes().len();
    2.0 * PI * f64::from(itinerary.strikes()[i].periods) + z[2 * ((i + 1) % m)] - z[2 * i]
}

/// The equations and their derivatives. Cost: m flows with variations, and O(m²) memory.
///
/// # Errors
/// An input error if a wall is missing, a duration is negative or 0, or z has the wrong length.
pub fn linearise(oscillator: &Oscillator, itinerary: &Itinerary, z: &[f64]) -> Result<Linearised> {
    let strikes = itinerary.strikes();
    let m = strikes.len();
    if z.len() != (2 * m).max(2) {
        return Err(Error::input(format!("{} unknowns for the pattern {itinerary}", z.len())));
    }
    if m == 0 {
        return Ok(free(oscillator, itinerary, z));
    }
    let mut found = Linearised {
        residual: vec![0.0; 2 * m],
        jacobian: vec![vec![0.0; 2 * m]; 2 * m],
        slope: vec![0.0; 2 * m],
    };
    for (i, strike) in strikes.iter().enumerate() {
        let next = (i + 1) % m;
        let (t, speed, t_next, speed_next) = (z[2 * i], z[2 * i + 1], z[2 * next], z[2 * next + 1]);
        let time = duration(itinerary, z, i);
        if time.is_nan() || time <= 0.0 {
            return Err(Error::input(format!("impact {} would come before impact {i}", i + 1)));
        }
        let here = oscillator.touch(strike.side, t)?;
        let there = oscillator.touch(strikes[next].side, t_next)?;
        let (tau, here_sign) = (here.wall.restitution, strike.side.sign());
        let from = here.leaving(t, tau * speed);
        let Leg { end, matrix, slope } = oscillator.leg(from, time);
        let sign = there.wall.side.sign();
        // Starting later is starting displaced: by what the wall and the orbit move in between, reversed.
        let delayed = [here.motion[1] - from.u, here.motion[2] - oscillator.flow().acceleration(from)];
        let kicked = [0.0, here_sign * tau];
        let changed = [here.slope[0], here.slope[1] + here_sign * here.restitution_slope * speed];
        let [delayed, kicked, changed] = [delayed, kicked, changed].map(|x| apply(&matrix, x));
        let arrival = [end.u - there.motion[1], oscillator.flow().acceleration(end) - there.motion[2]];
        let gap = [end.q - there.motion[0], arrival[0]];
        for row in [0, 1] {
            let r = 2 * i + row;
            found.residual[r] = sign * gap[row];
            found.slope[r] = sign * (changed[row] + slope[row] - there.slope[row]);
            // Added, not set: with m = 1 both ends are the same impact.
            let entries = &mut found.jacobian[r];
            entries[2 * i] += sign * delayed[row];
            entries[2 * i + 1] += sign * kicked[row];
            entries[2 * next] += sign * arrival[row];
        }
        found.residual[2 * i + 1] += speed_next;
        found.jacobian[2 * i + 1][2 * next + 1] += 1.0;
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
