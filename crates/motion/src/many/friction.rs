//! Dry friction: Coulomb's law at rows of a machine, in coefficients of any kind and in floats.
//!
//! At a row w that slides along a surface with v = w·q′ − (the surface's velocity) the force −F_k sgn v acts
//! along w, F_k = `coefficient` · `normal`. Where v is 0 the machine sticks as long as the force that this
//! takes is at most F_s = `static_coefficient` · `normal`, and slides on otherwise. Nothing is regularised:
//! sliding and sticking are equations of their own ([`Grip`]), linear ones of a linear machine. When one
//! turns into the other is found in `simulate`.
//!
//! The normal force is given, or it is that of a stop: then the machine rubs where the stop is in contact,
//! and at an impact on it. A coefficient may follow the sliding speed (`stribeck`).

use serde::Serialize;

use super::{Machine, RealVector, State, StopLaw, contact::Watch, stribeck::SlidingLaw};
use crate::{
    error::{Error, Result},
    motion::{Harmonic, Series, SmoothForce},
};

/// Dry friction at a row of a machine.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Friction<T> {
    /// What it is called.
    pub name: String,
    /// w, an entry for each coordinate q.
    pub row: Vec<T>,
    /// What presses.
    pub normal: NormalForce<T>,
    /// The force of sliding over the normal force, at least 0. Not used where there is a `law`.
    pub coefficient: T,
    /// The same as a formula in the sliding speed, per unit of time; under a given normal force alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub law: Option<SmoothForce<T>>,
    /// The largest force of sticking over the normal force, at least `coefficient`; of a `law`, 0 for what
    /// that is at rest.
    pub static_coefficient: T,
    /// The constant part of the surface's velocity along w.
    pub speed: T,
    /// The rest of the surface's motion, displacements along w.
    pub harmonics: Vec<Harmonic<T>>,
}

/// What presses where a machine rubs.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum NormalForce<T> {
    /// A given force, at least 0.
    Given(T),
    /// A stop, by its place in the machine.
    Stop {
        /// That place.
        stop: usize,
    },
}

impl<T> NormalForce<T> {
    /// The stop, if it is one's.
    pub fn stop(&self) -> Option<usize> {
        match self {
            NormalForce::Given(_) => None,
            NormalForce::Stop { stop } => Some(*stop),
        }
    }
}

impl<T> Machine<T> {
    /// Refuses a machine with friction, or with forces that have kinks, where motions between impacts must be
    /// smooth.
    ///
    /// # Errors
    /// An input error if there is any.
    pub fn check_no_friction(&self) -> Result<()> {
        if let Some(Friction { name, .. }) = self.friction.first() {
            return Err(Error::input(format!(
                "there is dry friction ({name}): the motion is not followed as one that is smooth between impacts"
            )));
        }
        self.check_no_kinks()
    }

    /// Refuses a machine with forces that have kinks.
    ///
    /// # Errors
    /// An input error if there is any.
    pub(crate) fn check_no_kinks(&self) -> Result<()> {
        let Some(text) = self.kinked() else { return Ok(()) };
        Err(Error::input(format!(
            "a force has kinks ({text}): the motion is not followed as one that is smooth between impacts"
        )))
    }
}

/// Refuses friction under the force of a stop, given by names and stops, where orbits are followed.
///
/// # Errors
/// An input error if there is any.
pub(super) fn check_given<'r>(rubs: impl Iterator<Item = (&'r String, Option<usize>)>) -> Result<()> {
    let on = |(name, stop): (&'r String, Option<usize>)| stop.map(|_| name);
    let Some(name) = rubs.filter_map(on).next() else { return Ok(()) };
    Err(Error::input(format!(
        "the normal force of friction {name} is that of a stop: orbits are followed under given normal forces alone"
    )))
}

impl<T> Friction<T> {
    /// The same with every coefficient converted.
    ///
    /// # Errors
    /// The first error of `convert`.
    pub(crate) fn try_map<U, E>(
        &self,
        mut convert: impl FnMut(&T) -> std::result::Result<U, E>,
    ) -> std::result::Result<Friction<U>, E> {
        Ok(Friction {
            name: self.name.clone(),
            row: self.row.iter().map(&mut convert).collect::<std::result::Result<_, E>>()?,
            normal: match &self.normal {
                NormalForce::Given(force) => NormalForce::Given(convert(force)?),
                NormalForce::Stop { stop } => NormalForce::Stop { stop: *stop },
            },
            coefficient: convert(&self.coefficient)?,
            law: self.law.as_ref().map(|law| law.try_map(&mut convert)).transpose()?,
            static_coefficient: convert(&self.static_coefficient)?,
            speed: convert(&self.speed)?,
            harmonics: self
                .harmonics
                .iter()
                .map(|h| Ok(Harmonic { k: h.k, cos: convert(&h.cos)?, sin: convert(&h.sin)? }))
                .collect::<std::result::Result<_, E>>()?,
        })
    }
}

/// How a machine moves at a row with friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Grip {
    /// It slides with v > 0, or is about to: the force is −F_k.
    Forward,
    /// It slides with v < 0: the force is F_k.
    Backward,
    /// It sticks: v stays 0.
    Stuck,
    /// Nothing presses: the stop whose force it is that does is not in contact.
    Open,
}

