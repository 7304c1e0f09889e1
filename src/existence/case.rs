//! The case (sign eµ, sign γ) in which an orbit exists.

use std::fmt;

use serde::{Serialize, Serializer};

/// A case (sign eµ, sign γ): the side of the bifurcation and the sign of γ = CAB for which an orbit exists.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Case {
    /// (−,−)
    MinusMinus,
    /// (−,+)
    MinusPlus,
    /// (+,−)
    PlusMinus,
    /// (+,+)
    PlusPlus,
}

impl Case {
    /// The case in which (52) and (53) hold, given the common sign of all b_{n,k} and the sign of c_n.
    pub fn from_signs(b_positive: bool, c_positive: bool) -> Self {
        match (b_positive, c_positive) {
            (true, true) => Case::PlusPlus,
            (true, false) => Case::PlusMinus,
            (false, true) => Case::MinusMinus,
            (false, false) => Case::MinusPlus,
        }
    }

    /// The case with both signs reversed.
    #[must_use]
    pub fn reversed(self) -> Self {
        match self {
            Case::MinusMinus => Case::PlusPlus,
            Case::MinusPlus => Case::PlusMinus,
            Case::PlusMinus => Case::MinusPlus,
            Case::PlusPlus => Case::MinusMinus,
        }
    }

    /// sign eµ, −1 or 1.
    pub fn sign_emu(self) -> i8 {
        match self {
            Case::MinusMinus | Case::MinusPlus => -1,
            Case::PlusMinus | Case::PlusPlus => 1,
        }
    }

    /// sign γ, −1 or 1.
    pub fn sign_gamma(self) -> i8 {
        match self {
            Case::MinusMinus | Case::PlusMinus => -1,
            Case::MinusPlus | Case::PlusPlus => 1,
        }
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Case::MinusMinus => "(-,-)",
            Case::MinusPlus => "(-,+)",
            Case::PlusMinus => "(+,-)",
            Case::PlusPlus => "(+,+)",
        })
    }
}

/// As text: `(+,-)`.
impl Serialize for Case {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}
