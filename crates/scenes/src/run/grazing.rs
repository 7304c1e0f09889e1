//! Tasks of kind `grazing`: a grazing bifurcation, and what is born there.

use std::f64::consts::TAU;

use num_rational::BigRational;
use num_traits::ToPrimitive;
use serde::Serialize;

use super::{
    Analysed, AttractorProofs, BandRow, ChaosRow, Complex, Finding, Job, Judgement, Lines, Status, bands,
    birth::all_patterns,
    engine::{Engine, GrazingPoint, by_engine},
    hit::{HitRow, hits},
    influence::{InfluenceRow, influences},
    range::{RangeRow, SideRange, WantedProofs},
    row,
    seen::{self, SeenRow},
    sentence::Sentence,
    told,
    tolerance::{self, ToleranceReport},
};
use crate::{
    attractor::diagram::Look,
    continuation::LocalMap,
    error::{Error, Result},
    many::grazing::LinearTouch,
    pattern::{Pattern, PatternExistence, Patterns, Report as Verdict},
    scene::{
        Body,
        orbits::{GrazingTask, RangeKeys},
    },
    search::{range::RangeEffort, touch::InTheory as _},
};

row! {
    /// What the local theory says of an impact pattern, and the orbit of the true system near by, if it was
    /// looked for and found.
    pub struct BornRow {
        /// The pattern, in periods of the orbit that grazes.
        pub pattern: String,
        /// On which side of the bifurcation an orbit is born, or what is open.
        pub side: String,
        /// L: the large multiplier of one round of the pattern is L µ^{−m} to leading order, µ the parameter
        /// less its value at grazing.
        pub coefficient: Option<f64>,
        /// The parameter at which the orbit was looked for.
        pub found_at: Option<f64>,
        /// The phases of its impacts, as fractions of the period.
        pub phases: Option<Vec<f64>>,
        /// Their incoming relative speeds, in the scene's units.
        pub speeds: Option<Vec<f64>>,
        /// Its multipliers of largest modulus, at most four, the largest first.
        pub multipliers: Option<Vec<Complex>>,
        /// Whether it is stable: what is born at a grazing is mostly not, so not seen.
        pub stable: Option<Judgement>,
        /// Whether it is an orbit.
        pub admissible: Option<Judgement>,
        /// Why it is none, or why nothing is decided.
        pub reason: Option<String>,
    }
}

row! {
    /// A touch of the motion without impacts.
    pub struct TouchRow {
        /// The parameter.
        pub parameter: f64,
        /// The stop.
        pub stop: String,
        /// The phase, as a fraction of the period.
        pub phase: f64,
        /// How fast the gap opens with the parameter.
        pub e: f64,
        /// The gap there, which rounding leaves.
        pub gap: f64,
    }
}

impl TouchRow {
    fn of(touch: &LinearTouch) -> TouchRow {
        let LinearTouch { parameter, at, rate, stop, .. } = touch;
        let phase = at.phase / TAU;
        TouchRow { parameter: *parameter, stop: stop.clone(), phase, e: *rate, gap: at.gap }
    }
}

/// What a search for a grazing came to.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum GrazingFindings {
    /// One was found.
    Found(Box<GrazingReport>),
    /// None within reach, or no orbit to begin with.
    Nothing {
        /// The parameter.
        varied: String,
        /// Its value at the start.
        start: f64,
        /// Why.
        #[serde(skip)]
        reason: String,
    },
}

impl Finding for GrazingFindings {
    fn status(&self) -> Status {
        match self {
            GrazingFindings::Found(found) => found.status(),
            GrazingFindings::Nothing { reason, .. } => Status::nothing(reason.clone()),
        }
    }

    fn lines(&self, lines: &mut Lines) {
        match self {
            GrazingFindings::Found(found) => found.lines(lines),
            GrazingFindings::Nothing { varied, start, .. } => {
                lines.say("start", format!("{varied} = {}", lines.told("start", *start)));
            }
        }
    }
}

