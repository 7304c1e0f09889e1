//! A stage whose forces are formulas: no tables, but steps of Taylor series, on each of which everything that
//! is watched is a polynomial.

use std::{f64::consts::TAU, sync::Arc};

use super::holds::What;
use crate::{
    error::{Error, Result},
    many::{
        Grip, LinearEquations, RealMatrix, RealVector, State,
        algebra::stacked,
        brace::Brace,
        contact::{Contacts, Watch},
        equations::Constrained,
        smooth::{Held, Leap, Record, Smooth, SmoothFlow},
    },
    motion::{
        Series, Time,
        flow::{GAUSS, Gradient, Program, Scalar, TERMS, too_many},
    },
};

/// How a machine with smooth forces moves in a stage.
#[derive(Debug)]
pub(crate) struct SmoothStage {
    pub flow: SmoothFlow,
    sights: Vec<Sight>,
    /// The longest step on which known functions of time are polynomials, too: with 24 terms of a sine what
    /// is left out is below 2²⁴/24! < 10⁻¹⁶ of the amplitude at 2 radians.
    longest: f64,
    /// Which output the accelerations without any stop begin at.
    free: usize,
    size: usize,
    /// A force known at times, and what the outputs feel of a force of 1.
    record: Option<(Arc<Record>, Vec<f64>)>,
}

/// The rows that are held, their forces as those of the linear machine, the constrained motion, and what
/// bounds the forces of what sticks.
type Kept<'a> = (&'a [usize], &'a [Watch], &'a Constrained, &'a [Brace]);

/// Something that is watched.
#[derive(Debug)]
enum Sight {
    /// By displacements, velocities and the time.
    Seen(Watch),
    /// Outputs times factors, and what is seen.
    Outputs(Vec<(usize, f64)>, Watch),
}

impl SmoothStage {
    /// The stage of `equations`, with what is watched, in the mode in which these switches are negative;
    /// where it rests on stops or sticks, with the rows that are held, their forces as those of the linear
    /// machine, the constrained motion, and what bounds the forces of what sticks.
    pub fn new(
        (smooth, modes): (&Smooth, &[usize]),
        equations: &LinearEquations,
        contacts: &Contacts,
        watches: &[(What, Watch)],
        grips: &[Grip],
        held: Option<Kept>,
    ) -> Result<SmoothStage> {
        let n = equations.size();
        let rows = held.map_or(&[][..], |known| known.0);
        // The outputs after the n accelerations are the forces, in the order of the rows.
        let output = |row: usize| n + rows.iter().position(|known| *known == row).unwrap_or(0);
        let none = |constant: f64| Watch::constant(n, constant);
        let first = if held.is_some() { 2 * n + rows.len() } else { n };
        let below = |k: usize| if modes.contains(&k) { -1.0 } else { 1.0 };
        let place = |k: usize| first + smooth.reached().iter().position(|known| *known == k).unwrap_or(0);
        let sights = watches.iter().map(|(what, watch)| match *what {
            What::Kink(k) => Sight::Outputs(vec![(place(k), below(k))], none(0.0)),
            What::Force(stop) => Sight::Outputs(vec![(output(stop), 1.0)], none(0.0)),
            What::Hold(i, side) => {
                let Brace { needed, parts } = &held.expect("what sticks is held").3[i];
                let one = |(j, factor): &(usize, f64)| (output(contacts.rub_row(*j)), -side.sign() * factor);
                let mut outputs: Vec<(usize, f64)> = needed.iter().map(one).collect();
                let mut known = none(0.0);
                for (j, part) in parts {
                    let rub = &contacts.rubs()[*j];
                    let most = rub.holding * part.abs();
                    match rub.stop {
                        None => known = known.with(1.0, &none(most)),
                        Some(stop) if rows.contains(&stop) => {
                            outputs.push((output(stop), most / contacts.mobility(stop)));
                        }
                        Some(stop) => {
                            let unit = contacts.all()[stop].soft.map_or(0.0, |soft| soft.unit());
                            known = known.with(most * unit, &contacts.all()[stop].push_watch(1.0));
                        }
                    }
                }
                Sight::Outputs(outputs, known)
            }
            _ => Sight::Seen(watch.clone()),
        });
        let (sights, next) = (sights.collect(), n + rows.len());
        let held = match held {
            None => None,
            Some((rows, forces, constrained, _)) => Some(Held {
                projection: constrained.projection.clone(),
                lifts: (0..)
                    .zip(rows)
                    .map(|(i, &row)| (constrained.lift.column(i).into_owned(), contacts.held_row(row).1))
                    .collect(),
                felt: contacts.felt(rows, grips)?.into_iter().map(|(_, felt)| felt).collect(),
                forces: forces.iter().collect(),
            }),
        };
        let order = watches.iter().map(|(_, watch)| watch.given.order()).max().unwrap_or(0);
        Ok(SmoothStage {
            flow: smooth.flow(equations, held.as_ref())?,
            sights,
            longest: 2.0 / f64::from(order),
            free: if held.is_some() { next } else { 0 },
            size: n,
            record: smooth.record().map(|(record, direction)| {
                (record.clone(), smooth.felt(equations, direction, held.as_ref()))
            }),
        })
    }

