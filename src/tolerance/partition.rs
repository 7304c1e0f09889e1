//! A box cut into cells on which the words are known, and the share of it in which a statement holds.

use std::{
    cmp::Reverse,
    collections::{BTreeMap, HashSet},
};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use super::{
    cell::{Cell, LONGEST, Turn},
    normal::NormalParameters,
    parameters::ParameterBox,
};
use crate::{
    error::{Error, Result},
    existence::Case,
    monitor::Monitor,
    number::Sign,
    word::{Edge, Extent, Letter, Relation, Word},
};

/// A cell is not halved more often than this, so that shares are whole numbers of 2⁻⁶².
pub(super) const DEEPEST: u32 = 62;

/// The most letters of a word on a cell.
const LETTERS: usize = 64;

/// So many halvings earlier than others comes a cell on which it is open whether chaos is born.
const HEADSTART: u32 = 3;

/// A cell of a partition, with what is the same at all of its points.
#[derive(Debug, Clone)]
pub struct Leaf {
    /// The cell.
    pub cell: ParameterBox,
    /// Its share of the box is 2^−`depth`.
    pub depth: u32,
    /// How much it counts, at least, in units of 2^−`DEEPEST`.
    part: u64,
    /// What the words for eµ > 0 and eµ < 0 have in common.
    pub words: [Word; 2],
    /// Whether γ > 0, where that is a function of the parameters and the same at all points.
    pub gamma: Option<bool>,
    /// The angle, if there is one.
    turn: Option<Turn>,
    /// Whether chaos is born for eµ > 0 where γ > 0, and where γ < 0.
    ahead: [Option<bool>; 2],
    /// Of each word the periods that may go on from it, where no other does.
    beyond: [Option<Vec<u64>>; 2],
}

/// What may hold at a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Statement<'a> {
    /// Two single-impact periods coexist in the case, so that chaos is born (W6).
    Chaos(Case),
    /// The same for a sign of eµ and the machine's own γ.
    ChaosAt {
        /// Whether eµ > 0.
        positive: bool,
    },
    /// Period n can occur between impacts.
    Period {
        /// Whether eµ > 0.
        positive: bool,
        /// n.
        n: u64,
    },
    /// An orbit of period n with one impact exists in the case.
    Orbit {
        /// The case.
        case: Case,
        /// n.
        n: u64,
    },
    /// The same for a sign of eµ and the machine's own γ.
    OrbitAt {
        /// Whether eµ > 0.
        positive: bool,
        /// n.
        n: u64,
    },
    /// Both periods occur, and `to` may follow `from`.
    Follows {
        /// The case.
        case: Case,
        /// The earlier period.
        from: u64,
        /// The later one.
        to: u64,
    },
    /// This is the word for its sign of eµ.
    Word(&'a Word),
}

/// What can be said of a statement on a box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spread {
    /// It holds at every point.
    Everywhere,
    /// It holds at no point.
    Nowhere,
    /// It holds at some points and does not at others.
    Differs,
    /// None of the three is certain.
    Open,
}

impl Spread {
    /// Its word in reports.
    pub fn word(self) -> &'static str {
        match self {
            Spread::Everywhere => "everywhere",
            Spread::Nowhere => "nowhere",
            Spread::Differs => "differs",
            Spread::Open => "open",
        }
    }
}

/// The share of a box in which a statement certainly holds, that in which it certainly does not, and where.
#[derive(Debug, Clone, PartialEq)]
pub struct Share {
    /// At least this share of the box has it.
    pub lower: BigRational,
    /// At most this share has it.
    pub upper: BigRational,
    /// A point of the largest cell on which it holds, in few decimals.
    pub with: Option<Vec<BigRational>>,
    /// A point of the largest cell on which it does not.
    pub without: Option<Vec<BigRational>>,
    /// Whether it is open on some cell.
    pub open: bool,
}

impl Share {
    /// What is certain of all points of the box.
    pub fn spread(&self) -> Spread {
        match (&self.with, &self.without) {
            (Some(_), Some(_)) => Spread::Differs,
            _ if self.open => Spread::Open,
            (_, None) => Spread::Everywhere,
            (None, _) => Spread::Nowhere,
        }
    }
}

