//! Grazing and periodic orbits of machines: against the one-degree code, against parts that do not know of
//! each other, against the simulator.

mod formula_orbits;
use super::machines::{apart, second};
mod soft_orbits;

use std::f64::consts::{PI, TAU};

use grazing_scenes::{
    Error,
    internals::many::{LinearEquations, LinearFlow, Periodic, Slope},
    many::{
        Family, FlowMethod, Load, Machine, Stop, StopLaw,
        grazing::{FreeMotion, Grazing, Search, locate},
        orbit::{Admissibility, Itinerary, Orbit, Strike, find},
        simulate::{Settings, Simulator},
    },
    motion::{Harmonic, Side, Time, Wall},
    one::{self, orbit as alone},
    pattern::{Analysis, Graph, Numbers, Pattern, Patterns},
    scene::{Scene, SceneFamily},
    search::touch::{InTheory, leading_impacts},
};

use crate::{paper::PAPER_MACHINE, samples::one_in};

type RealMatrix = nalgebra::DMatrix<f64>;
type RealVector = nalgebra::DVector<f64>;

/// A machine of n coordinates: mass, damping, stiffness by rows, forces of cos t, one stop.
#[derive(Clone)]
struct Parts {
    mass: Vec<Vec<f64>>,
    damping: Vec<Vec<f64>>,
    stiffness: Vec<Vec<f64>>,
    cos: Vec<f64>,
    row: Vec<f64>,
    offset: f64,
    amplitude: f64,
    restitution: f64,
    period: f64,
}

impl Parts {
    fn machine(&self) -> Machine<f64> {
        let entries = |rows: &[Vec<f64>]| {
            let one = |(i, row): (usize, &Vec<f64>)| {
                row.iter().enumerate().map(move |(j, x)| (i, j, *x)).collect::<Vec<_>>()
            };
            rows.iter().enumerate().flat_map(one).collect()
        };
        let harmonics = vec![Harmonic { k: 1, cos: self.amplitude, sin: 0.0 }];
        let wall = Wall { offset: self.offset, harmonics, restitution: self.restitution };
        Machine {
            size: self.mass.len(),
            period: self.period,
            mass: entries(&self.mass),
            damping: entries(&self.damping),
            damping_ratio: vec![],
            stiffness: entries(&self.stiffness),
            shapes: vec![],
            force: vec![],
            forcing: vec![Load { k: 1, cos: self.cos.clone(), sin: vec![] }],
            smooth: vec![],
            record: None,
            friction: vec![],
            stops: vec![Stop { name: "stop".into(), row: self.row.clone(), wall, law: StopLaw::Newton }],
        }
    }

    /// All coefficients 0.
    fn zero(&self) -> Parts {
        let nothing = |rows: &[Vec<f64>]| rows.iter().map(|row| vec![0.0; row.len()]).collect();
        Parts {
            mass: nothing(&self.mass),
            damping: nothing(&self.damping),
            stiffness: nothing(&self.stiffness),
            cos: vec![0.0; self.cos.len()],
            row: vec![0.0; self.row.len()],
            offset: 0.0,
            amplitude: 0.0,
            restitution: 0.0,
            period: 0.0,
        }
    }
}

/// Machines whose coefficients are linear in the parameter.
struct Lines {
    at_zero: Parts,
    slope: Parts,
}

impl Lines {
    fn parts(&self, p: f64) -> Parts {
        let sum = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a + p * b).collect::<Vec<_>>();
        let rows =
            |a: &[Vec<f64>], b: &[Vec<f64>]| a.iter().zip(b).map(|(a, b)| sum(a, b)).collect::<Vec<_>>();
        let (a, b) = (&self.at_zero, &self.slope);
        Parts {
            mass: rows(&a.mass, &b.mass),
            damping: rows(&a.damping, &b.damping),
            stiffness: rows(&a.stiffness, &b.stiffness),
            cos: sum(&a.cos, &b.cos),
            row: sum(&a.row, &b.row),
            offset: a.offset + p * b.offset,
            amplitude: a.amplitude + p * b.amplitude,
            restitution: a.restitution + p * b.restitution,
            period: a.period + p * b.period,
        }
    }
}

impl Family for Lines {
    fn at(&self, p: f64) -> Result<(Machine<f64>, Machine<f64>), Error> {
        Ok((self.parts(p).machine(), self.slope.machine()))
    }
}

const D: f64 = 0.6;
const W: f64 = 4.9;

/// Section 4 of the paper as 1 × 1 matrices, in `mu`.
fn paper() -> Lines {
    let at_zero = Parts {
        mass: vec![vec![1.0]],
        damping: vec![vec![2.0 * D / W]],
        stiffness: vec![vec![1.0 / (W * W)]],
        cos: vec![0.0],
        row: vec![1.0],
        offset: -1.0,
        amplitude: 1.0,
        restitution: 1.0,
        period: TAU,
    };
    let slope = Parts { amplitude: 1.0, ..at_zero.zero() };
    Lines { at_zero, slope }
}

/// The paper's oscillator with another beside it, in general coordinates: coupled by `coupling`.
fn beside(coupling: f64) -> Lines {
    let one = paper().at_zero;
    let at_zero = Parts {
        mass: vec![vec![1.0, 0.0], vec![0.0, 2.0]],
        damping: vec![vec![one.damping[0][0], 0.0], vec![0.0, 0.3]],
        stiffness: vec![vec![one.stiffness[0][0] + coupling, -coupling], vec![-coupling, 1.7 + coupling]],
        cos: vec![0.0, 0.4],
        row: vec![1.0, 0.0],
        ..one
    };
    let slope = Parts { amplitude: 1.0, ..at_zero.zero() };
    Lines { at_zero, slope }
}

