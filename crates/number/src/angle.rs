//! Exact rational multiples of π, reduced in integers before anything is rounded.

use num_bigint::{BigInt, BigUint};
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::Sign;

/// The angle πp/q, kept with 0 ≤ p < 2q; machine integers while they suffice.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Angle(Turn);

#[derive(Debug, Clone, PartialEq, Eq)]
enum Turn {
    /// q < 2⁶².
    Small {
        p: u64,
        q: u64,
    },
    Large {
        p: BigUint,
        q: BigUint,
    },
}

/// An angle brought to 0 ≤ t ≤ ¼: its sine is ± sin πt or ± cos πt.
pub(crate) struct Octant {
    pub negative: bool,
    pub cosine: bool,
    pub t: Fraction,
}

/// A fraction num/den ≥ 0, den > 0.
pub(crate) enum Fraction {
    Small(u64, u64),
    Large(BigUint, BigUint),
}

impl Angle {
    /// πp/q; `None` unless p < 2q and q < 2⁶². Cost: nothing is reduced.
    ///
    /// ```
    /// use grazing_number::{Angle, Sign};
    /// let angle = Angle::fraction(2, 6).unwrap();
    /// assert_eq!(angle.times(4).sin_sign(), Sign::Negative);
    /// assert!(Angle::fraction(2, 1).is_none());
    /// ```
    pub fn fraction(p: u64, q: u64) -> Option<Angle> {
        (q < 1 << 62 && p < 2 * q).then_some(Angle(Turn::Small { p, q }))
    }

    /// πx.
    ///
    /// ```
    /// use grazing_number::{Angle, Sign, parse_rational};
    /// let angle = Angle::new(&parse_rational("1/3")?);
    /// assert_eq!(angle.times(4).sin_sign(), Sign::Negative);
    /// assert_eq!(angle.complement(), Angle::new(&parse_rational("1/6")?));
    /// assert!(angle.times(3).is_on_axis() && !angle.is_on_axis());
    /// # Ok::<(), grazing_number::ParseError>(())
    /// ```
    pub fn new(x: &BigRational) -> Angle {
        let q = x.denom().magnitude();
        let turn: BigInt = x.denom() * 2;
        let (_, p) = x.numer().mod_floor(&turn).into_parts();
        match (p.to_u64(), q.to_u64()) {
            (Some(p), Some(q)) if q < 1 << 62 => Angle(Turn::Small { p, q }),
            _ => Angle(Turn::Large { p, q: q.clone() }),
        }
    }

    /// k times the angle, exactly. Cost: one multiplication and one remainder. An example of this and what
    /// follows is at [`new`](Angle::new).
    #[must_use]
    #[inline]
    pub fn times(&self, k: u64) -> Angle {
        Angle(match &self.0 {
            &Turn::Small { p, q } => {
                // The quick remainder first: a 128-bit one costs as much as a sine.
                let p = match k.checked_mul(p) {
                    Some(kp) => kp % (2 * q),
                    None => (u128::from(k) * u128::from(p) % u128::from(2 * q)) as u64,
                };
                Turn::Small { p, q }
            }
            Turn::Large { p, q } => Turn::Large { p: p * k % (q * 2u32), q: q.clone() },
        })
    }

    /// The difference of two multiples of one angle, exactly.
    #[must_use]
    pub(crate) fn minus(&self, other: &Angle) -> Angle {
        match (&self.0, &other.0) {
            (&Turn::Small { p, q }, &Turn::Small { p: less, q: same }) if q == same => {
                Angle(Turn::Small { p: if p >= less { p - less } else { p + 2 * q - less }, q })
            }
            (one, other) => {
                // p/q − p′/q′ + 2, over qq′.
                let ((p, q), (less, other)) = (one.large(), other.large());
                let whole = &q * &other;
                Angle(Turn::Large { p: (p * &other + &whole * 2u32 - less * &q) % (&whole * 2u32), q: whole })
            }
        }
    }

    /// π/2 minus the angle, so that its sine is this one's cosine.
    #[must_use]
    #[inline]
    pub fn complement(&self) -> Angle {
        // (q − 2p)/(2q), with 5q − 2p in place of q − 2p, which is positive and below 8q.
        Angle(match &self.0 {
            &Turn::Small { p, q } if q < 1 << 61 => {
                let (turned, period) = (5 * q - 2 * p, 4 * q);
                let p = if turned >= period { turned - period } else { turned };
                Turn::Small { p, q: 2 * q }
            }
            other => {
                let (p, q) = other.large();
                Turn::Large { p: (&q * 5u32 - p * 2u32) % (&q * 4u32), q: q * 2u32 }
            }
        })
    }

    /// The sign of the angle's sine: exact, in integers.
    pub fn sin_sign(&self) -> Sign {
        let (zero, upper) = match &self.0 {
            Turn::Small { p, q } => (*p == 0 || p == q, p < q),
            Turn::Large { p, q } => (p.is_zero() || p == q, p < q),
        };
        if zero { Sign::Zero } else { Sign::Positive.negated_if(!upper) }
    }

    /// Whether sine or cosine is zero: exact, in integers.
    #[inline]
    pub fn is_on_axis(&self) -> bool {
        match &self.0 {
            &Turn::Small { p, q } => p == 0 || p == q || 2 * p == q || 2 * p == 3 * q,
            Turn::Large { p, q } => (p * 2u32 % q).is_zero(),
        }
    }

    /// [`octant`](Angle::octant) in machine integers, if they hold the angle: negative, cosine, t.
    #[inline]
    pub(crate) fn small_octant(&self) -> Option<(bool, bool, u64, u64)> {
        match &self.0 {
            &Turn::Small { p, q } => Some(small_octant(p, q)),
            Turn::Large { .. } => None,
        }
    }

    pub(crate) fn octant(&self) -> Octant {
        match &self.0 {
            &Turn::Small { p, q } => {
                let (negative, cosine, p, q) = small_octant(p, q);
                Octant { negative, cosine, t: Fraction::Small(p, q) }
            }
            Turn::Large { p, q } => {
                let negative = p >= q;
                let p = if negative { p - q } else { p.clone() };
                let other = q - &p;
                let p = if other < p { other } else { p };
                let cosine = &p * 4u32 > *q;
                let t = if cosine {
                    Fraction::Large(q - p * 2u32, q * 2u32)
                } else {
                    Fraction::Large(p, q.clone())
                };
                Octant { negative, cosine, t }
            }
        }
    }
}

#[inline]
fn small_octant(p: u64, q: u64) -> (bool, bool, u64, u64) {
    let negative = p >= q;
    let p = if negative { p - q } else { p };
    let p = p.min(q - p);
    // sin πp/q = cos π(q − 2p)/(2q) above π/4; 4p < 2⁶⁴ since p ≤ q/2.
    if 4 * p > q { (negative, true, q - 2 * p, 2 * q) } else { (negative, false, p, q) }
}

impl Turn {
    fn large(&self) -> (BigUint, BigUint) {
        match self {
            &Turn::Small { p, q } => (p.into(), q.into()),
            Turn::Large { p, q } => (p.clone(), q.clone()),
        }
    }
}
