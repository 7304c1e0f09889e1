//! Tasks of kind `chaos`: that every word over an alphabet is an orbit (a full shift or a subshift), proved,
//! or what stood in the way.

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};
use serde::Serialize;

use super::{CertificateFile, Finding, Job, Lines, Status, row};
use crate::{
    certificate::chaos::Decimal,
    error::{Error, Result},
    motion::Side,
    number::certain_digits,
    scene::chaos::{Alphabet, ChaosTask, LONGEST, Periods},
    search::chaos::{LetterGraph, Normal, Problem, ShiftProof, born, prove},
};

row! {
    /// A letter of the alphabet, with its boxes: velocities divided by ν, in units of the normal form.
    pub struct LetterRow {
        /// n, the periods; with two walls half periods.
        pub periods: u64,
        /// The letters that may follow, by their number from 1.
        pub next: Vec<u64>,
        /// Between which the velocity just after its first impact lies.
        pub after: [f64; 2],
        /// Between which the velocity just before its last impact lies.
        pub before: [f64; 2],
    }
}

row! {
    /// A graph for which no proof was found, and why.
    pub struct FailureRow {
        /// The periods of its letters, or half periods.
        pub alphabet: Vec<u64>,
        /// What failed in the last, finest attempt.
        pub reason: String,
    }
}

/// What is proved.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ChaosFindings {
    /// Whether it is.
    pub proved: bool,
    /// Whether both of two walls are met; then periods, of letters and in `growth`, are counted in halves.
    pub half: bool,
    /// The oscillator in its normal form.
    pub oscillator: String,
    /// For which parameters of the scene.
    pub range: String,
    /// For which ν.
    pub depth: [f64; 2],
    /// The periods of the alphabet.
    pub alphabet: Vec<u64>,
    /// Whether every one may follow every one.
    pub full: bool,
    /// The letters with their boxes; none if nothing is proved.
    pub letters: Vec<LetterRow>,
    /// κ.
    pub contraction: Option<f64>,
    /// Certain digits of the topological entropy per forcing period.
    pub entropy: Option<String>,
    /// The growth rate per period that it is the logarithm of; with two walls the rate per half period, of
    /// which the logarithm is half the entropy.
    pub growth: Option<String>,
    /// q/ν, with two walls |q|/ν, stays below this on all these orbits; lengths in the units of the normal
    /// form.
    pub reach: Option<f64>,
    /// q/ν where a second wall that is not met is at its nearest.
    pub ceiling: Option<f64>,
    /// S: every motion that meets a wall at arbitrarily early and late times, and only near its top where
    /// its speed, in units of the normal form, is at most νS/2, is one of these; with damping and a spring so
    /// is every bounded motion that meets it only there. None if that is not proved.
    pub complete: Option<f64>,
    /// What was tried without success.
    pub failures: Vec<FailureRow>,
    /// The file of the certificate.
    pub certificate: Option<String>,
    /// The certificate.
    #[serde(skip)]
    pub proof: Option<CertificateFile>,
}

impl Finding for ChaosFindings {
    fn status(&self) -> Status {
        if self.proved {
            return Status::Done;
        }
        match self.failures.last() {
            Some(row) => Status::undecided(format!(
                "no proof over the alphabet {}: {}. This does not rule out chaos",
                periods(&row.alphabet, self.half, ["[", "]"]),
                row.reason
            )),
            None => Status::undecided(
                "as far as floats can tell, no alphabet with two words is born at the grazing. This does not rule out chaos",
            ),
        }
    }

    fn lines(&self, lines: &mut Lines) {
        // Bounds are not rounded.
        lines.exact();
        lines.say("oscillator", self.oscillator.clone());
        lines.say("for", self.range.clone());
        if self.proved {
            lines.say(
                "proved",
                format!(
                    "every bi-infinite word over {}{} is exactly one orbit in the boxes{}, admissible",
                    periods(&self.alphabet, self.half, ["{", "}"]),
                    if self.full { "" } else { " that the graph allows" },
                    if self.half { " from either wall (periods of letters below are halves)" } else { "" }
                ),
            );
            lines.table("letters", &self.letters);
            lines.say("contraction", self.contraction);
            lines
                .say("entropy", format!("{} per period of the wall", self.entropy.as_deref().unwrap_or("?")));
            if let Some((reach, ceiling)) = self.reach.zip(self.ceiling) {
                lines.say(
                    "the other wall",
                    format!("not met: q/nu stays below {reach}, it is above {ceiling:.4}"),
                );
            }
            let claim = self.proof.as_ref().map(|proof| proof.accepted.claim());
            for name in ["window", "others"] {
                lines.say(name, claim.and_then(|claim| claim.detail(name)).unwrap_or_default().to_string());
            }
        }
        if !self.failures.is_empty() {
            lines.table("without", &self.failures);
        }
    }

