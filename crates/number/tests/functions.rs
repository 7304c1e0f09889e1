//! Functions of intervals and balls: identities, edges of domains, text, and, with `GRAZING_REQUIRE_ARB=1`
//! and a `$PYTHON` that has python-flint, 100,000 values against Arb.

#[path = "../../../tests/samples/mod.rs"]
mod samples;

use std::{
    io::Write,
    process::{Command, Stdio},
};

use grazing_number::{
    Ball, Elementary, FloatInterval, ParseError, Precision, Real, Sign, Transcendental, parse_rational,
};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

/// A function of one number, on any rung.
fn function<T: Transcendental>(name: &str, x: &T, context: &T::Context) -> T {
    match name {
        "sin" => x.sin_cos(context).0,
        "cos" => x.sin_cos(context).1,
        "sqrt" => x.sqrt(),
        "exp" => x.exp(context),
        "log" => x.log(context),
        "log1p" => x.log1p(context),
        "expm1" => x.expm1(context),
        "atan" => x.atan(context),
        "tan" => x.tan(context),
        "sinh" => x.sinh(context),
        _ => x.cosh(context),
    }
}

const NAMES: [&str; 11] =
    ["exp", "sin", "cos", "sqrt", "log", "log1p", "expm1", "atan", "tan", "sinh", "cosh"];

/// SplitMix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A finite float: of any exponent, of ordinary size, beside 0 or ±1 or a multiple of π/2, or an end of
    /// the range.
    fn float(&mut self) -> f64 {
        let (kind, bits) = (self.next() % 8, self.next());
        let unit = (bits >> 11) as f64 / (1u64 << 53) as f64;
        let sign = if bits & 1 == 0 { 1.0 } else { -1.0 };
        let near = |x: f64, bits: u64| (0..bits % 4).fold(x, |x, _| x.next_up());
        match kind {
            0 => Some(f64::from_bits(bits)).filter(|x| x.is_finite()).unwrap_or(f64::MAX),
            1 => sign * unit * 750.0,
            2 => sign * unit * 2f64.powi((bits % 60) as i32 - 50),
            3 => sign * (1.0 + unit * 2f64.powi(-((bits % 53) as i32))),
            4 => sign * near((self.next() % 2000) as f64 * std::f64::consts::FRAC_PI_2, bits >> 5),
            5 => sign * f64::from_bits((bits >> 12) % (1 << 20)),
            6 => {
                sign * near(
                    [0.0, 1.0, 709.782_712_893_384, 745.133_219_101_941, f64::MIN_POSITIVE]
                        [bits as usize % 5],
                    bits >> 5,
                )
            }
            _ => sign * unit,
        }
    }
}

fn floats(random: &mut Random, name: &str, lines: &mut String) {
    let domain = |x: f64| match name {
        "sqrt" | "log" | "pow" => x.abs(),
        "log1p" if x < -1.0 => x.abs(),
        _ => x,
    };
    let (x, mut y) = (domain(random.float()), domain(random.float()));
    match random.next() % 3 {
        0 => y = x,
        1 if random.next().is_multiple_of(2) => y = domain(x + (y % 4.0)),
        _ => {}
    }
    let interval = FloatInterval::from_bounds(x.min(y), x.max(y));
    let edge = if name == "log1p" { -1.0 } else { 0.0 };
    let outside = ["log", "log1p", "pow"].contains(&name) && interval.lo() <= edge;
    if outside || !(interval.hi() - interval.lo()).is_finite() {
        return;
    }
    let exponent = if name == "pow" { random.float() } else { 0.0 };
    let exponent = FloatInterval::from_bounds(exponent, exponent);
    let (result, other) = match name {
        "pow" => (interval.pow(&exponent, &()), vec![exponent]),
        _ => (function(name, &interval, &()), vec![]),
    };
    lines.push_str(&format!("i\t{name}"));
    for x in [interval].into_iter().chain(other).chain([result]) {
        lines.push_str(&format!("\t{:016x}\t{:016x}", x.lo().to_bits(), x.hi().to_bits()));
    }
    lines.push('\n');
}

