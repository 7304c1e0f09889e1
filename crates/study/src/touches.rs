//! Machines with one stop, each followed beside its touch: what is seen, for the picture that tells it from
//! what is born.

use std::f64::consts::{PI, TAU};

use crate::{
    attractor::{
        diagram::Look,
        touch::{Beside, Touch, beside},
    },
    error::Result,
    monitor::Monitor,
    motion::{Harmonic, State, System, Wall},
    one::simulate::{Settings, Simulator},
};

/// A machine beside its touch.
#[derive(Debug, Clone, PartialEq)]
pub struct TouchSample {
    /// The frequency of its free vibration, over that of the drive; below 1.
    pub ratio: f64,
    /// What is left of a free vibration after a period of the drive.
    pub remains: f64,
    /// Whether it is just before the touch, or just beyond it.
    pub before: bool,
    /// Whether the motion stays near the one that touches.
    pub near: bool,
    /// What it comes to, in words; none if it leaves every bound.
    pub motion: Option<String>,
    /// The least and the greatest displacement there, the stop being at 1 and the free motion going to −1.
    pub extent: Option<[f64; 2]>,
}

/// Of every machine of the samples.
pub const RESTITUTION: f64 = 0.8;

/// The samples: 0.04, 0.14, …, 0.94 across, and 0.15, 0.35, 0.55, 0.88 up. Cost: some 50,000 periods.
///
/// # Errors
/// Those of the simulator; the monitor's.
pub fn touch_samples(monitor: &dyn Monitor) -> Result<Vec<TouchSample>> {
    let mut all = Vec::new();
    for remains in [0.15, 0.35, 0.55, 0.88] {
        for column in 0..10 {
            all.extend(sample(0.04 + 0.1 * f64::from(column), remains, monitor)?);
            monitor.advance(1)?;
        }
    }
    Ok(all)
}

/// q″ + cq′ + kq = F cos t below a stop at 1: its free motion is F/|k − 1 + ic| cos(t − arg(k − 1 + ic)).
fn sample(ratio: f64, remains: f64, monitor: &dyn Monitor) -> Result<[TouchSample; 2]> {
    let damping = -remains.ln() / PI;
    let stiffness = ratio * ratio + damping * damping / 4.0;
    let (amplitude, phase) = ((stiffness - 1.0).hypot(damping), damping.atan2(stiffness - 1.0));
    let far = (phase + PI).rem_euclid(TAU);
    let touch = Touch {
        parameter: amplitude,
        e: -1.0 / amplitude,
        start: State { t: far, q: -1.0, u: 0.0 },
        rest: None,
        others: Vec::new(),
        periods: 1,
        slowest: remains,
        width: 1.0,
    };
    let dynamics = |force| {
        let system = System {
            rate: None,
            damping,
            stiffness,
            cubic: 0.0,
            force: 0.0,
            forcing: vec![Harmonic { k: 1, cos: force, sin: 0.0 }],
            smooth: None,
            lower: None,
            upper: Some(Wall { offset: 1.0, harmonics: Vec::new(), restitution: RESTITUTION }),
        };
        Simulator::new(&system, &Settings::default())
    };
    let look = Look { phase: far, transient: 500, points: 64, longest: 64 };
    let seen = beside(&touch, &look, dynamics, monitor)?;
    let mut before = true;
    Ok(seen.map(|Beside { settled, near, .. }| {
        let portrait = settled.as_ref().map(|settled| &settled.portrait);
        TouchSample {
            ratio,
            remains,
            before: std::mem::replace(&mut before, false),
            near,
            motion: portrait.map(|portrait| portrait.words()),
            extent: portrait.map(|portrait| portrait.range.extent),
        }
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// README's machine, whose numbers are tested with its scene.
    #[test]
    fn a_machine_jumps_and_a_strongly_damped_one_stays() {
        let [before, beyond] = sample(0.297_5_f64.sqrt(), (-0.1 * PI).exp(), &()).unwrap();
        assert!(before.before && before.near && !beyond.before && !beyond.near);
        let [low, high] = beyond.extent.unwrap();
        assert!((-6.63..-6.60).contains(&low) && (high - 1.0).abs() < 1e-9, "{beyond:?}");
        let [_, beyond] = sample(0.05, 0.1, &()).unwrap();
        assert!(beyond.near, "{beyond:?}");
    }
}
