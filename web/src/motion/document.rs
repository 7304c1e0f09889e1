//! A scene as the page changes it: its parameters, the numbers that stand in it without a name, and the text
//! of the same scene with other values and other tasks, which the command line runs as well.

use std::{collections::BTreeSet, f64::consts::TAU};

use grazing_scenes::{
    Error, Result,
    num_rational::BigRational,
    number::parse_rational,
    scene::{Body, Kind, Scene, SceneFormat},
};
use num_traits::ToPrimitive;
use toml_edit::{Document, DocumentMut, Item, Value};

/// A number that the page has a slider for.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// Its name, the scene's own or the page's.
    pub name: String,
    /// Its value in the scene, as it is written there; with a unit, in the scene's own for that.
    pub value: String,
    /// That unit, if it has one.
    pub unit: Option<String>,
    /// What it is: the comment beside it in the scene, or where it stands.
    pub about: String,
    /// The ends of the slider.
    pub range: [f64; 2],
    /// Where it stands, if the scene has no name for it.
    pub place: Option<Path>,
}

/// Where a value stands in a file, from the top down.
pub type Path = Vec<Step>;

/// A key, or a place in a list from 0.
#[derive(Debug, Clone, PartialEq)]
pub enum Step {
    /// A key of a table.
    Key(String),
    /// An entry of a list.
    Entry(usize),
}

/// A scene that can be changed.
#[derive(Debug, Clone)]
pub struct Changeable {
    /// The file's name, which leads errors.
    pub name: String,
    /// Its text.
    pub text: String,
    /// What it says.
    pub scene: Scene,
    /// Its parameters in their order, then the numbers that it has no names for.
    pub parameters: Vec<Parameter>,
}

/// Values by the names of parameters; exact numbers as text.
pub type Values = Vec<(String, String)>;

impl Changeable {
    /// Reads a scene.
    ///
    /// # Errors
    /// Those of [`Scene::from_toml`].
    pub fn new(text: &str, name: &str) -> Result<Changeable> {
        let scene = Scene::from_toml(text, name)?;
        let document = Document::parse(text).map_err(|error| Error::input(format!("{name}: {error}")))?;
        let root = document.as_item();
        let mut parameters = Vec::new();
        for (name, value) in &scene.parameters {
            let item = root.get("parameters").and_then(|all| all.get(name));
            let unit = scene.unit(name).map(|unit| unit.own.clone());
            let text = match (item, &unit) {
                (Some(item), None) => written(item).unwrap_or_default(),
                _ => in_decimals(value),
            };
            let unit = unit.filter(|unit| !unit.is_empty());
            let about = item.and_then(|item| comment(item, document.raw())).unwrap_or_default();
            let range = range(&scene, name, value);
            parameters.push(Parameter { name: name.clone(), value: text, about, unit, range, place: None });
        }
        let mut taken: BTreeSet<String> = RESERVED.iter().map(ToString::to_string).collect();
        taken.extend(parameters.iter().map(|known| known.name.clone()));
        for Unnamed { place, mut name, about } in unnamed(root) {
            let Some(value) = at(root, &place).and_then(written) else { continue };
            let Ok(number) = parse_rational(&value) else { continue };
            while !taken.insert(name.clone()) {
                name.push('_');
            }
            let range = default_range(&name, &number);
            parameters.push(Parameter { name, value, unit: None, about, range, place: Some(place) });
        }
        let (name, text) = (name.to_string(), text.to_string());
        Ok(Changeable { name, text, scene, parameters })
    }

    /// Where the lower end of a slider is not allowed, as a frequency of 0, it becomes a fiftieth of the
    /// value. Cost: the scene is read once for each parameter.
    pub fn keep_ranges_apart_from_errors(&mut self) {
        for i in 0..self.parameters.len() {
            let Parameter { name, value, range: [low, _], .. } = &self.parameters[i];
            let change = vec![(name.clone(), format!("{low:?}"))];
            let allowed = self.with(&change, "").and_then(|text| Scene::from_toml(&text, &self.name)).is_ok();
            if !allowed && let Some(value) = parse_rational(value).ok().and_then(|value| float(&value)) {
                self.parameters[i].range[0] = if value > 0.0 { value / 50.0 } else { value };
            }
        }
    }

