//! How a long job tells its caller how far it is, and hears that it should end.

use crate::error::Result;

/// Told of progress by long jobs, between independent units of work and from any thread.
pub trait Monitor: Sync {
    /// A stretch of work of that many units begins, named as in "periods". By default nothing.
    fn begin(&self, _units: u64, _unit: &'static str) {}

    /// Something that the user should know happened, and the work goes on. By default nothing.
    fn note(&self, _what: &str) {}

    /// `units` more are done.
    ///
    /// # Errors
    /// An interruption, if the job should end now; the job passes it on.
    fn advance(&self, units: u64) -> Result<()>;
}

/// Listens to nothing and never interrupts.
impl Monitor for () {
    fn advance(&self, _: u64) -> Result<()> {
        Ok(())
    }
}
