//! Certificates of a report, by the files that they are kept in.

use serde::Serialize;

use crate::search::{Accepted, Claimed};

/// A certificate and the file that it is kept in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CertificateFile {
    /// The file's name.
    pub file: String,
    /// What the checker has accepted.
    pub accepted: Accepted,
}

/// What a report says of one: the checker's own words.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct FiledClaim<'a> {
    /// The file's name.
    file: &'a str,
    #[serde(flatten)]
    claim: Claimed<'a>,
}

impl CertificateFile {
    /// What is said of it.
    #[must_use]
    pub fn claim(&self) -> FiledClaim<'_> {
        FiledClaim { file: &self.file, claim: self.accepted.claim() }
    }
}
