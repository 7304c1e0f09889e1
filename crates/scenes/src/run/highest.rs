//! Where coordinates and gaps are seen to swing most, for the task `response`.

use super::{
    Job,
    engine::Engine,
    proved::StartOf,
    response::{ResponseRow, half},
    row,
    swept::{SweepFindings, way},
    unstable::on_attractor,
};
use crate::{
    attractor::{
        diagram::SweepStep,
        portrait::{OnAttractor, Portrait},
        swing::Swing,
    },
    error::Result,
    scene::response::ResponseTask,
};

row! {
    /// Where a coordinate is seen to swing most.
    pub struct HighestRow {
        /// Which way the parameter goes.
        pub way: &'static str,
        /// The coordinate, or the stop whose gap it is.
        pub coordinate: String,
        /// The parameter's value there: between those looked at, where a periodic orbit is followed from one
        /// to the next.
        pub value: f64,
        /// Half of the way from its least to its greatest value.
        pub swing: f64,
        /// The harmonic's amplitude.
        pub amplitude: f64,
    }
}

/// Steps in which the place of a largest swing is narrowed down, to a hundred-thousandth.
const STEPS: u32 = 24;

/// Where each displacement swings most, each way: of `rows`, and then along the orbit there, between the
/// values on both sides or to where it ends. Cost: 25 orbits for each.
///
/// # Errors
/// An interruption.
pub(super) fn highest<E: Engine>(
    (task, names, rows): (&ResponseTask, &[String], &[ResponseRow]),
    job: &Job,
    (engine, states): (&E, &E::States),
    steps: &[(bool, &SweepStep<StartOf<E>>)],
    sweep: &SweepFindings,
) -> Result<Vec<HighestRow>> {
    let mut found = Vec::new();
    for up in [true, false] {
        let on: Vec<&SweepStep<_>> = steps.iter().filter(|step| step.0 == up).map(|step| step.1).collect();
        for (place, name) in names.iter().enumerate() {
            let own = rows.iter().filter(|row| row.way == way(up) && row.coordinate == *name);
            let Some(most) = own.max_by(|a, b| a.swing.total_cmp(&b.swing)) else { continue };
            let ResponseRow { way, value, swing, amplitude, .. } = *most;
            let mut row = HighestRow { way, coordinate: name.clone(), value, swing, amplitude };
            if let Some((settled, range)) = about(&row, &on, sweep) {
                let period = settled.portrait.period.unwrap_or(1);
                let swing_at = |value: f64| -> Result<(f64, f64)> {
                    job.check()?;
                    let change = (task.parameter.as_str(), value);
                    let swings = engine.system(Some(change)).and_then(|system| {
                        let orbit = on_attractor(engine, settled, &system)?;
                        let start = engine.on_orbit(&orbit, &system)?;
                        engine.swings(states, change, &start, [period, task.harmonic])
                    });
                    match swings {
                        Err(error) if error.is_interrupted() => Err(error),
                        // Beside its end the orbit may not be found.
                        Err(_) | Ok(None) => Ok((f64::NEG_INFINITY, 0.0)),
                        Ok(Some(swings)) => {
                            let Swing { extent, harmonic: [a, b] } = swings[place];
                            Ok((half(extent), a.hypot(b)))
                        }
                    }
                };
                narrow(&mut row, range, swing_at)?;
            }
            found.push(row);
        }
    }
    Ok(found)
}

/// The orbit on which something is largest, and between which values the sweep was on it; none at an end of
/// the sweep and where the motion is not periodic.
fn about<'s, S>(
    row: &HighestRow,
    on: &[&'s SweepStep<S>],
    sweep: &SweepFindings,
) -> Option<(&'s OnAttractor<S>, [f64; 2])> {
    let i = on.iter().position(|step| step.value == row.value)?;
    let (before, after) = (on.get(i.checked_sub(1)?)?, on.get(i + 1)?);
    let settled = on[i].decided().filter(|settled| settled.portrait.period.is_some())?;
    let jumps = || sweep.jumps.iter().filter(|jump| jump.sweep == row.way).map(|jump| jump.stays);
    let between = |x: f64, y: f64| jumps().find(|at| (at - x) * (at - y) <= 0.0);
    let kind = |portrait: &Portrait| (portrait.period, portrait.impacts);
    let goes_on = |step: &SweepStep<S>| {
        step.decided().is_some_and(|there| kind(&there.portrait) == kind(&settled.portrait))
    };
    // What a jump leads to is not known before it, nor the orbit beyond where the motion is on it.
    let first = match between(before.value, row.value) {
        None if goes_on(before) => before.value,
        _ => row.value,
    };
    let last = match between(row.value, after.value) {
        None if goes_on(after) => after.value,
        end => end.unwrap_or(row.value),
    };
    (first != last).then_some((settled, [first, last]))
}

/// By the golden section of the range.
fn narrow(
    row: &mut HighestRow,
    [mut a, mut b]: [f64; 2],
    at: impl Fn(f64) -> Result<(f64, f64)>,
) -> Result<()> {
    let part = (5f64.sqrt() - 1.0) / 2.0;
    let mut look = |value: f64| -> Result<(f64, f64)> {
        let (swing, amplitude) = at(value)?;
        if swing > row.swing {
            (row.value, row.swing, row.amplitude) = (value, swing, amplitude);
        }
        Ok((value, swing))
    };
    let (mut low, mut high) = (look(b - part * (b - a))?, look(a + part * (b - a))?);
    for _ in 0..STEPS {
        if low.1 > high.1 {
            (b, high) = (high.0, low);
            low = look(b - part * (b - a))?;
        } else {
            (a, low) = (low.0, high);
            high = look(a + part * (b - a))?;
        }
    }
    Ok(())
}
