//! The checker notices overflows, whatever its caller was built to do. In a release build this test's own
//! code wraps.

use std::hint::black_box;

use grazing::certificate;

#[test]
fn an_overflow_in_the_checker_is_a_panic() {
    assert!(std::panic::catch_unwind(certificate::overflow).is_err());
    let here = std::panic::catch_unwind(|| black_box(u64::MAX) + black_box(1));
    assert_eq!(here.is_err(), cfg!(debug_assertions), "this test shows nothing if its own sums are checked");
}

/// Real code of the checker, reached through an entry point: a period of this size doubles past the end.
#[test]
fn what_the_checker_computes_does_not_wrap() {
    let parse = |n| certificate::theorem2::Claim::parse("orbit 0/1 1/2 + -", n);
    assert!(parse(100).is_ok());
    assert!(std::panic::catch_unwind(|| parse(u64::MAX)).is_err());
}
