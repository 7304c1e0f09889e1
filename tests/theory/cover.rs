//! Covers as the search makes them: complete, true at random points by multi-precision, the same however a
//! run goes.

use std::{collections::HashMap, sync::Mutex};

use grazing::{
    certificate::{self, cover::Leaf},
    existence::{Existence, Variant, by_definition},
    local::{Answer, Ladder, Point, Polar, Quantity},
    number::Sign,
    search::cover::{Cell, Chart, Cover, CoverOptions, certificate, cover, strips, units},
};
use num_bigint::BigInt;
use num_rational::BigRational;

fn covers(options: &CoverOptions) -> Vec<Cover> {
    cover(options, HashMap::new(), &(), &|_, _| Ok(())).unwrap()
}

/// The numbers of a simple generator: these tests are the same on every run.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, bound: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % bound
    }

    /// A point of an interval, its ends included.
    fn between(&mut self, [low, high]: &[BigRational; 2]) -> BigRational {
        low + (high - low) * BigRational::new(self.below(4097).into(), BigInt::from(4096))
    }
}

/// All leaves of the covers of some periods, with their boxes.
fn all_leaves(covers: &[Cover]) -> Vec<(u64, Chart, Leaf, Cell)> {
    let mut all = Vec::new();
    for cover in covers {
        cover.leaves(|chart, leaf, cell| all.push((cover.n, chart.clone(), leaf, cell)));
    }
    all
}

#[test]
fn nothing_is_open_and_the_checker_agrees() {
    let options = CoverOptions::new(3..=16);
    let covers = covers(&options);
    let blocks: Vec<String> = covers.iter().map(|cover| cover.block().unwrap()).collect();
    let text = certificate(&options.periods, &blocks);
    let checked = certificate::check(&mut text.as_bytes()).unwrap();
    assert_eq!((checked.kind, checked.range), ("cover", Some(3..=16)));
    for cover in &covers {
        let tally = cover.tally();
        assert!(tally.open.is_empty() && cover.refuted.is_none());
        // φ(n) + 1 areas.
        let coprime = (1..cover.n).filter(|&m| num_integer::gcd(m, cover.n) == 1).count();
        assert_eq!(tally.areas as usize, coprime + 1);
    }
}

/// The boxes of a chart fill it: their areas add up, exactly.
#[test]
fn leaves_tile_region_3() {
    for cover in covers(&CoverOptions::new(3..=12)) {
        let mut area = BigRational::from_integer(0.into());
        cover.leaves(|chart, _, cell| {
            let [r, s] = chart.bounds(&cell);
            area += (&r[1] - &r[0]) * (&s[1] - &s[0]);
        });
        assert_eq!(area, cover.r_max / BigInt::from(2), "n = {}", cover.n);
    }
}

/// Whether a leaf's claim is true at a point; `None` where multi-precision cannot tell or u_n = 0.
fn holds(ladder: &Ladder, n: u64, chart: &Chart, leaf: Leaf, point: &Point) -> Option<bool> {
    let found = by_definition(ladder, point, n);
    let b = |k| match ladder.sign(point, Quantity::B { n, k }).answer {
        Answer::Sign(sign) => Some(sign),
        _ => None,
    };
    let case = chart.strip.interval.as_ref().map(|interval| interval.case);
    match (leaf, found) {
        (_, Existence::Undecided | Existence::Singular) | (Leaf::Open, _) => None,
        (Leaf::None { positive, negative }, Existence::None { .. }) => {
            let (positive, negative) = (b(positive)?, b(negative)?);
            Some(positive != Sign::Zero && positive == -negative)
        }
        (Leaf::Orbit { .. }, Existence::Orbit(found)) => Some(Some(found) == case),
        (Leaf::Edge { deciding, .. }, Existence::Orbit(found)) => {
            Some(Some(found) == case && b(deciding)? == sign_of(found.sign_emu()))
        }
        (Leaf::Edge { deciding, .. }, Existence::None { .. } | Existence::Iterate(_)) => {
            Some(b(deciding)? != sign_of(case?.sign_emu()))
        }
        _ => Some(false),
    }
}

fn sign_of(sign: i8) -> Sign {
    if sign > 0 { Sign::Positive } else { Sign::Negative }
}

