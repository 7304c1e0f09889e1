//! From a motion to the periodic orbit that it tends to: the impact pattern read off, the orbit by Newton's
//! method.

use crate::{
    attractor::{detection::Detection, dynamics::Dynamics},
    continuation::natural,
    error::{Error, Result},
    monitor::Monitor,
    motion::{Flow, State, Time},
    one::{
        orbit::{Itinerary, Orbit, Oscillator, Strike, find},
        simulate::{Event, Settings, Simulator},
    },
};

/// The periodic orbit that the motion from `start`, its velocity as it is shown, tends to.
///
/// # Errors
/// An input error if it tends to none that is found, or rests on a wall; those of [`find`]; the monitor's.
pub fn attracting(
    oscillator: &Oscillator,
    start: State,
    detection: &Detection,
    settings: &Settings,
    monitor: &dyn Monitor,
) -> Result<Orbit> {
    let simulator = Simulator::new(oscillator.system(), settings)?.counting_too(oscillator.tally());
    let mut run = simulator.begin(&start)?;
    let cycle = detection.detect(&simulator, &mut run, monitor)?.periodic(detection)?;
    let (period, phase, [q, u]) = (cycle.period() as i64, detection.phase, cycle.points[0]);
    let mut run = simulator.start(Time::new(0, phase), q, u)?;
    let (mut times, mut sides, mut speeds, mut rests) = (Vec::new(), Vec::new(), Vec::new(), false);
    run.record(Time::new(period, phase), |event| match event {
        Event::Impact(impact) => {
            times.push((impact.time.period, impact.time.phase));
            sides.push(impact.place);
            speeds.push(impact.velocity.abs());
        }
        Event::Stick(_) => rests = true,
        _ => {}
    });
    if rests {
        return Err(Error::input("the attractor rests on a wall: it has no impact pattern"));
    }
    if times.is_empty() {
        let at_zero = oscillator.flow().advance(State { t: phase, q, u }, std::f64::consts::TAU - phase);
        return find(oscillator, &Itinerary::free(period as u32)?, vec![at_zero.q, at_zero.u]);
    }
    let counted = natural(&times, period as u32);
    let strikes =
        sides.into_iter().zip(&counted).map(|(side, &(periods, _))| Strike { place: side, periods });
    let z = counted.iter().zip(speeds).flat_map(|((_, time), speed)| [*time, speed]).collect();
    find(oscillator, &Itinerary::new(strikes.collect())?, z)
}
