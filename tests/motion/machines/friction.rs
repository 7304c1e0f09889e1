//! Dry friction: closed forms, energy, impacts among it, a second integrator, the limit of steep formulas.

use crate::samples::{one_in, samples};
use std::collections::BTreeMap;

use grazing_scenes::{
    attractor::{
        cycle::Cycle,
        detection::{Detection, Fate},
        dynamics::Dynamics,
    },
    many::{Friction, NormalForce},
};

use super::{second::numbers, *};

mod corners;
mod drag;
mod forms;
mod orbits;
mod pressed;
mod refusals;
mod rough;
mod shared;
mod stops;
mod stribeck;

use rough::Rough;

fn friction(row: &[f64], normal: f64, [coefficient, static_coefficient]: [f64; 2]) -> Friction<f64> {
    Friction {
        name: format!("friction {row:?}"),
        row: row.to_vec(),
        normal: NormalForce::Given(normal),
        coefficient,
        law: None,
        static_coefficient,
        speed: 0.0,
        harmonics: vec![],
    }
}

/// A machine with two rough rows, a belt, a vibrating surface and a stop.
fn rough_pair() -> Machine<f64> {
    let damping: [&[f64]; 2] = [&[0.1, -0.02], &[-0.02, 0.15]];
    let mut rough = machine(&[&[1.0, 0.2], &[0.2, 0.7]], &damping, &[&[4.0, -1.5], &[-1.5, 2.2]]);
    rough.forcing = vec![Load { k: 1, cos: vec![1.6, 0.1], sin: vec![0.2, 0.3] }];
    rough.friction = vec![
        Friction { speed: 0.05, ..friction(&[1.0, 0.0], 1.5, [0.4, 0.6]) },
        Friction {
            harmonics: vec![Harmonic { k: 2, cos: 0.02, sin: 0.05 }],
            ..friction(&[-1.0, 1.0], 0.5, [0.3, 0.3])
        },
    ];
    rough.stops = vec![stop(&[0.0, 1.0], -0.3, 0.7)];
    rough
}

/// What happened, by its word, place and time in radians.
fn told(events: &[Event]) -> Vec<(&'static str, usize, f64)> {
    let one = |event: &Event| {
        let word = match event {
            Event::Stick(_) => "stick",
            Event::Release(_) => "release",
            Event::Reversal(_) => "reversal",
            Event::Impact(_) => "impact",
            _ => return None,
        };
        Some((word, event.place()?, TAU * event.time()?.periods()))
    };
    events.iter().filter_map(one).collect()
}

/// A free mass on a rough spring loses 4F/k of its amplitude a period, by half periods of cosines about ±F/k,
/// and stops for ever where the spring cannot pull it off.
#[test]
fn free_vibration_falls_linearly_and_stops() {
    let (k, force) = (4.0f64, 0.3);
    let mut rough = machine(&[&[1.0]], &[&[0.0]], &[&[k]]);
    rough.friction = vec![friction(&[1.0], 1.0, [force, 0.35])];
    let simulator = simulator(&rough);
    let mut amplitude = 1.0f64;
    let found = told(&events(&simulator, (at(0.0), &[amplitude], &[0.0]), Time::new(10, 0.0)));
    let half = PI / k.sqrt();
    for (i, (word, place, time)) in found.iter().enumerate() {
        assert_eq!(*place, 0);
        assert!((time - (i + 1) as f64 * half).abs() < 1e-12, "{i}: {time}");
        amplitude -= 2.0 * force / k;
        let stops = k * amplitude <= 0.35;
        assert_eq!(*word, if stops { "stick" } else { "reversal" }, "{i}");
    }
    assert!(k * amplitude <= 0.35 && found.len() == 7, "{found:?}");
    let mut run = simulator.start(at(0.0), &[1.0], &[0.0]).unwrap();
    run.finish(Time::new(10, 0.0));
    assert!((run.state().q()[0].abs() - amplitude.abs()).abs() < 1e-13 && run.state().u()[0] == 0.0);
}

