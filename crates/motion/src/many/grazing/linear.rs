//! All touches of the motion without impacts of a linear machine, from any start.
//!
//! The motion at a value of the parameter is one linear solve for each harmonic, and so is its derivative.
//! The least gap g, over all stops and phases, is a function of the parameter alone; a touch is a zero of it.
//!
//! **Where the parameter scales forces or moves stops**, each gap is α(t) + p β(t), so that g, the least of
//! affine functions, is concave: the machine is free between two touches at most, and no start is needed.
//! Newton's method on g comes from either infinity to the nearer touch and never passes it:
//!
//! ```text
//! p ← −α(t*)/β(t*),  t* the phase of the least of x α + y β,  (x, y) = (0, ±1) first, then (1, p) scaled.
//! ```
//!
//! **Elsewhere** g is looked at on a ladder of values, to all orders of magnitude both ways, and beside each
//! resonance of a mode with a harmonic. An interval is halved until the cubic through the values and slopes
//! at its ends predicts the middle and shows no zero, or one. A dip of g that is no mode's and narrower than
//! the interval it stands in may be missed.
//!
//! Not here: which of several touches is meant; formulas among the forces (`locate`).

use super::free::{FreeMotion, LeastGap};
use crate::{
    error::{Error, Result},
    many::{
        Machine, State,
        resonance::{AtValue, near_resonances},
    },
    motion::Series,
};

/// A touch.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearTouch {
    /// The parameter there.
    pub parameter: f64,
    /// Where it touches, and what rounding leaves of the gap.
    pub at: LeastGap,
    /// How fast the gap opens with the parameter.
    pub rate: f64,
    /// The stop's name.
    pub stop: String,
    /// The motion at phase 0.
    pub state: State,
}

/// What a search for touches came to.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LinearTouches {
    /// They, the nearest to the start first.
    pub found: Vec<LinearTouch>,
    /// Why there are no others, or none.
    pub why: String,
    /// Where it was not looked, for there is no motion without impacts at a value there.
    pub unseen: Vec<Unseen>,
}

/// Values of the parameter among which there is no motion without impacts.
#[derive(Debug, Clone, PartialEq)]
pub struct Unseen {
    /// The values next to them that were looked at, or the last ones.
    pub ends: [f64; 2],
    /// Why there is none at a value between.
    pub why: String,
}

impl LinearTouches {
    /// Where it was not looked, in words.
    pub fn open(&self) -> Option<String> {
        let one = |Unseen { ends: [from, to], why }: &Unseen| match from == to {
            true => format!("at {from:?}: {why}"),
            false => format!("from {:?} to {:?}: {why}", from.min(*to), from.max(*to)),
        };
        let all: Vec<String> = self.unseen.iter().map(one).collect();
        let begin = "not looked for where there is no motion without impacts";
        (!all.is_empty()).then(|| format!("{begin}, {}", all.join("; ")))
    }
}

/// Checks whether to go on.
type Check<'c> = &'c mut dyn FnMut() -> Result<()>;

/// The touches of the machines of a family: all within two values if they are given, else the nearest either
/// way from `start`. Cost: a motion for each of some 10 values where the parameter scales or moves; elsewhere
/// of some hundreds, and of a thousand where nothing is found.
///
/// # Errors
/// Where the family is not defined at `start`; those of `check`.
pub fn touches(family: AtValue, start: f64, within: Option<[f64; 2]>, check: Check) -> Result<LinearTouches> {
    let mut search = Search { family, check, found: Vec::new(), least: None, unseen: Vec::new() };
    let [_, slope] = family(start)?;
    let why = match search.affine(start, &slope) {
        Some(gaps) => search.scaled(&gaps, within)?,
        None => search.walked(start, within)?,
    };
    let Search { mut found, unseen, .. } = search;
    let inside = |touch: &LinearTouch| within.is_none_or(|[lo, hi]| (lo..=hi).contains(&touch.parameter));
    found.retain(inside);
    let own = |touch: &LinearTouch| (touch.parameter < 0.0) == (start < 0.0);
    let away = |touch: &LinearTouch| (touch.parameter - start).abs();
    found.sort_by(|a, b| away(a).total_cmp(&away(b)).then(own(b).cmp(&own(a))));
    found.dedup_by(|a, b| a.parameter == b.parameter);
    Ok(LinearTouches { found, why, unseen })
}

/// A value of the parameter, the least gap there, and how fast it opens.
#[derive(Debug, Clone, Copy)]
struct Sight {
    value: f64,
    gap: f64,
    rate: f64,
}

