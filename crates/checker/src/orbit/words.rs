//! What a certificate speaks of, in words.

use super::{
    super::motion::words::{list, system, walls},
    Version,
    text::Certificate,
};

/// Names and values: what is claimed, the pattern, the impacts, the box, the oscillator, its walls and its
/// digest.
pub(super) fn detail<C: Version>(certificate: &Certificate<C>) -> Vec<(&'static str, String)> {
    let impacts = &certificate.impacts;
    let only = format!(
        "the only orbit of this pattern whose phases and speeds are all within {} of these; its own are within {}",
        certificate.radius, certificate.within
    );
    let orbit = [
        ("stability", certificate.claim.said().to_string()),
        ("pattern", walls(impacts)),
        ("phases", list(impacts, |impact| impact.phase)),
        ("speeds", list(impacts, |impact| impact.velocity)),
        ("box", only),
    ];
    orbit.into_iter().chain(system(&certificate.system, certificate.system.digest(), "")).collect()
}
