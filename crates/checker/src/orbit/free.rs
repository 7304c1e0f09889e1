//! Version 3: the motion without impacts, which is the response to the forcing.
//!
//! It is a sum of harmonics about its mean F/k, and so is every gap, with all its derivatives: nothing is
//! integrated, and there is no box. Its multipliers are e^2πλ, λ the roots of λ² + cλ + k. Both are in the
//! left half plane iff c > 0 and k > 0, and one is in the right one if c < 0 or k < 0. It is the only motion
//! without impacts that comes back after 2π unless 1 is a multiplier, λ = iν for a whole number ν: unless
//! k = 0, or c = 0 and k = ν².

use std::fmt;

use super::{
    super::motion::{
        Interval,
        oscillator::Oscillator,
        pattern::{follow, turns},
        text::{Coefficient, read_flights, read_system, write_flight},
        words::system,
    },
    Claim, Decimal, FORMAT, Fault, Lines, Proved, Range, Rejection, STATEMENT_3, Side, System, text,
};
use crate::rejection::{GoOn, claim};

/// The line of the kind.
const HEAD: &str = "kind orbit 3";

/// All that a certificate of a motion without impacts holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FreeCertificate {
    /// The oscillator.
    pub system: System<Range>,
    /// The claim about stability.
    pub claim: Claim,
    /// The times since phase 0 at which the pieces of the period end.
    pub pieces: Vec<Decimal>,
}

/// The text of the certificate, header included.
impl fmt::Display for FreeCertificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let system = &self.system;
        write!(f, "{FORMAT}\n{HEAD}\nstatement {STATEMENT_3}\n")?;
        write!(f, "digest {}\n{system}orbit 0 {}\n", system.digest(), self.claim)?;
        write_flight(f, &self.pieces)
    }
}

/// Checks everything after the kind line.
pub(in super::super) fn check(lines: &mut Lines) -> Result<Proved, Rejection> {
    let certificate = read(lines)?;
    prove(&certificate, &mut || lines.go_on()).map_err(|fault| lines.rejection(fault))?;
    let FreeCertificate { system: own, claim, .. } = &certificate;
    let orbit = [("stability", claim.said().to_string()), ("pattern", "no impact, period 1".to_string())];
    let detail = orbit.into_iter().chain(system(own, own.digest(), "")).collect();
    Ok(Proved::plain(Some(1..=1), detail))
}

/// Reads everything after the kind line.
fn read(lines: &mut Lines) -> Result<FreeCertificate, Rejection> {
    let system: System<Range> = read_system(lines, STATEMENT_3)?;
    let claim = lines.line("orbit", |words| {
        words.number("the number of impacts", 0)?;
        Claim::read(words)
    })?;
    let pieces = read_flights(lines, 1, |pieces| text::work(system.harmonics(), pieces, 0))?.swap_remove(0);
    Ok(FreeCertificate { system, claim, pieces })
}

/// That the motion exists, is alone, meets no wall, and is as stable as is claimed.
fn prove(certificate: &FreeCertificate, go_on: GoOn) -> Result<(), Fault> {
    let FreeCertificate { system, claim: wanted, pieces } = certificate;
    let oscillator = Oscillator::<Interval>::new(system, Interval::ZERO).map_err(Fault::False)?;
    let [damping, stiffness] = [&system.damping, &system.stiffness].map(|x| x.enclosed(Interval::ZERO));
    claim(is_alone(damping, stiffness), "1 may be a multiplier of the motion without impacts")?;
    follow(1, turns(1), pieces, go_on, |from, to, _| {
        let doubtful = |side: &Side| !is_open(&oscillator, *side, from.until(to));
        oscillator.sides().find(doubtful).map(|side| format!("the gap to the {side} wall"))
    })?;
    let holds = match wanted {
        Claim::Stable => damping.is_positive() && stiffness.is_positive(),
        Claim::Unstable => (-damping).is_positive() || (-stiffness).is_positive(),
        Claim::Open => true,
    };
    claim(holds, format_args!("the orbit is not certainly {wanted}"))
}

/// Whether no iν is a root of λ² + cλ + k, ν a whole number. Coefficients are below 2³⁰ = 32768².
fn is_alone(damping: Interval, stiffness: Interval) -> bool {
    let is_apart = |x: Interval| x.is_positive() || (-x).is_positive();
    let squares = || (1..1 << 15).map(|n: u64| Interval::integer(n * n));
    is_apart(stiffness) && (is_apart(damping) || squares().all(|square| is_apart(stiffness - square)))
}

/// With r half the length of a piece and m its middle, z lies in z(m) + z′(m)[−r, r] + z″[0, r²/2].
fn is_open(oscillator: &Oscillator<Interval>, side: Side, whole: Interval) -> bool {
    let middle = whole.middle();
    let away = whole - middle;
    let [gap, slope, _] = oscillator.free_gap(side, middle);
    let [_, _, bend] = oscillator.free_gap(side, whole);
    (gap + slope * away + bend * away.squared().shifted_down(1)).is_positive()
}
