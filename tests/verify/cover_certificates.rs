//! Certificates of kind cover: what the search writes passes; what is damaged, or true only by a wrong rule,
//! is rejected.

use crate::common;
use crate::samples::{samples, tried};

use std::{fs, path::Path, process::Command, sync::LazyLock};

use common::Fraction;
use grazing::{
    certificate::{
        self, Rejection,
        cover::{
            Leaf, check_block,
            expansion::{Expansion, Form, Patch, Powers, Waves},
            fixed::{ONE, sine_cosine, sines_cosines},
        },
    },
    existence::{Case, Claim, Variant, claimed},
    local::{Answer, Ladder, Point, Polar, Quantity},
    number::{Angle, Ball, Circular, Precision, Real, Sign},
};
use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::{prelude::*, sample::Index, strategy::ValueTree, test_runner::TestRunner};

/// What `grazing cover` writes.
fn written(periods: &str, r_max: Option<&str>) -> String {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cover");
    let mut command = Command::new(crate::PROGRAM);
    command.args(["cover", periods, "--certificate"]).arg(&path);
    if let Some(r_max) = r_max {
        command.args(["--r-max", r_max]);
    }
    let output = command.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    fs::read_to_string(path).unwrap()
}

fn check(text: &str) -> Result<certificate::Checked, Rejection> {
    certificate::check(&mut text.as_bytes())
}

/// The blocks of a certificate, each with the number of lines before it.
fn blocks(text: &str) -> Vec<(u64, u64, String)> {
    let mut all: Vec<(u64, u64, String)> = Vec::new();
    for (before, line) in text.lines().enumerate().skip(5) {
        if let Some(rest) = line.strip_prefix("n ") {
            let n = rest.split(' ').next().unwrap().parse().unwrap();
            all.push((n, before as u64, String::new()));
        }
        let block = &mut all.last_mut().unwrap().2;
        block.push_str(line);
        block.push('\n');
    }
    all
}

#[test]
fn what_is_written_passes_whole_and_by_blocks() {
    let text = written("3..=20", None);
    let checked = check(&text).unwrap();
    assert_eq!((checked.kind, checked.range), ("cover", Some(3..=20)));
    assert_eq!(checked.lines, text.lines().count() as u64);
    for (n, before, block) in blocks(&text) {
        check_block(n, block.as_bytes(), before).unwrap();
        assert!(check_block(n + 1, block.as_bytes(), before).is_err());
    }
    let large = written("128", None);
    check(&large).unwrap();
}

/// The block of n = 3 shown in the documentation, and its failing variants.
#[test]
fn the_example_in_the_documentation_is_a_block() {
    let source =
        fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../checker/src/cover/mod.rs")).unwrap();
    let start = source.find("//! n 3 2/3").unwrap();
    let shown: Vec<&str> = source[start..]
        .lines()
        .map(|line| line.trim_start_matches("//! "))
        .take_while(|line| *line != "```")
        .collect();
    let block = shown.join("\n") + "\n";
    check_block(3, block.as_bytes(), 5).unwrap();
    for (from, to) in [
        ("2/3 22", "2/3 21"),
        ("rN2,1;snn", "rnsnn"),
        ("rp1;P;", "rp1;M;"),
        ("sM;m2l;", "sM;m2;"),
        ("sM;M;sM;M;", "M;M;"),
    ] {
        assert!(block.contains(from));
        let answer = check_block(3, block.replacen(from, to, 1).as_bytes(), 5).unwrap_err().to_string();
        let wrapped = source.replace("\n//!", " ").split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(wrapped.contains(&answer), "{answer}");
    }
}

// ---- The plainest reading: boxes as exact fractions, claims at points by the crate's enclosures.

fn rational((p, q): Fraction) -> BigRational {
    BigRational::new(p.into(), q.into())
}

fn fraction(word: &str) -> Option<Fraction> {
    let (p, q) = word.split_once('/')?;
    let (p, q): (i128, i128) = (p.parse().ok()?, q.parse().ok()?);
    (q > 0).then_some((p, q))
}

/// The strips of period n, with the case of those that are intervals.
fn strips(n: i128) -> Vec<(Fraction, Fraction, Option<Case>)> {
    let theorem = common::theorem(n);
    let mut cuts: Vec<BigRational> = (0..=n).map(|j| rational((j, 2 * n))).collect();
    cuts.extend(theorem.iter().flat_map(|interval| [rational(interval.0), rational(interval.1)]));
    cuts.sort();
    cuts.dedup();
    let small = |x: &BigRational| -> Fraction {
        (i128::try_from(x.numer()).unwrap(), i128::try_from(x.denom()).unwrap())
    };
    cuts.windows(2)
        .map(|pair| {
            let case = theorem
                .iter()
                .find(|interval| rational(interval.0) == pair[0] && rational(interval.1) == pair[1])
                .map(|&(_, _, emu, gamma)| Case::from_signs(emu > 0, emu * gamma > 0));
            (small(&pair[0]), small(&pair[1]), case)
        })
        .collect()
}

