//! The backbone curves of several coordinates, for the task `response`: the free vibrations that grow from
//! each mode, over the drive's frequency.

use std::f64::consts::TAU;

use super::{
    Job,
    backbone::{Backbone, BackboneEndRow, BackboneRow},
};
use crate::{
    attractor::dynamics::Dynamics,
    continuation::CurveEnd,
    error::{Error, Result},
    many::{
        Machine,
        families::{ModeFamily, families},
        section::PlanarMachine,
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
    let [base, other] = [at(low)?, at(high)?];
    let [free, far] = [base.freed(), other.freed()];
    let planar = job.planar(&free, &[], &[])?;
    // The drive's own period changes, or the machine is written in units in which it does not.
    if base.period == other.period && !is_slower(&planar, &job.planar(&far, &[], &[])?, high / low)? {
        return Err(Error::input(format!(
            "backbone = true: of several coordinates it is over the drive's frequency, and {} changes more of the forces than that",
            task.parameter
        )));
    }
    let radians = |value: f64| TAU / f64::from(task.harmonic) * low / value;
    let value = |period: f64| radians(low) / period * low;
    let [least, most] = [radians(high).min(radians(low)), radians(high).max(radians(low))];
    let found = families(&base, &planar, [least, most], &mut || job.check())?;
    let inside = |period: f64| least * (1.0 - PLACE) <= period && period <= most * (1.0 + PLACE);
    let (mut rows, mut told) = (Vec::new(), Vec::new());
    for ModeFamily { mode, natural, vibrations, end, largest } in &found {
        let mode = *mode;
        let mut say = |value: f64, swings: &[f64], why| {
            told.extend(names.iter().zip(swings).map(|(coordinate, swing)| BackboneEndRow {
                value,
                swing: (why != "largest swings").then_some(*swing),
                why,
                coordinate: coordinate.clone(),
                mode,
            }));
        };
        let is_in = |i: usize| vibrations.get(i).is_some_and(|there| inside(there.period));
        let still = vec![0.0; names.len()];
        if vibrations.is_empty() && inside(*natural) {
            let why = if end.is_none() { "linear" } else { "lost" };
            say(value(*natural), &still, why);
        }
        for (i, here) in vibrations.iter().enumerate().filter(|(_, here)| inside(here.period)) {
            let at = value(here.period);
            if i == 0 && inside(*natural) {
                say(value(*natural), &still, "natural frequency");
            } else if i == 0 || !is_in(i - 1) {
                say(at, &here.swings, "range");
            }
            rows.extend(names.iter().zip(&here.swings).map(|(coordinate, swing)| BackboneRow {
                value: at,
                swing: *swing,
                coordinate: coordinate.clone(),
                mode,
                energy: Some(here.energy),
            }));
            let grows = largest.filter(|period| i + 1 == vibrations.len() && inside(*period));
            if let Some(period) = grows {
                say(value(period), &here.swings, "largest swings");
            } else if !is_in(i + 1) {
                let why = match end {
                    _ if i + 1 < vibrations.len() => "range",
                    Some(CurveEnd::Fails) => "stop",
                    Some(CurveEnd::Bound) => "range",
                    Some(CurveEnd::Points) => "points",
                    _ => "lost",
                };
                say(at, &here.swings, why);
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

/// Whether all accelerations from rest are so many times less, squared, in the other machine: at places along
/// each coordinate, of sizes from 2⁻³⁰ to 2³⁰.
fn is_slower(machine: &PlanarMachine, other: &PlanarMachine, times: f64) -> Result<bool> {
    let n = machine.dimension() / 2;
    for i in 0..n {
        for exponent in (-30..=30).step_by(3) {
            for sign in [1.0, -1.0] {
                let mut place = vec![0.0; 2 * n];
                place[i] = sign * 2f64.powi(exponent);
                let pull = |planar: &PlanarMachine| {
                    let motion = planar.begin(&planar.at(&place, 0.0)).ok()?;
                    planar.field(&motion).map(|field| field[n..].to_vec())
                };
                let (Some(one), Some(two)) = (pull(machine), pull(other)) else { continue };
                let size = one.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
                let differ = |(a, b): (&f64, &f64)| (a - b * times * times).abs() > PLACE * size;
                if one.iter().zip(&two).any(differ) {
                    return Ok(false);
                }
            }
        }
    }
    Ok(true)
}
