//! The keys of the tasks about periodic orbits: `orbit`, `event`, `grazing`.

use num_rational::BigRational;

use std::f64::consts::TAU;

use num_traits::ToPrimitive;

use super::{
    grammar::LIMIT_BITS,
    keys::{Entry, StopName, Table, Value, keys},
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
    /// Which periodic orbit: its impact pattern, and where Newton's method starts.
    pub struct OrbitKeys {
        /// n_1, …, n_m: the forcing periods from the phase of one impact to that of the next; empty for an
        /// orbit without impacts
        pattern: Vec<u32> = "[]",
        /// the name of the stop of each impact; needed only if there are several stops
        stops: Vec<StopName> = "[]",
        /// the period of an orbit without impacts
        period: u32 = "1",
        /// time and incoming speed t_1, V_1, …, t_m, V_m to start from, a time as a fraction of the period,
        /// or in radians of the forcing, as in "0.5 rad"; without impacts all of q, then all of u at t = 0;
        /// if empty, all orbits are searched for
        start: Vec<StartNumber> = "[]",
        /// how many starts the search makes
        starts: u32 = "500",
        /// the greatest speed at which the search starts, in the scene's units; without it the size of the
        /// motion (of what the forces do and of the stops that are struck), where the engine is `many` and no
        /// force is a formula four times the size of the gaps' motion per radian of the forcing
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
    /// Finds periodic orbits, with their impacts and multipliers, and says whether each is admissible
    /// (positive speeds, no other contact).
    pub struct OrbitTask {
        /// which orbit
        orbit: OrbitKeys,
        /// a parameter that takes several values
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
    /// Locates a bifurcation of an orbit in a parameter, to rounding, from the orbit at the parameter's
    /// present value.
    pub struct EventTask {
        /// which bifurcation
        event: Bifurcation,
        /// the parameter that varies
        parameter: String,
        /// the orbit at the parameter's present value
        orbit: OrbitKeys,
        /// how far along its branch to look, both ways, in the norm of times, of speeds in units of the
        /// motion's size and of the parameter; where the engine is `many`, in the parameter; without it 0.5,
        /// the parameter in units of what changes a force or a stop by its own size, where the engine is
        /// `many` half of the parameter's value, or what moves a gap by the size of the gaps' motion, the
        /// larger; and to the grazing of a motion without impacts that is linear, however far it is
        reach: Option<f64>,
        /// how the branch is followed; lengths are as those of `reach`; where the engine is `many` in units
        /// of the gaps' motion, and of what `reach` is if it is not given
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
    /// Locates a grazing bifurcation. The local theory there decides which orbits are born on which side;
    /// each is then found in the true system nearby. One line says whether chaos is born on either side, by
    /// all patterns together, and with which entropy.
    pub struct GrazingTask {
        /// the parameter that varies
        parameter: String,
        /// the orbit that comes to graze, near the parameter's present value, at its least minimum of a gap;
        /// where the engine is `many`, the motion without impacts, of several the one near `start`
        orbit: OrbitKeys = "{}",
        /// how far along its branch to look, both ways, as in a task `event`; without it the touch of a
        /// motion without impacts that is linear is found however far it is; of another motion, where the
        /// engine is `one`, also from where it nears a stop, to first order
        reach: Option<f64>,
        /// two values of the parameter, between which all touches are listed, the nearest being looked at;
        /// of a motion without impacts that is linear
        within: Vec<f64> = "[]",
        /// how the branch is followed; lengths are as those of `reach`; not where the engine is `many`
        options: Options = "{}",
        /// the largest period of the patterns, in periods of that orbit
        max_period: u32 = "4",
        /// how far from the bifurcation the born orbits are found: the distance |eµ| between the orbit and
        /// the stop; without it 1e-6 of the size of the motion, where the engine is `many` of the gaps'
        /// motion
        distance: Option<f64>,
        /// whether to follow motions beside the touch, to see whether they stay near or jump, and where they
        /// come back; without it, only where no force is a formula and no stop gives way
        seen: Option<bool>,
        /// whether to prove of each periodic attractor that is seen there that it is a stable orbit, with a
        /// certificate for each, as a task `validate` does
        prove: bool = "false",
        /// whether to prove, for either side of the touch, how far what is born there goes on: "main" does it
        /// of all that is born together, with a tenth of the work, of machines with linear forces and without
        /// `tolerance` and `attractor`, where the motion without impacts touches; `true` also of each orbit
        /// of one impact, of a part that goes farther, and of what else there is
        range: RangeKey = "\"main\"",
        /// whether to prove, of an overdamped machine beside one stop, that beyond the touch chaos attracts:
        /// how far from it there is a trap in which no periodic motion is stable, and where that does not
        /// reach the parameter's present value, whether it is so there; of machines with linear forces, and
        /// where the motion without impacts touches
        attractor: bool = "false",
        /// whether to find the touch again with each other parameter of the scene a little larger and
        /// smaller, to say by how much it moves for one per cent more
        sensitivity: bool = "false",
        /// how exactly parameters are known, as in `{ k = "2%", d = 0.01, m = [0.9, 1.1] }`: a part of the
        /// value, up to a number, or the least and greatest value (of the task's own parameter about its
        /// value at the touch); what is born, with `range` how far it goes on, and what `attractor` proves,
        /// is then told of all machines that this allows
        tolerance: Tolerances = "{}",
    }
}

keys! {
    /// How far a range is followed.
    pub struct RangeKeys {
        /// work allowed on each side of the touch for all that is proved there, in units of some 30 µs: three
        /// legs of the search or steps of the checker; without it 100000
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
