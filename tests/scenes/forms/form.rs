//! The forms of a scene: each the same question, and how its report is read in the frame of the scene.

use std::f64::consts::TAU;

use grazing::{number::Plain, scene::Expression};
use toml::{Table, Value};

use super::{
    draw::Random,
    report::{FAR, Moving, Texts, View},
    scene::{
        What, brief, coordinates, each_number, each_text, exact, is_formula, is_machine, list, renamed,
        substituted, text,
    },
};

/// How near a form's numbers are to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// All that is computed is the same, work included.
    Same,
    /// Every number to the last bit, after powers of two and signs.
    Exact,
    /// But for rounding.
    Rounding,
    /// But for what an integrator leaves.
    Integrator,
}

/// A form of a scene.
pub struct Form {
    pub name: &'static str,
    pub level: Level,
    pub scene: Table,
    /// What it is a form of, where that is not the scene itself but the scene with shorter tasks.
    pub of: Option<Table>,
    pub view: View,
    pub texts: Texts,
    /// Kinds of tasks that the form leaves out by design.
    pub without: Vec<&'static str>,
    /// Whether only columns are compared that both reports have.
    pub common: bool,
    /// Tasks that are computed in another order in the form, for which [`Level::Exact`] is but for rounding.
    pub rounded: &'static [&'static str],
    /// Columns and tables that mean something else in the form.
    pub other: Vec<&'static str>,
}

/// Tasks that a form has not, and why: printed with every run.
pub const BY_DESIGN: [(&str, &str, &str); 18] = [
    ("machine of formulas", "criticality", "no normal form is computed through formulas of machines"),
    ("machine", "columns that one format has", "each is compared between forms of its own format"),
    ("machine", "whether a grazing is admissible", "format 1 says it but for the tangency"),
    ("machine", "events beyond their reach", "it is a length of a branch in one format"),
    ("machine", "refuted", "what is proved of machines refutes nothing: undecided"),
    ("mirrored", "the point shown of a basin's attractor", "that of the first start, which is another"),
    ("machine", "map crisis chaos", "tasks of format 1 only"),
    ("machine", "validate with event", "bifurcations of machines are not proved"),
    ("machine", "grazing of an orbit with impacts", "machines graze from the motion without impacts"),
    ("machine", "a frame", "planes of machines have gaps in its place"),
    ("hidden, machine of formulas", "validate chaos", "proofs are for linear systems by their keys"),
    ("inlined", "tasks that vary or set the parameter", "it is not there"),
    ("moving stops", "diagram points", "the frame moves with the parameter"),
    ("half the rate", "tasks but simulate and section", "patterns count periods of the form"),
    ("all", "tasks that restart from a file", "tested where files are: it needs those of another task"),
    ("shifted", "section with manifolds", "drawn for one phase"),
    ("all but the units", "a force measured once", "it is no function of the phase"),
    (
        "machine, units, rate",
        "coefficients of normal forms",
        "their sizes go with the coordinates (docs/branches.md)",
    ),
];

/// Tasks whose numbers come from Newton's method.
const SOLVED: [&str; 5] = ["orbit", "event", "branch", "grazing", "validate"];

fn tasks(scene: &mut Table) -> &mut Vec<Value> {
    scene.entry("tasks").or_insert(Value::Array(Vec::new())).as_array_mut().expect("a list")
}

fn system(scene: &mut Table) -> &mut Table {
    scene["system"].as_table_mut().expect("a table")
}

fn form(name: &'static str, level: Level, base: &Table) -> Form {
    Form {
        name,
        level,
        scene: base.clone(),
        of: None,
        view: View::of(base),
        texts: Texts::Words,
        without: Vec::new(),
        common: false,
        rounded: &[],
        other: Vec::new(),
    }
}

/// Whether motions of the scene are integrated.
pub fn is_integrated(scene: &Table) -> bool {
    let system = &scene["system"];
    let formula = |value: &Value| match value {
        Value::Array(all) => all.iter().any(|one| is_formula(&text(one))),
        one => is_formula(&text(one)),
    };
    system.get("cubic").is_some() || system.get("force").is_some_and(formula)
}

/// Without the tasks that no form has.
pub fn base(scene: &Table) -> Table {
    let mut scene = scene.clone();
    let restarts = |task: &Value| text(task).contains("restart");
    tasks(&mut scene).retain(|task| !restarts(task));
    scene
}

/// All forms that the scene has.
pub fn forms(base: &Table) -> Vec<Form> {
    let all = [
        renamed_parameters(base),
        inlined(base),
        reversed_tasks(base),
        units(
            "lengths in a smaller unit",
            base,
            [if is_machine(base) { 1_048_576.0 } else { 4.0 }, 1.0, 1.0],
        ),
        units(
            "lengths in a larger unit",
            base,
            [1.0 / if is_machine(base) { 1_048_576.0 } else { 4.0 }, 1.0, 1.0],
        ),
        units("times and masses in other units", base, [1.0, 64.0, 0.25]),
        mirrored(base),
        shifted("shifted by a quarter", base, 0.25),
        shifted("shifted by a tenth", base, 0.1),
        reversed_lists(base),
        far_stop(base),
        as_formula(base),
        hidden(base),
        machine(base),
        machine(base).and_then(machine_further),
        further(base),
        moving(base),
        half_rate(base),
    ];
    all.into_iter().flatten().collect()
}

