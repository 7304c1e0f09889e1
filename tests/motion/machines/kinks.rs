//! Forces with kinks and jumps, powers that are not whole, and stops whose force is a formula: where the
//! answer is known, against stops and friction that say the same, and against the second integrator.

use grazing_scenes::{
    attractor::lyapunov::exponents,
    many::section::{PlanarMachine, PlaneAxis},
};

use crate::samples::samples;

use super::{
    second::{extrapolated, pair_with},
    *,
};

fn read(body: &str) -> grazing_scenes::Result<Scene> {
    let text = format!("format = \"grazing-scene 3\"\ntitle = \"kinks\"\n{body}");
    Scene::from_toml(&text, "kinks.toml")
}

fn built(body: &str) -> Machine<f64> {
    read(body).and_then(|scene| scene.machine(&[])).unwrap_or_else(|error| panic!("{body}: {error}"))
}

/// Words, places and times in radians of all events, and the state at the end.
fn followed(
    machine: &Machine<f64>,
    q: &[f64],
    u: &[f64],
    until: f64,
) -> (Vec<(&'static str, usize, f64)>, State) {
    followed_by(&simulator(machine), q, u, until)
}

fn followed_by(
    simulator: &Simulator,
    q: &[f64],
    u: &[f64],
    until: f64,
) -> (Vec<(&'static str, usize, f64)>, State) {
    let mut run = simulator.start(at(0.0), q, u).unwrap();
    let mut all = Vec::new();
    let end = run.record(at(0.0).after(until), |event| {
        let word = match event {
            Event::Touch(_) => "touch",
            Event::Release(_) => "release",
            Event::Kink(_) => "kink",
            _ => "other",
        };
        all.push((word, event.place().unwrap(), TAU * event.time().unwrap().periods()));
    });
    assert_eq!((end, run.failure().map(|error| error.to_string())), (RunEnd::Reached, None), "{all:?}");
    (all, run.state())
}

/// q″ = −2 sign q from 1: parabolas between odd times; and q″ = −|q| q, whose energy is known.
#[test]
fn a_relay_turns_when_parabolas_say() {
    let relay = built("[system]\nperiod = \"2*pi\"\nmass = 1\nforce = \"-2*sign(q)\"");
    let (events, end) = followed(&relay, &[1.0], &[0.0], 8.5);
    let times: Vec<f64> = events.iter().map(|event| event.2).collect();
    assert!(apart(&times, &[1.0, 3.0, 5.0, 7.0]) < 1e-13 && times.len() == 4, "{times:?}");
    assert!(events.iter().all(|event| event.0 == "kink" && event.1 == 0), "{events:?}");
    assert!(apart(end.q(), &[1.0 - 0.25]) < 1e-13, "{end:?}");
    let spring = built("[system]\nperiod = \"2*pi\"\nmass = 1\nforce = \"-abs(q)*q\"");
    let (events, end) = followed(&spring, &[1.0], &[0.0], 40.0);
    let energy = 0.5 * end.u()[0].powi(2) + end.q()[0].abs().powi(3) / 3.0;
    assert!((energy - 1.0 / 3.0).abs() < 1e-11 && events.len() > 8, "{energy} {events:?}");
}

const PAIR: &str = "[system]\nperiod = 4\nmass = [[2, 0.3], [0.3, 0.5]]\nstiffness = [[3, -1], [-1, 2]]\n\
                    damping = [[0.4, -0.05], [-0.05, 0.3]]\nforcing = [{ k = 1, cos = [1.5, -0.6] }]\n";

/// The same stop as max(…) in forces and as a law of its own: as the compliant stop, to eleven digits.
#[test]
fn a_spring_by_max_and_by_a_law_is_the_compliant_stop() {
    let row = "row = [-1, 1]\noffset = -0.2\nharmonics = [{ k = 2, sin = 0.05 }]\n";
    let depth = "-0.2 + 0.05*sin(2*t) + q1 - q2";
    let soft = built(&format!("{PAIR}[[stops]]\n{row}stiffness = 50"));
    let force = format!("force = [\"-50*max({depth}, 0)\", \"50*max({depth}, 0)\"]\n");
    let kinked = built(&format!("{PAIR}{force}"));
    let law = built(&format!("{PAIR}[[stops]]\n{row}law = \"50*d\""));
    let (events, end) = followed(&soft, &[0.3, -0.1], &[0.2, 0.5], 30.0);
    assert!(events.len() > 8, "{events:?}");
    for (name, machine) in [("max", &kinked), ("law", &law)] {
        let (found, last) = followed(machine, &[0.3, -0.1], &[0.2, 0.5], 30.0);
        let times = |all: &[(&str, usize, f64)]| all.iter().map(|event| event.2).collect::<Vec<_>>();
        assert_eq!(found.len(), events.len(), "{name}: {found:?} {events:?}");
        let off = apart(&times(&found), &times(&events));
        let state = apart(last.q(), end.q()).max(apart(last.u(), end.u()));
        println!("{name}: events off by {off:e}, state by {state:e}");
        assert!(off < 1e-11 && state < 1e-11, "{name}: {off:e} {state:e}");
    }
}

/// With a damper the force jumps where contact begins, and the stop lets go before it is open.
#[test]
fn exponents_with_a_law_are_those_of_the_compliant_stop() {
    let stop = "[[stops]]\nrow = [-1, 1]\noffset = -0.2\n";
    let machines = ["stiffness = 50\ndamping = 1.5", "law = \"50*d + 1.5*v\""];
    let [soft, law] = machines.map(|text| {
        let machine = built(&format!("{PAIR}{stop}{text}"));
        let axes = [PlaneAxis::Place(0), PlaneAxis::Speed(0)];
        let planar = PlanarMachine::new(&machine, simulator(&machine), &axes).unwrap();
        let start = State::new(0.0, &[0.1, 0.0], &[0.0, 0.2]);
        let all = exponents(&planar, &start.start(machine.rate()), 4, 0, 20, &()).unwrap();
        (
            followed(&machine, &[0.1, 0.0], &[0.0, 0.2], 40.0).0,
            all.iter().map(|one| one.rate).collect::<Vec<_>>(),
        )
    });
    assert_eq!(soft.0.len(), law.0.len(), "{:?} {:?}", soft.0, law.0);
    assert!(soft.0.len() > 8);
    for (a, b) in soft.0.iter().zip(&law.0) {
        assert!((a.0, a.1) == (b.0, b.1) && (a.2 - b.2).abs() < 1e-9, "{a:?} {b:?}");
    }
    for (a, b) in soft.1.iter().zip(&law.1) {
        assert!((a - b).abs() < 1e-8 * a.abs().max(0.1), "{soft:?} {law:?}");
    }
}

/// ½ m v² = ⅖ k d^{5/2} at the deepest, and T = 2 √π Γ(7/5)/Γ(9/10) d/v.
#[test]
fn a_hertzian_impact_lasts_as_long_as_gamma_functions_say() {
    const LASTS: f64 = 2.943_275_184_324_706;
    for (mass, k, speed) in [(1.0f64, 1e4f64, 0.5f64), (0.2, 1e9, 3.0), (3.0, 20.0, 1.0), (1.0, 1e6, 1e-3)] {
        let machine = built(&format!(
            "[system]\nperiod = \"2*pi\"\nmass = {mass:?}\n[[stops]]\nside = \"lower\"\noffset = 0.25\nlaw = \"{k:?}*d^1.5\""
        ));
        let depth = (5.0 * mass * speed * speed / (4.0 * k)).powf(0.4);
        let duration = LASTS * depth / speed;
        let start = 0.25 + 0.01 * speed;
        let (events, end) = followed(&machine, &[start], &[-speed], 0.02 + duration);
        let [("touch", 0, begin), ("release", 0, over)] = events[..] else { panic!("{k}: {events:?}") };
        let off = ((over - begin) / duration - 1.0).abs();
        let speed_off = (end.u()[0] / speed - 1.0).abs();
        let (_, deepest) = followed(&machine, &[start], &[-speed], begin + duration / 2.0);
        let depth_off = ((0.25 - deepest.q()[0]) / depth - 1.0).abs();
        println!("k {k:e}: duration off by {off:e}, speed {speed_off:e}, depth {depth_off:e}");
        // Times are phases in floats, the stop is at 0.25, and contact ends within the minimum depth.
        let least = 1e-15 / duration.min(depth) + 1e-12 / (speed * duration);
        assert!(off < 1e-11 + 4.0 * least && depth_off < 1e-11 + 4.0 * least, "{k}: {off:e} {depth_off:e}");
        assert!(speed_off < 1e-11, "{k}: {speed_off:e}");
    }
}

/// Hunt and Crossley: v dv/(1 + cv) = −k d^{3/2} dd/m, so that G(v) = v/c − ln(1 + cv)/c² is the same before
/// and after.
#[test]
fn a_contact_by_hunt_and_crossley_returns_what_its_integral_says() {
    for (c, speed) in [(0.1f64, 1.0f64), (0.5, 2.0), (0.02, 0.3), (3.0, 1.0)] {
        let machine = built(&format!(
            "[parameters]\nk = 1e5\nc = {c:?}\n[system]\nperiod = \"2*pi\"\nmass = 1\n[[stops]]\nside = \"upper\"\n\
             offset = 0.1\nlaw = \"k*d^(3/2)*(1 + c*v)\""
        ));
        let integral = |v: f64| v / c - (c * v).ln_1p() / (c * c);
        let (mut low, mut high) = (-speed.min(1.0 / c * (1.0 - 1e-15)), 0.0);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if integral(middle) > integral(speed) { low = middle } else { high = middle }
        }
        let (events, end) = followed(&machine, &[0.0], &[speed], 0.1 / speed + 0.5);
        assert_eq!(events.len(), 2, "{events:?}");
        let off = (end.u()[0] / low - 1.0).abs();
        println!("c {c}: restitution {}, off by {off:e}", -low / speed);
        assert!(off < 1e-11, "{c}: {} {low}", end.u()[0]);
    }
}

/// While it slides; where it would stick there is no motion by the formula, and that is said.
#[test]
fn a_sign_of_the_velocity_is_friction_until_it_sticks() {
    let head =
        "[system]\nperiod = \"2*pi\"\nmass = 1\nstiffness = 1.7\ndamping = 0.1\nforcing = [{ cos = 0.05 }]\n";
    let rubbed = built(&format!("{head}[[friction]]\nnormal = 0.2\ncoefficient = 1"));
    let signed = built(&format!("{head}force = \"-0.2*sign(u)\""));
    let [by_friction, by_sign] = [&rubbed, &signed].map(simulator);
    let (mut a, mut b) = (
        by_friction.start(at(0.0), &[3.0], &[0.1]).unwrap(),
        by_sign.start(at(0.0), &[3.0], &[0.1]).unwrap(),
    );
    let mut crossed = 0;
    loop {
        let goal = Time::new(60, 0.0);
        let (one, two) = (a.next(goal), b.next(goal));
        match (one, two) {
            (Event::Reversal(one), Event::Kink(two)) => {
                assert!(one.time.since(two.time).abs() < 1e-11, "{one:?} {two:?}");
                crossed += 1;
            }
            (Event::Stick(one), Event::End(RunEnd::Escaped)) => {
                let error = b.failure().unwrap().to_string();
                assert!(error.contains("sign(u)") && error.contains("[[friction]]"), "{error}");
                assert!(b.time().since(one.time).abs() < 1e-10, "{one:?} {:?}", b.time());
                break;
            }
            other => panic!("{other:?}"),
        }
        let off = apart(a.state().q(), b.state().q()).max(apart(a.state().u(), b.state().u()));
        assert!(off < 1e-11, "{off:e}");
    }
    assert!(crossed > 3, "{crossed}");
}

#[test]
fn kinks_in_the_wrong_place_are_refused() {
    let refused = |body: &str, words: &str| {
        let error = read(body).and_then(|scene| scene.machine(&[]).map(drop)).unwrap_err().to_string();
        assert!(error.contains(words) && error.contains("kinks.toml:"), "{body}: {error}");
    };
    let force = |text: &str| format!("[system]\nperiod = 4\nmass = 1\nforce = \"{text}\"");
    refused(&force("q^0.5"), "write x^1.5 as it is");
    refused(&force("q^(4/2)"), "is whole");
    refused(&force("q^(1/0)"), "divides by zero");
    refused(&force("max(q)"), "has 2 arguments");
    refused(&force("abs q"), "expected \"(\"");
    refused(&force("abs(2)*3"), "stands only in a force");
    refused(&force("max(t, 0)"), "is not periodic in t");
    refused(&force(&format!("{}q{}", "abs(".repeat(20), ")".repeat(20))), "both sides of all kinks");
    let stop = |keys: &str| {
        format!("[system]\nperiod = 4\nmass = 1\n[[stops]]\nside = \"lower\"\noffset = 0\n{keys}")
    };
    refused(&stop("law = \"3\""), "depends on neither");
    refused(&stop("law = \"3*d\"\nstiffness = 2"), "stands beside `law`");
    refused(&stop("law = \"3*q\""), "unknown parameter");
    refused(
        &stop("law = \"-3*d^1.5\""),
        "stops[1].law = \"-3*d^1.5\": stop lower: law is negative at every depth",
    );
}

/// A force of a few kinks: its text, and what it is.
#[derive(Clone)]
struct Kinked {
    /// Factor, kind, and what it is of: by q1, q2, u1, u2, cos t and a constant.
    terms: Vec<(f64, &'static str, [f64; 6])>,
}

fn linear(by: &[f64; 6], t: f64, x: &[f64]) -> f64 {
    by[..4].iter().zip(x).map(|(a, b)| a * b).sum::<f64>() + by[4] * t.cos() + by[5]
}

impl Kinked {
    fn text(&self) -> String {
        let of = |[a, b, c, d, e, f]: [f64; 6]| {
            format!("({a:?})*q1+({b:?})*q2+({c:?})*u1+({d:?})*u2+({e:?})*cos(t)+({f:?})")
        };
        let one = |(factor, kind, by): &(f64, &str, [f64; 6])| {
            let inner = of(*by);
            let own = match *kind {
                "abs" => format!("abs({inner})"),
                "max" => format!("max({inner}, 0.5*({inner}) + 0.1)"),
                "min" => format!("min({inner}, 0)"),
                "power" => format!("max({inner}, 0)^1.5"),
                "nested" => format!("sin(max(abs({inner}) - 0.3, 0))^2"),
                _ => format!("sign({inner})"),
            };
            format!("({factor:?})*{own}")
        };
        self.terms.iter().map(one).collect::<Vec<_>>().join(" + ")
    }

    /// In the mode of signs of all switches.
    fn at(&self, t: f64, x: &[f64], signs: &[f64]) -> f64 {
        let one = |((factor, kind, by), sign): (&(f64, &str, [f64; 6]), &[f64])| {
            let inner = linear(by, t, x);
            let above = sign[0] > 0.0;
            factor
                * match *kind {
                    "abs" => sign[0] * inner,
                    "max" => {
                        if above {
                            inner
                        } else {
                            0.5 * inner + 0.1
                        }
                    }
                    "min" => {
                        if above {
                            0.0
                        } else {
                            inner
                        }
                    }
                    "power" => {
                        if above {
                            inner.max(0.0).powf(1.5)
                        } else {
                            0.0
                        }
                    }
                    "nested" => {
                        if sign[1] > 0.0 {
                            (sign[0] * inner - 0.3).sin().powi(2)
                        } else {
                            0.0
                        }
                    }
                    _ => sign[0],
                }
        };
        self.terms.iter().zip(signs.chunks(2)).map(one).sum()
    }

    /// Two switches for each term.
    fn switches(&self, t: f64, x: &[f64]) -> Vec<f64> {
        let one = |(_, kind, by): &(f64, &str, [f64; 6])| {
            let inner = linear(by, t, x);
            match *kind {
                "max" => [0.5 * inner - 0.1, 1.0],
                "nested" => [inner, inner.abs() - 0.3],
                _ => [inner, 1.0],
            }
        };
        self.terms.iter().flat_map(one).collect()
    }
}

/// The state after a time by the second integrator, its switches' zeros by bisection.
fn second(forces: &[Kinked; 2], from: [f64; 4], until: f64) -> Vec<f64> {
    let (mut t, mut x) = (0.0, from.to_vec());
    let all = |t: f64, x: &[f64]| forces.iter().flat_map(|force| force.switches(t, x)).collect::<Vec<f64>>();
    let mut signs: Vec<f64> = all(t, &x).iter().map(|g| g.signum()).collect();
    let cut = 2 * forces[0].terms.len();
    while t < until {
        let slope = |time: f64, x: &[f64], signs: &[f64]| {
            let a = forces[0].at(time, x, &signs[..cut]) - 2.0 * x[0] + 0.5 * x[1] - 0.2 * x[2];
            let b = forces[1].at(time, x, &signs[cut..]) + 0.5 * x[0] - 1.5 * x[1] - 0.3 * x[3];
            vec![x[2], x[3], a + time.cos(), b]
        };
        // Towards and from a zero of a switch the steps shrink and grow.
        let rate = slope(t, &x, &signs);
        let ahead: Vec<f64> = x.iter().zip(&rate).map(|(x, rate)| x + 1e-4 * rate).collect();
        let near =
            all(t, &x).iter().zip(all(t + 1e-4, &ahead)).fold(f64::INFINITY, |near: f64, (g, next)| {
                let speed = (next - g).abs() / 1e-4;
                if speed > 0.0 { near.min(0.15 * g.abs() / speed) } else { near }
            });
        let h = near.clamp(1e-7, 0.02).min(until - t);
        let after = |h: f64| extrapolated(&x, h, |after, x| slope(t + after, x, &signs));
        let wrong = |h: f64, x: &[f64]| all(t + h, x).iter().zip(&signs).any(|(g, sign)| g * sign < 0.0);
        let end = after(h);
        if !wrong(h, &end) {
            (x, t) = (end, t + h);
            continue;
        }
        let (mut low, mut high) = (0.0, h);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if wrong(middle, &after(middle)) { high = middle } else { low = middle }
        }
        let next = after(high);
        let now = all(t + high, &next);
        for (sign, g) in signs.iter_mut().zip(&now) {
            if g * *sign < 0.0 {
                *sign = g.signum();
            }
        }
        (x, t) = (next, t + high);
    }
    x
}

#[test]
fn random_forces_with_kinks_agree_with_the_second_integrator() {
    let mut state = 1u64;
    let mut random = |low: f64, high: f64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let x = (state >> 11) as f64 / (1u64 << 53) as f64;
        // Few digits, so that text and numbers are the same.
        ((low + (high - low) * x) * 1e4).round() / 1e4
    };
    let kinds = ["abs", "max", "min", "power", "nested", "sign"];
    let (mut compared, mut slid, mut crossed, mut worst) = (0, 0, 0, 0.0f64);
    let trials = samples(6);
    for case in 0..trials {
        let mut force = || {
            let term = |random: &mut dyn FnMut(f64, f64) -> f64| {
                let kind = kinds[(random(0.0, 5.999)).floor() as usize];
                let by: [f64; 6] = std::array::from_fn(|i| random(-1.0, 1.0) * if i < 4 { 1.0 } else { 0.5 });
                (random(-0.6, 0.6), kind, by.map(|x| (x * 1e4).round() / 1e4))
            };
            Kinked { terms: (0..2).map(|_| term(&mut random)).collect() }
        };
        let forces = [force(), force()];
        let text = pair_with([forces[0].text(), forces[1].text()]);
        let machine = built(&text);
        let simulator = simulator(&machine);
        let Ok(mut run) = simulator.start(at(0.0), &[0.7, -0.3], &[0.2, 0.4]) else { panic!("{text}") };
        let mut kinks = 0;
        let end = run.record(at(0.0).after(12.0), |_| kinks += 1);
        if let Some(error) = run.failure() {
            assert!(error.to_string().contains("slides along the jump"), "{case}: {error}");
            slid += 1;
            continue;
        }
        assert_eq!(end, RunEnd::Reached, "{case}: {text}");
        let known = second(&forces, [0.7, -0.3, 0.2, 0.4], 12.0);
        let off = apart(run.state().q(), &known[..2]).max(apart(run.state().u(), &known[2..]));
        worst = worst.max(off);
        assert!(off < 1e-9, "{case}: off by {off:e} after {kinks} kinks: {text}");
        (compared, crossed) = (compared + 1, crossed + kinks);
    }
    println!("{compared} forces with {crossed} kinks: off by at most {worst:e}; {slid} slide");
    assert!(compared * 3 > trials * 2 && crossed > trials * 5, "{compared} {crossed} {slid}");
}

