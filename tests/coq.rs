//! The Coq development under `proofs/coq` says and rests on what is pinned there (`check.sh`), and what the
//! built `grazing` prints agrees with functions that Coq has proved: those of `StatementZ.v` and
//! `StatementCircleZ.v`, extracted to OCaml. So do the checker's verdicts with the readers of certificates of
//! `StatementReaders.v`, `StatementReaderWords.v`, `StatementGrowth.v`, `StatementPaths.v`,
//! `StatementRanges.v` and `StatementTraps.v`.
//!
//! Without `coqc` (for the second, an OCaml compiler too) on the PATH nothing is checked and stderr says so;
//! with `GRAZING_REQUIRE_COQ=1` that is a failure.

use std::collections::{BTreeMap, BTreeSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;
use std::{env, fs, thread};

#[path = "coq/circle.rs"]
mod circle;
#[path = "coq/readers.rs"]
mod readers;
#[path = "samples/mod.rs"]
mod samples;

/// First by its name: it takes longest, and two processors from the start.
#[test]
fn check_sh_accepts_the_development() {
    let Some(version) = version("coqc", "the Coq development checked", "coq") else { return };
    let build = folder("coq");
    let sources = sources();
    let mut hasher = DefaultHasher::new();
    // What was checked with less is checked again.
    (&sources, version, std::env::var_os("GRAZING_COQCHK")).hash(&mut hasher);
    let (stamp, digest) = (build.with_extension("stamp"), hasher.finish().to_string());
    if fs::read_to_string(&stamp).ok().as_ref() == Some(&digest) {
        return;
    }
    let _ = fs::remove_file(&stamp);
    place(&build, &sources);
    run(&build, "sh", &["check.sh"]);
    fs::write(&stamp, digest).unwrap();
}

/// The folder with the extracted functions, compiled; `None` without Coq or an OCaml compiler.
fn oracle() -> Option<PathBuf> {
    static BUILT: OnceLock<Option<PathBuf>> = OnceLock::new();
    BUILT.get_or_init(build_oracle).clone()
}

fn build_oracle() -> Option<PathBuf> {
    let notice = "grazing compared with the proved functions";
    version("coqc", notice, "coq")?;
    if !["ocamlopt", "ocamlc"].into_iter().any(runs) {
        missing("ocamlopt or ocamlc", notice, "ocaml-nox");
    }
    let build = folder("oracle");
    place(&build, &sources());
    run(&build, "sh", &["reader.sh", "."]);
    Some(build)
}

#[test]
fn grazing_prints_what_is_proved() {
    let Some(build) = oracle() else { return };
    let points = points();
    let classified = points.iter().flat_map(|point| (1..=point.largest).map(move |n| (point.clone(), n)));
    let evaluated = points.iter().enumerate().map(|(i, point)| {
        // Up to 30 where numbers are short.
        let least = point.largest.min(5);
        (point.clone(), least + i * 7 % (2 * point.largest - least - 1))
    });
    let answers = ask(&build, classified.chain(evaluated).collect());
    let (mut verdicts, signs) = answers.split_at(points.iter().map(|point| point.largest).sum());

    let mut kinds = BTreeMap::new();
    for point in &points {
        let (proved, rest) = verdicts.split_at(point.largest);
        verdicts = rest;
        for (n, kind) in (1..).zip(compare_classify(point, proved)) {
            *kinds.entry((n == 1, kind)).or_insert(0_usize) += 1;
        }
    }
    let compared: usize = signs.iter().map(compare_evaluate).sum();
    // Enough of each answer that may occur; 4 kinds for n >= 2, and the two of n = 1.
    for (first, kind, least) in [
        (false, "orbit", 400),
        (false, "none", 400),
        (false, "singular boundary", 50),
        (false, "iterate boundary", 50),
        (false, "sign boundary", 2),
        (true, "orbit", 100),
        (true, "sign boundary", 5),
    ] {
        let found = kinds.get(&(first, kind.to_owned())).copied().unwrap_or(0);
        assert!(found >= least, "only {found} of {kind}: {kinds:?}");
    }
    assert!(compared >= 2000, "only {compared} signs compared");
    println!("{compared} signs and {} verdicts compared: {kinds:?}", kinds.values().sum::<usize>());
}

/// Words: which periods occur, which may follow which, which patterns exist, against the functions proved in
/// `StatementWordsZ.v`, at the points with short numbers.
#[test]
fn grazing_prints_the_proved_words() {
    let Some(build) = oracle() else { return };
    let points: Vec<_> = points().into_iter().filter(|point| point.largest == 16).collect();
    let word = |point: &Rational| format!("word {} {} {} {LONGEST}", point.p, point.s, point.q);
    let proved = answers(&build, &points.iter().map(word).collect::<Vec<_>>());
    let patterns: Vec<Vec<usize>> = (1..=TURNS).flat_map(necklaces).collect();
    let pattern = |point: &Rational, pattern: &[usize]| {
        let periods: Vec<_> = pattern.iter().map(usize::to_string).collect();
        format!("pattern {} {} {} {}", point.p, point.s, point.q, periods.join(","))
    };
    let questions = points.iter().flat_map(|point| patterns.iter().map(|l| pattern(point, l)));
    let exist = answers(&build, &questions.collect::<Vec<_>>());

    let mut seen = WordsSeen::default();
    for ((point, words), exist) in points.iter().zip(&proved).zip(exist.chunks(patterns.len())) {
        let text = grazing_word(point);
        let Some(report) = text else { continue };
        seen.points += 1;
        for word in report["words"].as_array().unwrap() {
            let sign = word["sign_emu"].as_i64().unwrap() as i8;
            let members = &words[usize::from(sign < 0)];
            let last = compare_members(point, word, members, &mut seen);
            // Where every period occurs, the edges are listed up to `--max-period`.
            let edges = if word["end"]["kind"] == "all" { TURNS } else { last };
            for case in word["cases"].as_array().unwrap() {
                let signs = (sign, case["sign_gamma"].as_i64().unwrap() as i8);
                compare_edges(point, case, signs, edges, (&words[2..], members), &mut seen);
                if last == LONGEST {
                    compare_patterns(point, case, signs, &patterns, exist, &mut seen);
                }
            }
        }
    }
    println!("{seen:?}");
    let WordsSeen { points, members, absent, edges, no_edges, open, patterns } = seen;
    assert!(points >= 150 && members >= 1000 && absent >= 1000, "{points} {members} {absent}");
    assert!(edges >= 3000 && no_edges >= 3000 && open >= 10 && patterns >= 2000);
}

/// How many of each answer was compared.
#[derive(Default, Debug)]
struct WordsSeen {
    points: usize,
    members: usize,
    absent: usize,
    edges: usize,
    no_edges: usize,
    open: usize,
    patterns: usize,
}

/// Periods up to this one are held against the proved ones; patterns up to `TURNS` periods of the drive.
const LONGEST: usize = 10;
const TURNS: usize = 6;

/// The compositions of a number, one of each set that differ by a rotation.
fn necklaces(total: usize) -> Vec<Vec<usize>> {
    fn compositions(total: usize) -> Vec<Vec<usize>> {
        if total == 0 {
            return vec![Vec::new()];
        }
        let first = |n: usize| compositions(total - n).into_iter().map(move |rest| [vec![n], rest].concat());
        (1..=total).flat_map(first).collect()
    }
    let least = |l: &Vec<usize>| (0..l.len()).all(|k| *l <= [&l[k..], &l[..k]].concat());
    compositions(total).into_iter().filter(least).collect()
}

/// The report of `grazing word`; `None` where it has no word to report (on the two lines).
fn grazing_word(point: &Rational) -> Option<serde_json::Value> {
    let Rational { p, s, q, .. } = point;
    let output = Command::new(env!("CARGO_BIN_EXE_grazing"))
        .args(["word", "--format", "json", "--letters", "40", "--max-period", &TURNS.to_string()])
        .args([format!("--a1={p}/{q}"), format!("--a2={s}/{q}")])
        .output()
        .unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(matches!(output.status.code(), Some(0 | 3)), "{point:?}: {message}");
    serde_json::from_slice(&output.stdout).ok()
}

fn numbers(value: &serde_json::Value) -> Vec<usize> {
    value.as_array().unwrap().iter().map(|n| n.as_u64().unwrap() as usize).collect()
}

/// The periods of a word up to `LONGEST` are the proved members. Up to where the word tells them: 0 on the
/// two lines, where it has none.
fn compare_members(point: &Rational, word: &serde_json::Value, proved: &str, seen: &mut WordsSeen) -> usize {
    let periods = numbers(&word["periods"]);
    let kind = word["end"]["kind"].as_str().unwrap();
    let last = match kind {
        "complete" | "boundary" | "singular" | "all" => LONGEST,
        _ => periods.iter().copied().max().unwrap_or(0).min(LONGEST),
    };
    for (n, bit) in (1..=last).zip(proved.chars()) {
        let found = kind == "all" || periods.contains(&n);
        assert_eq!(found, bit == '1', "n = {n} of {word} at {point:?}");
        *(if found { &mut seen.members } else { &mut seen.absent }) += 1;
    }
    last
}

/// The edges between members up to `last` are the proved ones, and what is open is zero.
fn compare_edges(
    point: &Rational,
    case: &serde_json::Value,
    (emu, gamma): (i8, i8),
    last: usize,
    (signs, members): (&[String], &str),
    seen: &mut WordsSeen,
) {
    let pairs = |key: &str| -> BTreeSet<(usize, usize)> {
        let pair = |edge: &serde_json::Value| (numbers(edge)[0], numbers(edge)[1]);
        case[key].as_array().unwrap().iter().map(pair).collect()
    };
    let (edges, open) = (pairs("edges"), pairs("open"));
    let member = |n: usize| members.as_bytes()[n - 1] == b'1';
    let letters = (1..=last).filter(|&n| member(n)).collect::<Vec<_>>();
    for (&i, &j) in letters.iter().flat_map(|i| letters.iter().map(move |j| (i, j))) {
        let sign = match signs[i - 1].as_bytes()[j - 1] {
            b'+' => 1,
            b'-' => -1,
            _ => 0,
        };
        let at = || format!("{i} -> {j}, case ({emu}, {gamma}), at {point:?}: {case}");
        assert_eq!(edges.contains(&(i, j)), sign * emu * gamma > 0, "{}", at());
        assert_eq!(open.contains(&(i, j)), sign == 0, "{}", at());
        match sign * emu * gamma {
            1 => seen.edges += 1,
            0 => seen.open += 1,
            _ => seen.no_edges += 1,
        }
    }
}

/// The numbers of patterns of each period are those of the proved ones.
fn compare_patterns(
    point: &Rational,
    case: &serde_json::Value,
    signs: (i8, i8),
    patterns: &[Vec<usize>],
    exist: &[Vec<String>],
    seen: &mut WordsSeen,
) {
    let place = CASES.iter().position(|&case| case == signs).unwrap();
    for row in case["patterns"].as_array().unwrap() {
        let period = row["period"].as_u64().unwrap() as usize;
        let held = |(l, bits): &(&Vec<usize>, &Vec<String>)| {
            l.iter().sum::<usize>() == period && bits[0].as_bytes()[place] == b'1'
        };
        let proved = patterns.iter().zip(exist).filter(held).count();
        assert_eq!(row["all"].as_str().unwrap(), proved.to_string(), "{period} at {point:?}, {case}");
        seen.patterns += proved;
    }
}

/// Coq's theorem on chaos is about the oscillator and the boxes of the certificate, whose checker shares
/// nothing with it.
#[test]
fn chaos_has_the_certificates_boxes() {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let statement = fs::read_to_string(root.join("proofs/coq/StatementChaos.v")).unwrap();
    let certificate = fs::read_to_string(root.join("crates/checker/tests/data/chaos-12.txt")).unwrap();
    let line = |name: &str| -> Vec<&str> {
        let line = certificate.lines().find(|line| line.split(' ').next() == Some(name)).unwrap();
        line.split(' ').skip(1).collect()
    };
    assert_eq!(line("damping"), ["12/49", "12/49"]);
    assert_eq!(line("stiffness"), ["100/2401", "100/2401"]);
    assert_eq!(line("window"), ["1.2"]);
    // 2d/w = 12/49 and 1/w² = 100/2401.
    assert!(statement.contains("motion (Nordmark (3 / 5) (49 / 10) 1) Plus (- mu) (6 / 5)."));

    // Each bound is NUMBER / NUMBER * mu, perhaps - (NUMBER / NUMBER) * mu; in units of 1/10000.
    let (_, boxes) = statement.split_once("Definition in_two_boxes").unwrap();
    let (boxes, _) = boxes.split_once("Definition").unwrap();
    let mut stated: Vec<&str> = boxes.split(" * mu").collect();
    stated.pop();
    let stated: Vec<i64> = stated
        .iter()
        .map(|piece| {
            let bound = piece.rsplit(['>', '=', '\\']).next().unwrap();
            let parts = bound.split(|c: char| !c.is_ascii_digit()).filter(|part| !part.is_empty());
            let parts: Vec<i64> = parts.map(|part| part.parse().unwrap()).collect();
            assert_eq!((parts.len(), 10_000 % parts[1]), (2, 0), "{bound}");
            let size = parts[0] * (10_000 / parts[1]);
            if bound.contains('-') { -size } else { size }
        })
        .collect();
    let decimal = |word: &str| {
        let (whole, rest) = word.split_once('.').unwrap_or((word, ""));
        format!("{whole}{rest:0<4}").parse::<i64>().unwrap()
    };
    let letters = certificate.lines().filter_map(|line| line.strip_prefix("letter "));
    let certified: Vec<i64> = letters
        .enumerate()
        .flat_map(|(i, letter)| {
            let words: Vec<&str> = letter.split(' ').collect();
            assert_eq!(words[0], (i + 1).to_string());
            words[1..5].iter().map(|word| decimal(word)).collect::<Vec<_>>()
        })
        .collect();
    assert_eq!(stated, certified);
}

/// a₁ = p/q and a₂ = s/q as decimal numbers.
#[derive(Clone, Debug)]
struct Rational {
    p: String,
    s: String,
    q: String,
    /// `classify` is asked for the periods up to this one. Numbers have about as many digits as the longest
    /// of these, times the period, and the proved functions multiply them bit by bit.
    largest: usize,
}

/// What the proved functions say about one period at one point.
struct Proved {
    point: Rational,
    n: usize,
    singular: bool,
    /// The signs of b_{n,1}, …, b_{n,n−1}, of c_n and of 1 − v_n + a₂ⁿ.
    b: Vec<char>,
    c: char,
    d: char,
    /// The cases (sign eµ, sign γ) with an orbit.
    cases: BTreeSet<(i8, i8)>,
    no_orbit: bool,
}

/// Points of every region, of the lines between them and of the ends of the ranges.
fn points() -> Vec<Rational> {
    let point = |p: String, s: String, q: String| {
        let largest = match p.len().max(s.len()).max(q.len()) {
            1..=4 => 16,
            5..=8 => 8,
            _ => 4,
        };
        Rational { p, s, q, largest }
    };
    let small = |p: i64, s: i64, q: i64| point(p.to_string(), s.to_string(), q.to_string());
    let mut all = Vec::new();
    // A linear congruence is random enough here, and the same on every machine.
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    let mut below = |bound: u64| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((state >> 33) % bound) as i64
    };
    for q in [7, 60, 997, 1_000_000] {
        for _ in 0..30 {
            let s = 1 + below(q as u64);
            // |a1| < 2 sqrt(a2) half of the time, else up to 3.
            let root = ((s as f64 * q as f64).sqrt() * 2.0) as u64;
            let bound = if below(2) == 0 { root.max(1) } else { 3 * q as u64 };
            all.push(small(below(2 * bound + 1) - bound as i64, s, q));
        }
        // a2 near 1, and above: reversed time.
        for _ in 0..6 {
            all.push(small(below(4 * q as u64) - 2 * q, q - below(2), q));
            all.push(small(below(6 * q as u64) - 3 * q, q + 1 + below(2 * q as u64), q));
        }
    }
    // a1 = ±(a2 + 1), equal eigenvalues ±x/10, the circle at rational cosines.
    for x in 1..10 {
        all.push(small(10 + x, x, 10));
        all.push(small(-10 - x, x, 10));
        all.push(small(20 * x, x * x, 100));
        all.push(small(-20 * x, x * x, 100));
    }
    all.extend((-2..=2).map(|p| small(p, 1, 1)));
    all.extend((-6..=6).map(|p| small(p, 2, 2)));
    all.extend((-5..=5).map(|p| small(p, 1, 2)));
    // r^2 = 1/2 and 1/3 at s = 1/8, 1/12 and their like have a1^2/a2 rational: u_n = 0 exactly.
    all.extend(
        [(2, 1, 2), (-2, 1, 2), (3, 3, 3), (-3, 3, 3), (1, 1, 3), (-1, 1, 3), (1, 1, 1), (0, 5, 7)]
            .map(|(p, s, q)| small(p, s, q)),
    );
    // Within 10^-25 of the circle, of a line, of 0; very large.
    let ten = |k: usize| format!("1{}", "0".repeat(k));
    let nines = |k: usize| "9".repeat(k);
    all.push(point(ten(25), nines(25), ten(25)));
    all.push(point(format!("-{}", ten(25)), nines(25), ten(25)));
    all.push(point("0".into(), nines(25), ten(25)));
    all.push(point(format!("1{}", nines(25)), nines(25), ten(25)));
    all.push(point(format!("-1{}", nines(25)), nines(25), ten(25)));
    all.push(point(ten(25), "1".into(), ten(25)));
    all.push(point("1".into(), "1".into(), ten(20)));
    all.push(point(ten(25), "3".into(), "4".into()));
    all.push(point(format!("-{}", ten(25)), "3".into(), "4".into()));
    all.push(point("3".into(), ten(25), "4".into()));
    all
}

