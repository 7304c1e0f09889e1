//! Theorem 2's list, rational s on r = 1, and the words of boxes, against the proved functions.

use std::collections::BTreeSet;
use std::process::Command;

use super::{CASES, LONGEST, Rational, TURNS, WordsSeen, answers, numbers, oracle, points, sampled};

/// The last period that is compared on r = 1.
const LAST: usize = 200;

/// `grazing intervals` prints the intervals of `sidesZ`, in any order, and the first one of each period.
#[test]
fn grazing_lists_the_proved_intervals() {
    let Some(build) = oracle() else { return };
    let questions: Vec<_> = (3..=LAST).map(|n| format!("list {n}")).collect();
    let text = grazing(&["intervals", &format!("3..={LAST}"), "--format", "csv"]);
    let mut rows: Vec<BTreeSet<String>> = vec![BTreeSet::new(); LAST + 1];
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("n,m,sign_emu,sign_gamma,left,right,deciding"));
    let mut compared = 0;
    for line in lines {
        let [n, _, emu, gamma, left, right, deciding] = line.split(',').collect::<Vec<_>>()[..] else {
            panic!("{line}")
        };
        let number: usize = n.parse().unwrap();
        if emu == "-1" {
            assert_eq!((gamma, left, deciding), ("1", "0/1", ""), "{line}");
            assert_eq!(right, format!("1/{}", 2 * number), "{line}");
        } else {
            let sign = if gamma == "1" { '+' } else { '-' };
            assert!(rows[number].insert(format!("{deciding}{sign}{left},{right}")), "twice: {line}");
        }
        compared += 1;
    }
    for (n, proved) in (3..).zip(answers(&build, &questions)) {
        assert_eq!(rows[n], proved.into_iter().collect::<BTreeSet<_>>(), "n = {n}");
    }
    assert!(compared > 10_000, "{compared}");
}

/// s = x/z: fractions whose denominators are small, so that many of them are ends of intervals, their
/// neighbours, and others.
fn turns() -> Vec<(u64, u64)> {
    let mut all = vec![(1, 3), (1, 4), (1, 6), (2, 5), (7, 20), (49, 100), (1, 1000), (499_999, 1_000_000)];
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut below = |bound: u64| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) % bound
    };
    for largest in [12, 60, 200, 400, 10_000, 1_000_000_000] {
        for _ in 0..12 {
            let z = 3 + below(largest - 2);
            let x = 1 + below((z - 1) / 2);
            all.push((x, z));
            // Within 10^-9 of it.
            let shifted = [x * 1_000_000_000 + 1, x * 1_000_000_000 - 1][below(2) as usize];
            if largest <= 60 && 2 * shifted < z * 1_000_000_000 {
                all.push((shifted, z * 1_000_000_000));
            }
        }
    }
    all.retain(|(x, z)| 2 * x < *z);
    all
}

/// What `classify` prints on r = 1 is what Theorem 2's list says, for n up to `LAST`.
#[test]
fn grazing_agrees_with_the_proved_list_on_the_circle() {
    let Some(build) = oracle() else { return };
    let turns = turns();
    let ask =
        |(x, z): &(u64, u64)| (3..=LAST).map(move |n| format!("circle {n} {x} {z}")).collect::<Vec<_>>();
    let proved = answers(&build, &turns.iter().flat_map(ask).collect::<Vec<_>>());
    let mut kinds = [0_usize; 4];
    for ((x, z), proved) in turns.iter().zip(proved.chunks(LAST - 2)) {
        let largest = LAST.to_string();
        let (r, s) = ("--r=1", format!("--s={x}/{z}"));
        let text = grazing(&["classify", r, &s, "--max-n", &largest, "--format", "csv"]);
        let mut found = vec![("", BTreeSet::new()); LAST + 1];
        for line in text.lines().skip(1) {
            let cells: Vec<_> = line.split(',').collect();
            let (existence, cases) = &mut found[cells[0].parse::<usize>().unwrap()];
            *existence = cells[1];
            if *existence == "orbit" {
                cases.insert((cells[2].parse::<i8>().unwrap(), cells[3].parse::<i8>().unwrap()));
            }
        }
        for (n, words) in (3..).zip(proved) {
            let [singular, cases, nothing] = &words[..] else { panic!("{words:?}") };
            let cases: BTreeSet<_> =
                cases.chars().zip(CASES).filter(|(bit, _)| *bit == '1').map(|(_, case)| case).collect();
            let (existence, printed) = &found[n];
            let at = || format!("n = {n}, s = {x}/{z}: {existence} {printed:?}, proved {words:?}");
            assert_eq!(*printed, cases, "{}", at());
            assert_eq!(*existence == "singular boundary", singular == "1", "{}", at());
            assert_eq!(*existence == "none", nothing == "1", "{}", at());
            let kind = match *existence {
                "orbit" => 0,
                "none" => 1,
                "singular boundary" => 2,
                // An end of an interval, where the deciding b_{n,k} is zero.
                "iterate boundary" => 3,
                _ => panic!("{}", at()),
            };
            kinds[kind] += 1;
        }
    }
    assert!(kinds.iter().sum::<usize>() >= 10_000 && kinds.iter().all(|&kind| kind >= 20), "{kinds:?}");
    println!("orbits, none, u_n = 0, ends: {kinds:?}");
}

