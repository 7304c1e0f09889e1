//! Certificates of kind chaos: the paper's oscillator, and what must be refused.

use crate::common::{
    CHAOS_12, CHAOS_123, CHAOS_MIRRORED, CHAOS_MIRRORED_BEFORE, answer, rejected, second_reader, with,
};
use crate::samples::one_in;
use grazing_check::chaos::{STATEMENT_3, STATEMENT_4};

#[test]
fn what_is_written_passes_and_is_named() {
    let checked = answer(CHAOS_12).unwrap();
    assert_eq!((checked.kind, checked.range.clone()), ("chaos", None));
    assert_eq!(
        checked.to_string(),
        "proved, chaos
  claim: chaos: paths branch, and the entropy is positive
  motion: q'' = -c q' - k q + f above the wall nu - 1 + cos t, restitution tau
  damping: 12/49
  stiffness: 100/2401
  force: 0
  restitution: 1
  depth: every nu with 0 < nu <= 1
  letters: 1: 1 period, velocity/nu 0.089 to 0.244 first, -0.1582 to -0.0612 last, then 1 or 2; \
2: 2 periods, velocity/nu 0.615 to 1.036 first, -0.367 to -0.14 last, then 1 or 2
  window: impacts within 1.2 of multiples of 2 pi
  contraction: at most 0.875
  reach: q < 4.3 nu
  entropy: per period between log 1.61803398874 and log 1.61803398876
  others: not excluded: there may be other orbits near"
    );
    let checked = answer(CHAOS_123).unwrap();
    assert!(checked.to_string().contains("others: none near"), "{checked}");
}