/// An oscillator as a machine with a further coordinate.
fn machine_further(mut first: Form) -> Option<Form> {
    let second = further(&first.scene)?;
    first.other.extend(second.other);
    first.view.further = second.view.further;
    Some(Form { name: "as a machine with a further coordinate", scene: second.scene, ..first })
}

/// The scene with every coefficient changed by a part of up to δ, at random.
pub fn changed(base: &Table, delta: f64, seed: u64) -> Table {
    let mut scene = base.clone();
    let parts = (4.0 / delta).log2().round() as u32;
    let mut count = 0;
    each_number(&mut scene, &mut |mut slot| {
        count += 1;
        // How far a born orbit is from its grazing is the difference of two parameters. These are known to
        // δ of themselves, which is more beside a distance of 2⁻²⁰ of the motion's size.
        if slot.what == What::Distance {
            let number: f64 = slot.text().parse().expect("a number");
            let part = f64::from(Random(seed).signed_part());
            *slot.value = Value::Float(number * (1.0 + part / 4.0 * delta * 1_048_576.0));
            return;
        }
        if matches!(slot.what, What::Clock | What::Bound | What::Row) || slot.plain {
            return;
        }
        // The same for the two entries of a symmetric matrix.
        let [i, j] = slot.entry;
        let place = (i.min(j) * 1000 + i.max(j)) as u64;
        let list = u64::from(matches!(slot.what, What::Linear | What::Inertia));
        let key = seed.wrapping_mul(0x1_0001)
            ^ (place * list)
            ^ (((1 - list) * count) << 20)
            ^ ((slot.what as u64) << 50)
            ^ ((slot.unit.1 as u64) << 55);
        let part = Random(key).signed_part();
        let part = if slot.what == What::Restitution { -part.abs() } else { part };
        slot.wrap(&format!("({{}})*(1 + ({part})/2^{parts})"));
    });
    scene
}

fn renamed_parameters(base: &Table) -> Option<Form> {
    let mut form = form("parameters renamed", Level::Exact, base);
    let names: Vec<String> = base.get("parameters")?.as_table()?.keys().cloned().collect();
    let new = |name: &str| names.iter().any(|known| known == name).then(|| format!("{name}_of_the_scene"));
    let keys = |table: &mut Table| {
        *table = std::mem::take(table)
            .into_iter()
            .map(|(name, value)| (new(&name).unwrap_or(name), value))
            .collect();
    };
    let mut whole = Value::Table(form.scene);
    each_text(&mut whole, &mut |text| *text = renamed(text, &new));
    let Value::Table(mut scene) = whole else { unreachable!("it was a table") };
    keys(scene["parameters"].as_table_mut()?);
    for task in list(&mut scene, "tasks") {
        for key in ["parameter", "second"] {
            if let Some(name) = task.get(key).and_then(Value::as_str).and_then(new) {
                task.insert(key.into(), Value::String(name));
            }
        }
        for key in ["set", "cell"] {
            if let Some(set) = task.get_mut(key).and_then(Value::as_table_mut) {
                keys(set);
            }
        }
    }
    form.scene = scene;
    form.view.parameters.iter_mut().for_each(|name| *name = format!("{name}_of_the_scene"));
    Some(form)
}

fn inlined(base: &Table) -> Option<Form> {
    let mut form = form("parameters inlined", Level::Same, base);
    let values = base.get("parameters")?.as_table()?.clone();
    let whole = |task: &Value| ["parameter", "set", "cell"].iter().all(|key| task.get(key).is_none());
    tasks(&mut form.scene).retain(whole);
    form.scene.remove("parameters");
    let mut scene = Value::Table(form.scene);
    each_text(&mut scene, &mut |known| {
        *known = renamed(known, &|name| Some(format!("({})", text(values.get(name)?))));
    });
    let Value::Table(scene) = scene else { unreachable!("it was a table") };
    form.scene = scene;
    form.without = vec!["parameter"];
    Some(form)
}

fn reversed_tasks(base: &Table) -> Option<Form> {
    let mut form = form("order of tasks", Level::Same, base);
    tasks(&mut form.scene).reverse();
    Some(form)
}

