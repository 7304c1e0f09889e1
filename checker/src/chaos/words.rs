//! What a certificate speaks of, in words.

use super::text::{Certificate, Fraction, RANGES};

/// Names and values: the oscillator, the ranges, the letters with what may follow, the rate of growth.
pub(super) fn detail(certificate: &Certificate) -> Vec<(&'static str, String)> {
    let mut all = vec![(
        "motion",
        format!(
            "q'' = -c q' - k q + f above the wall {}nu - 1 + {}, restitution tau",
            if certificate.behind { "" } else { "-" },
            wall(certificate)
        ),
    )];
    for (name, [lo, hi]) in RANGES.iter().zip(certificate.ranges) {
        let open = *name == "depth" && lo.p == 0;
        let value = match (lo == hi, open) {
            (true, _) => plain(lo),
            (false, true) => format!("every nu with 0 < nu <= {}", plain(hi)),
            (false, false) => format!("from {} to {}", plain(lo), plain(hi)),
        };
        all.push((name, value));
    }
    let full = certificate.letters.iter().all(|letter| letter.next.len() == certificate.letters.len());
    let letters = certificate.letters.iter().map(|letter| letter.periods.to_string());
    let graph = if full { "each may follow each" } else { "as the lines next say" };
    all.push(("letters", format!("{}; {graph}", letters.collect::<Vec<_>>().join(", "))));
    all.push(("contraction", certificate.contraction.to_string()));
    all.push(("reach", format!("q < {} nu", certificate.reach)));
    let [lo, hi] = certificate.growth;
    all.push(("entropy", format!("per period between log {lo} and log {hi}")));
    all.push((
        "others",
        match certificate.complete {
            None => "not excluded: there may be other orbits near".to_string(),
            Some(claim) => {
                let [[damping, _], [stiffness, _], ..] = certificate.ranges;
                let which = match damping.p > 0 && stiffness.p > 0 {
                    true => "bounded motion that meets the wall only",
                    false => "motion that meets the wall at arbitrarily early and late times, and only",
                };
                format!(
                    "none near: every {which} in the window, at |g'| <= nu {}/2, is one of these",
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
