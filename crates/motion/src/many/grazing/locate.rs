//! The search along the parameter.

use std::{cell::RefCell, f64::consts::TAU};

use super::{
    HalfPeriod,
    free::{FreeMotion, LeastGap},
    local_map::local_map,
};
use crate::{
    continuation::{LeadingImpact, LocalMap, TWICE, pattern_of},
    error::{Error, Result},
    many::{
        Family, Periodic, State,
        orbit::{Itinerary, Strike},
    },
};

/// The motion without impacts that grazes.
#[derive(Debug, Clone)]
pub struct Grazing {
    /// The parameter there.
    pub parameter: f64,
    /// Where it grazes, and what is left of the gap.
    pub at: LeastGap,
    /// The size of the gaps' motion.
    pub scale: f64,
    /// Other minima of gaps that are zero to rounding: the map is not the whole theory then.
    pub others: Vec<LeastGap>,
    /// The motion.
    pub motion: Periodic,
    /// The map there.
    pub map: LocalMap,
    /// That of half a period, where a symmetric machine grazes a stop and its mirror.
    pub half: Option<HalfPeriod>,
}

impl Grazing {
    /// The grazing of the motion without impacts of a linear machine at a touch that is known.
    ///
    /// # Errors
    /// Where the family is not defined there; no stop; det(I − A) = 0.
    pub fn at(family: &dyn Family, touch: f64) -> Result<Grazing> {
        let (machine, slope) = family.at(touch)?;
        Grazing::of(touch, &FreeMotion::new(&machine, &slope)?)
    }

    /// The grazing beside a value of the parameter, of the motion beside a state at phase 0.
    ///
    /// # Errors
    /// As [`locate`].
    pub fn near(family: &dyn Family, parameter: f64, state: &State) -> Result<Grazing> {
        let look = look_along(family, Some(state));
        let parameter = polish(&look, parameter)?;
        Grazing::of(parameter, &look(parameter)?.0)
    }

    fn of(parameter: f64, motion: &FreeMotion) -> Result<Grazing> {
        let at = motion.least().ok_or_else(|| Error::input("there is no stop that could be grazed"))?;
        let scale = motion.scale();
        let tiny = TWICE * scale;
        let mut others = motion.minima();
        others.retain(|other| other.gap.abs() <= tiny && *other != at);
        let (map, half) = (local_map(motion, &at, TAU)?, HalfPeriod::new(motion, &at, &others)?);
        Ok(Grazing { parameter, at, scale, others, motion: motion.motion().clone(), map, half })
    }

    /// The map that the local theory is asked about: of half a period if two stops that mirror each other are
    /// grazed, and then patterns count halves.
    pub fn local(&self) -> &LocalMap {
        self.half.as_ref().map_or(&self.map, |half| &half.map)
    }

    /// The pattern in the machine of one of the map's, and a start for Newton's method there at the distance
    /// `away` of the parameter from the grazing: see [`LocalMap::start`]. Of half a period, a pattern
    /// with an odd number of halves is gone round twice.
    ///
    /// # Errors
    /// Those of [`Itinerary::new`].
    pub fn start(&self, impacts: &[LeadingImpact], away: f64) -> Result<(Itinerary, Vec<f64>)> {
        if let Some(half) = &self.half {
            let (grazing, places) = ((self.at.phase, 1), [self.at.stop, half.mirror]);
            return half.map.half_start(grazing, places, impacts, away);
        }
        let strike = |&n: &u64| Strike { place: self.at.stop, periods: n as u32 };
        let pattern = Itinerary::new(pattern_of(impacts).iter().map(strike).collect())?;
        Ok((pattern, self.map.start(self.at.phase, impacts, away)))
    }
}

/// What a search for a grazing came to.
#[derive(Debug, Clone)]
pub enum Search {
    /// The nearest grazing that was found.
    Found(Box<Grazing>),
    /// None, and why.
    Nothing(String),
}

/// What may know a touch beyond a fold, or why there is none, from the state at phase 0 at the start.
pub type Further<'f> = &'f dyn Fn(&State) -> Result<std::result::Result<Grazing, String>>;

/// Values of the parameter that are tried each way.
const STEPS: u32 = 200;

/// How far a parameter is looked through that has this value, where nothing else is said: half of it, or the
/// change that moves a gap, to first order, by the size of the gaps' motion, the larger; 1/2 where neither is
/// anything. `near` as in [`locate`].
///
/// # Errors
/// Where the family is not defined.
pub fn own_reach(family: &dyn Family, value: f64, near: Option<&State>) -> Result<f64> {
    let (machine, slope) = family.at(value)?;
    // Without a periodic motion there is no gaps' motion.
    let motion = FreeMotion::near(&machine, &slope, near, family.tally());
    let moved = motion.map_or(0.0, |motion| motion.scale() / motion.drift_scale());
    let reach = if moved.is_finite() { moved.max(value.abs() / 2.0) } else { value.abs() / 2.0 };
    Ok(if reach > 0.0 { reach } else { 0.5 })
}

