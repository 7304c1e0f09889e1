//! The lower edges of the areas and their lowest points, against the polynomials in (a₁, a₂) in exact
//! arithmetic.

use crate::{common, samples::samples};

use grazing::{
    existence::{Boundary, Case, Enclosure, Lowest, Tip, intervals, tip_correction, tip_law},
    number::parse_rational,
};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use proptest::prelude::*;

fn fraction(p: impl Into<BigInt>, q: impl Into<BigInt>) -> BigRational {
    BigRational::new(p.into(), q.into())
}

/// cos 2πs within 10⁻⁴⁰ on either side, from 50 digits of π and the Taylor series: no code of the crate's.
fn cosine(s: &BigRational) -> [BigRational; 2] {
    let pi = parse_rational("3.14159265358979323846264338327950288419716939937511").unwrap();
    let scale: BigInt = BigInt::from(10).pow(60);
    let x = (s * pi * BigInt::from(2) * &scale).to_integer();
    let square = &x * &x / &scale;
    let (mut term, mut sum) = (scale.clone(), BigInt::zero());
    for i in 0..60 {
        sum += &term;
        term = -(term * &square) / &scale / ((2 * i + 1) * (2 * i + 2));
    }
    let margin = BigInt::from(10).pow(20);
    [fraction(&sum - &margin, scale.clone()), fraction(sum + margin, scale)]
}

/// The signs of b_{n,1}, …, b_{n,n−1} by (59), where they agree at both ends of the enclosure of cos 2πs.
fn signs(n: usize, r: &BigRational, s: &BigRational) -> Vec<Option<bool>> {
    let exact = |c: &BigRational| {
        let (a1, a2) = (r * c * BigInt::from(2), r * r);
        let mut u = vec![BigRational::zero(), BigRational::one()];
        let mut powers = vec![BigRational::one()];
        for k in 1..n {
            u.push(&a1 * &u[k] - &a2 * &u[k - 1]);
            powers.push(&powers[k - 1] * &a2);
        }
        let b = |k: usize| (&u[n] - &u[k] - &powers[k] * &u[n - k]) / &u[n];
        (1..n).map(|k| b(k).is_positive()).collect::<Vec<bool>>()
    };
    let [low, high] = cosine(s).each_ref().map(exact);
    low.into_iter().zip(high).map(|(a, b)| (a == b).then_some(a)).collect()
}

fn inside(boundary: &Boundary, i: i64, grid: i64) -> BigRational {
    let [left, right] =
        [&boundary.interval().left, &boundary.interval().right].map(|x| fraction(*x.numer(), *x.denom()));
    &left + (right - &left) * fraction(i, grid + 1)
}

fn boundaries(n: u64) -> impl Iterator<Item = Boundary> {
    intervals(n).unwrap().map(Boundary::new)
}

fn tip(boundary: &Boundary, digits: u32) -> Option<Tip> {
    match boundary.lowest(digits).expect("every lowest point is certified") {
        Lowest::Tip(tip) => Some(tip),
        Lowest::Zero { .. } | Lowest::Region4 => None,
    }
}

/// Above the edge all b have the case's sign, below it the deciding one is negative, by exact polynomials at
/// the ends of the enclosure.
#[test]
fn polynomials_change_sign_across_the_edge() {
    let mut crossings = 0;
    for n in 3..=if samples::<u64>(1) > 1 { 12 } else { 11 } {
        for boundary in boundaries(n) {
            for i in 1..=4 {
                let s = inside(&boundary, i, 4);
                let Enclosure { lower, upper } = boundary.at(&s, 15).unwrap().unwrap();
                let positive = boundary.interval().case != Case::MinusPlus;
                if upper.is_zero() {
                    for r in ["1/10", "1/2", "0.999"] {
                        let signs = signs(n as usize, &parse_rational(r).unwrap(), &s);
                        assert!(
                            signs.iter().all(|&sign| sign == Some(positive)),
                            "n = {n}, s = {s}, r = {r}"
                        );
                    }
                    continue;
                }
                assert!(&upper - &lower <= parse_rational("2e-17").unwrap());
                let above = signs(n as usize, &upper, &s);
                assert!(above.iter().all(|&sign| sign == Some(true)), "n = {n}, s = {s}: {above:?}");
                let deciding = boundary.interval().deciding.unwrap() as usize;
                assert_eq!(signs(n as usize, &lower, &s)[deciding - 1], Some(false), "n = {n}, s = {s}");
                crossings += 1;
            }
        }
    }
    assert!(crossings > 80);
}

/// Exact zeros: N_{3,2} = (a₁ − a₂ − 1)(a₁ + a₂), so that r = −2 cos 2πs; N_{3,1} = (a₁ − a₂ − 1)(a₁ + 1).
#[test]
fn period_three_in_closed_form() {
    let all: Vec<Boundary> = boundaries(3).collect();
    for i in 1..20 {
        let s = inside(&all[1], i, 19);
        let [c, c2] = cosine(&s);
        let r = all[1].at(&s, 20).unwrap().unwrap();
        if c2.is_positive() || s == fraction(1, 4) {
            assert_eq!(r, Enclosure::zero(), "s = {s}");
        } else {
            assert!(r.lower < c2 * BigInt::from(-2) && c * BigInt::from(-2) < r.upper, "s = {s}");
        }
        let s = inside(&all[2], i, 19);
        let [c, c2] = cosine(&s).map(|c| (c * BigInt::from(-2)).recip());
        let r = all[2].at(&s, 20).unwrap().unwrap();
        assert!(r.lower < c.clone().max(c2.clone()) && c.min(c2) < r.upper, "s = {s}");
    }
    assert!(all[1].at(&fraction(1, 6), 20).unwrap_err().is_input());
}

