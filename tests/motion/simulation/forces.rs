//! Forces that are formulas: against a second integrator that shares no code with `src`, against the cubic
//! oscillator moved aside, against differences, and where they are not smooth.

use std::f64::consts::TAU;

use grazing_scenes::{
    attractor::lyapunov::exponents,
    continuation::{Bifurcation, Criticality, NormalForm, Sense},
    many,
    motion::{Counts, Effect, Flow, RunEnd, State, System, Time, flow::Free},
    one::{
        attractor::{lyapunov, manifold::reversed},
        orbit::{Family, Itinerary, Oscillator, find, monodromy, return_map},
        simulate::{Event, Settings, Simulator},
    },
    scene::{Scene, SceneFamily},
};

use proptest::prelude::{ProptestConfig, proptest};

use super::{at, bare, events, impacts, wall};

/// A scene with parameters a = 0.4, b = 0.7.
fn scene(system: &str, walls: &str) -> Scene {
    let text = format!(
        "format = \"grazing-scene 1\"\ntitle = \"force\"\n[parameters]\na = 0.4\nb = 0.7\n[system]\n{system}\n{walls}"
    );
    Scene::from_toml(&text, "force.toml").unwrap_or_else(|error| panic!("{error}"))
}

fn formula(force: &str) -> System<f64> {
    scene(&format!("force = \"{force}\""), "").plain(&[]).unwrap()
}

/// A wall: its sign, its place and speed at t, its restitution.
type Place = (f64, fn(f64) -> [f64; 2], f64);

/// (q, u) → (q′, u′) followed by extrapolated midpoint steps, impacts by sign changes of the gaps and
/// bisection.
struct Second<'a> {
    acceleration: &'a dyn Fn(f64, f64, f64) -> f64,
    walls: &'a [Place],
    t: f64,
    x: [f64; 2],
}

impl Second<'_> {
    fn after(&self, h: f64) -> [f64; 2] {
        let slope = |t: f64, x: [f64; 2]| [x[1], (self.acceleration)(t, x[0], x[1])];
        let add = |x: [f64; 2], d: [f64; 2], h: f64| [x[0] + h * d[0], x[1] + h * d[1]];
        let mut table: Vec<[f64; 2]> = Vec::new();
        for i in 1..=8usize {
            let step = h / (2 * i) as f64;
            let (mut before, mut now) = (self.x, add(self.x, slope(self.t, self.x), step));
            for j in 1..2 * i {
                let next = add(before, slope(self.t + j as f64 * step, now), 2.0 * step);
                (before, now) = (now, next);
            }
            let end = add(before, slope(self.t + h, now), step);
            let mut last = [(now[0] + end[0]) / 2.0, (now[1] + end[1]) / 2.0];
            let mut next = vec![last];
            for (j, old) in table.iter().enumerate() {
                let ratio = (i as f64 / (i - 1 - j) as f64).powi(2) - 1.0;
                last = [last[0] + (last[0] - old[0]) / ratio, last[1] + (last[1] - old[1]) / ratio];
                next.push(last);
            }
            table = next;
        }
        *table.last().unwrap()
    }

    /// Times and relative velocities of the impacts up to a time.
    fn follow(&mut self, until: f64) -> Vec<(f64, f64)> {
        let mut hits = Vec::new();
        while self.t < until {
            let h = 0.08f64.min(until - self.t);
            let gap = |sign: f64, place: fn(f64) -> [f64; 2], h: f64| {
                sign * (self.after(h)[0] - place(self.t + h)[0])
            };
            let mut first: Option<(f64, usize)> = None;
            for (i, &(sign, place, _)) in self.walls.iter().enumerate() {
                // Not the zero that an impact leaves behind.
                let mut low = if gap(sign, place, 0.0) > 1e-9 { 0.0 } else { h / 16.0 };
                if gap(sign, place, h) < 0.0 && gap(sign, place, low) > 0.0 {
                    let mut high = h;
                    for _ in 0..60 {
                        let middle = (low + high) / 2.0;
                        if gap(sign, place, middle) > 0.0 { low = middle } else { high = middle }
                    }
                    if first.is_none_or(|known| high < known.0) {
                        first = Some((high, i));
                    }
                }
            }
            let step = first.map_or(h, |hit| hit.0);
            self.x = self.after(step);
            self.t += step;
            if let Some((_, i)) = first {
                let (sign, place, tau) = self.walls[i];
                let speed = place(self.t)[1];
                hits.push((self.t, sign * (self.x[1] - speed)));
                self.x[1] = speed - tau * (self.x[1] - speed);
            }
        }
        hits
    }
}

type Walls = Vec<Place>;

struct Case {
    name: &'static str,
    force: &'static str,
    acceleration: fn(f64, f64, f64) -> f64,
    toml: &'static str,
    walls: Walls,
}

