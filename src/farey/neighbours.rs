//! The two parents of a fraction in the Stern–Brocot tree.

use num_rational::Ratio;

use super::FareyInteger;
use crate::error::{Error, Result};

/// The Farey neighbours m₊/n₊ < m/n < m₋/n₋ of a fraction m/n: its neighbours in F_n.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Neighbours<T: FareyInteger> {
    /// m₊/n₊, the left neighbour: m n₊ − m₊ n = 1.
    pub left: Ratio<T>,
    /// m₋/n₋, the right neighbour: m₋ n − m n₋ = 1.
    pub right: Ratio<T>,
}

/// The neighbours of `x` = m/n in F_n, by the continued fraction of `x`.
///
/// n₊ + n₋ = n and m₊ + m₋ = m, so both fit the type of `x`. Cost: O(log n) divisions.
///
/// # Errors
/// An input error if `x` is an integer, whose neighbours would have a denominator 0.
///
/// ```
/// use grazing::farey::neighbours;
/// use num_rational::Ratio;
/// let found = neighbours(&Ratio::new(3, 8))?;
/// assert_eq!((found.left, found.right), (Ratio::new(1, 3), Ratio::new(2, 5)));
/// # Ok::<(), grazing::Error>(())
/// ```
pub fn neighbours<T: FareyInteger + std::fmt::Display>(x: &Ratio<T>) -> Result<Neighbours<T>> {
    let (m, n) = (x.numer().clone(), x.denom().clone());
    if n.is_one() {
        return Err(Error::input(format!("{m} has no Farey neighbours: give a fraction m/n with n ≥ 2")));
    }
    // (p, q) is the latest convergent, (p0, q0) the one before; the loop ends at the last but one of x.
    let (mut p0, mut q0) = (T::one(), T::zero());
    let (floor, mut remainder) = m.div_mod_floor(&n);
    let (mut p, mut q) = (floor, T::one());
    let mut divisor = n.clone();
    let mut left_of_x = true;
    loop {
        let (a, next) = divisor.div_rem(&remainder);
        if next.is_zero() {
            break;
        }
        (p0, p) = (p.clone(), a.clone() * p + p0);
        (q0, q) = (q.clone(), a * q + q0);
        (divisor, remainder) = (remainder, next);
        left_of_x = !left_of_x;
    }
    let other = Ratio::new_raw(m - p.clone(), n - q.clone());
    let convergent = Ratio::new_raw(p, q);
    Ok(if left_of_x {
        Neighbours { left: convergent, right: other }
    } else {
        Neighbours { left: other, right: convergent }
    })
}
