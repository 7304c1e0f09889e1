//! Legs among dry friction: what slides, sticks and turns round on the way, with derivatives.
//!
//! Friction is passed through as contact with soft stops is: pieces of a leg end where it changes, too, and
//! no unknown belongs to that. Where g(t, q, q′, p) has fallen to 0 on the stage so far, a motion beside this
//! one comes there δt = −δg/g′ later, and δq′ becomes δq′ + (q″⁻ − q″⁺) δt; of what sticks from then on v
//! does not change but with the surface. That holds for displacements and for the slope s by a parameter p,
//! of which g has a derivative of its own.
//!
//! On a piece, M q″ = f − C q′ − K q + Wᵀλ with v = W q′ − Q′ = 0 for the rows W that stick, f having the
//! force of those that slide. So
//!
//!   s″ = Π M⁻¹(−C s′ − K s) + h,  h = M⁻¹(f_p − M_p q″ − C_p q′ − K_p q + W_pᵀλ + Wᵀλ_p),
//!   D λ_p = Q″_p − W_p q″ − W M⁻¹(f_p − … + W_pᵀλ),
//!
//! with D = W M⁻¹Wᵀ and Π = 1 − M⁻¹Wᵀ D⁻¹ W: Duhamel's integral, by Gauss's rule on panels short against
//! every motion, exact to rounding.

use std::{f64::consts::TAU, sync::Arc};

use super::{
    Change, StopEquations,
    leg::{Between, LOST, LegPassage, LegPiece, followed},
};
use crate::{
    error::{Error, Result},
    many::{
        Grip, LinearEquations, LinearFlow, Periodic, RealMatrix, RealVector, Slope, State,
        algebra::stacked,
        contact::{Contacts, DEPENDENT},
        simulate::{Event, Simulator, Stage, What},
    },
    motion::{RunEnd, Time, flow::GAUSS},
};

/// A row that is this slow, as a part of what its velocity is added up from, may be one that sticks, of which
/// Newton's method has moved the velocity.
const NEAR: f64 = 1e-3;

/// An impact is not felt along a row whose coupling with the stop is less than this part of what it can be.
const APART: f64 = 1e-13;

/// How a row with friction moves, one after the other, and how long.
pub(super) type Parts = Vec<(Grip, f64)>;

/// What happens at the end of a piece.
pub(crate) struct Turn {
    /// The state there, as the piece comes to it.
    pub at: State,
    /// What friction does from then on, or the stop that begins to push.
    met: Met,
    /// How it moves before and after.
    stages: [Arc<Stage>; 2],
}

enum Met {
    Rub(What),
    /// Contact with a soft stop begins, at a speed, with a jump of the force.
    Touch(usize, f64),
    Nothing,
}

/// What a turn adds to displacements: `kick` times what `seen` and `own` of the parameter tell.
struct Salt {
    seen: RealVector,
    own: f64,
    kick: RealVector,
}

impl Turn {
    /// None where displacements stay as they are.
    fn salt(&self, contacts: &Contacts, change: Option<&Change>) -> Result<Option<Salt>> {
        let (at, [before, after], n) = (&self.at, &self.stages, self.at.q.len());
        let now = Time::new(0, at.t);
        let bend = before.acceleration(now, at);
        let turn = &bend - after.acceleration(now, at);
        let zero = RealVector::zeros(n);
        match self.met {
            Met::Nothing => Ok(None),
            Met::Touch(stop, speed) => {
                let seen = stacked(&contacts.all()[stop].row, &zero);
                let own = change.map_or(0.0, |change| change.gap(stop, at)[0]);
                Ok(Some(Salt { seen, own, kick: stacked(&zero, &(turn / speed)) }))
            }
            Met::Rub(what) => {
                let (seen, by_time) = before.slopes(contacts, what, at)?;
                let rate = seen.dot(&stacked(&at.u, &bend)) + by_time;
                // Where it goes on as before, it does not matter when.
                if turn.amax() == 0.0 || rate >= 0.0 || rate.is_nan() {
                    return Ok(None);
                }
                let own = match change {
                    None => 0.0,
                    Some(change) => Rough::new(change, before, contacts)?.of(what, at),
                };
                Ok(Some(Salt { seen, own, kick: stacked(&zero, &(turn / -rate)) }))
            }
        }
    }

