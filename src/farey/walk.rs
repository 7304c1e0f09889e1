//! A fast walk of F_N within [0, 1]: no division and no unpredictable branch for most terms.
//!
//! F_N is walked as a coarse sequence F_M, M ≈ N/6, by the next-term recurrence; the terms of F_N inside a
//! gap of F_M between fractions with denominators d₁, d₂ are the combinations i·left + j·right, i and j
//! coprime, with i d₁ + j d₂ ≤ N. The coprime pairs stand in tables, in the order of the terms, so a gap is
//! filled by one multiply-add and one comparison a candidate. For the plain recurrence and for other types
//! see [`Sequence`](super::Sequence).
//!
//! There is one stream of terms. Two gaps filled in one loop were tried, and are no faster than one after the
//! other: candidates do not wait for each other, so a processor overlaps them anyway. Two thirds of the time
//! go into candidates and one third into handing on the terms.

use num_rational::Ratio;

use super::sequence::bracket;
use crate::error::{Error, Result};

/// A fraction as numerator · 2³² + denominator: one integer operation then serves both, since neither
/// half ever exceeds 2N < 2³² (see [`Walk::MAX_ORDER`]).
type Packed = u64;

/// The terms of F_N in a closed range within [0, 1], from either end, in O(1) memory.
///
/// Cost: O(1) per term, about 2 ns on average. The setting up takes O(log N) divisions and tables of fixed
/// size, together about as long as 50,000 terms if N is large; less if it is small. Memory: about 0.2 MB,
/// twice that once terms are asked for from the back.
///
/// ```
/// use grazing::farey::Walk;
/// use num_rational::Ratio;
/// let mut terms = Walk::new(10_000, &Ratio::new(1, 3), &Ratio::new(1, 2))?;
/// assert_eq!(terms.next(), Some(Ratio::new(1, 3)));
/// assert_eq!(terms.next(), Some(Ratio::new(3333, 9998)));
/// assert_eq!(terms.nth_back(1), Some(Ratio::new(4999, 9999)));
/// # Ok::<(), grazing::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Walk {
    front: Side,
    /// The walk of the mirror image 1 − x, begun when it is first asked for.
    back: Option<Side>,
    order: u32,
    range: (Ratio<u64>, Ratio<u64>),
    /// The last term given from the back, 0 for none: the ends meet when one is about to repeat the other.
    back_last: Packed,
}

impl Walk {
    /// The largest order N allowed. A candidate in a gap has i d₁ ≤ N and j d₂ ≤ N, so every number formed is
    /// ≤ 2N.
    pub const MAX_ORDER: u64 = 1 << 30;

    /// The terms x of F_N, N = `order`, with `from` ≤ x ≤ `to`; none if `from` > `to`.
    ///
    /// # Errors
    /// An input error unless 1 ≤ `order` ≤ [`MAX_ORDER`](Self::MAX_ORDER) and `to` ≤ 1.
    pub fn new(order: u64, from: &Ratio<u64>, to: &Ratio<u64>) -> Result<Self> {
        if !(1..=Self::MAX_ORDER).contains(&order) {
            return Err(Error::input(format!(
                "a walk has an order from 1 to {}, not {order}",
                Self::MAX_ORDER
            )));
        }
        if to.numer() > to.denom() {
            return Err(Error::input(format!("{to} is above 1: a walk stays within [0, 1]")));
        }
        // At most 2³⁰.
        let order = order as u32;
        let front = Side::new(order, from, to)?;
        Ok(Walk { front, back: None, order, range: (*from, *to), back_last: 0 })
    }
}

impl Iterator for Walk {
    type Item = Ratio<u64>;

    #[inline]
    fn next(&mut self) -> Option<Ratio<u64>> {
        let term = self.front.peek()?;
        if term == self.back_last {
            return None;
        }
        self.front.position += 1;
        Some(unpack(term))
    }

    fn fold<B, F: FnMut(B, Ratio<u64>) -> B>(mut self, init: B, mut f: F) -> B {
        let mut value = init;
        while self.front.peek().is_some() {
            for &term in &self.front.buffer[self.front.position..self.front.length] {
                if term == self.back_last {
                    return value;
                }
                value = f(value, unpack(term));
            }
            self.front.position = self.front.length;
        }
        value
    }
}

