//! Many points (r, s) with one s, in `f64` or in pairs of them with proved error bounds: the periods that
//! occur by the record form and which may follow which by (64), against the word of the path and its table.
//!
//! Here U is that of `twofold`. e_j ≈ e^{2πijs} comes from products by a number within 4U of e^{2πis}, so
//! that it is off by at most 16jU (the head of `fuzz::sweep` has the proof, here with r = 1), for j ≤ 4096.
//! R_j ≈ rʲ comes from products by r, exact, and is off by at most (j − 1)U relatively; the sweep ends before
//! rʲ underflows, and where smaller products occur in a sum their errors do not count. So z_j = R_j e_j is
//! off by at most 32jU rʲ = E_j rʲ.
//!
//! - *Records*: f_j = Im λʲ/(1 − Re λʲ) as in `fuzz::sweep`. After n it is no record once rⁿ/(1 − rⁿ) is
//!   below both |extremes|, which have opposite signs: then every period has been decided.
//! - *Followers*: p_n = (u_{n+1} − 1)/u_n, q_n = (a₂ⁿ + a₂u_{n−1})/u_n, with y_j = Im λʲ and y_1 = Im λ:
//!   (y_{n+1} − y_1)/y_n and (r²ⁿy_1 + r²y_{n−1})/y_n. The numerators are off by less than 32(n + 4)U r and
//!   64(n + 4)U rⁿ⁺¹, the denominator by 32nU rⁿ; the quotient x/y by less than 1.1 (δx + |x/y| δy)/|y|
//!   where |y| > 16 δy.
//! - *Word*: sides by integers, s = `s`/2⁵⁴ being exact; the deciding b has the sign of u_n T, T = r^{n−k}
//!   sin nθ − rⁿ sin (n−k)θ − sin kθ, whose terms are off by less than 128nU in all.

use num_rational::BigRational;

use super::twofold::Rounded;
use crate::number::{Angle, Sign};

/// The largest period of a sweep.
pub(super) const LONGEST: usize = 1024;

/// 32U j: how far off e_j may be, relatively.
fn error<T: Rounded>(j: usize) -> T {
    T::of(32.0 * T::UNIT * j as f64)
}

/// How the two routes compare at one point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Swept {
    /// On everything, with so many pairs of periods compared.
    Agree(u64),
    /// A bound leaves something open.
    Open,
    /// They do not.
    Differ,
}

/// A period of a word.
#[derive(Debug, Clone, Copy)]
struct Letter {
    m: u64,
    n: usize,
    upper: bool,
}

/// A closed interval of numbers.
type Span<T> = (T, T);

/// The work space of a sweep, and the powers of one angle.
#[derive(Debug, Clone)]
pub(crate) struct WordSweep<T> {
    s: u64,
    cosine: Vec<T>,
    sine: Vec<T>,
    power: Vec<T>,
    /// The periods found by the definition, with p and q.
    found: Vec<(usize, Span<T>, Span<T>)>,
    word: Vec<Letter>,
}

impl<T: Rounded> WordSweep<T> {
    /// For periods up to `last` ≤ [`LONGEST`].
    pub(super) fn new(last: usize) -> WordSweep<T> {
        assert!((3..=LONGEST).contains(&last));
        let room = || vec![T::of(0.0); last + 2];
        WordSweep { s: 1, cosine: room(), sine: room(), power: room(), found: Vec::new(), word: Vec::new() }
    }

    fn last(&self) -> usize {
        self.power.len() - 2
    }

    /// Turns to the angle s = `s`/2⁵⁴, 0 < s < 2⁵³, s odd (so that u_n ≠ 0 for every n < 2⁵²).
    pub(super) fn turn(&mut self, s: u64) {
        self.s = s;
        let angle = Angle::new(&BigRational::new_raw(s.into(), (1u64 << 53).into()));
        let (a, b) = T::cosine_sine(&angle);
        let (mut x, mut y) = (T::of(1.0), T::of(0.0));
        for (cosine, sine) in self.cosine.iter_mut().zip(&mut self.sine) {
            (*cosine, *sine) = (x, y);
            (x, y) = (x * a - y * b, x * b + y * a);
        }
    }

