//! Tasks of kind `simulate`: one motion, its impacts and rests.

use serde::Serialize;

use super::{
    Finding, Job, Keeper, Lines, SeriesOf, SeriesPoint, Status, StopEvent, Tabular,
    engine::{Engine, by_engine},
    row, small_motion,
};
use crate::{
    error::Result,
    motion::{RunEnd, Time},
    scene::{simulate::SimulateTask, values::ROUNDED},
};

row! {
    /// What happened at a stop.
    #[derive(Default)]
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
        /// The impulses of all impacts there, or the integral of the force with which a stop that gives way
        /// pushed; what holds the motion at rest on a rigid stop is not in it.
        pub impulse: f64,
        /// The largest force found with which a stop that gives way pushes, in the scene's units; absent for
        /// a rigid one.
        pub peak_force: Option<f64>,
        /// How long the longest contact with a stop that gives way pushed; absent for a rigid one.
        pub longest: Option<f64>,
        /// The energy that impacts and contacts took: of a rigid stop ½ m (1 − τ²) v² each, m being the mass
        /// felt there, and what friction on it takes of an impact; of one that gives way all that does not
        /// stay stored in it: what its damper takes.
        pub dissipated: f64,
        /// The least gap at points of the series.
        pub least_gap: f64,
        /// The largest gap at points of the series.
        pub largest_gap: f64,
    }
}

row! {
    /// What happened where there is dry friction.
    #[derive(Default)]
    pub struct FrictionRow {
        /// Its name.
        pub friction: String,
        /// How often it came to stick.
        pub sticks: u64,
        /// How often the sliding turned back without sticking.
        pub reversals: u64,
        /// The part of the time in which it sticks.
        pub stuck: f64,
        /// How far it slid, there and back, under a normal force.
        pub path: f64,
        /// The energy that the friction took: the force of sliding times the path. What it takes at impacts
        /// is told of the stop.
        pub dissipated: f64,
        /// What it does at the end: `slides`; `open`, where the stop on which it would is open; `sticks`;
        /// `sticks for ever`, where nothing moves it in a period more and the motion is the same after that,
        /// to 10⁻⁹.
        pub at_end: &'static str,
    }
}

row! {
    /// What happened at a kink or a jump of a force.
    pub struct KinkRow {
        /// As it is written.
        pub kink: String,
        /// How often the motion crossed it.
        pub crossings: u64,
    }
}

row! {
    /// How often a threshold was crossed.
    pub struct ThresholdRow {
        /// Its name.
        pub event: String,
        /// How often upwards.
        pub up: u64,
        /// How often downwards.
        pub down: u64,
        /// When first, in forcing periods since t = 0; absent if never.
        pub first: Option<f64>,
        /// When last.
        pub last: Option<f64>,
    }
}

