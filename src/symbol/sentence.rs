//! What holds for one period in one area, as a closed sentence about polynomials that other tools can decide.
//!
//! In every area here 1 − a₁ + a₂ > 0, a factor of every N_{n,k}, so with Q_k = N_{n,k} / (1 − a₁ + a₂) the
//! sign of b_{n,k} (59) is that of Q_k u_n, and the sentences speak of u_n and the Q_k alone, which are
//! easier to decide.
//!
//! On a half-cell of region 3, a₁ = 2rc and a₂ = r² with c = cos 2πs turn u_n into r^{n−1} U(c) and Q_k into
//! r^{k−1} times a polynomial in (c, r). The ends of the half-cell are neighbouring roots cos(πj/n) of U;
//! between them U has one sign, and beyond them, up to the next roots, the other. So rational bounds that
//! shut out the next roots, together with that sign of U, describe the half-cell without naming its ends, and
//! the sentence has two variables.

use std::fmt::{self, Display};
use std::str::FromStr;

use num_bigint::BigInt;
use num_integer::{ExtendedGcd, Integer};
use num_rational::BigRational;

use super::formula::{declarations, quantified, recurrence};
use super::print::{Format, prefix};
use super::{Polynomial, chebyshev_roots};
use crate::error::{Error, Result};

/// The largest period for which sentences are written: far beyond what the tools decide
/// (`docs/conjecture1.md`).
pub const MAX_SENTENCE_PERIOD: usize = 50;

/// Where a sentence speaks: region 4 or the half-cell on one side of s = m/n.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Area {
    /// −(a₂ + 1) < a₁ ≤ −2√a₂, 0 < a₂ < 1; written `region4`.
    Region4,
    /// Half a cell beside s = m/n; written `3+` or `3-` for m = 3.
    HalfCell {
        /// The numerator, coprime to the period.
        m: usize,
        /// The side.
        side: HalfCellSide,
    },
}

/// A side of s = m/n, named by the sign of γ of the orbits there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HalfCellSide {
    /// (m − ½)/n < s < m/n, where orbits are (+,+).
    Plus,
    /// m/n < s < (m + ½)/n, where orbits are (+,−).
    Minus,
}

/// A closed sentence: for all values of the two variables, what is given implies what is claimed.
#[derive(Debug, Clone)]
pub struct Sentence {
    title: Vec<String>,
    names: [&'static str; 2],
    given: Vec<Atom>,
    claimed: Vec<Atom>,
    /// All of these hold exactly if the one at the index does.
    equivalent: Option<(Vec<Atom>, usize)>,
}

/// A polynomial compared with 0.
#[derive(Debug, Clone)]
struct Atom(Polynomial, Relation);

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Relation {
    Negative,
    Positive,
    NonNegative,
}
use Relation::{Negative, NonNegative, Positive};

impl Sentence {
    /// What the paper's Conjecture 1 says of period n in `area`.
    ///
    /// Region 4: n odd, u_n > 0 and all b_{n,k} > 0 iff b_{n,n−2} > 0; n even, b_{n,2} < 0 < b_{n,1}, so that
    /// there is no orbit (S5). A half-cell, for 0 < r ≤ 1: all b_{n,k} > 0 iff the deciding one is, k = n −
    /// m⁻¹ mod n on the side `+` and m⁻¹ mod n on the side `-` (S3).
    ///
    /// # Errors
    /// An input error unless 3 ≤ n ≤ [`MAX_SENTENCE_PERIOD`] and, for a half-cell, 0 < 2m < n with m coprime
    /// to n.
    pub fn new(n: usize, area: Area) -> Result<Sentence> {
        if !(3..=MAX_SENTENCE_PERIOD).contains(&n) {
            return Err(Error::input(format!(
                "there is no sentence for n = {n}: give 3 <= n <= {MAX_SENTENCE_PERIOD}"
            )));
        }
        let [a1, a2] = [0, 1].map(Polynomial::variable);
        let known = &(&a1 - &a2) - &Polynomial::from(1);
        let mut u = recurrence(&a1, &a2, n);
        let quotient = |k: usize| {
            let power = Polynomial::monomial(1.into(), [0, k as u32]);
            let numerator = &(&u[n] - &u[k]) - &(&power * &u[n - k]);
            -&numerator.divided_by(&known).expect("a1 - a2 - 1 divides every N_{n,k}")
        };
        let quotients: Vec<_> = (1..n).map(quotient).collect();
        let (Some(u), title) = (u.pop(), |text: &str| format!("{area} of period {n}: {text}")) else {
            unreachable!("the recurrence gives u_0, ..., u_n")
        };
        match area {
            Area::Region4 => Ok(Self::region4(n, title, u, quotients)),
            Area::HalfCell { m, side } => Self::half_cell(n, m, side, title, u, quotients),
        }
    }

