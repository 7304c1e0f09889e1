//! Tasks of kind `response`: how far a machine swings over a parameter, as a rule the drive's frequency.
//!
//! Linear, in closed form, with peaks; and as it is seen by following motions up and down, as a `diagram`
//! that sweeps does.

use std::f64::consts::TAU;

use serde::Serialize;

use super::{
    Finding, Job, Lines, Status,
    backbone::{Backbone, BackboneEndRow, BackboneRow, backbone},
    diagram::{sweep_steps, value, ways},
    engine::{Engine, by_engine},
    families::of_several,
    highest::{HighestRow, highest},
    row,
    swept::{SweepFindings, way},
    unstable::{Unstable, UnstableOrbit, UnstableRow, unstable},
};
use crate::{
    attractor::swing::Swing,
    continuation::Options,
    error::Result,
    many::{
        Machine,
        peaks::{Peak, peaks},
        resonance::{self, FreeResponse},
    },
    rounding::SUM,
    scene::{Frame, branches::DiagramTask, response::ResponseTask},
};

row! {
    /// How far a coordinate or a gap swings at a value.
    pub struct ResponseRow {
        /// `linear`; which way the parameter goes; or `unstable`.
        pub way: &'static str,
        /// The parameter's value.
        pub value: f64,
        /// The coordinate, or the stop whose gap it is.
        pub coordinate: String,
        /// Half of the way from its least to its greatest value.
        pub swing: f64,
        /// The amplitude A of the harmonic, A cos(kt − 2π `lag`), t the angle of the forcing.
        pub amplitude: f64,
        /// By how much of its own period the harmonic lags, from 0 to 1; absent where it is 0.
        pub lag: Option<f64>,
        /// The motion's period, in forcing periods; absent if it is not periodic or not settled.
        pub period: Option<u32>,
        /// Impacts in a period.
        pub impacts: Option<u64>,
        /// The stop that the linear response reaches or crosses, the one it crosses farthest.
        pub stop: Option<String>,
        /// The stretch of unstable orbits, counted from 1.
        pub stretch: Option<usize>,
    }
}

row! {
    /// A peak of the linear response.
    pub struct PeakRow {
        /// The coordinate, or the stop whose gap it is.
        pub coordinate: String,
        /// The parameter's value there.
        pub value: f64,
        /// The harmonic's amplitude; absent where nothing damps the mode that resonates.
        pub amplitude: Option<f64>,
        /// By how much of its own period the harmonic lags.
        pub lag: Option<f64>,
        /// Below the peak, where the amplitude is 1/√2 of it.
        pub lower: Option<f64>,
        /// Above it.
        pub upper: Option<f64>,
        /// Where the parameter is the drive's frequency, the damping ratio by the half-power points ω₁ and
        /// ω₂ of the peak ω: (ω₂² − ω₁²)/(4ω²).
        pub half_power_ratio: Option<f64>,
        /// The damping ratio of the mode whose natural frequency is nearest.
        pub damping_ratio: Option<f64>,
        /// Why there are no half-power points.
        pub open: Option<&'static str>,
    }
}

row! {
    /// Neighbouring values at which the linear response reaches a stop: the machine does something else.
    pub struct ContactRow {
        /// The first value.
        pub from: f64,
        /// The last.
        pub to: f64,
        /// The stop.
        pub stop: String,
        /// How many values.
        pub values: usize,
    }
}

/// The response over a parameter, and what it amounts to.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ResponseFindings {
    /// The parameter.
    pub parameter: String,
    /// Whether it is the drive's frequency, in whatever unit.
    pub is_frequency: bool,
    /// Which harmonic amplitudes and lags are of.
    pub harmonic: u32,
    /// How many values were looked at, each way.
    pub values: usize,
    /// Peaks of the linear response.
    pub peaks: Vec<PeakRow>,
    /// Where it reaches a stop.
    pub contact: Vec<ContactRow>,
    /// Values without a linear response: a mode without damping resonates, or a constant force drives one
    /// without stiffness away.
    pub resonant: Vec<f64>,
    /// Values at which a mode without stiffness leaves open about what the linear response moves: no stop is
    /// known to be reached there.
    pub floating: Vec<f64>,
    /// Where each coordinate and gap is seen to swing most, each way; none where only the linear response is
    /// asked for or is what is seen.
    pub highest: Option<Vec<HighestRow>>,
    /// The backbone curve, value by value. None where it is not asked for.
    pub backbone: Option<Vec<BackboneRow>>,
    /// Where it ends, and why.
    pub backbone_ends: Option<Vec<BackboneEndRow>>,
    /// What is seen up and down, as of a `diagram` that sweeps.
    pub sweep: Option<SweepFindings>,
    /// Where the orbits that it leaves go on, unstable.
    pub unstable: Option<Vec<UnstableRow>>,
    /// Values at which it is not decided whether a motion tends to a periodic orbit.
    pub not_settled: Vec<f64>,
    /// All swings. Not in JSON: they are the task's CSV file.
    #[serde(skip)]
    pub rows: Vec<ResponseRow>,
    /// Whether peaks are all that there are; if not, a warning says so.
    #[serde(skip)]
    pub all_peaks: bool,
    /// Which branches were not followed, and why. In JSON these are warnings.
    #[serde(skip)]
    pub open: Vec<String>,
    /// Why the backbone has no points, if it has none. In JSON it is the status's reason.
    #[serde(skip)]
    pub no_backbone: Option<String>,
}

