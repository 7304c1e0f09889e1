//! Certificates of kind `branch`: a periodic orbit of a linear impact oscillator, followed over a range of a
//! parameter: at every value it exists, is unique near a curve, admissible, and in parts stable or not.
//!
//! The oscillator's coefficients are quotients of polynomials in the parameter p, their numbers known to lie
//! in intervals, as of kind `event 2` ([`super::event`]); the unknowns and the equations are those of kind
//! `orbit` ([`super::orbit`]). The range is cut into cells. In each the orbit lies near a line, a point plus
//! rates times the distance from the cell's middle, and Krawczyk's test is made about that line (`proof`).
//! No code is shared with what finds the proof.
//!
//! # Form
//!
//! After `kind branch`; what is not explained is as for an event of version 2:
//!
//! ```text
//! statement …                  what passing proves, word for word: STATEMENT
//! digest HEX                   of the system's lines, units included
//! units L P                    lengths are listed in 10^L, the parameter in 10^P; not if both are 0
//! damping C                    and so on: every coefficient is a quotient P0,P1,…/Q0,Q1,… of ranges
//! …                            LOWER..UPPER
//! parameter NAME               its name
//! branch M                     the number of impacts, 1 to 24
//! strike SIDE N                M lines: lower or upper, the periods to the next impact (0 to 10000)
//! cells K                      1 to 10000, then K blocks
//! cell LO HI CLAIM             p from LO to HI, LO < HI, LO that of the block before; stable, unstable, or
//!                              open (no claim)
//! at T V T' V'                 M lines: the phase and the incoming relative speed at the cell's middle, and
//!                              their rates
//! radius R W                   the only orbit within R of the line, and it lies within W; 0 < W ≤ R
//! row C …                      2M lines of 2M numbers, about the inverse of the equations' derivative
//! flight J                     for each impact, J ≥ 1, and J lines
//! until T                      the times since its impact at which pieces end
//! ```
//!
//! All but N, M, K and J are decimals.
//!
//! # Rules
//!
//! Let p₀ be a cell's middle, y its point, y′ its rates, δ = p − p₀ with |δ| ≤ d, F the equations, C the
//! rows. For all p of the cell at once:
//!
//! - B1: for r = R and r = W, and X all numbers with |ξ| ≤ r in each unknown,
//!   −C F(y + y′δ; p) + (I − C F_x(y + y′δ + X; p)) X lies in the interior of X. The first is enclosed by
//!   F(y; p₀) and the derivative of F along the line, times [−d, d];
//! - B2: the solution is an orbit, as of kind `orbit`: V > 0, least period, positive gaps; restitutions are
//!   not negative;
//! - B3: what is claimed of the multipliers, as of kind `orbit`;
//! - B4: at the value that two cells share the former's solution is within R of the latter's line.
//!
//! B1 at each p is Krawczyk's test about y + y′δ: there is exactly one solution within R of it, with a
//! regular F_x, so that it depends on p as smoothly as F does. B4 says that both cells have the same one
//! where they meet.
//!
//! # Cost
//!
//! With J harmonics in all, and M impacts and P pieces in a cell, the sum of (1 + 2J)(4P + 6M(8M + 11)) over
//! the cells may be at most 8,000,000, which bounds the exponentials taken, one with a derivative counting as
//! four. Memory: the certificate.

mod proof;
mod text;
mod words;

use super::{
    FORMAT, Proved, Rejection,
    lines::Lines,
    rejection::{Fault, unless},
};

pub use super::{
    event::RangeQuotient,
    motion::text::{Decimal, Side, System},
    orbit::Claim,
};
pub use text::{Cell, Certificate, Line, Strike};

/// The word in the header.
pub const KIND: &str = "branch";

/// The most cells.
const CELLS: u64 = 10_000;
/// The most exponentials that a check may take.
const WORK: u64 = 8_000_000;

/// What a certificate proves.
pub const STATEMENT: &str = "For every choice of one number in each interval of the system of this digest and every value of its \
parameter from the first cell's LO to the last cell's HI, exactly one choice of phases and incoming relative speeds within R of the line of \
a cell that holds the value, the listed phases and speeds plus the listed rates times the distance from the cell's middle, solves the equations of the \
pattern, and it lies within W. This is a periodic orbit: every impact has positive speed, strictly between impacts every gap to a wall is positive, \
and no smaller number of periods than that of all listed strikes is a period. Where two cells meet both have the same orbit, and with the numbers of the \
intervals held its phases and speeds are continuously differentiable functions of the parameter in each cell, and continuous from the first LO to the last HI. In a \
cell whose claim is stable, both multipliers lie strictly inside the unit circle; if unstable, one lies strictly outside.";

/// Whether the rules hold in one cell, from 0, and it is linked to the one before: for a search, which finds
/// cell after cell. What is proved is what [`check`](crate::check) accepts as a whole. `stop` is asked after
/// every microsecond or few of work whether to end.
///
/// # Errors
/// The rule that fails, or that it was stopped.
pub fn cell_holds(
    certificate: &Certificate,
    cell: usize,
    stop: &mut dyn FnMut() -> bool,
) -> Result<(), String> {
    proof::cells(certificate, cell..cell + 1, &mut || unless(stop())).map_err(Fault::reason)
}

/// Checks everything after the kind line.
pub(super) fn check(lines: &mut Lines) -> Result<Proved, Rejection> {
    let certificate = text::read(lines)?;
    proof::cells(&certificate, 0..certificate.cells.len(), &mut || lines.go_on())
        .map_err(|fault| lines.rejection(fault))?;
    let periods: u64 = certificate.strikes.iter().map(|strike| strike.periods).sum();
    Ok(Proved::plain(Some(periods..=periods), words::detail(&certificate)))
}
