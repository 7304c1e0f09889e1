//! What a certificate speaks of, in words.

use super::{
    super::motion::words::{pattern, system, unit},
    Certificate,
};

/// Names and values: the parameter's range, where the orbit is stable, the pattern, the boxes, the
/// oscillator, its walls and its digest.
pub(super) fn detail(certificate: &Certificate) -> Vec<(&'static str, String)> {
    let Certificate { name, cells, strikes, .. } = certificate;
    // A certificate without cells has not been read.
    let [from, to] =
        [cells.first().map(|cell| cell.parameter[0]), cells.last().map(|cell| cell.parameter[1])]
            .map(|end| end.map(|end| end.to_string()).unwrap_or_default());
    let strikes: Vec<_> =
        strikes.iter().map(|strike| (format!("{} wall", strike.side), strike.periods)).collect();
    let unit = unit(certificate.system.units);
    let plural = if cells.len() == 1 { "" } else { "s" };
    let start = [
        ("parameter", format!("{name}, from {from} to {to}{unit}, in {} cell{plural}", cells.len())),
        ("stability", stability(certificate)),
        ("pattern", pattern(&strikes)),
        ("box", "in each cell the only orbit of this pattern that is so near its line".into()),
    ];
    start.into_iter().chain(system(&certificate.system, certificate.system.digest(), name)).collect()
}

/// Where it is stable, unstable, or nothing is claimed.
fn stability(certificate: &Certificate) -> String {
    let parts = certificate.parts();
    let all = parts.iter().map(|(claim, [from, to])| format!("{claim} from {from} to {to}"));
    all.collect::<Vec<_>>().join("; ")
}
