//! Damaged certificates, against an oracle in floats.

use crate::samples::{samples, tried};
use std::collections::HashMap;

use grazing_scenes::{
    certificate::{
        self,
        chaos::{Certificate, Complete, Decimal, Fraction, Harmonic, Letter},
    },
    search::chaos::holds,
};
use proptest::strategy::{Strategy, ValueTree};

use super::{
    ALWAYS, FIGURE_10,
    common::damage::{damage, damaged},
    mirrored, proved,
};

/// The certificate as a plain reader of the format has it.
fn read(text: &str) -> Option<Certificate> {
    let mut lines: HashMap<&str, Vec<Vec<&str>>> = HashMap::new();
    for line in text.lines() {
        let mut words = line.split(' ');
        lines.entry(words.next()?).or_default().push(words.collect());
    }
    let decimal = |word: &str| {
        let (whole, places) = word.split_once('.').unwrap_or((word, ""));
        Some(Decimal { digits: format!("{whole}{places}").parse().ok()?, places: places.len() as u32 })
    };
    let fraction = |word: &str| {
        let (p, q) = word.split_once('/')?;
        Some(Fraction { p: p.parse().ok()?, q: q.parse().ok()? })
    };
    let one = |name: &str| lines.get(name).map(|all| all[0].clone());
    let range = |name: &str| Some([fraction(one(name)?[0])?, fraction(one(name)?[1])?]);
    let whole = |word: &str| word.parse::<u64>().ok();
    let letters = lines.get("letter")?.iter().zip(lines.get("next")?).map(|(w, next)| {
        Some(Letter {
            periods: whole(w[0])?,
            after: [decimal(w[1])?, decimal(w[2])?],
            before: [decimal(w[3])?, decimal(w[4])?],
            weights: [decimal(w[5])?, decimal(w[6])?],
            growth: decimal(w[7])?,
            parts: whole(w[8])?,
            next: next.iter().map(|w| Some(whole(w)? as usize - 1)).collect::<Option<_>>()?,
        })
    });
    let harmonic = |w: &Vec<&str>| {
        let [a, b, c, d] = [fraction(w[1])?, fraction(w[2])?, fraction(w[3])?, fraction(w[4])?];
        Some(Harmonic { order: whole(w[0])?, parts: [[a, b], [c, d]] })
    };
    let complete = match &one("complete")?[..] {
        ["no"] => None,
        [s, m, k, r] => {
            Some(Complete { strength: decimal(s)?, longest: whole(m)?, parts: whole(k)?, rounds: whole(r)? })
        }
        _ => return None,
    };
    let cells: Vec<u64> = one("cells")?.iter().filter_map(|w| whole(w)).collect();
    Some(Certificate {
        mirrored: one("kind")? == ["chaos", "4"],
        ranges: [
            range("damping")?,
            range("stiffness")?,
            range("force")?,
            range("restitution")?,
            range("depth")?,
        ],
        behind: one("side")?[0] == "1",
        harmonics: lines.get("harmonic")?.iter().map(harmonic).collect::<Option<_>>()?,
        complete,
        cells: cells.try_into().ok()?,
        window: decimal(one("window")?[0])?,
        pieces: whole(one("pieces")?[0])?,
        letters: letters.collect::<Option<_>>()?,
        contraction: decimal(one("contraction")?[0])?,
        reach: decimal(one("reach")?[0])?,
        growth: [decimal(one("growth")?[0])?, decimal(one("growth")?[1])?],
    })
}

/// Damaged certificates, GRAZING_SAMPLES times as many of each; those that pass hold in floats too, by code
/// that shares nothing with the checker.
#[test]
fn damage_is_detected() {
    let mut runner = crate::common::runner(1);
    let strategy = damage();
    let one = [ALWAYS, FIGURE_10].map(proved);
    let two = ["touched", "before"].map(|name| mirrored::proved(mirrored::STOPS, name));
    for found in one.into_iter().chain(two) {
        let text = found.proof.unwrap().accepted.text().to_string();
        assert_eq!(holds(&read(&text).unwrap()), Ok(()));
        let head = text.lines().position(|line| line.starts_with("damping")).unwrap();
        let (mut rejected, mut unchanged, mut still_true) = (0, 0, 0);
        for round in 0..samples::<u64>(250) {
            let damage = strategy.new_tree(&mut runner).unwrap().current();
            let changed = damaged(&text, if round % 8 == 0 { 0 } else { head }, &damage);
            if changed == text {
                unchanged += 1;
            } else if certificate::check(&mut changed.as_bytes()).is_ok() {
                let certificate = read(&changed).expect("what is accepted can be read");
                assert_eq!(holds(&certificate), Ok(()), "accepted after {damage:?}:\n{changed}");
                still_true += 1;
            } else {
                rejected += 1;
            }
        }
        println!("{rejected} rejected, {still_true} still true, {unchanged} unchanged");
        assert!(rejected > 2 * still_true && tried(still_true, 5));
    }
}
