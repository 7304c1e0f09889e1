//! The graph of a word: which period may follow which, by the table of the word theorem, and the weights zⁿ.
//!
//! For γ > 0: U to U always; D to D never; between a D, i, and a U, j, that are neighbours and not the last
//! pair, both ways or neither way as the letter of i + j is U or D; between others both ways or neither way
//! as the later of the two is D or U. For γ < 0 every answer is the opposite one.

use super::fixed::{Powers, quotient, rest};

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Letter {
    U,
    D,
}

/// Letters as they are written, `-` for none.
pub(super) fn name(word: &[Letter]) -> String {
    if word.is_empty() {
        return "-".into();
    }
    word.iter().map(|letter| if *letter == Letter::U { 'U' } else { 'D' }).collect()
}

struct Node {
    numerator: u64,
    period: u64,
    letter: Letter,
}

/// A word's vertices, in path order, and once it is closed or ended the matrix.
pub(super) struct Graph {
    positive: bool,
    nodes: Vec<Node>,
    /// The places of the last D and the last U.
    last: [usize; 2],
    weights: Vec<u128>,
    /// Whether the last pair is joined both ways, and one more vertex with all.
    closed: bool,
}

impl Graph {
    /// That of 1, K and these letters.
    pub fn new(first: u64, word: &[Letter], positive: bool) -> Graph {
        let node = |numerator, period, letter| Node { numerator, period, letter };
        let mut nodes = vec![node(0, 1, Letter::D), node(1, first, Letter::U)];
        let mut last = [0, 1];
        for &letter in word {
            let [low, high] = last.map(|place| (nodes[place].numerator, nodes[place].period));
            last[usize::from(letter == Letter::U)] = nodes.len();
            nodes.push(node(low.0 + high.0, low.1 + high.1, letter));
        }
        Graph { positive, nodes, last, weights: Vec::new(), closed: false }
    }

    /// Any word that begins so.
    pub fn close(&mut self, z: &Powers) {
        self.end(z);
        let [low, high] = self.last.map(|place| self.nodes[place].period);
        let later = quotient(z.power(low + high, true), rest(z.power(low.min(high), true)), true);
        self.weights.push(later);
        self.closed = true;
    }

    /// The word that ends here.
    pub fn end(&mut self, z: &Powers) {
        self.weights = self.nodes.iter().map(|node| z.power(node.period, true)).collect();
    }

    pub fn size(&self) -> usize {
        self.weights.len()
    }

    /// An entry of M, rounded up.
    pub fn entry(&self, i: usize, j: usize) -> u128 {
        let joined = i >= self.nodes.len() || j >= self.nodes.len() || self.edge(i, j);
        if joined { self.weights[j] } else { 0 }
    }

    /// Whether j may follow i.
    fn edge(&self, i: usize, j: usize) -> bool {
        let (a, b) = (&self.nodes[i], &self.nodes[j]);
        let for_positive = match (a.letter, b.letter) {
            (Letter::U, Letter::U) => true,
            (Letter::D, Letter::D) => false,
            (from, _) => {
                let (d, u) = if from == Letter::D { (i, j) } else { (j, i) };
                let (low, high) = (&self.nodes[d], &self.nodes[u]);
                if [d, u] == self.last {
                    if self.closed {
                        return true;
                    }
                    from == Letter::D
                } else if high.numerator * low.period == low.numerator * high.period + 1 {
                    let mediant = low.period + high.period;
                    let found = self.nodes[d.max(u) + 1..].iter().find(|node| node.period == mediant);
                    // Neighbours that are not the last pair have their mediant in the word.
                    found.is_some_and(|node| node.letter == Letter::U)
                } else {
                    d > u
                }
            }
        };
        for_positive == self.positive
    }
}
