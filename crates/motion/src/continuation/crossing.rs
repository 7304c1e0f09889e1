//! Where two curves of solutions cross: the point to rounding, and both tangents.
//!
//! There the Jacobian J of F (n equations, n + 1 unknowns u) has rank n − 1, so Newton's method on F alone
//! loses half the digits. The system F(u) + µψ = 0, J(u)ᵀψ = 0, |ψ|² = 1 in (u, µ, ψ) is regular at a simple
//! crossing and gives it with µ = 0 (G. Moore, SIAM J. Numer. Anal. 17 (1980) 567–576). The tangents are the
//! roots of the quadratic form ψ·F″ on J's kernel.

use super::curve::{Curve, CurvePoint, difference, dot, largest, norm};
use crate::{
    error::{Error, Result},
    motion::algebra::solve,
};

/// A point where curves cross.
#[derive(Debug, Clone)]
pub(crate) struct Crossing {
    /// The point, its tangent that of the curve it was found on.
    pub place: CurvePoint,
    /// The unit tangent of the other curve.
    pub other: Vec<f64>,
}

/// The step of central differences, the cube root of the rounding error: their error then is of the order of
/// 10⁻¹⁰. Of J it slows Newton's method, and moves no root.
pub(super) const DIFFERENCE: f64 = 6e-6;

/// A crossing is this near to where it was looked for.
const NEAR: f64 = 1e-2;

/// Newton's method does not come back from so far, where motions may take ever longer to follow.
const ASTRAY: f64 = 1.0;

/// Whether J is so nearly of rank n − 1 at a point that curves cross there or close by: the least singular
/// value of J with the tangent, to within a factor √n.
pub(crate) fn is_near(curve: &impl Curve, place: &CurvePoint) -> Result<bool> {
    let mut matrix = curve.equations(&place.u)?.jacobian;
    let scale = matrix.iter().fold(1.0, |most: f64, row| most.max(largest(row)));
    matrix.push(place.tangent.clone());
    let right = generic(place.u.len());
    Ok(solve(matrix, right).is_none_or(|x| norm(&x) * 1e-5 * scale >= 1.0))
}

/// The crossing near a point of one of the curves. Cost: 2(n + 1) evaluations for each of a few Newton steps,
/// O(n³).
///
/// # Errors
/// An input error if there is none: Newton's method does not end, or the tangents are not two.
pub(crate) fn locate(curve: &impl Curve, near: &CurvePoint) -> Result<Crossing> {
    let failed = || Error::input("no crossing of two branches here");
    let size = near.u.len();
    let n = size - 1;
    let jacobian = curve.equations(&near.u)?.jacobian;
    let mut psi = left_kernel(&jacobian).ok_or_else(failed)?;
    let (mut u, mut mu, mut last) = (near.u.clone(), 0.0, f64::INFINITY);
    for steps in 1..=12 {
        let here = curve.equations(&u)?;
        let pulled = transposed(&here.jacobian, &psi);
        let mut right: Vec<f64> = here.residual.iter().zip(&psi).map(|(f, psi)| f + mu * psi).collect();
        right.extend(&pulled);
        right.push(dot(&psi, &psi) - 1.0);
        // Rows: F + µψ; Jᵀψ; |ψ|². Columns: u, µ, ψ.
        let mut matrix = vec![vec![0.0; 2 * n + 2]; 2 * n + 2];
        for (i, (row, &weight)) in here.jacobian.iter().zip(&psi).enumerate() {
            matrix[i][..size].copy_from_slice(row);
            matrix[i][size] = weight;
            matrix[i][size + 1 + i] = mu;
            matrix[2 * n + 1][size + 1 + i] = 2.0 * weight;
            for (j, &entry) in row.iter().enumerate() {
                matrix[n + j][size + 1 + i] = entry;
            }
        }
        for j in 0..size {
            let mut along = vec![0.0; size];
            along[j] = 1.0;
            let bent = bend(curve, &u, &along)?;
            for (k, value) in transposed(&bent, &psi).into_iter().enumerate() {
                matrix[n + k][j] = value;
            }
        }
        let step = solve(matrix, right).ok_or_else(failed)?;
        u.iter_mut().zip(&step).for_each(|(u, step)| *u -= step);
        mu -= step[size];
        psi.iter_mut().zip(&step[size + 1..]).for_each(|(psi, step)| *psi -= step);
        let length = norm(&step);
        if norm(&difference(&u, &near.u)) > ASTRAY {
            return Err(failed());
        }
        if length <= 1e-13 || (length <= 1e-9 && length >= last / 2.0) {
            let residual = largest(&curve.equations(&u)?.residual);
            if residual > 1e-10 || norm(&difference(&u, &near.u)) > NEAR {
                return Err(failed());
            }
            let [tangent, other] = tangents(curve, &u, &psi, &near.tangent)?;
            return Ok(Crossing { place: CurvePoint { u, tangent, residual, steps }, other });
        }
        last = length;
    }
    Err(failed())
}

