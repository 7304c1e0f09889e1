//! Forces that are any smooth function of all displacements, velocities and the time, beside the linear
//! machine: M q″ + C q′ + K q = f(t) + Φᵀ g(t, Φq, ΩΦq′), g being the formulas of the scene.
//!
//! All of it is compiled to one list of operations on Taylor series ([`Program`]), the linear part as sums,
//! so that what the formulas of several coordinates have in common is computed once. A machine that rests on
//! stops, or that soft ones push, is another list, and so is every mode of forces with kinks (`kinks`).
//! `flow` follows motions by it. Not here: what is watched on
//! the way (`simulate`).

mod flow;
mod kinks;
mod laws;
mod record;

use std::{
    f64::consts::TAU,
    sync::{Arc, OnceLock},
};

pub(crate) use flow::{Leap, SmoothFlow};
pub(crate) use kinks::{Switch, SwitchOf};
pub(super) use kinks::{joined, known, number};
pub use record::Record;

use super::{LinearEquations, Machine, Periodic, RealMatrix, RealVector, Slope};
use crate::{
    error::{Error, Result},
    motion::{
        EffectTally, Series, SmoothForce,
        flow::{Drive, Gradient, Outline, Program, Scalar},
    },
};

/// The formulas of a machine, and what they need of it.
#[derive(Debug, Clone)]
pub(crate) struct Smooth {
    /// The point on which each acts; after all points the stops with laws, then the friction with one.
    formulas: Vec<(usize, SmoothForce<f64>)>,
    /// Of each law what a force of 1 there is on the equations' coordinates, and what it is called.
    laws: Vec<(RealVector, String)>,
    /// How many formulas there are but for those of friction.
    without_friction: usize,
    /// Where formulas have kinks.
    switches: Arc<Vec<Switch>>,
    /// The switches that its mode looks at, and these as formulas.
    reached: Vec<usize>,
    sights: Vec<SmoothForce<f64>>,
    /// Φ.
    shape: RealMatrix,
    /// Ω.
    rate: f64,
    /// A force known at times, and its direction.
    record: Option<(Arc<Record>, RealVector)>,
    /// Where its steps are counted, of all clones and all flows; empty where nothing is counted.
    tally: Arc<OnceLock<Arc<EffectTally>>>,
}

/// Phases at which a machine is looked at to linearise it.
const LOOKS: u32 = 64;

/// A machine at rest on stops: ZZᵀM, and what the stops' motions add to its accelerations.
pub(crate) struct Held<'a> {
    /// ZZᵀM.
    pub projection: RealMatrix,
    /// For each stop, b and the stop's place.
    pub lifts: Vec<(RealVector, &'a Series)>,
    /// For each stop v, its force being that of the linear machine less v·Φᵀg.
    pub felt: Vec<RealVector>,
    /// The force of each stop, of the linear machine: by q, by q′ and known.
    pub forces: Vec<&'a super::contact::Watch>,
}

impl Smooth {
    /// The formulas of a machine; none if it has none.
    ///
    /// # Errors
    /// Formulas for another number of coordinates; coefficients that are not finite; those of
    /// [`Machine::direction`].
    pub fn new(machine: &Machine<f64>) -> Result<Option<Smooth>> {
        let record = match &machine.record {
            Some((record, direction)) => {
                Some((Arc::new(record.scaled(machine.rate())), machine.direction(direction)?))
            }
            None => None,
        };
        if !machine.is_smooth() && record.is_none() {
            return Ok(None);
        }
        let points = machine.points();
        if !machine.smooth.is_empty() && machine.smooth.len() != points {
            let found = machine.smooth.len();
            return Err(Error::input(format!(
                "force has {found} entries; the machine has {points} coordinates"
            )));
        }
        let formulas: Vec<(usize, SmoothForce<f64>)> = machine
            .smooth
            .iter()
            .enumerate()
            .filter_map(|(point, force)| Some((point, force.clone()?)))
            .collect();
        if formulas.iter().any(|(_, force)| force.coefficients().iter().any(|x| !x.is_finite())) {
            return Err(Error::input("force has a coefficient that is not finite"));
        }
        let shape = machine.shape().unwrap_or_else(|| RealMatrix::identity(machine.size, machine.size));
        Ok(Some(
            Smooth {
                formulas,
                laws: vec![],
                without_friction: 0,
                switches: Arc::default(),
                reached: vec![],
                sights: vec![],
                shape,
                rate: machine.rate(),
                record,
                tally: Arc::default(),
            }
            .with_kinks(machine)?,
        ))
    }

