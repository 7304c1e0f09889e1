//! What several test programs share: the plainest possible decision of Theorem 2's signs, as an oracle.

// Each test program uses a part of this.
#![allow(dead_code)]

pub mod damage;

use num_integer::Integer;
use proptest::test_runner::{Config, FileFailurePersistence, RngAlgorithm, TestRng, TestRunner};

use crate::samples::{samples, seed_bytes};

/// Property tests keep the inputs that failed beside their source, and try them first from then on.
pub fn config() -> Config {
    let failure_persistence = Some(Box::new(FileFailurePersistence::WithSource("regressions")) as _);
    Config { cases: samples(48), failure_persistence, ..Config::default() }
}

/// What draws the same in every run, and with `GRAZING_DRAW` something else.
pub fn runner(own: u64) -> TestRunner {
    TestRunner::new_with_rng(Config::default(), TestRng::from_seed(RngAlgorithm::ChaCha, &seed_bytes(own)))
}

/// A fraction, any sign, any terms.
pub type Fraction = (i128, i128);

/// sign sin(πp/q), q > 0.
pub fn sign_sin(p: i128, q: i128) -> i32 {
    let t = p.rem_euclid(2 * q);
    if t == 0 || t == q {
        0
    } else if t < q {
        1
    } else {
        -1
    }
}

/// sign of −2 sin kπs sin (n−k)πs / cos nπs (B1) at s = p/q; `None` where cos nπs = 0.
pub fn sign_b(n: i128, k: i128, (p, q): Fraction) -> Option<i32> {
    let cos = sign_sin(2 * n * p + q, 2 * q);
    (cos != 0).then(|| -sign_sin(k * p, q) * sign_sin((n - k) * p, q) * cos)
}

/// sign of −2 sin 2πs tan nπs (B2) at s = p/q; `None` where cos nπs = 0.
pub fn sign_c(n: i128, (p, q): Fraction) -> Option<i32> {
    let cos = sign_sin(2 * n * p + q, 2 * q);
    (cos != 0).then(|| -sign_sin(2 * p, q) * sign_sin(n * p, q) * cos)
}

/// Whether u_n = 0: sin 2πns = 0.
pub fn singular(n: i128, (p, q): Fraction) -> bool {
    2 * n * p % q == 0
}

/// Every zero and pole of every b_{n,k} and c_n in [0, ½], in order.
pub fn cuts(n: i128) -> Vec<Fraction> {
    let mut all: Vec<Fraction> = (1..n)
        .chain([2 * n])
        .flat_map(|q| (0..=q / 2).map(move |p| (p / p.gcd(&q), q / p.gcd(&q))))
        .collect();
    all.push((1, 2));
    all.sort_by(|a, b| (a.0 * b.1).cmp(&(b.0 * a.1)));
    all.dedup();
    all
}

/// The midpoint of two fractions.
pub fn middle(a: Fraction, b: Fraction) -> Fraction {
    (a.0 * b.1 + b.0 * a.1, 2 * a.1 * b.1)
}

pub fn less(a: Fraction, b: Fraction) -> bool {
    a.0 * b.1 < b.0 * a.1
}

/// The (sign eµ, sign γ) for which (52), (53) hold at s, where u_n ≠ 0.
pub fn cases(n: i128, s: Fraction) -> Vec<(i32, i32)> {
    let mut found = Vec::new();
    for emu in [-1, 1] {
        for gamma in [-1, 1] {
            let all = (1..n).all(|k| sign_b(n, k, s).is_some_and(|b| emu * b > 0));
            if all && sign_c(n, s).is_some_and(|c| emu * gamma * c > 0) {
                found.push((emu, gamma));
            }
        }
    }
    found
}

/// Theorem 2's intervals for n ≥ 3, the neighbours found by trying every denominator.
pub fn theorem(n: i128) -> Vec<(Fraction, Fraction, i32, i32)> {
    let mut all = vec![((0, 1), (1, 2 * n), -1, 1)];
    for m in (1..n).filter(|&m| 2 * m < n && m.gcd(&n) == 1) {
        let (n_minus, m_minus) =
            (1..n).find_map(|q| (0..=q).find(|p| m * q - p * n == -1).map(|p| (q, p))).unwrap();
        let (n_plus, m_plus) =
            (1..n).find_map(|q| (0..=q).find(|p| m * q - p * n == 1).map(|p| (q, p))).unwrap();
        let left = if m == 1 { (1, 2 * n) } else { (m_plus, n_plus) };
        all.push((left, (m, n), 1, 1));
        all.push(((m, n), (m_minus, n_minus), 1, -1));
    }
    all
}
