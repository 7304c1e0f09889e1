//! Orbits through contact with stops that give way.

use grazing_scenes::{
    continuation::PatternFamily,
    many::{branch::Patterns, orbit::find_from},
};

use super::{second::Motion, *};
use grazing_scenes::many::{SpeedLaw, State, simulate::Event};

fn entries(n: usize, rows: &[f64]) -> Vec<(usize, usize, f64)> {
    rows.iter().enumerate().map(|(k, x)| (k / n, k % n, *x)).collect()
}

/// The columns of a map's Jacobian at a point, by central differences.
fn columns(map: impl Fn([f64; 2]) -> [f64; 2], x: [f64; 2], h: f64) -> [[f64; 2]; 2] {
    [0, 1].map(|j| {
        let moved = |h: f64| {
            let mut x = x;
            x[j] += h;
            map(x)
        };
        let (more, less) = (moved(h), moved(-h));
        [0, 1].map(|i| (more[i] - less[i]) / (2.0 * h))
    })
}

fn soft(row: &[f64], offset: f64, stiffness: f64, damping: f64) -> Stop<f64> {
    let wall = Wall { offset, harmonics: vec![], restitution: 0.0 };
    let law = StopLaw::Soft { stiffness, damping };
    Stop { name: format!("{row:?}"), row: row.to_vec(), wall, law }
}

fn machine(
    n: usize,
    [mass, damping, stiffness]: [&[f64]; 3],
    cos: &[f64],
    stops: Vec<Stop<f64>>,
) -> Machine<f64> {
    Machine {
        size: n,
        period: TAU,
        mass: entries(n, mass),
        damping: entries(n, damping),
        damping_ratio: vec![],
        stiffness: entries(n, stiffness),
        shapes: vec![],
        force: vec![],
        forcing: vec![Load { k: 1, cos: cos.to_vec(), sin: vec![0.0; n] }],
        smooth: vec![],
        record: None,
        friction: vec![],
        stops,
    }
}

fn simulator(machine: &Machine<f64>) -> Simulator {
    Simulator::new(machine, &Settings::default()).unwrap()
}

fn state(q: &[f64], u: &[f64]) -> State {
    State::new(0.0, q, u)
}

