//! What is to be done for some of the motions, packed: no gaps between them, whichever they are.

use fearless_simd::{Simd, prelude::*, u64x8};

use super::vector::{LANES, Mask, V};

/// A list of motions, N numbers for each.
pub(super) struct Queue<const N: usize> {
    pub len: usize,
    lanes: Vec<u64>,
    numbers: [Vec<f64>; N],
}

impl<const N: usize> Default for Queue<N> {
    /// No room for any.
    fn default() -> Self {
        Queue { len: 0, lanes: Vec::new(), numbers: std::array::from_fn(|_| Vec::new()) }
    }
}

impl<const N: usize> Queue<N> {
    /// Room for that many motions.
    pub fn new(most: usize) -> Self {
        let room = most + LANES;
        Queue { len: 0, lanes: vec![0; room], numbers: std::array::from_fn(|_| vec![0.0; room]) }
    }

    /// Adds the motions of a mask, of these eight.
    #[inline(always)]
    pub fn push<S: Simd>(&mut self, mask: Mask<S>, lanes: u64x8<S>, numbers: [V<S>; N]) {
        let at = self.len..self.len + LANES;
        lanes.compress(mask).store_slice(&mut self.lanes[at.clone()]);
        for (row, number) in self.numbers.iter_mut().zip(numbers) {
            number.compress(mask).store_slice(&mut row[at.clone()]);
        }
        self.len += mask.to_bitmask().count_ones() as usize;
    }

    /// Adds one.
    pub fn push_one(&mut self, lane: usize, numbers: [f64; N]) {
        self.lanes[self.len] = lane as u64;
        for (row, number) in self.numbers.iter_mut().zip(numbers) {
            row[self.len] = number;
        }
        self.len += 1;
    }

    /// Which motions the eight from `at` on are.
    #[inline(always)]
    pub fn lanes<S: Simd>(&self, s: S, at: usize) -> u64x8<S> {
        u64x8::from_slice(s, &self.lanes[at..at + LANES])
    }

    /// One of their numbers.
    #[inline(always)]
    pub fn numbers<S: Simd>(&self, s: S, at: usize) -> [V<S>; N] {
        let mut out = [V::splat(s, 0.0); N];
        for (out, row) in out.iter_mut().zip(&self.numbers) {
            *out = V::from_slice(s, &row[at..at + LANES]);
        }
        out
    }
}