    /// q″ before and after.
    pub fn bends(&self) -> [RealVector; 2] {
        self.stages.each_ref().map(|stage| stage.acceleration(Time::new(0, self.at.t), &self.at))
    }

    /// Of its map of displacements.
    pub fn determinant(&self, contacts: &Contacts) -> Result<f64> {
        Ok(self.salt(contacts, None)?.map_or(1.0, |salt| 1.0 + salt.seen.dot(&salt.kick)))
    }
}

/// The pieces of a leg among friction, and its end.
pub(super) fn rough_pieces(
    simulator: &Simulator,
    state: &State,
    duration: f64,
) -> Result<(Vec<LegPiece>, State)> {
    let begin = Time::new(0, state.t);
    let until = begin.after(duration);
    let mut run = simulator.start(begin, state.q.as_slice(), state.u.as_slice())?;
    let (mut pieces, mut now, mut start, mut stage) = (Vec::new(), begin, run.state(), run.stage());
    start.t = state.t;
    loop {
        let event = run.next(until);
        let (time, next, what) = (run.time(), run.stage(), run.rubbed());
        let duration = time.since(now).max(0.0);
        let met = match (&event, what) {
            (Event::Touch(touch), _) if touch.jump > 0.0 => Met::Touch(touch.place, -touch.velocity),
            (_, Some(what)) => Met::Rub(what),
            _ => Met::Nothing,
        };
        let at = State { t: time.phase, ..stage.after(now, &start, duration) };
        let turn = Some(Turn { at, met, stages: [stage.clone(), next.clone()] });
        let (flow, pushing) = (stage.flow.clone(), stage.holds.soft.pushing.clone());
        pieces.push(LegPiece { flow, pushing, start, duration, stage: Some(stage), touch: None, turn });
        let here = State { t: time.phase, ..run.state() };
        if let Event::End(end) = event {
            followed(run.failure(), end)?;
            return Ok((pieces, here));
        }
        (now, start, stage) = (time, here, next);
    }
}

/// (q′, q″) of a state, as it slides and sticks from there on.
pub(super) fn rough_field(simulator: &Simulator, state: &State) -> RealVector {
    let run = simulator.start(Time::new(0, state.t), state.q.as_slice(), state.u.as_slice());
    let bend = run.map(|run| run.stage().acceleration(Time::new(0, state.t), state));
    stacked(&state.u, &bend.unwrap_or_else(|_| state.u.map(|_| f64::NAN)))
}

impl Between<'_> {
    pub(super) fn rough_passage(
        &self,
        state: &State,
        duration: f64,
        change: Option<&Change>,
    ) -> Result<LegPassage> {
        let n = state.q.len();
        let (pieces, end) = self.pieces(state, duration)?;
        let (mut phi, mut slope) = (RealMatrix::identity(2 * n, 2 * n), RealVector::zeros(2 * n));
        for piece in &pieces {
            phi = piece.transition(self.contacts)? * phi;
            if let (Some(change), Some(stage)) = (change, &piece.stage) {
                slope = Rough::new(change, stage, self.contacts)?.leg(&piece.start, piece.duration, slope)?;
            }
            let Some(turn) = &piece.turn else { continue };
            let Some(Salt { seen, own, kick }) = turn.salt(self.contacts, change)? else { continue };
            let told = seen.dot(&slope) + own;
            slope.axpy(told, &kick, 1.0);
            let row = seen.transpose() * &phi;
            phi += kick * row;
        }
        let field = |piece: Option<&LegPiece>, at: &State| {
            let stage = piece.and_then(|piece| piece.stage.as_ref()).ok_or_else(|| Error::input(LOST))?;
            Ok::<_, Error>(stacked(&at.u, &stage.acceleration(Time::new(0, at.t), at)))
        };
        let first = pieces.first();
        let begin = field(first, first.map_or(state, |piece| &piece.start))?;
        let fields = Some([begin, field(pieces.last(), &end)?]);
        Ok(LegPassage { end, phi, slope, fields })
    }
}

