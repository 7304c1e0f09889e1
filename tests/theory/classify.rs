//! Existence at a point: the definition, the record form and the paper's claim, against one another and exact
//! arithmetic.

use crate::common;

use grazing::{
    existence::{
        Case, Claim, Existence, Resonance, Variant, by_definition, by_enclosures, by_records, claimed,
        intervals, large_eigenvalue_sign, up_to,
    },
    local::{Ladder, Plane, Point, Polar, Region},
    number::{FloatInterval, parse_rational},
};
use grazing_base::random::Random;
use num_rational::{BigRational, Ratio};
use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

fn q(text: &str) -> BigRational {
    parse_rational(text).unwrap()
}

fn polar(r: &str, s: &str) -> Point {
    Point::Polar(Polar::new(q(r), q(s)).unwrap())
}

fn plane(a1: &str, a2: &str) -> Point {
    Point::Plane(Plane::new(q(a1), q(a2)).unwrap())
}

/// u_0, …, u_n by the recurrence.
fn u(a1: &BigRational, a2: &BigRational, n: u64) -> Vec<BigRational> {
    let mut u = vec![BigRational::zero(), BigRational::one()];
    for k in 1..n as usize {
        u.push(a1 * &u[k] - a2 * &u[k - 1]);
    }
    u
}

/// The definition in exact fractions, by (59), (60) as they stand: the cases, or `None` on a boundary.
fn exactly(a1: &BigRational, a2: &BigRational, n: u64) -> Option<Vec<Case>> {
    let u = u(a1, a2, n + 1);
    let m = n as usize;
    if u[m].is_zero() {
        return None;
    }
    let power = |k: usize| num_traits::pow(a2.clone(), k);
    let b: Vec<BigRational> = (1..m).map(|k| (&u[m] - &u[k] - power(k) * &u[m - k]) / &u[m]).collect();
    let v = &u[m + 1] - a2 * &u[m - 1];
    let c = -(BigRational::one() - v + power(m)) / &u[m];
    let (some_positive, some_negative) =
        (b.iter().any(Signed::is_positive), b.iter().any(Signed::is_negative));
    if some_positive && some_negative {
        return Some(Vec::new());
    }
    if c.is_zero() || b.iter().any(Zero::is_zero) {
        return None;
    }
    let mut cases = vec![Case::from_signs(!some_negative, c.is_positive())];
    if n == 1 {
        cases.push(cases[0].reversed());
    }
    Some(cases)
}

fn cases(claim: Claim, n: u64) -> Option<Vec<Case>> {
    match claim {
        Claim::Orbit(case) => Some(Existence::Orbit(case).cases(n)),
        Claim::None => Some(Vec::new()),
        Claim::Boundary => None,
        Claim::Undecided => panic!("undecided"),
    }
}

/// Whether an answer says the same as the exact cases; on a boundary it must say so.
fn agrees(found: Existence, n: u64, exact: &Option<Vec<Case>>) -> bool {
    match (found, exact) {
        (Existence::Orbit(_) | Existence::None { .. }, Some(cases)) => found.cases(n) == *cases,
        (Existence::Singular | Existence::Iterate(_) | Existence::SignBoundary, None) => true,
        _ => false,
    }
}

#[test]
fn boundaries_are_named() {
    let ladder = Ladder::default();
    let at = |point: &Point, n| by_definition(&ladder, point, n);
    // a₁ = a₂ = r² = 1 is s = 1/6: u_3 = 0.
    assert_eq!(at(&plane("1", "1"), 3), Existence::Singular);
    assert_eq!(at(&polar("1", "1/6"), 3), Existence::Singular);
    // u_2 = a₁ = 0.
    assert_eq!(at(&plane("0", "1/2"), 2), Existence::Singular);
    // s = 1/3, r = 1: b_{4,3} = 0 = b_{4,1}, and b_{4,2} > 0.
    assert_eq!(at(&polar("1", "1/3"), 4), Existence::Iterate(1));
    assert_eq!(by_records(&ladder, &polar("1", "1/3"), 4).unwrap()[3], Existence::Iterate(1));
    // a₁ = a₂ + 1: an eigenvalue 1.
    assert_eq!(at(&plane("3/2", "1/2"), 1), Existence::SignBoundary);
    assert_eq!(at(&plane("3/2", "1/2"), 2), Existence::Iterate(1));
    // a₁ = −(a₂ + 1): c_2 = 0, b_{2,1} > 0; for odd n the signs of region 5.
    assert_eq!(at(&plane("-3/2", "1/2"), 2), Existence::SignBoundary);
    assert_eq!(at(&plane("-3/2", "1/2"), 5), Existence::Orbit(Case::PlusMinus));
}