/// A mass on a belt: it sticks until the spring pulls with F_s, and the belt catches it where it has the
/// belt's velocity again: all of one period in closed form.
#[test]
fn stick_and_slip_on_a_belt_is_closed() {
    for [k, holding, sliding, speed] in [[100.0, 4.0, 2.0, 0.1], [1.0, 1.0, 0.2, 0.5], [7.0, 3.0, 0.0, 1e-3]]
    {
        let [k, holding, sliding, speed]: [f64; 4] = [k, holding, sliding, speed];
        let mut belt = machine(&[&[1.0]], &[&[0.0]], &[&[k]]);
        belt.friction = vec![Friction { speed, ..friction(&[1.0], 1.0, [sliding, holding]) }];
        // From where the belt carries it: q = F_s/k and q′ = the belt's velocity.
        let (omega, drop) = (k.sqrt(), (holding - sliding) / k);
        // q − F_k/k = drop cos ωs + (speed/ω) sin ωs has the velocity `speed` again at s = 2(π − atan(ω
        // drop/speed))/ω.
        let slip = 2.0 * (PI - (omega * drop / speed).atan()) / omega;
        let stick = 2.0 * drop / speed;
        let simulator = simulator(&belt);
        let rounds = 5;
        let until = f64::from(rounds) * (slip + stick) + 0.5 * slip;
        let found = told(&events(&simulator, (at(0.0), &[holding / k], &[speed]), at(until)));
        let mut expected = vec![];
        for i in 0..rounds {
            expected.push(("stick", f64::from(i) * (slip + stick) + slip));
            expected.push(("release", f64::from(i + 1) * (slip + stick)));
        }
        // It may begin by sticking for no time at all.
        let found: Vec<_> = found.into_iter().filter(|(.., time)| *time > 1e-9).collect();
        assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
        for ((word, _, time), (wanted, when)) in found.iter().zip(&expected) {
            assert_eq!(word, wanted);
            assert!((time - when).abs() < 1e-12 * until * (1.0 + omega), "{word}: {time} {when}");
        }
    }
}

/// Matrices of a scene: m on a spring k, and where n is 2 a mass 1 on it by a spring l.
fn in_a_row(n: usize, [k, l, m]: [f64; 3]) -> String {
    match n {
        1 => format!("mass = {m:?}\nstiffness = {k:?}\n"),
        _ => format!(
            "mass = {{ diagonal = [{m:?}, 1] }}\nstiffness = [[{:?}, {:?}], [{:?}, {l:?}]]\n",
            k + l,
            -l,
            -l
        ),
    }
}

