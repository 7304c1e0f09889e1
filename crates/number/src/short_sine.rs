//! sin πt and cos πt of short fractions to at most 9 limbs: a table of multiples of π/256, and a short series
//! for the rest of the angle.
//!
//! With j the integer nearest to 256 t and d = π(t − j/256), |d| ≤ π/512, and a = πj/256,
//!
//! ```text
//! sin(a + d) = sin a + cos a sin d − sin a (1 − cos d)
//! cos(a + d) = cos a − sin a sin d − cos a (1 − cos d)
//! ```
//!
//! The table is made once for every number of limbs, from the long series (`ball_sine`). Numbers are
//! fractions X·2^−64L, errors count in their last place.

use std::sync::LazyLock;

use super::approximation::Limbs;
use super::ball_forms::Turned;
use super::{angle, ball::Precision, ball_sine, fixed};

/// The error bound of [`Table::evaluate`], in the last place.
pub(super) const SHORT_ERROR: u64 = 16;

/// Parts of a half turn.
const PARTS: u64 = 256;

/// Powers of d² that are kept: terms of the series are summed by blocks of so many.
const BLOCK: usize = 4;

static THREE: LazyLock<Table<3>> = LazyLock::new(Table::new);
static FIVE: LazyLock<Table<5>> = LazyLock::new(Table::new);
static NINE: LazyLock<Table<9>> = LazyLock::new(Table::new);

/// sin or cos of πp/q, 0 < p/q ≤ ¼, within [`SHORT_ERROR`], by at least `length` limbs; `None` where these
/// are too many, or p/q below 1/512, where the sine would not have its relative accuracy.
///
/// Cost for L limbs: 13 to 20 products of L limbs, for 3 to 9.
pub(super) fn short_sine(cosine: bool, p: u64, q: u64, length: usize) -> Option<Vec<u64>> {
    // The nearest integer; 2·256·p ≤ 128 q.
    let j = match p.checked_mul(2 * PARTS).and_then(|wide| wide.checked_add(q)) {
        Some(wide) if q < 1 << 63 => wide / (2 * q),
        _ => ((u128::from(p) * u128::from(2 * PARTS) + u128::from(q)) / u128::from(q) / 2) as u64,
    };
    if j == 0 {
        return None;
    }
    // |256 p − j q| ≤ q/2 + 1: the wrapped difference is the true one.
    let rest = (p.wrapping_mul(PARTS)).wrapping_sub(j.wrapping_mul(q)) as i64;
    let angle = Short { j: j as usize, negative: rest < 0, p: rest.unsigned_abs(), q };
    Some(match length {
        0..=3 => THREE.turn(cosine, &angle).to_vec(),
        4..=5 => FIVE.turn(cosine, &angle).to_vec(),
        6..=9 => NINE.turn(cosine, &angle).to_vec(),
        _ => return None,
    })
}

/// Limbs on the stack, of a length that there is a table for.
impl<const L: usize> Limbs for [u64; L] {
    fn zero(length: usize) -> Self {
        debug_assert_eq!(length, L);
        [0; L]
    }

    fn limbs(&self) -> &[u64] {
        self
    }

    fn limbs_mut(&mut self) -> &mut [u64] {
        self
    }

    #[inline(always)]
    fn product(&self, other: &Self) -> Self {
        product(self, other)
    }
}

/// The table of every length that has one.
macro_rules! tabled {
    ($($length:literal $table:ident),*) => {$(
        impl Turned for [u64; $length] {
            #[inline]
            fn sine(cosine: bool, t: &[u64], _: &Precision) -> Option<Self> {
                $table.at(cosine, t)
            }
        }
    )*};
}

tabled!(3 THREE, 5 FIVE, 9 NINE);

/// π(j ± p/q)/256, p ≤ q/2.
struct Short {
    j: usize,
    negative: bool,
    p: u64,
    q: u64,
}

