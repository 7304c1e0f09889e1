//! The conditions E1 to E3: the map of sequences of strengths is a contraction of the edges' ranges, and its
//! fixed points have positive speeds.
//!
//! At an edge the map is F = (1 − m) s + m (c₁ a + c₂ p), where a, of the leg after it, depends on s and s⁺,
//! p, of the leg before it, on s⁻ and s, and c₁ = 2/(1 + τ), c₂ = 2τ/(1 + τ). So pairs of edges are run, and
//! what they give is put together in all ways: by the mean-value form about the middles of s⁻, s, s⁺ and ν.

use super::{
    Fault, Interval,
    legs::Leg,
    work::{Numbers, Work},
};
use crate::rejection::{GoOn, claim};

/// All legs between parts of edges, in the order of `Graph::legs`, then of the
/// parts of the first edge, then of the second.
pub(super) struct Legs(Vec<Vec<Leg>>);

/// A velocity at an impact, as a function of its own s, of its neighbour's and of ν.
struct Velocity {
    all: Interval,
    middle: Interval,
    /// The derivative by its own s.
    own: Interval,
    /// How far it moves with the neighbour's s and with ν.
    moved: Interval,
    /// The greatest derivative by the neighbour's s, times the neighbour's weight.
    weighed: Interval,
}

/// Both velocities in all ways, at an impact.
struct Impacts {
    after: Vec<Velocity>,
    before: Vec<Velocity>,
}

