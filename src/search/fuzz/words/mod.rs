//! Fuzzing the word theorem: which periods occur and which may follow which, by the definition and (64),
//! against one word and its table.
//!
//! Most points come from sweeps (`sweep`): eight moduli per angle, uniform, near r = 1, near fractions of
//! small denominator, near the lowest points of areas. Some are drawn near the places where something could
//! fail and decided exactly (`compare`), as is a share of the sweeps' points. Beside them random words on r
//! = 1 are asked whether any has an entropy above the supremum, for eµ > 0 in region 3. Finding no
//! disagreement proves nothing.

mod compare;
mod points;
mod suprema;
mod sweep;
mod twofold;

use serde::{Deserialize, Serialize};

use super::{Campaign, Instance, Tally, dyadic, weighted};
use crate::{
    error::{Error, Result},
    local::Ladder,
    monitor::Monitor,
    processor::thread_seconds,
    random::Random,
};
pub use compare::WordStatement;
use compare::{Comparison, compare, differ, shrink};
use points::{angle, modulus};
pub use suprema::SUPREMA;
use suprema::entropies;
use sweep::{Swept, WordSweep};
use twofold::Twofold;

/// What to fuzz.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WordOptions {
    /// The largest period compared, from 3 to 1024.
    pub last: u64,
    /// The points wanted: whole units are done, as few as have them.
    pub cases: u64,
    /// The seed.
    pub seed: u64,
    /// The share of sweep points that are decided exactly, too.
    pub definition_share: f64,
}

/// What a run has come to so far.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct WordTally {
    /// The number of units done: the run goes on from here.
    pub units: u64,
    /// Points at which both routes agree in a sweep.
    pub swept: u64,
    /// Pairs of periods compared there.
    pub pairs: u64,
    /// Points that a sweep left open, on which both routes agree in pairs of floats.
    pub closer: u64,
    /// Points decided exactly, on which both routes agree.
    pub exact: u64,
    /// Points on a boundary, where something is zero; the rest agrees.
    pub boundary: u64,
    /// Points left undecided.
    pub undecided: u64,
    /// Points of sweeps decided exactly too, by choice.
    pub repeated: u64,
    /// Points drawn near the hard places.
    pub weighted: u64,
    /// Random words on r = 1 whose entropies were computed, both signs of γ.
    pub words: u64,
    /// The largest entropy of them for γ > 0 and γ < 0, rounded.
    pub largest: [f64; 2],
    /// The fractions m/n whose words have them, and their sides.
    pub largest_at: [String; 2],
    /// Words with an entropy certainly above the supremum.
    pub beyond: Vec<String>,
    /// Processor seconds in sweeps and elsewhere; 0 where the system does not tell.
    pub sweep_seconds: f64,
    /// See `sweep_seconds`.
    pub other_seconds: f64,
    /// Confirmed disagreements, shrunk, as `words N polar R S` or `words N plane A1 A2`.
    pub disagreements: Vec<String>,
    /// Errors of this program: a sweep's disagreement that the exact routes do not confirm.
    pub faults: Vec<String>,
}

/// Angles of one unit, moduli of each, and what else a unit has.
const ANGLES: u64 = 4096;
const MODULI: u64 = 8;
const WEIGHTED: u64 = 8;
const WORDS: u64 = 4;
/// One unit in this many has weighted points and words, which take three times as long as its sweeps.
const SELDOM: u64 = 16;
/// The largest period that points decided exactly are compared on.
const EXACT_LAST: u64 = 24;

impl Tally for WordTally {
    fn units(&self) -> u64 {
        self.units
    }

    fn decided(&self) -> u64 {
        self.swept + self.closer + self.exact + self.boundary
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

    fn merge(mut self, other: WordTally) -> WordTally {
        self.units += other.units;
        self.swept += other.swept;
        self.pairs += other.pairs;
        self.closer += other.closer;
        self.exact += other.exact;
        self.boundary += other.boundary;
        self.undecided += other.undecided;
        self.repeated += other.repeated;
        self.weighted += other.weighted;
        self.words += other.words;
        for (index, at) in other.largest_at.into_iter().enumerate() {
            if other.largest[index] > self.largest[index] {
                self.largest[index] = other.largest[index];
                self.largest_at[index] = at;
            }
        }
        self.beyond.extend(other.beyond);
        self.sweep_seconds += other.sweep_seconds;
        self.other_seconds += other.other_seconds;
        self.disagreements.extend(other.disagreements);
        self.faults.extend(other.faults);
        self
    }
}

/// The case of a line of a regression file.
///
/// # Errors
/// An input error unless it is `words N polar R S` or `words N plane A1 A2`.
pub fn replayed(line: &str) -> Result<Instance> {
    let case = line.strip_prefix("words ");
    case.ok_or_else(|| {
        Error::input(format!("{line:?} is not a case: write words N polar R S or words N plane A1 A2"))
    })?
    .parse()
}

/// What a thread sweeps with: floats, and pairs of them for what they leave open.
#[derive(Debug, Clone)]
pub struct Sweeps {
    near: WordSweep<f64>,
    closer: WordSweep<Twofold>,
}

impl Campaign for WordOptions {
    type Tally = WordTally;
    type Sweep = Sweeps;
    const CHUNK: u64 = 64;
    const LONGEST: u64 = sweep::LONGEST as u64;

    fn last(&self) -> u64 {
        self.last
    }

    fn cases(&self) -> u64 {
        self.cases
    }

    fn block(&self) -> u64 {
        ANGLES * MODULI
    }

    fn canonical(&self) -> String {
        let WordOptions { last, seed, definition_share, .. } = self;
        let share = definition_share.to_bits();
        format!(
            "words to {last} seed {seed} share {share:016x} unit {ANGLES}x{MODULI}/2+({WEIGHTED}+{WORDS})/{SELDOM}"
        )
    }

