//! Gauss's rule of eight points.

/// On [−1, 1]: the positive nodes, of which each has a negative twin, and their weights. The rule is exact
/// for polynomials up to degree 15.
pub(crate) const GAUSS: [[f64; 2]; 4] = [
    [0.183_434_642_495_649_8, 0.362_683_783_378_362],
    [0.525_532_409_916_329, 0.313_706_645_877_887_27],
    [0.796_666_477_413_626_7, 0.222_381_034_453_374_48],
    [0.960_289_856_497_536_3, 0.101_228_536_290_376_26],
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_up_to_degree_fifteen_are_exact() {
        for degree in 0..8 {
            let sum: f64 = GAUSS.iter().map(|[x, weight]| 2.0 * weight * x.powi(2 * degree)).sum();
            assert!((sum - 2.0 / f64::from(2 * degree + 1)).abs() < 1e-15, "{degree}: {sum}");
        }
    }
}
