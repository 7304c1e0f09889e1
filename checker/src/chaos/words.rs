//! What a certificate speaks of, in words.

use super::text::{Certificate, Fraction, RANGES};

/// Names and values: the oscillator, the ranges, the letters with what may follow, the rate of growth.
pub(super) fn detail(certificate: &Certificate) -> Vec<(&'static str, String)> {
    let (sign, wall) = (if certificate.behind { "" } else { "-" }, wall(certificate));
    let motion = match certificate.mirrored {
        false => format!("q'' = -c q' - k q + f above the wall {sign}nu - 1 + {wall}, restitution tau"),
        true => format!(
            "q'' = -c q' - k q between the wall w(t) = {sign}nu - 1 + {wall} and the wall -w(t - pi), restitution tau"
        ),
    };
    let mut all = vec![("motion", motion)];
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
    let full = certificate.letters.iter().all(|letter| letter.next.len() == certificate.letters.len());
    let letters = certificate.letters.iter().map(|letter| match (certificate.mirrored, letter.periods % 2) {
        (false, _) => letter.periods.to_string(),
        (true, 0) => (letter.periods / 2).to_string(),
        (true, _) => format!("{}/2", letter.periods),
    });
    let graph = if full { "each may follow each" } else { "as the lines next say" };
    all.push(("letters", format!("{}; {graph}", letters.collect::<Vec<_>>().join(", "))));
    all.push(("contraction", certificate.contraction.to_string()));
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
    all.push((
        "others",
        match certificate.complete {
            None => "not excluded: there may be other orbits near".to_string(),
            Some(claim) => {
                let [[damping, _], [stiffness, _], ..] = certificate.ranges;
                let (wall, window) = match certificate.mirrored {
                    false => ("the wall", "in the window"),
                    true => ("a wall", "in that wall's windows"),
                };
                let which = match damping.p > 0 && stiffness.p > 0 {
                    true => format!("bounded motion that meets {wall} only"),
                    false => {
                        format!("motion that meets {wall} at arbitrarily early and late times, and only")
                    }
                };
                format!(
                    "none near: every {which} {window}, at |g'| <= nu {}/2, is one of these",
                    claim.strength
                )
            }
        },
    ));
    all
}

/// g(t), or its name where its harmonics are not those of a cosine.
fn wall(certificate: &Certificate) -> String {
    let one = |x: Fraction| x.p == 1 && x.q == 1;
    match &certificate.harmonics[..] {
        [only] if only.order == 1 && only.parts[0].into_iter().all(one) => "cos t".into(),
        all => {
            let orders: Vec<String> = all.iter().map(|term| term.order.to_string()).collect();
            format!("g(t), of harmonics {} as the lines harmonic say", orders.join(", "))
        }
    }
}

/// p/q, or p if q is 1.
fn plain(x: Fraction) -> String {
    if x.q == 1 { x.p.to_string() } else { x.to_string() }
}
