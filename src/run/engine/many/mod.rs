//! Machines: their orbits as tasks ask for them.
//!
//! Phases are fractions of the period, everything else is in the scene's units.

mod job;
mod motion;
mod proofs;
mod search;
mod sections;

use std::f64::consts::TAU;

use proofs::MachineProver;
use search::machine_orbits;

use super::{
    super::{
        Analysed, Complex, GrazingEventRow, GrazingMap, Job, Judgement, Keeper, SectionFindings,
        SimulationFindings, ValidateFindings,
        branch::{events, settled},
    },
    AnalysedEvent, Branches, Engine, GrazingPoint, JudgedOrbit, OrbitSource, Prover, StartPlane, Theory,
};
use crate::{
    attractor::{basins::BasinGrid, cycle::Cycle, dynamics::Dynamics, observe::Attraction},
    continuation::{Bifurcation, FollowedOrbit, Label, Located, RecordForm, SearchReach, read_label_as},
    error::{Error, Result},
    many::{
        Machine, MachineFamily, MachineState, RealMatrix, StopLaw,
        branch::{MachinePatterns, MachinePlane},
        grazing::{MachineGrazing, MachineSearch, locate, own_reach},
        normal_form::normal_form,
        orbit::{MachineAdmissibility, MachineOrbit, StopPattern, StopStrike, find, find_from},
        section::{MachinePoint, MachineStart, PlanarMachine},
        simulate::{Event, MachineRun, MachineSimulator},
    },
    motion::{RunEnd, Time},
    one::{
        grazing::region_of,
        orbit::{counted, natural},
    },
    pattern::{Analysis, Map, Numbers, Report as Verdict},
    scene::{
        BasinsTask, MachineSceneFamily, SectionTask,
        branches::{BranchOrigin, BranchStart, BranchTask},
        orbits::{GrazingTask, OrbitKeys},
        simulate::{SimulateTask, Start},
        validate::ValidateTask,
    },
    search::machine::listed,
};

/// Closer to the unit circle than this, rounding decides.
const MARGIN: f64 = 1e-11;

impl JudgedOrbit for MachineOrbit {
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
            () if largest > 1.0 + MARGIN => Judgement::No,
            () if critical > 0 || (largest - 1.0).abs() <= MARGIN => Judgement::Marginal,
            () => Judgement::Yes,
        }
    }

    fn admissible(&self, at: Option<Bifurcation>) -> (Judgement, Option<String>) {
        if matches!(at, Some(Bifurcation::Grazing | Bifurcation::Fade)) {
            return (Judgement::Marginal, None);
        }
        match &self.admissibility {
            MachineAdmissibility::Admissible if !self.is_orbit() => {
                let why = "the least gap between impacts is not positive, though within the minimum depth";
                (Judgement::Marginal, Some(why.into()))
            }
            MachineAdmissibility::Admissible => (Judgement::Yes, None),
            MachineAdmissibility::Marginal(why) => (Judgement::Marginal, Some(why.to_string())),
            MachineAdmissibility::No(why) => (Judgement::No, Some(why.to_string())),
        }
    }
}

/// Multipliers that a report shows.
const SHOWN: usize = 4;

/// Phases as fractions of the period, as the pattern counts them.
fn phases(orbit: &MachineOrbit) -> Vec<f64> {
    let times: Vec<f64> = orbit.impacts.iter().map(|impact| impact.time).collect();
    counted(&times).into_iter().map(|time| time / TAU).collect()
}

/// Incoming speeds in the scene's units, of which `rate` is Ω.
fn speeds(orbit: &MachineOrbit, rate: f64) -> Vec<f64> {
    orbit.impacts.iter().map(|impact| impact.speed * rate).collect()
}

/// What is known of an orbit of a machine.
fn analysed(orbit: &MachineOrbit, machine: &Machine<f64>, at: Option<Bifurcation>) -> Analysed {
    let (admissible, reason) = orbit.admissible(at);
    Analysed {
        pattern: named(&orbit.pattern, machine),
        phases: phases(orbit),
        speeds: speeds(orbit, machine.rate()),
        multipliers: orbit.multipliers.iter().take(SHOWN).map(|&one| Complex::from(one)).collect(),
        stable: orbit.stable(at),
        admissible,
        reason,
        nearest_stop: orbit.least.map(|least| machine.stops[least.stop].name.clone()),
        least_gap: orbit.least.map(|least| least.gap),
        residual: orbit.residual,
        newton_steps: orbit.steps,
    }
}

