//! Whether a motion tends to a periodic orbit, and to which: Newton's method on the map from section to
//! section.
//!
//! Points that recur are no orbit yet: those of a slow transient do, too. From a point x of a motion, and for
//! each divisor d of the period at which it recurs, the least first, Newton's method looks for x* = P^d(x*).
//! With A the derivative there, ρ its spectral radius and e = x − x*, the motion tends to x* if
//!
//! - ρ < 1;
//! - the map is linear on the way: |P^d(x) − x* − A e| ≤ (1 − ρ)|e|/4, so that near x* no round adds as much
//!   as it takes away;
//! - and x is near x*, or follows A^k e to within ‖A^k‖|e|/2 for the rounds in which ‖A^k‖ falls to 10⁻⁵:
//!   what is farther away may meet a stop that x* and the first round do not;
//!
//! or, however far it is, if the motions from x* + e, x* + e/2, … down to where x is near all come nearer
//! ([`shrinks`]): friction alone damps so slowly, and light damping, that no motion would be seen to the end.
//! Where Newton's method finds no orbit that attracts from x, it is asked once more from the mean of the
//! points.
//!
//! Period, impacts, points and multipliers are then those of the orbit: no number depends on where the motion
//! was. Numerical evidence, not proof: that is `validate`. What the tolerances are relative to: the extent of
//! the orbit, the largest difference of a coordinate on it; rounding is relative to the largest coordinate.

use super::{
    cycle::{Cycle, ordered},
    dynamics::{Dynamics, Motion, SectionState, Tangents},
};
use crate::{
    error::Result,
    motion::{RunEnd, Time, algebra::solve},
    rounding::{CIRCLE, SUM},
};

/// Closer than this to an orbit, relative to its extent, a motion need not be followed to be told to tend
/// there.
const NEAR: f64 = 1e-5;
/// Farther than this, relative to the extent, an orbit is another motion's unless the map is linear so far.
const FAR: f64 = 1e-2;
/// Orbits this close are the same: relative to the extent.
const SAME: f64 = 1e-7;
/// The same for rounding, relative to the largest coordinate.
const SAME_ROUNDING: f64 = 1e-11;
/// Smaller numbers are 0: the simulators end motions that small.
const NOTHING: f64 = 1e-140;
/// Rounds in which a motion is seen to come nearer to an orbit.
const LAP: u64 = 32;
/// In a lap the farthest comes nearer by this part at least: turning, points miss their farthest by less.
const NEARER: f64 = 1e-3;
/// 2 to this is how many points a form is the mean over.
const DOUBLINGS: u32 = 24;
/// Halvings of the distance from which motions are seen to come nearer.
const LEVELS: u32 = 24;
/// A spectral radius this near 1 is 1: what is on such an orbit stays, what is beside it is not attracted.
pub const NEUTRAL: f64 = 1e-7;
/// Steps of Newton's method: to an orbit at rest in 0, which has no size, each takes 16 digits off, until
/// nothing is left.
const STEPS: usize = 40;
/// A step that is not shorter than this share of the one before is the last: rounding, or no convergence.
const SHORTER: f64 = 0.5;
/// Looks in a period for how far a motion extends.
const LOOKS: u32 = 16;
/// The longest that a motion is followed on its way to an orbit, in forcing periods.
pub(super) const PATIENCE: u64 = 2_000;

/// How large a motion is, in the unit of its coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Size {
    /// The largest difference of one coordinate.
    pub extent: f64,
    /// The largest coordinate.
    pub magnitude: f64,
}