/// What `classify` prints for the periods 1 to `largest` at one point, held against the proved answers.
/// The word it has for each period.
fn compare_classify(point: &Rational, proved: &[Proved]) -> Vec<String> {
    let largest = point.largest.to_string();
    let text = grazing(&["classify", "--max-n", &largest, "--format", "csv"], point);
    let mut rows: BTreeMap<usize, Vec<Vec<String>>> = BTreeMap::new();
    let mut lines = text.lines();
    let header = "n,existence,sign_emu,sign_gamma,large_eigenvalue,positive_k,negative_k,zero_k,resonance";
    assert_eq!(lines.next(), Some(header));
    for line in lines {
        let cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        rows.entry(cells[0].parse().unwrap()).or_default().push(cells);
    }
    assert_eq!(rows.len(), point.largest);
    let mut kinds = Vec::new();
    for (found, proved) in rows.values().zip(proved) {
        let (n, first) = (proved.n, &found[0]);
        let at = || format!("n = {n} at {point:?}: {found:?}");
        let sign = |cell: &str| cell.parse::<i8>().unwrap();
        let letter = |cell: &str| proved.b[cell.parse::<usize>().unwrap() - 1];
        let none = proved.cases.is_empty() && !proved.no_orbit;
        match first[1].as_str() {
            "orbit" => {
                let cases = found.iter().map(|row| (sign(&row[2]), sign(&row[3]))).collect::<BTreeSet<_>>();
                assert_eq!(cases, proved.cases, "{}", at());
                // (61): the large eigenvalue has the sign of eµ times that of 1 - v_n + a2^n.
                let d = if proved.d == '+' { 1 } else { -1 };
                assert!(found.iter().all(|row| sign(&row[4]) == sign(&row[2]) * d), "{}", at());
            }
            "none" => {
                assert!(proved.no_orbit && letter(&first[5]) == '+' && letter(&first[6]) == '-', "{}", at());
            }
            "singular boundary" => assert!(proved.singular, "{}", at()),
            "iterate boundary" => {
                assert!(!proved.singular && none && letter(&first[7]) == '0', "{}", at());
            }
            "sign boundary" => assert!(!proved.singular && none && proved.c == '0', "{}", at()),
            _ => panic!("undecided: {}", at()),
        }
        assert_eq!(proved.singular, first[1] == "singular boundary", "{}", at());
        kinds.push(first[1].clone());
    }
    kinds
}

