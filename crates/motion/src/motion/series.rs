//! 2π-periodic functions as short trigonometric sums: forcing and wall motion in one normal form.

use super::Harmonic;
use crate::error::{Error, Result};

/// `mean` + Σ (cos·cos kt + sin·sin kt), every k ≥ 1 once, ascending, with nonzero amplitude: a harmonic
/// given with zero coefficients and one not given are the same series.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    mean: f64,
    harmonics: Vec<Harmonic<f64>>,
}

impl Series {
    /// The function 0.
    pub(crate) const ZERO: Series = Series { mean: 0.0, harmonics: Vec::new() };

    /// A constant function.
    pub(crate) fn constant(mean: f64) -> Series {
        Series { mean, harmonics: Vec::new() }
    }

    /// The normal form of a sum; equal k are added up.
    ///
    /// # Errors
    /// A coefficient that is not finite, or k = 0.
    pub fn new(mean: f64, harmonics: &[Harmonic<f64>]) -> Result<Self> {
        finite("the mean", mean)?;
        for h in harmonics {
            finite("cos", h.cos)?;
            finite("sin", h.sin)?;
            if h.k == 0 {
                return Err(Error::input(
                    "a harmonic with k = 0: give a constant as offset or force instead",
                ));
            }
        }
        Ok(Series::sum(mean, harmonics))
    }

    fn sum(mean: f64, harmonics: &[Harmonic<f64>]) -> Self {
        let mut sum: Vec<Harmonic<f64>> = Vec::new();
        for h in harmonics {
            match sum.iter_mut().find(|other| other.k == h.k) {
                Some(other) => (other.cos, other.sin) = (other.cos + h.cos, other.sin + h.sin),
                None => sum.push(h.clone()),
            }
        }
        sum.retain(|h| h.cos != 0.0 || h.sin != 0.0);
        sum.sort_by_key(|h| h.k);
        Series { mean: mean + 0.0, harmonics: sum }
    }

    /// The constant term.
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// The harmonics, k ascending.
    pub fn harmonics(&self) -> &[Harmonic<f64>] {
        &self.harmonics
    }

    /// The highest k, 0 for a constant.
    pub fn order(&self) -> u32 {
        self.harmonics.last().map_or(0, |h| h.k)
    }

    /// Value, first and second derivative at t: one sine and cosine a harmonic.
    pub fn at(&self, t: f64) -> [f64; 3] {
        self.harmonics.iter().fold([self.mean, 0.0, 0.0], |[value, first, second], h| {
            let k = f64::from(h.k);
            let (sin, cos) = (k * t).sin_cos();
            let (here, slope) = (h.cos * cos + h.sin * sin, k * (h.sin * cos - h.cos * sin));
            [value + here, first + slope, second - k * k * here]
        })
    }

    /// Adds the Taylor coefficients of `factor` times the series at t, scaled to the half width `h`: those of
    /// x ↦ series(t + hx).
    pub(crate) fn add_taylor(&self, factor: f64, t: f64, h: f64, coefficients: &mut [f64]) {
        let Some(constant) = coefficients.first_mut() else { return };
        *constant += factor * self.mean;
        for harmonic in &self.harmonics {
            let k = f64::from(harmonic.k);
            let (sin, cos) = (k * t).sin_cos();
            // Each derivative turns (value, slope / k) by a quarter.
            let mut even = factor * (harmonic.cos * cos + harmonic.sin * sin);
            let mut odd = factor * (harmonic.sin * cos - harmonic.cos * sin);
            let mut power = 1.0;
            for (i, coefficient) in coefficients.iter_mut().enumerate() {
                *coefficient += even * power;
                (even, odd) = (odd, -even);
                power *= k * h / (i + 1) as f64;
            }
        }
    }

    /// The derivative, a series again.
    #[must_use]
    pub(crate) fn derivative(&self) -> Series {
        let turned = |h: &Harmonic<f64>| {
            let k = f64::from(h.k);
            Harmonic { k: h.k, cos: k * h.sin, sin: -k * h.cos }
        };
        Series { mean: 0.0, harmonics: self.harmonics.iter().map(turned).collect() }
    }

    /// A linear combination.
    pub(crate) fn combination(terms: &[(f64, &Series)]) -> Series {
        let mean = terms.iter().map(|(factor, series)| factor * series.mean).sum();
        let scaled = |&(factor, series): &(f64, &'_ Series)| {
            let scale =
                move |h: &Harmonic<f64>| Harmonic { k: h.k, cos: factor * h.cos, sin: factor * h.sin };
            series.harmonics.iter().map(scale).collect::<Vec<_>>()
        };
        Series::sum(mean, &terms.iter().flat_map(scaled).collect::<Vec<_>>())
    }

    /// Σ kⁿ √(cos² + sin²), but for rounding: no derivative of order n ≥ 1 exceeds it. The same from
    /// whichever phase time is counted, for it stands for sizes, too.
    pub fn derivative_bound(&self, n: i32) -> f64 {
        self.harmonics.iter().map(|h| f64::from(h.k).powi(n) * h.cos.hypot(h.sin)).sum()
    }
}

pub(crate) fn finite(name: &str, value: f64) -> Result<()> {
    if value.is_finite() { Ok(()) } else { Err(Error::input(format!("{name} = {value} is not finite"))) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_and_absent_are_the_same_series_and_equal_k_add_up() {
        let h = |k, cos, sin| Harmonic { k, cos, sin };
        let series =
            Series::new(-0.0, &[h(3, 0.5, 0.0), h(2, 0.0, -0.0), h(1, 1.0, 2.0), h(1, 1.0, -2.0)]).unwrap();
        assert_eq!(series, Series::new(0.0, &[h(1, 2.0, 0.0), h(3, 0.5, 0.0)]).unwrap());
        assert!(series.mean().is_sign_positive());
        assert!(Series::new(0.0, &[h(0, 1.0, 0.0)]).unwrap_err().is_input());
        assert!(Series::new(f64::NAN, &[]).unwrap_err().is_input());
    }

    #[test]
    fn the_taylor_coefficients_sum_to_the_series() {
        let h = |k, cos, sin| Harmonic { k, cos, sin };
        let series = Series::new(0.25, &[h(1, 1.0, -0.5), h(3, 0.1, 0.2)]).unwrap();
        let mut coefficients = [0.0; 20];
        series.add_taylor(-2.0, 1.1, 0.3, &mut coefficients);
        for x in [-1.0, -0.3, 0.0, 0.7, 1.0] {
            let sum = coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c);
            assert!((sum + 2.0 * series.at(1.1 + 0.3 * x)[0]).abs() < 1e-14);
        }
    }
}
