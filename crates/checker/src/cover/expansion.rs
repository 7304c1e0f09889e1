//! T_{n,k} on a box: its second-order Taylor expansion at the centre, with a bound of the rest.
//!
//! Write a = n − k and f_q(θ) = sin qθ, or f_q = S_q/n with S_q = sin qθ/sin θ = Σ cos mθ over m = q−1, q−3,
//! …, −(q−1), which has no pole. Then
//!
//! ```text
//! T_k(r, θ) = r^a f_n(θ) − r^n f_a(θ) − f_k(θ).
//! ```
//!
//! On the box |r − r₀| ≤ h, |θ − θ₀| ≤ η put r = r₀ + hx, θ = θ₀ + ηy, |x|, |y| ≤ 1. With the *Taylor
//! coefficients* of a factor, A_i(p; r) = binomial(p, i) r^{p−i} h^i for r^p and F_j(q; θ) = η^j
//! f_q^{(j)}(θ)/j! for f_q, the expansion has the coefficients c_ij = A_i(a) F_j(n) − A_i(n) F_j(a) − [i = 0]
//! F_j(k) at the centre: T_k = Σ_{i+j≤2} c_ij x^i y^j + ρ.
//!
//! **Remainder.** By Taylor's theorem with Lagrange's remainder on the segment from the centre, ρ = Σ_{i+j=3}
//! C_ij x^i y^j with C_ij the same coefficient at a point of the box. r^{p−i} grows with r, and |f_q^{(j)}|
//! is at most q^j, or Σ|m|^j/n for the quotient; so with r₁ = r₀ + h and G_j(q) = η^j/j! times that bound,
//!
//! ```text
//! |C_ij| ≤ d_ij = A_i(a; r₁) G_j(n) + A_i(n; r₁) G_j(a) + [i = 0] G_j(k),   |ρ| ≤ d_30 + d_21 + d_12 + d_03.
//! ```
//!
//! **A sign.** t T_k > 0 on the box, t = ±1, if t c_00 + min(0, t c_20) + min(0, t
//! c_02) > |c_10| + |c_01| + |c_11| + Σ d_ij: x² and y² are between 0 and 1. Likewise for β T_k − α T_d, α, β
//! ≥ 0, whose c are the same combination and whose d are at most β d(k) + α d(d).
//!
//! **Less is enough for most.** Taylor's formula of order m < 3 has Σ_{i+j=m} C_ij x^i y^j for its rest, so
//! |T_k − Σ_{i+j<m} c_ij x^i y^j| ≤ Σ_{i+j=m} d_ij. Since G_j(q) grows with q, that is at most
//!
//! ```text
//! D_m = Σ_{i+j=m} (Ā_i + A_i(n; r₁)) G_j(n) + G_m(n),    Ā_i the largest A_i(p; r₁), p ≤ n,
//! ```
//!
//! the same for all k. So t c_00 > D_1 shows the sign t, and so does t c_00 > |c_10| + |c_01| + D_2.
//!
//! **A derivative.** h ∂_r T = ∂_x T = c_10 + 2 c_20 x + c_11 y + ρ_x, where ρ_x, the second-order remainder
//! of ∂_x T, is Σ over the second derivatives of ∂_x T: |ρ_x| ≤ 3 d_30 + 2 d_21 + d_12. Likewise for y.
//!
//! **Rounding**, in units of 2⁻⁶⁰. The box is exact, its centre too; η is an upper bound, which only enlarges
//! the box. Let H = max(1, ⌈nh⌉). Every A_i is at most 1, being a term of (r + (1 − r))^p as h ≤ 1 − r₁, and
//! is computed from below, with an error of at most n (i = 0), n(hn + 1) ≤ 2nH (i = 1),
//! n(2nHh + 1)/2 + 1 ≤ 3nH²/2 + 1 (i = 2), n(h(3nH²/2 + 1) + 1)/3 + 1 ≤ 6nH³/5 + 1 (i = 3). As
//! nη ≤ 1.6, |F_0|, G_0 ≤ 1, |F_1|, G_1 ≤ 1.6, |F_2|, G_2 ≤ 1.28, G_3 ≤ 0.69, each off by less than 24 (see
//! `Wave`). The 20 products in the c and d of one k, each rounded by 1, and the 4 single terms are together
//! off by less than 2(1 + 1.6 + 1.28 + 0.69) n + 2(1 + 1.6 + 1.28) 2nH + 2(1 + 1.6)(3nH²/2 + 1) +
//! 2(6nH³/5 + 1) + 20·(24 + 1) + 4·24 < 35 nH³ + 620. Where D_1 or D_2 is enough, the error is
//! smaller: D_m has an A_i G_j where c_ij has an A_i F_j, with the same bounds, and products of larger i + j
//! are missing. No value reaches 8, where an `i64` ends: |c_ij| and
//! d_ij are at most 3·1.6.
//!
//! With H = 1 (all boxes but those with r < 1 − 1/n or so) this is 4·10⁻¹⁵ for n = 128. The claims get finer
//! like n⁻⁶, about 10⁻¹³ at n = 128; somewhere beyond n = 200 they are below the error bound, and then a
//! claim is not shown, so rejected.

