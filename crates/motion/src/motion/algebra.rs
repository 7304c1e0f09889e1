//! Plain floating-point linear algebra: 2 × 2 matrices, and one dense system.

/// ∂(q, u) / ∂(q₀, u₀), by rows.
pub(crate) type Matrix2 = [[f64; 2]; 2];

/// I.
pub(crate) const IDENTITY: Matrix2 = [[1.0, 0.0], [0.0, 1.0]];

/// M v.
pub(crate) fn apply(m: &Matrix2, v: [f64; 2]) -> [f64; 2] {
    [m[0][0] * v[0] + m[0][1] * v[1], m[1][0] * v[0] + m[1][1] * v[1]]
}

/// a + b.
pub(crate) fn add(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

/// `factor` a.
pub(crate) fn scale(a: [f64; 2], factor: f64) -> [f64; 2] {
    [a[0] * factor, a[1] * factor]
}

/// a b, of complex numbers.
pub(crate) fn times(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

/// a / b, of complex numbers.
pub(crate) fn divide(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    scale(times(a, [b[0], -b[1]]), 1.0 / (b[0] * b[0] + b[1] * b[1]))
}

/// A B.
pub(crate) fn product(a: &Matrix2, b: &Matrix2) -> Matrix2 {
    let column = |j: usize| apply(a, [b[0][j], b[1][j]]);
    let (first, second) = (column(0), column(1));
    [[first[0], second[0]], [first[1], second[1]]]
}

/// tr a.
pub(crate) fn trace(a: &Matrix2) -> f64 {
    a[0][0] + a[1][1]
}

/// det a.
pub(crate) fn determinant(a: &Matrix2) -> f64 {
    a[0][0] * a[1][1] - a[0][1] * a[1][0]
}

/// m⁻¹; its entries are infinite or no numbers where m is singular.
pub(crate) fn inverse(m: &Matrix2) -> Matrix2 {
    let det = determinant(m);
    [[m[1][1] / det, -m[0][1] / det], [-m[1][0] / det, m[0][0] / det]]
}

/// The x with (I − a) x = b; `None` if I − a is singular.
pub(crate) fn resolve(a: &Matrix2, b: [f64; 2]) -> Option<[f64; 2]> {
    let m = [[1.0 - a[0][0], -a[0][1]], [-a[1][0], 1.0 - a[1][1]]];
    let det = determinant(&m);
    let x = [(m[1][1] * b[0] - m[0][1] * b[1]) / det, (m[0][0] * b[1] - m[1][0] * b[0]) / det];
    x.iter().all(|x| x.is_finite()).then_some(x)
}

/// The x with a x = b by Gaussian elimination with partial pivoting;
/// `None` if a pivot is 0 or no number. Cost: O(n³).
pub(crate) fn solve(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Option<Vec<f64>> {
    let n = b.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()))?;
        a.swap(k, pivot);
        b.swap(k, pivot);
        if a[k][k] == 0.0 || !a[k][k].is_finite() {
            return None;
        }
        let (done, rest) = a.split_at_mut(k + 1);
        for (row, i) in rest.iter_mut().zip(k + 1..) {
            let factor = row[k] / done[k][k];
            if factor != 0.0 {
                row[k..].iter_mut().zip(&done[k][k..]).for_each(|(x, y)| *x -= factor * y);
                b[i] -= factor * b[k];
            }
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - known) / a[k][k];
    }
    b.iter().all(|x| x.is_finite()).then_some(b)
}
