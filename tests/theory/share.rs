//! Certificates of shares: the search and the checker bound the same share by other enclosures, words at
//! random points of the parts are what is claimed of them, and what the command writes, prints and refuses.

use std::{fs, path::PathBuf, process::Command};

use grazing::certificate;
use grazing::local::{Ladder, Plane, Point, Polar};
use grazing::number::parse_rational;
use grazing::search::{Certified, ShareStatement, certify_share};
use grazing::tolerance::{CaseSigns, ParameterBox, Partition, Statement};
use grazing::word::{Relation, Word};
use num_rational::BigRational;
use num_traits::{One, Zero};

type Q = BigRational;

fn q(text: &str) -> Q {
    parse_rational(text).unwrap()
}

fn certified(of: &ParameterBox, statement: &str, cells: u64) -> String {
    let statement = ShareStatement::parse(statement).unwrap();
    match certify_share(of, &statement, cells, &(), &mut || false).unwrap() {
        Certified::Text(text) => text,
        Certified::Undecided(reason) => panic!("{statement}: {reason}"),
    }
}

/// The two shares that a certificate states.
fn shares(text: &str) -> [Q; 2] {
    let line = text.lines().find_map(|line| line.strip_prefix("share ")).unwrap();
    let (lower, upper) = line.split_once(' ').unwrap();
    [q(lower), q(upper)]
}

/// The parts of which something is claimed.
fn parts(text: &str, of: &ParameterBox) -> Vec<([[Q; 2]; 2], bool)> {
    let (mut stack, mut found) = (vec![of.bounds().clone()], Vec::new());
    for line in text.lines().skip(6) {
        let part = stack.pop().unwrap();
        match line {
            "+" | "-" => found.push((part, line == "+")),
            "?" => {}
            axis => {
                let axis = axis.parse::<usize>().unwrap() - 1;
                let middle = (&part[axis][0] + &part[axis][1]) / q("2");
                let (mut lower, mut upper) = (part.clone(), part);
                (lower[axis][1], upper[axis][0]) = (middle.clone(), middle);
                stack.extend([upper, lower]);
            }
        }
    }
    assert!(stack.is_empty());
    found
}

fn boxes() -> [ParameterBox; 3] {
    let pair = |text: &str| {
        let (lower, upper) = text.split_once(' ').unwrap();
        [q(lower), q(upper)]
    };
    [
        ParameterBox::machine(pair("0.6 0.62"), pair("0.08 0.12")).unwrap(),
        ParameterBox::polar(pair("0.9 0.98"), pair("0.15 0.35")).unwrap(),
        ParameterBox::plane(pair("-1 1"), pair("0.4 0.9")).unwrap(),
    ]
}

/// Of every statement: the partition's bounds and the certificate's have a number in common, and both are
/// narrower with more cells.
#[test]
fn two_searches_bound_one_share() {
    let mut narrow = 0;
    for of in boxes() {
        let partition = Partition::new(&of, 1_500, &()).unwrap();
        let free = if of.has_gamma() { "" } else { " -" };
        let gamma = (!of.has_gamma()).then_some(false);
        let all = [
            (format!("chaos +{free}"), CaseSigns { positive: true, gamma }.chaos()),
            (format!("chaos -{free}"), CaseSigns { positive: false, gamma }.chaos()),
            ("period + 3".into(), Statement::Period { positive: true, n: 3 }),
            ("period - 2".into(), Statement::Period { positive: false, n: 2 }),
        ];
        for (text, statement) in all {
            let other = partition.share(statement);
            let found = certified(&of, &text, 1_500);
            let [lower, upper] = shares(&found);
            assert!(lower <= other.upper && other.lower <= upper, "{text} {of:?}: {lower} {upper} {other:?}");
            narrow += usize::from(&upper - &lower < q("0.05"));
            let [least, most] = shares(&certified(&of, &text, 150));
            assert!(least <= lower && upper <= most, "{text}");
        }
    }
    assert!(narrow >= 8, "{narrow} of 12");
}

/// At points of the parts, by exact words: of r and s, and of a₁ and a₂.
#[test]
fn words_at_points_of_the_parts_are_what_is_claimed() {
    let mut told = 0;
    for of in &boxes()[1..] {
        for text in ["period + 3", "word + 3 1D 2U", "chaos + -"] {
            let certificate = certified(of, text, 200);
            for (part, claimed) in parts(&certificate, of) {
                let [x, y] =
                    [("3", 0), ("7", 1)].map(|(by, i)| &part[i][0] + (&part[i][1] - &part[i][0]) / q(by));
                let point = if certificate.contains("\nbox polar ") {
                    Point::Polar(Polar::new(x, y).unwrap())
                } else {
                    Point::Plane(Plane::new(x, y).unwrap())
                };
                let word = Word::at(&Ladder::default(), &point, true, 60, &()).unwrap();
                let letters: Vec<(u64, String)> = word
                    .up_to(3)
                    .iter()
                    .filter(|v| v.period <= 3)
                    .map(|v| (v.period, v.letter.to_string()))
                    .collect();
                let holds = match text {
                    "period + 3" => letters.iter().any(|(n, _)| *n == 3),
                    "chaos + -" => Relation::new(&word, false, false, 200).unwrap().loops().len() > 1,
                    _ => {
                        let mut letters = letters;
                        letters.sort();
                        letters == [(1, "D".to_string()), (2, "U".to_string())]
                    }
                };
                assert_eq!(holds, claimed, "{text} at {point:?}");
                told += 1;
            }
        }
    }
    assert!(told > 150, "{told}");
}

