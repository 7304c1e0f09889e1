//! How a curve is followed: one struct, checked once.

use super::curve::Corrector;
use crate::error::{Error, Result};

macro_rules! options {
    ($($(#[doc = $doc:literal])+ $field:ident: $type:ty = $default:expr, $unit:literal;)*) => {
        /// How a curve is followed. Lengths are those of the curve in its unknowns: impact times in radians of the forcing
        /// period, speeds as they are, and the parameter as a fraction of its range.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct Options { $($(#[doc = $doc])+ pub $field: $type,)* }

        impl Default for Options {
            fn default() -> Self {
                Options { $($field: $default,)* }
            }
        }

        impl Options {
            /// Name, unit, default and meaning of every option, as a table in Markdown.
            pub fn reference() -> String {
                let mut table = String::from("| option | unit | default | meaning |\n| --- | --- | --- | --- |\n");
                let default = Options::default();
                $(table.push_str(&format!(
                    "| `{}` | {} | {:?} | {} |\n", stringify!($field), $unit, default.$field, concat!($($doc),+).trim()
                ));)*
                table
            }
        }
    };
}

options! {
    /// the length of the first step
    step: f64 = 0.01, "length";
    /// no step is shorter; where one would have to be, the curve is lost
    least_step: f64 = 1e-7, "length";
    /// no step is longer
    most_step: f64 = 0.1, "length";
    /// the largest angle between the tangents of neighbouring points
    turn: f64 = 0.2, "radians";
    /// most points in one direction, events not counted
    points: usize = 2000, "points";
    /// a Newton step no longer than this is the last one
    tolerance: f64 = 1e-11, "length";
    /// most Newton steps for a point; a step of the curve that needs more is halved
    newton: u32 = 7, "steps";
    /// go on where the solutions are no orbits: an impact going out, a forbidden excursion
    beyond: bool = false, "true or false";
}

impl Options {
    /// The options, if they make sense.
    ///
    /// # Errors
    /// An input error that names the option, its value and what it may be.
    pub fn checked(self) -> Result<Options> {
        let fail = |name: &str, value: &dyn std::fmt::Debug, want: &str| {
            Err(Error::input(format!("{name} = {value:?}: {want}")))
        };
        if !(self.least_step > 0.0 && self.least_step.is_finite()) {
            return fail("least_step", &self.least_step, "write a positive number");
        }
        if !(self.step >= self.least_step) {
            return fail("step", &self.step, &format!("write at least least_step = {:?}", self.least_step));
        }
        if !(self.most_step >= self.step && self.most_step.is_finite()) {
            return fail("most_step", &self.most_step, &format!("write at least step = {:?}", self.step));
        }
        if !(self.turn > 0.0 && self.turn <= 1.0) {
            return fail("turn", &self.turn, "write an angle of more than 0 and at most 1");
        }
        if self.points == 0 {
            return fail("points", &self.points, "write at least 1");
        }
        if !(1e-14..=1e-4).contains(&self.tolerance) {
            return fail("tolerance", &self.tolerance, "write a number from 1e-14 to 1e-4");
        }
        if self.newton < 2 {
            return fail("newton", &self.newton, "write at least 2");
        }
        Ok(self)
    }

    pub(super) fn corrector(&self) -> Corrector {
        Corrector { tolerance: self.tolerance, steps: self.newton }
    }
}
