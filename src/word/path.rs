//! The word of a point: which periods can occur between impacts, found by walking down the Stern–Brocot tree.

use std::fmt;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::{BigRational, Ratio};
use num_traits::{One, Signed, ToPrimitive};
use serde::Serialize;

use super::{Edge, Rectangle};
use crate::{
    error::{Error, Result},
    local::{Answer, Ladder, Plane, Point, Polar, Quantity, Region, Rung, SignDecision},
    monitor::Monitor,
    number::Sign,
};

/// The most letters that a word is asked for.
pub const MAX_LETTERS: usize = 100_000;

/// The sign of c_n of a period, which is also its side in regions 2, 3 and 4.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
pub enum Letter {
    /// c_n > 0. In region 3 its fraction m/n lies above s, and u_n < 0.
    U,
    /// c_n < 0. In regions 2, 3 and 4 its fraction m/n lies at or below s, and u_n > 0.
    D,
    /// Neither is true of all points: c_n is 0, on a line |a₁| = a₂ + 1, or has both signs on a rectangle.
    Either,
}

/// `U`, `D` or `?`.
impl fmt::Display for Letter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Letter::U => "U",
            Letter::D => "D",
            Letter::Either => "?",
        })
    }
}

/// A period that can occur between impacts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct Vertex {
    /// n.
    pub period: u64,
    /// m, the integer nearest to ns: m/n is the period's place in the Stern–Brocot tree. In regions 1, 2, 4
    /// and 5, where s is 0 or ½, the fraction on the path to s that has the denominator n.
    pub numerator: u64,
    /// Its letter.
    pub letter: Letter,
}

/// Where a word ends, and why.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Extent {
    /// Every period n ≥ 1 occurs, with the one letter given (regions 1, 2 and 5).
    All,
    /// No other period occurs. `next` is the period on the path whose deciding b_{n,k} is negative, or whose
    /// u_n is zero with a₂ < 1; `None` where the periods are bounded by 2ns < 1 or where 1 is the only one.
    Complete {
        /// The first period on the path that does not occur.
        next: Option<u64>,
    },
    /// The next period on the path lies on a boundary of its area, and Theorem 1 is silent there: its
    /// deciding b_{n,k} is zero (`deciding`), or u_n = 0 with a₂ = 1. No later period occurs.
    Boundary {
        /// The period on whose boundary the point lies.
        next: u64,
        /// The letter of the side on which the deciding b_{n,k} vanishes; `None` where u_n = 0.
        deciding: Option<Letter>,
    },
    /// The sign that decides about the next period on the path was not certain within the ladder's budget;
    /// the word may go on.
    Undecided {
        /// The period that was not decided.
        next: u64,
        /// The highest rung tried.
        rung: Rung,
    },
    /// Whether this period occurs is not the same on all of the rectangle, or not certain. So is what comes
    /// after it.
    Straddled {
        /// The first period that was not decided.
        next: u64,
    },
    /// The limit on letters was reached; the word may go on.
    Cut,
    /// On a₁ = −(a₂ + 1), for eµ > 0. Every odd period occurs, with the letter D. So does 2, but c_2 = 0.
    /// Every other even period has a b_{n,k} = 0, where Theorem 1 is silent.
    Odd,
    /// On a₁ = a₂ + 1, where every c_n and every b_{n,k} is zero. Period 1 occurs, and Theorem 1 is silent
    /// about everything else.
    Line,
}

