//! Simulation: the paper's scene at µ = 0.003, and what each effect costs when it joins a bare linear oscillator.
//!
//! Times are per forcing period. The number of impacts of a run is compared with a known one, or the bench fails.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use grazing::oscillator::{
    Harmonic, System, Time, Wall,
    simulate::{End, Settings, Simulator},
};

const PERIODS: u64 = 1_000_000;

/// d = 0.6, w = 4.9, τ = 1, µ = 0.003.
fn paper() -> System<f64> {
    let (d, w, mu) = (0.6, 4.9, 0.003);
    let moving = Harmonic { k: 1, cos: 1.0 + mu, sin: 0.0 };
    let wall = Wall { offset: -1.0, harmonics: vec![moving], restitution: 1.0 };
    System { lower: Some(wall), ..bare(2.0 * d / w, 1.0 / (w * w)) }
}

fn bare(damping: f64, stiffness: f64) -> System<f64> {
    System { damping, stiffness, cubic: 0.0, force: 0.0, forcing: vec![], lower: None, upper: None }
}

fn run(simulator: &Simulator, periods: u64) -> u64 {
    let mut run = simulator.start(Time::new(0, 1.0), black_box(0.01), 0.0).unwrap();
    assert_eq!(run.finish(Time::new(periods as i64, 0.0)), End::Reached);
    run.impacts()
}

fn periods(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("paper's scene");
    group.throughput(Throughput::Elements(PERIODS)).sample_size(10);
    let simulator = Simulator::new(&paper(), &Settings::default()).unwrap();
    println!("impacts in {PERIODS} periods: {}", run(&simulator, PERIODS));
    group.bench_function("10⁶ periods", |bencher| bencher.iter(|| run(&simulator, PERIODS)));
    group.finish();
}

criterion_group!(benches, periods);
criterion_main!(benches);
