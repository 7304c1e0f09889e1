//! Proved orbits and events of the paper's example against closed formulas and Newton's method by mpmath
//! (tests/data/oscillator.csv).

use grazing::{
    Result,
    number::{Ball, Elementary, Precision, Real, parse_rational},
    oscillator::{
        Harmonic, Side, System, Wall,
        validate::{self, Condition, Impact, Jet, Stability, Verdict},
    },
};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero, pow};

fn number(text: &str) -> BigRational {
    parse_rational(text).unwrap()
}

/// The paper's example, section 4: (65)–(67).
fn example<T: Real>(mu: &T, context: &T::Context) -> System<T> {
    let ratio = |text: &str| T::ratio(&number(text), context);
    let cos = ratio("1") + mu;
    let motion = Harmonic { k: 1, cos, sin: ratio("0") };
    System {
        damping: ratio("12/49"),
        stiffness: ratio("100/2401"),
        cubic: ratio("0"),
        force: ratio("0"),
        forcing: Vec::new(),
        lower: Some(Wall { offset: ratio("-1"), harmonics: vec![motion], restitution: ratio("1") }),
        upper: None,
    }
}

fn impact(periods: u32, phase: f64, velocity: f64) -> Impact {
    Impact { side: Side::Lower, periods, phase, velocity }
}

fn proved<T>(verdict: Verdict<T>) -> T {
    match verdict {
        Verdict::Proved(proof) => proof,
        Verdict::Refuted(why) | Verdict::Undecided(why) => panic!("not proved: {why}"),
    }
}

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
    let lines = include_str!("data/oscillator.csv").lines().map(|line| line.split(',').collect::<Vec<_>>());
    lines.filter(|words| words[0] == kind).collect()
}

#[test]
fn orbits_agree_with_the_closed_formulas() {
    let precision = Precision::new(128);
    let stable = [("3", "0.0058"), ("4", "-0.05"), ("4", "-0.01")];
    for words in rows("orbit") {
        let (n, mu, t, v) = (words[1], words[2], words[3], words[4]);
        let system = example(&number(mu), &());
        let guess = impact(n.parse().unwrap(), t[..10].parse().unwrap(), v[..10].parse().unwrap());
        let verdict = validate::orbit(&system, &[guess], &precision).unwrap();
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
        println!("{words:?} {} {:?}", orbit.radius, orbit.trace.exact_bounds().map(|(lo, _)| lo.to_f64()));
        assert!(orbit.radius >= power_of_ten(8), "{words:?}: {}", orbit.radius);
    }
}

#[test]
fn a_box_without_a_solution_is_refuted() {
    let precision = Precision::new(128);
    let system = example(&number("-0.05"), &());
    let radius = power_of_ten(3);
    let at = |phase, velocity| {
        validate::solution_in(&system, &[impact(4, phase, velocity)], &radius, &precision).unwrap()
    };
    assert!(matches!(at(-0.6833, 0.6), Verdict::Proved(_)));
    assert!(matches!(at(-0.6633, 0.62), Verdict::Refuted(_)));
    assert!(matches!(at(0.3, 0.62), Verdict::Refuted(_)));
    // A box as wide as both branches' orbits: Krawczyk's test must not pass it.
    let wide = validate::solution_in(&system, &[impact(4, -0.41, 0.37)], &number("0.5"), &precision).unwrap();
    assert!(matches!(wide, Verdict::Undecided(_)));
    // Below the saddle-node there is nothing to find.
    let gone = example(&number("-0.0844"), &());
    let verdict = validate::orbit(&gone, &[impact(4, -0.41, 0.37)], &precision).unwrap();
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
        let verdict = validate::event(family(&precision), &impacts, mu, condition, &precision).unwrap();
        let event = proved(verdict);
        println!(
            "{name} {} {:?}",
            event.radius,
            event.parameter.exact_bounds().map(|(lo, hi)| (lo.to_f64(), (hi - lo).to_f64()))
        );
        assert!(agrees(&event.parameter, words[2], 20), "{name}: {:?}", event.parameter);
        if let (Some(time), Some(expected)) = (&event.time, words.get(3)) {
            assert!(agrees(time, expected, 20), "{name}");
        }
    }
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
        validate::event(
            family(&precision),
            &[impact(4, -0.41, 0.365)],
            -0.0843,
            Condition::SaddleNode,
            &precision,
        )
        .unwrap(),
    );
    let difference = mu - &event.parameter;
    assert!(difference.contains(&BigRational::zero()) && difference.exponent() < -180, "{difference:?}");
}

#[test]
fn a_system_outside_the_method_is_an_input_error() {
    let precision = Precision::new(64);
    let good = example(&BigRational::zero(), &());
    let cubic = System { cubic: BigRational::one(), ..good.clone() };
    let resonant = System {
        damping: BigRational::zero(),
        stiffness: BigRational::from_integer(4.into()),
        forcing: vec![Harmonic { k: 2, cos: BigRational::one(), sin: BigRational::zero() }],
        ..good.clone()
    };
    for (system, word) in [(&cubic, "cubic"), (&resonant, "resonance")] {
        let error = validate::orbit(system, &[impact(1, 0.0, 0.1)], &precision).unwrap_err();
        assert!(error.is_input() && error.to_string().contains(word), "{error}");
    }
    let above = Impact { side: Side::Upper, ..impact(1, 0.0, 0.1) };
    assert!(validate::orbit(&good, &[above], &precision).unwrap_err().to_string().contains("no upper wall"));
    assert!(validate::orbit(&good, &[impact(0, 0.0, 0.1)], &precision).unwrap_err().is_input());
}