impl Extent {
    /// Why a word ends, in words.
    pub fn in_words(self) -> String {
        match self {
            Extent::All => "every period occurs, with this letter".into(),
            Extent::Complete { next: Some(n) } => {
                format!("no other period occurs: on the path {n} is the first that does not")
            }
            Extent::Complete { next: None } => "no other period occurs".into(),
            Extent::Boundary { next, deciding: Some(_) } => {
                format!(
                    "the point lies on the boundary of period {next}: one b_{{n,k}} = 0 there, and no later period occurs"
                )
            }
            Extent::Boundary { next, deciding: None } => {
                format!("u_{next} = 0 at this point, where Theorem 1 is silent; no later period occurs")
            }
            Extent::Undecided { next, rung } => {
                format!(
                    "undecided: whether period {next} occurs (highest precision tried: {rung}); there may be more"
                )
            }
            Extent::Straddled { next } => format!(
                "undecided: whether period {next} occurs may differ between points of the box; there may be more"
            ),
            Extent::Cut => "the limit on letters is reached: there may be more".into(),
            Extent::Odd => {
                "every odd period occurs, with the letter D, and so does 2; every other even period has a \
                            b_{n,k} = 0, where Theorem 1 is silent"
                    .into()
            }
            Extent::Line => "on this line every c_n and every b_{n,k} is zero: Theorem 1 is silent".into(),
        }
    }
}

/// The periods that can occur between impacts at a point with 0 < a₂ ≤ 1, for one sign of eµ, in path order.
///
/// For eµ > 0 these are the n with u_n ≠ 0 and every b_{n,k} > 0, for eµ < 0 those with every b_{n,k} < 0; n
/// = 1 always occurs. Which may follow which, for either sign of γ, is [`Word::edge`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Word {
    positive: bool,
    vertices: Vec<Vertex>,
    extent: Extent,
    /// The indices of the last lower and upper vertex, the pair whose mediant ended the walk.
    last: Option<(usize, usize)>,
}

impl Word {
    /// The word at `point` for the sign of eµ, `positive` or negative, of at most `limit` letters.
    ///
    /// Cost: one sign of u_n and one of b_{n,k} for each of its L letters; memory O(L). `monitor` is told of
    /// every letter.
    ///
    /// # Errors
    /// An input error if a₂ > 1 (reverse time: [`Point`] with a₁/a₂, 1/a₂) or `limit` is not in
    /// 1..=[`MAX_LETTERS`]; the monitor's interruption.
    pub fn at(
        ladder: &Ladder,
        point: &Point,
        positive: bool,
        limit: usize,
        monitor: &dyn Monitor,
    ) -> Result<Word> {
        Word::by(&At { ladder, point }, point, positive, limit, monitor)
    }

    /// The same with signs from elsewhere.
    pub(crate) fn by(
        signs: &dyn Signs,
        point: &Point,
        positive: bool,
        limit: usize,
        monitor: &dyn Monitor,
    ) -> Result<Word> {
        limited(limit)?;
        let realm = match point {
            Point::Polar(_) => Realm::Inside,
            Point::Plane(plane) if plane.a2() > &BigRational::one() => {
                return Err(Error::input(format!("a2 = {} is above 1: reverse time first", plane.a2())));
            }
            Point::Plane(plane) => Realm::of(plane),
        };
        Walk { signs, limit, monitor, word: Word::empty(positive) }.run(realm)
    }

    /// The word that all points of a rectangle have in common, of at most `limit` letters;
    /// [`Extent::Straddled`] where they may differ. The rectangle may meet lines between regions: every
    /// period listed occurs at all of its points, with this letter unless it is [`Letter::Either`], and every
    /// edge that is not open holds at all of them.
    ///
    /// Cost: O(1) for each sign, of which there are two for each letter.
    ///
    /// # Errors
    /// An input error if `limit` is not in 1..=[`MAX_LETTERS`]; the monitor's interruption.
    pub fn in_rectangle(
        rectangle: &Rectangle,
        positive: bool,
        limit: usize,
        monitor: &dyn Monitor,
    ) -> Result<Word> {
        Word::of_set(rectangle, rectangle.realm(), positive, limit, monitor)
    }

