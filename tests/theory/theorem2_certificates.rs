//! Certificates: what is written passes, what is damaged is rejected unless it is still true.

use crate::common;
use crate::samples::{samples, tried};

use std::{collections::BTreeMap, fs};

use common::Fraction;
use grazing::{
    certificate::{self, Rejection, theorem2::Claim},
    search::{ProofMethod, prove_theorem2, write_theorem2},
};
use num_integer::Integer;
use proptest::{prelude::*, strategy::ValueTree};

fn written(first: u64, last: u64) -> String {
    let proof = prove_theorem2(first..=last, ProofMethod::Exact, &()).unwrap();
    let mut bytes = Vec::new();
    write_theorem2(first..=last, &proof, &mut bytes, &()).unwrap();
    String::from_utf8(bytes).unwrap()
}

fn check(text: &str) -> Result<certificate::Checked, Rejection> {
    certificate::check(&mut text.as_bytes())
}

#[test]
fn what_is_written_passes() {
    let text = written(1, 60);
    let checked = check(&text).unwrap();
    assert_eq!(checked.range, Some(1..=60));
    assert_eq!(checked.lines, text.lines().count() as u64);
    assert!(is_true(&text));
}

#[test]
fn the_example_in_the_documentation_is_the_block_of_period_4() {
    let text = written(4, 4);
    let block: Vec<&str> = text.lines().skip(5).collect();
    let source =
        fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../checker/src/theorem2/mod.rs")).unwrap();
    let start = source.find("//! n 4 9").unwrap();
    let shown: Vec<&str> = source[start..]
        .lines()
        .map(|line| line.trim_start_matches("//! ").split("  ").next().unwrap())
        .take(block.len())
        .collect();
    assert_eq!(shown, block);
    // The failing run shown there.
    let damaged = text.replace("stretch 1/3 3/8 2 1", "stretch 1/3 3/8 1 2");
    let answer = check(&damaged).unwrap_err().to_string();
    assert!(source.contains(&format!("`{answer}`")), "{answer}");
}

#[test]
fn rejections_name_the_line_and_the_reason() {
    let text = written(3, 5);
    let lines: Vec<&str> = text.lines().collect();
    let with = |index: usize, line: &str| {
        let mut lines = lines.clone();
        lines[index] = line;
        lines.join("\n") + "\n"
    };
    let known: Vec<String> = certificate::kinds().map(|kind| format!("\"kind {kind}\"")).collect();
    assert!(known.len() > 20 && known[0] == "\"kind theorem2\"");
    let cases = [
        (String::new(), "line 1: malformed: the file ends where the format line should stand"),
        (
            with(0, "grazing-certificate 2"),
            "line 1: malformed: not a certificate of this format: expected \"grazing-certificate 1\"",
        ),
        (with(1, "kind theorem3"), &format!("line 2: malformed: expected a line {}", known.join(" or "))),
        (with(2, "range 5 3"), "line 3: malformed: the range must be 1 <= first <= last"),
        (with(2, "range 0 5"), "line 3: malformed: the range must be 1 <= first <= last"),
        (
            with(2, "range 3 99999999999999999999"),
            "line 3: malformed: expected the last period, a number from 0 to 200000",
        ),
        (with(3, "lines 7"), "line 4: malformed: 30 lines follow the header, so this should be \"lines 30\""),
        (
            with(4, "statement 1 = 1"),
            "line 5: malformed: the statement is not, word for word, that of this kind and version",
        ),
        (with(5, "n 4 5"), "line 6: malformed: expected the block of n = 3"),
        (
            with(6, "orbit 0/1 2/12 - +"),
            "line 7: malformed: expected a fraction p/q in lowest terms, 0 <= p <= q <= 6",
        ),
        (
            with(6, "orbit 0/1 1/06 - +"),
            "line 7: malformed: expected a fraction p/q in lowest terms, 0 <= p <= q <= 6",
        ),
        (with(6, "orbit 0/1 1/6 - + x"), "line 7: malformed: unexpected words at the end of the line"),
        (with(6, "orbit 0/1 1/6 - -"), "line 7: false: c_3 has the wrong sign on (0/1, 1/6)"),
        (with(6, "orbit 0/1 1/6 + +"), "line 7: false: b_{3,1} has the wrong sign on (0/1, 1/6)"),
        (with(6, "stretch 0/1 1/6 1 2"), "line 7: false: b_{3,1} is not > 0 on (0/1, 1/6)"),
        (with(6, "orbit 0/1 1/3 - +"), "line 7: false: u_3 = 0 at a multiple of 1/6 inside (0/1, 1/3)"),
        (with(7, "point 1/6 boundary 3"), "line 8: malformed: expected k, a number from 0 to 2"),
        (with(7, "point 1/6 boundary 1"), "line 8: false: u_3 = 0 at 1/6: singular"),
        (
            with(7, "point 1/5 singular"),
            "line 8: false: the lines must tile (0, 1/2) by intervals and the points between them; reached 1/6",
        ),
        (text.clone() + "\n", "line 36: malformed: the file goes on after the last period of its range"),
        (
            lines[..20].join("\n") + "\n",
            "line 21: malformed: the file ends where a line of this block should stand",
        ),
    ];
    for (damaged, expected) in cases {
        assert_eq!(check(&damaged).unwrap_err().to_string(), expected);
    }
    assert!(
        certificate::check(&mut &b"grazing-certificate 1\nkind \xff\n"[..])
            .unwrap_err()
            .to_string()
            .contains("not text")
    );
    assert!(check(&"x".repeat(10_000_000)).unwrap_err().to_string().contains("longer than 1000 bytes"));
}

