//! What a certificate of kind `range` says of all its cells alike: the graph, the wall and the parameters.

use super::{Interval, text::Certificate, work::Graph};
use crate::touch::{legs::Cell, wall::Wall};

/// What is the same in all cells.
pub(super) struct Problem<'a> {
    pub graph: Graph,
    mirrored: bool,
    behind: bool,
    pub wall: &'a Wall,
    harmonics: u64,
    /// c, k, τ.
    parameters: [Interval; 3],
    side: Interval,
    pub pieces: u64,
    pub contraction: Interval,
}

impl<'a> Problem<'a> {
    pub fn new(certificate: &Certificate, wall: &'a Wall) -> Problem<'a> {
        Problem {
            graph: Graph::new(certificate),
            mirrored: certificate.mirrored,
            behind: certificate.behind,
            wall,
            harmonics: certificate.harmonics.len() as u64,
            parameters: certificate.ranges.map(|[lo, hi]| lo.enclosed().hull(hi.enclosed())),
            side: if certificate.behind { Interval::ONE } else { -Interval::ONE },
            pieces: certificate.pieces,
            contraction: certificate.contraction.enclosed(),
        }
    }

    /// Whether σ = 1.
    pub fn is_behind(&self) -> bool {
        self.behind
    }

    /// How many harmonics the wall has.
    pub fn harmonics(&self) -> u64 {
        self.harmonics
    }

    /// At these depths.
    pub fn cell(&self, depth: Interval) -> Cell<'_> {
        let [damping, stiffness, restitution] = self.parameters;
        let parameters = [damping, stiffness, Interval::ZERO, restitution, depth];
        Cell::new(self.mirrored, parameters, self.side, self.wall)
    }
}
