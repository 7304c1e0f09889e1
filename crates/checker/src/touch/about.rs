//! Of which oscillator, and to what depth, a certificate near a touch speaks.

use super::text::{Fraction, Harmonic, Range};

/// What another certificate may compare a machine with.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct About {
    /// Whether there are two walls, the upper one the mirror image of the lower.
    pub mirrored: bool,
    /// The ranges of c, k, τ.
    pub ranges: [Range<Fraction>; 3],
    /// Whether σ = 1.
    pub behind: bool,
    /// The harmonics of g.
    pub harmonics: Vec<Harmonic>,
    /// Everything is proved for every ν > 0 up to this,
    pub depth: Fraction,
    /// from this one on, if there is such a number.
    pub least: Option<Fraction>,
}
