//! How long the intervals of a period are together, and how many periods coexist at a random s: the formulas
//! against the intervals themselves, and against the cells of Farey sequences.

use grazing::existence::{
    Case, Coexistence, Coexisting, Interval, MAX_EXACT, coexisting, intervals, landau, landau_scaled,
    measure, measures,
};
use num_bigint::{BigInt, BigUint};
use num_integer::Integer;
use num_rational::{BigRational, Ratio};
use num_traits::{One, ToPrimitive, Zero};

fn q(x: &Ratio<u64>) -> BigRational {
    BigRational::new((*x.numer()).into(), (*x.denom()).into())
}

/// L_n = (1/n) Σ 1/k against the sum of the lengths of Theorem 2's intervals, for every n up to 2000: both as
/// multiples of 1/(n² lcm(1, …, n)).
#[test]
fn the_formula_is_the_sum_of_the_lengths() {
    let mut common = BigInt::from(2);
    for n in 3..=2000u64 {
        common = common.lcm(&BigInt::from(n));
        let whole: BigInt = &common * n * n * 2;
        let mut sum = BigInt::zero();
        for Interval { left, right, .. } in intervals(n).unwrap() {
            let top = right.numer() * left.denom() - left.numer() * right.denom();
            let (units, rest) = (&whole * top).div_rem(&BigInt::from(left.denom() * right.denom()));
            assert!(rest.is_zero(), "{n}: {left} {right}");
            sum += units;
        }
        let found = measure(n).unwrap();
        assert_eq!(found.numer() * &whole, sum * found.denom(), "{n}");
        assert!(found.numer().gcd(found.denom()).is_one(), "{n}: not in lowest terms");
    }
}

/// Large periods: against 1/k summed in floats, and in lowest terms modulo primes.
#[test]
fn fractions_of_large_periods_are_right() {
    for n in [9_973, 10_000, 30_030, 65_536, 99_999, 100_003] {
        let found = measure(n).unwrap();
        let sum: f64 = (1..n).filter(|k| k.gcd(&n) == 1).map(|k| 1.0 / k as f64).sum();
        let (top, bottom) = (found.numer() << 64u32, found.denom());
        let value = (top / bottom).to_f64().unwrap() / 2f64.powi(64);
        assert!((value * n as f64 / sum - 1.0).abs() < 1e-12, "{n}: {value} {sum}");
        for p in (2..=n).filter(|p| (2..).take_while(|d| d * d <= *p).all(|d| p % d > 0)) {
            let shared = (found.numer() % p).is_zero() && (found.denom() % p).is_zero();
            assert!(!shared, "{n}: {p} divides both");
        }
    }
    assert!(measure(2).is_err() && measure(MAX_EXACT + 1).is_err());
}

/// Enclosures hold the exact values and are narrow; the digits printed are those of the exact value, rounded.
#[test]
fn enclosures_hold_the_fractions() {
    let mut mean = BigRational::zero();
    measures(600, &(), |found| {
        let exact = measure(found.n).unwrap();
        mean += &exact * BigInt::from(2);
        for (bounds, exact) in [(found.length, &exact), (found.mean, &mean)] {
            let (lower, upper) = bounds.exact();
            assert!(lower <= *exact && *exact <= upper, "{}", found.n);
            assert!((upper - lower).to_f64().unwrap() < 1e-28, "{}", found.n);
            for decimals in [2, 15, 24] {
                let scale = num_traits::pow(BigInt::from(10), decimals);
                let half = BigRational::new(1.into(), 2.into());
                let rounded = (exact * &scale + half).floor().to_integer();
                let text = bounds.decimals(decimals as u32);
                assert_eq!(text.replace('.', "").parse::<BigInt>().unwrap(), rounded, "{}: {text}", found.n);
                let places = text.split_once('.').map_or(0, |(_, rest)| rest.len());
                assert_eq!(places, decimals, "{text}");
            }
        }
        Ok(())
    })
    .unwrap();
}

/// Every piece of (0, ½) between fractions of denominator up to 2N, and in it the periods whose intervals
/// have its middle.
#[test]
fn periods_coexist_as_the_intervals_say() {
    for order in [2, 3, 5, 12, 23] {
        let all: Vec<Vec<Interval>> = (1..=order).map(|n| intervals(n).unwrap().collect()).collect();
        let mut ends: Vec<Ratio<u64>> =
            (1..=2 * order).flat_map(|b| (0..=b / 2).map(move |a| Ratio::new(a, b))).collect();
        ends.sort();
        ends.dedup();
        for counted in [Coexisting::InSomeCase, Coexisting::Positive] {
            let mut classes = vec![BigRational::zero(); order as usize + 1];
            for pair in ends.windows(2) {
                let middle = (pair[0] + pair[1]) / 2;
                let has = |case: Case| counted == Coexisting::InSomeCase || case.sign_emu() > 0;
                let exists = |list: &&Vec<Interval>| {
                    list.iter().any(|one| one.left < middle && middle < one.right && has(one.case))
                };
                let periods = all.iter().filter(exists).count();
                classes[periods] += (q(&pair[1]) - q(&pair[0])) * BigInt::from(2);
            }
            let found = Coexistence::new(order, counted, &()).unwrap();
            for (count, (exact, (lower, upper))) in classes.iter().zip(found.bounds()).enumerate() {
                let bound = |x: u128| BigRational::new(x.into(), BigInt::one() << 100);
                assert!(bound(lower) <= *exact && *exact <= bound(upper), "{order} {counted:?}: {count}");
            }
        }
    }
    assert!(Coexistence::new(1, Coexisting::Positive, &()).is_err());
}

