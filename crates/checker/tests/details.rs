//! Whatever is printed of a certificate is part of what is checked. Every word of a sample of every kind is
//! changed, in several ways, also with a digest that fits; whatever is still accepted must be called by the
//! same name, and
//!
//! - a word whose change is seen in what is printed must be one that is checked: another change of the same
//!   word is refused as false, or as not going with other lines;
//! - what is printed then must be true still: the orbit, or the word, that the sample is of has not gone.
//!
//! So nothing is printed that a forger is free to choose, but a parameter's name. And the other way round:
//! what is claimed is printed. A word whose change is accepted and changes no print must say how it is
//! proved, not what.

use std::{
    collections::BTreeMap,
    f64::consts::{PI, TAU},
    thread,
};

use crate::common::{
    ATTRACTOR, ATTRACTOR_CELLS, ATTRACTOR_SEVERAL, BRANCH, CHAOS_12, CHAOS_MIRRORED_BEFORE, COVER, ENTROPY,
    FREE, FREE_MACHINE, GRAZING, NOTHING, NOTHING_MIRRORED, ORBIT_4, PARAMETER, PARAMETER_HERTZ, RANGE_1,
    RANGE_ALONE, RANGE_MIRRORED, RANGE_MIRRORED_BEYOND, SADDLE_NODE, SHARE, SHARE_POLAR, SINGLE_1,
    SINGLE_MIRRORED_1, THEOREM2, WORD, WORD_BY_THEOREM, answer, first_cells, float, resealed, with,
};
use crate::share::is_likely;
use grazing_check::{Checked, Rejection, kinds};

const RESPONSE: &str = include_str!("data/event-response.txt");
const RANGES: &str = include_str!("data/orbit-4-range.txt");
const BALL: &str = include_str!("data/machine-ball.txt");

/// Of every kind a sample: proofs about periods, about one orbit, about all paths of a graph.
fn samples() -> [Vec<String>; 3] {
    let few = with(CHAOS_12, "depth", "depth 0/1 3/1003");
    let owned = |texts: &[&str]| texts.iter().map(|text| text.to_string()).collect::<Vec<_>>();
    // One of the ball's multipliers is outside the unit circle, as `machine.rs` has it.
    let ball = with(BALL, "orbit", "orbit 1 unstable");
    [
        owned(&[THEOREM2, COVER, WORD, WORD_BY_THEOREM, ENTROPY, SHARE, SHARE_POLAR]),
        owned(&[
            ORBIT_4,
            RANGES,
            SADDLE_NODE,
            GRAZING,
            RESPONSE,
            &ball,
            FREE,
            FREE_MACHINE,
            &first_cells(BRANCH, 1),
        ]),
        owned(&[
            RANGE_1,
            RANGE_ALONE,
            PARAMETER,
            PARAMETER_HERTZ,
            NOTHING,
            ATTRACTOR,
            ATTRACTOR_SEVERAL,
            ATTRACTOR_CELLS,
            SINGLE_1,
            &first_cells(RANGE_MIRRORED, 1),
            &first_cells(RANGE_MIRRORED_BEYOND, 1),
            NOTHING_MIRRORED,
            SINGLE_MIRRORED_1,
            CHAOS_12,
            CHAOS_MIRRORED_BEFORE,
            &with(&few, "complete", "complete 2 4 2 3"),
        ]),
    ]
}