/// The grazing of the motion without impacts nearest to `start`, within `reach` of it; of several motions,
/// which there may be where forces are formulas, of the one that Newton's method finds from `near`, a state
/// at phase 0. From step to step of the parameter, 200 of them each way, the least gap changes sign, or its
/// derivative does, so that it dips between them; dips of a fraction of a step may be missed. Then Newton's
/// method on the least gap as a function of the parameter, kept between bounds. Where there is no motion any
/// more, or no touch is found, `further` is asked once.
///
/// # Errors
/// Where the family is not defined at `start`; no periodic motion there; det(I − A) = 0 at the grazing; those
/// of `further`.
pub fn locate(
    family: &dyn Family,
    start: f64,
    reach: f64,
    near: Option<&State>,
    mut further: Option<Further>,
) -> Result<Search> {
    let look = look_along(family, near);
    let (motion, least, rate) = look(start)?;
    let (tiny, name) = (TWICE * motion.scale(), &motion.contacts().all()[least.stop].name);
    let state = motion.motion().state(0.0);
    let graze = |look: Look, near: f64| {
        let parameter = polish(look, near)?;
        Grazing::of(parameter, &look(parameter)?.0)
    };
    let away = |known: &Grazing| (known.parameter - start).abs();
    if least.gap.abs() <= tiny {
        return Ok(Search::Found(Box::new(graze(&look, start)?)));
    }
    let (mut nearest, mut why): (Option<Grazing>, Vec<String>) = (None, Vec::new());
    let mut ask = |why: &mut Vec<String>| -> Result<Option<Grazing>> {
        let Some(further) = further.take() else { return Ok(None) };
        Ok(further(&state)?.map_err(|more| why.push(more)).ok())
    };
    for direction in [1.0, -1.0] {
        if least.gap < 0.0 {
            why.push(format!(
                "at the start the motion without impacts is already behind stop {name}, by {:e}: start where it is free",
                -least.gap
            ));
            break;
        }
        let look = look_along(family, Some(&state));
        let (mut before, mut last) = (start, (least.gap, rate * direction));
        for step in 1..=STEPS {
            let there = start + direction * reach * f64::from(step) / f64::from(STEPS);
            if nearest.as_ref().is_some_and(|known| away(known) <= (before - start).abs()) {
                break;
            }
            let (gap, rate) = match look(there) {
                Ok((_, least, rate)) => (least.gap, rate * direction),
                Err(error) => {
                    why.push(format!("the search ended at {there:?}: {error}"));
                    // What is known beyond a fold bounds the other way.
                    if nearest.is_none() {
                        nearest = ask(&mut why)?;
                    }
                    break;
                }
            };
            let end = if gap <= 0.0 {
                Some(there)
            } else if last.1 < 0.0 && rate > 0.0 {
                dip(&look, before, there, direction)?
            } else {
                None
            };
            if let Some(end) = end {
                let found = graze(&look, root(&look, before, end)?)?;
                if nearest.as_ref().is_none_or(|known| away(&found) < away(known)) {
                    nearest = Some(found);
                }
                break;
            }
            (before, last) = (there, (gap, rate));
        }
    }
    if nearest.is_none() {
        nearest = ask(&mut why)?;
    }
    Ok(match nearest {
        Some(found) => Search::Found(Box::new(found)),
        None => {
            let none = format!("the motion without impacts touches no stop within {reach} of {start:?}");
            Search::Nothing(if least.gap < 0.0 { why } else { [vec![none], why].concat() }.join("; "))
        }
    })
}

/// The motion at a value of the parameter that is nearest to the one looked at before.
fn look_along<'f>(
    family: &'f dyn Family,
    near: Option<&State>,
) -> impl Fn(f64) -> Result<(FreeMotion, LeastGap, f64)> + 'f {
    let last: RefCell<Option<State>> = RefCell::new(near.cloned());
    move |parameter: f64| {
        let (machine, slope) = family.at(parameter)?;
        let motion = FreeMotion::near(&machine, &slope, last.borrow().as_ref(), family.tally())?;
        last.replace(Some(motion.motion().state(0.0)));
        let least = motion.least().ok_or_else(|| Error::input("there is no stop that could be grazed"))?;
        let rate = motion.rate(&least);
        Ok((motion, least, rate))
    }
}

type Look<'l> = &'l dyn Fn(f64) -> Result<(FreeMotion, LeastGap, f64)>;

/// A value between two, at which the least gap falls and rises again, where it is not positive.
fn dip(look: Look, mut lo: f64, mut hi: f64, direction: f64) -> Result<Option<f64>> {
    for _ in 0..50 {
        let middle = lo + (hi - lo) / 2.0;
        let (_, least, rate) = look(middle)?;
        if least.gap <= 0.0 {
            return Ok(Some(middle));
        }
        if rate * direction < 0.0 {
            lo = middle;
        } else {
            hi = middle;
        }
    }
    Ok(None)
}

/// Where the least gap, positive at `free`, passes through 0 before `behind`: Newton's method between bounds.
fn root(look: Look, mut free: f64, mut behind: f64) -> Result<f64> {
    let mut here = free + (behind - free) / 2.0;
    // Far away Newton's steps are rounding's: down from the largest float it takes some 1100 halvings.
    for _ in 0..1200 {
        let (_, least, rate) = look(here)?;
        if least.gap > 0.0 {
            free = here;
        } else {
            behind = here;
        }
        let next = here - least.gap / rate;
        let inside = (next - free) * (behind - next) > 0.0;
        let next = if inside { next } else { free + (behind - free) / 2.0 };
        if (next - here).abs() <= 4.0 * f64::EPSILON * here.abs() || next == free || next == behind {
            break;
        }
        here = next;
    }
    Ok(here)
}

/// Newton's method from nearby, as long as it makes the gap smaller.
fn polish(look: Look, mut here: f64) -> Result<f64> {
    let (_, mut least, mut rate) = look(here)?;
    for _ in 0..4 {
        let next = here - least.gap / rate;
        let Ok((_, closer, there)) = look(next) else { break };
        if closer.gap.abs().is_nan() || closer.gap.abs() >= least.gap.abs() {
            break;
        }
        (here, least, rate) = (next, closer, there);
    }
    Ok(here)
}
