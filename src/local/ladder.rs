//! Signs by a ladder of rungs: climb as far as needed, no further, and never guess.

use std::{
    fmt,
    sync::{Arc, OnceLock},
};

use serde::{Serialize, Serializer};

use super::{Point, Polar, Quantity, quick, zero_test};
use crate::{
    error::Result,
    monitor::Monitor,
    number::{Ball, Circular, FloatInterval, Plain, Precision, Real, Sign},
    processor::Stopwatch,
    profile::Profile,
};

/// Where an answer came from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rung {
    /// Plain `f64`, which promises nothing.
    Plain,
    /// `f64` intervals.
    Interval,
    /// Balls of this many bits.
    Ball(u32),
    /// Integers.
    Exact,
}

impl Rung {
    /// The higher of two; integers, which often decide before anything else is tried, count as the lowest.
    pub(crate) fn higher(self, other: Rung) -> Rung {
        let height = |rung| match rung {
            Rung::Exact => 0,
            Rung::Plain | Rung::Interval => 1,
            Rung::Ball(bits) => bits,
        };
        if height(other) > height(self) { other } else { self }
    }
}

/// `plain f64`, `f64 interval`, `256 bits` or `exact`.
impl fmt::Display for Rung {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Rung::Plain => f.pad("plain f64"),
            Rung::Interval => f.pad("f64 interval"),
            Rung::Ball(bits) => f.pad(&format!("{bits} bits")),
            Rung::Exact => f.pad("exact"),
        }
    }
}

/// As text: `plain f64`, `f64 interval`, `256 bits` or `exact`.
impl Serialize for Rung {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// What is known of a sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Answer {
    /// It is this.
    Sign(Sign),
    /// u_n = 0: the quantity is not defined, and Theorem 1 is silent.
    Singular,
    /// The rung was not enough.
    Undecided,
}

/// The sign, `singular` or `undecided`.
impl fmt::Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Answer::Sign(sign) => sign.fmt(f),
            Answer::Singular => f.pad("singular"),
            Answer::Undecided => f.pad("undecided"),
        }
    }
}

/// As text: the sign, `singular` or `undecided`.
impl Serialize for Answer {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// An answer and the highest rung it took.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct SignDecision {
    /// The answer.
    pub answer: Answer,
    /// The rung that gave it; for [`Answer::Undecided`] the highest one tried.
    pub rung: Rung,
}

/// The rungs up to a number of bits, with π computed at most once for each. Shared freely between threads.
///
/// Order: exact where integers decide at once (a singular point; r = 1; c_n from (r, s)), intervals, balls, a
/// cheap exact attempt, longer balls, a dear exact attempt. What intervals leave open lies within 10⁻¹⁵ of a
/// zero or so, where no short fraction happens to lie: the length of the point's own fractions says how near
/// it may have been put on purpose. So balls begin with that, if it is at most 1024 bits, and else grow to it
/// from 512 by a factor of 8 at the most. What balls of this length leave open is probably a zero, and only
/// then integers are tried. So a rung tried in vain costs little beside the one that decides; the longest is
/// always tried.
#[derive(Debug)]
pub struct Ladder {
    balls: Vec<(u32, OnceLock<Precision>)>,
    profile: Option<Arc<Profile>>,
}

/// Integers of the exact rung grow to at most this many bits: first try, last try.
const EXACT_BITS: [u64; 2] = [1 << 15, 1 << 23];

/// Balls of up to this many bits cost about the same: one rung among them is enough.
const SHORT: u32 = 512;

/// A point that needs no more bits than this begins with as many as it needs.
const AT_ONCE: u32 = 1024;

/// Up to so many signs that plain `f64` leaves open are decided one by one, with no pass over all k.
const FEW: usize = 2;

/// Bits beyond a point's own that a decision takes.
const SLACK: u64 = 32;

impl Default for Ladder {
    /// Up to 16384 bits.
    fn default() -> Self {
        Ladder::new(16384)
    }
}

