//! Is a solution of the pattern equations an orbit? (20), (21), and every other minimum of every gap
//! positive.

use std::f64::consts::PI;

use super::{
    super::{
        Side,
        flow::{Flow, State},
    },
    Itinerary, Oscillator,
    passage::Unknowns,
};

/// A local minimum of the gap to a wall between impacts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Minimum {
    /// The wall.
    pub side: Side,
    /// The impact whose leg it is on, from 0; 0 for an orbit without impacts.
    pub leg: usize,
    /// The time since that leg began.
    pub after: f64,
    /// The distance to the wall; negative behind it.
    pub gap: f64,
}

/// Whether a solution is an orbit, and if not, the first reason that is found.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Admissibility {
    /// Every impact comes in and every other minimum of every gap is positive.
    Admissible,
    /// This impact, from 0, has V ≤ 0 (21).
    Outgoing(usize),
    /// The least minimum is not positive (20): a forbidden excursion.
    Excursion(Minimum),
}

impl Admissibility {
    /// Whether it is an orbit.
    pub fn is_admissible(&self) -> bool {
        matches!(self, Admissibility::Admissible)
    }
}

/// What admissibility rests on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Check {
    /// The answer.
    pub admissibility: Admissibility,
    /// The least of the other minima of the gaps; `None` if there is none.
    pub least: Option<Minimum>,
}

/// Checks a solution z of the pattern equations. Cost: about 16 flows for each period of the fastest rate of
/// the system.
pub fn check(oscillator: &Oscillator, itinerary: &Itinerary, z: &[f64]) -> Check {
    let strikes = itinerary.strikes();
    let mut least: Option<Minimum> = None;
    let mut search = |leg, from, time| {
        for found in minima(oscillator, leg, from, time) {
            if least.is_none_or(|least| found.gap < least.gap) {
                least = Some(found);
            }
        }
    };
    if strikes.is_empty() {
        let from = State { t: 0.0, q: z[0], u: z[1] };
        // A little more than the period: a minimum at its ends counts too.
        let time = 2.0 * PI * f64::from(itinerary.periods()) + 0.1 / oscillator.rate(&from);
        search(0, from, time);
    }
    let unknowns = Unknowns::new(itinerary, z);
    for passage in unknowns.iter().flat_map(|unknowns| unknowns.passages(oscillator)).flatten() {
        search(passage.index, passage.from, passage.duration);
    }
    let outgoing =
        unknowns.iter().flat_map(Unknowns::speeds).position(|speed| speed.is_nan() || speed <= 0.0);
    let admissibility = match (outgoing, least) {
        (Some(i), _) => Admissibility::Outgoing(i),
        (None, Some(least)) if least.gap <= 0.0 => Admissibility::Excursion(least),
        _ => Admissibility::Admissible,
    };
    Check { admissibility, least }
}

/// How near the end of a leg a contact without speed belongs to the impact there: gaps there are of the order
/// of its square.
const ROUNDING: f64 = 1e-6;

/// The local minima of the gaps on an open stretch of motion.
///
/// A cell is a sixteenth of the fastest period (but there are no more than 10⁶), searched by
/// [`minimum_within`].
pub(in crate::oscillator) fn minima(
    oscillator: &Oscillator,
    leg: usize,
    from: State,
    time: f64,
) -> Vec<Minimum> {
    let flow = oscillator.flow();
    let mut found = Vec::new();
    for wall in oscillator.walls() {
        let side = wall.side;
        // (z, z′, z″) of a state.
        let gap = |state: State| {
            let [z, speed] = wall.gap(state);
            [z, speed, wall.acceleration(flow, state)]
        };
        let (mut start, mut begun) = (from, 0.0);
        while begun < time {
            let width = (PI / 8.0 / oscillator.rate(&start)).max(1e-6 * time).min(time - begun);
            let at = |after: f64| gap(flow.advance(start, after));
            let (a, b) = (gap(start), at(width));
            if let Some(root) = minimum_within(at, a, b, width) {
                let (after, least) = (begun + root, at(root)[0]);
                // A leg that begins or ends without speed has a minimum there, which rounding may bring
                // inside.
                if after.min(time - after) > ROUNDING || least.abs() > ROUNDING * ROUNDING {
                    found.push(Minimum { side, leg, after, gap: least });
                }
            }
            (start, begun) = (flow.advance(start, width), begun + width);
        }
    }
    found
}

/// Where z has a minimum on the cell from 0 to `width`, `at` being (z, z′, z″), `a` and `b` its values at
/// both ends: on it z″ is taken to change sign once at most, so z′ is monotone on either side of that point
/// and every root of z′ is found.
pub(crate) fn minimum_within(
    at: impl Fn(f64) -> [f64; 3],
    a: [f64; 3],
    b: [f64; 3],
    width: f64,
) -> Option<f64> {
    // The stretch on which z′ rises through zero, if there is one.
    let (lo, hi) = if a[1] < 0.0 && b[1] >= 0.0 {
        (0.0, width)
    } else if a[2] * b[2] < 0.0 && (a[1] < 0.0) == (b[1] < 0.0) && (a[1] < 0.0) == (a[2] > 0.0) {
        let turn = rising(|t| at(t)[2] * b[2].signum(), 0.0, width);
        match (a[1] < 0.0, at(turn)[1]) {
            (true, middle) if middle >= 0.0 => (0.0, turn),
            (false, middle) if middle < 0.0 => (turn, width),
            _ => return None,
        }
    } else {
        return None;
    };
    Some(rising(|t| at(t)[1], lo, hi))
}

/// Where an f with f(lo) < 0 ≤ f(hi) passes through 0: bisection, to the last digit.
fn rising(f: impl Fn(f64) -> f64, mut lo: f64, mut hi: f64) -> f64 {
    for _ in 0..60 {
        let middle = lo + (hi - lo) / 2.0;
        if f(middle) < 0.0 {
            lo = middle;
        } else {
            hi = middle;
        }
    }
    hi
}
