//! What bounded motions near the touch can do where the place of rest is free, σ = −1: a bound of their
//! velocities at impacts, and of how long their legs are. For f = 0, c > 0 and 4k > c².
//!
//! Then V = u² + cqu + kq² = (u + cq/2)² + κq², κ = k − c²/4, decays as e^{−cT} exactly. Between impacts of a
//! motion all of whose contacts are at |g′| ≤ νS/2 a leg of n periods lasts 2πn − D at least, D being twice
//! the greatest |t| there, and −Q̄ ≤ q̂ ≤ −1 at both. So with a ≤ A at its first impact and a ≥ s/2 ≥ −S/2
//!
//! ```text
//! V ≤ B(A) = max(A² − cA, S²/4 + cSQ̄/2) + kQ̄²,    (p + cq̂/2)² ≤ R = e^{−c(2πn−D)} B(A) − κ
//! ```
//!
//! at its last one. R < 0 forbids the leg; else −p ≤ √R − c/2. The law of impact a = (1 + τ)s/2 − τp bounds
//! the next a by (1 + τ)S/2 + τ max(0, √R − c/2), with n = 1: this bounds the supremum of all a, which is
//! finite for a bounded motion. The proof is in `proofs/ranges.md`.

use super::{
    Interval,
    flow::Flow,
    legs::{Impact, Known},
};

/// Steps that narrow A, at most.
const STEPS: usize = 64;

/// What the bounds are made of; all numbers are points, rounded to the side that is safe.
struct Bounds {
    /// Least c and κ, greatest τ.
    damping: Interval,
    spread: Interval,
    restitution: Interval,
    /// (1 + τ) S/2.
    own: Interval,
    /// kQ̄², and S²/4 + cSQ̄/2 + kQ̄².
    rest: Interval,
    slow: Interval,
}

/// The velocities of legs of 1 to `longest` periods between impacts of strengths up to S, given the impacts
/// of all these; `None` if they are not bounded, or a leg may be longer.
pub(super) fn velocities(
    flow: Flow,
    shares: [Interval; 2],
    all: &Impact,
    time: impl Fn(u64) -> Interval,
    longest: u64,
) -> Option<Known> {
    let damping = flow.damping.least();
    let spread = (flow.stiffness - flow.damping.squared().shifted_down(2)).least();
    if !(damping.is_positive() && spread.is_positive()) {
        return None;
    }
    // c₂/c₁ = τ.
    let restitution = shares[1].over(shares[0]).greatest();
    let half = all.s.magnitude().half();
    let (place, most) = (all.place.magnitude(), flow.damping.greatest());
    let rest = (flow.stiffness * place.squared()).greatest();
    let slow = (half.squared() + most * half * place + rest).greatest();
    let own = (half + restitution * half).greatest();
    let bounds = Bounds { damping, spread, restitution, own, rest, slow };
    let width = all.phase.magnitude() + all.phase.magnitude();
    // e^{−cT} is E₂₂ of q″ = −c q′.
    let decay = |n: u64| {
        let free = Flow { damping, stiffness: Interval::ZERO };
        free.velocity(free.exp((time(n) - width).least())).greatest()
    };
    let speed = bounds.speed(decay(1))?;
    if bounds.last(decay(longest + 1), speed).is_some() {
        return None;
    }
    let after = (-half).until(speed);
    let leg = |n| {
        let least = -bounds.last(decay(n), speed)?;
        (!half.is_below(least)).then(|| [after, least.until(half)])
    };
    Some((1..=longest).map(leg).collect())
}