fn named(pattern: &StopPattern, machine: &Machine<f64>) -> String {
    pattern.with_names(&names(machine))
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
    type Orbit = MachineOrbit;
    type System = (Machine<f64>, MachineSimulator);
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
    type States = Vec<MachineState>;

    fn states(&self, starts: &[Start]) -> Result<Vec<MachineState>> {
        starts.iter().map(|start| self.job.scene.machine_state(start, self.machine, "starts")).collect()
    }

    fn begun(&self, states: &Vec<MachineState>) -> Vec<MachineStart> {
        states.iter().map(|state| state.start(self.machine.rate())).collect()
    }

    fn dynamics(
        &self,
        states: &Vec<MachineState>,
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
        cycles: &[(usize, Cycle<MachinePoint>)],
        found: &mut SectionFindings,
    ) -> Result<()> {
        sections::further(task, self, planar, cycles, found)
    }

    fn simulate(&self, task: &SimulateTask, keeper: &mut dyn Keeper) -> Result<SimulationFindings> {
        motion::simulate(task, self, keeper)
    }

    fn system(&self, change: Option<(&str, f64)>) -> Result<Self::System> {
        let machine = match change {
            Some(change) => self.job.scene.machine(&[change])?,
            None => self.machine.clone(),
        };
        let simulator = self.job.machine_simulator(&machine, &[])?;
        Ok((machine, simulator))
    }

    fn orbits(&self, keys: &OrbitKeys, (machine, simulator): &Self::System) -> Result<Vec<MachineOrbit>> {
        machine_orbits(keys, machine, simulator, self.job)
    }

    fn analysed(&self, orbit: &MachineOrbit, (machine, _): &Self::System) -> Analysed {
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
        let reach = task.reach.map_or_else(|| own_reach(family, start), Ok)?;
        let event = match locate(family, start, reach)? {
            MachineSearch::Found(found) => *found,
            MachineSearch::Nothing(reason) => return Ok(Err(reason)),
        };
        self.job.check()?;
        let (machine, _) = family.at(event.parameter)?;
        Ok(Ok(MachineGrazingPoint { task, job: self.job, family, event, machine, reach }))
    }

    fn prover(&self, _: &ValidateTask) -> Result<std::result::Result<impl Prover<MachineOrbit>, String>> {
        let enclosed = self.job.scene.enclosed_machine()?;
        Ok(match listed(&enclosed) {
            Ok(listed) => {
                let (job, machine, period) = (self.job, self.machine, enclosed.period);
                Ok(MachineProver { job, machine, listed, period })
            }
            Err(error) => Err(error.to_string()),
        })
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

/// The format of a machine's branch in a file.
const FORMAT: &str = "grazing-machine-branch 1";

/// The form in which branches of a machine with stops of these names are written.
pub fn form<'n>(names: &'n [&'n str]) -> RecordForm<'n> {
    RecordForm { format: FORMAT, contacts: names }
}

/// The orbits of a scene's machine over a parameter.
pub struct MachineSource<'a> {
    family: &'a MachineSceneFamily<'a>,
    /// What is searched for orbits with given patterns.
    pub patterns: MachinePatterns<'a>,
    machine: &'a Machine<f64>,
    job: &'a Job<'a>,
}

impl<'a> MachineSource<'a> {
    /// # Errors
    /// Those of [`MachinePatterns::new`].
    pub fn new(
        family: &'a MachineSceneFamily<'a>,
        machine: &'a Machine<f64>,
        job: &'a Job<'a>,
    ) -> Result<MachineSource<'a>> {
        let depth = job.scene.machine_scene()?.minimum_depth;
        let patterns = MachinePatterns::new(family, family.value(), depth)?;
        Ok(MachineSource { family, patterns, machine, job })
    }

    fn admissible(&self, keys: &OrbitKeys, machine: &Machine<f64>) -> Result<Vec<MachineOrbit>> {
        let mut found = machine_orbits(keys, machine, &self.job.machine_simulator(machine, &[])?, self.job)?;
        found.retain(FollowedOrbit::is_orbit);
        Ok(found)
    }
}

impl<'a> OrbitSource for MachineSource<'a> {
    type Orbit = MachineOrbit;
    type Family = MachinePatterns<'a>;

    fn family(&self) -> &MachinePatterns<'a> {
        &self.patterns
    }

    fn value(&self) -> f64 {
        self.family.value()
    }

    fn present(&self, keys: &OrbitKeys) -> Result<Vec<MachineOrbit>> {
        self.admissible(keys, self.machine)
    }

    fn orbits(&self, start: &BranchStart, at: f64) -> Result<Vec<MachineOrbit>> {
        let (machine, _) = self.family.at(at)?;
        match start.origin()? {
            BranchOrigin::Attractor(state) => {
                let from = self.job.scene.machine_state(state, &machine, "attractor")?;
                let planar = self.job.planar(&machine, std::slice::from_ref(&from), &[])?;
                let found = attracting(&planar, &from, from.t, self.job)?;
                Ok(Some(found).filter(FollowedOrbit::is_orbit).into_iter().collect())
            }
            BranchOrigin::Orbit(keys) => self.admissible(keys, &machine),
            BranchOrigin::Restart(_) => Ok(Vec::new()),
        }
    }

    fn reaches(&self, reach: Option<f64>, orbits: &[MachineOrbit]) -> Result<Vec<SearchReach>> {
        let unit = own_reach(self.family, self.value())?;
        Ok(vec![SearchReach::Parameter { unit, reach: reach.unwrap_or(unit) }; orbits.len()])
    }

    fn analysed(
        &self,
        orbit: &MachineOrbit,
        at: &[(&str, f64)],
        event: Option<Bifurcation>,
    ) -> Result<AnalysedEvent> {
        let (machine, form) = match at {
            &[(_, parameter)] => {
                let (machine, slope) = self.family.at(parameter)?;
                let form = event.map(|event| normal_form(&machine, &slope, orbit, event));
                (machine, form)
            }
            _ => (self.job.scene.machine(at)?, None),
        };
        let rate = machine.rate();
        let least = orbit.least.filter(|_| event == Some(Bifurcation::Grazing));
        let touch = least.map(|least| {
            let stop = machine.stops[least.stop].name.clone();
            (stop, (least.phase / TAU).fract(), least.acceleration * rate * rate)
        });
        Ok(AnalysedEvent { orbit: analysed(orbit, &machine, event), form, touch })
    }

    fn named_with_speeds(&self, orbit: &MachineOrbit) -> (String, Vec<f64>) {
        (self.named(&orbit.pattern), speeds(orbit, self.machine.rate()))
    }

    fn has_maps(&self) -> bool {
        false
    }

    fn local_map(&self, _: &Located<MachineOrbit>, _: &MachineOrbit) -> Result<Option<GrazingEventRow>> {
        Ok(None)
    }

    fn loci(&self, task: &BranchTask, second: &str) -> Result<Branches<MachineOrbit>> {
        let at =
            |[first, other]: [f64; 2]| self.job.scene.machine(&[(&task.parameter, first), (second, other)]);
        let value = MachineSceneFamily::new(&self.job.scene, second)?.value();
        let depth = self.job.scene.machine_scene()?.minimum_depth;
        let plane = MachinePlane::new(&at, [self.value(), value], depth, self.family.tally())?;
        events(task, self, &plane, value, self.job)
    }

    fn label(&self, text: &str, label: &str) -> Result<Label<StopPattern>> {
        read_label_as(text, label, form(&names(self.machine)), |strikes, period| {
            if strikes.is_empty() {
                return StopPattern::free(period);
            }
            StopPattern::new(strikes.iter().map(|&(stop, periods)| StopStrike { stop, periods }).collect())
        })
    }

    fn named(&self, pattern: &StopPattern) -> String {
        named(pattern, self.machine)
    }
}

