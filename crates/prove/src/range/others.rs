//! Where what is born is proved: that there is nothing else near, cell by cell; of bounded motions, before
//! the touch.
//!
//! Near reaches as far as the strengths of what is born, and farther where the checker can be shown that; the
//! claims are added to the cells that have them from the touch on.

use super::{
    RangeEffort,
    map::{Edges, Oscillator},
    nothing::longest,
    write,
};
use crate::{
    certificate::range::{Alone, Certificate, Others, others_hold},
    chaos::{span::Span, write::decimal},
    error::Result,
    monitor::Monitor,
};

/// S, in the greatest |s| of the cell, from the widest; what is cut into how many parts, from the coarsest.
const WIDER: [f64; 4] = [1.5, 1.3, 1.1, 1.02];
const PARTS: [[u64; 2]; 6] = [[2, 1], [2, 2], [4, 1], [2, 4], [4, 4], [8, 4]];
/// The longest legs before the touch that are looked at, and how much longer they may become in later cells.
const LONGEST: u64 = 200;
const LONGER: u64 = 3;
/// Rounds of C3, and of F.
const ROUNDS: u64 = 6;

/// The certificate with claims that there are no others, in as many cells from the touch on as have one; none
/// if the first has none. Strengths and parts that did for a cell are tried first for the next.
pub(super) fn alone(
    certificate: &Certificate,
    oscillator: &Oscillator,
    effort: &RangeEffort,
    monitor: &dyn Monitor,
) -> Result<Option<Certificate>> {
    let periods: Vec<u64> = certificate.letters.iter().map(|letter| letter.periods).collect();
    let distinct = (1..periods.len()).all(|n| !periods[..n].contains(&periods[n]));
    let most = if certificate.behind { longest(oscillator) } else { settling(certificate, oscillator) };
    let Some(longest) = most.filter(|_| distinct) else { return Ok(None) };
    let mut found = Certificate { alone: Some(Alone { longest, rounds: ROUNDS }), ..certificate.clone() };
    let mut first = [0, 0];
    for cell in 0..found.cells.len() {
        let ways =
            (first[1]..PARTS.len()).flat_map(|cut| (first[0]..WIDER.len()).map(move |wide| [wide, cut]));
        let mut held = None;
        for [wide, cut] in ways {
            monitor.advance(0)?;
            let strength = decimal((greatest(&found, cell) * WIDER[wide] * 1000.0).ceil() / 1000.0, 3)?;
            let [parts, slices] = PARTS[cut];
            found.cells[cell].others = Some(Others { strength, parts, slices });
            if effort.judged(|| others_hold(&found, cell, &mut || effort.stops())).is_ok() {
                held = Some([wide, cut]);
            }
            if held.is_some() || effort.is_spent() {
                break;
            }
        }
        let Some(way) = held else {
            found.cells[cell].others = None;
            break;
        };
        first = way;
    }
    Ok(found.cells[0].others.is_some().then_some(found))
}

/// The longest leg of bounded motions before the touch, in floats: as the checker bounds it in the first
/// cell, and in later ones where it is not much longer.
fn settling(certificate: &Certificate, oscillator: &Oscillator) -> Option<u64> {
    let of = |cell: usize| {
        let depth = &certificate.cells[cell].depth;
        let depths = oscillator.depths(Span::point(depth.p as f64 / depth.q as f64), &Edges::none());
        let strength = greatest(certificate, cell) * WIDER[0];
        let own = (depths.period(), oscillator.parameters.map(Span::middle));
        settles(own, strength, depths.reach(strength)?)
    };
    let first = of(0)?;
    let all = (0..certificate.cells.len()).filter_map(of).filter(|&n| n <= first + LONGER);
    all.max()
}

/// The same of motions with these strengths, phases and places, by the decay of u² + cqu + kq².
fn settles(
    (period, [damping, stiffness, restitution]): (f64, [f64; 3]),
    strength: f64,
    [phase, place]: [f64; 2],
) -> Option<u64> {
    let spread = stiffness - damping * damping / 4.0;
    let (half, rest) = (strength / 2.0, stiffness * place * place);
    let energy = |a: f64| (a * a - damping * a).max(half * half + damping * half * place) + rest;
    let decay = |n: u64| (-damping * (period * n as f64 - 2.0 * phase)).exp();
    let next = |a: f64| {
        let last = (decay(1) * energy(a) - spread).max(0.0).sqrt() - damping / 2.0;
        (1.0 + restitution) * half + restitution * last.max(0.0)
    };
    let factor = restitution * decay(1).sqrt();
    let first = ((1.0 + restitution) * half + factor * energy(0.0).sqrt()) / (1.0 - factor);
    if !(damping > 0.0 && spread > 0.0 && factor < 1.0) {
        return None;
    }
    let speed = (0..64).fold(first, |a, _| a.min(next(a)));
    (1..=LONGEST).find(|&n| decay(n + 1) * energy(speed) < 0.999 * spread)
}

/// The greatest |s| of a cell's edges.
fn greatest(certificate: &Certificate, cell: usize) -> f64 {
    let ends = certificate.cells[cell].edges.iter().flat_map(|edge| edge.strengths);
    ends.map(|end| write::float(end).abs()).fold(0.0, f64::max)
}
