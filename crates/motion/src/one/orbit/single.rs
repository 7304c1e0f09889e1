//! Exact orbits with one impact a period: closed formulas for a linear oscillator whose gap has one harmonic.
//!
//! Beyond the paper. Write z for the distance to the wall, positive on the free side, and z = x − g(t) with x
//! a free vibration (no forcing) and g = g₀ + R cos(kt − φ) the wall seen from the forced response. An impact
//! of incoming speed V at phase t₀ adds (0, (1+τ)V) to (x, x′), and n periods later the state just before the
//! next one is the same:
//!
//! ```text
//! (x, x′) = (p₁, p₂) V,   (p₁, p₂) = (I − E_n)⁻¹ E_n (0, 1+τ)ᵀ,   E_n the flow matrix over n periods
//! g(t₀) = p₁ V,   g′(t₀) = (1 + p₂) V,   so   R² = (p₁V − g₀)² + ((1+p₂)V/k)²
//! det = τ² det E_n,   tr = −τ tr E_n − (1+τ)(−k²g₀/V + κ)(E_n)₁₂,   κ = p₁(k² − stiffness) − damping (1+p₂)
//! ```
//!
//! Here are the speeds for given R, and R where the branch folds (saddle-node) or flips. Whether the motion
//! between impacts keeps clear of the wall is not decided here (`admissible`).

use std::f64::consts::PI;

use crate::{
    continuation::Multipliers,
    error::{Error, Result},
    motion::{
        Side, System, Wall,
        algebra::{Matrix2, apply, determinant, resolve, trace},
        flow::Equation,
    },
};

/// The orbits with one impact every `n` periods of 2π at one wall of a linear system.
#[derive(Debug, Clone)]
pub struct SingleImpact {
    damping: f64,
    stiffness: f64,
    restitution: f64,
    /// E_n.
    flow: Matrix2,
    /// (p₁, p₂).
    p: [f64; 2],
    /// g₀.
    mean: f64,
    /// R.
    amplitude: f64,
    /// φ.
    phase: f64,
    k: f64,
}

impl SingleImpact {
    /// The orbits of period `n` at the wall on `side`.
    ///
    /// # Errors
    /// An input error unless the system is linear with a wall there, the forcing and the wall have together
    /// one harmonic, and neither the forced response nor (I − E_n)⁻¹ is infinite.
    pub fn new(system: &System<f64>, side: Side, n: u32) -> Result<SingleImpact> {
        let wall = system.wall(side).ok_or_else(|| {
            Error::input(format!("exact orbits at the {} wall, which is not there", side.name()))
        })?;
        // What of a formula is linear, and a harmonic, is a coefficient here.
        let equation = Equation::new(system)?;
        if equation.cubic != 0.0 {
            return Err(Error::input("exact orbits need a linear system; the cubic stiffness is not 0"));
        }
        if !equation.is_linear() {
            return Err(Error::input(
                "exact orbits need a linear system; the force is a formula that is not",
            ));
        }
        let (k, cos, sin) = relative_harmonic(&equation, wall)?;
        let sign = side.sign();
        let restitution = wall.restitution;
        let flow = flow_matrix(equation.damping, equation.stiffness, 2.0 * PI * f64::from(n));
        let p = resolve(&flow, apply(&flow, [0.0, 1.0 + restitution]))
            .ok_or_else(|| Error::input("det(I − E_n) = 0: a free vibration repeats after n periods"))?;
        let force = equation.forcing.mean();
        let rest = if force == 0.0 { 0.0 } else { force / equation.stiffness };
        Ok(SingleImpact {
            damping: equation.damping,
            stiffness: equation.stiffness,
            restitution,
            flow,
            p,
            mean: sign * (wall.offset - rest),
            amplitude: cos.hypot(sin),
            phase: (sign * sin).atan2(sign * cos),
            k: f64::from(k),
        })
    }

    /// R.
    pub fn amplitude(&self) -> f64 {
        self.amplitude
    }

    /// The speeds V > 0 for which the orbit closes, ascending: none, one or two.
    pub fn speeds(&self) -> Vec<f64> {
        let [p1, p2] = self.slopes();
        let square = p1 * p1 + p2 * p2;
        // (p₁² + p₂²) V² − 2 p₁g₀ V + g₀² − R² = 0; R² − g₀² as a product keeps its digits near grazing.
        let half = p1 * self.mean;
        let rest = (self.amplitude - self.mean.abs()) * (self.amplitude + self.mean.abs());
        let discriminant = half * half + square * rest;
        if discriminant < 0.0 {
            return Vec::new();
        }
        let far = half + discriminant.sqrt().copysign(half);
        let mut speeds = vec![far / square, -rest / far];
        speeds.retain(|speed| *speed > 0.0);
        speeds.sort_by(f64::total_cmp);
        speeds.dedup();
        speeds
    }

