//! Graphs of letters: how fast their paths grow, which part of one is richest, and which graph is born at a
//! grazing.

use std::collections::HashSet;

use super::{Problem, float, map::Cell, span::Span};
use crate::certificate::chaos::Certificate;

/// Letters with their periods, and for each which may follow.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LetterGraph {
    /// The periods.
    pub letters: Vec<u64>,
    /// For each, the letters that may follow, by their places, increasing.
    pub next: Vec<Vec<usize>>,
}

impl LetterGraph {
    /// Every letter may follow every one.
    pub fn full(letters: &[u64]) -> LetterGraph {
        LetterGraph { letters: letters.to_vec(), next: vec![(0..letters.len()).collect(); letters.len()] }
    }

    /// Whether there is a path from every letter to every other.
    pub fn is_connected(&self) -> bool {
        self.component(0).len() == self.letters.len()
    }

    /// The letters that can be reached from one and from which it can be reached, itself included even if not
    /// so.
    fn component(&self, start: usize) -> Vec<usize> {
        let reach = |next: &dyn Fn(usize) -> Vec<usize>| {
            let mut known = vec![false; self.letters.len()];
            let mut open = vec![start];
            while let Some(v) = open.pop() {
                if !std::mem::replace(&mut known[v], true) {
                    open.extend(next(v));
                }
            }
            known
        };
        let forward = reach(&|v| self.next[v].clone());
        let back = reach(&|v| (0..self.letters.len()).filter(|&u| self.next[u].contains(&v)).collect());
        (0..self.letters.len()).filter(|&v| forward[v] && back[v]).collect()
    }

    /// The graph of some of its letters.
    pub fn part(&self, keep: &[usize]) -> LetterGraph {
        let place = |v: usize| keep.iter().position(|&kept| kept == v);
        LetterGraph {
            letters: keep.iter().map(|&v| self.letters[v]).collect(),
            next: keep.iter().map(|&v| self.next[v].iter().filter_map(|&w| place(w)).collect()).collect(),
        }
    }

    /// The connected part whose paths grow fastest; none if no letter can follow itself, however late.
    pub fn richest(&self) -> Option<LetterGraph> {
        let parts = (0..self.letters.len()).map(|v| self.part(&self.component(v)));
        let parts = parts.filter(|part| part.next.iter().all(|next| !next.is_empty()));
        parts.max_by(|a, b| a.growth().0.total_cmp(&b.growth().0))
    }

    /// The growth rate 1/z of a connected graph, where M(z) has the eigenvalue 1, and the positive
    /// eigenvector there, of greatest entry 1.
    pub fn growth(&self) -> (f64, Vec<f64>) {
        let eigen = |z: f64| {
            let mut vector = vec![1.0; self.letters.len()];
            let mut value = 1.0;
            for _ in 0..2000 {
                let row = |next: &Vec<usize>| {
                    next.iter().map(|&w| z.powi(self.letters[w] as i32) * vector[w]).sum::<f64>()
                };
                // Half of the vector is kept: no cycle of the graph's own period.
                let new: Vec<f64> =
                    self.next.iter().zip(&vector).map(|(next, old)| 0.5 * row(next) + 0.5 * old).collect();
                let greatest = new.iter().copied().fold(0.0, f64::max);
                value = 2.0 * greatest - 1.0;
                let old = std::mem::replace(&mut vector, new.iter().map(|x| x / greatest).collect());
                if old.iter().zip(&vector).all(|(a, b)| (a - b).abs() < 1e-15) {
                    break;
                }
            }
            (value, vector)
        };
        let (mut lo, mut hi) = (0.0, 1.0);
        for _ in 0..60 {
            let z = 0.5 * (lo + hi);
            if eigen(z).0 < 1.0 { lo = z } else { hi = z }
        }
        (1.0 / hi, eigen(hi).1)
    }

