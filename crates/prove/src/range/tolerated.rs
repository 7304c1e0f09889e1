//! Machines that are known up to tolerances, about their touches: the values of the parameter that have
//! depths up to one for all of them.
//!
//! R of `parameter` is a function of the parameter p and of the machine, a point b of a box; with one
//! harmonic the depth is σν = 1 − √R. Where the signs of its derivatives are the same on the box, R is least
//! and greatest at two corners of it, exactly. Let R run one way in p, too, from p₁ to p₂ and for every b.
//! Then for all b what R is at most or at least at both ends it is between them: a range from where every
//! machine has passed its touch to where none is deeper than ν has depths up to ν only.
//!
//! Derivatives are enclosed on cells of p and b, which are halved where a sign is not certain. Of a
//! coordinate of b whose side is too narrow for that, as that of π, the sign is not asked: R changes along it
//! by no more than its width times the greatest slope.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::parameter::{edge, farthest, outwards, shorter, simplest};
use crate::{
    error::{Error, Result},
    motion::{Harmonic, System},
    number::{FloatInterval, Real, Sign},
    tolerance::Sloped,
};

type Q = BigRational;

/// The system where the parameter and then each coordinate of the box have these values.
pub type SystemOf<'a, R> = &'a dyn Fn(&[R]) -> Result<System<R>>;

/// All machines of a box.
#[derive(Clone)]
pub struct MachineBox<'a> {
    /// The least and the greatest value of each coordinate.
    pub bounds: Vec<[BigRational; 2]>,
    /// The system with its slopes.
    pub sloped: SystemOf<'a, Sloped>,
    /// The system exactly.
    pub exact: SystemOf<'a, BigRational>,
}

/// A side of the touches of all machines of a box.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ToleratedRange {
    /// Every machine touches once between these, both included; one number, if that is where all do.
    pub touches: [BigRational; 2],
    /// From the nearer of these, included unless all touch there, to here every machine has a depth above 0
    /// and at most as given; none if no value of the parameter has.
    pub end: Option<BigRational>,
}

/// A machine near its touch.
struct Seen<R> {
    /// c, k and τ.
    parameters: [R; 3],
    /// C.
    mean: R,
    /// R.
    ratio: R,
}

/// Into how many cells the parameter and the box are cut to see that something runs one way.
const CELLS: usize = 512;
/// How many times a step is doubled, and a range made shorter.
const STEPS: u32 = 60;

fn fail<T>(message: &str) -> Result<T> {
    Err(Error::input(message))
}

/// The coefficients of each order; orders without any left out.
fn waves<R: Real<Context = ()>>(harmonics: &[Harmonic<R>]) -> BTreeMap<u32, [R; 2]> {
    let mut all: BTreeMap<u32, [R; 2]> = BTreeMap::new();
    for Harmonic { k, cos, sin } in harmonics {
        let zero = || [R::integer(0, &()), R::integer(0, &())];
        let [a, b] = all.remove(k).unwrap_or_else(zero);
        all.insert(*k, [a + cos, b + sin]);
    }
    all.retain(|_, both| both.iter().any(|part| part.sign() != Some(Sign::Zero)));
    all
}

impl<R: Real<Context = ()>> Seen<R> {
    /// Of a linear oscillator beside one stop, one harmonic of order 1 between them.
    fn of(system: &System<R>) -> Result<Seen<R>> {
        let (wall, upper) = match (&system.lower, &system.upper) {
            (Some(wall), None) => (wall, false),
            (None, Some(wall)) => (wall, true),
            _ => return fail("ranges over tolerances are beside one stop"),
        };
        if system.cubic.sign() != Some(Sign::Zero) || system.smooth.is_some() {
            return fail("ranges over tolerances are of linear machines");
        }
        let (drive, motion) = (waves(&system.forcing), waves(&wall.harmonics));
        if drive.keys().chain(motion.keys()).any(|order| *order != 1) {
            return fail(
                "ranges over tolerances are proved where the drive and the stop's motion have one harmonic, k = 1",
            );
        }
        let (c, k) = (&system.damping, &system.stiffness);
        let offset = wall.offset.clone() - &(system.force.clone() / k);
        let mean = if upper { -offset } else { offset };
        let square = |[a, b]: &[R; 2]| a.clone() * a + &(b.clone() * b);
        let detuning = k.clone() - &R::integer(1, &());
        let determinant = detuning.clone() * &detuning + &(c.clone() * c);
        // 1/A², from as few terms as can be.
        let inverse = match (drive.get(&1), motion.get(&1)) {
            (None, None) => return fail("the stop must move, seen from the motion without it"),
            (None, Some(motion)) => R::integer(1, &()) / &square(motion),
            (Some(drive), None) => determinant / &square(drive),
            (Some([f, g]), Some([a, b])) => {
                let first = (detuning.clone() * f - &(c.clone() * g)) / &determinant;
                let second = (detuning * g + &(c.clone() * f)) / &determinant;
                R::integer(1, &()) / &square(&[a.clone() - &first, b.clone() - &second])
            }
        };
        let ratio = mean.clone() * &mean * &inverse;
        Ok(Seen { parameters: [c.clone(), k.clone(), wall.restitution.clone()], mean, ratio })
    }
}