/// What is known not to hold is refused for the reason why it does not.
#[test]
fn negative_controls_are_refused() {
    for (start, line, reason) in [
        // µ = 0.0035: the boxes of 0.003 are left.
        ("depth", "depth 7/2007 7/2007", "(H1)"),
        ("letter 3", "letter 3 19 32.3 -3.34 -1.75 1 0.102973657 1 4", "(H1)"),
        // w = 4.7.
        ("stiffness", "stiffness 100/2209 100/2209", "(H1)"),
        // Equal weights.
        ("letter 1", "letter 1 0.028 0.196 -0.1137 -0.101 1 1 1 1", "(H2)"),
        ("contraction", "contraction 0.92", "(H2)"),
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
    // The place of rest before the wall, µ < 0.
    let before = with(&with(CHAOS_123, "side", "side -1"), "complete", "complete no");
    assert!(rejected(&before).contains("(H1)"));
    // w = 8 has no letter of 4 periods near: u_4 is nearly 0.
    let why = rejected(&with(
        &with(CHAOS_12, "letter 2", "letter 4 0.69 0.962 -0.282 -0.197 1 0.25 1 1"),
        "stiffness",
        "stiffness 1/64 1/64",
    ));
    assert!(why.contains("false"), "{why}");
}

/// That there are no other orbits is refused where there are, or where the claim's numbers do not show it.
#[test]
fn what_is_not_complete_is_refused() {
    for (line, reason) in [
        // The orbits of letter 3 have |s| up to 32.2; from 30 on there are none to be missed.
        ("complete 48.3 3 2 7", "longer than 3 periods"),
        ("complete 48.3 4 2 1", "(C)"),
        ("complete 60 4 2 7", "longer than 4 periods"),
        ("complete 400 4 2 7", "two contacts"),
        ("complete 2000 4 2 7", "outside the window"),
    ] {
        let why = rejected(&with(CHAOS_123, "complete", line));
        assert!(why.contains("false") && why.contains(reason), "{line}: {why}");
    }
    assert!(answer(&with(CHAOS_123, "complete", "complete 36 4 2 7")).is_ok());
    // At µ = 0.003 letter 3 exists, with |s| from 13 on: {1, 2} is complete without it, not with it.
    let few = with(CHAOS_12, "depth", "depth 0/1 3/1003");
    assert!(answer(&with(&few, "complete", "complete 2 4 2 7")).is_ok());
    let why = rejected(&with(&few, "complete", "complete 36 4 2 7"));
    assert!(why.contains("there may be a leg of 3 periods (C)"), "{why}");
    // Without the edge from 2 to 2 the orbits ... 2 2 ... are others. Growth: z + z³ = 1, and 2 has z times
    // the entry of 1.
    let graph = few.replace("next 1 2\nnext 1 2\n", "next 1 2\nnext 1\n");
    let graph = graph.replace("0.310435706 1 1", "0.310435706 0.6823278038 1");
    let graph = with(&graph, "growth", "growth 1.465571 1.465572");
    assert!(answer(&graph).is_ok(), "{:?}", answer(&graph));
    let why = rejected(&with(&graph, "complete", "complete 2 4 2 7"));
    assert!(why.contains("letter 2 may follow letter 2 (C)"), "{why}");
    // Undamped and for ever: not for the place of rest before the wall.
    let before = with(&with(CHAOS_12, "side", "side -1"), "complete", "complete 2 4 2 7");
    assert!(rejected(&before).contains("side 1"));
}

/// The same lines as of the other version.
fn version(text: &str, mirrored: bool) -> String {
    let (kind, statement) =
        if mirrored { ("kind chaos 4", STATEMENT_4) } else { ("kind chaos 3", STATEMENT_3) };
    with(&with(text, "kind", kind), "statement", &format!("statement {statement}"))
}

/// For µ → 0, in a time that is so many times faster: the boxes with it.
fn hurried(text: &str, [damping, stiffness]: [&str; 2], boxes: [&str; 2]) -> String {
    let text = with(&with(text, "complete", "complete no"), "depth", "depth 0/1 1/1000000");
    let text = with(&with(&text, "damping", damping), "stiffness", stiffness);
    with(&with(&text, "letter 1", boxes[0]), "letter 2", boxes[1])
}

/// The paper's letters 1 and 2 for small µ, as 2 and 4 half periods between mirrored walls.
fn small_twice() -> String {
    let small = with(CHAOS_12, "depth", "depth 0/1 1/100");
    let twice = small.replace("letter 2 ", "letter 4 ").replace("letter 1 ", "letter 2 ");
    version(&with(&twice, "growth", "growth 1.2720196495 1.2720196496"), true)
}

#[test]
fn orbits_between_mirrored_walls_pass_and_are_named() {
    let checked = answer(CHAOS_MIRRORED).unwrap();
    assert_eq!((checked.kind, checked.statement, checked.range.clone()), ("chaos", STATEMENT_4, None));
    let text = checked.to_string();
    assert!(text.contains("between the wall w(t) = nu - 1 + cos t and the wall -w(t - pi)"), "{text}");
    for letter in ["1: 1/2 periods, vel", "2: 1 period, vel", "3: 3/2 periods, vel", ", then 1 or 2 or 3"] {
        assert!(text.contains(letter), "{text}");
    }
    assert!(text.contains("per half period between log 1.839286755204") && !text.contains("force"), "{text}");
    // A wall is met near its own top alone: at multiples of its own.
    let alone = "every bounded motion that meets a wall, the lower one only within 1.2 of even and the upper one of odd \
                 multiples of pi, where |w'|, at the upper wall half a period before, <= nu S/2, S = 4.73,";
    assert!(text.contains("|q| < 4.1 nu") && text.contains(alone), "{text}");
    let window = "within 1.2 of multiples of pi, at the lower wall of even and at the upper wall of odd ones";
    assert!(text.contains(window), "{text}");
    let text = answer(CHAOS_MIRRORED_BEFORE).unwrap().to_string();
    assert!(text.contains("others: not excluded") && text.contains("-nu - 1 + cos t"), "{text}");
}

/// What would hold if a leg between walls had the wrong sign, or without the other wall, is refused.
#[test]
fn signs_and_gaps_of_mirrored_walls_count() {
    // Whole periods in place of halves.
    assert!(rejected(&version(CHAOS_MIRRORED, false)).contains("(H1)"));
    // In half the time, with half of c and a quarter of k, E over a period is E over half a period, but for
    // the sign.
    let letters = [
        "letter 1 0.4073 0.4217 -0.13635 -0.12295 0.270998201 0.131271856 1 1",
        "letter 2 0.87945 0.8892 -0.44845 -0.44275 0.290520967 0.116457833 1 1",
    ];
    let unsigned = hurried(CHAOS_MIRRORED, ["damping 1/16 1/16", "stiffness 25/64 25/64"], letters);
    assert!(rejected(&version(&unsigned, false)).contains("letters 1, 1, 1: the first velocity"));
    // And the other way round: here one wall is right.
    let letters = [
        "letter 1 0.178 0.488 -0.3164 -0.1224 0.264121084 0.082075454 1 1",
        "letter 2 1.23 2.072 -0.734 -0.28 1 0.310435706 1 1",
    ];
    let signed = hurried(CHAOS_12, ["damping 24/49 24/49", "stiffness 400/2401 400/2401"], letters);
    assert!(rejected(&version(&signed, true)).contains("letters 1, 1, 1: the first velocity"));
    // Legs of whole periods between the walls have the boxes of one wall; only the gap to the other fails.
    assert!(answer(&with(CHAOS_12, "depth", "depth 0/1 1/100")).is_ok());
    let why = rejected(&small_twice());
    assert!(why.contains("letter 1: the wall may be met in window 1 (H4)"), "{why}");
}

#[test]
fn negative_controls_between_mirrored_walls_are_refused() {
    for (text, start, line, reason) in [
        // Walls closer to each other.
        (CHAOS_MIRRORED, "depth", "depth 1/100 1/100", "(H1)"),
        (CHAOS_MIRRORED_BEFORE, "depth", "depth 0/1 1/2", "(H1)"),
        (CHAOS_MIRRORED_BEFORE, "side", "side 1", "(H1)"),
        (CHAOS_MIRRORED, "stiffness", "stiffness 1/2 1/2", "(H1)"),
        (CHAOS_MIRRORED, "reach", "reach 3", "reach in window 0"),
        // Beyond the wall below the motion is as far as beyond the one above.
        (CHAOS_MIRRORED_BEFORE, "reach", "reach 1.2", "reach in window 1"),
        (CHAOS_MIRRORED, "window", "window 0.001", "outside the window"),
        (CHAOS_MIRRORED, "window", "window 1.57", "convex in window 0"),
        (CHAOS_MIRRORED, "window", "window 0.03", "may not be positive after window 0"),
        (CHAOS_MIRRORED_BEFORE, "window", "window 0.3", "may not be positive before window 1"),
        (CHAOS_MIRRORED_BEFORE, "window", "window 0.4", "may not be positive after window 1"),
        // Rates count half periods.
        (CHAOS_MIRRORED, "growth", "growth 3.382975 3.382976", "lower rate"),
        (CHAOS_MIRRORED, "complete", "complete 60 5 2 4", "a leg of 4 periods (C)"),
        (CHAOS_MIRRORED, "complete", "complete 4.73 3 2 4", "longer than 3 periods"),
    ] {
        let why = rejected(&with(text, start, line));
        assert!(why.contains("false") && why.contains(reason), "{line}: {why}");
    }
    for (text, start, line, reason) in [
        (CHAOS_MIRRORED, "force", "force 1/10 1/10", "force is 0/1"),
        (CHAOS_MIRRORED_BEFORE, "complete", "complete 2 5 2 4", "side 1"),
        (CHAOS_MIRRORED, "kind", "kind chaos 3", "line 3"),
        (CHAOS_MIRRORED, "kind", "kind chaos 5", "expected a line"),
        (CHAOS_12, "kind", "kind chaos 4", "line 3"),
        (
            CHAOS_MIRRORED,
            "pieces",
            "pieces 1000
pieces 1000",
            "letters",
        ),
    ] {
        let why = rejected(&with(text, start, line));
        assert!(why.contains("malformed") && why.contains(reason), "{line}: {why}");
    }
}

/// The growth vector proves its rates along the edges or along the edges reversed, not some of each.
#[test]
fn rates_are_proved_along_edges_or_against_them() {
    // From 1 to 1 and 2, from 2 to 3, from 3 to 1: z + z⁶ = 1. Fewer edges leave fewer conditions.
    let graph = with(CHAOS_123, "complete", "complete no");
    let graph = graph.replace("next 1 2 3\nnext 1 2 3\nnext 1 2 3\n", "next 1 2\nnext 3\nnext 1\n");
    let graph = with(&graph, "growth", "growth 1.285198 1.2852");
    let (z, cube, fourth) = ("0.7780895987", "0.4710736687", "0.3665375218");
    for (second, third, proved) in [(fourth, z, true), (z, cube, true), (fourth, cube, false), (z, z, false)]
    {
        let entry = |start: &str, entry: &str| {
            let line = CHAOS_123.lines().find(|line| line.starts_with(start)).unwrap();
            let mut words: Vec<&str> = line.split(' ').collect();
            words[8] = entry;
            words.join(" ")
        };
        let text = with(&graph, "letter 2", &entry("letter 2", second));
        let text = with(&text, "letter 3", &entry("letter 3", third));
        assert_eq!(answer(&text).is_ok(), proved, "{second} {third}: {:?}", answer(&text));
    }
}

/// A wall of two harmonics that is not convex on the window, and one that is lower than its other top.
#[test]
fn walls_without_one_top_are_refused() {
    let two = |terms: &str| with(&with(CHAOS_12, "harmonics", "harmonics 2"), "harmonic ", terms);
    // cos t and a tenth of cos 2t more: less than a tenth changes little.
    let small = two("harmonic 1 9999/10000 9999/10000 0/1 0/1\nharmonic 2 1/10000 1/10000 0/1 0/1");
    assert!(answer(&with(&small, "depth", "depth 0/1 1/3")).is_ok(), "{:?}", answer(&small));
    let why = rejected(&two("harmonic 1 4/3 4/3 0/1 0/1\nharmonic 2 -1/3 -1/3 0/1 0/1"));
    assert!(why.contains("convex"), "{why}");
    // Tops at 0 and π, the latter the higher.
    let twin = two("harmonic 1 -1/10 -1/10 0/1 0/1\nharmonic 2 11/10 11/10 0/1 0/1");
    assert!(rejected(&with(&twin, "window", "window 0.6")).contains("false"));
    let twice = two("harmonic 2 1/1 1/1 0/1 0/1\nharmonic 1 0/1 0/1 0/1 0/1");
    assert!(rejected(&twice).contains("orders of harmonics increase"));
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
        ("complete", "complete no\ncontraction 0.5", "goes on"),
        ("complete", "complete", "decimal"),
        ("complete", "complete 2 4 2 0", "at least 1"),
        ("complete", "complete 2 4 2 101", "from 0 to 100"),
        ("complete", "complete 2 400 2 7", "exponentials"),
        ("side", "side -1\ncomplete 2 4 2 7", "harmonics"),
        ("harmonics", "harmonics 0", "sum to 1"),
        ("harmonic ", "harmonic 1 1/2 2/3 0/1 0/1", "sum to 1"),
        ("harmonic ", "harmonic 1 1/1 1/1 1/9 1/9", "sum to 1"),
        ("harmonic ", "harmonic 0 1/1 1/1 0/1 0/1", "at least 1"),
        ("harmonic ", "harmonic 1 1/1 1/1 0/1", "fraction"),
        ("cells", "cells 1 1 1 1 10000", "exponentials"),
    ] {
        let why = rejected(&with(CHAOS_12, start, line));
        assert!(why.contains("malformed") && why.contains(reason), "{line}: {why}");
    }
}

