//! The Poincaré map round an orbit as a Taylor polynomial of degree 3.
//!
//! The section of an orbit with impacts is its first impact: coordinates (t, V), the time and the incoming
//! speed. That of an orbit without is t = 0: coordinates (q, u). All derivatives are exact to rounding:
//! polynomials go through the flow and the impacts in place of numbers. The map is smooth as long as every
//! speed is positive. Not here: what its coefficients mean (`normal_form`).

use std::f64::consts::TAU;

use super::{Itinerary, Oscillator, passage::Unknowns};
use crate::{
    continuation::{Cubic, polynomial},
    error::{Error, Result},
    motion::{
        Flow, Series, Side, State,
        flow::{Equation, Free, Program, Scalar, Size},
    },
};

/// The image of (x, y), both counted from the orbit's own point of the section.
pub(crate) type ReturnMap = [Cubic; 2];

/// A state whose coordinates are polynomials, at a time that is one.
#[derive(Clone, Copy)]
struct Point {
    q: Cubic,
    u: Cubic,
}

/// The expansion of the Poincaré map at a solution z of the pattern equations. Cost: one flow with variations
/// for each impact if the system is linear; else the Taylor steps of its flow, each with 30² products of
/// polynomials.
///
/// # Errors
/// An input error if a wall is missing, an impact does not come in, or the motion leaves every bound.
pub fn return_map(oscillator: &Oscillator, itinerary: &Itinerary, z: &[f64]) -> Result<ReturnMap> {
    let unknowns = Unknowns::new(itinerary, z)?;
    let equation = &Expanded::new(oscillator.flow().equation())?;
    let [x, y] = [0, 1].map(|which| Cubic::variable(0.0, which));
    if itinerary.strikes().is_empty() {
        let from = Point { q: Cubic::constant(z[0]) + x, u: Cubic::constant(z[1]) + y };
        let end = fly(oscillator, equation, from, 0.0, TAU * f64::from(itinerary.periods()))?;
        return Ok([end.q.without_value(), end.u.without_value()]);
    }
    let (mut delay, mut speed) = (x, Cubic::constant(unknowns.speed(0)) + y);
    for passage in unknowns.passages(oscillator) {
        let passage = passage?;
        if passage.arrival.speed.is_nan() || passage.arrival.speed <= 0.0 {
            return Err(Error::input("the Poincaré map is not smooth: an impact does not come in"));
        }
        let (wall, t) = (passage.here.wall, passage.from.t);
        let left = Point {
            q: shifted(&wall.position, t, delay),
            u: shifted(&wall.position.derivative(), t, delay)
                + speed.scaled(wall.side.sign() * wall.restitution),
        };
        // Back to the impact's own time, from there to the next one's, and on to the wall.
        let left = moved(&series(equation, left, t, delay, 5), -delay);
        let end = fly(oscillator, equation, left, t, passage.duration)?;
        let ahead = series(equation, end, t + passage.duration, Cubic::constant(0.0), 5);
        let there = passage.there.wall;
        (delay, speed) = arrive(&ahead, &there.position, there.side, t + passage.duration);
    }
    Ok([delay, speed.without_value()])
}

/// When the motion with these Taylor coefficients in time meets a wall, and how fast: Newton's iteration,
/// exact after three.
fn arrive(ahead: &[Cubic], wall: &Series, side: Side, t: f64) -> (Cubic, Cubic) {
    let mut place = wall.clone();
    let mut gap = Vec::new();
    let mut factorial = 1.0;
    for (k, coefficient) in ahead.iter().enumerate() {
        factorial *= (k as f64).max(1.0);
        let wall = Cubic::constant(place.at(t)[0] / factorial);
        gap.push((*coefficient - wall).scaled(side.sign()));
        place = place.derivative();
    }
    // The orbit's own impact is at this time, whatever rounding has left.
    gap[0] = gap[0].without_value();
    let per_speed = -gap[1].inverse();
    let mut late = Cubic::constant(0.0);
    for _ in 0..3 {
        let bent = late * late * (gap[2] + late * gap[3]);
        late = (gap[0] + bent) * per_speed;
    }
    let slope: Vec<Cubic> = (1..gap.len()).map(|k| gap[k].scaled(-(k as f64))).collect();
    (late, polynomial(&slope, late))
}

