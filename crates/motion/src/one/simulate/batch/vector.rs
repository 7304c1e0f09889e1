//! Arithmetic on eight motions at a time, in the order of the scalar code, so that every result has its bits.

use fearless_simd::{Simd, f64x8, mask64x8, prelude::*};

use super::super::grid::{Polynomial, TERMS};
use crate::motion::minimum::ROUNDING;

/// How many motions a vector holds. Where registers are narrower it fills several.
pub(super) const LANES: usize = 8;

/// One number for each of eight motions.
pub(super) type Eight = [f64; LANES];

pub(super) type V<S> = f64x8<S>;
pub(super) type Mask<S> = mask64x8<S>;

#[inline(always)]
pub(super) fn load<S: Simd>(s: S, numbers: &Eight) -> V<S> {
    V::load_array_ref(s, numbers)
}

/// The eight that begin at `at`.
#[inline(always)]
pub(super) fn load_from<S: Simd>(s: S, numbers: &[f64], at: usize) -> V<S> {
    V::from_slice(s, &numbers[at..at + LANES])
}

#[inline(always)]
pub(super) fn splat<S: Simd>(s: S, number: f64) -> V<S> {
    V::splat(s, number)
}

/// The mask of the first `count` motions.
#[inline(always)]
pub(super) fn first<S: Simd>(s: S, count: usize) -> Mask<S> {
    Mask::from_bitmask(s, if count >= LANES { 0xff } else { (1 << count) - 1 })
}

/// The places of the bits that are set.
#[inline(always)]
pub(super) fn bits(mut mask: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let place = (mask != 0).then(|| mask.trailing_zeros() as usize)?;
        mask &= mask - 1;
        Some(place)
    })
}

/// Gaps of eight motions on one piece: a coefficient of all in each vector.
pub(super) struct Gaps<S: Simd>(pub(crate) [V<S>; TERMS]);

impl<S: Simd> Gaps<S> {
    /// What rounding may make of the gaps.
    #[inline(always)]
    pub fn rounding(&self, s: S) -> V<S> {
        let mut norm = self.0[0].abs();
        for c in &self.0[1..] {
            norm += c.abs();
        }
        splat(s, ROUNDING) * norm
    }

    /// Bounds |z‴|.
    #[inline(always)]
    pub fn third(&self, s: S) -> V<S> {
        let mut third = splat(s, 6.0) * self.0[3].abs();
        for i in 4..TERMS {
            third += splat(s, (i * (i - 1) * (i - 2)) as f64) * self.0[i].abs();
        }
        third
    }

    /// z, z′, z″ in the middle, as [`at`](Self::at) says them.
    #[inline(always)]
    pub fn middle(&self, s: S) -> [V<S>; 3] {
        [self.0[0], self.0[1], splat(s, 2.0) * self.0[2]]
    }

    /// z, z′ at −1 and at 1, as [`at`](Self::at) says them: there Horner's rule only adds.
    #[inline(always)]
    pub fn ends(&self, s: S) -> [[V<S>; 2]; 2] {
        let zero = splat(s, 0.0);
        let (mut p, mut first) = ([zero; 2], [zero; 2]);
        for k in (0..TERMS / 2).rev() {
            for i in 0..2 {
                first[i] += p[i];
                p[i] += self.0[2 * k + i];
            }
        }
        let ([e, o], [e1, o1]) = (p, first);
        let two = splat(s, 2.0);
        [[e - o, o + two * (o1 - e1)], [e + o, o + two * (e1 + o1)]]
    }

    /// z, z′, z″ at x, as [`Gap::at`](super::super::search::Gap::at).
    #[inline(always)]
    pub fn at(&self, s: S, x: V<S>) -> [V<S>; 3] {
        let square = x * x;
        let zero = splat(s, 0.0);
        let (mut p, mut first, mut half) = ([zero; 2], [zero; 2], [zero; 2]);
        for k in (0..TERMS / 2).rev() {
            for i in 0..2 {
                let c = self.0[2 * k + i];
                // The first rounds of Horner's rule multiply zeros.
                match TERMS / 2 - 1 - k {
                    0 => p[i] = c + zero,
                    1 => {
                        first[i] = p[i];
                        p[i] = p[i] * square + c;
                    }
                    2 => {
                        half[i] = first[i];
                        first[i] = first[i] * square + p[i];
                        p[i] = p[i] * square + c;
                    }
                    _ => {
                        half[i] = half[i] * square + first[i];
                        first[i] = first[i] * square + p[i];
                        p[i] = p[i] * square + c;
                    }
                }
            }
        }
        let ([e, o], [e1, o1], [e2, o2]) = (p, first, half);
        let eight = splat(s, 8.0);
        let bend = splat(s, 2.0) * e1 + eight * square * e2 + x * (splat(s, 6.0) * o1 + eight * square * o2);
        [e + x * o, o + splat(s, 2.0) * (x * e1 + square * o1), bend]
    }
}

/// Eight polynomials, a coefficient of all in each vector.
#[inline(always)]
pub(super) fn turned<S: Simd>(s: S, rows: [&Polynomial; LANES]) -> [V<S>; TERMS] {
    let mut out = [splat(s, 0.0); TERMS];
    for half in 0..TERMS / LANES {
        let mut block = [splat(s, 0.0); LANES];
        for (row, out) in rows.iter().zip(&mut block) {
            *out = load_from(s, &row[..], half * LANES);
        }
        // Three perfect shuffles of the rows.
        for _ in 0..3 {
            let mut next = block;
            for i in 0..LANES / 2 {
                (next[2 * i], next[2 * i + 1]) = block[i].interleave(block[i + LANES / 2]);
            }
            block = next;
        }
        out[half * LANES..(half + 1) * LANES].copy_from_slice(&block);
    }
    out
}