/// Without damping the symmetric motion under F cos t between two soft stops is even about t = 0 and odd
/// about t = π/2: beyond the gap q* + A cos Ωt + F/(Ω² − 1) cos t, within B sin ω(π/2 − t) + F/(ω² − 1) cos
/// t; one equation says when it passes from one to the other.
#[test]
fn the_symmetric_orbit_of_the_bilinear_oscillator_has_a_closed_form() {
    for (k, stop, gap, force) in
        [(0.4f64, 6.0f64, 0.7f64, 2.0f64), (0.3, 50.0, 0.5, 1.5), (2.2, 9.0, 0.4, 1.0)]
    {
        let (w, omega) = (k.sqrt(), (k + stop).sqrt());
        let (far, near) = (force / (omega * omega - 1.0), force / (w * w - 1.0));
        let centre = stop * gap / (omega * omega);
        let parts = |t: f64| {
            let a = (gap - centre - far * t.cos()) / (omega * t).cos();
            let b = (gap - near * t.cos()) / (w * (TAU / 4.0 - t)).sin();
            let out = -a * omega * (omega * t).sin() - far * t.sin();
            (a, out - (-b * w * (w * (TAU / 4.0 - t)).cos() - near * t.sin()))
        };
        // All signs of the difference, poles left out by its size; the motion must leave the gap there.
        let mut found = 0;
        let grid = 20_000;
        for i in 1..grid {
            let (mut low, mut high) =
                (TAU / 4.0 * f64::from(i) / f64::from(grid), TAU / 4.0 * f64::from(i + 1) / f64::from(grid));
            if high >= TAU / 4.0 || (parts(low).1 > 0.0) == (parts(high).1 > 0.0) || parts(low).1.abs() > 1.0
            {
                continue;
            }
            for _ in 0..100 {
                let middle = (low + high) / 2.0;
                let same = (parts(middle).1 > 0.0) == (parts(low).1 > 0.0);
                *(if same { &mut low } else { &mut high }) = middle;
            }
            let (a, _) = parts(low);
            let q0 = centre + a + far;
            let at = |t: f64| centre + a * (omega * t).cos() + far * t.cos();
            let inner = |t: f64| {
                let b = (gap - near * low.cos()) / (w * (TAU / 4.0 - low)).sin();
                b * (w * (TAU / 4.0 - t)).sin() + near * t.cos()
            };
            let beyond = (0..200).all(|j| at(low * f64::from(j) / 200.0) > gap);
            let within = (1..200).all(|j| inner(low + (TAU / 4.0 - low) * f64::from(j) / 200.0).abs() < gap);
            if !(beyond && within) {
                continue;
            }
            found += 1;
            let stops = vec![soft(&[1.0], -gap, stop, 0.0), soft(&[-1.0], -gap, stop, 0.0)];
            let machine = machine(1, [&[1.0], &[0.0], &[k]], &[force], stops);
            let start = state(&[q0 * (1.0 + 1e-5)], &[1e-5]);
            let orbit =
                find_from(&simulator(&machine), &Itinerary::free(1).unwrap(), &[], Some(&start)).unwrap();
            let off = (orbit.state.q()[0] - q0).abs().max(orbit.state.u()[0].abs());
            println!("k = {k}, stop {stop}: q(0) = {q0}, off by {off:e}, {:?}", orbit.multipliers);
            assert!(off < 1e-10, "{off:e}");
            assert_eq!(orbit.admissibility, Admissibility::Admissible);
            let area: f64 = orbit.multipliers.iter().map(|x| x.0.hypot(x.1)).product();
            assert!((area - 1.0).abs() < 1e-9);
        }
        assert!(found > 0, "{k} {stop}");
    }
}

/// The orbit returns by the second integrator, and its multipliers are those of differences of that
/// integrator's period map: with damping at the stops, with a rigid stop beside.
#[test]
fn soft_orbits_return_and_their_multipliers_are_those_of_differences() {
    let one = machine(1, [&[1.0], &[0.15], &[0.4]], &[1.0], vec![soft(&[1.0], -0.3, 9.0, 1.2)]);
    let pair = machine(
        2,
        [&[2.0, 0.3, 0.3, 0.5], &[0.4, -0.05, -0.05, 0.3], &[3.0, -1.0, -1.0, 2.0]],
        &[1.5, -0.6],
        vec![soft(&[-1.0, 1.0], -0.3, 8.0, 0.7), soft(&[1.0, 0.0], -0.4, 5.0, 0.0)],
    );
    for machine in [one, pair] {
        let (n, simulator) = (machine.size, simulator(&machine));
        let mut run = simulator.start(Time::new(0, 0.0), &vec![0.0; n], &vec![0.0; n]).unwrap();
        run.finish(Time::new(400, 0.0));
        let orbit = (1..=4)
            .find_map(|period| {
                let pattern = Itinerary::free(period).unwrap();
                find_from(&simulator, &pattern, &[], Some(&run.state())).ok()
            })
            .expect("a periodic orbit");
        let map = |x: &[f64]| {
            let mut motion = Motion::new(&machine, &x[..n], &x[n..]);
            motion.follow(TAU * f64::from(orbit.itinerary.periods()));
            let touched = motion.contacts.len();
            ([motion.q.clone(), motion.u.clone()].concat(), touched)
        };
        let x: Vec<f64> = orbit.state.q().iter().chain(orbit.state.u()).copied().collect();
        let (back, touched) = map(&x);
        assert!(touched > 0);
        let off = x.iter().zip(&back).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-10, "{off:e}");
        let h = 1e-5;
        let columns: Vec<RealVector> = (0..2 * n)
            .map(|j| {
                let moved = |h: f64| {
                    let mut x = x.clone();
                    x[j] += h;
                    RealVector::from_vec(map(&x).0)
                };
                (moved(h) - moved(-h)) / (2.0 * h)
            })
            .collect();
        let differences = RealMatrix::from_columns(&columns);
        let trace: f64 = orbit.multipliers.iter().map(|x| x.0).sum();
        let product =
            orbit.multipliers.iter().fold((1.0, 0.0), |(a, b), (c, d)| (a * c - b * d, a * d + b * c)).0;
        println!("{:?} {} {}", orbit.multipliers, differences.trace(), differences.determinant());
        assert!((trace - differences.trace()).abs() < 1e-7, "{trace} {}", differences.trace());
        assert!((product - differences.determinant()).abs() < 1e-7);
    }
}

