//! What continuation asks of periodic orbits, whatever it is that moves: oscillators of one degree of freedom
//! (`one_degree`) and machines.
//!
//! A [`PatternFamily`] has the equations of a pattern with all derivatives over one parameter, a
//! [`PatternPlane`] the functions whose zeros are bifurcations over two; a [`FollowedOrbit`] is what is known
//! of a solution. Not here: how a curve is followed (`curve`, `follow`).

use super::{Bifurcation, Degeneracy, Itinerary};
use crate::{
    continuation::{Linearised, Root},
    error::Result,
    motion::event::Place,
    rounding::SUM,
};

/// A solution of the equations of a pattern.
pub trait FollowedOrbit: Clone {
    /// What its impacts are at: sides or stops.
    type Place: Place;

    /// Its pattern.
    fn pattern(&self) -> &Itinerary<Self::Place>;

    /// The unknowns, in units of their own ([`unit`](Self::unit)).
    fn unknowns(&self) -> Vec<f64>;

    /// The same with other unknowns, all else as it was: what follows from the unknowns alone may be asked of
    /// it.
    #[must_use]
    fn moved(&self, unknowns: &[f64]) -> Self;

    /// Whether an unknown is an impact time, in radians: whole periods make no difference.
    fn is_time(&self, unknown: usize) -> bool;

    /// What an unknown of 1 is: lengths and speeds may have a unit of their own.
    fn unit(&self, _unknown: usize) -> f64 {
        1.0
    }

    /// What a gap of 1 is.
    fn length_unit(&self) -> f64 {
        1.0
    }

    /// The incoming speeds of its impacts, positive if they come in.
    fn speeds(&self) -> Vec<f64>;

    /// The least minimum of a gap away from the impacts, in the unit of lengths; `None` if there is none.
    fn least_gap(&self) -> Option<f64>;

    /// Whether it is an orbit.
    fn is_orbit(&self) -> bool;

    /// What is left of its equations.
    fn residual(&self) -> f64;

    /// Newton steps that it took.
    fn newton_steps(&self) -> usize;

    /// The multipliers, real and imaginary parts, the largest modulus first.
    fn multipliers(&self) -> Vec<(f64, f64)>;

    /// Whether all multipliers are inside the unit circle.
    fn is_stable(&self) -> bool;

    /// Whether, where there is dry friction, both slide and stick in the same order, and both touch stops
    /// that give way as often.
    fn slides_as(&self, _other: &Self) -> bool {
        true
    }

    /// Whether both slide and stick in the same way where they begin: where that changes their unknowns have
    /// a corner, and nothing else does.
    fn begins_as(&self, _other: &Self) -> bool {
        true
    }

    /// What it is called where they do not slide in the same order, and nothing else is between them.
    fn changed(&self, _other: &Self) -> Bifurcation {
        Bifurcation::FrictionChange
    }

    /// Π (1 − λ), zero where a multiplier is 1.
    fn fold(&self) -> f64;

    /// Π (1 + λ), zero where a multiplier is −1.
    fn flip(&self) -> f64;

    /// One function for each two multipliers: where two complex ones pass the unit circle exactly one of
    /// these changes sign. They are |λ_2| − 1, |λ_4| − 1, …, the moduli in descending order: continuous,
    /// whichever multipliers meet and become real or complex on the way; a single real multiplier that passes
    /// 1 or −1 may change the sign of one, too. 0 where rounding decides: motions without any loss have that
    /// everywhere.
    fn circles(&self) -> Vec<f64> {
        let moduli: Vec<f64> = self.multipliers().iter().map(|(re, im)| re.hypot(*im)).collect();
        let rounding = SUM * moduli.first().map_or(1.0, |most| most.max(1.0));
        let beyond = |modulus: &f64| if (modulus - 1.0).abs() <= rounding { 0.0 } else { modulus - 1.0 };
        moduli.iter().skip(1).step_by(2).map(beyond).collect()
    }

    /// Whether the two multipliers whose product is nearest to 1 are complex, or equal to rounding: beyond a
    /// double multiplier λ and 1/λ are real, a saddle that keeps areas and no bifurcation.
    fn rotates(&self) -> bool;

    /// Whether it is at a bifurcation: its multipliers are the bifurcation's, and no speed is zero where
    /// multipliers are asked for.
    fn is_at(&self, bifurcation: Bifurcation) -> bool;
}

/// Slower than this, in units of the motion, an impact's speed is rounding's.
pub(crate) const STILL: f64 = 1e-10;

/// The pattern of the orbits of a family.
pub type PatternOf<O> = Itinerary<<O as FollowedOrbit>::Place>;

/// Orbits of any pattern over one parameter.
pub trait PatternFamily {
    /// A solution.
    type Orbit: FollowedOrbit;

    /// How many unknowns a pattern has.
    fn count(&self, pattern: &PatternOf<Self::Orbit>) -> usize;

    /// The equations of a pattern with their derivatives in the unknowns and in the parameter.
    ///
    /// # Errors
    /// An input error where they are not defined.
    fn equations(&self, parameter: f64, pattern: &PatternOf<Self::Orbit>, z: &[f64]) -> Result<Linearised>;