    /// The phase t₀ in [0, 2π) of the impact with speed V, any multiple of 2π/k apart from others.
    pub fn phase(&self, speed: f64) -> f64 {
        let [p1, p2] = self.slopes();
        let angle = (-p2 * speed).atan2(p1 * speed - self.mean);
        ((angle + self.phase) / self.k).rem_euclid(2.0 * PI)
    }

    /// The multipliers of the orbit with speed V.
    pub fn multipliers(&self, speed: f64) -> Multipliers {
        let tau = self.restitution;
        let bracket = -self.k * self.k * self.mean / speed + self.kappa();
        Multipliers {
            trace: -tau * trace(&self.flow) - (1.0 + tau) * bracket * self.flow[0][1],
            determinant: self.determinant(),
        }
    }

    /// R on the branch at speed V.
    pub fn amplitude_at(&self, speed: f64) -> f64 {
        let [p1, p2] = self.slopes();
        (p1 * speed - self.mean).hypot(p2 * speed)
    }

    /// The speed where two orbits meet (saddle-node); there R = |g₀ p₂|/√(p₁² + p₂²), p₂ short for (1+p₂)/k.
    /// `None` if p₁g₀ ≤ 0.
    pub fn fold(&self) -> Option<f64> {
        let [p1, p2] = self.slopes();
        Some(p1 * self.mean / (p1 * p1 + p2 * p2)).filter(|speed| *speed > 0.0)
    }

    /// The speed where a multiplier is −1 (flip): tr = −(1 + det). `None` if it is not positive.
    pub fn flip(&self) -> Option<f64> {
        let tau = self.restitution;
        let wanted = 1.0 + self.determinant() - tau * trace(&self.flow);
        let bracket = wanted / ((1.0 + tau) * self.flow[0][1]);
        Some(-self.k * self.k * self.mean / (bracket - self.kappa())).filter(|speed| *speed > 0.0)
    }

    /// p₁ and (1 + p₂)/k.
    fn slopes(&self) -> [f64; 2] {
        [self.p[0], (1.0 + self.p[1]) / self.k]
    }

    fn kappa(&self) -> f64 {
        self.p[0] * (self.k * self.k - self.stiffness) - self.damping * (1.0 + self.p[1])
    }

    fn determinant(&self) -> f64 {
        self.restitution * self.restitution * determinant(&self.flow)
    }
}

/// The only harmonic (k, cos, sin) of the wall less the forced response.
fn relative_harmonic(equation: &Equation, wall: &Wall<f64>) -> Result<(u32, f64, f64)> {
    let mut found: Option<(u32, f64, f64)> = None;
    let mut add = |k: u32, cos: f64, sin: f64| {
        if cos == 0.0 && sin == 0.0 {
            return Ok(());
        }
        match &mut found {
            Some(one) if one.0 != k => Err(Error::input(format!(
                "exact orbits need one harmonic in forcing and wall together; here are k = {} and k = {k}",
                one.0
            ))),
            Some(one) => {
                *one = (k, one.1 + cos, one.2 + sin);
                Ok(())
            }
            None => {
                found = Some((k, cos, sin));
                Ok(())
            }
        }
    };
    for h in &wall.harmonics {
        add(h.k, h.cos, h.sin)?;
    }
    for h in equation.forcing.harmonics() {
        // The response to F e^{−ikt} is F e^{−ikt}/(stiffness − k² − ik damping), with F = cos + i sin.
        let k = f64::from(h.k);
        let (re, im) = (equation.stiffness - k * k, -k * equation.damping);
        let square = re * re + im * im;
        let (cos, sin) = ((h.cos * re + h.sin * im) / square, (h.sin * re - h.cos * im) / square);
        add(h.k, -cos, -sin)?;
    }
    let found = found.ok_or_else(|| Error::input("exact orbits need a harmonic: nothing moves here"))?;
    if !(found.1.is_finite() && found.2.is_finite()) {
        return Err(Error::input("the forcing is in resonance: no bounded response"));
    }
    Ok(found)
}

/// exp(t [[0, 1], [−stiffness, −damping]]).
fn flow_matrix(damping: f64, stiffness: f64, t: f64) -> Matrix2 {
    let half = damping / 2.0;
    let square = stiffness - half * half;
    let omega = square.abs().sqrt();
    let (c, s) = match square {
        _ if omega * t == 0.0 => (1.0, t),
        x if x > 0.0 => ((omega * t).cos(), (omega * t).sin() / omega),
        _ => ((omega * t).cosh(), (omega * t).sinh() / omega),
    };
    let decay = (-half * t).exp();
    [[decay * (c + half * s), decay * s], [-decay * stiffness * s, decay * (c - half * s)]]
}
