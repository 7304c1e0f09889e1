//! Periodic orbits of machines with a given impact pattern, by Newton's method on the impacts; their
//! multipliers; whether they are orbits.
//!
//! The unknowns are the state X just after the first impact, 2n numbers, and time and incoming speed t_i, V_i
//! of each impact; impact i changes the velocities by (1 + τ) V_i M⁻¹wᵀ/(w M⁻¹wᵀ), Newton's law for one stop.
//! The equations: at t_{i+1} + 2π n_i the gap is 0 and its rate −V_{i+1}; after the last leg and the first
//! impact the state is X again. They are the equations (19) of the paper for any number of degrees of
//! freedom, and as those they are smooth where an impact has V = 0. That the speeds are unknowns of their
//! own, by which the velocities jump, keeps the equations well conditioned near grazing, where the flow with
//! its impacts expands by 1/V.
//!
//! Not here: rest on stops, and several stops hit at one instant; an orbit that has them is not found.

use std::{f64::consts::TAU, fmt};

use nalgebra::Schur;

use super::{
    LinearFlow, MachineState, RealMatrix, RealVector,
    contact::StopContact,
    grazing::determinant,
    simulate::{MachineEvent, MachineSimulator, RunEnd},
};
use crate::{
    error::{Error, Result},
    oscillator::{
        Time,
        orbit::{Linearised, Multipliers, newton},
    },
};

/// An impact and the periods from its phase to the next one's.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StopStrike {
    /// The stop that is hit.
    pub stop: usize,
    /// n_i: the next impact is 2π n_i + t_{i+1} − t_i later.
    pub periods: u32,
}

/// The impact pattern of an orbit with the stop of each impact; or no impact and a period.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StopPattern {
    strikes: Vec<StopStrike>,
    periods: u32,
}

impl StopPattern {
    /// An orbit without impacts that repeats after `periods` periods.
    ///
    /// # Errors
    /// An input error for 0.
    pub fn free(periods: u32) -> Result<StopPattern> {
        Self::checked(Vec::new(), periods)
    }

    /// The orbit with these impacts, in this order.
    ///
    /// # Errors
    /// An input error if the periods sum to 0 or to more than 2³² − 1.
    pub fn new(strikes: Vec<StopStrike>) -> Result<StopPattern> {
        let sum = strikes.iter().try_fold(0u32, |sum, strike| sum.checked_add(strike.periods));
        let periods = sum.ok_or_else(|| Error::input("the pattern's periods sum to more than 2^32 - 1"))?;
        Self::checked(strikes, periods)
    }

    fn checked(strikes: Vec<StopStrike>, periods: u32) -> Result<StopPattern> {
        if periods == 0 {
            return Err(Error::input("the pattern of an orbit must have a period of at least 1"));
        }
        Ok(StopPattern { strikes, periods })
    }

    /// The impacts; empty for an orbit without.
    pub fn strikes(&self) -> &[StopStrike] {
        &self.strikes
    }

    /// n, in forcing periods.
    pub fn periods(&self) -> u32 {
        self.periods
    }

    /// Its text, as `3,3`, with the stop's name at each impact if the machine has several.
    pub fn named(&self, contacts: &[StopContact]) -> String {
        let show = |strike: &StopStrike| match contacts {
            [_] => strike.periods.to_string(),
            many => format!("{} {}", strike.periods, many[strike.stop].name),
        };
        match &self.strikes[..] {
            [] => format!("free {}", self.periods),
            all => all.iter().map(show).collect::<Vec<_>>().join(","),
        }
    }
}

/// An impact of an orbit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MachineOrbitImpact {
    /// The stop.
    pub stop: usize,
    /// t_i, near the phase: within one turn of [0, 2π).
    pub time: f64,
    /// V_i, per radian of the forcing.
    pub speed: f64,
}

/// Whether a solution is an orbit.
#[derive(Debug, Clone, PartialEq)]
pub enum MachineAdmissibility {
    /// Every impact comes in, and on the legs between them the simulator finds no other contact.
    Admissible,
    /// Rounding decides: why.
    Marginal(MachineObstacle),
    /// It is not: why.
    No(MachineObstacle),
}

