//! Two dimensions: each X_i is the single-impact X of its n_i, and which n_{i+1} may follow n_i is a matter
//! of the pair (64).

use num_bigint::BigUint;
use num_rational::BigRational;

use super::{
    Coordinates, Failure, Map, PatternOrbit, Report, Scalar, Value,
    existence::{PatternExistence, PatternQuantity, Tally, factor, flat, range},
    matrix::dot,
};
use crate::{
    error::{Error, Result},
    number::{Ball, Precision, Sign},
    word::ClosedWalks,
};

/// The largest period of a graph: its P² edges are computed exactly.
pub const MAX_GRAPH_PERIOD: u64 = 400;

/// Bits for maps given by intervals.
const BITS: u32 = 256;

/// The periods 1, …, P of a two-dimensional map, what each allows, and which may follow which.
///
/// Signs are exact if the map is; otherwise they are certain or unknown.
#[derive(Debug, Clone)]
pub struct Graph {
    e: Option<Sign>,
    nodes: Vec<Option<Node>>,
    flat: Vec<bool>,
    /// `steps[i][j]`: Y of an impact between periods i + 1 and j + 1; `None` if one of them is singular.
    steps: Vec<Vec<Option<Step>>>,
    singular: Vec<Failure>,
    /// What is born of one impact where that is singular, if it is known.
    resonances: Vec<Option<Report>>,
}

/// The patterns of one period by what Theorem 1 says of them.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct PatternTally {
    /// Σ n_i.
    pub period: u64,
    /// All of them, up to rotation.
    pub patterns: BigUint,
    /// Those with an orbit for eµ > 0.
    pub plus: BigUint,
    /// Those with an orbit for eµ < 0.
    pub minus: BigUint,
    /// Those with an orbit for neither.
    pub neither: BigUint,
    /// Those of which a sign is zero or not known.
    pub undecided: BigUint,
}

#[derive(Debug, Clone)]
struct Node {
    x: Vec<Value>,
    tally: Tally,
    gaps: Option<[Value; 2]>,
}

#[derive(Debug, Clone)]
struct Step {
    y: Value,
    sign: Option<Sign>,
    leading: Option<Value>,
    leading_sign: Option<Sign>,
}

impl Graph {
    /// The graph on the periods 1, …, `last`. Cost: O(`last`²) operations, on exact numbers of O(`last`)
    /// times the bits of the map's. `exact` keeps the numbers exact as well as their signs.
    ///
    /// # Errors
    /// An input error unless N = 2 and 1 ≤ `last` ≤ [`MAX_GRAPH_PERIOD`].
    pub fn new(map: &Map, last: u64, exact: bool) -> Result<Graph> {
        if map.dimension() != 2 {
            return Err(Error::input(format!("the pattern graph needs N = 2; here N = {}", map.dimension())));
        }
        if !(1..=MAX_GRAPH_PERIOD).contains(&last) {
            return Err(Error::input(format!(
                "--max-period {last}: the pattern graph has periods 1 to {MAX_GRAPH_PERIOD}"
            )));
        }
        let e = map.e().sign();
        match Coordinates::<BigRational>::new(map, last, ()) {
            Some(coordinates) => {
                let mut graph = Self::build(&coordinates, last, exact, e);
                graph.resonances = (1..=last).map(|n| map.at_resonance(n)).collect();
                Ok(graph)
            }
            None => match Coordinates::<Ball>::new(map, last, Precision::new(BITS)) {
                Some(coordinates) => {
                    let mut graph = Self::build(&coordinates, last, false, e);
                    let near =
                        |n: u64| graph.nodes[n as usize - 1].is_none().then(|| map.near_resonance(n))?;
                    graph.resonances = (1..=last).map(near).collect();
                    Ok(graph)
                }
                None => Err(Error::input("the map cannot be enclosed")),
            },
        }
    }

