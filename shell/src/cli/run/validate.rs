//! The files of tasks of kind `validate`.

use super::Job;
use crate::{error::Result, run::ValidateFindings};

/// The certificates, and a table of what is proved.
pub(super) fn keep(found: &ValidateFindings, job: &Job) -> Result<Vec<String>> {
    let mut files = Vec::new();
    for (file, text) in &found.certificates {
        job.write(file, |out| Ok(out.write_all(text.as_bytes())?))?;
        files.push(file.clone());
    }
    files.push(job.csv(&found.proofs, ".csv")?);
    Ok(files)
}
