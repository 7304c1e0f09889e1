//! The grids of many systems, side by side: what a sweep over all motions reads.

use super::{
    super::{
        Simulator,
        grid::{Polynomial, TERMS, Tables},
        pieces::{LOWER, UPPER},
        search::{Head, clear},
    },
    vector::{Eight, LANES},
};

/// What a sweep needs of the systems of eight motions.
pub(super) struct Block {
    /// From a cell to the next, by rows.
    pub matrix: [Eight; 4],
    pub step: [Eight; 2],
    /// Heads of both basis polynomials.
    pub heads: [[Eight; 4]; 2],
    /// Per wall and row of the table: the head of ±(p − Q).
    pub drive: [Vec<[Eight; 4]>; 2],
}

impl Block {
    /// The block of up to eight systems, the last one repeated.
    fn new(systems: &[Tables]) -> Block {
        let eight = |number: &dyn Fn(&Tables) -> f64| -> Eight {
            std::array::from_fn(|lane| number(&systems[lane.min(systems.len() - 1)]))
        };
        let head = |head: &dyn Fn(&Tables) -> Head| std::array::from_fn(|i| eight(&|t| head(t)[i]));
        Block {
            matrix: std::array::from_fn(|i| eight(&|t| t.matrix[i / 2][i % 2])),
            step: std::array::from_fn(|i| eight(&|t| t.step[i])),
            heads: [head(&|t| t.heads[0]), head(&|t| t.heads[1])],
            drive: [LOWER, UPPER].map(|wall| {
                (0..systems[0].drive[wall].len()).map(|row| head(&|t| t.drive[wall][row].0)).collect()
            }),
        }
    }

    /// The blocks of systems in order, and which one each eight of them have: one for all if there is one
    /// system only.
    pub fn all(simulators: &[&Simulator], systems: &[Tables]) -> (Vec<Block>, Vec<u32>) {
        let count = systems.len().div_ceil(LANES);
        if same(simulators) {
            return (vec![Block::new(&systems[..1])], vec![0; count]);
        }
        (systems.chunks(LANES).map(Block::new).collect(), (0..count as u32).collect())
    }
}

/// Whether all motions are of one system.
pub(super) fn same(simulators: &[&Simulator]) -> bool {
    simulators.windows(2).all(|pair| std::ptr::eq(pair[0], pair[1]))
}

/// The polynomials of one system, each coefficient eight times.
pub(super) struct Shared {
    pub basis: [[Eight; TERMS]; 2],
    pub drive: [Vec<[Eight; TERMS]>; 2],
}

impl Shared {
    pub fn new(tables: &Tables) -> Shared {
        let wide = |polynomial: &Polynomial| polynomial.map(|c| [c; LANES]);
        Shared {
            basis: [wide(&tables.basis[0]), wide(&tables.basis[1])],
            drive: [LOWER, UPPER].map(|wall| tables.drive[wall].iter().map(|row| wide(&row.1)).collect()),
        }
    }
}

/// Whether the gap to a wall surely stays above `depth` on a cell, as the sweep decides it.
pub(super) fn far(tables: &Tables, wall: usize, row: usize, [a, b]: [f64; 2], depth: f64) -> bool {
    let sign = if wall == LOWER { 1.0 } else { -1.0 };
    let ([one, other], drive) = (tables.heads, &tables.drive[wall][row].0);
    let term = |i: usize| sign * (a * one[i] + b * other[i]) + drive[i];
    let tail = a.abs() * one[3] + b.abs() * other[3] + drive[3];
    clear([term(0), term(1), term(2), tail], depth)
}

/// Numbers so large that rounding or overflow could tell the short test of a sweep from the long one.
pub(super) fn moderate(tables: &Tables) -> bool {
    let small = |x: &f64| x.abs() < 1e40;
    let rows = tables.drive.iter().flat_map(|rows| rows.iter()).map(|(_, polynomial)| polynomial);
    rows.chain(tables.basis).flatten().all(small)
        && tables.matrix.iter().flatten().chain(&tables.step).all(small)
}
