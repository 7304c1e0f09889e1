//! An orbit found in floats made precise, and proved by the checker of its certificate.

use std::f64::consts::TAU;

use num_rational::BigRational;

use super::{
    linear::{self, Matrix, apply},
    motion::{Motion, exact, float},
    pieces::{Flight, nearest, pieces},
};
use crate::{
    Accepted,
    certificate::{
        self,
        machine::{Certificate, Claim, Decimal, Impact, Machine},
    },
    error::{Error, Result},
    many::orbit::Orbit,
    number::{Ball, Elementary, FloatInterval, Plain, Real},
    orbit::{Verdict, decimal, radii, rounded},
};

/// A proved orbit.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct ProvedMachineOrbit {
    /// The certificate's contents.
    pub certificate: Certificate,
    /// Its text, which has passed the check.
    pub accepted: Accepted,
    /// The phases of the impacts, as fractions of the period.
    pub phases: Vec<Ball>,
    /// V_i > 0, per radian of the forcing.
    pub speeds: Vec<Ball>,
}

impl ProvedMachineOrbit {
    /// The radius of the box in which there is no other orbit of its pattern: of phases in radians of the
    /// forcing, of displacements and velocities in the certificate's scales.
    pub fn radius(&self) -> f64 {
        nearest(&exact(&self.certificate.radius))
    }
}

/// Newton steps in balls, and the step relative to the unknowns' scales after which they end.
const STEPS: u32 = 12;
const SMALL: f64 = 1e-21;
/// Decimals below an unknown's scale that are kept.
const PLACES: i32 = 24;
/// Digits of a preconditioner's entries.
const COARSE: i32 = 10;
/// How often a piece that the checker refuses is cut.
const CUTS: u32 = 100;

/// A solution to many digits, and about the inverse of the derivative there.
type Refined = (Vec<BigRational>, Vec<Vec<f64>>);

/// The equations of a pattern.
struct Equations {
    motion: Motion<Ball>,
    /// Stop and periods of each impact.
    strikes: Vec<(usize, u32)>,
}

/// Proves an orbit near one that was found in floats, unique in the largest box that the checker accepts.
/// `stop` is asked again and again whether to end.
///
/// # Errors
/// An interruption; an input error where the machine is not defined.
pub fn orbit(
    machine: &Machine,
    near: &Orbit,
    stop: &mut dyn FnMut() -> bool,
) -> Result<Verdict<ProvedMachineOrbit>> {
    let strikes = near.itinerary.strikes().iter().map(|strike| (strike.place, strike.periods)).collect();
    let equations = Equations { motion: Motion::new(machine)?, strikes };
    let undecided = |why: &str| Ok(Verdict::Undecided(why.to_string()));
    let start = equations.start(near);
    if start.iter().any(|x| !x.is_finite()) {
        return undecided("the motion between the impacts is not finite");
    }
    let scales = equations.scales(&start);
    let Some((centre, inverse)) = equations.refine(&start, &scales)? else {
        return undecided("Newton's method does not converge from this guess");
    };
    let mut certificate = equations.certificate(machine, &scales, &centre, &inverse)?;
    // The smallest box that passes, then the largest about it.
    let mut closes =
        |radius: &Decimal, within: &Decimal, certificate: &Certificate| -> Result<Option<String>> {
            let text = Certificate { radius: *radius, within: *within, ..certificate.clone() }.to_string();
            let why = refusal(text, stop)?.unwrap_or_default();
            Ok(Some(why)
                .filter(|why| !why.contains("stop before its end") && !why.contains("does not certainly")))
        };
    let mut found = None;
    let mut last = String::new();
    for places in (6..=22).rev() {
        let [within, radius] = [places, places - 1].map(|places| Decimal { digits: 1, places });
        match closes(&radius, &within, &certificate)? {
            None => {
                found = Some((radius, within));
                break;
            }
            Some(why) => last = why,
        }
    }
    let Some((radius, within)) = found else {
        return undecided(&format!("the checker does not accept the orbit: {last}"));
    };
    (certificate.radius, certificate.within) = (radius, within);
    for radius in radii() {
        let radius = decimal(&radius)?;
        if exact(&radius) > exact(&certificate.radius) && closes(&radius, &within, &certificate)?.is_none() {
            certificate.radius = radius;
            break;
        }
    }
    for i in 0..equations.strikes.len() {
        match pieces(&equations.flight(i, &centre)) {
            Ok(ends) => certificate.flights[i] = ends.iter().map(decimal).collect::<Result<_>>()?,
            Err(doubt) => return undecided(&format!("{doubt} after an impact")),
        }
    }
    let mut flights = std::mem::take(&mut certificate.flights);
    let text = |flights: &[_]| Certificate { flights: flights.to_vec(), ..certificate.clone() }.to_string();
    let refused = cut_until_accepted(&mut flights, &text, stop)?;
    certificate.flights = flights;
    if let Some(why) = refused {
        return undecided(&format!("the checker does not accept the orbit: {why}"));
    }
    // What can be said of the multipliers besides.
    let largest = near.multipliers.first().map_or(0.0, |x| x.0.hypot(x.1));
    let claim = if largest < 1.0 { Claim::Stable } else { Claim::Unstable };
    let claimed = Certificate { claim, ..certificate.clone() };
    for certificate in [claimed, certificate] {
        if let Ok(accepted) = accepted(certificate.to_string(), stop)? {
            let (phases, speeds) = equations.enclosed(&certificate, &centre);
            return Ok(Verdict::Proved(ProvedMachineOrbit { certificate, accepted, phases, speeds }));
        }
    }
    undecided("the checker does not accept the orbit")
}

