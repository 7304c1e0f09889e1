//! A scene as TOML, and all the numbers in it with their units: what forms of a scene are made of.

use toml::{Table, Value};

/// The powers of length, time and mass in a unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Unit(pub i32, pub i32, pub i32);

/// Without a unit.
pub const ONE: Unit = Unit(0, 0, 0);
pub const LENGTH: Unit = Unit(1, 0, 0);
pub const SPEED: Unit = Unit(1, -1, 0);

/// What a number of a scene is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum What {
    /// An entry of the mass matrix, or a shape.
    Inertia,
    /// A coefficient of the velocity or the displacement.
    Linear,
    /// A force, of a direction: it turns with the coordinates.
    Force,
    /// A force as a formula of displacement, velocity and time.
    Formula,
    /// Where a wall is; of format 1 it turns with the coordinates.
    Place,
    /// What a stop gives back.
    Restitution,
    /// A stiffness, damping or coefficient of wear of a stop, a normal force, a coefficient of friction.
    Stop,
    /// The force of a stop as a formula of depth and speed.
    Law,
    /// An entry of a stop's row.
    Row,
    /// The period, the frequency.
    Clock,
    /// Where a motion starts: it turns with the coordinates.
    Start,
    /// A bound that does not turn: a greatest speed, a depth.
    Bound,
    /// How far from a grazing orbits are looked for.
    Distance,
}

/// A number of a scene: a TOML number, or an expression as text.
pub struct Slot<'a> {
    pub what: What,
    pub unit: Unit,
    /// Whether it must stay a number.
    pub plain: bool,
    /// Of a matrix or list, which entries it is of.
    pub entry: [usize; 2],
    pub value: &'a mut Value,
}

impl Slot<'_> {
    /// Its text as an expression.
    pub fn text(&self) -> String {
        text(self.value)
    }

    /// Whether it is written as a zero.
    pub fn is_zero(&self) -> bool {
        self.text().parse::<f64>() == Ok(0.0)
    }

    /// Puts an expression in its place, `{}` standing for what is there; zeros stay.
    pub fn wrap(&mut self, around: &str) {
        if !self.is_zero() {
            *self.value = Value::String(around.replace("{}", &self.text()));
        }
    }

    /// Multiplies by a power of two, or its negative: exactly.
    pub fn scale(&mut self, factor: f64) {
        if self.plain {
            let number: f64 = self.text().parse().expect("a number");
            *self.value = Value::Float(number * factor);
        } else if factor != 1.0 {
            self.wrap(&format!("({})*({{}})", exact(factor)));
        }
    }
}

/// A power of two as a fraction.
pub fn exact(factor: f64) -> String {
    if factor.abs() >= 1.0 {
        format!("{factor}")
    } else {
        format!("{}/{}", factor.signum(), 1.0 / factor.abs())
    }
}

/// A TOML number or text as an expression.
pub fn text(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Float(number) => format!("{number:?}"),
        other => other.to_string(),
    }
}

/// Whether the scene is of the engine `many`: of format 2, or of format 3, which is for what format 2 lacks.
pub fn is_machine(scene: &Table) -> bool {
    scene["format"].as_str() != Some("grazing-scene 1")
}

/// What the list of stops is called.
pub fn stops_key(scene: &Table) -> &'static str {
    if scene["format"].as_str() == Some("grazing-scene 3") { "stops" } else { "walls" }
}

/// The stops.
pub fn stops(scene: &mut Table) -> impl Iterator<Item = &mut Table> + use<'_> {
    let key = stops_key(scene);
    list(scene, key)
}

/// Whether some row has dry friction.
pub fn has_friction(scene: &Table) -> bool {
    scene.contains_key("friction")
}

/// All that moves or stands against the machine: stops, and surfaces with friction.
pub fn surfaces(scene: &mut Table, look: &mut dyn FnMut(&mut Table)) {
    stops(scene).for_each(&mut *look);
    list(scene, "friction").for_each(look);
}

