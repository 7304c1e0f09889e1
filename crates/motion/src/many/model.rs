//! A machine with coefficients of any kind, in the units of its scene, and its equations in floats.

use std::f64::consts::TAU;

use serde::Serialize;

use super::{
    Friction, LinearEquations, Periodic, RealMatrix, RealVector, SpeedLaw, State, equations::check_symmetric,
};
use crate::{
    error::{Error, Result},
    many::smooth::Record,
    motion::{Series, SmoothForce, Wall},
};

/// M q″ + C q′ + K q = f₀ + Σ (f_k cos kΩt + g_k sin kΩt) + g(Ωt, q, q′), Ω = 2π/T, in consistent units, with
/// stops; most machines have no g.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Machine<T> {
    /// Degrees of freedom n.
    pub size: usize,
    /// T: the period of the forcing; without forcing, what is called a period.
    pub period: T,
    /// The nonzero entries of M by row and column, which is symmetric and positive definite.
    pub mass: Vec<(usize, usize, T)>,
    /// The nonzero entries of C.
    pub damping: Vec<(usize, usize, T)>,
    /// Damping ratios added to C in the modes of M and K, in the order of their frequencies; one for all, or
    /// none.
    pub damping_ratio: Vec<T>,
    /// The nonzero entries of K.
    pub stiffness: Vec<(usize, usize, T)>,
    /// Φ by rows: q = Φη, where the equations are those of η and forces, rows of stops and states are given
    /// for q. None where q = η.
    pub shapes: Vec<Vec<T>>,
    /// f₀, an entry for each coordinate q, or none for zero.
    pub force: Vec<T>,
    /// The harmonics of the force.
    pub forcing: Vec<Load<T>>,
    /// On each coordinate q any smooth function of all of them, of their velocities and of the phase, or
    /// none; empty where there is none at all.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub smooth: Vec<Option<SmoothForce<T>>>,
    /// A force known at times, once and not periodic, and what a force of 1 is on each coordinate q.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub record: Option<(Record, Vec<T>)>,
    /// The stops.
    pub stops: Vec<Stop<T>>,
    /// The dry friction, empty where there is none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub friction: Vec<Friction<T>>,
}

/// A harmonic of the force, on all coordinates: none for zero.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Load<T> {
    /// The multiple k ≥ 1 of the base frequency.
    pub k: u32,
    /// The coefficients of cos kΩt.
    pub cos: Vec<T>,
    /// The coefficients of sin kΩt.
    pub sin: Vec<T>,
}

/// A stop for the gap z = `row`·q − `wall`(t).
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stop<T> {
    /// What it is called.
    pub name: String,
    /// w, an entry for each coordinate q.
    pub row: Vec<T>,
    /// Its place, motion and restitution.
    pub wall: Wall<T>,
    /// What contact with it does.
    #[serde(skip_serializing_if = "StopLaw::is_newton")]
    pub law: StopLaw<T>,
}

/// What contact with a stop does.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub enum StopLaw<T> {
    /// It is rigid, z stays ≥ 0: an impact turns z′ into −τ z′, τ being the wall's restitution.
    Newton,
    /// It gives way, and z may be negative: then it pushes along w with the force −(`stiffness` z +
    /// `damping` z′), unless that would pull. The wall's restitution is not used.
    Soft {
        /// Force per displacement, above 0.
        stiffness: T,
        /// Force per velocity, at least 0.
        damping: T,
    },
    /// It is rigid as Newton's is, τ being a function of the impact's speed. The wall's restitution is not
    /// used.
    Speed(SpeedLaw<T>),
    /// It gives way: where the depth d = −z is positive it pushes along w with the force that a formula in d
    /// and in the speed of closing v = −z′, per unit of time, says, unless that is negative. The wall's
    /// restitution is not used.
    Formula(SmoothForce<T>),
}

impl<T> StopLaw<T> {
    /// Whether it is Newton's.
    pub fn is_newton(&self) -> bool {
        matches!(self, StopLaw::Newton)
    }

    /// Whether the stop is rigid.
    pub fn is_rigid(&self) -> bool {
        matches!(self, StopLaw::Newton | StopLaw::Speed(_))
    }

