//! Enclosures of b_{n,k} and c_n against exact fractions and against each other on a million points.

use grazing::local::{Answer, Ladder, Plane, Point, Polar, Quantity, Rung, sign_by, sign_on};
use grazing::number::{Ball, FloatInterval, Precision, Real, parse_rational};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero, pow};

/// SplitMix64.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) % bound
    }

    fn polar(&mut self, circle: bool) -> (Polar, u64, u64) {
        loop {
            let n = 2 + self.below(99);
            let k = 1 + self.below(n - 1);
            let q = 3 + self.below(1000);
            let near = BigRational::new(BigInt::from(self.below(3)) - 1, BigInt::one() << self.below(200));
            let s = BigRational::new((1 + self.below(q / 2)).into(), q.into()) + near;
            let r = match (circle, self.below(2)) {
                (true, _) => BigRational::one(),
                (false, 0) => BigRational::new((1 + self.below(998)).into(), 1000.into()),
                _ => BigRational::one() - BigRational::new(1.into(), BigInt::one() << (1 + self.below(120))),
            };
            if let Ok(polar) = Polar::new(r, s) {
                return (polar, n, k);
            }
        }
    }
}

/// A million points on r = 1 against integers, which share no code with the intervals.
#[test]
fn a_million_interval_signs_are_right() {
    let mut random = Random(1);
    let (mut decided, count) = (0, 10_000);
    for _ in 0..count {
        let (polar, n, k) = random.polar(true);
        let point = Point::Polar(polar.clone());
        for i in 0..100 {
            let quantity = if i == 0 { Quantity::C { n } } else { Quantity::B { n: n + i, k } };
            let exact = sign_by(&point, quantity, Rung::Exact);
            let answer = sign_on::<FloatInterval>(&point, quantity, &());
            assert!(
                answer == exact || answer == Answer::Undecided,
                "{polar:?} {quantity:?}: {answer:?}, {exact:?}"
            );
            decided += usize::from(answer != Answer::Undecided);
        }
    }
    assert!(decided > 99 * count, "only {decided} decided");
}

/// For r < 1 every rung encloses one number: all pairs of enclosures meet, and the ladder decides.
#[test]
fn rungs_agree_inside_the_circle() {
    let mut random = Random(2);
    let ladder = Ladder::default();
    let precisions = [64, 128, 512].map(Precision::new);
    for _ in 0..3000 {
        let (polar, n, k) = random.polar(false);
        let point = Point::Polar(polar.clone());
        for quantity in [Quantity::B { n, k }, Quantity::C { n }] {
            let decision = ladder.sign(&point, quantity);
            assert!(decision.answer != Answer::Undecided);
            let interval = sign_on::<FloatInterval>(&point, quantity, &());
            assert!(interval == decision.answer || interval == Answer::Undecided);
            let Some(interval) = point.evaluate::<FloatInterval>(quantity, &()) else { continue };
            let mut bounds: Vec<_> = interval.exact_bounds().into_iter().collect();
            bounds.extend(
                precisions.iter().filter_map(|p| point.evaluate::<Ball>(quantity, p)?.exact_bounds()),
            );
            for (l1, h1) in &bounds {
                assert!(bounds.iter().all(|(_, h2)| l1 <= h2), "{polar:?} {quantity:?} {h1}");
            }
        }
    }
}

/// All k at once and one k at a time are two routes; so are (r, s) and (a₁, a₂) where both are rational (s =
/// 1/3, 1/4, 1/6).
#[test]
fn routes_agree() {
    let precision = Precision::new(200);
    let number = |text: &str| parse_rational(text).unwrap();
    let meet = |a: &Ball, b: &Ball| {
        let ((l1, h1), (l2, h2)) = (a.exact_bounds().unwrap(), b.exact_bounds().unwrap());
        assert!(l1 <= h2 && l2 <= h1, "{a:?} {b:?}");
    };
    for r in ["1", "9/10", "1/3", "1 - 2^-70"] {
        for (s, cosine) in [("1/3", "-1/2"), ("1/4", "0"), ("1/6", "1/2")] {
            let r = number(r);
            let polar = Polar::new(r.clone(), number(s)).unwrap();
            let plane = Plane::new(&r * number(cosine) * BigInt::from(2), &r * &r).unwrap();
            for n in 2..40 {
                assert_eq!(polar.is_singular(n), plane.is_singular(n));
                let (Some(all), Some(other)) =
                    (polar.b_all::<Ball>(n, &precision), plane.b_all::<Ball>(n, &precision))
                else {
                    continue;
                };
                for k in 1..n {
                    let single: Ball = polar.b(n, k, &precision).unwrap();
                    meet(&all[k as usize - 1], &single);
                    meet(&other[k as usize - 1], &single);
                    meet(&plane.b(n, k, &precision).unwrap(), &single);
                }
                meet(&polar.c(n, &precision).unwrap(), &plane.c(n, &precision).unwrap());
            }
        }
    }
}

