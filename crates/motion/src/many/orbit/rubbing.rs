//! Legs among dry friction: what slides, sticks and turns round on the way, with derivatives.
//!
//! Friction is passed through as contact with soft stops is: pieces of a leg end where it changes, too, and
//! no unknown belongs to that. Where g(t, q, q′, p) has fallen to 0 on the stage so far, a motion beside this
//! one comes there δt = −δg/g′ later, and δq′ becomes δq′ + (q″⁻ − q″⁺) δt; of what sticks from then on v
//! does not change but with the surface. That holds for displacements and for the slope s by a parameter p,
//! of which g has a derivative of its own (`rough`).

use std::sync::Arc;

use super::{
    Change,
    leg::{Between, LOST, LegPassage, LegPiece, followed},
    rough::Rough,
};
use crate::{
    error::{Error, Result},
    many::{
        RealMatrix, RealVector, State,
        algebra::stacked,
        contact::{Contacts, DEPENDENT},
        simulate::{Event, Simulator, Stage, What},
    },
    motion::Time,
};

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
                // Where it goes on as before, it does not matter when. A switch may have turned unseen since.
                let falls = rate < 0.0 || matches!(what, What::Kink(_)) && rate > 0.0;
                if turn.amax() == 0.0 || !falls {
                    return Ok(None);
                }
                let own = match change {
                    None => 0.0,
                    Some(change) => Rough::new(change, before, contacts)?.of(what, at)?,
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
        let rows: Vec<usize> = stage.holds.held(contacts).iter().map(|&j| contacts.rub_row(j)).collect();
        let inverse = contacts.among(&rows).try_inverse().ok_or_else(|| Error::input(DEPENDENT))?;
        let allowed = |u: RealVector| {
            let rates = rows.iter().map(|&row| contacts.held_row(row).0.dot(&u));
            let off = -&inverse * RealVector::from_iterator(rows.len(), rates);
            u + contacts.change(&rows, off.as_slice())
        };
        let duration = if stage.smooth.is_some() { 0.0 } else { self.duration };
        let unit = |i: usize| RealVector::from_fn(n, |j, _| f64::from(u8::from(i == j)));
        let places = (0..n).map(|i| (unit(i), zero.clone()));
        let units: Vec<_> = places.chain((0..n).map(|i| (zero.clone(), allowed(unit(i))))).collect();
        let columns = stage.carried(&units, duration);
        let mut all = RealMatrix::from_fn(2 * n, 2 * n, |i, j| {
            let (q, u) = &columns[j];
            if i < n { q[i] } else { u[i - n] }
        });
        if let Some(smooth) = &stage.smooth {
            all = smooth.transition(&self.start, self.duration) * all;
        }
        if all.iter().all(|x| x.is_finite()) { Ok(all) } else { Err(Error::input(LOST)) }
    }
}
