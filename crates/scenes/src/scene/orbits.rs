//! The keys of the tasks about periodic orbits: `orbit`, `event`, `grazing`.

use num_rational::BigRational;

use std::f64::consts::TAU;

use num_traits::ToPrimitive;

use super::{
    grammar::LIMIT_BITS,
    keys::{Entry, StopName, Table, Value, keys},
    simulate::Start,
    tolerance::Tolerances,
};
use crate::{
    continuation::{Bifurcation, Options, OrbitSearch, SearchReach, SearchTally},
    error::Result,
    motion::{Side, System},
    number::parse_rational_within,
    one::orbit::{Itinerary, Orbit, Oscillator, Strike, find, search_obstacle, search_while},
    source::hint,
};

keys! {
    /// Which periodic orbit, and where Newton's method starts.
    pub struct OrbitKeys {
        /// n_1, …, n_m: forcing periods from one impact's phase to the next's; empty without impacts
        pattern: Vec<u32> = "[]",
        /// that of each impact, if there are several
        stops: Vec<StopName> = "[]",
        /// of an orbit without impacts
        period: u32 = "1",
        /// t_1, V_1, …: phases (fractions, or "0.5 rad") and incoming speeds; without impacts q, then u at t
        /// = 0; if empty, a search
        start: Vec<StartNumber> = "[]",
        /// how many the search makes
        starts: u32 = "500",
        /// greatest of the starts (of several impacts of a linear machine it follows from the times); without
        /// it the [motion's size](#sizes)
        speed: Option<f64>,
    }
}

/// A number of an orbit's `start`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum StartNumber {
    /// In the scene's units; a time as a fraction of the period.
    Plain(f64),
    /// A time in radians of the forcing.
    Radians(f64),
}

impl StartNumber {
    /// As it stands there.
    pub(crate) fn value(self) -> f64 {
        match self {
            StartNumber::Plain(value) | StartNumber::Radians(value) => value,
        }
    }

    /// A time in radians of the forcing.
    pub(crate) fn radians(self) -> f64 {
        match self {
            StartNumber::Plain(fraction) => fraction * TAU,
            StartNumber::Radians(time) => time,
        }
    }
}

impl Value for StartNumber {
    fn shape() -> String {
        "number".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        let radians = entry.item.as_str().and_then(|text| text.trim_end().strip_suffix("rad"));
        let Some(text) = radians else { return f64::read(entry).map(StartNumber::Plain) };
        let number = parse_rational_within(text.trim(), LIMIT_BITS);
        let number = number.map_err(|error| entry.fail(&error.to_string()))?.to_f64();
        let number = number.filter(|value| value.is_finite());
        number.map(StartNumber::Radians).ok_or_else(|| entry.fail("is beyond the range of floats"))
    }
}

impl Value for StopName {
    fn shape() -> String {
        "text".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        let (name, stops) = (entry.text()?, entry.scope.stops);
        stops.iter().find(|stop| stop.name == name).cloned().ok_or_else(|| {
            let names = hint(name, stops.iter().map(|stop| stop.name.as_str()));
            entry.fail(&format!("is no {} of the scene; {names}", entry.scope.format.stop()))
        })
    }
}

impl OrbitKeys {
    /// The pattern with its walls, for the engine `one`.
    ///
    /// # Errors
    /// An input error if the walls do not fit the pattern or the scene.
    pub(crate) fn itinerary(&self, system: &System<f64>) -> Result<Itinerary> {
        if self.pattern.is_empty() {
            return Itinerary::free(self.period);
        }
        let side = if system.lower.is_some() { Side::Lower } else { Side::Upper };
        let side = |i: usize| self.stops.get(i).and_then(|stop| stop.side).unwrap_or(side);
        let strikes = self.pattern.iter().enumerate().map(|(i, &periods)| Strike { place: side(i), periods });
        Itinerary::new(strikes.collect())
    }

