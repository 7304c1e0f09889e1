//! One question in every form: (r, s) and (a₁, a₂), time forwards and backwards, a point and a box about it,
//! a box across lines between regions and its points; by periods (`classify`), by the word, by the general
//! solver of every pattern, by the intervals on r = 1.
//!
//! Points are drawn, from the seed that is printed, and hard: on the lines between regions, where they meet,
//! at r = 1 and s = 1/n.

use crate::samples::samples;
use std::collections::BTreeSet;

use grazing::existence::{Case, Existence, by_definition, intervals};
use grazing::local::{Forward, Ladder, Plane, Point, Polar};
use grazing::pattern::{Analysis, Numbers, Patterns};
use grazing::search::{Certified, WordCertificate, WordPlace, certify_word};
use grazing::word::{Edge, Extent, Letter, Rectangle, Relation, Word};
use num_rational::{BigRational, Ratio};
use num_traits::One;

use super::{Q, exhaustive, follows, occurring, q, u};

/// Drawn numbers: SplitMix64.
struct Drawn(u64);

impl Drawn {
    /// From a seed that a failure prints.
    fn new(name: &str) -> Drawn {
        let drawn = std::env::var("GRAZING_DRAW").unwrap_or_default();
        println!("{name}: GRAZING_DRAW={drawn}");
        Drawn(crate::samples::seed(1))
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// From 0 to `most` − 1.
    fn below(&mut self, most: u64) -> i64 {
        (self.next() % most) as i64
    }

    /// A fraction strictly between the two.
    fn between(&mut self, lower: &Q, upper: &Q) -> Q {
        lower + (upper - lower) * q(1 + self.below(997), 998)
    }
}

/// The lines between regions: a₁ at a place t with a₂ = t², and which it is.
#[derive(Debug, Clone, Copy)]
enum Line {
    TwoThree,
    ThreeFour,
    FourFive,
    OneTwo,
}

const LINES: [Line; 4] = [Line::TwoThree, Line::ThreeFour, Line::FourFive, Line::OneTwo];

impl Line {
    fn at(self, t: &Q) -> [Q; 2] {
        let (square, two) = (t * t, q(2, 1));
        let a1 = match self {
            Line::TwoThree => two * t,
            Line::ThreeFour => -two * t,
            Line::FourFive => -Q::one() - &square,
            Line::OneTwo => Q::one() + &square,
        };
        [a1, square]
    }
}

/// Points where something is special: lines, where they meet at a₂ = 1, zeros of u, boundaries of areas.
fn hard_points() -> Vec<[Q; 2]> {
    let mut points = Vec::new();
    for t in [q(1, 10), q(1, 3), q(1, 2), q(9, 10), q(999, 1000), q(1, 1)] {
        points.extend(LINES.map(|line| line.at(&t)));
        points.extend([q(0, 1), t.clone(), -t.clone()].map(|a1| [a1, &t * &t]));
    }
    points.extend([[q(-1, 1), q(1, 2)], [q(-1, 4), q(1, 2)], [q(1, 4), q(1, 1)], [q(-7, 4), q(1, 1)]]);
    points
}

fn plane([a1, a2]: &[Q; 2]) -> Point {
    Point::Plane(Plane::new(a1.clone(), a2.clone()).unwrap())
}

fn word(point: &Point, positive: bool) -> Word {
    Word::at(&Ladder::default(), point, positive, 14, &()).unwrap()
}

/// Everything that a word says of the periods up to `last`.
fn said(word: &Word, last: u64) -> (Vec<(u64, Letter)>, Vec<Relation>) {
    let letters = word.up_to(last).iter().map(|vertex| (vertex.period, vertex.letter)).collect();
    let relations = [true, false].map(|gamma| Relation::new(word, gamma, false, last).unwrap());
    (letters, relations.to_vec())
}

/// The periods of the words at every point whose letters or edges are looked at.
const LAST: u64 = 8;

/// What a box says must be true at this one of its points: by the definition, in exact fractions.
fn holds_at(word: &Word, [a1, a2]: &[Q; 2], what: &str) {
    let values = u(a1, a2, 2 * LAST as usize + 2);
    let occur = occurring(a2, &values, word.is_positive(), LAST as usize);
    let listed: Vec<u64> =
        word.up_to(LAST).iter().map(|vertex| vertex.period).filter(|n| *n <= LAST).collect();
    for vertex in word.up_to(LAST) {
        let n = vertex.period;
        assert!(occur.contains(&n), "{what}: period {n} does not occur at {a1}, {a2}");
        // c_n > 0 is p_n > q_n.
        let c = follows(a2, &values, n, n, true);
        match vertex.letter {
            Letter::U => assert_eq!(c, Edge::Yes, "{what}: U {n} at {a1}, {a2}"),
            Letter::D => assert_eq!(c, Edge::No, "{what}: D {n} at {a1}, {a2}"),
            Letter::Either => {}
        }
    }
    if matches!(word.extent(), Extent::Complete { .. } | Extent::All) {
        let mut sorted = listed.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, occur, "{what}: all periods at {a1}, {a2}");
    }
    for gamma in [true, false] {
        let relation = Relation::new(word, gamma, false, LAST).unwrap();
        for (&i, &j) in listed.iter().flat_map(|i| listed.iter().map(move |j| (i, j))) {
            let edge = relation.edge(i, j);
            if edge != Edge::Open {
                let truth = follows(a2, &values, i, j, word.is_positive() == gamma);
                assert_eq!(edge, truth, "{what}: {i} -> {j} at {a1}, {a2}, gamma > 0: {gamma}");
            }
        }
    }
}

