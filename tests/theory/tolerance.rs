//! Boxes of parameters against points in them: what is said of all points is true at each, by other routes.

use crate::common;
use crate::samples::samples;

use common::config;
use grazing::existence::{Case, by_definition};
use grazing::local::{Ladder, Plane, Point, Polar};
use grazing::number::{Ball, Elementary, Precision, Real};
use grazing::tolerance::{ChaosChart, Excursion, ParameterBox, Partition, Spread, Statement, Toward};
use grazing::word::{Edge, Extent, Letter, Rectangle, Relation, Word};
use num_rational::BigRational;
use num_traits::ToPrimitive;
use proptest::prelude::*;

type Q = BigRational;

fn q(p: i64, d: i64) -> Q {
    Q::new(p.into(), d.into())
}

const CASES: [Case; 4] = [Case::PlusPlus, Case::PlusMinus, Case::MinusPlus, Case::MinusMinus];

/// Both words at a point: for eµ > 0 and for eµ < 0; and the point, or of a machine one with its words.
struct Exact {
    words: [Word; 2],
    point: Point,
}

impl Exact {
    fn at(point: Point) -> Exact {
        let ladder = Ladder::default();
        let words = [true, false].map(|positive| Word::at(&ladder, &point, positive, 200, &()).unwrap());
        Exact { words, point }
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
        let [a1, a2] = [Ball::integer(2, &precision) * &r * &swing, r.clone() * &r].map(|x| ends(&x));
        let point = Point::Plane(Plane::new(a1[0].clone(), a2[0].clone()).unwrap());
        let rectangle = Rectangle::new(a1, a2).unwrap();
        let words = [true, false].map(|positive| Word::in_rectangle(&rectangle, positive, 200, &()).unwrap());
        words.iter().all(Word::is_whole).then_some(Exact { words, point })
    }

