//! That there are no other orbits near: every motion that meets the wall at arbitrarily early and late times,
//! and always in the window with |g′(t)| ≤ νS/2, is one of the graph's. For σ = 1 and f = 0. The proof with
//! its words is in `docs/chaos.md`.
//!
//! - C1: in one window there is at most one contact. Between two, q̂′ is once the wall's, at most S/2, and
//!   then |q̂′| and |q̂″| are bounded; Z″ = −g″ + νq̂″ > 0 leaves no room for a second contact and none for
//!   rest on the wall.
//! - C2: a leg has at most M periods. At the phase of its first impact q̂ would be y₀, y₁, … > 0 a period
//!   apart, but yₖ₊₁/yₖ = trace − determinant/(yₖ/yₖ₋₁) of E(2π) cannot remain positive.
//! - C3: what is known of the velocities a, p of legs of n ≤ M periods, at first nothing, is narrowed by G
//!   itself, by the law of impact s = 2(a + τp)/(1 + τ), by a ≥ s/2 ≥ p, and by q̂ ≥ σ at 2πk for 0 < k < n,
//!   until all legs that are left are in a letter's box and follow each other as the graph allows.

use std::fmt;

use super::{Fault, Interval, text::Complete, work::Work};
use crate::{
    rejection::{GoOn, claim},
    touch::legs::Impact,
};

/// What the velocities a and p of legs of n periods lie in, for n from 1; `None` if there are no such legs.
type Known = Vec<Option<[Interval; 2]>>;

/// A false claim for this reason, unless it `holds`.
fn shown(holds: bool, reason: impl fmt::Display) -> Result<(), Fault> {
    claim(holds, format_args!("{reason} (C)"))
}

fn outside() -> Fault {
    Fault::False("an impact may be outside the window (C)".into())
}

/// Proves it in a cell.
pub(super) fn complete(work: &Work, claim: &Complete, go_on: GoOn) -> Result<(), Fault> {
    let strength = claim.strength.enclosed();
    let strengths = (-strength).hull(strength);
    let letters = &work.numbers.letters;
    let holds =
        (1..letters.len()).all(|n| letters[..n].iter().all(|other| other.periods != letters[n].periods));
    shown(holds, "letters of one period are told apart by more than that")?;
    let Some(all) = work.cell.impact(strengths) else { return Err(outside()) };
    shown(once(work, &all), "there may be two contacts in one window")?;
    let holds = all.place.is_positive() && ends(work.cell.flow.invariants(work.turns(1)), claim.longest);
    shown(holds, format_args!("a leg may be longer than {} periods", claim.longest))?;
    let mut known: Known = vec![Some([Interval::WHOLE; 2]); claim.longest as usize];
    for round in 0..claim.rounds {
        known = narrowed(work, &known, strengths, claim.parts, round == 0, go_on)?;
        if left(work, &known, strengths).is_none() {
            return Ok(());
        }
    }
    shown(false, left(work, &known, strengths).unwrap_or_default())
}

/// C1. With D the width of the phases and |q̂(0)| ≤ Q: |q̂′| ≤ M, |q̂″| ≤ A = |c|M + |k|(Q + DM) and M ≤ S/2
/// + DA.
fn once(work: &Work, all: &Impact) -> bool {
    let (cell, flow) = (&work.cell, work.cell.flow);
    let width = all.phase.magnitude() + all.phase.magnitude();
    let (damping, stiffness) = (flow.damping.magnitude(), flow.stiffness.magnitude());
    let (place, speed) = (all.place.magnitude(), all.s.magnitude().half());
    let room = Interval::ONE - width * (damping + stiffness * width);
    if !room.is_positive() {
        return false;
    }
    let most = (speed + width * (stiffness * place)).over(room);
    let acceleration = damping * most + stiffness * (place + width * most);
    (all.bend.least() - cell.depth * acceleration).is_positive()
}

/// C2, with the ratios' upper bounds, from the trace and the determinant of E(2π). Where a ratio is not
/// bounded nothing follows.
pub(super) fn ends([trace, determinant]: [Interval; 2], longest: u64) -> bool {
    let (trace, determinant) = (trace.greatest(), determinant.least());
    if !determinant.is_positive() {
        return false;
    }
    // Of y_{k+1}/y_k for k = 1, 2, …; a leg of n periods has y_0, …, y_{n−1}.
    let mut ratio = trace;
    for _ in 1..longest {
        if ratio.is_up_to(Interval::ZERO) {
            return true;
        }
        ratio = (trace - determinant.over(ratio)).greatest();
    }
    false
}

