//! One case of the conjecture decided by its definition, by the record form and by the claim.
//!
//! The definition takes its signs from the ladder, as many as it takes to see two opposite ones; the record
//! form from enclosures of f_1, …, f_n, and from the definition where these overlap; the claim has
//! [`apart`](super::apart). A wrong sign on one side shows as a difference. Where the ladder does not confirm
//! a difference, the error is this program's.

use super::{Instance, apart, fuzz::quotients};
use crate::{
    existence::{Brief, Claim, Existence, Variant, claimed, claimed_with},
    local::{Answer, Ladder, Plane, Point, Quantity, Region, Rung},
};

/// Up to this period a point (a₁, a₂) is decided in reversed time too, and by the record form.
const REVERSED: u64 = 24;
const RECORDED: u64 = 64;

/// How one case compares.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Comparison {
    Agree(Rung),
    Boundary,
    Undecided,
    Differ,
    /// Two routes of this program to one answer differ.
    Fault(&'static str),
}

pub(super) fn compare(ladder: &Ladder, case: &Instance, variant: Variant) -> Comparison {
    let Instance { n, point } = case;
    let definition = Brief::new(ladder, point, *n);
    let (found, rung) = (definition.existence, definition.rung);
    let cases = found.cases(*n);
    let apart = |point: &Point, quantity: Quantity| match quantity {
        Quantity::B { n, k } => match apart::sign(ladder, point, n, k) {
            // An exact zero inside the circle is found by algebra alone.
            Answer::Undecided => ladder.sign(point, quantity).answer,
            answer => answer,
        },
        Quantity::C { .. } => ladder.sign(point, quantity).answer,
    };
    let claim = claimed_with(&apart, point, *n, variant);
    let comparison = against(&found, claim, case, rung);
    if comparison == Comparison::Differ {
        let confirmed = claimed(ladder, point, *n, variant);
        return if confirmed == claim {
            Comparison::Differ
        } else {
            Comparison::Fault("two routes to the sign that decides the claim differ")
        };
    }
    let quotients = match point {
        Point::Polar(polar) if *n <= RECORDED => quotients(polar, *n),
        _ => None,
    };
    if *n <= RECORDED
        && let Some(record) = definition.record(ladder, point, *n, quotients.as_deref())
    {
        let decided = record != Existence::Undecided && found != Existence::Undecided;
        if decided && record.cases(*n) != cases {
            return Comparison::Fault("the definition and the record form differ");
        }
        let by_record = against(&record, claim, case, rung);
        if by_record == Comparison::Differ && comparison != Comparison::Undecided {
            return Comparison::Fault("the record form and the claim differ");
        }
    }
    // The same orbits exist in reversed time, where a₁ and a₂ are a₁/a₂ and 1/a₂.
    if let Point::Plane(plane) = point
        && *n <= REVERSED
        && matches!(comparison, Comparison::Agree(_) | Comparison::Undecided)
        && let Ok(reversed) = Plane::new(plane.a1() / plane.a2(), plane.a2().recip())
    {
        let other = Brief::new(ladder, &Point::Plane(reversed), *n).existence;
        if other != Existence::Undecided && other.cases(*n) != cases {
            return Comparison::Differ;
        }
    }
    comparison
}

fn against(found: &Existence, claim: Claim, case: &Instance, rung: Rung) -> Comparison {
    let claim = match claim {
        Claim::Orbit(orbit) => Existence::Orbit(orbit).cases(case.n),
        Claim::None => Vec::new(),
        Claim::Undecided => return Comparison::Undecided,
        // On a boundary nothing is claimed, but an orbit there would lie in no area. For odd n the line a₁ =
        // −(a₂ + 1), which belongs to no region, has them.
        Claim::Boundary if matches!(found, Existence::Orbit(_)) && !on_line(&case.point) => {
            return Comparison::Differ;
        }
        Claim::Boundary => return Comparison::Boundary,
    };
    match found {
        Existence::Undecided => Comparison::Undecided,
        Existence::Orbit(_) | Existence::None { .. } if found.cases(case.n) == claim => {
            Comparison::Agree(rung)
        }
        _ => Comparison::Differ,
    }
}

fn on_line(point: &Point) -> bool {
    matches!(point, Point::Plane(plane) if plane.region() == Region::Line)
}

/// Whether the definition and a variant of the claim are both decided, and differently.
pub(super) fn differ(ladder: &Ladder, case: &Instance, variant: Variant) -> bool {
    compare(ladder, case, variant) == Comparison::Differ
}