    /// The next step from a state.
    pub fn leap(&self, time: Time, state: &State) -> Leap {
        let (given, left) = self.recorded(time);
        self.flow.leap(time, state, self.longest.min(left), &given)
    }

    /// Whether a force is recorded: steps end at its samples, and are as many as these.
    pub fn is_recorded(&self) -> bool {
        self.record.is_some()
    }

    /// What the outputs feel of the recorded force at a time, a value and a slope each, and for how long; of
    /// no record nothing, for ever.
    fn recorded(&self, time: Time) -> (Vec<[f64; 2]>, f64) {
        let Some((record, weights)) = &self.record else { return (Vec::new(), f64::INFINITY) };
        let (value, slope, left) = record.at(time);
        (weights.iter().map(|by| [by * value, by * slope]).collect(), left)
    }

    /// All outputs at a state.
    fn all_at(&self, time: Time, state: &State) -> Vec<f64> {
        let mut all = self.flow.all_at(time.phase, &state.q, &state.u);
        if let Some((record, weights)) = &self.record {
            let (value, ..) = record.at(time);
            all.iter_mut().zip(weights).for_each(|(output, by)| *output += by * value);
        }
        all
    }

    /// q″ with the forces of the stops rested on.
    pub fn acceleration(&self, time: Time, state: &State) -> RealVector {
        RealVector::from_column_slice(&self.all_at(time, state)[..self.size])
    }

    /// Of what is watched the derivatives by q, by q′ and by the time, at a state.
    pub fn slopes(&self, watch: usize, state: &State) -> (RealVector, f64) {
        match &self.sights[watch] {
            Sight::Seen(watch) => (stacked(&watch.places, &watch.rates), watch.given.at(state.t)[1]),
            Sight::Outputs(outputs, watch) => {
                let mut all = (stacked(&watch.places, &watch.rates), watch.given.at(state.t)[1]);
                for (output, factor) in outputs {
                    let (by_state, by_time) = self.flow.output_slopes(*output, state.t, &state.q, &state.u);
                    all = (all.0 + by_state * *factor, all.1 + by_time * factor);
                }
                all
            }
        }
    }

    /// q″ without them.
    pub fn unheld(&self, time: Time, state: &State) -> RealVector {
        RealVector::from_column_slice(&self.all_at(time, state)[self.free..self.free + self.size])
    }

    /// The forces of the stops rested on, as the accelerations that they prevent.
    pub fn forces(&self, time: Time, state: &State) -> Vec<f64> {
        let all = self.all_at(time, state);
        if self.free == 0 { Vec::new() } else { all[self.size..self.free].to_vec() }
    }

    /// The state after a duration; where it cannot be followed, not a number.
    pub fn after(&self, time: Time, state: &State, duration: f64) -> State {
        let (mut now, mut here, mut left, mut steps) = (time, state.clone(), duration, 0);
        loop {
            steps += 1;
            let leap = self.leap(now, &here);
            if left <= leap.h {
                return leap.state(left / leap.h);
            }
            if leap.over().is_some() || !self.is_recorded() && too_many(steps, duration - left) {
                let none = RealVector::from_element(self.size, f64::NAN);
                return State { t: time.after(duration).phase, q: none.clone(), u: none };
            }
            (now, here, left) = (leap.time(1.0), leap.state(1.0), left - leap.h);
        }
    }