/// A least gap that changes over the reach by less than this, relative to the gaps' motion, does not pass
/// through 0.
const FLAT: f64 = 1e-9;

/// A grazing bifurcation of the motion without impacts of a machine.
pub(crate) struct MachineGrazingPoint<'f> {
    task: &'f GrazingTask,
    job: &'f Job<'f>,
    family: &'f MachineSceneFamily<'f>,
    event: MachineGrazing,
    machine: Machine<f64>,
    /// How far it was looked for.
    reach: f64,
}

impl GrazingPoint for MachineGrazingPoint<'_> {
    const HALF: &'static str =
        "of half a period, then the mirror: the stop and its mirror are grazed; patterns count halves";
    const NEEDS: &'static str = "that needs a2 > 0 and gamma other than 0";

    fn report(&self) -> GrazingMap {
        let (event, map, machine) = (&self.event, self.event.local(), &self.machine);
        let (rate, n, one) = (machine.rate(), machine.size, machine.size == 1);
        // From velocities per radian to velocities per unit of time.
        let unit = |i: usize| if i < n { 1.0 } else { rate };
        let scaled = RealMatrix::from_fn(2 * n, 2 * n, |i, j| map.a[(i, j)] * unit(i) / unit(j));
        let phase = event.at.phase / TAU;
        let region = || region_of(map.a.trace(), map.determinant).map(|region| region.to_string());
        GrazingMap {
            varied: self.task.parameter.clone(),
            parameter: event.parameter,
            orbit: None,
            stop: machine.stops[event.at.stop].name.clone(),
            phase: if phase < 1.0 { phase } else { 0.0 },
            acceleration: map.acceleration * rate * rate,
            a: scaled.row_iter().map(|row| row.iter().copied().collect()).collect(),
            b: (0..2 * n).map(|i| map.b[i] * unit(i)).collect(),
            c: map.c.iter().copied().collect(),
            e: map.e,
            eigenvalues: map.eigenvalues.iter().map(|&x| Complex::from(x)).collect(),
            a1: one.then(|| map.a.trace()),
            a2: one.then_some(map.determinant),
            gamma: map.gamma().map(|gamma| gamma / rate),
            region: one.then(region).flatten(),
            admissible: Judgement::Yes,
            residual: event.at.gap.abs(),
            half: event.half.is_some(),
            open: self.open(),
            chaos_open: None,
        }
    }

    fn plane(&self) -> Option<[f64; 4]> {
        let map = self.event.local();
        map.gamma().map(|gamma| [map.a.trace(), map.determinant, gamma, map.e])
    }

    fn map(&self) -> Result<Map> {
        self.event.local().to_map()
    }

    fn theory<'m>(&self, map: &'m Map) -> Result<Theory<'m>> {
        let analysis = Analysis::new(map, self.task.max_period.into(), Numbers::Enclosed);
        Ok(Box::new(move |periods: &[u64]| analysis.judge(periods)))
    }

    fn leading(&self, _: &[u64], verdict: &Verdict) -> Option<f64> {
        Some(verdict.orbit.as_ref()?.leading.as_ref()?.middle())
    }

    fn size(&self) -> Result<f64> {
        Ok(self.event.scale)
    }

    fn orbit(
        &self,
        periods: &[u64],
        verdict: &Verdict,
        parameter: f64,
        away: f64,
    ) -> Result<Result<Analysed>> {
        let (machine, _): (Machine<f64>, _) = self.family.at(parameter)?;
        let simulator = self.job.machine_simulator(&machine, &[])?;
        let (strikes, start) = self.event.start(periods, verdict, away)?;
        Ok(find(&simulator, &strikes, &start).map(|orbit| analysed(&orbit, &machine, None)))
    }
}