row! {
    /// What wears off a stop, where the scene says how much.
    pub struct WearRow {
        /// Its name.
        pub stop: String,
        /// The volume that wore off: the stop's coefficient times the energy that impacts and contacts took.
        pub volume: f64,
        /// The same per unit of time.
        pub rate: f64,
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
    #[derive(Default)]
    pub struct Moved {
        /// Forcing periods asked for after the transient; a part of one counts as one.
        pub periods: u32,
        /// The period, in the scene's unit of time.
        pub period: f64,
        /// How the motion is computed.
        pub method: &'static str,
        /// The condition number of a machine's modes; absent where they do not exist or forces are formulas.
        pub condition: Option<f64>,
        /// How many modes of a machine oscillate.
        pub oscillating: Option<usize>,
        /// Impacts after the transient; contacts with compliant stops count.
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
        /// The least and the greatest displacement at points of the series and at stops; of a motion with one
        /// displacement.
        pub extent: Option<Vec<f64>>,
        /// What counts as contact without impact.
        pub minimum_depth: f64,
    }
}

/// What happened in one motion; its series and its events went to the [`Keeper`].
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SimulationFindings {
    /// The motion in numbers.
    #[serde(flatten)]
    pub(crate) moved: Moved,
    /// The slowest modes of a machine, at most ten; where forces are formulas, of the machine linearised at
    /// rest.
    pub(crate) modes: Vec<ModeRow>,
    /// What happened at each stop, after the transient.
    pub(crate) stops: Vec<StopRow>,
    /// What happened at each row with dry friction, after the transient.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) friction: Vec<FrictionRow>,
    /// What happened at each kink or jump of a force, after the transient.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) kinks: Vec<KinkRow>,
    /// The events, after the transient.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) events: Vec<ThresholdRow>,
    /// What wears off stops that have a coefficient for it, after the transient.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) wear: Vec<WearRow>,
    /// What the harmonics of a measured force leave out, if there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) measured: Option<MeasuredEffect>,
    /// The accelerations at the end.
    #[serde(skip)]
    pub(super) acceleration: Vec<f64>,
    /// When the series begins, in periods.
    #[serde(skip)]
    begin: f64,
    /// How many impacts, each on one stop alone, left more energy than there was.
    #[serde(skip)]
    gained: u64,
    /// The last instant at which the order of several impacts mattered: it counts once.
    #[serde(skip)]
    several: Option<Time>,
}

/// How well the harmonics of a measured force stand for it, and what of it the motion feels.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct MeasuredEffect {
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

impl Finding for SimulationFindings {
    fn status(&self) -> Status {
        let Moved { end, ended_at, q, u, .. } = &self.moved;
        Status::of_motion(*end, *ended_at, [q, u, &self.acceleration])
    }

    fn warnings(&self) -> Vec<String> {
        let Moved { order_matters, ref extent, minimum_depth, .. } = self.moved;
        let mut all = Vec::new();
        if self.gained > 0 {
            all.push(format!(
                "{} times an impact gave the motion energy: a restitution above 1, or friction at an eccentric impact under Newton's law",
                self.gained
            ));
        }
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
        // What sticks extends over nothing, and where there is no stop there are no impacts to tell.
        let width = extent.as_ref().filter(|_| self.friction.is_empty() || !self.stops.is_empty());
        let width = width.map(|ends| ends[1] - ends[0]);
        all.extend(width.and_then(|width| small_motion(width, minimum_depth)));
        all
    }

    fn lines(&self, lines: &mut Lines) {
        let moved = &self.moved;
        // A list of dozens is no end to be read; that all was followed need not be said.
        let short = |(name, cell): &(&str, String)| match *name {
            "q" | "u" => moved.q.len() <= 10,
            "end" | "ended_at" => moved.end != RunEnd::Reached,
            _ => !cell.is_empty(),
        };
        lines.fields(moved, short);
        listed(lines, "modes", &self.modes);
        listed(lines, "stops", &self.stops);
        listed(lines, "friction", &self.friction);
        listed(lines, "kinks", &self.kinks);
        listed(lines, "events", &self.events);
        listed(lines, "wear", &self.wear);
        self.measured.iter().for_each(|measured| measured.lines(lines));
    }
}

/// A table that has rows.
fn listed(lines: &mut Lines, name: &str, table: &impl Tabular) {
    if !table.cells(None).is_empty() {
        lines.table(name, table);
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
        lines.exact();
        lines.say("bound", self.bound);
        if let (Some(gap), Some(time)) = (self.gap_change, self.time_change) {
            lines.say("gap_change", gap);
            lines.say("time_change", time);
        }
    }
}

/// The words for an event, as its function passes 0 upwards and downwards.
pub(super) const UP: &str = "upcrossing";
pub(super) const DOWN: &str = "downcrossing";

/// Modes that a report lists.
const LISTED: usize = 10;

/// Follows the motion; each point and each event goes to `keeper` as it comes, so that memory does not grow
/// with the length.
///
/// # Errors
/// Those of the simulator; the keeper's; an interruption.
pub(crate) fn simulate(
    task: &SimulateTask,
    job: &Job,
    keeper: &mut dyn Keeper,
) -> Result<SimulationFindings> {
    let mut found: SimulationFindings = by_engine!(job, engine => engine.simulate(task, keeper))?;
    let time = (found.moved.ended_at - found.begin) * found.moved.period;
    for (row, wear) in found.stops.iter().zip(job.scene.wear()?) {
        let Some(volume) = wear.map(|wear| wear * row.dissipated) else { continue };
        let rate = if time > 0.0 { volume / time } else { 0.0 };
        found.wear.push(WearRow { stop: row.stop.clone(), volume, rate });
    }
    Ok(found)
}

impl StopRow {
    fn new(name: &str, compliant: bool) -> StopRow {
        StopRow {
            stop: name.into(),
            strongest: (!compliant).then_some(0.0),
            peak_force: compliant.then_some(0.0),
            longest: compliant.then_some(0.0),
            least_gap: f64::INFINITY,
            largest_gap: f64::NEG_INFINITY,
            ..StopRow::default()
        }
    }
}

impl ThresholdRow {
    fn new(name: &str) -> ThresholdRow {
        ThresholdRow { event: name.into(), up: 0, down: 0, first: None, last: None }
    }
}

impl FrictionRow {
    fn new(name: &str) -> FrictionRow {
        FrictionRow { friction: name.into(), at_end: "slides", ..FrictionRow::default() }
    }
}

impl SimulationFindings {
    /// Before anything has happened in a motion over so many periods that a series is of, with stops that are
    /// compliant or not.
    pub(super) fn new(
        span: f64,
        (of, compliant): (&SeriesOf, &[bool]),
        method: &'static str,
        minimum_depth: f64,
    ) -> Self {
        let moved = Moved {
            periods: span.ceil() as u32,
            period: of.period,
            method,
            extent: (of.points == 1).then(|| vec![f64::INFINITY, f64::NEG_INFINITY]),
            minimum_depth,
            ..Moved::default()
        };
        let stops = of.stops.iter().zip(compliant);
        SimulationFindings {
            moved,
            modes: Vec::new(),
            stops: stops.map(|(stop, &compliant)| StopRow::new(&stop.name, compliant)).collect(),
            friction: of.friction.iter().map(|name| FrictionRow::new(name)).collect(),
            kinks: of.kinks.iter().map(|kink| KinkRow { kink: kink.clone(), crossings: 0 }).collect(),
            events: of.events.iter().map(|name| ThresholdRow::new(name)).collect(),
            wear: Vec::new(),
            measured: None,
            begin: of.begin,
            gained: 0,
            acceleration: Vec::new(),
            several: None,
        }
    }

    /// The slowest of the modes that oscillate, each a frequency in cycles per unit of time and a damping
    /// ratio.
    pub(super) fn oscillating(&mut self, modes: &[(f64, f64)]) {
        self.moved.oscillating = Some(modes.len());
        let row = |&(frequency, damping_ratio)| ModeRow { frequency, damping_ratio };
        self.modes = modes.iter().take(LISTED).map(row).collect();
    }

    /// Where it ended, and what bends it there.
    pub(super) fn ended(&mut self, end: (RunEnd, Time), [q, u, acceleration]: [Vec<f64>; 3]) {
        (self.moved.end, self.moved.ended_at) = (end.0, end.1.periods());
        if let [q] = q[..] {
            self.widen(q);
        }
        (self.moved.q, self.moved.u, self.acceleration) = (q, u, acceleration);
    }

    fn widen(&mut self, q: f64) {
        if let Some(ends) = &mut self.moved.extent {
            (ends[0], ends[1]) = (ends[0].min(q), ends[1].max(q));
        }
    }

    /// Takes a point of the series into account.
    pub(super) fn passed(&mut self, sample: &SeriesPoint) {
        if let [q] = *sample.q {
            self.widen(q);
        }
        for (row, &[gap, _]) in self.stops.iter_mut().zip(sample.gaps) {
            (row.least_gap, row.largest_gap) = (row.least_gap.min(gap + 0.0), row.largest_gap.max(gap + 0.0));
        }
    }

    /// Takes an event into account; false of a rest in which the motion begins: nothing happens there.
    pub(super) fn happened(&mut self, event: &StopEvent) -> bool {
        if let Some([q, _]) = event.place {
            self.widen(q);
        }
        let Some(row) = self.stops.get_mut(event.stop) else {
            let place = event.stop - self.stops.len();
            let Some(row) = self.friction.get_mut(place) else {
                let place = place - self.friction.len();
                if let Some(row) = self.kinks.get_mut(place) {
                    row.crossings += 1;
                    return true;
                }
                let (row, now) = (&mut self.events[place - self.kinks.len()], event.time.periods());
                if event.event == UP {
                    row.up += 1
                } else {
                    row.down += 1
                }
                (row.first, row.last) = (row.first.or(Some(now)), Some(now));
                return true;
            };
            match event.event {
                "stick" => row.sticks += 1,
                "reversal" => row.reversals += 1,
                _ => {}
            }
            return true;
        };
        let moved = &mut self.moved;
        let since = |rest: f64| event.time.periods() - self.begin - rest / moved.period;
        let late = ROUNDED * event.time.periods();
        if event.rest.is_some_and(|rest| row.impacts == 0 && since(rest) <= late) {
            return false;
        }
        if let Some(velocity) = event.velocity {
            moved.first_impact.get_or_insert(event.time.periods());
            (moved.impacts, row.impacts) = (moved.impacts + 1, row.impacts + 1);
            row.fastest = row.fastest.max(velocity.abs());
        }
        if let Some(impulse) = event.impulse {
            row.strongest = row.strongest.map(|most| most.max(impulse));
            row.impulse += impulse;
        }
        if let Some(energy) = event.energy {
            row.dissipated += energy;
            // Rounding leaves a part of what is exchanged. Without friction only a restitution above 1 gains,
            // and of that the scene warns.
            let exchanged = event.impulse.unwrap_or(0.0) * event.velocity.unwrap_or(0.0).abs();
            let gains = event.together == Some(1) && energy < -1e-9 * exchanged;
            self.gained += u64::from(gains && !self.friction.is_empty());
        }
        if event.order_matters == Some(true) && self.several != Some(event.time) {
            moved.order_matters += 1;
            self.several = Some(event.time);
        }
        match event.event {
            "tangency" => (moved.tangencies, row.tangencies) = (moved.tangencies + 1, row.tangencies + 1),
            "stick" => (moved.rests, row.rests) = (moved.rests + 1, row.rests + 1),
            _ => {}
        }
        true
    }
}