/// A local map in the scene's coordinates (q, q̇) less those of the orbit that grazes, per unit of time.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MapNumbers {
    /// a_G: the second derivative of the gap there.
    pub acceleration: f64,
    /// A, by rows.
    #[serde(rename = "A")]
    pub a: Vec<Vec<f64>>,
    /// B.
    #[serde(rename = "B")]
    pub b: Vec<f64>,
    /// C.
    #[serde(rename = "C")]
    pub c: Vec<f64>,
    /// e: how fast the least gap opens with the parameter.
    pub e: f64,
    /// The eigenvalues of A, the largest modulus first.
    pub eigenvalues: Vec<Complex>,
    /// a₁ = tr A; only of one degree of freedom.
    pub a1: Option<f64>,
    /// a₂ = det A; only of one degree of freedom.
    pub a2: Option<f64>,
    /// γ; only of one degree of freedom.
    pub gamma: Option<f64>,
    /// The region of the plane of (a₁, a₂), 1 to 5 or `line`; only of one degree of freedom, and for a₂ > 0.
    pub region: Option<String>,
    /// Where the map is in the picture of what is born and seen, if its eigenvalues are complex: across, of
    /// the motion without impacts the frequency of the free vibration over that of the forcing, without its
    /// whole part.
    pub ratio: Option<f64>,
    /// Up: what is left of a free vibration after a period.
    pub remains: Option<f64>,
}

/// A grazing bifurcation with its local map: of an orbit of an oscillator, of the motion without impacts of a
/// machine.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GrazingMap {
    /// The parameter.
    pub varied: String,
    /// Its value at grazing.
    pub parameter: f64,
    /// The pattern of the orbit that grazes, where it is one with impacts or may be.
    pub orbit: Option<String>,
    /// The stop that is grazed.
    pub stop: String,
    /// t_G, as a fraction of the period.
    pub phase: f64,
    /// The local map there.
    #[serde(flatten)]
    pub map: MapNumbers,
    /// Whether the orbit is one but for the tangency.
    pub admissible: Judgement,
    /// What is left of the equations, of a machine of the gap.
    pub residual: f64,
    /// Whether the map is of half a period, followed by the mirror: the motion is symmetric and grazes a stop
    /// and its mirror. Patterns count halves then, and the stops alternate with them; A and what follows from
    /// it are that map's.
    pub half: bool,
    /// Why the local theory does not apply, if it does not.
    pub open: Option<String>,
}

/// A grazing bifurcation, and the patterns that are born there.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GrazingReport {
    /// What happens, in sentences, each with a mark.
    pub sentences: Vec<Sentence>,
    /// The same without marks.
    pub in_words: String,
    /// The bifurcation.
    #[serde(flatten)]
    pub at: GrazingMap,
    /// All touches within the values that were asked for, the nearest first.
    pub touches: Option<Vec<TouchRow>>,
    /// Whether chaos is born, on either side, by all patterns together; absent where no word decides.
    pub chaos: Option<Vec<ChaosRow>>,
    /// Why it is not decided whether chaos is born.
    pub chaos_open: Option<String>,
    /// The patterns that are born or open.
    pub born: Vec<BornRow>,
    /// What attracts beside the touch; absent if it was not looked for.
    pub seen: Option<Vec<SeenRow>>,
    /// Why it was not.
    pub seen_open: Option<&'static str>,
    /// What motions do over the parameter; absent if nothing was looked for, and where another orbit than the
    /// motion without impacts touches.
    pub bands: Option<Vec<BandRow>>,
    /// How hard what is seen hits; absent if nothing was looked for.
    pub hits: Option<Vec<HitRow>>,
    /// By how much parameters move the touch; absent if it was not asked for.
    pub influence: Option<Vec<InfluenceRow>>,
    /// What is proved of it, if that was asked for.
    pub proofs: Option<AttractorProofs>,
    /// How far from the touch what is born is proved to go on; absent if it was not asked for.
    pub range: Option<Vec<RangeRow>>,
    /// Why no range was looked for, though it was asked for.
    pub range_open: Option<String>,
    /// What is born of all machines that the task's tolerances allow; absent if it has none.
    pub tolerance: Option<ToleranceReport>,
    /// Why that is not told, though there are tolerances.
    pub tolerance_open: Option<String>,
    /// The certificates of ranges: file and text.
    #[serde(skip)]
    pub certificates: Vec<(String, String)>,
    /// How many of them are open.
    #[serde(skip)]
    undecided: usize,
}

