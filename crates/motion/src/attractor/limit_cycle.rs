//! Limit cycles of what nothing drives: periodic motions whose period is a number of the answer.
//!
//! A motion has settled on one where it comes back to a state x₀ that it was in: where it passes the plane
//! f₀·(x − x₀) = 0 in the same sense and near x₀, f being how fast the state changes. From there Newton's
//! method goes in the state x and the period T, with P_T(x) = x and f₀·(x − x₀) = 0; the derivative by T is f
//! at the end. Where the motion is moved along its own cycle nothing happens: that multiplier 1 is taken out
//! by the reflection that turns f into the first axis. Rests, friction and impacts at one instant are as the
//! engine's motions have them. Not here: cycles that repel, and how they go on in a parameter.

use super::dynamics::{Dynamics, Motion, SectionState, Tangents};
use crate::{
    error::{Error, Result},
    monitor::Monitor,
    motion::{RunEnd, Time, algebra::solve},
    rounding::{PLACE, SUM},
};

/// A limit cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct LimitCycle<S> {
    /// A state on it.
    pub start: S,
    /// T, in radians: 2π is the system's unit of time, which it calls its period.
    pub period: f64,
    /// Impacts in one time round.
    pub impacts: u64,
    /// The multipliers but the 1 along the cycle, the largest modulus first.
    pub multipliers: Vec<(f64, f64)>,
    /// By how much it misses its beginning, relative to its extent.
    pub residual: f64,
    /// Newton steps taken.
    pub steps: usize,
}

/// Looks per unit of time for a return, and units of time in which one is looked for.
const LOOKS: u32 = 256;
const UNITS: u32 = 64;
/// A return is one that is so near, relative to the extent of the motion.
const BACK: f64 = 0.02;
/// Most steps of Newton's method.
const STEPS: usize = 30;
/// Whole parts of a period that are tried.
const PARTS: u32 = 8;

/// The limit cycle on which the motion from a start has settled after so many units of time. Cost: the
/// motion's, and a round with a vector for each coordinate for each Newton step.
///
/// # Errors
/// An input error where a drive moves the system, where the motion is at rest, ends, or comes not back, and
/// where Newton's method does not end; those of [`Motion::pass`]; the monitor's.
pub fn limit_cycle<D: Dynamics>(
    dynamics: &D,
    start: &D::Start,
    transient: u64,
    monitor: &dyn Monitor,
) -> Result<LimitCycle<D::Start>> {
    let mut run = dynamics.begin(start)?;
    let begun = length(run.point().coordinates());
    for unit in 1..=transient {
        monitor.advance(0)?;
        reached(run.pass(Time { period: unit as i64, ..run.time() })?)?;
    }
    let x = run.point().coordinates().to_vec();
    let driven =
        || Error::input("a drive moves the system: its motions have a multiple of the drive's period");
    let field = dynamics.field(&run).ok_or_else(driven)?;
    let (extent, returns) = returns(&mut run, &x, &field, monitor)?;
    // What has died out is at rest beside what it was.
    let rests = extent <= SUM * length(&x).max(begun);
    if rests || returns.is_empty() {
        let why = if rests { "is at rest" } else { "comes not back near a state that it was in" };
        return Err(Error::input(format!("after {transient} units of time the motion {why}")));
    }
    let mut found = Err(Error::input("no return"));
    for time in returns {
        found = newton(dynamics, (&x, &field), time, extent);
        if found.is_ok() {
            break;
        }
    }
    found
}

/// How far a motion goes, and after which times it comes back to a state, in order.
fn returns<M: Motion>(
    run: &mut M,
    x: &[f64],
    field: &[f64],
    monitor: &dyn Monitor,
) -> Result<(f64, Vec<f64>)> {
    let (begin, mut seen) = (run.time(), Vec::<[f64; 3]>::new());
    let (mut low, mut high) = (x.to_vec(), x.to_vec());
    for look in 1..=LOOKS * UNITS {
        if look % LOOKS == 0 {
            monitor.advance(0)?;
        }
        let gone = f64::from(look) * std::f64::consts::TAU / f64::from(LOOKS);
        reached(run.pass(begin.after(gone))?)?;
        let here = run.point().coordinates().to_vec();
        for (i, x) in here.iter().enumerate() {
            (low[i], high[i]) = (low[i].min(*x), high[i].max(*x));
        }
        let off: Vec<f64> = here.iter().zip(x).map(|(a, b)| a - b).collect();
        seen.push([gone, dot(field, &off), length(&off)]);
    }
    let extent = low.iter().zip(&high).map(|(low, high)| high - low).fold(0.0, f64::max);
    let crosses = seen.windows(2).filter_map(|pair| {
        let [[t, before, far], [next, after, farther]] = [pair[0], pair[1]];
        let at = before / (before - after);
        // Between two looks it may be nearer by all that it goes there.
        let near = far.min(farther) <= BACK * extent + dot(field, field).sqrt() * (next - t);
        (before < 0.0 && after >= 0.0 && near).then_some(t + at * (next - t))
    });
    Ok((extent, crosses.collect()))
}

