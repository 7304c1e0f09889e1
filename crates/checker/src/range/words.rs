//! What a certificate speaks of, in words: all that its statement leaves to its lines.

use super::text::{Certificate, Decimal, Fraction, RANGES};
use crate::touch::{
    among::{Among, less},
    text::{plain, wall_in_words, window},
};

/// Names and values: what is proved in a word, the oscillator, the ranges, the letters and what may follow,
/// the strengths, and the rate of growth.
pub(super) fn detail(certificate: &Certificate) -> Vec<(&'static str, String)> {
    let (sign, wall) = (if certificate.behind { "" } else { "-" }, wall_in_words(&certificate.harmonics));
    let claim = match certificate.is_chaos() {
        true => "chaos: paths branch, and the entropy is positive",
        false => "orbits: that there is more than one path is not claimed, nor that the entropy is positive",
    };
    let (motion, half) = match certificate.mirrored {
        false => (format!("q'' = -c q' - k q above the wall {sign}nu - 1 + {wall}, restitution tau"), ""),
        true => (
            format!(
                "q'' = -c q' - k q between the lower wall {sign}nu - 1 + {wall} and its mirror image half a period \
                 later, restitution tau"
            ),
            "half ",
        ),
    };
    let mut all = vec![("claim", claim.to_string()), ("motion", motion)];
    for (name, [lo, hi]) in RANGES.iter().zip(certificate.ranges) {
        let value = if lo == hi { plain(lo) } else { format!("from {} to {}", plain(lo), plain(hi)) };
        all.push((name, value));
    }
    let twice = if certificate.mirrored { ", per period twice that" } else { "" };
    let last = certificate.cells.last().map_or(Fraction::ZERO, |cell| cell.depth);
    let cells = certificate.cells.len();
    let cells = if cells == 1 { "one cell".into() } else { format!("{cells} cells, linked") };
    all.push(("depth", format!("every nu with 0 < nu <= {}, in {cells}", plain(last))));
    let letters = (1..).zip(&certificate.letters).map(|(number, letter)| {
        let next: Vec<String> = letter.next.iter().map(|next| (next + 1).to_string()).collect();
        let periods = if letter.periods == 1 { "period" } else { "periods" };
        format!("{number}: {} {half}{periods}, then {}", letter.periods, next.join(" or "))
    });
    all.push(("letters", letters.collect::<Vec<_>>().join("; ")));
    all.push(("impacts", strengths(certificate)));
    all.push(("window", window(certificate.window, certificate.mirrored)));
    all.push(("contraction", format!("at most {}", certificate.contraction)));
    let [lo, hi] = certificate.growth;
    all.push(("entropy", format!("per {half}period between log {lo} and log {hi}{twice}")));
    all.push(("others", others(certificate)));
    all
}

/// Up to which depth there are none, and which.
fn others(certificate: &Certificate) -> String {
    match certificate.among() {
        None => "not excluded: there may be other orbits near".into(),
        Some((depth, among)) => format!("none near for nu <= {}: {among}", plain(depth)),
    }
}

impl Certificate {
    /// In the cells from the touch on that exclude other motions: the greatest ν, and which motions are among
    /// these; none if the first cell does not.
    pub fn among(&self) -> Option<(Fraction, Among)> {
        let claimed = self.cells.iter().map_while(|cell| Some((cell.depth, cell.others?.strength)));
        let (depth, strength) = claimed.reduce(|(_, one), (depth, other)| (depth, less(one, other)))?;
        let [[damping, _], [stiffness, _], ..] = self.ranges;
        let damped = damping.p > 0 && stiffness.p > 0;
        Some((depth, Among::new([self.mirrored, self.behind, damped], [self.window, strength])))
    }
}

/// For each edge, between which numbers s lies at any depth.
fn strengths(certificate: &Certificate) -> String {
    let below = |one: Decimal, other: Decimal| one.parts() < other.parts();
    let each = certificate.edges().into_iter().enumerate().map(|(edge, [u, v])| {
        let ranges = certificate.cells.iter().map(|cell| cell.edges[edge].strengths);
        let all = ranges
            .reduce(|[a, b], [c, d]| [if below(c, a) { c } else { a }, if below(b, d) { d } else { b }]);
        let said = all.map(|[lo, hi]| format!("from {lo} to {hi}")).unwrap_or_default();
        format!("{}, {}: {said}", u + 1, v + 1)
    });
    let cells = if certificate.cells.len() > 1 { ", in each cell the part that it lists" } else { "" };
    format!("g' = nu s/2{cells}, between letters {}", each.collect::<Vec<_>>().join("; "))
}
