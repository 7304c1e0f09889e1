//! Linear algebra that orbits and local maps share.

use nalgebra::Schur;

use super::{RealMatrix, RealVector};
use crate::{
    continuation::Multipliers,
    error::{Error, Result},
};

/// (q, q′) as one vector.
pub(super) fn stacked(q: &RealVector, u: &RealVector) -> RealVector {
    RealVector::from_iterator(q.len() + u.len(), q.iter().chain(u.iter()).copied())
}

/// Eigenvalues by modulus, the largest first, of a matrix of the given determinant, from which those of a 2 ×
/// 2 matrix are taken without cancellation.
///
/// # Errors
/// A matrix that is not finite.
pub(super) fn eigenvalues(matrix: &RealMatrix, determinant: f64) -> Result<Vec<(f64, f64)>> {
    if matrix.nrows() == 2 {
        return Ok(Multipliers { trace: matrix.trace(), determinant }.values().to_vec());
    }
    if matrix.iter().any(|x| !x.is_finite()) {
        return Err(Error::input("the linearised motion is not finite"));
    }
    let schur = Schur::try_new(matrix.clone(), f64::EPSILON, 1_000 * matrix.nrows());
    let schur = schur.ok_or_else(|| Error::input("the multipliers were not found"))?;
    let mut all: Vec<(f64, f64)> = schur.complex_eigenvalues().iter().map(|x| (x.re, x.im)).collect();
    all.sort_by(|a, b| {
        let size = |x: &(f64, f64)| x.0.hypot(x.1);
        size(b).total_cmp(&size(a)).then(b.1.total_cmp(&a.1))
    });
    Ok(all)
}
