//! How a linear system falls apart: into its real modes, into complex ones, or not at all.
//!
//! Everything is done in coordinates in which the mass is 1, x = Lᵀq with M = L Lᵀ. There K and C are
//! symmetric if they were.
//!
//! 1. Classical damping: an orthogonal U makes both K and C diagonal. U are eigenvectors of K, or, where K
//!    has repeated eigenvalues that C tells apart, of K + θC for a θ that makes coincidences unlikely.
//!    Accepted if what is left beside both diagonals is rounding.
//! 2. Else the state is X = (Dη, η′), x = Uη with U from K's symmetric part and D = diag √max(|K_ii|, 1), in
//!    which an undamped system is a rotation and its eigenvectors are orthonormal. Eigenvectors of the matrix
//!    of X′ = A X by its complex Schur form. Accepted if their condition number is at most [`WORST`]:
//!    rounding is amplified by no more.
//! 3. Else X itself, in one block.

use nalgebra::{Complex, Schur, SymmetricEigen};

use super::{LinearEquations, RealMatrix, RealVector, pair::Pair};
use crate::error::{Error, Result};

/// The worst condition number of complex eigenvectors: with it, some 10⁻¹² of a motion is rounding.
pub(super) const WORST: f64 = 1e4;

/// Coordinates in which a system falls apart.
#[derive(Debug, Clone)]
pub(super) struct Reduction {
    pub shape: Shape,
    /// y from (q, q′): 2n × 2n.
    pub to: RealMatrix,
    /// (q, q′) from y.
    pub from: RealMatrix,
    /// Of the eigenvectors, in balanced coordinates: 1 for real modes.
    pub condition: f64,
}

#[derive(Debug, Clone)]
pub(super) enum Shape {
    /// Real modes.
    Real(Vec<Pair>),
    /// Complex modes, in pairs.
    Complex(Vec<Pair>),
    /// y′ = A y as a whole.
    Whole(RealMatrix),
}

/// C of these ratios in the modes of M and K, by frequency ascending.
pub(super) fn damping(mass: &RealMatrix, stiffness: &RealMatrix, ratios: &[f64]) -> Result<RealMatrix> {
    let n = mass.nrows();
    if ratios.len() != 1 && ratios.len() != n {
        let found = ratios.len();
        return Err(Error::input(format!("damping_ratio has {found} entries; give one for all, or {n}")));
    }
    let zero = RealMatrix::zeros(n, n);
    let still = super::Periodic::constant(RealVector::zeros(n));
    let equations = LinearEquations::new(mass.clone(), zero, stiffness.clone(), still)?;
    let k = equations.per_mass(stiffness);
    if !is_symmetric(&k) {
        return Err(Error::input("damping_ratio needs a symmetric stiffness: write `damping` as a matrix"));
    }
    let (values, u) = eigen(&k)?;
    let floor = 1e-12 * k.norm();
    let mut middle = RealMatrix::zeros(n, n);
    for (i, &s) in values.iter().enumerate() {
        if s < -floor {
            let message =
                "damping_ratio needs a stiffness without negative eigenvalues: write `damping` as a matrix";
            return Err(Error::input(message));
        }
        middle[(i, i)] = 2.0 * ratios[if ratios.len() == 1 { 0 } else { i }] * s.max(0.0).sqrt();
    }
    let lu = equations.root() * u;
    Ok(&lu * middle * lu.transpose())
}

impl Reduction {
    /// # Errors
    /// An input error if an eigenvalue iteration does not end, which finite matrices do not bring about in
    /// practice.
    pub fn new(equations: &LinearEquations) -> Result<Reduction> {
        let (k, c) = (equations.per_mass(&equations.stiffness), equations.per_mass(&equations.damping));
        match classical(&k, &c)? {
            Some(u) => Ok(real(equations, &k, &c, &u)),
            None => general(equations, &k, &c),
        }
    }
}

fn real(equations: &LinearEquations, k: &RealMatrix, c: &RealMatrix, u: &RealMatrix) -> Reduction {
    let n = k.nrows();
    let (shapes, back) = shapes(equations, u);
    let (mut to, mut from) = (RealMatrix::zeros(2 * n, 2 * n), RealMatrix::zeros(2 * n, 2 * n));
    for i in 0..n {
        for part in [0, 1] {
            for j in 0..n {
                to[(2 * i + part, part * n + j)] = back[(i, j)];
                from[(part * n + j, 2 * i + part)] = shapes[(j, i)];
            }
        }
    }
    let quotient = |m: &RealMatrix, i: usize| (u.column(i).transpose() * m * u.column(i))[0];
    let pairs = (0..n).map(|i| Pair::Mode { damping: quotient(c, i), stiffness: quotient(k, i) });
    Reduction { shape: Shape::Real(pairs.collect()), to, from, condition: 1.0 }
}

