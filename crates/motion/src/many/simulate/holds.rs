//! What a machine is in contact with, where it slides and sticks, on which side of kinks its forces are, and
//! what is watched because of it.

use crate::{
    many::{
        Grip, State,
        brace::Brace,
        contact::{Contacts, Watch},
    },
    motion::Effect,
};

/// What is watched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum What {
    /// The gap to a stop.
    Gap(usize),
    /// The force of a stop that is rested on, as the acceleration that it prevents.
    Force(usize),
    /// The force of a soft stop, over [`SoftContact::unit`](crate::many::contact::SoftContact::unit).
    Push(usize),
    /// The same with the other sign: by how much a soft stop would pull.
    Pull(usize),
    /// The gap to a soft stop with the other sign.
    Rise(usize),
    /// The velocity at a row with friction that slides, with the sign that it has.
    Slide(usize),
    /// By how much what sticks could push more, as an acceleration, along a brace of the stage or against it.
    Hold(usize, Grip),
    /// A switch of forces with kinks, with the sign that it has.
    Kink(usize),
}

impl What {
    /// What a look at it counts as.
    pub fn effect(self) -> Effect {
        match self {
            What::Gap(_) | What::Rise(_) | What::Kink(_) => Effect::Gap,
            What::Force(_) | What::Push(_) | What::Pull(_) => Effect::Force,
            What::Slide(_) | What::Hold(..) => Effect::Friction,
        }
    }
}

/// Which soft stops are not open, each list ascending. A stop without damping is never behind.
#[derive(Debug, Clone, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct SoftStops {
    /// Those that push: z < 0 and the force is positive.
    pub pushing: Vec<usize>,
    /// Those let go of that are not open yet: z < 0, and they would pull.
    pub behind: Vec<usize>,
}

impl SoftStops {
    /// Of a state: what it is follows from gaps and rates alone.
    pub fn of(contacts: &Contacts, state: &State) -> SoftStops {
        let mut all = SoftStops::default();
        for (j, contact) in contacts.all().iter().enumerate() {
            let Some(soft) = contact.soft.filter(|_| contact.force.is_none()) else { continue };
            let gap = contact.gap(state);
            match soft.force(gap) > 0.0 {
                _ if gap[0] >= 0.0 => {}
                true => all.pushing.push(j),
                false => all.behind.push(j),
            }
        }
        all
    }

    pub fn is_empty(&self) -> bool {
        self.pushing.is_empty() && self.behind.is_empty()
    }

    /// The same with one stop somewhere else.
    pub fn with(&self, stop: usize, place: SoftPlace) -> SoftStops {
        let mut all = self.clone();
        all.pushing.retain(|&j| j != stop);
        all.behind.retain(|&j| j != stop);
        let list = match place {
            SoftPlace::Open => return all,
            SoftPlace::Pushing => &mut all.pushing,
            SoftPlace::Behind => &mut all.behind,
        };
        list.push(stop);
        list.sort_unstable();
        all
    }
}

/// Where the motion is at a soft stop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum SoftPlace {
    Open,
    Pushing,
    Behind,
}

/// What a machine is in contact with.
#[derive(Debug, Clone, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Holds {
    /// The stops rested on, ascending.
    pub resting: Vec<usize>,
    /// The soft ones.
    pub soft: SoftStops,
    /// How it moves at each row with friction.
    pub grips: Vec<Grip>,
    /// The switches of forces with kinks that are negative, ascending.
    pub below: Vec<usize>,
}

impl Holds {
    /// Whether it is in contact with nothing, without friction and with no switch negative.
    #[inline]
    pub fn is_free(&self) -> bool {
        self.resting.is_empty() && self.soft.is_empty() && self.grips.is_empty() && self.below.is_empty()
    }

    /// The friction that sticks.
    pub fn stuck(&self) -> impl Iterator<Item = usize> {
        self.grips.iter().enumerate().filter(|(_, grip)| **grip == Grip::Stuck).map(|(j, _)| j)
    }

    /// By how much what sticks could push more to a side of a brace, as an acceleration; `forces` are those
    /// of the rows held.
    pub fn bound(&self, contacts: &Contacts, forces: &[Watch], brace: &Brace, side: Grip) -> Watch {
        let rows = self.rows(contacts);
        let at = |row: usize| rows.iter().position(|known| *known == row);
        let own = |rub: usize| &forces[at(contacts.rub_row(rub)).unwrap_or(0)];
        let needed = match brace.needed[..] {
            [(rub, 1.0)] => own(rub).clone(),
            _ => {
                let none = Watch::constant(contacts.held_row(0).0.len(), 0.0);
                brace.needed.iter().fold(none, |sum, (rub, factor)| sum.with(*factor, own(*rub)))
            }
        };
        let most = |&(rub, part): &(usize, f64)| (rub, part.abs() * contacts.rubs()[rub].holding);
        let given = |(rub, most): (usize, f64)| contacts.rubs()[rub].stop.is_none().then_some(most);
        let known = brace.parts.iter().map(most).filter_map(given).sum();
        let mut bound = needed.below(known, side.sign());
        for (rub, most) in brace.parts.iter().map(most) {
            let Some(stop) = contacts.rubs()[rub].stop else { continue };
            bound = match (at(stop), contacts.all()[stop].soft) {
                (Some(i), _) => bound.with(most / contacts.mobility(stop), &forces[i]),
                (None, Some(soft)) => bound.with(most * soft.unit(), &contacts.all()[stop].push_watch(1.0)),
                (None, None) => bound,
            };
        }
        bound
    }

    /// The friction that sticks but for what depends on the rest of it.
    pub fn held(&self, contacts: &Contacts) -> Vec<usize> {
        contacts.basis(&self.stuck().collect::<Vec<_>>())
    }

    /// The same with one switch turned.
    pub fn turned(&self, switch: usize) -> Holds {
        let mut all = self.clone();
        if self.below.contains(&switch) {
            all.below.retain(|&k| k != switch);
        } else {
            all.below.push(switch);
            all.below.sort_unstable();
        }
        all
    }

    /// The rows that are held: stops rested on, then what sticks, but for what depends on the rest of it.
    pub fn rows(&self, contacts: &Contacts) -> Vec<usize> {
        self.resting.iter().copied().chain(self.held(contacts).iter().map(|&j| contacts.rub_row(j))).collect()
    }
}
