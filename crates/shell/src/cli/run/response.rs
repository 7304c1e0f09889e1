//! The files of tasks of kind `response`.

use super::Job;
use crate::{error::Result, figure, run::ResponseFindings};

pub(super) fn keep(found: &ResponseFindings, job: &Job) -> Result<Vec<String>> {
    let backbone = found.backbone.as_deref().unwrap_or_default();
    figure::response(&found.rows, &found.peaks, backbone, &job.axis(&found.parameter), &job.place())?;
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
