//! Cells with their returns as a graph, and weights by which every arc of it grows: the least mean of its
//! cycles, by the potential that Bellman and Ford's method finds where no cycle is below what is asked for.

use super::returns::{RETURNS, Return, Returns};
use crate::chaos::span::Span;

/// What an arc must grow by at least: a number, and so much for each of its periods.
#[derive(Debug, Clone, Copy)]
pub(super) struct Asked {
    pub impact: f64,
    pub period: f64,
}

impl Asked {
    fn of(self, periods: u64) -> f64 {
        self.impact.max(self.period * periods as f64)
    }
}

/// Cells up to these ends, and their returns.
pub(super) struct Graph {
    pub ends: Vec<f64>,
    /// With by how many periods all are back.
    returns: Vec<(Vec<Return>, u64)>,
}

/// After how many sweeps a cycle is looked for, and how many there are.
const LOOKED: usize = 8;
const SWEEPS: usize = 4000;
/// Below such a change a potential is the same.
const SAME: f64 = 1e-12;
/// No cell that is a smaller part of all is cut.
const SMALLEST: f64 = 1e-5;

/// A number that a certificate's decimals hold.
fn rounded(x: f64) -> f64 {
    (x * 1e9).round() / 1e9
}

impl Graph {
    /// So many cells of one width; none where returns may be too late.
    pub fn new(returns: &Returns, speed: f64, number: usize) -> Option<Graph> {
        let end = |i: usize| if i == number { speed } else { rounded(speed * i as f64 / number as f64) };
        let ends: Vec<f64> = (1..=number).map(end).collect();
        let cells = (0..number).map(|i| Span::new(end(i), end(i + 1)));
        let returns = cells.map(|cell| returns.of(cell)).collect::<Option<_>>()?;
        Some(Graph { ends, returns })
    }

    fn start(&self, i: usize) -> f64 {
        if i == 0 { 0.0 } else { self.ends[i - 1] }
    }

    /// Those cells cut in two; none if no cell is large enough.
    pub fn cut(&self, returns: &Returns, cells: &[usize]) -> Option<Graph> {
        let mut found = Graph { ends: Vec::new(), returns: Vec::new() };
        let least = SMALLEST * self.ends.last()?;
        for i in 0..self.ends.len() {
            let (start, end) = (self.start(i), self.ends[i]);
            if !cells.contains(&i) || end - start < least {
                found.ends.push(end);
                found.returns.push(self.returns[i].clone());
                continue;
            }
            let middle = rounded(0.5 * (start + end));
            found.ends.extend([middle, end]);
            found.returns.push(returns.of(Span::new(start, middle))?);
            found.returns.push(returns.of(Span::new(middle, end))?);
        }
        (found.ends.len() > self.ends.len()).then_some(found)
    }

    /// From which cell to which last one a return may lead.
    fn targets(&self, next: &Return) -> std::ops::RangeInclusive<usize> {
        let last = self.ends.len() - 1;
        let of = |x: f64| self.ends.partition_point(|end| *end < x).min(last);
        of(next.speed.lo)..=of(next.speed.hi)
    }

    /// A potential by which every arc grows as asked, or the cells of a cycle that does not.
    pub fn potential(&self, asked: Asked) -> Result<Vec<f64>, Vec<usize>> {
        let number = self.ends.len();
        let arcs = |all: &Vec<Return>| -> Vec<_> {
            all.iter().map(|next| (next.growth - asked.of(next.periods), self.targets(next))).collect()
        };
        let arcs: Vec<Vec<_>> = self.returns.iter().map(|(all, _)| arcs(all)).collect();
        let mut potential = vec![0.0f64; number];
        let mut next = vec![usize::MAX; number];
        for sweep in 1..=SWEEPS {
            let mut settled = true;
            for i in (0..number).rev() {
                for (growth, targets) in &arcs[i] {
                    for j in targets.clone() {
                        if growth + potential[j] < potential[i] - SAME {
                            (potential[i], next[i], settled) = (growth + potential[j], j, false);
                        }
                    }
                }
            }
            if settled {
                return Ok(potential);
            }
            if sweep % LOOKED == 0 {
                let cycles = cycles(&next);
                if !cycles.is_empty() {
                    return Err(cycles);
                }
            }
        }
        Err(Vec::new())
    }

    /// The most that can be asked for between two such numbers by halving, of which the first can.
    pub fn most(&self, asked: impl Fn(f64) -> Asked, [mut lo, mut hi]: [f64; 2]) -> f64 {
        const HALVINGS: u32 = 10;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (lo + hi);
            if self.potential(asked(middle)).is_ok() { lo = middle } else { hi = middle }
        }
        lo
    }

    /// What each impact and each period grow by at least, by these weights.
    pub fn growth(&self, weights: &[u64]) -> Asked {
        let mut least = Asked { impact: f64::INFINITY, period: f64::INFINITY };
        for (i, (all, _)) in self.returns.iter().enumerate() {
            for next in all {
                let lightest = self.targets(next).map(|j| weights[j]).min().unwrap_or(1);
                let growth = next.growth + (lightest as f64 / weights[i] as f64).ln();
                least.impact = least.impact.min(growth);
                least.period = least.period.min(growth / next.periods as f64);
            }
        }
        least
    }

    /// By how many periods all are back, as a certificate lists it: one more, for other enclosures.
    pub fn listed(&self) -> u64 {
        let last = self.returns.iter().map(|(_, last)| *last).max().unwrap_or(1);
        (last + 1).min(RETURNS)
    }
}

/// The numbers on cycles of a map, of which those without an image are none.
fn cycles(next: &[usize]) -> Vec<usize> {
    let mut seen = vec![usize::MAX; next.len()];
    let mut all = Vec::new();
    for first in 0..next.len() {
        let (mut path, mut at) = (Vec::new(), first);
        while at != usize::MAX && seen[at] == usize::MAX {
            seen[at] = first;
            path.push(at);
            at = next[at];
        }
        if at != usize::MAX && seen[at] == first {
            all.extend(path.iter().skip_while(|i| **i != at));
        }
    }
    all
}
