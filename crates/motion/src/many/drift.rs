//! Drifts: directions in which nothing holds a machine, as that in which a capsule robot crawls.
//!
//! A machine may be moved along a direction e where no spring, no gap and no formula tells: K e = 0, w·e = 0
//! of each stop, and each formula depends on displacements only by combinations c·q with c·e = 0. Friction
//! and damping act on velocities. Then motions from states that differ by a multiple of e differ by that for
//! ever, and what comes back but for a multiple of e does so once a period: it is periodic up to a drift. Of
//! a formula the combinations are read off its tree, so that one that holds in some places only, as `max(q1 -
//! 1, 0)`, holds.
//!
//! States are told apart by what is left of x = Lᵀq, in which the mass is 1, beside the drifts; the
//! multiplier 1 along each is left out with it. Orbits begin with no part of q along a drift.

use std::sync::Arc;

use super::{LinearEquations, Machine, RealMatrix, RealVector, equations::complement};
use crate::{
    error::Result,
    formula::{Formula, Operation},
    rounding::SUM,
};

/// The directions in which nothing holds a machine: at least one.
#[derive(Debug)]
pub(crate) struct Drifts {
    /// Orthonormal columns, in the machine's own coordinates.
    along: RealMatrix,
    /// What is left of x = Lᵀq: orthonormal columns.
    rest: RealMatrix,
    /// The drifts as the coordinates q of the scene show them.
    seen: RealMatrix,
}

impl Drifts {
    /// Those of a machine; none where all is held. Cost: O((n + stops) n²).
    ///
    /// # Errors
    /// Those of [`Machine::equations`].
    pub fn of(machine: &Machine<f64>, equations: &LinearEquations) -> Result<Option<Arc<Drifts>>> {
        let mut rows = Vec::new();
        for force in machine.smooth.iter().flatten() {
            let told = Told { points: machine.points(), coefficients: &force.coefficients };
            let last = told.by(&force.formula, &mut rows).0;
            rows.push(last);
        }
        rows.extend(machine.stops.iter().map(|stop| stop.row.clone()));
        let rows = rows.iter().map(|row| machine.vector("row", row)).collect::<Result<Vec<_>>>()?;
        let springs = equations.stiffness.row_iter().map(|row| row.transpose());
        let units: Vec<RealVector> =
            springs.chain(rows).filter(|row| row.amax() > 0.0).map(|row| row.normalize()).collect();
        let n = equations.size();
        // As many rows as columns at least, for all directions to be there.
        let all = RealMatrix::from_fn(units.len().max(n), n, |i, j| units.get(i).map_or(0.0, |row| row[j]));
        let found = all.svd(false, true);
        let Some(directions) = found.v_t else { return Ok(None) };
        let free = (0..n).filter(|&i| found.singular_values[i] <= SUM);
        let columns: Vec<RealVector> = free.map(|i| directions.row(i).transpose()).collect();
        if columns.is_empty() {
            return Ok(None);
        }
        let along = RealMatrix::from_columns(&columns);
        let rest = complement(&equations.root().tr_mul(&along));
        let seen = machine.shape().map_or_else(|| along.clone(), |shape| shape * &along);
        Ok(Some(Arc::new(Drifts { along, rest, seen })))
    }

    /// How many.
    pub fn count(&self) -> usize {
        self.along.ncols()
    }

    /// The part of displacements along them.
    pub fn part(&self, q: &RealVector) -> RealVector {
        &self.along * self.along.tr_mul(q)
    }

    /// Whether a row tells of none of them.
    pub fn is_unseen(&self, row: &RealVector) -> bool {
        self.along.tr_mul(row).amax() <= SUM * row.amax()
    }

    /// The part of displacements along them as the coordinates of the scene show it.
    pub fn seen(&self, q: &RealVector) -> RealVector {
        &self.seen * self.along.tr_mul(q)
    }

    /// What is left of (Lᵀq, Lᵀq′).
    pub fn reduced(&self, whole: &[f64]) -> Vec<f64> {
        let n = whole.len() / 2;
        let left = self.rest.tr_mul(&RealVector::from_column_slice(&whole[..n]));
        left.iter().chain(&whole[n..]).copied().collect()
    }

    /// (Lᵀq, Lᵀq′) of what is left, with nothing along the drifts.
    pub fn lifted(&self, left: &[f64]) -> Vec<f64> {
        let n = self.rest.ncols();
        let whole = &self.rest * RealVector::from_column_slice(&left[..n]);
        whole.iter().chain(&left[n..]).copied().collect()
    }

