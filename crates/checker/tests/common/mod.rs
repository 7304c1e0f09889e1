//! What the tests share.

#![allow(dead_code)]

use std::{f64::consts::PI, fs, path::Path, process::Command};

use grazing_check::{Checked, Rejection, check};

pub const THEOREM2: &str = include_str!("../data/theorem2.txt");
pub const COVER: &str = include_str!("../data/cover.txt");
pub const ORBIT_4: &str = include_str!("../data/orbit-4.txt");
pub const SADDLE_NODE: &str = include_str!("../data/event-sn.txt");
pub const FLIP: &str = include_str!("../data/event-pd.txt");
pub const GRAZING: &str = include_str!("../data/event-gr3.txt");
pub const ORBIT_6: &str = include_str!("../data/orbit-6.txt");
pub const FREE: &str = include_str!("../data/orbit-free.txt");
pub const FREE_MACHINE: &str = include_str!("../data/machine-free.txt");
pub const CHAOS_12: &str = include_str!("../data/chaos-12.txt");
pub const CHAOS_123: &str = include_str!("../data/chaos-123.txt");
pub const CHAOS_MIRRORED: &str = include_str!("../data/chaos-mirrored.txt");
pub const CHAOS_MIRRORED_BEFORE: &str = include_str!("../data/chaos-mirrored-before.txt");
pub const ATTRACTOR: &str = include_str!("../data/attractor.txt");
pub const ATTRACTOR_WIDE: &str = include_str!("../data/attractor-wide.txt");
pub const ATTRACTOR_SEVERAL: &str = include_str!("../data/attractor-several.txt");
pub const ATTRACTOR_CELLS: &str = include_str!("../data/attractor-cells.txt");
pub const ATTRACTOR_CELLS_WIDE: &str = include_str!("../data/attractor-cells-wide.txt");
pub const ATTRACTOR_CELLS_SEVERAL: &str = include_str!("../data/attractor-cells-several.txt");
pub const PARAMETER: &str = include_str!("../data/parameter.txt");
pub const PARAMETER_SEVERAL: &str = include_str!("../data/parameter-several.txt");
pub const PARAMETER_ATTRACTOR: &str = include_str!("../data/parameter-attractor.txt");
pub const PARAMETER_CELLS: &str = include_str!("../data/parameter-cells.txt");
pub const PARAMETER_FREQUENCY: &str = include_str!("../data/parameter-frequency.txt");
pub const PARAMETER_HERTZ: &str = include_str!("../data/parameter-hertz.txt");
pub const PARAMETER_MIRRORED: &str = include_str!("../data/parameter-mirrored.txt");
pub const RANGE_1: &str = include_str!("../data/range-1.txt");
pub const RANGE_12: &str = include_str!("../data/range-12.txt");
pub const RANGE_13: &str = include_str!("../data/range-13.txt");
pub const RANGE_ALONE: &str = include_str!("../data/range-alone.txt");
pub const RANGE_BEFORE: &str = include_str!("../data/range-before.txt");
pub const RANGE_MIRRORED: &str = include_str!("../data/range-mirrored.txt");
pub const RANGE_MIRRORED_BEFORE: &str = include_str!("../data/range-mirrored-before.txt");
pub const RANGE_MIRRORED_BEYOND: &str = include_str!("../data/range-mirrored-beyond.txt");
pub const BRANCH: &str = include_str!("../data/branch.txt");
pub const BRANCH_2: &str = include_str!("../data/branch-2.txt");
pub const BRANCH_FREQUENCY: &str = include_str!("../data/branch-frequency.txt");
pub const BRANCH_SPLICED: &str = include_str!("../data/branch-spliced.txt");
pub const SINGLE_1: &str = include_str!("../data/single-1.txt");
pub const SINGLE_2: &str = include_str!("../data/single-2.txt");
pub const SINGLE_3: &str = include_str!("../data/single-3.txt");
pub const SINGLE_MIRRORED_1: &str = include_str!("../data/single-mirrored-1.txt");
pub const SINGLE_MIRRORED_2: &str = include_str!("../data/single-mirrored-2.txt");
pub const SINGLE_MIRRORED_3: &str = include_str!("../data/single-mirrored-3.txt");
pub const SINGLE_RESONANCE: &str = include_str!("../data/single-resonance.txt");
pub const NOTHING_MIRRORED: &str = include_str!("../data/nothing-mirrored.txt");
pub const NOTHING: &str = include_str!("../data/nothing.txt");
pub const SHARE: &str = include_str!("../data/share.txt");
pub const SHARE_POLAR: &str = include_str!("../data/share-polar.txt");
pub const SHARE_PLANE: &str = include_str!("../data/share-plane.txt");
pub const WORD: &str = include_str!("../data/word.txt");
pub const ENTROPY: &str = include_str!("../data/entropy.txt");
pub const WORD_BY_THEOREM: &str = include_str!("../data/word-by-theorem.txt");

