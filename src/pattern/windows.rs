//! Three and more dimensions: which beginnings of a pattern no orbit can have, so that no pattern with one is
//! visited.
//!
//! # Statement
//!
//! Let N ≥ 3 and e ≠ 0. A *window* is a row n₁, …, n_t of periods. Of a pattern that has it, (32) and C X_i =
//! −1 say
//!
//! ```text
//! X_{i+1} = A^{n_i} X_i + B Y_i,   C A^{n_i} X_i = −1   (i ≤ t),
//! ```
//!
//! and an orbit for eµ > 0 needs C A^k X_i + 1 > 0 for 0 < k < n_i and Y_i > 0 (33), (34); for eµ < 0 all of
//! them are below 0. Where C A^{n_{i+1}} B ≠ 0, the second equation at i + 1 gives Y_i, so that all X_i and
//! Y_i of the window are affine in d = N − 2 numbers z, the freedom of X₁. A window is left out for a sign of
//! eµ only if no z makes all its quantities ≥ 0 (≤ 0). A pattern with det D ≠ 0 that has such a window then
//! has a quantity of the wrong sign: Theorem 1 says that it has no orbit for that sign of eµ. Of patterns
//! with det D = 0, where Theorem 1 is silent, those with such a window are left out, too.
//!
//! # Proof that a window has none
//!
//! By Farkas: d + 1 of its quantities a_j·z + b_j, and λ_j ≥ 0, not all 0, with Σ λ_j a_j = 0 and Σ λ_j b_j <
//! 0. Which ones is guessed by linear programming in floats, and warm: what proves nothing for a window is
//! where the search begins for its continuations. The λ are then solved for with enclosures of a_j, one of
//! them being 1, and every sign above is certain; else the window is kept. So a wrong guess costs time alone.

use super::{
    Coordinates, Scalar,
    linear::Basis,
    matrix::{back_substitute, dot, eliminate},
    sequence::Pruning,
};
use crate::number::Sign;

/// The rows of a vector that is affine in z: d coefficients, then the constant.
type Affine<T> = Vec<Vec<T>>;

/// A window, grown and cut at its end.
pub struct Windows<'m, T: Scalar> {
    map: &'m Coordinates<T>,
    /// The quantities of the window, each as a row of an [`Affine`].
    quantities: Vec<Vec<T>>,
    /// The same in floats, scaled so that the greatest coefficient is ±1.
    floats: Vec<Vec<f64>>,
    levels: Vec<Level<T>>,
}

/// What one more period has added.
struct Level<T> {
    /// A^n X; `None` if X is not known as a function of z, and nothing is left out from here on.
    image: Option<Affine<T>>,
    /// The quantities before.
    before: usize,
    /// For eµ > 0 and for eµ < 0 where the search for a proof stands; `None` if the window is left out.
    search: [Option<Basis>; 2],
}

impl<'m, T: Scalar> Windows<'m, T> {
    /// The empty window of a map with N ≥ 3. Cost of each period more: O(N³ + n N²) operations, and a linear
    /// program in N − 1 rows.
    pub(crate) fn new(map: &'m Coordinates<T>) -> Self {
        debug_assert!(map.dimension() >= 3);
        Windows { map, quantities: Vec::new(), floats: Vec::new(), levels: Vec::new() }
    }

    fn free(&self) -> usize {
        self.map.dimension() - 2
    }

    fn number(&self, x: i32) -> T {
        T::integer(x, self.map.context())
    }

    /// X₁ = (−1, ξ) with C A^n X₁ = −1, one entry of ξ eliminated.
    fn first(&self, n: u64) -> Option<Affine<T>> {
        let (row, d) = (self.map.power(n).row(0), self.free());
        let pivot = (1..row.len()).filter_map(|i| Some((row[i].pivot()?, i))).max()?.1;
        let mut x = vec![vec![self.number(0); d + 1]; row.len()];
        x[0][d] = self.number(-1);
        x[pivot][d] = (row[0].clone() - &self.number(1)) / &row[pivot];
        for (z, i) in (1..row.len()).filter(|&i| i != pivot).enumerate() {
            x[i][z] = self.number(1);
            x[pivot][z] = -(row[i].clone() / &row[pivot]);
        }
        Some(x)
    }

    /// X and Y of the impact after W = A^m X, before n iterates: C A^n (W + B Y) = −1.
    fn following(&self, image: &Affine<T>, n: u64) -> Option<(Affine<T>, Vec<T>)> {
        let response = self.map.response(n);
        response.pivot()?;
        let mut y = self.along(image, n, self.number(1));
        for entry in &mut y {
            *entry = -(entry.clone() / response);
        }
        let mut x = image.clone();
        let last = x.len() - 1;
        for (entry, more) in x[last].iter_mut().zip(&y) {
            *entry = entry.clone() + more;
        }
        Some((x, y))
    }

