//! Certificates of kind branch: what passes, what must be refused, and whether the orbits of those that pass,
//! also of the damaged ones, are as they say: in floats, from the differential equation and the law of impact
//! alone.

use crate::samples::samples;
use std::f64::consts::TAU;

use crate::common::{
    BRANCH, BRANCH_2, BRANCH_FREQUENCY, BRANCH_SPLICED, Random, answer, are_refused, damage,
    damaged_are_true, eliminate, first_cells, float, flow, nth, rejected, resealed, second_reader, with,
};
use grazing_check::branch::STATEMENT;

/// Σ a cos nt + b sin nt: n, a, b.
type Waves = Vec<[f64; 3]>;

/// Its value and its derivative.
fn at(waves: &Waves, t: f64) -> [f64; 2] {
    waves.iter().fold([0.0; 2], |[x, slope], &[n, a, b]| {
        let (sin, cos) = (n * t).sin_cos();
        [x + a * cos + b * sin, slope + n * (b * cos - a * sin)]
    })
}

/// The oscillator at a value of the parameter, the middles of all intervals.
struct Oscillator {
    /// c and k.
    free: [f64; 2],
    /// The motion without walls.
    response: Waves,
    /// Below and above: place, τ.
    walls: [Option<(Waves, f64)>; 2],
}

/// A quotient of ranges.
fn quotient(word: &str, p: f64) -> f64 {
    let range = |word: &str| {
        let (lo, hi) = word.split_once("..").unwrap();
        (float(lo) + float(hi)) / 2.0
    };
    let value = |list: &str| list.rsplit(',').map(range).fold(0.0, |sum, x| sum * p + x);
    let (above, below) = word.split_once('/').unwrap();
    value(above) / value(below)
}

impl Oscillator {
    fn read(text: &str, p: f64) -> Oscillator {
        let mut lines = text.lines().map(|line| line.split(' ').collect::<Vec<_>>()).peekable();
        while lines.peek().unwrap()[0] != "damping" {
            lines.next();
        }
        let mut one = || quotient(lines.next().unwrap()[1], p);
        let [c, k, force] = [one(), one(), one()];
        let harmonics = |count: &str, lines: &mut dyn Iterator<Item = Vec<&str>>| -> Waves {
            let words = (0..count.parse().unwrap()).map(|_| lines.next().unwrap());
            words.map(|x| [float(x[1]), quotient(x[2], p), quotient(x[3], p)]).collect()
        };
        let count = lines.next().unwrap()[1];
        let forcing = harmonics(count, &mut lines);
        let walls = [0, 1].map(|_| {
            let head = lines.next().unwrap();
            (head[1] != "none").then(|| {
                let mut place = harmonics(head[3], &mut lines);
                place.push([0.0, quotient(head[1], p), 0.0]);
                (place, quotient(head[2], p))
            })
        });
        let response = forcing.iter().map(|&[n, a, b]| {
            let (stiff, damp) = (k - n * n, c * n);
            let size = stiff * stiff + damp * damp;
            [n, (stiff * a - damp * b) / size, (stiff * b + damp * a) / size]
        });
        let mut response: Waves = response.collect();
        response.push([0.0, force / k, 0.0]);
        Oscillator { free: [c, k], response, walls }
    }

    /// Displacement and velocity a time after some at a phase.
    fn after(&self, t: f64, [q, u]: [f64; 2], time: f64) -> [f64; 2] {
        let ([r, v], [last, speed]) = (at(&self.response, t), at(&self.response, t + time));
        let [e11, e12, e21, e22] = flow(self.free, time);
        [last + e11 * (q - r) + e12 * (u - v), speed + e21 * (q - r) + e22 * (u - v)]
    }

    /// The gap to a wall (0 below, 1 above) and its derivative, of a state.
    fn gap(&self, side: usize, t: f64, [q, u]: [f64; 2]) -> [f64; 2] {
        let (place, _) = self.walls[side].as_ref().unwrap();
        let ([w, slope], sign) = (at(place, t), 1.0 - 2.0 * side as f64);
        [sign * (q - w), sign * (u - slope)]
    }

