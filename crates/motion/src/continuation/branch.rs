//! A branch: what was found along the curve of an impact pattern, both ways from a start, and what continues
//! from its labels.

use std::f64::consts::TAU;

use super::{
    Bifurcation, Degeneracy, Options, PatternCurve, Singularity, crossing,
    curve::{Curve, CurvePoint, difference, norm},
    follow::{CurveEnd, Followed, Step, follow},
    problem::{FollowedOrbit, PatternFamily, PatternOf},
};
use crate::error::{Error, Result};

/// A point of a branch.
#[derive(Debug, Clone, PartialEq)]
pub struct BranchPoint<O> {
    /// The parameter; for events followed in two, both.
    pub parameters: Vec<f64>,
    /// The orbit, with multipliers, admissibility and residual.
    pub orbit: O,
    /// The unknowns and the tangent.
    pub place: CurvePoint,
    /// The branch's direction: of the unknowns, then of the parameters as they are, to any length.
    pub tangent: Vec<f64>,
    /// What happens here; none of it if it is of codimension two.
    pub event: Option<Bifurcation>,
    /// What of codimension two happens here, on a curve in two parameters.
    pub degeneracy: Option<Degeneracy>,
    /// The function that takes a value here.
    pub level: Option<String>,
    /// Its name, "flip 1" being the first flip in the branch's order.
    pub label: Option<String>,
    /// The branch's length from the start, negative on the backward side.
    pub length: f64,
}

/// Orbits of one pattern along a curve, in its order.
#[derive(Debug, Clone, PartialEq)]
pub struct OrbitBranch<O: FollowedOrbit> {
    /// The bifurcation that is followed, if it is a curve of them.
    pub subject: Option<Bifurcation>,
    /// The pattern.
    pub itinerary: PatternOf<O>,
    /// The points.
    pub points: Vec<BranchPoint<O>>,
    /// Why there are none before the first and after the last.
    pub ends: [CurveEnd; 2],
}

/// Which way to follow a curve from its start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// Both ways.
    Both,
    /// Along the tangent: at an orbit's start, to larger parameters.
    Forward,
    /// Against it.
    Backward,
}

/// A curve of orbits, over one parameter or two.
pub trait OrbitCurve: Followed<View: FollowedOrbit> {
    /// The pattern.
    fn itinerary(&self) -> &PatternOf<Self::View>;

    /// The parameters at a point.
    fn parameters(&self, u: &[f64]) -> Vec<f64>;

    /// The parameters' units of length along the curve.
    fn units(&self) -> Vec<f64>;

    /// What an event is.
    fn singularity(&self, event: usize) -> Singularity;

    /// The bifurcation that is followed, if it is a curve of them.
    fn subject(&self) -> Option<Bifurcation>;
}

impl<F: PatternFamily + ?Sized> OrbitCurve for PatternCurve<'_, F> {
    fn itinerary(&self) -> &PatternOf<F::Orbit> {
        &self.itinerary
    }

    fn parameters(&self, u: &[f64]) -> Vec<f64> {
        vec![self.parameter(u)]
    }

    fn units(&self) -> Vec<f64> {
        vec![self.unit()]
    }

    fn singularity(&self, event: usize) -> Singularity {
        match event.checked_sub(Bifurcation::ALL.len()) {
            Some(level) => Singularity::Level(self.levels[level].name.clone()),
            None => Singularity::Bifurcation(Bifurcation::ALL[event]),
        }
    }

    fn subject(&self) -> Option<Bifurcation> {
        None
    }
}

impl<O> BranchPoint<O> {
    /// The name of what happens here.
    pub fn kind(&self) -> Option<&str> {
        let known = self.event.map(Bifurcation::name).or(self.degeneracy.map(Degeneracy::name));
        known.or(self.level.as_deref())
    }
}