/// Two masses that share a spring and a damper that is no sum of theirs, in real units, in the force's
/// amplitude.
fn coupled() -> Lines {
    let at_zero = Parts {
        mass: vec![vec![2.0, 0.1], vec![0.1, 0.5]],
        damping: vec![vec![12.0, -2.0], vec![-2.0, 2.0]],
        stiffness: vec![vec![3200.0, -200.0], vec![-200.0, 200.0]],
        cos: vec![0.0, 0.0],
        row: vec![1.0, -0.25],
        offset: -0.012,
        amplitude: 0.0,
        restitution: 0.8,
        period: 0.125,
    };
    let slope = Parts { cos: vec![1.0, 0.2], ..at_zero.zero() };
    Lines { at_zero, slope }
}

fn graze(family: &dyn Family, start: f64, reach: f64) -> Grazing {
    match locate(family, start, reach, None, None).unwrap() {
        Search::Found(found) => *found,
        Search::Nothing(why) => panic!("{why}"),
    }
}

fn simulator(machine: &Machine<f64>) -> Simulator {
    let settings = Settings { minimum_depth: 1e-14, ..Settings::default() };
    Simulator::new(machine, &settings).unwrap()
}

fn single(periods: &[u32]) -> Itinerary {
    Itinerary::new(periods.iter().map(|&periods| Strike { place: 0, periods }).collect()).unwrap()
}

fn paper_scene() -> Scene {
    Scene::from_toml(include_str!("../../examples/scenes/nordmark-2001.toml"), "test").unwrap()
}

/// A forced oscillator against an upper wall, of mass 2 and period 1/2: as 1 × 1 matrices in seconds, and by
/// hand in the forcing's phase.
#[test]
fn one_degree_of_freedom_has_the_local_map_of_the_one_degree_code() {
    let (mass, period): (f64, f64) = (2.0, 0.5);
    let rate = TAU / period;
    let (damping, stiffness) = (0.2, 0.4);
    let at_zero = Parts {
        mass: vec![vec![mass]],
        damping: vec![vec![damping * mass * rate]],
        stiffness: vec![vec![stiffness * mass * rate * rate]],
        cos: vec![0.0],
        // A stop above: gap = 0.7 − q.
        row: vec![-1.0],
        offset: -0.7,
        amplitude: 0.0,
        restitution: 0.5,
        period,
    };
    // The force, and the spring with it.
    let slope = Parts {
        cos: vec![mass * rate * rate],
        stiffness: vec![vec![0.3 * mass * rate * rate]],
        ..at_zero.zero()
    };
    let text = "format = \"grazing-scene 1\"\ntitle = \"t\"\n[parameters]\nf = 0.3\n[system]\ndamping = 0.2\n\
                stiffness = \"0.4 + 0.3*f\"\nforcing = [{ cos = \"f\" }]\n[[walls]]\nside = \"upper\"\noffset = 0.7\nrestitution = 0.5";
    let other = Scene::from_toml(text, "test").unwrap();
    let cases = [(paper(), paper_scene(), "mu", -0.04), (Lines { at_zero, slope }, other, "f", 0.3)];
    for (lines, scene, parameter, start) in cases {
        let restitution = lines.at_zero.restitution;
        let found = graze(&lines, start, 0.5);
        let family = SceneFamily::new(&scene, parameter).unwrap();
        let free = alone::Itinerary::free(1).unwrap();
        let orbit = alone::find(&alone::Family::at(&family, start).unwrap(), &free, vec![0.1, 0.1]).unwrap();
        let known = one::grazing::locate(&family, &orbit, start).unwrap();
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-10, "{parameter}: {a} {b}");
        near(found.parameter, known.parameter);
        let turn = (found.at.phase - known.phase()).abs();
        near(turn.min(TAU - turn), 0.0);
        near(found.map.acceleration, known.map.acceleration);
        near(found.map.e, known.map.e);
        near(found.map.gamma().unwrap(), known.map.gamma().unwrap());
        let w = lines.at_zero.row[0];
        for i in 0..2 {
            for j in 0..2 {
                near(found.map.a[i][j], known.map.a[i][j]);
            }
        }
        let kick = (2.0 * known.map.acceleration).sqrt() * (1.0 + restitution);
        for map in [&found.map, &known.map] {
            // With w = −1 the gap is the other way.
            near(map.c[0], w);
            near(map.b[1], w * kick);
            assert_eq!((map.b[0], map.c[1]), (0.0, 0.0));
        }
        near(found.map.rate_drift, known.map.rate_drift);
        assert!(found.others.is_empty());
        let (map, graph) =
            (found.map.to_map().unwrap(), Graph::new(&known.map.to_map().unwrap(), 5, false).unwrap());
        let analysis = Analysis::new(&map, 5, Numbers::Enclosed);
        for pattern in (1..=5).flat_map(Patterns::of_period) {
            let (a, b) = (analysis.judge(pattern.periods()), graph.judge(pattern.periods()));
            assert_eq!((a.plus, a.minus), (b.plus, b.minus), "{pattern}");
        }
    }
}

