//! The motion between impacts: closed form for linear systems, Taylor series with a tolerance for all. A
//! smooth force is compiled once, to a list of operations on series; what of it is linear, cubic or a
//! harmonic joins the equation's own coefficients, and nothing of it remains if it is all of that kind.
//!
//! Not here: walls and what happens at them (`system`), when they are met (`simulate`).

mod linear;
mod program;
mod response;
mod scalar;
mod taylor;

pub use linear::Linear;
use linear::carried;
pub(crate) use program::{Drive, Obstacle, Outline, Program, Rows};
pub(crate) use scalar::{Gradient, Primitive, Range, Scalar, value};
pub use taylor::Taylor;
pub(crate) use taylor::{
    Expansion, GAUSS, LEAST, MOST_STEPS, Recurrence, SHORTEST, Size, TERMS, defect, too_many,
};

use std::sync::Arc;

use super::{EffectTally, Flow, Harmonic, Matrix2, Series, State, System, finite};
use crate::error::{Error, Result};

/// The flow that suits a system: closed form if it is linear, else Taylor series.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum Free {
    /// Neither a cubic term nor another force that is not linear.
    Linear(Linear),
    /// Duffing, any smooth force, or any system on demand.
    Taylor(Taylor),
}

/// What a step of a linear flow leaves to the next.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Kept {
    duration: f64,
    /// Of that duration.
    matrix: Matrix2,
    /// The end.
    t: f64,
    /// The particular solution there.
    particular: [f64; 2],
}

impl Free {
    /// The flow of a system without its walls; `tolerance` is that of `Taylor::new` and not looked at in
    /// closed form.
    ///
    /// # Errors
    /// Those of [`Linear::new`] and `Taylor::new`.
    pub fn new(system: &System<f64>, tolerance: f64) -> Result<Self> {
        let equation = Equation::new(system)?;
        if equation.is_linear() {
            Linear::of(equation).map(Free::Linear)
        } else {
            Taylor::of(equation, tolerance).map(Free::Taylor)
        }
    }

    /// The same flow, the steps of its integrator added up in `tally`; the closed form has none.
    #[must_use]
    pub(crate) fn counting(self, tally: Arc<EffectTally>) -> Self {
        match self {
            Free::Linear(flow) => Free::Linear(flow),
            Free::Taylor(flow) => Free::Taylor(flow.counting(tally)),
        }
    }

    /// Where a motion cannot be followed any farther, and why, if that is before its end.
    pub(crate) fn obstacle(&self, from: State, duration: f64) -> Option<(State, Obstacle)> {
        match self {
            Free::Linear(_) => None,
            Free::Taylor(flow) => flow.obstacle(from, duration),
        }
    }

    /// As [`Flow::advance`], for steps that follow each other: of a linear flow what a step has in common
    /// with the one before is kept.
    pub(crate) fn step(&self, from: State, duration: f64, kept: &mut Option<Kept>) -> State {
        let Free::Linear(flow) = self else { return self.advance(from, duration) };
        let (matrix, here) = match kept {
            Some(kept) => (
                if kept.duration == duration { kept.matrix } else { flow.matrix(duration) },
                if kept.t == from.t { kept.particular } else { flow.particular(from.t) },
            ),
            None => (flow.matrix(duration), flow.particular(from.t)),
        };
        let t = from.t + duration;
        let there = flow.particular(t);
        *kept = Some(Kept { duration, matrix, t, particular: there });
        carried(&matrix, from, here, t, there)
    }

    /// The integrator, if the force is neither linear nor cubic.
    pub(crate) fn by_program(&self) -> Option<&Taylor> {
        match self {
            Free::Taylor(flow) if flow.equation().smooth.is_some() => Some(flow),
            _ => None,
        }
    }

    /// As [`advance_linearised`](Flow::advance_linearised), by one step at most where the force is a formula:
    /// over that a motion cannot contract by much. How far it went comes last.
    pub(crate) fn step_linearised(&self, from: State, longest: f64) -> (State, Matrix2, f64) {
        if let Some(found) = self.by_program().and_then(|flow| flow.step_linearised(from, longest)) {
            return found;
        }
        let (end, matrix) = self.advance_linearised(from, longest);
        (end, matrix, longest)
    }

