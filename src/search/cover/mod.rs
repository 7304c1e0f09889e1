//! Covers: what happens at every point of region 3 with r ≤ r_max, for one period after the other.
//!
//! Region 3 is cut into strips of s and rows of r (`chart`); a strip's part of a row is halved, along r or
//! along s, until every box can be claimed something of (`claim`): no orbit, an orbit, or the edge of an
//! area. The search knows Conjecture 1 and uses it as a guess. It computes in plain floats with margins
//! (`expansion`), so it proves nothing; the trees it writes down (`tree`) do, once
//! [`certificate`](crate::certificate) has checked them. A box it cannot claim anything of stays in the tree,
//! as Open. Regions 2 and 4 need no search.
//!
//! A unit of work is one strip of one period, and its trees depend on nothing else: units run in any order
//! and number at a time, and a run that was ended goes on from those it had finished.
//!
//! ```
//! use std::collections::HashMap;
//! use grazing::certificate;
//! use grazing::search::cover::{Cover, CoverOptions, certificate as text, cover};
//! let options = CoverOptions::new(3..=4);
//! let covers = cover(&options, HashMap::new(), &(), &|_, _| Ok(()))?;
//! assert!(covers.iter().all(Cover::is_complete));
//! let blocks: Vec<String> = covers.iter().filter_map(Cover::block).collect();
//! let checked = certificate::check(&mut text(&options.periods, &blocks).as_bytes())?;
//! assert_eq!((checked.kind, checked.range), ("cover", Some(3..=4)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod chart;
mod claim;
mod expansion;
mod tree;

use std::{collections::HashMap, ops::RangeInclusive};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};
use rayon::prelude::*;

pub use chart::{Cell, Chart, Strip, strips};
pub(crate) use tree::walk;

use super::{Instance, compare::differ};
use crate::{
    certificate::cover::{FINEST, Leaf, header},
    error::{Error, Result},
    existence::Variant,
    local::{Ladder, Point, Polar},
    monitor::{Monitor, timed},
    processor::thread_seconds,
};
use claim::Judge;

/// What to cover, and how finely.
#[derive(Debug, Clone, PartialEq)]
pub struct CoverOptions {
    /// The periods, from 3 up.
    pub periods: RangeInclusive<u64>,
    /// The largest r covered; by default 1 − 1/n³.
    pub r_max: Option<BigRational>,
    /// The largest number of splits above a leaf.
    pub max_depth: u32,
    /// The largest width of an Edge leaf in the (a₁, a₂) plane, for pictures; its height is at most this
    /// times max(1 − a₂, 1/10).
    pub finest: Option<f64>,
    /// The statement that guides the search.
    pub variant: Variant,
}

impl CoverOptions {
    /// The usual options for a range of periods.
    pub fn new(periods: RangeInclusive<u64>) -> Self {
        CoverOptions { periods, r_max: None, max_depth: 60, finest: None, variant: Variant::True }
    }

    /// r_max for period `n`: by default 1 − 1/n³, which lies above the lowest point of every area, since each
    /// reaches below 1 − 4/(πn³) (`proofs/coq/Depth.v`).
    ///
    /// # Errors
    /// An input error if it is not in (0, 1), has more digits than a certificate can hold, or lies below the
    /// lowest points of areas.
    pub(crate) fn r_max(&self, n: u64) -> Result<BigRational> {
        let cube = BigInt::from(n).pow(3);
        let Some(r_max) = &self.r_max else {
            return Ok(BigRational::one() - BigRational::new(BigInt::one(), cube));
        };
        let gap = BigRational::one() - r_max;
        if !gap.is_positive() || !r_max.is_positive() || r_max.denom() > &BigInt::from(FINEST) {
            return Err(Error::input(format!(
                "r_max = {r_max}: a fraction between 0 and 1 whose denominator is at most {FINEST}"
            )));
        }
        if gap * &cube * BigInt::from(10) > BigRational::from_integer(49.into()) {
            return Err(Error::input(format!(
                "r_max = {r_max} may lie below an area of period {n}: give at least 1 - 4.9/{n}^3"
            )));
        }
        Ok(r_max.clone())
    }
}

