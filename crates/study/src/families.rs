//! Named families of inputs, each a fixed list of points that stress one thing.

use num_bigint::BigInt;
use num_rational::BigRational;

use super::{ZeroFamily, zeros::NearZero};
use crate::{
    local::{Plane, Point, Polar, Quantity},
    random::Random,
};

/// b_{n,k} at a point.
#[derive(Debug, Clone)]
pub struct Input {
    /// Where.
    pub point: Point,
    /// The period.
    pub n: u64,
    /// The index.
    pub k: u64,
}

/// What a list of inputs has in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InputFamily {
    /// 5 ≤ n ≤ 100, ½ < r < 1.
    Generic,
    /// r = 1, s within 2⁻⁶⁰ of an odd multiple of 1/(2n).
    NearPole,
    /// r = 1, s within 2⁻⁶⁰ of a multiple of 1/k that is one of 1/(n − k) too.
    NearDoubleZero,
    /// (a₁, a₂) with a₁² = 4a₂ up to 2⁻⁶⁰.
    NearEqualEigenvalues,
    /// 1 − r = 2⁻⁶⁰, s within 2⁻⁶⁰ of m/n.
    RadiusToOne,
    /// r = 2⁻³⁰.
    RadiusToZero,
    /// n about 10⁹, 1 − r = 2⁻³⁰.
    HugePeriod,
    /// (a₁, a₂) with complex eigenvalues, a₁ within a relative 10⁻¹⁸ of a zero of u_n.
    NearComplexPole,
}

/// All families, in the order of the table.
pub const FAMILIES: [InputFamily; 8] = [
    InputFamily::Generic,
    InputFamily::NearPole,
    InputFamily::NearDoubleZero,
    InputFamily::NearEqualEigenvalues,
    InputFamily::RadiusToOne,
    InputFamily::RadiusToZero,
    InputFamily::HugePeriod,
    InputFamily::NearComplexPole,
];

impl InputFamily {
    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            InputFamily::Generic => "generic",
            InputFamily::NearPole => "near a pole",
            InputFamily::NearDoubleZero => "near a double zero",
            InputFamily::NearEqualEigenvalues => "near-equal eigenvalues",
            InputFamily::RadiusToOne => "r -> 1",
            InputFamily::RadiusToZero => "r -> 0",
            InputFamily::HugePeriod => "huge n",
            InputFamily::NearComplexPole => "near a complex pole",
        }
    }

    /// `count` inputs, none singular: the same list at every call, a shorter one the start of a longer one.
    /// Those near a complex pole take a few dozen values in balls of 4096 bits each.
    pub fn inputs(self, count: usize) -> Vec<Input> {
        if self == InputFamily::NearComplexPole {
            let places = ZeroFamily::ComplexPole.places(count, &()).unwrap_or_default();
            return places.iter().filter_map(|place| near(place.at(Some(18))?)).collect();
        }
        let mut random = Random(self as u64 + 1);
        std::iter::repeat_with(|| self.input(&mut random)).flatten().take(count).collect()
    }

    /// The next input; `None` if singular or outside 0 < s < ½.
    fn input(self, random: &mut Random) -> Option<Input> {
        let one = ratio(1, 1);
        let tiny = ratio(1, 1 << 60);
        let n = 5 + random.below(96);
        let k = 1 + random.below(n - 1);
        let s = ratio(1 + random.below(500_000), 1_000_003);
        let (r, s, n, k) = match self {
            InputFamily::Generic => (ratio(501 + random.below(499), 1000), s, n, k),
            InputFamily::NearPole => (one, ratio(2 * random.below(n / 2) + 1, 2 * n) + tiny, n, k),
            InputFamily::NearDoubleZero => {
                let (g, times) = (2 + random.below(9), 2 + random.below(9));
                (
                    one,
                    ratio(1 + random.below(g), 2 * g) + tiny,
                    2 * g * times,
                    2 * g * (1 + random.below(times - 1)),
                )
            }
            InputFamily::NearEqualEigenvalues => {
                let root = ratio(100 + random.below(900), 1000);
                let sign = if random.below(2) == 0 { one } else { -one };
                let a1 = &root * BigInt::from(2) * (sign + tiny);
                let plane = Plane::new(a1, &root * &root).ok().filter(|plane| !plane.is_singular(n))?;
                return Some(Input { point: Point::Plane(plane), n, k });
            }
            InputFamily::RadiusToOne => (one - &tiny, ratio(1 + random.below(n / 2), n) + tiny, n, k),
            InputFamily::RadiusToZero => (ratio(1, 1 << 30), s, n, k),
            InputFamily::HugePeriod => {
                let n = 1_000_000_000 - random.below(1000);
                (one - ratio(1, 1 << 30), s, n, 1 + random.below(n - 1))
            }
            InputFamily::NearComplexPole => return None,
        };
        let polar = Polar::new(r, s).ok().filter(|polar| !polar.is_singular(n))?;
        Some(Input { point: Point::Polar(polar), n, k })
    }
}

fn near(NearZero { point, quantity }: NearZero) -> Option<Input> {
    match quantity {
        Quantity::B { n, k } => Some(Input { point, n, k }),
        Quantity::C { .. } => None,
    }
}

fn ratio(p: u64, q: u64) -> BigRational {
    BigRational::new(p.into(), q.into())
}
