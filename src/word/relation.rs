//! Which period may follow which in one case (sign eµ, sign γ): the pattern graph as a relation on periods.

use std::fmt;

use serde::Serialize;

use super::{Letter, Word, alike};
use crate::{
    error::{Error, Result},
    existence::Case,
};

/// The most periods of a relation: it holds every pair of them.
pub const MAX_RELATION: usize = 4096;

/// Whether one period may follow another.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Edge {
    /// It may.
    Yes,
    /// It may not.
    No,
    /// The quantity that decides is zero, where Theorem 1 is silent, or its sign was not decided.
    Open,
}

/// `yes`, `no` or `open`.
impl fmt::Display for Edge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Edge::Yes => "yes",
            Edge::No => "no",
            Edge::Open => "open",
        })
    }
}

impl Edge {
    /// What both say; open where they differ.
    pub(super) fn and(self, other: Edge) -> Edge {
        if self == other { self } else { Edge::Open }
    }

    pub(super) fn opposite(self) -> Edge {
        match self {
            Edge::Yes => Edge::No,
            Edge::No => Edge::Yes,
            Edge::Open => Edge::Open,
        }
    }
}

/// The pattern graph of one case on finitely many periods. The impact patterns that exist are its closed
/// walks, a step to period n taking n forcing periods.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Relation {
    case: Case,
    periods: Vec<u64>,
    /// `edges[i][j]`: `periods[j]` may follow `periods[i]`.
    edges: Vec<Vec<Edge>>,
    whole: bool,
}

impl Relation {
    /// The relation of a word for a sign of γ, on its periods up to `last`. `reversed`: the word is that of
    /// the time-reversed system, a₂ > 1, whose patterns are read backwards. Time and memory: O(V²) for V
    /// periods.
    ///
    /// # Errors
    /// An input error for more than [`MAX_RELATION`] periods.
    pub fn new(word: &Word, gamma_positive: bool, reversed: bool, last: u64) -> Result<Relation> {
        let endless = word.is_endless();
        let count = match endless {
            true => usize::try_from(last).unwrap_or(usize::MAX),
            false => word.vertices().iter().filter(|vertex| vertex.period <= last).count(),
        };
        if count > MAX_RELATION {
            return Err(Error::input(format!(
                "a pattern graph on {count} periods: at most {MAX_RELATION}; take those up to a lower period"
            )));
        }
        let vertices = word.up_to(last);
        let case = match (word.is_positive(), gamma_positive) {
            (true, true) => Case::PlusPlus,
            (true, false) => Case::PlusMinus,
            (false, true) => Case::MinusPlus,
            (false, false) => Case::MinusMinus,
        };
        let sigma = word.is_positive() == gamma_positive;
        // The vertices kept keep their place in the word.
        let places: Vec<usize> = (0..word.vertices().len())
            .filter(|&index| !endless && word.vertices()[index].period <= last)
            .collect();
        // In a word without end all letters that are known are the same.
        let edge = |from: usize, to: usize| match (endless, vertices[from].letter) {
            (false, _) => word.edge(places[from], places[to], sigma),
            (true, Letter::Either) => alike(vertices[to].letter, sigma),
            (true, letter) => alike(letter, sigma),
        };
        let size = vertices.len();
        let edges = (0..size)
            .map(|i| (0..size).map(|j| if reversed { edge(j, i) } else { edge(i, j) }).collect())
            .collect();
        let whole = word.is_whole() && !endless && word.vertices().iter().all(|vertex| vertex.period <= last);
        Ok(Relation { case, periods: vertices.iter().map(|vertex| vertex.period).collect(), edges, whole })
    }

    /// The case (sign eµ, sign γ).
    pub fn case(&self) -> Case {
        self.case
    }

    /// The periods, in path order.
    pub fn periods(&self) -> &[u64] {
        &self.periods
    }

    /// Whether the periods are all that occur.
    pub fn is_whole(&self) -> bool {
        self.whole
    }

    /// Whether `to` may follow `from`; [`Edge::No`] for periods that do not occur. Cost: O(V), V the number
    /// of periods.
    pub fn edge(&self, from: u64, to: u64) -> Edge {
        let place = |n| self.periods.iter().position(|&period| period == n);
        match (place(from), place(to)) {
            (Some(i), Some(j)) => self.edges[i][j],
            _ => Edge::No,
        }
    }

    /// The edges by index, as in [`periods`](Relation::periods).
    pub fn edges(&self) -> &[Vec<Edge>] {
        &self.edges
    }

    /// The periods that may follow themselves: the single-impact orbits of this case.
    pub fn loops(&self) -> Vec<u64> {
        (0..self.periods.len()).filter(|&i| self.edges[i][i] == Edge::Yes).map(|i| self.periods[i]).collect()
    }

    /// Whether an edge is open. Cost: O(V²).
    pub fn is_open(&self) -> bool {
        self.edges.iter().flatten().any(|&edge| edge == Edge::Open)
    }

    /// Whether the pattern exists: [`Edge::Yes`] if each period may follow the one before it, cyclically.
    /// Cost: O(m V).
    pub fn pattern(&self, pattern: &[u64]) -> Edge {
        let mut answer = Edge::Yes;
        for (index, &from) in pattern.iter().enumerate() {
            match self.edge(from, pattern[(index + 1) % pattern.len()]) {
                Edge::No => return Edge::No,
                Edge::Open => answer = Edge::Open,
                Edge::Yes => {}
            }
        }
        answer
    }

    /// Whether patterns branch: the topological entropy is positive. By the word theorem exactly where two
    /// single-impact periods coexist in the case.
    pub fn is_chaotic(&self) -> bool {
        self.loops().len() > 1
    }
}
