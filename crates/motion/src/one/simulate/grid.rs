//! Pieces of a linear flow: a fixed grid of cells over the forcing period, everything about it in tables.
//!
//! The motion is p + y with p the particular solution and y homogeneous, so that a forced oscillator against
//! a wall Q is a free one against the wall Q − p, known in advance. Per cell a table holds the Taylor
//! polynomial of p − Q about its middle; y about the middle is two numbers times two basis polynomials, the
//! same in all cells, and one matrix takes it to the next cell. No sine, exponential or division is left. An
//! autonomous oscillator needs one row for all cells: there p starts anew, at rest, in the middle of each
//! cell.
//!
//! A cell is at most 1/R wide, R the largest of the frequencies in forcing and walls and of the moduli of the
//! eigenvalues: the terms left out are below 2⁻¹⁶/16! < 10⁻¹⁸ of the amplitude for sines, and 32 times that
//! for the homogeneous motion (at critical damping).

use std::f64::consts::{PI, TAU};

use super::pieces::{LOWER, Pieces};
use crate::{
    error::{Error, Result},
    motion::{
        Contact, Counter, Effect, Flow, RunEnd, State, Time,
        algebra::{Matrix2, apply},
        flow::{Linear, Recurrence},
        minimum::{Head, head},
    },
};

/// Coefficients of a polynomial.
pub(super) const TERMS: usize = 16;

/// Finer grids than this are refused: a table of it fills 8 MB.
const MOST_CELLS: usize = 1 << 16;

/// A homogeneous motion smaller than this at the turn of a period is taken for none. It is so far below every
/// depth that it tells nothing. Followed on, its squares and then itself would become subnormal numbers, and
/// stay so for good: a processor takes twenty times as long for them.
pub(super) const NOTHING: f64 = 1e-150;

pub(super) type Polynomial = [f64; TERMS];

/// The tables. Without `DRIVEN` (no forcing, no moving wall) there is one row for all cells.
#[derive(Debug, Clone)]
pub(super) struct Grid<const DRIVEN: bool> {
    flow: Linear,
    cells: usize,
    /// Half the width of a cell.
    half: f64,
    /// q of the homogeneous motions that start from the middle as (1, 0) and (0, 1).
    basis: [Polynomial; 2],
    heads: [Head; 2],
    /// From a cell's middle to the next.
    matrix: Matrix2,
    /// What y gains where p starts anew: at each turn of the period; without `DRIVEN` of the cell.
    step: [f64; 2],
    /// Per wall and cell: ±(p − Q).
    drive: [Vec<(Head, Polynomial)>; 2],
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Cursor {
    pub period: i64,
    pub cell: usize,
    /// The homogeneous motion at the middle of the cell.
    pub y: [f64; 2],
    pub from: f64,
}

/// The tables of any grid, for those who follow many motions at once.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tables<'a> {
    pub driven: bool,
    pub cells: usize,
    pub half: f64,
    pub basis: &'a [Polynomial; 2],
    pub heads: &'a [Head; 2],
    pub matrix: &'a Matrix2,
    pub step: [f64; 2],
    pub drive: [&'a [(Head, Polynomial)]; 2],
}

/// Where a phase lies on the grid, and how a motion that is there is read as a state.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub cell: usize,
    pub from: f64,
    matrix: Matrix2,
    /// p at the middle of the cell as the tables have it, there as the flow has it, and at the phase.
    particular: [[f64; 2]; 3],
}

impl Place {
    /// (q, u) of the homogeneous motion y about the middle of the cell: what [`Pieces::state`] says.
    #[inline]
    pub fn state(&self, y: [f64; 2]) -> [f64; 2] {
        let [table, here, there] = self.particular;
        let [q, u] = [y[0] + table[0], y[1] + table[1]];
        let [q, u] = apply(&self.matrix, [q - here[0], u - here[1]]);
        [q + there[0], u + there[1]]
    }
}

