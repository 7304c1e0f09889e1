//! Grazing bifurcations of the motion without impacts: where it touches a stop as a parameter varies, and the
//! local map there.
//!
//! The motion is known in closed form ([`LinearEquations::response`]), and so is its gap to each stop, a
//! trigonometric sum. [`locate`] follows the least gap from one value of the parameter both ways and finds
//! where it is zero first. The map there is the paper's, with the state x = (q, q′) less that of the motion,
//! at the phase t_G of grazing, 2n numbers:
//!
//! - A = the flow over one period, (2);
//! - C = (w, 0): the gap is C x + eµ to first order, (5), (26);
//! - B = √(2a_G) (1 + τ) (0, M⁻¹wᵀ/(w M⁻¹wᵀ)): an impact of incoming speed V changes the velocities by (1 +
//!   τ) V M⁻¹wᵀ/(w M⁻¹wᵀ), Newton's law for one stop ([`contact`](super::contact)), and V = √(2a_G) y, (44);
//!   with one degree of freedom B = (0, √(2a_G)(1 + τ));
//! - e = the rate of the least gap with the parameter, (26).
//!
//! Not here: which patterns exist (`pattern`), motions with impacts (`orbit`).

use std::f64::consts::{PI, TAU};

use num_rational::BigRational;

use super::{
    LinearEquations, LinearFlow, Machine, MachineFamily, MachineSlope, MachineState, Periodic, RealMatrix,
    RealVector, contact::Contacts, half::HalfPeriod, modes::Pair, orbit::eigenvalues,
};
use crate::{
    error::{Error, Result},
    oscillator::{Series, orbit::minimum_within},
    pattern::{Entry, Map, Report},
};

/// A local minimum of a stop's gap along the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeastGap {
    /// The stop.
    pub stop: usize,
    /// The phase, in [0, 2π).
    pub phase: f64,
    /// The gap, in the scene's unit.
    pub gap: f64,
}

/// The motion without impacts at one value of a parameter, with its derivatives.
#[derive(Debug, Clone)]
pub struct FreeMotion {
    equations: LinearEquations,
    contacts: Contacts,
    motion: Periodic,
    drift: Periodic,
    /// The gap of each stop, and its derivative in the parameter.
    gaps: Vec<[Series; 2]>,
}

impl FreeMotion {
    /// The motion of a machine whose coefficients change at the rates `slope`.
    ///
    /// # Errors
    /// Those of [`Machine::equations`], [`Machine::contacts`], [`MachineSlope::new`] and
    /// [`LinearEquations::response`].
    pub fn new(machine: &Machine<f64>, slope: &Machine<f64>) -> Result<FreeMotion> {
        let (equations, slope) = (machine.equations()?, MachineSlope::new(machine, slope)?);
        let contacts = Contacts::new(&equations, machine.contacts()?);
        let motion = equations.response()?;
        let drift = equations.response_slope(&motion, &slope)?;
        let gap = |(contact, (row, place)): (&super::contact::StopContact, &(RealVector, Series))| {
            let gap = Series::combination(&[(1.0, &motion.series(&contact.row)?), (-1.0, &contact.position)]);
            let parts = [(1.0, &motion.series(row)?), (1.0, &drift.series(&contact.row)?), (-1.0, place)];
            Ok([gap, Series::combination(&parts)])
        };
        let gaps = contacts.all().iter().zip(&slope.stops).map(gap).collect::<Result<_>>()?;
        Ok(FreeMotion { equations, contacts, motion, drift, gaps })
    }

    /// The equations of motion.
    pub(super) fn equations(&self) -> &LinearEquations {
        &self.equations
    }

    /// The motion's displacements over a period.
    pub fn motion(&self) -> &Periodic {
        &self.motion
    }

    /// The stops.
    pub fn contacts(&self) -> &Contacts {
        &self.contacts
    }

    /// The minima of all gaps over a period, by stop. A gap that does not change has one, at phase 0.
    pub fn minima(&self) -> Vec<LeastGap> {
        let of = |(stop, [gap, _]): (usize, &[Series; 2])| {
            minima(gap).into_iter().map(move |(phase, gap)| LeastGap { stop, phase, gap })
        };
        self.gaps.iter().enumerate().flat_map(of).collect()
    }

