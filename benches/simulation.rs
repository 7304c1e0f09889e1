//! Simulation of the paper's scene at µ = 0.003 over 10⁶ forcing periods, on one core and on all; and what
//! such long runs lose.
//!
//! The number of impacts is compared with a known one, or the bench fails. (What each effect costs:
//! `effects`.)

use std::{f64::consts::TAU, hint::black_box, sync::Arc};

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use grazing_scenes::{
    attractor::section::section,
    motion::{Harmonic, RunEnd, System, Time, Wall, flow::Linear},
    one::simulate::{Event, Settings, Simulator, batch::Batch},
};
use rayon::prelude::*;

const PERIODS: u64 = 1_000_000;

/// The paper's scene, d = 0.6, w = 4.9, τ = 1.
fn paper(mu: f64) -> System<f64> {
    let (d, w) = (0.6, 4.9);
    let moving = Harmonic { k: 1, cos: 1.0 + mu, sin: 0.0 };
    let wall = Wall { offset: -1.0, harmonics: vec![moving], restitution: 1.0 };
    System { lower: Some(wall), ..bare(2.0 * d / w, 1.0 / (w * w)) }
}

fn bare(damping: f64, stiffness: f64) -> System<f64> {
    System { damping, stiffness, ..System::default() }
}

fn run(simulator: &Simulator, periods: u64) -> u64 {
    start(simulator, 0.01, periods)
}

fn start(simulator: &Simulator, q: f64, periods: u64) -> u64 {
    let mut run = simulator.start(Time::new(0, 1.0), black_box(q), 0.0).unwrap();
    assert_eq!(run.finish(Time::new(periods as i64, 0.0)), RunEnd::Reached);
    run.impacts()
}

fn periods(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("paper's scene");
    group.throughput(Throughput::Elements(PERIODS)).sample_size(10);
    let simulator = Simulator::new(&paper(0.003), &Settings::default()).unwrap();
    let impacts = run(&simulator, PERIODS);
    println!("impacts in {PERIODS} periods: {impacts}");
    // The orbit is chaotic, the mean is not.
    assert!(impacts.abs_diff(292_100) < 500, "{impacts} impacts, 292100 expected");
    group.bench_function("10⁶ periods", |bencher| {
        bencher.iter(|| assert_eq!(run(&simulator, PERIODS), impacts))
    });
    // As `grazing run` does for its reports.
    let counted = simulator.clone().counting(Arc::default());
    group.bench_function("10⁶ periods, effects counted", |bencher| {
        bencher.iter(|| assert_eq!(run(&counted, PERIODS), impacts))
    });
    group.bench_function("10⁵ periods from each of 64 starts, all cores", |bencher| {
        bencher.iter(|| {
            (0..64)
                .into_par_iter()
                .map(|i| start(&simulator, 0.01 + 0.001 * f64::from(i), PERIODS / 10))
                .sum::<u64>()
        });
    });
    group.finish();
}

/// How many motions are followed together, and for how long.
const MOTIONS: usize = 1024;
const TOGETHER: u64 = 1000;