impl Finding for ResponseFindings {
    fn status(&self) -> Status {
        if let Some(first) = self.not_settled.first() {
            let why = match self.resonant.contains(first) {
                true => "nothing damps it there, and it may grow for ever",
                false => "raise `transient`",
            };
            return Status::undecided(format!(
                "{} times a motion is not settled, first at {first}: {why}",
                self.not_settled.len()
            ));
        }
        if let Some(why) = &self.no_backbone {
            return Status::nothing(format!("the backbone has no point: {why}"));
        }
        let unfollowed = |row: &&BackboneEndRow| matches!(row.why, "points" | "lost");
        if let Some(row) = self.backbone_ends.iter().flatten().find(unfollowed) {
            return Status::undecided(format!(
                "the backbone of mode {} was followed no farther than {}",
                row.mode, row.value
            ));
        }
        match self.rows.is_empty() && self.backbone.is_none() {
            false => Status::Done,
            true => Status::nothing("at no value is there a response"),
        }
    }

    fn warnings(&self) -> Vec<String> {
        let at = self.floating.first().map(|first| {
            format!(
                "at {} of {} values, the first {first}, a mode without stiffness leaves open about what the linear response \
                 moves: whether it reaches a stop is not told",
                self.floating.len(),
                self.values
            )
        });
        let open = "how the linear response changes with the parameter is not resolved everywhere: between values a peak may be \
                    missed";
        let peaks = (!self.all_peaks).then(|| open.to_string());
        at.into_iter().chain(peaks).chain(self.open.iter().cloned()).collect()
    }

    fn lines(&self, lines: &mut Lines) {
        lines.say("values", self.values);
        if self.harmonic != 1 {
            lines.say("harmonic", self.harmonic);
        }
        lines.table("peaks", &self.peaks);
        if !self.contact.is_empty() {
            lines.table("contact", &self.contact);
        }
        if !self.resonant.is_empty() {
            lines.say("resonant", self.resonant.clone());
        }
        if let Some(highest) = &self.highest {
            lines.table("highest", highest);
        }
        if let Some(backbone) = &self.backbone {
            lines.say("backbone", format!("{} points", backbone.len()));
        }
        if let Some(ends) = &self.backbone_ends {
            lines.table("backbone_ends", ends);
        }
        if let Some(sweep) = &self.sweep {
            sweep.lines(lines);
        }
        if let Some(unstable) = &self.unstable {
            lines.table("unstable", unstable);
        }
        if !self.not_settled.is_empty() {
            lines.say("not_settled", self.not_settled.len());
        }
    }
}

/// The response over the task's values, resuming from the checkpoint of an interrupted run if there is one.
///
/// # Errors
/// Those of the system at a value and of the simulator; an unusable checkpoint; an interruption.
pub(crate) fn response(task: &ResponseTask, job: &Job) -> Result<ResponseFindings> {
    by_engine!(job, engine => over(task, job, &engine))
}

