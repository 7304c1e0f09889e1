//! Pieces of time on which the gaps are seen to be positive, by the checker's test in floats, without
//! guarantee.

use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::{linear::apply, motion::Motion};
use crate::{
    number::{FloatInterval, Real},
    orbit::rounded,
};

/// No piece is cut below this.
const FINEST: f64 = 1e-9;
/// The most pieces of a flight.
const MOST: usize = 50_000;

/// A flight: what it starts from, the stops it leaves and meets, if it does, how long it lasts.
pub(super) struct Flight {
    pub motion: Motion<FloatInterval>,
    pub start: Vec<FloatInterval>,
    pub stops: Option<[usize; 2]>,
    pub duration: f64,
}

/// Their ends, the last after the flight's; a gap that cannot be shown to be positive, and when, as an error.
pub(super) fn pieces(flight: &Flight) -> Result<Vec<BigRational>, String> {
    let end = flight.duration + 1e-9;
    let mut ends: Vec<BigRational> = Vec::new();
    let mut todo = vec![(0.0, end)];
    while let Some((from, to)) = todo.pop() {
        let last = to == end;
        let doubtful = if to - from <= 0.5 { flight.doubtful(from, to, last) } else { Some(0) };
        let Some(stop) = doubtful else {
            ends.push(decimal(to, last));
            continue;
        };
        if to - from < FINEST || ends.len() > MOST {
            return Err(format!("the gap to stop {} cannot be told from 0 {from:.6}", stop + 1));
        }
        // Few decimals, near the middle.
        let places = (1..12).find(|&places| to - from > 8.0 * 10f64.powi(-places)).unwrap_or(12);
        let scale = 10f64.powi(places);
        let middle = ((from + to) / 2.0 * scale).round() / scale;
        todo.extend([(middle, to), (from, middle)]);
    }
    Ok(ends)
}

/// The nearest number of twelve decimals; the last is not before the end.
fn decimal(x: f64, last: bool) -> BigRational {
    let more = if last { 1e-11 } else { 0.0 };
    rounded(&BigRational::from_float(x + more).unwrap_or_default(), 12)
}

impl Flight {
    /// A stop whose gap is not seen to be positive on a piece.
    fn doubtful(&self, from: f64, to: f64, last: bool) -> Option<usize> {
        let (middle, half) = ((from + to) / 2.0, (to - from) / 2.0);
        let motion = &self.motion;
        let point = FloatInterval::from_bounds(middle, middle);
        let away = FloatInterval::from_bounds(-half, half);
        let at_middle = apply(&motion.flow(&point, middle), &self.start, &());
        let over = apply(&motion.flow(&away, half), &at_middle, &());
        let bends = motion.field(&motion.field(&over));
        let positive = |x: &FloatInterval, margin: f64| x.lo() > margin;
        (0..motion.stops.len()).find(|&stop| {
            let [gap, rate] = motion.gap(stop, &at_middle);
            let row = &motion.stops[stop].0;
            // The checker adds up the same in another order: twice as wide is on the safe side.
            let bend =
                row.iter().zip(&bends).fold(FloatInterval::integer(0, &()), |sum, (w, x)| sum + &(*w * x));
            let spread = (bend.hi() - bend.lo()) / 2.0;
            let bend = FloatInterval::from_bounds(bend.lo() - spread, bend.hi() + spread);
            let slope = rate + &(bend * &away);
            let square = FloatInterval::from_bounds(0.0, half * half / 2.0 * (1.0 + 1e-12));
            let gap = gap + &(rate * &away) + &(bend * &square);
            let is = |i: usize| self.stops.is_some_and(|stops| stops[i] == stop);
            let leaves = from == 0.0 && is(0) && (positive(&slope, 0.0) || positive(&bend, 0.0));
            let meets = last && is(1) && slope.hi() < 0.0;
            !(positive(&gap, 0.0) || leaves || meets)
        })
    }
}

/// The float nearest to a number.
pub(super) fn nearest(x: &BigRational) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}