    /// The same law with every coefficient converted.
    ///
    /// # Errors
    /// The first error of `convert`.
    pub(crate) fn try_map<U, E>(
        &self,
        convert: &mut impl FnMut(&T) -> std::result::Result<U, E>,
    ) -> std::result::Result<StopLaw<U>, E> {
        Ok(match self {
            StopLaw::Newton => StopLaw::Newton,
            StopLaw::Speed(law) => StopLaw::Speed(law.try_map(convert)?),
            StopLaw::Formula(force) => StopLaw::Formula(force.try_map(convert)?),
            StopLaw::Soft { stiffness, damping } => {
                StopLaw::Soft { stiffness: convert(stiffness)?, damping: convert(damping)? }
            }
        })
    }
}

impl<T> Machine<T> {
    /// The same machine with every coefficient converted.
    ///
    /// # Errors
    /// The first error of `convert`.
    pub fn try_map<U, E>(
        &self,
        mut convert: impl FnMut(&T) -> std::result::Result<U, E>,
    ) -> std::result::Result<Machine<U>, E> {
        let convert = &mut convert;
        let load = |load: &Load<T>, convert: &mut _| -> std::result::Result<_, E> {
            Ok(Load { k: load.k, cos: list(&load.cos, convert)?, sin: list(&load.sin, convert)? })
        };
        let stop = |stop: &Stop<T>, convert: &mut _| -> std::result::Result<_, E> {
            let (row, wall) = (list(&stop.row, convert)?, stop.wall.try_map(&mut *convert)?);
            Ok(Stop { name: stop.name.clone(), row, wall, law: stop.law.try_map(convert)? })
        };
        Ok(Machine {
            size: self.size,
            period: convert(&self.period)?,
            mass: entries(&self.mass, convert)?,
            damping: entries(&self.damping, convert)?,
            damping_ratio: list(&self.damping_ratio, convert)?,
            stiffness: entries(&self.stiffness, convert)?,
            shapes: self
                .shapes
                .iter()
                .map(|row| list(row, convert))
                .collect::<std::result::Result<_, E>>()?,
            force: list(&self.force, convert)?,
            forcing: self
                .forcing
                .iter()
                .map(|one| load(one, convert))
                .collect::<std::result::Result<_, E>>()?,
            smooth: self
                .smooth
                .iter()
                .map(|force| force.as_ref().map(|force| force.try_map(&mut *convert)).transpose())
                .collect::<std::result::Result<_, E>>()?,
            record: match &self.record {
                Some((record, direction)) => Some((record.clone(), list(direction, convert)?)),
                None => None,
            },
            stops: self.stops.iter().map(|one| stop(one, convert)).collect::<std::result::Result<_, E>>()?,
            friction: self
                .friction
                .iter()
                .map(|one| one.try_map(&mut *convert))
                .collect::<std::result::Result<_, E>>()?,
        })
    }
}

impl<T> Machine<T> {
    /// Whether a force on it is a formula: then its motion is no sum of modes.
    pub fn is_smooth(&self) -> bool {
        self.smooth.iter().any(Option::is_some) || self.has_laws() || self.has_sliding_laws()
    }

    /// Whether a stop pushes by a formula.
    pub(crate) fn has_laws(&self) -> bool {
        self.stops.iter().any(|stop| matches!(stop.law, StopLaw::Formula(_)))
    }

    /// Whether friction follows a law of the sliding speed.
    pub(crate) fn has_sliding_laws(&self) -> bool {
        self.friction.iter().any(|friction| friction.law.is_some())
    }

    /// What of its forces has kinks, if anything has.
    pub fn kinked(&self) -> Option<String> {
        let forces = self.smooth.iter().flatten().filter(|force| force.formula.chooses());
        let laws = self.stops.iter().filter(|stop| matches!(stop.law, StopLaw::Formula(_)));
        forces
            .map(|force| force.text.clone())
            .chain(laws.map(|stop| format!("law of stop {}", stop.name)))
            .next()
    }

    /// The number of coordinates q.
    pub fn points(&self) -> usize {
        if self.shapes.is_empty() { self.size } else { self.shapes.len() }
    }
}

fn list<T, U, E>(
    all: &[T],
    convert: &mut impl FnMut(&T) -> std::result::Result<U, E>,
) -> std::result::Result<Vec<U>, E> {
    all.iter().map(convert).collect()
}