/// An orbit whose impacts have a restitution that depends on their speed, beside a soft stop: its multipliers
/// are those of differences of the second integrator's map of a period.
#[test]
fn multipliers_know_how_restitution_changes_with_the_speed() {
    for beside in [None, Some(soft(&[-1.0], -0.6, 5.0, 0.4))] {
        let law = SpeedLaw { text: "law".into(), over: vec![0.8], under: vec![1.0, 0.7] };
        let mut rigid = soft(&[1.0], -0.4, 1.0, 0.0);
        (rigid.name, rigid.law) = ("rigid".into(), StopLaw::Speed(law));
        let machine =
            machine(1, [&[1.0], &[0.2], &[0.3]], &[1.0], std::iter::once(rigid).chain(beside).collect());
        let simulator = simulator(&machine);
        let mut run = simulator.start(Time::new(0, 0.0), &[0.0], &[0.0]).unwrap();
        run.finish(Time::new(600, 0.0));
        let before = run.state();
        let mut hits = Vec::new();
        let mut after = None;
        let period = (1..=6)
            .find(|&period: &i64| {
                loop {
                    match run.next(Time::new(600 + period, 0.0)) {
                        Event::Impact(hit) => {
                            after.get_or_insert_with(|| run.state());
                            hits.push((hit.time, -hit.velocity));
                        }
                        Event::End(_) => break,
                        _ => {}
                    }
                }
                apart(run.state().q(), before.q()) < 1e-7
            })
            .expect("periodic");
        let strikes = (0..hits.len()).map(|i| {
            let next = hits.get(i + 1).map_or(hits[0].0.period + period, |next| next.0.period);
            Strike { place: 0, periods: (next - hits[i].0.period) as u32 }
        });
        let pattern = Itinerary::new(strikes.collect()).unwrap();
        let start: Vec<f64> = hits.iter().flat_map(|(time, speed)| [time.phase, *speed]).collect();
        let orbit = find_from(&simulator, &pattern, &start, after.as_ref()).unwrap();
        let map = |x: [f64; 2]| {
            let mut motion = Motion::new(&machine, &x[..1], &x[1..]);
            motion.follow(TAU * period as f64);
            [motion.q[0], motion.u[0]]
        };
        let [a, b] = columns(map, [before.q()[0], before.u()[0]], 1e-5);
        let (trace, determinant) = (a[0] + b[1], a[0] * b[1] - a[1] * b[0]);
        let [first, second] = [orbit.multipliers[0], orbit.multipliers[1]];
        println!("period {period}, {} impacts: {:?}, {trace} {determinant}", hits.len(), orbit.multipliers);
        assert!((first.0 + second.0 - trace).abs() < 1e-6);
        assert!((first.0 * second.0 - first.1 * second.1 - determinant).abs() < 1e-6);
    }
}

/// A machine every coefficient of which changes with the parameter, those of its soft stop among them.
struct Changing;

