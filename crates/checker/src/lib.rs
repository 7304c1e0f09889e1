//! Certificates: their text format, and the checker that re-proves them. **This package is the trusted
//! code.**
//!
//! It depends on nothing but `std`: it has its own integers, fractions, signs, intervals and modular
//! inverses, so that a fault in what finds a proof cannot hide in what checks it. A certificate that passes
//! proves the statement in its header to whoever trusts this package, the Rust compiler and standard library,
//! and the machine. There is no search in here and nothing is taken on faith from the file.
//!
//! An overflow is a panic, in release builds too (the workspace's manifest asks for it;
//! `grazing-check --overflow` shows it), and a panic is no verdict. Functions that are generic or `#[inline]`
//! would follow their caller's settings instead, so the entry points, [`check`], [`check_until`] and
//! [`cover::check_block`], are neither.
//!
//! # Format
//!
//! A certificate is text: lines that end with a line feed, with a carriage return and a line feed, or, the
//! last one, with the file. A line has at most 1000 bytes without its end, where its kind does not say
//! otherwise. Words are separated by one space; none leads or trails. Every line must be read: a blank one at
//! the end is one too many.
//!
//! ```text
//! grazing-certificate 1                the format and its version
//! kind KIND                            one of those in the table below, with its version above 1; the rest
//!                                      is the kind's own
//! statement …                          in every kind, after the lines that its form lists: what passing
//!                                      proves, word for word
//! ```
//!
//! Where a form says *number*, it is a decimal integer from 0 up without leading zeros, `0|[1-9][0-9]*`. A
//! *fraction* `P/Q` is two of these in lowest terms, with P ≤ Q and 0 < Q, so that zero is `0/1` and one
//! `1/1`. A *decimal* is `-?(0|[1-9][0-9]*)(\.[0-9]*[1-9])?`, but not `-0`, of at most 34 digits: every
//! number has one form. A file that is not exactly of its form is malformed, one with a claim that fails is
//! false; both are rejected.
//!
//! | kind | proves | its form, rules, limits and cost |
//! | --- | --- | --- |
//! | `theorem2` | Theorem 2, on r = 1, for a range of periods | [`theorem2`], with a block by hand |
//! | `cover` | Conjecture 1 for a range of periods, r ≤ r_max < 1 | [`cover`], with a block by hand |
//! | `word` | at a point (a₁, a₂) or in a box: which periods can occur between impacts, up to a last one, and which may follow which | [`word`], two by hand |
//! | `word-by-theorem` | the signs that the word theorem asks for there, and so all periods | [`word`] |
//! | `orbit`, `orbit 2`, `orbit 3` | that a periodic orbit of an oscillator exists, is unique in a box, admissible, stable or not; 2: for all coefficients in intervals; 3: the same of the motion without impacts, which is clear of every wall | [`orbit`] |
//! | `event`, `event 2` | that such an orbit bifurcates (saddle-node, flip) or grazes at a parameter in an interval; 2: for all coefficients in intervals | [`event`] |
//! | `branch` | such an orbit over a range of a parameter, at every value, and where it is stable | [`branch`] |
//! | `chaos 3`, `chaos 4` | that every bi-infinite path of a graph of letters, each of so many periods, is an orbit of an oscillator, over ranges of parameters; 4: between two walls, each the other's mirror image, both met | [`chaos`] |
//! | `range`, `range 2`, `range 3`, `range 4` | the motions that are born where an oscillator touches its wall, for every bi-infinite path of a graph, from the touch to a distance; 2, 4: and that no others are near; 3, 4: between mirrored walls | [`range`] |
//! | `nothing`, `nothing 2` | that beyond the touch nothing is born and no motion stays near, to a distance; 2: between mirrored walls | [`nothing`] |
//! | `single`, `single 2` | an orbit of one impact along its curve, from the touch where it is born to a distance, past its flips, and where it is stable; 2: between mirrored walls | [`single`] |
//! | `attractor` | that beyond the touch of an overdamped oscillator motions are trapped, to a distance, and what is trapped is chaotic: no periodic motion there is stable, and exponents are positive | [`attractor`] |
//! | `attractor 2` | the same at one depth, or between two: displacements grow by weights in cells, also where they shrink at some impacts | [`attractor::cells`] |
//! | `parameter`, `parameter 2` | that a certificate of kind `range`, `nothing`, `single` or `attractor`, which follows in the same file, is of a machine over a range of its own parameter; 2: for all coefficients in intervals | [`parameter`] |
//! | `share` | in which share of a box of parameters a period or a word occurs, or chaos is born | [`share`], one by hand |
//! | `entropy` | by the word theorem, for all r ≤ 1, s and eµ > 0: the least upper bounds of the entropy | [`entropy`], a line by hand |
//! | `machine-orbit`, `machine-orbit 2` | that a periodic orbit of a machine with any number of coordinates and stops exists, is unique in a box, admissible, stable or not; 2: the same of the motion without impacts | [`machine`] |
//!
//! # Use
//!
//! ```
//! use grazing_check::{FORMAT, check, theorem2};
//! // Period 2 on r = 1: an orbit on (0, 1/4) and one on (1/4, 1/2), and u_2 = 0 between them.
//! let lines = "n 2 3\norbit 0/1 1/4 - +\npoint 1/4 singular\norbit 1/4 1/2 + +\n";
//! let head = format!("{FORMAT}\nkind theorem2\nrange 2 2\nlines 4\nstatement {}\n", theorem2::STATEMENT);
//! let checked = check(&mut (head.clone() + lines).as_bytes()).unwrap();
//! assert_eq!((checked.kind, checked.range), ("theorem2", Some(2..=2)));
//! // With one sign changed it is rejected, with the line and the reason.
//! let rejection = check(&mut (head + &lines.replace("- +", "+ +")).as_bytes()).unwrap_err();
//! assert!(rejection.to_string().starts_with("line 7: false"));
//! ```
//!
//! # Adding a kind
//!
//! A kind is a folder: `mod.rs` with the form, the rules, the limits and the cost in its head, the constants
//! `KIND` and `STATEMENT`, and `check`, which reads and proves everything after the kind line and returns the
//! range of periods and what else to print. It gets a line in the table `KINDS` below, which is the only
//! place that names all kinds, a row in the table above, samples in `tests/data`, and rows in
//! `tests/details.rs`, which changes every word of the samples: whatever is printed must be part of what is
//! checked. It asks `Lines::go_on` at least every few milliseconds, refuses work beyond a stated limit before
//! it begins it, and holds no more than it says. A statement that turns out not to be true as it stands is
//! never mended in place: it gets a new version, and the old one a row in `WITHDRAWN`. What finds
//! certificates lives elsewhere.