impl<O: FollowedOrbit> OrbitBranch<O> {
    /// What its points are, in a word.
    pub fn name(&self) -> &'static str {
        self.subject.map_or("orbit", Bifurcation::name)
    }

    /// Follows a curve from a point of it.
    ///
    /// # Errors
    /// Those of [`follow`].
    pub fn follow(
        curve: &impl OrbitCurve<View = O>,
        start: &CurvePoint,
        direction: Direction,
        options: &Options,
    ) -> Result<Self> {
        let units = curve.units();
        let point = |step: Step<O>, sign: f64| {
            let mut tangent = step.place.tangent.clone();
            let first = tangent.len() - units.len();
            tangent[first..].iter_mut().zip(&units).for_each(|(t, unit)| *t *= unit);
            let (mut event, mut degeneracy, mut level) = (None, None, None);
            match step.event.map(|monitor| curve.singularity(monitor)) {
                Some(Singularity::Bifurcation(what)) => event = Some(what),
                Some(Singularity::Degeneracy(what)) => degeneracy = Some(what),
                Some(Singularity::Level(name)) => level = Some(name),
                None => {}
            }
            BranchPoint {
                parameters: curve.parameters(&step.place.u),
                orbit: step.view,
                place: step.place,
                tangent,
                event,
                degeneracy,
                level,
                label: None,
                length: sign * step.length,
            }
        };
        let mut branch = OrbitBranch {
            subject: curve.subject(),
            itinerary: curve.itinerary().clone(),
            points: Vec::new(),
            ends: [CurveEnd::Start, CurveEnd::Start],
        };
        if direction != Direction::Forward {
            let (steps, end) = follow(curve, start.reversed(), options)?;
            let end = faded(curve, &steps, &end).unwrap_or(end);
            branch.points.extend(steps.into_iter().rev().map(|mut step| {
                step.place = step.place.reversed();
                point(step, -1.0)
            }));
            // The start is the first point of the way forward, too.
            if direction == Direction::Both {
                branch.points.pop();
            }
            branch.ends[0] = end;
        }
        // A closed curve has come back to the start from behind: it is all there.
        if direction != Direction::Backward && branch.ends[0] != CurveEnd::Closed {
            let (steps, end) = follow(curve, start.clone(), options)?;
            let end = faded(curve, &steps, &end).unwrap_or(end);
            branch.points.extend(steps.into_iter().map(|step| point(step, 1.0)));
            branch.ends[1] = end;
        }
        let mut counts = std::collections::BTreeMap::new();
        for point in &mut branch.points {
            point.label = point.kind().map(|kind| {
                let count = counts.entry(kind.to_string()).and_modify(|count| *count += 1).or_insert(1);
                format!("{kind} {count}")
            });
        }
        Ok(branch)
    }

    /// The events with their labels.
    pub fn labels(&self) -> Vec<(&str, &BranchPoint<O>)> {
        self.points.iter().filter_map(|point| Some((point.label.as_deref()?, point))).collect()
    }

    /// Whether an orbit at a parameter value lies on the branch, as nearly as chords can tell; impact times
    /// that differ by whole periods are the same.
    pub fn passes(&self, orbit: &O, parameter: f64) -> bool {
        let z = orbit.unknowns();
        let off = |a: &O, b: &O, part: f64| -> f64 {
            let (from, to) = (a.unknowns(), b.unknowns());
            let apart = |i: usize| {
                let there = z[i] * orbit.unit(i) / a.unit(i);
                let apart = from[i] + part * (to[i] - from[i]) - there;
                if orbit.is_time(i) { apart - TAU * (apart / TAU).round() } else { apart }
            };
            (0..z.len()).map(|i| apart(i).powi(2)).sum::<f64>().sqrt()
        };
        let same = |pair: &[BranchPoint<O>]| {
            let [a, b] = [&pair[0], &pair[1]];
            let part = (parameter - a.parameters[0]) / (b.parameters[0] - a.parameters[0]);
            let chord = norm(&difference(&b.orbit.unknowns(), &a.orbit.unknowns()));
            (0.0..=1.0).contains(&part) && off(&a.orbit, &b.orbit, part) <= 0.1 * chord + 1e-6
        };
        self.itinerary == *orbit.pattern() && self.points.windows(2).any(same)
    }

    /// The point with a label.
    ///
    /// # Errors
    /// An input error that lists the labels there are.
    pub fn labelled(&self, label: &str) -> Result<&BranchPoint<O>> {
        let labels = self.labels();
        labels.iter().find(|(name, _)| *name == label).map(|(_, point)| *point).ok_or_else(|| {
            let names: Vec<&str> = labels.iter().map(|(name, _)| *name).collect();
            Error::input(format!("the branch has no label {label:?}; it has {}", names.join(", ")))
        })
    }
}

/// An impact so much slower than any on a curve of grazings is about to lose its speed.
const FADING: f64 = 1e-2;
/// So close, over the parameters' units, a line and a parabola come to the same end.
const CLOSE: f64 = 1e-6;