/// Other words in place of this one.
fn others(word: &str) -> Vec<String> {
    let mut all: Vec<String> = match word {
        "+" => vec!["-".into()],
        "-" => vec!["+".into()],
        "U" => vec!["D".into()],
        "D" => vec!["U".into()],
        "lower" => vec!["upper".into()],
        "stable" | "unstable" | "open" => ["stable", "unstable", "open"].map(String::from).into(),
        "saddle-node" | "flip" | "grazing" => ["saddle-node", "flip", "grazing"].map(String::from).into(),
        "singular" => vec!["boundary".into()],
        _ => Vec::new(),
    };
    if !word.bytes().any(|byte| byte.is_ascii_digit()) {
        all.push(format!("{word}x"));
        return all;
    }
    // One more in each of the first digits, and in the last; with another sign, and far off.
    let digits: Vec<_> = word.bytes().enumerate().filter(|(_, byte)| byte.is_ascii_digit()).collect();
    for &(at, byte) in digits.iter().take(3).chain(digits[3.min(digits.len())..].last()) {
        let next = char::from(b'0' + (byte - b'0' + 1) % 10).to_string();
        all.push(format!("{}{next}{}", &word[..at], &word[at + 1..]));
    }
    all.push(match word.strip_prefix('-') {
        Some(rest) => rest.to_string(),
        None => format!("-{word}"),
    });
    // A fraction nearer to 1.
    if let Some((p, q)) =
        word.split_once('/').and_then(|(p, q)| p.parse::<u64>().ok().zip(q.parse::<u64>().ok()))
    {
        all.push(format!("{}/{}", p + 3 * q, 4 * q));
        // And one much nearer to 0.
        all.push(format!("1/{}", 1007 * q));
    }
    all.extend([format!("9{word}"), format!("{word}7"), word[..word.len() - 1].to_string()]);
    all.extend(["0", "1", "77", "0/1", "1/3", "0.000001", "0.5", "1.00000000001"].map(String::from));
    all
}

fn detail<'a>(checked: &'a Checked, name: &str) -> &'a str {
    checked.detail.iter().find(|(known, _)| *known == name).map_or("", |(_, value)| value)
}

/// All decimals of a text.
fn numbers(text: &str) -> Vec<f64> {
    let parts = text.split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-'));
    parts.filter_map(|part| part.trim_end_matches('.').parse().ok()).collect()
}

/// A box printed is about the listed numbers, and the true ones are those of the sample: in its box, or
/// beside it by rounding, as a list that is nearer to them than it says may be wrong by that.
fn keeps_the_orbit(sample: &Checked, changed: &Checked) -> bool {
    if detail(sample, "box").is_empty() {
        // Without impacts nothing is listed of it; in `free.rs` a second reader decides.
        return detail(sample, "pattern").starts_with("no impact") && detail(changed, "box").is_empty();
    }
    let within = |checked: &Checked| {
        let [.., radius] = numbers(detail(checked, "box"))[..] else { panic!("{checked}") };
        radius
    };
    let slack = within(sample) + within(changed) * 1.000001 + 1e-12;
    ["phases", "speeds", "displacements", "velocities", "parameter", "contact"].iter().all(|name| {
        let (old, new) = (numbers(detail(sample, name)), numbers(detail(changed, name)));
        // Phases are modulo the period; of a contact, too, where no impact comes before it.
        let phase = *name == "phases" || detail(sample, name).contains("at phase");
        let apart = |old: f64, new: f64| match phase {
            true => (old - new + PI).rem_euclid(TAU) - PI,
            false => old - new,
        };
        old.len() == new.len() && old.iter().zip(&new).all(|(old, new)| apart(*old, *new).abs() <= slack)
    })
}

/// The periods and letters of the word at a₁, a₂, from the definitions, in floats.
fn word_there(a1: f64, a2: f64, positive: bool, last: usize) -> (Vec<usize>, String) {
    let mut u = vec![0.0, 1.0];
    for k in 1..=last {
        u.push(a1 * u[k] - a2 * u[k - 1]);
    }
    let b = |n: usize, k: usize| (u[n] - u[k] - a2.powi(k as i32) * u[n - k]) / u[n];
    let occurs = |&n: &usize| (1..n).all(|k| (b(n, k) > 0.0) == positive);
    let periods: Vec<usize> = (1..=last).filter(occurs).collect();
    let letter = |&n: &usize| {
        let (p, q) = ((u[n + 1] - 1.0) / u[n], (a2.powi(n as i32) + a2 * u[n - 1]) / u[n]);
        if p > q { 'U' } else { 'D' }
    };
    let word = periods.iter().map(letter).collect();
    (periods, word)
}

