//! Oscillators of one degree of freedom: their orbits as tasks ask for them.

mod grazing;
mod motion;
mod proofs;
mod ranges;
mod resonance;
mod response;
mod rest;
mod sections;
mod source;
mod tolerated;

use std::f64::consts::{PI, TAU};

use grazing::OscillatorGrazing;
use num_rational::BigRational;
use proofs::OrbitProver;
pub(crate) use resonance::ResonantBirth;
use rest::RestingOscillator;
pub use source::OscillatorSource;

use super::{
    super::{
        Analysed, Complex, Job, Judgement, Keeper, SectionFindings, SimulationFindings, StartNumbers,
        ValidateFindings,
        rest::{RestsHere, all_rests},
    },
    Engine, JudgedOrbit, Prover, RangeProver, StartPlane, asked_touches, no_orbit,
};
use crate::{
    attractor::{basins::BasinGrid, cycle::Cycle, detection::Detection, swing::Swing},
    continuation::{Bifurcation, BranchSearch, OrbitSearch, nearest},
    error::Result,
    many::{
        Machine,
        grazing::{LinearTouch, LinearTouches},
    },
    motion::{Flow, Side, State, System},
    number::Precision,
    one::{
        attractor::attracting,
        branch::Patterns,
        grazing::{Grazing, locate},
        orbit::{Admissibility, Family, Itinerary, Orbit, Oscillator, find},
        simulate::Simulator,
    },
    rounding::CIRCLE,
    scene::{
        BasinsTask, SceneFamily, SectionTask, StartAxis,
        orbits::{GrazingTask, OrbitKeys},
        rest::RestTask,
        simulate::{SimulateTask, Start},
        validate::ValidateTask,
    },
};

/// How often it is gone nearer to a touch that is not found, each time by this part of the way, which is
/// halved as often where there is no motion;
/// and the step of differences, in the parameter's own unit, or by which a proof's gap opens.
const NEARER: u32 = 8;
const MOST: f64 = 0.9;
const SMALL: f64 = 1e-6;

/// How far the least gap is open, of the size of the motion, where it is come to from beyond a stop.
const OPEN: f64 = 0.01;

impl JudgedOrbit for Orbit {
    fn stable(&self, at: Option<Bifurcation>) -> Judgement {
        let multipliers = &self.multipliers;
        let test = |value: f64, here: bool| match () {
            () if here || value.abs() <= CIRCLE * (1.0 + multipliers.trace.abs()) => Judgement::Marginal,
            () if value > 0.0 => Judgement::Yes,
            () => Judgement::No,
        };
        let tests = [
            test(multipliers.fold(), matches!(at, Some(Bifurcation::SaddleNode | Bifurcation::Crossing))),
            test(multipliers.flip(), at == Some(Bifurcation::Flip)),
            test(1.0 - multipliers.determinant, at == Some(Bifurcation::Torus)),
        ];
        match () {
            () if tests.contains(&Judgement::No) => Judgement::No,
            () if tests.contains(&Judgement::Marginal) => Judgement::Marginal,
            () => Judgement::Yes,
        }
    }
}

/// Whether it is an orbit, and why not; marginal at a grazing or where an impact fades.
fn admissible(orbit: &Orbit, job: &Job, at: Option<Bifurcation>) -> (Judgement, Option<String>) {
    if matches!(at, Some(Bifurcation::Grazing | Bifurcation::Fade)) {
        return (Judgement::Marginal, None);
    }
    let margin = CIRCLE * orbit.unit;
    let grazes = orbit.least.is_some_and(|least| least.gap.abs() <= margin);
    let fades = orbit.impacts().any(|impact| impact.speed.abs() <= margin);
    let others = orbit.impacts().all(|impact| impact.speed > -margin)
        && orbit.least.is_none_or(|least| least.gap > -margin);
    if others && (grazes || fades) {
        // What rounding decides is not said of one stop or impact.
        let why = "touches a stop, or an impact has no speed, to rounding";
        return (Judgement::Marginal, Some(why.into()));
    }
    match orbit.admissibility {
        Admissibility::Admissible => (Judgement::Yes, None),
        Admissibility::Outgoing(i) => (Judgement::No, Some(format!("impact {} does not come in", i + 1))),
        Admissibility::Excursion(at) => {
            let (stop, after, leg) = (job.stop(at.side), turn(at.after), at.leg + 1);
            (Judgement::No, Some(format!("meets stop {stop} {after:.6} periods into leg {leg}")))
        }
    }
}

