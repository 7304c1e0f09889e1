//! The suprema of the entropy: their certificate, damaged copies of it, and words drawn at random.

use grazing::certificate::check;
use grazing::local::{Ladder, Point, Polar};
use grazing::number::parse_rational;
use grazing::search::entropy_certificate;
use grazing::word::{Entropy, Word};
use num_rational::BigRational;
use num_traits::ToPrimitive;

/// log of the tribonacci constant, and −log of the root of the equation of the other case.
const SUPREMA: [f64; 2] = [0.609_377_863_436_006, 0.450_385_084_073_141];

#[test]
fn the_certificate_passes() {
    let text = entropy_certificate(&()).unwrap();
    // The checker's sample.
    assert_eq!(text, include_str!("../../crates/checker/tests/data/entropy.txt"));
    let checked = check(&mut text.as_bytes()).unwrap();
    assert_eq!((checked.kind, &checked.range), ("entropy", &None));
    let [minus, plus] = &checked.detail[..] else { panic!("{checked}") };
    assert_eq!(minus.0, "case + -");
    assert!(minus.1.starts_with("1699/3125 < z < 54369/100000; 7 bounds"), "{}", minus.1);
    assert!(plus.1.ends_with("8 bounds of words, the last of every K >= 4"), "{}", plus.1);
    for ((_, detail), supremum) in checked.detail.iter().zip(SUPREMA) {
        let bound = |part: &str| {
            let (p, q) = part.split_once('/').unwrap();
            -(p.parse::<f64>().unwrap() / q.parse::<f64>().unwrap()).ln()
        };
        let (low, rest) = detail.split_once(" < z < ").unwrap();
        let high = rest.split_once(';').unwrap().0;
        assert!(bound(high) < supremum && supremum < bound(low), "{detail}");
    }
}

/// Every word of every line changed: what is still accepted has other vectors, or bounds of the root further
/// off, and proves the same.
#[test]
fn damaged_certificates_are_refused() {
    let text = entropy_certificate(&()).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    let (mut refused, mut accepted) = (0, 0);
    for (index, line) in lines.iter().enumerate() {
        let with = |changed: Option<&str>| {
            let all = lines.iter().enumerate();
            let kept = all.filter_map(|(i, line)| if i == index { changed } else { Some(*line) });
            kept.map(|line| format!("{line}\n")).collect::<String>()
        };
        assert!(check(&mut with(None).as_bytes()).is_err(), "without {line}");
        assert!(check(&mut with(Some(&format!("{line}\n{line}"))).as_bytes()).is_err(), "twice {line}");
        let words: Vec<&str> = line.split(' ').collect();
        for place in 0..words.len() {
            for other in
                ["0", "1", "7", "-", "+", "U", "D", "UD", "bound", "ends", "1/2", "999999", "2000000"]
            {
                if words[place] == other {
                    continue;
                }
                let mut changed = words.clone();
                changed[place] = other;
                match check(&mut with(Some(&changed.join(" "))).as_bytes()) {
                    Err(_) => refused += 1,
                    Ok(_) => {
                        let vector = ["bound", "ends"].contains(&words[0]) && place > 1;
                        let bound = words[0] == "root" && other == "1/2";
                        let entry = vector && other.parse::<u64>().is_ok();
                        assert!(entry || bound, "{line}: {other} at {place}");
                        accepted += 1;
                    }
                }
            }
        }
    }
    // A vector that is smaller in one entry, or larger in another, hardly ever does.
    assert!(refused > 50 * accepted && refused > 1000, "{refused} {accepted}");
}

/// No word at a random place, or near the places of the suprema, has more; near them it has nearly as much.
#[test]
fn no_word_exceeds_the_suprema() {
    let entropy = |r: &str, s: &str, gamma: bool| {
        let polar = Polar::new(parse_rational(r).unwrap(), parse_rational(s).unwrap()).unwrap();
        let word = Word::at(&Ladder::default(), &Point::Polar(polar), true, 60, &()).unwrap();
        let (entropy, _) = Entropy::of(&word, gamma, 50).unwrap();
        entropy.bounds().map_or(0.0, |(_, high): (BigRational, BigRational)| high.to_f64().unwrap())
    };
    for i in 1..400u32 {
        let s = format!("{}/1600", 2 * i - 1);
        for r in ["1", "0.999", "0.9", "0.6"] {
            for (gamma, supremum) in [(false, SUPREMA[0]), (true, SUPREMA[1])] {
                assert!(entropy(r, &s, gamma) < supremum + 1e-12, "{r} {s} {gamma}");
            }
        }
    }
    assert!(entropy("1", "0.4999", false) > SUPREMA[0] - 1e-6);
    assert!(entropy("1", "0.2501", true) > SUPREMA[1] - 1e-6);
}

/// The limits from both sides of a fraction that docs/words.md lists. Seen, not proved.
#[test]
fn the_staircase_jumps_as_listed() {
    let page = include_str!("../../docs/words.md");
    let mut listed = 0;
    for line in page.lines().filter(|line| line.starts_with("| ") && line.matches('|').count() == 8) {
        let cells: Vec<String> = line.split('|').map(|cell| cell.trim().replace('−', "-")).collect();
        let Some((m, n)) = cells[1].split_once('/') else { continue };
        let (Ok(m), Ok(n)) = (m.parse::<i64>(), n.parse::<i64>()) else { continue };
        listed += 1;
        for (gamma, first) in [(true, 2), (false, 5)] {
            let limit = |side: i64| {
                let s = BigRational::new((1_000_000 * m + side * n).into(), (1_000_000 * n).into());
                let polar = Polar::new(BigRational::from_integer(1.into()), s).unwrap();
                let word = Word::at(&Ladder::default(), &Point::Polar(polar), true, 70, &()).unwrap();
                Entropy::of(&word, gamma, 50).unwrap().0.bounds().unwrap().0.to_f64().unwrap()
            };
            let (below, above) = (limit(-1), limit(1));
            for (value, cell) in [(below, first), (above, first + 1), (above - below, first + 2)] {
                assert!((value - cells[cell].parse::<f64>().unwrap()).abs() < 1e-6, "{line}: {value}");
            }
        }
    }
    assert_eq!(listed, 8);
}

/// Just below 1/k the entropy in (+,−) is that of z + z^k + z^(k+1) = 1. Seen, not proved.
#[test]
fn tails_have_the_entropy_of_their_equation() {
    for k in 2..=6u64 {
        let s = BigRational::new((10_000 - k).into(), (10_000 * k).into());
        let polar = Polar::new(BigRational::from_integer(1.into()), s).unwrap();
        let word = Word::at(&Ladder::default(), &Point::Polar(polar), true, 300, &()).unwrap();
        let (entropy, at_least) = Entropy::of(&word, false, 60).unwrap();
        let (low, _) = entropy.bounds().unwrap();
        let (mut below, mut above) = (0.5f64, 1.0f64);
        for _ in 0..60 {
            let z = (below + above) / 2.0;
            let value = z + z.powi(k as i32) + z.powi(k as i32 + 1);
            *(if value < 1.0 { &mut below } else { &mut above }) = z;
        }
        assert!((low.to_f64().unwrap() + below.ln()).abs() < 1e-12, "{k}: {low} {below} {at_least}");
    }
}
