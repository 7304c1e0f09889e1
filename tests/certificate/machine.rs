//! Certificates of machines: orbits of one coordinate against the proofs in balls and version 1, machines of
//! up to three against the simulator; damage is rejected unless what is said is still true.

use crate::common;
use crate::samples::{samples, tried};
use crate::systems;

use std::{
    f64::consts::TAU,
    ops::{AddAssign, SubAssign},
};

use common::damage::{damage, damaged};
use grazing_scenes::{
    certificate::{self, Rejection, machine as listed},
    many::{
        Machine,
        orbit::{Itinerary, Orbit, Strike, find},
        simulate::{Settings, Simulator},
    },
    motion::{Harmonic, Side, Wall},
    run::{Findings, Surroundings, run},
    scene::Scene,
    search::{
        machine::{Bounds, ProvedMachineOrbit, listed as list, orbit as prove_machine},
        orbit::{ProvedOrbit, Stability, Verdict},
    },
};
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};
use proptest::strategy::{Strategy, ValueTree};
use systems::{Case, cases, number, prove, proved};

fn check(text: &str) -> Result<certificate::Checked, Rejection> {
    certificate::check(&mut text.as_bytes())
}

fn exact(x: &BigRational) -> Bounds {
    [x.clone(), x.clone()]
}

/// Digits of 2π, between which it lies.
fn turn() -> Bounds {
    ["6.283185307179586476925286766559", "6.283185307179586476925286766560"].map(number)
}

/// An oscillator as a machine of one coordinate, its walls as stops with the rows 1 and −1, made as a
/// certificate lists it.
pub(crate) fn as_machine(case: &Case) -> (Machine<Bounds>, Vec<Side>) {
    let system = &case.system;
    let zero = BigRational::zero();
    let mut sides = Vec::new();
    let mut stops = Vec::new();
    for side in [Side::Lower, Side::Upper] {
        let Some(wall) = system.wall(side) else { continue };
        let sign = BigRational::from_integer(if side == Side::Lower { 1 } else { -1 }.into());
        let harmonic = |h: &Harmonic<BigRational>| Harmonic {
            k: h.k,
            cos: exact(&(&h.cos * &sign)),
            sin: exact(&(&h.sin * &sign)),
        };
        let wall = Wall {
            offset: exact(&(&wall.offset * &sign)),
            harmonics: wall.harmonics.iter().map(harmonic).collect(),
            restitution: exact(&wall.restitution),
        };
        stops.push(grazing_scenes::many::Stop {
            name: side.name().into(),
            row: vec![exact(&sign)],
            wall,
            law: grazing_scenes::many::StopLaw::Newton,
        });
        sides.push(side);
    }
    let load = |h: &Harmonic<BigRational>| grazing_scenes::many::Load {
        k: h.k,
        cos: vec![exact(&h.cos)],
        sin: vec![exact(&h.sin)],
    };
    let one = exact(&BigRational::from_integer(1.into()));
    let machine = Machine {
        size: 1,
        period: turn(),
        mass: vec![(0, 0, one)],
        damping: vec![(0, 0, exact(&system.damping))],
        damping_ratio: Vec::new(),
        stiffness: vec![(0, 0, exact(&system.stiffness))],
        shapes: Vec::new(),
        force: vec![exact(if system.force.is_zero() { &zero } else { &system.force })],
        forcing: system.forcing.iter().map(load).collect(),
        smooth: Vec::new(),
        record: None,
        friction: vec![],
        stops,
    };
    (machine, sides)
}

/// What follows the motions of the least of each coefficient, in floats.
pub(crate) fn plainly(machine: &Machine<Bounds>) -> Simulator {
    let plain = machine.try_map(|x| Ok::<f64, ()>(x[0].to_f64().unwrap())).unwrap();
    Simulator::new(&plain, &Settings { minimum_depth: 1e-12, ..Settings::default() }).unwrap()
}