fn units(name: &'static str, base: &Table, [length, time, mass]: [f64; 3]) -> Option<Form> {
    let machine = is_machine(base);
    if !machine && (time, mass) != (1.0, 1.0) {
        return None;
    }
    let modal = base["system"].get("modes").is_some();
    let mass = if modal { 1.0 } else { mass };
    // The integrator of format 1 has a tolerance with a unit.
    let level = if is_integrated(base) && !machine { Level::Integrator } else { Level::Exact };
    let mut form = form(name, level, base);
    each_number(&mut form.scene, &mut |mut slot| {
        let unit = slot.unit;
        let factor = length.powi(unit.0) * time.powi(unit.1) * mass.powi(unit.2);
        match slot.what {
            // In the variables of the other unit.
            What::Formula => {
                let (q, u) = (exact(1.0 / length), exact(time / length));
                let inner =
                    substituted(&slot.text(), &format!("({{}}*({q}))"), &format!("({{}}*({u}))"), "t");
                *slot.value = Value::String(format!("({})*({inner})", exact(factor)));
            }
            What::Restitution => {
                let speed = exact(time / length);
                let law = renamed(&slot.text(), &|name| (name == "v").then(|| format!("(v*({speed}))")));
                if slot.value.is_str() {
                    *slot.value = Value::String(law);
                }
            }
            _ => slot.scale(factor),
        }
    });
    if !machine {
        // It has a default with a unit.
        let accuracy = form.scene.entry("accuracy").or_insert(Value::Table(Table::new()));
        let accuracy = accuracy.as_table_mut()?;
        if !accuracy.contains_key("minimum_depth") {
            accuracy.insert("minimum_depth".into(), Value::Float(1e-12 * length));
        }
    }
    if machine || level != Level::Exact {
        form.rounded = &SOLVED;
    }
    (form.view.length, form.view.time, form.view.mass) = (length, time, mass);
    form.other.push("coefficient");
    Some(form)
}

fn mirrored(base: &Table) -> Option<Form> {
    let mut form = form("mirrored", Level::Exact, base);
    let machine = is_machine(base);
    if machine {
        // One coordinate's row may be left out.
        for wall in list(&mut form.scene, "walls") {
            wall.entry("row").or_insert(Value::Array(vec![Value::Integer(1)]));
        }
    }
    each_number(&mut form.scene, &mut |mut slot| match slot.what {
        What::Force | What::Start => slot.scale(-1.0),
        What::Place if !machine => slot.scale(-1.0),
        What::Row => slot.scale(-1.0),
        What::Formula => {
            let inner = substituted(&slot.text(), "(-{})", "(-{})", "t");
            *slot.value = Value::String(format!("-({inner})"));
        }
        _ => {}
    });
    for task in list(&mut form.scene, "tasks").filter(|task| task["kind"].as_str() == Some("basins")) {
        for key in ["q", "u"] {
            let values = task[key].as_table_mut()?;
            let [from, to] = ["from", "to"].map(|key| values[key].clone());
            values.insert("from".into(), to);
            values.insert("to".into(), from);
        }
    }
    if !machine {
        let mut whole = Value::Table(form.scene);
        swap_sides(&mut whole);
        let Value::Table(scene) = whole else { unreachable!("it was a table") };
        form.scene = scene;
        form.view.own_walls.iter_mut().chain(&mut form.view.walls).for_each(|side| *side = other_side(side));
    }
    form.view.mirrored = true;
    // Response of a machine is by amplitude and phase, whose half turn is rounded.
    form.level = if machine { Level::Rounding } else { Level::Exact };
    if machine && is_integrated(base) {
        form.level = Level::Integrator;
    }
    // The first start that leads to an attractor is another, and the first point that is shown of it.
    form.rounded = &["basins", "orbit", "event", "branch", "grazing", "validate"];
    form.other.extend(["basins.q", "basins.u"]);
    form.other.push("coefficient");
    Some(form)
}

fn other_side(side: &str) -> String {
    match side {
        "lower" => "upper".into(),
        "upper" => "lower".into(),
        other => other.into(),
    }
}

fn swap_sides(value: &mut Value) {
    match value {
        Value::String(text) => *text = other_side(text),
        Value::Array(all) => all.iter_mut().for_each(swap_sides),
        Value::Table(table) => table.iter_mut().for_each(|(_, value)| swap_sides(value)),
        _ => {}
    }
}

/// A phase less a part of a period, as a fraction from 0.
fn less(value: Option<&Value>, shift: f64) -> Value {
    let phase = value.map_or(0.0, |value| {
        let text = text(value);
        let (above, below) = text.split_once('/').unwrap_or((&text, "1"));
        above.parse::<f64>().expect("a number") / below.parse::<f64>().expect("a number")
    });
    Value::Float((phase - shift).rem_euclid(1.0))
}

