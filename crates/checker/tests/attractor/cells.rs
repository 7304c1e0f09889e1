//! Version 2, by cells with weights: what passes, what must be refused, and whether it is true of motions.

use super::{
    lie, machine,
    motions::{least_growth, returns},
};
use crate::common::{
    ATTRACTOR_CELLS, ATTRACTOR_CELLS_SEVERAL, ATTRACTOR_CELLS_WIDE, Random, answer, are_refused, damage,
    damaged_so_are_true, nth, second_reader, with,
};
use crate::samples::{one_in, samples};
use grazing_check::attractor::cells::STATEMENT;

const ALL: [&str; 3] = [ATTRACTOR_CELLS, ATTRACTOR_CELLS_WIDE, ATTRACTOR_CELLS_SEVERAL];

fn changed(text: &str, name: &str, line: &str) -> String {
    with(text, &format!("{name} "), &format!("{name} {line}"))
}

/// With the `at`-th cell, from 0, in place of another, or without it.
fn cell(text: &str, at: usize, line: &str) -> String {
    let line = if line.is_empty() { line.to_string() } else { format!("cell {line}") };
    nth(text, "cell ", at, &line).replace("\n\n", "\n")
}

#[test]
fn what_is_written_passes_and_is_named() {
    let checked = answer(ATTRACTOR_CELLS).unwrap();
    assert_eq!((checked.kind, checked.statement), ("attractor", STATEMENT));
    let said = checked.to_string();
    for part in [
        "proved, chaos that attracts",
        "depth: every nu with 1/127 <= nu <= 1/126",
        "weights from 871171 to 1000000 in 16 cells of -V/sqrt(nu) 1.2229 at each contact",
        "come after 9 periods at most",
        "exponent: at least 0.02515 in a period 2 pi",
    ] {
        assert!(said.contains(part), "{part}: {said}");
    }
    for text in ALL {
        assert_eq!(answer(text).map_err(|why| why.to_string()).err(), None);
        assert_eq!(lie(text, samples(60)), None);
        let grown: f64 =
            text.lines().find_map(|line| line.strip_prefix("growth ")).unwrap()[..4].parse().unwrap();
        let seen = least_growth(text, samples(20));
        println!("{grown} proved, {seen:.4} seen");
        assert!((0.75..1.01).contains(&(grown / seen)), "{grown} {seen}");
    }
}

/// The first cell in so many that there are this many, with returns after up to 200 periods.
fn many(cells: usize) -> String {
    let text = changed(&changed(ATTRACTOR_CELLS, "growth", "1.21 0.024 200"), "cells", &cells.to_string());
    let part = |i: usize| format!("{} 1000000", short(2.5e-4 * i as f64));
    cell(&text, 0, &(1..=cells - 15).map(part).collect::<Vec<_>>().join("\ncell "))
}

#[test]
fn weaker_claims_pass() {
    for (name, line) in [
        ("depths", "1/127 1/127"),
        ("depths", "1/126 1/126"),
        ("depths", "2/253 2/253"),
        ("window", "0.12608 0.1260719"),
        ("bends", "0.992 1"),
        ("slip", "0.0325"),
        ("start", "0.5"),
        ("growth", "1.2 0.01 9"),
        ("growth", "1.22 0.025 50"),
        ("growth", "1.0001 0.0251 200"),
        ("restitution", "7999/10000 4/5"),
    ] {
        let text = changed(&changed(ATTRACTOR_CELLS, "growth", "1.21 0.024 9"), name, line);
        assert_eq!(answer(&text).map_err(|why| why.to_string()).err(), None, "{name} {line}");
        assert_eq!(lie(&text, 30), None);
    }
    assert_eq!(answer(&many(200)).map_err(|why| why.to_string()).err(), None);
    // A cell in two, each with its weight.
    let text = cell(&changed(ATTRACTOR_CELLS, "cells", "17"), 12, "0.68 942385\ncell 0.709748813 942385");
    assert_eq!(answer(&text).map_err(|why| why.to_string()).err(), None);
}

