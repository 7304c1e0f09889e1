//! Certificates of kind parameter: what passes, what must be refused, and whether the machine is at the
//! depths that those say that pass, also the damaged ones: in floats, the least gap being looked for over a
//! period.

use std::f64::consts::TAU;

use crate::common::{
    NOTHING, PARAMETER, PARAMETER_ATTRACTOR, PARAMETER_CELLS, PARAMETER_FREQUENCY, PARAMETER_HERTZ,
    PARAMETER_MIRRORED, PARAMETER_SEVERAL, Random, answer, are_refused, damage, damaged_so_are_true, float,
    nth, rejected, resealed, second_reader, with,
};
use crate::samples::samples;
use grazing_check::parameter::{STATEMENT, STATEMENT_2};

const ALL: [&str; 7] = [
    PARAMETER,
    PARAMETER_SEVERAL,
    PARAMETER_FREQUENCY,
    PARAMETER_HERTZ,
    PARAMETER_MIRRORED,
    PARAMETER_ATTRACTOR,
    PARAMETER_CELLS,
];

/// The middle of a coefficient at p.
fn value(word: &str, p: f64) -> f64 {
    let middle = |text: &str| match text.split_once("..") {
        Some((lo, hi)) => f64::midpoint(float(lo), float(hi)),
        None => float(text),
    };
    let sum = |list: &str| list.split(',').rev().fold(0.0, |sum, text| sum * p + middle(text));
    let (above, below) = word.split_once('/').unwrap();
    sum(above) / sum(below)
}

/// The machine of a certificate at p: c, k, τ and σν, by the least gap of the motion without walls.
fn machine(text: &str, p: f64) -> [f64; 4] {
    let mut lines = text.lines().take_while(|line| !line.starts_with("parameter"));
    let mut next = |name: &str| -> Vec<String> {
        let line = lines.find(|line| line.starts_with(name)).unwrap();
        line.split(' ').skip(1).map(String::from).collect()
    };
    let [c, k, force] = ["damping", "stiffness", "force"].map(|name| value(&next(name)[0], p));
    let mut read = |count: &str| -> Vec<[f64; 3]> {
        let one = |words: Vec<String>| [words[0].parse().unwrap(), value(&words[1], p), value(&words[2], p)];
        (0..count.parse::<usize>().unwrap()).map(|_| one(next("harmonic"))).collect()
    };
    let count = text.lines().find_map(|line| line.strip_prefix("forcing ")).unwrap();
    let forcing = read(count);
    let walls = ["lower", "upper"].map(|side| {
        let own = |line: &&str| line.split(' ').next() == Some(side);
        let words: Vec<&str> = text.lines().find(own).unwrap().split(' ').skip(1).collect();
        (words[0] != "none").then(|| (value(words[0], p), value(words[1], p), read(words[2])))
    });
    let (sign, (place, tau, moves)) = match walls {
        [Some(lower), _] => (1.0, lower),
        [None, upper] => (-1.0, upper.unwrap()),
    };
    // (k − n² + i n c) z = a − i b for z e^{int}.
    let answer = |t: f64| -> f64 {
        let one = |&[n, a, b]: &[f64; 3]| {
            let (x, y) = (k - n * n, n * c);
            let size = x * x + y * y;
            let (re, im) = ((a * x - b * y) / size, (-b * x - a * y) / size);
            re * (n * t).cos() - im * (n * t).sin()
        };
        forcing.iter().map(one).sum()
    };
    let wall = |t: f64| -> f64 { moves.iter().map(|[n, a, b]| a * (n * t).cos() + b * (n * t).sin()).sum() };
    let moving = |t: f64| sign * (answer(t) - wall(t));
    let mean = sign * (if force == 0.0 { 0.0 } else { force / k } - place);
    const STEPS: usize = 2000;
    let at = |i: usize| TAU * i as f64 / STEPS as f64;
    let first = (0..STEPS).min_by(|&i, &j| moving(at(i)).total_cmp(&moving(at(j)))).unwrap();
    let (mut lo, mut hi) = (at(first) - TAU / STEPS as f64, at(first) + TAU / STEPS as f64);
    for _ in 0..80 {
        let (a, b) = (lo + (hi - lo) / 3.0, hi - (hi - lo) / 3.0);
        if moving(a) < moving(b) { hi = b } else { lo = a }
    }
    [c, k, tau, 1.0 + mean / moving(0.5 * (lo + hi))]
}

