//! A branch: what was found along the curve of an impact pattern, both ways from a start, and what continues from its labels.

use std::f64::consts::TAU;

use super::{
    Event, Options, Orbits,
    curve::{Curve, Foot, difference, norm},
    follow::{End, Followed, Step, follow},
};
use crate::{
    error::{Error, Result},
    oscillator::{
        algebra::solve,
        orbit::{Itinerary, Orbit, find},
    },
};

/// A point of a branch.
#[derive(Debug, Clone)]
pub struct Point {
    /// The parameter; for events followed in two, both.
    pub parameters: Vec<f64>,
    /// The orbit, with multipliers, admissibility and residual.
    pub orbit: Orbit,
    /// The unknowns and the tangent.
    pub foot: Foot,
    /// What happens here.
    pub event: Option<Event>,
    /// The branch's length from the start, negative on the backward side.
    pub length: f64,
}

/// Orbits of one pattern along a curve, in its order.
#[derive(Debug, Clone)]
pub struct Branch {
    /// The pattern.
    pub itinerary: Itinerary,
    /// The points.
    pub points: Vec<Point>,
    /// Why there are none before the first and after the last.
    pub ends: [End; 2],
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
pub trait OrbitCurve: Followed<View = Orbit> {
    /// The pattern.
    fn itinerary(&self) -> &Itinerary;

    /// The parameters at a point.
    fn parameters(&self, u: &[f64]) -> Vec<f64>;
}

impl OrbitCurve for Orbits<'_> {
    fn itinerary(&self) -> &Itinerary {
        &self.itinerary
    }

    fn parameters(&self, u: &[f64]) -> Vec<f64> {
        vec![self.parameter(u)]
    }
}

impl Branch {
    /// Follows a curve from a point of it.
    ///
    /// # Errors
    /// Those of [`follow`].
    pub fn follow(
        curve: &impl OrbitCurve,
        start: &Foot,
        direction: Direction,
        options: &Options,
    ) -> Result<Branch> {
        let point = |step: Step<Orbit>, sign: f64| Point {
            parameters: curve.parameters(&step.foot.u),
            orbit: step.view,
            foot: step.foot,
            event: step.event.map(Event::of),
            length: sign * step.length,
        };
        let mut branch = Branch {
            itinerary: curve.itinerary().clone(),
            points: Vec::new(),
            ends: [End::Start, End::Start],
        };
        if direction != Direction::Forward {
            let (steps, end) = follow(curve, start.reversed(), options)?;
            branch.points.extend(steps.into_iter().rev().map(|mut step| {
                step.foot = step.foot.reversed();
                point(step, -1.0)
            }));
            if direction == Direction::Both {
                branch.points.pop();
            }
            branch.ends[0] = end;
        }
        if direction != Direction::Backward && branch.ends[0] != End::Closed {
            let (steps, end) = follow(curve, start.clone(), options)?;
            branch.points.extend(steps.into_iter().map(|step| point(step, 1.0)));
            branch.ends[1] = end;
        }
        Ok(branch)
    }

    /// The events with their labels, "flip 1" being the first flip in the branch's order.
    pub fn labels(&self) -> Vec<(String, &Point)> {
        let mut counts = [0; Event::ALL.len()];
        let labelled = self.points.iter().filter_map(|point| Some((point.event?, point)));
        labelled
            .map(|(event, point)| {
                counts[event as usize] += 1;
                (format!("{} {}", event.name(), counts[event as usize]), point)
            })
            .collect()
    }

    /// Whether an orbit at a parameter value lies on the branch, as nearly as chords can tell; impact times that differ by whole
    /// periods are the same.
    pub fn passes(&self, orbit: &Orbit, parameter: f64) -> bool {
        let off = |a: &Orbit, b: &Orbit, part: f64| -> f64 {
            let apart = |i: usize| {
                let apart = a.z[i] + part * (b.z[i] - a.z[i]) - orbit.z[i];
                if i.is_multiple_of(2) && !orbit.itinerary.strikes().is_empty() {
                    apart - TAU * (apart / TAU).round()
                } else {
                    apart
                }
            };
            (0..orbit.z.len()).map(|i| apart(i).powi(2)).sum::<f64>().sqrt()
        };
        let same = |pair: &[Point]| {
            let [a, b] = [&pair[0], &pair[1]];
            let part = (parameter - a.parameters[0]) / (b.parameters[0] - a.parameters[0]);
            let chord = norm(&difference(&b.orbit.z, &a.orbit.z));
            (0.0..=1.0).contains(&part) && off(&a.orbit, &b.orbit, part) <= 0.1 * chord + 1e-6
        };
        self.itinerary == orbit.itinerary && self.points.windows(2).any(same)
    }