/// Of section 4's oscillator q″ = −2dq′/w − q/w² over a period: a₁ = 2r cos 2πs, a₂ = r², γ, and B.
#[test]
fn the_paper_s_map_has_its_closed_form_in_either_engine() {
    let scene = paper_scene();
    let family = SceneFamily::new(&scene, "mu").unwrap();
    let free = alone::Itinerary::free(1).unwrap();
    let orbit = alone::find(&alone::Family::at(&family, -0.04).unwrap(), &free, vec![0.1, 0.1]).unwrap();
    let one = one::grazing::locate(&family, &orbit, -0.04).unwrap().map;
    let (r, frequency) = ((-TAU * D / W).exp(), (1.0 - D * D).sqrt() / W);
    for map in [&graze(&paper(), -0.04, 0.5).map, &one] {
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-13, "{a} {b}");
        near(map.trace(), 2.0 * r * (TAU * frequency).cos());
        near(map.determinant, r * r);
        near(map.gamma().unwrap(), r * (TAU * frequency).sin() / frequency);
        near(map.acceleration, 1.0);
        near(map.b[1], 8.0_f64.sqrt());
        assert_eq!((map.b[0], &map.c[..]), (0.0, &[1.0, 0.0][..]));
        assert_eq!(map.region(), Some(grazing_scenes::local::Region::Three));
    }
}

#[test]
fn an_oscillator_beside_it_changes_no_pattern() {
    let (found, one) = (graze(&beside(0.0), -0.04, 0.5), graze(&paper(), -0.04, 0.5));
    assert!(found.parameter.abs() < 1e-13 && found.map.a.len() == 4);
    let (map, alone) = (found.map.to_map().unwrap(), one.map.to_map().unwrap());
    let (four, two) =
        (Analysis::new(&map, 6, Numbers::Enclosed), Analysis::new(&alone, 6, Numbers::Enclosed));
    let mut born = 0;
    for pattern in (1..=6).flat_map(Patterns::of_period) {
        let (a, b) = (four.judge(pattern.periods()), two.judge(pattern.periods()));
        assert_eq!((a.plus, a.minus), (b.plus, b.minus), "{pattern}");
        assert!(!b.is_open(), "{pattern}");
        born += usize::from(b.side().is_some());
    }
    assert!(born > 3, "{born}");
}

/// e and the rate's drift against the neighbours' gaps, in a parameter that every coefficient depends on.
#[test]
fn e_is_the_rate_at_which_the_least_gap_opens() {
    let mut lines = coupled();
    lines.slope.mass = vec![vec![0.003, 0.001], vec![0.001, 0.0]];
    lines.slope.damping = vec![vec![0.01, 0.02], vec![-0.01, 0.0]];
    lines.slope.stiffness = vec![vec![3.0, 1.0], vec![1.0, 2.0]];
    lines.slope.row = vec![0.001, 0.002];
    lines.slope.offset = 1e-5;
    lines.slope.amplitude = 2e-6;
    lines.slope.period = 1e-5;
    let found = graze(&lines, 5.0, 100.0);
    let look = |p: f64| {
        let (machine, slope) = lines.at(p).unwrap();
        FreeMotion::new(&machine, &slope).unwrap().least().unwrap()
    };
    let h = 1e-3;
    let (a, b) = (look(found.parameter - h), look(found.parameter + h));
    let e = (b.gap - a.gap) / (2.0 * h);
    assert!((found.map.e / e - 1.0).abs() < 1e-6, "{} {e}", found.map.e);
    assert!((a.gap + b.gap).abs() < 1e-4 * (a.gap - b.gap).abs() && found.at.gap.abs() < 1e-16);
    // At the minimum the rate is 0: its drift moves the phase by −drift/a_G.
    let moved = -(b.phase - a.phase) / (2.0 * h) * found.map.acceleration;
    assert!((found.map.rate_drift / moved - 1.0).abs() < 1e-5, "{} {moved}", found.map.rate_drift);
}

/// The damping of given ratios in modes that the parameter changes, against differences.
#[test]
fn damping_ratios_have_their_derivative() {
    let mut lines = coupled();
    lines.slope.mass = vec![vec![0.3, 0.1], vec![0.1, 0.05]];
    lines.slope.stiffness = vec![vec![300.0, 40.0], vec![40.0, -20.0]];
    lines.slope.period = 0.01;
    let at = |p: f64| Machine {
        damping: vec![],
        damping_ratio: vec![0.02 + 0.1 * p, 0.05],
        ..lines.parts(p).machine()
    };
    let slope = Machine { damping: vec![], damping_ratio: vec![0.1, 0.0], ..lines.slope.machine() };
    let exact = Slope::new(&at(0.1), &slope).unwrap();
    let h = 1e-5;
    let (a, b) = (at(0.1 - h).equations().unwrap(), at(0.1 + h).equations().unwrap());
    for (name, exact, a, b) in [
        ("C", &exact.damping, &a.damping, &b.damping),
        ("M", &exact.mass, &a.mass, &b.mass),
        ("K", &exact.stiffness, &a.stiffness, &b.stiffness),
    ] {
        let differences = (b - a) / (2.0 * h);
        assert!((exact - &differences).norm() < 1e-7 * differences.norm(), "{name}: {exact} {differences}");
    }
}

fn agree(found: &Orbit, known: &alone::Orbit) {
    for (impact, expected) in found.impacts.iter().zip(known.z.chunks(2)) {
        assert!((impact.time - expected[0]).abs() < 1e-10 && (impact.speed - expected[1]).abs() < 1e-10);
    }
    for (a, b) in found.multipliers.iter().zip(known.multipliers.values()) {
        let size = 1.0 + b.0.hypot(b.1);
        assert!((a.0 - b.0).abs() < 1e-9 * size && (a.1 - b.1).abs() < 1e-9 * size, "{a:?} {b:?}");
    }
    let admissible = found.admissibility == Admissibility::Admissible;
    assert_eq!(admissible, known.admissibility.is_admissible(), "{:?}", found.admissibility);
}

