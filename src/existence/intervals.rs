//! Theorem 2's intervals of s, by two independent routes.

use std::{fmt, ops::Range};

use num_rational::Ratio;
use serde::Serialize;

use super::{
    Case,
    units::{Unit, Units},
};
use crate::{
    error::{Error, Result},
    farey::Gap,
    output::serialize_fraction,
};

/// The largest period n for which intervals are made and decided: products of two numbers up to 2n fit 64
/// bits with room to spare.
pub const MAX_PERIOD: u64 = 10_000_000;

/// An open interval of s on r = 1 where exactly one single-impact orbit of period n exists.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Interval {
    /// The period n.
    pub n: u64,
    /// The integer nearest to n s throughout the interval.
    pub m: u64,
    /// The signs of eµ and γ for which the orbit exists.
    pub case: Case,
    /// The left end, in lowest terms.
    #[serde(serialize_with = "serialize_fraction")]
    pub left: Ratio<u64>,
    /// The right end, in lowest terms.
    #[serde(serialize_with = "serialize_fraction")]
    pub right: Ratio<u64>,
    /// The k whose b_{n,k} alone decides existence for r < 1 (statement S3): n₋ for (+,+), n₊ for (+,−); none
    /// for m = 0.
    pub deciding: Option<u64>,
}

/// As `n = 5: (1/10, 1/5) in case (+,+)`.
impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "n = {}: ({}, {}) in case {}", self.n, self.left, self.right, self.case)
    }
}

/// All of Theorem 2's intervals for period `n`, from left to right, by modular inverses.
///
/// There are φ(n) + 1 for n ≥ 2. Period 1 exists everywhere, in (+,−) and (−,+); period 2 follows the general
/// pattern with m = 1 at s = ½. O(1) memory; O(√n) operations, then O(1) for each m ≤ n/2, where those of 512
/// values of m are made together.
///
/// # Errors
/// An input error unless 1 ≤ n ≤ [`MAX_PERIOD`].
///
/// ```
/// use grazing::existence::{Case, intervals};
/// let list: Vec<String> = intervals(8)?.map(|i| format!("{} {} {}", i.case, i.left, i.right)).collect();
/// assert_eq!(list, ["(-,+) 0 1/16", "(+,+) 1/16 1/8", "(+,-) 1/8 1/7", "(+,+) 1/3 3/8", "(+,-) 3/8 2/5"]);
/// # Ok::<(), grazing::Error>(())
/// ```
pub fn intervals(n: u64) -> Result<impl Iterator<Item = Interval> + Send> {
    check_period(n)?;
    Ok(intervals_between(n, 0..n / 2 + 1))
}

/// Those of [`intervals`] with m in a range, for a period that it takes. Cost: O(√n) operations, then O(1)
/// for each of these m.
pub(crate) fn intervals_between(n: u64, range: Range<u64>) -> impl Iterator<Item = Interval> + Send {
    let first = (range.start == 0 && range.end > 0).then(|| around_zero(n));
    let second =
        first.as_ref().filter(|_| n == 1).map(|first| Interval { case: Case::MinusPlus, ..first.clone() });
    // Period 1 has no m but 0.
    let units = (n > 1).then(|| Units::new(n, range.start.max(1)..range.end.min(n / 2 + 1)));
    let rest = units.into_iter().flatten().flat_map(move |unit| {
        // m n₊ ≡ 1 mod n; n₊ + n₋ = n. For n = 2, n₊ = 1.
        let Unit { m, inverse: n_plus, quotient } = unit;
        around(n, m, Ratio::new_raw(quotient, n_plus), Ratio::new_raw(m - quotient, n - n_plus))
    });
    [first, second].into_iter().flatten().chain(rest)
}

/// All of Theorem 2's intervals for every period from 3 to `order`, in increasing order of m/n, by Farey
/// mediants.
///
/// Each mediant inserted between two neighbours, starting from 0/1 and 1/2, makes the intervals on its two
/// sides; the interval around s = 0 comes with the mediant 1/n. O(`order`) memory, O(1) operations an
/// interval.
///
/// # Errors
/// An input error unless 1 ≤ `order` ≤ [`MAX_PERIOD`].
pub fn tree_intervals(order: u64) -> Result<impl Iterator<Item = Interval> + Send> {
    check_period(order)?;
    Ok(Gap::half().in_order(order).flat_map(|(node, gap)| {
        let (m, n) = node.into_raw();
        let zero = (m == 1).then(|| around_zero(n));
        zero.into_iter().chain(around(n, m, gap.left, gap.right))
    }))
}

pub(super) fn check_period(n: u64) -> Result<()> {
    if (1..=MAX_PERIOD).contains(&n) {
        return Ok(());
    }
    Err(Error::input(format!("a period is a whole number from 1 to {MAX_PERIOD}, not {n}")))
}

/// The interval with m = 0: (0, 1/(2n)) for n ≥ 2. For n = 1 there is no b to change sign, and both signs of
/// eµ are allowed: this is the one with eµ > 0.
fn around_zero(n: u64) -> Interval {
    Interval {
        n,
        m: 0,
        case: if n == 1 { Case::PlusMinus } else { Case::MinusPlus },
        left: Ratio::new_raw(0, 1),
        right: Ratio::new_raw(1, 2 * n),
        deciding: None,
    }
}

/// The intervals on the two sides of m/n, given its neighbours; for m/n = ½ only the left side lies in (0,
/// ½).
fn around(n: u64, m: u64, left: Ratio<u64>, right: Ratio<u64>) -> impl Iterator<Item = Interval> + Send {
    let (n_plus, n_minus) = (*left.denom(), *right.denom());
    let at = Ratio::new_raw(m, n);
    // Between 0/1 and 1/n the interval of m = 0 ends, and this one starts, at 1/(2n).
    let left = if m == 1 { Ratio::new_raw(1, 2 * n) } else { left };
    let before = Interval { n, m, case: Case::PlusPlus, left, right: at, deciding: Some(n_minus) };
    let after =
        (n > 2).then_some(Interval { n, m, case: Case::PlusMinus, left: at, right, deciding: Some(n_plus) });
    [before].into_iter().chain(after)
}