impl MachineGrazingPoint<'_> {
    /// Why the local theory is not for this grazing; `None` where it is.
    fn open(&self) -> Option<String> {
        let MachineGrazingPoint { task, event, machine, reach, .. } = self;
        let (map, rate) = (event.local(), machine.rate());
        let name = |stop: usize| &machine.stops[stop].name;
        if let StopLaw::Soft { damping, .. } = machine.stops[event.at.stop].law {
            return Some(format!(
                "stop {} gives way: what a contact of depth d changes is of the order of d{}, so the local map has no square \
                 root, and the local theory is not for it",
                name(event.at.stop),
                if damping > 0.0 { "" } else { "^(3/2)" }
            ));
        }
        if let Some(other) = event.others.first().filter(|_| event.half.is_none()) {
            return Some(if other.stop == event.at.stop {
                format!(
                    "the motion grazes stop {} more than once in its period: the local theory is for one grazing",
                    name(other.stop)
                )
            } else {
                format!(
                    "the motion grazes several stops in its period, {} and {} among them: the local theory is for one grazing",
                    name(event.at.stop),
                    name(other.stop)
                )
            });
        }
        if map.acceleration.is_nan() || map.acceleration <= 0.0 {
            return Some(format!(
                "a_G = {} at the touch: the local theory is for a positive one",
                map.acceleration * rate * rate
            ));
        }
        if map.e.is_nan() || map.e.abs() * reach <= FLAT * event.scale {
            return Some(format!(
                "e = {:e}: the least gap only touches 0 as {} varies, and the local theory is for one that passes through it",
                map.e, task.parameter
            ));
        }
        (event.at.gap.abs() > 1e-9 * event.scale).then(|| {
            format!("the least gap passes through 0 without being found there: {:e} is left", event.at.gap)
        })
    }
}

