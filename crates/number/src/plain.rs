//! Plain `f64` arithmetic, to be compared with: fast, and without any guarantee.

use std::f64::consts::PI;
use std::ops::{Add, Div, Mul, Neg, Sub};

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::angle::{Angle, Fraction};
use super::{Circular, Real, Sign};

/// A float that stands for a real number near it, nobody knows how near.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plain(pub f64);

impl Neg for Plain {
    type Output = Plain;

    #[inline]
    fn neg(self) -> Plain {
        Plain(-self.0)
    }
}

macro_rules! operation {
    ($trait:ident, $method:ident) => {
        impl $trait<&Plain> for Plain {
            type Output = Plain;

            #[inline]
            fn $method(self, other: &Plain) -> Plain {
                Plain(self.0.$method(other.0))
            }
        }
    };
}

operation!(Add, add);
operation!(Sub, sub);
operation!(Mul, mul);
operation!(Div, div);

impl Real for Plain {
    type Context = ();

    fn ratio(value: &BigRational, (): &()) -> Plain {
        Plain(value.to_f64().unwrap_or(f64::NAN))
    }

    #[inline]
    fn integer(value: i32, (): &()) -> Plain {
        Plain(value.into())
    }

    /// The float's own sign: "certain" only in the sense that this rung never doubts.
    #[inline]
    fn sign(&self) -> Option<Sign> {
        if self.0 == 0.0 { Some(Sign::Zero) } else { Some(Sign::Positive.negated_if(self.0 < 0.0)) }
    }
}

impl Circular for Plain {
    const CERTAIN: bool = false;

    fn sin(angle: &Angle, (): &()) -> Plain {
        let octant = angle.octant();
        let t = match &octant.t {
            &Fraction::Small(p, q) => p as f64 / q as f64,
            Fraction::Large(p, q) => {
                BigRational::new(p.clone().into(), q.clone().into()).abs().to_f64().unwrap_or(0.0)
            }
        };
        let value = if octant.cosine { (PI * t).cos() } else { (PI * t).sin() };
        Plain(if octant.negative { -value } else { value })
    }

    fn tighter(self, _: Plain) -> Plain {
        self
    }
}
