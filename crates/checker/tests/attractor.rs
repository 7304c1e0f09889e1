//! Certificates of kind attractor: what passes, what must be refused, and whether what those say that pass,
//! also the damaged ones, is true of motions in floats: of where they hit, and how fast they part.

mod cells;
mod motions;
mod page;

use crate::common::{
    ATTRACTOR, ATTRACTOR_SEVERAL, ATTRACTOR_WIDE, Random, answer, are_refused, damage, damaged_so_are_true,
    float, second_reader, with,
};
use crate::samples::{one_in, samples};
use grazing_check::attractor::STATEMENT;
use motions::{least_growth, lie};

const ALL: [&str; 3] = [ATTRACTOR, ATTRACTOR_WIDE, ATTRACTOR_SEVERAL];

/// d, w and τ of the paper's oscillator, as this kind has them: c, k and τ.
fn machine(ranges: [&str; 3], lines: &[(&str, &str)]) -> String {
    let names = ["damping", "stiffness", "restitution"];
    let whole = names.iter().zip(ranges).fold(ATTRACTOR.to_string(), |text, (name, range)| {
        let range = if range.contains(' ') { range.to_string() } else { format!("{range} {range}") };
        with(&text, name, &format!("{name} {range}"))
    });
    lines.iter().fold(whole, |text, (name, line)| with(&text, &format!("{name} "), &format!("{name} {line}")))
}

/// d = 3/2, w = 8, τ = 4/5 at some depth.
fn paper(lines: &[(&str, &str)]) -> String {
    machine(["3/8", "1/64", "4/5"], lines)
}

#[test]
fn what_is_written_passes_and_is_named() {
    let checked = answer(ATTRACTOR).unwrap();
    assert_eq!((checked.kind, checked.statement), ("attractor", STATEMENT));
    let said = checked.to_string();
    for part in [
        "proved, chaos that attracts",
        "overdamped",
        "depth: every nu with 0 < nu <= 1/100",
        "growth: 1.15 at each contact",
        "exponent: at least 0.005 in a period 2 pi for nu >= 1/10000",
    ] {
        assert!(said.contains(part), "{part}: {said}");
    }
    for text in ALL {
        assert_eq!(answer(text).map_err(|why| why.to_string()).err(), None);
        assert_eq!(lie(text, samples(40)), None);
    }
}

/// Such a part of the growth that is seen is proved, at least.
const PARTS: [f64; 5] = [0.7, 0.7, 0.7, 0.75, 0.75];

/// The depths, growths and exponents that the formulas give in floats, for µ = ν/(1 − ν) in the paper's
/// units.
#[test]
fn the_formulas_reach_what_they_should() {
    let rows = [
        (
            "1/11",
            "0.4297",
            "0.909090909",
            "0.72232",
            "0.0786482",
            ["1.0051 11", "1.0052 11"],
            "1/11 0.01508 10",
        ),
        (
            "3/103",
            "0.241946",
            "0.97087378",
            "0.720656",
            "0.0688807",
            ["1.2319 13", "1.2320 13"],
            "3/103 0.02124 12",
        ),
        (
            "1/101",
            "0.140836",
            "0.990099",
            "0.720201",
            "0.0642257",
            ["1.3212 14", "1.3213 14"],
            "1/101 0.04204 13",
        ),
        (
            "1/1001",
            "0.0447028",
            "0.99900099",
            "0.72",
            "0.0601423",
            ["1.3997 18", "1.3998 18"],
            "1/1001 0.03125 17",
        ),
        ("1/10001", "0.0141416", "0.9999", "0.71998", "0.0589088", ["1.4204 22", "1.4205 22"], "none"),
    ];
    for ((depth, window, bend, speed, slip, growths, exponent), part) in rows.into_iter().zip(PARTS) {
        let (window, bends) = (format!("{window} {window}"), format!("{bend} 1"));
        let lines = |growth| {
            paper(&[
                ("depth", depth),
                ("window", &window),
                ("bends", &bends),
                ("speed", speed),
                ("slip", slip),
                ("growth", growth),
                ("start", "1.5"),
                ("exponent", exponent),
            ])
        };
        let text = lines(growths[0]);
        assert_eq!(answer(&text).map_err(|why| why.to_string()).err(), None, "{depth}");
        assert_eq!(lie(&text, 40), None);
        // What is proved of all depths below, over what motions do at the greatest.
        let seen = least_growth(&text, samples(8));
        let proved = float(growths[0].split(' ').next().unwrap());
        println!("nu = {depth}: {proved} proved, {seen:.4} seen, {:.3} of it", proved / seen);
        assert!((part..1.0).contains(&(proved / seen)), "{depth}: {proved} {seen}");
        let why = answer(&lines(&growths[1].replace("1.2320", "1.233").replace("0 1", "01 1"))).unwrap_err();
        assert!(why.to_string().contains("(A5)"), "{depth}: {why}");
    }
}

