//! Scenes of format 2: machines with any number of degrees of freedom and of stops, in the units in which
//! they are measured.

use super::{
    expression::Expression,
    force::ForceList,
    keys::{Entry, Key, Record, keys},
    matrix::{CoordinateList, MatrixValue},
    measured::{MeasuredForce, MeasuredKeys},
    restitution::RestitutionKey,
    system::{HarmonicKeys, check_k, harmonics},
};
use crate::{
    error::Result,
    many::{Load, Machine, Stop, StopLaw},
    motion::Wall,
};

keys! {
    /// `mass` q″ + `damping` q′ + `stiffness` q = `force` + `forcing`(t), in consistent units of your choice:
    /// kilograms, metres, seconds and newtons, say.
    pub struct MachineKeys {
        /// how often the forcing repeats in a unit of time (hertz if times are seconds); this or `period`
        /// must be given, also without forcing, as times are reported in periods, too
        frequency: Option<Expression>,
        /// how long the forcing's period is
        period: Option<Expression>,
        /// the masses: symmetric, positive definite; this or `modes` must be given
        mass: Option<MatrixValue>,
        /// the stiffness
        stiffness: Option<MatrixValue>,
        /// the damping
        damping: Option<MatrixValue>,
        /// instead of `damping`, the damping ratio of every mode, or a list of them by frequency ascending
        damping_ratio: Option<CoordinateList>,
        /// instead of matrices, the modes of the machine
        modes: Option<ModesKeys>,
        /// the force on each coordinate beside `forcing`, one 0 for none: a constant, or any smooth function
        /// of the coordinates q1, q2, …, their velocities u1, u2, … per unit of time, and t, the angle of the
        /// forcing, 2π in a period; with one coordinate q and u will do
        force: ForceList = "0",
        /// the harmonics of the force
        forcing: Vec<LoadKeys> = "[]",
        /// instead of `forcing`, a measured force: harmonics are fitted to it, its mean is added to `force`;
        /// or it is taken as it is, once
        measured: Option<MeasuredKeys>,
    }
}

keys! {
    /// A term `cos` cos 2πkt/T + `sin` sin 2πkt/T of the force, T its period.
    pub struct LoadKeys {
        /// the multiple of the base frequency, 1 to 1000
        k: u32 = "1",
        /// the coefficients of the cosine, one for each coordinate; one 0 for none
        cos: CoordinateList = "0",
        /// the coefficients of the sine
        sin: CoordinateList = "0",
    }
}

keys! {
    /// The modes of a machine, of modal mass 1.
    pub struct ModesKeys {
        /// their frequencies, in the unit of `frequency`
        frequencies: Vec<Expression>,
        /// their damping ratios: one for all, or one for each
        ratios: CoordinateList = "0",
        /// their shapes: a row for each coordinate q₁, q₂, … of the scene, an entry in it for each mode; the
        /// coordinates are points of the machine where forces act, stops stand or motions are looked at.
        /// Without it the coordinates are the modes' amplitudes
        shapes: Option<MatrixValue>,
    }
}

keys! {
    /// A stop for the gap z = `row`·q − `offset` − Σ `harmonics`. With `restitution` it is rigid: z stays at
    /// least 0, and an impact turns z′ into −`restitution` times itself. With `stiffness` it gives way: where
    /// z is negative it pushes with the force −`stiffness` z − `damping` z′, until that would pull.
    pub struct StopKeys {
        /// what it is called in reports
        name: Option<String>,
        /// what of the machine it stops, an entry for each coordinate; [1] for one coordinate. Two masses
        /// that hit each other: [1, −1]
        row: Option<CoordinateList>,
        /// its mean place
        offset: Expression,
        /// its motion, harmonics of the forcing's frequency; none for a stop that stands still
        harmonics: Vec<HarmonicKeys> = "[]",
        /// at least 0: 0 for a stop that takes all velocity, 1 for one that keeps the energy; or a rational
        /// function of the speed v of the impact, as "1/(1 + v/2)". This or `stiffness` must be given
        restitution: Option<RestitutionKey>,
        /// of a stop that gives way, the force per displacement along `row`, above 0
        stiffness: Option<Expression>,
        /// of a stop that gives way, the force per velocity, at least 0; without it 0
        damping: Option<Expression>,
    }
}

