//! Certificates of kind nothing: what passes, what must be refused, and whether motions do as those say that
//! pass, also the damaged ones: in floats, from the differential equation alone.

use crate::samples::{one_in, samples};
use std::f64::consts::TAU;

use crate::common::{
    NOTHING, NOTHING_MIRRORED, Random, Touching, answer, are_refused, damage, damaged_are_true, float, nth,
    second_reader, with,
};
use grazing_check::nothing::STATEMENT;

#[test]
fn what_is_written_passes_and_is_named() {
    let checked = answer(NOTHING).unwrap();
    assert_eq!((checked.kind, checked.range.clone(), checked.statement), ("nothing", None, STATEMENT));
    assert_eq!(
        checked.to_string(),
        "proved, nothing born
  motion: q'' = -c q' - k q above the wall nu - 1 + cos t, restitution tau
  damping: 1/10
  stiffness: 3/10
  restitution: 4/5
  depth: every nu with 0 < nu <= 1/5
  leaves: within 18 periods (N = 2, R = 2) every motion meets the wall elsewhere than within 1.2 of a multiple of 2 pi and at |g'| <= nu S/2
  S: 28.1 up to nu = 1/100, 9.1 up to nu = 1/20, 2.3 up to nu = 1/5"
    );
}

/// The same machine with another damping and stiffness.
fn machine(damping: &str, stiffness: &str, longest: u64) -> String {
    let text = with(NOTHING, "damping", &format!("damping {damping} {damping}"));
    let text = with(&text, "stiffness", &format!("stiffness {stiffness} {stiffness}"));
    let text = with(&text, "longest", &format!("longest {longest}"));
    let start = text.split("cells").next().unwrap();
    format!("{start}cells 1\ncell 1/1000 4 1\n")
}

#[test]
fn weaker_claims_pass() {
    for text in [
        nth(NOTHING, "cell ", 0, "cell 1/100 0.001 1"),
        nth(NOTHING, "cell ", 2, "cell 19/100 2.3 4"),
        with(NOTHING, "longest", "longest 3"),
        with(NOTHING, "rounds", "rounds 9"),
        with(NOTHING, "window", "window 1.5"),
        with(NOTHING, "damping", "damping 99/1000 1/10"),
        // There nothing is born either.
        machine("1/10", "7/25", 2),
        machine("1/5", "3/10", 2),
    ] {
        assert!(answer(&text).is_ok(), "{:?}: {text}", answer(&text));
    }
}

/// False claims, with what is seen of them.
fn forgeries() -> Vec<(String, &'static str)> {
    let mut all: Vec<(String, &'static str)> = Vec::new();
    let mut add = |reason: &'static str, texts: Vec<String>| {
        assert!(texts.len() >= 10, "{reason}: {}", texts.len());
        all.extend(texts.into_iter().map(|text| (text, reason)));
    };
    // Something is born: the paper's oscillator, and others with slow vibrations or fast ones.
    let born = [
        ("12/49", "100/2401", 6),
        ("1/10", "1/10", 5),
        ("1/10", "1/20", 8),
        ("1/10", "23/20", 4),
        ("1/100", "11/10", 9),
        ("1/5", "3/25", 5),
        ("1/20", "21/10", 4),
        ("1/50", "9/2", 6),
        ("3/10", "1/10", 6),
        ("1/10", "1/5", 3),
    ];
    add("something may be born (T)", born.iter().map(|(c, k, n)| machine(c, k, *n)).collect());
    let cells = |index: usize, lines: &[&str]| -> Vec<String> {
        lines.iter().map(|line| nth(NOTHING, "cell ", index, &format!("cell {line}"))).collect()
    };
    let mut legs = cells(2, &["1/5 2.6 2", "1/4 2.3 2", "1/5 3 64", "1/2 2 8", "1/5 4 4"]);
    legs.extend(cells(1, &["1/20 9.6 1", "3/50 9.1 1", "1/20 12 16"]));
    legs.extend([with(NOTHING, "rounds", "rounds 1"), nth(NOTHING, "cell ", 1, "cell 1/20 9.4 1")]);
    add("there may be a leg of", legs);
    let mut longer = cells(0, &["1/100 28.4 1", "1/100 30 64", "1/90 28.1 1", "1/100 60 1", "1/100 90 64"]);
    longer.push(with(NOTHING, "longest", "longest 1"));
    longer.extend(["7/25", "3/10", "29/100", "31/100"].map(|k| machine("1/10", k, 1)));
    add("a leg may be longer than", longer);
    let twice = cells(0, &["1/50 60 1", "1/50 70 1", "1/1000 700 1", "1/1000 800 8"]);
    let twice = twice.into_iter().chain(cells(1, &["1/20 25 64", "1/20 30 1", "1/20 35 1"]));
    let twice = twice.chain(cells(2, &["1/5 7 1", "1/5 8 64", "1/2 3 1"]));
    add("there may be two contacts in one window", twice.collect());
    let outside = cells(0, &["1/100 200 1", "1/40 100 1", "1/1000 2000 1", "1/100 1000 64"]).into_iter();
    let outside = outside.chain(cells(2, &["1/5 10 1", "1/5 20 1", "1/5 32767 1", "1/1 2 1"]));
    let narrow = ["0.1", "0.2"].map(|window| with(NOTHING, "window", &format!("window {window}")));
    add("outside the window", outside.chain(narrow).collect());
    all
}

