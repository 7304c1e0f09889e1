//! Frequency and damping ratio of a machine from a free decay, with their deviations: least squares, in
//! floating point and without proof.
//!
//! The model, with w = ω√(1−ζ²) and a = ζω, is
//!
//! ```text
//! x(t) = c + e^{−at} (A cos wt + B sin wt).
//! ```
//!
//! For given w and a the best c, A and B solve a linear system. So w and a are looked for on a grid, in the
//! first samples and in samples spread over the record, and the best of each damping are refined by
//! Levenberg's and Marquardt's method. With n samples and residuals e, the covariance is Σe²/(n−5) (JᵀJ)⁻¹,
//! which holds if residuals are independent and of one size: so a record whose residuals are not independent
//! is refused.

use std::{
    array,
    f64::consts::{PI, TAU},
};

use crate::error::{Error, Result};

/// A value and its standard deviation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The value.
    pub value: f64,
    /// Its deviation.
    pub deviation: f64,
}

/// What a record of a free decay says of a linear machine with one degree of freedom.
#[derive(Debug, Clone, PartialEq)]
pub struct Decay {
    /// How many samples.
    pub samples: usize,
    /// The time from the first to the last.
    pub duration: f64,
    /// How often it turns in that time.
    pub periods: f64,
    /// The undamped natural frequency ω/2π, per unit of time.
    pub frequency: Estimate,
    /// ζ.
    pub damping_ratio: Estimate,
    /// How the errors of these two go together, from −1 to 1.
    pub correlation: f64,
    /// Where it comes to rest.
    pub offset: Estimate,
    /// How far it swings at the first sample.
    pub amplitude: f64,
    /// The root mean square of the residuals, by n − 5.
    pub rms: f64,
    /// How many runs of residuals with one sign there are.
    pub runs: usize,
    /// How many there would be of independent ones.
    pub expected_runs: f64,
    /// Durbin's and Watson's number: 2 of independent residuals, 0 of such as hardly change.
    pub durbin_watson: f64,
}

/// The fewest samples and periods.
const SAMPLES: usize = 12;
const PERIODS: f64 = 1.5;
/// How many samples are looked at on the grid.
const LOOK: usize = 1024;
/// Decays on the grid, over the time looked at.
const DECAYS: [f64; 5] = [0.0, 1.5, 5.0, 15.0, 50.0];
/// How large Fisher's ratio must be: the largest of n that are noise alone is about 2 ln n.
const FISHER: f64 = 25.0;
/// So many deviations from independence are a structure: of two million white records one has that.
const STRUCTURE: f64 = 5.0;
/// So many tell the damping of two parts of a record apart.
const APART: f64 = 4.0;
/// And so many that from 0.
const DAMPED: f64 = 2.0;
/// Residuals below this part of the amplitude are rounding.
const ROUNDING: f64 = 1e-9;
const ITERATIONS: usize = 100;

/// Times from 0 to 1, values from −1 to 1.
type Points<'a> = &'a [(f64, f64)];

/// The model with parameters c, A, B, w, a, and the sum of its squared residuals.
#[derive(Debug, Clone, Copy)]
struct Fit {
    at: [f64; 5],
    squares: f64,
}

