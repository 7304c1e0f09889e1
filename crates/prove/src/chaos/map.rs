//! The map of proofs/chaos.md over a box of parameters, in spans: impacts by their strength s, legs with
//! their derivatives, gaps.

use std::{
    f64::consts::{PI, TAU},
    rc::Rc,
};

use super::{profile::Profile, span::Span};

/// A box of the parameters c, k, f, τ, ν, with σ and the wall.
#[derive(Debug, Clone)]
pub(crate) struct Cell {
    /// Whether there are two walls; then periods are counted in halves, and what happens at the upper wall is
    /// described by its mirror image.
    mirrored: bool,
    pub damping: Span,
    pub stiffness: Span,
    /// f/ν.
    force: Span,
    pub depth: Span,
    side: f64,
    /// 2/(1 + τ) and 2τ/(1 + τ).
    pub shares: [Span; 2],
    profile: Rc<Profile>,
}

/// E₁₁ and E₁₂ of the free motion; the others are −k E₁₂ and E₁₁ − c E₁₂.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Flow {
    pub a: Span,
    pub b: Span,
}

/// An impact of strength s: its phase, the wall's bend there, its place.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Impact {
    pub s: Span,
    pub phase: Span,
    pub bend: Span,
    /// (1 − g)/g′².
    pub ratio: Span,
    pub place: Span,
}

/// First and last velocity of a leg, and their derivatives with respect to the strengths of its impacts.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Leg {
    pub after: Span,
    pub before: Span,
    pub after_slopes: [Span; 2],
    pub before_slopes: [Span; 2],
}

impl Cell {
    pub(crate) fn new(
        mirrored: bool,
        [damping, stiffness, force, restitution, depth]: [Span; 5],
        side: f64,
        profile: &Rc<Profile>,
    ) -> Cell {
        let force = if force == Span::point(0.0) { force } else { force.over(depth) };
        let sum = restitution + Span::point(1.0);
        let two = Span::point(2.0);
        let shares = [two.over(sum), two.over(sum) * restitution];
        Cell { mirrored, damping, stiffness, force, depth, side, shares, profile: Rc::clone(profile) }
    }

    /// n periods, or half periods.
    pub(crate) fn time(&self, n: u64) -> Span {
        Span::point(if self.mirrored { PI } else { TAU } * n as f64)
    }

    /// E over n periods, or (−1)ⁿ E over n half periods.
    pub(crate) fn turned(&self, n: u64) -> Flow {
        self.signed(n, self.flow(self.time(n)))
    }

    fn signed(&self, n: u64, e: Flow) -> Flow {
        if self.mirrored && n % 2 == 1 { Flow { a: -e.a, b: -e.b } } else { e }
    }

    /// s of an impact with these velocities after and before.
    pub(crate) fn strength(&self, after: Span, before: Span) -> Span {
        self.shares[0] * after + self.shares[1] * before
    }

    /// The impacts of these strengths, if their phases are within π/2.
    pub(crate) fn impact(&self, s: Span) -> Option<Impact> {
        let phase = self.profile.phase(-(self.depth * s).times(0.5))?;
        let [bend, ratio] = self.profile.bends(phase);
        let drop = (self.depth * s.squared() * ratio).times(0.25);
        Some(Impact { s, phase, bend, ratio, place: Span::point(self.side) - drop })
    }

    /// The least −g″ on a window.
    pub(crate) fn least_bend(&self, window: f64, pieces: u64) -> f64 {
        let whole = Span::new(-window, window);
        let bend = |piece| self.profile.at(whole.part(piece, pieces)).bend.lo;
        (0..pieces).map(bend).fold(f64::INFINITY, f64::min)
    }

    /// E₁₁ + E₂₂ and the determinant of E over a period, or half a period.
    pub(crate) fn invariants(&self) -> [Span; 2] {
        let e = self.turned(1);
        let velocity = self.velocity(e);
        [e.a + velocity, e.a * velocity + self.stiffness * e.b.squared()]
    }