fn entries<T, U, E>(
    all: &[(usize, usize, T)],
    convert: &mut impl FnMut(&T) -> std::result::Result<U, E>,
) -> std::result::Result<Vec<(usize, usize, U)>, E> {
    all.iter().map(|(i, j, x)| Ok((*i, *j, convert(x)?))).collect()
}

impl Machine<f64> {
    /// Ω = 2π/T: a velocity per radian of the forcing times this is one per unit of time.
    pub fn rate(&self) -> f64 {
        TAU / self.period
    }

    /// The equations with the forcing's phase as time: MΩ², CΩ, K; without the forces that are formulas.
    ///
    /// # Errors
    /// An input error for a period that is not positive, sizes that do not fit, coefficients that are not
    /// finite, M that is not symmetric and positive definite, damping ratios without symmetric K ≥ 0.
    #[doc(hidden)]
    pub fn equations(&self) -> Result<LinearEquations> {
        if !(self.period > 0.0 && self.period.is_finite()) {
            return Err(Error::input(format!("the period is {}; it must be positive", self.period)));
        }
        let rate = self.rate();
        let mut damping = self.matrix("damping", &self.damping)? * rate;
        let mass = self.matrix("mass", &self.mass)?;
        check_symmetric(&mass)?;
        let mass = mass * (rate * rate);
        let stiffness = self.matrix("stiffness", &self.stiffness)?;
        if !self.damping_ratio.is_empty() {
            damping += super::modes::damping(&mass, &stiffness, &self.damping_ratio)?;
        }
        let mut force = Periodic::constant(self.vector("force", &self.force)?);
        for load in &self.forcing {
            if load.k == 0 {
                return Err(Error::input("a harmonic with k = 0: give a constant as force instead"));
            }
            force.add(
                load.k,
                &self.vector("forcing: cos", &load.cos)?,
                &self.vector("forcing: sin", &load.sin)?,
            );
        }
        LinearEquations::new(mass, damping, stiffness, force)
    }

    /// Refuses formulas that are no forces.
    ///
    /// # Errors
    /// Formulas for another number of coordinates; coefficients that are not finite; a constant part that is
    /// no number, as a root of a negative one.
    pub fn check_forces(&self) -> Result<()> {
        // What friction takes has checks of its own.
        match super::smooth::Smooth::new(&Machine { friction: Vec::new(), ..self.clone() })? {
            Some(smooth) => smooth.in_mode(&[], &[]).flow(&self.equations()?, None).map(drop),
            None => Ok(()),
        }
    }

    /// w and the place of each stop.
    ///
    /// # Errors
    /// As [`equations`](Self::equations), led by the stop's name; also for a row of zeros, a negative
    /// restitution, and a soft stop without stiffness or with negative damping.
    pub fn contacts(&self) -> Result<Vec<super::contact::StopContact>> {
        let one = |stop: &Stop<f64>| {
            let row = self.vector("row", &stop.row)?;
            if row.iter().all(|x| *x == 0.0) {
                let given = stop.row.iter().any(|x| *x != 0.0);
                let seen = if given { "no mode moves it" } else { "row is zero" };
                return Err(Error::input(format!("{seen}: no motion reaches the stop")));
            }
            let restitution = stop.wall.restitution;
            if !(restitution >= 0.0 && restitution.is_finite()) {
                return Err(Error::input(format!("restitution = {restitution}; it is at least 0")));
            }
            let position = Series::new(stop.wall.offset, &stop.wall.harmonics)?;
            let mut restitution = restitution;
            let (mut law, mut force) = (None, None);
            let soft = match &stop.law {
                StopLaw::Newton => None,
                StopLaw::Speed(given) => {
                    given.check()?;
                    restitution = given.at(0.0)[0];
                    law = Some(given.scaled(self.rate()));
                    None
                }
                StopLaw::Formula(given) => {
                    if given.coefficients().iter().any(|x| !x.is_finite()) {
                        return Err(Error::input("law has a coefficient that is not finite"));
                    }
                    let own = super::push::StopForce::new(given, self.rate());
                    if own.pulls() {
                        return Err(Error::input(
                            "law is negative at every depth, so that the stop never pushes: the law is how hard it pushes \
                             where the depth d is above 0; turn its sign",
                        ));
                    }
                    force = Some(own);
                    Some(super::contact::SoftContact { stiffness: 0.0, damping: 0.0 })
                }
                &StopLaw::Soft { stiffness, damping } => {
                    if !(stiffness > 0.0 && stiffness.is_finite()) {
                        return Err(Error::input(format!(
                            "stiffness = {stiffness}; that of a soft stop is positive"
                        )));
                    }
                    if !(damping >= 0.0 && damping.is_finite()) {
                        return Err(Error::input(format!("damping = {damping}; it is at least 0")));
                    }
                    Some(super::contact::SoftContact { stiffness, damping: damping * self.rate() })
                }
            };
            let name = stop.name.clone();
            Ok(super::contact::StopContact { name, row, position, restitution, law, soft, force })
        };
        let named =
            |stop: &Stop<f64>| one(stop).map_err(|error| error.context(format!("stop {}", stop.name)));
        self.stops.iter().map(named).collect()
    }

