//! Boxes of parameters against points in them: what is said of all points is true at each, by other routes.

use crate::common;

use common::config;
use grazing::existence::Case;
use grazing::local::{Ladder, Plane, Point, Polar};
use grazing::number::{Ball, Elementary, Precision, Real};
use grazing::tolerance::{ParameterBox, Partition, Spread, Statement};
use grazing::word::{Edge, Extent, Letter, Rectangle, Relation, Word};
use num_rational::BigRational;
use proptest::prelude::*;

type Q = BigRational;

fn q(p: i64, d: i64) -> Q {
    Q::new(p.into(), d.into())
}

const CASES: [Case; 4] = [Case::PlusPlus, Case::PlusMinus, Case::MinusPlus, Case::MinusMinus];

/// Both words at a point: for eµ > 0 and for eµ < 0.
struct Exact {
    words: [Word; 2],
}

impl Exact {
    fn at(point: &Point) -> Exact {
        let ladder = Ladder::default();
        Exact { words: [true, false].map(|positive| Word::at(&ladder, point, positive, 200, &()).unwrap()) }
    }

    /// At a machine: a₁ and a₂ enclosed to 200 bits, and the words of that rectangle. None where even that is
    /// open.
    fn of_machine(ratio: &Q, damping: &Q) -> Option<Exact> {
        let precision = Precision::new(256);
        let exact = |x: &Q| Ball::ratio(x, &precision);
        let two_pi = Ball::pi(&precision) * &Ball::integer(2, &precision);
        let exponent = -(two_pi.clone() * &exact(&(ratio * damping)));
        let r = exponent.exp(&precision);
        let under = q(1, 1) - damping * damping;
        let turn = two_pi * &exact(ratio);
        let swing = if under > q(0, 1) {
            (turn * &exact(&under).sqrt()).sin_cos(&precision).1
        } else {
            let x = (turn * &exact(&-under).sqrt()).exp(&precision);
            (x.clone() + &(Ball::integer(1, &precision) / &x)) / &Ball::integer(2, &precision)
        };
        let ends = |x: &Ball| x.exact_bounds().map(|(lo, hi)| [lo, hi]).unwrap();
        let a1 = ends(&(Ball::integer(2, &precision) * &r * &swing));
        let rectangle = Rectangle::new(a1, ends(&(r.clone() * &r))).unwrap();
        let words = [true, false].map(|positive| Word::in_rectangle(&rectangle, positive, 200, &()).unwrap());
        words.iter().all(Word::is_whole).then_some(Exact { words })
    }

    fn word(&self, positive: bool) -> &Word {
        &self.words[usize::from(!positive)]
    }

    /// Whether a period occurs, and its letter.
    fn letter(&self, positive: bool, n: u64) -> Option<Letter> {
        self.word(positive).up_to(n).iter().find(|vertex| vertex.period == n).map(|vertex| vertex.letter)
    }

    fn edge(&self, case: Case, from: u64, to: u64) -> Edge {
        let word = self.word(case.sign_emu() > 0);
        Relation::new(word, case.sign_gamma() > 0, false, from.max(to)).unwrap().edge(from, to)
    }
}

fn spelling(word: &Word) -> Vec<(u64, Letter)> {
    word.vertices().iter().map(|vertex| (vertex.period, vertex.letter)).collect()
}

/// What a word says of all points of a set is true at one of them.
fn word_holds(of_all: &Word, exact: &Exact) {
    let positive = of_all.is_positive();
    for vertex in of_all.vertices() {
        let letter = exact.letter(positive, vertex.period);
        assert!(letter.is_some(), "period {} does not occur", vertex.period);
        assert!(vertex.letter == Letter::Either || letter == Some(vertex.letter), "{vertex:?} {letter:?}");
    }
    if matches!(of_all.extent(), Extent::Complete { .. } | Extent::All) {
        assert_eq!(spelling(of_all), spelling(exact.word(positive)));
    }
    for gamma in [true, false] {
        let relation = Relation::new(of_all, gamma, false, 30).unwrap();
        for (i, &from) in relation.periods().iter().enumerate() {
            for (j, &to) in relation.periods().iter().enumerate() {
                let edge = relation.edges()[i][j];
                let at = exact.edge(relation.case(), from, to);
                assert!(edge == Edge::Open || at == Edge::Open || edge == at, "{from} -> {to} {edge} {at}");
            }
        }
    }
}

/// Compares every statement of a box's partition with one point of the box, and counts those that decide.
fn compare(of: &ParameterBox, at: &[Q; 2], exact: &Exact, cells: u64) -> u64 {
    for positive in [true, false] {
        word_holds(&of.word(positive, 60, &()).unwrap(), exact);
    }
    let partition = Partition::new(of, cells, &()).unwrap();
    let mut told = 0;
    let inside = |bounds: &[[Q; 2]; 2]| (0..2).all(|i| bounds[i][0] <= at[i] && at[i] <= bounds[i][1]);
    let mut found = false;
    for leaf in partition.leaves().iter().filter(|leaf| inside(leaf.cell.bounds())) {
        found = true;
        leaf.words.iter().for_each(|word| word_holds(word, exact));
        for case in CASES {
            let positive = case.sign_emu() > 0;
            let orbits = |n: u64| exact.edge(case, n, n) == Edge::Yes;
            if let Some(chaos) = leaf.holds(Statement::Chaos(case)) {
                told += 1;
                assert_eq!(chaos, (1..120).filter(|&n| orbits(n)).count() > 1, "{case}");
            }
            for n in 1..24 {
                if let Some(occurs) = leaf.holds(Statement::Period { positive, n }) {
                    told += 1;
                    assert_eq!(occurs, exact.letter(positive, n).is_some(), "{case} {n}");
                }
                if let Some(orbit) = leaf.holds(Statement::Orbit { case, n }) {
                    assert_eq!(orbit, orbits(n), "{case} {n}");
                }
            }
            for (from, to) in (1..7).flat_map(|i| (1..7).map(move |j| (i, j))) {
                if let Some(follows) = leaf.holds(Statement::Follows { case, from, to }) {
                    assert_eq!(follows, exact.edge(case, from, to) == Edge::Yes, "{case} {from} {to}");
                }
            }
        }
    }
    assert!(found, "the cells do not cover the box");
    told
}