    /// A force known at times, and its direction on the equations' coordinates.
    pub fn record(&self) -> Option<(&Arc<Record>, &RealVector)> {
        self.record.as_ref().map(|(record, direction)| (record, direction))
    }

    /// What a force of 1 that a formula is on is on the equations' coordinates.
    fn direction(&self, point: usize) -> RealVector {
        match point.checked_sub(self.shape.nrows()) {
            Some(law) => self.laws[law].0.clone(),
            None => self.shape.row(point).transpose(),
        }
    }

    /// What the same formulas change by in a parameter in which the machine's coefficients change at the
    /// rates `slope`.
    ///
    /// # Errors
    /// Those of [`laws::laws`].
    pub fn slope(&self, machine: &Machine<f64>, slope: &Machine<f64>) -> Result<Smooth> {
        let zero =
            |force: &SmoothForce<f64>| force.try_map(&mut |_: &f64| Ok::<_, std::convert::Infallible>(0.0));
        let (rows, columns) = self.shape.shape();
        let shape = slope.shape().unwrap_or_else(|| RealMatrix::zeros(rows, columns));
        let (laws, _) = laws::laws(machine, Some(slope))?;
        let formulas = self.formulas.iter().map(|(point, force)| {
            let known = match point.checked_sub(machine.points()) {
                Some(law) => Some(SmoothForce { coefficients: laws[law].slopes.clone(), ..force.clone() }),
                None => slope.smooth.get(*point).cloned().flatten(),
            };
            (*point, known.unwrap_or_else(|| zero(force).unwrap_or_else(|never| match never {})))
        });
        Ok(Smooth {
            formulas: formulas.collect(),
            laws: laws
                .iter()
                .map(|law| (shape.tr_mul(&law.row[0]) + self.shape.tr_mul(&law.row[1]), String::new()))
                .collect(),
            without_friction: self.without_friction,
            switches: self.switches.clone(),
            reached: vec![],
            sights: vec![],
            shape,
            rate: -machine.rate() * slope.period / machine.period,
            record: None,
            tally: self.tally.clone(),
        })
    }

    /// From now on all steps are counted there.
    pub fn count_in(&self, tally: &Arc<EffectTally>) {
        // The first stays: a machine is made for one task.
        let _ = self.tally.set(tally.clone());
    }

    /// The machine between events: the equations with these forces, at rest on what holds it.
    ///
    /// # Errors
    /// A constant part of a formula that is no number.
    pub fn flow(&self, equations: &LinearEquations, held: Option<&Held>) -> Result<SmoothFlow> {
        let program = self.program(equations, None, held, |value, _| value)?;
        let varied = self.program(equations, None, held, |value, _| Gradient::constant(value))?;
        Ok(SmoothFlow::new(program, varied, equations, self.tally.clone()))
    }

    /// The motion with its derivative in a parameter.
    ///
    /// # Errors
    /// As [`flow`](Self::flow).
    pub fn changing(
        &self,
        equations: &LinearEquations,
        (machine, own): (&Slope, &Smooth),
    ) -> Result<Program<Gradient<2>>> {
        self.program(equations, Some((machine, own)), None, |value, slope| Gradient([value, slope]))
    }

