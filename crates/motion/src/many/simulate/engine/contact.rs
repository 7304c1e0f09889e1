//! What contact makes of a motion: impacts, rest, the end of rest; contact with soft stops and its end.

use std::{f64::consts::TAU, sync::Arc};

use super::{Found, MOST_CHANGES, Run};
use crate::{
    error::Result,
    many::{
        Blow, Grip, RealVector, State,
        simulate::{
            Event, STILL, SoftStops, Stage, What,
            holds::{Holds, SoftPlace},
        },
    },
    motion::{
        Effect, Time,
        event::{Impact, Release, Shock, Stick, Tangency, Touch},
        minimum::{Hit, NUDGE},
    },
};

impl Run<'_> {
    /// Makes events of a hit.
    pub(super) fn meet(&mut self, stage: &Stage, found: Found) -> Result<()> {
        if stage.holds.grips.is_empty() {
            return self.met(stage, found);
        }
        let time = self.time_at(found.hit.place());
        self.met(stage, found)?;
        self.told_grips(time, &stage.grips());
        Ok(())
    }

    fn met(&mut self, stage: &Stage, Found { watch, hit, z, rounding }: Found) -> Result<()> {
        let (x, half) = (hit.place(), self.half());
        let time = self.time_at(x);
        self.from = x;
        self.still.clear();
        let rubs = |what: &What| what.effect() == Effect::Friction || matches!(what, What::Kink(_));
        self.rubbed = Some(stage.watched[watch]).filter(rubs);
        match (stage.watched[watch], hit) {
            (What::Gap(stop), Hit::Tangency(_)) => {
                self.events.push(Event::Tangency(Tangency { time, place: stop, gap: z[0] }));
            }
            (What::Gap(stop), Hit::Impact(_) | Hit::Press(_)) if self.is_soft(stop) => {
                let radius = (z[0].abs() + rounding) / z[1].abs() * half;
                let velocity = (z[1] / half).min(0.0);
                let soft = self.simulator.contacts.all()[stop].soft;
                let jump = soft.map_or(0.0, |soft| -soft.damping * velocity);
                self.touch(Touch { time, radius: radius + 1e-15, place: stop, velocity, jump });
                self.place(time, x, stop, SoftPlace::Pushing)?;
            }
            (What::Gap(stop), Hit::Press(_)) => {
                let state = self.state_at(x);
                let resting = stage.holds.resting.clone();
                if !self.settle(time, state, &[stop], &resting)? {
                    // The stop presses by no more than rounding: on, and surely not to the same place.
                    self.from = x + NUDGE;
                }
            }
            (What::Gap(stop), Hit::Impact(_)) => {
                // On the wrong side of rounding an impact may seem to leave: it arrives with velocity 0.
                let velocity = (z[1] / half).min(0.0);
                let off = 2.0 * (z[0].abs() + rounding);
                let radius = (off / z[1].abs()).min((off / z[2].abs()).sqrt()) * half;
                self.hit(stage, (x, watch), stop, velocity, z[2] / (half * half), radius)?;
            }
            (_, Hit::Tangency(_)) => {}
            (What::Push(stop), _) => {
                self.events.push(Event::Release(Release { time, place: stop }));
                let contact = &self.simulator.contacts.all()[stop];
                let damped = contact.soft.is_some_and(|soft| soft.damping > 0.0);
                let behind = damped && contact.gap(&self.state_at(x))[0] < 0.0;
                self.place(time, x, stop, if behind { SoftPlace::Behind } else { SoftPlace::Open })?;
            }
            (What::Pull(stop), _) => {
                let velocity = self.simulator.contacts.all()[stop].gap(&self.state_at(x))[1];
                self.touch(Touch { time, radius: 1e-15, place: stop, velocity, jump: 0.0 });
                self.place(time, x, stop, SoftPlace::Pushing)?;
            }
            (What::Rise(stop), _) => self.place(time, x, stop, SoftPlace::Open)?,
            (What::Kink(switch), _) => self.kinked(time, x, switch)?,
            (What::Slide(rub), _) => self.caught(time, x, rub)?,
            (What::Hold(brace, side), _) => self.slips(time, x, &stage.braces[brace], side)?,
            (What::Force(stop), Hit::Impact(_) | Hit::Press(_)) => {
                let state = self.state_at(x);
                let resting: Vec<usize> =
                    stage.holds.resting.iter().copied().filter(|&other| other != stop).collect();
                self.events.push(Event::Release(Release { time, place: stop }));
                self.rest(time, &state, &resting)?;
            }
        }
        Ok(())
    }

    fn is_soft(&self, stop: usize) -> bool {
        self.simulator.contacts.all()[stop].soft.is_some()
    }

    pub(in crate::many::simulate) fn touch(&mut self, touch: Touch<usize>) {
        self.impacts += 1;
        self.events.push(Event::Touch(touch));
    }

    /// A soft stop is somewhere else from x on.
    fn place(&mut self, time: Time, x: f64, stop: usize, place: SoftPlace) -> Result<()> {
        let state = self.state_at(x);
        self.open[stop] = false;
        let mut holds = self.stage.holds.clone();
        holds.soft = holds.soft.with(stop, place);
        if !holds.grips.is_empty() {
            holds.grips = self.grips_with(&state, (&holds.resting, &holds.soft), false);
        }
        self.change(self.simulator.stage(&holds)?, time, &state);
        self.regrip(time, &state, &[])
    }

    /// Where soft stops are after velocities have jumped to those of `state`: some may be thrown off, others
    /// caught before they are open.
    fn soft_after(&mut self, time: Time, state: &State) -> SoftStops {
        let before = self.stage.holds.soft.clone();
        if before.is_empty() {
            return before;
        }
        let mut after = before.clone();
        for (stop, contact) in self.simulator.contacts.all().iter().enumerate() {
            let Some(soft) = contact.soft.filter(|_| contact.force.is_none()) else { continue };
            let gap = contact.gap(state);
            let pushes = soft.force(gap) > 0.0;
            if before.pushing.contains(&stop) && !pushes && soft.damping > 0.0 {
                after = after.with(stop, SoftPlace::Behind);
                self.events.push(Event::Release(Release { time, place: stop }));
            } else if before.behind.contains(&stop) && pushes {
                after = after.with(stop, SoftPlace::Pushing);
                self.impacts += 1;
                let touch = Touch { time, radius: 1e-15, place: stop, velocity: gap[1], jump: 0.0 };
                self.events.push(Event::Touch(touch));
            }
        }
        after
    }

    /// An impact on a stop at x, the gap's rate being `velocity` and its second derivative before it `bend`.
    fn hit(
        &mut self,
        stage: &Stage,
        (x, watch): (f64, usize),
        stop: usize,
        velocity: f64,
        bend: f64,
        radius: f64,
    ) -> Result<()> {
        let (time, simulator) = (self.time_at(x), self.simulator);
        let (depth, mut touched) = (simulator.settings.minimum_depth, vec![stop]);
        let after = (1.0 + x) * self.half();
        let mut y = if stage.smooth.is_some() { RealVector::zeros(0) } else { stage.vector(&self.y) };
        let alone = stage.holds.resting.is_empty() && simulator.contacts.all().len() == 1;
        let mut known = None;
        if !alone {
            let state = if stage.smooth.is_some() {
                self.state_at(x)
            } else {
                stage.flow.advance(&mut y, after);
                stage.join(self.begin() + after, &y)
            };
            let others = simulator.touched(&state).into_iter();
            touched.extend(others.filter(|other| *other != stop && !stage.holds.resting.contains(other)));
            known = Some(state);
        }
        let free = stage.smooth.is_none() && stage.holds.is_free();
        if touched.len() > 1 || !free {
            let state = known.unwrap_or_else(|| self.state_at(x));
            let rate =
                |&j: &usize| if j == stop { velocity } else { simulator.contacts.all()[j].gap(&state)[1] };
            let rates: Vec<f64> = touched.iter().map(rate).collect();
            return self.strike(time, state, &touched, &rates, radius);
        }
        // One stop alone: the motion is kicked where it is.
        let law = simulator.contacts.impact(&[stop], &[velocity])?;
        let mut kick = stage.flow.kick(&law.change);
        stage.flow.advance(&mut kick, -after);
        let kick = stage.padded(&kick);
        // The gap's rate is to change by −(1 + τ) w as the tables see it: what they are off by would add up
        // over many impacts.
        let restitution = simulator.contacts.all()[stop].restitution_at(-velocity);
        let wanted = -(1.0 + restitution) * velocity;
        let seen = stage.slope(watch, x, &kick) / self.half();
        let factor = if (seen / wanted - 1.0).abs() < 1e-6 { wanted / seen } else { 1.0 };
        for (y, kick) in self.y.iter_mut().zip(kick) {
            *y += factor * kick;
        }
        let energy = 0.5 * (1.0 - restitution) * -velocity * law.impulses[0];
        let shock = Shock { impulse: law.impulses[0], energy, together: 1, order_matters: false };
        self.told(time, stop, velocity, radius, shock);
        let bounce = -restitution * velocity;
        let pushed = bend - simulator.drags[stop] * law.impulses[0];
        if pushed < 0.0 && bounce * bounce < -2.0 * pushed * depth {
            let state = self.state_at(x);
            self.settle(time, state, &[stop], &[])?;
        }
        Ok(())
    }

    fn told(&mut self, time: Time, stop: usize, velocity: f64, radius: f64, shock: Shock) {
        self.impacts += 1;
        self.open[stop] = false;
        // The phase is a double below 2π.
        let radius = radius + 1e-15;
        self.events.push(Event::Impact(Impact { time, radius, place: stop, velocity, shock }));
    }

    /// Impacts at one instant on the stops touched, together with those rested on.
    pub(super) fn strike(
        &mut self,
        time: Time,
        mut state: State,
        touched: &[usize],
        rates: &[f64],
        radius: f64,
    ) -> Result<()> {
        let (simulator, resting) = (self.simulator, self.stage.holds.resting.clone());
        let all: Vec<usize> = touched.iter().chain(&resting).copied().collect();
        if all.len() > 1 {
            self.count(Effect::Together);
        }
        let rates: Vec<f64> = rates.iter().copied().chain(resting.iter().map(|_| 0.0)).collect();
        let sliding = simulator.sliding(&state);
        let blow = Blow { stops: &all, rates: &rates, sliding: &sliding, grips: &self.stage.holds.grips };
        let law = simulator.contacts.struck(&blow)?;
        state.u += &law.change;
        // What rounding leaves of velocities before would look like sliding beside those after.
        let rubbing = simulator.contacts.rubbing(&all).into_iter();
        self.still = rubbing.filter(|&j| law.grips[j] == Grip::Stuck).collect();
        let energy = |i: usize| {
            let after = rates[i] + simulator.contacts.held_row(all[i]).0.dot(&law.change);
            -0.5 * law.impulses[i] * (rates[i] + after) + law.rubbed[i]
        };
        // Where no impulse acts there is no impact: the stop is only touched, or another, which may be the
        // same stop once more, has turned the motion already. Nor is one where the gap opened before, or was
        // closed already: what such a stop takes, as others drive the motion into it, the first of them does.
        let still = STILL * rates.iter().fold(0.0, |most: f64, rate| most.max(rate.abs()));
        let hit = |i: usize| i < touched.len() && rates[i] <= still && law.impulses[i] > 0.0;
        let mut beside: f64 = (0..all.len()).filter(|&i| !hit(i)).map(energy).sum();
        for (i, &stop) in touched.iter().enumerate() {
            if rates[i] < 0.0 || law.impulses[i] > 0.0 {
                self.open[stop] = false;
            }
            if hit(i) {
                let shock = Shock {
                    impulse: law.impulses[i],
                    energy: energy(i) + std::mem::take(&mut beside),
                    together: all.len(),
                    order_matters: law.order_matters,
                };
                self.told(time, stop, rates[i].min(0.0), radius, shock);
            }
        }
        let soft = self.soft_after(time, &state);
        let grips = self.grips_with(&state, (&resting, &soft), true);
        let below = self.stage.holds.below.clone();
        let holds = Holds { resting: resting.clone(), soft, grips, below };
        let holds = simulator.decided(holds, None, time, &state)?;
        if holds != self.stage.holds {
            // What it rests on is decided by the forces that act from now on.
            let (before, after) = (self.stage.clone(), simulator.stage(&holds)?);
            self.tell_kinks(time, &state, &before, &after);
            self.enter(after, time, &state);
        }
        if !self.settle(time, state.clone(), touched, &resting)? {
            // Thrown off what it rested on, unless some of it still presses.
            self.rest_among(time, &state, &resting)?;
        }
        Ok(())
    }

    /// Comes to rest on those of the stops touched whose bounce to come, z′ ≥ 0 in `state`, is lower than the
    /// minimum depth, beside those of `resting` that still press. False if nothing is added: then nothing is
    /// changed.
    pub(super) fn settle(
        &mut self,
        time: Time,
        mut state: State,
        touched: &[usize],
        resting: &[usize],
    ) -> Result<bool> {
        let (simulator, depth) = (self.simulator, self.simulator.settings.minimum_depth);
        let (contacts, now) = (simulator.contacts.all(), self.stage.clone());
        let bounce = |j: usize, state: &State| contacts[j].gap(state)[1].max(0.0);
        let held: Vec<usize> = self.held(time, &state, resting)?;
        // z″ of a stop with the forces of those that are held.
        let free = |j: usize, state: &State| now.bend(&simulator.contacts, j, time, state);
        let accelerations: Vec<f64> = held.iter().map(|&j| free(j, &state)).collect();
        let grips = &now.holds.grips;
        let forces = simulator.contacts.pressing(&held, &accelerations, grips)?;
        let helped = simulator.contacts.change_along(&held, &forces, grips);
        let pressed = |j: usize| free(j, &state) + contacts[j].row.dot(&helped);
        let mut added: Vec<(usize, f64)> = Vec::new();
        for &j in touched {
            let (v, a) = (bounce(j, &state), pressed(j));
            if a < 0.0 && v * v < -2.0 * a * depth {
                let tau = contacts[j].restitution;
                let rest = if tau < 1.0 { 2.0 * v / (-a * (1.0 - tau)) } else { 0.0 };
                added.push((j, rest));
            }
        }
        if added.is_empty() {
            return Ok(false);
        }
        let all: Vec<usize> = held.iter().copied().chain(added.iter().map(|known| known.0)).collect();
        // What still moves away is brought to rest, all at once: the bounces left out. With them goes what
        // slides there, and what has no velocity along the stops keeps none.
        let grips = self.grips_with(&state, (&all, &now.holds.soft), false);
        let rubbing = simulator.contacts.rubbing(&all);
        let still: Vec<usize> = rubbing.into_iter().filter(|&j| !grips[j].slides()).collect();
        let held = still.iter().map(|&j| simulator.contacts.rub_row(j));
        let rows: Vec<usize> = all.iter().copied().chain(held).collect();
        let along: Vec<f64> = simulator.contacts.rubs().iter().map(|rub| rub.rate(&state)).collect();
        let rate = |&row: &usize| match contacts.get(row) {
            Some(contact) => -contact.gap(&state)[1],
            None => -along[row - contacts.len()],
        };
        let rates = RealVector::from_iterator(rows.len(), rows.iter().map(rate));
        if let Some(stopped) = simulator.contacts.among_along(&rows, &rows, &grips).lu().solve(&rates) {
            state.u += simulator.contacts.change_along(&rows, stopped.as_slice(), &grips);
        }
        let accelerations: Vec<f64> = all.iter().map(|&j| free(j, &state)).collect();
        let forces = simulator.contacts.pressing(&all, &accelerations, &grips)?;
        let mut pressing: Vec<usize> = (0..all.len()).filter(|&i| forces[i] > 0.0).map(|i| all[i]).collect();
        pressing.sort_unstable();
        if !added.iter().any(|(j, _)| pressing.contains(j)) {
            return Ok(false);
        }
        self.still = still;
        let grips = self.grips_with(&state, (&pressing, &now.holds.soft), false);
        let holds = Holds { resting: pressing.clone(), grips, ..now.holds.clone() };
        let stage = simulator.stage(&holds)?;
        let longest = added.iter().map(|known| known.1).fold(0.0, f64::max);
        if longest > 0.0 && !steady(&stage, time, &state, longest) {
            // The stop changes its mind before the bounces end: one by one, then.
            return Ok(false);
        }
        for &j in resting.iter().filter(|j| !pressing.contains(j)) {
            self.events.push(Event::Release(Release { time, place: j }));
        }
        for (stop, rest) in added {
            if pressing.contains(&stop) {
                self.open[stop] = false;
                self.events.push(Event::Stick(Stick { time: time.after(rest), place: stop, rest }));
            }
        }
        self.change(stage, time, &state);
        self.regrip(time, &state, &[])?;
        Ok(true)
    }

    /// Those of the stops rested on that are not left by the velocities of `state`.
    fn held(&self, time: Time, state: &State, resting: &[usize]) -> Result<Vec<usize>> {
        let rate = |j: usize| self.simulator.contacts.all()[j].gap(state)[1];
        let stays = |&&j: &&usize| rate(j) <= 0.0 || self.is_slow(j, time, state);
        Ok(resting.iter().filter(stays).copied().collect())
    }

    /// Whether with its rate a gap changes by less than the minimum depth until the acceleration turns it.
    pub(super) fn is_slow(&self, stop: usize, time: Time, state: &State) -> bool {
        let (contacts, depth) = (&self.simulator.contacts, self.simulator.settings.minimum_depth);
        let (v, a) = (contacts.all()[stop].gap(state)[1], self.stage.bend(contacts, stop, time, state));
        v * v < 2.0 * a.abs() * depth
    }

    /// Goes on resting on those of the stops that still press, after others were hit.
    fn rest_among(&mut self, time: Time, state: &State, resting: &[usize]) -> Result<()> {
        let held = self.held(time, state, resting)?;
        for &stop in resting.iter().filter(|j| !held.contains(j)) {
            self.events.push(Event::Release(Release { time, place: stop }));
        }
        self.rest(time, state, &held)
    }

    /// Rests on those of the stops, none of which is left by velocity, that press; the others let go.
    fn rest(&mut self, time: Time, state: &State, stops: &[usize]) -> Result<()> {
        let simulator = self.simulator;
        let accelerations: Vec<f64> =
            stops.iter().map(|&j| self.stage.bend(&simulator.contacts, j, time, state)).collect();
        let grips = self.grips_with(state, (stops, &self.stage.holds.soft), false);
        let forces = simulator.contacts.pressing(stops, &accelerations, &grips)?;
        let mut pressing = Vec::new();
        for (&stop, force) in stops.iter().zip(forces) {
            if force > 0.0 {
                pressing.push(stop);
            } else {
                self.events.push(Event::Release(Release { time, place: stop }));
            }
        }
        pressing.sort_unstable();
        let grips = self.grips_with(state, (&pressing, &self.stage.holds.soft), false);
        let stage = simulator.stage(&Holds { resting: pressing, grips, ..self.stage.holds.clone() })?;
        self.change(stage, time, state);
        self.regrip(time, state, &[])
    }

    pub(in crate::many::simulate) fn change(&mut self, stage: Arc<Stage>, time: Time, state: &State) {
        for &stop in stage.holds.resting.iter().chain(&self.stage.holds.resting) {
            self.open[stop] = false;
        }
        self.changes += 1;
        self.enter(stage, time, state);
        if self.changes > MOST_CHANGES {
            // On, by what rounding may move a place.
            self.from = (self.from + NUDGE).min(1.0);
        }
    }
}

/// Whether the forces of what is rested on are within a factor of their values at `state` for `duration`.
fn steady(stage: &Stage, time: Time, state: &State, duration: f64) -> bool {
    let near = |now: &[f64], later: &[f64]| {
        now.iter().zip(later).all(|(now, later)| (later / now - 1.0).abs() <= 0.5)
    };
    if let Some(smooth) = &stage.smooth {
        let later = smooth.after(time, state, duration);
        return near(&smooth.forces(time, state), &smooth.forces(time.after(duration), &later));
    }
    let forces = |t: f64, y: &RealVector| -> Vec<f64> {
        let period = (t / TAU).floor() * TAU;
        stage.forces(t - period, y)
    };
    let mut y = stage.split(state);
    let now = forces(state.t, &y);
    stage.flow.advance(&mut y, duration);
    let later = forces(state.t + duration, &y);
    near(&now, &later)
}