/// A leaf with its box [r] × [s] and what its strip's interval claims.
struct Found {
    n: u64,
    token: String,
    r: [BigRational; 2],
    s: [BigRational; 2],
    case: Option<Case>,
}

/// Every leaf of a certificate; `None` if its text is not of the documented form.
fn read(text: &str) -> Option<Vec<Found>> {
    let mut lines = text.lines();
    let header: Vec<&str> = lines.by_ref().take(5).collect();
    let range: Vec<u64> =
        header.get(2)?.strip_prefix("range ")?.split(' ').map(|w| w.parse().unwrap()).collect();
    let mut all = Vec::new();
    for n in range[0]..=range[1] {
        let words: Vec<&str> = lines.next()?.split(' ').collect();
        let (["n", period, r_max, leaves], before) = (&words[..], all.len()) else { return None };
        let r_max = rational(fraction(r_max)?);
        (period.parse() == Ok(n)).then_some(())?;
        (lines.next()? == "identity region2" && lines.next()? == "identity region4").then_some(())?;
        for (left, right, case) in strips(n.into()) {
            let words: Vec<&str> = lines.next()?.split(' ').collect();
            (words == ["strip", &format!("{}/{}", left.0, left.1), &format!("{}/{}", right.0, right.1)])
                .then_some(())?;
            let visit = |token: &str, r: [BigRational; 2], s: [BigRational; 2]| {
                if !["r", "s"].contains(&token) {
                    all.push(Found { n, token: token.trim_end_matches(';').into(), r, s, case });
                }
            };
            walk(&spelled_out(lines.next()?)?, [rational(left), rational(right)], &r_max, visit)?;
        }
        (leaves.parse() == Ok(all.len() - before)).then_some(())?;
    }
    lines.next().is_none().then_some(all)
}

/// The trees of a strip with every `n` replaced by what it repeats; `None` if there is no such thing.
fn spelled_out(line: &str) -> Option<String> {
    let mut latest = None;
    tokens(line)
        .into_iter()
        .map(|token| match token {
            "n" => latest,
            _ if token.starts_with('N') => {
                latest = Some(token);
                latest
            }
            _ => Some(token),
        })
        .collect()
}

/// Hands every token of a strip's trees with its box to `visit`; `None` if the text is no tree for every row.
fn walk(
    text: &str,
    strip: [BigRational; 2],
    r_max: &BigRational,
    mut visit: impl FnMut(&str, [BigRational; 2], [BigRational; 2]),
) -> Option<()> {
    let middle = |x: &[BigRational; 2]| (&x[0] + &x[1]) / BigInt::from(2);
    let mut tokens = tokens(text).into_iter();
    let mut low = BigRational::from_integer(0.into());
    while low < *r_max {
        let high = middle(&[low.clone(), BigRational::from_integer(1.into())]).min(r_max.clone());
        let mut pending = vec![([low, high.clone()], strip.clone())];
        while let Some((r, s)) = pending.pop() {
            let token = tokens.next()?;
            visit(token, r.clone(), s.clone());
            match token {
                "r" => {
                    let m = middle(&r);
                    let [low, high] = r;
                    pending.extend([([m.clone(), high], s.clone()), ([low, m], s)]);
                }
                "s" => {
                    let m = middle(&s);
                    let [left, right] = s;
                    pending.extend([(r.clone(), [m.clone(), right]), (r, [left, m])]);
                }
                _ => token.ends_with(';').then_some(())?,
            }
        }
        low = high;
    }
    tokens.next().is_none().then_some(())
}

static LADDER: LazyLock<Ladder> = LazyLock::new(|| Ladder::new(1 << 12));

impl Found {
    /// The point at i/97 of the box's width in r, j/97 in s; `None` where u_n = 0 or r = 0.
    fn point(&self, i: u64, j: u64) -> Option<Point> {
        let at =
            |x: &[BigRational; 2], i: u64| &x[0] + (&x[1] - &x[0]) * BigRational::new(i.into(), 97.into());
        let polar = Polar::new(at(&self.r, i), at(&self.s, j)).ok()?;
        (!polar.is_singular(self.n)).then_some(Point::Polar(polar))
    }

