//! Basins of attraction on a grid of starts, in parallel.

use std::path::Path;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::{
    checkpoint::Checkpoint,
    detection::{Cycle, Detection, Fate, wait},
    dynamics::{Dynamics, SectionState},
};
use crate::{error::Result, monitor::Monitor, oscillator::simulate::RunEnd};

/// A grid of starts at the phase of the detection's section: `columns` values of q by `rows` of u, ends
/// included.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BasinGrid {
    /// The least and the greatest q.
    pub q: [f64; 2],
    /// The least and the greatest u.
    pub u: [f64; 2],
    /// How many q.
    pub columns: usize,
    /// How many u.
    pub rows: usize,
}

/// What becomes of one start.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[non_exhaustive]
pub enum BasinCell {
    /// The index of its attractor.
    Attractor(usize),
    /// No recurrence seen.
    Irregular,
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
    /// The start of a cell.
    pub fn start(&self, column: usize, row: usize) -> [f64; 2] {
        let place = |[low, high]: [f64; 2], i: usize, count: usize| {
            if count < 2 { low } else { low + (high - low) * i as f64 / (count - 1) as f64 }
        };
        [place(self.q, column, self.columns), place(self.u, row, self.rows)]
    }
}

/// Rows that run in parallel before what they lead to is sorted and kept.
const CHUNK: usize = 16;

/// Detects the attractor of every start, on all cores; the result does not depend on their number. With a
/// file, what is done is kept there, and what it holds of the same grid is not done again; `identity` is what
/// else the result depends on. The monitor hears of each row.
///
/// # Errors
/// Those of [`Detection::check`]; an unusable checkpoint; the monitor's, after a last checkpoint.
pub fn basins<D: Dynamics>(
    dynamics: &D,
    grid: &BasinGrid,
    detection: &Detection,
    identity: &str,
    file: Option<&Path>,
    monitor: &dyn Monitor,
) -> Result<Basins<D::Point>> {
    detection.check()?;
    let settled = Detection { transient: 0, ..detection.clone() };
    let row = |row: usize| {
        let fates = (0..grid.columns)
            .map(|column| {
                monitor.advance(0)?;
                let start = dynamics.in_plane(grid.start(column, row), detection.phase);
                match dynamics.begin(&start) {
                    Ok(mut run) => {
                        let end = wait(&mut run, detection.phase, detection.transient, monitor)?;
                        match end {
                            RunEnd::Reached => settled.detect(&mut run).map(Some),
                            end => Ok(Some(Fate::Ended(end))),
                        }
                    }
                    Err(_) => Ok(None),
                }
            })
            .collect::<Result<Vec<_>>>()?;
        monitor.advance(1)?;
        Ok(fates)
    };
    let job = serde_json::to_string(&(grid, detection)).map_err(std::io::Error::other)?;
    // 64 bytes for each cell; the points of attractors, which are few.
    let most = (1 << 30) + 64 * (grid.columns * grid.rows) as u64;
    let (mut checkpoint, mut found): (_, Vec<Basins<D::Point>>) =
        Checkpoint::open(file, "basins", &format!("{identity} {job}"), most, monitor)?;
    let mut done = found.pop().unwrap_or_else(|| Basins { attractors: Vec::new(), cells: Vec::new() });
    if !done.can_be(grid, detection) {
        return Err(checkpoint.bad("its record is not of these basins"));
    }
    let first = done.cells.len() / grid.columns;
    monitor.advance(first as u64)?;
    for rows in (first..grid.rows).collect::<Vec<_>>().chunks(CHUNK) {
        let fates: Result<Vec<_>> = rows.par_iter().map(|&i| row(i)).collect();
        let fates = match fates {
            Ok(fates) => fates,
            Err(error) => {
                checkpoint.replace_now(&done)?;
                return Err(checkpoint.ended(error, done.cells.len() / grid.columns, grid.rows, "rows"));
            }
        };
        for fate in fates.into_iter().flatten() {
            let cell = done.cell(fate);
            done.cells.push(cell);
        }
        checkpoint.replace(&done)?;
    }
    Ok(done)
}

impl<P: SectionState> Basins<P> {
    /// Whether a run over the grid can have come to this.
    fn can_be(&self, grid: &BasinGrid, detection: &Detection) -> bool {
        let cycle = |cycle: &Cycle<P>| {
            (1..=detection.longest).contains(&cycle.points.len()) && cycle.points.iter().all(P::is_finite)
        };
        let cell = |cell: &BasinCell| match *cell {
            BasinCell::Attractor(index) => index < self.attractors.len(),
            _ => true,
        };
        self.cells.len().is_multiple_of(grid.columns)
            && self.cells.len() <= grid.columns * grid.rows
            && self.cells.iter().all(cell)
            && self.attractors.iter().all(cycle)
    }

    /// What is kept of a start; an attractor not met before is added.
    fn cell(&mut self, fate: Option<Fate<P>>) -> BasinCell {
        match fate {
            None => BasinCell::Behind,
            Some(Fate::Irregular) => BasinCell::Irregular,
            Some(Fate::Ended(end)) => BasinCell::Ended(end),
            Some(Fate::Periodic(cycle)) => {
                let known = self.attractors.iter().position(|other| other.is(&cycle));
                BasinCell::Attractor(known.unwrap_or_else(|| {
                    self.attractors.push(cycle);
                    self.attractors.len() - 1
                }))
            }
        }
    }
}
