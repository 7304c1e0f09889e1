//! That there are no other orbits near: every motion that meets the wall at arbitrarily early and late times,
//! and always in the window with |g′(t)| ≤ νS/2, is one of the graph's. For σ = 1 and f = 0. The proof with
//! its words is in `proofs/chaos.md`. C1, C2 and the rounds of C3 are in [`near`]; here is what they leave:
//! legs in the letters' boxes, that follow each other as the graph allows.

use super::{Fault, text::Complete, work::Work};
use crate::{
    rejection::{GoOn, claim},
    touch::{
        legs::Known,
        near::{Near, anything},
    },
};

/// Proves it in a cell.
pub(super) fn complete(work: &Work, complete: &Complete, go_on: GoOn) -> Result<(), Fault> {
    let strength = complete.strength.enclosed();
    let near = work.near((-strength).hull(strength), complete.parts);
    let letters = &work.numbers.letters;
    let holds =
        (1..letters.len()).all(|n| letters[..n].iter().all(|other| other.periods != letters[n].periods));
    claim(holds, "letters of one period are told apart by more than that (C)")?;
    near.bounded(complete.longest)?;
    let mut known = anything(complete.longest);
    for round in 0..complete.rounds {
        known = near.narrowed(&known, round == 0, go_on)?;
        if left(work, &near, &known).is_none() {
            return Ok(());
        }
    }
    claim(false, format_args!("{} (C)", left(work, &near, &known).unwrap_or_default()))
}

/// What does not fit the letters and their graph yet.
fn left(work: &Work, near: &Near, known: &Known) -> Option<String> {
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
        if !letters[u].next.contains(&v) && near.between(known, m, n).is_some() {
            return Some(format!("letter {} may follow letter {}", v + 1, u + 1));
        }
    }
    None
}