    /// Whether no motion meets the wall twice in one window with impacts like these, nor rests on it.
    pub(crate) fn meets_once(&self, all: &Impact) -> bool {
        let width = 2.0 * all.phase.magnitude();
        let (damping, stiffness) = (self.damping.magnitude(), self.stiffness.magnitude());
        let place = all.place.magnitude();
        // |q̂′| ≤ speed = s/2 + width·(damping·speed + stiffness·(place + width·speed)).
        let share = 1.0 - width * (damping + stiffness * width);
        let speed = (0.5 * all.s.magnitude() + width * stiffness * place) / share;
        let acceleration = damping * speed + stiffness * (place + width * speed);
        share > 0.0 && all.place.lo > 0.0 && all.bend.lo > self.depth.hi * acceleration
    }

    /// q̂ at the middle of the window whose time from the first one's middle has this E.
    pub(crate) fn at_turn(&self, turns: Flow, from: &Impact, after: Span) -> Span {
        let e = self.product(turns, self.flow(-from.phase));
        e.a * from.place + e.b * after
    }

    /// E(t), by the exponential series of a small part of t about the exact value at its middle.
    pub(crate) fn flow(&self, t: Span) -> Flow {
        let middle = t.middle();
        self.product(self.series(Span::point(middle)), self.series(t - Span::point(middle)))
    }

    pub(crate) fn product(&self, x: Flow, y: Flow) -> Flow {
        let square = x.b * y.b;
        Flow { a: x.a * y.a - self.stiffness * square, b: x.a * y.b + x.b * y.a - self.damping * square }
    }

    fn series(&self, t: Span) -> Flow {
        let norm = (self.damping.magnitude() + self.stiffness.magnitude()).max(1.0);
        let halvings = (4.0 * norm * t.magnitude()).log2().ceil().clamp(0.0, 60.0) as i32;
        let t = t.times(0.5f64.powi(halvings));
        let mut sum = Flow { a: Span::point(1.0), b: Span::point(0.0) };
        for n in (1..=13).rev() {
            let factor = t.times(1.0 / f64::from(n));
            let a = Span::point(1.0) - factor * self.stiffness * sum.b;
            sum = Flow { a, b: factor * (sum.a - self.damping * sum.b) };
        }
        for _ in 0..halvings {
            let (square, product) = (sum.b.squared(), sum.a * sum.b);
            let a = sum.a.squared() - self.stiffness * square;
            sum = Flow { a, b: product.times(2.0) - self.damping * square };
        }
        sum
    }

    pub(crate) fn velocity(&self, e: Flow) -> Span {
        e.a - self.damping * e.b
    }

    pub(crate) fn acceleration(&self, place: Span, velocity: Span) -> Span {
        self.force - self.damping * velocity - self.stiffness * place
    }

    /// Place and velocity a time after leaving a place with a velocity, given E of that time.
    fn motion(&self, e: Flow, time: Span, place: Span, velocity: Span) -> [Span; 2] {
        let fallen = self.force * time.squared().times(0.5);
        [
            e.a * place + e.b * velocity + fallen,
            self.velocity(e) * velocity - self.stiffness * (e.b * place) + self.force * time,
        ]
    }

    pub(crate) fn ends(&self, e: Flow, time: Span, from: &Impact, to: &Impact) -> [Span; 2] {
        let fallen = self.force * time.squared().times(0.5);
        let after = (to.place - e.a * from.place - fallen).over(e.b);
        [after, self.motion(e, time, from.place, after)[1]]
    }

