//! The end of an attractor at a homoclinic crossing: where a corner of an unstable manifold falls on the
//! stable one.
//!
//! An unstable orbit S with one large multiplier Λ > 1 has a one-dimensional unstable manifold Wᵘ(S).
//! Followed from S it first meets the states whose next flight grazes a wall at its *corner*; there the map
//! from period to period has a square root, and the corner's images are the tips of the attractor beyond it.
//! When a tip's image crosses the stable manifold Wˢ(S) the attractor is no longer confined, and ends:
//! section 4.2's µ_cr is where the second image does. Not here: finding S (`orbit`), simulation.
//!
//! No manifold is drawn. Points S + εv on the unstable direction fall on Wᵘ(S) as they are iterated, the
//! error shrinking by the small multiplier each time, so only the ε of the corner is looked for; and the side
//! of Wˢ(S) on which a state lies is the sign of the left eigenvector's product with its distance from S, a
//! few iterates on.

use std::f64::consts::TAU;

use crate::{
    error::{Error, Result},
    motion::{
        Flow, State, Time,
        algebra::{inverse, product},
    },
    one::{
        orbit::{Family, Itinerary, Orbit, Oscillator, find, minima, monodromy},
        simulate::{Event, Settings, Simulator},
    },
};

/// An unstable orbit on a stroboscopic section, with its directions there.
pub(crate) struct Saddle {
    oscillator: Oscillator,
    simulator: Simulator,
    periods: i64,
    /// The orbit on the section, once in its period.
    pub state: State,
    /// The larger multiplier.
    pub expansion: f64,
    /// The unit vector along Wᵘ.
    pub unstable: [f64; 2],
    /// The row vector that is normal to Wˢ.
    normal: [f64; 2],
    /// The size of the motion.
    size: f64,
}

/// Where Wᵘ first meets the states whose next flight grazes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// The state on the section.
    pub state: State,
    /// ε: it is an image of S + εv.
    pub(crate) offset: f64,
    /// Which image, in periods of S.
    pub(crate) image: u32,
    /// The least minimum of the gap in the flight from it: what is left of 0.
    pub gap: f64,
}

/// One period of S from a state: where it leads, how many impacts there are, the least minimum of the gap
/// without impact.
struct Flight {
    end: State,
    impacts: u32,
    least: f64,
}

impl Saddle {
    /// The orbit with its directions at `phase`, a phase at which no impact is near.
    ///
    /// # Errors
    /// An input error if it is no orbit or its multipliers are not 0 < λ₂ < 1 < λ₁; those of
    /// [`Simulator::new`].
    pub fn new(oscillator: Oscillator, orbit: &Orbit, phase: f64, settings: &Settings) -> Result<Saddle> {
        let [(expansion, imaginary), (contraction, _)] = orbit.multipliers.values();
        if imaginary != 0.0 || !(expansion > 1.0 && (0.0..1.0).contains(&contraction)) {
            return Err(Error::input(format!(
                "the orbit's multipliers are {expansion} and {contraction}: it is not a saddle with positive multipliers"
            )));
        }
        if !orbit.admissibility.is_admissible() {
            return Err(Error::input("this is not an orbit of the system: it passes through a wall"));
        }
        let wait = (phase - orbit.z[0]).rem_euclid(TAU);
        let state = State { t: phase, ..orbit.state(&oscillator, orbit.z[0] + wait)? };
        let (_, there) = oscillator.flow().advance_linearised(State { t: phase - wait, ..state }, wait);
        let m =
            product(&product(&there, &monodromy(&oscillator, &orbit.itinerary, &orbit.z)?), &inverse(&there));
        let mut unstable = [m[0][1], expansion - m[0][0]];
        let length = unstable[0].hypot(unstable[1]);
        unstable.iter_mut().for_each(|x| *x /= length);
        let simulator = Simulator::new(oscillator.system(), settings)?.counting_too(oscillator.tally());
        let normal = [m[1][0], expansion - m[0][0]];
        let along = normal[0] * unstable[0] + normal[1] * unstable[1];
        Ok(Saddle {
            oscillator,
            simulator,
            periods: i64::from(orbit.itinerary.periods()),
            state,
            expansion,
            unstable,
            normal: normal.map(|x| x / along),
            size: orbit.unit,
        })
    }

