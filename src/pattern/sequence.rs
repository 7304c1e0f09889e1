//! Impact patterns up to rotation: necklaces whose beads are periods.

use std::fmt;

use num_bigint::BigUint;
use num_integer::Integer;
use num_traits::One;

/// An impact pattern (n₁, …, n_m): the periods between impacts, of all its rotations the lexicographically
/// least.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Pattern {
    periods: Vec<u64>,
    repeats: usize,
}

impl Pattern {
    /// The pattern of these periods, rotated to its least form; `None` unless there is one and all are ≥ 1.
    /// Cost: O(m²).
    pub fn new(periods: &[u64]) -> Option<Pattern> {
        if periods.is_empty() || periods.contains(&0) {
            return None;
        }
        let m = periods.len();
        let rotation = |i: usize| periods[i..].iter().chain(&periods[..i]).copied();
        let least = (0..m).min_by(|&i, &j| rotation(i).cmp(rotation(j)))?;
        let shortest = (1..=m).find(|&d| m.is_multiple_of(d) && rotation(d % m).eq(rotation(0)))?;
        Some(Pattern { periods: rotation(least).collect(), repeats: m / shortest })
    }

    /// n₁, …, n_m.
    pub fn periods(&self) -> &[u64] {
        &self.periods
    }

    /// n = Σ n_i.
    pub fn period(&self) -> u64 {
        self.periods.iter().sum()
    }

    /// Whether it is no shorter pattern run through several times.
    pub fn is_primitive(&self) -> bool {
        self.repeats == 1
    }
}

impl fmt::Display for Pattern {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let periods: Vec<String> = self.periods.iter().map(u64::to_string).collect();
        f.pad(&periods.join(","))
    }
}

/// The patterns of one period in lexicographic order, those with a step that is not allowed left out unseen.
///
/// The search extends pre-necklaces (Ruskey, Savage and Wang): a word a₁…a_t whose longest prefix that is a
/// Lyndon word has length p may go on with any a_{t+1} ≥ a_{t+1−p}, and is a necklace iff p divides t. Memory
/// O(n); without a filter the time for all patterns of period n is in proportion to their number (2ⁿ/n), O(1)
/// steps for each.
pub struct Patterns<F> {
    period: u64,
    left: u64,
    /// The word, each letter with the p of the prefix that it ends.
    word: Vec<(u64, usize)>,
    /// The letter to try next in place t + 1.
    next: u64,
    pruning: F,
}

/// What leaves out beginnings of patterns, as the search makes and unmakes them letter by letter.
pub trait Pruning {
    /// One letter more, after `before` unless it is the first. False: no pattern that begins so is wanted,
    /// and the letter is not taken.
    fn enter(&mut self, before: Option<u64>, letter: u64) -> bool;

    /// The last letter that was taken goes.
    fn leave(&mut self) {}

    /// Whether the word is wanted as a pattern, `first` following `last`.
    fn closes(&self, _last: u64, _first: u64) -> bool {
        true
    }
}

/// Whether one letter may follow another.
impl<F: Fn(u64, u64) -> bool> Pruning for F {
    fn enter(&mut self, before: Option<u64>, letter: u64) -> bool {
        before.is_none_or(|before| self(before, letter))
    }

    fn closes(&self, last: u64, first: u64) -> bool {
        self(last, first)
    }
}

impl Patterns<fn(u64, u64) -> bool> {
    /// Every pattern with Σ n_i = `period`.
    ///
    /// ```
    /// use grazing::pattern::Patterns;
    /// let all: Vec<String> = Patterns::of_period(4).map(|pattern| pattern.to_string()).collect();
    /// assert_eq!(all, ["1,1,1,1", "1,1,2", "1,3", "2,2", "4"]);
    /// ```
    pub fn of_period(period: u64) -> Self {
        Patterns::walks(period, |_, _| true)
    }

    /// How many there are: (1/n) Σ_{d|n} φ(n/d) 2^d − 1, the necklaces of n beads of two colours without the
    /// one that has no impact. Cost: O(σ(n)) greatest common divisors, σ(n) the sum of the divisors of n =
    /// `period`, and a number of n bits.
    ///
    /// ```
    /// use grazing::pattern::Patterns;
    /// assert_eq!(Patterns::count(4), 5u32.into());
    /// ```
    pub fn count(period: u64) -> BigUint {
        let coprime = |n: u64| (1..=n).filter(|k| k.gcd(&n) == 1).count();
        let divisors = (1..=period).filter(|&d| period.is_multiple_of(d));
        let colourings: BigUint = divisors.map(|d| (BigUint::one() << d) * coprime(period / d)).sum();
        if period == 0 { BigUint::ZERO } else { colourings / period - 1u32 }
    }
}

impl<F: Pruning> Patterns<F> {
    /// The patterns that `pruning` leaves; as a function `follows(n_i, n_{i+1})`, those in which it holds
    /// cyclically. Cost: memory O(n), n = `period`; time up to that of all beginnings that are left, of which
    /// there are O(2ⁿ).
    pub fn walks(period: u64, pruning: F) -> Self {
        Patterns { period, left: period, word: Vec::new(), next: 1, pruning }
    }

    /// Takes the last letter away and aims at its successor; false if there is none.
    fn back(&mut self) -> bool {
        let Some((letter, _)) = self.word.pop() else { return false };
        self.pruning.leave();
        self.left += letter;
        self.next = letter + 1;
        true
    }
}

impl<F: Pruning> Iterator for Patterns<F> {
    type Item = Pattern;

    fn next(&mut self) -> Option<Pattern> {
        if self.period == 0 {
            return None;
        }
        loop {
            if self.left == 0 {
                let (last, p) = *self.word.last()?;
                let found = (self.word.len().is_multiple_of(p) && self.pruning.closes(last, self.word[0].0))
                    .then(|| Pattern {
                        periods: self.word.iter().map(|&(letter, _)| letter).collect(),
                        repeats: self.word.len() / p,
                    });
                self.back();
                if found.is_some() {
                    return found;
                }
                continue;
            }
            if self.next > self.left {
                if !self.back() {
                    return None;
                }
                continue;
            }
            let letter = self.next;
            self.next += 1;
            let t = self.word.len();
            if let Some(&(last, p)) = self.word.last() {
                let bound = self.word[t - p].0;
                if letter < bound {
                    self.next = bound;
                    continue;
                }
                if !self.pruning.enter(Some(last), letter) {
                    continue;
                }
                self.word.push((letter, if letter == bound { p } else { t + 1 }));
            } else {
                if !self.pruning.enter(None, letter) {
                    continue;
                }
                self.word.push((letter, 1));
            }
            self.left -= letter;
            // The least letter that may come next.
            let p = self.word[t].1;
            self.next = self.word[t + 1 - p].0;
        }
    }
}