/// Φ = L⁻ᵀU with q = Φη, and Φ⁻¹ = UᵀLᵀ.
fn shapes(equations: &LinearEquations, u: &RealMatrix) -> (RealMatrix, RealMatrix) {
    let upper = equations.root().transpose();
    let back = u.transpose() * &upper;
    (upper.solve_upper_triangular(u).unwrap_or_else(|| u.clone()), back)
}

/// What is smaller, relative to a matrix's norm, is rounding.
fn rounding(n: usize) -> f64 {
    32.0 * (n as f64).max(2.0) * f64::EPSILON
}

fn is_symmetric(m: &RealMatrix) -> bool {
    (m - m.transpose()).norm() <= rounding(m.nrows()) * m.norm()
}

/// Eigenvalues, ascending, and orthonormal eigenvectors of a symmetric matrix.
pub(super) fn eigen(m: &RealMatrix) -> Result<(Vec<f64>, RealMatrix)> {
    let n = m.nrows();
    let symmetric = (m + m.transpose()) * 0.5;
    if is_diagonal(&symmetric) {
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by(|&a, &b| symmetric[(a, a)].total_cmp(&symmetric[(b, b)]));
        let vectors = RealMatrix::from_fn(n, n, |i, j| f64::from(u8::from(order[j] == i)));
        return Ok((order.iter().map(|&i| symmetric[(i, i)]).collect(), vectors));
    }
    let found = SymmetricEigen::try_new(symmetric, f64::EPSILON, 1_000 * n.max(10));
    let found = found
        .ok_or_else(|| Error::input("the modes of mass and stiffness were not found: are they finite?"))?;
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&a, &b| found.eigenvalues[a].total_cmp(&found.eigenvalues[b]));
    let vectors = RealMatrix::from_fn(n, n, |i, j| found.eigenvectors[(i, order[j])]);
    Ok((order.iter().map(|&i| found.eigenvalues[i]).collect(), vectors))
}

fn is_diagonal(m: &RealMatrix) -> bool {
    (0..m.nrows()).all(|i| (0..m.ncols()).all(|j| i == j || m[(i, j)] == 0.0))
}

/// What stands beside the diagonal of UᵀMU, relative to M.
fn beside(u: &RealMatrix, m: &RealMatrix) -> f64 {
    let mut all = u.transpose() * m * u;
    all.fill_diagonal(0.0);
    all.norm() / m.norm().max(f64::MIN_POSITIVE)
}

/// An orthogonal matrix that makes K and C diagonal, if there is one.
fn classical(k: &RealMatrix, c: &RealMatrix) -> Result<Option<RealMatrix>> {
    if !is_symmetric(k) || !is_symmetric(c) {
        return Ok(None);
    }
    let fits = |u: &RealMatrix| beside(u, k) <= rounding(k.nrows()) && beside(u, c) <= rounding(k.nrows());
    let (_, u) = eigen(k)?;
    if fits(&u) {
        return Ok(Some(u));
    }
    let scale = k.norm() / c.norm();
    if !scale.is_finite() {
        return Ok(None);
    }
    let (_, u) = eigen(&(k + c * (0.618_033_988_749_894_8 * scale)))?;
    Ok(fits(&u).then_some(u))
}

fn general(equations: &LinearEquations, k: &RealMatrix, c: &RealMatrix) -> Result<Reduction> {
    let n = k.nrows();
    let (_, u) = eigen(&((k + k.transpose()) * 0.5))?;
    let (k, c) = (u.transpose() * k * &u, u.transpose() * c * &u);
    let d: Vec<f64> = (0..n).map(|i| k[(i, i)].abs().max(1.0).sqrt()).collect();
    let mut a = RealMatrix::zeros(2 * n, 2 * n);
    for i in 0..n {
        a[(i, n + i)] = d[i];
        for j in 0..n {
            a[(n + i, j)] = -k[(i, j)] / d[j];
            a[(n + i, n + j)] = -c[(i, j)];
        }
    }
    let (shapes, back) = shapes(equations, &u);
    let (mut to, mut from) = (RealMatrix::zeros(2 * n, 2 * n), RealMatrix::zeros(2 * n, 2 * n));
    for i in 0..n {
        for j in 0..n {
            to[(i, j)] = d[i] * back[(i, j)];
            to[(n + i, n + j)] = back[(i, j)];
            from[(j, i)] = shapes[(j, i)] / d[i];
            from[(n + j, n + i)] = shapes[(j, i)];
        }
    }
    match complex(&a) {
        (Some((pairs, vectors, inverse)), condition) => {
            Ok(Reduction { shape: Shape::Complex(pairs), to: inverse * to, from: from * vectors, condition })
        }
        (None, condition) => Ok(Reduction { shape: Shape::Whole(a), to, from, condition }),
    }
}

