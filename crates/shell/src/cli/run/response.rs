//! The files of tasks of kind `response`.

use super::Job;
use crate::{
    error::Result,
    figure,
    run::{PeakRow, ResponseFindings},
};

pub(super) fn keep(found: &ResponseFindings, job: &Job) -> Result<Vec<String>> {
    // The picture is in the unit in which the parameter is written, tables are in the scene's.
    let across = job.axis(&found.parameter);
    let (mut rows, mut peaks) = (found.rows.clone(), found.peaks.clone());
    let mut backbone = found.backbone.clone().unwrap_or_default();
    rows.iter_mut().for_each(|row| row.value = across.at(row.value));
    backbone.iter_mut().for_each(|row| row.value = across.at(row.value));
    for peak in &mut peaks {
        let PeakRow { value, lower, upper, .. } = peak;
        [Some(value), lower.as_mut(), upper.as_mut()].into_iter().flatten().for_each(|x| *x = across.at(*x));
    }
    figure::response(&rows, &peaks, &backbone, &across.name, &job.place())?;
    let picture = job.figure().into_iter().next();
    let mut files: Vec<String> = picture.into_iter().chain([job.csv(&found.rows, ".csv")?]).collect();
    files.push(job.csv(&found.peaks, "-peaks.csv")?);
    if let Some(backbone) = &found.backbone {
        files.push(job.csv(backbone, "-backbone.csv")?);
    }
    if let Some(sweep) = &found.sweep {
        files.push(job.csv(&sweep.jumps, "-jumps.csv")?);
    }
    Ok(files)
}