    /// The state just after an impact.
    fn leaves(&self, side: usize, t: f64, speed: f64) -> [f64; 2] {
        let (place, tau) = self.walls[side].as_ref().unwrap();
        let ([w, slope], sign) = (at(place, t), 1.0 - 2.0 * side as f64);
        [w, slope + sign * tau * speed]
    }
}

/// A pattern: wall and periods of each impact.
type Pattern = Vec<(usize, f64)>;

/// The gap, and what its derivative is beside −V, at the end of each flight.
fn wrong(oscillator: &Oscillator, pattern: &Pattern, x: &[f64]) -> Vec<f64> {
    let m = pattern.len();
    let flight = |i: usize| {
        let (next, (side, periods)) = ((i + 1) % m, pattern[i]);
        let time = TAU * periods + x[next] - x[i];
        let state = oscillator.after(x[i], oscillator.leaves(side, x[i], x[m + i]), time);
        let [gap, slope] = oscillator.gap(pattern[next].0, x[next], state);
        [gap, slope + x[m + next]]
    };
    (0..m).flat_map(flight).collect()
}

/// The solution that Newton's method finds.
fn solved(oscillator: &Oscillator, pattern: &Pattern, start: &[f64]) -> Option<Vec<f64>> {
    let mut x = start.to_vec();
    for _ in 0..50 {
        let now = wrong(oscillator, pattern, &x);
        if now.iter().all(|f| f.abs() < 1e-12) {
            return Some(x);
        }
        let column = |i: usize| {
            let moved = |by: f64| {
                let mut there = x.clone();
                there[i] += by;
                wrong(oscillator, pattern, &there)
            };
            moved(1e-6).iter().zip(moved(-1e-6)).map(|(right, left)| (right - left) / 2e-6).collect()
        };
        let change = eliminate((0..x.len()).map(column).collect(), now)?;
        x.iter_mut().zip(change).for_each(|(x, change)| *x -= change);
    }
    None
}

/// Where phase and speed of the first impact are after once round, by flights to the next wall.
fn round(oscillator: &Oscillator, pattern: &Pattern, orbit: &[f64], [t, v]: [f64; 2]) -> [f64; 2] {
    let m = pattern.len();
    let (mut t, mut v, mut turns) = (t, v, 0.0);
    for i in 0..m {
        let (next, (side, periods)) = ((i + 1) % m, pattern[i]);
        turns += periods;
        let state = oscillator.leaves(side, t, v);
        let mut time = TAU * turns + orbit[next] - t;
        for _ in 0..20 {
            let [gap, slope] = oscillator.gap(pattern[next].0, t + time, oscillator.after(t, state, time));
            time -= gap / slope;
        }
        let [_, slope] = oscillator.gap(pattern[next].0, t + time, oscillator.after(t, state, time));
        (t, v) = (t + time, -slope);
    }
    [t, v]
}

/// Trace and determinant of that map's derivative.
fn multipliers(oscillator: &Oscillator, pattern: &Pattern, orbit: &[f64]) -> [f64; 2] {
    let start = [orbit[0], orbit[pattern.len()]];
    let column = |i: usize| {
        let moved = |by: f64| {
            let mut there = start;
            there[i] += by;
            round(oscillator, pattern, orbit, there)
        };
        let (right, left) = (moved(1e-6), moved(-1e-6));
        [0, 1].map(|j| (right[j] - left[j]) / 2e-6)
    };
    let [[a, c], [b, d]] = [column(0), column(1)];
    [a + d, a * d - b * c]
}