/// The cycle near a state that comes back after about a time.
fn newton<D: Dynamics>(
    dynamics: &D,
    (from, field): (&[f64], &[f64]),
    time: f64,
    extent: f64,
) -> Result<LimitCycle<D::Start>> {
    let (mut x, mut period, mut last, n) = (from.to_vec(), time, f64::INFINITY, from.len());
    let size = extent + length(from);
    for steps in 1..=STEPS {
        let Round { end, slope, arrival, impacts } = round(dynamics, &x, period)?;
        let off: Vec<f64> = (0..n).map(|i| x[i] - end[i]).collect();
        let mut matrix: Vec<Vec<f64>> = (0..n)
            .map(|i| {
                let own = |j: usize| slope[i][j] - f64::from(u8::from(i == j));
                (0..n).map(own).chain([arrival[i]]).collect()
            })
            .collect();
        matrix.push(field.iter().copied().chain([0.0]).collect());
        let along: f64 = (0..n).map(|i| field[i] * (from[i] - x[i])).sum();
        let right = off.iter().copied().chain([along]).collect();
        let step = solve(matrix, right).ok_or_else(|| Error::input("the return map is singular"))?;
        let long = length(&step[..n]).max(step[n].abs() * length(field));
        // Where steps no longer fall they are rounding, or lead nowhere.
        if long <= f64::EPSILON * size || long > last / 2.0 {
            if long > PLACE * size {
                break;
            }
            if let Some(part) = shorter(dynamics, &x, period, extent)? {
                return newton(dynamics, (&x, field), part, extent);
            }
            let others = beside(&slope, &arrival);
            let multipliers = match &others[..] {
                [row] => vec![(row[0], 0.0)],
                _ => D::multipliers(&others, None).ok_or_else(|| Error::input("no multipliers"))?,
            };
            let (start, residual) = (dynamics.at(&x, 0.0), length(&off) / extent);
            return Ok(LimitCycle { start, period, impacts, multipliers, residual, steps });
        }
        x.iter_mut().zip(&step).for_each(|(x, step)| *x += step);
        (period, last) = (period + step[n], long);
        if period.is_nan() || period <= 0.0 || long > 10.0 * size {
            break;
        }
    }
    Err(Error::input("Newton's method found no limit cycle from where the motion comes back"))
}

/// The whole part of a period after which the motion is back already.
fn shorter<D: Dynamics>(dynamics: &D, x: &[f64], period: f64, extent: f64) -> Result<Option<f64>> {
    for parts in (2..=PARTS).rev() {
        let (mut run, part) = (dynamics.begin(&dynamics.at(x, 0.0))?, period / f64::from(parts));
        reached(run.pass(Time::new(0, 0.0).after(part))?)?;
        let off: Vec<f64> = run.point().coordinates().iter().zip(x).map(|(a, b)| a - b).collect();
        if length(&off) <= PLACE * (extent + length(x)) {
            return Ok(Some(part));
        }
    }
    Ok(None)
}

/// A motion for a time, with the derivative by its beginning, by rows, and how fast it changes at the end.
pub(crate) struct Round {
    pub end: Vec<f64>,
    pub slope: Vec<Vec<f64>>,
    pub arrival: Vec<f64>,
    pub impacts: u64,
}

/// The motion from a state at phase 0 of what nothing drives.
///
/// # Errors
/// An input error where it ends; those of [`Motion::pass`].
pub(crate) fn round<D: Dynamics>(dynamics: &D, x: &[f64], time: f64) -> Result<Round> {
    let (start, until) = (dynamics.at(x, 0.0), Time::new(0, 0.0).after(time));
    let mut run = dynamics.begin(&start)?;
    reached(run.pass(until)?)?;
    let arrival = dynamics.field(&run).unwrap_or_default();
    let mut carried = dynamics.along(dynamics.begin(&start)?);
    reached(carried.grow(until, &mut [])?)?;
    let columns = carried.vectors();
    let slope = (0..x.len()).map(|i| columns.iter().map(|column| column[i]).collect()).collect();
    Ok(Round { end: carried.coordinates(), slope, arrival, impacts: carried.impacts() })
}

/// What a matrix that leaves a vector as it is does to all beside it: by the reflection of the vector to the
/// first axis.
fn beside(slope: &[Vec<f64>], fixed: &[f64]) -> Vec<Vec<f64>> {
    let size = dot(fixed, fixed).sqrt();
    let mut normal = fixed.to_vec();
    normal[0] += size.copysign(fixed[0]);
    let weight = 2.0 / dot(&normal, &normal);
    let turned = |v: &[f64]| -> Vec<f64> {
        let part = weight * dot(&normal, v);
        v.iter().zip(&normal).map(|(v, n)| v - part * n).collect()
    };
    // Rows, then columns.
    let rows: Vec<Vec<f64>> = slope.iter().map(|row| turned(row)).collect();
    let columns: Vec<Vec<f64>> =
        (1..fixed.len()).map(|j| turned(&rows.iter().map(|row| row[j]).collect::<Vec<_>>())).collect();
    (1..fixed.len()).map(|i| columns.iter().map(|column| column[i]).collect()).collect()
}

fn reached(end: RunEnd) -> Result<()> {
    if end == RunEnd::Reached {
        Ok(())
    } else {
        Err(Error::input(format!("the motion ended, {}", end.why())))
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn length(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |most: f64, x| if x.is_nan() { f64::NAN } else { most.max(x.abs()) })
}