/// A certificate, if the checker accepts it, or why it does not.
pub(super) fn accepted(
    text: String,
    stop: &mut dyn FnMut() -> bool,
) -> Result<std::result::Result<Accepted, String>> {
    match Accepted::until(text, stop) {
        Err(certificate::Rejection::Interrupted { .. }) => {
            Err(Error::interrupted("the check of a certificate was ended"))
        }
        found => Ok(found.map_err(|rejection| rejection.to_string())),
    }
}

/// Why the checker does not accept it.
fn refusal(text: String, stop: &mut dyn FnMut() -> bool) -> Result<Option<String>> {
    Ok(accepted(text, stop)?.err())
}

/// Cuts the piece that the checker doubts in two, until it doubts none; else why it does not accept the
/// certificate, whose `text` is that of these flights.
pub(super) fn cut_until_accepted(
    flights: &mut [Vec<Decimal>],
    text: &dyn Fn(&[Vec<Decimal>]) -> String,
    stop: &mut dyn FnMut() -> bool,
) -> Result<Option<String>> {
    for _ in 0..CUTS {
        let Some(why) = refusal(text(flights), stop)? else { return Ok(None) };
        let Some((piece, flight)) = doubted(&why) else { return Ok(Some(why)) };
        let Some(ends) = flights.get_mut(flight - 1) else { return Ok(Some(why)) };
        let to = exact(&ends[piece - 1]);
        let from = if piece > 1 { exact(&ends[piece - 2]) } else { BigRational::default() };
        let middle = rounded(&((&from + &to) / BigRational::from_integer(2.into())), 14);
        if middle <= from || middle >= to {
            return Ok(Some(why));
        }
        ends.insert(piece - 1, decimal(&middle)?);
    }
    refusal(text(flights), stop)
}

/// `… on piece P of flight F is not certainly positive`.
fn doubted(why: &str) -> Option<(usize, usize)> {
    let (_, rest) = why.split_once(" on piece ")?;
    let (piece, rest) = rest.split_once(" of flight ")?;
    Some((piece.parse().ok()?, rest.split(' ').next()?.parse().ok()?))
}

/// The power of ten nearest to a positive number.
pub(super) fn power_of_ten(x: f64) -> BigRational {
    let power = num_traits::pow(BigRational::from_integer(10.into()), x.log10().round().abs() as usize);
    if x < 1.0 { power.recip() } else { power }
}

/// A few digits.
fn significant(x: f64) -> Result<Decimal> {
    let size = if x == 0.0 { 0 } else { x.abs().log10().floor() as i32 };
    let places = (COARSE - size).clamp(0, 30) as u32;
    decimal(&rounded(&BigRational::from_float(x).unwrap_or_default(), places))
}

impl Equations {
    fn next(&self, i: usize) -> usize {
        (i + 1) % self.strikes.len()
    }

    /// The unknowns in floats: phase, displacements and velocities just before each impact.
    fn start(&self, near: &Orbit) -> Vec<f64> {
        let (n, m, motion) = (self.motion.size, self.strikes.len(), self.motion.plain());
        let times: Vec<f64> = near.impacts.iter().map(|impact| impact.time).collect();
        let after: Vec<Plain> = near.state.q.iter().chain(near.state.u.iter()).map(|&x| Plain(x)).collect();
        let mut y = motion.lifted(&after, &Plain(times[0]), times[0].abs());
        let mut all = vec![Vec::new(); m];
        for i in 0..m {
            let next = self.next(i);
            let duration = TAU * f64::from(self.strikes[i].1) + times[next] - times[i];
            y = apply(&motion.flow(&Plain(duration), duration.abs()), &y, &());
            all[next] = [vec![times[next]], y[..2 * n].iter().map(|x| x.0).collect()].concat();
            y = motion.kicked(self.strikes[next].0, &y);
        }
        all.concat()
    }

