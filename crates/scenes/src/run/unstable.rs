//! Where a sweep leaves an orbit its branch goes on: what of it is unstable, for the task `response`.

use super::{
    Job,
    engine::{Engine, JudgedOrbit, OrbitSource},
    proved::StartOf,
    row,
    swept::{SweepFindings, way},
};
use crate::{
    attractor::{detection::Detection, diagram::SweepStep, portrait::OnAttractor},
    continuation::{
        BranchPoint, Direction, FollowedOrbit as _, Options, OrbitBranch, PatternCurve, PatternFamily,
    },
    error::{Error, Result},
    scene::response::ResponseTask,
};

row! {
    /// A stretch of a branch on which orbits are unstable.
    pub struct UnstableRow {
        /// The stretch, counted from 1.
        pub stretch: usize,
        /// Its orbits' period, in forcing periods.
        pub period: u32,
        /// Their impacts in a period, stop by stop.
        pub pattern: String,
        /// The parameter's value where it begins.
        pub from: f64,
        /// The bifurcation there.
        pub begins: String,
        /// The parameter's value where it ends.
        pub to: f64,
        /// The bifurcation there, or why the branch was followed no farther.
        pub ends: String,
        /// How many orbits were found on it.
        pub orbits: usize,
    }
}

/// An orbit of a stretch, and a state on it.
pub(super) struct UnstableOrbit<S> {
    pub stretch: usize,
    pub value: f64,
    pub period: u32,
    pub impacts: u64,
    pub start: S,
}

/// Stretches, their orbits one after the other, and what was not followed and why.
pub(super) struct Unstable<S> {
    pub rows: Vec<UnstableRow>,
    pub orbits: Vec<UnstableOrbit<S>>,
    pub open: Vec<String>,
}

impl<S> Default for Unstable<S> {
    fn default() -> Self {
        Unstable { rows: Vec::new(), orbits: Vec::new(), open: Vec::new() }
    }
}

/// Orbits of a branch: a picture needs no more.
const POINTS: u32 = 400;

/// Of orbits of more impacts in a period than this no branch is followed: an orbit of m impacts takes O(m³)
/// operations.
const MOST_IMPACTS: u64 = 32;

/// So many branches are followed.
const MOST_BRANCHES: usize = 16;

/// The branches of the orbits that a sweep over these values leaves, each followed in the sweep's direction
/// from the last value at which the motion was on it. Cost: that of a branch of at most 400 points for each
/// orbit, of at most 16.
///
/// # Errors
/// Those of the system; an interruption.
pub(super) fn unstable<E: Engine>(
    (task, range): (&ResponseTask, (f64, f64)),
    job: &Job,
    engine: &E,
    steps: &[(bool, &SweepStep<StartOf<E>>)],
    sweep: &SweepFindings,
) -> Result<Unstable<StartOf<E>>> {
    let family = engine.family(&task.parameter)?;
    let source = engine.source(&family)?;
    let mut found = Unstable::default();
    let mut known: Vec<OrbitBranch<E::Orbit>> = Vec::new();
    for (up, at, on) in left(steps, sweep) {
        job.check()?;
        if known.len() == MOST_BRANCHES {
            found.open.push(format!(
                "{MOST_BRANCHES} branches of orbits that the sweep leaves were followed, and no others"
            ));
            break;
        }
        let system = engine.system(Some((&task.parameter, at)))?;
        let orbit = on_attractor(engine, on, &system);
        let orbit = orbit.map(|orbit| {
            let passes = known.iter().any(|branch| branch.passes(&orbit, at));
            (!passes).then_some(orbit)
        });
        let followed = orbit
            .and_then(|orbit| orbit.map(|orbit| beyond(source.family(), &orbit, at, range, up)).transpose());
        match followed {
            Ok(None) => {}
            Ok(Some((branch, end))) => {
                stretch_rows((engine, &task.parameter), &source, (&branch, &end), &mut found)?;
                known.push(branch);
            }
            Err(error) if error.is_interrupted() => return Err(error),
            Err(error) => found.open.push(format!(
                "the branch of the orbit on which the sweep is at {at}, and then no longer, was not followed: {error}"
            )),
        }
    }
    Ok(found)
}

/// The orbit that the motion has settled on.
///
/// # Errors
/// An input error of one with more than 32 impacts; those of [`Engine::attracting`].
pub(super) fn on_attractor<E: Engine>(
    engine: &E,
    on: &OnAttractor<StartOf<E>>,
    system: &E::System,
) -> Result<E::Orbit> {
    let portrait = &on.portrait;
    if portrait.impacts > MOST_IMPACTS {
        return Err(Error::input(format!(
            "it has {} impacts in a period, of which {MOST_IMPACTS} are the most that are followed",
            portrait.impacts
        )));
    }
    let longest = portrait.period.unwrap_or(1) as usize;
    engine.attracting(system, &on.start, &Detection { transient: 0, longest, ..Detection::default() })
}