    fn check_counts(&self, tally: &WordTally) -> std::result::Result<(), &'static str> {
        let points = tally.units * ANGLES * MODULI;
        let parts = [tally.swept, tally.closer, tally.exact, tally.boundary, tally.undecided];
        if parts.iter().any(|&part| part > 1 << 60) || tally.pairs > points.saturating_mul(1 << 20) {
            return Err("a count beyond all units");
        }
        if tally.repeated > points
            || tally.weighted > tally.units * WEIGHTED
            || tally.words > tally.units * WORDS
        {
            return Err("more repeated points, weighted points or words than units have");
        }
        // Every point of a sweep is decided, one repeated once more, and every weighted one.
        let (counted, differing) = (parts.iter().sum::<u64>(), tally.disagreements.len() as u64);
        let all = points + tally.repeated + tally.weighted;
        if counted > all || (tally.faults.is_empty() && all - counted > differing) {
            return Err("the counts do not add up");
        }
        let numbers = [tally.sweep_seconds, tally.other_seconds, tally.largest[0], tally.largest[1]];
        if !numbers.iter().all(|number| (0.0..1e15).contains(number)) {
            return Err("its times, or its entropies");
        }
        Ok(())
    }

    fn differs(&self, line: &str) -> Result<bool> {
        Ok(differ(&Ladder::default(), &replayed(line)?, WordStatement::True))
    }

    fn sweep(&self) -> Sweeps {
        let last = self.last as usize;
        Sweeps { near: WordSweep::new(last), closer: WordSweep::new(last) }
    }

    fn unit(
        &self,
        ladder: &Ladder,
        sweep: &mut Sweeps,
        unit: u64,
        monitor: &dyn Monitor,
    ) -> Option<WordTally> {
        let mut random = Random::of_unit(self.seed, unit);
        let mut tally = WordTally { units: 1, ..WordTally::default() };
        let start = thread_seconds();
        let threshold = (self.definition_share * (1u64 << 53) as f64) as u64;
        let mut exact = 0.0;
        for _ in 0..ANGLES {
            monitor.advance(0).ok()?;
            let (family, s) = angle(&mut random);
            sweep.near.turn(s);
            let mut turned = false;
            for _ in 0..MODULI {
                let r = modulus(&mut random, family);
                let mut swept = sweep.near.compare(r);
                if let Swept::Agree(pairs) = swept {
                    tally.swept += 1;
                    tally.pairs += pairs;
                } else if swept == Swept::Open {
                    if !std::mem::replace(&mut turned, true) {
                        sweep.closer.turn(s);
                    }
                    swept = sweep.closer.compare(r);
                    if let Swept::Agree(pairs) = swept {
                        tally.closer += 1;
                        tally.pairs += pairs;
                    }
                }
                let repeated = random.bits() >> 11 < threshold;
                if swept != Swept::Differ && swept != Swept::Open && !repeated {
                    continue;
                }
                tally.repeated += u64::from(repeated);
                let begun = thread_seconds();
                let case = dyadic(self.last.min(EXACT_LAST) as usize, r, s);
                for _ in 0..u32::from(!matches!(swept, Swept::Agree(_))) + u32::from(repeated) {
                    let decided = one_point(ladder, case.clone(), &mut tally);
                    if swept == Swept::Differ && decided != Comparison::Differ && tally.faults.is_empty() {
                        tally.faults.push(format!(
                            "a sweep's word and the definition differ, the exact routes do not: {case}"
                        ));
                    }
                }
                exact += thread_seconds() - begun;
                // After an error of ours the rest of the unit says nothing.
                if !tally.faults.is_empty() {
                    return Some(tally);
                }
            }
        }
        tally.sweep_seconds = thread_seconds() - start - exact;
        let start = thread_seconds();
        if unit.is_multiple_of(SELDOM) {
            for _ in 0..WEIGHTED {
                monitor.advance(0).ok()?;
                if let Some(mut case) = weighted::case(&mut random, ladder, 3..=24) {
                    tally.weighted += 1;
                    case.n = case.n.clamp(12, self.last.clamp(12, EXACT_LAST));
                    one_point(ladder, case, &mut tally);
                }
            }
            for _ in 0..WORDS {
                monitor.advance(0).ok()?;
                entropies(&mut random, &mut tally);
            }
        }
        tally.other_seconds = thread_seconds() - start + exact;
        Some(tally)
    }
}

/// Decides one point exactly and counts it.
fn one_point(ladder: &Ladder, case: Instance, tally: &mut WordTally) -> Comparison {
    let comparison = compare(ladder, &case, WordStatement::True);
    match comparison {
        Comparison::Agree => tally.exact += 1,
        Comparison::Boundary => tally.boundary += 1,
        Comparison::Undecided => tally.undecided += 1,
        Comparison::Differ => {
            // The first is enough to be made simple.
            let case =
                if tally.disagreements.is_empty() { shrink(ladder, case, WordStatement::True) } else { case };
            tally.disagreements.push(format!("words {case}"));
        }
    }
    comparison
}

/// The first of `most` weighted points of a seed that refutes a statement, shrunk. Cost: at most `most`
/// points, each with O(n²) signs for n up to 24, and the shrinking of one.
pub fn refute_words(statement: WordStatement, seed: u64, most: u64) -> Option<Instance> {
    let ladder = Ladder::default();
    let mut random = Random::of_unit(seed, 0);
    (0..most)
        .filter_map(|_| weighted::case(&mut random, &ladder, 3..=24))
        .find(|case| differ(&ladder, case, statement))
        .map(|case| shrink(&ladder, case, statement))
}
