//! Functions of multipliers, complex ones with their conjugates, whose zeros are bifurcations and points
//! where two of them meet.

/// Products are kept between these in modulus: with hundreds of multipliers they might leave the range of
/// floats, and only signs would be lost.
const RANGE: (f64, f64) = (1e-290, 1e290);

/// Π (1 ± λ), one factor |1 ± λ|² for each complex pair.
pub(crate) fn product(multipliers: &[(f64, f64)], sign: f64) -> f64 {
    multipliers.iter().filter(|(_, im)| *im >= 0.0).fold(1.0, |all: f64, &(re, im)| {
        let factor = if im > 0.0 { (1.0 + sign * re).powi(2) + im * im } else { 1.0 + sign * re };
        let next = all * factor;
        if next == 0.0 { next } else { next.abs().clamp(RANGE.0, RANGE.1).copysign(next) }
    })
}

/// Σ_i Π_{j ≠ i} (1 ± λ_j): where one multiplier is ∓1 the product over the others, and smooth where another
/// joins it.
pub(crate) fn product_of_others(multipliers: &[(f64, f64)], sign: f64) -> f64 {
    // (product, sum of products without one) over factors, conjugates together: (a + ib)(a − ib) and its
    // derivative 2a.
    let (_, sum) =
        multipliers.iter().filter(|(_, im)| *im >= 0.0).fold((1.0, 0.0), |(all, sum), &(re, im)| {
            let a = 1.0 + sign * re;
            if im > 0.0 {
                (all * (a * a + im * im), sum * (a * a + im * im) + all * 2.0 * a)
            } else {
                (all * a, sum * a + all)
            }
        });
    sum
}

/// Two multipliers that are complex conjugates, or real.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MultiplierPair {
    /// Whether they are complex.
    pub complex: bool,
    /// 1 − λ_iλ_j.
    pub off: f64,
    /// λ_i + λ_j.
    pub sum: f64,
}

/// The complex pairs, and all pairs of real ones.
pub(crate) fn pairs(multipliers: &[(f64, f64)]) -> impl Iterator<Item = MultiplierPair> + '_ {
    let complex = multipliers.iter().filter(|(_, im)| *im > 0.0).map(|&(re, im)| MultiplierPair {
        complex: true,
        off: 1.0 - (re * re + im * im),
        sum: 2.0 * re,
    });
    let real: Vec<f64> = multipliers.iter().filter(|(_, im)| *im == 0.0).map(|(re, _)| *re).collect();
    let two = (0..real.len()).flat_map(move |i| {
        let real = real.clone();
        (0..i).map(move |j| MultiplierPair {
            complex: false,
            off: 1.0 - real[i] * real[j],
            sum: real[i] + real[j],
        })
    });
    complex.chain(two)
}

impl MultiplierPair {
    /// The two.
    pub fn both(&self) -> [(f64, f64); 2] {
        let (half, product) = (self.sum / 2.0, 1.0 - self.off);
        let square = half * half - product;
        if self.complex {
            let im = (-square).max(0.0).sqrt();
            [(half, im), (half, -im)]
        } else {
            let root = square.max(0.0).sqrt();
            [(half + root, 0.0), (half - root, 0.0)]
        }
    }
}

/// The multipliers but for those nearest to these.
pub(crate) fn without(multipliers: &[(f64, f64)], these: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut all = multipliers.to_vec();
    for (re, im) in these {
        let off = |one: &(f64, f64)| (one.0 - re).hypot(one.1 - im);
        if let Some(i) = (0..all.len()).min_by(|&i, &j| off(&all[i]).total_cmp(&off(&all[j]))) {
            all.remove(i);
        }
    }
    all
}

/// Π (1 − λ_iλ_j) over all pairs i < j: where two complex multipliers pass the unit circle it changes sign.
pub(crate) fn pairs_product(multipliers: &[(f64, f64)]) -> f64 {
    let mut all = 1.0f64;
    for (i, a) in multipliers.iter().enumerate() {
        for b in &multipliers[..i] {
            let (re, im) = (1.0 - (a.0 * b.0 - a.1 * b.1), a.0 * b.1 + a.1 * b.0);
            // Of two conjugates it is real; others come with the conjugates of both.
            let conjugate = a.0 == b.0 && a.1 == -b.1 || a.1 == 0.0 && b.1 == 0.0;
            let factor = if conjugate { re } else { re.hypot(im) };
            let next = all * factor;
            all = if next == 0.0 { next } else { next.abs().clamp(RANGE.0, RANGE.1).copysign(next) };
        }
    }
    all
}

/// The pair whose product is nearest to 1.
pub(crate) fn nearest_pair(multipliers: &[(f64, f64)]) -> Option<MultiplierPair> {
    pairs(multipliers).min_by(|a, b| a.off.abs().total_cmp(&b.off.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 0.3 ± 0.4i, 0.5 and −2.
    const FOUR: [(f64, f64); 4] = [(-2.0, 0.0), (0.5, 0.0), (0.3, 0.4), (0.3, -0.4)];

    #[test]
    fn products_are_those_of_the_factors_by_hand() {
        let near = |found: f64, known: f64| assert!((found - known).abs() < 1e-14, "{found} {known}");
        near(product(&FOUR, 1.0), -1.5 * (1.3 * 1.3 + 0.16));
        near(product(&FOUR, -1.0), 3.0 * 0.5 * (0.7 * 0.7 + 0.16));
        // (1 − 1/4) |1 − (0.3 + 0.4i)/2|² |1 + 2(0.3 + 0.4i)|² (1 + 1).
        near(pairs_product(&FOUR), 0.75 * (0.85 * 0.85 + 0.04) * (1.6 * 1.6 + 0.64) * 2.0);
        assert_eq!(
            pairs(&FOUR).map(|pair| (pair.complex, pair.off)).collect::<Vec<_>>(),
            [(true, 0.75), (false, 2.0)]
        );
    }

    /// Two complex multipliers that pass the unit circle turn the sign of all pairs' product, whatever else
    /// there is.
    #[test]
    fn a_pair_that_passes_the_circle_is_found_among_others() {
        for others in [vec![], vec![(0.9, 0.0)], vec![(1.0, 0.0), (-0.2, 0.7), (-0.2, -0.7)]] {
            let sign = |r: f64| {
                let mut all = others.clone();
                all.extend([(0.6 * r, 0.8 * r), (0.6 * r, -0.8 * r)]);
                let pair = nearest_pair(&all).unwrap();
                assert!(pair.complex && (pair.both()[0].0 - 0.6 * r).abs() < 1e-12, "{pair:?}");
                assert!((pair.both()[0].1 - 0.8 * r).abs() < 1e-12, "{pair:?}");
                assert_eq!(without(&all, &pair.both()), others);
                pairs_product(&all).signum()
            };
            assert_eq!(sign(1.001), -sign(0.999), "{others:?}");
        }
    }

    #[test]
    fn real_pairs_are_told_from_complex_ones() {
        let pair = nearest_pair(&[(0.5, 0.0), (2.0, 0.0), (0.1, 0.0)]).unwrap();
        assert!(!pair.complex && pair.off == 0.0);
        assert_eq!(pair.both(), [(2.0, 0.0), (0.5, 0.0)]);
        assert!(nearest_pair(&[(1.0, 0.0)]).is_none() && without(&[(1.0, 0.0)], &[(1.0, 0.0)]).is_empty());
        assert_eq!(pairs_product(&[]), 1.0);
    }
}
