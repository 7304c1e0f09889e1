//! The plain forms of b_{n,k} on limbs, for balls: from (r, s) with sines of exact angles, from (a₁, a₂) by
//! duplication.
//!
//! With j = n − k, b_{n,k} is 1 − (sin 2πks + rⁿ sin 2πjs)/(r^j sin 2πns), or 1 − (u_k + a₂^k u_j)/u_n. These
//! cancel near a zero of b_{n,k}, and where r → 1 much more than they must. But a few limbs more cost little:
//! the numerator is evaluated with some bits to spare, again with as many more as it lost, and is then as
//! good as if nothing had cancelled. Where that would take too many, there is no answer, and the forms of
//! `local`, which do not cancel, have to give one.

use num_bigint::BigUint;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::Sign;
use super::angle::Angle;
use super::approximation::{Approximation, Limbs};
use super::ball::{Ball, Precision};
use super::ball_sine::{self, ERROR, SINE_GUARD, limbs_for};
use super::fixed;
use super::short_sine::Divisor;

/// Bits of the numerator and the denominator of a quotient beyond those of the quotient.
const SPARE: u64 = 4;

/// The longest period: multiples of s by it are right to 2⁻¹⁶ of the last place.
const LONGEST: u64 = 1 << 48;

/// The longest numbers on the stack, in limbs.
const STACKED: usize = 9;

/// Numbers of limbs that are also sines.
pub(super) trait Turned: Limbs {
    /// sin or cos of πt within [`ERROR`], for t ≤ ¼ on a limb more, known within 2⁵⁰ of its last place;
    /// `None` for the least t, where the sine would not have its relative accuracy.
    fn sine(cosine: bool, t: &[u64], precision: &Precision) -> Option<Self>;
}

impl Turned for Vec<u64> {
    fn sine(cosine: bool, t: &[u64], precision: &Precision) -> Option<Self> {
        let length = t.len() - 1;
        if t[length] >> 55 == 0 {
            return None;
        }
        Some(ball_sine::limbs_sine(cosine, t, precision))
    }
}

/// s, or a multiple of it, modulo 1.
struct Turn<'a> {
    s: &'a BigRational,
    /// On a limb more than what is computed with, cut.
    limbs: Vec<u64>,
}

impl<'a> Turn<'a> {
    /// 0 < s < ½.
    fn new(s: &'a BigRational, length: usize) -> Self {
        let (p, q) = (s.numer().magnitude(), s.denom().magnitude());
        let limbs = match (p.to_u64(), q.to_u64()) {
            (Some(p), Some(q)) => {
                let mut limbs = vec![0; length + 1];
                Divisor::new(q).fraction(p, &mut limbs);
                limbs
            }
            _ => {
                let quotient: BigUint = (p << (64 * (length + 1))) / q;
                fixed::limbs(&quotient, length + 1)
            }
        };
        Turn { s, limbs }
    }

    /// sin 2πis, for i up to [`LONGEST`].
    ///
    /// The limbs times i are off by less than i, twice that by 2i ≤ 2⁴⁹, and the units below add 2.
    fn sine<S: Turned>(&self, i: u64, precision: &Precision) -> Approximation<S> {
        let length = self.limbs.len() - 1;
        let mut t = self.limbs.clone();
        let mut carry = 0u64;
        for limb in &mut t {
            let scaled = u128::from(*limb) * u128::from(i) + u128::from(carry);
            (*limb, carry) = (scaled as u64, (scaled >> 64) as u64);
        }
        // What is beyond a whole number; sin 2πx = −sin 2π(x − ½).
        let negative = t[length] >> 63 == 1;
        double(&mut t);
        // sin πt = sin π(1 − t), with a unit less.
        if t[length] >> 63 == 1 {
            t.iter_mut().for_each(|limb| *limb = !*limb);
        }
        let cosine = t[length] >> 62 == 1;
        if cosine {
            // ½ − t, with a unit less.
            t.iter_mut().for_each(|limb| *limb = !*limb);
            t[length] &= (1 << 63) - 1;
        }
        match S::sine(cosine, &t, precision) {
            Some(limbs) => Approximation::fraction(negative, limbs, ERROR),
            None => self.exactly(i, length, precision),
        }
    }

