//! A certificate's contents, as written and as read.

use std::fmt;

use super::{
    super::motion::text::{
        DIGITS, decimal, read_count, read_flights, read_impacts, read_matrix, read_name, read_radius,
        read_system, write_proof,
    },
    Decimal, Impact, Lines, Quotient, Rejection, Side, System, Version, Words,
};
use crate::lines::LONGEST;
use crate::rejection::ensure;

/// What happens.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Event {
    /// A multiplier is 1.
    SaddleNode,
    /// A multiplier is −1.
    Flip,
    /// A wall is touched.
    Grazing(Contact),
}

/// Where a wall is touched.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Contact {
    /// The impact that it follows, from 0; 0 if there is none.
    pub after: usize,
    /// The wall.
    pub side: Side,
    /// About how long after that impact; about the phase if there is none.
    pub time: Decimal,
}

/// All that a certificate of this kind holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Certificate<C = Quotient> {
    /// The oscillator.
    pub system: System<C>,
    /// The parameter's name.
    pub name: String,
    /// The parameter in the middle of the box.
    pub parameter: Decimal,
    /// What happens.
    pub event: Event,
    /// The pattern, and the middle of the box.
    pub impacts: Vec<Impact>,
    /// Half the side of the box in which the event is the only one.
    pub radius: Decimal,
    /// Half the side of the smaller box in which it lies.
    pub within: Decimal,
    /// The preconditioner: near the inverse of the equations' derivative.
    pub inverse: Vec<Vec<Decimal>>,
    /// For each flight, the times since its impact at which pieces end.
    pub flights: Vec<Vec<Decimal>>,
}

impl<C> Certificate<C> {
    /// The ends of the parameter's checked interval, exactly; `None` where they have too many digits.
    pub fn interval(&self) -> Option<[Decimal; 2]> {
        let minus = Decimal { digits: -self.within.digits, ..self.within };
        Some([sum(self.parameter, minus)?, sum(self.parameter, self.within)?])
    }
}

/// The exact sum, if it has at most [`DIGITS`] digits.
fn sum(a: Decimal, b: Decimal) -> Option<Decimal> {
    let mut places = a.places.max(b.places);
    let aligned = |x: Decimal| x.digits.checked_mul(10i128.checked_pow(places - x.places)?);
    let mut digits = aligned(a)?.checked_add(aligned(b)?)?;
    while places > 0 && digits % 10 == 0 {
        (digits, places) = (digits / 10, places - 1);
    }
    (digits.unsigned_abs() < 10u128.pow(DIGITS as u32)).then_some(Decimal { digits, places })
}

/// A bound of the number of exponentials that the check takes, one with a derivative counted four times: (1 +
/// 2J)(4 P + 6 m (8 m + 9)) for J harmonics in all, P pieces and m impacts.
///
/// A piece is as in a certificate of kind `orbit`. The equations take at most 3(1 + 2J) for each impact, and
/// are evaluated twice at a point and twice in each of at most 2m + 2 directions.
fn work(harmonics: u64, pieces: u64, impacts: u64) -> u64 {
    (1 + 2 * harmonics) * (4 * pieces + 6 * impacts * (8 * impacts + 9))
}

impl Event {
    /// The word for it.
    pub(super) fn name(&self) -> &'static str {
        match self {
            Event::SaddleNode => "saddle-node",
            Event::Flip => "flip",
            Event::Grazing(_) => "grazing",
        }
    }
}

/// The text of the certificate, header included.
impl<C: Version> fmt::Display for Certificate<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let system = &self.system;
        write!(f, "{}\n{}\nstatement {}\n", super::FORMAT, C::HEAD, C::STATEMENT)?;
        write!(f, "digest {}\n{system}parameter {} {}\n", system.digest(), self.name, self.parameter)?;
        writeln!(f, "event {} {}", self.event.name(), self.impacts.len())?;
        self.impacts.iter().try_for_each(|impact| writeln!(f, "{impact}"))?;
        if let Event::Grazing(Contact { after, side, time }) = &self.event {
            let after = if self.impacts.is_empty() { 0 } else { after + 1 };
            writeln!(f, "contact {after} {side} {time}")?;
        }
        writeln!(f, "radius {} {}", self.radius, self.within)?;
        write_proof(f, &self.inverse, &self.flights)
    }
}

/// Reads everything after the kind line.
pub(super) fn read<C: Version>(lines: &mut Lines) -> Result<Certificate<C>, Rejection> {
    let system: System<C> = read_system(lines, C::STATEMENT)?;
    let (name, parameter) = lines.line("parameter", |words| Ok((read_name(words)?, decimal(words)?)))?;
    let at = lines.number();
    let (event, m) = lines.line("event", |words| {
        let event = words.word("saddle-node, flip or grazing")?;
        ensure(["saddle-node", "flip", "grazing"].contains(&event), "expected saddle-node, flip or grazing")?;
        Ok((event.to_string(), read_count(words)?))
    })?;
    let free = m == 0 && C::WITHOUT_IMPACTS && event == "grazing";
    let impacts = if free { Vec::new() } else { read_impacts(lines, &system, m)? };
    let event = match event.as_str() {
        "saddle-node" => Event::SaddleNode,
        "flip" => Event::Flip,
        _ => Event::Grazing(lines.line("contact", |words| contact(words, &system, m))?),
    };
    let (radius, within) = read_radius(lines)?;
    let size = 2 * impacts.len() + if matches!(event, Event::Grazing(_)) { 2 } else { 1 };
    let inverse = read_matrix(LONGEST, lines, size)?;
    let flights =
        read_flights(lines, impacts.len().max(1), |pieces| work(system.harmonics(), pieces, m.max(1)))?;
    let certificate =
        Certificate { system, name, parameter, event, impacts, radius, within, inverse, flights };
    if certificate.interval().is_none() {
        let reason = format!("P - W and P + W have more than {DIGITS} digits");
        return Err(Rejection::Malformed { line: at, reason });
    }
    Ok(certificate)
}

fn contact<C>(words: &mut Words, system: &System<C>, impacts: u64) -> Result<Contact, String> {
    let after = words.number("an impact", impacts)?;
    ensure(after > 0 || impacts == 0, "impacts are counted from 1")?;
    let side = Side::read(words)?;
    ensure(system.has(side), format_args!("there is no {side} wall"))?;
    Ok(Contact { after: (after as usize).saturating_sub(1), side, time: decimal(words)? })
}
