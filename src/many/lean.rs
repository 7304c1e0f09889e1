//! Friction under the force of a stop: what leans, and impacts with it.
//!
//! Where the normal force of friction is that of a stop, a force Λ of the stop along its row w comes with
//! −σμΛ along the row t of what slides on it, σ being the sign of the velocity there: the stop's force acts
//! along w − σμt and *leans*. So motion at rest on a stop, and in contact with one that gives way, is linear
//! with friction, too; its matrices are not symmetric. What sticks is held along t by at most μΛ, and where
//! the stop is not in contact there is nothing.
//!
//! # Impacts
//!
//! An impact has an impulse Λ of each stop and with it P along t, |P| ≤ μΛ: the velocity there is 0
//! afterwards, or P = −σμΛ with the sign σ that it has then. The gaps obey Newton's law as without friction
//! (Moreau's law with no restitution along t). Of several answers the one counts in which the most sticks.
//! One that slides on may be turned round only by an impulse that lets it stick: nothing is resolved in
//! time. Newton's law is for gaps, and with friction at an eccentric impact it may add energy (Kane).

use super::{
    Grip, RealMatrix, RealVector, Rub,
    contact::{Contacts, ImpactLaw, MOST_TRIED, tried},
};
use crate::error::{Error, Result};

/// Velocities within this of their size have no sign.
const SMALL: f64 = 1e-12;

/// Impacts one after the other at one instant: more than this for each stop do not end.
const TURNS: usize = 200;

/// More rows than this at one impact are refused: all ways in which they go on are tried.
const MOST: usize = 6;

/// An impact on stops with friction.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LeaningImpact {
    /// The impulses, one for each stop.
    pub impulses: Vec<f64>,
    /// The rows of friction at them, by their places among all friction, and the impulses along them.
    pub rubs: Vec<(usize, f64)>,
    /// How all friction goes on; of what has no part in it as it was.
    pub grips: Vec<Grip>,
    /// The change of velocity.
    pub change: RealVector,
    /// Whether impacts one after the other, in some order, would have ended with other velocities.
    pub order_matters: bool,
}

/// What an impact does, with friction or without.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Struck {
    /// The impulses, one for each stop.
    pub impulses: Vec<f64>,
    /// The energy that the friction at each stop takes.
    pub rubbed: Vec<f64>,
    /// How all friction goes on.
    pub grips: Vec<Grip>,
    /// The change of velocity.
    pub change: RealVector,
    /// Whether impacts one after the other, in some order, would have ended with other velocities.
    pub order_matters: bool,
}

impl Contacts {
    /// The impact on stops with gaps' rates `rates`, `sliding` and `grips` being those of all friction
    /// before.
    ///
    /// # Errors
    /// Those of [`impact`](Self::impact) and of [`leaning_impact`](Self::leaning_impact).
    pub(crate) fn struck(
        &self,
        stops: &[usize],
        rates: &[f64],
        sliding: &[f64],
        grips: &[Grip],
    ) -> Result<Struck> {
        let mut rubbed = vec![0.0; stops.len()];
        if self.rubs().is_empty() || self.rubbing(stops).is_empty() {
            let ImpactLaw { impulses, change, order_matters } = self.impact(stops, rates)?;
            return Ok(Struck { impulses, rubbed, grips: grips.to_vec(), change, order_matters });
        }
        let law = self.leaning_impact(stops, rates, sliding, grips)?;
        for &(j, impulse) in &law.rubs {
            let after = sliding[j] + self.held_row(self.rub_row(j)).0.dot(&law.change);
            let at = stops.iter().position(|stop| self.rubs()[j].stop == Some(*stop));
            at.into_iter().for_each(|i| rubbed[i] -= 0.5 * impulse * (sliding[j] + after));
        }
        let LeaningImpact { impulses, grips, change, order_matters, .. } = law;
        Ok(Struck { impulses, rubbed, grips, change, order_matters })
    }

    /// The friction that slides on a stop: its row, and −σμ.
    fn leaning<'a>(&'a self, row: usize, grips: &'a [Grip]) -> impl Iterator<Item = (usize, f64)> + 'a {
        let tied = move |(j, rub): (usize, &Rub)| {
            let grip = grips.get(j).filter(|grip| rub.stop == Some(row) && grip.slides())?;
            Some((self.rub_row(j), -grip.sign() * rub.sliding))
        };
        self.rubs().iter().enumerate().filter_map(tied)
    }