    /// The word that all points of any set in a realm have in common, by signs that hold at all of them.
    pub(crate) fn of_set(
        signs: &dyn Signs,
        realm: Realm,
        positive: bool,
        limit: usize,
        monitor: &dyn Monitor,
    ) -> Result<Word> {
        limited(limit)?;
        Walk { signs, limit, monitor, word: Word::empty(positive) }.run(realm)
    }

    /// The word for eµ > 0 in the part of region 3 where period n = `period`, m = `numerator`, occurs on the
    /// side `letter` of m/n and no later period does, with K = `first` the least k such that 2ks > 1. K
    /// matters where m = 1 and the side is U, 1/(2n) < s < 1/n; elsewhere s and so K is known well enough
    /// from m/n.
    ///
    /// `None` unless m/n is in lowest terms with 0 < m/n < ½, or 2 with the side U, and K ≤ n. Cost: O(n).
    pub fn of_area(period: u64, numerator: u64, letter: Letter, first: u64) -> Option<Word> {
        let (n, m) = (period, numerator);
        let end = (n, m) == (2, 1) && letter == Letter::U;
        if letter == Letter::Either
            || m == 0
            || m.gcd(&n) != 1
            || m > n / 2
            || (2 * m == n && !end)
            || first < 2
            || first > n
        {
            return None;
        }
        let mut word = Word::empty(true);
        word.push(0, 1, Letter::D);
        let (mut lower, mut upper) = ((0, 1, Some(0)), (1, 2, None));
        if first == 2 {
            word.push(1, 2, Letter::U);
            upper.2 = Some(1);
        }
        let mut next = (1, 2);
        while next != (m, n) {
            next = (lower.0 + upper.0, lower.1 + upper.1);
            let side = match (m * next.1).cmp(&(next.0 * n)) {
                std::cmp::Ordering::Less => Letter::U,
                std::cmp::Ordering::Greater => Letter::D,
                std::cmp::Ordering::Equal => letter,
            };
            let occurs = side == Letter::D || next.0 > 1 || next.1 >= first;
            let index = occurs.then_some(word.vertices.len());
            if occurs {
                word.push(next.0, next.1, side);
            }
            *(if side == Letter::U { &mut upper } else { &mut lower }) = (next.0, next.1, index);
        }
        word.extent = Extent::Complete { next: Some(lower.1 + upper.1) };
        word.last = lower.2.zip(upper.2);
        Some(word)
    }

    /// The word for eµ > 0 of 1 (D), K = `first` (U) and these letters, U or D, which ends there. Cost: O(L).
    pub(crate) fn of_letters(first: u64, letters: &[Letter]) -> Word {
        let mut word = Word::empty(true);
        word.push(0, 1, Letter::D);
        word.push(1, first, Letter::U);
        let (mut lower, mut upper) = ((0, 1, 0), (1, first, 1));
        for &letter in letters {
            let next = (lower.0 + upper.0, lower.1 + upper.1, word.vertices.len());
            word.push(next.0, next.1, letter);
            *(if letter == Letter::U { &mut upper } else { &mut lower }) = next;
        }
        word.extent = Extent::Complete { next: Some(lower.1 + upper.1) };
        word.last = Some((lower.2, upper.2));
        word
    }

    fn empty(positive: bool) -> Word {
        Word { positive, vertices: Vec::new(), extent: Extent::Complete { next: None }, last: None }
    }

    fn fill(&mut self, letter: Letter) {
        self.push(0, 1, letter);
        self.extent = Extent::All;
    }

    fn push(&mut self, numerator: u64, period: u64, letter: Letter) {
        self.vertices.push(Vertex { period, numerator, letter });
    }

    /// The first letters of this word, as of a walk that was cut there.
    pub(crate) fn shortened(&self, letters: usize) -> Word {
        let vertices = self.vertices[..letters.min(self.vertices.len())].to_vec();
        let last = |letter| vertices.iter().rposition(|vertex: &Vertex| vertex.letter == letter);
        let last = last(Letter::D).zip(last(Letter::U));
        Word { positive: self.positive, vertices, extent: Extent::Cut, last }
    }

