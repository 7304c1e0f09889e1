//! On which side of its kinks a machine's forces are.
//!
//! Between two zeros of its switches a machine with kinks is one with smooth forces. Where a switch comes to
//! 0 the motion goes on in the mode of the other side, if it leads there; a switch that is 0 and did not come
//! there, as at a start, is decided by the first derivative along the motion that has a sign. Where the force
//! jumps and pushes back from both sides the motion would slide along the jump, as Filippov's solutions do:
//! nothing is smoothed, and the run ends with an error.

use super::{
    Event, Simulator,
    engine::Run,
    holds::{Holds, What},
    stage::Stage,
};
use crate::{
    error::{Error, Result},
    many::{
        State,
        smooth::{Smooth, Switch, SwitchOf},
    },
    motion::{
        Time,
        event::{Kink, Release, Touch},
        minimum::norm,
    },
    rounding::SUM,
};

/// Within this of their size derivatives of a switch have none, and accelerations on both sides are the same.
const LEAD: f64 = 1e-9;

/// More zeros of switches than this in a period are chatter.
const MOST_KINKS: u32 = 100_000;

impl Simulator {
    /// Where forces have kinks.
    pub fn switches(&self) -> &[Switch] {
        self.smooth.as_ref().map_or(&[], Smooth::switches)
    }

    /// The switches of forces that are formulas, without those of stops, as events number them.
    pub fn kinks(&self) -> impl Iterator<Item = usize> {
        let all = self.switches().iter().enumerate();
        all.filter(|(_, switch)| switch.of == SwitchOf::Kink).map(|(k, _)| k)
    }

    /// What is held, with the sign of every switch at a state. The signs that `holds` says are kept where
    /// the state does not tell otherwise, those that `known` watched without being looked at again.
    ///
    /// # Errors
    /// Where the force jumps and pushes back from both sides; a stage that cannot be built.
    pub(super) fn decided(
        &self,
        mut holds: Holds,
        known: Option<&Stage>,
        time: Time,
        state: &State,
    ) -> Result<Holds> {
        let Some(smooth) = self.smooth.as_ref().filter(|smooth| !smooth.switches().is_empty()) else {
            return Ok(holds);
        };
        let mut open = Vec::new();
        for (k, [value, size]) in smooth.switched(state).into_iter().enumerate() {
            if matches!(smooth.switches()[k].of, SwitchOf::Slide(_)) {
                continue;
            }
            if value.abs() <= (SUM * size).max(self.depth(&What::Kink(k))) {
                open.push(k);
            } else if (value < 0.0) != holds.below.contains(&k) {
                holds = holds.turned(k);
            }
        }
        let sure = |k: usize, holds: &Holds| {
            known.is_some_and(|stage| {
                let same = stage.holds.below.contains(&k) == holds.below.contains(&k);
                same && stage.watched.contains(&What::Kink(k))
            })
        };
        let mut turned = Vec::new();
        loop {
            let stage = self.stage(&holds)?;
            let falls = |&&k: &&usize| !sure(k, &holds) && lead(&stage, k, time, state) < 0.0;
            let Some(&k) = open.iter().find(falls) else { return Ok(holds) };
            let other = self.stage(&holds.turned(k))?;
            if turned.contains(&k) || lead(&other, k, time, state) < 0.0 {
                // It falls on both sides.
                let [one, two] = [&stage, &other].map(|stage| stage.acceleration(time, state));
                if (&one - &two).amax() > LEAD * (one.amax() + two.amax()) {
                    return Err(self.slides(k, time));
                }
                open.retain(|known| *known != k);
                continue;
            }
            turned.push(k);
            holds = holds.turned(k);
        }
    }

    fn slides(&self, switch: usize, time: Time) -> Error {
        let (text, at) = (&self.switches()[switch].text, time.periods());
        Error::input(format!(
            "after {at:.9} periods the force jumps at {text} and pushes back to it from both sides: the motion \
             slides along the jump, which a formula does not say; write dry friction as [[friction]]"
        ))
    }
}

/// The first derivative of a switch, with the sign that it has in a stage, that is not 0 along the motion.
fn lead(stage: &Stage, switch: usize, time: Time, state: &State) -> f64 {
    let place = stage.watched.iter().position(|what| *what == What::Kink(switch));
    let (Some(smooth), Some(watch)) = (&stage.smooth, place) else { return 0.0 };
    let state = State { t: time.phase, ..state.clone() };
    let (polynomial, _) = smooth.polynomial(&smooth.leap(time, &state), watch);
    let size = norm(&polynomial[1..]);
    polynomial[1..8].iter().copied().find(|c| c.abs() > LEAD * size).unwrap_or(0.0)
}

impl Run<'_> {
    /// Whether the switch of a kink, as [`Simulator::kinks`] numbers them, is negative from here on.
    pub fn is_below(&self, kink: usize) -> bool {
        self.simulator().kinks().nth(kink).is_some_and(|k| self.stage().holds.below.contains(&k))
    }

    /// A switch has come to 0 at x.
    pub(super) fn kinked(&mut self, time: Time, x: f64, switch: usize) -> Result<()> {
        let (state, before) = (self.state_at(x), self.stage());
        self.kinks =
            if self.kinks.0 == time.period { (time.period, self.kinks.1 + 1) } else { (time.period, 1) };
        if self.kinks.1 > MOST_KINKS {
            let (text, at) = (&self.simulator().switches()[switch].text, time.periods());
            return Err(Error::input(format!(
                "after {at:.9} periods {text} has changed sides {MOST_KINKS} times in a period: the motion \
                 chatters there; write dry friction as [[friction]], a stop as [[stops]]"
            )));
        }
        let turned = before.holds.turned(switch);
        let holds = self.simulator().decided(turned, Some(&before), time, &state)?;
        let stage = self.simulator().stage(&holds)?;
        self.tell_kinks(time, &state, &before, &stage);
        self.change(stage, time, &state);
        self.regrip(time, &state, &[])
    }

    /// Tells on which switches the two stages differ.
    pub(super) fn tell_kinks(&mut self, time: Time, state: &State, before: &Stage, after: &Stage) {
        if self.simulator().switches().is_empty() {
            return;
        }
        let contacts = self.simulator().contacts();
        let count = contacts.all().len();
        for stop in (0..count).filter(|&j| contacts.all()[j].force.is_some()) {
            match (before.pushing.contains(&stop), after.pushing.contains(&stop)) {
                (false, true) => {
                    let velocity = contacts.all()[stop].gap(state)[1];
                    self.touch(Touch { time, radius: 1e-15, place: stop, velocity, jump: 0.0 });
                }
                (true, false) => self.push_event(Event::Release(Release { time, place: stop })),
                _ => {}
            }
        }
        for (place, k) in (count + contacts.rubs().len()..).zip(self.simulator().kinks()) {
            let turns = before.holds.below.contains(&k) != after.holds.below.contains(&k);
            if turns && before.watched.contains(&What::Kink(k)) {
                self.push_event(Event::Kink(Kink { time, place }));
            }
        }
    }
}