/// The orbit of a case in floats, found from what the proof in balls says.
fn near(case: &Case, machine: &Machine<Bounds>, sides: &[Side], known: &ProvedOrbit) -> Orbit {
    let simulator = plainly(machine);
    let strike = |impact: &grazing_scenes::search::orbit::ExpectedImpact| Strike {
        place: sides.iter().position(|&side| side == impact.side).unwrap(),
        periods: impact.periods,
    };
    let pattern = Itinerary::new(case.impacts.iter().map(strike).collect()).unwrap();
    let float = |x: &grazing_scenes::number::Ball| x.exact_bounds().unwrap().0.to_f64().unwrap();
    let start: Vec<f64> =
        known.phases.iter().zip(&known.velocities).flat_map(|(t, v)| [float(t), float(v)]).collect();
    find(&simulator, &pattern, &start).unwrap()
}

fn proved_machine(machine: &Machine<Bounds>, near: &Orbit) -> ProvedMachineOrbit {
    match prove_machine(&list(machine).unwrap(), near, &mut || false).unwrap() {
        Verdict::Proved(proof) => proof,
        other => panic!("{other:?}"),
    }
}

/// One coordinate: what the checker of machines encloses is what balls and closed forms enclose, to 10⁻¹⁷.
#[test]
fn oscillators_as_machines_have_the_same_orbits() {
    let mut count = 0;
    for case in cases() {
        let known = proved(prove(&case.system, &case.impacts));
        let (machine, sides) = as_machine(&case);
        let proof = proved_machine(&machine, &near(&case, &machine, &sides, &known));
        let checked = check(proof.accepted.text()).unwrap();
        let periods = u64::from(case.impacts.iter().map(|impact| impact.periods).sum::<u32>());
        assert_eq!(
            (checked.kind, checked.range),
            ("machine-orbit", Some(periods..=periods)),
            "{}",
            case.name
        );
        assert!(number(&proof.certificate.within.to_string()) <= number("1e-15"), "{}", case.name);
        for (i, impact) in proof.certificate.impacts.iter().enumerate() {
            let (lo, hi) = known.phases[i].exact_bounds().unwrap();
            let phase = number(&impact.phase.to_string());
            // The period is 2π but for 10⁻³⁰, which is carried along for some hundred radians.
            let near = number(&proof.certificate.within.to_string()) + number("1e-24");
            assert!(&lo - &near < phase && phase < hi + near, "{}", case.name);
            let (lo, hi) = known.velocities[i].exact_bounds().unwrap();
            let (from, to) = proof.speeds[i].exact_bounds().unwrap();
            assert!(from <= hi && lo <= to, "{}", case.name);
        }
        let claim = match case.stability {
            Stability::Stable => listed::Claim::Stable,
            Stability::Unstable => listed::Claim::Unstable,
        };
        assert_eq!(proof.certificate.claim, claim, "{}", case.name);
        count += 1;
    }
    assert!(count >= 5);
}

/// A chain of masses on springs between the ground and its stop, driven at its end.
fn chain(n: usize, damping: &str) -> String {
    let diagonal = |x: &str| vec![x; n].join(", ");
    let row = |i: usize| -> String {
        let entry = |j: usize| match i.abs_diff(j) {
            0 => "40",
            1 => "-20",
            _ => "0",
        };
        format!("[{}]", (0..n).map(entry).collect::<Vec<_>>().join(", "))
    };
    let unit =
        |at: usize, x: &str| (0..n).map(|i| if i == at { x } else { "0" }).collect::<Vec<_>>().join(", ");
    format!(
        r#"format = "grazing-scene 2"
title = "a chain"
[system]
frequency = "5/pi"
mass = {{ diagonal = [{}] }}
stiffness = [{}]
damping = {{ diagonal = [{}] }}
forcing = [{{ k = 1, cos = [{}] }}, {{ k = 2, sin = [{}] }}]
[[walls]]
name = "end"
row = [{}]
offset = "-0.05"
restitution = "0.7"
[[walls]]
name = "other side"
row = [{}]
offset = "-2"
restitution = "sqrt(2)/2"
harmonics = [{{ k = 1, cos = 0.1 }}]
[[tasks]]
name = "proof"
kind = "validate"
orbit = {{ pattern = [1], stops = ["end"], speed = 6, starts = 100 }}
"#,
        diagonal("1"),
        (0..n).map(row).collect::<Vec<_>>().join(", "),
        diagonal(damping),
        unit(0, "\"30*exp(0)\""),
        unit(0, "\"pi\""),
        unit(n - 1, "1"),
        unit(n - 1, "-1"),
    )
}

