//! Proofs that a periodic orbit with a given impact pattern exists, is unique in a box, admissible, and
//! stable or not.

use num_rational::BigRational;
use num_traits::Zero;
use serde::Serialize;

use super::{
    Bounded, Jet, Units, Verdict, admissible,
    coefficient::bounded,
    equations::Equations,
    krawczyk::{self, Preconditioner, Search},
    linear::Linear,
    repetition::least_period,
};
use crate::{
    error::{Error, Result},
    motion::{Side, System},
    number::{Ball, Precision, Real, Sign},
};

/// An impact of a pattern, with where it is expected.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExpectedImpact {
    /// The wall that is met.
    pub side: Side,
    /// n_i: the next impact comes 2π n_i + t_{i+1} − t_i later.
    pub periods: u32,
    /// About t_i, the phase.
    pub phase: f64,
    /// About V_i, the speed at which the gap closes.
    pub velocity: f64,
}

/// Where the multipliers of an orbit are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Stability {
    /// All strictly inside the unit circle.
    Stable,
    /// One strictly outside.
    Unstable,
}

/// A proved orbit.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct ProvedOrbit {
    /// The pattern.
    pub impacts: Vec<ExpectedImpact>,
    /// In what the box is: its phases are in radians.
    pub units: Units,
    /// The middle of the box, t_1, …, t_m, V_1, …, V_m, in these units.
    pub centre: Vec<BigRational>,
    /// Half the side of the box in which the orbit is the only one with its pattern, in these units.
    pub radius: BigRational,
    /// t_i, enclosed.
    pub phases: Vec<Ball>,
    /// V_i > 0, enclosed.
    pub velocities: Vec<Ball>,
    /// The trace of the linearised map once round the orbit.
    pub trace: Ball,
    /// Its determinant.
    pub determinant: Ball,
    /// Where its eigenvalues are, if the enclosures tell.
    pub stability: Option<Stability>,
    /// Phases and velocities in these units.
    pub(super) found: Vec<Ball>,
    /// The matrix that Krawczyk's test used.
    pub(super) inverse: Preconditioner,
    /// The pieces of time by which each flight was proved.
    pub(super) pieces: admissible::Pieces,
}

/// Proves an orbit near the guess, unique in the largest box of radius 1/2, 1/5, 1/10, … that allows it. For
/// m impacts: O(m³) operations and, for each flight of n periods, O(n) evaluations of the motion.
///
/// # Errors
/// An input error: the system is not linear, a wall that is met is missing, an undamped resonance, periods
/// that sum to 0.
pub fn orbit(
    system: &System<impl Bounded>,
    guess: &[ExpectedImpact],
    precision: &Precision,
) -> Result<Verdict<ProvedOrbit>> {
    let units = Units::of(&bounded(system), guess.iter().map(|impact| impact.side));
    let (linear, near) = (Linear::of(&units.bounded(system), precision)?, units.impacts(guess));
    let equations = equations(&linear, &near)?;
    let map = |unknowns: &[Jet]| equations.residual(unknowns);
    Search::run(&map, &start(&near), precision)?.and_then(|search| {
        let unknowns: Vec<Jet> = search.found.iter().cloned().map(Jet::constant).collect();
        let pieces = admitted(&equations, &unknowns, None, &search)?;
        pieces.and_then(|pieces| {
            let (trace, determinant) = equations.multipliers(&unknowns)?;
            let (trace, determinant) = (trace.value, determinant.value);
            let Search { centre, radius, inverse, found } = search;
            let mut phases = found.clone();
            let velocities = units.own(phases.split_off(guess.len()), precision);
            let stability = stability(&trace, &determinant, precision);
            let impacts = guess.to_vec();
            Ok(Verdict::Proved(ProvedOrbit {
                impacts,
                units,
                centre,
                radius,
                phases,
                velocities,
                trace,
                determinant,
                stability,
                found,
                inverse,
                pieces,
            }))
        })
    })
}

/// Proves that the pattern's equations have exactly one solution in the box of `radius` about the guess
/// itself, and encloses it, or that they have none. Whether the solution is an orbit is not asked.
///
/// # Errors
/// As [`orbit`]; also if the guess is not finite or the radius not positive.
pub fn solution_in(
    system: &System<impl Bounded>,
    guess: &[ExpectedImpact],
    radius: &BigRational,
    precision: &Precision,
) -> Result<Verdict<Vec<Ball>>> {
    let linear = Linear::of(&bounded(system), precision)?;
    let equations = equations(&linear, guess)?;
    let map = |unknowns: &[Jet]| equations.residual(unknowns);
    krawczyk::in_box(&map, &start(guess), radius, precision)
}

/// The equations of a pattern.
///
/// # Errors
/// An input error: no impact, periods that sum to 0, a wall that is missing.
pub(super) fn equations<'a>(linear: &'a Linear<'a>, impacts: &'a [ExpectedImpact]) -> Result<Equations<'a>> {
    if impacts.iter().all(|impact| impact.periods == 0) {
        return Err(Error::input("the periods of an impact pattern must not sum to 0"));
    }
    for impact in impacts {
        linear.wall(impact.side)?;
    }
    Ok(Equations { linear, impacts })
}

/// The unknowns where the impacts are expected.
pub(super) fn start(impacts: &[ExpectedImpact]) -> Vec<f64> {
    impacts.iter().map(|impact| impact.phase).chain(impacts.iter().map(|impact| impact.velocity)).collect()
}

/// Whether the solution is an orbit: V_i > 0, no smaller period, and every gap is positive between impacts
/// but for a known tangency.
pub(super) fn admitted(
    equations: &Equations,
    unknowns: &[Jet],
    touch: Option<&admissible::Touch>,
    search: &Search,
) -> Result<Verdict<admissible::Pieces>> {
    let m = equations.impacts.len();
    for (i, velocity) in unknowns[m..2 * m].iter().enumerate() {
        match velocity.sign() {
            Some(Sign::Positive) => {}
            Some(_) => return Ok(Verdict::Refuted(format!("the gap opens at impact {}", i + 1))),
            None => return Ok(Verdict::Undecided(format!("impact {} may be a tangency", i + 1))),
        }
    }
    let Search { found, centre, radius, .. } = search;
    // The same orbit begun later solves the equations of pattern, saddle-node and flip, but not those of a
    // tangency after a given impact.
    let only_within = if touch.is_some() { &BigRational::zero() } else { radius };
    least_period(equations.impacts, found, centre, only_within, equations.linear.precision)
        .and_then(|()| admissible::prove(equations, unknowns, touch))
}

/// Jury's conditions: both eigenvalues are inside the unit circle iff D < 1, 1 + D > |T|; one is outside if
/// D > 1 or 1 + D < |T|.
pub(super) fn stability(trace: &Ball, determinant: &Ball, precision: &Precision) -> Option<Stability> {
    let one = Ball::integer(1, precision);
    let sum = one.clone() + determinant;
    let signs = [one - determinant, sum.clone() - trace, sum + trace].map(|x| x.sign());
    if signs.contains(&Some(Sign::Negative)) {
        Some(Stability::Unstable)
    } else if signs.iter().all(|&sign| sign == Some(Sign::Positive)) {
        Some(Stability::Stable)
    } else {
        None
    }
}
