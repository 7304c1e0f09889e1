//! The Farey sequence F_N over any range of rationals, for any integer type, by the next-term recurrence.
//!
//! F_N here is the set of all fractions with denominator at most N, not only those in [0, 1]. For a fast walk
//! within [0, 1] over machine integers see [`Walk`](super::Walk).

use std::{fmt::Display, mem::replace};

use num_rational::Ratio;
use num_traits::Zero;

use super::FareyInteger;
use crate::error::{Error, Result};

/// The consecutive terms l ≤ x < r of F_N around `x`, N = `order` ≥ 1.
///
/// Cost: O(log N) divisions.
///
/// # Errors
/// An input error if `order` < 1; an overflow error if 2N(|x| + 1) does not fit the type.
///
/// ```
/// use grazing::farey::{bracket, next, previous};
/// use num_rational::Ratio;
/// // 3/8 is no term of F_7; 2/5 is one.
/// let [third, x, two_fifths] = [(1u64, 3), (3, 8), (2, 5)].map(|(p, q)| Ratio::new(p, q));
/// assert_eq!(bracket(&x, &7)?, (third, two_fifths));
/// assert_eq!((next(&x, &7)?, previous(&two_fifths, &7)?), (two_fifths, third));
/// # Ok::<(), grazing::Error>(())
/// ```
pub fn bracket<T: FareyInteger + Display>(x: &Ratio<T>, order: &T) -> Result<(Ratio<T>, Ratio<T>)> {
    check(x, order)?;
    let (floor, rest) = x.numer().div_mod_floor(x.denom());
    // l = p/q and r = p'/q' with the remainders d = (x − l) q b ≥ 0 and d' = (r − x) q' b > 0, b the
    // denominator of x. The run lengths are Euclid's quotients of the remainders, so they stay below b.
    let (mut p, mut q, mut d) = (floor.clone(), T::one(), rest.clone());
    let (mut p1, mut q1, mut d1) = (floor + T::one(), T::one(), x.denom().clone() - rest);
    loop {
        let run = (d.clone() / d1.clone()).min((order.clone() - q.clone()) / q1.clone());
        p = p + run.clone() * p1.clone();
        q = q + run.clone() * q1.clone();
        d = d - run.clone() * d1.clone();
        let room = (order.clone() - q1.clone()) / q.clone();
        let run1 = if d.is_zero() { room } else { room.min((d1.clone() - T::one()) / d.clone()) };
        p1 = p1 + run1.clone() * p.clone();
        q1 = q1 + run1.clone() * q.clone();
        d1 = d1 - run1.clone() * d.clone();
        if run.is_zero() && run1.is_zero() {
            return Ok((Ratio::new_raw(p, q), Ratio::new_raw(p1, q1)));
        }
    }
}

/// The least term of F_N greater than `x`, which need not be a term itself. Cost and errors as [`bracket`].
pub fn next<T: FareyInteger + Display>(x: &Ratio<T>, order: &T) -> Result<Ratio<T>> {
    Ok(bracket(x, order)?.1)
}

/// The greatest term of F_N less than `x`, which need not be a term itself. Cost and errors as [`bracket`].
pub fn previous<T: FareyInteger + Display>(x: &Ratio<T>, order: &T) -> Result<Ratio<T>> {
    let (left, right) = bracket(x, order)?;
    if left != *x {
        return Ok(left);
    }
    if left.is_zero() && T::zero().checked_sub(&T::one()).is_none() {
        return Err(Error::overflow("the term before 0 is negative; use a signed integer type"));
    }
    Ok(opposite(order, &left, &right))
}

/// The neighbour of the term `x` on the other side of a given one: k x − neighbour, with k as large as N
/// allows.
fn opposite<T: FareyInteger>(order: &T, x: &Ratio<T>, neighbour: &Ratio<T>) -> Ratio<T> {
    let k = (order.clone() + neighbour.denom().clone()) / x.denom().clone();
    Ratio::new_raw(
        k.clone() * x.numer().clone() - neighbour.numer().clone(),
        k * x.denom().clone() - neighbour.denom().clone(),
    )
}

/// Rejects what could overflow: a step multiplies a term next to x by a number below 2N.
fn check<T: FareyInteger + Display>(x: &Ratio<T>, order: &T) -> Result<()> {
    if *order < T::one() {
        return Err(Error::input(format!("a Farey sequence has an order of at least 1, not {order}")));
    }
    let fits = || -> Option<()> {
        let twice = order.checked_add(order)?;
        let (floor, _) = x.numer().div_mod_floor(x.denom());
        let above = floor.checked_add(&T::one())?.checked_add(&T::one())?;
        above.checked_mul(&twice)?;
        if floor < T::zero() {
            floor.checked_sub(&T::one())?.checked_mul(&twice)?;
        }
        Some(())
    };
    fits().ok_or_else(|| {
        Error::overflow(format!(
            "F_{order} around {x} needs numbers beyond this integer type; use a wider one or BigInt"
        ))
    })
}

/// The terms of F_N in a closed range, from either end, in O(1) memory.
///
/// One division and six other operations a term.
///
/// ```
/// use grazing::farey::Sequence;
/// use num_rational::Ratio;
/// let terms: Vec<_> = Sequence::new(5u64, &Ratio::new(1, 4), &Ratio::new(1, 2))?.collect();
/// let expected = [(1, 4), (1, 3), (2, 5), (1, 2)].map(|(p, q)| Ratio::new(p, q));
/// assert_eq!(terms, expected);
/// # Ok::<(), grazing::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Sequence<T> {
    order: T,
    /// The next term from the front and the one after it.
    front: (Ratio<T>, Ratio<T>),
    /// The next term from the back and the one after it. (Not the one before it: that of 0/1 is negative.)
    back: (Ratio<T>, Ratio<T>),
    done: bool,
}

impl<T: FareyInteger + Display> Sequence<T> {
    /// The terms x of F_N, N = `order`, with `from` ≤ x ≤ `to`; none if `from` > `to`.
    ///
    /// # Errors
    /// As [`bracket`] at either end.
    pub fn new(order: T, from: &Ratio<T>, to: &Ratio<T>) -> Result<Self> {
        let (left, right) = bracket(from, &order)?;
        let front = if left == *from {
            (left, right)
        } else {
            let after = opposite(&order, &right, &left);
            (right, after)
        };
        let back = bracket(to, &order)?;
        let done = back.0 < front.0;
        Ok(Sequence { order, front, back, done })
    }
}

impl<T: FareyInteger> Iterator for Sequence<T> {
    type Item = Ratio<T>;

    fn next(&mut self) -> Option<Ratio<T>> {
        if self.done {
            return None;
        }
        // Both ends step through the same terms, so they meet exactly: equality is enough.
        if self.front.0 == self.back.0 {
            self.done = true;
            return Some(self.front.0.clone());
        }
        let after = opposite(&self.order, &self.front.1, &self.front.0);
        Some(replace(&mut self.front.0, replace(&mut self.front.1, after)))
    }
}

impl<T: FareyInteger> DoubleEndedIterator for Sequence<T> {
    fn next_back(&mut self) -> Option<Ratio<T>> {
        if self.done {
            return None;
        }
        if self.front.0 == self.back.0 {
            self.done = true;
            return Some(self.back.0.clone());
        }
        let before = opposite(&self.order, &self.back.0, &self.back.1);
        self.back.1 = replace(&mut self.back.0, before);
        Some(self.back.1.clone())
    }
}

impl<T: FareyInteger> std::iter::FusedIterator for Sequence<T> {}
