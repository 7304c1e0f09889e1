//! A small generator of repeatable random choices: SplitMix64, seeded per unit of work.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

/// The generator. Its stream depends on the seed and the unit alone, whatever thread runs it.
#[derive(Debug, Clone)]
pub(super) struct Random(u64);

impl Random {
    pub fn new(seed: u64, unit: u64) -> Self {
        let mut random = Random(seed);
        let mixed = random.next() ^ unit.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        Random(mixed)
    }

    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A whole number in `low..=high`; the bias of the remainder does not matter here.
    pub fn within(&mut self, low: u64, high: u64) -> u64 {
        low + self.next() % (high - low + 1)
    }

    /// True with probability 1/2.
    pub fn coin(&mut self) -> bool {
        self.next() >> 63 == 1
    }

    /// A fraction in (0, 1): with a small denominator, or dyadic with 53 bits.
    pub fn fraction(&mut self) -> BigRational {
        if self.coin() {
            let q = self.within(2, 200);
            let p = self.within(1, q - 1);
            BigRational::new(p.into(), q.into())
        } else {
            BigRational::new((self.next() >> 11 | 1).into(), (1u64 << 53).into())
        }
    }

    /// 2^−e for a random e in `low..=high`, times 1 or a fraction in (0, 1).
    pub fn tiny(&mut self, low: u64, high: u64) -> BigRational {
        let power = BigRational::new(BigInt::one(), BigInt::one() << self.within(low, high));
        if self.coin() { power } else { power * self.fraction() }
    }
}
