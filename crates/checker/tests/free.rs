//! Certificates of motions without impacts, kinds orbit 3 and machine-orbit 2: forgeries by hand, and
//! `reference/free.py`, which was written from the form alone, gives the same verdict on damaged files.

use grazing_check::Rejection;

use crate::common::{FREE, FREE_MACHINE, ORBIT_4, answer, rejected, resealed, second_reader, with};
use crate::samples::one_in;

#[test]
fn what_is_written_passes_and_is_named() {
    let checked = answer(FREE).unwrap();
    assert_eq!((checked.kind, checked.range.clone()), ("orbit", Some(1..=1)));
    let expected = "\
proved, orbit of 1 period
  stability: stable
  pattern: no impact, period 1
  motion: q'' = -0.2 q' - 2 q + cos t
  lower wall: -1, restitution 0.8
  upper wall: none
  digest: 95ee966fd51c554e2655b1c5c6d317ab449474a966988c88a8c4ee85ef94d901";
    assert_eq!(checked.to_string(), expected);
    let checked = answer(FREE_MACHINE).unwrap();
    assert_eq!((checked.kind, checked.range.clone()), ("machine-orbit", Some(1..=1)));
}

/// q″ = −c q′ − k q + cos t has the amplitude 1/√((k − 1)² + c²): with c = 0.2, k = 2 it is 0.98058…
#[test]
fn a_wall_that_is_met_is_found() {
    let lower = |place: &str| resealed(&with(FREE, "lower", &format!("lower {place}..{place} 0.8..0.8 0")));
    let upper = |place: &str| resealed(&with(FREE, "upper", &format!("upper {place}..{place} 0.8..0.8 0")));
    assert!(answer(&lower("-0.99")).is_ok() && answer(&upper("1.2")).is_ok());
    for place in ["-0.98", "-0.5", "0", "0.98", "2"] {
        assert!(rejected(&lower(place)).contains("false: the gap to the lower wall on piece"), "{place}");
    }
    for place in ["0.98", "0", "-2"] {
        assert!(rejected(&upper(place)).contains("false: the gap to the upper wall on piece"), "{place}");
    }
    // A wall that comes to meet it, for one choice of an amplitude in its interval; a constant force.
    let moving =
        |wave: &str| resealed(&with(FREE, "lower", &format!("lower -1..-1 0..0 1\nharmonic 1 {wave}")));
    assert!(answer(&moving("0..0.01 0..0")).is_ok());
    assert!(rejected(&moving("-0.1..0.01 0..0")).contains("the gap to the lower wall"));
    let force = |x: &str| resealed(&with(FREE, "force", &format!("force {x}..{x}")));
    assert!(answer(&force("0.04")).is_ok() && answer(&force("-0.02")).is_ok());
    assert!(rejected(&force("-0.04")).contains("the gap to the lower wall"));
    // Q₁ < q < Q₂ is no matter of the walls' order: each gap is asked for.
    let machine = |stop: &str| resealed(&with(FREE_MACHINE, "stop -", &format!("stop {stop} 0.8..0.8 0")));
    assert!(answer(&machine("-0.03..-0.03")).is_ok());
    assert!(rejected(&machine("-0.01..-0.01")).contains("false: the gap to stop 1 on piece"));
    assert!(rejected(&machine("-0.02..-0.01")).contains("false: the gap to stop 1 on piece"));
}

/// A response that meets the wall late in the period, and pieces that end before; pieces that say too much.
#[test]
fn the_whole_period_is_followed() {
    let short = |text: &str, count: &str, last: &str| with(&with(text, "flight", count), last, "");
    let why = rejected(&short(FREE, "flight 19", "until 6.3"));
    assert!(why.contains("false: the pieces of flight 1 stop before its end"), "{why}");
    let why = rejected(&with(FREE, "until 6.3", "until 6.28"));
    assert!(why.contains("false: the pieces of flight 1 stop before its end"), "{why}");
    let why = rejected(&with(FREE, "until 1.5", "until 0.5"));
    assert!(why.contains("false: the pieces of flight 1 do not follow one another"), "{why}");
    let one = FREE.lines().filter(|line| !line.starts_with("until") || *line == "until 6.3");
    let one = with(&one.collect::<Vec<_>>().join("\n"), "flight", "flight 1");
    assert!(rejected(&one).contains("false: the gap to the lower wall on piece 1"));
    // No wall, and nothing to show: one piece does.
    let none = resealed(&with(&one, "lower", "lower none"));
    assert!(answer(&none).is_ok(), "{}", rejected(&none));
}