/// What a number of limbs needs.
struct Table<const L: usize> {
    /// π/4, cut.
    quarter: [u64; L],
    /// sin and cos of πj/256, cut; j = 0, …, 64, of which 0 is not asked for.
    values: Vec<[[u64; L]; 2]>,
    /// 1 − cos d and 1 − sin d / d.
    series: [Series; 2],
}

/// Σ_{i=1}^{N} (−1)^{i+1} y^i first!/(2i + first)!, N even, from its last term on.
struct Series {
    terms: Vec<Term>,
    /// By which the sum is divided last.
    divisor: Divisor,
}

/// A term: y^i `scale` in the unit that holds then, and the divisor that changes the unit after it, if one
/// does.
struct Term {
    scale: u64,
    divisor: Option<Divisor>,
}

/// A divisor ≥ 2 with its reciprocal, for [`divide`].
pub(super) struct Divisor {
    /// d·2^shift ≥ 2⁶³.
    normal: u64,
    shift: u32,
    /// ⌊(2¹²⁸ − 1)/normal⌋ − 2⁶⁴.
    reciprocal: u64,
}

impl<const L: usize> Table<L> {
    fn new() -> Self {
        let w = 64 * L as u32;
        // From values with a limb more, whose error is far below a unit.
        let precision = Precision::new(w);
        let long = |cosine, j: u64| -> [u64; L] {
            let fraction = angle::Fraction::Small(j, PARTS);
            let (value, exp, _) = ball_sine::series_kernel(cosine, &fraction, &precision, L + 1);
            cut(&fixed::limbs(&(value.magnitude() >> (-exp - i128::from(w))), L))
        };
        let pi = fixed::limbs((ball_sine::pi(w + 64) >> 66u32).magnitude(), L);
        Table {
            quarter: cut(&pi),
            values: (0..=PARTS / 4)
                .map(|j| if j == 0 { [[0; L]; 2] } else { [long(false, j), long(true, j)] })
                .collect(),
            series: [Series::new(0, L), Series::new(1, L)],
        }
    }

    /// sin or cos of πj/256 ± d within [`SHORT_ERROR`], from d known within 1.1.
    ///
    /// Errors: y = d² < 2^−14.6 is off by less than 2.1 and so is every power (what the last one passes on is
    /// nothing beside the product's 2). Hence each series is off by less than 4: powers weigh less than 0.6,
    /// cuts in units of 1/4! and below 0.2, the last division and the tail 1 each. sin d = d − d(1 − sin d/d)
    /// by 1.1·1.01 + 0.1 + 2 < 3.3; the product with the table's value by 3.3 + 0.1 + 2, that of 1 − cos d
    /// by 4 + 0.1 + 2, and the value itself is cut by less than 1.1: together less than 13.
    fn evaluate(&self, cosine: bool, j: usize, negative: bool, d: &[u64; L]) -> [u64; L] {
        let y = product(d, d);
        let mut powers = [y; BLOCK];
        for i in 1..BLOCK {
            powers[i] = product(&powers[i - 1], &y);
        }
        let [fall, shortfall] = self.series.each_ref().map(|series| series.sum(&powers));
        let sine = difference(d, &product(d, &shortfall));
        let [sin, cos] = &self.values[j];
        let (value, other) = if cosine { (cos, sin) } else { (sin, cos) };
        let kept = difference(value, &product(value, &fall));
        let turned = product(other, &sine);
        // The sine grows with the angle, the cosine falls.
        if cosine == negative { sum(&kept, &turned) } else { difference(&kept, &turned) }
    }

    /// sin or cos of an angle of a short fraction.
    fn turn(&self, cosine: bool, angle: &Short) -> [u64; L] {
        self.evaluate(cosine, angle.j, angle.negative, &self.turned(angle.p, angle.q))
    }