/// Lines of a certificate put in place of others: the first that begins so, or several.
fn forged(changes: &[(&str, &str)]) -> String {
    changes.iter().fold(CHAOS_12.to_string(), |text, (start, lines)| with(&text, start, lines))
}

/// The letters 1 and 2 at a depth where both close with room.
const SHALLOW: (&str, &str) = ("depth", "depth 0/1 1/100");

/// Certificates that put false words around true claims, or true words around nothing: what they say beyond
/// the form, and why they are refused. The letters' boxes are those of the paper's oscillator.
fn forgeries() -> Vec<(&'static str, String, &'static str)> {
    let (one, two) = (line("letter 1"), line("letter 2"));
    let unit = |letter: &str| {
        let mut words: Vec<&str> = letter.split(' ').collect();
        words[8] = "1";
        words.join(" ")
    };
    let all = |changes: &[(&str, &str)]| forged(&[&[SHALLOW], changes].concat());
    // What nothing precedes was not checked at all.
    let orphan = |letter: &str, next: &str| {
        let letters = format!("{two}\n{letter}");
        all(&[("letters", "letters 3"), ("letter 2", &letters), ("contraction", next)])
    };
    let (steady, high) = (unit(&one), "letter 777 1 2 -2 -1 1 1 1 1");
    let alone = |growth: &str| {
        let lines = [("letters", "letters 1"), ("letter 2", ""), ("letter 1", &steady)];
        let lines = [&lines[..], &[("next", ""), ("next", "next 1"), ("growth", growth)]].concat();
        all(&lines)
    };
    vec![
        ("a periodic orbit grows", alone("growth 1.00000000001 1.1"), "lower rate at letter 1"),
        ("a periodic orbit grows by half", alone("growth 1.5 1.6"), "lower rate"),
        ("a rate below 1", alone("growth 0.5 3"), "a growth rate is at least 1"),
        ("a rate of 0", alone("growth 0 3"), "a growth rate is at least 1"),
        ("a negative rate", alone("growth -1 3"), "a growth rate is at least 1"),
        ("rates the wrong way round", alone("growth 1.1 1"), "ends must increase"),
        (
            "a letter that nothing precedes",
            orphan(high, "next 1 2\ncontraction 0.875"),
            "letter 3 follows no letter",
        ),
        ("a letter that only itself precedes", orphan(high, "next 3\ncontraction 0.875"), "growth vector"),
        (
            "the same with a growth vector",
            orphan(high, "next 1 2 3\ncontraction 0.875").replace("growth 1.61803398874", "growth 1"),
            "(H",
        ),
        ("a letter that nothing follows", all(&[("next", "next")]), "number of a letter"),
        (
            "a letter left out by all others",
            all(&[("next", "next 1"), ("next 1 2", "next 1")]),
            "letter 2 follows no letter",
        ),
        ("a letter that follows a letter not there", all(&[("next", "next 1 3")]), "from 0 to 2"),
        ("a letter 0", all(&[("next", "next 0 1")]), "begin at 1"),
        ("a letter twice", all(&[("next", "next 1 1")]), "increase"),
        (
            "one letter under two numbers",
            orphan(&two, "next 1 2 3\ncontraction 0.875").replace("next 1 2\n", "next 1 2 3\n"),
            "two successors of the same period",
        ),
        (
            "a letter's periods",
            all(&[("letter 2", &two.replacen("letter 2", "letter 3", 1))]),
            "lower rate at letter 1",
        ),
        (
            "a number of two forms",
            all(&[("letter 2", &two.replace("0.310435706", "0.3104357060"))]),
            "expected a decimal",
        ),
        ("boxes that other orbits leave", all(&[("letter 2", &two.replace("0.615", "0.95"))]), "(H1)"),
        (
            "walls that there are not: the cosines sum to almost 1",
            all(&[
                (
                    "harmonic 1",
                    "harmonic 1 1/2 1/2 0/1 0/1\nharmonic 2 499999999999999/999999999999999 \
                 499999999999999/999999999999999 0/1 0/1",
                ),
                ("harmonics", "harmonics 2"),
            ]),
            "sum to 1",
        ),
        (
            "walls that there are not: a range just below 1",
            all(&[("harmonic 1", "harmonic 1 1/2 999999999999998/999999999999999 0/1 0/1")]),
            "sum to 1",
        ),
        (
            "a slope at the top",
            all(&[("harmonic 1", "harmonic 1 1/1 1/1 1/999999999999999 1/99")]),
            "sum to 1",
        ),
        (
            "sums that nobody can follow",
            all(&[
                ("harmonics", "harmonics 4"),
                (
                    "harmonic 1",
                    "harmonic 1 999999999999989/999999999999999 1/1 0/1 0/1\n\
                 harmonic 2 1/999999999999998 1/999999999999997 0/1 0/1\n\
                 harmonic 3 1/999999999999995 1/999999999999993 0/1 0/1\n\
                 harmonic 4 1/999999999999991 1/999999999999989 0/1 0/1",
                ),
            ]),
            "no common denominator",
        ),
        ("a smaller contraction", all(&[("contraction", "contraction 0.001")]), "(H2)"),
        ("a lower reach", all(&[("reach", "reach 1")]), "reach"),
        ("a narrower window", all(&[("window", "window 0.001")]), "outside the window"),
        ("no others, with legs of 3 periods", all(&[("complete", "complete 36 4 2 7")]), "(C)"),
        (
            "no others, of an oscillator that may stay free",
            all(&[("side", "side -1"), ("complete", "complete 2 4 2 7")]),
            "side 1",
        ),
        (
            "another statement",
            with(CHAOS_12, "statement", "statement This oscillator is chaotic."),
            "word for word",
        ),
        (
            "the statement between two walls",
            with(CHAOS_12, "statement", &format!("statement {STATEMENT_4}")),
            "line 3: malformed",
        ),
        ("two walls", version(CHAOS_12, true), "(H"),
        ("version 1", with(CHAOS_12, "kind", "kind chaos"), "leaves out which impact is the first"),
        ("version 2", with(CHAOS_MIRRORED, "kind", "kind chaos 2"), "writes it anew"),
    ]
}