const HIGH: &str = "[[walls]]\nside = \"upper\"\noffset = 1\nrestitution = 0.9";
const MOVING: &str =
    "[[walls]]\nside = \"lower\"\noffset = -0.6\nharmonics = [{ sin = 0.1 }]\nrestitution = 0.7";
const BOTH: &str = "[[walls]]\nside = \"lower\"\noffset = -0.5\nrestitution = 0.8\n\
                    [[walls]]\nside = \"upper\"\noffset = 1\nrestitution = 0.9";

fn cases() -> Vec<Case> {
    let low = || -> Walls { vec![(1.0, |_| [-0.5, 0.0], 0.8)] };
    let high = || -> Walls { vec![(-1.0, |_| [1.0, 0.0], 0.9)] };
    let moving = || -> Walls { vec![(1.0, |t: f64| [-0.6 + 0.1 * t.sin(), 0.1 * t.cos()], 0.7)] };
    vec![
        Case {
            name: "pendulum",
            force: "-0.1*u - sin(q) + (a + 0.4)*cos(t)",
            acceleration: |t, q, u| -0.1 * u - q.sin() + 0.8 * t.cos(),
            toml: BOTH,
            walls: [low(), high()].concat(),
        },
        Case {
            name: "van der Pol",
            force: "2*a*(1 - q^2)*u - q + 0.5*cos(2*t)",
            acceleration: |t, q, u| 0.8 * (1.0 - q * q) * u - q + 0.5 * (2.0 * t).cos(),
            toml: HIGH,
            walls: high(),
        },
        Case {
            name: "electrostatic",
            force: "-0.2*u - q + 0.1/(2 - q)^2 + cos(t)*b",
            acceleration: |t, q, u| -0.2 * u - q + 0.1 / ((2.0 - q) * (2.0 - q)) + 0.7 * t.cos(),
            toml: HIGH,
            walls: high(),
        },
        Case {
            name: "Morse",
            force: "2*(exp(-2*q) - exp(-q)) - 0.05*u + 0.3*sin(t)",
            acceleration: |t, q, u| 2.0 * ((-2.0 * q).exp() - (-q).exp()) - 0.05 * u + 0.3 * t.sin(),
            toml: HIGH,
            walls: high(),
        },
        Case {
            name: "every function",
            force: "-tanh(2*q) - 0.1*log(1 + q^2)*u + sqrt(1 + q^2)*sin(t - q)*a - q^3/(1 + cos(q)^2)",
            acceleration: |t, q, u| {
                -(2.0 * q).tanh() - 0.1 * (1.0 + q * q).ln() * u + (1.0 + q * q).sqrt() * (t - q).sin() * 0.4
                    - q.powi(3) / (1.0 + q.cos().powi(2))
            },
            toml: MOVING,
            walls: moving(),
        },
        Case {
            name: "driven pendulum, moved at its hinge",
            force: "-(1 + a*cos(2*t + 0.3))*sin(q) - 0.05*u - u^3/20 + b*cos(t)",
            acceleration: |t, q, u| {
                -(1.0 + 0.4 * (2.0 * t + 0.3).cos()) * q.sin() - 0.05 * u - u.powi(3) / 20.0 + 0.7 * t.cos()
            },
            toml: MOVING,
            walls: moving(),
        },
    ]
}

const START: [f64; 3] = [0.3, 0.2, 1.5];

/// To 10⁻¹² of the time before amplification, which is measured.
#[test]
fn formulas_agree_with_a_second_integrator() {
    for case in cases() {
        let system = scene(&format!("force = \"{}\"", case.force), case.toml).plain(&[]).unwrap();
        let settings = Settings { tolerance: 1e-15, ..Settings::default() };
        let ours = Simulator::new(&system, &settings).unwrap();
        let [t, q, u] = START;
        let until = t + 6.0 * TAU;
        let hits = |q: f64| -> Vec<(f64, f64)> {
            let found = impacts(&mut ours.start(at(t), q, u).unwrap(), at(0.0).after(until));
            found.iter().map(|hit| (hit.time.since(at(0.0)), hit.velocity)).collect()
        };
        let (found, nudged) = (hits(q), hits(q + 1e-8));
        let mut second = Second { acceleration: &case.acceleration, walls: &case.walls, t, x: [q, u] };
        let known = second.follow(until);
        assert_eq!(found.len(), known.len(), "{}: {found:?} {known:?}", case.name);
        assert!(known.len() >= 3, "{}: {} impacts, {known:?}", case.name, known.len());
        let (mut amplification, mut worst) = (1.0f64, 0.0f64);
        for (i, (a, b)) in found.iter().zip(&known).enumerate() {
            if let Some(moved) = nudged.get(i) {
                amplification = amplification.max((moved.0 - a.0).abs().max((moved.1 - a.1).abs()) / 1e-8);
            }
            let off = (a.0 - b.0).abs().max((a.1 - b.1).abs());
            worst = worst.max(off / amplification / b.0.max(1.0));
            assert!(
                off <= 1e-12 * amplification * b.0.max(1.0),
                "{}: impact {i} {a:?} {b:?}, {amplification:e}",
                case.name
            );
        }
        println!("{}: {} impacts, worst {worst:.1e}, amplified {amplification:.1e}", case.name, known.len());
    }
}

