//! The equations of a pattern with their derivatives in the unknowns and in a parameter, and the linearised
//! motion once around.

use std::f64::consts::TAU;

use super::{Between, Change, Itinerary, turned};
use crate::{
    continuation::Linearised,
    error::{Error, Result},
    many::{
        RealMatrix, RealVector, State,
        algebra::stacked,
        contact::{Contacts, StopContact},
        orbit::leg::LegPassage,
        simulate::Simulator,
    },
};

/// The equations at one machine.
#[derive(Clone, Copy)]
pub(crate) struct StopEquations<'s> {
    pub between: Between<'s>,
    pub contacts: &'s Contacts,
    pub pattern: &'s Itinerary,
    /// The unit of X and V.
    pub scale: f64,
    /// Rows with friction that stick all the time, with the places at which they are to: any place of a
    /// stretch is one.
    pub pins: &'s [(usize, f64)],
}

impl<'s> StopEquations<'s> {
    pub fn new(between: Between<'s>, pattern: &'s Itinerary, scale: f64) -> StopEquations<'s> {
        StopEquations { between, contacts: between.contacts, pattern, scale, pins: &[] }
    }

    /// n.
    pub fn size(&self) -> usize {
        self.between.flow.equations().size()
    }

    /// The stop of impact i.
    pub fn contact(&self, i: usize) -> &'s StopContact {
        &self.contacts.all()[self.pattern.strikes()[i].place]
    }

    /// (1 + τ) M⁻¹wᵀ/(w M⁻¹wᵀ), by which the velocities change for each V of an impact of speed V.
    pub fn kick(&self, i: usize, speed: f64) -> RealVector {
        self.pushed(i, self.contact(i).restitution_at(speed))
    }

    /// How the change of velocities changes with V: τ + Vτ′ in place of τ.
    fn kick_slope(&self, i: usize, speed: f64) -> RealVector {
        self.pushed(i, self.contact(i).restitution_slope(speed))
    }

    fn pushed(&self, i: usize, restitution: f64) -> RealVector {
        let stop = self.pattern.strikes()[i].place;
        self.contacts.push(stop) * ((1.0 + restitution) / self.contacts.mobility(stop))
    }

    pub fn duration(&self, times: &[f64], i: usize) -> Result<f64> {
        let m = times.len();
        let duration = times[(i + 1) % m] - times[i] + TAU * f64::from(self.pattern.strikes()[i].periods);
        if duration > 0.0 {
            Ok(duration)
        } else {
            Err(Error::input("an impact does not follow the one before"))
        }
    }

    /// X, the times and the speeds of unknowns.
    pub fn split(&self, z: &[f64]) -> (State, Vec<f64>, Vec<f64>) {
        let n = self.size();
        let impacts = &z[2 * n..];
        let times: Vec<f64> = impacts.iter().step_by(2).copied().collect();
        let speeds = impacts.iter().skip(1).step_by(2).map(|v| v * self.scale).collect();
        let part = |from: usize| RealVector::from_fn(n, |i, _| z[from + i] * self.scale);
        let t = times.first().copied().unwrap_or(0.0);
        (State { t: turned(t), q: part(0), u: part(n) }, times, speeds)
    }

    /// F and ∂F/∂z, by the flow's own derivatives, and ∂F/∂p if it is told how the machine changes. Cost: O(m
    /// (n + m)² n), and for ∂F/∂p that of [`Change::leg`] for each impact.
    pub fn linearise(&self, z: &[f64], change: Option<&Change>) -> Result<Linearised> {
        let (n, m, s) = (self.size(), self.pattern.strikes().len(), self.scale);
        let (first, _, _) = self.split(z);
        let (mut state, times, speeds) = self.begun(z)?;
        let unknowns = 2 * n + 2 * m;
        // The derivative of the state at the time of the present impact, just after it: by the unknowns and,
        // last, by the parameter.
        let mut d = RealMatrix::zeros(2 * n, unknowns + 1);
        d.view_mut((0, 0), (2 * n, 2 * n)).fill_diagonal(s);
        let (mut residual, mut jacobian) = (Vec::new(), Vec::new());
        for i in 0..m {
            let next = (i + 1) % m;
            let (time, speed) = (2 * n + 2 * next, 2 * n + 2 * next + 1);
            let duration = self.duration(&times, i)?;
            let LegPassage { mut end, phi, slope, fields } =
                self.between.passage(&state, duration, change)?;
            end.t = turned(times[next]);
            let [begin, arrival] =
                fields.unwrap_or_else(|| [self.between.field(&state), self.between.field(&end)]);
            d = &phi * d;
            let earlier = &phi * begin;
            add_column(&mut d, 2 * n + 2 * i, -1.0, &earlier);
            add_column(&mut d, time, 1.0, &arrival);
            if change.is_some() {
                add_column(&mut d, unknowns, 1.0, &slope);
            }
            let contact = self.contact(next);
            let [_, speed_of_stop, bend_of_stop] = contact.position.at(end.t);
            let [gap, rate] = contact.gap(&end);
            let seen = |from: usize| -> Vec<f64> {
                let part = d.rows(from, n);
                (0..=unknowns).map(|j| contact.row.dot(&part.column(j)) / s).collect()
            };
            let (mut gap_row, mut rate_row) = (seen(0), seen(n));
            gap_row[time] -= speed_of_stop / s;
            rate_row[time] -= bend_of_stop / s;
            rate_row[speed] += 1.0;
            let stop = self.pattern.strikes()[next].place;
            if let Some(change) = change {
                let [gap, rate] = change.gap(stop, &end);
                gap_row[unknowns] += gap / s;
                rate_row[unknowns] += rate / s;
            }
            residual.extend([gap / s, (rate + speeds[next]) / s]);
            jacobian.extend([gap_row, rate_row]);
            let kick = self.kick_slope(next, speeds[next]);
            end.u.axpy(speeds[next], &self.kick(next, speeds[next]), 1.0);
            for k in 0..n {
                d[(n + k, speed)] += kick[k] * s;
            }
            if let Some(change) = change {
                for (k, by) in change.kick(stop, speeds[next]).iter().enumerate() {
                    d[(n + k, unknowns)] += by * speeds[next];
                }
            }
            state = end;
        }
        if m == 0 {
            let duration = TAU * f64::from(self.pattern.periods());
            let LegPassage { end, phi, slope, .. } = self.between.passage(&state, duration, change)?;
            d = phi * d;
            if change.is_some() {
                add_column(&mut d, unknowns, 1.0, &slope);
            }
            state = end;
        }
        let (now, then) = (stacked(&state.q, &state.u), stacked(&first.q, &first.u));
        for k in 0..2 * n {
            residual.push((now[k] - then[k]) / s);
            let mut row: Vec<f64> = d.row(k).iter().map(|x| x / s).collect();
            row[k] -= 1.0;
            jacobian.push(row);
        }
        self.settle(&first, (&mut residual, &mut jacobian));
        self.pin(&first, (&mut residual, &mut jacobian));
        let slope = jacobian.iter_mut().map(|row| row.pop().unwrap_or(0.0)).collect();
        Ok(Linearised { residual, jacobian, slope })
    }

    /// Along drifts the state need not come back: in the equations that say so there, it is asked to begin
    /// at 0.
    fn settle(&self, first: &State, (residual, jacobian): (&mut [f64], &mut [Vec<f64>])) {
        let Some(drifts) = self.between.drifts else { return };
        let (n, columns) = (self.size(), jacobian.first().map_or(0, Vec::len));
        let begin = residual.len() - 2 * n;
        let off = drifts
            .part(&(RealVector::from_column_slice(&residual[begin..begin + n]) - &first.q / self.scale));
        (0..n).for_each(|k| residual[begin + k] -= off[k]);
        (0..columns).for_each(|j| {
            let by = |k: usize| jacobian[begin + k][j] - f64::from(u8::from(j == k));
            let off = drifts.part(&RealVector::from_fn(n, |k, _| by(k)));
            (0..n).for_each(|k| jacobian[begin + k][j] -= off[k]);
        });
    }

    /// How far it comes per forcing period along drifts, in each coordinate of the scene.
    pub fn drifted(&self, z: &[f64]) -> Result<Vec<f64>> {
        let Some(drifts) = self.between.drifts else { return Ok(Vec::new()) };
        let periods = f64::from(self.pattern.periods());
        let moved = self.state(z, TAU * periods)?.q - self.begun(z)?.0.q;
        Ok((drifts.seen(&moved) / periods).as_slice().to_vec())
    }

    /// X of given times and speeds: the equations of periodicity are linear in it, unless there are soft
    /// stops; with dry friction they are solved by a few of Newton's steps. Where they have no one solution
    /// (a motion without stiffness or damping), the smallest of the best. Where forces are formulas, the
    /// motion that the forces bring about, pushed at the stop to where it is met.
    pub fn complete(&self, impacts: &[f64]) -> Result<Vec<f64>> {
        let mut z = vec![0.0; 2 * self.size()];
        z.extend(impacts);
        let has = |what: fn(&Simulator) -> bool| self.between.soft.is_some_and(what);
        if has(Simulator::is_smooth) && !impacts.is_empty() {
            return Ok(self.met(z));
        }
        for _ in 0..if has(Simulator::is_smooth) || has(Simulator::is_rough) { COMPLETED } else { 1 } {
            z = self.completed(z)?;
        }
        Ok(z)
    }

    /// The motion that the forces bring about at the first impact, with gap and rate as just after it.
    fn met(&self, mut z: Vec<f64>) -> Vec<f64> {
        let (n, (mut state, _, speeds)) = (self.size(), self.split(&z));
        let forced = self.between.flow.outward(&self.between.flow.particular(state.t));
        if forced.iter().all(|x| x.is_finite()) {
            (state.q, state.u) = (forced.rows(0, n).into_owned(), forced.rows(n, n).into_owned());
        }
        let (stop, contact) = (self.pattern.strikes()[0].place, self.contact(0));
        let push = self.contacts.push(stop) / self.contacts.mobility(stop);
        let [gap, rate] = contact.gap(&state);
        let after = contact.restitution_at(speeds[0]) * speeds[0];
        state.q.axpy(-gap, &push, 1.0);
        state.u.axpy(after - rate, &push, 1.0);
        z.iter_mut().zip(state.q.iter().chain(state.u.iter())).for_each(|(z, x)| *z = x / self.scale);
        z
    }

    /// One step of it.
    fn completed(&self, mut z: Vec<f64>) -> Result<Vec<f64>> {
        let n = self.size();
        let Linearised { residual, jacobian, .. } = self.linearise(&z, None)?;
        let rows = 2 * self.pattern.strikes().len();
        let matrix = RealMatrix::from_fn(2 * n, 2 * n, |i, j| jacobian[rows + i][j]);
        let right = RealVector::from_fn(2 * n, |i, _| -residual[rows + i]);
        let size = right.amax().max(1.0);
        let known = matrix.clone().lu().solve(&right).filter(|x| x.amax() <= 1e10 * size);
        let found = match known {
            Some(x) => x,
            None => matrix
                .svd(true, true)
                .solve(&right, 1e-10)
                .map_err(|error| Error::input(format!("no state to start from: {error}")))?,
        };
        z[..2 * n].iter_mut().zip(found.iter()).for_each(|(x, change)| *x += change);
        Ok(z)
    }

    /// The state a time ≥ 0 after the first impact (after phase 0 without impacts).
    pub fn state(&self, z: &[f64], mut left: f64) -> Result<State> {
        let (mut state, times, speeds) = self.begun(z)?;
        for i in 0..times.len() {
            let (next, duration) = ((i + 1) % times.len(), self.duration(&times, i)?);
            if left <= duration {
                break;
            }
            state = self.between.after(&state, duration)?;
            state.t = turned(times[next]);
            state.u.axpy(speeds[next], &self.kick(next, speeds[next]), 1.0);
            left -= duration;
        }
        self.between.after(&state, left)
    }

    /// The states leg by leg, from just after an impact to just before the next, without impacts once around:
    /// both ends, and evenly between, at least `places` for each period. Cost: once around.
    pub fn legs(&self, z: &[f64], places: u32) -> Result<Vec<Vec<State>>> {
        let (mut state, times, speeds) = self.begun(z)?;
        let mut all = Vec::new();
        for leg in 0..times.len().max(1) {
            let duration = match times.len() {
                0 => TAU * f64::from(self.pattern.periods()),
                _ => self.duration(&times, leg)?,
            };
            let count = (duration / TAU * f64::from(places)).ceil().max(1.0);
            let mut own = vec![state];
            for _ in 0..count as u64 {
                own.push(self.between.after(&own[own.len() - 1], duration / count)?);
            }
            state = own[own.len() - 1].clone();
            all.push(own);
            if !times.is_empty() {
                let next = (leg + 1) % times.len();
                state.t = turned(times[next]);
                state.u.axpy(speeds[next], &self.kick(next, speeds[next]), 1.0);
            }
        }
        Ok(all)
    }

    /// The motion linearised once around, after the first impact, at fixed times.
    ///
    /// At an impact a displacement δ before it becomes S δ, S = J + (f⁻ − κ z″ − f⁺)(w, 0)/V, where J = I − κ
    /// (0, w) is Newton's law with κ = (0, (1 + τ + Vτ′) M⁻¹wᵀ/(w M⁻¹wᵀ)), f = (q′, q″), z″ the gap's second
    /// derivative before it, and w δq/V the delay of the impact.
    pub fn monodromy(&self, z: &[f64]) -> Result<RealMatrix> {
        let (n, m) = (self.size(), self.pattern.strikes().len());
        let (mut state, times, speeds) = self.begun(z)?;
        if m == 0 {
            return Ok(self.between.passage(&state, TAU * f64::from(self.pattern.periods()), None)?.phi);
        }
        let mut all = RealMatrix::identity(2 * n, 2 * n);
        for i in 0..m {
            let next = (i + 1) % m;
            let duration = self.duration(&times, i)?;
            let LegPassage { mut end, phi, fields, .. } = self.between.passage(&state, duration, None)?;
            all = phi * all;
            end.t = turned(times[next]);
            let (contact, kick) = (self.contact(next), self.kick(next, speeds[next]));
            let before = fields.map_or_else(|| self.between.field(&end), |[_, arrival]| arrival);
            let bend = contact.row.dot(&before.rows(n, n)) - contact.position.at(end.t)[2];
            end.u.axpy(speeds[next], &kick, 1.0);
            let kappa = stacked(&RealVector::zeros(n), &self.kick_slope(next, speeds[next]));
            let turn = (before - &kappa * bend - self.between.field(&end)) / speeds[next];
            let zero = RealVector::zeros(n);
            let delay = stacked(&contact.row, &zero).transpose() * &all;
            let rate = stacked(&zero, &contact.row).transpose() * &all;
            all += turn * delay - kappa * rate;
            state = end;
        }
        Ok(all)
    }

    /// The determinant of [`monodromy`](Self::monodromy), by Liouville.
    pub fn determinant(&self, z: &[f64]) -> Result<f64> {
        let (mut state, times, speeds) = self.begun(z)?;
        let m = times.len();
        let lost = |i: usize| {
            let contact = self.contact(i);
            contact.restitution_at(speeds[i]) * contact.restitution_slope(speeds[i])
        };
        let factor: f64 = (0..m).map(lost).product();
        let whole = TAU * f64::from(self.pattern.periods());
        if self.between.soft.is_none() || m == 0 {
            return Ok(self.between.determinant(&state, whole)? * factor);
        }
        let mut all = factor;
        for i in 0..m {
            let (next, duration) = ((i + 1) % m, self.duration(&times, i)?);
            all *= self.between.determinant(&state, duration)?;
            state = self.between.after(&state, duration)?;
            state.t = turned(times[next]);
            state.u.axpy(speeds[next], &self.kick(next, speeds[next]), 1.0);
        }
        Ok(all)
    }
}

/// Newton's steps towards a state to start from.
const COMPLETED: usize = 6;

fn add_column(matrix: &mut RealMatrix, j: usize, factor: f64, column: &RealVector) {
    matrix.column_mut(j).axpy(factor, column, 1.0);
}