    /// The sign of N_{n,k} at a point.
    fn sign(&self, point: &Point, k: u64) -> i8 {
        let Point::Polar(polar) = point else { unreachable!() };
        let number = |sign: Sign| match sign {
            Sign::Negative => -1,
            Sign::Zero => 0,
            Sign::Positive => 1,
        };
        match LADDER.sign(point, Quantity::B { n: self.n, k }).answer {
            Answer::Sign(sign) => number(sign) * number(polar.u_sign(self.n)),
            answer => panic!("{answer:?}"),
        }
    }

    /// Whether the claim holds at some points, one above and one right of the first, and is what the
    /// conjecture says there.
    fn holds_at(&self, i: u64, j: u64) -> bool {
        let points = [(i, j), ((i + 97) / 2, j), (i, (j + 97) / 2)].map(|(i, j)| self.point(i, j));
        let [Some(point), Some(above), Some(right)] = points else { return true };
        let leaf = Leaf::parse(&self.token, self.n).unwrap();
        let all = |point: &Point, t| (1..self.n).all(|k| self.sign(point, k) == t);
        let exists = all(&point, 1) || all(&point, -1);
        let sign = |positive| if positive { 1 } else { -1 };
        let holds = match leaf {
            Leaf::None { positive, negative } => {
                self.sign(&point, positive) == 1 && self.sign(&point, negative) == -1
            }
            Leaf::Orbit { positive } => all(&point, sign(positive)),
            Leaf::Edge { positive, deciding, across } => {
                let t = sign(positive);
                let side = |point: &Point| t * self.sign(point, deciding);
                let grows = |a: &Point, b: &Point| side(a) <= side(b);
                exists == (side(&point) == 1)
                    && (!exists || all(&point, t))
                    && grows(&point, &above)
                    && (across <= 0 || grows(&point, &right))
                    && (across >= 0 || grows(&right, &point))
            }
            Leaf::Open => true,
        };
        let claim = claimed(&LADDER, &point, self.n, Variant::True);
        let as_claimed = match claim {
            Claim::Orbit(case) => exists && self.case == Some(case),
            _ => !exists,
        };
        holds && as_claimed
    }
}

/// Whether the text is of the form documented and every leaf holds at a few points.
fn is_true(text: &str) -> bool {
    let Some(leaves) = read(text) else { return false };
    leaves
        .iter()
        .all(|leaf| [(1, 1), (1, 95), (95, 1), (95, 95), (48, 48)].iter().all(|&(i, j)| leaf.holds_at(i, j)))
}

#[test]
fn leaves_hold_at_random_points() {
    let leaves = read(&written("3..=24", None)).unwrap();
    let mut runner = TestRunner::deterministic();
    let strategy = (any::<Index>(), 1u64..97, 1u64..97);
    for _ in 0..10_000 {
        let (at, i, j) = strategy.new_tree(&mut runner).unwrap().current();
        let leaf = &leaves[at.index(leaves.len())];
        assert!(leaf.holds_at(i, j), "n = {}, {} at {i}, {j}: {:?} {:?}", leaf.n, leaf.token, leaf.r, leaf.s);
    }
}

// ---- Damage.

#[derive(Debug, Clone)]
enum Damage {
    /// Change a byte.
    Byte(Index, u8),
    /// Put a byte in.
    Insert(Index, u8),
    /// A token of a tree is removed, doubled, exchanged with another, or replaced.
    Remove(Index),
    Duplicate(Index),
    Swap(Index, Index),
    Replace(Index, String),
    /// A leaf, or a whole subtree, is replaced by a leaf, and the number of leaves is set right.
    Prune(Index, String),
    /// Another index in a leaf.
    Shift(Index, u8),
    RemoveLine(Index),
    SwapLines(Index, Index),
    Truncate(Index),
    RMax(Index, u64, u64),
}

fn damage() -> impl Strategy<Value = Damage> {
    let index = any::<Index>;
    let leaf = || {
        prop_oneof![
            (1..6u8, 1..6u8).prop_map(|(k, j)| format!("N{k},{j};")),
            prop::sample::select(vec!["P;", "M;", "n"]).prop_map(String::from),
            ("[pm]", 1..6u8, "[lr]?").prop_map(|(t, d, across)| format!("{t}{d}{across};")),
        ]
    };
    prop_oneof![
        4 => (index(), prop::sample::select(b"0123456789rsnNPMpmlru,;/ O".to_vec())).prop_map(|(at, byte)| Damage::Byte(at, byte)),
        1 => index().prop_map(Damage::Remove),
        1 => index().prop_map(Damage::Duplicate),
        2 => (index(), index()).prop_map(|(a, b)| Damage::Swap(a, b)),
        2 => (index(), prop::sample::select(vec!["r", "s", "n", "N1,2;", "O;"])).prop_map(|(at, to)| Damage::Replace(at, to.into())),
        2 => (index(), prop::sample::select(b"0123456789rsnNPMpmlru,;/ O\r\n".to_vec())).prop_map(|(at, byte)| Damage::Insert(at, byte)),
        8 => (index(), leaf()).prop_map(|(at, leaf)| Damage::Prune(at, leaf)),
        4 => (index(), 1..4u8).prop_map(|(at, by)| Damage::Shift(at, by)),
        1 => index().prop_map(Damage::RemoveLine),
        1 => (index(), index()).prop_map(|(a, b)| Damage::SwapLines(a, b)),
        1 => index().prop_map(Damage::Truncate),
        1 => (index(), 1..40u64, 2..40u64).prop_map(|(at, p, q)| Damage::RMax(at, p, q)),
    ]
}