fn shifted(name: &'static str, base: &Table, shift: f64) -> Option<Form> {
    let machine = is_machine(base);
    // Values of format 1 are rational.
    if base["system"].get("measured").is_some() || !machine && (shift * 4.0).fract() != 0.0 {
        return None;
    }
    let level = if is_integrated(base) { Level::Integrator } else { Level::Rounding };
    let mut form = form(name, level, base);
    let turn = |harmonics: &mut Table| {
        let k = harmonics.get("k").map_or(1.0, |k| text(k).parse::<f64>().expect("a number"));
        let angle = (k * shift).rem_euclid(1.0);
        let (cos, sin) = match (angle * 4.0, machine) {
            (quarters, _) if quarters.fract() == 0.0 => {
                let [cos, sin] = [[1, 0], [0, 1], [-1, 0], [0, -1]][quarters as usize];
                (cos.to_string(), sin.to_string())
            }
            _ => (format!("cos(2*pi*{angle})"), format!("sin(2*pi*{angle})")),
        };
        let zero = Value::Integer(0);
        let (c, s) =
            (harmonics.get("cos").unwrap_or(&zero).clone(), harmonics.get("sin").unwrap_or(&zero).clone());
        harmonics.insert("cos".into(), sum(&c, &cos, &s, &sin));
        harmonics.insert("sin".into(), sum(&s, &cos, &c, &format!("-({sin})")));
    };
    list(system(&mut form.scene), "forcing").for_each(turn);
    list(&mut form.scene, "walls").for_each(|wall| list(wall, "harmonics").for_each(turn));
    each_number(&mut form.scene, &mut |slot| {
        if slot.what == What::Formula {
            let inner = substituted(&slot.text(), "{}", "{}", &format!("(t + 2*pi*{shift})"));
            *slot.value = Value::String(inner);
        }
    });
    for task in list(&mut form.scene, "tasks") {
        shift_task(task, shift, machine);
    }
    form.view.shift = shift;
    form.other.push("coefficient");
    Some(form)
}

/// a·x + b·y, entry by entry.
fn sum(a: &Value, x: &str, b: &Value, y: &str) -> Value {
    let one = |a: &Value, b: &Value| Value::String(format!("({})*({x}) + ({})*({y})", text(a), text(b)));
    match (a, b) {
        (Value::Array(a), Value::Array(b)) => Value::Array(a.iter().zip(b).map(|(a, b)| one(a, b)).collect()),
        (Value::Array(a), b) => Value::Array(a.iter().map(|a| one(a, b)).collect()),
        (a, Value::Array(b)) => Value::Array(b.iter().map(|b| one(a, b)).collect()),
        (a, b) => one(a, b),
    }
}

fn shift_task(task: &mut Table, shift: f64, machine: bool) {
    let kind = task["kind"].as_str().expect("a word").to_string();
    let begin = |start: &mut Table| {
        let phase = less(start.get("phase"), shift);
        start.insert("phase".into(), phase);
    };
    let orbit = |holder: &mut Table| {
        let keys = holder.get_mut("orbit").and_then(Value::as_table_mut);
        let start = keys.and_then(|keys| keys.get_mut("start")).and_then(Value::as_array_mut);
        for time in start.into_iter().flatten().step_by(2) {
            let part = if machine { shift } else { TAU * shift };
            *time = Value::Float(text(time).parse::<f64>().expect("a number") - part);
        }
    };
    if let Some(start) = task.get_mut("start").and_then(Value::as_table_mut) {
        begin(start);
    }
    for start in list(task, "starts") {
        if ["section", "diagram"].contains(&&*kind) {
            begin(start);
        }
        if let Some(start) = start.get_mut("attractor").and_then(Value::as_table_mut) {
            begin(start);
        }
        orbit(start);
    }
    orbit(task);
    if ["section", "diagram", "basins", "map"].contains(&&*kind) {
        let phase = less(task.get("phase"), shift);
        task.insert("phase".into(), phase);
    }
}

fn reversed_lists(base: &Table) -> Option<Form> {
    let level = if is_integrated(base) { Level::Integrator } else { Level::Rounding };
    let mut form = form("order of stops and harmonics", level, base);
    let mut turned = false;
    let mut reverse = |table: &mut Table, key: &str| {
        if let Some(all) = table.get_mut(key).and_then(Value::as_array_mut) {
            turned |= all.len() > 1;
            all.reverse();
        }
    };
    // Names that are places in the list stay with their stops.
    if is_machine(base) {
        for (i, wall) in (1..).zip(list(&mut form.scene, "walls")) {
            wall.entry("name").or_insert(Value::String(format!("{i}")));
        }
    }
    reverse(&mut form.scene, "walls");
    reverse(system(&mut form.scene), "forcing");
    list(&mut form.scene, "walls").for_each(|wall| reverse(wall, "harmonics"));
    form.view.own_walls.reverse();
    turned.then_some(form)
}

/// Patterns name their walls where there are several.
fn name_walls(scene: &mut Table, key: &str, name: &str) {
    let fill = |keys: &mut Table| {
        let count = keys.get("pattern").and_then(Value::as_array).map_or(0, Vec::len);
        if count > 0 && !keys.contains_key(key) {
            keys.insert(key.into(), Value::Array(vec![Value::String(name.into()); count]));
        }
    };
    for task in list(scene, "tasks") {
        for start in list(task, "starts") {
            start.get_mut("orbit").and_then(Value::as_table_mut).into_iter().for_each(fill);
        }
        list(task, "orbits").for_each(fill);
        task.get_mut("orbit").and_then(Value::as_table_mut).into_iter().for_each(fill);
    }
}