/// A box and its cells.
#[derive(Debug, Clone)]
pub struct Partition {
    leaves: Vec<Leaf>,
    /// What all of it counts.
    whole: u64,
    cells: u64,
    cut: bool,
}

impl Partition {
    /// Halves the box, then the largest cell on which something is open, and so on, until nothing is that can
    /// become certain, or `limit` cells were looked at. The same on every machine.
    ///
    /// Cost: O(`limit`) cells, each with the signs of two words. `monitor` is told of every cell.
    ///
    /// # Errors
    /// The monitor's interruption.
    pub fn new(of: &ParameterBox, limit: u64, monitor: &dyn Monitor) -> Result<Partition> {
        Partition::weighted(of, None, limit, monitor)
    }

    /// The same where the parts of the box count by a normal distribution, if there is one, and what lies
    /// beyond the box counts as open. What counts most is halved first.
    ///
    /// # Errors
    /// The monitor's interruption.
    pub fn weighted(
        of: &ParameterBox,
        normal: Option<&NormalParameters>,
        limit: u64,
        monitor: &dyn Monitor,
    ) -> Result<Partition> {
        let mut settled = Vec::new();
        // By rank, then by age.
        let mut open = BTreeMap::new();
        let mut cells = 0;
        let mut next = vec![(of.clone(), 0)];
        loop {
            for (cell, depth) in next.drain(..) {
                monitor.advance(1)?;
                cells += 1;
                let (mut leaf, axis) = Leaf::new(cell, depth)?;
                if let Some(normal) = normal {
                    leaf.part = normal.part(&leaf.cell);
                }
                match axis {
                    Some(axis) => {
                        // In halvings of what counts; of the box, if every part counts alike.
                        let halvings = DEEPEST - leaf.part.checked_ilog2().unwrap_or(0);
                        let rank = halvings + if leaf.is_chaos_open() { 0 } else { HEADSTART };
                        open.insert((rank, cells), (leaf, axis));
                    }
                    None => settled.push(leaf),
                }
            }
            if cells + 2 > limit {
                break;
            }
            let Some((_, (leaf, axis))) = open.pop_first() else { break };
            next.extend(leaf.cell.halves(axis).map(|half| (half, leaf.depth + 1)));
        }
        let cut = !open.is_empty();
        let mut leaves = settled;
        leaves.extend(open.into_values().map(|(leaf, _)| leaf));
        leaves.sort_by_key(|leaf| Reverse(leaf.part));
        Ok(Partition { leaves, whole: 1 << DEEPEST, cells, cut })
    }

    /// Samples, each of which counts alike: shares are those of the samples, and no bound of any other.
    ///
    /// # Errors
    /// An input error if there is none; the monitor's interruption.
    pub fn of_samples(samples: &[ParameterBox], monitor: &dyn Monitor) -> Result<Partition> {
        let whole = samples.len() as u64;
        if whole == 0 {
            return Err(Error::input("no samples"));
        }
        let leaf = |of: &ParameterBox| {
            monitor.advance(1)?;
            Ok(Leaf { part: 1, ..Leaf::new(of.clone(), 0)?.0 })
        };
        let leaves = samples.iter().map(leaf).collect::<Result<_>>()?;
        Ok(Partition { leaves, whole, cells: whole, cut: false })
    }

    /// The cells, the one that counts most first.
    pub fn leaves(&self) -> &[Leaf] {
        &self.leaves
    }

    /// How many cells were looked at, those that were halved included.
    pub fn cells(&self) -> u64 {
        self.cells
    }

    /// Whether cells are left that were not halved for want of more: more of them might tell more.
    pub fn is_cut(&self) -> bool {
        self.cut
    }

    /// The share of the box in which a statement holds, every part of the box counting by its size. Cost:
    /// that of one look at each cell.
    pub fn share(&self, statement: Statement) -> Share {
        self.share_by(|leaf| leaf.holds(statement))
    }

