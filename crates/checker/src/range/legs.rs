//! Legs with their derivatives by the depth: the mean-value form in s, s′ and ν together.
//!
//! With s held, −g′(t) = −νs/2 and Q = σ − (1 − g(t))/ν give
//!
//! ```text
//! t_ν = s/2g″,   Q_ν = (1 − g)/ν² + g′ t_ν/ν = s²/4 ((1 − g)/g′² + 1/g″)
//! a_ν = (Q′_ν − E₁₁ Q_ν − p′ T_ν)/E₁₂,   p′_ν = E₂₁ Q_ν + E₂₂ a_ν + r T_ν,   T_ν = t′_ν − t_ν
//! ```
//!
//! from (Q′, p′) = E(T)(Q, a) and dE/dT; the rest is in `touch::legs`.

use super::Interval;
use crate::touch::{
    flow::Matrix,
    legs::{Cell, Impact},
};

/// A leg's first and last velocity: enclosed; at the middle of its impacts and depths; the derivatives by s,
/// s′ and ν.
pub(super) struct Leg {
    pub after: Interval,
    pub before: Interval,
    pub middle: [Interval; 2],
    pub after_slopes: [Interval; 3],
    pub before_slopes: [Interval; 3],
}

/// t_ν and Q_ν.
fn drift(impact: &Impact) -> [Interval; 2] {
    let once = Interval::ONE.over(impact.bend);
    [-(impact.s * once).half(), (impact.s.squared() * (impact.ratio - once)).shifted_down(2)]
}

/// Of the depths of a cell, of which `centre` has the middle one: a leg of so many periods, `turns` being
/// their E, between these impacts; `middles`, among them, are impacts at the middle depth.
pub(super) fn leg(
    [cell, centre]: [&Cell; 2],
    turns: Matrix,
    periods: u64,
    [from, to]: [&Impact; 2],
    middles: [&Impact; 2],
) -> Leg {
    let e = cell.matrix(turns, from, to);
    let [mut after, mut before] = cell.ends(e, periods, from, to);
    let there = centre.matrix(turns, middles[0], middles[1]);
    let middle = centre.ends(there, periods, middles[0], middles[1]);
    let frame = cell.frame(e, from, to);
    let ([time, place], [last_time, last_place]) = (drift(from), drift(to));
    let longer = last_time - time;
    let apart = [from.s - middles[0].s, to.s - middles[1].s, cell.depth - centre.depth];
    let mut slopes = [[Interval::WHOLE; 3]; 2];
    for _ in 0..3 {
        let last = cell.acceleration(to.place, before);
        let [[a, a_last], [p, p_last]] = frame.slopes(before, last);
        let a_depth = (last_place - e.a * place - before * longer).over(e.b);
        let p_depth = frame.spring * place + frame.velocity * a_depth + last * longer;
        slopes = [[a, a_last, a_depth], [p, p_last, p_depth]];
        after = after.meet(middle[0] + moved(slopes[0], apart));
        before = before.meet(middle[1] + moved(slopes[1], apart));
    }
    let [after_slopes, before_slopes] = slopes;
    Leg { after, before, middle, after_slopes, before_slopes }
}

/// The scalar product.
pub(super) fn moved(slopes: [Interval; 3], apart: [Interval; 3]) -> Interval {
    slopes[0] * apart[0] + slopes[1] * apart[1] + slopes[2] * apart[2]
}