/// The same for what is seen without any condition: the form.
fn malformed() -> Vec<(String, &'static str)> {
    let lines = [
        ("kind", "kind nothing 3", "expected a line"),
        ("statement", "statement No motion stays near.", "word for word"),
        ("damping", "damping 2/20 2/20", "lowest terms"),
        ("damping", "damping 1/10 1/20", "must not decrease"),
        ("restitution", "restitution 0/1 4/5", "positive"),
        ("harmonics", "side 1\nharmonics 1", "harmonics"),
        ("harmonic ", "harmonic 1 1/2 2/3 0/1 0/1", "sum to 1"),
        ("window", "window 0", "positive"),
        ("pieces", "pieces 0", "at least 1"),
        ("pieces", "pieces 1001", "1000"),
        ("longest", "longest 0", "at least 1"),
        ("longest", "longest 101", "100"),
        ("rounds", "rounds 0", "at least 1"),
        ("rounds", "rounds 101", "100"),
        ("cells", "cells 0", "at least 1"),
        ("cells", "cells 2", "goes on"),
        ("cells", "cells 4", "the file ends"),
        ("cell ", "cell 0/1 28.1 1", "increase, from 0"),
        ("cell ", "cell -1/100 28.1 1", "increase, from 0"),
        ("cell ", "cell 1/20 5 1", "increase, from 0"),
        ("cell ", "cell 1/100 0 1", "positive"),
        ("cell ", "cell 1/100 -1 1", "positive"),
        ("cell ", "cell 1/100 28.10 1", "decimal"),
        ("cell ", "cell 1/100 28.1 0", "at least 1 part"),
        ("cell ", "cell 1/100 28.1 65", "64"),
        ("cell ", "cell 1/100 28.1", "expected"),
        ("cell ", "cell 1/100 28.1 1 1", "unexpected"),
    ];
    let change = |(start, line, reason)| (with(NOTHING, start, line), reason);
    let mut all: Vec<(String, &'static str)> = lines.into_iter().map(change).collect();
    let costly = with(&with(NOTHING, "longest", "longest 100"), "rounds", "rounds 100");
    all.push((costly, "exponentials"));
    all.push((with(NOTHING, "kind", "kind range"), "word for word"));
    all
}

#[test]
fn forgeries_are_refused() {
    are_refused(&forgeries(), &malformed());
}

/// The reader in Python, written from the form and the theorem alone, gives the same verdicts.
#[test]
fn two_readers_agree() {
    let right =
        [NOTHING.to_string(), nth(NOTHING, "cell ", 2, "cell 19/100 2.3 4"), machine("1/5", "3/10", 2)];
    let wrong = forgeries().into_iter().chain(malformed()).map(|(text, _)| text).step_by(one_in(8));
    let mut random = Random(7);
    let damaged = (0..samples::<usize>(30)).map(|_| damage(&mut random, NOTHING));
    let all: Vec<String> = right.into_iter().chain(wrong).chain(damaged).collect();
    let Some(verdicts) = second_reader("nothing.py", &all) else { return };
    let mut accepted = 0;
    for (text, line) in all.iter().zip(&verdicts) {
        let ours = answer(text);
        accepted += usize::from(ours.is_ok());
        assert_eq!(ours.is_ok(), line.ends_with(": proved, nothing born"), "{ours:?}, {line}\n{text}");
    }
    assert!(accepted > samples(3), "{accepted}");
}

/// A certificate's numbers, its one harmonic being a cosine.
struct Claim {
    mirrored: bool,
    /// c, k, τ, at both ends of their ranges.
    parameters: [[f64; 3]; 2],
    order: f64,
    window: f64,
    longest: f64,
    rounds: f64,
    /// Least and greatest ν, and S.
    cells: Vec<[f64; 3]>,
}

impl Claim {
    fn of(text: &str) -> Claim {
        let named = |name: &str| -> Vec<Vec<f64>> {
            let rest = |line: &str| -> Option<Vec<f64>> {
                Some(line.strip_prefix(name)?.strip_prefix(' ')?.split(' ').map(float).collect())
            };
            text.lines().filter_map(rest).collect()
        };
        let one = |name: &str| named(name)[0].clone();
        let [c, k, tau] = ["damping", "stiffness", "restitution"].map(one);
        let cells = named("cell");
        let from = |i: usize| if i == 0 { 0.0 } else { cells[i - 1][0] };
        Claim {
            mirrored: text.contains("kind nothing 2\n"),
            parameters: [0, 1].map(|end| [c[end], k[end], tau[end]]),
            order: one("harmonic")[0],
            window: one("window")[0],
            longest: one("longest")[0],
            rounds: one("rounds")[0],
            cells: (0..cells.len()).map(|i| [from(i), cells[i][0], cells[i][1]]).collect(),
        }
    }
}

/// What is looked at in motions.
trait Motions {
    fn wall(&self, t: f64) -> [f64; 2];
    fn gap(&self, q: f64, t: f64) -> f64;
    fn stays(&self, start: [f64; 2], t: f64, zone: [f64; 2], periods: f64) -> Option<f64>;
}

impl Motions for Touching {
    /// The wall and its velocity.
    fn wall(&self, t: f64) -> [f64; 2] {
        let (sin, cos) = (self.order * t).sin_cos();
        [self.depth - 1.0 + cos, -self.order * sin]
    }

    /// To the wall, or the nearer of two.
    fn gap(&self, q: f64, t: f64) -> f64 {
        let gap = q - self.wall(t)[0];
        if self.mirrored { gap.min(-q - self.wall(t - self.turn())[0]) } else { gap }
    }

    /// For how many periods, or half periods, a motion stays near: all its contacts at most `window` from a
    /// multiple of 2π, and where the wall's speed is at most `slow`. None where it comes to rest on the wall,
    /// near.
    fn stays(
        &self,
        [mut q, mut u]: [f64; 2],
        mut t: f64,
        [window, slow]: [f64; 2],
        periods: f64,
    ) -> Option<f64> {
        let (begin, long) = (t, TAU / (256.0 * self.order));
        let (turn, mut contacts, mut late) = (self.turn(), 0, 0.0);
        while t + late < begin + turn * periods {
            // At its top a wall is beyond rest for a short time only.
            let top = (self.order * t + 0.2).rem_euclid(turn) < 0.4;
            let step = if top { long.min(0.05 * self.depth.sqrt() / self.order) } else { long };
            let [next, velocity] = self.after([q, u], step);
            if self.gap(next, t + step) > 0.0 {
                [q, u, t] = [next, velocity, t + step];
                continue;
            }
            let (mut lo, mut hi) = (0.0, step);
            for _ in 0..60 {
                let middle = (lo + hi) / 2.0;
                if self.gap(self.after([q, u], middle)[0], t + middle) > 0.0 {
                    lo = middle
                } else {
                    hi = middle
                }
            }
            [q, u] = self.after([q, u], lo);
            t += lo;
            if q - self.wall(t)[0] > self.gap(q, t) {
                // It is the other wall: seen in the mirror the lower one, half a period before.
                [q, u, t, late] = [-q, -u, t - turn, late + turn];
            }
            let [_, velocity] = self.wall(t);
            let phase = (t + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0;
            if phase.abs() > window || velocity.abs() > slow {
                return Some((t + late - begin) / turn);
            }
            contacts += 1;
            if contacts > 200 || velocity - u < 1e-9 {
                return None;
            }
            u = velocity + self.parameters[2] * (velocity - u);
        }
        Some(periods)
    }
}

/// What is false about a certificate, as far as floats, short words and some motions tell.
fn lie(text: &str, motions: usize) -> Option<String> {
    let claim = Claim::of(text);
    let mut random = Random(5);
    let periods = (2.0 * claim.rounds + 2.0) * (claim.longest + 1.0);
    let lengths: Vec<f64> = (1..=claim.longest as usize).map(|n| n as f64).collect();
    for [least, greatest, strength] in &claim.cells {
        for share in [0.01, 0.5, 1.0] {
            let depth = least + share * (greatest - least);
            for parameters in claim.parameters {
                let (mirrored, order) = (claim.mirrored, claim.order);
                let at = Touching { mirrored, parameters, side: 1.0, order, depth };
                for &n in &lengths {
                    let words = lengths.iter().map(|&m| vec![n, m]).chain([vec![n]]);
                    for word in words {
                        if [-0.5, -0.1, 0.1, 0.5]
                            .iter()
                            .any(|&start| at.orbit(&word, *strength, start).is_some())
                        {
                            return Some(format!("an orbit {word:?} at depth {depth}"));
                        }
                    }
                }
                for _ in 0..motions {
                    // Near the wall's top, or anywhere.
                    let size = if random.below(2) == 0 { depth } else { 1.0 };
                    let t = (random.part() - 0.5) * if size < 1.0 { 0.2 } else { TAU };
                    let q = at.wall(t)[0].max(0.0) + size * random.part();
                    if at.gap(q, t) < 0.0 {
                        continue;
                    }
                    let u = 4.0 * size * (random.part() - 0.5);
                    let zone = [claim.window, depth * strength / 2.0];
                    if let Some(stayed) = at.stays([q, u], t, zone, periods + 1.0)
                        && stayed > periods
                    {
                        return Some(format!("a motion stays for {stayed} periods at depth {depth}"));
                    }
                }
            }
        }
    }
    None
}

/// GRAZING_SAMPLES times as many of them.
#[test]
fn what_is_accepted_of_damaged_certificates_is_true() {
    for (seed, text) in [(4, NOTHING), (5, NOTHING_MIRRORED)] {
        assert_eq!(lie(text, 100), None);
        damaged_are_true(seed, samples::<usize>(400), text, |text| lie(text, 2));
    }
}

/// The floats see what is false: something that is born, and a time that is too short.
#[test]
fn floats_notice_lies() {
    for (c, k, n) in [("12/49", "100/2401", 6), ("1/10", "1/20", 8), ("1/5", "3/25", 5)] {
        let found =
            lie(&with(&machine(c, k, n), "restitution", "restitution 1/1 1/1"), 0).unwrap_or_default();
        assert!(found.contains("an orbit"), "{c} {k}: {found}");
    }
    let short = with(&with(NOTHING, "longest", "longest 0"), "rounds", "rounds 0");
    let wide = nth(&short, "cell ", 2, "cell 1/5 9 2");
    let found = lie(&wide, 300).unwrap_or_default();
    assert!(found.contains("a motion stays"), "{found}");
}
