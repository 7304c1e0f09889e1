//! A scene and its values: the oscillator at the parameters' values, a state to start from, where each stands
//! in the file.

use std::{collections::BTreeMap, f64::consts::TAU, ops::Range, path::PathBuf, sync::Arc};

use num_rational::BigRational;
use num_traits::ToPrimitive;
use serde::{Serialize, Serializer};

use super::{
    dimension::Measured,
    expression::{Coefficient, Expression},
    format::SceneFormat,
    grammar,
    keys::StopName,
    machine::MachineScene,
    matrix::CoordinateList,
    quantity::{Kinds, Scale, WrittenUnit, bare},
    sections::StartAxis,
    simulate::Start,
    system::{Accuracy, EngineKey},
    task::Task,
    units::SiUnits,
    walls,
};
use crate::{
    error::{Error, Result},
    motion::{Contact, State, System},
    number::{Ball, Plain, Precision, Real, parse_rational},
    quantity::{Dimension, exact_text},
    search::machine::Bounds,
    source::{Source, hint},
    typed::in_number,
};

/// An oscillator with named parameters, what to do with it, and how accurately.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// What it is.
    pub title: String,
    /// The parameters and their values, in the file's order.
    pub parameters: Vec<(String, BigRational)>,
    /// What it is about.
    pub body: Body,
    /// What computes its motions, and why.
    pub engine: Engine,
    /// Its stops.
    pub stops: Vec<StopName>,
    /// All of it as a machine, whatever computes it.
    pub(super) whole: Arc<MachineScene>,
    /// Of the engine `one`, what its forces were divided by, if that was not 1.
    pub(super) mass: Option<Expression>,
    /// The parameters that stand in no expression.
    pub(super) idle: Arc<Vec<String>>,
    /// How accurately to compute.
    pub accuracy: Accuracy,
    /// What a unit of its numbers is, if it says so, or has units written out.
    pub units: Option<SiUnits>,
    /// Whether its coordinates are angles, as far as its masses tell; none where some may be.
    pub(crate) turns: Option<bool>,
    /// The units of parameters that are written with one.
    pub(super) written: Arc<BTreeMap<String, WrittenUnit>>,
    /// Its units, and what its parameters measure.
    pub(super) quantities: Arc<(Scale, Kinds)>,
    /// What to do.
    pub tasks: Vec<Task>,
    /// The format of its file.
    pub format: SceneFormat,
    /// The file's name and text, and where in it each key's value stands.
    pub(super) file: Arc<(String, String)>,
    pub(super) places: Arc<BTreeMap<String, Range<usize>>>,
    /// The files beside it that it was read from.
    pub(super) files: Arc<Vec<PathBuf>>,
}

/// What a scene is about, by the engine that computes it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Body {
    /// `one`: the equation of motion and the walls of an oscillator with one degree of freedom.
    Oscillator(Arc<System<Expression>>),
    /// `many`: a machine.
    Machine(Arc<MachineScene>),
}

/// What computes a scene's motions.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Engine {
    /// Which engine: `one` or `many`.
    #[serde(serialize_with = "as_word")]
    pub name: EngineKey,
    /// Why it is that one.
    pub reason: String,
}

fn as_word<S: Serializer>(engine: &EngineKey, serializer: S) -> std::result::Result<S::Ok, S::Error> {
    serializer.serialize_str(engine.word())
}

impl Scene {
    /// The equation of motion and the walls, where the engine is `one`.
    ///
    /// # Errors
    /// Where it is `many`.
    pub(crate) fn system(&self) -> Result<&System<Expression>> {
        match &self.body {
            Body::Oscillator(system) => Ok(system),
            Body::Machine(_) => {
                Err(Error::input(format!("{}: {}", self.file.0, self.only_one("what was asked for works"))))
            }
        }
    }

    /// That something is done by the engine `one` alone, and why that is not the scene's.
    pub(super) fn only_one(&self, what: &str) -> String {
        format!(
            "{what} with one degree of freedom and rigid stops, by the engine \"one\"; here it is \"many\": {}",
            self.engine.reason
        )
    }

    /// The same scene with other values of some parameters.
    ///
    /// # Errors
    /// An input error for a parameter that the scene does not have, or a value of more than 4096 bits.
    pub fn with(&self, values: &[(String, BigRational)]) -> Result<Scene> {
        self.clone().set(values)
    }

