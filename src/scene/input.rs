//! A scene from TOML text.

use std::cell::RefCell;

use num_rational::BigRational;
use toml_edit::Item;

use super::{
    Scene, Task,
    expression::{Expression, is_name},
    keys::{Entry, Key, Record, Scope, keys},
};
use crate::{
    error::Result,
    oscillator::{Harmonic, Side, System, Wall},
    source::Source,
};

const FORMAT: &str = "grazing-scene 1";
/// The highest multiple of the base frequency.
const LIMIT_K: u32 = 1000;

keys! {
    /// The file.
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
    /// q″ = −`damping` q′ − `stiffness` q − `cubic` q³ + `force` + `forcing`(t), time in units in which the forcing's period is 2π.
    pub struct SystemKeys {
        /// the coefficient of the velocity
        damping: Expression = "0",
        /// the coefficient of the displacement
        stiffness: Expression = "0",
        /// the coefficient of the displacement cubed (Duffing)
        cubic: Expression = "0",
        /// a constant acceleration: preload or gravity
        force: Expression = "0",
        /// the harmonics of the forcing
        forcing: Vec<HarmonicKeys> = "[]",
    }
}

keys! {
    /// A term `cos` cos kt + `sin` sin kt.
    pub struct HarmonicKeys {
        /// the multiple of the base frequency, 1 to 1000
        k: u32 = "1",
        /// the coefficient of cos kt
        cos: Expression = "0",
        /// the coefficient of sin kt
        sin: Expression = "0",
    }
}

keys! {
    /// A wall at `offset` + Σ `harmonics`; an impact turns the velocity relative to it into −`restitution` times itself.
    pub struct WallKeys {
        /// on which side of the oscillator
        side: Side,
        /// the mean position
        offset: Expression,
        /// its motion; none for a wall that stands still
        harmonics: Vec<HarmonicKeys> = "[]",
        /// at least 0: 0 for a wall that stops the motion, 1 for one that keeps the energy
        restitution: Expression,
    }
}

keys! {
    /// How accurately motions are computed.
    pub struct Accuracy {
        /// the integrator's tolerance, absolute and relative, for oscillators with cubic stiffness; others need none
        tolerance: f64 = "1e-12",
        /// a minimum of the distance to a wall that is deeper than this is an impact; a shallower one is a tangency
        minimum_depth: f64 = "1e-12",
    }
}

/// Names and values.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameters;

/// A task, read once its parameters are known.
#[derive(Debug, Clone, PartialEq)]
pub struct TaskEntry(Task);

impl super::keys::Value for Parameters {
    fn shape() -> String {
        "table of numbers".to_string()
    }

    fn read(_: &Entry) -> Result<Self> {
        Ok(Parameters)
    }
}

impl super::keys::Value for Side {
    fn shape() -> String {
        "`\"lower\"` or `\"upper\"`".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        entry.word(&[Side::Lower, Side::Upper].map(|side| (side.name(), side)))
    }
}

impl super::keys::Value for TaskEntry {
    fn shape() -> String {
        "task".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        Task::read(entry).map(TaskEntry)
    }
}