    fn region4(
        n: usize,
        title: impl Fn(&str) -> String,
        u: Polynomial,
        mut quotients: Vec<Polynomial>,
    ) -> Sentence {
        let [a1, a2] = [0, 1].map(Polynomial::variable);
        let one = Polynomial::from(1);
        let four_a2 = Polynomial::monomial(4.into(), [0, 1]);
        let given = vec![
            Atom(a2.clone(), Positive),
            Atom(&one - &a2, Positive),
            Atom(a1.clone(), Negative),
            Atom(&(&a1 * &a1) - &four_a2, NonNegative),
            Atom(&(&a1 + &a2) + &one, Positive),
        ];
        let (claim, claimed, equivalent) = if n % 2 == 1 {
            let all = quotients.into_iter().map(|q| Atom(q, Positive)).collect();
            ("u_n > 0, and all b_(n,k) > 0 iff b_(n,n-2) > 0", vec![Atom(u, Positive)], Some((all, n - 3)))
        } else {
            let second = quotients.swap_remove(1);
            let first = quotients.swap_remove(0);
            let claimed = vec![Atom(u, Negative), Atom(first, Negative), Atom(second, Positive)];
            ("u_n < 0 and b_(n,2) < 0 < b_(n,1), so no orbit", claimed, None)
        };
        let title = vec![title(claim), "b_(n,k) has the sign of u_n Q_k, Q_k = N_(n,k)/(1 - a1 + a2)".into()];
        Sentence { title, names: ["a1", "a2"], given, claimed, equivalent }
    }

    fn half_cell(
        n: usize,
        m: usize,
        side: HalfCellSide,
        title: impl Fn(&str) -> String,
        u: Polynomial,
        quotients: Vec<Polynomial>,
    ) -> Result<Sentence> {
        let ExtendedGcd { gcd, x: inverse, .. } = (m as i64).extended_gcd(&(n as i64));
        if gcd != 1 || m == 0 || 2 * m >= n {
            return Err(Error::input(format!(
                "period {n} has no area at m = {m}: give 0 < 2m < n with m coprime to n"
            )));
        }
        let inverse = inverse.rem_euclid(n as i64) as usize;
        // u_n has one sign on the half-cell, that of sin 2πns.
        let (deciding, upper, sign) = match side {
            HalfCellSide::Plus => (n - inverse, 2 * m - 1, Negative),
            HalfCellSide::Minus => (inverse, 2 * m, Positive),
        };
        // The upper end is the root `upper`, the lower one the next, or −1 where there is none.
        let [inner, high] = chebyshev_roots(n, upper);
        let low = if upper + 1 == n { inner.clone() } else { chebyshev_roots(n, upper + 1)[0].clone() };
        let [c, r] = [0, 1].map(Polynomial::variable);
        let beyond = |bound: &BigRational| {
            &(&Polynomial::monomial(bound.denom().clone(), [0, 0]) * &c)
                - &Polynomial::monomial(bound.numer().clone(), [0, 0])
        };
        let given = vec![
            Atom(r.clone(), Positive),
            Atom(&Polynomial::from(1) - &r, NonNegative),
            Atom(beyond(&low), Positive),
            Atom(beyond(&high), Negative),
            Atom(in_c_and_r(&u, n - 1), sign),
        ];
        let all = quotients.iter().zip(1..).map(|(q, k)| Atom(in_c_and_r(q, k - 1), sign)).collect();
        let mut title = vec![
            title(&format!("all b_(n,k) > 0 iff b_(n,{deciding}) > 0, for 0 < r <= 1 and u_n {} 0", sign.symbol())),
            "a1 = 2rc, a2 = r^2, u_n = r^(n-1) U(c); b_(n,k) has the sign of u_n Q_k, Q_k = N_(n,k)/(1 - a1 + a2)".into(),
            format!("upper end: c = cos(pi {upper}/{n}), the only root of U between {inner} and {high}"),
        ];
        title.push(if upper + 1 == n {
            "lower end: c = -1".into()
        } else {
            format!("lower end: c = cos(pi {}/{n}), the only root of U between {low} and {inner}", upper + 1)
        });
        Ok(Sentence {
            title,
            names: ["c", "r"],
            given,
            claimed: vec![],
            equivalent: Some((all, deciding - 1)),
        })
    }

