//! Certificates of kind `entropy`: how much chaos a grazing bifurcation can give birth to, for eµ > 0.
//!
//! # What is proved, and how
//!
//! By the word theorem the periods between impacts at (r, s), r ≤ 1, in region 3 and eµ > 0 are an initial
//! piece of the path of the Stern–Brocot tree from 0/1 and 1/2 to s, without the 1/k with 2ks ≤ 1: first 1
//! (D) and K = ⌊1/(2s)⌋ + 1 (U), then the denominators of mediants, U above s and D below. Which may follow
//! which is a function of the letters (`graph`). With M(z)_ij = zⁿ, n the period j, where j may follow i,
//! the topological entropy exceeds −log z if and only if M(z) has a spectral radius above 1. So it is below
//! −log z if some v > 0 has M(z) v < v, and then it is for every smaller z.
//!
//! *Words with one beginning* (`bound`). Let i, D, and j, U, be the last two neighbours of the letters
//! listed. All later periods are at least i + j, and each exceeds the one before by at least min(i, j):
//! their zⁿ add up to at most t = z^(i+j)/(1 − z^min(i,j)). Put one vertex of weight t for them, joined both
//! ways to all and to itself, and join i and j both ways. If this matrix passes, so does every word that
//! begins so or ends there. Its entries fall with K, so that one bound of the words with K = L and no letter
//! is one for all K ≥ L.
//!
//! *Words that end* (`ends`): the last pair has the edge D → U for γ > 0, U → D for γ < 0.
//!
//! *The words left over* begin with one infinite word, DDD… for γ < 0 and UDUUU… for γ > 0, K = 2, whose own
//! equation is κ(z)S(z) = 1:
//!
//! ```text
//! γ < 0     κ = 1 + z²,   S = z/(1 − z²),                      that is z + z² + z³ = 1
//! γ > 0     κ = 1 + z⁴,   S = z³/(1 − z⁴) + z²/(1 − z³)
//! ```
//!
//! A word that ends on this path has fewer vertices and no more edges. One that leaves it, after a ≥ 6
//! letters D, or a ≥ 4 letters U after UD, has its next letter at the period b + c, with b = 2a + 1, c = 2
//! or b = 4a + 3, c = 4. With e = z^(b+c), α = 1/(1 − z^c) and R ≤ z^(2b+c)/(1 − z^b) for all that comes
//! later, its radius is below 1 if (S − αe + R)(κ + e + R) < 1, where at the root Sκ = 1 and S = 1/κ. The
//! product is at most 1 − e(ακ − 1/κ) + R(κ + 1/κ + e + R). So what is checked is
//!
//! ```text
//! ακ − 1/κ > q (κ + 1/κ + e + R),   q = z^b/(1 − z^b) ≥ R/e,
//! ```
//!
//! at the least a; both sides of it are monotone in z, and the right one falls with a. In regions 2 and 4
//! with real eigenvalues the graphs are among these; in regions 1 and 5 every period is born, and the
//! entropy is log 2 in one case: they are left out.
//!
//! # Form
//!
//! ```text
//! statement …                     after the kind line: what passing proves, word for word: STATEMENT
//! case + -                        γ < 0; then the same of case + +
//! root P/Q P/Q                    fractions with Q ≤ 100000: the root lies strictly between them
//! first K                         K = 2, 3, … up to 16; of the last one, the words with larger K too
//! bound WORD V V …                words that begin with these letters (`-` for none); the entries of v, from
//!                                 1 to 10⁶, for 1, K, the letters' periods, and the later ones
//! ends WORD V V …                 the word that ends after these letters; v for 1, K and the letters'
//!                                 periods
//! ```
//!
//! Lines come in the order of a walk: at each word either a `bound`, or nothing, if it is one of those left
//! over; else `ends`, if it does not begin the infinite word, and then the words with one letter more, first
//! U, then D. As 1/(2K) < s ≤ 1/(2K − 2), the period k of a word U…U has the letter U for k ≤ 2K − 2 and D
//! for k = 2K. Words have at most 16 letters. The last `first` of a case has one line, `bound -`.
//!
//! Powers of z are multiples of 2⁻⁶⁰, rounded up (in `root` and κ also down).
//!
//! # A line by hand
//!
//! `bound - 8 7 8` after `first 3` in `case + -`, z = 0.54369: the weights are z = 0.54369, z³ = 0.16071 and
//! t = z⁴/(1 − z) = 0.19149. For γ < 0 period 1 may follow itself, 3 may not, and 1 and 3 follow each other.
//! So the entries of Mv are 8·0.54369 + 7·0.16071 + 8·0.19149 = 7.0064 < 8, 8·0.54369 + 8·0.19149 = 5.8814 <
//! 7, and 7.0064 < 8 once more. Were the line `bound - 8 5 8`, the checker would answer: `false: the entry 2
//! of M v is not below that of v`.
//!
//! # Cost
//!
//! A line of L letters takes L² additions and, for a period n, n products of 128-bit integers. Memory: one
//! line.

