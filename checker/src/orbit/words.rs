//! What a certificate speaks of, in words.

use super::{
    super::motion::words::{list, pattern, system},
    Version,
    text::{Certificate, Claim},
};

/// Names and values: what is claimed, the pattern, the impacts, the box, the oscillator, its walls and its
/// digest.
pub(super) fn detail<C: Version>(certificate: &Certificate<C>) -> Vec<(&'static str, String)> {
    let impacts = &certificate.impacts;
    let claim = match certificate.claim {
        Claim::Stable => "stable",
        Claim::Unstable => "unstable",
        Claim::Open => "open: nothing is claimed",
    };
    let only = format!(
        "the only orbit of this pattern whose phases and speeds are all within {} of these; its own are within {}",
        certificate.radius, certificate.within
    );
    let orbit = [
        ("stability", claim.to_string()),
        ("pattern", pattern(impacts)),
        ("phases", list(impacts, ", ", |impact| impact.phase.to_string())),
        ("speeds", list(impacts, ", ", |impact| impact.velocity.to_string())),
        ("box", only),
    ];
    orbit.into_iter().chain(system(&certificate.system, certificate.system.digest(), "")).collect()
}
