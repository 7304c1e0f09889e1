//! B1 and B2: the contacts of a cell, and where a return takes them.

use super::super::{
    Fault, Interval,
    proof::{Trap, periods},
    rates::{Rates, decay, growth},
};

/// How often an enclosure is put into the equations that narrow it.
const ROUNDS: usize = 3;

/// e^−at and e^−Dt.
#[derive(Clone, Copy)]
struct Fall {
    slow: Interval,
    apart: Interval,
}

impl Fall {
    fn then(self, other: Fall) -> Fall {
        Fall { slow: self.slow * other.slow, apart: self.apart * other.apart }
    }
}

/// What is the same for all cells.
pub(super) struct Returns {
    trap: Trap,
    /// √ν, and ν.
    root: Interval,
    depth: Interval,
    /// Between which −g″ is.
    bend: Interval,
    /// From 0 to 1, to S and to Z.
    unit: Interval,
    speeds: Interval,
    slips: Interval,
    /// After n periods, from n = 0.
    falls: Vec<Fall>,
    /// When after a top there are contacts, and the fall until then.
    window: (Interval, Fall),
}

/// The contacts of a cell.
pub(super) struct Contacts {
    /// The greatest s.
    most: Interval,
    /// y.
    height: Interval,
    /// h/√ν, of those that have not returned.
    kick: Interval,
    /// Σ from below.
    strength: Interval,
    /// From the contact to the top.
    fall: Fall,
}

/// A return.
pub(super) struct Return {
    /// s of the next contact.
    pub speed: Interval,
    /// E from below.
    pub growth: Interval,
}

impl Returns {
    pub fn new(trap: Trap, depth: Interval, last: u64) -> Returns {
        let (zero, one, root) = (Interval::ZERO, Interval::ONE, depth.roots());
        let Rates { slow, apart, .. } = trap.rates;
        let bend = trap.bends[0].hull(trap.bends[1]);
        let fall = |n| Fall { slow: decay(slow * periods(n)), apart: decay(apart * periods(n)) };
        let falls = (0..=last).map(fall).collect();
        let (speeds, slips) = (zero.hull(trap.speed), zero.hull(trap.slip));
        let steep = (-(root * slow)).hull(trap.speed + root * trap.slip);
        let window = (zero, Fall { slow: one, apart: one });
        let mut all = Returns { root, depth, bend, unit: zero.hull(one), speeds, slips, falls, window, trap };
        all.window = all.at(-(root * steep).over(bend));
        all
    }

    /// A time after a top with the fall until then.
    fn at(&self, time: Interval) -> (Interval, Fall) {
        let of = |rate: Interval| growth(-(rate * time));
        (time, Fall { slow: of(self.trap.rates.slow), apart: of(self.trap.rates.apart) })
    }

    /// B1: those with s in a cell; none if there are none.
    pub fn contacts(&self, speed: Interval) -> Option<Contacts> {
        let Rates { slow, fast, .. } = self.trap.rates;
        let (one, tau) = (Interval::ONE, self.trap.tau);
        let mut height = self.unit;
        let mut steep = speed;
        for _ in 0..ROUNDS {
            steep = speed + self.root * (self.slips - slow * height);
            height = (one - steep.squared().over(self.bend + self.bend)).common(height)?;
        }
        let time = -(self.root * steep).over(self.bend);
        let (_, fall) = self.at(-time);
        let kick = (one + tau) * speed + self.root * self.slips;
        let lift = self.trap.bends[0] + slow.squared() * self.depth * height;
        let pull = (slow + fast) * (tau * self.depth * self.slips + self.root * kick);
        let strength = ((one + tau) * lift - pull).least();
        Some(Contacts { most: speed.greatest(), height, kick: kick.over(self.root), strength, fall })
    }

    /// E₁₁ − a E₁₂ and E₁₂ after a fall, and the rest of ζ.
    fn motion(&self, fall: Fall) -> [Interval; 3] {
        let reach = fall.slow * (Interval::ONE - fall.apart).over(self.trap.rates.apart);
        [fall.slow, reach, fall.slow * fall.apart]
    }

    /// B2: those that return in pass n; none if none does.
    pub fn after(&self, contacts: &Contacts, n: usize) -> Option<Return> {
        let Contacts { most, kick, strength, fall, .. } = *contacts;
        let way = self.falls[n].then(fall);
        let (slow, tau) = (self.trap.rates.slow, self.trap.tau);
        let ((mut time, mut until), mut height) = (self.window, self.unit);
        let mut found = None;
        for _ in 0..ROUNDS {
            let [stay, reach, rest] = self.motion(way.then(until));
            height = (stay * contacts.height + reach * kick).common(height)?;
            let slip = (rest * kick).common(self.slips)?;
            let drift = self.root * (slow * height - slip);
            let steep = ((self.bend + self.bend) * (Interval::ONE - height)).roots();
            // Before the top the wall rises at the contact, after it it falls.
            let before = (steep + drift).common(self.speeds).map(|speed| (speed, -steep));
            let gentle = steep.common(Interval::ZERO.hull(drift));
            let after = gentle.and_then(|falls| Some(((drift - falls).common(self.speeds)?, falls)));
            let both = [before, after].into_iter().flatten();
            let (speed, moved) = both.reduce(|one, other| (one.0.hull(other.0), one.1.hull(other.1)))?;
            let growth = strength * reach.over(self.root * most) + tau * stay;
            found = Some(Return { speed, growth: growth.least() });
            (time, until) = self.at((self.root * moved).over(self.bend).common(time)?);
        }
        found
    }

    /// Those that are above the wall at the top of pass n; none if none is.
    pub fn clear(&self, contacts: Contacts, n: usize) -> Option<Contacts> {
        let [stay, reach, _] = self.motion(self.falls[n].then(contacts.fall));
        let least = (Interval::ONE - stay * contacts.height).over(reach);
        Some(Contacts { kick: contacts.kick.at_least(least)?, ..contacts })
    }

    /// e^Rn for n from 0.
    pub fn powers(rate: Interval, last: u64) -> Vec<Interval> {
        (0..=last).map(|n| growth(rate * Interval::integer(n))).collect()
    }

    /// A6.
    pub fn begins(&self, start: Interval) -> Result<(), Fault> {
        self.trap.begins(start)
    }
}