    /// Whether this is the word for eµ > 0.
    pub fn is_positive(&self) -> bool {
        self.positive
    }

    /// The periods, in path order; of [`Extent::All`] only n = 1, whose letter is everyone's, and of
    /// [`Extent::Odd`] only 1 and 2.
    pub fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }

    /// Whether the word has no end: [`Extent::All`] or [`Extent::Odd`].
    pub fn is_endless(&self) -> bool {
        matches!(self.extent, Extent::All | Extent::Odd)
    }

    /// The periods up to `last`, in path order. Memory: O(`last`) for a word without end.
    pub fn up_to(&self, last: u64) -> Vec<Vertex> {
        match (self.extent, self.vertices.first()) {
            (Extent::All, Some(first)) => (1..=last).map(|period| Vertex { period, ..*first }).collect(),
            (Extent::Odd, _) => {
                let letter = |n: u64| if n == 2 { Letter::Either } else { Letter::D };
                let place = |period| Vertex { period, numerator: period / 2, letter: letter(period) };
                (1..=last).filter(|n| *n == 2 || n % 2 == 1).map(place).collect()
            }
            _ => self.vertices.iter().copied().filter(|vertex| vertex.period <= last).collect(),
        }
    }

    /// Where the word ends, and why.
    pub fn extent(&self) -> Extent {
        self.extent
    }

    /// Of the word for eµ < 0 of a set of points the n ≥ 2 at which it ends, as s = 1/(2n) may be among them:
    /// that word is of the n with s < 1/(2n).
    pub fn straddled_resonance(&self) -> Option<u64> {
        match self.extent {
            Extent::Straddled { next } if !self.is_positive() && next > 1 => Some(next),
            _ => None,
        }
    }

    /// Whether the periods listed are certainly all.
    pub fn is_whole(&self) -> bool {
        matches!(self.extent, Extent::All | Extent::Complete { .. } | Extent::Boundary { .. })
    }

    /// Whether the period of vertex `to` may follow that of vertex `from`: condition (64) with σ = sign(eµ)
    /// sign(γ), `sigma` true for σ > 0. Both are indices into [`vertices`](Word::vertices). Cost: O(1).
    ///
    /// | from, to (σ > 0) | edge |
    /// | --- | --- |
    /// | U → U | always |
    /// | D → D | never |
    /// | i D and j U, Farey neighbours, their mediant in the word with letter U | both ways |
    /// | the same with letter D | neither way |
    /// | the same, the mediant not in the word: the deciding b < 0, or u_{i+j} = 0 and a₂ < 1 | D → U only |
    /// | i D and j U, not neighbours, the later in the word is D | both ways |
    /// | the same, the later is U | neither way |
    ///
    /// For σ < 0 every answer is the opposite one. Open where a quantity is zero or was not decided; with
    /// [`Letter::Either`], where the answers for U and for D differ.
    ///
    /// # Panics
    /// Unless both are indices of vertices.
    pub fn edge(&self, from: usize, to: usize, sigma: bool) -> Edge {
        let by = |from_letter: Letter, to_letter: Letter| match (from_letter, to_letter) {
            (Letter::D, Letter::U) => self.between(from, to).0,
            (Letter::U, Letter::D) => self.between(to, from).1,
            (letter, _) => alike(letter, true),
        };
        let (a, b) = (self.vertices[from].letter, self.vertices[to].letter);
        let edge = match (a, b) {
            (Letter::Either, Letter::Either) => Edge::Open,
            (Letter::Either, _) => by(Letter::U, b).and(by(Letter::D, b)),
            (_, Letter::Either) => by(a, Letter::U).and(by(a, Letter::D)),
            _ => by(a, b),
        };
        if sigma { edge } else { edge.opposite() }
    }

    /// For a D and a U: D → U and U → D, at σ > 0.
    fn between(&self, d: usize, u: usize) -> (Edge, Edge) {
        if self.last == Some((d, u)) {
            return match self.extent {
                Extent::Complete { .. } => (Edge::Yes, Edge::No),
                Extent::Boundary { deciding: Some(Letter::U), .. } => (Edge::Yes, Edge::Open),
                Extent::Boundary { deciding: Some(Letter::D), .. } => (Edge::Open, Edge::No),
                _ => (Edge::Open, Edge::Open),
            };
        }
        let (a, b) = (&self.vertices[d], &self.vertices[u]);
        let determinant =
            u128::from(b.numerator) * u128::from(a.period) - u128::from(a.numerator) * u128::from(b.period);
        let both = if determinant == 1 {
            // Neighbours: the next vertex after both is their mediant.
            self.vertices[d.max(u) + 1..]
                .iter()
                .find(|mediant| mediant.period == a.period + b.period)
                .is_some_and(|mediant| mediant.letter == Letter::U)
        } else {
            d > u
        };
        if both { (Edge::Yes, Edge::Yes) } else { (Edge::No, Edge::No) }
    }

    /// The letters, for reading.
    pub fn letters(&self) -> String {
        self.vertices.iter().map(|vertex| vertex.letter.to_string()).collect()
    }
}