    /// A leg of so many periods, `turns` being their E, between these impacts; `middles` lie among them.
    pub(crate) fn leg(
        &self,
        turns: Flow,
        periods: u64,
        [from, to]: [&Impact; 2],
        middles: [&Impact; 2],
    ) -> Leg {
        let time = |from: &Impact, to: &Impact| self.time(periods) + to.phase - from.phase;
        let e = |from: &Impact, to: &Impact| self.product(turns, self.flow(to.phase - from.phase));
        let whole = e(from, to);
        let [mut after, mut before] = self.ends(whole, time(from, to), from, to);
        let centre =
            self.ends(e(middles[0], middles[1]), time(middles[0], middles[1]), middles[0], middles[1]);
        let slope = |impact: &Impact| -self.depth.over(impact.bend).times(0.5);
        let (slopes, halves) = ([slope(from), slope(to)], [from.s.times(0.5), to.s.times(0.5)]);
        let apart = [from.s - middles[0].s, to.s - middles[1].s];
        let (mut after_slopes, mut before_slopes) = ([Span::point(0.0); 2], [Span::point(0.0); 2]);
        for _ in 0..3 {
            let last = self.acceleration(to.place, before);
            let by_first = (before - whole.a * halves[0]).over(whole.b);
            let by_last = (halves[1] - before).over(whole.b);
            let velocity = self.velocity(whole);
            after_slopes = [slopes[0] * by_first, slopes[1] * by_last];
            before_slopes = [
                slopes[0] * (velocity * by_first - self.stiffness * (whole.b * halves[0]) - last),
                slopes[1] * (velocity * by_last + last),
            ];
            let moved = |slopes: [Span; 2]| slopes[0] * apart[0] + slopes[1] * apart[1];
            after = after.meet(centre[0] + moved(after_slopes));
            before = before.meet(centre[1] + moved(before_slopes));
        }
        Leg { after, before, after_slopes, before_slopes }
    }

    /// The greatest q/ν, with two walls |q|/ν, on a leg of n periods from these impacts with these
    /// velocities, and why its gap may not be positive.
    pub(crate) fn gap(
        &self,
        periods: u64,
        [from, to]: [&Impact; 2],
        after: Span,
        window: f64,
        pieces: u64,
    ) -> (f64, Option<String>) {
        let mut reach = f64::NEG_INFINITY;
        let mut reason = None;
        let periods_of = if self.mirrored { "half periods" } else { "periods" };
        let mut motion = |k: u64, t: Span| {
            let since = self.time(k) + t - from.phase;
            let e = self.signed(k, self.flow(since));
            let [place, velocity] = self.motion(e, since, from.place, after);
            reach = reach.max(if self.mirrored { place.magnitude() } else { place.hi });
            (place, velocity, self.acceleration(place, velocity))
        };
        let gap = |t: Span, place: Span| {
            self.profile.at(t).drop.lo + (self.depth * (place - Span::point(self.side))).lo
        };
        for k in 0..=periods {
            let lo = if k == 0 { from.phase.lo } else { -window };
            let hi = if k == periods { to.phase.hi } else { window };
            let mut least = f64::INFINITY;
            for piece in 0..pieces {
                let t = Span::new(lo, hi).part(piece, pieces);
                let (_, _, acceleration) = motion(k, t);
                least = least.min(self.profile.at(t).bend.lo + (self.depth * acceleration).lo);
            }
            if least <= 0.0 {
                reason = reason.or(Some(format!("the wall may press {k} {periods_of} after the impact")));
            }
            if 0 < k && k < periods {
                let (place, velocity, _) = motion(k, Span::point(0.0));
                let dip = (self.depth * velocity.squared()).times(0.5 / least);
                if (place - dip).lo <= self.side {
                    reason =
                        reason.or(Some(format!("the wall may be met {k} {periods_of} after the impact")));
                }
            }
            // To the next window of the same wall, or to the leg's end.
            let ends = self.mirrored && k + 1 == periods;
            let between = Span::new(window, if ends { PI + to.phase.hi } else { TAU - window });
            for piece in 0..if k < periods { pieces } else { 0 } {
                let t = between.part(piece, pieces);
                if gap(t, motion(k, t).0) <= 0.0 {
                    reason = reason.or(Some(format!("the gap may close after window {k}")));
                }
            }
        }
        // The other wall, from the leg's beginning to its first window.
        let before = Span::new(PI + from.phase.lo, TAU - window);
        for piece in 0..if self.mirrored { pieces } else { 0 } {
            let t = before.part(piece, pieces);
            if gap(t, -motion(0, t - Span::point(PI)).0) <= 0.0 {
                reason = reason.or(Some("the other wall may be met before its first window".into()));
            }
        }
        (reach, reason)
    }
}
