//! Fuzzing Conjecture 1: random points at which the definition and the claim are decided apart and compared.
//!
//! Half of the cases come from sweeps: (r, s) uniform, every n ≤ N in one pass of the record form (`sweep`);
//! half of the rest of the work goes to single cases drawn near the places where something could fail
//! (`weighted`), decided k by k on the ladder. A run is a list of units; unit i of a seed is the same
//! whatever the number of threads. Finding no disagreement proves nothing; a disagreement is decided again,
//! shrunk, and can be replayed. Where two routes of this program to one answer differ, that is an error of
//! its own, reported with the point.
//!
//! ```
//! use grazing::search::fuzz::{Campaign, FuzzOptions, FuzzTally, Tally, fuzz};
//! let options = FuzzOptions { first: 1, last: 12, cases: 1000, seed: 1, definition_share: 0.01 };
//! let tally = fuzz(&options, 0..options.units(), FuzzTally::default(), &(), |_| Ok(()))?;
//! assert!(tally.decided() >= 1000 && tally.disagreements().is_empty());
//! # Ok::<(), grazing::Error>(())
//! ```

mod campaign;
mod confirm;
mod random;
mod sweep;
mod weighted;
pub mod words;

use num_rational::BigRational;
use serde::{Deserialize, Serialize};

use super::{Instance, compare::differ};
use crate::{
    error::Result,
    existence::Variant,
    local::{Ladder, Point, Polar},
    monitor::Monitor,
    processor::thread_seconds,
    random::Random,
};
pub use campaign::{Campaign, Tally, fuzz};
use confirm::{contradiction, one_case, shrink};
use sweep::Sweep;
pub(crate) use sweep::quotients;

/// What to fuzz.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FuzzOptions {
    /// The smallest period.
    pub first: u64,
    /// The largest period; at least 3 and at most 4096.
    pub last: u64,
    /// The cases wanted: whole units are done, as few as have them.
    pub cases: u64,
    /// The seed.
    pub seed: u64,
    /// The share of sweep points at which one period is decided by the definition, k by k, too.
    pub definition_share: f64,
}

/// What a run has come to so far.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct FuzzTally {
    /// The number of units done: the run goes on from here.
    pub units: u64,
    /// Cases decided in sweeps by `f64` with proved bounds.
    pub swept: u64,
    /// Cases decided on the ladder: by intervals, by balls, by integers alone.
    pub interval: u64,
    /// See `interval`.
    pub ball: u64,
    /// See `interval`.
    pub exact: u64,
    /// Cases on a boundary, where nothing is claimed.
    pub boundary: u64,
    /// Cases left undecided by the ladder's precision.
    pub undecided: u64,
    /// Sweep results decided again by the definition.
    pub repeated: u64,
    /// Weighted cases, which are among those counted above.
    pub weighted: u64,
    /// Processor seconds spent on sweeps and on weighted cases; 0 where the system does not tell.
    pub sweep_seconds: f64,
    /// See `sweep_seconds`.
    pub weighted_seconds: f64,
    /// Confirmed disagreements, shrunk, as lines of a regression file.
    pub disagreements: Vec<String>,
    /// Errors of this program: what two routes to one answer differ in, and the case.
    #[serde(default)]
    pub faults: Vec<String>,
}

impl Tally for FuzzTally {
    fn units(&self) -> u64 {
        self.units
    }

    fn decided(&self) -> u64 {
        self.swept + self.interval + self.ball + self.exact + self.boundary
    }

    fn undecided(&self) -> u64 {
        self.undecided
    }

    fn disagreements(&self) -> &[String] {
        &self.disagreements
    }

    fn faults(&self) -> &[String] {
        &self.faults
    }

    fn merge(mut self, other: FuzzTally) -> FuzzTally {
        self.units += other.units;
        self.swept += other.swept;
        self.interval += other.interval;
        self.ball += other.ball;
        self.exact += other.exact;
        self.boundary += other.boundary;
        self.undecided += other.undecided;
        self.repeated += other.repeated;
        self.weighted += other.weighted;
        self.sweep_seconds += other.sweep_seconds;
        self.weighted_seconds += other.weighted_seconds;
        self.disagreements.extend(other.disagreements);
        self.faults.extend(other.faults);
        self
    }
}

/// Sweep points and weighted cases of one unit.
const SWEEP_POINTS: u64 = 256;
const WEIGHTED_CASES: u64 = 4;
/// The least period of a sweep.
const FIRST_SWEPT: u64 = 3;

impl FuzzOptions {
    /// The periods of a sweep: it begins at 3.
    fn periods(&self) -> u64 {
        (self.last + 1).saturating_sub(self.first.max(FIRST_SWEPT))
    }
}

impl Campaign for FuzzOptions {
    type Tally = FuzzTally;
    type Sweep = Sweep;
    const CHUNK: u64 = 512;
    const LONGEST: u64 = sweep::LONGEST as u64;

    fn last(&self) -> u64 {
        self.last
    }

    fn cases(&self) -> u64 {
        self.cases
    }

    fn block(&self) -> u64 {
        SWEEP_POINTS * self.periods()
    }

