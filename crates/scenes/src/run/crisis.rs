//! Tasks of kind `crisis`: where an attractor ends, by manifolds and by simulation.

use serde::Serialize;

use super::{Finding, Job, Lines, Status, row};
use crate::{
    attractor::dynamics::Dynamics,
    error::{Error, Result},
    motion::Time,
    one::{
        attractor::crisis::{CrisisSearch, crisis as locate},
        orbit::Family,
    },
    rounding::PLACE,
    scene::{branches::CrisisTask, phase},
};

row! {
    /// The crisis as found from one distance.
    pub struct CrisisRow {
        /// How far from the orbit its unstable manifold was entered.
        pub offset: f64,
        /// The parameter.
        pub parameter: f64,
        /// The corner's displacement on the section.
        pub corner_q: f64,
        /// Its velocity.
        pub corner_u: f64,
        /// The least minimum of the gap in the flight from it: what is left of 0.
        pub corner_gap: f64,
        /// The orbit's larger multiplier.
        pub expansion: f64,
        /// What is left of the distance from the stable manifold.
        pub distance: f64,
    }
}

row! {
    /// A motion simulated beside the crisis.
    pub struct PersistenceRow {
        /// The parameter.
        pub parameter: f64,
        /// Its distance from the crisis.
        pub margin: f64,
        /// For how many periods the motion went on having impacts.
        pub periods: u64,
        /// Whether it has escaped before the periods asked for were over.
        pub escaped: bool,
    }
}

/// The crisis from each distance, and motions on both sides of it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CrisisFindings {
    /// One row for each distance; their parameters should agree.
    pub crisis: Vec<CrisisRow>,
    /// One row for each margin and side.
    pub simulated: Vec<PersistenceRow>,
    /// The length of the bracket.
    #[serde(skip)]
    width: f64,
}

impl Finding for CrisisFindings {
    fn status(&self) -> Status {
        let values = self.crisis.iter().map(|row| row.parameter);
        let (low, high) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        if high - low <= PLACE * low.abs().max(self.width) {
            return Status::Done;
        }
        Status::undecided(format!("the answers for different offsets differ by {:e}", high - low))
    }

    fn lines(&self, lines: &mut Lines) {
        lines.table("crisis", &self.crisis);
        lines.table("simulated", &self.simulated);
    }
}

/// Locates the crisis and simulates on both sides of it.
///
/// # Errors
/// An input error if there is no saddle or no crisis in the bracket; an interruption.
pub(crate) fn crisis(task: &CrisisTask, job: &Job) -> Result<CrisisFindings> {
    let family = job.family(&task.parameter)?;
    let bracket = (task.bracket[0], task.bracket[1]);
    let orbits = task.orbit.orbits(&family.at((bracket.0 + bracket.1) / 2.0)?, || job.check())?.found;
    let saddle = orbits
        .into_iter()
        .find(|orbit| orbit.admissibility.is_admissible() && orbit.multipliers.values()[0].0 > 1.0)
        .ok_or_else(|| Error::input("no saddle of the pattern in the middle of the bracket"))?;
    let mut found =
        CrisisFindings { crisis: Vec::new(), simulated: Vec::new(), width: (bracket.1 - bracket.0).abs() };
    let mut parameter = f64::NAN;
    let settings = job.settings()?;
    for offset in task.offsets_at(saddle.unit) {
        job.check()?;
        let search = CrisisSearch {
            itinerary: &saddle.itinerary,
            start: saddle.z.clone(),
            phase: phase(&task.phase),
            images: task.images,
            offset,
            bracket,
            settings: &settings,
        };
        let here = locate(&family, &search)?;
        parameter = here.parameter;
        found.crisis.push(CrisisRow {
            offset,
            parameter,
            corner_q: here.corner.state.q,
            corner_u: here.corner.state.u * here.saddle.rate,
            corner_gap: here.corner.gap,
            expansion: here.saddle.multipliers.values()[0].0,
            distance: here.distance,
        });
    }
    let margins: Vec<f64> = task.margins.iter().flat_map(|margin| [-margin, *margin]).collect();
    job.monitor.begin(task.periods * margins.len() as u64, "periods");
    for margin in margins {
        let periods = persistence(task, job, parameter + margin)?;
        found.simulated.push(PersistenceRow {
            parameter: parameter + margin,
            margin,
            periods,
            escaped: periods < task.periods,
        });
    }
    Ok(found)
}

/// For how many periods the motion goes on having impacts.
fn persistence(task: &CrisisTask, job: &Job, parameter: f64) -> Result<u64> {
    let simulator = job.simulator_of(&job.scene.plain(&[(&task.parameter, parameter)])?)?;
    let start = job.scene.state(&task.start)?;
    let (t, mut run) = (start.t, simulator.begin(&start)?);
    let (mut last, mut impacts) = (0, 0);
    for period in 1..=task.periods {
        if period.is_multiple_of(4096) {
            job.monitor.advance(4096)?;
        }
        run.finish(Time::new(period as i64, t));
        if run.impacts() > impacts {
            (last, impacts) = (period, run.impacts());
        }
        if period - last > task.quiet {
            return Ok(last);
        }
    }
    Ok(task.periods)
}
