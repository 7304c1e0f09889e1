//! What each effect of an oscillator costs: a thousand periods of a bare linear one, and of it with each
//! effect added.

use criterion::{Criterion, criterion_group, criterion_main};
use grazing_scenes::{
    motion::Time,
    one::simulate::{Settings, Simulator},
};
use grazing_study::effects::{PERIODS, effects};

fn bench(c: &mut Criterion) {
    let mut group = c.benchmark_group("effects/1000 periods");
    for effect in effects() {
        // A benchmark of an effect that is evaluated where it is not needed, or not where it is, measures
        // nothing.
        let (counts, _) = effect.count(PERIODS).unwrap();
        assert!(effect.needs.iter().all(|&needed| counts.of(needed) > 0), "{}", effect.name);
        let simulator = Simulator::new(&effect.system, &Settings::default()).unwrap();
        group.bench_function(effect.name, |b| {
            b.iter(|| {
                let mut run = simulator.start(Time::new(0, 0.0), 0.0, 1.0 / 1.1).unwrap();
                for period in 1..=PERIODS {
                    run.finish(Time::new(period, 0.0));
                }
                run.state()
            });
        });
    }
}

criterion_group!(benches, bench);
criterion_main!(benches);