/// The tokens of a line of trees.
fn tokens(line: &str) -> Vec<&str> {
    line.split_inclusive(|c| ";rsn".contains(c))
        .flat_map(|part| {
            // The r that ends an edge leaf is not a split.
            let split = part.len() - usize::from(part.len() > 1 && !part.ends_with(';'));
            [&part[..split], &part[split..]]
        })
        .filter(|token| !token.is_empty())
        .fold(Vec::new(), |mut all: Vec<&str>, token| {
            match all.last_mut() {
                Some(last) if !last.ends_with(';') && !["r", "s", "n"].contains(last) => {
                    // Glue what belongs to one leaf.
                    let start = last.as_ptr() as usize - line.as_ptr() as usize;
                    let end = token.as_ptr() as usize - line.as_ptr() as usize + token.len();
                    *last = &line[start..end];
                }
                _ => all.push(token),
            }
            all
        })
}

/// The number of tokens of the subtree that begins at `at`.
fn subtree(tokens: &[&str], at: usize) -> usize {
    let mut missing = 1;
    let mut length = 0;
    while missing > 0 && at + length < tokens.len() {
        missing = if ["r", "s"].contains(&tokens[at + length]) { missing + 1 } else { missing - 1 };
        length += 1;
    }
    length
}

fn damaged(text: &str, damage: &Damage) -> String {
    let mut lines: Vec<String> = text.lines().map(String::from).collect();
    let trees: Vec<usize> = (6..lines.len()).filter(|&i| lines[i - 1].starts_with("strip ")).collect();
    let places: Vec<(usize, usize)> =
        trees.iter().flat_map(|&i| (0..tokens(&lines[i]).len()).map(move |j| (i, j))).collect();
    let mut edit = |at: &Index, change: &dyn Fn(&mut Vec<String>, usize)| {
        let (i, j) = places[at.index(places.len())];
        let mut all: Vec<String> = tokens(&lines[i]).into_iter().map(String::from).collect();
        change(&mut all, j);
        lines[i] = all.concat();
        i
    };
    match damage {
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
        Damage::Remove(at) => drop(edit(at, &|all, j| drop(all.remove(j)))),
        Damage::Duplicate(at) => drop(edit(at, &|all, j| all.insert(j, all[j].clone()))),
        Damage::Swap(a, b) => drop(edit(a, &|all, j| all.swap(j, b.index(j + 1)))),
        Damage::Replace(at, to) => drop(edit(at, &|all, j| all[j].clone_from(to))),
        Damage::Shift(at, by) => drop(edit(at, &|all, j| {
            all[j] = all[j]
                .chars()
                .map(|c| {
                    c.to_digit(10).map_or(c, |d| char::from_digit((d + u32::from(*by)) % 10, 10).unwrap())
                })
                .collect();
        })),
        Damage::Prune(at, leaf) => {
            let line = edit(at, &|all, j| {
                let length = subtree(&all.iter().map(String::as_str).collect::<Vec<_>>(), j);
                all.splice(j..j + length, [leaf.clone()]);
            });
            recount(&mut lines, line);
        }
        Damage::RemoveLine(at) => drop(lines.remove(at.index(lines.len()))),
        Damage::SwapLines(a, b) => {
            let (a, b) = (a.index(lines.len()), b.index(lines.len()));
            lines.swap(a, b);
        }
        Damage::Truncate(at) => return text[..at.index(text.len())].to_string(),
        Damage::RMax(at, p, q) => {
            let heads: Vec<usize> = (5..lines.len()).filter(|&i| lines[i].starts_with("n ")).collect();
            let line = &mut lines[heads[at.index(heads.len())]];
            let words: Vec<&str> = line.split(' ').collect();
            *line = format!("n {} {p}/{q} {}", words[1], words[3]);
        }
    }
    lines.join("\n") + "\n"
}

