//! Error against time of six motions: linear and Duffing's with a wall, near grazing, chatter, a steep
//! friction, ten modes.
//!
//! `simulations_reference.csv` says where each is after ten periods, to 40 digits: Taylor series in other
//! software, `benches/peers/motions_reference.py`, followed each twice. All coefficients are dyadic
//! fractions, so every program computes the same motion; `benches/peers/motions.py` has them for others. A
//! motion with another number of impacts is another motion: its error says nothing, and it is counted apart.

use std::{f64::consts::TAU, time::Duration};

use super::{
    computer::load,
    measure::{batches, quartiles},
};
use crate::{
    error::{Error, Result},
    many::{self, Load, Machine, Stop, StopLaw},
    motion::{Event, Harmonic, System, Time, Wall},
    one::simulate::{Settings, Simulator},
    scene::Scene,
};

/// A motion that starts at t = 0 at rest.
#[derive(Debug, Clone)]
pub struct KnownMotion {
    /// Its name in tables.
    pub(crate) name: &'static str,
    model: Model,
    start: f64,
    /// Impacts slower than this are not counted: where a motion chatters to rest there is no end of them.
    slowest: f64,
}

#[derive(Debug, Clone)]
enum Model {
    Oscillator(System<f64>),
    Machine(Machine<f64>),
}

/// One way to simulate one motion.
#[derive(Debug, Clone)]
pub struct SimulationPrice {
    /// The motion.
    pub name: &'static str,
    /// The integrator's tolerance; `None` for the closed form.
    pub tolerance: Option<f64>,
    /// The largest error of a displacement or velocity at the end.
    pub error: f64,
    /// Impacts that were counted, and how many there should have been.
    pub impacts: [i64; 2],
    /// Median, lower and upper quartile of the time of a period.
    pub time: [Duration; 3],
    /// The load of the machine.
    pub load: Option<f64>,
}

/// Periods 2π of a motion.
pub const PERIODS: i64 = 10;

/// A friction that turns round within a velocity of 1/64.
const FRICTION: &str =
    "format = \"grazing-scene 1\"\ntitle = \"friction\"\n[system]\nforce = \"-1/4*tanh(64*u)\"\n";

const REFERENCE: &str = include_str!("simulations_reference.csv");

/// Squares of the frequencies of the ten modes, in sixteenths: from 1.3² to 13².
const SQUARES: [f64; 10] = [27.0, 45.0, 75.0, 126.0, 209.0, 349.0, 583.0, 972.0, 1621.0, 2704.0];
/// Their damping, in 64ths: 4% of critical.
const DAMPING: [f64; 10] = [7.0, 9.0, 11.0, 14.0, 19.0, 24.0, 31.0, 40.0, 52.0, 67.0];

/// The six motions.
///
/// # Errors
/// None: the scene of the friction is part of the program, and a test reads it.
pub fn motions() -> Result<Vec<KnownMotion>> {
    let wall = |offset, restitution, cos: f64| {
        let harmonics = if cos == 0.0 { vec![] } else { vec![Harmonic { k: 1, cos, sin: 0.0 }] };
        Wall { offset, harmonics, restitution }
    };
    let system = |damping, stiffness, wall: Wall<f64>| System {
        damping,
        stiffness,
        lower: Some(wall),
        ..System::default()
    };
    let forced = |cos| vec![Harmonic { k: 1, cos, sin: 0.0 }];
    let rubbed = Scene::from_toml(FRICTION, "friction")?.plain(&[])?;
    let eighth = || system(0.125, 0.25, wall(-0.5, 0.75, 0.0));
    let alone =
        |name, system, start, slowest| KnownMotion { name, model: Model::Oscillator(system), start, slowest };
    let halves: Vec<f64> = (0..10).map(|i| (-0.5f64).powi(i)).collect();
    let entries = |all: [f64; 10], unit: f64| all.iter().enumerate().map(|(i, x)| (i, i, x / unit)).collect();
    let machine = Machine {
        size: 10,
        period: TAU,
        mass: (0..10).map(|i| (i, i, 1.0)).collect(),
        damping: entries(DAMPING, 64.0),
        damping_ratio: vec![],
        stiffness: entries(SQUARES, 16.0),
        shapes: vec![],
        force: vec![],
        forcing: vec![Load { k: 1, cos: halves.clone(), sin: vec![] }],
        smooth: vec![],
        record: None,
        friction: vec![],
        stops: vec![Stop {
            name: "stop".into(),
            row: halves,
            wall: wall(-0.5, 0.5, 0.0),
            law: StopLaw::Newton,
        }],
    };
    Ok(vec![
        alone("linear with wall", System { forcing: forced(1.0), ..eighth() }, 1.0, 0.0),
        alone("Duffing with wall", System { forcing: forced(0.5), cubic: 0.5, ..eighth() }, 1.0, 0.0),
        alone("near grazing", system(0.0, 1.0 - 1.0 / 64.0, wall(-1.0 + 1.0 / 2048.0, 1.0, 0.0)), 1.0, 0.0),
        alone("chatter", System { force: -1.0, ..system(0.125, 0.25, wall(0.0, 0.5, 2.0)) }, 3.0, 1.0 / 64.0),
        alone("steep friction", System { forcing: forced(1.0), smooth: rubbed.smooth, ..eighth() }, 1.0, 0.0),
        KnownMotion { name: "10 modes", model: Model::Machine(machine), start: 0.0, slowest: 0.0 },
    ])
}

