//! Fixed-point numbers on 64-bit limbs: the few operations that sines spend their time in.
//!
//! A fraction is L limbs, least significant first, in units of 2^(−64L). Sizes are the caller's duty; nothing
//! allocates but results.

use num_bigint::{BigInt, BigUint, Sign};

/// ⌊a·b / 2^(64L)⌋ for L = b.len() ≥ 2, or one or two less: a.len() limbs.
///
/// Products of limbs below the last two columns are left out; together they are less than L·2^−64 of the last
/// place.
pub(super) fn product(a: &[u64], b: &[u64]) -> Vec<u64> {
    let skipped = b.len() - 2;
    let mut columns = vec![0u64; a.len() + 2];
    for (i, &x) in a.iter().enumerate() {
        let start = skipped.saturating_sub(i);
        let at = i + start - skipped;
        let mut carry = 0u64;
        for (column, &y) in columns[at..].iter_mut().zip(&b[start..]) {
            let sum = u128::from(x) * u128::from(y) + u128::from(*column) + u128::from(carry);
            *column = sum as u64;
            carry = (sum >> 64) as u64;
        }
        columns[i + 2] = carry;
    }
    columns.drain(..2);
    columns
}

/// total ± a·c modulo 2^(64·total.len()), for a of one limb less.
pub(super) fn add_scaled(total: &mut [u64], a: &[u64], c: u64, subtract: bool) {
    let mut carry = 0u64;
    let (last, rest) = total.split_last_mut().expect("a number has limbs");
    for (limb, &x) in rest.iter_mut().zip(a) {
        let scaled = u128::from(x) * u128::from(c) + u128::from(carry);
        let (value, wrapped) =
            if subtract { limb.overflowing_sub(scaled as u64) } else { limb.overflowing_add(scaled as u64) };
        *limb = value;
        carry = (scaled >> 64) as u64 + u64::from(wrapped);
    }
    *last = if subtract { last.wrapping_sub(carry) } else { last.wrapping_add(carry) };
}

/// Divides by d in place, rounding down.
pub(super) fn divide(total: &mut [u64], d: u64) {
    let mut rest = 0u64;
    for limb in total.iter_mut().rev() {
        let value = (u128::from(rest) << 64) | u128::from(*limb);
        *limb = (value / u128::from(d)) as u64;
        rest = (value % u128::from(d)) as u64;
    }
}

/// The limbs of x, at least `length` of them.
pub(super) fn limbs(x: &BigUint, length: usize) -> Vec<u64> {
    let mut limbs: Vec<u64> = x.iter_u64_digits().collect();
    limbs.resize(length.max(limbs.len()), 0);
    limbs
}

/// The integer of these limbs.
pub(super) fn integer(limbs: &[u64]) -> BigUint {
    BigUint::new(limbs.iter().flat_map(|&limb| [limb as u32, (limb >> 32) as u32]).collect())
}

/// A fixed-point number of L fraction limbs and one whole limb, with a sign.
#[derive(Clone)]
pub(super) struct Signed {
    pub negative: bool,
    pub limbs: Vec<u64>,
}

impl Signed {
    /// In units of the last place.
    pub fn integer(&self) -> BigInt {
        BigInt::from_biguint(if self.negative { Sign::Minus } else { Sign::Plus }, integer(&self.limbs))
    }

    /// self·b − previous, for 0 ≤ b < 4 given as b/4, L = quarter.len(): off by less than 9.
    pub fn step(&self, quarter: &[u64], negative: bool, previous: &Signed) -> Signed {
        let mut limbs = product(&self.limbs, quarter);
        let mut carry = 0;
        for limb in &mut limbs {
            (*limb, carry) = ((*limb << 2) | carry, *limb >> 62);
        }
        let negative = self.negative != negative;
        if negative != previous.negative {
            accumulate(&mut limbs, &previous.limbs, false);
            return Signed { negative, limbs };
        }
        if limbs.iter().rev().lt(previous.limbs.iter().rev()) {
            let mut rest = previous.limbs.clone();
            accumulate(&mut rest, &limbs, true);
            return Signed { negative: !negative, limbs: rest };
        }
        accumulate(&mut limbs, &previous.limbs, true);
        Signed { negative, limbs }
    }
}

/// total ± other, which must not pass zero or the top limb.
fn accumulate(total: &mut [u64], other: &[u64], subtract: bool) {
    let mut carry = false;
    for (limb, &x) in total.iter_mut().zip(other) {
        let (value, first) = if subtract { limb.overflowing_sub(x) } else { limb.overflowing_add(x) };
        let (value, second) =
            if subtract { value.overflowing_sub(carry.into()) } else { value.overflowing_add(carry.into()) };
        (*limb, carry) = (value, first || second);
    }
}
