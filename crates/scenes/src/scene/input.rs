//! A scene from TOML text.

use std::{
    collections::{BTreeMap, HashSet},
    path::Path,
    sync::Arc,
};

use num_rational::BigRational;
use num_traits::Signed;
use toml_edit::{Item, Table};

use super::{
    format::{Foreign, SceneFormat, translate},
    grammar::is_name,
    keys::{Entry, Key, Record, Scope, Seen, StopName, Value, keys},
    linear,
    machine::MachineScene,
    machine::{measured_motion, name, period},
    measured::MeasuredForce,
    oscillator::{Disqualified, oscillator},
    quantity::{Kinds, Scale, WrittenUnit},
    scene::{Body, Engine, Scene},
    system::{Accuracy, EngineKey, EventKeys, FrictionKeys, StopKeys, SystemKeys},
    task::{Kind, Task},
    units::{SiUnits, UnitKeys},
    wanted::{self, Coordinates},
};
use crate::{
    error::Result,
    output::{LONGEST_SCENE, read_text},
    quantity::Dimension,
    source::Source,
};

/// The most parameters and tasks of a scene: each task takes the parameters along, and is checked with them.
const MOST_PARAMETERS: usize = 1000;
const MOST_TASKS: usize = 10_000;

keys! {
    /// The top level of a scene.
    pub struct File {
        /// `"grazing-scene 3"`
        format: String,
        /// what it is
        title: String,
        /// what computes its motions ([engines](#the-two-engines)); `auto` takes `one` where the system
        /// qualifies
        engine: EngineKey = "\"auto\"",
        /// names and their values, with units too; `--set` and a task's `set` change them
        parameters: Parameters = "{}",
        /// the equations of motion
        system: SystemKeys,
        /// the stops
        stops: Vec<StopKeys> = "[]",
        /// the dry friction
        friction: Vec<FrictionKeys> = "[]",
        /// thresholds that are told where motions pass them
        events: Vec<EventKeys> = "[]",
        /// what the numbers' units are
        units: Option<UnitKeys>,
        /// how accurately to compute
        accuracy: Accuracy = "{}",
        /// what to do
        tasks: Tasks = "[]",
    }
}

/// Names and values.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Parameters;

/// The tasks, which are read once parameters and stops are known.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tasks;

impl Value for Parameters {
    fn shape() -> String {
        "table of numbers".to_string()
    }

    fn read(_: &Entry) -> Result<Self> {
        Ok(Parameters)
    }
}

impl Value for Tasks {
    fn shape() -> String {
        "list of tasks".to_string()
    }

    fn read(_: &Entry) -> Result<Self> {
        Ok(Tasks)
    }
}

/// The measured motions of stops, by name: from here on these are their harmonics, whatever computes.
fn moved(file: &Entry, read: &mut File) -> Result<Vec<(String, MeasuredForce)>> {
    let SystemKeys { frequency, period: given, .. } = &read.system;
    let mut all = Vec::new();
    for (i, keys) in (1..).zip(&mut read.stops).filter(|(_, keys)| keys.measured.is_some()) {
        if read.system.measured.as_ref().is_some_and(|force| force.once) {
            let why = "is periodic, and the force is a record of one run (once = true): give `harmonics`";
            return Err(file.at(&format!("stops[{i}].measured")).fail(why));
        }
        let forcing = period(file, frequency.clone(), given.clone(), None)?;
        let found = measured_motion(file, i, keys, &forcing)?;
        all.extend(found.map(|found| (name(keys, i), found)));
    }
    Ok(all)
}

