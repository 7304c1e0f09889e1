//! Branches of periodic orbits over a parameter: continuation, events, switching, events in two parameters.
//!
//! `curve` follows any curve, [`PatternCurve`] is the one of orbits with an impact pattern, [`OrbitBranch`]
//! what was found along it; what they ask of the orbits, of oscillators and of machines alike, is in
//! `problem`. Not here: attractors (`attractor`).
//!
//! ```
//! use grazing::oscillator::branch::{Bifurcation, BranchSearch, Options, locate};
//! use grazing::oscillator::{Side, orbit::{Family, Itinerary, search}};
//! use grazing::scene::{Scene, SceneFamily};
//! // Section 4.2 of the paper: period 3 flips at µ = 0.005479.
//! let scene = Scene::read("examples/scenes/nordmark-2001.toml")?;
//! let family = SceneFamily::new(&scene, "mu")?;
//! let orbits = search(&family.at(0.003)?, &Itinerary::at(Side::Lower, &[3])?, 100, 1.0);
//! let orbit = orbits.iter().find(|orbit| orbit.admissibility.is_admissible()).unwrap();
//! let found = locate(&family, Bifurcation::Flip, orbit, 0.003, 0.5, &Options::default())?;
//! let BranchSearch::Found(flip) = found else { panic!("there is a flip") };
//! assert!((flip.parameter - 0.005479).abs() < 5e-7);
//! # Ok::<(), grazing::Error>(())
//! ```

mod between;
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
pub use criticality::{CODIMENSION_TWO, DOUBLE, Estimate, NOT_SMOOTH, NoForm, NormalForm, Sense, UNKNOWN};
pub use curve::{Corrector, Curve, CurvePoint, Equations};
pub use follow::{CurveEnd, Followed, Settled, Step, follow, follow_until};
pub use locate::{BranchSearch, Located, Nothing, OneWay, SearchReach, locate, nearest};
pub use one_degree::{OscillatorPatterns, OscillatorPlane, TwoParameterFamily};
pub use options::Options;
pub(crate) use options::with_options;
pub use orbits::{Orbits, PatternCurve};
pub use plane::{EventCurve, Events};
pub(crate) use problem::halved;
pub use problem::{FollowedOrbit, ImpactPattern, PatternFamily, PatternOf, PatternPlane};
pub use record::{Label, RecordForm, read_label, read_label_as, record, record_as};