/// What a file says that is not so, in some values of each cell.
fn lie(text: &str) -> Option<String> {
    let words: Vec<Vec<&str>> = text.lines().map(|line| line.split(' ').collect()).collect();
    let pattern: Pattern = words
        .iter()
        .filter(|words| words[0] == "strike")
        .map(|words| (usize::from(words[1] == "upper"), float(words[2])))
        .collect();
    let m = pattern.len();
    let mut last: Option<Vec<f64>> = None;
    for (at, cell) in words.iter().enumerate().filter(|(_, words)| words[0] == "cell") {
        let [from, to] = [float(cell[1]), float(cell[2])];
        let line = |i: usize| words[at + 1..=at + m].iter().map(move |words| float(words[i]));
        let (point, rates): (Vec<f64>, Vec<f64>) =
            (line(1).chain(line(2)).collect(), line(3).chain(line(4)).collect());
        let [radius, within] = [1, 2].map(|i| float(words[at + m + 1][i]));
        for part in [0.0, 0.03, 0.3, 0.5, 0.8, 1.0] {
            let p = from + part * (to - from);
            let oscillator = Oscillator::read(text, p);
            let here: Vec<f64> =
                point.iter().zip(&rates).map(|(y, rate)| y + rate * (p - (from + to) / 2.0)).collect();
            let Some(orbit) = solved(&oscillator, &pattern, &here) else {
                return Some(format!("no orbit at {p}"));
            };
            let away = orbit.iter().zip(&here).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
            if away > within + 1e-9 {
                return Some(format!("{away} from the line at {p}"));
            }
            // From elsewhere in the box to no other solution there.
            for shift in [-0.9, 0.9] {
                let start: Vec<f64> = here.iter().map(|y| y + shift * radius).collect();
                if let Some(other) = solved(&oscillator, &pattern, &start) {
                    let inside = other.iter().zip(&here).all(|(x, y)| (x - y).abs() < radius - 1e-9);
                    let same = other.iter().zip(&orbit).all(|(x, y)| (x - y).abs() < 1e-6);
                    if inside && !same {
                        return Some(format!("two orbits at {p}"));
                    }
                }
            }
            if orbit[m..].iter().any(|&v| v <= 0.0) {
                return Some(format!("no speed at {p}"));
            }
            if let Some(before) = last.take()
                && before.iter().zip(&orbit).any(|(x, y)| (x - y).abs() > 1e-6)
            {
                return Some(format!("another orbit at {p}"));
            }
            for (i, &(side, periods)) in pattern.iter().enumerate() {
                let time = TAU * periods + orbit[(i + 1) % m] - orbit[i];
                let state = oscillator.leaves(side, orbit[i], orbit[m + i]);
                for k in 1..100 {
                    let s = time * f64::from(k) / 100.0;
                    let there = oscillator.after(orbit[i], state, s);
                    for wall in [0, 1].into_iter().filter(|&wall| oscillator.walls[wall].is_some()) {
                        if oscillator.gap(wall, orbit[i] + s, there)[0] < -1e-9 {
                            return Some(format!("no gap at {p}"));
                        }
                    }
                }
            }
            let [trace, det] = multipliers(&oscillator, &pattern, &orbit);
            let inside = det < 1.0 && 1.0 + det > trace.abs();
            let edge = (1.0 + det - trace.abs()).abs() < 1e-4 * (1.0 + trace.abs());
            if !edge && cell[3] == if inside { "unstable" } else { "stable" } {
                return Some(format!("not {} at {p}", cell[3]));
            }
            last = (part == 1.0).then_some(orbit);
        }
    }
    None
}

#[test]
fn what_is_written_passes_and_is_named() {
    let checked = answer(BRANCH).unwrap();
    assert_eq!((checked.kind, checked.range.clone(), checked.statement), ("branch", Some(3..=3), STATEMENT));
    let said = checked.to_string();
    for line in [
        "proved, branch of 3 periods",
        "  parameter: mu, from 0.004 to 0.008, in 24 cells",
        "  pattern: 1 impact in 3 periods, and in no fewer: lower wall, next after 3",
        "  box: in each cell the only orbit of this pattern that is so near its line",
        "  lower wall: -1 + (1 + mu) cos t, restitution 1",
    ] {
        assert!(said.lines().any(|known| known == line), "{line}: {said}");
    }
    // The paper's flip is at 0.005479.
    let stability = said.lines().find(|line| line.starts_with("  stability")).unwrap();
    assert!(stability.starts_with("  stability: unstable from 0.004 to 0.00547"), "{stability}");
    assert!(stability.contains("; open from 0.00547") && stability.ends_with("to 0.008"), "{stability}");
    let said = answer(BRANCH_2).unwrap().to_string();
    assert!(
        said.contains("  pattern: 2 impacts in 6 periods") && said.contains("  stability: unstable from"),
        "{said}"
    );
}