pub fn answer(text: &str) -> Result<Checked, Rejection> {
    check(&mut text.as_bytes())
}

/// The rejection in words.
pub fn rejected(text: &str) -> String {
    answer(text).map_or_else(|rejection| rejection.to_string(), |checked| panic!("accepted: {checked}"))
}

/// The text with the first line that begins with `start` replaced by other lines, if any.
pub fn with(text: &str, start: &str, lines: &str) -> String {
    let at = text.lines().position(|line| line.starts_with(start)).expect("the line is there");
    let all = text.lines().enumerate().map(|(i, line)| if i == at { lines } else { line });
    all.filter(|line| !line.is_empty()).map(|line| format!("{line}\n")).collect()
}

/// What a second reader in Python, of this name, says of each text; none but with `GRAZING_REQUIRE_PYTHON=1`.
/// The test is named after readers: `.ci/run` asks for those by that word.
pub fn second_reader(script: &str, texts: impl IntoIterator<Item = impl AsRef<[u8]>>) -> Option<Vec<String>> {
    if !crate::samples::asked("GRAZING_REQUIRE_PYTHON", &format!("the second reader {script}")) {
        return None;
    }
    let test = std::thread::current().name().map(String::from).expect("a test has a name");
    assert!(test.contains("reader"), "{test}: the name does not say that a second reader is asked");
    // Tests of one file run side by side.
    let own = format!("{script}-{}-{:?}", std::process::id(), std::thread::current().id());
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(own);
    fs::create_dir_all(&folder).unwrap();
    let mut files = Vec::new();
    for text in texts {
        let file = folder.join(files.len().to_string());
        fs::write(&file, text).unwrap();
        files.push(file);
    }
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("reference").join(script);
    let output = Command::new("python3").arg(script).args(&files).output().unwrap();
    let verdicts: Vec<String> = String::from_utf8(output.stdout).unwrap().lines().map(String::from).collect();
    assert_eq!(verdicts.len(), files.len(), "{}", String::from_utf8_lossy(&output.stderr));
    fs::remove_dir_all(folder).unwrap();
    Some(verdicts)
}

/// The text with the `at`-th line that begins so (from 0) in place of another.
pub fn nth(text: &str, start: &str, at: usize, line: &str) -> String {
    let mut seen = 0;
    let lines = text.lines().map(|old| {
        let here = old.starts_with(start) && seen == at;
        seen += usize::from(old.starts_with(start));
        if here { line } else { old }
    });
    let all: Vec<&str> = lines.collect();
    assert!(seen > at, "{start}: line {at} is not there");
    all.join("\n") + "\n"
}

