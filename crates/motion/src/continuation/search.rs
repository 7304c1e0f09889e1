//! A search for all orbits of a pattern from many starts, and what came of each: the same in both engines.
//!
//! Newton's method goes from every start. Then it goes again from some of those that led to what is known,
//! with all that is known taken out of the equations (`Known`), until that finds nothing further: so "these
//! are all" says more than that no start happened to lead elsewhere. It proves nothing.
//!
//! A search has a scale: starts are as fast as motions of the size of what is struck, and Newton's method
//! goes at most 60 of these sizes on. And it has an end: a period that takes too many steps to follow is
//! given up, and counted.

use rayon::prelude::*;
use serde::Serialize;

use crate::error::Result;

/// Starts between two looks at whether to go on.
const CHUNK: usize = 16;

/// Starts that are tried again with what is known taken out.
const AGAIN: usize = 16;

/// Most such rounds.
const ROUNDS: u32 = 8;

/// Closer than this, in radians and relative to the largest speed or the size of the motion, two solutions
/// are one.
pub const NEAR: f64 = 1e-7;

/// What came of the starts of a search: `starts` is the sum of what the first round found, `again`, `others`,
/// `endless` and `lost`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct SearchTally {
    /// Starts of Newton's method.
    pub starts: u32,
    /// Those that led to an orbit that another one had led to.
    pub again: u32,
    /// Those that led to a solution that is none of the pattern: it goes round a shorter one, or an impact
    /// has no speed or comes from behind.
    pub others: u32,
    /// Those from which a motion took too many steps to follow.
    pub endless: u32,
    /// Those from which the iterates did not settle, or came to where the equations cannot be followed.
    pub lost: u32,
    /// Starts that were asked for and not made: the first ones were all lost, and a motion takes too many
    /// steps.
    pub unmade: u32,
    /// Orbits found where what was known had been taken out.
    pub further: u32,
    /// Starts of the last round of that, which found nothing; 0 if all rounds found something.
    pub deflated: u32,
}

impl SearchTally {
    /// In words.
    pub fn told(&self) -> String {
        let SearchTally { starts, again, others, endless, lost, unmade, further, deflated } = *self;
        let parts = [
            (again, "came to an orbit again"),
            (others, "came to a solution that is none of the pattern"),
            (endless, "took too many steps"),
            (lost, "did not settle"),
            (unmade, "more were not made: a forcing period takes too many steps"),
            (further, "further orbits were found with the known ones taken out"),
            (deflated, "were tried with all taken out, and led to no further one"),
        ];
        let parts = parts.iter().filter(|part| part.0 > 0).map(|(count, what)| format!(", {count} {what}"));
        let open = starts > 1 && starts > endless + lost && deflated == 0;
        let open =
            if open { ", and each round with the known ones taken out led to another solution" } else { "" };
        format!("{starts} starts{}{open}", parts.collect::<String>())
    }
}

/// What a search found.
#[derive(Debug, Clone)]
pub struct OrbitSearch<O> {
    /// Each once.
    pub found: Vec<O>,
    /// What came of the starts.
    pub tally: SearchTally,
}

impl<O> OrbitSearch<O> {
    /// What one start led to.
    pub fn of_one(found: Result<O>) -> OrbitSearch<O> {
        let lost = u32::from(found.is_err());
        OrbitSearch {
            found: found.into_iter().collect(),
            tally: SearchTally { starts: 1, lost, ..SearchTally::default() },
        }
    }
}

