//! Simulation of machines: the flow, interrupted by impacts and rests on stops and nothing else, event by
//! event.
//!
//! # What is promised
//!
//! - Every minimum of a gap below −[`minimum_depth`](Settings::minimum_depth) is an impact, found on
//!   the stretch on which the gap falls, however slow; a minimum within the depth of 0 is a
//!   [tangency](Event::Tangency). *Proof.* On a cell of the finest level the gap is a polynomial up to 10⁻¹⁸
//!   of its amplitude (`stage`), on which the minimum test of the one-degree simulation decides (its
//!   `search`: cases by Taylor's formula with a bound on the third derivative). Any other cell, and any
//!   stretch of cells at once, is passed over only where the head of `stage`, a lower bound of the gap on all
//!   of it, exceeds the depth. Where rounding of the sum over the modes exceeds the minimum depth, it takes
//!   its place.
//! - Stops that are touched at one instant, within the minimum depth, are hit together by Newton's law for
//!   all of them (`contact`); `order_matters`
//!   says where that is a choice.
//! - Bounces on a stop that would be lower than the minimum depth, where it presses, are summed as a
//!   geometric series and end in rest ([`Event::Stick`]): motion under the constraint that the gap is 0,
//!   until the force of contact falls to 0 ([`Event::Release`]). The velocity lost is that of the bounces
//!   left out. Other stops are watched meanwhile, and may be rested on, too.
//! - A soft stop pushes from where its gap closes until its force would pull ([`Event::Touch`],
//!   [`Event::Release`]), and again if it would push before the gap is open. In contact the machine is
//!   another linear one. *Proof* of what is found: where contact begins is the minimum of a gap, as above;
//!   where it ends, and may begin again, the force over its unit is
//!   watched as a gap is. There the depth is smaller than the minimum depth by the acceleration of the gap
//!   that the unit causes, if that is above 1: no push or pull is passed over that accelerates the gap by
//!   more than the minimum depth per radian².
//! - Where there is dry friction, the machine slides by one linear motion and sticks by another, in which
//!   the surface holds it. *Proof* of what is found: where it ceases to slide is the minimum of a velocity,
//!   as above; where it ceases to stick, that of what the surface could hold more. There Coulomb's law for
//!   all rows without velocity and all stops rested on at once says how it goes on (`engine::grips`).
//! - Forces with kinks are smooth on each side of them. *Proof* of what is found: the switch of each kink is
//!   watched as a gap is, with the same depth, in its own unit; that of a stop's force as the acceleration of
//!   the gap (`kinks`).
//! - A run ends by a [`RunEnd`](crate::motion::RunEnd) that says why.
//!
//! The trajectory itself carries rounding errors only, amplified by the condition number of the modes. Where
//! forces are formulas it is followed by steps of Taylor series whose last terms are below 10⁻¹⁵ of the
//! motion, and on which the forces are near their series all along; the gap on a step is a polynomial then,
//! too, and what is found on it is found by the same test.
//!
//! ```
//! use grazing_scenes::many::simulate::{Event, Settings, Simulator};
//! use grazing_scenes::many::{Machine, Stop, StopLaw};
//! use grazing_scenes::motion::{Time, Wall};
//!
//! // A mass of 2 that falls onto a table: g = 8, and the table keeps half of the velocity.
//! let table = Wall { offset: 0.0, harmonics: vec![], restitution: 0.5 };
//! let machine = Machine {
//!     size: 1,
//!     period: 4.0,
//!     mass: vec![(0, 0, 2.0)],
//!     damping: vec![],
//!     damping_ratio: vec![],
//!     stiffness: vec![],
//!     shapes: vec![],
//!     force: vec![-16.0],
//!     forcing: vec![],
//!     smooth: vec![],
//!     record: None,
//!     stops: vec![Stop { name: "table".into(), row: vec![1.0], wall: table, law: StopLaw::Newton }],
//!     friction: vec![],
//! };
//! let settings = Settings { minimum_depth: 1e-12, ..Settings::default() };
//! let simulator = Simulator::new(&machine, &settings)?;
//! let mut run = simulator.start(Time::new(0, 0.0), &[1.0], &[0.0])?;
//! let Event::Impact(impact) = run.next(Time::new(1, 0.0)) else { panic!() };
//! // After half a unit of time, an eighth of the period, at velocity −4.
//! assert!((impact.time.periods() - 0.125).abs() < 1e-14);
//! assert!((impact.velocity * machine.rate() + 4.0).abs() < 1e-13);
//! # Ok::<(), grazing_scenes::Error>(())
//! ```