    /// sin 2πis from the exact angle, with full relative accuracy.
    fn exactly<S: Turned>(&self, i: u64, length: usize, precision: &Precision) -> Approximation<S> {
        let angle = Angle::new(self.s).times(2 * i);
        let (m, exp, radius) = ball_sine::exact_sine(&angle, precision, length);
        Approximation::enclosed(&m, exp, radius, length)
    }
}

/// Twice the fraction, modulo 1.
fn double(limbs: &mut [u64]) {
    let mut carry = 0;
    for limb in limbs {
        (*limb, carry) = (*limb << 1 | carry, *limb >> 63);
    }
}

/// Numerator and denominator of b_{n,k}, but for a factor.
struct Parts<S> {
    numerator: Approximation<S>,
    denominator: Approximation<S>,
    /// The leading bits that are certain of each term of the numerator. Few where errors have grown with
    /// every duplication: more limbs do not bring them back, since the zeros that stay above them double.
    kept: u64,
}

impl<S: Limbs> Parts<S> {
    /// first − second − third over first.
    fn of(first: Approximation<S>, second: &Approximation<S>, third: &Approximation<S>) -> Self {
        let kept = [&first, second, third].map(Approximation::certain_bits);
        let numerator = first.minus(second).minus(third);
        Parts { numerator, denominator: first, kept: kept[0].min(kept[1]).min(kept[2]) }
    }

    /// `sign` if it is certain, or that it cannot be to these bits; `None` where another form may tell it.
    fn told(&self, sign: Option<Sign>, precision: &Precision) -> Option<Option<Sign>> {
        (sign.is_some() || self.kept >= u64::from(precision.bits())).then_some(sign)
    }
}

/// r^j sin 2πns − sin 2πks − rⁿ sin 2πjs and r^j sin 2πns, 0 < r < 1. Cost: three sines and O(log n)
/// products.
fn turned<S: Turned>(
    (r, s): (&BigRational, &BigRational),
    [n, k]: [u64; 2],
    precision: &Precision,
    length: usize,
) -> Parts<S> {
    let j = n - k;
    let r = Approximation::<S>::ratio(r, length);
    let turn = Turn::new(s, length);
    let [at_n, at_k, at_j] = [n, k, j].map(|i| turn.sine::<S>(i, precision));
    let (power_j, power_k) = (r.power(j), r.power(k));
    let first = power_j.times(&at_n);
    let last = power_j.times(&power_k).times(&at_j);
    Parts::of(first, &at_k, &last)
}

/// u_n − u_k − a₂^k u_{n−k} and u_n, from a₁, D = a₁²/4 − a₂ and a₂. Cost: O(log n) products.
fn duplicated<S: Limbs>(parts: [&BigRational; 3], [n, k]: [u64; 2], length: usize) -> Parts<S> {
    let [a1, quarter, a2] = parts.map(|part| Approximation::<S>::ratio(part, length));
    let half = a1.halved();
    let at = |i| Duplicated::at(i, [&half, &quarter, &a2], length);
    let (at_k, at_j) = (at(k), at(n - k));
    let un = at_k.u.times(&at_j.h).plus(&at_k.h.times(&at_j.u));
    Parts::of(un, &at_k.u, &at_k.power.times(&at_j.u))
}

/// u_i, h_i = v_i/2 and a₂^i.
struct Duplicated<S> {
    u: Approximation<S>,
    h: Approximation<S>,
    power: Approximation<S>,
}