impl Ladder {
    /// Rungs of 128, 256, … bits, not above `max_bits`; below 128 there are only intervals and integers.
    /// Cost: none here; a rung's constants are computed when a sign first needs it, O(log `max_bits`) rungs
    /// in all.
    pub fn new(max_bits: u32) -> Ladder {
        let rungs = std::iter::successors(Some(128u32), |bits| bits.checked_mul(2))
            .take_while(|&bits| bits <= max_bits);
        Ladder { balls: rungs.map(|bits| (bits, OnceLock::new())).collect(), profile: None }
    }

    /// The same ladder, which adds up the time and the number of its signs by the rung that decided, if there
    /// is a profile.
    #[must_use]
    pub fn with_profile(self, profile: Option<Arc<Profile>>) -> Ladder {
        Ladder { profile, ..self }
    }

    /// The precisions of the ball rungs, lowest first.
    pub fn precisions(&self) -> impl Iterator<Item = &Precision> {
        (0..self.balls.len()).map(|index| self.precision(index))
    }

    /// The sign of a quantity at a point.
    ///
    /// Right whenever it is not [`Answer::Undecided`]. An exact zero is found on r = 1, for every (a₁, a₂)
    /// within 2²³ bits, and for (r, s) with s = p/q as long as q has at most one prime above 2²⁰ (below 2⁴⁰)
    /// and 12 primes in all. Cost: on each rung climbed O(log n) products of the rung's bits and, from (r,
    /// s), up to six sines; on the exact one, from (a₁, a₂), O(log n) products of integers of n times the
    /// bits of the point, at most 2²³. Memory: some of these numbers.
    ///
    /// # Panics
    /// Unless n ≥ 1 and, for b_{n,k}, 1 ≤ k < n.
    pub fn sign(&self, point: &Point, quantity: Quantity) -> SignDecision {
        self.sign_watched(point, quantity, &()).expect("nothing interrupts")
    }

    /// [`sign`](Ladder::sign), which a monitor can end: it is asked before every rung, and in the exact one
    /// before every product of long integers, of which none takes a second.
    ///
    /// # Errors
    /// The monitor's interruption.
    ///
    /// # Panics
    /// As [`sign`](Ladder::sign).
    pub fn sign_watched(
        &self,
        point: &Point,
        quantity: Quantity,
        monitor: &dyn Monitor,
    ) -> Result<SignDecision> {
        quantity.check();
        let Some(profile) = &self.profile else { return self.decide(point, quantity, monitor) };
        let start = Stopwatch::start();
        let decision = self.decide(point, quantity, monitor)?;
        profile.since(start, decision.rung, 1);
        Ok(decision)
    }

    /// Where time is added up, if anywhere.
    pub(crate) fn profile(&self) -> Option<&Profile> {
        self.profile.as_deref()
    }

    fn decide(&self, point: &Point, quantity: Quantity, monitor: &dyn Monitor) -> Result<SignDecision> {
        if let Some(answer) = at_once(point, quantity) {
            return Ok(SignDecision { answer, rung: Rung::Exact });
        }
        self.climb(
            point.length(),
            sign_on::<FloatInterval>(point, quantity, &()),
            |precision| monitor.advance(0).map(|()| sign_on::<Ball>(point, quantity, precision)),
            |attempt| monitor.advance(0).and_then(|()| exactly(point, quantity, attempt, monitor)),
        )
    }