    /// The equation between impacts.
    pub fn equation(&self) -> &Equation {
        match self {
            Free::Linear(flow) => flow.equation(),
            Free::Taylor(flow) => flow.equation(),
        }
    }

    /// det of the derivative of [`advance`](Flow::advance), by Liouville: exp ∫ ∂q″/∂q′ dt along the motion,
    /// which keeps its digits where those of the matrix are lost by cancellation. NaN where the motion cannot
    /// be followed. Cost: none if ∂q″/∂q′ is constant, else the motion's and 8 evaluations per step.
    pub(crate) fn determinant(&self, from: State, duration: f64) -> f64 {
        match (self.equation().constant_divergence(), self) {
            (Some(rate), _) => (rate * duration).exp(),
            (None, Free::Taylor(flow)) => flow.divergence(from, duration).exp(),
            (None, Free::Linear(_)) => unreachable!("a linear equation has a constant divergence"),
        }
    }
}

impl Flow for Free {
    fn acceleration(&self, at: State) -> f64 {
        match self {
            Free::Linear(flow) => flow.acceleration(at),
            Free::Taylor(flow) => flow.acceleration(at),
        }
    }

    fn advance(&self, from: State, duration: f64) -> State {
        match self {
            Free::Linear(flow) => flow.advance(from, duration),
            Free::Taylor(flow) => flow.advance(from, duration),
        }
    }

    fn advance_linearised(&self, from: State, duration: f64) -> (State, Matrix2) {
        match self {
            Free::Linear(flow) => flow.advance_linearised(from, duration),
            Free::Taylor(flow) => flow.advance_linearised(from, duration),
        }
    }
}

/// The equation of motion without walls, checked and in normal form; −0 is 0.
#[derive(Debug, Clone)]
pub struct Equation {
    /// Over the mass, as all of it.
    pub damping: f64,
    /// The linear part.
    pub stiffness: f64,
    /// The coefficient of q³.
    pub cubic: f64,
    /// Forcing with the constant force as its mean.
    pub forcing: Series,
    /// The whole equation again, all of the above in it, where these terms are not all of it.
    pub(crate) smooth: Option<Arc<Smooth>>,
}

/// An equation of motion that is not linear but for a cubic term.
#[derive(Debug)]
pub(crate) struct Smooth {
    pub program: Program<f64>,
    /// With the derivatives by q and u at the start.
    pub varied: Program<Gradient<3>>,
    system: System<f64>,
}

impl Smooth {
    /// The equation in other numbers.
    ///
    /// # Errors
    /// Those of [`Program::new`].
    pub fn program_in<S: Scalar>(&self) -> Result<Program<S>> {
        Program::new(&self.system.try_map(|x| Ok::<_, Error>(S::constant(*x)))?)
    }
}

impl Equation {
    /// That of a system.
    ///
    /// # Errors
    /// An input error if a coefficient is not finite.
    pub fn new(system: &System<f64>) -> Result<Self> {
        for (name, value) in
            [("damping", system.damping), ("stiffness", system.stiffness), ("cubic", system.cubic)]
        {
            finite(name, value)?;
        }
        let forcing = Series::new(system.force, &system.forcing).map_err(|e| e.context("forcing"))?;
        let equation = Equation {
            damping: system.damping + 0.0,
            stiffness: system.stiffness + 0.0,
            cubic: system.cubic + 0.0,
            forcing,
            smooth: None,
        };
        if system.smooth.is_some() { equation.with(system) } else { Ok(equation) }
    }

    /// The equation with the system's smooth force.
    fn with(self, system: &System<f64>) -> Result<Self> {
        let system = System { lower: None, upper: None, ..system.clone() };
        for coefficient in system.smooth.iter().flat_map(|force| &force.coefficients) {
            finite("a coefficient of the force", *coefficient)?;
        }
        let wrong = |e: Error| e.context("force");
        let program = Program::new(&system).map_err(wrong)?;
        if let Some(plain) = program.plain() {
            let harmonics: Vec<Harmonic<f64>> = plain
                .drive
                .iter()
                .map(|drive| Harmonic { k: drive.k as u32, cos: drive.cos, sin: drive.sin })
                .collect();
            let forcing = Series::new(plain.force, &harmonics).map_err(wrong)?;
            let (damping, stiffness) = (plain.damping + 0.0, plain.stiffness + 0.0);
            return Ok(Equation { damping, stiffness, cubic: plain.cubic + 0.0, forcing, smooth: None });
        }
        let varied = Program::new(&system.try_map(|x| Ok::<_, Error>(Gradient::constant(*x)))?)?;
        Ok(Equation { smooth: Some(Arc::new(Smooth { program, varied, system })), ..self })
    }