fn fraction(text: &str) -> f64 {
    let (p, q) = text.split_once('/').unwrap_or((text, "1"));
    p.parse::<f64>().unwrap() / q.parse::<f64>().unwrap()
}

/// Whether the word printed for either sign is that of the place printed.
fn is_the_word(checked: &Checked) -> bool {
    let place: Vec<f64> = detail(checked, "point")
        .split(", ")
        .map(|part| fraction(part.split_once(" = ").unwrap().1))
        .collect();
    let (a1, a2) = match detail(checked, "point").starts_with('r') {
        // r e^{±2πis}: the sum of the eigenvalues and their product.
        true => (2.0 * place[0] * (TAU * place[1]).cos(), place[0] * place[0]),
        false => (place[0], place[1]),
    };
    checked.detail.iter().filter(|(name, _)| name.starts_with("e mu")).all(|(name, said)| {
        let (periods, word) = word_there(a1, a2, name.ends_with("> 0"), 12);
        // What is decided, of the twelve.
        let decided = said.split_once("decided for 1 to ").map_or(12, |(_, rest)| numbers(rest)[0] as usize);
        let (listed, letters): (Vec<String>, String) = periods
            .iter()
            .zip(word.chars())
            .filter(|(n, _)| **n <= decided)
            .map(|(n, letter)| (n.to_string(), letter))
            .unzip();
        said.starts_with(&format!("word {letters}, periods {};", listed.join(", ")))
    })
}

/// Whether the roots lie between the bounds printed, and the bounds of words are as many.
fn has_the_roots(sample: &Checked, changed: &Checked) -> bool {
    let roots = [0.543_689_012_692_076_4, 0.637_382_658_446_787_1];
    sample.detail.iter().zip(&changed.detail).zip(roots).all(|(((name, old), (same, new)), root)| {
        let (bounds, words) = new.split_once("; ").unwrap();
        let (low, high) = bounds.split_once(" < z < ").unwrap();
        name == same && old.ends_with(words) && fraction(low) < root && root < fraction(high)
    })
}

/// The paper's oscillator for ν → 0, where the velocities of a leg of T are a = (1 − E₁₁)/E₁₂ and E₂₁ + E₂₂
/// a: those of letters, the place that is passed on the way, the rate of {1, 2}, and the letters' boxes.
fn is_the_horseshoe(checked: &Checked) -> bool {
    let (c, k) = (12.0 / 49.0, 100.0 / 2401.0f64);
    let omega = (k - c * c / 4.0f64).sqrt();
    let flow = |t: f64| {
        let decay = (-c * t / 2.0).exp();
        let b = decay * (omega * t).sin() / omega;
        let a = decay * (omega * t).cos() + c / 2.0 * b;
        [a, b, -k * b, a - c * b]
    };
    let mut highest: f64 = 0.0;
    let letters: Vec<&str> = detail(checked, "letters").split("; ").collect();
    let boxes = (1..).zip(&letters).all(|(n, letter)| {
        let time = f64::from(n) * TAU;
        let e = flow(time);
        let a = (1.0 - e[0]) / e[1];
        let p = e[2] + e[3] * a;
        for i in 0..1000 {
            let e = flow(time * f64::from(i) / 1000.0);
            highest = highest.max(e[0] + e[1] * a);
        }
        let said = numbers(letter.split_once("velocity/nu").unwrap().1);
        said[0] < a && a < said[1] && said[2] < p && p < said[3]
    });
    let rates = numbers(detail(checked, "entropy"));
    let golden = (1.0 + 5f64.sqrt()) / 2.0;
    let of_two = letters.len() == 2 && letters.iter().all(|letter| letter.ends_with("then 1 or 2"));
    let reach = numbers(detail(checked, "reach"))[0];
    let contraction = numbers(detail(checked, "contraction"))[0];
    boxes && of_two && rates[0] <= golden && golden <= rates[1] && reach > highest && contraction < 1.0
}