/// An exponent is the least over all returns, here that of eleven periods.
#[test]
fn each_return_bounds_the_exponent() {
    let lines = |exponent| {
        paper(&[
            ("depth", "1/11"),
            ("window", "0.4297 0.4297"),
            ("bends", "0.909090909 1"),
            ("speed", "0.72232"),
            ("slip", "0.0786482"),
            ("growth", "1.0051 11"),
            ("start", "1.5"),
            ("exponent", exponent),
        ])
    };
    assert!(answer(&lines("1/1000 0.00046 17")).is_ok());
    let why = answer(&lines("1/1000 0.0005 17")).unwrap_err().to_string();
    assert!(why.contains("over 11 periods (A7)"), "{why}");
}

#[test]
fn weaker_claims_pass() {
    for (name, line) in [
        ("depth", "1/200"),
        ("window", "0.15 0.142"),
        ("bends", "0.981 1"),
        ("speed", "0.74"),
        ("slip", "0.075"),
        ("growth", "1.15 20"),
        ("growth", "1.01 100"),
        ("start", "0.01"),
        ("exponent", "none"),
        ("exponent", "1/5000 0.001 50"),
        ("restitution", "79/100 4/5"),
    ] {
        let text = paper(&[("growth", "1.14 15"), (name, line)]);
        assert_eq!(answer(&text).map_err(|why| why.to_string()).err(), None, "{name} {line}");
        assert_eq!(lie(&text, 20), None);
    }
}

/// d = 3/2, w = 5, where λ₁ = 0.62 < 2/3, at a small depth, with a trap that holds.
fn slower(growth: &str) -> String {
    let lines = [
        ("depth", "1/1001"),
        ("window", "0.0448 0.0448"),
        ("bends", "0.999 1"),
        ("speed", "0.8744"),
        ("slip", "0.03"),
        ("growth", growth),
        ("start", "0.2"),
        ("exponent", "none"),
    ];
    machine(["3/5", "1/25", "4/5"], &lines)
}

