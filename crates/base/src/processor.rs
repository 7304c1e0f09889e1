//! How long things took, how long a processor was kept busy, and how much memory that took.

use std::{
    env,
    num::NonZero,
    thread,
    time::{Duration, Instant},
};

use crate::error::{Error, Result};

/// Most threads per core, whatever asks for more: they only stand in each other's way, and hundreds of
/// thousands stall a computer.
const MOST_PER_CORE: usize = 4;

/// How many threads to work on: `asked`, or where that is 0 what `RAYON_NUM_THREADS` says, or one for each
/// core.
///
/// # Errors
/// An input error if that is more than four for each core.
pub fn threads(asked: usize) -> Result<usize> {
    let cores = thread::available_parallelism().map_or(1, NonZero::get);
    let variable = |name: &'static str| Some((name, env::var(name).ok()?.parse().ok().filter(|&n| n > 0)?));
    let (who, count) = match asked {
        0 => variable("RAYON_NUM_THREADS").or_else(|| variable("RAYON_RS_NUM_CPUS")).unwrap_or(("", cores)),
        asked => ("--jobs", asked),
    };
    if count > MOST_PER_CORE * cores {
        let most = MOST_PER_CORE * cores;
        return Err(Error::input(format!("{who} {count}: at most {most}, four times the number of cores")));
    }
    Ok(count)
}

/// Measures time on the clock of the wall. The library asks no clock but here: where the system has none, as
/// in a browser's WebAssembly, `Instant::now` panics, and a stopwatch stands at 0.
#[derive(Debug, Clone, Copy)]
pub struct Stopwatch(Option<Instant>);

impl Stopwatch {
    /// One that starts now.
    pub fn start() -> Stopwatch {
        Stopwatch((!cfg!(target_family = "wasm")).then(Instant::now))
    }

    /// The time since its start; 0 without a clock.
    pub fn elapsed(self) -> Duration {
        self.0.map_or(Duration::ZERO, |start| start.elapsed())
    }
}

/// Processor seconds that this thread has used. Time in which other threads or processes had the processor
/// does not count. 0 where the system does not tell.
pub fn thread_seconds() -> f64 {
    #[cfg(unix)]
    {
        let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
        time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
    }
    #[cfg(not(unix))]
    0.0
}

/// Processor seconds that all threads of this process have used. 0 where the system does not tell.
pub fn process_seconds() -> f64 {
    #[cfg(unix)]
    {
        let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
        time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
    }
    #[cfg(not(unix))]
    0.0
}

/// The most memory that this process has had, in kilobytes; none where the system does not tell.
pub fn most_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.split_whitespace().next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::Stopwatch;

    #[test]
    fn a_stopwatch_goes_on_where_there_is_a_clock_and_stands_where_there_is_none() {
        let running = Stopwatch::start();
        while running.elapsed() == Duration::ZERO {}
        assert_eq!(Stopwatch(None).elapsed(), Duration::ZERO);
    }

    /// A thread that sleeps uses none.
    #[cfg(unix)]
    #[test]
    fn sleep_is_not_work() {
        let start = super::thread_seconds();
        std::thread::sleep(std::time::Duration::from_millis(200));
        let asleep = super::thread_seconds() - start;
        assert!((0.0..0.1).contains(&asleep), "{asleep}");
        let busy = (0u64..20_000_000).fold(0u64, |sum, i| sum.rotate_left(5) ^ i);
        assert!(super::thread_seconds() > start + asleep, "{busy}");
    }
}