    /// A certificate of the orbit whose box, flights and claim are still to be found.
    fn certificate(
        &self,
        machine: &Machine,
        scales: &[f64],
        centre: &[BigRational],
        inverse: &[Vec<f64>],
    ) -> Result<Certificate> {
        let block = 2 * self.motion.size + 1;
        let impact = |(i, &(stop, periods)): (usize, &(usize, u32))| -> Result<Impact> {
            let x = &centre[i * block..(i + 1) * block];
            let state = x[1..].iter().map(decimal).collect::<Result<_>>()?;
            Ok(Impact { stop, periods: periods.into(), phase: decimal(&x[0])?, state })
        };
        let row = |row: &Vec<f64>| row.iter().map(|&x| significant(x)).collect::<Result<Vec<_>>>();
        Ok(Certificate {
            machine: machine.clone(),
            claim: Claim::Open,
            scales: scales[1..block].iter().map(|&x| decimal(&power_of_ten(x))).collect::<Result<_>>()?,
            impacts: self.strikes.iter().enumerate().map(impact).collect::<Result<_>>()?,
            radius: Decimal { digits: 1, places: 0 },
            within: Decimal { digits: 1, places: 0 },
            inverse: inverse.iter().map(row).collect::<Result<_>>()?,
            // One short piece each: what the checker says of them shows that all before was accepted.
            flights: vec![vec![Decimal { digits: 1, places: 9 }]; self.strikes.len()],
        })
    }

    /// About the size of each unknown, 1 for phases: those of one coordinate have one scale, not far below
    /// those of the others.
    fn scales(&self, x: &[f64]) -> Vec<f64> {
        let block = 2 * self.motion.size + 1;
        let most = |j: usize| x.iter().skip(j).step_by(block).fold(0.0, |most: f64, x| most.max(x.abs()));
        let all: Vec<f64> = (1..block).map(most).collect();
        let largest = all.iter().fold(1e-12, |most: f64, &x| most.max(x));
        let one: Vec<f64> =
            std::iter::once(1.0).chain(all.iter().map(|x| x.clamp(largest * 1e-3, 1e6))).collect();
        one.repeat(self.strikes.len())
    }

    /// The left sides of all equations.
    fn residual(&self, x: &[Ball]) -> Vec<Ball> {
        let (n, motion) = (self.motion.size, &self.motion);
        let block = 2 * n + 1;
        let mut all = Vec::with_capacity(x.len());
        for (i, &(stop, periods)) in self.strikes.iter().enumerate() {
            let (here, next) = (i * block, self.next(i) * block);
            let y = motion.lifted(&x[here + 1..here + block], &x[here], float(&x[here]).abs());
            all.push(motion.gap(stop, &y)[0].clone());
            let turn = Ball::pi(&motion.context)
                * &Ball::ratio(&BigRational::from_integer((2 * i64::from(periods)).into()), &motion.context);
            let duration = turn + &x[next] - &x[here];
            let flow = motion.flow(&duration, float(&duration).abs());
            let end = apply(&flow, &motion.kicked(stop, &y), &motion.context);
            all.extend((0..2 * n).map(|k| end[k].clone() - &x[next + 1 + k]));
        }
        all
    }

    /// Their derivatives, in floats.
    fn derivatives(&self, x: &[f64]) -> Matrix<Plain> {
        let (n, motion) = (self.motion.size, self.motion.plain());
        let block = 2 * n + 1;
        let mut rows = vec![vec![Plain(0.0); x.len()]; x.len()];
        for (i, &(stop, periods)) in self.strikes.iter().enumerate() {
            let (here, next) = (i * block, self.next(i) * block);
            let state: Vec<Plain> = x[here + 1..here + block].iter().map(|&x| Plain(x)).collect();
            let y = motion.lifted(&state, &Plain(x[here]), x[here].abs());
            let duration = TAU * f64::from(periods) + x[next] - x[here];
            let flow = motion.flow(&Plain(duration), duration.abs());
            let later = motion.field(&apply(&flow, &motion.kicked(stop, &y), &()));
            // What goes with the phase is that part of Y which is time.
            let mut by_time = motion.field(&y);
            by_time[..2 * n].iter_mut().for_each(|x| *x = Plain(0.0));
            let unit = |j: usize| (0..y.len()).map(|k| Plain(f64::from(u8::from(j == k)))).collect();
            let directions: Vec<Vec<Plain>> = std::iter::once(by_time).chain((0..2 * n).map(unit)).collect();
            for (j, direction) in directions.iter().enumerate() {
                rows[here][here + j] = motion.gap(stop, direction)[0];
                let end = apply(&flow, &motion.kicked(stop, direction), &());
                for k in 0..2 * n {
                    rows[here + 1 + k][here + j].0 += end[k].0;
                }
            }
            for k in 0..2 * n {
                rows[here + 1 + k][here].0 -= later[k].0;
                rows[here + 1 + k][next].0 += later[k].0;
                rows[here + 1 + k][next + 1 + k].0 -= 1.0;
            }
        }
        rows
    }

