//! The leading-order equations (32) of an impact pattern, solved block by block.
//!
//! In [`Coordinates`] each X_i = (−1, ξ_i) because C X_{i+1} = C A^{n_i} X_i = −1, and Y_i is read off the
//! last row of X_{i+1} = A^{n_i} X_i + B Y_i. What is left are N − 1 equations an impact for ξ_i ∈ R^{N−1},
//!
//! ```text
//! S_i ξ_i + R ξ_{i+1} = f_i     (cyclic in i),
//! ```
//!
//! S_i the rows 2, …, N−1 and 1 of A^{n_i} without their first column, R minus the identity but for a zero in
//! its last place. |det D| of (28) is that of this system. Wright's structured elimination: ξ_2, ξ_3, … are
//! eliminated in turn with row exchanges within two blocks, ξ_1 closes the circle. It fails only if the whole
//! matrix is singular (or an enclosure cannot tell), also where some C A^{n_i} B = 0.

use super::{
    Coordinates, Scalar,
    matrix::{back_substitute, dot, eliminate},
};

pub use super::matrix::Failure;

/// X_i and Y_i of (28), (32).
#[derive(Debug, Clone)]
pub struct Solution<T> {
    /// X_1, …, X_m in the coordinates of [`Coordinates`].
    pub x: Vec<Vec<T>>,
    /// Y_1, …, Y_m.
    pub y: Vec<T>,
}

/// Solves (32) for the pattern `periods`, none of them above the last power of A that is known. On a rung
/// of enclosures the result contains the solution for every map enclosed, and each of these has one. Cost:
/// O(m N³) operations, memory O(m N²).
///
/// # Errors
/// [`Failure`]: det D = 0, or it cannot be told from 0 on this rung.
pub fn solve<T: Scalar>(map: &Coordinates<T>, periods: &[u64]) -> Result<Solution<T>, Failure> {
    let (size, m) = (map.dimension() - 1, periods.len());
    let zero = T::integer(0, map.context());
    let minus_one = T::integer(-1, map.context());
    // A row: ξ_i | ξ_{i+1} | ξ_1 | right side, each part of the width `size` but the last. What is eliminated
    // stands first.
    let (this, after, first) = (0, 1, 2);
    let width = 3 * size + 1;
    // Block i with S_i in the part `own` and R in the part `next`, added up if they are one.
    let block = |n: u64, own: usize, next: usize| -> Vec<Vec<T>> {
        let power = map.power(n);
        let rows = (1..=size).map(|r| {
            // The last row of the block is C A^n X = −1.
            let closing = r == size;
            let source = power.row(if closing { 0 } else { r });
            let mut row = vec![T::integer(0, map.context()); width];
            row[own * size..(own + 1) * size].clone_from_slice(&source[1..]);
            row[width - 1] = source[0].clone();
            if closing {
                row[width - 1] = source[0].clone() + &minus_one;
            } else {
                let entry = &mut row[next * size + r - 1];
                *entry = entry.clone() + &minus_one;
            }
            row
        });
        rows.collect()
    };
    let mut state = block(periods[0], first, if m == 1 { first } else { this });
    let mut triangles = Vec::with_capacity(m);
    for (i, &n) in periods.iter().enumerate().skip(1) {
        state.extend(block(n, this, if i + 1 == m { first } else { after }));
        eliminate(&mut state, 0, size)?;
        let rest = state.split_off(size);
        triangles.push(std::mem::replace(&mut state, rest));
        for row in &mut state {
            for k in 0..size {
                row[k] = std::mem::replace(&mut row[k + size], zero.clone());
            }
        }
    }
    eliminate(&mut state, 2 * size, 3 * size)?;
    let mut unknowns = vec![back_substitute(&state, 2 * size, 3 * size, |row| row[width - 1].clone())];
    // ξ_m, ξ_{m−1}, …, ξ_2, each from ξ_1 and the one after it.
    for rows in triangles.iter().rev() {
        let ends = unknowns[unknowns.len() - 1].iter().chain(&unknowns[0]);
        let found = back_substitute(rows, 0, size, |row| {
            row[width - 1].clone() - &dot(&row[size..3 * size], ends.clone(), &zero)
        });
        unknowns.push(found);
    }
    unknowns[1..].reverse();
    let x: Vec<Vec<T>> =
        unknowns.into_iter().map(|xi| std::iter::once(minus_one.clone()).chain(xi).collect()).collect();
    let y =
        (0..m).map(|i| x[(i + 1) % m][size].clone() - &dot(map.power(periods[i]).row(size), &x[i], &zero));
    Ok(Solution { y: y.collect(), x })
}
