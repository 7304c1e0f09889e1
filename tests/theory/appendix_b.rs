//! Appendix B's expansions of b_{n,k} and c_n on r = 1, each proved in exact algebra for every n ≤ 50.
//!
//! With w = exp(2πis), 2i sin 2πs u_j = S(j) := w^j − w^{−j}, so that b_{n,k} = N/D with N = S(n) − S(k) −
//! S(n−k) and D = S(n): polynomials in w and 1/w with integer coefficients. At a root of unity w₀ =
//! exp(2πis₀), s = s₀ + ε,
//!
//! f = Σ c_e w^e  has  f = Σ_p T_p(f) (2πiε)^p / p!,  T_p(f) = Σ c_e e^p w₀^e,
//!
//! and every coefficient the appendix states is, up to powers of 2πi, a ratio of such T_p. An equation
//! between T_p holds at all primitive d-th roots of unity exactly if its polynomial is divisible by the
//! cyclotomic polynomial Φ_d: integer arithmetic, nothing rounded.

use grazing::symbol::{Polynomial, period_formulas};
use num_integer::gcd;

/// Integer coefficients with their exponents of w, which may be negative or repeated.
type Laurent = Vec<(i64, i64)>;

const LAST: i64 = 50;

fn s(j: i64) -> Laurent {
    vec![(1, j), (-1, -j)]
}

fn numerator(n: i64, k: i64) -> Laurent {
    [s(n), times(-1, &s(k)), times(-1, &s(n - k))].concat()
}

fn times(factor: i64, f: &Laurent) -> Laurent {
    f.iter().map(|(c, e)| (factor * c, *e)).collect()
}

fn product(f: &Laurent, g: &Laurent) -> Laurent {
    f.iter().flat_map(|(c, e)| g.iter().map(move |(d, h)| (c * d, e + h))).collect()
}

/// f − g
fn minus(f: &Laurent, g: &Laurent) -> Laurent {
    [f.clone(), times(-1, g)].concat()
}

/// T_p as a Laurent polynomial in w₀.
fn t(p: u32, f: &Laurent) -> Laurent {
    f.iter().map(|(c, e)| (c * e.pow(p), *e)).collect()
}

/// Arithmetic at the primitive d-th roots of unity, all at once.
struct Root {
    d: i64,
    cyclotomic: Vec<i64>,
}

impl Root {
    fn all(last: i64) -> Vec<Root> {
        let mut roots: Vec<Root> = Vec::new();
        for d in 1..=last {
            let mut cyclotomic = vec![0; d as usize + 1];
            (cyclotomic[0], cyclotomic[d as usize]) = (-1, 1);
            for smaller in roots.iter().filter(|r| d % r.d == 0) {
                let (quotient, rest) = divide(cyclotomic, &smaller.cyclotomic);
                assert!(rest.iter().all(|c| *c == 0));
                cyclotomic = quotient;
            }
            roots.push(Root { d, cyclotomic });
        }
        roots
    }

    /// Whether f(w₀) = 0.
    fn zero(&self, f: &Laurent) -> bool {
        let mut dense = vec![0; self.d as usize];
        f.iter().for_each(|(c, e)| dense[e.rem_euclid(self.d) as usize] += c);
        divide(dense, &self.cyclotomic).1.iter().all(|c| *c == 0)
    }
}

/// Quotient and remainder by a monic polynomial, lowest coefficient first.
fn divide(mut rest: Vec<i64>, monic: &[i64]) -> (Vec<i64>, Vec<i64>) {
    let degree = monic.len() - 1;
    let mut quotient = vec![0; rest.len().saturating_sub(degree)];
    for i in (0..quotient.len()).rev() {
        quotient[i] = rest[i + degree];
        monic.iter().enumerate().for_each(|(j, m)| rest[i + j] -= quotient[i] * m);
    }
    rest.truncate(degree);
    (quotient, rest)
}

