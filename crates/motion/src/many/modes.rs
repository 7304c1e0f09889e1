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
//!    of X′ = A X by its real Schur form, or, where the iteration for that does not end, by the complex one.
//!    Accepted if their condition number is at most [`WORST`]: rounding is amplified by no more.
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
fn complex(a: &RealMatrix) -> (Option<(Vec<Pair>, RealMatrix, RealMatrix)>, f64) {
    let (mut worst, small) = (f64::INFINITY, rounding(a.nrows()) * a.norm());
    for modes in [real_schur, complex_schur] {
        let Some((pairs, vectors)) = modes(a, small).and_then(|all| paired(all, small)) else { continue };
        let values = vectors.singular_values();
        worst = values.max() / values.min();
        if worst.is_nan() || worst > WORST {
            break;
        }
        let Some(inverse) = vectors.clone().try_inverse() else { break };
        let off = (a * &vectors - times_generators(&vectors, &pairs)).norm() / a.norm();
        if off <= 1e-11 * worst {
            return (Some((pairs, vectors, inverse)), worst);
        }
    }
    (None, worst)
}

type ComplexMatrix = nalgebra::DMatrix<Complex<f64>>;

/// Eigenvalues with their eigenvectors as columns, of each pair of conjugates at least the one above the real
/// axis.
type Modes = (Vec<Complex<f64>>, ComplexMatrix);

/// By the real Schur form: of 400 × 400 it takes a fifth of the time of the complex one.
fn real_schur(a: &RealMatrix, small: f64) -> Option<Modes> {
    let n = a.nrows();
    let (q, t) = Schur::try_new(a.clone(), f64::EPSILON, 1_000 * n)?.unpack();
    let (mut values, mut columns) = (Vec::new(), Vec::new());
    let mut k = 0;
    while k < n {
        if k + 1 == n || t[(k + 1, k)] == 0.0 {
            values.push(Complex::new(t[(k, k)], 0.0));
            columns.push(eigenvector(&t, k, &[Complex::new(1.0, 0.0)], values[values.len() - 1], small));
            k += 1;
            continue;
        }
        let [b, c] = [t[(k, k + 1)], t[(k + 1, k)]];
        let (middle, half) = ((t[(k, k)] + t[(k + 1, k + 1)]) / 2.0, (t[(k, k)] - t[(k + 1, k + 1)]) / 2.0);
        let square = half * half + b * c;
        let root = Complex::new(square.max(0.0).sqrt(), (-square).max(0.0).sqrt());
        // A pair off the real axis needs one of its two.
        let both = if root.im > small { &[1.0][..] } else { &[1.0, -1.0] };
        for sign in both {
            let lambda = root * *sign + middle;
            // (block − λ) x = 0 by its row with the larger entry beside the diagonal.
            let x = if b.abs() >= c.abs() {
                [Complex::new(b, 0.0), lambda - t[(k, k)]]
            } else {
                [lambda - t[(k + 1, k + 1)], Complex::new(c, 0.0)]
            };
            values.push(lambda);
            columns.push(eigenvector(&t, k, &x, lambda, small));
        }
        k += 2;
    }
    let part = |of: fn(&Complex<f64>) -> f64| {
        &q * RealMatrix::from_fn(n, columns.len(), |i, j| columns[j].get(i).map_or(0.0, of))
    };
    let (re, im) = (part(|z| z.re), part(|z| z.im));
    Some((values, ComplexMatrix::from_fn(n, columns.len(), |i, j| Complex::new(re[(i, j)], im[(i, j)]))))
}

/// By the complex Schur form, whose iteration ends where that of the real one does not.
fn complex_schur(a: &RealMatrix, small: f64) -> Option<Modes> {
    let n = a.nrows();
    let schur = Schur::try_new(a.map(|x| Complex::new(x, 0.0)), f64::EPSILON, 1_000 * n)?;
    let (q, t) = schur.unpack();
    let values: Vec<Complex<f64>> = (0..n).map(|k| t[(k, k)]).filter(|z| z.im >= -small).collect();
    let mut all = ComplexMatrix::zeros(n, values.len());
    for (j, k) in (0..n).filter(|k| t[(*k, *k)].im >= -small).enumerate() {
        let x = eigenvector(&t, k, &[Complex::new(1.0, 0.0)], values[j], small);
        all.set_column(j, &(q.columns(0, x.len()) * nalgebra::DVector::from_vec(x)));
    }
    Some((values, all))
}