/// Sets the number of leaves of the block that holds `line`.
fn recount(lines: &mut [String], line: usize) {
    let head = (5..=line).rev().find(|&i| lines[i].starts_with("n ")).unwrap();
    let leaves: usize = lines[head + 1..]
        .iter()
        .take_while(|line| !line.starts_with("n "))
        .filter(|line| !line.contains(' '))
        .map(|line| line.matches([';', 'n']).count())
        .sum();
    let words: Vec<&str> = lines[head].split(' ').collect();
    lines[head] = format!("{} {} {} {leaves}", words[0], words[1], words[2]);
}

#[test]
fn tokens_are_split_as_they_are_joined() {
    assert_eq!(
        tokens("rsN2,1;np1r;nm3l;snP;M;O;"),
        ["r", "s", "N2,1;", "n", "p1r;", "n", "m3l;", "s", "n", "P;", "M;", "O;"]
    );
    assert_eq!(subtree(&tokens("rsN2,1;nP;M;"), 0), 5);
}

/// Thousands of damaged certificates; the few that pass are true at points by enclosures.
#[test]
fn damage_is_detected() {
    let text = written("3..=6", None);
    assert!(is_true(&text));
    let mut runner = common::runner(1);
    let (mut rejected, mut unchanged, mut still_true, mut open) = (0, 0, 0, 0);
    let strategy = damage();
    for _ in 0..samples::<u64>(3_000) {
        let damage = strategy.new_tree(&mut runner).unwrap().current();
        let changed = damaged(&text, &damage);
        match check(&changed) {
            _ if changed == text => unchanged += 1,
            Ok(_) => {
                assert!(is_true(&changed), "accepted though false, after {damage:?}:\n{changed}");
                still_true += 1;
            }
            Err(Rejection::Undecided { .. }) => open += 1,
            Err(_) => rejected += 1,
        }
    }
    println!("{rejected} rejected, {open} undecided, {still_true} still true, {unchanged} unchanged");
    assert!(2 * (unchanged + open + still_true) < rejected);
    assert!(tried(still_true, 10) && tried(open, 10), "other witnesses pass, open leaves leave it undecided");
}

// ---- Wrong rules, wrong conclusions.

/// Without the remainder, signs that are false would be shown; with it, they are not.
#[test]
fn the_remainder_is_needed() {
    let n = 12;
    let context = Precision::new(128);
    let (mut caught, mut at_once) = (0, 0);
    // High and narrow boxes: r^p is far from its parabola.
    for s in (1..1 << 12).map(|i| (1u64 << 63) / (1 << 12) * i) {
        let powers = Powers::new(n, [0, ONE / 2]).unwrap();
        let waves = Waves::new(n, [s, s + (1 << 30)], Form::Sine).unwrap();
        let patch = Patch::new(&powers, &waves);
        for (k, term) in (1..n).zip(patch.terms()) {
            let expansion = term.expansion();
            let cut = Expansion { d: [0; 4], ..expansion };
            let at = |bits| BigRational::new(s.into(), BigInt::from(1) << bits);
            let top = value(n, k, &BigRational::new(1.into(), 2.into()), &at(64), Form::Sine, &context);
            for (t, wrong) in [(1, Sign::Negative), (-1, Sign::Positive)] {
                if top.sign() == Some(wrong) {
                    assert!(!expansion.shows(t, patch.slack) && !term.shows(t));
                    caught += u32::from(cut.shows(t, patch.slack));
                    // Nor by the constant alone, or the linear polynomial.
                    let [constant, across, up, ..] = cut.c.map(|c| t * c);
                    at_once += u32::from(constant > across.abs() + up.abs());
                }
            }
        }
    }
    assert!(
        caught > 0 && at_once > 0,
        "no false sign is shown without the remainder: the test shows nothing"
    );
}

