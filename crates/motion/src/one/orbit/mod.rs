//! Periodic orbits of the true system for any impact pattern, with what proves them orbits or not.
//!
//! [`Itinerary`] is the impact pattern with its walls, [`linearise`] the equations (19) with all derivatives,
//! [`find`] Newton's method on them, its answer an [`Orbit`] with its multipliers and [`Admissibility`].
//! [`SingleImpact`] has the exact orbits of a linear oscillator, a second route. [`return_map`] expands the
//! Poincaré map. Not here: where orbits bifurcate (`grazing`, `branch`), the normal forms' coefficients
//! (`continuation`).
//!
//! ```
//! use grazing_scenes::motion::Side;
//! use grazing_scenes::one::orbit::{Itinerary, Oscillator, search};
//! use grazing_scenes::scene::Scene;
//! // The paper's oscillator at µ = −0.05 has a stable orbit with one impact every four periods.
//! # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))?;
//! let scene = Scene::read("examples/scenes/nordmark-2001.toml")?;
//! let oscillator = Oscillator::new(scene.exact(&[])?.rounded(), 1e-12)?;
//! let orbits = search(&oscillator, &Itinerary::at(Side::Lower, &[4])?, 100, 1.0);
//! let stable = orbits.iter().find(|orbit| orbit.multipliers.is_stable()).unwrap();
//! assert!(stable.admissibility.is_admissible() && stable.residual < 1e-12);
//! # Ok::<(), grazing_scenes::Error>(())
//! ```

mod admissible;
mod determinant;
mod equations;
mod family;
mod gap;
mod leg;
mod oscillator;
mod passage;
mod return_map;
mod search;
mod single;
mod solution;

use crate::motion::Side;
pub(super) use admissible::minima;
pub use admissible::{Admissibility, Minimum};
pub(crate) use admissible::{Check, check};
pub(crate) use determinant::flow_determinant;
pub use equations::linearise;
pub use family::Family;
pub use leg::Leg;
pub(crate) use leg::Touch;
pub use oscillator::Oscillator;
pub use passage::Unknowns;
pub use return_map::return_map;
pub use search::{search, search_obstacle, search_while};
pub use single::SingleImpact;
pub use solution::{Orbit, OrbitImpact, describe, find, monodromy};

/// The pattern of an orbit with the wall of each impact.
pub type Itinerary = crate::continuation::Itinerary<Side>;

/// An impact of a pattern, at a wall.
pub type Strike = crate::continuation::Strike<Side>;