/// Whether a period may follow another with the same letter.
pub(super) fn alike(letter: Letter, sigma: bool) -> Edge {
    match (letter, sigma) {
        (Letter::U, true) | (Letter::D, false) => Edge::Yes,
        (Letter::D, true) | (Letter::U, false) => Edge::No,
        (Letter::Either, _) => Edge::Open,
    }
}

fn limited(limit: usize) -> Result<()> {
    if (1..=MAX_LETTERS).contains(&limit) {
        return Ok(());
    }
    Err(Error::input(format!("a word of {limit} letters: from 1 to {MAX_LETTERS}")))
}

/// Where a walk has its signs from.
pub(crate) trait Signs {
    /// The sign of u_n.
    fn side(&self, n: u64) -> std::result::Result<Sign, Rung>;
    /// The sign of b_{n,k}.
    fn deciding(&self, n: u64, k: u64) -> SignDecision;
    /// Whether period n certainly does not occur though the sign of u_n is open: on a set with points on both
    /// sides of m/n, b_{n,upper} < 0 above s and b_{n,lower} < 0 below it, and u_n = 0 with a₂ < 1 only.
    fn absent(&self, _n: u64, _lower: u64, _upper: u64) -> bool {
        false
    }
    /// What is said of the period whose sign was not decided.
    fn open(&self, next: u64, rung: Rung) -> Extent;
    /// Whether a₂ = 1.
    fn on_circle(&self) -> bool;
    /// The point by its modulus and angle, if it is given so.
    fn polar(&self) -> Option<&Polar>;
}

/// A point, and the ladder that decides there.
pub(crate) struct At<'a> {
    pub ladder: &'a Ladder,
    pub point: &'a Point,
}

impl Signs for At<'_> {
    fn side(&self, n: u64) -> std::result::Result<Sign, Rung> {
        let decision = self.ladder.u_sign(self.point, n);
        match decision.answer {
            Answer::Sign(sign) => Ok(sign),
            Answer::Singular | Answer::Undecided => Err(decision.rung),
        }
    }

    fn deciding(&self, n: u64, k: u64) -> SignDecision {
        self.ladder.sign(self.point, Quantity::B { n, k })
    }

    fn open(&self, next: u64, rung: Rung) -> Extent {
        Extent::Undecided { next, rung }
    }

    fn on_circle(&self) -> bool {
        match self.point {
            Point::Polar(polar) => polar.on_circle(),
            Point::Plane(plane) => plane.a2().is_one(),
        }
    }

    fn polar(&self) -> Option<&Polar> {
        match self.point {
            Point::Polar(polar) => Some(polar),
            Point::Plane(_) => None,
        }
    }
}

