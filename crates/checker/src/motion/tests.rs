//! The checker's arithmetic against integers, known digits.

use super::{
    Interval,
    exponential::Ring,
    number::{Dual, Number},
    text::Decimal,
};

fn decimal(text: &str) -> Interval {
    let (whole, places) = text.split_once('.').unwrap();
    let digits = format!("{whole}{places}").parse().unwrap();
    Decimal { digits, places: places.len() as u32 }.enclosed()
}

/// Whether an interval contains a number, known to 30 digits, and tells 23 of them.
fn is(x: Interval, text: &str) -> bool {
    let error = decimal("0.00000000000000000000001");
    (x - decimal(text)).is_within(error, Interval::ZERO)
}

#[test]
fn products_and_quotients_round_outwards() {
    // Thirds and sevenths of either sign: x·y − xy contains 0, is a few units wide at most, and is never
    // empty.
    let unit = decimal("0.0000000000000000000000000001");
    for p in -9i128..=9 {
        for q in 1i128..=9 {
            for r in [-1_000_003i128, -7, -1, 1, 3, 123_456_789] {
                let x = Interval::ratio(p, q);
                let y = Interval::ratio(r, 7);
                let product = x * y - Interval::ratio(p * r, 7 * q);
                let scale = Interval::ratio(unit_scale(r), 1);
                assert!(product.is_within(unit * scale, Interval::ZERO), "{p}/{q} {r}/7");
                let quotient = x.over(y) - Interval::ratio(7 * p * r.signum(), q * r.abs());
                assert!(quotient.is_within(unit * scale, Interval::ZERO), "{p}/{q} {r}/7");
                assert!(!(x * y - x * y).is_positive() && !(x * y - x * y - unit).is_positive());
            }
        }
    }
    let third = Interval::ratio(1, 3);
    assert!(!(third * Interval::integer(3) - Interval::ONE).is_positive());
    assert!(!(Interval::ONE - third * Interval::integer(3)).is_positive());
    let straddling = third - third;
    let unknown = Interval::ONE.over(straddling);
    assert!(unknown.magnitude_bits().is_none());
    for x in [unknown + third, unknown * straddling, -unknown, unknown.over(third), third.over(unknown)] {
        assert!(x.magnitude_bits().is_none());
    }
    let huge = Interval::integer(1 << 29);
    assert!((huge * huge).magnitude_bits().is_none() && (huge + huge).magnitude_bits().is_none());
    assert!(huge.over(Interval::ratio(1, 4)).magnitude_bits().is_none());
}

/// A factor above the magnitude of what is multiplied.
fn unit_scale(r: i128) -> i128 {
    2 * r.abs() + 1000
}

#[test]
fn exponentials_have_known_digits() {
    // A² = A: exp(tA) = 1 + (e^t − 1) A.
    let growth = Ring { damping: -Interval::ONE, stiffness: Interval::ZERO };
    assert!(is(growth.exp(Interval::ONE).b, "1.718281828459045235360287471352662"));
    assert!(is(growth.exp(-Interval::integer(3)).b, "-0.950212931632136057020657584350"));
    let circle = Ring::CIRCLE.exp(Interval::integer(100));
    assert!(is(circle.a, "0.862318872287683934101938513951"));
    assert!(is(circle.b, "-0.506365641109758793656557610459"));
    // A² = 2: cosh √2 t + A sinh(√2 t)/√2, with √2 hidden in it.
    let hyperbolic = Ring { damping: Interval::ZERO, stiffness: -Interval::integer(2) };
    let e = hyperbolic.exp(Interval::ONE);
    assert!(
        (e.a.squared() - Interval::integer(2) * e.b.squared() - Interval::ONE)
            .is_within(decimal("0.00000000000000000000001"), Interval::ZERO)
    );
    assert!(is(e.a, "2.178183556608570863989222067820"));
}

