//! Free vibrations of several coordinates: the families (nonlinear normal modes) that grow from a machine's
//! modes, by energy.
//!
//! Without damping, drive and friction a motion that is at rest twice runs back and forth between both
//! places: it is periodic with twice the time between them. From rest at x the velocity after half a period T
//! is to be 0: n equations for x and T, whose solutions are curves, each followed from a mode by
//! pseudo-arclength continuation. Forces of the displacement and springs that begin somewhere may be of any
//! kind; a family ends where it meets a rigid stop. Not here: one coordinate, whose vibrations are integrals
//! (`motion::backbone`); motions that are never at rest.

use super::{Machine, RealVector, section::PlanarMachine, smooth::Smooth};
use crate::{
    attractor::{
        dynamics::{Dynamics, Motion as _, SectionState as _},
        limit_cycle::{Round, round},
        swing::{Look, widen},
    },
    continuation::{Curve, CurveEnd, CurvePoint, Equations, Followed, Options, follow},
    error::{Error, Result},
    motion::{RunEnd, Time, flow::GAUSS},
    rounding::SUM,
};

/// A free vibration.
#[derive(Debug, Clone, PartialEq)]
pub struct FreeVibration {
    /// Its period, in radians of the machine's drive.
    pub period: f64,
    /// Half of the way of each coordinate of the scene.
    pub swings: Vec<f64>,
    /// What it has above the machine at rest.
    pub energy: f64,
}

/// The vibrations that grow from a mode.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeFamily {
    /// The mode, counted from 1 by frequency.
    pub mode: usize,
    /// The period of the smallest.
    pub natural: f64,
    /// By their order on the curve.
    pub vibrations: Vec<FreeVibration>,
    /// Why there are no more: none where all swings have one frequency.
    /// [`CurveEnd::Fails`] where a rigid stop is met.
    pub end: Option<CurveEnd>,
    /// What their period tends to as they grow without end, if they were followed to where that shows.
    pub largest: Option<f64>,
}

/// A mode is linear up to where its force is off by this part.
const OFF: f64 = 0.01;
/// Sizes at which that is asked, as powers of 2, and halvings from one to the next.
const SIZES: i32 = 300;
const HALVINGS: u32 = 50;
/// The first vibration, as a part of where its mode ceases to be linear.
const FIRST: f64 = 0.1;
/// Looks at a vibration for its extents, and panels of the work that brings it to where it begins.
const LOOKS: u32 = 128;
const PANELS: u32 = 16;
/// Steps to the place of rest.
const STEPS: u32 = 100;
/// Beyond springs that begin somewhere a period is a constant and a part that falls with the swing: so near,
/// as a part of it, the constant is the same from two swings and from twice these.
const SETTLED: f64 = 1e-3;
/// How far the period may go beyond what is asked for.
const BEYOND: f64 = 2.0;
/// Vibrations of a family, in steps of the size up to which its mode is linear.
const OPTIONS: Options = Options {
    step: 0.05,
    least_step: 1e-7,
    most_step: 1.0,
    turn: 0.2,
    points: 400,
    tolerance: 1e-11,
    newton: 8,
    beyond: false,
};

