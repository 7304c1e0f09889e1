//! Machines against 50-digit values, against the one-degree engine, against a second integrator that shares
//! no code with `src`, and where the answer is known.

use crate::samples::{one_in, samples};
use std::{
    f64::consts::{PI, TAU},
    fs,
    path::Path,
};

use grazing_scenes::{
    many::{
        FlowMethod, Load, Machine, State, Stop, StopLaw,
        simulate::{Event, Settings, Simulator},
    },
    motion::{Harmonic, RunEnd, System, Time, Wall},
    one::simulate as alone,
    scene::Scene,
};

mod attractors;
mod chatter;
mod formulas;
mod friction;
mod kinks;
mod recorded;
pub mod second;
mod soft;
mod steep;
mod stiff;
mod thresholds;

/// How far two vectors are apart, at most.
pub fn apart(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn rows(rows: &[Vec<f64>]) -> Vec<&[f64]> {
    rows.iter().map(Vec::as_slice).collect()
}

/// A machine whose period is 2π.
fn machine(mass: &[&[f64]], damping: &[&[f64]], stiffness: &[&[f64]]) -> Machine<f64> {
    let entries = |rows: &[&[f64]]| {
        let one = |(i, row): (usize, &&[f64])| {
            row.iter().enumerate().map(move |(j, x)| (i, j, *x)).collect::<Vec<_>>()
        };
        rows.iter().enumerate().flat_map(one).collect()
    };
    Machine {
        size: mass.len(),
        period: TAU,
        mass: entries(mass),
        damping: entries(damping),
        damping_ratio: vec![],
        stiffness: entries(stiffness),
        shapes: vec![],
        force: vec![],
        forcing: vec![],
        smooth: vec![],
        record: None,
        friction: vec![],
        stops: vec![],
    }
}

fn stop(row: &[f64], offset: f64, restitution: f64) -> Stop<f64> {
    let wall = Wall { offset, harmonics: vec![], restitution };
    Stop { name: format!("{row:?} {offset}"), row: row.to_vec(), wall, law: StopLaw::Newton }
}

fn simulator(machine: &Machine<f64>) -> Simulator {
    Simulator::new(machine, &Settings::default()).unwrap()
}

fn at(t: f64) -> Time {
    Time::new(0, t)
}

/// The events up to a time.
fn events(simulator: &Simulator, start: (Time, &[f64], &[f64]), until: Time) -> Vec<Event> {
    let mut all = Vec::new();
    let mut run = simulator.start(start.0, start.1, start.2).unwrap();
    assert_eq!(run.record(until, |event| all.push(event)), RunEnd::Reached);
    all
}

#[derive(serde::Deserialize)]
struct Table {
    durations: Vec<f64>,
    cases: Vec<Case>,
}

#[derive(serde::Deserialize)]
struct Case {
    name: String,
    mass: Vec<Vec<f64>>,
    damping: Vec<Vec<f64>>,
    stiffness: Vec<Vec<f64>>,
    /// Φ, if forces and states are at points of the machine; the start is of the modes.
    #[serde(default)]
    shapes: Vec<Vec<f64>>,
    force: Vec<f64>,
    loads: Vec<Given>,
    t0: f64,
    q: Vec<f64>,
    u: Vec<f64>,
    states: Vec<Vec<String>>,
}

#[derive(serde::Deserialize)]
struct Given {
    k: u32,
    cos: Vec<f64>,
    sin: Vec<f64>,
}

/// Repeated, overdamped, defective, rigid-body, gyroscopic, circulatory, resonant, stiff, modal: by whatever
/// method, to 2·10⁻¹³ of the largest entry, times the condition number where there are complex modes.
#[test]
fn motions_without_stops_agree_with_fifty_digits() {
    let table: Table = toml::from_str(include_str!("../data/machines.toml")).unwrap();
    let mut methods = [0; 3];
    for case in &table.cases {
        let mut machine = machine(&rows(&case.mass), &rows(&case.damping), &rows(&case.stiffness));
        machine.force = case.force.clone();
        machine.shapes = case.shapes.clone();
        let load = |given: &Given| Load { k: given.k, cos: given.cos.clone(), sin: given.sin.clone() };
        machine.forcing = case.loads.iter().map(load).collect();
        let simulator = simulator(&machine);
        let flow = simulator.flow();
        methods[flow.method() as usize] += 1;
        let condition = if flow.condition().is_finite() { flow.condition().min(1e4) } else { 1.0 };
        for (duration, expected) in table.durations.iter().zip(&case.states) {
            let expected: Vec<f64> = expected.iter().map(|x| x.parse().unwrap()).collect();
            let size = expected.iter().fold(1.0f64, |most, x| most.max(x.abs()));
            let start = State::new(case.t0, &case.q, &case.u);
            let end = flow.after(&start, *duration);
            let mut run = simulator.start(at(case.t0), &case.q, &case.u).unwrap();
            run.finish(at(case.t0).after(*duration));
            for (how, state) in [("at once", end), ("by the run", run.state())] {
                let (q, u) = (machine.displaced(state.q()), machine.displaced(state.u()));
                let found = q.iter().chain(&u);
                assert_eq!(q.len() + u.len(), expected.len(), "{}", case.name);
                let off = found.zip(&expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                let fastest = flow.rates().iter().fold(1.0f64, |most, rate| most.max(*rate));
                let bound = 2e-15 * size * condition * (10.0 + fastest * duration);
                let name = flow.method().name();
                assert!(
                    off <= bound,
                    "{}: {how}, {name}, after {duration}: {off:e} of {size:e}, bound {bound:e}",
                    case.name
                );
            }
        }
    }
    assert!(methods.iter().all(|count| *count >= 2), "{methods:?}");
}

#[test]
fn the_method_is_as_the_eigenvectors_are() {
    let table: Table = toml::from_str(include_str!("../data/machines.toml")).unwrap();
    for (name, method) in [
        ("repeated", FlowMethod::RealModes),
        ("repeated rotated", FlowMethod::RealModes),
        ("critical", FlowMethod::RealModes),
        ("overdamped", FlowMethod::ComplexModes),
        ("rigid body", FlowMethod::RealModes),
        ("defective", FlowMethod::Exponential),
        ("rigid body, defective", FlowMethod::Exponential),
        ("defective, threefold", FlowMethod::Exponential),
        ("defective, oscillating", FlowMethod::Exponential),
        ("defective, damped", FlowMethod::Exponential),
        ("flutter", FlowMethod::ComplexModes),
        ("three, oscillating and overdamped", FlowMethod::ComplexModes),
        ("two spirals at resonance", FlowMethod::ComplexModes),
        ("shapes, two points of three modes", FlowMethod::RealModes),
        ("gyroscopic", FlowMethod::ComplexModes),
        ("circulatory", FlowMethod::ComplexModes),
        ("five, not classical", FlowMethod::ComplexModes),
    ] {
        let case = table.cases.iter().find(|case| case.name == name).unwrap();
        let machine = machine(&rows(&case.mass), &rows(&case.damping), &rows(&case.stiffness));
        let found = simulator(&machine);
        assert_eq!(found.flow().method(), method, "{name}: condition {:e}", found.flow().condition());
    }
}

/// One degree of freedom as a 1 × 1 machine of mass 2.
fn as_machine(system: &System<f64>) -> Machine<f64> {
    let mut all = machine(&[&[2.0]], &[&[2.0 * system.damping]], &[&[2.0 * system.stiffness]]);
    all.force = vec![2.0 * system.force];
    all.forcing = system
        .forcing
        .iter()
        .map(|h| Load { k: h.k, cos: vec![2.0 * h.cos], sin: vec![2.0 * h.sin] })
        .collect();
    let turned = |wall: &Wall<f64>| Wall {
        offset: -wall.offset,
        harmonics: wall.harmonics.iter().map(|h| Harmonic { k: h.k, cos: -h.cos, sin: -h.sin }).collect(),
        restitution: wall.restitution,
    };
    let named =
        |name: &str, row: f64, wall| Stop { name: name.into(), row: vec![row], wall, law: StopLaw::Newton };
    all.stops.extend(system.lower.clone().map(|wall| named("lower", 1.0, wall)));
    all.stops.extend(system.upper.as_ref().map(|wall| named("upper", -1.0, turned(wall))));
    all
}

fn wall(offset: f64, restitution: f64, harmonics: &[(u32, f64, f64)]) -> Wall<f64> {
    let harmonics = harmonics.iter().map(|&(k, cos, sin)| Harmonic { k, cos, sin }).collect();
    Wall { offset, harmonics, restitution }
}

fn oscillators() -> Vec<(&'static str, System<f64>, [f64; 2])> {
    let bare = |damping, stiffness| System { damping, stiffness, ..System::default() };
    let forced = |cos| vec![Harmonic { k: 1, cos, sin: 0.0 }];
    vec![
        (
            "moving wall",
            System { lower: Some(wall(-1.0, 1.0, &[(1, 1.01, 0.0)])), ..bare(0.2, 0.04) },
            [0.5, 0.0],
        ),
        (
            "two walls",
            System {
                forcing: forced(1.0),
                lower: Some(wall(-0.6, 0.8, &[])),
                upper: Some(wall(0.7, 0.7, &[(2, 0.0, 0.1)])),
                ..bare(0.1, 1.3)
            },
            [0.0, 0.1],
        ),
        ("ball", System { force: -1.0, lower: Some(wall(0.0, 0.5, &[])), ..bare(0.0, 0.0) }, [0.5, 0.0]),
        (
            "ball on a shaker",
            System { force: -1.0, lower: Some(wall(0.0, 0.3, &[(1, 1.5, 0.0)])), ..bare(0.0, 0.0) },
            [2.0, 0.0],
        ),
        (
            "plastic",
            System { forcing: forced(1.0), lower: Some(wall(-0.3, 0.0, &[])), ..bare(0.05, 2.1) },
            [0.2, 0.0],
        ),
        (
            "resonant",
            System { forcing: forced(0.2), lower: Some(wall(-1.0, 0.9, &[])), ..bare(0.0, 1.0) },
            [0.2, 0.0],
        ),
        (
            "repelled",
            System {
                forcing: forced(1.0),
                lower: Some(wall(-1.0, 0.6, &[])),
                upper: Some(wall(1.0, 0.6, &[])),
                ..bare(0.3, -0.4)
            },
            [0.1, 0.0],
        ),
        (
            "fast",
            System { forcing: forced(30.0), lower: Some(wall(-0.01, 0.8, &[])), ..bare(1.0, 3000.0) },
            [0.02, 0.0],
        ),
    ]
}

/// Every event of both engines, in the same order, at the same time with the same velocity: to 10⁻¹³ before
/// amplification, which is measured by starts 10⁻⁸ apart.
#[test]
fn one_degree_of_freedom_agrees_with_the_engine_for_it() {
    for (name, system, start) in oscillators() {
        let until = Time::new(12, 0.0);
        let one = alone::Simulator::new(&system, &alone::Settings::default()).unwrap();
        let follow = |start: [f64; 2]| {
            let mut all: Vec<(u8, f64, f64)> = Vec::new();
            let mut run = one.start(at(0.3), start[0], start[1]).unwrap();
            run.record(until, |event| {
                all.push(match event {
                    alone::Event::Impact(x) => (0, x.time.since(at(0.0)), x.velocity),
                    alone::Event::Tangency(x) => (1, x.time.since(at(0.0)), 0.0),
                    alone::Event::Stick(x) => (2, x.time.since(at(0.0)), 0.0),
                    alone::Event::Release(x) => (3, x.time.since(at(0.0)), 0.0),
                    other => unreachable!("{other:?}"),
                });
            });
            (all, run.state())
        };
        let ((known, end), (moved, _)) = (follow(start), follow([start[0] + 1e-8, start[1]]));
        let other = simulator(&as_machine(&system));
        let found = events(&other, (at(0.3), &start[..1], &start[1..]), until);
        assert_eq!(found.len(), known.len(), "{name}");
        assert!(known.len() >= 4, "{name}: {}", known.len());
        // What rounding makes of the times of slow impacts adds up.
        let (mut amplification, mut radii) = (1.0f64, 0.0);
        for (i, ((kind, time, velocity), event)) in known.iter().zip(&found).enumerate() {
            // What is near a bounce that is summed up, or after another history, tells nothing of
            // amplification.
            if let Some(moved) = moved.get(i).filter(|moved| moved.0 == *kind) {
                amplification =
                    amplification.max((moved.1 - time).abs().max((moved.2 - velocity).abs()) / 1e-8);
            }
            let (t, v) = match event {
                Event::Impact(x) => {
                    radii += 2.0 * x.radius;
                    (x.time.since(at(0.0)), x.velocity)
                }
                other => (other.time().unwrap().since(at(0.0)), 0.0),
            };
            let same = match event {
                Event::Impact(_) => 0,
                Event::Tangency(_) => 1,
                Event::Stick(_) => 2,
                Event::Release(_) => 3,
                other => panic!("{name}: {other:?}"),
            };
            assert_eq!(same, *kind, "{name}: event {i}");
            let off = (t - time).abs().max((v - velocity).abs());
            assert!(
                off <= (1e-13 * (1.0 + time) + radii) * amplification,
                "{name}: event {i} is off by {off:e}, amplified {amplification:e} times"
            );
        }
        let mut run = other.start(at(0.3), &start[..1], &start[1..]).unwrap();
        run.finish(until);
        let off = (run.state().q()[0] - end.q).abs().max((run.state().u()[0] - end.u).abs());
        assert!(off <= 1e-12 * amplification * 80.0, "{name}: the end is off by {off:e}");
    }
}

/// Both of two machines that share no spring and no stop move as each alone.
#[test]
fn uncoupled_oscillators_each_move_as_alone() {
    let all = oscillators();
    for (first, second) in [(1, 7), (1, 3), (4, 2)] {
        let parts = [&all[first], &all[second]].map(|(_, system, start)| (as_machine(system), *start));
        let mut both =
            machine(&[&[2.0, 0.0], &[0.0, 2.0]], &[&[0.0, 0.0], &[0.0, 0.0]], &[&[0.0, 0.0], &[0.0, 0.0]]);
        both.force = vec![0.0, 0.0];
        for (i, (part, _)) in parts.iter().enumerate() {
            let place = |v: &[f64]| if i == 0 { vec![v[0], 0.0] } else { vec![0.0, v[0]] };
            both.damping.push((i, i, part.damping[0].2));
            both.stiffness.push((i, i, part.stiffness[0].2));
            both.force[i] = part.force[0];
            both.forcing.extend(part.forcing.iter().map(|load| Load {
                k: load.k,
                cos: place(&load.cos),
                sin: place(&load.sin),
            }));
            both.stops.extend(part.stops.iter().map(|stop| Stop {
                name: format!("{i} {}", stop.name),
                row: place(&stop.row),
                wall: stop.wall.clone(),
                law: stop.law.clone(),
            }));
        }
        let until = Time::new(8, 0.0);
        let starts = [parts[0].1, parts[1].1];
        let found = events(
            &simulator(&both),
            (at(0.3), &[starts[0][0], starts[1][0]], &[starts[0][1], starts[1][1]]),
            until,
        );
        let counts = [0, parts[0].0.stops.len()];
        for (i, (part, start)) in parts.iter().enumerate() {
            let known = events(&simulator(part), (at(0.3), &start[..1], &start[1..]), until);
            let follow = |known: &[Event], first: usize| -> Vec<(usize, f64, f64)> {
                let one = |event: &Event| {
                    let velocity = if let Event::Impact(impact) = event { impact.velocity } else { 0.0 };
                    (event.place().unwrap() - first, event.time().unwrap().since(at(0.0)), velocity)
                };
                known.iter().map(one).collect()
            };
            let mine: Vec<Event> = found
                .iter()
                .filter(|event| {
                    let stop = event.place().unwrap();
                    if i == 0 { stop < counts[1] } else { stop >= counts[1] }
                })
                .copied()
                .collect();
            let (mine, known) = (follow(&mine, counts[i]), follow(&known, 0));
            assert_eq!(mine.len(), known.len(), "{} and {}", all[first].0, all[second].0);
            for (a, b) in mine.iter().zip(&known) {
                assert_eq!(a.0, b.0);
                let off = (a.1 - b.1).abs().max((a.2 - b.2).abs());
                assert!(off < 1e-8, "{} and {}: {a:?} {b:?}", all[first].0, all[second].0);
            }
            // Before anything is amplified, to rounding.
            assert!((mine[0].1 - known[0].1).abs() < 1e-13 && (mine[0].2 - known[0].2).abs() < 1e-12);
        }
    }
}

/// A chain of three without damping between elastic stops, one of them between two of its masses.
fn elastic_chain() -> Machine<f64> {
    let mut chain = machine(
        &[&[1.0, 0.0, 0.0], &[0.0, 2.0, 0.0], &[0.0, 0.0, 0.5]],
        &[&[0.0; 3], &[0.0; 3], &[0.0; 3]],
        &[&[4.0, -2.0, 0.0], &[-2.0, 5.0, -3.0], &[0.0, -3.0, 7.0]],
    );
    chain.stops = vec![
        stop(&[1.0, 0.0, 0.0], -0.2, 1.0),
        stop(&[-1.0, 1.0, 0.0], -0.3, 1.0),
        stop(&[0.0, 0.0, -1.0], -0.4, 1.0),
    ];
    chain
}

/// Over 3000 impacts; docs/machines.md has the figure for 10⁶.
#[test]
fn energy_is_kept_by_elastic_impacts() {
    let wanted: u64 = samples(3_000);
    let chain = elastic_chain();
    let simulator = simulator(&chain);
    let equations = simulator.equations();
    let energy = |state: &State| {
        let [q, u] = [state.q(), state.u()].map(nalgebra::DVector::from_column_slice);
        (u.dot(&(&equations.mass * &u)) + q.dot(&(&equations.stiffness * &q))) / 2.0
    };
    let mut run = simulator.start(at(0.0), &[0.3, 0.2, 0.1], &[1.0, -1.5, 0.5]).unwrap();
    let begin = energy(&run.state());
    let (mut worst, mut period) = (0.0f64, 0);
    while run.impacts() < wanted {
        period += 10;
        assert_eq!(run.finish(Time::new(period, 0.0)), RunEnd::Reached);
        worst = worst.max((energy(&run.state()) / begin - 1.0).abs());
    }
    println!("energy drifts by {worst:e} of itself over {} impacts", run.impacts());
    assert!(worst < 1e-10, "{worst:e} over {} impacts", run.impacts());
}

/// q = P cos t + a cos w(t − φ) + b sin w(t − φ) between stops at ±d, mirrored every half period: b = −a cot
/// x, x = wπ/2, and with r = (1 − τ)/(1 + τ), P cos φ = −d − a, P sin φ = −a w r cot x, so that P² = (d +
/// a)² + (a w r cot x)².
#[test]
fn the_symmetric_orbit_between_two_stops_is_that_of_the_closed_form() {
    for (w, tau, d, force) in [(0.7f64, 0.8, 0.5, 1.0), (0.4, 0.6, 0.3, 1.0), (0.25, 0.7, 1.0, 3.0)] {
        let p = force / (w * w - 1.0);
        let (cot, r) = (1.0 / (w * PI / 2.0).tan(), (1.0 - tau) / (1.0 + tau));
        let g = w * r * cot;
        // (1 + g²)a² + 2da + d² − P² = 0.
        let root = (d * d - (1.0 + g * g) * (d * d - p * p)).sqrt();
        for a in [(-d + root) / (1.0 + g * g), (-d - root) / (1.0 + g * g)] {
            let phase = (-a * g / p).atan2((-d - a) / p).rem_euclid(TAU);
            let v = -2.0 * a * w * cot * tau / (1.0 + tau);
            if v <= 0.0 {
                continue;
            }
            let mut machine = machine(&[&[1.0]], &[&[0.0]], &[&[w * w]]);
            machine.forcing = vec![Load { k: 1, cos: vec![force], sin: vec![0.0] }];
            machine.stops = vec![stop(&[1.0], -d, tau), stop(&[-1.0], -d, tau)];
            let found = events(&simulator(&machine), (at(phase), &[-d], &[v]), at(phase).after(4.5 * PI));
            for (i, event) in found.iter().enumerate() {
                let Event::Impact(impact) = event else { panic!("{event:?}") };
                let off = impact.time.since(at(phase)) - PI * (i + 1) as f64;
                assert_eq!(impact.place, (i + 1) % 2);
                assert!(
                    off.abs() < 1e-11 && (impact.velocity + v / tau).abs() < 1e-11,
                    "w = {w}, impact {i}: {off:e}"
                );
            }
            assert_eq!(found.len(), 4);
        }
    }
}

/// A name, a machine, displacements and velocities to start from.
type Start = (&'static str, Machine<f64>, Vec<f64>, Vec<f64>);

/// Machines for both integrators.
fn pairs() -> Vec<Start> {
    let mut all = Vec::new();
    let mut two =
        machine(&[&[2.0, 0.0], &[0.0, 0.5]], &[&[0.3, -0.1], &[-0.1, 0.2]], &[&[3.0, -1.0], &[-1.0, 1.0]]);
    two.forcing = vec![Load { k: 1, cos: vec![2.0, 0.0], sin: vec![0.0, 0.5] }];
    two.stops = vec![stop(&[-1.0, 1.0], -0.2, 0.7), stop(&[1.0, 0.0], -0.8, 0.8)];
    all.push(("two masses that hit each other", two, vec![0.1, 0.2], vec![0.0, 0.0]));
    let mut turning =
        machine(&[&[1.0, 0.2], &[0.2, 1.5]], &[&[0.1, -2.0], &[2.0, 0.1]], &[&[5.0, 0.5], &[-0.5, 4.0]]);
    turning.forcing = vec![Load { k: 2, cos: vec![1.0, 0.3], sin: vec![0.0, 1.0] }];
    turning.stops = vec![stop(&[1.0, 0.5], -0.25, 0.6)];
    all.push(("gyroscopic", turning, vec![0.3, 0.0], vec![0.0, 0.4]));
    let mut defective =
        machine(&[&[1.0, 0.0], &[0.0, 1.0]], &[&[2.0, 1.0], &[0.0, 2.0]], &[&[1.0, 0.0], &[0.0, 1.0]]);
    defective.forcing = vec![Load { k: 1, cos: vec![1.0, 2.0], sin: vec![0.0, 0.0] }];
    defective.stops = vec![stop(&[1.0, 1.0], -0.2, 0.5)];
    all.push(("defective", defective, vec![0.3, 0.0], vec![0.0, 0.4]));
    let mut chain = elastic_chain();
    chain.force = vec![-1.0, 0.0, 0.5];
    chain.forcing = vec![Load { k: 1, cos: vec![0.0, 1.0, 0.0], sin: vec![0.0, 0.0, 0.0] }];
    chain.stops.iter_mut().for_each(|stop| stop.wall.restitution = 0.75);
    all.push(("chain", chain, vec![0.3, 0.2, 0.1], vec![0.0; 3]));
    let mut free =
        machine(&[&[1.0, 0.0], &[0.0, 3.0]], &[&[0.0, 0.0], &[0.0, 0.0]], &[&[2.0, -2.0], &[-2.0, 2.0]]);
    free.force = vec![-1.0, -3.0];
    free.stops = vec![Stop {
        name: "shaker".into(),
        row: vec![1.0, 0.0],
        wall: wall(0.0, 0.6, &[(1, 0.8, 0.0)]),
        law: StopLaw::Newton,
    }];
    all.push(("a sprung pair that falls on a shaker", free, vec![1.0, 1.5], vec![0.0, 0.0]));
    let mut stiff = machine(
        &[&[1.0, 0.0, 0.0], &[0.0, 0.1, 0.0], &[0.0, 0.0, 0.1]],
        &[&[0.2, -0.1, 0.0], &[-0.1, 0.15, -0.05], &[0.0, -0.05, 0.05]],
        &[&[60.0, -50.0, 0.0], &[-50.0, 200.0, -150.0], &[0.0, -150.0, 150.0]],
    );
    stiff.forcing = vec![Load { k: 1, cos: vec![20.0, 0.0, 0.0], sin: vec![0.0; 3] }];
    stiff.stops = vec![stop(&[0.0, 0.0, 1.0], -0.5, 0.8)];
    all.push(("stiff", stiff, vec![0.3; 3], vec![0.0; 3]));
    let mut resting =
        machine(&[&[1.0, 0.0], &[0.0, 1.0]], &[&[0.2, -0.1], &[-0.1, 0.1]], &[&[5.0, -3.0], &[-3.0, 3.0]]);
    resting.force = vec![-2.0, 0.0];
    resting.forcing = vec![Load { k: 1, cos: vec![0.0, 3.0], sin: vec![0.0, 0.0] }];
    resting.stops = vec![stop(&[1.0, 0.0], -0.1, 0.1), stop(&[0.0, 1.0], -1.2, 0.7)];
    all.push(("one mass rests while the other hits", resting, vec![0.3, 0.0], vec![0.0; 2]));
    all
}

/// Impacts, rests and states agree with the second integrator, to 10⁻¹² before amplification where nothing
/// rests, to 10⁻⁷ where something does, as the two end bounces at different heights.
#[test]
fn motions_agree_with_a_second_integrator() {
    let mut rested = 0;
    for (name, machine, q, u) in pairs().into_iter().step_by(one_in(3)) {
        let ours = simulator(&machine);
        // The second integrator does not get through the stiff one's chatter: up to there.
        let mut until = 5.0 * TAU;
        if name == "stiff" {
            ours.start(at(0.0), &q, &u).unwrap().record(Time::new(5, 0.0), |event| {
                if let Event::Stick(stick) = event {
                    until = until.min(stick.time.since(at(0.0)) - 0.02);
                }
            });
        }
        let mut found = Vec::new();
        let mut run = ours.start(at(0.0), &q, &u).unwrap();
        let mut rests = 0;
        run.record(at(until), |event| match event {
            Event::Impact(impact) => found.push((impact.place, impact.time.since(at(0.0)), impact.velocity)),
            Event::Stick(_) => rests += 1,
            _ => {}
        });
        println!("{name}: {} impacts, {rests} rests", found.len());
        let mut other = second::Motion::new(&machine, &q, &u);
        let known = other.follow(until);
        assert!(found.len() > 4, "{name}: {} impacts", found.len());
        // The impacts of speeds that both follow.
        let swift = |all: &[(usize, f64, f64)]| {
            all.iter().copied().filter(|hit| hit.2.abs() > 1e-4).collect::<Vec<_>>()
        };
        let (found, known) = (swift(&found), swift(&known));
        assert_eq!(found.len(), known.len(), "{name}");
        let nudged: Vec<f64> = q.iter().map(|q| q + 1e-8).collect();
        let mut moved = Vec::new();
        ours.start(at(0.0), &nudged, &u).unwrap().record(at(until), |event| {
            if let Event::Impact(impact) = event {
                moved.push((impact.place, impact.time.since(at(0.0)), impact.velocity));
            }
        });
        let moved = swift(&moved);
        let (mut amplification, mut worst) = (1.0f64, 0.0f64);
        for (i, (a, b)) in found.iter().zip(&known).enumerate() {
            assert_eq!(a.0, b.0, "{name}: impact {i}");
            if let Some(moved) = moved.get(i) {
                amplification = amplification.max((moved.1 - a.1).abs().max((moved.2 - a.2).abs()) / 1e-8);
            }
            let off = (a.1 - b.1).abs().max((a.2 - b.2).abs());
            worst = worst.max(off / amplification);
            let bound = if rests > 0 { 1e-7 } else { 1e-12 };
            assert!(
                off <= bound * amplification,
                "{name}: impact {i} {a:?} {b:?} is off by {off:e}, amplified {amplification:e} times"
            );
        }
        println!(
            "{name}: {} impacts, {rests} rests, worst {worst:e} before amplification {amplification:.1e}",
            found.len()
        );
        let state = run.state();
        for i in 0..q.len() {
            let off = (state.q()[i] - other.q[i]).abs().max((state.u()[i] - other.u[i]).abs());
            let bound = if rests > 0 { 1e-6 } else { 1e-11 };
            assert!(off <= bound * amplification, "{name}: the end is off by {off:e}");
        }
        rested += usize::from(rests > 0);
    }
    assert!((2..6).contains(&rested), "{rested}");
}

const GOOD: &str = r#"format = "grazing-scene 2"
title = "t"
[parameters]
k = 200
[system]
frequency = 8
mass = [[2, 0], [0, 0.5]]
damping = [[12, -2], [-2, 2]]
stiffness = [[3200, "-k"], ["-k", 200]]
forcing = [{ cos = [12, 0] }]
[[walls]]
row = [-1, 1]
offset = -0.004
restitution = 0.8
[[tasks]]
name = "m"
kind = "simulate"
start = { q = 0 }
"#;

/// One line each: file, line, key, value, what is wrong.
#[test]
fn bad_machines_are_named_with_file_line_key_and_value() {
    Scene::from_toml(GOOD, "s.toml").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("s.toml");
    let file = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    file("bad.mtx", "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 2\n1 2 1\n");
    file("short.mtx", "%%MatrixMarket matrix array real general\n2 2\n1\n0\n0\n");
    file("pattern.mtx", "%%MatrixMarket matrix coordinate pattern general\n2 2 1\n1 1\n");
    file("words.csv", "1, 0\nmass, 1\n");
    let mut wrong: Vec<String> = Vec::new();
    file("ragged.csv", "1, 0\n0\n");
    for (from, to, line, says) in [
        ("frequency = 8\n", "", 5, "has neither `frequency` nor `period`"),
        ("frequency = 8", "frequency = 8\nperiod = 0.125", 7, "stands beside `frequency`"),
        ("frequency = 8", "frequency = -8", 6, "must be positive"),
        ("mass = [[2, 0], [0, 0.5]]\n", "", 5, "has neither `mass` nor `modes`"),
        ("mass = [[2, 0], [0, 0.5]]", "mass = [[2, 0], [0, 0]]", 7, "not positive definite"),
        ("mass = [[2, 0], [0, 0.5]]", "mass = [[1, 2], [2, 1]]", 7, "not positive definite"),
        (
            "mass = [[2, 0], [0, 0.5]]",
            "mass = [[1, 0.5], [0, 1]]",
            7,
            "not symmetric: row 2, column 1 has 0, row 1, column 2 has 0.5",
        ),
        (
            "mass = [[2, 0], [0, 0.5]]\ndamping = [[12, -2], [-2, 2]]\nstiffness = [[3200, \"-k\"], [\"-k\", 200]]",
            "modes = { frequencies = [3, 5], ratios = [0.01, 0.01], shapes = [[1, 2], [1, 2]] }",
            10,
            "no mode moves it",
        ),
        ("mass = [[2, 0], [0, 0.5]]", "mass = [[2, 0], [0]]", 7, "has 1 entries; the first row has 2"),
        ("mass = [[2, 0], [0, 0.5]]", "mass = 2", 9, "has 2 rows; mass has 1"),
        ("damping = [[12, -2], [-2, 2]]", "damping = [[12, -2]]", 8, "must be square"),
        (
            "damping = [[12, -2], [-2, 2]]",
            "damping_ratio = [0.1, 0.1, 0.1]",
            8,
            "give one ratio for all modes, or 2",
        ),
        ("damping =", "damping_ratio = 0.1\ndamping =", 8, "stands beside `damping`"),
        ("\"-k\"], [", "\"-q\"], [", 9, "unknown parameter \"q\""),
        ("3200", "\"sqrt(0-k)\"", 9, "root of a negative number"),
        ("cos = [12, 0]", "cos = [12]", 10, "has 1 entries; the machine has 2 coordinates"),
        ("cos = [12, 0]", "k = 0, cos = [12, 0]", 10, "k is 0"),
        ("row = [-1, 1]", "row = [0, 0]", 12, "no motion reaches the stop"),
        ("row = [-1, 1]", "row = [1]", 12, "has 1 entries; the machine has 2 coordinates"),
        ("row = [-1, 1]", "side = \"lower\"", 12, "row = [-1] for an upper one"),
        ("restitution = 0.8", "restitution = -0.8", 14, "at least 0"),
        ("restitution = 0.8\n", "", 11, "has neither `restitution` nor `stiffness`"),
        ("restitution = 0.8", "restitution = 0.8\nstiffness = 9", 15, "stands beside `restitution`"),
        ("restitution = 0.8", "restitution = 0.8\ndamping = 9", 15, "stands beside `restitution`"),
        ("restitution = 0.8", "stiffness = 0", 14, "that of a soft stop is positive"),
        ("restitution = 0.8", "stiffness = 9\ndamping = -1", 15, "at least 0"),
        ("restitution = 0.8", "restitution = \"1 - v\"", 14, "is negative at the speed v ="),
        ("restitution = 0.8", "restitution = \"1/(1 - v/k)\"", 14, "has a pole at the speed v = 200"),
        ("restitution = 0.8", "restitution = \"exp(-v)\"", 14, "is not a rational function of the speed v"),
        ("restitution = 0.8", "restitution = \"v^10\"", 14, "powers of v above 8"),
        ("offset = -0.004", "offset = 0.004", 18, "behind the stop"),
        (
            "start = { q = 0 }",
            "start = { q = [0, 0, 0] }",
            18,
            "has 3 entries; the machine has 2 coordinates",
        ),
        (
            "kind = \"simulate\"",
            "kind = \"crisis\"\nparameter = \"k\"\nbracket = [1, 2]\norbit = { pattern = [1] }\nphase = 0",
            17,
            "works with one degree of freedom",
        ),
        (
            "kind = \"simulate\"\nstart = { q = 0 }",
            "kind = \"event\"\nevent = \"flip\"\nparameter = \"x\"\norbit = { pattern = [1] }",
            19,
            "parameter = \"x\": the scene has no parameter",
        ),
        ("mass = [[2, 0], [0, 0.5]]", "mass = { file = \"none.mtx\" }", 7, "none.mtx"),
        ("mass = [[2, 0], [0, 0.5]]", "mass = { file = \"bad.mtx\" }", 7, "bad.mtx:4: row 1, column 2"),
        ("mass = [[2, 0], [0, 0.5]]", "mass = { file = \"short.mtx\" }", 7, "ends after 3 of 4 entries"),
        ("mass = [[2, 0], [0, 0.5]]", "mass = { file = \"pattern.mtx\" }", 7, "entries must be real"),
        (
            "mass = [[2, 0], [0, 0.5]]",
            "mass = { file = \"words.csv\" }",
            7,
            "words.csv:2: \"mass\" is not a number",
        ),
        ("mass = [[2, 0], [0, 0.5]]", "mass = { file = \"ragged.csv\" }", 7, "ragged.csv:2: has 1 numbers"),
    ] {
        assert!(GOOD.contains(from), "{from}");
        // The last one alone where it is the task's.
        let text = if from.starts_with("kind") || from.starts_with("start") {
            let (head, tail) = GOOD.rsplit_once(from).unwrap();
            format!("{head}{to}{tail}")
        } else {
            GOOD.replacen(from, to, 1)
        };
        let error = Scene::from_toml(&text, scene.to_str().unwrap()).unwrap_err();
        let shown = error.to_string();
        let place = format!("{}:{line}: ", scene.display());
        assert!(error.is_input() && shown.lines().count() == 1, "{shown}");
        if !(shown.starts_with(&place) && shown.contains(says)) {
            wrong.push(format!("{to}: {shown}\n  wanted {place}… {says}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The same matrix written out, as CSV and as MatrixMarket in each layout.
#[test]
fn matrices_from_files_are_those_written_out() {
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("s.toml");
    let name = scene.to_str().unwrap();
    let known = Scene::from_toml(GOOD, name).unwrap().machine(&[]).unwrap().equations().unwrap();
    for (file, text) in [
        ("a.csv", "3200, -200 # newtons per metre\n-200; 200\n".replace(';', ",")),
        ("b.txt", "3200\t-200\n-2e2 200\n".to_string()),
        (
            "c.mtx",
            "%%MatrixMarket matrix array real general\n% by columns\n2 2\n3200\n-200\n-200\n200\n"
                .to_string(),
        ),
        ("d.mtx", "%%MatrixMarket matrix array real symmetric\n2 2\n3200\n-200\n200\n".to_string()),
        (
            "e.mtx",
            "%%MatrixMarket matrix coordinate real general\n2 2 4\n1 1 3200\n2 1 -200\n1 2 -200\n2 2 200\n"
                .to_string(),
        ),
        (
            "f.mtx",
            "%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 3200\n2 1 -200\n2 2 200\n"
                .to_string(),
        ),
    ] {
        fs::write(folder.path().join(file), text).unwrap();
        let text = GOOD.replace("[[3200, \"-k\"], [\"-k\", 200]]", &format!("{{ file = \"{file}\" }}"));
        let found = Scene::from_toml(&text, name).unwrap().machine(&[]).unwrap().equations().unwrap();
        assert_eq!(found.stiffness, known.stiffness, "{file}");
    }
}