/// How attractors beside a touch are looked at; the phase is half a period from the touch.
const LOOK: Look = Look { phase: 0.0, transient: 500, points: 64, longest: 64 };

/// Multipliers closer than this to the unit circle are on it.
const MARGIN: f64 = 1e-9;

/// A matrix of more rows than this is not shown in text.
const SHOWN: usize = 6;

impl MapNumbers {
    /// Those of a map whose velocities are per radian of the forcing, `rate` of which are a unit of time.
    pub(super) fn of(map: &LocalMap, rate: f64) -> MapNumbers {
        let one = map.gamma().is_some();
        let unit = |i: usize| if i < map.b.len() / 2 { 1.0 } else { rate };
        let row = |(i, row): (usize, &Vec<f64>)| {
            row.iter().enumerate().map(|(j, x)| x * unit(i) / unit(j)).collect::<Vec<f64>>()
        };
        let (trace, gamma) = (map.trace(), map.gamma().map(|gamma| gamma / rate));
        let place = gamma.map(|gamma| MapNumbers::in_picture(trace, map.determinant, gamma));
        let [ratio, remains] = place.unwrap_or_default();
        MapNumbers {
            acceleration: map.acceleration * rate * rate,
            a: map.a.iter().enumerate().map(row).collect(),
            b: map.b.iter().enumerate().map(|(i, x)| x * unit(i)).collect(),
            c: map.c.clone(),
            e: map.e,
            eigenvalues: map.eigenvalues.iter().map(|&x| Complex::from(x)).collect(),
            a1: one.then_some(trace),
            a2: one.then_some(map.determinant),
            gamma,
            region: map.region().map(|region| region.to_string()),
            ratio,
            remains,
        }
    }

    /// The place of (a₁, a₂, sign γ) in the picture: a₁ = 2r cos 2πs, a₂ = r², and s or 1 − s across.
    fn in_picture(a1: f64, a2: f64, gamma: f64) -> [Option<f64>; 2] {
        let r = a2.sqrt();
        let cosine = a1 / (2.0 * r);
        if !(cosine.abs() < 1.0 && gamma.abs() > 0.0) {
            return [None, None];
        }
        let s = cosine.acos() / TAU;
        [Some(if gamma > 0.0 { s } else { 1.0 - s }), Some(r)]
    }
}

impl MapNumbers {
    /// The numbers, each with what it is.
    fn lines(&self, varied: &str, residual: f64, lines: &mut Lines) {
        lines.say("local_map", "(q, q') less the orbit's at the touch, after a period");
        // Large ones are in JSON.
        if self.b.len() <= SHOWN {
            self.a.iter().for_each(|row| lines.say("A", row.clone()));
            lines.say("B", format!("{}: added by an impact of size 1", lines.set(self.b.clone())));
            lines.say("C", format!("{}: the gap, by (q, q')", lines.set(self.c.clone())));
        }
        lines.say("e", format!("{}: the least gap, per {varied}", lines.set(self.e)));
        lines.say("acceleration", format!("{}: of the gap at the touch", lines.set(self.acceleration)));
        lines.say("eigenvalues", self.eigenvalues.iter().take(SHOWN).copied().collect::<Vec<_>>());
        if self.eigenvalues.len() > SHOWN {
            lines.say("more_eigenvalues", self.eigenvalues.len() - SHOWN);
        }
        if let (Some(a1), Some(a2)) = (self.a1, self.a2) {
            lines.say("a1", format!("{}: trace of A", lines.set(a1)));
            lines.say("a2", format!("{}: determinant of A", lines.set(a2)));
            lines.say("region", self.region.as_deref().unwrap_or("none"));
        }
        if let Some(gamma) = self.gamma {
            lines.say("gamma", format!("{}: A12", lines.set(gamma)));
        }
        if let (Some(ratio), Some(remains)) = (self.ratio, self.remains) {
            let of = "free over forcing frequency, without its whole part";
            lines.say("ratio", format!("{}: {of}", lines.set(ratio)));
            lines.say("remains", format!("{}: of a free vibration after a period", lines.set(remains)));
        }
        lines.say("residual", residual);
    }
}