/// What `word` says of a box holds at its corners: of two boxes about each point, or in `.ci/run` of one.
#[test]
fn words_of_boxes_hold_at_their_corners() {
    let Some(build) = oracle() else { return };
    let mut seen = WordsSeen::default();
    let points = points().into_iter().filter(|point| point.largest == 16 && point.q.len() <= 2);
    for (index, point) in points.enumerate() {
        let (p, s, q): (i64, i64, i64) =
            (point.p.parse().unwrap(), point.s.parse().unwrap(), point.q.parse().unwrap());
        // 2/scale wide in a1, 1/scale in a2.
        let scales = [100, 2000];
        for scale in if sampled() { vec![scales[index % 2]] } else { scales.to_vec() } {
            // A box lies in 0 < a2 <= 1.
            if 2 * s * scale <= q || 2 * s * scale + q > 2 * scale * q {
                continue;
            }
            let corners: Vec<_> = [(-1, -1), (-1, 1), (1, -1), (1, 1)]
                .map(|(da, db)| Rational {
                    p: (2 * (p * scale + da * q)).to_string(),
                    s: (2 * s * scale + db * q).to_string(),
                    q: (2 * scale * q).to_string(),
                    largest: point.largest,
                })
                .into();
            let [low, .., high] = &corners[..] else { unreachable!() };
            let output = Command::new(env!("CARGO_BIN_EXE_grazing"))
                .args(["word", "--format", "json", "--letters", "40", "--max-period", &TURNS.to_string()])
                .arg(format!("--a1={}/{}..={}/{}", low.p, low.q, high.p, high.q))
                .arg(format!("--a2={}/{}..={}/{}", low.s, low.q, high.s, high.q))
                .output()
                .unwrap();
            let message = String::from_utf8_lossy(&output.stderr);
            assert!(matches!(output.status.code(), Some(0 | 3)), "{low:?} {high:?}: {message}");
            let Ok(report) = serde_json::from_slice::<serde_json::Value>(&output.stdout) else { continue };
            seen.points += 1;
            let question = |c: &Rational| format!("word {} {} {} {LONGEST}", c.p, c.s, c.q);
            let proved = answers(&build, &corners.iter().map(question).collect::<Vec<_>>());
            for (corner, proved) in corners.iter().zip(&proved) {
                for word in report["words"].as_array().unwrap() {
                    let emu = word["sign_emu"].as_i64().unwrap() as i8;
                    let members = &proved[usize::from(emu < 0)];
                    let letters = compare_periods(corner, word, members, &mut seen);
                    for case in word["cases"].as_array().unwrap() {
                        let sign = emu * case["sign_gamma"].as_i64().unwrap() as i8;
                        compare_edges(corner, case, sign, &letters, &proved[2..], &mut seen);
                    }
                }
            }
        }
    }
    println!("{seen:?}");
    let WordsSeen { points, members, absent, edges, no_edges, open, .. } = seen;
    assert!(points >= 80 && members >= 1000 && absent >= 1000, "{points} {members} {absent}");
    assert!(edges >= 3000 && no_edges >= 3000 && open >= 10, "{edges} {no_edges} {open}");
}

/// A period of a box's word occurs at this corner, and where the word is complete no other does. The periods
/// that are listed, up to where the word tells them.
fn compare_periods(
    corner: &Rational,
    word: &serde_json::Value,
    members: &str,
    seen: &mut WordsSeen,
) -> Vec<usize> {
    let periods = numbers(&word["periods"]);
    let kind = word["end"]["kind"].as_str().unwrap();
    for (n, bit) in (1..=LONGEST).zip(members.chars()) {
        let at = || format!("n = {n} of {word} at {corner:?}");
        if kind == "all" || periods.contains(&n) {
            assert_eq!(bit, '1', "{}", at());
            seen.members += 1;
        } else if kind == "complete" {
            assert_eq!(bit, '0', "{}", at());
            seen.absent += 1;
        }
    }
    // Where every period occurs, the edges are listed up to `--max-period`.
    if kind == "all" {
        (1..=TURNS).collect()
    } else {
        periods.into_iter().filter(|n| *n <= LONGEST).collect()
    }
}

/// An edge of a box is one at this corner; what is neither an edge nor open is none.
fn compare_edges(
    corner: &Rational,
    case: &serde_json::Value,
    sign: i8,
    letters: &[usize],
    signs: &[String],
    seen: &mut WordsSeen,
) {
    let pairs = |key: &str| -> BTreeSet<(usize, usize)> {
        let pair = |edge: &serde_json::Value| (numbers(edge)[0], numbers(edge)[1]);
        case[key].as_array().unwrap().iter().map(pair).collect()
    };
    let (edges, open) = (pairs("edges"), pairs("open"));
    for (&i, &j) in letters.iter().flat_map(|i| letters.iter().map(move |j| (i, j))) {
        let proved = match signs[i - 1].as_bytes()[j - 1] {
            b'+' => sign,
            b'-' => -sign,
            _ => 0,
        };
        let at = || format!("{i} -> {j} at {corner:?}: {case}");
        if open.contains(&(i, j)) {
            seen.open += 1;
        } else if edges.contains(&(i, j)) {
            assert_eq!(proved, 1, "{}", at());
            seen.edges += 1;
        } else {
            assert_eq!(proved, -1, "{}", at());
            seen.no_edges += 1;
        }
    }
}

/// What the built `grazing` prints; it must succeed.
fn grazing(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_grazing")).args(arguments).output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    // 3: of some period Theorem 1 is silent.
    assert!(matches!(output.status.code(), Some(0 | 3)), "{arguments:?}: {message}");
    String::from_utf8(output.stdout).unwrap()
}