    fn certificates(&self) -> Vec<&CertificateFile> {
        self.proof.iter().collect()
    }
}

/// Proves the alphabet of the task, or the largest that closes of those born at the grazing.
///
/// # Errors
/// What the normal form does not cover; an interruption.
pub(crate) fn chaos(task: &ChaosTask, job: &Job) -> Result<ChaosFindings> {
    let normal = task.normal(&job.scene)?;
    let mut found = ChaosFindings {
        proved: false,
        half: normal.mirrored,
        oscillator: oscillator(&normal),
        range: range(task, &normal),
        depth: normal.ranges[4].each_ref().map(|x| x.to_f64().unwrap_or(f64::NAN)),
        alphabet: Vec::new(),
        full: false,
        letters: Vec::new(),
        contraction: None,
        entropy: None,
        growth: None,
        reach: None,
        ceiling: normal.ceiling.as_ref().and_then(ToPrimitive::to_f64),
        complete: None,
        failures: Vec::new(),
        certificate: None,
        proof: None,
    };
    let problem = |graph: &LetterGraph| {
        let graph = match task.history[..] {
            [of, most] => {
                graph.with_history(ChaosTask::counted(&normal, of), most.whole().unwrap_or(0) as usize)
            }
            _ => graph.clone(),
        };
        let Normal { mirrored, ranges, behind, harmonics, .. } = normal.clone();
        Problem { mirrored, ranges, behind, harmonics, letters: graph.letters, next: graph.next }
    };
    let mut graph = match &task.alphabet {
        Alphabet::Auto => born(&problem(&LetterGraph::full(&[1])), LONGEST.min(24)).richest(),
        Alphabet::Periods(periods) => {
            let counted =
                |list: &Vec<Periods>| list.iter().map(|&n| ChaosTask::counted(&normal, n)).collect();
            let follow: Vec<Vec<u64>> = task.follow.iter().map(counted).collect();
            Some(given(&counted(periods), &follow)?)
        }
    };
    while let Some(tried) = graph.take() {
        if tried.growth().0 <= 1.0 + 1e-9 {
            if task.alphabet != Alphabet::Auto {
                return Err(Error::input(
                    "kind \"chaos\": the graph has one periodic word only, whose entropy is 0",
                ));
            }
            break;
        }
        found.alphabet.clone_from(&tried.letters);
        found.full = tried == LetterGraph::full(&tried.letters);
        match prove(&problem(&tried), job.monitor)? {
            Ok(proof) if found.ceiling.is_none_or(|ceiling| reach(&proof) < ceiling) => {
                found.keep(proof, &job.task.name);
                break;
            }
            Ok(proof) => {
                let (reach, ceiling) = (reach(&proof), found.ceiling.unwrap_or(f64::NAN));
                let reason = format!(
                    "the other wall may be met: it is above q/nu = {ceiling:.4}, the orbits below {reach}"
                );
                found.failures.push(FailureRow { alphabet: tried.letters.clone(), reason });
            }
            Err(reasons) => {
                let reason = reasons.last().cloned().unwrap_or_else(|| "too much work".into());
                found.failures.push(FailureRow { alphabet: tried.letters.clone(), reason });
                if task.alphabet == Alphabet::Auto {
                    let longest = tried.letters.iter().copied().max();
                    let keep: Vec<usize> =
                        (0..tried.letters.len()).filter(|&v| Some(tried.letters[v]) != longest).collect();
                    graph = tried.part(&keep).richest();
                }
            }
        }
    }
    Ok(found)
}