    /// Of a matrix that leaves displacements along the drifts as they are, what it does to all others.
    pub fn quotient(&self, matrix: &RealMatrix) -> RealMatrix {
        let (n, d) = (self.along.nrows(), self.count());
        let mut fixed = RealMatrix::zeros(2 * n, d);
        fixed.view_mut((0, 0), (n, d)).copy_from(&self.along);
        let others = complement(&fixed);
        others.tr_mul(&(matrix * &others))
    }
}

/// What a formula tells of displacements.
struct Told<'f> {
    points: usize,
    coefficients: &'f [f64],
}

impl Told<'_> {
    /// A formula is c·q and what depends on displacements by `rows` only; c, and the value where it is one
    /// number.
    fn by(&self, formula: &Formula, rows: &mut Vec<Vec<f64>>) -> (Vec<f64>, Option<f64>) {
        let (points, none) = (self.points, || vec![0.0; self.points]);
        if !formula.mentions(&|place| place <= 2 * points) {
            let variables: Vec<f64> =
                std::iter::repeat_n(0.0, 2 * points + 1).chain(self.coefficients.iter().copied()).collect();
            return (none(), Some(formula.at(&variables)[0]));
        }
        let times = |row: Vec<f64>, factor: f64| (row.into_iter().map(|c| c * factor).collect(), None);
        let mut parts = match formula {
            Formula::Variable(place) => {
                return ((0..points).map(|i| f64::from(u8::from(i == *place))).collect(), None);
            }
            Formula::Negated(inner) => return times(self.by(inner, rows).0, -1.0),
            Formula::Binary(operation, parts) => {
                let [(a, x), (b, y)] = parts.each_ref().map(|part| self.by(part, rows));
                match (operation, x, y) {
                    (Operation::Sum, ..) => return (a.iter().zip(&b).map(|(a, b)| a + b).collect(), None),
                    (Operation::Difference, ..) => {
                        return (a.iter().zip(&b).map(|(a, b)| a - b).collect(), None);
                    }
                    (Operation::Product, Some(x), _) => return times(b, x),
                    (Operation::Product, _, Some(y)) => return times(a, y),
                    (Operation::Quotient, _, Some(y)) => return times(a, 1.0 / y),
                    _ => vec![a, b],
                }
            }
            Formula::Power(inner, _) | Formula::Call(_, inner) | Formula::Raised(inner, _) => {
                vec![self.by(inner, rows).0]
            }
            Formula::Choice(choice) => choice.parts().map(|part| self.by(part, rows).0).to_vec(),
            Formula::Number(_) | Formula::Pi => Vec::new(),
        };
        rows.append(&mut parts);
        (none(), None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::kink;

    fn q(place: usize) -> Formula {
        Formula::Variable(place)
    }

    fn join(operation: Operation, a: Formula, b: Formula) -> Formula {
        Formula::Binary(operation, Box::new([a, b]))
    }

    #[test]
    fn a_formula_tells_of_differences_and_of_what_it_holds_in_some_places() {
        let told = Told { points: 2, coefficients: &[3.0] };
        let apart = || join(Operation::Difference, q(0), q(1));
        let rows = |formula: &Formula| {
            let mut rows = Vec::new();
            let last = told.by(formula, &mut rows).0;
            rows.push(last);
            rows.retain(|row| row.iter().any(|c| *c != 0.0));
            rows
        };
        // (q1 − q2)³ and 3 q1 − q2 · 3, and the same of velocities.
        assert_eq!(rows(&Formula::Power(Box::new(apart()), 3)), [[1.0, -1.0]]);
        let [first, second] = [0, 1].map(|place| join(Operation::Product, q(5), q(place)));
        assert_eq!(rows(&join(Operation::Difference, first, second)), [[3.0, -3.0]]);
        assert!(rows(&Formula::Power(Box::new(q(2)), 3)).is_empty());
        // q1 q2 tells of both; max(q1, q2) of q1 − q2, of q1 and of q2.
        assert_eq!(rows(&join(Operation::Product, q(0), q(1))), [[1.0, 0.0], [0.0, 1.0]]);
        let most = kink("max", "max(q1,q2)", vec![q(0), q(1)]).unwrap();
        assert_eq!(rows(&most), [[1.0, -1.0], [1.0, 0.0], [0.0, 1.0]]);
    }
}
