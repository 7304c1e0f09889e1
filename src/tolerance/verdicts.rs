//! What is said of a box as a whole, and in which order: for each sign of eµ, and of γ, whether chaos is
//! born; which periods occur; which words there are. Each with the share of the box in which it is so.

use super::{
    parameters::ParameterBox,
    partition::{Partition, Share, Spread, Statement},
};
use crate::{existence::Case, word::Word};

/// A box is cut into no more cells than this where somebody waits.
pub const MOST_CELLS: u64 = 1_000_000;
/// The largest period of which a box is asked.
pub const LAST_PERIOD: u64 = 400;

/// A sign of eµ and, where γ is free, one of γ.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CaseSigns {
    /// Whether eµ > 0.
    pub positive: bool,
    /// Whether γ > 0; none where γ is a function of the parameters.
    pub gamma: Option<bool>,
}

impl CaseSigns {
    /// The case with these signs, if γ is free.
    pub fn case(self) -> Option<Case> {
        let gamma = self.gamma?;
        // b and c are those of an orbit in it.
        Some(Case::from_signs(self.positive, self.positive == gamma))
    }

    /// That chaos is born.
    pub fn chaos(self) -> Statement<'static> {
        match self.case() {
            Some(case) => Statement::Chaos(case),
            None => Statement::ChaosAt { positive: self.positive },
        }
    }

    /// That an orbit of period n with one impact exists.
    pub fn orbit(self, n: u64) -> Statement<'static> {
        match self.case() {
            Some(case) => Statement::Orbit { case, n },
            None => Statement::OrbitAt { positive: self.positive, n },
        }
    }
}

/// What a verdict is of.
#[derive(Debug, Clone)]
pub enum Subject {
    /// Whether chaos is born.
    Chaos(CaseSigns),
    /// Whether a period occurs between impacts.
    Period {
        /// Whether eµ > 0.
        positive: bool,
        /// n.
        n: u64,
    },
    /// Whether this is the word.
    Word {
        /// Whether eµ > 0.
        positive: bool,
        /// It.
        word: Word,
    },
}

/// In which share of a box something is so.
#[derive(Debug, Clone)]
pub struct SubjectVerdict {
    /// What.
    pub subject: Subject,
    /// The share.
    pub share: Share,
}

impl ParameterBox {
    /// The signs that are told apart: a machine has its own γ.
    pub fn signs(&self) -> Vec<CaseSigns> {
        let gammas: &[_] = if self.has_gamma() { &[None] } else { &[Some(true), Some(false)] };
        let all = [true, false].into_iter();
        all.flat_map(|positive| gammas.iter().map(move |&gamma| CaseSigns { positive, gamma })).collect()
    }
}

impl Partition {
    /// Of a box with these signs: chaos, then for eµ > 0 and for eµ < 0 the periods up to `last` that occur,
    /// or may, and the words.
    pub fn verdicts(&self, signs: Vec<CaseSigns>, last: u64) -> Vec<SubjectVerdict> {
        let chaos = |signs: CaseSigns| SubjectVerdict {
            subject: Subject::Chaos(signs),
            share: self.share(signs.chaos()),
        };
        let mut all: Vec<SubjectVerdict> = signs.into_iter().map(chaos).collect();
        for positive in [true, false] {
            let period = |n| SubjectVerdict {
                subject: Subject::Period { positive, n },
                share: self.share(Statement::Period { positive, n }),
            };
            all.extend((1..=last).map(period).filter(|one| one.share.spread() != Spread::Nowhere));
            let words = self.words(positive).into_iter();
            all.extend(
                words
                    .map(|(word, share)| SubjectVerdict { subject: Subject::Word { positive, word }, share }),
            );
        }
        all
    }
}
