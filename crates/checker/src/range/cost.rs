//! What a check costs, known before it is begun: exponentials, and what takes as long as one. Not here: C3
//! and F where there are no others, which are counted while they are done (`others`).
//!
//! The table is in the head of `mod.rs`; that no check takes more exponentials than this says is a test.

use super::text::{Alone, Cell, Certificate};

/// Exponentials, for each harmonic, of an impact whose phase is an interval: two phases with at most 10
/// shapes each, the wall's two bends there, and its drop.
const IMPACT: u64 = 23;
/// The same of such an impact and of one at a point.
pub(super) const BOTH: u64 = IMPACT + 13;
/// A leg with its derivatives: two exponentials, and three rounds that narrow it.
pub(super) const LEG: u64 = 5;

impl Certificate {
    /// The cost of the check; below 10¹⁸ of each cell, as no number is beyond its limit.
    pub(super) fn cost(&self) -> u64 {
        let (harmonics, pieces) = (self.harmonics.len() as u64, self.pieces);
        let previous = self.previous();
        let before = |v: usize| previous[v].len() as u64;
        let after = |v: usize| self.letters[v].next.len() as u64;
        let edges = self.edges();
        let pairs = self.pairs();
        let flights = self.letters.iter().enumerate().map(|(v, letter)| {
            let n = letter.periods;
            let stretches = 2 * n + 1 + u64::from(self.mirrored);
            before(v) * after(v) * (stretches * pieces * (2 + 2 * harmonics) + n)
        });
        let flights: u64 = flights.sum();
        let triples: u64 = edges.iter().map(|&[u, v]| before(u) * after(v)).sum();
        let longest = self.letters.iter().map(|letter| letter.periods).max().unwrap_or(0);
        let count = edges.len() as u64;
        let map = |parts: u64| {
            let legs = pairs * LEG * parts.pow(2) + triples * parts.pow(3);
            longest + 1 + count * harmonics * BOTH * parts + legs
        };
        let others = |cell: &Cell| {
            let (Some(Alone { longest, .. }), Some(others)) = (self.alone, cell.others) else { return 0 };
            others.slices * (2 * longest + 3 + IMPACT * harmonics)
        };
        let before = self.cells.first().into_iter().chain(&self.cells);
        let cells = self.cells.iter().zip(before).map(|(cell, before)| {
            let whole = count * harmonics * IMPACT + flights;
            map(cell.parts) + whole + cell.steps * map(before.parts) + others(cell)
        });
        cells.fold((pieces + 2) * harmonics, u64::saturating_add)
    }
}