fn far_stop(base: &Table) -> Option<Form> {
    let mut form = form("a stop that is never met", Level::Rounding, base);
    if is_integrated(base) {
        form.level = Level::Integrator;
    }
    let mut wall = Table::new();
    let own = &form.view.own_walls;
    let only = (own.len() == 1).then(|| own[0].clone());
    if is_machine(base) {
        let row = (0..coordinates(base)).map(|i| Value::Integer(i64::from(i == 0))).collect();
        wall.insert("name".into(), Value::String("guard".into()));
        wall.insert("row".into(), Value::Array(row));
        wall.insert("offset".into(), Value::Float(-FAR));
        form.view.far = Some("guard".into());
    } else {
        let side = match own.iter().map(String::as_str).collect::<Vec<_>>()[..] {
            [] | ["upper"] => "lower",
            ["lower"] => "upper",
            _ => return None,
        };
        wall.insert("side".into(), Value::String(side.into()));
        wall.insert("offset".into(), Value::Float(if side == "lower" { -FAR } else { FAR }));
        form.view.far = Some(side.into());
    }
    wall.insert("restitution".into(), Value::Float(0.5));
    form.view.own_walls.extend(form.view.far.clone());
    form.scene.entry("walls").or_insert(Value::Array(Vec::new())).as_array_mut()?.push(Value::Table(wall));
    if let Some(name) = only {
        name_walls(&mut form.scene, if is_machine(base) { "stops" } else { "walls" }, &name);
    }
    form.other.extend(["effects", "largest_gap"]);
    Some(form)
}

/// The keys of an oscillator as one formula, its first term with `stiffness` in place of q.
fn formula(system: &Table, displacement: &str) -> String {
    let mut all = String::new();
    let mut add = |key: &str, factor: &str| {
        if let Some(value) = system.get(key) {
            all += &format!(" - ({})*{factor}", text(value));
        }
    };
    add("damping", "u");
    add("stiffness", displacement);
    add("cubic", "q^3");
    if let Some(force) = system.get("force") {
        all += &format!(" + {}", text(force));
    }
    let mut harmonics = system.get("forcing").cloned().into_iter().collect::<Vec<_>>();
    for harmonic in harmonics.iter_mut().flat_map(|all| all.as_array_mut().into_iter().flatten()) {
        let k = harmonic.get("k").map_or("1".into(), text);
        for key in ["cos", "sin"] {
            if let Some(value) = harmonic.get(key) {
                all += &format!(" + ({})*{key}({k}*t)", text(value));
            }
        }
    }
    format!("0{all}")
}

fn only_force(form: &mut Form, force: String) {
    let system = system(&mut form.scene);
    system.clear();
    system.insert("force".into(), Value::String(force));
}

fn as_formula(base: &Table) -> Option<Form> {
    if is_machine(base) {
        return None;
    }
    let mut form = form("keys as a formula", Level::Exact, base);
    let force = formula(base["system"].as_table()?, "q");
    only_force(&mut form, force);
    without_proofs(&mut form);
    Some(form)
}

fn without_proofs(form: &mut Form) {
    form.without.extend(["validate", "chaos"]);
    tasks(&mut form.scene)
        .retain(|task| !["validate", "chaos"].contains(&task["kind"].as_str().unwrap_or("")));
}

/// The sum of squares of sine and cosine is no linear term.
fn hidden(base: &Table) -> Option<Form> {
    let mut form = form("a formula that is not recognised", Level::Integrator, base);
    without_proofs(&mut form);
    if !is_integrated(base) {
        brief(&mut form.scene);
        form.of = Some(form.scene.clone());
    }
    if !is_machine(base) {
        let force = formula(base["system"].as_table()?, "q*(sin(q)^2 + cos(q)^2)");
        only_force(&mut form, force);
        return Some(form);
    }
    if base["system"].get("modes").is_some() {
        return None;
    }
    let n = coordinates(base);
    let zero = "0*q1*(sin(q1)^2 + cos(q1)^2)";
    let system = system(&mut form.scene);
    let known: Vec<String> = match system.get("force") {
        Some(Value::Array(all)) => all.iter().map(text).collect(),
        Some(one) if n == 1 => vec![text(one)],
        _ => vec!["0".into(); n],
    };
    // The stiffness of the first coordinate goes over into the formula, and with one coordinate all of it.
    let stiffness = match (system.get("stiffness"), n) {
        (Some(Value::Array(rows)), _) => text(&rows[0].as_array()?[0]),
        (Some(Value::Table(_)), _) => return None,
        (Some(one), _) => text(one),
        (None, _) => "0".into(),
    };
    let take = |value: &mut Value| *value = Value::Integer(0);
    match system.get_mut("stiffness") {
        Some(Value::Array(rows)) => take(&mut rows[0].as_array_mut()?[0]),
        Some(one) => take(one),
        None => {}
    }
    let forces = known.iter().enumerate().map(|(i, force)| match i {
        0 => format!("{force} - ({stiffness})*q1*(sin(q1)^2 + cos(q1)^2)"),
        _ => format!("{force} + {zero}"),
    });
    let forces = forces.map(Value::String).collect();
    system.insert("force".into(), Value::Array(forces));
    // Nothing says which way a bifurcation of a machine of formulas goes (docs/scenes.md).
    form.other.extend(["modes", "effects", "order_matters", "coefficient", "criticality"]);
    Some(form)
}