/// Each claim, and what is true: the roots of λ² + cλ + k, or of the machine's.
#[test]
fn no_motion_is_said_to_be_more_stable_than_it_is() {
    let clear = |text: &str| {
        let text = with(&with(text, "lower", "lower -9..-9 0.8..0.8 0"), "upper", "upper 9..9 0.8..0.8 0");
        resealed(&text)
    };
    let cases = [
        ("0.2..0.2", "2..2", "stable"),
        ("0.2..0.2", "0.01..0.01", "stable"),
        ("7..7", "2..2", "stable"),
        ("-0.2..-0.2", "2..2", "unstable"),
        ("0.2..0.2", "-2..-2", "unstable"),
        ("-0.2..-0.2", "-2..-2", "unstable"),
        ("-0.001..0.001", "2..2", "open"),
        ("0..0", "2..2", "open"),
        ("0..0", "0.25..0.25", "open"),
    ];
    for (damping, stiffness, truth) in cases {
        let text = with(FREE, "damping", &format!("damping {damping}"));
        let text = clear(&with(&text, "stiffness", &format!("stiffness {stiffness}")));
        for claim in ["stable", "unstable", "open"] {
            let text = with(&text, "orbit", &format!("orbit 0 {claim}"));
            let holds = claim == truth || claim == "open";
            assert_eq!(answer(&text).is_ok(), holds, "{damping} {stiffness} {claim}: {:?}", answer(&text));
        }
    }
    // The second mass driven by its damper.
    let clear = with(FREE_MACHINE, "stop -", "stop -9..-9 0.8..0.8 0");
    let driven = with(&clear, "damping -2..-2 2..2", "damping -2..-2 -20..-20");
    for (text, truth) in [(clear, "stable"), (driven, "unstable")] {
        for claim in ["stable", "unstable", "open"] {
            let text = resealed(&with(&text, "orbit", &format!("orbit 0 {claim}")));
            assert_eq!(answer(&text).is_ok(), claim == truth || claim == "open", "{claim}");
        }
    }
}

/// Where the forcing's period is one of the free vibration, there are others, or none.
#[test]
fn a_motion_that_is_not_alone_is_refused() {
    let sealed = |damping: &str, stiffness: &str| {
        let text = with(FREE, "damping", &format!("damping {damping}"));
        let text = with(&text, "stiffness", &format!("stiffness {stiffness}"));
        let text = with(&with(&text, "lower", "lower -9..-9 1..1 0"), "orbit", "orbit 0 open");
        resealed(&text)
    };
    let alone = format!("false: {MAY}");
    for stiffness in ["4..4", "9..9", "3.9..4.1", "0..0", "-0.1..0.1"] {
        let why = rejected(&sealed("0..0", stiffness));
        assert!(why.contains(&alone), "{stiffness}: {why}");
    }
    assert!(rejected(&sealed("0..0", "1..1")).contains("false: harmonic 1 of the forcing is in undamped"));
    assert!(rejected(&sealed("0.1..0.1", "0..0")).contains(&alone));
    assert!(answer(&sealed("0..0", "4.1..4.1")).is_ok());
    let open = with(FREE_MACHINE, "orbit", "orbit 0 open");
    let still = with(&with(&open, "damping 12", "damping 0..0 0..0"), "damping -2", "damping 0..0 0..0");
    let loose = |first: &str, second: &str| {
        let text = with(&still, "stiffness 3200", &format!("stiffness {first} 0..0"));
        resealed(&with(&text, "stiffness -200", &format!("stiffness 0..0 {second}")))
    };
    // The second mass by itself: its frequency is twice the forcing's where k₂ = m₂ (4π/T)² = 0.5 (32π)².
    let why = rejected(&loose("3200..3200", "5053..5054"));
    assert!(why.contains("false: 1 may be a multiplier"), "{why}");
    let why = rejected(&loose("3200..3200", "0..0"));
    assert!(why.contains("false: 1 may be a multiplier"), "{why}");
}

/// What the form does not have, and what belongs to other versions.
#[test]
fn versions_do_not_mix() {
    for (text, what) in [(FREE, "orbit"), (FREE_MACHINE, "machine-orbit")] {
        assert!(rejected(&with(text, "orbit", "orbit 1 stable")).contains("malformed: expected the number"));
        assert!(rejected(&with(text, "orbit", "orbit stable")).contains("malformed"));
        assert!(
            rejected(&with(text, "flight", "radius 1 1\nflight 13")).contains("malformed: expected a line")
        );
        assert!(rejected(&(text.to_string() + "until 7\n")).contains("the file goes on after the last"));
        // As an older kind, and as one still to come.
        assert!(rejected(&with(text, "kind", "kind event")).contains("malformed"));
        let why = rejected(&with(text, "kind", &format!("kind {what} 9")));
        assert!(why.contains("line 2: malformed: expected a line \"kind theorem2\""), "{why}");
    }
    assert!(rejected(&with(FREE, "kind", "kind orbit 2")).contains("malformed"));
    assert!(rejected(&with(FREE_MACHINE, "kind", "kind machine-orbit")).contains("malformed"));
    // No orbit without impacts in the older versions: the statement of version 3 is none of theirs.
    let why = rejected(&with(&with(ORBIT_4, "orbit", "orbit 0 stable"), "impact", ""));
    assert!(why.contains("malformed: the periods of an orbit must not sum to 0"), "{why}");
    assert!(rejected(&with(FREE_MACHINE, "scales", "scales 1 1 1 0")).contains("scales are above 0"));
    let many = format!("flight 90000\n{}", "until 1\n".repeat(90_000));
    let why = rejected(&with(FREE, "flight", many.trim_end()));
    assert!(why.contains("malformed: the check would take up to"), "{why}");
}