/// The stable forms from (a₁, a₂) against the recurrence and (59), (60) in fractions, in every region.
#[test]
fn plane_agrees_with_fractions() {
    let precision = Precision::new(200);
    let ladder = Ladder::default();
    for (a1, a2) in [
        ("3", "1/2"),
        ("7/5", "1/2"),
        ("6/5", "9/10"),
        ("-7/5", "1/2"),
        ("-3", "1/2"),
        ("2", "1"),
        ("-2", "1"),
        ("1", "1/4"),
        ("3/2", "1/2"),
        ("-3/2", "1/2"),
        ("-1/3", "2/3"),
    ] {
        let (a1, a2) = (parse_rational(a1).unwrap(), parse_rational(a2).unwrap());
        let plane = Plane::new(a1.clone(), a2.clone()).unwrap();
        let point = Point::Plane(plane.clone());
        let mut u = vec![BigRational::zero(), BigRational::one()];
        for k in 1..30 {
            u.push(&a1 * &u[k] - &a2 * &u[k - 1]);
        }
        for n in 2..25usize {
            assert_eq!(plane.is_singular(n as u64), u[n].is_zero());
            if u[n].is_zero() {
                continue;
            }
            let power = |k: usize| num_traits::pow(a2.clone(), k);
            let v = &u[n + 1] - &a2 * &u[n - 1];
            let c = -(BigRational::one() - v + power(n)) / &u[n];
            let mut all = vec![(Quantity::C { n: n as u64 }, c)];
            all.extend((1..n).map(|k| {
                (Quantity::B { n: n as u64, k: k as u64 }, (&u[n] - &u[k] - power(k) * &u[n - k]) / &u[n])
            }));
            for (quantity, exact) in all {
                assert!(
                    point.evaluate::<FloatInterval>(quantity, &()).unwrap().contains(&exact),
                    "{point:?} {quantity:?}"
                );
                assert!(
                    point.evaluate::<Ball>(quantity, &precision).unwrap().contains(&exact),
                    "{point:?} {quantity:?}"
                );
                assert_eq!(ladder.sign(&point, quantity).answer, Answer::Sign(Real::sign(&exact).unwrap()));
            }
        }
    }
}

/// Real eigenvalues: doubling and the recurrence in exact fractions are two routes, and one k needs O(log n)
/// steps.
#[test]
fn real_eigenvalues_add_up_exactly() {
    for (a1, a2) in [
        ("3", "1/2"),
        ("7/5", "1/4"),
        ("-7/5", "1/4"),
        ("-3", "1/2"),
        ("2", "1"),
        ("-2", "1"),
        ("1", "1/4"),
        ("-5/2", "1"),
    ] {
        let (a1, a2) = (parse_rational(a1).unwrap(), parse_rational(a2).unwrap());
        let plane = Plane::new(a1.clone(), a2.clone()).unwrap();
        let mut u = vec![BigRational::zero(), BigRational::one()];
        for k in 1..40 {
            u.push(&a1 * &u[k] - &a2 * &u[k - 1]);
        }
        for n in 1..36usize {
            let v = &u[n + 1] - &a2 * &u[n - 1];
            let c = -(BigRational::one() - v + pow(a2.clone(), n)) / &u[n];
            assert_eq!(plane.c::<BigRational>(n as u64, &()), Some(c), "c_{n} at ({a1}, {a2})");
            let all = plane.b_all::<BigRational>(n as u64, &()).unwrap();
            for k in 1..n {
                let b = (&u[n] - &u[k] - pow(a2.clone(), k) * &u[n - k]) / &u[n];
                assert_eq!(all[k - 1], b, "b_{n},{k} at ({a1}, {a2})");
                assert_eq!(plane.b::<BigRational>(n as u64, k as u64, &()), Some(b));
            }
        }
    }
}

/// Periods for which O(n) numbers would not fit any memory, against λ₁ = 1 − 2⁻⁴⁰ and λ₂ = ½ in closed form.
#[test]
fn real_eigenvalues_of_huge_periods_are_evaluated() {
    let number = |text: &str| parse_rational(text).unwrap();
    let (first, second) = (number("1-2^-40"), number("1/2"));
    let precision = Precision::new(256);
    let power = |x: &BigRational, k: u64| {
        let x = Ball::ratio(x, &precision);
        (0..64 - k.leading_zeros()).rev().fold(Ball::integer(1, &precision), |power, bit| {
            let square = power.clone() * &power;
            if k >> bit & 1 == 1 { square * &x } else { square }
        })
    };
    let plane = Plane::new(&first + &second, &first * &second).unwrap();
    let ladder = Ladder::default();
    for n in [10_000_000, 1_000_000_001, 1 << 42] {
        let u = |k: u64| power(&first, k) - &power(&second, k);
        for k in [1, 2, 1000, n / 2, n - 1] {
            let b = (u(n) - &u(k) - &(power(&(&first * &second), k) * &u(n - k))) / &u(n);
            let found = plane.b::<Ball>(n, k, &precision).unwrap();
            let difference = Real::sign(&(found.clone() - &b));
            assert!(matches!(difference, None | Some(grazing::number::Sign::Zero)), "n = {n}, k = {k}");
            assert!(found.certain_bits().unwrap() > 200, "n = {n}, k = {k}: {found:?}");
            let point = Point::Plane(plane.clone());
            let answer = ladder.sign(&point, Quantity::B { n, k }).answer;
            assert_eq!(Some(answer), Real::sign(&b).map(Answer::Sign));
        }
        let c = plane.c::<Ball>(n, &precision).unwrap();
        assert!(c.certain_bits().unwrap() > 200 && Real::sign(&c) == Some(grazing::number::Sign::Negative));
    }
}
