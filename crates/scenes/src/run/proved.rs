//! Attractors that were seen, proved: the periodic ones, at the exact value of the parameter.
//!
//! What is seen is evidence. Of an attractor that is a periodic orbit the impact pattern is read off, the
//! orbit is found by Newton's method, and it is proved that it exists, and that it is stable, as by a task
//! `validate`. Not here: the proofs (`search`), what is seen (`swept`, `seen`).

use num_rational::BigRational;
use serde::{Serialize, Serializer};

use super::{
    CertificateFile, Job, Judgement, Lines, Proved, Status,
    engine::{Engine, Proof, Prover},
    row,
};
use crate::{
    attractor::{detection::Detection, diagram::Look, dynamics::Dynamics, portrait::OnAttractor},
    error::{Error, Result},
    number::{Plain, Real},
    search::orbit::Verdict,
};

/// Bits of the enclosures: as a task `validate` has them unless it says otherwise.
const BITS: u32 = 128;

row! {
    /// A periodic attractor, and what is proved of it.
    pub struct ProvedRow {
        /// Where it was seen: which way the parameter was swept, from which start, or on which side of a
        /// touch.
        pub seen: String,
        /// The value of the parameter.
        pub value: f64,
        /// What was seen.
        pub motion: String,
        with {
            /// What is proved.
            pub proved: Proved
        }
    }
}

row! {
    /// Neighbouring values at which an attractor is not proved, for one reason.
    pub struct OpenRow {
        /// Where it was seen.
        pub seen: String,
        /// The first value.
        pub from: f64,
        /// The last.
        pub to: f64,
        /// How many values.
        pub values: usize,
        /// Why.
        pub reason: String,
    }
}

/// What is proved of the attractors that a task saw.
#[derive(Debug, Clone, PartialEq)]
pub struct AttractorProofs {
    /// A row for each that is periodic.
    pub rows: Vec<ProvedRow>,
    /// How many are not periodic: nothing is claimed of them.
    pub others: usize,
    /// The certificates.
    pub certificates: Vec<CertificateFile>,
}

/// The rows alone.
impl Serialize for AttractorProofs {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        self.rows.serialize(serializer)
    }
}

/// Proves the attractors of a task, one by one.
pub(super) struct Proving<'a, E> {
    pub engine: &'a E,
    /// The task's name.
    pub task: &'a str,
    pub parameter: &'a str,
    /// How they were looked at.
    pub look: &'a Look,
}

/// A state of an engine's motions.
pub(super) type StartOf<E> = <<E as Engine>::Dynamics as Dynamics>::Start;

/// An attractor to be proved: where it was seen, the exact value of the parameter, what it is.
pub(super) type Attractor<'a, E> = (&'a str, BigRational, &'a OnAttractor<StartOf<E>>);

impl<E: Engine> Proving<'_, E> {
    /// Those that are periodic, proved.
    ///
    /// # Errors
    /// An interruption.
    pub fn all(&self, all: &[Attractor<E>], job: &Job) -> Result<AttractorProofs> {
        let (mut rows, mut certificates) = (Vec::new(), Vec::new());
        let periodic = || all.iter().filter(|(_, _, on)| on.portrait.period.is_some());
        job.monitor.begin(periodic().count() as u64, "attractors");
        for (seen, value, on) in periodic() {
            job.monitor.advance(1)?;
            let (mut proved, certificate) = match self.one(value, on) {
                Ok(Proof { row, certificate }) => (row.proved, certificate),
                Err(error) if error.is_interrupted() => return Err(error),
                Err(error) => (Proved::of(&Verdict::<()>::Undecided(error.to_string()), None), None),
            };
            if let Some(accepted) = certificate {
                let file = format!("{}-{}.certificate", self.task, certificates.len() + 1);
                proved.certificate = Some(file.clone());
                certificates.push(CertificateFile { file, accepted });
            }
            let (seen, value) = (seen.to_string(), Plain::ratio(value, &()).0);
            rows.push(ProvedRow { seen, value, motion: on.portrait.words(), proved });
        }
        let others = all.len() - rows.len();
        Ok(AttractorProofs { rows, others, certificates })
    }

    /// What is proved of one.
    ///
    /// # Errors
    /// Why there is nothing to prove; an interruption.
    fn one(&self, value: &BigRational, on: &OnAttractor<StartOf<E>>) -> Result<Proof> {
        let Proving { engine, parameter, look, .. } = *self;
        let system = engine.system(Some((parameter, Plain::ratio(value, &()).0)))?;
        let (phase, longest) = (look.phase, look.longest as usize);
        let detection = Detection { phase, transient: 0, longest, ..Detection::default() };
        let orbit = engine.attracting(&system, &on.start, &detection)?;
        engine.prover(Some((parameter, value)), BITS)?.map_err(Error::input)?.prove(&orbit)
    }
}

impl ProvedRow {
    /// Why it is not proved to be a stable orbit, if it is not.
    fn open(&self) -> Option<String> {
        let Proved { verdict, reason, stable, .. } = &self.proved;
        let stable = match stable {
            Some(Judgement::Yes) => None,
            Some(Judgement::No) => Some("the orbit that is proved is not stable".to_string()),
            _ => Some("it is not decided whether the orbit is stable".to_string()),
        };
        let unproved = || Some(format!("{verdict}: {}", reason.as_deref().unwrap_or_default()));
        if *verdict == "proved" { stable } else { unproved() }
    }
}

impl AttractorProofs {
    /// What is left open.
    pub(super) fn status(&self) -> Status {
        let all: Vec<_> = self.rows.iter().filter_map(|row| Some((row.open()?, row))).collect();
        match all.first() {
            None => Status::Done,
            Some((why, first)) => Status::undecided(format!(
                "{} of {} periodic attractors are not proved to be stable orbits; {}, at {}: {why}",
                all.len(),
                self.rows.len(),
                first.seen,
                first.value
            )),
        }
    }

    /// The values at which an orbit with impacts is proved by a certificate.
    pub(super) fn hitting(&self) -> Vec<f64> {
        let hits = |row: &&ProvedRow| {
            let Proved { verdict, pattern, certificate, .. } = &row.proved;
            let struck = pattern.as_deref().is_some_and(|pattern| !pattern.starts_with("free "));
            *verdict == "proved" && certificate.is_some() && struck
        };
        self.rows.iter().filter(hits).map(|row| row.value).collect()
    }

    pub(super) fn lines(&self, lines: &mut Lines) {
        let open = self.open_rows();
        let left: usize = open.iter().map(|row| row.values).sum();
        let (proved, all) = (self.rows.len() - left, self.rows.len());
        lines.say("proved", format!("{proved} of {all} periodic attractors are stable orbits"));
        if !open.is_empty() {
            lines.table("not_proved", &open);
        }
        if self.others > 0 {
            lines.say("no_claim", format!("{} attractors are not periodic", self.others));
        }
    }

    /// Neighbours that are open for one reason together.
    fn open_rows(&self) -> Vec<OpenRow> {
        let mut rows: Vec<OpenRow> = Vec::new();
        let mut last = None;
        for (i, row) in self.rows.iter().enumerate() {
            let Some(reason) = row.open() else { continue };
            let (seen, value) = (row.seen.clone(), row.value);
            match rows.last_mut().filter(|one| last == Some(i) && one.reason == reason && one.seen == seen) {
                Some(one) => (one.to, one.values) = (value, one.values + 1),
                None => rows.push(OpenRow { seen, from: value, to: value, values: 1, reason }),
            }
            last = Some(i + 1);
        }
        rows
    }
}
