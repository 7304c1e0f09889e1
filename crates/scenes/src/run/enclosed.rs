//! The touch of the motion without impacts of a linear machine, between two values of the parameter.
//!
//! **Statement.** The motion without impacts is the response to the forcing. At one end, `clear`, all its
//! gaps are above 0 at every phase; at the other one is below 0 at some phase; and for every value from one
//! to the other there is one response. So the least gap is continuous between them, and is 0 somewhere.
//!
//! **Proof**, in intervals of floats, with coefficients from balls of 96 bits. The harmonic x cos kt + y sin
//! kt of the response solves
//!
//! ```text
//! (K − k²M) x + kC y = f,    (K − k²M) y − kC x = g.
//! ```
//!
//! Let R be about the inverse of this matrix A, and q < 1 at least the norm of 1 − RA, of the greatest sum of
//! a row: then A has an inverse, and the solution is within |R(b − Ax̃)|/(1 − q) of x̃. Over all values
//! between the ends A is one matrix of intervals. With B = Σ k²(|a_k| + |b_k|) ≥ |z″| a gap z is above 0
//! within h of a phase t where z(t) − |z′(t)| h − B h²/2 is; the period is halved until that is so of each
//! part.
//!
//! Not here: a certificate; the search for the touch (`many::grazing`).

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, pow};

use super::Job;
use crate::{
    error::{Error, Result},
    many::{Machine, RealMatrix, RealVector, grazing::LinearTouch},
    motion::{System, Wall},
    number::{Angle, Ball, Circular, Elementary, FloatInterval, Precision, Real, Sign},
    scene::{Body, Expression},
};

/// Of the balls by which coefficients are enclosed.
const BITS: u32 = 96;
/// The first distance of the ends from the touch, of its size, and how often it grows, by a factor of 16.
const FIRST: f64 = 1.0 / (1u64 << 46) as f64;
const GROWS: i32 = 6;
/// The most coordinates: their cube is the cost.
const COORDINATES: usize = 40;
/// Parts of a period at first, and how often each is halved at most.
const PARTS: u32 = 8;
const HALVED: u32 = 40;
/// The most parts of a period.
const LOOKS: u32 = 100_000;

/// Between which values the touch is, or why that is not known. `unit` moves the gap by the size of the
/// motion. Cost: for n coordinates O(n³) for each harmonic, and some hundred looks at each gap.
///
/// # Errors
/// An interruption; a name that the scene does not have.
pub(super) fn touch(
    job: &Job,
    name: &str,
    (touch, unit): (&LinearTouch, f64),
) -> Result<std::result::Result<[BigRational; 2], String>> {
    let Some(at) = BigRational::from_float(touch.parameter).filter(|_| touch.rate != 0.0) else {
        return Ok(Err("the least gap does not pass through 0 there".into()));
    };
    let mut last = "the least gap is too near to 0 for its signs beside the touch";
    for i in 0..GROWS {
        job.check()?;
        let ends = around(&at, touch.parameter.abs().max(unit.abs()) * FIRST * 16f64.powi(i));
        let [clear, through] = if touch.rate < 0.0 { [&ends[0], &ends[1]] } else { [&ends[1], &ends[0]] };
        let mut gaps = Vec::new();
        for [from, to] in [[clear; 2], [through; 2], [&ends[0], &ends[1]]] {
            let equations = match Equations::of(job, name, [from, to])? {
                Ok(equations) => equations,
                Err(why) => return Ok(Err(why.into())),
            };
            gaps.push(equations.gaps());
        }
        let [Some(clear), Some(through), Some(_)] = &gaps[..] else {
            last = "the motion without impacts is not certain to be the only one there";
            continue;
        };
        let phase = BigRational::from_float(touch.at.phase / std::f64::consts::PI).map(|x| Angle::new(&x));
        let is_through =
            |gap: &Gap| phase.as_ref().is_some_and(|phase| gap.at(phase)[0].sign() == Some(Sign::Negative));
        if through.iter().any(is_through) && clear.iter().all(Gap::is_clear) {
            return Ok(Ok(ends));
        }
    }
    Ok(Err(last.into()))
}