/// The `at`-th line that begins so with one of its words changed.
fn word(text: &str, start: &str, at: usize, which: usize, to: &str) -> String {
    let line = text.lines().filter(|line| line.starts_with(start)).nth(at).unwrap();
    let mut words: Vec<&str> = line.split(' ').collect();
    words[which] = to;
    nth(text, start, at, &words.join(" "))
}

#[test]
fn weaker_claims_pass() {
    let one = first_cells(BRANCH, 1);
    for text in [
        one.clone(),
        word(&one, "cell ", 0, 3, "open"),
        // A part of the cell, about the same line at its own middle.
        first_cells(BRANCH, 7),
        first_cells(BRANCH_2, 2),
        word(&one, "radius ", 0, 1, "0.02"),
        with(&one, "parameter", "parameter another_name"),
    ] {
        assert!(answer(&text).is_ok(), "{:?}", answer(&text));
    }
}

/// False claims, with what is seen of them.
fn forgeries() -> Vec<(String, &'static str)> {
    let mut all: Vec<(String, &'static str)> = Vec::new();
    let one = first_cells(BRANCH, 1);
    let mut add = |reason: &'static str, texts: Vec<String>| {
        all.extend(texts.into_iter().map(|text| (text, reason)));
    };
    // Other points, rates, boxes, rows; a range that is too long for one line.
    let krawczyk = "Krawczyk's test does not map the box into itself";
    let mut lines = Vec::new();
    for (which, changes) in [
        (1, &["6.25", "6.2412", "0", "6.1"][..]),
        (2, &["0.053", "0.05", "0.5", "0"][..]),
        (3, &["0", "8", "-8.5"][..]),
        (4, &["0", "-10", "11"][..]),
    ] {
        lines.extend(changes.iter().map(|change| word(&one, "at ", 0, which, change)));
    }
    lines.extend(["1", "0.9", "0.5"].iter().map(|radius| word(&one, "radius ", 0, 1, radius)));
    lines.extend(["0.00001", "0.000001"].iter().map(|within| word(&one, "radius ", 0, 2, within)));
    lines.extend(["1", "70", "-70"].iter().map(|entry| word(&one, "row ", 0, 1, entry)));
    lines.extend(["0.006", "0.01", "0.1", "1"].iter().map(|to| word(&one, "cell ", 0, 2, to)));
    lines.extend(["0.003", "0", "-1"].iter().map(|from| word(&one, "cell ", 0, 1, from)));
    // Another pattern, and another oscillator.
    lines.push(word(&one, "strike", 0, 2, "4"));
    lines.push(resealed(&word(&one, "harmonic", 0, 2, "2..2,1..1/1..1")));
    lines.push(resealed(&word(&one, "damping", 0, 1, "0..0/1..1")));
    lines.push(resealed(&word(&one, "damping", 0, 1, "0.2..0.3/1..1")));
    lines.push(resealed(&word(&one, "lower", 0, 1, "-2..-2/1..1")));
    add(krawczyk, lines);
    add(
        "the smaller radius must be positive and at most the larger",
        vec![
            word(&one, "radius ", 0, 1, "0.00001"),
            word(&one, "radius ", 0, 2, "0"),
            word(&one, "radius ", 0, 2, "0.06"),
        ],
    );
    // Stable where it is not, and where it flips.
    let cells = BRANCH.lines().filter(|line| line.starts_with("cell ")).count();
    for at in 0..cells {
        let line = BRANCH.lines().filter(|line| line.starts_with("cell ")).nth(at).unwrap();
        let claims: &[&str] = match line.rsplit(' ').next().unwrap() {
            "stable" => &["unstable"],
            "unstable" => &["stable"],
            _ => &["stable", "unstable"],
        };
        add(
            "the orbit is not certainly",
            claims.iter().map(|claim| word(BRANCH, "cell ", at, 3, claim)).collect(),
        );
    }
    // Pieces that are too few or too long, or end too soon.
    let pieces: Vec<usize> =
        one.lines().enumerate().filter(|(_, line)| line.starts_with("until ")).map(|(i, _)| i).collect();
    let without = |which: usize| {
        let text: Vec<&str> =
            one.lines().enumerate().filter(|(i, _)| *i != pieces[which]).map(|(_, line)| line).collect();
        with(&(text.join("\n") + "\n"), "flight", &format!("flight {}", pieces.len() - 1))
    };
    add("the pieces of flight 1 stop before its end", vec![without(pieces.len() - 1)]);
    add("the pieces of flight 1 do not follow one another", vec![nth(&one, "until ", 3, "until 0.1")]);
    let whole = one.split("flight ").next().unwrap();
    add(
        "the gap on piece 1 of flight 1",
        vec![format!("{whole}flight 1\nuntil 19\n"), format!("{whole}flight 2\nuntil 9\nuntil 19\n")],
    );
    all
}

