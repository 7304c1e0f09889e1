//! A force known at evenly spaced times, and straight between them.

use std::f64::consts::TAU;

use serde::Serialize;

use crate::{
    error::{Error, Result},
    motion::Time,
};

/// Values of a force from phase 0 of period 0 on, evenly spaced, straight between.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Record {
    /// The step between samples: of a [`Machine`](crate::many::Machine) in its unit of time.
    pub(crate) step: f64,
    /// The samples.
    pub(crate) values: Vec<f64>,
}

/// Knots nearer than this, as a part of a step, are passed.
const NEAR: f64 = 1e-7;

impl Record {
    /// A record.
    ///
    /// # Errors
    /// Fewer than two samples; a step that is not positive; values that are not finite.
    pub fn new(step: f64, values: Vec<f64>) -> Result<Record> {
        if values.len() < 2 || !(step > 0.0 && step.is_finite()) || values.iter().any(|x| !x.is_finite()) {
            return Err(Error::input("a record needs two finite samples or more, a positive time apart"));
        }
        Ok(Record { step, values })
    }

    /// Its length, in the unit of the step.
    pub fn length(&self) -> f64 {
        self.step * (self.values.len() - 1) as f64
    }

    /// The same with time in another unit, of which there are `rate` in the old one.
    #[must_use]
    pub(crate) fn scaled(&self, rate: f64) -> Record {
        Record { step: self.step * rate, values: self.values.clone() }
    }

    /// Steps being radians: the force at a time, its slope from there on, and how long that stays; before its
    /// beginning and after its end the force is 0.
    pub(crate) fn at(&self, time: Time) -> (f64, f64, f64) {
        let now = time.period as f64 * TAU + time.phase;
        let place = now / self.step + NEAR;
        let last = self.values.len() - 1;
        if place < 0.0 {
            return (0.0, 0.0, -now);
        }
        let i = place.floor() as usize;
        if i >= last {
            return (0.0, 0.0, f64::INFINITY);
        }
        let slope = (self.values[i + 1] - self.values[i]) / self.step;
        let begun = now - i as f64 * self.step;
        (self.values[i] + slope * begun, slope, self.step - begun)
    }
}
