//! Which motions near a touch are among those of a certificate's paths, in the words of every kind that
//! excludes others.

use std::fmt;

use super::super::decimal::Decimal;

/// Which motions are among those of a certificate's paths, in words wherever it is quoted: those that meet
/// the wall near enough, and slowly enough.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Among {
    /// Two walls: versions 3 and 4.
    mirrored: bool,
    /// Whether they have impacts again and again: where they may not, a last impact is excluded.
    held: bool,
    /// Whether c and k are positive.
    damped: bool,
    /// W.
    window: Decimal,
    /// S: no cell has less.
    strength: Decimal,
}

impl Among {
    /// `mirrored`: two walls; `held`: motions without a last impact need not be told apart; `damped`: c and k
    /// are positive; W and S.
    pub(crate) fn new([mirrored, held, damped]: [bool; 3], [window, strength]: [Decimal; 2]) -> Among {
        Among { mirrored, held, damped, window, strength }
    }

    /// Of two certificates of one oscillator, which motions are among those of both.
    pub fn and(self, other: Among) -> Among {
        Among {
            damped: self.damped && other.damped,
            window: less(self.window, other.window),
            strength: less(self.strength, other.strength),
            ..self
        }
    }
}

impl fmt::Display for Among {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Among { mirrored, held, damped, window, strength } = self;
        // Where c and k are positive the statement has a word for motions that meet the wall so once.
        let (which, when) = match (damped, held) {
            (true, true) => ("bounded motion", ","),
            (true, false) => ("bounded motion", " and has no last impact,"),
            (false, true) => ("motion", " at arbitrarily early and late times,"),
            (false, false) => ("bounded motion", " at arbitrarily early and late times,"),
        };
        let (wall, place, speed) = match mirrored {
            false => ("the wall", format!("only within {window} of multiples of 2 pi"), "|g'|"),
            true => (
                "a wall",
                format!(
                    "the lower one only within {window} of even and the upper one of odd multiples of pi,"
                ),
                "|w'|, at the upper wall half a period before,",
            ),
        };
        write!(
            f,
            "every {which} that meets {wall}{when} {place} where {speed} <= nu S/2, S = {strength}, is one of these"
        )
    }
}

/// The less of two.
pub(crate) fn less(one: Decimal, other: Decimal) -> Decimal {
    if other.parts() < one.parts() { other } else { one }
}