    /// ∂(q, q′) after a duration by (q, q′) before, of a machine without a recorded force.
    pub fn transition(&self, state: &State, duration: f64) -> RealMatrix {
        self.flow.flown(state, duration).1
    }

    /// The same over one step, no longer than `longest`, with a recorded force, if there is one; and how far
    /// that goes.
    pub fn step_transition(&self, time: Time, state: &State, longest: f64) -> (RealMatrix, f64) {
        let (given, left) = self.recorded(time);
        self.flow.step_transition(state, longest.min(left), &given)
    }

    /// How (q, q′) after a duration changes with a parameter, the state before being fixed, by the motion
    /// with its derivative.
    ///
    /// # Errors
    /// A motion that cannot be followed.
    pub fn changed(&self, program: &Program<Gradient<2>>, from: &State, duration: f64) -> Result<RealVector> {
        let start = from.q.iter().chain(from.u.iter()).map(|x| Gradient::constant(*x)).collect();
        let end = self.flow.carried(program, start, from.t, duration);
        let slopes = RealVector::from_iterator(2 * self.size, end.iter().map(|x| x.0[1]));
        if slopes.iter().all(|x| x.is_finite()) {
            Ok(slopes)
        } else {
            Err(Error::input("how the motion changes with the parameter could not be followed"))
        }
    }

    /// The determinant of [`transition`](Self::transition), by Liouville: exp ∫ tr ∂q″/∂q′ dt; NaN where the
    /// motion cannot be followed.
    pub fn determinant(&self, state: &State, duration: f64) -> f64 {
        let trace =
            |State { t, q, u }: &State| self.flow.jacobian(*t, q, u).map_or(f64::NAN, |by| by[1].trace());
        self.integral(Time::new(0, state.t), state, duration, trace).exp()
    }

    /// The integral of a function along the motion, by Gauss's rule on each step; NaN where that cannot be
    /// followed.
    pub fn integral(&self, time: Time, state: &State, duration: f64, of: impl Fn(&State) -> f64) -> f64 {
        let (mut now, mut here, mut left, mut sum) = (time, state.clone(), duration, 0.0);
        loop {
            let leap = self.leap(now, &here);
            let part = (left / leap.h).min(1.0);
            for (x, weight) in GAUSS {
                sum += part * leap.h * weight * of(&leap.state(part * x));
            }
            if left <= leap.h {
                return sum;
            }
            if leap.over().is_some() {
                return f64::NAN;
            }
            (now, here, left) = (leap.time(1.0), leap.state(1.0), left - leap.h);
        }
    }

    /// What is watched on a step, as a polynomial, and the sum of the moduli of what its value at x = 0 was
    /// added up from.
    pub fn polynomial(&self, leap: &Leap, watch: usize) -> ([f64; TERMS], f64) {
        match &self.sights[watch] {
            Sight::Outputs(outputs, watch) => {
                let (mut all, mut size) = seen(leap, watch);
                for (output, factor) in outputs {
                    let own = leap.outputs[*output];
                    size += own[0].abs();
                    all.iter_mut().zip(own).for_each(|(sum, c)| *sum += factor * c);
                }
                (all, size)
            }
            Sight::Seen(watch) => seen(leap, watch),
        }
    }
}

/// A functional along a step, and the sum of the moduli of what its value at x = 0 was added up from.
pub(crate) fn seen(leap: &Leap, watch: &Watch) -> ([f64; TERMS], f64) {
    let (mut all, mut size) = ([0.0; TERMS], 0.0);
    for (j, row) in leap.q.iter().enumerate() {
        let (place, rate) = (watch.places[j], watch.rates[j] / leap.h);
        if place != 0.0 {
            all.iter_mut().zip(row).for_each(|(sum, c)| *sum += place * c);
            size += (place * row[0]).abs();
        }
        if rate != 0.0 {
            for k in 1..TERMS {
                all[k - 1] += rate * k as f64 * row[k];
            }
            size += (rate * row[1]).abs();
        }
    }
    watch.given.add_taylor(1.0, leap.start.phase, leap.h, &mut all);
    (all, size + known(&watch.given, leap.start.phase))
}

fn known(series: &Series, t: f64) -> f64 {
    let t = t - (t / TAU).floor() * TAU;
    series.mean().abs().max(series.at(t)[0].abs())
}
