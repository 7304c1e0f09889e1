//! What friction makes of a motion: where sliding ends, what sticks, what slides on.
//!
//! Rows with friction that have velocity slide as it says. Those without one, and the stops that are rested
//! on, are decided together: with D the coupling of all rows held or to be held (`many::contact`), the forces
//! λ_S ≥ 0 of stops and |λ_T| ≤ F_s of what sticks are those for which the stops' gaps do not close, of each
//! stop the force or the acceleration is 0, and what sticks has no acceleration; what slides from rest has
//! the force −σF_k and an acceleration with the sign σ. There may be several answers, above all where F_s >
//! F_k. The one in which the most sticks is taken; among these the one in which most of what stuck before
//! still does; and among these the one in which stops press least: so a mass that friction alone can hold
//! beside a stop leaves the stop alone.
//!
//! Where the normal force is a stop's, F_s and F_k follow its force: known of one that gives way, of one that
//! is rested on a part of what is decided (`many::lean`). Then there may be no answer, or one for which the
//! stop's force would have to pull (Painlevé's paradox): the run ends and says so.

use super::Run;
use crate::{
    error::Result,
    many::{
        Grip, RealVector, State,
        brace::{Brace, chosen},
        contact::Contacts,
        simulate::{
            Event, Stage,
            holds::{Holds, SoftStops},
        },
    },
    motion::{
        Time,
        event::{Release, Reversal, Stick},
        minimum::NUDGE,
    },
};

/// Rows without velocity of which any number may slide on; of more, at most [`FEW`] at one instant.
const MANY: usize = 6;
const FEW: usize = 2;

/// Accelerations within this of their size have no sign.
const SMALL: f64 = 1e-10;

/// How it goes on at one instant.
struct Decided {
    /// The stops that press.
    pressing: Vec<usize>,
    grips: Vec<Grip>,
    /// The sum of the stops' forces.
    load: f64,
}

/// What is to be decided: the accelerations without the forces of what is open.
struct Open<'a> {
    contacts: &'a Contacts,
    /// Of each row.
    accelerations: Vec<f64>,
    stops: Vec<usize>,
    /// The friction without velocity, but for what surely slides.
    rubs: Vec<usize>,
    /// What slides, and what surely does; of the others how they were.
    grips: Vec<Grip>,
    /// The normal force of each row, but for that of a stop rested on, which is open.
    normals: Vec<Option<f64>>,
}

