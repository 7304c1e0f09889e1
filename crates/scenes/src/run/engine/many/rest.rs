//! Periodic motions of a machine that rest on a stop: all of them with one coordinate, with several those
//! that a search finds.

use std::f64::consts::TAU;

use super::{
    super::super::{
        Complex, Job, Judgement, RestOrbitRow,
        rest::{RestsHere, all_rests, is_rest},
    },
    SHOWN, names,
};
use crate::{
    attractor::{
        NEUTRAL,
        rest::{RestEvent, Resting, tell},
    },
    error::Result,
    many::{
        Machine, RealVector, State,
        resting::{RestCycle, RestSearch, RestsFound, search},
        simulate::Simulator,
    },
    motion::{RunEnd, Time},
    scene::rest::RestTask,
};

/// The periodic motions of a machine that rest.
///
/// # Errors
/// Where the machine is not defined; an interruption.
pub(super) fn rests(task: &RestTask, job: &Job, machine: &Machine<f64>) -> Result<RestsHere> {
    let names: Vec<String> = names(machine).into_iter().map(String::from).collect();
    if machine.size == 1 && machine.friction.is_empty() {
        let resting = RestingMachine(job.machine_simulator(machine, &[])?);
        return all_rests(&resting, &names, machine.rate(), task);
    }
    let planar = job.planar(machine, &[], &[])?;
    let RestTask { periods, starts, longest, .. } = *task;
    let found = search(&planar, &RestSearch { starts, longest, periods }, job.monitor)?;
    let orbits = found.cycles.iter().map(|cycle| row(cycle, machine, &names)).collect();
    let RestsFound { followed, failed, failure, .. } = &found;
    let unfollowed = failure.as_ref().map(|error| {
        format!("{failed} of {followed} motions were not followed to their end; the first: {error}")
    });
    Ok(RestsHere { complete: false, orbits, releases: Vec::new(), none: none(&found, task), unfollowed })
}

fn row(cycle: &RestCycle, machine: &Machine<f64>, names: &[String]) -> RestOrbitRow {
    let rate = machine.rate();
    let largest = cycle.multipliers.first().map_or(0.0, |(re, im)| re.hypot(*im));
    let clear = cycle.tangencies == 0 && cycle.rests.iter().all(|rest| is_rest(rest.length));
    RestOrbitRow {
        value: None,
        period: cycle.period,
        stops: cycle.rests.iter().map(|rest| names[rest.stop].clone()).collect(),
        released: cycle.rests.iter().map(|rest| rest.release / TAU).collect(),
        rested: cycle.rests.iter().map(|rest| rest.begin / TAU).collect(),
        held: cycle.held.iter().map(|&stop| names[stop].clone()).collect(),
        resting: cycle.resting,
        impacts: cycle.impacts,
        fastest: cycle.fastest * rate,
        stable: match largest {
            _ if !clear => Judgement::Marginal,
            size if size < 1.0 - NEUTRAL => Judgement::Yes,
            size if size > 1.0 + NEUTRAL => Judgement::No,
            _ => Judgement::Marginal,
        },
        multipliers: cycle.multipliers.iter().take(SHOWN).map(|&one| Complex::from(one)).collect(),
        q: machine.displaced(cycle.begin.q()),
        u: machine.displaced(cycle.begin.u()).into_iter().map(|u| u * rate).collect(),
    }
}

/// Why nothing was found.
fn none(found: &RestsFound, task: &RestTask) -> String {
    let RestsFound { followed, rested, .. } = found;
    let RestTask { periods, longest, .. } = task;
    format!(
        "none found: of {followed} motions followed for {periods} periods {rested} came to a rest that ended, and from none \
         Newton's method found one of up to {longest} periods; there may be others: raise starts or longest"
    )
}

/// A machine with one coordinate.
struct RestingMachine(Simulator);

impl RestingMachine {
    /// What rests on a stop.
    fn state(&self, stop: usize, t: f64) -> State {
        let contact = &self.0.contacts().all()[stop];
        let ([place, speed, _], along) = (contact.position.at(t), contact.row[0]);
        let of = |x: f64| RealVector::from_element(1, x / along);
        State { t, q: of(place), u: of(speed) }
    }
}

impl Resting for RestingMachine {
    fn stops(&self) -> usize {
        self.0.contacts().all().len()
    }

    /// Nothing rests on a stop that gives way.
    fn bend(&self, stop: usize, phase: f64) -> Result<f64> {
        let contact = &self.0.contacts().all()[stop];
        if contact.soft.is_some() {
            return Ok(f64::INFINITY);
        }
        let acceleration = self.0.acceleration(&self.state(stop, phase))?;
        Ok(contact.row.dot(&acceleration) - contact.position.at(phase)[2])
    }

    fn on(&self, stop: usize, phase: f64) -> [f64; 2] {
        let State { q, u, .. } = self.state(stop, phase);
        [q[0], u[0]]
    }

    fn order(&self) -> u32 {
        let stops = self.0.contacts().all().iter().map(|stop| stop.position.order());
        stops.fold(self.0.equations().force.order(), u32::max)
    }

    fn follow(
        &self,
        stop: usize,
        from: Time,
        until: Time,
        each: &mut dyn FnMut(RestEvent) -> bool,
    ) -> Result<RunEnd> {
        let State { q, u, .. } = self.state(stop, from.phase);
        let mut run = self.0.start(from, q.as_slice(), u.as_slice())?;
        let rigid = |stop: usize| self.0.contacts().all()[stop].soft.is_none().then_some(stop);
        let end = tell(|| run.next(until), rigid, each);
        run.failure().map_or(Ok(end), Err)
    }
}
