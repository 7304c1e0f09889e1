//! What the conditions are proved of: a certificate's numbers, enclosed, and a cell of parameters with what
//! holds in it.

use super::{
    Fault, Interval,
    text::{Certificate, Complete, Decimal, Range},
};
use crate::{
    rejection::GoOn,
    touch::{
        flow::Matrix,
        legs::{Cell, Parts},
        near::Near,
    },
};

/// A certificate's numbers, enclosed.
pub(super) struct Numbers {
    pub letters: Vec<Numbered>,
    pub contraction: Interval,
    pub reach: Interval,
    pub complete: Option<Complete>,
}

/// A letter's.
pub(super) struct Numbered {
    pub periods: u64,
    pub after: Box1,
    pub before: Box1,
    pub alpha: Interval,
    pub beta: Interval,
    pub parts: u64,
    pub next: Vec<usize>,
    pub previous: Vec<usize>,
}

/// A range of numbers: its ends, each enclosed, and all between them.
pub(super) struct Box1 {
    least: Interval,
    greatest: Interval,
    pub all: Interval,
}

impl Box1 {
    fn new([least, greatest]: Range<Decimal>) -> Box1 {
        let (least, greatest) = (least.enclosed(), greatest.enclosed());
        Box1 { least, greatest, all: least.hull(greatest) }
    }

    /// Whether all these numbers are in the range.
    pub fn holds(&self, x: Interval) -> bool {
        self.least.is_up_to(x) && x.is_up_to(self.greatest)
    }
}

/// A cell of parameters, with its E over n periods, or half periods.
pub(super) struct Work<'a> {
    pub cell: Cell<'a>,
    pub numbers: &'a Numbers,
    turns: Vec<Matrix>,
}

impl Numbers {
    pub fn new(certificate: &Certificate) -> Numbers {
        let letters = certificate.letters.iter().zip(certificate.previous());
        let letters = letters.map(|(letter, previous)| Numbered {
            periods: letter.periods,
            after: Box1::new(letter.after),
            before: Box1::new(letter.before),
            alpha: letter.weights[0].enclosed(),
            beta: letter.weights[1].enclosed(),
            parts: letter.parts,
            next: letter.next.clone(),
            previous,
        });
        Numbers {
            letters: letters.collect(),
            contraction: certificate.contraction.enclosed(),
            reach: certificate.reach.enclosed(),
            complete: certificate.complete,
        }
    }
}

impl<'a> Work<'a> {
    pub fn new(cell: Cell<'a>, numbers: &'a Numbers) -> Self {
        let periods = numbers.letters.iter().map(|letter| letter.periods);
        let longest = periods.chain(numbers.complete.map(|claim| claim.longest)).max().unwrap_or(0);
        let turns = (0..=longest).map(|n| cell.turned(n)).collect();
        Work { cell, numbers, turns }
    }

    /// E over so many periods, or half periods.
    pub fn turns(&self, periods: u64) -> Matrix {
        self.turns[periods as usize]
    }

    /// Motions near, with strengths from these, cut into so many parts; their legs are as long as E is known.
    pub fn near(&self, strengths: Interval, parts: u64) -> Near<'_> {
        Near { cell: &self.cell, turns: &self.turns, strengths, parts }
    }

    /// The s of all impacts between two letters.
    pub fn strength(&self, m: usize, n: usize) -> Interval {
        let (one, other) = (&self.numbers.letters[m], &self.numbers.letters[n]);
        self.cell.strength(other.after.all, one.before.all)
    }

    /// The impacts between two letters, their s cut into parts.
    pub fn parts(&self, m: usize, n: usize, parts: u64, go_on: GoOn) -> Result<Option<Parts>, Fault> {
        self.cell.parts(self.strength(m, n), parts, go_on)
    }
}