impl LegPiece {
    /// ∂(q, q′) at its end by (q, q′) before, of which only what is allowed where it sticks is left: an
    /// impulse there takes the rest away.
    pub(super) fn held_transition(&self, stage: &Stage, contacts: &Contacts) -> Result<RealMatrix> {
        let n = self.start.q.len();
        let zero = RealVector::zeros(n);
        let rows: Vec<usize> = stage.holds.stuck().map(|j| contacts.rub_row(j)).collect();
        let inverse = contacts.among(&rows).try_inverse().ok_or_else(|| Error::input(DEPENDENT))?;
        let allowed = |u: RealVector| {
            let rates = rows.iter().map(|&row| contacts.held_row(row).0.dot(&u));
            let off = -&inverse * RealVector::from_iterator(rows.len(), rates);
            u + contacts.change(&rows, off.as_slice())
        };
        let duration = if stage.smooth.is_some() { 0.0 } else { self.duration };
        let mut all = RealMatrix::zeros(2 * n, 2 * n);
        for j in 0..2 * n {
            let unit = RealVector::from_fn(n, |i, _| f64::from(u8::from(i == j % n)));
            let (q, u) = if j < n {
                stage.carried(&unit, &zero, duration)
            } else {
                stage.carried(&zero, &allowed(unit), duration)
            };
            all.set_column(j, &stacked(&q, &u));
        }
        if let Some(smooth) = &stage.smooth {
            all = smooth.transition(&self.start, self.duration) * all;
        }
        if all.iter().all(|x| x.is_finite()) { Ok(all) } else { Err(Error::input(LOST)) }
    }
}

/// How the motion of a stage changes with a parameter.
struct Rough<'c> {
    slope: Slope,
    stage: &'c Stage,
    contacts: &'c Contacts,
    /// What sticks.
    stuck: Vec<usize>,
    /// D⁻¹.
    inverse: RealMatrix,
}

impl<'c> Rough<'c> {
    fn new(change: &Change, stage: &'c Stage, contacts: &'c Contacts) -> Result<Rough<'c>> {
        if stage.smooth.is_some() {
            return Err(Error::input(
                "how motions change with a parameter is not followed where there is dry friction and a force is a formula",
            ));
        }
        let signs = stage.holds.grips.iter().map(|grip| grip.sign());
        let slope = change.slope.pushed(contacts, &stage.holds.soft.pushing).dragged(contacts, signs);
        let stuck: Vec<usize> = stage.holds.stuck().collect();
        let rows: Vec<usize> = stuck.iter().map(|&j| contacts.rub_row(j)).collect();
        let inverse = contacts.among(&rows).try_inverse().ok_or_else(|| Error::input(DEPENDENT))?;
        Ok(Rough { slope, stage, contacts, stuck, inverse })
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

    /// h and λ_p.
    fn bent(&self, at: &State) -> (RealVector, RealVector) {
        let Rough { slope, stage, contacts, inverse, .. } = self;
        let (equations, rubs) = (&stage.equations, contacts.rubs());
        let bend = stage.acceleration(Time::new(0, at.t), at);
        let mut force =
            slope.force.at(at.t) - &slope.mass * &bend - &slope.damping * &at.u - &slope.stiffness * &at.q;
        if self.stuck.is_empty() {
            return (equations.accelerate(&force), RealVector::zeros(0));
        }
        let free = equations.acceleration(at.t, &at.q, &at.u);
        let load = inverse * self.held(|j| rubs[j].surface(at.t)[1] - rubs[j].row.dot(&free));
        for (&j, load) in self.stuck.iter().zip(load.iter()) {
            force.axpy(*load, &slope.rubs[j].row, 1.0);
        }
        let felt = equations.accelerate(&force);
        let by = inverse
            * self.held(|j| {
                let own = &slope.rubs[j];
                own.velocity.at(at.t)[1] - own.row.dot(&bend) - rubs[j].row.dot(&felt)
            });
        (felt + self.pushed(&by), by)
    }