/// What admits an orbit where u_n = 0, by its conditions γ u_k/(1 − ζ) > 0, ζ = Aⁿ: all have the sign of γ at
/// the first resonance alone; and s = m/(2n) says the same in its own way.
#[test]
fn a_resonance_is_what_its_conditions_say() {
    let mut seen = [0; 2];
    for n in 2..=24u64 {
        for m in 1..n {
            let of_s = polar("9/10", &format!("{m}/{}", 2 * n));
            let expected = if m == 1 { Resonance::First } else { Resonance::Higher };
            assert_eq!(Resonance::at(&of_s, n), Some(expected), "{m}/{n}");
            assert_eq!(Resonance::at(&of_s, 2 * n), Some(Resonance::Higher), "{m}/{n}");
            assert_eq!(Resonance::at(&polar("1", &format!("{m}/{}", 2 * n)), n), None);
        }
        for a1 in ["0", "1", "-1", "3/2", "-3/2", "1/2", "-2", "6/5"] {
            for (over, other) in [("1", "1/3"), ("1/2", "7"), ("1/3", "1/2"), ("2", "4"), ("1/5", "5")] {
                // a₁² = 0, a₂, 2a₂, 3a₂, and others.
                let a2 = if a1 == "0" { q(other) } else { q(a1) * q(a1) * q(over) };
                if a2.is_one() {
                    continue;
                }
                let u = u(&q(a1), &a2, n);
                let found = Resonance::at(&Point::Plane(Plane::new(q(a1), a2.clone()).unwrap()), n);
                assert_eq!(found.is_some(), u[n as usize].is_zero(), "a₁ = {a1}, a₂ = {a2}, n = {n}");
                // ζ = u_{n+1} where u_n = 0; 1 − ζ is the same for all k.
                let inner = &u[1..n as usize];
                let one_sign = inner.iter().all(Signed::is_positive) || inner.iter().all(Signed::is_negative);
                if let Some(found) = found {
                    assert_eq!(found == Resonance::First, one_sign, "a₁ = {a1}, a₂ = {a2}, n = {n}");
                    seen[usize::from(one_sign)] += 1;
                }
            }
        }
    }
    assert!(seen[0] > 20 && seen[1] > 4, "{seen:?}");
}

#[test]
fn the_circle_has_theorem_2s_intervals() {
    let ladder = Ladder::default();
    for n in 1..=25u64 {
        for interval in intervals(n).unwrap() {
            let middle = (interval.left + interval.right) / 2;
            let s = BigRational::new((*middle.numer()).into(), (*middle.denom()).into());
            for r in [BigRational::one(), q("1-2^-200")] {
                let point = Point::Polar(Polar::new(r, s.clone()).unwrap());
                let found = by_definition(&ladder, &point, n);
                assert!(found.cases(n).contains(&interval.case), "n = {n}, s = {s}: {found:?}");
                assert_eq!(by_records(&ladder, &point, n).unwrap()[n as usize - 1].cases(n), found.cases(n));
                assert_eq!(cases(claimed(&ladder, &point, n, Variant::True), n), Some(found.cases(n)));
            }
        }
    }
}

#[test]
fn equal_eigenvalues_belong_to_regions_2_and_4() {
    let ladder = Ladder::default();
    for lambda in ["1/2", "-1/2", "1-2^-60", "-1+2^-60", "2^-30", "-2^-30"] {
        let (a1, a2) = (q(lambda) * q("2"), q(lambda) * q(lambda));
        let point = Point::Plane(Plane::new(a1.clone(), a2.clone()).unwrap());
        for n in 1..=12 {
            let exact = exactly(&a1, &a2, n);
            assert!(agrees(by_definition(&ladder, &point, n), n, &exact), "λ = {lambda}, n = {n}");
            assert_eq!(cases(claimed(&ladder, &point, n, Variant::True), n), exact, "λ = {lambda}, n = {n}");
        }
    }
}

/// Fractions with all kinds of size: small, near ±1, near 0.
fn fraction() -> impl Strategy<Value = BigRational> {
    (1i64..1000, 1i64..1000, 0u32..60, prop::bool::ANY).prop_map(|(p, q, e, near)| {
        let x = Ratio::new(p.min(q), p.max(q));
        let x = BigRational::new((*x.numer()).into(), (*x.denom()).into());
        let power = BigRational::from_integer(2.into()).pow(-(e as i32));
        if near { BigRational::one() - x * power } else { x * power }
    })
}