/// What is in the way of an orbit.
#[derive(Debug, Clone, PartialEq)]
pub enum MachineObstacle {
    /// This impact, from 0, has V ≤ 0.
    Outgoing(usize),
    /// On the leg after impact `leg` (0 for an orbit without impacts) the stop is met, after this time.
    Met {
        /// The leg.
        leg: usize,
        /// The stop's name.
        stop: String,
        /// Radians of the forcing since the leg began.
        after: f64,
    },
    /// On that leg, that stop is touched without impact.
    Touched {
        /// The leg.
        leg: usize,
        /// The stop's name.
        stop: String,
    },
    /// At this impact, from 0, several stops are met at one instant.
    Together(usize),
    /// The simulator did not follow this leg, from 0, to its end.
    Lost(usize),
}

impl fmt::Display for MachineObstacle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MachineObstacle::Outgoing(i) => write!(f, "impact {} does not come in", i + 1),
            MachineObstacle::Met { leg, stop, after } => {
                write!(f, "meets stop {stop} {:.6} periods into leg {}", after / TAU, leg + 1)
            }
            MachineObstacle::Touched { leg, stop } => {
                write!(f, "touches stop {stop} on leg {}, to rounding", leg + 1)
            }
            MachineObstacle::Together(i) => {
                write!(f, "impact {} meets several stops at one instant", i + 1)
            }
            MachineObstacle::Lost(leg) => write!(f, "leg {} could not be followed to its end", leg + 1),
        }
    }
}

/// A solution of the equations.
#[derive(Debug, Clone)]
pub struct MachineOrbit {
    /// Its pattern.
    pub pattern: StopPattern,
    /// Just after the first impact; at phase 0 for an orbit without impacts.
    pub state: MachineState,
    /// Its impacts.
    pub impacts: Vec<MachineOrbitImpact>,
    /// What is left of the equations, relative to the size of the motion.
    pub residual: f64,
    /// Real and imaginary part of each, by modulus, the largest first.
    pub multipliers: Vec<(f64, f64)>,
    /// Whether it is an orbit.
    pub admissibility: MachineAdmissibility,
}

/// The equations at one machine.
struct Equations<'s> {
    simulator: &'s MachineSimulator,
    pattern: &'s StopPattern,
    /// The unit of X and V.
    scale: f64,
}