/// Pairs of modes of X′ = A X with the real basis of each and its inverse, and the condition number of that
/// basis, infinite if there is none.
#[allow(clippy::type_complexity)]
fn complex(a: &RealMatrix) -> (Option<(Vec<Pair>, RealMatrix, RealMatrix)>, f64) {
    let none = (None, f64::INFINITY);
    let n = a.nrows();
    let schur = Schur::try_new(a.map(|x| Complex::new(x, 0.0)), f64::EPSILON, 1_000 * n);
    let Some((q, t)) = schur.map(Schur::unpack) else { return none };
    let small = rounding(n) * a.norm();
    let (mut pairs, mut columns, mut reals) = (Vec::new(), Vec::new(), Vec::new());
    let mut conjugates = 0;
    for k in 0..n {
        let lambda = t[(k, k)];
        if lambda.im < -small {
            conjugates += 1;
            continue;
        }
        let v = eigenvector(&q, &t, k, small);
        if lambda.im > small {
            pairs.push(Pair::Spiral { rate: lambda.re, turn: lambda.im });
            columns.extend([v.map(|x| x.re), v.map(|x| -x.im)]);
        } else {
            // The largest entry made real; the others are real then, up to rounding.
            let largest = v.iter().copied().max_by(|x, y| x.norm().total_cmp(&y.norm())).unwrap_or_default();
            let v = v.map(|x| (x * largest.conj()).re);
            reals.push((lambda.re, v.normalize()));
        }
    }
    if conjugates != pairs.len() || reals.len() % 2 != 0 {
        return none;
    }
    for two in reals.chunks_exact(2) {
        pairs.push(Pair::Two([two[0].0, two[1].0]));
        columns.extend([two[0].1.clone(), two[1].1.clone()]);
    }
    let vectors = RealMatrix::from_columns(&columns);
    let values = vectors.singular_values();
    let condition = values.max() / values.min();
    let Some(inverse) = vectors.clone().try_inverse() else { return none };
    let mut diagonal = RealMatrix::zeros(n, n);
    for (i, pair) in pairs.iter().enumerate() {
        let g = pair.generator();
        for (r, row) in g.iter().enumerate() {
            for (s, x) in row.iter().enumerate() {
                diagonal[(2 * i + r, 2 * i + s)] = *x;
            }
        }
    }
    let off = (a * &vectors - &vectors * diagonal).norm() / a.norm();
    if condition.is_nan() || condition > WORST || off > 1e-11 * condition {
        return (None, condition);
    }
    (Some((pairs, vectors, inverse)), condition)
}

/// The k-th eigenvector by back substitution in the triangle, as long as 1.
fn eigenvector(
    q: &nalgebra::DMatrix<Complex<f64>>,
    t: &nalgebra::DMatrix<Complex<f64>>,
    k: usize,
    small: f64,
) -> nalgebra::DVector<Complex<f64>> {
    let n = t.nrows();
    let mut x = nalgebra::DVector::from_element(n, Complex::new(0.0, 0.0));
    x[k] = Complex::new(1.0, 0.0);
    for i in (0..k).rev() {
        let sum = (i + 1..=k).fold(Complex::new(0.0, 0.0), |sum, j| sum + t[(i, j)] * x[j]);
        let mut gap = t[(i, i)] - t[(k, k)];
        // Equal eigenvalues: the vectors become nearly the same, which the condition number shows, or the sum
        // is zero.
        if gap.norm() < small {
            gap = Complex::new(small.max(f64::MIN_POSITIVE), 0.0);
        }
        x[i] = -sum / gap;
    }
    let v = q * x;
    let norm = v.iter().map(Complex::norm_sqr).sum::<f64>().sqrt();
    v.map(|x| x / norm)
}