/// What is certain of all of a box is a share of one or of nothing, from one part.
#[test]
fn all_and_nothing_are_one_part() {
    let of = ParameterBox::polar([q("0.9"), q("0.901")], [q("0.3"), q("0.301")]).unwrap();
    for (text, share) in [("period - 1", Q::one()), ("period - 2", Q::zero()), ("chaos - +", Q::zero())] {
        let found = certified(&of, text, 1);
        assert_eq!(shares(&found), [share.clone(), share], "{text}");
        assert_eq!(found.lines().count(), 7);
        assert_eq!(certificate::check(&mut found.as_bytes()).unwrap().kind, "share");
    }
}

fn command(arguments: &[&str]) -> (i32, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_grazing")).args(arguments).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

#[test]
fn the_command_writes_and_says_what_was_proved() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("share");
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join("chaos.txt");
    let file = file.to_str().unwrap();
    let machine =
        ["word", "--frequency", "12.3Hz±1%", "--damping-ratio", "0.02±20%", "--drive", "10Hz", "--shares"];
    let asked = |more: &[&str]| command(&[&machine, more].concat());
    let (code, out, error) =
        asked(&["--cells", "400", "--max-period", "3", "--certificate", file, "--holds", "chaos +"]);
    assert_eq!(code, 0, "{error}");
    let checked = certificate::check(&mut fs::read(file).unwrap().as_slice()).unwrap();
    let proved: Vec<String> =
        checked.detail.iter().map(|(name, value)| format!("  {name}: {value}\n")).collect();
    assert!(out.ends_with(&format!("Certificate: {file}\n{}", proved.concat())), "{out}");
    assert!(proved[0].starts_with("  share: 53."), "{proved:?}");
    let (code, out, _) = command(&["check", file]);
    assert_eq!((code, out), (0, format!("{file}: {checked}\n")));
    let (_, out, _) =
        asked(&["--cells", "40", "--certificate", file, "--holds", "period + 2", "--format", "json"]);
    let report: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(report["certificate"], file);

    // Nothing that cannot be proved is written, and nothing is left out in silence.
    let none = folder.join("none.txt");
    let name = none.to_str().unwrap();
    // Of an earlier run.
    let _ = fs::remove_file(&none);
    let (code, _, error) = asked(&["--cells", "1", "--certificate", name, "--holds", "period + 4"]);
    assert_eq!(code, 3, "{error}");
    assert!(error.contains("no certificate: on none of 1 cells is it certain; --cells 4 may do"), "{error}");
    assert!(!none.exists());
    let wrong: [(&[&str], &str); 7] = [
        (&["--certificate", name], "add --holds"),
        (&["--holds", "chaos +"], "--certificate"),
        (&["--certificate", name, "--holds", "chaos"], "expected \"period + 3\""),
        (&["--certificate", name, "--holds", "period + 65"], "periods are at most 64"),
        (&["--certificate", name, "--holds", "chaos + -"], "leave out the second sign"),
        (&["--certificate", name, "--holds", "chaos +", "--normal"], "cannot be used with"),
        (&["--certificate", name, "--holds", "chaos +", "--by-theorem"], "cannot be used with"),
    ];
    for (more, expected) in wrong {
        let (code, _, error) = asked(more);
        assert_eq!(code, 2, "{more:?}: {error}");
        assert!(error.contains(expected), "{more:?}: {error}");
    }
    let polar = ["word", "--r", "0.9", "--s", "0.3±1%", "--shares", "--certificate", name, "--holds"];
    let (code, _, error) = command(&[polar.as_slice(), &["chaos +"]].concat());
    assert!(code == 2 && error.contains("the sign of gamma is free here"), "{error}");
    let long = ["word", "--r", "0.9", "--s", "0.1234567890123456±1%", "--shares", "--certificate", name];
    let (code, _, error) = command(&[long.as_slice(), &["--holds", "period + 3"]].concat());
    assert!(code == 2 && error.contains("at most 15 digits"), "{error}");
    assert!(!none.exists());
}
