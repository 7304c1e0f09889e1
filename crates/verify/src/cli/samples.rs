//! Samples of machines, or of points, from a CSV: `word --samples`.

use std::path::Path;

use num_rational::BigRational;

use super::place::Bounds;
use crate::{
    error::{Error, Result},
    number::parse_rational,
    output::{FileRegistry, read_text},
    tolerance::ParameterBox,
};

/// The longest file, in bytes.
const LONGEST: u64 = 1 << 26;
/// The columns that make a sample; others are not read.
const COLUMNS: [&[&str]; 4] =
    [&["frequency", "damping_ratio", "drive"], &["ratio", "damping_ratio"], &["r", "s"], &["a1", "a2"]];

/// The samples, each a box of one point, and the bounds of all of them.
pub(super) fn read(file: &Path, files: &FileRegistry) -> Result<(Vec<ParameterBox>, Bounds)> {
    files.read("--samples", file)?;
    let name = file.display();
    let wrong = |error: csv::Error| Error::input(format!("{name}: {error}"));
    let text = read_text(file, LONGEST)?;
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
    let header = reader.headers().map_err(wrong)?.clone();
    let place = |column: &str| header.iter().position(|name| name == column);
    let known = COLUMNS.iter().find_map(|columns| {
        columns.iter().map(|column| place(column)).collect::<Option<Vec<usize>>>().map(|at| (*columns, at))
    });
    let Some((columns, at)) = known else {
        let known = COLUMNS.map(|columns| columns.join(",")).join("; ");
        return Err(Error::input(format!(
            "{name}: the first line names the columns, one of these sets: {known}"
        )));
    };
    let (names, of): (_, fn(_, _) -> _) = match columns[0] {
        "r" => (["r", "s"], ParameterBox::polar),
        "a1" => (["a1", "a2"], ParameterBox::plane),
        _ => (["ratio", "damping_ratio"], ParameterBox::machine),
    };
    let mut samples = Vec::new();
    let mut hull: Option<[[BigRational; 2]; 2]> = None;
    for (index, row) in reader.records().enumerate() {
        let row = row.map_err(wrong)?;
        let in_row = |error: Error| error.context(format!("{name}, sample {}", index + 1));
        let values: Vec<BigRational> = at
            .iter()
            .map(|&i| parse_rational(row.get(i).unwrap_or_default()).map_err(Error::from))
            .collect::<Result<_>>()
            .map_err(in_row)?;
        let point = sample(columns[0], &values).map_err(in_row)?;
        let [first, second] = point.each_ref().map(|x| [x.clone(), x.clone()]);
        samples.push(of(first, second).map_err(in_row)?);
        match &mut hull {
            None => hull = Some(point.map(|x| [x.clone(), x])),
            Some(hull) => {
                for ([lower, upper], x) in hull.iter_mut().zip(point) {
                    if x < *lower {
                        *lower = x;
                    } else if x > *upper {
                        *upper = x;
                    }
                }
            }
        }
    }
    let [first, second] = hull.ok_or_else(|| Error::input(format!("{name}: no samples")))?;
    Ok((samples, [(names[0], first), (names[1], second)]))
}

/// The two coordinates of a sample.
fn sample(first: &str, values: &[BigRational]) -> Result<[BigRational; 2]> {
    let ratio = match (first, values) {
        ("frequency", [_, _, drive]) if *drive <= BigRational::from_integer(0.into()) => {
            return Err(Error::input(format!("a drive of {drive}: above 0")));
        }
        ("frequency", [natural, _, drive]) => natural / drive,
        _ => values[0].clone(),
    };
    Ok([ratio, values[1].clone()])
}
