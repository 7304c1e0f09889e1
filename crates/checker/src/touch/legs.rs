//! Legs: from one impact to the next, over a cell of parameters, with bounds of their derivatives.
//!
//! All lengths and velocities are divided by ν. An impact is given by s = 2 (a + τ p)/(1 + τ), p and a being
//! the velocities just before and after it: the law of impact says −g′(t) = −ν s/2. The place is Q = σ − (1 −
//! g(t))/ν = σ − ν s²/4 (1 − g)/g′². A leg of n periods from s to s′ lasts T = 2πn + t′ − t; its first
//! velocity a and its last, p′, follow from both places:
//!
//! ```text
//! E = E(T),   I = f T²/2ν,   J = f T/ν,   r = −c p′ − k Q′ + f/ν  (f ≠ 0 only if c = k = 0)
//! a = (Q′ − E₁₁ Q − I)/E₁₂,    p′ = E₂₁ Q + E₂₂ a + J
//! a_t = (p′ − E₁₁ s/2)/E₁₂,    p_t = E₂₁ s/2 + E₂₂ a_t − r
//! a_t′ = (s′/2 − p′)/E₁₂,      p_t′ = E₂₂ a_t′ + r,            dt/ds = ν/2g″(t)
//! ```
//!
//! since dq/dT = p′ and dp/dT = r at the leg's end, and the place of an impact moves with s/2, the wall's
//! velocity.
//!
//! Between two mirrored walls n counts half periods, and an impact at the upper wall is described by its
//! mirror image at the lower one: its place and velocities times −1, its time less half a period. Then a leg
//! of n half periods lasts T = πn + t′ − t, and E = (−1)ⁿ E(T), while everything else stays as it is.

use super::{
    Interval,
    flow::{Flow, Matrix},
    wall::Wall,
};
use crate::rejection::{Fault, GoOn};

/// A box of parameters.
pub(crate) struct Cell<'a> {
    /// Whether there is an upper wall too, the mirror image; then times are counted in half periods.
    pub mirrored: bool,
    pub flow: Flow,
    /// f/ν.
    pub force: Interval,
    /// ν.
    pub depth: Interval,
    /// σ = ±1.
    pub side: Interval,
    /// 2/(1 + τ) and 2τ/(1 + τ), by which a and p count in s.
    pub shares: [Interval; 2],
    pub wall: &'a Wall,
}

/// What the velocities a and p of legs of n periods lie in, for n from 1; `None` if there are no such legs.
pub(crate) type Known = Vec<Option<[Interval; 2]>>;

/// An impact.
#[derive(Clone, Copy)]
pub(crate) struct Impact {
    pub s: Interval,
    pub phase: Interval,
    /// −g″.
    pub bend: Interval,
    /// (1 − g)/g′².
    pub ratio: Interval,
    /// Q.
    pub place: Interval,
}

/// Impacts cut into parts, each part with its middle.
pub(crate) type Parts = Vec<[Impact; 2]>;

/// A leg's first and last velocity, with bounds of their derivatives with respect to s and s′.
pub(crate) struct Leg {
    pub after: Interval,
    pub before: Interval,
    pub after_slopes: [Interval; 2],
    pub before_slopes: [Interval; 2],
}

/// What the derivatives of a leg are made of: E, its E₂₂ and E₂₁, dt/ds and s/2 at both impacts.
pub(crate) struct Frame {
    pub e: Matrix,
    pub velocity: Interval,
    pub spring: Interval,
    slopes: [Interval; 2],
    halves: [Interval; 2],
}

impl Frame {
    /// The derivatives of a and of p′ with respect to s and s′, given p′ and r.
    pub fn slopes(&self, before: Interval, last: Interval) -> [[Interval; 2]; 2] {
        let Frame { e, velocity, spring, slopes, halves } = *self;
        let by_first = (before - e.a * halves[0]).over(e.b);
        let by_last = (halves[1] - before).over(e.b);
        let first = spring * halves[0] + velocity * by_first - last;
        [
            [slopes[0] * by_first, slopes[1] * by_last],
            [slopes[0] * first, slopes[1] * (velocity * by_last + last)],
        ]
    }
}

