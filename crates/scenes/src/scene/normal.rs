//! What the task `chaos` is about: its scene's oscillator in the normal form of docs/chaos.md, for all its
//! parameters.

use num_rational::BigRational;
use num_traits::Zero;

use super::{
    chaos::{Alphabet, ChaosTask, LONGEST, Periods},
    scene::Scene,
};
use crate::{
    error::{Error, Result},
    motion::Side,
    number::{FloatInterval, Real},
    search::chaos::{Normal, RationalFunction},
};

impl ChaosTask {
    pub(super) fn check(&self, scene: &Scene, path: &str) -> Result<()> {
        let fail = |key: &str, message: &str| Err(scene.fail(&format!("{path}.{key}"), message));
        if let Alphabet::Periods(periods) = &self.alphabet {
            let increase = periods.windows(2).all(|pair| pair[0] < pair[1]);
            let longest = periods.last().map_or(0, |last| last.halves);
            if !increase || periods.is_empty() || periods[0].halves == 0 || longest > 2 * LONGEST {
                return fail("alphabet", &format!("must be periods from 1 to {LONGEST}, increasing"));
            }
            let known = |list: &Vec<Periods>| {
                !list.is_empty()
                    && list.windows(2).all(|pair| pair[0] < pair[1])
                    && list.iter().all(|n| periods.contains(n))
            };
            let given = self.follow.len() == periods.len() && self.follow.iter().all(known);
            if !(given || self.follow.is_empty()) {
                return fail(
                    "follow",
                    "must have one list per period of the alphabet: at least one of its periods, increasing",
                );
            }
        } else if !self.follow.is_empty() {
            return fail("follow", "goes with an alphabet of periods, not with \"auto\"");
        }
        match &self.history[..] {
            [] => {}
            [of, _] if matches!(&self.alphabet, Alphabet::Periods(periods) if !periods.contains(of)) => {
                return fail("history", &format!("{of} is no period of the alphabet"));
            }
            [_, most] if most.whole().is_some_and(|most| most <= 40) => {}
            _ => return fail("history", "must be a period and a number up to 40"),
        }
        match (&self.parameter, &self.from, &self.to) {
            (None, None, None) => {}
            (Some(name), Some(from), to) => {
                scene.parameter(name)?;
                if to.as_ref().is_some_and(|to| to <= from) {
                    return fail("to", "must be above from");
                }
                if self.cell.0.iter().any(|(other, _)| other == name) {
                    return fail("cell", &format!("must not hold {name}, which varies from {from} on"));
                }
            }
            _ => return fail("parameter", "goes with from, and to where the range ends"),
        }
        let normal = self.normal(scene).map_err(|error| scene.fail(path, &error.to_string()))?;
        if !normal.mirrored {
            let whole = |list: &[Periods]| list.iter().all(|n| n.whole().is_some());
            let message = "has half periods, after which another wall would be met; but one wall is";
            if matches!(&self.alphabet, Alphabet::Periods(periods) if !whole(periods)) {
                return fail("alphabet", message);
            }
            if !whole(&self.history) {
                return fail("history", message);
            }
        }
        Ok(())
    }

    /// A number of periods as letters count them: in halves where both walls are met.
    pub(crate) fn counted(normal: &Normal, periods: Periods) -> u64 {
        if normal.mirrored { periods.halves } else { periods.halves / 2 }
    }
}

impl ChaosTask {
    /// The scene's oscillator in the normal form of chaos.md, for all parameters of the task.
    ///
    /// # Errors
    /// As `Normal::of`; also where a wall or a force depends on a parameter of the cell.
    pub fn normal(&self, scene: &Scene) -> Result<Normal> {
        self.normal_form(scene).map_err(|error| error.context("kind \"chaos\""))
    }