/// A machine's orbit of one period near its touch: at a phase t it has ν = σ sin t (tan(t/2) − 2/κ), s =
/// σκ/(1 − (κ/2) tan(t/2)), which are within what is printed; σκ > 0 of those tried, so that t < 0.
fn is_born(checked: &Checked) -> bool {
    let middle = |name: &str| {
        let ends: Vec<f64> = detail(checked, name)
            .split(' ')
            .filter(|w| w.starts_with(|c: char| c.is_ascii_digit()))
            .map(float)
            .collect();
        ends.iter().sum::<f64>() / ends.len() as f64
    };
    let [c, k, tau] = ["damping", "stiffness", "restitution"].map(middle);
    let omega = (k - c * c / 4.0f64).sqrt();
    // Of half a period, with the mirror after it, between mirrored walls.
    let (time, sign) = if detail(checked, "motion").contains("mirror") { (PI, -1.0) } else { (TAU, 1.0) };
    let decay = sign * (-c * time / 2.0).exp();
    let b = decay * (omega * time).sin() / omega;
    let a = decay * (omega * time).cos() + c / 2.0 * b;
    let alpha = (1.0 - a) / b;
    let kappa = 2.0 * (alpha + tau * (-k * b + (a - c * b) * alpha)) / (1.0 + tau);
    let side = if detail(checked, "motion").contains("wall -nu") { -1.0 } else { 1.0 };
    let depth = fraction(detail(checked, "depth").split("nu <= ").nth(1).unwrap().split(',').next().unwrap());
    let said = numbers(detail(checked, "impacts").split_once("1: from").unwrap().1);
    // From the touch to that depth, which the curve reaches before its fold.
    let (mut inside, mut nu) = (true, 0.0);
    for i in 1..10_000 {
        let t = -f64::from(i) * 1e-4;
        let before = nu;
        nu = side * t.sin() * ((t / 2.0).tan() - 2.0 / kappa);
        if nu > depth || nu <= before {
            break;
        }
        let s = side * kappa / (1.0 - kappa / 2.0 * (t / 2.0).tan());
        inside &= said[0] < s && s < said[1];
    }
    inside && nu > depth && numbers(detail(checked, "contraction"))[0] < 1.0
}

