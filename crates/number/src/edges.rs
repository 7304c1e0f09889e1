//! Tests of balls and radii at the ends of their ranges, and of roundings that ordinary values never show.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::{
    Ball, Circular, Elementary, Precision, Real, Sign,
    exponent::{Exponent, Misfit},
    radius::Radius,
};

const LIMIT: i128 = 1 << 62;

fn dyadic(m: impl Into<BigInt>, e: i128) -> BigRational {
    let power = BigInt::one() << e.unsigned_abs();
    let m = m.into();
    if e < 0 { BigRational::new(m, power) } else { BigRational::from_integer(m * power) }
}

/// Whether |x| ≤ radius·2^−shift. A bound beyond 2^±20000 is not written out.
fn bounds(radius: Radius, shift: i128, x: &BigRational) -> bool {
    let (m, e) = radius.parts();
    match e - shift {
        _ if radius.is_infinite() || x.is_zero() => true,
        _ if m == 0 => false,
        20_000.. => true,
        e @ -20_000.. => x.abs() <= dyadic(m, e),
        _ => false,
    }
}

/// Whether x·2^shift lies in the ball.
fn holds(ball: &Ball, shift: i128, x: &BigRational) -> bool {
    let mid = if ball.mid().is_zero() || ball.radius().is_infinite() {
        BigRational::zero()
    } else {
        dyadic(ball.mid().clone(), ball.unit_exponent() - shift)
    };
    bounds(ball.radius(), shift, &(x - mid))
}

#[test]
fn exponents_fit_or_say_on_which_side_they_do_not() {
    for e in [0, 1, -1, LIMIT, -LIMIT] {
        assert_eq!(Exponent::fit(e).unwrap().wide(), e);
    }
    assert_eq!(Exponent::fit(LIMIT + 1), Err(Misfit::Above));
    assert_eq!(Exponent::fit(-LIMIT - 1), Err(Misfit::Below));
    assert_eq!(Exponent::fit(i128::MAX), Err(Misfit::Above));
    assert_eq!(Exponent::LOWEST.wide(), -LIMIT);
}

/// Sums, products and quotients of radii against exact ones: never less, and less than one part in 2³⁰ more.
#[test]
fn radii_round_up() {
    let mantissas =
        [1u64, 3, (1 << 31) + 1, u32::MAX as u64, (1 << 32) + 1, (1 << 33) + 1, (1 << 62) + 1, u64::MAX];
    let shifts = [0i128, 1, 2, 30, 31, 32, 33, 40, 70];
    let close = |radius: Radius, exact: &BigRational, what: &str| {
        assert!(bounds(radius, 0, exact), "{what} is rounded down");
        assert!(!bounds(radius, 0, &(exact * dyadic((1 << 29) + 1, -29))), "{what} is rounded too far up");
    };
    for &a in &mantissas {
        close(Radius::new(a, 5), &dyadic(a, 5), "a new radius");
        let big = BigInt::from(a) * BigInt::from(u64::MAX) + 1;
        close(Radius::of(&big, -7), &dyadic(big.clone(), -7), "the radius of an integer");
        for &b in &mantissas {
            for &shift in &shifts {
                let (x, y) = (Radius::new(a, 0), Radius::new(b, -shift));
                let [exact_x, exact_y] = [x, y].map(|radius| dyadic(radius.parts().0, radius.parts().1));
                close(x + y, &(&exact_x + &exact_y), "a sum");
                close(y + x, &(&exact_x + &exact_y), "a sum");
                close(x * y, &(&exact_x * &exact_y), "a product");
                let (m, e) = y.parts();
                close(x.over(m, e), &(exact_x / exact_y), "a quotient");
            }
        }
    }
}

#[test]
fn radii_at_the_ends_of_their_range_stay_bounds() {
    let least = Radius::new(1, -2 * LIMIT);
    assert!(!least.is_zero() && !least.is_infinite() && least.parts() == (1 << 31, -LIMIT));
    assert_eq!(least * least, least);
    assert!(least.is_below(Radius::one()) && !Radius::one().is_below(least) && !least.is_below(least));
    let most = Radius::new(u32::MAX.into(), LIMIT);
    assert!(!most.is_infinite());
    for sum in [most + most, most * most, Radius::new(1, LIMIT + 32), Radius::INFINITE + least] {
        assert!(sum.is_infinite() && !sum.is_below(most) && most.is_below(sum) && !sum.is_below(sum));
        assert!(!sum.is_within(i128::MAX) && (sum * Radius::ZERO).is_infinite());
    }
    // A difference of exponents of 2⁶³, and a quotient beyond both ends.
    assert_eq!((Radius::new(1 << 31, LIMIT) + least).parts().1, LIMIT);
    assert!(most.over(1 << 31, -LIMIT).is_infinite());
    assert_eq!(least.over(1 << 31, LIMIT), least);
}