/// The mean number of periods by cells is that by lengths, with 1 and 2, which always exist.
#[test]
fn cells_and_lengths_have_one_mean() {
    for (order, digits) in [(100, "17.59"), (1000, "36.91")] {
        let mut mean = None;
        measures(order, &(), |found| {
            mean = Some(found.mean);
            Ok(())
        })
        .unwrap();
        assert_eq!(mean.unwrap().decimals(2), digits);
        let (lower, _) = mean.unwrap().exact();
        let cells = Coexistence::new(order, Coexisting::InSomeCase, &()).unwrap().probabilities();
        let total: f64 = cells.iter().sum();
        let by_cells: f64 = cells.iter().zip(0..).map(|(p, count)| p * f64::from(count)).sum();
        assert!((total - 1.0).abs() < 1e-12 && (by_cells - 2.0 - lower.to_f64().unwrap()).abs() < 1e-10);
    }
}

/// The numbers of periods at given s are those of the cells, and both come from the path itself.
#[test]
fn counts_at_a_point_are_those_of_its_cell() {
    for order in [2u64, 7, 20] {
        for counted in [Coexisting::InSomeCase, Coexisting::Positive] {
            for p in 1..499i64 {
                let s = BigRational::new(p.into(), 998.into()) + BigRational::new(1.into(), 1_000_003.into());
                let exists = |n: u64| {
                    intervals(n).unwrap().any(|one| {
                        let inside = q(&one.left) < s && s < q(&one.right);
                        inside && (counted == Coexisting::InSomeCase || one.case.sign_emu() > 0)
                    })
                };
                let expected = (1..=order).filter(|&n| exists(n)).count() as u64;
                assert_eq!(coexisting(&s, &order.into(), counted).unwrap(), expected.into(), "{s} {order}");
            }
        }
    }
    let s = BigRational::new(1.into(), 2.into());
    assert!(coexisting(&s, &5u32.into(), Coexisting::Positive).is_err());
}

/// The greatest distance from the Landau law of the number of periods up to `order` at a random s of r = 1,
/// by exact cells.
fn distance_by_cells(order: u64) -> f64 {
    let cells = Coexistence::new(order, Coexisting::Positive, &()).unwrap().probabilities();
    let (mut below, mut worst) = (0.0, 0.0f64);
    for (count, p) in cells.iter().enumerate() {
        below += p;
        worst = worst.max((below - landau(landau_scaled(count as f64 + 0.5, order as f64))).abs());
    }
    worst
}

/// What is conjectured with damping, in the table that `grazing figure coexistence` wrote: the distance from
/// the law falls with 1 − r, by about two bands at every step, and at 1 − r = 10⁻⁸ it is that of r = 1 with
/// N = (1 − r)^(−1/3) = 464, as far as 2000 samples tell.
#[test]
fn with_damping_the_distance_from_the_law_falls() {
    let table = include_str!("../../docs/coexistence.csv");
    let distance = |damping: &str| {
        let rows = table.lines().filter(|row| row.starts_with(&format!("{damping},")));
        let off = rows.map(|row| {
            let number = |i: usize| row.split(',').nth(i).unwrap().parse::<f64>().unwrap();
            ((number(3) + number(4)) / 2.0 - number(5)).abs()
        });
        off.fold(0.0, f64::max)
    };
    let found = ["1e-2", "1e-4", "1e-8", "1e-16"].map(distance);
    assert!(found.windows(2).all(|pair| pair[0] - pair[1] > 0.07) && found[3] < 0.28, "{found:?}");
    assert!((found[2] - distance_by_cells(464)).abs() < 0.07, "{found:?} {}", distance_by_cells(464));
}

/// The greatest distance from the Landau law of the counts of 2000 random s, at ln N = 30 and 100: 0.15 and
/// 0.08, told within 0.036 with a probability of 99 %. By cells it falls from N = 30 to 3000.
#[test]
fn the_distribution_approaches_the_landau_law() {
    let found = [30, 300, 3000].map(distance_by_cells);
    assert!(found[0] > found[1] && found[1] > found[2] && found[2] < 0.31, "{found:?}");
    // Random bits by a linear congruence on 64 bits, the upper half of each.
    let mut state = 1u64;
    let mut word = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        state >> 32
    };
    for (logarithm, expected) in [(30.0f64, 0.15), (100.0, 0.08)] {
        let order = BigUint::one() << (logarithm / 2f64.ln()) as u32;
        let mut counts: Vec<f64> = (0..2000)
            .map(|_| {
                let bits = (0..20).fold(BigInt::one(), |all, _| (all << 32u32) + word());
                let s = BigRational::new(bits % (BigInt::one() << 640u32), BigInt::one() << 641u32);
                coexisting(&s, &order, Coexisting::Positive).unwrap().to_f64().unwrap()
            })
            .collect();
        counts.sort_by(f64::total_cmp);
        let order = 2f64.powi((logarithm / 2f64.ln()) as i32);
        let distance = |(place, count): (usize, &f64)| {
            let law = landau(landau_scaled(*count, order));
            (law - place as f64 / 2000.0).abs().min((law - (place + 1) as f64 / 2000.0).abs())
        };
        let worst = counts.iter().enumerate().map(distance).fold(0.0, f64::max);
        assert!((worst - expected).abs() < 0.045, "{logarithm}: {worst}");
    }
}