/// The periodic orbit on which a motion settles: its impact pattern is read off the attractor that is found.
fn attracting(planar: &PlanarMachine, from: &MachineState, phase: f64, job: &Job) -> Result<MachineOrbit> {
    let (simulator, detection) = (planar.simulator(), settled(phase));
    let start = from.start(simulator.rate());
    let found = planar.fates(std::slice::from_ref(&start), &detection, &[], job.monitor)?;
    let fate = found.into_iter().next().flatten();
    let fate = fate.ok_or_else(|| Error::input("the attractor's start lies behind a stop"))?;
    let cycle = fate.periodic(&detection)?;
    // At phase 0 the state of an orbit without impacts is asked for.
    let at = planar.state(&cycle.points[0].whole, phase);
    let period = cycle.period() as i64;
    let mut run = simulator.start(Time::new(0, phase), at.q.as_slice(), at.u.as_slice())?;
    // Where the state does not follow from times and speeds.
    let soft =
        simulator.is_smooth() || simulator.contacts().all().iter().any(|contact| contact.soft.is_some());
    let (mut struck, mut impacts) = (None, Vec::<(usize, Time, f64)>::new());
    let mut rests = !run.resting().is_empty();
    let end = loop {
        match run.next(Time::new(period, phase)) {
            Event::Impact(hit) => {
                impacts.push((hit.place, hit.time, -hit.velocity));
                if soft && struck.is_none() {
                    struck = Some(run.state());
                }
            }
            Event::Stick(_) => rests = true,
            Event::End(end) => break end,
            _ => {}
        }
    };
    ended(&mut run, end)?;
    if rests {
        return Err(Error::input("the motion comes to rest on a stop: orbits with rests are not followed"));
    }
    let turned = |time: &Time| {
        let turns = (time.phase / TAU).floor();
        (time.period + turns as i64, time.phase - turns * TAU)
    };
    let times: Vec<(i64, f64)> = impacts.iter().map(|(_, time, _)| turned(time)).collect();
    let counted = natural(&times, period as u32);
    let strikes =
        impacts.iter().zip(&counted).map(|(hit, &(periods, _))| StopStrike { stop: hit.0, periods });
    let strikes: Vec<StopStrike> = strikes.collect();
    if strikes.is_empty() {
        let pattern = StopPattern::free(period as u32)?;
        let end = run.finish(Time::new(period + 1, 0.0));
        ended(&mut run, end)?;
        return find_from(simulator, &pattern, &[], Some(&run.state()));
    }
    let start: Vec<f64> =
        counted.iter().zip(&impacts).flat_map(|((_, time), (_, _, speed))| [*time, *speed]).collect();
    find_from(simulator, &StopPattern::new(strikes)?, &start, struck.as_ref())
}

fn ended(run: &mut MachineRun, end: RunEnd) -> Result<()> {
    match (run.failure(), end) {
        (Some(error), _) => Err(error),
        (None, RunEnd::Reached) => Ok(()),
        (None, end) => Err(Error::input(format!("the attractor's motion ended, {}", end.why()))),
    }
}