/// What is linear, cubic or a harmonic in a formula is the same as its own key, to the last bit.
#[test]
fn what_a_formula_has_of_other_keys_is_the_same_as_these() {
    let walls = "[[walls]]\nside = \"lower\"\noffset = -0.5\nrestitution = 0.8";
    let keys = scene(
        "damping = 0.1\nstiffness = \"a\"\ncubic = \"b\"\nforce = 0.2\nforcing = [{ cos = 1.5, sin = 0.5 }, { k = 3, sin = \"a\" }]",
        walls,
    );
    let one = scene("force = \"-0.1*u - a*q - b*q^3 + 0.2 + 1.5*cos(t) + 0.5*sin(t) + a*sin(3*t)\"", walls);
    let two = scene(
        "damping = 0.1\nforcing = [{ k = 3, sin = \"a\" }]\nforce = \"-q*(a) - q*q*q*b + 0.2 + 1.5*cos(-t) - sin(-t)/2\"",
        walls,
    );
    let run = |scene: &Scene| {
        let simulator = Simulator::new(&scene.plain(&[]).unwrap(), &Settings::default()).unwrap();
        let mut run = simulator.start(at(0.3), 0.2, 1.5).unwrap();
        let all = events(&mut run, Time::new(40, 0.0));
        format!("{all:?} {:?}", run.state())
    };
    assert_eq!(run(&keys), run(&one));
    assert_eq!(run(&keys), run(&two));
    // A linear one has a closed form, and a coefficient of 0 is not there.
    let flow = |force: &str| Free::new(&formula(force), 1e-12).unwrap();
    assert!(matches!(flow("-q - 0.1*u + a*cos(t) + 0*sin(q) + (b - 0.7)*exp(q)"), Free::Linear(_)));
    assert!(matches!(flow("-q - 0.1*u + a*cos(t)*q"), Free::Taylor(_)));
}

/// The cubic oscillator, and the same moved by 1/4 and written as a formula that is not recognised: the same
/// impacts, rests, exponents and derivatives.
#[test]
fn a_cubic_oscillator_moved_aside_has_the_same_motions() {
    let cubic = System { cubic: 0.7, ..bare(0.1, 0.4) };
    for (offset, motion, tau, weight) in
        [(-0.5, vec![], 0.8, 0.0), (-0.3, vec![(1, 0.0, 0.8), (3, 0.0, 0.02)], 0.3, 1.0)]
    {
        let forcing = vec![grazing_scenes::motion::Harmonic { k: 1, cos: 1.2, sin: 0.0 }];
        let here =
            System { force: -weight, forcing, lower: Some(wall(offset, tau, &motion)), ..cubic.clone() };
        let moved = System {
            lower: Some(wall(offset + 0.25, tau, &motion)),
            force: -weight,
            ..formula("-0.1*u - 0.4*(q - 1/4) - 0.7*(q - 1/4)^3 + 1.2*cos(t)")
        };
        let [one, two] = [&here, &moved].map(|system| Simulator::new(system, &Settings::default()).unwrap());
        let follow = |simulator: &Simulator, q: f64| {
            let mut run = simulator.start(at(0.3), q, 1.5).unwrap();
            events(&mut run, Time::new(20, 0.0)).0
        };
        let (a, b, nudged) = (follow(&one, 0.3), follow(&two, 0.55), follow(&one, 0.3 + 1e-9));
        assert!(a.len() >= 20, "{} events", a.len());
        assert_eq!(a.len(), b.len());
        let mut amplification = 1.0f64;
        for (i, (a, b)) in a.iter().zip(&b).enumerate() {
            assert_eq!(std::mem::discriminant(a), std::mem::discriminant(b), "{i}: {a:?} {b:?}");
            let (s, t) = (a.time().unwrap(), b.time().unwrap());
            if let Some(moved) = nudged.get(i).and_then(Event::time) {
                amplification = amplification.max(moved.since(s).abs() / 1e-9);
            }
            // Rest is the limit of many impacts, whose times are known to the minimum depth.
            let bound = if tau < 0.5 { 1e-9 } else { 1e-13 * s.since(at(0.0)).max(1.0) };
            assert!(t.since(s).abs() <= bound * amplification, "{i}: {a:?} {b:?} {amplification:e}");
        }
        if tau < 0.5 {
            assert!(a.iter().any(|event| matches!(event, Event::Release(_))), "{} events", a.len());
        } else {
            let rate =
                |simulator: &Simulator, q| lyapunov(simulator, at(0.3), [q, 1.5], 20, 100, &()).unwrap().rate;
            assert!((rate(&one, 0.3) - rate(&two, 0.55)).abs() < 1e-3);
        }
    }
}