fn forgeries() -> Vec<(String, &'static str)> {
    let mut all = Vec::new();
    for (name, line, reason) in [
        // One digit too far.
        ("growth", "1.17 14", "(A5)"),
        ("growth", "1.15 13", "over 13 periods or more (A5)"),
        ("growth", "1.15 1", "over 1 periods or more (A5)"),
        ("growth", "1.17 100", "(A5)"),
        ("window", "0.1415 0.15", "outside the window (A1)"),
        ("window", "0.15 0.1415", "outside the window (A1)"),
        ("window", "0.14154 6.2", "outside the window (A1)"),
        ("window", "3.14159 3.15", "outside the window (A1)"),
        ("window", "3.1415926 3.1416", "outside the window (A1)"),
        ("window", "3.1 3.1", "the slip may be greater (A2)"),
        ("bends", "0.99000001 1.01", "bend otherwise in the window (A1)"),
        ("bends", "0.98 0.99999999", "bend otherwise in the window (A1)"),
        ("speed", "0.72", "contacts may be faster (A3)"),
        ("slip", "0.064", "the slip may be greater (A2)"),
        ("slip", "300", "convex before a contact (A3)"),
        ("start", "2.4", "(A6)"),
        ("start", "0.000699", "less than what is trapped (A6)"),
        ("start", "100", "(A6)"),
        ("exponent", "1/10000 0.02 25", "the exponent may be less over"),
        ("exponent", "1/10000 0.005 20", "may be after more periods (A7)"),
        ("exponent", "1/1000000 0.005 25", "may be after more periods (A7)"),
        ("exponent", "1/10000 0.5 25", "periods (A7)"),
        // Deeper, and other machines: of another λ₁, not overdamped, with more at an impact.
        ("depth", "1/88", "(A1)"),
        ("depth", "2/1", "(A1)"),
        ("damping", "1/4 1/4", "overdamped (A1)"),
        ("damping", "1/5 3/8", "overdamped (A1)"),
        ("damping", "-3/8 -3/8", "overdamped (A1)"),
        ("stiffness", "1/64 3/64", "overdamped (A1)"),
        ("stiffness", "0/1 1/64", "overdamped (A1)"),
        ("stiffness", "-1/64 1/64", "overdamped (A1)"),
        ("damping", "3/8 2/5", ""),
        ("damping", "10/1 10/1", "(A3)"),
        ("restitution", "4/5 1/1", ""),
        ("restitution", "1/2 4/5", ""),
        ("restitution", "20/1 20/1", ""),
    ] {
        all.push((with(ATTRACTOR, &format!("{name} "), &format!("{name} {line}")), reason));
    }
    for (name, line, reason) in [
        ("depth", "1/190", "outside the window (A1)"),
        ("window", "0.0874 0.088059", "outside the window (A1)"),
        ("window", "0.087467 0.088", "outside the window (A1)"),
        ("window", "1.3 0.088059", "concave in the window (A1)"),
        ("window", "0.087467 1.2", "concave in the window (A1)"),
        ("bends", "1.27 1.324", "bend otherwise in the window (A1)"),
        ("bends", "1.257 1.31", "bend otherwise in the window (A1)"),
        ("concave", "1.3 1.14", "may not be concave (A1)"),
        ("concave", "1.21 1.3", "may not be concave (A1)"),
        ("concave", "0.09 0.09", "outside the window (A1)"),
        ("concave", "3.2 3.2", "longer than a period (A1)"),
        ("pieces", "3", "(A1)"),
        ("slip", "0.0619", "(A2)"),
        ("speed", "0.827", "(A3)"),
        ("growth", "1.3 16", "(A5)"),
    ] {
        all.push((with(ATTRACTOR_SEVERAL, &format!("{name} "), &format!("{name} {line}")), reason));
    }
    // Fast rates, and more speed after an impact than before.
    let strong = [
        ("depth", "1/10000"),
        ("window", "0.01415 0.01415"),
        ("bends", "0.9999 1"),
        ("speed", "0.6"),
        ("slip", "0.001"),
        ("growth", "1.3 46"),
        ("start", "0.001"),
        ("exponent", "none"),
    ];
    all.push((machine(["40/1", "7/20", "5/1"], &strong), "convex after a contact (A4)"));
    all.push((slower("1.00001 40"), "growth may be less over"));
    all.push((slower("1.00001 9"), "growth may be less over"));
    // µ beyond µ₁: what the formulas would reach there is below 1.
    let deep = [
        ("depth", "1/10"),
        ("window", "0.45103 0.45103"),
        ("bends", "0.9 1"),
        ("speed", "0.73"),
        ("slip", "0.08"),
        ("growth", "1.00001 11"),
        ("start", "1"),
        ("exponent", "none"),
    ];
    all.push((paper(&deep), "(A5)"));
    all
}