impl KnownMotion {
    /// The number of impacts and the state at the end, q before u.
    ///
    /// # Errors
    /// None: the file is part of the program, and a test reads it.
    fn reference(&self) -> Result<(i64, Vec<f64>)> {
        let line = REFERENCE.lines().find(|line| line.split(',').next() == Some(self.name));
        let cells: Vec<&str> = line.unwrap_or_default().split(',').collect();
        let read = || {
            let [_, impacts, _, state] = cells[..] else { return None };
            let state: Option<Vec<f64>> = state.split(' ').map(|x| x.parse().ok()).collect();
            Some((impacts.parse().ok()?, state?))
        };
        read().ok_or_else(|| Error::input(format!("simulations_reference.csv: {} is not there", self.name)))
    }

    /// Whether it can be simulated in closed form.
    pub fn is_linear(&self) -> bool {
        !matches!(&self.model, Model::Oscillator(system) if system.cubic != 0.0 || system.smooth.is_some())
    }

    /// Whether it can be integrated with a tolerance.
    pub fn is_oscillator(&self) -> bool {
        matches!(self.model, Model::Oscillator(_))
    }

    /// Simulates in closed form, or by the integrator with a tolerance: `repeats` times three runs or, if
    /// they are short, batches of about `batch`.
    ///
    /// # Errors
    /// None for what [`is_linear`](Self::is_linear) and [`is_oscillator`](Self::is_oscillator) allow.
    pub fn measure(
        &self,
        tolerance: Option<f64>,
        repeats: usize,
        batch: Duration,
    ) -> Result<SimulationPrice> {
        let (impacts, state) = self.reference()?;
        let end = Time::new(PERIODS, 0.0);
        let load = load();
        let (found, counted, times) = match &self.model {
            Model::Oscillator(system) => {
                let mut settings = Settings { integrate: tolerance.is_some(), ..Settings::default() };
                settings.tolerance = tolerance.unwrap_or(settings.tolerance);
                let simulator = Simulator::new(system, &settings)?;
                let follow = || {
                    let mut run = simulator.start(Time::new(0, 0.0), self.start, 0.0)?;
                    let mut counted = 0;
                    run.record(end, |event| {
                        counted += i64::from(
                            matches!(event, Event::Impact(impact) if -impact.velocity > self.slowest),
                        );
                    });
                    let state = run.state();
                    Ok::<_, Error>((vec![state.q, state.u], counted))
                };
                let (found, counted) = follow()?;
                let times: Vec<Duration> = (0..repeats).flat_map(|_| batches(batch, follow)).collect();
                (found, counted, times)
            }
            Model::Machine(machine) => {
                let simulator =
                    many::simulate::Simulator::new(machine, &many::simulate::Settings::default())?;
                let rest = vec![0.0; machine.size];
                let start = vec![self.start; machine.size];
                let follow = || {
                    let mut run = simulator.start(Time::new(0, 0.0), &start, &rest)?;
                    let mut counted = 0;
                    run.record(end, |event| {
                        counted += i64::from(
                            matches!(event, Event::Impact(impact) if -impact.velocity > self.slowest),
                        );
                    });
                    let state = run.state();
                    Ok::<_, Error>((state.q.iter().chain(state.u.iter()).copied().collect(), counted))
                };
                let (found, counted): (Vec<f64>, i64) = follow()?;
                let times: Vec<Duration> = (0..repeats).flat_map(|_| batches(batch, follow)).collect();
                (found, counted, times)
            }
        };
        let pairs = found.iter().zip(&state);
        let error = pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        let time = quartiles(times).map(|time| time / PERIODS as u32);
        Ok(SimulationPrice { name: self.name, tolerance, error, impacts: [counted, impacts], time, load })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Closed forms and the integrator meet the other program's motions, and its impacts.
    #[test]
    fn motions_agree_with_another_programs() {
        for motion in motions().unwrap() {
            let ways = [motion.is_linear().then_some(None), motion.is_oscillator().then_some(Some(1e-13))];
            for tolerance in ways.into_iter().flatten() {
                let found = motion.measure(tolerance, 1, Duration::ZERO).unwrap();
                assert_eq!(found.impacts[0], found.impacts[1], "{found:?}");
                assert!(found.impacts[1] >= 10 && found.error < 1e-10, "{found:?}");
            }
            if motion.is_oscillator() {
                let rough = motion.measure(Some(1e-3), 1, Duration::ZERO).unwrap();
                assert!(rough.error > 1e-9, "{rough:?}");
            }
        }
    }
}
