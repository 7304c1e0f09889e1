//! Certificates of kind range: what passes, and what must be refused.

use crate::common::{
    CHAOS_12, RANGE_1, RANGE_12, RANGE_13, RANGE_ALONE, RANGE_BEFORE, answer, are_refused, nth,
    second_reader, with,
};
use crate::samples::one_in;
use grazing_check::range::{STATEMENT, STATEMENT_2};

#[test]
fn what_is_written_passes_and_is_named() {
    let checked = answer(RANGE_1).unwrap();
    assert_eq!((checked.kind, checked.range.clone(), checked.statement), ("range", None, STATEMENT));
    assert_eq!(
        checked.to_string(),
        "proved, range of orbits
  claim: orbits: that there is more than one path is not claimed, nor that the entropy is positive
  motion: q'' = -c q' - k q above the wall -nu - 1 + cos t, restitution tau
  damping: 1/10
  stiffness: 3/10
  restitution: 4/5
  depth: every nu with 0 < nu <= 1/10, in 6 cells, linked
  letters: 1: 1 period, then 1
  impacts: g' = nu s/2, in each cell the part that it lists, between letters 1, 1: from 2.081727 to 2.397615
  window: impacts within 1.2 of multiples of 2 pi
  contraction: at most 0.999
  entropy: per period between log 1 and log 1.00000000001
  others: not excluded: there may be other orbits near"
    );
    for text in [RANGE_12, RANGE_13] {
        let said = answer(text).unwrap().to_string();
        assert!(said.starts_with("proved, range of chaos\n  claim: chaos: paths branch"), "{said}");
    }
}

/// README's machine at a touch: one letter, one cell.
fn one(side: &str, letter: &str, depth: &str, edge: &str) -> String {
    let start = RANGE_1.split("cells 6\n").next().unwrap();
    let text = format!("{start}cells 1\ncell {depth} 1 0\nedge {edge}\n");
    with(&with(&text, "side", &format!("side {side}")), "letter ", &format!("letter {letter} 1"))
}

/// What is accepted may be made weaker.
#[test]
fn weaker_claims_pass() {
    for text in [
        one("-1", "1", "1/100", "2 2.5 1 1"),
        one("-1", "1", "1/1000", "2 2.5 1 0.001"),
        one("-1", "3", "1/100", "1.9 2.2 1 1"),
        nth(RANGE_1, "cell ", 1, "cell 37/800 2 10"),
        nth(RANGE_1, "cell ", 5, "cell 99/1000 1 1000"),
        with(RANGE_1, "pieces", "pieces 16"),
        with(RANGE_1, "window", "window 0.8"),
        with(&one("-1", "1", "1/100", "2 2.5 1 1"), "damping", "damping 99/1000 1/10"),
        with(RANGE_12, "contraction", "contraction 0.95"),
        with(RANGE_ALONE, "others", "others no"),
        with(RANGE_ALONE, "longest", "longest 4"),
        with(RANGE_ALONE, "rounds", "rounds 9"),
        nth(RANGE_ALONE, "others", 0, "others 2.9 2 2"),
        with(RANGE_BEFORE, "others", "others no"),
        with(RANGE_BEFORE, "others", "others 6 2 2"),
        with(RANGE_BEFORE, "longest", "longest 15"),
        with(RANGE_BEFORE, "longest", "longest 10"),
        with(RANGE_BEFORE, "damping", "damping 99999/1000000 1/10"),
    ] {
        assert!(answer(&text).is_ok(), "{:?}: {text}", answer(&text));
    }
}