    /// The least of them; none without stops.
    pub fn least(&self) -> Option<LeastGap> {
        self.minima().into_iter().min_by(|a, b| a.gap.total_cmp(&b.gap))
    }

    /// How fast a minimum of a gap opens with the parameter: at a minimum the phase may be held fixed.
    pub fn rate(&self, at: &LeastGap) -> f64 {
        self.gaps[at.stop][1].at(at.phase)[0]
    }

    /// The size of the gaps' motion: what is much smaller is rounding.
    pub fn scale(&self) -> f64 {
        let one = |gap: &Series| gap.mean().abs() + gap.derivative_bound(0);
        self.gaps.iter().map(|[gap, _]| one(gap)).fold(0.0, f64::max)
    }
}

/// The minima of a trigonometric sum over a period, phase and value.
///
/// Cells are 1/32 of the fastest period; within one the second derivative is taken to change sign once at
/// most, so that every root of the first is found.
fn minima(z: &Series) -> Vec<(f64, f64)> {
    if z.order() == 0 {
        return vec![(0.0, z.mean())];
    }
    let cells = 32 * z.order();
    let width = TAU / f64::from(cells);
    let mut found = Vec::new();
    for cell in 0..cells {
        let (lo, hi) = (f64::from(cell) * width, f64::from(cell + 1) * width);
        // The end of the last cell is the beginning of the first, to the bit.
        let [_, b, end] = z.at(if cell + 1 == cells { 0.0 } else { hi });
        if let Some(x) = minimum_within(|x| z.at(lo + x), z.at(lo), [z.at(hi)[0], b, end], hi - lo) {
            let t = lo + x;
            found.push((if t < TAU { t } else { 0.0 }, z.at(t)[0]));
        }
    }
    found
}

/// The motion without impacts that grazes.
#[derive(Debug, Clone)]
pub struct MachineGrazing {
    /// The parameter there.
    pub parameter: f64,
    /// Where it grazes, and what is left of the gap.
    pub at: LeastGap,
    /// The size of the gaps' motion.
    pub scale: f64,
    /// Other minima of gaps that are zero to rounding: the map is not the whole theory then.
    pub others: Vec<LeastGap>,
    /// The map there.
    pub map: MachineLocalMap,
    /// That of half a period, where a symmetric machine grazes a stop and its mirror.
    pub half: Option<HalfPeriod>,
}

/// What a search for a grazing came to.
#[derive(Debug, Clone)]
pub enum MachineSearch {
    /// The nearest grazing that was found.
    Found(Box<MachineGrazing>),
    /// None, and why.
    Nothing(String),
}

/// Values of the parameter that are tried each way.
const STEPS: u32 = 200;

/// A gap smaller than this, relative to the gaps' motion, where another is zero, is zero too.
const TWICE: f64 = 1e-11;

