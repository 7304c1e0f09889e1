//! Machines: their orbits as tasks ask for them.
//!
//! Phases are fractions of the period, everything else is in the scene's units.

mod grazing;
mod job;
mod motion;
mod proofs;
mod response;
mod rest;
mod search;
mod sections;
mod source;

use std::f64::consts::TAU;

use grazing::MachineGrazingPoint;
use num_rational::BigRational;
use proofs::MachineProver;
use search::machine_orbits;
pub use source::{MachineSource, form};

use super::{
    super::{
        Analysed, Complex, Job, Judgement, Keeper, SectionFindings, SimulationFindings, StartNumbers,
        ValidateFindings, rest::RestsHere,
    },
    Engine, JudgedOrbit, OrbitSource as _, Prover, RangeProver, StartPlane, asked_touches,
};
use crate::{
    attractor::{basins::BasinGrid, cycle::Cycle, detection::Detection, dynamics::Dynamics, swing::Swing},
    continuation::{Bifurcation, BranchSearch, FollowedOrbit, OrbitSearch, SearchReach, counted, nearest},
    error::{Error, Result},
    many::{
        Family, Machine, State,
        attracting::attracting,
        grazing::{Further, Grazing, LinearTouches, Search, locate, own_reach},
        orbit::{Admissibility, Itinerary, Orbit, find_from},
        section::{self, PlanarMachine, Point},
        simulate::Simulator,
    },
    number::{Plain, Real},
    rounding::CIRCLE,
    scene::{
        BasinsTask, MachineSceneFamily, SectionTask,
        orbits::{GrazingTask, OrbitKeys},
        rest::RestTask,
        simulate::{SimulateTask, Start},
        validate::ValidateTask,
    },
    search::machine::listed,
};

impl JudgedOrbit for Orbit {
    fn stable(&self, at: Option<Bifurcation>) -> Judgement {
        let off = |&(re, im): &(f64, f64)| match at {
            Some(Bifurcation::SaddleNode | Bifurcation::Crossing) => (re - 1.0).hypot(im),
            Some(Bifurcation::Flip) => (re + 1.0).hypot(im),
            _ => (re.hypot(im) - 1.0).abs(),
        };
        let critical = match at {
            Some(Bifurcation::SaddleNode | Bifurcation::Crossing | Bifurcation::Flip) => 1,
            Some(Bifurcation::Torus) => 2,
            _ => 0,
        };
        let mut all = self.multipliers.clone();
        all.sort_by(|a, b| off(a).total_cmp(&off(b)));
        let largest = all[critical.min(all.len())..].iter().map(|x| x.0.hypot(x.1)).fold(0.0, f64::max);
        match () {
            () if largest > 1.0 + CIRCLE => Judgement::No,
            () if critical > 0 || (largest - 1.0).abs() <= CIRCLE => Judgement::Marginal,
            () => Judgement::Yes,
        }
    }
}

/// Whether it is an orbit, and why not; marginal at a grazing or where an impact fades.
fn admissible(orbit: &Orbit, at: Option<Bifurcation>) -> (Judgement, Option<String>) {
    if matches!(at, Some(Bifurcation::Grazing | Bifurcation::Fade)) {
        return (Judgement::Marginal, None);
    }
    match &orbit.admissibility {
        Admissibility::Admissible if !orbit.is_orbit() => {
            let why = "the least gap between impacts is not positive, though within the minimum depth";
            (Judgement::Marginal, Some(why.into()))
        }
        Admissibility::Admissible => (Judgement::Yes, None),
        Admissibility::Marginal(why) => (Judgement::Marginal, Some(why.to_string())),
        Admissibility::No(why) => (Judgement::No, Some(why.to_string())),
    }
}

/// Multipliers that a report shows.
const SHOWN: usize = 4;

/// Phases as fractions of the period, as the pattern counts them.
fn phases(orbit: &Orbit) -> Vec<f64> {
    let times: Vec<f64> = orbit.impacts.iter().map(|impact| impact.time).collect();
    counted(&times).into_iter().map(|time| time / TAU).collect()
}