/// A time in radians as a part of the period.
fn turn(radians: f64) -> f64 {
    radians / TAU
}

/// A pattern with the names of the stops, if there are several.
fn named(pattern: &Itinerary, job: &Job) -> String {
    let several = job.scene.stops.len() != 1;
    pattern.with_names(|side| several.then(|| job.stop(side)))
}

/// The speeds of its impacts, in the scene's unit of time.
fn speeds(orbit: &Orbit) -> Vec<f64> {
    orbit.impacts().map(|impact| impact.speed * orbit.rate).collect()
}

fn analysed(orbit: &Orbit, job: &Job, at: Option<Bifurcation>) -> Analysed {
    let (admissible, reason) = admissible(orbit, job, at);
    Analysed {
        pattern: named(&orbit.itinerary, job),
        phases: orbit.times().into_iter().map(turn).collect(),
        speeds: speeds(orbit),
        multipliers: orbit.multipliers.values().map(Complex::from).to_vec(),
        stable: orbit.stable(at),
        admissible,
        reason,
        drift: Vec::new(),
        nearest_stop: orbit.least.map(|least| job.stop(least.side)),
        least_gap: orbit.least.map(|least| least.gap),
        residual: orbit.residual,
        newton_steps: orbit.steps,
    }
}

/// The engine for one degree of freedom at work on a job.
pub(crate) struct Oscillators<'j> {
    pub job: &'j Job<'j>,
    pub system: &'j System<f64>,
}

impl<'j> Engine for Oscillators<'j> {
    type Orbit = Orbit;
    type System = Oscillator;
    type Family = SceneFamily<'j>;
    type Source<'f>
        = OscillatorSource<'f>
    where
        Self: 'f;
    type Grazing<'f>
        = OscillatorGrazing<'f>
    where
        Self: 'f;

    type Dynamics = Simulator;
    type States = Vec<State>;

    fn states(&self, starts: &[Start]) -> Result<Vec<State>> {
        starts.iter().map(|start| self.job.scene.state(start)).collect()
    }

    fn begun(&self, states: &Vec<State>) -> Vec<State> {
        states.clone()
    }

    fn dynamics(&self, _: &Vec<State>, change: Option<(&str, f64)>, _: &[String]) -> Result<Simulator> {
        match change {
            None => self.job.simulator(),
            Some(change) => self.job.simulator_of(&self.job.scene.plain(&[change])?),
        }
    }

    fn plane(&self, _: &[String]) -> Option<[String; 2]> {
        None
    }

    fn extents(&self, simulator: &Simulator) -> (f64, Option<f64>) {
        (simulator.settings().minimum_depth, None)
    }

    fn start_plane(&self, task: &BasinsTask, grid: &BasinGrid, phase: f64) -> Result<StartPlane<Simulator>> {
        let dynamics = self.job.simulator()?;
        let minimum_depth = dynamics.settings().minimum_depth;
        let axes = self.job.scene.start_plane(&task.plane, "plane")?;
        let at = State { t: phase, q: 0.0, u: 0.0 };
        let base = match &task.start {
            Some(start) => State { t: at.t, ..self.job.scene.state(start)? },
            None => at,
        };
        let place = move |_: &Simulator, numbers: [f64; 2]| {
            let mut start = base;
            for (axis, x) in axes.into_iter().zip(numbers) {
                match axis {
                    StartAxis::Place => start.q = x,
                    StartAxis::Speed => start.u = x,
                    StartAxis::Phase => start.t = TAU * (x - x.floor()),
                }
            }
            start
        };
        // How large the motions are, as far as the grid tells.
        let extent =
            |(axis, [low, high]): (StartAxis, [f64; 2])| (axis == StartAxis::Place).then_some(high - low);
        let size = axes.into_iter().zip([grid.q, grid.u]).find_map(extent).unwrap_or(f64::INFINITY);
        let plane = match &task.plane[..] {
            [first, second] => Some([first.clone(), second.clone()]),
            _ => None,
        };
        let own = plane.as_ref().map(|names| serde_json::to_string(&(names, base)));
        let identity = own.transpose().map_err(std::io::Error::other)?.unwrap_or_default();
        Ok(StartPlane { dynamics, place: Box::new(place), plane, identity, minimum_depth, size })
    }