impl GrazingReport {
    /// How what was asked of ranges ended: undecided where something is born on a side, and no range is
    /// proved there. What else was not proved there is told in its own row.
    fn range_status(&self) -> Status {
        let rows = self.range.as_deref().unwrap_or_default();
        let is_proved = |side| rows.iter().any(|row| row.side == side && row.is_proved());
        let undecided = rows.iter().find(|row| row.is_undecided() && !is_proved(row.side));
        match (&self.range_open, undecided) {
            (Some(why), _) => Status::undecided(format!("no range is proved: {why}")),
            (None, Some(RangeRow { side, reason, .. })) => Status::undecided(format!(
                "{side} the touch no range is proved: {}",
                reason.as_deref().unwrap_or_default()
            )),
            (None, None) => Status::Done,
        }
    }

    /// How what was asked of tolerances ended.
    fn tolerance_status(&self) -> Status {
        match &self.tolerance_open {
            Some(why) => Status::undecided(format!("nothing is told of the tolerances: {why}")),
            None => self.tolerance.as_ref().map_or(Status::Done, ToleranceReport::status),
        }
    }

    fn status(&self) -> Status {
        match (&self.at.open, self.undecided) {
            (Some(reason), _) => Status::undecided(reason.clone()),
            (None, 0) if self.at.admissible == Judgement::No => {
                Status::undecided("the orbit that grazes is not one: what is born there is not decided")
            }
            (None, 0) => {
                let proofs = self.proofs.as_ref().map_or(Status::Done, AttractorProofs::status);
                let all = [proofs, self.range_status(), self.tolerance_status()];
                all.into_iter().find(|status| *status != Status::Done).unwrap_or(Status::Done)
            }
            (None, open) => Status::undecided(format!("{open} patterns are open; the table has the reasons")),
        }
    }

    fn lines(&self, lines: &mut Lines) {
        let at = &self.at;
        Sentence::lines(&self.sentences, lines);
        lines.say("grazing", format!("{} = {}", at.varied, lines.told("parameter", at.parameter)));
        lines.say_known("orbit", &at.orbit);
        lines.say("stop", at.stop.as_str());
        if at.half {
            lines.say("map", HALF);
        }
        lines.say("phase", format!("{} of the period", lines.set(at.phase)));
        lines.say("admissible", at.admissible);
        lines.say_known("open", &at.open);
        if let Some(rows) = &self.touches {
            lines.table("touches", rows);
        }
        if let Some(rows) = &self.chaos {
            lines.say("chaos", ChaosRow::sentences(rows, at.half, lines));
        }
        if let Some(reason) = &self.chaos_open {
            lines.say("chaos", format!("not decided: {reason}"));
        }
        let rows = self.range.as_deref().unwrap_or_default();
        for alike in rows.chunk_by(RangeRow::is_told_with) {
            RangeRow::lines(alike, (&at.varied, at.half), lines);
        }
        if let Some(why) = &self.range_open {
            lines.say("range", format!("none: {why}"));
        }
        if let Some(tolerance) = &self.tolerance {
            tolerance.lines(lines);
        }
        if let Some(why) = &self.tolerance_open {
            lines.say("tolerance", format!("none: {why}"));
        }
        lines.table("born", &self.born);
        if let Some(rows) = &self.seen {
            lines.table("seen", rows);
        }
        if let Some(why) = self.seen_open {
            lines.say("seen", format!("not looked for: {why}"));
        }
        if let Some(rows) = &self.bands {
            lines.table("bands", rows);
        }
        if let Some(rows) = self.hits.as_ref().filter(|rows| !rows.is_empty()) {
            lines.table("hits", rows);
        }
        if let Some(rows) = &self.influence {
            lines.table("influence", rows);
        }
        if let Some(proofs) = &self.proofs {
            // Bounds in a proof have all their digits, and so what follows.
            at.map.lines(&at.varied, at.residual, lines);
            return proofs.lines(lines);
        }
        at.map.lines(&at.varied, at.residual, lines);
    }
}

/// What is said of a map of half a period.
const HALF: &str =
    "of half a period, then the mirror: a stop and its mirror are grazed; patterns count halves";