    fn flight(&self, from: State) -> Result<Flight> {
        let start = Time::new(0, from.t);
        let until = Time::new(self.periods, from.t);
        let mut run = self.simulator.start(start, from.q, from.u)?;
        let (mut last, mut at, mut impacts, mut least) = (start, from, 0, f64::INFINITY);
        loop {
            let event = run.next(until);
            let now = event.time().unwrap_or(run.time());
            // Tangencies do not interrupt a flight: its minima are those of the flow since the last impact.
            if matches!(event, Event::Tangency(_)) {
                continue;
            }
            let found = minima(&self.oscillator, 0, at, now.since(last));
            least = found.iter().fold(least, |least, minimum| least.min(minimum.gap));
            match event {
                Event::Impact(_) => impacts += 1,
                Event::End(_) => return Ok(Flight { end: run.state(), impacts, least }),
                _ => {}
            }
            (last, at) = (now, run.state());
        }
    }

    fn offset(&self, offset: f64) -> State {
        let [q, u] = self.unstable;
        State { q: self.state.q + offset * q, u: self.state.u + offset * u, ..self.state }
    }

    /// The corner on the side of S on which there is one within `IMAGES` images of S + `offset` v. The corner
    /// does not depend on the offset, as long as that is small.
    ///
    /// # Errors
    /// An input error if there is none on either side.
    pub fn corner(&self, offset: f64) -> Result<Corner> {
        for side in [offset, -offset] {
            if let Some(corner) = self.corner_beyond(side)? {
                return Ok(corner);
            }
        }
        Err(Error::input("the unstable manifold does not come to graze"))
    }

    fn corner_beyond(&self, offset: f64) -> Result<Option<Corner>> {
        let impacts = self.flight(self.state)?.impacts;
        let mut state = self.offset(offset);
        for image in 0..IMAGES {
            let flight = self.flight(state)?;
            if flight.impacts > impacts {
                return if image == 0 {
                    Ok(None)
                } else {
                    self.corner_at(offset, image - 1, impacts).map(Some)
                };
            }
            if flight.impacts < impacts {
                return Ok(None);
            }
            state = flight.end;
        }
        Ok(None)
    }

    /// The flight from the given image of S + εv, if all before it have as many impacts as S, and where it
    /// starts.
    fn image(&self, offset: f64, image: u32) -> Result<(State, Flight)> {
        let mut state = self.offset(offset);
        for _ in 0..image {
            state = self.flight(state)?.end;
        }
        Ok((state, self.flight(state)?))
    }

    /// The corner in the fundamental segment [ε, Λε]: bisection by the number of impacts, then the secant
    /// rule on the gap, from the side without the impact, where it is smooth.
    fn corner_at(&self, offset: f64, image: u32, impacts: u32) -> Result<Corner> {
        let (mut free, mut struck) = (offset, offset * self.expansion);
        while (struck - free).abs() > 1e-7 * free.abs() {
            let middle = free + (struck - free) / 2.0;
            if self.image(middle, image)?.1.impacts > impacts {
                struck = middle;
            } else {
                free = middle;
            }
        }
        let gap = |offset: f64| Ok::<f64, Error>(self.image(offset, image)?.1.least);
        let mut before = (free - (struck - free), 0.0);
        before.1 = gap(before.0)?;
        let mut here = (free, gap(free)?);
        for _ in 0..8 {
            let next = here.0 - here.1 * (here.0 - before.0) / (here.1 - before.1);
            if !next.is_finite() || here.1.abs() < 1e-15 * self.size {
                break;
            }
            (before, here) = (here, (next, gap(next)?));
            if here.1.abs() >= before.1.abs() {
                here = before;
                break;
            }
        }
        Ok(Corner { state: self.image(here.0, image)?.0, offset: here.0, image, gap: here.1 })
    }

