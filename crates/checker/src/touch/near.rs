//! What motions near the touch can do: how often they meet the wall in one window, how long their legs are,
//! and which velocities legs between impacts of bounded strength can have. For f = 0.
//!
//! - C1: in one window there is at most one contact. Between two, q̂′ is once the wall's, at most S/2, and
//!   then |q̂′| and |q̂″| are bounded; Z″ = −g″ + νq̂″ > 0 leaves no room for a second contact and none for
//!   rest on the wall.
//! - C2: a leg has at most M periods. At the phase of its first impact q̂ would be y₀, y₁, … > 0 a period
//!   apart, but yₖ₊₁/yₖ = trace − determinant/(yₖ/yₖ₋₁) of E(2π) cannot remain positive.
//! - C3: what is known of the velocities a, p of legs of n ≤ M periods, at first nothing, is narrowed by G
//!   itself, by the law of impact s = 2(a + τp)/(1 + τ), by a ≥ s/2 ≥ p, and by q̂ ≥ σ at 2πk for 0 < k < n.
//!
//! Where the place of rest is free, σ = −1, bounded motions have bounded velocities and legs instead of C2
//! (`settled`). The proofs are in `proofs/chaos.md` and `proofs/ranges.md`. What is left in the end is
//! judged by the kinds.

use super::{
    Interval,
    flow::Matrix,
    legs::{Cell, Impact, Known},
    settled,
};
use crate::rejection::{Fault, GoOn, claim};

/// Motions all of whose contacts are in the window at |g′| ≤ νS/2.
pub(crate) struct Near<'a> {
    pub cell: &'a Cell<'a>,
    /// E over 0, 1, … periods, to the longest legs.
    pub turns: &'a [Matrix],
    /// From −S to S.
    pub strengths: Interval,
    /// Into how many parts the strengths of an impact are cut.
    pub parts: u64,
}

/// Of legs of up to so many periods nothing.
pub(crate) fn anything(longest: u64) -> Known {
    vec![Some([Interval::WHOLE; 2]); longest as usize]
}

/// An impact may be outside the window.
fn outside() -> Fault {
    Fault::False("an impact may be outside the window (C)".into())
}

