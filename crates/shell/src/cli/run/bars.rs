//! The progress bar of the task that is running.

use std::sync::{Arc, PoisonError, RwLock};

use crate::{
    cli::progress::{Interrupt, Progress},
    error::Result,
    monitor::Monitor,
    output::say,
    profile::Profile,
};

/// A bar for the stretch of work that began last.
pub(super) struct Bars<'a> {
    interrupt: &'a Interrupt,
    bar: RwLock<Option<Progress>>,
}

impl<'a> Bars<'a> {
    pub fn new(interrupt: &'a Interrupt) -> Self {
        Bars { interrupt, bar: RwLock::new(None) }
    }

    /// Takes the bar off the screen.
    pub fn clear(&self) {
        *self.bar.write().unwrap_or_else(PoisonError::into_inner) = None;
    }
}

impl Monitor for Bars<'_> {
    fn begin(&self, units: u64, unit: &'static str) {
        self.clear();
        *self.bar.write().unwrap_or_else(PoisonError::into_inner) =
            Some(Progress::new(self.interrupt, units, unit));
    }

    fn note(&self, what: &str) {
        say(format_args!("note: {what}"));
    }

    fn profile(&self) -> Option<Arc<Profile>> {
        self.interrupt.profile()
    }

    fn advance(&self, units: u64) -> Result<()> {
        if let Some(bar) = &*self.bar.read().unwrap_or_else(PoisonError::into_inner)
            && units > 0
        {
            return bar.advance(units);
        }
        self.interrupt.check()
    }
}
