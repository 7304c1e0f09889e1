//! Text as LaTeX and Markdown need it. What is mathematics already (headings such as `$b_{n,k}$`) does not
//! come here.

use crate::printable::Printable;

/// `text` so that LaTeX sets it as it reads, in text mode: the ten special characters escaped, the Greek
/// letters, signs and small digits of this project in maths mode. A character that pdflatex does not know by
/// these is written as its code point, `U+1F600`. Cost: linear in the length of `text`.
pub fn latex(text: &str) -> String {
    let mut all = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        match c {
            '\\' => all.push_str("\\textbackslash{}"),
            '{' | '}' | '$' | '&' | '#' | '_' | '%' => all.extend(['\\', c]),
            '^' => all.push_str("\\textasciicircum{}"),
            '~' => all.push_str("\\textasciitilde{}"),
            '<' | '>' | '|' => all.extend(['$', c, '$']),
            // Not \textquotedbl, which the default font encoding lacks.
            '"' => all.push_str("{\\ttfamily\\char34}"),
            ' '..='~' => all.push(c),
            '\n' | '\t' => all.push(' '),
            '\u{c0}'..='\u{17f}' if !matches!(c, '×' | '÷') => all.push(c),
            _ => match symbol(c) {
                Some(maths) => all.extend(["$", maths, "$"]),
                None => all.push_str(&format!("U+{:04X}", u32::from(c))),
            },
        }
    }
    all
}

/// `text` as [`latex`] writes it, or in maths mode where it is a decimal number: a minus that is no hyphen,
/// and `1.5e-30` as 1.5·10⁻³⁰. No digit is changed.
pub fn latex_cell(text: &str) -> String {
    match text.split_once(['e', 'E']) {
        _ if !is_decimal(text) => latex(text),
        Some((digits, exponent)) => format!("${digits}\\cdot10^{{{}}}$", exponent.trim_start_matches('+')),
        None => format!("${text}$"),
    }
}

/// Whether `text` is a decimal number, perhaps with an exponent.
pub fn is_decimal(text: &str) -> bool {
    text.parse::<f64>().is_ok() && text.bytes().any(|byte| byte.is_ascii_digit())
}

/// Decimal numbers with commas between, real or complex, in maths mode, where lines may break after every
/// ten digits of a number of more than 24; any other text as [`latex`] writes it. No digit is changed.
pub fn latex_numbers(text: &str) -> String {
    let each: Option<Vec<String>> = text.split(", ").map(number).collect();
    each.map_or_else(|| latex(text), |all| format!("${}$", all.join(",\\allowbreak\\ ")))
}

/// A number in maths mode, without the dollars.
fn number(text: &str) -> Option<String> {
    if let Some((real, imaginary)) = text.strip_suffix('i').and_then(|pair| pair.rsplit_once([' '])) {
        let (real, sign) = real.rsplit_once(' ')?;
        return Some(format!("{} {sign} {}\\,\\mathrm{{i}}", number(real)?, number(imaginary)?));
    }
    let finite = text.parse::<f64>().is_ok_and(f64::is_finite);
    if !finite {
        return None;
    }
    let (digits, exponent) = text.split_once(['e', 'E']).unwrap_or((text, ""));
    let mut all = String::new();
    let whole = digits.find('.').unwrap_or(digits.len());
    for (at, c) in digits.char_indices() {
        if digits.len() > 26 && at > whole + 1 && (at - whole - 1).is_multiple_of(10) {
            all.push_str("\\allowbreak ");
        }
        all.push(c);
    }
    if !exponent.is_empty() {
        all += &format!("\\cdot10^{{{}}}", exponent.trim_start_matches('+'));
    }
    Some(all)
}

/// `text` as one cell of a Markdown table: bars and what would begin HTML escaped, line ends as spaces.
pub fn markdown(text: &str) -> String {
    let text = Printable(&text.replace(['\n', '\r'], " ")).to_string();
    let mut all = String::with_capacity(text.len());
    for (at, c) in text.char_indices() {
        let begins = |next: char| next.is_ascii_alphabetic() || "/!?".contains(next);
        match c {
            '\\' | '|' => all.extend(['\\', c]),
            '<' if text[at + 1..].starts_with(begins) => all.push_str("&lt;"),
            c => all.push(c),
        }
    }
    all
}