#[test]
fn orbits_of_one_degree_of_freedom_are_those_of_the_one_degree_code() {
    let scene = paper_scene();
    let family = SceneFamily::new(&scene, "mu").unwrap();
    let cases: [(&[u32], &[f64], f64); 4] = [
        (&[4], &[-0.77, 0.67], -0.026),
        (&[4], &[-0.77, 0.67], -0.05),
        (&[3, 3], &[-0.0957, 0.0999, -0.008, 0.028], 0.0058),
        // Past its grazing it is behind the stop: no orbit.
        (&[4], &[-0.77, 0.67], -0.0),
    ];
    for (periods, start, mu) in cases {
        let itinerary = alone::Itinerary::at(Side::Lower, periods).unwrap();
        let known =
            alone::find(&alone::Family::at(&family, mu).unwrap(), &itinerary, start.to_vec()).unwrap();
        let found = find(&simulator(&paper().parts(mu).machine()), &single(periods), start).unwrap();
        assert!(found.residual < 1e-13, "{found:?}");
        agree(&found, &known);
    }
    let free = find(&simulator(&paper().parts(-0.05).machine()), &Itinerary::free(2).unwrap(), &[]).unwrap();
    assert_eq!(free.admissibility, Admissibility::Admissible);
    let behind = find(&simulator(&paper().parts(0.05).machine()), &Itinerary::free(1).unwrap(), &[]).unwrap();
    assert!(matches!(behind.admissibility, Admissibility::No(_)), "{behind:?}");
}

/// A ball on a moving table has no periodic motion without impacts; its orbit of one impact a period is found
/// all the same, with the speed that gravity gives back: V(1 + τ) = g T + (1 − τ) v of the table, at T = 2π.
#[test]
fn a_machine_without_stiffness_has_orbits() {
    let parts = Parts {
        mass: vec![vec![3.0]],
        damping: vec![vec![0.0]],
        stiffness: vec![vec![0.0]],
        amplitude: 0.5,
        offset: 0.0,
        restitution: 0.8,
        ..paper().at_zero
    };
    let machine = Machine { force: vec![-3.0 * 0.1], ..parts.machine() };
    let found = find(&simulator(&machine), &single(&[1]), &[0.3, 0.3]);
    let found = found.or_else(|_| find(&simulator(&machine), &single(&[1]), &[6.1, 0.3])).unwrap();
    let (t, v) = (found.impacts[0].time, found.impacts[0].speed);
    // Leaves at table + τV, arrives at table − V: the velocity changes by −g T in between.
    assert!((v * 1.8 - 0.1 * TAU).abs() < 1e-12, "{v}");
    // It rises as far as it falls: its mean velocity is 0.
    let table = -0.5 * t.sin();
    assert!((table + 0.8 * v - 0.1 * TAU / 2.0).abs() < 1e-12, "{t} {v}");
}

#[test]
fn a_simulation_stays_on_a_stable_orbit() {
    let machine = beside(2e-4).parts(-0.05).machine();
    let simulator = simulator(&machine);
    let found = find(&simulator, &single(&[4]), &[-0.77, 0.67]).unwrap();
    assert!(found.residual < 1e-13 && found.admissibility == Admissibility::Admissible, "{found:?}");
    let largest = found.multipliers[0].0.hypot(found.multipliers[0].1);
    assert!(largest < 1.0 && found.multipliers.len() == 4, "{:?}", found.multipliers);
    // A little beside it, to come back; from just after an impact, of which the next is a period away.
    let mut u = found.state.u().to_vec();
    u[1] += 1e-4;
    let begin = Time::new(0, found.state.t);
    let mut run = simulator.start(begin, found.state.q(), &u).unwrap();
    run.finish(begin.after(TAU * 400.0 + 1e-3));
    assert_eq!(run.impacts(), 100);
    let there = run.state();
    let mut again = simulator.start(begin, found.state.q(), found.state.u()).unwrap();
    again.finish(begin.after(1e-3));
    let off = apart(there.q(), again.state().q()).max(apart(there.u(), again.state().u()));
    assert!(off < 1e-9, "{off:e}");
}

/// Theorem 1 in four dimensions against the true system: the leading-order solution is a start for Newton's
/// method, right to first order, and what is found is an orbit exactly where the theorem says.
#[test]
fn the_orbits_born_are_found_in_the_true_system() {
    for (family, start, reach, distance, unit) in
        [(coupled(), 1.0, 200.0, 1e-9, 0.012), (beside(0.01), -0.2, 0.5, 1e-7, 1.0)]
    {
        let grazing = graze(&family, start, reach);
        let map = grazing.map.to_map().unwrap();
        let analysis = Analysis::new(&map, 3, Numbers::Enclosed);
        let mut counts = [0; 2];
        for pattern in (1..=3).flat_map(Patterns::of_period).filter(Pattern::is_primitive) {
            let report = analysis.judge(pattern.periods());
            let periods: Vec<u32> = pattern.periods().iter().map(|&n| n as u32).collect();
            for positive in [true, false] {
                let solve = |distance: f64| {
                    let away = if positive { distance } else { -distance } / grazing.map.e;
                    let impacts = leading_impacts(&report, pattern.periods()).unwrap();
                    let z = grazing.map.start(grazing.at.phase, &impacts, away);
                    let machine = family.parts(grazing.parameter + away).machine();
                    let settings = Settings { minimum_depth: 1e-15 * unit, ..Settings::default() };
                    let simulator = Simulator::new(&machine, &settings).unwrap();
                    let orbit = find(&simulator, &single(&periods), &z)
                        .unwrap_or_else(|error| panic!("{pattern}: {error}"));
                    let error = orbit.impacts.iter().zip(z.chunks(2));
                    let error = error.map(|(impact, z)| (impact.time - z[0]).abs()).fold(0.0, f64::max);
                    (orbit, error)
                };
                let (orbit, close) = solve(distance);
                let exists = report.side() == Some(positive);
                let admissible = orbit.admissibility == Admissibility::Admissible;
                assert_eq!(admissible, exists, "{pattern} {positive}: {orbit:?}");
                counts[usize::from(exists)] += 1;
                let (_, far) = solve(4.0 * distance);
                // Of second order in the time √distance: four times the distance, more than twice as far off.
                assert!(close < 0.4 * far + 1e-9 && far < 1e-2, "{pattern}: {close} {far}");
            }
        }
        assert!(counts[0] > 0 && counts[1] > 0, "{counts:?}");
    }
}

