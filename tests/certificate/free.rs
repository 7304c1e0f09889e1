//! Certificates of motions without impacts, written for oscillators drawn at random, both as oscillators and
//! as machines of one coordinate: proved where the gap in floats is open, refuted where it is not.

use crate::{
    common::damage::{damage, damaged},
    machine::{as_machine, plainly},
    systems::{Case, number},
};

use std::f64::consts::TAU;

use grazing_scenes::{
    certificate,
    many::orbit::{Itinerary, find},
    motion::{Harmonic, System, Wall},
    number::Precision,
    search::{
        machine::{self, listed as list},
        orbit::{Stability, Verdict, free_certificate, free_motion},
    },
};
use num_rational::BigRational;
use proptest::{
    prelude::*,
    strategy::ValueTree,
    test_runner::{Config, TestRng, TestRunner},
};

/// c, k, two harmonics of the force and where the walls are, in hundredths.
type Drawn = (i64, i64, [i64; 4], [i64; 2]);

fn drawn() -> impl Strategy<Value = Drawn> {
    let wave = || prop::array::uniform4(-100i64..=100);
    (1i64..=150, 5i64..=900, wave(), prop::array::uniform2(1i64..=400))
}

fn hundredths(x: i64) -> BigRational {
    BigRational::new(x.into(), 100.into())
}

fn system((c, k, [a, b, d, e], walls): &Drawn) -> System<BigRational> {
    let wall = |x: i64| Wall {
        offset: hundredths(x),
        harmonics: vec![Harmonic { k: 3, cos: hundredths(x / 9), sin: hundredths(0) }],
        restitution: number("0.8"),
    };
    let wave = |k, cos: &i64, sin: &i64| Harmonic { k, cos: hundredths(*cos), sin: hundredths(*sin) };
    System {
        rate: None,
        damping: hundredths(*c),
        stiffness: hundredths(*k),
        cubic: number("0"),
        force: number("0"),
        smooth: None,
        forcing: vec![wave(1, a, b), wave(2, d, e)],
        lower: Some(wall(-walls[0])),
        upper: Some(wall(walls[1])),
    }
}

/// The least gap, in floats: the response by complex numbers, at 2000 phases.
fn least_gap((c, k, [a, b, d, e], walls): &Drawn) -> f64 {
    let [c, k, a, b, d, e] = [*c, *k, *a, *b, *d, *e].map(|x| x as f64 / 100.0);
    let answer = |nu: f64, a: f64, b: f64| {
        let (re, im) = (k - nu * nu, c * nu);
        let size = re * re + im * im;
        ((re * a - im * b) / size, (re * b + im * a) / size)
    };
    let (one, two) = (answer(1.0, a, b), answer(2.0, d, e));
    let gap = |t: f64| {
        let q = one.0 * t.cos() + one.1 * t.sin() + two.0 * (2.0 * t).cos() + two.1 * (2.0 * t).sin();
        let place = |x: i64| x as f64 / 100.0 + (x / 9) as f64 / 100.0 * (3.0 * t).cos();
        (q - place(-walls[0])).min(place(walls[1]) - q)
    };
    (0..2000).map(|i| gap(TAU * f64::from(i) / 2000.0)).fold(f64::INFINITY, f64::min)
}

fn draws(count: usize) -> Vec<Drawn> {
    let rng = TestRng::deterministic_rng(proptest::test_runner::RngAlgorithm::ChaCha);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    (0..count).map(|_| drawn().new_tree(&mut runner).unwrap().current()).collect()
}

#[test]
fn motions_without_impacts_are_proved_where_the_gap_is_open() {
    let precision = Precision::new(128);
    let (mut open, mut met) = (0, 0);
    for drawn in draws(60) {
        let (system, least) = (system(&drawn), least_gap(&drawn));
        match free_motion(&system, &precision).unwrap() {
            Verdict::Proved(proof) => {
                assert!(least > 0.0, "{drawn:?}: {least}");
                assert_eq!(proof.stability, Some(Stability::Stable));
                let text = free_certificate(&system, &proof).unwrap().accepted.text().to_string();
                let checked = certificate::check(&mut text.as_bytes()).unwrap();
                assert_eq!((checked.kind, checked.range), ("orbit", Some(1..=1)));
                assert!(text.contains("\nkind orbit 3\n") && text.contains("\norbit 0 stable\n"), "{text}");
                open += 1;
            }
            Verdict::Refuted(why) => {
                assert!(least < 1e-4 && why.contains("is negative"), "{drawn:?}: {least}, {why}");
                met += 1;
            }
            Verdict::Undecided(why) => panic!("{drawn:?}: {least}, {why}"),
        }
    }
    assert!(open > 10 && met > 10, "{open} {met}");
}

