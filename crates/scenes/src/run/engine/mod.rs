//! What the tasks of a scene ask of an engine: its systems, their orbits, and orbits over a parameter.
//!
//! A task asks an [`Engine`] and never a type of one; [`by_engine!`] is where the choice is made. `one`
//! answers for oscillators of one degree of freedom, `many` for machines. Not here: what a report shows of
//! the answers (`columns`). Errors everywhere: a system that is not defined, a search's or a file's, an
//! interruption.

mod many;
mod one;

pub(crate) use many::Machines;
pub use many::{MachineSource, form};
pub use one::OscillatorSource;
pub(crate) use one::Oscillators;
pub(crate) use one::ResonantBirth;

use num_rational::BigRational;
use serde::{Serialize, de::DeserializeOwned};

use super::{
    Analysed, GrazingMap, Job, Judgement, Keeper, Measures, ProofRow, SectionFindings, SimulationFindings,
    StartNumbers, ValidateFindings,
    range::{SideRange, WantedProofs},
    rest::RestsHere,
};
use crate::{
    attractor::{
        basins::BasinGrid, cycle::Cycle, detection::Detection, diagram::Look, dynamics::Dynamics,
        observe::Attraction, swing::Swing, touch::Seen,
    },
    continuation::{
        Bifurcation, FollowedOrbit, Label, LocalMap, Located, NoForm, NormalForm, OrbitBranch, OrbitSearch,
        PatternFamily, PatternOf, SearchReach,
    },
    error::{Error, Result},
    many::{
        Machine,
        grazing::{LinearTouch, LinearTouches, touches},
    },
    pattern::{Map, Report},
    scene::{
        BasinsTask, SectionTask,
        branches::{BranchStart, BranchTask},
        orbits::{GrazingTask, OrbitKeys},
        rest::RestTask,
        simulate::{SimulateTask, Start},
        tolerated::ToleratedMachines,
        validate::ValidateTask,
    },
    search::{
        Accepted,
        orbit::{ProvedBranch, Verdict},
    },
};

/// Calls the rest with the engine that the job's scene is for.
macro_rules! by_engine {
    ($job:expr, $engine:ident => $ask:expr) => {
        match &$job.model {
            $crate::run::Model::Oscillator(system) => {
                let $engine = $crate::run::engine::Oscillators { job: $job, system };
                $ask
            }
            $crate::run::Model::Machine(machine) => {
                let $engine = $crate::run::engine::Machines { job: $job, machine };
                $ask
            }
        }
    };
}
pub(crate) use by_engine;

/// An orbit, judged: what is asked of it beside its numbers.
pub trait JudgedOrbit: FollowedOrbit {
    /// Whether all multipliers are inside the unit circle; marginal at a bifurcation at which one or two are
    /// on it.
    fn stable(&self, at: Option<Bifurcation>) -> Judgement;
}

/// What a normal form comes to.
pub(crate) type Form = std::result::Result<NormalForm, NoForm>;

/// What is known of an orbit and of the event at it.
pub struct AnalysedEvent {
    /// The orbit.
    pub(crate) orbit: Analysed,
    /// The normal form of an event over one parameter.
    pub(crate) form: Option<Form>,
}

/// Where an orbit touches a stop as it grazes, with its local map where that is known.
pub struct Grazed {
    /// The parameter there.
    pub(crate) parameter: f64,
    /// The stop.
    pub(crate) stop: String,
    /// The phase, as a fraction of the period.
    pub(crate) phase: f64,
    /// The second derivative of the gap, in the scene's units.
    pub(crate) acceleration: f64,
    /// The region of the plane of (a₁, a₂).
    pub(crate) region: Option<String>,
    /// γ and e.
    pub(crate) map: Option<[f64; 2]>,
    /// Whether it is an orbit but for the tangency, as far as that is known.
    pub(crate) sound: bool,
    /// What is left of the equations.
    pub(crate) residual: f64,
}

impl AnalysedEvent {
    /// The normal form's coefficient, and what it means or why there is none.
    pub fn form(form: Option<Form>) -> (Option<f64>, Option<&'static str>) {
        match form {
            None => (None, None),
            Some(Ok(form)) => (Some(form.coefficient), Some(form.name())),
            Some(Err(why)) => (None, Some(why)),
        }
    }
}

/// Branches, and what became of every start.
pub(crate) type Branches<O> = (Vec<OrbitBranch<O>>, Vec<super::StartRow>);