impl Scene {
    /// Reads a scene from a TOML file, whose path leads every error message. Matrices that the scene keeps in
    /// files of their own are read beside it. The format is in docs/scenes.md.
    ///
    /// ```
    /// use grazing_scenes::scene::Scene;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))?;
    /// let scene = Scene::read("examples/scenes/nordmark-2001.toml")?;
    /// assert_eq!(scene.parameters[0].0, "d");
    /// assert!(Scene::read("no/such/scene.toml").unwrap_err().is_io());
    /// # Ok::<(), grazing_scenes::Error>(())
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
    /// cross, a negative restitution, a start behind a stop, with the scene's parameters and with those of
    /// each task.
    ///
    /// ```
    /// use grazing_scenes::scene::Scene;
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
    /// # Ok::<(), grazing_scenes::Error>(())
    /// ```
    pub fn from_toml(text: &str, name: &str) -> Result<Scene> {
        let source = Source { text, name };
        let document = source.document()?;
        let mut root = document.as_table().clone();
        let format = format(&source, &root)?;
        let clash = |foreign: Foreign| source.fail(foreign.span, &foreign.message);
        translate(&mut root, format, &|value| source.number_text(value)).map_err(clash)?;
        let (seen, root) = (Seen::default(), Item::Table(root));
        let scope = |names, stops, quantities| Scope {
            source: source.clone(),
            format,
            names,
            stops,
            quantities,
            seen: &seen,
        };
        let top = |scope, item: &Item| Entry { scope, path: String::new(), span: None, item: item.clone() };
        let unitless = scope(&[], &[], None);
        let file = top(&unitless, &root);
        file.only(&File::KEYS.iter().map(|key| key.name).collect::<Vec<_>>())?;
        let units = file.get("units")?.map(|entry| UnitKeys::read(&entry)).transpose()?;
        let (scale, none) = (Scale::new(units.map(|keys| keys.symbols())), Kinds::new());
        // Other formats have no units.
        let is_third = format == SceneFormat::Three;
        let nameless = scope(&[], &[], is_third.then_some((&scale, &none)));
        let (parameters, written) = match top(&nameless, &root).get("parameters")? {
            Some(entry) => parameters(&entry)?,
            None => (Vec::new(), BTreeMap::new()),
        };
        let kinds: Kinds = seen
            .measured
            .take()
            .into_iter()
            .map(|(path, kind)| (path[PARAMETERS..].to_string(), kind))
            .collect();
        let quantities = is_third.then_some((&scale, &kinds));
        let names: Vec<String> = parameters.iter().map(|(name, _)| name.clone()).collect();
        let stopless = scope(&names, &[], quantities);
        let file = top(&stopless, &root);
        let mut read = File::fields(&file, &[])?;
        let moved = moved(&file, &mut read)?;
        let known = Known { file: &file, format, parameters: &parameters };
        let (stops, body, engine, whole) = known.body(&read, moved)?;
        let mass = match body {
            Body::Oscillator(_) => read.system.mass.as_ref().and_then(|mass| mass.entries.first()),
            Body::Machine(_) => None,
        };
        let mass = mass.map(|(_, _, mass)| mass.clone());
        let all = scope(&names, &stops, quantities);
        let tasks = match top(&all, &root).get("tasks")? {
            Some(entry) => entry.elements()?.iter().map(Task::read).collect::<Result<_>>()?,
            None => Vec::new(),
        };
        let measured = seen.measured.take();
        // A scene of plain numbers has no dimensions, whatever percentages are in it.
        let is_inertia = |(path, kind): &(String, Dimension)| {
            path.starts_with("system.mass") && kind.is_like(Dimension::of(2, 0, 1))
        };
        let several = whole.machine.points() != 1;
        let turns = measured.iter().any(is_inertia);
        if seen.scaled.get() {
            let coordinates = Coordinates { several, turns };
            let named = |path: &str, key: &str| named(&root, path, key);
            wanted::check(&file, &measured, (&scale, &kinds), coordinates, &named)?;
        }
        let si = read.units.map(|keys| keys.si()).or(seen.scaled.get().then_some(SiUnits::SI));
        let used = seen.used.take();
        let idle = names.iter().filter(|name| !used.contains(*name)).cloned().collect();
        let scene = Scene {
            title: read.title,
            parameters,
            body,
            engine,
            stops,
            whole,
            mass,
            accuracy: read.accuracy,
            units: si,
            turns: Some(turns).filter(|turns| !(several && *turns)),
            written: Arc::new(written),
            quantities: Arc::new((scale.clone(), kinds.clone())),
            idle: Arc::new(idle),
            tasks,
            format,
            file: Arc::new((name.to_string(), text.to_string())),
            places: Arc::new(seen.places.take()),
            files: Arc::new(seen.files.take()),
        };
        scene.check_whole()?;
        Ok(scene)
    }

