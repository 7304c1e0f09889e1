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
