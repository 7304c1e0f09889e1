//! Enclosures against exact fractions, and sines against FLINT (tests/data/sines.csv).

#[path = "../../../tests/samples/mod.rs"]
mod samples;

use grazing_number::{Angle, Ball, Circular, FloatInterval, Precision, Real, parse_rational};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

type Bounds = Option<(BigRational, BigRational)>;

fn fraction(p: i64, q: u64, exponent: i32) -> BigRational {
    let power = BigRational::from_integer(BigInt::one() << exponent.unsigned_abs());
    let x = BigRational::new(p.into(), q.into());
    if exponent < 0 { x / power } else { x * power }
}

/// The unit in the last place of x ≠ 0 at a precision of `bits`: the width of the correctly rounded
/// enclosure.
fn unit(x: &BigRational, bits: i64) -> BigRational {
    let estimate = x.numer().bits() as i64 - x.denom().bits() as i64;
    let power = |e: i64| fraction(1, 1, e as i32);
    let exponent = if x.abs() < power(estimate) { estimate - 1 } else { estimate };
    power(exponent + 1 - bits)
}

/// Whether x is a number of `bits` bits, so that its correctly rounded enclosure is a point.
fn representable(x: &BigRational, bits: u64) -> bool {
    let (p, q) = (x.numer().magnitude(), x.denom().magnitude());
    q.count_ones() == 1 && p.bits() - p.trailing_zeros().unwrap_or(0) <= bits
}

fn check_width(bounds: &Bounds, exact: &BigRational, bits: u64, what: &str) {
    let (lo, hi) = bounds.as_ref().unwrap();
    assert!(lo <= exact && exact <= hi, "{what}: {exact} is outside");
    if exact.is_zero() || representable(exact, bits) {
        assert_eq!(lo, hi, "{what}: {exact} is representable");
    } else {
        assert!(hi - lo <= unit(exact, bits as i64) * BigInt::from(8), "{what}: too wide at {exact}");
    }
}