/// An engine at work on a job.
pub(crate) trait Engine {
    /// A periodic orbit.
    type Orbit: JudgedOrbit;
    /// A system of the scene, ready to be asked for orbits.
    type System;
    /// The scene's systems over a parameter.
    type Family;
    /// The orbits of these.
    type Source<'f>: OrbitSource<Orbit = Self::Orbit>
    where
        Self: 'f;
    /// A grazing bifurcation.
    type Grazing<'f>: GrazingPoint<Start = <Self::Dynamics as Dynamics>::Start>
    where
        Self: 'f;

    /// Its motions, of which is told what they lead to.
    type Dynamics: Attraction<Start: Serialize + DeserializeOwned>;
    /// States that motions start from.
    type States: Sync;

    /// The states of a task.
    fn states(&self, starts: &[Start]) -> Result<Self::States>;

    /// The same as its motions start from them.
    fn begun(&self, states: &Self::States) -> Vec<<Self::Dynamics as Dynamics>::Start>;

    /// The motions of the scene's system, with another value of a parameter if there is one, seen in a plane.
    fn dynamics(
        &self,
        states: &Self::States,
        change: Option<(&str, f64)>,
        plane: &[String],
    ) -> Result<Self::Dynamics>;

    /// What the two numbers of a point are, of an engine whose scenes say it.
    fn plane(&self, plane: &[String]) -> Option<[String; 2]>;

    /// The minimum depth, and the size of motions if the engine knows it.
    fn extents(&self, dynamics: &Self::Dynamics) -> (f64, Option<f64>);

    /// The starts of a grid of basins.
    fn start_plane(
        &self,
        task: &BasinsTask,
        grid: &BasinGrid,
        phase: f64,
    ) -> Result<StartPlane<Self::Dynamics>>;

    /// Adds to a section what it has besides attractors.
    fn further_orbits(
        &self,
        task: &SectionTask,
        dynamics: &Self::Dynamics,
        cycles: &[(usize, Cycle<<Self::Dynamics as Dynamics>::Point>)],
        found: &mut SectionFindings,
    ) -> Result<()>;

    /// How often the motion from a start passes each of the scene's thresholds in a forcing period, up and
    /// down: the mean over so many, or over what the motion lasts.
    fn crossings(&self, _: &<Self::Dynamics as Dynamics>::Start, _: u32) -> Result<Vec<(String, [f64; 2])>> {
        Ok(Vec::new())
    }

    /// A state as a scene has it.
    fn numbers(&self, start: &<Self::Dynamics as Dynamics>::Start) -> StartNumbers;

    /// Follows the motion of a task.
    fn simulate(&self, task: &SimulateTask, keeper: &mut dyn Keeper) -> Result<SimulationFindings>;

    /// The periodic motions that rest, of the scene's system with another value of a parameter if there is
    /// one.
    fn rests(&self, task: &RestTask, change: Option<(&str, f64)>) -> Result<RestsHere>;

    /// The scene as a machine at a value of the family's parameter, and the derivatives of its coefficients.
    /// What is cubic of an oscillator is left out.
    fn machines(&self, family: &Self::Family, value: f64) -> Result<[Machine<f64>; 2]>;

    /// The same where the motion without impacts is linear; none where it is not.
    fn linear(&self, family: &Self::Family, value: f64) -> Result<Option<[Machine<f64>; 2]>>;

    /// The coefficient of the displacement cubed at a value of the family's parameter.
    fn cubic(&self, family: &Self::Family, value: f64) -> Result<f64>;

    /// How each coordinate, and the gap of each stop, goes at a value of a parameter, in the motion from a
    /// start: for so many periods, with the harmonic k; none where the motion ends before.
    fn swings(
        &self,
        states: &Self::States,
        change: (&str, f64),
        start: &<Self::Dynamics as Dynamics>::Start,
        round: [u32; 2],
    ) -> Result<Option<Vec<Swing>>>;

    /// The scene's period, with another value of a parameter if there is one.
    fn unit_of_time(&self, change: Option<(&str, f64)>) -> Result<f64>;

    /// The system of the scene, with another value of a parameter if there is one.
    fn system(&self, change: Option<(&str, f64)>) -> Result<Self::System>;

    /// The orbits of the keys: the one that Newton's method finds from `start`, or those of a search.
    fn orbits(&self, keys: &OrbitKeys, system: &Self::System) -> Result<OrbitSearch<Self::Orbit>>;