/// Compares a thin box with its points: what it says is true at all of them, and it says what they have in
/// common.
fn compare_box(a1: [Q; 2], a2: [Q; 2], inner: &[[Q; 2]]) {
    let what = format!("box {}..={} x {}..={}", a1[0], a1[1], a2[0], a2[1]);
    let rectangle = Rectangle::new(a1.clone(), a2.clone()).unwrap();
    let corners = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(i, j)| [a1[i].clone(), a2[j].clone()]);
    let points: Vec<&[Q; 2]> = corners.iter().chain(inner).collect();
    for positive in [true, false] {
        let of_box = Word::in_rectangle(&rectangle, positive, 14, &()).unwrap();
        // The first letters of all words; across a₁ = −(a₂ + 1), where some leave out even periods, every
        // letter that they share.
        let letters = |word: &Word| -> Vec<(u64, String)> {
            word.up_to(6).iter().map(|vertex| (vertex.period, vertex.letter.to_string())).collect()
        };
        let below = a1[0] <= -Q::one() - &a2[0];
        let mut lists = points.iter().map(|point| letters(&word(&plane(point), positive)));
        let first = lists.next().unwrap();
        let common = lists.fold(first, |all, list| {
            let both = all.iter().zip(&list).take_while(|(a, b)| a == b).count();
            all.iter()
                .enumerate()
                .filter(|(i, a)| *i < both || below && list.contains(a))
                .map(|x| x.1.clone())
                .collect()
        });
        for point in &points {
            holds_at(&of_box, point, &what);
        }
        let listed = letters(&of_box);
        assert!(
            common.iter().all(|x| listed.contains(x)),
            "{what}: {common:?} and not {listed:?}, {positive}"
        );
    }
}

/// The boxes are thin, so that what corners have in common the whole box has.
#[test]
fn boxes_across_lines_say_what_their_points_have_in_common() {
    let mut drawn = Drawn::new("boxes across lines");
    for round in 0..samples::<usize>(30) {
        let line = LINES[round % 4];
        let t = q(1, 20) + q(drawn.below(9_400), 10_000);
        let [a1, a2] = line.at(&t);
        let size = q(1, 10i64.pow(5 + drawn.below(4) as u32));
        let mut ends = |x: &Q| {
            let (left, right) = (q(1 + drawn.below(9), 10), q(1 + drawn.below(9), 10));
            [x - &size * left, x + &size * right]
        };
        let (across, along) = (ends(&a1), ends(&a2));
        let inner: Vec<[Q; 2]> = (0..3)
            .map(|_| [drawn.between(&across[0], &across[1]), drawn.between(&along[0], &along[1])])
            .chain([[a1.clone(), a2.clone()]])
            .collect();
        compare_box(across, along, &inner);
    }
    // Where the lines meet.
    for a1 in [q(2, 1), q(-2, 1)] {
        let size = q(1, 1_000_000);
        let (across, along) = ([&a1 - &size, &a1 + &size], [Q::one() - &size, Q::one()]);
        compare_box(across, along, &[[a1.clone(), Q::one()], [a1.clone(), Q::one() - &size / q(2, 1)]]);
    }
}

