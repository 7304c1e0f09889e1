//! The minimum depth that suits motions of a machine, where its scene gives none.

use super::{Settings, Simulator, looks};
use crate::{
    error::Result,
    many::{Machine, State, contact::StopContact},
    motion::minimum::RELATIVE_DEPTH,
};

impl Simulator {
    /// A simulator of a machine. The minimum depth is the one that is given, or
    /// [`depth_for`](Self::depth_for) these starts.
    ///
    /// # Errors
    /// Those of [`Simulator::new`].
    pub fn suited(machine: &Machine<f64>, given: Option<f64>, starts: &[State]) -> Result<Simulator> {
        let settings = |minimum_depth| Settings { minimum_depth, ..Settings::default() };
        let simulator = Simulator::new(machine, &settings(given.unwrap_or(RELATIVE_DEPTH)))?;
        if given.is_some() {
            return Ok(simulator);
        }
        let depth = simulator.depth_for(starts);
        Ok(simulator.with(settings(depth)))
    }

    /// 10⁻¹² of the size of the gap to the nearest stop, or of what starts show at the stops.
    pub fn depth_for(&self, starts: &[State]) -> f64 {
        let gap = |state: &State| {
            let one =
                |contact: &StopContact| contact.row.dot(&state.q).abs().max(contact.gap(state)[1].abs());
            self.contacts.all().iter().map(one).fold(0.0, f64::max)
        };
        let scale = match self.contacts.all() {
            [] if self.contacts.rubs().is_empty() && !self.switches().is_empty() => {
                let seen = starts.iter().map(|state| state.q.amax().max(state.u.amax())).fold(0.0, f64::max);
                if seen > 0.0 { seen } else { self.moved() }
            }
            [] => self.rub_scale(starts),
            _ => starts.iter().map(gap).fold(self.gap_scale(), f64::max),
        };
        RELATIVE_DEPTH * if scale > 0.0 && scale.is_finite() { scale } else { 1.0 }
    }

    /// With what each switch of the forces changes by, seen over the size of the machine's motions.
    pub(super) fn with_steepness(self) -> Simulator {
        let smooth = self.smooth.as_ref().filter(|smooth| !smooth.switches().is_empty());
        let Some(smooth) = smooth else { return self };
        let steepness = smooth.steepness(self.depth_for(&[]) / RELATIVE_DEPTH).into();
        Simulator { steepness, ..self }
    }

    /// How far the forces alone, without formulas, move a coordinate.
    fn moved(&self) -> f64 {
        let (flow, n) = (&self.free.flow, self.equations.size());
        looks().map(|t| flow.outward(&flow.particular(t)).rows(0, n).amax()).fold(0.0, f64::max)
    }

    /// What counts as contact without impact.
    pub fn minimum_depth(&self) -> f64 {
        self.settings.minimum_depth
    }

    /// The same machine with another minimum depth. No table is made anew: both share them.
    #[must_use]
    pub fn sharing(&self, minimum_depth: f64) -> Simulator {
        Simulator {
            equations: self.equations.clone(),
            contacts: self.contacts.clone(),
            smooth: self.smooth.clone(),
            free: self.free.clone(),
            stages: self.stages.clone(),
            drags: self.drags.clone(),
            steepness: self.steepness.clone(),
            settings: Settings { minimum_depth, ..self.settings.clone() },
            rate: self.rate,
            drifts: self.drifts.clone(),
            through: self.through,
            tally: self.tally.clone(),
        }
    }

    /// Whether a state lies behind a rigid stop, where no motion begins.
    pub fn is_behind(&self, state: &State) -> bool {
        self.stop_before(state).is_some()
    }

    /// The first rigid stop behind which a state lies, with its gap.
    pub(super) fn stop_before(&self, state: &State) -> Option<(&StopContact, f64)> {
        let rigid = self.contacts.all().iter().filter(|contact| contact.soft.is_none() && !self.through);
        let mut gaps = rigid.map(|contact| (contact, contact.gap(state)[0]));
        gaps.find(|(_, gap)| *gap < -self.settings.minimum_depth)
    }
}