    /// Values of parameters as a reader writes them: numbers, also with a unit where the scene's own has one.
    ///
    /// # Errors
    /// An input error for a parameter that the scene does not have or that is given twice, for what is no
    /// number, and for a unit of something else.
    pub fn values<N: AsRef<str>>(&self, given: &[(N, N)]) -> Result<Vec<(String, BigRational)>> {
        let mut values: Vec<(String, BigRational)> = Vec::with_capacity(given.len());
        for (name, text) in given {
            let (name, text) = (name.as_ref(), text.as_ref());
            if values.iter().any(|(known, _)| known == name) {
                return Err(Error::input(format!("{name} is given twice; leave one out")));
            }
            self.parameter(name)?;
            let value = self.given(name, text);
            values.push((
                name.to_string(),
                value.map_err(|error| error.context(format_args!("{name} = {text:?}")))?,
            ));
        }
        Ok(values)
    }

    fn given(&self, name: &str, text: &str) -> Result<BigRational> {
        let (scale, kinds) = &*self.quantities;
        let meant = || in_number(text).map_or(String::new(), |meant| format!("; {meant}"));
        let plain = parse_rational(text).map_err(|error| Error::input(format!("{error}{}", meant())));
        let (Err(error), Some(found)) = (&plain, bare(text, &[], (scale, &Kinds::new()))?) else {
            return plain;
        };
        match (kinds.get(name), found.measured) {
            (Some(kind), Measured::Known(given)) if kind.is_like(given) => found.value(),
            (None, Measured::Known(given)) if given.is_like(Dimension::ONE) => found.value(),
            (Some(kind), Measured::Known(given)) => {
                Err(Error::input(format!("is {given}, and in {} {name} is {kind}", self.file.0)))
            }
            _ => Err(Error::input(format!("{error}; in {} {name} has no unit", self.file.0))),
        }
    }

    /// The same scene with other values of some parameters, and without its tasks, which may be many.
    pub(super) fn alone(&self, values: &[(String, BigRational)]) -> Result<Scene> {
        let Scene { title, parameters, body, engine, stops, whole, mass, accuracy, .. } = self;
        let Scene { units, turns, written, quantities, idle, format, file, places, files, .. } = self;
        Scene {
            title: title.clone(),
            parameters: parameters.clone(),
            body: body.clone(),
            engine: engine.clone(),
            stops: stops.clone(),
            whole: whole.clone(),
            mass: mass.clone(),
            accuracy: accuracy.clone(),
            units: *units,
            turns: *turns,
            written: written.clone(),
            quantities: quantities.clone(),
            idle: idle.clone(),
            tasks: Vec::new(),
            format: *format,
            file: file.clone(),
            places: places.clone(),
            files: files.clone(),
        }
        .set(values)
    }

    fn set(mut self, values: &[(String, BigRational)]) -> Result<Scene> {
        for (name, value) in values {
            let place = self.parameter(name)?;
            self.parameters[place].1 = grammar::checked(value.clone())
                .map_err(|error| error.context(format_args!("parameter {name}")))?;
        }
        Ok(self)
    }

    /// The mass of the one degree of freedom, where the engine is `one`: impulses are its velocities' changes
    /// times this.
    ///
    /// # Errors
    /// Where it is not defined.
    pub(crate) fn mass(&self) -> Result<f64> {
        self.mass.as_ref().map_or(Ok(1.0), |mass| self.number(mass))
    }

    /// The same with other values of some parameters.
    ///
    /// # Errors
    /// As [`mass`](Self::mass).
    pub(crate) fn mass_at(&self, changes: &[(&str, f64)]) -> Result<f64> {
        let exact = |(name, value): &(&str, f64)| Some((name.to_string(), BigRational::from_float(*value)?));
        self.alone(&changes.iter().filter_map(exact).collect::<Vec<_>>())?.mass()
    }

    /// A text of the oscillator: its parameters with their values, and its equation and walls as expressions
    /// in them, without the spaces in them. Scenes with the same text have the same motions; titles, tasks,
    /// comments and the order of keys do not matter.
    pub(crate) fn canonical(&self) -> Result<String> {
        let parameters: Vec<(&str, String)> =
            self.parameters.iter().map(|(name, value)| (name.as_str(), value.to_string())).collect();
        Ok(match &self.body {
            Body::Oscillator(system) => serde_json::to_string(&(parameters, system.as_ref())),
            Body::Machine(scene) => serde_json::to_string(&(parameters, &scene.machine, scene.minimum_depth)),
        }
        .map_err(std::io::Error::other)?)
    }

    /// The unit in which a parameter is written, if it is.
    pub fn unit(&self, parameter: &str) -> Option<&WrittenUnit> {
        self.written.get(parameter)
    }

