//! What following a machine costs, in nanoseconds of the time that the thread computes. Prints two CSV
//! tables; fails if a motion has no impact, or one where none should be, or leaves its bounds.
//!
//! The first is over the number of modes and (fastest mode) / forcing: per mode and quarter period of the
//! fastest; per mode and quarter period of that mode where the gap stays just open; per mode and impact, what
//! is left of the former; per mode, evaluating all modes once in closed form. The second is for chains of
//! masses with dampers of unlike sizes, which no real modes tell apart: how they are solved, how well
//! conditioned, how fast.

use std::{f64::consts::TAU, hint::black_box, time::Duration};

use grazing_scenes::{
    many::{
        Load, Machine, State, Stop, StopLaw,
        simulate::{Settings, Simulator},
    },
    motion::{Time, Wall},
};
use nalgebra::DVector;

/// The time that this thread has computed: what else runs on the machine is not counted.
struct Clock(Duration);

impl Clock {
    #[cfg(unix)]
    fn read() -> Duration {
        let now = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
        Duration::new(now.tv_sec as u64, now.tv_nsec as u32)
    }

    #[cfg(not(unix))]
    fn read() -> Duration {
        std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).unwrap_or_default()
    }

    fn now() -> Clock {
        Clock(Clock::read())
    }

    fn elapsed(&self) -> Duration {
        Clock::read() - self.0
    }
}

/// The i-th frequency, in those of the forcing.
fn frequency(modes: usize, ratio: f64, i: usize) -> f64 {
    let part = if modes == 1 { 1.0 } else { i as f64 / (modes - 1) as f64 };
    1.3 * (ratio / 1.3).powf(part)
}

/// Modes of frequencies from 1.3 to `ratio` times the forcing's, evenly spaced by logarithms, each 2% damped;
/// one stop that sees all of them.
fn machine(modes: usize, ratio: f64) -> Machine<f64> {
    let frequency = |i: usize| frequency(modes, ratio, i);
    let seen: Vec<f64> = (0..modes).map(|i| if i % 2 == 0 { 1.0 } else { -1.0 }).collect();
    let wall = Wall { offset: -0.4 / frequency(0).powi(2), harmonics: vec![], restitution: 0.7 };
    Machine {
        size: modes,
        period: TAU,
        mass: (0..modes).map(|i| (i, i, 1.0)).collect(),
        damping: (0..modes).map(|i| (i, i, 0.04 * frequency(i))).collect(),
        damping_ratio: vec![],
        stiffness: (0..modes).map(|i| (i, i, frequency(i).powi(2))).collect(),
        shapes: vec![],
        force: vec![],
        forcing: vec![Load { k: 1, cos: seen.clone(), sin: vec![] }],
        smooth: vec![],
        record: None,
        friction: vec![],
        stops: vec![Stop { name: "stop".into(), row: seen, wall, law: StopLaw::Newton }],
    }
}

/// A chain of masses of 1 to 2 between springs, a damper between any two neighbours, of a size of its own;
/// every seventh pair is coupled by a gyroscopic force where `gyroscopic`. The last mass is forced and meets
/// the stop.
fn chain(masses: usize, gyroscopic: bool) -> Machine<f64> {
    // Numbers in [0, 1), spread evenly.
    let part = |i: usize, step: f64| (i as f64 * step).fract();
    let (mut damping, mut stiffness) = (Vec::new(), Vec::new());
    for i in 0..masses {
        let spring = (masses * masses) as f64 * (0.5 + part(i, 0.618_033_988_7));
        let damper = 0.02 * masses as f64 * part(i, 0.414_213_562_4).powi(2);
        for (all, x) in [(&mut damping, damper), (&mut stiffness, spring)] {
            all.push((i, i, x));
            if i > 0 {
                all.extend([(i - 1, i - 1, x), (i, i - 1, -x), (i - 1, i, -x)]);
            }
        }
        if gyroscopic && i % 7 == 6 {
            damping.extend([(i, i - 3, 0.5), (i - 3, i, -0.5)]);
        }
    }
    let at_end = |x: f64| (0..masses).map(|i| if i + 1 == masses { x } else { 0.0 }).collect::<Vec<_>>();
    let wall = Wall { offset: -0.01, harmonics: vec![], restitution: 0.7 };
    Machine {
        size: masses,
        period: TAU,
        mass: (0..masses).map(|i| (i, i, 1.0 + part(i, 0.732_050_807_6))).collect(),
        damping,
        damping_ratio: vec![],
        stiffness,
        shapes: vec![],
        force: vec![],
        forcing: vec![Load { k: 1, cos: at_end(masses as f64), sin: vec![] }],
        smooth: vec![],
        record: None,
        friction: vec![],
        stops: vec![Stop { name: "stop".into(), row: at_end(1.0), wall, law: StopLaw::Newton }],
    }
}

