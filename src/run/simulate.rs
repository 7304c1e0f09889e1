//! Tasks of kind `simulate`: one motion, its impacts and rests.

use serde::{
    Serialize, Serializer,
    ser::{Error as _, SerializeMap},
};

use super::{
    Finding, Job, Keeper, Lines, Row, Status,
    columns::{SIMULATED, SIMULATED_LINES},
    engine::{Engine, by_engine},
    row, small_motion,
    table::{columns_of, select},
};
use crate::{
    error::Result,
    motion::{Event, RunEnd, event::Place},
    scene::simulate::SimulateTask,
};

row! {
    /// What happened at a stop.
    pub struct StopRow {
        /// Its name.
        pub stop: String,
        /// Impacts there; contacts with a stop that gives way.
        pub impacts: u64,
        /// Minima of its gap within the minimum depth, of which no impact or contact was made.
        pub tangencies: u64,
        /// How often something came to rest on it.
        pub rests: u64,
        /// The largest speed of an impact, or with which a contact began, in the scene's units.
        pub fastest: f64,
        /// The largest impulse of an impact, in the scene's units; absent for a stop that gives way.
        pub strongest: Option<f64>,
        /// The largest force found with which a stop that gives way pushes, in the scene's units; absent for
        /// a rigid one.
        pub peak_force: Option<f64>,
        /// The least gap at points of the series.
        pub least_gap: f64,
        /// The largest gap at points of the series.
        pub largest_gap: f64,
    }
}

row! {
    /// A mode that oscillates.
    pub struct ModeRow {
        /// Its natural frequency, in cycles per unit of time.
        pub frequency: f64,
        /// Its damping ratio.
        pub damping_ratio: f64,
    }
}

row! {
    /// One motion, in numbers.
    pub struct Moved {
        /// Forcing periods asked for after the transient.
        pub periods: u32,
        /// The period, in the scene's unit of time.
        pub period: f64,
        /// How the motion of a machine is computed.
        pub method: Option<&'static str>,
        /// The condition number of a machine's modes; absent where they do not exist or forces are formulas.
        pub condition: Option<f64>,
        /// How many modes of a machine oscillate.
        pub oscillating: usize,
        /// Impacts on rigid stops, after the transient.
        pub impacts: u64,
        /// Minima of a gap within the minimum depth, of which no impact or contact was made.
        pub tangencies: u64,
        /// How often it came to rest on a stop.
        pub rests: u64,
        /// Instants at which several stops were hit and impacts one by one would have ended otherwise.
        pub order_matters: u64,
        /// When a stop was first met, in forcing periods since t = 0, after the transient.
        pub first_impact: Option<f64>,
        /// Why it ended.
        pub end: RunEnd,
        /// Forcing periods from the beginning to the end.
        pub ended_at: f64,
        /// The displacements at the end.
        pub q: Vec<f64>,
        /// The velocities at the end.
        pub u: Vec<f64>,
        /// Of an oscillator, the least and the greatest displacement at points of the series and at impacts.
        pub extent: Option<[f64; 2]>,
        /// What counts as contact without impact.
        pub minimum_depth: f64,
    }
}

/// What happened in one motion; its series and its events went to the [`Keeper`].
#[derive(Debug, Clone, PartialEq)]
pub struct SimulationFindings {
    /// The motion in numbers.
    pub moved: Moved,
    /// The slowest modes of a machine, at most ten; where forces are formulas, of the machine linearised at
    /// rest.
    pub modes: Vec<ModeRow>,
    /// What happened at each stop of a machine, after the transient.
    pub stops: Vec<StopRow>,
    /// What the harmonics of a measured force leave out, if there is one.
    pub measured: Option<MeasuredEffect>,
    /// The accelerations at the end.
    pub(super) acceleration: Vec<f64>,
    /// The entries of the object, and the lines of text.
    pub(super) columns: [&'static str; 2],
}

/// How well the harmonics of a measured force stand for it, and what of it the motion feels.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MeasuredEffect {
    /// The file.
    pub file: String,
    /// The samples used, of so many whole periods; the rest is left out.
    pub samples: usize,
    /// Whole periods in the record.
    pub periods: usize,
    /// The samples left out.
    pub left_out: usize,
    /// How many harmonics stand for it.
    pub harmonics: usize,
    /// The largest difference from a sample.
    pub residual: f64,
    /// The largest difference from the record, taken as straight between samples, is no larger. Of a record
    /// taken once an eighth of its largest second difference: what a smooth force may have been off that
    /// between the samples.
    pub bound: f64,
    /// What stands for it: "harmonics", or "linear", straight lines between the samples of a record taken
    /// once.
    pub interpolation: &'static str,
    /// By how much a force of that size could change the gap at the first impact.
    pub gap_change: Option<f64>,
    /// By how much of a period it could change its time, to first order; absent without an impact.
    pub time_change: Option<f64>,
}