fn symbol(c: char) -> Option<&'static str> {
    const SYMBOLS: &[(char, &str)] = &[
        ('µ', "\\mu"),
        ('μ', "\\mu"),
        ('α', "\\alpha"),
        ('β', "\\beta"),
        ('γ', "\\gamma"),
        ('δ', "\\delta"),
        ('ε', "\\varepsilon"),
        ('κ', "\\kappa"),
        ('λ', "\\lambda"),
        ('Λ', "\\Lambda"),
        ('ν', "\\nu"),
        ('π', "\\pi"),
        ('ρ', "\\rho"),
        ('σ', "\\sigma"),
        ('Σ', "\\Sigma"),
        ('τ', "\\tau"),
        ('φ', "\\varphi"),
        ('ω', "\\omega"),
        ('−', "-"),
        ('±', "\\pm"),
        ('×', "\\times"),
        ('÷', "\\div"),
        ('·', "\\cdot"),
        ('≤', "\\le"),
        ('≥', "\\ge"),
        ('≠', "\\ne"),
        ('≈', "\\approx"),
        ('→', "\\to"),
        ('∞', "\\infty"),
        ('∈', "\\in"),
        ('∂', "\\partial"),
        ('√', "\\sqrt{\\ }"),
        ('½', "\\frac12"),
        ('…', "\\ldots"),
        ('′', "'"),
        ('″', "''"),
        ('°', "^\\circ"),
        ('⁺', "^+"),
        ('⁻', "^-"),
        ('₊', "_+"),
        ('₋', "_-"),
        ('ⁿ', "^n"),
        ('ₙ', "_n"),
        ('ₖ', "_k"),
    ];
    const UP: [(char, &str); 10] = [
        ('⁰', "^0"),
        ('¹', "^1"),
        ('²', "^2"),
        ('³', "^3"),
        ('⁴', "^4"),
        ('⁵', "^5"),
        ('⁶', "^6"),
        ('⁷', "^7"),
        ('⁸', "^8"),
        ('⁹', "^9"),
    ];
    const DOWN: [(char, &str); 10] = [
        ('₀', "_0"),
        ('₁', "_1"),
        ('₂', "_2"),
        ('₃', "_3"),
        ('₄', "_4"),
        ('₅', "_5"),
        ('₆', "_6"),
        ('₇', "_7"),
        ('₈', "_8"),
        ('₉', "_9"),
    ];
    [SYMBOLS, &UP, &DOWN].concat().into_iter().find(|&(known, _)| known == c).map(|(_, maths)| maths)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_special_character_is_escaped() {
        assert_eq!(
            latex(r"a_1 & 50% #2 {x} $y$ c^2 ~ \z"),
            r"a\_1 \& 50\% \#2 \{x\} \$y\$ c\textasciicircum{}2 \textasciitilde{} \textbackslash{}z"
        );
        assert_eq!(latex("|a1| < 2"), "$|$a1$|$ $<$ 2");
        assert_eq!(latex("µ ≥ λ²"), r"$\mu$ $\ge$ $\lambda$$^2$");
        assert_eq!(latex("é"), "é");
        assert_eq!(latex("\u{1f600}"), "U+1F600");
    }

    #[test]
    fn numbers_are_set_as_numbers() {
        assert_eq!(latex_cell("-0.250"), "$-0.250$");
        assert_eq!(latex_cell("1.5e-30"), "$1.5\\cdot10^{-30}$");
        assert_eq!(latex_cell("-1e+9"), "$-1\\cdot10^{9}$");
        assert_eq!(latex_cell("inf"), "inf");
        assert_eq!(latex_cell("e"), "e");
    }

    #[test]
    fn a_bar_ends_no_cell() {
        assert_eq!(markdown("|a1| < \\ 2\n"), "\\|a1\\| < \\\\ 2 ");
        assert_eq!(markdown("<b>\u{1b}</b> n<3"), "&lt;b>\\\\u{1b}&lt;/b> n<3");
    }
}