impl Bounds {
    /// A, from a first bound down. That is, with G² = S²/4 + cSQ̄/2 + kQ̄², A ≤ (1 + τ)S/2 + τ√ρ (A + G).
    fn speed(&self, decay: Interval) -> Option<Interval> {
        let factor = self.restitution * decay.root().greatest();
        let room = (Interval::ONE - factor).least();
        if !room.is_positive() {
            return None;
        }
        let first = (self.own + factor * self.slow.root()).over(room).greatest();
        let mut speed = first.is_known().then_some(first)?;
        for _ in 0..STEPS {
            let last = self.last(decay, speed).unwrap_or(Interval::ZERO);
            let last = if last.is_up_to(Interval::ZERO) { Interval::ZERO } else { last };
            let next = (self.own + self.restitution * last).greatest();
            // Nothing is below what is not known, nor is that.
            if !next.is_below(speed) {
                break;
            }
            speed = next;
        }
        Some(speed)
    }

    /// An upper bound of −p, if a leg that decays so can be: √R − c/2. With lengths in units of A, whose
    /// square may be beyond all numbers.
    fn last(&self, decay: Interval, speed: Interval) -> Option<Interval> {
        let unit = if Interval::ONE.is_below(speed) { speed } else { Interval::ONE };
        let scaled = |x: Interval| x.over(unit);
        let a = scaled(speed);
        let fast = a.squared() - scaled(self.damping) * a + scaled(scaled(self.rest));
        let energy = fast.hull(scaled(scaled(self.slow))).greatest();
        let left = (decay * energy - scaled(scaled(self.spread))).greatest();
        if left.is_below(Interval::ZERO) {
            return None;
        }
        Some((unit * left.root() - self.damping.half()).greatest())
    }
}

#[cfg(test)]
mod tests {
    use super::velocities;
    use crate::touch::{
        Interval,
        flow::Flow,
        legs::{Cell, Known},
        wall::Wall,
    };

    /// c, k, τ, S, ν over a thousand.
    fn known([c, k, tau, s, nu]: [i128; 5], longest: u64) -> Option<Known> {
        let [c, k, tau, s, nu] = [c, k, tau, s, nu].map(|x| Interval::ratio(x, 1000));
        let one = (1, [Interval::ONE, Interval::ZERO]);
        let wall = Wall::new(vec![one], Interval::ratio(6, 5), 8, &mut || Ok(())).ok()?;
        let cell = Cell::new(false, [c, k, Interval::ZERO, tau, nu], -Interval::ONE, &wall);
        let all = cell.impact((-s).hull(s))?;
        velocities(Flow { damping: c, stiffness: k }, cell.shares, &all, |n| cell.time(n), longest)
    }

    /// Whether a number lies in an interval, to 10⁻⁹.
    fn lies(x: f64, all: Interval) -> bool {
        let [lo, hi] = [x - 1e-9, x + 1e-9].map(|x| Interval::ratio((x * 1e12) as i128, 1_000_000_000_000));
        all.common(lo.hull(hi)).is_some()
    }

