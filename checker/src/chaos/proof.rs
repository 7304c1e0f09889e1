//! The conditions H0 to H3 over all cells: the map of a sequence of velocities to the velocities of its legs
//! is a contraction of the boxes.

use super::{
    Lines, Rejection,
    fixed::Interval,
    flow::Matrix,
    gaps,
    legs::{Cell, Impact, turn},
    only,
    text::{Certificate, Complete, Decimal, Range},
    wall::Wall,
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

/// What holds in one cell: its turns E(2πn), and the least and greatest s from letter to letter.
pub(super) struct Work<'a> {
    pub cell: Cell<'a>,
    pub numbers: &'a Numbers,
    turns: Vec<Matrix>,
}

impl Numbers {
    pub fn new(certificate: &Certificate) -> Numbers {
        let letters = certificate.letters.iter().enumerate().map(|(n, letter)| Numbered {
            periods: letter.periods,
            after: Box1::new(letter.after),
            before: Box1::new(letter.before),
            alpha: letter.weights[0].enclosed(),
            beta: letter.weights[1].enclosed(),
            parts: letter.parts,
            next: letter.next.clone(),
            previous: (0..certificate.letters.len())
                .filter(|&m| certificate.letters[m].next.contains(&n))
                .collect(),
        });
        Numbers {
            letters: letters.collect(),
            contraction: certificate.contraction.enclosed(),
            reach: certificate.reach.enclosed(),
            complete: certificate.complete,
        }
    }
}

/// Proves everything in every cell.
pub(super) fn run(certificate: &Certificate, lines: &mut Lines) -> Result<(), Rejection> {
    let numbers = Numbers::new(certificate);
    let harmonics = certificate.harmonics.iter();
    let harmonics =
        harmonics.map(|one| (one.order, one.parts.map(|[lo, hi]| lo.enclosed().hull(hi.enclosed()))));
    let wall = Wall::new(harmonics.collect(), certificate.window.enclosed(), certificate.pieces)
        .map_err(|reason| lines.false_claim(reason))?;
    let ranges = certificate.ranges.map(|[lo, hi]| lo.enclosed().hull(hi.enclosed()));
    let side = if certificate.behind { Interval::ONE } else { -Interval::ONE };
    let total: u64 = certificate.cells.iter().product();
    for index in 0..total {
        let mut rest = index;
        let mut parameters = ranges;
        for (parameter, parts) in parameters.iter_mut().zip(certificate.cells) {
            *parameter = parameter.part(rest % parts, parts);
            rest /= parts;
        }
        let cell = Cell::new(parameters, side, &wall);
        let periods = numbers.letters.iter().map(|letter| letter.periods);
        let longest = periods.chain(numbers.complete.map(|claim| claim.longest)).max().unwrap_or(0);
        let turns = (0..=longest).map(|n| cell.flow.exp(turn(n))).collect();
        let work = Work { cell, numbers: &numbers, turns };
        let place = |reason: String| format!("cell {} of {total}: {reason}", index + 1);
        work.contracts(lines, &place)?;
        gaps::open(&work, certificate.pieces, lines, &place)?;
        if let Some(claim) = &numbers.complete {
            only::complete(&work, claim, lines, &place)?;
        }
    }
    Ok(())
}

/// Where a reason is said to hold.
pub(super) type Place<'a> = &'a dyn Fn(String) -> String;

impl Work<'_> {
    /// E(2πn).
    pub fn turns(&self, periods: u64) -> Matrix {
        self.turns[periods as usize]
    }

    /// The s of all impacts between two letters.
    pub fn strength(&self, m: usize, n: usize) -> Interval {
        let (one, other) = (&self.numbers.letters[m], &self.numbers.letters[n]);
        self.cell.strength(other.after.all, one.before.all)
    }

    /// The impacts between two letters, their s cut into parts, each with one in its middle.
    fn parts(&self, m: usize, n: usize, parts: u64) -> Option<Vec<[Impact; 2]>> {
        let s = self.strength(m, n);
        let impact = |part| {
            let s = s.part(part, parts);
            Some([self.cell.impact(s)?, self.cell.impact(s.middle())?])
        };
        (0..parts).map(impact).collect()
    }

    /// H0 to H3.
    fn contracts(&self, lines: &mut Lines, place: Place) -> Result<(), Rejection> {
        for n in 0..self.numbers.letters.len() {
            let letter = &self.numbers.letters[n];
            let fail = |lines: &Lines, reason: String| Err(lines.false_claim(place(reason)));
            let impacts = |m, n| self.parts(m, n, letter.parts);
            let last: Option<Vec<_>> = letter.next.iter().map(|&k| impacts(n, k)).collect();
            let Some(last) = last else {
                return fail(lines, format!("an impact after letter {} may be outside the window", n + 1));
            };
            for &m in &letter.previous {
                let previous = &self.numbers.letters[m];
                if !(letter.after.all - previous.before.all).is_positive() {
                    return fail(
                        lines,
                        format!("letters {}, {}: the speed may not be positive (H3)", m + 1, n + 1),
                    );
                }
                let Some(first) = impacts(m, n) else {
                    return fail(
                        lines,
                        format!("an impact before letter {} may be outside the window", n + 1),
                    );
                };
                for (&k, last) in letter.next.iter().zip(&last) {
                    lines.go_on().map_err(|fault| lines.rejection(fault))?;
                    for from in &first {
                        for to in last {
                            if let Err(reason) = self.leg([m, n, k], from, to) {
                                let triple = format!("letters {}, {}, {}: {reason}", m + 1, n + 1, k + 1);
                                return fail(lines, triple);
                            }
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// H1 and H2 for a leg of letter n between m and k, from impacts to impacts.
    fn leg(&self, [m, n, k]: [usize; 3], from: &[Impact; 2], to: &[Impact; 2]) -> Result<(), &'static str> {
        let letters = &self.numbers.letters;
        let (previous, letter, next) = (&letters[m], &letters[n], &letters[k]);
        let turns = self.turns(letter.periods);
        let leg = self.cell.leg(turns, letter.periods, [&from[0], &to[0]], [&from[1], &to[1]]);
        if !letter.after.holds(leg.after) {
            return Err("the first velocity may leave its box (H1)");
        }
        if !letter.before.holds(leg.before) {
            return Err("the last velocity may leave its box (H1)");
        }
        let first = self.cell.strength(letter.alpha, previous.beta);
        let last = self.cell.strength(next.alpha, letter.beta);
        let contracts = |slopes: [Interval; 2], weight: Interval| {
            let sum = slopes[0].magnitude() * first + slopes[1].magnitude() * last;
            sum.is_up_to(self.numbers.contraction * weight)
        };
        if !(contracts(leg.after_slopes, letter.alpha) && contracts(leg.before_slopes, letter.beta)) {
            return Err("the map may not contract (H2)");
        }
        Ok(())
    }
}