impl<S: Limbs> Duplicated<S> {
    /// By λ^i = h_i + u_i √D: u_{2i} = 2u_i h_i, h_{2i} = 2h_i² − a₂^i; u_{i+1} = (a₁/2) u_i + h_i, h_{i+1} =
    /// (a₁/2) h_i + D u_i. i ≥ 1.
    fn at(i: u64, [half, quarter, a2]: [&Approximation<S>; 3], length: usize) -> Self {
        let mut at = Duplicated { u: Approximation::one(length), h: half.clone(), power: a2.clone() };
        for bit in (0..63 - i.leading_zeros()).rev() {
            let u = at.u.times(&at.h).doubled();
            let h = at.h.times(&at.h).doubled().minus(&at.power);
            at = Duplicated { u, h, power: at.power.times(&at.power) };
            if i >> bit & 1 == 1 {
                let u = half.times(&at.u).plus(&at.h);
                let h = half.times(&at.h).plus(&quarter.times(&at.u));
                at = Duplicated { u, h, power: at.power.times(a2) };
            }
        }
        at
    }
}

/// A form by as many limbs as asked for, or some more: on the stack where there is a table.
macro_rules! by_length {
    ($length:expr, $form:ident($($argument:expr),*)) => {
        match $length {
            0..=3 => $form::<[u64; 3]>($($argument,)* 3),
            4..=5 => $form::<[u64; 5]>($($argument,)* 5),
            6..=9 => $form::<[u64; 9]>($($argument,)* 9),
            length => $form::<Vec<u64>>($($argument,)* length),
        }
    };
}

/// Numerator and denominator of b_{n,k} from (r, s), both to the bits and [`SPARE`] more; `None` where that
/// takes too many limbs.
pub(super) fn polar_parts(
    point: (&BigRational, &BigRational),
    at: [u64; 2],
    precision: &Precision,
) -> Option<[Ball; 2]> {
    fn parts<S: Turned>(
        point: (&BigRational, &BigRational),
        at: [u64; 2],
        precision: &Precision,
        length: usize,
    ) -> Result<[Ball; 2], u64> {
        settled(turned::<S>(point, at, precision, length), precision)
    }
    let longest = precision.pi_bits() as usize / 64;
    let known = |length: usize| length <= longest.max(STACKED) && at[0] <= LONGEST;
    attempts(precision, known, |length| by_length!(length, parts(point, at, precision)))
}

/// The sign of the numerator of b_{n,k} from (r, s), if this many bits show it; `None` where this form is not
/// for such an n.
pub(super) fn polar_sign(
    point: (&BigRational, &BigRational),
    at: [u64; 2],
    precision: &Precision,
) -> Option<Option<Sign>> {
    fn sign<S: Turned>(
        point: (&BigRational, &BigRational),
        at: [u64; 2],
        precision: &Precision,
        length: usize,
    ) -> Option<Option<Sign>> {
        let parts = turned::<S>(point, at, precision, length);
        parts.told(parts.numerator.sign(), precision)
    }
    if at[0] > LONGEST {
        return None;
    }
    by_length!(first_length(precision), sign(point, at, precision))
}

/// u_n b_{n,k} and u_n from a₁, D and a₂, as [`polar_parts`].
pub(super) fn plane_parts(
    parts: [&BigRational; 3],
    at: [u64; 2],
    precision: &Precision,
) -> Option<[Ball; 2]> {
    fn both<S: Limbs>(
        parts: [&BigRational; 3],
        at: [u64; 2],
        precision: &Precision,
        length: usize,
    ) -> Result<[Ball; 2], u64> {
        settled(duplicated::<S>(parts, at, length), precision)
    }
    attempts(precision, |_| true, |length| by_length!(length, both(parts, at, precision)))
}

/// The sign of b_{n,k} from a₁, D and a₂, as [`polar_sign`].
pub(super) fn plane_sign(
    parts: [&BigRational; 3],
    at: [u64; 2],
    precision: &Precision,
) -> Option<Option<Sign>> {
    fn sign<S: Limbs>(
        parts: [&BigRational; 3],
        at: [u64; 2],
        precision: &Precision,
        length: usize,
    ) -> Option<Option<Sign>> {
        let parts = duplicated::<S>(parts, at, length);
        let sign = parts.numerator.sign().zip(parts.denominator.sign()).map(|(a, b)| a * b);
        parts.told(sign, precision)
    }
    by_length!(first_length(precision), sign(parts, at, precision))
}

/// Limbs for a first attempt: at least 32 bits more than the ball has.
fn first_length(precision: &Precision) -> usize {
    limbs_for(precision.bits() + SINE_GUARD)
}

