//! What each effect of an oscillator costs: added one at a time to a bare linear one, timed, its evaluations
//! counted.

use std::{
    sync::Arc,
    time::{Duration, Instant},
};

use crate::{
    error::Result,
    many::{self, Friction, Machine, NormalForce, SpeedLaw, Stop, StopLaw},
    motion::{Counts, Effect, EffectTally, Harmonic, SmoothForce, System, Time, Wall},
    one::simulate::{Settings, Simulator},
    scene::Scene,
};

/// An oscillator with one effect more than the bare one.
#[derive(Debug, Clone)]
pub struct WithEffect {
    /// What is added.
    pub name: &'static str,
    /// The system.
    pub system: System<f64>,
    /// The evaluations that it needs; all others must be counted 0 times.
    pub needs: &'static [Effect],
}

/// What an oscillator or a machine costs, with `N` kinds of evaluations.
#[derive(Debug, Clone)]
pub struct EffectCost<const N: usize> {
    /// What was added.
    pub name: &'static str,
    /// The mean time of a period at whose end the state is asked for.
    pub time: Duration,
    /// Impacts in the periods counted.
    pub impacts: u64,
    /// How many periods.
    pub periods: i64,
    /// Evaluations in these periods, in the order of [`Effect::ALL`] or, for a machine,
    /// [`Effect::OF_MACHINES`].
    pub counts: [u64; N],
}

/// Periods over which a full study counts evaluations.
pub const PERIODS: i64 = 1000;

const SPEED: f64 = 1.0 / 1.1;

/// A linear oscillator q″ = −q/1.21, and each effect added to it alone; from q = 0, u = 1/1.1 the bare one
/// moves between −1 and 1.
pub fn effects() -> Vec<WithEffect> {
    let bare = || System { stiffness: 1.0 / 1.21, ..System::default() };
    let harmonic = |k: u32, cos| Harmonic { k, cos, sin: 0.0 };
    let wall = |offset, amplitude| {
        let harmonics = if amplitude == 0.0 { vec![] } else { vec![harmonic(1, amplitude)] };
        Some(Wall { offset, harmonics, restitution: 1.0 })
    };
    use Effect::{Cubic, Drive, LowerGap, Piece, Search, Smooth, UpperGap};
    let formula = |text: &str| System { damping: 0.0, stiffness: 0.0, smooth: force(text), ..bare() };
    let with = |name, system, needs| WithEffect { name, system, needs };
    vec![
        with("bare", bare(), &[]),
        with("damping", System { damping: 0.01, ..bare() }, &[]),
        with("constant force", System { force: 0.1, ..bare() }, &[]),
        with("forcing", System { forcing: vec![harmonic(1, 0.1)], ..bare() }, &[]),
        with(
            "forcing, 3 harmonics",
            System { forcing: [1, 2, 3].map(|k| harmonic(k, 0.1)).to_vec(), ..bare() },
            &[],
        ),
        with("wall, far away", System { lower: wall(-20.0, 0.0), ..bare() }, &[Piece, LowerGap]),
        with("wall, hit", System { lower: wall(-0.5, 0.0), ..bare() }, &[Piece, LowerGap, Search]),
        with("upper wall, hit", System { upper: wall(0.5, 0.0), ..bare() }, &[Piece, UpperGap, Search]),
        with(
            "two walls, hit",
            System { lower: wall(-0.5, 0.0), upper: wall(0.5, 0.0), ..bare() },
            &[Piece, LowerGap, UpperGap, Search],
        ),
        with(
            "moving wall, hit",
            System { lower: wall(-0.6, 0.1), ..bare() },
            &[Piece, Drive, LowerGap, Search],
        ),
        with("cubic stiffness", System { cubic: 0.1, ..bare() }, &[Cubic]),
        with("cubic stiffness, as a formula", formula("-q/1.21 - 0.1*q^3"), &[Cubic]),
        // The cubic spring's parabola keeps it from being taken for one of the cubic key.
        with("cubic stiffness, by the graph", formula("-q/1.21 - 0.1*q^3 - 1e-30*q^2"), &[Smooth]),
        with("pendulum, as a formula", formula("-sin(q)/1.21"), &[Smooth]),
        with("pole, as a formula", formula("-q/1.21 + 0.01/(3 - q)^2"), &[Smooth]),
    ]
}

/// A machine with one effect more than the bare one.
#[derive(Debug, Clone)]
pub struct MachineWithEffect {
    /// What is added.
    pub name: &'static str,
    /// The machine.
    pub machine: Machine<f64>,
    /// The evaluations that it needs; all others must be counted 0 times.
    pub needs: &'static [Effect],
}

