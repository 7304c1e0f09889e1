//! A guess by linear programming in floats: which of many linear quantities cannot all be ≥ 0.
//!
//! For rows a_j·z + b_j the linear program max t with a_j·z + b_j ≥ t has the dual: min Σ λ_j b_j with Σ λ_j
//! a_j = 0, Σ λ_j = 1, λ ≥ 0, whose basic solutions have d + 1 rows. Rows that are added later keep a basis
//! feasible, so that the search goes on where it stood. Nothing here is rigorous: what is found is to be
//! proved by others.

/// Where the search stands: d + 1 of the rows and the inverse of their matrix (a_j; 1).
#[derive(Debug, Clone)]
pub(super) struct Basis {
    rows: Vec<Row>,
    inverse: Vec<Vec<f64>>,
}

#[derive(Debug, Clone, Copy)]
enum Row {
    /// One of those asked about.
    Given(usize),
    /// One of a simplex that contains all z of interest, to begin with.
    Far,
}

/// The size of that simplex: rows are scaled to ±1.
const FAR: f64 = 1e9;
/// What counts as 0.
const SMALL: f64 = 1e-12;
/// The most changes of the basis at one call.
const STEPS: usize = 60;

impl Basis {
    /// That of z_i ≥ −10⁹ and Σ z_i ≤ 10⁹, for d numbers z.
    pub fn new(d: usize) -> Basis {
        // The inverse of the columns (e_i; 1) and (−1, …, −1; 1).
        let part = 1.0 / (d + 1) as f64;
        let entry = |i: usize, j: usize| match j == d {
            true => part,
            false => f64::from(u8::from(i == j)) - part,
        };
        let inverse = (0..=d).map(|i| (0..=d).map(|j| entry(i, j)).collect()).collect();
        Basis { rows: vec![Row::Far; d + 1], inverse }
    }

    /// d + 1 of the rows, each with its λ > 0, with Σ λ_j sign a_j = 0 and Σ λ_j sign b_j < 0, as far as
    /// floats tell; `None` if there seem to be none.
    pub fn improve(&mut self, rows: &[Vec<f64>], sign: f64) -> Option<Vec<(usize, f64)>> {
        let d = self.rows.len() - 1;
        for _ in 0..STEPS {
            let cost = |row: &Row| match row {
                Row::Given(j) => sign * rows[*j][d],
                Row::Far => FAR,
            };
            let costs: Vec<f64> = self.rows.iter().map(cost).collect();
            let lambda = |i: usize| self.inverse[i][d];
            if (0..=d).map(|i| lambda(i) * costs[i]).sum::<f64>() < -SMALL {
                let given = self.rows.iter().enumerate().map(|(i, row)| match row {
                    Row::Given(j) => Some((*j, lambda(i))),
                    Row::Far => None,
                });
                if let Some(given) = given.collect::<Option<Vec<_>>>() {
                    return Some(given);
                }
            }
            // z = −y, and the least quantity there.
            let y: Vec<f64> = (0..=d).map(|k| (0..=d).map(|i| costs[i] * self.inverse[i][k]).sum()).collect();
            let at =
                |row: &Vec<f64>| sign * (row[d] - row[..d].iter().zip(&y).map(|(a, y)| a * y).sum::<f64>());
            let (least, entering) =
                rows.iter().enumerate().map(|(j, row)| (at(row), j)).min_by(|a, b| a.0.total_cmp(&b.0))?;
            if least >= 0.0 || least - y[d] >= -SMALL {
                return None;
            }
            let column: Vec<f64> = (0..=d)
                .map(|i| {
                    let along: f64 = (0..d).map(|k| self.inverse[i][k] * sign * rows[entering][k]).sum();
                    along + self.inverse[i][d]
                })
                .collect();
            let leaving = (0..=d)
                .filter(|&i| column[i] > SMALL)
                .min_by(|&i, &j| (lambda(i) / column[i]).total_cmp(&(lambda(j) / column[j])))?;
            self.exchange(leaving, entering, &column);
        }
        None
    }

    fn exchange(&mut self, leaving: usize, entering: usize, column: &[f64]) {
        self.rows[leaving] = Row::Given(entering);
        for entry in &mut self.inverse[leaving] {
            *entry /= column[leaving];
        }
        let pivot = self.inverse[leaving].clone();
        for (i, row) in self.inverse.iter_mut().enumerate().filter(|(i, _)| *i != leaving) {
            for (entry, pivot) in row.iter_mut().zip(&pivot) {
                *entry -= column[i] * pivot;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_that_exclude_each_other_are_found() {
        // z ≥ 1, z ≤ 2; then z ≤ 1/2, too.
        let mut rows = vec![vec![1.0, -1.0], vec![-1.0, 2.0]];
        let mut basis = Basis::new(1);
        assert!(basis.improve(&rows, 1.0).is_none());
        rows.push(vec![-1.0, 0.5]);
        let mut found = basis.improve(&rows, 1.0).unwrap();
        found.sort_by_key(|row| row.0);
        assert_eq!(found.iter().map(|row| row.0).collect::<Vec<_>>(), [0, 2]);
        // With the other sign: z ≤ 1 and z ≥ 2.
        let mut found = Basis::new(1).improve(&rows, -1.0).unwrap();
        found.sort_by_key(|row| row.0);
        assert_eq!(found.iter().map(|row| row.0).collect::<Vec<_>>(), [0, 1]);
    }

    #[test]
    fn a_triangle_turned_inside_out_is_found() {
        // x ≥ 1, y ≥ 1, x + y ≤ 1, and rows that do not matter.
        let rows = vec![
            vec![0.0, 0.0, 1.0],
            vec![1.0, 0.0, -1.0],
            vec![1.0, 1.0, 5.0],
            vec![0.0, 1.0, -1.0],
            vec![-1.0, -1.0, 1.0],
        ];
        let mut found = Basis::new(2).improve(&rows, 1.0).unwrap();
        found.sort_by_key(|row| row.0);
        assert_eq!(found.iter().map(|row| row.0).collect::<Vec<_>>(), [1, 3, 4]);
        assert!(Basis::new(2).improve(&rows[..4], 1.0).is_none());
    }
}