/// Of a machine of one coordinate rows may be left out.
pub fn with_rows(scene: &mut Table) {
    surfaces(scene, &mut |surface| {
        surface.entry("row").or_insert(Value::Array(vec![Value::Integer(1)]));
    });
}

/// Stops and friction without a name are called by their places: with them these stay with their tables.
pub fn with_names(scene: &mut Table) {
    for (i, stop) in (1..).zip(stops(scene)) {
        stop.entry("name").or_insert(Value::String(format!("{i}")));
    }
    let alone = list(scene, "friction").count() == 1;
    for (i, friction) in (1..).zip(list(scene, "friction")) {
        let name = if alone { "friction".into() } else { format!("friction {i}") };
        friction.entry("name").or_insert(Value::String(name));
    }
}

/// A stop on a side of a single coordinate as a row.
pub fn side_as_row(stop: &mut Table) -> Option<()> {
    let side = stop.remove("side")?;
    let upper = side.as_str() == Some("upper");
    stop.insert("row".into(), Value::Array(vec![Value::Integer(if upper { -1 } else { 1 })]));
    stop.entry("name").or_insert(side);
    if upper {
        stop["offset"] = Value::String(format!("-({})", text(&stop["offset"])));
        for harmonic in list(stop, "harmonics") {
            for key in ["cos", "sin"] {
                if let Some(value) = harmonic.get_mut(key) {
                    *value = Value::String(format!("-({})", text(value)));
                }
            }
        }
    }
    Some(())
}

/// A whole number of a table, where it is more.
pub fn at_most(table: &mut Table, key: &str, most: i64) {
    if let Some(value) = table.get_mut(key)
        && value.as_integer().is_some_and(|number| number > most)
    {
        *value = Value::Integer(most);
    }
}

/// Fewer and shorter tasks: what is integrated takes ten to a hundred times as long. Branches and events
/// are followed for a sixth of their way at most, from orbits and not from attractors; motions last tens of
/// periods.
pub fn brief(scene: &mut Table) {
    let number = |value: &Value| text(value).parse::<f64>().ok();
    let parameters = scene.get("parameters").and_then(Value::as_table).cloned().unwrap_or_default();
    if let Some(tasks) = scene.get_mut("tasks").and_then(Value::as_array_mut) {
        tasks.retain(|task| {
            let starts = task.get("starts").and_then(Value::as_array);
            !starts.is_some_and(|all| all.iter().any(|start| start.get("attractor").is_some()))
        });
    }
    for task in list(scene, "tasks") {
        for (key, most) in
            [("transient", 40), ("points", 20), ("periods", 6), ("max_period", 1), ("longest", 8)]
        {
            at_most(task, key, most);
        }
        if task["kind"].as_str() != Some("map") {
            at_most(task, "count", 2);
        }
        if let Some(orbit) = task.get_mut("orbit").and_then(Value::as_table_mut) {
            at_most(orbit, "starts", 1);
        }
        for key in ["q", "u"] {
            if let Some(values) = task.get_mut(key).and_then(Value::as_table_mut) {
                at_most(values, "count", 2);
            }
        }
        if ["section", "diagram"].contains(&task["kind"].as_str().unwrap_or(""))
            && let Some(starts) = task.get_mut("starts").and_then(Value::as_array_mut)
        {
            starts.truncate(1);
        }
        if task["kind"].as_str() == Some("event") {
            task.insert("reach".into(), Value::Float(0.15625));
        }
        let value =
            task.get("parameter").and_then(Value::as_str).and_then(|name| number(parameters.get(name)?));
        if let (Some(value), Some("branch")) = (value, task["kind"].as_str())
            && let Some(range) = task.get_mut("range").and_then(Value::as_array_mut)
            && let [Some(low), Some(high)] = [number(&range[0]), number(&range[1])]
        {
            let part = (high - low) / 24.0;
            *range = vec![Value::Float(low.max(value - part)), Value::Float(high.min(value + part))];
        }
        if let Some(values) = task.get_mut("values").and_then(Value::as_array_mut)
            && values.len() > 1
        {
            *values = vec![values[values.len() / 2].clone()];
        }
    }
}