    /// The point with a label.
    ///
    /// # Errors
    /// An input error that lists the labels there are.
    pub fn labelled(&self, label: &str) -> Result<&Point> {
        let labels = self.labels();
        labels.iter().find(|(name, _)| name == label).map(|(_, point)| *point).ok_or_else(|| {
            let names: Vec<&str> = labels.iter().map(|(name, _)| name.as_str()).collect();
            Error::input(format!("the branch has no label {label:?}; it has {}", names.join(", ")))
        })
    }
}

impl Foot {
    /// The same point, looking back.
    #[must_use]
    pub fn reversed(&self) -> Foot {
        Foot { tangent: self.tangent.iter().map(|t| -t).collect(), ..self.clone() }
    }
}

impl Orbits<'_> {
    /// The orbit near `guess` at a parameter value, to start from; its tangent points to larger parameters.
    ///
    /// # Errors
    /// Those of [`find`]; an input error at a saddle-node, or outside the range.
    pub fn start(&self, guess: Vec<f64>, parameter: f64, options: &Options) -> Result<Foot> {
        let (low, high) = self.range;
        if !(low < high && (low..=high).contains(&parameter)) {
            return Err(Error::input(format!(
                "the start, {parameter}, is not in the range from {low} to {high}"
            )));
        }
        let orbit = find(&self.family.at(parameter)?, &self.itinerary, guess)?;
        let u = self.unknowns(&orbit.z, parameter);
        options.corrector().start(self, &u, u.len() - 1)
    }

    /// The branch that is born at a flip (with the doubled pattern) or crosses here (with the same): its curve and
    /// first point. The other half of the new branch lies against the tangent; at a flip it is the same orbits, a period later.
    ///
    /// # Errors
    /// An input error at any other point.
    pub fn switch(&self, event: Event, at: &Foot) -> Result<(Self, Foot)> {
        let times = match event {
            Event::Flip => 2,
            Event::Crossing => 1,
            other => return Err(Error::input(format!("no branch to switch to at a {}", other.name()))),
        };
        let copies = if self.itinerary.strikes().is_empty() { 1 } else { times };
        let twice = |u: &[f64]| {
            let (z, last) = u.split_at(u.len() - 1);
            z.repeat(copies).into_iter().chain([last[0]]).collect::<Vec<f64>>()
        };
        let itinerary = self.itinerary.repeated(times as u32);
        let born = Orbits { family: self.family, itinerary, range: self.range };
        let u = twice(&at.u);
        let mut old = twice(&at.tangent);
        let length = norm(&old);
        old.iter_mut().for_each(|t| *t /= length);
        let tangent = other_tangent(&born, &u, old)?;
        Ok((born, Foot { u, tangent, residual: at.residual, steps: at.steps }))
    }
}

/// Where a Jacobian's kernel is two-dimensional, the unit vector in it that is normal to one of it: by inverse
/// iteration, which the near-singularity of the bordered matrix makes exact.
fn other_tangent(curve: &impl Curve, u: &[f64], old: Vec<f64>) -> Result<Vec<f64>> {
    let mut matrix = curve.equations(u)?.jacobian;
    matrix.push(old);
    for (i, row) in matrix.iter_mut().enumerate() {
        row[i] += 1e-14;
    }
    // Any vector will do that is not normal to the answer.
    let mut x: Vec<f64> = (0..u.len()).map(|i| 1.0 / (1.0 + i as f64)).collect();
    for _ in 0..3 {
        x = solve(matrix.clone(), x).ok_or_else(|| Error::input("no second tangent here"))?;
        let length = norm(&x);
        x.iter_mut().for_each(|x| *x /= length);
    }
    Ok(x)
}
