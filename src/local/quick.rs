//! The signs of b_{n,k}, for all k at once, by plain `f64` with bounds proved beforehand: from (r, s), and
//! from (a₁, a₂) with real eigenvalues.
//!
//! From (r, s), with u = 2⁻⁵³, ε = n 2⁻⁵⁰, n ≤ 4096, and M = −(σ_n X + κ_n Y) is the folded form of
//! [`Polar`](super::Polar), X = a_j a_k + b_j b_k and Y = a_j b_k − b_j a_k with a_i = h_i κ_i, b_i = p_i
//! σ_i.
//!
//! - e^{iπms}: its first power has sine and cosine within 2u each, so is off by 2√2 u, and a complex product
//!   adds 4u. The m-th is off by m 2⁻⁵⁰ ≤ ε at most.
//! - r^m = p_m − 1: r is off by 4u of itself, a product adds u of its result: p_m within ε in all. h_m adds
//!   up products r^i h_1 of positive numbers: within m 2⁻⁵⁰ of itself. Where r^i underflows it no longer
//!   counts.
//! - So a_i is within 2.2ε h_i, and b_i, which is at most 2, within 3.2ε; X, at most 5, within 19ε; Y, at
//!   most 2(h_j + h_k), within 9(h_j + h_k)ε.
//! - σ_n and κ_n, from exact angles, are within 4u of themselves. So M is within 21ε|σ_n| + 10(h_j + h_k)ε.
//!   In place of 21 and 10 there are 24 and 12: this covers the roundings of the bound itself, and products
//!   that underflow, as long as σ_n and h_1 are above 2⁻⁹⁰⁰.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::{Plane, Polar, Region};
use crate::number::{Angle, Circular, FloatInterval, Real, Sign};

/// The longest period.
const LONGEST: u64 = 4096;

/// Below this, 2⁻⁹⁰⁰, products could underflow.
const SMALLEST: f64 = f64::from_bits((1023 - 900) << 52);

/// A float within 4u of the enclosed number, relatively, if the enclosure is as narrow as that.
fn narrow(x: FloatInterval) -> Option<f64> {
    const WIDTH: f64 = 1.0 / (1u64 << 51) as f64;
    (x.hi() - x.lo() <= WIDTH * x.lo().abs().min(x.hi().abs())).then(|| x.lo())
}

/// The signs of b_{n,1}, …, b_{n,n−1} where they are certain; `None` where the bounds do not hold. Needs
/// r < 1 and u_n ≠ 0. Cost: four sines and O(n) operations.
pub(super) fn polar_signs(polar: &Polar, n: u64) -> Option<Vec<Option<Sign>>> {
    let half = Angle::new(polar.s());
    let (at_n, u) = (half.times(n), polar.u_sign(n));
    let sine = |angle: &Angle| FloatInterval::sin(angle, &());
    let cosine = |angle: &Angle| FloatInterval::cos(angle, &());
    let [sin_n, cos_n] = [narrow(sine(&at_n))?, narrow(cosine(&at_n))?];
    let first = [cosine(&half), sine(&half)];
    const DOUBLE: f64 = 1.0 / (1u64 << 52) as f64;
    if first.iter().any(|part| part.hi() - part.lo() > DOUBLE) {
        return None;
    }
    let [a, b] = first.map(|part| part.lo());
    let rest = narrow(FloatInterval::ratio(&(BigRational::one() - polar.r()), &()))?;
    let r = narrow(FloatInterval::ratio(polar.r(), &()))?;
    if n > LONGEST || sin_n.abs() < SMALLEST || rest < SMALLEST {
        return None;
    }
    let epsilon = n as f64 * (1.0 / (1u64 << 50) as f64);
    // h_i κ_i, p_i σ_i and h_i for i = 1, …, n − 1.
    let (mut x, mut y, mut power, mut h) = (a, b, r, rest);
    let parts: Vec<[f64; 3]> = (1..n)
        .map(|_| {
            let part = [h * x, (1.0 + power) * y, h];
            (x, y) = (x * a - y * b, x * b + y * a);
            h += power * rest;
            power *= r;
            part
        })
        .collect();
    let sign = |([ak, bk, hk], [aj, bj, hj]): (&[f64; 3], &[f64; 3])| {
        let numerator = -(sin_n * (aj * ak + bj * bk) + cos_n * (aj * bk - bj * ak));
        let bound = epsilon * (24.0 * sin_n.abs() + 12.0 * (hj + hk));
        (numerator.abs() > bound).then(|| u.negated_if(numerator < 0.0))
    };
    Some(parts.iter().zip(parts.iter().rev()).map(sign).collect())
}

