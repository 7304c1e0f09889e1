//! Progress on standard error, and the user's wish to end early.

use std::{
    io::IsTerminal,
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
    time::Duration,
};

use indicatif::{ProgressBar, ProgressStyle};

use crate::{
    error::{Error, Result},
    monitor::Monitor,
};

/// Whether the user has pressed Ctrl-C (or the system has asked the process to end).
#[derive(Debug, Clone, Default)]
pub struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Starts listening. The first signal asks for an orderly end; a second ends the process at once, with
    /// exit code 130.
    ///
    /// # Errors
    /// An I/O error if the system refuses.
    pub fn listen() -> Result<Self> {
        let interrupt = Interrupt::default();
        let flag = interrupt.0.clone();
        ctrlc::set_handler(move || {
            if flag.swap(true, Ordering::Relaxed) {
                std::process::exit(130);
            }
        })
        .map_err(|error| Error::from(std::io::Error::other(error)).context("cannot listen for Ctrl-C"))?;
        Ok(interrupt)
    }

    /// An interruption error once the user has asked for an end.
    ///
    /// # Errors
    /// The interruption.
    pub fn check(&self) -> Result<()> {
        if self.0.load(Ordering::Relaxed) {
            return Err(Error::interrupted("interrupted before the work was done"));
        }
        Ok(())
    }
}

/// A progress bar for one job, shown only on a terminal.
#[derive(Debug)]
pub struct Progress {
    bar: ProgressBar,
    interrupt: Interrupt,
}

impl Progress {
    /// A bar for `units` units named `unit` (as in "periods").
    pub fn new(interrupt: &Interrupt, units: u64, unit: &'static str) -> Self {
        let bar =
            if std::io::stderr().is_terminal() { ProgressBar::new(units) } else { ProgressBar::hidden() };
        let template = format!("{{bar:40}} {{human_pos}}/{{human_len}} {unit}, {{per_sec}}, {{eta}} left");
        bar.set_style(
            ProgressStyle::with_template(&template).unwrap_or_else(|_| ProgressStyle::default_bar()),
        );
        bar.enable_steady_tick(Duration::from_millis(200));
        Progress { bar, interrupt: interrupt.clone() }
    }
}

impl Monitor for Progress {
    fn advance(&self, units: u64) -> Result<()> {
        self.bar.inc(units);
        self.interrupt.check()
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
