//! A machine of a scene at the parameters' values, and the states in which it starts.

use std::f64::consts::TAU;

use num_rational::BigRational;

use super::{
    expression::Expression,
    format::SceneFormat,
    machine::MachineScene,
    matrix::CoordinateList,
    scene::{Body, Scene, float, phase},
    sections::Values,
    simulate::{SimulateTask, Start},
};
use crate::{
    error::{Error, Result},
    many::{Machine, RealVector, State, elements::Evaluated, section::PlaneAxis},
    number::{Ball, Plain, Precision, Real},
    search::machine::Bounds,
};

/// A scene as it is written, at the parameters' values.
#[derive(Debug, Clone, PartialEq)]
pub struct WrittenMachine {
    /// The machine.
    pub machine: Machine<Evaluated>,
    /// Of a scene of format 1, the coefficient of the displacement cubed.
    pub cubic: Option<Evaluated>,
    /// The file of a measured force.
    pub measured: Option<String>,
}

/// A duration so near whole periods, or whole samples, relative to itself, is of whole ones.
pub(crate) const ROUNDED: f64 = 4.0 * f64::EPSILON;

impl Scene {
    /// How many forcing periods of a motion are written, in whole ones or not.
    ///
    /// # Errors
    /// A duration that cannot be computed, or a period.
    pub(crate) fn span(&self, task: &SimulateTask) -> Result<f64> {
        let Some(duration) = &task.duration else { return Ok(f64::from(task.periods)) };
        let period = match self.body {
            Body::Oscillator(_) => TAU / self.rounded()?.shown_rate(),
            Body::Machine(_) => self.machine(&[])?.period,
        };
        let span = self.number(duration)? / period;
        // Whole periods that are not whole by the rounding of a quotient.
        let near = (span - span.round()).abs() <= ROUNDED * span;
        Ok(if near { span.round() } else { span })
    }

    /// The machine where the engine is `many`, each coefficient rounded from its exact value where it is
    /// rational.
    ///
    /// # Errors
    /// An input error, naming file, line and key, for a value that cannot be computed, M that is not
    /// symmetric and positive definite, a negative restitution, a stop that no motion reaches, a period that
    /// is not positive; where the engine is `one`.
    pub fn machine(&self, changes: &[(&str, f64)]) -> Result<Machine<f64>> {
        let scene = self.machine_scene()?;
        let exact: Vec<_> = self.parameters.iter().map(|(_, value)| value.clone()).collect();
        let mut floats: Vec<_> = exact.iter().map(|value| Plain(float(value))).collect();
        for (name, value) in changes {
            floats[self.parameter(name)?] = Plain(*value);
        }
        let point = || self.point(&floats.iter().map(|value| value.0).collect::<Vec<_>>());
        let number = |expression: &Expression| {
            if changes.is_empty()
                && let Ok(value) = expression.evaluate(&exact, &())
            {
                let value = float(&value);
                if value.is_finite() {
                    return Ok(value);
                }
            }
            self.value(expression, &floats, |x| x.0, &point).map(|value| value.0)
        };
        let machine = scene.machine.try_map(number)?;
        let keyed = |key: &str, error: &Error| self.fail(key, &format!("{error}{}", point()));
        // A period that is no number fails too.
        if machine.period.is_nan() || machine.period <= 0.0 {
            let key =
                if self.places.contains_key("system.period") { "system.period" } else { "system.frequency" };
            return Err(self
                .fail(key, &format!("makes the period {}; it must be positive{}", machine.period, point())));
        }
        self.check_signs(&floats, |x| x.0, &point)?;
        machine.equations().map_err(|error| {
            let text = error.to_string();
            let key = ["mass", "damping_ratio", "damping", "stiffness"]
                .into_iter()
                .find(|key| text.starts_with(key));
            keyed(&key.map_or("system".to_string(), |key| format!("system.{key}")), &error)
        })?;
        machine.check_forces().map_err(|error| {
            let text = error.to_string();
            keyed("system.force", &Error::input(text.strip_prefix("force: ").unwrap_or(&text)))
        })?;
        for (i, stop) in (1..).zip(&machine.stops) {
            let alone = Machine { stops: vec![stop.clone()], ..machine.clone() };
            alone.contacts().map_err(|error| {
                let text = error.to_string();
                let text = text.strip_prefix(&format!("stop {}: ", stop.name)).unwrap_or(&text);
                let parts = ["restitution", "stiffness", "damping", "law"];
                let part = parts.into_iter().find(|part| text.starts_with(part)).unwrap_or("row");
                keyed(&format!("stops[{i}].{part}"), &error)
            })?;
        }
        for (i, friction) in (1..).zip(&machine.friction) {
            let alone = Machine { friction: vec![friction.clone()], ..machine.clone() };
            alone.rubs().map_err(|error| {
                let text = error.to_string();
                let text = text.strip_prefix(&format!("friction {}: ", friction.name)).unwrap_or(&text);
                let parts = ["normal", "stop", "coefficient", "static_coefficient", "speed"];
                let part = parts.into_iter().find(|part| text.starts_with(&format!("{part} ")));
                keyed(&format!("friction[{i}].{}", part.unwrap_or("row")), &Error::input(text))
            })?;
        }
        Ok(machine)
    }