/// Every operation on x·2^E, y·2^E for E up to both ends: the result holds the true value, or is the whole
/// line.
#[test]
fn operations_hold_at_every_exponent() {
    let bits = 40;
    let ends = [LIMIT, LIMIT - 80, LIMIT / 2, LIMIT / 2 - 39, LIMIT / 2 - 100, 1 << 40];
    let exponents: Vec<i128> = ends.iter().flat_map(|&e| [e, -e]).chain([0]).collect();
    let mids: [i64; 5] = [0, 1, -5, (1 << 39) - 1, -(1 << 39) + 3];
    let radii = [Radius::ZERO, Radius::new(3, -2), Radius::new(1, 60)];
    let scaled = |radius: Radius, e: i128| {
        let (m, unit) = radius.parts();
        if radius.is_zero() { radius } else { Radius::new(m, unit + e) }
    };
    let cases: Vec<(i64, Radius)> = mids.iter().flat_map(|&m| radii.map(|r| (m, r))).collect();
    let mut known = 0;
    for &e in &exponents {
        for &(a, ra) in &cases {
            let x = Ball::new(a.into(), e, scaled(ra, e), bits);
            // The middle and the two ends of what x stands for.
            let (m, unit) = ra.parts();
            let points =
                |a: i64, r: BigRational| [-r.clone(), BigRational::zero(), r].map(|r| dyadic(a, 0) + r);
            let xs = points(a, dyadic(m, unit));
            assert!(xs.iter().all(|p| holds(&x, e, p)), "2^{e}");
            assert!(holds(&-x.clone(), e, &-xs[2].clone()));
            if let Some((least, at)) = x.least_magnitude() {
                assert!(xs.iter().all(|p| p.abs() >= dyadic(least, at - e)), "2^{e}: {a} {ra:?}");
            }
            if let Some(sign) = x.sign() {
                assert!(xs.iter().all(|p| Sign::of(p) == sign));
                if e % 2 == 0 && sign == Sign::Positive {
                    let root = x.sqrt();
                    assert!(holds(&root, e / 2, &BigRational::zero()) != root.sign().is_some());
                    let square = root.clone() * &root;
                    assert!(xs.iter().all(|p| holds(&square, e, p)), "√ at 2^{e}: {a} {ra:?}");
                }
            }
            let _ =
                (x.exponent(), x.least_exponent(), x.certain_bits(), x.exact_bounds(), x.contains(&xs[0]));
            for &(b, rb) in &cases {
                let y = Ball::new(b.into(), e, scaled(rb, e), bits);
                let opposite = Ball::new(b.into(), -e, scaled(rb, -e), bits);
                let (m, unit) = rb.parts();
                let results = [
                    (x.clone() + &y, e),
                    (x.clone() - &y, e),
                    (x.clone().hull(&y), e),
                    (x.clone() * &y, 2 * e),
                    (x.clone() * &opposite, 0),
                    (x.clone() / &y, 0),
                    (x.clone() / &opposite, 2 * e),
                ];
                known += results.iter().filter(|(ball, _)| !ball.radius().is_infinite()).count();
                for p in &xs {
                    for q in &points(b, dyadic(m, unit)) {
                        let quotient = if q.is_zero() { BigRational::zero() } else { p / q };
                        let exact = [p + q, p - q, p.clone(), p * q, p * q, quotient.clone(), quotient];
                        for (i, ((ball, shift), exact)) in results.iter().zip(&exact).enumerate() {
                            if i < 5 || !q.is_zero() {
                                assert!(
                                    holds(ball, *shift, exact),
                                    "{i} at 2^{e}: ({a}, {ra:?}), ({b}, {rb:?})"
                                );
                            }
                        }
                    }
                }
            }
        }
    }
    assert!(known > 8_000, "only {known} results are bounded");
}

/// A term far away from the other, in both orders.
#[test]
fn distant_terms_add_up() {
    for (high, low) in [(LIMIT, -LIMIT), (0, -LIMIT), (LIMIT, 0), (0, -1000)] {
        let [x, y] = [high, low].map(|e| Ball::new(3.into(), e, Radius::ZERO, 30));
        for sum in [x.clone() + &y, y.clone() + &x] {
            assert_eq!(sum.sign(), Some(Sign::Positive));
            assert!(sum.exponent() == x.exponent() && holds(&sum, high, &dyadic(3, 0)));
        }
        assert_eq!((y - &x).sign(), Some(Sign::Negative));
    }
}