/// Incoming speeds in the scene's units, of which `rate` is Ω.
fn speeds(orbit: &Orbit, rate: f64) -> Vec<f64> {
    orbit.impacts.iter().map(|impact| impact.speed * rate).collect()
}

/// What is known of an orbit of a machine.
fn analysed(orbit: &Orbit, machine: &Machine<f64>, at: Option<Bifurcation>) -> Analysed {
    let (admissible, reason) = admissible(orbit, at);
    Analysed {
        pattern: named(&orbit.itinerary, machine),
        phases: phases(orbit),
        speeds: speeds(orbit, machine.rate()),
        multipliers: orbit.multipliers.iter().take(SHOWN).map(|&one| Complex::from(one)).collect(),
        stable: orbit.stable(at),
        admissible,
        reason,
        drift: orbit.drift.clone(),
        nearest_stop: orbit.least.map(|least| machine.stops[least.stop].name.clone()),
        least_gap: orbit.least.map(|least| least.gap),
        residual: orbit.residual,
        newton_steps: orbit.steps,
    }
}

fn named(pattern: &Itinerary, machine: &Machine<f64>) -> String {
    let stops = &machine.stops;
    pattern.with_names(|stop| (stops.len() > 1).then(|| &stops[stop].name))
}

fn names(machine: &Machine<f64>) -> Vec<&str> {
    machine.stops.iter().map(|stop| stop.name.as_str()).collect()
}

/// The engine for machines at work on a job.
pub(crate) struct Machines<'j> {
    pub job: &'j Job<'j>,
    pub machine: &'j Machine<f64>,
}

impl<'j> Engine for Machines<'j> {
    type Orbit = Orbit;
    type System = (Machine<f64>, Simulator);
    type Family = MachineSceneFamily<'j>;
    type Source<'f>
        = MachineSource<'f>
    where
        Self: 'f;
    type Grazing<'f>
        = MachineGrazingPoint<'f>
    where
        Self: 'f;

    type Dynamics = PlanarMachine;
    type States = Vec<State>;

    fn states(&self, starts: &[Start]) -> Result<Vec<State>> {
        starts.iter().map(|start| self.job.scene.machine_state(start, self.machine, "starts")).collect()
    }

    fn begun(&self, states: &Vec<State>) -> Vec<section::Start> {
        states.iter().map(|state| state.start(self.machine.rate())).collect()
    }

    fn dynamics(
        &self,
        states: &Vec<State>,
        change: Option<(&str, f64)>,
        plane: &[String],
    ) -> Result<PlanarMachine> {
        match change {
            None => self.job.planar(self.machine, states, plane),
            Some(change) => self.job.planar(&self.job.scene.machine(&[change])?, states, plane),
        }
    }

    fn plane(&self, plane: &[String]) -> Option<[String; 2]> {
        Some(self.job.scene.plane_names(plane))
    }

    /// The minimum depth is to be small against the size of the gap to the nearest stop; without stops it
    /// decides nothing.
    fn extents(&self, planar: &PlanarMachine) -> (f64, Option<f64>) {
        let simulator = planar.simulator();
        let none = simulator.contacts().all().is_empty();
        (simulator.settings().minimum_depth, Some(if none { f64::INFINITY } else { simulator.gap_scale() }))
    }

    fn start_plane(&self, task: &BasinsTask, _: &BasinGrid, phase: f64) -> Result<StartPlane<PlanarMachine>> {
        let Machines { job, machine } = *self;
        let rest = job.scene.rest(&task.start, machine)?;
        let axes = job.scene.plane(&task.plane, machine, "plane")?;
        let planar = job.planar(machine, &[], &task.plane)?;
        let dynamics = planar.starting(machine, &axes, [&rest[0], &rest[1]])?;
        let names = job.scene.plane_names(&task.plane);
        let own = serde_json::to_string(&(&names, &rest, dynamics.simulator().settings()));
        let (minimum_depth, size) = self.extents(&dynamics);
        Ok(StartPlane {
            dynamics,
            place: Box::new(move |dynamics, at| dynamics.in_plane(at, phase)),
            plane: Some(names),
            identity: own.map_err(std::io::Error::other)?,
            minimum_depth,
            size: size.unwrap_or(f64::INFINITY),
        })
    }

