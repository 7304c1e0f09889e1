//! Small dense matrices and Gaussian elimination that never divides by what may be zero.

use std::ops::{Index, IndexMut};

use super::Scalar;
use crate::number::{Real, Sign};

/// A matrix stored by rows.
#[derive(Debug, Clone)]
pub struct Matrix<T> {
    columns: usize,
    entries: Vec<T>,
}

impl<T> Matrix<T> {
    /// The matrix of these rows, all of one length.
    pub(crate) fn from_rows(rows: Vec<Vec<T>>) -> Self {
        let columns = rows.first().map_or(0, Vec::len);
        debug_assert!(rows.iter().all(|row| row.len() == columns));
        Matrix { columns, entries: rows.into_iter().flatten().collect() }
    }

    /// The number of rows.
    pub(crate) fn rows(&self) -> usize {
        self.entries.len().checked_div(self.columns).unwrap_or(0)
    }

    /// The number of columns.
    pub(crate) fn columns(&self) -> usize {
        self.columns
    }

    /// One row.
    pub(crate) fn row(&self, index: usize) -> &[T] {
        &self.entries[index * self.columns..(index + 1) * self.columns]
    }

    /// The matrix with `f` applied to every entry.
    pub(crate) fn map<U>(&self, f: impl FnMut(&T) -> U) -> Matrix<U> {
        Matrix { columns: self.columns, entries: self.entries.iter().map(f).collect() }
    }
}

impl<T> Index<(usize, usize)> for Matrix<T> {
    type Output = T;

    fn index(&self, (row, column): (usize, usize)) -> &T {
        &self.entries[row * self.columns + column]
    }
}

impl<T> IndexMut<(usize, usize)> for Matrix<T> {
    fn index_mut(&mut self, (row, column): (usize, usize)) -> &mut T {
        &mut self.entries[row * self.columns + column]
    }
}

/// Σ a_i b_i, the terms with an exact zero in `a` left out; `None` if none is left.
fn sum<'a, T: Real + 'a>(a: &[T], b: impl Iterator<Item = &'a T>) -> Option<T> {
    a.iter().zip(b).filter(|(a, _)| a.sign() != Some(Sign::Zero)).fold(None, |total, (a, b)| {
        let term = a.clone() * b;
        Some(total.map_or(term.clone(), |total| total + &term))
    })
}

/// The inner product of two vectors, `zero` where every term has an exact zero in `a`.
pub(super) fn dot<'a, T: Real + 'a>(a: &[T], b: impl IntoIterator<Item = &'a T>, zero: &T) -> T {
    sum(a, b.into_iter()).unwrap_or_else(|| zero.clone())
}

impl<T: Scalar> Matrix<T> {
    /// The identity.
    pub(crate) fn identity(size: usize, context: &T::Context) -> Self {
        let entry = |i, j| T::integer(i32::from(i == j), context);
        Matrix::from_rows((0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect())
    }

    /// The product with another matrix. Cost: rows × columns × other columns multiplications.
    pub(crate) fn times(&self, other: &Self, context: &T::Context) -> Self {
        let zero = T::integer(0, context);
        let entry = |i, j| dot(self.row(i), other.entries.iter().skip(j).step_by(other.columns), &zero);
        Matrix::from_rows(
            (0..self.rows()).map(|i| (0..other.columns).map(|j| entry(i, j)).collect()).collect(),
        )
    }

    /// The product with a vector.
    pub(crate) fn apply(&self, vector: &[T], context: &T::Context) -> Vec<T> {
        let zero = T::integer(0, context);
        (0..self.rows()).map(|i| dot(self.row(i), vector, &zero)).collect()
    }
}

/// Why an elimination stopped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Failure {
    /// The columns are certainly dependent.
    Singular,
    /// No pivot is certainly different from zero: more bits, or narrower entries, might show one.
    Unknown,
}

/// Makes columns `from..to` of the rows upper triangular by row operations, with pivots that are certainly
/// not zero: the first `to − from` rows then hold the triangle. Cost: O((to − from)·rows·width).
///
/// # Errors
/// [`Failure`], the rows left in a state without meaning.
pub(super) fn eliminate<T: Scalar>(rows: &mut [Vec<T>], from: usize, to: usize) -> Result<(), Failure> {
    for column in from..to {
        let top = column - from;
        let best =
            (top..rows.len()).filter_map(|i| Some((rows[i][column].pivot()?, i))).max_by_key(|&(p, _)| p);
        let Some((_, best)) = best else {
            let zero = rows[top..].iter().all(|row| row[column].sign() == Some(Sign::Zero));
            return Err(if zero { Failure::Singular } else { Failure::Unknown });
        };
        rows.swap(top, best);
        let (head, tail) = rows.split_at_mut(top + 1);
        let pivot_row = &head[top];
        for row in tail {
            if row[column].sign() == Some(Sign::Zero) {
                continue;
            }
            let factor = row[column].clone() / &pivot_row[column];
            for (entry, above) in row[column + 1..].iter_mut().zip(&pivot_row[column + 1..]) {
                if above.sign() != Some(Sign::Zero) {
                    *entry = entry.clone() - &(factor.clone() * above);
                }
            }
        }
    }
    Ok(())
}

/// Solves the triangle that [`eliminate`] left in the first `to − from` rows; `rest(row)` is its right side.
pub(super) fn back_substitute<T: Scalar>(
    rows: &[Vec<T>],
    from: usize,
    to: usize,
    rest: impl Fn(&[T]) -> T,
) -> Vec<T> {
    let mut found: Vec<T> = Vec::with_capacity(to - from);
    for column in (from..to).rev() {
        let row = &rows[column - from];
        let mut value = rest(row);
        // `found` runs from the last column down.
        for (coefficient, x) in row[column + 1..to].iter().rev().zip(&found) {
            if coefficient.sign() != Some(Sign::Zero) {
                value = value - &(coefficient.clone() * x);
            }
        }
        found.push(value / &row[column]);
    }
    found.reverse();
    found
}

/// Whether a square matrix is certainly invertible: the error says how it is not.
///
/// # Errors
/// [`Failure::Singular`] if it certainly is not, [`Failure::Unknown`] if it may not be.
pub(super) fn certainly_invertible<T: Scalar>(matrix: &Matrix<T>) -> Result<(), Failure> {
    let mut rows: Vec<Vec<T>> = (0..matrix.rows()).map(|i| matrix.row(i).to_vec()).collect();
    eliminate(&mut rows, 0, matrix.columns())
}
