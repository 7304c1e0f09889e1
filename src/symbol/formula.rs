//! u_n, u_k, N_{n,k} and 1 − v_n + a₂ⁿ (59), (60) as polynomials in (a₁, a₂), factored as far as we can
//! prove.
//!
//! With the eigenvalues λ₁, λ₂ and Φ_d the cyclotomic polynomials:
//! - u_n = Π Φ_d(λ₁, λ₂) over the divisors d > 1 of n, Φ_d made homogeneous; each factor is irreducible over
//!   the rationals.
//! - 1 − v_n + a₂ⁿ = (1 − λ₁ⁿ)(1 − λ₂ⁿ) = −Π χ_d over the divisors d of n, with χ_d = ±Φ_d(λ₁)Φ_d(λ₂) monic
//!   in a₁; it is the product of the φ(d) conjugates of a line, so irreducible too. χ_1 = a₁ − a₂ − 1, χ_2 =
//!   a₁ + a₂ + 1.
//! - N_{n,k}: let g = gcd(n, k). u_g divides u_n, u_k and u_{n−k}. Each χ_d with d | g vanishes only where an
//!   eigenvalue has λ^g = 1, and there 2 N_{n,k} = u_n (2 − v_k) − u_k (2 − v_n) is 0: with λ₁ⁿ = λ₁^k = 1
//!   both products are (1 − λ₂ⁿ)(1 − λ₂^k)/(λ₁ − λ₂). What remains is the quotient of N_{n/g,k/g} by χ_1, at
//!   the trace and determinant of A^g.
//!
//! Nothing rests on that reasoning: every quotient is divided out, and the factors multiply back to the
//! polynomial.

use num_integer::gcd;

use super::Polynomial;
use super::print::{Format, prefix};
use crate::error::{Error, Result};

/// The largest period whose formulas are written out: what is left of N_{n,k} has O(n²) terms.
pub const MAX_PERIOD: usize = 200;

/// The names of the two variables.
const NAMES: [&str; 2] = ["a1", "a2"];

/// A polynomial in (a₁, a₂) under its name, with its factors: `expanded` is their product, or its negative.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Factored {
    name: Name,
    /// The polynomial, multiplied out.
    pub expanded: Polynomial,
    /// Whether the product of the factors is the negative of the polynomial.
    pub negative: bool,
    /// Factors other than 1, each monic in a₁.
    pub factors: Vec<Polynomial>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Name {
    U(usize),
    Numerator(usize, usize),
    Determinant(usize),
}

/// u_0, …, u_last for the given trace and determinant.
pub(super) fn recurrence(trace: &Polynomial, determinant: &Polynomial, last: usize) -> Vec<Polynomial> {
    let mut u = vec![Polynomial::default(), Polynomial::from(1)];
    while u.len() <= last {
        let [.., before, now] = &u[..] else { unreachable!("u starts with two terms") };
        u.push(&(trace * now) - &(determinant * before));
    }
    u
}

/// u_n, u_k, N_{n,k} and 1 − v_n + a₂ⁿ, each with its known factors, for 1 ≤ k ≤ n − 1, n ≤ [`MAX_PERIOD`].
///
/// Exact. Cost: O(n²) operations on integers of O(n) bits for each of the O(n) terms of a factor.
///
/// # Errors
/// An input error outside that range.
///
/// ```
/// use grazing::symbol::{Format, period_formulas, write_formulas};
/// let text = write_formulas(&period_formulas(3, 2)?, Format::Text);
/// assert!(text.contains("= (a1 - a2 - 1)*(a1 + a2)"));
/// # Ok::<(), grazing::Error>(())
/// ```
pub fn period_formulas(n: usize, k: usize) -> Result<[Factored; 4]> {
    if !(2..=MAX_PERIOD).contains(&n) || !(1..n).contains(&k) {
        return Err(Error::input(format!(
            "there is no formula for n = {n}, k = {k}: give 2 <= n <= {MAX_PERIOD} and 1 <= k <= n - 1"
        )));
    }
    let [a1, a2] = [0, 1].map(Polynomial::variable);
    let u = recurrence(&a1, &a2, n + 1);
    let power = |e: usize| Polynomial::monomial(1.into(), [0, e as u32]);
    // −(1 − v_j + a₂^j), v_j = u_{j+1} − a₂ u_{j−1}; monic in a₁.
    let determinant = |j: usize| &(&u[j + 1] - &(&a2 * &u[j - 1])) - &(&Polynomial::from(1) + &power(j));
    let numerator = &(&u[n] - &u[k]) - &(&power(k) * &u[n - k]);

    let known = |j| [parts(j, |d| u[d].clone()), parts(j, determinant)].concat();
    let mut factors = known(gcd(n, k));
    let rest = factors.iter().fold(numerator.clone(), |rest, factor| quotient(&rest, factor));
    factors.push(rest);
    let factored = |name, expanded, negative, factors: Vec<Polynomial>| {
        let factors = factors.into_iter().filter(|f| *f != Polynomial::from(1)).collect();
        Factored { name, expanded, negative, factors }
    };
    Ok([
        factored(Name::U(n), u[n].clone(), false, parts(n, |d| u[d].clone())),
        factored(Name::U(k), u[k].clone(), false, parts(k, |d| u[d].clone())),
        factored(Name::Numerator(n, k), numerator, false, factors),
        factored(Name::Determinant(n), -&determinant(n), true, parts(n, determinant)),
    ])
}