    /// What no single key says: numbers within their ranges, a system that can be computed, tasks of which
    /// each can be done.
    fn check_whole(&self) -> Result<()> {
        if !(1e-15..=1e-3).contains(&self.accuracy.tolerance) {
            return Err(self.fail("accuracy.tolerance", "is outside 1e-15 to 1e-3"));
        }
        if self.accuracy.minimum_depth.is_some_and(|depth| depth.is_nan() || depth <= 0.0) {
            return Err(self.fail("accuracy.minimum_depth", "must be positive"));
        }
        match self.body {
            Body::Oscillator(_) => self.rounded().map(|_| ())?,
            Body::Machine(_) => self.machine(&[]).map(|_| ())?,
        }
        for (count, most, key) in
            [(self.parameters.len(), MOST_PARAMETERS, "parameters"), (self.tasks.len(), MOST_TASKS, "tasks")]
        {
            if count > most {
                return Err(self.fail(key, &format!("{count} of them: at most {most}")));
            }
        }
        let mut names = HashSet::new();
        for task in &self.tasks {
            if !names.insert(&task.name) {
                let key = format!("{}.name", task.path);
                return Err(
                    self.fail(&key, "is the name of an earlier task too; its files would be overwritten")
                );
            }
            self.for_task(task, &[])?;
        }
        let watched = self.machine_scene().is_ok_and(|scene| !scene.events.is_empty());
        let tells = |task: &Task| matches!(task.kind, Kind::SimulateTask(_) | Kind::SectionTask(_));
        if watched && !self.tasks.iter().any(tells) {
            let why = "are told by tasks `simulate` and `section` alone, and there is none";
            return Err(self.fail("events", why));
        }
        Ok(())
    }
}

/// The format that a file names; without a name that of format 3, which then fails for want of it.
fn format(source: &Source, root: &Table) -> Result<SceneFormat> {
    let Some(item) = root.get("format") else { return Ok(SceneFormat::Three) };
    let known = |word| SceneFormat::ALL.into_iter().find(|known| known.0 == word);
    item.as_str().and_then(known).map(|known| known.1).ok_or_else(|| {
        let words = SceneFormat::ALL.map(|known| format!("{:?}", known.0)).join(", ");
        let span = item.span().or(root.key("format").and_then(toml_edit::Key::span));
        source.at("format", span, &format!("this version reads {words}"))
    })
}

/// What is known once all keys but those of tasks are read.
struct Known<'a> {
    file: &'a Entry<'a>,
    format: SceneFormat,
    parameters: &'a [(String, BigRational)],
}

