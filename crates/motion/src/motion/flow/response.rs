//! A particular solution of the forced linear equation that stays moderate at and near resonance.

use super::{Equation, linear::Exponential};
use crate::motion::{
    Harmonic, Series,
    algebra::{divide, scale, times},
};
use std::f64::consts::TAU;

/// Below this distance of i k from an eigenvalue (of 0 from a stiffness for the constant force) the periodic
/// response would be large and cancel against the homogeneous motion: a secular term takes its place.
const NEAR: f64 = 1.0 / 16.0;

/// p with p″ + c p′ + s p = f, as the sum over the terms of f.
#[derive(Debug, Clone)]
pub(super) struct Response {
    exponential: Exponential,
    /// The constant part: F / s.
    rest: f64,
    /// The periodic parts.
    periodic: Vec<Harmonic<f64>>,
    /// F where s is too small to divide by.
    push: f64,
    /// Harmonics of f near resonance.
    resonant: Vec<Resonant>,
}

/// The secular response to one harmonic, Re(z w(t)) with w = (e^{ikt} − e^{λt}) / (ik − λ): the solution of
/// (D − λ) w = e^{ikt} at rest at 0, which tends to t e^{ikt} as λ → ik. As λ̄ is far from ik, z = (cos − i
/// sin) / (ik − λ̄).
#[derive(Debug, Clone, Copy)]
struct Resonant {
    k: f64,
    z: [f64; 2],
    /// (ik − λ) / 2.
    half: [f64; 2],
}

impl Response {
    pub fn new(equation: &Equation, exponential: Exponential) -> Self {
        let (c, s, force) = (equation.damping, equation.stiffness, equation.forcing.mean());
        let (rest, push) = if force == 0.0 || s.abs() >= NEAR { (force / s, 0.0) } else { (0.0, force) };
        let rest = if force == 0.0 { 0.0 } else { rest };
        let mut response = Response { exponential, rest, push, periodic: Vec::new(), resonant: Vec::new() };
        for h in equation.forcing.harmonics() {
            let k = f64::from(h.k);
            // λ = −c/2 + i root; (k − root)(k + root) = k² − s + c²/4 keeps the small difference exact.
            let sum = k + exponential.root;
            let half = [c / 4.0, ((k * k - s) + c * c / 4.0) / sum / 2.0];
            if exponential.oscillates && 2.0 * half[0].hypot(half[1]) < NEAR {
                let z = divide([h.cos, -h.sin], [c / 2.0, sum]);
                response.resonant.push(Resonant { k, z, half });
            } else {
                // χ(ik) = s − k² + i c k
                let [cos, sin] = divide([h.cos, -h.sin], [s - k * k, c * k]);
                response.periodic.push(Harmonic { k: h.k, cos, sin: -sin });
            }
        }
        response
    }

    /// p as a series, if no part of it is secular.
    pub fn periodic(&self) -> Option<Series> {
        if self.push != 0.0 || !self.resonant.is_empty() {
            return None;
        }
        Series::new(self.rest, &self.periodic).ok()
    }

    /// (p, p′) at t.
    pub fn at(&self, t: f64) -> [f64; 2] {
        let mut sum = [self.rest, 0.0];
        for h in &self.periodic {
            let k = f64::from(h.k);
            let (sin, cos) = (k * t).sin_cos();
            sum[0] += h.cos * cos + h.sin * sin;
            sum[1] += k * (h.sin * cos - h.cos * sin);
        }
        for resonant in &self.resonant {
            let [p, slope] = resonant.at(t);
            sum = [sum[0] + p, sum[1] + slope];
        }
        if self.push != 0.0 {
            let [p, slope] = pushed(&self.exponential, t);
            sum = [sum[0] + self.push * p, sum[1] + self.push * slope];
        }
        sum
    }

    /// What p gains from 0 to 2π; the periodic parts gain exactly nothing.
    pub fn step(&self) -> [f64; 2] {
        let secular = Response { rest: 0.0, periodic: Vec::new(), ..self.clone() };
        let (start, end) = (secular.at(0.0), secular.at(TAU));
        [end[0] - start[0], end[1] - start[1]]
    }
}

impl Resonant {
    /// Re(z w), Re(z w′), with w = t e^{(ik + λ)t/2} sinhc((ik − λ)t/2) and w′ = λ w + e^{ikt}.
    fn at(&self, t: f64) -> [f64; 2] {
        let Resonant { k, z, half } = *self;
        let forced = unit(k * t);
        let x = [half[0] * t, half[1] * t];
        // (ik + λ)t/2 = ikt − (ik − λ)t/2
        let middle = scale(times(forced, unit(-x[1])), (-x[0]).exp());
        let w = scale(times(middle, sinhc(x)), t);
        let lambda = [-2.0 * half[0], k - 2.0 * half[1]];
        let slope = times(lambda, w);
        [times(z, w)[0], times(z, [slope[0] + forced[0], slope[1] + forced[1]])[0]]
    }
}

/// The response to the constant force 1 from rest at 0: p″ + c p′ + s p = 1, for |s| < `NEAR`. p′ is E₁₂; p
/// is its integral, by whichever of three forms does not cancel: (1 − E₁₁)/s, a Taylor series, or both real
/// eigenvalues apart.
fn pushed(exponential: &Exponential, t: f64) -> [f64; 2] {
    let (c, s) = (exponential.damping, exponential.stiffness);
    let e = exponential.at(t);
    let p = if s.abs() * t * t >= 0.25 {
        (1.0 - e[0][0]) / s
    } else if (c * t).abs() <= 2.0 {
        // p = Σ a_i with a_{i+2} = −(c t (i+1) a_{i+1} + s t² a_i) / ((i+1)(i+2)), a₂ = t²/2.
        let (mut before, mut here, mut sum) = (0.0, t * t / 2.0, t * t / 2.0);
        for i in 1..30 {
            let i = f64::from(i);
            let next = -(c * t * (i + 1.0) * here + s * t * t * before) / ((i + 1.0) * (i + 2.0));
            (before, here, sum) = (here, next, sum + next);
        }
        sum
    } else {
        let [slow, fast] = exponential.real_eigenvalues();
        let integral = |rate: f64| if rate == 0.0 { t } else { (rate * t).exp_m1() / rate };
        (integral(slow) - integral(fast)) / (slow - fast)
    };
    [p, e[0][1]]
}

/// sinh(x)/x for |x| well below 1: the series to 2⁻⁶⁰ for |x| ≤ 1/2, the quotient beyond.
fn sinhc(x: [f64; 2]) -> [f64; 2] {
    let square = times(x, x);
    if x[0].abs() + x[1].abs() > 0.5 {
        let (sin, cos) = x[1].sin_cos();
        return divide([x[0].sinh() * cos, x[0].cosh() * sin], x);
    }
    (1..=8).rev().fold([1.0, 0.0], |sum, i| {
        let term = scale(times(square, sum), 1.0 / f64::from(2 * i * (2 * i + 1)));
        [1.0 + term[0], term[1]]
    })
}

fn unit(angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos, sin]
}