impl Scene {
    /// Reads a scene from the text of a TOML file; `name` leads every error message. The format is in docs/scenes.md.
    ///
    /// # Errors
    /// An input error `name:line: key = value: what is wrong and the fix`: for the text's form, an unknown key, a
    /// missing one, a value of the wrong shape, an expression that cannot be evaluated, walls that cross, a negative
    /// restitution, a start behind a wall, with the scene's parameters and with those of each task.
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
        let (places, root) = (RefCell::default(), Item::Table(document.as_table().clone()));
        let scope = |names| Scope { source: source.clone(), names, places: &places };
        let nameless = scope(&[]);
        let file = Entry { scope: &nameless, path: String::new(), span: None, item: root.clone() };
        file.only(&File::KEYS.iter().map(|key| key.name).collect::<Vec<_>>())?;
        if let Some(format) = file.get("format")?
            && format.item.as_str() != Some(FORMAT)
        {
            return Err(format.fail(&format!("this version reads {FORMAT:?}")));
        }
        let parameters = match file.get("parameters")? {
            Some(entry) => parameters(&entry)?,
            None => Vec::new(),
        };
        let names: Vec<String> = parameters.iter().map(|(name, _)| name.clone()).collect();
        let scope = scope(&names);
        let file = Entry { scope: &scope, path: String::new(), span: None, item: root };
        let read = File::fields(&file, &[])?;
        let tasks: Vec<Task> = read.tasks.into_iter().map(|task| task.0).collect();
        let system = system(&file, read.system, read.walls)?;
        let scene = Scene {
            title: read.title,
            parameters,
            system,
            accuracy: read.accuracy,
            tasks,
            file: (name.to_string(), text.to_string()),
            places: places.take(),
        };
        for (accuracy, least, key) in [
            (scene.accuracy.tolerance, 1e-15, "tolerance"),
            (scene.accuracy.minimum_depth, 1e-13, "minimum_depth"),
        ] {
            if !(least..=1e-3).contains(&accuracy) {
                return Err(scene.fail(&format!("accuracy.{key}"), &format!("is outside {least:e} to 1e-3")));
            }
        }
        scene.exact(&[])?;
        for (index, task) in scene.tasks.iter().enumerate() {
            if scene.tasks[..index].iter().any(|other| other.name == task.name) {
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

fn system(file: &Entry, keys: SystemKeys, walls: Vec<WallKeys>) -> Result<System<Expression>> {
    let at = |path: &str| Entry {
        scope: file.scope,
        path: path.to_string(),
        span: file.scope.places.borrow().get(path).cloned(),
        item: Item::None,
    };
    let harmonics = |list: Vec<HarmonicKeys>, path: &str| {
        for (i, harmonic) in list.iter().enumerate() {
            let place = || at(&format!("{path}[{}]", i + 1));
            if !(1..=LIMIT_K).contains(&harmonic.k) {
                return Err(place().fail(&format!("k is {}; it goes from 1 to {LIMIT_K}", harmonic.k)));
            }
            if list[..i].iter().any(|other| other.k == harmonic.k) {
                return Err(
                    place().fail(&format!("k = {} stands here twice; add the two terms up", harmonic.k))
                );
            }
        }
        Ok(list.into_iter().map(|h| Harmonic { k: h.k, cos: h.cos, sin: h.sin }).collect())
    };
    let (mut lower, mut upper) = (None, None);
    for (i, keys) in walls.into_iter().enumerate() {
        let path = format!("walls[{}]", i + 1);
        let place = match keys.side {
            Side::Lower => &mut lower,
            Side::Upper => &mut upper,
        };
        if place.is_some() {
            return Err(at(&format!("{path}.side")).fail("there is a wall on this side already"));
        }
        let harmonics = harmonics(keys.harmonics, &format!("{path}.harmonics"))?;
        *place = Some(Wall { offset: keys.offset, harmonics, restitution: keys.restitution });
    }
    Ok(System {
        damping: keys.damping,
        stiffness: keys.stiffness,
        cubic: keys.cubic,
        force: keys.force,
        forcing: harmonics(keys.forcing, "system.forcing")?,
        lower,
        upper,
    })
}

/// The tables of the file but those of the tasks: path, what it is, keys.
pub(super) const TABLES: &[(&str, &str, &[Key])] = &[
    ("the file", File::ABOUT, File::KEYS),
    ("`[system]`", SystemKeys::ABOUT, SystemKeys::KEYS),
    ("an entry of `forcing` or `harmonics`", HarmonicKeys::ABOUT, HarmonicKeys::KEYS),
    ("`[[walls]]`", WallKeys::ABOUT, WallKeys::KEYS),
    ("`[accuracy]`", Accuracy::ABOUT, Accuracy::KEYS),
];