/// Between mirrored walls at a resonance, of two half periods: ω = 3/2.
pub fn mirrored_at_resonance() -> String {
    let (head, _) = SINGLE_MIRRORED_2.split_once("parts ").unwrap();
    let text = with(&with(head, "damping", "damping 1/4 1/4"), "stiffness", "stiffness 145/64 145/64");
    text + "parts 1\npart 1/25 stable\ncells 3\ncell 0.1\ncell 0.2\ncell 0.3\n"
}

/// A branch with its first cells alone.
pub fn first_cells(text: &str, cells: usize) -> String {
    let (head, rest) = text.split_once("\ncell ").unwrap();
    let blocks: Vec<&str> = rest.trim_end().split("\ncell ").take(cells).collect();
    let blocks: Vec<String> = blocks.iter().map(|block| format!("\ncell {block}")).collect();
    with(&format!("{head}{}\n", blocks.concat()), "cells", &format!("cells {cells}"))
}

/// A fraction or a decimal.
pub fn float(word: &str) -> f64 {
    match word.split_once('/') {
        Some((p, q)) => p.parse::<f64>().unwrap() / q.parse::<f64>().unwrap(),
        None => word.parse().unwrap(),
    }
}

/// E₁₁, E₁₂, E₂₁, E₂₂ of q″ = −c q′ − k q over a time.
pub fn flow([c, k]: [f64; 2], t: f64) -> [f64; 4] {
    let d = k - c * c / 4.0;
    let (wave, sine) = match d {
        d if d > 1e-12 => ((d.sqrt() * t).cos(), (d.sqrt() * t).sin() / d.sqrt()),
        d if d < -1e-12 => (((-d).sqrt() * t).cosh(), ((-d).sqrt() * t).sinh() / (-d).sqrt()),
        _ => (1.0, t),
    };
    let decay = (-c * t / 2.0).exp();
    let (a, b) = (decay * (wave + c / 2.0 * sine), decay * sine);
    [a, b, -k * b, a - c * b]
}

/// Numbers that look random, the same in every run (Knuth's MMIX generator).
pub struct Random(pub u64);

impl Random {
    /// From 0 to `below` − 1.
    pub fn below(&mut self, below: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((u128::from(self.0 >> 16) * below as u128) >> 48) as usize
    }

    pub fn pick<'a, T: ?Sized>(&mut self, list: &[&'a T]) -> &'a T {
        list[self.below(list.len())]
    }

    /// From 0 to 1.
    pub fn part(&mut self) -> f64 {
        self.below(1 << 30) as f64 / f64::from(1 << 30)
    }
}

/// Σ xᵢ columnᵢ = right.
pub fn eliminate(mut columns: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let n = right.len();
    for i in 0..n {
        let pivot = (i..n).max_by(|&a, &b| columns[i][a].abs().total_cmp(&columns[i][b].abs()))?;
        columns.iter_mut().for_each(|column| column.swap(i, pivot));
        right.swap(i, pivot);
        if columns[i][i] == 0.0 {
            return None;
        }
        for row in i + 1..n {
            let factor = columns[i][row] / columns[i][i];
            columns.iter_mut().for_each(|column| column[row] -= factor * column[i]);
            right[row] -= factor * right[i];
        }
    }
    for i in (0..n).rev() {
        right[i] /= columns[i][i];
        for row in 0..i {
            right[row] -= columns[i][row] * right[i];
        }
    }
    Some(right)
}

/// One damage: a word replaced, or a line moved, lost or doubled.
pub fn damage(random: &mut Random, text: &str) -> String {
    let mut lines: Vec<String> = text.lines().map(String::from).collect();
    let at = 3 + random.below(lines.len() - 3);
    match random.below(12) {
        0 => drop(lines.remove(at)),
        1 => lines.insert(at, lines[at].clone()),
        2 => {
            let other = 3 + random.below(lines.len() - 3);
            lines.swap(at, other);
        }
        _ => {
            let mut words: Vec<String> = lines[at].split(' ').map(String::from).collect();
            let j = random.below(words.len());
            words[j] = changed(random, &words[j], &lines);
            lines[at] = words.join(" ");
        }
    }
    lines.join("\n") + "\n"
}

