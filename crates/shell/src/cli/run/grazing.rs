//! The files of tasks of kind `grazing`.

use super::{Job, validate::proofs};
use crate::{error::Result, run::GrazingReport};

/// What is born and how far that is proved to go on, what is seen and what is proved of that.
pub(super) fn keep(found: &GrazingReport, job: &Job) -> Result<Vec<String>> {
    let mut files = vec![job.csv(&found.born, ".csv")?];
    files.extend(job.certificates(&found.certificates)?);
    if let Some(touches) = &found.touches {
        files.push(job.csv(touches, "-touches.csv")?);
    }
    if let Some(seen) = &found.seen {
        files.push(job.csv(seen, "-seen.csv")?);
    }
    if let Some(bands) = &found.bands {
        files.push(job.csv(bands, "-bands.csv")?);
    }
    if let Some(hits) = &found.hits {
        files.push(job.csv(hits, "-hits.csv")?);
    }
    if let Some(influence) = &found.influence {
        files.push(job.csv(influence, "-influence.csv")?);
    }
    files.extend(proofs(found.proofs.as_ref(), job)?);
    Ok(files)
}