/// Whether f = g as Laurent polynomials.
fn identical(f: &Laurent, g: &Laurent) -> bool {
    let mut terms = std::collections::HashMap::new();
    minus(f, g).into_iter().for_each(|(c, e)| *terms.entry(e).or_insert(0) += c);
    terms.values().all(|c| *c == 0)
}

/// `polynomial` at a₁ = w + 1/w, a₂ = 1.
fn on_the_circle(polynomial: &Polynomial) -> Laurent {
    let mut powers = vec![vec![(1, 0)]];
    let mut total = Laurent::new();
    for ([i, _], c) in polynomial.terms() {
        while powers.len() <= *i as usize {
            // (w + 1/w)^p, like terms collected.
            let p = powers.len() as i64;
            let last = &powers[p as usize - 1];
            let next = (0..=p).map(|j| {
                let coefficient = |e: i64| last.iter().find(|(_, f)| *f == e).map_or(0, |(c, _)| *c);
                (coefficient(p - 2 * j - 1) + coefficient(p - 2 * j + 1), p - 2 * j)
            });
            let next = next.collect();
            powers.push(next);
        }
        let c = i64::try_from(c).expect("coefficients for n <= 50 are small");
        total.extend(times(c, &powers[*i as usize]));
    }
    total
}

/// The definitions (59), (60) become N, D and S on r = 1: (B1) and (B2) in factored form follow.
#[test]
fn the_polynomials_on_the_circle() {
    for n in 2..=LAST {
        let mut formulas = None;
        for k in 1..n {
            let [u, _, big_n, determinant] = period_formulas(n as usize, k as usize).unwrap();
            assert!(identical(&product(&on_the_circle(&u.expanded), &s(1)), &s(n)), "n = {n}");
            let own = product(&on_the_circle(&big_n.expanded), &s(1));
            assert!(identical(&own, &numerator(n, k)), "n = {n}, k = {k}");
            formulas = Some(determinant);
        }
        // 1 − v_n + 1 = −(wⁿ − 1)² w^{−n}, so c_n = (w − 1/w)(wⁿ − 1)/(wⁿ + 1) = −2 sin 2πs tan nπs.
        let determinant = on_the_circle(&formulas.expect("n >= 2").expanded);
        assert!(identical(&determinant, &vec![(2, 0), (-1, n), (-1, -n)]), "n = {n}");
    }
}

/// wⁿ N = (wⁿ − 1)(w^k − 1)(w^{n−k} − 1) and wⁿ D = (wⁿ − 1)(wⁿ + 1): b_{n,k} = (w^k − 1)(w^{n−k} − 1)/(wⁿ +
/// 1). Each factor has simple roots, so zeros are at m/k and m/(n−k) alone, double exactly where both, which
/// is where w^{gcd(n,k)} = 1; and poles, where wⁿ = −1 and neither factor is 0, are simple.
#[test]
fn where_zeros_and_poles_are() {
    let minus_one = |j: i64| vec![(1, j), (-1, 0)];
    for n in 2..=LAST {
        let shift = vec![(1, n)];
        let denominator = product(&minus_one(n), &vec![(1, n), (1, 0)]);
        assert!(identical(&product(&shift, &s(n)), &denominator), "n = {n}");
        for k in 1..n {
            let factored = product(&minus_one(n), &product(&minus_one(k), &minus_one(n - k)));
            assert!(identical(&product(&shift, &numerator(n, k)), &factored), "n = {n}, k = {k}");
        }
    }
    // Both factors vanish exactly at the multiples of 1/gcd(n, k), which are multiples of 1/n.
    for root in &Root::all(2 * LAST) {
        for n in 2..=LAST {
            for k in 1..n {
                let both = root.zero(&minus_one(k)) && root.zero(&minus_one(n - k));
                assert_eq!(both, gcd(n, k) % root.d == 0, "d = {}, n = {n}, k = {k}", root.d);
            }
        }
    }
}

