//! The files of tasks of kind `validate`.

use super::Job;
use crate::{error::Result, run::ValidateFindings};

/// The certificates, and a table of what is proved.
pub(super) fn keep(found: &ValidateFindings, job: &Job) -> Result<Vec<String>> {
    let mut files = job.certificates(&found.certificates)?;
    files.push(job.csv(&found.proofs, ".csv")?);
    Ok(files)
}
