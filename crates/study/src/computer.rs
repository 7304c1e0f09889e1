//! Where and by what a measurement was made.

use std::{fs, thread};

/// The program that measures, as "grazing 0.1.0, rustc 1.90.0, opt-level 3".
pub const PROGRAM: &str = concat!("grazing ", env!("CARGO_PKG_VERSION"), ", ", env!("GRAZING_COMPILER"));

/// The processor and how many there are, as "Intel(R) Xeon(R) Processor, 2 cores"; where the system does not
/// name it, its kind.
pub fn machine() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let named = info.lines().find_map(|line| {
        let (key, value) = line.split_once(':')?;
        (key.trim() == "model name").then(|| value.trim().to_string())
    });
    let name = named.unwrap_or_else(|| format!("{} {}", std::env::consts::OS, std::env::consts::ARCH));
    let cores = thread::available_parallelism().map_or(1, usize::from);
    format!("{name}, {cores} core{}", if cores == 1 { "" } else { "s" })
}

/// Processes that were waiting for a processor or had one, on average over the last minute: 1 is this one.
/// `None` where the system does not say.
pub fn load() -> Option<f64> {
    fs::read_to_string("/proc/loadavg").ok()?.split(' ').next()?.parse().ok()
}
