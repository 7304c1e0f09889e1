//! What a run of a machine reports.

use crate::motion::{RunEnd, Time};

/// The next thing that happens.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum MachineEvent {
    /// The machine met a stop and bounced. Of several at one instant each is told.
    Impact(StopImpact),
    /// A gap came within the minimum depth of 0, neither clearly short of it nor clearly beyond: no impact
    /// was made of it.
    Tangency(StopTangency),
    /// Contact with a soft stop began.
    Touch(StopTouch),
    /// It came to rest on a stop that presses.
    Stick(StopStick),
    /// A stop let go of it: rest on it ended, or the contact with a soft one.
    Release(StopRelease),
    /// Nothing more before the time asked for, or nothing more at all.
    End(RunEnd),
}

/// One impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StopImpact {
    /// When, of the trajectory computed.
    pub time: Time,
    /// The root of the gap lies within this of `time`, for the trajectory computed: rounding over impact
    /// velocity.
    pub radius: f64,
    /// Which stop, by its place in the machine.
    pub stop: usize,
    /// The gap's z′ ≤ 0 on arrival, per radian of the forcing.
    pub velocity: f64,
    /// The impulse, in mass times velocity per radian: with one stop −(1 + τ) z′ times the mass felt there.
    pub impulse: f64,
    /// How many stops took part: those touched, at rest or not.
    pub together: usize,
    /// Whether impacts one after the other would have ended with other velocities: the outcome is a choice.
    pub order_matters: bool,
}

/// The beginning of contact with a soft stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StopTouch {
    /// When, of the trajectory computed.
    pub time: Time,
    /// As of an impact: the root of the gap lies within this of `time`.
    pub radius: f64,
    /// Which stop, by its place in the machine.
    pub stop: usize,
    /// The gap's z′ there, per radian of the forcing: negative, but where the motion was about to leave a
    /// stop with damping, which let go of it before.
    pub velocity: f64,
    /// The force with which contact begins as the gap closes, in the scene's unit: damping times velocity; 0
    /// where it begins otherwise.
    pub jump: f64,
}

/// A minimum of the gap within the minimum depth of 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StopTangency {
    /// When.
    pub time: Time,
    /// Which stop.
    pub stop: usize,
    /// The gap there, of either sign.
    pub gap: f64,
}

/// The start of rest on a stop: bounces have become lower than the minimum depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StopStick {
    /// When: for τ < 1 the limit of the impacts that would have followed, a geometric series.
    pub time: Time,
    /// Which stop.
    pub stop: usize,
    /// The time that the impacts left out would have taken, in radians of the forcing.
    pub rest: f64,
}

/// The end of rest on a stop, or of contact with a soft one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StopRelease {
    /// When the force of contact falls to 0, or an impact elsewhere throws it off.
    pub time: Time,
    /// Which stop.
    pub stop: usize,
}

impl MachineEvent {
    /// When it happened; an end has the time that the run has.
    pub fn time(&self) -> Option<Time> {
        match self {
            MachineEvent::Impact(impact) => Some(impact.time),
            MachineEvent::Touch(touch) => Some(touch.time),
            MachineEvent::Tangency(tangency) => Some(tangency.time),
            MachineEvent::Stick(stick) => Some(stick.time),
            MachineEvent::Release(release) => Some(release.time),
            MachineEvent::End(_) => None,
        }
    }

    /// At which stop.
    pub fn stop(&self) -> Option<usize> {
        match self {
            MachineEvent::Impact(impact) => Some(impact.stop),
            MachineEvent::Touch(touch) => Some(touch.stop),
            MachineEvent::Tangency(tangency) => Some(tangency.stop),
            MachineEvent::Stick(stick) => Some(stick.stop),
            MachineEvent::Release(release) => Some(release.stop),
            MachineEvent::End(_) => None,
        }
    }
}