impl Equations<'_> {
    fn flow(&self) -> &LinearFlow {
        self.simulator.flow()
    }

    fn size(&self) -> usize {
        self.simulator.equations().size()
    }

    fn contact(&self, i: usize) -> &StopContact {
        &self.simulator.contacts().all()[self.pattern.strikes[i].stop]
    }

    /// (1 + τ) M⁻¹wᵀ/(w M⁻¹wᵀ).
    fn kick(&self, i: usize) -> RealVector {
        let (contacts, stop) = (self.simulator.contacts(), self.pattern.strikes[i].stop);
        contacts.push(stop) * ((1.0 + contacts.all()[stop].restitution) / contacts.mobility(stop))
    }

    /// (q′, q″).
    fn field(&self, state: &MachineState) -> RealVector {
        let bend = self.simulator.equations().acceleration(state.t, &state.q, &state.u);
        stacked(&state.u, &bend)
    }

    fn duration(&self, times: &[f64], i: usize) -> Result<f64> {
        let m = times.len();
        let duration = times[(i + 1) % m] - times[i] + TAU * f64::from(self.pattern.strikes[i].periods);
        if duration > 0.0 {
            Ok(duration)
        } else {
            Err(Error::input("an impact does not follow the one before"))
        }
    }

    fn split(&self, z: &[f64]) -> (MachineState, Vec<f64>, Vec<f64>) {
        let n = self.size();
        let impacts = &z[2 * n..];
        let times: Vec<f64> = impacts.iter().step_by(2).copied().collect();
        let speeds = impacts.iter().skip(1).step_by(2).map(|v| v * self.scale).collect();
        let part = |from: usize| RealVector::from_fn(n, |i, _| z[from + i] * self.scale);
        let t = times.first().copied().unwrap_or(0.0);
        (MachineState { t: turned(t), q: part(0), u: part(n) }, times, speeds)
    }

    /// F and ∂F/∂z, by the flow's own derivatives. Cost: O(m (n + m)² n).
    fn linearise(&self, z: &[f64]) -> Result<Linearised> {
        let (n, m, s) = (self.size(), self.pattern.strikes.len(), self.scale);
        let (first, times, speeds) = self.split(z);
        let (mut state, columns) = (first.clone(), 2 * n + 2 * m);
        // The derivative of the state at the time of the present impact, just after it.
        let mut d = RealMatrix::zeros(2 * n, columns);
        d.fill_diagonal(s);
        let (mut residual, mut jacobian) = (Vec::new(), Vec::new());
        for i in 0..m {
            let next = (i + 1) % m;
            let (time, speed) = (2 * n + 2 * next, 2 * n + 2 * next + 1);
            let duration = self.duration(&times, i)?;
            let phi = self.flow().transition(duration);
            let begin = self.field(&state);
            let mut end = self.flow().after(&state, duration);
            end.t = turned(times[next]);
            d = &phi * d;
            let earlier = &phi * begin;
            add_column(&mut d, 2 * n + 2 * i, -1.0, &earlier);
            add_column(&mut d, time, 1.0, &self.field(&end));
            let contact = self.contact(next);
            let [_, speed_of_stop, bend_of_stop] = contact.position.at(end.t);
            let [gap, rate] = contact.gap(&end);
            let seen = |from: usize| -> Vec<f64> {
                let part = d.rows(from, n);
                (0..columns).map(|j| contact.row.dot(&part.column(j)) / s).collect()
            };
            let (mut gap_row, mut rate_row) = (seen(0), seen(n));
            gap_row[time] -= speed_of_stop / s;
            rate_row[time] -= bend_of_stop / s;
            rate_row[speed] += 1.0;
            residual.extend([gap / s, (rate + speeds[next]) / s]);
            jacobian.extend([gap_row, rate_row]);
            let kick = self.kick(next);
            end.u.axpy(speeds[next], &kick, 1.0);
            for k in 0..n {
                d[(n + k, speed)] += kick[k] * s;
            }
            state = end;
        }
        if m == 0 {
            let duration = TAU * f64::from(self.pattern.periods);
            d = self.flow().transition(duration) * d;
            state = self.flow().after(&state, duration);
        }
        let (now, then) = (stacked(&state.q, &state.u), stacked(&first.q, &first.u));
        for k in 0..2 * n {
            residual.push((now[k] - then[k]) / s);
            let mut row: Vec<f64> = d.row(k).iter().map(|x| x / s).collect();
            row[k] -= 1.0;
            jacobian.push(row);
        }
        let slope = vec![0.0; residual.len()];
        Ok(Linearised { residual, jacobian, slope })
    }

    /// X of given times and speeds: the equations of periodicity are linear in it. Where they have no one
    /// solution (a motion without stiffness or damping), the smallest of the best.
    fn complete(&self, impacts: &[f64]) -> Result<Vec<f64>> {
        let n = self.size();
        let mut z = vec![0.0; 2 * n];
        z.extend(impacts);
        let Linearised { residual, jacobian, .. } = self.linearise(&z)?;
        let rows = 2 * self.pattern.strikes.len();
        let matrix = RealMatrix::from_fn(2 * n, 2 * n, |i, j| jacobian[rows + i][j]);
        let right = RealVector::from_fn(2 * n, |i, _| -residual[rows + i]);
        let size = right.amax().max(1.0);
        let known = matrix.clone().lu().solve(&right).filter(|x| x.amax() <= 1e10 * size);
        let found = match known {
            Some(x) => x,
            None => matrix
                .svd(true, true)
                .solve(&right, 1e-10)
                .map_err(|error| Error::input(format!("no state to start from: {error}")))?,
        };
        z[..2 * n].copy_from_slice(found.as_slice());
        Ok(z)
    }

    /// The motion linearised once around, after the first impact, at fixed times.
    ///
    /// At an impact a displacement δ before it becomes S δ, S = J + (f⁻ − κ z″ − f⁺)(w, 0)/V, where J = I − κ
    /// (0, w) is Newton's law with κ = (0, (1 + τ) M⁻¹wᵀ/(w M⁻¹wᵀ)), f = (q′, q″), z″ the gap's second
    /// derivative before it, and w δq/V the delay of the impact.
    fn monodromy(&self, z: &[f64]) -> Result<RealMatrix> {
        let (n, m) = (self.size(), self.pattern.strikes.len());
        let (mut state, times, speeds) = self.split(z);
        if m == 0 {
            return Ok(self.flow().transition(TAU * f64::from(self.pattern.periods)));
        }
        let mut all = RealMatrix::identity(2 * n, 2 * n);
        for i in 0..m {
            let next = (i + 1) % m;
            let duration = self.duration(&times, i)?;
            all = self.flow().transition(duration) * all;
            let mut end = self.flow().after(&state, duration);
            end.t = turned(times[next]);
            let (contact, kick) = (self.contact(next), self.kick(next));
            let bend = contact.acceleration(self.simulator.equations(), &end);
            let before = self.field(&end);
            end.u.axpy(speeds[next], &kick, 1.0);
            let kappa = stacked(&RealVector::zeros(n), &kick);
            let turn = (before - &kappa * bend - self.field(&end)) / speeds[next];
            let zero = RealVector::zeros(n);
            let delay = stacked(&contact.row, &zero).transpose() * &all;
            let rate = stacked(&zero, &contact.row).transpose() * &all;
            all += turn * delay - kappa * rate;
            state = end;
        }
        Ok(all)
    }

    /// Each leg by the simulator, from the state just after its impact up to the next.
    fn admissibility(&self, z: &[f64]) -> Result<MachineAdmissibility> {
        let (mut state, times, speeds) = self.split(z);
        let m = times.len();
        let name = |stop: usize| self.simulator.contacts().all()[stop].name.clone();
        if let Some(i) = speeds.iter().position(|speed| speed.is_nan() || *speed <= 0.0) {
            return Ok(MachineAdmissibility::No(MachineObstacle::Outgoing(i)));
        }
        let mut marginal = None;
        for leg in 0..m.max(1) {
            let next = if m == 0 { 0 } else { (leg + 1) % m };
            let duration = match m {
                0 => TAU * f64::from(self.pattern.periods),
                _ => self.duration(&times, leg)?,
            };
            let begin = Time::new(0, state.t);
            let mut run = match self.simulator.start(begin, state.q.as_slice(), state.u.as_slice()) {
                Ok(run) => run,
                Err(_) if m == 0 => {
                    let stop = self.simulator.contacts().all().iter().position(|c| c.gap(&state)[0] < 0.0);
                    let stop = name(stop.unwrap_or(0));
                    return Ok(MachineAdmissibility::No(MachineObstacle::Met { leg, stop, after: 0.0 }));
                }
                Err(error) => return Err(error),
            };
            // What the legs' own impacts look like to the simulator: at an end of the leg, at the stop that
            // is hit there. Slow ones it does not see, as they are not as deep as the minimum depth; that
            // they are there is in the equations.
            let own = |stop: usize, after: f64| {
                let at = |i: usize| m > 0 && self.pattern.strikes[i].stop == stop;
                (at(leg) && after <= CLOSE) || (at(next) && duration - after <= CLOSE)
            };
            let until = begin.after(duration);
            loop {
                match run.next(until) {
                    MachineEvent::Tangency(touch) if own(touch.stop, touch.time.since(begin)) => {}
                    MachineEvent::Tangency(touch) => {
                        marginal = Some(MachineObstacle::Touched { leg, stop: name(touch.stop) });
                    }
                    MachineEvent::Impact(impact) => {
                        let after = impact.time.since(begin);
                        if !(m > 0 && impact.stop == self.pattern.strikes[next].stop)
                            || duration - after > CLOSE
                        {
                            let stop = name(impact.stop);
                            return Ok(MachineAdmissibility::No(MachineObstacle::Met { leg, stop, after }));
                        }
                        if impact.together > 1 {
                            return Ok(MachineAdmissibility::Marginal(MachineObstacle::Together(next)));
                        }
                        break;
                    }
                    MachineEvent::Stick(stick) => {
                        let (stop, after) = (name(stick.stop), stick.time.since(begin));
                        return Ok(MachineAdmissibility::No(MachineObstacle::Met { leg, stop, after }));
                    }
                    MachineEvent::Release(_) => {}
                    MachineEvent::End(RunEnd::Reached) => break,
                    MachineEvent::End(_) => {
                        return Ok(MachineAdmissibility::Marginal(MachineObstacle::Lost(leg)));
                    }
                }
            }
            // Another stop at the instant of the impact.
            if m > 0 {
                let end = self.flow().after(&state, duration);
                let depth = self.simulator.settings().minimum_depth;
                let (stop, all) = (self.pattern.strikes[next].stop, self.simulator.contacts().all());
                if (0..all.len()).any(|other| other != stop && all[other].gap(&end)[0] <= depth) {
                    return Ok(MachineAdmissibility::Marginal(MachineObstacle::Together(next)));
                }
            }
            if m > 0 {
                state = self.flow().after(&state, duration);
                state.t = turned(times[next]);
                state.u.axpy(speeds[next], &self.kick(next), 1.0);
            }
        }
        Ok(marginal.map_or(MachineAdmissibility::Admissible, MachineAdmissibility::Marginal))
    }
}

