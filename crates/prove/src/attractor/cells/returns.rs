//! Where the contacts of a cell return to, and how displacements grow until then, in floats: what rules B1
//! and B2 of a certificate with cells say, about.

use std::f64::consts::TAU;

use super::super::{constants::Rates, stop::Stop};
use crate::chaos::span::Span;

/// The most periods of a return that a certificate has.
pub(super) const RETURNS: u64 = 200;
/// How often an enclosure is narrowed.
const ROUNDS: usize = 3;
/// What the checker's enclosures may be wider by.
const NEAR: f64 = 1e-9;

/// A return after n periods.
#[derive(Debug, Clone, Copy)]
pub(super) struct Return {
    pub periods: u64,
    /// Of the next contact.
    pub speed: Span,
    /// The logarithm of the growth.
    pub growth: f64,
}

/// The machines, the wall and the trap at some depths.
pub(super) struct Returns {
    slow: Span,
    fast: Span,
    apart: Span,
    tau: Span,
    bend: Span,
    depth: Span,
    root: Span,
    speeds: Span,
    slips: Span,
}

/// The contacts of a cell.
struct Contacts {
    most: f64,
    height: Span,
    time: Span,
    kick: Span,
    strength: f64,
}

impl Returns {
    pub fn new(rates: &Rates, stop: &Stop, depth: Span, [speed, slip]: [f64; 2]) -> Returns {
        let of = |[lo, hi]: [f64; 2]| Span::new(lo, hi);
        let [slow, fast] = [of(rates.slow), of(rates.fast)];
        Returns {
            slow,
            fast,
            apart: Span::point(rates.apart).hull(Span::point(fast.hi - slow.lo)),
            tau: of(rates.tau),
            bend: of(stop.bends),
            depth,
            root: Span::new(depth.lo.sqrt(), depth.hi.sqrt()),
            speeds: Span::new(0.0, speed),
            slips: Span::new(0.0, slip),
        }
    }

    /// All returns from a cell, and by how many periods all are back; none where some may be later than is
    /// looked at.
    pub fn of(&self, cell: Span) -> Option<(Vec<Return>, u64)> {
        let Some(mut contacts) = self.contacts(cell) else { return Some((Vec::new(), 1)) };
        let mut all = Vec::new();
        for n in 1..=RETURNS {
            all.extend(self.after(&contacts, n));
            let [stay, reach, _] = self.motion(Span::point(TAU * n as f64) - contacts.time);
            let least = (Span::point(1.0) - stay * contacts.height).over(reach).lo;
            if least > contacts.kick.hi * (1.0 + NEAR) {
                return Some((all, n));
            }
            contacts.kick.lo = contacts.kick.lo.max(least).min(contacts.kick.hi);
        }
        None
    }

    fn contacts(&self, speed: Span) -> Option<Contacts> {
        let one = Span::point(1.0);
        let mut height = Span::new(0.0, 1.0);
        let mut steep = speed;
        for _ in 0..ROUNDS {
            steep = speed + self.root * (self.slips - self.slow * height);
            height = (one - steep.squared().over(self.bend.times(2.0))).widened(NEAR).common(height)?;
        }
        let kick = (one + self.tau) * speed + self.root * self.slips;
        let lift = Span::point(self.bend.lo) + self.slow.squared() * self.depth * height;
        let pull = (self.slow + self.fast) * (self.tau * self.depth * self.slips + self.root * kick);
        let strength = ((one + self.tau) * lift - pull).lo;
        let time = -(self.root * steep).over(self.bend);
        Some(Contacts { most: speed.hi, height, time, kick: kick.over(self.root), strength })
    }

    /// E₁₁ − a E₁₂, E₁₂ and e^−bT.
    fn motion(&self, time: Span) -> [Span; 3] {
        let decay = |rate: Span| {
            let x = rate * time;
            Span::new((-x.hi).exp(), (-x.lo).exp())
        };
        let [slow, apart] = [decay(self.slow), decay(self.apart)];
        [slow, slow * (Span::point(1.0) - apart).over(self.apart), slow * apart]
    }

    fn after(&self, contacts: &Contacts, periods: u64) -> Option<Return> {
        let (one, way) = (Span::point(1.0), Span::point(TAU * periods as f64) - contacts.time);
        let fastest = self.speeds.hi + self.root.hi * self.slips.hi;
        let last = self.root.hi * self.slow.hi;
        let mut time = (self.root * Span::new(-fastest, last)).over(self.bend);
        let mut height = Span::new(0.0, 1.0);
        let mut found = None;
        for _ in 0..ROUNDS {
            let [stay, reach, rest] = self.motion(way + time);
            height = (stay * contacts.height + reach * contacts.kick).widened(NEAR).common(height)?;
            let slip = (rest * contacts.kick).widened(NEAR).common(self.slips)?;
            let drift = self.root * (self.slow * height - slip);
            let square = self.bend.times(2.0) * (one - height);
            let steep = Span::new(square.lo.max(0.0).sqrt(), square.hi.sqrt());
            let before = (steep + drift).common(self.speeds).map(|speed| (speed, -steep));
            let gentle = steep.common(Span::new(0.0, drift.hi.max(0.0)));
            let after = gentle.and_then(|falls| Some(((drift - falls).common(self.speeds)?, falls)));
            let both = [before, after].into_iter().flatten();
            let (speed, moved) = both.reduce(|one, other| (one.0.hull(other.0), one.1.hull(other.1)))?;
            let growth =
                contacts.strength * reach.lo / (self.root.hi * contacts.most) + self.tau.lo * stay.lo;
            let growth = if growth > 0.0 { growth.ln() } else { f64::NEG_INFINITY };
            found = Some(Return { periods, speed: speed.widened(NEAR), growth });
            time = (self.root * moved).over(self.bend).widened(NEAR * self.root.hi).common(time)?;
        }
        found
    }
}
