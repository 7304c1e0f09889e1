//! What a periodic orbit with a given impact pattern solves, and the trace and determinant of its
//! linearisation.
//!
//! Unknowns: the phases t_1, …, t_m and the incoming relative speeds V_1, …, V_m. Impact i + 1 comes 2π n_i +
//! t_{i+1} − t_i after impact i; there the gap is 0 and closes at speed V_{i+1}: 2m equations.

use num_bigint::BigInt;

use super::{
    ExpectedImpact, Jet,
    linear::{Flight, Linear},
};
use crate::{
    error::Result,
    motion::Side,
    number::{Elementary, Real},
};

/// The equations of a pattern.
pub(super) struct Equations<'a> {
    pub(crate) linear: &'a Linear<'a>,
    pub(crate) impacts: &'a [ExpectedImpact],
}

/// One flight of an orbit: from an impact to the next.
pub(super) struct Leg {
    pub flight: Flight,
    pub from: Side,
    pub to: Side,
    /// How long it lasts, and the phase at its end.
    pub duration: Jet,
    pub end: Jet,
    /// Whether it leaves no wall and meets none.
    pub free: bool,
}

impl Equations<'_> {
    /// The flights of unknowns that begin with t_1, …, t_m, V_1, …, V_m.
    pub(crate) fn legs(&self, unknowns: &[Jet]) -> Result<Vec<Leg>> {
        let (precision, m) = (self.linear.precision, self.impacts.len());
        let turn = Jet::pi(precision) * &Jet::integer(2, precision);
        let leg = |i: usize| {
            let next = (i + 1) % m;
            let (impact, phase, end) = (&self.impacts[i], &unknowns[i], &unknowns[next]);
            let periods = Jet::ratio(&BigInt::from(impact.periods).into(), precision) * &turn;
            Ok(Leg {
                flight: self.linear.depart(impact.side, phase, &unknowns[m + i])?,
                from: impact.side,
                to: self.impacts[next].side,
                // With one impact the phases cancel, which enclosures would not see.
                duration: if m == 1 { periods } else { periods + end - phase },
                end: end.clone(),
                free: false,
            })
        };
        (0..m).map(leg).collect()
    }

    /// A period of the response without impacts, of which the middle is at phase `t`.
    pub(crate) fn free(&self, t: &Jet) -> Result<Leg> {
        let half = Jet::pi(self.linear.precision);
        let flight = self.linear.steady(&(t.clone() - &half))?;
        let (duration, end) = (half.clone() + &half, t.clone() + &half);
        Ok(Leg { flight, from: Side::Lower, to: Side::Lower, duration, end, free: true })
    }

    /// The gap at the end of each flight, and the sum of its derivative there and V.
    pub(crate) fn residual(&self, unknowns: &[Jet]) -> Result<Vec<Jet>> {
        let m = self.impacts.len();
        let mut values = Vec::with_capacity(2 * m);
        for (i, leg) in self.legs(unknowns)?.iter().enumerate() {
            let [gap, speed, _] = self.linear.gap_at(&leg.flight, leg.to, &leg.duration, &leg.end)?;
            values.push(gap);
            values.push(speed + &unknowns[m + (i + 1) % m]);
        }
        Ok(values)
    }

    /// The trace and determinant of the linearised map once round the orbit.
    ///
    /// It is the product of flights E(τ_i) and of impacts [[−τ, 0], [−(τ z₋″ + z₊″)/V, −τ]], in the
    /// displacement and velocity away from the wall, z the gap just before and after: a perturbed orbit meets
    /// the wall δz/V later. The determinant is that of the factors, Π τ² det E: near grazing the entries grow
    /// like 1/V, and their products would cancel.
    pub(crate) fn multipliers(&self, unknowns: &[Jet]) -> Result<(Jet, Jet)> {
        let (linear, m) = (self.linear, self.impacts.len());
        let mut product = [[1, 0], [0, 1]].map(|row| row.map(|x| Jet::integer(x, linear.precision)));
        let mut determinant = Jet::integer(1, linear.precision);
        for (i, leg) in self.legs(unknowns)?.iter().enumerate() {
            let (phase, velocity) = (&unknowns[i], &unknowns[m + i]);
            let restitution = &linear.wall(leg.from)?.restitution;
            let [position, speed, curvature] = linear.wall_motion(leg.from, phase)?;
            let bend = |relative: Jet| {
                let u = speed.clone() + &linear.inward(leg.from, relative);
                let a = linear.acceleration(&position, &u, phase) - &curvature;
                linear.inward(leg.from, a)
            };
            let (before, after) = (bend(-velocity.clone()), bend(restitution.clone() * velocity));
            let kick = -(restitution.clone() * &before + &after) / velocity;
            let zero = Jet::integer(0, linear.precision);
            let impact = [[-restitution.clone(), zero], [kick, -restitution.clone()]];
            let flow = linear.propagator(&leg.duration);
            let [[a, b], [c, d]] = &flow;
            let area = a.clone() * d - &(b.clone() * c);
            determinant = determinant * restitution * restitution * &area;
            product = times(&times(&flow, &impact), &product);
        }
        let [[a, _], [_, d]] = product;
        Ok((a + &d, determinant))
    }
}

fn times(a: &[[Jet; 2]; 2], b: &[[Jet; 2]; 2]) -> [[Jet; 2]; 2] {
    let entry = |i: usize, j: usize| a[i][0].clone() * &b[0][j] + &(a[i][1].clone() * &b[1][j]);
    [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
}