/// The end of a curve of grazings where an impact of its orbits loses its speed: beside it the least gap is
/// one of that impact's, so that the curve is lost before. It is where a parabola in that speed leads, if a
/// line leads there, too.
fn faded<C: OrbitCurve<View: FollowedOrbit>>(
    curve: &C,
    steps: &[Step<C::View>],
    end: &CurveEnd,
) -> Option<CurveEnd> {
    if curve.subject() != Some(Bifurcation::Grazing) || !matches!(end, CurveEnd::Lost(_)) {
        return None;
    }
    let speeds: Vec<f64> =
        steps.iter().map(|step| step.view.speeds().into_iter().fold(f64::INFINITY, f64::min)).collect();
    let last = *speeds.last()?;
    if !(last > 0.0 && last <= FADING * speeds.iter().copied().fold(0.0, f64::max)) {
        return None;
    }
    let before = |from: usize, least: f64| speeds[..from].iter().rposition(|speed| *speed >= least);
    let first = before(speeds.len(), 2.0 * last)?;
    let places = [speeds.len() - 1, first, before(first, 4.0 * last)?];
    let at = places.map(|i| curve.parameters(&steps[i].place.u));
    let [a, b, c] = places.map(|i| speeds[i]);
    let mut found = Vec::new();
    for (i, unit) in curve.units().into_iter().enumerate() {
        let line = (at[0][i] * b - at[1][i] * a) / (b - a);
        let other = (at[1][i] * c - at[2][i] * b) / (c - b);
        let curved = (line * c - other * a) / (c - a);
        if (curved - line).abs() > CLOSE * unit {
            return None;
        }
        found.push(curved);
    }
    Some(CurveEnd::Fades(found))
}

impl CurvePoint {
    /// The same point, looking back.
    #[must_use]
    pub(crate) fn reversed(&self) -> CurvePoint {
        CurvePoint { tangent: self.tangent.iter().map(|t| -t).collect(), ..self.clone() }
    }
}

impl<F: PatternFamily + ?Sized> PatternCurve<'_, F> {
    pub(crate) fn check_range(&self, parameter: f64) -> Result<()> {
        if self.contains(parameter) {
            return Ok(());
        }
        let (low, high) = self.range();
        Err(Error::input(format!("the start, {parameter}, is not in the range from {low} to {high}")))
    }

    /// An orbit at a parameter value, to start from; its tangent points to larger parameters.
    ///
    /// # Errors
    /// An input error at a saddle-node, or outside the range.
    pub fn start_at(&self, orbit: &F::Orbit, parameter: f64, options: &Options) -> Result<CurvePoint> {
        self.check_range(parameter)?;
        let own = |(i, z): (usize, &f64)| z * orbit.unit(i) / self.family.unit(&self.itinerary, i);
        let z: Vec<f64> = orbit.unknowns().iter().enumerate().map(own).collect();
        self.place(&self.unknowns(&z, parameter), options)
    }

    /// The point of the curve at u, or so near as rounding is, wherever on the curve it is: at a saddle-node
    /// too.
    pub(super) fn place(&self, u: &[f64], options: &Options) -> Result<CurvePoint> {
        // At a saddle-node the parameter must be free: any direction that is not normal to the curve fixes
        // the point.
        let (corrector, last) = (options.corrector(), u.len() - 1);
        let near = |place: &CurvePoint| place.u.iter().zip(u).all(|(a, b)| (a - b).abs() < 1e-6);
        let mut failure = None;
        for fixed in [last, 1, 0] {
            match corrector.start(self, u, fixed) {
                Ok(place) if near(&place) => {
                    let back = place.tangent[last] < 0.0;
                    return Ok(if back { place.reversed() } else { place });
                }
                Ok(_) => {}
                Err(error) => failure = Some(error),
            }
        }
        Err(failure.unwrap_or_else(|| Error::input("Newton's method leads away from the point")))
    }

    /// The branch that is born at a flip (with the doubled pattern) or crosses here (with the same): its
    /// curve and first point. The other half of the new branch lies against the tangent; at a flip it is the
    /// same orbits, a period later.
    ///
    /// # Errors
    /// An input error at any other point, or where the two branches' tangents cannot be told apart.
    pub fn switch(&self, what: Bifurcation, at: &CurvePoint) -> Result<(Self, CurvePoint)> {
        match what {
            Bifurcation::Crossing => {
                let found = crossing::locate(self, at)?;
                Ok((self.clone(), CurvePoint { tangent: found.other, ..found.place }))
            }
            Bifurcation::Flip => {
                let twice = |u: &[f64]| {
                    let (z, last) = u.split_at(u.len() - 1);
                    self.family.twice(&self.itinerary, z).into_iter().chain([last[0]]).collect::<Vec<f64>>()
                };
                let born = self.with(self.itinerary.repeated(2)?);
                // The born orbit and the same a period later are two at one parameter, one on each side of
                // the flip: there the parameter does not change. That the tangent is normal to the old branch
                // holds only where both halves of the unknowns are swapped by the shift, not where they are a
                // state.
                let u = twice(&at.u);
                let mut parameter = vec![0.0; u.len()];
                parameter[u.len() - 1] = 1.0;
                let tangent = crossing::kernel(&born.equations(&u)?.jacobian, &parameter)
                    .ok_or_else(|| Error::input("no second tangent here"))?;
                Ok((born, CurvePoint { u, tangent, residual: at.residual, steps: at.steps }))
            }
            other => Err(Error::input(format!("no branch to switch to at a {}", other.name()))),
        }
    }
}