    /// What the force of a row, with that of what slides on it, acts along.
    pub(super) fn along(&self, row: usize, grips: &[Grip]) -> RealVector {
        let mut along = self.held_row(row).0.clone();
        for (other, lean) in self.leaning(row, grips) {
            along.axpy(lean, self.held_row(other).0, 1.0);
        }
        along
    }

    /// Why nothing can go on at some stops.
    pub(super) fn paradox(&self, stops: &[usize]) -> Error {
        let names: Vec<&str> = stops.iter().map(|&stop| self.all()[stop].name.as_str()).collect();
        Error::input(format!(
            "no motion on {} obeys Coulomb's law here: with this friction the stop's force would have to pull, or be \
             infinite (Painlevé's paradox)",
            names.join(", ")
        ))
    }

    /// Whether the force of any of some rows leans.
    pub(super) fn leans(&self, rows: &[usize], grips: &[Grip]) -> bool {
        rows.iter().any(|&row| self.leaning(row, grips).next().is_some())
    }

    /// What a row feels, as an acceleration, of a force of 1 at another with that of what slides on it.
    pub(super) fn coupled_along(&self, row: usize, other: usize, grips: &[Grip]) -> f64 {
        let more = self.leaning(other, grips).map(|(third, lean)| lean * self.coupled(row, third));
        more.fold(self.coupled(row, other), |sum, part| sum + part)
    }

    /// The same of some rows by others.
    pub(super) fn among_along(&self, rows: &[usize], others: &[usize], grips: &[Grip]) -> RealMatrix {
        RealMatrix::from_fn(rows.len(), others.len(), |i, j| self.coupled_along(rows[i], others[j], grips))
    }

    /// The change of velocity by impulses at some rows with those of what slides on them.
    pub(super) fn change_along(&self, rows: &[usize], impulses: &[f64], grips: &[Grip]) -> RealVector {
        let mut sum = self.change(rows, impulses);
        for (&row, &impulse) in rows.iter().zip(impulses) {
            for (other, lean) in self.leaning(row, grips) {
                sum.axpy(lean * impulse, self.push(other), 1.0);
            }
        }
        sum
    }

    /// The friction under the force of one of some stops.
    pub(super) fn rubbing(&self, stops: &[usize]) -> Vec<usize> {
        if self.rubs().is_empty() {
            return Vec::new();
        }
        let under = |j: &usize| self.rubs()[*j].stop.is_some_and(|stop| stops.contains(&stop));
        (0..self.rubs().len()).filter(under).collect()
    }

    /// The law of the head for stops with gaps' rates `rates`, at which friction has these velocities. Cost:
    /// O(3^r 2^m (m + r)³) for m stops and r rows of friction at them.
    ///
    /// # Errors
    /// More than six rows of friction at them; none of the ways to go on is one.
    pub(crate) fn leaning_impact(
        &self,
        stops: &[usize],
        rates: &[f64],
        sliding: &[f64],
        grips: &[Grip],
    ) -> Result<LeaningImpact> {
        let mut found = self.at_once(stops, rates, sliding, grips)?;
        if stops.len() > 1 {
            let size = rates.iter().fold(0.0, |most: f64, rate| most.max(rate.abs()));
            let other = |first: usize| {
                let ended = self.leaning_in_turn(stops, rates, (sliding, grips), first);
                ended.is_none_or(|change| {
                    stops.iter().any(|&stop| {
                        (self.held_row(stop).0.dot(&(&change - &found.change))).abs() > 1e-9 * size
                    })
                })
            };
            found.order_matters = (0..stops.len()).any(other);
        }
        Ok(found)
    }

    /// The change of velocity by impacts one by one, beginning with `first`; none if they do not end.
    fn leaning_in_turn(
        &self,
        stops: &[usize],
        rates: &[f64],
        (sliding, grips): (&[f64], &[Grip]),
        first: usize,
    ) -> Option<RealVector> {
        let m = stops.len();
        let tiny = 1e-13 * rates.iter().fold(0.0, |most: f64, rate| most.max(rate.abs()));
        let mut change: RealVector = self.push(stops[0]) * 0.0;
        for turn in 0..TURNS * m {
            let now = |i: usize| rates[i] + self.held_row(stops[i]).0.dot(&change);
            if (0..m).all(|i| now(i) >= -tiny) {
                return Some(change);
            }
            let i = (first + turn) % m;
            if now(i) < 0.0 {
                let slid: Vec<f64> = (0..sliding.len())
                    .map(|j| sliding[j] + self.held_row(self.rub_row(j)).0.dot(&change))
                    .collect();
                change += self.at_once(&stops[i..=i], &[now(i)], &slid, grips).ok()?.change;
            }
        }
        None
    }