impl Decay {
    /// Fits (time, displacement), by time.
    ///
    /// Cost: O(n) per step of the refinement, and 10⁶ values of the model for the grid.
    ///
    /// # Errors
    /// An input error that says why the record is none of a free decay of the model: too few samples or
    /// periods, nothing but noise, growing, overdamped, residuals with a structure, damping not told from 0.
    pub fn fit(samples: &[(f64, f64)]) -> Result<Decay> {
        let n = samples.len();
        if n < SAMPLES {
            return Err(Error::input(format!("{n} samples: a decay needs at least {SAMPLES}")));
        }
        let (start, duration) = (samples[0].0, samples[n - 1].0 - samples[0].0);
        let mean = samples.iter().map(|sample| sample.1 / n as f64).sum::<f64>();
        let size = samples.iter().map(|sample| (sample.1 - mean).abs()).fold(0.0, f64::max);
        let usable = |x: f64, least: f64| x.is_finite() && x > least;
        if !usable(duration, 0.0) || !mean.is_finite() || !usable(size, 1e-13 * mean.abs()) {
            return Err(Error::input("nothing moves, or times do not rise"));
        }
        let points: Vec<(f64, f64)> =
            samples.iter().map(|(t, x)| ((t - start) / duration, (x - mean) / size)).collect();
        let nothing = || Error::input("no oscillation stands out of the noise");
        let fit = best(&points).ok_or_else(nothing)?;
        let free = (n - 5) as f64;
        let mean = points.iter().map(|point| point.1).sum::<f64>() / n as f64;
        let all: f64 = points.iter().map(|point| (point.1 - mean).powi(2)).sum();
        if (all - fit.squares) / 4.0 < FISHER * fit.squares / free {
            return Err(nothing());
        }
        let [offset, cosine, sine, w, a] = fit.at;
        let periods = w / TAU;
        if periods < PERIODS {
            return Err(Error::input(format!(
                "it turns {periods:.2} times only: overdamped, or too short a record; at least {PERIODS} periods are needed"
            )));
        }
        let variance = fit.squares / free;
        let covariance = Cholesky::new(normal_equations(&points, &fit.at).0).ok_or_else(nothing)?.inverse();
        let covariance = covariance.map(|row| row.map(|x| x * variance));
        let deviation = |i: usize| covariance[i][i].max(0.0).sqrt();
        let residuals: Vec<f64> = points.iter().map(|&point| residual(&fit.at, point)).collect();
        let white = Whiteness::of(&residuals);
        if a < -DAMPED * deviation(4) {
            let factor = (-a / periods).exp();
            return Err(Error::input(format!(
                "it grows, by a factor of {factor:.4} per period: no free decay"
            )));
        }
        let amplitude = cosine.hypot(sine);
        if variance.sqrt() > ROUNDING * amplitude && !white.is_white() {
            return Err(Error::input(structure(&points, &fit, &white)));
        }
        if a <= DAMPED * deviation(4) {
            let [zeta, by] = [a, deviation(4)].map(|x| x / w);
            return Err(Error::input(format!(
                "the damping ratio {zeta:.1e} is not told apart from 0, its deviation being {by:.1e}: record for longer"
            )));
        }
        // ω² = w² + a², ζ = a/ω.
        let omega = w.hypot(a);
        let gradients =
            [[w / omega, a / omega], [-a * w / omega.powi(3), (1.0 - (a / omega).powi(2)) / omega]];
        let of = |i: usize, j: usize| -> f64 {
            let pairs = (0..2).flat_map(|k| (0..2).map(move |l| (k, l)));
            pairs.map(|(k, l)| gradients[i][k] * covariance[3 + k][3 + l] * gradients[j][l]).sum()
        };
        let [by_omega, by_zeta] = [of(0, 0), of(1, 1)].map(|x| x.max(0.0).sqrt());
        let both = by_omega * by_zeta;
        let mean = samples.iter().map(|sample| sample.1 / n as f64).sum::<f64>();
        Ok(Decay {
            samples: n,
            duration,
            periods,
            frequency: Estimate { value: omega / TAU / duration, deviation: by_omega / TAU / duration },
            damping_ratio: Estimate { value: a / omega, deviation: by_zeta },
            correlation: if both > 0.0 { (of(0, 1) / both).clamp(-1.0, 1.0) } else { 0.0 },
            offset: Estimate { value: mean + size * offset, deviation: size * deviation(0) },
            amplitude: size * amplitude,
            rms: size * variance.sqrt(),
            runs: white.runs,
            expected_runs: white.expected,
            durbin_watson: white.durbin_watson,
        })
    }
}

/// Whether residuals look independent.
struct Whiteness {
    runs: usize,
    expected: f64,
    /// How many deviations the runs are too few.
    few: f64,
    durbin_watson: f64,
    /// How many deviations that is away from 2.
    away: f64,
}

impl Whiteness {
    fn of(residuals: &[f64]) -> Whiteness {
        let n = residuals.len() as f64;
        let runs = residuals.chunk_by(|a, b| (*a >= 0.0) == (*b >= 0.0)).count();
        let above = residuals.iter().filter(|e| **e >= 0.0).count() as f64;
        let product = 2.0 * above * (n - above);
        let expected = 1.0 + product / n;
        let spread = (product * (product - n) / (n * n * (n - 1.0))).max(0.0).sqrt().max(0.5);
        let squares: f64 = residuals.iter().map(|e| e * e).sum();
        let steps: f64 = residuals.windows(2).map(|pair| (pair[1] - pair[0]).powi(2)).sum();
        let durbin_watson = if squares > 0.0 { steps / squares } else { 2.0 };
        let away = (1.0 - durbin_watson / 2.0).abs() * n.sqrt();
        Whiteness { runs, expected, few: (expected - runs as f64) / spread, durbin_watson, away }
    }

    fn is_white(&self) -> bool {
        self.few < STRUCTURE && self.away < STRUCTURE
    }
}