impl Size {
    /// That of the motion from these coordinates over a period. A motion that ends is as large as it was.
    ///
    /// # Errors
    /// Those of [`Motion::pass`].
    pub fn of<D: Dynamics>(dynamics: &D, x: &[f64], phase: f64) -> Result<Size> {
        let (mut low, mut high) = (x.to_vec(), x.to_vec());
        if let Ok(mut run) = dynamics.begin(&dynamics.at(x, phase)) {
            for look in 1..=LOOKS {
                let part = std::f64::consts::TAU * f64::from(look) / f64::from(LOOKS);
                if run.pass(Time::new(0, phase + part))? != RunEnd::Reached {
                    break;
                }
                for (i, x) in run.point().coordinates().iter().enumerate() {
                    (low[i], high[i]) = (low[i].min(*x), high[i].max(*x));
                }
            }
        }
        let extent = low.iter().zip(&high).map(|(low, high)| high - low).fold(0.0, f64::max);
        let magnitude = low.iter().chain(&high).fold(0.0, |most: f64, x| most.max(x.abs()));
        Ok(Size { extent, magnitude })
    }

    /// This part of the extent, with room for rounding.
    pub fn part(&self, of_extent: f64) -> f64 {
        of_extent * self.extent + SUM * self.magnitude
    }

    /// Orbits this close are the same.
    pub fn same(&self) -> f64 {
        (SAME * self.extent + SAME_ROUNDING * self.magnitude).max(NOTHING)
    }
}

/// What there is about a period at a point of a motion.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Tendency<P> {
    /// The motion tends to this orbit.
    Settled(Cycle<P>),
    /// There is an orbit that attracts, and the motion is not yet where it could be told to tend there.
    NotYet,
    /// There is an orbit that attracts, and nothing tells that the motion goes there.
    Elsewhere,
    /// There is none.
    Other,
}

/// The map round d periods at a point.
struct Round {
    end: Vec<f64>,
    /// ∂end/∂x, by rows.
    slope: Vec<Vec<f64>>,
    impacts: u64,
}

/// A fixed point of the map round some periods.
struct Fixed {
    period: usize,
    x: Vec<f64>,
    slope: Vec<Vec<f64>>,
}

/// What a motion at these coordinates of the section at `phase` tends to, if it recurs after `period`: the
/// orbit of the least period that divides it. The mean is of its points one period apart, if it is known.
/// Cost: some four rounds with vectors for each divisor, and that of [`shrinks`].
///
/// # Errors
/// Those of [`Motion::pass`].
pub(super) fn tendency<D: Dynamics>(
    dynamics: &D,
    x: &[f64],
    phase: f64,
    period: usize,
    mean: Option<&[f64]>,
    size: &Size,
) -> Result<Tendency<D::Point>> {
    let (mut found, mut shorter) = (Tendency::Other, Vec::<Fixed>::new());
    for divisor in (1..=period).filter(|divisor| period.is_multiple_of(*divisor)) {
        let (tends, fixed) = of_period(dynamics, x, phase, divisor, mean, size)?;
        let Some(fixed) = fixed else { continue };
        match tends {
            Tends::Settled => {
                // Beside a flip the map of twice the period may tell what that of the period does not yet: it
                // is the same orbit.
                let same = |old: &&Fixed| {
                    divisor.is_multiple_of(old.period) && length(&minus(&old.x, &fixed.x)) <= size.same()
                };
                let least = shorter.iter().find(same).unwrap_or(&fixed);
                return Ok(cycle(dynamics, least, phase)?.map_or(Tendency::Other, Tendency::Settled));
            }
            Tends::NotYet => found = Tendency::NotYet,
            Tends::Elsewhere if found == Tendency::Other => found = Tendency::Elsewhere,
            Tends::Elsewhere | Tends::Not => {}
        }
        shorter.push(fixed);
    }
    Ok(found)
}

/// Whether a motion tends to a fixed point.
#[derive(PartialEq)]
enum Tends {
    Settled,
    NotYet,
    Elsewhere,
    /// It does not attract, or there is none.
    Not,
}

/// The fixed point of the map round a period that Newton's method finds from these coordinates, with the
/// map's derivative there; none where it finds none. Cost: a round with vectors for each of some five steps.
///
/// # Errors
/// Those of [`Motion::pass`].
pub fn fixed_point<D: Dynamics>(
    dynamics: &D,
    from: &[f64],
    phase: f64,
    period: u64,
) -> Result<Option<FixedPoint>> {
    let Some(first) = round(dynamics, from, phase, period)? else { return Ok(None) };
    let size = Size::of(dynamics, from, phase)?;
    let found = newton(dynamics, from, first, phase, period, &size)?;
    let Some((x, Round { slope, .. })) = found else { return Ok(None) };
    let same = Size::of(dynamics, &x, phase)?.same();
    Ok(Some(FixedPoint { x, slope, same }))
}