/// With w < 0 allowed, T_d > 0 would "decide" T_k where it does not.
#[test]
fn a_negative_w_is_refused() {
    let n = 8;
    let mut caught = 0;
    for i in 0..40 {
        for j in 0..40 {
            let r = [ONE / 100 * (55 + i), ONE / 100 * (55 + i) + ONE / 200];
            let s = [(1u64 << 63) / 50 * (j + 5), (1u64 << 63) / 50 * (j + 5) + (1 << 63) / 200];
            let (Ok(powers), Ok(waves)) = (Powers::new(n, r), Waves::new(n, s, Form::Sine)) else { continue };
            let patch = Patch::new(&powers, &waves);
            let all: Vec<Expansion> = patch.terms().map(|term| term.expansion()).collect();
            for (k, d) in (0..7).flat_map(|k| (0..7).map(move |d| (k, d))).filter(|(k, d)| k != d) {
                let (one_k, one_d) = (&all[k], &all[d]);
                // T_k + v T_d > 0 for some v > 0, though T_k < 0 < T_d at the centre.
                let added = |v: i128| {
                    let sum = |a: i64, b: i64| (i128::from(a) + v * i128::from(b) / 16) as i64;
                    let c = std::array::from_fn(|i| sum(one_k.c[i], one_d.c[i]));
                    Expansion { c, d: std::array::from_fn(|i| sum(one_k.d[i], one_d.d[i])) }
                };
                let false_claim = one_k.c[0] < -(1 << 30) && one_d.c[0] > 1 << 30;
                if false_claim && (1..32).any(|v| added(v).shows(1, 4 * patch.slack)) {
                    assert!(!one_k.shows(1, patch.slack) && !one_k.shows_beyond(one_d, 1, patch.slack));
                    caught += 1;
                }
            }
        }
    }
    assert!(caught > 0, "nothing is shown by a negative w: the test shows nothing");
}

/// At the least coefficient that suffices and one unit below: every part of the rest and of rounding counts,
/// as often as it should.
#[test]
fn bounds_are_met_to_the_unit() {
    let (slack, d) = (1i64 << 20, [1i64 << 10, 1 << 12, 1 << 14, 1 << 16]);
    let (rest, [d30, d21, d12, d03]) = (d.iter().sum::<i64>(), d);
    for (t, extra) in [(1, 0), (1, 1), (-1, 0), (-1, 1)] {
        let need = 17 + 13 + 11 + 5 + rest + slack + extra;
        assert_eq!(Expansion { c: [t * need, 17, -13, -5 * t, 11, 9 * t], d }.shows(t, slack), extra == 1);
        let up = 2 * 5 + 11 + 3 * d30 + 2 * d21 + d12 + 3 * slack + extra;
        let right = 2 * 9 + 11 + 3 * d03 + 2 * d12 + d21 + 3 * slack + extra;
        let slopes = Expansion { c: [0, t * up, -t * right, 5, -11, 9], d }.slopes(slack);
        assert_eq!(slopes, [t * extra, -t * extra]);
        // w = 1: both rests, and rounding twice.
        let decider = Expansion { c: [0, 1 << 40, 0, 0, 0, 0], d };
        let beyond = Expansion { c: [t * (2 * rest + 2 * slack + extra), 1 << 40, 0, 0, 0, 0], d };
        assert_eq!(beyond.shows_beyond(&decider, t, slack), extra == 1);
    }
}

/// An Edge leaf is put in the place of every part of every tree: each condition is the one that fails
/// somewhere.
#[test]
fn every_condition_of_an_edge_is_asked_for() {
    let text = written("3..=8", None);
    let lines: Vec<String> = text.lines().map(String::from).collect();
    let mut reasons = String::new();
    for (at, line) in lines.iter().enumerate().filter(|(_, line)| !line.contains(' ')) {
        let all = tokens(line);
        let Some(edge) = all.iter().find(|token| token.starts_with(['p', 'm'])) else { continue };
        for j in 0..all.len() {
            let mut tree = all.clone();
            tree.splice(j..j + subtree(&all, j), [*edge]);
            let mut changed = lines.clone();
            changed[at] = tree.concat();
            recount(&mut changed, at);
            if let Err(rejection) = check(&(changed.join("\n") + "\n")) {
                reasons += &rejection.to_string();
            }
        }
    }
    for reason in
        ["that N_{", "no N has the sign on the whole box", "grows with r is not shown", "out of order"]
    {
        assert!(reasons.contains(reason), "{reason}");
    }
}

