//! Samples over time, from a text with two columns among others.

use crate::typed::in_number;

/// A line of the file, a time and a value.
pub type SampleLine = (usize, f64, f64);
/// What is wrong and in which line.
pub type WrongLine = (usize, String);

/// Most samples.
const SAMPLES: usize = 100_000;

/// Which columns hold the times and the values.
#[derive(Debug, Clone, Copy)]
pub struct SampleColumns {
    /// The column of the times, from 0.
    pub time: usize,
    /// That of the values.
    pub value: usize,
    /// Whether the first line names the columns, and is not a sample itself.
    pub named: bool,
}

/// The samples of a text, by time. `columns` chooses from the cells of the first line, in lower case; `#`
/// begins a comment, and lines without anything are left out. Cells are separated by semicolons, commas or
/// tabs, whatever of these is in the first line first, or else by blanks.
///
/// # Errors
/// What is wrong in which line: what `columns` says, another number of cells, what is no finite number, times
/// that do not rise, fewer than 3 samples or more than 100000.
pub fn samples(
    text: &str,
    columns: &dyn Fn(&[String]) -> Result<SampleColumns, String>,
) -> Result<Vec<SampleLine>, WrongLine> {
    let text = text.trim_start_matches('\u{feff}');
    let mut lines = (1..)
        .zip(text.lines())
        .map(|(line, content)| (line, content.trim()))
        .filter(|(_, content)| !content.is_empty() && !content.starts_with('#'))
        .peekable();
    let &(line, head) =
        lines.peek().ok_or((1, "holds no samples: two columns are needed, times and values".into()))?;
    let separator = [';', ',', '\t'].into_iter().find(|c| head.contains(*c));
    let cells = |content: &str| -> Vec<String> {
        let bare = |cell: &str| cell.trim().trim_matches('"').to_string();
        match separator {
            Some(separator) => content.split(separator).map(bare).collect(),
            None => content.split_whitespace().map(bare).collect(),
        }
    };
    let names: Vec<String> = cells(head).iter().map(|name| name.to_lowercase()).collect();
    let SampleColumns { time, value, named } = columns(&names).map_err(|message| (line, message))?;
    if named {
        lines.next();
    }
    let mut all: Vec<SampleLine> = Vec::new();
    for (line, content) in lines {
        let cells = cells(content);
        if cells.len() != names.len() {
            return Err((line, format!("has {} cells; the first line has {}", cells.len(), names.len())));
        }
        let number = |place: usize| {
            let value = cells[place].parse::<f64>().ok().filter(|value| value.is_finite());
            value.ok_or_else(|| {
                let what = format!("{:?} is not a finite number, written with a point", cells[place]);
                let begins = cells[place].starts_with(|c: char| c.is_ascii_digit());
                let meant = match in_number(&cells[place]) {
                    Some(meant) if begins => meant,
                    _ if begins => "write the number alone, its unit into the first line".to_string(),
                    _ => "take the line out".to_string(),
                };
                (line, format!("{what}: {meant}"))
            })
        };
        let (t, x) = (number(time)?, number(value)?);
        if let Some(&(before, last, _)) = all.last()
            && t <= last
        {
            let message = if t == last {
                format!("the time {t} stands in line {before}, too: keep one of them")
            } else {
                format!("the time {t} is before that of line {before}, {last}: sort the lines by time")
            };
            return Err((line, message));
        }
        if all.len() == SAMPLES {
            return Err((line, format!("more than {SAMPLES} samples: take fewer")));
        }
        all.push((line, t, x));
    }
    if all.len() < 3 {
        return Err((line, format!("has {} samples: at least 3 are needed", all.len())));
    }
    Ok(all)
}
