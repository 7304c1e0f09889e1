//! How much the tests do.

/// `sample` times `GRAZING_SAMPLES`, a whole number from 1: 1 where it is not set, as in `cargo test`.
pub fn samples<T: TryFrom<u64>>(sample: u64) -> T {
    let times = match std::env::var("GRAZING_SAMPLES") {
        Ok(text) => match text.parse::<u64>() {
            Ok(times @ 1..) => times,
            _ => panic!("GRAZING_SAMPLES={text}: it is a whole number from 1"),
        },
        Err(std::env::VarError::NotPresent) => 1,
        Err(error) => panic!("GRAZING_SAMPLES: {error}"),
    };
    let all = sample.checked_mul(times).and_then(|all| T::try_from(all).ok());
    all.unwrap_or_else(|| panic!("GRAZING_SAMPLES={times}: too much of {sample}"))
}
