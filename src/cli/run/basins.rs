//! Tasks of kind `basins`: which starts lead to which attractor.

use super::{Job, Report, ended, report::Rows, settings};
use crate::{
    cli::progress::Progress,
    error::Result,
    figure::{self, Grid},
    oscillator::{
        attractor::{
            basins::{Cell, Frame, basins},
            detection::{Cycle, Detection},
        },
        simulate::{End, Simulator},
    },
    scene::{Basins, Values, phase},
};

pub(super) fn run(task: &Basins, job: &Job, report: &mut Report) -> Result<()> {
    let simulator = Simulator::new(&job.system, &settings(&job.scene))?;
    let ends = |values: &Values| -> Result<[f64; 2]> {
        Ok([job.scene.number(&values.from)?, job.scene.number(&values.to)?])
    };
    let frame = Frame {
        q: ends(&task.q)?,
        u: ends(&task.u)?,
        columns: task.q.count as usize,
        rows: task.u.count as usize,
    };
    let detection = Detection {
        phase: phase(&task.phase),
        transient: task.transient,
        longest: task.longest as usize,
        ..Detection::default()
    };
    let progress = Progress::new(job.interrupt, u64::from(task.u.count), "rows");
    let found = basins(&simulator, &frame, &detection, &progress)?;

    let name = |cycle: &Cycle| {
        let plural = if cycle.impacts == 1 { "" } else { "s" };
        format!("period {}, {} impact{plural}", cycle.period(), cycle.impacts)
    };
    let others = ["behind a wall", ended(End::Escaped), "not periodic"].map(String::from);
    let class = |cell: &Cell| match cell {
        Cell::Behind => 0,
        Cell::Ended(_) => 1,
        Cell::Irregular => 2,
        Cell::Attractor(index) => others.len() + index,
    };
    let cells: Vec<usize> = found.cells.iter().map(class).collect();
    let names: Vec<String> = others.iter().cloned().chain(found.attractors.iter().map(name)).collect();
    let mut rows = Rows::new(&["ends", "starts"]);
    for (class, name) in names.iter().enumerate() {
        let starts = cells.iter().filter(|&&cell| cell == class).count();
        if starts > 0 {
            rows.push([name.as_str().into(), starts.into()]);
        }
    }
    let x = (0..frame.columns).map(|column| frame.start(column, 0)[0]).collect();
    let y = (0..frame.rows).map(|row| frame.start(0, row)[1]).collect();
    figure::grid(&Grid { x, y, cells, names }, ["q", "u"], job.folder, &job.task.name)?;
    report.table("basins", rows);
    report.say("files", ["svg", "csv"].map(|end| format!("{}.{end}", job.task.name)).to_vec());
    Ok(())
}