fn told(text: &str) -> Vec<grazing_scenes::run::TaskReport> {
    let scene = Scene::from_toml(text, "test").unwrap();
    grazing_scenes::run::run(&scene, grazing_scenes::run::Surroundings::default(), &mut ()).unwrap()
}

fn reports(text: &str) -> Vec<serde_json::Value> {
    told(text).iter().map(|report| serde_json::to_value(report).unwrap()).collect()
}

/// The tasks of a scene of format 2 against those of format 1.
#[test]
fn tasks_on_a_machine_say_what_they_say_of_the_oscillator() {
    let tasks = "[[tasks]]\nname = \"g\"\nkind = \"grazing\"\nparameter = \"mu\"\ndistance = 1e-7\n\
                 [[tasks]]\nname = \"o\"\nkind = \"orbit\"\norbit = { pattern = [4], starts = 40 }\n\
                 [[tasks]]\nname = \"p\"\nkind = \"orbit\"\norbit = { pattern = [4], start = [START] }\n";
    let machine = reports(&format!("{PAPER_MACHINE}{}", tasks.replace("START", "-0.12254931, 1.4032447")));
    let scene = include_str!("../../examples/scenes/nordmark-2001.toml");
    let scene = scene.split("[[tasks]]").next().unwrap();
    let one = reports(&format!("{scene}{}", tasks.replace("START", "\"-0.77 rad\", 0.67")));
    let number = |value: &serde_json::Value| value.as_f64().unwrap_or_else(|| panic!("{value}"));
    let near = |a: &serde_json::Value, b: &serde_json::Value, factor: f64, size: f64| {
        let (a, b) = (number(a), number(b) * factor);
        assert!((a - b).abs() < size * (1.0 + b.abs()), "{a} {b}");
    };
    let rate = TAU / 3.0;
    let (a, b) = (&machine[0], &one[0]);
    assert!(a["status"] == "done" && a["stop"] == "plate", "{a}");
    near(&a["parameter"], &b["parameter"], 1.0, 1e-10);
    near(&a["acceleration"], &b["acceleration"], rate * rate, 1e-10);
    near(&a["gamma"], &b["gamma"], 1.0 / rate, 1e-10);
    near(&a["a1"], &b["a1"], 1.0, 1e-10);
    near(&a["a2"], &b["a2"], 1.0, 1e-10);
    let (rows, known) = (a["born"].as_array().unwrap(), b["born"].as_array().unwrap());
    assert!(rows.len() == known.len() && rows.len() > 2, "{a} {b}");
    for (row, known) in rows.iter().zip(known) {
        assert!(row["pattern"] == known["pattern"] && row["side"] == known["side"], "{row} {known}");
        assert!(row["admissible"] == true && known["admissible"] == true, "{row} {known}");
        near(&row["coefficient"], &known["coefficient"], 1.0, 1e-8);
        near(&row["speeds"][0], &known["speeds"][0], rate, 1e-9);
        let turn = number(&row["phases"][0]) - number(&known["phases"][0]);
        assert!((turn - turn.round()).abs() < 1e-9, "{row} {known}");
        near(&row["multipliers"][0][0], &known["multipliers"][0][0], 1.0, 1e-6);
    }
    // From the search the orbit of one start, among others perhaps.
    let speed = number(&one[2]["orbits"][0]["speeds"][0]) * rate;
    assert!((number(&machine[2]["orbits"][0]["speeds"][0]) - speed).abs() < 1e-9, "{}", machine[2]);
    let searched = machine[1]["orbits"].as_array().unwrap();
    assert!(searched.iter().any(|row| (number(&row["speeds"][0]) - speed).abs() < 1e-9), "{}", machine[1]);
}

/// Section 4.1 of the paper, w = 4.8, as a machine: A is a turn by π/3 with r = e^{−π/4}, so that A³ = −r³;
/// period 3 is on the singular boundary, and all along its branch both multipliers are r³.
#[test]
fn the_resonance_of_section_4_1_has_its_closed_form() {
    let text = PAPER_MACHINE.replace("w = 4.9", "w = 4.8");
    assert!(text != PAPER_MACHINE);
    let tasks = "[[tasks]]\nname = \"g\"\nkind = \"grazing\"\nparameter = \"mu\"\n\
                 [[tasks]]\nname = \"o\"\nkind = \"orbit\"\nparameter = \"mu\"\nvalues = [1e-2, 1e-4, 1e-8]\n\
                 orbit = { pattern = [3] }\n";
    let told = reports(&format!("{text}{tasks}"));
    let number = |value: &serde_json::Value| value.as_f64().unwrap_or_else(|| panic!("{value}"));
    let near = |a: f64, b: f64, size: f64| assert!((a - b).abs() <= size, "{a} {b}");
    let r = (-PI / 4.0).exp();
    let map = &told[0];
    near(number(&map["parameter"]), 0.0, 1e-14);
    near(number(&map["a1"]), r, 1e-14);
    near(number(&map["a2"]), r * r, 1e-14);
    // The patterns of one impact.
    let rows = map["born"].as_array().unwrap().iter();
    let single = rows.filter(|row| !row["pattern"].as_str().unwrap().contains(','));
    let sides: Vec<&str> = single.map(|row| row["side"].as_str().unwrap()).collect();
    assert_eq!(sides, ["mu > 0", "mu > 0", "open", "mu < 0"], "{map}");
    assert_eq!(map["status"], "undecided");
    let orbits = told[1]["orbits"].as_array().unwrap();
    let admissible: Vec<_> = orbits.iter().filter(|row| row["admissible"] == true).collect();
    assert_eq!(admissible.len(), 3, "{}", told[1]);
    for row in admissible {
        let [first, second] = [0, 1].map(|i| [0, 1].map(|j| number(&row["multipliers"][i][j])));
        // Near the grazing entries are as large as 1/V.
        let size = 1e-12 / number(&row["speeds"][0]);
        near(first[0] + second[0], 2.0 * r.powi(3), size);
        near(first[0] * second[0] - first[1] * second[1], r.powi(6), size);
    }
}