fn balls(random: &mut Random, name: &str, precisions: &[Precision], lines: &mut String) {
    let context = &precisions[random.next() as usize % precisions.len()];
    let mut ball = |name: &str| {
        let mid = random.float();
        let mid = if ["sqrt", "log", "pow"].contains(&name) || mid < -1.0 && name == "log1p" {
            mid.abs()
        } else {
            mid
        };
        let mid = BigRational::from_float(mid).unwrap() + BigRational::new(1.into(), BigInt::one() << 90);
        let radius = BigRational::new((random.next() % 1000).into(), BigInt::one() << (random.next() % 200));
        let radius = if random.next().is_multiple_of(2) { BigRational::zero() } else { radius };
        Ball::between(&(&mid - &radius), &(mid + radius), context)
    };
    let x = ball(name);
    let (result, arguments) = if name == "pow" {
        let y = ball("").centre();
        (x.pow(&y, context), vec![x, y])
    } else {
        (function(name, &x, context), vec![x])
    };
    lines.push_str(&format!("b\t{name}\t{}", context.bits()));
    for x in arguments.iter().chain([&result]) {
        lines.push_str(&format!("\t{}", x.arb_text().unwrap_or("whole".to_string())));
    }
    lines.push('\n');
}

/// Values at points and over intervals and balls, at the ends of the range and of domains, near 0, ±1 and the
/// multiples of π/2.
#[test]
fn a_hundred_thousand_values_agree_with_arb() {
    if !samples::asked("GRAZING_REQUIRE_ARB", "100,000 values of functions against Arb") {
        return;
    }
    let precisions = [24, 53, 128, 400].map(Precision::new);
    let (mut random, mut lines) = (Random(66), String::new());
    for name in NAMES.into_iter().chain(["pow"]) {
        for _ in 0..samples::samples(7500) {
            floats(&mut random, name, &mut lines);
        }
        for _ in 0..samples::samples(2500) {
            balls(&mut random, name, &precisions, &mut lines);
        }
    }
    let cases = lines.lines().count();
    assert!(cases >= 100_000, "{cases}");
    let python = std::env::var("PYTHON").unwrap_or("python3".to_string());
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/arb.py");
    let mut arb =
        Command::new(python).arg(script).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    // A reader that fails closes the pipe; its own words say why.
    let _ = arb.stdin.take().unwrap().write_all(lines.as_bytes());
    let output = arb.wait_with_output().unwrap();
    let said = String::from_utf8(output.stdout).unwrap();
    println!("{said}");
    assert!(output.status.success() && said.starts_with(&format!("{cases} ")), "{said}");
}

/// Whether each end is what is expected, or, where that is not 0, ±1 or ±∞, a float beside it.
fn close(found: FloatInterval, expected: FloatInterval) -> bool {
    let end = |x: f64, y: f64| {
        let beside = ![0.0, 1.0, f64::INFINITY].contains(&y.abs());
        x == y || beside && (x.next_up() == y || x.next_down() == y)
    };
    end(found.lo(), expected.lo()) && end(found.hi(), expected.hi())
}

