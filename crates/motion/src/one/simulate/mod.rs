//! Simulation: the flow, interrupted by impacts, rests on walls and nothing else, event by event.
//!
//! A [`Simulator`] is built once for a system and composed of the effects it has: a linear flow is followed
//! through tables of one grid of cells, any other by Taylor steps; a wall that is not there is not tested;
//! without any wall nothing is searched and the closed form is asked for the end at once; an autonomous
//! system has tables of one row. A coefficient of 0 and one not given build the same simulator.
//!
//! # What is promised
//!
//! - The gap to each wall is a polynomial on each piece of the trajectory. Every minimum of it below
//!   −[`minimum_depth`](Settings::minimum_depth) is an impact, found on the stretch on which the gap falls,
//!   whatever its velocity; a minimum within the depth of 0 is a
//!   [`Tangency`](crate::motion::Event::Tangency).
//! - The oscillator is never behind a wall by more than the minimum depth, nor leaves an impact with z′ of
//!   the wrong sign.
//! - Bounces that would be lower than the minimum depth on a wall that presses are summed as a geometric
//!   series and end in rest ([`Stick`](crate::motion::Event::Stick)) until the force of contact is 0
//!   ([`Release`](crate::motion::Event::Release)), at most one period later, or for good.
//! - A run ends by an [`RunEnd`] that says why.
//!
//! For linear systems the trajectory itself carries rounding errors only. For others the error is that of
//! [`Taylor`], an estimate: there the promises hold for the polynomials that are computed. No step leaps over
//! what a force does on the way; a force that changes in less than the shortest step ends the run.
//!
//! ```
//! use grazing_scenes::motion::{System, Time, Wall};
//! use grazing_scenes::one::simulate::{Event, Settings, Simulator};
//!
//! // A ball under gravity 1 on a table that keeps half of the velocity: 1 + 1 + 1/2 + 1/4 + … = 3.
//! let table = Wall { offset: 0.0, harmonics: vec![], restitution: 0.5 };
//! let (damping, stiffness, cubic, force) = (0.0, 0.0, 0.0, -1.0);
//! let lower = Some(table);
//! let (forcing, smooth, upper) = (vec![], None, None);
//! let ball = System { damping, stiffness, cubic, force, forcing, smooth, lower, upper, rate: None };
//! let simulator = Simulator::new(&ball, &Settings::default())?;
//! let mut run = simulator.start(Time::new(0, 0.0), 0.5, 0.0)?;
//! let mut rest = None;
//! run.record(Time::new(1, 0.0), |event| match event {
//!     Event::Stick(stick) => rest = Some(stick.time),
//!     other => assert!(matches!(other, Event::Impact(_))),
//! });
//! assert!((rest.unwrap().phase - 3.0).abs() < 1e-9);
//! # Ok::<(), grazing_scenes::Error>(())
//! ```

pub mod batch;
mod engine;
mod grid;
mod pieces;
mod rise;
mod steps;
mod wall;

use std::sync::Arc;

use engine::{Aloft, Engine, Loop};
use grid::{Grid, Place, Tables};
use pieces::Pieces;
use serde::Serialize;
use steps::Steps;
use wall::Walls;

use super::size;
use crate::{
    error::{Error, Result},
    motion::{
        Contact, Counter, EffectTally, RunEnd, Share, Side, State, System, Time,
        flow::{Free, Taylor},
        minimum::RELATIVE_DEPTH,
    },
};

/// What happens in a motion between two walls.
pub type Event = crate::motion::Event<Side>;

/// Whether a motion of this size counts as unbounded; what is not a number does.
fn unbounded(size: f64) -> bool {
    size.is_nan() || size > 1e100
}

/// How finely to simulate.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Settings {
    /// Gaps within this of 0 are contact without impact: see the promises of [`simulate`](self). In units of
    /// q, above 0. Default 1e-12, which suits motions of size 1: [`Settings::sized`] is for others. Where a
    /// trajectory is so large that rounding exceeds it, the rounding error takes its place.
    pub minimum_depth: f64,
    /// The tolerance of the integrator, where there is one: see `Taylor::new`. Default 1e-13.
    pub tolerance: f64,
    /// Whether to integrate a linear system, too, instead of using its closed form. Default false.
    pub integrate: bool,
    /// A run ends after this many impacts. Default: no limit.
    pub impact_limit: u64,
}

