//! Tasks of kind `validate`: orbits and bifurcations proved, from approximations found as the tasks `orbit`
//! and `event` do.

use std::f64::consts::TAU;

use num_rational::BigRational;
use num_traits::ToPrimitive;
use serde::Serialize;

use super::{Finding, Job, Judgement, Lines, Status, orbit::speeds, row};
use crate::{
    continuation::{Bifurcation, BranchSearch, nearest},
    error::{Error, Result},
    local::Rung,
    monitor::timed,
    number::{Ball, Precision, Real, certain_digits},
    one::{
        branch::OscillatorPatterns,
        grazing,
        orbit::{Family, Itinerary, Orbit, Oscillator, Unknowns},
    },
    scene::{SceneFamily, validate::ValidateTask},
    search::orbit::{self, Condition, ExpectedImpact, Jet, Quotient, Stability, Verdict},
};

/// The most digits shown of an enclosed number.
const DIGITS: u32 = 20;

row! {
    /// A solution, and what is proved of it.
    pub struct ProofRow {
        /// "proved", "refuted" or "undecided".
        pub verdict: &'static str,
        /// The impact pattern.
        pub pattern: String,
        /// About where the solution is: its phases and speeds, t_1, V_1, …, and last the parameter of an
        /// event.
        pub solution: Vec<f64>,
        /// Why it is not proved.
        pub reason: Option<String>,
        /// The certain digits of the parameter of an event.
        pub parameter: Option<String>,
        /// The width of its enclosure.
        pub width: Option<f64>,
        /// The least value that the certificate leaves to it, exactly.
        pub lower: Option<String>,
        /// The greatest.
        pub upper: Option<String>,
        /// The certain digits of the phases.
        pub phases: Option<Vec<String>>,
        /// Of the speeds.
        pub speeds: Option<Vec<String>>,
        /// Half the side of the box in which there is no other solution.
        pub only_within: Option<f64>,
        /// The certain digits of λ₁ + λ₂.
        pub trace: Option<String>,
        /// Of λ₁λ₂.
        pub det: Option<String>,
        /// Whether the orbit is stable; "marginal" if that is undecided.
        pub stable: Option<Judgement>,
        /// The file of its certificate.
        pub certificate: Option<String>,
        /// Why it has none.
        pub no_certificate: Option<String>,
    }
}

row! {
    /// A start from which there was nothing to prove.
    pub struct UnprovedRow {
        /// The speeds of the orbit; none if there is no orbit.
        pub speeds: Vec<f64>,
        /// Why.
        pub reason: String,
    }
}

/// What is proved of each solution.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct ValidateFindings {
    /// The bifurcation that is enclosed; absent for orbits.
    pub event: Option<&'static str>,
    /// One row for each solution.
    pub proofs: Vec<ProofRow>,
    /// Starts from which there was nothing to prove.
    pub without: Vec<UnprovedRow>,
    /// The certificates: file and text.
    #[serde(skip)]
    pub certificates: Vec<(String, String)>,
}

impl Finding for ValidateFindings {
    fn status(&self) -> Status {
        let said = |row: &ProofRow| {
            let reason = row.reason.as_deref().unwrap_or_default();
            format!("pattern {} near {:?}: {reason}", row.pattern, row.solution)
        };
        let first = |verdict: &str| self.proofs.iter().find(|row| row.verdict == verdict).map(said);
        match (first("refuted"), first("undecided")) {
            (Some(which), _) => Status::refuted(which),
            (None, Some(which)) => Status::undecided(which),
            (None, None) if !self.proofs.is_empty() => Status::Done,
            _ => Status::nothing(
                self.without.first().map_or("nothing to prove".into(), |row| row.reason.clone()),
            ),
        }
    }

    fn lines(&self, lines: &mut Lines) {
        if let Some(event) = self.event {
            lines.say("event", event);
        }
        lines.table(if self.event.is_some() { "events" } else { "orbits" }, &self.proofs);
        if !self.without.is_empty() {
            lines.table("without", &self.without);
        }
    }
}

/// Proves each orbit that is found, or the event nearest to each.
///
/// # Errors
/// Where the system is not defined; an interruption.
pub fn validate(task: &ValidateTask, job: &Job) -> Result<ValidateFindings> {
    let mut found = ValidateFindings::default();
    match (task.event, &task.parameter) {
        (Some(event), Some(parameter)) => events(task, event, parameter, job, &mut found)?,
        _ => orbits(task, job, &mut found)?,
    }
    Ok(found)
}