/// An amplitude that is the parameter's square and a constant: at the cell's middle nothing moves, so that
/// only what happens in all of the cell tells how far the orbit goes.
#[test]
fn what_moves_away_from_the_middle_is_seen() {
    let one = first_cells(BRANCH, 1);
    let line = one.lines().find(|line| line.starts_with("cell ")).unwrap();
    let ends: Vec<f64> = line.split(' ').skip(1).take(2).map(float).collect();
    let amplitude = 1.0 + f64::midpoint(ends[0], ends[1]);
    let text = word(&one, "harmonic", 0, 2, &format!("{amplitude:.5}..{amplitude:.5},0..0,1..1/1..1"));
    let text = word(&word(&text, "at ", 0, 3, "0"), "at ", 0, 4, "0");
    let over = |end: &str| {
        let text = word(&word(&text, "cell ", 0, 1, &format!("-{end}")), "cell ", 0, 2, end);
        resealed(&text)
    };
    assert!(answer(&over("0.001")).is_ok(), "{:?}", answer(&over("0.001")));
    assert_eq!(lie(&over("0.001")), None);
    for end in ["0.03", "0.1"] {
        assert!(lie(&over(end)).is_some(), "{end}");
        let why = rejected(&over(end));
        assert!(why.contains("Krawczyk's test"), "{end}: {why}");
    }
}

/// A cell of either orbit of period 4, each right by itself, which meet at one value: there is no way from
/// one to the other.
#[test]
fn cells_of_different_orbits_are_not_one_branch() {
    let why = rejected(BRANCH_SPLICED);
    assert!(why.contains("false: cell 2 of 2: its orbit may not be that of the cell before (B4)"), "{why}");
    assert!(lie(BRANCH_SPLICED).is_some_and(|why| why.starts_with("another orbit at -0.05")));
    let former = first_cells(BRANCH_SPLICED, 1);
    let latter = BRANCH_SPLICED.replacen(former.split("\ncell ").nth(1).unwrap(), "", 1);
    let latter = with(&latter.replacen("\ncell cell ", "\ncell ", 1), "cells", "cells 1");
    for text in [former, latter] {
        assert!(answer(&text).is_ok(), "{:?}", answer(&text));
    }
}

/// What is of no form, with the reason.
fn malformed() -> Vec<(String, &'static str)> {
    let all = [
        ("kind", "kind branch 2", "expected a line"),
        ("branch", "branch 0", "a branch has at least one impact"),
        ("branch", "branch 25", "expected the number of impacts"),
        ("branch", "branch 2", "expected a line \"strike"),
        ("strike", "strike lower 0", "the periods of an orbit must not sum to 0"),
        ("strike", "strike upper 3", "there is no upper wall"),
        ("strike", "strike lower 10001", "expected the periods to the next impact"),
        ("cells", "cells 0", "there is at least one cell"),
        ("cells", "cells 10001", "expected the number of cells"),
        ("cells", "cells 23", "the file goes on after the last cell"),
        ("cell ", "cell 0.004 0.004 unstable", "a cell ends after it begins"),
        ("cell ", "cell 0.004 0.0044 unstable", "a cell begins where the one before ends"),
        ("cell ", "cell 0.004 0.0045 perhaps", "expected stable, unstable or open"),
        ("cell ", "cell 0.0040 0.0045 open", "expected a decimal"),
        ("parameter", "parameter 7up", "expected a name"),
        ("flight", "flight 0", "a flight has at least one piece"),
        ("flight", "flight 8000000", "the check would take up to"),
        ("damping", "damping 1/1", "expected LOWER..UPPER"),
    ];
    all.iter().map(|(start, line, reason)| (with(BRANCH, start, line), *reason)).collect()
}

