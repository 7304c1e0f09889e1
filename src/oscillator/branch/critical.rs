//! Where an orbit bifurcates: saddle-nodes and flips, to rounding.
//!
//! The branch of orbits near a given one is a curve in (z, p); it is described by its distance s along the tangent there, so that
//! it may fold in p. Along it a test function changes sign, and a bracketing secant method finds where. (Grazing of
//! a branch needs no search: `grazing::locate`.) Not here: following a branch far.

use crate::{
    error::{Error, Result},
    oscillator::{
        algebra::solve,
        orbit::{
            Family, Itinerary, Linearised, Multipliers, Orbit, Root, describe, linearise, monodromy, newton,
        },
    },
};

/// What is looked for on a branch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bifurcation {
    /// A multiplier 1: two orbits meet.
    SaddleNode,
    /// A multiplier −1: an orbit of twice the period branches off.
    Flip,
}

impl Bifurcation {
    /// The function of the multipliers that changes sign there.
    pub fn test(self, multipliers: &Multipliers) -> f64 {
        match self {
            Bifurcation::SaddleNode => multipliers.fold(),
            Bifurcation::Flip => multipliers.flip(),
        }
    }
}

/// A bifurcation that was found.
#[derive(Debug, Clone)]
pub struct Critical {
    /// Which.
    pub kind: Bifurcation,
    /// The parameter there.
    pub parameter: f64,
    /// The orbit there.
    pub orbit: Orbit,
}

/// The branch of orbits through a point, by s: (z, p) with the component of (z, p) − (z₀, p₀) along the tangent equal to s.
pub struct Chart<'f> {
    family: &'f dyn Family,
    itinerary: Itinerary,
    centre: Vec<f64>,
    tangent: Vec<f64>,
}

impl<'f> Chart<'f> {
    /// The chart around a solution z of the pattern equations at a parameter.
    ///
    /// # Errors
    /// As [`linearise`]; an input error if the branch has no tangent there.
    pub fn new(
        family: &'f dyn Family,
        itinerary: &Itinerary,
        z: &[f64],
        parameter: f64,
    ) -> Result<Chart<'f>> {
        let Linearised { jacobian, slope, .. } = linearise(&family.at(parameter)?, itinerary, z)?;
        let n = z.len();
        let rows: Vec<Vec<f64>> = jacobian
            .into_iter()
            .zip(slope)
            .map(|(mut row, slope)| {
                row.push(slope);
                row
            })
            .collect();
        // The null vector with one entry 1: the entry that leaves the best-conditioned system, which has the least other entries.
        let null = |pinned: usize| {
            let square =
                rows.iter().map(|row| (0..=n).filter(|&j| j != pinned).map(|j| row[j]).collect()).collect();
            let mut found = solve(square, rows.iter().map(|row| -row[pinned]).collect())?;
            found.insert(pinned, 1.0);
            Some(found)
        };
        let size = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
        let best = (0..=n).filter_map(null).min_by(|a, b| size(a).total_cmp(&size(b)));
        let mut tangent =
            best.ok_or_else(|| Error::input("the branch has no tangent here: several branches meet"))?;
        let length = size(&tangent).copysign(tangent[n]);
        tangent.iter_mut().for_each(|x| *x /= length);
        let centre = z.iter().copied().chain([parameter]).collect();
        Ok(Chart { family, itinerary: itinerary.clone(), centre, tangent })
    }

    /// The solution at s, found by Newton's method from a point (z, p) near it.
    ///
    /// # Errors
    /// As [`newton`].
    pub fn at(&self, s: f64, start: Vec<f64>) -> Result<Root> {
        newton(start, |y| {
            let (z, parameter) = y.split_at(y.len() - 1);
            let oscillator = self.family.at(parameter[0])?;
            let Linearised { mut residual, mut jacobian, slope } =
                linearise(&oscillator, &self.itinerary, z)?;
            jacobian.iter_mut().zip(&slope).for_each(|(row, slope)| row.push(*slope));
            jacobian.push(self.tangent.clone());
            let along: f64 = (0..y.len()).map(|i| self.tangent[i] * (y[i] - self.centre[i])).sum();
            residual.push(along - s);
            Ok(Linearised { residual, jacobian, slope })
        })
    }

    /// The solution at s from the tangent.
    fn near_centre(&self, s: f64) -> Result<Root> {
        self.at(
            s,
            self.centre.iter().zip(&self.tangent).map(|(centre, tangent)| centre + s * tangent).collect(),
        )
    }

    fn test(&self, kind: Bifurcation, y: &[f64]) -> Result<f64> {
        let (z, parameter) = y.split_at(y.len() - 1);
        let oscillator = self.family.at(parameter[0])?;
        let matrix = monodromy(&oscillator, &self.itinerary, z)?;
        Ok(kind.test(&Multipliers::new(&matrix, &oscillator, &self.itinerary)))
    }
}

/// A point of the chart: s, the solution, the test function.
type Sample = (f64, Root, f64);

/// The nearest bifurcation of a kind on the branch through an orbit: the branch is sampled at growing distances both ways up to `reach`
/// (in the norm of (z, p)) until the test function changes sign, then the secant method, kept in the bracket, ends at rounding.
///
/// # Errors
/// An input error if there is no sign change within reach.
pub fn locate(
    family: &dyn Family,
    kind: Bifurcation,
    orbit: &Orbit,
    parameter: f64,
    reach: f64,
) -> Result<Critical> {
    let chart = Chart::new(family, &orbit.itinerary, &orbit.z, parameter)?;
    let sample = |s: f64| -> Result<Sample> {
        let root = chart.near_centre(s)?;
        let test = chart.test(kind, &root.z)?;
        Ok((s, root, test))
    };
    let centre = sample(0.0)?;
    let mut ends = [Some(centre.clone()), Some(centre)];
    let mut step = reach / 256.0;
    while step <= reach && ends.iter().any(Option::is_some) {
        for (end, direction) in ends.iter_mut().zip([1.0, -1.0]) {
            let Some(from) = end.take() else { continue };
            let Ok(to) = sample(direction * step) else { continue };
            if from.2.signum() != to.2.signum() {
                return refine(&chart, kind, &sample, [from, to]);
            }
            *end = Some(to);
        }
        step *= 2.0_f64.sqrt();
    }
    Err(Error::input(format!(
        "no {kind:?} within {reach} of the orbit {} at {parameter}: start nearer",
        orbit.itinerary
    )))
}

/// The Illinois form of the secant method: superlinear, and it never leaves the bracket.
fn refine(
    chart: &Chart,
    kind: Bifurcation,
    sample: &dyn Fn(f64) -> Result<Sample>,
    [mut a, mut b]: [Sample; 2],
) -> Result<Critical> {
    for _ in 0..200 {
        let s = (a.0 * b.2 - b.0 * a.2) / (b.2 - a.2);
        if a.2 == 0.0 || b.2 == 0.0 || s <= a.0.min(b.0) || s >= a.0.max(b.0) {
            break;
        }
        let c = sample(s)?;
        let width = (c.0 - b.0).abs();
        if c.2.signum() == b.2.signum() {
            a.2 /= 2.0;
        } else {
            a = b;
        }
        b = c;
        if width <= 1e-15 * (1.0 + b.0.abs()) {
            break;
        }
    }
    let (_, mut root, _) = if a.2.abs() < b.2.abs() { a } else { b };
    let parameter = root.z.pop().unwrap_or(f64::NAN);
    let orbit = describe(&chart.family.at(parameter)?, &chart.itinerary, root)?;
    Ok(Critical { kind, parameter, orbit })
}