    /// The sign of u_n, never [`Answer::Singular`]: exact from (r, s) and where u_n = 0, else by the rungs.
    /// Cost: O(1) from (r, s); else as [`sign`](Ladder::sign).
    ///
    /// # Panics
    /// Unless n ≥ 1.
    pub fn u_sign(&self, point: &Point, n: u64) -> SignDecision {
        Quantity::C { n }.check();
        let plane = match point {
            Point::Polar(polar) => {
                return SignDecision { answer: Answer::Sign(polar.u_sign(n)), rung: Rung::Exact };
            }
            Point::Plane(plane) if plane.is_singular(n) => {
                return SignDecision { answer: Answer::Sign(Sign::Zero), rung: Rung::Exact };
            }
            Point::Plane(plane) => plane,
        };
        let known = |sign: Option<Sign>| sign.map_or(Answer::Undecided, Answer::Sign);
        self.climb(
            plane.length(),
            known(plane.u::<FloatInterval>(n, &()).sign()),
            |precision| Ok(known(plane.u::<Ball>(n, precision).sign())),
            |attempt| Ok(plane.exact_u(n, attempt, &())?.as_ref().map(Sign::from)),
        )
        .expect("nothing interrupts")
    }

    /// The signs of b_{n,1}, …, b_{n,n−1}, most of them from a pass of intervals over all k, or two. Cost:
    /// O(n) interval operations, and a [`sign`](Ladder::sign) for each k that they leave open; on r = 1 n − 1
    /// signs. Memory: O(n).
    ///
    /// # Panics
    /// Unless n ≥ 1.
    pub fn signs(&self, point: &Point, n: u64) -> Vec<SignDecision> {
        Quantity::C { n }.check();
        let start = self.profile.as_ref().map(|_| Stopwatch::start());
        let Some(first) = signs_by_intervals(point, n, |_| false) else {
            return (1..n).map(|k| self.sign(point, Quantity::B { n, k })).collect();
        };
        if let Some((profile, start)) = self.profile.as_ref().zip(start) {
            let decided = first.iter().filter(|&&answer| answer != Answer::Undecided).count();
            profile.since(start, Rung::Interval, decided as u64);
        }
        let decide = |(k, answer)| match answer {
            Answer::Undecided => self.sign(point, Quantity::B { n, k }),
            answer => SignDecision { answer, rung: Rung::Interval },
        };
        (1..n).zip(first).map(decide).collect()
    }

    /// The signs of b_{n,1}, …, b_{n,n−1} as far as it takes to know both a positive one and a negative one,
    /// or all of them, and the highest rung it took (`Exact` counts as the lowest; plain `f64` with proved
    /// bounds, which comes first, counts as intervals). What intervals leave open is decided, in order of k,
    /// only where they do not show both. Needs u_n ≠ 0. Cost: as [`signs`](Ladder::signs) at most.
    ///
    /// # Panics
    /// Unless n ≥ 1.
    pub(crate) fn signs_until_both(&self, point: &Point, n: u64) -> (Vec<Answer>, Rung) {
        Quantity::C { n }.check();
        let start = self.profile.as_ref().map(|_| Stopwatch::start());
        let quick = match point {
            Point::Polar(polar) if polar.on_circle() || polar.is_singular(n) => None,
            Point::Polar(polar) => quick::polar_signs(polar, n),
            Point::Plane(plane) => quick::plane_signs(plane, n),
        };
        let mut answers: Vec<Answer> = match &quick {
            Some(signs) => signs.iter().map(|sign| sign.map_or(Answer::Undecided, Answer::Sign)).collect(),
            None => vec![Answer::Undecided; n as usize - 1],
        };
        let mut rung = if quick.is_some() { Rung::Interval } else { Rung::Exact };
        // A few signs are decided one by one.
        let open = answers.iter().filter(|&&answer| answer == Answer::Undecided).count();
        if open > FEW
            && !both(&answers)
            && let Some(signs) = signs_by_intervals(point, n, both)
        {
            rung = Rung::Interval;
            for (answer, sign) in answers.iter_mut().zip(signs) {
                *answer = if *answer == Answer::Undecided { sign } else { *answer };
            }
        }
        if let Some((profile, start)) = self.profile.as_ref().zip(start)
            && rung == Rung::Interval
        {
            let decided = answers.iter().filter(|&&answer| answer != Answer::Undecided).count();
            profile.since(start, Rung::Interval, decided as u64);
        }
        if let Point::Plane(plane) = point
            && answers.iter().filter(|&&answer| answer == Answer::Undecided).count() > FEW
            && !both(&answers)
            && let Some(precision) = self.precisions().next()
            && let Some((numerators, u)) = plane.numerators::<Ball>(n, precision)
        {
            rung = Rung::Ball(precision.bits());
            let u = u.sign();
            for (answer, numerator) in answers.iter_mut().zip(numerators) {
                if let (Answer::Undecided, Some(sign), Some(u)) = (&answer, numerator.sign(), u) {
                    *answer = Answer::Sign(sign * u);
                }
            }
        }
        let mut enough = both(&answers);
        for k in 1..n {
            let place = k as usize - 1;
            if !enough && answers[place] == Answer::Undecided {
                let decision = self.sign(point, Quantity::B { n, k });
                answers[place] = decision.answer;
                enough = both(&answers);
                rung = rung.higher(decision.rung);
            }
        }
        (answers, rung)
    }