/// The signs that `evaluate` prints for one period at one point, held against the proved ones; how many.
fn compare_evaluate(proved: &Proved) -> usize {
    let n = proved.n.to_string();
    let text = grazing(&["evaluate", "--n", &n, "--format", "json"], &proved.point);
    let values = serde_json::from_str::<serde_json::Value>(&text).unwrap()["values"].clone();
    let names = (1..proved.n).map(|k| format!("b_{{{n},{k}}}")).chain([format!("c_{n}")]);
    let signs = proved.b.iter().chain([&proved.c]);
    let expected: Vec<_> = names
        .zip(signs)
        .map(|(name, &sign)| (name, if proved.singular { "singular".into() } else { sign.to_string() }))
        .collect();
    let found: Vec<_> = (values.as_array().unwrap().iter())
        .map(|v| (v["name"].as_str().unwrap().to_owned(), v["sign"].as_str().unwrap().to_owned()))
        .collect();
    assert_eq!(found, expected, "n = {n} at {:?}", proved.point);
    found.len()
}

/// What the built `grazing` prints about a point; it must succeed.
fn grazing(arguments: &[&str], point: &Rational) -> String {
    let Rational { p, s, q, .. } = point;
    let output = Command::new(env!("CARGO_BIN_EXE_grazing"))
        .args(arguments)
        .args([format!("--a1={p}/{q}"), format!("--a2={s}/{q}")])
        .output()
        .unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    // 3: of some period Theorem 1 is silent.
    assert!(matches!(output.status.code(), Some(0 | 3)), "{arguments:?} at {point:?}: {message}");
    String::from_utf8(output.stdout).unwrap()
}