    fn further_orbits(
        &self,
        task: &SectionTask,
        planar: &PlanarMachine,
        cycles: &[(usize, Cycle<Point>)],
        found: &mut SectionFindings,
    ) -> Result<()> {
        sections::further(task, self, planar, cycles, found)
    }

    fn crossings(&self, start: &section::Start, periods: u32) -> Result<Vec<(String, [f64; 2])>> {
        motion::crossings(self, start, periods)
    }

    fn numbers(&self, start: &section::Start) -> StartNumbers {
        (start.t, self.machine.displaced(&start.q), self.machine.displaced(&start.u))
    }

    fn simulate(&self, task: &SimulateTask, keeper: &mut dyn Keeper) -> Result<SimulationFindings> {
        motion::simulate(task, self, keeper)
    }

    fn rests(&self, task: &RestTask, change: Option<(&str, f64)>) -> Result<RestsHere> {
        let changed = change.map(|change| self.job.scene.machine(&[change])).transpose()?;
        rest::rests(task, self.job, changed.as_ref().unwrap_or(self.machine))
    }

    fn machines(&self, family: &MachineSceneFamily, value: f64) -> Result<[Machine<f64>; 2]> {
        let (machine, slope) = family.at(value)?;
        Ok([machine, slope])
    }

    fn linear(&self, family: &MachineSceneFamily, value: f64) -> Result<Option<[Machine<f64>; 2]>> {
        let (machine, slope) = family.at(value)?;
        let is_linear = !machine.is_smooth() && machine.friction.is_empty();
        Ok(is_linear.then_some([machine, slope]))
    }

    fn cubic(&self, _: &MachineSceneFamily, _: f64) -> Result<f64> {
        Ok(0.0)
    }

    fn swings(
        &self,
        states: &Vec<State>,
        change: (&str, f64),
        start: &section::Start,
        round: [u32; 2],
    ) -> Result<Option<Vec<Swing>>> {
        response::swings(self, states, change, start, round)
    }

    fn unit_of_time(&self, change: Option<(&str, f64)>) -> Result<f64> {
        let changed = change.map(|change| self.job.scene.machine(&[change])).transpose()?;
        Ok(changed.as_ref().unwrap_or(self.machine).period)
    }

    fn system(&self, change: Option<(&str, f64)>) -> Result<Self::System> {
        let machine = match change {
            Some(change) => self.job.scene.machine(&[change])?,
            None => self.machine.clone(),
        };
        let simulator = self.job.machine_simulator(&machine, &[])?;
        Ok((machine, simulator))
    }

    fn orbits(&self, keys: &OrbitKeys, (machine, simulator): &Self::System) -> Result<OrbitSearch<Orbit>> {
        machine_orbits(keys, machine, simulator, self.job)
    }

    fn analysed(&self, orbit: &Orbit, (machine, _): &Self::System) -> Analysed {
        analysed(orbit, machine, None)
    }

