//! Every N_{n,k} on a box in plain floats: Taylor expansions of second order at the centre, with bounds of
//! the rest.
//!
//! Up to factors > 0 (r^{k−1}, sin θ), N_{n,k} is T_k = r^{n−k} f_n − rⁿ f_{n−k} − f_k with f_q = sin qθ
//! (62). Near s = 0 and s = ½ the factor sin θ is divided out and f_q = sin qθ/(n sin θ) = (cos (q−1)θ + cos
//! (q−3)θ + … + cos (1−q)θ)/n. A box of half widths h, η about (r₀, θ₀) is |x|, |y| ≤ 1 in r = r₀ + hx, θ =
//! θ₀ + ηy, and there
//!
//! ```text
//! T_k = c₀₀ + c₁₀x + c₀₁y + c₂₀x² + c₁₁xy + c₀₂y² + rest,   |rest| ≤ d₃₀ + d₂₁ + d₁₂ + d₀₃,
//! ```
//!
//! d from the third derivatives, bounded by powers of r₀ + h and by |∂ʲ sin qθ| ≤ qʲ. Nothing here is proof:
//! the margin below is meant to be larger than what is lost to rounding, here and in the checker, which
//! decides.

use std::f64::consts::TAU;

use super::chart::Frame;

/// 2⁻⁶⁴ turns in radians.
const UNIT: f64 = TAU / 18_446_744_073_709_551_616.0;

/// Taylor coefficients of one factor: at the centre, and bounds over the box (the third order only there).
#[derive(Debug, Clone, Copy, Default)]
struct Factor {
    at: [f64; 3],
    bound: [f64; 4],
}

/// The expansion of one T_k, or of a combination.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Expansion {
    /// c₀₀, c₁₀, c₀₁, c₂₀, c₁₁, c₀₂.
    c: [f64; 6],
    /// d₃₀, d₂₁, d₁₂, d₀₃.
    d: [f64; 4],
    /// What rounding may amount to.
    pad: f64,
}

impl Expansion {
    /// A lower bound of t T on the box, t = ±1.
    pub fn low(&self, t: f64) -> f64 {
        let [c00, c10, c01, c20, c11, c02] = self.c;
        // x² and y² are not negative.
        let others = c10.abs() + c01.abs() + c11.abs() + (-t * c20).max(0.0) + (-t * c02).max(0.0);
        t * c00 - 1.000_001 * (others + self.d.iter().sum::<f64>()) - self.pad
    }

    /// T − wD, w ≥ 0 being such that the gradient is at right angles to that of D: the best guess where T = 0
    /// and D = 0 almost touch.
    pub fn minus_multiple(&self, other: &Expansion) -> Expansion {
        let [_, a, b, ..] = self.c;
        let [_, x, y, ..] = other.c;
        let w = ((a * x + b * y) / (x * x + y * y)).max(0.0);
        Expansion {
            c: std::array::from_fn(|i| self.c[i] - w * other.c[i]),
            d: std::array::from_fn(|i| self.d[i] + w * other.d[i]),
            pad: self.pad + w * other.pad,
        }
    }

    /// A lower bound of t ∂T/∂x on the box.
    pub fn slope_up(&self, t: f64) -> f64 {
        let ([_, c10, _, c20, c11, _], [d30, d21, d12, _]) = (self.c, self.d);
        t * c10 - 1.000_001 * (2.0 * c20.abs() + c11.abs() + 3.0 * d30 + 2.0 * d21 + d12) - 3.0 * self.pad
    }

    /// A lower bound of t ∂T/∂y on the box.
    pub fn slope_right(&self, t: f64) -> f64 {
        let ([_, _, c01, _, c11, c02], [_, d21, d12, d03]) = (self.c, self.d);
        t * c01 - 1.000_001 * (2.0 * c02.abs() + c11.abs() + 3.0 * d03 + 2.0 * d12 + d21) - 3.0 * self.pad
    }

    /// How much T varies on the box along r and along s, relative to its size.
    pub fn shares(&self) -> [f64; 2] {
        let ([c00, c10, c01, c20, c11, c02], [d30, d21, d12, d03]) = (self.c.map(f64::abs), self.d);
        let mixed = (c11 + d21 + d12) / 2.0;
        let (along_r, along_s) = (c10 + c20 + d30 + mixed, c01 + c02 + d03 + mixed);
        [along_r, along_s].map(|share| share / (c00 + along_r + along_s))
    }

    /// Whether T varies by less on the box than rounding may amount to: splitting does not help then.
    pub fn is_noise(&self) -> bool {
        self.c[1..].iter().map(|c| c.abs()).sum::<f64>() + self.d.iter().sum::<f64>() < self.pad
    }
}

/// The expansions of all T_k of one period on one box after the other; buffers are kept.
#[derive(Debug)]
pub(super) struct Expander {
    n: usize,
    /// Σ|m|ʲ/n over the terms of the quotient sin qθ/sin θ.
    moments: Vec<[f64; 4]>,
    quotient: bool,
    waves: Vec<Factor>,
    powers: Vec<Factor>,
    /// At index k, that of T_k; index 0 means nothing.
    pub all: Vec<Expansion>,
}