/// Machines of one to three coordinates, from their scenes: the numbers between which phases and speeds lie
/// hold those that the simulator follows.
#[test]
fn chains_are_proved_and_the_simulator_follows_them() {
    for n in 1..=3 {
        let scene = Scene::from_toml(&chain(n, "2"), "chain.toml").unwrap();
        let reports = run(&scene, Surroundings::default(), &mut ()).unwrap();
        let Findings::Validate(found) = reports[0].findings.as_ref().unwrap() else { panic!() };
        let rows: Vec<_> = found.proofs.iter().filter(|row| row.proved.verdict == "proved").collect();
        assert!(!rows.is_empty(), "{n}: {:?}", found.proofs);
        assert_eq!(rows.len(), found.certificates.len());
        for (row, one) in rows.iter().zip(&found.certificates) {
            let text = one.accepted.text();
            let checked = check(text).unwrap();
            assert_eq!((checked.kind, checked.statement), ("machine-orbit", listed::STATEMENT));
            let digits = |list: &Option<Vec<String>>| -> f64 { list.as_ref().unwrap()[0].parse().unwrap() };
            // 20 digits agree with the float solution to rounding.
            assert!(
                (digits(&row.proved.phases) - row.solution[0]).rem_euclid(1.0).min(1.0) < 1e-9
                    || (row.solution[0] - digits(&row.proved.phases)).rem_euclid(1.0) < 1e-9
            );
            assert!((digits(&row.proved.speeds) - row.solution[1]).abs() < 1e-9 * row.solution[1]);
            follow(&scene, text);
        }
    }
}

/// The simulator, begun just before the first impact of the certificate's middle, comes to the same state a
/// period later.
fn follow(scene: &Scene, text: &str) {
    let machine = scene.machine(&[]).unwrap();
    let simulator =
        Simulator::new(&machine, &Settings { minimum_depth: 1e-12, ..Settings::default() }).unwrap();
    let words = |start: &str| -> Vec<String> {
        let line = text.lines().find(|line| line.starts_with(start)).unwrap();
        line.split(' ').skip(1).map(String::from).collect()
    };
    let impact = words("impact");
    let numbers: Vec<f64> = impact[2..].iter().map(|x| x.parse().unwrap()).collect();
    let (n, phase) = (machine.size, numbers[0]);
    // Begin a little later than the impact, by its law.
    let contact = &simulator.contacts().all()[0];
    let place = contact.position.at(phase);
    let u = nalgebra::DVector::from_column_slice(&numbers[1 + n..]);
    let speed = place[1] - contact.row.dot(&u);
    let push = simulator.contacts().push(0)
        * ((1.0 + contact.restitution) * speed / simulator.contacts().mobility(0));
    let after =
        grazing_scenes::many::State::new(phase.rem_euclid(TAU), &numbers[1..1 + n], (&u + push).as_slice());
    let step = 1e-3;
    let soon = simulator.flow().after(&after, step);
    let begin = grazing_scenes::motion::Time::new(0, phase.rem_euclid(TAU) + step);
    let mut run = simulator.start(begin, soon.q(), soon.u()).unwrap();
    let mut impacts = 0;
    let end = grazing_scenes::motion::Time::new(1, phase.rem_euclid(TAU) + step);
    run.record(end, |event| {
        if let grazing_scenes::many::simulate::Event::Impact(impact) = event {
            assert!((impact.velocity.abs() - speed).abs() < 1e-8 * (1.0 + speed));
            impacts += 1;
        }
    });
    assert_eq!(impacts, 1);
    let state = run.state();
    let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart(state.q(), soon.q()) < 1e-8 && apart(state.u(), soon.u()) < 1e-7);
}