/// What is false of a certificate that is accepted, as floats see it.
fn lie(text: &str) -> Option<String> {
    let words = |name: &str| -> Vec<Vec<&str>> {
        let lines = text.lines().filter(|line| line.split(' ').next() == Some(name));
        lines.map(|line| line.split(' ').skip(1).collect()).collect()
    };
    let side: f64 = words("side").first().map_or(1.0, |side| float(side[0]));
    let ranges = ["damping", "stiffness", "restitution"].map(|name| {
        let line = words(name).into_iter().next_back().unwrap();
        [float(line[0]), float(line[1])]
    });
    let start = words("touch").first().map_or_else(|| float(words("from")[0][0]), |ends| float(ends[0]));
    // An attractor has a line of its own of that name.
    let both = |line: &Vec<&str>| (line.len() == 2).then(|| [float(line[0]), float(line[1])]);
    let depths: Vec<[f64; 2]> = words("depth").iter().filter_map(both).collect();
    let last = depths.last()?[1];
    // Before the touch, which may be anywhere in its interval, nu is below 0.
    let from = if words("touch").is_empty() { -1e-9 } else { f64::NEG_INFINITY };
    // A certificate with cells has a least depth.
    let least = words("depths").iter().find(|line| line.len() == 2).map(|line| float(line[0]));
    let mut before = least.unwrap_or(from);
    for i in 0..=40 {
        let p = start + (last - start) * f64::from(i) / 40.0;
        let found = machine(text, p);
        let nu = side * found[3];
        let most = depths.iter().find(|[_, end]| (end - p) * (last - start) >= 0.0)?[0];
        let inside = found[..3].iter().zip(ranges).all(|(x, [lo, hi])| lo - 1e-9 <= *x && *x <= hi + 1e-9);
        if nu < before - 1e-9 || nu > most + 1e-9 || !inside {
            return Some(format!("at {p}: {found:?}, before {before}, most {most}, ranges {ranges:?}"));
        }
        before = nu;
    }
    let touches = words("touch").first().is_none_or(|ends| {
        let [one, other] = [ends[0], ends[1]].map(|end| machine(text, float(end))[3]);
        one.min(other) < 1e-9 && one.max(other) > -1e-9
    });
    (!touches).then(|| "it does not touch there".into())
}

#[test]
fn what_is_written_passes_and_is_named() {
    let checked = answer(PARAMETER).unwrap();
    assert_eq!((checked.kind, checked.statement), ("parameter", STATEMENT));
    assert_eq!(answer(PARAMETER_HERTZ).unwrap().statement, STATEMENT_2);
    let said = checked.to_string();
    for part in [
        "proved, range of orbits",
        "parameter: for 0.64282434654 <= F < F*, the touch F* being the only one between 0.7071",
        "there: nu <= 1/10 for F >= 0.64282434654",
        "machine: q'' = -1/10 q' - 3/10 q + F cos t",
        "upper wall: 1, restitution 4/5",
        "depth: every nu with 0 < nu <= 1/10",
    ] {
        assert!(said.contains(part), "{part}: {said}");
    }
}

/// 1/(1 + ν) of the touch, which is at F = √½, is F at the depth ν before it.
#[test]
fn the_example_is_right_by_hand() {
    let [c, k, tau, depth] = machine(PARAMETER, 0.64282434654);
    assert_eq!([c, k, tau], [0.1, 0.3, 0.8]);
    assert!((depth + 0.1).abs() < 1e-10 && (0.5f64.sqrt() / 1.1 - 0.64282434654).abs() < 1e-11, "{depth}");
}

