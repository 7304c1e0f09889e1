//! What a proof costs: bits and time to prove an orbit against its distance to grazing and against its
//! period; the size of certificates and the time to check them, for every kind but those of motions without
//! impacts.

use std::time::{Duration, Instant};

use num_rational::BigRational;
use num_traits::One;

use super::computer::load;
use crate::{
    certificate,
    error::{Error, Result},
    local::{Ladder, Plane, Point},
    monitor::Monitor,
    motion::{Side, System},
    number::{Precision, parse_rational},
    one::orbit::{Itinerary, Oscillator, search},
    run::{Findings, Surroundings, run},
    scene::Scene,
    search::{
        Certified, ProofMethod, WordCertificate, WordPlace, certify_word,
        cover::{self, CoverOptions},
        entropy_certificate,
        orbit::{self, ExpectedImpact, Verdict},
        prove_theorem2, write_theorem2,
    },
    word::Word,
};

/// What is varied.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum ProofStudy {
    /// The distance of an orbit to the grazing it is born at.
    Distance,
    /// The period of an orbit with one impact.
    Period,
    /// The n of a certificate.
    Certificate,
}

impl ProofStudy {
    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            ProofStudy::Distance => "distance",
            ProofStudy::Period => "period",
            ProofStudy::Certificate => "certificate",
        }
    }
}

/// What one proof costs.
#[derive(Debug, Clone)]
pub struct ProofCost {
    /// What is varied.
    pub study: ProofStudy,
    /// The kind of the certificate.
    pub kind: &'static str,
    /// The distance to grazing is 10^−`digits`; `None` where it is not what is varied.
    pub digits: Option<u32>,
    /// The period; of covers, Theorem 2 and words the period that is proved; of chaos and ranges the letters
    /// of the alphabet; of machines the coordinates; 0 where the kind has no such number.
    pub n: u64,
    /// The fewest bits, of 32, 48, 64, 96, 128, …, 1024, with which the proof succeeded; `None` where no such
    /// choice is made, or none did.
    pub bits: Option<u32>,
    /// The time of the proof, with these bits; of kinds whose search is no proof, of the search too.
    pub prove: Option<Duration>,
    /// The certificate's bytes.
    pub bytes: Option<usize>,
    /// The least of three times to check it.
    pub check: Option<Duration>,
    /// Why there is no proof, or no certificate.
    pub reason: Option<String>,
    /// Processes that were waiting for a processor or had one, as [`SignPrice`](super::SignPrice) has it.
    pub load: Option<f64>,
}

/// How much is measured.
#[derive(Debug, Clone)]
pub struct ProofSizes {
    /// Distances 10^−d.
    pub(crate) distances: &'static [u32],
    /// Periods of orbits.
    pub(crate) periods: &'static [u32],
    /// Periods of orbits whose coefficients are intervals.
    pub(crate) intervals: &'static [u32],
    /// Periods of Theorem 2 and of words.
    pub(crate) exact: &'static [u64],
    /// Periods of covers.
    pub(crate) covers: &'static [u64],
    /// Coordinates of machines.
    pub(crate) machines: &'static [u64],
}

impl ProofSizes {
    /// A full study: about a minute.
    pub const FULL: ProofSizes = ProofSizes {
        distances: &[1, 2, 3, 4, 5, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30],
        periods: &[1, 2, 3, 5, 10, 20, 50, 100, 200, 500, 1000],
        intervals: &[1, 2, 3, 5, 10, 20, 50],
        exact: &[3, 10, 30, 100, 300],
        covers: &[3, 4, 5, 6, 8, 10, 12],
        machines: &[1, 2, 3, 4],
    };
    /// A quick one: some seconds.
    pub const QUICK: ProofSizes = ProofSizes {
        distances: &[1, 3, 10, 30],
        periods: &[1, 10, 100],
        intervals: &[1, 10],
        exact: &[3, 10, 30],
        covers: &[3, 4],
        machines: &[1, 2],
    };