mod depth;
mod engine;
mod holds;
mod kinks;
mod pushes;
mod slid;
mod smooth;
mod stage;
mod tangent;

use std::{
    collections::BTreeMap,
    f64::consts::TAU,
    sync::{Arc, Mutex, PoisonError},
};

use serde::Serialize;

pub use engine::Run;
pub(crate) use holds::What;
use holds::{Holds, SoftStops};
pub use pushes::{Contact, Pushes};
pub use slid::{Slid, goes_on};
pub(crate) use smooth::{SmoothStage, seen};
pub(crate) use stage::Stage;
pub use tangent::Carried;

use super::{
    LinearEquations, Machine, RealVector, Rub, State,
    contact::{Contacts, StopContact},
    smooth::{Smooth, SwitchOf},
};
use crate::many::{LinearFlow, drift::Drifts};
use crate::{
    error::{Error, Result},
    motion::{EffectTally, Time},
};

/// What happens in a motion of a machine, at a stop by its place in it.
pub type Event = crate::motion::Event<usize>;

/// How finely to simulate.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Settings {
    /// Gaps within this of 0 are contact without impact: see the promises of [`simulate`](self). In the unit
    /// of gaps, above 0. Default 1e-12, which suits motions of size 1; [`Simulator::scale`] tells
    /// their size.
    pub minimum_depth: f64,
    /// After so many impacts a run ends. Default: no limit.
    pub impact_limit: u64,
}

impl Default for Settings {
    fn default() -> Self {
        Settings { minimum_depth: 1e-12, impact_limit: u64::MAX }
    }
}

/// How large the motion of a gap is.
struct GapSize {
    /// What the forces alone bring about.
    forced: f64,
    /// What they bring about of the whole machine, and the stop's own motion: no less.
    moved: f64,
    /// The stop's place and motion.
    place: f64,
}

/// A stop farther away than this, in sizes of the forced motion, says nothing about the size of motions.
const MET: f64 = 10.0;

/// Velocities within this of their size are rounding's.
const STILL: f64 = 1e-13;

/// Phases at which a motion is looked at for its size.
fn looks() -> impl Iterator<Item = f64> {
    (0..64).map(|i| TAU * f64::from(i) / 64.0)
}

/// The machine in contact.
type Stages = BTreeMap<Holds, Arc<Stage>>;

/// A machine ready to run from many starts and on many threads.
#[derive(Debug)]
pub struct Simulator {
    equations: LinearEquations,
    contacts: Contacts,
    smooth: Option<Smooth>,
    /// The machine away from all stops and without friction; others as they come up.
    free: Arc<Stage>,
    stages: Arc<Mutex<Stages>>,
    /// w M⁻¹ C M⁻¹ wᵀ of each stop: by how much an impulse of 1 there changes z″ through damping.
    drags: Vec<f64>,
    /// By how much each switch of the forces changes for a displacement of 1.
    steepness: Arc<[f64]>,
    settings: Settings,
    rate: f64,
    drifts: Option<Arc<Drifts>>,
    /// Whether rigid stops are passed through.
    through: bool,
    tally: Option<Arc<EffectTally>>,
}