/// A contact that the simulator sees this near an end of a leg, at the stop hit there, is that impact.
const CLOSE: f64 = 1e-5;

/// The orbit of a pattern nearest to times and incoming speeds t_1, V_1, …, t_m, V_m (none without impacts):
/// Newton's method with exact derivatives.
///
/// # Errors
/// An input error if the start has another length, a stop is not there, or Newton's method does not end.
pub fn find(simulator: &MachineSimulator, pattern: &StopPattern, start: &[f64]) -> Result<MachineOrbit> {
    let m = pattern.strikes.len();
    if start.len() != 2 * m {
        return Err(Error::input(format!(
            "the start has {} numbers; the pattern takes {}",
            start.len(),
            2 * m
        )));
    }
    let stops = simulator.contacts().all().len();
    if pattern.strikes.iter().any(|strike| strike.stop >= stops) {
        return Err(Error::input("an impact at a stop that the machine does not have"));
    }
    let size = simulator.scale();
    let fastest = start.iter().skip(1).step_by(2).fold(0.0, |most: f64, v| most.max(v.abs()));
    let scale = if size > 0.0 {
        size
    } else if fastest > 0.0 {
        fastest
    } else {
        1.0
    };
    let equations = Equations { simulator, pattern, scale };
    let scaled: Vec<f64> =
        start.iter().enumerate().map(|(i, x)| if i % 2 == 0 { *x } else { x / scale }).collect();
    let root = newton(equations.complete(&scaled)?, |z| equations.linearise(z))?;
    let (state, times, speeds) = equations.split(&root.z);
    let monodromy = equations.monodromy(&root.z)?;
    let factor: f64 = (0..m).map(|i| equations.contact(i).restitution.powi(2)).product();
    let product = determinant(simulator.equations(), pattern.periods) * factor;
    let impacts = pattern.strikes.iter().zip(times.iter().zip(&speeds));
    Ok(MachineOrbit {
        pattern: pattern.clone(),
        state,
        impacts: impacts
            .map(|(strike, (&time, &speed))| MachineOrbitImpact { stop: strike.stop, time, speed })
            .collect(),
        residual: root.residual,
        multipliers: eigenvalues(&monodromy, product)?,
        admissibility: equations.admissibility(&root.z)?,
    })
}

