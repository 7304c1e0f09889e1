//! What goes farther than the whole graph that is born: each orbit of one impact, and the graph without the
//! letter that ends first.

use num_traits::ToPrimitive;

use super::{RangeEffort, RangeProblem, RangeProof, born::endless, prove};
use crate::{chaos::LetterGraph, error::Result, monitor::Monitor};

/// A part is worth a certificate if it goes so many times as deep as the whole.
const FARTHER: f64 = 1.02;

/// The periods of the orbits with one impact: of each letter that may follow itself.
#[must_use]
pub fn single_orbits(graph: &LetterGraph) -> Vec<u64> {
    let loops = (0..graph.letters.len()).filter(|&v| graph.next[v].contains(&v));
    loops.map(|v| graph.letters[v]).collect()
}

/// Of the graphs that lack one letter of the problem's, and what cannot go on without it, the one that is
/// proved deepest, if that is deeper than `whole`, the depth of the problem's own. Of two as deep the one
/// without the longer letter.
///
/// Cost: `effort`, shared evenly by the letters.
///
/// # Errors
/// As [`prove`].
pub fn prove_farther(
    problem: &RangeProblem,
    whole: f64,
    effort: &RangeEffort,
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
        if let Ok(proof) = prove(&part, &effort.part(without as u64 + 1), monitor)? {
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
        assert_eq!(single_orbits(&LetterGraph::full(&[1, 3])), [1, 3]);
        // 2 follows 5 alone.
        let some = LetterGraph { letters: vec![2, 5], next: vec![vec![1], vec![0, 1]] };
        assert_eq!(single_orbits(&some), [5]);
        assert_eq!(single_orbits(&LetterGraph::full(&[4])), [4]);
    }
}