use std::cell::OnceCell;

use super::fixed::{self, ONE, product};

/// The largest n·η: 1.6.
const WIDEST: i64 = ONE / 5 * 8;

const TOO_WIDE: &str = "the box is too wide for its expansion";

/// A closed box, in units of 2⁻⁶⁰ for r and of 2⁻⁶⁴ for s.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cell {
    /// The bounds of r.
    pub r: [i64; 2],
    /// The bounds of s.
    pub s: [u64; 2],
}

/// Which f: sin qθ, or S_q/n.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// sin qθ.
    Sine,
    /// S_q/n.
    Quotient,
}

/// A_0, A_1, A_2 at the centre and A_0, …, A_3 at r₁.
#[derive(Debug, Clone, Copy, Default)]
struct Power {
    at: [i64; 3],
    bound: [i64; 4],
}

/// F_0, F_1, F_2 at the centre and G_0, …, G_3.
///
/// Errors, with 14 for a sine and e = nη or qη ≤ 1.6: sine form, F_0 14, F_1 1.6·14 + 1, F_2 (2.56·14 + 1 +
/// 1)/2 + 1, G_2 1, G_3 2. Quotient form: the sums of Σ 1, Σ|m|, Σ m² times 14 are divided by n, n², n³,
/// which leaves less than 15, 8, 6; times e^j/j!, less than 15, 14, 10; G 1, 1, 2, 3. All are below 24.
#[derive(Debug, Clone, Copy, Default)]
struct Wave {
    at: [i64; 3],
    bound: [i64; 4],
}

/// The coefficients of one T_k.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Expansion {
    /// c_00, c_10, c_01, c_20, c_11, c_02.
    pub c: [i64; 6],
    /// d_30, d_21, d_12, d_03.
    pub d: [i64; 4],
}

/// What boxes with the same bounds of r have in common: the powers of every p ≤ n.
pub struct Powers {
    all: Vec<Power>,
    /// The largest A_0, A_1, A_2 of all p ≤ n at r₁.
    most: [i64; 3],
    /// The bound of all rounding in the coefficients of one k.
    slack: i64,
}

/// What boxes with the same bounds of s have in common.
pub struct Waves {
    n: u64,
    form: Form,
    turns: u64,
    eta: i64,
    /// sin nθ₀ and cos nθ₀.
    sine_n: (i64, i64),
    wave_n: Wave,
    /// Those of every q ≤ n, once they are needed.
    all: OnceCell<Vec<Wave>>,
}

/// A box, made of its two sides.
pub struct Patch<'a> {
    powers: &'a Powers,
    waves: &'a Waves,
    /// The bound of all rounding in the coefficients of one k.
    pub slack: i64,
    /// D_1 and D_2, with that bound.
    rest: [i128; 2],
}

/// What T_k on a box is made of, for one k.
pub struct Term<'a> {
    patch: &'a Patch<'a>,
    power_a: &'a Power,
    wave_a: &'a Wave,
    wave_k: &'a Wave,
}