mod fixed;
mod graph;

use fixed::{Powers, bounded};
use graph::{Graph, Letter};

use super::{
    Proved, Rejection,
    arithmetic::Fraction,
    header::expect_statement,
    lines::{Lines, Words},
};
use crate::rejection::ensure;

/// The word in the header.
pub const KIND: &str = "entropy";

/// What a certificate of this kind proves.
pub const STATEMENT: &str = "Let 0 < r <= 1, 0 < s < 1/2 and e mu > 0, and take the graph of which period may certainly \
follow which between impacts. If the word theorem holds, as stated and proved in the folder proofs of the project and not \
here, then its topological entropy per forcing period is at most -log z with z + z^2 + z^3 = 1, 0 < z < 1, in case + - \
(gamma < 0), and at most -log z with (1 + z^4)(z^3/(1 - z^4) + z^2/(1 - z^3)) = 1, 0 < z < 1, in case + + (gamma > 0). Each \
z lies strictly between the two listed fractions.";

/// The largest denominator of a bound of z.
const DENOMINATOR: u64 = 100_000;
/// The largest K.
const FIRST: u64 = 16;
/// The most letters of a word.
const LETTERS: usize = 16;
/// The largest entry of a vector.
const ENTRY: u64 = 1_000_000;

/// One sign of γ.
struct Case {
    positive: bool,
    /// Powers of the bounds of the root.
    low: Powers,
    high: Powers,
}

/// Checks everything after the kind line.
pub(super) fn check(lines: &mut Lines) -> Result<Proved, Rejection> {
    expect_statement(lines, STATEMENT)?;
    let mut detail = Vec::new();
    let mut line = lines.expect("a case")?;
    for positive in [false, true] {
        let (sign, name) = if positive { ("+", "case + +") } else { ("-", "case + -") };
        lines.form(line == format!("case + {sign}"), format_args!("expected a line \"case + {sign}\""))?;
        let text = lines.expect("the bounds of the root")?;
        let [low, high] = root(&text).map_err(|reason| lines.malformed(reason))?;
        ascend(low, high).map_err(|reason| lines.false_claim(reason))?;
        let case = Case { positive, low: Powers::new(low), high: Powers::new(high) };
        case.root_between().map_err(|reason| lines.false_claim(reason))?;
        case.leftovers().map_err(|reason| lines.false_claim(reason))?;
        let mut next = Some(lines.expect("\"first 2\"")?);
        let mut bounds = 0;
        let mut first = 2;
        loop {
            let holds = next.as_deref() == Some(format!("first {first}").as_str()) && first <= FIRST;
            lines.form(holds, format_args!("expected a line \"first {first}\", at most {FIRST}"))?;
            next = lines.next()?;
            let root = next.as_deref().is_some_and(|line| line.starts_with("bound - "));
            case.walk(first, &mut Vec::new(), &mut next, &mut bounds, lines)?;
            if root {
                break;
            }
            first += 1;
        }
        detail.push((
            name,
            format!("{low} < z < {high}; {bounds} bounds of words, the last of every K >= {first}"),
        ));
        match (positive, next) {
            (false, Some(found)) => line = found,
            (false, None) => {
                line = lines.expect("\"case + +\"")?;
            }
            (true, None) => {}
            (true, Some(_)) => return Err(lines.malformed("the file goes on after its last bound")),
        }
    }
    Ok(Proved::plain(None, detail))
}

/// Reads `root P/Q P/Q`.
fn root(line: &str) -> Result<[Fraction; 2], String> {
    let mut words = Words::new(line);
    ensure(words.word("root")? == "root", "expected a line \"root P/Q P/Q\"")?;
    let found = [words.fraction(DENOMINATOR)?, words.fraction(DENOMINATOR)?];
    words.end()?;
    Ok(found)
}

/// Whether the bounds are where all numbers below stay small.
fn ascend(low: Fraction, high: Fraction) -> Result<(), String> {
    let third = Fraction::new(1, 3).expect("1/3 is in lowest terms");
    let most = Fraction::new(3, 4).expect("3/4 is in lowest terms");
    if third.less(low) && low.less(high) && high.less(most) {
        return Ok(());
    }
    Err("the bounds do not ascend between 1/3 and 3/4".into())
}

impl Case {
    /// The powers of z with a given exponent that κ, b and the path have: c.
    fn exponent(&self) -> u64 {
        if self.positive { 4 } else { 2 }
    }

