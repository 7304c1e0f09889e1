//! Whether the gaps stay positive between impacts: each flight is cut into pieces of time, each proved by itself.
//!
//! On a piece of half-width r about m, z lies in z(m) + z′(m)[−r, r] + z″[0, r²/2] and z′ in z′(m) + z″[−r, r], z″ enclosed over the whole
//! piece. It passes if z > 0 there; or, for the gap that the flight starts from, if it is the first and z′ > 0 or z″ > 0 (z = 0 ≤ z′ at its start);
//! or, for the gap that it ends at, if it is the last and z′ < 0; or, about a known tangency, if z″ > 0.

use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::{
    Jet, Verdict,
    equations::{Equations, Leg},
    krawczyk::rounded,
    linear::Motion,
};
use crate::{
    error::Result,
    number::{Ball, Precision, Real, Sign},
    oscillator::Side,
};

/// A tangency that is known: in which flight, with which wall, when.
pub(super) struct Touch {
    pub flight: usize,
    pub side: Side,
    pub time: Ball,
}

/// No piece is cut below this many decimals of time.
const FINEST: u32 = 12;

/// For each flight, the ends of pieces that prove it; the last is at or after the flight's end.
pub(super) type Pieces = Vec<Vec<BigRational>>;

/// Proves every flight of the orbit at `unknowns`, or finds a gap that is certainly negative.
pub(super) fn prove(
    equations: &Equations,
    unknowns: &[Jet],
    touch: Option<&Touch>,
) -> Result<Verdict<Pieces>> {
    let precision = equations.linear.precision;
    let mut all = Vec::new();
    for (index, leg) in equations.legs(unknowns)?.iter().enumerate() {
        let Some((earliest, latest)) = leg.duration.value.exact_bounds() else {
            return Ok(Verdict::Undecided("an impact's time is not enclosed".into()));
        };
        if !earliest.is_positive() {
            return Ok(Verdict::Undecided(format!("flight {} may last no time", index + 1)));
        }
        let unit = BigRational::new(1.into(), num_traits::pow(10.into(), FINEST as usize));
        let end = rounded(&(latest + &unit), FINEST);
        let touch = touch.filter(|touch| touch.flight == index);
        let longest = BigRational::new(1.into(), 2.into());
        let mut ends = Vec::new();
        let mut left = vec![(BigRational::zero(), end.clone())];
        while let Some((from, to)) = left.pop() {
            let mut passed = &to - &from <= longest;
            for side in equations.linear.sides() {
                let piece = Piece { from: &from, to: &to, last: to == end };
                passed = passed && piece.passes(equations, leg, side, touch, precision)?;
            }
            if passed {
                ends.push(to);
                continue;
            }
            let middle = (&from + &to) / BigRational::from_integer(2.into());
            if let Some(side) = negative(equations, leg, &middle, &earliest)? {
                return Ok(Verdict::Refuted(format!(
                    "the gap to the {side} wall is negative {:.6} after impact {}",
                    num_traits::ToPrimitive::to_f64(&middle).unwrap_or(f64::NAN),
                    index + 1
                )));
            }
            if &to - &from < &unit * BigRational::from_integer(1000.into()) {
                return Ok(Verdict::Undecided(format!(
                    "a gap cannot be told from 0 near {:.6} after impact {}",
                    num_traits::ToPrimitive::to_f64(&middle).unwrap_or(f64::NAN),
                    index + 1
                )));
            }
            // Few decimals, near the middle.
            let places = (1..=FINEST).find(|&places| {
                &to - &from > BigRational::new(8.into(), num_traits::pow(10.into(), places as usize))
            });
            let middle = rounded(&middle, places.unwrap_or(FINEST));
            left.push((middle.clone(), to));
            left.push((from, middle));
        }
        all.push(ends);
    }
    Ok(Verdict::Proved(all))
}

/// The side whose gap is certainly negative at a time certainly before the flight's end.
fn negative(
    equations: &Equations,
    leg: &Leg,
    time: &BigRational,
    earliest: &BigRational,
) -> Result<Option<Side>> {
    if time >= earliest {
        return Ok(None);
    }
    for side in equations.linear.sides() {
        let [gap, ..] =
            equations.linear.gap(&leg.flight, side, &Jet::ratio(time, equations.linear.precision))?;
        if gap.sign() == Some(Sign::Negative) {
            return Ok(Some(side));
        }
    }
    Ok(None)
}

struct Piece<'a> {
    from: &'a BigRational,
    to: &'a BigRational,
    last: bool,
}

impl Piece<'_> {
    fn passes(
        &self,
        equations: &Equations,
        leg: &Leg,
        side: Side,
        touch: Option<&Touch>,
        precision: &Precision,
    ) -> Result<bool> {
        let two = BigRational::from_integer(2.into());
        let (middle, half) = ((self.from + self.to) / &two, (self.to - self.from) / &two);
        let whole = Jet::constant(Ball::between(self.from, self.to, precision));
        let at = |time: &Jet| equations.linear.gap(&leg.flight, side, time);
        let [gap, slope, _]: Motion = at(&Jet::ratio(&middle, precision))?;
        let [_, _, curvature] = at(&whole)?;
        let reach = Jet::constant(Ball::between(&-&half, &half, precision));
        let bent = Ball::between(&BigRational::zero(), &(&half * &half / &two), precision);
        let positive = |x: &Jet| x.sign() == Some(Sign::Positive);
        let over = slope.clone() + &(curvature.clone() * &reach);
        let gap = gap + &(slope * &reach) + &(curvature.clone() * &Jet::constant(bent));
        let first = self.from.is_zero() && side == leg.from && (positive(&over) || positive(&curvature));
        let last = self.last && side == leg.to && positive(&-over);
        let touching = touch.is_some_and(|touch| {
            let inside = touch.time.exact_bounds().is_some_and(|(lo, hi)| *self.from < lo && hi < *self.to);
            touch.side == side && inside && positive(&curvature)
        });
        Ok(positive(&gap) || first || last || touching)
    }
}
