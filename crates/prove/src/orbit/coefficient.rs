//! Coefficients of a system that is proved of: exact numbers, or all between two.

use std::convert::Infallible;

use num_rational::BigRational;

use crate::{machine::Bounds, motion::System};

/// A number between two exact ones, which may be one.
pub trait Bounded: Clone {
    /// The two, in order.
    fn bounds(&self) -> Bounds;
}

impl Bounded for BigRational {
    fn bounds(&self) -> Bounds {
        [self.clone(), self.clone()]
    }
}

impl Bounded for Bounds {
    fn bounds(&self) -> Bounds {
        self.clone()
    }
}

/// A system with two numbers between which each coefficient lies.
pub(super) fn bounded(system: &System<impl Bounded>) -> System<Bounds> {
    let Ok(system) = system.try_map(|x| Ok::<_, Infallible>(x.bounds()));
    system
}

/// The same system in exact numbers, if it is.
pub(super) fn exact(system: &System<Bounds>) -> Option<System<BigRational>> {
    system.try_map(|[lo, hi]| if lo == hi { Ok(lo.clone()) } else { Err(()) }).ok()
}
