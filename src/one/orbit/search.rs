//! All orbits of a pattern that Newton's method finds from many starts.

use std::f64::consts::TAU;

use rayon::prelude::*;

use super::{Itinerary, Orbit, Oscillator, find, solution::obstacle};
use crate::error::Error;

/// The orbits reached from `starts` well-spread starts with speeds up to `speed`, admissible or not, with
/// every speed positive: each once, whichever of its impacts is called the first, those that go round a
/// shorter pattern left out. Sorted by speeds. Finding none proves nothing. Cost: `starts` Newton solutions,
/// shared by the threads.
pub fn search(oscillator: &Oscillator, itinerary: &Itinerary, starts: u32, speed: f64) -> Vec<Orbit> {
    let m = itinerary.strikes().len();
    if m == 0 {
        return find(oscillator, itinerary, vec![0.0; 2]).into_iter().collect();
    }
    let one = |i: u32| find(oscillator, itinerary, start(m, speed, i)).ok();
    let roots: Vec<Orbit> = (0..starts).into_par_iter().filter_map(one).collect();
    let mut found: Vec<Orbit> = Vec::new();
    for orbit in roots {
        let moving = orbit.z.chunks(2).all(|impact| impact[1] > NEAR * orbit.unit);
        let primitive = (1..m).all(|shift| !same(&orbit, &orbit, shift));
        if moving && primitive && found.iter().all(|old| (0..m).all(|shift| !same(old, &orbit, shift))) {
            found.push(orbit);
        }
    }
    found.sort_by(|a, b| a.z[1].total_cmp(&b.z[1]));
    found
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
        m => (0..starts.min(LOOKS)).find_map(|i| obstacle(oscillator, itinerary, &start(m, speed, i))),
    }
}

/// Starts that are looked at for a reason.
const LOOKS: u32 = 16;

/// The i-th start of a pattern with m impacts.
fn start(m: usize, speed: f64, i: u32) -> Vec<f64> {
    let sequence = |j: usize| (0.5 + f64::from(i) * spread(j, 2 * m)).fract();
    (0..2 * m).map(|j| sequence(j) * if j % 2 == 0 { TAU } else { speed }).collect()
}

/// Closer than this, in radians and in the size of the motion, two solutions are one.
const NEAR: f64 = 1e-7;

/// Whether b is a with impact `shift` called the first.
fn same(a: &Orbit, b: &Orbit, shift: usize) -> bool {
    let (strikes, m) = (a.itinerary.strikes(), a.itinerary.strikes().len());
    (0..m).all(|i| {
        let (x, y) = (&a.z[2 * i..], &b.z[2 * ((i + shift) % m)..]);
        let turn = (x[0] - y[0]).rem_euclid(TAU);
        strikes[i].side == strikes[(i + shift) % m].side
            && turn.min(TAU - turn) < NEAR
            && (x[1] - y[1]).abs() < NEAR * a.unit
    })
}

/// The j-th ratio of an additive recurrence in `dimension` dimensions (powers of 1/φ_d, φ_d^{d+1} = φ_d + 1):
/// points that fill the cube evenly.
fn spread(j: usize, dimension: usize) -> f64 {
    let mut root: f64 = 2.0;
    for _ in 0..40 {
        root = (1.0 + root).powf(1.0 / (dimension as f64 + 1.0));
    }
    root.powi(-(j as i32 + 1))
}