fn over<E: Engine>(task: &ResponseTask, job: &Job, engine: &E) -> Result<ResponseFindings> {
    let family = engine.family(&task.parameter)?;
    let at = |value: f64| engine.machines(&family, value);
    let values: Vec<f64> = (0..task.count).map(|i| value(&task.range, i, task.count)).collect();
    let [machine, _] = at(values[0])?;
    let (names, k) = (names(&machine), task.harmonic);
    let is_linear = !machine.is_smooth() && job.system().map_or(true, |system| system.cubic == 0.0);
    let ends = [values[0], values[values.len() / 2], values[values.len() - 1]];
    let is_frequency = resonance::is_frequency(&at, ends)?;
    let backbone = match task.backbone {
        true if machine.size == 1 && machine.points() == 1 => {
            backbone(task, job, &values, &|value| Ok((at(value)?[0].clone(), engine.cubic(&family, value)?)))?
        }
        true => {
            let (own, ends) = (|value: f64| at(value).map(|[machine, _]| machine), [ends[0], ends[2]]);
            of_several(task, job, &names[..machine.points()], ends, is_frequency, &own)?
        }
        false => Backbone::default(),
    };
    // Without a drive there is nothing but the free machine.
    let linear = if machine.is_driven() { &values[..] } else { &[] };
    let (mut rows, mut resonant, mut floating) = (Vec::new(), Vec::new(), Vec::new());
    job.monitor.begin(values.len() as u64, "values, linear");
    for &value in linear {
        match FreeResponse::at(&at, value)? {
            Some(free) => {
                floating.extend(free.floats().then_some(value));
                rows.extend(linear_rows(value, &free, &names, &machine, k));
            }
            None => resonant.push(value),
        }
        job.monitor.advance(1)?;
    }
    let (peaks, all_peaks) = match linear.is_empty() {
        true => (Vec::new(), true),
        false => peaks(&at, &values, k, &mut || job.check())?,
    };
    let peaks = peaks.into_iter().map(|peak| PeakRow::new(peak, &names, is_frequency)).collect();
    let contact = contacts(&rows);
    let found = ResponseFindings {
        parameter: task.parameter.clone(),
        is_frequency,
        harmonic: k,
        values: values.len(),
        peaks,
        contact,
        resonant,
        floating,
        highest: None,
        backbone: backbone.rows,
        backbone_ends: backbone.ends,
        sweep: None,
        unstable: None,
        not_settled: Vec::new(),
        rows,
        all_peaks,
        open: Vec::new(),
        no_backbone: backbone.why,
    };
    let clear = found.contact.is_empty() && (found.floating.is_empty() || machine.stops.is_empty());
    let same = is_linear && machine.friction.is_empty() && clear;
    match task.seen.unwrap_or(!same) && !linear.is_empty() {
        true => followed(task, job, engine, (&names, is_linear && machine.stops.is_empty()), found),
        false => Ok(found),
    }
}

/// Adds what is seen up and down. Where only friction bounds what resonates without damping, a motion that is
/// not periodic grows: there it has no swing.
fn followed<E: Engine>(
    task: &ResponseTask,
    job: &Job,
    engine: &E,
    (names, grows): (&[String], bool),
    found: ResponseFindings,
) -> Result<ResponseFindings> {
    let diagram = as_diagram(task);
    let ways = ways(task.count, task.sweep);
    let (steps, sweep, _) = sweep_steps(&diagram, job, engine, &ways)?;
    let states = engine.states(&diagram.starts)?;
    let (mut rows, mut not_settled) = (Vec::new(), Vec::new());
    job.monitor.begin(steps.len() as u64, "values, swings");
    for (step, &(up, _)) in steps.iter().zip(&ways) {
        job.monitor.advance(1)?;
        let Some(settled) = &step.settled else { continue };
        let portrait = &settled.portrait;
        let grows = grows && portrait.period.is_none() && found.resonant.contains(&step.value);
        if portrait.undecided || grows {
            not_settled.push(step.value);
        }
        if portrait.undecided || grows {
            continue;
        }
        let (change, round) = ((task.parameter.as_str(), step.value), [portrait.looked, task.harmonic]);
        if let Some(swings) = engine.swings(&states, change, &settled.start, round)? {
            let impacts = portrait.period.map(|_| portrait.impacts);
            let orbit = (way(up), step.value, portrait.period, impacts, None);
            rows.extend(seen_rows(orbit, &swings, names));
        }
    }
    let on: Vec<_> = ways.iter().map(|&(up, _)| up).zip(&steps).collect();
    let highest = Some(highest((task, names, &rows), job, (engine, &states), &on, &sweep)?);
    let range = (value(&task.range, 0, task.count), value(&task.range, task.count - 1, task.count));
    let Unstable { rows: unstable, orbits, open } = match task.unstable {
        true => unstable((task, range), job, engine, &on, &sweep)?,
        false => Unstable::default(),
    };
    job.monitor.begin(orbits.len() as u64, "unstable orbits, swings");
    for UnstableOrbit { stretch, value, period, impacts, start } in orbits {
        job.monitor.advance(1)?;
        let change = (task.parameter.as_str(), value);
        if let Some(swings) = engine.swings(&states, change, &start, [period, task.harmonic])? {
            let orbit = ("unstable", value, Some(period), Some(impacts), Some(stretch));
            rows.extend(seen_rows(orbit, &swings, names));
        }
    }
    let rows = found.rows.into_iter().chain(rows).collect();
    let (sweep, unstable) = (Some(sweep), task.unstable.then_some(unstable));
    Ok(ResponseFindings { highest, sweep, unstable, open, not_settled, rows, ..found })
}

/// What follows the motions.
fn as_diagram(task: &ResponseTask) -> DiagramTask {
    let ResponseTask { parameter, range, count, sweep, start, .. } = task.clone();
    let ResponseTask { transient, points, longest, resume, .. } = *task;
    DiagramTask {
        parameter,
        range,
        count,
        starts: vec![start],
        sweep: Some(sweep),
        prove: false,
        phase: num_traits::Zero::zero(),
        frame: Frame::Fixed,
        plane: Vec::new(),
        transient,
        points,
        longest,
        every: 1,
        branches: Vec::new(),
        options: Options::default(),
        resume,
    }
}

