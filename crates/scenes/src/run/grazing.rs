//! Tasks of kind `grazing`: a grazing bifurcation, and what is born there.

use std::f64::consts::TAU;

use num_rational::BigRational;
use num_traits::ToPrimitive;
use serde::Serialize;

use super::{
    CertificateFile, ChaosRow, Complex, Finding, GrazingMap, GrazingReport, Job, Lines, Status, bands,
    birth::all_patterns,
    born::{at_resonance, born_at, side_of},
    enclosed,
    engine::{Engine, GrazingPoint, by_engine},
    hit::hits,
    influence::influences,
    range::{RangeRow, SideRange, WantedProofs},
    row, seen, told,
    tolerance::{self, ToleranceReport},
};
use crate::{
    attractor::diagram::Look,
    error::{Error, Result},
    many::grazing::LinearTouch,
    motion::System,
    output::decimal_or_fraction,
    pattern::{Pattern, Patterns},
    rounding::CIRCLE,
    scene::{
        Body,
        orbits::{GrazingTask, RangeKey},
    },
    search::{range::RangeEffort, touch::InTheory as _},
};

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

    fn certificates(&self) -> Vec<&CertificateFile> {
        match self {
            GrazingFindings::Found(found) => {
                let seen = found.proofs.iter().flat_map(|proofs| &proofs.certificates);
                found.certificates.iter().chain(seen).collect()
            }
            GrazingFindings::Nothing { .. } => Vec::new(),
        }
    }
}

