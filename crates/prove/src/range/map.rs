//! The map of proofs/ranges.md over a cell of depths, in spans: F = (1 − m) s + m f at every edge of a graph,
//! with bounds of its derivatives.
//!
//! Plain floats, by the mean-value form about the middles of strengths and depths, as the checker has it.

use std::rc::Rc;

use super::RangeEffort;
use crate::chaos::{
    LetterGraph,
    map::{Cell, Flow, Impact},
    profile::Profile,
    span::Span,
};

/// So many impacts cost as much as a leg.
const IMPACTS: u64 = 8;

/// The graph, edge by edge.
#[derive(Debug, Clone)]
pub(super) struct Edges {
    pub letters: Vec<u64>,
    /// First and second letter.
    pub edges: Vec<[usize; 2]>,
    /// The edges before and after each leg: the edge to a letter, the letter, the edge from it.
    pub legs: Vec<[usize; 3]>,
}

/// An oscillator near a touch.
#[derive(Debug, Clone)]
pub(super) struct Oscillator {
    /// Whether there are two walls, each the other's mirror image.
    pub mirrored: bool,
    /// c, k, τ.
    pub parameters: [Span; 3],
    pub side: f64,
    pub profile: Rc<Profile>,
}

/// A leg's velocities in the middle of its strengths and depths, and the derivatives of both by s, s′ and ν.
#[derive(Clone)]
struct Leg {
    middle: [Span; 2],
    after: [Span; 3],
    before: [Span; 3],
}

/// A velocity at an impact: in the middle, its slope by the impact's own s, how far it moves else, and the
/// neighbouring edge with the greatest slope by its s.
#[derive(Clone)]
struct Term {
    middle: Span,
    own: Span,
    moved: Span,
    other: usize,
    slope: f64,
}

/// Depths, with E over any number of periods.
pub(super) struct Depths {
    cell: Cell,
    centre: Cell,
    turns: Vec<Flow>,
}

/// What the map does on an edge.
#[derive(Debug, Clone)]
pub(super) struct Image {
    /// Where F takes the strengths, over all neighbours.
    pub strengths: Span,
    /// f_s, over all neighbours.
    pub own: Span,
    /// The greatest |f_s⁻| and |f_s⁺| for each neighbouring edge.
    pub before: Vec<(usize, f64)>,
    pub after: Vec<(usize, f64)>,
}

impl Edges {
    pub fn new(graph: &LetterGraph) -> Edges {
        let letters = graph.letters.clone();
        let all = graph.next.iter().enumerate();
        let edges: Vec<[usize; 2]> = all.flat_map(|(u, next)| next.iter().map(move |&v| [u, v])).collect();
        let of = |end: usize, v: usize| (0..edges.len()).filter(|&e| edges[e][end] == v).collect::<Vec<_>>();
        let mut legs = Vec::new();
        for v in 0..letters.len() {
            let out = of(0, v);
            of(1, v).iter().for_each(|&from| legs.extend(out.iter().map(|&to| [from, v, to])));
        }
        Edges { letters, edges, legs }
    }

    /// No edges.
    pub fn none() -> Edges {
        Edges { letters: Vec::new(), edges: Vec::new(), legs: Vec::new() }
    }
}

impl Oscillator {
    fn cell(&self, depth: Span) -> Cell {
        let [damping, stiffness, restitution] = self.parameters;
        let parameters = [damping, stiffness, Span::point(0.0), restitution, depth];
        Cell::new(self.mirrored, parameters, self.side, &self.profile)
    }

    /// Depths from one to another.
    pub fn depths(&self, depth: Span, edges: &Edges) -> Depths {
        let (cell, centre) = (self.cell(depth), self.cell(Span::point(depth.middle())));
        let longest = edges.letters.iter().copied().max().unwrap_or(0);
        let turns = (0..=longest).map(|n| cell.turned(n)).collect();
        Depths { cell, centre, turns }
    }
}