/// Damage that random edits hardly ever make: each block is edited consistently, line counts included.
#[test]
fn consistent_falsehoods_are_rejected() {
    let text = written(6, 6);
    let body: Vec<&str> = text.lines().skip(6).collect();
    let rebuilt = |body: &[&str]| {
        let header = certificate::theorem2::header(&(6..=6), body.len() as u64 + 1);
        check(&format!("{header}n 6 {}\n{}\n", body.len(), body.join("\n")))
    };
    assert!(rebuilt(&body).is_ok());
    let at = body.iter().position(|line| *line == "point 1/3 singular").unwrap();
    // b_{6,2} > 0 > b_{6,3} on both sides of 1/3 = 2/6, and (B1) has the same signs there, but u_6 = 0.
    assert!(
        rebuilt(&[&body[..at], &["point 1/3 excluded 2 3"], &body[at + 1..]].concat())
            .unwrap_err()
            .to_string()
            .ends_with("u_6 = 0 at 1/3: singular")
    );
    let left: Vec<&str> = body[at - 1].split(' ').collect();
    let right: Vec<&str> = body[at + 1].split(' ').collect();
    for witnesses in ["1 3", "1 2", "2 3", "3 2", "2 1", "3 1"] {
        let across = format!("stretch {} {} {witnesses}", left[1], right[2]);
        let error = rebuilt(&[&body[..at - 1], &[&across], &body[at + 2..]].concat()).unwrap_err();
        assert!(error.to_string().contains("u_6 = 0 at a multiple"), "{error}");
    }
    // An interval of length 0, and the same point twice.
    let empty = format!("stretch {0} {0} {1} {2}", left[1], left[3], left[4]);
    let error = rebuilt(&[&body[..at - 1], &[&empty, body[at - 2]], &body[at - 1..]].concat()).unwrap_err();
    assert!(error.to_string().contains("tile"), "{error}");
}