/// What is known of residuals that are not independent.
fn structure(points: Points, fit: &Fit, white: &Whiteness) -> String {
    let [.., w, a] = fit.at;
    let mut said = format!(
        "residuals have a structure: {} runs of one sign where {:.0} are expected, Durbin-Watson {:.2} instead of 2",
        white.runs, white.expected, white.durbin_watson
    );
    // What swings most, and what comes after.
    let end = if a > 0.0 { (1.5 / a).min(0.5) } else { 0.5 };
    let cut = points.partition_point(|point| point.0 <= end);
    let parts = [&points[..cut], &points[cut..]].map(|part| {
        let fit = (part.len() >= SAMPLES).then(|| refine(part, w, a)).flatten()?;
        let inverse = Cholesky::new(normal_equations(part, &fit.at).0)?.inverse();
        let variance = fit.squares / (part.len() - 5) as f64;
        Some([fit.at[4], (inverse[4][4].max(0.0) * variance).sqrt()].map(|x| x / w))
    });
    if let [Some([early, by]), Some([late, by_late])] = parts
        && (early - late).abs() > APART * by.hypot(by_late)
    {
        said += &format!(
            "; the damping ratio is {early:.2e} where it swings widely and {late:.2e} later, so that damping depends on the \
             amplitude: fit a part of the record"
        );
    } else {
        said += "; another mode, a drift, or an impact: fit a part of the record";
    }
    said
}

/// c + e^{−aτ}(A cos wτ + B sin wτ) − x.
fn residual(&[c, cosine, sine, w, a]: &[f64; 5], (t, x): (f64, f64)) -> f64 {
    let (sin, cos) = (w * t).sin_cos();
    c + (-a * t).exp() * (cosine * cos + sine * sin) - x
}

/// The sums of products of 1, C, S and x.
#[derive(Default)]
struct Sums {
    n: f64,
    c: f64,
    s: f64,
    x: f64,
    cc: f64,
    cs: f64,
    ss: f64,
    cx: f64,
    sx: f64,
}

impl Sums {
    fn add(&mut self, c: f64, s: f64, x: f64) {
        self.n += 1.0;
        self.c += c;
        self.s += s;
        self.x += x;
        self.cc += c * c;
        self.cs += c * s;
        self.ss += s * s;
        self.cx += c * x;
        self.sx += s * x;
    }

    /// The best c, A and B, and by how much they make the sum of squares less.
    fn solve(&self) -> Option<([f64; 3], f64)> {
        // Columns of one length.
        let scale = [self.n, self.cc, self.ss].map(|square| 1.0 / square.sqrt());
        let [k, l, m] = scale;
        let matrix = [
            [1.0, k * l * self.c, k * m * self.s],
            [k * l * self.c, 1.0, l * m * self.cs],
            [k * m * self.s, l * m * self.cs, 1.0],
        ];
        let right = [k * self.x, l * self.cx, m * self.sx];
        let solved = Cholesky::new(matrix)?.solve(right);
        let gain = solved.iter().zip(right).map(|(x, y)| x * y).sum::<f64>();
        gain.is_finite().then(|| ([k * solved[0], l * solved[1], m * solved[2]], gain))
    }
}

/// L of a symmetric positive definite matrix L Lᵀ.
struct Cholesky<const N: usize>([[f64; N]; N]);

impl<const N: usize> Cholesky<N> {
    /// `None` where the matrix is not positive definite to rounding.
    fn new(matrix: [[f64; N]; N]) -> Option<Self> {
        let mut lower = matrix;
        for i in 0..N {
            for j in 0..=i {
                let known: f64 = (0..j).map(|k| lower[i][k] * lower[j][k]).sum();
                let left = matrix[i][j] - known;
                lower[i][j] = if i == j { left.sqrt() } else { left / lower[j][j] };
            }
            if lower[i][i].is_nan() || lower[i][i] <= 0.0 {
                return None;
            }
        }
        Some(Cholesky(lower))
    }

    fn solve(&self, right: [f64; N]) -> [f64; N] {
        let (lower, mut x) = (&self.0, right);
        for i in 0..N {
            x[i] = (x[i] - (0..i).map(|k| lower[i][k] * x[k]).sum::<f64>()) / lower[i][i];
        }
        for i in (0..N).rev() {
            x[i] = (x[i] - (i + 1..N).map(|k| lower[k][i] * x[k]).sum::<f64>()) / lower[i][i];
        }
        x
    }

    fn inverse(&self) -> [[f64; N]; N] {
        array::from_fn(|i| self.solve(array::from_fn(|j| f64::from(u8::from(i == j)))))
    }
}

/// The best fit for given w and a.
fn evaluate(points: Points, w: f64, a: f64) -> Option<Fit> {
    let mut sums = Sums::default();
    for &(t, x) in points {
        let (sin, cos) = (w * t).sin_cos();
        let decay = (-a * t).exp();
        sums.add(decay * cos, decay * sin, x);
    }
    let ([c, cosine, sine], _) = sums.solve()?;
    let at = [c, cosine, sine, w, a];
    let squares: f64 = points.iter().map(|&point| residual(&at, point).powi(2)).sum();
    squares.is_finite().then_some(Fit { at, squares })
}

