//! The options of continuation, declared once: names, meanings, defaults; and what they may be.

use super::curve::Corrector;
use crate::error::{Error, Result};

/// Hands the declaration of [`Options`] to another macro: here it becomes the struct with its defaults, in
/// `scene` a table of keys.
#[doc(hidden)]
#[macro_export]
macro_rules! with_options {
    ($use:ident) => {
        $use! {
            /// How a branch is followed. Lengths are those of the curve: impact times in radians, speeds in
            /// units of the motion's size, parameters as fractions of their range.
            pub struct Options {
                /// length of the first step
                step: f64 = 0.01,
                /// where a shorter one is needed, the branch is lost
                least_step: f64 = 1e-7,
                /// longest; a sixteenth where two events of a kind may lie in a step
                most_step: f64 = 0.1,
                /// largest angle between neighbouring tangents, radians
                turn: f64 = 0.2,
                /// most in one direction, without events
                points: u32 = 2000,
                /// a Newton step this short is the last
                tolerance: f64 = 1e-11,
                /// most Newton steps; a step that needs more is halved
                newton: u32 = 8,
                /// go on where solutions are no orbits: an impact goes out, a forbidden excursion
                beyond: bool = false,
            }
        }
    };
}

macro_rules! declare {
    ($(#[doc = $about:literal])+ pub struct $name:ident {
        $($(#[doc = $doc:literal])+ $key:ident: $type:ty = $default:expr,)*
    }) => {
        $(#[doc = $about])+
        #[derive(Debug, Clone, PartialEq)]
        pub struct $name { $($(#[doc = $doc])+ pub $key: $type,)* }

        impl Default for $name {
            fn default() -> Self {
                $name { $($key: $default,)* }
            }
        }
    };
}
with_options!(declare);

impl Options {
    /// The options, if they make sense.
    ///
    /// # Errors
    /// An input error that names the option, its value and what it may be.
    pub fn checked(&self) -> Result<Options> {
        let positive = |x: f64| x > 0.0 && x.is_finite();
        // The default of the other is not in the scene.
        let [least, step] = [("least_step", self.least_step), ("step", self.step)]
            .map(|(name, value)| format!("at least {name}, which is {value}"));
        let claims = [
            (positive(self.least_step), "least_step", self.least_step, "a positive number"),
            (positive(self.step) && self.step >= self.least_step, "step", self.step, &least),
            (positive(self.most_step) && self.most_step >= self.step, "most_step", self.most_step, &step),
            (
                positive(self.turn) && self.turn <= 1.0,
                "turn",
                self.turn,
                "an angle of more than 0 and at most 1",
            ),
            (self.points > 0, "points", self.points.into(), "at least 1"),
            ((1e-14..=1e-4).contains(&self.tolerance), "tolerance", self.tolerance, "from 1e-14 to 1e-4"),
            (self.newton > 1, "newton", self.newton.into(), "at least 2"),
        ];
        match claims.into_iter().find(|claim| !claim.0) {
            Some((_, name, value, want)) => Err(Error::input(format!("{name} = {value} must be {want}"))),
            None => Ok(self.clone()),
        }
    }

    pub(super) fn corrector(&self) -> Corrector {
        Corrector { tolerance: self.tolerance, steps: self.newton }
    }
}