impl Family for Changing {
    fn at(&self, p: f64) -> Result<(Machine<f64>, Machine<f64>), Error> {
        let make = |value: f64, one: f64| {
            // Coefficients a + b p, or their derivative b.
            let c = |a: f64, b: f64| a * one + b * value;
            let mut stop = soft(&[c(-1.0, 0.2), c(0.8, -0.1)], c(-0.2, 0.1), c(9.0, 3.0), c(0.8, 0.5));
            stop.wall.harmonics = vec![Harmonic { k: 1, cos: c(0.05, 0.1), sin: 0.0 }];
            let rows = |a: [f64; 4], b: [f64; 4]| -> Vec<f64> { (0..4).map(|i| c(a[i], b[i])).collect() };
            let law = SpeedLaw {
                text: "law".into(),
                over: vec![c(0.9, 0.2), c(0.1, 0.1)],
                under: vec![c(1.0, 0.0), c(0.5, -0.2), c(0.05, 0.1)],
            };
            let mut rigid = soft(&[c(0.1, 0.3), c(1.0, -0.2)], c(-1.0, 0.3), 1.0, 0.0);
            (rigid.name, rigid.law) = ("rigid".into(), StopLaw::Speed(law));
            let mut machine = machine(
                2,
                [
                    &rows([2.0, 0.3, 0.3, 0.5], [0.3, 0.1, 0.1, 0.2]),
                    &rows([0.4, -0.05, -0.05, 0.3], [0.1, 0.0, 0.2, 0.1]),
                    &rows([3.0, -1.0, -1.0, 2.0], [1.0, 0.5, 0.5, -0.4]),
                ],
                &[c(1.5, 0.3), c(-0.6, 0.2)],
                vec![stop, rigid],
            );
            machine.period = c(5.0, 0.7);
            machine
        };
        Ok((make(p, 1.0), make(1.0, 0.0)))
    }
}

#[test]
fn the_equations_of_soft_orbits_change_with_a_parameter_as_differences_say() {
    let family = Changing;
    let patterns = Patterns::new(&family, 0.0, None).unwrap();
    let z = [0.1, -0.3, 0.5, -0.4];
    let struck = Itinerary::new(vec![Strike { place: 1, periods: 1 }]).unwrap();
    for (pattern, z) in
        [(Itinerary::free(1).unwrap(), z.to_vec()), (struck, vec![0.1, -0.3, 0.5, -0.4, 0.7, 0.6])]
    {
        let at = |p: f64, z: &[f64]| patterns.equations(p, &pattern, z).unwrap();
        let (exact, h) = (at(0.1, &z), 1e-5);
        let (more, less) = (at(0.1 + h, &z), at(0.1 - h, &z));
        for i in 0..z.len() {
            let slope = (more.residual[i] - less.residual[i]) / (2.0 * h);
            let found = exact.slope[i];
            assert!((slope - found).abs() < 1e-6 * (1.0 + slope.abs()), "{i}: {slope} {found}");
            for j in 0..z.len() {
                let moved = |h: f64| {
                    let mut z = z.clone();
                    z[j] += h;
                    at(0.1, &z).residual[i]
                };
                let slope = (moved(h) - moved(-h)) / (2.0 * h);
                let found = exact.jacobian[i][j];
                assert!((slope - found).abs() < 1e-6 * (1.0 + slope.abs()), "{i} {j}: {slope} {found}");
            }
        }
    }
    // There is contact on the way.
    let (machine, _) = family.at(0.1).unwrap();
    let scale = simulator(&machine).scale();
    let mut touched = 0;
    let simulator = simulator(&machine);
    let [q, u] = [&z[..2], &z[2..]].map(|part| part.iter().map(|x| x * scale).collect::<Vec<_>>());
    let mut run = simulator.start(Time::new(0, 0.0), &q, &u).unwrap();
    run.record(Time::new(1, 0.0), |_| touched += 1);
    assert!(touched > 1, "{touched}");
}