/// The matrix's exponential by its damping, its stiffness and time, where closed forms are simple.
#[test]
fn exponentials_have_known_derivatives() {
    let along =
        |value: Interval, on: bool| Dual { value, slope: if on { Interval::ONE } else { Interval::ZERO } };
    let exp = |[c, k, t]: [Interval; 3], direction: usize| {
        let [c, k, t] = [(0, c), (1, k), (2, t)].map(|(i, x)| along(x, i == direction));
        Ring { damping: c, stiffness: k }.exp(t)
    };
    // Squaring nine times costs two times nine bits.
    let near =
        |x: Interval, y: Interval| (x - y).is_within(decimal("0.00000000000000000001"), Interval::ZERO);
    // k = 0: a = 1, b = (1 − e^−ct)/c, at c = −1 and t = 1: ∂b/∂c = −1 whatever e is, ∂b/∂t = e.
    let growth = [-Interval::ONE, Interval::ZERO, Interval::ONE];
    let by_c = exp(growth, 0);
    assert!(near(by_c.a.slope, Interval::ZERO) && near(by_c.b.slope, -Interval::ONE));
    let by_t = exp(growth, 2);
    assert!(near(by_t.a.slope, Interval::ZERO) && is(by_t.b.slope, "2.718281828459045235360287471352662"));
    assert!(near(by_t.b.slope - by_t.b.value, Interval::ONE));
    // c = 0: a = cos √k t, b = sin(√k t)/√k, at k = 1: ∂a/∂k = −t b/2, ∂b/∂k = (t a − b)/2; ∂a/∂t = −b, ∂b/∂t
    // = a. Far enough to be halved and squared nine times.
    let t = Interval::integer(100);
    let circle = [Interval::ZERO, Interval::ONE, t];
    let known = Ring::<Interval>::CIRCLE.exp(t);
    let by_k = exp(circle, 1);
    assert!(near(by_k.a.slope, -(t * known.b).shifted_down(1)));
    assert!(near(by_k.b.slope, (t * known.a - known.b).shifted_down(1)));
    let by_t = exp(circle, 2);
    assert!(near(by_t.a.slope, -known.b) && near(by_t.b.slope, known.a));
    for direction in 0..3 {
        let values = exp(circle, direction);
        assert!(near(values.a.value, known.a) && near(values.b.value, known.b));
    }
}

/// x²/(1 + x) and its derivative 1 − 1/(1 + x)², at a point and over an interval.
#[test]
fn duals_follow_the_rules_of_derivatives() {
    let along = |value| Dual { value, slope: Interval::ONE };
    let f = |x: Dual| x.squared().over(Dual::ONE + x) - -Dual::ZERO;
    let known = |x: Interval| Interval::ONE - Interval::ONE.over((Interval::ONE + x).squared());
    for p in [-7i128, -2, -1, 1, 5, 40] {
        let x = Interval::ratio(p, 9);
        let value = f(along(x));
        let error = decimal("0.00000000000000000000001");
        assert!((value.value - x.squared().over(Interval::ONE + x)).is_within(error, Interval::ZERO));
        assert!((value.slope - known(x)).is_within(error, Interval::ZERO));
        // Wider arguments enclose what points give.
        let wide = f(along(x.until(Interval::ratio(p + 1, 9))));
        let slope = known(x);
        assert!(!(wide.slope - slope).is_positive() && !(slope - wide.slope).is_positive());
    }
    let pole = f(along(Interval::ratio(-2, 1).until(Interval::ZERO)));
    assert!(pole.value.magnitude_bits().is_none() && pole.slope.magnitude_bits().is_none());
}

#[test]
fn pi_is_where_the_sine_changes_sign() {
    let pi = Interval::PI;
    let wide = decimal("0.0000000000000000000000001");
    assert!(Ring::CIRCLE.exp(pi - wide).b.is_positive());
    assert!((-Ring::CIRCLE.exp(pi + wide).b).is_positive());
    assert!(is(pi, "3.14159265358979323846264338327950"));
}

#[test]
fn an_interval_of_times_is_enclosed() {
    let ring = Ring { damping: decimal("0.3"), stiffness: decimal("2.0") };
    let wide = decimal("5.0").until(decimal("5.5"));
    let all = ring.exp(wide);
    for text in ["5.0", "5.1", "5.25", "5.4", "5.5"] {
        let one = ring.exp(decimal(text));
        for (part, whole) in [(one.a, all.a), (one.b, all.b)] {
            assert!(!(part - whole).is_positive() && !(whole - part).is_positive());
            assert!((whole - part).is_within(Interval::integer(2), Interval::ZERO));
        }
    }
}
