//! Motion from one impact on a rigid stop to the next, through contact with soft ones.
//!
//! Between impacts a machine without soft stops is one linear system. With some, a leg is made of pieces,
//! each of them linear: the simulator follows it with all rigid stops passed through, so that the equations
//! of an orbit are smooth beyond them. Contact with a soft stop begins and ends without an unknown of its
//! own. Where it ends, the motion's field is continuous, and nothing is to be done; where it begins the force
//! jumps by cV, and a displacement δ becomes δq′ − c M⁻¹wᵀ δz, δz being by how much the gap is larger there.
//! So a branch passes through a grazing of a soft stop. Where forces are formulas, pieces are not linear, and
//! their derivatives are those of the flow along the motion. Where there is friction, or forces have kinks,
//! it is in `rubbing`.

use std::sync::Arc;

use super::{
    Change,
    rubbing::{Turn, rough_field, rough_pieces},
};
use crate::{
    error::{Error, Result},
    many::{
        LinearEquations, LinearFlow, RealMatrix, RealVector, State,
        algebra::stacked,
        contact::Contacts,
        drift::Drifts,
        simulate::{Event, Simulator, Stage},
    },
    motion::{RunEnd, Time, event::Touch},
};

/// What carries a machine between impacts.
#[derive(Clone, Copy)]
pub(crate) struct Between<'s> {
    pub flow: &'s LinearFlow,
    pub contacts: &'s Contacts,
    /// The machine with its rigid stops passed through, if it has soft ones or friction, or its forces are
    /// formulas.
    pub soft: Option<&'s Simulator>,
    /// The directions in which nothing holds it.
    pub drifts: Option<&'s Drifts>,
}

/// Motion without events.
pub(crate) struct LegPiece {
    pub flow: LinearFlow,
    /// The soft stops that push.
    pub pushing: Vec<usize>,
    pub start: State,
    pub duration: f64,
    /// Where forces are formulas or there is friction, how it moves.
    pub stage: Option<Arc<Stage>>,
    /// Contact that begins at its end, with the state there.
    pub touch: Option<(Touch<usize>, State)>,
    /// What changes at its end, where there is friction.
    pub turn: Option<Turn>,
}

/// A leg's end, what of a displacement before is left there, and how the end changes with a parameter.
pub(crate) struct LegPassage {
    pub end: State,
    pub phi: RealMatrix,
    pub slope: RealVector,
    /// Where there is friction (q′, q″) at its begin and end, as it slides and sticks on the leg.
    pub fields: Option<[RealVector; 2]>,
}

