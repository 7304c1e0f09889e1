//! Certificates of orbits: what is written passes, what breaks a rule or is damaged is rejected unless it is
//! still true.

use crate::common;
use crate::samples::{samples, tried};
use crate::systems;

use std::sync::LazyLock;

use common::damage::{damage, damaged};
use grazing_scenes::{
    certificate::{self, Rejection},
    motion::System,
    number::Precision,
    search::orbit::{self, ProvedOrbit, Stability, Verdict},
};
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};
use proptest::{prelude::*, strategy::ValueTree};
use systems::{Case, at, cases, lower, number, prove, proved};

fn written(case: &Case) -> String {
    text_of(&case.system, &proved(prove(&case.system, &case.impacts)))
}

fn text_of(system: &System<BigRational>, orbit: &ProvedOrbit) -> String {
    orbit::certificate(system, orbit).unwrap().accepted.text().to_string()
}

fn check(text: &str) -> Result<certificate::Checked, Rejection> {
    certificate::check(&mut text.as_bytes())
}

#[test]
fn what_is_written_passes() {
    for case in cases() {
        let text = written(&case);
        let checked = check(&text).unwrap();
        let periods = u64::from(case.impacts.iter().map(|impact| impact.periods).sum::<u32>());
        assert_eq!((checked.kind, checked.range), ("orbit", Some(periods..=periods)), "{}", case.name);
        assert_eq!(checked.lines, text.lines().count() as u64);
        let claim = if case.stability == Stability::Stable { "stable" } else { "unstable" };
        let digest = text.lines().find_map(|line| line.strip_prefix("digest ")).unwrap();
        assert_eq!(checked.detail.first().unwrap(), &("stability", claim.to_string()));
        assert_eq!(checked.detail.last().unwrap(), &("digest", digest.to_string()));
    }
}

/// A force that no decimal of 34 digits tells from what it was.
fn long(case: Case) -> Case {
    let force = &case.system.force + number("1e-40");
    Case { system: System { force, ..case.system }, ..case }
}

/// Version 2, where one coefficient is too long for version 1: every coefficient lies in its interval, which
/// is narrow.
#[test]
fn long_coefficients_are_held_in_intervals() {
    for case in cases().into_iter().map(long) {
        let text = written(&case);
        assert!(text.starts_with("grazing-certificate 1\nkind orbit 2\n"), "{text}");
        let checked = check(&text).unwrap();
        assert_eq!((checked.kind, checked.statement), ("orbit", certificate::orbit::STATEMENT_2));
        let bounds = |start: &str, word: usize| {
            let line = text.lines().find(|line| line.starts_with(start)).unwrap();
            let (lower, upper) = line.split(' ').nth(word).unwrap().split_once("..").unwrap();
            (number(lower), number(upper))
        };
        let mut known = vec![
            (bounds("damping", 1), &case.system.damping),
            (bounds("stiffness", 1), &case.system.stiffness),
            (bounds("force", 1), &case.system.force),
        ];
        if let Some(wall) = &case.system.lower {
            known.push((bounds("lower", 1), &wall.offset));
            known.push((bounds("lower", 2), &wall.restitution));
        }
        for ((lower, upper), value) in known {
            assert!(lower <= *value && *value <= upper && upper - lower < number("2e-33"), "{}", case.name);
        }
        let (lower, upper) = bounds("force", 1);
        assert!(lower < upper);
        // The claim is proved for all of the interval; that of the other version is not accepted for it.
        let other = if case.stability == Stability::Stable { "unstable" } else { "stable" };
        let line = text.lines().find(|line| line.starts_with("orbit ")).unwrap();
        let (count, _) = line.rsplit_once(' ').unwrap();
        let answer = check(&with(&text, "orbit ", &format!("{count} {other}"))).unwrap_err().to_string();
        assert!(answer.contains("the orbit is not certainly"), "{answer}");
        assert!(check(&with(&text, "kind", "kind orbit")).is_err());
    }
    let case = cases().remove(0);
    let huge = System { force: number("1073741824"), ..at("-0.05") };
    let error = orbit::certificate(&huge, &proved(prove(&case.system, &case.impacts))).unwrap_err();
    assert!(error.is_input() && error.to_string().contains("between -2^30 and 2^30"), "{error}");
}