/// Intervals at the edges of domains and of the floats.
#[test]
fn intervals_that_touch_the_edge_of_a_domain_keep_it() {
    let of = |lo: f64, hi: f64| FloatInterval::from_bounds(lo, hi);
    let (inf, whole) = (f64::INFINITY, FloatInterval::WHOLE);
    let quarter = std::f64::consts::FRAC_PI_2;
    let cases = [
        ("log", of(0.0, 1.0), of(-inf, 0.0)),
        ("log", of(1.0, inf), of(0.0, inf)),
        ("log", of(-0.0, inf), whole),
        ("log", of(-5e-324, 1.0), whole),
        ("log", of(0.0, 0.0), whole),
        ("log1p", of(-1.0, 0.0), of(-inf, 0.0)),
        ("log1p", of((-1.0f64).next_down(), 0.0), whole),
        ("log1p", of(5e-324, 5e-324), of(0.0, 5e-324)),
        ("sqrt", of(0.0, 4.0), of(0.0, 2.0)),
        ("sqrt", of(0.0, inf), of(0.0, inf)),
        ("sqrt", of(-1.0, 4.0), whole),
        ("exp", of(-inf, 0.0), of(0.0, 1.0)),
        ("exp", of(0.0, inf), of(1.0, inf)),
        ("exp", of(1e300, inf), of(f64::MAX, inf)),
        ("exp", of(-inf, -1e300), of(0.0, 5e-324)),
        ("exp", whole, of(0.0, inf)),
        ("expm1", of(-inf, 0.0), of(-1.0, 0.0)),
        ("sinh", of(-inf, 0.0), of(-inf, 0.0)),
        ("sinh", whole, whole),
        ("cosh", whole, of(1.0, inf)),
        ("cosh", of(-1e300, 0.0), of(1.0, inf)),
        ("atan", whole, of(-quarter.next_up(), quarter.next_up())),
        ("atan", of(0.0, 0.0), of(0.0, 0.0)),
        ("tan", whole, whole),
        ("tan", of(1.0, 2.0), whole),
        ("tan", of(0.0, f64::MAX), whole),
        ("sin", whole, of(-1.0, 1.0)),
        ("cos", of(0.0, 0.0), of(1.0, 1.0)),
        ("sin", of(1.0, 2.0), of(1f64.sin().next_down(), 1.0)),
        ("cos", of(3.0, 4.0), of(-1.0, (-0.653_643_620_863_611_9f64).next_up())),
        ("sin", of(0.0, 5.0), of(-1.0, 1.0)),
    ];
    for (name, x, expected) in cases {
        let found = function(name, &x, &());
        assert!(close(found, expected), "{name} of {x:?} is {found:?}, not {expected:?}");
    }
    let powers = [
        (of(0.0, 1.0), of(2.0, 2.0), of(0.0, 1.0)),
        (of(0.0, 4.0), of(0.5, 0.5), of(0.0, 2.0)),
        (of(0.0, 2.0), of(-1.0, -1.0), of(0.5, inf)),
        (of(0.0, 1.0), of(0.0, 1.0), of(0.0, 1.0)),
        (of(1.0, inf), of(-inf, 0.0), of(0.0, 1.0)),
        (of(0.5, 1.0), whole, of(0.0, inf)),
        (of(0.0, 0.0), of(1.0, 2.0), of(0.0, 0.0)),
        (of(0.0, 0.0), of(0.0, 2.0), whole),
        (of(-1.0, 2.0), of(2.0, 2.0), whole),
        (of(2.0, 2.0), of(1e300, 1e300), of(f64::MAX, inf)),
        (of(2.0, 2.0), of(-1e300, -1e300), of(0.0, 5e-324)),
    ];
    for (x, y, expected) in powers {
        let found = x.pow(&y, &());
        assert!(close(found, expected), "{x:?}^{y:?} is {found:?}, not {expected:?}");
    }
    assert_eq!(FloatInterval::pi(&()), of(std::f64::consts::PI, std::f64::consts::PI.next_up()));
    assert_eq!(FloatInterval::e(&()), of(std::f64::consts::E, std::f64::consts::E.next_up()));
    let ln_2 = std::f64::consts::LN_2;
    assert_eq!(FloatInterval::ln_2(&()), of(ln_2, ln_2.next_up()));
}