    /// Whether it has a closed form.
    pub fn is_linear(&self) -> bool {
        self.cubic == 0.0 && self.smooth.is_none()
    }

    /// Whether the time enters.
    pub fn is_driven(&self) -> bool {
        self.forcing.order() > 0 || self.smooth.as_ref().is_some_and(|smooth| smooth.program.is_driven())
    }

    /// ∂q″/∂q′ where neither state nor time change it: then a period's map shrinks all areas alike.
    pub fn constant_divergence(&self) -> Option<f64> {
        match &self.smooth {
            None => Some(-self.damping),
            Some(smooth) => smooth.program.rate_factor(),
        }
    }

    /// ∂q″/∂q′ at a state.
    fn divergence(&self, State { t, q, u }: State) -> f64 {
        let Some(smooth) = &self.smooth else { return -self.damping };
        let u = Gradient::variable(u, 2);
        smooth.varied.at(Gradient::constant(q), u, Gradient::constant(t)).part(2)
    }

    /// Whether it is its own mirror image half a period later, (q, u, t) ↦ (−q, −u, t + π).
    pub fn is_mirrored(&self) -> bool {
        let Some(smooth) = &self.smooth else {
            let odd = |h: &Harmonic<f64>| h.k % 2 == 1 || (h.cos == 0.0 && h.sin == 0.0);
            return self.forcing.mean() == 0.0 && self.forcing.harmonics().iter().all(odd);
        };
        smooth.program.is_mirrored()
    }

    /// The same without force and forcing.
    pub fn unforced(&self) -> Self {
        Equation { forcing: Series::ZERO, smooth: None, ..*self }
    }

