//! The free vibration of one coordinate without damping: how far it swings at a given frequency, its
//! *backbone*.
//!
//! m q″ + V′(q) = 0 between rigid stops, at which it turns back without loss. From a place q₀ to a turning
//! point b, q = q₀ + (b − q₀) cos φ, and with V(b) − V(q) = (b − q) G(q)
//!
//! ∫ dq/√(2 (V(b) − V(q))/m) = ∫ √(m (b − q₀)/G) cos(φ/2) dφ, φ from 0 to π/2,
//!
//! which is smooth up to the turning point where G is positive. A rigid stop before b cuts the integral off,
//! a spring that begins on the way is a kink of G, at which it is cut in two. Each piece is summed by Gauss's
//! rule of eight points on eight panels, more beside a hill. What a force that is a formula adds to V(b) −
//! V(q) is summed from point to point, from b on.

use std::{
    cell::Cell,
    f64::consts::{FRAC_PI_2, TAU},
};

use super::{Q, flow::GAUSS};
use crate::formula::Formula;

/// One coordinate without damping, drive and friction; time is in radians of the drive.
#[derive(Debug, Clone, PartialEq)]
pub struct Conservative {
    pub mass: f64,
    /// V′ = `stiffness` q + `cubic` q³ − `force`, and what the springs add.
    pub stiffness: f64,
    pub cubic: f64,
    pub force: f64,
    /// The rigid stops below and above, infinite where there is none.
    pub stops: [f64; 2],
    /// Springs that push towards smaller q above a place (sign 1), or towards larger below it (−1): place,
    /// sign and stiffness.
    pub springs: Vec<[f64; 3]>,
    /// A force that is a formula of the displacement.
    pub own: Option<OwnForce>,
}

/// A force that is a formula of the displacement alone.
#[derive(Debug, Clone, PartialEq)]
pub struct OwnForce {
    /// In the displacement and coefficients, each at its place among the variables.
    pub formula: Formula,
    /// The variables' values; that of the displacement does not matter.
    pub variables: Vec<f64>,
    /// The displacement for each unit of the coordinate, and so the force on that for each unit of force.
    pub factor: f64,
}

impl OwnForce {
    fn at(&self, q: f64) -> f64 {
        let mut variables = self.variables.clone();
        variables[Q] = self.factor * q;
        self.factor * self.formula.at(&variables)[0]
    }

    /// −∫ from q to b: what it adds to V(b) − V(q).
    fn work(&self, b: f64, q: f64, panels: u32) -> f64 {
        let width = (b - q) / f64::from(panels);
        let panel =
            |i: u32| GAUSS.iter().map(move |(x, weight)| weight * self.at(q + width * (f64::from(i) + x)));
        -width * (0..panels).flat_map(panel).sum::<f64>()
    }
}

/// Panels of a piece.
const PANELS: u32 = 8;
/// So close to what is asked for a frequency is the same.
pub(super) const SAME: f64 = 1e-13;

impl Conservative {
    /// −V′.
    fn force_at(&self, q: f64) -> f64 {
        let springs = self.springs.iter().map(|&[place, sign, stiffness]| {
            let depth = (sign * (q - place)).max(0.0);
            sign * stiffness * depth
        });
        let own = self.own.as_ref().map_or(0.0, |own| own.at(q));
        self.force - self.stiffness * q - self.cubic * q * q * q - springs.sum::<f64>() + own
    }

    /// G: (V(b) − V(q))/(b − q), without a force that is a formula.
    fn slope(&self, b: f64, q: f64) -> f64 {
        let own = (b + q) * (self.stiffness / 2.0 + self.cubic / 4.0 * (b * b + q * q)) - self.force;
        let springs = self.springs.iter().map(|&[place, sign, stiffness]| {
            let [deep, here] = [b, q].map(|x| (sign * (x - place)).max(0.0));
            match (deep > 0.0, here > 0.0) {
                (false, false) => 0.0,
                // Both within: (deep² − here²)/(b − q) without a difference of squares.
                (true, true) => sign * stiffness * (deep + here) / 2.0,
                _ => stiffness * (deep + here) * (deep - here) / (2.0 * (b - q)),
            }
        });
        own + springs.sum::<f64>()
    }