struct Search<'f, 'c> {
    family: AtValue<'f>,
    check: Check<'c>,
    found: Vec<LinearTouch>,
    /// The value at which the least gap was smallest in size.
    least: Option<Sight>,
    unseen: Vec<Unseen>,
}

/// Halvings of an interval in which it is not clear whether there is a touch.
const HALVINGS: u32 = 48;
/// What the middle of an interval may differ from what its ends predict, as a part of the gap.
const PREDICTED: f64 = 1.0 / 8.0;

impl Search<'_, '_> {
    fn motion(&self, value: f64) -> Result<FreeMotion> {
        let [machine, slope] = (self.family)(value)?;
        FreeMotion::new(&machine, &slope)
    }

    fn look(&mut self, value: f64) -> Result<Sight> {
        let motion = self.motion(value)?;
        let least = motion.least().ok_or_else(|| Error::input("there is no stop that could be grazed"))?;
        let sight = Sight { value, gap: least.gap, rate: motion.rate(&least) };
        if self.least.is_none_or(|known| sight.gap.abs() < known.gap.abs()) {
            self.least = Some(sight);
        }
        Ok(sight)
    }

    fn keep(&mut self, value: f64) -> Result<()> {
        let motion = self.motion(value)?;
        if let Some(at) = motion.least() {
            let (rate, state) = (motion.rate(&at), motion.motion().state(0.0));
            let stop = motion.contacts().all()[at.stop].name.clone();
            self.found.push(LinearTouch { parameter: value, at, rate, stop, state });
        }
        Ok(())
    }

    /// α and β of each gap where each is α + pβ: no coefficient but forces' and stops' places changes, and
    /// their derivatives, which dual numbers give exactly, are the same wherever they are looked at.
    fn affine(&self, start: f64, slope: &Machine<f64>) -> Option<Vec<[Series; 2]>> {
        let still = |entries: &[(usize, usize, f64)]| entries.iter().all(|entry| entry.2 == 0.0);
        let fixed = slope.period == 0.0
            && [&slope.mass, &slope.damping, &slope.stiffness].into_iter().all(|entries| still(entries))
            && slope.damping_ratio.iter().chain(slope.shapes.iter().flatten()).all(|x| *x == 0.0)
            && slope.stops.iter().flat_map(|stop| &stop.row).all(|x| *x == 0.0);
        let same = |value: &f64| (self.family)(*value).is_ok_and(|[_, other]| other == *slope);
        if !(fixed && [0.0, 1.0, -0.37, -start].iter().all(same)) {
            return None;
        }
        Some(self.motion(0.0).ok()?.gaps)
    }

    /// The two touches between which the machine is free. Says why there are none.
    fn scaled(&mut self, gaps: &[[Series; 2]], within: Option<[f64; 2]>) -> Result<String> {
        let mut ends = [None; 2];
        for (end, sign) in ends.iter_mut().zip([-1.0, 1.0]) {
            let (mut weights, mut last) = ([0.0, sign], sign * f64::INFINITY);
            loop {
                (self.check)()?;
                let (stop, phase, gap) = least(gaps, weights);
                let [a, b] = gaps[stop].each_ref().map(|series| series.at(phase)[0]);
                // From the infinity on, it opens: to the other side, or never.
                if gap >= 0.0 || a.is_nan() || b * sign >= 0.0 {
                    let behind = gap < 0.0 && last.is_finite();
                    *end = (!behind && last.is_finite()).then_some(last);
                    if behind {
                        let why =
                            "the motion without impacts is behind a stop at every value of the parameter";
                        return Ok(format!("{why}: by {:e} at {last:?}", -a - last * b));
                    }
                    break;
                }
                let next = -a / b;
                if !next.is_finite() {
                    break;
                }
                if (next - last) * sign >= 0.0 {
                    *end = Some(last);
                    break;
                }
                let size = next.abs().max(1.0);
                (weights, last) = ([1.0 / size, next / size], next);
            }
        }
        for end in ends.into_iter().flatten() {
            self.keep(end)?;
        }
        Ok(match (self.found.is_empty(), within) {
            (true, _) => "no value of the parameter brings the motion without impacts to a stop: vary another, such as the drive"
                .into(),
            (false, Some([lo, hi])) => {
                let all: Vec<String> =
                    self.found.iter().map(|touch| format!("{:?}", touch.parameter)).collect();
                format!("of all touches, at {}, none is within [{lo:?}, {hi:?}]", all.join(" and "))
            }
            (false, None) => String::new(),
        })
    }