impl Known<'_> {
    /// The stops, what the scene is about, the engine for it, and the scene as a machine.
    fn body(
        &self,
        read: &File,
        moved: Vec<(String, MeasuredForce)>,
    ) -> Result<(Vec<StopName>, Body, Engine, Arc<MachineScene>)> {
        let (file, depth) = (self.file, read.accuracy.minimum_depth);
        let machine = {
            let held = (read.stops.clone(), read.friction.clone(), read.events.clone());
            Arc::new(MachineScene::new(file, read.system.clone(), held, moved, depth)?)
        };
        let names = || machine.machine.stops.iter().map(|stop| stop.name.clone());
        let one = match oscillator(file, &read.system, &read.stops)? {
            Ok(found) if self.format == SceneFormat::One => Ok(found),
            Ok(_) if !read.friction.is_empty() => {
                Err(Disqualified { key: "friction".into(), why: "has dry friction".into() })
            }
            Ok(_) if !read.events.is_empty() => {
                Err(Disqualified { key: "events".into(), why: "has events".into() })
            }
            Ok((sides, system)) => self.has_weight(read).map(|()| (sides, system)),
            Err(why) => Err(why),
        };
        let why_many = match (one, self.format, read.engine) {
            (
                Ok((sides, system)),
                SceneFormat::One | SceneFormat::Three,
                EngineKey::Auto | EngineKey::One,
            ) => {
                let stops = names().zip(sides).map(|(name, side)| StopName { name, side: Some(side) });
                let reason = "one degree of freedom and rigid stops".to_string();
                let engine = Engine { name: EngineKey::One, reason };
                let (stops, body) = (stops.collect(), Body::Oscillator(Arc::new(system)));
                return Ok((stops, body, engine, machine.clone()));
            }
            (Err(Disqualified { key, why }), SceneFormat::One, _) => {
                let newer = SceneFormat::Three.word();
                return Err(file.at(&key).fail(&format!("{why}; write format = {newer:?}")));
            }
            (Err(Disqualified { key, why }), _, EngineKey::One) => {
                return Err(file.at("engine").fail(&format!("is for other systems: this one {why} ({key})")));
            }
            (_, SceneFormat::Two, _) => format!("the scene is of format {:?}", SceneFormat::Two.word()),
            (Ok(_), ..) => "the scene asks for it".to_string(),
            (Err(Disqualified { why, .. }), ..) => format!("the system {why}"),
        };
        if file.scope.seen.places.borrow().contains_key("accuracy.tolerance") {
            let message = format!("is of the engine \"one\"; this scene is computed by \"many\": {why_many}");
            return Err(file.at("accuracy.tolerance").fail(&message));
        }
        let stops = names().map(|name| StopName { name, side: None }).collect();
        let engine = Engine { name: EngineKey::Many, reason: why_many };
        // What is computed; what is drawn and listed is as it is written.
        let own = linear::coefficients(&machine.machine).map_or_else(
            || machine.clone(),
            |own| Arc::new(MachineScene { machine: own, ..machine.as_ref().clone() }),
        );
        Ok((stops, Body::Machine(own), engine, machine))
    }

    /// Whether the mass is positive.
    fn has_weight(&self, read: &File) -> std::result::Result<(), Disqualified> {
        let exact: Vec<_> = self.parameters.iter().map(|(_, value)| value.clone()).collect();
        let mass = read.system.mass.as_ref().and_then(|mass| mass.entries.first());
        if let Some((_, _, mass)) = mass
            && mass.evaluate(&exact, &()).is_ok_and(|mass| !mass.is_positive())
        {
            let why = "has a mass that is not positive".to_string();
            return Err(Disqualified { key: mass.key.clone(), why });
        }
        Ok(())
    }
}

/// The bytes of `parameters.` before a parameter's name.
const PARAMETERS: usize = "parameters.".len();

/// The parameters with their values, and the units of those that were written with one.
type Parameterised = (Vec<(String, BigRational)>, BTreeMap<String, WrittenUnit>);

fn parameters(entry: &Entry) -> Result<Parameterised> {
    let (mut all, mut written) = (Vec::new(), BTreeMap::new());
    for (name, _) in entry.table()?.iter() {
        let Some(value) = entry.get(name)? else { continue };
        if !is_name(name) {
            return Err(value.fail("the name of a parameter is a letter, then letters, digits and _"));
        }
        let text = value.item.as_str().map(str::to_string);
        let found = text.map(|text| value.quantity(&text, &[])).transpose()?.flatten();
        if name == "pi" && value.scope.format == SceneFormat::Three {
            return Err(value.fail("is 3.14159… in every expression, and no parameter: give it another name"));
        }
        all.push((
            name.to_string(),
            match &found {
                Some(found) => found.value().map_err(|error| value.fail(&error.to_string()))?,
                None => value.number()?,
            },
        ));
        written.extend(found.and_then(|found| found.unit).map(|unit| (name.to_string(), unit)));
    }
    Ok((all, written))
}

/// What a key of the task says in which a path is.
fn named(root: &Item, path: &str, key: &str) -> Option<String> {
    let place: usize = path.strip_prefix("tasks[")?.split(']').next()?.parse().ok()?;
    let tasks = root.get("tasks")?;
    let task = match tasks {
        Item::ArrayOfTables(tables) => tables.get(place - 1)?.get(key)?.as_str(),
        tasks => tasks.as_array()?.get(place - 1)?.as_inline_table()?.get(key)?.as_str(),
    };
    task.map(str::to_string)
}

/// The table of the whole file: path, what it is, keys.
pub(super) const FILE: (&str, &str, &[Key]) = ("the file", File::ABOUT, File::KEYS);