/// Random machines of one to three coordinates with one or two rough rows, belts, vibrating surfaces and
/// stops against the second solver: every event, every time, the state at the end.
#[test]
fn random_machines_with_friction_agree_with_a_second_solver() {
    let trials: u32 = samples(2);
    let mut random = numbers(88_172_645_463_325_252);
    let mut words: BTreeMap<&str, u32> = BTreeMap::new();
    let mut worst = 0.0f64;
    for trial in 0..trials {
        let n = 1 + trial as usize % 3;
        let mut between = |low: f64, high: f64| random(low, high);
        let mut rough = machine(&[], &[], &[]);
        rough.size = n;
        for i in 0..n {
            rough.mass.push((i, i, between(0.5, 2.0)));
            let (k, c) = (between(0.3, 6.0), between(0.0, 0.2));
            rough.stiffness.push((i, i, k));
            rough.damping.push((i, i, c));
            if i > 0 {
                let k = between(0.5, 4.0);
                for (a, b, sign) in [(i, i, 1.0), (i - 1, i - 1, 1.0), (i, i - 1, -1.0), (i - 1, i, -1.0)] {
                    rough.stiffness.push((a, b, sign * k));
                }
            }
        }
        // Each place of a matrix is given once.
        let mut sum: BTreeMap<(usize, usize), f64> = BTreeMap::new();
        rough.stiffness.iter().for_each(|&(i, j, x)| *sum.entry((i, j)).or_default() += x);
        rough.stiffness = sum.into_iter().map(|((i, j), x)| (i, j, x)).collect();
        let amplitude = between(0.5, 2.0);
        rough.forcing = vec![Load {
            k: 1,
            cos: (0..n).map(|i| if i == 0 { amplitude } else { 0.0 }).collect(),
            sin: (0..n).map(|_| between(-0.3, 0.3)).collect(),
        }];
        for j in 0..1 + trial as usize / 3 % 2 {
            let row: Vec<f64> = match (j, n) {
                (_, 1) | (0, _) => (0..n).map(|i| f64::from(u8::from(i == 0))).collect(),
                _ => (0..n).map(|i| [-1.0, 1.0, 0.3][i]).collect(),
            };
            if j == 1 && n == 1 {
                break;
            }
            let (coefficient, more) = (between(0.05, 0.6), between(0.0, 0.4));
            let kinds = trial as usize / 6;
            rough.friction.push(Friction {
                speed: if kinds % 3 == 1 { between(-0.4, 0.4) } else { 0.0 },
                harmonics: match kinds % 3 {
                    2 => vec![Harmonic { k: 2, cos: between(-0.2, 0.2), sin: between(-0.2, 0.2) }],
                    _ => vec![],
                },
                ..friction(
                    &row,
                    between(0.5, 1.5),
                    [coefficient, coefficient + if kinds.is_multiple_of(2) { 0.0 } else { more }],
                )
            });
        }
        if trial % 5 == 0 {
            // Which of several answers is taken does not go with their order.
            rough.friction.reverse();
        }
        if trial % 4 == 3 {
            let row: Vec<f64> = (0..n).map(|i| f64::from(u8::from(i + 1 == n))).collect();
            rough.stops = vec![stop(&row, -between(0.4, 1.0), 0.8)];
        }
        let q: Vec<f64> = (0..n).map(|_| between(-0.3, 0.3)).collect();
        let u: Vec<f64> = (0..n).map(|_| between(-0.5, 0.5)).collect();
        let simulator = simulator(&rough);
        let until = 6.0 * TAU;
        let found = told(&events(&simulator, (at(0.0), &q, &u), at(until)));
        let mut other = Rough::new(&rough, &q, &u);
        let expected = other.follow(until);
        let show = |all: &[(&str, usize, f64)]| format!("{:?}", &all[..all.len().min(200)]);
        assert_eq!(
            found.iter().map(|one| (one.0, one.1)).collect::<Vec<_>>(),
            expected.iter().map(|one| (one.0, one.1)).collect::<Vec<_>>(),
            "{trial}: {}\n{}",
            show(&found),
            show(&expected)
        );
        for (one, known) in found.iter().zip(&expected) {
            assert!((one.2 - known.2).abs() < 1e-9, "{trial}: {one:?} {known:?}");
            *words.entry(one.0).or_default() += 1;
        }
        let mut run = simulator.start(at(0.0), &q, &u).unwrap();
        run.finish(at(until));
        let state = run.state();
        let off = apart(&[state.q(), state.u()].concat(), &other.x);
        worst = worst.max(off);
        assert!(off < 1e-9, "{trial}: {off:e}");
    }
    println!("{trials} machines, {words:?}, at the end apart by at most {worst:e}");
    let all = ["stick", "release", "reversal", "impact"];
    assert!(all[..2].iter().all(|word| words.contains_key(word)), "{words:?}");
    assert!(trials < 4 || all.iter().all(|word| words.contains_key(word)), "{words:?}");
}