    fn further_orbits(
        &self,
        task: &SectionTask,
        simulator: &Simulator,
        cycles: &[(usize, Cycle)],
        found: &mut SectionFindings,
    ) -> Result<()> {
        sections::further(task, self, simulator, cycles, found)
    }

    fn numbers(&self, &State { t, q, u }: &State) -> StartNumbers {
        (t, vec![q], vec![u])
    }

    fn simulate(&self, task: &SimulateTask, keeper: &mut dyn Keeper) -> Result<SimulationFindings> {
        motion::simulate(task, self, keeper)
    }

    fn rests(&self, task: &RestTask, change: Option<(&str, f64)>) -> Result<RestsHere> {
        let changed = change.map(|change| self.job.scene.plain(&[change])).transpose()?;
        let system = changed.as_ref().unwrap_or(self.system);
        let simulator = self.job.simulator_of(system)?;
        let order = system.forcing.iter().map(|harmonic| harmonic.k).max().unwrap_or(0);
        let stops = self.job.scene.stops.iter();
        let (names, stops): (Vec<String>, _) = stops
            .filter_map(|stop| Some((stop.name.clone(), simulator.contact(stop.side?)?.clone())))
            .unzip();
        let rate = system.shown_rate();
        all_rests(&RestingOscillator::new(simulator, stops, order), &names, rate, task)
    }

    fn machines(&self, family: &SceneFamily, value: f64) -> Result<[Machine<f64>; 2]> {
        Ok(self.as_machines(&family.systems(value)?))
    }

    fn linear(&self, family: &SceneFamily, value: f64) -> Result<Option<[Machine<f64>; 2]>> {
        let systems = family.systems(value)?;
        let linear = match &systems {
            [system, _] if system.smooth.is_some() => family.at(value)?.linear(),
            [system, slope] => (system.cubic == 0.0 && slope.cubic == 0.0).then_some(systems),
        };
        Ok(linear.map(|systems| self.as_machines(&systems)))
    }

    fn cubic(&self, family: &SceneFamily, value: f64) -> Result<f64> {
        Ok(family.systems(value)?[0].cubic)
    }

    fn swings(
        &self,
        _: &Vec<State>,
        change: (&str, f64),
        start: &State,
        round: [u32; 2],
    ) -> Result<Option<Vec<Swing>>> {
        response::swings(self, change, start, round)
    }

    fn unit_of_time(&self, change: Option<(&str, f64)>) -> Result<f64> {
        let changed = change.map(|change| self.job.scene.plain(&[change])).transpose()?;
        Ok(TAU / changed.as_ref().unwrap_or(self.system).shown_rate())
    }

    fn system(&self, change: Option<(&str, f64)>) -> Result<Oscillator> {
        self.job.oscillator(match change {
            Some(change) => self.job.scene.plain(&[change])?,
            None => self.system.clone(),
        })
    }

    fn orbits(&self, keys: &OrbitKeys, oscillator: &Oscillator) -> Result<OrbitSearch<Orbit>> {
        keys.orbits(oscillator, || self.job.check())
    }

    fn analysed(&self, orbit: &Orbit, _: &Oscillator) -> Analysed {
        analysed(orbit, self.job, None)
    }

