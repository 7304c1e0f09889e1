//! What a certificate speaks of, in words.

use super::{
    super::motion::words::{system, unit},
    Begin, Certificate, Version,
};

/// Names and values: the parameter's range, its depths, the machine, and what the certificate that follows
/// says of the oscillator.
pub(super) fn detail<C: Version>(
    certificate: &Certificate<C>,
    inner: Vec<(&'static str, String)>,
) -> Vec<(&'static str, String)> {
    let Certificate { name, begin, depths, .. } = certificate;
    let (above, unit) = (certificate.is_above(), unit(certificate.system.units));
    let end = depths.last().map(|last| last.parameter.to_string()).unwrap_or_default();
    let range = match (begin, above) {
        (Begin::Touch([lo, hi]), true) => {
            format!(
                "for {name}* < {name} <= {end}, the touch {name}* being the only one between {lo} and {hi}{unit}"
            )
        }
        (Begin::Touch([lo, hi]), false) => {
            format!(
                "for {end} <= {name} < {name}*, the touch {name}* being the only one between {lo} and {hi}{unit}"
            )
        }
        (Begin::From(value), true) => format!("for {value} <= {name} <= {end}{unit}"),
        (Begin::From(value), false) => format!("for {end} <= {name} <= {value}{unit}"),
    };
    let way = if above { "<=" } else { ">=" };
    let depth: Vec<String> =
        depths.iter().map(|one| format!("nu <= {} for {name} {way} {}", one.depth, one.parameter)).collect();
    let mut all = vec![("parameter", range), ("there", depth.join("; "))];
    if let Some([lo, hi]) = certificate.top {
        all.push((
            "top",
            format!("the wall's top, the certificate's time 0, is at a time between {lo} and {hi}"),
        ));
    }
    let machine = system(&certificate.system, certificate.system.digest(), name);
    all.extend(
        machine.into_iter().map(|(what, text)| (if what == "motion" { "machine" } else { what }, text)),
    );
    all.push(("seen", "from the motion without walls, in units of the wall's own motion, it is".into()));
    all.extend(inner);
    all
}