/// Den Hartog's motion without stops: the undamped oscillator under P cos ωt turns back at ±x₀, and nowhere
/// else, with x₀² = (aV)² − (x_f s/(r(1 + c)))², a = P/k, x_f = F/k, V = 1/(1 − r²), s and c the sine and
/// cosine of π/r.
#[test]
fn forced_motions_without_stops_have_the_amplitude_of_den_hartog() {
    for (r, ratio) in [(0.62f64, 0.3), (0.8, 0.5), (1.3, 0.4), (2.2, 0.2)] {
        // The forcing's period is 2π: ω = 1, and the natural frequency is 1/r.
        let k = 1.0 / (r * r);
        let mut rough = machine(&[&[1.0]], &[&[0.0]], &[&[k]]);
        rough.forcing = vec![Load { k: 1, cos: vec![k], sin: vec![0.0] }];
        rough.friction = vec![friction(&[1.0], k, [ratio, ratio])];
        let (s, c) = (PI / r).sin_cos();
        let wanted = ((1.0 / (1.0 - r * r)).powi(2) - (ratio * s / (r * (1.0 + c))).powi(2)).sqrt();
        let simulator = simulator(&rough);
        let mut run = simulator.start(at(0.0), &[wanted], &[0.0]).unwrap();
        run.finish(Time::new(3000, 0.0));
        let mut turns = Vec::new();
        while turns.len() < 6 {
            let event = run.next(Time::new(3010, 0.0));
            assert!(matches!(event, Event::Reversal(_)), "{r}: {event:?}");
            turns.push(run.state().q()[0].abs());
        }
        for turn in turns {
            assert!((turn - wanted).abs() < 1e-9 * wanted, "{r}: {turn} {wanted}");
        }
    }
}

const BODY: &str = "
[[stops]]
name = \"rigid\"
row = [-1, 1]
offset = -0.3
restitution = 0.5
[[stops]]
name = \"soft\"
row = [1, 0]
offset = -0.4
stiffness = 50
damping = 1
[[stops]]
name = \"rest\"
row = [0, -1]
offset = -0.35
restitution = 0
harmonics = [{ k = 1, sin = 0.05 }]
[[friction]]
name = \"ground\"
row = [1, 0]
normal = 2
coefficient = 0.5
static_coefficient = 0.7
[[friction]]
name = \"between\"
row = [-1, 1]
normal = 1
coefficient = 0.25
";

fn scene(system: &str, rest: &str) -> Scene {
    let text = format!(
        "format = \"grazing-scene 3\"\ntitle = \"rough\"\nengine = \"many\"\n[system]\n{system}{rest}"
    );
    Scene::from_toml(&text, "rough.toml").unwrap_or_else(|error| panic!("{error}"))
}

/// A machine with friction, stops of all kinds and units of its own by matrices, and the same by formulas.
fn both() -> [Machine<f64>; 2] {
    let head = "period = 4\nmass = [[2, 0.3], [0.3, 0.5]]\n";
    let modal = "stiffness = [[3, -1], [-1, 2]]\ndamping = [[0.4, -0.05], [-0.05, 0.3]]\nforce = [0.2, 0.8]\n\
                 forcing = [{ k = 1, cos = [2.5, -0.9] }, { k = 3, sin = [0.2, 0.5] }]\n";
    let formulas = "force = [\"-3*q1 + q2 - 0.4*u1 + 0.05*u2 + 0.2 + 2.5*cos(t) + 0.2*sin(3*t)\", \
                    \"q1 - 2*q2 + 0.05*u1 - 0.3*u2 + 0.8 - 0.9*cos(t) + 0.5*sin(3*t) + 0*exp(q1)\"]\n";
    [modal, formulas].map(|system| scene(&format!("{head}{system}"), BODY).machine(&[]).unwrap())
}

