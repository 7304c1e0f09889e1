//! Grazing bifurcations of orbits of an oscillator, for the task `grazing`.

use super::{
    super::{
        super::{
            Analysed, GrazingMap, Job, Judgement, MapNumbers,
            range::{SideRange, WantedProofs},
        },
        GrazingPoint, KICKS, Theory,
    },
    analysed,
    ranges::ranges,
    resonance::ResonantBirth,
    turn,
};
use crate::{
    attractor::{
        diagram::Look,
        touch::{self, Seen, Touch},
    },
    continuation::LocalMap,
    error::{Error, Result},
    many::grazing::LinearTouches,
    motion::State,
    number::parse_rational,
    one::{
        grazing::Grazing,
        orbit::{Family, find},
    },
    pattern::{Graph, Map, Report as Verdict},
    scene::{Expression, Scene, SceneFamily, Tolerances, orbits::GrazingTask, tolerated::ToleratedMachines},
    search::touch::leading_impacts,
};

/// A grazing bifurcation of an oscillator's orbit.
pub(crate) struct OscillatorGrazing<'f> {
    pub task: &'f GrazingTask,
    pub job: &'f Job<'f>,
    pub family: &'f SceneFamily<'f>,
    pub event: Grazing,
    pub half: Option<LocalMap>,
    /// The pattern of the orbit that grazes.
    pub orbit: String,
    /// A state of it, half a period from the touch.
    pub far: State,
    /// Radians in the scene's unit of time, at the touch.
    pub rate: f64,
    /// What is known of the touches.
    pub touches: LinearTouches,
    /// The scene as its tolerances are asked of, and they, those of numbers that are not rational included.
    pub tolerated: (Scene, Tolerances),
}

impl OscillatorGrazing<'_> {
    /// The size of the motion there.
    pub fn unit(&self) -> Result<f64> {
        Ok(self.family.at(self.event.parameter)?.unit(&self.event.itinerary))
    }

    /// The machines that the task's tolerances allow, or why these are not covered.
    pub fn machines(&self) -> Result<std::result::Result<ToleratedMachines, String>> {
        let (scene, tolerances) = &self.tolerated;
        let (itinerary, system) = (&self.event.itinerary, scene.system()?);
        let named = |expression: &Expression| {
            let places = tolerances.0.iter().map(|(name, _)| scene.parameter(name));
            let places = places.collect::<Result<Vec<usize>>>()?;
            Ok::<_, Error>(expression.mentions(&|place| places.contains(&place)))
        };
        let not = |why: &str| Ok(Err(why.to_string()));
        if itinerary.strikes().len() != 1 || itinerary.periods() != 1 {
            return not(
                "tolerances are of machines whose motion without impacts touches; another orbit does",
            );
        }
        if system.lower.is_some() && system.upper.is_some() {
            return not("tolerances are of machines with one stop; there are two");
        }
        if !self.job.is_linear() || named(&system.cubic)? {
            return not("tolerances are of linear machines; here a force is a formula, or cubic");
        }
        // A tolerance is about the touch to 12 digits.
        let Ok(value) = parse_rational(&format!("{:.11e}", self.event.parameter)) else {
            return not("the parameter at the touch is not a number");
        };
        scene.tolerated(tolerances, (&self.task.parameter, &value))
    }
}

impl GrazingPoint for OscillatorGrazing<'_> {
    type Start = State;

    fn touches(&self) -> &LinearTouches {
        &self.touches
    }

    fn report(&self) -> GrazingMap {
        let (event, half) = (&self.event, &self.half);
        GrazingMap {
            varied: self.task.parameter.clone(),
            parameter: event.parameter,
            orbit: Some(self.orbit.clone()),
            stop: self.job.stop(event.side()),
            phase: turn(event.phase()),
            map: MapNumbers::of(self.local(), self.rate),
            admissible: match (event.second, event.admissible) {
                (Some(_), _) if half.is_none() => Judgement::Marginal,
                (Some(_), _) | (None, true) => Judgement::Yes,
                (None, false) => Judgement::No,
            },
            residual: event.residual,
            half: half.is_some(),
            open: event.second.filter(|_| half.is_none()).map(|second| {
                format!(
                    "the orbit grazes twice in its period, also at stop {}: the local theory is for one grazing",
                    self.job.stop(second.side)
                )
            }),
        }
    }

    fn local(&self) -> &LocalMap {
        self.half.as_ref().unwrap_or(&self.event.map)
    }

    fn theory<'m>(&self, map: &'m Map) -> Result<Theory<'m>> {
        let graph = Graph::new(map, self.task.max_period.into(), false)?;
        Ok(Box::new(move |periods: &[u64]| graph.judge(periods)))
    }

    fn leading(&self, periods: &[u64], _: &Verdict) -> Option<f64> {
        self.local().leading(periods)
    }

    fn size(&self) -> Result<f64> {
        self.unit()
    }

    fn seen(&self, e: f64, look: &Look) -> Result<Seen<State>> {
        let (job, name) = (self.job, self.task.parameter.as_str());
        let (parameter, width) = (self.event.parameter, self.size()?);
        let simulator = |value| job.simulator_of(&job.scene.plain(&[(name, value)])?);
        let look = Look { phase: self.far.t, ..look.clone() };
        let (re, im) = self.event.map.eigenvalues[0];
        let (periods, slowest) = (self.event.itinerary.periods(), re.hypot(im));
        // Of the motion without impacts, which has the touch for its only one.
        let is_free = self.event.itinerary.strikes().len() == 1;
        let rest = is_free.then_some(State { t: 0.0, q: 0.0, u: 0.0 });
        let kicked = |part: f64| State { u: self.far.u + part * width * self.rate, ..self.far };
        let others = if is_free && job.is_linear() { KICKS.map(kicked).to_vec() } else { Vec::new() };
        let touch = Touch { parameter, e, start: self.far, rest, others, periods, slowest, width };
        touch::seen(&touch, &look, simulator, job.monitor)
    }

    fn ranges(&self, wanted: WantedProofs) -> Result<std::result::Result<Vec<SideRange>, String>> {
        ranges(self, wanted)
    }

    fn tolerated(&self) -> Result<std::result::Result<ToleratedMachines, String>> {
        self.machines()
    }

    fn at_resonance(&self, n: u64) -> Result<Option<ResonantBirth>> {
        self.resonance(n)
    }

    fn orbit_at_resonance(
        &self,
        impact: (u32, f64),
        parameter: f64,
        distance: f64,
    ) -> Result<Result<Analysed>> {
        self.resonant_orbit(impact, parameter, distance)
    }

    fn orbit(&self, periods: &[u64], verdict: &Verdict, parameter: f64, _: f64) -> Result<Result<Analysed>> {
        let impacts = leading_impacts(verdict, periods)?;
        let (itinerary, z) = match &self.half {
            Some(map) => self.event.half_start(map, &impacts, parameter)?,
            None => self.event.start(self.family, &impacts, parameter)?,
        };
        let found = find(&self.family.at(parameter)?, &itinerary, z);
        Ok(found.map(|orbit| analysed(&orbit, self.job, None)))
    }
}