/// The plainest reading of a certificate: every claim tested cell by cell by brute force.
fn is_true(text: &str) -> bool {
    let fraction = |word: &str| -> Fraction {
        let (p, q) = word.split_once('/').unwrap();
        (p.parse().unwrap(), q.parse().unwrap())
    };
    let mut blocks: BTreeMap<i128, Vec<Vec<&str>>> = BTreeMap::new();
    let mut n = 0;
    for line in text.lines().skip(5) {
        let words: Vec<&str> = line.split(' ').collect();
        if words[0] == "n" {
            n = words[1].parse().unwrap();
            blocks.insert(n, Vec::new());
        } else {
            blocks.get_mut(&n).unwrap().push(words);
        }
    }
    blocks.iter().all(|(&n, lines)| {
        let cuts = common::cuts(n);
        let cells = |l: Fraction, r: Fraction| -> Vec<Fraction> {
            let mut ends: Vec<Fraction> =
                cuts.iter().copied().filter(|&c| common::less(l, c) && common::less(c, r)).collect();
            ends.insert(0, l);
            ends.push(r);
            ends.windows(2).map(|pair| common::middle(pair[0], pair[1])).collect()
        };
        let inside = |l: Fraction, r: Fraction| {
            cuts.iter().copied().filter(move |&c| common::less(l, c) && common::less(c, r))
        };
        let opposite = |s: Fraction, k: &str, j: &str| {
            common::sign_b(n, k.parse().unwrap(), s) == Some(1)
                && common::sign_b(n, j.parse().unwrap(), s) == Some(-1)
        };
        let mut orbits = Vec::new();
        let mut reached = (0, 1);
        let all = lines.iter().all(|words| match words[0] {
            "orbit" => {
                let (l, r) = (fraction(words[1]), fraction(words[2]));
                let sign = |word: &str| if word == "+" { 1 } else { -1 };
                orbits.push((l, r, sign(words[3]), sign(words[4])));
                let tiles = n == 1 || l == reached;
                reached = r;
                // No cut inside: then the signs hold throughout.
                tiles
                    && inside(l, r).all(|c| {
                        !common::singular(n, c)
                            && common::cases(n, c).contains(&(sign(words[3]), sign(words[4])))
                    })
                    && cells(l, r)
                        .into_iter()
                        .all(|s| common::cases(n, s).contains(&(sign(words[3]), sign(words[4]))))
            }
            "stretch" => {
                let (l, r) = (fraction(words[1]), fraction(words[2]));
                let tiles = l == reached;
                reached = r;
                tiles
                    && cells(l, r)
                        .into_iter()
                        .chain(inside(l, r))
                        .all(|s| !common::singular(n, s) && opposite(s, words[3], words[4]))
            }
            _ => {
                let s = fraction(words[1]);
                // u_1 = 1, and the points are those of the open interval.
                s == reached
                    && common::less(s, (1, 2))
                    && n > 1
                    && match words[2] {
                        "singular" => common::singular(n, s),
                        "boundary" => {
                            let b: Vec<_> = (1..n).map(|k| common::sign_b(n, k, s)).collect();
                            !common::singular(n, s)
                                && common::sign_b(n, words[3].parse().unwrap(), s) == Some(0)
                                && !(b.contains(&Some(1)) && b.contains(&Some(-1)))
                        }
                        _ => !common::singular(n, s) && opposite(s, words[3], words[4]),
                    }
            }
        });
        let expected = match n {
            1 => vec![((0, 1), (1, 2), 1, -1), ((0, 1), (1, 2), -1, 1)],
            2 => vec![((0, 1), (1, 4), -1, 1), ((1, 4), (1, 2), 1, 1)],
            _ => common::theorem(n),
        };
        all && reached == (1, 2) && orbits == expected
    })
}

