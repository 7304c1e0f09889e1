//! The periodic motion without impacts: the forced response of a linear system, and how it changes with a
//! parameter.

use nalgebra::{Complex, DMatrix, DVector};

use super::{LinearEquations, Periodic, RealMatrix, RealVector, Slope, State};
use crate::{
    error::{Error, Result},
    motion::{Harmonic, Series},
};

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

impl Periodic {
    /// Adds the harmonic with this amplitude.
    fn put(&mut self, k: u32, z: &DVector<Complex<f64>>) {
        let [re, im] = [z.map(|x| x.re), z.map(|x| -x.im)];
        if k == 0 { self.mean = re } else { self.add(k, &re, &im) }
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

    /// The same and its derivative in a parameter, to rounding however near a resonance is.
    ///
    /// # Errors
    /// As [`response`](Self::response).
    pub(crate) fn refined(&self, slope: &Slope) -> Result<[Refined; 2]> {
        let ks = std::iter::once(0).chain(self.force.harmonics.iter().map(|known| known.0));
        let motion = self.refine(ks, |k| self.force.amplitude(k))?;
        let (ks, right) = self.slope_of(&motion.motion, slope, true);
        let drift = self.refine(ks.into_iter(), right)?;
        Ok([motion, drift])
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
        let ks = self.force.harmonics.iter().map(|known| known.0);
        self.solve(ks, |k| self.force.amplitude(k))
    }

    /// The derivative in a parameter of the periodic motion `motion`:
    /// (K − k²M + ikC) z_k′ = f_k′ − (K′ − k²M′ + ikC′) z_k.
    ///
    /// # Errors
    /// As [`response`](Self::response).
    pub(crate) fn response_slope(&self, motion: &Periodic, slope: &Slope) -> Result<Periodic> {
        let (ks, right) = self.slope_of(motion, slope, true);
        self.solve(ks.into_iter(), right)
    }

    /// That of a motion about 0: its mean is left out.
    ///
    /// # Errors
    /// As [`response_about_0`](Self::response_about_0).
    pub(crate) fn slope_about_0(&self, motion: &Periodic, slope: &Slope) -> Result<Periodic> {
        let (ks, right) = self.slope_of(motion, slope, false);
        self.solve(ks.into_iter(), right)
    }

    /// The harmonics of the derivative, and their right sides.
    fn slope_of<'s>(
        &self,
        motion: &'s Periodic,
        slope: &'s Slope,
        with_mean: bool,
    ) -> (Vec<u32>, impl Fn(u32) -> DVector<Complex<f64>> + 's) {
        let both = motion.harmonics.iter().chain(&slope.force.harmonics).map(|known| known.0);
        let mut ks: Vec<u32> = with_mean.then_some(0).into_iter().chain(both).collect();
        ks.sort_unstable();
        ks.dedup();
        let changed =
            move |k| dynamic(k, &slope.mass, &slope.damping, &slope.stiffness) * motion.amplitude(k);
        (ks, move |k| slope.force.amplitude(k) - changed(k))
    }

    fn solve(
        &self,
        ks: impl Iterator<Item = u32>,
        right: impl Fn(u32) -> DVector<Complex<f64>>,
    ) -> Result<Periodic> {
        let n = self.size();
        let mut sum = Periodic::constant(RealVector::zeros(n));
        self.each(ks, right, |k, z, _| sum.put(k, z))?;
        Ok(sum)
    }

    /// The same to rounding, and what rounding leaves.
    fn refine(
        &self,
        ks: impl Iterator<Item = u32>,
        right: impl Fn(u32) -> DVector<Complex<f64>>,
    ) -> Result<Refined> {
        let none = || Periodic::constant(RealVector::zeros(self.size()));
        let mut found = Refined { motion: none(), rest: none() };
        self.each(ks, &right, |k, z, solve| {
            let (f, mut z, mut rest) = (right(k), z.clone(), None);
            for _ in 0..REFINEMENTS {
                let Some(change) = solve(&self.left(k, &z, &f)) else { break };
                let next = &z + &change;
                rest = Some(change - (&next - &z));
                z = next;
            }
            found.motion.put(k, &z);
            rest.into_iter().for_each(|rest| found.rest.put(k, &rest));
        })?;
        Ok(found)
    }

