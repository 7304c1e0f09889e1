//! Finds boxes, weights and cells for which the theorem's conditions hold, as far as floats tell.
//!
//! The map of proofs/chaos.md is iterated on boxes, from points, until they change no more: the least boxes
//! that it keeps, if there are such. The weights are about the eigenvector of the greatest derivatives (of
//! F(w)_n, the greatest over all triples of what H2 bounds). Cells and parts of phases are doubled until this
//! succeeds and the checker agrees.

use std::f64::consts::FRAC_PI_2;

use super::{
    Problem, float,
    map::{Cell, Flow, Impact},
    span::Span,
    write::places,
};
use crate::certificate::chaos::{Certificate, Complete, Decimal};

/// Boxes that the map keeps, and the rest of what a certificate needs.
#[derive(Debug, Clone)]
pub(super) struct Closed {
    pub cells: [u64; 5],
    pub parts: Vec<u64>,
    /// A and P of each letter.
    pub boxes: Vec<[Span; 2]>,
    /// α and β of each letter, the greatest being 1.
    pub weights: Vec<[f64; 2]>,
    pub contraction: f64,
    pub window: f64,
    pub pieces: u64,
    pub reach: f64,
    /// A neighbourhood in which there are no other orbits.
    pub complete: Option<Complete>,
}

/// Windows to try, the likeliest first.
const WINDOWS: [f64; 9] = [1.2, 1.0, 0.8, 0.6, 1.35, 0.4, 0.3, 0.2, 0.1];

/// No greater contraction is tried: a certificate has it with three places, and rounded up.
const MOST_CONTRACTION: f64 = 0.99;

/// No attempt takes more evaluations of a leg per round.
const MOST: u64 = 100_000;

/// One way to cut parameters and phases.
pub(super) struct Attempt<'a> {
    pub problem: &'a Problem,
    cuts: [u64; 5],
    parts: Vec<u64>,
    pub cells: Vec<(Cell, Vec<Flow>)>,
    previous: Vec<Vec<usize>>,
}

/// The greatest derivatives of a triple of letters: a by s and s′, p by both.
struct Slopes {
    triple: [usize; 3],
    all: [f64; 4],
}