/// The same from real eigenvalues; `None` also for complex ones. Cost: O(n) operations.
pub(super) fn plane_signs(plane: &Plane, n: u64) -> Option<Vec<Option<Sign>>> {
    let excess = match plane.region() {
        Region::Three => return None,
        Region::One | Region::Five => Sign::Negative,
        Region::Two | Region::Four => Sign::Positive,
        Region::Line => Sign::Zero,
    };
    let (p, q) = (plane.a1().numer().abs(), plane.a1().denom());
    let (x, y) = (plane.a2().numer(), plane.a2().denom());
    let square: BigInt = q * q * 4u32;
    let quarter = BigRational::new_raw(&p * &p * y - &square * x, square * y);
    let float = |x: &BigRational| narrow(FloatInterval::ratio(x, &()));
    let (first, quarter, a2) =
        (float(&BigRational::new_raw(p, q * 2u32))?, float(&quarter)?, float(plane.a2())?);
    const LARGEST: f64 = f64::from_bits((1023 + 400) << 52);
    let sound = |x: f64| (1.0 / LARGEST..LARGEST).contains(&x);
    if n > LONGEST || !(quarter == 0.0 || sound(quarter)) {
        return None;
    }
    // ũ_i and a₂^i for i = 0, …, n.
    let (mut u, mut h, mut power) = (0.0, 1.0, 1.0);
    let mut all = Vec::with_capacity(n as usize + 1);
    for i in 0..=n {
        if !(sound(h) && (sound(u) || i == 0)) {
            return None;
        }
        all.push((u, power));
        (u, h) = (h + u * first, h * first + quarter * u);
        power *= a2;
    }
    let un = all[n as usize].0;
    let near = 12.0 * n as f64 * (1.0 / (1u64 << 53) as f64);
    let sign = |k: u64| {
        let ((uk, power), (uj, _)) = (all[k as usize], all[(n - k) as usize]);
        let tail = power * uj;
        let numerator = match (plane.a1().is_negative(), n.is_multiple_of(2), k.is_multiple_of(2)) {
            (false, _, _) | (true, true, true) => return Some(-excess),
            // All three of one sign, that of u_n.
            (true, true, false) => return Some(Sign::Positive),
            (true, false, true) => un + uk - tail,
            (true, false, false) => un - uk + tail,
        };
        let certain = numerator.abs() > near * (un + uk + tail);
        certain.then(|| Sign::Positive.negated_if(numerator < 0.0))
    };
    Some((1..n).map(sign).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        local::{Answer, Ladder, Point, Quantity},
        random::Random,
    };

    /// What is told is so, near r = 1 and near fractions m/n too; and most is told.
    #[test]
    fn certain_signs_are_those_of_the_ladder() {
        let (ladder, mut random) = (Ladder::default(), Random::of_unit(8, 0));
        let (mut told, mut open) = (0, 0);
        for _ in 0..300 {
            let n = random.within(2, 40);
            let tiny =
                |random: &mut Random| BigRational::new(1.into(), BigInt::one() << random.within(2, 110));
            let r = match random.within(0, 2) {
                0 => tiny(&mut random),
                _ => BigRational::one() - tiny(&mut random),
            };
            let s = BigRational::new(random.within(1, n).into(), (2 * n + 1).into());
            let s = match random.within(0, 2) {
                0 => s,
                _ => {
                    BigRational::new(random.within(1, n.div_ceil(2)).into(), (2 * n).into())
                        + tiny(&mut random)
                }
            };
            let Ok(polar) = Polar::new(r, s) else { continue };
            if polar.is_singular(n) {
                continue;
            }
            let point = Point::Polar(polar.clone());
            for (k, found) in (1..).zip(polar_signs(&polar, n).expect("no underflow")) {
                match found {
                    None => open += 1,
                    Some(sign) => {
                        told += 1;
                        let answer = ladder.sign(&point, Quantity::B { n, k }).answer;
                        assert_eq!(answer, Answer::Sign(sign), "{polar:?}, n = {n}, k = {k}");
                    }
                }
            }
        }
        assert!(told > 3000 && open > 100 && told > 5 * open, "{told} {open}");
    }
    /// The same from real eigenvalues of one sign: in every region, on its lines, and for equal ones.
    #[test]
    fn certain_signs_from_real_eigenvalues_are_those_of_the_ladder() {
        let (ladder, mut random) = (Ladder::default(), Random::of_unit(9, 0));
        let (mut told, mut open) = ([0; 3], 0);
        for _ in 0..400 {
            let n = random.within(2, 30);
            let mut eigenvalue = || match random.within(0, 4) {
                0 => BigRational::one(),
                1 => BigRational::one() - BigRational::new(1.into(), BigInt::one() << random.within(1, 90)),
                2 => BigRational::new(random.within(1, 90).into(), 40.into()),
                _ => BigRational::new(random.within(1, 40).into(), 41.into()),
            };
            let (x, y) = (eigenvalue(), eigenvalue());
            let y = if random.within(0, 3) == 0 { x.clone() } else { y };
            let a1 = if random.within(0, 2) > 0 { -(&x + &y) } else { &x + &y };
            let plane = Plane::new(a1, x * y).unwrap();
            let point = Point::Plane(plane.clone());
            for (k, found) in (1..).zip(plane_signs(&plane, n).expect("no underflow")) {
                let Some(sign) = found else {
                    open += 1;
                    continue;
                };
                told[usize::from(sign == Sign::Negative) + 2 * usize::from(sign == Sign::Zero)] += 1;
                let answer = ladder.sign(&point, Quantity::B { n, k }).answer;
                assert_eq!(answer, Answer::Sign(sign), "{plane:?}, n = {n}, k = {k}");
            }
        }
        assert!(told.iter().all(|&told| told > 100) && open > 0, "{told:?} {open}");
    }
}