    /// Whether the growth rates of a certificate of this graph are proved by its vector, and its periods tell
    /// its paths.
    pub(super) fn claims(&self, certificate: &Certificate) -> Result<(), String> {
        let periods = |list: &[usize]| {
            list.iter().map(|&v| self.letters[v]).collect::<HashSet<u64>>().len() == list.len()
        };
        let told = self.next.iter().all(|next| periods(next))
            || self.backwards().next.iter().all(|before| periods(before));
        if !told {
            return Err("periods do not tell paths".into());
        }
        let proves = |edges: &[Vec<usize>]| {
            certificate.letters.iter().zip(edges).all(|(letter, next)| {
                let sum = |rate: f64| -> f64 {
                    next.iter()
                        .map(|&w| float(certificate.letters[w].growth) / rate.powi(self.letters[w] as i32))
                        .sum()
                };
                let own = float(letter.growth);
                sum(float(certificate.growth[0])) >= own - 1e-12
                    && sum(float(certificate.growth[1])) <= own + 1e-12
            })
        };
        if proves(&self.next) || proves(&self.backwards().next) {
            Ok(())
        } else {
            Err("the growth vector proves another rate".into())
        }
    }

    /// The same letters, every edge reversed: as many paths.
    fn backwards(&self) -> LetterGraph {
        let before = |w: usize| (0..self.letters.len()).filter(|&v| self.next[v].contains(&w)).collect();
        LetterGraph { letters: self.letters.clone(), next: (0..self.letters.len()).map(before).collect() }
    }

    /// The growth rate with a vector that proves it: of this graph or of the one with every edge reversed,
    /// whichever has the greater least entry, and so the shorter decimals.
    pub(crate) fn growth_either_way(&self) -> (f64, Vec<f64>) {
        let least = |vector: &[f64]| vector.iter().copied().fold(1.0, f64::min);
        let (forward, backward) = (self.growth(), self.backwards().growth());
        if least(&backward.1) > least(&forward.1) { backward } else { forward }
    }

    /// Each letter told apart by how many of the letters `of` follow it, up to `depth`: more boxes, the same
    /// words.
    #[must_use]
    pub fn with_history(&self, of: u64, depth: usize) -> LetterGraph {
        let vertices: Vec<(usize, usize)> =
            (0..self.letters.len()).flat_map(|v| (0..=depth).map(move |j| (v, j))).collect();
        let follows = |(v, j): (usize, usize), (w, i): (usize, usize)| {
            let allowed = self.next[v].contains(&w);
            let counted = if self.letters[w] == of { (i + 1).min(depth) == j } else { j == 0 };
            allowed && counted
        };
        let graph = LetterGraph {
            letters: vertices.iter().map(|&(v, _)| self.letters[v]).collect(),
            next: vertices
                .iter()
                .map(|&from| (0..vertices.len()).filter(|&to| follows(from, vertices[to])).collect())
                .collect(),
        };
        graph.richest().unwrap_or(graph)
    }
}

/// The graph at the grazing, ν → 0, in the middle of the ranges: n is a letter if (33) holds strictly, n may
/// follow m if (64) does. Up to `most` periods, with two walls half periods.
pub fn born(problem: &Problem, most: u64) -> LetterGraph {
    let middle = problem.spans().map(|span| Span::point(span.middle()));
    let [damping, stiffness, force, restitution, _] = middle;
    let side = if problem.behind { 1.0 } else { -1.0 };
    let parameters = [damping, stiffness, force, restitution, Span::point(0.0)];
    let cell = Cell::new(problem.mirrored, parameters, side, &problem.profile());
    let mut letters = Vec::new();
    for n in 1..=most {
        let entry = |k: u64| {
            let flow = cell.turned(k);
            (flow.a.middle(), flow.b.middle())
        };
        let (a, b) = entry(n);
        let after = side * (1.0 - a) / b;
        if !after.is_finite() || after.abs() > 1e4 {
            continue;
        }
        let (q, u) = (side, after);
        if (1..n).all(|k| {
            let (a, b) = entry(k);
            a * q + b * u - side > 1e-9
        }) {
            let velocity = (a - damping.middle() * b) * after - stiffness.middle() * b * side;
            letters.push((n, after, velocity));
        }
    }
    let next = letters
        .iter()
        .map(|&(_, _, before)| (0..letters.len()).filter(|&n| letters[n].1 - before > 1e-9).collect());
    LetterGraph { letters: letters.iter().map(|letter| letter.0).collect(), next: next.collect() }
}