    /// The derivative by the parameter of what is watched of friction, as [`Stage::slopes`] has it.
    fn of(&self, what: What, at: &State) -> f64 {
        match what {
            What::Slide(j) => {
                let own = &self.slope.rubs[j];
                self.stage.holds.grips[j].sign() * (own.row.dot(&at.u) - own.velocity.at(at.t)[0])
            }
            What::Hold(j, side) => {
                let place = self.stuck.iter().position(|&known| known == j);
                let load = place.map_or(0.0, |place| self.bent(at).1[place]);
                let mobility = self.contacts.mobility(self.contacts.rub_row(j));
                mobility * (self.slope.rubs[j].holding - side.sign() * load)
            }
            _ => 0.0,
        }
    }

    /// The slope after a duration from a state, of that before. Cost: O(n²) for each of 8 points per radian
    /// of the fastest motion.
    fn leg(&self, from: &State, duration: f64, mut slope: RealVector) -> Result<RealVector> {
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
                let (bent, _) = self.bent(&at);
                slope.rows_mut(n, n).axpy(width * weight, &bent, 1.0);
            }
            slope = &steps[GAUSS.len()] * slope;
        }
        Ok(slope)
    }
}

impl StopEquations<'_> {
    /// X, the times and the speeds of unknowns. What sticks where an orbit begins has the surface's velocity;
    /// Newton's method may have moved that, and the machine would slide. So of rows that are slow, what would
    /// slide is begun with the surface's velocity, if it sticks then and where it comes back; and the
    /// equations, which ask for the velocity there to be that of X, bring it to 0.
    pub fn begun(&self, z: &[f64]) -> Result<(State, Vec<f64>, Vec<f64>)> {
        let (state, times, speeds) = self.split(z);
        let Some(simulator) = self.between.rough() else { return Ok((state, times, speeds)) };
        let rates = simulator.rub_rates(&state);
        // The machine as a whole may be at rest.
        let moved = |j: usize| {
            let whole: f64 = simulator.contacts().rubs()[j].row.iter().map(|w| w.abs() * self.scale).sum();
            whole.max(rates[j][1])
        };
        let slow: Vec<usize> = (0..rates.len()).filter(|&j| rates[j][0].abs() <= NEAR * moved(j)).collect();
        let still = simulator.sliding(&state);
        if slow.iter().all(|&j| still[j] == 0.0) {
            return Ok((state, times, speeds));
        }
        let contacts = simulator.contacts();
        let rows: Vec<usize> = slow.iter().map(|&j| contacts.rub_row(j)).collect();
        let Some(inverse) = contacts.among(&rows).try_inverse() else { return Ok((state, times, speeds)) };
        let off = RealVector::from_iterator(slow.len(), slow.iter().map(|&j| -rates[j][0]));
        let mut held = state.clone();
        held.u += contacts.change(&rows, (inverse * off).as_slice());
        if self.comes_back(simulator, &held, &slow) {
            Ok((held, times, speeds))
        } else {
            Ok((state, times, speeds))
        }
    }

    /// Whether these rows stick at a state and, an orbit gone round, where it comes back.
    fn comes_back(&self, simulator: &Simulator, held: &State, rubs: &[usize]) -> bool {
        let begin = Time::new(0, held.t);
        let Ok(mut run) = simulator.start(begin, held.q.as_slice(), held.u.as_slice()) else { return false };
        let sticks = |grips: &[Grip]| rubs.iter().all(|&j| grips[j] == Grip::Stuck);
        if !sticks(&run.grips()) {
            return false;
        }
        match self.pattern.strikes().first() {
            None => {
                let until = begin.after(TAU * f64::from(self.pattern.periods()));
                run.finish(until) == RunEnd::Reached && sticks(&run.grips())
            }
            // It stuck before the impact, too, if that is not felt there.
            Some(strike) => {
                let contacts = simulator.contacts();
                let felt = |&j: &usize| {
                    let row = contacts.rub_row(j);
                    let most = (contacts.mobility(row) * contacts.mobility(strike.place)).sqrt();
                    contacts.coupled(row, strike.place).abs() > APART * most
                };
                !rubs.iter().any(felt)
            }
        }
    }

    /// Where a row sticks all the time, its place comes back whatever it is: in the equation that says so,
    /// the place is asked for.
    pub(super) fn pin(&self, first: &State, (residual, jacobian): (&mut [f64], &mut [Vec<f64>])) {
        let n = self.size();
        let begin = residual.len() - 2 * n;
        for &(j, place) in self.pins {
            let (row, number) = (&self.contacts.rubs()[j].row, self.contacts.rub_row(j));
            let push = self.contacts.push(number) / self.contacts.mobility(number);
            let off = (row.dot(&first.q) - place) / self.scale;
            for k in 0..n {
                residual[begin + k] += push[k] * off;
                (0..n).for_each(|i| jacobian[begin + k][i] += push[k] * row[i]);
            }
        }
    }

    /// How each row with friction moves where the orbit begins.
    pub fn begins(&self, z: &[f64]) -> Result<Vec<Grip>> {
        let Some(simulator) = self.between.rough() else { return Ok(Vec::new()) };
        let (state, ..) = self.begun(z)?;
        let run = simulator.start(Time::new(0, state.t), state.q.as_slice(), state.u.as_slice())?;
        Ok(run.grips())
    }

    /// How each row with friction moves on the orbit, one after the other, and how long.
    pub fn parts(&self, z: &[f64]) -> Result<Vec<Parts>> {
        if self.between.rough().is_none() {
            return Ok(Vec::new());
        }
        let (mut state, times, speeds) = self.begun(z)?;
        let (m, mut all) = (times.len(), Vec::<Parts>::new());
        for leg in 0..m.max(1) {
            let duration = match m {
                0 => TAU * f64::from(self.pattern.periods()),
                _ => self.duration(&times, leg)?,
            };
            let (pieces, end) = self.between.pieces(&state, duration)?;
            for piece in &pieces {
                let Some(stage) = &piece.stage else { continue };
                all.resize(stage.holds.grips.len(), Vec::new());
                for (row, grip) in all.iter_mut().zip(stage.grips()) {
                    row.push((grip, piece.duration));
                }
            }
            if m > 0 {
                let next = (leg + 1) % m;
                state = State { t: super::turned(times[next]), ..end };
                state.u.axpy(speeds[next], &self.kick(next, speeds[next]), 1.0);
            }
        }
        Ok(all)
    }
}