/// A unit of work: a period and the index of one of its strips.
pub type Unit = (u64, usize);

/// What the search came to for one period.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Cover {
    /// The period.
    pub n: u64,
    /// The largest r covered.
    pub r_max: BigRational,
    /// The strips with their trees as text; none where a strip was not reached, or refuted.
    pub strips: Vec<(Strip, Option<String>)>,
    /// A point at which the claim is false, confirmed by the definition.
    pub refuted: Option<Instance>,
    /// Processor seconds spent, but for strips whose trees were known before.
    pub seconds: f64,
}

/// The leaves of a cover, counted.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct CoverTally {
    /// Leaves without an orbit.
    pub none: u64,
    /// Leaves with one everywhere.
    pub orbit: u64,
    /// Leaves on the edge of an area.
    pub edge: u64,
    /// Leaves left open, their bounds of r and of s.
    pub open: Vec<[[BigRational; 2]; 2]>,
    /// Strips that hold an area.
    pub areas: u64,
    /// The largest number of splits above a leaf.
    pub depth: u32,
}

impl CoverTally {
    /// The number of leaves of all kinds.
    pub fn leaves(&self) -> u64 {
        self.none + self.orbit + self.edge + self.open.len() as u64
    }

    /// The area in the (r, s) plane left open, rounded.
    pub fn open_area(&self) -> f64 {
        let area =
            |[r, s]: &[[BigRational; 2]; 2]| ((&r[1] - &r[0]) * (&s[1] - &s[0])).to_f64().unwrap_or(f64::NAN);
        self.open.iter().map(area).fold(0.0, std::ops::Add::add)
    }
}

impl Cover {
    /// Whether every strip was covered, be it with Open leaves.
    pub fn is_complete(&self) -> bool {
        self.strips.iter().all(|(_, trees)| trees.is_some())
    }

    /// Calls `visit` with each leaf of the strips covered, its box, and the chart that gives the box its
    /// place. Cost: linear in the leaves and the splits above them.
    pub fn leaves(&self, mut visit: impl FnMut(&Chart, Leaf, Cell)) {
        for (strip, trees) in &self.strips {
            let chart = Chart::new(strip.clone(), &self.r_max);
            if let Some(trees) = trees {
                walk(trees, self.n, &chart, |leaf, cell| visit(&chart, leaf, cell))
                    .expect("checked when it was made");
            }
        }
    }

    /// The leaves counted. Cost: as [`leaves`](Cover::leaves); memory: the open ones.
    pub fn tally(&self) -> CoverTally {
        let mut tally = CoverTally::default();
        self.leaves(|chart, leaf, cell| {
            tally.depth = tally.depth.max(cell.depth());
            match leaf {
                Leaf::None { .. } => tally.none += 1,
                Leaf::Orbit { .. } => tally.orbit += 1,
                Leaf::Edge { .. } => tally.edge += 1,
                Leaf::Open => tally.open.push(chart.bounds(&cell)),
            }
        });
        tally.areas =
            self.strips.iter().filter(|(strip, trees)| strip.interval.is_some() && trees.is_some()).count()
                as u64;
        tally
    }

    /// The block of this period in a certificate; none unless it is complete. Cost: as
    /// [`leaves`](Cover::leaves); memory: the text, about two bytes per leaf.
    pub fn block(&self) -> Option<String> {
        let leaves = self.tally().leaves();
        let (p, q) = (self.r_max.numer(), self.r_max.denom());
        let mut text = format!("n {} {p}/{q} {leaves}\nidentity region2\nidentity region4\n", self.n);
        for (Strip { left, right, .. }, trees) in &self.strips {
            let [left, right] = [left, right].map(|end| format!("{}/{}", end.numer(), end.denom()));
            text += &format!("strip {left} {right}\n{}\n", trees.as_ref()?);
        }
        Some(text)
    }
}

/// The certificate of covers, given their blocks in order. Cost: linear in the text, which is in memory
/// twice.
pub fn certificate(periods: &RangeInclusive<u64>, blocks: &[String]) -> String {
    let lines = blocks.iter().map(|block| block.lines().count() as u64).sum();
    header(periods, lines) + &blocks.concat()
}