/// The tangents of the two curves: the one nearer to `along` first, both pointing its way as far as they do.
fn tangents(curve: &impl Curve, u: &[f64], psi: &[f64], along: &[f64]) -> Result<[Vec<f64>; 2]> {
    let failed = || Error::input("the branches that cross here have no two tangents");
    let jacobian = curve.equations(u)?.jacobian;
    let second = kernel(&jacobian, along).ok_or_else(failed)?;
    let first = kernel(&jacobian, &second).ok_or_else(failed)?;
    let form = |bent: &[Vec<f64>], x: &[f64]| -> f64 {
        bent.iter().zip(psi).map(|(row, psi)| psi * dot(row, x)).sum()
    };
    let (by_first, by_second) = (bend(curve, u, &first)?, bend(curve, u, &second)?);
    let (a, b, c) = (form(&by_first, &first), form(&by_second, &first), form(&by_second, &second));
    // a α² + 2b αβ + c β² = 0: the root of larger modulus of α/β or β/α without cancellation, the other from
    // the product.
    let discriminant = b * b - a * c;
    if discriminant.is_nan() || discriminant <= 0.0 {
        return Err(failed());
    }
    let far = -(b + discriminant.sqrt().copysign(b));
    let roots = [[far, a], [c, far]];
    let mut found = roots.map(|[alpha, beta]| {
        let mut x: Vec<f64> = first.iter().zip(&second).map(|(x, y)| alpha * x + beta * y).collect();
        let length = norm(&x).copysign(dot(&x, along));
        x.iter_mut().for_each(|x| *x /= length);
        x
    });
    if dot(&found[0], along) < dot(&found[1], along) {
        found.swap(0, 1);
    }
    if found.iter().flatten().all(|x| x.is_finite()) { Ok(found) } else { Err(failed()) }
}

/// The derivative of J along a direction, by central differences.
fn bend(curve: &impl Curve, u: &[f64], along: &[f64]) -> Result<Vec<Vec<f64>>> {
    let at = |by: f64| {
        let u: Vec<f64> = u.iter().zip(along).map(|(u, along)| u + by * along).collect();
        Ok::<_, Error>(curve.equations(&u)?.jacobian)
    };
    let (ahead, behind) = (at(DIFFERENCE)?, at(-DIFFERENCE)?);
    let rows = ahead.iter().zip(&behind);
    Ok(rows.map(|(a, b)| a.iter().zip(b).map(|(a, b)| (a - b) / (2.0 * DIFFERENCE)).collect()).collect())
}

/// The unit vector of J's kernel that is normal to `row`, where the kernel is two-dimensional.
pub(super) fn kernel(jacobian: &[Vec<f64>], row: &[f64]) -> Option<Vec<f64>> {
    let [a, b]: [Vec<f64>; 2] = null_space(jacobian, 2)?.try_into().ok()?;
    let (along_a, along_b) = (dot(row, &a), dot(row, &b));
    unit(a.iter().zip(&b).map(|(a, b)| a * along_b - b * along_a).collect())
}

/// The unit vector ψ with ψᵀJ = 0, where J has one row more than its rank.
fn left_kernel(jacobian: &[Vec<f64>]) -> Option<Vec<f64>> {
    let columns = jacobian.first().map_or(0, Vec::len);
    let turned: Vec<Vec<f64>> = (0..columns).map(|j| jacobian.iter().map(|row| row[j]).collect()).collect();
    unit(null_space(&turned, 1)?.pop()?)
}

fn unit(mut x: Vec<f64>) -> Option<Vec<f64>> {
    let length = norm(&x);
    x.iter_mut().for_each(|x| *x /= length);
    x.iter().all(|x| x.is_finite()).then_some(x)
}

/// A basis of the kernel of a matrix that is known to have this dimension, each vector of length 1: Gaussian
/// elimination with complete pivoting, ended when the rank is reached; what is left then counts as 0. Cost:
/// O(n³).
fn null_space(matrix: &[Vec<f64>], dimension: usize) -> Option<Vec<Vec<f64>>> {
    let mut a = matrix.to_vec();
    let columns = a.first()?.len();
    let rank = columns.checked_sub(dimension)?;
    let mut order: Vec<usize> = (0..columns).collect();
    for k in 0..rank {
        let places = (k..a.len()).flat_map(|i| (k..columns).map(move |j| (i, j)));
        let (i, j) =
            places.max_by(|&(i, j), &(k, l)| a[i][order[j]].abs().total_cmp(&a[k][order[l]].abs()))?;
        a.swap(k, i);
        order.swap(k, j);
        let (done, rest) = a.split_at_mut(k + 1);
        let (pivot, row) = (done[k][order[k]], &done[k]);
        if pivot == 0.0 || !pivot.is_finite() {
            return None;
        }
        for other in rest {
            let factor = other[order[k]] / pivot;
            other.iter_mut().zip(row).for_each(|(x, y)| *x -= factor * y);
        }
    }
    (rank..columns)
        .map(|free| {
            let mut x = vec![0.0; columns];
            x[order[free]] = 1.0;
            for k in (0..rank).rev() {
                let known: f64 = (k + 1..columns).map(|j| a[k][order[j]] * x[order[j]]).sum();
                x[order[k]] = -known / a[k][order[k]];
            }
            unit(x)
        })
        .collect()
}

/// A vector that is not normal to anything it meets.
fn generic(size: usize) -> Vec<f64> {
    (0..size).map(|i| 1.0 / (1.0 + i as f64)).collect()
}

/// Jᵀψ.
fn transposed(jacobian: &[Vec<f64>], psi: &[f64]) -> Vec<f64> {
    let size = jacobian.first().map_or(0, Vec::len);
    (0..size).map(|j| jacobian.iter().zip(psi).map(|(row, psi)| row[j] * psi).sum()).collect()
}