    /// Hands on the amplitude of each harmonic, and what solves its equations for another right side.
    fn each(
        &self,
        ks: impl Iterator<Item = u32>,
        right: impl Fn(u32) -> DVector<Complex<f64>>,
        mut with: impl FnMut(
            u32,
            &DVector<Complex<f64>>,
            &dyn Fn(&DVector<Complex<f64>>) -> Option<DVector<Complex<f64>>>,
        ),
    ) -> Result<()> {
        let n = self.size();
        for k in ks {
            let matrix = dynamic(k, &self.mass, &self.damping, &self.stiffness);
            let size = matrix.norm();
            let lu = matrix.lu();
            // Rounding leaves a singular matrix a pivot of about its own size times n ε.
            let pivot = lu.u().diagonal().iter().map(|x| x.norm()).fold(f64::INFINITY, f64::min);
            let solve = |right: &DVector<Complex<f64>>| {
                lu.solve(right).filter(|z| z.iter().all(|x| x.re.is_finite() && x.im.is_finite()))
            };
            let Some(z) = solve(&right(k)).filter(|_| pivot > 4.0 * f64::EPSILON * n as f64 * size) else {
                return Err(Error::input(format!(
                    "without impacts there is no unique periodic motion: an undamped mode resonates with {}, or has no stiffness",
                    if k == 0 { "the constant force".to_string() } else { format!("harmonic {k}") }
                )));
            };
            with(k, &z, &solve);
        }
        Ok(())
    }

    /// f − (K − k²M + ikC) z, rounded once: K and k²M cancel near a resonance.
    fn left(&self, k: u32, z: &DVector<Complex<f64>>, f: &DVector<Complex<f64>>) -> DVector<Complex<f64>> {
        let k = f64::from(k);
        let (square, n) = (k * k, self.size());
        DVector::from_fn(n, |i, _| {
            let mut parts = [Exact::of(f[i].re), Exact::of(f[i].im)];
            for j in 0..n {
                let (stiffness, mass) = (self.stiffness[(i, j)], exact(square, self.mass[(i, j)]));
                let damping = exact(k, self.damping[(i, j)]);
                for (part, (own, other, sign)) in
                    parts.iter_mut().zip([(z[j].re, z[j].im, 1.0), (z[j].im, z[j].re, -1.0)])
                {
                    part.add(-stiffness, own);
                    mass.into_iter().for_each(|x| part.add(x, own));
                    damping.into_iter().for_each(|x| part.add(sign * x, other));
                }
            }
            let [re, im] = parts.map(|part| part.sum + part.off);
            Complex::new(re, im)
        })
    }
}

/// A periodic motion to rounding, and what rounding leaves of it: as if in twice the digits.
#[derive(Debug, Clone)]
pub(crate) struct Refined {
    /// The motion.
    pub motion: Periodic,
    rest: Periodic,
}

impl Refined {
    /// A motion that is known to rounding.
    pub(crate) fn of(motion: Periodic) -> Refined {
        Refined { rest: Periodic::constant(RealVector::zeros(motion.mean.len())), motion }
    }

    /// One functional of it: what several large displacements leave of each other is right.
    pub(crate) fn series(&self, row: &RealVector) -> Result<Series> {
        let along = |own: &RealVector, rest: Option<&RealVector>| {
            let mut sum = Exact::of(0.0);
            row.iter().zip(own).for_each(|(w, x)| sum.add(*w, *x));
            sum.sum + (sum.off + rest.map_or(0.0, |rest| row.dot(rest)))
        };
        let harmonic = |(k, a, b): &(u32, RealVector, RealVector)| {
            let rest = self.rest.harmonics.iter().find(|known| known.0 == *k);
            let [cos, sin] = [along(a, rest.map(|rest| &rest.1)), along(b, rest.map(|rest| &rest.2))];
            Harmonic { k: *k, cos, sin }
        };
        let all: Vec<Harmonic<f64>> = self.motion.harmonics.iter().map(harmonic).collect();
        Series::new(along(&self.motion.mean, Some(&self.rest.mean)), &all)
    }
}

/// Each takes the condition times rounding off the error.
const REFINEMENTS: usize = 3;

/// A sum of products, and what rounding has taken from it: as if in twice the digits.
struct Exact {
    sum: f64,
    off: f64,
}

impl Exact {
    fn of(sum: f64) -> Exact {
        Exact { sum, off: 0.0 }
    }

    fn add(&mut self, x: f64, y: f64) {
        let [product, rest] = exact(x, y);
        let sum = self.sum + product;
        let own = sum - self.sum;
        self.off += (self.sum - (sum - own)) + (product - own) + rest;
        self.sum = sum;
    }
}

/// x y, rounded, and what is missing.
fn exact(x: f64, y: f64) -> [f64; 2] {
    let product = x * y;
    [product, x.mul_add(y, -product)]
}

/// K − k²M + ikC.
fn dynamic(k: u32, mass: &RealMatrix, damping: &RealMatrix, stiffness: &RealMatrix) -> DMatrix<Complex<f64>> {
    let k = f64::from(k);
    DMatrix::from_fn(mass.nrows(), mass.ncols(), |i, j| {
        Complex::new(stiffness[(i, j)] - k * k * mass[(i, j)], k * damping[(i, j)])
    })
}