proptest! {
    #![proptest_config(common::config())]

    /// Everywhere in the plane: definition, records, claim and the large eigenvalue against exact fractions.
    #[test]
    fn all_ways_agree_in_the_plane(a2 in fraction(), t in fraction(), sign in prop::bool::ANY, wide in 0u8..4, n in 1u64..25) {
        prop_assume!(a2.is_positive() && a2 < BigRational::one() && t.is_positive());
        // a₁ across all regions: scaled by 1, by a₂ + 1 or by 3, or on the equal-eigenvalue parabola's side.
        let scale = match wide { 0 => a2.clone() + BigRational::one(), 1 => q("3"), 2 => q("2") * &a2, _ => q("1") };
        let a1 = if sign { t * scale } else { -t * scale };
        let ladder = Ladder::default();
        let plane = Plane::new(a1.clone(), a2.clone()).unwrap();
        let region = plane.region();
        let point = Point::Plane(plane);
        let exact = exactly(&a1, &a2, n);
        let found = by_definition(&ladder, &point, n);
        prop_assert!(agrees(found, n, &exact), "definition: {:?}, exactly {:?}", found, exact);
        if let Some(records) = by_records(&ladder, &point, n) {
            let record = records[n as usize - 1];
            prop_assert!(agrees(record, n, &exact), "records: {:?}, exactly {:?}", record, exact);
        } else {
            prop_assert!(!matches!(region, Region::Two | Region::Three | Region::Four));
        }
        if region != Region::Line {
            prop_assert_eq!(cases(claimed(&ladder, &point, n, Variant::True), n), exact.clone());
        }
        // Time reversal: the same orbits.
        let (b1, b2) = (&a1 / &a2, a2.recip());
        prop_assert_eq!(exactly(&b1, &b2, n), exact.clone());
        // (61): the sign of eµ (λ₁ⁿ − 1)(λ₂ⁿ − 1) = eµ (1 − v_n + a₂ⁿ).
        let u = u(&a1, &a2, n + 1);
        let m = n as usize;
        let v = &u[m + 1] - &a2 * &u[m - 1];
        let factor = BigRational::one() - v + num_traits::pow(a2.clone(), m);
        for case in exact.into_iter().flatten() {
            let expected = if factor.is_positive() { case.sign_emu() } else { -case.sign_emu() };
            prop_assert_eq!(large_eigenvalue_sign(region, n, case), expected);
        }
    }

    /// In region 3 by (r, s): definition, records and claim.
    #[test]
    fn all_ways_agree_from_r_and_s(r in fraction(), s in fraction(), n in 2u64..60) {
        prop_assume!(r.is_positive() && r < BigRational::one());
        let s = s / BigRational::from_integer(2.into());
        prop_assume!(s.is_positive() && s < q("1/2"));
        let ladder = Ladder::default();
        let point = Point::Polar(Polar::new(r, s).unwrap());
        let found = by_definition(&ladder, &point, n);
        let record = by_records(&ladder, &point, n).unwrap()[n as usize - 1];
        prop_assert_ne!(found, Existence::Undecided);
        prop_assert_eq!(std::mem::discriminant(&found), std::mem::discriminant(&record));
        prop_assert_eq!(found.cases(n), record.cases(n));
        match claimed(&ladder, &point, n, Variant::True) {
            // Nothing is claimed on a boundary; what the definition finds there is not an orbit.
            Claim::Boundary => prop_assert!(found.cases(n).is_empty()),
            claim => prop_assert_eq!(cases(claim, n).unwrap(), found.cases(n)),
        }
    }
}

/// Enclosures alone say what the exact point has, or nothing: random points, and beside every kind of
/// boundary.
#[test]
fn enclosures_say_what_exact_numbers_do() {
    let (ladder, mut random) = (Ladder::default(), Random::of_unit(11, 0));
    let (mut told, mut open) = (0, 0);
    for case in 0..2000 {
        let unit = |random: &mut Random| random.within(1, 1 << 40) as f64 / (1u64 << 40) as f64;
        let (mut a2, side) = (unit(&mut random), 2.0 * unit(&mut random) - 1.0);
        let mut a1 = side * (1.0 + a2);
        let tiny = 0.1f64.powi(random.within(8, 17) as i32);
        match case % 4 {
            // u_3 = 0 or u_2 = 0, b_{3,2} = 0 (a₁ = −½, a₂ = ½), and r = 1.
            1 => a1 = if case % 8 == 1 { a2.sqrt() } else { a2 * 1e-12 },
            2 => (a1, a2) = (-0.5 + side * tiny, 0.5),
            3 => (a1, a2) = (2.0 * side, 1.0),
            _ => {}
        }
        let [x, y] = [a1, a2].map(|x| FloatInterval::from_bounds(x, x));
        let plane =
            Plane::new(BigRational::from_float(a1).unwrap(), BigRational::from_float(a2).unwrap()).unwrap();
        let exact = up_to(&ladder, &Point::Plane(plane), 24, || Ok(())).unwrap();
        match by_enclosures(&x, &y, 24) {
            Some(found) => {
                assert_eq!(found, exact, "{a1} {a2}");
                told += 1;
            }
            None => open += 1,
        }
        // Beyond a₂ = 1 and on |a₁| = a₂ + 1 nothing is said; in regions 1 and 5 all.
        let point = |x: f64| FloatInterval::from_bounds(x, x);
        assert!(by_enclosures(&x, &point(a2 + 1.0), 3).is_none());
        assert!(by_enclosures(&point(1.5), &point(0.5), 3).is_none());
        let beyond = a2 + 1.0 + 1.0 / (1u64 << (case % 40)) as f64;
        for a1 in [beyond, -beyond] {
            let [a1, a2] = [a1, a2].map(|x| BigRational::from_float(x).unwrap());
            let outside = up_to(&ladder, &Point::Plane(Plane::new(a1, a2).unwrap()), 9, || Ok(())).unwrap();
            let sign = if outside[0] == Existence::Orbit(Case::PlusPlus) { 1.0 } else { -1.0 };
            assert_eq!(by_enclosures(&point(sign * beyond), &y, 9), Some(outside), "{beyond} {y:?}");
        }
    }
    assert!(told > 1000 && open > 50, "{told} {open}");
}
