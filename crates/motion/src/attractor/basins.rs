//! Basins of attraction on a grid of starts, in parallel.

use std::{ops::Range, path::Path};

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::{
    checkpoint::{Checkpoint, Keep},
    cycle::Cycle,
    detection::{Detection, Fate},
    dynamics::SectionState,
    observe::Attraction,
};
use crate::{error::Result, monitor::Monitor, motion::RunEnd};

/// A grid of starts in a plane, that of (q, u) if no other is named: `columns` values of its first number by
/// `rows` of its second, ends included.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BasinGrid {
    /// The ends of the first number.
    pub q: [f64; 2],
    /// The ends of the second.
    pub u: [f64; 2],
    /// How many of the first.
    pub columns: usize,
    /// How many of the second.
    pub rows: usize,
}

/// What becomes of one start.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum BasinCell {
    /// The index of its attractor.
    Attractor(usize),
    /// No recurrence seen.
    Irregular,
    /// Not decided: a transient is not over, or points recur and no orbit is found.
    Unsettled,
    /// A start behind a wall.
    Behind,
    /// The run ended.
    Ended(RunEnd),
}

/// The attractors met, in order of the first start that leads to each, and the cells, q fastest.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Basins<P = [f64; 2]> {
    /// The attractors.
    pub attractors: Vec<Cycle<P>>,
    /// One cell a start.
    pub cells: Vec<BasinCell>,
}

impl BasinGrid {
    /// The two numbers of a cell's start.
    pub fn start(&self, column: usize, row: usize) -> [f64; 2] {
        let place = |[low, high]: [f64; 2], i: usize, count: usize| {
            if count < 2 { low } else { low + (high - low) * i as f64 / (count - 1) as f64 }
        };
        [place(self.q, column, self.columns), place(self.u, row, self.rows)]
    }
}

/// Rows that run in parallel before what they lead to is kept.
const CHUNK: usize = 16;

/// The most starts of several rows that are followed together.
const TOGETHER: usize = 256;

/// One in this many starts of a row is followed first.
const SCOUTS: usize = 24;

/// Detects the attractor of every start, on all cores; the result does not depend on their number. Motions of
/// oscillators are followed together, and no further than onto an attractor found in the same row. With a
/// file, what is done is kept there, and what it holds of the same grid is not done again; `identity` is what
/// else the result depends on. The monitor hears of each row.
///
/// # Errors
/// Those of [`Detection::check`]; an unusable checkpoint; the monitor's, after a last checkpoint.
pub fn basins<D: Attraction>(
    dynamics: &D,
    grid: &BasinGrid,
    detection: &Detection,
    identity: &str,
    file: Option<&Path>,
    monitor: &dyn Monitor,
) -> Result<Basins<D::Point>> {
    let start = |at| dynamics.in_plane(at, detection.phase);
    let keep = Keep { file, tally: None };
    let rows = basin_rows((dynamics, &start), grid, detection, 0..grid.rows, identity, keep, monitor)?;
    Ok(Basins::joined(rows))
}

