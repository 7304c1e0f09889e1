//! Polynomials whose coefficients are whole numbers, or between two of them where what they are made of is
//! not rational: sums and products. Coefficients by rising powers.

use num_bigint::BigInt;
use num_traits::Zero;

/// A number between two whole ones, which may be one.
pub(crate) type Between = [BigInt; 2];

pub(crate) fn exactly(x: BigInt) -> Between {
    [x.clone(), x]
}

pub(crate) fn is_exact([lo, hi]: &Between) -> bool {
    lo == hi
}

pub(crate) fn is_zero([lo, hi]: &Between) -> bool {
    lo.is_zero() && hi.is_zero()
}

pub(crate) fn negated([lo, hi]: &Between) -> Between {
    [-hi, -lo]
}

pub(crate) fn sum(a: &[Between], b: &[Between]) -> Vec<Between> {
    let part =
        |list: &[Between], i: usize, end: usize| list.get(i).map_or_else(BigInt::zero, |x| x[end].clone());
    (0..a.len().max(b.len())).map(|i| [0, 1].map(|end| part(a, i, end) + part(b, i, end))).collect()
}

pub(crate) fn times(x: &Between, y: &Between) -> Between {
    if is_exact(x) && is_exact(y) {
        return exactly(&x[0] * &y[0]);
    }
    let mut ends = [&x[0] * &y[0], &x[0] * &y[1], &x[1] * &y[0], &x[1] * &y[1]];
    ends.sort_unstable();
    let [lo, .., hi] = ends;
    [lo, hi]
}

/// Of two that are not empty.
pub(crate) fn product(a: &[Between], b: &[Between]) -> Vec<Between> {
    let mut all = vec![exactly(BigInt::zero()); a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            let [lo, hi] = times(x, y);
            all[i + j][0] += lo;
            all[i + j][1] += hi;
        }
    }
    all
}