/// The grazing of the motion without impacts nearest to `start`, within `reach` of it. From step to step of
/// the parameter, 200 of them each way, the least gap changes sign, or its derivative does, so that it dips
/// between them; dips of a fraction of a step may be missed. Then Newton's method on the least gap as a
/// function of the parameter, kept between bounds.
///
/// # Errors
/// Where the family is not defined at `start`; no periodic motion there; det(I − A) = 0 at the grazing.
pub fn locate(family: &dyn MachineFamily, start: f64, reach: f64) -> Result<MachineSearch> {
    let look = |parameter: f64| -> Result<(FreeMotion, LeastGap, f64)> {
        let (machine, slope) = family.at(parameter)?;
        let motion = FreeMotion::new(&machine, &slope)?;
        let least = motion.least().ok_or_else(|| Error::input("there is no stop that could be grazed"))?;
        let rate = motion.rate(&least);
        Ok((motion, least, rate))
    };
    let (motion, least, rate) = look(start)?;
    let tiny = TWICE * motion.scale();
    if least.gap < -tiny {
        let name = &motion.contacts.all()[least.stop].name;
        return Ok(MachineSearch::Nothing(format!(
            "at the start the motion without impacts is already behind stop {name}, by {:e}: start where it is free",
            -least.gap
        )));
    }
    let mut nearest: Option<f64> = (least.gap <= tiny).then_some(start);
    let mut why = Vec::new();
    for direction in [1.0, -1.0] {
        if nearest == Some(start) {
            break;
        }
        let (mut before, mut last) = (start, (least.gap, rate * direction));
        for step in 1..=STEPS {
            let there = start + direction * reach * f64::from(step) / f64::from(STEPS);
            if nearest.is_some_and(|known| (known - start).abs() <= (before - start).abs()) {
                break;
            }
            let (gap, rate) = match look(there) {
                Ok((_, least, rate)) => (least.gap, rate * direction),
                Err(error) => {
                    why.push(format!("the search ended at {there:?}: {error}"));
                    break;
                }
            };
            let end = if gap <= 0.0 {
                Some(there)
            } else if last.1 < 0.0 && rate > 0.0 {
                dip(&look, before, there, direction)?
            } else {
                None
            };
            if let Some(end) = end {
                let root = root(&look, before, end)?;
                if nearest.is_none_or(|known| (root - start).abs() < (known - start).abs()) {
                    nearest = Some(root);
                }
                break;
            }
            (before, last) = (there, (gap, rate));
        }
    }
    let Some(near) = nearest else {
        let mut reason = format!("the motion without impacts touches no stop within {reach} of {start:?}");
        for more in why {
            reason = format!("{reason}; {more}");
        }
        return Ok(MachineSearch::Nothing(reason));
    };
    let parameter = polish(&look, near)?;
    let (motion, at, _) = look(parameter)?;
    let scale = motion.scale();
    let tiny = TWICE * scale;
    let mut others = motion.minima();
    others.retain(|other| other.gap.abs() <= tiny && *other != at);
    let (map, half) = (MachineLocalMap::new(&motion, &at)?, HalfPeriod::new(&motion, &at, &others)?);
    Ok(MachineSearch::Found(Box::new(MachineGrazing { parameter, at, scale, others, map, half })))
}

type Look<'l> = &'l dyn Fn(f64) -> Result<(FreeMotion, LeastGap, f64)>;

/// A value between two, at which the least gap falls and rises again, where it is not positive.
fn dip(look: Look, mut lo: f64, mut hi: f64, direction: f64) -> Result<Option<f64>> {
    for _ in 0..50 {
        let middle = lo + (hi - lo) / 2.0;
        let (_, least, rate) = look(middle)?;
        if least.gap <= 0.0 {
            return Ok(Some(middle));
        }
        if rate * direction < 0.0 {
            lo = middle;
        } else {
            hi = middle;
        }
    }
    Ok(None)
}

/// Where the least gap, positive at `free`, passes through 0 before `behind`: Newton's method between bounds.
fn root(look: Look, mut free: f64, mut behind: f64) -> Result<f64> {
    let mut here = free + (behind - free) / 2.0;
    for _ in 0..200 {
        let (_, least, rate) = look(here)?;
        if least.gap > 0.0 {
            free = here;
        } else {
            behind = here;
        }
        let next = here - least.gap / rate;
        let inside = (next - free) * (behind - next) > 0.0;
        let next = if inside { next } else { free + (behind - free) / 2.0 };
        if (next - here).abs() <= 4.0 * f64::EPSILON * here.abs() || next == free || next == behind {
            break;
        }
        here = next;
    }
    Ok(here)
}

/// Newton's method from nearby, as long as it makes the gap smaller.
fn polish(look: Look, mut here: f64) -> Result<f64> {
    let (_, mut least, mut rate) = look(here)?;
    for _ in 0..4 {
        let next = here - least.gap / rate;
        let Ok((_, closer, there)) = look(next) else { break };
        if closer.gap.abs().is_nan() || closer.gap.abs() >= least.gap.abs() {
            break;
        }
        (here, least, rate) = (next, closer, there);
    }
    Ok(here)
}

