//! A system that does not fall apart: y and p move by Taylor series of the matrix exponential.

use std::f64::consts::TAU;

use crate::many::{Periodic, RealMatrix, RealVector};

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

/// e^{A·duration}: by its series where the matrix is at most 1/2, then squared. Cost: 20 products of matrices
/// and one more for each doubling.
pub(super) fn exponential(a: &RealMatrix, duration: f64) -> RealMatrix {
    let n = a.nrows();
    let doublings = (2.0 * rate_of(a) * duration.abs()).log2().ceil().max(0.0);
    let small = a * (duration / doublings.exp2());
    let mut sum = RealMatrix::identity(n, n);
    for i in (1..BLOCK_TERMS).rev() {
        sum = &small * sum / i as f64;
        sum.iter_mut().step_by(n + 1).for_each(|x| *x += 1.0);
    }
    (0..doublings as u64).fold(sum, |sum, _| &sum * &sum)
}

/// The responses from rest at 0 at the beginnings of `count` equal parts of a period, and at its end.
///
/// From part to part p ↦ E p + r, where r is what the force brings about within a part: for a harmonic with
/// the coefficients a and b it is cos kt times that of (a, b) and sin kt times that of (b, −a).
pub(super) fn responses_from_rest(a: &RealMatrix, force: &Periodic, count: usize) -> Vec<RealVector> {
    let width = TAU / count as f64;
    let (step, rest) = (exponential(a, width), RealVector::zeros(a.nrows()));
    let alone = |k: u32, cos: &RealVector, sin: &RealVector| {
        let harmonics = vec![(k, cos.clone(), sin.clone())];
        forced(a, &Periodic { mean: rest.clone(), harmonics }, 0.0, width, &rest)
    };
    let mean = forced(a, &Periodic::constant(force.mean.clone()), 0.0, width, &rest);
    let parts: Vec<(f64, RealVector, RealVector)> = force
        .harmonics
        .iter()
        .map(|(k, cos, sin)| (f64::from(*k), alone(*k, cos, sin), alone(*k, sin, &-cos)))
        .collect();
    let mut all = vec![rest.clone()];
    for i in 0..count {
        let mut next = &step * &all[i] + &mean;
        for (k, even, odd) in &parts {
            let (sin, cos) = (k * (width * i as f64)).sin_cos();
            next.axpy(cos, even, 1.0);
            next.axpy(sin, odd, 1.0);
        }
        all.push(next);
    }
    all
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