/// Whether what is printed after a change follows from what the sample is known to be.
fn follows(sample: &Checked, changed: &Checked, mirrored: bool) -> bool {
    match sample.kind {
        "theorem2" => changed.detail.is_empty() && changed.range == sample.range,
        // Least and most; what is covered up to there is covered up to less.
        "cover" => {
            let ends = |checked| {
                let parts = detail(checked, "r_max").split(' ').filter(|word| word.contains('/'));
                let last = |part: &str| part.starts_with(|c: char| c.is_ascii_digit());
                parts.filter(|part| last(part) && !part.contains('n')).map(fraction).collect::<Vec<f64>>()
            };
            let (new, old) = (ends(changed), ends(sample));
            old.len() == 2 && new.len() == 2 && new.iter().zip(&old).all(|(new, old)| new <= old)
        }
        "word" | "word-by-theorem" => is_the_word(changed),
        // Whether it is so in every part is looked at in `share.rs`.
        "share" => is_likely(changed),
        "entropy" => has_the_roots(sample, changed),
        "orbit" | "machine-orbit" => {
            let stability = detail(changed, "stability");
            let known = stability == detail(sample, "stability") || stability.starts_with("open");
            known
                && detail(changed, "pattern") == detail(sample, "pattern")
                && keeps_the_orbit(sample, changed)
        }
        "event" => {
            let word = |checked| detail(checked, "event").split(':').next().unwrap_or_default().to_string();
            let same =
                word(changed) == word(sample) && detail(changed, "pattern") == detail(sample, "pattern");
            same && keeps_the_orbit(sample, changed)
        }
        "chaos" => {
            let branches = numbers(detail(changed, "entropy"))[0] > 1.0;
            let title = if branches { "chaos" } else { "orbits" };
            let others = |checked| detail(checked, "others").starts_with("none near");
            // Between walls the damage tests hold the rest against floats.
            let right = mirrored || is_the_horseshoe(changed);
            changed.title == title && right && others(changed) <= others(sample)
        }
        "range" => {
            let same = ["motion", "letters"];
            let same = same.iter().all(|name| detail(changed, name) == detail(sample, name));
            // Of chaos less may be said: orbits.
            let claim = detail(changed, "claim");
            let chaos = claim.starts_with("chaos");
            let title = if chaos { "range of chaos" } else { "range of orbits" };
            let same = same && changed.title == title && (claim == detail(sample, "claim") || !chaos);
            // Whether there are others is looked at in `range_damage.rs`.
            let others = |checked| detail(checked, "others").starts_with("none near");
            same && others(changed) <= others(sample) && is_born(changed)
        }
        // Whether motions do so is looked at in `nothing.rs` and in `attractor.rs`.
        "nothing" | "attractor" => {
            changed.title == sample.title
                && detail(changed, "motion").split(" + ").next()
                    == detail(sample, "motion").split(" + ").next()
        }
        // Whether the orbit is there, and stable, is looked at in `branch.rs`.
        "branch" => {
            let word =
                |checked| detail(checked, "stability").split(' ').next().unwrap_or_default().to_string();
            let ends = |checked| numbers(detail(checked, "parameter"));
            let ([from, to, ..], [new_from, new_to, ..]) = (&ends(sample)[..], &ends(changed)[..]) else {
                panic!("{changed}")
            };
            let room = to - from;
            detail(changed, "pattern") == detail(sample, "pattern")
                && (word(changed) == word(sample) || word(changed) == "open")
                && from - room < *new_from
                && *new_to < to + room
        }
        // Whether the machine is at these depths is looked at in `parameter.rs`.
        "parameter" => {
            let same = ["motion", "letters", "machine", "lower wall"];
            // A parameter may be called otherwise.
            let same =
                same.iter().all(|name| detail(changed, name).replace("Fx", "F") == detail(sample, name));
            let born = || changed.title != "range of orbits" || is_born(changed);
            same && changed.title == sample.title && born()
        }
        // Whether the orbit is there, and stable, is looked at in `single.rs`.
        "single" => {
            let same = ["motion", "orbit"];
            let word =
                |checked| detail(checked, "stability").split(' ').next().unwrap_or_default().to_string();
            same.iter().all(|name| {
                let start =
                    |checked| detail(checked, name).split(" + ").next().unwrap_or_default().to_string();
                start(changed) == start(sample)
            }) && (word(changed) == word(sample) || word(changed) == "open")
        }
        kind => panic!("a kind without a rule here: {kind}"),
    }
}

/// What became of a word.
#[derive(Default)]
struct Fate {
    /// A change that is printed, if one is accepted.
    printed: Option<String>,
    /// A change that is accepted and not printed, if there is one.
    silent: Option<String>,
    /// Whether a change was refused as false, or as not going with other lines.
    refused: bool,
}

