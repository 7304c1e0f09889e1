//! Proofs of events along a branch of orbits: saddle-node, flip, grazing, with the parameter enclosed.

use num_rational::BigRational;

use super::{
    ExpectedImpact, Jet, Units, Verdict,
    admissible::{Pieces, Touch},
    equations::Equations,
    krawczyk::{self, Preconditioner, Search},
    linear::Linear,
    solution::{admitted, equations, start},
};
use crate::{
    error::{Error, Result},
    motion::{Side, System},
    number::{Ball, Elementary, Precision, Real, Sign},
};

/// What happens at the event.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Condition {
    /// A multiplier is 1: 1 − trace + det = 0.
    SaddleNode,
    /// A multiplier is −1: 1 + trace + det = 0.
    Flip,
    /// Between impacts the orbit touches a wall: z = z′ = 0 < z″.
    Grazing {
        /// The impact after which it does, from 0; 0 for an orbit without impacts.
        after: usize,
        /// The wall.
        side: Side,
        /// About how long after that impact; about the phase, for an orbit without impacts.
        time: f64,
    },
}

/// A proved event: at exactly one parameter value and orbit in the box the condition holds, and that orbit is
/// admissible (but for the tangency, if it is one).
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct ProvedEvent {
    /// What happens.
    pub condition: Condition,
    /// The pattern.
    pub impacts: Vec<ExpectedImpact>,
    /// The parameter's value.
    pub parameter: Ball,
    /// t_i.
    pub phases: Vec<Ball>,
    /// V_i > 0.
    pub velocities: Vec<Ball>,
    /// How long after its impact the tangency comes, if it is one.
    pub time: Option<Ball>,
    /// In what the box is: its times are in radians.
    pub units: Units,
    /// The middle of the box: t_1, …, t_m, V_1, …, V_m, the parameter, the time of the tangency.
    pub centre: Vec<BigRational>,
    /// Half the side of the box in which there is no other, in these units.
    pub radius: BigRational,
    /// The matrix that Krawczyk's test used.
    pub(super) inverse: Preconditioner,
    /// The pieces of time by which each flight was proved.
    pub(super) pieces: Pieces,
}

/// Proves an event near the guess, in the largest box that allows it. `family` is the system at a parameter
/// value.
///
/// # Errors
/// As [`orbit`](super::orbit()), and those of `family`; also where damping² cannot be told from 4 stiffness
/// over a box.
pub fn event(
    family: impl Fn(&Jet) -> Result<System<Jet>>,
    impacts: &[ExpectedImpact],
    parameter: f64,
    condition: Condition,
    precision: &Precision,
) -> Result<Verdict<ProvedEvent>> {
    let m = impacts.len();
    let at = BigRational::from_float(parameter).ok_or_else(|| Error::input("a parameter is finite"))?;
    let units = {
        let touched = match condition {
            Condition::Grazing { side, .. } => Some(side),
            _ => None,
        };
        let met = impacts.iter().map(|impact| impact.side).chain(touched);
        Units::along(&family, met, &at, precision)?
    };
    let (family, near) = (units.family(family, precision), units.impacts(impacts));
    let map = |unknowns: &[Jet]| extended(&family, unknowns, &near, condition, precision);
    Search::run(&map, &unknowns(&near, units.about(parameter), condition), precision)?.and_then(|search| {
        let unknowns: Vec<Jet> = search.found.iter().cloned().map(Jet::constant).collect();
        let linear = Linear::enclosed(family(&unknowns[2 * m])?, precision)?;
        let time = search.found.get(2 * m + 1).cloned();
        let touch = match (condition, &time) {
            (Condition::Grazing { after, side, .. }, Some(time)) => {
                let phase = Jet::constant(time.clone());
                // Without impacts the period has no place where it begins: half of it before the touch, half
                // after.
                Some(match m {
                    0 => Touch { flight: 0, side, time: Ball::pi(precision), phase },
                    _ => Touch {
                        flight: after,
                        side,
                        time: time.clone(),
                        phase: phase + unknowns.get(after).unwrap_or(&unknowns[0]),
                    },
                })
            }
            _ => None,
        };
        let equations = pattern(&linear, &near, condition)?;
        if m == 0 && !is_alone(&linear) {
            return Ok(Verdict::Undecided("1 may be a multiplier of the motion without impacts".into()));
        }
        admitted(&equations, &unknowns, touch.as_ref(), &search)?.and_then(|pieces| {
            Ok(Verdict::Proved(ProvedEvent {
                condition,
                impacts: impacts.to_vec(),
                parameter: units.own_parameter(search.found[2 * m].clone(), precision),
                phases: search.found[..m].to_vec(),
                velocities: units.own(search.found[m..2 * m].to_vec(), precision),
                time,
                units,
                centre: search.centre,
                radius: search.radius,
                inverse: search.inverse,
                pieces,
            }))
        })
    })
}