    /// Looks along the ladders. Says why there is no touch.
    fn walked(&mut self, start: f64, within: Option<[f64; 2]>) -> Result<String> {
        let mut ends = Vec::new();
        match within {
            Some([lo, hi]) => {
                let inside =
                    ladder(start, true).chain(ladder(start, false)).filter(|x| (lo..=hi).contains(x));
                let even = (0..=EVEN).map(|i| lo + (hi - lo) * f64::from(i) / f64::from(EVEN));
                let mut values: Vec<f64> = inside.chain(even).collect();
                values.sort_by(f64::total_cmp);
                values.dedup();
                self.along(values.into_iter(), true)?;
            }
            None => {
                // At a resonance without damping there is no motion, beside it there is.
                let own = self.look(start).is_ok().then_some(start);
                for up in [true, false] {
                    let before = self.found.len();
                    let steps = own.into_iter().chain(ladder(start, up));
                    let end = self.along(steps, false)?;
                    if self.found.len() == before {
                        ends.extend(end);
                    }
                }
            }
        }
        let range = within.map_or_else(|| "both ways".into(), |[lo, hi]| format!("within [{lo:?}, {hi:?}]"));
        let mut why = format!(
            "no touch of the motion without impacts was found {range}: vary another parameter, such as the drive"
        );
        if let Some(Sight { value, gap, .. }) = self.least {
            why += &format!("; nearest to 0 of the values looked at, its least gap is {gap:e} at {value:?}");
        }
        ends.iter().for_each(|end| why += &format!("; {end}"));
        Ok(why)
    }

    fn pass(&mut self, ends: [f64; 2], error: &Error) {
        self.unseen.push(Unseen { ends, why: error.to_string() });
    }

    /// Looks from value to value, to the first touch or to all. Where there is no motion it ends, and says
    /// why, or begins anew.
    fn along(&mut self, values: impl Iterator<Item = f64>, all: bool) -> Result<Option<String>> {
        let (mut before, mut passed): (Option<Sight>, Option<([f64; 2], Error)>) = (None, None);
        for value in values {
            (self.check)()?;
            let here = match self.look(value) {
                Ok(here) => here,
                Err(error) if all && !error.is_interrupted() => {
                    let from = before.take().map_or(value, |before| before.value);
                    passed.get_or_insert(([from, value], error)).0[1] = value;
                    continue;
                }
                Err(error) if !error.is_interrupted() => {
                    return Ok(Some(format!("at {value:?} there is none: {error}")));
                }
                Err(error) => return Err(error),
            };
            if let Some(([from, _], error)) = passed.take() {
                self.pass([from, value], &error);
            }
            if let Some(before) = before {
                self.beside_resonances(before, here, all)?;
            }
            if !all && !self.found.is_empty() && self.found.iter().any(|t| between(before, t.parameter, here))
            {
                return Ok(None);
            }
            before = Some(here);
        }
        if let Some((ends, error)) = passed {
            self.pass(ends, &error);
        }
        Ok(None)
    }

    /// The touches between two values, cut at the resonances there.
    fn beside_resonances(&mut self, from: Sight, to: Sight, all: bool) -> Result<()> {
        let ends = [from.value.min(to.value), from.value.max(to.value)];
        let [machine, _] = (self.family)(from.value)?;
        let ks: Vec<u32> = machine.forcing.iter().map(|load| load.k).collect();
        let mut cuts = near_resonances(self.family, &ends, &ks, self.check)?;
        cuts.sort_by(f64::total_cmp);
        if from.value > to.value {
            cuts.reverse();
        }
        let mut before = from;
        for cut in cuts {
            let Ok(here) = self.look(cut) else { continue };
            self.halved(before, here, HALVINGS, all)?;
            before = here;
        }
        self.halved(before, to, HALVINGS, all)
    }

