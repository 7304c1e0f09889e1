//! Proofs about periodic orbits of machines with few coordinates.
//!
//! An orbit found in floats is made precise by Newton's method in balls, and everything that a certificate of
//! kind `machine-orbit` needs is looked for: the box, the preconditioner, the pieces of time. None of that is
//! a proof. What is called proved is what the checker of certificates has proved from the certificate's text,
//! with code and formulas of its own: here time is in the state (`linear`), there the response to the forcing
//! is subtracted. The motion without impacts has its own certificate (`free`). Up to 8 coordinates, 16 stops.

mod free;
mod linear;
mod motion;
mod orbit;
mod pieces;
mod write;

pub use free::{ProvedFreeMachine, free_motion};
pub use orbit::{ProvedMachineOrbit, orbit};
pub use write::listed;

use num_rational::BigRational;

/// A coefficient that is known to lie between two numbers, equal if it is known exactly.
pub type Bounds = [BigRational; 2];