/// Wide boxes may say little; what they say is true.
#[test]
fn wide_boxes_never_contradict_their_points() {
    let mut drawn = Drawn::new("wide boxes");
    for _ in 0..80 {
        let mut two = |from: i64, to: i64| {
            let (a, b) = (drawn.below((to - from) as u64), drawn.below((to - from) as u64));
            [q(from + a.min(b), 100), q(from + a.max(b), 100)]
        };
        let (across, along) = (two(-250, 251), two(1, 101));
        let inner = [[drawn.between(&across[0], &across[1]), drawn.between(&along[0], &along[1])]];
        let rectangle = Rectangle::new(across.clone(), along.clone()).unwrap();
        for positive in [true, false] {
            let of_box = Word::in_rectangle(&rectangle, positive, 14, &()).unwrap();
            let corners =
                [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(i, j)| [across[i].clone(), along[j].clone()]);
            for point in corners.iter().chain(&inner) {
                holds_at(&of_box, point, &format!("{across:?} {along:?}"));
            }
        }
    }
}

/// A point and the smallest box about it say the same, but where a quantity is zero.
#[test]
fn a_point_is_a_tiny_box() {
    let mut drawn = Drawn::new("tiny boxes");
    let size = Q::new(1.into(), num_bigint::BigInt::from(10).pow(25));
    let random = (0..24).map(|_| [q(drawn.below(4_800) - 2_400, 1_000), q(1 + drawn.below(998), 1_000)]);
    let mut points: Vec<[Q; 2]> = random.collect();
    points.extend(hard_points());
    let mut same = 0;
    for [a1, a2] in points {
        let top = (&a2 + &size).min(Q::one());
        let (across, along) = ([&a1 - &size, &a1 + &size], [&a2 - &size, top]);
        let rectangle = Rectangle::new(across.clone(), along.clone()).unwrap();
        for positive in [true, false] {
            let (at, about) = (
                word(&plane(&[a1.clone(), a2.clone()]), positive),
                Word::in_rectangle(&rectangle, positive, 14, &()).unwrap(),
            );
            if matches!(at.extent(), Extent::Complete { .. }) && about.extent() == at.extent() {
                assert_eq!(said(&at, LAST), said(&about, LAST), "{a1} {a2}");
                same += 1;
            }
        }
        compare_box(across, along, &[[a1, a2]]);
    }
    assert!(same > 50, "{same}");
}

/// The box of the report: its words, which are those of all points, are certified too.
#[test]
fn a_box_across_regions_3_and_4_is_certified() {
    let (a1, a2) = ([q(-1415, 1000), q(-1414, 1000)], [q(1, 2), q(5001, 10000)]);
    let rectangle = Rectangle::new(a1, a2).unwrap();
    assert_eq!(rectangle.region(), None);
    let words = [true, false].map(|positive| Word::in_rectangle(&rectangle, positive, 14, &()).unwrap());
    assert_eq!(words.each_ref().map(Word::letters), ["DUD", "D"]);
    assert_eq!(words.each_ref().map(Word::extent).map(|x| matches!(x, Extent::Complete { .. })), [true; 2]);
    for kind in [WordCertificate::BySigns { last: 8 }, WordCertificate::ByTheorem] {
        let place = WordPlace::Rectangle(&rectangle);
        let found = certify_word(place, &words.each_ref(), kind, &mut || false).unwrap();
        let Certified::Text(text) = found else { panic!("{found:?}") };
        let proved = grazing::certificate::check(&mut text.as_bytes()).unwrap();
        let detail: Vec<&str> = proved.detail.iter().map(|(_, line)| line.as_str()).collect();
        assert!(detail[1].contains("word DUD, periods 1, 2, 3;"), "{detail:?}");
        // The same lines do not pass for a box that reaches across the line to region 5, or to region 2.
        for (from, to) in [("-283/200", "-31/20"), ("-707/500", "3/2")] {
            let moved = text.replacen(from, to, 1);
            assert_ne!(moved, text);
            assert!(grazing::certificate::check(&mut moved.as_bytes()).is_err(), "{to}");
        }
        if kind == WordCertificate::ByTheorem {
            assert!(text.contains("\nregion 34\n"), "{text}");
            for region in [3, 4, 5, 33] {
                let moved = text.replacen("region 34", &format!("region {region}"), 1);
                assert!(grazing::certificate::check(&mut moved.as_bytes()).is_err(), "region {region}");
            }
        }
    }
}