impl Simulator {
    /// Solves the machine and fills its tables. Cost: O(n³ + (stops + harmonics) (min(R, 10⁴) + n log R)), R
    /// the fastest motion over the forcing's frequency.
    ///
    /// # Errors
    /// Those of [`Machine::equations`] and [`Machine::contacts`]; a minimum depth that is not positive;
    /// motions some 10¹¹ times as fast as the forcing, or, without modes, some 10⁴ times.
    pub fn new(machine: &Machine<f64>, settings: &Settings) -> Result<Simulator> {
        let depth = settings.minimum_depth;
        if !(depth > 0.0 && depth.is_finite()) {
            return Err(Error::input(format!("minimum_depth = {depth} is not positive")));
        }
        let equations = machine.equations()?;
        let contacts = Contacts::new(&equations, machine.contacts()?, machine.rubs()?);
        let smooth = Smooth::new(machine)?;
        let free = Arc::new(Stage::new(&equations, &contacts, &Holds::default(), false, smooth.as_ref())?);
        let stops = contacts.all().iter().map(|contact| ("stop", &contact.name));
        let rubs = contacts.rubs().iter().map(|rub| ("friction", &rub.name));
        for (row, (what, name)) in stops.chain(rubs).enumerate() {
            if contacts.mobility(row) <= 0.0 || contacts.mobility(row).is_nan() {
                return Err(Error::input(format!("{what} {name}: no motion of the machine reaches it")));
            }
        }
        let drag = |j: usize| {
            let push = contacts.push(j);
            push.dot(&(&equations.damping * push))
        };
        let drags = (0..contacts.all().len()).map(drag).collect();
        let (stages, settings, rate) = (Arc::default(), settings.clone(), machine.rate());
        let drifts = Drifts::of(machine, &equations)?;
        let simulator = Simulator {
            equations,
            contacts,
            smooth,
            free,
            stages,
            drags,
            steepness: Arc::default(),
            settings,
            rate,
            drifts,
            through: false,
            tally: None,
        };
        Ok(simulator.with_steepness())
    }

    /// Within how much of 0 what is watched of a stop has no sign. At a soft stop no force is passed over
    /// that would accelerate the gap by more than the minimum depth per radian²: a depth by itself is a force
    /// that grows with the stiffness, and a stop as stiff as 10¹² would hold on to a mass.
    fn depth(&self, what: &What) -> f64 {
        if let What::Kink(k) = *what {
            let depth = self.settings.minimum_depth;
            return match self.switches()[k].of {
                // What a force changes by must be seen in the motion.
                SwitchOf::Push(stop) => depth / self.contacts.mobility(stop),
                SwitchOf::Depth(_) | SwitchOf::Slide(_) => depth,
                SwitchOf::Kink => depth * self.steepness[k],
            };
        }
        let (What::Gap(stop) | What::Push(stop) | What::Pull(stop) | What::Rise(stop) | What::Force(stop)) =
            *what
        else {
            return self.settings.minimum_depth;
        };
        let soft = self.contacts.all()[stop].soft;
        let felt = soft.map_or(1.0, |soft| soft.unit() * self.contacts.mobility(stop));
        self.settings.minimum_depth / felt.max(1.0)
    }

    /// The same machine simulated otherwise.
    #[must_use]
    pub(crate) fn with(self, settings: Settings) -> Simulator {
        Simulator { settings, ..self }
    }

    /// The machine with its rigid stops passed through; none if then it is one linear machine: it has no soft
    /// stops and no friction, and no force is a formula.
    ///
    /// # Errors
    /// None in practice: those of [`Simulator::new`].
    pub(crate) fn through(&self) -> Result<Option<Simulator>> {
        if !self.is_pieced() {
            return Ok(None);
        }
        let smooth = self.smooth.as_ref();
        let free = Stage::new(&self.equations, &self.contacts, &Holds::default(), true, smooth)?;
        Ok(Some(Simulator {
            equations: self.equations.clone(),
            contacts: self.contacts.clone(),
            smooth: self.smooth.clone(),
            free: Arc::new(free),
            stages: Arc::default(),
            drags: self.drags.clone(),
            steepness: self.steepness.clone(),
            settings: self.settings.clone(),
            rate: self.rate,
            drifts: self.drifts.clone(),
            through: true,
            tally: self.tally.clone(),
        }))
    }

    /// The same machine, its work added up in `tally`: of runs as each ends, of steps by formulas as they
    /// are made, whatever for.
    #[must_use]
    pub fn counting(self, tally: Arc<EffectTally>) -> Simulator {
        if let Some(smooth) = &self.smooth {
            smooth.count_in(&tally);
        }
        Simulator { tally: Some(tally), ..self }
    }

    /// The same where there is a tally.
    #[must_use]
    pub(crate) fn counting_too(self, tally: Option<&Arc<EffectTally>>) -> Simulator {
        match tally {
            Some(tally) => self.counting(tally.clone()),
            None => self,
        }
    }