impl Settings {
    /// The same with the minimum depth that suits motions from these starts: 10⁻¹² of the size of the gap to
    /// the nearest wall, of what the forces do in a radian and of the wall's place and motion or, where there
    /// is none of this, of the starts, their velocities as they are shown. It goes with the unit of length.
    ///
    /// # Errors
    /// Coefficients that are not finite.
    pub fn sized(self, system: &System<f64>, starts: &[State]) -> Result<Settings> {
        let (flow, contacts) = (Free::new(system, self.tolerance)?, Contact::of(system)?);
        let own = size::gap_size(flow.equation(), contacts.iter());
        let start =
            |most: f64, start: &State| most.max(start.q.abs()).max(start.u.abs() / system.shown_rate());
        let size = if own > 0.0 { own } else { starts.iter().fold(0.0, start) };
        let size = if size > 0.0 && size.is_finite() { size } else { 1.0 };
        Ok(Settings { minimum_depth: RELATIVE_DEPTH * size, ..self })
    }
}

impl Default for Settings {
    fn default() -> Self {
        Settings { minimum_depth: 1e-12, tolerance: 1e-13, integrate: false, impact_limit: u64::MAX }
    }
}

/// A system ready to run from many starts and on many threads.
#[derive(Debug, Clone)]
pub struct Simulator {
    method: Method,
    flow: Free,
    walls: Walls,
    settings: Settings,
    tally: Option<Arc<EffectTally>>,
    /// Radians in a unit of the time in which velocities are shown.
    rate: f64,
}

#[derive(Debug, Clone)]
enum Method {
    Still(Grid<false>),
    Driven(Grid<true>),
    Steps(Steps),
}

/// A trajectory under way.
pub struct Run<'a> {
    engine: Box<dyn Engine + 'a>,
    rate: f64,
}

impl Simulator {
    /// Builds what the system needs and nothing else; O(16 R (walls + harmonics)) for a linear one, R the
    /// largest frequency.
    ///
    /// # Errors
    /// Coefficients that are not finite, a negative restitution, walls that meet, a setting out of range, a
    /// frequency above some 10⁴.
    pub fn new(system: &System<f64>, settings: &Settings) -> Result<Self> {
        let depth = settings.minimum_depth;
        if !(depth > 0.0 && depth.is_finite()) {
            return Err(Error::input(format!("minimum_depth = {depth} is not positive")));
        }
        let contact = |side: Side, wall: &Option<_>| {
            let contact = wall.as_ref().map(|wall| Contact::new(side, wall)).transpose();
            contact.map_err(|e| e.context(format!("{} wall", side.name())))
        };
        let contacts = [contact(Side::Lower, &system.lower)?, contact(Side::Upper, &system.upper)?];
        let flow = if settings.integrate {
            Free::Taylor(Taylor::new(system, settings.tolerance)?)
        } else {
            Free::new(system, settings.tolerance)?
        };
        let walls = Walls::new(flow.equation(), contacts, depth)?;
        let moving = walls.contacts.iter().flatten().any(|contact| contact.position.order() > 0);
        let method = match &flow {
            Free::Linear(linear) if moving || linear.equation().forcing.order() > 0 => {
                Method::Driven(Grid::new(linear, &walls.contacts)?)
            }
            Free::Linear(linear) => Method::Still(Grid::new(linear, &walls.contacts)?),
            Free::Taylor(taylor) => Method::Steps(Steps::new(taylor, &walls.contacts)),
        };
        Ok(Simulator {
            method,
            flow,
            walls,
            settings: settings.clone(),
            tally: None,
            rate: system.shown_rate(),
        })
    }

    /// The same simulator, the work of its runs added up in `tally`. What counting costs has not been
    /// measured.
    #[must_use]
    pub fn counting(self, tally: Arc<EffectTally>) -> Self {
        // The steps of its runs are counted by the runs; those of the bare flow, which carries vectors, by
        // itself.
        Simulator { flow: self.flow.counting(tally.clone()), tally: Some(tally), ..self }
    }

    /// The same as of another whose work is counted there, or is not.
    #[must_use]
    pub(crate) fn counting_too(self, tally: Option<&Arc<EffectTally>>) -> Self {
        match tally {
            Some(tally) => self.counting(tally.clone()),
            None => self,
        }
    }

    /// Radians in a unit of the time in which velocities are shown.
    pub fn rate(&self) -> f64 {
        self.rate
    }

    /// A state of its motions with the velocity as it is shown.
    pub fn as_start(&self, state: State) -> State {
        State { u: state.u * self.rate, ..state }
    }

    /// How finely it simulates.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The flow between impacts.
    pub fn flow(&self) -> &Free {
        &self.flow
    }

    /// The walls that are there, lower before upper.
    pub fn contacts(&self) -> impl Iterator<Item = &Contact> {
        self.walls.contacts.iter().flatten()
    }

    /// One of the walls, if it is there.
    pub fn contact(&self, side: Side) -> Option<&Contact> {
        self.walls.contacts[side as usize].as_ref()
    }

