//! What rows with friction that stick hold together.
//!
//! Rows may depend on one another: those of two masses on the ground and on each other, of a shaft between
//! two jaws. Then only the sum Σ λ_j w_j of what they hold is known, not each λ_j, and the machine sticks as
//! long as there are λ_j with |λ_j| ≤ F_j that make it up. These sums are a zonotope. Of r independent rows
//! among them, a facet is what r − 1 leave open, a direction n with n·w = 0 for each of these, and says
//!
//!   |n·Σ λ_j w_j| ≤ Σ |n·w_j| F_j.
//!
//! Where the two are equal each row with n·w_j ≠ 0 gives all that it can, so that these slide, all at once
//! and each its own way; the others stick on. A row that no other depends on is a facet of its own.
//!
//! Below, w_j is Σ T_jb w_b of the independent rows b, each row divided by the root of its mobility D_jj, so
//! that n and T have no unit.

use super::{RealMatrix, RealVector, contact::Contacts};
use crate::{
    error::{Error, Result},
    rounding::DIRECTION,
};

/// Most choices of rows that may leave a facet open.
const MOST: u64 = 1000;

/// A facet: what is needed along it and what there is at most, both as accelerations.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Brace {
    /// Independent rows of friction, and what each force, as the acceleration that it prevents, counts.
    pub needed: Vec<(usize, f64)>,
    /// Rows of friction, and what the largest force of each counts, with the sign of its part.
    pub parts: Vec<(usize, f64)>,
}

impl Contacts {
    /// Of some rows of friction the first of which all are combinations.
    pub(crate) fn basis(&self, rubs: &[usize]) -> Vec<usize> {
        if rubs.len() < 2 {
            return rubs.to_vec();
        }
        let (mut basis, mut rows) = (Vec::new(), Vec::new());
        for &j in rubs {
            if self.weights(self.rub_row(j), &rows).is_none() {
                basis.push(j);
                rows.push(self.rub_row(j));
            }
        }
        basis
    }

    /// What bounds the forces of these rows of friction where they stick, in those of their
    /// [`basis`](Self::basis). Cost: O(k^r) for k rows that depend on one another, r of them independent.
    ///
    /// # Errors
    /// Too many rows that depend on one another.
    pub(crate) fn braces(&self, stuck: &[usize]) -> Result<Vec<Brace>> {
        let basis = self.basis(stuck);
        let alone =
            |&j: &usize| Brace { needed: vec![(j, 1.0)], parts: vec![(j, self.mobility(self.rub_row(j)))] };
        if basis.len() == stuck.len() {
            return Ok(stuck.iter().map(alone).collect());
        }
        let rows: Vec<usize> = basis.iter().map(|&b| self.rub_row(b)).collect();
        let root = |j: usize| self.mobility(self.rub_row(j)).sqrt();
        let direction = |&j: &usize| {
            let own = basis.iter().position(|&b| b == j);
            let weights = match own {
                Some(i) => RealVector::from_fn(basis.len(), |other, _| f64::from(u8::from(other == i))),
                None => {
                    self.weights(self.rub_row(j), &rows).unwrap_or_else(|| RealVector::zeros(basis.len()))
                }
            };
            RealVector::from_fn(basis.len(), |i, _| weights[i] * root(basis[i]) / root(j))
        };
        let directions: Vec<RealVector> = stuck.iter().map(direction).collect();
        let shared = |i: usize| {
            let others = stuck.iter().zip(&directions).filter(|(j, _)| **j != basis[i]);
            others.into_iter().any(|(_, direction)| direction[i].abs() > DIRECTION)
        };
        let (together, apart): (Vec<usize>, Vec<usize>) = (0..basis.len()).partition(|&i| shared(i));
        let mut all: Vec<Brace> = apart.iter().map(|&i| alone(&basis[i])).collect();
        // What depends on one another, in the coordinates of the independent rows among it.
        let own: Vec<(usize, RealVector)> = stuck
            .iter()
            .zip(&directions)
            .filter(|(j, _)| apart.iter().all(|&i| basis[i] != **j))
            .map(|(&j, direction)| (j, RealVector::from_fn(together.len(), |i, _| direction[together[i]])))
            .collect();
        let choices = (1..together.len() as u64)
            .fold(1, |sum: u64, i| sum.saturating_mul(own.len() as u64 + 1 - i) / i);
        if choices > MOST {
            return Err(Error::input(format!(
                "{} rows of friction that stick at once depend on one another, {} of them independent: that many are not \
                 followed",
                own.len(),
                together.len()
            )));
        }
        let size = together.iter().map(|&i| root(basis[i])).fold(0.0, f64::max);
        for normal in normals(&own) {
            let needed = together.iter().zip(normal.iter()).filter(|(_, part)| part.abs() > DIRECTION);
            let needed = needed.map(|(&i, part)| (basis[i], part * size / root(basis[i]))).collect();
            let parts = own.iter().map(|(j, direction)| (*j, normal.dot(direction)));
            let parts = parts.filter(|(_, part)| part.abs() > DIRECTION);
            let parts = parts.map(|(j, part)| (j, part * size * root(j))).collect();
            all.push(Brace { needed, parts });
        }
        Ok(all)
    }
}

/// The unit vectors on which as many of these directions as leave one open have no part, each once, of two
/// opposite ones the one whose first component is positive.
fn normals(all: &[(usize, RealVector)]) -> Vec<RealVector> {
    let Some(r) = all.first().map(|known| known.1.len()) else { return Vec::new() };
    let places: Vec<usize> = (0..all.len()).collect();
    let mut found: Vec<RealVector> = Vec::new();
    for some in chosen(&places, r - 1) {
        let matrix = RealMatrix::from_fn(r - 1, r, |i, j| all[some[i]].1[j]);
        let minor = |j: usize| {
            let sign = if j.is_multiple_of(2) { 1.0 } else { -1.0 };
            sign * matrix.clone().remove_column(j).determinant()
        };
        let normal = RealVector::from_fn(r, |j, _| minor(j));
        let long = normal.norm();
        let first = normal.iter().find(|part| part.abs() > DIRECTION * long);
        let Some(first) = first.filter(|_| long > DIRECTION) else { continue };
        let normal = &normal / (long * first.signum());
        if found.iter().all(|known| (known - &normal).amax() > DIRECTION) {
            found.push(normal);
        }
    }
    found
}

/// All choices of `count` of some numbers.
pub(crate) fn chosen(all: &[usize], count: usize) -> Vec<Vec<usize>> {
    match (count, all) {
        (0, _) => vec![Vec::new()],
        (_, []) => Vec::new(),
        (_, [first, rest @ ..]) => {
            let with = chosen(rest, count - 1).into_iter().map(|more| [vec![*first], more].concat());
            with.chain(chosen(rest, count)).collect()
        }
    }
}
