//! A linear system with periodic force, time being the forcing's phase: a machine, free or resting on some of
//! its stops.

use super::{RealMatrix, RealVector, contact::StopContact};
use crate::{
    error::{Error, Result},
    motion::{Harmonic, Series},
};

/// M q″ + C q′ + K q = f(t) with M symmetric and positive definite, f 2π-periodic. No coordinate at all is
/// allowed.
#[derive(Debug, Clone)]
pub struct LinearEquations {
    /// M.
    pub mass: RealMatrix,
    /// C, of any kind.
    pub damping: RealMatrix,
    /// K, of any kind.
    pub stiffness: RealMatrix,
    /// f.
    pub(crate) force: Periodic,
    /// L with M = L Lᵀ.
    root: RealMatrix,
}

/// A 2π-periodic vector: mean + Σ (cos cos kt + sin sin kt), every k once.
#[derive(Debug, Clone)]
pub struct Periodic {
    /// The constant part.
    pub(crate) mean: RealVector,
    /// k ≥ 1 with the coefficients of cos kt and sin kt.
    pub(crate) harmonics: Vec<(u32, RealVector, RealVector)>,
}

impl Periodic {
    /// A constant.
    pub fn constant(mean: RealVector) -> Periodic {
        Periodic { mean, harmonics: Vec::new() }
    }

    /// Adds a harmonic; zeros are left out.
    pub(crate) fn add(&mut self, k: u32, cos: &RealVector, sin: &RealVector) {
        if cos.iter().chain(sin).all(|x| *x == 0.0) {
            return;
        }
        match self.harmonics.iter_mut().find(|known| known.0 == k) {
            Some((_, a, b)) => {
                *a += cos;
                *b += sin;
            }
            None => self.harmonics.push((k, cos.clone(), sin.clone())),
        }
    }

    /// Adds `direction` times a series.
    pub(crate) fn add_series(&mut self, direction: &RealVector, series: &Series) {
        self.mean += direction * series.mean();
        for h in series.harmonics() {
            self.add(h.k, &(direction * h.cos), &(direction * h.sin));
        }
    }

    /// The value at t.
    pub(crate) fn at(&self, t: f64) -> RealVector {
        let mut sum = self.mean.clone();
        for (k, a, b) in &self.harmonics {
            let (sin, cos) = (f64::from(*k) * t).sin_cos();
            sum.axpy(cos, a, 1.0);
            sum.axpy(sin, b, 1.0);
        }
        sum
    }

    /// The function under a linear map.
    #[must_use]
    pub(crate) fn mapped(&self, map: &RealMatrix) -> Periodic {
        let harmonics = self.harmonics.iter().map(|(k, a, b)| (*k, map * a, map * b)).collect();
        Periodic { mean: map * &self.mean, harmonics }
    }

    /// One functional of it.
    pub(crate) fn series(&self, row: &RealVector) -> Result<Series> {
        let harmonic =
            |(k, a, b): &(u32, RealVector, RealVector)| Harmonic { k: *k, cos: row.dot(a), sin: row.dot(b) };
        Series::new(row.dot(&self.mean), &self.harmonics.iter().map(harmonic).collect::<Vec<_>>())
    }

    /// The highest k, 0 for a constant.
    pub(crate) fn order(&self) -> u32 {
        self.harmonics.iter().map(|known| known.0).max().unwrap_or(0)
    }
}

impl LinearEquations {
    /// Equations of n coordinates, all matrices n × n.
    ///
    /// # Errors
    /// An input error for M that is not symmetric or not positive definite.
    pub fn new(
        mass: RealMatrix,
        damping: RealMatrix,
        stiffness: RealMatrix,
        force: Periodic,
    ) -> Result<LinearEquations> {
        check_symmetric(&mass)?;
        let root = root_of(&mass)?;
        Ok(LinearEquations { mass, damping, stiffness, force, root })
    }

    /// n.
    pub(crate) fn size(&self) -> usize {
        self.mass.nrows()
    }