/// Damages a certificate so many times: of what is still accepted nothing is a `lie`, nor is it before.
pub fn damaged_are_true(seed: u64, trials: usize, text: &str, lie: impl Fn(&str) -> Option<String>) {
    damaged_so_are_true((seed, trials, trials / 50), text, damage, lie);
}

/// The same with damage of a certificate's own, of which more than so many are accepted.
pub fn damaged_so_are_true(
    (seed, trials, least): (u64, usize, usize),
    text: &str,
    damage: impl Fn(&mut Random, &str) -> String,
    lie: impl Fn(&str) -> Option<String>,
) {
    assert_eq!(lie(text), None);
    let mut random = Random(crate::samples::seed(seed));
    let [mut refused, mut unchanged, mut still] = [0; 3];
    for _ in 0..trials {
        let mut damaged = damage(&mut random, text);
        if random.below(4) == 0 {
            damaged = damage(&mut random, &damaged);
        }
        if answer(&damaged).is_err() {
            refused += 1;
        } else if damaged == text {
            unchanged += 1;
        } else {
            still += 1;
            assert_eq!(lie(&damaged), None, "{damaged}");
        }
    }
    println!("{refused} rejected, {unchanged} unchanged, {still} still true");
    let enough = crate::samples::tried(still, least as u64) && refused > trials / 3;
    assert!(enough, "{still} accepted, {refused} rejected");
}