/// An oscillator as a machine of one coordinate.
fn machine(base: &Table) -> Option<Form> {
    if is_machine(base) {
        return None;
    }
    let level = if is_integrated(base) { Level::Integrator } else { Level::Rounding };
    let mut form = form("as a machine", level, base);
    let scene = &mut form.scene;
    scene.insert("format".into(), Value::String("grazing-scene 2".into()));
    let system = system(scene);
    system.insert("period".into(), Value::String("2*pi".into()));
    system.insert("mass".into(), Value::Integer(1));
    if let Some(cubic) = system.remove("cubic") {
        let force = system.get("force").map_or("0".into(), text);
        system.insert("force".into(), Value::String(format!("{force} - ({})*q^3", text(&cubic))));
    }
    if let Some(accuracy) = scene.get_mut("accuracy").and_then(Value::as_table_mut) {
        accuracy.remove("tolerance");
    }
    for wall in list(scene, "walls") {
        let side = wall.remove("side")?;
        let upper = side.as_str() == Some("upper");
        wall.insert("row".into(), Value::Array(vec![Value::Integer(if upper { -1 } else { 1 })]));
        wall.insert("name".into(), side);
        if upper {
            wall["offset"] = Value::String(format!("-({})", text(&wall["offset"])));
            for harmonic in list(wall, "harmonics") {
                for key in ["cos", "sin"] {
                    if let Some(value) = harmonic.get_mut(key) {
                        *value = Value::String(format!("-({})", text(value)));
                    }
                }
            }
        }
    }
    let framed = |task: &Value| task.get("frame").is_some_and(|frame| frame.as_str() != Some("fixed"));
    let impacting = |task: &Value| {
        task.get("orbit").is_some_and(|orbit| {
            orbit.get("pattern").is_some_and(|all| all.as_array().is_some_and(|all| !all.is_empty()))
        })
    };
    tasks(scene).retain(|task| {
        let kind = task["kind"].as_str().unwrap_or("");
        let refused = ["map", "crisis", "chaos"].contains(&kind)
            || kind == "validate" && task.get("event").is_some()
            || kind == "grazing" && impacting(task);
        !refused && (kind == "branch" || !framed(task))
    });
    for task in list(scene, "tasks") {
        let kind = task["kind"].as_str()?.to_string();
        if ["section", "diagram", "basins"].contains(&&*kind) {
            task.insert(
                "plane".into(),
                Value::Array(["q1", "u1"].map(|name| Value::String(name.into())).to_vec()),
            );
        }
        for key in ["frame", "manifolds", "grazing_curve"] {
            task.remove(key);
        }
        if kind == "grazing" {
            task.remove("orbit");
            task.remove("options");
        }
        for start in list(task, "starts") {
            start.get_mut("orbit").and_then(Value::as_table_mut).into_iter().for_each(orbit_of_machine);
        }
        list(task, "orbits").for_each(orbit_of_machine);
        task.get_mut("orbit").and_then(Value::as_table_mut).into_iter().for_each(orbit_of_machine);
    }
    form.texts = Texts::Presence;
    form.common = true;
    form.view.radians = false;
    form.without.push("machine");
    form.other.extend(["coefficient", "effects", "extent", "half"]);
    if is_integrated(base) {
        form.other.push("criticality");
    }
    Some(form)
}

fn orbit_of_machine(keys: &mut Table) {
    if let Some(walls) = keys.remove("walls") {
        keys.insert("stops".into(), walls);
    }
    keys.entry("speed").or_insert(Value::Float(1.0));
    let free = keys.get("pattern").and_then(Value::as_array).is_none_or(Vec::is_empty);
    if free {
        keys.remove("start");
    }
    for time in keys.get_mut("start").and_then(Value::as_array_mut).into_iter().flatten().step_by(2) {
        *time = Value::Float(text(time).parse::<f64>().expect("a number") / TAU);
    }
}

