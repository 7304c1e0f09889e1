//! The units of a scene's bare numbers, and what they are in metres, seconds and kilograms. Not here: numbers
//! that have their unit with them (`quantity`).

use super::keys::{Record, keys, words};

words! {
    /// A unit of length.
    pub enum LengthUnit {
        /// Metres.
        Metre = "m",
        /// Centimetres.
        Centimetre = "cm",
        /// Millimetres.
        Millimetre = "mm",
        /// Micrometres.
        Micrometre = "um",
        /// Inches, 25.4 mm.
        Inch = "in",
    }
}

words! {
    /// A unit of time.
    pub enum TimeUnit {
        /// Seconds.
        Second = "s",
        /// Milliseconds.
        Millisecond = "ms",
        /// Microseconds.
        Microsecond = "us",
    }
}

words! {
    /// A unit of mass.
    pub enum MassUnit {
        /// Kilograms.
        Kilogram = "kg",
        /// Grams.
        Gram = "g",
        /// Milligrams.
        Milligram = "mg",
        /// Tonnes, which go with millimetres, seconds and newtons.
        Tonne = "t",
    }
}

keys! {
    /// The units of bare numbers; written ones are converted to them. The unit of force is mass · length /
    /// time².
    pub struct UnitKeys {
        /// of displacements
        length: LengthUnit,
        /// without `period` and `frequency` a radian of the forcing
        time: TimeUnit,
        /// of masses
        mass: MassUnit,
    }
}

/// What a unit of the scene is in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SiUnits {
    /// Metres in a unit of length.
    pub length: f64,
    /// Seconds in a unit of time.
    pub time: f64,
    /// Kilograms in a unit of mass.
    pub mass: f64,
}

impl SiUnits {
    /// Metres, seconds and kilograms themselves.
    pub(super) const SI: SiUnits = SiUnits { length: 1.0, time: 1.0, mass: 1.0 };
}

impl UnitKeys {
    /// The symbols of length, time and mass.
    pub(super) fn symbols(&self) -> [&'static str; 3] {
        [self.length.word(), self.time.word(), self.mass.word()]
    }

    pub(super) fn si(&self) -> SiUnits {
        SiUnits {
            length: match self.length {
                LengthUnit::Metre => 1.0,
                LengthUnit::Centimetre => 1e-2,
                LengthUnit::Millimetre => 1e-3,
                LengthUnit::Micrometre => 1e-6,
                LengthUnit::Inch => 0.0254,
            },
            time: match self.time {
                TimeUnit::Second => 1.0,
                TimeUnit::Millisecond => 1e-3,
                TimeUnit::Microsecond => 1e-6,
            },
            mass: match self.mass {
                MassUnit::Kilogram => 1.0,
                MassUnit::Gram => 1e-3,
                MassUnit::Milligram => 1e-6,
                MassUnit::Tonne => 1e3,
            },
        }
    }
}

/// The table of units: path, what it is, keys.
pub(super) const TABLE: (&str, &str, &[super::keys::Key]) = ("`[units]`", UnitKeys::ABOUT, UnitKeys::KEYS);