impl ChaosFindings {
    fn keep(&mut self, proof: ShiftProof, name: &str) {
        let letters = proof.certificate.letters.iter();
        self.letters = letters
            .map(|letter| LetterRow {
                periods: letter.periods,
                next: letter.next.iter().map(|&next| next as u64 + 1).collect(),
                after: letter.after.map(float),
                before: letter.before.map(float),
            })
            .collect();
        self.contraction = Some(float(proof.certificate.contraction));
        let growth = proof.certificate.growth;
        self.growth = Some(growth[0].to_string());
        self.entropy = entropy(growth.map(float), self.half);
        self.reach = Some(reach(&proof));
        self.complete = proof.certificate.complete.map(|claim| float(claim.strength));
        let file = format!("{name}.certificate");
        self.certificate = Some(file.clone());
        self.proof = Some(CertificateFile { file, accepted: proof.accepted });
        self.proved = true;
    }
}

fn reach(proof: &ShiftProof) -> f64 {
    float(proof.certificate.reach)
}

/// The number that a certificate's decimal stands for.
fn float(x: Decimal) -> f64 {
    x.digits as f64 / 10f64.powi(x.places as i32)
}

/// Numbers of periods, which may be counted in halves, between brackets.
fn periods(counts: &[u64], half: bool, [open, close]: [&str; 2]) -> String {
    let halves = |&n: &u64| Periods { halves: if half { n } else { 2 * n } }.to_string();
    format!("{open}{}{close}", counts.iter().map(halves).collect::<Vec<_>>().join(", "))
}

/// The digits of the logarithm, twice the one of a rate per half period, that both ends share: an error of
/// 1e-15, the library's, is allowed for.
fn entropy([lo, hi]: [f64; 2], half: bool) -> Option<String> {
    let times = if half { 2.0 } else { 1.0 };
    let ends = [lo.ln() - 1e-14, hi.ln() + 1e-14].map(|end| BigRational::from_float(times * end));
    let [Some(lo), Some(hi)] = ends else { return None };
    certain_digits(&lo, &hi, 12)
}

fn given(periods: &[u64], follow: &[Vec<u64>]) -> Result<LetterGraph> {
    let mut graph = LetterGraph::full(periods);
    if !follow.is_empty() {
        let place = |n: &u64| periods.iter().position(|known| known == n);
        graph.next = follow.iter().map(|list| list.iter().filter_map(place).collect()).collect();
    }
    if graph.is_connected() {
        Ok(graph)
    } else {
        Err(Error::input(
            "kind \"chaos\": some period of the alphabet cannot be reached from another: leave it out",
        ))
    }
}

fn range(task: &ChaosTask, normal: &Normal) -> String {
    let end = if normal.open { "<" } else { "<=" };
    let mut parts = Vec::new();
    if let (Some(name), Some(from)) = (&task.parameter, &task.from) {
        parts.push(match &task.to {
            Some(to) => format!("every {name} with {from} < {name} {end} {to}"),
            None => format!("every {name} > {from}"),
        });
    }
    parts.extend(task.cell.0.iter().map(|(name, [lo, hi])| format!("every {name} from {lo} to {hi}")));
    if parts.is_empty() { "the values of the parameters".into() } else { parts.join(", ") }
}

fn oscillator(normal: &Normal) -> String {
    let names = ["c", "k", "f", "tau", "nu"];
    let one = |name: &str, [lo, hi]: &[BigRational; 2]| {
        if lo == hi { format!("{name} = {lo}") } else { format!("{name} in [{lo}, {hi}]") }
    };
    let mut values: Vec<String> =
        names.into_iter().zip(&normal.ranges).map(|(name, range)| one(name, range)).collect();
    let wall = match &normal.harmonics[..] {
        [_] => "cos t".to_string(),
        all => {
            let mut terms = Vec::new();
            for (j, both) in all {
                for ((name, function), range) in [("a", "cos"), ("b", "sin")].into_iter().zip(both) {
                    if range.iter().any(|x| !x.is_zero()) {
                        let order = if *j == 1 { String::new() } else { j.to_string() };
                        terms.push(format!("{name}{j} {function} {order}t"));
                        values.push(one(&format!("{name}{j}"), range));
                    }
                }
            }
            terms.join(" + ")
        }
    };
    let sign = if normal.behind { "" } else { "-" };
    if normal.mirrored {
        let values = values.iter().filter(|value| !value.starts_with("f ")).cloned().collect::<Vec<_>>();
        return format!(
            "q'' = -c q' - k q between w(t) = {sign}nu - 1 + {wall} and -w(t - pi); {}",
            values.join(", ")
        );
    }
    let turned = if normal.side == Side::Upper { ", turned below by q -> -q" } else { "" };
    format!("q'' = -c q' - k q + f above {sign}nu - 1 + {wall}{turned}; {}", values.join(", "))
}
