//! The Poincaré map of an orbit on a curve or a surface of states, to third order.
//!
//! Between impacts a machine is linear, so that displacements from the orbit, as polynomials, move by the
//! flow itself. At an impact they bring about a delay δ, where the gap is 0, and an incoming speed V, which
//! are polynomials again; seen at the orbit's own time, the impact adds V e^{−δA} κ to the state, A being the
//! matrix of the flow and κ the kick for V = 1. So all derivatives are exact to rounding, and nothing is
//! differenced. Not here: what the coefficients mean (`machine::normal_form`).

use super::{Change, StopEquations, turned};
use crate::{
    continuation::{Cubic, polynomial},
    error::{Error, Result},
    many::{RealMatrix, RealVector, State, algebra::stacked, orbit::leg::LegPassage},
};

/// Coefficients of a polynomial of degree 3 in two variables.
const TERMS: usize = 10;

/// Displacements from an orbit as polynomials of degree 3 in x and y that vanish at (0, 0), in the
/// coordinates of [`LinearFlow`] in which motions fall apart: a column for each of x, y, x², xy, y², x³, x²y,
/// xy², y³.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Surface(pub(crate) RealMatrix);

/// An impact beside the orbit's.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Beside {
    /// How much later it happens.
    pub delay: Cubic,
    /// Its incoming speed.
    pub speed: Cubic,
}

/// What the Poincaré map makes of a surface.
#[derive(Debug, Clone)]
pub(crate) struct Image {
    /// The displacements after the first impact when the orbit is back there.
    pub surface: Surface,
    /// The impacts on the way, by their number in the pattern: the first is the last to come.
    pub impacts: Vec<Beside>,
}

impl Surface {
    /// That of displacements x `first` + y `second`.
    pub fn plane(first: &RealVector, second: &RealVector) -> Surface {
        let mut all = RealMatrix::zeros(first.len(), TERMS - 1);
        all.set_column(0, first);
        all.set_column(1, second);
        Surface(all)
    }

    /// The same with x² `xx` + xy `xy` + y² `yy` added.
    #[must_use]
    pub fn bent(mut self, xx: &RealVector, xy: &RealVector, yy: &RealVector) -> Surface {
        for (j, column) in [xx, xy, yy].into_iter().enumerate() {
            self.0.column_mut(2 + j).axpy(1.0, column, 1.0);
        }
        self
    }

    /// A functional on it.
    fn seen(&self, row: &RealVector) -> Cubic {
        let all = self.0.tr_mul(row);
        Cubic::of(std::array::from_fn(|i| if i == 0 { 0.0 } else { all[i - 1] }))
    }

    /// Adds a polynomial, without its value at (0, 0), times a vector.
    fn add(&mut self, by: Cubic, vector: &RealVector) {
        for (j, coefficient) in by.coefficients()[1..].iter().enumerate() {
            self.0.column_mut(j).axpy(*coefficient, vector, 1.0);
        }
    }
}

/// The gap to a stop beside an orbit's impact: its Taylor coefficients in time at the orbit's own time.
struct Approach {
    /// Of the orbit's own gap.
    own: [f64; ORDERS],
    /// By displacements.
    rows: Vec<RealVector>,
}

/// Time derivatives of a gap that matter to third order, from the 0th on.
const ORDERS: usize = 5;