    /// The same of anything that may be true on a cell, false, or open.
    pub(super) fn share_by(&self, holds: impl Fn(&Leaf) -> Option<bool>) -> Share {
        let mut sums = [0u64; 2];
        let mut at = [None, None];
        let mut open = false;
        for leaf in &self.leaves {
            let Some(holds) = holds(leaf) else {
                open = true;
                continue;
            };
            let side = usize::from(!holds);
            sums[side] += leaf.part;
            at[side].get_or_insert_with(|| leaf.cell.short_point());
        }
        let whole = BigInt::from(self.whole);
        let [lower, rest] = sums.map(|sum| BigRational::new(sum.into(), whole.clone()));
        let [with, without] = at;
        Share { lower, upper: BigRational::one() - rest, with, without, open }
    }

    /// The different words for a sign of eµ that are whole on some cell, the one with the largest share
    /// first, each with its share. Cost: O(W L), W words, L cells.
    pub fn words(&self, positive: bool) -> Vec<(Word, Share)> {
        let mut found: Vec<&Word> = Vec::new();
        let mut known = HashSet::new();
        for word in self.leaves.iter().map(|leaf| leaf.word(positive)).filter(|word| word.is_whole()) {
            if known.insert(spelling(word)) {
                found.push(word);
            }
        }
        let mut found: Vec<(Word, Share)> =
            found.into_iter().map(|word| (word.clone(), self.share(Statement::Word(word)))).collect();
        found.sort_by(|a, b| b.1.lower.cmp(&a.1.lower));
        found
    }

    /// The cell that counts most of those on which a word is open, or γ.
    pub fn open(&self) -> Option<&Leaf> {
        self.leaves.iter().find(|leaf| !leaf.is_settled())
    }

    /// The share of the box on which the words for both signs of eµ, and γ if the box has one, are certain.
    pub fn settled(&self) -> BigRational {
        self.share_by(|leaf| leaf.is_settled().then_some(true)).lower
    }
}

/// What tells words apart: where they end on the same letters, they end.
fn spelling(word: &Word) -> (Vec<(u64, Letter)>, bool) {
    (word.vertices().iter().map(|vertex| (vertex.period, vertex.letter)).collect(), word.is_endless())
}

impl Leaf {
    /// What is certain on a cell, and across which parameter to halve it if there is hope of more.
    pub(crate) fn new(cell: ParameterBox, depth: u32) -> Result<(Leaf, Option<usize>)> {
        let signs = Cell::new(&cell);
        let word = |positive| Word::of_set(&signs, signs.realm(), positive, LETTERS, &());
        // The axis is that of the last open sign: eµ > 0 comes last.
        let behind = word(false)?;
        let ahead = word(true)?;
        let axis = cell.wide_axis(signs.axis());
        let words = [ahead, behind];
        let ahead = [true, false].map(|gamma| signs.chaos_ahead(gamma));
        let beyond = [beyond_ahead(&signs, &words[0]), beyond_behind(&signs, &words[1])];
        let part = 1 << (DEEPEST - depth);
        let leaf = Leaf { gamma: signs.gamma, words, depth, part, turn: signs.turn(), cell, ahead, beyond };
        let hope = |word: &Word| matches!(word.extent(), Extent::Straddled { next } if next <= LONGEST);
        let open = leaf.is_gamma_open() || leaf.words.iter().any(hope);
        let can = depth < DEEPEST && !leaf.cell.is_point();
        Ok((leaf, (open && can).then_some(axis)))
    }

    /// Whether the cell has a γ of its own whose sign is not certain.
    pub fn is_gamma_open(&self) -> bool {
        self.cell.has_gamma() && self.gamma.is_none()
    }

    /// Whether its words are whole, and γ is known if the box has one.
    pub fn is_settled(&self) -> bool {
        !self.is_gamma_open() && self.words.iter().all(Word::is_whole)
    }

