//! Certificates in the caption of a LaTeX table: checked first, then named by their SHA-256.

use std::path::{Path, PathBuf};

use super::{
    Outcome,
    check::{hashed, outcome},
    progress::Interrupt,
    range::Periods,
};
use crate::{
    certificate::{Rejection, Sha256},
    error::{Error, Result},
    output::{Caption, FileRegistry, latex, say},
};

/// A kind of certificate that a table can rest on.
pub(super) struct Basis {
    /// As in its header.
    pub kind: &'static str,
    /// What of the table it proves, in LaTeX, without the stop.
    pub proves: &'static str,
    /// The command that writes one.
    pub command: &'static str,
}

/// Names the certificates among the command's files.
///
/// # Errors
/// An input error if one is an output too.
pub(super) fn named(files: &[PathBuf], registry: &FileRegistry) -> Result<()> {
    files.iter().try_for_each(|file| registry.read("--cite", file))
}

/// The caption of a table of `periods` that cites `files`, or what keeps one of them from being cited, which
/// is said. `about` says what the table shows, in LaTeX; `bases` what it can rest on. Cost: that of checking
/// the files.
///
/// # Errors
/// A certificate of another kind, or one that leaves out some of the periods.
pub(super) fn caption(
    files: &[PathBuf],
    (name, about, bases): (&str, &str, &[Basis]),
    periods: &Periods,
    interrupt: &Interrupt,
) -> Result<std::result::Result<Caption, Outcome>> {
    let (first, last) = (*periods.0.start(), *periods.0.end());
    let mut text = about.to_owned();
    let mut cited: Vec<&str> = Vec::new();
    for path in files {
        let shown = path.display();
        let (checked, sha256) = match hashed(path, interrupt) {
            Ok(found) => found,
            Err(Rejection::Interrupted { .. }) => {
                return Err(Error::interrupted(format!("while {shown} was checked")));
            }
            Err(rejection) => {
                let outcome = outcome(path, &rejection);
                if outcome != Outcome::Failed {
                    let verdict = rejection.verdict();
                    say(format_args!("error: {shown} cannot be cited: {verdict}: {rejection}"));
                }
                return Ok(Err(outcome));
            }
        };
        let basis = bases.iter().find(|basis| basis.kind == checked.kind);
        let (Some(basis), Some(range)) = (basis, checked.range) else {
            let kinds: Vec<&str> = bases.iter().map(|basis| basis.kind).collect();
            return Err(Error::input(format!(
                "{shown} is of kind {}, which proves nothing of this table: cite one of kind {}",
                checked.kind,
                kinds.join(" or ")
            )));
        };
        if cited.contains(&basis.kind) {
            return Err(Error::input(format!("{shown} is the second of kind {}: cite one", basis.kind)));
        }
        cited.push(basis.kind);
        let (from, to) = range.into_inner();
        if first < from || last > to {
            return Err(Error::input(format!(
                "{shown} proves n = {from}..={to}, and the table has {first}..={last}: list {}..={}, or cite what \
                 `{} {first}..={last} --certificate FILE` writes",
                first.clamp(from, to),
                last.clamp(from, to),
                basis.command
            )));
        }
        let file = path.file_name().map_or_else(|| shown.to_string(), |name| name.to_string_lossy().into());
        let named = if file == "-" { String::new() } else { format!(" \\texttt{{{}}}", latex(&file)) };
        text += &format!(
            " {} (certificate{named} of kind {}, $n = {from}, \\dots, {to}$, SHA-256 {}).",
            basis.proves,
            latex(basis.kind),
            digest(&sha256)
        );
    }
    Ok(Ok(Caption { text, label: label(name, periods) }))
}

/// That of a table which cites nothing.
pub(super) fn plain(name: &str, about: &str, periods: &Periods) -> Caption {
    Caption { text: about.to_owned(), label: label(name, periods) }
}

/// What `\\ref` finds a table of these periods by.
pub(super) fn label(name: &str, periods: &Periods) -> String {
    let (first, last) = (periods.0.start(), periods.0.end());
    if first == last { format!("tab:{name}-{first}") } else { format!("tab:{name}-{first}-{last}") }
}

/// A certificate that this command writes, by its file's name and the SHA-256 of its text.
pub fn written(path: &Path, text: &str) -> String {
    let file =
        path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into());
    let mut hash = Sha256::default();
    hash.update(text.as_bytes());
    format!("\\texttt{{{}}}, SHA-256 {}", latex(&file), digest(&hash.finish()))
}

/// A digest that a line may break.
pub(super) fn digest(sha256: &str) -> String {
    let parts: Vec<&str> = (0..sha256.len()).step_by(8).map(|i| &sha256[i..i + 8]).collect();
    format!("\\texttt{{{}}}", parts.join("\\allowbreak "))
}