keys! {
    /// How accurately motions of machines are computed.
    pub struct MachineAccuracy {
        /// a minimum of a gap that is deeper than this is an impact; a shallower one is a tangency. In the
        /// unit of gaps; without it 10⁻¹² of the gaps' motion
        minimum_depth: Option<f64>,
    }
}

/// Most coordinates and modes.
const MOST: usize = 2000;

/// What a scene of format 2 has in place of [`System`](crate::motion::System).
#[derive(Debug, Clone, PartialEq)]
pub struct MachineScene {
    /// Its coefficients.
    pub machine: Machine<Expression>,
    /// The minimum depth, if it is given.
    pub minimum_depth: Option<f64>,
    /// The measured force, which is among the machine's own loads, too.
    pub measured: Option<MeasuredForce>,
}

impl MachineScene {
    /// Checks what stands in the file's tables against one another.
    pub(super) fn new(
        file: &Entry,
        keys: MachineKeys,
        walls: Vec<StopKeys>,
        accuracy: &MachineAccuracy,
    ) -> Result<Self> {
        let at = |path: &str| file.at(path);
        let once = match &keys.measured {
            Some(measured) if measured.once => Some(MeasuredForce::once(file, measured)?),
            _ => None,
        };
        let period = period(file, keys.frequency, keys.period, once.as_ref())?;
        let mut machine = Machine {
            size: 0,
            period,
            mass: Vec::new(),
            damping: Vec::new(),
            damping_ratio: Vec::new(),
            stiffness: Vec::new(),
            shapes: Vec::new(),
            force: Vec::new(),
            forcing: Vec::new(),
            smooth: Vec::new(),
            record: None,
            stops: Vec::new(),
        };
        match (keys.mass, keys.modes) {
            (Some(mass), None) => {
                matrices(file, mass, keys.stiffness, keys.damping, keys.damping_ratio, &mut machine)?;
            }
            (None, Some(modes)) => {
                let said = [
                    ("stiffness", keys.stiffness.is_some()),
                    ("damping", keys.damping.is_some()),
                    ("damping_ratio", keys.damping_ratio.is_some()),
                ];
                if let Some((name, _)) = said.into_iter().find(|(_, given)| *given) {
                    let place = at(&format!("system.{name}"));
                    return Err(place.fail("stands beside `modes`, which already say it"));
                }
                modal(file, modes, &mut machine)?;
            }
            (Some(_), Some(_)) => {
                return Err(at("system.modes").fail("stands beside `mass`: give one of them"));
            }
            (None, None) => return Err(at("system").fail("has neither `mass` nor `modes`: give one of them")),
        }
        let points = machine.points();
        (machine.force, machine.smooth) = keys.force.fit(&at("system.force"), points)?;
        for (i, load) in (1..).zip(keys.forcing) {
            let path = format!("system.forcing[{i}]");
            check_k(&at(&path), load.k, machine.forcing.iter().map(|known| known.k))?;
            let cos = load.cos.fit(&at(&format!("{path}.cos")), points)?;
            let sin = load.sin.fit(&at(&format!("{path}.sin")), points)?;
            machine.forcing.push(Load { k: load.k, cos, sin });
        }
        let measured = measured(file, keys.measured, once, &mut machine)?;
        for (i, keys) in (1..).zip(walls) {
            let stop = stop(file, i, keys, points)?;
            if machine.stops.iter().any(|known| known.name == stop.name) {
                return Err(at(&format!("walls[{i}].name")).fail("is the name of an earlier stop, too"));
            }
            machine.stops.push(stop);
        }
        if let Some(depth) = accuracy.minimum_depth
            && depth.is_nan() | (depth <= 0.0)
        {
            return Err(at("accuracy.minimum_depth").fail("must be positive"));
        }
        Ok(MachineScene { machine, minimum_depth: accuracy.minimum_depth, measured })
    }
}

