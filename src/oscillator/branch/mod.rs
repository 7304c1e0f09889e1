//! Branches of periodic orbits over a parameter: continuation, events, switching, events in two parameters.
//!
//! `curve` follows any curve, [`PatternCurve`] is the one of orbits with an impact pattern, [`OrbitBranch`]
//! what was found along it; what they ask of the orbits, of oscillators and of machines alike, is in
//! `problem`. Not here: attractors (`attractor`).

mod bifurcation;
#[expect(clippy::module_inception)]
mod branch;
mod criticality;
mod crossing;
mod curve;
mod follow;
mod locate;
mod one_degree;
mod options;
mod orbits;
mod plane;
mod problem;
mod record;

pub use bifurcation::{Bifurcation, Degeneracy, Singularity};
pub use branch::{Branch, BranchOrbit, BranchPoint, Direction, OrbitBranch, OrbitCurve};
pub use criticality::{NormalForm, Sense};
pub use curve::{Corrector, Curve, CurvePoint, Equations};
pub use follow::{CurveEnd, Followed, Settled, Step, follow, follow_until};
pub use locate::{BranchSearch, Located, Nothing, OneWay, locate, nearest};
pub use one_degree::TwoParameterFamily;
pub use options::Options;
pub(crate) use options::with_options;
pub use orbits::{Orbits, PatternCurve};
pub use plane::{EventCurve, Events};
pub use problem::{FollowedOrbit, ImpactPattern, PatternFamily, PatternOf, PatternPlane};
pub use record::{Label, RecordForm, read_label, read_label_as, record, record_as};
