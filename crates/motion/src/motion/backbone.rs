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
//! rule of eight points on eight panels.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::flow::GAUSS;

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
}

/// Panels of a piece.
const PANELS: u32 = 8;
/// Amplitudes at which a frequency is looked at, and how many times the least the largest is.
const LOOKS: u32 = 200;
const SPAN: f64 = 1e4;

impl Conservative {
    /// −V′.
    fn force_at(&self, q: f64) -> f64 {
        let springs = self.springs.iter().map(|&[place, sign, stiffness]| {
            let depth = (sign * (q - place)).max(0.0);
            sign * stiffness * depth
        });
        self.force - self.stiffness * q - self.cubic * q * q * q - springs.sum::<f64>()
    }

    /// G: (V(b) − V(q))/(b − q).
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
        let softens = self.stiffness < 0.0 || self.stiffness == 0.0 && self.cubic < 0.0;
        softens && self.force_at(0.0) == 0.0 && low < 0.0 && high > 0.0 && !held
    }

    /// Where it rests, if there is a place to which all forces lead in its neighbourhood: by halving from 0,
    /// outwards as far as `reach`.
    fn rest(&self, reach: f64) -> Option<f64> {
        let [low, high] = self.stops;
        let start = 0f64.clamp(low, high);
        let push = self.force_at(start);
        if push == 0.0 {
            return Some(start);
        }
        let (mut near, mut step) = (start, reach * 1e-6 * push.signum());
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
        let mut sum = 0.0;
        for pair in cuts.windows(2).filter(|pair| pair[0] < pair[1]) {
            let width = (pair[1] - pair[0]) / f64::from(PANELS);
            for i in 0..PANELS {
                for (x, weight) in GAUSS {
                    let phi = pair[0] + width * (f64::from(i) + x);
                    let over = reach / self.slope(b, from + reach * phi.cos());
                    if over.is_nan() || over <= 0.0 {
                        return None;
                    }
                    sum += weight * width * (self.mass * over).sqrt() * (phi / 2.0).cos();
                }
            }
        }
        Some(sum)
    }

    /// The frequency, per radian of the drive, and the swing of the vibration that would turn at b, if no
    /// stop were in the way, about where it rests.
    fn at(&self, rest: f64, b: f64) -> Option<[f64; 2]> {
        let [low, high] = self.stops;
        let up = b > rest;
        let mut ends = [b, b];
        let mut time = self.quarter(rest, b)?;
        // The other side, unless it rests on a stop there.
        let other = if up { low } else { high };
        if other == rest {
            ends[usize::from(!up)] = rest;
        } else {
            let energy = |a: f64| (b - a) * self.slope(b, a);
            let mut reach = rest - b;
            let mut tries = 0;
            while energy(rest + reach) > 0.0 {
                reach *= 2.0;
                tries += 1;
                if tries > 60 {
                    return None;
                }
            }
            let (mut inside, mut outside) = (rest, rest + reach);
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

    /// The swings, up to `size`, of vibrations at k times the drive's frequency, ascending: each where the
    /// frequency passes k between neighbours of two hundred amplitudes, evenly spaced in their logarithms.
    pub fn swings(&self, k: u32, size: f64) -> Vec<f64> {
        let Some(rest) = self.rest(100.0 * size).filter(|_| size > 0.0) else { return Vec::new() };
        let k = f64::from(k);
        let sign = if self.stops[1] > rest { 1.0 } else { -1.0 };
        // An amplitude without stops may be larger than a swing between them.
        let amplitude = |i: u32| 10.0 * size * SPAN.powf(f64::from(i) / f64::from(LOOKS) - 1.0);
        let off =
            |amplitude: f64| self.at(rest, rest + sign * amplitude).map(|[rate, swing]| [rate - k, swing]);
        let mut found = Vec::new();
        let mut before: Option<(f64, f64)> = None;
        for i in 0..=LOOKS {
            let here = amplitude(i);
            // Where nothing leads back from, the last amplitude from which it does.
            let over = off(here).is_none();
            let here = match before.filter(|_| over) {
                Some((last, _)) => between(last, here, |amplitude| off(amplitude).is_some()).0,
                None => here,
            };
            let Some([now, _]) = off(here) else { break };
            if let Some((last, then)) = before.filter(|(_, then)| (*then > 0.0) != (now > 0.0)) {
                let same = |amplitude| off(amplitude).is_some_and(|[rate, _]| (rate > 0.0) == (then > 0.0));
                let (_, high) = between(last, here, same);
                found.extend(off(high).map(|[_, swing]| swing).filter(|swing| *swing <= size));
            }
            before = Some((here, now));
            if over {
                break;
            }
        }
        found
    }
}

/// The neighbouring floats between which what holds at the first of two values ceases to.
fn between(mut low: f64, mut high: f64, holds: impl Fn(f64) -> bool) -> (f64, f64) {
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

    const FREE: Conservative = Conservative {
        mass: 1.0,
        stiffness: 1.0,
        cubic: 0.0,
        force: 0.0,
        stops: [f64::NEG_INFINITY, f64::INFINITY],
        springs: Vec::new(),
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
        assert_eq!(ball.rest(1.0), Some(0.0));
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
        let spring = Conservative { cubic: 0.2, ..FREE };
        for amplitude in [0.3, 1.0, 4.0] {
            let [rate, swing] = spring.at(0.0, amplitude).unwrap();
            let slower = Conservative { mass: rate * rate, ..spring.clone() };
            let [found] = slower.swings(1, 5.0)[..] else { panic!("{:?}", slower.swings(1, 5.0)) };
            assert!((found - swing).abs() < 1e-12, "{found} {swing}");
        }
        assert!(FREE.swings(2, 1.0).is_empty() && spring.swings(1, 0.1).is_empty());
        assert!(!spring.leads_away() && Conservative { stiffness: -1.0, ..spring.clone() }.leads_away());
        assert!(!Conservative { stiffness: -1.0, force: 0.1, ..spring }.leads_away());
    }
}