/// From rest a drive reaches the third mass, which friction holds, only later: the force that holds it, and
/// the velocity in a kink, begin at 0 with all that they are added up from.
#[test]
fn what_nothing_moves_yet_is_no_steep_force() {
    let machine = built(
        "[system]\nperiod = \"2*pi\"\nmass = [[1.7, 0, 0], [0, 1.8, 0], [0, 0, 0.6]]\n\
         damping = [[0.2, -0.1, 0], [-0.1, 0.5, -0.4], [0, -0.4, 0.4]]\n\
         stiffness = [[4, -2, 0], [-2, 3.7, -1.7], [0, -1.7, 1.7]]\nforce = [0, \"-0.05*max(u2, 0)\", 0]\n\
         forcing = [{ cos = [1, 0, 0] }]\n\
         [[friction]]\nrow = [0, 0, 1]\nnormal = 1\ncoefficient = 0.2\n",
    );
    let (events, end) = followed(&machine, &[0.0; 3], &[0.0; 3], 20.0);
    assert!(events.iter().filter(|event| event.0 == "kink").count() > 4, "{events:?}");
    // A start that is off by rounding goes the same way.
    let (_, near) = followed(&machine, &[1e-14, 1e-14, 0.0], &[1e-14, 1e-14, 0.0], 20.0);
    let off = apart(end.q(), near.q()).max(apart(end.u(), near.u()));
    assert!(off < 1e-11, "{off:e}: {end:?} {near:?}");
}

