//! A motion's time series as it is kept, whichever engine follows it: what it is of, its points, its events.
//! Everything is in the scene's units. Not here: how a motion is followed (`follow`).

use crate::motion::Time;

/// What a series is of.
#[derive(Debug, Clone, PartialEq)]
pub struct SeriesOf {
    /// How many displacements a point has.
    pub points: usize,
    /// The stops, in the scene's order.
    pub stops: Vec<SeriesStop>,
    /// The names of its dry friction, in the scene's order.
    pub friction: Vec<String>,
    /// The kinks and jumps of its forces, as they are written.
    pub kinks: Vec<String>,
    /// The names of its events, in the scene's order.
    pub events: Vec<String>,
    /// The forcing period, in the scene's unit of time.
    pub period: f64,
    /// When it begins, after the transient, in periods.
    pub begin: f64,
    /// For how many periods it is asked for, whole ones or not.
    pub span: f64,
}

impl SeriesOf {
    /// The names of all places where something happens, as [`StopEvent::stop`] counts them.
    pub fn places(&self) -> Vec<String> {
        let stops = self.stops.iter().map(|stop| &stop.name);
        stops.chain(&self.friction).chain(&self.kinks).chain(&self.events).cloned().collect()
    }
}

/// A stop of a series.
#[derive(Debug, Clone, PartialEq)]
pub struct SeriesStop {
    /// Its name.
    pub name: String,
    /// Of a motion with one displacement q, by how much the gap opens with q: the stop stands at q − gap /
    /// `along`.
    pub along: Option<f64>,
}

/// A point of a series.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeriesPoint<'a> {
    /// When.
    pub time: Time,
    /// The displacements.
    pub q: &'a [f64],
    /// The velocities.
    pub u: &'a [f64],
    /// The gap to each stop, and its rate.
    pub gaps: &'a [[f64; 2]],
}

/// What happened at a stop, or where there is dry friction.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct StopEvent {
    /// "impact", "tangency", "touch", "stick" or "release"; with friction "stick", "release" or "reversal";
    /// of a force with kinks "kink"; of an event "upcrossing" or "downcrossing".
    pub event: &'static str,
    /// When.
    pub time: Time,
    /// The stop, by its place; friction comes after all stops, then kinks of forces, then events.
    pub stop: usize,
    /// The gap's rate on arrival, of an impact or a touch.
    pub velocity: Option<f64>,
    /// That with which it leaves, where the impact was one at one stop.
    pub leaving: Option<f64>,
    /// The impulse of an impact, or of the contact that a release ends.
    pub impulse: Option<f64>,
    /// The root of the gap lies within this of the time, for the trajectory computed; in radians over the
    /// forcing's frequency.
    pub radius: Option<f64>,
    /// The gap at a tangency.
    pub gap: Option<f64>,
    /// The time that the impacts left out before a rest would have taken.
    pub rest: Option<f64>,
    /// How many stops took part in an impact.
    pub together: Option<usize>,
    /// Whether impacts one by one would have ended otherwise.
    pub order_matters: Option<bool>,
    /// Of the contact that a release ends, how long it pushed.
    pub duration: Option<f64>,
    /// Of that contact the largest force found.
    pub force: Option<f64>,
    /// The energy that an impact or that contact takes.
    pub energy: Option<f64>,
    /// Of a motion with one displacement, where the stop stands, and how fast it moves.
    pub place: Option<[f64; 2]>,
}

impl StopEvent {
    /// Nothing but what happened, when and where.
    pub(super) fn new(event: &'static str, time: Time, stop: usize) -> StopEvent {
        StopEvent { event, time, stop, ..StopEvent::default() }
    }
}
