//! The ten formulas of proofs/attractor.md in floats, for all parameters of their ranges, divided by the
//! depth or its root.

use std::f64::consts::TAU;

use super::stop::Stop;

/// a < b over all c and k, as their least and greatest numbers; D at its least; τ at both ends.
pub(super) struct Rates {
    pub slow: [f64; 2],
    pub fast: [f64; 2],
    pub apart: f64,
    pub tau: [f64; 2],
}

impl Rates {
    /// Of the ranges of c, k and τ; none where the oscillator may not be overdamped.
    pub fn of([[c0, c1], [k0, k1], tau]: [[f64; 2]; 3]) -> Option<Rates> {
        if k0 <= 0.0 || c0 <= 0.0 || c0 * c0 <= 4.0 * k1 {
            return None;
        }
        let apart = [(c0 * c0 - 4.0 * k1).sqrt(), (c1 * c1 - 4.0 * k0).sqrt()];
        let fast = [0.5 * (c0 + apart[0]), 0.5 * (c1 + apart[1])];
        Some(Rates { slow: [k0 / fast[1], k1 / fast[0]], fast, apart: apart[0], tau })
    }

    /// The least λ₁.
    pub fn share(&self) -> f64 {
        (-self.slow[1] * TAU).exp()
    }

    /// E₁₁ and E₁₂ of the rates' least numbers, 0, or their greatest, 1.
    fn motion(&self, time: f64, end: usize) -> [f64; 2] {
        let (a, b) = (self.slow[end], self.fast[end]);
        let slow = (-a * time).exp();
        let reach = slow * -(-(b - a) * time).exp_m1() / (b - a);
        [slow + a * reach, reach]
    }
}

/// What a certificate lists.
#[derive(Debug, Clone, Copy)]
pub(super) struct Constants {
    pub speed: f64,
    pub slip: f64,
    /// E and N.
    pub growth: f64,
    pub last: u64,
    pub start: f64,
    /// w, √ν, σ and q.
    window: f64,
    root: f64,
    strength: f64,
    height: f64,
}

/// The most returns that a certificate looks at, for the growth and for exponents.
const PERIODS: u64 = 1000;
const RETURNS: u64 = 2000;
/// What is listed is more than what is found by such a part, less twice that.
pub(super) const ROOM: f64 = 2e-6;
/// What is taken off the checker's sums of many terms.
const NEAR: f64 = 1e-3;

impl Constants {
    /// At a depth; none where the gap may not be convex, or the window be longer than a period.
    pub fn of(rates: &Rates, stop: &Stop, depth: f64) -> Option<Constants> {
        let ([_, a], [_, b], d, tau) = (rates.slow, rates.fast, rates.apart, rates.tau);
        let window = stop.window[0] + stop.window[1];
        let [least, greatest] = stop.bends;
        let short = TAU - window;
        if short <= 0.0 {
            return None;
        }
        let slip = d / (d * short).exp_m1() * (1.0 + ROOM);
        let reach = |n: u64| {
            let ends = [-window, window].map(|by| rates.motion(TAU * n as f64 + by, 1)[1]);
            ends[0].min(ends[1])
        };
        let (whole, share, root) = (1.0 / reach(1), b * b / d, depth.sqrt());
        let early = least - share * (b * window).exp() * depth * (slip + whole);
        let most = greatest + a * a * depth * (1.0 + slip / d);
        let bounce = (tau[1] * whole / (1.0 + tau[0])).powi(2) * depth / (2.0 * early);
        let speed = (2.0 * most * (1.0 - rates.share() * (1.0 - bounce))).sqrt() * (1.0 + ROOM);
        let late = least - share * (depth * slip + (1.0 + tau[1]) * root * speed);
        if early <= 0.0 || late <= 0.0 {
            return None;
        }
        let strength = tau[0] * (least - share * depth * slip) + late;
        let height = 1.0 - (speed + root * slip).max(a * root).powi(2) / (2.0 * least);
        let start = start(|x| {
            let fastest = (2.0 * depth * (greatest + a * a * (depth + x / d))).sqrt();
            least > share * (x + (1.0 + tau[1]) * fastest)
        });
        let mut found =
            Constants { speed, slip, growth: 0.0, last: 1, start, window, root, strength, height };
        if start < depth * slip {
            return None;
        }
        let mut before = f64::INFINITY;
        for n in 1..=PERIODS {
            let [one, other] = found.growths(rates, n);
            let growth = before.min(other);
            if growth > found.growth * (1.0 + 1e-9) {
                (found.growth, found.last) = (growth, n);
            }
            before = before.min(one.max(other));
            // B_n grows with n, and nothing helps what a shorter return lacks.
            if before <= found.growth * (1.0 + 1e-6) || before < 1.0 {
                break;
            }
        }
        Some(found)
    }

    /// A_n and B_n.
    pub fn growths(&self, rates: &Rates, n: u64) -> [f64; 2] {
        let [early, late] = [-self.window, self.window].map(|by| TAU * n as f64 + by);
        let reach = rates.motion(early, 1)[1].min(rates.motion(late, 1)[1]);
        let rest = rates.motion(early, 0)[0];
        let way = ((1.0 + rates.tau[1]) * self.speed + self.root * self.slip) * self.speed;
        [self.strength * reach / (self.root * self.speed), self.strength * (self.height - rest) / way]
    }

    /// From a depth on: L and R, if returns are over within the periods that are looked at.
    pub fn exponent(&self, rates: &Rates, least: f64) -> Option<(u64, f64)> {
        let kick = (1.0 + rates.tau[1]) * self.speed / least.sqrt() + self.slip;
        let is_over = |&n: &u64| {
            let time = TAU * n as f64 - self.window;
            rates.motion(time, 0)[0] + (-rates.slow[0] * time).exp() / rates.apart * kick < 1.0 - NEAR
        };
        let last = (1..=RETURNS).find(is_over)?;
        let rate = |n: u64| {
            let [one, other] = self.growths(rates, n);
            one.max(other).ln() / n as f64
        };
        Some((last, (1..=last).map(rate).fold(f64::INFINITY, f64::min)))
    }
}

/// The largest start that is trapped, at most 1000.
fn start(holds: impl Fn(f64) -> bool) -> f64 {
    let (mut lo, mut hi) = (0.0, 1000.0);
    for _ in 0..60 {
        let middle = 0.5 * (lo + hi);
        if holds(middle) { lo = middle } else { hi = middle }
    }
    lo
}
