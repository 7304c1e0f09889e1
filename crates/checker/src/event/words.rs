//! What a certificate speaks of, in words.

use super::{
    super::motion::words::{list, system, unit, walls},
    Certificate, Contact, Event, Version,
};

/// Names and values: the event, the parameter's interval, the pattern, the impacts if there are any, the
/// contact, the box, the oscillator, its walls and its digest.
pub(super) fn detail<C: Version>(certificate: &Certificate<C>) -> Vec<(&'static str, String)> {
    let (impacts, name) = (&certificate.impacts, &certificate.name);
    let event = match &certificate.event {
        Event::SaddleNode => format!("saddle-node: a multiplier is 1, and {name} turns, nondegenerate"),
        Event::Flip => {
            format!("flip: a multiplier is -1, and 1 + trace + determinant passes through 0 as {name} varies")
        }
        Event::Grazing(contact) => {
            format!("grazing: the {} wall is touched, and the gap's minimum passes through 0", contact.side)
        }
    };
    // A certificate without an interval has not been read.
    let [from, to] = certificate.interval().map(|ends| ends.map(|end| end.to_string())).unwrap_or_default();
    let mut all = vec![
        ("event", event),
        ("parameter", format!("{name}, from {from} to {to}{}", unit(certificate.system.units))),
        ("pattern", if impacts.is_empty() { "no impact, period 1".into() } else { walls(impacts) }),
    ];
    if !impacts.is_empty() {
        all.push(("phases", list(impacts, |impact| impact.phase)));
        all.push(("speeds", list(impacts, |impact| impact.velocity)));
    }
    if let Event::Grazing(Contact { after, side, time }) = &certificate.event {
        let when = match impacts.len() {
            0 => format!("at phase {time}"),
            _ => format!("{time} after impact {}", after + 1),
        };
        all.push(("contact", format!("with the {side} wall, {when}")));
    }
    all.push((
        "box",
        format!(
            "the only event of this kind and pattern with all of these and {name} within {} of the listed values; its own are within {}",
            certificate.radius, certificate.within
        ),
    ));
    all.extend(system(&certificate.system, certificate.system.digest(), name));
    all
}