    /// What is known of an orbit of a system.
    fn analysed(&self, orbit: &Self::Orbit, system: &Self::System) -> Analysed;

    /// The systems over a parameter.
    fn family(&self, parameter: &str) -> Result<Self::Family>;

    /// The orbits of a family.
    fn source<'f>(&'f self, family: &'f Self::Family) -> Result<Self::Source<'f>>;

    /// The scene's own value of a parameter.
    fn value(family: &Self::Family) -> f64;

    /// The nearest grazing of the task; the inner error is why there is none.
    fn grazing<'f>(
        &'f self,
        task: &'f GrazingTask,
        family: &'f Self::Family,
    ) -> Result<std::result::Result<Self::Grazing<'f>, String>>;

    /// The periodic orbit of a system on which the motion from a start settles.
    fn attracting(
        &self,
        system: &Self::System,
        from: &<Self::Dynamics as Dynamics>::Start,
        detection: &Detection,
    ) -> Result<Self::Orbit>;

    /// A state on an orbit of a system: just after its first impact, or at phase 0.
    fn on_orbit(
        &self,
        orbit: &Self::Orbit,
        system: &Self::System,
    ) -> Result<<Self::Dynamics as Dynamics>::Start>;

    /// What proves orbits of the scene's system, with another value of a parameter if there is one, in balls
    /// of so many bits where the engine works with balls; the inner error is why none can be proved.
    fn prover(
        &self,
        change: Option<(&str, &BigRational)>,
        bits: u32,
    ) -> Result<std::result::Result<impl Prover<Self::Orbit>, String>>;

    /// What proves orbits of the scene's systems over ranges of a parameter.
    fn range_prover<'e>(
        &'e self,
        parameter: &'e str,
        bits: u32,
    ) -> Result<Box<dyn RangeProver<Self::Orbit> + 'e>>;

    /// Proves each orbit of the task over a range of a parameter.
    fn prove_branches(
        &self,
        task: &ValidateTask,
        parameter: &str,
        found: &mut ValidateFindings,
    ) -> Result<()>;

    /// Proves the event nearest to each admissible orbit of the task.
    fn prove_events(
        &self,
        task: &ValidateTask,
        event: Bifurcation,
        parameter: &str,
        found: &mut ValidateFindings,
    ) -> Result<()>;
}

/// The touches of the motion without impacts, of a scene that is linear without them; none of another, and
/// where that motion is not known at the scene's own value.
///
/// # Errors
/// An interruption.
pub(crate) fn linear_touches<E: Engine>(
    engine: &E,
    family: &E::Family,
    within: Option<[f64; 2]>,
    job: &Job,
) -> Result<Option<LinearTouches>> {
    let start = E::value(family);
    if !matches!(engine.linear(family, start), Ok(Some(_))) {
        return Ok(None);
    }
    let machines = |value: f64| {
        let linear = engine.linear(family, value)?;
        linear.ok_or_else(|| Error::input(format!("the motion is not linear at {value:?}")))
    };
    match touches(&machines, start, within, &mut || job.check()) {
        Err(error) if error.is_interrupted() => Err(error),
        found => Ok(found.ok()),
    }
}

/// That there is no orbit to begin with, and where to look: at the touch of the motion without impacts, if
/// it is known. Of one overdamped coordinate all is born beyond it: with real eigenvalues and γ > 0 no γu_n
/// is negative.
///
/// # Errors
/// An interruption.
pub(crate) fn no_orbit<E: Engine>(engine: &E, family: &E::Family, name: &str, job: &Job) -> Result<String> {
    let mut said = format!("no admissible orbit to begin with at {name} = {}", E::value(family));
    let touches = linear_touches(engine, family, None, job)?;
    if let Some(LinearTouch { parameter, rate, stop, .. }) =
        touches.and_then(|all| all.found.into_iter().next())
    {
        said += &format!(
            "; the motion without impacts touches stop {stop} at {name} = {parameter}, where orbits with impacts are born"
        );
        let [c, m, k] = match engine.linear(family, parameter) {
            Ok(Some([Machine { size: 1, damping, mass, stiffness, stops, .. }, _])) if stops.len() == 1 => {
                [damping, mass, stiffness].map(|all| all.iter().map(|entry| entry.2).sum::<f64>())
            }
            _ => [0.0; 3],
        };
        if k > 0.0 && c * c > 4.0 * k * m {
            let side = if rate < 0.0 { ">" } else { "<" };
            said += &format!(": of this overdamped machine all of them for {name} {side} {parameter}");
        }
    }
    Ok(said)
}