impl DoubleEndedIterator for Walk {
    fn next_back(&mut self) -> Option<Ratio<u64>> {
        let (order, (from, to)) = (self.order, &self.range);
        let back = self.back.get_or_insert_with(|| {
            let mirror = |x: &Ratio<u64>| Ratio::new_raw(x.denom() - x.numer(), *x.denom());
            // The mirrored range is empty or within [0, 1] like the range itself, so this cannot fail.
            let start = if from > to { Ratio::new_raw(1, 1) } else { mirror(to) };
            let end = if from > to { Ratio::new_raw(0, 1) } else { mirror(from) };
            Side::new(order, &start, &end).expect("the mirror image of a valid range is valid")
        });
        let term = mirrored(back.peek()?);
        if term == self.front.given() {
            return None;
        }
        back.position += 1;
        self.back_last = term;
        Some(unpack(term))
    }
}

impl std::iter::FusedIterator for Walk {}

fn unpack(term: Packed) -> Ratio<u64> {
    Ratio::new_raw(term >> 32, term & u64::from(u32::MAX))
}

fn pack(x: &Ratio<u64>) -> Packed {
    x.numer() << 32 | x.denom()
}

fn mirrored(term: Packed) -> Packed {
    let denominator = term & u64::from(u32::MAX);
    (denominator - (term >> 32)) << 32 | denominator
}

/// The coarse order is N/`COARSENESS`; tables reach to ⌊N/d⌋ = `REACH`, so that of two neighbours in F_M,
/// with d₁ + d₂ > M, at most one lies beyond. Both chosen by measurement.
const COARSENESS: u32 = 8;
const REACH: u32 = 40;
/// Gaps are filled until this many terms are ready.
const BATCH: usize = 256;

/// One direction of a walk.
#[derive(Debug, Clone)]
struct Side {
    order: u32,
    coarse: u32,
    tables: Tables,
    /// The current gap of F_M.
    gap: (Packed, Packed),
    /// The point of the chain through that gap reached so far, and the equal steps left before its right end.
    at: Packed,
    step: u64,
    steps: u32,
    /// The last term wanted.
    last: Packed,
    ended: bool,
    /// The terms ready to be given, from `position` to `length`.
    buffer: Vec<Packed>,
    position: usize,
    length: usize,
    /// The last term given from the buffer before this one, 0 for none.
    given_before: Packed,
}

impl Side {
    fn new(order: u32, from: &Ratio<u64>, to: &Ratio<u64>) -> Result<Self> {
        let coarse = (order / COARSENESS).max(1);
        let tables = Tables::new(order.min(REACH));
        let (left, right) = bracket(from, &u64::from(coarse))?;
        let first = match bracket(from, &u64::from(order))? {
            (exact, _) if exact == *from => exact,
            (_, after) => after,
        };
        let (last, _) = bracket(to, &u64::from(order))?;
        let ended = first > last;
        let buffer = vec![0; BATCH + tables.longest + 2];
        let mut side = Side {
            order,
            coarse,
            tables,
            gap: (pack(&left), pack(&right)),
            at: 0,
            step: 0,
            steps: 0,
            last: pack(&last),
            ended,
            buffer,
            position: 0,
            length: 0,
            given_before: 0,
        };
        if !ended {
            side.push(pack(&left));
            side.enter_gap();
            side.skip_to(pack(&first));
        }
        Ok(side)
    }

    /// The last term given, 0 for none.
    fn given(&self) -> Packed {
        self.position.checked_sub(1).map_or(self.given_before, |index| self.buffer[index])
    }

    /// The next term, if there is one.
    #[inline]
    fn peek(&mut self) -> Option<Packed> {
        if self.position == self.length && !self.refill() {
            return None;
        }
        Some(self.buffer[self.position])
    }

    #[inline]
    fn push(&mut self, term: Packed) {
        self.buffer[self.length] = term;
        self.length += 1;
    }

    /// Drops the terms before `first`, a term that lies ahead.
    fn skip_to(&mut self, first: Packed) {
        loop {
            if let Some(found) = self.buffer[..self.length].iter().position(|&term| term == first) {
                self.position = found;
                return self.trim();
            }
            self.length = 0;
            self.advance();
        }
    }

    /// Fills the buffer with the next terms; false at the end.
    #[cold]
    fn refill(&mut self) -> bool {
        if self.ended {
            return false;
        }
        self.given_before = self.given();
        self.position = 0;
        self.length = 0;
        while self.length < BATCH && !self.past_end() {
            self.advance();
        }
        self.trim();
        true
    }

    /// Whether the last term wanted has been reached: p/q ≥ p'/q' by cross-multiplication, all below 2³².
    fn past_end(&self) -> bool {
        let low = u64::from(u32::MAX);
        (self.at >> 32) * (self.last & low) >= (self.last >> 32) * (self.at & low)
    }