    /// The force on each of the equations' coordinates that a force of 1 in a direction of the points is, as
    /// the outputs of [`flow`](Self::flow) feel it.
    pub fn felt(&self, equations: &LinearEquations, direction: &RealVector, held: Option<&Held>) -> Vec<f64> {
        let own = equations.accelerate(direction);
        let Some(held) = held else { return own.as_slice().to_vec() };
        let acting = &held.projection * &own;
        let forces = held.felt.iter().map(|felt| -felt.dot(direction));
        acting.iter().copied().chain(forces).chain(own.iter().copied()).collect()
    }

    /// The equations linearised at rest, their coefficients averaged over the period and the forces there as
    /// harmonics; those without the formulas where these are not smooth there.
    pub fn linearised(&self, equations: &LinearEquations) -> LinearEquations {
        let (n, mut all) = (equations.size(), equations.clone());
        // At rest friction holds, or not: in neither case is it a damper.
        let mode = (!self.switches.is_empty()).then(|| self.in_mode(&self.below_at_rest(n), &[]));
        let Ok(flow) = mode.as_ref().unwrap_or(self).flow(equations, None) else { return all };
        let zero = RealVector::zeros(n);
        let part = 1.0 / f64::from(LOOKS);
        let (mut by_place, mut by_rate) = (RealMatrix::zeros(n, n), RealMatrix::zeros(n, n));
        let mut force = Periodic::constant(zero.clone());
        let mut waves = vec![[zero.clone(), zero.clone()]; (LOOKS / 4) as usize];
        for i in 0..LOOKS {
            let t = TAU * f64::from(i) * part;
            let Some([place, rate]) = flow.jacobian(t, &zero, &zero) else { return all };
            by_place += place * part;
            by_rate += rate * part;
            let bend = RealVector::from_column_slice(&flow.all_at(t, &zero, &zero)[..n]);
            force.mean += &bend * part;
            for (k, [cos, sin]) in (1..).zip(&mut waves) {
                let (s, c) = (f64::from(k) * t).sin_cos();
                cos.axpy(2.0 * part * c, &bend, 1.0);
                sin.axpy(2.0 * part * s, &bend, 1.0);
            }
        }
        let size = waves.iter().flatten().map(RealVector::amax).fold(force.mean.amax(), f64::max);
        for (k, [cos, sin]) in (1..).zip(waves) {
            if cos.amax().max(sin.amax()) > 1e-14 * size {
                force.add(k, &cos, &sin);
            }
        }
        let forced = force.mapped(&equations.mass);
        if by_place.iter().chain(by_rate.iter()).chain(forced.mean.iter()).all(|x| x.is_finite()) {
            (all.stiffness, all.damping) = (-(&equations.mass * by_place), -(&equations.mass * by_rate));
            all.force = forced;
        }
        all
    }

