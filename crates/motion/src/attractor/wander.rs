//! Whether a motion that is on no orbit that is found wanders for ever, or is on its way.
//!
//! Evidence for the first is that neighbours part, by more than the error of the mean, or that the motion
//! goes equally far in blocks of time without a trend. What grows, or still comes nearer to something, does
//! not wander. Nor is that said of a motion that is young beside what its machine loses: where damping and
//! impacts take little, irregular motion lasts for many times as long, and is a transient all the same.

use std::f64::consts::TAU;

use super::{
    dynamics::{Dynamics, Motion, SectionState},
    lyapunov::{Exponent, exponents},
};
use crate::{
    error::Result,
    monitor::Monitor,
    motion::{RunEnd, Time},
};

/// Forcing periods in which it is measured how areas of states shrink, and how a vector grows.
const MEASURED: u64 = 128;
/// Those in which the growth of a vector is looked at where that leaves it open.
const LONGER: [u64; 3] = [512, 2048, 8192];
/// The monitor is asked after so many forcing periods.
const PAUSE: i64 = 64;
/// A mean this many times its standard error is not 0.
const SURE: f64 = 3.0;
/// Blocks of time, and the forcing periods of each: longer ones where the shorter are not equal, as of what
/// turns slowly.
const BLOCKS: usize = 4;
const LENGTHS: [i64; 2] = [256, 1024];
/// A motion that goes so many times as far in all blocks as in any of them is on its way.
const GROWS: f64 = 2.0;
/// Blocks in which a motion goes as far are equal up to this part.
const EQUAL: f64 = 0.1;
/// A change between the first block and the last, in one sense throughout, by more than this part is a trend.
const TREND: f64 = 1e-3;

/// Areas of states have shrunk by e to this before an irregular motion counts as what it tends to: of a
/// lightly damped machine four of nine starts were on transients at e to the 12, none at e to the 34.
const SHRUNK: f64 = 30.0;
/// Where they shrink by less per forcing period nothing is lost, and what a motion does it goes on to do.
const CONSERVED: f64 = 1e-9;

/// Whether the motion from these coordinates of the section at `phase`, which has lasted for so many forcing
/// periods, wanders; where an orbit is `found` that attracts and there are no impacts, only as neighbours
/// part. Cost: 1,024 forcing periods, and 128 with two vectors, then with six where these do not
/// tell, then with one for each coordinate of a state; where that leaves it open 4,096 more and 10,752 with a
/// vector.
///
/// # Errors
/// Those of [`Motion::pass`]; the monitor's.
pub(super) fn wanders<D: Dynamics>(
    dynamics: &D,
    x: &[f64],
    phase: f64,
    (lasted, found): (u64, bool),
    monitor: &dyn Monitor,
) -> Result<bool> {
    let start = dynamics.at(x, phase);
    let Some(Blocks { sizes: all, impacts, end: start }) = blocks(dynamics, &start, LENGTHS[0], monitor)?
    else {
        return Ok(false);
    };
    // The last is of all blocks together.
    if all[BLOCKS] > GROWS * all[..BLOCKS].iter().copied().fold(0.0, f64::max) {
        return Ok(false);
    }
    let lasted = lasted.saturating_add(BLOCKS as u64 * LENGTHS[0].unsigned_abs());
    let is_old = |rate: f64| rate.abs() < CONSERVED || rate * lasted as f64 >= SHRUNK;
    let Some((mut one, _)) = shrinks(dynamics, &start, monitor)?.filter(|(_, rate)| is_old(*rate)) else {
        return Ok(false);
    };
    let mut longer = LONGER.iter();
    loop {
        let error = SURE * one.standard_error;
        if one.rate > error {
            return Ok(true);
        }
        // Where impacts are rare, and stretch much, most means of short times are negative. Of a vector that
        // vanishes there is no error.
        let next = longer.next();
        if next.is_none() && one.rate < -error || one.rate == f64::NEG_INFINITY {
            return Ok(false);
        }
        let Some(periods) = next else { break };
        match growth(dynamics, &start, 1, *periods, monitor)? {
            Some(all) => one = all[0],
            None => return Ok(false),
        }
    }
    // Light damping is not seen in this time; what impacts take is.
    if found && impacts == 0 {
        return Ok(false);
    }
    let longer = |length| blocks(dynamics, &start, length, monitor);
    Ok(are_equal(&all) || longer(LENGTHS[1])?.is_some_and(|longer| are_equal(&longer.sizes)))
}

