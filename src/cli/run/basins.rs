//! Tasks of kind `basins`: which starts lead to which attractor.

use rayon::prelude::*;

use super::{Job, Report, report::Rows, settings};
use crate::{
    error::Result,
    monitor::Monitor,
    oscillator::{
        Attractor, Look,
        flow::State,
        scene::{Basins, Values, phase},
        simulate::{End, Simulator},
    },
    output::{
        Progress,
        figure::{self, Grid},
    },
};

/// Classes of starts besides the attractors.
const OTHERS: [&str; 3] = ["behind a wall", "unbounded", "not periodic"];

pub(super) fn run(task: &Basins, job: &Job, report: &mut Report) -> Result<()> {
    let simulator = Simulator::new(&job.system, &settings(&job.scene))?;
    let t = phase(&task.phase);
    let look = Look { phase: t, transient: task.transient, points: task.points, longest: task.longest };
    let (qs, us) = (values(&task.q, job)?, values(&task.u, job)?);
    let progress = Progress::new(job.interrupt, us.len() as u64 * qs.len() as u64, "starts");
    let ends: Vec<Option<Attractor>> = (0..us.len() * qs.len())
        .into_par_iter()
        .map(|i| {
            progress.advance(1)?;
            let start = State { t, q: qs[i % qs.len()], u: us[i / qs.len()] };
            if simulator.contacts().any(|wall| wall.gap(start)[0] < 0.0) {
                return Ok(None);
            }
            Attractor::of(&simulator, start, &look, || Ok(())).map(Some)
        })
        .collect::<Result<_>>()?;
    let mut attractors: Vec<Attractor> = Vec::new();
    let mut class = |end: &Option<Attractor>| match end {
        None => 0,
        Some(end) if end.end != End::Reached => 1,
        Some(end) if end.period.is_none() => 2,
        Some(end) => {
            let known = attractors.iter().position(|other| other.is(end));
            OTHERS.len()
                + known.unwrap_or_else(|| {
                    attractors.push(end.clone());
                    attractors.len() - 1
                })
        }
    };
    let cells: Vec<usize> = ends.iter().map(&mut class).collect();
    let name = |attractor: &Attractor| {
        let plural = if attractor.impacts == 1 { "" } else { "s" };
        format!("period {}, {} impact{plural}", attractor.period.unwrap_or_default(), attractor.impacts)
    };
    let names: Vec<String> =
        OTHERS.iter().map(|name| name.to_string()).chain(attractors.iter().map(name)).collect();
    let mut rows = Rows::new(&["ends", "starts"]);
    for (class, name) in names.iter().enumerate() {
        let starts = cells.iter().filter(|&&cell| cell == class).count();
        if starts > 0 {
            rows.push([name.as_str().into(), starts.into()]);
        }
    }
    figure::grid(&Grid { x: qs, y: us, cells, names }, ["q", "u"], job.folder, &job.task.name)?;
    report.table("basins", rows);
    report.say("files", ["svg", "csv"].map(|end| format!("{}.{end}", job.task.name)).to_vec());
    Ok(())
}

fn values(range: &Values, job: &Job) -> Result<Vec<f64>> {
    let (from, to) = (job.scene.number(&range.from)?, job.scene.number(&range.to)?);
    let last = f64::from(range.count - 1);
    Ok((0..range.count).map(|i| from + (to - from) * f64::from(i) / last).collect())
}