/// Eigenvalues by modulus, the largest first, of a matrix of the given determinant, from which those of a 2 ×
/// 2 matrix are taken without cancellation.
///
/// # Errors
/// A matrix that is not finite.
pub(super) fn eigenvalues(matrix: &RealMatrix, determinant: f64) -> Result<Vec<(f64, f64)>> {
    if matrix.nrows() == 2 {
        return Ok(Multipliers { trace: matrix.trace(), determinant }.values().to_vec());
    }
    if matrix.iter().any(|x| !x.is_finite()) {
        return Err(Error::input("the linearised motion is not finite"));
    }
    let schur = Schur::try_new(matrix.clone(), f64::EPSILON, 1_000 * matrix.nrows());
    let schur = schur.ok_or_else(|| Error::input("the multipliers were not found"))?;
    let mut all: Vec<(f64, f64)> = schur.complex_eigenvalues().iter().map(|x| (x.re, x.im)).collect();
    all.sort_by(|a, b| {
        let size = |x: &(f64, f64)| x.0.hypot(x.1);
        size(b).total_cmp(&size(a)).then(b.1.total_cmp(&a.1))
    });
    Ok(all)
}

/// A time's phase, in [0, 2π].
fn turned(t: f64) -> f64 {
    t.rem_euclid(TAU)
}

fn stacked(q: &RealVector, u: &RealVector) -> RealVector {
    RealVector::from_iterator(q.len() + u.len(), q.iter().chain(u.iter()).copied())
}

fn add_column(matrix: &mut RealMatrix, j: usize, factor: f64, column: &RealVector) {
    matrix.column_mut(j).axpy(factor, column, 1.0);
}