    /// Rung after rung for a point whose fractions have `length` bits.
    fn climb(
        &self,
        length: u64,
        first: Answer,
        ball: impl Fn(&Precision) -> Result<Answer>,
        exact: impl Fn(u64) -> Result<Option<Sign>>,
    ) -> Result<SignDecision> {
        if first != Answer::Undecided {
            return Ok(SignDecision { answer: first, rung: Rung::Interval });
        }
        let mut rung = Rung::Interval;
        let mut exact_tried = false;
        // The balls' own forms have some bits to spare.
        let at_once = length <= AT_ONCE.into();
        let mut next = self.rung_for(length, 0, if at_once { AT_ONCE } else { SHORT });
        let needed = length.saturating_add(SLACK);
        while let Some(index) = next {
            let precision = self.precision(index);
            rung = Rung::Ball(precision.bits());
            let answer = ball(precision)?;
            if answer != Answer::Undecided {
                return Ok(SignDecision { answer, rung });
            }
            let after = index + 1;
            let enough = u64::from(precision.bits()) >= needed;
            if !exact_tried && (enough || after == self.balls.len()) {
                exact_tried = true;
                if let Some(sign) = exact(EXACT_BITS[0])? {
                    return Ok(SignDecision { answer: Answer::Sign(sign), rung: Rung::Exact });
                }
            }
            next = self.rung_for(needed, after, precision.bits().saturating_mul(8).max(SHORT));
        }
        Ok(match exact(EXACT_BITS[1])? {
            Some(sign) => SignDecision { answer: Answer::Sign(sign), rung: Rung::Exact },
            None => SignDecision { answer: Answer::Undecided, rung },
        })
    }

    /// The first rung of balls from `start` on with as many bits as `needed`, or the last one up to `highest`
    /// bits, or `start`; `None` beyond the last.
    fn rung_for(&self, needed: u64, start: usize, highest: u32) -> Option<usize> {
        let reached = (start..self.balls.len()).take_while(|&index| self.balls[index].0 <= highest);
        let enough = |&index: &usize| u64::from(self.balls[index].0) >= needed;
        reached.clone().find(enough).or(reached.last()).or((start < self.balls.len()).then_some(start))
    }

    fn precision(&self, index: usize) -> &Precision {
        let (bits, precision) = &self.balls[index];
        precision.get_or_init(|| Precision::new(*bits))
    }
}

/// The signs of b_{n,1}, …, b_{n,n−1} on one rung in one pass, from the direct numerators. Needs
/// r < 1 and u_n ≠ 0. Cost: O(n) products of the rung's numbers, and as many held in memory.
pub fn direct_signs<T: Circular>(polar: &Polar, n: u64, context: &T::Context) -> Vec<Answer> {
    let sine = polar.u_sign(n);
    let answer = |numerator: T| numerator.sign().map_or(Answer::Undecided, |sign| Answer::Sign(sign * sine));
    polar.direct_numerators::<T>(n, context).into_iter().map(answer).collect()
}