/// The families of a machine with periods about these, in radians of its drive; `planar` is of what is left
/// of it without drive, losses and rigid stops ([`Machine::freed`]). Cost: for each of at most 400 vibrations
/// of a mode some four of its half periods with 2n vectors.
///
/// # Errors
/// An input error where nothing holds a coordinate, or no place of rest is found from q = 0; those of the
/// machine; what `check` says.
pub fn families(
    machine: &Machine<f64>,
    planar: &PlanarMachine,
    periods: [f64; 2],
    check: &mut dyn FnMut() -> Result<()>,
) -> Result<Vec<ModeFamily>> {
    let n = machine.size;
    if planar.dimension() != 2 * n {
        return Err(Error::input(
            "a machine that nothing holds has no free vibrations about a place of rest",
        ));
    }
    let mut equations = machine.equations()?;
    if let Some(smooth) = Smooth::new(machine)? {
        equations = smooth.linearised(&equations);
    }
    // L⁻¹ K L⁻ᵀ, of Lᵀq.
    let root = equations.root();
    let part = root.solve_lower_triangular(&equations.stiffness);
    let stiffness = part.and_then(|part| root.solve_lower_triangular(&part.transpose()));
    let stiffness = stiffness.ok_or_else(|| Error::input("the mass is singular"))?;
    let force = |x: &[f64]| -> Result<RealVector> {
        let still = x.iter().copied().chain(vec![0.0; n]).collect::<Vec<_>>();
        let field = planar.field(&planar.begin(&planar.at(&still, 0.0))?).unwrap_or_default();
        Ok(RealVector::from_column_slice(field.get(n..).unwrap_or_default()))
    };
    let rest = rest(&stiffness, &force)?;
    let eigen = stiffness.symmetric_eigen();
    let mut modes: Vec<(f64, Vec<f64>)> = (0..n)
        .map(|i| (eigen.eigenvalues[i], eigen.eigenvectors.column(i).iter().copied().collect()))
        .collect();
    modes.sort_by(|a, b| a.0.total_cmp(&b.0));
    let contacts = machine.contacts()?;
    let rigid = contacts.iter().zip(&machine.stops).filter(|(_, stop)| stop.law.is_rigid());
    let stops: Vec<_> = rigid.map(|(contact, _)| (contact.row.clone(), contact.position.mean())).collect();
    let mut found = Vec::new();
    for (mode, (square, shape)) in (1..).zip(modes).filter(|(_, mode)| mode.0 > 0.0) {
        check()?;
        let natural = std::f64::consts::TAU / square.sqrt();
        // To both sides.
        let linear = |size: f64| {
            [1.0, -1.0].iter().all(|sign| {
                let size = sign * size;
                let at: Vec<f64> = rest.iter().zip(&shape).map(|(rest, shape)| rest + size * shape).collect();
                let pull = size * square;
                let is_near = |(f, s): (&f64, &f64)| (f + pull * s).abs() <= OFF * pull.abs();
                force(&at).is_ok_and(|f| f.iter().zip(&shape).all(is_near))
            })
        };
        let mut family = ModeFamily { mode, natural, vibrations: Vec::new(), end: None, largest: None };
        let largest = (-SIZES..=SIZES).rev().find(|exponent| linear(2f64.powi(*exponent)));
        if let Some(exponent) = largest.filter(|exponent| *exponent < SIZES) {
            let [least, most] = periods;
            // The same in all units.
            let [mut low, mut high] = [exponent, exponent + 1].map(|exponent| 2f64.powi(exponent));
            for _ in 0..HALVINGS {
                let middle = f64::midpoint(low, high);
                *(if linear(middle) { &mut low } else { &mut high }) = middle;
            }
            let half = Half {
                planar,
                machine,
                stops: &stops,
                rest: &rest,
                size: low,
                natural,
                asked: periods.map(|period| period / natural),
                bounds: [least.min(natural) / BEYOND / natural, BEYOND * most.max(natural) / natural],
            };
            half.follow(&shape, &force, &mut family)?;
        }
        found.push(family);
    }
    Ok(found)
}

/// Where all forces are 0, from q = 0 by the stiffness there.
fn rest(stiffness: &super::RealMatrix, force: &dyn Fn(&[f64]) -> Result<RealVector>) -> Result<Vec<f64>> {
    let mut at = RealVector::zeros(stiffness.nrows());
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        let push = force(at.as_slice())?;
        let Some(step) = stiffness.clone().lu().solve(&push) else { break };
        let long = step.amax();
        // Where steps no longer fall they are rounding.
        if long <= f64::EPSILON * at.amax() || long >= last && long <= SUM * at.amax() {
            return Ok(at.as_slice().to_vec());
        }
        at += step;
        last = long;
    }
    Err(Error::input("no place of rest is found from q = 0"))
}

/// What the period tends to with the swing, from the last half of some vibrations and the half before.
fn largest(all: &[FreeVibration]) -> Option<f64> {
    let last = all.len().checked_sub(1)?;
    let [a, b, c] = [last / 4, last / 2, last]
        .map(|i| (all[i].swings.iter().copied().fold(0.0, f64::max), all[i].period));
    // T = T₁ + C/swing.
    let constant = |(s, t): (f64, f64), (swing, period): (f64, f64)| (swing * period - s * t) / (swing - s);
    let (before, found) = (constant(a, b), constant(b, c));
    (a.0 < b.0 && b.0 < c.0 && (found - before).abs() <= SETTLED * found).then_some(found)
}

/// Half of a vibration, from rest to rest: unknowns are the place over a size and the period over the mode's.
struct Half<'a> {
    planar: &'a PlanarMachine,
    machine: &'a Machine<f64>,
    /// Rigid stops: the row of each and its place.
    stops: &'a [(RealVector, f64)],
    rest: &'a [f64],
    size: f64,
    natural: f64,
    /// The periods that are asked for, over the mode's, and how far beyond them it is followed.
    asked: [f64; 2],
    bounds: [f64; 2],
}