    /// Whether forces are formulas.
    pub fn is_smooth(&self) -> bool {
        self.smooth.is_some()
    }

    /// Whether motion between impacts is more than that of one linear machine: a state does not follow from
    /// times and speeds of impacts.
    pub fn is_pieced(&self) -> bool {
        let soft = || self.contacts.all().iter().any(|contact| contact.soft.is_some());
        self.is_smooth() || self.is_rough() || soft()
    }

    /// Whether motion between impacts is that of one linear machine with a periodic motion that its forces
    /// bring about: state and speeds at impacts follow from their times.
    pub fn is_held(&self) -> bool {
        !self.is_pieced() && self.flow().particular(0.0).iter().all(|x| x.is_finite())
    }

    /// Whether motion between impacts has corners: there is dry friction, or forces have kinks.
    pub(crate) fn is_rough(&self) -> bool {
        !self.contacts.rubs().is_empty() || !self.switches().is_empty()
    }

    /// (q″) of a state between impacts.
    ///
    /// # Errors
    /// A stage that cannot be built.
    pub fn acceleration(&self, state: &State) -> Result<RealVector> {
        let soft = SoftStops::of(&self.contacts, state);
        let time = Time::new(0, state.t);
        let holds = self.decided(Holds { soft, ..Holds::default() }, None, time, state)?;
        Ok(self.stage(&holds)?.acceleration(time, state))
    }

    /// The acceleration of a stop's gap at a phase where the machine rests on it, moved by a push there from
    /// where all coordinates are 0. Not a number where that has none.
    pub fn on_stop(&self, stop: usize, t: f64) -> f64 {
        let contact = &self.contacts.all()[stop];
        let [place, rate, bend] = contact.position.at(t);
        let push = self.contacts.push(stop) / self.contacts.mobility(stop);
        let state = State { t, q: &push * place, u: &push * rate };
        contact.row.dot(&self.free.acceleration(Time::new(0, t), &state)) - bend
    }

    /// The machine away from all stops.
    pub(crate) fn free(&self) -> Arc<Stage> {
        self.free.clone()
    }

    /// The flow between impacts; where forces are formulas, that of the machine linearised at rest.
    #[doc(hidden)]
    pub fn flow(&self) -> &LinearFlow {
        &self.free.flow
    }

    /// The equations of motion, the forcing's phase being time.
    #[doc(hidden)]
    pub fn equations(&self) -> &LinearEquations {
        &self.equations
    }

    /// The stops.
    #[doc(hidden)]
    pub fn contacts(&self) -> &Contacts {
        &self.contacts
    }

    /// The directions in which nothing holds it, if there are any.
    pub(crate) fn drifts(&self) -> Option<&Drifts> {
        self.drifts.as_deref()
    }

    /// How finely it simulates.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Ω: velocities per radian of the forcing times this are per unit of time.
    pub fn rate(&self) -> f64 {
        self.rate
    }

    /// The size of the motions of the gaps, at the stop that is nearest to the motion that the forces alone
    /// bring about: of that, and of what a constant force does in a radian; and of the stop's place and
    /// motion, unless they are farther than ten times the motion of the machine and of the stop. 0 if there
    /// is none of them: then only starts tell. A stop that is farther away changes nothing.
    ///
    /// How far is far is told by the machine's motion, by the norm that the mass gives: that of the gap alone
    /// may be rounding's, where the forces act on a part of the machine that the stop does not feel.
    pub fn scale(&self) -> f64 {
        self.nearest_stop().map(|stop| self.gap_size(stop)).map_or(0.0, |GapSize { forced, moved, place }| {
            if moved > 0.0 && place > MET * moved { moved } else { forced.max(place) }
        })
    }

    /// The same; of a machine without stops the size of the motions where there is friction, and without that
    /// of what the forces bring about.
    pub fn size(&self) -> f64 {
        let scale = self.scale();
        let scale = if scale > 0.0 { scale } else { self.rub_scale(&[]) };
        if scale > 0.0 { scale } else { self.forced_size() }
    }