impl Signs for Rectangle {
    fn side(&self, n: u64) -> std::result::Result<Sign, Rung> {
        self.u(n).ok_or(Rung::Exact)
    }

    fn deciding(&self, n: u64, k: u64) -> SignDecision {
        SignDecision { answer: self.b(n, k).map_or(Answer::Undecided, Answer::Sign), rung: Rung::Exact }
    }

    fn open(&self, next: u64, _: Rung) -> Extent {
        Extent::Straddled { next }
    }

    fn on_circle(&self) -> bool {
        self.a2()[1].is_one()
    }

    fn polar(&self) -> Option<&Polar> {
        None
    }
}

/// Where in the plane a walk is: in a region or on a line, or on a set that meets several.
///
/// `proofs/words.md`, sections 4 and 10, treats regions 3 and 4 as one, and section 12 the others.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Realm {
    One,
    Two,
    /// |a₁| < a₂ + 1: region 3, or more than one of 2, 3 and 4.
    Inside,
    Four,
    Five,
    /// a₁ = a₂ + 1.
    LineAbove,
    /// a₁ = −(a₂ + 1).
    LineBelow,
    /// Part of that line, or both sides of it.
    AcrossAbove,
    /// The same, and a₁ < a₂ + 1.
    AcrossBelow,
}

impl Realm {
    fn of(plane: &Plane) -> Realm {
        match plane.region() {
            Region::One => Realm::One,
            Region::Two => Realm::Two,
            Region::Three => Realm::Inside,
            Region::Four => Realm::Four,
            Region::Five => Realm::Five,
            Region::Line if plane.a1().is_negative() => Realm::LineBelow,
            Region::Line => Realm::LineAbove,
        }
    }
}

/// A walk down the tree, with the word found so far.
struct Walk<'a> {
    signs: &'a dyn Signs,
    limit: usize,
    monitor: &'a dyn Monitor,
    word: Word,
}

/// A fraction on the path, and its index in the word if its period occurs.
#[derive(Clone, Copy)]
struct End {
    numerator: u64,
    period: u64,
    index: Option<usize>,
}