impl Powers {
    /// The powers on an interval of r. Needs 2 ≤ n ≤ [`MOST`](super::MOST). Cost: O(n) products.
    ///
    /// # Errors
    /// If it is wider than twice its distance to r = 1.
    pub fn new(n: u64, [low, high]: [i64; 2]) -> Result<Powers, String> {
        let centre = (low + high) / 2;
        let h = high - centre;
        if h > ONE - high {
            return Err(TOO_WIDE.into());
        }
        let steep = ((i128::from(h) * i128::from(n)) >> 60) as i64 + 1;
        let (mut all, mut most) = (Vec::with_capacity(n as usize + 1), [0; 3]);
        for ([a0, a1, a2, _], bound) in chain(centre, h).zip(chain(high, h)).take(n as usize + 1) {
            all.push(Power { at: [a0, a1, a2], bound });
            most = [0, 1, 2].map(|i| bound[i].max(most[i]));
        }
        Ok(Powers { all, most, slack: 35 * n as i64 * steep.pow(3) + 620 })
    }
}

/// A_0, …, A_3 of p = 0, 1, …: A_i(p) = (p h/i) A_{i−1}(p−1).
fn chain(r: i64, h: i64) -> impl Iterator<Item = [i64; 4]> {
    let step = move |p: i64, [a0, a1, a2, _]: [i64; 4]| {
        let next = |a: i64, i: i64| product(a, h) * p / i;
        [product(a0, r), next(a0, 1), next(a1, 2), next(a2, 3)]
    };
    (1..).scan([ONE, 0, 0, 0], move |latest, p| Some(std::mem::replace(latest, step(p, *latest))))
}

impl Waves {
    /// The waves on an interval of s, as [`Powers::new`]. Cost: O(1), in the quotient form O(n).
    ///
    /// # Errors
    /// If it is too wide: η > 1.6/n.
    pub fn new(n: u64, [left, right]: [u64; 2], form: Form) -> Result<Waves, String> {
        let turns = left + (right - left) / 2;
        let eta = fixed::radians_above(right - turns);
        if eta > WIDEST / n as i64 {
            return Err(TOO_WIDE.into());
        }
        let sine_n = fixed::sine_cosine(turns.wrapping_mul(n));
        let wave_n = sine_wave(n, sine_n, eta);
        let mut waves = Waves { n, form, turns, eta, sine_n, wave_n, all: OnceCell::new() };
        if form == Form::Quotient {
            waves.wave_n = waves.all()[n as usize];
        }
        Ok(waves)
    }

    /// Those of all q. Cost: O(n) products the first time.
    fn all(&self) -> &[Wave] {
        let &Waves { n, turns, eta, .. } = self;
        self.all.get_or_init(|| match self.form {
            Form::Sine => {
                let mut all = Vec::with_capacity(n as usize + 1);
                all.extend((0..).zip(fixed::sines_cosines(turns, n)).map(|(q, at)| sine_wave(q, at, eta)));
                all
            }
            Form::Quotient => quotients(n, turns, eta),
        })
    }

    /// Those of k and n − k. Cost: O(1) products.
    fn pair(&self, k: u64) -> [Wave; 2] {
        let a = self.n - k;
        match self.form {
            Form::Sine => {
                let at = fixed::sine_cosine(self.turns.wrapping_mul(k));
                // aθ = nθ − kθ spares a sine.
                let rest = fixed::difference(self.sine_n, at);
                [sine_wave(k, at, self.eta), sine_wave(a, rest, self.eta)]
            }
            Form::Quotient => [k, a].map(|q| self.all()[q as usize]),
        }
    }
}