    /// The sentence as a formula or as a script for the tool: z3 and cvc5 answer `unsat` (of its negation) if
    /// it is true, QEPCAD `TRUE`.
    pub fn write(&self, format: Format) -> String {
        let atoms =
            |atoms: &[Atom]| atoms.iter().map(|atom| atom.write(format, self.names)).collect::<Vec<_>>();
        let mut claims = atoms(&self.claimed);
        if let Some((all, deciding)) = &self.equivalent {
            claims.push(format.iff(&format.and(&atoms(all)), &all[*deciding].write(format, self.names)));
        }
        let (given, claim) = (format.and(&atoms(&self.given)), format.and(&claims));
        let [x, y] = self.names;
        let body = match format {
            Format::Text => format!("for all real {x}, {y}:\n{given}\nimplies\n{claim}\n"),
            Format::Latex => {
                let [x, y] = self.names.map(super::print::latex_name);
                format.paragraphs(&format!(
                    "\\forall {x}, {y} \\in \\mathbf{{R}}:\n{given}\n\\implies {claim}\n"
                ))
            }
            Format::Sympy => format!(
                "from sympy import And, Equivalent, Implies, symbols\n\n{x}, {y} = symbols(\"{x} {y}\", real=True)\nsentence = Implies({given},\n{claim})\n"
            ),
            Format::Smtlib => {
                format!("{}(assert {given})\n(assert (not {claim}))\n(check-sat)\n", declarations(self.names))
            }
            Format::Qepcad => quantified(self.names, &format!("[ {given} ==> {claim} ]")),
        };
        format.comments(&self.title) + &body
    }
}

impl Format {
    fn and(self, parts: &[String]) -> String {
        let join = |joint: &str| match parts {
            [one] => one.clone(),
            _ => parts.join(joint),
        };
        match self {
            Format::Text => join("\n  and "),
            Format::Latex => join("\n\\land "),
            Format::Sympy => format!("And({})", parts.join(",\n  ")),
            Format::Smtlib => prefix("and", "true", parts),
            Format::Qepcad => format!("[ {} ]", join("\n  /\\ ")),
        }
    }

    fn iff(self, left: &str, right: &str) -> String {
        match self {
            Format::Text => format!("(( {left} )\n  iff {right})"),
            Format::Latex => format!("(( {left} )\n\\iff {right})"),
            Format::Sympy => format!("Equivalent({left},\n  {right})"),
            Format::Smtlib => format!("(= {left} {right})"),
            Format::Qepcad => format!("[ {left}\n  <==> {right} ]"),
        }
    }
}

impl Atom {
    fn write(&self, format: Format, names: [&str; 2]) -> String {
        let polynomial = format.polynomial(&self.0, names);
        match (format, self.1) {
            (Format::Smtlib, relation) => format!("({} {polynomial} 0)", relation.symbol()),
            (Format::Latex, NonNegative) => format!("{polynomial} \\ge 0"),
            (_, relation) => format!("{polynomial} {} 0", relation.symbol()),
        }
    }
}

impl Relation {
    fn symbol(self) -> &'static str {
        match self {
            Negative => "<",
            Positive => ">",
            NonNegative => ">=",
        }
    }
}

/// `polynomial` at a₁ = 2rc, a₂ = r², divided by r^`strip`, in the variables (c, r).
fn in_c_and_r(polynomial: &Polynomial, strip: usize) -> Polynomial {
    let term = |(&[i, j], coefficient): (&[u32; 2], &BigInt)| {
        let r = (i + 2 * j).checked_sub(strip as u32).expect("r^strip divides every term");
        Polynomial::monomial(coefficient << i, [i, r])
    };
    polynomial.terms().map(term).fold(Polynomial::default(), |sum, term| &sum + &term)
}

impl Display for Area {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Area::Region4 => f.write_str("region4"),
            Area::HalfCell { m, side: HalfCellSide::Plus } => write!(f, "{m}+"),
            Area::HalfCell { m, side: HalfCellSide::Minus } => write!(f, "{m}-"),
        }
    }
}

impl FromStr for Area {
    type Err = Error;
    fn from_str(name: &str) -> Result<Self> {
        let half_cell = |side: char| name.strip_suffix(side).and_then(|m| m.parse().ok());
        match (name, half_cell('+'), half_cell('-')) {
            ("region4", ..) => Ok(Area::Region4),
            (_, Some(m), _) => Ok(Area::HalfCell { m, side: HalfCellSide::Plus }),
            (_, _, Some(m)) => Ok(Area::HalfCell { m, side: HalfCellSide::Minus }),
            _ => Err(Error::input(format!(
                "{name:?} is not an area: write region4, or 3+ or 3- for a side of s = 3/n"
            ))),
        }
    }
}
