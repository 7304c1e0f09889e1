//! The keys of the system: its equation of motion, its stops, the accuracy of its motions.

use super::{
    expression::Expression,
    force::{ForceList, FunctionText},
    keys::{Entry, Key, Record, Value, keys, words},
    law::{CoefficientKey, LawKey},
    matrix::{CoordinateList, MatrixValue},
    measured::{MeasuredKeys, MeasuredMotionKeys},
    restitution::RestitutionKey,
};
use crate::{
    error::Result,
    motion::{Harmonic, Side},
};

/// The highest multiple of the base frequency.
const LIMIT_K: u32 = 1000;

keys! {
    /// `mass` q″ + `damping` q′ + `stiffness` q + `cubic` q³ = `force` + `forcing`(t), in consistent units.
    pub struct SystemKeys {
        /// the forcing's, in which times are reported, with forcing or without; without it and `frequency` 2π
        period: Option<Expression>,
        /// in place of `period`, cycles per unit of time: hertz if that is a second
        frequency: Option<Expression>,
        /// symmetric, positive definite; without it and `modes` 1, of one coordinate
        mass: Option<MatrixValue>,
        /// the damping
        damping: Option<MatrixValue>,
        /// instead of `damping`, of every mode, or a list by frequency ascending
        damping_ratio: Option<CoordinateList>,
        /// the stiffness
        stiffness: Option<MatrixValue>,
        /// of one coordinate, the coefficient of q³ (Duffing)
        cubic: Option<Expression>,
        /// instead of matrices
        modes: Option<ModesKeys>,
        /// on each coordinate, beside `forcing`: a constant or a [formula](#forces)
        force: ForceList = "0",
        /// its harmonics
        forcing: Vec<LoadKeys> = "[]",
        /// instead of `forcing`, a [record](#measured-forces); its mean adds to `force`
        measured: Option<MeasuredKeys>,
    }
}

keys! {
    /// A term `cos` cos 2πkt/T + `sin` sin 2πkt/T of the force, T its period.
    pub struct LoadKeys {
        /// multiple of the base frequency, 1 to 1000
        k: u32 = "1",
        /// coefficients of the cosine; one 0 for none
        cos: CoordinateList = "0",
        /// of the sine
        sin: CoordinateList = "0",
    }
}

keys! {
    /// The modes of a system, of modal mass 1.
    pub struct ModesKeys {
        /// in the unit of `frequency`
        frequencies: Vec<Expression>,
        /// damping ratios: one for all, or one each
        ratios: CoordinateList = "0",
        /// a row per point of the machine (a coordinate), an entry per mode; without it the amplitudes are
        /// the coordinates
        shapes: Option<MatrixValue>,
    }
}

keys! {
    /// A stop, rigid with `restitution`, compliant with `stiffness` or `law`. Its gap is z = `row`·q −
    /// `offset` − Σ `harmonics`.
    pub struct StopKeys {
        /// without it its side, or its number
        name: Option<String>,
        /// of one coordinate: q stays above, or below, `offset` + Σ `harmonics`
        side: Option<Side>,
        /// in place of `side`, an entry per coordinate: two masses that hit each other [1, −1]; of one
        /// coordinate [1] if absent
        row: Option<CoordinateList>,
        /// mean place
        offset: Expression,
        /// its motion, in multiples of the forcing's frequency
        harmonics: Vec<HarmonicKeys> = "[]",
        /// instead of `harmonics`, a [record](#measured-forces); its mean adds to `offset`
        measured: Option<MeasuredMotionKeys>,
        /// at least 0, or a rational function of the impact's speed v, as "1/(1 + v/2)"
        restitution: Option<RestitutionKey>,
        /// compliant: force per displacement along `row`, above 0
        stiffness: Option<Expression>,
        /// compliant: force per velocity, at least 0; without it 0
        damping: Option<Expression>,
        /// compliant: the force in depth d and closing speed v, as "k*d^1.5*(1 + c*v)"
        law: Option<LawKey>,
        /// volume worn off per energy that contacts take
        wear: Option<Expression>,
    }
}

keys! {
    /// [Dry friction](#dry-friction) (Coulomb, Stribeck) along `row`.
    pub struct FrictionKeys {
        /// what it is called in reports; without it `friction`, with a number if there are several
        name: Option<String>,
        /// what slides, as of a stop
        row: Option<CoordinateList>,
        /// the normal force, at least 0; this or `stop`
        normal: Option<Expression>,
        /// the name of the stop on which it slides
        stop: Option<String>,
        /// of kinetic friction, at least 0; a law of the sliding speed v goes with `normal`
        coefficient: CoefficientKey,
        /// that of static friction, at least `coefficient` (at v = 0); without it the same
        static_coefficient: Option<Expression>,
        /// of the surface, as of a belt
        speed: Expression = "0",
        /// the surface's vibration along `row`
        harmonics: Vec<HarmonicKeys> = "[]",
    }
}