mod arithmetic;
pub mod attractor;
pub mod branch;
pub mod chaos;
pub mod cover;
mod decimal;
pub mod entropy;
pub mod event;
mod header;
mod interval;
mod lines;
pub mod machine;
mod motion;
pub mod nothing;
pub mod orbit;
pub mod parameter;
pub mod range;
mod rejection;
mod sha256;
pub mod share;
pub mod single;
pub mod theorem2;
mod touch;
pub mod word;

use std::{fmt, io::BufRead, ops::RangeInclusive};

pub use arithmetic::Fraction;
pub use rejection::Rejection;
pub use sha256::{Hashed, Sha256};

use lines::Lines;
use touch::about::About;

/// The first line of every certificate this version reads and writes.
pub const FORMAT: &str = "grazing-certificate 1";

/// The kinds of certificate. Nothing else in here names them all.
const KINDS: [Kind; 28] = [
    Kind::first(theorem2::KIND, theorem2::STATEMENT, theorem2::check),
    Kind::first(cover::KIND, cover::STATEMENT, cover::check),
    Kind::first(orbit::KIND, orbit::STATEMENT, orbit::check::<orbit::Fraction>),
    Kind::first(event::KIND, event::STATEMENT, event::check::<event::Quotient>),
    Kind::first(word::KIND, word::STATEMENT, word::check),
    Kind::first(word::KIND_BY_THEOREM, word::STATEMENT_BY_THEOREM, word::check_by_theorem),
    Kind::first(orbit::KIND, orbit::STATEMENT_2, orbit::check::<orbit::Range>).version(" 2"),
    Kind::first(event::KIND, event::STATEMENT_2, event::check::<event::RangeQuotient>).version(" 2"),
    Kind::first(branch::KIND, branch::STATEMENT, branch::check),
    Kind::first(chaos::KIND, chaos::STATEMENT_3, chaos::check::<false>).version(" 3"),
    Kind::first(chaos::KIND, chaos::STATEMENT_4, chaos::check::<true>).version(" 4"),
    Kind::first(range::KIND, range::STATEMENT, range::check::<1>),
    Kind::first(range::KIND, range::STATEMENT_2, range::check::<2>).version(" 2"),
    Kind::first(range::KIND, range::STATEMENT_3, range::check::<3>).version(" 3"),
    Kind::first(range::KIND, range::STATEMENT_4, range::check::<4>).version(" 4"),
    Kind::first(nothing::KIND, nothing::STATEMENT, nothing::check::<false>),
    Kind::first(nothing::KIND, nothing::STATEMENT_2, nothing::check::<true>).version(" 2"),
    Kind::first(single::KIND, single::STATEMENT, single::check::<false>),
    Kind::first(single::KIND, single::STATEMENT_2, single::check::<true>).version(" 2"),
    Kind::first(attractor::KIND, attractor::STATEMENT, attractor::check),
    Kind::first(attractor::KIND, attractor::cells::STATEMENT, attractor::cells::check).version(" 2"),
    Kind::first(entropy::KIND, entropy::STATEMENT, entropy::check),
    Kind::first(share::KIND, share::STATEMENT, share::check),
    Kind::first(machine::KIND, machine::STATEMENT, machine::check),
    Kind::first(orbit::KIND, orbit::STATEMENT_3, orbit::check_free).version(" 3"),
    Kind::first(machine::KIND, machine::STATEMENT_2, machine::check_free).version(" 2"),
    Kind::first(parameter::KIND, parameter::STATEMENT, parameter::check::<event::Quotient>),
    Kind::first(parameter::KIND, parameter::STATEMENT_2, parameter::check::<event::RangeQuotient>)
        .version(" 2"),
];