    fn canonical(&self) -> String {
        let FuzzOptions { first, last, seed, definition_share, .. } = self;
        let share = definition_share.to_bits();
        format!(
            "periods {first}..={last} seed {seed} share {share:016x} unit {SWEEP_POINTS}+{WEIGHTED_CASES}"
        )
    }

    fn check_counts(&self, tally: &FuzzTally) -> std::result::Result<(), &'static str> {
        let parts = [tally.swept, tally.interval, tally.ball, tally.exact, tally.boundary, tally.undecided];
        if parts.iter().chain([&tally.repeated, &tally.weighted]).any(|&part| part > 1 << 60) {
            return Err("a count beyond all units");
        }
        if tally.repeated > tally.units * SWEEP_POINTS || tally.weighted > tally.units * WEIGHTED_CASES {
            return Err("more repeated or weighted cases than units have");
        }
        // Every point of a sweep is one case for each period, a repeated one is decided once more, and
        // weighted cases are cases.
        let cases = tally.units * SWEEP_POINTS * self.periods() + tally.repeated + tally.weighted;
        let counted: u64 = parts.iter().sum();
        let differing = tally.disagreements.len() as u64;
        // A unit ends at its first fault.
        if counted > cases || (tally.faults.is_empty() && cases - counted > differing) {
            return Err("the counts do not add up");
        }
        let seconds = [tally.sweep_seconds, tally.weighted_seconds];
        if !seconds.iter().all(|seconds| (0.0..1e15).contains(seconds)) {
            return Err("its times");
        }
        Ok(())
    }

    fn differs(&self, line: &str) -> Result<bool> {
        Ok(differ(&Ladder::default(), &line.parse()?, Variant::True))
    }

    fn sweep(&self) -> Sweep {
        Sweep::new(self.last as usize)
    }

    fn unit(
        &self,
        ladder: &Ladder,
        sweep: &mut Sweep,
        unit: u64,
        monitor: &dyn Monitor,
    ) -> Option<FuzzTally> {
        let mut random = Random::of_unit(self.seed, unit);
        let mut tally = FuzzTally { units: 1, ..FuzzTally::default() };
        let start = thread_seconds();
        // The share as a threshold on 53 random bits: what it selects depends on the seed alone.
        let threshold = (self.definition_share * (1u64 << 53) as f64) as u64;
        for _ in 0..SWEEP_POINTS {
            monitor.advance(0).ok()?;
            let (r, s) = (random.bits() >> 11 | 1, random.bits() >> 11 | 1);
            let repeated = if random.bits() >> 11 < threshold {
                random.within(self.first.max(FIRST_SWEPT), self.last)
            } else {
                0
            };
            sweep.run(r, s, |n, swept| {
                // After an error of ours the rest of the unit says nothing, and might be one such line for
                // every case.
                if (n as u64) < self.first || !tally.faults.is_empty() {
                    return;
                }
                let agreed = swept.defined.is_some() && swept.defined == swept.claimed;
                tally.swept += u64::from(agreed);
                let repeated = n as u64 == repeated;
                tally.repeated += u64::from(repeated);
                if agreed && !repeated {
                    return;
                }
                let case = dyadic(n, r, s);
                if let Some(what) = contradiction(ladder, &case, &swept) {
                    tally.faults.push(format!("{what}: {case}"));
                }
                // Open or an apparent disagreement; and one chosen to be decided again whatever the sweep
                // says.
                for _ in 0..u32::from(!agreed) + u32::from(repeated) {
                    one_case(ladder, case.clone(), Variant::True, &mut tally);
                }
            });
        }
        tally.sweep_seconds = thread_seconds() - start;
        let start = thread_seconds();
        for _ in 0..WEIGHTED_CASES {
            monitor.advance(0).ok()?;
            if let Some(case) = weighted::case(&mut random, ladder, self.first..=self.last) {
                tally.weighted += 1;
                one_case(ladder, case, Variant::True, &mut tally);
            }
        }
        tally.weighted_seconds = thread_seconds() - start;
        Some(tally)
    }
}

/// The first of `most` weighted cases of a seed that refutes a variant of the claim, shrunk. Cost: at most
/// `most` cases, each with O(n) signs, n ≤ `last`, and the shrinking of one.
pub fn refute(variant: Variant, seed: u64, most: u64, last: u64) -> Option<Instance> {
    let ladder = Ladder::default();
    let mut random = Random::of_unit(seed, 0);
    (0..most)
        .filter_map(|_| weighted::case(&mut random, &ladder, 1..=last))
        .find(|case| differ(&ladder, case, variant))
        .map(|case| shrink(&ladder, case, variant))
}

/// The sweep's point r/2⁵³, s/2⁵⁴ as an exact case.
fn dyadic(n: usize, r: u64, s: u64) -> Instance {
    let r = BigRational::new(r.into(), (1u64 << 53).into());
    let s = BigRational::new(s.into(), (1u64 << 54).into());
    let polar = Polar::new(r, s).expect("a sweep's point is in region 3");
    Instance { n: n as u64, point: Point::Polar(polar) }
}
