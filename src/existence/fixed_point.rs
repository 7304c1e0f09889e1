//! Numbers with a fixed point, for the claim's side alone: one `i128` counts units of 2⁻¹¹².
//!
//! A product is cut towards zero, by less than a unit. What is left out is bounded beforehand, in units, so
//! that a sign costs a few products of machine integers. Neither the intervals and balls that the ladder
//! takes its signs from nor their sines are used.

use num_rational::BigRational;
use num_traits::{One, ToPrimitive};

use crate::{
    local::{Plane, Polar, Region},
    number::Sign,
};

/// Bits after the point.
const POINT: u32 = 112;

/// The longest period: u_n stays below 2¹⁴, and the bounds below far less than 1.
const LONGEST: u64 = 4096;

/// ⌊π 2¹¹²⌋.
const PI: i128 = 0x3_243f_6a88_85a3_08d3_1319_8a2e_0370;

const ONE: i128 = 1 << POINT;

/// x, |x| < 2¹⁴, cut towards zero by less than a unit.
fn ratio(x: &BigRational) -> i128 {
    ((x.numer() << POINT) / x.denom()).to_i128().expect("below 2¹⁴ by the caller's conditions")
}

/// ab, |ab| < 2¹⁵, cut towards zero by less than a unit.
fn product(a: i128, b: i128) -> i128 {
    let halves = |x: u128| (x >> 64, x & u128::from(u64::MAX));
    let ((a1, a0), (b1, b0)) = (halves(a.unsigned_abs()), halves(b.unsigned_abs()));
    let (low, first, second) = (a0 * b0, a1 * b0, a0 * b1);
    // a₁ and b₁ are below 2⁶³, so that the sum of three numbers below 2¹²⁷ does not wrap.
    let middle = (low >> 64) + first + (second & u128::from(u64::MAX));
    let high = a1 * b1 + (middle >> 64) + (second >> 64);
    let magnitude = (high << (128 - POINT)) | ((middle & u128::from(u64::MAX)) >> (POINT - 64));
    if (a < 0) == (b < 0) { magnitude as i128 } else { -(magnitude as i128) }
}

/// The sign of a number that is `value` to within `bound` units, if that tells it.
fn sign(value: i128, bound: u64) -> Option<Sign> {
    let certain = value.unsigned_abs() > u128::from(bound);
    certain.then(|| Sign::Positive.negated_if(value < 0))
}

/// a₁ and a₂ where u_1, …, u_n can be followed: both eigenvalues within the unit circle.
fn coefficients(plane: &Plane, n: u64) -> Option<[i128; 2]> {
    let inside = matches!(plane.region(), Region::Two | Region::Three | Region::Four);
    let within = inside && plane.a2() <= &BigRational::one() && n <= LONGEST;
    within.then(|| [ratio(plane.a1()), ratio(plane.a2())])
}

/// u_1, u_2, …, each u_m to within m³ units, m ≤ 4096.
///
/// Both eigenvalues are within the unit circle, so |u_m| ≤ m and |a₁| ≤ 2. A step from u_{i−1} and u_i is off
/// by |u_i| + |u_{i−1}| units for a₁ and a₂, each off by one, and by 2 for the cuts: by 2i + 3 if the numbers
/// themselves are off by less than 1. Such an error at step i counts u_{m−i}-fold in u_m. The sum over i < m
/// of (m − i)(2i + 3) is (m³ − m)/3 + 3(m² − m)/2 ≤ m³.
fn terms([a1, a2]: [i128; 2]) -> impl Iterator<Item = i128> {
    let step = move |&(before, u): &(i128, i128)| Some((u, product(a1, u) - product(a2, before)));
    std::iter::successors(Some((0, ONE)), step).map(|(_, u)| u)
}

fn cube(n: u64) -> u64 {
    n * n * n
}

/// How many sign changes u_1, …, u_n have, in region 3; `None` unless the sign of each is certain.
pub(super) fn sign_changes(plane: &Plane, n: u64) -> Option<u64> {
    let (mut last, mut changes) = (Sign::Positive, 0);
    for (i, u) in (1..=n).zip(terms(coefficients(plane, n)?)) {
        let here = sign(u, cube(i))?;
        changes += u64::from(here != last);
        last = here;
    }
    Some(changes)
}