    fn normal_form(&self, scene: &Scene) -> Result<Normal> {
        let cell = &self.cell.0;
        let in_cell = |name: &String| cell.iter().find(|(other, _)| other == name).map(|(_, range)| range);
        let varies = |name: &String| self.parameter.as_ref() == Some(name);
        let functions: Vec<RationalFunction> = scene
            .parameters
            .iter()
            .map(|(name, value)| match (&self.from, in_cell(name)) {
                (Some(from), _) if varies(name) => RationalFunction::range(from, self.to.as_ref()),
                // Where it matters, ranges are used in its place.
                (_, Some([lo, _])) => RationalFunction::ratio(lo, &()),
                _ => RationalFunction::ratio(value, &()),
            })
            .collect();
        let system = scene.system()?;
        let varied = system.in_radians().try_map(|expression| expression.evaluate(&functions, &()))?;
        if let (None, Some(lower), Some(upper)) = (self.side(), &system.lower, &system.upper) {
            let both = [lower, upper].map(|wall| &wall.restitution);
            let [one, other] = both.map(ToString::to_string);
            // What is no number of its own is compared as it is written.
            let are_numbers = cell.is_empty() && both.iter().all(|x| x.is_rational());
            if one != other && !are_numbers {
                return Err(Error::input(format!(
                    "both walls' restitutions must be given by the same expression, not {one} and {other}, or side must say which wall is met"
                )));
            }
        }
        if cell.is_empty() {
            return Normal::of(&varied, None, self.side());
        }
        let ranged = |index: usize| in_cell(&scene.parameters[index].0).is_some();
        let walls = [&system.lower, &system.upper].into_iter().flatten();
        let harmonics = walls.clone().flat_map(|wall| &wall.harmonics).chain(&system.forcing);
        let mut others = harmonics
            .flat_map(|harmonic| [&harmonic.cos, &harmonic.sin])
            .chain(walls.map(|wall| &wall.offset))
            .chain([&system.force, &system.cubic]);
        if let Some(expression) = others.find(|expression| expression.mentions(&ranged)) {
            return Err(Error::input(format!(
                "{expression} depends on a parameter of the cell; only damping, stiffness and restitution may"
            )));
        }
        let wide = |lo: &BigRational, hi: &BigRational| {
            let [lo, hi] = [lo, hi].map(|x| FloatInterval::ratio(x, &()));
            FloatInterval::from_bounds(lo.lo(), hi.hi())
        };
        let intervals: Vec<FloatInterval> = scene
            .parameters
            .iter()
            .map(|(name, value)| match (&self.from, &self.to, in_cell(name)) {
                (Some(from), Some(to), _) if varies(name) => wide(from, to),
                (Some(_), None, _) if varies(name) => FloatInterval::WHOLE,
                (_, _, Some([lo, hi])) => wide(lo, hi),
                _ => FloatInterval::ratio(value, &()),
            })
            .collect();
        let met = self
            .side()
            .map_or_else(|| system.wall(Side::Lower).or(system.wall(Side::Upper)), |side| system.wall(side));
        let restitution = met.map(|wall| &wall.restitution);
        let measured = [Some(&system.damping), Some(&system.stiffness), restitution].map(|expression| {
            let Some(expression) = expression else {
                return Ok([BigRational::zero(), BigRational::zero()]);
            };
            let free = |index: usize| ranged(index) || varies(&scene.parameters[index].0);
            if !expression.mentions(&free) {
                let exact: Vec<BigRational> =
                    scene.parameters.iter().map(|(_, value)| value.clone()).collect();
                if let Ok(value) = expression.evaluate(&exact, &()) {
                    return Ok([value.clone(), value]);
                }
            }
            let value = expression.evaluate(&intervals, &())?;
            let bounds = value.exact_bounds().map(|(lo, hi)| [lo, hi]);
            bounds.ok_or_else(|| Error::input(format!("{expression} is not bounded")))
        });
        let [damping, stiffness, restitution] = measured;
        Normal::of(&varied, Some([damping?, stiffness?, restitution?]), self.side())
    }
}
