//! Where motions end: the stroboscopic section, attractors and their basins, Lyapunov exponents, diagrams,
//! crises.
//!
//! [`detection`] tells periodic attractors by recurrence, confirmed by Newton's method; [`attracting`] reads
//! the impact pattern of one;
//! [`basins`], [`diagram`] and [`map`] do it for many starts and for values of one or two parameters;
//! [`crisis`] finds where an attractor meets the stable manifold of a saddle. All is numerical evidence. Not
//! here: following orbits whether they attract or not (`branch`).
//!
//! ```
//! use grazing::oscillator::{Time, attractor::detection::{Detection, Fate}};
//! use grazing::oscillator::simulate::{Settings, Simulator};
//! use grazing::scene::Scene;
//! // At µ = −0.05 a motion of the paper's oscillator settles on the orbit of period 4.
//! let scene = Scene::read("examples/scenes/nordmark-2001.toml")?;
//! let simulator = Simulator::new(&scene.exact(&[])?.rounded(), &Settings::default())?;
//! let mut run = simulator.start(Time::new(0, 0.0), 0.5, 0.0)?;
//! let fate = Detection { transient: 300, longest: 8, ..Detection::default() }.detect(&simulator, &mut run)?;
//! assert!(matches!(fate, Fate::Periodic(cycle) if cycle.period() == 4 || cycle.period() == 1));
//! # Ok::<(), grazing::Error>(())
//! ```

mod attracting;
pub mod basins;
mod checkpoint;
mod confirm;
pub mod crisis;
pub mod detection;
pub mod diagram;
pub mod dynamics;
pub mod lyapunov;
pub mod manifold;
pub mod map;
pub mod observe;
mod one_degree;
pub mod section;
mod together;
mod touching;

pub use attracting::attracting;
pub use checkpoint::Keep;
pub use touching::touching;