/// The sign of b_{n,k}, 1 ≤ k < n, by (59) from u_n, u_k and u_{n−k}, if it is certain.
///
/// a₂^k is off by 2 units for each factor. So N = u_n − u_k − a₂^k u_j is off by n³ + k³ + j³ + 2k(j + 1) + 1
/// ≤ 3n³ units, j = n − k.
pub(crate) fn plane_sign(plane: &Plane, n: u64, k: u64) -> Option<Sign> {
    let [a1, a2] = coefficients(plane, n)?;
    let (mut at_k, mut at_j, mut un) = (0, 0, 0);
    for (i, u) in (1..=n).zip(terms([a1, a2])) {
        if i == k {
            at_k = u;
        }
        if i == n - k {
            at_j = u;
        }
        un = u;
    }
    let power = (0..k).fold(ONE, |power, _| product(power, a2));
    let numerator = un - at_k - product(power, at_j);
    Some(sign(un, cube(n))? * sign(numerator, 3 * cube(n))?)
}

/// A complex number.
type Complex = [i128; 2];

fn times([a, b]: Complex, [c, d]: Complex) -> Complex {
    [product(a, c) - product(b, d), product(a, d) + product(b, c)]
}

/// e^{2πis} for 0 < s < ½, to within 700 units.
///
/// x = πs/8 < 0.2 is off by 2 units at most. In the power series of e^{ix} the term i is off by e_i ≤
/// (e_{i−1} x + 2 x^{i−1} + 1)/i + 1: by 4 for i = 1, and by less than 2.2 after that. So both sums up to i =
/// 24 are within 28 units, and their tail is far below one: the pair is within 40. Each of the four squarings
/// doubles that and adds 3.
fn turn(s: &BigRational) -> Complex {
    let x = product(PI, ratio(s)) / 8;
    let (mut sums, mut term) = ([0i128; 2], ONE);
    for i in 0..=24i128 {
        if i > 0 {
            term = product(term, x) / i;
        }
        let sum = &mut sums[(i % 2) as usize];
        *sum += if i % 4 < 2 { term } else { -term };
    }
    (0..4).fold(sums, |z, _| times(z, z))
}

/// λ^m for m ≥ 1 from λ^{2^i}, to within 720m units if λ itself is within 716.
///
/// By induction within 720m − 4: in a product of two powers, of modulus 1 at most, the errors add up, and the
/// cuts and the product of the errors add less than 4.
fn power(squares: &[Complex], m: u64) -> Complex {
    let factors = (0..).zip(squares).filter(|(bit, _)| m >> bit & 1 == 1).map(|(_, square)| *square);
    factors.reduce(times).expect("m is at least 1")
}

/// The sign of b_{n,k}, 1 ≤ k < n, by (59) from the powers of λ = r e^{2πis}, if it is certain.
///
/// λ is within 704 units, Im λ^m within 720m, r^{2k} = |λ^k|² within 1440k + 3. So the numerator is off by
/// 720n + 720k + 1440k + 720(n − k) + 4 < 3000n units.
pub(crate) fn polar_sign(polar: &Polar, n: u64, k: u64) -> Option<Sign> {
    if n > LONGEST {
        return None;
    }
    let r = ratio(polar.r());
    let lambda = turn(polar.s()).map(|part| product(r, part));
    let bits = 64 - n.leading_zeros();
    let squares: Vec<_> =
        std::iter::successors(Some(lambda), |&z| Some(times(z, z))).take(bits as usize).collect();
    let (at_k, at_j) = (power(&squares, k), power(&squares, n - k));
    let un = times(at_k, at_j)[1];
    let weight = product(at_k[0], at_k[0]) + product(at_k[1], at_k[1]);
    let numerator = un - at_k[1] - product(weight, at_j[1]);
    Some(sign(un, 720 * n)? * sign(numerator, 3000 * n)?)
}

#[cfg(test)]
mod tests {
    use num_bigint::BigInt;

