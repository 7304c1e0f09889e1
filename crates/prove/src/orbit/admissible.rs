//! Whether the gaps stay positive between impacts: each flight is cut into pieces of time, each proved by
//! itself.
//!
//! On a piece of half-width r about m, z lies in z(m) + z′(m)[−r, r] + z″[0, r²/2] and z′ in z′(m) + z″[−r,
//! r], z″ enclosed over the whole piece. It passes if z > 0 there; or, for the gap that the flight starts
//! from, if it is the first and z′ > 0 or z″ > 0 (z = 0 ≤ z′ at its start); or, for the gap that it ends at,
//! if it is the last and z′ < 0, or z″ > 0 (z = 0 > z′ at its end, so that z′ < 0 before); or, about a known
//! tangency, if z″ > 0. Pieces are at most 1/2 long, so that
//! cruder enclosures than these pass them too.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero, pow};

use super::{
    Jet, Verdict,
    equations::{Equations, Leg},
    krawczyk::rounded,
};
use crate::{
    error::Result,
    motion::Side,
    number::{Ball, Elementary, Real, Sign},
};

/// A tangency that is known: in which flight, with which wall, when.
pub(super) struct Touch {
    pub flight: usize,
    pub side: Side,
    pub time: Ball,
    /// Its phase.
    pub phase: Jet,
}

/// Decimals of a flight's end.
const END: u32 = 12;

/// No piece is cut below this many decimals of time. A gap that is told from 0 by `bits` bits has its least
/// value for a time of half as many, as it bends; a certificate holds 30 decimals.
fn finest(bits: u32) -> u32 {
    (bits * 3 / 20).clamp(END, 30)
}

/// For each flight, the ends of pieces that prove it; the last is at or after the flight's end.
pub(super) type Pieces = Vec<Vec<BigRational>>;

/// Proves every flight of the orbit at `unknowns`, or finds a gap that is certainly negative.
pub(super) fn prove(
    equations: &Equations,
    unknowns: &[Jet],
    touch: Option<&Touch>,
) -> Result<Verdict<Pieces>> {
    let mut all = Vec::new();
    let legs = match touch {
        Some(touch) if equations.impacts.is_empty() => vec![equations.free(&touch.phase)?],
        // From phase 0 on.
        None if equations.impacts.is_empty() => vec![equations.free(&Jet::pi(equations.linear.precision))?],
        _ => equations.legs(unknowns)?,
    };
    for (index, leg) in legs.iter().enumerate() {
        let after = match (equations.impacts.is_empty(), touch.is_some()) {
            (false, _) => format!("after impact {}", index + 1),
            (true, false) => "after phase 0".into(),
            (true, true) => "after half a period before the contact".into(),
        };
        match pieces(equations, leg, touch.filter(|touch| touch.flight == index))? {
            Verdict::Proved(ends) => all.push(ends),
            Verdict::Refuted(why) => return Ok(Verdict::Refuted(format!("{why} {after}"))),
            Verdict::Undecided(why) => return Ok(Verdict::Undecided(format!("{why} {after}"))),
        }
    }
    Ok(Verdict::Proved(all))
}

/// Halves pieces of one flight until each passes; their ends.
fn pieces(equations: &Equations, leg: &Leg, touch: Option<&Touch>) -> Result<Verdict<Vec<BigRational>>> {
    let Some((earliest, latest)) = leg.duration.value.exact_bounds() else {
        return Ok(Verdict::Undecided("nothing is known of the flight".into()));
    };
    if !earliest.is_positive() {
        return Ok(Verdict::Undecided("the flight may last no time".into()));
    }
    if let Some(touch) = touch {
        let inside = |(lo, hi): (BigRational, BigRational)| lo.is_positive() && hi < earliest;
        if !touch.time.exact_bounds().is_some_and(inside) {
            return Ok(Verdict::Undecided("the tangency is not certainly in the flight".into()));
        }
    }
    let tenths = |places: u32| BigRational::new(1.into(), pow(BigInt::from(10), places as usize));
    let end = rounded(&(latest + tenths(END)), END);
    let finest = finest(equations.linear.precision.bits());
    let two = BigRational::from_integer(2.into());
    let mut ends = Vec::new();
    let mut left = vec![(BigRational::zero(), end.clone())];
    while let Some((from, to)) = left.pop() {
        let length = &to - &from;
        let piece = Piece { from: &from, to: &to, last: to == end };
        if &length * &two <= BigRational::one() && piece.passes(equations, leg, touch)? {
            ends.push(to);
            continue;
        }
        let middle = (&from + &to) / &two;
        let time = middle.to_f64().unwrap_or(f64::NAN);
        if let Some(side) = negative(equations, leg, &middle, &earliest)? {
            return Ok(Verdict::Refuted(format!(
                "the gap to the {} wall is negative {time:.6}",
                side.name()
            )));
        }
        if length < tenths(finest - 3) {
            return Ok(Verdict::Undecided(format!("a gap cannot be told from 0 {time:.6}")));
        }
        // Few decimals, near the middle.
        let places = (1..finest).find(|&places| length > tenths(places) * BigInt::from(8)).unwrap_or(finest);
        let middle = rounded(&middle, places);
        left.push((middle.clone(), to));
        left.push((from, middle));
    }
    Ok(Verdict::Proved(ends))
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
    fn passes(&self, equations: &Equations, leg: &Leg, touch: Option<&Touch>) -> Result<bool> {
        let precision = equations.linear.precision;
        let two = BigRational::from_integer(2.into());
        let (middle, half) = ((self.from + self.to) / &two, (self.to - self.from) / &two);
        let whole = Jet::constant(Ball::between(self.from, self.to, precision));
        let reach = Jet::constant(Ball::between(&-&half, &half, precision));
        let bent = Jet::constant(Ball::between(&BigRational::zero(), &(&half * &half / &two), precision));
        let touches = touch.is_some_and(|touch| {
            touch.time.exact_bounds().is_some_and(|(lo, hi)| *self.from < lo && hi < *self.to)
        });
        let positive = |x: &Jet| x.sign() == Some(Sign::Positive);
        for side in equations.linear.sides() {
            let [gap, slope, _] = equations.linear.gap(&leg.flight, side, &Jet::ratio(&middle, precision))?;
            let [_, _, curvature] = equations.linear.gap(&leg.flight, side, &whole)?;
            let over = slope.clone() + &(curvature.clone() * &reach);
            let gap = gap + &(slope * &reach) + &(curvature.clone() * &bent);
            let first = !leg.free
                && self.from.is_zero()
                && side == leg.from
                && (positive(&over) || positive(&curvature));
            let last = !leg.free && self.last && side == leg.to && (positive(&-over) || positive(&curvature));
            let touching = touches && touch.is_some_and(|touch| touch.side == side) && positive(&curvature);
            if !(positive(&gap) || first || last || touching) {
                return Ok(false);
            }
        }
        Ok(true)
    }
}