    /// What is not certain on it, in words, `side` being what a sign of eµ is called; none if all is.
    pub fn why_open(&self, side: impl Fn(bool) -> &'static str) -> Option<String> {
        if self.is_gamma_open() {
            return Some("gamma may be 0".into());
        }
        let sides = [true, false].into_iter().filter(|&positive| !self.word(positive).is_whole());
        let why = sides.map(|positive| {
            let why = match self.word(positive).extent() {
                Extent::Straddled { next } => format!("whether period {next} occurs"),
                Extent::Cut => "how a long word goes on".into(),
                _ => "where the theory is silent".into(),
            };
            format!("{why}, {}", side(positive))
        });
        let all = why.collect::<Vec<_>>().join("; ");
        (!all.is_empty()).then_some(all)
    }

    fn is_chaos_open(&self) -> bool {
        let open = |statement| self.holds(statement).is_none();
        if self.cell.has_gamma() {
            return [true, false].into_iter().any(|positive| open(Statement::ChaosAt { positive }));
        }
        CASES.into_iter().any(|case| open(Statement::Chaos(case)))
    }

    /// The word for a sign of eµ.
    pub fn word(&self, positive: bool) -> &Word {
        &self.words[usize::from(!positive)]
    }

    /// Whether a statement holds at all points, or at none.
    pub fn holds(&self, statement: Statement) -> Option<bool> {
        match statement {
            Statement::Chaos(case) => self.is_chaotic(case),
            Statement::ChaosAt { positive } => self.own(positive, |case| self.is_chaotic(case)),
            Statement::Period { positive, n } => self.letter(positive, n).map(|letter| letter.is_some()),
            Statement::Orbit { case, n } => self.has_orbit(case, n),
            Statement::OrbitAt { positive, n } => self.own(positive, |case| self.has_orbit(case, n)),
            Statement::Follows { case, from, to } => self.follows(case, from, to),
            Statement::Word(word) => self.is_word(word),
        }
    }

    /// What holds for the machine's own γ.
    fn own(&self, positive: bool, holds: impl Fn(Case) -> Option<bool>) -> Option<bool> {
        let by = |gamma| holds(case_of(positive, gamma));
        match self.gamma {
            Some(gamma) => by(gamma),
            None => None,
        }
    }

    /// The letter of period n, none if it does not occur.
    pub(crate) fn letter(&self, positive: bool, n: u64) -> Option<Option<Letter>> {
        let word = self.word(positive);
        let listed = match word.is_endless() {
            true => word.up_to(n).pop().filter(|vertex| vertex.period == n),
            false => word.vertices().iter().find(|vertex| vertex.period == n).copied(),
        };
        let beyond = self.beyond[usize::from(!positive)].as_ref();
        // Beyond a₁ = −(a₂+1) all periods occur.
        let across = has_either(word);
        match (listed, word.extent()) {
            (Some(vertex), _) => Some(Some(vertex.letter)),
            (None, _) if word.is_whole() => Some(None),
            // What else may occur comes later on the path, and has a larger denominator.
            (None, Extent::Straddled { next }) if n < next && !across => Some(None),
            (None, _) if beyond.is_some_and(|beyond| !beyond.contains(&n)) => Some(None),
            _ => None,
        }
    }

    fn has_orbit(&self, case: Case, n: u64) -> Option<bool> {
        let positive = case.sign_emu() > 0;
        let Some(found) = self.letter(positive, n) else {
            // Its letter would be that of its side of s, and for eµ < 0 it would be D.
            let turn = self.turn?;
            let upper = positive && turn.sign(n)? == Sign::Negative;
            return (upper != (wanted(case) == Letter::U)).then_some(false);
        };
        match (found, wanted(case)) {
            (None, _) => Some(false),
            (Some(Letter::Either), _) => None,
            (Some(letter), wanted) => Some(letter == wanted),
        }
    }

    /// Two loops make chaos, and nothing else does.
    fn is_chaotic(&self, case: Case) -> Option<bool> {
        let word = self.word(case.sign_emu() > 0);
        let wanted = wanted(case);
        let loops = word.vertices().iter().filter(|vertex| vertex.letter == wanted).count();
        let endless = word.is_endless() && word.vertices().first().is_some_and(|v| v.letter == wanted);
        if loops > 1 || endless {
            return Some(true);
        }
        // For eµ < 0 and a₁ < a₂ + 1 all letters are D.
        let lower =
            case == Case::MinusMinus && word.vertices().first().is_some_and(|v| v.letter == Letter::D);
        if word.is_whole() || lower {
            return Some(false);
        }
        match case {
            Case::PlusPlus => self.ahead[0],
            Case::PlusMinus => self.ahead[1],
            _ => None,
        }
    }