    /// The cases in which an orbit of period n with one impact exists, by Theorem 1's signs, without words.
    fn orbits(&self, n: u64) -> Vec<Case> {
        by_definition(&Ladder::default(), &self.point, n).cases(n)
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
                    assert!(n > 9 || orbit == exact.orbits(n).contains(&case), "{case} {n}, by definition");
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

/// How many points are drawn in each of the three coordinates.
fn points(sample: u32) -> u32 {
    samples(sample.into())
}

/// Of the boxes with one point each there are fewer.
fn boxes(sample: u32) -> ProptestConfig {
    ProptestConfig { cases: points(sample * PER_BOX as u32).div_ceil(PER_BOX as u32), ..config() }
}

proptest! {
    #![proptest_config(boxes(6))]

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
        let exact = Exact::at(Point::Polar(Polar::new(at[0].clone(), at[1].clone()).unwrap()));
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
        let exact = Exact::at(Point::Plane(Plane::new(at[0].clone(), at[1].clone()).unwrap()));
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

/// How many points are drawn in one box.
const PER_BOX: usize = 40;

/// The same numbers everywhere, from 0 to 1009.
struct Drawn(u64);

impl Drawn {
    fn below(&mut self, bound: u64) -> i64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % bound) as i64
    }
}

/// A random box in one of the three coordinates.
fn tube(kind: usize, drawn: &mut Drawn) -> ParameterBox {
    let mut around = |least: i64, most: i64, parts: u64| {
        let middle = q(least + drawn.below((most - least) as u64), 1000);
        let by = q(1 + drawn.below(parts), 1000);
        [&middle - &by, middle + by]
    };
    match kind {
        0 => ParameterBox::machine(around(100, 3_000, 30), around(120, 400, 100)),
        1 => ParameterBox::polar(around(200, 980, 20), around(30, 460, 20)),
        _ => ParameterBox::plane(around(-1_900, 1_900, 60), around(100, 930, 60)),
    }
    .unwrap()
}

fn at_point(kind: usize, [x, y]: [Q; 2]) -> Option<Exact> {
    match kind {
        0 => Exact::of_machine(&x, &y),
        1 => Some(Exact::at(Point::Polar(Polar::new(x, y).unwrap()))),
        _ => Some(Exact::at(Point::Plane(Plane::new(x, y).unwrap()))),
    }
}

/// What is counted over many boxes: how often a statement is true at points drawn, and how often it would be
/// by the shares, at least and at most.
#[derive(Default, Clone)]
struct Tally {
    counted: f64,
    bounds: [f64; 2],
    points: f64,
}

/// Random points of random boxes: none contradicts what is said of its box; and the points counted lie within
/// the sums of the shares' bounds, but for what chance may do once in 10⁹ (Hoeffding).
#[test]
fn random_points_contradict_no_verdict_and_lie_within_the_shares() {
    for kind in 0..3 {
        let mut drawn = Drawn(37 + kind as u64);
        let statements: Vec<Statement> = CASES
            .into_iter()
            .flat_map(|case| [1, 2, 3, 4, 5].map(|n| Statement::Orbit { case, n }))
            .chain(CASES.map(Statement::Chaos))
            .chain(
                [true, false]
                    .into_iter()
                    .flat_map(|positive| (1..9).map(move |n| Statement::Period { positive, n })),
            )
            .collect();
        let mut tallies = vec![Tally::default(); statements.len()];
        let mut decided = 0;
        for _ in 0..points(400).div_ceil(PER_BOX as u32) {
            let of = tube(kind, &mut drawn);
            let partition = Partition::new(&of, 200, &()).unwrap();
            let points: Vec<Exact> = (0..PER_BOX)
                .filter_map(|_| at_point(kind, along(of.bounds(), [drawn.below(1010), drawn.below(1010)])))
                .collect();
            for positive in [true, false] {
                let word = of.word(positive, 30, &()).unwrap();
                points.iter().for_each(|exact| word_holds(&word, exact));
            }
            for (statement, tally) in statements.iter().zip(&mut tallies) {
                let share = partition.share(*statement);
                let holds = points.iter().filter(|exact| is_true(*statement, exact)).count();
                match share.spread() {
                    Spread::Everywhere => assert_eq!(holds, points.len(), "{statement:?} {of:?}"),
                    Spread::Nowhere => assert_eq!(holds, 0, "{statement:?} {of:?}"),
                    _ => {}
                }
                decided += usize::from(share.spread() != Spread::Open);
                tally.counted += holds as f64;
                tally.points += points.len() as f64;
                for (sum, bound) in tally.bounds.iter_mut().zip([&share.lower, &share.upper]) {
                    *sum += points.len() as f64 * bound.to_f64().unwrap();
                }
            }
        }
        assert!(decided > statements.len() * 8, "{decided} verdicts in coordinates {kind}");
        for (statement, Tally { counted, bounds: [lower, upper], points }) in statements.iter().zip(tallies) {
            // exp(-2t²/N) = 10⁻⁹; and a grid of 1010 values in each direction is not quite a continuum.
            let chance = (points * 1e9f64.ln() / 2.0).sqrt() + 0.002 * points;
            let fits = lower - chance <= counted && counted <= upper + chance;
            assert!(fits, "{statement:?}: {counted} of {points}, not {lower} to {upper}");
        }
    }
}

/// By the word at a point; orbits and chaos, which is two of them, by Theorem 1.
fn is_true(statement: Statement, exact: &Exact) -> bool {
    match statement {
        Statement::Orbit { case, n } => exact.orbits(n).contains(&case),
        Statement::Chaos(case) => {
            let word = exact.word(case.sign_emu() > 0);
            let last = word.vertices().iter().map(|vertex| vertex.period).max().unwrap_or(1).max(3);
            Relation::new(word, case.sign_gamma() > 0, false, last).unwrap().loops().len() > 1
        }
        Statement::Period { positive, n } => exact.letter(positive, n).is_some(),
        _ => unreachable!("not asked"),
    }
}

/// From the middle of random boxes, on every way: before a change a statement is at random points what it is
/// at the middle, and at the change it is not; the other parameter stays, or is anywhere in the box.
#[test]
fn nothing_changes_before_a_change_and_something_at_it() {
    let mut drawn = Drawn(4);
    let (mut changes, mut same) = (0, 0);
    for round in 0..points(9).min(3_000) as usize {
        let kind = round % 3;
        let of = tube(kind, &mut drawn);
        let from = of.centre();
        let case = CASES[drawn.below(4) as usize];
        let positive = case.sign_emu() > 0;
        let n = 1 + drawn.below(5) as u64;
        for to in (0..8).map(|i| Toward { axis: i % 2, rises: i / 2 % 2 == 0, whole: i >= 4 }) {
            let mut way = Excursion::new(&of, &from, to, 150).unwrap();
            for statement in [Statement::Chaos(case), Statement::Period { positive, n }] {
                let Some(change) = way.first(statement, &()).unwrap() else { continue };
                let mut at = |x: Q| {
                    let other = if to.whole { drawn.below(1010) } else { 0 };
                    let mut point = if to.whole { along(of.bounds(), [other, other]) } else { from.clone() };
                    point[to.axis] = x;
                    point
                };
                for part in [q(0, 1), q(1, 3), q(7, 9), q(1, 1)] {
                    let x = &from[to.axis] + (&change.before - &from[to.axis]) * part;
                    let Some(exact) = at_point(kind, at(x)) else { continue };
                    // With all of the box nothing may be said, not even of its middle line.
                    if change.before != from[to.axis] {
                        assert_eq!(is_true(statement, &exact), change.holds, "{statement:?} {to:?} {of:?}");
                        same += 1;
                    }
                }
                let Some(after) = change.after else { continue };
                let mut point = after.cell.centre();
                point[to.axis] = change.by.unwrap();
                let short: [Q; 2] = after.cell.short_point().try_into().unwrap();
                for point in [point, short] {
                    let Some(exact) = at_point(kind, point) else { continue };
                    assert_ne!(is_true(statement, &exact), change.holds, "{statement:?} {to:?} {of:?}");
                    changes += 1;
                }
            }
        }
    }
    assert!(changes > 30 && same > 100, "{changes} changes, {same} points before");
}

/// Where the truth is known: for eµ < 0 the periods are those with 2ns < 1, and at r = 1 for eµ > 0 nothing
/// depends on more than the order of fractions.
#[test]
fn changes_are_where_they_are_known_to_be() {
    let point = |x: Q| [x.clone(), x];
    let of = ParameterBox::polar(point(q(9, 10)), point(q(1, 5))).unwrap();
    let first = |axis, rises, n| {
        let mut way = Excursion::new(&of, &of.centre(), Toward { axis, rises, whole: false }, 2_000).unwrap();
        way.first(Statement::Period { positive: false, n }, &()).unwrap().unwrap()
    };
    for (rises, n, at) in [(true, 2, q(1, 4)), (false, 3, q(1, 6)), (false, 4, q(1, 8))] {
        let change = first(1, rises, n);
        let [low, high] = if rises {
            [change.before.clone(), change.by.clone().unwrap()]
        } else {
            [change.by.clone().unwrap(), change.before.clone()]
        };
        assert!(low <= at && at <= high && high - low < q(1, 1_000_000_000), "{n}: {change:?}");
        assert!(!change.open && change.holds == rises);
    }
    // It does not depend on r, down to where is looked.
    let change = first(0, false, 2);
    assert_eq!((change.by, change.open, change.before), (None, false, q(9, 20)));
}

/// A chart covers its box once, and what it says of chaos is true at random machines, by their words.
#[test]
fn a_chart_of_chaos_says_what_words_say() {
    let mut drawn = Drawn(1);
    let mut told = [[0; 2]; 2];
    for (ratio, damping) in [
        ([q(1, 10), q(21, 10)], [q(1, 256), q(1, 2)]),
        ([q(3, 10), q(7, 10)], [q(1, 20), q(1, 10)]),
        ([q(1, 2), q(3, 2)], [q(0, 1), q(5, 4)]),
    ] {
        let of = ParameterBox::machine(ratio, damping).unwrap();
        let chart = ChaosChart::new(&of, 5, &()).unwrap();
        let sides = [chart.columns.len() - 1, chart.rows.len() - 1];
        let mut covered = vec![0; sides[0] * sides[1]];
        for cell in &chart.cells {
            for (i, j) in (cell.rows[0]..cell.rows[1])
                .flat_map(|j| (cell.columns[0]..cell.columns[1]).map(move |i| (i, j)))
            {
                covered[j * sides[0] + i] += 1;
            }
            let size = (cell.rows[1] - cell.rows[0]) * (cell.columns[1] - cell.columns[0]);
            if size == 1 && drawn.below(4) > 0 {
                continue;
            }
            let bounds = chart.bounds(cell);
            let at = along(&bounds, [drawn.below(1010), drawn.below(1010)]);
            let Some(exact) = Exact::of_machine(&at[0], &at[1]) else { continue };
            let [ratio, damping] = at.each_ref().map(|x| x.to_f64().unwrap());
            let swing = if damping < 1.0 { (1.0 - damping * damping).sqrt() * ratio } else { 0.25 };
            let gamma = (std::f64::consts::TAU * swing).sin() > 0.0;
            for (chaos, positive) in cell.chaos.into_iter().zip([true, false]) {
                let Some(born) = chaos else { continue };
                let case = Case::from_signs(positive, positive == gamma);
                let loops = (1..120).filter(|&n| exact.edge(case, n, n) == Edge::Yes).count();
                assert_eq!(born, loops > 1, "{case} at {at:?}");
                told[usize::from(positive)][usize::from(born)] += 1;
            }
        }
        assert!(covered.iter().all(|&times| times == 1));
    }
    assert!(told.as_flattened().iter().all(|&times| times > 20), "{told:?}");
    let point = ParameterBox::machine([q(1, 2), q(1, 2)], [q(1, 10), q(1, 5)]).unwrap();
    assert!(ChaosChart::new(&point, 5, &()).unwrap_err().is_input());
}