    /// The largest coordinate of the periodic motion of the machine linearised at rest; where it has none, of
    /// what its forces do in a radian.
    fn forced_size(&self) -> f64 {
        let (flow, n) = (&self.free.flow, self.equations.size());
        let most = |t: f64| flow.outward(&flow.particular(t)).rows(0, n).amax();
        let forced = looks().map(most).filter(|size| size.is_finite()).fold(0.0, f64::max);
        let zero = RealVector::zeros(n);
        let bend = |t: f64| self.equations.acceleration(t, &zero, &zero).amax();
        if forced > 0.0 { forced } else { looks().map(bend).fold(0.0, f64::max) }
    }

    /// The same where these stops are met: of their places and motions, too. Where forces are formulas the
    /// machine linearised at rest may resonate where they do not: no more than what they do in a radian.
    pub fn scale_at(&self, stops: impl IntoIterator<Item = usize> + Clone) -> f64 {
        let size = |stop: usize| {
            let GapSize { forced, place, .. } = self.gap_size(stop);
            forced.max(place)
        };
        let scale = stops.clone().into_iter().map(size).fold(self.scale(), f64::max);
        if !self.is_smooth() {
            return scale;
        }
        let rest = |t: f64| State { t, q: self.zeros(), u: self.zeros() };
        let bend = |stop: usize| {
            let row = &self.contacts.all()[stop].row;
            let bend = looks().filter_map(|t| Some(row.dot(&self.acceleration(&rest(t)).ok()?).abs()));
            bend.fold(self.gap_size(stop).place, f64::max)
        };
        let own = stops.into_iter().map(bend).fold(0.0, f64::max);
        if own > 0.0 { scale.min(own) } else { scale }
    }

    fn zeros(&self) -> RealVector {
        RealVector::zeros(self.equations.size())
    }

    /// The size of the gap to the stop that is nearest, however far that is: what its rounding is relative
    /// to. 0 as of [`scale`](Self::scale).
    pub fn gap_scale(&self) -> f64 {
        self.nearest_stop().map_or(0.0, |stop| {
            let GapSize { forced, place, .. } = self.gap_size(stop);
            forced.max(place)
        })
    }

