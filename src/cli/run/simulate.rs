//! Tasks of kind `simulate`: one motion.

use super::{Job, Report};
use crate::{error::Result, oscillator::scene::task::Simulate};

pub(super) fn run(task: &Simulate, job: &Job, report: &mut Report) -> Result<()> {
    report.say("periods", task.periods);
    report.say("start", job.scene.state(&task.start)?.to_vec());
    Ok(())
}