/// However far the search may go, the grazing is the nearest; and a distance that rounding does not leave is
/// said, with no orbit beside it.
#[test]
fn reach_and_distance_may_be_huge_or_tiny() {
    let of = |keys: &str| {
        let text = format!(
            "format = \"grazing-scene 2\"\ntitle = \"t\"\n[parameters]\nF = 1\n[system]\nperiod = \"2*pi\"\n\
             mass = 1\ndamping = 0.1\nstiffness = 3\nforcing = [{{ cos = [\"F\"] }}]\n[[walls]]\nname = \"stop\"\n\
             row = [1]\noffset = -1\nrestitution = 0.5\n[[tasks]]\nname = \"g\"\nkind = \"grazing\"\n\
             parameter = \"F\"\n{keys}\n"
        );
        reports(&text).remove(0)
    };
    // Where |F|/|3 − 1 + i/10| is 1.
    let known = 2.0f64.hypot(0.1);
    for reach in ["2", "1e6", "1e20", "1e300"] {
        let found = of(&format!("reach = {reach}"));
        let parameter = found["parameter"].as_f64().unwrap_or_else(|| panic!("{found}"));
        assert!((parameter / known - 1.0).abs() < 1e-14, "{reach}: {found}");
    }
    for (distance, looked) in [("1e-9", true), ("1e-17", false), ("1e-300", false)] {
        let found = of(&format!("reach = 2\ndistance = {distance}"));
        let rows = found["born"].as_array().unwrap();
        assert!(!rows.is_empty(), "{found}");
        for row in rows {
            assert_eq!(row["found_at"].is_number(), looked, "{row}");
            let said = row["reason"].as_str().is_some_and(|reason| reason.contains("`distance`"));
            assert!(said != looked, "{row}");
        }
    }
}

/// A motion that touches a stop whatever the parameter is: the local theory has nothing to say, and no orbit
/// is looked for infinitely far away.
#[test]
fn a_gap_that_does_not_pass_through_zero_is_left_open() {
    let text = "format = \"grazing-scene 2\"\ntitle = \"t\"\n[parameters]\nr = 0.5\n[system]\nfrequency = 1\nmass = 1\n\
                stiffness = \"4*pi*pi + 1\"\nforcing = [{ k = 1, cos = [1] }]\n\
                [[walls]]\nname = \"below\"\nrow = [1]\noffset = \"-1\"\nrestitution = \"r\"\n\
                [[tasks]]\nname = \"g\"\nkind = \"grazing\"\nparameter = \"r\"\nreach = 0.25\n";
    let report = &reports(text)[0];
    assert!(report["status"] == "undecided" && report["parameter"] == 0.5, "{report}");
    assert!(report["open"].as_str().unwrap().contains("only touches 0"), "{report}");
    assert!(report["born"].as_array().unwrap().is_empty(), "{report}");
}

#[test]
fn several_stops_grazed_at_once_are_left_open_and_wrong_keys_are_named() {
    let stops = "[[walls]]\nname = \"below\"\nrow = [1]\noffset = \"-1\"\nrestitution = 0.5\n\
                 [[walls]]\nname = \"above\"\nrow = [-1]\noffset = \"-1\"\nrestitution = 0.6\n";
    let text = format!(
        "format = \"grazing-scene 2\"\ntitle = \"t\"\n[parameters]\nF = 0.1\n[system]\nfrequency = 1\nmass = 1\nstiffness = 100\ndamping = 1\n\
         forcing = [{{ k = 1, cos = [\"F\"] }}]\n{stops}[[tasks]]\nname = \"g\"\nkind = \"grazing\"\nparameter = \"F\"\nreach = 200\n"
    );
    let report = &reports(&text)[0];
    assert!(report["status"] == "undecided", "{report}");
    let open = report["open"].as_str().unwrap();
    assert!(open.contains("several stops") && open.contains("below") && open.contains("above"), "{open}");
    // At the amplitude of the response, |F| / |100 − Ω² + iΩ| = 1.
    let gain = (100.0 - TAU * TAU).hypot(TAU);
    assert!((report["parameter"].as_f64().unwrap() / gain - 1.0).abs() < 1e-12, "{report}");
    let far = &reports(&text.replace("reach = 200", "reach = 20"))[0];
    assert!(far["status"] == "nothing-found", "{far}");
    let refused = |more: &str, key: &str| {
        let error = Scene::from_toml(&text.replace("reach = 200", more), "test.toml");
        let error =
            error.and_then(|scene| grazing_scenes::run::run(&scene, Default::default(), &mut ()).map(drop));
        let message = error.unwrap_err().to_string();
        assert!(message.contains(key), "{message}");
    };
    refused("orbit = { pattern = [1], stops = [\"below\"] }", "tasks[1].orbit");
    let orbits =
        text.replace("kind = \"grazing\"\nparameter = \"F\"\nreach = 200", "kind = \"orbit\"\nreach = 200");
    let refused = |orbit: &str, key: &str| {
        let error = Scene::from_toml(&orbits.replace("reach = 200", orbit), "test.toml");
        let error =
            error.and_then(|scene| grazing_scenes::run::run(&scene, Default::default(), &mut ()).map(drop));
        let message = error.unwrap_err().to_string();
        assert!(message.contains(key), "{message}");
    };
    refused("orbit = { pattern = [1] }", "below, above");
    refused("orbit = { pattern = [1], stops = [\"left\"] }", "\"left\"");
    refused("orbit = { pattern = [1], walls = [\"lower\"] }", "`stops`");
    refused("orbit = { pattern = [1], stops = [\"below\", \"above\"] }", "1 stops");
    refused("orbit = { pattern = [1], stops = [\"below\"], start = [1] }", "2 numbers");
}