    fn family(&self, parameter: &str) -> Result<MachineSceneFamily<'j>> {
        self.job.machine_family(parameter)
    }

    fn source<'f>(&'f self, family: &'f MachineSceneFamily<'j>) -> Result<MachineSource<'f>> {
        MachineSource::new(family, self.machine, self.job)
    }

    fn value(family: &MachineSceneFamily) -> f64 {
        family.value()
    }

    /// The motion without impacts is followed to the nearest grazing.
    fn grazing<'f>(
        &'f self,
        task: &'f GrazingTask,
        family: &'f MachineSceneFamily<'j>,
    ) -> Result<std::result::Result<MachineGrazingPoint<'f>, String>> {
        let start = family.value();
        let near = search::state(&task.orbit, self.machine)?;
        let touches = match asked_touches(self, family, task, self.job)? {
            Some(Err(why)) => return Ok(Err(why)),
            Some(Ok(touches)) => touches,
            None => LinearTouches::default(),
        };
        let from = touches.found.first().map_or(start, |nearest| nearest.parameter);
        let reach = task.reach.map_or_else(|| own_reach(family, from, near.as_ref()), Ok)?;
        let event = match touches.found.first() {
            Some(nearest) => Grazing::at(family, nearest.parameter)?,
            None => {
                let further = |state: &State| self.along_branch(task, (family, state), reach);
                let further: Option<Further> = if self.machine.is_smooth() { Some(&further) } else { None };
                match locate(family, start, reach, near.as_ref(), further)? {
                    Search::Found(found) => *found,
                    Search::Nothing(reason) => return Ok(Err(reason)),
                }
            }
        };
        self.job.check()?;
        let (machine, _) = family.at(event.parameter)?;
        Ok(Ok(MachineGrazingPoint { task, job: self.job, family, event, machine, reach, touches }))
    }

    fn attracting(
        &self,
        (machine, _): &Self::System,
        from: &section::Start,
        detection: &Detection,
    ) -> Result<Orbit> {
        attracting(&self.job.planar(machine, &[], &[])?, from, detection, self.job.monitor)
    }

    fn on_orbit(&self, orbit: &Orbit, (machine, _): &Self::System) -> Result<section::Start> {
        Ok(orbit.state.start(machine.rate()))
    }

    fn prover(
        &self,
        change: Option<(&str, &BigRational)>,
        _: u32,
    ) -> Result<std::result::Result<impl Prover<Orbit>, String>> {
        let scene = &self.job.scene;
        let enclosed = scene.enclosed_machine(change)?;
        let change = change.map(|(name, value)| (name, Plain::ratio(value, &()).0));
        Ok(match listed(&enclosed) {
            Ok(listed) => {
                let machine = change.map_or_else(|| Ok(self.machine.clone()), |one| scene.machine(&[one]))?;
                Ok(MachineProver { job: self.job, machine, listed, period: enclosed.period })
            }
            Err(error) => Err(error.to_string()),
        })
    }

    fn range_prover<'e>(&'e self, _: &'e str, _: u32) -> Result<Box<dyn RangeProver<Orbit> + 'e>> {
        // Refused when the scene was read.
        Err(Error::input("orbits of machines are not proved over a range"))
    }

    fn prove_branches(&self, _: &ValidateTask, _: &str, _: &mut ValidateFindings) -> Result<()> {
        // Refused when the scene was read.
        Err(Error::input("orbits of machines are not proved over a range"))
    }

    fn prove_events(
        &self,
        _: &ValidateTask,
        _: Bifurcation,
        _: &str,
        _: &mut ValidateFindings,
    ) -> Result<()> {
        // Refused when the scene was read.
        Err(Error::input("bifurcations of machines are not proved"))
    }
}

impl<'j> Machines<'j> {
    /// The touch of the motion without impacts along its branch, from its state at phase 0, through folds in
    /// which the parameter turns; the inner error is why there is none.
    fn along_branch(
        &self,
        task: &GrazingTask,
        (family, state): (&MachineSceneFamily<'j>, &State),
        reach: f64,
    ) -> Result<std::result::Result<Grazing, String>> {
        let (source, start) = (self.source(family)?, family.value());
        let simulator = self.job.machine_simulator(self.machine, &[])?;
        let known = find_from(&simulator, &Itinerary::free(1)?, &[], Some(state)).ok();
        let known = known.filter(FollowedOrbit::is_orbit);
        let orbits = known.map_or_else(|| source.present(&task.orbit), |orbit| Ok(vec![orbit]))?;
        let Some(orbit) = orbits.first() else {
            return Ok(Err(format!("no admissible orbit to follow at {} = {start}", task.parameter)));
        };
        let extent = SearchReach::Parameter { unit: reach, reach };
        let options = task.options.checked()?;
        Ok(match nearest(source.family(), Bifurcation::Grazing, orbit, start, extent, &options)? {
            BranchSearch::Found(found) => Ok(Grazing::near(family, found.parameter, &found.orbit.state)?),
            BranchSearch::Nothing(why) => Err(format!("followed as a branch: {why}")),
        })
    }
}