/// Decimals about as far below and above a number.
fn around(at: &BigRational, reach: f64) -> [BigRational; 2] {
    let places = (2.0 - reach.log10()).clamp(0.0, 400.0) as usize;
    let ten = BigRational::from_integer(pow(BigInt::from(10), places));
    let reach = BigRational::from_float(reach).unwrap_or_else(BigRational::one);
    [((at - &reach) * &ten).floor() / &ten, ((at + &reach) * &ten).ceil() / &ten]
}

/// The equations in radians of the forcing, for all values of the parameter between two.
struct Equations {
    size: usize,
    mass: Vec<(usize, usize, FloatInterval)>,
    damping: Vec<(usize, usize, FloatInterval)>,
    stiffness: Vec<(usize, usize, FloatInterval)>,
    /// The coefficients of the forces' cosines and sines by their orders; the constant ones are of order 0.
    loads: BTreeMap<u32, [Vec<FloatInterval>; 2]>,
    /// Of each stop its row and its place.
    stops: Vec<(Vec<FloatInterval>, Wall<FloatInterval>)>,
}

/// A gap as a sum of harmonics, the constant one of order 0.
struct Gap(BTreeMap<u32, [FloatInterval; 2]>);

fn zero() -> FloatInterval {
    FloatInterval::integer(0, &())
}

/// The largest of its numbers in size.
fn size(x: &FloatInterval) -> FloatInterval {
    let most = x.lo().abs().max(x.hi().abs());
    FloatInterval::from_bounds(most, most)
}

fn dot<'a>(row: impl Iterator<Item = &'a FloatInterval>, x: &[FloatInterval]) -> FloatInterval {
    row.zip(x).fold(zero(), |sum, (a, b)| sum + &(*a * b))
}

