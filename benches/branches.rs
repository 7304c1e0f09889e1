//! Continuation: time per point of the paper's period-4 branch, from µ = −0.05 through the saddle-node to its
//! grazing, and of an orbit of many impacts.
//!
//! A saddle-node or a grazing in the wrong place fails the bench. `benches/peers/branch.sh` times AUTO-07p on
//! the same branch.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use grazing_scenes::{
    attractor::detection::Detection,
    continuation::{Direction, Options},
    motion::{Side, State},
    one::{
        attractor::attracting,
        branch::{Branch, Orbits, Patterns},
        orbit::{Family, Itinerary, SingleImpact},
        simulate::Settings,
    },
    scene::{Scene, SceneFamily},
};

fn branches(criterion: &mut Criterion) {
    let text = include_str!("../examples/scenes/nordmark-2001.toml");
    let scene = Scene::from_toml(text, "nordmark-2001.toml").unwrap();
    let family = SceneFamily::new(&scene, "mu").unwrap();
    let mut group = criterion.benchmark_group("a point of a branch");
    group.sample_size(20);

    let oscillator = family.at(-0.05).unwrap();
    let exact = SingleImpact::new(oscillator.system(), Side::Lower, 4).unwrap();
    let (speed, range) = (exact.speeds()[0], (-0.1, 0.01));
    let patterns = Patterns::new(&family, -0.05).unwrap();
    let orbits = Orbits::over(&patterns, Itinerary::at(Side::Lower, &[4]).unwrap(), range);
    for most_step in [0.1f64, 1e-3] {
        let options = Options { step: most_step.min(0.01), most_step, points: 5000, ..Options::default() };
        let start = orbits.start(vec![exact.phase(speed), speed], -0.05, &options).unwrap();
        let follow = || Branch::follow(&orbits, black_box(&start), Direction::Backward, &options).unwrap();
        let found = follow();
        let at = |label: &str| found.labelled(label).unwrap().parameters[0];
        assert!((at("saddle-node 1") + 0.084_338_470_089_589_27).abs() < 1e-14);
        assert!((at("grazing 1") + 0.024_447_456_305_83).abs() < 1e-13);
        group.throughput(Throughput::Elements(found.points.len() as u64));
        group.bench_function(format!("period 4, steps up to {most_step}"), |bencher| bencher.iter(follow));
    }

    let detection = Detection { phase: 3.0, transient: 20_000, longest: 80, ..Detection::default() };
    let oscillator = family.at(-0.024_34).unwrap();
    let start = State { t: 3.0, q: 2.6, u: 0.31 };
    let orbit = attracting(&oscillator, start, &detection, &Settings::default(), &()).unwrap();
    let options = Options::default();
    let orbits = Orbits::over(&patterns, orbit.itinerary.clone(), (-0.0247, -0.0232));
    let start = orbits.start(orbit.z, -0.024_34, &options).unwrap();
    let follow = || Branch::follow(&orbits, black_box(&start), Direction::Both, &options).unwrap();
    let found = follow();
    assert!((found.labelled("grazing 1").unwrap().parameters[0] + 0.024_272_274_147_74).abs() < 1e-13);
    group.throughput(Throughput::Elements(found.points.len() as u64));
    group.bench_function("period 28 with 8 impacts", |bencher| bencher.iter(follow));
    group.finish();
}

criterion_group!(benches, branches);
criterion_main!(benches);