    fn follows(&self, case: Case, from: u64, to: u64) -> Option<bool> {
        let positive = case.sign_emu() > 0;
        if self.letter(positive, from)?.is_none() || self.letter(positive, to)?.is_none() {
            return Some(false);
        }
        let relation = Relation::new(self.word(positive), case.sign_gamma() > 0, false, from.max(to)).ok()?;
        match relation.edge(from, to) {
            Edge::Yes => Some(true),
            Edge::No => Some(false),
            Edge::Open => None,
        }
    }

    fn is_word(&self, other: &Word) -> Option<bool> {
        let word = self.word(other.is_positive());
        let ((mine, endless), (its, its_endless)) = (spelling(word), spelling(other));
        if word.is_whole() {
            return Some(mine == its && endless == its_endless);
        }
        let begins = its.len() >= mine.len() && its[..mine.len()] == mine[..];
        let beyond = self.beyond[usize::from(!other.is_positive())].as_ref();
        if begins && beyond.is_some_and(|beyond| its[mine.len()..].iter().any(|(n, _)| !beyond.contains(n))) {
            return Some(false);
        }
        (!begins && !its_endless && !mine.iter().any(|(_, letter)| *letter == Letter::Either))
            .then_some(false)
    }
}

fn has_either(word: &Word) -> bool {
    word.vertices().iter().any(|vertex| vertex.letter == Letter::Either)
}

/// How many periods are looked at beyond the end of a word.
const BEYOND: usize = 4;

/// For eµ > 0: the path goes on as s says, and V is an initial piece of it, so that it ends with the first
/// period that certainly does not occur, though one before it is open.
fn beyond_ahead(signs: &Cell, word: &Word) -> Option<Vec<u64>> {
    let Extent::Straddled { next } = word.extent() else { return None };
    if has_either(word) {
        return None;
    }
    let last = |letter| word.vertices().iter().rev().find(|v| v.letter == letter).map(|v| v.period);
    let (mut lower, mut upper) = (last(Letter::D)?, last(Letter::U)?);
    debug_assert_eq!(next, lower + upper);
    let mut beyond = Vec::new();
    while beyond.len() < BEYOND {
        let n = lower + upper;
        if n > LONGEST || signs.occurs(n, lower, upper) == Some(false) {
            return (n <= LONGEST).then_some(beyond);
        }
        beyond.push(n);
        match signs.u(n)? {
            Sign::Negative => upper = n,
            _ => lower = n,
        }
    }
    None
}

/// For eµ < 0: V⁻ holds n with 2ns < 1 only, and 2ns > 1 where u_n < 0.
fn beyond_behind(signs: &Cell, word: &Word) -> Option<Vec<u64>> {
    let Extent::Straddled { next } = word.extent() else { return None };
    let all_lower = word.vertices().iter().all(|vertex| vertex.letter == Letter::D);
    let end = (next..next + BEYOND as u64).find(|&n| signs.u(n) == Some(Sign::Negative));
    end.filter(|_| all_lower).map(|end| (next..end).collect())
}

/// All four.
pub(super) const CASES: [Case; 4] = [Case::PlusPlus, Case::PlusMinus, Case::MinusPlus, Case::MinusMinus];

pub(super) fn case_of(positive: bool, gamma: bool) -> Case {
    match (positive, gamma) {
        (true, true) => Case::PlusPlus,
        (true, false) => Case::PlusMinus,
        (false, true) => Case::MinusPlus,
        (false, false) => Case::MinusMinus,
    }
}

/// The letter of the periods that have an orbit with one impact, a loop: σ c_n > 0.
fn wanted(case: Case) -> Letter {
    if (case.sign_emu() > 0) == (case.sign_gamma() > 0) { Letter::U } else { Letter::D }
}
