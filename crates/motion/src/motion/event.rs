//! What happens in a motion with impacts, whichever engine follows it.

use std::fmt::Debug;

use super::{RunEnd, Side, Time};

/// Where something happens: the side of a wall, or the place of a stop in its machine.
pub trait Place: Copy + PartialEq + Debug {
    /// What is known of an impact beside its velocity.
    type Shock: Copy + PartialEq + Debug;

    /// Its number: the lower wall is 0, the upper 1.
    fn number(self) -> usize;

    /// The place of a number that [`number`](Self::number) gives.
    fn numbered(number: usize) -> Self;
}

/// A point mass between two walls meets one at a time.
impl Place for Side {
    type Shock = ();

    fn number(self) -> usize {
        self as usize
    }

    fn numbered(number: usize) -> Side {
        [Side::Lower, Side::Upper][number]
    }
}

impl Place for usize {
    type Shock = Shock;

    fn number(self) -> usize {
        self
    }

    fn numbered(number: usize) -> usize {
        number
    }
}

/// What several stops make of an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shock {
    /// The impulse, in mass times velocity per radian: with one stop −(1 + τ) z′ times the mass felt there.
    pub impulse: f64,
    /// What it takes of the energy at this stop, in mass times velocity per radian squared: −Λ (w⁻ + w⁺)/2.
    pub energy: f64,
    /// How many stops took part: those touched, at rest or not.
    pub together: usize,
    /// Whether impacts one after the other would have ended with other velocities: the outcome is a choice.
    pub order_matters: bool,
}

/// The next thing that happens.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Event<P: Place> {
    /// A rigid stop was met, and the motion bounced. Of several stops at one instant each is told.
    Impact(Impact<P>),
    /// A gap came within the minimum depth of 0, neither clearly short of it nor clearly beyond: no impact
    /// was made of it.
    Tangency(Tangency<P>),
    /// Contact with a compliant stop began.
    Touch(Touch<P>),
    /// The motion came to rest on a stop that presses.
    Stick(Stick<P>),
    /// A stop let go of it: rest on it ended, or the contact with a compliant one; or what stuck slides.
    Release(Release<P>),
    /// What slides turned back without sticking.
    Reversal(Reversal<P>),
    /// A force with a kink or a jump there is on its other side.
    Kink(Kink<P>),
    /// Nothing more before the time asked for, or nothing more at all.
    End(RunEnd),
}

/// One impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impact<P: Place> {
    /// When, of the trajectory computed.
    pub time: Time,
    /// The root of the gap lies within this of `time`, for the trajectory computed: rounding over impact
    /// velocity.
    pub radius: f64,
    /// Which stop.
    pub place: P,
    /// The gap's z′ ≤ 0 on arrival, per radian of the forcing; at one stop alone it leaves as −τ z′.
    pub velocity: f64,
    /// What is known besides.
    pub shock: P::Shock,
}

/// The beginning of contact with a compliant stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch<P> {
    /// When, of the trajectory computed.
    pub time: Time,
    /// As of an impact: the root of the gap lies within this of `time`.
    pub radius: f64,
    /// Which stop.
    pub place: P,
    /// The gap's z′ there, per radian of the forcing: negative, but where the motion was about to leave a
    /// stop with damping, which let go of it before.
    pub velocity: f64,
    /// The force with which contact begins as the gap closes, in the scene's unit: damping times velocity; 0
    /// where it begins otherwise.
    pub jump: f64,
}

/// A minimum of the gap within the minimum depth of 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tangency<P> {
    /// When.
    pub time: Time,
    /// Which stop.
    pub place: P,
    /// The gap there, of either sign.
    pub gap: f64,
}

/// The start of rest on a stop: bounces have become lower than the minimum depth; or of sticking, where there
/// is dry friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stick<P> {
    /// When: for τ < 1 the limit of the impacts that would have followed, a geometric series.
    pub time: Time,
    /// Which stop.
    pub place: P,
    /// The time that the impacts left out would have taken, in radians of the forcing.
    pub rest: f64,
}

/// The end of rest on a stop, or of contact with a compliant one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Release<P> {
    /// When the force of contact falls to 0, or an impact elsewhere throws it off.
    pub time: Time,
    /// Which stop.
    pub place: P,
}

/// A change of the direction in which something slides with dry friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reversal<P> {
    /// When.
    pub time: Time,
    /// At which friction, after all stops.
    pub place: P,
}

/// A change of sides of a force with a kink or a jump.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kink<P> {
    /// When.
    pub time: Time,
    /// At which kink, after all stops and all friction.
    pub place: P,
}

impl<P: Place> Event<P> {
    /// When it happened, and at which stop; an end has the time that the run has.
    pub fn at(&self) -> Option<(Time, P)> {
        match *self {
            Event::Impact(Impact { time, place, .. })
            | Event::Touch(Touch { time, place, .. })
            | Event::Tangency(Tangency { time, place, .. })
            | Event::Stick(Stick { time, place, .. })
            | Event::Release(Release { time, place })
            | Event::Reversal(Reversal { time, place })
            | Event::Kink(Kink { time, place }) => Some((time, place)),
            Event::End(_) => None,
        }
    }

    /// When it happened.
    pub fn time(&self) -> Option<Time> {
        Some(self.at()?.0)
    }

    /// At which stop.
    pub fn place(&self) -> Option<P> {
        Some(self.at()?.1)
    }

    /// The gap's rate on arrival, of an impact or a touch.
    pub(crate) fn velocity(&self) -> Option<f64> {
        match *self {
            Event::Impact(Impact { velocity, .. }) | Event::Touch(Touch { velocity, .. }) => Some(velocity),
            _ => None,
        }
    }

    /// Its word in a report.
    pub fn word(&self) -> &'static str {
        match self {
            Event::Impact(_) => "impact",
            Event::Touch(_) => "touch",
            Event::Tangency(_) => "tangency",
            Event::Stick(_) => "stick",
            Event::Release(_) => "release",
            Event::Reversal(_) => "reversal",
            Event::Kink(_) => "kink",
            Event::End(_) => "end",
        }
    }
}