/// False claims are refused as false for the reasons given with them, and what is of no form for its reasons.
pub fn are_refused(forgeries: &[(String, &str)], malformed: &[(String, &str)]) {
    println!("{} forgeries, {} more of the form", forgeries.len(), malformed.len());
    let mut wrong = String::new();
    for (text, reason) in forgeries {
        let why = answer(text).map_or_else(|why| why.to_string(), |_| "accepted".into());
        if !(why.contains("false") && why.contains(reason)) {
            let lines: Vec<&str> = text.lines().skip(3).collect();
            wrong += &format!("{reason}: {why} {lines:?}\n");
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
    for (text, reason) in malformed {
        let why = rejected(text);
        assert!(why.contains(reason), "{reason}: {why}");
    }
}

/// Another word: a digit changed, the sign, nearby by a thousandth or a tenth, or a word from elsewhere.
fn changed(random: &mut Random, word: &str, lines: &[String]) -> String {
    let short = |x: f64| {
        let text = format!("{x:.9}");
        text.trim_end_matches('0').trim_end_matches('.').to_string()
    };
    match (random.below(6), word.parse::<f64>()) {
        (0, _) => word.strip_prefix('-').map_or(format!("-{word}"), String::from),
        (1 | 2, Ok(x)) => {
            let size = [1e-4, 1e-3, 1e-2, 1e-1, 1.0][random.below(5)];
            short(x + (random.below(2001) as f64 - 1000.0) / 1000.0 * size * x.abs().max(1e-3))
        }
        (3, _) => {
            let line = &lines[3 + random.below(lines.len() - 3)];
            let words: Vec<&str> = line.split(' ').collect();
            words[random.below(words.len())].to_string()
        }
        _ => {
            let digits: Vec<usize> =
                word.bytes().enumerate().filter(|(_, byte)| byte.is_ascii_digit()).map(|(i, _)| i).collect();
            if digits.is_empty() {
                return format!("{word}1");
            }
            let at = digits[random.below(digits.len())];
            format!("{}{}{}", &word[..at], random.below(10), &word[at + 1..])
        }
    }
}

/// An oscillator near its touch, above the wall σν − 1 + cos jt.
pub struct Touching {
    /// Whether there is a mirrored wall above it; then words count half periods.
    pub mirrored: bool,
    /// c, k, τ.
    pub parameters: [f64; 3],
    /// σ.
    pub side: f64,
    pub order: f64,
    pub depth: f64,
}

impl Touching {
    /// (q, q′) a time later.
    pub fn after(&self, [q, u]: [f64; 2], time: f64) -> [f64; 2] {
        let [a, b, c, d] = flow([self.parameters[0], self.parameters[1]], time);
        [a * q + b * u, c * q + d * u]
    }

    /// A period, or half period.
    pub fn turn(&self) -> f64 {
        if self.mirrored { PI } else { 2.0 * PI }
    }

    /// As seen at the wall so many periods on.
    fn sign(&self, periods: f64) -> f64 {
        if self.mirrored && periods % 2.0 == 1.0 { -1.0 } else { 1.0 }
    }

    /// The phase of an impact of strength s, and its place over ν.
    fn impact(&self, s: f64) -> [f64; 2] {
        let t = -(self.depth * s / (2.0 * self.order)).asin() / self.order;
        [t, self.side - (1.0 - (self.order * t).cos()) / self.depth]
    }

    /// The velocities over ν of legs round a word, whose impacts have these strengths.
    fn velocities(&self, word: &[f64], s: &[f64]) -> Vec<[f64; 2]> {
        let leg = |i: usize| {
            let ([t, place], [u, last]) = (self.impact(s[i]), self.impact(s[(i + 1) % s.len()]));
            let time = self.turn() * word[i] + u - t;
            let e = flow([self.parameters[0], self.parameters[1]], time).map(|x| self.sign(word[i]) * x);
            let after = (last - e[0] * place) / e[1];
            [after, e[2] * place + e[3] * after]
        };
        (0..s.len()).map(leg).collect()
    }

    fn wrong(&self, word: &[f64], s: &[f64]) -> Vec<f64> {
        let (legs, tau, count) = (self.velocities(word, s), self.parameters[2], s.len());
        let strength = |i: usize| 2.0 * (legs[i][0] + tau * legs[(i + count - 1) % count][1]) / (1.0 + tau);
        (0..count).map(|i| s[i] - strength(i)).collect()
    }

    /// The strengths of a motion round a word with |s| ≤ S, if Newton's method finds one.
    pub fn orbit(&self, word: &[f64], bound: f64, start: f64) -> Option<Vec<f64>> {
        let mut s = vec![start * bound; word.len()];
        for _ in 0..40 {
            let wrong = self.wrong(word, &s);
            if wrong.iter().any(|x| !x.is_finite()) {
                return None;
            }
            if wrong.iter().all(|x| x.abs() < 1e-9) {
                let legs = self.velocities(word, &s);
                let fast = legs.iter().zip(&s).all(|([a, _], s)| *a > s / 2.0 + 1e-6);
                let clear = (0..word.len()).all(|i| {
                    let [t, place] = self.impact(s[i]);
                    let at = |k: f64| self.sign(k) * self.after([place, legs[i][0]], self.turn() * k - t)[0];
                    (1..word[i] as usize).all(|k| at(k as f64) > self.side)
                });
                return (fast && clear && s.iter().all(|s| s.abs() <= bound)).then_some(s);
            }
            let column = |i: usize| {
                let at = |by: f64| {
                    let mut moved = s.clone();
                    moved[i] += by;
                    self.wrong(word, &moved)
                };
                at(1e-6).iter().zip(at(-1e-6)).map(|(right, left)| (right - left) / 2e-6).collect()
            };
            let change = eliminate((0..s.len()).map(column).collect(), wrong)?;
            s.iter_mut().zip(change).for_each(|(s, change)| *s -= change);
        }
        None
    }
}

/// The text with the digest that belongs to its system.
pub fn resealed(text: &str) -> String {
    let Err(rejection) = answer(text) else { return text.to_string() };
    match rejection.to_string().split_once("which is ") {
        Some((_, digest)) => with(text, "digest", &format!("digest {digest}")),
        None => text.to_string(),
    }
}
