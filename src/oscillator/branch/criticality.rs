//! Which way a bifurcation on a branch goes: the coefficient of its normal form, by derivatives of the
//! Poincaré map.

use super::Bifurcation;
use crate::oscillator::{
    algebra::{Matrix2, apply, determinant, product},
    orbit::{Criticality, Derivatives, Orbit, Oscillator, Unknowns, return_map},
};

/// The normal form of a bifurcation: see [`Derivatives`] for what the coefficient is.
///
/// With linear damping Re d = 0 at every Neimark–Sacker point. Between impacts the area dq du then shrinks by
/// e^{−ct}, c the damping, whatever the stiffness and the forcing; an impact with restitution τ at a wall
/// multiplies V dt dV by τ². Hence the Poincaré map, its time counted from one passage of the orbit to the
/// next, multiplies the form e^{ct} V dt dV by the orbit's own determinant Π τ² e^{−cT}. Where that is 1,
/// which only damping and restitution can bring about, the map keeps an area, and its normal form is a
/// rotation to every order: no closed curve is born, motions wind in or out at all amplitudes alike. With any
/// other damping, written as a formula, areas shrink along one motion and not along its neighbour, and Re d
/// is a number like the others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalForm {
    /// a (saddle-node), c (crossing with a = 0: a pitchfork), a (any other crossing), b (flip), Re d
    /// (Neimark–Sacker).
    pub coefficient: f64,
    /// What it means.
    pub kind: Sense,
}

/// Which way a bifurcation goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sense {
    /// What is born is stable in the critical direction, or not.
    Born(Criticality),
    /// A saddle-node: both orbits exist above the parameter's value.
    Above,
    /// A saddle-node: both orbits exist below.
    Below,
    /// Two branches that go on on both sides and exchange their stability.
    Transcritical,
    /// The coefficient is zero to rounding: the bifurcation is of higher codimension.
    Degenerate,
}

/// Relative to the derivatives that it is made of, a coefficient smaller than this is rounding's.
const ROUNDING: f64 = 1e-12;

impl NormalForm {
    /// The normal form of a bifurcation of an orbit; none for grazing and fading, where the Poincaré map is
    /// not smooth, and where it cannot be computed, as at a double multiplier. The oscillator needs slopes
    /// for a saddle-node's side. Cost: that of [`return_map`].
    pub fn at(oscillator: &Oscillator, orbit: &Orbit, bifurcation: Bifurcation) -> Option<NormalForm> {
        if matches!(bifurcation, Bifurcation::Grazing | Bifurcation::Fade) {
            return None;
        }
        let map = return_map(oscillator, &orbit.itinerary, &orbit.z).ok()?;
        let derivatives = Derivatives::of(&map);
        // At a double multiplier the critical direction is no direction of its own, and the coefficients have
        // no meaning.
        let double = (orbit.multipliers.determinant - 1.0).abs() <= 1e-9;
        let one = !matches!(bifurcation, Bifurcation::Torus);
        if one && double {
            return None;
        }
        let size = map[0].size().max(map[1].size()).max(1.0);
        let small = |x: f64| x.abs() <= ROUNDING * size * size;
        let born = |coefficient: f64, stable: bool| {
            let criticality = if stable { Criticality::Supercritical } else { Criticality::Subcritical };
            let kind = if small(coefficient) { Sense::Degenerate } else { Sense::Born(criticality) };
            NormalForm { coefficient, kind }
        };
        Some(match bifurcation {
            Bifurcation::SaddleNode => {
                let a = derivatives.fold()?;
                let [p, shift] = [derivatives.fold_normal()?, parameter_shift(oscillator, orbit)?];
                let drift = p[0] * shift[0] + p[1] * shift[1];
                // ξ ↦ ξ + drift (µ − µ_sn) + a ξ²: fixed points where both terms can cancel.
                let kind = match () {
                    () if small(a) || drift == 0.0 => Sense::Degenerate,
                    () if (drift < 0.0) == (a > 0.0) => Sense::Above,
                    () => Sense::Below,
                };
                NormalForm { coefficient: a, kind }
            }
            Bifurcation::Crossing => {
                let a = derivatives.fold()?;
                // The point is exact to rounding, the multiplier to its square root.
                if a.abs() > 1e-8 * size * size {
                    return Some(NormalForm { coefficient: a, kind: Sense::Transcritical });
                }
                let c = derivatives.pitchfork()?;
                born(c, c < 0.0)
            }
            Bifurcation::Flip => {
                let b = derivatives.flip()?;
                born(b, b > 0.0)
            }
            _ => {
                let d = derivatives.torus()?;
                match oscillator.flow().equation().constant_divergence() {
                    // Zero but for rounding.
                    Some(_) => NormalForm { coefficient: d, kind: Sense::Degenerate },
                    None => born(d, d < 0.0),
                }
            }
        })
    }

    /// Its word.
    pub fn name(&self) -> &'static str {
        match self.kind {
            Sense::Born(criticality) => criticality.name(),
            Sense::Above => "above",
            Sense::Below => "below",
            Sense::Transcritical => "transcritical",
            Sense::Degenerate => "degenerate",
        }
    }
}

/// The derivative of the Poincaré map in the parameter: of (t, V) at the first impact, or of (q, u) without
/// impacts.
fn parameter_shift(oscillator: &Oscillator, orbit: &Orbit) -> Option<[f64; 2]> {
    if orbit.itinerary.strikes().is_empty() {
        let slope = crate::oscillator::orbit::linearise(oscillator, &orbit.itinerary, &orbit.z).ok()?.slope;
        return Some([-slope[0], -slope[1]]);
    }
    let mut shift = [0.0; 2];
    for passage in Unknowns::new(&orbit.itinerary, &orbit.z).ok()?.passages(oscillator) {
        let equations = passage.ok()?.equations();
        let back = inverse(&equations.arrival)?;
        let through = product(&back, &equations.departure);
        let (carried, added) = (apply(&through, shift), apply(&back, equations.slope));
        shift = [0, 1].map(|i| -(carried[i] + added[i]));
    }
    Some(shift)
}

fn inverse(m: &Matrix2) -> Option<Matrix2> {
    let det = determinant(m);
    (det != 0.0).then(|| [[m[1][1] / det, -m[0][1] / det], [-m[1][0] / det, m[0][0] / det]])
}