/// A fixed point of the map round a period.
pub struct FixedPoint {
    /// The point, as [`SectionState::coordinates`].
    pub x: Vec<f64>,
    /// The derivative there, by rows.
    pub slope: Vec<Vec<f64>>,
    /// States this close to its motion are on it.
    pub same: f64,
}

fn of_period<D: Dynamics>(
    dynamics: &D,
    from: &[f64],
    phase: f64,
    period: usize,
    mean: Option<&[f64]>,
    size: &Size,
) -> Result<(Tends, Option<Fixed>)> {
    let nothing = (Tends::Not, None);
    let rounds = period as u64;
    let Some(first) = round(dynamics, from, phase, rounds)? else { return Ok(nothing) };
    let after = first.end.clone();
    let radius = |at: &Round| {
        let all = D::multipliers(&at.slope, None)?;
        Some(all.iter().fold(0.0, |most: f64, (re, im)| most.max(re.hypot(*im))))
    };
    let mut found = newton(dynamics, from, first, phase, rounds, size)?;
    if let Some(mean) = mean
        && found.as_ref().and_then(|(_, at)| radius(at)).is_none_or(|radius| radius > 1.0)
        && let Some(first) = round(dynamics, mean, phase, rounds)?
    {
        found = newton(dynamics, mean, first, phase, rounds, size)?.or(found);
    }
    let Some((mut x, at)) = found else { return Ok(nothing) };
    if length(&x) <= NOTHING {
        x.fill(0.0);
    }
    let Some(radius) = radius(&at) else { return Ok(nothing) };
    let off: Vec<f64> = minus(from, &x);
    let distance = length(&off);
    let on_it = distance <= size.part(0.0);
    let neutral = if at.impacts == 0 { CIRCLE } else { NEUTRAL };
    let attracts = radius < if on_it { 1.0 + NEUTRAL } else { 1.0 - neutral };
    let bent = length(&minus(&minus(&after, &x), &times(&at.slope, &off)));
    let linear = bent <= (1.0 - radius) / 4.0 * distance;
    let near = distance <= size.part(NEAR);
    let tends = if !attracts {
        Tends::Not
    } else if on_it
        || linear && (near || follows(dynamics, from, phase, rounds, (&x, &at.slope, radius, &off))?)
        || shrinks(dynamics, (&x, &at, radius), phase, rounds, &off, size)?
    {
        Tends::Settled
    } else if linear || distance <= size.part(FAR) {
        Tends::NotYet
    } else {
        Tends::Elsewhere
    };
    Ok((tends, Some(Fixed { period, x, slope: at.slope })))
}

/// Whether motions from x* + e, x* + e/2, … come nearer to x*, and meet nothing that its orbit does not. They
/// come nearer if no round takes a quadratic form of e up ([`least_form`]), or if in a
/// second lap the farthest is nearer than in the first, by what the points of a lap can miss.
/// Cost: two laps of 32 rounds for each of up to 24 halvings.
///
/// # Errors
/// Those of [`Motion::pass`].
fn shrinks<D: Dynamics>(
    dynamics: &D,
    (x, at, radius): (&[f64], &Round, f64),
    phase: f64,
    period: u64,
    off: &[f64],
    size: &Size,
) -> Result<bool> {
    let form = least_form(&at.slope, radius);
    let mut scale = 1.0;
    for _ in 0..LEVELS {
        let start: Vec<f64> = x.iter().zip(off).map(|(x, e)| x + scale * e).collect();
        let Ok(mut run) = dynamics.begin(&dynamics.at(&start, phase)) else { return Ok(false) };
        let (mut farthest, mut last, mut always) = ([0.0f64; 2], f64::INFINITY, true);
        for i in 0..2 * LAP {
            let e = minus(run.point().coordinates(), x);
            let value = quadratic(&form, &e);
            always &= value < last;
            last = value;
            let lap = &mut farthest[(i / LAP) as usize];
            *lap = lap.max(length(&e));
            if run.pass(Time::new(((i + 1) * period) as i64, phase))? != RunEnd::Reached {
                return Ok(false);
            }
        }
        if run.impacts() != 2 * LAP * at.impacts {
            return Ok(false);
        }
        if !always && farthest[1] > (1.0 - NEARER) * farthest[0] {
            return Ok(false);
        }
        if scale * length(off) <= size.part(NEAR) {
            return Ok(true);
        }
        scale /= 2.0;
    }
    Ok(false)
}