/// A line of a certificate with its words after the first.
fn lines<'t>(text: &'t str, start: &str) -> Vec<Vec<&'t str>> {
    let all = text.lines().filter(|line| line.split(' ').next() == Some(start));
    all.map(|line| line.split(' ').skip(1).collect()).collect()
}

/// Whether what an accepted certificate says is true, by another route: the machine is the same (its digest),
/// one impact, and the orbit that all orbits near are is in both of its boxes. The solution is `state`, to
/// many digits.
fn is_true(text: &str, original: &str, solution: &[BigRational], fixed: &Fixed, multiplier: f64) -> bool {
    let head = |text: &str| -> Vec<String> {
        text.lines().skip(4).take_while(|line| !line.starts_with("orbit")).map(String::from).collect()
    };
    let pattern = |text: &str| {
        lines(text, "impact").iter().map(|w| (w[0].to_string(), w[1].to_string())).collect::<Vec<_>>()
    };
    if head(text) != head(original) || pattern(text) != pattern(original) {
        return false;
    }
    let centre: Vec<BigRational> =
        lines(text, "impact").iter().flat_map(|w| w[2..].iter().map(|x| number(x))).collect();
    let scales = [vec![number("1")], lines(text, "scales")[0].iter().map(|x| number(x)).collect()].concat();
    let [radius, within] = [0, 1].map(|i| number(lines(text, "radius")[0][i]));
    let tiny = number("1e-18");
    let inside = solution.iter().zip(&centre).enumerate().all(|(i, (x, c))| {
        let scale = &scales[i % scales.len()];
        (x - c).abs() <= &within * scale + &tiny && within < radius
    });
    let claim = match lines(text, "orbit")[0][1] {
        "stable" => multiplier < 1.0,
        "unstable" => multiplier > 1.0,
        claim => claim == "open",
    };
    inside && claim && only(fixed, &centre, &scales, &radius)
}

/// Whether no second solution shows in the box: from corners of it Newton's method, in floats, comes to the
/// one in it or leaves the box.
fn only(fixed: &Fixed, centre: &[BigRational], scales: &[BigRational], radius: &BigRational) -> bool {
    let float = |x: &BigRational| x.to_f64().unwrap();
    let (radius, centre): (f64, Vec<f64>) = (float(radius), centre.iter().map(float).collect());
    let scales: Vec<f64> = scales.iter().map(float).collect();
    let mut found: Vec<f64> = Vec::new();
    // One impact: all is told by its phase, as the equations are linear in the state.
    for part in -20..=20 {
        let Some(t) = fixed.newton(centre[0] + radius * f64::from(part) / 20.0) else { continue };
        let state = fixed.at(t);
        let within = (t - centre[0]).abs() <= radius
            && state.iter().enumerate().all(|(j, x)| (x - centre[1 + j]).abs() <= radius * scales[1 + j]);
        if within && found.iter().all(|known| (known - t).abs() > 1e-7) {
            found.push(t);
        }
    }
    found.len() <= 1
}

/// The orbits of one impact at a stop that stands still, of a machine with one harmonic: for every phase
/// there is one state that comes back, and what is left is one equation, that its gap is 0. With eigenvalues
/// of nobody: the flow by many small steps of a Runge–Kutta method.
struct Fixed {
    n: usize,
    matrix: nalgebra::DMatrix<f64>,
    force: [nalgebra::DVector<f64>; 2],
    row: nalgebra::DVector<f64>,
    kick: nalgebra::DVector<f64>,
    offset: f64,
    periods: f64,
    states: [nalgebra::DVector<f64>; 2],
}