    /// Compares the two routes at r = `r`/2⁵³, 0 < r < 2⁵³.
    pub(super) fn compare(&mut self, r: u64) -> Swept {
        let radius = T::of(r as f64 / (1u64 << 53) as f64);
        let mut power = T::of(1.0);
        for place in &mut self.power {
            *place = power;
            power = power * radius;
        }
        let Some((decided, whole)) = self.by_definition() else { return Swept::Open };
        if decided == 0 {
            return Swept::Differ;
        }
        let Some(ended) = self.by_path() else { return Swept::Open };
        self.against(decided, whole, ended)
    }

    /// Finds the periods that occur for eµ > 0, by records; how far it came, and whether no later one occurs.
    /// `None` where a bound leaves one open. Those for eµ < 0 must be the n with 2ns < 1: (0, …) if they are
    /// not.
    fn by_definition(&mut self) -> Option<(usize, bool)> {
        self.found.clear();
        let zero = T::of(0.0);
        let (mut highest, mut lowest) = ((zero, zero), (zero, zero));
        for n in 1..=self.last() {
            let size = self.power[n];
            if size < T::of(T::SMALLEST) {
                return Some((n - 1, false));
            }
            let (x, y) = (size * self.cosine[n], size * self.sine[n]);
            let here = ratio(x, y, n, size);
            if n == 1 {
                (highest, lowest) = (here, here);
                self.push(1)?;
                continue;
            }
            let (high, low) = (here.0 > highest.1, here.1 < lowest.0);
            if high || low {
                if y.abs() <= error::<T>(n) * size {
                    return None;
                }
                let positive = (y > zero) == high;
                // 2ns < 1 in integers.
                if positive == ((n as u64) * self.s < 1 << 53) {
                    return Some((0, false));
                }
                if positive {
                    self.push(n)?;
                }
            } else if here.1 < highest.0 && here.0 > lowest.1 {
                if (n as u64) * self.s < 1 << 53 {
                    return Some((0, false));
                }
            } else {
                return None;
            }
            highest = (highest.0.larger(here.0), highest.1.larger(here.1));
            lowest = (lowest.0.smaller(here.0), lowest.1.smaller(here.1));
            // rⁿ/(1 − rⁿ) ≤ 2rⁿ for rⁿ ≤ ½; the factor 2.1 covers the rounding of rⁿ.
            if size <= T::of(0.5) && T::of(2.1) * size < highest.0.smaller(-lowest.1) {
                return Some((n, true));
            }
        }
        Some((self.last(), false))
    }

    /// Adds a period with its p and q; `None` if they are not certain enough to be told apart.
    fn push(&mut self, n: usize) -> Option<()> {
        let y = |j: usize| self.power[j] * self.sine[j];
        let (one, r) = (y(1), self.power[1]);
        let (below, off) = (y(n), error::<T>(n) * self.power[n]);
        if below.abs() < T::of(16.0) * off {
            return None;
        }
        let quotient = |x: T, error_x: T| {
            let t = x / below;
            let bound = T::of(1.1) * (error_x + t.abs() * off) / below.abs() + T::of(4.0 * T::UNIT) * t.abs();
            (t - bound, t + bound)
        };
        let p = quotient(y(n + 1) - one, error::<T>(n + 4) * r);
        let ahead = self.power[n] * self.power[n] * one + r * r * y(n - 1);
        let q = quotient(ahead, error::<T>(2 * (n + 4)) * self.power[n] * r);
        self.found.push((n, p, q));
        Some(())
    }

    /// Walks down the path as far as periods occur; whether it was seen to end. `None` where a bound leaves a
    /// sign open.
    fn by_path(&mut self) -> Option<bool> {
        let (power, sine) = (&self.power, &self.sine);
        path(self.s, self.last(), &mut self.word, |n, k| {
            let value = power[n - k] * sine[n] - power[n] * sine[n - k] - sine[k];
            let certain = value.abs() > error::<T>(4 * n);
            certain.then_some(if value < T::of(0.0) { Sign::Negative } else { Sign::Positive })
        })
    }

    /// The periods up to `decided`, or all of them if `whole`, and every pair of them.
    fn against(&self, decided: usize, whole: bool, ended: bool) -> Swept {
        let periods: Vec<usize> = self.found.iter().map(|found| found.0).collect();
        against(&self.word, &periods, (decided, whole, ended), |i, j| {
            let (p, q) = (self.found[j].1, self.found[i].2);
            (p.0 > q.1 || p.1 < q.0).then_some(p.0 > q.1)
        })
    }
}

