//! What the monitors of a branch must be, with the coordinates that there are.

use super::Checked;
use crate::{
    error::Result,
    scene::{
        branches::BranchTask,
        monitors::{Hold, Quantity},
    },
    source::hint,
};

impl Checked<'_> {
    pub(super) fn monitors(&self, task: &BranchTask) -> Result<()> {
        let names: Vec<&str> = task.monitors.0.iter().map(|monitor| monitor.name.as_str()).collect();
        let held = task.hold.as_ref().map(|Hold(name, _)| ("hold", name));
        for (key, name) in task.levels.0.iter().map(|(name, _)| ("levels", name)).chain(held) {
            if !names.contains(&name.as_str()) {
                let hint = hint(name, names.iter().copied());
                return self.fail(key, &format!("there is no monitor {name:?} in the task; {hint}"));
            }
        }
        if let Some(Hold(name, _)) = &task.hold {
            if task.second.is_none() {
                return self.fail("hold", "holds a monitor while two parameters move: give `second`");
            }
            if task.levels.0.iter().any(|level| level.0 == *name) {
                return self.fail("levels", &format!("{name} is held: it takes one value"));
            }
        }
        let count = self.coordinates();
        for monitor in &task.monitors.0 {
            for (_, word, quantity) in monitor.asked(self.scene.parameters.len()) {
                let fail =
                    |what: &str| self.fail(&format!("monitors.{}", monitor.name), &format!("{word}: {what}"));
                match quantity {
                    Quantity::Extent(None, _) if count > 1 => {
                        return fail("there are several coordinates: name one, as in swing1 or q1_max");
                    }
                    Quantity::Extent(Some(i), _) if i >= count => {
                        return fail(&format!("the coordinates are 1 to {count}"));
                    }
                    _ => {}
                }
            }
        }
        Ok(())
    }
}