/// What is accepted of a wide interval is true at its ends and within, by the proof in balls; and none is
/// accepted that is too wide.
#[test]
fn a_wide_interval_is_a_statement_about_all_of_it() {
    let case = long(cases().remove(0));
    let text = written(&case);
    let widened = |half: &str| {
        let (lower, upper) = (number("0.95") - number(half), number("0.95") + number(half));
        let decimal = |x: &BigRational| format!("0.{:018}", (x * number("1e18")).to_integer());
        let decimal = |x: &BigRational| decimal(x).trim_end_matches('0').to_string();
        let text =
            with(&text, "harmonic", &format!("harmonic 1 {}..{} 0..0", decimal(&lower), decimal(&upper)));
        let text = with(&text, "radius", "radius 0.05 0.04");
        ([lower, upper], resealed(text))
    };
    let (mut accepted, mut refused) = (0, 0);
    for half in ["0.000000000000000001", "0.000001", "0.0001", "0.001", "0.002", "0.005", "0.02", "0.3"] {
        let (ends, text) = widened(half);
        if check(&text).is_err() {
            refused += 1;
            continue;
        }
        accepted += 1;
        let [phase, speed] = [3, 4].map(|i| {
            let line = text.lines().find(|line| line.starts_with("impact")).unwrap();
            number(line.split(' ').nth(i).unwrap())
        });
        for part in 0..=4 {
            let a = &ends[0] + (&ends[1] - &ends[0]) * BigRational::new(part.into(), 4.into());
            let system = System { force: number("1e-40"), ..at(&(a - number("1")).to_string()) };
            let orbit = proved(prove(&system, &case.impacts));
            for (x, middle) in [(&orbit.phases[0], &phase), (&orbit.velocities[0], &speed)] {
                let (lo, hi) = x.exact_bounds().unwrap();
                assert!(middle - number("0.04") < lo && hi < middle + number("0.04"), "{half}");
            }
            assert_eq!(orbit.stability, Some(case.stability));
        }
    }
    assert!(accepted >= 3 && refused >= 2, "{accepted} {refused}");
}

/// The certificate of the first case with one line replaced, found by its beginning.
fn with(text: &str, start: &str, line: &str) -> String {
    let at = text.lines().position(|line| line.starts_with(start)).unwrap();
    let lines: Vec<&str> =
        text.lines().enumerate().map(|(i, old)| if i == at { line } else { old }).collect();
    lines.join("\n") + "\n"
}

/// The certificate with the digest of the system that it now holds.
fn resealed(text: String) -> String {
    let answer = check(&text).map_or_else(|rejection| rejection.to_string(), |_| String::new());
    match answer.split_once("not that of the system, which is ") {
        Some((_, digest)) => with(&text, "digest", &format!("digest {digest}")),
        None => text,
    }
}

#[test]
fn rejections_name_the_line_and_the_reason() {
    let text = written(&cases()[0]);
    assert_eq!(resealed(text.clone()), text);
    let ends: Vec<&str> = text.lines().filter(|line| line.starts_with("until")).collect();
    let last = ends[ends.len() - 1];
    let cases = [
        (
            with(&text, "statement", "statement 1 = 1"),
            "line 3: malformed: the statement is not, word for word",
        ),
        (
            with(&text, "damping", "damping 12/48"),
            "line 5: malformed: expected a fraction p/q in lowest terms",
        ),
        (
            with(&text, "damping", "damping 12/-49"),
            "line 5: malformed: expected a fraction p/q in lowest terms",
        ),
        (with(&text, "damping", "damping 12/50"), "line 5: malformed"),
        (with(&text, "damping", "damping 11/49"), "line 4: false: the digest is not that of the system"),
        (resealed(with(&text, "damping", "damping 11/49")), "false: Krawczyk's test does not map"),
        (resealed(with(&text, "harmonic", "harmonic 1 21/20 0/1")), "false: Krawczyk's test does not map"),
        (resealed(with(&text, "harmonic", "harmonic 2 19/20 0/1")), "false: Krawczyk's test does not map"),
        (resealed(with(&text, "lower", "lower -1/1 -1/1 1")), "a restitution is at least 0"),
        (with(&text, "lower", "lower none"), "line 10: malformed: expected a line \"upper …\""),
        (with(&text, "upper", "upper 1/2 1/1 0"), "line 4: false: the digest"),
        // A wall that the orbit would cross: everything else is still right.
        (resealed(with(&text, "upper", "upper 1/2 1/1 0")), "is not certainly positive"),
        (with(&text, "orbit", "orbit 1 unstable"), "false: the orbit is not certainly unstable"),
        (with(&text, "orbit", "orbit 0 stable"), "the periods of an orbit must not sum to 0"),
        (with(&text, "orbit", "orbit 2 stable"), "malformed: expected a line \"impact …\""),
        (with(&text, "orbit", "orbit 1 steady"), "malformed: expected stable, unstable or open"),
        (with(&text, "impact", "impact upper 4 -0.6833 0.6"), "malformed: there is no upper wall"),
        (with(&text, "impact", "impact lower 3 -0.6833 0.6"), "false: Krawczyk's test does not map"),
        (with(&text, "impact", "impact lower 4 -0.6833 -0.6"), "false: Krawczyk's test does not map"),
        (with(&text, "impact", "impact lower 4 -0.6833 0.6"), "in unknown 1"),
        (with(&text, "impact", "impact lower 4 -.6833 0.6"), "malformed: expected a decimal"),
        (with(&text, "radius", "radius 2 0.000000000000000001"), "false: Krawczyk's test does not map"),
        (with(&text, "radius", "radius 0.1 0.2"), "false: the smaller radius must be positive and at most"),
        (with(&text, "radius", "radius 0.1 0"), "false: the smaller radius must be positive and at most"),
        (with(&text, "radius", "radius 0.1 -0.01"), "false: the smaller radius must be positive and at most"),
        (with(&text, "radius", "radius 0.1 0.0000000000000000000000000001"), "false: Krawczyk's test"),
        (with(&text, "row", "row 0 0"), "false: Krawczyk's test does not map"),
        (with(&text, "row", "row 1"), "malformed: expected a decimal, found the end"),
        (with(&text, "flight", "flight 0"), "malformed: a flight has at least one piece"),
        (with(&text, ends[3], ends[1]), "false: the pieces of flight 1 do not follow one another"),
        (with(&text, last, "until 25.1327"), "false: the pieces of flight 1 stop before its end"),
        (with(&text, last, "until 28"), "the gap on piece 64 of flight 1 is not certainly positive"),
        (text.clone() + "\n", "malformed: the file goes on after the last flight"),
        (text.replace(&format!("{last}\n"), ""), "the file ends where a line \"until …\" should stand"),
    ];
    for (damaged, expected) in cases {
        let answer = check(&damaged).map_or_else(|rejection| rejection.to_string(), |_| "accepted".into());
        assert!(answer.contains(expected), "{answer}, expected {expected}");
    }
    // Fewer pieces than the proof needs.
    let coarse = text.replace("flight 64", "flight 1");
    let coarse: String =
        coarse.lines().filter(|line| !line.starts_with("until")).map(|line| format!("{line}\n")).collect();
    let answer = check(&format!("{coarse}{last}\n")).unwrap_err().to_string();
    assert!(answer.contains("the gap on piece 1 of flight 1"), "{answer}");
}

