//! The backbone curves of several coordinates, for the task `response`: the free vibrations that grow from
//! each mode, over the drive's frequency.

use std::f64::consts::TAU;

use super::{
    Job,
    backbone::{Backbone, BackboneEndRow, BackboneRow},
};
use crate::{
    continuation::CurveEnd,
    error::{Error, Result},
    many::{
        Machine,
        families::{ModeFamily, families},
    },
    rounding::PLACE,
    scene::response::ResponseTask,
};

/// The curves between two values of the drive's frequency, and where each ends.
///
/// # Errors
/// Those of the machine at a value and of [`families`]; an input error over another parameter; an
/// interruption.
pub(super) fn of_several(
    task: &ResponseTask,
    job: &Job,
    names: &[String],
    [low, high]: [f64; 2],
    is_frequency: bool,
    at: &dyn Fn(f64) -> Result<Machine<f64>>,
) -> Result<Backbone> {
    if !is_frequency {
        return Err(Error::input(format!(
            "backbone = true: of several coordinates it is over the drive's frequency, and {} is another parameter",
            task.parameter
        )));
    }
    let base = at(low)?;
    let asked = Asked { low, high, harmonic: task.harmonic, base: &base, at };
    let ends = [asked.radians(low)?, asked.radians(high)?];
    let free = base.freed();
    let [least, most] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
    let found = families(&base, &job.planar(&free, &[], &[])?, [least, most], &mut || job.check())?;
    let inside = |period: f64| least * (1.0 - PLACE) <= period && period <= most * (1.0 + PLACE);
    let (mut rows, mut told) = (Vec::new(), Vec::new());
    for ModeFamily { mode, natural, vibrations, end } in &found {
        let mode = *mode;
        let mut say = |value: f64, swings: &[f64], why| {
            told.extend(names.iter().zip(swings).map(|(coordinate, swing)| BackboneEndRow {
                value,
                swing: Some(*swing),
                why,
                coordinate: coordinate.clone(),
                mode,
            }));
        };
        let is_in = |i: usize| vibrations.get(i).is_some_and(|there| inside(there.period));
        for (i, here) in vibrations.iter().enumerate().filter(|(_, here)| inside(here.period)) {
            let value = asked.value(here.period, ends)?;
            if i == 0 && inside(*natural) {
                say(asked.value(*natural, ends)?, &vec![0.0; names.len()], "natural frequency");
            } else if i > 0 && !is_in(i - 1) {
                say(value, &here.swings, "range");
            }
            rows.extend(names.iter().zip(&here.swings).map(|(coordinate, swing)| BackboneRow {
                value,
                swing: *swing,
                coordinate: coordinate.clone(),
                mode,
                energy: Some(here.energy),
            }));
            if !is_in(i + 1) {
                let why = match end {
                    _ if i + 1 < vibrations.len() => "range",
                    Some(CurveEnd::Fails) => "stop",
                    Some(CurveEnd::Bound) => "range",
                    Some(CurveEnd::Points) => "points",
                    _ => "lost",
                };
                say(value, &here.swings, why);
            }
        }
    }
    let why = rows.is_empty().then(|| {
        let word = match found.iter().all(|family| family.end.is_none()) {
            true => "vibrations of all swings have the frequencies of the modes, as of linear springs",
            false => "no free vibration has that frequency at any of the values",
        };
        word.to_string()
    });
    Ok(Backbone { rows: Some(rows), ends: Some(told), why })
}

/// What is asked for: the drive's period, over a harmonic, between two values.
struct Asked<'a> {
    low: f64,
    high: f64,
    harmonic: u32,
    base: &'a Machine<f64>,
    at: &'a dyn Fn(f64) -> Result<Machine<f64>>,
}

impl Asked<'_> {
    /// The period that is asked for at a value, in radians of the drive at the first.
    fn radians(&self, value: f64) -> Result<f64> {
        Ok((self.at)(value)?.period / self.base.period / f64::from(self.harmonic) * TAU)
    }

    /// The value at which a period is asked for, by halving, from what is at both ends.
    fn value(&self, period: f64, ends: [f64; 2]) -> Result<f64> {
        for (end, value) in ends.into_iter().zip([self.low, self.high]) {
            if (period - end).abs() <= PLACE * end {
                return Ok(value);
            }
        }
        let (mut a, mut b) = (self.low, self.high);
        loop {
            let middle = a + (b - a) / 2.0;
            if middle <= a || middle >= b {
                return Ok(middle);
            }
            *(if (self.radians(middle)? < period) == (ends[0] < ends[1]) { &mut a } else { &mut b }) = middle;
        }
    }
}
