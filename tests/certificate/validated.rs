//! Proved orbits and events of the paper's example against closed formulas and Newton's method by mpmath
//! (tests/data/oscillator.csv).

use crate::systems;

use std::process::Command;

use grazing_scenes::{
    Result,
    motion::{Harmonic, Side, System, Wall},
    number::{Ball, Elementary, Precision, Real},
    search::orbit::{self, Condition, ExpectedImpact, Jet, Stability, Verdict},
};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero, pow};
use systems::{at, cases, example, lower as impact, number, prove, proved};

fn power_of_ten(exponent: u32) -> BigRational {
    BigRational::new(1.into(), pow(BigInt::from(10), exponent as usize))
}

/// Whether a ball contains the number of 40 digits, and is narrower than 10^−width.
fn agrees(ball: &Ball, text: &str, width: u32) -> bool {
    let value = number(text);
    let slack = power_of_ten(34);
    let (lo, hi) = ball.exact_bounds().unwrap();
    lo <= &value + &slack && &value - &slack <= hi && hi - lo <= power_of_ten(width)
}

fn rows(kind: &str) -> Vec<Vec<&'static str>> {
    let lines =
        include_str!("../data/oscillator.csv").lines().map(|line| line.split(',').collect::<Vec<_>>());
    lines.filter(|words| words[0] == kind).collect()
}

#[test]
fn orbits_agree_with_the_closed_formulas() {
    let precision = Precision::new(128);
    let stable = [("3", "0.0058"), ("4", "-0.05"), ("4", "-0.01")];
    for words in rows("orbit") {
        let (n, mu, t, v) = (words[1], words[2], words[3], words[4]);
        let system = at(mu);
        let guess = impact(n.parse().unwrap(), t[..10].parse().unwrap(), v[..10].parse().unwrap());
        let verdict = orbit::orbit(&system, &[guess], &precision).unwrap();
        if (n, mu, &v[..3]) == ("4", "-0.01", "0.7") {
            // Past µ_gr4 the stable branch is no orbit.
            assert!(matches!(&verdict, Verdict::Refuted(why) if why.contains("lower wall")), "{verdict:?}");
            continue;
        }
        let orbit = proved(verdict);
        assert!(agrees(&orbit.phases[0], t, 25), "{words:?}: {:?}", orbit.phases);
        assert!(agrees(&orbit.velocities[0], v, 25) && agrees(&orbit.determinant, words[6], 20), "{words:?}");
        assert!(agrees(&orbit.trace, words[5], 15), "{words:?}: {:?}", orbit.trace);
        let upper = v.starts_with("0.5") || n == "3";
        let expected =
            if stable.contains(&(n, mu)) && upper { Stability::Stable } else { Stability::Unstable };
        assert_eq!(orbit.stability, Some(expected), "{words:?}");
        assert!(orbit.radius >= power_of_ten(2), "{words:?}: {}", orbit.radius);
    }
}

#[test]
fn a_box_without_a_solution_is_refuted() {
    let precision = Precision::new(128);
    let system = at("-0.05");
    let radius = power_of_ten(3);
    let in_box = |phase, velocity| {
        orbit::solution_in(&system, &[impact(4, phase, velocity)], &radius, &precision).unwrap()
    };
    assert!(matches!(in_box(-0.6833, 0.6), Verdict::Proved(_)));
    assert!(matches!(in_box(-0.6633, 0.62), Verdict::Refuted(_)));
    assert!(matches!(in_box(0.3, 0.62), Verdict::Refuted(_)));
    // A box as wide as both branches' orbits: Krawczyk's test must not pass it.
    let wide = orbit::solution_in(&system, &[impact(4, -0.41, 0.37)], &number("0.5"), &precision).unwrap();
    assert!(matches!(wide, Verdict::Undecided(_)));
    // Below the saddle-node there is nothing to find.
    let gone = at("-0.0844");
    let verdict = orbit::orbit(&gone, &[impact(4, -0.41, 0.37)], &precision).unwrap();
    assert!(!matches!(verdict, Verdict::Proved(_)));
}

fn family(precision: &Precision) -> impl Fn(&Jet) -> Result<System<Jet>> {
    |mu| Ok(example(mu, precision))
}