    /// A run from displacement q and velocity u at `time`.
    ///
    /// # Errors
    /// A start behind a wall, or not finite.
    pub fn start(&self, time: Time, q: f64, u: f64) -> Result<Run<'_>> {
        match &self.tally {
            None => self.start_counting(time, q, u, ()),
            Some(tally) => self.start_counting(time, q, u, Share::of(tally)),
        }
    }

    /// The same, every evaluation told to `counter`.
    ///
    /// # Errors
    /// Those of [`start`](Self::start).
    pub fn start_counting<'a>(
        &'a self,
        time: Time,
        q: f64,
        u: f64,
        counter: impl Counter + 'a,
    ) -> Result<Run<'a>> {
        match &self.method {
            Method::Still(grid) => self.run(grid, time, [q, u], counter),
            Method::Driven(grid) => self.run(grid, time, [q, u], counter),
            Method::Steps(steps) => self.run(steps, time, [q, u], counter),
        }
    }

    /// The tables of a linear system with a wall.
    fn tables(&self) -> Option<Tables<'_>> {
        self.walls.contacts.iter().flatten().next()?;
        match &self.method {
            Method::Still(grid) => Some(grid.tables()),
            Method::Driven(grid) => Some(grid.tables()),
            Method::Steps(_) => None,
        }
    }

    /// Where a phase lies on the grid of a linear system.
    fn place(&self, phase: f64) -> Option<Place> {
        match &self.method {
            Method::Still(grid) => Some(grid.place(phase)),
            Method::Driven(grid) => Some(grid.place(phase)),
            Method::Steps(_) => None,
        }
    }

    /// A run that goes on with a motion in flight, of a system with tables.
    fn resume(&self, aloft: Aloft) -> Run<'_> {
        match &self.tally {
            None => self.resume_counting(aloft, ()),
            Some(tally) => self.resume_counting(aloft, Share::of(tally)),
        }
    }

    fn resume_counting<'a>(&'a self, aloft: Aloft, counter: impl Counter + 'a) -> Run<'a> {
        match &self.method {
            Method::Still(grid) => self.rejoin(grid, aloft, counter),
            Method::Driven(grid) => self.rejoin(grid, aloft, counter),
            Method::Steps(steps) => self.rejoin(steps, aloft, counter),
        }
    }

    fn rejoin<'a>(&'a self, pieces: &'a impl Pieces, aloft: Aloft, counter: impl Counter + 'a) -> Run<'a> {
        let (walls, settings) = (&self.walls, &self.settings);
        let engine: Box<dyn Engine + 'a> = match walls.contacts {
            [Some(_), Some(_)] => {
                Box::new(Loop::<_, _, true, true>::resume(pieces, walls, settings, aloft, counter))
            }
            [Some(_), None] => {
                Box::new(Loop::<_, _, true, false>::resume(pieces, walls, settings, aloft, counter))
            }
            [None, _] => Box::new(Loop::<_, _, false, true>::resume(pieces, walls, settings, aloft, counter)),
        };
        Run { engine, rate: self.rate }
    }

    fn run<'a>(
        &'a self,
        pieces: &'a impl Pieces,
        time: Time,
        at: [f64; 2],
        counter: impl Counter + 'a,
    ) -> Result<Run<'a>> {
        let (walls, settings) = (&self.walls, &self.settings);
        let engine: Box<dyn Engine + 'a> = match walls.contacts {
            [None, None] => {
                Box::new(Loop::<_, _, false, false>::new(pieces, walls, settings, time, at, counter)?)
            }
            [Some(_), None] => {
                Box::new(Loop::<_, _, true, false>::new(pieces, walls, settings, time, at, counter)?)
            }
            [None, Some(_)] => {
                Box::new(Loop::<_, _, false, true>::new(pieces, walls, settings, time, at, counter)?)
            }
            [Some(_), Some(_)] => {
                Box::new(Loop::<_, _, true, true>::new(pieces, walls, settings, time, at, counter)?)
            }
        };
        Ok(Run { engine, rate: self.rate })
    }
}

impl Run<'_> {
    /// Radians in a unit of the time in which velocities are shown.
    pub(crate) fn rate(&self) -> f64 {
        self.rate
    }

    /// On to the next event, no further than `until`. An impact at the initial time comes first of all.
    pub fn next(&mut self, until: Time) -> Event {
        self.engine.next(until)
    }

    /// Where the run is in time.
    pub fn time(&self) -> Time {
        self.engine.time()
    }

    /// The motion now, after the impact if there is one; t is the phase.
    pub fn state(&self) -> State {
        self.engine.state()
    }

    /// How many impacts there were.
    pub fn impacts(&self) -> u64 {
        self.engine.impacts()
    }

    /// On to `until`, events unseen.
    pub fn finish(&mut self, until: Time) -> RunEnd {
        self.record(until, |_| {})
    }

    /// On to `until`, each event shown.
    pub fn record(&mut self, until: Time, mut each: impl FnMut(Event)) -> RunEnd {
        loop {
            match self.next(until) {
                Event::End(end) => return end,
                event => each(event),
            }
        }
    }
}
