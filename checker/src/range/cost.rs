//! What a check costs, known before it is begun: exponentials, and what takes as long as one.
//!
//! The table is in the head of `mod.rs`; that no check takes more exponentials than this says is a test.

use super::text::Certificate;

/// Exponentials, for each harmonic, of an impact whose phase is an interval: two phases with at most 10
/// shapes each, the wall's two bends there, and its drop.
const IMPACT: u64 = 23;
/// The same of such an impact and of one at a point.
const BOTH: u64 = IMPACT + 13;
/// A leg with its derivatives: two exponentials, and three rounds that narrow it.
const LEG: u64 = 5;

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
            before(v) * after(v) * ((2 * n + 1) * pieces * (2 + 2 * harmonics) + n)
        });
        let flights: u64 = flights.sum();
        let triples: u64 = edges.iter().map(|&[u, v]| before(u) * after(v)).sum();
        let longest = self.letters.iter().map(|letter| letter.periods).max().unwrap_or(0);
        let count = edges.len() as u64;
        let cells = self.cells.iter().map(|cell| {
            let parts = cell.parts;
            let impacts = count * harmonics * (BOTH * parts + IMPACT);
            let legs = pairs * LEG * parts.pow(2) + triples * parts.pow(3);
            let step = count * harmonics * BOTH + pairs * LEG + triples;
            longest + 1 + impacts + legs + flights + cell.steps * step
        });
        cells.fold((pieces + 2) * harmonics, u64::saturating_add)
    }
}