/// The s of impacts between legs of m and n periods (from 0), if there can be any.
fn between(work: &Work, known: &Known, strengths: Interval, m: usize, n: usize) -> Option<Interval> {
    let ([after, _], [_, before]) = (known[n]?, known[m]?);
    after.at_least(before)?;
    work.cell.strength(after, before).common(strengths)
}

/// C3: a round of narrowing.
fn narrowed(
    work: &Work,
    known: &Known,
    strengths: Interval,
    parts: u64,
    first: bool,
    go_on: GoOn,
) -> Result<Known, Fault> {
    let count = known.len();
    let mut narrow: Known = vec![None; count];
    // At first all are alike.
    let others = if first { 1 } else { count };
    let mut impacts = vec![None; count * count];
    for (m, n) in (0..count).flat_map(|m| (0..count).map(move |n| (m, n))) {
        go_on()?;
        if let Some(s) = between(work, known, strengths, m, n) {
            let Some(cut) = work.cell.parts(s, parts, go_on)? else { return Err(outside()) };
            impacts[m * count + n] = Some(cut);
        }
    }
    for n in 0..count {
        for (m, k) in (0..others).flat_map(|m| (0..others).map(move |k| (m, k))) {
            let (Some(from), Some(to)) = (&impacts[m * count + n], &impacts[n * count + k]) else { continue };
            for (from, to) in from.iter().flat_map(|from| to.iter().map(move |to| (from, to))) {
                go_on()?;
                if let Some(found) = leg(work, known, [m, n, k], from, to) {
                    let old = narrow[n].unwrap_or(found);
                    narrow[n] = Some([0, 1].map(|i| old[i].hull(found[i])));
                }
            }
        }
    }
    Ok(narrow)
}

/// The velocities of a leg of n + 1 periods between impacts, those of the legs before and after being known;
/// none if it cannot be.
fn leg(
    work: &Work,
    known: &Known,
    [m, n, k]: [usize; 3],
    from: &[Impact; 2],
    to: &[Impact; 2],
) -> Option<[Interval; 2]> {
    let (cell, periods) = (&work.cell, n as u64 + 1);
    let ([own_after, own_before], [_, before], [after, _]) = (known[n]?, known[m]?, known[k]?);
    let leg = cell.leg(work.turns(periods), periods, [&from[0], &to[0]], [&from[1], &to[1]]);
    let (a, p) = (leg.after.common(own_after)?, leg.before.common(own_before)?);
    // Relative speeds are at least 0.
    let a = a.at_least(from[0].s.half())?;
    let p = -((-p).at_least(-to[0].s.half())?);
    // s is what these velocities and the neighbours' make it.
    let [one, other] = cell.shares;
    let a = a.common((from[0].s - other * before).over(one))?;
    let p = p.common((to[0].s - one * after).over(other))?;
    // The gap at the middle of each window between.
    let back = cell.flow.exp(-from[0].phase);
    for turns in 1..periods {
        let e = cell.flow.times(work.turns(turns), back);
        cell.flow.apply(e, from[0].place, a).0.at_least(cell.side)?;
    }
    Some([a, p])
}

/// What does not fit the letters and their graph yet.
fn left(work: &Work, known: &Known, strengths: Interval) -> Option<String> {
    let letters = &work.numbers.letters;
    let place = |n: usize| letters.iter().position(|letter| letter.periods == n as u64 + 1);
    if let Some(n) = (0..known.len()).find(|&n| known[n].is_some() && place(n).is_none()) {
        return Some(format!("there may be a leg of {} periods", n + 1));
    }
    let mut found = Vec::new();
    for (n, known) in known.iter().enumerate() {
        let (Some([after, before]), Some(v)) = (*known, place(n)) else { continue };
        if !(letters[v].after.holds(after) && letters[v].before.holds(before)) {
            return Some(format!("a leg of letter {}'s periods may be outside its box", v + 1));
        }
        found.push((n, v));
    }
    for (&(m, u), &(n, v)) in found.iter().flat_map(|from| found.iter().map(move |to| (from, to))) {
        if !letters[u].next.contains(&v) && between(work, known, strengths, m, n).is_some() {
            return Some(format!("letter {} may follow letter {}", v + 1, u + 1));
        }
    }
    None
}