    /// The stop that the forced motion comes nearest to, distances being those of displacements in
    /// coordinates in which the mass is 1.
    pub(crate) fn nearest_stop(&self) -> Option<usize> {
        let (flow, zero) = (&self.free.flow, RealVector::zeros(self.equations.size()));
        let distance = |stop: usize| {
            let contact = &self.contacts.all()[stop];
            let g = flow.seen(&contact.row, &zero);
            let gap = |t: f64| g.dot(&flow.particular(t)) - contact.position.at(t)[0];
            let least = looks().map(gap).fold(f64::INFINITY, f64::min);
            least / self.contacts.mobility(stop).sqrt()
        };
        let all = (0..self.contacts.all().len()).map(|stop| (stop, distance(stop)));
        all.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(stop, _)| stop)
    }

    /// The size of the motion along the rows with friction, from these starts; where nothing moves, of what
    /// friction does in a radian.
    pub(crate) fn rub_scale(&self, starts: &[State]) -> f64 {
        let rubs = || self.contacts.rubs().iter().enumerate();
        let moved = |(j, rub): (usize, &Rub)| {
            let GapSize { forced, place, .. } = self.gap_size(self.contacts.rub_row(j));
            let seen = |state: &State| rub.row.dot(&state.q).abs().max(rub.rate(state).abs());
            starts.iter().map(seen).fold(forced.max(place).max(rub.speed.abs()), f64::max)
        };
        let moved = rubs().map(moved).fold(0.0, f64::max);
        let given = |known: &(usize, &Rub)| known.1.stop.is_none();
        let holds = |(j, rub): (usize, &Rub)| rub.holding * self.contacts.mobility(self.contacts.rub_row(j));
        if moved > 0.0 { moved } else { rubs().filter(given).map(holds).fold(0.0, f64::max) }
    }

    fn gap_size(&self, stop: usize) -> GapSize {
        let (row, place) = self.contacts.held_row(stop);
        let (flow, n) = (&self.free.flow, self.equations.size());
        let forced = looks().map(|t| flow.outward(&flow.particular(t)).rows(0, n).into_owned());
        let push = self.equations.accelerate(&self.equations.force.mean);
        // What the record's largest force does in a radian.
        let record = self.smooth.as_ref().and_then(Smooth::record).map(|(record, direction)| {
            let most = record.values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            self.equations.accelerate(direction) * most
        });
        let all: Vec<RealVector> = forced.chain([push]).chain(record).collect();
        let largest = |size: &dyn Fn(&RealVector) -> f64| all.iter().map(size).fold(0.0, f64::max);
        let mobility = self.contacts.mobility(stop);
        // |w q| is at most this, by Cauchy and Schwarz.
        let whole = |q: &RealVector| (mobility * q.dot(&(&self.equations.mass * q))).sqrt();
        let (forced, motion) = (largest(&|q| row.dot(q).abs()), place.derivative_bound(0));
        GapSize { forced, moved: largest(&whole).max(forced).max(motion), place: place.mean().abs() + motion }
    }

    /// A run from displacements q and velocities u, per radian of the forcing, at `time`.
    ///
    /// # Errors
    /// A start behind a rigid stop, not finite, or of another size.
    pub fn start(&self, time: Time, q: &[f64], u: &[f64]) -> Result<Run<'_>> {
        let n = self.equations.size();
        if q.len() != n || u.len() != n {
            let (q, u) = (q.len(), u.len());
            return Err(Error::input(format!(
                "the start has {q} displacements and {u} velocities; it takes {n}"
            )));
        }
        if q.iter().chain(u).any(|x| !x.is_finite()) {
            return Err(Error::input("the start is not finite"));
        }
        let state =
            State { t: time.phase, q: RealVector::from_column_slice(q), u: RealVector::from_column_slice(u) };
        if let Some((contact, gap)) = self.stop_before(&state) {
            let name = &contact.name;
            return Err(Error::input(format!("the start lies behind the stop {name}: its gap is {gap:e}")));
        }
        Run::new(self, time, state)
    }

    /// v at each row with friction; where it is rounding's, 0.
    pub(crate) fn sliding(&self, state: &State) -> Vec<f64> {
        let still = |[rate, size]: [f64; 2]| if rate.abs() <= STILL * size { 0.0 } else { rate };
        self.rub_rates(state).into_iter().map(still).collect()
    }

    /// v at each row with friction, and what it is added up from.
    pub(crate) fn rub_rates(&self, state: &State) -> Vec<[f64; 2]> {
        if self.contacts.rubs().is_empty() {
            return Vec::new();
        }
        // |w q′| is at most the root of its mobility times this, by Cauchy and Schwarz.
        let whole = state.u.dot(&(&self.equations.mass * &state.u)).sqrt();
        let one = |(j, rub): (usize, &Rub)| {
            let mobility = self.contacts.mobility(self.contacts.rub_row(j));
            let size = mobility.sqrt() * whole + rub.speed.abs() + rub.motion.derivative_bound(0);
            [rub.rate(state), size]
        };
        self.contacts.rubs().iter().enumerate().map(one).collect()
    }

    /// The rigid stops whose gaps are within the minimum depth of 0, or below.
    fn touched(&self, state: &State) -> Vec<usize> {
        let depth = self.settings.minimum_depth;
        let near = |stop: &StopContact| stop.soft.is_none() && stop.gap(state)[0] <= depth;
        let all = self.contacts.all().iter().enumerate().filter(|(_, stop)| !self.through && near(stop));
        all.map(|(place, _)| place).collect()
    }

    /// The machine in contact so.
    fn stage(&self, holds: &Holds) -> Result<Arc<Stage>> {
        if holds.is_free() {
            return Ok(self.free.clone());
        }
        let mut stages = self.stages.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(stage) = stages.get(holds) {
            return Ok(stage.clone());
        }
        let formulas = self.smooth.as_ref();
        let stage =
            Stage::new(&self.equations, &self.contacts, holds, self.through, formulas).map_err(|error| {
                let stops = holds.resting.iter().chain(&holds.soft.pushing);
                let stops = stops.map(|&j| self.contacts.all()[j].name.as_str());
                let stuck = holds.stuck().map(|j| self.contacts.rubs()[j].name.as_str());
                let all: Vec<&str> = stops.chain(stuck).collect();
                error.context(format!("in contact with {}", all.join(", ")))
            })?;
        let stage = Arc::new(stage);
        stages.insert(holds.clone(), stage.clone());
        Ok(stage)
    }
}
