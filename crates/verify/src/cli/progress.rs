//! Progress on standard error, and the user's wish to end early.

use std::{
    fmt,
    io::IsTerminal,
    sync::{
        Arc, Mutex, OnceLock, PoisonError,
        atomic::{AtomicBool, Ordering},
    },
    time::Duration,
};

use indicatif::{ProgressBar, ProgressStyle};

use crate::{
    error::{Error, Result},
    monitor::Monitor,
    outcome::Outcome,
    output::remove_temporaries,
    profile::Profile,
};

/// Whether the user has pressed Ctrl-C (or the system has asked the process to end).
#[derive(Debug, Clone, Default)]
pub struct Interrupt(Arc<Inner>);

#[derive(Default)]
struct Inner {
    asked: AtomicBool,
    without_bars: AtomicBool,
    kept: Mutex<String>,
    profile: OnceLock<Arc<Profile>>,
    last: Mutex<Option<LastWords>>,
}

/// Gives a report in JSON, and how it counts.
type LastWords = Box<dyn Fn() -> (String, Outcome) + Send>;

impl fmt::Debug for Inner {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Inner").field("asked", &self.asked).field("kept", &self.kept).finish_non_exhaustive()
    }
}

impl Interrupt {
    /// Starts listening. The first signal asks for an orderly end and calls `heard`; a second ends the
    /// process at once, with exit code 130.
    ///
    /// # Errors
    /// An I/O error if the system refuses.
    pub fn listen(heard: impl Fn() + Send + 'static) -> Result<Self> {
        let interrupt = Interrupt::default();
        let inner = interrupt.0.clone();
        ctrlc::set_handler(move || {
            if inner.asked.swap(true, Ordering::Relaxed) {
                remove_temporaries();
                std::process::exit(130);
            }
            heard();
        })
        .map_err(|error| Error::from(std::io::Error::other(error)).context("cannot listen for Ctrl-C"))?;
        Ok(interrupt)
    }

    /// An interruption error once the user has asked for an end.
    ///
    /// # Errors
    /// The interruption.
    pub fn check(&self) -> Result<()> {
        if self.asked() { Err(self.error()) } else { Ok(()) }
    }

    /// Whether the user has asked for an end.
    pub fn asked(&self) -> bool {
        self.0.asked.load(Ordering::Relaxed)
    }

    /// Shows no progress bars from here on.
    pub fn without_bars(&self) {
        self.0.without_bars.store(true, Ordering::Relaxed);
    }

    /// Has the time of each method added up from here on.
    pub fn keep_profile(&self) -> Arc<Profile> {
        self.0.profile.get_or_init(Arc::default).clone()
    }

    /// Says what is kept of the work, and how to go on from it: an interruption ends with these words.
    pub fn keeps(&self, what: impl Into<String>) {
        *self.0.kept.lock().unwrap_or_else(PoisonError::into_inner) = what.into();
    }

    /// Says how a command reports in JSON, should the process have to end without it.
    pub fn says_last(&self, report: impl Fn() -> (String, Outcome) + Send + 'static) {
        *self.0.last.lock().unwrap_or_else(PoisonError::into_inner) = Some(Box::new(report));
    }

    /// That report.
    pub fn last_words(&self) -> Option<(String, Outcome)> {
        self.0.last.lock().unwrap_or_else(PoisonError::into_inner).as_ref().map(|report| report())
    }

    /// The interruption.
    pub fn error(&self) -> Error {
        let kept = self.0.kept.lock().unwrap_or_else(PoisonError::into_inner);
        let kept = if kept.is_empty() { String::new() } else { format!("; {kept}") };
        Error::interrupted(format!("interrupted before the work was done{kept}"))
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
        let shown = std::io::stderr().is_terminal() && !interrupt.0.without_bars.load(Ordering::Relaxed);
        let bar = if shown { ProgressBar::new(units) } else { ProgressBar::hidden() };
        let template = format!("{{bar:40}} {{human_pos}}/{{human_len}} {unit}, {{per_sec}}, {{eta}} left");
        bar.set_style(
            ProgressStyle::with_template(&template).unwrap_or_else(|_| ProgressStyle::default_bar()),
        );
        bar.enable_steady_tick(Duration::from_millis(200));
        Progress { bar, interrupt: interrupt.clone() }
    }
}

impl Monitor for Interrupt {
    fn profile(&self) -> Option<Arc<Profile>> {
        self.0.profile.get().cloned()
    }

    fn advance(&self, _: u64) -> Result<()> {
        self.check()
    }
}

impl Monitor for Progress {
    fn profile(&self) -> Option<Arc<Profile>> {
        self.interrupt.profile()
    }

    fn advance(&self, units: u64) -> Result<()> {
        if units > 0 {
            self.bar.inc(units);
        }
        self.interrupt.check()
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
