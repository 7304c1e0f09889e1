//! Version 2: the motion without impacts, which is the response to the forcing.
//!
//! It is a sum of harmonics about the displacements K⁻¹f₀, and so is every gap: nothing is integrated, and
//! there is no box. Its multipliers are those of the flow over one period, and it is the only motion without
//! impacts that comes back after one unless 1 is among them.

use std::fmt;

use super::{
    super::motion::{
        Interval,
        krawczyk::enclosed,
        pattern::{follow, turns},
        text::{read_digested, read_flights, write_flight},
    },
    Claim, Decimal, FORMAT, Fault, KIND, Lines, Machine, Proved, Rejection, STATEMENT_2,
    cycle::state_part,
    motion::Motion,
    proof::{multipliers_are, without_one},
    text::{List, read_machine, read_scales, work},
    words::machine,
};
use crate::rejection::{GoOn, claim};

/// All that a certificate of a motion without impacts holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FreeCertificate {
    /// The machine.
    pub machine: Machine,
    /// The claim about stability.
    pub claim: Claim,
    /// The unit of each displacement, then of each velocity, in which powers of the flow shrink.
    pub scales: Vec<Decimal>,
    /// The times since phase 0 at which the pieces of the period end.
    pub pieces: Vec<Decimal>,
}

/// The text of the certificate, header included.
impl fmt::Display for FreeCertificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let machine = &self.machine;
        write!(f, "{FORMAT}\nkind {KIND} 2\nstatement {STATEMENT_2}\n")?;
        write!(f, "digest {}\n{machine}orbit 0 {}\n", machine.digest(), self.claim)?;
        writeln!(f, "scales{}", List(&self.scales))?;
        write_flight(f, &self.pieces)
    }
}

/// Checks everything after the kind line.
pub(in super::super) fn check(lines: &mut Lines) -> Result<Proved, Rejection> {
    let certificate = read(lines)?;
    prove(&certificate, &mut || lines.go_on()).map_err(|fault| lines.rejection(fault))?;
    let claim = certificate.claim.said().to_string();
    let orbit = [("stability", claim), ("pattern", "no impact, period 1".to_string())];
    let detail = orbit.into_iter().chain(machine(&certificate.machine)).collect();
    Ok(Proved::plain(Some(1..=1), detail))
}

/// Reads everything after the kind line.
fn read(lines: &mut Lines) -> Result<FreeCertificate, Rejection> {
    let machine = read_digested(lines, STATEMENT_2, "machine", read_machine)?;
    let claim = lines.line("orbit", |words| {
        words.number("the number of impacts", 0)?;
        Claim::read(words)
    })?;
    let scales = read_scales(lines, machine.size())?;
    // Beside the pieces the flow, counted as an impact.
    let work = |pieces| work(machine.size() as u64, machine.harmonics(), pieces, 1);
    let pieces = read_flights(lines, 1, work)?.swap_remove(0);
    Ok(FreeCertificate { machine, claim, scales, pieces })
}

/// That the motion exists, is alone, meets no stop, and is as stable as is claimed.
fn prove(certificate: &FreeCertificate, go_on: GoOn) -> Result<(), Fault> {
    let FreeCertificate { machine, claim: wanted, scales, pieces } = certificate;
    let motion = Motion::new(machine, go_on)?;
    let around = state_part(&motion.flow(turns(1)));
    // Of a stable one no multiplier is 1, which `multipliers_are` shows.
    let alone = *wanted == Claim::Stable || without_one(&around).is_some();
    claim(alone, "1 may be a multiplier of the motion without impacts")?;
    let singular = || Fault::False("the stiffness may be singular".into());
    let rest = motion.rest().ok_or_else(singular)?;
    follow(1, turns(1), pieces, go_on, |from, to, _| {
        let doubtful = |stop: &usize| !is_open(&motion, *stop, &rest, from.until(to));
        (0..motion.contacts.len()).find(doubtful).map(|stop| format!("the gap to stop {}", stop + 1))
    })?;
    multipliers_are(*wanted, &around, &enclosed(scales), go_on)
}

/// With r half the length of a piece and m its middle, z lies in z(m) + z′(m)[−r, r] + z″[0, r²/2].
fn is_open(motion: &Motion, stop: usize, rest: &[Interval], whole: Interval) -> bool {
    let middle = whole.middle();
    let away = whole - middle;
    let [gap, slope, _] = motion.free_gap(stop, rest, middle);
    let [_, _, bend] = motion.free_gap(stop, rest, whole);
    (gap + slope * away + bend * away.squared().shifted_down(1)).is_positive()
}
