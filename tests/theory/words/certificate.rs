//! Certificates of words: what is written passes, and a damaged one that passes is confirmed from the
//! definition, in exact fractions written out here.
//!
//! `GRAZING_SAMPLES=100 cargo test --test theory words::certificate::damage -- --nocapture` damages as many
//! as it says and prints how each went.

use crate::samples::samples;
use std::collections::BTreeMap;

use grazing::certificate;
use grazing::local::{Answer, Ladder, Plane, Point, Polar, Quantity};
use grazing::number::Sign;
use grazing::search::{Certified, WordCertificate, WordPlace, certify_word};
use grazing::word::{Rectangle, Word};
use num_rational::BigRational;
use num_traits::Pow;

use super::{Q, q};

fn plane(a1: Q, a2: Q) -> Point {
    Point::Plane(Plane::new(a1, a2).unwrap())
}

fn polar(r: Q, s: Q) -> Point {
    Point::Polar(Polar::new(r, s).unwrap())
}

fn text_at(point: &Point, kind: WordCertificate) -> String {
    let words = [true, false].map(|positive| Word::at(&Ladder::default(), point, positive, 40, &()).unwrap());
    match certify_word(WordPlace::Point(point), &[&words[0], &words[1]], kind, &mut || false).unwrap() {
        Certified::Text(text) => text,
        Certified::Undecided(reason) => panic!("{point:?}: {reason}"),
    }
}

fn text_in(a1: [Q; 2], a2: [Q; 2], kind: WordCertificate) -> Certified {
    let rectangle = Rectangle::new(a1, a2).unwrap();
    let words = [true, false].map(|positive| Word::in_rectangle(&rectangle, positive, 40, &()).unwrap());
    certify_word(WordPlace::Rectangle(&rectangle), &[&words[0], &words[1]], kind, &mut || false).unwrap()
}

/// Points of every region, on r = 1, where u_n = 0, and boxes.
fn certificates() -> Vec<String> {
    let points = [
        plane(q(-1, 4), q(1, 2)),
        plane(q(3, 10), q(9, 10)),
        plane(q(-6, 5), q(2, 5)),
        plane(q(2, 1), q(1, 2)),
        plane(q(6, 5), q(1, 4)),
        plane(q(-11, 10), q(1, 4)),
        plane(q(-2, 1), q(1, 2)),
        plane(q(1, 1), q(1, 1)),
        plane(q(1, 2), q(1, 4)),
        polar(q(9, 10), q(37, 100)),
        polar(q(1, 1), q(3, 10)),
        polar(q(3, 4), q(1, 6)),
    ];
    let kinds = [WordCertificate::BySigns { last: 7 }, WordCertificate::ByTheorem];
    let mut texts: Vec<String> =
        points.iter().flat_map(|point| kinds.map(|kind| text_at(point, kind))).collect();
    for (a1, a2) in [
        ([q(-26, 100), q(-25, 100)], [q(1, 2), q(51, 100)]),
        ([q(-119, 100), q(-1, 1)], [q(81, 100), q(82, 100)]),
        ([q(5, 4), q(13, 10)], [q(1, 3), q(7, 20)]),
    ] {
        for kind in kinds {
            match text_in(a1.clone(), a2.clone(), kind) {
                Certified::Text(text) => texts.push(text),
                Certified::Undecided(reason) => panic!("{a1:?}: {reason}"),
            }
        }
    }
    texts
}

#[test]
fn what_is_written_passes_and_is_true() {
    for text in certificates() {
        assert!(certificate::check(&mut text.as_bytes()).is_ok(), "{text}");
        assert_eq!(falsehood(&text), None, "{text}");
    }
}

/// A box across an edge of an area is certified up to that edge, and one across a line between regions not at
/// all.
#[test]
fn boxes_that_straddle_claim_less() {
    let kind = WordCertificate::ByTheorem;
    // b_{3,1} = 0 at a₁ = −1, a₂ = 1/2.
    let Certified::Text(text) = text_in([q(-101, 100), q(-99, 100)], [q(1, 2), q(1, 2)], kind) else {
        panic!("the first two letters are certain")
    };
    assert!(text.contains("\nfirst 2\nopen\n"), "{text}");
    assert_eq!(falsehood(&text), None);
    let Certified::Undecided(reason) = text_in([q(1, 1), q(3, 2)], [q(1, 4), q(1, 4)], kind) else {
        panic!("regions 1 and 2 differ")
    };
    assert!(reason.contains("the box meets a line |a1| = a2 + 1"), "{reason}");
}

/// The signs of u_n and N_{n,k} at one point.
enum Oracle {
    Exact { a2: Q, u: Vec<Q> },
    Ladder(Box<Point>),
}

impl Oracle {
    fn exact(a1: Q, a2: Q) -> Oracle {
        let u = super::u(&a1, &a2, 80);
        Oracle::Exact { a2, u }
    }

