//! Certificates: their text format, and the checker that re-proves them. **This folder is the trusted code.**
//!
//! It imports nothing from the rest of the crate and, so far, nothing but `std`: it has its own integers,
//! fractions, signs and modular inverses, so that a fault in what finds a proof cannot hide in what checks it. A
//! certificate that passes proves the statement in its header to whoever trusts this folder, the Rust compiler
//! and standard library, and the machine. There is no search in here and nothing is taken on faith from the file.
//!
//! # Format
//!
//! ASCII lines ended by `\n`, words separated by single spaces, numbers in decimal without leading zeros,
//! fractions `p/q` in lowest terms with q ≤ 2n. The header:
//!
//! ```text
//! grazing-certificate 1                format and its version
//! kind theorem2                        or one with a form of its own below this line: [`cover`], [`orbit`]
//! range A B                            the periods covered, 1 ≤ A ≤ B; 3 ≤ A ≤ B ≤ 256 for a cover
//! lines L                              the number of lines after the header
//! statement …                          what passing proves, word for word
//! ```
//!
//! Then one block for each n in the range, in order. With kind `theorem2`, its lines tile (0, 1/2) from left to right, alternately an open
//! interval and the point that ends it:
//!
//! ```text
//! n N COUNT                            period and the number of lines in its block
//! orbit P/Q P/Q EMU GAMMA              (52), (53) hold on the open interval in the case (EMU, GAMMA), each + or -
//! stretch P/Q P/Q K K'                 b_{n,K} > 0 > b_{n,K'} on the open interval: no orbit
//! point P/Q singular                   u_n = 0: Theorem 1 is silent
//! point P/Q boundary K                 b_{n,K} = 0 and no two b of opposite sign: Theorem 1 is silent
//! point P/Q excluded K K'              b_{n,K} > 0 > b_{n,K'} there: no orbit
//! ```
//!
//! For n = 1, which has no b and so two cases at once, the block is the two lines `orbit 0/1 1/2 + -` and
//! `orbit 0/1 1/2 - +`.
//!
//! With kind `cover`, a block holds bisection trees over boxes in (r, s), one line for each strip of s; the claims are those of [`cover::Leaf`], and
//! [`cover`] says what follows from them, with a block by hand:
//!
//! ```text
//! n N RMAX COUNT                       period, r_max (p/q in lowest terms, q ≤ 2^40) and the number of leaves
//! identity region2                     N_{n,k} < 0 for all k in region 2
//! identity region4                     none in region 4 for even n; for odd n, b_{n,n-2} > 0 decides
//! strip P/Q P/Q                        the next strip of s, from 0/1 to 1/2
//! TREES                                the trees of its rows, r = 0 to 1/2, 1/2 to 3/4, … up to r_max, in preorder
//!
//! r                                    the box is halved in r; the lower half's tree, then the upper one's
//! s                                    the box is halved in s; the left half's tree, then the right one's
//! NK,K';                               N_{n,K} > 0 > N_{n,K'} on the closed box: no orbit
//! n                                    the same again: NK,K'; with the K and K' of the last one before it in TREES; malformed if there is none
//! P;  M;                               all N_{n,k} > 0 (P) or < 0 (M)
//! pK; pKl; pKr;  mK; mKl; mKr;         N_{n,K} > 0 (p) or < 0 (m) decides, the more so for larger r; for smaller (l) or larger (r) s
//! O;                                   open: nothing is claimed, and the statement is not proved
//! ```
//!
//! # A block of kind `theorem2` by hand
//!
//! Period 4 has b_{4,k}(s) = −2 sin kπs sin (4−k)πs / cos 4πs and c_4(s) = −2 sin 2πs tan 4πs:
//!
//! ```text
//! n 4 9
//! orbit 0/1 1/8 - +       cos 4πs > 0, all sines > 0: every b < 0, c < 0
//! point 1/8 singular      2·4·(1/8) is an integer, so u_4 = 0
//! orbit 1/8 1/4 + +       cos 4πs < 0, sines still > 0: every b > 0, and c > 0
//! point 1/4 singular
//! orbit 1/4 1/3 + -       the same b; sin 4πs is now < 0, so c < 0
//! point 1/3 boundary 3    sin 3πs = 0, so b_{4,3} = b_{4,1} = 0
//! stretch 1/3 3/8 2 1     sin 3πs < 0 turns b_{4,1} < 0, while b_{4,2} > 0
//! point 3/8 singular
//! stretch 3/8 1/2 1 2     cos 4πs > 0 turns both
//! ```
//!
//! Theorem 2 lists for n = 4, m = 1, the neighbours 0/1 and 1/3 of 1/4: (−,+) on (0, 1/8), (+,+) on (1/8, 1/4),
//! (+,−) on (1/4, 1/3): the three `orbit` lines. Were the line `stretch 1/3 3/8 2 1` to read `stretch 1/3 3/8 1 2`, the
//! checker would answer: `line 13: false: b_{4,1} is not > 0 on (1/3, 3/8)`.