impl<const DRIVEN: bool> Grid<DRIVEN> {
    /// # Errors
    /// A frequency that would take more than 2¹⁶ cells a period.
    pub fn new(flow: &Linear, contacts: &[Option<Contact>; 2]) -> Result<Self> {
        let order = contacts.iter().flatten().map(|c| c.position.order()).max().unwrap_or(0);
        let order = f64::from(order.max(flow.equation().forcing.order()));
        let cells = (TAU * order.max(flow.rate())).ceil().max(8.0);
        if cells > MOST_CELLS as f64 {
            return Err(Error::input(format!(
                "the fastest frequency is {:.0} times that of the forcing period: at most {:.0} can be followed",
                cells / TAU,
                MOST_CELLS as f64 / TAU
            )));
        }
        let (half, cells) = (PI / cells, cells as usize);
        let (free, forced) = (Recurrence(flow.equation().unforced()), Recurrence(flow.equation().clone()));
        let expand = |recurrence: &Recurrence, t, [q, u]: [f64; 2]| {
            let mut polynomial = [0.0; TERMS];
            recurrence.expand(State { t, q, u }, half, &mut polynomial);
            polynomial
        };
        let row = |contact: &Contact, cell| {
            let t = middle(cell, half);
            let mut row = expand(&forced, t, if DRIVEN { flow.particular(t) } else { [0.0; 2] });
            contact.position.add_taylor(-1.0, t, half, &mut row);
            let row = row.map(|c| contact.side.sign() * c);
            (head(&row), row)
        };
        let basis = [expand(&free, 0.0, [1.0, 0.0]), expand(&free, 0.0, [0.0, 1.0])];
        let rest = flow.advance(State { t: 0.0, q: 0.0, u: 0.0 }, 2.0 * half);
        // Without a drive all cells are alike.
        let rows = if DRIVEN { cells } else { 1 };
        let table = |contact: &Option<Contact>| {
            contact.as_ref().map_or(Vec::new(), |contact| (0..rows).map(|cell| row(contact, cell)).collect())
        };
        Ok(Grid {
            cells,
            half,
            heads: [head(&basis[0]), head(&basis[1])],
            basis,
            matrix: flow.matrix(2.0 * half),
            step: if DRIVEN { apply(&flow.matrix(half), flow.step()) } else { [rest.q, rest.u] },
            drive: [table(&contacts[0]), table(&contacts[1])],
            flow: flow.clone(),
        })
    }

    pub fn tables(&self) -> Tables<'_> {
        Tables {
            driven: DRIVEN,
            cells: self.cells,
            half: self.half,
            basis: &self.basis,
            heads: &self.heads,
            matrix: &self.matrix,
            step: self.step,
            drive: [&self.drive[0], &self.drive[1]],
        }
    }

    pub fn place(&self, phase: f64) -> Place {
        let (_, cell, from) = self.target(Time { period: 0, phase });
        let (t, duration) = (self.middle(cell), from * self.half);
        let particular = [self.particular(cell), self.flow.particular(t), self.flow.particular(t + duration)];
        Place { cell, from, matrix: self.flow.matrix(duration), particular }
    }

    /// How far the middle of the cell is from the start of its period.
    fn middle(&self, cell: usize) -> f64 {
        middle(cell, self.half)
    }

    /// The row of the table for the cell.
    fn row(&self, cursor: &Cursor) -> usize {
        if DRIVEN { cursor.cell } else { 0 }
    }

    /// p at the middle of a cell.
    fn particular(&self, cell: usize) -> [f64; 2] {
        if DRIVEN { self.flow.particular(self.middle(cell)) } else { [0.0; 2] }
    }
}

fn middle(cell: usize, half: f64) -> f64 {
    (2 * cell + 1) as f64 * half
}

impl<const DRIVEN: bool> Pieces for Grid<DRIVEN> {
    type Cursor = Cursor;
    type Gap = Polynomial;
    type Target = (i64, usize, f64);

    fn start<C: Counter>(&self, time: Time, q: f64, u: f64, _: &mut C) -> Cursor {
        let (period, cell, from) = self.target(time);
        let State { q, u, .. } = self.flow.advance(State { t: time.phase, q, u }, -from * self.half);
        let p = self.particular(cell);
        Cursor { period, cell, y: [q - p[0], u - p[1]], from }
    }

    fn from(&self, cursor: &Cursor) -> f64 {
        cursor.from
    }

    fn pass(&self, cursor: &mut Cursor, x: f64) {
        cursor.from = x;
    }