/// Many motions together, of one system and of a system each; beside the scalar engine, motion by motion. The
/// impacts of all are compared, or the bench fails.
fn together(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("many motions");
    group.throughput(Throughput::Elements(MOTIONS as u64 * TOGETHER)).sample_size(10);
    let one = Simulator::new(&paper(0.003), &Settings::default()).unwrap();
    let each: Vec<Simulator> = (0..256)
        .map(|i| Simulator::new(&paper(0.002 + 1e-5 * f64::from(i)), &Settings::default()).unwrap())
        .collect();
    let q = |i: usize| 0.01 + 1e-4 * i as f64;
    let shared: Vec<(&Simulator, f64)> = (0..MOTIONS).map(|i| (&one, q(i))).collect();
    let own: Vec<(&Simulator, f64)> = (0..MOTIONS).map(|i| (&each[i % each.len()], 0.01)).collect();
    let begin = |motions: &[(&Simulator, f64)]| -> u64 {
        // What fits a core's cache.
        let followed = motions.chunks(256).map(|motions| {
            let runs = motions.iter().map(|&(simulator, q)| {
                (simulator, simulator.start(Time::new(0, 1.0), black_box(q), 0.0).unwrap())
            });
            let mut batch = Batch::new(0.0, runs.collect());
            (0..TOGETHER).for_each(|_| batch.pass());
            (0..motions.len()).map(|i| batch.impacts(i)).sum::<u64>()
        });
        followed.sum()
    };
    let scalar = |motions: &[(&Simulator, f64)]| -> u64 {
        motions.iter().map(|&(simulator, q)| start(simulator, q, TOGETHER)).sum()
    };
    for (name, motions) in [("of one system", &shared), ("of 256 systems", &own)] {
        let impacts = scalar(motions);
        group.bench_function(format!("one by one, {name}"), |bencher| {
            bencher.iter(|| assert_eq!(scalar(motions), impacts))
        });
        group.bench_function(format!("together, {name}"), |bencher| {
            bencher.iter(|| assert_eq!(begin(motions), impacts))
        });
    }
    group.finish();
}

/// What 10⁶ periods lose: printed, not timed.
fn long_runs(_: &mut Criterion) {
    let late = Time::new(PERIODS as i64, 0.0);
    // Period 3 of the paper's scene at µ = 0.0058, where it is stable.
    let stable = Simulator::new(&paper(0.0058), &Settings::default()).unwrap();
    let mut run = stable.start(Time::new(0, 1.0), 0.004, 0.0).unwrap();
    run.finish(late);
    let mut off = 0f64;
    run.record(late.after(20.0), |event| {
        if let Event::Impact(impact) = event {
            let (phase, velocity) = period_3(0.0058);
            off = off.max((impact.time.phase - phase).abs()).max((impact.velocity + velocity).abs());
        }
    });
    println!("distance from the exact orbit of period 3 after {PERIODS} periods: {off:.1e}");
    for (name, lower) in [("in one flight", None), ("beside a wall out of reach", paper(0.0).lower)] {
        let lower = lower.map(|wall| Wall { offset: -50.0, ..wall });
        let undamped = Simulator::new(&System { lower, ..bare(0.0, 1.3) }, &Settings::default()).unwrap();
        let mut run = undamped.start(Time::new(0, 0.0), 0.5, 0.3).unwrap();
        let energy = |q: f64, u: f64| u * u + 1.3 * q * q;
        section(&mut run, 0.0, PERIODS, |_| true).unwrap();
        let state = run.state();
        let lost = energy(state.q, state.u) / energy(0.5, 0.3) - 1.0;
        println!("energy after {PERIODS} periods {name}, relative error: {lost:.1e}");
    }
}

/// The exact orbit of period 3 with one impact: phase and velocity of the impact, τ = 1.
fn period_3(mu: f64) -> (f64, f64) {
    let flow = Linear::new(&paper(mu)).unwrap();
    let e = flow.matrix(3.0 * TAU);
    // p = (I − E)⁻¹ E (0, 2); then (1 + µ)² = (1 + p₁V)² + (1 + p₂)² V².
    let ([a, b], [c, d]) = ([1.0 - e[0][0], -e[0][1]], [-e[1][0], 1.0 - e[1][1]]);
    let (x, y, det) = (2.0 * e[0][1], 2.0 * e[1][1], a * d - b * c);
    let (p, r) = ((d * x - b * y) / det, 1.0 + (a * y - c * x) / det);
    // (p² + r²) V² + 2pV − µ(2 + µ) = 0, the root that is positive for small µ > 0.
    let (square, rest) = (p * p + r * r, mu * (2.0 + mu));
    let velocity = rest / (p + (p * p + square * rest).sqrt());
    ((-(r * velocity)).atan2(1.0 + p * velocity).rem_euclid(TAU), velocity)
}

criterion_group!(benches, periods, together, long_runs);
criterion_main!(benches);
