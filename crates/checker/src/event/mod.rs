//! Certificates of kind `event`: a periodic orbit of a linear impact oscillator bifurcates (saddle-node,
//! flip) or grazes a wall at a parameter in an interval.
//!
//! The oscillator's coefficients are quotients of polynomials in one parameter p (`quotient`), which the
//! checker evaluates in intervals itself. The unknowns are the phases T₁, …, T_M, the speeds V₁, …, V_M, then
//! p, then for a grazing the time T of the contact. The equations are those of the pattern, two for each
//! impact (see [`orbit`](crate::orbit)), and the event's: with T and D the trace and determinant of the
//! linearised map once round,
//!
//! | event | equations |
//! | --- | --- |
//! | `saddle-node` | 1 − T + D = 0 |
//! | `flip` | 1 + T + D = 0 |
//! | `grazing` | z = 0 and z′ = 0 for the gap z to the wall that is touched, a time T after the impact that the contact follows |
//!
//! Krawczyk's test proves that they have exactly one solution in a box, and that their derivative is regular
//! at it. All derivatives are taken by differentiating every step of the evaluation, in one direction at a
//! time (`motion/number.rs`).
//!
//! # What follows from a regular derivative
//!
//! Let f = 0 be the pattern's equations, x all phases and speeds, g = 1 − T + D. A regular derivative of (f,
//! g) by (x, p) means that (f_x, f_p) has full rank, so that the solutions of f = 0 near this one are a
//! curve, and that g has a nonzero derivative along it. On the curve det f_x = ± V₁ ⋯ V_M g: with B_i =
//! [[V_i, 0], [−z″₋, −1]], which takes (δT_i, δV_i) to the state just before impact i, the linearised
//! equation of flight i is M_i B_i − B_{i+1}, the M_i being the flights and impacts whose product is the map
//! once round. Along the curve dp/dσ is det f_x but for a factor that is nowhere 0. So **at a saddle-node**
//! dp/dσ = 0 and d²p/dσ² ≠ 0: there are two orbits on one side, which meet, and none on the other. **At a
//! flip** D ≥ 0, as every impact has the determinant τ² ≥ 0 and every flight a positive one; the multipliers
//! are −1 and −D, none is 1, and the curve is a graph over p, along which 1 + T + D passes through 0 with a
//! nonzero derivative. Whether the doubled orbits are born stable or not is not asked. **At a grazing** the
//! determinant is that of (f, z) by (x, p), with z taken at the contact, times z″ > 0: along the curve the
//! minimum of the gap passes through 0 with a nonzero derivative.
//!
//! # Form
//!
//! After `kind event`; what is not explained is as for `orbit`:
//!
//! ```text
//! statement …                  what passing proves, word for word: STATEMENT
//! digest HEX                   of the system's lines, units included
//! units L P                    as for an orbit, lengths being listed in 10^L; the parameter in 10^P
//! damping C                    and so on as for an orbit, but that every coefficient is a quotient of
//!                              polynomials in p:
//! …                            P0,P1,…/Q0,Q1,… stands for (P0 + P1 p + …)/(Q0 + Q1 p + …)
//! parameter NAME P             a letter or _, then up to 31 letters, digits or _ (ASCII); the parameter is
//!                              about P
//! event EVENT M                saddle-node, flip or grazing; the number of impacts, 1 to 24
//! impact SIDE N T V            M lines
//! contact I SIDE T             only for a grazing: between impact I (from 1) and the next the wall SIDE is
//!                              touched, about a time T after impact I
//! radius R W                   the only solution with all unknowns within R of the listed ones, and it lies
//!                              within W; 0 < W ≤ R
//! row C …                      as many lines as there are unknowns, of as many numbers
//! flight J                     for each impact, J ≥ 1, and J lines
//! until T                      one of these pieces holds the contact in its interior
//! ```
//!
//! The P and Q of a coefficient are integers of at most 34 digits, with a minus or none, at most 17 of each;
//! the last is not 0, unless it is the only one of the numerator; the last Q is above 0; no integer above 1
//! divides them all. So a constant P/Q reads as a fraction in lowest terms. Each, divided by the greatest
//! magnitude of the Q, lies strictly between −2³⁰ and 2³⁰. Common factors of the two polynomials are allowed;
//! where their quotient is not defined nothing is accepted. P − W and P + W must be decimals of at most 34
//! digits: they are the ends of the checked interval. Restitutions must certainly be at least 0 there. A
//! piece that holds the contact passes, for the wall touched, if z″ > 0 on it: z and z′ being 0 at one time,
//! z is positive at all others.
//!
//! Version 2 begins with `kind event 2` and differs in its statement and in that each P and Q is an interval
//! `LOWER..UPPER`, two decimals in order, as for an orbit of version 2:
//! `1..1,3.14159265358979323846..3.14159265358979323847/2..2` stands for (1 + πp)/2. There the numbers of a
//! quotient need not be in lowest terms.
//!
//! In version 2 the motion without impacts may graze, the response to the forcing: `event grazing 0`, no
//! impact, and `contact 0 SIDE T` with the phase T. The unknowns are p and T, the equations z = 0 and z′
//! = 0 at that phase, and the one flight is the period that begins half a period before. The motion
//! without impacts must not have the multiplier 1, so that no other one has the period 2π, and the
//! stiffness must certainly differ from 0. At the contact the derivative of the equations is z_p z″, so
//! that the minimum of the gap passes through 0 with a nonzero derivative here, too.
//!
//! # Cost
//!
//! With J harmonics in all, P pieces and M impacts, (1 + 2J)(4P + 6M(8M + 9)) may be at most 1,000,000, which
//! bounds the exponentials taken, one with a derivative counting as four. Memory: the certificate.