fn operations<T: Real>(
    x: &BigRational,
    y: &BigRational,
    context: &T::Context,
    bounds: impl Fn(&T) -> Bounds,
    bits: u64,
) {
    let (a, b) = (T::ratio(x, context), T::ratio(y, context));
    check_width(&bounds(&a), x, bits, "ratio");
    // From point arguments: x and y cut to `bits` bits.
    let cut = |x: &BigRational| {
        if x.is_zero() { x.clone() } else { (x / unit(x, bits as i64)).floor() * unit(x, bits as i64) }
    };
    let (x0, y0) = (cut(x), cut(y));
    let (a0, b0) = (T::ratio(&x0, context), T::ratio(&y0, context));
    check_width(&bounds(&(a0.clone() + &b0)), &(&x0 + &y0), bits, "sum");
    check_width(&bounds(&(a0.clone() - &b0)), &(&x0 - &y0), bits, "difference");
    check_width(&bounds(&(a0.clone() * &b0)), &(&x0 * &y0), bits, "product");
    if !y0.is_zero() {
        check_width(&bounds(&(a0 / &b0)), &(&x0 / &y0), bits, "quotient");
    }
    // From proper enclosures, containment.
    let inside = |t: T, exact: BigRational| bounds(&t).is_none_or(|(lo, hi)| lo <= exact && exact <= hi);
    assert!(inside(a.clone() + &b, x + y) && inside(a.clone() - &b, x - y) && inside(a.clone() * &b, x * y));
    assert!(y.is_zero() || inside(a.clone() / &b, x / y));
    // And from wide ones: x + (y − y) with an enclosure of y that is no point.
    let wide = b.clone() - &b + &(b.clone() / &T::integer(3, context)) - &(b / &T::integer(3, context));
    assert!(inside(a.clone() * &(wide.clone() + &a), x * x) && inside(wide, BigRational::zero()));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(samples::samples(900)))]

    #[test]
    fn field_operations_enclose_tightly(
        p in any::<i64>(), q in 1u64.., e in -80i32..80,
        u in prop_oneof![any::<i64>(), -4i64..4], v in prop_oneof![1u64.., 1u64..5], f in prop_oneof![-80i32..80, -3i32..3],
    ) {
        let (x, y) = (fraction(p, q, e), fraction(u, v, f));
        operations::<FloatInterval>(&x, &y, &(), FloatInterval::exact_bounds, 53);
        for bits in [24, 128, 300] {
            operations::<Ball>(&x, &y, &Precision::new(bits), Ball::exact_bounds, bits.into());
        }
    }

    /// Exponents to both ends of the floats' range and beyond: enclosed always, and tightly inside it.
    #[test]
    fn extreme_ratios_are_enclosed_tightly(
        p in any::<i64>(), q in 1u64.., e in -1100i32..1100,
        u in any::<i64>(), v in prop_oneof![1u64.., 1u64..5], f in prop_oneof![-1100i32..1100, -30i32..30],
    ) {
        let (x, y) = (fraction(p, q, e), fraction(u, v, f));
        let (a, b) = (FloatInterval::ratio(&x, &()), FloatInterval::ratio(&y, &()));
        let power = |e: i32| fraction(1, 1, e);
        // Below 2⁻¹⁰²² two neighbouring floats are left, above 2¹⁰²⁴ no width is promised.
        for (found, exact) in [(a, &x), (b, &y)] {
            prop_assert!(found.contains(exact), "{exact} is outside {found:?}");
            if exact.abs() >= power(-1022) && exact.abs() < power(1024) - power(971) {
                let (lo, hi) = found.exact_bounds().unwrap();
                prop_assert!(hi - lo <= unit(exact, 53) * BigInt::from(8), "too wide at {exact}: {found:?}");
            }
        }
        let all = |sum: bool, difference: bool, product: bool| sum && difference && product;
        prop_assert!(all(
            (a + &b).contains(&(&x + &y)),
            (a - &b).contains(&(&x - &y)),
            (a * &b).contains(&(&x * &y)),
        ));
        prop_assert!(y.is_zero() || (a / &b).contains(&(&x / &y)));
        for bits in [24, 128] {
            let precision = Precision::new(bits);
            let [a, b] = [&x, &y].map(|x| Ball::ratio(x, &precision));
            check_width(&a.exact_bounds(), &x, bits.into(), "ratio");
            prop_assert!(all(
                (a.clone() + &b).contains(&(&x + &y)),
                (a.clone() - &b).contains(&(&x - &y)),
                (a.clone() * &b).contains(&(&x * &y)),
            ));
            prop_assert!(y.is_zero() || (a / &b).contains(&(&x / &y)));
        }
    }

    #[test]
    fn extreme_floats_are_still_enclosed(x in any::<f64>(), y in any::<f64>()) {
        prop_assume!(x.is_finite() && y.is_finite());
        let (a, b) = (FloatInterval::from_bounds(x, x), FloatInterval::from_bounds(y, y));
        let (x, y) = (BigRational::from_float(x).unwrap(), BigRational::from_float(y).unwrap());
        prop_assert!((a + &b).contains(&(&x + &y)) && (a - &b).contains(&(&x - &y)) && (a * &b).contains(&(&x * &y)));
        if !y.is_zero() {
            prop_assert!((a / &b).contains(&(&x / &y)), "{:?} / {:?}", a, b);
        }
    }
}

/// The last binade below 2¹⁰²⁴ is as tight as any other (at the power of 2 below it the steps change); beyond
/// the floats only the near end is finite.
#[test]
fn the_largest_floats_enclose_as_tightly_as_others() {
    for text in ["1e308", "2^1023", "2^1023+1", "2^1024-2^971", "2^1024-2^972+1", "1.7e308"] {
        let x = parse_rational(text).unwrap();
        let found = FloatInterval::ratio(&x, &());
        assert!(found.contains(&x) && FloatInterval::ratio(&-&x, &()).contains(&-&x), "{text}: {found:?}");
        assert!(
            found.lo() >= 2f64.powi(1023) / 1.2 && found.hi() <= found.lo().next_up().next_up(),
            "{text}: {found:?}"
        );
    }
    let beyond = FloatInterval::ratio(&parse_rational("2^1024").unwrap(), &());
    assert_eq!((beyond.lo(), beyond.hi()), (f64::MAX, f64::INFINITY));
    // Below the normal floats there are fewer, and they enclose as tightly.
    for text in ["1e-310", "3e-320", "5e-324", "1e-330"] {
        let x = parse_rational(text).unwrap();
        let below = FloatInterval::ratio(&x, &());
        assert!(below.contains(&x) && below.hi() == below.lo().next_up(), "{text}: {below:?}");
    }
    let least = FloatInterval::ratio(&parse_rational("2^-1074").unwrap(), &());
    assert_eq!((least.lo(), least.hi()), (5e-324, 5e-324));
}