/// The exponents of so many vectors over so many periods; none where the motion ends.
fn growth<D: Dynamics>(
    dynamics: &D,
    start: &D::Start,
    count: usize,
    periods: u64,
    monitor: &dyn Monitor,
) -> Result<Option<Vec<Exponent>>> {
    match exponents(dynamics, start, count, 0, periods, monitor) {
        Err(error) if error.is_interrupted() => Err(error),
        found => Ok(found.ok().filter(|all| all.iter().all(|one| one.end == RunEnd::Reached))),
    }
}

/// The largest exponent, and the rate per forcing period at which areas of states shrink, the slowest of
/// those that grow one way as neighbours part and shrink the other: coordinates that have nothing to do with
/// that change nothing. None where the motion ends.
fn shrinks<D: Dynamics>(
    dynamics: &D,
    start: &D::Start,
    monitor: &dyn Monitor,
) -> Result<Option<(Exponent, f64)>> {
    let size = dynamics.dimension();
    let mut count = size.min(2);
    loop {
        let Some(all) = growth(dynamics, start, count, MEASURED, monitor)? else { return Ok(None) };
        let sums: Vec<f64> = all.iter().skip(1).map(|one| all[0].rate + one.rate).collect();
        match sums.iter().copied().find(|sum| *sum < 0.0) {
            // As a rule some few vectors tell.
            None if count < size => count = if count == 2 { size.min(6) } else { size },
            falls => return Ok(falls.or(sums.last().copied()).map(|sum| (all[0], -TAU * sum))),
        }
    }
}

/// Whether blocks extend equally far, without a trend, and all of them together no farther: the last is that.
fn are_equal(all: &[f64]) -> bool {
    let (whole, sizes) = (all[BLOCKS], &all[..BLOCKS]);
    let (first, last) = (sizes[0], sizes[BLOCKS - 1]);
    let rises = sizes.windows(2).all(|pair| pair[1] > pair[0]);
    let falls = sizes.windows(2).all(|pair| pair[1] < pair[0]);
    let trend = (rises || falls) && (last - first).abs() > TREND * first;
    let least = sizes.iter().copied().fold(f64::INFINITY, f64::min);
    !trend && whole - least <= EQUAL * whole
}

/// What is seen of a motion in blocks of time.
struct Blocks<S> {
    /// How far the points of the section extend in each, and then in all together, in the coordinate in which
    /// they extend most.
    sizes: Vec<f64>,
    impacts: u64,
    /// Where it is after them.
    end: S,
}

/// Blocks of so many periods; none where the motion ends.
fn blocks<D: Dynamics>(
    dynamics: &D,
    start: &D::Start,
    length: i64,
    monitor: &dyn Monitor,
) -> Result<Option<Blocks<D::Start>>> {
    let Ok(mut run) = dynamics.begin(start) else { return Ok(None) };
    let begun = run.time();
    let mut ends: Vec<[Vec<f64>; 2]> = Vec::new();
    for block in 0..BLOCKS as i64 {
        let first = run.point().coordinates().to_vec();
        let (mut low, mut high) = (first.clone(), first);
        for i in 1..=length {
            if i % PAUSE == 0 {
                monitor.advance(0)?;
            }
            let until = Time { period: begun.period + block * length + i, ..begun };
            if run.pass(until)? != RunEnd::Reached {
                return Ok(None);
            }
            for (j, x) in run.point().coordinates().iter().enumerate() {
                (low[j], high[j]) = (low[j].min(*x), high[j].max(*x));
            }
        }
        ends.push([low, high]);
    }
    let size = |j: usize, blocks: &[[Vec<f64>; 2]]| {
        let low = blocks.iter().map(|[low, _]| low[j]).fold(f64::INFINITY, f64::min);
        blocks.iter().map(|[_, high]| high[j]).fold(f64::NEG_INFINITY, f64::max) - low
    };
    let widest =
        (0..ends[0][0].len()).max_by(|&a, &b| size(a, &ends).total_cmp(&size(b, &ends))).unwrap_or(0);
    let each = ends.chunks(1).map(|block| size(widest, block));
    let sizes = each.chain([size(widest, &ends)]).collect();
    Ok(Some(Blocks { sizes, impacts: run.impacts(), end: dynamics.here(&run) }))
}