/// The cases (sign eµ, sign γ) in the order of the extracted functions' answers.
const CASES: [(i8, i8); 4] = [(1, 1), (1, -1), (-1, 1), (-1, -1)];

/// What the extracted functions answer to each question, in order: the words after it.
fn answers(build: &Path, questions: &[String]) -> Vec<Vec<String>> {
    let mut child =
        Command::new(build.join("oracle")).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let mut input = child.stdin.take().unwrap();
    let text = questions.join("\n") + "\n";
    let writer = thread::spawn(move || input.write_all(text.as_bytes()));
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap().unwrap();
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(text.lines().count(), questions.len());
    (text.lines().zip(questions))
        .map(|(line, question)| {
            let words = line.strip_prefix(question.as_str()).unwrap();
            words.split_whitespace().map(str::to_owned).collect()
        })
        .collect()
}

/// What is proved about one impact per period, in the order of the questions.
fn ask(build: &Path, questions: Vec<(Rational, usize)>) -> Vec<Proved> {
    let lines: Vec<_> =
        questions.iter().map(|(Rational { p, s, q, .. }, n)| format!("{p} {s} {q} {n}")).collect();
    (questions.into_iter().zip(answers(build, &lines)))
        .map(|((point, n), words)| {
            let [singular, b, c, d, cases, no_orbit] = &words[..] else { panic!("{words:?}") };
            let held = cases.chars().zip(CASES).filter(|(bit, _)| *bit == '1').map(|(_, case)| case);
            let letter = |word: &str| word.chars().next().unwrap();
            let b = b.chars().filter(|&letter| letter != '.').collect();
            let (singular, no_orbit) = (singular == "1", no_orbit == "1");
            Proved { n, singular, b, c: letter(c), d: letter(d), cases: held.collect(), no_orbit, point }
        })
        .collect()
}