impl StopEquations<'_> {
    /// What the Poincaré map, from just after the first impact to there at fixed times, makes of a surface.
    /// Cost: O(m n) for modes, O(m n²) for the matrix exponential, with at most ten times that of a motion.
    ///
    /// # Errors
    /// No impacts, or one that does not come in: there is no map, or it is not smooth.
    pub fn image(&self, z: &[f64], surface: &Surface) -> Result<Image> {
        let m = self.pattern.strikes().len();
        let (mut state, times, speeds) = self.split(z);
        let flow = self.between.flow;
        let own = |i: usize| self.contact(i).law.is_some();
        if self.between.soft.is_some() || (0..m).any(own) {
            return Err(Error::input(
                "the Poincaré map's derivatives are not followed through stops that give way or impacts whose restitution depends \
                 on the speed, nor where forces are formulas",
            ));
        }
        if m == 0 || speeds.iter().any(|speed| speed.is_nan() || *speed <= 0.0) {
            return Err(Error::input("the Poincaré map is not smooth: an impact does not come in"));
        }
        let mut surface = surface.clone();
        let none = Beside { delay: Cubic::constant(0.0), speed: Cubic::constant(0.0) };
        let mut impacts = vec![none; m];
        for i in 0..m {
            let next = (i + 1) % m;
            let duration = self.duration(&times, i)?;
            for j in 0..surface.0.ncols() {
                let mut column = surface.0.column(j).into_owned();
                if column.amax() > 0.0 {
                    flow.advance(&mut column, duration);
                    surface.0.set_column(j, &column);
                }
            }
            let mut end = flow.after(&state, duration);
            end.t = turned(times[next]);
            let approach = self.approach(next, &end);
            let beside = arrive(&approach, &surface);
            impacts[next] = beside;
            // V Σ (−δ)^k A^k κ/k!.
            let (mut power, mut kick) = (beside.speed, flow.kick(&self.kick(next, speeds[next])));
            for k in 0..4 {
                surface.add(power, &kick);
                power = power * -beside.delay;
                kick = flow.generate(&kick) / f64::from(k + 1);
            }
            end.u.axpy(speeds[next], &self.kick(next, speeds[next]), 1.0);
            state = end;
        }
        Ok(Image { surface, impacts })
    }

    /// The displacement, in the coordinates of a [`Surface`], that a change of the parameter brings about in
    /// one round from a fixed state after the first impact at a fixed time.
    ///
    /// # Errors
    /// As [`image`](Self::image).
    pub fn drift(&self, z: &[f64], change: &Change) -> Result<RealVector> {
        let (n, m) = (self.size(), self.pattern.strikes().len());
        let (mut state, times, speeds) = self.split(z);
        let (mut x, flow) = (RealVector::zeros(2 * n), self.between.flow);
        for i in 0..m {
            let next = (i + 1) % m;
            let (duration, stop) = (self.duration(&times, i)?, self.pattern.strikes()[next].place);
            let LegPassage { mut end, phi, slope, .. } =
                self.between.passage(&state, duration, Some(change))?;
            x = phi * x + slope;
            end.t = turned(times[next]);
            let (kick, speed) = (self.kick(next, speeds[next]), speeds[next]);
            let contact = self.contact(next);
            let field = self.between.field(&end);
            let bend = contact.row.dot(&field.rows(n, n)) - contact.position.at(end.t)[2];
            let [gap, rate] = change.gap(stop, &end);
            let row = &contact.row;
            let delay = (row.dot(&x.rows(0, n)) + gap) / speed;
            let faster = -(row.dot(&x.rows(n, n)) + rate + bend * delay);
            // V e^{−δA} κ: κ dV + V κ′ − V δ Aκ.
            let whole = stacked(&RealVector::zeros(n), &(&kick * faster + change.kick(stop, speed) * speed));
            let moved = flow.outward(&flow.generate(&flow.kick(&kick)));
            x += whole - moved * (speed * delay);
            end.u.axpy(speed, &kick, 1.0);
            state = end;
        }
        Ok(flow.inward(&x.rows(0, n).into_owned(), &x.rows(n, n).into_owned()))
    }

    /// The displacement after the first impact at a fixed time, in the coordinates of a [`Surface`], that a
    /// change of the unknowns is.
    pub fn displacement(&self, z: &[f64], change: &[f64]) -> RealVector {
        let (n, s) = (self.size(), self.scale);
        let (state, ..) = self.split(z);
        let late = change.get(2 * n).copied().unwrap_or(0.0);
        let bend = self.between.flow.equations().acceleration(state.t, &state.q, &state.u);
        let q = RealVector::from_fn(n, |i, _| change[i] * s - state.u[i] * late);
        let u = RealVector::from_fn(n, |i, _| change[n + i] * s - bend[i] * late);
        self.between.flow.inward(&q, &u)
    }

    fn approach(&self, i: usize, end: &State) -> Approach {
        let (flow, contact) = (self.between.flow, self.contact(i));
        let mut rows = vec![flow.seen(&contact.row, &RealVector::zeros(self.size()))];
        for k in 1..ORDERS {
            let next = flow.generate_row(&rows[k - 1]) / k as f64;
            rows.push(next);
        }
        let particular = flow.expand(end.t, 1.0, ORDERS);
        let y = flow.split(end);
        let mut place = contact.position.clone();
        let mut factorial = 1.0;
        let own = std::array::from_fn(|k| {
            factorial *= (k as f64).max(1.0);
            let wall = place.at(end.t)[0] / factorial;
            place = place.derivative();
            rows[0].dot(&particular[k]) + rows[k].dot(&y) - wall
        });
        Approach { own, rows }
    }
}

/// When the states of a surface meet the stop, and how fast: Newton's iteration, exact after three.
fn arrive(approach: &Approach, surface: &Surface) -> Beside {
    let mut gap: Vec<Cubic> = approach
        .own
        .iter()
        .zip(&approach.rows)
        .map(|(own, row)| Cubic::constant(*own) + surface.seen(row))
        .collect();
    // The orbit's own impact is at this time, whatever rounding has left.
    gap[0] = gap[0].without_value();
    let per_speed = -gap[1].inverse();
    let mut delay = Cubic::constant(0.0);
    for _ in 0..3 {
        delay = (gap[0] + delay * delay * (gap[2] + delay * gap[3])) * per_speed;
    }
    let slope: Vec<Cubic> = (1..ORDERS).map(|k| gap[k].scaled(-(k as f64))).collect();
    Beside { delay, speed: polynomial(&slope, delay) }
}
