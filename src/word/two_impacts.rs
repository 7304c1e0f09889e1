//! Where patterns of two impacts exist on r = 1: Farey intervals of s, by the word theorem.

use std::fmt;

use num_integer::Integer;
use num_rational::Ratio;
use num_traits::Zero;
use serde::Serialize;

use crate::{
    error::{Error, Result},
    existence::{Case, MAX_PERIOD},
    output::serialize_fraction,
};

/// An open interval of s on r = 1 in which the impact pattern (i, j) exists.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct PatternInterval {
    /// The lower period, i < j.
    pub i: u64,
    /// The higher period.
    pub j: u64,
    /// The case (sign eµ, sign γ) in which it exists.
    pub case: Case,
    /// The left end.
    #[serde(serialize_with = "serialize_fraction")]
    pub left: Ratio<u64>,
    /// The right end.
    #[serde(serialize_with = "serialize_fraction")]
    pub right: Ratio<u64>,
}

/// As `(3,5): (1/6, 1/5) in case (+,+)`.
impl fmt::Display for PatternInterval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({},{}): ({}, {}) in case {}", self.i, self.j, self.left, self.right, self.case)
    }
}

/// Every interval of the pattern (i, j), by increasing s; the ends are Farey fractions or multiples of
/// 1/(2i), 1/(2j).
///
/// For each fraction m_j/j, gcd(m_j, j) = 1, with an ancestor m_i/i in the Stern–Brocot tree below 0/1 and ½,
/// for eµ > 0:
///
/// | i and j | (i, j) exists | in case |
/// | --- | --- | --- |
/// | same side of s | on the area of j on that side | above: (+,+), below: (+,−) |
/// | opposite sides, i no parent of j | on the area of j on its side | that of i's side |
/// | opposite sides, i a parent of j | on both areas of i + j between them | (+,+) and (+,−) |
///
/// where 1/k does not occur for 2ks ≤ 1; and for eµ < 0 on 0 < s < 1/(2j), in (−,+). Cost: O(j log j).
///
/// # Errors
/// An input error unless 1 ≤ i < j and i + j ≤ [`MAX_PERIOD`].
pub fn two_impacts(i: u64, j: u64) -> Result<Vec<PatternInterval>> {
    if i == 0 || i >= j || i.checked_add(j).is_none_or(|sum| sum > MAX_PERIOD) {
        return Err(Error::input(format!(
            "the pattern ({i}, {j}): two periods 1 <= i < j with i + j <= {MAX_PERIOD}"
        )));
    }
    let mut found = vec![PatternInterval {
        i,
        j,
        case: Case::MinusPlus,
        left: Ratio::zero(),
        right: Ratio::new(1, 2 * j),
    }];
    let numerators = 1..=if j == 2 { 1 } else { (j - 1) / 2 };
    for m in numerators.filter(|m| m.gcd(&j) == 1) {
        above(i, Ratio::new_raw(m, j), &mut found);
    }
    found.sort_by(|a, b| a.left.cmp(&b.left).then(a.case.cmp(&b.case)));
    Ok(found)
}

/// Every interval of every pattern (i, j) of period i + j = `n`, by increasing i. Cost: O(n² log n).
///
/// # Errors
/// As [`two_impacts`]; `n` must be at least 3.
pub fn two_impacts_of(n: u64) -> Result<impl Iterator<Item = PatternInterval>> {
    if !(3..=MAX_PERIOD).contains(&n) {
        return Err(Error::input(format!("two impacts of period {n}: from 3 to {MAX_PERIOD}")));
    }
    Ok((1..=(n - 1) / 2).flat_map(move |i| two_impacts(i, n - i).unwrap_or_default()))
}

/// The intervals that come from one fraction of denominator j: eµ > 0.
fn above(i: u64, fraction: Ratio<u64>, found: &mut Vec<PatternInterval>) {
    let j = *fraction.denom();
    let (zero, half) = (Ratio::new_raw(0, 1), Ratio::new_raw(1, 2));
    // The path from 0/1 and ½ to the fraction: its parents, and its ancestor of denominator i.
    let (mut lower, mut upper) = (zero, half);
    let mut ancestor = [zero, half].into_iter().find(|end| *end.denom() == i);
    if fraction == half {
        // ½ and 0/1 are ends of the tree; as a pair they are neighbours.
        upper = Ratio::new_raw(1, 1);
    } else {
        loop {
            let mediant = Ratio::new_raw(lower.numer() + upper.numer(), lower.denom() + upper.denom());
            if mediant == fraction {
                break;
            }
            if *mediant.denom() > j {
                return;
            }
            if *mediant.denom() == i {
                ancestor = Some(mediant);
            }
            if fraction < mediant { upper = mediant } else { lower = mediant }
        }
    }
    let Some(ancestor) = ancestor else { return };
    let is_upper = ancestor > fraction;
    // A period 1/k does not occur for 2ks ≤ 1.
    let first = |x: &Ratio<u64>| if *x.numer() == 1 { Ratio::new(1, 2 * x.denom()) } else { zero };
    let least = first(&ancestor).max(first(&fraction));
    let mut add = |case, left: Ratio<u64>, right: Ratio<u64>, least: Ratio<u64>| {
        let left = left.max(least);
        if left < right {
            found.push(PatternInterval { i, j, case, left, right });
        }
    };
    let by_side = |upper: bool| if upper { Case::PlusPlus } else { Case::PlusMinus };
    // On the ancestor's own side of s.
    if is_upper {
        add(Case::PlusPlus, lower, fraction, least);
    } else if fraction != half {
        add(Case::PlusMinus, fraction, upper, least);
    }
    // With s between the two.
    let parent = if is_upper { upper } else { lower };
    if ancestor == parent {
        let (left, right) = if is_upper { (fraction, ancestor) } else { (ancestor, fraction) };
        let mediant = Ratio::new_raw(left.numer() + right.numer(), left.denom() + right.denom());
        let least = least.max(first(&mediant));
        add(Case::PlusPlus, left, mediant, least);
        add(Case::PlusMinus, mediant, right, least);
    } else if is_upper {
        add(by_side(true), fraction, upper, least);
    } else {
        add(by_side(false), lower, fraction, least);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(i: u64, j: u64) -> Vec<String> {
        two_impacts(i, j).unwrap().iter().map(|x| format!("{} {} {}", x.case, x.left, x.right)).collect()
    }

    /// Worked out by hand from the signs (B1), (64).
    #[test]
    fn the_first_patterns() {
        assert_eq!(shown(1, 2), ["(-,+) 0 1/4", "(+,+) 1/4 1/3", "(+,-) 1/3 1/2"]);
        assert_eq!(shown(1, 3), ["(-,+) 0 1/6", "(+,+) 1/6 1/4", "(+,-) 1/4 1/3", "(+,-) 1/3 1/2"]);
        let both = shown(3, 5);
        let plus: Vec<&str> = both.iter().map(String::as_str).collect();
        assert_eq!(
            plus,
            [
                "(-,+) 0 1/10",
                "(+,+) 1/6 1/5",
                "(+,+) 1/5 1/4",
                "(+,+) 1/3 3/8",
                "(+,-) 3/8 2/5",
                "(+,-) 2/5 1/2"
            ]
        );
    }

    #[test]
    fn ends_of_the_range_are_errors() {
        for (i, j) in [(0, 1), (2, 2), (3, 2), (1, u64::MAX), (u64::MAX - 1, u64::MAX)] {
            assert!(two_impacts(i, j).unwrap_err().is_input(), "{i} {j}");
        }
        assert!(two_impacts_of(2).is_err());
    }
}