/// Walks down the Stern–Brocot path to s = `s`/2⁵⁴ as far as periods occur, by the sign of u_n b_{n,k} times
/// something positive; whether it was seen to end before `last`. `None` where such a sign is not certain.
fn path(
    s: u64,
    last: usize,
    word: &mut Vec<Letter>,
    mut deciding: impl FnMut(usize, usize) -> Option<Sign>,
) -> Option<bool> {
    word.clear();
    word.push(Letter { m: 0, n: 1, upper: false });
    let first = (1u64 << 53) / s + 1;
    if first > last as u64 {
        return Some(false);
    }
    word.push(Letter { m: 1, n: first as usize, upper: true });
    let (mut lower, mut upper) = (word[0], word[1]);
    loop {
        let (m, n) = (lower.m + upper.m, lower.n + upper.n);
        if n > last {
            return Some(false);
        }
        let is_upper = u128::from(m) << 54 > n as u128 * u128::from(s);
        let k = if is_upper { upper.n } else { lower.n };
        // u_n < 0 above s.
        if (deciding(n, k)? == Sign::Negative) != is_upper {
            return Some(true);
        }
        let letter = Letter { m, n, upper: is_upper };
        word.push(letter);
        if is_upper { upper = letter } else { lower = letter }
    }
}

/// A word against the periods that occur, up to `decided` or all of them if `whole`, and its edges against
/// `follows(i, j)`, whether p_j > q_i for two of these.
fn against(
    word: &[Letter],
    found: &[usize],
    (decided, whole, ended): (usize, bool, bool),
    mut follows: impl FnMut(usize, usize) -> Option<bool>,
) -> Swept {
    let listed = word.iter().take_while(|letter| whole || letter.n <= decided);
    if !listed.map(|letter| letter.n).eq(found.iter().copied()) {
        return Swept::Differ;
    }
    let newest = |upper: bool| word.iter().rposition(|letter| letter.upper == upper);
    let last = newest(false).zip(newest(true));
    for i in 0..found.len() {
        for j in 0..found.len() {
            let Some(wanted) = edge(word, last, ended, i, j) else { continue };
            match follows(i, j) {
                Some(follows) if follows != wanted => return Swept::Differ,
                Some(_) => {}
                None => return Swept::Open,
            }
        }
    }
    Swept::Agree((found.len() * found.len()) as u64)
}

/// The table of the word theorem: whether p_j > q_i for two letters; `None` for the last pair of a word that
/// was not seen to end.
fn edge(word: &[Letter], last: Option<(usize, usize)>, ended: bool, i: usize, j: usize) -> Option<bool> {
    let (from, to) = (word[i], word[j]);
    if from.upper == to.upper {
        return Some(from.upper);
    }
    let (d, u) = if from.upper { (j, i) } else { (i, j) };
    if last == Some((d, u)) {
        return ended.then_some(to.upper);
    }
    let (a, b) = (word[d], word[u]);
    if b.m * a.n as u64 == a.m * b.n as u64 + 1 {
        let mediant = word[d.max(u)..].iter().find(|letter| letter.n == a.n + b.n);
        return mediant.map(|letter| letter.upper);
    }
    Some(d > u)
}

/// An enclosure of Im λʲ/(1 − Re λʲ) from z_j; `fuzz::sweep` has the proof, here with twice its bound on z_j.
fn ratio<T: Rounded>(x: T, y: T, j: usize, size: T) -> Span<T> {
    let e = error::<T>(j) * size * T::of(1.01);
    let e1 = e + error(1);
    let d = T::of(1.0) - x;
    if d < T::of(4.0) * e1 {
        return (T::of(f64::NEG_INFINITY), T::of(f64::INFINITY));
    }
    let t = y / d;
    let bound = T::of(2.0) * (e + t.abs() * e1) / d + t.abs() * T::of(8.0 * T::UNIT);
    (t - bound, t + bound)
}

#[cfg(test)]
mod tests {
    use num_traits::{One, Pow};

    use super::{
        super::{
            points::{angle, modulus},
            twofold::Twofold,
        },
        *,
    };
    use crate::{
        number::{Ball, Circular, Precision, Real},
        random::Random,
    };

