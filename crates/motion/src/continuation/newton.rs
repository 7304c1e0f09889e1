//! Newton's method, damped: for pattern equations and for the systems that pin down their bifurcations.

use super::{curve::largest, search::Known};
use crate::{
    error::{Error, Result},
    motion::algebra::solve,
};

/// The equations at one z: F, ∂F/∂z by rows, ∂F/∂p.
#[derive(Debug, Clone)]
pub struct Linearised {
    /// F.
    pub residual: Vec<f64>,
    /// ∂F/∂z.
    pub jacobian: Vec<Vec<f64>>,
    /// ∂F/∂p; zeros if the system has no slope.
    pub slope: Vec<f64>,
}

impl Linearised {
    /// The same with lengths and speeds measured by `unit`, an unknown of 1 being `own` of its number.
    #[must_use]
    pub(crate) fn measured(mut self, unit: f64, own: impl Fn(usize) -> f64) -> Linearised {
        self.residual.iter_mut().chain(&mut self.slope).for_each(|x| *x /= unit);
        for row in &mut self.jacobian {
            row.iter_mut().enumerate().for_each(|(i, x)| *x *= own(i) / unit);
        }
        self
    }
}

/// Most steps of one solution.
const STEPS: usize = 60;

/// A root with what is left of the equations there.
#[derive(Debug, Clone)]
pub struct Root {
    /// z.
    pub z: Vec<f64>,
    /// The largest |F_i|.
    pub residual: f64,
    /// Newton steps taken.
    pub steps: usize,
}

/// A root of F near `start`. `equations` gives F and ∂F/∂z, or an error where F is not defined; no step is
/// longer than 1, and a step that does not lower |F| is halved. Ends when steps stop shrinking at the level
/// of rounding: no iterate is farther than 60 from the start. It keeps away from what is `known`.
///
/// # Errors
/// An input error if F is not defined at `start`, ∂F/∂z is singular on the way, or it does not converge in 60
/// steps (20 where some are known, and no step is halved as often).
pub(crate) fn newton(
    start: Vec<f64>,
    known: &Known,
    equations: impl Fn(&[f64]) -> Result<Linearised>,
) -> Result<Root> {
    let (most, least) = if known.is_empty() { (STEPS, 1e-6) } else { (STEPS / 3, 1e-2) };
    let mut z = start;
    let mut here = equations(&z)?;
    let mut size = largest(&here.residual);
    for steps in 0..most {
        // At a fold the Jacobian is singular: there F alone has to be small.
        let solved = size <= 4.0 * f64::EPSILON * (1.0 + largest(&z));
        let Some(mut step) = solve(here.jacobian, here.residual.clone()) else {
            return if solved {
                Ok(Root { z, residual: size, steps })
            } else {
                Err(Error::input("Newton's method met a singular Jacobian"))
            };
        };
        let (held, along) = known.factor(&z, &step);
        // Of the equations times the factor Newton's step has the same direction.
        step.iter_mut().for_each(|x| *x /= 1.0 + along);
        let length = largest(&step);
        let settled = solved || length <= 1e-11 * (1.0 + largest(&z));
        let mut factor = (1.0 / length).min(1.0);
        let next = loop {
            let trial: Vec<f64> = z.iter().zip(&step).map(|(z, step)| z - factor * step).collect();
            let there = known.factor(&trial, &step).0;
            match equations(&trial) {
                Ok(found) if there * largest(&found.residual) < held * size => break Some((trial, found)),
                _ if settled => break None,
                _ => factor /= 2.0,
            }
            if factor < least {
                return Err(unended(size, steps));
            }
        };
        // At the level of rounding a step that lowers |F| no more is the end.
        let Some((trial, found)) = next else {
            return Ok(Root { z, residual: size, steps });
        };
        (z, here) = (trial, found);
        size = largest(&here.residual);
        if size == 0.0 {
            return Ok(Root { z, residual: size, steps: steps + 1 });
        }
    }
    // Each of these steps may have lowered |F| a little, below what rounding leaves of it.
    if size <= 4.0 * f64::EPSILON * (1.0 + largest(&z)) {
        return Ok(Root { z, residual: size, steps: most });
    }
    Err(unended(size, most))
}

/// The unknowns near `start` where equations hold that are linear in all unknowns but `kept`: Newton's method
/// goes in `kept`, by as many `rows` of the equations; the other unknowns solve the other rows at every step
/// (variable projection). So a search fills few dimensions, and comes to solutions that are missed where all
/// unknowns are spread. Cost: two of `equations` a step, and a linear solution for each of `kept`.
///
/// # Errors
/// As [`newton`]; an input error where the other rows have not one solution.
pub(crate) fn project(
    start: &[f64],
    kept: &[usize],
    rows: &[usize],
    known: &Known,
    equations: impl Fn(&[f64]) -> Result<Linearised>,
) -> Result<Vec<f64>> {
    let others = |some: &[usize]| (0..start.len()).filter(|i| !some.contains(i)).collect::<Vec<usize>>();
    let (linear, solved) = (others(kept), others(rows));
    let solution = |at: &Linearised, right: &dyn Fn(usize) -> f64| {
        let matrix =
            solved.iter().map(|&row| linear.iter().map(|&k| at.jacobian[row][k]).collect()).collect();
        solve(matrix, solved.iter().map(|&row| -right(row)).collect())
            .ok_or_else(|| Error::input("the linear unknowns have not one solution"))
    };
    let whole = |part: &[f64]| {
        let mut z = vec![0.0; start.len()];
        kept.iter().zip(part).for_each(|(&k, x)| z[k] = *x);
        let at = equations(&z)?;
        linear.iter().zip(solution(&at, &|row| at.residual[row])?).for_each(|(&k, x)| z[k] = x);
        Ok(z)
    };
    let begin = kept.iter().map(|&k| start[k]).collect();
    let root = newton(begin, known, |part| {
        let at = equations(&whole(part)?)?;
        let moved: Vec<Vec<f64>> =
            kept.iter().map(|&k| solution(&at, &|row| at.jacobian[row][k])).collect::<Result<_>>()?;
        let entry = |row: usize, (k, moved): (usize, &[f64])| {
            let by = linear.iter().zip(moved).map(|(&other, x)| at.jacobian[row][other] * x);
            at.jacobian[row][k] + by.sum::<f64>()
        };
        let columns = || kept.iter().copied().zip(moved.iter().map(Vec::as_slice));
        Ok(Linearised {
            residual: rows.iter().map(|&row| at.residual[row]).collect(),
            jacobian: rows.iter().map(|&row| columns().map(|column| entry(row, column)).collect()).collect(),
            slope: vec![0.0; rows.len()],
        })
    })?;
    whole(&root.z)
}

/// It comes no nearer, or too slowly: which of the two depends on the unknowns, and says nothing.
fn unended(size: f64, steps: usize) -> Error {
    Error::input(format!("Newton's method did not converge: residual {size:.1e} after {steps} steps"))
}