impl Fixed {
    fn of(text: &str) -> Fixed {
        let value = |word: &str| -> f64 {
            let (lo, hi) = word.split_once("..").unwrap();
            (lo.parse::<f64>().unwrap() + hi.parse::<f64>().unwrap()) / 2.0
        };
        let rows = |name: &str| -> Vec<Vec<f64>> {
            lines(text, name).iter().map(|words| words.iter().map(|x| value(x)).collect()).collect()
        };
        let vector = |list: &[f64]| nalgebra::DVector::from_column_slice(list);
        let (mass, damping, stiffness) = (rows("mass"), rows("damping"), rows("stiffness"));
        let n = mass.len();
        let square = |rows: &[Vec<f64>]| nalgebra::DMatrix::from_fn(n, n, |i, j| rows[i][j]);
        let mass = nalgebra::DMatrix::from_fn(n, n, |i, j| mass[i.max(j)][i.min(j)]);
        let inverse = mass.try_inverse().unwrap();
        let unit = value(lines(text, "period")[0][0]) / TAU;
        let mut matrix = nalgebra::DMatrix::zeros(2 * n, 2 * n);
        matrix.view_mut((0, n), (n, n)).fill_with_identity();
        matrix.view_mut((n, 0), (n, n)).copy_from(&(-&inverse * square(&stiffness) * unit * unit));
        matrix.view_mut((n, n), (n, n)).copy_from(&(-&inverse * square(&damping) * unit));
        let load: Vec<f64> = lines(text, "harmonic")[0][1..].iter().map(|x| value(x)).collect();
        let force = [0, 1].map(|part| &inverse * vector(&load[part * n..(part + 1) * n]) * unit * unit);
        let row = vector(&rows("direction")[0]);
        let stop = lines(text, "stop");
        let push = &inverse * &row;
        let kick = &push * ((1.0 + value(stop[0][1])) / row.dot(&push));
        let periods = lines(text, "impact")[0][1].parse().unwrap();
        let states = [0, 1].map(|_| nalgebra::DVector::zeros(0));
        let mut fixed = Fixed { n, matrix, force, row, kick, offset: value(stop[0][0]), periods, states };
        fixed.states = [0.0, TAU / 4.0].map(|t| fixed.state(t));
        fixed
    }

    fn field(&self, t: f64, x: &nalgebra::DVector<f64>, forced: bool) -> nalgebra::DVector<f64> {
        let mut all = &self.matrix * x;
        if forced {
            let here = &self.force[0] * t.cos() + &self.force[1] * t.sin();
            all.rows_mut(self.n, self.n).add_assign(&here);
        }
        all
    }

    /// The state a period of the orbit later.
    fn flown(&self, t: f64, x: &nalgebra::DVector<f64>, forced: bool) -> nalgebra::DVector<f64> {
        let steps = 400.0 * self.periods;
        let h = TAU * self.periods / steps;
        let mut x = x.clone();
        for i in 0..steps as u32 {
            let t = t + f64::from(i) * h;
            let a = self.field(t, &x, forced);
            let b = self.field(t + h / 2.0, &(&x + &a * (h / 2.0)), forced);
            let c = self.field(t + h / 2.0, &(&x + &b * (h / 2.0)), forced);
            let d = self.field(t + h, &(&x + &c * h), forced);
            x += (a + b * 2.0 + c * 2.0 + d) * (h / 6.0);
        }
        x
    }

    /// The state just before the impact at phase t that comes back after it.
    fn state(&self, t: f64) -> nalgebra::DVector<f64> {
        let zero = nalgebra::DVector::zeros(2 * self.n);
        let kicked = |x: &nalgebra::DVector<f64>| {
            let mut after = x.clone();
            let rate = self.row.dot(&x.rows(self.n, self.n));
            after.rows_mut(self.n, self.n).axpy(-rate, &self.kick, 1.0);
            after
        };
        let mut map = nalgebra::DMatrix::identity(2 * self.n, 2 * self.n);
        for j in 0..2 * self.n {
            let mut unit = zero.clone();
            unit[j] = 1.0;
            let image = self.flown(t, &kicked(&unit), false);
            map.column_mut(j).sub_assign(&image);
        }
        map.lu().solve(&self.flown(t, &zero, true)).unwrap()
    }