impl Depths {
    /// The trace and the determinant of E over a period, or half period.
    pub fn invariants(&self) -> [Span; 2] {
        self.cell.invariants()
    }

    /// A period, or half period.
    pub fn period(&self) -> f64 {
        self.cell.time(1).middle()
    }

    /// How far from 0 the phases and places of impacts of strengths up to this are.
    pub fn reach(&self, strength: f64) -> Option<[f64; 2]> {
        let impact = self.cell.impact(Span::new(-strength, strength))?;
        Some([impact.phase.magnitude(), impact.place.magnitude()])
    }

    /// The strengths at depth 0 of the impacts of each edge, which do not depend on their neighbours.
    pub fn born(&self, edges: &Edges) -> Option<Vec<f64>> {
        let still = self.cell.impact(Span::point(0.0))?;
        let all = edges.letters.iter().map(|&n| {
            let leg = self.cell.leg(self.turns[n as usize], n, [&still, &still], [&still, &still]);
            (leg.after, leg.before)
        });
        let all: Vec<_> = all.collect();
        let s = |&[u, v]: &[usize; 2]| self.cell.strength(all[v].0, all[u].1).middle();
        let found: Vec<f64> = edges.edges.iter().map(s).collect();
        found.iter().all(|s| s.is_finite()).then_some(found)
    }

    fn leg(&self, periods: u64, [from, to]: [&[Impact; 2]; 2]) -> Leg {
        let (cell, turns) = (&self.cell, self.turns[periods as usize]);
        let e = |from: &Impact, to: &Impact| cell.product(turns, cell.flow(to.phase - from.phase));
        let time = |from: &Impact, to: &Impact| cell.time(periods) + to.phase - from.phase;
        let (whole, inner) = (e(&from[0], &to[0]), e(&from[1], &to[1]));
        let mut before = cell.ends(whole, time(&from[0], &to[0]), &from[0], &to[0])[1];
        let middle = self.centre.ends(inner, time(&from[1], &to[1]), &from[1], &to[1]);
        let slope = |impact: &Impact| -cell.depth.over(impact.bend).times(0.5);
        let once = |impact: &Impact| Span::point(1.0).over(impact.bend);
        let drift = |impact: &Impact| (impact.s * once(impact)).times(-0.5);
        let sink = |impact: &Impact| (impact.s.squared() * (impact.ratio - once(impact))).times(0.25);
        let (t, u) = (slope(&from[0]), slope(&to[0]));
        let (half, last_half) = (from[0].s.times(0.5), to[0].s.times(0.5));
        let longer = drift(&to[0]) - drift(&from[0]);
        let (place, last_place) = (sink(&from[0]), sink(&to[0]));
        let apart = [from[0].s - from[1].s, to[0].s - to[1].s, cell.depth - Span::point(cell.depth.middle())];
        let (velocity, spring) = (cell.velocity(whole), -(cell.stiffness * whole.b));
        let mut slopes = [[Span::point(0.0); 3]; 2];
        for _ in 0..3 {
            let r = cell.acceleration(to[0].place, before);
            let first = (before - whole.a * half).over(whole.b);
            let last = (last_half - before).over(whole.b);
            let deeper = (last_place - whole.a * place - before * longer).over(whole.b);
            slopes = [
                [t * first, u * last, deeper],
                [
                    t * (spring * half + velocity * first - r),
                    u * (velocity * last + r),
                    spring * place + velocity * deeper + r * longer,
                ],
            ];
            let moved = (0..3).fold(middle[1], |sum, i| sum + slopes[1][i] * apart[i]);
            before = before.meet(moved);
        }
        let [after, before] = slopes;
        Leg { middle, after, before }
    }