/// How many coordinates its formulas, rows and starts have.
pub fn coordinates(scene: &Table) -> usize {
    let system = scene["system"].as_table().expect("a table");
    let rows = |value: &Value| match value {
        Value::Array(rows) => rows.len(),
        Value::Table(diagonal) => diagonal.get("diagonal").and_then(Value::as_array).map_or(0, Vec::len),
        _ => 1,
    };
    match (system.get("mass"), system.get("modes")) {
        (Some(mass), _) => rows(mass),
        (_, Some(modes)) => match modes.get("shapes") {
            Some(shapes) => rows(shapes),
            None => rows(&modes["frequencies"]),
        },
        _ => 1,
    }
}

/// Shows every number of a scene to `look`, parameters and their values apart.
pub fn each_number(scene: &mut Table, look: &mut dyn FnMut(Slot)) {
    let machine = is_machine(scene);
    if let Some(system) = scene.get_mut("system").and_then(Value::as_table_mut) {
        if machine { of_machine(system, look) } else { of_oscillator(system, look) }
    }
    for wall in stops(scene) {
        visit(wall, "offset", (What::Place, LENGTH), look);
        harmonics(wall, "harmonics", (What::Place, LENGTH), look);
        visit(wall, "restitution", (What::Restitution, ONE), look);
        visit(wall, "row", (What::Row, ONE), look);
        visit(wall, "stiffness", (What::Stop, Unit(0, -2, 1)), look);
        visit(wall, "damping", (What::Stop, Unit(0, -1, 1)), look);
        visit(wall, "law", (What::Law, Unit(1, -2, 1)), look);
        // A volume for an energy.
        visit(wall, "wear", (What::Stop, Unit(1, 2, -1)), look);
    }
    for friction in list(scene, "friction") {
        visit(friction, "row", (What::Row, ONE), look);
        visit(friction, "normal", (What::Stop, Unit(1, -2, 1)), look);
        visit(friction, "coefficient", (What::Stop, ONE), look);
        visit(friction, "static_coefficient", (What::Stop, ONE), look);
        // What is along a row that turns does not.
        visit(friction, "speed", (What::Place, SPEED), look);
        harmonics(friction, "harmonics", (What::Place, LENGTH), look);
    }
    if let Some(accuracy) = scene.get_mut("accuracy").and_then(Value::as_table_mut) {
        plain(accuracy, "minimum_depth", (What::Bound, LENGTH), look);
    }
    for task in list(scene, "tasks") {
        of_task(task, look);
    }
}

fn of_oscillator(system: &mut Table, look: &mut dyn FnMut(Slot)) {
    visit(system, "damping", (What::Linear, Unit(0, -1, 0)), look);
    visit(system, "stiffness", (What::Linear, Unit(0, -2, 0)), look);
    visit(system, "cubic", (What::Linear, Unit(-2, -2, 0)), look);
    force(system, Unit(1, -2, 0), look);
    harmonics(system, "forcing", (What::Force, Unit(1, -2, 0)), look);
}

fn of_machine(system: &mut Table, look: &mut dyn FnMut(Slot)) {
    visit(system, "period", (What::Clock, Unit(0, 1, 0)), look);
    visit(system, "frequency", (What::Clock, Unit(0, -1, 0)), look);
    visit(system, "mass", (What::Inertia, Unit(0, 0, 1)), look);
    visit(system, "damping", (What::Linear, Unit(0, -1, 1)), look);
    visit(system, "stiffness", (What::Linear, Unit(0, -2, 1)), look);
    visit(system, "cubic", (What::Linear, Unit(-2, -2, 1)), look);
    force(system, Unit(1, -2, 1), look);
    harmonics(system, "forcing", (What::Force, Unit(1, -2, 1)), look);
    if let Some(modes) = system.get_mut("modes").and_then(Value::as_table_mut) {
        visit(modes, "frequencies", (What::Clock, Unit(0, -1, 0)), look);
    }
    if let Some(measured) = system.get_mut("measured").and_then(Value::as_table_mut) {
        measured.entry("direction").or_insert(Value::Integer(1));
        visit(measured, "direction", (What::Force, Unit(1, -2, 1)), look);
    }
}