fn forgeries() -> Vec<(String, &'static str)> {
    let mut all = Vec::new();
    for (name, line, reason) in [
        // One digit too far.
        ("growth", "1.223 0.02515 9", "(B3)"),
        ("growth", "1.2229 0.0252 9", "(B3)"),
        ("growth", "1.3 0.02 9", "(B3)"),
        ("growth", "1.2229 0.02515 7", "returns may be after more than 7 periods (B2)"),
        ("growth", "1.2229 0.02515 1", "(B2)"),
        ("window", "0.126 0.1260719", "outside the window (A1)"),
        ("window", "0.1260719 0.126", "outside the window (A1)"),
        ("bends", "0.9921 1", "bend otherwise in the window (A1)"),
        ("bends", "0.99206349 0.999", "bend otherwise in the window (A1)"),
        ("slip", "0.0323", "the slip may be greater (A2)"),
        ("start", "1.4", "(A6)"),
        ("start", "0.0001", "(A6)"),
        // Nu beyond, into the windows on either side, and other machines.
        ("depths", "1/127 1/110", "(A1)"),
        ("depths", "1/150 1/126", "(B3)"),
        ("depths", "1/1000 1/126", "(B"),
        ("damping", "3/5 31/50", ""),
        ("stiffness", "1/25 1/20", ""),
        ("restitution", "7/10 4/5", "(A3)"),
        ("restitution", "4/5 9/10", ""),
    ] {
        all.push((changed(ATTRACTOR_CELLS, name, line), reason));
    }
    let fewer = |text: &str, number: &str| changed(text, "cells", number);
    // A cell missing, so that the next one is as large as both.
    for at in [11, 12, 13, 14] {
        all.push((cell(&fewer(ATTRACTOR_CELLS, "15"), at, ""), "(B3)"));
    }
    // The weights of one cell more or less than they may be, and of all that are not the same.
    for (at, line) in [
        (12, "0.709748813 942600"),
        (12, "0.709748813 1000000"),
        (13, "0.764344875 870000"),
        (14, "0.818940938 800000"),
        (15, "0.873537 870000"),
        (15, "0.873537 1"),
        (15, "0.873537 1000000"),
        (8, "0.491364563 1"),
    ] {
        all.push((cell(ATTRACTOR_CELLS, at, line), "(B3)"));
    }
    let flat = (12..16).fold(ATTRACTOR_CELLS.to_string(), |text, at| {
        let end = text.lines().filter(|line| line.starts_with("cell ")).nth(at).unwrap();
        let end = end.split(' ').nth(1).unwrap().to_string();
        cell(&text, at, &format!("{end} 1000000"))
    });
    all.push((flat, "(B3)"));
    // A trap that is too small.
    let slow = cell(&changed(ATTRACTOR_CELLS, "speed", "0.8735"), 15, "0.8735 871171");
    all.push((slow, "contacts may be faster (A3)"));
    // The window of period 9, with the stable orbit; there the growth is less in any cells.
    let window = [
        ("depths", "1/200 1/200"),
        ("window", "0.1001 0.1001"),
        ("bends", "0.995 1"),
        ("growth", "1.00001 0.00001 200"),
    ];
    let inside =
        window.iter().fold(ATTRACTOR_CELLS.to_string(), |text, (name, line)| changed(&text, name, line));
    all.push((inside, "(B3)"));
    all
}