/// No value of R on a grid is below the certified minimum, and one is near it; the place is near the best of
/// the grid.
#[test]
fn lowest_points_against_a_scan() {
    for n in [4, 5, 7, 8, 12, 17, 30] {
        for boundary in boundaries(n) {
            let Some(tip) = tip(&boundary, 12) else { continue };
            let scan = (1..=60).map(|i| {
                let s = inside(&boundary, i, 60);
                let r = boundary.at(&s, 12).unwrap().unwrap();
                assert!(r.upper >= tip.r.lower, "n = {n}, s = {s}");
                (r.middle(), s)
            });
            let (least, place) = scan.min().unwrap();
            let depth = BigRational::one() - &tip.r.lower;
            assert!(least - &tip.r.upper < depth * fraction(1, 100), "n = {n}");
            let width = inside(&boundary, 1, 60) - inside(&boundary, 0, 60);
            assert!((place - tip.s.middle()).abs() < width * BigInt::from(2), "n = {n}");
            let there = boundary.at(&tip.s.middle(), 12).unwrap().unwrap();
            assert!(there.lower <= tip.r.upper && tip.r.lower <= there.upper, "n = {n}");
            assert!(&tip.r.upper - &tip.r.lower <= parse_rational("1e-12").unwrap());
        }
    }
}

fn scaled(n: u64, tip: &Tip) -> f64 {
    (BigRational::one() - tip.r.middle()).to_f64().unwrap() * (n as f64).powi(3)
}

#[test]
fn known_tips() {
    let known = [(7, 8.334), (31, 27.900), (61, 8.527), (81, 10.979), (99, 15.464)];
    for (m, value) in known {
        let area = boundaries(200).find(|b| b.interval().m == m && b.interval().case == Case::PlusPlus);
        let tip = tip(&area.unwrap(), 20).unwrap();
        assert!((scaled(200, &tip) - value).abs() < 5e-4, "m = {m}: {}", scaled(200, &tip));
    }
}

/// The law, its rate 1/n² and the coefficient of that: doubling n divides what is left by 8.
#[test]
fn tips_follow_the_law() {
    let pi = std::f64::consts::PI;
    assert!((tip_law(0.0).1 - pi * pi / 2.0).abs() < 1e-14);
    let (mut left, mut previous) = (Vec::new(), None::<f64>);
    for n in [40u64, 80, 160] {
        let worst = boundaries(n)
            .filter_map(|b| tip(&b, 20).map(|tip| (b.interval().deciding.unwrap() as f64 / n as f64, tip)))
            .filter(|(t, _)| *t < 0.6)
            .map(|(t, tip)| {
                let found = scaled(n, &tip) - tip_law(t).1;
                assert!(found > 0.0, "n = {n}, t = {t}");
                (found * (n * n) as f64 / tip_correction(t) - 1.0).abs()
            })
            .fold(0.0, f64::max);
        if let Some(previous) = previous {
            left.push(previous / worst);
        }
        previous = Some(worst);
    }
    assert!(left.iter().all(|ratio| (1.7..2.3).contains(ratio)), "{left:?}");
}

#[test]
fn lowest_points_that_are_zero() {
    for n in 3..=30 {
        for boundary in boundaries(n) {
            let interval = boundary.interval().clone();
            let expected = match boundary.lowest(5).unwrap() {
                Lowest::Zero { left, right } if interval.m == 0 => {
                    left.is_zero() && right == fraction(1, 2 * n)
                }
                Lowest::Zero { left, right } => {
                    assert_eq!(boundary.at(&right, 10).unwrap(), Some(Enclosure::zero()));
                    let beyond = &right + fraction(1, 1_000_000_000);
                    assert!(boundary.at(&beyond, 10).unwrap().unwrap().upper.is_positive());
                    interval.m == 1 && interval.case == Case::PlusPlus && left == fraction(1, 2 * n)
                }
                Lowest::Region4 => n % 2 == 1 && 2 * interval.m + 1 == n && interval.case == Case::PlusMinus,
                Lowest::Tip(tip) => tip.r.lower.is_positive() && interval.deciding < Some(n - 2),
            };
            assert!(expected, "{interval:?}");
        }
    }
}

proptest! {
    #![proptest_config(common::config())]

    /// More digits refine; the edge lies above the lowest point; a₂ is r².
    #[test]
    fn enclosures_are_consistent(n in 3u64..400, pick in 0usize..1000, i in 1i64..1000, digits in 1u32..60) {
        let all: Vec<Boundary> = boundaries(n).collect();
        let boundary = &all[pick % all.len()];
        let s = inside(boundary, i, 1000);
        let (coarse, fine) = (boundary.at(&s, digits).unwrap().unwrap(), boundary.at(&s, digits + 20).unwrap().unwrap());
        prop_assert!(coarse.lower <= fine.upper && fine.lower <= coarse.upper);
        for (found, digits) in [(&coarse, digits), (&fine, digits + 20)] {
            let most = BigRational::new(2.into(), num_traits::pow(10.into(), digits as usize + 2));
            prop_assert!(found.lower <= found.upper && &found.upper - &found.lower <= most);
        }
        prop_assert!(!coarse.lower.is_negative() && coarse.upper <= BigRational::one());
        if let Some(tip) = tip(boundary, digits.max(17)) {
            prop_assert!(fine.upper >= tip.r.lower);
            prop_assert!(tip.s.lower < tip.s.upper);
        }
    }
}