fn line(start: &str) -> String {
    CHAOS_12.lines().find(|line| line.starts_with(start)).unwrap().to_string()
}

#[test]
fn forgeries_are_refused() {
    let all = forgeries();
    assert!(all.len() >= 30);
    for (what, text, reason) in all {
        let why = answer(&text).map_or_else(|why| why.to_string(), |checked| panic!("{what}: {checked}"));
        assert!(why.contains(reason), "{what}: {why}");
    }
}

/// One periodic orbit is proved as that; letters of 1 and 3 periods are not "n = 1..=3".
#[test]
fn what_is_proved_is_called_by_its_name() {
    let single = |text: &str| {
        let one = line("letter 1").replace("0.082075454", "1");
        let text = with(&with(&with(text, "letters", "letters 1"), "letter 2", ""), "letter 1", &one);
        with(&with(&text, "next", ""), "next", "next 1")
    };
    let checked = answer(&with(&single(CHAOS_12), "growth", "growth 1 1.00000000001")).unwrap();
    let text = checked.to_string();
    assert_eq!((checked.kind, checked.title, checked.range.clone()), ("chaos", "orbits", None));
    assert!(text.starts_with("proved, orbits\n  claim: orbits:") && !text.contains("chaos"), "{text}");
    // 1 and 3 of figure 10: z + z³ = 1.
    let letters: Vec<&str> = CHAOS_123.lines().filter(|line| line.starts_with("letter ")).collect();
    let with_growth = |letter: &str, entry: &str| {
        let mut words: Vec<&str> = letter.split(' ').collect();
        words[8] = entry;
        words.join(" ")
    };
    let text = with(&with(CHAOS_123, "letters", "letters 2"), letters[1], "");
    let text = with(&text, letters[2], &with_growth(letters[2], "1"));
    let text = with(&text, letters[0], &with_growth(letters[0], "1"));
    let text = text.replace("next 1 2 3\nnext 1 2 3\nnext 1 2 3\n", "next 1 2\nnext 1 2\n");
    let text = with(&with(&text, "growth", "growth 1.465571 1.465572"), "complete", "complete no");
    let said = answer(&text).unwrap().to_string();
    assert!(said.starts_with("proved, chaos\n") && !said.contains("2 periods"), "{said}");
    assert!(said.contains("1: 1 period, ") && said.contains("2: 3 periods, "), "{said}");
}