/// A coordinate that nothing drives or couples, before whose decay all others last.
fn further(base: &Table) -> Option<Form> {
    let base_system = base["system"].as_table()?;
    if !is_machine(base) || base_system.get("modes").is_some() || base_system.get("measured").is_some() {
        return None;
    }
    let level = if is_integrated(base) { Level::Integrator } else { Level::Rounding };
    let mut form = form("a further coordinate", level, base);
    let n = coordinates(base);
    let system = system(&mut form.scene);
    for (key, entry) in [("mass", "1"), ("damping", "3"), ("stiffness", "4")] {
        let mut rows: Vec<Value> = match system.get(key) {
            Some(Value::Array(rows)) => rows.clone(),
            Some(Value::Table(table)) => {
                let diagonal = table.get("diagonal")?.as_array()?;
                let row = |i: usize| {
                    Value::Array(
                        (0..n)
                            .map(|j| if i == j { diagonal[i].clone() } else { Value::Integer(0) })
                            .collect(),
                    )
                };
                (0..n).map(row).collect()
            }
            Some(one) => vec![Value::Array(vec![one.clone()])],
            None => vec![Value::Array(vec![Value::Integer(0); n]); n],
        };
        rows.iter_mut()
            .for_each(|row| row.as_array_mut().into_iter().for_each(|row| row.push(Value::Integer(0))));
        let mut last = vec![Value::Integer(0); n];
        last.push(Value::String(entry.into()));
        rows.push(Value::Array(last));
        system.insert(key.into(), Value::Array(rows));
    }
    let widen = |table: &mut Table, key: &str| {
        if let Some(value) = table.get_mut(key) {
            match value {
                Value::Array(all) => all.push(Value::Integer(0)),
                one if text(one).parse::<f64>() == Ok(0.0) => {}
                one => *one = Value::Array(vec![one.clone(), Value::Integer(0)]),
            }
        }
    };
    widen(system, "force");
    // With several coordinates q and u have numbers.
    for one in system.get_mut("force").and_then(Value::as_array_mut).into_iter().flatten() {
        if let Value::String(text) = one {
            *text = renamed(text, &|name| ["q", "u"].contains(&name).then(|| format!("{name}1")));
        }
    }
    for harmonic in list(system, "forcing") {
        widen(harmonic, "cos");
        widen(harmonic, "sin");
    }
    for wall in list(&mut form.scene, "walls") {
        wall.entry("row").or_insert(Value::Array(vec![Value::Integer(1)]));
        widen(wall, "row");
    }
    for task in list(&mut form.scene, "tasks") {
        let start = |start: &mut Table| {
            widen(start, "q");
            widen(start, "u");
        };
        task.get_mut("start").and_then(Value::as_table_mut).into_iter().for_each(start);
        for one in list(task, "starts") {
            start(one);
            one.get_mut("attractor").and_then(Value::as_table_mut).into_iter().for_each(start);
        }
    }
    // λ² + 3λ + 4 = 0 over a period.
    let period = number(base_system, "period", base)
        .or_else(|| Some(1.0 / number(base_system, "frequency", base)?))?;
    let (rate, angle) = (-1.5 * period, 1.75_f64.sqrt() * period);
    let of = |times: f64| {
        [(rate * times).exp() * (angle * times).cos(), (rate * times).exp() * (angle * times).sin()]
    };
    form.view.further = (1..=3).flat_map(|i| [of(f64::from(i)), of(f64::from(i)).map(|x| x)]).collect();
    form.view.further.iter_mut().skip(1).step_by(2).for_each(|pair| pair[1] = -pair[1]);
    form.other.extend([
        "coefficient",
        "modes",
        "effects",
        "a1",
        "a2",
        "gamma",
        "region",
        "exponents",
        "chaos",
        "chaos_open",
        "order_matters",
    ]);
    Some(form)
}

/// The value of an expression in the scene's parameters.
fn number(table: &Table, key: &str, scene: &Table) -> Option<f64> {
    let empty = Table::new();
    let parameters = scene.get("parameters").and_then(Value::as_table).unwrap_or(&empty);
    let names: Vec<String> = parameters.keys().cloned().collect();
    let value = |value: &Value| {
        let Plain(x) = Expression::parse(&text(value), &[]).ok()?.evaluate(&[], &()).ok()?;
        Some(Plain(x))
    };
    let values: Option<Vec<Plain>> = parameters.values().map(value).collect();
    let Plain(x) = Expression::parse(&text(table.get(key)?), &names).ok()?.evaluate(&values?, &()).ok()?;
    Some(x)
}