    fn fraction(p: u64, bits: u32) -> BigRational {
        BigRational::new_raw(p.into(), (1u64 << bits).into())
    }

    fn exact(x: f64) -> BigRational {
        BigRational::from_float(x).unwrap()
    }

    /// p and q lie in their intervals, which are no wider than they must be by a million.
    #[test]
    fn followers_are_enclosed() {
        let (precision, mut random) = (Precision::new(300), Random::of_unit(11, 0));
        let mut sweep = WordSweep::<f64>::new(40);
        let mut seen = 0;
        for _ in 0..40 {
            let (r, s) = (random.bits() >> 12 | 1 << 52, random.bits() >> 11 | 1);
            sweep.turn(s);
            if sweep.compare(r) == Swept::Open {
                continue;
            }
            let radius = fraction(r, 53);
            let angle = Angle::new(&fraction(s, 53));
            let y = |j: usize| {
                Ball::sin(&angle.times(j as u64), &precision)
                    * &Ball::ratio(&Pow::pow(&radius, j), &precision)
            };
            let square = Ball::ratio(&(&radius * &radius), &precision);
            for &(n, p, q) in &sweep.found {
                let true_p = (y(n + 1) - &y(1)) / &y(n);
                let weight = Ball::ratio(&Pow::pow(&radius, 2 * n), &precision);
                let true_q = (weight * &y(1) + &(square.clone() * &y(n - 1))) / &y(n);
                for (span, value) in [(p, true_p), (q, true_q)] {
                    let (lo, hi) = value.exact_bounds().unwrap();
                    assert!(exact(span.0) <= lo && hi <= exact(span.1), "n = {n}: {span:?}");
                    seen += usize::from(exact(span.0) != lo);
                }
            }
        }
        assert!(seen > 100, "{seen}");
        assert!(BigRational::one() == exact(1.0));
    }

    /// An edge, a side or a period changed on one route is noticed.
    #[test]
    fn a_changed_word_differs() {
        let mut sweep = WordSweep::<f64>::new(64);
        // DUD at r = 0.9, s = 0.37.
        sweep.turn((0.37 * (1u64 << 54) as f64) as u64 | 1);
        let r = (0.9 * (1u64 << 53) as f64) as u64;
        assert_eq!(sweep.compare(r), Swept::Agree(9));
        let (decided, whole) = sweep.by_definition().unwrap();
        let ended = sweep.by_path().unwrap();
        assert!(whole && ended && sweep.word.len() == 3);
        for change in 0..3 {
            let kept = sweep.word.clone();
            match change {
                0 => drop(sweep.word.pop()),
                1 => sweep.word[2].upper = true,
                _ => sweep.word.push(Letter { m: 2, n: 5, upper: true }),
            }
            assert_eq!(sweep.against(decided, whole, ended), Swept::Differ, "{change}");
            sweep.word = kept;
        }
        assert_eq!(sweep.against(decided, whole, false), Swept::Agree(9));
    }

    /// Where floats decide, pairs say the same of as many periods; where they do not, pairs nearly always
    /// decide.
    #[test]
    fn pairs_agree_with_floats() {
        let mut random = Random::of_unit(5, 0);
        let (mut near, mut closer) = (WordSweep::<f64>::new(48), WordSweep::<Twofold>::new(48));
        let (mut agreed, mut open, mut still) = (0, 0, 0);
        for _ in 0..1200 {
            let (family, s) = angle(&mut random);
            near.turn(s);
            closer.turn(s);
            for _ in 0..8 {
                let r = modulus(&mut random, family);
                let found = closer.compare(r);
                match near.compare(r) {
                    Swept::Agree(pairs) => {
                        // Pairs give up smaller powers than floats do.
                        let as_many = matches!(found, Swept::Agree(more) if more >= pairs);
                        assert!(as_many || r < 1 << 43, "{r} {s}: {found:?}");
                        agreed += 1;
                    }
                    Swept::Open => {
                        assert_ne!(found, Swept::Differ, "{r} {s}");
                        open += 1;
                        still += usize::from(found == Swept::Open);
                    }
                    Swept::Differ => panic!("{r} {s}"),
                }
            }
        }
        assert!(agreed > 6000 && open > 40 && still <= open / 10, "{agreed} {open} {still}");
    }
}