/// The same for some rows of the grid, each by itself: its attractors are in the order of its own starts.
/// [`Basins::joined`] makes one of them. The function says which start has these two numbers; it may be at
/// any phase.
///
/// # Errors
/// Those of [`basins`].
pub fn basin_rows<D: Attraction>(
    (dynamics, place): (&D, &(dyn Fn([f64; 2]) -> D::Start + Sync)),
    grid: &BasinGrid,
    detection: &Detection,
    rows: Range<usize>,
    identity: &str,
    keep: Keep,
    monitor: &dyn Monitor,
) -> Result<Vec<Basins<D::Point>>> {
    detection.check()?;
    // Some spread over a row find its attractors; the others are followed no further than onto these.
    let (scouts, others): (Vec<usize>, Vec<usize>) =
        (0..grid.columns).partition(|column| column.is_multiple_of(SCOUTS));
    let fates = |places: &[(usize, usize)], known: &[Cycle<D::Point>]| {
        let start = |&(column, row): &(usize, usize)| place(grid.start(column, row));
        let starts: Vec<D::Start> = places.iter().map(start).collect();
        dynamics.fates(&starts, detection, known, monitor)
    };
    let row = |(row, first): (usize, &[Option<Fate<D::Point>>])| {
        let mut all = vec![None; grid.columns];
        let mut found = Basins { attractors: Vec::new(), cells: Vec::with_capacity(grid.columns) };
        for (&column, fate) in scouts.iter().zip(first) {
            if let Some(Fate::Periodic(cycle)) = fate {
                found.attractor(cycle.clone());
            }
            all[column] = fate.clone();
        }
        let places: Vec<(usize, usize)> = others.iter().map(|&column| (column, row)).collect();
        for (&column, fate) in others.iter().zip(fates(&places, &found.attractors)?) {
            all[column] = fate;
        }
        // In the order of the starts.
        found.attractors.clear();
        for fate in all {
            let cell = found.cell(fate);
            found.cells.push(cell);
        }
        monitor.advance(1)?;
        Ok(found)
    };
    let job = serde_json::to_string(&(grid, detection, &rows)).map_err(std::io::Error::other)?;
    // 64 bytes for each cell; the points of attractors, of which a row has few.
    let most = (1 << 30) + 64 * (grid.columns * rows.len()) as u64;
    let (mut checkpoint, mut done): (_, Vec<Basins<D::Point>>) =
        Checkpoint::open(keep, "basins", &format!("{identity} {job}"), most, monitor)?;
    if done.len() > rows.len() || !done.iter().all(|row| row.can_be_row(grid, detection)) {
        return Err(checkpoint.bad("its records are not rows of these basins"));
    }
    monitor.advance(done.len() as u64)?;
    for chunk in rows.clone().skip(done.len()).collect::<Vec<usize>>().chunks(CHUNK) {
        // The scouts of all these rows are followed together, as those of one would leave vectors empty.
        let places: Vec<(usize, usize)> =
            chunk.iter().flat_map(|&row| scouts.iter().map(move |&column| (column, row))).collect();
        let most = places.len().div_ceil(rayon::current_num_threads()).clamp(1, TOGETHER.max(scouts.len()));
        let first: Result<Vec<_>> = places.par_chunks(most).map(|places| fates(places, &[])).collect();
        let first = match first {
            Ok(first) => first.concat(),
            Err(error) => return Err(checkpoint.ended(error, done.len(), rows.len(), "rows")),
        };
        let of_row = |i: usize| (chunk[i], &first[i * scouts.len()..(i + 1) * scouts.len()]);
        let found: Vec<Result<_>> = (0..chunk.len()).into_par_iter().map(|i| row(of_row(i))).collect();
        match found.into_iter().collect::<Result<Vec<_>>>() {
            Ok(found) => {
                checkpoint.append(&found)?;
                done.extend(found);
            }
            Err(error) => return Err(checkpoint.ended(error, done.len(), rows.len(), "rows")),
        }
    }
    Ok(done)
}

impl<P: SectionState> Basins<P> {
    /// The basins of all rows, in order. An attractor of a row is one that was met before if the first cycles
    /// that led to them are the same ([`Cycle::is`]), so what comes out depends on the rows alone, not on who
    /// found them.
    ///
    /// # Panics
    /// If a cell of a row is of an attractor that the row does not have.
    pub fn joined(rows: impl IntoIterator<Item = Basins<P>>) -> Basins<P> {
        let mut all = Basins { attractors: Vec::new(), cells: Vec::new() };
        for Basins { attractors, cells } in rows {
            let places: Vec<usize> = attractors.into_iter().map(|cycle| all.attractor(cycle)).collect();
            all.cells.extend(cells.into_iter().map(|cell| match cell {
                BasinCell::Attractor(index) => BasinCell::Attractor(places[index]),
                cell => cell,
            }));
        }
        all
    }

    /// Whether a row of the grid can have come to this.
    pub fn can_be_row(&self, grid: &BasinGrid, detection: &Detection) -> bool {
        let cycle = |cycle: &Cycle<P>| {
            (1..=detection.longest).contains(&cycle.points.len())
                && cycle.points.iter().all(P::is_finite)
                && cycle.same.is_finite()
        };
        let cell = |cell: &BasinCell| match *cell {
            BasinCell::Attractor(index) => index < self.attractors.len(),
            _ => true,
        };
        self.cells.len() == grid.columns && self.cells.iter().all(cell) && self.attractors.iter().all(cycle)
    }

    /// The index of an attractor, which is added if it was not met before.
    fn attractor(&mut self, cycle: Cycle<P>) -> usize {
        self.attractors.iter().position(|other| other.is(&cycle)).unwrap_or_else(|| {
            self.attractors.push(cycle);
            self.attractors.len() - 1
        })
    }

    /// What is kept of a start; an attractor not met before is added.
    fn cell(&mut self, fate: Option<Fate<P>>) -> BasinCell {
        match fate {
            None => BasinCell::Behind,
            Some(Fate::Irregular) => BasinCell::Irregular,
            Some(Fate::Unsettled) => BasinCell::Unsettled,
            Some(Fate::Ended(end)) => BasinCell::Ended(end),
            Some(Fate::Periodic(cycle)) => BasinCell::Attractor(self.attractor(cycle)),
        }
    }
}