/// How attractors beside a touch are looked at; the phase is half a period from the touch.
const LOOK: Look = Look { phase: 0.0, transient: 500, points: 64, longest: 64 };

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
    let touch = point.touches().found.first().filter(far).map(|touch| touch.parameter);
    if let Some(touch) = touch.filter(|touch| *touch != 0.0).and_then(BigRational::from_float) {
        return Ok(Reached::Far(touch));
    }
    let (at, mut born, mut undecided) = (point.report(), Vec::new(), 0);
    let (mut chaos, mut chaos_open, mut resonant) = (None, None, None);
    if at.open.is_none() {
        let (map, size) = (point.local().to_map()?, point.size()?);
        (chaos, chaos_open) = asked_for_chaos(task, job, (&point, size), &at)?;
        let theory = point.theory(&map)?;
        let patterns = (1..=task.max_period).flat_map(|period| Patterns::of_period(period.into()));
        for pattern in patterns.filter(Pattern::is_primitive) {
            job.check()?;
            let verdict = theory(pattern.periods());
            if let (true, &[n]) = (verdict.is_open(), pattern.periods())
                && let Some(known) = point.at_resonance(n)?
            {
                if let Some(row) = at_resonance(task, (&point, size), &at, &pattern, &known)? {
                    born.push(row);
                    resonant = Some(n);
                }
                continue;
            }
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
    let (touch, touch_open) = match enclosed_touch(task, job, &point)? {
        Ok(ends) => (Some(ends), None),
        Err(why) => (None, Some(why)),
    };
    let bands = seen.as_ref().and_then(|seen| bands::rows(&at, touch.is_some(), seen, proofs.as_ref()));
    let seen = seen.as_ref().map(|seen| seen::rows(seen, of_gap));
    let units = (job.scene.units, job.scene.turns);
    let told = bands.as_deref().unwrap_or_default();
    let all_seen = seen.as_deref().unwrap_or_default();
    let bands_in_words = told::of_bands((told, all_seen), &at, job.scene.unit(&at.varied));
    let mut sentences = told::sentences(
        &at,
        (job.model.period(), units, job.scene.unit(&at.varied), given),
        (chaos.as_deref().unwrap_or_default(), all_seen),
        (told, bands_in_words.as_deref()),
        hits.as_deref().unwrap_or_default(),
    );
    let is_covered =
        |system: &System<f64>| job.is_linear() || system.lower.is_none() || system.upper.is_none();
    if job.system().is_ok_and(is_covered) && born.len() > undecided {
        sentences.splice(1..1, told::theorem(&at).into_iter().chain(resonant.map(told::resonance)));
    }
    let unit = job.scene.unit(&at.varied);
    let proved = range.iter().flatten().filter_map(|row| row.sentence((&at.varied, at.half), unit));
    sentences.extend(told::together(proved));
    sentences.extend(told::influences(influence.as_deref().unwrap_or_default(), &at, unit));
    let touches_open = point.touches().open();
    let touches = task.within().map(|_| point.touches().found.iter().map(TouchRow::of).collect());
    Ok(Reached::Whole(GrazingFindings::Found(Box::new(GrazingReport {
        in_words: sentences.iter().map(|sentence| &*sentence.text).collect::<Vec<_>>().join(" "),
        sentences,
        at,
        touch,
        touch_open,
        touches,
        touches_open,
        chaos,
        chaos_open,
        born,
        seen,
        seen_open,
        bands,
        bands_in_words,
        hits,
        influence,
        proofs,
        range,
        range_open,
        main: task.range == RangeKey::Main && !task.attractor,
        tolerance,
        tolerance_open,
        certificates,
        undecided,
    }))))
}

/// Between which values the touch is, or why it is only located.
fn enclosed_touch(
    task: &GrazingTask,
    job: &Job,
    point: &impl GrazingPoint,
) -> Result<std::result::Result<[String; 2], String>> {
    let Some(touch) = point.touches().found.first() else {
        return Ok(Err("of a linear motion without impacts touches are enclosed".into()));
    };
    let unit = point.size()? / touch.rate.abs();
    let ends = enclosed::touch(job, &task.parameter, (touch, unit))?;
    Ok(ends.map(|ends| ends.each_ref().map(decimal_or_fraction)))
}

/// Why what attracts beside the touch is not looked for.
fn not_seen(task: &GrazingTask, job: &Job, at: &GrazingMap) -> Option<&'static str> {
    let attracts = at.map.eigenvalues.iter().all(|&Complex(re, im)| re.hypot(im) < 1.0 - CIRCLE);
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

/// What is proved of both sides, or why nothing was looked for, and the certificates.
type Ranges = (Option<Vec<RangeRow>>, Option<String>, Vec<CertificateFile>);

/// Where only the main claim is proved, with one in so many of the work else allowed.
const MAIN: u64 = 10;

/// How far what is born is proved to go on, if that is asked for.
fn asked_for_ranges(
    task: &GrazingTask,
    job: &Job,
    point: &impl GrazingPoint,
    at: &GrazingMap,
) -> Result<Ranges> {
    let main = task.range == RangeKey::Main;
    let range = match &task.range {
        RangeKey::None => None,
        RangeKey::Main => {
            (task.tolerance.0.is_empty() && !task.attractor).then_some(RangeEffort::DEFAULT / MAIN)
        }
        RangeKey::All(keys) => Some(keys.effort.unwrap_or(RangeEffort::DEFAULT)),
    };
    let wanted = WantedProofs { range, main, attractor: task.attractor };
    if wanted.is_nothing() {
        return Ok((None, None, Vec::new()));
    }
    let sides = match &at.open {
        Some(_) => Err(NO_THEORY.to_string()),
        None if at.map.e == 0.0 => Err(NEVER_OPENS.to_string()),
        None => match point.ranges(wanted) {
            // As where a number has more digits than a certificate.
            Err(error) if error.is_input() => Err(error.to_string()),
            sides => sides?,
        },
    };
    // Nobody has asked for what is tried of every machine.
    if main && !task.attractor && sides.is_err() {
        return Ok((None, None, Vec::new()));
    }
    let mut certificates = Vec::new();
    // Those that follow the first of a row are counted side by side of the touch.
    let mut further = [1; 2];
    let keep = |SideRange { mut row, proofs }| {
        for (i, accepted) in proofs.into_iter().enumerate() {
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
            certificates.push(CertificateFile { file, accepted });
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
