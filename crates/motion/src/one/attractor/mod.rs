//! Where motions of oscillators of one degree of freedom end: as `attractor` asks for it, and what is asked
//! of them alone (manifolds, crises, maps over two parameters).

mod attracting;
pub mod crisis;
mod dynamics;
mod lyapunov;
pub mod manifold;
pub mod map;
mod observe;
mod together;
pub mod touching;

pub use attracting::attracting;
pub use lyapunov::lyapunov;
pub use touching::touching;
