//! The checks of each kind of task.

use std::collections::BTreeSet;

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::{Checked, LONGEST, Model, POINTS};
use crate::{
    continuation::Bifurcation,
    error::{Error, Result},
    many::{Machine, RealVector, section::PlaneAxis},
    motion::{Harmonic, SmoothForce},
    scene::{
        branches::{BranchTask, CrisisTask, DiagramTask, MapTask},
        orbits::{EventTask, GrazingTask, OrbitTask},
        response::ResponseTask,
        rest::RestTask,
        sections::{BasinsTask, SectionTask},
        simulate::SimulateTask,
        task::Kind,
        validate::ValidateTask,
    },
    source::hint,
};

/// The highest harmonic of forces at rest that is told of formulas.
const FORMULA: u32 = 16;
/// No longer series is written: at some 50 bytes a point, 5 GB.
const MOST_POINTS: u64 = 100_000_000;
/// The default of `transient` in a task `orbit`.
const TRANSIENT: u64 = 300;

impl Checked<'_> {
    /// The checks of one task, its coefficients being those of the task.
    pub(super) fn kind(&self, kind: &Kind) -> Result<()> {
        self.once(kind)?;
        self.rubbing(kind)?;
        match kind {
            Kind::SimulateTask(task) => self.simulate(task),
            Kind::SectionTask(task) => self.section(task),
            Kind::BasinsTask(task) => self.basins(task),
            Kind::OrbitTask(task) => self.orbits(task),
            Kind::EventTask(task) => self.event(task),
            Kind::GrazingTask(task) => self.grazing(task),
            Kind::BranchTask(task) => self.branch(task),
            Kind::DiagramTask(task) => self.diagram(task),
            Kind::ResponseTask(task) => self.response(task),
            Kind::MapTask(task) => self.map(task),
            Kind::CrisisTask(task) => self.crisis(task),
            Kind::RestTask(task) => self.rest(task),
            Kind::ValidateTask(task) => self.validate(task),
            Kind::ChaosTask(task) => {
                self.only_one("kind", "works")?;
                task.check(self.scene, self.path)
            }
        }
    }

    /// A force that is recorded once: one run, from where it begins, no longer than it is.
    fn once(&self, kind: &Kind) -> Result<()> {
        let Model::Many(machine) = self.model else { return Ok(()) };
        let Some((record, _)) = &machine.record else { return Ok(()) };
        let periods = record.length() / machine.period;
        let Kind::SimulateTask(task) = kind else {
            let message = "needs a periodic force; `measured` with once = true is a record of one run, for `simulate` alone: fit \
                           `harmonics` to it instead";
            return self.fail("kind", message);
        };
        if task.transient > 0 {
            return self.fail("transient", "passes a part of a force that is recorded once: leave it out");
        }
        if !task.start.phase.is_zero() {
            let message = "is not 0, where the record of the force begins: leave it out";
            return self.fail("start.phase", message);
        }
        let asked = self.scene.span(task)?;
        if asked > periods * (1.0 + 1e-9) {
            let message =
                format!("asks for {asked} periods; the record of the force ends after {periods:.6}");
            return self.fail(if task.duration.is_some() { "duration" } else { "periods" }, &message);
        }
        Ok(())
    }

    /// With dry friction, and with forces that have kinks, motions are followed, attractors and orbits found,
    /// and branches of these over one parameter; not where friction is that of a stop. Nothing that takes a
    /// map that is smooth, or has an inverse.
    fn rubbing(&self, kind: &Kind) -> Result<()> {
        let Model::Many(machine) = self.model else { return Ok(()) };
        let friction =
            machine.friction.first().map(|first| format!("there is dry friction ({})", first.name));
        let has_friction = friction.is_some();
        let kinks = machine.kinked().map(|text| format!("a force has kinks ({text})"));
        let Some(what) = friction.or(kinks) else { return Ok(()) };
        let on_stop = machine.friction.iter().find(|friction| friction.normal.stop().is_some());
        let on_stop = on_stop.map(|friction| format!("the normal force of {} is a stop's", friction.name));
        let refused = |key: &str, what: &str| {
            let orbits = if on_stop.is_some() { "" } else { ", `orbit`, `branch` over one parameter" };
            let message = format!(
                "needs motions that are smooth between impacts; here {what}: `simulate`{orbits}, `basins`, `section` without `orbits`, \
                 `diagram` without `branches`, `response` and `rest` take it"
            );
            self.fail(key, &message)
        };
        match (kind, &on_stop) {
            (Kind::SimulateTask(_) | Kind::BasinsTask(_) | Kind::ResponseTask(_) | Kind::RestTask(_), _) => {
                Ok(())
            }
            (Kind::OrbitTask(task), Some(why)) if task.cycle.is_none() => refused("kind", why),
            (Kind::BranchTask(_), Some(why)) => refused("kind", why),
            (Kind::BranchTask(task), _) if task.second.is_some() && has_friction => refused("second", &what),
            (Kind::DiagramTask(task), Some(why)) if !task.branches.is_empty() => refused("branches", why),
            (Kind::OrbitTask(_) | Kind::BranchTask(_) | Kind::DiagramTask(_), _) => Ok(()),
            (Kind::SectionTask(task), _) if task.orbits.is_empty() => Ok(()),
            (Kind::SectionTask(_), _) => refused("orbits", &what),
            _ => refused("kind", &what),
        }
    }

    fn simulate(&self, task: &SimulateTask) -> Result<()> {
        let key = if task.duration.is_some() { "duration" } else { "periods" };
        if task.duration.is_some() && self.scene.has(&self.key("periods")) {
            return self.fail("duration", "stands beside `periods`: give one of them");
        }
        if task.periods == 0 {
            return self.fail("periods", "is 0; a motion is followed for at least 1");
        }
        let (span, samples) = (self.scene.span(task)?, task.samples);
        if span.is_nan() || span <= 0.0 {
            return self.fail(key, "is not positive: a motion is followed for some time");
        }
        let points = span * f64::from(samples);
        if points > MOST_POINTS as f64 {
            return self.fail(
                key,
                &format!(
                    "with samples = {samples} makes a series of {points:.0} points, more than {MOST_POINTS}: take fewer samples or \
                     periods"
                ),
            );
        }
        self.within("samples", samples, 1, 10_000)?;
        self.start(&task.start, "start")
    }

    fn section(&self, task: &SectionTask) -> Result<()> {
        if task.starts.is_empty() {
            return self.fail("starts", "is empty; a motion must start somewhere");
        }
        self.within("points", task.points, 1, POINTS)?;
        self.within("longest", task.longest, 1, LONGEST)?;
        let dimension = match self.model {
            Model::One(_) => 2,
            Model::Many(machine) => u32::try_from(2 * machine.size).unwrap_or(u32::MAX),
        };
        self.within("exponents", task.exponents, 1, dimension)?;
        self.plane(&task.plane)?;
        for (i, start) in (1..).zip(&task.starts) {
            self.start(start, &format!("starts[{i}]"))?;
        }
        self.frame(task.frame)?;
        if let (Model::One(system), Some(side)) = (self.model, task.frame.side())
            && system.wall(side).is_none()
        {
            return self.fail("frame", &format!("there is no {} {}", side.name(), self.scene.format.stop()));
        }
        for (i, orbit) in (1..).zip(&task.orbits) {
            self.orbit(orbit, &format!("orbits[{i}]"))?;
        }
        for (key, asked) in [("manifolds", task.manifolds), ("grazing_curve", task.grazing_curve)] {
            if asked {
                self.only_one(key, "is drawn")?;
            }
        }
        Ok(())
    }

    fn basins(&self, task: &BasinsTask) -> Result<()> {
        let scene = self.scene;
        if let Model::One(_) = self.model {
            scene.start_plane(&task.plane, &self.key("plane"))?;
            if let Some(start) = &task.start {
                if task.plane.is_empty() {
                    return self.fail("start", "goes with a plane: here q and u say all, leave it out");
                }
                scene.state(start)?;
            }
        }
        if task.start.as_ref().is_some_and(|start| !start.phase.is_zero()) {
            let message = "is given by the task's own phase, when all motions start: leave it out here";
            return self.fail("start.phase", message);
        }
        for (range, name) in [(&task.q, "q"), (&task.u, "u")] {
            self.within(&format!("{name}.count"), range.count, 2, 4000)?;
            scene.number(&range.from)?;
            scene.number(&range.to)?;
        }
        self.within("longest", task.longest, 1, LONGEST)?;
        match self.model {
            Model::One(_) => Ok(()),
            Model::Many(machine) => self.machine_basins(task, machine),
        }
    }

    fn machine_basins(&self, task: &BasinsTask, machine: &Machine<f64>) -> Result<()> {
        let axes = self.scene.plane(&task.plane, machine, &self.key("plane"))?;
        if axes.iter().any(|axis| matches!(axis, PlaneAxis::Gap(_) | PlaneAxis::Rate(_))) {
            let message =
                "has a gap; starts are given by displacements and velocities, as in [\"q1\", \"u2\"]";
            return self.fail("plane", message);
        }
        let rest = self.scene.rest(&task.start, machine)?;
        let ones = RealVector::from_element(machine.points(), 1.0);
        let wrong = |error: Error| self.scene.fail(&self.key("plane"), &error.to_string());
        machine.coordinates(&ones).map_err(wrong)?;
        machine.coordinates(&RealVector::from_vec(rest[0].clone())).map(drop).map_err(wrong)
    }

    fn orbits(&self, task: &OrbitTask) -> Result<()> {
        self.orbit(&task.orbit, "orbit")?;
        if let Some(start) = &task.cycle {
            self.start(start, "cycle")?;
            let orbit = &task.orbit;
            if !(orbit.pattern.is_empty() && orbit.start.is_empty() && orbit.period == 1) {
                return self.fail("orbit", "beside `cycle` nothing else is looked for: give one of them");
            }
        } else if task.transient != TRANSIENT {
            return self.fail("transient", "is of a limit cycle: give `cycle` with it");
        }
        self.values(task.parameter.as_deref(), &task.values)
    }

    /// The values of a parameter, or neither.
    fn values(&self, parameter: Option<&str>, values: &[BigRational]) -> Result<()> {
        if let Some(parameter) = parameter {
            self.parameter(parameter)?;
        }
        if parameter.is_some() == values.is_empty() {
            let message = "parameter and values belong together: give both or neither";
            return Err(self.scene.fail(self.path, message));
        }
        Ok(())
    }

    fn event(&self, task: &EventTask) -> Result<()> {
        self.parameter(&task.parameter)?;
        self.reach(task.reach, &task.options)?;
        self.stops()?;
        self.orbit(&task.orbit, "orbit")
    }

    fn grazing(&self, task: &GrazingTask) -> Result<()> {
        self.parameter(&task.parameter)?;
        self.reach(task.reach, &task.options)?;
        self.within("max_period", task.max_period, 1, 12)?;
        self.positive("distance", task.distance.as_slice())?;
        if !task.within.is_empty() {
            self.range(("parameter", &task.parameter), ("within", &task.within))?;
            if !task.is_of_free_motion() {
                return self.fail("within", "is for the motion without impacts, and goes without `reach`");
            }
        }
        self.stops()?;
        self.scene.check_tolerances(&task.tolerance, &task.parameter, &self.key("tolerance"))?;
        if task.prove {
            if task.seen == Some(false) {
                return self.fail("prove", "proves what is seen, which `seen = false` leaves out");
            }
            self.provable("prove")?;
        }
        match self.model {
            Model::Many(_) if !task.orbit.pattern.is_empty() || task.orbit.period != 1 => {
                let what = "orbits other than the motion without impacts are followed to their grazing";
                self.fail("orbit", &self.scene.only_one(what))
            }
            _ => self.orbit(&task.orbit, "orbit"),
        }
    }

    fn branch(&self, task: &BranchTask) -> Result<()> {
        // Friction alone, or a force that is a formula, makes a motion worth following, too.
        if !matches!(self.model, Model::Many(machine) if !machine.friction.is_empty() || machine.is_smooth())
        {
            self.stops()?;
        }
        self.frame(task.frame)?;
        self.branch_starts(&task.starts, "starts")?;
        self.range(("parameter", &task.parameter), ("range", &task.range))?;
        if task.starts.is_empty() {
            return self.fail("starts", "is empty; a branch must start somewhere");
        }
        for (i, at) in
            (1..).zip(&task.starts).filter_map(|(i, start)| Some((i, start.at.as_ref()?.to_f64()?)))
        {
            let (low, high) = (task.range[0], task.range[1]);
            if !(low..=high).contains(&at) {
                let message = format!("is not in the range from {low} to {high}");
                return self.fail(&format!("starts[{i}].at"), &message);
            }
        }
        if task.second.is_none() && self.scene.has(&self.key("second_range")) {
            return self.fail("second_range", "is of a second parameter: give `second`, or leave it out");
        }
        if let Some(second) = &task.second {
            self.range(("second", second), ("second_range", &task.second_range))?;
            if second == &task.parameter || task.starts.iter().any(|start| start.restart.is_none()) {
                return self.fail(
                    "second",
                    "must be another parameter, and every start a restart at the label of what is followed",
                );
            }
        }
        if !(task.drawn == 0 || (2..=100).contains(&task.drawn)) {
            return self.fail("drawn", "is outside 2 to 100 (0 draws none)");
        }
        if task.drawn > 0 && task.second.is_some() {
            return self.fail("drawn", "stands beside `second`: orbits are drawn along one parameter");
        }
        let names: Vec<&str> = task.monitors.0.iter().map(|monitor| monitor.name.as_str()).collect();
        let held = task.hold.0.iter().map(|held| ("hold", &held.0));
        for (key, name) in task.levels.0.iter().map(|level| ("levels", &level.0)).chain(held) {
            if !names.contains(&name.as_str()) {
                let hint = hint(name, names.iter().copied());
                return self.fail(key, &format!("there is no monitor {name:?} in the task; {hint}"));
            }
        }
        if !task.hold.0.is_empty() && (task.second.is_none() || task.hold.0.len() > 1) {
            return self
                .fail("hold", "holds one monitor at one value while two parameters move: give `second`");
        }
        if task.prove {
            if task.second.is_some() {
                return self.fail("prove", "proves orbits over one parameter: leave it or `second` out");
            }
            self.only_one("prove", "works")?;
            self.provable("prove")?;
        }
        self.options(&task.options)
    }

    fn diagram(&self, task: &DiagramTask) -> Result<()> {
        self.range(("parameter", &task.parameter), ("range", &task.range))?;
        self.branch_starts(&task.branches, "branches")?;
        self.plane(&task.plane)?;
        self.within("count", task.count, 2, 1_000_000)?;
        self.within("points", task.points, 2, 1_000_000)?;
        self.within("longest", task.longest, 1, 10_000)?;
        self.within("every", task.every, 1, task.points)?;
        if task.starts.is_empty() {
            return self.fail("starts", "is empty; a motion must start somewhere");
        }
        if task.sweep.is_some() && task.starts.len() > 1 {
            return self.fail(
                "starts",
                "has several; a sweep follows one motion: give one start, or a task for each",
            );
        }
        if task.prove {
            self.provable("prove")?;
        }
        for (i, start) in (1..).zip(&task.starts) {
            match self.model {
                Model::One(_) => self.scene.state(start).map(drop)?,
                Model::Many(machine) => {
                    self.scene.machine_state(start, machine, &self.key(&format!("starts[{i}]"))).map(drop)?;
                }
            }
        }
        self.frame(task.frame)?;
        self.options(&task.options)
    }

    fn response(&self, task: &ResponseTask) -> Result<()> {
        self.range(("parameter", &task.parameter), ("range", &task.range))?;
        self.within("count", task.count, 3, 1_000_000)?;
        self.within("points", task.points, 2, 1_000_000)?;
        self.within("longest", task.longest, 1, 10_000)?;
        let (driven, told) = self.drive();
        if !told && !driven.contains(&task.harmonic) {
            let known: Vec<String> = driven.iter().map(u32::to_string).collect();
            // The free machine swings without one.
            if known.is_empty() && task.backbone && task.seen != Some(true) {
                return self.backbone(task);
            }
            let message = match &known[..] {
                [] => "has no drive to respond to: give `forcing`, a formula in t, or a stop or surface that moves".to_string(),
                all => format!("is not in the drive, which has {}", all.join(", ")),
            };
            return self.fail(if known.is_empty() { "kind" } else { "harmonic" }, &message);
        }
        if told && task.harmonic > FORMULA && !driven.contains(&task.harmonic) {
            let message = format!("is looked for in formulas in t up to {FORMULA}: give it as `forcing`");
            return self.fail("harmonic", &message);
        }
        self.backbone(task)?;
        if task.seen == Some(false) {
            return Ok(());
        }
        self.start(&task.start, "start")
    }

    fn backbone(&self, task: &ResponseTask) -> Result<()> {
        let why = match self.model {
            Model::One(system) => Machine::of_oscillator(system, ["lower", "upper"], 1.0).no_backbone(),
            Model::Many(machine) => machine.no_backbone(),
        };
        why.filter(|_| task.backbone).map_or(Ok(()), |why| self.fail("backbone", why))
    }

    /// The harmonics of all that drives the system, and whether a formula may have more.
    fn drive(&self) -> (BTreeSet<u32>, bool) {
        let of = |all: &[Harmonic<f64>]| all.iter().map(|h| h.k).collect::<Vec<_>>();
        let timed = |force: &SmoothForce<f64>, time: usize| force.formula.mentions(&|place| place == time);
        match self.model {
            Model::One(system) => {
                let walls = [&system.lower, &system.upper].into_iter().flatten();
                let moved = walls.flat_map(|wall| of(&wall.harmonics));
                let told = system.smooth.as_ref().is_some_and(|force| timed(force, 2));
                (of(&system.forcing).into_iter().chain(moved).collect(), told)
            }
            Model::Many(machine) => {
                let stops = machine.stops.iter().flat_map(|stop| of(&stop.wall.harmonics));
                let surfaces = machine.friction.iter().flat_map(|friction| of(&friction.harmonics));
                let forced = machine.forcing.iter().map(|load| load.k);
                let told = machine.smooth.iter().flatten().any(|force| timed(force, 2 * machine.points()));
                (forced.chain(stops).chain(surfaces).collect(), told)
            }
        }
    }

    fn map(&self, task: &MapTask) -> Result<()> {
        self.only_one("kind", "works")?;
        self.range(("parameter", &task.parameter), ("range", &task.range))?;
        self.range(("second", &task.second), ("second_range", &task.second_range))?;
        if task.second == task.parameter {
            return self.fail("second", "must be another parameter");
        }
        self.within("count", task.count, 2, 4000)?;
        self.within("second_count", task.second_count, 2, 4000)?;
        self.within("longest", task.longest, 1, LONGEST)?;
        self.within("points", task.points, 3 * task.longest.min(LONGEST), POINTS)
    }

    fn crisis(&self, task: &CrisisTask) -> Result<()> {
        self.only_one("kind", "works")?;
        self.range(("parameter", &task.parameter), ("bracket", &task.bracket))?;
        self.positive("offsets", &task.offsets)?;
        self.positive("margins", &task.margins)?;
        if task.margins.is_empty() {
            return self.fail("margins", "is empty; motions on both sides are simulated");
        }
        for (key, value) in [("images", task.images.into()), ("periods", task.periods), ("quiet", task.quiet)]
        {
            if value == 0 {
                return self.fail(key, "must be at least 1");
            }
        }
        self.orbit(&task.orbit, "orbit")
    }

    fn rest(&self, task: &RestTask) -> Result<()> {
        let rigid = match self.model {
            Model::One(system) => system.lower.is_some() || system.upper.is_some(),
            Model::Many(machine) => machine.stops.iter().any(|stop| stop.law.is_rigid()),
        };
        if !rigid {
            return self.fail("kind", "needs a rigid stop to rest on, one with a restitution; there is none");
        }
        self.within("periods", task.periods, 1, 100_000)?;
        self.within("starts", task.starts, 1, 100_000)?;
        self.within("longest", task.longest, 1, 100)?;
        self.values(task.parameter.as_deref(), &task.values)
    }

    fn validate(&self, task: &ValidateTask) -> Result<()> {
        self.orbit(&task.orbit, "orbit")?;
        self.provable("kind")?;
        match self.model {
            Model::One(_) => self.proof(task),
            Model::Many(_) => self.machine_proof(task),
        }
    }

    /// Whether orbits of the model can be proved at all. Linear oscillators, and linear machines between
    /// rigid stops of constant restitution.
    fn provable(&self, key: &str) -> Result<()> {
        let machine = match self.model {
            Model::One(system) if system.cubic != 0.0 => {
                let message = "proves orbits of linear systems only: cubic must be 0";
                return self.fail(key, message);
            }
            Model::One(system) if system.smooth.is_some() => {
                let message = "depends on q, u or t, and only orbits of linear systems are proved; if the force is linear, \
                               write it as damping, stiffness and forcing";
                return Err(self.scene.fail("system.force", message));
            }
            Model::One(_) => return Ok(()),
            Model::Many(machine) => machine,
        };
        if machine.is_smooth() {
            let message =
                "proves orbits of linear machines; a `force` of this one is a formula in its motion";
            return self.fail(key, message);
        }
        if let Some(stop) = machine.stops.iter().find(|stop| !stop.law.is_newton()) {
            let name = &stop.name;
            let message =
                format!("proves orbits between rigid stops of constant restitution; stop {name} is another");
            return self.fail(key, &message);
        }
        Ok(())
    }

    fn proof(&self, task: &ValidateTask) -> Result<()> {
        let scene = self.scene;
        let search = ["reach", "options"].into_iter().find(|key| scene.has(&self.key(key)));
        if let Some(key) = search.filter(|_| task.event.is_none()) {
            return self.fail(key, "is of the search for an `event`: give one, or leave it out");
        }
        if task.orbit.pattern.is_empty()
            && (task.event != Some(Bifurcation::Grazing) || task.orbit.period != 1)
        {
            let message = "must have an impact to be validated; without one, only a grazing is, of period 1";
            return self.fail("orbit.pattern", message);
        }
        if !(64..=4096).contains(&task.bits) {
            return self.fail("bits", "must be from 64 to 4096");
        }
        self.reach(task.reach, &task.options)?;
        if let Some(event) = task.event
            && !matches!(event, Bifurcation::SaddleNode | Bifurcation::Flip | Bifurcation::Grazing)
        {
            let name = event.name();
            return self
                .fail("event", &format!("{name}: only saddle-node, flip and grazing can be validated"));
        }
        let Some(parameter) = &task.parameter else {
            return match task.event.is_some() || task.has_range() {
                true => {
                    Err(scene.fail(self.path, "has no parameter, which `event`, `from` and `to` are about"))
                }
                false => Ok(()),
            };
        };
        self.parameter(parameter)?;
        match (task.event.is_some(), task.has_range()) {
            (true, false) => Ok(()),
            (false, true) => self.proved_over(task, parameter),
            (true, true) => self.fail("event", "is proved by itself: leave `from` and `to` out"),
            (false, false) => {
                let message =
                    "varies in no way: give `from` or `to`, to prove orbits over a range, or `event`";
                self.fail("parameter", message)
            }
        }
    }

    /// The range over which orbits are proved, with the scene's value in it.
    fn proved_over(&self, task: &ValidateTask, parameter: &str) -> Result<()> {
        let scene = self.scene;
        let (_, own) = &scene.parameters[scene.parameter(parameter)?];
        let [from, to] = [&task.from, &task.to].map(|end| end.as_ref().unwrap_or(own));
        if task.orbit.pattern.is_empty() {
            return self.fail("orbit.pattern", "must have an impact to be proved over a range");
        }
        if from > own {
            return self
                .fail("from", &format!("is above the scene's {parameter}, at which the orbit is found"));
        }
        if to < own {
            return self
                .fail("to", &format!("is below the scene's {parameter}, at which the orbit is found"));
        }
        if from == to {
            return self.fail("to", "is `from`: a range has a least and a greatest value");
        }
        Ok(())
    }

    fn machine_proof(&self, task: &ValidateTask) -> Result<()> {
        let keys = [
            ("event", task.event.is_some()),
            ("from", task.from.is_some()),
            ("to", task.to.is_some()),
            ("parameter", task.parameter.is_some()),
        ];
        if let Some((key, _)) = keys.iter().find(|(_, given)| *given) {
            return self.only_one(key, "is proved");
        }
        if task.orbit.pattern.is_empty() {
            return self.fail("orbit.pattern", "must have an impact to be validated");
        }
        Ok(())
    }
}
