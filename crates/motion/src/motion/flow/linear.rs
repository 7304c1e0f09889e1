//! The linear flow in closed form: homogeneous motion by one exponential, plus one particular solution.

use super::{Equation, response::Response};
use crate::{
    error::{Error, Result},
    motion::{
        Flow, Series, State, System,
        algebra::{Matrix2, apply},
    },
};

/// q″ + c q′ + s q = f(t) solved: x(t) = p(t) + E(t − t₀)(x(t₀) − p(t₀)), with E the exponential of the
/// companion matrix and p a particular solution that stays moderate at and near resonance. Every damping and
/// stiffness is allowed, also negative. Error: a few units in the last place of the largest of E's entries
/// and p's terms, times 1 + |ω|·duration.
#[derive(Debug, Clone)]
pub struct Linear {
    equation: Equation,
    exponential: Exponential,
    response: Response,
}

impl Linear {
    /// Solves the equation; the walls are not looked at.
    ///
    /// # Errors
    /// A cubic term or another force that is not linear, or a coefficient that is not finite.
    pub fn new(system: &System<f64>) -> Result<Self> {
        if system.cubic != 0.0 {
            return Err(Error::input(format!(
                "cubic = {}: only linear systems have a closed form",
                system.cubic
            )));
        }
        let equation = Equation::new(system)?;
        if !equation.is_linear() {
            return Err(Error::input("the force is not linear: only linear systems have a closed form"));
        }
        Linear::of(equation)
    }

    /// Solves a linear equation.
    pub(super) fn of(equation: Equation) -> Result<Self> {
        let exponential = Exponential::new(equation.damping, equation.stiffness);
        let response = Response::new(&equation, exponential);
        Ok(Linear { equation, exponential, response })
    }

    /// E(duration).
    pub fn matrix(&self, duration: f64) -> Matrix2 {
        self.exponential.at(duration)
    }

    /// The particular solution (p, p′) at t; 2π-periodic unless [`step`](Self::step) is not zero.
    pub(crate) fn particular(&self, t: f64) -> [f64; 2] {
        self.response.at(t)
    }

    /// p(t + 2π) at t = 0 less p(0): zero but for terms near resonance.
    pub(crate) fn step(&self) -> [f64; 2] {
        self.response.step()
    }

    /// p, if it is periodic.
    pub(crate) fn periodic(&self) -> Option<Series> {
        self.response.periodic()
    }

    pub(crate) fn equation(&self) -> &Equation {
        &self.equation
    }

    /// The largest modulus of an eigenvalue.
    pub(crate) fn rate(&self) -> f64 {
        self.exponential.rate()
    }
}

impl Flow for Linear {
    fn acceleration(&self, at: State) -> f64 {
        self.equation.acceleration(at)
    }

    fn advance(&self, from: State, duration: f64) -> State {
        self.advance_linearised(from, duration).0
    }

    fn advance_linearised(&self, from: State, duration: f64) -> (State, Matrix2) {
        let matrix = self.matrix(duration);
        let (t, here) = (from.t + duration, self.particular(from.t));
        (carried(&matrix, from, here, t, self.particular(t)), matrix)
    }
}

/// The state at t, `here` and `there` being the particular solution where the motion starts and at t, and
/// `matrix` that of the time between.
pub(super) fn carried(matrix: &Matrix2, from: State, here: [f64; 2], t: f64, there: [f64; 2]) -> State {
    let [q, u] = apply(matrix, [from.q - here[0], from.u - here[1]]);
    State { t, q: q + there[0], u: u + there[1] }
}

/// t ↦ exp(t [[0, 1], [−s, −c]]).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Exponential {
    pub damping: f64,
    pub stiffness: f64,
    /// The square root of |s − c²/4|.
    pub root: f64,
    /// Whether s > c²/4.
    pub oscillates: bool,
}

impl Exponential {
    pub fn new(damping: f64, stiffness: f64) -> Self {
        let discriminant = stiffness - damping * damping / 4.0;
        Exponential { damping, stiffness, root: discriminant.abs().sqrt(), oscillates: discriminant > 0.0 }
    }

    /// The real eigenvalues −c/2 ± root, each without cancellation: their product is s.
    pub fn real_eigenvalues(&self) -> [f64; 2] {
        let far = -self.damping / 2.0 - self.root.copysign(self.damping);
        if far == 0.0 { [0.0; 2] } else { [self.stiffness / far, far] }
    }

    pub fn rate(&self) -> f64 {
        if self.oscillates { self.stiffness.sqrt() } else { self.damping.abs() / 2.0 + self.root }
    }

    /// The matrix at t. With C = cos or cosh, S = sin or sinh over the root (t at a root of 0: near critical
    /// damping nothing cancels, both are entire in s − c²/4), it is e^{−ct/2} [[C + cS/2, S], [−sS, C −
    /// cS/2]]; far from critical damping by e^{λt} for each λ, so that neither overflow nor cancellation
    /// touches the slow one.
    pub fn at(&self, t: f64) -> Matrix2 {
        let (c, s, angle) = (self.damping, self.stiffness, self.root * t);
        if !self.oscillates && angle.abs() > 0.5 {
            let [slow, fast] = self.real_eigenvalues();
            let (x, y, gap) = ((slow * t).exp(), (fast * t).exp(), slow - fast);
            let off = (x - y) / gap;
            return [[(slow * y - fast * x) / gap, off], [-s * off, (slow * x - fast * y) / gap]];
        }
        let (sin, cos) = if self.oscillates { angle.sin_cos() } else { (angle.sinh(), angle.cosh()) };
        let sin = if angle == 0.0 { t } else { sin / self.root };
        let (decay, half) = (if c == 0.0 { 1.0 } else { (-c * t / 2.0).exp() }, c / 2.0 * sin);
        [[decay * (cos + half), decay * sin], [-s * decay * sin, decay * (cos - half)]]
    }
}