#[test]
fn events_lie_in_proved_intervals() {
    let precision = Precision::new(128);
    let single = |periods, phase, velocity| vec![impact(periods, phase, velocity)];
    let grazing = |after, time| Condition::Grazing { after, side: Side::Lower, time };
    let cases = [
        ("sn", single(4, -0.41, 0.365), -0.0843, Condition::SaddleNode),
        ("pd", single(3, -0.051, 0.063), 0.0055, Condition::Flip),
        ("gr4", single(4, -0.76, 0.67), -0.0244, grazing(0, 19.7)),
        ("gr3", vec![impact(3, 0.0039, 0.0182), impact(3, -0.1078, 0.1098)], 0.006, grazing(0, 12.55)),
    ];
    for ((name, impacts, mu, condition), words) in cases.into_iter().zip(rows("event")) {
        assert_eq!(words[1], name);
        let verdict = orbit::event(family(&precision), &impacts, mu, condition, &precision).unwrap();
        let event = proved(verdict);
        assert!(agrees(&event.parameter, words[2], 20), "{name}: {:?}", event.parameter);
        if let (Some(time), Some(expected)) = (&event.time, words.get(3)) {
            assert!(agrees(time, expected, 20), "{name}");
        }
    }
}

/// The flight's formula goes on after its end, with tangencies that no orbit has.
#[test]
fn a_tangency_outside_its_flight_is_none() {
    let precision = Precision::new(128);
    let guess = [impact(4, -0.76, 0.67)];
    let mut outside = 0;
    for start in -20..60 {
        let condition = Condition::Grazing { after: 0, side: Side::Lower, time: f64::from(start) };
        let verdict = orbit::event(family(&precision), &guess, -0.0244, condition, &precision).unwrap();
        match verdict {
            Verdict::Proved(event) => {
                let (lo, hi) = event.time.unwrap().exact_bounds().unwrap();
                assert!(lo > BigRational::zero() && hi < number("25.2"), "{start}");
            }
            Verdict::Undecided(why) => outside += usize::from(why.contains("not certainly in the flight")),
            Verdict::Refuted(_) => {}
        }
    }
    assert!(outside > 0);
}

/// µ_sn from (p₁, p₂) = (I − E)⁻¹ E (0, 1 + τ) in balls, by the closed formula.
#[test]
fn the_saddle_node_has_a_closed_form() {
    let precision = Precision::new(256);
    let ratio = |text: &str| Ball::ratio(&number(text), &precision);
    let time = Ball::pi(&precision) * &ratio("8");
    let decay = (-ratio("6/49") * &time).exp(&precision);
    let omega = ratio("64/2401").sqrt();
    let (sin, cos) = (omega.clone() * &time).sin_cos(&precision);
    let (c, s) = (cos * &decay, sin * &decay / &omega);
    let e12 = s.clone();
    let (e11, e22) = (c.clone() + &(s.clone() * &ratio("6/49")), c - &(s.clone() * &ratio("6/49")));
    let e21 = -s * &ratio("100/2401");
    // Solve (I − E) p = E (0, 2) by Cramer's rule.
    let two = ratio("2");
    let (b1, b2) = (e12.clone() * &two, e22.clone() * &two);
    let (m11, m22) = (ratio("1") - &e11, ratio("1") - &e22);
    let determinant = m11.clone() * &m22 - &(e12.clone() * &e21);
    let p1 = (m22 * &b1 + &(e12 * &b2)) / &determinant;
    let p2 = (m11 * &b2 + &(e21 * &b1)) / &determinant;
    let q = ratio("1") + &p2;
    let mu = q.clone() / &(p1.clone() * &p1 + &(q.clone() * &q)).sqrt() - &ratio("1");
    let event = proved(
        orbit::event(
            family(&precision),
            &[impact(4, -0.41, 0.365)],
            -0.0843,
            Condition::SaddleNode,
            &precision,
        )
        .unwrap(),
    );
    let difference = mu - &event.parameter;
    assert!(
        difference.contains(&BigRational::zero()) && difference.exponent().is_none_or(|e| e < -180),
        "{difference:?}"
    );
}

#[test]
fn a_system_outside_the_method_is_an_input_error() {
    let precision = Precision::new(64);
    let good = at("0");
    let cubic = System { cubic: BigRational::one(), ..good.clone() };
    let resonant = System {
        damping: BigRational::zero(),
        stiffness: BigRational::from_integer(4.into()),
        forcing: vec![Harmonic { k: 2, cos: BigRational::one(), sin: BigRational::zero() }],
        ..good.clone()
    };
    for (system, word) in [(&cubic, "cubic"), (&resonant, "resonance")] {
        let error = orbit::orbit(system, &[impact(1, 0.0, 0.1)], &precision).unwrap_err();
        assert!(error.is_input() && error.to_string().contains(word), "{error}");
    }
    let above = ExpectedImpact { side: Side::Upper, ..impact(1, 0.0, 0.1) };
    assert!(orbit::orbit(&good, &[above], &precision).unwrap_err().to_string().contains("no upper wall"));
    assert!(orbit::orbit(&good, &[impact(0, 0.0, 0.1)], &precision).unwrap_err().is_input());
}

/// A motion of a system in floats by Runge and Kutta's method: another route to what an orbit is.
struct Motion(System<f64>);