    fn u(&self, n: usize) -> Sign {
        match self {
            Oracle::Exact { u, .. } => Sign::of(&u[n]),
            Oracle::Ladder(point) => match Ladder::default().u_sign(point, n as u64).answer {
                Answer::Sign(sign) => sign,
                other => panic!("{other:?}"),
            },
        }
    }

    fn numerator(&self, n: usize, k: usize) -> Sign {
        match self {
            Oracle::Exact { a2, u } => Sign::of(&(&u[n] - &u[k] - Pow::pow(a2, k) * &u[n - k])),
            Oracle::Ladder(point) => {
                let quantity = Quantity::B { n: n as u64, k: k as u64 };
                match Ladder::default().sign(point, quantity).answer {
                    Answer::Sign(sign) => sign * self.u(n),
                    // u_n = 0 and so N = −(1 − w) u_k with w = u_{n+1}, |w| = rⁿ; w = 1 on r = 1 for whole
                    // ns.
                    _ => match &**point {
                        Point::Polar(at) if at.on_circle() && (at.s() * q(n as i64, 1)).is_integer() => {
                            Sign::Zero
                        }
                        _ => self.u(k) * Sign::Negative,
                    },
                }
            }
        }
    }

    fn b(&self, n: usize, k: usize) -> Sign {
        self.numerator(n, k) * self.u(n)
    }
}

/// The first thing that is false of what an accepted certificate states, read by this test's own reader.
fn falsehood(text: &str) -> Option<String> {
    let lines: Vec<Vec<&str>> = text.lines().map(|line| line.split(' ').collect()).collect();
    let number = |word: &str| word.parse::<BigRational>().unwrap();
    let at: Vec<Q> = lines[3][2..].iter().map(|word| number(word)).collect();
    let points = match lines[3][1] {
        "plane" => vec![Oracle::exact(at[0].clone(), at[1].clone())],
        "polar" => vec![Oracle::Ladder(Box::new(polar(at[0].clone(), at[1].clone())))],
        _ => {
            let places = [q(0, 1), q(1, 2), q(1, 1)];
            let mix = |lo: &Q, hi: &Q, t: &Q| lo + (hi - lo) * t;
            let grid = places.iter().flat_map(|s| places.iter().map(move |t| (s, t)));
            grid.map(|(s, t)| Oracle::exact(mix(&at[0], &at[1], s), mix(&at[2], &at[3], t))).collect()
        }
    };
    points.iter().find_map(|point| false_at(&lines, point))
}

fn false_at(lines: &[Vec<&str>], point: &Oracle) -> Option<String> {
    let by_theorem = lines[1][1] == "word-by-theorem";
    let starts: Vec<usize> = (0..lines.len()).filter(|&i| lines[i][0] == "word").collect();
    for (index, &start) in starts.iter().enumerate() {
        let body = &lines[start + 1..starts.get(index + 1).copied().unwrap_or(lines.len())];
        let wanted = if lines[start][1] == "+" { Sign::Positive } else { Sign::Negative };
        // Every period that is decided: its letter if it occurs.
        let mut said: BTreeMap<usize, Option<char>> = BTreeMap::new();
        let letter = |word: &str| word.chars().next().unwrap();
        let period = |word: &str| word.parse::<usize>().unwrap();
        let mut open = false;
        if by_theorem
            && wanted == Sign::Positive
            && (body[0][0] == "first" || body[0][0] == "step" || body[0][0] == "end" || body[0][0] == "open")
        {
            said.extend([(1, Some('D')), (2, Some('U'))]);
        }
        for line in body {
            match line[0] {
                "occurs" | "step" => drop(said.insert(period(line[1]), Some(letter(line[2])))),
                "absent" | "singular" | "end" => drop(said.insert(period(line[1]), None)),
                "first" => {
                    said.remove(&2);
                    said.insert(period(line[1]), Some('U'));
                }
                "below" => said.extend((1..=period(line[1])).map(|n| (n, Some('D')))),
                "one" => drop(said.insert(1, Some(letter(line[1])))),
                "all" => said.extend((1..=30).map(|n| (n, Some(letter(line[1]))))),
                "open" => open = true,
                _ => {}
            }
        }
        // The theorem says that no other period occurs.
        let last = *said.keys().max()?;
        if by_theorem && body[0][0] != "all" {
            let to = if open { last } else { last + 8 };
            for n in 1..=to.min(38) {
                said.entry(n).or_insert(None);
            }
        }
        for (&n, &letter) in said.range(..=38) {
            let occurs = point.u(n) != Sign::Zero && (1..n).all(|k| point.b(n, k) == wanted);
            if occurs != letter.is_some() {
                return Some(format!("period {n}, e mu {wanted:?}"));
            }
            let c = point.numerator(2 * n, n);
            if letter.is_some_and(|letter| c != if letter == 'U' { Sign::Positive } else { Sign::Negative }) {
                return Some(format!("the letter of {n}"));
            }
        }
        let rows: Vec<&Vec<&str>> = body.iter().filter(|line| line[0] == "follows").collect();
        let order: Vec<usize> = rows.iter().map(|row| period(row[1])).collect();
        for row in &rows {
            let i = period(row[1]);
            for (mark, &j) in row[2].chars().zip(&order).filter(|&(_, &j)| i + j < 80) {
                let sign = point.numerator(i + j, i) * point.u(i) * point.u(j);
                let right = match mark {
                    '+' => sign == Sign::Positive,
                    '-' => sign == Sign::Negative,
                    _ => true,
                };
                if !right {
                    return Some(format!("{i} to {j}: {mark}"));
                }
            }
        }
    }
    None
}