/// Certificates that put false words around true claims, or true words around nothing, each with the
/// condition that it fails.
fn forgeries() -> Vec<(String, &'static str)> {
    let mut all: Vec<(String, &'static str)> = Vec::new();
    let mut add = |reason: &'static str, texts: Vec<String>| {
        assert!(texts.len() >= 10, "{reason}: {}", texts.len());
        all.extend(texts.into_iter().map(|text| (text, reason)));
    };
    let loops = |cases: &[(&str, &str, &str, &str)]| -> Vec<String> {
        cases.iter().map(|(side, letter, depth, edge)| one(side, letter, depth, edge)).collect()
    };
    let edges = |text: &str, cases: &[(usize, &str)]| -> Vec<String> {
        cases.iter().map(|&(at, line)| nth(text, "edge", at, &format!("edge {line}"))).collect()
    };
    let lines = |text: &str, cases: &[(&str, &str)]| -> Vec<String> {
        cases.iter().map(|(start, line)| with(text, start, line)).collect()
    };
    let h0 = loops(&[
        ("-1", "1", "1/1", "2 2.5 1 1"),
        ("-1", "1", "2/1", "-1 1 1 1"),
        ("-1", "1", "1/10", "2 20 1 1"),
        ("-1", "1", "1/10", "-20 2 1 1"),
        ("-1", "1", "1/100", "-400 400 0 1"),
        ("1", "2", "1/100", "1.3 200 1 1"),
        ("-1", "3", "3/1", "1 1.2 1 1"),
        ("-1", "1", "30000/1", "2 2.5 1 1"),
    ]);
    let narrow = [with(RANGE_1, "window", "window 0.01"), with(RANGE_12, "window", "window 0.2")];
    add("outside the window (H0)", h0.into_iter().chain(narrow).collect());
    let mut e1 = loops(&[
        ("-1", "1", "1/100", "2 2.1 1 1"),
        ("-1", "1", "1/100", "2.25 2.5 1 1"),
        ("-1", "1", "1/100", "-2.5 -2 1 1"),
        ("-1", "1", "1/100", "2.2 2.2000001 1 1"),
        ("-1", "1", "1/100", "2 2.5 20 1"),
        ("-1", "1", "1/100", "2 2.5 -1 1"),
        ("-1", "1", "1/10", "2 2.5 1 1"),
        ("1", "1", "1/100", "2 2.5 1 1"),
        ("-1", "2", "1/100", "2 2.5 1 1"),
    ]);
    e1.extend(lines(RANGE_1, &[("stiffness", "stiffness 31/100 31/100"), ("damping", "damping 1/20 1/20")]));
    // E₁₂ = 0: no leg of one period without damping at stiffness 1.
    let singular = with(RANGE_1, "damping", "damping 0/1 0/1");
    e1.push(with(&singular, "stiffness", "stiffness 1/1 1/1"));
    e1.extend(edges(RANGE_12, &[(0, "0.06 0.0848644 1.009818 0.37"), (2, "-0.0919266 -0.06 1 0.49")]));
    add("(E1)", e1);
    let mut e2 = edges(RANGE_1, &[(0, "2 2.5 0 1"), (0, "1 4 0 1"), (1, "2 2.5 0 1"), (5, "2 2.5 0 1")]);
    e2.extend(loops(&[
        ("-1", "1", "1/100", "2 2.5 0 0.000000001"),
        ("-1", "1", "1/1000", "2 3 0 1"),
        ("-1", "3", "1/100", "1 3 0 1"),
        ("1", "1", "1/100", "2 2.5 0 1"),
    ]));
    e2.extend(edges(
        RANGE_12,
        &[
            (0, "0.0522247 0.0848644 1.009818 0.00001"),
            (1, "0.6835538 0.7669964 1.037114 0.00001"),
            (3, "0.5381695 0.6261987 1.047477 0.01"),
        ],
    ));
    e2.extend(lines(RANGE_1, &[("contraction", "contraction 0.1")]));
    e2.extend(lines(RANGE_12, &[("contraction", "contraction 0.2")]));
    add("(E2)", e2);
    let e3 = loops(&[
        ("-1", "2", "1/100", "-1.5 -1.2 1 1"),
        ("-1", "4", "1/100", "-2.3 -1.8 1 1"),
        ("-1", "6", "1/1000", "-4.3 -3.5 1 1"),
        ("-1", "8", "1/10000", "-11 -9 1 1"),
        ("1", "1", "1/100", "-2.4 -1.9 1 1"),
        ("1", "3", "1/100", "-2.3 -1.8 1 1"),
        ("1", "5", "1/1000", "-3.1 -2.8 1 1"),
        ("1", "7", "1/10000", "-6.1 -5.9 1 1"),
        ("1", "1", "1/10000000", "-2.3 -2.1 0.5 1"),
        ("1", "1", "1/1000", "-2.4 -1.9 1.2 1"),
    ]);
    add("(E3)", e3);
    let h4 = loops(&[
        ("1", "2", "1/100", "1.2 1.5 1 1"),
        ("1", "2", "1/1000000", "1.33 1.34 1 1"),
        ("1", "4", "1/100", "1.9 2.2 1 1"),
        ("1", "4", "1/10000", "2 2.1 0.9 1"),
        ("1", "6", "1/1000", "3.6 4.1 1 1"),
        ("1", "8", "1/10000", "9.4 10.3 1 1"),
        ("-1", "5", "1/10000", "2.9 3 1 1"),
        ("-1", "5", "1/10000000", "2.96 2.97 1 1"),
        ("-1", "7", "1/10000", "5.9 6.1 1 1"),
        ("-1", "7", "1/10000000", "5.98 6 1 1"),
    ]);
    add("(H4)", h4);
    let mut link = edges(
        RANGE_1,
        &[
            (1, "2.3 2.371127 0.7833256 1"),
            (1, "2.131981 2.2 0.7833256 1"),
            (1, "5 6 0.7833256 1"),
            (1, "-2.371127 -2.131981 0.7833256 1"),
            (2, "2.38 2.4 0.6996879 1"),
            (5, "2.294504 2.3 0.5714203 1"),
            (5, "2.39 2.397615 0.5714203 1"),
        ],
    );
    link.extend(edges(
        RANGE_12,
        &[
            (4, "0.06 0.0861301 1.027932 0.274489153039"),
            (5, "0.604377 0.7 1.12429 0.887155609529"),
            (6, "0.604377 0.7 1.12429 0.887155609529"),
        ],
    ));
    link.push(nth(RANGE_1, "cell ", 1, "cell 37/800 1 0"));
    add("(link)", link);
    // Version 2: there are others, or more than is shown.
    let others = |at: usize, line: &str| nth(RANGE_ALONE, "others", at, &format!("others {line}"));
    let first = ["1.4 2 1", "1.5 2 1", "9 2 1", "20 2 1", "60 1 1", "200 2 1"];
    let mut alone: Vec<String> = first.map(|line| others(0, line)).into();
    alone.extend(["1.3 2 1", "9 4 1", "22 2 1", "3 1 1"].map(|line| others(1, line)));
    let lines = [("longest", "longest 1"), ("rounds", "rounds 1"), ("rounds", "rounds 2")];
    alone.extend(lines.map(|(start, line)| with(RANGE_ALONE, start, line)));
    // Without one letter, or an edge, what it is part of is another motion.
    let second = |text: &str, strength: &str| {
        let start = "kind range\nstatement ".to_string() + STATEMENT;
        let text = text.replace(&start, &("kind range 2\nstatement ".to_string() + STATEMENT_2));
        let text = text.replace("\ncells", "\nlongest 4\nrounds 6\ncells");
        let lines = text.lines().map(|line| match line.starts_with("cell ") {
            true => format!("{line}\nothers {strength} 2 1\n"),
            false => format!("{line}\n"),
        });
        lines.collect::<String>()
    };
    alone.extend([
        second(RANGE_12, "1"),
        second(RANGE_12, "0.87"),
        second(RANGE_1, "6"),
        second(RANGE_13, "9"),
    ]);
    // Before the touch: a strength above S, longer legs, more than is shown, no letter 2, no damping.
    let lines = [
        ("others", "others 5.8 2 2"),
        ("others", "others 60 2 2"),
        ("longest", "longest 9"),
        ("longest", "longest 1"),
        ("rounds", "rounds 1"),
    ];
    alone.extend(lines.map(|(start, line)| with(RANGE_BEFORE, start, line)));
    let undamped = one("-1", "1", "1/100", "0 3 1 1");
    let undamped = with(&undamped, "damping", "damping 0/1 0/1");
    alone.push(second(&undamped, "6"));
    add("(C)", alone);
    all
}

