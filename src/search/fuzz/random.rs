//! Random fractions of the sizes that fuzzing wants.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use crate::random::Random;

impl Random {
    /// A fraction in (0, 1): with a small denominator, or dyadic with 53 bits.
    pub(super) fn fraction(&mut self) -> BigRational {
        if self.coin() {
            let q = self.within(2, 200);
            let p = self.within(1, q - 1);
            BigRational::new(p.into(), q.into())
        } else {
            BigRational::new((self.bits() >> 11 | 1).into(), (1u64 << 53).into())
        }
    }

    /// 2^−e for a random e in `low..=high`, times 1 or a fraction in (0, 1).
    pub(super) fn tiny(&mut self, low: u64, high: u64) -> BigRational {
        let power = BigRational::new(BigInt::one(), BigInt::one() << self.within(low, high));
        if self.coin() { power } else { power * self.fraction() }
    }
}
