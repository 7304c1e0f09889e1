//! What a check costs, known before it is begun: exponentials, and what takes as long as one.
//!
//! `Flow::exp` is where the time goes; where c or k is an interval one takes up to three times as long. A
//! wall takes one for each harmonic; whatever else is counted, as a leg's derivatives or a step from one
//! window to the next, is counted as at least its share of one. The table is in the head of `mod.rs`;
//! that no check takes more exponentials than this says is a test.

use super::text::{Certificate, Complete};

/// Exponentials, for each harmonic, of an impact whose phase is an interval: two phases with at most 10
/// shapes each, the wall's two bends there, and its drop.
const IMPACT: u64 = 23;
/// The same of such an impact and of one at a point.
const BOTH: u64 = IMPACT + 13;
/// A leg with its derivatives: two exponentials, and three rounds that narrow it.
const LEG: u64 = 4;

impl Certificate {
    /// The cost of the check: of a cell it is below 10¹⁸, as no number is beyond its limit.
    pub(super) fn cost(&self) -> u64 {
        let (harmonics, pieces) = (self.harmonics.len() as u64, self.pieces);
        let both = u64::from(self.mirrored);
        let letters = self.letters.iter().zip(self.previous()).map(|(letter, previous)| {
            let (before, after) = (previous.len() as u64, letter.next.len() as u64);
            let (n, parts) = (letter.periods, letter.parts);
            let legs = (before + after) * parts * BOTH * harmonics + LEG * before * after * parts * parts;
            legs + 2 * IMPACT * harmonics + (2 * n + 1 + both) * pieces * (1 + harmonics) + n
        });
        let others = self.complete.map_or(0, |claim| {
            let Complete { longest, parts, rounds, .. } = claim;
            let impacts = IMPACT * harmonics + rounds * longest.pow(2) * parts * BOTH * harmonics;
            let legs = (longest + (rounds - 1) * longest.pow(3)) * parts.pow(2);
            impacts + legs * (LEG + 1 + longest)
        });
        let periods = self.letters.iter().map(|letter| letter.periods);
        let longest = periods.chain(self.complete.map(|claim| claim.longest)).max().unwrap_or(0);
        let cells: u64 = self.cells.iter().product();
        let cell = longest + 1 + letters.sum::<u64>() + others;
        cells.saturating_mul(cell).saturating_add((pieces + 2) * harmonics)
    }
}