#[test]
fn balls_at_the_edge_of_a_domain_keep_it() {
    let bits = Precision::new(64);
    let ball =
        |lo: &str, hi: &str| Ball::between(&parse_rational(lo).unwrap(), &parse_rational(hi).unwrap(), &bits);
    let bounds = |x: &Ball| x.exact_bounds().unwrap();
    for (lo, hi) in [("0", "1"), ("0", "1/3"), ("0", "1e-30"), ("0", "12345678901234567890")] {
        for context in [16, 20, 64, 200].map(Precision::new) {
            let (lo, hi) = (parse_rational(lo).unwrap(), parse_rational(hi).unwrap());
            let x = Ball::between(&lo, &hi, &context);
            assert!(!bounds(&x).0.is_negative() && x.contains(&lo) && x.contains(&hi), "{x:?}");
            let y = Ball::between(&-&hi, &lo, &context);
            assert!(!bounds(&y).1.is_positive() && y.contains(&-hi.clone()) && y.contains(&lo), "{y:?}");
            let root = x.sqrt();
            assert!(!bounds(&root).0.is_negative() && (root.clone() * &root).contains(&hi));
            assert!(x.pow(&ball("1/2", "1/2"), &context).contains(&BigRational::zero()));
        }
    }
    for (x, name) in [("0", "log"), ("-1", "log"), ("-1", "log1p"), ("-2", "log1p"), ("-1", "sqrt")] {
        assert!(function(name, &ball(x, x), &bits).exact_bounds().is_none(), "{name} {x}");
    }
    assert!(ball("1", "2").tan(&bits).exact_bounds().is_none());
    let whole = ball("1", "1") / &ball("-1", "1");
    for name in ["log", "log1p", "expm1", "tan", "sinh", "cosh", "exp"] {
        assert!(function(name, &whole, &bits).exact_bounds().is_none(), "{name} of everything");
    }
    let (low, high) = bounds(&whole.atan(&bits));
    assert!(low > parse_rational("-1.5708").unwrap() && high < parse_rational("1.5708").unwrap());
    // 2^200 ± 1, of which a ball of 64 bits knows nothing.
    let long = ball("2^200-1", "2^200+1").tan(&bits);
    assert!(long.exact_bounds().is_none());
    // A wide argument, to the true range.
    let (low, high) = bounds(&ball("-1.2", "1.3").tan(&bits));
    assert!(low > parse_rational("-2.573").unwrap() && high < parse_rational("3.603").unwrap());
    assert!(bounds(&ball("-3", "2").cosh(&bits)).0 > parse_rational("1-1e-8").unwrap());
}

/// ±2^60 and beyond: signs that exp always has, and nothing slow or wrong elsewhere.
#[test]
fn functions_of_huge_and_tiny_numbers_answer() {
    let bits = Precision::new(64);
    let mut power = Ball::ratio(&parse_rational("2^30").unwrap(), &bits);
    power = power.clone() * &power;
    let (up, down) = (power.exp(&bits), (-&power).exp(&bits));
    assert_eq!((up.sign(), down.sign()), (Some(Sign::Positive), Some(Sign::Positive)));
    assert!(
        (up.clone() * &down).contains(&BigRational::one()) && up.log(&bits).intersection(&power).is_some()
    );
    assert_eq!((up.sign(), (&down - &up).sign()), (Some(Sign::Positive), Some(Sign::Negative)));
    let far = Ball::ratio(&parse_rational("2^80").unwrap(), &bits);
    assert!(far.exp(&bits).exact_bounds().is_none() && (-&far).exp(&bits).sqrt().exact_bounds().is_some());
    // Half of it known: an upper end from e^5.
    let half =
        Ball::between(&parse_rational("-2^20").unwrap(), &parse_rational("5").unwrap(), &bits).exp(&bits);
    let (low, high) = half.exact_bounds().unwrap();
    assert!(
        low.is_zero() && high < parse_rational("148.5").unwrap() && high > parse_rational("148.4").unwrap()
    );
    let tiny = Ball::ratio(&parse_rational("2^-9000").unwrap(), &bits);
    let small = Ball::ratio(&parse_rational("2^-40").unwrap(), &bits);
    for name in ["log1p", "expm1", "atan", "tan", "sinh", "sin"] {
        for x in [&tiny, &small] {
            let value = function(name, x, &bits);
            let near = ((&value / x) - &Ball::integer(1, &bits)).exponent().is_none_or(|e| e < -35);
            assert!(value.certain_bits().unwrap() > 60 && near, "{name} of {x}");
        }
    }
    for x in [&far, &tiny, &up, &down] {
        for name in NAMES {
            let _ = (function(name, x, &bits), function(name, &-x, &bits));
        }
        assert!(x.log(&bits).certain_bits().unwrap() > 60);
    }
}

