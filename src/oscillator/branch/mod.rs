//! Branches of periodic orbits over a parameter: continuation, events, switching, events in two parameters.
//!
//! `curve` follows any curve, [`Orbits`] is the one of orbits with an impact pattern, [`Branch`] what was found along it.
//! Not here: attractors (`attractor`).

#[expect(clippy::module_inception)]
mod branch;
pub mod critical;
mod curve;
mod follow;
mod options;
mod orbits;
mod plane;
mod record;

pub use branch::{Branch, Direction, OrbitCurve, Point};
pub use curve::{Corrector, Curve, Equations, Foot};
pub use follow::{End, Followed, Step, follow};
pub use options::Options;
pub(crate) use options::with_options;
pub use orbits::{Event, Orbits};
pub use plane::{Events, Plane};
pub use record::{Label, read_label, record};