    /// q″ there.
    pub fn acceleration(&self, at: State) -> f64 {
        if let Some(smooth) = &self.smooth {
            return smooth.program.at(at.q, at.u, at.t);
        }
        let smooth = -self.damping * at.u - (self.stiffness + self.cubic * at.q * at.q) * at.q;
        smooth + self.forcing.at(at.t)[0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::Harmonic;

    fn system(damping: f64, stiffness: f64, force: f64, forcing: &[(u32, f64, f64)]) -> System<f64> {
        let forcing = forcing.iter().map(|&(k, cos, sin)| Harmonic { k, cos, sin }).collect();
        System { damping, stiffness, force, forcing, ..System::default() }
    }

    /// Damped, undamped, critical and nearly, zero and negative stiffness, resonant and nearly, with force
    /// and harmonics.
    fn systems() -> Vec<System<f64>> {
        let mut all = Vec::new();
        for (c, s) in [
            (0.3, 2.0),
            (0.0, 1.7),
            (2.0, 1.0),
            (2.0, 1.0 + 1e-9),
            (2.0, 1.0 - 1e-9),
            (2.0, 1.001),
            (6.0, 1.0),
            (40.0, 0.01),
            (0.5, 0.0),
            (0.0, 0.0),
            (0.0, 1e-12),
            (1e-9, -1e-10),
            (0.1, -0.5),
            (-0.2, 1.0),
            (0.0, 1.0),
            (0.0, 1.0 + 1e-10),
            (1e-6, 4.0 - 1e-7),
            (0.05, 4.05),
            (0.1249, 1.0),
            (0.126, 1.0),
        ] {
            all.push(system(c, s, 0.7, &[(1, 1.0, 0.5), (2, -0.3, 0.2), (5, 0.1, 0.0)]));
            all.push(system(c, s, 0.0, &[]));
        }
        all
    }

    const START: State = State { t: 0.9, q: 0.4, u: -0.8 };

    #[test]
    fn gauss_s_rule_is_exact_up_to_degree_fifteen() {
        for degree in 0..16 {
            let sum: f64 = GAUSS.iter().map(|(x, weight)| weight * x.powi(degree)).sum();
            assert!((sum - 1.0 / f64::from(degree + 1)).abs() < 1e-15, "{degree}: {sum}");
        }
    }

    #[test]
    fn the_closed_form_agrees_with_the_integrator() {
        for system in systems() {
            let (linear, taylor) = (Linear::new(&system).unwrap(), Taylor::new(&system, 1e-15).unwrap());
            for duration in [1e-7, 0.3, 3.0, 12.0, -2.0] {
                let (x, m) = linear.advance_linearised(START, duration);
                let (y, n) = taylor.advance_linearised(START, duration);
                let size = m.iter().flatten().fold(1.0 + x.q.abs() + x.u.abs(), |size, e| size.max(e.abs()));
                let mut off = (x.q - y.q).abs().max((x.u - y.u).abs());
                for (a, b) in m.iter().flatten().zip(n.iter().flatten()) {
                    off = off.max((a - b).abs());
                }
                assert!(off < 4e-13 * size, "{system:?} over {duration}: {off:e} of {size}");
            }
        }
    }

    #[test]
    fn the_closed_form_composes_and_turns_back() {
        for system in systems() {
            let flow = Linear::new(&system).unwrap();
            let there = flow.advance(flow.advance(START, 1.3), 2.1);
            let once = flow.advance(START, 3.4);
            let back = flow.advance(once, -3.4);
            let size = 1.0 + once.q.abs() + once.u.abs();
            let (m, n) = (flow.matrix(3.4), flow.matrix(-3.4));
            let growth = m.iter().flatten().chain(n.iter().flatten()).fold(1.0, |a: f64, b| a.max(b.abs()));
            assert!((there.q - once.q).abs().max((there.u - once.u).abs()) < 2e-14 * size, "{system:?}");
            let off = (back.q - START.q).abs().max((back.u - START.u).abs());
            assert!(off < 2e-14 * size * growth, "{system:?}: {off:e}");
        }
    }

    /// To the bit, when the steps are equal, when they are not, and when they do not follow each other.
    #[test]
    fn what_steps_have_in_common_changes_nothing() {
        for system in systems() {
            let (flow, mut kept, mut from) = (Free::new(&system, 1e-12).unwrap(), None, START);
            for duration in [0.1, 0.1, 0.1, 0.03, 0.1, -0.1, 0.0, 0.0, 1.7] {
                let end = flow.step(from, duration, &mut kept);
                assert_eq!(end, flow.advance(from, duration), "{system:?}");
                from =
                    if duration == 0.03 { State { t: 5.5, ..end } } else { State { u: end.u + 0.1, ..end } };
            }
        }
    }

    #[test]
    fn the_variation_of_a_duffing_oscillator_is_its_derivative() {
        let duffing = System { cubic: 0.9, ..system(0.1, -0.5, 0.1, &[(1, 0.4, 0.3)]) };
        let flow = Taylor::new(&duffing, 1e-15).unwrap();
        let (end, m) = flow.advance_linearised(START, 5.0);
        let h = 1e-5;
        for (j, [dq, du]) in [[h, 0.0], [0.0, h]].into_iter().enumerate() {
            let shifted =
                |f: f64| flow.advance(State { q: START.q + f * dq, u: START.u + f * du, ..START }, 5.0);
            let (plus, minus) = (shifted(1.0), shifted(-1.0));
            let column = [(plus.q - minus.q) / (2.0 * h), (plus.u - minus.u) / (2.0 * h)];
            for i in 0..2 {
                assert!(
                    (column[i] - m[i][j]).abs() < 3e-7 * (1.0 + m[i][j].abs()),
                    "{i}{j}: {column:?} {m:?}"
                );
            }
        }
        let determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
        assert!((determinant - (-0.1f64 * 5.0).exp()).abs() < 1e-12);
        let back = flow.advance(end, -5.0);
        assert!((back.q - START.q).abs().max((back.u - START.u).abs()) < 1e-11);
    }

    #[test]
    fn what_has_no_flow_is_refused() {
        let bad = system(f64::NAN, 1.0, 0.0, &[]);
        assert!(Free::new(&bad, 1e-12).unwrap_err().is_input());
        assert!(Linear::new(&System { cubic: 1.0, ..system(0.0, 1.0, 0.0, &[]) }).unwrap_err().is_input());
        assert!(Taylor::new(&system(0.0, 1.0, 0.0, &[]), 0.1).unwrap_err().is_input());
    }
}
