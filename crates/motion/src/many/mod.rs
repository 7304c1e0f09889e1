//! Machines: mechanical systems with any number of degrees of freedom and any number of stops, rigid or not.
//!
//! A [`Machine`] is M q″ + C q′ + K q = f₀ + Σ f_k(t) + g(t, q, q′) with stops w·q ≥ offset(t), rigid or
//! giving way ([`StopLaw`]), in the units of its scene; g is any smooth function, and most machines have
//! none. It is the engine for any number of coordinates, as `one` is that for one degree of freedom and two
//! walls: neither imports from the other, and what they share stands below both (`motion`, `continuation`,
//! `attractor`).
//!
//! # Design
//!
//! - **Time.** Inside, time is the forcing's phase: T/2π is the unit of time ([`Machine::equations`]), so
//!   that velocities are per radian. Who reports multiplies by [`Machine::rate`].
//! - **One idea.** Between events a machine is a linear system with periodic force, and so is a machine that
//!   rests on some of its stops, with fewer degrees of freedom, and one that soft stops push:
//!   [`LinearEquations`] each time. Everything
//!   that is watched for (a gap, the force of a stop that something rests on) is a linear functional of the
//!   state plus a known function of time (`contact::Watch`).
//! - **LinearFlow.** [`LinearFlow`] solves [`LinearEquations`] in closed form: y = T(q, q′) − p(t) is
//!   homogeneous and falls apart into pairs of coordinates, by real modes where damping is classical, else by
//!   complex modes; where their eigenvectors are too nearly dependent, it is one block with its matrix
//!   exponential. [`LinearFlow::method`] and [`LinearFlow::condition`] say which and why.
//! - **Formulas.** A machine on which forces are formulas moves by Taylor series of all coordinates at once
//!   (`smooth`), and no table of it is made; [`LinearFlow`] then is that of the machine linearised at rest.
//! - **Impacts.** Newton's law for all stops that are hit at one instant, as a complementarity problem in the
//!   mass metric (`contact`).
//! - **Simulation.** [`simulate`] promises what that of `one` does, with the same minimum test; far
//!   from all stops it passes over long stretches at once.
//! - **Analysis.** The motion without impacts, where it grazes a stop as a parameter varies, and the local
//!   map there ([`grazing`]); periodic orbits with impacts ([`orbit`]), their branches and bifurcations by
//!   `continuation` ([`branch`]), and which way those go
//!   ([`normal_form`](mod@normal_form)). Derivatives come from the flow, the saltation at impacts and
//!   [`Slope`]: nothing is differenced.
//!
//! - **Drifts.** Where nothing holds a machine along a direction, orbits and attractors are what they are up
//!   to a drift along it (`drift`).
//! - **Elements.** [`elements`] takes a machine apart into masses, springs and dampers, to be drawn.
//! - **Attractors.** [`section`] is the machine as sections, basins, diagrams and Lyapunov exponents of
//!   `attractor` follow it: there is one notion of an attractor.
//!
//! Linear algebra is by `nalgebra`, 18 packages; `faer` would bring 57 and the eigenvectors of general
//! matrices, which are thirty lines here. Not here: what is to be done, as a file (`scene`); tables and
//! pictures.
//!
//! ```
//! use grazing_scenes::many::grazing::{Search, locate};
//! use grazing_scenes::scene::{MachineSceneFamily, Scene};
//! // At which force, from 1 N on, do the two masses first touch?
//! # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))?;
//! let scene = Scene::read("examples/machines/two-masses.toml")?;
//! let family = MachineSceneFamily::new(&scene, "F0")?;
//! let Search::Found(touch) = locate(&family, 1.0, 20.0, None, None)? else { panic!() };
//! assert!(touch.parameter > 1.0 && touch.at.gap.abs() <= 1e-11 * touch.scale);
//! # Ok::<(), grazing_scenes::Error>(())
//! ```

mod algebra;
pub mod attracting;
mod backbone;
mod brace;
pub mod branch;
pub mod contact;
mod critical;
mod deflected;
mod drift;
pub mod elements;
pub mod equations;
pub mod families;
pub mod flow;
mod friction;
pub mod grazing;
mod lean;
pub mod measure;
mod model;
mod modes;
pub mod normal_form;
pub mod orbit;
mod pair;
pub mod peaks;
pub mod push;
pub mod resonance;
mod response;
pub mod resting;
pub mod section;
pub mod simulate;
mod sliding;
pub mod slope;
mod smooth;
mod speed;
mod stribeck;
mod thresholds;

pub(crate) use equations::{LinearEquations, Periodic};
pub use flow::FlowMethod;
pub(crate) use flow::LinearFlow;
pub use friction::{Friction, NormalForce};
pub use friction::{Grip, Rub};
pub(crate) use lean::Blow;
pub use model::{Load, Machine, Stop, StopLaw};
pub use slope::Family;
pub(crate) use slope::Slope;
pub use smooth::Record;
pub use speed::MOST as MOST_POWERS;
pub use speed::SpeedLaw;
#[doc(hidden)]
pub use stribeck::SlidingLaw;
#[doc(hidden)]
pub use thresholds::threshold;

/// Vectors of coordinates, velocities, forces.
pub type RealVector = nalgebra::DVector<f64>;
/// Matrices of any size.
pub type RealMatrix = nalgebra::DMatrix<f64>;

/// A state: displacements q and velocities q′ at phase t in [0, 2π), velocities per radian of the forcing.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// The phase.
    pub t: f64,
    /// Displacements.
    pub q: RealVector,
    /// Velocities.
    pub u: RealVector,
}

impl State {
    /// The state with these displacements and velocities, one for each coordinate.
    pub fn new(t: f64, q: &[f64], u: &[f64]) -> State {
        State { t, q: RealVector::from_column_slice(q), u: RealVector::from_column_slice(u) }
    }

    /// The displacements.
    pub fn q(&self) -> &[f64] {
        self.q.as_slice()
    }

    /// The velocities.
    pub fn u(&self) -> &[f64] {
        self.u.as_slice()
    }
}