/// At s = m/n: b = 2 sin²(πkm/n); where km/n is an integer, b = −2π²k(n−k)ε² + O(ε⁴).
#[test]
fn values_at_multiples_of_1_over_n() {
    for root in &Root::all(LAST) {
        for n in (2..=LAST).filter(|n| n % root.d == 0) {
            let d = s(n);
            assert!(root.zero(&t(0, &d)) && !root.zero(&t(1, &d)), "u_n has a simple zero, n = {n}");
            for k in 1..n {
                let big_n = numerator(n, k);
                assert!(root.zero(&t(0, &big_n)));
                // 2 T₁(N) = 2 · 2 sin²(πkm/n) T₁(D), and 4 sin² x = 2 − e^{2ix} − e^{−2ix}.
                let four_sin2 = vec![(2, 0), (-1, k), (-1, -k)];
                let value = minus(&times(2, &t(1, &big_n)), &product(&four_sin2, &t(1, &d)));
                assert!(root.zero(&value), "value at m/n, n = {n}, k = {k}, d = {}", root.d);
                if k % root.d == 0 {
                    // T₃(N)(2πi)³/6 = −2π²k(n−k) T₁(D)(2πi), and b is even in ε.
                    assert!(root.zero(&t(1, &big_n)) && root.zero(&t(2, &big_n)) && root.zero(&t(4, &big_n)));
                    assert!(root.zero(&t(2, &d)));
                    let third = minus(&t(3, &big_n), &times(3 * k * (n - k), &t(1, &d)));
                    assert!(root.zero(&third), "double zero, n = {n}, k = {k}, d = {}", root.d);
                }
            }
        }
    }
}

/// At s = (2m+1)/(2n): b = 2(n−k)/n where k(2m+1)/n is an odd integer, 2k/n where it is even, else a simple
/// pole with b = sin(πk(2m+1)/n)/(πnε) + O(1).
#[test]
fn poles_and_finite_limits() {
    let (mut poles, mut odd, mut even) = (0, 0, 0);
    for root in &Root::all(2 * LAST) {
        for n in (2..=LAST).filter(|n| (2 * n) % root.d == 0 && n % root.d != 0) {
            let d = s(n);
            assert!(root.zero(&t(0, &d)) && !root.zero(&t(1, &d)), "u_n has a simple zero, n = {n}");
            for k in 1..n {
                let big_n = numerator(n, k);
                let limit = |twice: i64| {
                    root.zero(&t(0, &big_n))
                        && root.zero(&minus(&times(n, &t(1, &big_n)), &times(twice, &t(1, &d))))
                };
                // w₀^k = exp(πik(2m+1)/n) is −1 or 1 where the multiple is an odd or even integer.
                if root.zero(&vec![(1, k), (1, 0)]) {
                    odd += 1;
                    assert!(limit(2 * (n - k)), "odd, n = {n}, k = {k}, d = {}", root.d);
                } else if root.zero(&vec![(1, k), (-1, 0)]) {
                    even += 1;
                    assert!(limit(2 * k), "even, n = {n}, k = {k}, d = {}", root.d);
                } else {
                    poles += 1;
                    // N(w₀)/(2πi T₁(D)) = sin(…)/(πn), and 2i sin(πk(2m+1)/n) = S(k).
                    let residue = minus(&times(n, &t(0, &big_n)), &product(&s(k), &t(1, &d)));
                    assert!(root.zero(&residue), "pole, n = {n}, k = {k}, d = {}", root.d);
                    assert!(!root.zero(&t(0, &big_n)));
                }
            }
        }
    }
    // Every (n, k, d) with d | 2n but not d | n was in one of the three cases.
    let classes = |n: i64| (1..=2 * n).filter(|d| 2 * n % d == 0 && n % d != 0).count() as i64;
    assert_eq!(poles + odd + even, (2..=LAST).map(|n| (n - 1) * classes(n)).sum::<i64>());
    assert!(odd > 0 && even > 0);
}
