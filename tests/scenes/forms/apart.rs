//! One run, and the same work in other pieces: on other numbers of threads (and so in other batches), in
//! shards, and interrupted and resumed. All that is reported is the same, to the last bit.

use std::sync::atomic::{AtomicI64, Ordering};

use grazing_scenes::{
    Monitor,
    run::{Job, Status, Surroundings, TaskReport, parts, run_task},
    scene::{Scene, Task},
};
use rayon::ThreadPoolBuilder;
use toml::Table;

use super::{
    compare::Difference,
    report::{Reported, reports},
    scenes::NAME,
};

/// Interrupts after this many units of work.
struct Ends(AtomicI64);

impl Monitor for Ends {
    fn advance(&self, units: u64) -> grazing_scenes::Result<()> {
        match self.0.fetch_sub(units.try_into().unwrap_or(i64::MAX), Ordering::Relaxed) {
            left if left > 0 => Ok(()),
            _ => Err(grazing_scenes::Error::interrupted("by the test")),
        }
    }
}

/// What differs, and how many reports were compared.
pub fn differences(scene: &Table) -> (Vec<Difference>, usize) {
    let text = toml::to_string(scene).expect("a table");
    let (mut all, mut count) = (Vec::new(), 0);
    let mut compare = |task: &str, how: &str, one: &str, other: &str| {
        count += 1;
        if one != other {
            let what = format!("{other} for {one}");
            all.push(Difference { task: task.into(), column: how.into(), what });
        }
    };
    let on = |threads: usize| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| reports(&text, Surroundings::default())).expect("it was read before")
    };
    let (one, three) = (on(1), on(3));
    for (one, three) in one.0.iter().zip(&three.0) {
        compare(&one.report.task, "on three threads", &Reported::whole(one), &three.whole());
    }
    let scene = Scene::from_toml(&text, NAME).expect("it was read before");
    for (task, one) in scene.tasks.iter().zip(&one.0) {
        let Some((units, _)) = parts::units(task) else { continue };
        let effects = format!("{:?}", one.report.effects);
        let one = findings(&one.report);
        let shards = in_shards(&scene, task, units);
        compare(&task.name, "in shards", &one, &findings(&shards));
        compare(&task.name, "work of shards", &effects, &format!("{:?}", shards.effects));
        compare(&task.name, "resumed", &one, &findings(&resumed(&scene, task)));
    }
    (all, count)
}

/// Without the effects: a resumed task counts those of a unit that was under way twice.
fn findings(report: &TaskReport) -> String {
    format!("{:?} {:?} {:?}", report.status, report.findings, report.warnings)
}

fn in_shards(scene: &Scene, task: &Task, units: u64) -> TaskReport {
    let folder = tempfile::tempdir().expect("a folder");
    // Each is a command of its own, that counts its own work.
    let job = || Job::new(scene, task, Surroundings::default()).expect("it was made before");
    let cut = units / 3;
    let part = |name: &str, range| parts::part(&job(), range, &folder.path().join(name)).expect("a part");
    let records: Vec<String> = [part("1", 0..cut), part("2", cut..units)].concat();
    parts::whole(&job(), &records, &mut ())
}

fn resumed(scene: &Scene, task: &Task) -> TaskReport {
    let folder = tempfile::tempdir().expect("a folder");
    let around = Surroundings { folder: Some(folder.path()), ..Surroundings::default() };
    let ends = Ends(AtomicI64::new(1));
    let job = Job::new(scene, task, Surroundings { monitor: &ends, ..around }).expect("it was made before");
    let report = run_task(&job, &mut ());
    assert!(matches!(report.status, Status::Interrupted { .. }), "{:?}", report.status);
    run_task(&Job::new(scene, task, around).expect("it was made before"), &mut ())
}