/// How a function runs in one of its variables.
#[derive(Debug, Clone, Copy)]
struct Way {
    /// Whether it certainly does not fall, or does not rise, where its sign is asked.
    way: [bool; 2],
    /// The greatest slope where it is not.
    slope: f64,
}

/// Sides that are narrower than this part of their place are not halved.
fn is_narrow([lo, hi]: &[Q; 2]) -> bool {
    (hi - lo) * Q::from_integer((1u64 << 63).into()) < hi.abs()
}

fn float(side: &[Q; 2]) -> FloatInterval {
    let [lo, hi] = side.each_ref().map(|x| FloatInterval::ratio(x, &()));
    FloatInterval::from_bounds(lo.lo(), hi.hi())
}

impl MachineBox<'_> {
    /// Which way a function of a machine runs in each variable, the parameter first; none if that is not the
    /// same, or not certain, or the wall's mean is not behind the motion's.
    fn ways(&self, over: [&Q; 2], of: &dyn Fn(&Seen<Sloped>) -> Sloped) -> Result<Option<Vec<Way>>> {
        let mut whole = vec![over.map(Clone::clone)];
        whole.extend(self.bounds.iter().cloned());
        let mut ways = vec![Way { way: [true, true], slope: 0.0 }; whole.len()];
        let wide = |cell: &[[Q; 2]], i: usize| &cell[i][1] - &cell[i][0];
        let mut open = vec![whole.clone()];
        let mut cells = 0;
        while let Some(cell) = open.pop() {
            cells += 1;
            let sides: Vec<FloatInterval> = cell.iter().map(float).collect();
            let mut certain = true;
            let mut here = Vec::with_capacity(sides.len());
            for (axis, side) in whole.iter().enumerate() {
                let variable = |i: usize| match i == axis {
                    true => Sloped::parameter(0, sides[i]),
                    false => Sloped::constant(sides[i]),
                };
                let seen = Seen::of(&(self.sloped)(&(0..sides.len()).map(variable).collect::<Vec<_>>())?)?;
                let slope = of(&seen).slope()[0];
                let way = [slope.lo() >= 0.0, slope.hi() <= 0.0];
                let is_asked = way == [false, false] && !(axis > 0 && is_narrow(side));
                certain &= !is_asked && seen.mean.value().hi() < 0.0;
                here.push((way, slope.hi().max(-slope.lo())));
            }
            if certain {
                for (all, (way, slope)) in ways.iter_mut().zip(here) {
                    if way == [false, false] {
                        all.slope = all.slope.max(slope);
                        continue;
                    }
                    all.way = [all.way[0] && way[0], all.way[1] && way[1]];
                    if all.way == [false, false] {
                        return Ok(None);
                    }
                }
                continue;
            }
            // Across the side that is the largest part of the whole one.
            let widest = (0..cell.len())
                .filter(|&i| wide(&cell, i).is_positive())
                .max_by(|&i, &j| (wide(&cell, i) * wide(&whole, j)).cmp(&(wide(&cell, j) * wide(&whole, i))));
            let Some(axis) = widest.filter(|_| cells + open.len() < CELLS) else { return Ok(None) };
            let middle = shorter(&cell[axis][0], &cell[axis][1]);
            for end in [0, 1] {
                let mut half = cell.clone();
                half[axis][end].clone_from(&middle);
                open.push(half);
            }
        }
        Ok(Some(ways))
    }

    /// The least and the greatest value for a parameter, over the box, exactly but for what narrow sides
    /// leave open; none if these are not known to be at corners.
    fn extremes(
        &self,
        p: &Q,
        sloped: &dyn Fn(&Seen<Sloped>) -> Sloped,
        exact: &dyn Fn(&Seen<Q>) -> Q,
    ) -> Result<Option<[Q; 2]>> {
        let Some(ways) = self.ways([p, p], sloped)? else { return Ok(None) };
        let mut open = Q::zero();
        for ([lo, hi], way) in self.bounds.iter().zip(&ways[1..]) {
            let Some(slope) = Q::from_float(way.slope) else { return Ok(None) };
            open += slope * (hi - lo);
        }
        let corner = |most: usize| -> Result<Q> {
            let end = |(side, way): (&[Q; 2], &Way)| side[if way.way[0] { most } else { 1 - most }].clone();
            let mut point = vec![p.clone()];
            point.extend(self.bounds.iter().zip(&ways[1..]).map(end));
            Ok(exact(&Seen::of(&(self.exact)(&point)?)?))
        };
        Ok(Some([corner(0)? - &open, corner(1)? + &open]))
    }

    /// The least and the greatest R for a parameter; none where that is not known.
    fn ratios(&self, p: &Q) -> Option<[Q; 2]> {
        self.extremes(p, &|seen| seen.ratio, &|seen| seen.ratio.clone()).ok().flatten()
    }

    /// The ranges of c, k and τ, rounded outwards, where the parameter does not move them.
    ///
    /// # Errors
    /// An input error for what is not covered: more than one harmonic, two stops, damping, stiffness or
    /// restitution that do not run one way.
    pub fn parameters(&self, p: &BigRational) -> Result<[[BigRational; 2]; 3]> {
        let mut all = Vec::new();
        for (i, name) in ["damping", "stiffness", "restitution"].into_iter().enumerate() {
            let found = self.extremes(p, &|seen| seen.parameters[i], &|seen| seen.parameters[i].clone())?;
            let Some(ends) = found else {
                return fail(&format!(
                    "it is not shown that the {name} runs one way with each tolerance, and that the stop's mean is \
                     beyond the motion's"
                ));
            };
            all.push(outwards(ends));
        }
        let [damping, stiffness, restitution] = all.try_into().unwrap_or_default();
        Ok([damping, stiffness, restitution])
    }

    /// The parameters from the touches near `start` to a depth, on the side where the wall is passed
    /// (`behind`) or not; `unit` is a small step of the parameter. None if no touches of all machines are
    /// found there.
    ///
    /// Cost: some 300 evaluations of R on up to 512 cells.
    pub fn range(
        &self,
        [start, unit]: [&BigRational; 2],
        depth: &BigRational,
        behind: bool,
    ) -> Result<Option<ToleratedRange>> {
        let one = Q::one();
        let on_side = |[lo, hi]: &[Q; 2]| if behind { *hi < one } else { *lo > one };
        let on_other = |[lo, hi]: &[Q; 2]| if behind { *lo >= one } else { *hi <= one };
        let limit = square(depth, behind);
        let inside =
            |ends: &[Q; 2]| on_side(ends) && if behind { ends[0] >= limit } else { ends[1] <= limit };
        let is = |p: &Q, test: &dyn Fn(&[Q; 2]) -> bool| self.ratios(p).is_some_and(|ends| test(&ends));
        // Which way, and a point on either side of all touches.
        let mut step = unit.clone();
        let mut sides = None;
        for _ in 0..STEPS {
            let (left, right) = (start - &step, start + &step);
            if is(&left, &on_other) && is(&right, &on_side) {
                sides = Some((unit.clone(), left, right));
            } else if is(&left, &on_side) && is(&right, &on_other) {
                sides = Some((-unit.clone(), right, left));
            }
            if sides.is_some() || step > start.abs() + unit * Q::from_integer((1u64 << 40).into()) {
                break;
            }
            step = &step + &step;
        }
        let Some((way, outer, first)) = sides else { return Ok(None) };
        let near = edge(&|p| Ok(is(p, &on_side)), &first, &outer)?;
        let far = edge(&|p| Ok(is(p, &on_other)), &outer, &first)?;
        let sorted = |a: &Q, b: &Q| if a < b { [a.clone(), b.clone()] } else { [b.clone(), a.clone()] };
        let mut touches = sorted(&near, &far);
        // Each machine touches between them, and once.
        if self.ways([&touches[0], &touches[1]], &|seen| seen.ratio)?.is_none() {
            return Ok(None);
        }
        let short = simplest(&touches[0], &touches[1]);
        if is(&short, &|ends| ends.iter().all(|end| *end == one)) {
            touches = [short.clone(), short];
        }
        if !is(&near, &inside) {
            return Ok(Some(ToleratedRange { touches, end: None }));
        }
        let mut end = farthest(&|p| Ok(is(p, &inside)), &near, &way)?;
        for _ in 0..STEPS {
            let [from, to] = sorted(&far, &end);
            if self.ways([&from, &to], &|seen| seen.ratio)?.is_some() {
                return Ok(Some(ToleratedRange { touches, end: Some(end) }));
            }
            end = shorter(&near, &end);
        }
        Ok(None)
    }

    /// About the nearest parameter to the touches from which all machines are at least as deep, up to `end`,
    /// itself so; none if they are not at `end`. `start` is near the touches, and from there on R runs one
    /// way.
    pub fn deep_from(
        &self,
        end: &BigRational,
        start: &BigRational,
        depth: &BigRational,
        behind: bool,
    ) -> Option<BigRational> {
        let deep = |p: &Q| Ok(self.are_as_deep(p, depth, behind));
        self.are_as_deep(end, depth, behind).then(|| edge(&deep, end, start).ok()).flatten()
    }

    /// Whether the depth at a parameter is certainly at least this for all machines.
    pub fn are_as_deep(&self, p: &BigRational, depth: &BigRational, behind: bool) -> bool {
        let limit = square(depth, behind);
        self.ratios(p)
            .is_some_and(|[lo, hi]| if behind { hi <= limit && depth <= &Q::one() } else { lo >= limit })
    }
}