    /// F of strengths in so many parts, with these factors; none if a phase is out of reach, something is not
    /// bounded, or there is too much to do.
    pub fn image(
        &self,
        edges: &Edges,
        strengths: &[Span],
        factors: &[f64],
        parts: u64,
        effort: &RangeEffort,
    ) -> Option<Vec<Image>> {
        effort.take(strengths.len() as u64 * parts / IMPACTS)?;
        let both = |s: Span| Some([self.cell.impact(s)?, self.centre.impact(Span::point(s.middle()))?]);
        let cut = |s: &Span| (0..parts).map(|i| both(s.part(i, parts))).collect::<Option<Vec<_>>>();
        let impacts: Vec<Vec<[Impact; 2]>> = strengths.iter().map(cut).collect::<Option<_>>()?;
        effort.take(edges.legs.len() as u64 * parts * parts)?;
        let [after, before] = self.terms(edges, &impacts);
        let images = factors.iter().enumerate().map(|(edge, &m)| {
            let [c1, c2] = self.cell.shares;
            let mut image = Image {
                strengths: Span::WHOLE,
                own: Span::WHOLE,
                before: gathered(&before[edge], c2.hi),
                after: gathered(&after[edge], c1.hi),
            };
            let parts = impacts[edge].iter().zip(after[edge].iter().zip(&before[edge]));
            let all = parts.flat_map(|(impact, (after, before))| {
                let pairs = after.iter().flat_map(|a| before.iter().map(move |p| (a, p)));
                pairs.map(|(a, p)| self.value(m, impact, a, p))
            });
            let hull = |x: [Span; 2], y: [Span; 2]| [x[0].hull(y[0]), x[1].hull(y[1])];
            [image.strengths, image.own] = all.reduce(hull)?;
            (image.strengths.is_finite() && image.own.is_finite()).then_some(image)
        });
        images.collect()
    }

    /// F and f_s at a part of an edge, of a leg after it and one before it.
    fn value(&self, m: f64, [impact, middle]: &[Impact; 2], a: &Term, p: &Term) -> [Span; 2] {
        let [c1, c2] = self.cell.shares;
        let own = c1 * a.own + c2 * p.own;
        let mean = c1 * (a.middle + a.moved) + c2 * (p.middle + p.moved);
        let slope = Span::point(1.0 - m) + own.times(m);
        [middle.s.times(1.0 - m) + mean.times(m) + slope * (impact.s - middle.s), own]
    }

    /// For each edge and part what the legs after it, and those before it, say.
    fn terms(&self, edges: &Edges, impacts: &[Vec<[Impact; 2]>]) -> [Vec<Vec<Vec<Term>>>; 2] {
        let deeper = self.cell.depth - Span::point(self.cell.depth.middle());
        let none: Vec<Vec<Vec<Term>>> = impacts.iter().map(|cut| vec![Vec::new(); cut.len()]).collect();
        let [mut after, mut before] = [none.clone(), none];
        for &[from, v, to] in &edges.legs {
            for (i, first) in impacts[from].iter().enumerate() {
                for (j, last) in impacts[to].iter().enumerate() {
                    let leg = self.leg(edges.letters[v], [first, last]);
                    let term = |middle: Span,
                                own: Span,
                                slope: Span,
                                depth: Span,
                                other: usize,
                                at: &[Impact; 2]| {
                        let moved = slope * (at[0].s - at[1].s) + depth * deeper;
                        Term { middle, own, moved, other, slope: slope.magnitude() }
                    };
                    let [own, other, depth] = leg.after;
                    after[from][i].push(term(leg.middle[0], own, other, depth, to, last));
                    let [other, own, depth] = leg.before;
                    before[to][j].push(term(leg.middle[1], own, other, depth, from, first));
                }
            }
        }
        [after, before]
    }
}

/// The greatest slope for each neighbour, times a share.
fn gathered(parts: &[Vec<Term>], share: f64) -> Vec<(usize, f64)> {
    let mut all: Vec<(usize, f64)> = Vec::new();
    for term in parts.iter().flatten() {
        let slope = share * term.slope;
        match all.iter_mut().find(|(known, _)| *known == term.other) {
            Some((_, most)) => *most = most.max(slope),
            None => all.push((term.other, slope)),
        }
    }
    all
}
