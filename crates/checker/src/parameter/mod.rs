//! Certificates of kind `parameter`: a certificate about an oscillator near a touch, said in the parameter of
//! a machine, in the machine's own units of length.
//!
//! Kinds `range`, `single`, `nothing` and `attractor` speak of an oscillator as it is seen from the motion
//! without walls, in units of the wall's own motion, at depths ν. This kind has the machine's coefficients as
//! functions of its parameter p, and a certificate of one of those kinds after them; what is checked is that
//! at every listed p the machine is that oscillator, at a depth that the certificate has.
//!
//! # Form
//!
//! After `kind parameter`:
//!
//! ```text
//! statement …            what passing proves, word for word: STATEMENT
//! digest HEX             of the system's lines, units included
//! units L P              as of kind branch, and so all lines of the system; a coefficient is a quotient
//! damping C              P0,P1,…/Q0,Q1,… of polynomials in integers, as of kind event
//! …
//! parameter NAME         its name
//! touch LO HI            the parameter at the touch lies between these, LO < HI; or
//! from P                 the parameter from which on it is proved
//! top LO HI              of several harmonics: a time of the wall's top lies between these; or: top none
//! pieces J               1 to 1000: the range is looked at in J equal pieces
//! depths K               1 to 100, then K lines
//! depth NU P             at P the depth is at most NU; both farther from the touch than those before
//! kind range 2           the certificate, from its line `kind` on: of one of those kinds, of any version
//! …
//! ```
//!
//! NU is a fraction as in the certificate, J and K are whole, the rest decimals, in the listed units. Version
//! 2 has for every integer of a quotient a range LOWER..UPPER, as version 2 of kind `event`.
//!
//! # Rules
//!
//! Let h be the motion without walls, the sum of harmonics that answers to force and forcing, d(t) how far it
//! is from the wall, M the mean of d, a_j and b_j its coefficients. With two walls it is the lower one, and
//! the certificate is of mirrored walls: then the force is 0, all orders of the forcing are odd, the walls do
//! not move, their places are opposite numbers and their restitutions one number; else there is one wall and
//! the certificate is of one.
//!
//! - P1, one harmonic: a₁ and b₁ are all there are, H² = a₁² + b₁², and the certificate's g(t) = cos t.
//! - P1, several: every coefficient of a harmonic that is not 0 is q pᵐ with numbers q and one m, and c and k
//!   do not contain p. At p = 1 d′ < 0 at the beginning of `top`, d′ > 0 at its end and d″ > 0 in it. For
//!   every T there, H = pᵐ H₁, H₁ = M − d(T), and the coefficients −(a_j cos jT + b_j sin jT)/H₁, −(b_j cos
//!   jT − a_j sin jT)/H₁ lie in the certificate's ranges of order j; it has no other orders but with ranges
//!   around 0.
//! - P2: in every piece M and H are positive, c, k and τ lie in the certificate's ranges, and ν = σ(1 − M/H)
//!   has a derivative of one sign, by that of M/H or, of one harmonic, of its square: it increases with the
//!   distance from the touch.
//! - P3: ν < 0 at the end of `touch` that is farther from the depths, ν > 0 at the other, or at `from`: by
//!   M/H or its square, which is 1 at the touch. For a certificate with a least depth, as of kind `attractor
//!   2`, there is a line `from`, and ν is at least that depth there.
//! - P4: at each listed P ν is at most NU, by the same; the last NU is at most the certificate's greatest.
//!
//! All is evaluated in intervals, derivatives by the rules of calculus along p. What does not depend on
//! p is compared with the certificate's ranges exactly, where its digits allow.
//!
//! Of P1 to P4 the statement follows: x = ±(q − h)/H at the time T + t satisfies x″ = −c x′ − k x, its wall
//! is at −d(T + t)/H = σν − 1 + g(t), with g(0) = 1 and g′(0) = 0, and a law of impact that scales
//! with the speed is the same. With `top` T is a smooth function of p, of constant value there. By P2 and P3
//! ν has one zero in `touch`, and is positive beyond it, by P4 up to NU.
//!
//! # Cost
//!
//! (J + K + 3)(1 + 2 N) evaluations of at most 17 terms, N harmonics, and what the certificate costs.

mod proof;
mod text;
mod words;

use super::{
    KINDS, Proved, Rejection, attractor,
    event::{Quotient, RangeQuotient},
    lines::Lines,
    motion::{text::Coefficient, words::Spoken},
    nothing, range, single,
};

pub use text::{Begin, Certificate, Decimal, Depth, Fraction, System};

/// The word in the header.
pub const KIND: &str = "parameter";