    fn build<T: Scalar>(map: &Coordinates<T>, last: u64, exact: bool, e: Option<Sign>) -> Graph {
        let show = |x: &T| if exact { x.value() } else { Value::Enclosed(x.enclosure()) };
        let zero = T::integer(0, map.context());
        let one = T::integer(1, map.context());
        // X = (−1, ξ) from C Aⁿ X = −1: (57), (58).
        let x: Vec<Option<[T; 2]>> = (1..=last)
            .map(|n| {
                let row = map.power(n).row(0);
                row[1].pivot()?;
                Some([-one.clone(), (row[0].clone() - &one) / &row[1]])
            })
            .collect();
        let node = |n: u64, x: &[T; 2]| {
            let gaps: Vec<T> = (1..n).map(|k| dot(map.power(k).row(0), x, &zero) + &one).collect();
            let mut tally = Tally::default();
            for (gap, k) in gaps.iter().zip(1..) {
                tally.add(gap.sign(), PatternQuantity { i: 0, k });
            }
            let shown = range(gaps.iter().map(show));
            Node { x: map.original(x).iter().map(show).collect(), tally, gaps: shown }
        };
        let step = |n: u64, from: &[T; 2], to: &[T; 2]| {
            let y = to[1].clone() - &dot(map.power(n).row(1), from, &zero);
            let leading = factor(map, n, &y);
            let leading_sign = leading.as_ref().and_then(T::sign);
            Step { y: show(&y), sign: y.sign(), leading: leading.as_ref().map(show), leading_sign }
        };
        let periods = || (1..=last).zip(&x);
        Graph {
            e,
            nodes: periods().map(|(n, x)| x.as_ref().map(|x| node(n, x))).collect(),
            flat: (1..=last).map(|n| flat(map, &[n]).is_some()).collect(),
            steps: periods()
                .map(|(n, from)| x.iter().map(|to| Some(step(n, from.as_ref()?, to.as_ref()?))).collect())
                .collect(),
            singular: (1..=last)
                .map(|n| {
                    if map.response(n).sign() == Some(Sign::Zero) {
                        Failure::Singular
                    } else {
                        Failure::Unknown
                    }
                })
                .collect(),
            resonances: Vec::new(),
        }
    }

    /// P.
    pub(crate) fn last(&self) -> u64 {
        self.nodes.len() as u64
    }

    /// What (52) says of the period n for a sign of eµ.
    pub(crate) fn node(&self, n: u64, positive: bool) -> PatternExistence {
        self.nodes[n as usize - 1].as_ref().map_or(PatternExistence::Open, |node| node.tally.side(positive))
    }

    /// What (52) for both periods and (64) say of an impact between the periods `from` and `to`, for a sign
    /// of eµ. Cost: O(1).
    pub(crate) fn edge(&self, from: u64, to: u64, positive: bool) -> PatternExistence {
        let (Some(a), Some(b), Some(step)) = (
            &self.nodes[from as usize - 1],
            &self.nodes[to as usize - 1],
            &self.steps[from as usize - 1][to as usize - 1],
        ) else {
            return PatternExistence::Open;
        };
        let mut tally = a.tally;
        tally.merge(&b.tally, 0);
        tally.add(step.sign, PatternQuantity { i: 0, k: 0 });
        tally.side(positive)
    }

    /// Whether some pattern in which `to` follows `from` may exist: what patterns are pruned by.
    pub fn may_follow(&self, from: u64, to: u64) -> bool {
        [true, false].iter().any(|&side| self.edge(from, to, side) != PatternExistence::NoOrbit)
    }

    /// Theorem 1 for a pattern of periods ≤ P: the same answer as
    /// [`Analysis::judge`](super::Analysis::judge). Cost: O(m).
    pub fn judge(&self, periods: &[u64]) -> Report {
        let m = periods.len();
        let index = |i: usize| periods[i % m] as usize - 1;
        let flat = periods.iter().copied().find(|&n| self.flat[n as usize - 1]);
        let nodes: Option<Vec<&Node>> = (0..m).map(|i| self.nodes[index(i)].as_ref()).collect();
        let steps: Option<Vec<&Step>> = (0..m).map(|i| self.steps[index(i)][index(i + 1)].as_ref()).collect();
        let (Some(nodes), Some(steps)) = (nodes, steps) else {
            if let Some(report) = self.resonance(periods) {
                return report.clone();
            }
            let singular = (0..m).any(|i| self.singular[index(i)] == Failure::Singular);
            let failure = if singular { Failure::Singular } else { Failure::Unknown };
            return Report::unsolved(failure, flat, self.e);
        };
        let mut tally = Tally::default();
        for (i, (node, step)) in nodes.iter().zip(&steps).enumerate() {
            tally.merge(&node.tally, i + 1);
            tally.add(step.sign, PatternQuantity { i: i + 1, k: 0 });
        }
        let ends = nodes.iter().filter_map(|node| node.gaps.clone()).flatten();
        let signs = steps.iter().try_fold(Sign::Positive, |product, step| Some(product * step.leading_sign?));
        let leading = steps.iter().map(|step| step.leading.clone()).collect::<Option<Vec<_>>>();
        let orbit = PatternOrbit {
            x: nodes.iter().map(|node| node.x.clone()).collect(),
            y: steps.iter().map(|step| step.y.clone()).collect(),
            gaps: range(ends),
            impacts: range(steps.iter().map(|step| step.y.clone()))
                .unwrap_or_else(|| [steps[0].y.clone(), steps[0].y.clone()]),
            leading: leading.and_then(|all| all.into_iter().reduce(Value::times)),
            leading_sign: signs,
        };
        tally.report(self.e, flat, orbit)
    }

