//! What a certificate speaks of, in words.

use super::{
    super::{
        motion::words::{Spoken, sum},
        orbit::Claim,
    },
    Range,
    text::{Certificate, Stop},
};

/// Names and values: what is claimed, the pattern, the impacts, the box, the machine, its stops and its
/// digest.
pub(super) fn detail(certificate: &Certificate) -> Vec<(&'static str, String)> {
    let (impacts, machine) = (&certificate.impacts, &certificate.machine);
    let claim = match certificate.claim {
        Claim::Stable => "stable",
        Claim::Unstable => "unstable",
        Claim::Open => "open: nothing is claimed",
    };
    let plural = |count: u64| if count == 1 { "" } else { "s" };
    let periods: u64 = impacts.iter().map(|impact| impact.periods).sum();
    let strikes: Vec<String> =
        impacts.iter().map(|i| format!("stop {}, next after {}", i.stop + 1, i.periods)).collect();
    let (count, n) = (impacts.len() as u64, machine.size());
    let pattern = format!(
        "{count} impact{} in {periods} period{}, and in no fewer: {}",
        plural(count),
        plural(periods),
        strikes.join("; ")
    );
    let phases: Vec<String> = impacts.iter().map(|i| i.phase.to_string()).collect();
    let states = |from: usize| -> String {
        let one = |i: &super::Impact| {
            format!(
                "({})",
                i.state[from..from + n].iter().map(|x| x.to_string()).collect::<Vec<_>>().join(", ")
            )
        };
        impacts.iter().map(one).collect::<Vec<_>>().join(", ")
    };
    let scales: Vec<String> = certificate.scales.iter().map(|x| x.to_string()).collect();
    let only = format!(
        "the only orbit of this pattern whose phases are within {} of these, and displacements and velocities within {} times {}; \
         its own are within {} times these",
        certificate.radius,
        certificate.radius,
        scales.join(", "),
        certificate.within
    );
    let unit =
        if machine.unit == 0 { String::new() } else { format!(", all in units of 10^{}", machine.unit) };
    let mass: Vec<String> = machine.mass.iter().map(|row| list(row)).collect();
    let matrix = |rows: &[Vec<Range>]| rows.iter().map(|row| list(row)).collect::<Vec<_>>().join(", ");
    let mut forces = vec![list(&machine.force)];
    for load in &machine.forcing {
        forces.push(format!("{} cos {} t", list(&load.cos), load.k));
        forces.push(format!("{} sin {} t", list(&load.sin), load.k));
    }
    let stops: Vec<String> = (1..).zip(&machine.stops).map(|(i, stop)| said(i, stop)).collect();
    vec![
        ("stability", claim.to_string()),
        ("pattern", pattern),
        ("phases", phases.join(", ")),
        ("displacements", states(0)),
        ("velocities", states(n)),
        ("box", only),
        ("period", spoken(&machine.period)),
        ("mass", format!("lower triangle {}{unit}", mass.join(", "))),
        ("damping", matrix(&machine.damping)),
        ("stiffness", matrix(&machine.stiffness)),
        ("force", forces.join(" + ")),
        ("stops", stops.join("; ")),
        ("digest", machine.digest()),
    ]
}

fn spoken(x: &Range) -> String {
    let sign = if x.is_negative() { "-" } else { "" };
    format!("{sign}{}", x.magnitude(""))
}

fn list(row: &[Range]) -> String {
    format!("({})", row.iter().map(spoken).collect::<Vec<_>>().join(", "))
}

fn said(number: u64, stop: &Stop) -> String {
    let q = |i: usize| format!("q{}", i + 1);
    let row: Vec<_> = stop.row.iter().enumerate().map(|(i, x)| (Spoken::is_negative(x), x, q(i))).collect();
    let angle = |k: u64| if k == 1 { "t".to_string() } else { format!("{k}t") };
    let mut place = vec![(Spoken::is_negative(&stop.offset), &stop.offset, String::new())];
    for h in &stop.harmonics {
        place.push((Spoken::is_negative(&h.cos), &h.cos, format!("cos {}", angle(h.k))));
        place.push((Spoken::is_negative(&h.sin), &h.sin, format!("sin {}", angle(h.k))));
    }
    format!("{number}: {} >= {}, restitution {}", sum(&row, ""), sum(&place, ""), spoken(&stop.restitution))
}