/// The oscillator of [`effects`] as a machine, and kinds of stops.
pub fn machine_effects() -> Vec<MachineWithEffect> {
    use Effect::{Force, Friction as Rubbing, Gap, Piece, Search, Smooth};
    let with = |name, stop: Option<(f64, f64, StopLaw<f64>)>, needs| {
        let made = |(offset, restitution, law)| {
            let wall = Wall { offset, harmonics: vec![], restitution };
            Stop { name: "stop".into(), row: vec![1.0], wall, law }
        };
        let machine = Machine {
            size: 1,
            period: std::f64::consts::TAU,
            mass: vec![(0, 0, 1.0)],
            damping: vec![],
            damping_ratio: vec![],
            stiffness: vec![(0, 0, 1.0 / 1.21)],
            shapes: vec![],
            force: vec![],
            forcing: vec![],
            smooth: vec![],
            record: None,
            friction: vec![],
            stops: stop.map(made).into_iter().collect(),
        };
        MachineWithEffect { name, machine, needs }
    };
    let soft = |damping| StopLaw::Soft { stiffness: 100.0, damping };
    // 1 at every speed, so that the motion goes on.
    let law = SpeedLaw { text: "(1+v)/(1+v)".into(), over: vec![1.0, 1.0], under: vec![1.0, 1.0] };
    let mut duffing = with("machine, cubic stiffness as a formula", None, &[Smooth]);
    duffing.machine.smooth = vec![force("-0.1*q^3 - 1e-30*q^2")];
    let rubbing = |name, speed, needs| {
        let mut rough: MachineWithEffect = with(name, None, needs);
        let (row, normal, harmonics) = (vec![1.0], NormalForce::Given(1.0), vec![]);
        let (coefficient, static_coefficient) = (0.1, 0.2);
        let name = "belt".into();
        let law = None;
        let belt = Friction { name, row, normal, coefficient, law, static_coefficient, speed, harmonics };
        rough.machine.friction = vec![belt];
        rough
    };
    vec![
        with("machine, bare", None, &[]),
        duffing,
        with("rigid stop, far away", Some((-20.0, 1.0, StopLaw::Newton)), &[Piece, Gap]),
        with("soft stop, far away", Some((-20.0, 0.0, soft(0.0))), &[Piece, Gap]),
        with("rigid stop, hit", Some((-0.5, 1.0, StopLaw::Newton)), &[Piece, Gap, Search]),
        with("restitution by the speed, hit", Some((-0.5, 0.0, StopLaw::Speed(law))), &[Piece, Gap, Search]),
        with("soft stop, hit", Some((-0.5, 0.0, soft(0.0))), &[Piece, Gap, Force, Search]),
        rubbing("dry friction, on a fast belt", 20.0, &[Piece, Rubbing]),
        rubbing("dry friction, stick and slip", 0.1, &[Piece, Rubbing, Search]),
    ]
}

impl MachineWithEffect {
    /// Evaluations in some periods, and the mean time of one, the least of `runs` runs.
    ///
    /// # Errors
    /// None for [`machine_effects`].
    pub fn measure(&self, periods: i64, runs: u32) -> Result<EffectCost<{ Effect::OF_MACHINES.len() }>> {
        let (counts, impacts) = self.count(periods)?;
        let simulator = many::simulate::Simulator::new(&self.machine, &many::simulate::Settings::default())?;
        let mut least = Duration::MAX;
        for _ in 0..runs {
            let mut run = simulator.start(Time::new(0, 0.0), &[0.0], &[SPEED])?;
            let start = Instant::now();
            for period in 1..=periods {
                std::hint::black_box(run.finish(Time::new(period, 0.0)));
                std::hint::black_box(run.state());
            }
            least = least.min(start.elapsed());
        }
        Ok(EffectCost { name: self.name, time: least / periods as u32, impacts, periods, counts })
    }

    /// The evaluations in some periods, and the impacts.
    ///
    /// # Errors
    /// None for [`machine_effects`].
    pub fn count(&self, periods: i64) -> Result<([u64; Effect::OF_MACHINES.len()], u64)> {
        let tally = Arc::new(EffectTally::default());
        let simulator = many::simulate::Simulator::new(&self.machine, &many::simulate::Settings::default())?
            .counting(tally.clone());
        let mut run = simulator.start(Time::new(0, 0.0), &[0.0], &[SPEED])?;
        for period in 1..=periods {
            run.finish(Time::new(period, 0.0));
        }
        let impacts = run.impacts();
        drop(run);
        Ok((Effect::OF_MACHINES.map(|effect| tally.of(effect)), impacts))
    }
}

/// A force from its formula.
fn force(text: &str) -> Option<SmoothForce<f64>> {
    let scene = format!("format = \"grazing-scene 1\"\ntitle = \"\"\n[system]\nforce = \"{text}\"\n");
    let scene = Scene::from_toml(&scene, "effects").ok()?;
    scene.plain(&[]).ok()?.smooth
}

impl WithEffect {
    /// The evaluations in some periods from q = 0, u = 1/1.1, and the impacts.
    ///
    /// # Errors
    /// None for [`effects`].
    pub fn count(&self, periods: i64) -> Result<(Counts, u64)> {
        let simulator = Simulator::new(&self.system, &Settings::default())?;
        let mut counts = Counts::default();
        let mut run = simulator.start_counting(Time::new(0, 0.0), 0.0, SPEED, &mut counts)?;
        for period in 1..=periods {
            run.finish(Time::new(period, 0.0));
        }
        let impacts = run.impacts();
        drop(run);
        Ok((counts, impacts))
    }

    /// The mean time of one of these periods, the least of `runs` runs.
    ///
    /// # Errors
    /// None for [`effects`].
    pub(crate) fn time(&self, periods: i64, runs: u32) -> Result<Duration> {
        let simulator = Simulator::new(&self.system, &Settings::default())?;
        let mut least = Duration::MAX;
        for _ in 0..runs {
            let mut run = simulator.start(Time::new(0, 0.0), 0.0, SPEED)?;
            let start = Instant::now();
            for period in 1..=periods {
                std::hint::black_box(run.finish(Time::new(period, 0.0)));
                std::hint::black_box(run.state());
            }
            least = least.min(start.elapsed());
        }
        Ok(least / periods as u32)
    }

    /// Both.
    ///
    /// # Errors
    /// None for [`effects`].
    pub fn measure(&self, periods: i64, runs: u32) -> Result<EffectCost<{ Effect::ALL.len() }>> {
        let (counts, impacts) = self.count(periods)?;
        let counts = Effect::ALL.map(|effect| counts.of(effect));
        Ok(EffectCost { name: self.name, time: self.time(periods, runs)?, impacts, periods, counts })
    }
}
