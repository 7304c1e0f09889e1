//! A scene from TOML text.

use std::{collections::HashSet, path::Path, sync::Arc};

use num_rational::BigRational;
use toml_edit::Item;

use super::{
    expression::is_name,
    keys::{Entry, Key, Record, Scope, Seen, Value, keys},
    machine::{MachineAccuracy, MachineKeys, MachineScene, StopKeys},
    scene::{Body, Scene},
    system::{Accuracy, HarmonicKeys, SystemKeys, WallKeys, system},
    task::Task,
};
use crate::{
    error::Result,
    output::{LONGEST_SCENE, read_text},
    source::Source,
};

/// The most parameters and tasks of a scene: each task takes the parameters along, and is checked with them.
const MOST_PARAMETERS: usize = 1000;
const MOST_TASKS: usize = 10_000;

const FORMAT: &str = "grazing-scene 1";
const MACHINES: &str = "grazing-scene 2";

keys! {
    /// The top level of a scene of an oscillator.
    pub struct File {
        /// `"grazing-scene 1"`
        format: String,
        /// what it is
        title: String,
        /// names and their values: numbers, which `grazing run --set` and a task's `set` can change
        parameters: Parameters = "{}",
        /// the equation of motion
        system: SystemKeys,
        /// at most one wall on each side
        walls: Vec<WallKeys> = "[]",
        /// how accurately to compute
        accuracy: Accuracy = "{}",
        /// what to do
        tasks: Vec<TaskEntry> = "[]",
    }
}

keys! {
    /// The top level of a scene of a machine.
    pub struct MachineFile {
        /// `"grazing-scene 2"`
        format: String,
        /// what it is
        title: String,
        /// names and their values: numbers, which `grazing run --set` and a task's `set` can change
        parameters: Parameters = "{}",
        /// the equations of motion
        system: MachineKeys,
        /// the stops
        walls: Vec<StopKeys> = "[]",
        /// how accurately to compute
        accuracy: MachineAccuracy = "{}",
        /// what to do
        tasks: Vec<TaskEntry> = "[]",
    }
}

/// Names and values.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameters;

/// A task, read once its parameters are known.
#[derive(Debug, Clone, PartialEq)]
pub struct TaskEntry(Task);

impl Value for Parameters {
    fn shape() -> String {
        "table of numbers".to_string()
    }

    fn read(_: &Entry) -> Result<Self> {
        Ok(Parameters)
    }
}

impl Value for TaskEntry {
    fn shape() -> String {
        "task".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        Task::read(entry).map(TaskEntry)
    }
}

impl Scene {
    /// Reads a scene from a TOML file, whose path leads every error message. Matrices that the scene keeps in
    /// files of their own are read beside it. The format is in docs/scenes.md.
    ///
    /// ```
    /// use grazing::scene::Scene;
    /// let scene = Scene::read("examples/scenes/nordmark-2001.toml")?;
    /// assert_eq!(scene.parameters[0].0, "d");
    /// assert!(Scene::read("no/such/scene.toml").unwrap_err().is_io());
    /// # Ok::<(), grazing::Error>(())
    /// ```
    ///
    /// # Errors
    /// If the file cannot be read, is longer than 4 MiB or is not UTF-8; else as
    /// [`from_toml`](Self::from_toml).
    pub fn read(path: impl AsRef<Path>) -> Result<Scene> {
        let path = path.as_ref();
        Self::from_toml(&read_text(path, LONGEST_SCENE)?, &path.display().to_string())
    }

