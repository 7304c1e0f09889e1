//! How a long job tells its caller how far it is, and hears that it should end.

use std::{fmt::Display, sync::Arc};

use crate::{error::Result, processor::Stopwatch, profile::Profile};

/// Told of progress by long jobs, between independent units of work and from any thread.
pub trait Monitor: Sync {
    /// A stretch of work of that many units begins, named as in "periods". By default nothing.
    fn begin(&self, _units: u64, _unit: &'static str) {}

    /// Something that the user should know happened, and the work goes on. By default nothing.
    fn note(&self, _what: &str) {}

    /// Where to add up which method decided how much and how long it took; nothing is timed without one. By
    /// default none.
    fn profile(&self) -> Option<Arc<Profile>> {
        None
    }

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

/// Does one case, and adds its time to the monitor's profile, if there is one, as that of a method.
pub fn timed<R>(monitor: &dyn Monitor, method: impl Display, work: impl FnOnce() -> R) -> R {
    let Some(profile) = monitor.profile() else { return work() };
    let start = Stopwatch::start();
    let found = work();
    profile.since(start, method, 1);
    found
}