impl Run<'_> {
    /// Where something that slides has lost its velocity.
    pub(super) fn caught(&mut self, time: Time, x: f64, rub: usize) -> Result<()> {
        let (mut state, contacts) = (self.state_at(x), &self.simulator.contacts);
        let row = contacts.rub_row(rub);
        let left = contacts.rubs()[rub].rate(&state);
        state.u.axpy(-left / contacts.mobility(row), contacts.push(row), 1.0);
        self.begun.1.clear();
        self.regrip(time, &state, &[(rub, Grip::Stuck)])
    }

    /// Where what sticks cannot be held any more: the force on it has grown to its bound on the given side,
    /// and it slides to the other.
    pub(super) fn slips(&mut self, time: Time, x: f64, brace: &Brace, side: Grip) -> Result<()> {
        let state = self.state_at(x);
        let way = |&(rub, part): &(usize, f64)| (rub, Grip::of(-side.sign() * part));
        let sure: Vec<(usize, Grip)> = brace.parts.iter().map(way).collect();
        self.regrip(time, &state, &sure)
    }

    /// Decides anew what slides and what sticks, of a machine with friction, beside the stops rested on. Of
    /// rows it may be known that they slide from rest, or, as [`Grip::Stuck`], that they have no velocity.
    pub(in crate::many::simulate) fn regrip(
        &mut self,
        time: Time,
        state: &State,
        sure: &[(usize, Grip)],
    ) -> Result<()> {
        if self.stage.holds.grips.is_empty() {
            return Ok(());
        }
        let (stage, rates) = (self.stage.clone(), self.sliding(state));
        // What begins to slide has no velocity at first, and is not asked again at that instant.
        let begins = |j: usize| sure.iter().all(|one| one.0 != j) && self.is_begun(j, time, &rates);
        let ways =
            stage.holds.grips.iter().copied().enumerate().filter(|(j, way)| way.slides() && begins(*j));
        let known: Vec<_> = sure.iter().copied().chain(ways).collect();
        let Decided { pressing, grips, .. } = self.decide(&stage, time, state, &known)?;
        if grips == stage.holds.grips && pressing == stage.holds.resting {
            if !sure.is_empty() {
                // Nothing changes: on, and surely not to the same place.
                self.change(stage, time, state);
            }
            return Ok(());
        }
        for &stop in stage.holds.resting.iter().filter(|stop| !pressing.contains(stop)) {
            // A rest that is not told yet never was.
            let before = self.events.len();
            let rest = |event: &Event| matches!(event, Event::Stick(stick) if stick.place == stop);
            self.events.retain(|event| !rest(event));
            if self.events.len() == before {
                self.events.push(Event::Release(Release { time, place: stop }));
            }
        }
        let holds = Holds { resting: pressing, grips, ..stage.holds.clone() };
        let stage = self.simulator.stage(&holds)?;
        self.change(stage, time, state);
        Ok(())
    }

    /// Tells what is gripped otherwise than before all that came of one hit, before the rests on stops that
    /// come of it, which may begin later.
    pub(super) fn told_grips(&mut self, time: Time, before: &[Grip]) {
        let contacts = &self.simulator.contacts;
        let now = self.stage.grips();
        let changed = |(j, (&was, is)): (usize, (&Grip, Grip))| {
            let place = contacts.rub_row(j);
            match (was, is) {
                _ if was == is => None,
                (_, Grip::Stuck) => Some(Event::Stick(Stick { time, place, rest: 0.0 })),
                (Grip::Stuck, _) => Some(Event::Release(Release { time, place })),
                (Grip::Open, _) | (_, Grip::Open) => None,
                _ => Some(Event::Reversal(Reversal { time, place })),
            }
        };
        let told: Vec<Event> = before.iter().zip(now).enumerate().filter_map(changed).collect();
        let (rates, now) = (self.sliding(&self.state()), self.stage.grips());
        let begins = |&j: &usize| now[j].slides() && (now[j] != before[j] || self.is_begun(j, time, &rates));
        self.begun = (time, (0..before.len()).filter(begins).collect());
        let rests = self.events.iter().position(|event| matches!(event, Event::Stick(_)));
        let at = rests.unwrap_or(self.events.len());
        self.events.splice(at..at, told);
    }

    /// Whether friction has just begun to slide.
    fn is_begun(&self, rub: usize, time: Time, rates: &[f64]) -> bool {
        let (from, rubs) = &self.begun;
        rubs.contains(&rub) && (rates[rub] == 0.0 || time.since(*from) <= NUDGE)
    }

    /// The grips in contact with these stops: where nothing presses it is open, and where something begins
    /// to, or all velocities have jumped, these tell; what has none stays as it is.
    pub(super) fn grips_with(
        &self,
        state: &State,
        (resting, soft): (&[usize], &SoftStops),
        jumped: bool,
    ) -> Vec<Grip> {
        let before = &self.stage.holds.grips;
        if before.is_empty() {
            return Vec::new();
        }
        let rubs = self.simulator.contacts.rubs();
        let rates = self.sliding(state).into_iter().zip(before);
        let one = |(j, (rate, &before)): (usize, (f64, &Grip))| match rubs[j].stop {
            Some(stop) if !(resting.contains(&stop) || soft.pushing.contains(&stop)) => Grip::Open,
            _ if rate == 0.0 || !jumped && before != Grip::Open => before,
            _ => Grip::of(rate),
        };
        rates.enumerate().map(one).collect()
    }

    /// v at each row with friction; where it is rounding's, 0.
    fn sliding(&self, state: &State) -> Vec<f64> {
        let mut all = self.simulator.sliding(state);
        self.still.iter().for_each(|&j| all[j] = 0.0);
        all
    }

    fn decide(&self, stage: &Stage, time: Time, state: &State, sure: &[(usize, Grip)]) -> Result<Decided> {
        let contacts = &self.simulator.contacts;
        let (mut grips, rubs) = (stage.holds.grips.clone(), contacts.rubs());
        let normal = |j: usize| match rubs[j].stop {
            None => Some(1.0),
            Some(stop) if stage.holds.resting.contains(&stop) => None,
            Some(stop) if stage.holds.soft.pushing.contains(&stop) => {
                let contact = &contacts.all()[stop];
                contact.soft.map(|soft| soft.force(contact.gap(state)).max(0.0))
            }
            Some(_) => Some(0.0),
        };
        let normals: Vec<Option<f64>> = (0..rubs.len()).map(normal).collect();
        // q″ without the forces of stops rested on, and without any friction.
        let mut bend = stage.unheld(time, state);
        let drag = |bend: &mut RealVector, j: usize, sign: f64| {
            let force = sign * rubs[j].sliding * normals[j].unwrap_or(0.0);
            bend.axpy(force, contacts.push(contacts.rub_row(j)), 1.0);
        };
        for (j, grip) in stage.holds.grips.iter().enumerate() {
            drag(&mut bend, j, grip.sign());
        }
        let rates = self.sliding(state);
        let known = |j: usize| sure.iter().find(|sure| sure.0 == j).map(|sure| sure.1);
        // What is a combination of rows without velocity has none, whatever rounding leaves of it.
        let none = |j: &usize| match known(*j) {
            Some(way) => way == Grip::Stuck,
            None => stage.holds.grips[*j] == Grip::Stuck || rates[*j] == 0.0,
        };
        let still = if rubs.len() < 2 { Vec::new() } else { (0..rubs.len()).filter(none).collect() };
        let still = if still.len() < 2 { still } else { contacts.basis(&still) };
        let still: Vec<usize> = still.into_iter().map(|j| contacts.rub_row(j)).collect();
        let mut open = Vec::new();
        for (j, rate) in rates.iter().copied().enumerate() {
            let presses = rubs[j].stop.is_none_or(|stop| {
                stage.holds.resting.contains(&stop) || stage.holds.soft.pushing.contains(&stop)
            });
            let slides = || rate != 0.0 && !contacts.follows(j, &still);
            grips[j] = match (known(j), grips[j]) {
                _ if !presses => Grip::Open,
                (Some(way), _) if way != Grip::Stuck => way,
                (None, grip) if grip != Grip::Stuck && slides() => Grip::of(rate),
                _ => {
                    open.push(j);
                    continue;
                }
            };
            drag(&mut bend, j, -grips[j].sign());
        }
        let rows = contacts.all().len() + rubs.len();
        let accelerations = (0..rows).map(|row| contacts.felt_along(row, &bend, state.t)).collect();
        let stops = stage.holds.resting.clone();
        let mut decided = Open { contacts, accelerations, stops, rubs: open, grips, normals }.decided()?;
        for (j, rub) in rubs.iter().enumerate() {
            let left = |stop: usize| stage.holds.resting.contains(&stop) && !decided.pressing.contains(&stop);
            if rub.stop.is_some_and(left) {
                decided.grips[j] = Grip::Open;
            }
        }
        Ok(decided)
    }
}

