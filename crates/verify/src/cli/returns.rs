//! `grazing word --returns`: first-return times to a line, and which points have them.

use std::cmp::Ordering;

use num_rational::BigRational;
use num_traits::One;

use super::Outcome;
use crate::{
    cli::progress::Interrupt,
    error::Result,
    local::{Forward, Ladder, Point},
    number::ball_digits,
    output::{Caption, Column, Destination, Setting, TableCell, TableFormat, TableWriter, say},
    word::{Extent, ReturnKind, Returns, Word, place},
};

/// Digits of p.
const DIGITS: u32 = 12;

/// Writes a row for each piece of the line. `at` names the point in LaTeX.
pub(super) fn run(
    forward: &Forward,
    at: &str,
    letters: usize,
    format: TableFormat,
    destination: &Destination,
    interrupt: &Interrupt,
) -> Result<Outcome> {
    let Forward { point, region, reversed } = forward;
    let word = Word::at(&Ladder::default(), point, true, letters, interrupt)?;
    let one = BigRational::one();
    let on_circle = match point {
        Point::Polar(polar) => polar.on_circle(),
        Point::Plane(plane) => *plane.a2() == one,
    };
    let modulus = match (reversed, on_circle) {
        (true, _) => Ordering::Greater,
        (false, true) => Ordering::Equal,
        (false, false) => Ordering::Less,
    };
    let returns = Returns::new(&word, *region, modulus)?;
    let columns = vec![
        Column::new("time", "time", 4),
        Column::new("place", "$m/n$", 7),
        Column::new("kind", "kind", 8),
        Column::new("from", "$p$ from", DIGITS as usize + 4),
        Column::new("to", "$p$ to", DIGITS as usize + 4),
    ];
    let caption = Caption {
        text: format!(
            "First-return times to the line $x_1 = -1$ of its points $(-1, p)$ at {at}: the time, the fraction that it \
             is the denominator of, and the $p$ that return then. The times D and U are periods of the word."
        ),
        label: "tab:returns".into(),
    };
    destination.list(|out| {
        let setting = Setting { caption: Some(&caption), ..Setting::default() };
        let mut table = TableWriter::set(out, format, "grazing-returns 1", columns, setting)?;
        let print = format.is_print();
        let rows = returns.pieces().iter().try_for_each(|piece| {
            let kind = match piece.kind {
                ReturnKind::Period(letter) => letter.to_string(),
                ReturnKind::Next => "next".to_string(),
                ReturnKind::Left => "left".to_string(),
                ReturnKind::Never => "never".to_string(),
            };
            let m_n = piece.time.map(|n| match piece.numerator {
                0 if print => "0".to_string(),
                m => format!("{m}/{n}"),
            });
            let number = |n: Option<u64>, infinite: &str| match n {
                None => infinite.to_string(),
                Some(n) => place(point, *reversed, n)
                    .and_then(|p| ball_digits(&p, DIGITS))
                    .unwrap_or_else(|| format!("p_{n}")),
            };
            let ends = [number(piece.ends[0], "-inf"), number(piece.ends[1], "inf")];
            let [from, to] = ends.map(|text| if print { text.replace("inf", "\\infty") } else { text });
            table.row(&[
                piece.time.map_or(TableCell::Empty, |n| TableCell::Int(n as i64)),
                m_n.as_deref()
                    .map_or(TableCell::Empty, if print { TableCell::Maths } else { TableCell::Text }),
                TableCell::Text(&kind),
                end(&from, print),
                end(&to, print),
            ])
        });
        table.end(rows)
    })?;
    if returns.is_whole() {
        return Ok(Outcome::Done);
    }
    let why = match word.extent() {
        Extent::Cut => format!("the word has more than {letters} letters: give a greater --letters"),
        _ => "a sign is zero or undecided".into(),
    };
    say(format_args!("note: the pieces in the middle are missing: {why}"));
    Ok(Outcome::Undecided)
}

/// An end; in print, where decimals are formulas by themselves, infinity is one too.
fn end(text: &str, print: bool) -> TableCell<'_> {
    if print && text.contains("infty") { TableCell::Maths(text) } else { TableCell::Text(text) }
}