    /// What there is to know of a root.
    ///
    /// # Errors
    /// As [`equations`](Self::equations).
    fn orbit(&self, parameter: f64, pattern: &PatternOf<Self::Orbit>, root: Root) -> Result<Self::Orbit>;

    /// The unknowns of an orbit gone round twice, or what a change of them becomes.
    fn twice(&self, pattern: &PatternOf<Self::Orbit>, z: &[f64]) -> Vec<f64>;

    /// The pattern and the unknowns of an orbit gone round once, if these are those of one gone round twice;
    /// of any other, of its first half, which then is no solution. `None` if the pattern is not twice
    /// another.
    fn once(&self, pattern: &PatternOf<Self::Orbit>, z: &[f64])
    -> Option<(PatternOf<Self::Orbit>, Vec<f64>)>;

    /// Whether an unknown is an impact time, as [`FollowedOrbit::is_time`].
    fn is_time(&self, pattern: &PatternOf<Self::Orbit>, unknown: usize) -> bool;

    /// What an unknown of 1 is, as [`FollowedOrbit::unit`].
    fn unit(&self, _pattern: &PatternOf<Self::Orbit>, _unknown: usize) -> f64 {
        1.0
    }
}

/// Orbits of any pattern over two parameters.
pub trait PatternPlane {
    /// A solution.
    type Orbit: FollowedOrbit;

    /// How many unknowns a pattern has.
    fn count(&self, pattern: &PatternOf<Self::Orbit>) -> usize;

    /// Whether an unknown is an impact time, as [`FollowedOrbit::is_time`].
    fn is_time(&self, pattern: &PatternOf<Self::Orbit>, unknown: usize) -> bool;

    /// What an unknown of 1 is, as [`FollowedOrbit::unit`].
    fn unit(&self, _pattern: &PatternOf<Self::Orbit>, _unknown: usize) -> f64 {
        1.0
    }

    /// The equations of a pattern and, last, the function that is zero at a bifurcation, if one is asked for:
    /// smooth near its zeros. Where branches cross the equations may be replaced by others that are regular
    /// there.
    ///
    /// # Errors
    /// An input error where they are not defined.
    fn values(
        &self,
        event: Option<Bifurcation>,
        parameters: [f64; 2],
        pattern: &PatternOf<Self::Orbit>,
        z: &[f64],
    ) -> Result<Vec<f64>>;

    /// What there is to know of a root of the pattern's equations; of what is no root, its residual NaN, all
    /// but whether it is an orbit.
    ///
    /// # Errors
    /// As [`values`](Self::values).
    fn orbit(
        &self,
        parameters: [f64; 2],
        pattern: &PatternOf<Self::Orbit>,
        root: Root,
    ) -> Result<Self::Orbit>;

    /// The functions whose zeros on a curve of bifurcations are of codimension two, in the order of
    /// `Degeneracy::ALL`; `None` where they are not defined or another curve's.
    /// `tangent` is that of the curve: of the unknowns, then of both parameters. The coefficients of the
    /// Poincaré map's expansion are taken times `factors`, where there are any, to tell what their rounding
    /// does.
    fn degeneracies(
        &self,
        event: Bifurcation,
        parameters: [f64; 2],
        tangent: &[f64],
        orbit: &Self::Orbit,
        factors: &[f64],
    ) -> Vec<Option<f64>>;

    /// Whether an orbit at a zero of such a function is what its name says.
    fn is_genuine(&self, _event: Bifurcation, _degeneracy: Degeneracy, _orbit: &Self::Orbit) -> bool {
        true
    }

    /// Whether, between two neighbouring points of a curve of bifurcations, one of these may have had two
    /// zeros.
    fn leaps(&self, _event: Bifurcation, _before: &Self::Orbit, _after: &Self::Orbit) -> bool {
        false
    }
}

/// The functions whose zeros are events, in their order ([`Bifurcation::of`] says which is which); `turn` is
/// the tangent's parameter component, if there is one parameter. Multipliers grow like 1/V at an impact of
/// small speed V: the product of the speeds takes the poles away. Π (1 − λ) vanishes with `turn` at a
/// saddle-node, and alone where branches cross.
pub(super) fn monitors(orbit: &impl FollowedOrbit, turn: Option<f64>) -> Vec<Option<f64>> {
    let finite = |x: f64| Some(x).filter(|x| x.is_finite());
    let speeds = orbit.speeds();
    let scale: f64 = speeds.iter().product();
    let incoming = speeds.iter().all(|speed| *speed > 0.0);
    let mut all = vec![
        turn.or_else(|| finite(orbit.fold() * scale)),
        turn.and_then(|turn| finite(orbit.fold() * scale / turn)),
        finite(orbit.flip() * scale),
        None,
        orbit.least_gap().filter(|_| incoming),
    ];
    all.extend(speeds.into_iter().map(Some));
    let mut circles = orbit.circles().into_iter().map(finite);
    all[Bifurcation::Torus as usize] = circles.next().flatten();
    all.extend(circles);
    all
}