/// Searches from `starts` starts. `look` goes from the i-th, the solutions it is given taken out; `alike`
/// tells whether two solutions are one, `whole` whether one is an orbit of the pattern, `hopeless`, asked
/// where the first 16 starts lead nowhere, whether the others would not, either: then they are not made;
/// `check` whether to go on. Cost: that of `look` for each start and for at most 16 of them up to 8 times,
/// shared by the threads.
///
/// # Errors
/// Those of `whole` and `check`; an interruption.
pub fn search_all<O: Send + Sync>(
    starts: u32,
    look: impl Fn(u32, &[O]) -> Result<O> + Sync,
    alike: impl Fn(&O, &O) -> bool,
    whole: impl Fn(&O) -> Result<bool>,
    hopeless: impl Fn() -> bool,
    check: impl Fn() -> Result<()>,
) -> Result<OrbitSearch<O>> {
    let (mut tally, mut roots, mut orbits) =
        (SearchTally { starts, ..SearchTally::default() }, Vec::new(), Vec::new());
    let round =
        |all: &[u32], known: &[O]| -> Vec<Result<O>> { all.par_iter().map(|&i| look(i, known)).collect() };
    // Where a solution is known, and whether it is an orbit; or that it is new.
    let place = |orbit: &O, roots: &[O]| roots.iter().position(|known| alike(known, orbit));
    let mut led = Vec::new();
    for first in (0..starts).step_by(CHUNK) {
        check()?;
        if first == CHUNK as u32 && led.is_empty() && hopeless() {
            (tally.starts, tally.unmade) = (first, starts - first);
            break;
        }
        let chunk: Vec<u32> = (first..first.saturating_add(CHUNK as u32).min(starts)).collect();
        for (&i, end) in chunk.iter().zip(round(&chunk, &[])) {
            let orbit = match end {
                Ok(orbit) => orbit,
                Err(error) if error.is_interrupted() => return Err(error),
                Err(error) => {
                    *if error.is_limit() { &mut tally.endless } else { &mut tally.lost } += 1;
                    continue;
                }
            };
            led.push(i);
            match place(&orbit, &roots) {
                Some(known) => *if orbits[known] { &mut tally.again } else { &mut tally.others } += 1,
                None => {
                    let is = whole(&orbit)?;
                    tally.others += u32::from(!is);
                    orbits.push(is);
                    roots.push(orbit);
                }
            }
        }
    }
    // Evenly of all that led somewhere.
    let apart = led.len().div_ceil(AGAIN).max(1);
    let chosen: Vec<u32> = led.into_iter().step_by(apart).collect();
    for _ in 0..ROUNDS {
        check()?;
        let before = roots.len();
        for orbit in round(&chosen, &roots).into_iter().flatten() {
            if place(&orbit, &roots).is_none() {
                let is = whole(&orbit)?;
                tally.further += u32::from(is);
                orbits.push(is);
                roots.push(orbit);
            }
        }
        if roots.len() == before {
            tally.deflated = chosen.len() as u32;
            break;
        }
    }
    let found = roots.into_iter().zip(orbits).filter_map(|(orbit, is)| is.then_some(orbit)).collect();
    Ok(OrbitSearch { found, tally })
}

/// Solutions of pattern equations that Newton's method is to keep away from: F is multiplied by the product
/// of 1 + 1/d², d being the distance to each, so that it does not vanish there (deflation).
#[derive(Debug, Clone, Default)]
pub(crate) struct Known {
    /// Where among the unknowns those begin that count.
    from: usize,
    /// How many of them an impact has, the first its time: 2 with its speed, 1 without, 0 if there is none.
    each: usize,
    points: Vec<Vec<f64>>,
}

impl Known {
    /// Of solutions whose unknowns are, from `from` on, times in radians and speeds of `impacts` impacts; of
    /// 0, all else. A solution of several impacts is one with each of them called the first.
    pub fn new(from: usize, impacts: usize, solutions: impl Iterator<Item = Vec<f64>>) -> Known {
        let (from, each) = if impacts > 0 { (from, 2) } else { (0, 0) };
        let turned = |z: Vec<f64>| {
            let own = z[from..].to_vec();
            (0..impacts.max(1)).map(move |shift| [&own[each * shift..], &own[..each * shift]].concat())
        };
        Known { from, each, points: solutions.flat_map(turned).collect() }
    }

    /// By the times alone, which are then all unknowns.
    pub fn of_times(impacts: usize, solutions: impl Iterator<Item = Vec<f64>>) -> Known {
        let points = Known::new(0, impacts, solutions).points.into_iter();
        let times = |point: Vec<f64>| point.into_iter().step_by(2).collect();
        Known { from: 0, each: 1, points: points.map(times).collect() }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// The factor, and the derivative of its logarithm along a step.
    pub fn factor(&self, z: &[f64], step: &[f64]) -> (f64, f64) {
        let (mut factor, mut slope) = (1.0, 0.0);
        for point in &self.points {
            let (mut apart, mut along) = (0.0, 0.0);
            for (k, known) in point.iter().enumerate() {
                let (by, step) = (z[self.from + k] - known, step[self.from + k]);
                // A time that is a period later is the same.
                let (square, half) = match self.each > 0 && k.is_multiple_of(self.each) {
                    true => (2.0 * (1.0 - by.cos()), by.sin()),
                    false => (by * by, by),
                };
                apart += square;
                along += 2.0 * half * step;
            }
            factor *= 1.0 + 1.0 / apart;
            slope -= along / (apart * (1.0 + apart));
        }
        (factor, slope)
    }
}