fn of_task(task: &mut Table, look: &mut dyn FnMut(Slot)) {
    let kind = task["kind"].as_str().expect("a word").to_string();
    let start = |table: &mut Table, look: &mut dyn FnMut(Slot)| {
        visit(table, "q", (What::Start, LENGTH), look);
        visit(table, "u", (What::Start, SPEED), look);
    };
    if let Some(table) = task.get_mut("start").and_then(Value::as_table_mut) {
        start(table, look);
    }
    for table in list(task, "starts") {
        start(table, look);
        if let Some(table) = table.get_mut("attractor").and_then(Value::as_table_mut) {
            start(table, look);
        }
        orbit(table, look);
    }
    for table in list(task, "branches").chain([]) {
        orbit(table, look);
    }
    for table in list(task, "orbits") {
        of_orbit(table, look);
    }
    orbit(task, look);
    if kind == "basins" {
        for (key, unit) in [("q", LENGTH), ("u", SPEED)] {
            if let Some(values) = task.get_mut(key).and_then(Value::as_table_mut) {
                visit(values, "from", (What::Start, unit), look);
                visit(values, "to", (What::Start, unit), look);
            }
        }
    }
    plain(task, "distance", (What::Distance, LENGTH), look);
}

fn orbit(table: &mut Table, look: &mut dyn FnMut(Slot)) {
    if let Some(keys) = table.get_mut("orbit").and_then(Value::as_table_mut) {
        of_orbit(keys, look);
    }
}

fn of_orbit(keys: &mut Table, look: &mut dyn FnMut(Slot)) {
    plain(keys, "speed", (What::Bound, SPEED), look);
    let free = keys.get("pattern").and_then(Value::as_array).is_none_or(Vec::is_empty);
    let start = keys.get_mut("start").and_then(Value::as_array_mut);
    for (i, value) in start.into_iter().flatten().enumerate() {
        let entry = [i, 0];
        match (free, i % 2) {
            (true, 0) => look(Slot { what: What::Start, unit: LENGTH, plain: true, entry, value }),
            (true, _) => look(Slot { what: What::Start, unit: SPEED, plain: true, entry, value }),
            (false, 0) => {}
            (false, _) => look(Slot { what: What::Bound, unit: SPEED, plain: true, entry, value }),
        }
    }
}

/// The tables of a list.
pub fn list<'a>(table: &'a mut Table, key: &str) -> impl Iterator<Item = &'a mut Table> + use<'a> {
    let all = table.get_mut(key).and_then(Value::as_array_mut);
    all.into_iter().flatten().filter_map(Value::as_table_mut)
}

fn force(system: &mut Table, unit: Unit, look: &mut dyn FnMut(Slot)) {
    let Some(value) = system.get_mut("force") else { return };
    each(value, [0; 2], &mut |entry, value| {
        let what = if is_formula(&text(value)) { What::Formula } else { What::Force };
        look(Slot { what, unit, plain: false, entry, value });
    });
}

fn harmonics(table: &mut Table, key: &str, (what, unit): (What, Unit), look: &mut dyn FnMut(Slot)) {
    for harmonic in list(table, key) {
        visit(harmonic, "cos", (what, unit), look);
        visit(harmonic, "sin", (what, unit), look);
    }
}

fn plain(table: &mut Table, key: &str, (what, unit): (What, Unit), look: &mut dyn FnMut(Slot)) {
    if let Some(value) = table.get_mut(key) {
        look(Slot { what, unit, plain: true, entry: [0; 2], value });
    }
}

fn visit(table: &mut Table, key: &str, (what, unit): (What, Unit), look: &mut dyn FnMut(Slot)) {
    let Some(value) = table.get_mut(key) else { return };
    each(value, [0; 2], &mut |entry, value| look(Slot { what, unit, plain: false, entry, value }));
}