impl Equations {
    /// For the machine of a scene; or why there are none.
    fn of(
        job: &Job,
        name: &str,
        [lo, hi]: [&BigRational; 2],
    ) -> Result<std::result::Result<Equations, &'static str>> {
        let (scene, precision) = (&job.scene, Precision::new(BITS));
        let of = |(other, value): &(String, BigRational)| match other == name {
            true => Ball::between(lo, hi, &precision),
            false => Ball::ratio(value, &precision),
        };
        let values: Vec<Ball> = scene.parameters.iter().map(of).collect();
        let value = |expression: &Expression| {
            float(&expression.evaluate(&values, &precision)?)
                .ok_or_else(|| Error::input("a coefficient is not bounded"))
        };
        let found = match &scene.body {
            Body::Oscillator(system) => system.in_radians().try_map(value).map(Equations::of_oscillator),
            Body::Machine(machine) => machine.machine.try_map(value).map(Equations::of_machine),
        };
        Ok(found.unwrap_or(Err("a coefficient is not known between bounds")))
    }

    fn of_oscillator(system: System<FloatInterval>) -> std::result::Result<Equations, &'static str> {
        if system.smooth.is_some() || system.cubic.sign() != Some(Sign::Zero) {
            return Err("a force is not linear");
        }
        let one = |x: FloatInterval| vec![(0, 0, x)];
        let loads = system.forcing.into_iter().map(|load| (load.k, vec![load.cos], vec![load.sin]));
        let unit = FloatInterval::integer(1, &());
        let stop = |wall: Option<Wall<FloatInterval>>, sign: i32| {
            let sign = FloatInterval::integer(sign, &());
            wall.map(|wall| (vec![sign], scaled(wall, &sign)))
        };
        let stops = [stop(system.lower, 1), stop(system.upper, -1)];
        Ok(Equations {
            size: 1,
            mass: one(unit),
            damping: one(system.damping),
            stiffness: one(system.stiffness),
            loads: summed(1, vec![system.force], loads),
            stops: stops.into_iter().flatten().collect(),
        })
    }

    fn of_machine(machine: Machine<FloatInterval>) -> std::result::Result<Equations, &'static str> {
        if machine.is_smooth() || machine.record.is_some() {
            return Err("a force is a formula, or measured once");
        }
        if !machine.damping_ratio.is_empty() {
            return Err("damping is given by ratios of modes, which are known in floats");
        }
        if !machine.friction.is_empty() {
            return Err("there is dry friction");
        }
        if machine.size > COORDINATES {
            return Err("there are more than 40 coordinates");
        }
        let turn = float(&(Ball::pi(&Precision::new(BITS)) * &Ball::integer(2, &Precision::new(BITS))));
        let rate = turn.unwrap_or(FloatInterval::WHOLE) / &machine.period;
        let n = machine.size;
        // Forces and rows are of coordinates, the equations of modes where there are shapes.
        let seen = |given: Vec<FloatInterval>| match machine.shapes.is_empty() || given.is_empty() {
            true => given,
            false => {
                (0..n).map(|j| dot(machine.shapes.iter().map(|row| &row[j]), &given)).collect::<Vec<_>>()
            }
        };
        let times = |all: Vec<(usize, usize, FloatInterval)>, factor: FloatInterval| {
            all.into_iter().map(|(i, j, x)| (i, j, x * &factor)).collect()
        };
        let loads = machine.forcing.into_iter().map(|load| (load.k, seen(load.cos), seen(load.sin)));
        Ok(Equations {
            size: n,
            mass: times(machine.mass, rate * &rate),
            damping: times(machine.damping, rate),
            loads: summed(n, seen(machine.force), loads),
            stops: machine.stops.into_iter().map(|stop| (seen(stop.row), stop.wall)).collect(),
            stiffness: machine.stiffness,
        })
    }

    /// The gaps of the response, where it is certain to be one.
    fn gaps(&self) -> Option<Vec<Gap>> {
        let place = |(_, wall): &(_, Wall<FloatInterval>)| {
            let moved = wall.harmonics.iter().map(|h| (h.k, [-h.cos, -h.sin]));
            let mut terms = BTreeMap::from([(0, [-wall.offset, zero()])]);
            for (k, [cos, sin]) in moved {
                let known = terms.entry(k).or_insert([zero(), zero()]);
                *known = [known[0] + &cos, known[1] + &sin];
            }
            Gap(terms)
        };
        let mut gaps: Vec<Gap> = self.stops.iter().map(place).collect();
        for (k, load) in &self.loads {
            let found = self.response(*k, load)?;
            for (gap, (row, _)) in gaps.iter_mut().zip(&self.stops) {
                let known = gap.0.entry(*k).or_insert([zero(), zero()]);
                for (known, part) in known.iter_mut().zip(&found) {
                    *known = *known + &dot(row.iter(), part);
                }
            }
        }
        Some(gaps)
    }

    /// x and y of the harmonic k.
    fn response(&self, k: u32, [cos, sin]: &[Vec<FloatInterval>; 2]) -> Option<[Vec<FloatInterval>; 2]> {
        let (n, order) = (self.size, FloatInterval::integer(i32::try_from(k).ok()?, &()));
        // A constant force has no sine.
        let rows = if k == 0 { n } else { 2 * n };
        let mut a = vec![vec![zero(); rows]; rows];
        let mut add = |i: usize, j: usize, x: FloatInterval| a[i][j] = a[i][j] + &x;
        let square = order * &order;
        let still = self.stiffness.iter().copied();
        for (i, j, x) in still.chain(self.mass.iter().map(|&(i, j, x)| (i, j, -(x * &square)))) {
            add(i, j, x);
            if k > 0 {
                add(n + i, n + j, x);
            }
        }
        for &(i, j, x) in self.damping.iter().filter(|_| k > 0) {
            add(i, n + j, x * &order);
            add(n + i, j, -(x * &order));
        }
        let b: Vec<FloatInterval> = cos.iter().chain(sin).copied().take(rows).collect();
        let mut found = solved(&a, &b)?;
        let sines = if k == 0 { vec![zero(); n] } else { found.split_off(n) };
        Some([found, sines])
    }
}

/// A number's bounds in floats.
fn float(ball: &Ball) -> Option<FloatInterval> {
    let (lo, hi) = ball.exact_bounds()?;
    let [lo, hi] = [lo, hi].map(|end| FloatInterval::ratio(&end, &()));
    Some(FloatInterval::from_bounds(lo.lo(), hi.hi()))
}

/// A wall as it is seen from the other side for −1.
fn scaled(mut wall: Wall<FloatInterval>, sign: &FloatInterval) -> Wall<FloatInterval> {
    wall.offset = wall.offset * sign;
    wall.harmonics.iter_mut().for_each(|h| (h.cos, h.sin) = (h.cos * sign, h.sin * sign));
    wall
}

