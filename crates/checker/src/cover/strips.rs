//! The strips and rows whose boxes are the roots of a cover's trees.

use super::{Fraction, Leaf, Multiple, Theorem, inverse};
use crate::rejection::ensure;

/// The part of region 3 between two neighbouring cuts in s.
pub(super) struct Strip {
    pub left: Fraction,
    pub right: Fraction,
    /// The ends in units of 2⁻⁶⁴, rounded outwards.
    pub units: [u64; 2],
    /// At s = 0 or s = ½, where sin θ = 0.
    pub outermost: bool,
    /// The interval of Theorem 2 that the strip is, if it is one.
    pub interval: Option<Interval>,
}

/// What is expected in a strip that is an interval of Theorem 2.
pub(super) struct Interval {
    /// Whether all N_{n,k} are > 0.
    positive: bool,
    /// The k of the curve that bounds the area; `None` if the area is the whole strip.
    deciding: Option<u64>,
}

impl Strip {
    /// Whether a leaf of this kind may stand in the strip.
    pub fn allows(&self, leaf: &Leaf) -> Result<(), String> {
        let Some(interval) = &self.interval else {
            return match leaf {
                Leaf::None { .. } | Leaf::Open => Ok(()),
                _ => Err("the strip is no interval of Theorem 2, so that no orbit is claimed there".into()),
            };
        };
        match *leaf {
            Leaf::Open => Ok(()),
            Leaf::Orbit { positive } if positive == interval.positive => Ok(()),
            Leaf::Edge { positive, deciding, .. }
                if positive == interval.positive && Some(deciding) == interval.deciding =>
            {
                Ok(())
            }
            Leaf::None { .. } if interval.deciding.is_some() => Ok(()),
            Leaf::None { .. } => Err("the area of (0, 1/(2n)) is its whole strip".into()),
            _ => Err("the sign or the deciding index is not that of the strip's interval".into()),
        }
    }
}

/// The strips of period n ≥ 3 from left to right: [0, ½] is cut at every multiple of 1/(2n), where u_n = 0,
/// and at the ends of Theorem 2's intervals.
///
/// # Errors
/// If an interval is not exactly one strip, its signs are not those that follow from the strip's, or two
/// intervals touch where u_n ≠ 0; it never happens.
pub(super) fn strips(n: u64) -> Result<Vec<Strip>, String> {
    let lowest = |p: u64, q: u64| {
        (1..=p.max(1)).rev().find_map(|d| {
            (p.is_multiple_of(d) && q.is_multiple_of(d)).then(|| Fraction::new(p / d, q / d)).flatten()
        })
    };
    let mut theorem = Theorem::new(n);
    let intervals: Vec<_> = std::iter::from_fn(|| theorem.next()).collect();
    let mut cuts: Vec<Fraction> = (0..=n).filter_map(|j| lowest(j, 2 * n)).collect();
    cuts.extend(intervals.iter().flat_map(|&(left, right, ..)| [left, right]));
    cuts.sort_by(|a, b| b.less(*a).cmp(&a.less(*b)));
    cuts.dedup();
    let mut all = Vec::new();
    let mut remaining = intervals.into_iter().peekable();
    for pair in cuts.windows(2) {
        let (left, right) = (pair[0], pair[1]);
        let listed = remaining.next_if(|listed| (listed.0, listed.1) == (left, right));
        let interval = listed.map(|(_, _, emu, gamma)| -> Result<Interval, String> {
            // Where all t N > 0, (52), (53) hold with sign γ = −t and sign eµ = t sign u_n; u_n < 0 on every
            // second stretch.
            let holds = emu == (gamma == Multiple::of(left, 2 * n).is_odd());
            ensure(
                holds,
                format_args!("Theorem 2's signs on ({left}, {right}) disagree with that of u_{n}"),
            )?;
            // The end m/n is on the right of a (+,+) interval, on the left of a (+,−) one; n₊ = 1/m modulo n,
            // n₋ = n − n₊.
            let deciding = match (left.parts().0, gamma) {
                (0, _) => None,
                (_, true) => Some(n - inverse(right.parts().0, n)),
                (m, false) => Some(inverse(m, n)),
            };
            Ok(Interval { positive: !gamma, deciding })
        });
        let units = |at: Fraction, up: u128| {
            let (p, q) = at.parts();
            (((u128::from(p) << 64) + up * u128::from(q - 1)) / u128::from(q)) as u64
        };
        all.push(Strip {
            left,
            right,
            units: [units(left, 0), units(right, 1)],
            outermost: left.parts().0 == 0 || right.parts() == (1, 2),
            interval: interval.transpose()?,
        });
    }
    let holds = n.is_multiple_of(2) || all.last().is_some_and(|last| last.interval.is_some());
    ensure(holds, format_args!("Theorem 2 lists no interval up to 1/2 for n = {n}"))?;
    ensure(remaining.next().is_none(), format_args!("an interval of Theorem 2 is not a strip for n = {n}"))?;
    let touching = |pair: &&[Strip]| {
        pair.iter().all(|strip| strip.interval.is_some()) && !pair[0].right.times_is_integer(2 * n)
    };
    match all.windows(2).find(touching) {
        Some(pair) => Err(format!("two intervals of Theorem 2 touch at {} for n = {n}", pair[0].right)),
        None => Ok(all),
    }
}

/// The rows [0, 1/2], [1/2, 3/4], … up to r_max, rounded up to a unit of 2⁻⁶⁰.
pub(super) fn rows(r_max: Fraction) -> Vec<[i64; 2]> {
    let (p, q) = r_max.parts();
    let top = (u128::from(p) << 60).div_ceil(u128::from(q)) as i64;
    let cut = |j: u32| super::fixed::ONE - (super::fixed::ONE >> j);
    let whole = (1..60).take_while(|&j| cut(j) < top).count() as u32;
    (0..=whole).map(|j| [cut(j), if j < whole { cut(j + 1) } else { top }]).collect()
}
