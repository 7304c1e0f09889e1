//! Grazing bifurcations of the motion without impacts: where it touches a stop as a parameter varies, and the
//! local map there.
//!
//! The motion is known in closed form (`LinearEquations::response`), and
//! so is its gap to each stop, a trigonometric sum. Of a linear machine [`touches`] finds where the least gap
//! is zero; of others [`locate`] follows it from one value of the parameter both ways. The map there is the
//! paper's, with the state x = (q, q′) less that of the motion, at the phase t_G of grazing, 2n numbers:
//!
//! - A = the flow over one period, (2);
//! - C = (w, 0): the gap is C x + eµ to first order, (5), (26);
//! - B = √(2a_G) (1 + τ) (0, M⁻¹wᵀ/(w M⁻¹wᵀ)): an impact of incoming speed V changes the velocities by (1 +
//!   τ) V M⁻¹wᵀ/(w M⁻¹wᵀ), Newton's law for one stop (`contact`), and V = √(2a_G) y, (44);
//!   with one degree of freedom B = (0, √(2a_G)(1 + τ));
//! - e = the rate of the least gap with the parameter, (26).
//!
//! Not here: which patterns exist (`pattern`), motions with impacts (`orbit`).

pub(in crate::many) mod free;
mod half;
mod linear;
mod local_map;
mod locate;
mod smooth;

pub use free::{FreeMotion, LeastGap};
pub use half::HalfPeriod;
pub use linear::{LinearTouch, LinearTouches, Unseen, touches};
pub use locate::own_reach;
pub use locate::{Further, Grazing, Search, locate};