#[test]
fn intervals_that_straddle_zero_multiply_rightly() {
    let ends = [-3.0, -1.0, 0.0, 2.0, 5.0];
    let intervals: Vec<(f64, f64)> = ends
        .iter()
        .flat_map(|&lo| ends.iter().filter(move |&&hi| lo <= hi).map(move |&hi| (lo, hi)))
        .collect();
    for &(a, b) in &intervals {
        for &(c, d) in &intervals {
            let product = FloatInterval::from_bounds(a, b) * &FloatInterval::from_bounds(c, d);
            let all = [a * c, a * d, b * c, b * d];
            let expected = (
                all.iter().copied().fold(f64::INFINITY, f64::min),
                all.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            );
            assert_eq!((product.lo(), product.hi()), expected, "[{a}, {b}]·[{c}, {d}]");
            let quotient = FloatInterval::from_bounds(a, b) / &FloatInterval::from_bounds(c, d);
            if c <= 0.0 && d >= 0.0 {
                assert_eq!(quotient, FloatInterval::WHOLE);
            } else {
                for x in [a / c, a / d, b / c, b / d] {
                    assert!(quotient.lo() <= x && x <= quotient.hi());
                }
            }
        }
    }
}

#[test]
fn sines_agree_with_flint() {
    let text = include_str!("data/sines.csv");
    assert!(text.lines().count() > 400);
    let precisions = [24, 53, 128, 256, 1024, 4096, 16384].map(Precision::new);
    for (index, line) in text.lines().enumerate() {
        let (x, value) = line.split_once(',').unwrap();
        let (x, value) = (parse_rational(x).unwrap(), parse_rational(value).unwrap());
        let digits: u32 = if index < 6 { 1299 } else { 59 };
        let slack = value.abs() / BigInt::from(10).pow(digits - 1);
        let angle = Angle::new(&x);
        let complement = Angle::new(&(BigRational::new(1.into(), 2.into()) - &x));
        let check = |bounds: Bounds, bits: u64| {
            let (lo, hi) = bounds.unwrap();
            assert!(lo <= &value + &slack && &value - &slack <= hi, "sin {x}π at {bits} bits");
            let limit = if value.is_zero() {
                BigRational::zero()
            } else {
                unit(&value, bits as i64) * BigInt::from(8)
            };
            assert!(hi - lo <= limit, "sin {x}π at {bits} bits is too wide");
        };
        check(FloatInterval::sin(&angle, &()).exact_bounds(), 53);
        check(FloatInterval::cos(&complement, &()).exact_bounds(), 53);
        for precision in precisions.iter().take(if index < 40 { 7 } else { 5 }) {
            check(Ball::sin(&angle, precision).exact_bounds(), precision.bits().into());
            check(Ball::cos(&complement, precision).exact_bounds(), precision.bits().into());
        }
    }
}

/// The recurrence in k and single sines are two routes to the same numbers.
#[test]
fn recurrences_meet_single_sines() {
    let meet = |a: &Ball, b: &Ball| {
        let ((l1, h1), (l2, h2)) = (a.exact_bounds().unwrap(), b.exact_bounds().unwrap());
        l1 <= h2 && l2 <= h1
    };
    for (s, n) in [("12345/67891", 300), ("1/3 + 2^-90", 60), ("1e-20", 40), ("17/12", 50), ("-2/7", 30)] {
        let angle = Angle::new(&parse_rational(s).unwrap());
        for bits in [53, 128, 1000] {
            let precision = Precision::new(bits);
            let (sines, cosines) = (Ball::sines(&angle, n, &precision), Ball::cosines(&angle, n, &precision));
            for k in 0..=n {
                let (sine, cosine) =
                    (Ball::sin(&angle.times(k), &precision), Ball::cos(&angle.times(k), &precision));
                assert!(
                    meet(&sines[k as usize], &sine) && meet(&cosines[k as usize], &cosine),
                    "{k}·{s}π at {bits} bits"
                );
                let certain = |ball: &Ball| ball.certain_bits().unwrap_or(u64::MAX);
                assert!(
                    certain(&sines[k as usize]).saturating_add(4) >= bits.into()
                        && certain(&cosines[k as usize]).saturating_add(4) >= bits.into()
                );
            }
        }
    }
}