/// Those that a task asks for, at least one, or why there are none; nothing where they are not known at
/// all.
///
/// # Errors
/// An interruption; `within` of a motion that is not linear.
pub(crate) fn asked_touches<E: Engine>(
    engine: &E,
    family: &E::Family,
    task: &GrazingTask,
    job: &Job,
) -> Result<Option<std::result::Result<LinearTouches, String>>> {
    let all = match task.is_of_free_motion() {
        true => linear_touches(engine, family, task.within(), job)?,
        false => None,
    };
    match all {
        Some(all) if all.found.is_empty() => {
            let open = all.open().map_or_else(String::new, |open| format!("; {open}"));
            Ok(Some(Err(format!("{}{open}", all.why))))
        }
        Some(all) => Ok(Some(Ok(all))),
        None if task.within.is_empty() => Ok(None),
        None => Err(Error::input(
            "`within` is for a motion without impacts that is linear and known at the parameter's own value; `reach` says how \
             far another is followed",
        )),
    }
}

/// The start of a system with two numbers in the plane.
pub(crate) type StartAt<D> = Box<dyn Fn(&D, [f64; 2]) -> <D as Dynamics>::Start + Sync>;

/// The starts of a grid.
pub(crate) struct StartPlane<D: Dynamics> {
    pub dynamics: D,
    /// The start with two numbers in the plane.
    pub place: StartAt<D>,
    /// What the two numbers are, if the scene names it.
    pub plane: Option<[String; 2]>,
    /// All that tells these starts from others of the scene, as text.
    pub identity: String,
    pub minimum_depth: f64,
    /// How large motions are, as far as the grid or the machine tells; infinite where they do not.
    pub size: f64,
}

/// Why a motion without impacts is not proved.
const SEVERAL_PERIODS: &str = "of motions without impacts the one that comes back after one period is proved";

/// What proves orbits of one system.
pub(crate) trait Prover<O> {
    /// What is proved of the orbit near an approximation.
    fn prove(&self, approximation: &O) -> Result<Proof>;
}

/// What proves orbits over ranges of a parameter.
pub(crate) trait RangeProver<O> {
    /// What is proved of the orbit near an approximation at a value, over a range that holds the value.
    fn prove(
        &self,
        approximation: &O,
        at: &BigRational,
        over: [BigRational; 2],
    ) -> Result<Verdict<ProvedBranch>>;

    /// Whether an approximation at a value of the parameter is of the orbit that is proved there, as nearly
    /// as floats tell.
    fn holds(&self, proof: &ProvedBranch, approximation: &O, at: f64) -> bool;
}

/// What was proved, and if so the certificate.
pub(crate) struct Proof {
    pub(crate) row: ProofRow,
    pub(crate) certificate: Option<Accepted>,
}

/// The orbits of a scene over a parameter.
pub trait OrbitSource {
    /// A periodic orbit.
    type Orbit: JudgedOrbit;
    /// Their equations.
    type Family: PatternFamily<Orbit = Self::Orbit> + ?Sized;

    /// Their equations.
    fn family(&self) -> &Self::Family;

    /// The scene's own value of the parameter.
    fn value(&self) -> f64;

    /// The admissible orbits of the keys at the scene's own value.
    ///
    /// # Errors
    /// Why there are none, or an interruption.
    fn present(&self, keys: &OrbitKeys) -> Result<Vec<Self::Orbit>>;

    /// The admissible orbits that a start means, at a value of the parameter.
    ///
    /// # Errors
    /// Why there are none, or an interruption.
    fn orbits(&self, start: &BranchStart, at: f64) -> Result<Vec<Self::Orbit>>;

    /// How far to look along the branch of each of some orbits.
    ///
    /// # Errors
    /// Where the family is not defined.
    fn reaches(&self, reach: Option<f64>, orbits: &[Self::Orbit]) -> Result<Vec<SearchReach>>;

    /// What is known of an orbit at these values of parameters, and of an event there.
    ///
    /// # Errors
    /// Where the family is not defined.
    fn analysed(
        &self,
        orbit: &Self::Orbit,
        at: &[(&str, f64)],
        event: Option<Bifurcation>,
    ) -> Result<AnalysedEvent>;

