//! The detector of attractors by itself, on a map that is written out: what it says where Newton's method has
//! nothing to say.

use std::f64::consts::TAU;

use grazing_scenes::{
    Result,
    attractor::{
        detection::{Detection, Fate},
        dynamics::{Dynamics, Motion, Range, SectionState, Tangents},
    },
    motion::{RunEnd, Time},
};
use serde::{Deserialize, Serialize};

/// x goes round 1, 2, 3, 4; how far it is from these is multiplied by −9/10 each time round. Vectors are not
/// numbers.
struct Round;

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Place([f64; 1]);

impl SectionState for Place {
    fn plane(&self) -> [f64; 2] {
        [self.0[0], 0.0]
    }

    fn coordinates(&self) -> &[f64] {
        &self.0
    }
}

#[derive(Clone)]
struct Moving {
    x: f64,
    time: Time,
}

impl Motion for Moving {
    type Point = Place;

    const CHUNK: u64 = 1;

    fn time(&self) -> Time {
        self.time
    }

    fn impacts(&self) -> u64 {
        self.time.period.unsigned_abs()
    }

    fn point(&self) -> Place {
        Place([self.x])
    }

    fn pass(&mut self, until: Time) -> Result<RunEnd> {
        for _ in self.time.period..until.period {
            let whole = self.x.round();
            let off = self.x - whole;
            self.x = if whole < 4.0 { whole + 1.0 + off } else { 1.0 - 0.9 * off };
        }
        self.time = until;
        Ok(RunEnd::Reached)
    }

    fn pass_seen(&mut self, until: Time, seen: &mut Range) -> Result<RunEnd> {
        let end = self.pass(until)?;
        seen.widen(self.x);
        Ok(end)
    }
}

/// A motion with a vector that says nothing.
struct Blind(Moving);

impl Tangents for Blind {
    fn time(&self) -> Time {
        self.0.time
    }

    fn coordinates(&self) -> Vec<f64> {
        vec![self.0.x]
    }

    fn vectors(&self) -> Vec<Vec<f64>> {
        vec![vec![f64::NAN]]
    }

    fn impacts(&self) -> u64 {
        self.0.impacts()
    }

    fn grow(&mut self, goal: Time, _: &mut [f64]) -> Result<RunEnd> {
        self.0.pass(goal)
    }
}

impl Dynamics for Round {
    type Start = f64;
    type Point = Place;
    type Motion<'a> = Moving;
    type Tangents<'a> = Blind;

    fn dimension(&self) -> usize {
        1
    }

    fn begin(&self, start: &f64) -> Result<Moving> {
        Ok(Moving { x: *start, time: Time::new(0, 0.0) })
    }

    fn at(&self, coordinates: &[f64], _: f64) -> f64 {
        coordinates[0]
    }

    fn along(&self, motion: Moving) -> Blind {
        Blind(motion)
    }

    fn multipliers(_: &[Vec<f64>], _: Option<f64>) -> Option<Vec<(f64, f64)>> {
        None
    }

    fn in_plane(&self, at: [f64; 2], _: f64) -> f64 {
        at[0]
    }

    fn here(&self, motion: &Moving) -> f64 {
        motion.x
    }

    fn tangents(&self, motion: Moving, _: usize) -> Blind {
        Blind(motion)
    }
}

/// Off by e, −9e/10, 81e/100 … in each round, points are nearer to those of two rounds before than to those
/// of one: while the transient lasts they recur after 8, and not after 4.
#[test]
fn a_period_is_the_least_after_which_points_recur_in_the_end() {
    let off = 3e-7;
    let at = |rounds: u64| {
        let mut motion = Round.begin(&(1.0 + off)).unwrap();
        motion.pass(Time::new(4 * rounds as i64, TAU / 2.0)).unwrap();
        motion.x
    };
    let detection = Detection { transient: 0, ..Detection::default() };
    assert!((at(2) - at(0)).abs() < detection.tolerance && (at(1) - at(0)).abs() > 5.0 * detection.tolerance);
    let fate = detection.detect(&Round, &mut Round.begin(&(1.0 + off)).unwrap(), &()).unwrap();
    let Fate::Periodic(cycle) = fate else { panic!("{fate:?}") };
    assert_eq!((cycle.period(), cycle.impacts), (4, 4));
    assert!(cycle.exponents().is_empty(), "no vector told them");
}