#[test]
fn weaker_claims_pass() {
    // A machine beyond its touch among those of a range.
    let (head, _) = PARAMETER.rsplit_once("\nkind ").unwrap();
    let among = with(NOTHING, "damping", "damping 99/1000 101/1000");
    let among = format!("{head}\n{}", among.split_once('\n').unwrap().1);
    for text in [
        nth(&among, "depth ", 0, "depth 1/5 0.88388"),
        nth(PARAMETER, "depth ", 0, "depth 1/10 0.65"),
        nth(PARAMETER, "depths ", 0, "depths 2\ndepth 1/20 0.68"),
        with(PARAMETER, "touch", "touch 0.70710678 0.70710679"),
        with(PARAMETER, "touch", "from 0.7071067"),
        with(PARAMETER, "pieces", "pieces 77"),
    ] {
        assert!(answer(&text).is_ok(), "{:?}: {text}", answer(&text));
        assert_eq!(lie(&text), None);
    }
}

/// False claims, with what is seen of them.
#[test]
fn forged_claims_are_refused() {
    let head = |start: &str, lines: &str| resealed(&with(PARAMETER, start, lines));
    let several = |start: &str, lines: &str| resealed(&with(PARAMETER_SEVERAL, start, lines));
    let mirrored = |start: &str, lines: &str| resealed(&with(PARAMETER_MIRRORED, start, lines));
    let (inner, orbit) = (PARAMETER.split_once("\nkind range").unwrap(), include_str!("data/orbit-4.txt"));
    let around = |other: &str, kind: &str| match kind {
        "" => format!("{}\n{}", inner.0, other.split_once('\n').unwrap().1),
        kind => format!("{}\nkind {kind}{other}", inner.0),
    };
    // A machine of one harmonic around an oscillator of two, no deeper than that is proved.
    let inside = PARAMETER_SEVERAL.rsplit_once("\nkind ").unwrap().1;
    let two = nth(&format!("{}\nkind {inside}", inner.0), "depth ", 0, "depth 1/50 0.7");
    let line = "harmonic 2 0/1 0,1/3\n";
    let third =
        PARAMETER_SEVERAL.replace(line, &format!("{line}harmonic 3 0,1/10000000000000000000000 0/1\n"));
    let third = resealed(&third.replace("forcing 2", "forcing 3"));
    // Both by a little, so that the top is still 1.
    let shifted = PARAMETER_SEVERAL
        .replace(
            "4862220235889/5000000000000 9724440471779/10000000000000",
            "486222023589/500000000000 9724440471781/10000000000000",
        )
        .replace(
            "275559528221/10000000000000 137779764111/5000000000000",
            "137779764109/5000000000000 275559528219/10000000000000",
        );
    let forged = [
        // One digit too far; a depth below the one there.
        (nth(PARAMETER, "depth ", 0, "depth 1/10 0.64282434653"), "(P4)"),
        (nth(PARAMETER, "depth ", 0, "depth 99/1000 0.64282434654"), "(P4)"),
        (nth(PARAMETER, "depth ", 0, "depth 1/10 -0.64282434654"), "(P2)"),
        // More than the certificate has.
        (nth(PARAMETER, "depth ", 0, "depth 1/9 0.637"), "does not go so deep (P4)"),
        // The touch is elsewhere: on either side, and on the far side of the depths.
        (with(PARAMETER, "touch", "touch 0.7071067812 0.7071067813"), "(P3)"),
        (with(PARAMETER, "touch", "touch 0.707106781 0.7071067811"), "(P3)"),
        (with(PARAMETER, "touch", "from 0.70710679"), "(P3)"),
        (nth(PARAMETER, "depth ", 0, "depth 1/10 0.75"), "(P2)"),
        // Of a certificate with a least depth: one digit too near, and from the touch on.
        (with(PARAMETER_CELLS, "from", "from 0.0079365"), "less than the certificate's least (P3)"),
        (with(PARAMETER_CELLS, "from", "touch -0.001 0.001"), "of no depths next to the touch (P3)"),
        (nth(PARAMETER_CELLS, "depth ", 0, "depth 1/126 0.008001"), "(P4)"),
        (nth(PARAMETER_CELLS, "depth ", 0, "depth 1/125 0.008001"), "does not go so deep (P4)"),
        // Another machine.
        (head("damping", "damping 101/1000"), "c, k or tau"),
        (head("stiffness", "stiffness 299/1000"), "c, k or tau"),
        (head("stiffness", "stiffness 3,1/10"), "c, k or tau"),
        (head("upper", "upper 1/1 79/100 0"), "c, k or tau"),
        (head("upper", "upper 11/10 4/5 0"), "(P3)"),
        (head("harmonic", "harmonic 1 0,1/1 1/10"), "(P3)"),
        (head("harmonic", "harmonic 2 0,1/1 0/1"), "several harmonics"),
        (head("force", "force 1/10"), "(P3)"),
        (head("lower none", "lower -2/1 4/5 0"), "the walls are not those"),
        (head("harmonic", "harmonic 0 0,1/1 0/1"), "M or H not be positive"),
        // Several harmonics: another top, or none; a form that changes; one more.
        (with(PARAMETER_SEVERAL, "top", "top none"), "several harmonics"),
        (with(PARAMETER_SEVERAL, "top", "top 0.1 0.2"), "no top of the wall"),
        (with(PARAMETER, "top", "top 3 3.1"), "(P1)"),
        (several("harmonic 2", "harmonic 2 0,0,1/4 0/1"), "may change with the parameter"),
        (several("stiffness", "stiffness 3,1/10"), "may change with the parameter"),
        // Walls that are no mirror images.
        (mirrored("upper", "upper 1001/1000 4/5 0"), "mirror images"),
        (mirrored("force", "force 1/1000"), "mirror images"),
        (mirrored("harmonic", "harmonic 2 0,1/1 0/1"), "mirror images"),
        (mirrored("upper", "upper 1/1 79/100 0"), "mirror images"),
        (mirrored("upper", "upper 1/1 4/5 1\nharmonic 1 1/1000 0/1"), "mirror images"),
        // The mean of the wall is on the other side, as far off; a motion that grows with the other sign.
        (head("upper", "upper -1/1 4/5 0"), "M or H not be positive"),
        (two.clone(), "not of one harmonic"),
        (with(PARAMETER_SEVERAL, "top", "top 2 4"), "no top of the wall"),
        (with(PARAMETER_SEVERAL, "top", "top 2.8853630863259576 2.8853630863259577"), "no top of the wall"),
        (third, "harmonic 3 may leave"),
        (shifted, "harmonic 1 may leave"),
        (with(PARAMETER, "side", "side 1"), ""),
        (
            around(PARAMETER_MIRRORED.split_once("\nkind range").unwrap().1, "range"),
            "the walls are not those",
        ),
    ];
    let malformed = [
        (around(orbit, ""), "expected the line kind of a certificate"),
        (around(PARAMETER, ""), "expected the line kind of a certificate"),
        (format!("{}\n", inner.0), "the file ends"),
    ];
    are_refused(&forged, &malformed);
    // What is claimed from inside the touch on is about no machine.
    assert!(rejected(&nth(PARAMETER, "depth ", 0, "depth 1/10 0.70710678118654752440")).contains("line"));
}

#[test]
fn what_is_accepted_of_damaged_certificates_is_true() {
    for (i, text) in ALL.into_iter().enumerate() {
        assert_eq!(lie(text), None);
        damaged_so_are_true((40 + i as u64, samples(60), samples::<usize>(60) / 1000), text, damage, lie);
    }
}

/// What is damaged in the head, with a digest that fits.
#[test]
fn two_readers_agree_on_damaged_heads() {
    let mut random = Random(7);
    let mut texts: Vec<String> = ALL.iter().map(|text| text.to_string()).collect();
    for text in ALL {
        let (head, inner) = text.rsplit_once("\nkind ").unwrap();
        for _ in 0..samples(3) {
            texts.push(resealed(&format!("{}kind {inner}", damage(&mut random, head))));
        }
    }
    let Some(verdicts) = second_reader("parameter.py", &texts) else { return };
    let mut accepted = 0;
    for (text, line) in texts.iter().zip(&verdicts) {
        let theirs = line.contains(": proved, ");
        let ours = answer(text);
        assert_eq!(ours.is_ok(), theirs, "{ours:?}, but {line}\n{text}");
        accepted += usize::from(theirs);
    }
    assert!(accepted >= ALL.len(), "{accepted}");
}