impl<'a> Attempt<'a> {
    /// Cuts of the parameters' ranges and of each letter's phases; none if that is too much work.
    pub fn new(problem: &'a Problem, cuts: [u64; 5], parts: Vec<u64>) -> Option<Attempt<'a>> {
        let ranges = problem.spans();
        let side = if problem.behind { 1.0 } else { -1.0 };
        let letters = problem.letters.len();
        let previous: Vec<Vec<usize>> =
            (0..letters).map(|n| (0..letters).filter(|&m| problem.next[m].contains(&n)).collect()).collect();
        let total: u64 = cuts.iter().product();
        let legs: u64 = (0..letters)
            .map(|n| previous[n].len() as u64 * problem.next[n].len() as u64 * parts[n] * parts[n])
            .sum();
        if total * legs > MOST {
            return None;
        }
        let profile = problem.profile();
        let longest = problem.letters.iter().copied().max().unwrap_or(0);
        let cells = (0..total).map(|index| {
            let mut rest = index;
            let mut parameters = ranges;
            for (parameter, cuts) in parameters.iter_mut().zip(cuts) {
                *parameter = parameter.part(rest % cuts, cuts);
                rest /= cuts;
            }
            let cell = Cell::new(problem.mirrored, parameters, side, &profile);
            let turns = (0..=longest).map(|n| cell.turned(n)).collect();
            (cell, turns)
        });
        Some(Attempt { problem, cuts, parts, cells: cells.collect(), previous })
    }

    /// Boxes that close, or why there are none.
    pub fn close(&self) -> Result<Closed, String> {
        let boxes = self.settled()?;
        self.speeds(&boxes)?;
        let (_, slopes) = self.image(&boxes, false)?;
        let (_, least) = self.weights(&boxes, &slopes);
        if least >= MOST_CONTRACTION {
            return Err(slow(least));
        }
        let mut reason = String::from("the map does not keep boxes a little wider than its least");
        // With one box per letter, finer cuts do more than the last two.
        let letters = &self.problem.letters;
        let histories = (1..letters.len()).any(|n| letters[..n].contains(&letters[n]));
        let shares = [(0.02, 1), (0.05, 1), (0.1, 1), (0.005, 1), (1e-3, 60), (2e-4, 60)];
        for &(share, rounds) in &shares[..if histories { 6 } else { 4 }] {
            let Some((boxes, slopes)) = self.widened(&boxes, share, rounds) else { continue };
            let (weights, contraction) = self.weights(&boxes, &slopes);
            if contraction >= MOST_CONTRACTION {
                reason = slow(contraction);
                continue;
            }
            self.speeds(&boxes)?;
            let (window, pieces, reach) = self.window(&boxes)?;
            let (cells, parts) = (self.cuts, self.parts.clone());
            let complete = None;
            return Ok(Closed { cells, parts, boxes, weights, contraction, window, pieces, reach, complete });
        }
        Err(reason)
    }

    /// Boxes that the map keeps, with its derivatives there: the image of the last ones, wider by a share of
    /// the first, round by round. Where the map hardly contracts one round does not do.
    fn widened(&self, boxes: &[[Span; 2]], share: f64, rounds: u64) -> Option<(Vec<[Span; 2]>, Vec<Slopes>)> {
        let margins: Vec<[f64; 2]> = boxes.iter().map(|pair| pair.map(|span| share * span.width())).collect();
        let mut image = boxes.to_vec();
        for _ in 0..rounds {
            let both = image.iter().zip(&margins);
            let wide: Vec<[Span; 2]> =
                both.map(|(pair, margin)| [0, 1].map(|i| rounded(pair[i], margin[i], rounds > 1))).collect();
            let (next, slopes) = self.image(&wide, false).ok()?;
            if wide.iter().zip(&next).all(|(wide, next)| (0..2).all(|i| next[i].is_in(wide[i]))) {
                return Some((wide, slopes));
            }
            image = next;
        }
        None
    }

    /// Boxes that the map changes no more, from points.
    fn settled(&self) -> Result<Vec<[Span; 2]>, String> {
        let mut boxes = self.start()?;
        // Of letters with a history the boxes grow by one step of it per round.
        let rounds = 80 + boxes.len();
        for _ in 0..rounds {
            let (image, _) = self.image(&boxes, false)?;
            let settled = boxes.iter().zip(&image).all(|(old, new)| {
                (0..2).all(|i| {
                    let (old, new) = (old[i], new[i]);
                    (old.lo - new.lo).abs().max((old.hi - new.hi).abs()) <= 1e-3 * new.width() + 1e-13
                })
            });
            boxes = image;
            if settled {
                return Ok(boxes);
            }
        }
        Err(format!("the boxes still grow after {rounds} rounds"))
    }

    /// Whether a certificate with these cells and parts holds, as far as floats tell.
    pub fn holds(&self, certificate: &Certificate) -> Result<(), String> {
        const SMALL: f64 = 1e-12;
        let range = |[lo, hi]: [Decimal; 2]| Span::new(float(lo), float(hi));
        let boxes: Vec<[Span; 2]> =
            certificate.letters.iter().map(|letter| [range(letter.after), range(letter.before)]).collect();
        let (image, slopes) = self.image(&boxes, true)?;
        if !boxes.iter().zip(&image).all(|(old, new)| (0..2).all(|i| new[i].is_in(old[i].widened(SMALL)))) {
            return Err("a box is left (H1)".into());
        }
        let weights: Vec<[f64; 2]> =
            certificate.letters.iter().map(|letter| letter.weights.map(float)).collect();
        let rows = self.rows(&weights, &slopes);
        let most = float(certificate.contraction) * (1.0 + SMALL);
        if !rows.iter().flatten().zip(weights.iter().flatten()).all(|(row, weight)| *row <= most * weight)
            || most >= 1.0
        {
            return Err("no contraction (H2)".into());
        }
        self.speeds(&boxes)?;
        let (_, reach) =
            self.gaps(&boxes, float(certificate.window), certificate.pieces).map_err(|why| why + " (H4)")?;
        if let Some(claim) = &certificate.complete {
            self.alone(&boxes, float(certificate.window), claim).map_err(|why| why + " (C)")?;
        }
        if reach > float(certificate.reach) + SMALL { Err("the reach".into()) } else { Ok(()) }
    }

    /// The velocities of each letter between impacts of strength 0, in the middle of the parameters.
    fn start(&self) -> Result<Vec<[Span; 2]>, String> {
        let (cell, turns) = &self.cells[self.cells.len() / 2];
        let still = cell.impact(Span::point(0.0)).ok_or("an impact of strength 0 is out of reach")?;
        let leg = |&n: &u64| {
            let leg = cell.leg(turns[n as usize], n, [&still, &still], [&still, &still]);
            if leg.after.is_finite() { Ok([leg.after, leg.before]) } else { Err(self.singular(n)) }
        };
        self.problem.letters.iter().map(leg).collect()
    }

    /// The image of boxes, and the greatest derivatives on them for each triple; for each cell and part of
    /// phases if `apart`.
    fn image(&self, boxes: &[[Span; 2]], apart: bool) -> Result<(Vec<[Span; 2]>, Vec<Slopes>), String> {
        let mut image: Vec<Option<[Span; 2]>> = vec![None; boxes.len()];
        let mut slopes: Vec<Slopes> = Vec::new();
        for (cell, turns) in &self.cells {
            let impacts = |m: usize, n: usize, parts: u64| -> Result<Vec<[Impact; 2]>, String> {
                let s = cell.strength(boxes[n][0], boxes[m][1]);
                let one = |i| {
                    let s = s.part(i, parts);
                    Some([cell.impact(s)?, cell.impact(Span::point(s.middle()))?])
                };
                let all: Option<Vec<_>> = (0..parts).map(one).collect();
                all.ok_or_else(|| {
                    format!("the phase between letters {} and {} is not bounded", self.name(m), self.name(n))
                })
            };
            let mut at = 0;
            for (n, &periods) in self.problem.letters.iter().enumerate() {
                let last: Vec<_> = self.problem.next[n]
                    .iter()
                    .map(|&k| impacts(n, k, self.parts[n]))
                    .collect::<Result<_, _>>()?;
                for &m in &self.previous[n] {
                    let first = impacts(m, n, self.parts[n])?;
                    for (&k, last) in self.problem.next[n].iter().zip(&last) {
                        let mut all = [0.0f64; 4];
                        for (from, to) in first.iter().flat_map(|from| last.iter().map(move |to| (from, to)))
                        {
                            let leg = cell.leg(
                                turns[periods as usize],
                                periods,
                                [&from[0], &to[0]],
                                [&from[1], &to[1]],
                            );
                            // Beyond 10⁴ no box of a proof is of use: E₁₂ is near 0 somewhere in the cell.
                            if !(leg.after.is_finite() && leg.before.is_finite())
                                || leg.after.magnitude().max(leg.before.magnitude()) > 1e4
                            {
                                return Err(self.singular(periods));
                            }
                            let ([a, b], [c, d]) = (leg.after_slopes, leg.before_slopes);
                            if apart {
                                let all = [a, b, c, d].map(Span::magnitude);
                                slopes.push(Slopes { triple: [m, n, k], all });
                            }
                            for (most, slope) in all.iter_mut().zip([a, b, c, d]) {
                                *most = most.max(slope.magnitude());
                            }
                            let new = [leg.after, leg.before];
                            image[n] =
                                Some(image[n].map_or(new, |old| [old[0].hull(new[0]), old[1].hull(new[1])]));
                        }
                        if apart {
                            continue;
                        }
                        // Cells come in turn, with the same triples in the same order: the place says which
                        // triple it is.
                        match slopes.get_mut(at) {
                            None => slopes.push(Slopes { triple: [m, n, k], all }),
                            Some(known) => (0..4).for_each(|i| known.all[i] = known.all[i].max(all[i])),
                        }
                        at += 1;
                    }
                }
            }
        }
        let image: Option<Vec<_>> = image.into_iter().collect();
        Ok((image.ok_or("a letter is on no path")?, slopes))
    }

    fn name(&self, n: usize) -> String {
        self.problem.periods(self.problem.letters[n])
    }

    fn singular(&self, periods: u64) -> String {
        let periods = self.problem.periods(periods);
        format!(
            "letter {periods}: a leg of {periods} periods is near one that returns every velocity to one place (E12 = 0)"
        )
    }

    /// Weights that make the contraction about as small as it can be, and that contraction.
    fn weights(&self, boxes: &[[Span; 2]], slopes: &[Slopes]) -> (Vec<[f64; 2]>, f64) {
        let mut w: Vec<[f64; 2]> = boxes.iter().map(|pair| pair.map(|span| span.width() + 1e-9)).collect();
        let mut best = (w.clone(), f64::INFINITY);
        for _ in 0..400 {
            let greatest = w.iter().flatten().copied().fold(0.0, f64::max);
            w.iter_mut().flatten().for_each(|x| *x = (*x / greatest).max(1e-7));
            w.iter_mut().flatten().for_each(|x| *x = (*x * 1e9).ceil() / 1e9);
            let rows = self.rows(&w, slopes);
            let ratio =
                rows.iter().flatten().zip(w.iter().flatten()).map(|(row, w)| row / w).fold(0.0, f64::max);
            if ratio < best.1 {
                best = (w.clone(), ratio);
            }
            w.iter_mut()
                .flatten()
                .zip(rows.iter().flatten())
                .for_each(|(w, row)| *w = 0.5 * *w * ratio + 0.5 * row);
        }
        best
    }

    /// The left sides of H2, the greatest over all triples.
    fn rows(&self, w: &[[f64; 2]], slopes: &[Slopes]) -> Vec<[f64; 2]> {
        let shares = [0, 1].map(|i| self.cells.iter().map(|(cell, _)| cell.shares[i].hi).fold(0.0, f64::max));
        let mut rows = vec![[0.0f64; 2]; w.len()];
        for Slopes { triple: [m, n, k], all } in slopes {
            let first = shares[0] * w[*n][0] + shares[1] * w[*m][1];
            let last = shares[0] * w[*k][0] + shares[1] * w[*n][1];
            rows[*n][0] = rows[*n][0].max(all[0] * first + all[1] * last);
            rows[*n][1] = rows[*n][1].max(all[2] * first + all[3] * last);
        }
        rows
    }

    /// H3.
    fn speeds(&self, boxes: &[[Span; 2]]) -> Result<(), String> {
        for (m, next) in self.problem.next.iter().enumerate() {
            for &n in next {
                if boxes[n][0].lo <= boxes[m][1].hi {
                    let (m, n) = (self.name(m), self.name(n));
                    return Err(format!("an impact between letters {m} and {n} may have speed 0"));
                }
            }
        }
        Ok(())
    }

    /// A window and pieces for which H4 holds, with the reach.
    fn window(&self, boxes: &[[Span; 2]]) -> Result<(f64, u64, f64), String> {
        let mut why = String::from("the phases do not fit into a window");
        for (window, pieces) in WINDOWS.iter().flat_map(|&window| [(window, 16), (window, 64)]) {
            match self.gaps(boxes, window, pieces) {
                Ok((edge, reach)) if edge < 0.999 => return Ok((window, pieces, reach)),
                Ok(_) => why = format!("a phase may leave the window of {window}"),
                Err(reason) => why = reason,
            }
        }
        Err(why)
    }

    /// H4 and the phases' part of H0: the greatest phase as a part of the window, and the greatest q/ν.
    fn gaps(&self, boxes: &[[Span; 2]], window: f64, pieces: u64) -> Result<(f64, f64), String> {
        if window >= FRAC_PI_2 {
            return Err("the window is not below pi/2".into());
        }
        if self.cells[0].0.least_bend(window, pieces) <= 1e-9 {
            return Err(format!("the wall is not convex on a window of {window}"));
        }
        let (mut edge, mut reach) = (0.0f64, f64::NEG_INFINITY);
        for ((cell, _), n) in self.cells.iter().flat_map(|cell| (0..boxes.len()).map(move |n| (cell, n))) {
            let hull = |list: &mut dyn Iterator<Item = Span>| {
                list.reduce(Span::hull).and_then(|s| cell.impact(s)).ok_or("a phase is not bounded")
            };
            let first = hull(&mut self.previous[n].iter().map(|&m| cell.strength(boxes[n][0], boxes[m][1])))?;
            let last =
                hull(&mut self.problem.next[n].iter().map(|&k| cell.strength(boxes[k][0], boxes[n][1])))?;
            edge = edge.max(first.phase.magnitude().max(last.phase.magnitude()) / window);
            if edge >= 1.0 {
                return Err(format!("a phase may leave the window of {window}"));
            }
            let periods = self.problem.letters[n];
            let (most, fails) = cell.gap(periods, [&first, &last], boxes[n][0], window, pieces);
            reach = reach.max(most);
            if let Some(fails) = fails {
                return Err(format!("letter {}: {fails}", self.name(n)));
            }
        }
        Ok((edge, reach))
    }
}

fn slow(contraction: f64) -> String {
    format!("the map does not contract: {contraction:.3} at best")
}

/// A box wider by so much on each side, its ends short decimals, or with two more digits.
fn rounded(span: Span, margin: f64, finer: bool) -> Span {
    let wide = span.widened(margin + 1e-11);
    let scale = 10f64.powi((places(wide) + if finer { 2 } else { 0 }).min(13));
    Span::new((wide.lo * scale).floor() / scale, (wide.hi * scale).ceil() / scale)
}