/// What the displacements are called: coordinates, then gaps.
fn names(machine: &Machine<f64>) -> Vec<String> {
    let alone = machine.points() == 1;
    let coordinate = |i: usize| if alone { "q".to_string() } else { format!("q{i}") };
    let gaps = machine.stops.iter().map(|stop| format!("gap {}", stop.name));
    (1..=machine.points()).map(coordinate).chain(gaps).collect()
}

/// Amplitude and lag of a harmonic, beside displacements of this size.
fn polar([a, b]: [f64; 2], size: f64) -> (f64, Option<f64>) {
    let amplitude = a.hypot(b);
    let lag = (b.atan2(a) / TAU).rem_euclid(1.0);
    (amplitude, (amplitude > SUM * size).then_some(if lag < 1.0 { lag } else { 0.0 }))
}

pub(super) fn half([low, high]: [f64; 2]) -> f64 {
    (high - low) / 2.0
}

fn linear_rows(
    value: f64,
    free: &FreeResponse,
    names: &[String],
    machine: &Machine<f64>,
    k: u32,
) -> Vec<ResponseRow> {
    let (extents, harmonics) = (free.extents(), free.harmonics(k));
    let size = extents.iter().map(|extent| half(*extent)).fold(0.0, f64::max);
    let gaps = extents[free.points()..].iter().filter(|_| !free.floats());
    let met = gaps.zip(&machine.stops).filter(|(gap, _)| gap[0] <= 0.0);
    let stop = met.min_by(|a, b| a.0[0].total_cmp(&b.0[0])).map(|(_, stop)| stop.name.clone());
    let row = |(name, (extent, harmonic)): (&String, (&[f64; 2], [f64; 2]))| {
        let (amplitude, lag) = polar(harmonic, size);
        ResponseRow {
            way: "linear",
            value,
            coordinate: name.clone(),
            swing: half(*extent),
            amplitude,
            lag,
            period: Some(1),
            impacts: Some(0),
            stop: stop.clone(),
            stretch: None,
        }
    };
    names.iter().zip(extents.iter().zip(harmonics)).map(row).collect()
}

/// The rows of a motion: which way it is seen, at which value, its period and impacts, its stretch.
fn seen_rows(
    (way, value, period, impacts, stretch): (&'static str, f64, Option<u32>, Option<u64>, Option<usize>),
    swings: &[Swing],
    names: &[String],
) -> Vec<ResponseRow> {
    let size = swings.iter().map(|swing| half(swing.extent)).fold(0.0, f64::max);
    let row = |(name, swing): (&String, &Swing)| {
        let (amplitude, lag) = polar(swing.harmonic, size);
        let (swing, coordinate) = (half(swing.extent), name.clone());
        ResponseRow { way, value, coordinate, swing, amplitude, lag, period, impacts, stop: None, stretch }
    };
    names.iter().zip(swings).map(row).collect()
}

impl PeakRow {
    fn new(peak: Peak, names: &[String], is_frequency: bool) -> PeakRow {
        let Peak { place, value, harmonic, half, mode } = peak;
        let polar = harmonic.map(|harmonic| polar(harmonic, 0.0));
        let [lower, upper] = [0, 1].map(|i| half.ok().map(|ends| ends[i]));
        let ratio = |[from, to]: [f64; 2]| (to - from) * (to + from) / (4.0 * value * value);
        PeakRow {
            coordinate: names[place].clone(),
            value,
            amplitude: polar.map(|polar| polar.0),
            lag: polar.and_then(|polar| polar.1),
            lower,
            upper,
            half_power_ratio: half.ok().filter(|_| is_frequency).map(ratio),
            damping_ratio: mode.map(|[_, ratio]| ratio),
            open: half.err(),
        }
    }
}

/// Where the linear response reaches each stop, in the order of values.
fn contacts(rows: &[ResponseRow]) -> Vec<ContactRow> {
    let mut found: Vec<ContactRow> = Vec::new();
    let mut before: Option<&ResponseRow> = None;
    for row in rows.iter().filter(|row| row.coordinate == rows[0].coordinate) {
        if let Some(stop) = &row.stop {
            let goes_on = before.is_some_and(|before| before.stop.as_ref() == Some(stop));
            match found.last_mut().filter(|_| goes_on) {
                Some(last) => (last.to, last.values) = (row.value, last.values + 1),
                None => {
                    found.push(ContactRow { from: row.value, to: row.value, stop: stop.clone(), values: 1 })
                }
            }
        }
        before = Some(row);
    }
    found
}