    /// A parameter with an exact value, in the unit in which it is written.
    pub(crate) fn told(&self, name: &str, value: &BigRational) -> String {
        match self.unit(name) {
            Some(unit) => format!("{name} = {} {}", exact_text(&(value / &unit.size)), unit.text),
            None => format!("{name} = {value}"),
        }
    }

    /// The scene's unit of a dimension, if it has units.
    pub(crate) fn unit_name(&self, dimension: Dimension) -> Option<String> {
        self.units.map(|_| self.quantities.0.name(dimension))
    }

    /// The place of a parameter in the list.
    ///
    /// # Errors
    /// An input error if there is none of that name.
    pub fn parameter(&self, name: &str) -> Result<usize> {
        self.parameters
            .iter()
            .position(|known| known.0 == name)
            .ok_or_else(|| Error::input(format!("{}: {}", self.file.0, self.no_parameter(name))))
    }

    /// That there is a parameter of the name that stands at a key.
    ///
    /// # Errors
    /// An input error if there is none.
    pub(super) fn check_parameter(&self, name: &str, key: &str) -> Result<()> {
        self.parameter(name).map(drop).map_err(|_| self.fail(key, &self.no_parameter(name)))
    }

    fn no_parameter(&self, name: &str) -> String {
        let known: Vec<&str> = self.parameters.iter().map(|(name, _)| name.as_str()).collect();
        format!("the scene has no parameter {name:?}; {}", hint(name, known))
    }

    /// The system with the parameters' values, and some of them changed.
    ///
    /// # Errors
    /// An input error, naming file, line and key, for an unknown parameter, a division by zero, a negative
    /// restitution or walls that touch.
    pub fn exact(&self, changes: &[(&str, BigRational)]) -> Result<System<BigRational>> {
        let mut values: Vec<BigRational> = self.parameters.iter().map(|(_, value)| value.clone()).collect();
        for (name, value) in changes {
            values[self.parameter(name)?].clone_from(value);
        }
        let point = || self.point(&values);
        let system = self.system()?.try_map(|expression| self.value(expression, &values, float, &point));
        let plain = || values.iter().map(|value| Plain::ratio(value, &())).collect::<Vec<_>>();
        let system = system.map_err(|error| self.without_period(&plain()).unwrap_or(error))?;
        self.check_signs(&values, float, &point)?;
        self.check(&system.rounded(), &point)?;
        Ok(system)
    }

    /// That there is no period, which every coefficient needs.
    fn without_period(&self, values: &[Plain]) -> Option<Error> {
        let rate = self.system().ok()?.rate.as_ref()?;
        let is_positive = rate.evaluate(values, &()).is_ok_and(|rate| rate.0 > 0.0);
        (!is_positive).then(|| {
            let values: Vec<f64> = values.iter().map(|value| value.0).collect();
            self.fail(&rate.key, &format!("makes no period: it must be positive{}", self.point(&values)))
        })
    }

    /// The system in floats: each coefficient rounded from its exact value, or computed in floats where some
    /// are not rational.
    ///
    /// # Errors
    /// As [`Scene::exact`], but for what is not rational.
    pub fn rounded(&self) -> Result<System<f64>> {
        match self.exact(&[]) {
            Ok(system) => Ok(system.rounded()),
            // Where floats have no value either, the exact one says what is wrong, unless there may be none.
            Err(error) => {
                let rational = |x: &Expression| if x.root.is_rational() { Ok(()) } else { Err(()) };
                let is_rational = self.system().is_ok_and(|system| system.try_map(rational).is_ok());
                self.plain(&[]).map_err(|other| if is_rational { error } else { other })
            }
        }
    }

    /// Two numbers between which each coefficient lies, equal for one that is rational, and the rate; with
    /// another value of a parameter if there is one. The system's own rate is left out.
    ///
    /// # Errors
    /// As [`Scene::exact`], but for what is not rational.
    pub(crate) fn enclosed(
        &self,
        change: Option<(&str, &BigRational)>,
        precision: &Precision,
    ) -> Result<(System<Bounds>, Ball)> {
        let mut exact: Vec<BigRational> = self.parameters.iter().map(|(_, value)| value.clone()).collect();
        if let Some((name, value)) = change {
            exact[self.parameter(name)?].clone_from(value);
        }
        let balls: Vec<Ball> = exact.iter().map(|value| Ball::ratio(value, precision)).collect();
        let ball = |expression: &Expression| {
            let fail =
                |message: &str| self.fail(&expression.key, &format!("{message}{}", self.point(&exact)));
            expression.evaluate(&balls, precision).map_err(|error| fail(&error.to_string()))
        };
        let written = self.system()?;
        let rate = written.rate.as_ref().map_or_else(|| Ok(Ball::integer(1, precision)), ball)?;
        let system = written.in_radians();
        let system = system.try_map(|expression| {
            if let Ok(value) = expression.evaluate(&exact, &()) {
                return Ok([value.clone(), value]);
            }
            let bounds = ball(expression)?.exact_bounds();
            bounds.map(|(lo, hi)| [lo, hi]).ok_or_else(|| self.fail(&expression.key, "cannot be enclosed"))
        })?;
        Ok((system, rate))
    }

