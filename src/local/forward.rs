//! A point in the direction of time in which a₂ ≤ 1.

use num_rational::BigRational;
use num_traits::{One, Signed};

use super::{Plane, Point, Polar, Region};
use crate::error::{Error, Result};

/// A point where a₂ ≤ 1, reached by reversing time if need be: the same orbits exist at (a₁/a₂, 1/a₂), or at
/// (1/r, s), run through backwards.
#[derive(Debug, Clone)]
pub struct Forward {
    /// The point, with a₂ ≤ 1.
    pub point: Point,
    /// The region of that point.
    pub region: Region,
    /// Whether time was reversed to get there.
    pub reversed: bool,
}

impl Forward {
    /// From trace and determinant, of any size.
    ///
    /// # Errors
    /// An input error unless a₂ > 0.
    pub fn plane(a1: BigRational, a2: BigRational) -> Result<Self> {
        if !a2.is_positive() {
            return Err(Error::input(format!("a2 = {a2}: the determinant of the map of a flow is above 0")));
        }
        let reversed = a2 > BigRational::one();
        let plane = if reversed { Plane::new(a1 / &a2, a2.recip())? } else { Plane::new(a1, a2)? };
        Ok(Forward { region: plane.region(), point: Point::Plane(plane), reversed })
    }

    /// From modulus and angle of complex eigenvalues.
    ///
    /// # Errors
    /// An input error unless r > 0 and 0 < s < ½.
    pub fn polar(r: BigRational, s: BigRational) -> Result<Self> {
        if !r.is_positive() {
            return Err(Error::input(format!("r = {r}: the modulus is above 0")));
        }
        let reversed = r > BigRational::one();
        let polar = Polar::new(if reversed { r.recip() } else { r }, s)?;
        Ok(Forward { region: Region::Three, point: Point::Polar(polar), reversed })
    }

    /// The k for which b_{n,k} at the point given has the sign of this `k`'s at [`point`](Self::point):
    /// reversing time turns b_{n,k} into b_{n,n−k} and keeps every sign.
    pub fn index(&self, n: u64, k: u64) -> u64 {
        if self.reversed { n - k } else { k }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::local::{Answer, Ladder, Quantity};

    fn ratio(p: i64, q: i64) -> BigRational {
        BigRational::new(p.into(), q.into())
    }

    /// By the recurrence of u at the point as it was given, with a₂ > 1.
    #[test]
    fn reversed_time_keeps_every_sign() {
        for (a1, a2) in [(ratio(3, 2), ratio(2, 1)), (ratio(-5, 1), ratio(3, 1)), (ratio(7, 2), ratio(5, 4))]
        {
            let forward = Forward::plane(a1.clone(), a2.clone()).unwrap();
            assert!(forward.reversed);
            let mut u = vec![ratio(0, 1), ratio(1, 1)];
            for i in 1..9 {
                u.push(&a1 * &u[i] - &a2 * &u[i - 1]);
            }
            let mut power = BigRational::one();
            for k in 1..9 {
                power *= &a2;
                for n in k + 1..=9 {
                    let b = (&u[n] - &u[k] - &power * &u[n - k]) / &u[n];
                    let (n, k) = (n as u64, k as u64);
                    let there = Quantity::B { n, k: forward.index(n, k) };
                    let Answer::Sign(sign) = Ladder::default().sign(&forward.point, there).answer else {
                        panic!("{there} at {a1}, {a2}")
                    };
                    assert_eq!(sign, crate::number::Sign::of(&b), "b_{{{n},{k}}} at {a1}, {a2}");
                }
            }
        }
    }

    #[test]
    fn the_circle_and_determinant_1_stay_as_they_are() {
        assert!(!Forward::polar(ratio(1, 1), ratio(1, 5)).unwrap().reversed);
        assert!(!Forward::plane(ratio(1, 1), ratio(1, 1)).unwrap().reversed);
        assert!(Forward::polar(ratio(9, 8), ratio(1, 5)).unwrap().reversed);
        for (r, s) in [(ratio(0, 1), ratio(1, 4)), (ratio(-1, 2), ratio(1, 4)), (ratio(2, 1), ratio(1, 2))] {
            assert!(Forward::polar(r, s).unwrap_err().is_input());
        }
        assert!(Forward::plane(ratio(1, 1), ratio(0, 1)).unwrap_err().is_input());
    }
}