    fn family(&self, parameter: &str) -> Result<SceneFamily<'j>> {
        self.job.family(parameter)
    }

    fn source<'f>(&'f self, family: &'f SceneFamily<'j>) -> Result<OscillatorSource<'f>> {
        OscillatorSource::new(family, self.job)
    }

    fn value(family: &SceneFamily) -> f64 {
        family.value()
    }

    /// The branch of the first admissible orbit is followed to the nearest grazing.
    fn grazing<'f>(
        &'f self,
        task: &'f GrazingTask,
        family: &'f SceneFamily<'j>,
    ) -> Result<std::result::Result<OscillatorGrazing<'f>, String>> {
        let start = family.value();
        match asked_touches(self, family, task, self.job)? {
            Some(Err(why)) => return Ok(Err(why)),
            Some(Ok(touches)) => return self.at_touch(task, family, touches).map(Ok),
            None => {}
        }
        let orbits = task.orbit.orbits(&family.at(start)?, || self.job.check())?.found;
        // Beyond its touch the motion without impacts is not admissible, and leads there all the same.
        let is_far = |orbit: &&Orbit| task.reach.is_none() && orbit.itinerary.strikes().is_empty();
        let admissible = orbits.iter().find(|orbit| orbit.admissibility.is_admissible());
        let Some(orbit) = admissible.or_else(|| orbits.iter().find(is_far)) else {
            return no_orbit(self, family, &task.parameter, self.job).map(Err);
        };
        self.job.check()?;
        let options = task.options.checked()?;
        let search = |orbit: &Orbit, at: f64| {
            let (patterns, extent) = (Patterns::new(family, at)?, task.extent(&family.at(at)?, orbit));
            nearest(&patterns, Bifurcation::Grazing, orbit, at, extent, &options)
        };
        let mut found = admissible.map(|orbit| search(orbit, start)).transpose()?;
        // The motion without impacts may be far from its touch.
        let mut from = Some(orbit).filter(is_far).map(|orbit| (orbit.clone(), start));
        for _ in 0..NEARER {
            let (None | Some(BranchSearch::Nothing(_)), Some((orbit, at))) = (&found, &from) else { break };
            self.job.check()?;
            from = nearer(family, orbit, *at);
            let Some((orbit, at)) = &from else { break };
            if orbit.admissibility.is_admissible() {
                let there = search(orbit, *at)?;
                if found.is_none() || matches!(there, BranchSearch::Found(_)) {
                    found = Some(there);
                }
            }
        }
        let located = match found {
            Some(BranchSearch::Found(found)) => found,
            Some(BranchSearch::Nothing(why)) => return Ok(Err(why.to_string())),
            None => {
                let name = &task.parameter;
                return Ok(Err(format!(
                    "the motion without impacts is beyond a stop at {name} = {start}, and no {name} is found from there \
                     at which it is not"
                )));
            }
        };
        let event = locate(family, &located.orbit, located.parameter)?;
        self.point(task, family, (event, &located.orbit), LinearTouches::default()).map(Ok)
    }

    fn attracting(&self, oscillator: &Oscillator, from: &State, detection: &Detection) -> Result<Orbit> {
        attracting(oscillator, *from, detection, &self.job.settings()?, self.job.monitor)
    }

    fn on_orbit(&self, orbit: &Orbit, oscillator: &Oscillator) -> Result<State> {
        let t = orbit.times().first().copied().unwrap_or(0.0);
        Ok(shown(orbit.state(oscillator, t)?, oscillator))
    }

    fn prover(
        &self,
        change: Option<(&str, &BigRational)>,
        bits: u32,
    ) -> Result<std::result::Result<impl Prover<Orbit>, String>> {
        let precision = Precision::new(bits);
        let (system, rate) = self.job.scene.enclosed(change, &precision)?;
        Ok(Ok(OrbitProver { job: self.job, system, rate, precision }))
    }

    fn range_prover<'e>(&'e self, parameter: &'e str, bits: u32) -> Result<Box<dyn RangeProver<Orbit> + 'e>> {
        Ok(Box::new(proofs::OverRange::new(self.job, parameter, bits)?))
    }

    fn prove_branches(
        &self,
        task: &ValidateTask,
        parameter: &str,
        found: &mut ValidateFindings,
    ) -> Result<()> {
        proofs::branches(task, parameter, self, found)
    }

    fn prove_events(
        &self,
        task: &ValidateTask,
        event: Bifurcation,
        parameter: &str,
        found: &mut ValidateFindings,
    ) -> Result<()> {
        proofs::events(task, event, parameter, self, found)
    }
}