    /// Reads a scene from the text of a TOML file; `name` leads every error message. The format is in
    /// docs/scenes.md.
    ///
    /// # Errors
    /// An input error `name:line: key = value: what is wrong and the fix`: for the text's form, an unknown
    /// key, a missing one, a value of the wrong shape, an expression that cannot be evaluated, walls that
    /// cross, a negative restitution, a start behind a wall, with the scene's parameters and with those of
    /// each task.
    ///
    /// ```
    /// use grazing::scene::Scene;
    /// let text = r#"
    ///     format = "grazing-scene 1"
    ///     title = "A mass on a spring"
    ///     [parameters]
    ///     w = 4.9
    ///     [system]
    ///     stiffness = "1/w^2"
    /// "#;
    /// let scene = Scene::from_toml(text, "spring.toml")?;
    /// assert_eq!(scene.exact(&[])?.stiffness.to_string(), "100/2401");
    /// # Ok::<(), grazing::Error>(())
    /// ```
    pub fn from_toml(text: &str, name: &str) -> Result<Scene> {
        let source = Source { text, name };
        let document = source.document()?;
        let (seen, root) = (Seen::default(), Item::Table(document.as_table().clone()));
        let scope = |names| Scope { source: source.clone(), names, seen: &seen };
        let nameless = scope(&[]);
        let file = Entry { scope: &nameless, path: String::new(), span: None, item: root.clone() };
        file.only(&File::KEYS.iter().map(|key| key.name).collect::<Vec<_>>())?;
        let format = file.get("format")?;
        let machines = format.as_ref().is_some_and(|format| format.item.as_str() == Some(MACHINES));
        if let Some(format) = format
            && format.item.as_str() != Some(FORMAT)
            && !machines
        {
            return Err(
                format.fail(&format!("this version reads {FORMAT:?} and, for machines, {MACHINES:?}"))
            );
        }
        let parameters = match file.get("parameters")? {
            Some(entry) => parameters(&entry)?,
            None => Vec::new(),
        };
        let names: Vec<String> = parameters.iter().map(|(name, _)| name.clone()).collect();
        let scope = scope(&names);
        let file = Entry { scope: &scope, path: String::new(), span: None, item: root };
        let (title, tasks, accuracy, body) = if machines {
            let read = MachineFile::fields(&file, &[])?;
            let machine = MachineScene::new(&file, read.system, read.walls, &read.accuracy)?;
            (read.title, read.tasks, Accuracy::default(), Body::Machine(Arc::new(machine)))
        } else {
            let read = File::fields(&file, &[])?;
            let system = system(&file, read.system, read.walls)?;
            (read.title, read.tasks, read.accuracy, Body::Oscillator(Arc::new(system)))
        };
        let tasks: Vec<Task> = tasks.into_iter().map(|task| task.0).collect();
        let scene = Scene {
            title,
            parameters,
            body,
            accuracy,
            tasks,
            file: Arc::new((name.to_string(), text.to_string())),
            places: Arc::new(seen.places.take()),
            files: Arc::new(seen.files.take()),
        };
        if !(1e-15..=1e-3).contains(&scene.accuracy.tolerance) {
            return Err(scene.fail("accuracy.tolerance", "is outside 1e-15 to 1e-3"));
        }
        if scene.accuracy.minimum_depth.is_some_and(|depth| depth.is_nan() || depth <= 0.0) {
            return Err(scene.fail("accuracy.minimum_depth", "must be positive"));
        }
        match scene.body {
            Body::Oscillator(_) => scene.exact(&[]).map(|_| ())?,
            Body::Machine(_) => scene.machine(&[]).map(|_| ())?,
        }
        for (count, most, key) in [
            (scene.parameters.len(), MOST_PARAMETERS, "parameters"),
            (scene.tasks.len(), MOST_TASKS, "tasks"),
        ] {
            if count > most {
                return Err(scene.fail(key, &format!("{count} of them: at most {most}")));
            }
        }
        let mut names = HashSet::new();
        for task in &scene.tasks {
            if !names.insert(&task.name) {
                let key = format!("{}.name", task.path);
                return Err(
                    scene.fail(&key, "is the name of an earlier task too; its files would be overwritten")
                );
            }
            scene.for_task(task, &[])?;
        }
        Ok(scene)
    }
}

fn parameters(entry: &Entry) -> Result<Vec<(String, BigRational)>> {
    let mut all = Vec::new();
    for (name, _) in entry.table()?.iter() {
        let Some(value) = entry.get(name)? else { continue };
        if !is_name(name) {
            return Err(value.fail("the name of a parameter is a letter, then letters, digits and _"));
        }
        all.push((name.to_string(), value.number()?));
    }
    Ok(all)
}

/// The tables of the file but those of the tasks: path, what it is, keys.
pub(super) const TABLES: &[(&str, &str, &[Key])] = &[
    ("the file", File::ABOUT, File::KEYS),
    ("the file of a machine", MachineFile::ABOUT, MachineFile::KEYS),
    ("`[system]`", SystemKeys::ABOUT, SystemKeys::KEYS),
    ("an entry of `forcing` or `harmonics`", HarmonicKeys::ABOUT, HarmonicKeys::KEYS),
    ("`[[walls]]`", WallKeys::ABOUT, WallKeys::KEYS),
    ("`[accuracy]`", Accuracy::ABOUT, Accuracy::KEYS),
];
