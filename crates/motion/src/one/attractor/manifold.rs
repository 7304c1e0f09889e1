//! Stable and unstable manifolds of periodic orbits on the stroboscopic section, as curves to be drawn.
//!
//! The unstable manifold of a saddle S with multiplier Λ is what becomes of a short segment [ε v, Λ ε v] on
//! its unstable direction v, both ways, under the map from period to period of S. The stable manifold is the
//! unstable one of the motion run backwards, which is that of an impact oscillator, too: damping, odd
//! harmonics and velocities change sign, in a formula velocity and time, and a restitution τ becomes 1/τ.
//! Impacts cut the curves: where neighbouring points come to lie far apart, one of them beyond a grazing, the
//! curve is broken and not bridged. Not here: where manifolds cross (`crisis`).

use std::f64::consts::TAU;

use crate::{
    error::{Error, Result},
    monitor::Monitor,
    motion::{
        Flow, Harmonic, RunEnd, System, TIME, Time, U, Wall,
        algebra::{IDENTITY, Matrix2, product, trace},
    },
    one::simulate::{Event, Simulator},
};

/// How far and how finely manifolds are followed.
#[derive(Debug, Clone, PartialEq)]
pub struct ManifoldPlan {
    /// The distance from the orbit at which it is left. Default 10⁻⁵.
    pub distance: f64,
    /// How many times the segment is mapped on. Default 30.
    pub images: u32,
    /// Neighbouring points of the curve are no farther apart, unless a grazing is between them. Default 0.02.
    pub step: f64,
    /// The most points of one half of a manifold. Default 4000.
    pub points: usize,
}

impl ManifoldPlan {
    /// The plan for motions of a size: lengths are parts of it.
    #[must_use]
    pub fn sized(self, size: f64) -> ManifoldPlan {
        ManifoldPlan { distance: self.distance * size, step: self.step * size, ..self }
    }
}

impl Default for ManifoldPlan {
    fn default() -> Self {
        ManifoldPlan { distance: 1e-5, images: 30, step: 0.02, points: 4000 }
    }
}

/// A point of the manifold under way: where on the first segment it began, and where it is.
type Traced = (f64, [f64; 2]);

/// The pieces of both halves of the unstable manifold of the saddle at (q, u) on the section at `phase`, of
/// the given period. Points whose motion escapes or starts behind a wall end a piece.
///
/// # Errors
/// An input error unless one multiplier is real and beyond ±1; the monitor's.
pub fn unstable_manifold(
    simulator: &Simulator,
    phase: f64,
    periods: u32,
    saddle: [f64; 2],
    plan: &ManifoldPlan,
    monitor: &dyn Monitor,
) -> Result<Vec<Vec<[f64; 2]>>> {
    let (_, matrix) = return_map(simulator, phase, periods, saddle)?;
    let (expansion, direction) = expanding(&matrix)?;
    // Two periods of the map if it turns the sides over.
    let (rounds, growth) =
        if expansion < 0.0 { (2 * periods, expansion * expansion) } else { (periods, expansion) };
    let map = |[q, u]: [f64; 2]| {
        let mut run = simulator.start(Time::new(0, phase), q, u).ok()?;
        let end = run.finish(Time::new(rounds.into(), phase));
        let state = run.state();
        (end == RunEnd::Reached).then_some([state.q, state.u])
    };
    let at = |offset: f64| [saddle[0] + offset * direction[0], saddle[1] + offset * direction[1]];
    let far = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) > plan.step;
    let mut pieces = Vec::new();
    for side in [plan.distance, -plan.distance] {
        pieces.push(vec![saddle]);
        let mut count = 0;
        // The image of a point of the first segment, or where it was lost.
        let image = |part: f64, images: u32| {
            (0..images).try_fold(at(side * growth.powf(part)), |state, _| map(state))
        };
        'images: for images in 0..plan.images {
            let mut last: Option<Traced> = None;
            // Parts still to be looked at, the next one last.
            let mut parts: Vec<f64> = (0..=32).rev().map(|i| f64::from(i) / 32.0).collect();
            while let Some(part) = parts.pop() {
                monitor.advance(0)?;
                if count > plan.points {
                    break 'images;
                }
                count += 1;
                let Some(here) = image(part, images) else {
                    pieces.push(Vec::new());
                    last = None;
                    continue;
                };
                if let Some((before, there)) = last
                    && far(here, there)
                {
                    if part - before > 1e-6 {
                        parts.extend([part, (before + part) / 2.0]);
                        continue;
                    }
                    pieces.push(Vec::new());
                }
                pieces.last_mut().expect("never empty").push(here);
                last = Some((part, here));
            }
        }
    }
    pieces.retain(|piece| piece.len() > 1);
    Ok(pieces)
}

