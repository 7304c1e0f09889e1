//! Matrices of intervals: products, elimination, the exponential.

use super::super::motion::Interval;

/// A column.
pub(super) type Vector = Vec<Interval>;
/// Rows.
pub(super) type Matrix = Vec<Vector>;

/// The terms of the power series after which, with a norm up to 1/4, the rest is below
/// 4⁻²¹/21! · 4/3 < 2⁻¹⁰⁶, far less than a unit.
const TERMS: i128 = 20;
/// The most halvings of a time: more of them than the bits that a coarse middle leaves free would lose
/// digits.
const HALVINGS: u32 = 40;

/// The n × n identity.
pub(super) fn identity(n: usize) -> Matrix {
    let entry = |i, j| if i == j { Interval::ONE } else { Interval::ZERO };
    (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
}

/// a b.
pub(super) fn times(a: &Matrix, b: &Matrix) -> Matrix {
    let columns = b.first().map_or(0, Vec::len);
    let row = |row: &Vector| {
        let mut sums = vec![Interval::ZERO; columns];
        for (&x, other) in row.iter().zip(b) {
            if x != Interval::ZERO {
                sums.iter_mut().zip(other).for_each(|(sum, &y)| *sum = *sum + x * y);
            }
        }
        sums
    };
    a.iter().map(row).collect()
}

/// a v.
pub(super) fn apply(a: &Matrix, v: &[Interval]) -> Vector {
    a.iter().map(|row| dot(row, v)).collect()
}

/// a · b.
pub(super) fn dot(a: &[Interval], b: &[Interval]) -> Interval {
    a.iter().zip(b).fold(Interval::ZERO, |sum, (&x, &y)| sum + x * y)
}

/// a + b.
pub(super) fn sum(a: &[Interval], b: &[Interval]) -> Vector {
    a.iter().zip(b).map(|(&x, &y)| x + y).collect()
}

/// a − b.
pub(super) fn difference(a: &[Interval], b: &[Interval]) -> Vector {
    a.iter().zip(b).map(|(&x, &y)| x - y).collect()
}

/// c v.
pub(super) fn scaled(c: Interval, v: &[Interval]) -> Vector {
    v.iter().map(|&x| c * x).collect()
}

/// The greatest sum of magnitudes in a row, as a point: the norm that goes with the maximum norm of vectors.
pub(super) fn norm(a: &Matrix) -> Interval {
    let known = |x: Interval| x.magnitude_bits().is_some();
    let row = |row: &Vector| row.iter().fold(Interval::ZERO, |sum, x| sum + x.magnitude());
    a.iter().map(row).fold(Interval::ZERO, |most, x| if !known(most) || x.is_up_to(most) { most } else { x })
}

/// What Gauss and Jordan's elimination finds.
pub(super) struct Solved {
    /// a⁻¹ b.
    pub solution: Matrix,
    /// det a.
    pub determinant: Interval,
    /// Whether every pivot is positive. Without exchanges of rows, and if a is symmetric: whether it is
    /// positive definite.
    pub positive: bool,
}

/// Solves a x = b for every enclosed a and b; `None` where a may be singular, as far as the intervals tell.
/// With `exchange` the row whose entry is the least likely to be 0 is taken for each column, else the next.
pub(super) fn solve(a: &Matrix, b: &Matrix, exchange: bool) -> Option<Solved> {
    let n = a.len();
    let (mut left, mut right) = (a.clone(), b.clone());
    let (mut determinant, mut positive) = (Interval::ONE, true);
    for column in 0..n {
        // An untrusted choice: any row whose entry is certainly not 0 will do.
        let size = |row: &Vector| row[column].middle().magnitude();
        let mut best = column;
        for i in column + 1..n {
            if exchange && size(&left[best]).is_below(size(&left[i])) {
                best = i;
            }
        }
        if best != column {
            left.swap(best, column);
            right.swap(best, column);
            determinant = -determinant;
        }
        let pivot = left[column][column];
        if !pivot.is_positive() && !(-pivot).is_positive() {
            return None;
        }
        positive &= pivot.is_positive();
        determinant = determinant * pivot;
        let over = |row: &Vector| -> Vector { row.iter().map(|&x| x.over(pivot)).collect() };
        (left[column], right[column]) = (over(&left[column]), over(&right[column]));
        let (pivot_left, pivot_right) = (left[column].clone(), right[column].clone());
        for i in (0..n).filter(|&i| i != column) {
            let factor = left[i][column];
            left[i] = difference(&left[i], &scaled(factor, &pivot_left));
            right[i] = difference(&right[i], &scaled(factor, &pivot_right));
        }
    }
    Some(Solved { solution: right, determinant, positive })
}

/// exp(ta) for every enclosed t: a coarse middle apart, so that an interval of t is no wider than it must be
/// and halving the middle loses no digits.
pub(super) fn exp(a: &Matrix, t: Interval) -> Matrix {
    let middle = t.coarse_middle();
    times(&series(a, middle), &series(a, t - middle))
}

/// (exp(ta/2^j))^(2^j) with ‖ta/2^j‖ ≤ 1/4.
fn series(a: &Matrix, t: Interval) -> Matrix {
    let n = a.len();
    let unknown = || vec![vec![Interval::ONE.over(Interval::ZERO); n]; n];
    let (Some(size), Some(most)) = (t.magnitude_bits(), norm(a).magnitude_bits()) else { return unknown() };
    // In units: ‖ta‖ ≤ 2^(size + most − 2·96), wanted at most 2^(−2).
    let halvings = (size + most + 2).saturating_sub(192);
    if halvings > HALVINGS {
        return unknown();
    }
    let t = t.shifted_down(halvings);
    let x: Matrix = a.iter().map(|row| scaled(t, row)).collect();
    // 1 + x (1 + x/2 (1 + x/3 (…))).
    let mut sum = identity(n);
    for k in (1..=TERMS).rev() {
        let product = times(&x, &sum);
        sum = identity(n);
        for (row, terms) in sum.iter_mut().zip(product) {
            row.iter_mut().zip(terms).for_each(|(one, term)| *one = *one + term.divided(k));
        }
    }
    // Every entry of the rest is below its norm.
    sum.iter_mut().flatten().for_each(|entry| *entry = entry.outwards());
    (0..halvings).fold(sum, |power, _| times(&power, &power))
}
