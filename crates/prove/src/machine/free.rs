//! The motion of a machine without impacts, proved by the checker of its certificate.

use std::f64::consts::TAU;

use super::{
    motion::Motion,
    orbit::{accepted, cut_until_accepted, power_of_ten},
    pieces::{Flight, pieces},
};
use crate::{
    Accepted,
    certificate::machine::{Claim, Decimal, FreeCertificate, Machine},
    error::Result,
    many::orbit::Orbit,
    number::FloatInterval,
    orbit::{Verdict, decimal},
};

/// A proved motion without impacts.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct ProvedFreeMachine {
    /// The certificate's contents.
    pub certificate: FreeCertificate,
    /// Its text, which has passed the check.
    pub accepted: Accepted,
}

/// Proves that the motion without impacts that was found in floats is the only one of its period, clear of
/// every stop, and stable or not. `stop` is asked again and again whether to end.
///
/// # Errors
/// An interruption; an input error where the machine is not defined.
pub fn free_motion(
    machine: &Machine,
    near: &Orbit,
    stop: &mut dyn FnMut() -> bool,
) -> Result<Verdict<ProvedFreeMachine>> {
    let state: Vec<f64> = near.state.q.iter().chain(near.state.u.iter()).copied().collect();
    if state.iter().any(|x| !x.is_finite()) {
        return Ok(Verdict::Undecided("the motion without impacts is not finite".into()));
    }
    // Only their ratios count.
    let largest = state.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let part = |x: &f64| if largest > 0.0 { (x.abs() / largest).max(1e-3) } else { 1.0 };
    let scale = |x: &f64| decimal(&power_of_ten(part(x)));
    let scales = state.iter().map(scale).collect::<Result<Vec<Decimal>>>()?;
    let motion = Motion::new(machine)?.intervals();
    let point = |x: f64| FloatInterval::from_bounds(x, x);
    let start = motion.lifted(&state.iter().map(|&x| point(x)).collect::<Vec<_>>(), &point(0.0), 0.0);
    let ends = match pieces(&Flight { motion, start, stops: None, duration: TAU }) {
        Ok(ends) => ends.iter().map(decimal).collect::<Result<Vec<Decimal>>>()?,
        Err(doubt) => return Ok(Verdict::Undecided(format!("{doubt} after phase 0"))),
    };
    let certificate = |claim, pieces: &[Decimal]| FreeCertificate {
        machine: machine.clone(),
        claim,
        scales: scales.clone(),
        pieces: pieces.to_vec(),
    };
    let mut flights = [ends];
    let text = |flights: &[Vec<Decimal>]| certificate(Claim::Open, &flights[0]).to_string();
    if let Some(why) = cut_until_accepted(&mut flights, &text, stop)? {
        return Ok(Verdict::Undecided(format!("the checker does not accept the motion: {why}")));
    }
    // What can be said of the multipliers besides.
    let largest = near.multipliers.first().map_or(0.0, |x| x.0.hypot(x.1));
    let claim = if largest < 1.0 { Claim::Stable } else { Claim::Unstable };
    let claimed = certificate(claim, &flights[0]);
    let open = certificate(Claim::Open, &flights[0]);
    for certificate in [claimed, open] {
        if let Ok(accepted) = accepted(certificate.to_string(), stop)? {
            return Ok(Verdict::Proved(ProvedFreeMachine { certificate, accepted }));
        }
    }
    Ok(Verdict::Undecided("the checker does not accept the motion".into()))
}