#[test]
fn a_linear_machine_as_formulas_slides_and_sticks_as_by_modes() {
    let machines = both();
    assert!(!machines[0].is_smooth() && machines[1].is_smooth());
    let [modal, smooth] = machines.each_ref().map(simulator);
    let mut kinds: BTreeMap<(&str, usize), u32> = BTreeMap::new();
    for i in 0..16u32 {
        let start = |k: u32| f64::from((i * 7 + k * 5) % 11) / 11.0 - 0.5;
        let (phase, q, u) =
            (TAU * f64::from(i) / 16.0, [0.4 * start(1), 0.1 * start(2)], [start(3), start(4)]);
        let [a, b] = [&modal, &smooth].map(|simulator| {
            let mut all = Vec::new();
            let mut run = simulator.start(at(phase), &q, &u).unwrap();
            run.record(at(phase).after(3.0 * TAU), |event| all.push(event));
            assert!(run.failure().is_none());
            (told(&all), run.state())
        });
        let words =
            |all: &[(&'static str, usize, f64)]| all.iter().map(|one| (one.0, one.1)).collect::<Vec<_>>();
        assert_eq!(words(&a.0), words(&b.0), "{i}: {:?} {:?}", a.0, b.0);
        for (x, y) in a.0.iter().zip(&b.0) {
            *kinds.entry((x.0, x.1)).or_default() += 1;
            assert!((x.2 - y.2).abs() < 1e-8, "{i}: {x:?} {y:?}");
        }
        let off = apart(a.1.q(), b.1.q()).max(apart(a.1.u(), b.1.u()));
        assert!(off < 1e-8, "{i}: {off:e} after {:?}", a.0);
    }
    println!("{kinds:?}");
    for known in [("stick", 2), ("stick", 3), ("stick", 4), ("release", 3), ("release", 4), ("impact", 0)] {
        assert!(kinds.contains_key(&known), "{known:?}: {kinds:?}");
    }
}

/// What the forces put in is in the motion, in dampers, in impacts or in friction, which takes its force
/// times the path.
#[test]
fn the_energy_is_accounted_for() {
    use grazing_scenes::run::{Findings, Surroundings, run};
    let tasks = "[[tasks]]\nname = \"motion\"\nkind = \"simulate\"\nstart = { q = [1, 0], u = [0, 1.5] }\nperiods = 9\n";
    let system = "period = 4\nmass = [[2, 0.3], [0.3, 0.5]]\nstiffness = [[3, -1], [-1, 2]]\n";
    let rough = "[[friction]]\nname = \"ground\"\nrow = [1, 0]\nnormal = 2\ncoefficient = 0.06\n\
                 [[friction]]\nname = \"between\"\nrow = [-1, 1]\nnormal = 1\ncoefficient = 0.05\n";
    let scene = scene(system, &format!("{rough}{tasks}"));
    let reports = run(&scene, Surroundings::default(), &mut ()).unwrap();
    let Some(Findings::Simulation(found)) = &reports[0].findings else { panic!("{}", reports[0].status) };
    let found = serde_json::to_value(found).unwrap();
    let list = |key: &str| -> Vec<f64> {
        found[key].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
    };
    let energy = |q: &[f64], u: &[f64]| {
        0.5 * (2.0 * u[0] * u[0] + 0.6 * u[0] * u[1] + 0.5 * u[1] * u[1])
            + 0.5 * (3.0 * q[0] * q[0] - 2.0 * q[0] * q[1] + 2.0 * q[1] * q[1])
    };
    let lost = energy(&[1.0, 0.0], &[0.0, 1.5]) - energy(&list("q"), &list("u"));
    let rows = found["friction"].as_array().unwrap();
    let taken: f64 = rows.iter().map(|row| row["dissipated"].as_f64().unwrap()).sum();
    println!("lost {lost}, taken by friction {taken}: {rows:?}");
    assert!(lost > 0.5 && (lost - taken).abs() < 1e-11, "{lost} {taken}");
    for row in rows {
        assert_eq!(row["at_end"], "sticks for ever", "{row}");
        assert!(row["stuck"].as_f64().unwrap() > 0.1, "{row}");
    }
}

/// A sum of squares' root.
fn norm(all: &[Vec<f64>]) -> f64 {
    all.iter().flatten().map(|x| x * x).sum::<f64>().sqrt()
}

/// The logarithm of the largest modulus of an eigenvalue: by how much the norm of the 256th power is larger
/// than that of the 128th.
fn growth(matrix: &[Vec<f64>]) -> f64 {
    let n = matrix.len();
    let (mut power, mut logs) = (matrix.to_vec(), vec![0.0]);
    for _ in 0..8 {
        let product: Vec<Vec<f64>> = (0..n)
            .map(|i| (0..n).map(|j| (0..n).map(|l| power[i][l] * power[l][j]).sum()).collect())
            .collect();
        let size = norm(&product);
        power = product.iter().map(|row| row.iter().map(|x| x / size).collect()).collect();
        logs.push(2.0 * logs[logs.len() - 1] + size.ln());
    }
    (logs[8] - logs[7]) / 128.0
}

/// Lyapunov exponents of periodic motions that turn back, stick, and slide off with a jump of the force,
/// against differences of the second solver's period map. Where it sticks, rank is lost.
#[test]
fn exponents_are_those_of_a_second_solver() {
    use grazing_scenes::{
        attractor::lyapunov::exponents,
        many::section::{PlanarMachine, PlaneAxis},
    };
    let one = |damping: f64, amplitude: f64, [kinetic, holding]: [f64; 2]| {
        let mut rough = machine(&[&[1.0]], &[&[damping]], &[&[5.3]]);
        rough.forcing = vec![Load { k: 1, cos: vec![amplitude], sin: vec![0.0] }];
        rough.friction = vec![friction(&[1.0], 1.0, [kinetic, holding])];
        rough
    };
    let pair = |holding: f64, second: bool| {
        let damping: [&[f64]; 2] = [&[0.1, -0.02], &[-0.02, 0.15]];
        let mut rough = machine(&[&[1.0, 0.0], &[0.0, 0.7]], &damping, &[&[4.0, -1.5], &[-1.5, 2.2]]);
        rough.forcing = vec![Load { k: 1, cos: vec![1.6, 0.0], sin: vec![0.2, 0.3] }];
        rough.friction = vec![friction(&[1.0, 0.0], 1.0, [0.9, holding])];
        if second {
            rough.friction.push(friction(&[-1.0, 1.0], 1.0, [0.1, 0.1]));
        }
        rough
    };
    let all = [
        ("turns", one(0.1, 9.0, [0.4, 0.4]), 0),
        ("sticks", one(0.1, 1.5, [0.4, 0.4]), 1),
        ("slips", one(0.1, 1.5, [0.3, 0.5]), 1),
        ("pair", pair(0.9, false), 1),
        ("slipping pair", pair(1.2, false), 1),
        ("two rows", pair(0.9, true), 1),
    ];
    for (name, rough, stuck) in all.into_iter().step_by(one_in(5)) {
        let n = rough.size;
        let simulator = simulator(&rough);
        let mut run = simulator.start(at(0.0), &vec![0.1; n], &vec![0.0; n]).unwrap();
        run.finish(Time::new(400, 0.0));
        let state = [run.state().q(), run.state().u()].concat();
        run.finish(Time::new(401, 0.0));
        let again = [run.state().q(), run.state().u()].concat();
        assert!(apart(&state, &again) < 1e-9, "{name}: {state:?} {again:?}");
        let mut columns = Vec::new();
        for i in 0..2 * n {
            let ends = [1e-5, -1e-5].map(|h| {
                let mut from = state.clone();
                from[i] += h;
                let mut other = Rough::new(&rough, &from[..n], &from[n..]);
                other.follow(TAU);
                other.x
            });
            columns.push((0..2 * n).map(|j| (ends[0][j] - ends[1][j]) / 2e-5).collect::<Vec<f64>>());
        }
        let wanted = growth(&columns) / TAU;
        let axes = [PlaneAxis::Place(0), PlaneAxis::Speed(0)];
        let planar = PlanarMachine::new(&rough, Simulator::new(&rough, &Settings::default()).unwrap(), &axes);
        let start = State::new(0.0, &state[..n], &state[n..]).start(1.0);
        let planar = planar.unwrap();
        let all = exponents(&planar, &start, 2 * n, 0, 400, &()).unwrap();
        println!("{name}: {all:?}, by differences {wanted}");
        assert!((all[0].second_half - wanted).abs() < 5e-4, "{name}: {all:?} {wanted}");
        let lost = all.iter().filter(|one| !one.rate.is_finite()).count();
        assert!(if stuck == 0 { lost == 0 } else { lost >= 1 }, "{name}: {all:?}");
        // Those of the orbit: what is lost is 0, and not what rounding leaves of it.
        let mut run = planar.begin(&start).unwrap();
        let fate = Detection { transient: 0, ..Detection::default() }.detect(&planar, &mut run, &()).unwrap();
        let Fate::Periodic(Cycle { multipliers, .. }) = fate else { panic!("{name}: {fate:?}") };
        let zeros = multipliers.iter().filter(|one| **one == (0.0, 0.0)).count();
        assert_eq!((multipliers.len(), zeros), (2 * n, lost), "{name}: {multipliers:?}");
    }
}

/// The second solver with a cubic spring, against formulas with friction.
#[test]
fn cubic_springs_among_friction_agree_with_a_second_solver() {
    let system = "force = [\"-0.6*q1^3 - 0.2*(q1 - q2)^3\", \"0.2*(q1 - q2)^3\"]\n\
                  mass = { diagonal = [1, 0.8] }\nstiffness = [[2, -1], [-1, 1.5]]\n\
                  damping = { diagonal = [0.05, 0.1] }\nforcing = [{ cos = [1.4, 0.2] }]\n\
                  [[friction]]\nrow = [1, 0]\nnormal = 1\ncoefficient = 0.3\nstatic_coefficient = 0.5\nspeed = 0.1\n\
                  [[friction]]\nrow = [-1, 1]\nnormal = 1\ncoefficient = 0.1\n";
    let rough = scene(system, "").machine(&[]).unwrap();
    let simulator = simulator(&rough);
    for i in (0..6u32).rev().step_by(one_in(6)) {
        let (q, u) = ([0.1 * f64::from(i) - 0.2, 0.3], [0.5, -0.2 * f64::from(i)]);
        let found = told(&events(&simulator, (at(0.0), &q, &u), at(4.0 * TAU)));
        let mut other = Rough::new(&rough, &q, &u);
        other.load = |q, _| {
            let between = 0.2 * (q[0] - q[1]).powi(3);
            vec![-0.6 * q[0].powi(3) - between, between]
        };
        other.decide(None);
        let expected = other.follow(4.0 * TAU);
        assert_eq!(found.len(), expected.len(), "{i}: {found:?} {expected:?}");
        assert!(found.len() > 8);
        for (one, known) in found.iter().zip(&expected) {
            assert_eq!((one.0, one.1), (known.0, known.1));
            assert!((one.2 - known.2).abs() < 1e-9, "{i}: {one:?} {known:?}");
        }
        let mut run = simulator.start(at(0.0), &q, &u).unwrap();
        run.finish(at(4.0 * TAU));
        let off = apart(&[run.state().q(), run.state().u()].concat(), &other.x);
        assert!(off < 1e-10, "{i}: {off:e}");
    }
}

/// −F tanh(v/ε) tends to friction with F_s = F_k as ε falls, in proportion to it, up to sticking: then it
/// creeps, by ε times the time.
#[test]
fn steep_formulas_tend_to_friction() {
    let system = "mass = 1\nstiffness = 5.3\ndamping = 0.1\nforcing = [{ cos = 1.5 }]\n";
    let end = |extra: &str| {
        let machine = scene(&format!("{system}{extra}"), "").machine(&[]).unwrap();
        let simulator = simulator(&machine);
        let mut run = simulator.start(at(0.0), &[0.2], &[0.0]).unwrap();
        assert_eq!(run.finish(Time::new(2, 1.0)), RunEnd::Reached);
        [run.state().q(), run.state().u()].concat()
    };
    let sharp = end("[[friction]]\nnormal = 1\ncoefficient = 0.4\n");
    let off = [0.02, 0.004, 0.0008]
        .map(|width| apart(&end(&format!("force = \"-0.4*tanh(u/{width})\"\n")), &sharp));
    println!("off by {off:?}");
    assert!(off[2] < 2e-3 && off.windows(2).all(|pair| pair[1] < 0.3 * pair[0]), "{off:?}");
}

/// A mass that friction alone holds beside a stop does not rest on the stop; pressed harder than friction can
/// hold, it does, and when the force turns it sticks until that exceeds F_s.
#[test]
fn a_stop_and_friction_on_one_row_share_what_holds() {
    let mut rough = machine(&[&[1.0]], &[&[0.0]], &[&[0.0]]);
    rough.friction = vec![friction(&[1.0], 1.0, [0.5, 0.8])];
    rough.stops = vec![stop(&[1.0], 0.0, 0.6)];
    // Pushed against the stop by up to 2, pulled by up to 2.
    rough.forcing = vec![Load { k: 1, cos: vec![-2.0], sin: vec![0.0] }];
    let simulator = simulator(&rough);
    let found = told(&events(&simulator, (at(0.0), &[0.0], &[0.0]), at(TAU)));
    // −2 cos t − 0.5 pulls from −2 cos t = 0.8 on; until then it rests: on the stop while 2 cos t > 0.5.
    let (leaves, pulls) = ((0.25f64).acos(), (-0.4f64).acos());
    let words: Vec<_> = found.iter().map(|one| (one.0, one.1)).collect();
    // On the stop it has no velocity either: it sticks from the beginning, which is not told.
    assert_eq!(words[..3], [("stick", 0), ("release", 0), ("release", 1)], "{found:?}");
    for (one, time) in found.iter().zip([0.0, leaves, pulls]) {
        assert!((one.2 - time).abs() < 1e-12, "{found:?}");
    }
    // Held by friction alone: thrown gently at the stop, it bounces once and sticks.
    rough.forcing = vec![];
    rough.force = vec![-0.3];
    let held = Simulator::new(&rough, &Settings::default()).unwrap();
    let found = told(&events(&held, (at(0.0), &[0.1], &[-1.0]), at(6.0)));
    assert_eq!(
        found.iter().map(|one| (one.0, one.1)).collect::<Vec<_>>(),
        [("impact", 0), ("reversal", 1), ("stick", 1)]
    );
}

/// Modes of any kind: a coordinate that slides freely beside what sticks has no stiffness of its own;
/// gyroscopic and overdamped machines.
#[test]
fn machines_without_classical_modes_stick_as_a_second_solver_says() {
    type Square = [[f64; 2]; 2];
    let cases: [(&str, Square, Square); 4] = [
        ("free", [[0.0, 0.0], [0.0, 0.05]], [[2.0, 0.0], [0.0, 0.0]]),
        ("coupled and free", [[0.1, 0.0], [0.0, 0.1]], [[1.0, -1.0], [-1.0, 1.0]]),
        ("gyroscopic", [[0.05, 0.7], [-0.7, 0.05]], [[2.0, 0.0], [0.0, 3.0]]),
        ("overdamped", [[3.0, -1.0], [-1.0, 6.0]], [[2.0, -0.5], [-0.5, 1.0]]),
    ];
    for (name, damping, stiffness) in cases.into_iter().step_by(one_in(4)) {
        let rows = |of: [[f64; 2]; 2]| of.map(|row| row.to_vec());
        let (damping, stiffness) = (rows(damping), rows(stiffness));
        let mut rough =
            machine(&[&[1.0, 0.0], &[0.0, 2.0]], &super::rows(&damping), &super::rows(&stiffness));
        rough.forcing = vec![Load { k: 1, cos: vec![2.0, 0.5], sin: vec![0.0, 1.0] }];
        rough.friction = vec![Friction { speed: 0.1, ..friction(&[1.0, 0.0], 1.0, [0.7, 0.9]) }];
        let (q, u) = ([0.1, 0.2], [0.1, 0.0]);
        let simulator = simulator(&rough);
        let found = told(&events(&simulator, (at(0.0), &q, &u), at(5.0 * TAU)));
        let mut other = Rough::new(&rough, &q, &u);
        let expected = other.follow(5.0 * TAU);
        assert_eq!(found.len(), expected.len(), "{name}: {found:?} {expected:?}");
        assert!(found.iter().any(|one| one.0 == "stick"), "{name}: {found:?}");
        for (one, known) in found.iter().zip(&expected) {
            assert_eq!((one.0, one.1), (known.0, known.1), "{name}");
            assert!((one.2 - known.2).abs() < 1e-9, "{name}: {one:?} {known:?}");
        }
        let mut run = simulator.start(at(0.0), &q, &u).unwrap();
        run.finish(at(5.0 * TAU));
        let off = apart(&[run.state().q(), run.state().u()].concat(), &other.x);
        assert!(off < 1e-10, "{name}: {off:e}");
    }
}
