//! What the graph of letters alone decides: that different paths are different motions, but for finitely
//! many, and how fast they grow.
//!
//! M_{vw} = z^{n_w} for every edge v → w. If Mγ ≥ γ for a positive vector γ, the paths of N periods grow at
//! least like z⁻ᴺ; if Mγ ≤ γ, at most so. With all edges reversed the paths are as many, so predecessors do
//! as well as successors. At a vertex whose successors have different periods a path is told by its periods
//! and where it starts; likewise backwards.

use super::{
    Interval,
    text::{Decimal, Range},
};
use crate::rejection::ensure;

/// A letter: its periods, its entry in the growth vector, the letters that may follow.
pub(crate) struct Vertex<'a> {
    pub periods: u64,
    pub growth: Decimal,
    pub next: &'a [usize],
}

/// For each letter the letters that may precede it, from 0, increasing.
pub(crate) fn previous<'a>(next: impl ExactSizeIterator<Item = &'a [usize]>) -> Vec<Vec<usize>> {
    let mut all = vec![Vec::new(); next.len()];
    for (m, next) in next.enumerate() {
        next.iter().for_each(|&n| all[n].push(m));
    }
    all
}

/// Proves that the growth rate is in the range, and that paths are told by their periods.
pub(crate) fn grows(letters: &[Vertex], rates: Range<Decimal>) -> Result<(), String> {
    let distinct = |mut periods: Vec<u64>| {
        let count = periods.len();
        periods.sort_unstable();
        periods.dedup();
        periods.len() == count
    };
    let next: Vec<Vec<usize>> = letters.iter().map(|letter| letter.next.to_vec()).collect();
    let previous = previous(letters.iter().map(|letter| letter.next));
    let told = |way: &[Vec<usize>]| {
        way.iter().all(|list| distinct(list.iter().map(|&v| letters[v].periods).collect()))
    };
    let (forward, backward) = (told(&next), told(&previous));
    let holds = forward || backward;
    ensure(holds, "a letter has two successors of the same period, and one has two such predecessors")?;
    bounds(letters, rates, &next).or_else(|reason| bounds(letters, rates, &previous).map_err(|_| reason))
}

/// Whether the growth vector proves both rates, along these edges.
fn bounds(letters: &[Vertex], rates: Range<Decimal>, edges: &[Vec<usize>]) -> Result<(), String> {
    let [least, most] = rates.map(|growth| Interval::ONE.over(growth.enclosed()));
    let terms = |z: Interval| -> Vec<Interval> {
        letters.iter().map(|letter| power(z, letter.periods) * letter.growth.enclosed()).collect()
    };
    let (least, most) = (terms(least), terms(most));
    for (v, letter) in letters.iter().enumerate() {
        let sum = |terms: &[Interval]| edges[v].iter().fold(Interval::ZERO, |sum, &w| sum + terms[w]);
        let own = letter.growth.enclosed();
        let holds = own.is_up_to(sum(&least));
        ensure(holds, format_args!("the growth vector does not prove the lower rate at letter {}", v + 1))?;
        let holds = sum(&most).is_up_to(own);
        ensure(holds, format_args!("the growth vector does not prove the upper rate at letter {}", v + 1))?;
    }
    Ok(())
}

fn power(z: Interval, n: u64) -> Interval {
    (0..n).fold(Interval::ONE, |product, _| product * z)
}
