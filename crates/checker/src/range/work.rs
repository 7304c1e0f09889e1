//! What the conditions are proved of: the graph, and a cell of depths with its impacts and legs.

use super::{
    Fault, Interval,
    legs::{Leg, leg},
    text::{Cell as Block, Certificate, Decimal, Range},
};
use crate::{
    rejection::GoOn,
    touch::{
        flow::Matrix,
        legs::{Cell, Impact},
    },
};

/// The graph: its edges, and where legs begin and end.
pub(super) struct Graph {
    pub periods: Vec<u64>,
    /// First and second letter.
    pub edges: Vec<[usize; 2]>,
    /// The edges before and after each leg: the edge that leads to a letter, the letter, the edge that leaves
    /// it.
    pub legs: Vec<[usize; 3]>,
    /// For each edge the legs that begin there, and those that end there, by their places.
    pub begin: Vec<Vec<usize>>,
    pub end: Vec<Vec<usize>>,
}

impl Graph {
    pub fn new(certificate: &Certificate) -> Graph {
        let edges = certificate.edges();
        let of = |end: usize, v: usize| (0..edges.len()).filter(|&e| edges[e][end] == v).collect::<Vec<_>>();
        let mut legs = Vec::new();
        for v in 0..certificate.letters.len() {
            let out = of(0, v);
            of(1, v).iter().for_each(|&from| legs.extend(out.iter().map(|&to| [from, v, to])));
        }
        let (mut begin, mut end) = (vec![Vec::new(); edges.len()], vec![Vec::new(); edges.len()]);
        for (leg, [from, _, to]) in legs.iter().enumerate() {
            begin[*from].push(leg);
            end[*to].push(leg);
        }
        let periods = certificate.letters.iter().map(|letter| letter.periods).collect();
        Graph { periods, edges, legs, begin, end }
    }

    /// An edge in words.
    pub fn name(&self, edge: usize) -> String {
        let [u, v] = self.edges[edge];
        format!("letters {}, {}", u + 1, v + 1)
    }

    /// That an edge's impacts have phases in the window is not proved.
    pub fn outside(&self, edge: usize) -> Fault {
        Fault::False(format!("{}: an impact may be outside the window (H0)", self.name(edge)))
    }
}

/// A range of numbers: its ends, each enclosed.
#[derive(Clone, Copy)]
pub(super) struct Ends {
    least: Interval,
    greatest: Interval,
}

impl Ends {
    pub fn new([least, greatest]: Range<Decimal>) -> Ends {
        Ends { least: least.enclosed(), greatest: greatest.enclosed() }
    }

    pub fn all(&self) -> Interval {
        self.least.hull(self.greatest)
    }

    /// Whether all these numbers are in the range.
    pub fn holds(&self, x: Interval) -> bool {
        self.least.is_up_to(x) && x.is_up_to(self.greatest)
    }
}

/// What is said of an edge, enclosed.
pub(super) struct Numbers {
    pub ends: Ends,
    pub factor: Interval,
    pub weight: Interval,
}

/// The numbers of all edges of a block.
pub(super) fn numbers(block: &Block) -> Vec<Numbers> {
    let all = block.edges.iter().map(|edge| Numbers {
        ends: Ends::new(edge.strengths),
        factor: edge.factor.enclosed(),
        weight: edge.weight.enclosed(),
    });
    all.collect()
}

/// Depths, the middle one apart, with E over any number of periods, and the strengths of each edge in parts.
pub(super) struct Work<'a> {
    pub graph: &'a Graph,
    pub cell: Cell<'a>,
    centre: Cell<'a>,
    turns: Vec<Matrix>,
    /// For each edge the impacts in each part, and the one in its middle at the middle depth.
    pub parts: Vec<Vec<[Impact; 2]>>,
}

impl<'a> Work<'a> {
    /// Of a cell and the same at its middle depth, with these strengths in so many parts.
    pub fn new(
        graph: &'a Graph,
        [cell, centre]: [Cell<'a>; 2],
        strengths: &[Interval],
        parts: u64,
        go_on: GoOn,
    ) -> Result<Work<'a>, Fault> {
        let longest = graph.periods.iter().copied().max().unwrap_or(0);
        let turns: Result<Vec<Matrix>, Fault> =
            (0..=longest).map(|n| go_on().map(|()| cell.turned(n))).collect();
        let mut all = Vec::new();
        for (edge, strengths) in strengths.iter().enumerate() {
            let mut cut = Vec::new();
            for part in 0..parts {
                go_on()?;
                let s = strengths.part(part, parts);
                let Some(both) = cell.impact(s).zip(centre.impact(s.middle())) else {
                    return Err(graph.outside(edge));
                };
                cut.push(both.into());
            }
            all.push(cut);
        }
        Ok(Work { graph, cell, centre, turns: turns?, parts: all })
    }

    /// E over so many periods.
    pub fn turns(&self, periods: u64) -> Matrix {
        self.turns[periods as usize]
    }

    /// The difference of the depths from the middle one.
    pub fn deeper(&self) -> Interval {
        self.cell.depth - self.centre.depth
    }

    /// The leg of a letter between parts of its two edges.
    pub fn leg(&self, letter: usize, from: &[Impact; 2], to: &[Impact; 2]) -> Leg {
        let periods = self.graph.periods[letter];
        let cells = [&self.cell, &self.centre];
        leg(cells, self.turns(periods), periods, [&from[0], &to[0]], [&from[1], &to[1]])
    }
}
