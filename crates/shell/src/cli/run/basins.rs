//! The files of tasks of kind `basins`.

use super::Job;
use crate::{
    error::Result,
    figure::{self, Grid},
    run::{BasinRow, BasinsFindings},
};

pub(super) fn keep(found: &BasinsFindings, job: &Job) -> Result<Vec<String>> {
    let frame = &found.grid;
    let x = (0..frame.columns).map(|column| frame.start(column, 0)[0]).collect();
    let y = (0..frame.rows).map(|row| frame.start(0, row)[1]).collect();
    // The picture's first three classes are not attractors.
    let others = ["behind-a-stop", "escaped", "not-periodic", "impact-limit", "not-smooth", "too-steep"];
    let place = |basin: &BasinRow| others.iter().position(|other| *other == basin.end);
    let mut names: Vec<String> =
        ["behind a stop", "it left every bound", "not periodic"].map(String::from).to_vec();
    let classes: Vec<usize> = found
        .basins
        .iter()
        .map(|basin| match place(basin) {
            Some(class) if class < 3 => class,
            _ => {
                names.push(name(basin));
                names.len() - 1
            }
        })
        .collect();
    let cells = found.cells.iter().map(|&cell| classes[cell]).collect();
    let plane = found.plane.as_ref();
    let axes = plane.map_or(["q", "u"], |[first, second]| [first, second]);
    figure::grid(&Grid { x, y, cells, names }, axes, &job.place())?;
    Ok(job.figure())
}

fn name(basin: &BasinRow) -> String {
    match (basin.period, basin.impacts) {
        (Some(period), Some(impacts)) => {
            let plural = if impacts == 1 { "" } else { "s" };
            format!("period {period}, {impacts} impact{plural}")
        }
        _ => basin.end.replace('-', " "),
    }
}
