//! What a certificate speaks of, in words: all that its statement leaves to its lines.

use super::text::{Certificate, Fraction, RANGES};
use crate::touch::text::{plain, wall_in_words};

/// Names and values: the oscillator, the ranges, the orbit, and where it is stable.
pub(super) fn detail(certificate: &Certificate) -> Vec<(&'static str, String)> {
    let (sign, wall) = (if certificate.behind { "" } else { "-" }, wall_in_words(&certificate.harmonics));
    let motion = match certificate.mirrored {
        false => format!("q'' = -c q' - k q above the wall {sign}nu - 1 + {wall}, restitution tau"),
        true => format!(
            "q'' = -c q' - k q between the lower wall {sign}nu - 1 + {wall} and its mirror image half a period later, \
             restitution tau"
        ),
    };
    let mut all = vec![("motion", motion)];
    for (name, [lo, hi]) in RANGES.iter().zip(certificate.ranges) {
        let value = if lo == hi { plain(lo) } else { format!("from {} to {}", plain(lo), plain(hi)) };
        all.push((name, value));
    }
    let every = match (certificate.periods, certificate.mirrored) {
        (1, false) => "every period 2 pi".to_string(),
        (n, false) => format!("every {n} periods 2 pi"),
        (1, true) => "every half period pi, at the other wall each time".to_string(),
        (n, true) if n % 2 == 1 => format!("every {n} half periods pi, at the other wall each time"),
        (n, true) => format!("every {n} half periods pi, at the lower wall"),
    };
    all.push(("orbit", format!("one impact {every}, born at t = 0 with nu = 0")));
    let last = certificate.parts.last().map_or(Fraction::ZERO, |part| part.depth);
    all.push(("depth", format!("every nu with 0 < nu <= {}", plain(last))));
    if let Some(phase) = certificate.cells.last() {
        let (cells, sign) = (certificate.cells.len(), if certificate.forward { "" } else { "-" });
        let cells = if cells == 1 { "one cell".into() } else { format!("{cells} cells") };
        all.push(("phase", format!("t from 0 to {sign}{phase}, in {cells}")));
    }
    let mut from = Fraction::ZERO;
    let mut parts = Vec::new();
    for part in &certificate.parts {
        parts.push(format!("{} for {} < nu <= {}", part.word, plain(from), plain(part.depth)));
        from = part.depth;
    }
    all.push(("stability", parts.join("; ")));
    all
}