/// A solution past its grazing, with everything but admissibility in order.
#[test]
fn an_orbit_through_the_wall_is_rejected() {
    let before = Case { system: at("-0.02445"), impacts: vec![lower(4, -0.76, 0.67)], ..cases().remove(0) };
    let text = written(&before);
    assert!(check(&text).is_ok());
    // µ_gr4 = −0.0244474…: a little further the stable branch passes through the wall.
    let beyond = at("-0.0244");
    let verdict = prove(&beyond, &before.impacts);
    assert!(matches!(verdict, Verdict::Refuted(_)));
    let solution =
        proved(orbit::solution_in(&beyond, &before.impacts, &number("0.05"), &Precision::new(128)).unwrap());
    let digits = |i: usize| {
        let (lo, _) = solution[i].exact_bounds().unwrap();
        let scaled = (lo * number("1e24")).round().to_integer();
        format!("{}0.{:024}", if scaled.is_negative() { "-" } else { "" }, scaled.abs())
    };
    let moved = with(&text, "impact", &format!("impact lower 4 {} {}", digits(0), digits(1)));
    let moved = with(&moved, "harmonic", "harmonic 1 2439/2500 0/1");
    let moved = resealed(moved);
    let answer = check(&moved).unwrap_err().to_string();
    assert!(answer.contains("is not certainly positive") && answer.contains("the gap on piece"), "{answer}");
    // However few the pieces, and whatever their middles say.
    let lines: Vec<&str> = moved.lines().collect();
    let first = lines.iter().position(|line| line.starts_with("until")).unwrap();
    for (from, count) in (0..60).flat_map(|from| (2..24).step_by(3).map(move |count| (from, count))) {
        let mut fewer = lines.clone();
        let count = count.min(lines.len() - 1 - first - from);
        fewer.drain(first + from..first + from + count);
        let flight = format!("flight {}", fewer.len() - first);
        fewer[first - 1] = &flight;
        let answer = check(&(fewer.join("\n") + "\n")).unwrap_err().to_string();
        assert!(answer.contains("the gap on piece"), "{from} {count}: {answer}");
    }
}

