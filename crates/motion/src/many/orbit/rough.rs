//! How a motion that slides and sticks changes with a parameter, on one piece of it.
//!
//! There M q″ = f − C q′ − K q + Wᵀλ with v = W q′ − Q′ = 0 for the rows W that stick, f having the
//! force of those that slide. So
//!
//!   s″ = Π M⁻¹(−C s′ − K s) + h,  h = M⁻¹(f_p − M_p q″ − C_p q′ − K_p q + W_pᵀλ + Wᵀλ_p),
//!   D λ_p = Q″_p − W_p q″ − W M⁻¹(f_p − … + W_pᵀλ),
//!
//! with D = W M⁻¹Wᵀ and Π = 1 − M⁻¹Wᵀ D⁻¹ W: Duhamel's integral, by Gauss's rule on panels short against
//! every motion, exact to rounding.

use super::{Change, leg::LOST};
use crate::{
    error::{Error, Result},
    many::{
        LinearEquations, LinearFlow, Periodic, RealMatrix, RealVector, Slope, State,
        brace::Brace,
        contact::{Contacts, DEPENDENT},
        simulate::{SmoothStage, Stage, What},
    },
    motion::{
        Time,
        flow::{GAUSS, Gradient, Program, Scalar},
    },
};

/// How the motion of a stage changes with a parameter.
pub(super) struct Rough<'c> {
    slope: Slope,
    stage: &'c Stage,
    contacts: &'c Contacts,
    /// What sticks, but for what depends on the rest of it.
    stuck: Vec<usize>,
    /// D⁻¹.
    inverse: RealMatrix,
    change: &'c Change,
}

/// Where forces are formulas, q″ without what sticks, with its derivative.
type Changing = Option<Program<Gradient<2>>>;

