//! Grazing bifurcations of the true system: where they are, the local map there, and the orbits born at them.
//!
//! A periodic orbit, with impacts or without, grazes where a further minimum of a gap is zero: [`locate`].
//! Its [`LocalMap`](crate::continuation::LocalMap) has A, B, C, e, γ and a_G of sections 2 and 3.1 of the
//! paper, and [`Grazing::start`] turns the leading-order solution of a pattern into a start for Newton's
//! method on the true system. Not here: which patterns exist (`pattern`), following a branch further.
//!
//! ```
//! use grazing_scenes::one::grazing::locate;
//! use grazing_scenes::search::touch::InTheory;
//! use grazing_scenes::one::orbit::{Family, Itinerary, find};
//! use grazing_scenes::scene::{Scene, SceneFamily};
//! // The motion at rest grazes the paper's moving stop at µ = 0, with eigenvalues in region 3.
//! # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))?;
//! let scene = Scene::read("examples/scenes/nordmark-2001.toml")?;
//! let family = SceneFamily::new(&scene, "mu")?;
//! let rest = find(&family.at(-0.05)?, &Itinerary::free(1)?, vec![0.0, 0.0])?;
//! let grazing = locate(&family, &rest, -0.05)?;
//! assert!(grazing.parameter.abs() < 1e-12 && grazing.admissible);
//! assert_eq!(grazing.map.region(), Some(grazing_scenes::local::Region::Three));
//! # Ok::<(), grazing_scenes::Error>(())
//! ```

mod half;
mod local_map;
mod locate;
mod start;

pub(crate) use half::is_mirrored;
pub(crate) use locate::local_map_of;
pub use locate::{Grazing, locate};