/// A linear oscillator seen from its motion without walls: nothing drives it, and the walls move.
fn moving(base: &Table) -> Option<Form> {
    let known = base["system"].as_table()?;
    if is_machine(base) || is_integrated(base) || base.get("walls").is_none() {
        return None;
    }
    let mut form = form("moving stops for the force", Level::Rounding, base);
    let coefficient = |key: &str| known.get(key).map_or("0".to_string(), text);
    let (d, k) = (coefficient("damping"), coefficient("stiffness"));
    number(known, "stiffness", base).filter(|&k| k != 0.0)?;
    let mean = format!("({})/({k})", coefficient("force"));
    let mut terms: Vec<(u32, String, String)> = Vec::new();
    for harmonic in known.get("forcing").and_then(Value::as_array).into_iter().flatten() {
        let m: u32 = harmonic.get("k").map_or(1, |m| text(m).parse().expect("a number"));
        let [c, s] = ["cos", "sin"].map(|key| harmonic.get(key).map_or("0".into(), text));
        let even = format!("(({k}) - {})", m * m);
        let odd = format!("({m}*({d}))");
        let square = format!("({even}^2 + {odd}^2)");
        terms.push((
            m,
            format!("({even}*({c}) - {odd}*({s}))/{square}"),
            format!("({even}*({s}) + {odd}*({c}))/{square}"),
        ));
    }
    if terms.is_empty() {
        return None;
    }
    let system = system(&mut form.scene);
    system.remove("forcing");
    system.remove("force");
    for wall in list(&mut form.scene, "walls") {
        wall["offset"] = Value::String(format!("({}) - {mean}", text(&wall["offset"])));
        let all = wall.entry("harmonics").or_insert(Value::Array(Vec::new())).as_array_mut()?;
        for (m, cos, sin) in &terms {
            let is = |one: &&mut Value| one.get("k").map_or("1".into(), text) == m.to_string();
            let mut one = Table::new();
            if let Some(known) = all.iter_mut().find(is) {
                for (key, part) in [("cos", cos), ("sin", sin)] {
                    let old = known.get(key).map_or("0".into(), text);
                    known.as_table_mut()?.insert(key.into(), Value::String(format!("({old}) - {part}")));
                }
                continue;
            }
            one.insert("k".into(), Value::Integer((*m).into()));
            one.insert("cos".into(), Value::String(format!("-{cos}")));
            one.insert("sin".into(), Value::String(format!("-{sin}")));
            all.push(Value::Table(one));
        }
    }
    let sum = |parts: Vec<String>| parts.join(" + ");
    let q = sum(terms.iter().map(|(_, cos, _)| format!("({cos})")).chain([mean.clone()]).collect());
    let u = sum(terms.iter().map(|(m, _, sin)| format!("{m}*({sin})")).collect());
    // Only what begins at phase 0 and is looked at there.
    let phased = |task: &Value| text(task).contains("phase") || text(task).contains("frame");
    tasks(&mut form.scene).retain(|task| !phased(task) && task["kind"].as_str() != Some("diagram"));
    for task in list(&mut form.scene, "tasks") {
        let place = |table: &mut Table, key: &str, less: &str| {
            let old = table.get(key).map_or("0".into(), text);
            table.insert(key.into(), Value::String(format!("({old}) - ({less})")));
        };
        let start = |start: &mut Table| {
            place(start, "q", &q);
            place(start, "u", &u);
        };
        let kind = task["kind"].as_str()?.to_string();
        task.get_mut("start").and_then(Value::as_table_mut).into_iter().for_each(start);
        for one in list(task, "starts") {
            if kind == "section" {
                start(one);
            }
            one.get_mut("attractor").and_then(Value::as_table_mut).into_iter().for_each(start);
        }
        if kind == "basins" {
            for (key, less) in [("q", &q), ("u", &u)] {
                let values = task[key].as_table_mut()?;
                place(values, "from", less);
                place(values, "to", less);
            }
        }
    }
    let mut one = Table::new();
    let mut at = |text: &String| {
        one.insert("x".into(), Value::String(text.clone()));
        number(&one, "x", base)
    };
    let mut all = vec![Moving { k: 0.0, cos: at(&mean)?, sin: 0.0 }];
    for (m, cos, sin) in &terms {
        all.push(Moving { k: f64::from(*m), cos: at(cos)?, sin: at(sin)? });
    }
    form.view.moving = all;
    form.without.extend(["diagram", "phase"]);
    form.other.extend(["coefficient", "effects", "extent"]);
    Some(form)
}

/// Every harmonic twice its number, in twice the period.
fn half_rate(base: &Table) -> Option<Form> {
    let level = if is_integrated(base) { Level::Integrator } else { Level::Rounding };
    let mut form = form("harmonics doubled, half the rate", level, base);
    if !is_machine(base) || base["system"].get("measured").is_some() {
        return None;
    }
    let double = |table: &mut Table| {
        let k: i64 = table.get("k").map_or(1, |k| text(k).parse().expect("a number"));
        table.insert("k".into(), Value::Integer(2 * k));
    };
    let system = system(&mut form.scene);
    list(system, "forcing").for_each(double);
    if let Some(period) = system.get_mut("period") {
        *period = Value::String(format!("2*({})", text(period)));
    }
    if let Some(frequency) = system.get_mut("frequency") {
        *frequency = Value::String(format!("({})/2", text(frequency)));
    }
    list(&mut form.scene, "walls").for_each(|wall| list(wall, "harmonics").for_each(double));
    each_number(&mut form.scene, &mut |slot| {
        if slot.what == What::Formula {
            *slot.value = Value::String(substituted(&slot.text(), "{}", "{}", "(2*t)"));
        }
    });
    tasks(&mut form.scene).retain(|task| {
        let even =
            |key: &str, default: i64| task.get(key).map_or(default, |n| n.as_integer().unwrap_or(1)) % 2 == 0;
        task["kind"].as_str() == Some("simulate")
            && even("periods", 10)
            && even("transient", 0)
            && task.get("start").is_some_and(|start| start.get("phase").is_none())
    });
    for task in list(&mut form.scene, "tasks") {
        let number = |task: &Table, key: &str, default: i64| {
            task.get(key).and_then(Value::as_integer).unwrap_or(default)
        };
        let [periods, transient, samples] =
            [number(task, "periods", 10), number(task, "transient", 0), number(task, "samples", 64)];
        task.insert("periods".into(), Value::Integer(periods / 2));
        task.insert("transient".into(), Value::Integer(transient / 2));
        task.insert("samples".into(), Value::Integer(2 * samples));
    }
    form.view.rounds = 2.0;
    form.without.push("all but simulate");
    form.other.extend(["coefficient", "effects", "periods", "period", "ended_at", "modes", "speed"]);
    Some(form)
}