    /// How many measurements that are.
    pub fn steps(&self) -> u64 {
        let orbits = self.distances.len() + self.periods.len() + self.intervals.len();
        let scenes = SCENES.len() + self.machines.len();
        (orbits + 3 * self.exact.len() + self.covers.len() + scenes + 1) as u64
    }
}

/// The oscillator of section 4 of the paper, with proofs of orbits and events.
pub const PAPER: &str = include_str!("../scenes/nordmark-2001.toml");
/// The same with proofs of chaos.
pub const CHAOS: &str = include_str!("../scenes/nordmark-2001-chaos.toml");
const BRANCHES: &str = include_str!("../scenes/nordmark-2001-branches.toml");
/// The same stop with so much damping that both eigenvalues are real: orbits of every period are born.
const OVERDAMPED: &str = r#"
format = "grazing-scene 1"
title = "an overdamped oscillator whose stop grazes it"
[parameters]
d = 1.2
w = 60
mu = 0.001
[system]
damping = "2*d/w"
stiffness = "1/w^2"
[[walls]]
side = "lower"
offset = -1
harmonics = [{ k = 1, cos = "1 + mu" }]
restitution = 1
"#;

/// The motions of two mirrored stops, with proofs of chaos.
pub const MIRRORED: &str = include_str!("../scenes/two-stops-chaos.toml");
/// A damped oscillator below a stop that its motion without impacts touches where F is √½ (k = 3/10), and
/// how far from there what is born is proved to go on, and where nothing is born.
const TOUCHED: &str = r#"
format = "grazing-scene 3"
title = "a stop that is touched"
[parameters]
F = 0.5
[system]
damping = 0.1
stiffness = 0.3
forcing = [{ cos = "F" }]
[[stops]]
side = "upper"
offset = 1
restitution = 0.8
[[tasks]]
name = "range"
kind = "grazing"
parameter = "F"
max_period = 1
seen = false
range = { effort = 20000 }
"#;

/// Tasks of scenes that write certificates: kind, n, scene, task.
const SCENES: [(&str, u64, &str, &str); 14] = [
    ("event", 3, PAPER, "proved-mu_pd"),
    ("event", 4, PAPER, "proved-mu_sn"),
    ("event", 6, PAPER, "proved-mu_gr3"),
    ("event 2", 3, PAPER, "proved-mu_pd"),
    ("event 2", 4, PAPER, "proved-mu_sn"),
    ("event 2", 6, PAPER, "proved-mu_gr3"),
    ("branch", 3, BRANCHES, "period-3"),
    ("chaos 3", 2, CHAOS, "few"),
    ("chaos 3", 3, CHAOS, "figure10"),
    ("chaos 4", 3, MIRRORED, "touched"),
    ("range", 2, TOUCHED, "range"),
    ("range 2", 3, TOUCHED, "range"),
    ("nothing", 0, TOUCHED, "range"),
    ("single", 1, TOUCHED, "range"),
];

/// A scene with the stop's amplitude changed in the 40th decimal, which version 1 of a certificate cannot
/// hold.
fn lengthened(text: &str) -> String {
    text.replace("1 + mu", "1 + mu + 1e-40")
}

/// Bits that are tried, in order.
const BITS: [u32; 10] = [32, 48, 64, 96, 128, 192, 256, 384, 512, 1024];