/// The reader in Python, written from the form and the theorem alone, gives the same verdicts.
#[test]
fn two_readers_agree() {
    let letter = CHAOS_12.lines().find(|line| line.starts_with("letter 1 ")).unwrap();
    let changes = [
        ("side", "side 1".to_string(), true),
        ("reach", "reach 100".to_string(), true),
        ("pieces", "pieces 12".to_string(), true),
        ("cells", "cells 1 1 1 1 2".to_string(), true),
        ("reach", "reach 1.5".to_string(), false),
        ("side", "side -1".to_string(), false),
        ("side", "side 2".to_string(), false),
        ("depth", "depth 0/1 2/1".to_string(), false),
        ("depth", "depth 0/1 2/2".to_string(), false),
        ("window", "window 0.3".to_string(), false),
        ("window", "window 1.6".to_string(), false),
        ("window", "window 01.2".to_string(), false),
        ("restitution", "restitution 0/1 1/1".to_string(), false),
        ("force", "force -1/10 0/1".to_string(), false),
        ("contraction", "contraction 0.8".to_string(), false),
        ("contraction", "contraction 1.1".to_string(), false),
        ("growth", "growth 1.6 1.61".to_string(), false),
        ("growth", "growth 1.62 1.7".to_string(), false),
        ("next", "next 2 1".to_string(), false),
        ("growth", "growth 1.618 1.6181\ngrowth 1.618 1.6181".to_string(), false),
        ("letter 1", letter.replacen("0.089", "0.0995", 1), false),
        ("letter 1", letter.replacen("0.089", "0.0890", 1), false),
        ("letter 1", letter.replacen("0.089", "0.086", 1), true),
    ];
    let few = with(CHAOS_12, "depth", "depth 0/1 3/1003");
    let changes = changes.into_iter().map(|change| (CHAOS_12, change)).chain([
        (&few[..], ("complete", "complete 2 4 2 3".to_string(), true)),
        (&few, ("complete", "complete 2 3 2 3".to_string(), false)),
        (&few, ("complete", "complete 36 4 2 2".to_string(), false)),
        (&few, ("complete", "complete 0 4 2 2".to_string(), false)),
        (&few, ("harmonic ", "harmonic 1 1/1 1/1 1/99 1/9".to_string(), false)),
        (&few, ("harmonic ", "harmonic 1 99999/100000 1/1 0/1 0/1".to_string(), true)),
    ]);
    let twice = small_twice();
    let unsigned = version(CHAOS_MIRRORED, false);
    let changes = changes.chain([
        (CHAOS_MIRRORED, ("pieces", "pieces 12".to_string(), true)),
        (CHAOS_MIRRORED, ("reach", "reach 3".to_string(), false)),
        (CHAOS_MIRRORED, ("force", "force 1/10 1/10".to_string(), false)),
        (CHAOS_MIRRORED, ("complete", "complete 4.73 3 2 4".to_string(), false)),
        (CHAOS_MIRRORED_BEFORE, ("side", "side -1".to_string(), true)),
        (CHAOS_MIRRORED_BEFORE, ("reach", "reach 1.2".to_string(), false)),
        (CHAOS_MIRRORED_BEFORE, ("window", "window 0.3".to_string(), false)),
        (CHAOS_MIRRORED_BEFORE, ("window", "window 0.4".to_string(), false)),
        (&unsigned, ("side", "side 1".to_string(), false)),
        (&twice, ("side", "side 1".to_string(), false)),
    ]);
    let changed = changes.map(|(text, (start, line, right))| (line.clone(), with(text, start, &line), right));
    let forged = forgeries().into_iter().map(|(what, text, _)| (what.to_string(), text, false));
    let all: Vec<_> = changed.step_by(one_in(3)).chain(forged.step_by(one_in(12))).collect();
    let Some(verdicts) = second_reader("chaos.py", all.iter().map(|(_, text, _)| text)) else { return };
    for ((what, text, right), line) in all.iter().zip(&verdicts) {
        let (ours, theirs) = (answer(text), line.contains(": proved, "));
        assert_eq!((ours.is_ok(), theirs), (*right, *right), "{what}: {ours:?}, {line}");
        if let Ok(checked) = ours {
            assert!(line.ends_with(&format!(": proved, {}", checked.title)), "{line}");
        }
    }
}