#[test]
fn false_conclusions_are_rejected() {
    let text = written("8", None);
    let (_, before, block) = blocks(&text).remove(0);
    let lines: Vec<&str> = block.lines().collect();
    let rejected = |change: &dyn Fn(&mut Vec<String>)| {
        let mut changed: Vec<String> =
            text.lines().take(5).chain(lines.iter().copied()).map(String::from).collect();
        change(&mut changed);
        recount(&mut changed, 5);
        let block = changed[5..].join("\n") + "\n";
        check_block(8, block.as_bytes(), before).unwrap_err().to_string()
    };
    let trees = |strip: &str| text.lines().position(|line| line == strip).unwrap() + 1;
    // The area of (1/3, 3/8) as one of another strip; no area there at all; one where there is none.
    let (area, gap) = (trees("strip 1/3 3/8"), trees("strip 5/16 1/3"));
    assert!(rejected(&|all| all[area - 1] = "strip 5/16 3/8".into()).contains("expected \"strip 1/3 3/8\""));
    assert!(rejected(&|all| all.swap(area, gap)).contains("false"));
    assert!(rejected(&|all| all.swap(area - 1, gap - 1)).contains("expected \"strip 5/16 1/3\""));
    let emptied = rejected(&|all| all[area] = all[area].replace("M;", "N1,2;"));
    assert!(emptied.contains("is not shown"), "{emptied}");
    // Other signs, another deciding index.
    assert!(
        rejected(&|all| all[area] = all[area].replace("M;", "P;"))
            .contains("not that of the strip's interval")
    );
    let deciding =
        tokens(lines[area - 5]).iter().find(|token| token.starts_with('m')).unwrap()[1..2].to_string();
    let other = rejected(&|all| all[area] = all[area].replace(&format!("m{deciding}"), "m4"));
    assert!(other.contains("not that of the strip's interval"), "{other}");
    // The row at the top without what makes it one interval.
    assert!(rejected(&|all| all[area] = all[area].replace("r;", ";")).contains("not one area"));
    assert!(rejected(&|all| all[area] = all[area].replace("l;", ";")).contains("not one area"));
    assert!(rejected(&|all| all[area] = all[area].replace("l;", "r;")).contains("false"));
    // In the first strip nothing but orbits.
    let first = trees("strip 0/1 1/16");
    assert!(rejected(&|all| all[first] = all[first].replacen("M;", "N1,2;", 1)).contains("its whole strip"));
    // r_max so low that the areas are not reached: every leaf holds, but there is no area.
    let low = "n 3 1/3 8\nidentity region2\nidentity region4\nstrip 0/1 1/6\nsM;M;\nstrip 1/6 1/3\nssM;m2l;sm2l;N2,1;\nstrip 1/3 1/2\nsN2,1;N2,1;\n";
    let answer = check_block(3, low.as_bytes(), 5).unwrap_err().to_string();
    assert!(
        answer.contains("the leaves of (1/3, 1/2) are not one area: at the top, there is no orbit leaf"),
        "{answer}"
    );
}

#[test]
fn an_open_leaf_leaves_it_undecided() {
    let text = written("4", None);
    let mut lines: Vec<String> = text.lines().map(String::from).collect();
    let strip = lines.iter().position(|line| line == "strip 1/3 3/8").unwrap() + 1;
    let mut all = tokens(&lines[strip]);
    // The last one: no n after it repeats it.
    let last = all.iter().rposition(|token| token.starts_with(['N', 'n'])).unwrap();
    // In a corner of its box only: what is left open must not round to nothing.
    let claim = all[..=last].iter().rfind(|token| token.starts_with('N')).unwrap();
    let corner = format!("{}O;{}", "rs".repeat(27), claim.repeat(54));
    all[last] = &corner;
    lines[strip] = all.concat();
    recount(&mut lines, strip);
    let opened = lines.join("\n") + "\n";
    let rejection = check(&opened).unwrap_err();
    assert!(rejection.to_string().contains(": all else being proved, 1 leaves are open"), "{rejection}");
    assert!(rejection.to_string().contains("e-20 in (r, s)"), "{rejection}");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("open");
    fs::write(&path, &opened).unwrap();
    assert_eq!(exit_code(&path), 3);
    fs::write(&path, &text).unwrap();
    assert_eq!(exit_code(&path), 0);
    fs::write(&path, text.replacen("M;", "P;", 1)).unwrap();
    assert_eq!(exit_code(&path), 1);
}

fn exit_code(path: &Path) -> i32 {
    let output = Command::new(crate::PROGRAM).arg("check").arg(path).output().unwrap();
    output.status.code().unwrap()
}

// ---- The checker's arithmetic against the crate's balls.

fn scaled(x: &Ball, centre: i64) -> (BigRational, BigRational) {
    let (lo, hi) = x.exact_bounds().unwrap();
    let unit = BigRational::from_integer(BigInt::from(1) << 60);
    let centre = BigRational::from_integer(centre.into());
    (lo * &unit - &centre, hi * &unit - centre)
}

fn within(x: &Ball, centre: i64, bound: i64) -> bool {
    let (lo, hi) = scaled(x, centre);
    let bound = BigRational::from_integer(bound.into());
    lo >= -bound.clone() && hi <= bound
}

/// T_{n,k} or, divided by n sin θ, Q_{n,k}/n.
fn value(n: u64, k: u64, r: &BigRational, s: &BigRational, form: Form, context: &Precision) -> Ball {
    let angle = Angle::new(&(s * BigInt::from(2)));
    let sine = |q: u64| Ball::sin(&angle.times(q), context);
    let power = |p: u64| Ball::ratio(&num_traits::pow(r.clone(), p as usize), context);
    let t = power(n - k) * &sine(n) - &(power(n) * &sine(n - k)) - &sine(k);
    match form {
        Form::Sine => t,
        Form::Quotient => t / &(sine(1) * &Ball::integer(n as i32, context)),
    }
}

