//! All conditions in all cells, and what is said in the parts.

use std::ops::Range;

use super::{
    Fault, Interval,
    curve::Curve,
    gap::{Free, Phases},
    text::{Certificate, Decimal, Fraction, Part, Word},
};
use crate::rejection::{GoOn, claim};

/// What is found of a cell: depths in units of 2⁻⁴⁸, and multipliers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Found {
    /// All its depths are at least this, whatever the parameters.
    pub least: i128,
    /// And at most this.
    pub greatest: i128,
    /// They reach this, whatever the parameters.
    pub reach: i128,
    /// What is certain of the multipliers in all of it.
    pub word: Word,
}

impl Found {
    /// Whether no depth of the cell is between these two, the second included.
    fn is_apart(&self, from: Fraction, to: Fraction) -> bool {
        let (least, greatest) = (Interval::units(self.least), Interval::units(self.greatest));
        greatest.is_up_to(from.enclosed()) || to.enclosed().is_up_to(least)
    }

    fn reaches(&self, depth: Fraction) -> bool {
        depth.enclosed().is_up_to(Interval::units(self.reach))
    }
}

/// Proves everything.
pub(super) fn run(certificate: &Certificate, go_on: GoOn) -> Result<(), Fault> {
    let found = cells(certificate, 0..certificate.cells.len(), go_on)?;
    let mut from = Fraction::ZERO;
    for (index, Part { depth, word }) in certificate.parts.iter().enumerate() {
        if *word != Word::Open {
            let agrees = |cell: &Found| cell.word == *word || cell.is_apart(from, *depth);
            if let Some(cell) = found.iter().position(|cell| !agrees(cell)) {
                let reason = format!("the orbit may not be {word} in cell {}", cell + 1);
                return Err(Fault::False(reason).at(format!("part {}", index + 1)));
            }
        }
        from = *depth;
    }
    let holds = found.last().is_some_and(|cell| cell.reaches(from));
    claim(holds, "the cells may not reach the depth of the last part")
}

/// Proves S1 to S3 in some cells.
pub(super) fn cells(
    certificate: &Certificate,
    which: Range<usize>,
    go_on: GoOn,
) -> Result<Vec<Found>, Fault> {
    let curve = Curve::new(certificate)?;
    let free = Free::new(&curve, certificate.pieces, go_on)?;
    let phase = |end: &Decimal| curve.direction * end.enclosed();
    let mut all = Vec::new();
    for index in which {
        let from = index.checked_sub(1).map_or(Interval::ZERO, |before| phase(&certificate.cells[before]));
        let to = phase(&certificate.cells[index]);
        let mut prove = || {
            let at = Phases::new(&curve, from.hull(to));
            curve.runs(&at.shape, index == 0)?;
            claim(curve.is_clear(&free, &at, go_on)?, "the gap may not be positive (S3)")?;
            let [least, _] = if index == 0 { [0; 2] } else { curve.depth(from).in_units() };
            let [reach, greatest] = curve.depth(to).in_units();
            Ok(Found { least, greatest, reach, word: curve.word(&at.shape) })
        };
        let place = format!("cell {} of {}", index + 1, certificate.cells.len());
        all.push(prove().map_err(|fault: Fault| fault.at(place))?);
    }
    Ok(all)
}
