//! All orbits of a pattern that Newton's method finds from many starts.

use std::f64::consts::TAU;

use super::{
    Itinerary, Orbit, Oscillator, find,
    solution::{find_beside, find_projected, obstacle},
};
use crate::{
    continuation::{NEAR, OrbitSearch, Starts, search_all},
    error::{Error, Result},
    motion::State,
};

/// The orbits reached from `starts` well-spread starts with speeds up to `speed`, admissible or not, with
/// every speed positive: each once, whichever of its impacts is called the first, those that go round a
/// shorter pattern left out. Sorted by speeds. Finding none proves nothing. Cost: [`search_all`] with Newton
/// solutions.
///
/// # Errors
/// Those of `check`, which is asked now and then whether to go on.
pub fn search_while(
    oscillator: &Oscillator,
    itinerary: &Itinerary,
    starts: u32,
    speed: f64,
    check: impl Fn() -> Result<()>,
) -> Result<OrbitSearch<Orbit>> {
    let m = itinerary.strikes().len();
    if m == 0 {
        // Newton's method goes no farther than 60 sizes of the forces: at a resonance the motion is there.
        let found = find(oscillator, itinerary, vec![0.0; 2])
            .or_else(|error| oscillator.response().map_or(Err(error), |z| find(oscillator, itinerary, z)));
        return Ok(OrbitSearch::of_one(found));
    }
    let begin = begin(oscillator, itinerary, speed);
    let periods = whole_periods(itinerary);
    // Of several impacts the times alone are spread where speeds follow from them.
    let find = if m > 1 && oscillator.response().is_some() { find_projected } else { find_beside };
    let look = |i: u32, known: &[Orbit]| find(oscillator, itinerary, &begin.of(&periods, i), known);
    let whole = |orbit: &Orbit| {
        let moving = orbit.z.chunks(2).all(|impact| impact[1] > NEAR * orbit.unit);
        Ok(moving && (1..m).all(|shift| !same(orbit, orbit, shift)))
    };
    let alike = |a: &Orbit, b: &Orbit| (0..m).any(|shift| same(a, b, shift));
    let hopeless = || search_obstacle(oscillator, itinerary, 1, speed).is_some_and(|error| error.is_limit());
    let mut all = search_all(starts, look, alike, whole, hopeless, check)?;
    all.found.sort_by(|a, b| a.z[1].total_cmp(&b.z[1]));
    Ok(all)
}

/// The orbits of [`search_while`], to its end.
pub fn search(oscillator: &Oscillator, itinerary: &Itinerary, starts: u32, speed: f64) -> Vec<Orbit> {
    search_while(oscillator, itinerary, starts, speed, || Ok(())).map_or_else(|_| Vec::new(), |all| all.found)
}

/// Why a search finds nothing, if the motion of one of its first starts cannot be followed.
pub fn search_obstacle(
    oscillator: &Oscillator,
    itinerary: &Itinerary,
    starts: u32,
    speed: f64,
) -> Option<Error> {
    match itinerary.strikes().len() {
        0 => obstacle(oscillator, itinerary, &[0.0; 2]),
        _ => {
            let (begin, periods) = (begin(oscillator, itinerary, speed), whole_periods(itinerary));
            (0..starts.min(LOOKS)).find_map(|i| obstacle(oscillator, itinerary, &begin.of(&periods, i)))
        }
    }
}

fn whole_periods(itinerary: &Itinerary) -> Vec<u32> {
    itinerary.strikes().iter().map(|strike| strike.periods).collect()
}

/// Starts that are looked at for a reason.
const LOOKS: u32 = 16;

/// Where a search begins: told by what pulls a body that rests on the wall of the first impact.
fn begin(oscillator: &Oscillator, itinerary: &Itinerary, speed: f64) -> Starts {
    let struck = itinerary.strikes().first().map(|strike| strike.place);
    let wall = oscillator.walls().iter().find(|wall| Some(wall.side) == struck);
    Starts::new(speed, |t| {
        let Some(wall) = wall else { return 0.0 };
        let [q, u, _] = wall.position.at(t);
        wall.acceleration(oscillator.flow(), State { t, q, u })
    })
}

/// Whether b is a with impact `shift` called the first.
fn same(a: &Orbit, b: &Orbit, shift: usize) -> bool {
    let (strikes, m) = (a.itinerary.strikes(), a.itinerary.strikes().len());
    (0..m).all(|i| {
        let (x, y) = (&a.z[2 * i..], &b.z[2 * ((i + shift) % m)..]);
        let turn = (x[0] - y[0]).rem_euclid(TAU);
        strikes[i].place == strikes[(i + shift) % m].place
            && turn.min(TAU - turn) < NEAR
            && (x[1] - y[1]).abs() < NEAR * a.unit
    })
}
