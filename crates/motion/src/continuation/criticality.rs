//! Which way a bifurcation on a branch goes: the coefficient of its normal form, by derivatives of the
//! Poincaré map.

use crate::{continuation::Criticality, rounding::SUM};

/// The normal form of a bifurcation: see [`Derivatives`](super::Derivatives) for what the coefficient is.
///
/// With linear damping Re d = 0 at every Neimark–Sacker point. Between impacts the area dq du then shrinks by
/// e^{−ct}, c the damping, whatever the stiffness and the forcing; an impact with restitution τ at a wall
/// multiplies V dt dV by τ². Hence the Poincaré map, its time counted from one passage of the orbit to the
/// next, multiplies the form e^{ct} V dt dV by the orbit's own determinant Π τ² e^{−cT}. Where that is 1,
/// which only damping and restitution can bring about, the map keeps an area, and its normal form is a
/// rotation to every order: no closed curve is born, motions wind in or out at all amplitudes alike. With any
/// other damping, written as a formula, areas shrink along one motion and not along its neighbour, and Re d
/// is a number like the others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalForm {
    /// a (saddle-node), c (crossing with a = 0: a pitchfork), a (any other crossing), b (flip), Re d
    /// (Neimark–Sacker).
    pub coefficient: f64,
    /// What it means.
    pub kind: Sense,
}

/// Which way a bifurcation goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sense {
    /// What is born is stable in the critical direction, or not.
    Born(Criticality),
    /// A saddle-node: both orbits exist above the parameter's value.
    Above,
    /// A saddle-node: both orbits exist below.
    Below,
    /// Two branches that go on on both sides and exchange their stability.
    Transcritical,
    /// The coefficient is zero as far as can be told: the bifurcation is of higher codimension.
    Degenerate,
}

/// Why a point of a branch has no normal form, in a few words.
pub type NoForm = &'static str;

/// A number that is computed from an orbit, and how far it may be off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// By how much more than this it is not off, as far as can be told.
    pub error: f64,
}

/// How well an orbit at a bifurcation is located: times in radians, other unknowns as parts of themselves.
const LOCATED: f64 = 1e-9;

/// By how much an unknown may be off.
fn located(z: f64, is_time: bool) -> f64 {
    LOCATED * if is_time { 1.0 } else { z.abs() }
}

/// How many coefficients the expansion has.
const COEFFICIENTS: usize = 20;

impl Estimate {
    /// A number computed from the unknowns of an orbit, with the error that comes from their own; no unit
    /// enters. Rounding on the way, which acts as smaller changes of the same unknowns do, is covered unless
    /// they are 0, as those of an orbit at rest. `None` if it cannot be computed. Cost: five times its own.
    pub fn of(
        z: &[f64],
        is_time: impl Fn(usize) -> bool,
        number: impl Fn(&[f64]) -> Option<f64>,
    ) -> Option<Estimate> {
        Estimate::within(z, |i| located(z[i], is_time(i)), number)
    }

    /// The same of a number computed from the unknowns and from the expansion of the Poincaré map, each of
    /// whose coefficients is taken times a factor: it is known to rounding, too. Unknowns of an orbit at rest
    /// are 0 and exact: there only that is left.
    pub fn of_map(
        z: &[f64],
        is_time: impl Fn(usize) -> bool,
        number: impl Fn(&[f64], &[f64]) -> Option<f64>,
    ) -> Option<Estimate> {
        let all: Vec<f64> = z.iter().copied().chain([1.0; COEFFICIENTS]).collect();
        let off = |i: usize| z.get(i).map_or(SUM, |z| located(*z, is_time(i)));
        Estimate::within(&all, off, |all| {
            let (z, factors) = all.split_at(z.len());
            number(z, factors)
        })
    }

    /// A number computed from others, of which the i-th may be off by `off(i)`: they are moved by that in
    /// four ways, and the number's largest change counts twice. `None` if it cannot be computed. Cost: five
    /// times its own.
    fn within(
        z: &[f64],
        off: impl Fn(usize) -> f64,
        number: impl Fn(&[f64]) -> Option<f64>,
    ) -> Option<Estimate> {
        let value = number(z)?;
        let moved = |way: usize| {
            let by = |(i, z): (usize, &f64)| {
                // Signs that no symmetry of the orbit shares.
                let sign = if (i * (2 * way + 3) + (i * i + way) / 3).is_multiple_of(2) { 1.0 } else { -1.0 };
                z + sign * off(i)
            };
            let there: Vec<f64> = z.iter().enumerate().map(by).collect();
            Some((number(&there)? - value).abs())
        };
        let most = (0..4).map(moved).try_fold(0.0, |most: f64, apart| Some(most.max(apart?)))?;
        most.is_finite().then_some(Estimate { value, error: 2.0 * most })
    }

    /// Whether it may be zero.
    pub fn is_zero(&self) -> bool {
        self.value.abs() <= self.error
    }

    /// What is born at a bifurcation with this coefficient, `stable` saying for which sign that is stable.
    pub fn born(self, stable: impl Fn(f64) -> bool) -> NormalForm {
        let criticality =
            if stable(self.value) { Criticality::Supercritical } else { Criticality::Subcritical };
        let kind = if self.is_zero() { Sense::Degenerate } else { Sense::Born(criticality) };
        NormalForm { coefficient: self.value, kind }
    }

    /// A saddle-node ξ ↦ ξ + d (µ − µ_sn) + a ξ², this being a: fixed points where both terms can cancel.
    /// `turn` is da, which no unit and no sign of ξ changes.
    pub fn fold(self, turn: Estimate) -> NormalForm {
        let kind = match () {
            () if self.is_zero() || turn.is_zero() => Sense::Degenerate,
            () if turn.value < 0.0 => Sense::Above,
            () => Sense::Below,
        };
        NormalForm { coefficient: self.value, kind }
    }
}

/// A bifurcation at which the map is not smooth.
pub const NOT_SMOOTH: NoForm = "none: the map is not smooth here";
/// A bifurcation at which a multiplier is double.
pub const DOUBLE: NoForm = "none: a double multiplier";
/// A bifurcation at which the derivatives are not found.
pub const UNKNOWN: NoForm = "none: the derivatives of the map are not found";
/// A point of codimension two, or a curve's in two parameters.
pub const CODIMENSION_TWO: NoForm = "none: of codimension two";

impl NormalForm {
    /// Its word.
    pub fn name(&self) -> &'static str {
        match self.kind {
            Sense::Born(criticality) => criticality.name(),
            Sense::Above => "above",
            Sense::Below => "below",
            Sense::Transcritical => "transcritical",
            Sense::Degenerate => "degenerate",
        }
    }
}
