//! What a certificate speaks of, in words: all that its statement leaves to its lines.

use super::text::{Certificate, Letter, RANGES};
use crate::touch::{
    among::Among,
    text::{plain, wall_in_words, window},
};

/// Names and values: what is proved in a word, the oscillator, the ranges, the letters with their boxes and
/// what may follow, the rate of growth, and which other motions there cannot be.
pub(super) fn detail(certificate: &Certificate) -> Vec<(&'static str, String)> {
    let (sign, wall) = (if certificate.behind { "" } else { "-" }, wall_in_words(&certificate.harmonics));
    let motion = match certificate.mirrored {
        false => format!("q'' = -c q' - k q + f above the wall {sign}nu - 1 + {wall}, restitution tau"),
        true => format!(
            "q'' = -c q' - k q between the wall w(t) = {sign}nu - 1 + {wall} and the wall -w(t - pi), restitution tau"
        ),
    };
    let claim = match certificate.is_chaos() {
        true => "chaos: paths branch, and the entropy is positive",
        false => "orbits: that there is more than one path is not claimed, nor that the entropy is positive",
    };
    let mut all = vec![("claim", claim.to_string()), ("motion", motion)];
    for (name, [lo, hi]) in RANGES.iter().zip(certificate.ranges) {
        if certificate.mirrored && *name == "force" {
            continue;
        }
        let open = *name == "depth" && lo.p == 0;
        let value = match (lo == hi, open) {
            (true, _) => plain(lo),
            (false, true) => format!("every nu with 0 < nu <= {}", plain(hi)),
            (false, false) => format!("from {} to {}", plain(lo), plain(hi)),
        };
        all.push((name, value));
    }
    let letters = (1..).zip(&certificate.letters);
    let letters = letters.map(|(number, letter)| said(number, letter, certificate.mirrored));
    all.push(("letters", letters.collect::<Vec<_>>().join("; ")));
    all.push(("window", window(certificate.window, certificate.mirrored)));
    all.push(("contraction", format!("at most {}", certificate.contraction)));
    let [lo, hi] = certificate.growth;
    if certificate.mirrored {
        all.push(("reach", format!("|q| < {} nu", certificate.reach)));
        all.push((
            "entropy",
            format!("per half period between log {lo} and log {hi}, per period twice that"),
        ));
    } else {
        all.push(("reach", format!("q < {} nu", certificate.reach)));
        all.push(("entropy", format!("per period between log {lo} and log {hi}")));
    }
    let others = match certificate.complete {
        None => "not excluded: there may be other orbits near".to_string(),
        Some(claim) => {
            let [[damping, _], [stiffness, _], ..] = certificate.ranges;
            let damped = damping.p > 0 && stiffness.p > 0;
            let which = [certificate.mirrored, true, damped];
            format!("none near: {}", Among::new(which, [certificate.window, claim.strength]))
        }
    };
    all.push(("others", others));
    all
}

/// A letter: its periods, its box and the letters that may follow.
fn said(number: u64, letter: &Letter, mirrored: bool) -> String {
    let n = letter.periods;
    let periods = match (mirrored, n % 2) {
        (true, 1) => format!("{n}/2 periods"),
        (true, _) if n == 2 => "1 period".into(),
        (true, _) => format!("{} periods", n / 2),
        (false, _) if n == 1 => "1 period".into(),
        (false, _) => format!("{n} periods"),
    };
    let ([a, b], [p, q]) = (letter.after, letter.before);
    let next: Vec<String> = letter.next.iter().map(|next| (next + 1).to_string()).collect();
    format!("{number}: {periods}, velocity/nu {a} to {b} first, {p} to {q} last, then {}", next.join(" or "))
}