/// The numbers of a number, a list, a matrix or a diagonal.
fn each(value: &mut Value, [row, column]: [usize; 2], look: &mut dyn FnMut([usize; 2], &mut Value)) {
    match value {
        Value::Array(all) => {
            for (i, value) in all.iter_mut().enumerate() {
                let entry = if value.is_array() { [i, column] } else { [row, i] };
                each(value, entry, look);
            }
        }
        Value::Table(table) => {
            if let Some(diagonal) = table.get_mut("diagonal") {
                each(diagonal, [0; 2], &mut |[_, i], value| look([i, i], value));
            }
        }
        number => look([row, column], number),
    }
}

/// Parts of an expression: names, and what is between them.
fn words(text: &str) -> Vec<(bool, String)> {
    let chars: Vec<char> = text.chars().collect();
    let (mut all, mut i) = (Vec::new(), 0);
    while i < chars.len() {
        let start = i;
        let is_name = chars[i].is_ascii_alphabetic() || chars[i] == '_';
        if is_name {
            while i < chars.len() && (chars[i].is_ascii_alphanumeric() || chars[i] == '_') {
                i += 1;
            }
        } else if chars[i].is_ascii_digit() || chars[i] == '.' {
            // A number with its exponent, whose e is no name.
            while i < chars.len() && (chars[i].is_ascii_digit() || chars[i] == '.') {
                i += 1;
            }
            if i < chars.len() && "eE".contains(chars[i]) {
                i += 1;
                i += usize::from(i < chars.len() && "+-".contains(chars[i]));
                while i < chars.len() && chars[i].is_ascii_digit() {
                    i += 1;
                }
            }
        } else {
            i += 1;
        }
        all.push((is_name, chars[start..i].iter().collect()));
    }
    all
}

/// The expression with other words in place of names, where `new` has one.
pub fn renamed(text: &str, new: &dyn Fn(&str) -> Option<String>) -> String {
    let word = |(is_name, word): (bool, String)| match new(&word).filter(|_| is_name) {
        Some(other) => other,
        None => word,
    };
    words(text).into_iter().map(word).collect()
}

/// The place of a variable of displacement or velocity: the letter and the coordinate from 0.
fn variable(name: &str) -> Option<(char, usize)> {
    let letter = name.chars().next().filter(|letter| "qu".contains(*letter))?;
    match &name[1..] {
        "" => Some((letter, 0)),
        number => Some((letter, number.parse::<usize>().ok()?.checked_sub(1)?)),
    }
}

/// Whether a force depends on the motion or on time.
pub fn is_formula(text: &str) -> bool {
    words(text).iter().any(|(is_name, word)| *is_name && (word == "t" || variable(word).is_some()))
}

/// The formula with other expressions for displacements, velocities and time, `{}` standing for each.
pub fn substituted(text: &str, q: &str, u: &str, t: &str) -> String {
    renamed(text, &|name| match (name, variable(name)) {
        ("t", _) => Some(t.replace("{}", name)),
        (_, Some(('q', _))) => Some(q.replace("{}", name)),
        (_, Some(_)) => Some(u.replace("{}", name)),
        _ => None,
    })
}

/// Every text of a scene that may be an expression in parameters, names of things apart.
pub fn each_text(value: &mut Value, look: &mut dyn FnMut(&mut String)) {
    const NAMES: [&str; 22] = [
        "format",
        "title",
        "name",
        "kind",
        "group",
        "side",
        "parameter",
        "second",
        "file",
        "label",
        "event",
        "walls_of",
        "stop",
        "plane",
        "frame",
        "direction_of",
        "options",
        "alphabet",
        "phase",
        "resume",
        "once",
        "history",
    ];
    match value {
        Value::String(text) => look(text),
        Value::Array(all) => all.iter_mut().for_each(|value| each_text(value, look)),
        Value::Table(table) => {
            for (key, value) in table.iter_mut() {
                // A parameter's own value, and stops by their names.
                let side = ["walls", "stops"].contains(&&**key)
                    && value.as_array().is_some_and(|all| all.iter().all(Value::is_str));
                if !NAMES.contains(&key.as_str())
                    && !["parameters", "set", "values", "range"].contains(&&**key)
                    && !side
                {
                    each_text(value, look);
                }
            }
        }
        _ => {}
    }
}