/// Proves that the equations of pattern and event have exactly one solution in the box of `radius` about the
/// guess itself, and encloses it, or that they have none. Whether the solution is an orbit is not asked.
///
/// # Errors
/// As [`event`]; also if the guess is not finite or the radius not positive.
pub fn event_in(
    family: impl Fn(&Jet) -> Result<System<Jet>>,
    impacts: &[ExpectedImpact],
    parameter: f64,
    condition: Condition,
    radius: &BigRational,
    precision: &Precision,
) -> Result<Verdict<Vec<Ball>>> {
    let map = |unknowns: &[Jet]| extended(&family, unknowns, impacts, condition, precision);
    krawczyk::in_box(&map, &unknowns(impacts, parameter, condition), radius, precision)
}

/// The unknowns where the event is expected.
fn unknowns(impacts: &[ExpectedImpact], parameter: f64, condition: Condition) -> Vec<f64> {
    let mut all = start(impacts);
    all.push(parameter);
    if let Condition::Grazing { time, .. } = condition {
        all.push(time);
    }
    all
}

/// The equations of the pattern; none of a motion without impacts, which may graze.
fn pattern<'a>(
    linear: &'a Linear<'a>,
    impacts: &'a [ExpectedImpact],
    condition: Condition,
) -> Result<Equations<'a>> {
    if impacts.is_empty() && matches!(condition, Condition::Grazing { .. }) {
        return Ok(Equations { linear, impacts });
    }
    equations(linear, impacts)
}

/// Whether no other motion without impacts comes back after 2π.
pub(super) fn is_alone(linear: &Linear) -> bool {
    let turn = Jet::pi(linear.precision) * &Jet::integer(2, linear.precision);
    let [[a, b], [c, d]] = linear.propagator(&turn);
    let determinant = a.clone() * &d - &(b * &c);
    let value = Jet::integer(1, linear.precision) - &(a + &d) + &determinant;
    matches!(value.sign(), Some(Sign::Positive | Sign::Negative))
}

/// The equations of pattern and event.
fn extended(
    family: &dyn Fn(&Jet) -> Result<System<Jet>>,
    unknowns: &[Jet],
    impacts: &[ExpectedImpact],
    condition: Condition,
    precision: &Precision,
) -> Result<Vec<Jet>> {
    let linear = Linear::enclosed(family(&unknowns[2 * impacts.len()])?, precision)?;
    let equations = pattern(&linear, impacts, condition)?;
    let mut values = equations.residual(unknowns)?;
    values.extend(extension(&equations, unknowns, condition)?);
    Ok(values)
}

/// The condition's equations: as many as it has unknowns beside the parameter, and one.
fn extension(equations: &Equations, unknowns: &[Jet], condition: Condition) -> Result<Vec<Jet>> {
    let m = equations.impacts.len();
    if let Condition::Grazing { after, side, .. } = condition {
        if m == 0 {
            let steady = equations.linear.steady(&unknowns[1])?;
            let zero = Jet::integer(0, equations.linear.precision);
            let [gap, speed, _] = equations.linear.gap(&steady, side, &zero)?;
            return Ok(vec![gap, speed]);
        }
        let legs = equations.legs(unknowns)?;
        let leg = legs.get(after).ok_or_else(|| Error::input(format!("there is no impact {after}")))?;
        let [gap, speed, _] = equations.linear.gap(&leg.flight, side, &unknowns[2 * m + 1])?;
        return Ok(vec![gap, speed]);
    }
    let (trace, determinant) = equations.multipliers(unknowns)?;
    let sum = determinant + &Jet::integer(1, equations.linear.precision);
    Ok(vec![if condition == Condition::Flip { sum + &trace } else { sum - &trace }])
}
