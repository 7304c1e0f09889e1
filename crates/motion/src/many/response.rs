//! The periodic motion without impacts: the forced response of a linear system, and how it changes with a
//! parameter.

use nalgebra::{Complex, DMatrix, DVector};

use super::{LinearEquations, Periodic, RealMatrix, RealVector, Slope, State};
use crate::error::{Error, Result};

impl Periodic {
    /// The state of displacements that move so, at t.
    pub fn state(&self, t: f64) -> State {
        let mut u = RealVector::zeros(self.mean.len());
        for (k, a, b) in &self.harmonics {
            let k = f64::from(*k);
            let (sin, cos) = (k * t).sin_cos();
            u.axpy(-k * sin, a, 1.0);
            u.axpy(k * cos, b, 1.0);
        }
        State { t, q: self.at(t), u }
    }

    /// a − ib of cos and sin of kt, the mean for k = 0: the function is the sum of the real parts of (a − ib)
    /// e^{ikt}.
    fn amplitude(&self, k: u32) -> DVector<Complex<f64>> {
        if k == 0 {
            return self.mean.map(|x| Complex::new(x, 0.0));
        }
        let found = self.harmonics.iter().find(|known| known.0 == k);
        let n = self.mean.len();
        found.map_or_else(
            || DVector::from_element(n, Complex::new(0.0, 0.0)),
            |(_, a, b)| DVector::from_fn(n, |i, _| Complex::new(a[i], -b[i])),
        )
    }
}

impl LinearEquations {
    /// The periodic motion: (K − k²M + ikC) z_k = f_k for each harmonic k, 0 among them. Cost: O(n³) for
    /// each.
    ///
    /// # Errors
    /// An input error at a resonance without damping, a motion without stiffness among them: there is no
    /// periodic motion then, or more than one.
    pub(crate) fn response(&self) -> Result<Periodic> {
        let ks = std::iter::once(0).chain(self.force.harmonics.iter().map(|known| known.0));
        self.solve(ks, |k| self.force.amplitude(k))
    }

    /// The same with a mean of 0: the motion about a place that a mode without stiffness leaves open.
    ///
    /// # Errors
    /// An input error at a resonance without damping, and where a constant force drives the mode away.
    pub(crate) fn response_about_0(&self) -> Result<Periodic> {
        let mean = &self.force.mean;
        // What a constant force does not do in displacements of size 1 it does not do at all.
        let held = self.stiffness.clone().svd(true, true).solve(mean, f64::EPSILON * self.stiffness.norm());
        let left = held.map_or(f64::INFINITY, |held| (&self.stiffness * held - mean).amax());
        if left.is_nan() || left > 1e-10 * mean.amax() {
            return Err(Error::input("a constant force drives a mode without stiffness away"));
        }
        self.solve(self.force.harmonics.iter().map(|known| known.0), |k| self.force.amplitude(k))
    }

    /// The derivative in a parameter of the periodic motion `motion`:
    /// (K − k²M + ikC) z_k′ = f_k′ − (K′ − k²M′ + ikC′) z_k.
    ///
    /// # Errors
    /// As [`response`](Self::response).
    pub(crate) fn response_slope(&self, motion: &Periodic, slope: &Slope) -> Result<Periodic> {
        self.slope_of(motion, slope, true)
    }

    /// That of a motion about 0: its mean is left out.
    ///
    /// # Errors
    /// As [`response_about_0`](Self::response_about_0).
    pub(crate) fn slope_about_0(&self, motion: &Periodic, slope: &Slope) -> Result<Periodic> {
        self.slope_of(motion, slope, false)
    }

    fn slope_of(&self, motion: &Periodic, slope: &Slope, with_mean: bool) -> Result<Periodic> {
        let both = motion.harmonics.iter().chain(&slope.force.harmonics).map(|known| known.0);
        let mut ks: Vec<u32> = with_mean.then_some(0).into_iter().chain(both).collect();
        ks.sort_unstable();
        ks.dedup();
        let changed = |k| dynamic(k, &slope.mass, &slope.damping, &slope.stiffness) * motion.amplitude(k);
        self.solve(ks.into_iter(), |k| slope.force.amplitude(k) - changed(k))
    }

    fn solve(
        &self,
        ks: impl Iterator<Item = u32>,
        right: impl Fn(u32) -> DVector<Complex<f64>>,
    ) -> Result<Periodic> {
        let n = self.size();
        let mut sum = Periodic::constant(RealVector::zeros(n));
        for k in ks {
            let matrix = dynamic(k, &self.mass, &self.damping, &self.stiffness);
            let size = matrix.norm();
            let lu = matrix.lu();
            // Rounding leaves a singular matrix a pivot of about its own size times n ε.
            let pivot = lu.u().diagonal().iter().map(|x| x.norm()).fold(f64::INFINITY, f64::min);
            let z = lu.solve(&right(k)).filter(|z| z.iter().all(|x| x.re.is_finite() && x.im.is_finite()));
            let Some(z) = z.filter(|_| pivot > 4.0 * f64::EPSILON * n as f64 * size) else {
                return Err(Error::input(format!(
                    "without impacts there is no unique periodic motion: an undamped mode resonates with {}, or has no stiffness",
                    if k == 0 { "the constant force".to_string() } else { format!("harmonic {k}") }
                )));
            };
            if k == 0 {
                sum.mean = z.map(|x| x.re);
            } else {
                sum.add(k, &z.map(|x| x.re), &z.map(|x| -x.im));
            }
        }
        Ok(sum)
    }
}

/// K − k²M + ikC.
fn dynamic(k: u32, mass: &RealMatrix, damping: &RealMatrix, stiffness: &RealMatrix) -> DMatrix<Complex<f64>> {
    let k = f64::from(k);
    DMatrix::from_fn(mass.nrows(), mass.ncols(), |i, j| {
        Complex::new(stiffness[(i, j)] - k * k * mass[(i, j)], k * damping[(i, j)])
    })
}
