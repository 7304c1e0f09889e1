//! How much the tests do, and what beside cargo they are asked to use.

// Each test program uses a part of this.
#![allow(dead_code)]

use std::io::Write;

/// `sample` times `GRAZING_SAMPLES`.
pub fn samples<T: TryFrom<u64>>(sample: u64) -> T {
    let times = times();
    let all = sample.checked_mul(times).and_then(|all| T::try_from(all).ok());
    all.unwrap_or_else(|| panic!("GRAZING_SAMPLES={times}: too much of {sample}"))
}

/// The step by which a list too long for every run is walked: `sample` at `GRAZING_SAMPLES` 1, and 1, so that
/// nothing is left out, from `GRAZING_SAMPLES=sample` on.
pub fn one_in(sample: u64) -> usize {
    usize::try_from((sample / times()).max(1)).expect("a step is small")
}

/// Whether what takes seconds and has no smaller sample is run: from `GRAZING_SAMPLES` 2 on. What is not is
/// said past the test harness, which keeps what a passing test prints.
pub fn larger(what: &str) -> bool {
    let larger = times() > 1;
    if !larger {
        let said = writeln!(std::io::stderr(), "NOT RUN, as GRAZING_SAMPLES=2 does not ask for it: {what}");
        said.expect("standard error can be written");
    }
    larger
}

/// `GRAZING_SAMPLES`, a whole number from 1: 1 where it is not set, as in `cargo test`.
fn times() -> u64 {
    match std::env::var("GRAZING_SAMPLES") {
        Ok(text) => match text.parse::<u64>() {
            Ok(times @ 1..) => times,
            _ => panic!("GRAZING_SAMPLES={text}: it is a whole number from 1"),
        },
        Err(std::env::VarError::NotPresent) => 1,
        Err(error) => panic!("GRAZING_SAMPLES: {error}"),
    }
}

/// What numbers that look random begin with: `own`, mixed with `GRAZING_DRAW` where that is set, to any text.
pub fn seed(own: u64) -> u64 {
    // FNV-1a: every seed has numbers of its own.
    let Ok(text) = std::env::var("GRAZING_DRAW") else { return own };
    let mixed = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
    text.bytes().chain(own.to_le_bytes()).fold(0xcbf2_9ce4_8422_2325, mixed)
}

/// Whether more than `least` of what was drawn could have gone wrong, as is known of the numbers kept.
/// Of others one has to, where it is more than five of those: by chance there is none in a run of thousands.
pub fn tried(count: impl TryInto<u64>, least: u64) -> bool {
    let count = count.try_into().unwrap_or(0);
    match std::env::var_os("GRAZING_DRAW") {
        Some(_) => count > 0 || least <= 5,
        None => count > least,
    }
}

/// The same as the 32 bytes of another generator.
pub fn seed_bytes(own: u64) -> [u8; 32] {
    let bytes = (0..4).flat_map(|part| seed(4 * own + part).to_le_bytes());
    bytes.collect::<Vec<_>>().try_into().expect("four times eight")
}

/// Whether something beside cargo is asked for, by this variable being 1; it must be there then.
/// What is not asked for is said past the test harness, which keeps what a passing test prints.
pub fn asked(variable: &str, what: &str) -> bool {
    let asked = std::env::var_os(variable).is_some_and(|value| value == "1");
    if !asked {
        let said = writeln!(std::io::stderr(), "NOT RUN, as {variable}=1 does not ask for it: {what}");
        said.expect("standard error can be written");
    }
    asked
}