/// The factor of `whole(n)` that belongs to each divisor d of n, where `whole(n)` is the product of those of
/// all d.
fn parts(n: usize, whole: impl Fn(usize) -> Polynomial) -> Vec<Polynomial> {
    let mut parts: Vec<(usize, Polynomial)> = Vec::new();
    for d in (1..=n).filter(|d| n.is_multiple_of(*d)) {
        let smaller = parts.iter().filter(|(e, _)| d % e == 0);
        let part = smaller.fold(whole(d), |rest, (_, factor)| quotient(&rest, factor));
        parts.push((d, part));
    }
    parts.into_iter().map(|(_, part)| part).collect()
}

fn quotient(whole: &Polynomial, factor: &Polynomial) -> Polynomial {
    whole.divided_by(factor).expect("the factor was proved to divide, see the head of this file")
}

/// The formulas in one text. For a tool it is a script that also puts the factorisation to the tool: sympy
/// asserts it, z3 and cvc5 answer `unsat` and QEPCAD `TRUE` when expanded and factored forms agree. Cost:
/// linear in the length of the text, of which memory holds about three copies.
pub fn write_formulas(formulas: &[Factored], format: Format) -> String {
    let row = |f: &Factored| {
        let expanded = format.polynomial(&f.expanded, NAMES);
        [f.name.write(format), expanded, format.product(f.negative, &f.factors, NAMES)]
    };
    let rows: Vec<[String; 3]> = formulas.iter().map(row).collect();
    let each = |write: fn(&[String; 3]) -> String| rows.iter().map(write).collect::<Vec<_>>();
    match format {
        Format::Text => each(|[name, e, p]| format!("{name}\n  = {e}\n  = {p}\n")).concat(),
        Format::Latex => {
            let rows = each(|[name, e, p]| format!("{name} = {e}\n = {p}\n"));
            format.paragraphs(&rows.concat())
        }
        Format::Sympy => {
            let rows = each(|[name, e, p]| format!("{name} = {e}\nassert expand({name} - ({p})) == 0\n"));
            format!("from sympy import expand, symbols\n\na1, a2 = symbols(\"a1 a2\")\n{}", rows.concat())
        }
        Format::Smtlib => {
            let definitions = each(|[name, e, _]| format!("(define-fun {name} () Real {e})\n")).concat();
            let claim = prefix("and", "true", &each(|[name, _, p]| format!("(= {name} {p})")));
            format!("{}{definitions}(assert (not {claim}))\n(check-sat)\n", declarations(NAMES))
        }
        Format::Qepcad => {
            let title = each(|[name, ..]| name.clone()).join(", ");
            let claim = each(|[_, e, p]| format!("{e} = {p}")).join("\n  /\\ ");
            format.comments(&[title]) + &quantified(NAMES, &format!("[ {claim} ]"))
        }
    }
}

/// The head of an SMT-LIB script over two real unknowns.
pub(super) fn declarations(names: [&str; 2]) -> String {
    let declare = names.map(|name| format!("(declare-const {name} Real)\n"));
    format!("(set-logic QF_NRA)\n{}", declare.concat())
}

/// QEPCAD's input, below its title, for: `formula` holds for all values of the two variables.
pub(super) fn quantified(names: [&str; 2], formula: &str) -> String {
    let [x, y] = names;
    format!("({x},{y})\n0\n(A {x})(A {y}) {formula}.\nfinish\n")
}

impl Name {
    fn write(self, format: Format) -> String {
        match (format, self) {
            (Format::Text, Name::U(n)) => format!("u_{n}"),
            (Format::Text, Name::Numerator(n, k)) => {
                format!("N_{{{n},{k}}} = u_{n} - u_{k} - a2^{k}*u_{}", n - k)
            }
            (Format::Text, Name::Determinant(n)) => format!("1 - v_{n} + a2^{n}"),
            (Format::Latex, Name::U(n)) => format!("u_{{{n}}}"),
            (Format::Latex, Name::Numerator(n, k)) => format!("N_{{{n},{k}}}"),
            (Format::Latex, Name::Determinant(n)) => format!("1 - v_{{{n}}} + a_2^{{{n}}}"),
            (_, Name::U(n)) => format!("u_{n}"),
            (_, Name::Numerator(n, k)) => format!("N_{n}_{k}"),
            (_, Name::Determinant(n)) => format!("det_{n}"),
        }
    }
}
