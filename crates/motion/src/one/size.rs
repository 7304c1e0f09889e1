//! The size of an oscillator's motion: what its lengths are measured by, so that no unit of length decides
//! anything. Velocities are per radian of the forcing and have the same unit.
//!
//! It is told by what moves the oscillator and by the walls that are met: a wall that is farther away than
//! ten times the motion, and is not struck by what is looked at, enters nowhere.

use std::f64::consts::TAU;

use crate::motion::{
    Contact,
    flow::{Equation, Gradient, Scalar},
};

/// A wall that is farther away than this many times what moves is not met.
const MET: f64 = 10.0;

/// Phases at which a force is looked at.
const LOOKS: u32 = 16;

/// The size of the motion that the forces alone bring about: what each of them does in a radian or, if that
/// is less, in its own period or against a spring and a damper. A formula is looked at where the oscillator
/// is at rest in 0.
fn forced(equation: &Equation) -> f64 {
    let Some(smooth) = &equation.smooth else {
        let (stiffness, damping) = (equation.stiffness.abs(), equation.damping.abs());
        let slow = |k: f64| f64::max(1.0, stiffness).max(k * damping).max(k * k);
        let harmonics = equation.forcing.harmonics().iter();
        return harmonics.fold(equation.forcing.mean().abs() / slow(0.0), |sum, harmonic| {
            sum + harmonic.cos.hypot(harmonic.sin) / slow(f64::from(harmonic.k))
        });
    };
    let [q, u] = [1, 2].map(|place| Gradient::variable(0.0, place));
    let at = |look: u32| smooth.varied.at(q, u, Gradient::constant(TAU * f64::from(look) / f64::from(LOOKS)));
    let all: Vec<_> = (0..LOOKS).map(at).collect();
    let largest = |part: usize| all.iter().map(|a| a.part(part).abs()).fold(0.0, f64::max);
    largest(0) / largest(1).max(largest(2)).max(1.0)
}

/// How far a wall moves, whatever the phase from which it is counted.
fn motion(wall: &Contact) -> f64 {
    wall.position.harmonics().iter().map(|harmonic| harmonic.cos.hypot(harmonic.sin)).sum()
}

/// Where a wall is, at most: its place and its motion.
fn place(wall: &Contact) -> f64 {
    wall.position.mean().abs() + motion(wall)
}

/// The size of the gap's motion at the nearest wall: of what the forces do, of the wall's place and motion. 0
/// if nothing moves and there is no wall, or only one at 0. What rounding of a gap is relative to.
pub(super) fn gap_size<'w>(equation: &Equation, walls: impl Iterator<Item = &'w Contact>) -> f64 {
    finite(nearest(walls).map_or(0.0, place).max(forced(equation)))
}

/// The size of motions that strike the walls of which `struck` says so: of what the forces do, of the places
/// and motions of these walls; of the nearest wall, too, unless it is farther away than ten times all that
/// moves. 1 if there is none of this.
pub(super) fn unit<'w>(
    equation: &Equation,
    walls: impl Iterator<Item = &'w Contact> + Clone,
    struck: impl Fn(&Contact) -> bool,
) -> f64 {
    let forced = forced(equation);
    let near = nearest(walls.clone()).map_or(forced, |wall| {
        let moved = motion(wall).max(forced);
        if moved > 0.0 && place(wall) > MET * moved { moved } else { forced.max(place(wall)) }
    });
    let size = finite(walls.filter(|wall| struck(wall)).map(place).fold(near, f64::max));
    if size > 0.0 { size } else { 1.0 }
}

/// The wall that comes nearest to 0.
fn nearest<'w>(walls: impl Iterator<Item = &'w Contact>) -> Option<&'w Contact> {
    let least = |wall: &Contact| -wall.side.sign() * wall.position.mean() - motion(wall);
    walls.min_by(|a, b| least(a).total_cmp(&least(b)))
}

fn finite(size: f64) -> f64 {
    if size.is_finite() { size } else { 0.0 }
}