#[test]
fn forged_claims_are_refused() {
    are_refused(&forgeries(), &malformed());
}

/// `reference/branch.py` was written from the form alone, with other formulas. Of whole files it takes one.
#[test]
fn a_second_reader_gives_the_same_verdicts() {
    let one = first_cells(BRANCH, 1);
    let (some, open) = (first_cells(BRANCH, 5), word(&one, "cell ", 0, 3, "open"));
    let right = [BRANCH_2, BRANCH_FREQUENCY, &one, &some, &open].map(String::from);
    let short = |text: &String| text.contains("\ncells 1\n");
    let wrong = forgeries().into_iter().map(|(text, _)| text).filter(short);
    let wrong = wrong.chain([BRANCH_SPLICED.into(), word(&one, "cell ", 0, 3, "stable")]);
    let wrong = wrong.chain(malformed().into_iter().map(|(text, _)| text));
    let all: Vec<(String, bool)> =
        right.map(|text| (text, true)).into_iter().chain(wrong.map(|text| (text, false))).collect();
    let Some(verdicts) = second_reader("branch.py", all.iter().map(|(text, _)| text)) else { return };
    for ((text, right), line) in all.iter().zip(&verdicts) {
        let ours = answer(text);
        assert_eq!((ours.is_ok(), line.contains(": proved, ")), (*right, *right), "{ours:?}, {line}\n{text}");
    }
}

/// What only one of the readers can prove may be true; what either accepts is.
#[test]
fn a_second_reader_accepts_no_damage_that_is_false() {
    let (text, mut random) = (first_cells(BRANCH, 1), Random(74));
    let damaged: Vec<String> = (0..samples::<usize>(30)).map(|_| damage(&mut random, &text)).collect();
    let Some(verdicts) = second_reader("branch.py", &damaged) else { return };
    let (mut accepted, mut apart) = (0, 0);
    for (text, line) in damaged.iter().zip(&verdicts) {
        let (ours, theirs) = (answer(text), line.contains(": proved, "));
        let is_malformed = matches!(ours, Err(grazing_check::Rejection::Malformed { .. }));
        assert!(!(theirs && is_malformed), "{ours:?}, {line}\n{text}");
        assert!(!theirs || lie(text).is_none(), "{line}\n{text}");
        accepted += usize::from(theirs);
        apart += usize::from(ours.is_ok() != theirs);
    }
    println!("{accepted} of {} accepted, {apart} by one of the readers alone", damaged.len());
    assert!(
        accepted > damaged.len() / 20 && apart <= damaged.len() / 20,
        "{accepted} accepted, {apart} apart"
    );
}

#[test]
fn damaged_certificates_of_branches_are_true_or_rejected() {
    damaged_are_true(71, samples::<usize>(150), &first_cells(BRANCH, 4), lie);
    damaged_are_true(72, samples::<usize>(50), &first_cells(BRANCH_2, 2), lie);
}

/// The same of other oscillators, with the digests that belong to them.
#[test]
fn branches_of_damaged_oscillators_are_true_or_rejected() {
    let (mut random, mut still) = (Random(crate::samples::seed(73)), 0);
    let text = first_cells(BRANCH, 2);
    let lines: Vec<usize> = (4..11).collect();
    for _ in 0..samples::<usize>(150) {
        let mut all: Vec<String> = text.lines().map(String::from).collect();
        let at = lines[random.below(lines.len())];
        // A digit of the oscillator's.
        let digits: Vec<usize> =
            all[at].bytes().enumerate().filter(|(_, byte)| byte.is_ascii_digit()).map(|(i, _)| i).collect();
        if digits.is_empty() {
            continue;
        }
        let digit = digits[random.below(digits.len())];
        all[at].replace_range(digit..=digit, &random.below(10).to_string());
        let damaged = resealed(&(all.join("\n") + "\n"));
        if answer(&damaged).is_ok() {
            still += usize::from(damaged != text);
            assert_eq!(lie(&damaged), None, "{damaged}");
        }
    }
    assert!(crate::samples::tried(still, 10), "{still}");
}