#[test]
fn the_variation_of_a_formula_is_its_derivative() {
    for case in cases() {
        let flow = Free::new(&formula(case.force), 1e-14).unwrap();
        let start = State { t: 0.3, q: 0.1, u: 0.2 };
        for duration in [1.3, -0.4] {
            let (end, matrix) = flow.advance_linearised(start, duration);
            let plain = flow.advance(start, duration);
            assert!((end.q - plain.q).abs().max((end.u - plain.u).abs()) < 1e-12, "{}", case.name);
            let h = 1e-5;
            for (j, [dq, du]) in [[h, 0.0], [0.0, h]].into_iter().enumerate() {
                let go = |f: f64| flow.advance(State { q: 0.1 + f * dq, u: 0.2 + f * du, ..start }, duration);
                // Of fourth order: the error is 10⁻²⁰ and rounding.
                let slope = |part: fn(State) -> f64| {
                    let at = |f| part(go(f));
                    (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * h)
                };
                for (i, slope) in [slope(|x| x.q), slope(|x| x.u)].into_iter().enumerate() {
                    let off = (slope - matrix[i][j]).abs();
                    assert!(off < 2e-9, "{} {i}{j} over {duration}: off by {off:e}", case.name);
                }
            }
        }
    }
}

/// By a parameter that stands in the formula, recognised or not, and elsewhere.
#[test]
fn the_derivative_in_a_parameter_is_that_of_the_motion() {
    for force in
        ["-a*q - a^2*u/3 + a*cos(t)", "-sin(a*q)/a - 0.1*u*a + a^2*cos(t)", "-a*q^3 + sin(a)*exp(-q)"]
    {
        let scene = scene(&format!("damping = \"a/5\"\nforce = \"{force}\""), "");
        let family = SceneFamily::new(&scene, "a").unwrap();
        let start = State { t: 0.3, q: 0.1, u: 0.2 };
        let leg = |a: f64| family.at(a).unwrap().leg(start, 2.5);
        let (here, h) = (leg(0.4), 1e-5);
        for i in 0..2 {
            let at = |f: f64| {
                let end = leg(0.4 + f * h).end;
                [end.q, end.u][i]
            };
            let slope = (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * h);
            assert!((slope - here.slope[i]).abs() < 1e-8, "{force}: {slope} {:?}", here.slope);
        }
    }
}

/// The expansion of the Poincaré map to third order.
#[test]
fn the_return_map_of_a_cubic_oscillator_moved_aside_is_the_same() {
    let forcing = vec![grazing_scenes::motion::Harmonic { k: 1, cos: 0.3, sin: 0.0 }];
    let here = Oscillator::new(System { forcing, cubic: 0.7, ..bare(0.2, 0.4) }, 1e-13).unwrap();
    let moved = formula("-0.2*u - 0.4*(q - 1/4) - 0.7*(q - 1/4)^3 + 0.3*cos(t)");
    let moved = Oscillator::new(moved, 1e-13).unwrap();
    let free = Itinerary::free(1).unwrap();
    // Where the motion from rest ends.
    let simulator = Simulator::new(here.system(), &Settings::default()).unwrap();
    let mut run = simulator.start(at(0.0), 0.0, 0.0).unwrap();
    run.finish(Time::new(100, 0.0));
    let State { q, u, .. } = run.state();
    let one = find(&here, &free, vec![q, u]).unwrap();
    let two = find(&moved, &free, vec![q + 0.25, u]).unwrap();
    assert!((two.z[0] - one.z[0] - 0.25).abs() < 1e-12 && (two.z[1] - one.z[1]).abs() < 1e-12);
    let [a, b] = [return_map(&here, &free, &one.z).unwrap(), return_map(&moved, &free, &two.z).unwrap()];
    for (a, b) in a.iter().zip(&b) {
        for (i, j) in [(1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3)] {
            let off = (a.coefficient(i, j) - b.coefficient(i, j)).abs();
            assert!(off < 1e-10 * (1.0 + a.size()), "x^{i} y^{j}: {a:?} {b:?}");
        }
    }
}

/// How far a pole, a root or a logarithm lets a motion go, and why it ends there.
/// Their product is the determinant of the monodromy matrix, which is made of other numbers.
#[test]
fn the_multipliers_of_a_formula_have_the_product_that_areas_shrink_by() {
    let wall = "[[walls]]\nside = \"lower\"\noffset = -0.5\nrestitution = 0.9";
    for (force, impacts) in [
        ("-0.2*u - q + 0.3*cos(2*t) - 0.4*u^3", false),
        ("-0.2*u*exp(-q) - sin(q) + 0.3*cos(t)", false),
        ("-0.1*u*(2 + cos(t)) - q - 0.5*u^3 + cos(t)", true),
    ] {
        let scene = scene(&format!("force = \"{force}\""), if impacts { wall } else { "" });
        let oscillator = Oscillator::new(scene.plain(&[]).unwrap(), 1e-15).unwrap();
        let itinerary = match impacts {
            true => Itinerary::at(grazing_scenes::motion::Side::Lower, &[1]).unwrap(),
            false => Itinerary::free(1).unwrap(),
        };
        let start = if impacts { vec![3.0, 0.5] } else { vec![0.0, 0.0] };
        let orbit = find(&oscillator, &itinerary, start).unwrap();
        let m = monodromy(&oscillator, &itinerary, &orbit.z).unwrap();
        let product = m[0][0] * m[1][1] - m[0][1] * m[1][0];
        let found = orbit.multipliers.determinant;
        assert!((found - product).abs() < 1e-12 && found < 0.9, "{force}: {found} {product}");
    }
}