    /// Ends the walk after the last term wanted, if the buffer reaches it.
    fn trim(&mut self) {
        if self.past_end() {
            let found = self.buffer[..self.length].iter().position(|&term| term == self.last);
            self.length = found.map_or(self.length, |index| index + 1);
            self.ended = true;
        }
    }

    /// Sets up the chain of points through the current gap of F_M: its two ends, and, if one end's
    /// denominator is so small that no table reaches it, the terms of F_N adjacent to that end, an arithmetic
    /// progression.
    fn enter_gap(&mut self) {
        let (left, right) = self.gap;
        let (d1, d2) = (left as u32, right as u32);
        (self.at, self.step, self.steps) = (left, 0, 0);
        if self.order / d1 > REACH {
            let k = (self.order - d2) / d1;
            self.at = right + u64::from(k) * left;
            self.push(self.at);
            self.step = left.wrapping_neg();
            self.steps = k;
        } else if self.order / d2 > REACH {
            self.step = right;
            self.steps = (self.order - d1) / d2;
        }
    }

    /// Appends the terms up to the next point of the chain, that point included, and goes on to the next
    /// gap of F_M at its end.
    fn advance(&mut self) {
        let right = self.gap.1;
        if self.at == right {
            let k = u64::from((self.coarse + self.gap.0 as u32) / right as u32);
            self.gap = (right, k * right - self.gap.0);
            return self.enter_gap();
        }
        let to = if self.steps > 0 { self.at.wrapping_add(self.step) } else { right };
        self.steps = self.steps.saturating_sub(1);
        self.fill(self.at, to);
        self.push(to);
        self.at = to;
    }

    /// Appends the terms strictly between two neighbours.
    fn fill(&mut self, left: Packed, right: Packed) {
        let (d1, d2) = (left as u32, right as u32);
        if d1 + d2 > self.order {
            return;
        }
        let pairs = self.tables.get(self.order / d1, self.order / d2);
        let out = &mut self.buffer[self.length..self.length + pairs.len() + 1];
        let mut length = 0;
        for &[i, j] in pairs {
            let term = u64::from(i) * left + u64::from(j) * right;
            out[length] = term;
            // Branch-free: a candidate whose denominator is too large is overwritten by the next.
            length += usize::from(term as u32 <= self.order);
        }
        self.length += length;
    }
}

/// For each α, β the coprime pairs (i, j), i, j ≥ 1, with i/(α + 1) + j/(β + 1) < 1, by increasing j/i: all
/// that i d₁ + j d₂ ≤ N allows when ⌊N/d₁⌋ = α and ⌊N/d₂⌋ = β.
#[derive(Debug, Clone)]
struct Tables {
    reach: u32,
    pairs: Vec<[u8; 2]>,
    /// Where the table for (α, β) starts, at index α (reach + 1) + β; one more entry at the end.
    starts: Vec<u32>,
    longest: usize,
}

impl Tables {
    fn new(reach: u32) -> Self {
        let mut pairs = Vec::new();
        let mut starts = Vec::new();
        let mut longest = 0;
        for alpha in 0..=reach {
            for beta in 0..=reach {
                let start = pairs.len();
                starts.push(start as u32);
                // Two neighbours whose tables are both long do not occur: d₁ + d₂ > M.
                if alpha.min(beta) < 2 * (COARSENESS + 1) {
                    append_pairs(alpha + 1, beta + 1, &mut pairs);
                }
                longest = longest.max(pairs.len() - start);
            }
        }
        starts.push(pairs.len() as u32);
        Tables { reach, pairs, starts, longest }
    }

    fn get(&self, alpha: u32, beta: u32) -> &[[u8; 2]] {
        let index = (alpha * (self.reach + 1) + beta) as usize;
        &self.pairs[self.starts[index] as usize..self.starts[index + 1] as usize]
    }
}

/// The coprime pairs with i/a + j/b < 1, in order: the Stern–Brocot tree below 0/1 and 1/0, cut off there.
fn append_pairs(a: u32, b: u32, pairs: &mut Vec<[u8; 2]>) {
    let fits = |[i, j]: [u8; 2]| u32::from(i) * b + u32::from(j) * a < a * b;
    let mut left = [1, 0];
    let mut stack: Vec<[u8; 2]> = vec![[0, 1]];
    while let Some(&right) = stack.last() {
        let mediant = [left[0] + right[0], left[1] + right[1]];
        if fits(mediant) {
            stack.push(mediant);
        } else {
            stack.pop();
            if !stack.is_empty() {
                pairs.push(right);
            }
            left = right;
        }
    }
}