impl Serialize for SimulationFindings {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let all = serde_json::to_value(&self.moved).map_err(S::Error::custom)?;
        let mut map = serializer.serialize_map(None)?;
        for column in columns_of(self.columns[0]) {
            match (column.0, &self.measured) {
                ("modes", _) => map.serialize_entry("modes", &self.modes)?,
                ("stops", _) => map.serialize_entry("stops", &self.stops)?,
                ("measured", None) => {}
                ("measured", Some(measured)) => map.serialize_entry("measured", measured)?,
                (name, _) => map.serialize_entry(name, select(column, &all))?,
            }
        }
        map.end()
    }
}

impl Finding for SimulationFindings {
    fn status(&self) -> Status {
        let Moved { end, ended_at, q, u, .. } = &self.moved;
        Status::of_motion(*end, *ended_at, [q, u, &self.acceleration])
    }

    fn warnings(&self) -> Vec<String> {
        let Moved { order_matters, extent, minimum_depth, .. } = self.moved;
        let mut all = Vec::new();
        if order_matters > 0 {
            all.push(format!(
                "{order_matters} times several stops were hit at one instant and the outcome depends on the order: Newton's law for all at once was used"
            ));
        }
        for stop in &self.stops {
            let extent = stop.largest_gap - stop.least_gap;
            if stop.impacts > 0 && extent < 1e3 * minimum_depth {
                all.push(format!(
                    "the gap of stop {} extends over {extent:.3e}, within a thousand times minimum_depth = {minimum_depth:e}: impacts \
                     shallower than that are not told from contact; lower minimum_depth",
                    stop.stop
                ));
            }
        }
        all.extend(extent.and_then(|[low, high]| small_motion(high - low, minimum_depth)));
        all
    }

    fn lines(&self, lines: &mut Lines) {
        let moved = &self.moved;
        for column in columns_of(self.columns[1]) {
            match column.0 {
                "modes" => lines.table("modes", &self.modes),
                "more_modes" if moved.oscillating > self.modes.len() => {
                    lines.say("more_modes", moved.oscillating - self.modes.len());
                }
                "stops" => lines.table("stops", &self.stops),
                "ended" if moved.end != RunEnd::Reached => {
                    lines.say("ended", moved.end.why());
                    lines.say("after_periods", moved.ended_at);
                }
                "measured" => self.measured.iter().for_each(|measured| measured.lines(lines)),
                // A list of dozens is no end to be read.
                "q" | "u" if moved.q.len() > 10 => {}
                name => {
                    if let Some(cell) = moved.cell(column) {
                        lines.say(name, cell);
                    }
                }
            }
        }
    }
}

impl MeasuredEffect {
    fn lines(&self, lines: &mut Lines) {
        lines.say("measured_force", self.file.as_str());
        lines.say("interpolation", self.interpolation);
        if self.harmonics > 0 {
            lines.say("harmonics", self.harmonics);
            lines.say("residual", self.residual);
        }
        lines.say("bound", self.bound);
        if let (Some(gap), Some(time)) = (self.gap_change, self.time_change) {
            lines.say("gap_change", gap);
            lines.say("time_change", time);
        }
    }
}

/// Follows the motion; each point and each event goes to `keeper` as it comes, so that memory does not grow
/// with the length.
///
/// # Errors
/// Those of the simulator; the keeper's; an interruption.
pub fn simulate(task: &SimulateTask, job: &Job, keeper: &mut dyn Keeper) -> Result<SimulationFindings> {
    by_engine!(job, engine => engine.simulate(task, keeper))
}

impl SimulationFindings {
    /// Before anything has happened.
    pub(super) fn new(task: &SimulateTask, job: &Job, period: f64, minimum_depth: f64) -> Self {
        let moved = Moved {
            periods: task.periods,
            period,
            method: None,
            condition: None,
            oscillating: 0,
            impacts: 0,
            tangencies: 0,
            rests: 0,
            order_matters: 0,
            first_impact: None,
            end: RunEnd::Reached,
            ended_at: 0.0,
            q: Vec::new(),
            u: Vec::new(),
            extent: None,
            minimum_depth,
        };
        SimulationFindings {
            moved,
            modes: Vec::new(),
            stops: Vec::new(),
            measured: None,
            acceleration: Vec::new(),
            columns: [SIMULATED.of(job), SIMULATED_LINES.of(job)],
        }
    }

    /// Adds an event.
    pub(super) fn count<P: Place>(&mut self, event: &Event<P>) {
        if let (Some(time), Some(_)) = (event.time(), event.velocity()) {
            self.moved.first_impact.get_or_insert(time.periods());
        }
        match event {
            Event::Impact(_) => self.moved.impacts += 1,
            Event::Tangency(_) => self.moved.tangencies += 1,
            Event::Stick(_) => self.moved.rests += 1,
            _ => {}
        }
    }
}
