//! What each effect of an oscillator costs: a thousand periods of a bare linear one, and of it with each
//! effect added; and of the same machine in a time of its own.

use criterion::{Criterion, criterion_group, criterion_main};
use grazing_scenes::{
    motion::Time,
    one::simulate::{Settings, Simulator},
    scene::Scene,
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

/// README's machine, which hits its stop once per period: in radians of the drive, and in seconds.
fn clocks(c: &mut Criterion) {
    let radians = "damping = 0.1\nstiffness = 0.3\nforcing = [{ cos = 0.7 }]\n";
    let seconds = "frequency = 4\ndamping = \"0.1*8*pi\"\nstiffness = \"0.3*(8*pi)^2\"\n\
                   forcing = [{ cos = \"0.7*(8*pi)^2\" }]\n";
    let simulators = [radians, seconds].map(|keys| {
        let text = format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\n[system]\n{keys}\
             [[stops]]\nside = \"upper\"\noffset = 1\nrestitution = 0.8\n"
        );
        let system = Scene::from_toml(&text, "clock.toml").unwrap().rounded().unwrap();
        Simulator::new(&system, &Settings::default()).unwrap()
    });
    let after = |simulator: &Simulator| {
        let mut run = simulator.start(Time::new(0, 0.0), 0.0, 0.0).unwrap();
        for period in 1..=PERIODS {
            run.finish(Time::new(period, 0.0));
        }
        run.state()
    };
    let [one, other] = simulators.each_ref().map(|simulator| after(simulator).q);
    assert!((one - other).abs() < 1e-9 && one.abs() > 1e-3, "{one} {other}");
    let mut group = c.benchmark_group("clocks/1000 periods");
    for (name, simulator) in ["2 pi", "frequency = 4"].iter().zip(&simulators) {
        group.bench_function(*name, |b| b.iter(|| after(simulator)));
    }
}

criterion_group!(benches, bench, clocks);
criterion_main!(benches);