impl Walk<'_> {
    fn run(mut self, realm: Realm) -> Result<Word> {
        match (realm, self.word.positive) {
            (Realm::One, true) => self.word.fill(Letter::U),
            (Realm::Two, false) | (Realm::Five, true) => self.word.fill(Letter::D),
            // Period 1 alone: c_1 > 0 in region 1 only.
            (Realm::One, false) => self.word.push(0, 1, Letter::U),
            (Realm::Two, true) | (Realm::Four | Realm::Five | Realm::LineBelow, false) => {
                self.word.push(0, 1, Letter::D);
            }
            (Realm::Inside | Realm::AcrossBelow, false) => self.below_half_a_turn()?,
            (Realm::Inside, true) => self.down_to_angle()?,
            (Realm::Four, true) => self.down_to_half(Letter::U, |_, _| Ok(Sign::Positive))?,
            // In region 5 the letter of 2 is D, and all that is said of odd periods is true there.
            (Realm::AcrossBelow, true) if self.signs.side(2) == Ok(Sign::Negative) => {
                self.down_to_half(Letter::Either, |walk, n| walk.signs.side(n))?;
            }
            (Realm::AcrossBelow, true) => {
                self.word.push(0, 1, Letter::D);
                self.word.extent = Extent::Straddled { next: 2 };
            }
            (Realm::AcrossAbove, _) => {
                self.word.push(0, 1, Letter::Either);
                self.word.extent = Extent::Straddled { next: 2 };
            }
            (Realm::LineAbove, _) => {
                self.word.push(0, 1, Letter::Either);
                self.word.extent = Extent::Line;
            }
            (Realm::LineBelow, true) => {
                self.word.push(0, 1, Letter::D);
                self.word.push(1, 2, Letter::Either);
                self.word.extent = Extent::Odd;
            }
        }
        Ok(self.word)
    }

    /// eµ < 0 and a₁ < a₂ + 1: in region 3 the n with 2ns < 1, all D; in region 2 every n, and beyond region
    /// 3 on the left 1 alone. So a period occurs wherever u_1, …, u_n > 0.
    fn below_half_a_turn(&mut self) -> Result<()> {
        // Where the end is open, the periods before it are certain all the same.
        let last = match self.first_above_half_a_turn()? {
            Ok(first) => first.below - 1,
            Err(certain) => certain,
        };
        for n in 1..=last {
            if self.word.vertices.len() == self.limit {
                self.word.extent = Extent::Cut;
                return Ok(());
            }
            self.word.push(0, n, Letter::D);
            self.monitor.advance(1)?;
        }
        Ok(())
    }

    /// Regions 3 and 4, eµ > 0: the path to s, ½ in region 4. In region 2 only its first period occurs, and
    /// u_n is nowhere negative.
    fn down_to_angle(&mut self) -> Result<()> {
        self.word.push(0, 1, Letter::D);
        let Ok(HalfTurn { above, .. }) = self.first_above_half_a_turn()? else { return Ok(()) };
        let lower = End { numerator: 0, period: 1, index: Some(0) };
        if self.word.vertices.len() == self.limit {
            self.word.extent = Extent::Cut;
            return Ok(());
        }
        // For `above` = K the parents are 0/1 and 1/(K − 1), and its b's are positive whatever r is.
        self.word.push(1, above, Letter::U);
        let upper = End { numerator: 1, period: above, index: Some(1) };
        self.descend(lower, upper, |walk, n| walk.signs.side(n))
    }

    /// Region 4 and beside it, eµ > 0: the path to ½, which has every m/n = k/(2k + 1) below it; 2 has this
    /// letter.
    fn down_to_half(
        &mut self,
        two: Letter,
        side: impl Fn(&Self, u64) -> std::result::Result<Sign, Rung>,
    ) -> Result<()> {
        self.word.push(0, 1, Letter::D);
        if self.limit == 1 {
            self.word.extent = Extent::Cut;
            return Ok(());
        }
        self.word.push(1, 2, two);
        let lower = End { numerator: 0, period: 1, index: Some(0) };
        let upper = End { numerator: 1, period: 2, index: Some(1) };
        self.descend(lower, upper, side)
    }

    /// Follows the path below a gap whose ends are in the word, as long as the periods occur. `side` is the
    /// sign of u_n.
    fn descend(
        &mut self,
        mut lower: End,
        mut upper: End,
        side: impl Fn(&Self, u64) -> std::result::Result<Sign, Rung>,
    ) -> Result<()> {
        loop {
            self.monitor.advance(1)?;
            self.word.last = lower.index.zip(upper.index);
            let (Some(n), Some(m)) =
                (lower.period.checked_add(upper.period), lower.numerator.checked_add(upper.numerator))
            else {
                self.word.extent = Extent::Cut;
                return Ok(());
            };
            if self.word.vertices.len() == self.limit {
                self.word.extent = Extent::Cut;
                return Ok(());
            }
            let (letter, deciding) = match side(self, n) {
                // S3: above s the upper parent decides, below it the lower one.
                Ok(Sign::Negative) => (Letter::U, upper.period),
                Ok(Sign::Positive) => (Letter::D, lower.period),
                Ok(Sign::Zero) => {
                    self.word.extent = if self.signs.on_circle() {
                        Extent::Boundary { next: n, deciding: None }
                    } else {
                        Extent::Complete { next: Some(n) }
                    };
                    return Ok(());
                }
                Err(_) if self.signs.absent(n, lower.period, upper.period) => {
                    self.word.extent = Extent::Complete { next: Some(n) };
                    return Ok(());
                }
                Err(rung) => {
                    self.word.extent = self.signs.open(n, rung);
                    return Ok(());
                }
            };
            let decision = self.signs.deciding(n, deciding);
            self.word.extent = match decision.answer {
                Answer::Sign(Sign::Positive) => {
                    let end = End { numerator: m, period: n, index: Some(self.word.vertices.len()) };
                    self.word.push(m, n, letter);
                    *(if letter == Letter::U { &mut upper } else { &mut lower }) = end;
                    continue;
                }
                Answer::Sign(Sign::Negative) => Extent::Complete { next: Some(n) },
                Answer::Sign(Sign::Zero) => Extent::Boundary { next: n, deciding: Some(letter) },
                Answer::Singular | Answer::Undecided => self.signs.open(n, decision.rung),
            };
            return Ok(());
        }
    }

    /// Where 2ns passes 1; if that is not decided, an n up to which 2ns < 1, with the reason in the word.
    fn first_above_half_a_turn(&mut self) -> Result<std::result::Result<HalfTurn, u64>> {
        if let Some(polar) = self.signs.polar() {
            return match polar_half_turn(polar) {
                Some(found) => Ok(Ok(found)),
                None => {
                    self.word.extent = Extent::Cut;
                    // 1/(2s) is beyond 2⁶⁴.
                    Ok(Err(u64::MAX))
                }
            };
        }
        // u_n > 0 as long as 2ns < 1, and from such an n to 2n the sign tells whether 4ns < 1: gallop, then
        // bisect.
        let (mut low, mut high) = (1u64, 2u64);
        let mut zero = None;
        loop {
            self.monitor.advance(0)?;
            match self.signs.side(high) {
                Ok(Sign::Positive) => {
                    low = high;
                    match high.checked_mul(2) {
                        Some(twice) => high = twice,
                        None => {
                            self.word.extent = Extent::Cut;
                            return Ok(Err(low));
                        }
                    }
                }
                Ok(_) => break,
                // A jump may land where nothing is decided; single steps may not.
                Err(_) if high > low + 1 => high = low + 1,
                Err(rung) => {
                    self.word.extent = self.signs.open(high, rung);
                    return Ok(Err(low));
                }
            }
        }
        if self.signs.side(high) == Ok(Sign::Zero) {
            zero = Some(high);
        }
        while high - low > 1 {
            let (mut middle, mut side) = (low + (high - low) / 2, Err(Rung::Exact));
            for at in [middle, low + 1] {
                middle = at;
                side = self.signs.side(at);
                if side.is_ok() {
                    break;
                }
            }
            match side {
                Ok(Sign::Positive) => low = middle,
                Ok(sign) => {
                    high = middle;
                    zero = (sign == Sign::Zero).then_some(middle);
                }
                Err(rung) => {
                    self.word.extent = self.signs.open(middle, rung);
                    return Ok(Err(low));
                }
            }
        }
        Ok(Ok(HalfTurn { below: low + 1, above: if zero == Some(high) { high + 1 } else { high } }))
    }
}

/// The n around 1/(2s).
struct HalfTurn {
    /// The least n with 2ns ≥ 1.
    below: u64,
    /// K = ⌊1/(2s)⌋ + 1, the least n with 2ns > 1.
    above: u64,
}

fn polar_half_turn(polar: &Polar) -> Option<HalfTurn> {
    let (quotient, rest) = polar.s().denom().div_rem(&(polar.s().numer() * BigInt::from(2)));
    let floor = quotient.to_u64()?;
    let above = floor.checked_add(1)?;
    Some(HalfTurn { below: if rest == BigInt::ZERO { floor } else { above }, above })
}

impl Vertex {
    /// m/n.
    pub fn fraction(&self) -> Ratio<u64> {
        Ratio::new(self.numerator, self.period)
    }
}
