//! Where a search for orbits begins: the same starts in every form of a question.
//!
//! They fill the phases and the speeds evenly. Speeds are parts of a greatest one, and phases count from one
//! that is the system's own, so that neither the phase from which time is counted nor a unit changes what is
//! found, nor whether the wall moves or what hits it. That phase is told by what pulls a body that rests on
//! the wall: the acceleration of its gap there, which no frame changes.

use std::f64::consts::TAU;

use crate::rounding::SUM;

/// Times and speeds to start from, of any number of impacts: the i-th of a search.
#[derive(Debug, Clone, Copy)]
pub struct Starts {
    /// The phase from which the others count.
    phase: f64,
    /// The greatest speed.
    speed: f64,
}

/// Phases at which the acceleration on the wall is looked at.
const LOOKS: u32 = 64;

/// Of the strongest part, what a harmonic has at least that the phase is told by.
const TOLD: f64 = 0.125;

impl Starts {
    /// With the acceleration of the gap at a phase while it is closed.
    pub fn new(speed: f64, on_wall: impl Fn(f64) -> f64) -> Starts {
        let looks: Vec<(f64, f64)> =
            (0..LOOKS).map(|i| TAU * f64::from(i) / f64::from(LOOKS)).map(|t| (t, on_wall(t))).collect();
        let harmonic = |k: u32| {
            looks.iter().fold([0.0; 2], |[c, s], (t, a)| {
                let (sin, cos) = (f64::from(k) * t).sin_cos();
                [c + a * cos, s + a * sin]
            })
        };
        let all: Vec<[f64; 2]> = (1..LOOKS / 2).map(harmonic).collect();
        let size = |[c, s]: &[f64; 2]| c.hypot(*s);
        let strongest = all.iter().map(size).fold(0.0, f64::max);
        // Where nothing moves, rounding does.
        let sum: f64 = looks.iter().map(|(_, a)| a.abs()).sum();
        let told = (1..).zip(&all).find(|(_, one)| size(one) > f64::max(TOLD * strongest, SUM * sum));
        let phase = told.map_or(0.0, |(k, [c, s])| {
            let quarters = s.atan2(*c) / (TAU / 4.0);
            let near = quarters.round();
            TAU / 4.0 * if (quarters - near).abs() < SUM { near } else { quarters } / f64::from(k)
        });
        Starts { phase: if phase.is_finite() { phase } else { 0.0 }, speed }
    }

    /// t_1, V_1, …, t_m, V_m of the i-th start, for flights of so many whole periods and t_{j+1} − t_j. Times
    /// are in the period after the system's own phase; those between which no whole period lies ascend, for
    /// no impact is before the one that it follows.
    pub fn of(&self, periods: &[u32], i: u32) -> Vec<f64> {
        let m = periods.len();
        let part = |j: usize| Starts::part(i, j, 2 * m);
        let place = |j: usize| match j.is_multiple_of(2) {
            true => self.phase + part(j) * TAU,
            false => self.speed * part(j),
        };
        let mut all: Vec<f64> = (0..2 * m).map(place).collect();
        // From after a whole period, so that no run goes round; there is one, or nothing is periodic.
        let first = periods.iter().position(|&n| n > 0).map_or(0, |j| j + 1);
        let order: Vec<usize> = (0..m).map(|j| (first + j) % m).collect();
        for run in order.split_inclusive(|&j| periods[j] > 0) {
            let mut times: Vec<f64> = run.iter().map(|&j| all[2 * j]).collect();
            times.sort_by(f64::total_cmp);
            run.iter().zip(times).for_each(|(&j, time)| all[2 * j] = time);
        }
        all
    }

    /// Of the i-th of points that fill a cube of so many dimensions evenly, coordinate j, from 0 to 1.
    pub fn part(i: u32, j: usize, dimensions: usize) -> f64 {
        (0.5 + f64::from(i) * spread(j, dimensions)).fract()
    }

    /// The phase in [0, 2π) that is a part of the period after the system's own.
    pub fn phase(&self, part: f64) -> f64 {
        (self.phase + part * TAU).rem_euclid(TAU)
    }

    /// The greatest speed.
    pub fn speed(&self) -> f64 {
        self.speed
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The starts of a wall that pulls as one with two harmonics does, counted from another phase.
    fn starts(shift: f64, unit: f64) -> Vec<Vec<f64>> {
        let on_wall = |t: f64| unit * (0.25 + (t + shift).cos() + 0.5 * (2.0 * (t + shift) - 1.0).sin());
        let starts = Starts::new(unit * 3.0, on_wall);
        (0..20).map(|i| starts.of(&[1, 2], i)).collect()
    }

    #[test]
    fn starts_move_with_the_phase_and_grow_with_the_unit() {
        let known = starts(0.0, 1.0);
        for shift in [TAU / 4.0, 0.1, 2.0, -3.0] {
            for (a, b) in known.iter().zip(starts(shift, 1024.0)) {
                for (j, (x, y)) in a.iter().zip(&b).enumerate() {
                    let far = if j % 2 == 0 { (y + shift - x) / TAU } else { y / 1024.0 - x };
                    assert!((far - far.round()).abs() < 1e-12, "{x} {y} {shift}");
                }
                // The flights are the same, not only where in a period they begin and end.
                assert!(((b[2] - b[0]) - (a[2] - a[0])).abs() < 1e-12, "{a:?} {b:?} {shift}");
            }
        }
    }

    #[test]
    fn a_cosine_has_the_phase_0_and_so_has_what_does_not_move() {
        let [moved, still] = [1.0, 0.0].map(|size| Starts::new(1.0, |t: f64| size * t.cos() - 0.25));
        assert_eq!(moved.of(&[4], 3), still.of(&[4], 3));
        assert_eq!(moved.phase, 0.0);
    }

    #[test]
    fn no_flight_ends_before_it_begins() {
        let starts = Starts::new(1.0, |t: f64| (t + 0.3).cos());
        for periods in [&[0, 1][..], &[1, 0], &[0, 0, 1], &[0, 2, 0, 0, 1], &[1, 1]] {
            let m = periods.len();
            let flight =
                |all: &[f64], j: usize| f64::from(periods[j]) * TAU + all[2 * ((j + 1) % m)] - all[2 * j];
            for i in 0..100 {
                let all = starts.of(periods, i);
                assert!((0..m).all(|j| flight(&all, j) >= 0.0), "{periods:?} {all:?}");
            }
        }
    }
}
