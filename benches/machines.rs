//! What following a machine costs: over the number of modes and (fastest mode) / forcing, in nanoseconds per
//! mode and quarter period of the fastest, beside evaluating all modes once in closed form. Prints a CSV
//! table; fails if a motion has no impact or leaves its bounds.

use std::{f64::consts::TAU, hint::black_box, time::Instant};

use grazing::{
    machine::{
        Load, Machine, RealVector, Stop, StopLaw,
        simulate::{MachineSettings, MachineSimulator},
    },
    oscillator::{Time, Wall},
};

/// Modes of frequencies from 1.3 to `ratio` times the forcing's, evenly spaced by logarithms, each 2% damped;
/// one stop that sees all of them.
fn machine(modes: usize, ratio: f64) -> Machine<f64> {
    let frequency = |i: usize| {
        let part = if modes == 1 { 1.0 } else { i as f64 / (modes - 1) as f64 };
        1.3 * (ratio / 1.3).powf(part)
    };
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
        stops: vec![Stop { name: "stop".into(), row: seen, wall, law: StopLaw::Newton }],
    }
}

fn main() {
    println!("modes,ratio,build_ms,impacts_per_period,ns_per_mode_quarter,ns_per_mode_evaluation");
    for modes in [1, 2, 10, 100, 200] {
        for ratio in [3.0, 30.0, 300.0, 1e5] {
            let machine = machine(modes, ratio);
            let clock = Instant::now();
            let simulator = MachineSimulator::new(&machine, &MachineSettings::default()).expect("a machine");
            let build = clock.elapsed().as_secs_f64() * 1e3;
            let periods = (2_000_000.0 / (ratio * modes as f64)).clamp(4.0, 5_000.0) as i64;
            let zero = vec![0.0; modes];
            let mut run = simulator.start(Time::new(0, 0.0), &zero, &zero).expect("a start");
            run.finish(Time::new(2, 0.0));
            let (before, clock) = (run.impacts(), Instant::now());
            run.finish(Time::new(2 + periods, 0.0));
            let spent = clock.elapsed().as_secs_f64() * 1e9;
            let impacts = run.impacts() - before;
            assert!(impacts > 0 && run.state().q.amax() < 10.0, "{modes} modes, {ratio}: {impacts} impacts");
            let quarters = 4.0 * ratio * periods as f64;
            let mut y = RealVector::from_element(2 * modes, 0.3);
            let (times, clock) = (200_000 / modes, Instant::now());
            for _ in 0..times {
                simulator.flow().advance(black_box(&mut y), black_box(1e-3));
            }
            let once = clock.elapsed().as_secs_f64() * 1e9 / times as f64 / modes as f64;
            println!(
                "{modes},{ratio},{build:.2},{:.2},{:.2},{once:.1}",
                impacts as f64 / periods as f64,
                spent / quarters / modes as f64
            );
        }
    }
}