    /// C A^k X + `more`.
    fn along(&self, x: &Affine<T>, k: u64, more: T) -> Vec<T> {
        let (row, d, zero) = (self.map.power(k).row(0), self.free(), self.number(0));
        let mut sum: Vec<T> = (0..=d).map(|j| dot(row, x.iter().map(|entry| &entry[j]), &zero)).collect();
        sum[d] = sum[d].clone() + &more;
        sum
    }

    /// A^n X, whose first entry is −1.
    fn image(&self, x: &Affine<T>, n: u64) -> Affine<T> {
        let (power, d, zero) = (self.map.power(n), self.free(), self.number(0));
        let column = |j: usize| x.iter().map(move |entry| &entry[j]);
        let row = |i: usize| (0..=d).map(|j| dot(power.row(i), column(j), &zero)).collect();
        let mut image: Affine<T> = (0..x.len()).map(row).collect();
        image[0] = vec![zero.clone(); d + 1];
        image[0][d] = self.number(-1);
        image
    }

    fn add(&mut self, quantity: Vec<T>) {
        let middle = |x: &T| {
            let x = x.enclosure();
            x.lo() + (x.hi() - x.lo()) / 2.0
        };
        let mut row: Vec<f64> = quantity.iter().map(middle).collect();
        let scale = row.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let good = scale.is_finite() && scale > 0.0;
        // What is not known says nothing: 0·z + 1.
        row.iter_mut().for_each(|x| *x = if good { *x / scale } else { 0.0 });
        if !good || row.iter().any(|x| !x.is_finite()) {
            row = vec![0.0; row.len()];
            *row.last_mut().expect("a quantity has a constant") = 1.0;
        }
        self.floats.push(row);
        self.quantities.push(quantity);
    }

    /// Whether these quantities, times ±1, are certainly not all ≥ 0.
    fn refutes(&self, among: &[(usize, f64)], positive: bool) -> bool {
        let d = self.free();
        // The one with the greatest λ in floats gets λ = 1.
        let Some(&(lead, _)) = among.iter().max_by(|a, b| a.1.total_cmp(&b.1)) else { return false };
        let rest: Vec<&Vec<T>> =
            among.iter().filter(|(j, _)| *j != lead).map(|(j, _)| &self.quantities[*j]).collect();
        let lead = &self.quantities[lead];
        let mut rows: Vec<Vec<T>> = (0..d)
            .map(|z| rest.iter().map(|quantity| quantity[z].clone()).chain([-lead[z].clone()]).collect())
            .collect();
        if rest.len() != d || eliminate(&mut rows, 0, d).is_err() {
            return false;
        }
        let lambdas = back_substitute(&rows, 0, d, |row| row[d].clone());
        if lambdas.iter().any(|x| !matches!(x.sign(), Some(Sign::Positive | Sign::Zero))) {
            return false;
        }
        let sum = lambdas.iter().zip(&rest).fold(lead[d].clone(), |sum, (x, of)| sum + &(x.clone() * &of[d]));
        sum.sign() == Some(Sign::Positive.negated_if(positive))
    }

    /// The search for a proof for one sign of eµ, one window further; `None` if there is one.
    fn searched(&self, mut basis: Basis, positive: bool) -> Option<Basis> {
        match basis.improve(&self.floats, if positive { 1.0 } else { -1.0 }) {
            Some(among) if self.refutes(&among, positive) => None,
            _ => Some(basis),
        }
    }
}

impl<T: Scalar> Pruning for Windows<'_, T> {
    fn enter(&mut self, before: Option<u64>, letter: u64) -> bool {
        let count = self.quantities.len();
        let (x, search) = match (before, self.levels.last()) {
            (Some(_), Some(level)) => {
                let next = level.image.as_ref().and_then(|image| self.following(image, letter));
                let search = level.search.clone();
                (
                    next.map(|(x, y)| {
                        self.add(y);
                        x
                    }),
                    search,
                )
            }
            _ => (self.first(letter), [(); 2].map(|()| Some(Basis::new(self.free())))),
        };
        let Some(x) = x else {
            self.levels.push(Level { image: None, before: count, search });
            return true;
        };
        for k in 1..letter {
            let gap = self.along(&x, k, self.number(1));
            self.add(gap);
        }
        let [plus, minus] = search;
        let search = [
            plus.and_then(|basis| self.searched(basis, true)),
            minus.and_then(|basis| self.searched(basis, false)),
        ];
        if search.iter().all(Option::is_none) {
            self.cut(count);
            return false;
        }
        let image = Some(self.image(&x, letter));
        self.levels.push(Level { image, before: count, search });
        true
    }

    fn leave(&mut self) {
        if let Some(level) = self.levels.pop() {
            self.cut(level.before);
        }
    }
}

impl<T: Scalar> Windows<'_, T> {
    fn cut(&mut self, count: usize) {
        self.quantities.truncate(count);
        self.floats.truncate(count);
    }
}