    /// κS − 1 rises with z: it is below 0 at the lower bound, above 0 at the upper one.
    fn root_between(&self) -> Result<(), String> {
        let value = |powers: &Powers, up: bool| {
            let z = |n| powers.power(n, up);
            let sum = match self.positive {
                false => fixed::quotient(z(1), fixed::rest(powers.power(2, up)), up),
                true => {
                    fixed::quotient(z(3), fixed::rest(powers.power(4, up)), up)
                        + fixed::quotient(z(2), fixed::rest(powers.power(3, up)), up)
                }
            };
            fixed::product(fixed::ONE + z(self.exponent()), sum, up)
        };
        ensure(value(&self.low, true) < fixed::ONE, "the first bound is not certainly below the root")?;
        ensure(value(&self.high, false) > fixed::ONE, "the second bound is not certainly above the root")
    }

    /// The words that leave the infinite one late.
    fn leftovers(&self) -> Result<(), String> {
        let c = self.exponent();
        let b = if self.positive { 4 * 4 + 3 } else { 2 * 6 + 1 };
        let (low, high) = (&self.low, &self.high);
        let kappa = [fixed::ONE + low.power(c, false), fixed::ONE + high.power(c, true)];
        let alpha = fixed::quotient(fixed::ONE, fixed::rest(low.power(c, false)), false);
        let inverse = fixed::quotient(fixed::ONE, kappa[0], true);
        let left = fixed::product(alpha, kappa[0], false) - inverse;
        let q = fixed::quotient(high.power(b, true), fixed::rest(high.power(b, true)), true);
        let e = high.power(b + c, true);
        let rest = fixed::product(q, e, true);
        let right = fixed::product(q, kappa[1] + inverse + e + rest, true);
        ensure(left > right, "the words that leave the infinite one late are not bounded")
    }

    /// Whether these letters begin the infinite word of K = `first`.
    fn on_path(&self, first: u64, word: &[Letter]) -> bool {
        let expected = |place| match (self.positive, place) {
            (false, _) | (true, 1) => Letter::D,
            (true, _) => Letter::U,
        };
        // With one period more than UD the graph of U is none of a part: that word has its own line.
        let long_enough = !self.positive || word.len() >= 2;
        first == 2 && long_enough && word.iter().enumerate().all(|(place, letter)| *letter == expected(place))
    }

    /// Whether words that begin so are left over, or all of them but those that go on along the path are.
    fn is_left_over(&self, first: u64, word: &[Letter]) -> bool {
        word.len() >= 6 && self.on_path(first, word)
    }

    /// Checks the words that begin with `word`. `next` is the line not used yet.
    fn walk(
        &self,
        first: u64,
        word: &mut Vec<Letter>,
        next: &mut Option<String>,
        bounds: &mut u64,
        lines: &mut Lines,
    ) -> Result<(), Rejection> {
        if self.is_left_over(first, word) {
            return Ok(());
        }
        let name = graph::name(word);
        let Some(line) = next.take() else {
            lines.expect(&format!("a bound of the words {name}"))?;
            return Err(lines.malformed("the file ends early"));
        };
        let mut graph = Graph::new(first, word, self.positive);
        let begins = |what: &str| line.starts_with(&format!("{what} {name} "));
        if begins("bound") {
            graph.close(&self.high);
            self.entries(&graph, &line, lines)?;
            *bounds += 1;
            *next = lines.next()?;
            return Ok(());
        }
        lines.form(word.len() < LETTERS, format_args!("expected a bound of the words {name}"))?;
        if self.on_path(first, word) {
            *next = Some(line);
        } else if begins("ends") {
            graph.end(&self.high);
            self.entries(&graph, &line, lines)?;
            *next = lines.next()?;
        } else {
            return Err(lines.malformed(format!("expected a line \"bound {name} …\" or \"ends {name} …\"")));
        }
        // The period of the next letter, where the word is U…U.
        let run = word.iter().all(|letter| *letter == Letter::U).then(|| first + 1 + word.len() as u64);
        for letter in [Letter::U, Letter::D] {
            let possible = match letter {
                Letter::U => run != Some(2 * first),
                Letter::D => run.is_none_or(|k| k > 2 * first - 2),
            };
            if possible {
                word.push(letter);
                self.walk(first, word, next, bounds, lines)?;
                word.pop();
            }
        }
        Ok(())
    }

    /// Checks M v < v with the entries that follow the first two words of a line.
    fn entries(&self, graph: &Graph, line: &str, lines: &Lines) -> Result<(), Rejection> {
        let mut words = Words::new(line);
        let mut read = || -> Result<Vec<u64>, String> {
            words.word("bound or ends")?;
            words.word("the letters")?;
            let mut all = Vec::new();
            for _ in 0..graph.size() {
                all.push(words.number("an entry of v", ENTRY)?);
            }
            words.end()?;
            Ok(all)
        };
        let v = read().map_err(|reason| lines.malformed(reason))?;
        bounded(graph.size(), |i, j| graph.entry(i, j), &v)
            .map_err(|i| lines.false_claim(format!("the entry {} of M v is not below that of v", i + 1)))
    }
}