    /// A solution to many digits, and about the inverse of the derivative there; `None` if Newton's method
    /// does not converge.
    fn refine(&self, start: &[f64], scales: &[f64]) -> Result<Option<Refined>> {
        let place = |scale: f64| (PLACES - scale.log10().floor() as i32).clamp(0, 32) as u32;
        let number = |(x, scale): (&f64, &f64)| Some(rounded(&BigRational::from_float(*x)?, place(*scale)));
        let Some(mut x) = start.iter().zip(scales).map(number).collect::<Option<Vec<_>>>() else {
            return Ok(None);
        };
        let Some(inverse) = linear::inverse(&self.derivatives(start), |x| x.0.abs(), &()) else {
            return Ok(None);
        };
        for _ in 0..STEPS {
            let balls: Vec<Ball> = x.iter().map(|x| Ball::ratio(x, &self.motion.context)).collect();
            let residual: Vec<Plain> = self.residual(&balls).iter().map(|x| Plain(float(x))).collect();
            let step = apply(&inverse, &residual, &());
            let mut largest = 0.0f64;
            for ((x, step), &scale) in x.iter_mut().zip(&step).zip(scales) {
                let Some(exact) = BigRational::from_float(step.0) else { return Ok(None) };
                largest = largest.max(step.0.abs() / scale);
                *x = rounded(&(&*x - exact), place(scale));
            }
            if largest < SMALL {
                let inverse = inverse.iter().map(|row| row.iter().map(|x| x.0).collect()).collect();
                return Ok(Some((x, inverse)));
            }
            if largest > 1.0 {
                break;
            }
        }
        Ok(None)
    }

    /// The flight after impact i.
    fn flight(&self, i: usize, centre: &[BigRational]) -> Flight {
        let (n, next) = (self.motion.size, self.next(i));
        let block = 2 * n + 1;
        let motion = self.motion.intervals();
        let x: Vec<f64> = centre[i * block..(i + 1) * block].iter().map(nearest).collect();
        let point = |x: f64| FloatInterval::from_bounds(x, x);
        let state: Vec<FloatInterval> = x[1..].iter().map(|&x| point(x)).collect();
        let y = motion.lifted(&state, &point(x[0]), x[0].abs());
        let start = motion.kicked(self.strikes[i].0, &y);
        let duration = TAU * f64::from(self.strikes[i].1) + nearest(&centre[next * block]) - x[0];
        Flight { motion, start, stops: Some([self.strikes[i].0, self.strikes[next].0]), duration }
    }

    /// Phases as fractions of the period and speeds, in the smaller box.
    fn enclosed(&self, certificate: &Certificate, centre: &[BigRational]) -> (Vec<Ball>, Vec<Ball>) {
        let (motion, context) = (&self.motion, &self.motion.context);
        let block = 2 * motion.size + 1;
        // Series without their rests and the machine in the middle of its intervals are off by less than this
        // thousandth.
        let within = exact(&certificate.within) * BigRational::new(1001.into(), 1000.into());
        let turn = Ball::pi(context) * &Ball::integer(2, context);
        let one = |(i, &(stop, _)): (usize, &(usize, u32))| {
            let x: Vec<Ball> = (0..block)
                .map(|j| {
                    let scale = if j == 0 {
                        BigRational::from_integer(1.into())
                    } else {
                        exact(&certificate.scales[j - 1])
                    };
                    let (y, r) = (&centre[i * block + j], &within * scale);
                    Ball::between(&(y - &r), &(y + &r), context)
                })
                .collect();
            let y = motion.lifted(&x[1..], &x[0], float(&x[0]).abs());
            let [_, rate] = motion.gap(stop, &y);
            (x[0].clone() / &turn, -rate)
        };
        self.strikes.iter().enumerate().map(one).unzip()
    }
}