/// The kind lines that were proved once and are refused now, with the reason.
const WITHDRAWN: [(&str, &str); 2] = [("kind chaos", chaos::WITHDRAWN), ("kind chaos 2", chaos::WITHDRAWN)];

/// The kinds that this version proves, as after the word `kind` in a header: `orbit`, `orbit 2`, …
pub fn kinds() -> impl Iterator<Item = String> {
    KINDS.iter().map(|kind| format!("{}{}", kind.name, kind.version))
}

/// A kind of certificate, in one of its versions.
struct Kind {
    /// The word in the header.
    name: &'static str,
    /// What follows it in the header.
    version: &'static str,
    /// What a certificate of this kind proves.
    statement: &'static str,
    /// Reads and proves everything after the kind line.
    check: fn(&mut Lines) -> Result<Proved, Rejection>,
}

impl Kind {
    /// Version 1 of a kind, of which the header says nothing.
    const fn first(
        name: &'static str,
        statement: &'static str,
        check: fn(&mut Lines) -> Result<Proved, Rejection>,
    ) -> Kind {
        Kind { name, version: "", statement, check }
    }

    /// The same as another version.
    const fn version(self, version: &'static str) -> Kind {
        Kind { version, ..self }
    }

    fn line(&self) -> String {
        format!("kind {}{}", self.name, self.version)
    }
}