/// Why nothing further is looked for.
const NO_THEORY: &str = "the local theory does not apply";
const NEVER_OPENS: &str = "no change of the parameter opens the gap";

/// What the word theorem needs.
const NEEDS: &str = "that needs a2 > 0 and gamma, e other than 0";

/// Follows the branch of the orbit to the nearest grazing, of a machine the motion without impacts, and asks
/// the local theory there.
///
/// # Errors
/// Those of the orbit's search, of the branch and of the local theory; an interruption.
pub fn grazing(task: &GrazingTask, job: &Job) -> Result<GrazingFindings> {
    let value = &job.scene.parameters[job.scene.parameter(&task.parameter)?].1;
    let given = value.to_f64().unwrap_or(f64::NAN);
    match by_engine!(job, engine => of(task, job, &engine, given))? {
        Reached::Whole(found) => Ok(found),
        Reached::Far(touch) => {
            let there = job.with(&[(task.parameter.clone(), touch)])?;
            match by_engine!(&there, engine => of(task, &there, &engine, given))? {
                Reached::Whole(found) => Ok(found),
                Reached::Far(_) => Err(Error::input("the touch is found at another value from beside it")),
            }
        }
    }
}

/// What a task came to.
enum Reached {
    /// All.
    Whole(GrazingFindings),
    /// The touch, which is so far below the scene's own value that what is small there is not small here:
    /// motions are to be followed with the scene's value there.
    Far(BigRational),
}

fn of<E: Engine>(task: &GrazingTask, job: &Job, engine: &E, given: f64) -> Result<Reached> {
    let family = engine.family(&task.parameter)?;
    let point = match engine.grazing(task, &family)? {
        Ok(point) => point,
        Err(reason) => {
            let (varied, start) = (task.parameter.clone(), E::value(&family));
            return Ok(Reached::Whole(GrazingFindings::Nothing { varied, start, reason }));
        }
    };
    let far = |touch: &&LinearTouch| (E::value(&family) / touch.parameter).abs() > told::FAR;
    let touch = point.touches().first().filter(far).map(|touch| touch.parameter);
    if let Some(touch) = touch.filter(|touch| *touch != 0.0).and_then(BigRational::from_float) {
        return Ok(Reached::Far(touch));
    }
    let (at, mut born, mut undecided) = (point.report(), Vec::new(), 0);
    let (mut chaos, mut chaos_open) = (None, None);
    if at.open.is_none() {
        let (map, size) = (point.local().to_map()?, point.size()?);
        (chaos, chaos_open) = asked_for_chaos(task, job, (&point, size), &at)?;
        let theory = point.theory(&map)?;
        let patterns = (1..=task.max_period).flat_map(|period| Patterns::of_period(period.into()));
        for pattern in patterns.filter(Pattern::is_primitive) {
            job.check()?;
            let verdict = theory(pattern.periods());
            if verdict.side().is_some() || verdict.is_open() {
                born.push(born_at(task, (&point, size), &at, &pattern, &verdict)?);
            }
            undecided += usize::from(verdict.is_open());
        }
    }
    let seen_open = not_seen(task, job, &at);
    let seen = seen_open.is_none().then(|| point.seen(at.map.e, &LOOK)).transpose()?;
    let hits = seen.as_ref().map(|seen| hits(seen, task, job, engine)).transpose()?;
    let unit = if at.map.e == 0.0 { at.parameter.abs() } else { point.size()? / at.map.e.abs() };
    let influence = task.sensitivity.then(|| influences(task, job, &at, unit)).transpose()?;
    let proofs = seen.as_ref().filter(|_| task.prove);
    let proofs = proofs.map(|seen| seen::proofs(seen, task, job, engine)).transpose()?;
    let (range, range_open, certificates) = asked_for_ranges(task, job, &point, &at)?;
    let (tolerance, tolerance_open) = asked_for_tolerances(task, job, &point, &at)?;
    let of_gap = matches!(job.scene.body, Body::Machine(_));
    let bands = seen.as_ref().and_then(|seen| bands::rows(&at, seen));
    let seen = seen.as_ref().map(|seen| seen::rows(seen, of_gap));
    let units = (job.scene.units, job.scene.turns);
    let sentences = told::sentences(
        &at,
        (job.model.period(), units, job.scene.unit(&at.varied), given),
        (seen.as_deref().unwrap_or_default(), bands.as_deref().unwrap_or_default()),
        hits.as_deref().unwrap_or_default(),
        influence.as_deref().unwrap_or_default(),
    );
    let touches = task.within().map(|_| point.touches().iter().map(TouchRow::of).collect());
    Ok(Reached::Whole(GrazingFindings::Found(Box::new(GrazingReport {
        in_words: sentences.iter().map(|sentence| &*sentence.text).collect::<Vec<_>>().join(" "),
        sentences,
        at,
        touches,
        chaos,
        chaos_open,
        born,
        seen,
        seen_open,
        bands,
        hits,
        influence,
        proofs,
        range,
        range_open,
        tolerance,
        tolerance_open,
        certificates,
        undecided,
    }))))
}