/// What is this short, in radians, may be rounding's: where a row lets go with F_s = F_k its velocity begins
/// with the square of the time, and is caught again while it is within the minimum depth.
const BRIEF: f64 = 1e-4;

/// Slid in less than this, in radians, is rounding's.
const MOMENT: f64 = 1e-3;

/// What is as short as times are rounded takes no time: it may be decided twice at one instant.
const INSTANT: f64 = 1e-13;

/// The rows that stick all the time, or all but so short a time that Newton's method cannot tell: at the ends
/// of the stretch of places at which they can, what is slid is the fourth power of that time.
pub(super) fn held(parts: &[Parts]) -> Vec<usize> {
    let slides = |row: &Parts| -> f64 {
        row.iter().filter(|part| part.0 != Grip::Stuck).map(|part| part.1).sum::<f64>()
    };
    (0..parts.len()).filter(|&j| slides(&parts[j]) < MOMENT).collect()
}

/// The order of parts, with how long each takes, on a circle: parts that are the same are one, and where one
/// changes to another back and forth at one instant, it changes once.
pub(super) fn told(mut parts: Parts) -> Vec<Grip> {
    if parts.iter().any(|part| part.1 > INSTANT) {
        parts.retain(|part| part.1 > INSTANT);
    }
    loop {
        let n = parts.len();
        let next = |i: usize| (i + 1) % n;
        if let Some(i) = (0..n).find(|&i| n > 1 && parts[i].0 == parts[next(i)].0) {
            let (gone, j) = (parts[i].1, next(i));
            parts[j].1 += gone;
            parts.remove(i);
            continue;
        }
        let brief = |i: usize| parts[i % n].1 < BRIEF;
        let same = |i: usize, j: usize| parts[i % n].0 == parts[j % n].0;
        let twice = |i: usize| brief(i + 1) && brief(i + 2) && same(i, i + 2) && same(i + 1, i + 3);
        let Some(i) = (0..n).find(|&i| n > 3 && twice(i)) else {
            return parts.into_iter().map(|part| part.0).collect();
        };
        let gone = [(i + 1) % n, (i + 2) % n];
        let mut at = 0;
        parts.retain(|_| {
            at += 1;
            !gone.contains(&(at - 1))
        });
    }
}