#[test]
fn claims_hold_at_random_points_in_multi_precision() {
    let (ladder, mut numbers) = (Ladder::default(), Numbers(1));
    let periods: Vec<Cover> =
        covers(&CoverOptions::new(3..=20)).into_iter().chain(covers(&CoverOptions::new(37..=37))).collect();
    let leaves = all_leaves(&periods);
    let mut decided = 0;
    for _ in 0..10_000 {
        let (n, chart, leaf, cell) = &leaves[numbers.below(leaves.len() as u64) as usize];
        let [r, s] = chart.bounds(cell);
        let (r, s) = (numbers.between(&r), numbers.between(&s));
        // r = 0 and s = 0, ½ belong to no point of region 3.
        let Ok(polar) = Polar::new(r.clone(), s.clone()) else { continue };
        if let Some(holds) = holds(&ladder, *n, chart, *leaf, &Point::Polar(polar)) {
            assert!(holds, "{leaf} of n = {n} at r = {r}, s = {s}");
            decided += 1;
        }
    }
    assert!(decided > 9_500, "{decided}");
}

/// Where an Orbit leaf touches u_n = 0, its box goes up to the line and not beyond.
#[test]
fn singular_lines_are_sides_of_strips() {
    for n in 3..=40 {
        let strips = strips(n, Variant::True).unwrap();
        for pair in strips.windows(2) {
            assert_eq!(pair[0].right, pair[1].left);
        }
        for j in 0..=n {
            let line = num_rational::Ratio::new(j, 2 * n);
            assert!(strips.iter().any(|strip| strip.left == line || strip.right == line));
        }
    }
}

#[test]
fn false_variants_are_refuted_at_a_point() {
    for variant in [Variant::NeighboursExchanged, Variant::EndsShifted] {
        for cover in covers(&CoverOptions { variant, ..CoverOptions::new(5..=9) }) {
            // With n₊ = n₋ nothing is exchanged; n = 4, 6 have only such areas, or ends 1/n.
            let case = cover.refuted.clone();
            let case = case.unwrap_or_else(|| panic!("{variant:?} of n = {} is not refuted", cover.n));
            assert_eq!(case.n, cover.n);
            let existence = by_definition(&Ladder::default(), &case.point, case.n);
            assert!(
                matches!(existence, Existence::Orbit(_) | Existence::None { .. }),
                "{case}: {existence:?}"
            );
            assert!(!cover.is_complete());
        }
    }
}

#[test]
fn what_cannot_be_decided_is_left_open_and_listed() {
    let options = CoverOptions { max_depth: 3, ..CoverOptions::new(8..=8) };
    let cover = covers(&options).remove(0);
    let tally = cover.tally();
    assert!(!tally.open.is_empty() && tally.open_area() > 0.0 && tally.depth == 3);
    let text = certificate(&options.periods, &[cover.block().unwrap()]);
    let rejection = certificate::check(&mut text.as_bytes()).unwrap_err().to_string();
    assert!(rejection.contains(&format!("{} leaves are open", tally.open.len())), "{rejection}");
}

/// Very near r = 1 rounding hides its sign: those boxes are open, and no others are claimed wrongly.
#[test]
fn what_rounding_hides_is_left_open() {
    let r_max = BigRational::new(((1u64 << 40) - 1).into(), (1u64 << 40).into());
    let options = CoverOptions { r_max: Some(r_max), ..CoverOptions::new(5..=5) };
    let cover = covers(&options).remove(0);
    let open = cover.tally().open.len();
    let text = certificate(&options.periods, &[cover.block().unwrap()]);
    let rejection = certificate::check(&mut text.as_bytes()).unwrap_err().to_string();
    assert!(open > 0 && rejection.contains(&format!("all else being proved, {open} leaves")), "{rejection}");
}

/// A unit depends on nothing but its period and strip: known ones are taken as they are, the others come out
/// alike.
#[test]
fn a_run_goes_on_from_any_subset() {
    let options = CoverOptions::new(7..=9);
    let done = Mutex::new(HashMap::new());
    let keep = |unit, trees: &str| {
        done.lock().unwrap().insert(unit, trees.to_string());
        Ok(())
    };
    let whole: Vec<_> = cover(&options, HashMap::new(), &(), &keep).unwrap();
    let done = done.into_inner().unwrap();
    assert_eq!(done.len(), units(&options).unwrap().len());
    let mut numbers = Numbers(2);
    for _ in 0..10 {
        let known: HashMap<_, _> = done
            .iter()
            .filter(|_| numbers.below(2) == 0)
            .map(|(unit, trees)| (*unit, trees.clone()))
            .collect();
        let (expected, count) = (done.len() - known.len(), Mutex::new(0));
        let again = cover(&options, known, &(), &|_, _| {
            *count.lock().unwrap() += 1;
            Ok(())
        });
        for (a, b) in again.unwrap().iter().zip(&whole) {
            assert_eq!(a.block(), b.block());
        }
        assert_eq!(count.into_inner().unwrap(), expected);
    }
    let damaged = HashMap::from([((8, 0), "M;".to_string())]);
    assert!(cover(&options, damaged, &(), &|_, _| Ok(())).unwrap_err().is_input());
}
