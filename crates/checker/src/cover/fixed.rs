//! Fixed point: an `i64` X stands for X·2⁻⁶⁰, so numbers from −8 to 8; angles in turns, a `u64` for X·2⁻⁶⁴.
//!
//! Errors are counted in units of 2⁻⁶⁰. A sum of integers is exact; a product is rounded down, off by less
//! than 1.

/// 1.
pub const ONE: i64 = 1 << 60;

/// π rounded down, off by less than 1. (π = 3.243F6A88 85A308D3 13… in hexadecimal; the tests compare with
/// Machin's formula.)
const PI: i64 = 0x3243_F6A8_885A_308D;

/// x·y rounded down. Precondition: |x·y| < 8.
#[inline]
pub(super) fn product(x: i64, y: i64) -> i64 {
    let exact = (i128::from(x) * i128::from(y)) >> 60;
    debug_assert!(i64::try_from(exact).is_ok(), "{x} * {y} leaves the range");
    exact as i64
}

/// An upper bound of the angle of `turns`, in radians; within 2. Precondition: turns ≤ ¼.
pub(super) fn radians_above(turns: u64) -> i64 {
    // 2π·X·2⁻⁶⁴ = (X π/8)·2⁻⁶⁰, and PI + 1 is above π·2⁶⁰.
    ((u128::from(turns) * (PI as u128 + 1)) >> 63) as i64 + 1
}

/// 2i(2i + 1) for i = 8, …, 1: sin x = x (1 − y/6 (1 − y/20 (1 − …))), y = x².
const SINE: [i64; 8] = [272, 210, 156, 110, 72, 42, 20, 6];

/// 2i(2i − 1) for i = 9, …, 1: cos x = 1 − y/2 (1 − y/12 (1 − …)).
const COSINE: [i64; 9] = [306, 240, 182, 132, 90, 56, 30, 12, 2];

/// sin and cos of a number of turns, each within 4 and between −1 and 1.
///
/// The angle is reduced to x ≤ π/4 by its octant, exactly. The cut series is off by less than x¹⁹/19! < 0.1
/// (sine) or x²⁰/20! < 0.01 (cosine). x is off by 1.25: 0.25 from PI (x/π ≤ ¼) and 1 from rounding; y,
/// rounded down from that x, by 1. A Horner step t ↦ 1 − y t/d with 0 ≤ t ≤ 1 and y ≤ 0.62 turns an error e
/// of t into at most (0.62 e + 1 + 1)/d + 1. From e = 0 on, e stays below 1.4 while d ≥ 6, so that 1 − … is
/// off by 1.4 for the sine and, its last d being 2, by 2.5 for the cosine. In all: sine 1.25 + 0.1 +
/// 0.79·1.4 + 1 < 4, cosine 1.25 + 0.01 + 2.5 < 4.
#[inline]
pub fn sine_cosine(turns: u64) -> (i64, i64) {
    let (octant, rest) = (turns >> 61, turns & ((1 << 61) - 1));
    let folded = if octant & 1 == 1 { (1 << 61) - rest } else { rest };
    let x = ((u128::from(folded) * PI as u128) >> 63) as i64;
    let y = product(x, x);
    let sine = product(x, series(y, SINE));
    let cosine = series(y, COSINE);
    // Octants 1, 2, 5, 6 lie nearer to the vertical axis; the sine is negative in 4 to 7, the cosine in 2
    // to 5.
    let (sine, cosine) = if (octant + 1) & 2 == 2 { (cosine, sine) } else { (sine, cosine) };
    (if octant >= 4 { -sine } else { sine }, if (octant + 2) & 4 == 4 { -cosine } else { cosine })
}

/// sin and cos of α + β from those of α and β, each within 14 if those are within 4: an error of 4 meets
/// factors that add up to at most 2√2 and two products are rounded.
#[inline]
fn combined((sine, cosine): (i64, i64), (s, c): (i64, i64)) -> (i64, i64) {
    (product(sine, c) + product(cosine, s), product(cosine, c) - product(sine, s))
}

/// sin and cos of α − β from those of α and β, each within 14 if those are within 4.
#[inline]
pub(super) fn difference(alpha: (i64, i64), (s, c): (i64, i64)) -> (i64, i64) {
    combined(alpha, (-s, c))
}

/// sin and cos of 0, 1, …, n times a number of turns, each within 14: those of 8i + j from those of 8i and j.
pub fn sines_cosines(turns: u64, n: u64) -> impl Iterator<Item = (i64, i64)> {
    let multiple = move |q: u64| sine_cosine(turns.wrapping_mul(q));
    let small: [_; 8] = std::array::from_fn(|j| multiple(j as u64));
    (0..=n / 8)
        .flat_map(move |i| {
            let large = multiple(8 * i);
            small.into_iter().map(move |small| combined(large, small))
        })
        .take(n as usize + 1)
}

/// 1 − y/d_N (… (1 − y/d_2 (1 − y/d_1))). The number of terms is known when compiling: no division is left in
/// the loop.
#[inline(always)]
fn series<const N: usize>(y: i64, divisors: [i64; N]) -> i64 {
    divisors.into_iter().fold(ONE, |t, d| ONE - product(y, t) / d)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// π = 16 arctan 1/5 − 4 arctan 1/239 with 100 bits, each of its 60 divisions off by 1.
    #[test]
    fn pi_is_machins() {
        let arctan = |q: i128| {
            let mut power = (1i128 << 100) / q;
            let (mut sum, mut odd) = (0, 1);
            while power != 0 {
                sum += if odd % 4 == 1 { power / odd } else { -power / odd };
                power /= q * q;
                odd += 2;
            }
            sum
        };
        let pi = 16 * arctan(5) - 4 * arctan(239);
        assert_eq!(pi >> 40, i128::from(PI));
        assert!((pi - (i128::from(PI) << 40)) > 1 << 20);
    }

    /// sin² + cos² = 1 and the addition theorem, in every octant and at its ends.
    #[test]
    fn sines_obey_their_identities() {
        let mut turns = 0u64;
        for i in 0..100_000u64 {
            turns = turns.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            let a = if i < 64 {
                (i / 8).wrapping_mul(1 << 61).wrapping_add(i % 8).wrapping_sub(4)
            } else {
                turns
            };
            let b = turns.rotate_left(32);
            let ((sa, ca), (sb, cb)) = (sine_cosine(a), sine_cosine(b));
            let (s, c) = sine_cosine(a.wrapping_add(b));
            assert!(sa.abs() <= ONE && ca.abs() <= ONE);
            assert!((product(sa, sa) + product(ca, ca) - ONE).abs() <= 14);
            assert!((product(sa, cb) + product(ca, sb) - s).abs() <= 18);
            assert!((product(ca, cb) - product(sa, sb) - c).abs() <= 18);
        }
        assert_eq!(sine_cosine(0).1, ONE);
        for turns in [0, 1, turns >> 7, turns, u64::MAX / 3] {
            for (q, (sine, cosine)) in (0..).zip(sines_cosines(turns, 300)) {
                let (s, c) = sine_cosine(turns.wrapping_mul(q));
                assert!((sine - s).abs() <= 18 && (cosine - c).abs() <= 18);
            }
        }
    }
}