/// The period, from `frequency`, `period` or the length of a record that is taken once.
fn period(
    file: &Entry,
    frequency: Option<Expression>,
    period: Option<Expression>,
    once: Option<&MeasuredForce>,
) -> Result<Expression> {
    match (frequency, period) {
        (Some(frequency), None) => derived(file, &frequency, |text| format!("1/({text})")),
        (None, Some(period)) => Ok(period),
        (Some(_), Some(_)) => {
            Err(file.at("system.period").fail("stands beside `frequency`: give one of them"))
        }
        (None, None) => match once.and_then(|force| force.once.as_ref()) {
            Some(record) => Expression::parse(&format!("{:e}", record.length()), &[]),
            None => Err(file.at("system").fail("has neither `frequency` nor `period`: give one of them")),
        },
    }
}

/// The coefficients of a machine that is given by its matrices.
fn matrices(
    file: &Entry,
    mass: MatrixValue,
    stiffness: Option<MatrixValue>,
    damping: Option<MatrixValue>,
    ratios: Option<CoordinateList>,
    machine: &mut Machine<Expression>,
) -> Result<()> {
    machine.size = mass.square(&file.at("system.mass"), None)?;
    let n = machine.size;
    machine.mass = mass.entries;
    let others =
        [("stiffness", stiffness, &mut machine.stiffness), ("damping", damping, &mut machine.damping)];
    for (name, given, target) in others {
        if let Some(given) = given {
            given.square(&file.at(&format!("system.{name}")), Some(n))?;
            *target = given.entries;
        }
    }
    if let Some(ratios) = ratios {
        let place = file.at("system.damping_ratio");
        if !machine.damping.is_empty() {
            return Err(place.fail("stands beside `damping`: give one of them"));
        }
        if ratios.entries.len() != 1 && ratios.entries.len() != n {
            return Err(place.fail(&format!("give one ratio for all modes, or {n}")));
        }
        machine.damping_ratio = ratios.entries;
    }
    Ok(())
}

/// The measured force, if there is one, put among the machine's own loads; `once` is it if it is taken once.
fn measured(
    file: &Entry,
    keys: Option<MeasuredKeys>,
    once: Option<MeasuredForce>,
    machine: &mut Machine<Expression>,
) -> Result<Option<MeasuredForce>> {
    let Some(keys) = keys else { return Ok(None) };
    if !machine.forcing.is_empty() {
        return Err(file.at("system.measured").fail("stands beside `forcing`: give one of them"));
    }
    let points = machine.points();
    if let Some(force) = once {
        let direction = MeasuredForce::directed(file, keys.direction, points)?;
        machine.record = force.once.clone().map(|record| (record, direction.clone()));
        return Ok(Some(MeasuredForce { direction, ..force }));
    }
    let force = MeasuredForce::new(file, keys, &machine.period, points)?;
    let (mean, loads) = force.loads(file.scope.names)?;
    machine.forcing = loads;
    machine.force = match &machine.force[..] {
        [] => mean,
        constant => constant
            .iter()
            .zip(&mean)
            .map(|(one, mean)| derived(file, one, |text| format!("({text}) + ({mean})")))
            .collect::<Result<_>>()?,
    };
    Ok(Some(force))
}