/// What the checker of a kind found, everything being proved.
struct Proved {
    /// What the headline has in place of the kind, if that would say more than is proved.
    title: Option<&'static str>,
    /// The periods n that it is proved for, if that is all of a range.
    range: Option<RangeInclusive<u64>>,
    detail: Vec<(&'static str, String)>,
    /// Of which oscillator near a touch it is, for a certificate that holds this one.
    about: Option<About>,
}

impl Proved {
    /// What is a kind of its own, in its own word.
    fn plain(range: Option<RangeInclusive<u64>>, detail: Vec<(&'static str, String)>) -> Proved {
        Proved { title: None, range, detail, about: None }
    }
}

/// What a certificate that passed the check has proved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Checked {
    /// The kind of certificate, as in its header.
    pub kind: &'static str,
    /// What is proved, in a word: the kind, but `orbits` for one of kind `chaos` that proves no chaos.
    pub title: &'static str,
    /// The statement, as in the header.
    pub statement: &'static str,
    /// The periods n for which it is proved; `None` of kind `chaos`, whose letters need not be a range.
    pub range: Option<RangeInclusive<u64>>,
    /// What the statement leaves to the certificate, in words: names and values.
    pub detail: Vec<(&'static str, String)>,
    /// The number of lines read, header included.
    pub lines: u64,
}

/// `proved, TITLE for n = A..=B`, of an orbit `of N periods`, or without both, and a line for each detail.
impl fmt::Display for Checked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "proved, {}", self.title)?;
        match &self.range {
            Some(range) if [orbit::KIND, event::KIND, branch::KIND, machine::KIND].contains(&self.kind) => {
                let (periods, plural) = (range.start(), if *range.start() == 1 { "" } else { "s" });
                write!(f, " of {periods} period{plural}")?;
            }
            Some(range) => write!(f, " for n = {}..={}", range.start(), range.end())?,
            None => {}
        }
        self.detail.iter().try_for_each(|(name, value)| write!(f, "\n  {name}: {value}"))
    }
}

/// Re-proves a certificate of any kind, reading it once. Memory: one line and what its kind says.
///
/// # Errors
/// A [`Rejection`] with the line and the reason: malformed text, a false claim, a cover with open leaves, or
/// a stream that cannot be read.
pub fn check(input: &mut dyn BufRead) -> Result<Checked, Rejection> {
    check_until(input, &mut || false)
}

/// The same, ended early once `stop` returns true; it is asked before every line and every few milliseconds
/// of work. Where `input` blocks, its reader has to notice the wish: a read that fails while `stop` returns
/// true counts as the wish to end.
///
/// # Errors
/// As [`check`]; an interruption.
#[inline(never)]
pub fn check_until(input: &mut dyn BufRead, stop: &mut dyn FnMut() -> bool) -> Result<Checked, Rejection> {
    let mut lines = Lines::after(0, input, stop);
    let first = lines.expect("the format line")?;
    if first.starts_with("grazing-shard ") {
        return Err(lines.malformed("a shard is no certificate: `grazing merge` puts shards together"));
    }
    if first != FORMAT {
        return Err(lines.malformed(format!("not a certificate of this format: expected {FORMAT:?}")));
    }
    let line = lines.expect("the kind")?;
    let Some(kind) = KINDS.iter().find(|kind| line == kind.line()) else {
        if let Some((line, reason)) = WITHDRAWN.iter().find(|(withdrawn, _)| line == *withdrawn) {
            return Err(lines.malformed(format!("{line:?} is of an earlier version: {reason}")));
        }
        let names = KINDS.map(|kind| format!("{:?}", kind.line()));
        return Err(lines.malformed(format!("expected a line {}", names.join(" or "))));
    };
    let Proved { title, range, detail, .. } = (kind.check)(&mut lines)?;
    let (kind, statement, lines) = (kind.name, kind.statement, lines.number());
    Ok(Checked { kind, title: title.unwrap_or(kind), statement, range, detail, lines })
}

/// The largest `u64` and 1 more: a panic, if this crate was built to notice overflows, as the workspace's
/// manifest asks. For tests of a build.
#[inline(never)]
pub fn overflow() -> u64 {
    std::hint::black_box(u64::MAX) + 1
}