proptest! {
    #![proptest_config(common::config())]

    #[test]
    fn sines_are_within_their_bounds(turns: u64, shift in 0u32..64, n in 1u64..200) {
        let context = Precision::new(128);
        let turns = turns >> shift;
        let angle = Angle::new(&BigRational::new(turns.into(), BigInt::from(1) << 63));
        let (sine, cosine) = sine_cosine(turns);
        prop_assert!(within(&Ball::sin(&angle, &context), sine, 4));
        prop_assert!(within(&Ball::cos(&angle, &context), cosine, 4));
        let (sine, cosine) = sines_cosines(turns, n).last().unwrap();
        prop_assert!(within(&Ball::sin(&angle.times(n), &context), sine, 14));
        prop_assert!(within(&Ball::cos(&angle.times(n), &context), cosine, 14));
    }

    /// At a random point of a random box, T is what the expansion says, within its remainder and rounding.
    #[test]
    fn expansions_enclose(
        n in 3u64..=200, k in any::<Index>(), row in 0u32..24, place in 0u64..1 << 20, [wr, ws] in [0u32..30, 0u32..40],
        at in 0u64..1 << 20, [i, j] in [0i64..=16, 0i64..=16], quotient: bool,
    ) {
        let k = 1 + k.index(n as usize - 1) as u64;
        // A box within a row, and no wider in s than a strip.
        let low = ONE - (ONE >> row);
        let width = (ONE >> (row + 1)) >> wr;
        let r0 = low + ((((ONE >> (row + 1)) - width) as i128 * i128::from(place)) >> 20) as i64;
        let strip = (1u64 << 63) / n;
        let s_width = strip >> ws;
        let s0 = ((((1u64 << 63) - s_width) as u128 * u128::from(at)) >> 20) as u64;
        let (form, s_steps) = if quotient { (Form::Quotient, j.clamp(1, 15)) } else { (Form::Sine, j) };
        let powers = Powers::new(n, [r0, r0 + width]).unwrap();
        let waves = Waves::new(n, [s0, s0 + s_width], form).unwrap();
        let patch = Patch::new(&powers, &waves);
        let expansion = patch.expansion(k);
        let from_all = patch.terms().nth(k as usize - 1).unwrap().expansion();

        let at = |lo: i128, width: i128, i: i64, bits: u32| {
            BigRational::new(BigInt::from(lo * 16 + width * i128::from(i)), BigInt::from(16) << bits)
        };
        let r = at(r0.into(), width.into(), i, 60);
        let s = at(s0.into(), s_width.into(), s_steps, 64);
        let value = value(n, k, &r, &s, form, &Precision::new(320));
        for expansion in [expansion, from_all] {
            let c = expansion.c.map(|c| BigRational::from_integer(c.into()));
            let half = |width: i128| BigRational::from_integer((width - width / 2).into());
            let x = (BigRational::new(BigInt::from(width) * i, 16.into()) - BigRational::from_integer((width / 2).into())) / half(width.into());
            let y = (BigRational::new(BigInt::from(s_width) * s_steps, 16.into()) - BigRational::from_integer((s_width / 2).into())) / half(s_width.into());
            let polynomial = &c[0] + &c[1] * &x + &c[2] * &y + &c[3] * &x * &x + &c[4] * &x * &y + &c[5] * &y * &y;
            // η is rounded up by at most 3 units of 2⁻⁶⁰, which changes y by that over η ≥ 0.39 s_width/2.
            let eta = BigRational::new(BigInt::from(20), BigInt::from(s_width));
            let turned: BigInt = expansion.c[1..].iter().map(|c| BigInt::from(c.abs())).sum();
            let rest: i128 = expansion.d.iter().map(|&d| i128::from(d)).sum::<i128>() + i128::from(patch.slack);
            let bound = BigRational::from_integer(rest.into()) + eta * turned;
            let (lo, hi) = scaled(&value, 0);
            prop_assert!(lo >= &polynomial - &bound && hi <= &polynomial + &bound, "{expansion:?}, {:?}", (lo, polynomial));
            for t in [-1, 1] {
                if expansion.shows(t, patch.slack) || patch.shows(k, t) {
                    prop_assert_eq!(value.sign(), Some(if t > 0 { Sign::Positive } else { Sign::Negative }));
                }
            }
        }
    }
}