/// The signs of b_{n,1}, …, b_{n,n−1} as far as passes of intervals over all k tell them; `None` where
/// integers decide, on r = 1 and where u_n = 0. From (r, s) the folded form has what the direct one leaves
/// open, near r = 1 and near poles, unless that is `enough`.
fn signs_by_intervals(point: &Point, n: u64, enough: fn(&[Answer]) -> bool) -> Option<Vec<Answer>> {
    let known = |sign: Option<Sign>| sign.map_or(Answer::Undecided, Answer::Sign);
    match point {
        Point::Polar(polar) if polar.on_circle() || polar.is_singular(n) => None,
        Point::Polar(polar) => {
            let mut answers = direct_signs::<FloatInterval>(polar, n, &());
            if answers.contains(&Answer::Undecided) && !enough(&answers) {
                let sine = polar.u_sign(n);
                for (answer, folded) in
                    answers.iter_mut().zip(polar.folded_numerators::<FloatInterval>(n, &()))
                {
                    if *answer == Answer::Undecided {
                        *answer = known(folded.sign().map(|sign| sign * sine));
                    }
                }
            }
            Some(answers)
        }
        Point::Plane(plane) => {
            let (numerators, u) = plane.numerators::<FloatInterval>(n, &())?;
            let u = u.sign();
            Some(
                numerators
                    .iter()
                    .map(|numerator| known(numerator.sign().zip(u).map(|(a, b)| a * b)))
                    .collect(),
            )
        }
    }
}

/// Whether a positive and a negative sign are among the answers.
fn both(answers: &[Answer]) -> bool {
    [Sign::Positive, Sign::Negative].iter().all(|&sign| answers.contains(&Answer::Sign(sign)))
}

/// What integers decide with no search.
fn at_once(point: &Point, quantity: Quantity) -> Option<Answer> {
    match (point, quantity) {
        (Point::Polar(polar), _) if polar.is_singular(quantity.period()) => Some(Answer::Singular),
        (Point::Polar(polar), Quantity::C { n }) => Some(Answer::Sign(polar.c_sign(n))),
        (Point::Polar(polar), Quantity::B { n, k }) if polar.on_circle() => {
            Some(Answer::Sign(polar.b_sign_on_circle(n, k)))
        }
        (Point::Plane(plane), _) if plane.is_singular(quantity.period()) => Some(Answer::Singular),
        _ => None,
    }
}

/// The exact rung: a zero test from (r, s), every sign from (a₁, a₂), within `limit` bits.
fn exactly(point: &Point, quantity: Quantity, limit: u64, monitor: &dyn Monitor) -> Result<Option<Sign>> {
    let parts = match (point, quantity) {
        (Point::Polar(polar), Quantity::B { n, k }) => {
            // The test is cheap or hopeless: once is enough.
            let vanishes = limit == EXACT_BITS[0] && zero_test::numerator_vanishes(polar, n, k) == Some(true);
            return Ok(vanishes.then_some(Sign::Zero));
        }
        (Point::Polar(polar), Quantity::C { n }) => return Ok(Some(polar.c_sign(n))),
        (Point::Plane(plane), Quantity::B { n, k }) => plane.exact_numerator(n, k, limit, monitor)?,
        (Point::Plane(plane), Quantity::C { n }) => {
            plane.exact_factor(n, limit, monitor)?.map(|(factor, u)| (-factor, u))
        }
    };
    Ok(parts.map(|(numerator, denominator)| Sign::from(&numerator) * Sign::from(&denominator)))
}