/// The series at t + `by`, which vanishes at (0, 0).
fn shifted(series: &Series, t: f64, by: Cubic) -> Cubic {
    let [value, first, second] = series.at(t);
    let third = series.derivative().at(t)[2];
    polynomial(&[value, first, second / 2.0, third / 6.0].map(Cubic::constant), by)
}

/// An equation of motion, and its program in polynomials if it has one.
struct Expanded<'a> {
    equation: &'a Equation,
    program: Option<Program<Cubic>>,
}

impl Expanded<'_> {
    fn new(equation: &Equation) -> Result<Expanded<'_>> {
        let program = equation.smooth.as_ref().map(|smooth| smooth.program_in()).transpose()?;
        Ok(Expanded { equation, program })
    }
}

/// The first Taylor coefficients in time of the motion from a point at t + `late`.
fn series(expanded: &Expanded, from: Point, t: f64, late: Cubic, count: usize) -> Vec<Cubic> {
    if let Some(program) = &expanded.program {
        return program.solve([from.q, from.u], Cubic::constant(t) + late, 1.0, count).q().to_vec();
    }
    let equation = expanded.equation;
    let mut q = vec![from.q, from.u];
    let mut square: Vec<Cubic> = Vec::new();
    let (mut forcing, mut factorial) = (equation.forcing.clone(), 1.0);
    for k in 0..count.saturating_sub(2) {
        factorial *= (k as f64).max(1.0);
        let push = shifted(&forcing, t, late).scaled(1.0 / factorial);
        forcing = forcing.derivative();
        let mut sum =
            push - q[k + 1].scaled(equation.damping * (k + 1) as f64) - q[k].scaled(equation.stiffness);
        if equation.cubic != 0.0 {
            let convolved =
                |a: &[Cubic], b: &[Cubic]| (0..=k).fold(Cubic::constant(0.0), |sum, i| sum + a[i] * b[k - i]);
            square.push(convolved(&q, &q));
            sum = sum - convolved(&square, &q).scaled(equation.cubic);
        }
        q.push(sum.scaled(1.0 / ((k + 1) * (k + 2)) as f64));
    }
    q
}

/// The point a time `by` on along a motion with these coefficients.
fn moved(q: &[Cubic], by: Cubic) -> Point {
    let slope: Vec<Cubic> = (1..q.len()).map(|k| q[k].scaled(k as f64)).collect();
    Point { q: polynomial(q, by), u: polynomial(&slope, by) }
}

/// The motion for a given time from a given time.
fn fly(oscillator: &Oscillator, equation: &Expanded, from: Point, t: f64, duration: f64) -> Result<Point> {
    if let Free::Linear(_) = oscillator.flow() {
        // The flow is affine: one matrix carries everything but the orbit's own motion.
        let start = State { t, q: from.q.value(), u: from.u.value() };
        let (end, m) = oscillator.flow().advance_linearised(start, duration);
        let (q, u) = (from.q.without_value(), from.u.without_value());
        let row = |i: usize, value: f64| q.scaled(m[i][0]) + u.scaled(m[i][1]) + Cubic::constant(value);
        return Ok(Point { q: row(0, end.q), u: row(1, end.u) });
    }
    const COUNT: usize = 30;
    let (mut here, mut at) = (from, 0.0);
    for _ in 0..MOST_STEPS {
        if at >= duration {
            return Ok(here);
        }
        let q = series(equation, here, t + at, Cubic::constant(0.0), COUNT);
        // The last terms are to be below rounding in every coefficient, each with a unit of its own.
        let fits =
            |longest: f64, part: usize| Size::of(|k| q[k].part(part), 1.0, COUNT - 1).reach(1e-17, longest);
        let step = (0..Cubic::PARTS).fold(duration - at, fits);
        if step.is_nan() || step <= 1e-9 {
            break;
        }
        here = moved(&q, Cubic::constant(step));
        at = if duration - at <= step { duration } else { at + step };
    }
    Err(Error::input("the Poincaré map's derivatives cannot be followed round the orbit"))
}

/// Most Taylor steps of one flight.
const MOST_STEPS: u32 = 100_000;