/// e^X by its Taylor series, scaled and squared.
fn exponential(x: &RealMatrix) -> RealMatrix {
    let mut term = RealMatrix::identity(x.nrows(), x.nrows());
    let (mut sum, small) = (term.clone(), x / 1024.0);
    for i in 1..20 {
        term = &term * &small / f64::from(i);
        sum += &term;
    }
    (0..10).fold(sum, |sum, _| &sum * &sum)
}

/// Sixty masses between springs, with dampers of unlike sizes and two gyroscopic pairs: complex modes that
/// repeat what the exponential of the matrix says.
#[test]
fn a_long_chain_without_real_modes_moves_by_the_exponential() {
    let n = 60;
    let part = |i: usize, step: f64| (i as f64 * step).fract();
    let mut damping = RealMatrix::zeros(n, n);
    let mut stiffness = damping.clone();
    let mass = RealMatrix::from_fn(n, n, |i, j| if i == j { 1.0 + part(i, 0.732) } else { 0.0 });
    for i in 0..n {
        let parts = [(&mut stiffness, 30.0 * (0.5 + part(i, 0.618))), (&mut damping, part(i, 0.414))];
        for (all, x) in parts {
            all[(i, i)] += x;
            if i > 0 {
                all[(i - 1, i - 1)] += x;
                all[(i, i - 1)] -= x;
                all[(i - 1, i)] -= x;
            }
        }
        if i % 30 == 29 {
            damping[(i, i - 3)] += 0.5;
            damping[(i - 3, i)] -= 0.5;
        }
    }
    let still = Periodic::constant(RealVector::zeros(n));
    let equations = LinearEquations::new(mass.clone(), damping.clone(), stiffness.clone(), still).unwrap();
    let flow = LinearFlow::new(equations).unwrap();
    assert!(flow.method() == FlowMethod::ComplexModes && flow.condition() < 100.0, "{}", flow.condition());
    let mut a = RealMatrix::zeros(2 * n, 2 * n);
    for i in 0..n {
        a[(i, n + i)] = 1.0;
        for j in 0..n {
            a[(n + i, j)] = -stiffness[(i, j)] / mass[(i, i)];
            a[(n + i, n + j)] = -damping[(i, j)] / mass[(i, i)];
        }
    }
    let off = (flow.transition(0.5) - exponential(&(a * 0.5))).amax();
    assert!(off <= 1e-12, "{off}");
    // One chain of vectors: no modes at all.
    let two = |entries: [f64; 4]| RealMatrix::from_row_slice(2, 2, &entries);
    let still = Periodic::constant(RealVector::zeros(2));
    let (one, c) = (two([1.0, 0.0, 0.0, 1.0]), two([2.0, 1.0, 0.0, 2.0]));
    let flow = LinearFlow::new(LinearEquations::new(one.clone(), c.clone(), one, still).unwrap()).unwrap();
    assert_eq!(flow.method(), FlowMethod::Exponential);
    let mut a = RealMatrix::zeros(4, 4);
    a.view_mut((0, 2), (2, 2)).fill_diagonal(1.0);
    a.view_mut((2, 0), (2, 2)).fill_diagonal(-1.0);
    a.view_mut((2, 2), (2, 2)).copy_from(&-c);
    let off = (flow.transition(7.0) - exponential(&(a * 7.0))).amax();
    assert!(off <= 1e-14, "{off}");
}