/// The branch from an orbit on, one way, and why it ends.
fn beyond<F: PatternFamily + ?Sized>(
    family: &F,
    orbit: &F::Orbit,
    at: f64,
    range: (f64, f64),
    up: bool,
) -> Result<(OrbitBranch<F::Orbit>, String)> {
    let options = Options { points: POINTS, ..Options::default() };
    let curve = PatternCurve::over(family, orbit.pattern().clone(), range);
    let place = curve.start_at(orbit, at, &options)?;
    let direction = if up { Direction::Forward } else { Direction::Backward };
    let mut branch = OrbitBranch::follow(&curve, &place, direction, &options)?;
    if !up {
        branch.points.reverse();
    }
    let end = branch.ends[usize::from(up)].to_string();
    Ok((branch, end))
}

/// The stretches of a branch, with states on their orbits.
fn stretch_rows<E: Engine, S: OrbitSource<Orbit = E::Orbit>>(
    (engine, parameter): (&E, &str),
    source: &S,
    (branch, end): (&OrbitBranch<E::Orbit>, &str),
    found: &mut Unstable<StartOf<E>>,
) -> Result<()> {
    let pattern = &branch.itinerary;
    let kind = |point: &BranchPoint<E::Orbit>| point.kind().unwrap_or("start").to_string();
    for (begin, stretch) in stretches(&branch.points) {
        let (number, last) = (found.rows.len() + 1, begin + stretch.len() == branch.points.len());
        let [from, to] = [&stretch[0], &stretch[stretch.len() - 1]];
        found.rows.push(UnstableRow {
            stretch: number,
            period: pattern.periods(),
            pattern: source.named(pattern),
            from: from.parameters[0],
            begins: kind(from),
            to: to.parameters[0],
            ends: if last && to.kind().is_none() { end.to_string() } else { kind(to) },
            orbits: stretch.len(),
        });
        for point in stretch {
            let value = point.parameters[0];
            let system = engine.system(Some((parameter, value)))?;
            found.orbits.push(UnstableOrbit {
                stretch: number,
                value,
                period: pattern.periods(),
                impacts: pattern.strikes().len() as u64,
                start: engine.on_orbit(&point.orbit, &system)?,
            });
        }
    }
    Ok(())
}

/// The orbits that a sweep leaves, each with the way and the last value at which the motion is on it.
fn left<'s, S>(
    steps: &[(bool, &'s SweepStep<S>)],
    sweep: &SweepFindings,
) -> Vec<(bool, f64, &'s OnAttractor<S>)> {
    let kind = |on: &OnAttractor<S>| on.portrait.period.map(|period| (period, on.portrait.impacts));
    let pairs = steps.windows(2).filter(|pair| pair[0].0 == pair[1].0);
    let leaves = |pair: &[(bool, &'s SweepStep<S>)]| {
        let [(up, here), (_, next)] = [pair[0], pair[1]];
        let (on, then) = (here.decided()?, next.decided());
        let jumps = sweep.jumps.iter().any(|jump| {
            jump.sweep == way(up) && (jump.stays - here.value) * (jump.stays - next.value) <= 0.0
        });
        let changes = jumps || then.and_then(kind) != kind(on);
        (changes && kind(on).is_some()).then_some((up, here.value, on))
    };
    pairs.filter_map(leaves).collect()
}

/// The stretches of a branch between bifurcations on which orbits are unstable, those at both ends among
/// them, each with the number of its first point.
fn stretches<O: JudgedOrbit>(points: &[BranchPoint<O>]) -> Vec<(usize, &[BranchPoint<O>])> {
    let is_unstable = |point: &BranchPoint<O>| point.event.is_none() && !point.orbit.is_stable();
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(first) = points[at..].iter().position(is_unstable).map(|i| at + i) {
        let length =
            points[first..].iter().position(|point| point.event.is_none() && point.orbit.is_stable());
        let beyond = length.map_or(points.len(), |length| first + length);
        // Between the last unstable orbit and the first stable one is the bifurcation.
        let last = points[..beyond].iter().rposition(is_unstable).unwrap_or(first);
        let begin = if first > 0 && points[first - 1].event.is_some() { first - 1 } else { first };
        let end =
            if last + 1 < points.len() && points[last + 1].event.is_some() { last + 2 } else { last + 1 };
        found.push((begin, &points[begin..end]));
        at = beyond;
    }
    found
}