keys! {
    /// A [threshold](#events), which tasks `simulate` and `section` tell.
    pub struct EventKeys {
        /// what it is called in reports; without it `event`, with a number if there are several
        name: Option<String>,
        /// what passes 0, as "u1 - u2 + 0.1*cos(t)"
        of: FunctionText,
        /// whether a motion ends there, after the transient
        end: bool = "false",
    }
}

keys! {
    /// A term `cos` cos 2πkt/T + `sin` sin 2πkt/T of a motion, T the forcing's period.
    pub struct HarmonicKeys {
        /// multiple of the base frequency, 1 to 1000
        k: u32 = "1",
        /// of the cosine
        cos: Expression = "0",
        /// of the sine
        sin: Expression = "0",
    }
}

keys! {
    /// How accurately motions are computed.
    pub struct Accuracy {
        /// the integrator's, relative to the motion: engine `one`, not linear
        tolerance: f64 = "1e-12",
        /// a deeper minimum of a gap is an impact, a shallower one a tangency; length; without it 10⁻¹² of
        /// the gaps' motion
        minimum_depth: Option<f64>,
    }
}

words! {
    /// What computes a scene's motions.
    pub enum EngineKey {
        /// `one` where the system qualifies, else `many`.
        Auto = "auto",
        /// The engine for one degree of freedom and rigid stops.
        One = "one",
        /// The engine for any number of coordinates, and for compliant stops.
        Many = "many",
    }
}

impl Value for Side {
    fn shape() -> String {
        "`\"lower\"` or `\"upper\"`".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        entry.word(&[Side::Lower, Side::Upper].map(|side| (side.name(), side)))
    }
}

/// Refuses a multiple that is out of range or stands among those before.
pub(super) fn check_k(place: &Entry, k: u32, mut before: impl Iterator<Item = u32>) -> Result<()> {
    if !(1..=LIMIT_K).contains(&k) {
        return Err(place.fail(&format!("k is {k}; it goes from 1 to {LIMIT_K}")));
    }
    if before.any(|other| other == k) {
        return Err(place.fail(&format!("k = {k} stands here twice; add the two terms up")));
    }
    Ok(())
}

/// Harmonics, each multiple once.
pub(super) fn harmonics(
    file: &Entry,
    list: Vec<HarmonicKeys>,
    path: &str,
) -> Result<Vec<Harmonic<Expression>>> {
    for (i, harmonic) in list.iter().enumerate() {
        let place = file.at(&format!("{path}[{}]", i + 1));
        check_k(&place, harmonic.k, list[..i].iter().map(|other| other.k))?;
    }
    Ok(list.into_iter().map(|h| Harmonic { k: h.k, cos: h.cos, sin: h.sin }).collect())
}

/// An expression made of another's text, reported at its key.
pub(super) fn derived(file: &Entry, from: &Expression, text: impl Fn(&str) -> String) -> Result<Expression> {
    let mut derived = Expression::parse(&text(&from.to_string()), file.scope.names)?;
    derived.key.clone_from(&from.key);
    Ok(derived)
}

/// The tables of the system: path, what it is, keys.
pub(super) const TABLES: &[(&str, &str, &[Key])] = &[
    ("`[system]`", SystemKeys::ABOUT, SystemKeys::KEYS),
    ("an entry of `forcing`", LoadKeys::ABOUT, LoadKeys::KEYS),
    ("`measured`", MeasuredKeys::ABOUT, MeasuredKeys::KEYS),
    ("`modes`", ModesKeys::ABOUT, ModesKeys::KEYS),
    ("`[[stops]]`", StopKeys::ABOUT, StopKeys::KEYS),
    ("`measured` of a stop", MeasuredMotionKeys::ABOUT, MeasuredMotionKeys::KEYS),
    ("`[[friction]]`", FrictionKeys::ABOUT, FrictionKeys::KEYS),
    ("`[[events]]`", EventKeys::ABOUT, EventKeys::KEYS),
    ("an entry of `harmonics`", HarmonicKeys::ABOUT, HarmonicKeys::KEYS),
    ("`[accuracy]`", Accuracy::ABOUT, Accuracy::KEYS),
];