/// Stop i, counted from 1, of a machine of `points` coordinates that a row has entries for.
fn stop(file: &Entry, i: usize, keys: StopKeys, points: usize) -> Result<Stop<Expression>> {
    let path = format!("walls[{i}]");
    let at = |name: &str| file.at(&format!("{path}{name}"));
    let row = match keys.row {
        Some(row) => row.fit(&at(".row"), points)?,
        None if points == 1 => vec![Expression::parse("1", &[])?],
        None => {
            return Err(at("").fail(&format!("has no row: give {points} entries that say what it stops")));
        }
    };
    if row.is_empty() {
        return Err(at(".row").fail("is zero: no motion reaches the stop"));
    }
    let harmonics = harmonics(file, keys.harmonics, &format!("{path}.harmonics"))?;
    let zero = || Expression::parse("0", &[]);
    let (restitution, law) = match (keys.restitution, keys.stiffness) {
        (Some(_), None) if keys.damping.is_some() => {
            let why = "stands beside `restitution`: give `stiffness` with it for a stop that gives way, or leave it out";
            return Err(at(".damping").fail(why));
        }
        (Some(RestitutionKey::Constant(restitution)), None) => (restitution, StopLaw::Newton),
        (Some(RestitutionKey::Speed(law)), None) => (zero()?, StopLaw::Speed(law)),
        (None, Some(stiffness)) => {
            let damping = keys.damping.map_or_else(zero, Ok)?;
            (zero()?, StopLaw::Soft { stiffness, damping })
        }
        (Some(_), Some(_)) => {
            let why = "stands beside `restitution`: give `restitution` for a rigid stop, or `stiffness` for one that gives way";
            return Err(at(".stiffness").fail(why));
        }
        (None, None) => {
            let why = "has neither `restitution` nor `stiffness`: give the first for a rigid stop, the second for one that gives way";
            return Err(at("").fail(why));
        }
    };
    let wall = Wall { offset: keys.offset, harmonics, restitution };
    Ok(Stop { name: keys.name.unwrap_or_else(|| format!("{i}")), row, wall, law })
}

fn modal(file: &Entry, modes: ModesKeys, machine: &mut Machine<Expression>) -> Result<()> {
    let n = modes.frequencies.len();
    let place = file.at("system.modes.frequencies");
    if !(1..=MOST).contains(&n) {
        return Err(place.fail(&format!("has {n} entries; a machine has 1 to {MOST} modes")));
    }
    let ratios = modes.ratios.entries;
    if ratios.len() != 1 && ratios.len() != n {
        let place = file.at("system.modes.ratios");
        return Err(place.fail(&format!("has {} entries; give one for all modes, or {n}", ratios.len())));
    }
    machine.size = n;
    let one = Expression::parse("1", &[])?;
    for (i, frequency) in modes.frequencies.iter().enumerate() {
        let ratio = &ratios[if ratios.len() == 1 { 0 } else { i }];
        machine.mass.push((i, i, one.clone()));
        machine.stiffness.push((i, i, derived(file, frequency, |text| format!("(2*pi*({text}))^2"))?));
        let both = derived(file, ratio, |text| format!("4*pi*({text})*({frequency})"))?;
        machine.damping.push((i, i, both));
    }
    if let Some(shapes) = modes.shapes {
        let place = file.at("system.modes.shapes");
        if shapes.columns != n {
            let found = shapes.columns;
            return Err(place.fail(&format!("has {found} entries in a row; there are {n} modes")));
        }
        let zero = Expression::parse("0", &[])?;
        machine.shapes = vec![vec![zero; n]; shapes.rows];
        for (i, j, value) in shapes.entries {
            machine.shapes[i][j] = value;
        }
    }
    Ok(())
}

/// An expression made of another's text, reported at its key.
fn derived(file: &Entry, from: &Expression, text: impl Fn(&str) -> String) -> Result<Expression> {
    let mut derived = Expression::parse(&text(&from.to_string()), file.scope.names)?;
    derived.key.clone_from(&from.key);
    Ok(derived)
}

/// The tables of a machine's file: path, what it is, keys.
pub(super) const MACHINES: &[(&str, &str, &[Key])] = &[
    ("`[system]` of a machine", MachineKeys::ABOUT, MachineKeys::KEYS),
    ("an entry of a machine's `forcing`", LoadKeys::ABOUT, LoadKeys::KEYS),
    ("`measured`", MeasuredKeys::ABOUT, MeasuredKeys::KEYS),
    ("`modes`", ModesKeys::ABOUT, ModesKeys::KEYS),
    ("`[[walls]]` of a machine", StopKeys::ABOUT, StopKeys::KEYS),
    ("`[accuracy]` of a machine", MachineAccuracy::ABOUT, MachineAccuracy::KEYS),
];
