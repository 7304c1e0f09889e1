//! The curve of orbits with one impact pattern, and the functions whose zeros are its events.

use super::{
    curve::{Curve, Equations, Foot},
    follow::Followed,
};
use crate::{
    error::Result,
    oscillator::orbit::{Family, Itinerary, Orbit, Root, describe, linearise},
};

/// The solutions of the pattern equations over a range of a parameter: the unknowns are those of the pattern and, last, the
/// parameter as a fraction of its range.
pub struct Orbits<'a> {
    /// The oscillators, with slopes.
    pub family: &'a dyn Family,
    /// The pattern.
    pub itinerary: Itinerary,
    /// The parameter's bounds.
    pub range: (f64, f64),
}

/// The events of a branch, numbered as its monitors are; an impact's speed is one of those from `Fade` on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Event {
    /// The branch turns back in the parameter; a multiplier is 1.
    SaddleNode,
    /// Another branch of the same pattern crosses; a multiplier is 1.
    Crossing,
    /// A multiplier is −1: the branch of the doubled pattern is born.
    Flip,
    /// Two complex multipliers have modulus 1.
    Torus,
    /// A minimum of the gap is zero: a new impact with zero velocity.
    Grazing,
    /// An impact's velocity is zero: the branch ends as an orbit of this pattern.
    Fade,
}

impl Event {
    /// Its name in tables and labels.
    pub fn name(self) -> &'static str {
        match self {
            Event::SaddleNode => "saddle-node",
            Event::Crossing => "crossing",
            Event::Flip => "flip",
            Event::Torus => "torus",
            Event::Grazing => "grazing",
            Event::Fade => "fade",
        }
    }

    /// All, in the order of the monitors.
    pub const ALL: [Event; 6] =
        [Event::SaddleNode, Event::Crossing, Event::Flip, Event::Torus, Event::Grazing, Event::Fade];

    /// The event of a monitor's number.
    pub(super) fn of(monitor: usize) -> Event {
        Event::ALL[monitor.min(Event::Fade as usize)]
    }
}

impl Orbits<'_> {
    /// The parameter at a point.
    pub fn parameter(&self, u: &[f64]) -> f64 {
        self.range.0 + u[u.len() - 1] * (self.range.1 - self.range.0)
    }

    /// The unknowns of an orbit at a parameter value.
    pub fn unknowns(&self, z: &[f64], parameter: f64) -> Vec<f64> {
        let fraction = (parameter - self.range.0) / (self.range.1 - self.range.0);
        z.iter().copied().chain([fraction]).collect()
    }
}

impl Curve for Orbits<'_> {
    fn equations(&self, u: &[f64]) -> Result<Equations> {
        let oscillator = self.family.at(self.parameter(u))?;
        let mut found = linearise(&oscillator, &self.itinerary, &u[..u.len() - 1])?;
        for (row, slope) in found.jacobian.iter_mut().zip(&found.slope) {
            row.push(slope * (self.range.1 - self.range.0));
        }
        Ok(Equations { residual: found.residual, jacobian: found.jacobian })
    }
}

impl Followed for Orbits<'_> {
    type View = Orbit;

    fn view(&self, foot: &Foot) -> Result<Orbit> {
        let oscillator = self.family.at(self.parameter(&foot.u))?;
        let z = foot.u[..foot.u.len() - 1].to_vec();
        describe(
            &oscillator,
            &self.itinerary,
            Root { z, residual: foot.residual, steps: foot.steps as usize },
        )
    }

    fn monitors(&self, foot: &Foot, orbit: &Orbit) -> Vec<Option<f64>> {
        monitors(orbit, foot.tangent.last().copied())
    }

    fn holds(&self, orbit: &Orbit) -> bool {
        orbit.admissibility.is_admissible()
    }

    fn bounds(&self) -> Vec<(usize, f64, f64)> {
        vec![((2 * self.itinerary.strikes().len()).max(2), 0.0, 1.0)]
    }
}

/// The functions whose zeros are events, in their order, the speeds last; `turn` is the tangent's parameter component, if there is
/// one parameter. Multipliers grow like 1/V at an impact of small speed V: the product of the speeds takes the poles away.
/// (1−λ₁)(1−λ₂) vanishes with `turn` at a saddle-node, and alone where branches cross.
pub(super) fn monitors(orbit: &Orbit, turn: Option<f64>) -> Vec<Option<f64>> {
    let finite = |x: f64| Some(x).filter(|x| x.is_finite());
    let speeds = || orbit.impacts().map(|impact| impact.speed);
    let scale: f64 = speeds().product();
    let multipliers = &orbit.multipliers;
    let complex = multipliers.trace.abs() < 1.0 + multipliers.determinant;
    let incoming = speeds().all(|speed| speed > 0.0);
    let mut all = vec![
        turn.or_else(|| finite(multipliers.fold() * scale)),
        turn.and_then(|turn| finite(multipliers.fold() * scale / turn)),
        finite(multipliers.flip() * scale),
        complex.then_some(multipliers.determinant - 1.0),
        orbit.least.filter(|_| incoming).map(|least| least.gap),
    ];
    all.extend(speeds().map(Some));
    all
}
