//! The grids of many systems, side by side: what a sweep over all motions reads.

use super::{
    super::{
        Simulator,
        grid::{Polynomial, TERMS, Tables},
        pieces::{LOWER, UPPER},
    },
    vector::{Eight, LANES},
};
use crate::motion::minimum::{Head, clear};

/// What a sweep needs of the free motion of eight systems.
#[derive(PartialEq)]
pub(super) struct Freely {
    /// From a cell to the next, by rows.
    pub matrix: [Eight; 4],
    pub step: [Eight; 2],
    /// Heads of both basis polynomials.
    pub heads: [[Eight; 4]; 2],
}

/// Per wall and row of the table: the heads of ±(p − Q) of eight systems.
pub(super) type Drives = [Vec<[Eight; 4]>; 2];

/// What a sweep needs of all systems, by eights; what neighbours have in common is there once.
pub(super) struct Blocks {
    freely: Vec<Freely>,
    drives: Vec<Drives>,
    /// Which of them each eight has.
    pub of: Vec<[u32; 2]>,
}

/// A number of each of up to eight systems, that of the last one repeated.
fn eight(systems: &[Tables], number: impl Fn(&Tables) -> f64) -> Eight {
    std::array::from_fn(|lane| number(&systems[lane.min(systems.len() - 1)]))
}

fn heads(systems: &[Tables], head: impl Fn(&Tables) -> Head) -> [Eight; 4] {
    std::array::from_fn(|i| eight(systems, |tables| head(tables)[i]))
}

impl Blocks {
    /// The blocks of systems in order; `same` if there is one only.
    pub fn new(systems: &[Tables], same: bool) -> Blocks {
        let (mut freely, mut drives, mut of) = (Vec::new(), Vec::new(), Vec::new());
        for (i, systems) in systems.chunks(LANES).enumerate() {
            if i == 0 || !same {
                let free = Freely {
                    matrix: std::array::from_fn(|i| eight(systems, |t| t.matrix[i / 2][i % 2])),
                    step: std::array::from_fn(|i| eight(systems, |t| t.step[i])),
                    heads: [0, 1].map(|k| heads(systems, |t| t.heads[k])),
                };
                if freely.last() != Some(&free) {
                    freely.push(free);
                }
                drives.push([LOWER, UPPER].map(|wall| {
                    let rows = 0..systems[0].drive[wall].len();
                    rows.map(|row| heads(systems, |t| t.drive[wall][row].0)).collect()
                }));
            }
            of.push([freely.len() as u32 - 1, drives.len() as u32 - 1]);
        }
        Blocks { freely, drives, of }
    }

    /// Those of one of the eights.
    #[inline(always)]
    pub fn at(&self, [freely, drives]: [u32; 2]) -> (&Freely, &Drives) {
        (&self.freely[freely as usize], &self.drives[drives as usize])
    }
}

/// Whether all motions are of one system.
pub(super) fn same(simulators: &[&Simulator]) -> bool {
    simulators.windows(2).all(|pair| std::ptr::eq(pair[0], pair[1]))
}

/// Polynomials that all systems have in common, each coefficient eight times.
pub(super) struct Shared {
    pub basis: [[Eight; TERMS]; 2],
    /// Of one system only.
    pub drive: Option<[Vec<[Eight; TERMS]>; 2]>,
}

impl Shared {
    /// Those of systems that differ in their walls and forces only; `same` if there is one only.
    pub fn new(systems: &[Tables], same: bool) -> Option<Shared> {
        let tables = &systems[0];
        let wide = |polynomial: &Polynomial| polynomial.map(|c| [c; LANES]);
        let drive = || {
            [LOWER, UPPER].map(|wall| tables.drive[wall].iter().map(|row| wide(&row.1)).collect::<Vec<_>>())
        };
        (same || systems.iter().all(|other| other.basis == tables.basis)).then(|| Shared {
            basis: [wide(&tables.basis[0]), wide(&tables.basis[1])],
            drive: same.then(drive),
        })
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