/// q″ = ∓q²q′ − w²q about rest: by averaging the amplitude a of q obeys a′ = ∓a³/8, so that with |ζ| = a
/// √(1+w²)/2 a period of 2π has Re d = ∓π/(1 + w²).
#[test]
fn with_nonlinear_damping_a_neimark_sacker_point_has_a_direction() {
    for (sign, sense) in [("-", Criticality::Supercritical), ("+", Criticality::Subcritical)] {
        for w in [0.7_f64, 1.3, 2.2] {
            let system = formula(&format!("{sign}q^2*u - {}*q + 0*cos(t)", w * w));
            let oscillator = Oscillator::new(system, 1e-15).unwrap();
            let orbit = find(&oscillator, &Itinerary::free(1).unwrap(), vec![0.0, 0.0]).unwrap();
            let form = NormalForm::at(&oscillator, &orbit, Bifurcation::Torus).unwrap();
            let expected = std::f64::consts::PI / (1.0 + w * w) * if sign == "-" { -1.0 } else { 1.0 };
            assert!((form.coefficient - expected).abs() < 1e-9, "{w}: {form:?}, {expected}");
            assert_eq!(form.kind, Sense::Born(sense));
        }
    }
    // Areas shrink alike along all motions, or motions go backwards as they go forwards: Re d is zero, and
    // that is said.
    for force in ["0.3*q^3 - 0.49*q - sin(q)", "-q*u^2 - 0.49*q"] {
        let oscillator = Oscillator::new(formula(force), 1e-15).unwrap();
        let orbit = find(&oscillator, &Itinerary::free(1).unwrap(), vec![0.0, 0.0]).unwrap();
        let form = NormalForm::at(&oscillator, &orbit, Bifurcation::Torus).unwrap();
        assert_eq!(form.kind, Sense::Degenerate, "{force}: {form:?}");
    }
}

/// The sum of both exponents is the mean of ∂q″/∂q′, however fast areas shrink.
#[test]
fn exponents_of_strongly_damped_motions_have_the_sum_that_areas_shrink_by() {
    for (force, sum) in [("-200*u - 30*sin(q) + 40*cos(t)", -200.0), ("-3*u - sin(q) + cos(t)", -3.0)] {
        let simulator = Simulator::new(&formula(force), &Settings::default()).unwrap();
        let start = State { t: 0.0, q: 0.3, u: 0.0 };
        let all = exponents(&simulator, &start, 2, 2, 5, &()).unwrap();
        let found = all[0].rate + all[1].rate;
        assert!((found - sum).abs() < 1e-7 * -sum, "{force}: {found}");
    }
}

/// The motion of the reversed system leads back; a formula's velocity and time are turned round as well.
#[test]
fn a_formula_is_run_backwards() {
    let wall = "[[walls]]\nside = \"lower\"\noffset = -0.6\nrestitution = 0.8\nharmonics = [{ sin = 0.1 }]";
    for force in ["-sin(q) + 0.9*sin(t)", "-q - 0.1*u^3 + u*cos(t)/4 + sin(t + 1)", "tanh(q + u/3) - q^3 - q"]
    {
        let system = scene(&format!("damping = 0.1\nforcing = [{{ sin = 0.4 }}]\nforce = \"{force}\""), wall);
        let system = system.plain(&[]).unwrap();
        let run = |system: &System<f64>, from: f64, [q, u]: [f64; 2]| {
            let simulator = Simulator::new(system, &Settings::default()).unwrap();
            let mut run = simulator.start(at(from), q, u).unwrap();
            assert_eq!(run.finish(at(from + 9.0)), RunEnd::Reached);
            let state = run.state();
            assert!(run.impacts() > 0, "{force}");
            [state.q, state.u]
        };
        let there = run(&system, 1.0, [0.3, -0.8]);
        let back = run(&reversed(&system).unwrap(), -10.0, [there[0], -there[1]]);
        assert!((back[0] - 0.3).abs().max((back[1] - 0.8).abs()) < 1e-7, "{force}: {back:?}");
    }
}

/// Forces that change over a width w about s = c, s being the displacement, the velocity or the time.
#[derive(Debug, Clone, Copy)]
struct Steep {
    kind: usize,
    width: f64,
    centre: f64,
    strength: f64,
}