impl Half<'_> {
    fn place(&self, u: &[f64]) -> Vec<f64> {
        let moved = self.rest.iter().zip(u).map(|(rest, u)| rest + self.size * u);
        moved.chain(vec![0.0; self.rest.len()]).collect()
    }

    fn time(&self, u: &[f64]) -> f64 {
        self.natural * u[self.rest.len()] / 2.0
    }

    fn follow(
        &self,
        shape: &[f64],
        force: &dyn Fn(&[f64]) -> Result<RealVector>,
        family: &mut ModeFamily,
    ) -> Result<()> {
        let fixed = (0..shape.len()).max_by(|&i, &j| shape[i].abs().total_cmp(&shape[j].abs())).unwrap_or(0);
        // Outwards is where the largest part of the shape grows.
        let way = FIRST.copysign(shape[fixed]);
        let guess: Vec<f64> = shape.iter().map(|shape| way * shape).chain([1.0]).collect();
        let corrector = crate::continuation::Corrector { tolerance: OPTIONS.tolerance, steps: 30 };
        let first = match corrector.start(self, &guess, fixed) {
            Ok(first) => first,
            Err(error) => {
                family.end = Some(CurveEnd::Lost(error.to_string()));
                return Ok(());
            }
        };
        let (steps, end) = follow(self, first, &OPTIONS)?;
        for step in &steps {
            let energy = self.energy(&step.place.u, force)?;
            let swings = step.view[self.stops.len()..].iter().map(|[low, high]| (high - low) / 2.0).collect();
            let period = 2.0 * self.time(&step.place.u);
            family.vibrations.push(FreeVibration { period, swings, energy });
        }
        family.largest = if end == CurveEnd::Points { largest(&family.vibrations) } else { None };
        family.end = Some(end);
        Ok(())
    }

    /// What is needed to bring it from rest to where it begins.
    fn energy(&self, u: &[f64], force: &dyn Fn(&[f64]) -> Result<RealVector>) -> Result<f64> {
        let (x, n) = (self.place(u), self.rest.len());
        let at =
            |part: f64| -> Vec<f64> { (0..n).map(|j| self.rest[j] + part * (x[j] - self.rest[j])).collect() };
        // The force has kinks where springs begin.
        let still = |part: f64| self.planar.state(&[at(part), vec![0.0; n]].concat(), 0.0).q;
        let [from, to] = [still(0.0), still(1.0)];
        let begins = self.planar.simulator().contacts().all().iter().map(|stop| {
            let [near, far] = [&from, &to].map(|q| stop.row.dot(q) - stop.position.mean());
            near / (near - far)
        });
        let even = (0..=PANELS).map(|i| f64::from(i) / f64::from(PANELS));
        let mut cuts: Vec<f64> = begins.filter(|part| (0.0..1.0).contains(part)).chain(even).collect();
        cuts.sort_by(f64::total_cmp);
        let mut energy = 0.0;
        for pair in cuts.windows(2) {
            let width = pair[1] - pair[0];
            for (place, weight) in GAUSS {
                let push = force(&at(pair[0] + place * width))?;
                energy -= weight * width * (0..n).map(|j| push[j] * (x[j] - self.rest[j])).sum::<f64>();
            }
        }
        Ok(energy)
    }
}

impl Curve for Half<'_> {
    fn equations(&self, u: &[f64]) -> Result<Equations> {
        let n = self.rest.len();
        if u[n] <= 0.0 {
            return Err(Error::input("a period below 0"));
        }
        let Round { end, slope, arrival, .. } = round(self.planar, &self.place(u), self.time(u))?;
        let rows = n..2 * n;
        Ok(Equations {
            residual: rows.clone().map(|i| end[i] / self.size).collect(),
            jacobian: rows
                .map(|i| {
                    let by_time = arrival[i] * self.natural / 2.0 / self.size;
                    slope[i][..n].iter().copied().chain([by_time]).collect()
                })
                .collect(),
        })
    }
}

impl Followed for Half<'_> {
    /// The least and the greatest gap of each rigid stop, then displacement of each coordinate.
    type View = Vec<[f64; 2]>;

    fn view(&self, place: &CurvePoint) -> Result<Self::View> {
        let (x, time) = (self.place(&place.u), self.time(&place.u));
        let mut run = self.planar.begin(&self.planar.at(&x, 0.0))?;
        let look = |at: f64, whole: &[f64]| {
            let state = self.planar.state(whole, 0.0);
            let gaps = self.stops.iter().map(|(row, place)| [row.dot(&state.q) - place, row.dot(&state.u)]);
            let (q, u) = (self.machine.seen(&state.q), self.machine.seen(&state.u));
            let places = gaps.chain(q.iter().zip(u.iter()).map(|(q, u)| [*q, *u])).collect();
            Look { at, places, is_event: false }
        };
        let mut before = look(0.0, &x);
        let mut extents: Vec<[f64; 2]> = before.places.iter().map(|place| [place[0]; 2]).collect();
        for i in 1..=LOOKS {
            let at = time * f64::from(i) / f64::from(LOOKS);
            if run.pass(Time::new(0, 0.0).after(at))? != RunEnd::Reached {
                return Err(Error::input("the vibration ended"));
            }
            let here = look(at, run.point().coordinates());
            widen(&mut extents, &before, &here);
            before = here;
        }
        Ok(extents)
    }

    /// Where it comes to what is asked for and leaves it, and where it meets a rigid stop.
    fn monitors(&self, place: &CurvePoint, view: &Self::View) -> Vec<Option<f64>> {
        let periods = self.asked.iter().map(|asked| Some(place.u[self.rest.len()] - asked));
        periods.chain(self.stops.iter().zip(view).map(|(_, gap)| Some(gap[0] / self.size))).collect()
    }

    fn holds(&self, view: &Self::View) -> bool {
        self.stops.iter().zip(view).all(|(_, gap)| gap[0] >= 0.0)
    }

    fn bounds(&self) -> Vec<(usize, f64, f64)> {
        vec![(self.rest.len(), self.bounds[0], self.bounds[1])]
    }
}
