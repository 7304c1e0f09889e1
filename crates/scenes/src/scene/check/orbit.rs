//! What an orbit's keys must be, with the stops that there are.

use super::{Checked, Model};
use crate::{
    error::Result,
    many::{Machine, Stop},
    scene::orbits::{OrbitKeys, StartNumber},
};

impl Checked<'_> {
    pub(super) fn orbit(&self, orbit: &OrbitKeys, key: &str) -> Result<()> {
        let fail = |name: &str, message: &str| self.fail(&format!("{key}.{name}"), message);
        let (m, format) = (orbit.pattern.len(), self.scene.format);
        let (word, stops) = (format.stop(), format.key("orbit", "stops"));
        if m == 0 && orbit.period == 0 {
            return fail("period", "must be at least 1");
        }
        if m > 0 && self.scene.has(&self.key(&format!("{key}.period"))) {
            return fail(
                "period",
                "is of an orbit without impacts; that of a pattern is its sum: leave it out",
            );
        }
        if orbit.starts == 0 {
            return fail("starts", "must be at least 1");
        }
        match orbit.pattern.iter().try_fold(0u32, |sum, &n| sum.checked_add(n)) {
            Some(0) if m > 0 => return fail("pattern", "must have a period of at least 1"),
            None => return fail("pattern", "sums to more than 4294967295"),
            Some(_) => {}
        }
        let names: Vec<&str> = self.scene.stops.iter().map(|stop| stop.name.as_str()).collect();
        if m > 0 && names.is_empty() {
            return fail("pattern", &format!("has impacts, but the scene has no {word}"));
        }
        if orbit.stops.is_empty() && m > 0 && names.len() > 1 {
            let names = names.join(", ");
            let message =
                format!("the scene has several {word}s: name that of each impact in `{stops}`, of {names}");
            return fail("pattern", &message);
        }
        if !orbit.stops.is_empty() && orbit.stops.len() != m {
            return fail("stops", &format!("must name {m} {word}s, one for each impact"));
        }
        if let Model::Many(machine) = self.model
            && let Some(soft) = compliant(orbit, machine)
        {
            let message = format!(
                "stop {} is compliant: contact with it is no impact of a pattern, and orbits have it without being told; \
                 leave it out",
                soft.name
            );
            return fail(if orbit.stops.is_empty() { "pattern" } else { "stops" }, &message);
        }
        if orbit.speed.is_some_and(|speed| speed <= 0.0) {
            return fail(
                "speed",
                "must be above 0: it is the greatest incoming speed that a search starts from",
            );
        }
        self.start_numbers(orbit, key)
    }

    /// As many numbers as there are unknowns, times where times stand.
    fn start_numbers(&self, orbit: &OrbitKeys, key: &str) -> Result<()> {
        let m = orbit.pattern.len();
        let needed = if m > 0 { 2 * m } else { 2 * self.coordinates() };
        if !orbit.start.is_empty() && orbit.start.len() != needed {
            return self.fail(&format!("{key}.start"), &format!("must hold {needed} numbers"));
        }
        let is_time = |i: usize| m > 0 && i.is_multiple_of(2);
        let misplaced =
            |(i, number): &(usize, &StartNumber)| !is_time(*i) && matches!(number, StartNumber::Radians(_));
        let wrong = orbit.start.iter().enumerate().find(misplaced);
        match wrong {
            Some((i, _)) => self.fail(&format!("{key}.start[{}]", i + 1), "is no time: leave \"rad\" out"),
            None => Ok(()),
        }
    }
}

/// The first compliant stop on which an orbit would have an impact.
fn compliant<'m>(orbit: &OrbitKeys, machine: &'m Machine<f64>) -> Option<&'m Stop<f64>> {
    let hit = |stop: &&Stop<f64>| {
        let named = orbit.stops.iter().any(|known| known.name == stop.name);
        !orbit.pattern.is_empty() && (orbit.stops.is_empty() || named)
    };
    machine.stops.iter().filter(hit).find(|stop| !stop.law.is_rigid())
}