/// JᵀJ and Jᵀe.
fn normal_equations(points: Points, at: &[f64; 5]) -> ([[f64; 5]; 5], [f64; 5]) {
    let (mut matrix, mut right) = ([[0.0; 5]; 5], [0.0; 5]);
    let &[c, cosine, sine, w, a] = at;
    for &(t, value) in points {
        let (sin, cos) = (w * t).sin_cos();
        let decay = (-a * t).exp();
        let swing = decay * (cosine * cos + sine * sin);
        let row = [1.0, decay * cos, decay * sin, decay * t * (sine * cos - cosine * sin), -t * swing];
        let residual = c + swing - value;
        for (i, x) in row.iter().enumerate() {
            right[i] += x * residual;
            for (j, y) in row[..=i].iter().enumerate() {
                matrix[i][j] += x * y;
            }
        }
    }
    (array::from_fn(|i| array::from_fn(|j| matrix[i.max(j)][i.min(j)])), right)
}

/// Levenberg's and Marquardt's method, c, A and B being the best at every step.
fn refine(points: Points, w: f64, a: f64) -> Option<Fit> {
    let length = 1.0 / (points[points.len() - 1].0 - points[0].0);
    let mut fit = evaluate(points, w, a)?;
    let mut damping = 1e-3;
    for _ in 0..ITERATIONS {
        let (matrix, right) = normal_equations(points, &fit.at);
        let mut damped = matrix;
        for i in 0..5 {
            damped[i][i] += damping * matrix[i][i] + f64::MIN_POSITIVE;
        }
        let step = Cholesky::new(damped)?.solve(right);
        // By less than a turn over the record, lest it leave the hollow that it is in.
        let turns = (step[3].abs() / length).max(1.0);
        let [w, a] = [3, 4].map(|i| fit.at[i] - step[i] / turns);
        match evaluate(points, w.abs(), a).filter(|next| next.squares <= fit.squares) {
            Some(next) => {
                let small = [3, 4].iter().all(|&i| step[i].abs() < 1e-13 * turns * w.abs());
                fit = next;
                damping *= 0.1;
                if small {
                    break;
                }
            }
            None if damping > 1e9 => break,
            None => damping *= 10.0,
        }
    }
    Some(fit)
}

/// The best fit of all, from the grid.
fn best(points: Points) -> Option<Fit> {
    let n = points.len();
    let first = &points[..n.min(LOOK)];
    let mut found: Vec<Fit> = Vec::new();
    for (w, a) in grid(first) {
        let near = refine(first, w, a);
        found.extend(near.and_then(|near| refine(points, near.at[3], near.at[4])));
    }
    if n > LOOK {
        let spread: Vec<(f64, f64)> = (0..LOOK).map(|i| points[i * (n - 1) / (LOOK - 1)]).collect();
        found.extend(grid(&spread).into_iter().filter_map(|(w, a)| refine(points, w, a)));
    }
    // Beyond one turn for two samples nothing is told apart.
    let most = PI * (n - 1) as f64;
    found
        .into_iter()
        .filter(|fit| fit.at[3] <= most)
        .min_by(|one, other| one.squares.total_cmp(&other.squares))
}

/// The best frequency for each decay, up to one turn for two samples.
fn grid(points: Points) -> Vec<(f64, f64)> {
    let n = points.len();
    let (start, length) = (points[0].0, points[n - 1].0 - points[0].0);
    let step = TAU / (4.0 * length);
    let count = 2 * (n - 1);
    let mut best: [Option<(f64, f64)>; DECAYS.len()] = [None; DECAYS.len()];
    let decays: Vec<[f64; DECAYS.len()]> =
        points.iter().map(|(t, _)| DECAYS.map(|decay| (-decay * (t - start) / length).exp())).collect();
    for w in (1..=count).map(|i| i as f64 * step) {
        let mut sums: [Sums; DECAYS.len()] = Default::default();
        for (&(t, x), decays) in points.iter().zip(&decays) {
            let (sin, cos) = (w * (t - start)).sin_cos();
            for (sums, decay) in sums.iter_mut().zip(decays) {
                sums.add(decay * cos, decay * sin, x);
            }
        }
        for (best, sums) in best.iter_mut().zip(&sums) {
            if let Some((_, gain)) = sums.solve()
                && best.is_none_or(|(_, known)| gain > known)
            {
                *best = Some((w, gain));
            }
        }
    }
    let each = best.into_iter().zip(DECAYS);
    each.filter_map(|(best, decay)| best.map(|(w, _)| (w, decay / length))).collect()
}
