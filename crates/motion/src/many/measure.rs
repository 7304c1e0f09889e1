//! What is measured of an orbit: the impulses of its impacts, and how far its coordinates go.

use std::f64::consts::TAU;

use super::{
    LinearFlow, Machine,
    branch::{Solved, depth_of},
    contact::Contacts,
    orbit::Orbit,
};
use crate::{continuation::extents, error::Result};

/// The impulse of each impact of the pattern, in the scene's units; none where the orbit touches a stop that
/// gives way, which are not among these.
///
/// # Errors
/// Where the machine is not defined.
pub fn impulses(machine: &Machine<f64>, orbit: &Orbit) -> Result<Option<Vec<f64>>> {
    if !orbit.touches.contacts.is_empty() {
        return Ok(None);
    }
    let flow = LinearFlow::new(machine.equations()?)?;
    let contacts = Contacts::new(flow.equations(), machine.contacts()?, machine.rubs()?);
    let impulse = |stop: usize, speed: f64| {
        let factor = 1.0 + contacts.all()[stop].restitution_at(speed);
        factor * speed / contacts.mobility(stop) / machine.rate()
    };
    Ok(Some(orbit.impacts.iter().map(|impact| impulse(impact.stop, impact.speed)).collect()))
}

/// The least and the greatest of each coordinate; the minimum depth is that of
/// [`Patterns::new`](super::branch::Patterns::new). Cost: that of [`extents`].
///
/// # Errors
/// Where the machine is not defined, or cannot be followed.
pub fn extent(machine: &Machine<f64>, depth: Option<f64>, orbit: &Orbit) -> Result<Vec<[f64; 2]>> {
    let solved = Solved::new(machine, &orbit.itinerary, depth_of(machine, depth)?, None)?;
    let equations = solved.equations(&orbit.itinerary, orbit.scale);
    let times: Vec<f64> = orbit.impacts.iter().map(|impact| impact.time).collect();
    let mut starts = vec![0.0];
    for i in 1..times.len() {
        starts.push(starts[i - 1] + equations.duration(&times, i - 1)?);
    }
    extents(&starts, TAU * f64::from(orbit.itinerary.periods()), |t| {
        let state = equations.state(&orbit.z, t)?;
        let (q, u) = (machine.seen(&state.q), machine.seen(&state.u));
        Ok(q.iter().zip(u.iter()).map(|(q, u)| [*q, *u]).collect())
    })
}