    /// The outputs: the accelerations; at rest on stops, the forces of these and the accelerations without
    /// them, too.
    fn program<S: Scalar>(
        &self,
        equations: &LinearEquations,
        slope: Option<(&Slope, &Smooth)>,
        held: Option<&Held>,
        make: impl Fn(f64, f64) -> S,
    ) -> Result<Program<S>> {
        let n = equations.size();
        let free = self.free(equations, slope, &make);
        let mut outlines = match held {
            None => free,
            Some(held) => self.held(held, free, |value| make(value, 0.0)),
        };
        for at in 0..self.sights.len() {
            let mut outline = Outline::zero();
            outline.formulas.push((make(1.0, 0.0), self.formulas.len() + at));
            outlines.push(outline);
        }
        let variables = self.variables(slope, &make);
        let mut formulas = Vec::new();
        for (at, (_, force)) in self.formulas.iter().enumerate() {
            let slopes = slope.map(|(_, own)| own.formulas[at].1.coefficients().to_vec());
            let mut place = 0;
            let mut number = |value: &f64| {
                place += 1;
                Ok::<_, Error>(make(*value, slopes.as_ref().map_or(0.0, |all| all[place - 1])))
            };
            formulas.push(force.try_map(&mut number)?);
        }
        for sight in &self.sights {
            formulas.push(sight.try_map(&mut |value: &f64| Ok::<_, Error>(make(*value, 0.0)))?);
        }
        let formulas: Vec<&SmoothForce<S>> = formulas.iter().collect();
        let made = Program::assemble(n, &variables, &formulas, &outlines).map_err(|(at, error)| {
            let points = self.shape.nrows();
            error.context(match self.formulas.get(at) {
                Some((point, _)) if *point >= points => self.laws[point - points].1.clone(),
                Some((point, _)) if points > 1 => format!("force on q{}", point + 1),
                Some(_) => "force".to_string(),
                None => self.sights[at - self.formulas.len()].text.clone(),
            })
        });
        let first = outlines.len() - self.sights.len();
        let pushes = |k: &usize| matches!(self.switches[*k].of, SwitchOf::Push(_));
        let signs = self.reached.iter().enumerate().map(|(at, k)| (first + at, pushes(k))).collect();
        made.map(|mut program| {
            program.watch(signs);
            program
        })
    }

    /// The accelerations without stops, as sums of states, harmonics and formulas.
    fn free<S: Scalar>(
        &self,
        equations: &LinearEquations,
        slope: Option<(&Slope, &Smooth)>,
        make: impl Fn(f64, f64) -> S,
    ) -> Vec<Outline<S>> {
        let n = equations.size();
        // M⁻¹X and its derivative M⁻¹(X′ − M′M⁻¹X).
        let solved = |x: &RealVector, change: Option<&RealVector>| {
            let value = equations.accelerate(x);
            let slope = match (slope, change) {
                (Some((machine, _)), Some(change)) => {
                    equations.accelerate(&(change - &machine.mass * &value))
                }
                _ => RealVector::zeros(n),
            };
            (value, slope)
        };
        let changed = |of: fn(&Slope) -> &RealMatrix, j: usize| {
            slope.map(|(machine, _)| of(machine).column(j).into_owned())
        };
        let mut free = vec![Outline::zero(); n];
        let mut add = |(value, change): (RealVector, RealVector), row: usize, sign: f64| {
            for (i, outline) in free.iter_mut().enumerate() {
                if value[i] != 0.0 || change[i] != 0.0 {
                    outline.inputs.push((make(sign * value[i], sign * change[i]), row));
                }
            }
        };
        for j in 0..n {
            let by_rate = equations.damping.column(j).into_owned();
            add(solved(&by_rate, changed(|machine| &machine.damping, j).as_ref()), n + j, -1.0);
        }
        for j in 0..n {
            let by_place = equations.stiffness.column(j).into_owned();
            add(solved(&by_place, changed(|machine| &machine.stiffness, j).as_ref()), j, -1.0);
        }
        let force = slope.map(|(machine, _)| &machine.force);
        let mean = solved(&equations.force.mean, force.map(|force| &force.mean));
        let mut ks: Vec<u32> = equations.force.harmonics.iter().map(|known| known.0).collect();
        ks.extend(force.into_iter().flat_map(|force| force.harmonics.iter().map(|known| known.0)));
        ks.sort_unstable();
        ks.dedup();
        let zero = RealVector::zeros(n);
        let part = |of: &Periodic, k: u32| {
            let found = of.harmonics.iter().find(|known| known.0 == k);
            found.map_or((zero.clone(), zero.clone()), |(_, a, b)| (a.clone(), b.clone()))
        };
        let waves: Vec<_> = ks
            .iter()
            .map(|&k| {
                let (cos, sin) = part(&equations.force, k);
                let change = force.map(|force| part(force, k));
                let (by_cos, by_sin) = change.map_or((None, None), |(a, b)| (Some(a), Some(b)));
                (f64::from(k), solved(&cos, by_cos.as_ref()), solved(&sin, by_sin.as_ref()))
            })
            .collect();
        for (i, outline) in free.iter_mut().enumerate() {
            outline.constant = make(mean.0[i], mean.1[i]);
            for (k, cos, sin) in &waves {
                let (cos, sin) = (make(cos.0[i], cos.1[i]), make(sin.0[i], sin.1[i]));
                outline.drive.push(Drive { k: *k, cos, sin });
            }
        }
        for (at, (point, _)) in self.formulas.iter().enumerate() {
            let change = slope.map(|(_, own)| own.direction(*point));
            let push = solved(&self.direction(*point), change.as_ref());
            for (i, outline) in free.iter_mut().enumerate() {
                if push.0[i] != 0.0 || push.1[i] != 0.0 {
                    outline.formulas.push((make(push.0[i], push.1[i]), at));
                }
            }
        }
        free
    }