fn malformed() -> Vec<(String, &'static str)> {
    let lines = [
        ("depths", "0/1 1/126", "positive"),
        ("depths", "1/126 1/127", "decrease"),
        ("depths", "1/126", "expected"),
        ("growth", "1 0.02515 9", "above 1"),
        ("growth", "1.2229 0 9", "positive"),
        ("growth", "1.2229 -0.01 9", "positive"),
        ("growth", "1.2229 0.02515 0", "at least 1"),
        ("growth", "1.2229 0.02515 201", "200"),
        ("cells", "0", "at least 1"),
        ("cells", "2001", "2000"),
        ("cells", "15", "ends at the speed"),
        ("cells", "17", "the file ends"),
        ("speed", "0.9", "ends at the speed"),
    ];
    let mut all: Vec<(String, &'static str)> = lines
        .into_iter()
        .map(|(name, line, reason)| (changed(ATTRACTOR_CELLS, name, line), reason))
        .collect();
    for (at, line, reason) in [
        (3, "0.21838425 0", "at least 1"),
        (3, "0.21838425 1000001", "1000000"),
        (3, "0.21838425 1.5", "number"),
        (3, "0.1 1000000", "increase"),
        (0, "0 1000000", "positive"),
        (15, "0.9 871171", "ends at the speed"),
    ] {
        all.push((cell(ATTRACTOR_CELLS, at, line), reason));
    }
    all.push((many(201), "would take up to 40200 returns, more than 40000: fewer cells or periods"));
    all.push((with(ATTRACTOR_CELLS, "depths", "depth 1/126"), "depths"));
    all.push((with(ATTRACTOR_CELLS, "statement", "statement For all"), "word for word"));
    all.push((format!("{ATTRACTOR_CELLS}cell 1 1\n"), "goes on"));
    all
}

#[test]
fn forgeries_are_refused() {
    are_refused(&forgeries(), &malformed());
}

/// The reader in Python, written from the form and the theorem alone, gives the same verdicts.
#[test]
fn two_readers_agree() {
    let right = ALL.map(String::from).into_iter();
    let wrong = forgeries().into_iter().chain(malformed()).map(|(text, _)| text).step_by(one_in(4));
    let mut random = Random(9);
    let damaged =
        ALL.map(|text| (0..samples::<usize>(6)).map(|_| damage(&mut random, text)).collect::<Vec<_>>());
    let all: Vec<String> = right.chain(wrong).chain(damaged.into_iter().flatten()).collect();
    let Some(verdicts) = second_reader("attractor.py", &all) else { return };
    let mut accepted = 0;
    for (text, line) in all.iter().zip(&verdicts) {
        let ours = answer(text);
        accepted += usize::from(ours.is_ok());
        assert_eq!(ours.is_ok(), line.ends_with(": proved, chaos that attracts"), "{ours:?}, {line}\n{text}");
    }
    assert!(accepted >= ALL.len(), "{accepted}");
}

/// GRAZING_SAMPLES times as many of them.
#[test]
fn what_is_accepted_of_damaged_certificates_is_true() {
    for (seed, text) in (14..).zip(ALL) {
        damaged_so_are_true((seed, samples(90), samples::<usize>(90) / 50), text, damage, |text| {
            lie(text, 12)
        });
    }
}

/// The floats see what is false.
#[test]
fn floats_notice_lies() {
    let flat = "0.873537 1000000\n";
    for (text, what) in [
        (changed(ATTRACTOR_CELLS, "growth", "1.6 0.001 9"), "growth by"),
        (changed(ATTRACTOR_CELLS, "growth", "1.01 0.3 9"), "an exponent of"),
        (changed(ATTRACTOR_CELLS, "growth", "1.01 0.01 7"), "an exponent of"),
        (changed(ATTRACTOR_CELLS, "depths", "1/200 1/200"), "growth by"),
        (cell(ATTRACTOR_CELLS, 14, "0.818940938 500000"), "growth by"),
        (cell(ATTRACTOR_CELLS, 15, flat.trim_end()), "growth by"),
    ] {
        let found = lie(&text, 600).unwrap_or_default();
        assert!(found.contains(what), "{what}: {found:?}");
    }
}

/// A certificate at the depth 10⁻⁴ with these cells and weights, d = 3/2, w = 8 and τ = 4/5 but for what is
/// changed.
fn thin(parameters: [&str; 3], trap: [&str; 2], cells: &[(f64, f64)]) -> String {
    let mut text = machine(
        parameters,
        &[
            ("depth", "1/10000"),
            ("window", "0.0141423 0.0141423"),
            ("bends", "0.9999 1"),
            ("speed", trap[0]),
            ("slip", trap[1]),
        ],
    );
    text = text.split("\ngrowth ").next().unwrap().replace("kind attractor", "kind attractor 2");
    text = with(&text, "statement", &format!("statement {STATEMENT}"));
    text = text.replace("depth 1/10000", "depths 1/10000 1/10000");
    text += &format!("start 0.5\ngrowth 1.00001 0.000001 200\ncells {}\n", cells.len() + 1);
    for (end, weight) in cells {
        text += &format!("cell {} {}\n", short(*end), weight.round());
    }
    text + &format!("cell {} 1000\n", trap[0])
}

fn short(x: f64) -> String {
    format!("{x:.12}").trim_end_matches('0').trim_end_matches('.').to_string()
}

/// Of a cell of hardly any width nothing is given away: its weight may be what motions grow by, and no more;
/// and what it returns to is where motions return to, and no more.
#[test]
fn a_thin_cell_is_as_motions_are() {
    const PART: f64 = 1.0003;
    let mut tried = 0;
    for (parameters, trap) in [
        (["3/8", "1/64", "4/5"], ["0.72", "0.05892"]),
        (["1/1", "1/30", "9/10"], ["0.6246", "0.002763"]),
        (["1/1", "1/30", "1/5"], ["0.6246", "0.002763"]),
        (["3/10", "1/200", "3/1"], ["0.45905", "0.06252"]),
    ] {
        for s in [0.11, 0.2, 0.3, 0.37, 0.42] {
            let ends = [s, s + 1e-9];
            let [grown, least, greatest] = returns(&thin(parameters, trap, &[(s, 1000.0)]), s);
            let text = |times: f64| {
                let weight = 1000.0 * grown * times / 1.00001;
                thin(parameters, trap, &[(ends[0], 1000.0), (ends[1], weight)])
            };
            let verdict = |text: &str| answer(text).map_or_else(|why| why.to_string(), |_| String::new());
            let [weak, strong] = [1.0 / PART, PART].map(|times| verdict(&text(times)));
            assert_eq!(weak, "", "{parameters:?} {s}: {grown}");
            assert!(strong.contains("cell 2: growth may be less"), "{parameters:?} {s}: {strong}");
            // All that it returns to in one heavy cell, or not all.
            if least < ends[1] + 1e-3 || greatest + 1e-3 > trap[0].parse().unwrap() {
                continue;
            }
            let heavy = |[from, to]: [f64; 2]| {
                let cells =
                    [(ends[0], 1000.0), (ends[1], 1000.0 * grown * 1.1), (from, 1000.0), (to, 1000.0 * 1.2)];
                verdict(&thin(parameters, trap, &cells))
            };
            let room = 2e-4;
            assert_eq!(heavy([least - room, greatest + room]), "", "{parameters:?} {s}: {least} {greatest}");
            for part in [[least + 1e-6, greatest + room], [least - room, greatest - 1e-6]] {
                let why = heavy(part);
                assert!(why.contains("cell 2: growth may be less"), "{parameters:?} {s} {part:?}: {why}");
            }
            tried += 1;
        }
    }
    assert!(tried > 8, "{tried}");
}

/// A cell so slow that only contacts after the top are in it, where the wall falls.
#[test]
fn contacts_after_the_top_count() {
    let text = |slowest: f64| {
        let cells = [(1e-5, slowest), (0.24, 1000.0), (0.48, 1000.0)];
        answer(&thin(["3/8", "1/64", "4/5"], ["0.72", "0.05892"], &cells)).map_err(|why| why.to_string())
    };
    assert_eq!(text(1000.0).err(), None);
    let why = text(1.0).unwrap_err();
    assert!(why.contains("growth may be less") && !why.contains("cell 1:"), "{why}");
}
