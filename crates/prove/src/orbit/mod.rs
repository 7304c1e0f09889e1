//! Proofs about periodic orbits of linear oscillators: existence, uniqueness in a box, admissibility,
//! stability, events.
//!
//! Krawczyk's test over balls with first derivatives proves that the equations of an impact pattern, extended
//! by the event's condition where one is asked for, have exactly one solution in a box. Approximations serve
//! to choose the box only. Proved orbits and events are written as certificates, which `grazing check` proves
//! again. The motion without impacts (`free`) is in closed form and needs no test. Over a range of a
//! parameter an orbit is proved cell by cell (`branch`). Not here: continuation and approximate orbits.
//!
//! ```
//! use grazing_scenes::number::Precision;
//! use grazing_scenes::search::orbit::{ExpectedImpact, Stability, Verdict, orbit};
//! use grazing_scenes::motion::Side;
//! use grazing_scenes::one::orbit::{Itinerary, Oscillator, search};
//! use grazing_scenes::scene::Scene;
//! // An approximate orbit of period 4, and the proof that there is an exact one near it.
//! # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))?;
//! let system = Scene::read("examples/scenes/nordmark-2001.toml")?.exact(&[])?;
//! let oscillator = Oscillator::new(system.rounded(), 1e-12)?;
//! let orbits = search(&oscillator, &Itinerary::at(Side::Lower, &[4])?, 100, 1.0);
//! let found = orbits.iter().find(|orbit| orbit.multipliers.is_stable()).unwrap();
//! let [phase, velocity] = found.z[..] else { panic!("one impact") };
//! let guess = [ExpectedImpact { side: Side::Lower, periods: 4, phase, velocity }];
//! let Verdict::Proved(proof) = orbit(&system, &guess, &Precision::new(128))? else { panic!() };
//! assert_eq!(proof.stability, Some(Stability::Stable));
//! # Ok::<(), grazing_scenes::Error>(())
//! ```

mod admissible;
mod branch;
mod coefficient;
mod equations;
mod event;
mod free;
mod jet;
mod krawczyk;
mod linear;
mod quotient;
mod repetition;
mod solution;
mod units;
mod write;

pub use branch::{BranchProblem, ProvedBranch, branch};
pub use coefficient::Bounded;
pub use event::{Condition, ProvedEvent, event, event_in};
pub use free::{ProvedFreeMotion, free_motion};
pub use jet::Jet;
pub(crate) use krawczyk::{radii, rounded};
pub use quotient::Quotient;
pub use solution::{ExpectedImpact, ProvedOrbit, Stability, orbit, solution_in};
pub use units::Units;
pub use write::{CertifiedOrbit, certificate, event_certificate, free_certificate};
pub(crate) use write::{decimal, in_quotients, in_ranges, range_of};

use crate::error::Result;

/// An answer with its proof, the reason why it is certainly not so, or the reason why nothing was shown.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Verdict<T> {
    /// Proved.
    Proved(T),
    /// Certainly false.
    Refuted(String),
    /// Nothing is shown.
    Undecided(String),
}

impl<T> Verdict<T> {
    /// "proved", "refuted" or "undecided".
    #[must_use]
    pub fn word(&self) -> &'static str {
        match self {
            Verdict::Proved(_) => "proved",
            Verdict::Refuted(_) => "refuted",
            Verdict::Undecided(_) => "undecided",
        }
    }

    /// What follows from what is proved.
    ///
    /// # Errors
    /// Those of `next`.
    pub(crate) fn and_then<U>(self, next: impl FnOnce(T) -> Result<Verdict<U>>) -> Result<Verdict<U>> {
        match self {
            Verdict::Proved(proof) => next(proof),
            Verdict::Refuted(why) => Ok(Verdict::Refuted(why)),
            Verdict::Undecided(why) => Ok(Verdict::Undecided(why)),
        }
    }
}
