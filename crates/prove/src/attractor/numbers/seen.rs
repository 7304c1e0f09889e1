//! Motions in floats: by how much displacements times weights grow at least, as far as it is seen.

use std::f64::consts::TAU;

use num_traits::ToPrimitive;

use super::{AttractorProblem, Random};
use crate::{
    certificate::attractor::{Setting, cells::Cell},
    range::write::float,
};

/// The machine of the least parameters at the greatest depth, its trap, and the weights of a certificate.
pub(super) struct Seen {
    slow: f64,
    fast: f64,
    tau: f64,
    depth: f64,
    window: [f64; 2],
    /// S√ν and Zν.
    trap: [f64; 2],
    harmonics: Vec<[f64; 3]>,
    cells: Vec<[f64; 2]>,
}

impl Seen {
    /// Without cells all weighs the same.
    pub fn new(problem: &AttractorProblem, setting: &Setting, cells: &[Cell]) -> Seen {
        let number = |x: &num_rational::BigRational| x.to_f64().unwrap();
        let [c, k, tau] = problem.ranges.each_ref().map(|[x, _]| number(x));
        let fast = 0.5 * (c + (c * c - 4.0 * k).sqrt());
        let harmonic = |(j, [a, b]): &crate::chaos::Term| {
            [*j as f64, 0.5 * (number(&a[0]) + number(&a[1])), 0.5 * (number(&b[0]) + number(&b[1]))]
        };
        let depth = setting.depth.p as f64 / setting.depth.q as f64;
        Seen {
            slow: k / fast,
            fast,
            tau,
            depth,
            window: setting.window.map(float),
            trap: [float(setting.speed) * depth.sqrt(), float(setting.slip) * depth],
            harmonics: problem.harmonics.iter().map(harmonic).collect(),
            cells: cells.iter().map(|cell| [float(cell.end), cell.weight as f64]).collect(),
        }
    }

    /// Q and Q′ and Q″.
    fn wall(&self, t: f64) -> [f64; 3] {
        let mut all = [self.depth, 0.0, 0.0];
        for [j, a, b] in &self.harmonics {
            let ((sin, cos), half) = ((j * t).sin_cos(), (0.5 * j * t).sin());
            all[0] += b * sin - 2.0 * a * half * half;
            all[1] += j * (b * cos - a * sin);
            all[2] -= j * j * (a * cos + b * sin);
        }
        all
    }

    /// E₁₁ − a E₁₂ and E₁₂.
    fn motion(&self, t: f64) -> [f64; 2] {
        let stay = (-self.slow * t).exp();
        [stay, (stay - (-self.fast * t).exp()) / (self.fast - self.slow)]
    }

    /// The gap and its speed after a time, from a time and a state (x, ζ).
    fn gap(&self, from: f64, [x, zeta]: [f64; 2], t: f64) -> [f64; 2] {
        let ([stay, reach], [place, slope, _]) = (self.motion(t - from), self.wall(t));
        let now = stay * x + reach * zeta;
        [now - place, zeta * (-self.fast * (t - from)).exp() - self.slow * now - slope]
    }

    /// The first contact; in each pass the gap is convex.
    fn next(&self, from: f64, state: [f64; 2]) -> Option<f64> {
        (1..1000).find_map(|n| {
            let top = TAU * ((from / TAU).round() + f64::from(n));
            let (start, mut lo, mut hi) = (top - self.window[0], top - self.window[0], top + self.window[1]);
            for _ in 0..60 {
                let middle = 0.5 * (lo + hi);
                if self.gap(from, state, middle)[1] < 0.0 { lo = middle } else { hi = middle }
            }
            if self.gap(from, state, lo)[0] >= 0.0 {
                return None;
            }
            (hi, lo) = (lo, start);
            for _ in 0..60 {
                let middle = 0.5 * (lo + hi);
                if self.gap(from, state, middle)[0] > 0.0 { lo = middle } else { hi = middle }
            }
            Some(lo)
        })
    }

    fn weight(&self, speed: f64) -> f64 {
        let speed = speed / self.depth.sqrt();
        self.cells.iter().find(|[end, _]| speed <= *end).or(self.cells.last()).map_or(1.0, |cell| cell[1])
    }

    /// The least growth from contact to contact of so many motions, each followed for so many.
    pub fn least_growth(&self, motions: usize, contacts: usize) -> f64 {
        let (mut random, mut least) = (Random(5), f64::INFINITY);
        for _ in 0..motions {
            let mut state = [0.0, self.depth.sqrt() * random.between(0.2, 1.0)];
            let (mut at, mut before) = (-self.window[0], None);
            for i in 0..contacts {
                let Some(time) = self.next(at, state) else { break };
                let [_, closing] = self.gap(at, state, time);
                let zeta = state[1] * (-self.fast * (time - at)).exp();
                let ([place, _, bend], after) = (self.wall(time), zeta + (1.0 + self.tau) * -closing);
                let [fastest, most] = self.trap.map(|most| most * (1.0 + 1e-6));
                assert!(i < 3 || -closing < fastest && zeta < most, "out of the trap: {closing}, {zeta}");
                if let Some((stretch, weight)) = before
                    && i > 3
                {
                    let [stay, reach] = self.motion(time - at);
                    let grown: f64 = self.tau * stay + reach * stretch;
                    least = least.min(grown * self.weight(-closing) / weight);
                }
                if -closing < 1e-7 * self.depth.sqrt() {
                    break;
                }
                let turn = (1.0 + self.tau) * (self.slow.powi(2) * place - bend)
                    - (self.slow + self.fast) * (self.tau * zeta + after);
                before = Some((turn / -closing, self.weight(-closing)));
                (at, state) = (time, [place, after]);
            }
        }
        least
    }
}
