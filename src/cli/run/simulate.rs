//! Tasks of kind `simulate`: one motion.

use super::{Job, Report};
use crate::{error::Result, oscillator::scene::task::Simulate};

pub(super) fn run(task: &Simulate, job: &Job, report: &mut Report) -> Result<()> {
    report.say("periods", task.periods);
    let start = job.scene.state(&task.start)?;
    report.say("start", vec![start.t, start.q, start.u]);
    Ok(())
}
