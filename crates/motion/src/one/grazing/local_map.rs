//! The local map at a grazing orbit, from flow and saltation matrices.

use crate::{
    continuation::{Known, LocalMap, Multipliers},
    error::{Error, Result},
    motion::{
        Flow,
        algebra::{IDENTITY, Matrix2, add, apply, product, resolve},
    },
    one::orbit::{Itinerary, Leg, Oscillator, Unknowns, flow_determinant},
    rounding::SUM,
};

/// The map at a solution whose first impact has speed 0, and the derivative in the parameter of the orbit's
/// (q, u) less the wall's at the phase of grazing: of (40)–(44), C = (±1, 0), B = ±(0, √(2a_G)(1+τ)).
///
/// # Errors
/// An input error where det(I − A) = 0, and where the system is not defined.
pub(super) fn local_map(oscillator: &Oscillator, itinerary: &Itinerary, z: &[f64]) -> Result<LocalMap> {
    let strikes = itinerary.strikes();
    let touch = oscillator.touch(strikes[0].place, z[0])?;
    let (sign, graze) = (touch.wall.side.sign(), touch.leaving(z[0], 0.0));
    let (mut a, mut shift) = (IDENTITY, [0.0; 2]);
    for passage in Unknowns::new(itinerary, z)?.passages(oscillator) {
        let passage = passage?;
        let Leg { matrix, slope, .. } = passage.fly();
        a = product(&matrix, &a);
        shift = add(apply(&matrix, shift), slope);
        if passage.next != 0 {
            let (jump, slope) = passage.saltation();
            a = product(&jump, &a);
            shift = add(apply(&jump, shift), slope);
        }
    }
    // x̃ = A x̃ + shift, from which the wall's own motion is taken.
    let moved = resolve(&a, shift).ok_or_else(|| Error::input("det(I − A) = 0 at the grazing orbit (23)"))?;
    // The grazing impact itself does nothing: its factor τ² is left out.
    let flow = flow_determinant(oscillator, itinerary, z)?;
    let multipliers = Multipliers::with(&a, flow, oscillator, &strikes[1..]);
    let [e, rate_drift] = [0, 1].map(|i| sign * (moved[i] - touch.slope[i]));
    let acceleration = sign * (oscillator.flow().acceleration(graze) - touch.motion[2]);
    let kick = sign * (2.0 * acceleration).sqrt() * (1.0 + touch.wall.restitution);
    Ok(in_plane(&a, multipliers, [kick, sign], [e, rate_drift, acceleration]))
}

/// Every computed entry may be off by 10⁻¹² of the largest of A.
pub(super) fn in_plane(
    a: &Matrix2,
    multipliers: Multipliers,
    [kick, sign]: [f64; 2],
    [e, rate_drift, acceleration]: [f64; 3],
) -> LocalMap {
    let largest = a.as_flattened().iter().fold(1.0, |most: f64, x| most.max(x.abs()));
    let near = |x: f64| (x, SUM * largest.max(x.abs()));
    LocalMap {
        a: a.map(|row| row.to_vec()).to_vec(),
        b: vec![0.0, kick],
        c: vec![sign, 0.0],
        e,
        acceleration,
        rate_drift,
        determinant: multipliers.determinant,
        eigenvalues: multipliers.values().to_vec(),
        known: Known {
            a: a.map(|row| row.map(near).to_vec()).to_vec(),
            b: vec![(0.0, 0.0), near(kick)],
            c: vec![(sign, 0.0), (0.0, 0.0)],
            e: near(e),
            outward: None,
        },
    }
}