/// Whether a sample is tried: in `.ci/run`, not in `.ci/full`, where coqchk runs.
fn sampled() -> bool {
    env::var("GRAZING_COQCHK").is_ok_and(|v| v == "0")
}

/// A folder for building.
fn folder(name: &str) -> PathBuf {
    let build = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::create_dir_all(&build).unwrap();
    build
}

/// The files under `proofs/coq` that a build reads, by name.
fn sources() -> BTreeMap<String, String> {
    let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("proofs/coq");
    let names = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name());
    names
        .filter_map(|name| name.into_string().ok())
        .filter(|name| is_source(name))
        .map(|name| (name.clone(), fs::read_to_string(folder.join(name)).unwrap()))
        .collect()
}

fn is_source(name: &str) -> bool {
    let extension = Path::new(name).extension().and_then(|e| e.to_str());
    name == "_CoqProject" || matches!(extension, Some("v" | "sh" | "awk" | "txt" | "ml" | "mli"))
}

/// Makes the files in a build folder these sources and no others: what was compiled there before goes.
fn place(build: &Path, sources: &BTreeMap<String, String>) {
    fs::remove_dir_all(build).unwrap();
    fs::create_dir_all(build).unwrap();
    for (name, text) in sources {
        fs::write(build.join(name), text).unwrap();
    }
}