    /// Φ, none for the identity.
    pub(crate) fn shape(&self) -> Option<RealMatrix> {
        let n = self.size;
        (!self.shapes.is_empty()).then(|| RealMatrix::from_fn(self.points(), n, |i, j| self.shapes[i][j]))
    }

    /// The coordinates q of amplitudes η.
    pub fn displaced(&self, eta: &[f64]) -> Vec<f64> {
        self.seen(&RealVector::from_column_slice(eta)).as_slice().to_vec()
    }

    /// What is seen of coordinates η.
    pub fn seen(&self, eta: &RealVector) -> RealVector {
        self.shape().map_or_else(|| eta.clone(), |shape| shape * eta)
    }

    /// The amplitudes η with coordinates q.
    ///
    /// # Errors
    /// An input error where the shapes at the points do not tell all amplitudes.
    pub fn coordinates(&self, q: &RealVector) -> Result<RealVector> {
        let Some(shape) = self.shape() else { return Ok(q.clone()) };
        if q.iter().all(|x| *x == 0.0) {
            return Ok(RealVector::zeros(self.size));
        }
        let found = (shape.nrows() == shape.ncols()).then(|| shape.lu().solve(q)).flatten();
        found.filter(|eta| eta.iter().all(|x| x.is_finite())).ok_or_else(|| {
            Error::input("the shapes at the coordinates do not determine the modes' amplitudes: start from 0, or leave `shapes` out")
        })
    }

    /// The state at phase `t` with these displacements and velocities of the coordinates, per unit of time.
    ///
    /// # Errors
    /// An input error for lists of another length, and where the shapes at the points do not tell all
    /// amplitudes.
    pub fn state(&self, t: f64, q: &[f64], u: &[f64]) -> Result<State> {
        let points = self.points();
        if q.len() != points || u.len() != points {
            return Err(Error::input(format!("a start has {points} displacements and velocities")));
        }
        let part = |given: &[f64]| self.coordinates(&RealVector::from_column_slice(given));
        Ok(State { t, q: part(q)?, u: part(u)? / self.rate() })
    }

    /// A force on the coordinates q as one on the amplitudes.
    ///
    /// # Errors
    /// As [`equations`](Self::equations).
    pub fn direction(&self, values: &[f64]) -> Result<RealVector> {
        self.vector("direction", values)
    }

    pub(super) fn vector(&self, name: &str, values: &[f64]) -> Result<RealVector> {
        let points = self.points();
        if values.is_empty() {
            return Ok(RealVector::zeros(self.size));
        }
        if values.len() != points {
            let found = values.len();
            return Err(Error::input(format!(
                "{name} has {found} entries; the machine has {points} coordinates"
            )));
        }
        if values.iter().any(|x| !x.is_finite()) {
            return Err(Error::input(format!("{name} has an entry that is not finite")));
        }
        let given = RealVector::from_column_slice(values);
        Ok(self.shape().map_or_else(|| given.clone(), |shape| shape.tr_mul(&given)))
    }

    pub(super) fn matrix(&self, name: &str, entries: &[(usize, usize, f64)]) -> Result<RealMatrix> {
        let mut matrix = RealMatrix::zeros(self.size, self.size);
        for &(i, j, x) in entries {
            if i >= self.size || j >= self.size {
                let size = self.size;
                return Err(Error::input(format!(
                    "{name} has an entry in row {}, column {}; the machine has {size} coordinates",
                    i + 1,
                    j + 1
                )));
            }
            if !x.is_finite() {
                return Err(Error::input(format!("{name} has an entry that is not finite")));
            }
            matrix[(i, j)] += x;
        }
        Ok(matrix)
    }
}
