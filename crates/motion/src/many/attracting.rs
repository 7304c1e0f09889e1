//! From a motion to the periodic orbit that it tends to: the impact pattern read off, the orbit by Newton's
//! method.

use std::f64::consts::TAU;

use super::{
    orbit::{Itinerary, Orbit, Strike, find_from},
    section::{PlanarMachine, Start},
    simulate::{Event, Run},
};
use crate::{
    attractor::{detection::Detection, observe::Attraction},
    continuation::natural,
    error::{Error, Result},
    monitor::Monitor,
    motion::{RunEnd, Time},
};

/// The periodic orbit on which a motion settles: its impact pattern is read off the attractor that is found.
///
/// # Errors
/// An input error if it settles on none that is found, or rests on a stop; those of [`find_from`]; the
/// monitor's.
pub fn attracting(
    planar: &PlanarMachine,
    from: &Start,
    detection: &Detection,
    monitor: &dyn Monitor,
) -> Result<Orbit> {
    let (simulator, phase) = (planar.simulator(), detection.phase);
    let found = planar.fates(std::slice::from_ref(from), detection, &[], monitor)?;
    let fate = found.into_iter().next().flatten();
    let fate = fate.ok_or_else(|| Error::input("the attractor's start lies behind a stop"))?;
    let cycle = fate.periodic(detection)?;
    // At phase 0 the state of an orbit without impacts is asked for.
    let at = planar.state(&cycle.points[0].whole, phase);
    let period = cycle.period() as i64;
    let mut run = simulator.start(Time::new(0, phase), at.q.as_slice(), at.u.as_slice())?;
    // Where the state does not follow from times and speeds.
    let soft = simulator.is_pieced();
    let stops = simulator.contacts().all().len();
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
            Event::Stick(stick) if stick.place < stops => rests = true,
            Event::End(end) => break end,
            _ => {}
        }
    };
    ended(&mut run, end)?;
    if rests {
        return Err(Error::input(
            "the motion comes to rest on a stop: orbits with rests are not followed; a task `rest` finds them",
        ));
    }
    let turned = |time: &Time| {
        let turns = (time.phase / TAU).floor();
        (time.period + turns as i64, time.phase - turns * TAU)
    };
    let times: Vec<(i64, f64)> = impacts.iter().map(|(_, time, _)| turned(time)).collect();
    let counted = natural(&times, period as u32);
    let strikes = impacts.iter().zip(&counted).map(|(hit, &(periods, _))| Strike { place: hit.0, periods });
    let strikes: Vec<Strike> = strikes.collect();
    if strikes.is_empty() {
        let pattern = Itinerary::free(period as u32)?;
        let end = run.finish(Time::new(period + 1, 0.0));
        ended(&mut run, end)?;
        return find_from(simulator, &pattern, &[], Some(&run.state()));
    }
    let start: Vec<f64> =
        counted.iter().zip(&impacts).flat_map(|((_, time), (_, _, speed))| [*time, *speed]).collect();
    find_from(simulator, &Itinerary::new(strikes)?, &start, struck.as_ref())
}

fn ended(run: &mut Run, end: RunEnd) -> Result<()> {
    match (run.failure(), end) {
        (Some(error), _) => Err(error),
        (None, RunEnd::Reached) => Ok(()),
        (None, end) => Err(Error::input(format!("the attractor's motion ended, {}", end.why()))),
    }
}
