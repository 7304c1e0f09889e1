//! Certificates of kind chaos: the paper's oscillator, and what must be refused.

mod common;

use common::{CHAOS_12, CHAOS_123, answer, rejected, with};

#[test]
fn what_is_written_passes_and_is_named() {
    let checked = answer(CHAOS_12).unwrap();
    assert_eq!((checked.kind, checked.range.clone()), ("chaos", 1..=2));
    let text = checked.to_string();
    assert!(text.contains("depth: every nu with 0 < nu <= 1\n"), "{text}");
    assert!(text.contains("letters: 1, 2; each may follow each"), "{text}");
    assert_eq!(answer(CHAOS_123).unwrap().range, 1..=3);
}

/// What is known not to hold is refused for the reason why it does not.
#[test]
fn negative_controls_are_refused() {
    for (start, line, reason) in [
        // µ = 0.0035: the boxes of 0.003 are left.
        ("depth", "depth 7/2007 7/2007", "(H1)"),
        ("letter 3", "letter 3 19 32.4 -3.36 -1.66 1 0.105 1 4", "(H1)"),
        // w = 4.7.
        ("stiffness", "stiffness 100/2209 100/2209", "(H1)"),
        // The place of rest before the wall, µ < 0.
        ("side", "side -1", "(H1)"),
        // Equal weights.
        ("letter 1", "letter 1 0.02 0.22 -0.115 -0.1 1 1 1 1", "(H2)"),
        ("contraction", "contraction 0.82", "(H2)"),
        ("window", "window 1.6", "below pi/2"),
        ("window", "window 1.57", "convex"),
        ("window", "window 0.001", "outside the window"),
        ("window", "window 0.04", "may not be positive after window 0"),
        ("reach", "reach 80", "reach"),
        ("growth", "growth 1.8393 1.84", "lower rate"),
        ("growth", "growth 1.839 1.8392", "upper rate"),
    ] {
        let why = rejected(&with(CHAOS_123, start, line));
        assert!(why.contains("false") && why.contains(reason), "{start}: {why}");
    }
    // w = 8 has no letter of 4 periods near: u_4 is nearly 0.
    let why = rejected(&with(
        &with(CHAOS_12, "letter 2", "letter 4 0.69 0.962 -0.282 -0.197 1 0.25 1 1"),
        "stiffness",
        "stiffness 1/64 1/64",
    ));
    assert!(why.contains("false"), "{why}");
}

/// Two letters of the same period that may be exchanged would count orbits twice.
#[test]
fn paths_that_their_periods_do_not_tell_are_refused() {
    let twice = with(CHAOS_12, "letters", "letters 3");
    let letter = CHAOS_12.lines().find(|line| line.starts_with("letter 2")).unwrap();
    let twice = with(&twice, "letter 2", &format!("{letter}\n{letter}"));
    let twice = with(&twice, "next 1 2", "next 1 2 3\nnext 1 2 3");
    let twice = with(&twice, "next 1 2\n".trim(), "next 1 2 3");
    let why = rejected(&twice.replace("next 1 2\n", "next 1 2 3\n"));
    assert!(why.contains("two successors of the same period"), "{why}");
}

#[test]
fn numbers_have_one_form_and_limits() {
    for (start, line, reason) in [
        ("damping", "damping 24/98 24/98", "lowest terms"),
        ("damping", "damping 13/49 12/49", "must not decrease"),
        ("force", "force 1/1 1/1", "move the origin"),
        ("restitution", "restitution 0/1 1/1", "positive"),
        ("depth", "depth 0/1 0/1", "somewhere positive"),
        ("depth", "depth -1/2 1/1", "at least 0"),
        ("side", "side 0", "1 or -1"),
        ("cells", "cells 1 1 1 1 0", "1 to 10000"),
        ("cells", "cells 200 1 1 1 200", "1 to 10000"),
        ("pieces", "pieces 0", "at least 1"),
        ("pieces", "pieces 1001", "1000"),
        ("letters", "letters 0", "at least 1 letter"),
        ("letter 1", "letter 0 0.115 0.2 -0.121 -0.092 0.3 0.06666 1 1", "at least 1"),
        ("letter 1", "letter 1 0.2 0.115 -0.121 -0.092 0.3 0.06666 1 1", "increase"),
        ("letter 1", "letter 1 0.115 0.2 -0.121 -0.092 -0.3 0.06666 1 1", "positive"),
        ("letter 1", "letter 1 0.1150 0.2 -0.121 -0.092 0.3 0.06666 1 1", "decimal"),
        ("next", "next 2 1", "increase"),
        ("next", "next", "expected"),
        ("next", "next 1 3", "from 0 to 2"),
        ("contraction", "contraction 1", "below 1"),
        ("complete", "complete no", "decimal"),
        ("complete", "complete none\ncomplete none", "goes on"),
        ("cells", "cells 1 1 1 1 10000", "evaluations"),
    ] {
        let why = rejected(&with(CHAOS_12, start, line));
        assert!(why.contains("malformed") && why.contains(reason), "{line}: {why}");
    }
}