impl Motion {
    fn sum(harmonics: &[Harmonic<f64>], t: f64) -> [f64; 2] {
        harmonics.iter().fold([0.0, 0.0], |[value, slope], h| {
            let k = f64::from(h.k);
            let (sin, cos) = (k * t).sin_cos();
            [value + h.cos * cos + h.sin * sin, slope + k * (h.sin * cos - h.cos * sin)]
        })
    }

    fn advance(&self, mut x: [f64; 2], from: f64, to: f64) -> [f64; 2] {
        let s = &self.0;
        let f = |t: f64, [q, u]: [f64; 2]| {
            [u, Motion::sum(&s.forcing, t)[0] + s.force - s.damping * u - s.stiffness * q]
        };
        let steps = ((to - from).abs() / 0.002).ceil().max(1.0);
        let h = (to - from) / steps;
        for i in 0..steps as u32 {
            let t = from + h * f64::from(i);
            let along = |k: [f64; 2], h: f64| [x[0] + h * k[0], x[1] + h * k[1]];
            let k1 = f(t, x);
            let k2 = f(t + h / 2.0, along(k1, h / 2.0));
            let k3 = f(t + h / 2.0, along(k2, h / 2.0));
            let k4 = f(t + h, along(k3, h));
            for j in 0..2 {
                x[j] += h / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j]);
            }
        }
        x
    }

    fn walls(&self, side: Side) -> &Wall<f64> {
        if side == Side::Lower { self.0.lower.as_ref().unwrap() } else { self.0.upper.as_ref().unwrap() }
    }

    /// The state relative to a wall, and after an impact there.
    fn wall(&self, side: Side, t: f64, [q, u]: [f64; 2]) -> ([f64; 2], [f64; 2]) {
        let wall = self.walls(side);
        let [position, speed] = Motion::sum(&wall.harmonics, t);
        let (z, w) = (q - position - wall.offset, u - speed);
        ([z, w], [q, speed - wall.restitution * w])
    }

    /// From a time through the impacts expected at these times and on to the last time.
    fn through(&self, mut x: [f64; 2], mut from: f64, impacts: &[(Side, f64)], to: f64) -> [f64; 2] {
        for &(side, time) in impacts {
            let mut t = time;
            x = self.advance(x, from, t);
            for _ in 0..5 {
                let [z, w] = self.wall(side, t, x).0;
                x = self.advance(x, t, t - z / w);
                t -= z / w;
            }
            x = self.wall(side, t, x).1;
            from = t;
        }
        self.advance(x, from, to)
    }
}

#[test]
fn orbits_and_multipliers_are_those_of_motions_in_floats() {
    let float = |x: &Ball| x.exact_bounds().map(|(lo, _)| lo.to_f64().unwrap()).unwrap();
    for case in cases() {
        let orbit = proved(prove(&case.system, &case.impacts));
        assert_eq!(orbit.stability, Some(case.stability), "{}", case.name);
        let motion = Motion(case.system.try_map(|x| x.to_f64().ok_or(())).unwrap());
        let turn = std::f64::consts::TAU;
        let mut periods = 0;
        let mut times = Vec::new();
        for (impact, phase) in case.impacts.iter().zip(&orbit.phases) {
            times.push((impact.side, float(phase) + turn * f64::from(periods)));
            periods += impact.periods;
        }
        let end = times[0].1 + turn * f64::from(periods);
        times.push((times[0].0, end));
        // The orbit meets the walls when and as fast as is claimed.
        let (side, start) = times[0];
        let wall = motion.walls(side);
        let [position, speed] = Motion::sum(&wall.harmonics, start);
        let v = float(&orbit.velocities[0]) * side.sign();
        let after = [position + wall.offset, speed + wall.restitution * v];
        let mut x = after;
        for (i, pair) in times.windows(2).enumerate() {
            let before = motion.advance(x, pair[0].1, pair[1].1);
            let ([z, w], next) = motion.wall(pair[1].0, pair[1].1, before);
            let v = float(&orbit.velocities[(i + 1) % case.impacts.len()]);
            assert!(z.abs() < 1e-7 && (w * pair[1].0.sign() + v).abs() < 1e-7, "{}: {z} {w} {v}", case.name);
            x = next;
        }
        // Differences of the map once round, from a time in the first flight.
        let middle = (times[0].1 + times[1].1) / 2.0;
        let x = motion.advance(after, start, middle);
        let round = |x: [f64; 2]| motion.through(x, middle, &times[1..], middle + end - start);
        let h = 1e-5 * float(&orbit.velocities[0]).min(0.1);
        let column = |d: [f64; 2]| {
            let (a, b) = (round([x[0] + d[0], x[1] + d[1]]), round([x[0] - d[0], x[1] - d[1]]));
            [(a[0] - b[0]) / (2.0 * h), (a[1] - b[1]) / (2.0 * h)]
        };
        let (first, second) = (column([h, 0.0]), column([0.0, h]));
        let (trace, det) = (first[0] + second[1], first[0] * second[1] - first[1] * second[0]);
        let near = |a: f64, b: f64| (a - b).abs() < 1e-3 * (1.0 + b.abs());
        let proved = (float(&orbit.trace), float(&orbit.determinant));
        assert!(near(trace, proved.0) && near(det, proved.1), "{}: {trace} {det} {proved:?}", case.name);
    }
}