    /// Whether 0 is a place from which all forces lead away: then it does not swing about that.
    pub fn leads_away(&self) -> bool {
        let [low, high] = self.stops;
        let held = self.springs.iter().any(|spring| spring[0] == 0.0);
        let softens = match &self.own {
            // By what it does to either side.
            Some(_) => [-1.0, 1.0].iter().all(|x| x * self.force_at(x * self.amplitudes(0.0)[0]) > 0.0),
            None => self.stiffness < 0.0 || self.stiffness == 0.0 && self.cubic < 0.0,
        };
        softens && self.force_at(0.0) == 0.0 && low < 0.0 && high > 0.0 && !held
    }

    /// Where it rests, if there is a place to which all forces lead in its neighbourhood: by halving from 0,
    /// outwards as far as amplitudes are looked at.
    pub(super) fn rest(&self) -> Option<f64> {
        let [low, high] = self.stops;
        let start = 0f64.clamp(low, high);
        let push = self.force_at(start);
        if push == 0.0 {
            return Some(start);
        }
        let [least, reach] = self.amplitudes(0.0);
        let (mut near, mut step) = (start, least * push.signum());
        let mut far = loop {
            let far = (near + step).clamp(low, high);
            if self.force_at(far) * push <= 0.0 {
                break far;
            }
            if far == low || far == high {
                return Some(far);
            }
            if (far - start).abs() > reach {
                return None;
            }
            (near, step) = (far, 2.0 * step);
        };
        loop {
            let middle = near + (far - near) / 2.0;
            if middle == near || middle == far {
                return Some(far);
            }
            if self.force_at(middle) * push > 0.0 {
                near = middle;
            } else {
                far = middle;
            }
        }
    }

    /// The time from `from` to the turning point b, or to the rigid stop before it; none where the forces do
    /// not lead back all the way.
    fn quarter(&self, from: f64, b: f64) -> Option<f64> {
        let reach = b - from;
        let stop = self.stops[usize::from(reach > 0.0)];
        let phi = |place: f64| ((place - from) / reach).clamp(0.0, 1.0).acos();
        let begin = if (b - stop) * reach.signum() > 0.0 { phi(stop) } else { 0.0 };
        let mut cuts: Vec<f64> = self.springs.iter().map(|spring| phi(spring[0])).collect();
        cuts.extend([begin, FRAC_PI_2]);
        cuts.retain(|cut| *cut >= begin);
        cuts.sort_by(f64::total_cmp);
        if begin == 0.0 {
            // Beside a hill G is next to nothing at b, within √(G(b)/G(q₀)) of φ = 0: panels are graded.
            let own = self.own.as_ref().map_or(0.0, |own| own.work(b, from, PANELS) / reach);
            let least = (self.force_at(b) / (self.slope(b, from) + own)).abs().sqrt().max(f64::EPSILON);
            let mut width = cuts.iter().copied().find(|cut| *cut > 0.0).unwrap_or(0.0);
            while width > least {
                width /= 2.0;
                cuts.push(width);
            }
            cuts.sort_by(f64::total_cmp);
        }
        let mut sum = 0.0;
        let (mut last, mut work) = (b, 0.0);
        for pair in cuts.windows(2).filter(|pair| pair[0] < pair[1]) {
            let width = (pair[1] - pair[0]) / f64::from(PANELS);
            for i in 0..PANELS {
                for (x, weight) in GAUSS {
                    let phi = pair[0] + width * (f64::from(i) + x);
                    let q = from + reach * phi.cos();
                    let mut slope = self.slope(b, q);
                    if let Some(own) = &self.own {
                        // From a turning point beyond a stop it is far to the first.
                        work += own.work(last, q, if last == b && begin > 0.0 { PANELS } else { 1 });
                        last = q;
                        slope += if q == b { -own.at(b) } else { work / (b - q) };
                    }
                    let over = reach / slope;
                    if over.is_nan() || over <= 0.0 {
                        return None;
                    }
                    sum += weight * width * (self.mass * over).sqrt() * (phi / 2.0).cos();
                }
            }
        }
        Some(sum)
    }