/// The sign on one rung alone, from enclosures of numerator and denominator. Cost: O(log n) products of the
/// rung's numbers and, from (r, s), up to six sines.
///
/// # Panics
/// As [`Ladder::sign`].
pub fn sign_on<T: Circular>(point: &Point, quantity: Quantity, context: &T::Context) -> Answer {
    quantity.check();
    let value = match (point, quantity) {
        (Point::Plane(plane), Quantity::B { n, k }) => plane.b_sign::<T>(n, k, context),
        (Point::Plane(plane), Quantity::C { n }) => {
            let parts = plane.c_parts::<T>(n, context);
            parts.map(|(factor, u)| factor.sign().zip(u.sign()).map(|(a, b)| -(a * b)))
        }
        (Point::Polar(polar), _) if polar.is_singular(quantity.period()) => None,
        (Point::Polar(polar), Quantity::B { n, k }) if !polar.on_circle() => {
            Some(polar.numerator_sign::<T>(n, k, context).map(|sign| sign * polar.u_sign(n)))
        }
        (Point::Polar(polar), Quantity::B { n, k }) => polar.b::<T>(n, k, context).map(|b| b.sign()),
        (Point::Polar(polar), Quantity::C { n }) => polar.c::<T>(n, context).map(|c| c.sign()),
    };
    match value {
        None => Answer::Singular,
        Some(None) => Answer::Undecided,
        Some(Some(sign)) => Answer::Sign(sign),
    }
}

/// The sign on a rung chosen at run time; [`Rung::Exact`] alone decides what it can within 2²³ bits. Cost:
/// that of this rung in [`Ladder::sign`]; [`Rung::Ball`] computes its constants anew.
pub fn sign_by(point: &Point, quantity: Quantity, rung: Rung) -> Answer {
    match rung {
        Rung::Plain => sign_on::<Plain>(point, quantity, &()),
        Rung::Interval => sign_on::<FloatInterval>(point, quantity, &()),
        Rung::Ball(bits) => sign_on::<Ball>(point, quantity, &Precision::new(bits)),
        Rung::Exact => at_once(point, quantity)
            .or_else(|| {
                let exact = |&limit| exactly(point, quantity, limit, &()).expect("nothing interrupts");
                EXACT_BITS.iter().find_map(exact).map(Answer::Sign)
            })
            .unwrap_or(Answer::Undecided),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The balls tried in vain, in order, for a point of this length.
    fn tried(max_bits: u32, length: u64) -> Vec<u32> {
        let seen = std::cell::RefCell::new(Vec::new());
        let ball = |precision: &Precision| {
            seen.borrow_mut().push(precision.bits());
            Ok(Answer::Undecided)
        };
        let ladder = Ladder::new(max_bits);
        let found = ladder.climb(length, Answer::Undecided, ball, |_| Ok(None)).unwrap();
        let bits = seen.into_inner();
        let highest = bits.last().map_or(Rung::Interval, |&bits| Rung::Ball(bits));
        assert_eq!(found, SignDecision { answer: Answer::Undecided, rung: highest });
        bits
    }

    /// The longest balls are always tried, and before them what a point of its length can need.
    #[test]
    fn balls_grow_to_the_point() {
        assert_eq!(tried(16384, 3400), [512, 4096, 8192, 16384]);
        assert_eq!(tried(16384, 1000), [1024, 2048, 4096, 8192, 16384]);
        assert_eq!(tried(16384, 1100), [512, 2048, 4096, 8192, 16384]);
        assert_eq!(tried(16384, 430), [512, 1024, 2048, 4096, 8192, 16384]);
        assert_eq!(tried(16384, 200), [256, 512, 1024, 2048, 4096, 8192, 16384]);
        assert_eq!(tried(16384, 120), [128, 256, 512, 1024, 2048, 4096, 8192, 16384]);
        assert_eq!(tried(16384, 1 << 20), [512, 4096, 16384]);
        assert!(tried(64, 3400).is_empty());
        for bits in [128, 256, 512, 1024, 2048] {
            for length in [0, 100, 300, 1000, 4000] {
                let tried = tried(bits, length);
                assert!(tried.windows(2).all(|pair| pair[0] < pair[1]) && tried.last() == Some(&bits));
            }
        }
    }
}