/// Forces by their orders; a list without entries is 0.
fn summed(
    size: usize,
    constant: Vec<FloatInterval>,
    loads: impl Iterator<Item = (u32, Vec<FloatInterval>, Vec<FloatInterval>)>,
) -> BTreeMap<u32, [Vec<FloatInterval>; 2]> {
    let mut all = BTreeMap::new();
    for (k, cos, sin) in std::iter::once((0, constant, Vec::new())).chain(loads) {
        let known = all.entry(k).or_insert_with(|| [vec![zero(); size], vec![zero(); size]]);
        for (known, part) in known.iter_mut().zip([cos, sin]) {
            known.iter_mut().zip(part).for_each(|(sum, x)| *sum = *sum + &x);
        }
    }
    all
}

/// The solution of Ax = b, if A is certain to have an inverse.
fn solved(a: &[Vec<FloatInterval>], b: &[FloatInterval]) -> Option<Vec<FloatInterval>> {
    let n = a.len();
    let middle = |x: &FloatInterval| x.lo() / 2.0 + x.hi() / 2.0;
    let point = |x: f64| FloatInterval::from_bounds(x, x);
    let inverse = RealMatrix::from_fn(n, n, |i, j| middle(&a[i][j])).try_inverse()?;
    let near = &inverse * RealVector::from_iterator(n, b.iter().map(middle));
    let near: Vec<FloatInterval> = near.iter().map(|x| point(*x)).collect();
    let left: Vec<FloatInterval> = a.iter().zip(b).map(|(row, b)| *b - &dot(row.iter(), &near)).collect();
    let (mut norm, mut off) = (zero(), zero());
    let larger = |x: FloatInterval, y: FloatInterval| if x.hi() > y.hi() { x } else { y };
    for i in 0..n {
        let row: Vec<FloatInterval> = (0..n).map(|j| point(inverse[(i, j)])).collect();
        let entry = |j: usize| {
            let one = FloatInterval::integer(i32::from(i == j), &());
            size(&(one - &dot(a.iter().map(|row| &row[j]), &row)))
        };
        norm = larger(norm, (0..n).map(entry).fold(zero(), |sum, x| sum + &x));
        off = larger(off, size(&dot(row.iter(), &left)));
    }
    let rest = FloatInterval::integer(1, &()) - &norm;
    if rest.sign() != Some(Sign::Positive) {
        return None;
    }
    let off = (off / &rest).hi();
    let off = FloatInterval::from_bounds(-off, off);
    Some(near.into_iter().map(|x| x + &off).collect())
}

impl Gap {
    /// z and z′ at a phase.
    fn at(&self, phase: &Angle) -> [FloatInterval; 2] {
        let mut sum = [zero(), zero()];
        for (k, [a, b]) in &self.0 {
            let angle = phase.times(u64::from(*k));
            let (sin, cos) = (FloatInterval::sin(&angle, &()), FloatInterval::sin(&angle.complement(), &()));
            let order = FloatInterval::from_bounds(f64::from(*k), f64::from(*k));
            sum[0] = sum[0] + &(*a * &cos) + &(*b * &sin);
            sum[1] = sum[1] + &((*b * &cos - &(*a * &sin)) * &order);
        }
        sum
    }

    /// Whether it is certain to be above 0 at all phases.
    fn is_clear(&self) -> bool {
        let half = FloatInterval::from_bounds(0.5, 0.5);
        let bend = self.0.iter().fold(zero(), |sum, (k, [a, b])| {
            let order = FloatInterval::from_bounds(f64::from(*k), f64::from(*k));
            sum + &((size(a) + &size(b)) * &(order * &order))
        });
        // π/2^level from above, half of a part of the period.
        let reach = |level: u32| FloatInterval::from_bounds(0.0, 3.15 / (1u64 << level) as f64);
        let level = PARTS.ilog2();
        let mut left: Vec<(u32, u64)> = (0..u64::from(PARTS)).map(|i| (level, i)).collect();
        let mut looks = 0;
        while let Some((level, i)) = left.pop() {
            looks += 1;
            let h = reach(level);
            let middle = BigRational::new((2 * i + 1).into(), BigInt::one() << level);
            let [z, slope] = self.at(&Angle::new(&middle));
            let below = size(&slope) * &h + &(bend * &(h * &h) * &half);
            if (z - &below).lo() > 0.0 {
                continue;
            }
            if level >= HALVED || looks > LOOKS || z.hi() < 0.0 {
                return false;
            }
            left.extend([(level + 1, 2 * i), (level + 1, 2 * i + 1)]);
        }
        true
    }
}
