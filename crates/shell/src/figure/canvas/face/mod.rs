//! The face in which print has its text: DejaVu Sans Condensed, reduced to the characters of figures.

use ttf_parser::{Face, GlyphId};

/// The font's file; its licence is beside it.
pub(super) const FILE: &[u8] = include_bytes!("DejaVuSansCondensed.ttf");

/// Italic letters are slanted by this, as the face's own are.
#[cfg(feature = "print")]
pub(super) const SLANT: f64 = 0.2;

pub(super) fn face() -> Face<'static> {
    Face::parse(FILE, 0).expect("the font was read by tests")
}

/// The glyph of a character; of one that the face lacks, the sign for that.
pub(super) fn glyph(face: &Face, c: char) -> GlyphId {
    face.glyph_index(c).or_else(|| face.glyph_index('\u{fffd}')).unwrap_or(GlyphId(0))
}

/// The width of a glyph, in sizes of type.
pub(super) fn advance(face: &Face, glyph: GlyphId) -> f64 {
    f64::from(face.glyph_hor_advance(glyph).unwrap_or(0)) / f64::from(face.units_per_em())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::canvas::Words;

    /// What is placed by the widths that the canvas assumes is set with those of the face.
    #[test]
    fn the_widths_of_words_are_those_of_the_face() {
        let face = face();
        for text in ["0123456789 −+=(),.", "forcing periods", "unstable, impact pattern", "QWERTY"] {
            let width: f64 = text.chars().map(|c| advance(&face, glyph(&face, c))).sum();
            assert!((Words::plain(text).width(1.0) - width).abs() < 0.03, "{text}: {width}");
        }
        for c in "µγλθπτω₁²′≤−∓√½–…“”éß".chars() {
            assert!(face.glyph_index(c).is_some(), "{c}");
        }
    }
}