impl Grip {
    /// That of a velocity other than 0.
    pub fn of(rate: f64) -> Grip {
        if rate > 0.0 { Grip::Forward } else { Grip::Backward }
    }

    /// The sign of v; 0 where it sticks or nothing presses.
    pub fn sign(self) -> f64 {
        match self {
            Grip::Forward => 1.0,
            Grip::Backward => -1.0,
            Grip::Stuck | Grip::Open => 0.0,
        }
    }

    /// Whether it slides.
    pub fn slides(self) -> bool {
        self.sign() != 0.0
    }
}

/// Friction seen from the machine, velocities being per radian of the forcing.
#[derive(Debug, Clone, PartialEq)]
pub struct Rub {
    /// What it is called.
    pub name: String,
    /// w.
    pub row: RealVector,
    /// The constant part of the surface's velocity.
    pub speed: f64,
    /// The rest of its motion.
    pub motion: Series,
    /// The stop whose force presses, if it is not given.
    pub stop: Option<usize>,
    /// F_k; over that force, where it is a stop's. Of a law, that of the least speeds.
    pub sliding: f64,
    /// F_k where it follows the speed.
    pub law: Option<SlidingLaw>,
    /// F_s, likewise.
    pub holding: f64,
}

impl Rub {
    /// v.
    pub fn rate(&self, at: &State) -> f64 {
        self.row.dot(&at.u) - self.surface(at.t)[0]
    }

    /// The surface's velocity and its derivative.
    pub fn surface(&self, t: f64) -> [f64; 2] {
        let [_, rate, bend] = self.motion.at(t);
        [self.speed + rate, bend]
    }

    /// The surface's velocity along w as a function of time.
    pub fn velocity(&self) -> Series {
        let constant = Series::constant(self.speed);
        Series::combination(&[(1.0, &constant), (1.0, &self.motion.derivative())])
    }

    /// v times a sign.
    pub(crate) fn rate_watch(&self, sign: f64) -> Watch {
        let given = Series::combination(&[(-sign, &self.velocity())]);
        Watch { places: RealVector::zeros(self.row.len()), rates: &self.row * sign, given }
    }
}

impl Machine<f64> {
    /// The friction at its rows.
    ///
    /// # Errors
    /// An input error, led by its name, for a row of zeros or of another length, a negative normal force or
    /// coefficient, a static coefficient below the other, numbers that are not finite.
    pub fn rubs(&self) -> Result<Vec<Rub>> {
        let one = |friction: &Friction<f64>| {
            let row = self.vector("row", &friction.row)?;
            if row.iter().all(|x| *x == 0.0) {
                return Err(Error::input("row is zero: nothing slides"));
            }
            let (pressing, stop) = match friction.normal {
                NormalForce::Given(force) => (force, None),
                NormalForce::Stop { stop } => (1.0, Some(stop)),
            };
            if let Some(stop) = stop {
                let Some(known) = self.stops.get(stop) else {
                    return Err(Error::input(format!("stop {stop} is none of the machine's")));
                };
                if matches!(known.law, StopLaw::Formula(_)) {
                    return Err(Error::input(format!(
                        "stop {} pushes by a law: friction follows a restitution, or stiffness and damping",
                        known.name
                    )));
                }
                if parallel(&row, &self.vector("row", &known.row)?) {
                    return Err(Error::input(format!(
                        "row is that of the stop {}: what slides along a stop moves across its gap",
                        known.name
                    )));
                }
            }
            for (name, value) in [("normal", pressing), ("coefficient", friction.coefficient)] {
                if !(value >= 0.0 && value.is_finite()) {
                    return Err(Error::input(format!("{name} = {value}; it is at least 0")));
                }
            }
            if let (Some(SmoothForce { text, .. }), Some(_)) = (&friction.law, stop) {
                return Err(Error::input(format!(
                    "coefficient = {text} follows the sliding speed, which is taken under a given normal force alone: give \
                     `normal`, or a number"
                )));
            }
            let law = friction.law.as_ref().map(|law| SlidingLaw::new(law, pressing, self.rate()));
            let law = law.transpose()?;
            let kinetic = law.as_ref().map_or(friction.coefficient, SlidingLaw::at_rest);
            let holding = match friction.static_coefficient {
                0.0 if law.is_some() => kinetic,
                given => given,
            };
            if !(holding >= kinetic && holding.is_finite()) {
                return Err(Error::input(format!(
                    "static_coefficient = {holding}, below coefficient = {kinetic}: what sticks holds at least what slides does"
                )));
            }
            if !friction.speed.is_finite() {
                return Err(Error::input(format!("speed = {}; it must be finite", friction.speed)));
            }
            Ok(Rub {
                name: friction.name.clone(),
                row,
                speed: friction.speed / self.rate(),
                motion: Series::new(0.0, &friction.harmonics)?,
                stop,
                sliding: kinetic * pressing,
                law,
                holding: holding * pressing,
            })
        };
        let named = |friction: &Friction<f64>| {
            one(friction).map_err(|error| error.context(format!("friction {}", friction.name)))
        };
        self.friction.iter().map(named).collect()
    }
}

/// Whether one row is a multiple of another, neither of them 0.
fn parallel(a: &RealVector, b: &RealVector) -> bool {
    let (a, b) = (a / a.norm(), b / b.norm());
    (&a - &b).amax().min((&a + &b).amax()) <= 1e-12
}