#[test]
fn text_of_others_is_read_or_refused() {
    let bits = Precision::new(64);
    let one = |text: &str| Ball::read(text, &bits).map(|x| x.to_string());
    for (text, shown) in [
        ("arb((0x5, -0x3))", "0.625"),
        ("arb((5, -3), (0, 0))", "0.625"),
        (" arb((-0x5, -0x3)) ", "-0.625"),
        ("arb(0.0, (0x20000001, -0x1d))", "[+/- 1e1]"),
        ("arb(0.0, '+inf')", "[+/- inf]"),
        ("[+/- inf]", "[+/- inf]"),
        ("[1, inf]", "[+/- inf]"),
        ("[5/2^3, 5/2^3]", "0.625"),
        ("[0.625 +/- 0]", "0.625"),
        ("3/8", "0.375"),
    ] {
        assert_eq!(one(text).unwrap(), shown, "{text}");
    }
    let refused = [
        "",
        "[",
        "[]",
        "[1",
        "[1 2]",
        "[2, 1]",
        "[1 +/- -1]",
        "[nan, 1]",
        "arb(",
        "arb()",
        "arb((1, 2), (3))",
        "arb((1, 2), (-1, 0))",
        "arb((1, 99999999999999999999))",
        "arb((+1, 2))",
        "arb((1.5, 2))",
        "inf",
    ];
    for text in refused {
        assert!(one(text).is_err() && text.parse::<FloatInterval>().is_err(), "{text}");
    }
    assert_eq!("[-inf, 3]".parse(), Ok(FloatInterval::from_bounds(f64::NEG_INFINITY, 3.0)));
    let third: Result<FloatInterval, ParseError> = "[1/3 +/- 1e-20]".parse();
    assert!(third.unwrap().contains(&parse_rational("1/3").unwrap()));
}