impl ProofRow {
    pub(super) fn of<T>(verdict: &Verdict<T>, pattern: String, solution: Vec<f64>) -> ProofRow {
        let (verdict, reason) = match verdict {
            Verdict::Proved(_) => ("proved", None),
            Verdict::Refuted(why) => ("refuted", Some(why.clone())),
            Verdict::Undecided(why) => ("undecided", Some(why.clone())),
        };
        ProofRow {
            verdict,
            pattern,
            solution,
            reason,
            parameter: None,
            width: None,
            lower: None,
            upper: None,
            phases: None,
            speeds: None,
            only_within: None,
            trace: None,
            det: None,
            stable: None,
            certificate: None,
            no_certificate: None,
        }
    }
}

impl ValidateFindings {
    /// Adds the certificate of the row that comes next.
    pub(super) fn certify(&mut self, row: &mut ProofRow, task: &str, text: String) {
        let file = format!("{task}-{}.certificate", self.proofs.len() + 1);
        row.certificate = Some(file.clone());
        self.certificates.push((file, text));
    }

    pub(super) fn nothing(&mut self, speeds: Vec<f64>, reason: String) {
        self.without.push(UnprovedRow { speeds, reason });
    }
}

/// The orbits to begin with; a row that says so where there are none.
fn starts(task: &ValidateTask, oscillator: &Oscillator, found: &mut ValidateFindings) -> Vec<Orbit> {
    match task.orbit.orbits(oscillator) {
        Ok(orbits) => {
            if orbits.is_empty() {
                found.nothing(Vec::new(), task.orbit.none());
            }
            orbits
        }
        Err(error) => {
            found.nothing(Vec::new(), error.to_string());
            Vec::new()
        }
    }
}

fn orbits(task: &ValidateTask, job: &Job, found: &mut ValidateFindings) -> Result<()> {
    let precision = Precision::new(task.bits);
    let system = job.scene.exact(&[])?;
    let oscillator = job.oscillator(job.system()?.clone())?;
    for orbit in starts(task, &oscillator, found) {
        job.check()?;
        let guess = impacts(&orbit.itinerary, &orbit.z);
        let verdict =
            timed(job.monitor, Rung::Ball(precision.bits()), || orbit::orbit(&system, &guess, &precision))?;
        let mut row = ProofRow::of(&verdict, orbit.itinerary.to_string(), orbit.z.clone());
        if let Verdict::Proved(proof) = verdict {
            row.phases = Some(all(&proof.phases));
            row.speeds = Some(all(&proof.velocities));
            row.only_within = proof.radius.to_f64();
            row.trace = digits(&proof.trace);
            row.det = digits(&proof.determinant);
            row.stable = Some(match proof.stability {
                Some(Stability::Stable) => Judgement::Yes,
                Some(Stability::Unstable) => Judgement::No,
                None => Judgement::Marginal,
            });
            match orbit::certificate(&system, &proof) {
                Ok(text) => found.certify(&mut row, &job.task.name, text),
                Err(error) => row.no_certificate = Some(error.to_string()),
            }
        }
        found.proofs.push(row);
    }
    Ok(())
}

