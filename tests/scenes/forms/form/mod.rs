//! The forms of a scene: each the same question, and how its report is read in the frame of the scene.

mod changed;
mod clock;
mod far;
mod formula;
mod machine;
mod mirrored;
mod mixed;
mod moving;
mod order;
mod phase;
mod rate;
mod rubbing;
mod units;
mod upgraded;
mod words;

use std::f64::consts::TAU;

use grazing_scenes::{number::Plain, scene::Expression};
use toml::{Table, Value};

use super::{
    report::{Texts, View},
    scene::{self, is_formula, text},
};

pub use changed::changed;

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
    /// Tasks, or tables of them as in "grazing.born", that are computed in another order in the form, for
    /// which [`Level::Exact`] is but for rounding.
    pub rounded: &'static [&'static str],
    /// Columns and tables that mean something else in the form.
    pub other: Vec<&'static str>,
}

/// Tasks that a form has not, and why: printed with every run.
pub const BY_DESIGN: [(&str, &str, &str); 41] = [
    (
        "shifted",
        "tasks whose search finds another number of orbits",
        "its starts are states at phase 0, which is another",
    ),
    (
        "all",
        "a row of a motion that is settled on one side only",
        "how long a transient is, is not in the scene",
    ),
    ("machine of formulas", "criticality", "no normal form is computed through formulas of machines"),
    ("machine of formulas", "what a record's residual could move", "it is told of linear machines"),
    ("machine", "columns that one format has", "each is compared between forms of its own format"),
    ("machine", "whether a grazing is admissible", "format 1 says it but for the tangency"),
    (
        "machine, moving stops, shifted, mixed",
        "an event beyond its reach on one side only",
        "it is a length of the branch, in the form's own unknowns",
    ),
    ("the same", "how far a branch goes that has an event on neither side", "the same"),
    ("machine of formulas", "grazing of a motion of more than 1000 harmonics", "a machine refuses it"),
    ("units", "bits of born orbits and of proofs", "they begin at middles of enclosures"),
    ("format 1", "times and masses in other units", "its period is 2π and its mass 1: it has none"),
    ("machine", "refuted", "what is proved of machines refutes nothing: undecided"),
    ("mirrored", "the point shown of a basin's attractor", "that of the first start, which is another"),
    ("machine", "map crisis chaos", "tasks of format 1 only"),
    ("a stop that is never met", "chaos without `to`", "some value of the parameter reaches any stop"),
    ("machine", "validate with event", "bifurcations of machines are not proved"),
    ("machine", "validate and branch over ranges of a parameter", "they are proved of format 1"),
    (
        "hidden, machine of formulas",
        "what is proved of branches and beside touches",
        "proofs are for linear systems by their keys",
    ),
    ("machine", "grazing of an orbit with impacts", "machines graze from the motion without impacts"),
    ("machine", "a frame", "planes of machines have gaps in its place"),
    ("hidden, machine of formulas", "validate chaos", "proofs are for linear systems by their keys"),
    ("inlined", "tasks that vary or set the parameter", "it is not there"),
    ("inlined", "the warning of a parameter that stands in no expression", "the same"),
    (
        "moving stops",
        "motions that are settled on one side only",
        "what comes back is told by the extent, that of the frame",
    ),
    ("moving stops", "diagram points and responses", "the frame moves with the parameter"),
    (
        "half the rate",
        "all but motions and orbits of one impact in an even number of periods",
        "patterns and sections count periods of the form: others are gone round twice",
    ),
    ("half the rate", "orbits that are searched for", "starts are spread over the form's period"),
    (
        "moving stops",
        "orbits that are searched for, with none at hand",
        "Newton's steps are measured by the size of what moves in the frame",
    ),
    (
        "further coordinate",
        "one that is driven",
        "its motion would be part of the extent by which attractors are told apart",
    ),
    ("all", "tasks that restart from a file", "tested where files are: it needs those of another task"),
    ("laws", "all but motions", "a law is a kink to what finds and follows orbits"),
    ("laws", "stops on which friction is", "friction does not follow a law"),
    ("mixed", "basins", "the other coordinates of a grid's points stay where they are"),
    ("mixed", "responses of other coordinates", "they are others"),
    ("hidden, machine of formulas", "branches among friction", "they are refused where a force is a formula"),
    ("shifted", "how far is seen to swing", "turning points are those of a cubic through looks"),
    ("further coordinate", "rest", "of one coordinate it is all, of several what a search finds"),
    (
        "all",
        "rest: warnings, and whether it took work",
        "which motions of a search are not followed to their end goes with their rounding, and with one coordinate \
         what presses may be told without steps",
    ),
    ("shifted", "section with manifolds", "drawn for one phase"),
    ("all but the units of length", "a force measured once", "it is no function of the phase"),
    (
        "machine, units, rate",
        "coefficients of normal forms",
        "their sizes go with the coordinates (docs/branches.md)",
    ),
];

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
    let law = |stop: &Value| stop.get("law").is_some();
    let stops = scene.get(scene::stops_key(scene)).and_then(Value::as_array);
    system.get("cubic").is_some()
        || system.get("force").is_some_and(formula)
        || stops.is_some_and(|all| all.iter().any(law))
}