/// A symmetric machine that grazes a stop and its mirror: of one coordinate as by the one-degree code; of
/// two, coupled, the symmetric orbit that is born has the closed form of half a period.
#[test]
fn two_stops_that_mirror_each_other_are_one_of_half_a_period() {
    let most = if one_in(2) == 1 { 3 } else { 2 };
    let task = format!(
        "[[tasks]]\nname = \"g\"\nkind = \"grazing\"\nparameter = \"D\"\nmax_period = {most}\ndistance = 1e-5\nreach = 5\n"
    );
    let walls = |row: &str| {
        ["", "-"].map(|sign| {
            let row = row.replace('1', &format!("{sign}1"));
            format!("[[walls]]\nname = \"{sign}\"\nrow = {row}\noffset = -1\nrestitution = 0.7\n")
        })
    };
    let one = format!(
        "format = \"grazing-scene 1\"\ntitle = \"t\"\n[parameters]\nD = 0.5\n[system]\ndamping = 0.1\nstiffness = 0.25\n\
         forcing = [{{ cos = \"D\" }}]\n[[walls]]\nside = \"lower\"\noffset = -1\nrestitution = 0.7\n[[walls]]\nside = \"upper\"\n\
         offset = 1\nrestitution = 0.7\n{task}"
    );
    let machine = format!(
        "format = \"grazing-scene 2\"\ntitle = \"t\"\n[parameters]\nD = 0.5\n[system]\nperiod = \"2*pi\"\nmass = 1\ndamping = 0.1\n\
         stiffness = 0.25\nforcing = [{{ cos = [\"D\"] }}]\n{}{task}",
        walls("[1]").concat()
    );
    // Where chaos is born its entropy is per half period, too.
    for text in [&one, &machine] {
        let text = told(&text.replace("stiffness = 0.25", "stiffness = 4.5"))[0].to_string();
        assert!(text.contains("per half period"), "{text}");
    }
    let (one, machine) = (reports(&one), reports(&machine));
    let number = |value: &serde_json::Value| value.as_f64().unwrap_or_else(|| panic!("{value}"));
    let near = |a: f64, b: f64, size: f64| assert!((a - b).abs() <= size * (1.0 + b.abs()), "{a} {b}");
    let (a, b) = (&machine[0], &one[0]);
    assert!(a["half"] == true && b["half"] == true && a["status"] == "done", "{a} {b}");
    for key in ["parameter", "a1", "a2", "gamma", "e", "acceleration"] {
        near(number(&a[key]), number(&b[key]), 1e-11);
    }
    let (rows, known) = (a["born"].as_array().unwrap(), b["born"].as_array().unwrap());
    assert!(rows.len() == known.len() && !rows.is_empty(), "{a} {b}");
    for (row, known) in rows.iter().zip(known) {
        assert!(row["pattern"] == known["pattern"] && row["side"] == known["side"], "{row} {known}");
        assert!(row["admissible"] == true && known["admissible"] == true, "{row} {known}");
        near(number(&row["coefficient"]), number(&known["coefficient"]), 1e-8);
        let speeds = |row: &serde_json::Value| {
            row["speeds"].as_array().unwrap().iter().map(number).collect::<Vec<_>>()
        };
        assert_eq!(speeds(row).len(), speeds(known).len());
        speeds(row).iter().zip(speeds(known)).for_each(|(a, b)| near(*a, b, 1e-9));
        let multiplier = number(&row["multipliers"][0][0]);
        near(multiplier, number(&known["multipliers"][0][0]), 1e-5);
        // The coefficient is of one round of the pattern; an odd number of halves is gone round twice.
        let pattern: Vec<u32> =
            row["pattern"].as_str().unwrap().split(',').map(|n| n.parse().unwrap()).collect();
        let away = number(&row["found_at"]) - number(&a["parameter"]);
        let once = number(&row["coefficient"]) / away.powi(pattern.len() as i32);
        let whole = if pattern.iter().sum::<u32>() % 2 == 1 { once * once } else { once };
        assert!((multiplier / whole - 1.0).abs() < 0.05, "{pattern:?}: {multiplier} {whole}");
    }

    // Masses 1 and 3 in a row, the force on the second, the first between stops.
    let coupled = format!(
        "format = \"grazing-scene 2\"\ntitle = \"t\"\n[parameters]\nD = 2\n[system]\nperiod = \"2*pi\"\nmass = [[1, 0], [0, 3]]\n\
         damping = [[0.14, -0.09], [-0.09, 0.09]]\nstiffness = [[7.1, -5.5], [-5.5, 5.5]]\nforcing = [{{ cos = [0, \"D\"] }}]\n{}{task}",
        walls("[1, 0]").concat()
    );
    let found = &reports(&coupled)[0];
    assert!(found["half"] == true && found["status"] == "done", "{found}");
    // x″ = −(K x + C x′)/M: the flow over half a period, and the response to a force of 1.
    let field = RealMatrix::from_row_slice(
        4,
        4,
        &[0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, -7.1, 5.5, -0.14, 0.09, 5.5 / 3.0, -5.5 / 3.0, 0.03, -0.03],
    );
    let flow = exponential(&(&field * (TAU / 2.0)));
    let a: Vec<f64> =
        found["A"].as_array().unwrap().iter().flat_map(|row| row.as_array().unwrap()).map(number).collect();
    near((RealMatrix::from_row_slice(4, 4, &a) + &flow).amax(), 0.0, 1e-11);
    // (K − M + iC) z = (0, 1): z₁ = −k₁₂/det with complex entries.
    let times = |(a, b): (f64, f64), (c, d): (f64, f64)| (a * c - b * d, a * d + b * c);
    let (first, second) = (times((6.1, 0.14), (2.5, 0.09)), times((-5.5, -0.09), (-5.5, -0.09)));
    let response = 5.5f64.hypot(0.09) / (first.0 - second.0).hypot(first.1 - second.1);
    near(number(&found["parameter"]), 1.0 / response, 1e-12);
    let symmetric = found["born"].as_array().unwrap().iter().find(|row| row["pattern"] == "1").unwrap();
    assert!(symmetric["admissible"] == true, "{symmetric}");
    let speeds: Vec<f64> = symmetric["speeds"].as_array().unwrap().iter().map(number).collect();
    near(speeds[0], speeds[1], 1e-9);
    // y before the next impact is −(y after this one less the kick): (I + E) y = kick, for a speed of 1.
    let kick = RealMatrix::from_column_slice(4, 1, &[0.0, 0.0, 1.7, 0.0]);
    let y = (RealMatrix::identity(4, 4) + flow).lu().solve(&kick).unwrap();
    let (place, rate) = (-1.0 - y[0] * speeds[0], (1.0 + y[2] - 1.7) * speeds[0]);
    near(place.hypot(rate), number(&symmetric["found_at"]) * response, 1e-11);
}