/// Changes one word in `every` of the sample, GRAZING_SAMPLES times as many; what is accepted follows.
fn fates(text: &str, every: usize) -> BTreeMap<(usize, usize), Fate> {
    let every = every.div_ceil(crate::samples::samples(1));
    let sample = answer(text).unwrap_or_else(|why| panic!("{why}"));
    let lines: Vec<&str> = text.lines().collect();
    let mut all: BTreeMap<(usize, usize), Fate> = BTreeMap::new();
    let mut alike: BTreeMap<&str, usize> = BTreeMap::new();
    for (i, line) in lines.iter().enumerate() {
        // Of many lines of one name the first few do, and then one in nine; in a sample of trials, in 45.
        let name = line.split(' ').next().unwrap();
        let count = alike.entry(name).or_default();
        *count += 1;
        let next = if crate::samples::samples::<usize>(1) < 10 { 45 } else { 9 };
        if (*count > 3 && !count.is_multiple_of(next)) || name == "statement" || name == "digest" {
            continue;
        }
        let words: Vec<&str> = line.split(' ').collect();
        for (j, word) in words.iter().enumerate().filter(|(j, _)| (i + j) % every == 0) {
            let fate = all.entry((i, j)).or_default();
            // Nine tenths of the way to the number before and after: of a range, almost all of it is gone.
            let nearer = |beside: Option<&&str>| -> Option<String> {
                let (own, beside): (f64, f64) = (word.parse().ok()?, beside?.parse().ok()?);
                let text = format!("{:.12}", beside + 0.1 * (own - beside));
                word.contains('.').then(|| text.trim_end_matches('0').trim_end_matches('.').to_string())
            };
            let near = [j.checked_sub(1).and_then(|j| nearer(words.get(j))), nearer(words.get(j + 1))];
            let changes = others(word).into_iter().chain(near.into_iter().flatten());
            for other in changes.filter(|other| other != word) {
                let mut changed = words.clone();
                changed[j] = &other;
                let changed = changed.join(" ");
                let mut lines = lines.clone();
                lines[i] = &changed;
                let forged = lines.join("\n") + "\n";
                let sealed = resealed(&forged);
                // Another system than that of the digest is refused, though some coefficients decide nothing.
                fate.refused |= sealed != forged;
                match answer(&sealed) {
                    Err(Rejection::False { .. }) => fate.refused = true,
                    // The word itself is well formed, and other lines do not go with it.
                    Err(Rejection::Malformed { line, .. }) if line != i as u64 + 1 => fate.refused = true,
                    Err(_) => {}
                    Ok(checked) if checked == sample => fate.silent = Some(changed),
                    Ok(checked) => {
                        let mirrored = text.contains("\nkind chaos 4\n");
                        assert!(follows(&sample, &checked, mirrored), "{line} -> {changed}: {checked}");
                        if (&checked.title, &checked.range, &checked.detail)
                            != (&sample.title, &sample.range, &sample.detail)
                        {
                            fate.printed = Some(changed);
                        } else {
                            fate.silent = Some(changed);
                        }
                    }
                }
            }
        }
    }
    all
}

/// Whatever is printed of these is checked, one word in `every`, each text by a thread of its own.
fn printed_is_checked(samples: &[String], every: usize, least: usize) {
    let checked: usize = thread::scope(|scope| {
        let all: Vec<_> = samples.iter().map(|text| scope.spawn(|| printed_of(text, every))).collect();
        all.into_iter().map(|one| one.join().unwrap()).sum()
    });
    assert!(checked > least, "only {checked} words are checked");
}