    /// V(b) − V(a).
    fn climb(&self, b: f64, a: f64) -> f64 {
        (b - a) * self.slope(b, a) + self.own.as_ref().map_or(0.0, |own| own.work(b, a, 4 * PANELS))
    }

    /// The hills on the way from a place of rest to another place, of 64 looks at the force.
    fn hills(&self, rest: f64, b: f64) -> impl Iterator<Item = f64> {
        let way = (b - rest).signum();
        let leads_on = move |a: f64| way * self.force_at(a) > 0.0;
        let place = move |i: u32| rest + (b - rest) * f64::from(i) / 64.0;
        (2..=64).filter(move |&i| leads_on(place(i)) && !leads_on(place(i - 1))).map(move |i| {
            let [near, far] = [place(i - 1), place(i)];
            let (low, high) = between(near.min(far), near.max(far), |a| leads_on(a) == (way < 0.0));
            if way > 0.0 { low } else { high }
        })
    }

    /// The frequency, per radian of the drive, and the swing of the vibration that would turn at b, if no
    /// stop were in the way, about where it rests.
    pub(super) fn at(&self, rest: f64, b: f64) -> Option<[f64; 2]> {
        let [low, high] = self.stops;
        let up = b > rest;
        // Hills as high as it comes, to rounding, are turning points.
        let level = SAME * self.climb(b, rest);
        if self.hills(rest, b).any(|top| self.climb(b, top) <= level) {
            return None;
        }
        let mut ends = [b, b];
        let mut time = self.quarter(rest, b)?;
        // The other side, unless it rests on a stop there.
        let other = if up { low } else { high };
        if other == rest {
            ends[usize::from(!up)] = rest;
        } else {
            // V(b) − V(a), what a formula adds summed up from the place before.
            let known = Cell::new((b, 0.0));
            let energy = |a: f64| {
                let mut own = 0.0;
                if let Some(force) = &self.own {
                    let (place, work) = known.get();
                    own = work + force.work(place, a, if place == b { PANELS } else { 1 });
                    known.set((a, own));
                }
                (b - a) * self.slope(b, a) + own
            };
            let way = if up { -1.0 } else { 1.0 };
            let leads_on = |a: f64| way * self.force_at(a) > 0.0;
            let (mut inside, mut step, mut tries) = (rest, (rest - b) / 32.0, 0);
            let mut outside = loop {
                let next = inside + step;
                if energy(next) <= 0.0 {
                    break next;
                }
                // Over a hill that it may not come over.
                if leads_on(next) && !leads_on(inside) {
                    let (near, far) = if up { (next, inside) } else { (inside, next) };
                    let (near, far) = between(near, far, |a| leads_on(a) == up);
                    let top = if up { near } else { far };
                    if energy(top) <= level {
                        break top;
                    }
                }
                (inside, tries) = (next, tries + 1);
                if tries > 64 {
                    step *= 1.25;
                }
                if tries > 200 || !next.is_finite() {
                    return None;
                }
            };
            loop {
                let middle = inside + (outside - inside) / 2.0;
                if middle == inside || middle == outside {
                    break;
                }
                *(if energy(middle) > 0.0 { &mut inside } else { &mut outside }) = middle;
            }
            ends[usize::from(!up)] = outside;
            // The turning points are the same to rounding, whichever of them the energy is told by.
            time += self.quarter(rest, outside)?;
        }
        if !up {
            ends.reverse();
        }
        let [top, bottom] = ends.map(|end| end.clamp(low, high));
        Some([TAU / (2.0 * time), (top - bottom).abs() / 2.0])
    }
}

