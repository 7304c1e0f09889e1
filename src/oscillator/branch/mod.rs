//! Branches of periodic orbits over a parameter: continuation, events, switching, events in two parameters.
//!
//! `curve` follows any curve, [`Orbits`] is the one of orbits with an impact pattern, [`Branch`] what was
//! found along it. Not here: attractors (`attractor`).

mod bifurcation;
#[expect(clippy::module_inception)]
mod branch;
mod criticality;
mod crossing;
mod curve;
mod follow;
mod locate;
mod options;
mod orbits;
mod plane;
mod record;

pub use bifurcation::{Bifurcation, Degeneracy, Singularity};
pub use branch::{Branch, BranchOrbit, Direction, OrbitCurve};
pub use criticality::{NormalForm, Sense};
pub use curve::{Corrector, Curve, CurvePoint, Equations};
pub use follow::{CurveEnd, Followed, Settled, Step, follow, follow_until};
pub use locate::{BranchSearch, Located, Nothing, OneWay, locate};
pub use options::Options;
pub(crate) use options::with_options;
pub use orbits::Orbits;
pub use plane::{Events, TwoParameterFamily};
pub use record::{Label, read_label, record};