/// Measures all.
///
/// # Errors
/// The monitor's interruption, which it is asked for between measurements; whatever a search returns.
pub fn proof_costs(sizes: &ProofSizes, monitor: &dyn Monitor) -> Result<Vec<ProofCost>> {
    let mut costs = distances(sizes.distances, monitor)?;
    costs.extend(periods((ProofStudy::Period, "orbit"), sizes.periods, OVERDAMPED, monitor)?);
    let long = lengthened(OVERDAMPED);
    costs.extend(periods((ProofStudy::Certificate, "orbit 2"), sizes.intervals, &long, monitor)?);
    for &n in sizes.exact {
        costs.push(theorem2(n)?);
        monitor.advance(1)?;
        for by_theorem in [false, true] {
            costs.push(word(n, by_theorem)?);
            monitor.advance(1)?;
        }
    }
    for &n in sizes.covers {
        costs.push(covers(n)?);
        monitor.advance(1)?;
    }
    for (kind, n, text, task) in SCENES {
        let text = if kind == "event 2" { lengthened(text) } else { text.into() };
        costs.push(of_scene(kind, n, &text, task)?);
        monitor.advance(1)?;
    }
    costs.push(suprema()?);
    monitor.advance(1)?;
    for &n in sizes.machines {
        costs.push(of_scene("machine-orbit", n, &chain(n), "proof")?);
        monitor.advance(1)?;
    }
    Ok(costs)
}

/// The paper's orbit of period 3 with one impact, at µ = 10^−d above the grazing it is born at: its phase and
/// its speed shrink like µ, and so does what keeps it from the grazing.
fn distances(digits: &[u32], monitor: &dyn Monitor) -> Result<Vec<ProofCost>> {
    let scene = Scene::from_toml(PAPER, "nordmark-2001.toml")?;
    let at = |digits: u32| {
        let distance = BigRational::new(One::one(), num_bigint::BigInt::from(10).pow(digits));
        scene.exact(&[("mu", distance)])
    };
    // Scaled from where a search in floats finds it.
    let base = 3;
    let start = near(&at(base)?, 3, 0.1)?;
    let mut costs = Vec::new();
    for &digits in digits {
        let scale = 10f64.powi(base as i32 - digits as i32);
        // A larger µ moves the orbit by more than its scale.
        let guess = match near(&at(digits)?, 3, 2.0 * start[1] * scale) {
            Ok(found) if digits < 8 => found,
            _ => start.map(|x| x * scale),
        };
        costs.push(prove((ProofStudy::Distance, "orbit"), &at(digits)?, (Some(digits), 3), guess)?);
        monitor.advance(1)?;
    }
    Ok(costs)
}