fn events(
    task: &ValidateTask,
    event: Bifurcation,
    name: &str,
    job: &Job,
    found: &mut ValidateFindings,
) -> Result<()> {
    let precision = Precision::new(task.bits);
    let family = job.family(name)?;
    let start = family.value();
    let exact = |parameter: &Jet| {
        let values = job.scene.parameters.iter().map(|(other, value)| {
            if other == name { parameter.clone() } else { Jet::ratio(value, &precision) }
        });
        let values: Vec<Jet> = values.collect();
        job.scene.system()?.try_map(|expression| expression.evaluate(&values, &precision))
    };
    found.event = Some(event.name());
    // The family as a function of the parameter, for the certificates.
    let family_of = || {
        let values = job.scene.parameters.iter().map(|(other, value)| {
            if other == name { Quotient::parameter() } else { Quotient::ratio(value, &()) }
        });
        let values: Vec<Quotient> = values.collect();
        job.scene.system()?.try_map(|expression| expression.evaluate(&values, &()))
    };
    let mut known: Vec<BigRational> = Vec::new();
    for orbit in starts(task, &family.at(start)?, found) {
        job.check()?;
        if !orbit.admissibility.is_admissible() {
            found.nothing(speeds(&orbit), "the solution to begin with is not admissible".into());
            continue;
        }
        let (guess, parameter, condition) = match approximate(&family, event, &orbit, start, task) {
            Ok(found) => found,
            Err(error) => {
                found.nothing(speeds(&orbit), error.to_string());
                continue;
            }
        };
        let solution = guess.iter().flat_map(|impact| [impact.phase, impact.velocity]).chain([parameter]);
        let verdict = timed(job.monitor, Rung::Ball(precision.bits()), || {
            orbit::event(exact, &guess, parameter, condition, &precision)
        })?;
        let mut row = ProofRow::of(&verdict, orbit.itinerary.to_string(), solution.collect());
        if let Verdict::Proved(proof) = verdict {
            let Some((lo, hi)) = proof.parameter.exact_bounds() else {
                found.nothing(speeds(&orbit), "the parameter's enclosure is not bounded".into());
                continue;
            };
            // The same event from another orbit of its branch.
            if known.iter().any(|other| lo <= *other && *other <= hi) {
                continue;
            }
            row.parameter = digits(&proof.parameter);
            row.width = (&hi - &lo).to_f64();
            row.phases = Some(all(&proof.phases));
            row.speeds = Some(all(&proof.velocities));
            row.only_within = proof.radius.to_f64();
            match family_of().and_then(|system| orbit::event_certificate(&system, name, &proof)) {
                Ok((text, [lower, upper])) => {
                    (row.lower, row.upper) = (Some(lower), Some(upper));
                    found.certify(&mut row, &job.task.name, text);
                }
                Err(error) => row.no_certificate = Some(error.to_string()),
            }
            known.push((lo + hi) / BigRational::from_integer(2.into()));
        }
        found.proofs.push(row);
    }
    Ok(())
}

/// Impacts, parameter and condition near which the event is expected.
fn approximate(
    family: &SceneFamily,
    event: Bifurcation,
    orbit: &Orbit,
    start: f64,
    task: &ValidateTask,
) -> Result<(Vec<ExpectedImpact>, f64, Condition)> {
    let (patterns, extent) =
        (OscillatorPatterns::new(family, start)?, task.extent(&family.at(start)?, orbit));
    let found = match nearest(&patterns, event, orbit, start, extent, &task.options.checked()?)? {
        BranchSearch::Found(found) => found,
        BranchSearch::Nothing(nothing) => return Err(Error::input(nothing.to_string())),
    };
    if event == Bifurcation::Grazing {
        let found = grazing::locate(family, &found.orbit, found.parameter)?;
        // The tangency is the first of its impacts: what comes before it flies on to what comes after.
        let mut all = impacts(&found.itinerary, &found.z);
        let touch = all.remove(0);
        let Some(last) = all.last_mut() else {
            return Ok((
                all,
                found.parameter,
                Condition::Grazing { after: 0, side: touch.side, time: touch.phase },
            ));
        };
        let time = TAU * f64::from(last.periods) + touch.phase - last.phase;
        last.periods += touch.periods;
        let after = all.len() - 1;
        return Ok((all, found.parameter, Condition::Grazing { after, side: touch.side, time }));
    }
    let condition = if event == Bifurcation::Flip { Condition::Flip } else { Condition::SaddleNode };
    Ok((impacts(&found.orbit.itinerary, &found.orbit.z), found.parameter, condition))
}

/// The impacts of a solution of the pattern equations.
fn impacts(itinerary: &Itinerary, z: &[f64]) -> Vec<ExpectedImpact> {
    let Ok(unknowns) = Unknowns::new(itinerary, z) else { return Vec::new() };
    let strikes = itinerary.strikes().iter().enumerate();
    strikes
        .map(|(i, strike)| ExpectedImpact {
            side: strike.side,
            periods: strike.periods,
            phase: unknowns.phase(i),
            velocity: unknowns.speed(i),
        })
        .collect()
}

/// The certain digits of an enclosed number.
pub(super) fn digits(x: &Ball) -> Option<String> {
    let (lo, hi) = x.exact_bounds()?;
    certain_digits(&lo, &hi, DIGITS)
}

fn all(values: &[Ball]) -> Vec<String> {
    values.iter().map(|value| digits(value).unwrap_or_else(|| "?".into())).collect()
}