/// What a program prints on stdout; panics with all it prints when it fails.
fn run(folder: &Path, program: &str, arguments: &[&str]) -> String {
    // As in check.sh.
    let mut command = Command::new(program);
    command.args(arguments).current_dir(folder).env("OCAMLRUNPARAM", "s=2M,o=400");
    let output = command.output().unwrap();
    let (stdout, stderr) = (output.stdout, String::from_utf8_lossy(&output.stderr));
    let stdout = String::from_utf8_lossy(&stdout).into_owned();
    assert!(output.status.success(), "{program} {arguments:?} failed:\n{stdout}{stderr}");
    stdout
}

fn runs(program: &str) -> bool {
    Command::new(program).arg("-version").output().is_ok_and(|output| output.status.success())
}

/// The version a program prints, where it is asked for: not there it is a failure then.
fn version(program: &str, notice: &str, package: &str) -> Option<Vec<u8>> {
    if !samples::asked("GRAZING_REQUIRE_COQ", notice) {
        return None;
    }
    let found = Command::new(program).arg("--version").output().ok().map(|output| output.stdout);
    if found.is_none() {
        missing(program, notice, package);
    }
    found
}

fn missing(program: &str, notice: &str, package: &str) -> ! {
    panic!("GRAZING_REQUIRE_COQ=1, {notice}: no {program} on the PATH (Debian: apt install {package})");
}