    /// The text of the scene with these values, every number that the page named being a parameter, and with
    /// these tasks in place of its own.
    ///
    /// # Errors
    /// A name that is not among the parameters; a value that is not a number.
    pub fn with(&self, values: &[(String, String)], tasks: &str) -> Result<String> {
        let mut document: DocumentMut =
            self.text.parse().map_err(|error| Error::input(format!("{}: {error}", self.name)))?;
        document.remove("tasks");
        let root = document.as_item_mut();
        for parameter in &self.parameters {
            let new = self.checked(values, &parameter.name)?;
            let Some(place) = &parameter.place else {
                let item = root.get_mut("parameters").and_then(|all| all.get_mut(&parameter.name));
                if let (Some(item), Some(new)) = (item, new) {
                    let is_bare = parse_rational(&new).is_ok();
                    match parameter.unit.as_deref().filter(|_| is_bare) {
                        Some(unit) => replace_by(item, Value::from(in_unit(&new, unit))),
                        None => replace(item, &new),
                    }
                }
                continue;
            };
            if let Some(item) = at_mut(root, place) {
                replace_by(item, Value::from(parameter.name.clone()));
            }
            if root.get("parameters").is_none() {
                root["parameters"] = toml_edit::table();
            }
            root["parameters"][&parameter.name] =
                Item::Value(number(new.as_ref().unwrap_or(&parameter.value)));
        }
        self.known(values)?;
        let text = document.to_string();
        Ok(if tasks.is_empty() { text } else { format!("{}\n\n{}\n", text.trim_end(), tasks.trim()) })
    }

    /// The scene's own text, line by line as it is, with these values for the numbers that it has no names
    /// for; and the values of its own parameters, as `--set` takes them.
    ///
    /// # Errors
    /// As [`with`](Self::with).
    pub fn in_place(&self, values: &[(String, String)]) -> Result<(String, Vec<(String, BigRational)>)> {
        self.known(values)?;
        let document =
            Document::parse(&self.text).map_err(|error| Error::input(format!("{}: {error}", self.name)))?;
        let (mut edits, mut changes) = (Vec::new(), Vec::new());
        for parameter in &self.parameters {
            let Some(new) = self.checked(values, &parameter.name)? else { continue };
            match &parameter.place {
                None => changes.extend(self.scene.values(&[(&parameter.name, &new)])?),
                Some(place) => {
                    if let Some(span) = at(document.as_item(), place).and_then(Item::span) {
                        edits.push((span, number(&new).to_string()));
                    }
                }
            }
        }
        edits.sort_by_key(|(span, _)| std::cmp::Reverse(span.start));
        let mut text = self.text.clone();
        for (span, new) in edits {
            text.replace_range(span, new.trim());
        }
        Ok((text, changes))
    }

    /// The new value of a parameter, if it has one that differs from the scene's.
    fn checked(&self, values: &[(String, String)], name: &str) -> Result<Option<String>> {
        let Some((_, new)) = values.iter().find(|(known, _)| known == name) else { return Ok(None) };
        let old = self.parameters.iter().find(|known| known.name == name);
        // Its own parameters are read as by `--set`, in any unit.
        let value = match (parse_rational(new), old) {
            (Ok(value), _) => value,
            (Err(_), Some(Parameter { unit: Some(_), .. })) => self.scene.values(&[(name, new)])?.remove(0).1,
            (Err(error), _) => return Err(Error::from(error).context(format_args!("parameter {name}"))),
        };
        let same = old.is_some_and(|old| parse_rational(&old.value).is_ok_and(|old| old == value));
        Ok((!same).then(|| new.trim().to_string()))
    }

    fn known(&self, values: &[(String, String)]) -> Result<()> {
        let names = || self.parameters.iter().map(|known| known.name.as_str());
        match values.iter().find(|(name, _)| !names().any(|known| known == name)) {
            None => Ok(()),
            Some((name, _)) => {
                let all: Vec<&str> = names().collect();
                Err(Error::input(format!(
                    "the scene has no parameter {name:?}; there are {}",
                    all.join(", ")
                )))
            }
        }
    }
}

/// Names that mean something in expressions.
const RESERVED: [&str; 12] = ["q", "u", "t", "v", "pi", "sqrt", "exp", "sin", "cos", "log", "tanh", "e"];

/// A number of the scene that has no name there.
struct Unnamed {
    place: Path,
    name: String,
    about: String,
}