impl<'c> Rough<'c> {
    pub(super) fn new(change: &'c Change, stage: &'c Stage, contacts: &'c Contacts) -> Result<Rough<'c>> {
        let signs = stage.holds.grips.iter().map(|grip| grip.sign());
        let slope = change.slope.pushed(contacts, &stage.holds.soft.pushing).dragged(contacts, signs);
        let stuck = stage.holds.held(contacts);
        let turns = |j: usize| slope.rubs[j].row.amax() != 0.0;
        if stage.holds.stuck().count() > stuck.len() && stage.holds.stuck().any(turns) {
            return Err(Error::input(
                "what sticks together has rows that depend on one another and change with the parameter: how that changes \
                 what they hold is not followed",
            ));
        }
        let rows: Vec<usize> = stuck.iter().map(|&j| contacts.rub_row(j)).collect();
        let inverse = contacts.among(&rows).try_inverse().ok_or_else(|| Error::input(DEPENDENT))?;
        Ok(Rough { slope, stage, contacts, stuck, inverse, change })
    }

    /// M⁻¹Wᵀ x.
    fn pushed(&self, x: &RealVector) -> RealVector {
        let rows: Vec<usize> = self.stuck.iter().map(|&j| self.contacts.rub_row(j)).collect();
        let none = RealVector::zeros(self.stage.equations.size());
        if rows.is_empty() { none } else { self.contacts.change(&rows, x.as_slice()) }
    }

    /// For each row that sticks a number.
    fn held(&self, mut of: impl FnMut(usize) -> f64) -> RealVector {
        RealVector::from_iterator(self.stuck.len(), self.stuck.iter().map(|&j| of(j)))
    }

    fn changing(&self) -> Result<Changing> {
        self.change.changing(self.stage, &self.slope)
    }

    /// q″ without what sticks, and how that changes at a state that stays.
    fn free(&self, program: &Changing, at: &State) -> [RealVector; 2] {
        let Rough { slope, stage, .. } = self;
        let n = stage.equations.size();
        let Some(program) = program else {
            let bend = stage.equations.acceleration(at.t, &at.q, &at.u);
            let own = slope.force.at(at.t)
                - &slope.mass * &bend
                - &slope.damping * &at.u
                - &slope.stiffness * &at.q;
            let own = stage.equations.accelerate(&own);
            return [bend, own];
        };
        let state: Vec<_> = at.q.iter().chain(at.u.iter()).map(|x| Gradient::constant(*x)).collect();
        let all = program.all_at(&state, Gradient::constant(at.t));
        [0, 1].map(|part| RealVector::from_fn(n, |i, _| all[i].0[part]))
    }

    /// h and λ_p.
    fn bent(&self, program: &Changing, at: &State) -> (RealVector, RealVector) {
        let Rough { slope, stage, contacts, inverse, .. } = self;
        let (equations, rubs) = (&stage.equations, contacts.rubs());
        let [free, own] = self.free(program, at);
        if self.stuck.is_empty() {
            return (own, RealVector::zeros(0));
        }
        let bend = stage.acceleration(Time::new(0, at.t), at);
        let mut force = &slope.mass * (&free - &bend);
        let load = inverse * self.held(|j| rubs[j].surface(at.t)[1] - rubs[j].row.dot(&free));
        for (&j, load) in self.stuck.iter().zip(load.iter()) {
            force.axpy(*load, &slope.rubs[j].row, 1.0);
        }
        let felt = own + equations.accelerate(&force);
        let by = inverse
            * self.held(|j| {
                let own = &slope.rubs[j];
                own.velocity.at(at.t)[1] - own.row.dot(&bend) - rubs[j].row.dot(&felt)
            });
        (felt + self.pushed(&by), by)
    }

    /// The derivative by the parameter of what is watched of friction, as [`Stage::slopes`] has it.
    pub(super) fn of(&self, what: What, at: &State) -> Result<f64> {
        Ok(match what {
            What::Slide(j) => {
                let own = &self.slope.rubs[j];
                self.stage.holds.grips[j].sign() * (own.row.dot(&at.u) - own.velocity.at(at.t)[0])
            }
            What::Hold(i, side) => {
                let Brace { needed, parts } = &self.stage.braces[i];
                let loads = self.bent(&self.changing()?, at).1;
                let load = |(j, factor): &(usize, f64)| {
                    let place = self.stuck.iter().position(|known| known == j);
                    let mobility = self.contacts.mobility(self.contacts.rub_row(*j));
                    factor * mobility * place.map_or(0.0, |place| loads[place])
                };
                let most = |(j, part): &(usize, f64)| part.abs() * self.slope.rubs[*j].holding;
                parts.iter().map(most).sum::<f64>() - side.sign() * needed.iter().map(load).sum::<f64>()
            }
            // With the sign that it has on this stage.
            What::Kink(k) => {
                let sign = if self.stage.holds.below.contains(&k) { -1.0 } else { 1.0 };
                sign * self.change.switch(k, at)
            }
            _ => 0.0,
        })
    }

    /// The slope after a duration from a state, of that before. Cost: O(n²) for each of 8 points per radian
    /// of the fastest motion.
    pub(super) fn leg(&self, from: &State, duration: f64, mut slope: RealVector) -> Result<RealVector> {
        let Rough { stage, contacts, inverse, .. } = self;
        let (equations, n) = (&stage.equations, stage.equations.size());
        if !self.stuck.is_empty() {
            let u = slope.rows(n, n).into_owned();
            let off = self.held(|j| {
                let own = &self.slope.rubs[j];
                own.velocity.at(from.t)[0] - own.row.dot(&from.u) - contacts.rubs()[j].row.dot(&u)
            });
            let mut part = slope.rows_mut(n, n);
            part += self.pushed(&(inverse * off));
        }
        if duration <= 0.0 {
            return Ok(slope);
        }
        let program = self.changing()?;
        match (&stage.smooth, &program) {
            (Some(smooth), Some(own)) if self.stuck.is_empty() => {
                let own = smooth.changed(own, from, duration)?;
                return Ok(own + smooth.transition(from, duration) * slope);
            }
            (Some(smooth), Some(_)) => return self.stuck_leg((smooth, &program), from, duration, slope),
            _ => {}
        }
        let held;
        let flow = if self.stuck.is_empty() {
            &stage.flow
        } else {
            let kept = |x: &RealMatrix| {
                let columns: Vec<RealVector> = x
                    .column_iter()
                    .map(|column| {
                        let felt = equations.accelerate(&column.into_owned());
                        let load = inverse * self.held(|j| contacts.rubs()[j].row.dot(&felt));
                        let pushed: RealVector = self
                            .stuck
                            .iter()
                            .zip(load.iter())
                            .map(|(&j, load)| &contacts.rubs()[j].row * *load)
                            .sum();
                        column - pushed
                    })
                    .collect();
                RealMatrix::from_columns(&columns)
            };
            let (damping, stiffness) = (kept(&equations.damping), kept(&equations.stiffness));
            let none = Periodic::constant(RealVector::zeros(n));
            held = LinearFlow::new(LinearEquations::new(equations.mass.clone(), damping, stiffness, none)?)?;
            &held
        };
        let order = equations.force.order().max(self.slope.force.order()).max(1);
        let surfaces = contacts.rubs().iter().zip(&self.slope.rubs);
        let order =
            surfaces.fold(order, |most, (rub, own)| most.max(rub.motion.order()).max(own.velocity.order()));
        let rates = flow.rates().into_iter().chain(stage.flow.rates());
        let panels = (duration * rates.fold(f64::from(order), f64::max)).ceil().max(1.0);
        let width = duration / panels;
        let mut last = 0.0;
        let mut steps: Vec<RealMatrix> = Vec::with_capacity(GAUSS.len() + 1);
        for to in GAUSS.iter().map(|(node, _)| *node).chain([1.0]) {
            steps.push(flow.transition(width * (to - last)));
            last = to;
        }
        let now = Time::new(0, from.t);
        for panel in 0..panels as u64 {
            for ((node, weight), step) in GAUSS.iter().zip(&steps) {
                slope = step * slope;
                let gone = width * (panel as f64 + node);
                let at = State { t: now.after(gone).phase, ..stage.after(now, from, gone) };
                let (bent, _) = self.bent(&program, &at);
                slope.rows_mut(n, n).axpy(width * weight, &bent, 1.0);
            }
            slope = &steps[GAUSS.len()] * slope;
        }
        Ok(slope)
    }

    /// The same where something sticks and forces are formulas: a panel for each step of the motion.
    fn stuck_leg(
        &self,
        (smooth, program): (&SmoothStage, &Changing),
        from: &State,
        duration: f64,
        mut slope: RealVector,
    ) -> Result<RealVector> {
        let n = from.q.len();
        let (mut now, mut here, mut left) = (Time::new(0, from.t), from.clone(), duration);
        while left > 0.0 {
            let leap = smooth.leap(now, &here);
            if leap.over().is_some() {
                return Err(Error::input(LOST));
            }
            let width = left.min(leap.h);
            let mut gone = 0.0;
            for (node, weight) in GAUSS {
                let at = leap.state(node * width / leap.h);
                slope = smooth.transition(&here, width * (node - gone)) * slope;
                slope.rows_mut(n, n).axpy(width * weight, &self.bent(program, &at).0, 1.0);
                (here, gone) = (at, node);
            }
            slope = smooth.transition(&here, width * (1.0 - gone)) * slope;
            (now, here) = (leap.time(width / leap.h), leap.state(width / leap.h));
            left -= width;
        }
        Ok(slope)
    }
}