    /// sin or cos of πt, t ≤ ¼ on L + 1 limbs known within 2⁵⁰ of their last place; `None` for t < 1/512.
    ///
    /// 256 t is j ± rest. The 2⁵⁸ by which that, and the cut by which rest, may be off pass on less than
    /// 0.8·1.02/64 to d = (π/4) rest/64, the cut of π/4 half as much, and the product's 3/64 and the last cut
    /// together less than 1.05.
    fn at(&self, cosine: bool, t: &[u64]) -> Option<[u64; L]> {
        let j = ((t[L] >> 55) + 1) >> 1;
        if j == 0 {
            return None;
        }
        let negative = t[L] >> 55 & 1 == 1;
        let mut rest: [u64; L] = std::array::from_fn(|i| t[i + 1] << 8 | t[i] >> 56);
        if negative {
            // 1 − rest, with a unit less.
            rest = rest.map(|limb| !limb);
        }
        let d = product(&self.quarter, &rest);
        Some(self.evaluate(cosine, j as usize, negative, &shifted(&d)))
    }

    /// (π/4)(p/q)/64, cut, for p ≤ q/2: π/4 and the division are cut by less than 1 each, so that this is off
    /// by less than 1.03.
    fn turned(&self, p: u64, q: u64) -> [u64; L] {
        let mut value = [0u64; L];
        let mut top = 0;
        add_scaled(&mut value, &mut top, &self.quarter, p, false);
        divide(&mut value, top, &Divisor::new(q));
        shifted(&value)
    }
}

impl Series {
    /// As many terms as 64·`length` bits need for y < 2^−14.6, and two at the least.
    fn new(first: u64, length: usize) -> Series {
        let d = |i: u64| (2 * i + first - 1) * (2 * i + first);
        // y^i/(d₁⋯d_i) < 2^−w ends the alternating sum; here in hundredths of a bit, rounded down.
        let (mut last, mut reached) = (0u64, 0u64);
        while reached <= 6400 * length as u64 {
            last += 1;
            reached += 1460 + 100 * u64::from(d(last).ilog2());
        }
        let last = last.next_multiple_of(2);
        let mut terms = Vec::new();
        let mut scale = 1u64;
        for i in (1..=last).rev() {
            let full =
                i % 2 == 0 && scale.checked_mul(d(i)).and_then(|next| next.checked_mul(d(i - 1))).is_none();
            terms.push(Term { scale, divisor: full.then(|| Divisor::new(scale)) });
            scale = d(i) * if full { 1 } else { scale };
        }
        Series { terms, divisor: Divisor::new(scale) }
    }

    /// The sum, from y, …, y^[`BLOCK`].
    ///
    /// As in the long series, what is summed is Σ (−1)^i y^(i−k) c_i over i ≥ k, positive for even k, which k
    /// is wherever it is multiplied or divided; in between it wraps. That over i ≥ 1 is what is wanted, with
    /// its sign changed: y c₁ outweighs the rest, cuts included.
    fn sum<const L: usize>(&self, powers: &[[u64; L]; BLOCK]) -> [u64; L] {
        let (mut sum, mut top) = ([0u64; L], 0u64);
        for (term, i) in self.terms.iter().zip((1..=self.terms.len()).rev()) {
            match i % BLOCK {
                0 => {
                    let whole = top.wrapping_add(term.scale);
                    (sum, top) = (product(&sum, &powers[BLOCK - 1]), 0);
                    add_scaled(&mut sum, &mut top, &powers[BLOCK - 1], whole, false);
                }
                j => add_scaled(&mut sum, &mut top, &powers[j - 1], term.scale, i % 2 == 1),
            }
            if let Some(divisor) = &term.divisor {
                divide(&mut sum, top, divisor);
                top = 0;
            }
        }
        let mut carry = true;
        for limb in &mut sum {
            (*limb, carry) = (!*limb).overflowing_add(carry.into());
        }
        let top = (!top).wrapping_add(carry.into());
        divide(&mut sum, top, &self.divisor);
        sum
    }
}

impl Divisor {
    pub fn new(d: u64) -> Divisor {
        let shift = d.leading_zeros();
        let normal = d << shift;
        let reciprocal = ((u128::from(!normal) << 64) | u128::from(u64::MAX)) / u128::from(normal);
        Divisor { normal, shift, reciprocal: reciprocal as u64 }
    }

