//! What a certificate speaks of, in words.

use std::fmt::Write;

use super::text::{Certificate, Claim, Fraction, Harmonic, Wall};

/// Names and values: what is claimed, the pattern, the impacts, the box, the oscillator, its walls and its digest.
pub(super) fn detail(certificate: &Certificate) -> Vec<(&'static str, String)> {
    let (system, impacts) = (&certificate.system, &certificate.impacts);
    let list = |one: &dyn Fn(usize) -> String, between| {
        (0..impacts.len()).map(one).collect::<Vec<_>>().join(between)
    };
    let periods: u64 = impacts.iter().map(|impact| impact.periods).sum();
    let plural = |count: u64| if count == 1 { "" } else { "s" };
    vec![
        (
            "stability",
            match certificate.claim {
                Claim::Stable => "stable".into(),
                Claim::Unstable => "unstable".into(),
                Claim::Open => "open: nothing is claimed".into(),
            },
        ),
        (
            "pattern",
            format!(
                "{} in {periods} period{}, and in no fewer: {}",
                match impacts.len() {
                    1 => "1 impact".to_string(),
                    m => format!("{m} impacts"),
                },
                plural(periods),
                list(&|i| format!("{} wall, next after {}", impacts[i].side, impacts[i].periods), "; ")
            ),
        ),
        ("phases", list(&|i| impacts[i].phase.to_string(), ", ")),
        ("speeds", list(&|i| impacts[i].velocity.to_string(), ", ")),
        (
            "box",
            format!(
                "the only orbit of this pattern whose phases and speeds are all within {} of these; its own are within {}",
                certificate.radius, certificate.within
            ),
        ),
        (
            "motion",
            format!(
                "q'' = {}",
                sum(&[
                    (negated(system.damping), "q'".into()),
                    (negated(system.stiffness), "q".into()),
                    (system.force, String::new()),
                ]
                .into_iter()
                .chain(waves(&system.forcing))
                .collect::<Vec<_>>())
            ),
        ),
        ("lower wall", wall(&system.lower)),
        ("upper wall", wall(&system.upper)),
        ("digest", system.digest()),
    ]
}

fn wall(wall: &Option<Wall>) -> String {
    let Some(wall) = wall else { return "none".into() };
    let terms: Vec<_> = [(wall.offset, String::new())].into_iter().chain(waves(&wall.harmonics)).collect();
    format!("{}, restitution {}", sum(&terms), plain(wall.restitution))
}

fn waves(harmonics: &[Harmonic]) -> Vec<(Fraction, String)> {
    let angle = |k: u64| if k == 1 { "t".to_string() } else { format!("{k}t") };
    harmonics
        .iter()
        .flat_map(|h| [(h.cos, format!("cos {}", angle(h.k))), (h.sin, format!("sin {}", angle(h.k)))])
        .collect()
}

fn negated(x: Fraction) -> Fraction {
    Fraction { p: -x.p, q: x.q }
}

/// p/q, or p if q is 1.
fn plain(x: Fraction) -> String {
    if x.q == 1 { x.p.to_string() } else { x.to_string() }
}

/// A sum without its terms that are 0.
fn sum(terms: &[(Fraction, String)]) -> String {
    let mut text = String::new();
    for (x, what) in terms.iter().filter(|(x, _)| x.p != 0) {
        let sign = match (text.is_empty(), x.p < 0) {
            (true, true) => "-",
            (true, false) => "",
            (false, true) => " - ",
            (false, false) => " + ",
        };
        let size = plain(Fraction { p: x.p.abs(), q: x.q });
        let factor = match (what.is_empty(), size.as_str()) {
            (true, size) => size.to_string(),
            (false, "1") => what.clone(),
            (false, size) => format!("{size} {what}"),
        };
        write!(text, "{sign}{factor}").expect("writing to a String cannot fail");
    }
    if text.is_empty() { "0".into() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_read_as_one_writes_them() {
        let terms = |list: &[(i128, i128, &str)]| {
            sum(&list.iter().map(|&(p, q, what)| (Fraction { p, q }, what.to_string())).collect::<Vec<_>>())
        };
        assert_eq!(
            terms(&[(-1, 10, "q'"), (-1, 1, "q"), (0, 1, ""), (24, 25, "cos t")]),
            "-1/10 q' - q + 24/25 cos t"
        );
        assert_eq!(terms(&[(2, 1, ""), (-3, 2, "sin 2t")]), "2 - 3/2 sin 2t");
        assert_eq!(terms(&[(0, 1, "q")]), "0");
    }
}