fn malformed() -> Vec<(String, &'static str)> {
    let lines = [
        ("depth", "0/1", "positive"),
        ("depth", "-1/100", "positive"),
        ("window", "0 0.2", "positive"),
        ("window", "0.2", "expected"),
        ("window", "0.2 0.2 0.2", "unexpected"),
        ("bends", "-1 1", "positive"),
        ("speed", "0", "positive"),
        ("slip", "0", "positive"),
        ("slip", "0.10", "decimal"),
        ("growth", "1 14", "above 1"),
        ("growth", "0.9 14", "above 1"),
        ("growth", "1.3 0", "at least 1"),
        ("growth", "1.3 1001", "1000"),
        ("start", "0", "positive"),
        ("exponent", "0/1 0.01 21", "positive"),
        ("exponent", "1/10000 0 21", "positive"),
        ("exponent", "1/10000 0.01 0", "at least 1"),
        ("exponent", "1/10000 0.01 2001", "2000"),
        ("exponent", "1/99 0.01 21", "up to the greatest"),
        ("exponent", "none none", "unexpected"),
        ("restitution", "0/1 4/5", "positive"),
        ("harmonic", "1 9/10 9/10 0/1 0/1", "sum to 1"),
        ("harmonic", "2 1/1 1/1 0/1 0/1", "expected a line \"concave"),
        ("harmonic", "1 1/1 1/1 -1/10 1/10", "expected a line \"concave"),
    ];
    let change = |(name, line, reason): (&str, &str, _)| {
        (with(ATTRACTOR, &format!("{name} "), &format!("{name} {line}")), reason)
    };
    let mut all: Vec<(String, &'static str)> = lines.into_iter().map(change).collect();
    all.push((format!("{ATTRACTOR}exponent none\n"), "goes on"));
    all.push((with(ATTRACTOR, "statement", "statement"), "word for word"));
    all.push((with(ATTRACTOR, "start", "pieces 10\nstart 2"), "start"));
    all
}

#[test]
fn forgeries_are_refused() {
    are_refused(&forgeries(), &malformed());
}

/// The reader in Python, written from the form and the theorem alone, gives the same verdicts.
#[test]
fn two_readers_agree() {
    let right = ALL.map(String::from).into_iter().chain([paper(&[("growth", "1.01 100")])]);
    let wrong = forgeries().into_iter().chain(malformed()).map(|(text, _)| text).step_by(one_in(3));
    let mut random = Random(7);
    let damaged =
        ALL.map(|text| (0..samples::<usize>(12)).map(|_| damage(&mut random, text)).collect::<Vec<_>>());
    let all: Vec<String> = right.chain(wrong).chain(damaged.into_iter().flatten()).collect();
    let Some(verdicts) = second_reader("attractor.py", &all) else { return };
    let mut accepted = 0;
    for (text, line) in all.iter().zip(&verdicts) {
        let ours = answer(text);
        accepted += usize::from(ours.is_ok());
        assert_eq!(ours.is_ok(), line.ends_with(": proved, chaos that attracts"), "{ours:?}, {line}\n{text}");
    }
    assert!(accepted > ALL.len(), "{accepted}");
}

/// GRAZING_SAMPLES times as many of them.
#[test]
fn what_is_accepted_of_damaged_certificates_is_true() {
    for (seed, text) in (4..).zip(ALL) {
        damaged_so_are_true((seed, samples(120), samples::<usize>(120) / 50), text, damage, |text| {
            lie(text, 12)
        });
    }
}

/// The floats see what is false: each number of a certificate, changed by more than it has room for.
#[test]
fn floats_notice_lies() {
    for (name, line, what) in [
        ("window", "0.12 0.14154", "the wall is beyond rest"),
        ("bends", "0.999 1", "the wall bends"),
        ("bends", "0.98 0.995", "the wall bends"),
        ("speed", "0.5", "V ="),
        ("slip", "0.005", "slip"),
        ("growth", "2.5 14", "growth by"),
        ("exponent", "1/10000 0.3 25", "an exponent of"),
        ("exponent", "1/10000 0.01 3", "an exponent of"),
        ("damping", "1/5 1/5", "not overdamped"),
        ("depth", "1/2", "beyond rest"),
    ] {
        let text = with(ATTRACTOR, &format!("{name} "), &format!("{name} {line}"));
        let found = lie(&text, 400).unwrap_or_default();
        assert!(found.contains(what), "{name} {line}: {found:?}");
    }
}