/// On a₁ = −(a₂ + 1), by the solver of every pattern.
#[test]
fn on_the_line_left_of_region_4_odd_periods_and_2_make_every_pattern() {
    for a2 in [q(1, 1), q(1, 2), q(1, 1000), q(807, 1000)] {
        let a1 = -Q::one() - &a2;
        for gamma in [true, false] {
            let map = exhaustive::map(&a1, &a2, gamma);
            let analysis = Analysis::new(&map, 9, Numbers::Enclosed);
            let relations = [true, false].map(|positive| {
                Relation::new(&word(&plane(&[a1.clone(), a2.clone()]), positive), gamma, false, 9).unwrap()
            });
            for pattern in (1..=9).flat_map(Patterns::of_period) {
                let report = analysis.judge(pattern.periods());
                for (relation, positive) in relations.iter().zip([true, false]) {
                    match relation.pattern(pattern.periods()) {
                        Edge::Yes => assert_eq!(report.side(), Some(positive), "{a2} {gamma} {pattern}"),
                        Edge::Open => assert!(report.is_open(), "{a2} {gamma} {pattern}"),
                        // Periods that are not listed are not denied here.
                        Edge::No => assert_ne!(report.side(), Some(positive), "{a2} {gamma} {pattern}"),
                    }
                }
            }
        }
        let found = Relation::new(&word(&plane(&[a1, a2]), true), false, false, 9).unwrap();
        assert_eq!(found.loops(), [1, 3, 5, 7, 9]);
        assert_eq!(found.pattern(&[1, 2]), Edge::Yes);
        assert_eq!(found.pattern(&[2]), Edge::Open);
    }
}

/// One period at a time, by all its b and c, and the word: everywhere, and with time reversed.
#[test]
fn periods_and_words_agree_with_time_forwards_and_backwards() {
    let mut drawn = Drawn::new("periods and words");
    let random = (0..40).map(|_| [q(drawn.below(4_800) - 2_400, 1_000), q(1 + drawn.below(999), 1_000)]);
    let mut points: Vec<[Q; 2]> = random.collect();
    points.extend(hard_points());
    let ladder = Ladder::default();
    for [a1, a2] in points {
        let point = plane(&[a1.clone(), a2.clone()]);
        // The same point seen backwards: (a₁/a₂, 1/a₂), which is turned round again.
        let back = Forward::plane(&a1 / &a2, a2.recip()).unwrap();
        assert_eq!(back.reversed, !a2.is_one());
        for n in 1..=LAST {
            let existence = by_definition(&ladder, &point, n);
            assert_eq!(existence, by_definition(&ladder, &back.point, n), "{a1} {a2} {n}");
            let loops = |case: Case| {
                let word = word(&point, case.sign_emu() > 0);
                Relation::new(&word, case.sign_gamma() > 0, false, LAST).unwrap().edge(n, n)
            };
            for case in [Case::PlusPlus, Case::PlusMinus, Case::MinusPlus, Case::MinusMinus] {
                match (existence, loops(case)) {
                    (Existence::Undecided, _) => panic!("{a1} {a2} {n}"),
                    (Existence::Singular | Existence::Iterate(_) | Existence::SignBoundary, edge) => {
                        assert_ne!(edge, Edge::Yes, "{a1} {a2} {n} {case}: {existence}");
                    }
                    (_, edge) => {
                        let exists = existence.cases(n).contains(&case);
                        assert_eq!(edge == Edge::Yes, exists, "{a1} {a2} {n} {case}: {existence}, {edge}");
                    }
                }
            }
        }
        // By the definition where a₂ > 1, against the relation read backwards.
        let (b1, b2) = (&a1 / &a2, a2.recip());
        let values = u(&b1, &b2, 2 * LAST as usize + 2);
        for (positive, gamma) in [(true, true), (true, false), (false, true), (false, false)] {
            let word = Word::at(&ladder, &back.point, positive, 14, &()).unwrap();
            let relation = Relation::new(&word, gamma, back.reversed, LAST).unwrap();
            let occur = occurring(&b2, &values, positive, LAST as usize);
            let listed: BTreeSet<u64> = relation.periods().iter().copied().collect();
            assert_eq!(listed, occur.iter().copied().collect(), "{b1} {b2} {positive}");
            for (&i, &j) in occur.iter().flat_map(|i| occur.iter().map(move |j| (i, j))) {
                // Edges at the point given; of the reversed system those that lead the other way.
                let truth = follows(&b2, &values, i, j, positive == gamma);
                assert_eq!(relation.edge(i, j), truth, "{b1} {b2} {i} -> {j}");
            }
        }
    }
}