/// The point so far along both sides.
fn along(bounds: &[[Q; 2]; 2], by: [i64; 2]) -> [Q; 2] {
    [0, 1].map(|i| &bounds[i][0] + (&bounds[i][1] - &bounds[i][0]) * q(by[i], 1009))
}

/// How many points are drawn in each of the three coordinates: a sample, or GRAZING_POINTS of them by hand.
fn points(sample: u32) -> ProptestConfig {
    let many = std::env::var("GRAZING_POINTS").ok().map(|many| many.parse().expect("a number of points"));
    ProptestConfig { cases: many.unwrap_or(sample), ..config() }
}

proptest! {
    #![proptest_config(points(60))]

    #[test]
    fn machines_are_what_their_box_says(
        ratio in 50i64..3_000, damping in 0i64..1_300, spread in 1i64..60, wide in 1i64..400,
        by in [0i64..=1009, 0i64..=1009], cells in 1u64..60,
    ) {
        let around = |x: Q, by: Q| [&x - &x * &by, &x + &x * &by];
        let bounds = [around(q(ratio, 1000), q(spread, 1000)), around(q(damping, 1000), q(wide, 1000))];
        let of = ParameterBox::machine(bounds[0].clone(), bounds[1].clone()).unwrap();
        let at = along(&bounds, by);
        if let Some(exact) = Exact::of_machine(&at[0], &at[1]) {
            compare(&of, &at, &exact, cells);
        }
    }

    #[test]
    fn points_of_r_and_s_are_what_their_box_says(
        r in 200i64..1_000, s in 20i64..480, spread in 1i64..100, wide in 1i64..20,
        by in [0i64..=1009, 0i64..=1009], cells in 1u64..60,
    ) {
        let r = [q(r, 1000), q((r + spread).min(1000), 1000)];
        let s = [q(s, 1000), q((s + wide).min(499), 1000)];
        let of = ParameterBox::polar(r, s).unwrap();
        let at = along(of.bounds(), by);
        let exact = Exact::at(&Point::Polar(Polar::new(at[0].clone(), at[1].clone()).unwrap()));
        compare(&of, &at, &exact, cells);
    }

    #[test]
    fn points_of_the_plane_are_what_their_box_says(
        a1 in -2_200i64..2_200, a2 in 10i64..1_000, spread in 0i64..120, wide in 0i64..120,
        by in [0i64..=1009, 0i64..=1009], cells in 1u64..60,
    ) {
        let of = ParameterBox::plane(
            [q(a1, 1000), q(a1 + spread, 1000)],
            [q(a2, 1000), q((a2 + wide).min(1000), 1000)],
        ).unwrap();
        let at = along(of.bounds(), by);
        let exact = Exact::at(&Point::Plane(Plane::new(at[0].clone(), at[1].clone()).unwrap()));
        compare(&of, &at, &exact, cells);
    }
}

/// Fixed boxes on which much is decided, so that the properties above are not empty; and shares hold what
/// points drawn say.
#[test]
fn much_is_decided_and_shares_bound_what_is_counted() {
    let of =
        ParameterBox::machine([q(99, 100), q(101, 100)].map(|x| x * q(37, 100)), [q(8, 100), q(12, 100)])
            .unwrap();
    let partition = Partition::new(&of, 2_000, &()).unwrap();
    assert!(partition.settled() > q(95, 100), "{}", partition.settled());
    let mut counted = [0i64; 12];
    let mut all = 0;
    for i in 0..12 {
        for j in 0..12 {
            let at = along(of.bounds(), [40 + 83 * i, 31 + 85 * j]);
            let Some(exact) = Exact::of_machine(&at[0], &at[1]) else { continue };
            all += 1;
            for n in 1..12 {
                counted[n as usize] += i64::from(exact.letter(true, n).is_some());
            }
        }
    }
    assert!(all > 140, "{all}");
    let mut differ = 0;
    for n in 1..12 {
        let share = partition.share(Statement::Period { positive: true, n });
        // A grid of 12 by 12 misses a strip by one row or column at the most, on either side.
        let (slack, found) = (q(1, 6), q(counted[n as usize], all));
        assert!(&share.lower - &slack <= found && found <= &share.upper + &slack, "{n} {found} {share:?}");
        match share.spread() {
            Spread::Everywhere => assert_eq!(counted[n as usize], all),
            Spread::Nowhere => assert_eq!(counted[n as usize], 0),
            Spread::Differs => differ += 1,
            Spread::Open => {}
        }
    }
    assert!(differ >= 1, "no period ends in this box");
}