const MAY: &str = "1 may be a multiplier of the motion without impacts";

/// One word of one line changed, a line less, or a line twice.
fn damaged(text: &str) -> Vec<String> {
    let lines: Vec<&str> = text.lines().collect();
    let joined = |lines: &[&str]| lines.join("\n") + "\n";
    let mut all =
        vec![text.to_string(), text.replace('\n', "\r\n"), text.trim_end().into(), text.to_string() + "\n"];
    for (i, line) in lines.iter().enumerate() {
        let (mut less, mut twice) = (lines.clone(), lines.clone());
        less.remove(i);
        twice.insert(i, line);
        all.extend([joined(&less), joined(&twice)]);
        if line.starts_with("statement") {
            all.push(text.replacen("exactly one", "one", 1));
            continue;
        }
        if line.starts_with("until") && i % 5 > 0 {
            continue;
        }
        let words: Vec<&str> = line.split(' ').collect();
        for (j, word) in words.iter().enumerate() {
            let (low, high) = word.split_once("..").unwrap_or((word, word));
            let mut others =
                vec![format!("{word}0"), format!("-{word}"), format!("{word} "), format!("{word}x")];
            let fixed = [
                "0", "1", "2", "-1", "0.5", "0..0", "-3..-3", "0.1..0.3", "stable", "unstable", "open",
                "none",
            ];
            others.extend(fixed.map(String::from));
            others.extend([format!("{low}..{high}1"), format!("{low}..9{high}"), format!("9{low}..{high}")]);
            if let Ok(x) = low.parse::<f64>() {
                others.extend([0.9, 1.01].map(|part| format!("{}", x * part)));
                others.extend([0.9, 0.99, 1.01, 1.1].map(|part| format!("{0}..{0}", x * part)));
            }
            for other in others {
                let mut words = words.clone();
                words[j] = &other;
                let (mut lines, line) = (lines.clone(), words.join(" "));
                lines[i] = &line;
                let forged = joined(&lines);
                all.extend([resealed(&forged), forged]);
            }
        }
    }
    all
}

/// Whether a coefficient is known to no better than a tenth.
fn is_wide(text: &str) -> bool {
    let ends = |word: &str| -> Option<(f64, f64)> {
        let (low, high) = word.split_once("..")?;
        Some((low.parse().ok()?, high.parse().ok()?))
    };
    text.split([' ', '\n']).filter_map(ends).any(|(low, high)| high - low > 0.1 * high.abs().max(low.abs()))
}

#[test]
fn a_second_reader_agrees() {
    let unstable = resealed(&with(&with(FREE, "damping", "damping -0.2..-0.2"), "orbit", "orbit 0 unstable"));
    let open = with(FREE_MACHINE, "orbit", "orbit 0 open");
    let mut texts: Vec<String> = [FREE, FREE_MACHINE, &unstable, &open].map(damaged).concat();
    texts.sort();
    texts.dedup();
    let texts: Vec<String> = texts.into_iter().step_by(one_in(10)).collect();
    let Some(verdicts) = second_reader("free.py", &texts) else { return };
    let (mut accepted, mut rejected, mut narrower) = (0, 0, 0);
    for (text, line) in texts.iter().zip(&verdicts) {
        let (ours, theirs) = (answer(text), line.ends_with(": proved"));
        match &ours {
            // Over wide intervals the flow says less than Routh's array does.
            Err(Rejection::False { .. }) if theirs && is_wide(text) => narrower += 1,
            _ => assert_eq!(ours.is_ok(), theirs, "{ours:?}, but {line} of\n{text}"),
        }
        *(if ours.is_ok() { &mut accepted } else { &mut rejected }) += 1;
    }
    println!("{accepted} accepted, {rejected} rejected, {narrower} of them by the checker alone");
    let all = texts.len();
    assert!(accepted > all / 20 && rejected > all / 2, "{accepted} {rejected}");
    assert!(narrower < all / 120, "{narrower} of {all}");
}