fn key(name: &str) -> Step {
    Step::Key(name.into())
}

/// The numbers of the equation of motion and of the walls that stand alone: no entries of matrices, and no 0
/// that says that an effect is not there.
fn unnamed(root: &Item) -> Vec<Unnamed> {
    let mut all = Vec::new();
    let mut add = |place: Path, name: String, about: String, zero: bool| {
        let Some(text) = at(root, &place).and_then(written) else { return };
        if parse_rational(&text).is_ok_and(|value| zero || value != BigRational::default()) {
            all.push(Unnamed { place, name, about });
        }
    };
    for (name, about) in [
        ("damping", "damping"),
        ("damping_ratio", "damping ratio of every mode"),
        ("stiffness", "stiffness"),
        ("cubic", "cubic stiffness"),
        ("mass", "mass"),
        ("force", "constant force"),
        ("frequency", "frequency of the forcing"),
        ("period", "period of the forcing"),
    ] {
        add(vec![key("system"), key(name)], name.into(), about.into(), name == "damping");
    }
    let length = |item: Option<&Item>| -> usize {
        item.map_or(0, |item| match (item.as_array_of_tables(), item.as_array()) {
            (Some(tables), _) => tables.len(),
            (_, Some(array)) => array.len(),
            _ => 0,
        })
    };
    let mut harmonics = |list: Path, prefix: &str, what: &str| {
        let item = at(root, &list);
        for i in 0..length(item) {
            let k = item.and_then(|item| item.get(i)?.get("k")?.as_integer()).unwrap_or(1);
            for part in ["cos", "sin"] {
                let place: Path = list.iter().cloned().chain([Step::Entry(i), key(part)]).collect();
                let times = if k == 1 { String::new() } else { k.to_string() };
                let about = format!("{what}: coefficient of {part} {times}t");
                let entries = length(at(root, &place));
                if entries == 0 {
                    add(place, format!("{prefix}_{part}{times}"), about, false);
                } else {
                    for j in 0..entries {
                        let place = place.iter().cloned().chain([Step::Entry(j)]).collect();
                        let name = format!("{prefix}_{part}{times}_{}", j + 1);
                        add(place, name, format!("{about}, coordinate {}", j + 1), false);
                    }
                }
            }
        }
    };
    harmonics(vec![key("system"), key("forcing")], "forcing", "forcing");
    let heading = if root.get("stops").is_some() { "stops" } else { "walls" };
    let walls = root.get(heading);
    let several = length(walls) > 1;
    let mut stops = Vec::new();
    for i in 0..length(walls) {
        let wall = walls.and_then(|walls| walls.get(i));
        let called = |key: &str| wall.and_then(|wall| wall.get(key)?.as_str());
        let own = called("name").or(called("side")).map_or_else(|| (i + 1).to_string(), ToString::to_string);
        let word: String = own.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
        let end = if several { format!("_{word}") } else { String::new() };
        let list: Path = vec![key(heading), Step::Entry(i), key("harmonics")];
        harmonics(list, &format!("wall{end}"), &format!("motion of the stop “{own}”"));
        stops.push((i, own, end));
    }
    for (i, own, end) in stops {
        for (name, about) in [
            ("offset", "where it is"),
            ("restitution", "coefficient of restitution"),
            ("stiffness", "stiffness"),
            ("damping", "damping"),
        ] {
            let prefix = if matches!(name, "stiffness" | "damping") { "wall_" } else { "" };
            let place = vec![key(heading), Step::Entry(i), key(name)];
            add(place, format!("{prefix}{name}{end}"), format!("stop “{own}”: {about}"), true);
        }
    }
    all
}

/// What an orbit's stops are called in the format of a scene.
pub fn stops(scene: &Scene) -> &'static str {
    if scene.format == SceneFormat::One { "walls" } else { "stops" }
}

/// A time in an orbit's `start`, a fraction of the period, as a scene writes it: of format 1 in radians.
pub fn time(scene: &Scene, t: f64) -> String {
    let unit = if scene.format == SceneFormat::One { TAU } else { 1.0 };
    format!("{:?}", unit * t)
}

fn at<'a>(root: &'a Item, path: &[Step]) -> Option<&'a Item> {
    path.iter().try_fold(root, |item, step| match step {
        Step::Key(key) => item.get(key.as_str()),
        Step::Entry(i) => item.get(*i),
    })
}