/// Why what attracts beside the touch is not looked for.
fn not_seen(task: &GrazingTask, job: &Job, at: &GrazingMap) -> Option<&'static str> {
    let attracts = at.map.eigenvalues.iter().all(|&Complex(re, im)| re.hypot(im) < 1.0 - MARGIN);
    match task.seen {
        Some(false) => Some("it is not asked for"),
        None if !job.is_linear() => {
            Some("a force is a formula or a stop gives way, which takes long: `seen = true` asks for it")
        }
        _ if at.open.is_some() => Some(NO_THEORY),
        _ if at.map.e == 0.0 => Some(NEVER_OPENS),
        _ if !attracts => Some("the motion that touches does not attract, even before the touch"),
        _ => None,
    }
}

/// What is proved of both sides, or why nothing was looked for, and the certificates: file and text.
type Ranges = (Option<Vec<RangeRow>>, Option<String>, Vec<(String, String)>);

/// How far what is born is proved to go on, if that is asked for.
fn asked_for_ranges(
    task: &GrazingTask,
    job: &Job,
    point: &impl GrazingPoint,
    at: &GrazingMap,
) -> Result<Ranges> {
    let effort = |keys: &RangeKeys| keys.effort.map_or_else(RangeEffort::default, RangeEffort);
    let wanted = WantedProofs { range: task.range.0.as_ref().map(effort), attractor: task.attractor };
    if wanted.is_nothing() {
        return Ok((None, None, Vec::new()));
    }
    let sides = match &at.open {
        Some(_) => Err(NO_THEORY.to_string()),
        None if at.map.e == 0.0 => Err(NEVER_OPENS.to_string()),
        None => point.ranges(wanted)?,
    };
    let mut certificates = Vec::new();
    // Those that follow the first of a row are counted side by side of the touch.
    let mut further = [1; 2];
    let keep = |SideRange { mut row, texts }| {
        for (i, text) in texts.into_iter().enumerate() {
            let ending = match i {
                0 => row.ending(),
                _ => {
                    let count = &mut further[usize::from(row.is_beyond())];
                    *count += 1;
                    format!("{}-cell-{count}", row.side)
                }
            };
            let file = format!("{}-{ending}.certificate", job.task.name);
            if i == 0 {
                row.certificate = Some(file.clone());
            }
            if let Some(cell) = row.cells.get_mut(i) {
                cell.certificate = Some(file.clone());
            }
            certificates.push((file, text));
        }
        row
    };
    Ok(match sides {
        Ok(sides) => (Some(sides.into_iter().map(keep).collect()), None, certificates),
        Err(why) => (None, Some(why), certificates),
    })
}

/// What is born of all machines within the tolerances, or why that is not told.
fn asked_for_tolerances(
    task: &GrazingTask,
    job: &Job,
    point: &impl GrazingPoint,
    at: &GrazingMap,
) -> Result<(Option<ToleranceReport>, Option<String>)> {
    if task.tolerance.0.is_empty() {
        return Ok((None, None));
    }
    let machines = match &at.open {
        Some(_) => Err(NO_THEORY.to_string()),
        None => point.tolerated()?,
    };
    Ok(match machines {
        Ok(machines) => (Some(tolerance::told(&machines, job.monitor)?), None),
        Err(why) => (None, Some(why)),
    })
}