/// The same as machines of one coordinate.
#[test]
fn machines_of_one_coordinate_agree() {
    let mut proved = 0;
    for drawn in draws(25) {
        let system = system(&drawn);
        let case = Case { name: "drawn", impacts: Vec::new(), stability: Stability::Stable, system };
        let (machine, _) = as_machine(&case);
        let near = find(&plainly(&machine), &Itinerary::free(1).unwrap(), &[]).unwrap();
        match machine::free_motion(&list(&machine).unwrap(), &near, &mut || false).unwrap() {
            Verdict::Proved(proof) => {
                assert!(least_gap(&drawn) > 0.0, "{drawn:?}");
                let checked = certificate::check(&mut proof.accepted.text().as_bytes()).unwrap();
                assert_eq!((checked.kind, checked.range), ("machine-orbit", Some(1..=1)));
                assert!(proof.accepted.text().contains("\norbit 0 stable\n"), "{}", proof.accepted.text());
                proved += 1;
            }
            _ => assert!(least_gap(&drawn) < 1e-4, "{drawn:?}: {}", least_gap(&drawn)),
        }
    }
    assert!(proved > 5, "{proved}");
}

/// Near a touch, an unstable motion, one on which the method has nothing to say.
#[test]
fn what_is_not_proved_is_said() {
    let precision = Precision::new(128);
    let at = |c: &str, k: &str, offset: &str| System {
        rate: None,
        damping: number(c),
        stiffness: number(k),
        cubic: number("0"),
        force: number("0"),
        smooth: None,
        forcing: vec![Harmonic { k: 1, cos: number("1"), sin: number("0") }],
        lower: Some(Wall { offset: number(offset), harmonics: Vec::new(), restitution: number("1") }),
        upper: None,
    };
    // q″ = −2q + cos t has the motion cos t, which touches a wall at −1.
    let undamped = |offset: &str| free_motion(&at("0", "2", offset), &precision).unwrap();
    let Verdict::Undecided(why) = undamped("-1") else { panic!() };
    assert!(why.contains("cannot be told from 0 3.14159") && why.contains("after phase 0"), "{why}");
    let Verdict::Refuted(why) = undamped("-0.9999999999") else { panic!() };
    assert!(why.contains("is negative 3.14159"), "{why}");
    let system = at("0", "2", "-1.0000000001");
    let Verdict::Proved(proof) = free_motion(&system, &precision).unwrap() else { panic!() };
    assert_eq!(proof.stability, None);
    let text = free_certificate(&system, &proof).unwrap().accepted.text().to_string();
    assert!(text.contains("\norbit 0 open\n") && certificate::check(&mut text.as_bytes()).is_ok(), "{text}");
    let system = at("-0.1", "2", "-2");
    let Verdict::Proved(proof) = free_motion(&system, &precision).unwrap() else { panic!() };
    assert_eq!(proof.stability, Some(Stability::Unstable));
    assert!(free_certificate(&system, &proof).unwrap().accepted.text().contains("\norbit 0 unstable\n"));
    let Verdict::Undecided(why) = free_motion(&at("0", "4", "-2"), &precision).unwrap() else { panic!() };
    assert!(why.contains("1 may be a multiplier"), "{why}");
    assert!(free_motion(&at("0", "1", "-2"), &precision).unwrap_err().to_string().contains("resonance"));
    // Without stiffness 1 is a multiplier.
    let Verdict::Undecided(why) = free_motion(&at("0.1", "0", "-2"), &precision).unwrap() else { panic!() };
    assert!(why.contains("1 may be a multiplier"), "{why}");
}

/// Random damage below the digest's lines: what is still accepted makes the same claim, or claims less.
#[test]
fn damage_is_refused_unless_it_is_still_true() {
    let precision = Precision::new(128);
    let open = draws(60).into_iter().find(|drawn| least_gap(drawn) > 0.05).unwrap();
    let Verdict::Proved(proof) = free_motion(&system(&open), &precision).unwrap() else { panic!() };
    let text = free_certificate(&system(&open), &proof).unwrap().accepted.text().to_string();
    let known = certificate::check(&mut text.as_bytes()).unwrap();
    let mut runner = crate::common::runner(1);
    let (mut refused, mut accepted) = (0, 0);
    for _ in 0..2000 {
        let text = damaged(&text, 2, &damage().new_tree(&mut runner).unwrap().current());
        match certificate::check(&mut text.as_bytes()) {
            Err(_) => refused += 1,
            Ok(checked) => {
                assert_eq!((checked.kind, &checked.range), (known.kind, &known.range));
                assert_eq!(checked.detail[1..], known.detail[1..], "{text}");
                assert!(checked.detail[0] == known.detail[0] || text.contains("\norbit 0 open\n"), "{text}");
                accepted += 1;
            }
        }
    }
    assert!(refused > 1000 && crate::samples::tried(accepted, 10), "{refused} {accepted}");
}