    /// M⁻¹ v.
    #[must_use]
    pub(crate) fn accelerate(&self, v: &RealVector) -> RealVector {
        let half = self.root.solve_lower_triangular(v).unwrap_or_else(|| v.clone());
        self.root.transpose().solve_upper_triangular(&half).unwrap_or(half)
    }

    /// q″.
    pub(crate) fn acceleration(&self, t: f64, q: &RealVector, u: &RealVector) -> RealVector {
        self.accelerate(&(self.force.at(t) - &self.damping * u - &self.stiffness * q))
    }

    /// The same machine while these soft stops push on it: M q″ + (C + Σ c wᵀw) q′ + (K + Σ k wᵀw) q = f + Σ
    /// wᵀ (k Q + c Q′), Q being where a stop stands.
    #[must_use]
    pub(crate) fn pushed<'c>(&self, contacts: impl Iterator<Item = &'c StopContact>) -> LinearEquations {
        let mut all = self.clone();
        for contact in contacts {
            let Some(soft) = contact.soft else { continue };
            let (row, place) = (&contact.row, &contact.position);
            all.stiffness.ger(soft.stiffness, row, row, 1.0);
            all.damping.ger(soft.damping, row, row, 1.0);
            all.force.add_series(&(row * soft.stiffness), place);
            all.force.add_series(&(row * soft.damping), &place.derivative());
        }
        all
    }

    /// det of the flow over a time, by Liouville: exp(−tr(M⁻¹C) · time).
    pub(super) fn determinant(&self, time: f64) -> f64 {
        (-self.per_mass(&self.damping).trace() * time).exp()
    }

    /// L⁻¹ X L⁻ᵀ: a matrix of the equations in coordinates in which the mass is 1.
    pub(super) fn per_mass(&self, x: &RealMatrix) -> RealMatrix {
        let half = self.root.solve_lower_triangular(x).unwrap_or_else(|| x.clone());
        self.root.solve_lower_triangular(&half.transpose()).unwrap_or(half).transpose()
    }

    /// L.
    pub(super) fn root(&self) -> &RealMatrix {
        &self.root
    }

    /// The motion under the constraint that the gaps of these contacts, whose rows are independent, are 0: q
    /// = Z r + Σ b_j Q_j(t), with Z an M-orthonormal basis of the motions that keep the gaps, so that the
    /// mass of r is 1.
    ///
    /// # Errors
    /// None in practice: of [`LinearEquations::new`].
    pub(crate) fn constrained(&self, contacts: &[&StopContact]) -> Result<Constrained> {
        let (n, m) = (self.size(), contacts.len());
        let rows = RealMatrix::from_fn(m, n, |i, j| contacts[i].row[j]);
        // Rows in coordinates x = Lᵀq of mass 1: w·q = (L⁻¹wᵀ)·x.
        let seen = self.root.solve_lower_triangular(&rows.transpose()).unwrap_or_else(|| rows.transpose());
        let basis = complement(&seen);
        let upper = self.root.transpose();
        let free = upper.solve_upper_triangular(&basis).unwrap_or(basis);
        // b = M⁻¹Wᵀ(W M⁻¹Wᵀ)⁻¹.
        let lift = upper.solve_upper_triangular(&seen).unwrap_or_else(|| seen.clone());
        let inverse = (seen.transpose() * &seen).try_inverse();
        let inverse = inverse.ok_or_else(|| Error::input("the stops rested on have dependent rows"))?;
        let lift = lift * inverse;
        let mut force = Periodic::constant(RealVector::zeros(n - m));
        let down = free.transpose();
        let given = self.force.mapped(&down);
        force.mean = given.mean;
        force.harmonics = given.harmonics;
        for (j, contact) in contacts.iter().enumerate() {
            let b = lift.column(j).into_owned();
            let (place, speed) = (&contact.position, contact.position.derivative());
            // Z is M-orthogonal to b: Zᵀ M b Q″ = 0.
            force.add_series(&(-(&down * (&self.stiffness * &b))), place);
            force.add_series(&(-(&down * (&self.damping * &b))), &speed);
        }
        let reduced = |x: &RealMatrix| &down * x * &free;
        let mass = RealMatrix::identity(n - m, n - m);
        let equations = LinearEquations::new(mass, reduced(&self.damping), reduced(&self.stiffness), force)?;
        let down = down * &self.mass;
        Ok(Constrained { equations, free, lift, down })
    }
}