    /// The scene as a machine, whatever computes it, each coefficient exact where it is rational.
    ///
    /// # Errors
    /// As [`machine`](Self::machine), and as [`exact`](Self::exact) where the engine is `one`.
    pub fn written(&self) -> Result<WrittenMachine> {
        match &self.body {
            Body::Oscillator(_) => self.rounded().map(drop)?,
            Body::Machine(_) => self.machine(&[]).map(drop)?,
        }
        let exact: Vec<_> = self.parameters.iter().map(|(_, value)| value.clone()).collect();
        let floats: Vec<_> = exact.iter().map(|value| Plain(float(value))).collect();
        let number = |expression: &Expression| -> Result<Evaluated> {
            if let Ok(value) = expression.evaluate(&exact, &()) {
                return Ok(Evaluated { value, exact: true });
            }
            let Plain(value) = self.value(expression, &floats, |x| x.0, &|| self.where_parameters())?;
            let not_finite = || self.fail(&expression.key, "is beyond the range of floats");
            Ok(Evaluated { value: BigRational::from_float(value).ok_or_else(not_finite)?, exact: false })
        };
        let cubic = match &self.body {
            // In other formats it stands among the machine's forces.
            Body::Oscillator(system) if self.format == SceneFormat::One => Some(number(&system.cubic)?),
            _ => None,
        };
        let measured = self.whole.measured.as_ref().map(|force| force.file.clone());
        Ok(WrittenMachine { machine: self.whole.machine.try_map(number)?, cubic, measured })
    }

    /// The machine where the engine is `many`, a parameter changed if one is named, each coefficient exact
    /// where it is rational, else between bounds of 256 bits.
    ///
    /// # Errors
    /// An input error, naming file, line and key, for an unknown parameter or a value that cannot be
    /// computed; where the engine is `one`.
    pub(crate) fn enclosed_machine(&self, change: Option<(&str, &BigRational)>) -> Result<Machine<Bounds>> {
        let mut exact: Vec<_> = self.parameters.iter().map(|(_, value)| value.clone()).collect();
        if let Some((name, value)) = change {
            exact[self.parameter(name)?].clone_from(value);
        }
        let precision = Precision::new(256);
        let balls: Vec<_> = exact.iter().map(|value| Ball::ratio(value, &precision)).collect();
        self.machine_scene()?.machine.try_map(|expression| {
            if let Ok(value) = expression.evaluate(&exact, &()) {
                return Ok([value.clone(), value]);
            }
            let fail =
                |message: &str| self.fail(&expression.key, &format!("{message}{}", self.where_parameters()));
            let ball = expression.evaluate(&balls, &precision).map_err(|error| fail(&error.to_string()))?;
            let (lo, hi) = ball.exact_bounds().ok_or_else(|| fail("cannot be enclosed"))?;
            Ok([lo, hi])
        })
    }

    /// What the engine `many` is told.
    ///
    /// # Errors
    /// Where the engine is `one`.
    pub fn machine_scene(&self) -> Result<&MachineScene> {
        match &self.body {
            Body::Machine(scene) => Ok(scene),
            Body::Oscillator(_) => {
                Err(Error::input(format!("{}: is computed by the engine \"one\", not \"many\"", self.file.0)))
            }
        }
    }

    /// Of each stop the volume that wears off for a unit of energy that contacts take, if the scene says it.
    ///
    /// # Errors
    /// A coefficient that has no value, or is negative.
    pub(crate) fn wear(&self) -> Result<Vec<Option<f64>>> {
        let one = |given: &Option<Expression>| {
            let Some(given) = given else { return Ok(None) };
            let value = self.number(given)?;
            if value >= 0.0 {
                Ok(Some(value))
            } else {
                Err(self.fail(&given.key, "is negative: nothing grows by contact"))
            }
        };
        self.whole.wear.iter().map(one).collect()
    }