    /// p/d, p < d, as a fraction on limbs, cut.
    pub fn fraction(&self, p: u64, limbs: &mut [u64]) {
        let mut rest = p << self.shift;
        for limb in limbs.iter_mut().rev() {
            (*limb, rest) = self.step(rest, 0);
        }
    }

    /// Quotient and remainder of rest·2⁶⁴ + low by `normal`, for rest < normal (Möller and Granlund, Improved
    /// division by invariant integers, algorithm 4).
    #[inline(always)]
    fn step(&self, rest: u64, low: u64) -> (u64, u64) {
        let guess = u128::from(self.reciprocal) * u128::from(rest);
        let guess = guess.wrapping_add(u128::from(rest) << 64 | u128::from(low));
        let mut quotient = ((guess >> 64) as u64).wrapping_add(1);
        let mut rest = low.wrapping_sub(quotient.wrapping_mul(self.normal));
        if rest > guess as u64 {
            quotient = quotient.wrapping_sub(1);
            rest = rest.wrapping_add(self.normal);
        }
        if rest >= self.normal {
            quotient = quotient.wrapping_add(1);
            rest -= self.normal;
        }
        (quotient, rest)
    }
}

/// top·2^64L + value by the divisor, rounded down, for top below the divisor.
#[inline(always)]
fn divide<const L: usize>(value: &mut [u64; L], top: u64, divisor: &Divisor) {
    // Numerator and divisor both times 2^shift.
    let pair =
        |high: u64, low: u64| (((u128::from(high) << 64 | u128::from(low)) << divisor.shift) >> 64) as u64;
    let mut rest = pair(top, value[L - 1]);
    for i in (0..L).rev() {
        let low = pair(value[i], if i > 0 { value[i - 1] } else { 0 });
        (value[i], rest) = divisor.step(rest, low);
    }
}

/// ⌊ab⌋, or one or two less, as [`fixed::product`] for a known number of limbs.
#[inline(always)]
#[allow(clippy::needless_range_loop, reason = "loops of these bounds unroll, zipped ones do not")]
fn product<const L: usize>(a: &[u64; L], b: &[u64; L]) -> [u64; L] {
    // The two columns below the last place, and those above.
    let (mut below, mut columns) = ([0u64; 2], [0u64; L]);
    for i in 0..L {
        let mut carry = 0u64;
        for j in (L - 2).saturating_sub(i)..L {
            let at = i + j - (L - 2);
            let column = if at < 2 { &mut below[at] } else { &mut columns[at - 2] };
            let sum = u128::from(a[i]) * u128::from(b[j]) + u128::from(*column) + u128::from(carry);
            (*column, carry) = (sum as u64, (sum >> 64) as u64);
        }
        columns[i] = carry;
    }
    columns
}

/// top·2^64L + value ± a·c, modulo 2^64(L+1).
#[inline(always)]
fn add_scaled<const L: usize>(value: &mut [u64; L], top: &mut u64, a: &[u64; L], c: u64, subtract: bool) {
    let mut carry = 0u64;
    for (limb, &x) in value.iter_mut().zip(a) {
        let scaled = u128::from(x) * u128::from(c) + u128::from(carry);
        let (sum, wrapped) =
            if subtract { limb.overflowing_sub(scaled as u64) } else { limb.overflowing_add(scaled as u64) };
        *limb = sum;
        carry = (scaled >> 64) as u64 + u64::from(wrapped);
    }
    *top = if subtract { top.wrapping_sub(carry) } else { top.wrapping_add(carry) };
}

/// A 64th, cut.
fn shifted<const L: usize>(value: &[u64; L]) -> [u64; L] {
    std::array::from_fn(|i| value[i] >> 6 | if i + 1 < L { value[i + 1] << 58 } else { 0 })
}