impl Expander {
    /// For period `n`, in the quotient form or the sine form. O(n).
    pub fn new(n: u64, quotient: bool) -> Self {
        let n = n as usize;
        let mut moments = vec![[0.0; 4]; n + 1];
        moments[1][0] = 1.0 / n as f64;
        for q in 2..=n {
            let m = (q - 1) as f64;
            moments[q] = std::array::from_fn(|j| moments[q - 2][j] + 2.0 * m.powi(j as i32) / n as f64);
        }
        let (waves, powers) = (vec![Factor::default(); n + 1], vec![Factor::default(); n + 1]);
        Expander { n, moments, quotient, waves, powers, all: vec![Expansion::default(); n] }
    }

    /// Expands on a box. O(n), a sine and a cosine for every 8 indices.
    pub fn expand(&mut self, frame: &Frame) {
        let (n, h) = (self.n, frame.h);
        self.expand_waves(frame.turns, frame.half_turns * TAU);
        self.expand_powers(frame.gap, h);
        let steep = (n as f64 * h).floor() + 1.0;
        // The checker's bound of its own rounding, with room.
        let pad = (40.0 * n as f64 * steep.powi(3) + 300.0) * 0.5f64.powi(60) + 6e-15;
        let (last, wave_n) = (self.powers[n], self.waves[n]);
        for k in 1..n {
            let (power, wave, wave_k) = (&self.powers[n - k], &self.waves[n - k], &self.waves[k]);
            let c = |i: usize, j: usize| power.at[i] * wave_n.at[j] - last.at[i] * wave.at[j];
            let d = |i: usize, j: usize| power.bound[i] * wave_n.bound[j] + last.bound[i] * wave.bound[j];
            self.all[k] = Expansion {
                c: [
                    c(0, 0) - wave_k.at[0],
                    c(1, 0),
                    c(0, 1) - wave_k.at[1],
                    c(2, 0),
                    c(1, 1),
                    c(0, 2) - wave_k.at[2],
                ],
                d: [d(3, 0), d(2, 1), d(1, 2), d(0, 3) + wave_k.bound[3]],
                pad,
            };
        }
    }

    /// cos 2πqs and sin 2πqs for q = 0, 1, … by addition from every 8th, s = turns·2⁻⁶⁴.
    fn circle(turns: u64) -> impl Iterator<Item = (f64, f64)> {
        let angle = |turns: u64| {
            // The nearest float, and what is missing: a float has 53 of the 64 bits.
            let float = turns as i64 as f64;
            let ((sine, cosine), rest) =
                ((float * UNIT).sin_cos(), ((turns as i64).wrapping_sub(float as i64)) as f64 * UNIT);
            (cosine - rest * sine, sine + rest * cosine)
        };
        let (cosine, sine) = angle(turns);
        (0..).scan((1.0, 0.0), move |(c, s), q: u64| {
            (*c, *s) = if q.is_multiple_of(8) {
                angle(turns.wrapping_mul(q))
            } else {
                (*c * cosine - *s * sine, *s * cosine + *c * sine)
            };
            Some((*c, *s))
        })
    }

    fn expand_waves(&mut self, turns: u64, eta: f64) {
        if self.quotient {
            return self.expand_quotients(turns, eta);
        }
        for (q, (wave, (cosine, sine))) in self.waves.iter_mut().zip(Self::circle(turns)).enumerate() {
            let e = q as f64 * eta;
            wave.at = [sine, e * cosine, -e * e * sine / 2.0];
            wave.bound = [1.0, e, e * e / 2.0, e * e * e / 6.0];
        }
    }

    fn expand_quotients(&mut self, turns: u64, eta: f64) {
        let scale = 1.0 / self.n as f64;
        for ((q, (cosine, sine)), moments) in (1..=self.n).zip(Self::circle(turns)).zip(&self.moments[1..]) {
            let e = (q - 1) as f64 * eta;
            let terms = [cosine, -e * sine, -e * e * cosine / 2.0];
            self.waves[q].at = if q == 1 {
                [scale, 0.0, 0.0]
            } else {
                std::array::from_fn(|j| self.waves[q - 2].at[j] + 2.0 * scale * terms[j])
            };
            self.waves[q].bound = [
                moments[0],
                moments[1] * eta,
                moments[2] * eta * eta / 2.0,
                moments[3] * eta * eta * eta / 6.0,
            ];
        }
    }

    fn expand_powers(&mut self, gap: f64, h: f64) {
        let (mut at, mut bound) = ([1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]);
        let [r, r1] = [gap, gap - h].map(|gap| 1.0 - gap);
        // What r = 1 − gap lost to rounding.
        let [rest, rest1] = [(1.0 - r) - gap, (1.0 - r1) - (gap - h)];
        for (p, power) in (0..).zip(&mut self.powers) {
            power.at = [at[0], at[1], at[2]];
            power.bound = bound;
            // binomial(p + 1, i) r^(p + 1 − i) hⁱ = (p + 1)/i · h · the one before of p.
            let next = |a: [f64; 4], r: f64, rest: f64| {
                let q = f64::from(p) + 1.0;
                [a[0] * r + a[0] * rest, q * h * a[0], q / 2.0 * h * a[1], q / 3.0 * h * a[2]]
            };
            (at, bound) = (next(at, r, rest), next(bound, r1, rest1));
        }
    }
}