mod proof;
mod quotient;
mod ranges;
mod text;
mod words;

use super::{
    FORMAT, Proved, Rejection,
    lines::{Lines, Words},
    motion::{text::Coefficient, words::Spoken},
    rejection::Fault,
};

pub use super::motion::{
    range::Range,
    text::{Decimal, Harmonic, Impact, Side, System, Units, Wall},
};
pub use quotient::Quotient;
pub use ranges::RangeQuotient;
pub use text::{Certificate, Contact, Event};

/// The word in the header.
pub const KIND: &str = "event";

/// What a certificate of version 1 proves.
pub const STATEMENT: &str = "For exactly one choice of parameter, phases, incoming relative speeds and, for a grazing, time of \
contact, all within R of the listed ones, the oscillator of this digest has the listed event: the equations of pattern and event have exactly \
one solution there, their derivative is regular at it, and it lies within W of the listed one. It is a periodic orbit: every impact has positive speed, strictly \
between impacts every gap to a wall is positive, but for the contact, and no smaller number of periods than that of all listed impacts is a period. \
Saddle-node: a multiplier is 1, and the parameter has a nondegenerate extremum along the curve of solutions of the pattern. Flip: a multiplier is -1, and 1 + \
trace + determinant changes sign there with a nonzero derivative by the parameter. Grazing: at the contact the gap and its derivative are 0, its second derivative is \
positive, and along the curve its minimum changes sign with a nonzero derivative.";

/// What a certificate of version 2 proves.
pub const STATEMENT_2: &str = "For every choice of one number in each interval of the system of this digest, exactly one parameter, phases, incoming relative speeds and, \
for a grazing, time of contact, all within R of the listed ones, solve the equations of pattern and event; their derivative is \
regular there, and they lie within W. This is a periodic orbit: every impact has positive speed, strictly between impacts every gap to a wall is \
positive, but for the contact, and no smaller number of periods than that listed is a period; without impacts, it is the \
response to the forcing in one period. Saddle-node: a multiplier is 1, and the parameter has a nondegenerate extremum along the curve of \
solutions of the pattern. Flip: a multiplier is -1, and 1 + trace + determinant changes sign with a nonzero derivative by the \
parameter. Grazing: at the contact the gap and its derivative are 0, its second derivative is positive, and along the curve its \
minimum changes sign with a nonzero derivative.";

/// What a coefficient is, which is what the versions differ in.
#[expect(private_bounds, reason = "certificates are made of the versions that there are")]
pub trait Version: Coefficient + Spoken {
    /// The line of the kind.
    const HEAD: &str;
    /// What passing proves.
    const STATEMENT: &str;
    /// Whether an orbit without impacts may graze.
    const WITHOUT_IMPACTS: bool;
}

impl Version for Quotient {
    const HEAD: &str = "kind event";
    const STATEMENT: &str = STATEMENT;
    const WITHOUT_IMPACTS: bool = false;
}

impl Version for RangeQuotient {
    const HEAD: &str = "kind event 2";
    const STATEMENT: &str = STATEMENT_2;
    const WITHOUT_IMPACTS: bool = true;
}

/// Checks everything after the kind line.
pub(super) fn check<C: Version>(lines: &mut Lines) -> Result<Proved, Rejection> {
    let certificate: Certificate<C> = text::read(lines)?;
    let periods: u64 = certificate.impacts.iter().map(|impact| impact.periods).sum::<u64>().max(1);
    let proof = proof::Proof::new(&certificate);
    proof.run(&mut || lines.go_on()).map_err(|fault| lines.rejection(fault))?;
    Ok(Proved::plain(Some(periods..=periods), words::detail(&certificate)))
}