/// The bilinear oscillator's branch grazes its second spring at F² = (1 − w²)² + 4ζ²w²: it has a label there
/// and goes on, and up to it multipliers are those of the linear oscillator. The labels beyond are those of
/// contact: at a flip the second integrator's period map has a multiplier −1.
#[test]
fn a_branch_goes_on_beyond_the_grazing_of_a_soft_stop() {
    let file = std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
        .join("examples/machines/bilinear.toml");
    let text = std::fs::read_to_string(file).unwrap();
    let head = text.split("[[tasks]]").next().unwrap();
    let task = "[[tasks]]\nname = \"b\"\nkind = \"branch\"\nparameter = \"F\"\nrange = [0.3, 0.54]\n\
                starts = [{ attractor = { q = 0 } }]\n";
    let report = &reports(&format!("{head}{task}"))[0];
    let (w, zeta) = (0.7f64, 0.075f64);
    let grazing = ((1.0 - w * w).powi(2) + 4.0 * (zeta * w).powi(2)).sqrt();
    let [touch, labels @ ..] = &report["labels"].as_array().unwrap()[..] else { panic!("{report}") };
    assert_eq!(touch["label"], "grazing 1", "{report}");
    assert!((touch["parameters"][0].as_f64().unwrap() - grazing).abs() < 1e-11, "{touch}");
    let start = &report["starts"][0];
    for end in ["backward", "forward"] {
        assert_eq!(start[end], "a parameter is at its bound", "{report}");
    }
    assert!(!labels.is_empty(), "{report}");
    for label in labels {
        let at = label["parameters"][0].as_f64().unwrap();
        assert!(label["label"].as_str().unwrap().starts_with("flip") && at > grazing + 1e-3, "{label}");
    }
    let flip = labels[0]["parameters"][0].as_f64().unwrap();
    let scene = Scene::from_toml(&format!("{head}{task}"), "bilinear").unwrap();
    let orbit = |force: f64| {
        let machine = scene.machine(&[("F", force)]).unwrap();
        let near = scene.machine(&[("F", force.min(grazing + 0.004))]).unwrap();
        let settled = simulator(&near);
        let mut run = settled.start(Time::new(0, 0.0), &[0.0], &[0.0]).unwrap();
        run.finish(Time::new(300, 0.0));
        let found =
            find_from(&simulator(&machine), &Itinerary::free(1).unwrap(), &[], Some(&run.state())).unwrap();
        (machine, found)
    };
    for force in [0.3, grazing - 1e-6] {
        let (_, found) = orbit(force);
        let size: f64 = found.multipliers.iter().map(|x| x.0.hypot(x.1)).product();
        assert!((size - (-2.0 * zeta * TAU / w).exp()).abs() < 1e-12, "{force}: {size}");
        let angle = found.multipliers[0].1.atan2(found.multipliers[0].0).cos();
        assert!((angle - ((1.0 - zeta * zeta).sqrt() * TAU / w).cos()).abs() < 1e-10, "{force}: {angle}");
    }
    // The second integrator knows machines of period 2π: time is scaled by w.
    let (machine, found) = orbit(flip);
    let scaled = super::soft_orbits::machine(
        1,
        [&[w * w], &[2.0 * zeta * w], &[1.0]],
        &[flip],
        vec![soft(&[-1.0], -1.0, 4.0, 0.0)],
    );
    assert!((machine.period - TAU / w).abs() < 1e-12);
    let map = |x: [f64; 2]| {
        let mut motion = Motion::new(&scaled, &x[..1], &x[1..]);
        motion.follow(TAU);
        [motion.q[0], motion.u[0]]
    };
    let [a, b] = columns(map, [found.state.q()[0], found.state.u()[0]], 1e-5);
    let fold = 1.0 + a[0] + b[1] + a[0] * b[1] - a[1] * b[0];
    println!("grazing at {grazing}, flip at {flip}: {fold:e}");
    assert!(fold.abs() < 1e-5, "{fold:e}");
}