    /// The system in plain floats, for parameters that vary continuously; otherwise as [`Scene::exact`].
    ///
    /// # Errors
    /// As [`Scene::exact`].
    pub fn plain(&self, changes: &[(&str, f64)]) -> Result<System<f64>> {
        let mut values: Vec<Plain> =
            self.parameters.iter().map(|(_, value)| Plain::ratio(value, &())).collect();
        for (name, value) in changes {
            values[self.parameter(name)?] = Plain(*value);
        }
        let floats: Vec<f64> = values.iter().map(|value| value.0).collect();
        let point = || self.point(&floats);
        let system = self.system()?.try_map(|expression| self.value(expression, &values, |x| x.0, &point));
        let system = system.map_err(|error| self.without_period(&values).unwrap_or(error))?;
        let system = system.try_map(|x| Ok::<f64, Error>(x.0))?;
        self.check_signs(&values, |x| x.0, &point)?;
        self.check(&system, &point)?;
        Ok(system)
    }

    /// An expression's value with the scene's parameters, rounded.
    ///
    /// # Errors
    /// An input error that names where it stands, for a division by zero or a value beyond floats.
    pub(crate) fn number(&self, expression: &Expression) -> Result<f64> {
        let values: Vec<BigRational> = self.parameters.iter().map(|(_, value)| value.clone()).collect();
        let exact = self.value(expression, &values, float, &|| self.point(&values));
        if exact.is_err() {
            let values: Vec<Plain> = values.iter().map(|value| Plain::ratio(value, &())).collect();
            let floats: Vec<f64> = values.iter().map(|value| value.0).collect();
            return Ok(self.value(expression, &values, |x| x.0, &|| self.point(&floats))?.0);
        }
        Ok(float(&exact?))
    }

    /// A state to start from, rounded from its exact values; its velocity is in the scene's unit of time.
    ///
    /// # Errors
    /// As [`Scene::exact`].
    pub fn state(&self, start: &Start) -> Result<State> {
        let one = |given: &CoordinateList| match &given.entries[..] {
            [only] => self.number(only),
            many => {
                let key = many.first().map_or("", |first| first.key.trim_end_matches("[1]"));
                Err(self.fail(key, "is a list; here there is one displacement and one velocity"))
            }
        };
        Ok(State { t: phase(&start.phase), q: one(&start.q)?, u: one(&start.u)? })
    }

    /// What the axes of an oscillator's plane of starts are: two of `q`, `u` and `phase`; without names the
    /// first two.
    ///
    /// # Errors
    /// An input error at `path` for anything else.
    pub(crate) fn start_plane(&self, names: &[String], path: &str) -> Result<[StartAxis; 2]> {
        let axis = |name: &String| {
            match name.as_str() {
            "q" | "q1" => Ok(StartAxis::Place),
            "u" | "u1" => Ok(StartAxis::Speed),
            "phase" => Ok(StartAxis::Phase),
            _ => Err(self.fail(
                path,
                &format!(
                    "{name:?} is neither \"q\" nor \"u\" nor \"phase\", which are what a start of an oscillator has"
                ),
            )),
        }
        };
        match names {
            [] => Ok([StartAxis::Place, StartAxis::Speed]),
            [first, second] if first != second => Ok([axis(first)?, axis(second)?]),
            _ => Err(self.fail(path, "must name two different axes, as in [\"q\", \"phase\"]")),
        }
    }

    /// A coefficient's value, within the range of floats; an error names where it stands.
    pub(super) fn value<T: Coefficient<Context = ()>>(
        &self,
        expression: &Expression,
        values: &[T],
        float: impl Fn(&T) -> f64,
        point: &dyn Fn() -> String,
    ) -> Result<T> {
        let fail = |message: &str| self.fail(&expression.key, &format!("{message}{}", point()));
        let value = expression.evaluate(values, &()).map_err(|error| fail(&error.to_string()))?;
        if float(&value).is_finite() { Ok(value) } else { Err(fail("is beyond the range of floats")) }
    }