/// The local map of the stroboscopic section at the phase of grazing, in coordinates x = (q, q′) less those
/// of the motion, velocities per radian of the forcing.
#[derive(Debug, Clone)]
pub struct MachineLocalMap {
    /// A: ∂(q, q′) after a period by (q, q′) before.
    pub a: RealMatrix,
    /// B.
    pub b: RealVector,
    /// C.
    pub c: RealVector,
    /// e: how fast the least gap opens with the parameter (26).
    pub e: f64,
    /// a_G: the second derivative of the gap there.
    pub acceleration: f64,
    /// τ of the stop that is grazed.
    pub restitution: f64,
    /// How fast the rate of the gap at the phase of grazing changes with the parameter.
    pub rate_drift: f64,
    /// The motion's state there.
    pub state: MachineState,
    /// Its derivative in the parameter, at that phase.
    pub drift: MachineState,
    /// det A, without cancellation.
    pub determinant: f64,
    /// The eigenvalues of A, by modulus, the largest first.
    pub eigenvalues: Vec<(f64, f64)>,
    /// What A is the flow over, 2π, or the mirror of the flow over, π.
    span: f64,
    flow: LinearFlow,
    /// Of B, C on the flow's own coordinates.
    own: [RealVector; 2],
}

/// How far entries may be off that were computed in floats.
const ERROR: f64 = 1e-12;

impl MachineLocalMap {
    /// The map at a minimum of a gap that is zero. An a_G that is not positive is for
    /// [`to_map`](Self::to_map) to refuse.
    ///
    /// # Errors
    /// Those of [`LinearFlow::new`]; eigenvalues of A that are not found.
    pub fn new(motion: &FreeMotion, at: &LeastGap) -> Result<MachineLocalMap> {
        Self::over(motion, at, TAU)
    }

    /// The same over half a period, after which all is mirrored.
    pub(super) fn half(motion: &FreeMotion, at: &LeastGap) -> Result<MachineLocalMap> {
        Self::over(motion, at, PI)
    }

    fn over(motion: &FreeMotion, at: &LeastGap, span: f64) -> Result<MachineLocalMap> {
        let (contact, push) = (&motion.contacts.all()[at.stop], motion.contacts.push(at.stop));
        let n = motion.equations.size();
        let [gap, slope] = &motion.gaps[at.stop];
        let (acceleration, [e, rate_drift, _]) = (gap.at(at.phase)[2], slope.at(at.phase));
        let flow = LinearFlow::new(motion.equations.clone())?;
        // 2n is even: the mirror does not change the determinant.
        let (a, determinant) = (flow.transition(span) * mirrors(span), determinant(&motion.equations, span));
        let kick = (2.0 * acceleration.max(0.0)).sqrt() * (1.0 + contact.restitution);
        let change = push * (kick / motion.contacts.mobility(at.stop));
        let zero = RealVector::zeros(n);
        let stacked = |q: &RealVector, u: &RealVector| {
            RealVector::from_iterator(2 * n, q.iter().chain(u.iter()).copied())
        };
        Ok(MachineLocalMap {
            b: stacked(&zero, &change),
            c: stacked(&contact.row, &zero),
            e,
            acceleration,
            restitution: contact.restitution,
            rate_drift,
            state: motion.motion.state(at.phase),
            drift: motion.drift.state(at.phase),
            determinant,
            eigenvalues: eigenvalues(&a, determinant)?,
            own: [flow.kick(&change), flow.seen(&contact.row, &zero)],
            a,
            span,
            flow,
        })
    }

    /// √(2a_G): an impact of size y has the speed V = √(2a_G) y.
    pub fn speed_scale(&self) -> f64 {
        (2.0 * self.acceleration).sqrt()
    }

    /// γ = A₁₂ (44), of one degree of freedom.
    pub fn gamma(&self) -> Option<f64> {
        (self.b.len() == 2).then(|| self.a[(0, 1)])
    }

