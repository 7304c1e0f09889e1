//! The curve: the depth as a function of the phase of the impact, with its speed and its multipliers.
//!
//! The free motion that E takes from the impact to itself, Q = E₁₁Q + E₁₂a, with p = E₂₁Q + E₂₂a and a + τp =
//! (1 + τ)g′, has Q = K g′ and a = H g′ with
//!
//! ```text
//! S = 1 − E₁₁ + τ(E₂₂ − det E) ≠ 0,    K = (1 + τ)E₁₂/S,    H = (1 + τ)(1 − E₁₁)/S
//! ```
//!
//! and no other does. So
//!
//! ```text
//! σν = 1 − g + Q,    σ dν/dt = −g′ + K g″,    V = a − g′ = (1 − H)(−g′),    1 − H = −τ(1 − tr E + det E)/S
//! ```
//!
//! The multipliers are those of ES′, where S′, the derivative of an impact, is −τ on the diagonal and has R/v
//! below it: v = −V/τ is the velocity relative to the wall before the impact, and R is the acceleration after
//! it and τ times that before it, R = (1 + τ)(−g″ + (c + kK)(−g′)). So, with w = |g′|,
//!
//! ```text
//! Δ = τ² det E,    Θ w = −τ tr E w + (1 + τ)E₁₂ S/(1 − tr E + det E) (D(−g″) + (c + kK) w)
//! ```
//!
//! At a resonance E₁₂ = 0 exactly, E = ζ, and so K = 0: σν = 1 − g, whose slope vanishes at t = 0 as the
//! speed does; and Θ = −2τζ, Δ = τ²ζ², both multipliers being −τζ.

use super::{
    Fault, Interval,
    text::{Certificate, Word},
};
use crate::{
    rejection::claim,
    touch::{
        flow::{Flow, Matrix},
        wall::{Shape, Wall},
    },
};

/// An orbit of one impact, for a box of parameters, at all its phases.
pub(super) struct Curve {
    /// Whether there is an upper wall too, the mirror image; then periods are half periods.
    pub mirrored: bool,
    pub wall: Wall,
    pub flow: Flow,
    /// n.
    pub periods: u64,
    /// A period.
    pub turn: Interval,
    /// E of 0 to n periods; between mirrored walls with the sign (−1)ⁿ.
    pub turns: Vec<Matrix>,
    /// σ and D.
    side: Interval,
    pub direction: Interval,
    /// K and H.
    pub place: Interval,
    pub after: Interval,
    /// Δ.
    contraction: Interval,
    /// Θ: what multiplies w, and what multiplies D(−g″) + (c + kK) w; and c + kK.
    own: Interval,
    turned: Interval,
    bound: Interval,
    /// Whether E₁₂ = 0.
    resonant: bool,
}

impl Curve {
    /// Of a certificate.
    ///
    /// # Errors
    /// S2: that the velocities may not be defined, or the speed not positive.
    pub fn new(certificate: &Certificate) -> Result<Curve, Fault> {
        let [damping, stiffness, tau] = certificate.ranges.map(|[lo, hi]| lo.enclosed().hull(hi.enclosed()));
        let harmonics = certificate.harmonics.iter();
        let harmonics =
            harmonics.map(|one| (one.order, one.parts.map(|[lo, hi]| lo.enclosed().hull(hi.enclosed()))));
        let sign = |positive: bool| if positive { Interval::ONE } else { -Interval::ONE };
        let direction = sign(certificate.forward);
        let flow = Flow { damping, stiffness };
        let mirrored = certificate.mirrored;
        let turn = if mirrored { Interval::PI } else { Interval::PI + Interval::PI };
        let turned = |n: u64| {
            let e = flow.exp(turn * Interval::integer(n));
            if mirrored && n % 2 == 1 { Matrix { a: -e.a, b: -e.b } } else { e }
        };
        let mut turns: Vec<Matrix> = (0..=certificate.periods).map(turned).collect();
        let resonant = certificate.is_resonant();
        if resonant {
            turns[certificate.periods as usize].b = Interval::ZERO;
        }
        let e = turns[certificate.periods as usize];
        let one = Interval::ONE;
        let [trace, determinant] = flow.invariants(e);
        let sum = one - e.a + tau * (flow.velocity(e) - determinant);
        let left = one - trace + determinant;
        let speed = -(direction * left.over(sum));
        claim(speed.is_positive(), "the speed of the impact may not be positive (S2)")?;
        let share = (one + tau).over(sum);
        let (place, after) = (share * e.b, share * (one - e.a));
        Ok(Curve {
            mirrored,
            wall: Wall::free(harmonics.collect()),
            periods: certificate.periods,
            turn,
            turns,
            side: sign(certificate.behind),
            direction,
            place,
            after,
            contraction: tau.squared() * determinant,
            own: -(tau * trace),
            turned: e.b * (one + tau) * sum.over(left),
            bound: damping + stiffness * place,
            flow,
            resonant,
        })
    }

    /// ν at a phase.
    pub fn depth(&self, t: Interval) -> Interval {
        let shape = self.wall.at(t);
        self.side * (shape.drop - self.place * shape.slope)
    }

    /// D dν/dt where the wall is this.
    pub fn slope(&self, shape: &Shape) -> Interval {
        self.side * self.direction * (shape.slope - self.place * shape.bend)
    }

    /// S1 and S2 at phases from 0, if these are the `first`, where the wall is this.
    pub fn runs(&self, shape: &Shape, first: bool) -> Result<(), Fault> {
        let moves = if first { shape.bend } else { self.direction * shape.slope };
        let grows = if self.resonant { self.side * moves } else { self.slope(shape) };
        claim(grows.is_positive(), "nu may not increase (S1)")?;
        claim(moves.is_positive(), "the speed of the impact may not be positive (S2)")
    }

    /// What is certain of the multipliers where the wall is this.
    pub fn word(&self, shape: &Shape) -> Word {
        let one = Interval::ONE;
        // At a resonance all are multiples of w.
        let w = if self.resonant { one } else { self.direction * shape.slope };
        let sum = self.own * w + self.turned * (self.direction * shape.bend + self.bound * w);
        let whole = (one + self.contraction) * w;
        let [flip, fold] = [whole + sum, whole - sum];
        if (-flip).is_positive() || (-fold).is_positive() {
            Word::Unstable
        } else if self.contraction.is_below(one) && flip.is_positive() && fold.is_positive() {
            Word::Stable
        } else {
            Word::Open
        }
    }
}