    /// A state's `images`-th image, in periods of S.
    ///
    /// # Errors
    /// As [`Simulator::start`].
    pub fn iterate(&self, state: State, images: u32) -> Result<State> {
        (0..images).try_fold(state, |state, _| Ok(self.flight(state)?.end))
    }

    /// Which side of Wˢ a state is on, and about how far from it: the coordinate along Wᵘ of its second
    /// image, less S. Exact in sign near Wˢ, where the second image is near S.
    ///
    /// # Errors
    /// As [`Simulator::start`].
    pub fn side(&self, state: State) -> Result<f64> {
        let end = self.iterate(state, 2)?;
        Ok(self.normal[0] * (end.q - self.state.q) + self.normal[1] * (end.u - self.state.u))
    }
}

/// How many images of a point near S are looked at.
const IMAGES: u32 = 40;

/// A parameter value at which an image of the corner lies on the stable manifold.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Crisis {
    /// The parameter.
    pub parameter: f64,
    /// S there.
    pub saddle: Orbit,
    /// The corner there.
    pub corner: Corner,
    /// What is left of the distance to Wˢ.
    pub distance: f64,
}

/// Where to look for a crisis.
#[derive(Debug, Clone)]
pub struct CrisisSearch<'a> {
    /// S's pattern, and its unknowns about the middle of the bracket.
    pub itinerary: &'a Itinerary,
    /// The unknowns.
    pub start: Vec<f64>,
    /// The phase of the section.
    pub phase: f64,
    /// Which image of the corner.
    pub images: u32,
    /// ε: how far from S the unstable manifold is entered.
    pub offset: f64,
    /// Parameter values on either side.
    pub bracket: (f64, f64),
    /// How finely flights are simulated.
    pub settings: &'a Settings,
}

/// The crisis in a bracket, to rounding: bisection until the secant rule is good, then the secant rule, kept
/// in the bracket, the end that stays twice counting half (Illinois). Cost: some 30 corners.
///
/// # Errors
/// An input error if S or its corner cannot be found on the way, or the bracket's ends are on the same side
/// of Wˢ.
pub fn crisis(family: &dyn Family, search: &CrisisSearch) -> Result<Crisis> {
    let at = |parameter: f64| -> Result<Crisis> {
        let oscillator = family.at(parameter)?;
        let orbit = find(&oscillator, search.itinerary, search.start.clone())?;
        let saddle = Saddle::new(oscillator, &orbit, search.phase, search.settings)?;
        let corner = saddle.corner(search.offset)?;
        let distance = saddle.side(saddle.iterate(corner.state, search.images)?)?;
        Ok(Crisis { parameter, saddle: orbit, corner, distance })
    };
    let (mut a, mut b) = (at(search.bracket.0)?, at(search.bracket.1)?);
    if (a.distance < 0.0) == (b.distance < 0.0) {
        return Err(Error::input(format!(
            "the corner's image is on the same side of the stable manifold at {} and {}",
            a.parameter, b.parameter
        )));
    }
    let (mut weight, mut kept) = ([a.distance, b.distance], None);
    for round in 0..80 {
        let width = b.parameter - a.parameter;
        let secant = b.parameter - weight[1] * width / (weight[1] - weight[0]);
        let inside = (secant - a.parameter) * (secant - b.parameter) < 0.0;
        // Far from the crisis the distance is no straight line; and where the secant leaves the bracket,
        // halve it.
        let halve = round < 12 || !inside;
        let middle = if halve { a.parameter + width / 2.0 } else { secant };
        if middle == a.parameter || middle == b.parameter {
            break;
        }
        let found = at(middle)?;
        if found.distance == 0.0 {
            return Ok(found);
        }
        let lower = (found.distance < 0.0) == (a.distance < 0.0);
        if !halve && kept == Some(lower) {
            weight[usize::from(lower)] /= 2.0;
        }
        kept = (!halve).then_some(lower);
        weight[usize::from(!lower)] = found.distance;
        *(if lower { &mut a } else { &mut b }) = found;
    }
    Ok(if a.distance.abs() < b.distance.abs() { a } else { b })
}
