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
    brace::Brace,
    contact::{Contacts, ImpactLaw, MOST_TRIED, complementary, in_turn, tried},
};
use crate::{
    error::{Error, Result},
    motion::Series,
    rounding::SUM,
};

/// More rows than this at one impact are refused: all ways in which they go on are tried.
const MOST: usize = 6;

/// What meets at one instant.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Blow<'a> {
    /// The stops.
    pub stops: &'a [usize],
    /// The rates of their gaps.
    pub rates: &'a [f64],
    /// The velocities of all friction.
    pub sliding: &'a [f64],
    /// How it moved before.
    pub grips: &'a [Grip],
}

/// What an impact does, with friction or without.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Struck {
    /// The impulses, one for each stop.
    pub impulses: Vec<f64>,
    /// The energy that the friction at each stop takes.
    pub rubbed: Vec<f64>,
    /// How all friction goes on; what has no part in it as it was.
    pub grips: Vec<Grip>,
    /// The change of velocity.
    pub change: RealVector,
    /// Whether impacts one after the other, in some order, would have ended with other velocities.
    pub order_matters: bool,
}

impl Contacts {
    /// The impact, by the law of the head where there is friction on the stops. Cost: O(3^r 2^m (m + r)³) for
    /// m stops and r rows of friction at them.
    ///
    /// # Errors
    /// Those of [`impact`](Self::impact); more than 12 stops with friction or six rows of it; none of the
    /// ways to go on is one.
    pub(crate) fn struck(&self, blow: &Blow) -> Result<Struck> {
        let Blow { stops, rates, sliding, grips } = *blow;
        if self.rubs().is_empty() || self.rubbing(stops).is_empty() {
            let ImpactLaw { impulses, change, order_matters } = self.impact(stops, rates)?;
            let rubbed = vec![0.0; stops.len()];
            return Ok(Struck { impulses, rubbed, grips: grips.to_vec(), change, order_matters });
        }
        let mut found = self.leaning_impact(blow)?;
        if stops.len() > 1 {
            let size = rates.iter().fold(0.0, |most: f64, rate| most.max(rate.abs()));
            let faster = |change: &RealVector| {
                RealVector::from_fn(stops.len(), |i, _| self.held_row(stops[i]).0.dot(change))
            };
            let after = RealVector::from_column_slice(rates) + faster(&found.change);
            found.order_matters = (0..stops.len()).any(|first| {
                let mut change = &found.change * 0.0;
                let ended = in_turn(rates, first, |i, rate| {
                    let slid = |j: usize| sliding[j] + self.held_row(self.rub_row(j)).0.dot(&change);
                    let slid: Vec<f64> = (0..sliding.len()).map(slid).collect();
                    let one = Blow { stops: &stops[i..=i], rates: &[rate], sliding: &slid, grips };
                    let one = self.leaning_impact(&one).ok()?.change;
                    change += &one;
                    Some(faster(&one))
                });
                ended.is_none_or(|ended| (ended - &after).amax() > 1e-9 * size)
            });
        }
        Ok(found)
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

    /// Forces of stops of which each presses or is let go of: none if there is no answer.
    ///
    /// # Errors
    /// As [`complementary`]; more than 12 stops of which some lean.
    pub(super) fn loads(
        &self,
        stops: &[usize],
        grips: &[Grip],
        (coupling, b): (&RealMatrix, &RealVector),
    ) -> Result<Option<Vec<f64>>> {
        if !self.leans(stops, grips) {
            return complementary(coupling, b).map(Some);
        }
        if stops.len() > MOST_TRIED {
            return Err(Error::input(format!(
                "{} stops are rested on at once where there is friction on some; at most {MOST_TRIED} are followed",
                stops.len()
            )));
        }
        Ok(tried(coupling, b))
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

    /// Whether a row with friction can have no velocity, whatever happens, where these rows are held: it is a
    /// combination of them, and its surface moves with theirs. Two feet of a body on one floor are such rows.
    pub(super) fn follows(&self, rub: usize, held: &[usize]) -> bool {
        let (row, own) = (self.rub_row(rub), self.rubs()[rub].velocity());
        let Some(weights) = self.weights(row, held) else { return false };
        let velocity = |&row: &usize| match self.all().get(row) {
            Some(contact) => contact.position.derivative(),
            None => self.rubs()[row - self.all().len()].velocity(),
        };
        let all: Vec<Series> = held.iter().map(velocity).collect();
        let others = weights.iter().zip(&all).map(|(weight, velocity)| (-weight, velocity));
        let parts: Vec<(f64, &Series)> = [(1.0, &own)].into_iter().chain(others).collect();
        let size = |series: &Series| series.mean().abs() + series.derivative_bound(0);
        let whole: f64 = parts.iter().map(|(weight, series)| weight.abs() * size(series)).sum();
        size(&Series::combination(&parts)) <= SUM * whole
    }

    /// A row as a combination of others, which are independent, if it is one.
    pub(super) fn weights(&self, row: usize, others: &[usize]) -> Option<RealVector> {
        if others.is_empty() {
            return None;
        }
        let inverse = self.among(others).try_inverse()?;
        let seen = RealVector::from_fn(others.len(), |i, _| self.coupled(others[i], row));
        let weights = inverse * &seen;
        let left = self.mobility(row) - weights.dot(&seen);
        (left <= SUM * self.mobility(row)).then_some(weights)
    }

    /// The friction under the force of one of some stops.
    pub(super) fn rubbing(&self, stops: &[usize]) -> Vec<usize> {
        if self.rubs().is_empty() {
            return Vec::new();
        }
        let under = |j: &usize| self.rubs()[*j].stop.is_some_and(|stop| stops.contains(&stop));
        (0..self.rubs().len()).filter(under).collect()
    }

    fn leaning_impact(&self, blow: &Blow) -> Result<Struck> {
        let Blow { stops, rates, grips, .. } = *blow;
        let rubs = self.rubbing(stops);
        if rubs.len() > MOST || stops.len() > MOST_TRIED {
            return Err(Error::input(format!(
                "an impact on {} stops at once with {} rows of friction; at most {MOST_TRIED} and {MOST} are followed",
                stops.len(),
                rubs.len()
            )));
        }
        let goal = self.bounced(stops, rates);
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
        ways.into_iter()
            .find_map(|way| self.one_way(&Blow { grips: &way, ..*blow }, &rubs, &goal))
            .ok_or_else(|| {
                let names: Vec<&str> = stops.iter().map(|&stop| self.all()[stop].name.as_str()).collect();
                Error::input(format!(
                    "an impact with friction on {} that Coulomb's and Newton's laws leave no answer for",
                    names.join(", ")
                ))
            })
    }

    /// The impact if its friction, `rubs`, goes on as `grips` say, if it can.
    fn one_way(&self, blow: &Blow, rubs: &[usize], goal: &RealVector) -> Option<Struck> {
        let Blow { stops, rates, sliding, grips: way } = *blow;
        let fastest = rates.iter().chain(rubs.iter().map(|&j| &sliding[j]));
        let size = fastest.fold(0.0, |most: f64, v| most.max(v.abs()));
        let stuck: Vec<usize> = rubs.iter().copied().filter(|&j| way[j] == Grip::Stuck).collect();
        let basis = self.basis(&stuck);
        let held: Vec<usize> = basis.iter().map(|&j| self.rub_row(j)).collect();
        let own = RealVector::from_fn(held.len(), |i, _| sliding[basis[i]]);
        let inner = self.among(&held).try_inverse()?;
        let (cross, back) = (self.among_along(stops, &held, way), self.among_along(&held, stops, way));
        let coupling = self.among_along(stops, stops, way) - &cross * &inner * &back;
        let impulses = tried(&coupling, &(goal - &cross * &inner * &own))?;
        let holding = -&inner * (own + back * RealVector::from_column_slice(&impulses));
        let rows: Vec<usize> = stops.iter().chain(&held).copied().collect();
        let all: Vec<f64> = impulses.iter().chain(holding.iter()).copied().collect();
        let change = self.change_along(&rows, &all, way);
        let held_by = |j: usize| basis.iter().position(|known| *known == j).map_or(0.0, |i| holding[i]);
        let at = |j: usize| stops.iter().position(|stop| self.rubs()[j].stop == Some(*stop));
        for Brace { needed, parts } in self.braces(&stuck).ok()? {
            let force = |(j, factor): &(usize, f64)| factor * held_by(*j) * self.mobility(self.rub_row(*j));
            let most = |(j, part): &(usize, f64)| {
                let spare = SUM * size / self.mobility(self.rub_row(*j));
                at(*j).map_or(0.0, |at| part.abs() * (self.rubs()[*j].holding * impulses[at] + spare))
            };
            if needed.iter().map(force).sum::<f64>().abs() > parts.iter().map(most).sum() {
                return None;
            }
        }
        let mut rubbed = vec![0.0; stops.len()];
        for &j in rubs {
            let (rub, row, at) = (&self.rubs()[j], self.rub_row(j), at(j)?);
            let after = sliding[j] + self.held_row(row).0.dot(&change);
            let impulse = match way[j] {
                // What depends on the rest of what sticks is held by that, if its surface moves along.
                Grip::Stuck if !basis.contains(&j) && !self.follows(j, &held) => return None,
                Grip::Stuck => held_by(j),
                _ if way[j].sign() * after < -SUM * size => return None,
                _ => -way[j].sign() * rub.sliding * impulses[at],
            };
            rubbed[at] -= 0.5 * impulse * (sliding[j] + after);
        }
        Some(Struck { impulses, rubbed, grips: way.to_vec(), change, order_matters: false })
    }
}
