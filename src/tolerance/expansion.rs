//! N_{n,k} on a cell, by Taylor's formula about its middle.
//!
//! With θ = 2πs, sin θ > 0, the sign of N_{n,k} = u_n − u_k − a₂ᵏ u_{n−k} is that of (62)
//!
//! ```text
//! F = r^{n−k} sin nθ − sin kθ − rⁿ sin (n−k)θ
//! ```
//!
//! Let the parameters be p = (p₁, p₂), their middle c and half widths h. On the cell r(p) − r(c) = Σ rᵢ (pᵢ −
//! cᵢ) with slopes rᵢ that are enclosed, θ likewise, and
//!
//! ```text
//! |F(p) − F(c)| ≤ Σ |F_r rᵢ + F_θ θᵢ| hᵢ + (M_rr R² + 2 M_rθ R T + M_θθ T²)/2,
//! R = Σ |rᵢ| hᵢ,  T = Σ |θᵢ| hᵢ,
//! M_θθ = n² r^{n−k} + k² + (n−k)² rⁿ,   M_rθ = n(n−k)(r^{n−k−1} + r^{n−1}),
//! M_rr = (n−k)(n−k−1) r^{n−k−2} + n(n−1) r^{n−2}
//! ```
//!
//! with F_r, F_θ at c and the powers in M at the largest r of the cell, as |sin|, |cos| ≤ 1. What a cell is,
//! and its slopes, is in `cell`.

use std::cell::RefCell;

use num_rational::BigRational;

use crate::number::{Ball, FloatInterval, Real, Sign};

/// An interval of floats.
pub(super) type F = FloatInterval;

pub(super) fn float(value: &BigRational) -> F {
    F::ratio(value, &())
}

pub(super) fn whole(value: u64) -> F {
    F::integer(value as i32, &())
}

pub(super) fn hull(a: F, b: F) -> F {
    F::from_bounds(a.lo().min(b.lo()), a.hi().max(b.hi()))
}

/// |x| at most.
pub(super) fn most(x: F) -> F {
    let most = x.lo().abs().max(x.hi().abs());
    F::from_bounds(most, most)
}

pub(super) fn short(ball: &Ball) -> F {
    ball.exact_bounds().map_or(F::WHOLE, |(lo, hi)| hull(float(&lo), float(&hi)))
}

/// F about the middle of a cell.
#[derive(Debug)]
pub(super) struct Expansion {
    /// Half the width, for each parameter.
    half: Vec<F>,
    /// Of r and of θ, for each parameter.
    slope: Vec<[F; 2]>,
    /// R and T.
    reach: [F; 2],
    tables: RefCell<Tables>,
}

/// sin jθ, cos jθ and rʲ at the middle, and the powers of the largest r.
#[derive(Debug)]
struct Tables {
    sine: Vec<F>,
    cosine: Vec<F>,
    power: Vec<F>,
    top: Vec<F>,
}

impl Expansion {
    pub fn new(half: Vec<F>, slope: Vec<[F; 2]>, [sine, cosine, r]: [F; 3], top: F) -> Expansion {
        let reach = [0, 1].map(|of| farthest(slope.iter().map(|slope| slope[of]), &half));
        let one = F::integer(1, &());
        let tables = RefCell::new(Tables {
            sine: vec![F::integer(0, &()), sine],
            cosine: vec![one, cosine],
            power: vec![one, r],
            top: vec![one, top],
        });
        Expansion { half, slope, reach, tables }
    }

    /// The sign of F, or the parameter that it varies with most.
    pub fn sign(&self, n: u64, k: u64) -> Result<Sign, usize> {
        self.tables.borrow_mut().fill(n as usize);
        let tables = self.tables.borrow();
        let Tables { sine: s, cosine: c, power: p, top: t } = &*tables;
        let a = n - k;
        let [ni, ki, ai] = [n, k, a].map(|index| index as usize);
        let [nf, kf, af] = [n, k, a].map(whole);
        let value = p[ai] * &s[ni] - &s[ki] - &(p[ni] * &s[ai]);
        let by_angle = nf * &p[ai] * &c[ni] - &(kf * &c[ki]) - &(af * &p[ni] * &c[ai]);
        let by_modulus = af * &p[ai - 1] * &s[ni] - &(nf * &p[ni - 1] * &s[ai]);
        let angles = nf * &nf * &t[ai] + &(kf * &kf) + &(af * &af * &t[ni]);
        let mixed = nf * &af * &(t[ai - 1] + &t[ni - 1]);
        let falling = |m: F, i: usize| match i.checked_sub(2) {
            Some(j) => m * &(m - &F::integer(1, &())) * &t[j],
            None => F::integer(0, &()),
        };
        let moduli = falling(af, ai) + &falling(nf, ni);
        let [rr, tt] = self.reach;
        let two = F::integer(2, &());
        let rest = (moduli * &rr * &rr + &(two * &mixed * &rr * &tt) + &(angles * &tt * &tt)) / &two;
        let slopes = self.slope.iter().map(|[r, angle]| by_modulus * r + &(by_angle * angle));
        let change = farthest(slopes.clone(), &self.half) + &rest;
        if (value - &change).lo() > 0.0 {
            Ok(Sign::Positive)
        } else if (value + &change).hi() < 0.0 {
            Ok(Sign::Negative)
        } else {
            Err(widest(slopes, &self.half))
        }
    }
}

/// How far a function goes from its value in the middle of a cell, whose half widths these are, by the slopes
/// in each parameter.
pub(super) fn farthest(slopes: impl Iterator<Item = F>, half: &[F]) -> F {
    let parts = slopes.zip(half).map(|(slope, half)| most(slope) * half);
    parts.fold(F::integer(0, &()), |sum, part| sum + &part)
}

/// The parameter that brings it farthest, the first of equals.
pub(super) fn widest(slopes: impl Iterator<Item = F>, half: &[F]) -> usize {
    let parts = slopes.zip(half).map(|(slope, half)| (most(slope) * half).hi());
    let farther =
        |found: (usize, f64), (i, part): (usize, f64)| if part > found.1 { (i, part) } else { found };
    parts.enumerate().fold((0, 0.0), farther).0
}

impl Tables {
    /// Up to index n: each from two of half the index, so that errors grow like a power of n.
    fn fill(&mut self, n: usize) {
        for j in self.sine.len()..=n {
            let (i, k) = (j / 2, j - j / 2);
            let sine = self.sine[i] * &self.cosine[k] + &(self.cosine[i] * &self.sine[k]);
            let cosine = self.cosine[i] * &self.cosine[k] - &(self.sine[i] * &self.sine[k]);
            self.sine.push(sine);
            self.cosine.push(cosine);
            self.power.push(self.power[i] * &self.power[k]);
            self.top.push(self.top[i] * &self.top[k]);
        }
    }
}