#[test]
fn functions_of_huge_and_tiny_numbers_answer() {
    let precision = Precision::new(64);
    let at = |m: i32, e: i128| Ball::new(m.into(), e, Radius::ZERO, 64);
    for e in [LIMIT, LIMIT / 2, 4097] {
        assert!(at(1, e).exp(&precision).exact_bounds().is_none());
        assert!(at(-1, e).exp(&precision).contains(&BigRational::zero()));
        let (sin, cos) = at(1, e).sin_cos(&precision);
        assert!([sin, cos].iter().all(|x| x.contains(&BigRational::one())));
    }
    for e in [-LIMIT, -LIMIT / 2, -5000] {
        assert!(at(1, e).exp(&precision).contains(&BigRational::one()));
        let (sin, cos) = at(-3, e).sin_cos(&precision);
        assert!(holds(&sin, e, &dyadic(-3, 0)) && cos.contains(&BigRational::one()));
        assert!(sin.sign() == Some(Sign::Negative) || e == -LIMIT);
    }
    assert_eq!(Ball::zero(64).exp(&precision).exact_bounds(), Some((BigRational::one(), BigRational::one())));
}

/// Nothing is written out that would take more than some hundred thousand bits.
#[test]
fn bounds_are_written_out_only_where_they_are_short() {
    let at = |m: i32, e: i128, radius| Ball::new(m.into(), e, radius, 30);
    for e in [LIMIT - 100, 1 << 40, 1 << 18] {
        assert_eq!(at(3, e, Radius::ZERO).exact_bounds(), None);
        assert_eq!(at(3, 0, Radius::new(1, e)).exact_bounds(), None);
        for (m, r, zero, both) in
            [(3, 1, false, false), (-3, 1, false, false), (3, 9, true, true), (0, 1, true, true)]
        {
            let (low, high) = at(m, -e, Radius::new(r, -e)).exact_bounds().unwrap();
            assert!(low < high && high.abs() <= dyadic(1, -(1 << 16)) && low.abs() <= dyadic(1, -(1 << 16)));
            assert_eq!(low.is_negative() && high.is_positive(), both, "{m} ± {r}");
            assert!(zero || (if m > 0 { &low } else { &high }).is_zero());
        }
        let (low, high) = at(1, -e, Radius::one()).exact_bounds().unwrap();
        assert!(low < -BigRational::one() && high > BigRational::one() && high < dyadic(2, 0));
    }
    let (low, high) = at(5, -1000, Radius::new(1, -1002)).exact_bounds().unwrap();
    assert_eq!((low, high), (dyadic(19, -1002), dyadic(21, -1002)));
}

/// The midpoint less the radius is 2⁶¹ − ½, which no bound in units of 2⁰ may call 2⁶¹; and 1 − 2⁻⁵⁰⁰ is
/// not 1.
#[test]
fn least_magnitudes_round_the_radius_up() {
    let mid = (BigInt::one() << 61) + (BigInt::one() << 30);
    for (mid, unit, m, e) in [(mid, 0, (1u64 << 31) + 1, -1), (BigInt::one(), 0, 1 << 31, -531)] {
        let ball = Ball::new(mid.clone(), unit, Radius::new(m, e), 64);
        let (least, at) = ball.least_magnitude().unwrap();
        assert!(dyadic(least, at) <= dyadic(mid, unit) - dyadic(m, e));
    }
}

#[test]
fn wide_balls_multiply_rightly() {
    let integer = |x: i64| BigRational::from_integer(x.into());
    let precision = Precision::new(64);
    for (a, b) in [(-1, 3), (0, 2), (-5, 5), (2, 9), (-9, -2), (-1, 1)] {
        for (c, d) in [(-1, 3), (0, 2), (-5, 5), (2, 9), (-9, -2), (7, 7)] {
            let product = Ball::between(&integer(a), &integer(b), &precision)
                * &Ball::between(&integer(c), &integer(d), &precision);
            for end in [a * c, a * d, b * c, b * d] {
                assert!(product.contains(&integer(end)), "[{a}, {b}]·[{c}, {d}] lacks {end}");
            }
        }
    }
}

#[test]
#[should_panic(expected = "disjoint")]
fn disjoint_enclosures_are_noticed() {
    let _ = Ball::integer_at(1, 64).widened(Radius::new(1, -3)).tighter(Ball::integer_at(2, 64));
}

#[test]
#[should_panic(expected = "disjoint")]
fn disjoint_intervals_are_noticed() {
    let _ = super::FloatInterval::from_bounds(0.0, 1.0).tighter(super::FloatInterval::from_bounds(2.0, 3.0));
}
