//! What the paper claims about existence at one point: Conjecture 1 in regions 3 and 4, appendix A elsewhere.
//!
//! The claim for n ≥ 3 in regions 3 and 4 needs the sign of one b_{n,k} at the most, the one whose zero
//! bounds the area. It is here to be compared with the definition in (`single`), of which it knows nothing.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::{BigRational, Ratio};
use num_traits::{One, ToPrimitive};

use super::{Case, fixed_point};
use crate::{
    farey,
    local::{Answer, Ladder, Plane, Point, Polar, Quantity, Region},
    number::Sign,
};

/// What is claimed of the single-impact orbits of one period at one point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Claim {
    /// There is one in this case and, for n = 1, in the one with both signs reversed.
    Orbit(Case),
    /// There is none.
    None,
    /// The point lies on a boundary of the areas: nothing is claimed.
    Boundary,
    /// The ladder's precision was not enough.
    Undecided,
}

/// A false statement to be refuted, so as to see that refutation works.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Variant {
    /// Conjecture 1 as it stands.
    True,
    /// With the two neighbours exchanged: b_{n,n₊} decides (+,+) and b_{n,n₋} decides (+,−).
    NeighboursExchanged,
    /// With the area of m = 0 ending at s = 1/(2n + 1) instead of 1/(2n).
    EndsShifted,
}

/// What is claimed for period n ≥ 1 at `point`, whose determinant must be at most 1. Cost: one sign, and for
/// (a₁, a₂) in region 3 the signs of u_1, …, u_n.
pub fn claimed(ladder: &Ladder, point: &Point, n: u64, variant: Variant) -> Claim {
    claimed_with(&|point, quantity| ladder.sign(point, quantity).answer, point, n, variant)
}

/// Where a claim takes its one sign from.
type Signs<'a> = &'a dyn Fn(&Point, Quantity) -> Answer;

/// [`claimed`], with the sign from elsewhere than the ladder.
pub(crate) fn claimed_with(signs: Signs, point: &Point, n: u64, variant: Variant) -> Claim {
    let region = match point {
        Point::Polar(_) => Region::Three,
        Point::Plane(plane) => plane.region(),
    };
    match region {
        Region::One => Claim::Orbit(Case::PlusPlus),
        Region::Two => Claim::Orbit(if n == 1 { Case::PlusMinus } else { Case::MinusPlus }),
        Region::Five => Claim::Orbit(Case::PlusMinus),
        Region::Line => Claim::Boundary,
        Region::Three | Region::Four if n == 1 => Claim::Orbit(Case::PlusMinus),
        Region::Three => match half_turns(point, n) {
            Some(half_turns) => in_region_3(signs, point, n, half_turns, variant),
            None => Claim::Boundary,
        },
        Region::Four if n == 2 => Claim::Orbit(Case::PlusPlus),
        Region::Four if n.is_multiple_of(2) => Claim::None,
        Region::Four => decided_by(signs, point, n, n - 2, Case::PlusMinus),
    }
}

/// The claim for n ≥ 2 where 2ns lies strictly between `half_turns` and the next integer.
fn in_region_3(signs: Signs, point: &Point, n: u64, half_turns: u64, variant: Variant) -> Claim {
    let m = half_turns.div_ceil(2);
    if m == 0 {
        return match (variant, point) {
            (Variant::EndsShifted, Point::Polar(polar))
                if polar.s() * BigInt::from(2 * n + 1) > BigRational::one() =>
            {
                Claim::None
            }
            _ => Claim::Orbit(Case::MinusPlus),
        };
    }
    if n == 2 {
        return Claim::Orbit(Case::PlusPlus);
    }
    if m.gcd(&n) > 1 {
        return Claim::None;
    }
    let Ok(pair) = farey::neighbours(&Ratio::new_raw(m, n)) else { return Claim::None };
    let (n_plus, n_minus) = match variant {
        Variant::NeighboursExchanged => (*pair.right.denom(), *pair.left.denom()),
        _ => (*pair.left.denom(), *pair.right.denom()),
    };
    // Left of m/n in s, where 2ns < 2m, the area is (+,+), right of it (+,−).
    if half_turns % 2 == 1 {
        decided_by(signs, point, n, n_minus, Case::PlusPlus)
    } else {
        decided_by(signs, point, n, n_plus, Case::PlusMinus)
    }
}

fn decided_by(signs: Signs, point: &Point, n: u64, k: u64, case: Case) -> Claim {
    match signs(point, Quantity::B { n, k }) {
        Answer::Sign(Sign::Positive) => Claim::Orbit(case),
        Answer::Sign(Sign::Negative) => Claim::None,
        Answer::Sign(Sign::Zero) | Answer::Singular => Claim::Boundary,
        Answer::Undecided => Claim::Undecided,
    }
}

/// ⌊2ns⌋ at a point of region 3; `None` if 2ns is an integer.
fn half_turns(point: &Point, n: u64) -> Option<u64> {
    match point {
        Point::Polar(polar) => polar_half_turns(polar, n),
        Point::Plane(plane) => plane_half_turns(plane, n),
    }
}

fn polar_half_turns(polar: &Polar, n: u64) -> Option<u64> {
    let (quotient, rest) = (polar.s().numer() * BigInt::from(2 * n)).div_rem(polar.s().denom());
    (rest != BigInt::ZERO).then_some(quotient.to_u64()?)
}

/// sin 2πks passes each multiple of π once as k grows, since 2s < 1: the sign changes of u_1, …, u_n count
/// them. Where 128 bits with a fixed point leave the sign of one open, they are counted in integers.
fn plane_half_turns(plane: &Plane, n: u64) -> Option<u64> {
    fixed_point::sign_changes(plane, n).or_else(|| half_turns_exactly(plane, n))
}

fn half_turns_exactly(plane: &Plane, n: u64) -> Option<u64> {
    let d = plane.a1().denom().lcm(plane.a2().denom());
    let a = (plane.a1() * &d).to_integer();
    let b = (plane.a2() * (&d * &d)).to_integer();
    let (mut before, mut w) = (BigInt::ZERO, BigInt::from(1));
    let (mut last, mut changes) = (Sign::Positive, 0);
    for _ in 1..n {
        let next = &a * &w - &b * &before;
        before = std::mem::replace(&mut w, next);
        let sign = Sign::from(&w);
        // A zero is followed by the opposite sign, and is counted there.
        changes += u64::from(sign == -last);
        last = if sign == Sign::Zero { last } else { sign };
    }
    (Sign::from(&w) != Sign::Zero).then_some(changes)
}