/// Orbits of the overdamped oscillator with one impact in n periods.
fn periods(
    (study, kind): (ProofStudy, &'static str),
    periods: &[u32],
    scene: &str,
    monitor: &dyn Monitor,
) -> Result<Vec<ProofCost>> {
    let system = Scene::from_toml(scene, "overdamped")?.exact(&[])?;
    let mut costs = Vec::new();
    for &n in periods {
        costs.push(match near(&system, n, 0.05) {
            Ok(guess) => prove((study, kind), &system, (None, n), guess)?,
            Err(error) if error.is_interrupted() => return Err(error),
            Err(error) => {
                ProofCost { reason: Some(error.to_string()), ..ProofCost::new(study, kind, n.into()) }
            }
        });
        monitor.advance(1)?;
    }
    Ok(costs)
}

/// The slowest admissible orbit with one impact in n periods that a search in floats finds: its residual's
/// place, phase and speed.
fn near(system: &System<BigRational>, n: u32, speed: f64) -> Result<[f64; 2]> {
    let oscillator = Oscillator::new(system.rounded(), 1e-13)?;
    let orbits = search(&oscillator, &Itinerary::at(Side::Lower, &[n])?, 200, speed);
    let found = orbits.iter().find(|orbit| orbit.admissibility.is_admissible());
    let z = found.and_then(|orbit| <[f64; 2]>::try_from(orbit.z.clone()).ok());
    let z = z.ok_or_else(|| Error::input(format!("a search in floats finds no orbit of period {n}")))?;
    // The phase nearest to 0, as the guess is scaled.
    let turn = std::f64::consts::TAU;
    Ok([z[0] - turn * (z[0] / turn).round(), z[1]])
}

/// Proves an orbit with as few bits as will do, and checks its certificate.
fn prove(
    (study, kind): (ProofStudy, &'static str),
    system: &System<BigRational>,
    (digits, n): (Option<u32>, u32),
    [phase, velocity]: [f64; 2],
) -> Result<ProofCost> {
    let guess = [ExpectedImpact { side: Side::Lower, periods: n, phase, velocity }];
    let mut cost = ProofCost { digits, ..ProofCost::new(study, kind, n.into()) };
    for bits in BITS {
        let precision = Precision::new(bits);
        let start = Instant::now();
        let verdict = orbit::orbit(system, &guess, &precision)?;
        let time = start.elapsed();
        match verdict {
            Verdict::Proved(proof) => {
                (cost.bits, cost.prove, cost.reason) = (Some(bits), Some(time), None);
                match orbit::certificate(system, &proof) {
                    Ok(found) => cost.checked(found.accepted.text())?,
                    Err(error) => cost.reason = Some(error.to_string()),
                }
                break;
            }
            Verdict::Refuted(reason) | Verdict::Undecided(reason) => cost.reason = Some(reason),
        }
    }
    Ok(cost)
}

fn theorem2(n: u64) -> Result<ProofCost> {
    let mut text = Vec::new();
    let start = Instant::now();
    let proof = prove_theorem2(n..=n, ProofMethod::Exact, &())?;
    write_theorem2(n..=n, &proof, &mut text, &())?;
    ProofCost::of("theorem2", n, start.elapsed(), &String::from_utf8_lossy(&text))
}

fn covers(n: u64) -> Result<ProofCost> {
    let start = Instant::now();
    let covers = cover::cover(&CoverOptions::new(n..=n), Default::default(), &(), &|_, _| Ok(()))?;
    let blocks: Vec<String> = covers.iter().filter_map(cover::Cover::block).collect();
    let text = cover::certificate(&(n..=n), &blocks);
    ProofCost::of("cover", n, start.elapsed(), &text)
}

/// Periods between impacts up to n at (a₁, a₂) = (3/2, 9/10), and by the word theorem.
fn word(n: u64, by_theorem: bool) -> Result<ProofCost> {
    let kind = if by_theorem { "word-by-theorem" } else { "word" };
    let plane = Plane::new(parse_rational("3/2")?, parse_rational("9/10")?)?;
    let point = Point::Plane(plane);
    let start = Instant::now();
    let word = Word::at(&Ladder::default(), &point, true, n as usize, &())?;
    let how = if by_theorem { WordCertificate::ByTheorem } else { WordCertificate::BySigns { last: n } };
    match certify_word(WordPlace::Point(&point), &[&word], how, &mut || false)? {
        Certified::Text(text) => ProofCost::of(kind, n, start.elapsed(), &text),
        Certified::Undecided(reason) => {
            Ok(ProofCost { reason: Some(reason), ..ProofCost::new(ProofStudy::Certificate, kind, n) })
        }
    }
}

/// The two suprema of the entropy of words.
fn suprema() -> Result<ProofCost> {
    let start = Instant::now();
    let text = entropy_certificate(&())?;
    ProofCost::of("entropy", 0, start.elapsed(), &text)
}

/// The first certificate of a kind that a task writes; of a range over that many letters.
fn of_scene(kind: &'static str, n: u64, text: &str, task: &str) -> Result<ProofCost> {
    let mut scene = Scene::from_toml(text, kind)?;
    scene.tasks.retain(|other| other.name == task);
    let start = Instant::now();
    let reports = run(&scene, Surroundings::default(), &mut ())?;
    let time = start.elapsed();
    let found = reports.iter().filter_map(|report| report.findings.as_ref());
    let mut certificates = found.flat_map(Findings::certificates).map(|one| one.accepted.text());
    let letters = |text: &str| text.lines().filter(|line| line.starts_with("letter ")).count() as u64;
    let wanted = |text: &&str| is_of(kind, text) && (!kind.starts_with("range") || letters(text) == n);
    match certificates.find(wanted) {
        Some(text) => ProofCost::of(kind, n, time, text),
        None => {
            let reason = reports.first().map(|report| report.status.to_string());
            Ok(ProofCost { reason, ..ProofCost::new(ProofStudy::Certificate, kind, n) })
        }
    }
}

/// Whether a certificate's second line names this kind.
fn is_of(kind: &str, text: &str) -> bool {
    text.lines().nth(1).and_then(|line| line.strip_prefix("kind ")) == Some(kind)
}

/// n masses in a row on springs, the last one before a stop, the first one driven.
fn chain(n: u64) -> String {
    let list = |entry: &dyn Fn(u64) -> &'static str| (0..n).map(entry).collect::<Vec<_>>().join(", ");
    let row = |i: u64| {
        let entry = |j: u64| match i.abs_diff(j) {
            0 => "40",
            1 => "-20",
            _ => "0",
        };
        format!("[{}]", list(&entry))
    };
    let at = |place: u64, x: &'static str| list(&move |i| if i == place { x } else { "0" });
    format!(
        r#"format = "grazing-scene 2"
title = "a row of masses"
[system]
frequency = "5/pi"
mass = {{ diagonal = [{}] }}
stiffness = [{}]
damping = {{ diagonal = [{}] }}
forcing = [{{ k = 1, cos = [{}] }}]
[[walls]]
name = "end"
row = [{}]
offset = "-0.05"
restitution = "0.7"
[[tasks]]
name = "proof"
kind = "validate"
orbit = {{ pattern = [1], stops = ["end"], speed = 6, starts = 100 }}
"#,
        list(&|_| "1"),
        (0..n).map(row).collect::<Vec<_>>().join(", "),
        list(&|_| "2"),
        at(0, "30"),
        at(n - 1, "1"),
    )
}

impl ProofCost {
    fn new(study: ProofStudy, kind: &'static str, n: u64) -> ProofCost {
        ProofCost {
            study,
            kind,
            digits: None,
            n,
            bits: None,
            prove: None,
            bytes: None,
            check: None,
            reason: None,
            load: load(),
        }
    }

    fn of(kind: &'static str, n: u64, prove: Duration, text: &str) -> Result<ProofCost> {
        let mut cost = ProofCost { prove: Some(prove), ..ProofCost::new(ProofStudy::Certificate, kind, n) };
        cost.checked(text)?;
        Ok(cost)
    }

    /// Checks the certificate three times, each of which must pass.
    fn checked(&mut self, text: &str) -> Result<()> {
        if !is_of(self.kind, text) {
            return Err(Error::input(format!("a certificate is not of kind {}", self.kind)));
        }
        self.bytes = Some(text.len());
        for _ in 0..3 {
            let start = Instant::now();
            let checked = certificate::check(&mut text.as_bytes());
            let time = start.elapsed();
            checked.map_err(|rejection| Error::input(format!("a fresh certificate: {rejection}")))?;
            self.check = Some(self.check.map_or(time, |least| least.min(time)));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orbits_near_grazing_are_proved() {
        let costs = distances(&[1, 12, 16, 20, 30], &()).unwrap();
        for cost in &costs {
            assert!(cost.bits.is_some(), "1e-{:?}: {:?}", cost.digits, cost.reason);
        }
        assert!(costs[0].check.is_some());
    }

    #[test]
    fn long_coefficients_need_the_second_version() {
        let costs =
            periods((ProofStudy::Certificate, "orbit 2"), &[1], &lengthened(OVERDAMPED), &()).unwrap();
        assert!(costs[0].check.is_some(), "{:?}", costs[0].reason);
    }

    #[test]
    fn the_scenes_beside_the_touch_write_the_kinds_they_are_for() {
        for (kind, n, text, task) in SCENES.into_iter().filter(|row| row.2 == TOUCHED) {
            let cost = of_scene(kind, n, text, task).unwrap();
            assert!(cost.check.is_some(), "{kind}: {:?}", cost.reason);
        }
        assert!(suprema().unwrap().check.is_some());
    }
}