    /// `start` in the unknowns of the equations, each speed after its time; `speed` converts the speeds.
    pub(crate) fn unknowns(&self, speed: impl Fn(f64) -> f64) -> Vec<f64> {
        let impacts = !self.pattern.is_empty();
        let unknown = |(i, number): (usize, &StartNumber)| match i % 2 {
            0 if impacts => number.radians(),
            1 if impacts => speed(number.value()),
            _ => number.value(),
        };
        self.start.iter().enumerate().map(unknown).collect()
    }

    /// What is said where no orbit is found.
    pub(crate) fn none(&self, tally: &SearchTally) -> String {
        let of_the_motion = || "speeds of the size of the motion".to_string();
        let speeds = self.speed.map_or_else(of_the_motion, |speed| format!("speeds up to {speed}"));
        format!("no orbit of the pattern with {speeds}, of {}", tally.told())
    }

    /// The orbits of the pattern: the one Newton's method finds from `start`, or those of a search.
    ///
    /// # Errors
    /// As [`find`]; those of `check`.
    pub(crate) fn orbits(
        &self,
        oscillator: &Oscillator,
        check: impl Fn() -> Result<()>,
    ) -> Result<OrbitSearch<Orbit>> {
        let (itinerary, rate) = (self.itinerary(oscillator.system())?, oscillator.system().shown_rate());
        if self.start.is_empty() {
            let speed = self.speed.map_or_else(|| oscillator.unit(&itinerary), |speed| speed / rate);
            let all = search_while(oscillator, &itinerary, self.starts, speed, check)?;
            let nothing = all.found.is_empty();
            let why = nothing.then(|| search_obstacle(oscillator, &itinerary, self.starts, speed)).flatten();
            return why.map_or(Ok(all), Err);
        }
        let mut start = self.unknowns(|speed| speed / rate);
        if self.pattern.is_empty() {
            // q and u.
            start.iter_mut().skip(1).for_each(|u| *u /= rate);
        }
        find(oscillator, &itinerary, start).map(|orbit| OrbitSearch::of_one(Ok(orbit)))
    }
}

keys! {
    /// Finds periodic orbits, their impacts and multipliers, and whether each is admissible.
    pub struct OrbitTask {
        /// which
        orbit: OrbitKeys = "{}",
        /// of what nothing drives, in place of `orbit`: where a motion starts that settles on a limit cycle
        cycle: Option<Start>,
        /// of that, units of time (the scene's period) that pass first
        transient: u64 = "300",
        /// takes several values
        parameter: Option<String>,
        /// its values
        values: Vec<BigRational> = "[]",
    }
}

impl Value for Bifurcation {
    fn shape() -> String {
        Bifurcation::MONITORED.map(|known| format!("`\"{}\"`", known.name())).join(" or ")
    }

    fn read(entry: &Entry) -> Result<Self> {
        entry.word(&Bifurcation::MONITORED.map(|known| (known.name(), known)))
    }
}

keys! {
    /// Locates a bifurcation of an orbit in a parameter, to rounding.
    pub struct EventTask {
        /// which
        event: Bifurcation,
        /// what varies
        parameter: String,
        /// at the parameter's present value
        orbit: OrbitKeys,
        /// how far along its branch to look, both ways ([default](#sizes))
        reach: Option<f64>,
        /// how the branch is followed
        options: Options = "{}",
    }
}

impl EventTask {
    /// Whether a touch is asked for that a linear motion without impacts has at all.
    pub(crate) fn is_of_free_motion(&self) -> bool {
        self.event == Bifurcation::Grazing && self.orbit.pattern.is_empty() && self.reach.is_none()
    }
}

/// How far to look along the branch of an oscillator from an orbit: in the norm of times, of speeds in units
/// of the motion's size and of the parameter, as it is if `reach` is given, else in what changes the system
/// by its own size.
pub(crate) fn extent(reach: Option<f64>, oscillator: &Oscillator, orbit: &Orbit) -> SearchReach {
    match reach {
        Some(reach) => SearchReach::Length { reach, unit: 1.0 },
        None => SearchReach::Length { reach: 0.5, unit: oscillator.parameter_unit(orbit.unit) },
    }
}

