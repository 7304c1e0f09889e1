//! The equations of an impact pattern, their derivatives, and the map once round, linearised.
//!
//! The unknowns are, impact by impact, its phase T, then the state (q, q′) just before it: 2n + 1 each. The
//! equations of impact i are that its gap is 0, and that the flight that it begins ends in the state before
//! impact i + 1.

use super::{
    super::motion::{Interval, krawczyk::Equations, pattern::turns},
    Fault,
    linear::{self, Matrix, Vector, apply, difference, dot, scaled, sum},
    motion::Motion,
    text::Impact,
};
use crate::rejection::GoOn;

/// A machine and a pattern of impacts.
pub(super) struct Cycle<'a> {
    pub motion: Motion,
    pub impacts: &'a [Impact],
}

/// The flight from an impact to the next.
pub(super) struct Leg {
    /// The phase at which it begins.
    pub phase: Interval,
    pub duration: Interval,
    /// The phase at which it ends.
    pub end: Interval,
    /// The state after the impact.
    pub after: Vector,
    /// What the flow acts on.
    start: Vector,
}

impl Cycle<'_> {
    /// Unknowns for each impact.
    pub fn block(&self) -> usize {
        2 * self.motion.size + 1
    }

    /// T and the state just before impact i.
    pub fn impact<'x>(&self, x: &'x [Interval], i: usize) -> (Interval, &'x [Interval]) {
        let block = &x[i * self.block()..(i + 1) * self.block()];
        (block[0], &block[1..])
    }

    /// V: how fast the gap closes.
    pub fn speed(&self, x: &[Interval], i: usize) -> Interval {
        let (t, state) = self.impact(x, i);
        let contact = &self.motion.contacts[self.impacts[i].stop];
        contact.place(t)[1] - dot(&contact.row, &state[self.motion.size..])
    }

    /// The flight from impact i to the next.
    pub fn leg(&self, x: &[Interval], i: usize) -> Leg {
        let (m, n) = (self.impacts.len(), self.motion.size);
        let ((phase, before), (end, _)) = (self.impact(x, i), self.impact(x, (i + 1) % m));
        let kick = scaled(self.speed(x, i), &self.motion.contacts[self.impacts[i].stop].kick);
        let after = [&before[..n], &sum(&before[n..], &kick)].concat();
        let periods = turns(self.impacts[i].periods);
        Leg {
            phase,
            // The phases cancel where they are one.
            duration: if m == 1 { periods } else { periods + end - phase },
            end,
            start: self.motion.depart(&after, phase),
            after,
        }
    }

    /// The state a time τ after the start of a flight.
    pub fn state(&self, leg: &Leg, tau: Interval) -> Vector {
        self.motion.arrive(&self.motion.flow(tau), &leg.start, leg.phase + tau)
    }

    /// (q, q′) → (q, q′ − κ w·q′).
    fn passage(&self, i: usize) -> Matrix {
        let (n, contact) = (self.motion.size, &self.motion.contacts[self.impacts[i].stop]);
        let mut matrix = linear::identity(2 * n);
        for (k, &kick) in contact.kick.iter().enumerate() {
            for (j, &w) in contact.row.iter().enumerate() {
                matrix[n + k][n + j] = matrix[n + k][n + j] - kick * w;
            }
        }
        matrix
    }

    /// The linearised map once round, from just before the first impact. An orbit displaced by δ meets the
    /// stop w·δq/V later, in which it goes on by (q′, q″) before the impact instead of after, while its speed
    /// V grows by −z″ per unit of time.
    pub fn monodromy(&self, x: &[Interval], go_on: GoOn) -> Result<Matrix, Fault> {
        let n = self.motion.size;
        let mut all = linear::identity(2 * n);
        for i in 0..self.impacts.len() {
            go_on()?;
            let (leg, (t, before)) = (self.leg(x, i), self.impact(x, i));
            let stop = self.impacts[i].stop;
            let contact = &self.motion.contacts[stop];
            let [.., bend] = self.motion.gap(stop, before, t);
            let kick = [vec![Interval::ZERO; n], scaled(bend, &contact.kick)].concat();
            let fields = [self.motion.field(before, t), self.motion.field(&leg.after, t)];
            let turn = difference(&difference(&fields[0], &fields[1]), &kick);
            let mut passage = self.passage(i);
            for (row, &turn) in passage.iter_mut().zip(&turn) {
                for (entry, &w) in row.iter_mut().zip(&contact.row) {
                    *entry = *entry + (turn * w).over(self.speed(x, i));
                }
            }
            let flow = state_part(&self.motion.flow(leg.duration));
            all = linear::times(&flow, &linear::times(&passage, &all));
        }
        Ok(all)
    }
}

impl Equations for Cycle<'_> {
    fn residual(&self, x: &[Interval], go_on: GoOn) -> Result<Vector, Fault> {
        let m = self.impacts.len();
        let mut all = Vec::with_capacity(x.len());
        for i in 0..m {
            go_on()?;
            let (t, before) = self.impact(x, i);
            all.push(self.motion.gap(self.impacts[i].stop, before, t)[0]);
            let leg = self.leg(x, i);
            let flow = self.motion.flow(leg.duration);
            let end = self.motion.arrive(&flow, &leg.start, leg.end);
            all.extend(difference(&end, self.impact(x, (i + 1) % m).1));
        }
        Ok(all)
    }

    /// The flight that ends later goes on by (q′, q″) there; begun later it
    /// lacks what the flow makes of (q′, q″) after the impact, and has what it makes of the kick of Q″; what
    /// comes before the impact passes it by q′ → q′ − κ w·q′ and then the flow.
    fn derivatives(&self, x: &[Interval], go_on: GoOn) -> Result<Matrix, Fault> {
        let (m, n, block) = (self.impacts.len(), self.motion.size, self.block());
        let mut rows = vec![vec![Interval::ZERO; x.len()]; x.len()];
        for i in 0..m {
            go_on()?;
            let (next, here) = ((i + 1) % m, i * block);
            let contact = &self.motion.contacts[self.impacts[i].stop];
            let [_, speed, bend] = contact.place(self.impact(x, i).0);
            rows[here][here] = -speed;
            rows[here][here + 1..=here + n].copy_from_slice(&contact.row);
            let leg = self.leg(x, i);
            let flow = self.motion.flow(leg.duration);
            let later = self.motion.field(&self.motion.arrive(&flow, &leg.start, leg.end), leg.end);
            let flow = state_part(&flow);
            let still = vec![Interval::ZERO; n];
            let pushed = [still, scaled(bend, &contact.kick)].concat();
            let begun = apply(&flow, &difference(&pushed, &self.motion.field(&leg.after, leg.phase)));
            let passed = linear::times(&flow, &self.passage(i));
            for (k, passed) in passed.iter().enumerate() {
                let row = &mut rows[here + 1 + k];
                row[here] = row[here] + begun[k];
                row[next * block] = row[next * block] + later[k];
                for (j, &entry) in passed.iter().enumerate() {
                    row[here + 1 + j] = row[here + 1 + j] + entry;
                }
                row[next * block + 1 + k] = row[next * block + 1 + k] - Interval::ONE;
            }
        }
        Ok(rows)
    }
}

/// The flow of differences of states.
pub(super) fn state_part(flow: &Matrix) -> Matrix {
    let n = flow.len() - 1;
    flow[..n].iter().map(|row| row[..n].to_vec()).collect()
}