    /// What monitors ask of an orbit at these values of parameters, with the extents of coordinates if asked
    /// for.
    ///
    /// # Errors
    /// Where the family is not defined, or the orbit cannot be followed.
    fn measure(&self, orbit: &Self::Orbit, at: &[(&str, f64)], is_far: bool) -> Result<Measures>;

    /// Pattern and speeds of an orbit at the scene's own value.
    fn named_with_speeds(&self, orbit: &Self::Orbit) -> (String, Vec<f64>);

    /// How the orbit at a located grazing touches its stop; none if no least gap of it is known.
    ///
    /// # Errors
    /// Where the system is not defined, or det(I − A) = 0.
    fn grazed(&self, at: &Located<Self::Orbit>) -> Result<Option<Grazed>>;

    /// The labels of a task's restarts, followed in two parameters.
    ///
    /// # Errors
    /// Those of the files and of the branches; an interruption.
    fn loci(&self, task: &BranchTask, second: &str) -> Result<Branches<Self::Orbit>>;

    /// A label of a branch's file.
    ///
    /// # Errors
    /// Those of `read_label_as`.
    fn label(&self, text: &str, label: &str) -> Result<Label<PatternOf<Self::Orbit>>>;

    /// How a pattern is written.
    fn named(&self, pattern: &PatternOf<Self::Orbit>) -> String;
}

/// What the velocity of the motion that touches, far from the stop, is changed by along the stop's normal, in
/// sizes of that motion per radian: other motions that may hit.
const KICKS: [f64; 4] = [-4.0, -1.0, 1.0, 4.0];

/// What the local theory says of a pattern.
pub(crate) type Theory<'m> = Box<dyn Fn(&[u64]) -> Report + 'm>;

/// A grazing bifurcation, for the task `grazing`.
pub(crate) trait GrazingPoint {
    /// A state that a motion starts from.
    type Start;

    /// What is known of the touches of a linear machine without impacts; none of another orbit.
    fn touches(&self) -> &LinearTouches;

    /// Where it is and its local map; `open` says why the local theory does not apply, if it does not.
    fn report(&self) -> GrazingMap;

    /// The map that the local theory is asked about.
    fn local(&self) -> &LocalMap;

    /// What the theory says of each pattern up to the task's period.
    fn theory<'m>(&self, map: &'m Map) -> Result<Theory<'m>>;

    /// L: the large multiplier of one round of a pattern is L (eµ)^{−m} to leading order.
    fn leading(&self, periods: &[u64], verdict: &Report) -> Option<f64>;

    /// What the task's distance is measured in if it gives none: the size of motions there.
    fn size(&self) -> Result<f64>;

    /// What attracts beside the touch, where the least gap opens with the parameter at the rate `e`.
    ///
    /// # Errors
    /// Those of the system and of [`seen`](crate::attractor::touch::seen).
    fn seen(&self, e: f64, look: &Look) -> Result<Seen<Self::Start>>;

    /// How far from the touch what is born is proved to go on, before it and beyond it, and what attracts
    /// there; the inner error is why no range is looked for.
    ///
    /// # Errors
    /// An interruption.
    fn ranges(&self, wanted: WantedProofs) -> Result<std::result::Result<Vec<SideRange>, String>>;

    /// The machines that the task's tolerances allow; the inner error is why these are not covered.
    ///
    /// # Errors
    /// Those of the scene.
    fn tolerated(&self) -> Result<std::result::Result<ToleratedMachines, String>>;

    /// What is born of one impact in n periods where the local theory is silent, at a resonance of a linear
    /// oscillator; `None` where that is not known.
    ///
    /// # Errors
    /// Those of the scene.
    fn at_resonance(&self, _: u64) -> Result<Option<ResonantBirth>> {
        Ok(None)
    }

    /// That orbit: its periods, the speed of its impact over the stop's, the parameter and how far that is
    /// beyond the touch; the inner error is why none was found.
    ///
    /// # Errors
    /// Those of the scene.
    fn orbit_at_resonance(&self, _: (u32, f64), _: f64, _: f64) -> Result<Result<Analysed>> {
        Ok(Err(Error::input("no such orbit is known")))
    }

    /// The orbit of the true system near the leading-order solution of a pattern, at a parameter `away` from
    /// the bifurcation; the inner error is why none was found.
    fn orbit(&self, periods: &[u64], verdict: &Report, parameter: f64, away: f64)
    -> Result<Result<Analysed>>;
}