fn ball_of(p: i64, e: i32, spread: u64, down: u32, context: &Precision) -> Ball {
    let power = BigRational::from_integer(BigInt::one() << e.unsigned_abs());
    let mid = BigRational::from_integer(p.into());
    let mid = if e < 0 { mid / power } else { mid * power };
    let radius = BigRational::new(spread.into(), BigInt::one() << down);
    Ball::between(&(&mid - &radius), &(mid + radius), context)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(samples::samples(150)))]

    /// Each function undone by another, by the same rung's sin, cos, exp and √, which tests/elementary.rs
    /// holds against FLINT's digits.
    #[test]
    fn functions_undo_each_other(
        p in 1i64.., e in -70i32..-58, bits in prop_oneof![16u32..80, Just(200), Just(1500), Just(4000)],
    ) {
        let context = Precision::new(bits);
        let x = ball_of(p, e, 0, 0, &context);
        let is = |what: &str, found: Ball, exact: &Ball, lost: u64| {
            let difference = found.clone() - exact;
            assert!(difference.contains(&BigRational::zero()), "{what}: {found} is not {exact} at {bits} bits");
            assert!(found.certain_bits().is_none_or(|n| n + lost >= bits.into()), "{what}: {found:?} of {x:?}");
        };
        let one = Ball::integer(1, &context);
        let size = x.exponent().unwrap_or(0).unsigned_abs();
        is("exp log", x.log(&context).exp(&context), &x, 14);
        is("log exp", x.exp(&context).log(&context), &x, 6 + size);
        is("log1p expm1", x.expm1(&context).log1p(&context), &x, 16);
        is("expm1", x.expm1(&context) + &one, &x.exp(&context), 6);
        is("log1p", x.log1p(&context), &(&x + &one).log(&context), 6);
        let atan = x.atan(&context);
        is("tan atan", atan.tan(&context), &x, 20);
        let (sin, cos) = atan.sin_cos(&context);
        is("atan", sin / &cos, &x, 20);
        is("atan of 1/x", atan + &(&one / &x).atan(&context), &(Ball::pi(&context) / Ball::integer(2, &context)), 6);
        let (sinh, cosh) = (x.sinh(&context), x.cosh(&context));
        is("cosh - sinh", &cosh * &cosh - &(&sinh * &sinh), &one, 400);
        is("cosh + sinh", &cosh + &sinh, &x.exp(&context), 6);
        is("square", x.pow(&Ball::integer(2, &context), &context), &(&x * &x), 6);
        is("root", x.pow(&(&one / &Ball::integer(2, &context)), &context), &x.sqrt(), 6);
        is("odd", -&(-&x).sinh(&context), &sinh, 6);
    }

    /// The image of a ball holds the images of its ends and middle, and is hardly wider than the hull of
    /// those where the function rises.
    #[test]
    fn images_of_balls_are_right(
        p in -3000i64..3000, e in -14i32..3, spread in 0u64..1 << 20, down in 0u32..60,
        bits in prop_oneof![Just(20u32), Just(53), Just(128)],
    ) {
        let context = Precision::new(bits);
        let x = ball_of(p, e, spread, down, &context);
        let (low, high) = x.exact_bounds().unwrap();
        let fine = Precision::new(300);
        let points = [&low, &((&low + &high) / BigInt::from(2)), &high].map(|end| Ball::ratio(end, &fine));
        for name in NAMES {
            let image = function(name, &x, &context);
            let Some((lo, hi)) = image.exact_bounds() else { continue };
            let values: Vec<_> = points.iter().map(|x| function(name, x, &fine).exact_bounds()).collect();
            for value in values.iter().flatten() {
                prop_assert!(lo <= value.1 && value.0 <= hi, "{} of {} is not in the image {}", name, x, image);
            }
            if let [Some(first), _, Some(last)] = &values[..]
                && !["sin", "cos", "cosh", "sqrt"].contains(&name)
            {
                let rounding = (hi.abs() + lo.abs()) / BigRational::from_integer(BigInt::one() << (bits - 6));
                let width = (&last.1 - &first.0) * BigRational::new(101.into(), 100.into());
                prop_assert!(&hi - &lo <= width + rounding, "{} of {} is too wide: {:?}", name, x, image);
            }
        }
    }

    /// Sets, and text there and back.
    #[test]
    fn sets_and_text(
        p in any::<i64>(), e in -90i32..10, r in 0u64..1 << 32, down in 0u32..90, q in any::<i64>(), f in -90i32..10,
        bits in prop_oneof![Just(20u32), Just(64), Just(200)],
    ) {
        let context = Precision::new(bits);
        let (x, y) = (ball_of(p, e, r, down, &context), ball_of(q, f, 0, 0, &context));
        let ((a, b), (c, d)) = (x.exact_bounds().unwrap(), y.exact_bounds().unwrap());
        let holds = |ball: &Ball, ends: [&BigRational; 2]| ends.iter().all(|end| ball.contains(end));
        prop_assert!(holds(&x.hull(&y), [&a, &b]) && holds(&x.hull(&y), [&c, &d]));
        prop_assert!(holds(&x.max(&y), [(&a).max(&c), (&b).max(&d)]) && holds(&x.min(&y), [(&a).min(&c), (&b).min(&d)]));
        prop_assert!(holds(&x.abs(), [&a.abs(), &b.abs()]) && !x.abs().exact_bounds().unwrap().0.is_negative());
        match x.intersection(&y) {
            Some(common) => prop_assert!(a > d || b < c || holds(&common, [(&a).max(&c), (&b).min(&d)])),
            None => prop_assert!(b < c || d < a),
        }
        prop_assert!(x.intersection(&x).unwrap().contains(&a) && x.intersection(&x).unwrap().contains(&b));
        let again = Ball::read(&x.arb_text().unwrap(), &context).unwrap();
        prop_assert_eq!(again.exact_bounds(), x.exact_bounds());
        for text in [x.exact_text().unwrap(), x.to_string(), format!("{x:.3}")] {
            let again = Ball::read(&text, &context).unwrap();
            prop_assert!(holds(&again, [&a, &b]), "{} does not hold {:?}", text, x);
            let float: FloatInterval = text.parse().unwrap();
            prop_assert!(float.contains(&a) && float.contains(&b), "{} does not hold {:?}", text, x);
            prop_assert_eq!(float.exact_text().parse(), Ok(float));
        }
        // In every way of passing them.
        prop_assert_eq!((&x + &y).exact_bounds(), (x.clone() + y.clone()).exact_bounds());
        prop_assert_eq!((&x * y.clone()).exact_bounds(), (x.clone() * &y).exact_bounds());
    }
}
