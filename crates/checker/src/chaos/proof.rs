//! The conditions H0 to H3 over all cells: the map of a sequence of velocities to the velocities of its legs
//! is a contraction of the boxes.

use super::{
    Fault, Interval, Lines, Rejection, gaps, only,
    text::Certificate,
    work::{Numbers, Work},
};
use crate::{
    rejection::{GoOn, claim},
    touch::{
        legs::{Cell, Impact},
        wall::Wall,
    },
};

/// Proves everything in every cell.
pub(super) fn run(certificate: &Certificate, lines: &mut Lines) -> Result<(), Rejection> {
    let numbers = Numbers::new(certificate);
    let harmonics = certificate.harmonics.iter();
    let harmonics =
        harmonics.map(|one| (one.order, one.parts.map(|[lo, hi]| lo.enclosed().hull(hi.enclosed()))));
    let (window, pieces) = (certificate.window.enclosed(), certificate.pieces);
    let wall = Wall::new(harmonics.collect(), window, pieces, &mut || lines.go_on())
        .map_err(|fault| lines.rejection(fault))?;
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
        let work = Work::new(Cell::new(certificate.mirrored, parameters, side, &wall), &numbers);
        work.holds(pieces, &mut || lines.go_on())
            .map_err(|fault| lines.rejection(fault.at(format!("cell {} of {total}", index + 1))))?;
    }
    Ok(())
}

impl Work<'_> {
    /// All conditions.
    fn holds(&self, pieces: u64, go_on: GoOn) -> Result<(), Fault> {
        self.contracts(go_on)?;
        gaps::open(self, pieces, go_on)?;
        match &self.numbers.complete {
            Some(claim) => only::complete(self, claim, go_on),
            None => Ok(()),
        }
    }

    /// H0 to H3.
    fn contracts(&self, go_on: GoOn) -> Result<(), Fault> {
        let outside = |place| Fault::False(format!("an impact {place} may be outside the window"));
        for n in 0..self.numbers.letters.len() {
            let letter = &self.numbers.letters[n];
            let mut last = Vec::new();
            for &k in &letter.next {
                let parts = self.parts(n, k, letter.parts, go_on)?;
                last.push(parts.ok_or_else(|| outside(format!("after letter {}", n + 1)))?);
            }
            for &m in &letter.previous {
                let previous = &self.numbers.letters[m];
                let holds = (letter.after.all - previous.before.all).is_positive();
                claim(
                    holds,
                    format_args!("letters {}, {}: the speed may not be positive (H3)", m + 1, n + 1),
                )?;
                let first = self.parts(m, n, letter.parts, go_on)?;
                let first = first.ok_or_else(|| outside(format!("before letter {}", n + 1)))?;
                for (&k, last) in letter.next.iter().zip(&last) {
                    let pairs = first.iter().flat_map(|from| last.iter().map(move |to| (from, to)));
                    for (from, to) in pairs {
                        go_on()?;
                        self.leg([m, n, k], from, to)
                            .map_err(|fault| fault.at(format!("letters {}, {}, {}", m + 1, n + 1, k + 1)))?;
                    }
                }
            }
        }
        Ok(())
    }

    /// H1 and H2 for a leg of letter n between m and k, from impacts to impacts.
    fn leg(&self, [m, n, k]: [usize; 3], from: &[Impact; 2], to: &[Impact; 2]) -> Result<(), Fault> {
        let letters = &self.numbers.letters;
        let (previous, letter, next) = (&letters[m], &letters[n], &letters[k]);
        let turns = self.turns(letter.periods);
        let leg = self.cell.leg(turns, letter.periods, [&from[0], &to[0]], [&from[1], &to[1]]);
        claim(letter.after.holds(leg.after), "the first velocity may leave its box (H1)")?;
        claim(letter.before.holds(leg.before), "the last velocity may leave its box (H1)")?;
        let first = self.cell.strength(letter.alpha, previous.beta);
        let last = self.cell.strength(next.alpha, letter.beta);
        let contracts = |slopes: [Interval; 2], weight: Interval| {
            let sum = slopes[0].magnitude() * first + slopes[1].magnitude() * last;
            sum.is_up_to(self.numbers.contraction * weight)
        };
        let holds = contracts(leg.after_slopes, letter.alpha) && contracts(leg.before_slopes, letter.beta);
        claim(holds, "the map may not contract (H2)")
    }
}
