//! The files of tasks of kind `chaos`.

use super::Job;
use crate::{error::Result, run::ChaosFindings};

/// The certificate, if there is one, and a table of the letters.
pub(super) fn keep(found: &ChaosFindings, job: &Job) -> Result<Vec<String>> {
    let mut files = job.certificates(&found.proof)?;
    files.push(job.csv(&found.letters, ".csv")?);
    Ok(files)
}