/// a + b, which must be below 1.
fn sum<const L: usize>(a: &[u64; L], b: &[u64; L]) -> [u64; L] {
    let mut carry = false;
    std::array::from_fn(|i| {
        let (limb, first) = a[i].overflowing_add(b[i]);
        let (limb, second) = limb.overflowing_add(carry.into());
        carry = first || second;
        limb
    })
}

/// a − b, which must not be negative.
fn difference<const L: usize>(a: &[u64; L], b: &[u64; L]) -> [u64; L] {
    let mut borrow = false;
    std::array::from_fn(|i| {
        let (limb, first) = a[i].overflowing_sub(b[i]);
        let (limb, second) = limb.overflowing_sub(borrow.into());
        borrow = first || second;
        limb
    })
}

/// The lowest L limbs, which are all that are not 0.
fn cut<const L: usize>(limbs: &[u64]) -> [u64; L] {
    std::array::from_fn(|i| limbs[i])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    #[test]
    fn a_division_by_reciprocal_is_the_division() {
        let mut random = Random(1);
        let edges =
            [0, 1, 2, 1 << 31, 1 << 32, (1 << 63) - 1, 1 << 63, (1 << 63) + 1, u64::MAX - 1, u64::MAX];
        let mut words: Vec<u64> = edges.to_vec();
        words.extend((0..40).map(|i| random.next() >> (i % 60)));
        for &d in words.iter().filter(|&&d| d >= 2) {
            let divisor = Divisor::new(d);
            for &rest in &words {
                for &low in &words {
                    let normal = divisor.normal;
                    let (rest, n) = (rest % normal, u128::from(normal));
                    let whole = u128::from(rest) << 64 | u128::from(low);
                    let expected = ((whole / n) as u64, (whole % n) as u64);
                    assert_eq!(divisor.step(rest, low), expected, "{whole} / {normal}");
                    // Of several limbs, unnormalised: ⌊top·2¹²⁸ + low·2⁶⁴ + rest⌋ / d by two short divisions.
                    let (top, u) = (rest % d, u128::from(d));
                    let high = u128::from(top) << 64 | u128::from(low);
                    let second = (high % u) << 64 | u128::from(rest);
                    let mut value = [rest, low];
                    divide(&mut value, top, &divisor);
                    assert_eq!(value, [(second / u) as u64, (high / u) as u64], "{top} {low} {rest} / {d}");
                }
            }
        }
    }

    /// Against the long series with a limb more, at random and at the ends of the table's parts.
    fn within_the_error<const L: usize>(table: &Table<L>) {
        let precision = Precision::new(64 * L as u32);
        let mut random = Random(L as u64);
        let mut worst = 0u64;
        for case in 0..4000u64 {
            let q = (random.next() >> (1 + case % 50)).max(4);
            let p = match case % 4 {
                0 => q / 4,
                1 => (u128::from(q) * u128::from(2 * (random.next() % 64) + 1) / 512) as u64,
                2 => (u128::from(q) * u128::from(random.next() % 65) / 256) as u64,
                _ => random.next() % (q / 4 + 1),
            };
            for cosine in [false, true] {
                let Some(short) = short_sine(cosine, p, q, L) else {
                    assert!(p < q / 512 + 1);
                    continue;
                };
                let long = ball_sine::series_kernel(cosine, &angle::Fraction::Small(p, q), &precision, L + 1);
                let long = long.0.magnitude() >> (-long.1 - 64 * L as i128);
                let error = num_bigint::BigInt::from(fixed::integer(&short)) - num_bigint::BigInt::from(long);
                // What was cut from the long one is below 1.
                let error = error.magnitude().iter_u64_digits().next().unwrap_or(0);
                assert!(error < SHORT_ERROR, "{p}/{q}, cosine: {cosine}: {error}");
                worst = worst.max(error);
            }
        }
        assert!(table.values.len() == 65 && worst >= 1, "{worst}");
    }

    #[test]
    fn short_sines_stay_within_their_error() {
        within_the_error(&THREE);
        within_the_error(&FIVE);
        within_the_error(&NINE);
    }
}