    use super::*;
    use crate::{
        number::{Ball, Elementary, Precision, Real},
        random::Random,
    };

    fn exact(x: i128) -> BigRational {
        BigRational::new(x.into(), BigInt::one() << POINT)
    }

    fn off_by(value: i128, ball: &Ball) -> BigRational {
        let (low, high) = ball.exact_bounds().unwrap();
        let units =
            |end: BigRational| (end - exact(value)) * BigRational::from_integer(BigInt::one() << POINT);
        let [low, high] = [low, high].map(|end| num_traits::Signed::abs(&units(end)));
        low.max(high)
    }

    fn integer(x: u64) -> BigRational {
        BigRational::from_integer(x.into())
    }

    /// Products against integers, at the ends of the range too.
    #[test]
    fn products_are_cut_by_less_than_a_unit() {
        let mut random = Random::of_unit(1, 0);
        let mut factors = vec![0, 1, -1, ONE, -ONE, ONE - 1, (ONE << 14) - 1, 1 - (ONE << 14), 1 << 64, PI];
        factors.extend((0..200).map(|_| {
            let wide = i128::from(random.bits()) << 63 | i128::from(random.bits() >> 1);
            (wide >> random.below(120)) * if random.coin() { 1 } else { -1 }
        }));
        for (&a, &b) in factors.iter().flat_map(|a| factors.iter().map(move |b| (a, b))) {
            let true_value: BigInt = BigInt::from(a) * b / (BigInt::one() << POINT);
            if true_value.bits() < u64::from(POINT) + 15 {
                assert_eq!(BigInt::from(product(a, b)), true_value, "{a} {b}");
            }
        }
    }

    /// u_m, e^{2πis} and powers against balls.
    #[test]
    fn what_is_left_out_is_within_its_bounds() {
        let (precision, mut random) = (Precision::new(400), Random::of_unit(2, 0));
        let ball = |x: &BigRational| Ball::ratio(x, &precision);
        assert!(off_by(PI, &Ball::pi(&precision)) < integer(1));
        let fraction =
            |random: &mut Random| BigRational::new((random.bits() >> 11 | 1).into(), (1u64 << 53).into());
        for _ in 0..40 {
            let (r, s) = (fraction(&mut random), fraction(&mut random) / BigInt::from(2));
            let angle = Ball::pi(&precision) * &ball(&(&s + &s));
            let (sin, cos) = angle.sin_cos(&precision);
            let found = turn(&s);
            for (part, ball) in found.iter().zip([&cos, &sin]) {
                assert!(off_by(*part, ball) < integer(700), "s = {s}");
            }
            let lambda = found.map(|part| product(ratio(&r), part));
            let squares: Vec<_> =
                std::iter::successors(Some(lambda), |&z| Some(times(z, z))).take(7).collect();
            let (mut x, mut y) = (ball(&r) * &cos, ball(&r) * &sin);
            let (a, b) = (x.clone(), y.clone());
            for m in 1..=100 {
                let found = power(&squares, m);
                assert!(off_by(found[0], &x) < integer(720 * m) && off_by(found[1], &y) < integer(720 * m));
                (x, y) = (x.clone() * &a - &(y.clone() * &b), x * &b + &(y * &a));
            }
            // Complex and real eigenvalues inside the unit circle.
            let (a1, a2) = (fraction(&mut random) * BigInt::from(2) - integer(1), &r * &r);
            for a1 in [&a1 * &r, &r + &(&s * &r), -(&r + &(&s * &r))] {
                let a2 = if a1.numer().bits() % 2 == 0 { a2.clone() } else { &r * &s * &r };
                let Ok(plane) = Plane::new(a1.clone(), a2.clone()) else { continue };
                let Some(coefficients) = coefficients(&plane, 100) else { continue };
                let (mut before, mut u) = (ball(&integer(0)), ball(&integer(1)));
                for (m, found) in (1..=100).zip(terms(coefficients)) {
                    assert!(off_by(found, &u) <= integer(cube(m)), "{a1} {a2} {m}");
                    let next = ball(&a1) * &u - &(ball(&a2) * &before);
                    before = std::mem::replace(&mut u, next);
                }
            }
        }
    }
}