/// A machine resting on some stops.
#[derive(Debug, Clone)]
pub(crate) struct Constrained {
    /// The equations of r.
    pub equations: LinearEquations,
    /// Z, n × (n − m).
    pub free: RealMatrix,
    /// The columns b_j, n × m.
    pub lift: RealMatrix,
    /// ZᵀM: from q to r.
    pub down: RealMatrix,
}

/// An orthonormal basis of the vectors orthogonal to the columns of `seen`, which are independent.
fn complement(seen: &RealMatrix) -> RealMatrix {
    let (n, m) = seen.shape();
    if m == 0 {
        return RealMatrix::identity(n, n);
    }
    if n <= m {
        return RealMatrix::zeros(n, 0);
    }
    let q = seen.clone().qr().q();
    let mut all: Vec<RealVector> = q.column_iter().map(|column| column.into_owned()).collect();
    let mut left: Vec<usize> = (0..n).collect();
    let part = |all: &[RealVector], i: usize| all.iter().map(|v| v[i] * v[i]).sum::<f64>();
    while all.len() < n && !left.is_empty() {
        // The unit vector least in the span.
        let at = (0..left.len()).min_by(|&a, &b| part(&all, left[a]).total_cmp(&part(&all, left[b])));
        let i = left.remove(at.unwrap_or(0));
        let mut v = RealVector::from_fn(n, |j, _| f64::from(u8::from(j == i)));
        for _ in 0..2 {
            for known in &all {
                v.axpy(-known.dot(&v), known, 1.0);
            }
        }
        let norm = v.norm();
        all.push(v / norm);
    }
    RealMatrix::from_columns(&all[m..])
}

/// Refuses a mass that is not symmetric.
pub(super) fn check_symmetric(mass: &RealMatrix) -> Result<()> {
    for i in 0..mass.nrows() {
        for j in 0..i {
            let (a, b) = (mass[(i, j)], mass[(j, i)]);
            if (a - b).abs() > 1e-12 * a.abs().max(b.abs()) {
                let (i, j) = (i + 1, j + 1);
                return Err(Error::input(format!(
                    "mass is not symmetric: row {i}, column {j} has {a}, row {j}, column {i} has {b}"
                )));
            }
        }
    }
    Ok(())
}

/// The lower triangular L with L Lᵀ = M.
fn root_of(mass: &RealMatrix) -> Result<RealMatrix> {
    let n = mass.nrows();
    if n == 0 {
        return Ok(mass.clone());
    }
    let singular = |at: usize| {
        Error::input(format!(
            "mass is not positive definite: pivot {at} of its Cholesky factors is not positive; every motion must have inertia"
        ))
    };
    let mut root = RealMatrix::zeros(n, n);
    for j in 0..n {
        let left: f64 = (0..j).map(|k| root[(j, k)] * root[(j, k)]).sum();
        let pivot = mass[(j, j)] - left;
        // What rounding leaves of a singular matrix is no mass.
        if !(pivot > 1e-14 * mass[(j, j)].abs() && pivot.is_finite()) {
            return Err(singular(j + 1));
        }
        root[(j, j)] = pivot.sqrt();
        for i in j + 1..n {
            let left: f64 = (0..j).map(|k| root[(i, k)] * root[(j, k)]).sum();
            root[(i, j)] = (mass[(i, j)] - left) / root[(j, j)];
        }
    }
    Ok(root)
}