/// Between the flip and its end the double-impact orbit exists; past µ_gr3 the same equations have a solution
/// that is no orbit.
#[test]
fn past_its_grazing_the_double_impact_orbit_is_refuted() {
    let guess = |mu: &str, t1, v1, t2, v2| prove(&at(mu), &[impact(3, t1, v1), impact(3, t2, v2)]);
    assert!(matches!(guess("0.006", 0.0039, 0.0182, -0.1078, 0.1098), Verdict::Proved(_)));
    assert!(matches!(guess("0.006099", 0.0089, 0.014, -0.1129, 0.1139), Verdict::Proved(_)));
    let past = guess("0.0062", 0.0135, 0.0099, -0.118, 0.1185);
    assert!(matches!(&past, Verdict::Refuted(why) if why.contains("negative")), "{past:?}");
}

/// An orbit of period 4 listed as one of period 8 is none, with whatever words; nor is its saddle-node.
#[test]
fn a_pattern_listed_twice_repeats() {
    let turn = std::f64::consts::TAU;
    let (t, v) = (-0.144, 0.1363);
    for twice in [[impact(4, t, v), impact(4, t, v)], [impact(3, t, v), impact(5, t + turn, v)]] {
        let verdict = prove(&at("-0.05"), &twice);
        let says = "repeats itself after 1 of its 2 impacts, that is after 4 of its 8 periods";
        assert!(matches!(&verdict, Verdict::Refuted(why) if why.contains(says)), "{verdict:?}");
    }
    let precision = Precision::new(128);
    let twice = [impact(4, -0.41, 0.365), impact(4, -0.41, 0.365)];
    let node = Condition::SaddleNode;
    let verdict = orbit::event(family(&precision), &twice, -0.0843, node, &precision).unwrap();
    assert!(matches!(&verdict, Verdict::Refuted(why) if why.contains("repeats itself")), "{verdict:?}");
    // Two different impacts with the same periods do not repeat, from whichever the list begins.
    for double in [[(0.0039, 0.0182), (-0.1078, 0.1098)], [(-0.1078, 0.1098), (0.0039, 0.0182)]] {
        let impacts = double.map(|(t, v)| impact(3, t, v));
        assert!(matches!(prove(&at("0.006"), &impacts), Verdict::Proved(_)));
    }
}

/// The scene's own proofs: what is written passes `grazing check`, what is enclosed is enclosed tightly.
#[test]
fn the_example_scene_proves_what_it_says() {
    let folder = tempfile::tempdir().unwrap();
    let grazing = |args: &[&str]| {
        let output = Command::new(crate::PROGRAM).args(args).output().unwrap();
        assert!(output.status.success(), "{args:?}: {}", String::from_utf8_lossy(&output.stderr));
        serde_json::from_slice::<serde_json::Value>(&output.stdout).unwrap()
    };
    let path = folder.path().to_str().unwrap();
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/scenes/nordmark-2001.toml");
    let report = grazing(&["run", scene, "--only", "proofs", "-o", path, "--format", "json"]);
    let (mut certificates, mut events) = (0, 0);
    for task in report["tasks"].as_array().unwrap() {
        for row in task["proofs"].as_array().into_iter().flatten() {
            assert_eq!(row["verdict"], "proved", "{task}");
            let file = folder.path().join(row["certificate"].as_str().unwrap());
            let checked = grazing(&["check", file.to_str().unwrap(), "--format", "json"]);
            if let Some(event) = task["event"].as_str() {
                assert!(row["width"].as_f64().unwrap() <= 2.001e-20, "{task}");
                let [lower, upper] = ["lower", "upper"].map(|end| row[end].as_str().unwrap());
                let detail = &checked["files"][0]["detail"];
                assert!(detail["event"].as_str().unwrap().starts_with(event), "{checked}");
                assert_eq!(detail["parameter"], format!("mu, from {lower} to {upper}"));
                assert!(number(upper) - number(lower) <= power_of_ten(20));
                events += 1;
                continue;
            }
            let stable = if row["stable"] == true { "stable" } else { "unstable" };
            assert_eq!(checked["files"][0]["detail"]["stability"], stable, "{checked}");
            certificates += 1;
        }
    }
    assert_eq!((certificates, events), (3, 4));
}