fn at_mut<'a>(root: &'a mut Item, path: &[Step]) -> Option<&'a mut Item> {
    path.iter().try_fold(root, |item, step| match step {
        Step::Key(key) => item.get_mut(key.as_str()),
        Step::Entry(i) => item.get_mut(*i),
    })
}

/// A number, or text, as it is written.
fn written(item: &Item) -> Option<String> {
    match item.as_value()? {
        Value::String(text) => Some(text.value().clone()),
        number @ (Value::Integer(_) | Value::Float(_)) => Some(number.to_string().trim().replace('_', "")),
        _ => None,
    }
}

/// The comment on the line of a value.
fn comment(item: &Item, text: &str) -> Option<String> {
    let line = text.get(item.span()?.end..)?.lines().next()?;
    let (before, comment) = line.split_once('#')?;
    before.trim().is_empty().then(|| comment.trim().to_string())
}

/// A number as TOML: bare where TOML has it, else as text.
fn number(text: &str) -> Value {
    match text.trim().parse::<Value>() {
        Ok(value @ (Value::Integer(_) | Value::Float(_))) => value,
        _ => Value::from(text.trim()),
    }
}

fn replace(item: &mut Item, new: &str) {
    replace_by(item, number(new));
}

/// Puts a value in the place of another; spaces and comments around it stay.
fn replace_by(item: &mut Item, mut new: Value) {
    if let Some(old) = item.as_value() {
        *new.decor_mut() = old.decor().clone();
    }
    *item = Item::Value(new);
}

/// The nearest `f64`, if there is a finite one.
pub fn float(x: &BigRational) -> Option<f64> {
    x.to_f64().filter(|x| x.is_finite())
}

/// The range in which the first of the scene's own tasks that varies a parameter varies it, or one about its
/// value.
fn range(scene: &Scene, name: &str, value: &BigRational) -> [f64; 2] {
    let found = scene.tasks.iter().find_map(|task| {
        let [low, high] = match &task.kind {
            Kind::BranchTask(task) if task.parameter == name => [*task.range.first()?, *task.range.get(1)?],
            Kind::DiagramTask(task) if task.parameter == name => {
                [float(task.range.first()?)?, float(task.range.get(1)?)?]
            }
            _ => return None,
        };
        Some([low.min(high), low.max(high)])
    });
    let value_now = float(value).unwrap_or(0.0);
    match found {
        Some([low, high]) => [low.min(value_now), high.max(value_now)],
        None if is_restitution(scene, name) => [0.0, value_now.max(1.0)],
        None => default_range(name, value),
    }
}

/// Whether a parameter is a wall's restitution and nothing else.
fn is_restitution(scene: &Scene, name: &str) -> bool {
    let Body::Oscillator(system) = &scene.body else { return false };
    let own = |wall: &grazing_scenes::motion::Wall<grazing_scenes::scene::Expression>| {
        wall.restitution.to_string().trim() == name
    };
    system.lower.iter().chain(&system.upper).any(own)
}

/// From 0 to twice the value, about 0 if it is 0; a restitution goes from 0 to 1.
fn default_range(name: &str, value: &BigRational) -> [f64; 2] {
    let value = float(value).unwrap_or(0.0);
    if name.starts_with("restitution") {
        return [0.0, value.max(1.0)];
    }
    match value {
        0.0 => [-1.0, 1.0],
        positive if positive > 0.0 => [0.0, 2.0 * positive],
        negative => [2.0 * negative, 0.0],
    }
}

/// An exact number: in decimals where these are few, else a fraction.
fn in_decimals(value: &BigRational) -> String {
    let decimals = float(value).map(|value| value.to_string());
    let decimals = decimals.filter(|text| parse_rational(text).is_ok_and(|same| same == *value));
    decimals.unwrap_or_else(|| value.to_string())
}

/// A number in a unit.
pub fn in_unit(number: &str, unit: &str) -> String {
    let plain = number.chars().all(|c| c.is_ascii_digit() || matches!(c, '.' | '-'));
    if plain { format!("{number} {unit}") } else { format!("({number}) {unit}") }
}

/// A name as TOML has it between quotes.
pub fn quoted(text: &str) -> String {
    Value::from(text).to_string().trim().to_string()
}