impl<'a> Patch<'a> {
    /// The box of two sides, which are of the same period.
    pub fn new(powers: &'a Powers, waves: &'a Waves) -> Patch<'a> {
        let (power_n, g) = (&powers.all[waves.n as usize], &waves.wave_n.bound);
        let rest = [1, 2].map(|m| {
            let products = (0..=m).map(|i| i128::from(product(powers.most[i] + power_n.bound[i], g[m - i])));
            products.sum::<i128>() + i128::from(g[m]) + i128::from(powers.slack)
        });
        Patch { powers, waves, slack: powers.slack, rest }
    }

    /// The period.
    pub fn n(&self) -> u64 {
        self.waves.n
    }

    /// The expansion of one T_k. Cost: O(1) products.
    pub fn expansion(&self, k: u64) -> Expansion {
        let [wave_k, wave_a] = self.waves.pair(k);
        self.term((self.n() - k) as usize, &wave_a, &wave_k).expansion()
    }

    /// Whether t T_k > 0 on the box is shown. Cost: O(1) products.
    pub fn shows(&self, k: u64, t: i64) -> bool {
        let [wave_k, wave_a] = self.waves.pair(k);
        self.term((self.n() - k) as usize, &wave_a, &wave_k).shows(t)
    }

    /// T_1, …, T_{n−1} on the box. Cost: O(n) products the first time.
    pub fn terms(&self) -> impl Iterator<Item = Term<'_>> {
        let (n, waves) = (self.n() as usize, self.waves.all());
        (1..n).map(move |k| self.term(n - k, &waves[n - k], &waves[k]))
    }

    #[inline]
    fn term<'t>(&'t self, a: usize, wave_a: &'t Wave, wave_k: &'t Wave) -> Term<'t> {
        Term { patch: self, power_a: &self.powers.all[a], wave_a, wave_k }
    }
}

impl Term<'_> {
    /// c_ij.
    #[inline]
    fn c(&self, i: usize, j: usize) -> i64 {
        let Patch { powers, waves, .. } = self.patch;
        product(self.power_a.at[i], waves.wave_n.at[j])
            - product(powers.all[waves.n as usize].at[i], self.wave_a.at[j])
            - if i == 0 { self.wave_k.at[j] } else { 0 }
    }

    /// d_ij.
    #[inline]
    fn d(&self, i: usize, j: usize) -> i64 {
        let Patch { powers, waves, .. } = self.patch;
        product(self.power_a.bound[i], waves.wave_n.bound[j])
            + product(powers.all[waves.n as usize].bound[i], self.wave_a.bound[j])
            + if i == 0 { self.wave_k.bound[j] } else { 0 }
    }

    /// The expansion. Cost: 20 products.
    pub fn expansion(&self) -> Expansion {
        let (c, d) = (|i, j| self.c(i, j), |i, j| self.d(i, j));
        Expansion {
            c: [c(0, 0), c(1, 0), c(0, 1), c(2, 0), c(1, 1), c(0, 2)],
            d: [d(3, 0), d(2, 1), d(1, 2), d(0, 3)],
        }
    }

    /// Whether t T_k > 0 on the box is shown: by a constant, by a linear polynomial, or by the expansion.
    /// Cost: 2, 6 or 26 products.
    #[inline]
    pub fn shows(&self, t: i64) -> bool {
        let [d1, d2] = self.patch.rest;
        let constant = i128::from(t * self.c(0, 0));
        if constant <= 0 || constant > d1 {
            return constant > 0;
        }
        let linear = i128::from(self.c(1, 0).abs()) + i128::from(self.c(0, 1).abs());
        constant > linear + d2 || self.expansion().shows(t, self.patch.slack)
    }
}

#[inline]
fn sine_wave(q: u64, (sine, cosine): (i64, i64), eta: i64) -> Wave {
    let e = eta * q as i64;
    let square = product(e, e);
    Wave {
        at: [sine, product(e, cosine), -product(square, sine) / 2],
        bound: [ONE, e, square / 2, product(square / 2, e) / 3],
    }
}

