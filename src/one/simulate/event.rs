//! What a run reports.

use crate::motion::{RunEnd, Side, Time};

/// The next thing that happens.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Event {
    /// The oscillator met a wall and bounced.
    Impact(Impact),
    /// It came within the minimum depth of a wall, neither clearly short of it nor clearly beyond: no impact
    /// was made of it.
    Tangency(Tangency),
    /// It came to rest on a wall that presses.
    Stick(Stick),
    /// A wall let go of it.
    Release(Release),
    /// Nothing more before the time asked for, or nothing more at all.
    End(RunEnd),
}

/// One impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impact {
    /// When, of the trajectory computed.
    pub time: Time,
    /// The root of the gap lies within this of `time`, for the trajectory computed: rounding over impact
    /// velocity.
    pub radius: f64,
    /// Which wall.
    pub side: Side,
    /// The gap's z′ ≤ 0 on arrival; it leaves as −τ z′.
    pub velocity: f64,
}

/// A minimum of the gap within the minimum depth of 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tangency {
    /// When.
    pub time: Time,
    /// Which wall.
    pub side: Side,
    /// The gap there, of either sign.
    pub gap: f64,
}

/// The start of rest on a wall: bounces have become lower than the minimum depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stick {
    /// When: for τ < 1 the limit of the impacts that would have followed, a geometric series.
    pub time: Time,
    /// Which wall.
    pub side: Side,
    /// The time that the impacts left out would have taken.
    pub rest: f64,
}

/// The end of rest on a wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Release {
    /// When the force of contact falls to 0.
    pub time: Time,
    /// Which wall.
    pub side: Side,
}

impl Event {
    /// When it happened; an end has the time that the run has.
    pub fn time(&self) -> Option<Time> {
        match self {
            Event::Impact(impact) => Some(impact.time),
            Event::Tangency(tangency) => Some(tangency.time),
            Event::Stick(stick) => Some(stick.time),
            Event::Release(release) => Some(release.time),
            Event::End(_) => None,
        }
    }

    /// At which wall.
    pub fn side(&self) -> Option<Side> {
        match self {
            Event::Impact(impact) => Some(impact.side),
            Event::Tangency(tangency) => Some(tangency.side),
            Event::Stick(stick) => Some(stick.side),
            Event::Release(release) => Some(release.side),
            Event::End(_) => None,
        }
    }
}
