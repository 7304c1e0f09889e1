//! A linear system with periodic force, time being the forcing's phase: a machine, free or resting on some of
//! its stops.

use super::{
    RealMatrix, RealVector, Rub,
    contact::{DEPENDENT, StopContact},
};
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
    pub force: Periodic,
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
    pub fn order(&self) -> u32 {
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
    pub fn accelerate(&self, v: &RealVector) -> RealVector {
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
        self.pushed_along(contacts.map(|contact| (contact, contact.row.clone())))
    }

    /// The same where the forces act along d, not along w: with d in place of the first w of each product.
    #[must_use]
    pub(crate) fn pushed_along<'c>(
        &self,
        contacts: impl Iterator<Item = (&'c StopContact, RealVector)>,
    ) -> LinearEquations {
        let mut all = self.clone();
        for (contact, along) in contacts {
            let Some(soft) = contact.soft else { continue };
            let (row, place) = (&contact.row, &contact.position);
            all.stiffness.ger(soft.stiffness, &along, row, 1.0);
            all.damping.ger(soft.damping, &along, row, 1.0);
            all.force.add_series(&(&along * soft.stiffness), place);
            all.force.add_series(&(&along * soft.damping), &place.derivative());
        }
        all
    }

    /// The same machine where it slides under given normal forces, each row with the sign of its velocity, 0
    /// where it sticks.
    #[must_use]
    pub(crate) fn dragged<'r>(&self, rubs: impl Iterator<Item = (&'r Rub, f64)>) -> LinearEquations {
        let mut all = self.clone();
        for (rub, sign) in rubs.filter(|(rub, _)| rub.stop.is_none()) {
            all.force.mean.axpy(-sign * rub.sliding, &rub.row, 1.0);
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

    /// The motion under the constraints that rows W q, which are independent, are what they are held at: q =
    /// Z r + Σ b_j Q_j(t), with Z an M-orthonormal basis of the motions that keep them, so that the mass of r
    /// is 1. At stops Q is known. Where something sticks, only Q′ is, the surface's velocity; Q is a
    /// coordinate p beside r then, with p″ = Q″, and b is replaced by the s of the same row for which Zᵀ K s
    /// = 0, so that r does not feel where it sticks, wherever Zᵀ K Z is regular.
    ///
    /// # Errors
    /// Dependent rows.
    pub(crate) fn constrained(&self, held: &HeldRows) -> Result<Constrained> {
        let (stops, stuck) = (&held.stops, &held.stuck);
        let (n, m, s) = (self.size(), stops.len() + stuck.len(), stuck.len());
        let all: Vec<&RealVector> =
            stops.iter().map(|known| known.0).chain(stuck.iter().map(|known| known.0)).collect();
        let rows = RealMatrix::from_fn(m, n, |i, j| all[i][j]);
        // Rows in coordinates x = Lᵀq of mass 1: w·q = (L⁻¹wᵀ)·x.
        let seen = self.root.solve_lower_triangular(&rows.transpose()).unwrap_or_else(|| rows.transpose());
        let basis = complement(&seen);
        let upper = self.root.transpose();
        let inner = upper.solve_upper_triangular(&basis).unwrap_or(basis);
        // b = M⁻¹Wᵀ(W M⁻¹Wᵀ)⁻¹.
        let lift = upper.solve_upper_triangular(&seen).unwrap_or_else(|| seen.clone());
        let dependent = || Error::input(DEPENDENT);
        let (lift, down) = match &held.along {
            None => {
                let inverse = (seen.transpose() * &seen).try_inverse().ok_or_else(dependent)?;
                (lift * inverse, inner.transpose())
            }
            // The forces act along the columns of D: b = M⁻¹D(W M⁻¹D)⁻¹, and in place of Zᵀ what M b is 0
            // for, M Z still being 1: Zᵀ − ZᵀD(W M⁻¹D)⁻¹W M⁻¹. All below then holds as it is.
            Some(along) => {
                let pushed = self.root.solve_lower_triangular(along).ok_or_else(dependent)?;
                let inverse = (seen.transpose() * &pushed).try_inverse().ok_or_else(dependent)?;
                let oblique = upper.solve_upper_triangular(&pushed).ok_or_else(dependent)? * &inverse;
                let taken = inner.tr_mul(along) * inverse * lift.transpose();
                (oblique, inner.transpose() - taken)
            }
        };
        let mut given = self.force.mapped(&down);
        for (j, (_, place)) in stops.iter().enumerate() {
            let b = lift.column(j).into_owned();
            // Zᵀ M b Q″ = 0.
            given.add_series(&(-(&down * (&self.stiffness * &b))), place);
            given.add_series(&(-(&down * (&self.damping * &b))), &place.derivative());
        }
        let reduced = |x: &RealMatrix| &down * x * &inner;
        let (own_damping, own_stiffness) = (reduced(&self.damping), reduced(&self.stiffness));
        let down_mass = &down * &self.mass;
        let projection = &inner * &down_mass;
        if s == 0 {
            let mass = RealMatrix::identity(n - m, n - m);
            let equations = LinearEquations::new(mass, own_damping, own_stiffness, given)?;
            return Ok(Constrained { equations, free: inner, lift, down: down_mass, projection });
        }
        let r = n - m;
        let mut damping = RealMatrix::zeros(r + s, r + s);
        let mut stiffness = RealMatrix::zeros(r + s, r + s);
        damping.view_mut((0, 0), (r, r)).copy_from(&own_damping);
        stiffness.view_mut((0, 0), (r, r)).copy_from(&own_stiffness);
        let (mut free, mut all_down) = (RealMatrix::zeros(n, r + s), RealMatrix::zeros(r + s, n));
        free.columns_mut(0, r).copy_from(&inner);
        all_down.rows_mut(0, r).copy_from(&down_mass);
        let wide = |v: &RealVector, at: Option<usize>| {
            let mut all = RealVector::zeros(r + s);
            all.rows_mut(0, v.len()).copy_from(v);
            at.into_iter().for_each(|i| all[r + i] = 1.0);
            all
        };
        let harmonics = given.harmonics.iter().map(|(k, a, b)| (*k, wide(a, None), wide(b, None)));
        let mut force = Periodic { mean: wide(&given.mean, None), harmonics: harmonics.collect() };
        let solver = (r > 0).then(|| own_stiffness.clone().lu());
        let none = RealVector::zeros(0);
        for (i, (row, velocity)) in stuck.iter().enumerate() {
            let b = lift.column(stops.len() + i).into_owned();
            let bent = &down * (&self.stiffness * &b);
            // A singular ZᵀKZ leaves the coupling where it is.
            let settled = solver.as_ref().and_then(|solver| solver.solve(&bent)).filter(|x| {
                let left = (&own_stiffness * x - &bent).amax();
                left <= 1e-9 * bent.amax() && x.amax() <= 1e12 * b.amax()
            });
            let lifted = settled.as_ref().map_or_else(|| b.clone(), |x| &b - &inner * x);
            if r > 0 && settled.is_none() {
                stiffness.view_mut((0, r + i), (r, 1)).copy_from(&bent);
            }
            free.set_column(r + i, &lifted);
            let inertia = &down * (&self.mass * &lifted);
            let drag = &down * (&self.damping * &lifted);
            for j in 0..n {
                all_down[(r + i, j)] = row[j];
                for l in 0..r {
                    all_down[(l, j)] -= inertia[l] * row[j];
                }
            }
            force.add_series(&wide(&-drag, None), velocity);
            let bend = velocity.derivative();
            force.add_series(&wide(&-inertia, None), &bend);
            force.add_series(&wide(&none, Some(i)), &bend);
        }
        let equations = LinearEquations::new(RealMatrix::identity(r + s, r + s), damping, stiffness, force)?;
        Ok(Constrained { equations, free, lift, down: all_down, projection })
    }
}

/// What holds a machine: rows with what they are held at.
pub(crate) struct HeldRows<'a> {
    /// Stops rested on, with their places.
    pub stops: Vec<(&'a RealVector, &'a Series)>,
    /// What sticks, with the velocities of the surfaces.
    pub stuck: Vec<(&'a RealVector, Series)>,
    /// What the forces of all rows act along, a column for each; none if along the rows.
    pub along: Option<RealMatrix>,
}

/// A machine that rests on stops or sticks.
#[derive(Debug, Clone)]
pub(crate) struct Constrained {
    /// The equations of r, and of a place p for each row that sticks.
    pub equations: LinearEquations,
    /// q of (r, p) but for the places of stops.
    pub free: RealMatrix,
    /// The columns b_j of all rows held, n × m.
    pub lift: RealMatrix,
    /// From q to (r, p).
    pub down: RealMatrix,
    /// 1 − b W: of a velocity what the rows allow; Z ZᵀM where forces act along the rows.
    pub projection: RealMatrix,
}

/// An orthonormal basis of the vectors orthogonal to the columns of `seen`, which are independent.
pub(super) fn complement(seen: &RealMatrix) -> RealMatrix {
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