/// The waves of S_q/n, q = 0, …, n, by S_q = S_{q−2} + 2 cos (q−1)θ and its derivatives.
fn quotients(n: u64, turns: u64, eta: i64) -> Vec<Wave> {
    let e = eta * n as i64;
    let square = product(e, e);
    let scales = [1, 2, 3, 4].map(|j| i128::from(n).pow(j));
    // Σ cos, −Σ m sin, −Σ m² cos and Σ|m|^j for the two latest q.
    let mut sums = [([0i128; 3], [0i128; 4]); 2];
    let mut waves = Vec::with_capacity(n as usize + 1);
    waves.push(Wave::default());
    for (m, (sine, cosine)) in (0..).zip(fixed::sines_cosines(turns, n - 1)) {
        let (sine, cosine) = (i128::from(sine), i128::from(cosine));
        let (mut at, mut bound) = sums[0];
        if m == 0 {
            (at, bound) = ([ONE.into(), 0, 0], [1, 0, 0, 0]);
        } else {
            let terms = [cosine, -m * sine, -m * m * cosine];
            (0..3).for_each(|j| at[j] += 2 * terms[j]);
            (0..4).for_each(|j| bound[j] += 2 * m.pow(j as u32));
        }
        sums = [sums[1], (at, bound)];
        let part = |j: usize| (at[j] / scales[j]) as i64;
        let share = |j: usize, x: i64| (bound[j] * i128::from(x) / scales[j]) as i64;
        waves.push(Wave {
            at: [part(0), product(e, part(1)), product(square, part(2)) / 2],
            bound: [share(0, ONE), share(1, e), share(2, square / 2), share(3, product(square, e) / 6)],
        });
    }
    waves
}

impl Expansion {
    /// Whether t T_k > 0 on the box is shown.
    pub fn shows(&self, t: i64, slack: i64) -> bool {
        let rest: i128 = self.d.iter().map(|&d| i128::from(d)).sum();
        lower(|i| i128::from(self.c[i]), t) > rest + i128::from(slack)
    }

    /// Whether t (T_k − w T_d) > 0 on the box is shown for some w ≥ 0, `self` being T_k's expansion and w = 0
    /// not sufficient.
    ///
    /// The bound is concave and piecewise linear in w, so that it is enough to try the w that make a
    /// coefficient 0. As β T_k − α T_d, w = α/β, max(α, β) = 1, nothing outgrows its range.
    pub fn shows_beyond(&self, decider: &Expansion, t: i64, slack: i64) -> bool {
        (1..6).any(|i| {
            let (c, d) = (i128::from(self.c[i]), i128::from(decider.c[i]));
            if c.signum() * d.signum() <= 0 {
                return false;
            }
            // Rounded down: any weights ≥ 0 are sound.
            let (beta, alpha) = if c.abs() <= d.abs() {
                (ONE, ((c << 60) / d) as i64)
            } else {
                (((d << 60) / c) as i64, ONE)
            };
            let times = |x: i64, y: i64| i128::from(x) * i128::from(y);
            let mixed = |i: usize| times(beta, self.c[i]) - times(alpha, decider.c[i]);
            let rest = |i: usize| times(beta, self.d[i]) + times(alpha, decider.d[i]);
            beta > 0 && lower(mixed, t) > (0..4).map(rest).sum::<i128>() + times(beta + alpha, slack)
        })
    }

    /// The signs (−1, 0 for unknown, 1) of ∂T/∂r and ∂T/∂s on the box.
    pub fn slopes(&self, slack: i64) -> [i64; 2] {
        let [_, c10, c01, c20, c11, c02] = self.c.map(i128::from);
        let [d30, d21, d12, d03] = self.d.map(i128::from);
        // No coefficient counts more than three times.
        let slack = 3 * i128::from(slack);
        let sign =
            |slope: i128, rest: i128| if slope.abs() > rest + slack { slope.signum() as i64 } else { 0 };
        [
            sign(c10, 2 * c20.abs() + c11.abs() + 3 * d30 + 2 * d21 + d12),
            sign(c01, 2 * c02.abs() + c11.abs() + 3 * d03 + 2 * d12 + d21),
        ]
    }
}

/// A lower bound of t Σ c_ij x^i y^j, the coefficients being in the order of [`Expansion::c`].
#[inline]
fn lower(c: impl Fn(usize) -> i128, t: i64) -> i128 {
    let t = i128::from(t);
    t * c(0) + (t * c(3)).min(0) + (t * c(5)).min(0) - c(1).abs() - c(2).abs() - c(4).abs()
}