impl Steep {
    fn text(&self) -> String {
        let Steep { kind, width: w, centre: c, strength: a } = self;
        let part = match kind {
            0 => format!("-{a}*tanh(u/{w})"),
            1 => format!("{a}*tanh((q - {c})/{w})"),
            2 => format!("{a}*exp(-((q - {c})/{w})^2)"),
            3 => format!("{a}/(1 + ((q - {c})/{w})^2)"),
            4 => format!("{a}*exp(-((u - {c})/{w})^2)"),
            5 => format!("{a}*tanh(3*exp(-((q - {c})/{w})^2))"),
            6 => format!("{a}*tanh(sin(q - {c})/{w})*(1 + cos(t)/2)"),
            7 => format!("{a}*sqrt({w}^2 + (q - {c})^2)"),
            8 => format!("{a}/5*log({w}^2 + (q - {c})^2)"),
            9 => format!("{a}*exp((cos(t - {c} - 1) - 1)/{w}^2)"),
            _ => format!("{a}*u/sqrt({w}^2 + u^2)*exp(-q^2)"),
        };
        format!("-q - 0.05*u + cos(2*t) + {part}")
    }

    fn acceleration(&self, t: f64, q: f64, u: f64) -> f64 {
        let Steep { kind, width: w, centre: c, strength: a } = *self;
        let z = (q - c) / w;
        let part = match kind {
            0 => -a * (u / w).tanh(),
            1 => a * z.tanh(),
            2 => a * (-z * z).exp(),
            3 => a / (1.0 + z * z),
            4 => a * (-((u - c) / w).powi(2)).exp(),
            5 => a * (3.0 * (-z * z).exp()).tanh(),
            6 => a * ((q - c).sin() / w).tanh() * (1.0 + t.cos() / 2.0),
            7 => a * (w * w + (q - c) * (q - c)).sqrt(),
            8 => a / 5.0 * (w * w + (q - c) * (q - c)).ln(),
            9 => a * (((t - c - 1.0).cos() - 1.0) / (w * w)).exp(),
            _ => a * u / (w * w + u * u).sqrt() * (-q * q).exp(),
        };
        -q - 0.05 * u + (2.0 * t).cos() + part
    }

