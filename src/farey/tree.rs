//! The Stern–Brocot tree: descent to a fraction, and lazy walks of any subtree.
//!
//! A node is known by the [`Gap`] it fills: its two parents, whose mediant it is. The gap between 0/1 and
//! 1/2 is the root of Nordmark's construction, the one between 0/1 and 1/1 that of the Farey sequences.

use std::collections::VecDeque;

use num_rational::Ratio;

use super::FareyInteger;
use crate::error::{Error, Result};

/// Two Farey neighbours, and so a node of the tree: their mediant.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Gap<T: FareyInteger> {
    /// The left parent.
    pub left: Ratio<T>,
    /// The right parent.
    pub right: Ratio<T>,
}

impl<T: FareyInteger> Gap<T> {
    /// The gap between 0/1 and 1/2, where the existence intervals of all periods n ≥ 3 are made.
    pub fn half() -> Self {
        Gap {
            left: Ratio::new_raw(T::zero(), T::one()),
            right: Ratio::new_raw(T::one(), T::one() + T::one()),
        }
    }

    /// The gap between 0/1 and 1/1, which holds all of F_N but its ends.
    pub(crate) fn unit() -> Self {
        Gap { left: Ratio::new_raw(T::zero(), T::one()), right: Ratio::new_raw(T::one(), T::one()) }
    }

    /// The mediant (m₁ + m₂)/(n₁ + n₂), in lowest terms; `None` where it does not fit the type.
    pub fn mediant(&self) -> Option<Ratio<T>> {
        let numerator = self.left.numer().checked_add(self.right.numer())?;
        let denominator = self.left.denom().checked_add(self.right.denom())?;
        Some(Ratio::new_raw(numerator, denominator))
    }

    /// The mediant if its denominator is at most `order`; no sum is formed that could overflow.
    fn mediant_within(&self, order: &T) -> Option<Ratio<T>> {
        let room = order.checked_sub(self.left.denom())?;
        if *self.right.denom() > room {
            return None;
        }
        self.mediant()
    }

    /// The two children: the gaps left and right of the mediant.
    fn split(&self, mediant: &Ratio<T>) -> (Self, Self) {
        let left = Gap { left: self.left.clone(), right: mediant.clone() };
        let right = Gap { left: mediant.clone(), right: self.right.clone() };
        (left, right)
    }

    /// The nodes of this subtree with denominator at most `order`, each with its gap, by increasing depth and
    /// from left to right within a depth. Memory: the widest level met.
    pub fn breadth_first(self, order: T) -> BreadthFirst<T> {
        BreadthFirst { order, queue: VecDeque::from([self]) }
    }

    /// The nodes of this subtree with denominator at most `order`, each with its gap, in increasing order.
    /// Memory: the depth, at most `order` gaps.
    pub fn in_order(self, order: T) -> InOrder<T> {
        let mut walk = InOrder { order, stack: Vec::new() };
        walk.descend(self);
        walk
    }
}

/// The walk of [`Gap::breadth_first`].
#[derive(Debug, Clone)]
pub struct BreadthFirst<T: FareyInteger> {
    order: T,
    queue: VecDeque<Gap<T>>,
}

impl<T: FareyInteger> Iterator for BreadthFirst<T> {
    type Item = (Ratio<T>, Gap<T>);

    fn next(&mut self) -> Option<Self::Item> {
        // A child's denominator exceeds its parent's, so a gap without a node has no subtree either.
        loop {
            let gap = self.queue.pop_front()?;
            if let Some(node) = gap.mediant_within(&self.order) {
                let (left, right) = gap.split(&node);
                self.queue.extend([left, right]);
                return Some((node, gap));
            }
        }
    }
}

/// The walk of [`Gap::in_order`].
#[derive(Debug, Clone)]
pub struct InOrder<T: FareyInteger> {
    order: T,
    /// The nodes whose left subtree is under way or done, the innermost last.
    stack: Vec<(Ratio<T>, Gap<T>)>,
}

impl<T: FareyInteger> InOrder<T> {
    fn descend(&mut self, mut gap: Gap<T>) {
        while let Some(node) = gap.mediant_within(&self.order) {
            let left = Gap { left: gap.left.clone(), right: node.clone() };
            self.stack.push((node, gap));
            gap = left;
        }
    }
}

impl<T: FareyInteger> Iterator for InOrder<T> {
    type Item = (Ratio<T>, Gap<T>);

    fn next(&mut self) -> Option<Self::Item> {
        let (node, gap) = self.stack.pop()?;
        self.descend(gap.split(&node).1);
        Some((node, gap))
    }
}

/// A turn of a path down the tree.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turn {
    /// To the left child, the smaller one.
    Left,
    /// To the right child.
    Right,
}

/// The way from 1/1, the root of the Stern–Brocot tree, down to `x` > 0, as runs of equal turns.
///
/// The runs are the partial quotients of `x`, alternating from a turn to the right (a first run of length 0
/// is left out). Cost: O(log n) divisions, n the denominator.
///
/// # Errors
/// An input error if `x` ≤ 0.
pub fn path<T: FareyInteger + std::fmt::Display>(x: &Ratio<T>) -> Result<Vec<(Turn, T)>> {
    if *x.numer() <= T::zero() {
        return Err(Error::input(format!(
            "{x} is not in the Stern–Brocot tree: it holds the fractions above 0"
        )));
    }
    let mut runs = Vec::new();
    let (mut a, mut b) = (x.numer().clone(), x.denom().clone());
    let mut turn = Turn::Right;
    while !b.is_zero() {
        let (quotient, rest) = a.div_rem(&b);
        // The last quotient counts one step more than the path: it would pass through x to 1/0 or 0/1.
        let run = if rest.is_zero() { quotient - T::one() } else { quotient };
        if !run.is_zero() {
            runs.push((turn, run));
        }
        (a, b) = (b, rest);
        turn = match turn {
            Turn::Left => Turn::Right,
            Turn::Right => Turn::Left,
        };
    }
    Ok(runs)
}

/// The fraction at the end of a path from 1/1; the inverse of [`path`]. Cost: two operations a run.
///
/// # Errors
/// An overflow error if the fraction does not fit the type.
///
/// ```
/// use grazing::farey::{Turn, from_path, path};
/// use num_rational::Ratio;
/// let turns = path(&Ratio::new(3u64, 8))?;
/// assert_eq!(turns, [(Turn::Left, 2), (Turn::Right, 1), (Turn::Left, 1)]);
/// assert_eq!(from_path(&turns)?, Ratio::new(3, 8));
/// # Ok::<(), grazing::Error>(())
/// ```
pub fn from_path<T: FareyInteger>(runs: &[(Turn, T)]) -> Result<Ratio<T>> {
    let too_large = || Error::overflow("the fraction at the end of this path does not fit its integer type");
    let advance = |x: &T, by: &T, times: &T| -> Result<T> {
        by.checked_mul(times).and_then(|step| x.checked_add(&step)).ok_or_else(too_large)
    };
    let (mut p_left, mut q_left) = (T::zero(), T::one());
    let (mut p_right, mut q_right) = (T::one(), T::zero());
    for (turn, run) in runs {
        match turn {
            Turn::Right => {
                p_left = advance(&p_left, &p_right, run)?;
                q_left = advance(&q_left, &q_right, run)?;
            }
            Turn::Left => {
                p_right = advance(&p_right, &p_left, run)?;
                q_right = advance(&q_right, &q_left, run)?;
            }
        }
    }
    Ok(Ratio::new_raw(advance(&p_left, &p_right, &T::one())?, advance(&q_left, &q_right, &T::one())?))
}