    /// Damping ratios are at least 0, and the mass of the engine `one` is positive.
    pub(super) fn check_signs<T: Coefficient<Context = ()>>(
        &self,
        values: &[T],
        float: impl Fn(&T) -> f64,
        point: &dyn Fn() -> String,
    ) -> Result<()> {
        let ratios = self.whole.ratios.iter().map(|ratio| (ratio, true, "a damping ratio is at least 0"));
        let mass = self.mass.iter().map(|mass| (mass, false, "a mass is positive"));
        for (given, may_be_0, wanted) in ratios.chain(mass) {
            let value = float(&self.value(given, values, &float, point)?);
            if value < 0.0 || value == 0.0 && !may_be_0 {
                return Err(self.fail(&given.key, &format!("is {value}; {wanted}{}", point())));
            }
        }
        Ok(())
    }

    fn check(&self, system: &System<f64>, point: &dyn Fn() -> String) -> Result<()> {
        let written = self.system()?;
        if let (Some(rate), Some(written)) = (system.rate, &written.rate) {
            let period = TAU / rate;
            if rate.is_nan() || period <= 0.0 || !period.is_finite() {
                let message = format!("makes the period {period}; it must be positive{}", point());
                return Err(self.fail(&written.key, &message));
            }
        }
        for (wall, plain) in [(&written.lower, &system.lower), (&written.upper, &system.upper)] {
            if let (Some(wall), Some(plain)) = (wall, plain)
                && plain.restitution < 0.0
            {
                let message = format!("is {}; a restitution is at least 0{}", plain.restitution, point());
                return Err(self.fail(&wall.restitution.key, &message));
            }
        }
        if let ([lower, upper], Some(wall)) = (&Contact::of(system)?[..], &written.upper)
            && let Some((t, gap)) = walls::meet(lower, upper)?
        {
            let message = format!(
                "the {}s meet: at t = {t:.6} the upper one is {gap:.3e} above the lower; move them apart{}",
                self.format.stop(),
                point()
            );
            return Err(self.fail(&wall.offset.key, &message));
        }
        Ok(())
    }

    /// Whether something stands at a key of the file.
    pub(super) fn has(&self, key: &str) -> bool {
        self.places.contains_key(key)
    }

    /// The files beside the scene's that it was read from: matrices and records of forces.
    pub fn files(&self) -> &[PathBuf] {
        &self.files
    }

    /// Where a task stands in the file.
    pub(crate) fn place(&self, task: &Task) -> (String, Option<usize>) {
        let source = Source { name: &self.file.0, text: &self.file.1 };
        (self.file.0.clone(), self.places.get(&task.path).map(|span| source.line(span)))
    }

    /// `file:line: key = value: message`.
    pub fn fail(&self, key: &str, message: &str) -> Error {
        let source = Source { name: &self.file.0, text: &self.file.1 };
        let path = self.format.path(key);
        match self.places.get(key) {
            Some(place) => source.at(&path, Some(place.clone()), message),
            // What is not written stands in what is.
            None => {
                let above = key.match_indices(['.', '[']).rev().find_map(|(i, _)| self.places.get(&key[..i]));
                source.fail(above.cloned(), &format!("{path}: {message}"))
            }
        }
    }

    pub(super) fn where_parameters(&self) -> String {
        let values: Vec<&BigRational> = self.parameters.iter().map(|(_, value)| value).collect();
        self.point(&values)
    }

    /// The values at which something went wrong, one for each parameter.
    pub(super) fn point<T: std::fmt::Display>(&self, values: &[T]) -> String {
        let named = self.parameters.iter().zip(values);
        let all: Vec<String> = named.map(|((name, _), value)| format!("{name} = {}", brief(value))).collect();
        if all.is_empty() { String::new() } else { format!(" (with {})", all.join(", ")) }
    }
}

/// A number as it is told beside others: of one with very many digits the first.
fn brief(value: &impl std::fmt::Display) -> String {
    let text = value.to_string();
    if text.len() <= 60 { text } else { format!("{}… ({} characters)", &text[..20], text.len()) }
}

/// A fraction of the forcing period as t in [0, 2π).
pub fn phase(fraction: &BigRational) -> f64 {
    TAU * float(&(fraction - fraction.floor()))
}

pub(super) fn float(x: &BigRational) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}
