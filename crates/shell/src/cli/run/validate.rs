//! The files of tasks of kind `validate`.

use super::Job;
use crate::{
    error::Result,
    run::{AttractorProofs, ValidateFindings},
};

/// The certificates, and a table of what is proved.
pub(super) fn keep(found: &ValidateFindings, job: &Job) -> Result<Vec<String>> {
    let mut files = job.certificates(&found.certificates)?;
    files.push(job.csv(&found.proofs, ".csv")?);
    Ok(files)
}

/// What is proved of attractors, if that was asked for.
pub(super) fn proofs(found: Option<&AttractorProofs>, job: &Job) -> Result<Vec<String>> {
    let Some(found) = found else { return Ok(Vec::new()) };
    let mut files = vec![job.csv(&found.rows, "-proofs.csv")?];
    files.extend(job.certificates(&found.certificates)?);
    Ok(files)
}