    /// How far s is from its centre.
    fn distance(&self, t: f64, [q, u]: [f64; 2]) -> f64 {
        match self.kind {
            0 | 10 => u.abs(),
            4 => (u - self.centre).abs(),
            9 => ((t - self.centre - 1.0 + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0).abs(),
            _ => (q - self.centre).abs(),
        }
    }

    /// By the second integrator, on steps that are short beside the layer and beside the way to it: no speed
    /// is above 4.
    fn second(&self, start: [f64; 2], until: f64) -> [f64; 2] {
        let acceleration = |t: f64, q: f64, u: f64| self.acceleration(t, q, u);
        let mut second = Second { acceleration: &acceleration, walls: &[], t: 0.0, x: start };
        while second.t < until {
            let room = (self.distance(second.t, second.x) + self.width) / 16.0;
            let h = room.min(0.04).min(until - second.t);
            second.x = second.after(h);
            second.t += h;
        }
        second.x
    }
}

/// Motions through steep forces, as oscillators and as machines, against the second integrator.
fn steep_motions_agree(case: Steep, start: [f64; 2]) {
    const UNTIL: f64 = 4.0;
    let expected = case.second(start, UNTIL);
    // How much a difference at the start has become.
    let beside = case.second([start[0] + 1e-7, start[1] - 1e-7], UNTIL);
    let grown = 1.0 + (beside[0] - expected[0]).hypot(beside[1] - expected[1]) / 1.4e-7;
    let text = case.text();
    let simulator = Simulator::new(&formula(&text), &Settings::default()).unwrap();
    let mut run = simulator.start(at(0.0), start[0], start[1]).unwrap();
    assert_eq!(run.finish(at(UNTIL)), RunEnd::Reached, "{text}");
    let state = run.state();
    let off = (state.q - expected[0]).hypot(state.u - expected[1]);
    assert!(off < 2e-9 * grown, "{text} from {start:?}: off by {off:e}, grown {grown:.1}");
    let scene = format!(
        "format = \"grazing-scene 2\"\ntitle = \"steep\"\n[system]\nperiod = \"2*pi\"\nmass = [[1]]\nforce = \"{text}\"\n"
    );
    let machine = Scene::from_toml(&scene, "steep.toml").unwrap().machine(&[]).unwrap();
    let simulator = many::simulate::Simulator::new(&machine, &many::simulate::Settings::default()).unwrap();
    let mut run = simulator.start(at(0.0), &[start[0]], &[start[1]]).unwrap();
    assert_eq!(run.finish(at(UNTIL)), RunEnd::Reached, "{text}");
    let state = run.state();
    let off = (state.q()[0] - expected[0]).hypot(state.u()[0] - expected[1]);
    assert!(off < 2e-9 * grown, "{text} as a machine, from {start:?}: off by {off:e}, grown {grown:.1}");
    if case.width >= 0.01 {
        let flow = Free::new(&formula(&text), 1e-13).unwrap();
        let (_, m) = flow.advance_linearised(State { t: 0.0, q: start[0], u: start[1] }, UNTIL);
        for (j, d) in [[1e-6, 0.0], [0.0, 1e-6]].into_iter().enumerate() {
            let [up, down] =
                [1.0, -1.0].map(|sign| case.second([start[0] + sign * d[0], start[1] + sign * d[1]], UNTIL));
            for i in 0..2 {
                let slope = (up[i] - down[i]) / 2e-6;
                let size = grown + slope.abs();
                assert!((m[i][j] - slope).abs() < 1e-5 * size, "{text}: {i}{j} {m:?}, {slope}");
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]
    #[test]
    fn no_step_leaps_over_a_steep_force(
        kind in 0usize..11,
        width in 1.0..4.0f64,
        centre in -0.4..0.4f64,
        strength in 0.05..0.6f64,
        q in -0.8..0.8f64,
        u in -0.8..0.8f64,
    ) {
        let width = 10f64.powf(-width);
        // Where a force holds a motion in its layer the second integrator takes the layer's time for steps.
        let width = if kind == 0 { width.max(1e-3) } else { width };
        steep_motions_agree(Steep { kind, width, centre, strength }, [q, u]);
    }
}

/// Known from other programs in more digits.
#[test]
fn dry_friction_made_smooth_has_its_known_motion() {
    let force = "-q - 0.05*u - 0.2*tanh(u/0.02) + cos(2*t)";
    let (q, u) = (-0.246_915_145_464_25, 0.174_852_072_576_77);
    let simulator = Simulator::new(&formula(force), &Settings::default()).unwrap();
    let mut run = simulator.start(at(0.0), 0.3, 0.0).unwrap();
    assert_eq!(run.finish(Time::new(3, 0.0)), RunEnd::Reached);
    let state = run.state();
    assert!((state.q - q).abs().max((state.u - u).abs()) < 1e-11, "{state:?}");
    let scene = format!(
        "format = \"grazing-scene 2\"\ntitle = \"steep\"\n[system]\nperiod = \"2*pi\"\nmass = [[1]]\nforce = \"{force}\"\n"
    );
    let machine = Scene::from_toml(&scene, "steep.toml").unwrap().machine(&[]).unwrap();
    let simulator = many::simulate::Simulator::new(&machine, &many::simulate::Settings::default()).unwrap();
    let mut run = simulator.start(at(0.0), &[0.3], &[0.0]).unwrap();
    assert_eq!(run.finish(Time::new(3, 0.0)), RunEnd::Reached);
    let state = run.state();
    assert!((state.q()[0] - q).abs().max((state.u()[0] - u).abs()) < 1e-11, "{state:?}");
}

/// A cubic spring felt only far away: of its series from rest, orders 2, 8, 14, … only are not zero.
#[test]
fn a_step_does_not_leap_over_a_cubic_spring() {
    let system = System { cubic: 1000.0, force: 1.0, ..bare(0.0, 0.0) };
    for tolerance in [1e-9, 1e-12, 1e-13] {
        let settings = Settings { tolerance, ..Settings::default() };
        let simulator = Simulator::new(&system, &settings).unwrap();
        let mut run = simulator.start(at(0.0), 0.0, 0.0).unwrap();
        for i in 1..40 {
            run.finish(at(0.1 * f64::from(i)));
            let State { q, u, .. } = run.state();
            // u²/2 + 250 q⁴ − q = 0.
            let energy = u * u / 2.0 + 250.0 * q.powi(4) - q;
            assert!(energy.abs() < 100.0 * tolerance, "{tolerance:e} {i}: {energy:e}");
        }
    }
}

/// Where a force changes in less than the shortest step the motion ends, and its place is that.
#[test]
fn a_motion_ends_where_its_force_is_too_steep() {
    for (force, q, u) in [
        ("-q - 0.2*tanh(u/1e-13) + cos(2*t)", f64::NAN, 0.0),
        ("-q + tanh((q - 0.1)/1e-11)", 0.1, f64::NAN),
        ("-q + exp(-((q - 0.1)/1e-11)^2)", 0.1, f64::NAN),
    ] {
        let simulator = Simulator::new(&formula(force), &Settings::default()).unwrap();
        let mut run = simulator.start(at(0.0), 0.3, -1.0).unwrap();
        assert_eq!(run.finish(Time::new(3, 0.0)), RunEnd::TooSteep, "{force}");
        let state = run.state();
        let off = if q.is_nan() { state.u - u } else { state.q - q };
        assert!(off.abs() < 1e-7, "{force}: {state:?}");
    }
}

#[test]
fn a_motion_ends_where_its_force_is_not_smooth() {
    let cases: [(&str, f64, f64, f64); 6] = [
        // Drawn into a pole at 1; thrown at one that no potential keeps it from.
        ("1/(1 - q)^2", 0.0, 0.0, 1.0),
        ("1e-6/(1 - q)", 0.0, 1.0, 1.0),
        // Too weak a pole to be felt, but none is stepped over.
        ("1e-30/(1 - q)", 0.0, 1.0, 1.0),
        ("sqrt(1 - q)", 0.0, 0.5, 1.0),
        ("log(q + 1)", 0.0, -2.0, -1.0),
        ("-q + cos(t)/(q - 1)", 0.0, 3.0, 1.0),
    ];
    for (force, q, u, place) in cases {
        let simulator = Simulator::new(&formula(force), &Settings::default()).unwrap();
        let mut run = simulator.start(at(0.0), q, u).unwrap();
        assert_eq!(run.finish(Time::new(10, 0.0)), RunEnd::NotSmooth, "{force}");
        let state = run.state();
        assert!((state.q - place).abs() < 1e-4, "{force}: {state:?}");
        assert!(run.time().periods() < 2.0, "{force}: {:?}", run.time());
        // A wall before it keeps the motion from it.
        let side = if place > q { "upper" } else { "lower" };
        let walls = format!("[[walls]]\nside = \"{side}\"\noffset = {}\nrestitution = 0.5", 0.9 * place);
        let system = scene(&format!("force = \"{force}\""), &walls).plain(&[]).unwrap();
        let simulator = Simulator::new(&system, &Settings::default()).unwrap();
        let mut run = simulator.start(at(0.0), q, u).unwrap();
        let end = run.finish(Time::new(2, 0.0));
        assert!(matches!(end, RunEnd::Reached | RunEnd::Escaped) && run.impacts() > 0, "{force}: {end:?}");
    }
    // At a pole from the start, and where it leaves every bound instead.
    let end = |force: &str, q: f64| {
        let simulator = Simulator::new(&formula(force), &Settings::default()).unwrap();
        simulator.start(at(0.0), q, 0.0).unwrap().finish(Time::new(10, 0.0))
    };
    assert_eq!(end("1/q", 0.0), RunEnd::NotSmooth);
    assert_eq!(end("sqrt(q)", -1.0), RunEnd::NotSmooth);
    assert_eq!(end("exp(q)", 0.0), RunEnd::Escaped);
    assert_eq!(end("exp(q)", 1e6), RunEnd::Escaped);
    assert_eq!(end("q^3 + q^2", 1.0), RunEnd::Escaped);
    // The linearised motion has no end there, and says so.
    let flow = Free::new(&formula("1/(1 - q)^2"), 1e-12).unwrap();
    let (end, _) = flow.advance_linearised(State { t: 0.0, q: 0.0, u: 0.0 }, 20.0);
    assert!(end.q.is_nan());
    // A pole on a wall is no place to rest.
    let walls = "[[walls]]\nside = \"upper\"\noffset = 1\nrestitution = 0.5";
    let system = scene("force = \"1/(1 - q)^2\"", walls).plain(&[]).unwrap();
    let error = Simulator::new(&system, &Settings::default()).unwrap_err();
    assert!(error.to_string().contains("not smooth on the upper wall near q = 1"), "{error}");
}

#[test]
fn a_formula_is_counted_only_where_there_is_one() {
    for (force, present, absent) in
        [("-sin(q)", Effect::Smooth, Effect::Cubic), ("-q^3", Effect::Cubic, Effect::Smooth)]
    {
        let mut counts = Counts::default();
        let simulator = Simulator::new(&formula(force), &Settings::default()).unwrap();
        let mut run = simulator.start_counting(at(0.0), 0.1, 1.0, &mut counts).unwrap();
        run.finish(at(0.0).after(12.0));
        drop(run);
        assert!(counts.of(present) > 0 && counts.of(absent) == 0, "{force}");
    }
}

#[test]
fn what_is_wrong_with_a_force_is_said() {
    let error = |force: &str| {
        let text = format!(
            "format = \"grazing-scene 1\"\ntitle = \"force\"\n[parameters]\na = 0\n[system]\nforce = \"{force}\"\n"
        );
        let scene = Scene::from_toml(&text, "force.toml").and_then(|scene| scene.plain(&[]));
        scene.and_then(|system| Free::new(&system, 1e-12)).map(drop).unwrap_err().to_string()
    };
    for (force, expected) in [
        ("-q + cos(w*t)", "force.toml:6: system.force = \"-q + cos(w*t)\": unknown parameter \"w\""),
        ("-q + cos(t/2)", "is not periodic in t"),
        ("abs(q)", "has a force with kinks; write format = \"grazing-scene 3\""),
        ("q/a", "divides by zero"),
        ("sqrt(a - 1)*q", "takes the root of a negative number"),
        ("log(a)*q", "takes the logarithm of a number that is not positive"),
        ("q^300", "the exponent 300 is above 256"),
        ("q^(1/2)", "the exponent 1/2 at character 3 is not above 1"),
    ] {
        let error = error(force);
        assert!(error.contains(expected), "{force}: {error}");
    }
}
