//! Pseudo-arclength continuation of any curve given by n equations in n + 1 unknowns.
//!
//! From a point u with unit tangent t the next is predicted at u + h t and corrected by Newton's method on
//! the equations with t·(v − u) = h. Nothing here singles out a parameter, so folds are points like others.
//! Not here: what the equations say (`orbits`, `events`) and when to end (`follow`).

use crate::{
    error::{Error, Result},
    motion::algebra::solve,
};

/// n equations at one point, with their derivatives by the n + 1 unknowns, by rows.
#[derive(Debug, Clone)]
pub struct Equations {
    /// F.
    pub residual: Vec<f64>,
    /// ∂F/∂u.
    pub jacobian: Vec<Vec<f64>>,
}

/// A curve: the zeros of n equations in n + 1 unknowns.
pub trait Curve {
    /// The equations at u.
    ///
    /// # Errors
    /// An input error where they are not defined.
    fn equations(&self, u: &[f64]) -> Result<Equations>;
}

/// A point of a curve with the unit tangent there.
#[derive(Debug, Clone, PartialEq)]
pub struct CurvePoint {
    /// The unknowns.
    pub u: Vec<f64>,
    /// The tangent, pointing the way the curve is followed.
    pub tangent: Vec<f64>,
    /// The largest |F_i|.
    pub residual: f64,
    /// Newton steps that it took.
    pub steps: u32,
}

/// When Newton's method ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corrector {
    /// A step no longer than this is the last one.
    pub tolerance: f64,
    /// Most steps.
    pub steps: u32,
}

/// Residuals of at most this part of what rounding the unknowns changes are rounding's: beside a point where
/// curves cross, where the equations are nearly singular, steps made from them would not end.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Whether a residual is no larger than what rounding of the unknowns makes of it: |F_i| against Σ |∂F_i/∂u_j
/// u_j|, which grows with the equations' own stiffness.
fn is_rounding(here: &Equations, u: &[f64]) -> bool {
    let size = 1.0 + largest(u);
    let moved = |row: &[f64]| row.iter().zip(u).map(|(slope, u)| (slope * u).abs()).sum::<f64>();
    here.residual.iter().zip(&here.jacobian).all(|(f, row)| f.abs() <= ROUNDING * size.max(moved(row)))
}

impl Corrector {
    /// The point of the curve near `guess` in the hyperplane through it that is normal to `normal`, the
    /// tangent there within a right angle of `normal`. Cost: O(n³) and one evaluation a step.
    ///
    /// # Errors
    /// An input error where the equations are not defined, or if Newton's method does not end.
    pub fn correct(&self, curve: &impl Curve, guess: &[f64], normal: &[f64]) -> Result<CurvePoint> {
        let (mut u, mut last) = (guess.to_vec(), f64::INFINITY);
        for steps in 1..=self.steps {
            let here = curve.equations(&u)?;
            let off = dot(normal, &u) - dot(normal, guess);
            let solved = is_rounding(&here, &u) && off.abs() <= ROUNDING * (1.0 + largest(&u));
            let mut right = here.residual;
            right.push(off);
            let step = bordered(here.jacobian, normal, right)?;
            u.iter_mut().zip(&step).for_each(|(u, step)| *u -= step);
            let length = norm(&step);
            let settled = solved && length >= last / 2.0;
            last = length;
            if length <= self.tolerance || settled {
                let there = curve.equations(&u)?;
                let residual = largest(&there.residual);
                let tangent = tangent(there.jacobian, normal)?;
                return Ok(CurvePoint { u, tangent, residual, steps });
            }
        }
        Err(Error::input(format!("Newton's method did not end in {} steps", self.steps)))
    }

    /// The point a step `h` on from `place`.
    ///
    /// # Errors
    /// As [`Corrector::correct`].
    pub(crate) fn step(&self, curve: &impl Curve, place: &CurvePoint, h: f64) -> Result<CurvePoint> {
        let guess: Vec<f64> = place.u.iter().zip(&place.tangent).map(|(u, t)| u + h * t).collect();
        self.correct(curve, &guess, &place.tangent)
    }

    /// The point of the curve nearest to `guess`, as far as Newton's method can tell that does not know the
    /// tangent yet: the unknown `fixed` is kept. The tangent has that component not negative.
    ///
    /// # Errors
    /// As [`Corrector::correct`].
    pub(crate) fn start(&self, curve: &impl Curve, guess: &[f64], fixed: usize) -> Result<CurvePoint> {
        let mut normal = vec![0.0; guess.len()];
        normal[fixed] = 1.0;
        self.correct(curve, guess, &normal)
    }
}

/// The unit vector in the kernel of a Jacobian, within a right angle of `near`.
fn tangent(jacobian: Vec<Vec<f64>>, near: &[f64]) -> Result<Vec<f64>> {
    let mut right = vec![0.0; near.len()];
    right[near.len() - 1] = 1.0;
    let mut tangent = bordered(jacobian, near, right)?;
    let length = norm(&tangent);
    tangent.iter_mut().for_each(|t| *t /= length);
    Ok(tangent)
}

/// The solution of the Jacobian's equations and one more with the row `last`.
fn bordered(mut jacobian: Vec<Vec<f64>>, last: &[f64], right: Vec<f64>) -> Result<Vec<f64>> {
    jacobian.push(last.to_vec());
    solve(jacobian, right).ok_or_else(|| Error::input("the curve has no tangent here: a singular Jacobian"))
}

/// The largest |x_i|; NaN counts as infinite.
pub(super) fn largest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |most, x| if x.is_nan() { f64::INFINITY } else { most.max(x.abs()) })
}

/// a·b.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// |a|.
pub(super) fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

/// a − b.
pub(super) fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}
