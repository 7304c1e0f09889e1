//! Is a solution of the pattern equations an orbit? (20), (21), and every other minimum of every gap
//! positive.

use std::f64::consts::PI;

use super::{Itinerary, Oscillator, gap::LinearGap, passage::Unknowns};
use crate::{
    motion::{Flow, Side, State, minimum_within},
    rounding::PHASE,
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
pub(crate) struct Check {
    /// The answer.
    pub admissibility: Admissibility,
    /// The least of the other minima of the gaps; `None` if there is none.
    pub least: Option<Minimum>,
}

/// Checks a solution z of the pattern equations. Cost: about 16 flows for each period of the fastest rate of
/// the system.
pub(crate) fn check(oscillator: &Oscillator, itinerary: &Itinerary, z: &[f64]) -> Check {
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

/// The local minima of the gaps on an open stretch of motion.
///
/// A cell is a sixteenth of the fastest period (but there are no more than 10⁶), searched by
/// [`minimum_within`].
pub(crate) fn minima(oscillator: &Oscillator, leg: usize, from: State, time: f64) -> Vec<Minimum> {
    let flow = oscillator.flow();
    let mut found = Vec::new();
    for wall in oscillator.walls() {
        let side = wall.side;
        let (mut pieces, mut searches) = (0, 0);
        let mut keep = |after: f64, [gap, _, bend]: [f64; 3]| {
            searches += 1;
            // A leg that begins or ends without speed has a minimum there, which rounding may bring inside.
            if after.min(time - after) > PHASE || gap.abs() > PHASE * PHASE * bend.abs() {
                found.push(Minimum { side, leg, after, gap });
            }
        };
        let width = |at: &State| (PI / 8.0 / oscillator.rate(at)).max(1e-6 * time);
        if let Some(gap) = LinearGap::new(flow, wall) {
            let width = width(&from);
            let mut cells = gap.cells(gap.homogeneous(from), from.t, width);
            let mut a = wall.motion(flow, from);
            while cells.begun < time {
                pieces += 1;
                let (x, t, begun) = (cells.x, cells.time(), cells.begun);
                let at = |after: f64| gap.after(x, t, after);
                cells.step();
                // The last cell ends with the leg.
                let left = time - begun;
                let (width, b) = if width < left { (width, cells.gap()) } else { (left, at(left)) };
                if let Some(root) = minimum_within(at, a, b, width) {
                    keep(begun + root, at(root));
                }
                a = b;
            }
            oscillator.count(wall, pieces, searches);
            continue;
        }
        let gap = |state: State| wall.motion(flow, state);
        let (mut start, mut a, mut begun, mut kept) = (from, gap(from), 0.0, None);
        while begun < time {
            pieces += 1;
            let width = width(&start).min(time - begun);
            let end = flow.step(start, width, &mut kept);
            let b = gap(end);
            let at = |after: f64| gap(flow.advance(start, after));
            if let Some(root) = minimum_within(at, a, b, width) {
                keep(begun + root, at(root));
            }
            (start, a, begun) = (end, b, begun + width);
        }
        oscillator.count(wall, pieces, searches);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::{Harmonic, System, Wall};

    /// The cells of the closed form and those of the integrator show the same minima, with and without
    /// forcing, at both walls, on legs of many periods.
    #[test]
    fn minima_are_those_of_the_integrator() {
        let h = |k, cos, sin| Harmonic { k, cos, sin };
        let wall =
            |offset| Some(Wall { offset, harmonics: vec![h(1, 0.9, 0.1), h(3, 0.0, 0.2)], restitution: 0.8 });
        let mut count = 0;
        for (damping, stiffness) in [(0.245, 0.042), (0.05, 7.3), (0.0, 0.5), (2.5, 0.3)] {
            for forcing in [vec![], vec![h(1, 0.5, 0.25), h(2, -0.7, 0.4)]] {
                let system = System {
                    rate: None,
                    damping,
                    stiffness,
                    force: 0.1,
                    forcing,
                    lower: wall(-1.0),
                    upper: wall(2.0),
                    ..System::default()
                };
                // Too weak to move anything: it only leads to the integrator.
                let bent = System { cubic: 1e-300, ..system.clone() };
                let [closed, stepped] = [system, bent].map(|system| {
                    let oscillator = Oscillator::new(system, 1e-15).unwrap();
                    minima(&oscillator, 0, State { t: 0.7, q: 0.4, u: -0.3 }, 31.0)
                });
                assert_eq!(closed.len(), stepped.len(), "{damping} {stiffness}: {closed:?} {stepped:?}");
                for (one, other) in closed.iter().zip(&stepped) {
                    assert_eq!((one.side, one.leg), (other.side, other.leg));
                    assert!((one.gap - other.gap).abs() < 1e-11, "{one:?} {other:?}");
                    assert!((one.after - other.after).abs() < 1e-9, "{one:?} {other:?}");
                }
                count += closed.len();
            }
        }
        assert!(count > 80, "{count}");
    }
}
