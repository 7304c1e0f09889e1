//! Responses of pairs of coordinates that do not oscillate as real modes do, by complex exponentials.

use std::f64::consts::TAU;

use nalgebra::Complex;

use crate::{
    error::Result,
    many::{Periodic, RealVector, pair::Pair},
    motion::{Harmonic, Series},
};

/// Nearer than this to an eigenvalue a periodic response would be large and cancel: a secular one takes its
/// place.
const NEAR: f64 = 1.0 / 16.0;

/// ζ with ζ′ = λζ + Σ z e^{iκt}.
#[derive(Debug, Clone)]
pub(super) struct Response {
    lambda: Complex<f64>,
    /// κ, z, and whether the response starts from rest at 0: then it is z (e^{iκt} − e^{λt})/(iκ − λ), else z
    /// e^{iκt}/(iκ − λ).
    terms: Vec<(f64, Complex<f64>, bool)>,
}

impl Response {
    fn new(lambda: Complex<f64>, terms: impl Iterator<Item = (f64, Complex<f64>)>) -> Response {
        let terms = terms.filter(|(_, z)| z.norm() > 0.0);
        let near = |kappa: f64| (Complex::new(0.0, kappa) - lambda).norm() < NEAR;
        Response { lambda, terms: terms.map(|(kappa, z)| (kappa, z, near(kappa))).collect() }
    }

    pub(super) fn at(&self, t: f64) -> Complex<f64> {
        self.terms.iter().fold(Complex::new(0.0, 0.0), |sum, term| sum + self.term(term, t))
    }

    fn term(&self, &(kappa, z, near): &(f64, Complex<f64>, bool), t: f64) -> Complex<f64> {
        let away = Complex::new(0.0, kappa) - self.lambda;
        if !near {
            return z * Complex::from_polar(1.0, kappa * t) / away;
        }
        // (e^{iκt} − e^{λt})/(iκ − λ) = t e^{(iκ + λ)t/2} sinhc((iκ − λ)t/2), of which |(iκ − λ)t/2| < 1/5.
        let middle = (Complex::new(0.0, kappa) + self.lambda) * (t / 2.0);
        z * middle.exp() * sinhc(away * (t / 2.0)) * t
    }

    /// Whether it is periodic: no term starts from rest.
    pub(super) fn is_periodic(&self) -> bool {
        self.terms.iter().all(|term| !term.2)
    }

    /// Its real or its imaginary part, if it is periodic.
    pub(super) fn series(&self, imaginary: bool) -> Result<Series> {
        let mut mean = 0.0;
        let mut harmonics = Vec::new();
        for &(kappa, z, _) in &self.terms {
            let c = z / (Complex::new(0.0, kappa) - self.lambda);
            // c e^{iκt} = (c.re cos − c.im sin) + i (c.im cos + c.re sin) of κt.
            let (cos, sin) = if imaginary { (c.im, c.re) } else { (c.re, -c.im) };
            if kappa == 0.0 {
                mean += cos;
            } else {
                harmonics.push(Harmonic { k: kappa.abs() as u32, cos, sin: sin * kappa.signum() });
            }
        }
        Series::new(mean, &harmonics)
    }

    /// The response at 2π less that at 0.
    pub(super) fn step(&self) -> Complex<f64> {
        let secular = self.terms.iter().filter(|term| term.2);
        secular.fold(Complex::new(0.0, 0.0), |sum, term| sum + self.term(term, TAU))
    }
}

/// sinh(x)/x for |x| ≤ 1/2, to 2⁻⁶⁰.
fn sinhc(x: Complex<f64>) -> Complex<f64> {
    let square = x * x;
    (1..=8).rev().fold(Complex::new(1.0, 0.0), |sum, i| {
        square * sum / f64::from(2 * i * (2 * i + 1)) + Complex::new(1.0, 0.0)
    })
}

/// The responses of a pair: one complex number, or two real ones.
pub(super) fn responses(pair: Pair, force: &Periodic, at: usize) -> [Response; 2] {
    let terms = |weight: fn(&RealVector, usize) -> Complex<f64>, at: usize| {
        let i = Complex::new(0.0, 1.0);
        let mut all = vec![(0.0, weight(&force.mean, at))];
        for (k, a, b) in &force.harmonics {
            let (a, b, k) = (weight(a, at), weight(b, at), f64::from(*k));
            all.extend([(k, (a - i * b) * 0.5), (-k, (a + i * b) * 0.5)]);
        }
        all.into_iter()
    };
    let none = || Response::new(Complex::new(0.0, 0.0), std::iter::empty());
    match pair {
        Pair::Spiral { rate, turn } => {
            let both = |v: &RealVector, at: usize| Complex::new(v[at], v[at + 1]);
            [Response::new(Complex::new(rate, turn), terms(both, at)), none()]
        }
        Pair::Two(rates) => {
            let one = |v: &RealVector, at: usize| Complex::new(v[at], 0.0);
            [0, 1].map(|j| Response::new(Complex::new(rates[j], 0.0), terms(one, at + j)))
        }
        Pair::Mode { .. } => [none(), none()],
    }
}

pub(super) fn real_pair(pair: Pair, [first, second]: [Complex<f64>; 2]) -> [f64; 2] {
    if matches!(pair, Pair::Two(_)) { [first.re, second.re] } else { [first.re, first.im] }
}