    /// The touches between two values, in their order.
    fn halved(&mut self, from: Sight, to: Sight, left: u32, all: bool) -> Result<()> {
        let width = to.value - from.value;
        let crosses = (from.gap > 0.0) != (to.gap > 0.0);
        let halfway = from.value + width / 2.0;
        if halfway == from.value || halfway == to.value || left == 0 {
            return if crosses { self.root(from, to) } else { Ok(()) };
        }
        // At a resonance without damping there is no motion.
        let middle = self.look(halfway).or_else(|_| self.look(from.value + 0.375 * width));
        let middle = match middle {
            Ok(middle) => middle,
            Err(error) => {
                self.pass([from.value, to.value], &error);
                return Ok(());
            }
        };
        let predicted = f64::midpoint(from.gap, to.gap) + width / 8.0 * (from.rate - to.rate);
        let off = (middle.gap - predicted).abs();
        let all_three = [from, middle, to];
        let known = if crosses {
            let rates = all_three.map(|sight| sight.rate * width > 0.0);
            rates[0] == rates[1] && rates[1] == rates[2] && off <= PREDICTED * (to.gap - from.gap).abs()
        } else {
            let free = from.gap > 0.0;
            let size = all_three.iter().map(|sight| sight.gap.abs()).fold(f64::INFINITY, f64::min);
            let clear = |a: Sight, b: Sight| {
                let third = (b.value - a.value) / 3.0;
                [a.gap + third * a.rate, b.gap - third * b.rate].iter().all(|x| (*x > 0.0) == free)
            };
            (middle.gap > 0.0) == free && off <= PREDICTED * size && clear(from, middle) && clear(middle, to)
        };
        if known {
            return if crosses { self.root(from, to) } else { Ok(()) };
        }
        let before = self.found.len();
        self.halved(from, middle, left - 1, all)?;
        if !all && self.found.len() > before {
            return Ok(());
        }
        self.halved(middle, to, left - 1, all)
    }

    /// Where the least gap passes through 0 between two values: Newton's method between bounds.
    fn root(&mut self, from: Sight, to: Sight) -> Result<()> {
        let (mut free, mut behind) =
            if from.gap > 0.0 { (from.value, to.value) } else { (to.value, from.value) };
        let mut here = free + (behind - free) / 2.0;
        for turn in 1.. {
            let (gap, rate) = match self.look(here) {
                Ok(Sight { gap, rate, .. }) => (gap, rate),
                Err(error) => {
                    self.pass([free, behind], &error);
                    break;
                }
            };
            *(if gap > 0.0 { &mut free } else { &mut behind }) = here;
            let next = here - gap / rate;
            // Where Newton's steps creep, halving ends it.
            let inside = (next - free) * (behind - next) > 0.0 && (turn % 4 > 0 || next == here);
            let next = if inside { next } else { free + (behind - free) / 2.0 };
            if next == here || next == free || next == behind {
                return self.keep(here);
            }
            here = next;
        }
        Ok(())
    }
}

/// Whether a value is between two that were looked at.
fn between(from: Option<Sight>, value: f64, to: Sight) -> bool {
    from.is_some_and(|from| (value - from.value) * (to.value - value) >= 0.0)
}

/// Even steps between two given values, beside those of the ladders.
const EVEN: u32 = 400;

/// Values from `start` to the largest float one way, or down through 0 and to it on the other side: four to
/// an octave near by, one to eight octaves far away.
fn ladder(start: f64, away: bool) -> impl Iterator<Item = f64> {
    let unit = if start == 0.0 { 1.0 } else { start };
    let steps: Vec<f64> = (1..=64)
        .map(|i| f64::from(i) / 4.0)
        .chain((1..=48).map(|i| 16.0 + f64::from(i)))
        .chain((1..=136).map(|i| 64.0 + 8.0 * f64::from(i)))
        .collect();
    let rungs = |sign: f64, steps: Vec<f64>| steps.into_iter().map(move |step| sign * step.exp2());
    let mut all: Vec<f64> = Vec::new();
    if away && start != 0.0 {
        all.extend(rungs(1.0, steps.clone()));
    } else {
        let mirrored = if away { 1.0 } else { -1.0 };
        if start != 0.0 {
            all.extend(rungs(1.0, steps.iter().take(112).map(|step| -step).collect()));
            all.push(0.0);
        }
        all.extend(rungs(mirrored, steps.iter().take(112).rev().map(|step| -step).collect()));
        all.push(mirrored);
        all.extend(rungs(mirrored, steps));
    }
    all.into_iter().map(move |rung| rung * unit).take_while(|value| value.is_finite())
}

/// The stop, the phase and the value of the least of x α + y β.
fn least(gaps: &[[Series; 2]], [x, y]: [f64; 2]) -> (usize, f64, f64) {
    let of = |(stop, [a, b]): (usize, &[Series; 2])| {
        let sum = Series::combination(&[(x, a), (y, b)]);
        super::free::minima(&sum).into_iter().map(move |(phase, gap)| (stop, phase, gap))
    };
    gaps.iter().enumerate().flat_map(of).min_by(|a, b| a.2.total_cmp(&b.2)).unwrap_or((0, 0.0, 0.0))
}
