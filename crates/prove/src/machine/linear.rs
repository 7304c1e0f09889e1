//! Small matrices of any kind of number, and their exponential, without any guarantee on the rest of its
//! series.

use crate::number::{Real, Sign};

/// Rows.
pub(super) type Matrix<T> = Vec<Vec<T>>;

/// The n × n identity.
pub(super) fn identity<T: Real>(n: usize, context: &T::Context) -> Matrix<T> {
    (0..n).map(|i| (0..n).map(|j| T::integer(i32::from(i == j), context)).collect()).collect()
}

/// a · b.
pub(super) fn dot<T: Real>(a: &[T], b: &[T], context: &T::Context) -> T {
    let zero = T::integer(0, context);
    a.iter().zip(b).fold(zero, |sum, (x, y)| if is_zero(x) { sum } else { sum + &(x.clone() * y) })
}

/// a v.
pub(super) fn apply<T: Real>(a: &Matrix<T>, v: &[T], context: &T::Context) -> Vec<T> {
    a.iter().map(|row| dot(row, v, context)).collect()
}

/// a b.
pub(super) fn times<T: Real>(a: &Matrix<T>, b: &Matrix<T>, context: &T::Context) -> Matrix<T> {
    let columns = b.first().map_or(0, Vec::len);
    let row = |row: &Vec<T>| {
        let mut sums = vec![T::integer(0, context); columns];
        for (x, other) in row.iter().zip(b).filter(|(x, _)| !is_zero(*x)) {
            for (sum, y) in sums.iter_mut().zip(other) {
                *sum = sum.clone() + &(x.clone() * y);
            }
        }
        sums
    };
    a.iter().map(row).collect()
}

fn is_zero<T: Real>(x: &T) -> bool {
    x.sign() == Some(Sign::Zero)
}

/// exp(ta) by its power series to `terms` terms, for the norm of ta given, halved until it is at most 1/4.
pub(super) fn exp<T: Real>(a: &Matrix<T>, t: &T, norm: f64, terms: i32, context: &T::Context) -> Matrix<T> {
    let n = a.len();
    let halvings = if norm > 0.25 && norm < 1e15 { (norm * 4.0).log2().ceil() as u32 } else { 0 };
    let half = T::integer(1, context) / &T::integer(2, context);
    let t = (0..halvings).fold(t.clone(), |t, _| t * &half);
    let x: Matrix<T> = a.iter().map(|row| row.iter().map(|x| x.clone() * &t).collect()).collect();
    let mut sum = identity(n, context);
    for k in (1..=terms).rev() {
        let (product, k) = (times(&x, &sum, context), T::integer(k, context));
        sum = identity(n, context);
        for (row, terms) in sum.iter_mut().zip(product) {
            for (one, term) in row.iter_mut().zip(terms) {
                *one = one.clone() + &(term / &k);
            }
        }
    }
    (0..halvings).fold(sum, |power, _| times(&power, &power, context))
}

/// The inverse by Gauss and Jordan with partial pivoting; `None` if it is singular. `size` tells how large a
/// pivot is.
pub(super) fn inverse<T: Real>(
    a: &Matrix<T>,
    size: impl Fn(&T) -> f64,
    context: &T::Context,
) -> Option<Matrix<T>> {
    let n = a.len();
    let mut rows: Matrix<T> =
        a.iter().zip(identity(n, context)).map(|(row, one)| [row.clone(), one].concat()).collect();
    for column in 0..n {
        let pivot = (column..n)
            .max_by(|&i, &j| size(&rows[i][column]).total_cmp(&size(&rows[j][column])))
            .filter(|&i| size(&rows[i][column]) > 0.0)?;
        rows.swap(column, pivot);
        let scale = rows[column][column].clone();
        rows[column] = rows[column].iter().map(|x| x.clone() / &scale).collect();
        let above = rows[column].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != column) {
            let factor = row[column].clone();
            for (x, p) in row.iter_mut().zip(&above) {
                *x = x.clone() - &(factor.clone() * p);
            }
        }
    }
    Some(rows.into_iter().map(|row| row[n..].to_vec()).collect())
}