/// The neighbouring floats between which what holds at the first of two values ceases to.
pub(super) fn between(mut low: f64, mut high: f64, holds: impl Fn(f64) -> bool) -> (f64, f64) {
    loop {
        let middle = low + (high - low) / 2.0;
        if middle <= low || middle >= high {
            return (low, high);
        }
        *(if holds(middle) { &mut low } else { &mut high }) = middle;
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::formula::Function;

    const FREE: Conservative = Conservative {
        mass: 1.0,
        stiffness: 1.0,
        cubic: 0.0,
        force: 0.0,
        stops: [f64::NEG_INFINITY, f64::INFINITY],
        springs: Vec::new(),
        own: None,
    };

    fn agm(mut a: f64, mut b: f64) -> f64 {
        while (a - b).abs() > 1e-15 * a {
            (a, b) = ((a + b) / 2.0, (a * b).sqrt());
        }
        a
    }

    fn near(found: Option<[f64; 2]>, rate: f64, swing: f64) {
        let [a, b] = found.unwrap();
        assert!(
            (a - rate).abs() < 3e-14 * rate && (b - swing).abs() < 1e-14 * swing,
            "{a} {rate}, {b} {swing}"
        );
    }

    /// By Gauss's mean: of hardening, softening and no linear stiffness at all.
    #[test]
    fn a_cubic_spring_has_the_frequency_of_jacobis_cosine() {
        for (stiffness, cubic, amplitude) in
            [(1.0, 0.2, 2.0), (3.0, -0.2, 2.5), (0.0, 2.0, 0.7), (1.0, 0.0, 1.0)]
        {
            let spring = Conservative { mass: 2.0, stiffness, cubic, ..FREE };
            let whole: f64 = stiffness + cubic * amplitude * amplitude;
            let modulus = cubic * amplitude * amplitude / (2.0 * whole);
            let rate = (whole / 2.0).sqrt() * agm(1.0, (1.0 - modulus).sqrt());
            near(spring.at(0.0, amplitude), rate, amplitude);
        }
        // Beyond the hump of a softening spring nothing leads back.
        assert_eq!(Conservative { cubic: -1.0, ..FREE }.at(0.0, 1.001), None);
    }

    /// A stop without loss cuts the cosine, a second spring replaces a half of it by a faster one.
    #[test]
    fn stops_and_springs_have_their_closed_forms() {
        let (place, amplitude): (f64, f64) = (0.3, 0.9);
        let cut = (place / amplitude).acos();
        let above = Conservative { stops: [f64::NEG_INFINITY, place], ..FREE };
        near(above.at(0.0, amplitude), PI / (PI - cut), (place + amplitude) / 2.0);
        let both = Conservative { stops: [-place, place], ..FREE };
        near(both.at(0.0, amplitude), PI / (PI - 2.0 * cut), place);
        // Pressed against a stop below by a force, as a ball on the floor: 2 √(2 h/g) between bounces.
        let ball = Conservative { stiffness: 0.0, force: -1.0, stops: [0.0, f64::INFINITY], ..FREE };
        assert_eq!(ball.rest(), Some(0.0));
        near(ball.at(0.0, 0.5), PI, 0.25);
        // Above the place of a spring of stiffness k about q = k p/(1 + k) with √(1 + k).
        let (second, place) = (4.0, 0.5);
        let two = Conservative { springs: vec![[place, 1.0, second]], ..FREE };
        let top: f64 = 1.2;
        let (rate, middle) = ((1.0 + second).sqrt(), second * place / (1.0 + second));
        let bottom = (top * top + second * (top - place) * (top - place)).sqrt();
        let time = PI / 2.0 + (place / bottom).asin() + ((place - middle) / (top - middle)).acos() / rate;
        near(two.at(0.0, top), PI / time, (top + bottom) / 2.0);
        let mirrored = Conservative { springs: vec![[-place, -1.0, second]], ..FREE };
        near(mirrored.at(0.0, bottom), PI / time, (top + bottom) / 2.0);
    }

    #[test]
    fn a_swing_is_found_by_its_frequency() {
        let swings = |spring: &Conservative, k: u32| spring.vibrations(k, true).unwrap().swings;
        let spring = Conservative { cubic: 0.2, ..FREE };
        for amplitude in [0.3, 1.0, 4.0] {
            let [rate, swing] = spring.at(0.0, amplitude).unwrap();
            let slower = Conservative { mass: rate * rate, ..spring.clone() };
            let [found] = swings(&slower, 1)[..] else { panic!("{:?}", swings(&slower, 1)) };
            assert!((found - swing).abs() < 1e-12, "{found} {swing}");
        }
        assert!(swings(&FREE, 1).is_empty() && swings(&FREE, 2).is_empty());
        assert!(!spring.leads_away() && Conservative { stiffness: -1.0, ..spring.clone() }.leads_away());
        assert!(!Conservative { stiffness: -1.0, force: 0.1, ..spring }.leads_away());
    }

    /// −sin q as a formula: by Gauss's mean, on both sides of a place of rest, up to its hill at π.
    #[test]
    fn a_pendulum_has_its_elliptic_period_and_its_hill() {
        let formula =
            Formula::Negated(Box::new(Formula::Call(Function::Sin, Box::new(Formula::Variable(Q)))));
        let own = OwnForce { formula, variables: vec![0.0; 3], factor: 1.0 };
        let pendulum = Conservative { stiffness: 0.0, own: Some(own.clone()), ..FREE };
        for amplitude in [1e-4, 0.5, 2.0, 3.1] {
            near(pendulum.at(0.0, amplitude), agm(1.0, (amplitude / 2.0).cos()), amplitude);
        }
        let slow = pendulum.at(0.0, PI - 1e-6).unwrap()[0];
        assert!((slow / agm(1.0, 5e-7f64.sin()) - 1.0).abs() < 1e-4, "{slow}");
        // Half as long a coordinate, and stopped: as the same with a cut.
        let scaled =
            Conservative { mass: 4.0, own: Some(OwnForce { factor: 2.0, ..own }), ..pendulum.clone() };
        near(scaled.at(0.0, 1.0), agm(1.0, 1f64.cos()), 1.0);
        let found = pendulum.vibrations(1, true).unwrap();
        assert!(found.swings.is_empty() && (found.rates[1] - 1.0).abs() < 1e-11, "{found:?}");
        let [small, hill] = found.ends[..] else { panic!("{found:?}") };
        assert_eq!((small.why, hill.why, hill.faster), ("natural frequency", "hill", false));
        assert!((hill.swing.unwrap() - PI).abs() < 4e-6);
        assert!(!pendulum.leads_away());
    }

    /// A spring that softens and then hardens, k = 1, c = −1, with q⁵ as a formula: two swings at a frequency
    /// between its least and its natural one, and none below.
    #[test]
    fn two_swings_of_one_frequency_are_found_where_they_meet() {
        let fifth = Formula::Negated(Box::new(Formula::Power(Box::new(Formula::Variable(Q)), 5)));
        let own = Some(OwnForce { formula: fifth, variables: vec![0.0; 3], factor: 1.0 });
        let spring = Conservative { cubic: -1.5, own, ..FREE };
        let rate = |amplitude: f64| spring.at(0.0, amplitude).unwrap()[0];
        let (mut low, mut high) = (0.5, 1.2);
        for _ in 0..100 {
            let [a, b] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
            if rate(a) < rate(b) { high = b } else { low = a }
        }
        let least = rate(low);
        for (over, count) in [(1.0 - 1e-6, 0), (1.0 + 1e-6, 2), (1.01, 2), (1.001 / least, 1)] {
            let faster = Conservative { mass: (least * over).powi(2), ..spring.clone() };
            let found = faster.vibrations(1, true).unwrap();
            assert_eq!(found.swings.len(), count, "{over} {found:?}");
            for swing in found.swings {
                assert!((rate(swing) / (least * over) - 1.0).abs() < 1e-11);
            }
        }
    }
}
