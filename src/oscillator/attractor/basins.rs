//! Basins of attraction on a grid of starts, in parallel.

use rayon::prelude::*;

use super::detection::{Cycle, Detection, Fate};
use crate::{
    error::Result,
    monitor::Monitor,
    oscillator::{
        Time,
        simulate::{End, Simulator},
    },
};

/// A grid of starts at the phase of the detection's section: `columns` values of q by `rows` of u, ends included.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
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
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cell {
    /// The index of its attractor.
    Attractor(usize),
    /// No recurrence seen.
    Irregular,
    /// A start behind a wall.
    Behind,
    /// The run ended.
    Ended(End),
}

/// The attractors met, in order of the first start that leads to each, and the cells, q fastest.
#[derive(Debug, Clone, PartialEq)]
pub struct Basins {
    /// The attractors.
    pub attractors: Vec<Cycle>,
    /// One cell a start.
    pub cells: Vec<Cell>,
}

impl Frame {
    /// The start of a cell.
    pub fn start(&self, column: usize, row: usize) -> [f64; 2] {
        let place = |[low, high]: [f64; 2], i: usize, count: usize| {
            if count < 2 { low } else { low + (high - low) * i as f64 / (count - 1) as f64 }
        };
        [place(self.q, column, self.columns), place(self.u, row, self.rows)]
    }
}

/// Detects the attractor of every start, on all cores; the result does not depend on their number. Attractors within 1000 times the
/// detection's tolerance are one. The monitor hears of each row.
///
/// # Errors
/// Those of [`Detection::check`], and the monitor's.
pub fn basins(
    simulator: &Simulator,
    frame: &Frame,
    detection: &Detection,
    monitor: &impl Monitor,
) -> Result<Basins> {
    detection.check()?;
    let row = |row: usize| {
        let fates: Result<Vec<_>> = (0..frame.columns)
            .map(|column| {
                let [q, u] = frame.start(column, row);
                match simulator.start(Time::new(0, detection.phase), q, u) {
                    Ok(mut run) => detection.detect(&mut run).map(Some),
                    Err(_) => Ok(None),
                }
            })
            .collect();
        monitor.advance(1)?;
        fates
    };
    let fates: Vec<Vec<Option<Fate>>> = (0..frame.rows).into_par_iter().map(row).collect::<Result<_>>()?;
    let mut attractors: Vec<Cycle> = Vec::new();
    let mut index = |cycle: Cycle| {
        let known = attractors.iter().position(|other| other.is(&cycle, 1000.0 * detection.tolerance));
        known.unwrap_or_else(|| {
            attractors.push(cycle);
            attractors.len() - 1
        })
    };
    let cells = fates
        .into_iter()
        .flatten()
        .map(|fate| match fate {
            None => Cell::Behind,
            Some(Fate::Periodic(cycle)) => Cell::Attractor(index(cycle)),
            Some(Fate::Irregular) => Cell::Irregular,
            Some(Fate::Ended(end)) => Cell::Ended(end),
        })
        .collect();
    Ok(Basins { attractors, cells })
}