/// Negative damping, elastic: complex multipliers outside the unit circle, D > 1 and 1 + D ± T > 0.
#[test]
fn complex_multipliers_outside_the_circle_are_not_stable() {
    let mut system = at("1");
    (system.damping, system.stiffness) = (number("-1/65"), number("100/169"));
    let orbit = proved(prove(&system, &[lower(1, 3.07391, 2.04442)]));
    assert_eq!(orbit.stability, Some(Stability::Unstable));
    let text = text_of(&system, &orbit);
    assert!(check(&text).is_ok());
    let answer = check(&with(&text, "orbit", "orbit 1 stable")).unwrap_err().to_string();
    assert!(answer.contains("the orbit is not certainly stable"), "{answer}");
}

/// Whether what an accepted certificate of the first or third case says is true, by the proof in balls: only
/// the claim, the middle of the box and its radius can have changed, since the digest holds the system and
/// the pattern cannot change without the rest.
fn is_true(text: &str, case: &Case) -> bool {
    let orbit = proved(prove(&case.system, &case.impacts));
    let words = |start: &str| -> Vec<Vec<String>> {
        let lines = text.lines().filter(|line| line.starts_with(start));
        lines.map(|line| line.split(' ').map(String::from).collect()).collect()
    };
    let m = case.impacts.len();
    let impacts = words("impact");
    let centre: Vec<BigRational> =
        impacts.iter().map(|w| number(&w[3])).chain(impacts.iter().map(|w| number(&w[4]))).collect();
    let same = |i: usize| impacts[i][1] == "lower" && impacts[i][2] == case.impacts[i].periods.to_string();
    let radius = number(&words("radius")[0][1]);
    let all = orbit.phases.iter().chain(&orbit.velocities);
    let contains = all.zip(&centre).all(|(x, c)| {
        let (lo, hi) = x.exact_bounds().unwrap();
        c - &radius < lo && hi < c + &radius
    });
    // The only one there: inside the box of the proof, or proved again.
    let inside = orbit.centre.iter().zip(&centre).all(|(a, b)| (a - b).abs() + &radius <= orbit.radius);
    let again = || {
        let mut guess = case.impacts.clone();
        for (i, impact) in guess.iter_mut().enumerate() {
            (impact.phase, impact.velocity) = (centre[i].to_f64().unwrap(), centre[m + i].to_f64().unwrap());
        }
        let wider = &radius + number("1e-12");
        let verdict = orbit::solution_in(&case.system, &guess, &wider, &Precision::new(128)).unwrap();
        matches!(verdict, Verdict::Proved(_))
    };
    let claim = match (words("orbit ")[0][2].as_str(), case.stability) {
        ("stable", stability) => stability == Stability::Stable,
        ("unstable", stability) => stability == Stability::Unstable,
        (claim, _) => claim == "open",
    };
    impacts.len() == m && (0..m).all(same) && contains && (inside || again()) && claim
}

/// Thousands of damaged certificates; those that pass are confirmed true.
#[test]
fn damage_is_detected() {
    let mut runner = common::runner(1);
    let strategy = damage();
    let lists = [cases(), cases().into_iter().map(long).collect()];
    for (version, index) in [(0, 0), (0, 2), (1, 0)] {
        let case = &lists[version][index];
        let text = written(case);
        assert!(is_true(&text, case));
        let body = text.lines().position(|line| line.starts_with("orbit")).unwrap();
        let (mut rejected, mut unchanged, mut still_true) = (0, 0, 0);
        for round in 0..samples::<u64>(300) {
            let damage = strategy.new_tree(&mut runner).unwrap().current();
            // Half of the time past the header, which the digest and the statement guard.
            let changed = damaged(&text, if round % 2 == 0 { 0 } else { body }, &damage);
            if changed == text {
                unchanged += 1;
            } else if check(&changed).is_ok() {
                assert!(is_true(&changed, case), "accepted though false, after {damage:?}:\n{changed}");
                still_true += 1;
            } else {
                rejected += 1;
            }
        }
        println!("{rejected} rejected, {still_true} still true, {unchanged} unchanged");
        assert!(rejected > 4 * still_true && tried(still_true, 7));
    }
}

proptest! {
    #![proptest_config(common::config())]

    #[test]
    fn text_of_any_kind_is_an_answer_and_no_panic(text in "(?s).{0,300}", words in "[0-9 ./-]{0,80}", line in 0usize..40) {
        let headed = format!("grazing-certificate 1\nkind orbit\n{text}");
        prop_assert!(check(&headed).is_err());
        static TEXT: LazyLock<String> = LazyLock::new(|| written(&cases()[0]));
        let text = &*TEXT;
        let mut lines: Vec<String> = text.lines().map(String::from).collect();
        let line = 3 + line % (lines.len() - 3);
        let name = lines[line].split(' ').next().unwrap().to_string();
        lines[line] = format!("{name} {words}");
        let _ = check(&(lines.join("\n") + "\n"));
    }
}