/// (r, s) and (a₁, a₂): the same numbers where cos 2πs is rational, a tiny box where it is not.
#[test]
fn modulus_and_angle_are_trace_and_determinant() {
    let mut drawn = Drawn::new("r, s and a1, a2");
    let ladder = Ladder::default();
    for round in 0..24 {
        let r = if round < 3 { Q::one() } else { q(1 + drawn.below(999), 1_000) };
        for (s, a1) in [(q(1, 4), q(0, 1)), (q(1, 6), r.clone()), (q(1, 3), -r.clone())] {
            let polar = Point::Polar(Polar::new(r.clone(), s).unwrap());
            let flat = plane(&[a1, &r * &r]);
            for positive in [true, false] {
                let (one, other) = (word(&polar, positive), word(&flat, positive));
                assert_eq!((one.extent(), said(&one, 20)), (other.extent(), said(&other, 20)), "{r}");
            }
            for n in 1..=LAST {
                let [one, other] = [&polar, &flat].map(|point| by_definition(&ladder, point, n));
                assert_eq!(one, other, "{r} {n}");
            }
        }
    }
    let mut letters = 0;
    for round in 0..samples(60) {
        let r = if round % 3 == 0 {
            q(999_000 + drawn.below(999), 1_000_000)
        } else {
            q(1 + drawn.below(999), 1_000)
        };
        let s = if round % 4 == 0 { q(1, 3 + drawn.below(30)) } else { q(1 + drawn.below(4_999), 10_000) };
        let float = |x: &Q| num_traits::ToPrimitive::to_f64(x).unwrap();
        let a1 = 2.0 * float(&r) * (2.0 * std::f64::consts::PI * float(&s)).cos();
        // The float is off by some 1e-15.
        let (a1, margin) = (Q::from_float(a1).unwrap(), q(1, 1_000_000_000_000));
        let square = &r * &r;
        let rectangle = Rectangle::new([&a1 - &margin, &a1 + &margin], [square.clone(), square]).unwrap();
        let polar = Point::Polar(Polar::new(r.clone(), s.clone()).unwrap());
        for positive in [true, false] {
            let (at, about) =
                (word(&polar, positive), Word::in_rectangle(&rectangle, positive, 14, &()).unwrap());
            assert!(at.letters().starts_with(&about.letters()), "{r} {s}");
            assert!(at.vertices().starts_with(about.vertices()), "{r} {s}");
            letters += about.vertices().len();
            if let Extent::Complete { .. } = about.extent() {
                assert_eq!((at.extent(), said(&at, 40)), (about.extent(), said(&about, 40)), "{r} {s}");
            }
        }
    }
    assert!(letters > 300, "{letters}");
}

/// On r = 1: the intervals of s, the signs of all b and c, and the word.
#[test]
fn intervals_on_the_circle_are_those_of_periods_and_words() {
    let mut drawn = Drawn::new("intervals");
    let ladder = Ladder::default();
    for round in 0..60i64 {
        let s = if round < 20 { q(2, 2 * (round + 3) + 1) } else { q(1 + drawn.below(49_998), 100_003) };
        let point = Point::Polar(Polar::new(Q::one(), s.clone()).unwrap());
        let exact = |x: &Ratio<u64>| BigRational::new((*x.numer()).into(), (*x.denom()).into());
        for n in 3..=16 {
            let inside = intervals(n).unwrap().find(|x| exact(&x.left) < s && s < exact(&x.right));
            let existence = by_definition(&ladder, &point, n);
            match inside {
                Some(interval) => assert_eq!(existence, Existence::Orbit(interval.case), "{s} {n}"),
                None => assert!(existence.cases(n).is_empty(), "{s} {n}: {existence}"),
            }
            let found =
                [(true, true), (true, false), (false, true), (false, false)].map(|(positive, gamma)| {
                    let word = Word::at(&ladder, &point, positive, 400, &()).unwrap();
                    Relation::new(&word, gamma, false, n).unwrap().loops().contains(&n)
                });
            assert_eq!(found.contains(&true), !existence.cases(n).is_empty(), "{s} {n}");
        }
    }
}