impl Near<'_> {
    /// C1 and C2 for legs of up to so many periods, and a place of rest that the wall hides at these phases.
    pub fn bounded(&self, longest: u64) -> Result<(), Fault> {
        let Some(all) = self.cell.impact(self.strengths) else { return Err(outside()) };
        claim(self.once(&all), "there may be two contacts in one window (C)")?;
        let holds = all.place.is_positive() && ends(self.cell.flow.invariants(self.turns[1]), longest);
        claim(holds, format_args!("a leg may be longer than {longest} periods (C)"))
    }

    /// C1, and what is known of legs of up to so many periods of bounded motions for σ = −1: there are no
    /// longer ones, and of all of them the legs of one period have the widest sets.
    pub fn settled(&self, longest: u64) -> Result<Known, Fault> {
        let Some(all) = self.cell.impact(self.strengths) else { return Err(outside()) };
        claim(self.once(&all), "there may be two contacts in one window (C)")?;
        let (cell, time) = (self.cell, |n| self.cell.time(n));
        let known = settled::velocities(cell.flow, cell.shares, &all, time, longest);
        known.ok_or_else(|| Fault::False(format!("a leg may be longer than {longest} periods (C)")))
    }

    /// C1. With D the width of the phases and |q̂(0)| ≤ Q: |q̂′| ≤ M, |q̂″| ≤ A = |c|M + |k|(Q + DM) and M ≤
    /// S/2 + DA.
    fn once(&self, all: &Impact) -> bool {
        let (cell, flow) = (self.cell, self.cell.flow);
        let width = all.phase.magnitude() + all.phase.magnitude();
        let (damping, stiffness) = (flow.damping.magnitude(), flow.stiffness.magnitude());
        let (place, speed) = (all.place.magnitude(), all.s.magnitude().half());
        let room = Interval::ONE - width * (damping + stiffness * width);
        if !room.is_positive() {
            return false;
        }
        let most = (speed + width * (stiffness * place)).over(room);
        let acceleration = damping * most + stiffness * (place + width * most);
        (all.bend.least() - cell.depth * acceleration).is_positive()
    }

    /// The s of impacts between legs of m and n periods (from 0), if there can be any.
    pub fn between(&self, known: &Known, m: usize, n: usize) -> Option<Interval> {
        let ([after, _], [_, before]) = (known[n]?, known[m]?);
        after.at_least(before)?;
        self.cell.strength(after, before).common(self.strengths)
    }

    /// C3: a round of narrowing.
    pub fn narrowed(&self, known: &Known, first: bool, go_on: GoOn) -> Result<Known, Fault> {
        let count = known.len();
        let mut narrow: Known = vec![None; count];
        // At first all are alike.
        let others = if first { 1 } else { count };
        let mut impacts = vec![None; count * count];
        let pairs = (0..count).flat_map(|m| (0..count).map(move |n| (m, n)));
        for (m, n) in pairs.filter(|&(m, n)| m < others || n < others) {
            if let Some(s) = self.between(known, m, n) {
                let Some(cut) = self.cell.parts(s, self.parts, go_on)? else { return Err(outside()) };
                impacts[m * count + n] = Some(cut);
            }
        }
        for n in 0..count {
            for (m, k) in (0..others).flat_map(|m| (0..others).map(move |k| (m, k))) {
                let (Some(from), Some(to)) = (&impacts[m * count + n], &impacts[n * count + k]) else {
                    continue;
                };
                for (from, to) in from.iter().flat_map(|from| to.iter().map(move |to| (from, to))) {
                    go_on()?;
                    if let Some(found) = self.leg(known, [m, n, k], from, to) {
                        let old = narrow[n].unwrap_or(found);
                        narrow[n] = Some([0, 1].map(|i| old[i].hull(found[i])));
                    }
                }
            }
        }
        Ok(narrow)
    }

    /// The velocities of a leg of n + 1 periods between impacts, those of the legs before and after being
    /// known; none if it cannot be.
    fn leg(
        &self,
        known: &Known,
        [m, n, k]: [usize; 3],
        from: &[Impact; 2],
        to: &[Impact; 2],
    ) -> Option<[Interval; 2]> {
        let (cell, periods) = (self.cell, n as u64 + 1);
        let ([own_after, own_before], [_, before], [after, _]) = (known[n]?, known[m]?, known[k]?);
        let leg = cell.leg(self.turns[periods as usize], periods, [&from[0], &to[0]], [&from[1], &to[1]]);
        let (a, mut p) = (leg.after.common(own_after)?, leg.before.common(own_before)?);
        if !leg.after.is_known() {
            // E₁₂ may be 0: where does what is known of a lead?
            let e = cell.matrix(self.turns[periods as usize], &from[0], &to[0]);
            let (place, speed) = cell.flow.apply(e, from[0].place, a);
            place.common(to[0].place)?;
            p = p.common(speed)?;
        }
        // Relative speeds are at least 0.
        let a = a.at_least(from[0].s.half())?;
        let p = -((-p).at_least(-to[0].s.half())?);
        // s is what these velocities and the neighbours' make it.
        let [one, other] = cell.shares;
        let a = a.common((from[0].s - other * before).over(one))?;
        let p = p.common((to[0].s - one * after).over(other))?;
        // The gap at the middle of each window between.
        let back = cell.flow.exp(-from[0].phase);
        for turns in 1..periods {
            let e = cell.flow.times(self.turns[turns as usize], back);
            cell.flow.apply(e, from[0].place, a).0.at_least(cell.side)?;
        }
        Some([a, p])
    }
}

/// C2, with the ratios' upper bounds, from the trace and the determinant of E(2π). Where a ratio is not
/// bounded nothing follows.
pub(crate) fn ends([trace, determinant]: [Interval; 2], longest: u64) -> bool {
    let (trace, determinant) = (trace.greatest(), determinant.least());
    if !determinant.is_positive() {
        return false;
    }
    // Of y_{k+1}/y_k for k = 1, 2, …; a leg of n periods has y_0, …, y_{n−1}.
    let mut ratio = trace;
    for _ in 1..longest {
        if ratio.is_up_to(Interval::ZERO) {
            return true;
        }
        ratio = (trace - determinant.over(ratio)).greatest();
    }
    false
}