    #[inline]
    fn head<C: Counter, const WALL: usize>(&self, cursor: &Cursor, counter: &mut C) -> Head {
        if DRIVEN {
            counter.count(Effect::Drive);
        }
        let sign = if WALL == LOWER { 1.0 } else { -1.0 };
        let ([a, b], [one, other], drive) = (cursor.y, &self.heads, &self.drive[WALL][self.row(cursor)].0);
        let term = |i: usize| sign * (a * one[i] + b * other[i]) + drive[i];
        [term(0), term(1), term(2), a.abs() * one[3] + b.abs() * other[3] + drive[3]]
    }

    fn gap<const WALL: usize>(&self, cursor: &Cursor) -> Polynomial {
        let sign = if WALL == LOWER { 1.0 } else { -1.0 };
        let (a, b) = (sign * cursor.y[0], sign * cursor.y[1]);
        let mut gap = self.drive[WALL][self.row(cursor)].1;
        for (i, c) in gap.iter_mut().enumerate() {
            *c += a * self.basis[0][i] + b * self.basis[1][i];
        }
        gap
    }

    fn turn<C: Counter>(&self, cursor: &mut Cursor, _: &mut C) {
        cursor.y = apply(&self.matrix, cursor.y);
        cursor.from = -1.0;
        cursor.cell += 1;
        let last = cursor.cell == self.cells;
        if last {
            (cursor.cell, cursor.period) = (0, cursor.period + 1);
        }
        if last || !DRIVEN {
            cursor.y = [cursor.y[0] + self.step[0], cursor.y[1] + self.step[1]];
        }
        if last && cursor.y[0].abs() + cursor.y[1].abs() < NOTHING {
            cursor.y = [0.0; 2];
        }
    }

    fn kick<C: Counter>(&self, cursor: &mut Cursor, x: f64, du: f64, _: &mut C) {
        // The motion (0, du) at x, seen from the middle.
        let [q, slope] =
            self.basis[1].iter().rev().fold([0.0; 2], |[q, slope], c| [q * -x + c, slope * -x + q]);
        cursor.y = [cursor.y[0] + du * q, cursor.y[1] + du * slope / self.half];
        cursor.from = x;
    }

    fn jump<C: Counter>(&self, origin: &Cursor, cursor: &mut Cursor, until: Time, _: &mut C) {
        let (period, cell, from) = self.target(until);
        let there = Time { period, phase: self.middle(cell) };
        let mut here = Time { period: origin.period, phase: self.middle(origin.cell) };
        let mut y = origin.y;
        if !DRIVEN {
            let State { q, u, .. } = self.flow.advance(State { t: 0.0, q: y[0], u: y[1] }, there.since(here));
            *cursor = Cursor { period, cell, y: [q, u], from };
            return;
        }
        // Near resonance p starts anew each period.
        while self.step != [0.0; 2] && here.period < period {
            let [a, b] = apply(&self.flow.matrix(TAU + self.half - here.phase), y);
            y = [a + self.step[0], b + self.step[1]];
            here = Time { period: here.period + 1, phase: self.half };
        }
        *cursor = Cursor { period, cell, y: apply(&self.flow.matrix(there.since(here)), y), from };
    }

    fn target(&self, until: Time) -> (i64, usize, f64) {
        let cell = ((until.phase / (2.0 * self.half)) as usize).min(self.cells - 1);
        (until.period, cell, (until.phase - self.middle(cell)) / self.half)
    }

    fn reach(&self, cursor: &Cursor, (period, cell, x): (i64, usize, f64)) -> f64 {
        if (cursor.period, cursor.cell) < (period, cell) { f64::INFINITY } else { x }
    }

    fn time(&self, cursor: &Cursor, x: f64) -> Time {
        Time::new(cursor.period, self.middle(cursor.cell) + x * self.half)
    }

    fn scale(&self, _: &Cursor) -> f64 {
        self.half
    }

    fn state(&self, cursor: &Cursor, x: f64) -> State {
        let (t, p) = (self.middle(cursor.cell), self.particular(cursor.cell));
        self.flow.advance(State { t, q: cursor.y[0] + p[0], u: cursor.y[1] + p[1] }, x * self.half)
    }

    fn leave(&self, cursor: &Cursor) -> Option<Cursor> {
        Some(*cursor)
    }

    fn join(&self, cursor: Cursor) -> Cursor {
        cursor
    }

    fn over(&self, cursor: &Cursor) -> Option<RunEnd> {
        super::unbounded(cursor.y[0].abs() + cursor.y[1].abs()).then_some(RunEnd::Escaped)
    }
}