/// Whether chaos is born, or why that is not decided.
fn asked_for_chaos(
    task: &GrazingTask,
    job: &Job,
    (point, size): (&impl GrazingPoint, f64),
    at: &GrazingMap,
) -> Result<(Option<Vec<ChaosRow>>, Option<String>)> {
    let map = point.local();
    let Some(gamma) = map.gamma() else {
        let unit = if at.half { "half periods" } else { "periods" };
        let why = format!(
            "the local map has {} dimensions and the word theorem is for two; the table has the patterns of up to {} {unit}",
            map.a.len(),
            task.max_period
        );
        return Ok((None, Some(why)));
    };
    let side = |positive: bool| side_of(at, positive == (at.map.e > 0.0), size);
    let chaos = all_patterns([map.trace(), map.determinant, gamma, map.e], side, job.monitor)?;
    let open = chaos.is_none().then(|| NEEDS.to_string());
    Ok((chaos, open))
}

/// A side of the bifurcation.
fn side_of(at: &GrazingMap, above: bool, size: f64) -> String {
    format!("{} {} {}", at.varied, if above { '>' } else { '<' }, shown(at.parameter, size / at.map.e.abs()))
}

/// A row: what the local theory says of a pattern, and the orbit of the true system at the distance asked
/// for.
fn born_at(
    task: &GrazingTask,
    (point, size): (&impl GrazingPoint, f64),
    at: &GrazingMap,
    pattern: &Pattern,
    verdict: &Verdict,
) -> Result<BornRow> {
    let mut row = BornRow {
        pattern: pattern.to_string(),
        side: String::new(),
        coefficient: None,
        found_at: None,
        phases: None,
        speeds: None,
        multipliers: None,
        stable: None,
        admissible: None,
        reason: verdict.reason.map(|reason| reason.to_string()),
    };
    let Some(side) = verdict.side() else {
        row.side = side_open(verdict).into();
        return Ok(row);
    };
    let distance = task.distance_at(size);
    let (periods, away) = (pattern.periods(), if side { distance } else { -distance } / at.map.e);
    row.coefficient =
        point.leading(periods, verdict).map(|leading| leading / at.map.e.powi(periods.len() as i32));
    row.side = side_of(at, away > 0.0, size);
    let parameter = match beside(&at.varied, at.parameter, away) {
        Ok(parameter) => parameter,
        Err(error) => return Ok(BornRow { reason: Some(error.to_string()), ..row }),
    };
    row.found_at = Some(parameter);
    match point.orbit(periods, verdict, parameter, away)? {
        Ok(Analysed { phases, speeds, multipliers, stable, admissible, reason, .. }) => {
            row.reason = row.reason.or(reason);
            (row.phases, row.speeds, row.multipliers) = (Some(phases), Some(speeds), Some(multipliers));
            (row.stable, row.admissible) = (Some(stable), Some(admissible));
        }
        Err(error) => row.reason = Some(error.to_string()),
    }
    Ok(row)
}

/// The parameter at a distance from a grazing.
///
/// # Errors
/// A distance of which too little is left beside the parameter, rounded.
fn beside(name: &str, parameter: f64, away: f64) -> Result<f64> {
    let there = parameter + away;
    if ((there - parameter) / away - 1.0).abs() < 0.01 {
        return Ok(there);
    }
    let message = format!(
        "not looked for: in floating point {name} = {parameter:?} hardly changes by {away:e}, the task's `distance`: take a larger one"
    );
    Err(Error::input(message))
}

/// What of a pattern is open.
fn side_open(verdict: &Verdict) -> &'static str {
    match (verdict.plus, verdict.minus) {
        (PatternExistence::NoOrbit, _) => "open for e mu < 0",
        (_, PatternExistence::NoOrbit) => "open for e mu > 0",
        _ => "open",
    }
}

/// A parameter value for reading: rounding's leavings at 0 left out, of what moves the gap by the size of the
/// motion.
fn shown(value: f64, unit: f64) -> String {
    match value.abs() {
        size if unit.is_finite() && size <= 1e-14 * unit => "0".into(),
        size if (1e-3..1e9).contains(&size) => format!("{value:.6}"),
        _ => format!("{value:.6e}"),
    }
}
