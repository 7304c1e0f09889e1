//! Where motions end: the stroboscopic section, attractors and their basins, Lyapunov exponents, diagrams,
//! crises.
//!
//! [`detection`] tells periodic attractors by recurrence; [`attracting`] turns one into an exact orbit;
//! [`basins`] and [`diagram`] do it for many starts and many parameter values; [`crisis`] finds where an
//! attractor meets the stable manifold of a saddle. All is numerical evidence. Not here: following orbits
//! whether they attract or not (`branch`).

mod attracting;
pub mod basins;
mod checkpoint;
pub mod crisis;
pub mod detection;
pub mod diagram;
pub mod dynamics;
pub mod lyapunov;
pub mod manifold;
pub mod section;
mod touching;

pub use attracting::attracting;
pub use touching::touching;