/// The same for what is seen without any condition: the form, and the graph.
fn malformed() -> Vec<(String, &'static str)> {
    let change = |(start, line, reason)| (with(RANGE_1, start, line), reason);
    let lines = [
        ("kind", "kind range 2", "word for word"),
        ("kind", "kind range 3", "word for word"),
        ("kind", "kind range 5", "expected a line"),
        ("statement", "statement This oscillator is chaotic.", "word for word"),
        ("damping", "damping 2/20 2/20", "lowest terms"),
        ("damping", "damping 1/10 1/20", "must not decrease"),
        ("restitution", "restitution 0/1 4/5", "positive"),
        ("restitution", "restitution -4/5 4/5", "positive"),
        ("side", "side 0", "1 or -1"),
        ("side", "side -1\nforce 0/1 0/1", "harmonics"),
        ("harmonic ", "harmonic 1 1/2 2/3 0/1 0/1", "sum to 1"),
        ("harmonic ", "harmonic 1 1/1 1/1 1/9 1/9", "sum to 1"),
        ("window", "window 0", "positive"),
        ("window", "window -1", "positive"),
        ("pieces", "pieces 0", "at least 1"),
        ("pieces", "pieces 1001", "1000"),
        ("letters", "letters 0", "at least 1 letter"),
        ("letter ", "letter 0 1", "at least 1"),
        ("letter ", "letter 1 0", "positive"),
        ("letter ", "letter 1 1 1", "unexpected"),
        ("next", "next", "expected"),
        ("next", "next 2", "from 0 to 1"),
        ("next", "next 1 1", "increase"),
        ("growth", "growth 0.5 3", "at least 1"),
        ("growth", "growth 2 1", "must increase"),
        ("contraction", "contraction 1", "below 1"),
        ("contraction", "contraction 0", "positive"),
        ("cells", "cells 0", "at least 1 cell"),
        ("cells", "cells 5", "goes on"),
        ("cells", "cells 7", "the file ends"),
        ("cell ", "cell 0/1 1 0", "increase, from 0"),
        ("cell ", "cell -1/40 1 0", "increase, from 0"),
        ("cell ", "cell 37/800 1 0", "increase, from 0"),
        ("cell ", "cell 1/40 0 0", "at least 1 part"),
        ("cell ", "cell 1/40 65 0", "from 0 to 64"),
        ("cell ", "cell 1/40 1 1", "no other before it"),
        ("cell ", "cell 1/40 1 1001", "from 0 to 1000"),
        ("edge", "edge 2.4 2.3 1 1", "increase"),
        ("edge", "edge 2.3 2.3 1 1", "increase"),
        ("edge", "edge 2.0 2.3 1 1", "decimal"),
        ("edge", "edge 2 32768 1 1", "decimal"),
        ("edge", "edge 2 2.3 1 0", "weight"),
        ("edge", "edge 2 2.3 1 -1", "weight"),
        ("edge", "edge 2 2.3 nan 1", "decimal"),
        ("edge", "edge 2 2.3 inf 1", "decimal"),
        ("edge", "edge 2 2.3 1e9 1", "decimal"),
        ("edge", "edge 2 2.3 1", "decimal"),
    ];
    let mut all: Vec<(String, &'static str)> = lines.into_iter().map(change).collect();
    let others = [
        ("kind", "kind range", "longer than"),
        ("longest", "longest 0", "at least 1"),
        ("longest", "longest 1001", "1000"),
        ("rounds", "rounds 0", "at least 1"),
        ("rounds", "rounds 101", "100"),
        ("others", "others 0 2 1", "positive"),
        ("others", "others -1 2 1", "positive"),
        ("others", "others 40 0 1", "at least 1"),
        ("others", "others 40 65 1", "64"),
        ("others", "others 40 2 0", "at least 1"),
        ("others", "others 40 2 1001", "1000"),
        ("others", "others 40 2", "expected"),
        ("others", "others no 2 1", "unexpected"),
        ("others", "others 3 8 16", "K² D is at most 1000"),
    ];
    all.extend(others.map(|(start, line, reason)| (with(RANGE_ALONE, start, line), reason)));
    // Nothing is checked of letters that nothing precedes or follows, or of a graph without a cycle: each
    // letter must have both, and so there is one.
    let both = |one: &str, other: &str| {
        let text = RANGE_12.replace("next 1 2\nnext 1 2\n", &format!("{one}\n{other}\n"));
        assert_ne!(text, RANGE_12);
        text
    };
    all.push((both("next 1", "next 1 2"), "expected a line"));
    all.push((both("next 1 2", "next"), "number of a letter"));
    all.push((both("next 2", "next 2"), "letter 1 follows no letter"));
    all.push((both("next 1", "next 1"), "letter 2 follows no letter"));
    all.push((RANGE_12.replace("letter 2 1\n", "letter 3 1\n"), "the growth vector"));
    all.push((RANGE_12.replace("letter 2 1\n", "letter 1 1\n"), "of the same period"));
    all.push((with(RANGE_12, "growth", "growth 1.61803398876 1.7"), "lower rate"));
    all.push((with(RANGE_12, "growth", "growth 1.6 1.61803398874"), "upper rate"));
    all.push((with(RANGE_1, "growth", "growth 1.00000000001 1.1"), "lower rate"));
    all.push((nth(RANGE_1, "cell ", 3, "cell 37/800 1 10"), "increase, from 0"));
    all.push((nth(RANGE_1, "cell ", 3, "cell 1029/16000 1 10"), "increase, from 0"));
    all.push((nth(RANGE_1, "cell ", 3, "cell 1/100 1 10"), "increase, from 0"));
    all.push((
        nth(&nth(RANGE_12, "cell ", 0, "cell 999/2000 64 0"), "cell ", 1, "cell 999/1000 1 1000"),
        "exponentials",
    ));
    all.push((with(CHAOS_12, "kind", "kind range"), "word for word"));
    all
}

#[test]
fn forgeries_are_refused() {
    are_refused(&forgeries(), &malformed());
}

/// The reader in Python, written from the form and the theorem alone, gives the same verdicts.
#[test]
fn two_readers_agree() {
    let right = [RANGE_1, RANGE_12, RANGE_13].map(String::from).into_iter().chain([
        one("-1", "1", "1/100", "2 2.5 1 1"),
        one("-1", "3", "1/100", "1.9 2.2 1 1"),
        nth(RANGE_1, "cell ", 1, "cell 37/800 2 10"),
        RANGE_ALONE.to_string(),
        with(RANGE_ALONE, "others", "others no"),
        nth(RANGE_ALONE, "others", 0, "others 2.9 2 2"),
        RANGE_BEFORE.to_string(),
    ]);
    let wrong = forgeries().into_iter().chain(malformed()).map(|(text, _)| text).step_by(one_in(20));
    let all: Vec<(String, bool)> =
        right.map(|text| (text, true)).chain(wrong.map(|text| (text, false))).collect();
    let Some(verdicts) = second_reader("range.py", all.iter().map(|(text, _)| text)) else { return };
    for ((text, right), line) in all.iter().zip(&verdicts) {
        let ours = answer(text);
        assert_eq!((ours.is_ok(), line.contains(": proved, ")), (*right, *right), "{ours:?}, {line}\n{text}");
        if let Ok(checked) = ours {
            assert!(line.ends_with(&format!(": proved, {}", checked.title)), "{line}");
        }
    }
}
