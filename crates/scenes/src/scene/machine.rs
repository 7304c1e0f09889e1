//! What a scene says to the engine `many`: a machine with any number of degrees of freedom and of stops, in
//! the units in which it is measured. Every scene is checked as one.

use super::{
    expression::Expression,
    force::Variables,
    format::SceneFormat,
    keys::Entry,
    law::{CoefficientKey, LawKey},
    matrix::{CoordinateList, MatrixValue},
    measured::{MeasuredForce, MeasuredKeys, MeasuredMotionKeys, fitted},
    restitution::RestitutionKey,
    system::{
        EventKeys, FrictionKeys, HarmonicKeys, ModesKeys, StopKeys, SystemKeys, check_k, derived, harmonics,
    },
};
use crate::{
    error::Result,
    many::{Friction, Load, Machine, NormalForce, Stop, StopLaw},
    motion::{Harmonic, Side, SmoothForce, Wall},
    source::hint,
};

/// Most coordinates and modes.
const MOST: usize = 2000;

/// What the engine `many` has in place of [`System`](crate::motion::System).
#[derive(Debug, Clone, PartialEq)]
pub struct MachineScene {
    /// Its coefficients.
    pub machine: Machine<Expression>,
    /// The minimum depth, if it is given.
    pub minimum_depth: Option<f64>,
    /// The measured force, which is among the machine's own loads, too.
    pub measured: Option<MeasuredForce>,
    /// The measured motions of stops, each with the stop's name; they are among the stops' harmonics.
    pub(crate) moved: Vec<(String, MeasuredForce)>,
    /// The damping ratios that the damping is made of, none of which is negative.
    pub(super) ratios: Vec<Expression>,
    /// The thresholds, each with its name and whether it ends a motion.
    pub(crate) events: Vec<(String, SmoothForce<Expression>, bool)>,
    /// Of each stop the volume that wears off for a unit of energy, if it is given.
    pub(super) wear: Vec<Option<Expression>>,
}

impl MachineScene {
    /// Checks what stands in the file's tables against one another.
    pub(super) fn new(
        file: &Entry,
        mut keys: SystemKeys,
        (stops, friction, thresholds): (Vec<StopKeys>, Vec<FrictionKeys>, Vec<EventKeys>),
        moved: Vec<(String, MeasuredForce)>,
        minimum_depth: Option<f64>,
    ) -> Result<Self> {
        let at = |path: &str| file.at(path);
        let once = match &keys.measured {
            Some(measured) if measured.once => Some(MeasuredForce::once(file, measured)?),
            _ => None,
        };
        let period = period(file, keys.frequency.take(), keys.period.take(), once.as_ref())?;
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
            friction: Vec::new(),
        };
        let given = keys.damping_ratio.iter().chain(keys.modes.iter().map(|modes| &modes.ratios));
        let ratios = given.flat_map(|list| list.entries.clone()).collect();
        mass_or_modes(file, &mut keys, &mut machine)?;
        let points = machine.points();
        let force = match &keys.cubic {
            Some(_) if points != 1 => {
                let why = "is of a single coordinate: with more write a formula in `force`";
                return Err(at("system.cubic").fail(why));
            }
            // Of format 1 all else is computed by `one`.
            Some(_) if file.scope.format == SceneFormat::One => keys.force,
            Some(_) if file.scope.names.iter().any(|name| name == "q1") => {
                let why =
                    "needs q1, the displacement, which is a parameter of the scene: rename the parameter";
                return Err(at("system.cubic").fail(why));
            }
            Some(cubic) => keys.force.mapped(|text| format!("({text}) - ({cubic})*q1^3")),
            None => keys.force,
        };
        let variables = Variables::of(points, file.scope.format);
        (machine.force, machine.smooth) = force.fit(&at("system.force"), points, &variables)?;
        for (i, load) in (1..).zip(keys.forcing) {
            let path = format!("system.forcing[{i}]");
            check_k(&at(&path), load.k, machine.forcing.iter().map(|known| known.k))?;
            let cos = load.cos.fit(&at(&format!("{path}.cos")), points)?;
            let sin = load.sin.fit(&at(&format!("{path}.sin")), points)?;
            machine.forcing.push(Load { k: load.k, cos, sin });
        }
        let measured = measured(file, keys.measured, once, &mut machine)?;
        let wear = stops.iter().map(|keys| keys.wear.clone()).collect();
        for (i, keys) in (1..).zip(stops) {
            let name = name(&keys, i);
            if machine.stops.iter().any(|known| known.name == name) {
                let word = file.scope.format.stop();
                return Err(match (&keys.name, keys.side) {
                    (None, Some(_)) => at(&format!("stops[{i}].side"))
                        .fail(&format!("there is a {word} on this side already")),
                    _ => at(&format!("stops[{i}].name")).fail("is the name of an earlier stop, too"),
                });
            }
            machine.stops.push(stop(file, i, keys, points)?);
        }
        let alone = friction.len() == 1;
        for (i, keys) in (1..).zip(friction) {
            let own = if alone { "friction".to_string() } else { format!("friction {i}") };
            let name = keys.name.clone().unwrap_or(own);
            let mut before = machine.stops.iter().map(|stop| &stop.name);
            if before.any(|known| *known == name) || machine.friction.iter().any(|known| known.name == name) {
                let why = "is the name of a stop or of an earlier friction, too";
                return Err(at(&format!("friction[{i}].name")).fail(why));
            }
            let stops = std::mem::take(&mut machine.stops);
            let rub = rubbing(file, i, name, keys, (points, &stops));
            machine.stops = stops;
            machine.friction.push(rub?);
        }
        let mut events: Vec<(String, SmoothForce<Expression>, bool)> = Vec::new();
        let alone = thresholds.len() == 1;
        for (i, EventKeys { name, of, end }) in (1..).zip(thresholds) {
            let own = || if alone { "event".to_string() } else { format!("event {i}") };
            let name = name.unwrap_or_else(own);
            let held = machine.stops.iter().map(|stop| &stop.name);
            let held = held.chain(machine.friction.iter().map(|rub| &rub.name));
            if held.chain(events.iter().map(|known| &known.0)).any(|known| *known == name) {
                let why = "is the name of a stop, of friction or of an earlier event, too";
                return Err(at(&format!("events[{i}].name")).fail(why));
            }
            events.push((name, of.fit(&at(&format!("events[{i}].of")), &variables)?, end));
        }
        Ok(MachineScene { machine, minimum_depth, measured, moved, ratios, events, wear })
    }
}

