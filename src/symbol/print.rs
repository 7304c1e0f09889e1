//! How polynomials are written, for a reader and for each tool.

use std::fmt::Write;

use num_bigint::{BigInt, Sign};
use num_traits::One;

use super::Polynomial;

/// Who is to read a formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Format {
    /// A person, in a terminal.
    Text,
    /// LaTeX, for a formula display.
    Latex,
    /// Python with sympy.
    Sympy,
    /// An SMT-LIB 2 script, for z3 or cvc5.
    Smtlib,
    /// The input of QEPCAD B.
    Qepcad,
}

impl Format {
    /// `lines` as comments; QEPCAD has room for one, the title in brackets.
    pub(super) fn comments(self, lines: &[String]) -> String {
        let each = |lead: &str| lines.iter().map(|line| format!("{lead}{line}\n")).collect();
        match self {
            Format::Text => each(""),
            Format::Latex => each("% "),
            Format::Sympy => each("# "),
            Format::Smtlib => each("; "),
            Format::Qepcad => format!("[ {} ]\n", lines.join("; ")),
        }
    }

    /// Lines of mathematics in LaTeX as paragraphs of their own, which TeX breaks at signs and between
    /// factors, and across pages; a line that begins with a blank or a joint is indented.
    pub(super) fn paragraphs(self, lines: &str) -> String {
        let mut text = String::from("{\\raggedright\\parindent=0pt\\binoppenalty=0\\relpenalty=0\n");
        for line in lines.lines() {
            let more = line.starts_with([' ', '\\']) && !line.starts_with("\\forall");
            let indent = if more { "\\hspace*{2em}" } else { "" };
            let _ = writeln!(text, "\\hangindent=4em {indent}${}$\\par", line.trim());
        }
        text + "}\n"
    }

    /// `polynomial` with its variables named.
    pub(super) fn polynomial(self, polynomial: &Polynomial, names: [&str; 2]) -> String {
        let terms = polynomial.terms();
        if self == Format::Smtlib {
            let terms: Vec<_> = terms.map(|(e, c)| prefix_term(*e, c, names)).collect();
            return prefix("+", "0", &terms);
        }
        let mut text = String::new();
        for (exponents, coefficient) in terms {
            let negative = coefficient.sign() == Sign::Minus;
            text += match (text.is_empty(), negative) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            text += &self.term(*exponents, coefficient.magnitude().clone().into(), names);
        }
        if text.is_empty() { "0".into() } else { text }
    }

    /// The product of `factors`, its sign in front.
    pub(super) fn product(self, negative: bool, factors: &[Polynomial], names: [&str; 2]) -> String {
        let written: Vec<_> = factors
            .iter()
            .map(|factor| {
                let text = self.polynomial(factor, names);
                let bare = self == Format::Smtlib || factor.terms().len() == 1;
                if bare { text } else { format!("({text})") }
            })
            .collect();
        match (self, negative) {
            (Format::Smtlib, false) => prefix("*", "1", &written),
            (Format::Smtlib, true) => format!("(- {})", prefix("*", "1", &written)),
            _ if written.is_empty() => format!("{}1", if negative { "-" } else { "" }),
            _ => {
                let joint = if self == Format::Latex { "\\allowbreak " } else { self.times() };
                format!("{}{}", if negative { "-" } else { "" }, written.join(joint))
            }
        }
    }

    fn times(self) -> &'static str {
        if matches!(self, Format::Text | Format::Sympy) { "*" } else { " " }
    }

    fn term(self, exponents: [u32; 2], coefficient: BigInt, names: [&str; 2]) -> String {
        let mut parts = Vec::new();
        if !coefficient.is_one() || exponents == [0, 0] {
            parts.push(coefficient.to_string());
        }
        for (exponent, name) in exponents.into_iter().zip(names) {
            let name = if self == Format::Latex { latex_name(name) } else { name.to_string() };
            match (exponent, self) {
                (0, _) => {}
                (1, _) => parts.push(name),
                (_, Format::Latex) => parts.push(format!("{name}^{{{exponent}}}")),
                (_, Format::Sympy) => parts.push(format!("{name}**{exponent}")),
                _ => parts.push(format!("{name}^{exponent}")),
            }
        }
        parts.join(self.times())
    }
}

/// `a1` as `a_1`, `r` as it is.
pub(super) fn latex_name(name: &str) -> String {
    let mut text = String::new();
    for c in name.chars() {
        let _ = if c.is_ascii_digit() { write!(text, "_{c}") } else { write!(text, "{c}") };
    }
    text
}

/// `(operator a b …)`, the one operand alone, or `empty`.
pub(super) fn prefix(operator: &str, empty: &str, operands: &[String]) -> String {
    match operands {
        [] => empty.into(),
        [one] => one.clone(),
        _ => format!("({operator} {})", operands.join(" ")),
    }
}

/// A term in SMT-LIB, which has neither powers nor negative literals.
fn prefix_term(exponents: [u32; 2], coefficient: &BigInt, names: [&str; 2]) -> String {
    let literal = match coefficient.sign() {
        Sign::Minus => format!("(- {})", coefficient.magnitude()),
        _ => coefficient.to_string(),
    };
    let powers = names.iter().zip(exponents).flat_map(|(name, e)| (0..e).map(|_| name.to_string()));
    let unit = coefficient.is_one() && exponents != [0, 0];
    let operands: Vec<_> = (!unit).then_some(literal).into_iter().chain(powers).collect();
    prefix("*", "1", &operands)
}
