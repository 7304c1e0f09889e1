//! `--profile`: where a command's time went, as a table.

use crate::{
    error::Result,
    output::{Column, OutputFile, TableCell, TableFormat, TableWriter},
    profile::Profile,
};

/// Writes the table, the slowest method first.
///
/// # Errors
/// An I/O error.
pub(super) fn write_profile(file: &OutputFile, profile: &Profile) -> Result<()> {
    let (total, mut rows) = (profile.total(), profile.rows());
    rows.sort_by_key(|(_, spent)| std::cmp::Reverse(spent.time));
    let columns = ["method", "cases", "time_ns", "of_cases", "of_time"];
    let columns = columns.map(|name| Column::new(name, name, name.len())).to_vec();
    file.write(|out| {
        let mut table = TableWriter::new(out, TableFormat::Csv, "grazing-profile 1", columns)?;
        for (method, spent) in &rows {
            let share = |part: f64, all: f64| format!("{:.4}", if all > 0.0 { part / all } else { 0.0 });
            table.row(&[
                TableCell::Text(method),
                TableCell::Int(spent.cases as i64),
                TableCell::Int(spent.time.as_nanos() as i64),
                TableCell::Text(&share(spent.cases as f64, total.cases as f64)),
                TableCell::Text(&share(spent.time.as_secs_f64(), total.time.as_secs_f64())),
            ])?;
        }
        table.finish()
    })
}