    /// The closed walks of the periods ≤ `last` by their certain edges for a sign of eµ; open ones are left
    /// out. Cost: O(V² C), V = `last`, C ≤ V classes of periods that follow alike; memory: V² edges.
    pub fn walks(&self, positive: bool, last: u64) -> ClosedWalks {
        self.closed_walks(last, |from, to| self.edge(from, to, positive) == PatternExistence::Orbit)
    }

    fn closed_walks(&self, last: u64, follows: impl Fn(u64, u64) -> bool) -> ClosedWalks {
        let periods: Vec<u64> = (1..=last.min(self.last())).collect();
        let rows: Vec<Vec<bool>> =
            periods.iter().map(|&i| periods.iter().map(|&j| follows(i, j)).collect()).collect();
        ClosedWalks::from_edges(&periods, &rows)
    }

    /// What is born of one impact at a resonance.
    fn resonance(&self, periods: &[u64]) -> Option<&Report> {
        let &[n] = periods else { return None };
        self.resonances.get(n as usize - 1)?.as_ref()
    }

    /// What [`judge`](Graph::judge) says of all patterns of period 1, …, P, counted without listing one.
    ///
    /// A pattern is open if no edge of it is certainly absent and one is open, or if one of its periods is
    /// singular, but for one impact at a resonance that decides. Cost: O(P²) edges and, with C ≤ P classes of
    /// periods that follow alike, O(C³P²) products of integers of O(P) bits.
    pub fn tallies(&self) -> Vec<PatternTally> {
        let last = self.last();
        let solved = |n: u64| self.nodes[n as usize - 1].is_some();
        let regular = |i: u64, j: u64| solved(i) && solved(j);
        let count = |follows: &dyn Fn(u64, u64) -> bool| {
            self.closed_walks(last, follows)
                .count(last)
                .into_iter()
                .map(|row| row.all)
                .collect::<Vec<BigUint>>()
        };
        let certain = |side| move |i, j| regular(i, j) && self.edge(i, j, side) == PatternExistence::Orbit;
        let possible = |side| move |i, j| regular(i, j) && self.edge(i, j, side) != PatternExistence::NoOrbit;
        let [plus, minus] = [true, false].map(|side| count(&certain(side)));
        let [perhaps_plus, perhaps_minus] = [true, false].map(|side| count(&possible(side)));
        let both = count(&|i, j| possible(true)(i, j) && possible(false)(i, j));
        let (all, solvable) = (count(&|_, _| true), count(&regular));
        (0..last as usize)
            .map(|n| {
                let existing = &plus[n] + &minus[n];
                let perhaps = &perhaps_plus[n] + &perhaps_minus[n] - &both[n];
                let decided = self.resonance(&[n as u64 + 1]).is_some_and(|report| !report.is_open());
                let silent = &all[n] - &solvable[n] - u32::from(decided);
                let undecided = silent + perhaps - &existing;
                PatternTally {
                    period: n as u64 + 1,
                    neither: &all[n] - &existing - &undecided,
                    patterns: all[n].clone(),
                    plus: plus[n].clone(),
                    minus: minus[n].clone(),
                    undecided,
                }
            })
            .collect()
    }

    /// Graphviz: the periods that occur and who may follow whom, orange for eµ > 0, blue for eµ < 0, dashed
    /// if open. Cost: O(P²), as is the length of the text.
    pub fn to_dot(&self) -> String {
        let mut text = String::from(
            "// Which period may follow which: closed walks of one colour are the impact patterns that exist.\n\
             // orange: e mu > 0, blue: e mu < 0, dashed: open (a quantity is 0 or not known)\n\
             digraph patterns {\n  node [shape=circle];\n",
        );
        for n in 1..=self.last() {
            if [true, false].iter().any(|&side| self.node(n, side) != PatternExistence::NoOrbit) {
                text += &format!("  {n};\n");
            }
        }
        for from in 1..=self.last() {
            for to in 1..=self.last() {
                for (side, colour) in [(true, "#E69F00"), (false, "#0072B2")] {
                    let style = match self.edge(from, to, side) {
                        PatternExistence::Orbit => "",
                        PatternExistence::Open => ", style=dashed",
                        PatternExistence::NoOrbit => continue,
                    };
                    text += &format!("  {from} -> {to} [color=\"{colour}\"{style}];\n");
                }
            }
        }
        text + "}\n"
    }
}
