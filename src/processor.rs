//! How long a processor was kept busy, and how much memory that took.

/// Processor seconds that this thread has used. Time in which other threads or processes had the processor
/// does not count. 0 where the system does not tell.
pub(crate) fn thread_seconds() -> f64 {
    #[cfg(unix)]
    {
        let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
        time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
    }
    #[cfg(not(unix))]
    0.0
}

/// Processor seconds that all threads of this process have used. 0 where the system does not tell.
#[cfg(feature = "cli")]
pub(crate) fn process_seconds() -> f64 {
    #[cfg(unix)]
    {
        let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
        time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
    }
    #[cfg(not(unix))]
    0.0
}

/// The most memory that this process has had, in kilobytes; none where the system does not tell.
#[cfg(feature = "cli")]
pub(crate) fn most_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.split_whitespace().next()?.parse().ok()
}

#[cfg(all(test, unix))]
mod tests {
    /// A thread that sleeps uses none.
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