/// What stands in a kink may be of any unit: with lengths 2²⁰ times as large, or smaller, and the kink in the
/// old unit, all is the same to the last bit.
#[test]
fn a_kink_in_another_unit_than_lengths_is_the_same_to_the_last_bit() {
    let in_unit = |unit: f64| {
        let machine = built(&format!(
            "[system]\nperiod = \"2*pi\"\nmass = [[1.2, 0], [0, 1.3]]\ndamping = [[0.2, -0.1], [-0.1, 0.1]]\n\
             stiffness = [[4.5, -4], [-4, 4]]\nforcing = [{{ cos = [\"{unit:?}\", 0] }}]\n\
             force = [\"{unit:?}*0.2*max(-q1/{unit:?} - 0.09, 0)^1.5\", \"-{unit:?}*0.1*max(u2/{unit:?}, 0)\"]\n\
             [[stops]]\nrow = [0, -1]\noffset = \"-{unit:?}*0.4\"\nrestitution = 0.7\n"
        ));
        let (q, u) = ([0.05 * unit; 2], [0.02 * unit; 2]);
        let simulator = Simulator::suited(&machine, None, &[State::new(0.0, &q, &u)]).unwrap();
        let (events, end) = followed_by(&simulator, &q, &u, 40.0);
        let state: Vec<f64> = end.q().iter().chain(end.u()).map(|x| x / unit).collect();
        (events, state)
    };
    let known = in_unit(1.0);
    assert!(known.0.iter().filter(|event| event.0 == "kink").count() > 10, "{known:?}");
    for unit in [1_048_576.0, 1.0 / 1_048_576.0] {
        assert_eq!(in_unit(unit), known, "{unit}");
    }
}
