//! What a certificate speaks of, in words.

use super::{
    super::motion::words::{Spoken, alone, list, pattern, place, sum},
    Range,
    text::{Certificate, Machine, Stop},
};

/// Names and values: what is claimed, the pattern, the impacts, the box, the machine, its stops and its
/// digest.
pub(super) fn detail(certificate: &Certificate) -> Vec<(&'static str, String)> {
    let (impacts, machine) = (&certificate.impacts, &certificate.machine);
    let n = machine.size();
    let strikes: Vec<_> = impacts.iter().map(|i| (format!("stop {}", i.stop + 1), i.periods)).collect();
    let states = |from: usize| list(impacts, |i| format!("({})", list(&i.state[from..from + n], |x| *x)));
    let only = format!(
        "the only orbit of this pattern whose phases are within {} of these, and displacements and velocities within {} times {}; \
         its own are within {} times these",
        certificate.radius,
        certificate.radius,
        list(&certificate.scales, |x| *x),
        certificate.within
    );
    let orbit = [
        ("stability", certificate.claim.said().to_string()),
        ("pattern", pattern(&strikes)),
        ("phases", list(impacts, |i| i.phase)),
        ("displacements", states(0)),
        ("velocities", states(n)),
        ("box", only),
    ];
    orbit.into_iter().chain(self::machine(machine)).collect()
}

/// The machine, its stops and its digest.
pub(super) fn machine(machine: &Machine) -> [(&'static str, String); 7] {
    let unit =
        if machine.unit == 0 { String::new() } else { format!(", all in units of 10^{}", machine.unit) };
    let matrix = |rows: &[Vec<Range>]| list(rows, |one| row(one));
    let mut forces = vec![row(&machine.force)];
    for load in &machine.forcing {
        forces.push(format!("{} cos {} t", row(&load.cos), load.k));
        forces.push(format!("{} sin {} t", row(&load.sin), load.k));
    }
    let stops: Vec<String> = (1..).zip(&machine.stops).map(|(i, stop)| said(i, stop)).collect();
    [
        ("period", alone(&machine.period, "")),
        ("mass", format!("lower triangle {}{unit}", matrix(&machine.mass))),
        ("damping", matrix(&machine.damping)),
        ("stiffness", matrix(&machine.stiffness)),
        ("force", forces.join(" + ")),
        ("stops", if stops.is_empty() { "none".into() } else { stops.join("; ") }),
        ("digest", machine.digest()),
    ]
}

fn row(row: &[Range]) -> String {
    format!("({})", list(row, |x| alone(x, "")))
}

fn said(number: u64, stop: &Stop) -> String {
    let direction = stop.row.iter().enumerate();
    let direction: Vec<_> =
        direction.map(|(i, x)| (Spoken::is_negative(x), x, format!("q{}", i + 1))).collect();
    let place = place(&stop.offset, &stop.harmonics, "");
    format!("{number}: {} >= {place}, restitution {}", sum(&direction, ""), alone(&stop.restitution, ""))
}