    /// What the formulas see: displacements of all points, then their velocities.
    fn variables<S: Scalar>(
        &self,
        slope: Option<(&Slope, &Smooth)>,
        make: impl Fn(f64, f64) -> S,
    ) -> Vec<Vec<(S, usize)>> {
        let (points, n, shape) = (self.shape.nrows(), self.shape.ncols(), &self.shape);
        let own = |i: usize, j: usize| slope.map_or(0.0, |(_, own)| own.shape[(i, j)]);
        let faster = slope.map_or(0.0, |(_, own)| own.rate);
        let variable = |i: usize, rate: bool| -> Vec<(S, usize)> {
            let term = |j: usize| {
                let (value, change) = (shape[(i, j)], own(i, j));
                let factor = match rate {
                    false => make(value, change),
                    true => make(self.rate * value, faster * value + self.rate * change),
                };
                (factor, if rate { n + j } else { j })
            };
            (0..n).map(term).filter(|term| !term.0.is_zero()).collect()
        };
        [false, true]
            .into_iter()
            .flat_map(|rate| (0..points).map(move |i| (i, rate)))
            .map(|(i, rate)| variable(i, rate))
            .collect()
    }

    /// The outputs at rest on stops: q″ = ZZᵀM q″_free + Σ b Q″, the forces, q″_free.
    fn held<S: Scalar>(
        &self,
        held: &Held,
        free: Vec<Outline<S>>,
        make: impl Fn(f64) -> S,
    ) -> Vec<Outline<S>> {
        let n = free.len();
        let mut all = Vec::with_capacity(2 * n + held.felt.len());
        let series = |outline: &mut Outline<S>, factor: f64, series: &Series| {
            outline.constant = outline.constant + make(factor * series.mean());
            for h in series.harmonics() {
                let (cos, sin) = (make(factor * h.cos), make(factor * h.sin));
                outline.drive.push(Drive { k: f64::from(h.k), cos, sin });
            }
        };
        for i in 0..n {
            let mut outline = Outline::zero();
            for (j, other) in free.iter().enumerate() {
                if held.projection[(i, j)] != 0.0 {
                    outline.add(make(held.projection[(i, j)]), other);
                }
            }
            for (lift, place) in &held.lifts {
                series(&mut outline, lift[i], &place.derivative().derivative());
            }
            all.push(outline);
        }
        // A stop's force balances what the row of its constraint feels of all others.
        for (felt, force) in held.felt.iter().zip(&held.forces) {
            let mut outline = Outline::zero();
            for j in 0..n {
                outline.inputs.push((make(force.places[j]), j));
                outline.inputs.push((make(force.rates[j]), n + j));
            }
            series(&mut outline, 1.0, &force.given);
            for (at, (point, _)) in self.formulas.iter().enumerate() {
                let seen = self.direction(*point).dot(felt);
                outline.formulas.push((make(-seen), at));
            }
            all.push(outline);
        }
        all.extend(free);
        all
    }
}