    /// The map for the local theory, in the coordinates in which the flow falls apart, so that A is made of
    /// blocks of two and intervals stay narrow in any dimension. Every computed entry is widened by 10⁻¹² of
    /// the largest of its block, more for fast modes and for nearly dependent ones: far more than its error,
    /// but no proof. What is zero by structure stays exactly zero.
    ///
    /// # Errors
    /// An input error if a_G is not positive, and those of [`Map::new`].
    pub fn to_map(&self) -> Result<Map> {
        if self.acceleration.is_nan() || self.acceleration <= 0.0 {
            let message = format!("a_G = {} at the grazing point; it must be positive", self.acceleration);
            return Err(Error::input(message));
        }
        let exact = |x: f64| BigRational::from_float(x).ok_or_else(|| Error::input("A is not finite"));
        let wide = |x: f64, radius: f64| Entry::between(exact(x - radius)?, exact(x + radius)?);
        let zero = || Entry::from(BigRational::from_integer(0.into()));
        let (own, size) = (self.flow.matrix(self.span) * mirrors(self.span), self.flow.dimension());
        let condition = if self.flow.condition().is_finite() { self.flow.condition() } else { 10.0 };
        let pairs = self.flow.pairs();
        let rates = self.flow.rates();
        let entry = |i: usize, j: usize| match &pairs {
            Some(_) if i / 2 != j / 2 => Ok(zero()),
            Some(all) if i != j && matches!(all[i / 2], Pair::Two(_)) => Ok(zero()),
            Some(_) => {
                let first = i / 2 * 2;
                let largest = own.view((first, first), (2, 2)).amax();
                // The phase of a fast mode after a period is off by some ε times its rate.
                wide(own[(i, j)], ERROR.max(64.0 * f64::EPSILON * rates[i / 2]) * condition * largest)
            }
            None => wide(own[(i, j)], ERROR * condition * own.amax().max(1.0)),
        };
        let a = (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect::<Result<_>>()?;
        let vector = |v: &RealVector| {
            let one = |&x: &f64| if x == 0.0 { Ok(zero()) } else { wide(x, ERROR * condition * x.abs()) };
            v.iter().map(one).collect::<Result<Vec<Entry>>>()
        };
        let [b, c] = &self.own;
        Map::new(a, vector(b)?, vector(c)?, wide(self.e, ERROR * self.e.abs())?, None)
    }

    /// Times t_i and incoming speeds V_i of the impacts of the pattern (n₁, …, n_m) of `report`, which is of
    /// [`to_map`](Self::to_map), at the distance `away` of the parameter from the grazing at phase `phase`:
    /// the leading-order solution (32). Impact i follows n_{i−1} periods after the one before, with speed
    /// √(2a_G) η Y_{i−1}, η = e · `away`, where the rate of the gap is −V on the parabola of curvature a_G
    /// that the gap follows there.
    ///
    /// # Errors
    /// An input error if the report has no solution.
    pub fn start(&self, phase: f64, periods: &[u64], report: &Report, away: f64) -> Result<Vec<f64>> {
        let solution =
            report.orbit.as_ref().ok_or_else(|| Error::input("the pattern is singular: no start"))?;
        let (n, m, eta) = (self.b.len() / 2, periods.len(), self.e * away);
        let middle = |value: &crate::pattern::Value| {
            let interval = value.enclosure();
            interval.lo() + (interval.hi() - interval.lo()) / 2.0
        };
        let row = self.c.rows(0, n);
        let mut z = Vec::with_capacity(2 * m);
        for i in 0..m {
            let before = (i + m - 1) % m;
            let x = RealVector::from_iterator(2 * n, solution.x[before].iter().map(middle));
            let mut arriving = self.flow.outward(&x);
            for _ in 0..periods[before] {
                arriving = &self.a * arriving;
            }
            let speed = self.speed_scale() * eta * middle(&solution.y[before]);
            let rate = eta * row.dot(&arriving.rows(n, n)) + self.rate_drift * away;
            z.extend([phase - (rate + speed) / self.acceleration, speed]);
        }
        Ok(z)
    }
}

/// 1 for a whole period, −1 for half of one, after which all is mirrored.
fn mirrors(span: f64) -> f64 {
    if span < TAU { -1.0 } else { 1.0 }
}

/// det of the flow over a time, by Liouville: exp(−tr(M⁻¹C) · time).
pub(super) fn determinant(equations: &LinearEquations, time: f64) -> f64 {
    (-equations.per_mass(&equations.damping).trace() * time).exp()
}