impl Open<'_> {
    /// The answer in which the most sticks; where no choice of what slides gives one, what is accelerated the
    /// most by the other forces slides with them.
    fn decided(&self) -> Result<Decided> {
        let most = if self.rubs.len() <= MANY { self.rubs.len() } else { FEW };
        for count in 0..=most {
            let mut best: Option<Decided> = None;
            for sliding in chosen(&self.rubs, count) {
                for ways in 0..1u32 << count {
                    let ways =
                        (0..count).map(|i| if ways >> i & 1 == 0 { Grip::Forward } else { Grip::Backward });
                    let sliding: Vec<(usize, Grip)> = sliding.iter().copied().zip(ways).collect();
                    let Some(found) = self.with(&sliding)? else { continue };
                    let rank = |one: &Decided| (self.released(&one.grips), one.load);
                    if best.as_ref().is_none_or(|best| rank(&found) < rank(best)) {
                        best = Some(found);
                    }
                }
            }
            if let Some(best) = best {
                return Ok(best);
            }
        }
        if self.normals.iter().any(Option::is_none) {
            return Err(self.contacts.paradox(&self.stops));
        }
        let way = |&j: &usize| (j, Grip::of(self.accelerations[self.contacts.rub_row(j)]));
        let mut grips = self.grips.clone();
        self.rubs.iter().map(way).for_each(|(j, grip)| grips[j] = grip);
        Ok(Decided { pressing: self.stops.clone(), grips, load: 0.0 })
    }

    /// How many rows that stuck do not any more.
    fn released(&self, grips: &[Grip]) -> usize {
        let pairs = self.grips.iter().zip(grips);
        pairs.filter(|(was, is)| **was == Grip::Stuck && **is != Grip::Stuck).count()
    }

    /// How it goes on if of the rows without velocity these slide, if it can.
    fn with(&self, sliding: &[(usize, Grip)]) -> Result<Option<Decided>> {
        let (contacts, rubs) = (self.contacts, self.contacts.rubs());
        let stuck: Vec<usize> =
            self.rubs.iter().copied().filter(|j| sliding.iter().all(|known| known.0 != *j)).collect();
        let independent = (stuck.len() > 1).then(|| contacts.basis(&stuck));
        let basis = independent.as_ref().unwrap_or(&stuck);
        let held: Vec<usize> = basis.iter().map(|&j| contacts.rub_row(j)).collect();
        // Surfaces that move otherwise do not hold what depends on one another at once for long.
        if stuck.iter().any(|j| !basis.contains(j) && !contacts.follows(*j, &held)) {
            return Ok(None);
        }
        let mut grips = self.grips.clone();
        stuck.iter().for_each(|&j| grips[j] = Grip::Stuck);
        sliding.iter().for_each(|&(j, way)| grips[j] = way);
        // What the rows feel of the forces of what slides; those under stops that are open lean.
        let known = |j: usize| self.normals[j].unwrap_or(0.0);
        let forces: Vec<(usize, f64)> = sliding
            .iter()
            .map(|&(j, way)| (contacts.rub_row(j), -way.sign() * rubs[j].sliding * known(j)))
            .collect();
        let bend = |row: usize| {
            let felt = forces.iter().map(|&(other, force)| contacts.coupled(row, other) * force);
            self.accelerations[row] + felt.sum::<f64>()
        };
        let stops = &self.stops;
        let Some([holding, pressing]) = self.balanced(&held, &grips, bend)? else { return Ok(None) };
        let normal = |j: usize| {
            self.normals[j].unwrap_or_else(|| {
                let at = stops.iter().position(|stop| Some(*stop) == rubs[j].stop);
                at.map_or(0.0, |at| pressing[at])
            })
        };
        let most = |j: usize| rubs[j].holding * normal(j);
        let can = |needed: f64, most: f64| needed.abs() <= most * (1.0 + SMALL);
        let holds = if basis.len() == stuck.len() {
            stuck.iter().zip(holding.iter()).all(|(&j, force)| can(*force, most(j)))
        } else {
            let force = |(j, factor): &(usize, f64)| {
                let at = basis.iter().position(|known| known == j);
                at.map_or(0.0, |at| factor * holding[at] * contacts.mobility(held[at]))
            };
            let within = |Brace { needed, parts }: &Brace| {
                let parts = parts.iter().map(|&(j, part)| part.abs() * most(j));
                can(needed.iter().map(force).sum(), parts.sum())
            };
            contacts.braces(&stuck)?.iter().all(within)
        };
        if !holds {
            return Ok(None);
        }
        for &(j, way) in sliding {
            let row = contacts.rub_row(j);
            let part = |rows: &[usize], forces: &[f64]| {
                rows.iter()
                    .zip(forces.iter())
                    .map(|(&other, force)| contacts.coupled_along(row, other, &grips) * force)
                    .sum::<f64>()
            };
            let others = part(&held, &holding) + part(stops, &pressing);
            let size = self.accelerations[row].abs()
                + rubs[j].sliding * normal(j) * contacts.mobility(row)
                + others.abs();
            if way.sign() * (bend(row) + others) < -SMALL * size {
                return Ok(None);
            }
        }
        let presses = stops.iter().zip(&pressing).filter(|(_, force)| **force > 0.0);
        Ok(Some(Decided {
            pressing: presses.map(|(&stop, _)| stop).collect(),
            grips,
            load: pressing.iter().sum(),
        }))
    }

    /// What the rows that are held push with, and the stops, where what is held is not accelerated and stops
    /// press or let go; `bend` is what each row feels of everything else.
    fn balanced(
        &self,
        held: &[usize],
        grips: &[Grip],
        bend: impl Fn(usize) -> f64,
    ) -> Result<Option<[Vec<f64>; 2]>> {
        let (contacts, stops) = (self.contacts, &self.stops);
        let between = |rows: &[usize], columns: &[usize]| contacts.among_along(rows, columns, grips);
        if let ([], &[row]) = (&stops[..], held) {
            return Ok(Some([vec![-(1.0 / contacts.mobility(row)) * bend(row)], Vec::new()]));
        }
        let Some(inner) = between(held, held).try_inverse() else { return Ok(None) };
        let own = RealVector::from_iterator(held.len(), held.iter().map(|&row| bend(row)));
        let (cross, back) = (between(stops, held), between(held, stops));
        let mut coupling = between(stops, stops);
        let mut goal = RealVector::from_iterator(stops.len(), stops.iter().map(|&row| bend(row)));
        if !held.is_empty() {
            coupling -= &cross * &inner * &back;
            goal -= &cross * &inner * &own;
        }
        let leaning = contacts.leans(stops, grips);
        for (i, &stop) in stops.iter().enumerate() {
            // A stop along what sticks: no force of it is felt.
            if !leaning && coupling[(i, i)] <= 1e-12 * contacts.mobility(stop) {
                coupling.row_mut(i).fill(0.0);
                coupling.column_mut(i).fill(0.0);
                (coupling[(i, i)], goal[i]) = (1.0, 0.0);
            }
        }
        let Some(pressing) = contacts.loads(stops, grips, (&coupling, &goal))? else { return Ok(None) };
        let load = RealVector::from_column_slice(&pressing);
        let holding = -&inner * (own + back * &load);
        Ok(Some([holding.as_slice().to_vec(), pressing]))
    }
}
