//! The local map at a grazing of the motion without impacts, from its flow and the mobility at the stop.

use std::f64::consts::TAU;

use super::free::{FreeMotion, LeastGap};
use crate::{
    continuation::{Known, LocalMap, Near},
    error::Result,
    many::{
        LinearFlow, RealMatrix, RealVector,
        algebra::{eigenvalues, stacked},
        pair::Pair,
    },
    rounding::SUM,
};

/// The map at a minimum of a gap that is zero, over `span`: 2π, or π where all is mirrored after it. An a_G
/// that is not positive is for [`LocalMap::to_map`] to refuse.
///
/// # Errors
/// Those of [`LinearFlow::new`]; eigenvalues of A that are not found.
pub(super) fn local_map(motion: &FreeMotion, at: &LeastGap, span: f64) -> Result<LocalMap> {
    let (contact, push) = (&motion.contacts().all()[at.stop], motion.contacts().push(at.stop));
    let n = motion.equations.size();
    let [gap, slope] = &motion.gaps[at.stop];
    let (acceleration, [e, rate_drift, _]) = (gap.at(at.phase)[2], slope.at(at.phase));
    let state = motion.motion().state(at.phase);
    let smooth = motion.stage.as_ref().and_then(|stage| stage.smooth.as_ref());
    // 2n is even: the mirror does not change the determinant.
    let (a, determinant, flow) = match smooth {
        None => {
            let flow = LinearFlow::new(motion.equations.clone())?;
            (flow.transition(span) * mirrors(span), motion.equations.determinant(span), Some(flow))
        }
        Some(smooth) => {
            let a = smooth.transition(&state, span) * mirrors(span);
            (a, smooth.determinant(&state, span), None)
        }
    };
    // A stop that gives way does not turn velocities at once: its map has no square root.
    let factor = if contact.soft.is_some() { 0.0 } else { 1.0 + contact.restitution };
    let kick = (2.0 * acceleration.max(0.0)).sqrt() * factor;
    let change = push * (kick / motion.contacts().mobility(at.stop));
    let zero = RealVector::zeros(n);
    let (b, c) = (stacked(&zero, &change), stacked(&contact.row, &zero));
    Ok(LocalMap {
        known: match &flow {
            Some(flow) => in_blocks(flow, span, [&change, &contact.row], e),
            None => whole(&a, [&b, &c], CONDITION, e),
        },
        b: b.as_slice().to_vec(),
        c: c.as_slice().to_vec(),
        e,
        acceleration,
        rate_drift,
        determinant,
        eigenvalues: eigenvalues(&a, determinant)?,
        a: by_rows(&a),
    })
}

/// What the condition of coordinates is taken for where it is not known.
const CONDITION: f64 = 10.0;

/// The map in the coordinates in which the flow falls apart, so that A is made of blocks of two and intervals
/// stay narrow in any dimension. Every computed entry may be off by 10⁻¹² of the largest of its block, more
/// for fast modes and for nearly dependent ones. What is zero by structure is exactly zero.
fn in_blocks(flow: &LinearFlow, span: f64, [change, row]: [&RealVector; 2], e: f64) -> Known {
    let condition = if flow.condition().is_finite() { flow.condition() } else { CONDITION };
    let (own, rates) = (flow.matrix(span) * mirrors(span), flow.rates());
    let vectors = [&flow.kick(change), &flow.seen(row, &RealVector::zeros(row.len()))];
    let known = Known { outward: Some(by_rows(flow.from())), ..whole(&own, vectors, condition, e) };
    let Some(pairs) = flow.pairs() else { return known };
    let entry = |i: usize, j: usize| {
        if i / 2 != j / 2 || i != j && matches!(pairs[i / 2], Pair::Two(_)) {
            return (0.0, 0.0);
        }
        let first = i / 2 * 2;
        let largest = own.view((first, first), (2, 2)).amax();
        // The phase of a fast mode after a period is off by some ε times its rate.
        (own[(i, j)], SUM.max(64.0 * f64::EPSILON * rates[i / 2]) * condition * largest)
    };
    let size = own.nrows();
    Known { a: (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect(), ..known }
}

/// The map in coordinates that couple everything.
fn whole(a: &RealMatrix, [b, c]: [&RealVector; 2], condition: f64, e: f64) -> Known {
    let off = SUM * condition * a.amax().max(1.0);
    let vector = |v: &RealVector| v.iter().map(|&x| (x, SUM * condition * x.abs())).collect::<Vec<Near>>();
    let a = by_rows(a).into_iter().map(|row| row.into_iter().map(|x| (x, off)).collect()).collect();
    Known { a, b: vector(b), c: vector(c), e: (e, SUM * e.abs()), outward: None }
}

fn by_rows(matrix: &RealMatrix) -> Vec<Vec<f64>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}

/// 1 for a whole period, −1 for half of one, after which all is mirrored.
fn mirrors(span: f64) -> f64 {
    if span < TAU { -1.0 } else { 1.0 }
}
