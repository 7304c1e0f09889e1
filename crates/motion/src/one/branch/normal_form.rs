//! The normal form of a bifurcation of an oscillator's orbit, from the expansion of its Poincaré map.

use crate::{
    continuation::{
        Bifurcation, DOUBLE, Derivatives, Estimate, FollowedOrbit, NOT_SMOOTH, NoForm, NormalForm, Sense,
        UNKNOWN,
    },
    motion::algebra::{apply, inverse, product},
    one::orbit::{Orbit, Oscillator, Unknowns, return_map},
};

impl NormalForm {
    /// The normal form of a bifurcation of an orbit; the oscillator needs slopes for a saddle-node's side.
    /// Cost: five times that of [`return_map`].
    ///
    /// # Errors
    /// Why there is none: at grazing and fading the Poincaré map is not smooth, at a double multiplier the
    /// critical direction is no direction of its own.
    pub fn at(
        oscillator: &Oscillator,
        orbit: &Orbit,
        bifurcation: Bifurcation,
    ) -> Result<NormalForm, NoForm> {
        if matches!(bifurcation, Bifurcation::Grazing | Bifurcation::Fade) || bifurcation.is_sliding() {
            return Err(NOT_SMOOTH);
        }
        let double = (orbit.multipliers.determinant - 1.0).abs() <= 1e-9;
        if double && bifurcation != Bifurcation::Torus {
            return Err(DOUBLE);
        }
        let estimate = |number: &dyn Fn(&Derivatives, &Orbit) -> Option<f64>| {
            let at = |z: &[f64], factors: &[f64]| {
                let map = return_map(oscillator, &orbit.itinerary, z).ok()?;
                number(&Derivatives::of(&map).scaled(factors), &orbit.with(z))
            };
            Estimate::of_map(&orbit.z, |i| orbit.is_time(i), at).ok_or(UNKNOWN)
        };
        Ok(match bifurcation {
            Bifurcation::SaddleNode => {
                let turn = estimate(&|map, orbit| {
                    let [p, shift] = [map.fold_normal()?, parameter_shift(oscillator, orbit)?];
                    Some(map.fold()? * (p[0] * shift[0] + p[1] * shift[1]))
                })?;
                estimate(&|map, _| map.fold())?.fold(turn)
            }
            Bifurcation::Crossing => {
                let a = estimate(&|map, _| map.fold())?;
                if !a.is_zero() {
                    return Ok(NormalForm { coefficient: a.value, kind: Sense::Transcritical });
                }
                estimate(&|map, _| map.pitchfork())?.born(|c| c < 0.0)
            }
            Bifurcation::Flip => estimate(&|map, _| map.flip())?.born(|b| b > 0.0),
            // With linear damping zero, as far as can be told.
            _ => estimate(&|map, _| map.torus())?.born(|d| d < 0.0),
        })
    }
}

/// The derivative of the Poincaré map in the parameter: of (t, V) at the first impact, or of (q, u) without
/// impacts.
fn parameter_shift(oscillator: &Oscillator, orbit: &Orbit) -> Option<[f64; 2]> {
    if orbit.itinerary.strikes().is_empty() {
        let slope = crate::one::orbit::linearise(oscillator, &orbit.itinerary, &orbit.z).ok()?.slope;
        return Some([-slope[0], -slope[1]]);
    }
    let mut shift = [0.0; 2];
    for passage in Unknowns::new(&orbit.itinerary, &orbit.z).ok()?.passages(oscillator) {
        let equations = passage.ok()?.equations();
        let back = inverse(&equations.arrival);
        let through = product(&back, &equations.departure);
        let (carried, added) = (apply(&through, shift), apply(&back, equations.slope));
        shift = [0, 1].map(|i| -(carried[i] + added[i]));
    }
    shift.iter().all(|x| x.is_finite()).then_some(shift)
}
