//! What a certificate speaks of, in words: all that its statement leaves to its lines.

use super::text::{Certificate, Decimal, Exponent, RANGES, Setting, Shown};
use crate::touch::text::{plain, wall_in_words};

/// Names and values: the oscillator, the ranges, what traps, and how fast motions part there.
pub(super) fn detail(certificate: &Certificate) -> Vec<(&'static str, String)> {
    let Certificate { setting, growth, last, start, exponent } = certificate;
    let mut all = about(setting, format!("every nu with 0 < nu <= {}", plain(setting.depth)));
    all.push(trapped(*start));
    all.push(("growth", format!("{growth} at each contact, shown for {last} periods and more")));
    let exponent = match exponent {
        Some(Exponent { depth, rate, last }) => format!(
            "at least {rate} in a period 2 pi for nu >= {}, where returns take {last} periods at most",
            plain(*depth)
        ),
        None => "positive".into(),
    };
    all.push(("exponent", exponent));
    all
}

/// What begins so is trapped.
pub(super) fn trapped(start: Decimal) -> (&'static str, String) {
    ("trapped", format!("from the third contact on what begins with 0 <= a q + q' <= {start}"))
}

/// The oscillator, the ranges, the depths, the wall and the trap.
pub(super) fn about(setting: &Setting, depths: String) -> Vec<(&'static str, String)> {
    let Setting { harmonics, window, bends, shown, speed, slip, .. } = setting;
    let mut all = vec![(
        "motion",
        format!(
            "q'' = -c q' - k q above the wall Q = nu - 1 + {}, restitution tau, overdamped",
            wall_in_words(harmonics)
        ),
    )];
    for (name, [lo, hi]) in RANGES.iter().zip(setting.ranges) {
        let value = if lo == hi { plain(lo) } else { format!("from {} to {}", plain(lo), plain(hi)) };
        all.push((name, value));
    }
    all.push(("depth", depths));
    let mut seen = format!(
        "Q >= 0 within -{} <= t <= {}, where -g'' is from {} to {}",
        window[0], window[1], bends[0], bends[1]
    );
    if let Some(Shown { concave: [before, after], pieces }) = shown {
        seen += &format!("; concave for -{before} <= t <= {after}, in {pieces} pieces");
    }
    all.push(("wall", seen));
    let trap = format!("contacts with -{speed} sqrt(nu) <= V <= 0 and 0 <= a Q + Q' + V <= {slip} nu");
    all.push(("trap", trap));
    all
}