mod arithmetic;
pub mod cover;
mod header;
mod lines;
pub mod orbit;
mod rejection;
pub mod theorem2;

use std::{fmt, io::BufRead, ops::RangeInclusive};

pub use arithmetic::Fraction;
pub use rejection::Rejection;

use lines::Lines;

/// The first line of every certificate this version reads and writes.
pub const FORMAT: &str = "grazing-certificate 1";

/// The kinds of certificate. Nothing else in here names them all.
const KINDS: [Kind; 3] = [
    Kind { name: theorem2::KIND, statement: theorem2::STATEMENT, check: theorem2::check },
    Kind { name: cover::KIND, statement: cover::STATEMENT, check: cover::check },
    Kind { name: orbit::KIND, statement: orbit::STATEMENT, check: orbit::check },
];

/// A kind of certificate.
struct Kind {
    /// The word in the header.
    name: &'static str,
    /// What a certificate of this kind proves.
    statement: &'static str,
    /// Reads and proves everything after the kind line.
    check: fn(&mut Lines) -> Result<Proved, Rejection>,
}

/// What the checker of a kind found, everything being proved.
struct Proved {
    range: RangeInclusive<u64>,
    detail: Vec<(&'static str, String)>,
}

/// What a certificate that passed the check has proved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Checked {
    /// The kind of certificate: `theorem2`, `cover` or `orbit`.
    pub kind: &'static str,
    /// The statement, as in the header.
    pub statement: &'static str,
    /// The periods n for which it is proved.
    pub range: RangeInclusive<u64>,
    /// What the statement leaves to the certificate, in words: names and values.
    pub detail: Vec<(&'static str, String)>,
    /// The number of lines read, header included.
    pub lines: u64,
}

/// `proved, KIND for n = A..=B`, and a line for each detail.
impl fmt::Display for Checked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "proved, {} for n = {}..={}", self.kind, self.range.start(), self.range.end())?;
        self.detail.iter().try_for_each(|(name, value)| write!(f, "\n  {name}: {value}"))
    }
}

/// Re-proves a certificate of any kind, reading it once. Memory: one line and what its kind says.
///
/// # Errors
/// A [`Rejection`] with the line and the reason: malformed text, a false claim, a cover with open leaves, or a stream that cannot be read.
pub fn check(input: &mut dyn BufRead) -> Result<Checked, Rejection> {
    check_until(input, &mut || false)
}

/// The same, ended early once `stop` returns true; it is asked before every line and every few milliseconds of work. Where `input` blocks, its
/// reader has to notice the wish: a read that fails while `stop` returns true counts as the wish to end.
///
/// # Errors
/// As [`check`]; an interruption.
#[inline(never)]
pub fn check_until(input: &mut dyn BufRead, stop: &mut dyn FnMut() -> bool) -> Result<Checked, Rejection> {
    let mut lines = Lines::after(0, input, stop);
    let first = lines.expect("the format line")?;
    if first != FORMAT {
        return Err(lines.malformed(format!("not a certificate of this format: expected {FORMAT:?}")));
    }
    let line = lines.expect("the kind")?;
    let Some(kind) = KINDS.iter().find(|kind| line.strip_prefix("kind ") == Some(kind.name)) else {
        let names = KINDS.map(|kind| format!("{:?}", format!("kind {}", kind.name)));
        return Err(lines.malformed(format!("expected a line {}", names.join(" or "))));
    };
    let Proved { range, detail } = (kind.check)(&mut lines)?;
    Ok(Checked { kind: kind.name, statement: kind.statement, range, detail, lines: lines.number() })
}

/// The largest `u64` and 1 more: a panic, if this crate was built to notice overflows, as the workspace's manifest asks. For tests of a build.
#[inline(never)]
pub fn overflow() -> u64 {
    std::hint::black_box(u64::MAX) + 1
}