/// SplitMix64: the same damage on every machine.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % bound.max(1) as u64) as usize
    }
}

/// The text with one to three places damaged: marks, letters, digits, words from elsewhere, lines.
fn damaged(text: &str, random: &mut Random) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_string).collect();
    for _ in 0..1 + random.below(2) {
        // The statement is a line that must be word for word.
        let at = 3 + random.below(lines.len() - 3);
        match random.below(12) {
            0 => drop(lines.remove(at)),
            1 => {
                let line = lines[random.below(lines.len())].clone();
                lines.insert(at, line);
            }
            // Changes that may leave it true: a mark withdrawn, another witness, another precision, a digit
            // of the set.
            2 => {
                if let Some(line) = lines.iter_mut().skip(at).find(|line| line.starts_with("follows")) {
                    *line = line.replacen(['+', '-'][random.below(2)], "?", 1);
                }
            }
            3 | 4 => {
                if let Some(line) = lines.iter_mut().skip(at).find(|line| line.starts_with("absent")) {
                    let words: Vec<&str> = line.split(' ').collect();
                    *line = format!("{} {} {}", words[0], words[1], 1 + random.below(8));
                }
            }
            5 => lines[4] = format!("bits {}", 32 * (2 + random.below(9))),
            6 => {
                let places: Vec<usize> =
                    (0..lines[3].len()).filter(|&i| lines[3].as_bytes()[i].is_ascii_digit()).collect();
                let mut bytes = lines[3].clone().into_bytes();
                // An earlier change may have left no digit there.
                if !places.is_empty() {
                    bytes[places[random.below(places.len())]] = b"0123456789"[random.below(10)];
                }
                lines[3] = String::from_utf8(bytes).unwrap();
            }
            7..=9 => {
                let mut bytes = lines[at].clone().into_bytes();
                if !bytes.is_empty() {
                    let place = random.below(bytes.len());
                    let like = |byte: u8| match byte {
                        b'+' | b'-' | b'?' => b"+-?".as_slice(),
                        b'U' | b'D' => b"UD0",
                        b'0'..=b'9' => b"0123456789",
                        _ => b" +-0123456789UD/?",
                    };
                    let choice = like(bytes[place]);
                    bytes[place] = choice[random.below(choice.len())];
                }
                lines[at] = String::from_utf8(bytes).unwrap();
            }
            _ => {
                // A word from another line in the place of one.
                let from = 3 + random.below(lines.len() - 3);
                let words: Vec<String> = lines[from].split(' ').map(str::to_string).collect();
                let word = words[random.below(words.len())].clone();
                let mut words: Vec<String> = lines[at].split(' ').map(str::to_string).collect();
                let place = random.below(words.len());
                words[place] = word;
                lines[at] = words.join(" ");
            }
        }
        if lines.len() < 5 {
            break;
        }
    }
    lines.join("\n") + "\n"
}

#[test]
fn no_damaged_certificate_that_is_false_passes() {
    let texts = certificates();
    let runs: u64 = samples(1000);
    let (mut rejected, mut unchanged, mut still_true) = (0, 0, 0);
    for run in 0..runs {
        let mut random = Random(crate::samples::seed(run));
        let text = &texts[random.below(texts.len())];
        let damaged = damaged(text, &mut random);
        if certificate::check(&mut damaged.as_bytes()).is_err() {
            rejected += 1;
        } else if damaged == *text {
            unchanged += 1;
        } else {
            assert_eq!(falsehood(&damaged), None, "run {run} is accepted though false:\n{damaged}");
            still_true += 1;
        }
    }
    println!(
        "{runs} damaged: {rejected} rejected, {unchanged} unchanged, {still_true} still true and accepted"
    );
    assert!(rejected > runs / 4 && crate::samples::tried(still_true, 20));
}

/// The oracle notices what is false: else the test above asserts nothing.
#[test]
fn the_oracle_sees_falsehoods() {
    for text in certificates() {
        for (from, to) in [
            ("occurs 1 D", "occurs 1 U"),
            ("follows 1 -", "follows 1 +"),
            ("step 3 U", "step 3 D"),
            ("below 1", "below 2"),
        ] {
            if text.contains(from) {
                assert!(falsehood(&text.replacen(from, to, 1)).is_some(), "{from} to {to}:\n{text}");
            }
        }
    }
}