#[derive(Debug, Clone)]
enum Damage {
    Remove(prop::sample::Index),
    Duplicate(prop::sample::Index),
    Swap(prop::sample::Index, prop::sample::Index),
    Truncate(prop::sample::Index),
    /// Replace a word by one from elsewhere in the file.
    Transplant(prop::sample::Index, prop::sample::Index),
    /// Change a digit or sign.
    Byte(prop::sample::Index, u8),
    Insert(prop::sample::Index, u8),
    /// A line that is true of other periods is put in.
    Foreign(prop::sample::Index, &'static str),
    Huge(prop::sample::Index),
}

/// Lines about the ends, and about points that every period has.
const FOREIGN: [&str; 5] = [
    "point 1/2 singular",
    "point 0/1 singular",
    "point 1/4 singular",
    "orbit 0/1 1/2 + -",
    "stretch 0/1 1/2 1 1",
];

fn damage() -> impl Strategy<Value = Damage> {
    let index = any::<prop::sample::Index>;
    prop_oneof![
        1 => index().prop_map(Damage::Remove),
        1 => index().prop_map(Damage::Duplicate),
        1 => (index(), index()).prop_map(|(a, b)| Damage::Swap(a, b)),
        1 => index().prop_map(Damage::Truncate),
        4 => (index(), index()).prop_map(|(a, b)| Damage::Transplant(a, b)),
        4 => (index(), prop::sample::select(b"0123456789+-/ ".to_vec())).prop_map(|(at, byte)| Damage::Byte(at, byte)),
        2 => (index(), prop::sample::select(b"0123456789+-/ \r\n".to_vec())).prop_map(|(at, byte)| Damage::Insert(at, byte)),
        1 => (index(), prop::sample::select(FOREIGN.to_vec())).prop_map(|(at, line)| Damage::Foreign(at, line)),
        1 => index().prop_map(Damage::Huge),
    ]
}

fn damaged(text: &str, damage: &Damage) -> String {
    let mut lines: Vec<String> = text.lines().map(String::from).collect();
    let words: Vec<(usize, usize)> = lines
        .iter()
        .enumerate()
        .filter(|(i, _)| *i != 4)
        .flat_map(|(i, line)| (0..line.split(' ').count()).map(move |j| (i, j)))
        .collect();
    let replace = |lines: &mut Vec<String>, (i, j): (usize, usize), word: String| {
        let mut parts: Vec<String> = lines[i].split(' ').map(String::from).collect();
        parts[j] = word;
        lines[i] = parts.join(" ");
    };
    match damage {
        Damage::Remove(at) => drop(lines.remove(at.index(lines.len()))),
        Damage::Duplicate(at) => {
            let at = at.index(lines.len());
            lines.insert(at, lines[at].clone());
        }
        Damage::Swap(a, b) => {
            let (a, b) = (a.index(lines.len()), b.index(lines.len()));
            lines.swap(a, b);
        }
        Damage::Truncate(at) => return text[..at.index(text.len())].to_string(),
        Damage::Transplant(from, to) => {
            let (i, j) = words[from.index(words.len())];
            let word = lines[i].split(' ').nth(j).unwrap().to_string();
            replace(&mut lines, words[to.index(words.len())], word);
        }
        Damage::Byte(at, byte) => {
            let mut bytes = text.as_bytes().to_vec();
            bytes[at.index(text.len())] = *byte;
            return String::from_utf8(bytes).unwrap();
        }
        Damage::Insert(at, byte) => {
            let mut bytes = text.as_bytes().to_vec();
            bytes.insert(at.index(text.len()), *byte);
            return String::from_utf8(bytes).unwrap();
        }
        // The counts are set right, so that only the line itself can be wrong.
        Damage::Foreign(at, line) => {
            let at = 6 + at.index(lines.len() - 6);
            lines.insert(at, line.to_string());
            let head = (0..at).rev().find(|&i| lines[i].starts_with("n ")).unwrap();
            for i in [3, head] {
                let (first, count) = lines[i].rsplit_once(' ').unwrap();
                lines[i] = format!("{first} {}", count.parse::<u64>().unwrap() + 1);
            }
        }
        Damage::Huge(at) => replace(&mut lines, words[at.index(words.len())], "9".repeat(40)),
    }
    lines.join("\n") + "\n"
}

/// Thousands of damaged certificates; the few that pass are confirmed true by brute force.
#[test]
fn damage_is_detected() {
    let text = written(1, 14);
    let mut runner = common::runner(1);
    let (mut rejected, mut unchanged, mut still_true) = (0, 0, 0);
    let strategy = damage();
    for _ in 0..samples::<u64>(8_000) {
        let damage = strategy.new_tree(&mut runner).unwrap().current();
        let changed = damaged(&text, &damage);
        if changed == text {
            unchanged += 1;
        } else if check(&changed).is_ok() {
            assert!(is_true(&changed), "accepted though false, after {damage:?}:\n{changed}");
            still_true += 1;
        } else {
            rejected += 1;
        }
    }
    println!("{rejected} rejected, {still_true} still true, {unchanged} unchanged");
    assert!(3 * unchanged < rejected);
    assert!(tried(still_true, 10), "a witness replaced by another one that holds should pass");
}

proptest! {
    #![proptest_config(common::config())]

    /// A claim printed and read back is the same claim.
    #[test]
    fn claims_are_read_as_written(n in 2u64..5000, p: u64, q: u64, k: u64, j: u64, kind in 0..5) {
        let (q, k, j) = (1 + q % (2 * n), 1 + k % (n - 1), 1 + j % (n - 1));
        let p = p % (q + 1);
        let common = p.gcd(&q);
        let at = certificate::Fraction::new(p / common, q / common).unwrap();
        let claim = match kind {
            0 => Claim::Orbit { left: at, right: at, emu: k > j, gamma: p > j },
            1 => Claim::Stretch { left: at, right: at, positive: k, negative: j },
            2 => Claim::Singular(at),
            3 => Claim::Boundary(at, k),
            _ => Claim::Excluded { at, positive: k, negative: j },
        };
        prop_assert_eq!(Claim::parse(&claim.to_string(), n), Ok(claim));
    }

    #[test]
    fn text_of_any_kind_is_an_answer_and_no_panic(text in "(?s).{0,300}") {
        prop_assert!(check(&text).is_err());
        let headed = format!("grazing-certificate 1\nkind theorem2\n{text}");
        prop_assert!(check(&headed).is_err());
    }
}