impl<'j> Oscillators<'j> {
    /// The grazing of the motion without impacts at the first of its touches.
    fn at_touch<'f>(
        &'f self,
        task: &'f GrazingTask,
        family: &'f SceneFamily<'j>,
        touches: LinearTouches,
    ) -> Result<OscillatorGrazing<'f>> {
        let LinearTouch { parameter, state, .. } = &touches.found[0];
        let itinerary = Itinerary::free(task.orbit.period)?;
        let orbit = find(&family.at(*parameter)?, &itinerary, vec![state.q()[0], state.u()[0]])?;
        // Newton's method on the flow over a period loses digits at a resonance.
        let event = Grazing { parameter: *parameter, ..locate(family, &orbit, *parameter)? };
        self.point(task, family, (event, &orbit), touches)
    }

    /// All that is asked of a grazing, which an orbit comes to.
    fn point<'f>(
        &'f self,
        task: &'f GrazingTask,
        family: &'f SceneFamily<'j>,
        (event, near): (Grazing, &Orbit),
        touches: LinearTouches,
    ) -> Result<OscillatorGrazing<'f>> {
        let there = family.at(event.parameter)?;
        // Two grazings in a period are the theory's business only if a symmetry makes them one.
        let half = event.half_map(&there);
        let (job, orbit) = (self.job, named(&near.itinerary, self.job));
        let far = far_from(&event, near, &there)?;
        let rate = there.system().shown_rate();
        let hidden = match task.tolerance.0.is_empty() {
            true => None,
            false => job.scene.with_hidden(Some(&task.parameter), &task.tolerance)?,
        };
        let tolerated = hidden.unwrap_or_else(|| (job.scene.clone(), task.tolerance.clone()));
        Ok(OscillatorGrazing { task, job, family, event, half, orbit, far, rate, touches, tolerated })
    }

    /// A system and the rates of its coefficients, as machines.
    fn as_machines(&self, [system, slope]: &[System<f64>; 2]) -> [Machine<f64>; 2] {
        let names = [Side::Lower, Side::Upper].map(|side| self.job.stop(side));
        let names = names.each_ref().map(String::as_str);
        [(system, 1.0), (slope, 0.0)].map(|(system, unit)| Machine::of_oscillator(system, names, unit))
    }
}

/// The motion without impacts at a value of the parameter most of the way to where its least gap closes, to
/// first order, or half as far again and again, or from beyond a stop a little farther than there; none where
/// it does not change or there is no such motion.
fn nearer(family: &SceneFamily, orbit: &Orbit, at: f64) -> Option<(Orbit, f64)> {
    let there = |value: f64, z: Vec<f64>| find(&family.at(value).ok()?, &orbit.itinerary, z).ok();
    let gap = |orbit: &Orbit| orbit.least.map(|least| least.gap);
    let step = SMALL * family.at(at).ok()?.parameter_unit(orbit.unit);
    let ahead = there(at + step, orbit.z.clone())?;
    let slope = (gap(&ahead)? - gap(orbit)?) / step;
    let there = |value: f64| {
        let moved = |(z, ahead): (&f64, &f64)| z + (ahead - z) / step * (value - at);
        there(value, orbit.z.iter().zip(&ahead.z).map(moved).collect())
    };
    let closed = at - gap(orbit)? / slope;
    let open = gap(orbit)?;
    if open > 0.0 {
        // Before the gap closes there may be a fold, beyond which there is no such motion.
        let values = (0..NEARER).map(|i| at - MOST * open / slope / f64::from(1 << i));
        return values.filter(|value| value.is_finite()).find_map(|value| Some((there(value)?, value)));
    }
    let value = closed + OPEN * there(closed)?.unit / slope;
    Some((there(value).filter(|_| value.is_finite())?, value))
}

/// A state of the orbit that grazes, in the scene's unit of time, half a period from the touch: followed from
/// there, unless there are other impacts.
fn far_from(event: &Grazing, orbit: &Orbit, oscillator: &Oscillator) -> Result<State> {
    let t = event.z[0];
    let wall = oscillator.walls().iter().find(|wall| wall.side == event.side());
    let far = match wall.filter(|_| event.itinerary.strikes().len() == 1) {
        Some(wall) => {
            let [q, u, _] = wall.position.at(t);
            oscillator.flow().advance(State { t, q, u }, PI)
        }
        None => orbit.state(oscillator, t + PI)?,
    };
    Ok(shown(far, oscillator))
}

/// A state in the scene's unit of time.
fn shown(state: State, oscillator: &Oscillator) -> State {
    State { t: state.t.rem_euclid(TAU), u: state.u * oscillator.system().shown_rate(), ..state }
}
