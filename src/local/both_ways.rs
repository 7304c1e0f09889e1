//! The two ways that balls have to b_{n,k}: the short one on limbs, and the forms that cancel least.

use num_rational::BigRational;
use num_traits::One;

use super::{Plane, Polar};
use crate::{
    number::{Ball, Circular, Precision, Real, Sign, parse_rational},
    random::Random,
};

/// The precisions of the tests: on the stack, at its end, and beyond.
const BITS: [u32; 3] = [128, 300, 1100];

/// Both enclose one number, and the short way loses no more bits.
fn agree(short: Ball, other: &Ball) -> bool {
    let certain = other.certain_bits().map(|bits| bits.saturating_sub(3));
    short.certain_bits() >= certain && matches!((short - other).sign(), None | Some(Sign::Zero))
}

/// In all regions, and on the lines between them.
#[test]
fn from_trace_and_determinant() {
    let mut random = Random(6);
    let mut short = [0; 3];
    for (i, bits) in BITS.into_iter().enumerate() {
        let precision = Precision::new(bits);
        for case in 0..150u64 {
            let n = if case % 5 == 4 { random.bits() >> (case % 50) } else { 2 + random.below(60) };
            let n = n.max(2);
            let k = 1 + random.below(n - 1);
            let root = BigRational::new((1 + random.below(1500)).into(), 1000.into());
            let a2 = &root * &root;
            let tiny = parse_rational(&format!("3^-{}", 4 + random.below(90))).unwrap();
            let a1 = match case % 5 {
                0 => BigRational::new(random.below(4000).into(), 1000.into()),
                1 => &root + &root,
                2 => &root + &root - tiny,
                3 => &a2 + tiny + BigRational::one(),
                _ => root + tiny,
            };
            let plane = Plane::new(if random.coin() { -a1 } else { a1 }, a2).unwrap();
            let Some((numerator, u)) = plane.numerator::<Ball>(n, k, &precision) else { continue };
            let known = numerator.sign().zip(u.sign()).map(|(a, b)| a * b);
            let sign = Ball::plane_sign(plane.doubling(), [n, k], &precision).flatten();
            assert!(sign.is_none_or(|sign| known.is_none_or(|other| other == sign)), "{n} {k} {plane:?}");
            assert_eq!(plane.b_sign::<Ball>(n, k, &precision).unwrap().or(known), known.or(sign));
            if let Some(quotient) = Ball::plane_quotient(plane.doubling(), [n, k], &precision) {
                short[i] += 1;
                assert!(agree(quotient, &(numerator / &u)), "{n} {k} {plane:?}");
            }
        }
    }
    assert!(short.iter().all(|&count| count > 50), "{short:?}");
}

/// As r → 0 and r → 1, beside zeros and poles.
#[test]
fn from_modulus_and_angle() {
    let mut random = Random(5);
    let mut short = [0; 3];
    for (i, bits) in BITS.into_iter().enumerate() {
        let precision = Precision::new(bits);
        for case in 0..120u64 {
            let n = if case % 5 == 4 { random.bits() >> (17 + case % 40) } else { 2 + random.below(60) };
            let (n, g) = (n.max(2), 2 + random.below(9));
            let k = 1 + random.below(n - 1);
            let r = match case % 4 {
                0 => format!("{}/1000", 1 + random.below(999)),
                1 => format!("2^-{}", 1 + random.below(40)),
                2 => format!("1-2^-{}", 1 + random.below(90)),
                _ => format!("{}/{}", random.bits() >> 2, u64::MAX),
            };
            let s = match case % 3 {
                0 => format!("{}/1000003", 1 + random.below(500_000)),
                1 => format!("{}/{}+2^-{}", random.below(g) + 1, 2 * g + 1, 4 + random.below(90)),
                _ => format!("{}/{n}+3^-{}", random.below(n / 2 + 1), 4 + random.below(90)),
            };
            let [r, s] = [&r, &s].map(|text| parse_rational(text).unwrap());
            let Ok(polar) = Polar::new(r, s) else { continue };
            if polar.is_singular(n) || polar.on_circle() {
                continue;
            }
            let (point, at) = ((polar.r(), polar.s()), [n, k]);
            let plain: Ball = polar.quotient(n, k, &precision);
            let sign = Ball::polar_sign(point, at, &precision).flatten();
            let known = plain.sign().map(|b| b * polar.u_sign(n));
            assert!(sign.is_none_or(|sign| known.is_none_or(|other| other == sign)), "{n} {k} {polar:?}");
            if let Some(quotient) = Ball::polar_quotient(point, at, &precision) {
                short[i] += 1;
                assert!(agree(quotient, &plain), "{n} {k} {polar:?}");
            }
        }
    }
    assert!(short.iter().all(|&count| count > 50), "{short:?}");
}

/// Where forty duplications leave nothing of the short way, the other one tells the sign.
#[test]
fn at_a_very_large_period_on_the_circle() {
    let plane = Plane::new(parse_rational("1/2").unwrap(), BigRational::one()).unwrap();
    let (n, k, precision) = (541_706_634_515, 254_711_000_323, Precision::new(512));
    let known =
        plane.numerator::<Ball>(n, k, &precision).map(|(numerator, u)| numerator.sign().zip(u.sign()));
    let known = known.flatten().map(|(a, b)| a * b);
    assert!(known.is_some() && plane.b_sign::<Ball>(n, k, &precision).unwrap() == known);
}
