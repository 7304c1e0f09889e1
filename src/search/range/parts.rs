//! What goes farther than the whole graph that is born: each orbit of one impact by itself, and the graph
//! without the letter that ends first.

use num_traits::ToPrimitive;

use super::{RangeEffort, RangeProblem, RangeProof, born::endless, prove};
use crate::{error::Result, monitor::Monitor, search::chaos::LetterGraph};

/// A part is worth a certificate if it goes so many times as deep as the whole.
const FARTHER: f64 = 1.02;

/// The graphs of the orbits with one impact: of each letter that may follow itself, that letter alone. None
/// if that is all there is.
#[must_use]
pub fn single_orbits(graph: &LetterGraph) -> Vec<LetterGraph> {
    let loops = (0..graph.letters.len()).filter(|&v| graph.next[v].contains(&v));
    let single = |v: usize| LetterGraph { letters: vec![graph.letters[v]], next: vec![vec![0]] };
    let all: Vec<LetterGraph> = loops.map(single).collect();
    if graph.letters.len() > 1 { all } else { Vec::new() }
}

/// Of the graphs that lack one letter of the problem's, and what cannot go on without it, the one that is
/// proved deepest, if that is deeper than `whole`, the depth of the problem's own. Of two as deep the one
/// without the longer letter.
///
/// Cost: `effort`, shared evenly by the letters, and the checker's for each cell that is tried.
///
/// # Errors
/// As [`prove`].
pub fn prove_farther(
    problem: &RangeProblem,
    whole: f64,
    effort: RangeEffort,
    monitor: &dyn Monitor,
) -> Result<Option<(LetterGraph, RangeProof)>> {
    let count = problem.graph.letters.len();
    if count < 3 || whole >= problem.deepest {
        return Ok(None);
    }
    let mut best: Option<(LetterGraph, RangeProof, f64)> = None;
    for without in (0..count).rev() {
        let keep: Vec<usize> = (0..count).filter(|&v| v != without).collect();
        let Some(graph) = endless(problem.graph.part(&keep)) else { continue };
        // One orbit by itself has a range of its own.
        if graph.letters.len() < 2 {
            continue;
        }
        let part = RangeProblem { graph: graph.clone(), ..problem.clone() };
        if let Ok(proof) = prove(&part, RangeEffort(effort.0 / count as u64), monitor)? {
            let depth = proof.depth.to_f64().unwrap_or(0.0);
            let least = best.as_ref().map_or(FARTHER * whole, |(.., depth)| *depth);
            if depth > least {
                best = Some((graph, proof, depth));
            }
        }
    }
    Ok(best.map(|(graph, proof, _)| (graph, proof)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_that_follow_themselves_are_orbits() {
        let letters =
            |graph: &LetterGraph| single_orbits(graph).into_iter().map(|one| one.letters[0]).collect();
        let all: Vec<u64> = letters(&LetterGraph::full(&[1, 3]));
        assert_eq!(all, [1, 3]);
        // 2 follows 5 alone.
        let some: Vec<u64> = letters(&LetterGraph { letters: vec![2, 5], next: vec![vec![1], vec![0, 1]] });
        assert_eq!(some, [5]);
        let none: Vec<u64> = letters(&LetterGraph::full(&[4]));
        assert!(none.is_empty());
    }
}
