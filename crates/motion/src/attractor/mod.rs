//! Where motions end: the stroboscopic section, attractors and their basins, Lyapunov exponents, diagrams.
//!
//! From the bottom up: [`dynamics`] is what the chapter asks of an engine, [`section`] a motion looked at
//! once a period, [`cycle`] a periodic attractor; [`detection`] tells them by recurrence, confirmed by
//! Newton's method, [`observe`] for many motions; [`basins`] and [`diagram`] for many starts and for values
//! of a parameter. All is numerical evidence. Not here: the motions (`one`, `many`); following orbits whether
//! they attract or not (`continuation`). [`limit_cycle`] is for what nothing drives.
//!
//! ```
//! use grazing_scenes::attractor::detection::{Detection, Fate};
//! use grazing_scenes::motion::Time;
//! use grazing_scenes::one::simulate::{Settings, Simulator};
//! use grazing_scenes::scene::Scene;
//! // At µ = −0.05 a motion of the paper's oscillator settles on the orbit of period 4.
//! # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))?;
//! let scene = Scene::read("examples/scenes/nordmark-2001.toml")?;
//! let simulator = Simulator::new(&scene.exact(&[])?.rounded(), &Settings::default())?;
//! let mut run = simulator.start(Time::new(0, 0.0), 0.5, 0.0)?;
//! let detection = Detection { transient: 300, longest: 8, ..Detection::default() };
//! let fate = detection.detect(&simulator, &mut run, &())?;
//! assert!(matches!(fate, Fate::Periodic(cycle) if cycle.period() == 4 || cycle.period() == 1));
//! # Ok::<(), grazing_scenes::Error>(())
//! ```

pub mod basins;
pub(crate) mod checkpoint;
mod confirm;
pub mod cycle;
pub mod detection;
pub mod diagram;
pub mod dynamics;
pub mod hitting;
pub mod limit_cycle;
pub mod lyapunov;
pub mod observe;
pub mod portrait;
pub mod rest;
pub mod section;
pub mod swing;
pub mod touch;
mod wander;

pub use checkpoint::Keep;
pub use confirm::{FixedPoint, NEUTRAL, fixed_point};