/// Where a state leads in that many periods, and the derivative of that by the state: flow and saltation
/// matrices on the way.
///
/// # Errors
/// As [`Simulator::start`]; an input error if the motion escapes.
pub(crate) fn return_map(
    simulator: &Simulator,
    phase: f64,
    periods: u32,
    [q, u]: [f64; 2],
) -> Result<([f64; 2], Matrix2)> {
    let goal = Time::new(periods.into(), phase);
    let mut run = simulator.start(Time::new(0, phase), q, u)?;
    let (mut state, mut now, mut matrix) = (run.state(), run.time(), IDENTITY);
    loop {
        let event = run.next(goal);
        let then = event.time().unwrap_or(run.time());
        let (arrival, step) = simulator.flow().advance_linearised(state, then.since(now));
        matrix = product(&step, &matrix);
        match event {
            Event::Impact(impact) => {
                let contact = simulator.contact(impact.place).expect("a wall that was met");
                matrix = product(&contact.saltation(simulator.flow(), arrival), &matrix);
            }
            Event::Stick(_) | Event::Release(_) => matrix = [[0.0; 2]; 2],
            Event::Tangency(_) | Event::Touch(_) | Event::Reversal(_) | Event::Kink(_) => {}
            Event::End(RunEnd::Reached) => {
                let state = run.state();
                return Ok(([state.q, state.u], matrix));
            }
            Event::End(end) => return Err(Error::input(format!("the motion ends {}", end.why()))),
        }
        (state, now) = (run.state(), run.time());
    }
}

/// The multiplier beyond ±1 and its unit eigenvector.
fn expanding(m: &Matrix2) -> Result<(f64, [f64; 2])> {
    let (half, det) = (trace(m) / 2.0, m[0][0] * m[1][1] - m[0][1] * m[1][0]);
    let root = (half * half - det).sqrt();
    let expansion = half + if half < 0.0 { -root } else { root };
    let other = det / expansion;
    if !(expansion.abs() > 1.0 && other.abs() < 1.0) {
        return Err(Error::input(format!("multipliers {expansion} and {other} are not those of a saddle")));
    }
    // Of the two ways to write it the one that is not 0.
    let [a, b] = [[m[0][1], expansion - m[0][0]], [expansion - m[1][1], m[1][0]]];
    let v = if a[0].hypot(a[1]) > b[0].hypot(b[1]) { a } else { b };
    Ok((expansion, v.map(|x| x / v[0].hypot(v[1]))))
}

/// The system whose motions are those of this one run backwards: q(−t) and −u(−t).
///
/// # Errors
/// An input error if a restitution is 0: what such an impact forgets cannot be run backwards.
pub fn reversed(system: &System<f64>) -> Result<System<f64>> {
    let turned = |all: &[Harmonic<f64>]| all.iter().map(|h| Harmonic { sin: -h.sin, ..h.clone() }).collect();
    let wall = |wall: &Wall<f64>| {
        if wall.restitution == 0.0 {
            return Err(Error::input("a wall with restitution 0 cannot be run backwards"));
        }
        let harmonics = turned(&wall.harmonics);
        Ok(Wall { offset: wall.offset, harmonics, restitution: 1.0 / wall.restitution })
    };
    let back = |place: usize| place == U || place == TIME;
    let smooth = system.smooth.as_ref().map(|force| force.turned(&back));
    Ok(System {
        damping: -system.damping,
        smooth,
        forcing: turned(&system.forcing),
        lower: system.lower.as_ref().map(wall).transpose()?,
        upper: system.upper.as_ref().map(wall).transpose()?,
        ..system.clone()
    })
}

/// The phase at which the reversed system passes the section at `phase`.
pub fn reversed_phase(phase: f64) -> f64 {
    (-phase).rem_euclid(TAU)
}