    fn at_once(
        &self,
        stops: &[usize],
        rates: &[f64],
        sliding: &[f64],
        grips: &[Grip],
    ) -> Result<LeaningImpact> {
        let rubs = self.rubbing(stops);
        if rubs.len() > MOST || stops.len() > MOST_TRIED {
            return Err(Error::input(format!(
                "an impact on {} stops at once with {} rows of friction; at most {MOST_TRIED} and {MOST} are followed",
                stops.len(),
                rubs.len()
            )));
        }
        let goal = self.bounced(stops, rates);
        let size =
            rates.iter().chain(rubs.iter().map(|&j| &sliding[j])).fold(0.0, |most: f64, v| most.max(v.abs()));
        let mut ways: Vec<Vec<Grip>> = vec![grips.to_vec()];
        for &j in &rubs {
            let each = |way: Vec<Grip>| {
                [Grip::Stuck, Grip::Forward, Grip::Backward].map(|grip| {
                    let mut way = way.clone();
                    way[j] = grip;
                    way
                })
            };
            ways = ways.into_iter().flat_map(each).collect();
        }
        ways.sort_by_key(|way| way.iter().filter(|grip| grip.slides()).count());
        for way in ways {
            if let Some(found) = self.one_way(stops, &rubs, &goal, sliding, way, size) {
                return Ok(found);
            }
        }
        Err(Error::input("an impact with friction that Coulomb's and Newton's laws leave no answer for"))
    }

    /// The impact if friction goes on in this way, if it can.
    fn one_way(
        &self,
        stops: &[usize],
        rubs: &[usize],
        goal: &RealVector,
        sliding: &[f64],
        way: Vec<Grip>,
        size: f64,
    ) -> Option<LeaningImpact> {
        let stuck: Vec<usize> = rubs.iter().copied().filter(|&j| way[j] == Grip::Stuck).collect();
        let held: Vec<usize> = stuck.iter().map(|&j| self.rub_row(j)).collect();
        let own = RealVector::from_fn(held.len(), |i, _| sliding[stuck[i]]);
        let inner = self.among(&held).try_inverse()?;
        let (cross, back) = (self.among_along(stops, &held, &way), self.among_along(&held, stops, &way));
        let coupling = self.among_along(stops, stops, &way) - &cross * &inner * &back;
        let impulses = tried(&coupling, &(goal - &cross * &inner * &own))?;
        let load = RealVector::from_column_slice(&impulses);
        let holding = -&inner * (own + back * &load);
        let of = |stop: Option<usize>| {
            let at = stops.iter().position(|known| Some(*known) == stop);
            at.map_or(0.0, |i| impulses[i])
        };
        let most = |j: usize, by: f64| by * of(self.rubs()[j].stop);
        let within = |(&j, force): (&usize, &f64)| {
            let mobility = self.coupled(self.rub_row(j), self.rub_row(j));
            force.abs() <= most(j, self.rubs()[j].holding) + SMALL * size / mobility
        };
        if !stuck.iter().zip(holding.iter()).all(within) {
            return None;
        }
        let rows: Vec<usize> = stops.iter().chain(&held).copied().collect();
        let all: Vec<f64> = impulses.iter().chain(holding.iter()).copied().collect();
        let change = self.change_along(&rows, &all, &way);
        let slides_on = |&&j: &&usize| {
            let after = sliding[j] + self.held_row(self.rub_row(j)).0.dot(&change);
            !way[j].slides() || way[j].sign() * after >= -SMALL * size
        };
        if rubs.iter().filter(slides_on).count() < rubs.len() {
            return None;
        }
        let along = |&j: &usize| match stuck.iter().position(|known| *known == j) {
            Some(i) => (j, holding[i]),
            None => (j, -way[j].sign() * most(j, self.rubs()[j].sliding)),
        };
        let rubs = rubs.iter().map(along).collect();
        Some(LeaningImpact { impulses, rubs, grips: way, change, order_matters: false })
    }
}
