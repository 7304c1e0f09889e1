//! The files of tasks of kind `map`.

use super::Job;
use crate::{
    error::Result,
    figure::{self, Grid, ParameterMap},
    one::attractor::map::{MapCell, MapEnd},
    output::{Column, TableCell, TableFormat, TableWriter},
    run::{MapFindings, map_word},
};

/// Periods with a class of their own; all longer ones have one together.
const APART: u32 = 6;

/// Classes before those of periods.
const OTHERS: [&str; 3] = ["behind a stop", "it left every bound", "not periodic"];

/// The class of what was not decided, the last.
const NOT_SETTLED: usize = OTHERS.len() + APART as usize + 1;

pub(super) fn keep(found: &MapFindings, job: &Job) -> Result<Vec<String>> {
    let mut names: Vec<String> = OTHERS.map(String::from).to_vec();
    names.extend((1..=APART).map(|period| format!("period {period}")));
    names.push(format!("period above {APART}"));
    if found.cells.iter().any(|cell| cell.end == MapEnd::Unsettled) {
        names.push("not settled".into());
    }
    let [columns, rows] = &found.values;
    // The picture is in the units in which the parameters are written, the table is in the scene's.
    let axes = found.varied.each_ref().map(|parameter| job.axis(parameter));
    let [x, y] = [(columns, &axes[0]), (rows, &axes[1])]
        .map(|(values, axis)| values.iter().map(|value| axis.at(*value)).collect());
    let map = ParameterMap {
        ends: Grid { x, y, cells: found.cells.iter().map(class).collect(), names },
        exponents: found.cells.iter().map(|cell| cell.exponent).collect(),
    };
    figure::parameter_map(&map, axes.each_ref().map(|axis| axis.name.as_str()), &job.place())?;
    // Row by row: there may be many.
    job.write(&format!("{}.csv", job.task.name), |out| {
        let names = ["first", "second", "end", "period", "impacts", "exponent"];
        let columns_of = names.map(|name| Column::new(name, name, 0)).to_vec();
        let mut table = TableWriter::new(out, TableFormat::Csv, "", columns_of)?;
        for (i, cell) in found.cells.iter().enumerate() {
            let period = match cell.end {
                MapEnd::Periodic(period) => period.to_string(),
                _ => String::new(),
            };
            let (first, second) =
                (columns[i % columns.len()].to_string(), rows[i / columns.len()].to_string());
            let exponent = cell.exponent.map_or(String::new(), |exponent| exponent.to_string());
            let texts = [&first, &second, map_word(cell.end), &period, &cell.impacts.to_string(), &exponent];
            table.row(&texts.map(TableCell::Text))?;
        }
        table.finish()
    })?;
    Ok(job.figure())
}

fn class(cell: &MapCell) -> usize {
    match cell.end {
        MapEnd::BehindAWall => 0,
        MapEnd::Ended(_) => 1,
        MapEnd::NotPeriodic => 2,
        MapEnd::Unsettled => NOT_SETTLED,
        MapEnd::Periodic(period) => OTHERS.len() + period.min(APART + 1) as usize - 1,
    }
}