/// Both parts as balls, if they have the bits; else how many are missing, as far as that is known.
fn settled<S: Limbs>(parts: Parts<S>, precision: &Precision) -> Result<[Ball; 2], u64> {
    let parts = [parts.numerator, parts.denominator];
    let wanted = u64::from(precision.bits()) + SPARE;
    let certain = parts.each_ref().map(Approximation::certain_bits);
    let least = certain[0].min(certain[1]);
    if least >= wanted {
        return Ok(parts.map(|part| part.ball(precision.bits() + SPARE as u32)));
    }
    Err(if least == 0 { u64::MAX } else { wanted - least })
}

/// An attempt, and another with as many limbs as the first one was missing, if these are `known` and at most
/// double its length.
fn attempts(
    precision: &Precision,
    known: impl Fn(usize) -> bool,
    attempt: impl Fn(usize) -> Result<[Ball; 2], u64>,
) -> Option<[Ball; 2]> {
    let first = first_length(precision);
    let missing = match known(first).then(|| attempt(first))? {
        Ok(parts) => return Some(parts),
        Err(missing) => missing,
    };
    let second = usize::try_from(missing.div_ceil(64)).ok().filter(|&more| more <= first)? + first;
    known(second).then(|| attempt(second).ok())?
}

#[cfg(test)]
mod tests {
    use num_bigint::BigInt;
    use num_traits::One;

    use super::*;
    use crate::random::Random;
    use crate::{Circular, Real};

    /// Sines of multiples against those of the exact angle, at random and beside the ends of octants and of
    /// the table's parts.
    fn sines<S: Turned>(length: usize, cases: usize) {
        let precision = Precision::new(64 * length as u32);
        let long = Precision::new(64 * length as u32 + 64);
        let mut random = Random(length as u64);
        let mut seen = 0;
        for case in 0..cases {
            let i = 1 + (random.next() >> (16 + case % 48));
            let ratio = |p: u64, q: u64| BigRational::new(p.into(), q.into());
            let near = |value: BigRational, bits: u64| {
                // A fraction of 2^-bits beside it, for s so that i s is beside it too.
                let tiny = BigRational::new(BigInt::one(), (BigInt::one() << bits) + 1u32);
                let value = (value + BigInt::from(random_whole(i, case))) / BigInt::from(i);
                if case % 2 == 0 { value + tiny } else { value - tiny }
            };
            let s = match case % 4 {
                0 => ratio(1 + random.below(499_999), 1_000_003),
                1 => ratio(random.next() >> 2, u64::MAX),
                2 => near(ratio(random.below(1024), 1024), 20 + random.below(400)),
                _ => near(ratio(random.below(8), 8), 20 + random.below(400)),
            };
            if s <= ratio(0, 1) || s >= ratio(1, 2) {
                continue;
            }
            seen += 1;
            let sine = Turn::new(&s, length).sine::<S>(i, &precision);
            let truth = Ball::sin(&Angle::new(&(&s * BigInt::from(2))).times(i), &long);
            let (low, high) = (sine.ball(64 * length as u32) - &truth).exact_bounds().unwrap();
            let zero = BigRational::from_integer(0.into());
            assert!(low <= zero && zero <= high, "sin 2π {i} · {s}");
            assert!(
                sine.certain_bits() + 24 >= 64 * length as u64 || truth.sign() == Some(Sign::Zero),
                "{s}"
            );
        }
        assert!(seen > cases / 2, "{seen}");
    }

    /// A whole number so that (that + x)/i, 0 ≤ x < 1, is mostly below ½.
    fn random_whole(i: u64, case: usize) -> u64 {
        if i < 4 { 0 } else { (case as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) % (i / 2) }
    }

    #[test]
    fn sines_of_multiples_are_those_of_the_exact_angle() {
        sines::<[u64; 3]>(3, 2000);
        sines::<[u64; 5]>(5, 2000);
        sines::<[u64; 9]>(9, 2000);
        sines::<Vec<u64>>(10, 300);
        sines::<Vec<u64>>(17, 300);
    }
}