impl<'s> Between<'s> {
    /// The machine with its rigid stops passed through, where there is friction.
    pub fn rough(&self) -> Option<&'s Simulator> {
        self.soft.filter(|simulator| simulator.is_rough())
    }

    /// The state with nothing along the drifts.
    pub fn unmoved(&self, state: State) -> State {
        let part = self.drifts.map(|drifts| drifts.part(&state.q));
        State { q: part.map_or(state.q.clone(), |part| state.q - part), ..state }
    }

    /// The state after a leg.
    pub fn after(&self, state: &State, duration: f64) -> Result<State> {
        let Some(simulator) = self.soft.filter(|_| duration > 0.0) else {
            return Ok(self.flow.after(state, duration));
        };
        let begin = Time::new(0, state.t);
        let mut run = simulator.start(begin, state.q.as_slice(), state.u.as_slice())?;
        let end = run.finish(begin.after(duration));
        followed(run.failure(), end)?;
        Ok(State { t: run.time().phase, ..run.state() })
    }

    /// (q′, q″) of a state.
    pub fn field(&self, state: &State) -> RealVector {
        if let Some(simulator) = self.rough() {
            return rough_field(simulator, state);
        }
        if let Some(simulator) = self.soft.filter(|simulator| simulator.is_smooth()) {
            let bend = simulator.acceleration(state);
            return stacked(&state.u, &bend.unwrap_or_else(|_| state.u.map(|_| f64::NAN)));
        }
        let equations = self.flow.equations();
        let bend = |equations: &LinearEquations| equations.acceleration(state.t, &state.q, &state.u);
        let bend = match self.soft {
            None => bend(equations),
            Some(_) => bend(&self.pushed(state)),
        };
        stacked(&state.u, &bend)
    }

    /// The equations of motion at a state.
    fn pushed(&self, state: &State) -> LinearEquations {
        let pushes = |contact: &&super::StopContact| {
            let gap = contact.gap(state);
            contact.soft.is_some_and(|soft| gap[0] < 0.0 && soft.force(gap) > 0.0)
        };
        self.flow.equations().pushed(self.contacts.all().iter().filter(pushes))
    }

    /// The pieces of a leg; one without soft stops.
    pub fn pieces(&self, state: &State, duration: f64) -> Result<(Vec<LegPiece>, State)> {
        let Some(simulator) = self.soft else {
            let (flow, start) = (self.flow.clone(), state.clone());
            let (stage, touch, turn) = (None, None, None);
            let whole = LegPiece { flow, pushing: Vec::new(), start, duration, stage, touch, turn };
            return Ok((vec![whole], self.flow.after(state, duration)));
        };
        if simulator.is_rough() {
            return rough_pieces(simulator, state, duration);
        }
        let begin = Time::new(0, state.t);
        let until = begin.after(duration);
        let mut run = simulator.start(begin, state.q.as_slice(), state.u.as_slice())?;
        let (mut pieces, mut now, mut start) = (Vec::new(), begin, state.clone());
        let (mut flow, mut pushing) = (run.flow(), run.pushing().to_vec());
        let mut stage = run.stage();
        loop {
            let event = run.next(until);
            let touch = match &event {
                Event::Touch(touch) => Some(*touch),
                Event::Release(_) | Event::End(_) => None,
                _ => continue,
            };
            let (time, here) = (run.time(), State { t: run.time().phase, ..run.state() });
            let touch = touch.filter(|touch| touch.jump > 0.0).map(|touch| (touch, here.clone()));
            let duration = time.since(now).max(0.0);
            let own = stage.smooth.is_some().then_some(stage);
            pieces.push(LegPiece { flow, pushing, start, duration, stage: own, touch, turn: None });
            if let Event::End(end) = event {
                followed(run.failure(), end)?;
                return Ok((pieces, here));
            }
            (now, start, flow, pushing) = (time, here, run.flow(), run.pushing().to_vec());
            stage = run.stage();
        }
    }

    /// A leg with its derivatives, in a parameter, too, if it is told how the machine changes.
    pub fn passage(&self, state: &State, duration: f64, change: Option<&Change>) -> Result<LegPassage> {
        if self.soft.is_none() {
            return Ok(LegPassage {
                end: self.flow.after(state, duration),
                phi: self.flow.transition(duration),
                slope: change.map_or_else(none, |change| change.leg(self.flow, state, duration)),
                fields: None,
            });
        }
        if self.rough().is_some() {
            return self.rough_passage(state, duration, change);
        }
        let n = state.q.len();
        let (pieces, end) = self.pieces(state, duration)?;
        let (mut phi, mut slope) = (RealMatrix::identity(2 * n, 2 * n), RealVector::zeros(2 * n));
        for piece in &pieces {
            let own = piece.transition(self.contacts)?;
            phi = &own * phi;
            slope = own * slope;
            if let Some(change) = change {
                slope += match &piece.stage {
                    None => {
                        let pushed = change.pushed(&piece.flow, self.contacts, &piece.pushing)?;
                        pushed.leg(&piece.flow, &piece.start, piece.duration)
                    }
                    Some(stage) => change.smooth_leg(stage, self.contacts, &piece.start, piece.duration)?,
                };
            }
            let Some((touch, at)) = &piece.touch else { continue };
            let stop = touch.place;
            let damping = touch.jump / -touch.velocity;
            let kick = stacked(&RealVector::zeros(n), self.contacts.push(stop)) * -damping;
            let row = stacked(&self.contacts.all()[stop].row, &RealVector::zeros(n));
            let wider = row.dot(&slope) + change.map_or(0.0, |change| change.gap(stop, at)[0]);
            slope.axpy(wider, &kick, 1.0);
            let seen = row.transpose() * &phi;
            phi += &kick * seen;
        }
        Ok(LegPassage { end, phi, slope, fields: None })
    }

    /// det of the flow over a leg, by Liouville: beginnings of contact have determinant 1.
    pub fn determinant(&self, state: &State, duration: f64) -> Result<f64> {
        if self.soft.is_none() {
            return Ok(self.flow.equations().determinant(duration));
        }
        let (pieces, _) = self.pieces(state, duration)?;
        pieces.iter().map(|piece| piece.determinant(self.contacts)).product()
    }
}

impl LegPiece {
    /// ∂(q, q′) at its end by (q, q′) before.
    pub fn transition(&self, contacts: &Contacts) -> Result<RealMatrix> {
        if let Some(held) = self.stage.as_ref().filter(|stage| stage.holds.stuck().next().is_some()) {
            return self.held_transition(held, contacts);
        }
        let smooth = self.stage.as_ref().and_then(|stage| stage.smooth.as_ref());
        let phi = match smooth {
            None => return Ok(self.flow.transition(self.duration)),
            Some(smooth) => smooth.transition(&self.start, self.duration),
        };
        if phi.iter().all(|x| x.is_finite()) { Ok(phi) } else { Err(Error::input(LOST)) }
    }

    /// The determinant of [`transition`](Self::transition).
    fn determinant(&self, contacts: &Contacts) -> Result<f64> {
        if self.stage.as_ref().is_some_and(|stage| stage.holds.stuck().next().is_some()) {
            return Ok(0.0);
        }
        let smooth = self.stage.as_ref().and_then(|stage| stage.smooth.as_ref());
        let found = match smooth {
            None => self.flow.equations().determinant(self.duration),
            Some(smooth) => smooth.determinant(&self.start, self.duration),
        };
        let turned = self.turn.as_ref().map_or(Ok(1.0), |turn| turn.determinant(contacts))?;
        let found = found * turned;
        found.is_finite().then_some(found).ok_or_else(|| Error::input(LOST))
    }
}

pub(super) const LOST: &str = "the motion's derivative could not be followed";

fn none() -> RealVector {
    RealVector::zeros(0)
}

pub(super) fn followed(failure: Option<Error>, end: RunEnd) -> Result<()> {
    match (failure, end) {
        (Some(error), _) => Err(error),
        (None, RunEnd::Reached) => Ok(()),
        (None, RunEnd::TooSteep) => {
            Err(Error::limit(format!("the motion ended on the way, {}", RunEnd::TooSteep.why())))
        }
        (None, end) => Err(Error::input(format!("the motion ended on the way, {}", end.why()))),
    }
}
