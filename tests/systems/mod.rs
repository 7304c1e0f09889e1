//! Oscillators of every kind that the proofs distinguish, each with an orbit.

// Each test program uses a part of this.
#![allow(dead_code)]

use grazing_scenes::{
    motion::{Harmonic, Side, System, Wall},
    number::{Precision, Real, parse_rational},
    search::orbit::{self, ExpectedImpact, ProvedOrbit, Stability, Verdict},
};
use num_rational::BigRational;

pub fn number(text: &str) -> BigRational {
    parse_rational(text).unwrap()
}

/// The paper's example, section 4: (65)–(67), d = 0.6, w = 4.9, τ = 1, over any numbers.
pub fn example<T: Real>(mu: &T, context: &T::Context) -> System<T> {
    let ratio = |text: &str| T::ratio(&number(text), context);
    let motion = Harmonic { k: 1, cos: ratio("1") + mu, sin: ratio("0") };
    System {
        rate: None,
        damping: ratio("12/49"),
        stiffness: ratio("100/2401"),
        cubic: ratio("0"),
        force: ratio("0"),
        smooth: None,
        forcing: Vec::new(),
        lower: Some(Wall { offset: ratio("-1"), harmonics: vec![motion], restitution: ratio("1") }),
        upper: None,
    }
}

pub fn at(mu: &str) -> System<BigRational> {
    example(&number(mu), &())
}

pub fn lower(periods: u32, phase: f64, velocity: f64) -> ExpectedImpact {
    ExpectedImpact { side: Side::Lower, periods, phase, velocity }
}

fn upper(periods: u32, phase: f64, velocity: f64) -> ExpectedImpact {
    ExpectedImpact { side: Side::Upper, periods, phase, velocity }
}

fn harmonic(k: u32, cos: &str, sin: &str) -> Harmonic<BigRational> {
    Harmonic { k, cos: number(cos), sin: number(sin) }
}

fn still(offset: &str) -> Option<Wall<BigRational>> {
    Some(Wall { offset: number(offset), harmonics: Vec::new(), restitution: number("7/10") })
}

/// An orbit to prove.
pub struct Case {
    pub name: &'static str,
    pub system: System<BigRational>,
    pub impacts: Vec<ExpectedImpact>,
    pub stability: Stability,
}

/// Oscillating, without stiffness, without damping, overdamped, critically damped; one wall, two; forced and
/// not.
pub fn cases() -> Vec<Case> {
    let table = |damping, stiffness| System {
        damping: number(damping),
        stiffness: number(stiffness),
        force: number("-1/5"),
        lower: Some(Wall {
            offset: number("0"),
            harmonics: vec![harmonic(1, "0", "1/2")],
            restitution: number("4/5"),
        }),
        ..at("0")
    };
    let two_walls = System {
        damping: number("1/10"),
        stiffness: number("1/4"),
        forcing: vec![harmonic(1, "3/2", "0"), harmonic(3, "0", "1/10")],
        lower: still("-1/2"),
        upper: still("1/2"),
        ..at("0")
    };
    let round =
        [upper(0, -0.311, 1.189), upper(0, 0.884, 0.735), lower(1, 2.832, 1.189), lower(0, -2.255, 0.735)];
    let chatter = [lower(0, -0.425, 0.651), lower(1, 0.847, 0.2347)];
    let double = [lower(3, 0.0039, 0.0182), lower(3, -0.1078, 0.1098)];
    let case = |name, system, impacts: &[ExpectedImpact], stability| Case {
        name,
        system,
        impacts: impacts.to_vec(),
        stability,
    };
    use Stability::{Stable, Unstable};
    vec![
        case("node", at("-0.05"), &[lower(4, -0.6833, 0.6)], Stable),
        case("saddle", at("-0.05"), &[lower(4, -0.144, 0.1363)], Unstable),
        case("double impact", at("0.006"), &double, Unstable),
        case("bouncing ball", table("0", "0"), &[lower(1, 1.43, 0.7)], Unstable),
        case("falling with drag", table("1/20", "0"), &[lower(1, 1.4, 0.7)], Unstable),
        case("overdamped", table("1", "1/5"), &chatter, Stable),
        case("critically damped", table("1/5", "1/100"), &[lower(1, 1.1, 0.7)], Unstable),
        case("two walls", two_walls, &round, Stable),
    ]
}

pub fn prove(system: &System<BigRational>, impacts: &[ExpectedImpact]) -> Verdict<ProvedOrbit> {
    orbit::orbit(system, impacts, &Precision::new(128)).unwrap()
}

pub fn proved<T>(verdict: Verdict<T>) -> T {
    match verdict {
        Verdict::Proved(proof) => proof,
        Verdict::Refuted(why) | Verdict::Undecided(why) => panic!("not proved: {why}"),
    }
}