/// R at a depth.
fn square(depth: &Q, behind: bool) -> Q {
    let root = if behind { Q::one() - depth } else { Q::one() + depth };
    if root.is_positive() { &root * &root } else { Q::zero() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::Wall;

    fn q(p: i64, d: i64) -> Q {
        Q::new(p.into(), d.into())
    }

    /// q″ + d q′ + s q = F cos t below a stop at 1, of F, d and s.
    fn system<R: Real<Context = ()>>(at: &[R]) -> Result<System<R>> {
        let number = |x: i32| R::integer(x, &());
        let wall = Wall { offset: number(1), harmonics: Vec::new(), restitution: number(1) };
        let forcing = vec![Harmonic { k: 1, cos: at[0].clone(), sin: number(0) }];
        let (damping, stiffness) = (at[1].clone(), at[2].clone());
        let [cubic, force] = [number(0), number(0)];
        Ok(System {
            rate: None,
            damping,
            stiffness,
            cubic,
            force,
            forcing,
            smooth: None,
            lower: None,
            upper: Some(wall),
        })
    }

    /// R = ((s − 1)² + d²)/F² at the corners of the box.
    fn corners(force: &Q, bounds: &[[Q; 2]]) -> Vec<Q> {
        let at = |i: usize, j: usize| {
            let (d, detuning) = (&bounds[0][i], &bounds[1][j] - q(1, 1));
            (&detuning * &detuning + d * d) / (force * force)
        };
        [[0, 0], [0, 1], [1, 0], [1, 1]].map(|[i, j]| at(i, j)).to_vec()
    }

    #[test]
    fn values_of_the_parameter_are_those_of_every_corner() {
        let bounds = vec![[q(9, 100), q(11, 100)], [q(29, 100), q(31, 100)]];
        let machines = MachineBox { bounds: bounds.clone(), sloped: &system, exact: &system };
        let (start, unit) = (q(707, 1000), q(1, 1_000_000));
        for (behind, depth) in [(false, q(1, 5)), (true, q(1, 5))] {
            let limit = square(&depth, behind);
            let deep = |r: &Q| if behind { *r <= limit } else { *r >= limit };
            let passed = |r: &Q| if behind { *r < q(1, 1) } else { *r > q(1, 1) };
            let all = |p: &Q, is: &dyn Fn(&Q) -> bool| corners(p, &bounds).iter().all(is);
            let towards = |p: &Q| p + (&start - p) * q(1, 1000);
            let ToleratedRange { touches, end } =
                machines.range([&start, &unit], &depth, behind).unwrap().unwrap();
            let end = end.unwrap();
            let [near, far] = if behind { [&touches[1], &touches[0]] } else { [&touches[0], &touches[1]] };
            assert!(all(near, &passed) && !all(&towards(near), &passed));
            assert!(all(far, &|r| !passed(r)) && !all(&towards(far), &|r| !passed(r)));
            assert!(all(&end, &|r| !deep(r) || *r == limit), "{end}");
            let beyond = &end + (&end - &start) * q(1, 1000);
            assert!(!all(&beyond, &|r| !deep(r)));
            // From where on all of them are so deep.
            let last = &end + (&end - &start);
            let from = machines.deep_from(&last, &start, &depth, behind).unwrap();
            assert!(all(&from, &deep) && !all(&towards(&from), &deep), "{from}");
            assert_eq!(machines.deep_from(&end, &start, &depth, behind), None);
        }
        let [c, k, tau] = machines.parameters(&start).unwrap();
        assert_eq!([c, k, tau], [bounds[0].clone(), bounds[1].clone(), [q(1, 1), q(1, 1)]]);
    }
}