/// Whether a word of a line says how a thing is proved and not what, so that nothing that is printed need
/// change with it: in how many parts, where cells meet, by which matrices, weights and witnesses. All other
/// words are claims. Of cells what they have in common is printed, and that each lists its own.
fn is_work(lines: &[&str], line: usize, word: usize) -> bool {
    let own = lines[line];
    let name = own.split(' ').next().unwrap();
    // Of a certificate in another its own kind.
    let kind = lines[..=line].iter().rev().find_map(|line| line.strip_prefix("kind ")).unwrap_or("");
    let is_last = || !lines[line + 1..].iter().any(|other| other.split(' ').next() == Some(name));
    match (kind.split(' ').next().unwrap(), name) {
        (_, "pieces" | "row" | "flight" | "until") => true,
        // All j b together being 0, the b of one harmonic is 0 whatever its range.
        (_, "harmonic") => own.starts_with("harmonic 1 1/1 1/1 0/1 ") && is_last(),
        ("theorem2", "stretch") | ("word", "absent") => true,
        ("theorem2", "point") => word > 2,
        ("cover", _) => own.contains([';', ',']),
        ("share", name) => name.starts_with(|c: char| c.is_ascii_digit()),
        ("entropy", "bound" | "ends") | ("branch", "at" | "radius") | ("chaos", "cells") => true,
        // Of version 2 the units in which powers of the flow shrink.
        ("machine-orbit", "scales") => kind.ends_with(" 2"),
        // Weights, the growth vector, parts; what is claimed of other motions is S.
        ("chaos", "letter") => word > 5,
        ("chaos", "complete") => word > 1,
        ("range", "letter") => word == 2,
        ("range", "edge" | "longest" | "rounds") => true,
        // Of all cells the least S is printed.
        ("range", "others") => true,
        ("range" | "single", "cell") => word > 1 || !is_last(),
        // Of more than four cells the first and the last are printed.
        ("nothing", "cell") => {
            let cells: Vec<&&str> = lines.iter().filter(|line| line.starts_with("cell ")).collect();
            word > 2 || cells.len() > 4 && own != *cells[0] && !is_last()
        }
        _ => false,
    }
}

/// How many words are checked.
fn printed_of(text: &str, every: usize) -> usize {
    let lines: Vec<&str> = text.lines().collect();
    let (mut printed, mut checked) = (0, 0);
    let mut unsaid = Vec::new();
    for ((i, j), fate) in fates(text, every) {
        checked += usize::from(fate.refused);
        if let Some(change) = fate.silent.filter(|_| !is_work(&lines, i, j)) {
            unsaid.push(format!("{} -> {change}", lines[i]));
        }
        let Some(change) = fate.printed else { continue };
        printed += 1;
        // What a parameter is called is not checked, and need not be. All depths above 0 are the most that
        // there are, and near 0 the boxes close for every restitution that is tried. An unknown that
        // equations are linear in is unique at any scale.
        let line = lines[i];
        let ends = ["parameter ", "depth 0/1 ", "restitution "];
        // A root is in every wider interval, too.
        let wider = line.starts_with("touch ");
        let named = wider || ends.iter().any(|start| line.starts_with(start)) && j == 1;
        // Every rate above 1 is an upper bound of one orbit's.
        let single = line.starts_with("growth 1 ") && j == 2;
        // That nothing is born does not depend on the restitution, nor do these small depths.
        let of_nothing = || lines.iter().any(|line| line.starts_with("kind nothing"));
        let nothing = line.starts_with("restitution ") && of_nothing();
        let free = named || single || nothing || line.starts_with("scales ");
        assert!(fate.refused || free, "{}: free to choose: {line} -> {change}", lines[1]);
    }
    println!("{}: {checked} words are checked, {printed} of them may be said otherwise", lines[1]);
    assert!(unsaid.is_empty(), "{}: claimed and not printed: {unsaid:#?}", lines[1]);
    assert!(every > 1 || checked > 4, "{}: only {checked} words are checked", lines[1]);
    checked
}

#[test]
fn what_is_printed_of_periods_is_checked() {
    printed_is_checked(&samples()[0], 2, 10);
}

#[test]
fn what_is_printed_of_an_orbit_is_checked() {
    printed_is_checked(&samples()[1], 17, 10);
}

#[test]
fn what_is_printed_of_chaos_is_checked() {
    printed_is_checked(&samples()[2], 14, if crate::samples::one_in(2) == 1 { 10 } else { 4 });
}

/// Each kind is tried, and nothing is printed without a value.
#[test]
fn every_kind_is_tried_and_no_line_is_empty() {
    let samples = samples().concat();
    for kind in kinds() {
        let line = format!("\nkind {kind}\n");
        assert!(samples.iter().any(|text| text.contains(&line)), "kind {kind} has no sample here");
    }
    for text in samples {
        for (name, value) in answer(&text).unwrap().detail {
            assert!(!name.is_empty() && !value.trim().is_empty(), "{name:?}: {value:?}");
        }
    }
}