/// What both versions prove.
macro_rules! seen {
    () => {
        "the oscillator q'' = -c q' - k q + F + f(t) above its lower wall or below its upper one or between both, \
with restitution tau. Let h be its motion without walls, the sum of harmonics that answers to F and f, d(t) how \
far h is from the wall, inside being positive, the lower wall if there are two; M the mean of d, T a time at which \
d' = 0 and d'' > 0, in the listed top if there is one, and H = M - d(T) > 0. Then x(t) = (q - h)/H at the time T + t, \
or its negative if the wall is an upper one, moves as the oscillator of the certificate that follows at the depth nu \
with sigma nu = 1 - M/H, for g(t) = (M - d(T + t))/H: c, k, tau and the coefficients of g lie in its ranges, and nu, \
which increases with the distance from the touch, is > 0 and at most the listed NU up to each listed P. Exactly one p \
of the listed touch has d(T) = 0. So what the certificate states of its oscillator, it states of this one at each of \
these p."
    };
}

/// What a certificate proves.
pub const STATEMENT: &str = concat!(
    "For every p between the touch and the last listed P, P included, or, where no touch is listed, from the \
value that stands for it on, consider, with its coefficients the listed quotients of polynomials in p, ",
    seen!()
);

/// What a certificate of version 2 proves.
pub const STATEMENT_2: &str = concat!(
    "For every choice of one number in each interval of the system of this digest and every p between the touch and \
the last listed P, P included, or, where no touch is listed, from the value that stands for it on, consider ",
    seen!()
);

/// What a coefficient is, which is what the versions differ in.
#[expect(private_bounds, reason = "certificates are made of the versions that there are")]
pub trait Version: Coefficient + Spoken + Eq {
    /// The line of the kind.
    const HEAD: &str;
    /// What passing proves.
    const STATEMENT: &str;

    /// The least and the greatest number that it may be, exactly, if that is the same whatever the parameter
    /// is.
    fn bounds(&self) -> Option<[Fraction; 2]>;

    /// m, if it is q pᵐ with a number q, of which bounds may be known only.
    fn power(&self) -> Option<usize>;
}

const ONE: Fraction = Fraction { p: 1, q: 1 };

/// The one of these, if there is no other.
fn only(mut terms: impl Iterator<Item = usize>) -> Option<usize> {
    terms.next().filter(|_| terms.next().is_none())
}

impl Version for Quotient {
    const HEAD: &str = "kind parameter";
    const STATEMENT: &str = STATEMENT;

    fn bounds(&self) -> Option<[Fraction; 2]> {
        match (&self.numerator[..], &self.denominator[..]) {
            (&[p], &[q]) => Some([Fraction { p, q }; 2]),
            _ => None,
        }
    }

    fn power(&self) -> Option<usize> {
        let terms = self.numerator.iter().enumerate().filter(|(_, x)| **x != 0);
        only(terms.map(|(power, _)| power)).filter(|_| self.denominator.len() == 1)
    }
}

impl Version for RangeQuotient {
    const HEAD: &str = "kind parameter 2";
    const STATEMENT: &str = STATEMENT_2;

    fn bounds(&self) -> Option<[Fraction; 2]> {
        match (&self.numerator[..], &self.denominator[..]) {
            ([x], [one]) if one.bounds() == [ONE; 2] => Some(x.bounds()),
            _ => None,
        }
    }

    fn power(&self) -> Option<usize> {
        let terms = self.numerator.iter().enumerate().filter(|(_, x)| !x.is_zero());
        only(terms.map(|(power, _)| power)).filter(|_| self.denominator.len() == 1)
    }
}

/// Whether the wall's top is later than a time t, by the sign of d′ where the parameter is 1; `None` where it
/// is not known. For a search.
pub fn rises_after<C: Version>(certificate: &Certificate<C>, time: Decimal) -> Option<bool> {
    proof::falls(certificate, time)
}

/// Checks everything after the kind line.
pub(super) fn check<C: Version>(lines: &mut Lines) -> Result<Proved, Rejection> {
    let certificate: Certificate<C> = text::read(lines)?;
    let end = lines.number();
    let line = lines.expect("the line \"kind …\" of a certificate")?;
    // No other kind has what is compared, and none that holds others in turn is among these.
    let inner = [range::KIND, single::KIND, nothing::KIND, attractor::KIND];
    let kind = KINDS.iter().find(|kind| inner.contains(&kind.name) && line == kind.line());
    let Some(kind) = kind else {
        return Err(lines.malformed(
            "expected the line kind of a certificate of kind range, single, nothing or attractor",
        ));
    };
    let Proved { title, detail, about, .. } = (kind.check)(lines)?;
    let about = about.ok_or_else(|| lines.malformed("it does not say of which oscillator it is"))?;
    // What is false is said of the head, not of the last line.
    proof::run(&certificate, &about, &mut || lines.go_on()).map_err(|fault| fault.on(end))?;
    let detail = words::detail(&certificate, detail);
    Ok(Proved { title, ..Proved::plain(None, detail) })
}