impl Work<'_> {
    /// All legs.
    pub fn legs(&self, go_on: GoOn) -> Result<Legs, Fault> {
        let mut all = Vec::new();
        for &[from, letter, to] in &self.graph.legs {
            let mut legs = Vec::new();
            for (first, last) in
                self.parts[from].iter().flat_map(|first| self.parts[to].iter().map(move |last| (first, last)))
            {
                go_on()?;
                legs.push(self.leg(letter, first, last));
            }
            all.push(legs);
        }
        Ok(Legs(all))
    }

    /// The velocities at an edge's impacts of one part.
    fn velocities(&self, legs: &Legs, edge: usize, part: usize, numbers: &[Numbers]) -> Impacts {
        let (count, deeper) = (self.parts[edge].len(), self.deeper());
        let mut found = Impacts { after: Vec::new(), before: Vec::new() };
        let velocity = |all, middle, own, [other, depth]: [Interval; 2], [neighbour, at]: [usize; 2]| {
            let [part, middle_impact] = &self.parts[neighbour][at];
            let moved = other * (part.s - middle_impact.s) + depth * deeper;
            let weighed = other.magnitude() * numbers[neighbour].weight;
            Velocity { all, middle, own, moved, weighed }
        };
        let graph = self.graph;
        for (&at, other) in graph.begin[edge].iter().flat_map(|at| (0..count).map(move |other| (at, other))) {
            let leg = &legs.0[at][part * count + other];
            let [own, last, depth] = leg.after_slopes;
            let neighbour = [graph.legs[at][2], other];
            found.after.push(velocity(leg.after, leg.middle[0], own, [last, depth], neighbour));
        }
        for (&at, other) in graph.end[edge].iter().flat_map(|at| (0..count).map(move |other| (at, other))) {
            let leg = &legs.0[at][other * count + part];
            let [first, own, depth] = leg.before_slopes;
            let neighbour = [graph.legs[at][0], other];
            found.before.push(velocity(leg.before, leg.middle[1], own, [first, depth], neighbour));
        }
        found
    }

    /// F at an edge's impacts of one part, over all neighbours; with the greatest |F_s| w + |F_s⁻| w⁻ +
    /// |F_s⁺| w⁺.
    fn image(
        &self,
        impacts: &Impacts,
        edge: usize,
        part: usize,
        numbers: &Numbers,
        go_on: GoOn,
    ) -> Result<[Interval; 2], Fault> {
        let [c1, c2] = self.cell.shares;
        let (m, one) = (numbers.factor, Interval::ONE);
        let [impact, middle] = &self.parts[edge][part];
        let apart = impact.s - middle.s;
        let mut found: Option<[Interval; 2]> = None;
        for a in &impacts.after {
            go_on()?;
            for p in &impacts.before {
                let mean = |x: Interval, y: Interval| c1 * x + c2 * y;
                let slope = (one - m) + m * mean(a.own, p.own);
                let value = (one - m) * middle.s + m * (mean(a.middle, p.middle) + mean(a.moved, p.moved));
                let value = value + slope * apart;
                let size = slope.magnitude() * numbers.weight + m.magnitude() * mean(a.weighed, p.weighed);
                found = Some(found.map_or([value, size], |[x, y]| [x.hull(value), y.hull(size)]));
            }
        }
        Ok(found.unwrap_or([Interval::WHOLE; 2]))
    }

    /// Whether at every impact of the part the speed is certainly positive, given that s = c₁ a + c₂ p: s/2
    /// is a mean of a and p with positive weights.
    fn leaves(&self, impacts: &Impacts, edge: usize, part: usize) -> bool {
        let [impact, middle] = &self.parts[edge][part];
        let (apart, half) = (impact.s - middle.s, Interval::ONE.half());
        let (s, there) = (impact.s.half(), middle.s.half());
        let moved = |x: &Velocity| (x.middle - there) + (x.own - half) * apart + x.moved;
        let away = |a: &Velocity| (a.all - s).is_positive() || moved(a).is_positive();
        let comes = |p: &Velocity| (s - p.all).is_positive() || (-moved(p)).is_positive();
        let both = |a: &Velocity, p: &Velocity| {
            let apart = (a.middle - p.middle) + (a.own - p.own) * apart + (a.moved - p.moved);
            (a.all - p.all).is_positive() || apart.is_positive()
        };
        impacts.after.iter().all(away)
            || impacts.before.iter().all(comes)
            || impacts.after.iter().all(|a| impacts.before.iter().all(|p| both(a, p)))
    }

    /// E1 to E3.
    pub fn contracts(
        &self,
        legs: &Legs,
        numbers: &[Numbers],
        contraction: Interval,
        go_on: GoOn,
    ) -> Result<(), Fault> {
        for (edge, own) in numbers.iter().enumerate() {
            let shown = |holds, reason| claim(holds, format_args!("{}: {reason}", self.graph.name(edge)));
            for part in 0..self.parts[edge].len() {
                go_on()?;
                let impacts = self.velocities(legs, edge, part, numbers);
                let [image, size] = self.image(&impacts, edge, part, own, go_on)?;
                shown(own.ends.holds(image), "the map may leave the range (E1)")?;
                let holds = size.is_up_to(contraction * own.weight);
                shown(holds, "the map may not contract (E2)")?;
                let holds = self.leaves(&impacts, edge, part);
                shown(holds, "the speed may not be positive (E3)")?;
            }
        }
        Ok(())
    }

    /// F of everything, for each edge.
    pub fn images(&self, legs: &Legs, numbers: &[Numbers], go_on: GoOn) -> Result<Vec<Interval>, Fault> {
        let mut all = Vec::new();
        for (edge, own) in numbers.iter().enumerate() {
            let mut image: Option<Interval> = None;
            for part in 0..self.parts[edge].len() {
                go_on()?;
                let impacts = self.velocities(legs, edge, part, numbers);
                let [here, _] = self.image(&impacts, edge, part, own, go_on)?;
                image = Some(image.map_or(here, |image| image.hull(here)));
            }
            all.push(image.unwrap_or(Interval::WHOLE));
        }
        Ok(all)
    }

    /// The first velocities of a leg from one edge to another, the `index`-th of all.
    pub fn after(legs: &Legs, index: usize) -> Interval {
        let all = legs.0[index].iter().map(|leg| leg.after);
        all.reduce(Interval::hull).unwrap_or(Interval::WHOLE)
    }
}
