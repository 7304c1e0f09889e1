//! The charts of a cover: region 3 cut into strips of s and rows of r.

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{One, ToPrimitive};

use crate::{
    error::Result,
    existence::{Interval, Variant, intervals},
};

/// A closed interval of s between two neighbouring cuts: the multiples of 1/(2n), where u_n = 0, and the ends
/// of the claimed intervals.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Strip {
    /// The left end, in lowest terms.
    pub left: Ratio<u64>,
    /// The right end, in lowest terms.
    pub right: Ratio<u64>,
    /// The claimed interval, if there is one; it is the whole strip.
    pub interval: Option<Interval>,
}

impl Strip {
    /// Whether s = 0 or s = ½ is an end: there sin θ is divided out.
    pub(super) fn is_outermost(&self) -> bool {
        *self.left.numer() == 0 || self.right == Ratio::new_raw(1, 2)
    }

    /// The sign t that all N_{n,k} must have for an orbit in the claimed case: u_n t = sign eµ and t = −sign
    /// γ.
    pub(super) fn sign(&self) -> Option<f64> {
        self.interval.as_ref().map(|interval| -f64::from(interval.case.sign_gamma()))
    }
}

/// The strips of period `n`, from s = 0 to s = ½. O(n log n).
///
/// # Errors
/// An input error unless 3 ≤ n ≤ [`MAX_PERIOD`](crate::existence::MAX_PERIOD).
pub fn strips(n: u64, variant: Variant) -> Result<Vec<Strip>> {
    let claimed: Vec<Interval> = intervals(n)?.map(|interval| altered(interval, variant)).collect();
    let mut cuts: Vec<Ratio<u64>> = (0..=n).map(|j| Ratio::new(j, 2 * n)).collect();
    cuts.extend(claimed.iter().flat_map(|interval| [interval.left, interval.right]));
    cuts.sort_by(|a, b| (a.numer() * b.denom()).cmp(&(b.numer() * a.denom())));
    cuts.dedup();
    let strip = |pair: &[Ratio<u64>]| Strip {
        left: pair[0],
        right: pair[1],
        interval: claimed
            .iter()
            .find(|interval| interval.left == pair[0] && interval.right == pair[1])
            .cloned(),
    };
    Ok(cuts.windows(2).map(strip).collect())
}

/// The interval as a variant of Conjecture 1 has it.
fn altered(mut interval: Interval, variant: Variant) -> Interval {
    match variant {
        Variant::NeighboursExchanged => interval.deciding = interval.deciding.map(|k| interval.n - k),
        Variant::EndsShifted if interval.m == 0 => interval.right = Ratio::new(1, 2 * interval.n + 1),
        _ => {}
    }
    interval
}

/// The rows' ends: 0, ½, ¾, …, geometric in 1 − r, and `r_max` last.
pub(super) fn row_ends(r_max: &BigRational) -> Vec<BigRational> {
    let cuts = std::iter::successors(Some(BigRational::one()), |gap| Some(gap / BigInt::from(2)));
    let mut ends: Vec<_> = cuts.map(|gap| BigRational::one() - gap).take_while(|cut| cut < r_max).collect();
    ends.push(r_max.clone());
    ends
}

/// A box of a strip: a row, and in it and in the strip the interval [i, i + 1]/2^level of each axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cell {
    /// The row, from r = 0 up.
    pub(crate) row: u32,
    /// i and the level, along r.
    pub(crate) r: (u64, u32),
    /// The same along s.
    pub(crate) s: (u64, u32),
}

/// An axis to split along.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Axis {
    R,
    S,
}

impl Cell {
    pub(super) fn root(row: usize) -> Self {
        Cell { row: row as u32, r: (0, 0), s: (0, 0) }
    }

    /// The number of splits that made it.
    pub(crate) fn depth(&self) -> u32 {
        self.r.1 + self.s.1
    }

    /// The two halves, the one with smaller r or s first.
    pub(super) fn halves(self, axis: Axis) -> [Cell; 2] {
        [0, 1].map(|half| {
            let mut cell = self;
            let (i, level) = if axis == Axis::R { &mut cell.r } else { &mut cell.s };
            (*i, *level) = (2 * *i + half, *level + 1);
            cell
        })
    }
}

/// The rows and one strip of a period: what gives cells their place.
#[derive(Debug, Clone)]
pub struct Chart {
    /// The strip.
    pub strip: Strip,
    rows: Vec<BigRational>,
    /// 1 − r at the rows' ends, rounded.
    gaps: Vec<f64>,
    /// The strip's ends in units of 2⁻⁶⁴ turns, rounded down.
    turns: [u64; 2],
}

/// A cell in floats: its centre to nearly twice their precision, since a claim is sensitive to n times the
/// centre's error.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    /// 1 − r at the centre.
    pub(crate) gap: f64,
    /// Half the width in r.
    pub(crate) h: f64,
    /// s at the centre, in units of 2⁻⁶⁴ turns.
    pub(crate) turns: u64,
    /// Half the width in s, in turns.
    pub(crate) half_turns: f64,
}

impl Chart {
    /// The chart of a strip up to `r_max`.
    pub(crate) fn new(strip: Strip, r_max: &BigRational) -> Self {
        let rows = row_ends(r_max);
        let gaps = rows.iter().map(|r| (BigRational::one() - r).to_f64().unwrap_or(f64::NAN)).collect();
        let turns = [strip.left, strip.right]
            .map(|s| ((u128::from(*s.numer()) << 64) / u128::from(*s.denom())) as u64);
        Chart { strip, rows, gaps, turns }
    }

    pub(super) fn rows(&self) -> usize {
        self.rows.len() - 1
    }

    /// The bounds of r and of s in a cell, exact.
    pub fn bounds(&self, cell: &Cell) -> [[BigRational; 2]; 2] {
        let row = cell.row as usize;
        let end = |x: &Ratio<u64>| BigRational::new_raw((*x.numer()).into(), (*x.denom()).into());
        let part = |from: &BigRational, to: &BigRational, (i, level): (u64, u32)| {
            [i, i + 1].map(|i| from + (to - from) * BigRational::new(i.into(), BigInt::one() << level))
        };
        [
            part(&self.rows[row], &self.rows[row + 1], cell.r),
            part(&end(&self.strip.left), &end(&self.strip.right), cell.s),
        ]
    }

    /// Where a cell is, in floats.
    pub(super) fn frame(&self, cell: &Cell) -> Frame {
        let (row, half) = (cell.row as usize, |level: u32| 0.5f64.powi(level as i32 + 1));
        let (gap, height) = (self.gaps[row], self.gaps[row] - self.gaps[row + 1]);
        let [left, right] = self.turns;
        let (i, level) = cell.s;
        Frame {
            gap: gap - height * ((2 * cell.r.0 + 1) as f64 * half(cell.r.1)),
            h: height * half(cell.r.1),
            turns: left + ((u128::from(right - left) * u128::from(2 * i + 1)) >> (level + 1)) as u64,
            half_turns: (right - left) as f64 * half(level) * 0.5f64.powi(64),
        }
    }

    /// Whether the cell's upper side lies on r = r_max.
    pub(super) fn touches_top(&self, cell: &Cell) -> bool {
        cell.row as usize + 2 == self.rows.len() && cell.r.0 + 1 == 1 << cell.r.1
    }
}