fn chains() {
    println!("masses,gyroscopic,method,condition,fastest,build_s,impacts_per_period,ns_per_mode_quarter");
    for (masses, gyroscopic) in
        [(10, false), (50, false), (100, false), (100, true), (200, false), (200, true)]
    {
        let machine = chain(masses, gyroscopic);
        let clock = Clock::now();
        let simulator = Simulator::new(&machine, &Settings::default()).expect("a machine");
        let build = clock.elapsed().as_secs_f64();
        let flow = simulator.flow();
        let fastest = flow.rates().into_iter().fold(0.0, f64::max);
        let (zero, periods) = (vec![0.0; masses], 20);
        let mut run = simulator.start(Time::new(0, 0.0), &zero, &zero).expect("a start");
        run.finish(Time::new(2, 0.0));
        let (before, clock) = (run.impacts(), Clock::now());
        run.finish(Time::new(2 + periods, 0.0));
        let spent = clock.elapsed().as_secs_f64() * 1e9;
        let impacts = (run.impacts() - before) as f64 / periods as f64;
        assert!(
            impacts > 0.0 && run.state().q().iter().all(|q| q.abs() < 10.0),
            "{masses} masses: {impacts} impacts"
        );
        println!(
            "{masses},{gyroscopic},{},{:.1},{fastest:.0},{build:.2},{impacts:.2},{:.2}",
            flow.method().name(),
            flow.condition(),
            spent / (4.0 * fastest * periods as f64) / masses as f64
        );
    }
}

fn main() {
    modes();
    chains();
}

/// The machine without damping, its stop a little further away than it comes from rest in these periods.
fn open(modes: usize, ratio: f64, periods: usize) -> Machine<f64> {
    let mut machine = machine(modes, ratio);
    machine.damping.clear();
    machine.stops[0].wall.offset = -1e3;
    let simulator = Simulator::new(&machine, &Settings::default()).expect("a machine");
    let flow = simulator.flow();
    let zero = DVector::zeros(modes);
    let row = DVector::from_column_slice(&machine.stops[0].row);
    let seen = flow.seen(&row, &zero);
    let mut y = flow.split(&State::new(0.0, zero.as_slice(), zero.as_slice()));
    let looks = (24.0 * ratio).min(2e5 / modes as f64).ceil() as usize;
    let width = TAU / looks as f64;
    let mut least = 0.0f64;
    for look in 0..periods * looks {
        least = least.min(seen.dot(&(&y + flow.particular(width * (look % looks) as f64))));
        flow.advance(&mut y, width);
    }
    machine.stops[0].wall.offset = 1.02 * least;
    machine
}

fn modes() {
    println!(
        "modes,ratio,build_ms,impacts_per_period,ns_per_mode_quarter,ns_per_mode_own_quarter_open,ns_per_mode_impact,ns_per_mode_evaluation"
    );
    for modes in [1, 2, 10, 100, 200] {
        for ratio in [3.0, 30.0, 300.0, 1e5] {
            let machine = machine(modes, ratio);
            let clock = Clock::now();
            let simulator = Simulator::new(&machine, &Settings::default()).expect("a machine");
            let build = clock.elapsed().as_secs_f64() * 1e3;
            // After some periods, in which motions of rest on the stop are solved, too.
            let follow = |machine: &Machine<f64>, before: i64, periods: i64| {
                let simulator = Simulator::new(machine, &Settings::default()).expect("a machine");
                let zero = vec![0.0; modes];
                let mut run = simulator.start(Time::new(0, 0.0), &zero, &zero).expect("a start");
                run.finish(Time::new(before, 0.0));
                let (known, clock) = (run.impacts(), Clock::now());
                run.finish(Time::new(before + periods, 0.0));
                let spent = clock.elapsed().as_secs_f64() * 1e9;
                assert!(run.state().q().iter().all(|q| q.abs() < 10.0), "{modes} modes, {ratio}");
                (spent, run.impacts() - known)
            };
            let periods = (2_000_000.0 / (ratio * modes as f64)).clamp(4.0, 5_000.0);
            let (spent, impacts) = follow(&machine, 2, periods as i64);
            assert!(impacts > 0, "{modes} modes, {ratio}: no impact");
            // Few periods, of which all are seen beforehand.
            let few = periods.min(40.0);
            let (flown, none) = follow(&open(modes, ratio, few as usize), 0, few as i64);
            assert_eq!(none, 0, "{modes} modes, {ratio}");
            let quarters: f64 = (0..modes).map(|i| 4.0 * frequency(modes, ratio, i)).sum();
            let per_period = flown / few;
            let mut y = DVector::from_element(2 * modes, 0.3);
            let (times, clock) = (200_000 / modes, Clock::now());
            for _ in 0..times {
                simulator.flow().advance(black_box(&mut y), black_box(1e-3));
            }
            let once = clock.elapsed().as_secs_f64() * 1e9 / times as f64 / modes as f64;
            println!(
                "{modes},{ratio},{build:.2},{:.2},{:.2},{:.2},{:.0},{once:.1}",
                impacts as f64 / periods,
                spent / periods / (4.0 * ratio) / modes as f64,
                per_period / quarters,
                (spent - periods * per_period).max(0.0) / impacts as f64 / modes as f64
            );
        }
    }
}
