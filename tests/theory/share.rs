//! Certificates of shares: the search and the checker bound the same share by other enclosures, words at
//! random points of the parts are what is claimed of them, and what the command writes, prints and refuses.

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
        let partition = Partition::new(&of, 900, &()).unwrap();
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
            let found = certified(&of, &text, 900);
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