/// The coefficients, by matrices or by modes, taken out of the keys.
fn mass_or_modes(file: &Entry, keys: &mut SystemKeys, machine: &mut Machine<Expression>) -> Result<()> {
    let at = |path: &str| file.at(path);
    match (keys.mass.take(), keys.modes.take()) {
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
            modal(file, modes, machine)
        }
        (Some(_), Some(_)) => Err(at("system.modes").fail("stands beside `mass`: give one of them")),
        (None, None) if file.scope.format == SceneFormat::Two => {
            Err(at("system").fail("has neither `mass` nor `modes`: give one of them"))
        }
        (mass, None) => {
            let mass = mass.map_or_else(|| MatrixValue::single("1"), Ok)?;
            let [stiffness, damping] = [keys.stiffness.take(), keys.damping.take()];
            matrices(file, mass, stiffness, damping, keys.damping_ratio.take(), machine)
        }
    }
}

/// What stop i, counted from 1, is called.
pub(super) fn name(keys: &StopKeys, i: usize) -> String {
    let side = || keys.side.map_or_else(|| i.to_string(), |side| side.name().to_string());
    keys.name.clone().unwrap_or_else(side)
}

/// The period, from `frequency`, `period` or the length of a record that is taken once.
pub(super) fn period(
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
            None if file.scope.format == SceneFormat::Two => {
                Err(file.at("system").fail("has neither `frequency` nor `period`: give one of them"))
            }
            None => Expression::parse("2*pi", &[]),
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

/// The motion of stop i, counted from 1, if it has a record: it moves by its `harmonics` from then on, about
/// its `offset` and the mean.
pub(super) fn measured_motion(
    file: &Entry,
    i: usize,
    keys: &mut StopKeys,
    period: &Expression,
) -> Result<Option<MeasuredForce>> {
    let Some(MeasuredMotionKeys { file: name, harmonics, period: own }) = keys.measured.take() else {
        return Ok(None);
    };
    let path = format!("stops[{i}].measured");
    if !keys.harmonics.is_empty() {
        return Err(file.at(&path).fail("stands beside `harmonics`: give one of them"));
    }
    let found = fitted(file, &path, (&name, "position"), harmonics, (own.as_ref(), period))?;
    let number = |x: f64| Expression::parse(&format!("{x:e}"), &[]);
    keys.offset = derived(file, &keys.offset, |text| format!("({text}) + ({:e})", found.mean))?;
    let harmonic =
        |(k, [cos, sin]): (u32, &[f64; 2])| Ok(HarmonicKeys { k, cos: number(*cos)?, sin: number(*sin)? });
    keys.harmonics = (1..).zip(&found.harmonics).map(harmonic).collect::<Result<_>>()?;
    Ok(Some(found))
}

/// Stop i, counted from 1, of a machine of `points` coordinates that a row has entries for.
fn stop(file: &Entry, i: usize, keys: StopKeys, points: usize) -> Result<Stop<Expression>> {
    let path = format!("stops[{i}]");
    let at = |name: &str| file.at(&format!("{path}{name}"));
    let name = name(&keys, i);
    let number = |text: &str| Expression::parse(text, &[]);
    let harmonics = harmonics(file, keys.harmonics, &format!("{path}.harmonics"))?;
    let (row, offset, harmonics) = match (keys.side, keys.row) {
        (Some(_), Some(_)) => {
            return Err(at(".row").fail("stands beside `side`: give one of them"));
        }
        (Some(_), None) if points != 1 => {
            let why = "is of a single coordinate: give a `row` that says what the stop stops";
            return Err(at(".side").fail(why));
        }
        (Some(Side::Upper), None) => (vec![number("-1")?], keys.offset.negated(), negated(&harmonics)),
        (Some(Side::Lower), None) => (vec![number("1")?], keys.offset, harmonics),
        (None, Some(row)) => (row.fit(&at(".row"), points)?, keys.offset, harmonics),
        (None, None) if points == 1 => (vec![number("1")?], keys.offset, harmonics),
        (None, None) => {
            return Err(at("").fail(&format!("has no row: give {points} entries that say what it stops")));
        }
    };
    if row.is_empty() {
        return Err(at(".row").fail("is zero: no motion reaches the stop"));
    }
    if let Some(LawKey(force)) = keys.law {
        let others = [
            (".restitution", keys.restitution.is_some()),
            (".stiffness", keys.stiffness.is_some()),
            (".damping", keys.damping.is_some()),
        ];
        if let Some((key, _)) = others.into_iter().find(|known| known.1) {
            return Err(
                at(key).fail("stands beside `law`, which says all of the force: leave one of them out")
            );
        }
        let wall = Wall { offset, harmonics, restitution: number("0")? };
        return Ok(Stop { name, row, wall, law: StopLaw::Formula(force) });
    }
    let (restitution, law) = match (keys.restitution, keys.stiffness) {
        (Some(_), None) if keys.damping.is_some() => {
            let why =
                "stands beside `restitution`: give `stiffness` with it for a compliant stop, or leave it out";
            return Err(at(".damping").fail(why));
        }
        (Some(RestitutionKey::Constant(restitution)), None) => (restitution, StopLaw::Newton),
        (Some(RestitutionKey::Speed(law)), None) => (number("0")?, StopLaw::Speed(law)),
        (None, Some(stiffness)) => {
            let damping = keys.damping.map_or_else(|| number("0"), Ok)?;
            (number("0")?, StopLaw::Soft { stiffness, damping })
        }
        (Some(_), Some(_)) => {
            let why = "stands beside `restitution`: give `restitution` for a rigid stop, or `stiffness` for a compliant one";
            return Err(at(".stiffness").fail(why));
        }
        (None, None) => {
            let why = "has neither `restitution` nor `stiffness`: give the first for a rigid stop, the second for a compliant one, or `law`";
            return Err(at("").fail(why));
        }
    };
    Ok(Stop { name, row, wall: Wall { offset, harmonics, restitution }, law })
}

/// Friction i, counted from 1, of a machine of `points` coordinates that a row has entries for.
fn rubbing(
    file: &Entry,
    i: usize,
    name: String,
    keys: FrictionKeys,
    (points, stops): (usize, &[Stop<Expression>]),
) -> Result<Friction<Expression>> {
    let at = |key: &str| file.at(&format!("friction[{i}]{key}"));
    let harmonics = harmonics(file, keys.harmonics, &format!("friction[{i}].harmonics"))?;
    let row = match keys.row {
        Some(row) => row.fit(&at(".row"), points)?,
        None if points == 1 => vec![Expression::parse("1", &[])?],
        None => {
            return Err(at("").fail(&format!("has no row: give {points} entries that say what slides")));
        }
    };
    if row.is_empty() {
        return Err(at(".row").fail("is zero: nothing slides"));
    }
    let (coefficient, law) = match keys.coefficient {
        CoefficientKey::Constant(coefficient) => (coefficient, None),
        CoefficientKey::Law(law) => (Expression::parse("0", &[])?, Some(law)),
    };
    let static_coefficient = keys.static_coefficient.unwrap_or_else(|| coefficient.clone());
    let normal = match (keys.normal, keys.stop) {
        (Some(force), None) => NormalForce::Given(force),
        (None, Some(stop)) => {
            let place = stops.iter().position(|known| known.name == stop).ok_or_else(|| {
                let near = hint(&stop, stops.iter().map(|stop| stop.name.as_str()));
                at(".stop").fail(&format!("is {stop:?}, none of the scene's stops; {near}"))
            })?;
            NormalForce::Stop { stop: place }
        }
        (Some(_), Some(_)) => {
            return Err(
                at("").fail("has `normal` and `stop`: give the normal force or the stop whose force it is")
            );
        }
        (None, None) => {
            let why = "has neither `normal` nor `stop`: give the normal force, or the stop whose force it is";
            return Err(at("").fail(why));
        }
    };
    let speed = keys.speed;
    Ok(Friction { name, row, normal, coefficient, law, static_coefficient, speed, harmonics })
}

/// The opposite motion.
pub(super) fn negated(harmonics: &[Harmonic<Expression>]) -> Vec<Harmonic<Expression>> {
    let one = |h: &Harmonic<Expression>| Harmonic { k: h.k, cos: h.cos.negated(), sin: h.sin.negated() };
    harmonics.iter().map(one).collect()
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
