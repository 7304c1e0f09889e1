//! Grazing bifurcations of the motion without impacts of a machine, for the task `grazing`.

use std::f64::consts::{PI, TAU};

use super::{
    super::{
        super::{
            Analysed, GrazingMap, Job, Judgement, MapNumbers,
            range::{SideRange, WantedProofs},
        },
        GrazingPoint, KICKS, Theory,
    },
    analysed,
};
use crate::{
    attractor::{
        diagram::Look,
        touch::{self, Seen, Touch},
    },
    continuation::LocalMap,
    error::Result,
    many::{
        Family, Machine, State, StopLaw,
        grazing::{FreeMotion, Grazing, LinearTouches},
        orbit::{Itinerary, find_from},
        section::{PlanarMachine, PlaneAxis, Start},
        simulate::Simulator,
    },
    pattern::{Analysis, Map, Numbers, Report as Verdict},
    scene::{MachineSceneFamily, orbits::GrazingTask, tolerated::ToleratedMachines},
    search::touch::leading_impacts,
};

/// A least gap that changes over the reach by less than this, relative to the gaps' motion, does not pass
/// through 0.
const FLAT: f64 = 1e-9;

/// A grazing bifurcation of the motion without impacts of a machine.
pub(crate) struct MachineGrazingPoint<'f> {
    pub task: &'f GrazingTask,
    pub job: &'f Job<'f>,
    pub family: &'f MachineSceneFamily<'f>,
    pub event: Grazing,
    pub machine: Machine<f64>,
    /// How far it was looked for.
    pub reach: f64,
    /// What is known of the touches.
    pub touches: LinearTouches,
}

impl GrazingPoint for MachineGrazingPoint<'_> {
    type Start = Start;

    fn touches(&self) -> &LinearTouches {
        &self.touches
    }

    fn report(&self) -> GrazingMap {
        let (event, machine) = (&self.event, &self.machine);
        let phase = event.at.phase / TAU;
        GrazingMap {
            varied: self.task.parameter.clone(),
            parameter: event.parameter,
            orbit: None,
            stop: machine.stops[event.at.stop].name.clone(),
            phase: if phase < 1.0 { phase } else { 0.0 },
            map: MapNumbers::of(self.local(), machine.rate()),
            admissible: Judgement::Yes,
            residual: event.at.gap.abs(),
            half: event.half.is_some(),
            open: self.open(),
        }
    }

    fn local(&self) -> &LocalMap {
        self.event.local()
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

    /// Seen as the gap of the stop that is grazed.
    fn seen(&self, e: f64, look: &Look) -> Result<Seen<Start>> {
        let (event, stop) = (&self.event, self.event.at.stop);
        let phase = (event.at.phase + PI).rem_euclid(TAU);
        let (machine, slope) = self.family.at(event.parameter)?;
        let motion = FreeMotion::near(&machine, &slope, Some(&event.motion.state(0.0)), None)?;
        let state = motion.motion().state(phase);
        let (parameter, width) = (event.parameter, self.size()?);
        let simulator = self.job.machine_simulator(&machine, &[])?;
        let contacts = simulator.contacts();
        let kicked = |part: f64| {
            let mut state = state.clone();
            state.u.axpy(part * width / contacts.mobility(stop), contacts.push(stop), 1.0);
            state.start(machine.rate())
        };
        let others = if self.job.is_linear() { KICKS.map(kicked).to_vec() } else { Vec::new() };
        let start = state.start(machine.rate());
        let planar = |value| {
            let (machine, _): (Machine<f64>, _) = self.family.at(value)?;
            let simulator = self.job.machine_simulator(&machine, &[])?;
            PlanarMachine::new(&machine, simulator, &[PlaneAxis::Gap(stop), PlaneAxis::Rate(stop)])
        };
        let look = Look { phase, ..look.clone() };
        let slowest = event.map.eigenvalues.first().map_or(0.0, |x| x.0.hypot(x.1));
        let still = vec![0.0; start.q.len()];
        let rest = Some(Start { t: 0.0, q: still.clone(), u: still });
        let touch = Touch { parameter, e, start, rest, others, periods: 1, slowest, width };
        touch::seen(&touch, &look, planar, self.job.monitor)
    }

    fn ranges(&self, _: WantedProofs) -> Result<std::result::Result<Vec<SideRange>, String>> {
        Ok(Err("ranges are proved by the engine `one` alone".into()))
    }

    fn tolerated(&self) -> Result<std::result::Result<ToleratedMachines, String>> {
        Ok(Err("tolerances are followed by the engine `one` alone".into()))
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
        let (strikes, start) = self.event.start(&leading_impacts(verdict, periods)?, away)?;
        let near = simulator.is_smooth().then(|| self.struck(&simulator, &strikes, &start));
        let found = find_from(&simulator, &strikes, &start, near.as_ref());
        Ok(found.map(|orbit| analysed(&orbit, &machine, None)))
    }
}

impl MachineGrazingPoint<'_> {
    /// A state just after the first impact of an orbit that is born: that of the motion that grazes, struck.
    /// Where forces are formulas there may be several motions, and the impacts do not tell which is meant.
    fn struck(&self, simulator: &Simulator, pattern: &Itinerary, start: &[f64]) -> State {
        let (contacts, stop) = (simulator.contacts(), pattern.strikes()[0].place);
        let (contact, speed) = (&contacts.all()[stop], start[1]);
        let mut state = self.event.motion.state(start[0]);
        let lacks = contact.restitution_at(speed) * speed - contact.gap(&state)[1];
        state.u.axpy(lacks / contacts.mobility(stop), contacts.push(stop), 1.0);
        state
    }

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