keys! {
    /// Locates a grazing bifurcation. The local theory decides which orbits are born on which side, and
    /// whether chaos is, with its entropy; each orbit is then found in the true system nearby.
    pub struct GrazingTask {
        /// what varies
        parameter: String,
        /// the one that comes to graze, near the parameter's present value; of `many` the motion without
        /// impacts near `start`
        orbit: OrbitKeys = "{}",
        /// how far to look, as of `event` ([default](#sizes))
        reach: Option<f64>,
        /// two values between which all touches are listed: linear motions without impacts
        within: Vec<f64> = "[]",
        /// how the branch is followed; engine `one`
        options: Options = "{}",
        /// largest period of the patterns, in periods of that orbit
        max_period: u32 = "4",
        /// |eµ| at which born orbits are found; without it 1e-6 of the motion's size
        distance: Option<f64>,
        /// follow motions beside the touch; without it where no force is a formula and no stop compliant
        seen: Option<bool>,
        /// prove each periodic attractor seen there, with a certificate each
        prove: bool = "false",
        /// prove [how far](ranges.md) what is born goes on; `"main"`: all born together, a tenth of the work;
        /// `true`: also single orbits and parts
        range: RangeKey = "\"main\"",
        /// prove [that chaos attracts](attractor.md): overdamped, one stop, linear forces, the motion without
        /// impacts touching
        attractor: bool = "false",
        /// how much each other parameter moves the touch, per cent
        sensitivity: bool = "false",
        /// how exactly parameters are known, as `{ k = "2%", d = 0.01, m = [0.9, 1.1] }`: what is told holds
        /// for every machine that this allows
        tolerance: Tolerances = "{}",
    }
}

keys! {
    /// How far a range is followed.
    pub struct RangeKeys {
        /// work per side, in units of some 30 µs; without it 100000
        effort: Option<u64>,
    }
}

/// Which ranges are proved, and with which work.
#[derive(Debug, Clone, PartialEq)]
pub enum RangeKey {
    /// None.
    None,
    /// Of all that is born, on either side, as far as little work goes.
    Main,
    /// Of all that is born, of each orbit of one impact, and of what else there is.
    All(RangeKeys),
}

impl Value for RangeKey {
    fn shape() -> String {
        "`true`, `false`, `\"main\"` or a table".to_string()
    }

    fn table() -> Option<Table> {
        RangeKeys::table()
    }

    fn read(entry: &Entry) -> Result<Self> {
        Ok(match (entry.item.as_bool(), entry.item.as_str()) {
            (Some(false), _) => RangeKey::None,
            (Some(true), _) => RangeKey::All(RangeKeys { effort: None }),
            (None, Some("main")) => RangeKey::Main,
            (None, _) => RangeKey::All(RangeKeys::read(entry)?),
        })
    }
}

impl GrazingTask {
    /// Whether touches are asked for that a linear motion without impacts has at all.
    pub(crate) fn is_of_free_motion(&self) -> bool {
        self.orbit.pattern.is_empty() && self.reach.is_none()
    }

    /// Between which values they are.
    pub(crate) fn within(&self) -> Option<[f64; 2]> {
        <[f64; 2]>::try_from(&self.within[..]).ok()
    }

    /// How far to look along the branch of an oscillator from an orbit.
    pub(crate) fn extent(&self, oscillator: &Oscillator, orbit: &Orbit) -> SearchReach {
        extent(self.reach, oscillator, orbit)
    }

    /// The distance |eµ| where motions have this size.
    pub(crate) fn distance_at(&self, size: f64) -> f64 {
        self.distance.unwrap_or(1e-6 * size)
    }
}