    /// The same at any phase: by the phases 0 and π/2, as a force at phase t is a mixture of those.
    fn at(&self, t: f64) -> nalgebra::DVector<f64> {
        &self.states[0] * t.cos() + &self.states[1] * t.sin()
    }

    fn gap(&self, t: f64) -> f64 {
        self.row.dot(&self.at(t).rows(0, self.n)) - self.offset
    }

    fn newton(&self, start: f64) -> Option<f64> {
        let mut t = start;
        for _ in 0..20 {
            let (z, h) = (self.gap(t), 1e-5);
            let step = z / ((self.gap(t + h) - self.gap(t - h)) / (2.0 * h));
            t -= step;
            if step.abs() < 1e-10 {
                return Some(t);
            }
            if step.is_nan() || step.abs() >= 10.0 {
                return None;
            }
        }
        None
    }
}

const MASSES: &str = include_str!("../../crates/checker/tests/data/machine-masses.txt");

/// Thousands of damaged certificates of two masses; those that pass are confirmed true by a Runge–Kutta
/// method and Newton's.
#[test]
fn damage_is_detected() {
    let mut runner = common::runner(1);
    let strategy = damage();
    let impact = lines(MASSES, "impact")[0].clone();
    let solution: Vec<BigRational> = impact[2..].iter().map(|x| number(x)).collect();
    // The solution is one, by a route of its own.
    let fixed = Fixed::of(MASSES);
    let t = fixed.newton(solution[0].to_f64().unwrap()).unwrap();
    assert!((t - solution[0].to_f64().unwrap()).abs() < 1e-7);
    for (x, known) in fixed.at(t).iter().zip(&solution[1..]) {
        assert!((x - known.to_f64().unwrap()).abs() < 1e-8);
    }
    // Its multipliers are inside the unit circle: the example's report says 0.66.
    assert!(is_true(MASSES, MASSES, &solution, &fixed, 0.66));
    let body = MASSES.lines().position(|line| line.starts_with("orbit")).unwrap();
    let (mut rejected, mut unchanged, mut still_true) = (0, 0, 0);
    for round in 0..samples::<u64>(600) {
        let damage = strategy.new_tree(&mut runner).unwrap().current();
        let changed = damaged(MASSES, if round % 2 == 0 { 0 } else { body }, &damage);
        if changed == MASSES {
            unchanged += 1;
        } else if check(&changed).is_ok() {
            assert!(
                is_true(&changed, MASSES, &solution, &fixed, 0.66),
                "accepted though false, after {damage:?}:\n{changed}"
            );
            still_true += 1;
        } else {
            rejected += 1;
        }
    }
    println!("{rejected} rejected, {still_true} still true, {unchanged} unchanged");
    assert!(rejected > 2 * still_true && tried(still_true, 10));
}

/// What the method cannot do is said in one sentence.
#[test]
fn limits_are_said() {
    let answer = |text: &str| -> String {
        let scene = match Scene::from_toml(text, "chain.toml") {
            Ok(scene) => scene,
            Err(error) => return error.to_string(),
        };
        match run(&scene, Surroundings::default(), &mut ()) {
            Ok(reports) => format!("{:?} {:?}", reports[0].status, reports[0].findings),
            Err(error) => error.to_string(),
        }
    };
    let text = chain(2, "2");
    let cases = [
        (
            text.replace("pattern = [1], stops = [\"end\"]", "period = 1"),
            "must have an impact to be validated",
        ),
        (
            text.replace("kind = \"validate\"", "kind = \"validate\"\nevent = \"flip\"\nparameter = \"a\""),
            "is proved with one degree of freedom and rigid stops, by the engine \"one\"",
        ),
        (
            text.replace("damping = { diagonal = [2, 2] }", "damping_ratio = 0.1"),
            "`damping_ratio` of several coordinates is not enclosed",
        ),
        (chain(9, "2"), "the machine has 9 coordinates and 2 stops; proofs hold up to 8 and 16"),
    ];
    for (text, expected) in cases {
        let said = answer(&text);
        assert!(said.contains(expected), "{said}, expected {expected}");
    }
}