/// The number of units of a run. Cost: O(n) strips for each period n, as is the memory.
///
/// # Errors
/// As [`cover`].
pub fn units(options: &CoverOptions) -> Result<Vec<Unit>> {
    let of = |n| Ok((0..strips(n, options.variant)?.len()).map(move |index| (n, index)));
    Ok(options.periods.clone().map(of).collect::<Result<Vec<_>>>()?.into_iter().flatten().collect())
}

/// Covers every period in the range, on all threads of the current pool. `known` holds the trees of units
/// done before; `record` is told of every further one as it is done, from any thread. One unit of progress
/// each. On an interruption, what is not reached is missing.
///
/// Cost: for each n about n^1.3 leaves (docs/conjecture1.md), O(n) for each box met.
///
/// # Errors
/// An input error if a period or r_max is out of bounds, or trees are known that are none; whatever `record`
/// returns.
pub fn cover(
    options: &CoverOptions,
    mut known: HashMap<Unit, String>,
    monitor: &dyn Monitor,
    record: &(dyn Fn(Unit, &str) -> Result<()> + Sync),
) -> Result<Vec<Cover>> {
    let mut covers = Vec::new();
    for n in options.periods.clone() {
        if n < 3 {
            return Err(Error::input(format!("covers start at period 3, not at {n}")));
        }
        let r_max = options.r_max(n)?;
        let strip = |(index, strip): (usize, Strip)| {
            let trees = known.remove(&(n, index));
            if let Some(trees) = &trees {
                walk(trees, n, &Chart::new(strip.clone(), &r_max), |_, _| ())?;
            }
            Ok((strip, trees))
        };
        let strips = strips(n, options.variant)?.into_iter().enumerate().map(strip).collect::<Result<_>>()?;
        covers.push(Cover { n, r_max, strips, refuted: None, seconds: 0.0 });
    }
    let missing: Vec<(usize, usize)> = (0..covers.len())
        .rev()
        .flat_map(|at| (0..covers[at].strips.len()).map(move |index| (at, index)))
        .filter(|&(at, index)| covers[at].strips[index].1.is_none())
        .collect();
    // The long periods first, so that no thread is left alone with them at the end.
    let found: Vec<Option<(Found, f64)>> = missing
        .par_iter()
        .with_max_len(1)
        .map(|&(at, index)| {
            if monitor.advance(0).is_err() {
                return Ok(None);
            }
            let (cover, start) = (&covers[at], thread_seconds());
            let found = timed(monitor, "expansions in f64", || one_strip(options, cover, index));
            let seconds = thread_seconds() - start;
            if let Ok(trees) = &found {
                record((cover.n, index), trees)?;
            }
            // An interruption now is noticed before the next unit.
            let _ = monitor.advance(1);
            Ok(Some((found, seconds)))
        })
        .collect::<Result<_>>()?;
    for ((at, index), found) in missing.into_iter().zip(found) {
        let cover = &mut covers[at];
        match found {
            Some((Ok(trees), seconds)) => {
                cover.strips[index].1 = Some(trees);
                cover.seconds += seconds;
            }
            Some((Err(case), _)) => {
                cover.refuted.get_or_insert(*case);
            }
            None => {}
        }
    }
    Ok(covers)
}

/// What one unit came to: trees, or a point at which the claim is false.
type Found = std::result::Result<String, Box<Instance>>;

fn one_strip(options: &CoverOptions, cover: &Cover, index: usize) -> Found {
    let chart = Chart::new(cover.strips[index].0.clone(), &cover.r_max);
    let refutes = |cell: &Cell| {
        let [r, s] = chart.bounds(cell).map(|[low, high]| (low + high) / BigInt::from(2));
        let case = Instance { n: cover.n, point: Point::Polar(Polar::new(r, s).ok()?) };
        differ(&Ladder::default(), &case, options.variant).then_some(case)
    };
    tree::grow(Judge::new(&chart, cover.n, options.finest), options.max_depth, refutes)
}
