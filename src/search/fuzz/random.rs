//! Random fractions of the sizes that fuzzing wants.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use crate::random::Random;

/// A fraction in (0, 1): with a small denominator, or dyadic with 53 bits.
pub(super) fn fraction(random: &mut Random) -> BigRational {
    if random.coin() {
        let q = random.within(2, 200);
        let p = random.within(1, q - 1);
        BigRational::new(p.into(), q.into())
    } else {
        BigRational::new((random.bits() >> 11 | 1).into(), (1u64 << 53).into())
    }
}

/// 2^−e for a random e in `low..=high`, times 1 or a fraction in (0, 1).
pub(super) fn tiny(random: &mut Random, low: u64, high: u64) -> BigRational {
    let power = BigRational::new(BigInt::one(), BigInt::one() << random.within(low, high));
    if random.coin() { power } else { power * fraction(random) }
}
