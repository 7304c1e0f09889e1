//! Branches of periodic orbits over a parameter: continuation, events, switching, events in two parameters.
//!
//! `curve` follows any curve, [`PatternCurve`] is the one of orbits with an impact pattern, [`OrbitBranch`]
//! what was found along it; `problem` is what they ask of orbits, whichever engine has them. `newton`
//! solves pattern equations, [`Multipliers`] and [`Derivatives`] are those of plane maps. Not here: the
//! orbits themselves (`one`, `many`), attractors (`attractor`).
//!
//! ```
//! use grazing_scenes::continuation::{Bifurcation, BranchSearch, Options};
//! use grazing_scenes::motion::Side;
//! use grazing_scenes::one::branch::locate;
//! use grazing_scenes::one::orbit::{Family, Itinerary, search};
//! use grazing_scenes::scene::{Scene, SceneFamily};
//! // Section 4.2 of the paper: period 3 flips at µ = 0.005479.
//! # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))?;
//! let scene = Scene::read("examples/scenes/nordmark-2001.toml")?;
//! let family = SceneFamily::new(&scene, "mu")?;
//! let orbits = search(&family.at(0.003)?, &Itinerary::at(Side::Lower, &[3])?, 100, 1.0);
//! let orbit = orbits.iter().find(|orbit| orbit.admissibility.is_admissible()).unwrap();
//! let found = locate(&family, Bifurcation::Flip, orbit, 0.003, 0.5, &Options::default())?;
//! let BranchSearch::Found(flip) = found else { panic!("there is a flip") };
//! assert!((flip.parameter - 0.005479).abs() < 5e-7);
//! # Ok::<(), grazing_scenes::Error>(())
//! ```

mod between;
mod bifurcation;
mod branch;
mod criticality;
mod crossing;
mod cubic;
mod curve;
mod derivatives;
mod extent;
mod follow;
mod itinerary;
mod level;
mod local_map;
mod locate;
mod multipliers;
mod newton;
mod options;
mod orbits;
mod periods;
mod plane;
mod problem;
mod record;
mod search;
mod starts;

pub use bifurcation::{Bifurcation, Degeneracy, Singularity};
pub use branch::{BranchPoint, Direction, OrbitBranch, OrbitCurve};
pub use criticality::{CODIMENSION_TWO, Estimate, NOT_SMOOTH, NoForm, UNKNOWN};
pub use criticality::{DOUBLE, NormalForm, Sense};
pub use cubic::Cubic;
pub(crate) use cubic::polynomial;
pub use curve::{Corrector, Curve, CurvePoint, Equations};
pub use derivatives::{Criticality, Derivatives};
pub use extent::extents;
pub use follow::{CurveEnd, Followed, Step, follow};
pub use itinerary::{Itinerary, Strike};
pub use level::Level;
pub use local_map::{Known, LeadingImpact, LocalMap, Near};
pub(crate) use local_map::{TWICE, pattern_of};
pub use locate::nearest;
pub use locate::{BranchSearch, Located, Nothing, SearchReach};
pub use multipliers::Multipliers;
pub use newton::{Linearised, Root};
pub(crate) use newton::{newton, project};
pub use options::Options;
pub use orbits::PatternCurve;
pub use periods::{counted, natural};
pub use plane::EventCurve;
pub use problem::PatternOf;
pub(crate) use problem::STILL;
pub use problem::{FollowedOrbit, PatternFamily, PatternPlane};
pub use record::read_label_as;
pub use record::{Label, RecordForm, record_as};
pub(crate) use search::Known as KnownOrbits;
pub use search::{NEAR, OrbitSearch, SearchTally, search_all};
pub use starts::Starts;
