//! Coordinates in which C reads off the first one and B pushes along the last: the equations shrink from N +
//! 1 to N − 1 unknowns an impact, and none is lost.

use num_rational::BigRational;

use super::{Map, Matrix, Scalar, map::convert};

/// A in coordinates where C = (1, 0, …, 0) and B = (0, …, 0, 1)ᵀ, on one rung, with its powers.
///
/// The change of basis is Q = (e_i/C_i | e_k − (C_k/C_i) e_i, k ≠ i, j | B), Q⁻¹ being explicit too: its
/// first row is C, its last e_jᵀ/B_j. It is (12)–(14) with P = Q⁻¹, so every C A^k B stays what it is.
#[derive(Debug, Clone)]
pub struct Coordinates<T: Scalar> {
    powers: Vec<Matrix<T>>,
    back: Matrix<T>,
    context: T::Context,
}

impl<T: Scalar> Coordinates<T> {
    /// The map on this rung with A⁰, …, A^`last`; `None` if the rung is exact and the map is not.
    ///
    /// An exact map is transformed exactly and rounded once. Cost: O(`last`·N³) multiplications.
    pub fn new(map: &Map, last: u64, context: T::Context) -> Option<Self> {
        let (a, back) = match transform::<BigRational>(map, &()) {
            Some((a, back)) => {
                let round = |x: &BigRational| T::ratio(x, &context);
                (a.map(round), back.map(round))
            }
            None => transform::<T>(map, &context)?,
        };
        let mut powers = vec![Matrix::identity(map.dimension(), &context)];
        for k in 0..last as usize {
            powers.push(a.times(&powers[k], &context));
        }
        Some(Coordinates { powers, back, context })
    }

    /// N.
    pub(crate) fn dimension(&self) -> usize {
        self.back.columns()
    }

    /// What makes numbers of this rung.
    pub(crate) fn context(&self) -> &T::Context {
        &self.context
    }

    /// A^k in these coordinates. Its first row is C A^k, its last column A^k B.
    pub fn power(&self, k: u64) -> &Matrix<T> {
        &self.powers[k as usize]
    }

    /// C A^k B.
    pub(crate) fn response(&self, k: u64) -> &T {
        &self.power(k)[(0, self.dimension() - 1)]
    }

    /// A vector in the coordinates that the map was given in, or in those of its section change P.
    pub(crate) fn original(&self, vector: &[T]) -> Vec<T> {
        self.back.apply(vector, &self.context)
    }
}

/// Q⁻¹ A Q and P Q.
fn transform<T: Scalar>(map: &Map, context: &T::Context) -> Option<(Matrix<T>, Matrix<T>)> {
    let size = map.dimension();
    let (i, j) = map.pivots();
    let a = convert::<T>(map.a(), context)?;
    let vector = |entries: &[super::Entry]| entries.iter().map(|x| x.on(context)).collect::<Option<Vec<T>>>();
    let (b, c) = (vector(map.b())?, vector(map.c())?);
    let number = |x: i32| T::integer(x, context);
    let zeros = || -> Vec<Vec<T>> { vec![vec![number(0); size]; size] };
    let (mut q, mut inverse) = (zeros(), zeros());
    q[i][0] = number(1) / &c[i];
    inverse[0] = c.clone();
    for (row, k) in (0..size).filter(|&k| k != i && k != j).enumerate() {
        q[k][row + 1] = number(1);
        q[i][row + 1] = -(c[k].clone() / &c[i]);
        inverse[row + 1][k] = number(1);
        inverse[row + 1][j] = -(b[k].clone() / &b[j]);
    }
    for k in 0..size {
        q[k][size - 1] = b[k].clone();
    }
    inverse[size - 1][j] = number(1) / &b[j];
    let (q, inverse) = (Matrix::from_rows(q), Matrix::from_rows(inverse));
    let a = inverse.times(&a.times(&q, context), context);
    let back = match map.section() {
        Some(p) => convert::<T>(p, context)?.times(&q, context),
        None => q,
    };
    Some((a, back))
}
