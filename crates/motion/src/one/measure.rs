//! What is measured of an orbit: the impulses of its impacts, and how far it goes.

use crate::{
    continuation::extents,
    error::Result,
    one::orbit::{Orbit, Oscillator, Unknowns},
};

/// The impulse of each impact of an oscillator with this mass, in the scene's units.
pub fn impulses(oscillator: &Oscillator, mass: f64, orbit: &Orbit) -> Vec<f64> {
    let restitution = |side| oscillator.system().wall(side).map_or(f64::NAN, |wall| wall.restitution);
    let impulse = |speed: f64, side| mass * (1.0 + restitution(side)) * speed * orbit.rate;
    orbit.impacts().map(|impact| impulse(impact.speed, impact.side)).collect()
}

/// The least and the greatest displacement. Cost: that of [`extents`].
///
/// # Errors
/// Those of [`Orbit::state`].
pub fn extent(oscillator: &Oscillator, orbit: &Orbit) -> Result<Vec<[f64; 2]>> {
    let (mut starts, mut first) = (vec![0.0], 0.0);
    if !orbit.itinerary.strikes().is_empty() {
        let unknowns = Unknowns::new(&orbit.itinerary, &orbit.z)?;
        first = unknowns.phase(0);
        (1..orbit.itinerary.strikes().len())
            .for_each(|i| starts.push(starts[i - 1] + unknowns.duration(i - 1)));
    }
    extents(&starts, orbit.period(), |t| {
        let state = orbit.state(oscillator, first + t)?;
        Ok(vec![[state.q, state.u]])
    })
}
