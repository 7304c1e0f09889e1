//! Tasks of kind `validate`: orbits and bifurcations proved, from approximations found as the tasks `orbit`
//! and `event` do.

use serde::Serialize;

use super::{
    CertificateFile, Finding, Job, Judgement, Lines, StabilityRow, Status,
    engine::{Engine, Proof, Prover, by_engine},
    row,
};
use crate::{
    certificate::orbit::Claim,
    error::Result,
    number::{Ball, certain_digits},
    scene::validate::ValidateTask,
    search::{Accepted, orbit::Verdict},
};

/// The most digits shown of an enclosed number.
const DIGITS: u32 = 20;

row! {
    /// What is proved of an orbit, or of one at a bifurcation.
    pub struct Proved {
        /// "proved", "refuted" or "undecided".
        pub verdict: &'static str,
        /// The impact pattern; absent if there is no orbit to prove.
        pub pattern: Option<String>,
        /// Why it is not proved.
        pub reason: Option<String>,
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
        /// The file of its certificate: there is one of each that is proved.
        pub certificate: Option<String>,
    }
}

row! {
    /// A solution, and what is proved of it.
    pub struct ProofRow {
        with {
            /// What is proved.
            pub proved: Proved
        }
        /// About where the solution is: its phases and speeds, t_1, V_1, …, and last the parameter of an
        /// event; of a motion without impacts its displacements, then its velocities at phase 0.
        pub solution: Vec<f64>,
        /// The certain digits of the parameter of an event.
        pub parameter: Option<String>,
        /// The width of its enclosure.
        pub width: Option<f64>,
        /// The least value that the certificate leaves to it, exactly; of an orbit over a range the range's.
        pub lower: Option<String>,
        /// The greatest.
        pub upper: Option<String>,
        /// Over a range where the orbit is stable, part by part.
        pub stability: Vec<StabilityRow>,
        /// Why the range goes no further than this, if it is not all that was asked for.
        pub range_ends: Option<String>,
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
    /// The certificates.
    #[serde(skip)]
    pub certificates: Vec<CertificateFile>,
}

impl Finding for ValidateFindings {
    fn status(&self) -> Status {
        let said = |row: &ProofRow| {
            let text = |text: &Option<String>| text.clone().unwrap_or_default();
            let Proved { pattern, reason, .. } = &row.proved;
            format!("pattern {} near {:?}: {}", text(pattern), row.solution, text(reason))
        };
        let first = |verdict: &str| self.proofs.iter().find(|row| row.proved.verdict == verdict).map(said);
        let short = || self.proofs.iter().find_map(ProofRow::short);
        match (first("refuted"), first("undecided").or_else(short)) {
            (Some(which), _) => Status::refuted(which),
            (None, Some(which)) => Status::undecided(which),
            (None, None) if !self.proofs.is_empty() => Status::Done,
            _ => Status::nothing(
                self.without.first().map_or("nothing to prove".into(), |row| row.reason.clone()),
            ),
        }
    }

    fn lines(&self, lines: &mut Lines) {
        // Bounds are not rounded.
        lines.exact();
        if let Some(event) = self.event {
            lines.say("event", event);
        }
        lines.table(if self.event.is_some() { "events" } else { "orbits" }, &self.proofs);
        if !self.without.is_empty() {
            lines.table("without", &self.without);
        }
    }

    fn certificates(&self) -> Vec<&CertificateFile> {
        self.certificates.iter().collect()
    }
}

/// Proves each orbit that is found, or the event nearest to each.
///
/// # Errors
/// Where the system is not defined; an interruption.
pub(crate) fn validate(task: &ValidateTask, job: &Job) -> Result<ValidateFindings> {
    by_engine!(job, engine => of(task, job, &engine))
}

fn of<E: Engine>(task: &ValidateTask, job: &Job, engine: &E) -> Result<ValidateFindings> {
    let mut found = ValidateFindings::default();
    if let Some(parameter) = &task.parameter {
        match task.event {
            Some(event) => engine.prove_events(task, event, parameter, &mut found)?,
            None => engine.prove_branches(task, parameter, &mut found)?,
        }
        return Ok(found);
    }
    // What no certificate can hold is said before the search.
    let prover = match engine.prover(None, task.bits)? {
        Ok(prover) => prover,
        Err(why) => {
            found.nothing(Vec::new(), why);
            return Ok(found);
        }
    };
    for orbit in starts(task, engine, &engine.system(None)?, &mut found)? {
        job.check()?;
        let Proof { mut row, certificate } = prover.prove(&orbit)?;
        if let Some(accepted) = certificate {
            found.certify(&mut row, &job.task.name, accepted);
        }
        found.proofs.push(row);
    }
    Ok(found)
}

/// The orbits to begin with; a row that says so where there are none.
pub(super) fn starts<E: Engine>(
    task: &ValidateTask,
    engine: &E,
    system: &E::System,
    found: &mut ValidateFindings,
) -> Result<Vec<E::Orbit>> {
    match engine.orbits(&task.orbit, system) {
        Ok(all) => {
            if all.found.is_empty() {
                found.nothing(Vec::new(), task.orbit.none(&all.tally));
            }
            Ok(all.found)
        }
        Err(error) if error.is_interrupted() => Err(error),
        Err(error) => {
            found.nothing(Vec::new(), error.to_string());
            Ok(Vec::new())
        }
    }
}

impl Proved {
    /// What a verdict says by itself.
    pub(super) fn of<T>(verdict: &Verdict<T>, pattern: Option<String>) -> Proved {
        let reason = match verdict {
            Verdict::Proved(_) => None,
            Verdict::Refuted(why) | Verdict::Undecided(why) => Some(why.clone()),
        };
        Proved {
            verdict: verdict.word(),
            pattern,
            reason,
            phases: None,
            speeds: None,
            only_within: None,
            trace: None,
            det: None,
            stable: None,
            certificate: None,
        }
    }
}

impl ProofRow {
    pub(super) fn of<T>(verdict: &Verdict<T>, pattern: String, solution: Vec<f64>) -> ProofRow {
        let proved = Proved::of(verdict, Some(pattern));
        ProofRow {
            proved,
            solution,
            parameter: None,
            width: None,
            lower: None,
            upper: None,
            stability: Vec::new(),
            range_ends: None,
        }
    }

    /// That less is proved than was asked for.
    fn short(&self) -> Option<String> {
        let ProofRow { lower, upper, range_ends, .. } = self;
        let all = lower.as_ref().zip(upper.as_ref()).zip(range_ends.as_ref());
        all.map(|((lower, upper), why)| format!("proved from {lower} to {upper}, which is not all: {why}"))
    }
}

impl ValidateFindings {
    /// Adds the certificate of the row that comes next.
    pub(super) fn certify(&mut self, row: &mut ProofRow, task: &str, accepted: Accepted) {
        let file = format!("{task}-{}.certificate", self.proofs.len() + 1);
        row.proved.certificate = Some(file.clone());
        self.certificates.push(CertificateFile { file, accepted });
    }

    pub(super) fn nothing(&mut self, speeds: Vec<f64>, reason: String) {
        self.without.push(UnprovedRow { speeds, reason });
    }
}

/// What a certificate claims of multipliers, as a judgement.
pub(super) fn judged(claim: Claim) -> Judgement {
    match claim {
        Claim::Stable => Judgement::Yes,
        Claim::Unstable => Judgement::No,
        Claim::Open => Judgement::Marginal,
    }
}

/// What is enclosed as its certificate has it: what none holds is not proved.
pub(super) fn certified<T, C>(
    enclosed: Verdict<T>,
    certificate: impl FnOnce(&T) -> Result<C>,
) -> Verdict<(T, C)> {
    match enclosed {
        Verdict::Proved(found) => match certificate(&found) {
            Ok(certified) => Verdict::Proved((found, certified)),
            Err(why) => Verdict::Undecided(format!("it is enclosed, and no certificate holds it: {why}")),
        },
        Verdict::Refuted(why) => Verdict::Refuted(why),
        Verdict::Undecided(why) => Verdict::Undecided(why),
    }
}

/// The certain digits of an enclosed number.
pub(super) fn digits(x: &Ball) -> Option<String> {
    let (lo, hi) = x.exact_bounds()?;
    certain_digits(&lo, &hi, DIGITS)
}

pub(super) fn all(values: &[Ball]) -> Vec<String> {
    values.iter().map(|value| digits(value).unwrap_or_else(|| "?".into())).collect()
}