    /// Legs in floats between places that are allowed, in times that are: from velocities that are allowed
    /// they arrive with such, and leave so; and none is longer.
    #[test]
    fn no_leg_leaves_the_bounds() {
        let mut state = 7u64;
        let mut random = |lo: f64, hi: f64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            lo + (hi - lo) * ((state >> 11) as f64 / (1u64 << 53) as f64)
        };
        let (mut arrived, mut close) = (0, 0);
        for (numbers, longest) in
            [([100, 300, 800, 3300, 20], 9), ([50, 1300, 900, 2000, 5], 20), ([600, 200, 1000, 5000, 10], 5)]
        {
            let known = known(numbers, longest).unwrap();
            let [c, k, tau, s, nu] = numbers.map(|x| x as f64 / 1000.0);
            let phase = (nu * s / 2.0).asin();
            let deepest = 1.0 + nu * s * s / 4.0 / (1.0 + phase.cos());
            let [after, _] = known[0].unwrap();
            let (half, rate) = (c / 2.0, (k - c * c / 4.0).sqrt());
            for _ in 0..200_000 {
                let n = random(1.0, 2.0 * longest as f64).floor();
                let [q, place] = [0, 1].map(|_| -random(1.0, deepest));
                let time = std::f64::consts::TAU * n + random(-2.0 * phase, 2.0 * phase);
                let (left, (sin, cos)) = ((-half * time).exp(), (rate * time).sin_cos());
                let a = rate * (place / left - q * cos) / sin - half * q;
                let p = left * (a * cos - (k * q + half * a) / rate * sin);
                if !(a.abs() < 1e3 && lies(a, after)) || p > s / 2.0 {
                    continue;
                }
                arrived += 1;
                let Some(Some([_, before])) = known.get(n as usize - 1) else { panic!("{numbers:?} {n}") };
                let next = (1.0 + tau) * random(-s / 2.0, s / 2.0) - tau * p;
                assert!(
                    lies(p, *before) && (next < -s / 2.0 || lies(next, after)),
                    "{numbers:?} {n} {a} {p}"
                );
                close += usize::from(n > 1.0);
            }
        }
        assert!(arrived > 1000 && close > 100, "{arrived} {close}");
    }

    /// A and the bounds of p, by the formulas of `proofs/ranges.md` in floats, where each term counts: wide
    /// phases, a slow start, weak restitution.
    #[test]
    fn the_bounds_are_those_of_the_page() {
        for (numbers, longest) in [
            ([100, 300, 800, 3300, 20], 9),
            ([400, 1700, 900, 2000, 700], 7),
            ([1000, 1500, 100, 3000, 300], 5),
            ([200, 500, 10, 3000, 20], 3),
        ] {
            let known = known(numbers, longest).unwrap();
            let [c, k, tau, s, nu] = numbers.map(|x| x as f64 / 1000.0);
            let phase = (nu * s / 2.0).asin();
            let place = 1.0 + nu * s * s / 4.0 / (1.0 + phase.cos());
            let spread = k - c * c / 4.0;
            let slow = s * s / 4.0 + c * s * place / 2.0;
            let left = |n: usize, a: f64| {
                let decay = (-c * (std::f64::consts::TAU * n as f64 - 2.0 * phase)).exp();
                [decay, decay * ((a * a - c * a).max(slow) + k * place * place) - spread]
            };
            let factor = tau * left(1, 0.0)[0].sqrt();
            let rest = (slow + k * place * place).sqrt();
            let mut most = ((1.0 + tau) * s / 2.0 + factor * rest) / (1.0 - factor);
            for _ in 0..1000 {
                let last = (left(1, most)[1].max(0.0).sqrt() - c / 2.0).max(0.0);
                most = most.min((1.0 + tau) * s / 2.0 + tau * last);
            }
            for (n, known) in (1..).zip(&known) {
                let r = left(n, most)[1];
                let Some([after, before]) = known else {
                    assert!(r < 0.0, "{numbers:?} {n}");
                    continue;
                };
                // A root of nearly 0 has half the digits.
                let half_digits = Interval::ratio(1, 1_000_000);
                let close = |x: Interval, y: f64| lies(y, x.widened(half_digits));
                assert!(
                    close(after.least(), -s / 2.0) && close(after.greatest(), most),
                    "{numbers:?} {most}"
                );
                let least = c / 2.0 - r.sqrt();
                assert!(close(before.least(), least) && close(before.greatest(), s / 2.0), "{numbers:?} {n}");
            }
        }
    }

    /// Without damping, overdamped, where an impact gains what a period loses, and with longer legs than
    /// said.
    #[test]
    fn what_is_not_bounded_is_not_known() {
        assert!(known([100, 300, 800, 3300, 20], 9).is_some());
        for (numbers, longest) in [
            ([0, 300, 800, 3300, 20], 9),
            ([1200, 300, 800, 3300, 20], 9),
            ([100, 300, 1400, 3300, 20], 9),
            ([100, 300, 800, 3300, 20], 3),
            ([1, 300, 800, 3300, 20], 9),
        ] {
            assert!(known(numbers, longest).is_none(), "{numbers:?}");
        }
    }
}
