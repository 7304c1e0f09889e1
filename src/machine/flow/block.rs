//! A system that does not fall apart: y and p move by Taylor series of the matrix exponential.

use crate::machine::{Periodic, RealMatrix, RealVector};

/// Terms of the Taylor series by which a system moves that is one block: with 1/2, what is left out is below
/// 2⁻²⁰/20! < 10⁻²⁴.
const BLOCK_TERMS: usize = 20;

/// The Taylor coefficients of a periodic vector at t, one after the other: those of x ↦ f(t + hx).
pub(super) struct Force {
    /// Value and slope/k of each harmonic, turned by a quarter for each derivative, and k h.
    parts: Vec<(RealVector, RealVector, f64)>,
    mean: Option<RealVector>,
    size: usize,
    index: usize,
}

impl Force {
    pub(super) fn new(force: &Periodic, t: f64, h: f64) -> Force {
        let part = |(k, a, b): &(u32, RealVector, RealVector)| {
            let k = f64::from(*k);
            let (sin, cos) = (k * t).sin_cos();
            (a * cos + b * sin, b * cos - a * sin, k * h)
        };
        let parts = force.harmonics.iter().map(part).collect();
        Force { parts, mean: Some(force.mean.clone()), size: force.mean.len(), index: 0 }
    }

    pub(super) fn next(&mut self) -> RealVector {
        let mut sum = self.mean.take().unwrap_or_else(|| RealVector::zeros(self.size));
        self.index += 1;
        for (even, odd, kh) in &mut self.parts {
            sum += &*even;
            let turned = &*even * -1.0;
            let factor = *kh / self.index as f64;
            (*even, *odd) = (&*odd * factor, turned * factor);
        }
        sum
    }
}

/// A bound of A's largest singular value.
pub(super) fn rate_of(a: &RealMatrix) -> f64 {
    let columns = a.column_iter().map(|c| c.iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max);
    let rows = a.row_iter().map(|r| r.iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max);
    (columns * rows).sqrt()
}

/// e^{A·duration} v, or with the transpose as `times` says.
pub(super) fn moved(
    a: &RealMatrix,
    duration: f64,
    v: &RealVector,
    times: impl Fn(&RealMatrix, &RealVector) -> RealVector,
) -> RealVector {
    let steps = (2.0 * rate_of(a) * duration.abs()).ceil().max(1.0);
    let h = duration / steps;
    let mut sum = v.clone();
    for _ in 0..steps as u64 {
        let mut term = sum.clone();
        for i in 1..BLOCK_TERMS {
            term = times(a, &term) * (h / i as f64);
            sum += &term;
        }
    }
    sum
}

/// p at t + duration from p at t, p′ = A p + f.
pub(super) fn forced(a: &RealMatrix, force: &Periodic, t: f64, duration: f64, p: &RealVector) -> RealVector {
    let fastest = rate_of(a).max(f64::from(force.order()));
    let steps = (2.0 * fastest * duration.abs()).ceil().max(1.0);
    let h = duration / steps;
    let mut sum = p.clone();
    for step in 0..steps as u64 {
        let mut coefficients = Force::new(force, t + step as f64 * h, h);
        let mut term = sum.clone();
        for i in 1..BLOCK_TERMS {
            term = (a * &term + coefficients.next()) * (h / i as f64);
            sum += &term;
        }
    }
    sum
}