/// The pairs of modes, those off the real axis first, and their real bases.
fn paired((values, vectors): Modes, small: f64) -> Option<(Vec<Pair>, RealMatrix)> {
    let (mut pairs, mut columns, mut reals) = (Vec::new(), Vec::new(), Vec::new());
    for (lambda, v) in values.iter().zip(vectors.column_iter()) {
        let norm = v.iter().map(Complex::norm_sqr).sum::<f64>().sqrt();
        if lambda.im > small {
            pairs.push(Pair::Spiral { rate: lambda.re, turn: lambda.im });
            columns.extend([v.map(|x| x.re / norm), v.map(|x| -x.im / norm)]);
        } else {
            // The largest entry made real; the others are real then, up to rounding.
            let largest = v.iter().copied().max_by(|x, y| x.norm().total_cmp(&y.norm())).unwrap_or_default();
            reals.push((lambda.re, v.map(|x| (x * largest.conj()).re).normalize()));
        }
    }
    if columns.len() + reals.len() != vectors.nrows() || reals.len() % 2 != 0 {
        return None;
    }
    for two in reals.chunks_exact(2) {
        pairs.push(Pair::Two([two[0].0, two[1].0]));
        columns.extend([two[0].1.clone(), two[1].1.clone()]);
    }
    Some((pairs, RealMatrix::from_columns(&columns)))
}

/// V G, G being the generators of the pairs along the diagonal.
fn times_generators(vectors: &RealMatrix, pairs: &[Pair]) -> RealMatrix {
    let mut all = vectors.clone();
    for (i, pair) in pairs.iter().enumerate() {
        let [[a, b], [c, d]] = pair.generator();
        let (first, second) = (vectors.column(2 * i), vectors.column(2 * i + 1));
        all.set_column(2 * i, &(first * a + second * c));
        all.set_column(2 * i + 1, &(first * b + second * d));
    }
    all
}

/// An eigenvector of a triangle, or of one with blocks of two on its diagonal, of which the part `own` in the
/// block from row k on is given, by back substitution: its entries down to there.
fn eigenvector<T: Copy + nalgebra::Scalar>(
    t: &nalgebra::DMatrix<T>,
    k: usize,
    own: &[Complex<f64>],
    lambda: Complex<f64>,
    small: f64,
) -> Vec<Complex<f64>>
where
    Complex<f64>: From<T>,
{
    let at = |i: usize, j: usize| Complex::from(t[(i, j)]);
    let zero = Complex::new(0.0, 0.0);
    let mut x = vec![zero; k + own.len()];
    // What the entries known so far bring about in each row.
    let mut right = vec![zero; k];
    let set = |x: &mut [Complex<f64>], right: &mut [Complex<f64>], j: usize, value: Complex<f64>| {
        x[j] = value;
        for (i, sum) in right.iter_mut().enumerate().take(j) {
            *sum -= at(i, j) * value;
        }
    };
    for (j, value) in own.iter().enumerate() {
        set(&mut x, &mut right, k + j, *value);
    }
    // Equal eigenvalues: the vectors become nearly the same, which the condition number shows, or the sum is
    // zero.
    let least = small.max(f64::MIN_POSITIVE);
    let mut i = k;
    while i > 0 {
        i -= 1;
        if i > 0 && at(i, i - 1) != zero {
            let (a, b, c, d) = (at(i - 1, i - 1) - lambda, at(i - 1, i), at(i, i - 1), at(i, i) - lambda);
            let size = a.norm().max(b.norm()).max(c.norm()).max(d.norm());
            let mut det = a * d - b * c;
            if det.norm() < least * size {
                det = Complex::new(least * size, 0.0);
            }
            let (p, q) = (right[i - 1], right[i]);
            let (first, second) = ((d * p - b * q) / det, (a * q - c * p) / det);
            set(&mut x, &mut right, i, second);
            set(&mut x, &mut right, i - 1, first);
            i -= 1;
            continue;
        }
        let mut gap = at(i, i) - lambda;
        if gap.norm() < least {
            gap = Complex::new(least, 0.0);
        }
        let value = right[i] / gap;
        set(&mut x, &mut right, i, value);
    }
    x
}
