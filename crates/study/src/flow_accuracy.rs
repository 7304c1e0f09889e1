//! What accuracy costs in a simulation: error against time, for the closed form and for the integrator at
//! each tolerance.
//!
//! The oscillators are conservative and so tuned that their exact motion returns to its start after every
//! forcing period: the error is the distance from the start, with no other computation as reference. One has
//! no wall, one hits it hard, one nearly grazes it: there an error of ε in the gap becomes one of ε over the
//! impact velocity in time.

use std::{
    f64::consts::PI,
    time::{Duration, Instant},
};

use crate::{
    error::Result,
    motion::{Harmonic, System, Time, Wall},
    one::{
        orbit::{Itinerary, Oscillator, find},
        simulate::{Settings, Simulator},
    },
    scene::Scene,
};

/// An oscillator whose motion from q = 1, u = 0 has period 2π.
#[derive(Debug, Clone)]
pub struct Returning {
    /// What it does.
    pub name: &'static str,
    /// The system.
    pub system: System<f64>,
    /// Impacts in a period.
    pub impacts: u64,
}

/// One way to simulate one oscillator.
#[derive(Debug, Clone)]
pub struct FlowMeasured {
    /// The oscillator.
    pub name: &'static str,
    /// The integrator's tolerance; none for the closed form.
    pub tolerance: Option<f64>,
    /// The mean time of a period.
    pub time: Duration,
    /// |q − 1| + |u| after [`RETURNS`] periods, at most.
    pub error: f64,
    /// The relative error of the energy then, for oscillators that keep it.
    pub energy: Option<f64>,
}

/// Distance from an exact motion after many periods.
#[derive(Debug, Clone)]
pub struct LongRun {
    /// The motion.
    pub name: &'static str,
    /// How many forcing periods have passed.
    pub periods: i64,
    /// |q − exact| + |u − exact|.
    pub distance: f64,
    /// The relative error of the energy, where it is kept.
    pub energy: Option<f64>,
}

/// Periods after which the error is taken.
pub const RETURNS: i64 = 10;

/// The tolerances measured: 10⁻³ to 10⁻¹³.
pub fn tolerances() -> Vec<f64> {
    ["1e-3", "1e-4", "1e-5", "1e-6", "1e-7", "1e-8", "1e-9", "1e-10", "1e-11", "1e-12", "1e-13"]
        .iter()
        .filter_map(|text| text.parse().ok())
        .collect()
}

/// The oscillators: q″ = −ω² q (+ forcing), a wall at −cos φ with ω = 1 − φ/π, so that the wall is met at t =
/// π, at speed ω sin φ.
pub fn returning() -> Vec<Returning> {
    let system = |omega: f64, wall: Option<f64>| System {
        stiffness: omega * omega,
        lower: wall.map(|offset| Wall { offset, harmonics: vec![], restitution: 1.0 }),
        ..System::default()
    };
    let walled = |name, part: f64| Returning {
        name,
        system: system(1.0 - part, Some(-(PI * part).cos())),
        impacts: 1,
    };
    let forced = System { forcing: vec![Harmonic { k: 2, cos: 1.0, sin: 0.0 }], ..system(1.0, None) };
    vec![
        Returning { name: "no wall", system: forced, impacts: 0 },
        walled("impacts, speed 0.7", 0.25),
        walled("near grazing, speed 3e-2", 0.01),
        walled("near grazing, speed 3e-4", 0.0001),
    ]
}

impl Returning {
    fn energy(&self, q: f64, u: f64) -> Option<f64> {
        self.system.forcing.is_empty().then(|| (u * u / self.system.stiffness + q * q - 1.0).abs())
    }

    /// Simulates in closed form, or by the integrator with a tolerance.
    ///
    /// # Errors
    /// None for [`returning`] and [`tolerances`].
    pub fn measure(&self, tolerance: Option<f64>) -> Result<FlowMeasured> {
        let settings = Settings {
            integrate: tolerance.is_some(),
            tolerance: tolerance.unwrap_or(1e-13),
            ..Settings::default()
        };
        let simulator = Simulator::new(&self.system, &settings)?;
        let (mut error, mut energy) = (0.0f64, None);
        let mut least = Duration::MAX;
        for _ in 0..20 {
            let start = Instant::now();
            let mut run = simulator.start(Time::new(0, 0.0), 1.0, 0.0)?;
            for period in 1..=RETURNS {
                run.finish(Time::new(period, 0.0));
            }
            least = least.min(start.elapsed());
            let end = run.state();
            error = (end.q - 1.0).abs() + end.u.abs();
            energy = self.energy(end.q, end.u);
        }
        Ok(FlowMeasured { name: self.name, tolerance, time: least / RETURNS as u32, error, energy })
    }
}

/// Runs of up to 10^`decades` periods: the conservative oscillators, and the paper's at µ = −0.05 on its
/// stable orbit of period 4, whose exact place is Newton's solution of the pattern equations. A row a power
/// of ten.
///
/// # Errors
/// None expected.
pub fn long_runs(decades: u32) -> Result<Vec<LongRun>> {
    let mut rows = Vec::new();
    let powers = || (0..=decades).map(|power| 10i64.pow(power));
    for case in returning() {
        let simulator = Simulator::new(&case.system, &Settings::default())?;
        let mut run = simulator.start(Time::new(0, 0.0), 1.0, 0.0)?;
        for periods in powers() {
            // A state a period, as a section takes it.
            while run.time().period < periods {
                run.finish(Time::new(run.time().period + 1, 0.0));
            }
            let end = run.state();
            let distance = (end.q - 1.0).abs() + end.u.abs();
            rows.push(LongRun { name: case.name, periods, distance, energy: case.energy(end.q, end.u) });
        }
    }
    let system = Scene::from_toml(super::PAPER, "nordmark-2001.toml")?.plain(&[("mu", -0.05)])?;
    let oscillator = Oscillator::new(system.clone(), 1e-13)?;
    let pattern = Itinerary::at(crate::motion::Side::Lower, &[4])?;
    let orbits = crate::one::orbit::search(&oscillator, &pattern, 200, 2.0);
    if let Some(orbit) = orbits.into_iter().find(|orbit| orbit.multipliers.is_stable()) {
        let orbit = find(&oscillator, &pattern, orbit.z)?;
        let exact = |period: i64| orbit.state(&oscillator, PI + 2.0 * PI * (period % 4) as f64);
        let simulator = Simulator::new(&system, &Settings::default())?;
        let start = exact(0)?;
        let mut run = simulator.start(Time::new(0, PI), start.q, start.u)?;
        for periods in powers() {
            while run.time().period < periods {
                run.finish(Time::new(run.time().period + 1, PI));
            }
            let (end, exact) = (run.state(), exact(periods)?);
            let distance = (end.q - exact.q).abs() + (end.u - exact.u).abs();
            rows.push(LongRun { name: "section 4.2, stable period 4", periods, distance, energy: None });
        }
    }
    Ok(rows)
}
