//! What is measured of an orbit: the impulses of its impacts, and how far its coordinates go.

use super::{
    Machine,
    branch::{Solved, depth_of},
    orbit::Orbit,
};
use crate::{continuation::extents, error::Result};

/// The impulse of each impact in the scene's units, none where the orbit touches a stop that gives way; the
/// least and the greatest of each coordinate, if asked for. `depth` is that of
/// [`Patterns::new`](super::branch::Patterns::new).
///
/// # Errors
/// Where the machine is not defined, or cannot be followed.
pub fn measure(
    machine: &Machine<f64>,
    depth: Option<f64>,
    (orbit, is_far): (&Orbit, bool),
) -> Result<(Vec<f64>, Vec<[f64; 2]>)> {
    let solved = Solved::new(machine, &orbit.itinerary, depth_of(machine, depth)?, None)?;
    let (equations, contacts) = (solved.equations(&orbit.itinerary, orbit.scale), &solved.contacts);
    let factor = |stop: usize, speed: f64| 1.0 + contacts.all()[stop].restitution_at(speed);
    let mass = |stop: usize| 1.0 / contacts.mobility(stop) / machine.rate();
    let impulses = orbit.impacts.iter().map(|hit| factor(hit.stop, hit.speed) * hit.speed * mass(hit.stop));
    let seen = |t: f64| {
        let state = equations.state(&orbit.z, t)?;
        let (q, u) = (machine.seen(&state.q), machine.seen(&state.u));
        Ok(q.iter().zip(u.iter()).map(|(q, u)| [*q, *u]).collect())
    };
    let is_rigid = orbit.touches.contacts.is_empty();
    Ok((impulses.filter(|_| is_rigid).collect(), if is_far { extents(orbit, seen)? } else { Vec::new() }))
}