/// Without the tasks that no form has.
pub fn base(scene: &Table) -> Table {
    let mut scene = scene.clone();
    let restarts = |task: &Value| text(task).contains("restart");
    tasks(&mut scene).retain(|task| !restarts(task));
    scene
}

/// The names of its tasks.
pub fn names(scene: &Table) -> Vec<String> {
    let all = scene.get("tasks").and_then(Value::as_array).into_iter().flatten();
    all.map(|task| text(&task["name"])).collect()
}

/// The scene without some of its tasks.
pub fn without<'a>(scene: &Table, names: impl Iterator<Item = &'a String> + Clone) -> Table {
    let mut scene = scene.clone();
    tasks(&mut scene).retain(|task| names.clone().all(|name| task["name"].as_str() != Some(name)));
    scene
}

/// The scene with one of its tasks.
pub fn only(scene: &Table, task: &str) -> Table {
    let mut scene = scene.clone();
    tasks(&mut scene).retain(|one| one["name"].as_str() == Some(task));
    scene
}

/// Whether a task proves an orbit over a range of a parameter.
fn is_over_a_range(task: &Value) -> bool {
    task["kind"].as_str() == Some("validate")
        && task.get("parameter").is_some()
        && task.get("event").is_none()
}

/// Branches without what is proved of them.
fn without_prove(scene: &mut Table) {
    for task in scene::list(scene, "tasks").filter(|task| task["kind"].as_str() == Some("branch")) {
        task.remove("prove");
    }
}

/// The scene without proofs of chaos and those over ranges of a parameter.
pub fn without_ranges(scene: &Table) -> Table {
    let mut scene = scene.clone();
    tasks(&mut scene).retain(|one| one["kind"].as_str() != Some("chaos") && !is_over_a_range(one));
    without_prove(&mut scene);
    scene
}

/// Tasks whose orbits of impacts are searched for, as none is known to begin with.
pub fn searched(scene: &Table) -> Vec<String> {
    let open = |holder: &Table| {
        holder.get("orbit").is_some_and(|orbit| {
            let pattern = orbit.get("pattern").and_then(Value::as_array);
            pattern.is_some_and(|all| !all.is_empty()) && orbit.get("start").is_none()
        })
    };
    let any = |task: &&Table| {
        let starts = task.get("starts").and_then(Value::as_array).into_iter().flatten();
        open(task) || starts.filter_map(Value::as_table).any(open)
    };
    let all = scene.get("tasks").and_then(Value::as_array).into_iter().flatten();
    all.filter_map(Value::as_table).filter(any).map(|task| text(&task["name"])).collect()
}

/// All forms that the scene has.
pub fn forms(base: &Table) -> Vec<Form> {
    let all = [
        upgraded::upgraded(base),
        words::renamed_parameters(base),
        words::inlined(base),
        order::reversed_tasks(base),
        units::units("lengths in a smaller unit", base, [1_048_576.0, 1.0, 1.0]),
        units::units("lengths in a larger unit", base, [1.0 / 1_048_576.0, 1.0, 1.0]),
        units::units("times and masses in other units", base, [1.0, 64.0, 0.25]),
        clock::clock(base, ("another unit of time", Level::Exact), "pi/32", 1.0 / 64.0),
        clock::clock(base, ("in hertz", Level::Rounding), "1/4", 0.25 / TAU),
        mirrored::mirrored(base),
        phase::shifted("shifted by a quarter", base, 0.25),
        phase::shifted("shifted by a tenth", base, 0.1),
        order::reversed_lists(base),
        far::far_stop(base),
        formula::as_formula(base),
        formula::hidden(base),
        machine::machine(base),
        machine::machine(base).and_then(machine::machine_further),
        machine::further(base),
        moving::moving(base),
        rate::half_rate(base),
        mixed::mixed(base),
        rubbing::turned_rows(base),
        rubbing::laws(base),
    ];
    all.into_iter().flatten().collect()
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
