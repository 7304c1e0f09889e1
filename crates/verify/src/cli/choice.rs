//! The library's choices as values of options: their words and what `--help` says of them. Those of the
//! command line itself are clap's.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use crate::{output::TableFormat, search::ProofMethod, symbol::Format};

/// What can be chosen by a word.
pub(super) trait Choice: Copy + Send + Sync + 'static {
    /// All, each with its word and its meaning.
    const ALL: &'static [(Self, &'static str, &'static str)];

    /// The word for it.
    fn word(self) -> &'static str
    where
        Self: PartialEq,
    {
        Self::ALL.iter().find(|known| known.0 == self).map_or("", |known| known.1)
    }
}

impl Choice for TableFormat {
    const ALL: &'static [(Self, &'static str, &'static str)] = &[
        (TableFormat::Table, "table", "Aligned columns, for reading"),
        (TableFormat::Csv, "csv", "Comma-separated values with a header"),
        (TableFormat::Json, "json", "One object with a format name and an array of rows"),
        (TableFormat::Latex, "latex", "A longtable with booktabs rules"),
        (TableFormat::LatexSiunitx, "latex-siunitx", "The same with the numbers in siunitx's \\num"),
        (TableFormat::Markdown, "markdown", "A Markdown table"),
    ];
}

impl Choice for ProofMethod {
    const ALL: &'static [(Self, &'static str, &'static str)] = &[
        (ProofMethod::Exact, "exact", "At every zero and pole and just right of it, by integer arithmetic"),
        (ProofMethod::Interval, "interval", "On whole stretches, by enclosures of the arguments"),
        (
            ProofMethod::Both,
            "both",
            "By both, which must agree; the pieces counted are those of the exact method",
        ),
    ];
}

impl Choice for Format {
    const ALL: &'static [(Self, &'static str, &'static str)] = &[
        (Format::Text, "text", "A person, in a terminal"),
        (Format::Latex, "latex", "LaTeX, for a formula display"),
        (Format::Sympy, "sympy", "Python with sympy"),
        (Format::Smtlib, "smtlib", "An SMT-LIB 2 script, for z3 or cvc5"),
        (Format::Qepcad, "qepcad", "The input of QEPCAD B"),
    ];
}

/// Reads one by its word.
pub(super) fn choice<T: Choice>() -> impl TypedValueParser<Value = T> {
    let values = T::ALL.iter().map(|&(_, word, meaning)| PossibleValue::new(word).help(meaning));
    PossibleValuesParser::new(values).map(|given| {
        let known = T::ALL.iter().find(|(_, word, _)| *word == given);
        known.unwrap_or_else(|| unreachable!("clap lets no other word pass")).0
    })
}