impl<'a> Cell<'a> {
    /// Of ranges of c, k, f, τ, ν, with σ and the wall; f = 0 if there is a mirrored wall.
    pub fn new(
        mirrored: bool,
        [damping, stiffness, force, restitution, depth]: [Interval; 5],
        side: Interval,
        wall: &'a Wall,
    ) -> Cell<'a> {
        let sum = Interval::ONE + restitution;
        let two = Interval::ONE + Interval::ONE;
        let force = if force == Interval::ZERO { force } else { force.over(depth) };
        Cell {
            mirrored,
            flow: Flow { damping, stiffness },
            force,
            depth,
            side,
            shares: [two.over(sum), (two * restitution).over(sum)],
            wall,
        }
    }

    /// n periods, or half periods.
    pub fn time(&self, n: u64) -> Interval {
        let pi = Interval::PI;
        let one = if self.mirrored { pi } else { pi + pi };
        one * Interval::ratio(n.into(), 1)
    }

    /// E of that time, with the sign (−1)ⁿ that half periods bring.
    pub fn turned(&self, n: u64) -> Matrix {
        let e = self.flow.exp(self.time(n));
        if self.mirrored && n % 2 == 1 { Matrix { a: -e.a, b: -e.b } } else { e }
    }

    /// s of an impact with these velocities after and before.
    pub fn strength(&self, after: Interval, before: Interval) -> Interval {
        self.shares[0] * after + self.shares[1] * before
    }

    /// The impacts with these s, if their phases certainly lie within the window.
    pub fn impact(&self, s: Interval) -> Option<Impact> {
        let phase = self.wall.phase(-(self.depth * s).half())?;
        let [bend, ratio] = self.wall.bends(phase);
        let mut drop = (self.depth * s.squared() * ratio).shifted_down(2);
        if self.depth.is_positive() && !self.wall.plain() {
            drop = drop.meet(self.wall.at(phase).drop.over(self.depth));
        }
        Some(Impact { s, phase, bend, ratio, place: self.side - drop })
    }

    /// The impacts with these s cut into parts; none if one may be outside the window.
    pub fn parts(&self, s: Interval, parts: u64, go_on: GoOn) -> Result<Option<Parts>, Fault> {
        let both = |part| {
            go_on()?;
            let s = s.part(part, parts);
            Ok(self.impact(s).zip(self.impact(s.middle())).map(|(all, middle)| [all, middle]))
        };
        (0..parts).map(both).collect()
    }

    /// The fall I, J in a time.
    pub fn fall(&self, time: Interval) -> (Interval, Interval) {
        (self.force * time.squared().half(), self.force * time)
    }

    /// Acceleration at a place with a velocity.
    pub fn acceleration(&self, place: Interval, velocity: Interval) -> Interval {
        self.force - self.flow.damping * velocity - self.flow.stiffness * place
    }

    /// E for a leg, given that of its periods.
    pub fn matrix(&self, turns: Matrix, from: &Impact, to: &Impact) -> Matrix {
        self.flow.times(turns, self.flow.exp(to.phase - from.phase))
    }

    /// The velocities alone.
    pub fn ends(&self, e: Matrix, periods: u64, from: &Impact, to: &Impact) -> [Interval; 2] {
        let time = self.time(periods) + to.phase - from.phase;
        let (fallen, speed) = self.fall(time);
        let after = (to.place - e.a * from.place - fallen).over(e.b);
        let (_, before) = self.flow.apply(e, from.place, after);
        [after, before + speed]
    }

    /// What the derivatives of a leg are made of, but for its last velocity and acceleration.
    pub fn frame(&self, e: Matrix, from: &Impact, to: &Impact) -> Frame {
        let slope = |impact: &Impact| -self.depth.over(impact.bend).half();
        Frame {
            e,
            velocity: self.flow.velocity(e),
            spring: -(self.flow.stiffness * e.b),
            slopes: [slope(from), slope(to)],
            halves: [from.s.half(), to.s.half()],
        }
    }

    /// A leg of so many periods, `turns` being their E, between impacts from these; `middles` lie among them.
    /// Enclosed by the mean-value form, twice, since the velocity p′ enters the derivatives. The impacts' s
    /// are independent of each other and of the parameters.
    pub fn leg(&self, turns: Matrix, periods: u64, [from, to]: [&Impact; 2], middles: [&Impact; 2]) -> Leg {
        let e = self.matrix(turns, from, to);
        let [mut after, mut before] = self.ends(e, periods, from, to);
        let [middle_after, middle_before] =
            self.ends(self.matrix(turns, middles[0], middles[1]), periods, middles[0], middles[1]);
        let frame = self.frame(e, from, to);
        let apart = [from.s - middles[0].s, to.s - middles[1].s];
        let mut leg =
            Leg { after, before, after_slopes: [Interval::WHOLE; 2], before_slopes: [Interval::WHOLE; 2] };
        for _ in 0..3 {
            let last = self.acceleration(to.place, before);
            [leg.after_slopes, leg.before_slopes] = frame.slopes(before, last);
            let moved = |slopes: [Interval; 2]| slopes[0] * apart[0] + slopes[1] * apart[1];
            after = after.meet(middle_after + moved(leg.after_slopes));
            before = before.meet(middle_before + moved(leg.before_slopes));
            (leg.after, leg.before) = (after, before);
        }
        leg
    }
}
