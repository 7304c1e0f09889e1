//! Where the points of sweeps lie: everywhere, near r = 1, near fractions of small denominator, and near the
//! lowest points of areas.

use std::sync::LazyLock;

use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::{
    existence::{Boundary, Lowest, intervals},
    random::Random,
};

/// Where the points of an angle lie.
#[derive(Debug, Clone, Copy)]
pub(super) enum Family {
    Uniform,
    NearOne,
    /// About the lowest point of an area, r times 2⁵³.
    Tip(u64),
}

/// An angle, in units of 2⁻⁵⁴.
pub(super) fn angle(random: &mut Random) -> (Family, u64) {
    let odd = |s: u64| s.clamp(1, (1 << 53) - 1) | 1;
    let near = |random: &mut Random, s: u64| {
        let shift = random.bits() >> random.within(24, 56);
        odd(if random.coin() { s.saturating_add(shift) } else { s.saturating_sub(shift) })
    };
    match random.within(0, 7) {
        0..=3 => (Family::Uniform, random.bits() >> 11 | 1),
        4 => (Family::NearOne, random.bits() >> 11 | 1),
        5 | 6 => {
            // Near a fraction p/q < ½, or a multiple of 1/(2q).
            let q = random.within(3, 60);
            let p = random.within(1, (q - 1) / 2);
            let place = (u128::from(p) << 54) / u128::from(q);
            let family = if random.coin() { Family::NearOne } else { Family::Uniform };
            (family, near(random, place as u64))
        }
        _ => {
            let (r, s) = TIPS[random.below(TIPS.len() as u64) as usize];
            (Family::Tip(r), near(random, s))
        }
    }
}

/// A modulus, in units of 2⁻⁵³.
pub(super) fn modulus(random: &mut Random, family: Family) -> u64 {
    let one = 1u64 << 53;
    let r = match family {
        Family::Uniform => random.bits() >> 11,
        Family::NearOne => one - (random.bits() >> random.within(12, 50)),
        Family::Tip(r) => {
            let shift = random.bits() >> random.within(18, 50);
            if random.coin() { r.saturating_add(shift) } else { r.saturating_sub(shift) }
        }
    };
    r.clamp(1, one - 1)
}

/// The lowest points of the areas of periods up to 16: r in units of 2⁻⁵³, s in units of 2⁻⁵⁴.
static TIPS: LazyLock<Vec<(u64, u64)>> = LazyLock::new(|| {
    let fixed = |x: &BigRational, bits: u32| (x * BigRational::from_integer((1u64 << bits).into())).to_u64();
    let areas = (4..=16).filter_map(|n| intervals(n).ok()).flatten();
    areas
        .filter(|interval| interval.deciding.is_some())
        .filter_map(|interval| match Boundary::new(interval).lowest(10)? {
            Lowest::Tip(tip) => Some((fixed(&tip.r.middle(), 53)?, fixed(&tip.s.middle(), 54)?)),
            _ => None,
        })
        .collect()
});