/// eᵀSe.
fn quadratic(form: &[Vec<f64>], e: &[f64]) -> f64 {
    times(form, e).iter().zip(e).map(|(a, b)| a * b).sum()
}

/// A quadratic form that the map takes down in every round, if that is not by far less than 10⁻⁷: of two
/// multipliers that are a pair the one that it multiplies by their modulus squared, else the mean of those of
/// the points that follow.
fn least_form(slope: &[Vec<f64>], radius: f64) -> Vec<Vec<f64>> {
    if let [row, next] = slope
        && let ([a, b], [c, d]) = (&row[..], &next[..])
    {
        // A − tr A/2 is a turn, and leaves it as it is.
        let half = (a - d) / 2.0;
        if half * half + b * c < 0.0 {
            let sign = c.signum();
            return vec![vec![sign * c, -sign * half], vec![-sign * half, -sign * b]];
        }
    }
    let mut power: Vec<Vec<f64>> = slope.iter().map(|row| row.iter().map(|x| x / radius).collect()).collect();
    let size = slope.len();
    let mut form: Vec<Vec<f64>> =
        (0..size).map(|i| (0..size).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    for _ in 0..DOUBLINGS {
        let turned: Vec<Vec<f64>> = (0..size).map(|j| power.iter().map(|row| row[j]).collect()).collect();
        let more = product(&turned, &product(&form, &power));
        for (row, more) in form.iter_mut().zip(more) {
            row.iter_mut().zip(more).for_each(|(a, b)| *a = (*a + b) / 2.0);
        }
        power = product(&power, &power);
    }
    form
}

/// A point and the map there.
type Mapped = (Vec<f64>, Round);

/// A root of P^d(x) = x and the derivative there, from the map at the first point.
fn newton<D: Dynamics>(
    dynamics: &D,
    from: &[f64],
    first: Round,
    phase: f64,
    period: u64,
    size: &Size,
) -> Result<Option<Mapped>> {
    let (mut x, mut here, mut last) = (from.to_vec(), first, f64::INFINITY);
    for _ in 0..STEPS {
        let matrix = here.slope.iter().enumerate().map(|(i, row)| {
            row.iter().enumerate().map(|(j, a)| if i == j { 1.0 - a } else { -a }).collect::<Vec<f64>>()
        });
        let Some(step) = solve(matrix.collect(), minus(&here.end, &x)) else { return Ok(None) };
        let long = length(&step);
        let rounding = size.part(0.0);
        // Where steps no longer fall they are rounding, or lead nowhere.
        if long > SHORTER * last {
            return Ok((last <= rounding.max(size.part(SAME))).then_some((x, here)));
        }
        x.iter_mut().zip(&step).for_each(|(x, step)| *x += step);
        let Some(next) = round(dynamics, &x, phase, period)? else { return Ok(None) };
        (here, last) = (next, long);
        if long <= f64::EPSILON * length(&x) {
            return Ok(Some((x, here)));
        }
    }
    Ok((last <= size.part(0.0)).then_some((x, here)))
}

/// Whether the motion comes near as the derivative says: a stop may be met on the way, however far it is.
fn follows<D: Dynamics>(
    dynamics: &D,
    from: &[f64],
    phase: f64,
    period: u64,
    (x, slope, radius, off): (&[f64], &[Vec<f64>], f64, &[f64]),
) -> Result<bool> {
    // Never, in this time: no norm is below the spectral radius.
    if radius.powf(PATIENCE as f64 / period as f64) > NEAR {
        return Ok(false);
    }
    let Ok(mut run) = dynamics.begin(&dynamics.at(from, phase)) else { return Ok(false) };
    let (mut power, mut expected) = (slope.to_vec(), off.to_vec());
    let mut rounds = 0;
    loop {
        rounds += 1;
        if rounds * period > PATIENCE {
            return Ok(false);
        }
        expected = times(slope, &expected);
        if run.pass(Time::new((rounds * period) as i64, phase))? != RunEnd::Reached {
            return Ok(false);
        }
        let apart = minus(&minus(run.point().coordinates(), x), &expected);
        if length(&apart) > norm(&power) * length(off) / 2.0 + SUM * length(x) {
            return Ok(false);
        }
        if norm(&power) <= NEAR {
            return Ok(true);
        }
        power = product(slope, &power);
    }
}

/// The orbit of a fixed point, with its points and impacts; none where the motion ends.
fn cycle<D: Dynamics>(dynamics: &D, fixed: &Fixed, phase: f64) -> Result<Option<Cycle<D::Point>>> {
    let Fixed { period, x, slope } = fixed;
    let start = dynamics.at(x, phase);
    let Ok(mut run) = dynamics.begin(&start) else { return Ok(None) };
    let before = run.impacts();
    let mut points = vec![run.point()];
    for i in 1..=*period {
        if run.pass(Time::new(i as i64, phase))? != RunEnd::Reached {
            return Ok(None);
        }
        points.push(run.point());
    }
    points.pop();
    let (impacts, size) = (run.impacts() - before, Size::of(dynamics, x, phase)?);
    // Vectors kept orthonormal tell how volumes shrink without cancellation.
    let mut growth = vec![0.0; x.len()];
    let mut carried = dynamics.tangents(dynamics.begin(&start)?, x.len());
    carried.grow(Time::new(*period as i64, phase), &mut growth)?;
    let mut multipliers = D::multipliers(slope, Some(growth.iter().sum::<f64>().exp())).unwrap_or_default();
    // What vanishes is 0, whatever rounding leaves of it.
    let lost = growth.iter().filter(|growth| **growth == f64::NEG_INFINITY).count();
    let kept = multipliers.len().saturating_sub(lost);
    multipliers[kept..].fill((0.0, 0.0));
    Ok(Some(Cycle { points: ordered(points, SectionState::plane), impacts, same: size.same(), multipliers }))
}

/// The map round that many periods from x, with its derivative; none where the motion ends.
fn round<D: Dynamics>(dynamics: &D, x: &[f64], phase: f64, period: u64) -> Result<Option<Round>> {
    let Ok(run) = dynamics.begin(&dynamics.at(x, phase)) else { return Ok(None) };
    let mut carried = dynamics.along(run);
    // Vectors that are not asked how they grow stay as they are carried.
    if carried.grow(Time::new(period as i64, phase), &mut [])? != RunEnd::Reached {
        return Ok(None);
    }
    let (end, columns) = (carried.coordinates(), carried.vectors());
    let slope = (0..x.len()).map(|i| columns.iter().map(|column| column[i]).collect()).collect();
    Ok(Some(Round { end, slope, impacts: carried.impacts() }))
}

fn minus(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

fn times(matrix: &[Vec<f64>], x: &[f64]) -> Vec<f64> {
    matrix.iter().map(|row| row.iter().zip(x).map(|(a, x)| a * x).sum()).collect()
}

fn product(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let column = |j: usize| -> Vec<f64> { b.iter().map(|row| row[j]).collect() };
    let columns: Vec<Vec<f64>> = (0..b.len()).map(|j| times(a, &column(j))).collect();
    (0..a.len()).map(|i| columns.iter().map(|column| column[i]).collect()).collect()
}

/// In the largest coordinate.
fn length(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |most: f64, x| if x.is_nan() { f64::NAN } else { most.max(x.abs()) })
}

/// The norm that belongs to [`length`].
fn norm(matrix: &[Vec<f64>]) -> f64 {
    matrix.iter().map(|row| row.iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max)
}
