//! What every fuzzing has in common: units of cases, each drawn from the seed and its own number alone, so
//! that a run is the same whatever the number of threads, can be ended after any unit and gone on with.

use std::ops::Range;

use rayon::prelude::*;
use serde::{Serialize, de::DeserializeOwned};

use crate::{
    error::{Error, Result},
    local::Ladder,
    monitor::Monitor,
    processor::Stopwatch,
    profile::Profile,
};

/// What a run has come to so far.
pub trait Tally: Clone + Default + PartialEq + Send + Sync + Serialize + DeserializeOwned {
    /// The number of units done: the run goes on from here.
    fn units(&self) -> u64;

    /// The number of cases decided both ways, boundaries included.
    fn decided(&self) -> u64;

    /// Cases left undecided.
    fn undecided(&self) -> u64;

    /// Confirmed disagreements, shrunk, as lines of a regression file.
    fn disagreements(&self) -> &[String];

    /// Errors of this program: what two routes to one answer differ in, and the case.
    fn faults(&self) -> &[String];

    /// This with one more unit.
    fn merge(self, other: Self) -> Self;
}

/// The most units of a run: far more than any machine does, and few enough for every sum of counts.
const MOST_UNITS: u64 = 1 << 40;

/// What to fuzz, and how far.
pub trait Campaign: Serialize + Sync {
    /// What a run comes to.
    type Tally: Tally;
    /// What a thread needs for its units.
    type Sweep: Clone + Send + Sync;
    /// The most units between two checkpoints.
    const CHUNK: u64;
    /// The largest period that can be fuzzed.
    const LONGEST: u64;

    /// The largest period fuzzed.
    fn last(&self) -> u64;

    /// The cases wanted.
    fn cases(&self) -> u64;

    /// The cases of one unit, but for a few more: a run is whole units.
    fn block(&self) -> u64;

    /// The units of the whole run: as few as have the cases wanted.
    fn units(&self) -> u64 {
        self.cases().div_ceil(self.block())
    }

    /// All that a tally depends on but for the number of cases, written so that equal runs give equal texts.
    fn canonical(&self) -> String;

    /// What is wrong with the counts of a tally of at most 2⁴⁰ units, if no run comes to them.
    ///
    /// # Errors
    /// What that is, in words.
    fn check_counts(&self, tally: &Self::Tally) -> std::result::Result<(), &'static str>;

    /// Whether a line of a tally's disagreements is one: decided again.
    ///
    /// # Errors
    /// An input error if it is no case.
    fn differs(&self, line: &str) -> Result<bool>;

    /// Whether there is such a run.
    ///
    /// # Errors
    /// An input error that says which option is out of range.
    fn check_range(&self) -> Result<()> {
        if !(3..=Self::LONGEST).contains(&self.last()) || self.block() == 0 {
            return Err(Error::input(format!(
                "the largest period is {}: from 3 to {}, and no smaller than the first",
                self.last(),
                Self::LONGEST
            )));
        }
        if self.cases() == 0 {
            return Err(Error::input("the number of cases is 0: give at least 1"));
        }
        if self.units() > MOST_UNITS {
            return Err(Error::input(format!(
                "{} cases are too many: at most {}",
                self.cases(),
                MOST_UNITS.saturating_mul(self.block())
            )));
        }
        Ok(())
    }

    /// Whether a run with these options can have come to a tally, disagreements decided again.
    ///
    /// # Errors
    /// An input error if the options are out of range, or one that says what cannot be.
    fn check(&self, tally: &Self::Tally) -> Result<()> {
        self.check_range()?;
        let bad = |what: &str| Error::input(format!("no run can give this tally: {what}"));
        if tally.units() > MOST_UNITS {
            return Err(bad("the number of units"));
        }
        self.check_counts(tally).map_err(bad)?;
        for line in tally.disagreements() {
            if !self.differs(line)? {
                return Err(bad(&format!("{line} is no disagreement")));
            }
        }
        Ok(())
    }

    /// What each thread begins with.
    fn sweep(&self) -> Self::Sweep;

    /// One unit; none if the monitor ends it.
    fn unit(
        &self,
        ladder: &Ladder,
        sweep: &mut Self::Sweep,
        unit: u64,
        monitor: &dyn Monitor,
    ) -> Option<Self::Tally>;
}

/// Does the units in `range`, of which `tally` has the first ones, until the last is done or the monitor
/// interrupts; `checkpoint` sees every state from which the run can go on. Ends early once a disagreement or
/// an error of this program is found. Cost: that of the units, on all threads; memory: the tallies of a chunk
/// of units.
///
/// # Errors
/// An input error if the options are out of range, or `tally` cannot be of such a run; whatever `checkpoint`
/// returns.
pub fn fuzz<C: Campaign>(
    campaign: &C,
    range: Range<u64>,
    mut tally: C::Tally,
    monitor: &dyn Monitor,
    mut checkpoint: impl FnMut(&C::Tally) -> Result<()>,
) -> Result<C::Tally> {
    campaign.check(&tally)?;
    let profile = monitor.profile();
    let (ladder, sweep) = (Ladder::default().with_profile(profile.clone()), campaign.sweep());
    let before_all = profile.as_ref().map(|profile| profile.total());
    let whole = Profile::default();
    while range.start + tally.units() < range.end
        && tally.disagreements().is_empty()
        && tally.faults().is_empty()
    {
        let first = range.start + tally.units();
        let last = range.end.min(first + C::CHUNK);
        let units: Vec<Option<C::Tally>> = (first..last)
            .into_par_iter()
            .map_with(sweep.clone(), |sweep, unit| {
                monitor.advance(0).ok()?;
                let start = profile.as_ref().map(|_| Stopwatch::start());
                let found = campaign.unit(&ladder, sweep, unit, monitor);
                if let Some(start) = start {
                    whole.since(start, "unit", found.as_ref().map_or(0, Tally::decided));
                }
                found
            })
            .collect();
        // Whole units in their order, up to the first that was given up.
        let before = tally.decided();
        tally = units.iter().cloned().map_while(|unit| unit).fold(tally, C::Tally::merge);
        checkpoint(&tally)?;
        if monitor.advance(tally.decided() - before).is_err() || units.contains(&None) {
            break;
        }
    }
    if let Some((profile, before)) = profile.zip(before_all) {
        // What the ladder's signs did not take: sweeps of whole cases, by far the most of it.
        let (all, signs) = (whole.total(), profile.total().time - before.time);
        profile.add("sweeps in f64", all.cases, all.time.saturating_sub(signs));
    }
    Ok(tally)
}
