//! Where chaos is born over all machines between bounds: a plane of natural over drive frequency and damping
//! ratio, cut for this question alone.
//!
//! Cells are halved until chaos is certainly born, or certainly not, on both sides of the touch, or until
//! they are as small as a picture shows. Where the damping reaches over several octaves, each is cut for
//! itself, so that cells look alike where a picture is logarithmic.

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};
use rayon::prelude::*;

use super::{
    cell::Cell,
    parameters::{Coordinates, ParameterBox, is_flat},
};
use crate::{
    error::{Error, Result},
    monitor::Monitor,
    word::Realm,
};

/// The most halvings of a side.
const FINEST: u32 = 12;
/// A damping that reaches over so many octaves is cut octave by octave.
const OCTAVES: usize = 3;

/// A plane of machines with what is certain of each cell.
#[derive(Debug, Clone)]
pub struct ChaosChart {
    /// The edges of the columns, by natural over drive frequency.
    pub columns: Vec<BigRational>,
    /// The edges of the rows, by damping ratio.
    pub rows: Vec<BigRational>,
    /// They cover all of it, once.
    pub cells: Vec<ChartCell>,
}

/// Some columns and rows of a chart.
#[derive(Debug, Clone)]
pub struct ChartCell {
    /// The first column, and the one after the last.
    pub columns: [usize; 2],
    /// The first row, and the one after the last.
    pub rows: [usize; 2],
    /// Whether chaos is born for eµ > 0 and for eµ < 0, if it is certain.
    pub chaos: [Option<bool>; 2],
}

impl ParameterBox {
    /// Whether chaos is born at all points, or at none, for eµ > 0 and for eµ < 0 with the machine's own γ.
    /// `None` where that differs or is not certain, or where γ is free.
    ///
    /// Cost: O(1) signs.
    pub fn chaos(&self) -> [Option<bool>; 2] {
        let cell = Cell::new(self);
        let Some(gamma) = cell.gamma else { return [None; 2] };
        // Of real eigenvalues γ > 0; period 1 alone occurs for eµ > 0, every period for eµ < 0.
        if cell.realm() == Realm::Two {
            return [Some(false), Some(true)];
        }
        [cell.chaos_ahead(gamma), cell.chaos_behind(gamma)]
    }
}

impl ChaosChart {
    /// The chart of a machine's box with 2^`halvings` columns and about as many rows.
    ///
    /// Cost: in the mean a few cells per row and change of a verdict, each O(1) signs, on all threads.
    ///
    /// # Errors
    /// An input error if it is not a machine's box, has no width or no height, or for more than 12 halvings;
    /// the monitor's interruption.
    pub fn new(of: &ParameterBox, halvings: u32, monitor: &dyn Monitor) -> Result<ChaosChart> {
        let [ratio, damping] = of.bounds();
        if of.coordinates != Coordinates::Machine || of.bounds().iter().any(is_flat) || halvings > FINEST {
            return Err(Error::input(
                "a chart of chaos has a frequency and a damping ratio with two different ends each",
            ));
        }
        let octaves = octaves(damping);
        let height = 1usize << halvings.saturating_sub(octaves.len().next_power_of_two().ilog2());
        let width = 1usize << halvings;
        let edges = |[lower, upper]: &[BigRational; 2], count: usize| -> Vec<BigRational> {
            let part = |i: usize| BigRational::new(i.into(), count.into());
            (0..count).map(|i| lower + (upper - lower) * part(i)).collect()
        };
        let mut columns = edges(ratio, width);
        columns.push(ratio[1].clone());
        let mut rows: Vec<BigRational> = octaves.iter().flat_map(|octave| edges(octave, height)).collect();
        rows.push(damping[1].clone());
        let chart = ChaosChart { columns, rows, cells: Vec::new() };
        // Blocks for all threads, each cut by one of them.
        let across = width.min(16);
        let blocks: Vec<ChartCell> = (0..octaves.len())
            .flat_map(|y| (0..across).map(move |x| (x, y)))
            .map(|(x, y)| ChartCell {
                columns: [x, x + 1].map(|x| x * width / across),
                rows: [y, y + 1].map(|y| y * height),
                chaos: [None; 2],
            })
            .collect();
        monitor.begin(blocks.len() as u64, "parts");
        let cut = |block: ChartCell| -> Result<Vec<ChartCell>> {
            let cells = chart.cut(block, [width, octaves.len() * height])?;
            monitor.advance(1)?;
            Ok(cells)
        };
        let cells: Vec<Vec<ChartCell>> = blocks.into_par_iter().map(cut).collect::<Result<_>>()?;
        Ok(ChaosChart { cells: cells.concat(), ..chart })
    }

    /// The parameters of a cell.
    pub fn bounds(&self, cell: &ChartCell) -> [[BigRational; 2]; 2] {
        [cell.columns.map(|i| self.columns[i].clone()), cell.rows.map(|i| self.rows[i].clone())]
    }

    /// Halves a cell of a chart with these sides across what is longer, and so on.
    fn cut(&self, block: ChartCell, sides: [usize; 2]) -> Result<Vec<ChartCell>> {
        let mut open = vec![block];
        let mut cells = Vec::new();
        while let Some(cell) = open.pop() {
            let [ratio, damping] = self.bounds(&cell);
            let chaos = ParameterBox::machine(ratio, damping)?.chaos();
            let [wide, high] = [cell.columns, cell.rows].map(|[first, after]| after - first);
            if chaos.iter().all(Option::is_some) || (wide == 1 && high == 1) {
                cells.push(ChartCell { chaos, ..cell });
                continue;
            }
            let middle = |[first, after]: [usize; 2]| first + (after - first) / 2;
            let across = wide > 1 && (high == 1 || wide * sides[1] >= high * sides[0]);
            for end in [1, 0] {
                let mut half = cell.clone();
                if across {
                    half.columns[end] = middle(cell.columns);
                } else {
                    half.rows[end] = middle(cell.rows);
                }
                open.push(half);
            }
        }
        Ok(cells)
    }
}

/// From the lower end to twice it, and so on up to the upper end; all of it if that are few, or begin at 0.
fn octaves([lower, upper]: &[BigRational; 2]) -> Vec<[BigRational; 2]> {
    let mut edges = vec![lower.clone()];
    if lower.is_positive() && (upper / lower).to_u64().is_some_and(|ratio| ratio < 1 << 20) {
        let two = BigRational::from_integer(2.into());
        let mut next = lower * &two;
        while &next < upper {
            edges.push(next.clone());
            next *= &two;
        }
    }
    if edges.len() < OCTAVES {
        edges.truncate(1);
    }
    edges.push(upper.clone());
    edges.windows(2).map(|pair| [pair[0].clone(), pair[1].clone()]).collect()
}