    /// What the axes of a plane are: `q3` and `u3`, displacement and velocity of a coordinate, `gap NAME` and
    /// `rate NAME`, the gap of a stop and how fast it opens; without names those of the first coordinate.
    ///
    /// # Errors
    /// An input error at `path` for anything else.
    pub(crate) fn plane(
        &self,
        names: &[String],
        machine: &Machine<f64>,
        path: &str,
    ) -> Result<[PlaneAxis; 2]> {
        let fail = |message: String| self.fail(path, &message);
        let axis = |name: &String| {
            let digits = |letter: char| name.strip_prefix(letter)?.parse::<usize>().ok();
            let stop = |word: &str| {
                let given = name.strip_prefix(word)?.strip_prefix(' ')?.trim();
                Some((given.to_string(), machine.stops.iter().position(|stop| stop.name == given)))
            };
            let points = machine.points();
            let within = |i: usize| {
                (1..=points)
                    .contains(&i)
                    .then(|| i - 1)
                    .ok_or_else(|| fail(format!("{name:?}: the machine has the coordinates 1 to {points}")))
            };
            let known = |(given, place): (String, Option<usize>)| {
                let names: Vec<&str> = machine.stops.iter().map(|stop| stop.name.as_str()).collect();
                place.ok_or_else(|| {
                    fail(format!(
                        "{name:?}: {given:?} is no stop of the machine; there are {}",
                        names.join(", ")
                    ))
                })
            };
            match (digits('q'), digits('u'), stop("gap"), stop("rate")) {
                _ if points == 1 && name == "q" => Ok(PlaneAxis::Place(0)),
                _ if points == 1 && name == "u" => Ok(PlaneAxis::Speed(0)),
                (Some(i), ..) => Ok(PlaneAxis::Place(within(i)?)),
                (_, Some(i), ..) => Ok(PlaneAxis::Speed(within(i)?)),
                (_, _, Some(gap), _) => Ok(PlaneAxis::Gap(known(gap)?)),
                (_, _, _, Some(rate)) => Ok(PlaneAxis::Rate(known(rate)?)),
                _ => Err(fail(format!(
                    "{name:?} is neither a displacement, as \"q1\", nor a velocity, \"u1\", nor of a stop, \"gap NAME\" or \
                     \"rate NAME\""
                ))),
            }
        };
        match names {
            [] => Ok([PlaneAxis::Place(0), PlaneAxis::Speed(0)]),
            [first, second] if first != second => Ok([axis(first)?, axis(second)?]),
            _ => Err(fail("must name two different axes, as in [\"q1\", \"u1\"]".into())),
        }
    }

    /// The names of the axes of a plane.
    pub(crate) fn plane_names(&self, names: &[String]) -> [String; 2] {
        match names {
            [first, second] => [first.clone(), second.clone()],
            _ => ["q1".into(), "u1".into()],
        }
    }

    /// Displacements and velocities of all coordinates of the scene, those of a start or 0.
    ///
    /// # Errors
    /// An input error for lists of the wrong length and values that cannot be computed.
    pub(crate) fn rest(&self, start: &Option<Start>, machine: &Machine<f64>) -> Result<[Vec<f64>; 2]> {
        let points = machine.points();
        let part = |given: &CoordinateList| -> Result<Vec<f64>> {
            match given.entries.len() {
                1 if given.entries[0].is_zero() => Ok(vec![0.0; points]),
                found if found == points => given.entries.iter().map(|x| self.number(x)).collect(),
                found => {
                    let message = format!("has {found} entries; the machine has {points} coordinates");
                    let key = given.entries.first().map_or("", |first| first.key.trim_end_matches("[1]"));
                    Err(self.fail(key, &message))
                }
            }
        };
        let Some(start) = start else { return Ok([vec![0.0; points], vec![0.0; points]]) };
        Ok([part(&start.q)?, part(&start.u)?])
    }

    /// The ends of evenly spaced values, which ascend.
    ///
    /// # Errors
    /// An input error that names the key, for values that cannot be computed and a first one that is not
    /// below the last.
    pub(crate) fn ends(&self, values: &Values) -> Result<[f64; 2]> {
        let [from, to] = [self.number(&values.from)?, self.number(&values.to)?];
        if from < to {
            return Ok([from, to]);
        }
        let message = format!("is {from}, not below `to`, which is {to}: values ascend, so exchange them");
        Err(self.fail(&values.from.key, &message))
    }

    /// A state to start from: velocities per radian of the forcing.
    ///
    /// # Errors
    /// An input error that names the key, for lists of the wrong length, values that cannot be computed, and
    /// points of modes that do not tell all their amplitudes.
    pub(crate) fn machine_state(&self, start: &Start, machine: &Machine<f64>, path: &str) -> Result<State> {
        let part = |given: &CoordinateList, name: &str| -> Result<RealVector> {
            let key = format!("{path}.{name}");
            let points = machine.points();
            let values = match given.entries.len() {
                1 if given.entries[0].is_zero() => return Ok(RealVector::zeros(machine.size)),
                found if found == points => {
                    given.entries.iter().map(|x| self.number(x)).collect::<Result<Vec<f64>>>()?
                }
                found => {
                    let message = format!("has {found} entries; the machine has {points} coordinates");
                    return Err(self.fail(&key, &message));
                }
            };
            machine
                .coordinates(&RealVector::from_vec(values))
                .map_err(|error| self.fail(&key, &error.to_string()))
        };
        let (q, u) = (part(&start.q, "q")?, part(&start.u, "u")?);
        Ok(State { t: phase(&start.phase), q, u: u / machine.rate() })
    }
}
