//! The formats of scenes. One grammar, that of format 3, is read; a file of format 1 or 2 is first turned
//! into the document of format 3 that says the same, its values where they stand in the file, so that errors
//! name them there, by the words of the file's own format.
//!
//! SceneFormat 1 was for oscillators of one degree of freedom, format 2 for machines.

use std::ops::Range;

use toml_edit::{Array, Item, Key, Table, TableLike, Value};

use crate::{number::parse_rational_within, source::unknown};

use super::grammar::LIMIT_BITS;

/// A format of scenes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum SceneFormat {
    /// `"grazing-scene 1"`.
    One,
    /// `"grazing-scene 2"`.
    Two,
    /// `"grazing-scene 3"`.
    Three,
}

use SceneFormat::{One, Three, Two};

/// Keys with another name in older formats: which, the table in which a key stands, its name there and in
/// format 3. A list of tables goes by the name of the list; the top level has none.
const RENAMED: [(&[SceneFormat], &[&str], &str, &str); 3] = [
    (&[One, Two], &[""], "walls", "stops"),
    (&[One], &["orbit", "orbits"], "walls", "stops"),
    (&[One], &["tasks"], "side", "stop"),
];

/// Keys that older formats do not have, by the table in which they stand.
const MISSING: [(SceneFormat, &str, &[&str]); 7] = [
    (One, "", &["engine", "friction", "events", "units"]),
    (One, "system", &["period", "frequency", "mass", "damping_ratio", "modes", "measured"]),
    (One, "stops", &["name", "row", "stiffness", "damping", "measured"]),
    (Two, "", &["engine", "friction", "events", "units"]),
    (Two, "system", &["cubic"]),
    (Two, "stops", &["side", "measured"]),
    (Two, "accuracy", &["tolerance"]),
];

/// Keys without which an older format has no sense.
const REQUIRED: [(SceneFormat, &str, &str); 2] = [(One, "stops", "side"), (One, "stops", "restitution")];

/// A key or a place in a list: what leads to a value.
fn split(segment: &str) -> (&str, &str) {
    segment.split_at(segment.find('[').unwrap_or(segment.len()))
}

/// The name of the table that stands at a path.
fn table_name(path: &str) -> &str {
    split(path.rsplit('.').next().unwrap_or_default()).0
}

impl SceneFormat {
    /// All, by their words in a file.
    pub(super) const ALL: [(&'static str, SceneFormat); 3] =
        [("grazing-scene 1", One), ("grazing-scene 2", Two), ("grazing-scene 3", Three)];

    /// Its word in a file.
    pub(crate) fn word(self) -> &'static str {
        SceneFormat::ALL.into_iter().find(|known| known.1 == self).map_or("", |known| known.0)
    }

    /// What a key of format 3 is called in this one, in the table of this name.
    fn key_in<'k>(self, table: &str, key: &'k str) -> &'k str {
        let renamed = RENAMED.iter().find(|(formats, tables, _, new)| {
            formats.contains(&self) && tables.contains(&table) && *new == key
        });
        renamed.map_or(key, |found| found.2)
    }

    /// What a key of the table at a path is called in this format.
    pub(super) fn key<'k>(self, path: &str, key: &'k str) -> &'k str {
        self.key_in(table_name(path), key)
    }

    /// Whether this format has a key of format 3 in the table at a path.
    pub(super) fn has(self, path: &str, key: &str) -> bool {
        let table = table_name(path);
        !MISSING
            .iter()
            .any(|(format, tables, keys)| *format == self && *tables == table && keys.contains(&key))
    }

    /// Whether this format must have a key that format 3 need not have.
    pub(super) fn requires(self, path: &str, key: &str) -> bool {
        REQUIRED.contains(&(self, table_name(path), key))
    }

    /// A path of format 3 in the words of this one.
    pub(super) fn path(self, path: &str) -> String {
        let mut table = "";
        let own = path.split('.').map(|segment| {
            let (key, place) = split(segment);
            let own = format!("{}{place}", self.key_in(table, key));
            table = key;
            own
        });
        own.collect::<Vec<_>>().join(".")
    }

    /// What its stops are called.
    pub(super) fn stop(self) -> &'static str {
        if self == One { "wall" } else { "stop" }
    }
}

/// A key that a file has and its format does not: where it stands, and what is wrong.
#[derive(Debug)]
pub(super) struct Foreign {
    pub span: Option<Range<usize>>,
    pub message: String,
}

/// Turns the document of a file of an older format into that of format 3, keys in their order. `written` is
/// the text of a number as it stands in the file.
pub(super) fn translate(
    root: &mut Table,
    format: SceneFormat,
    written: &dyn Fn(&Value) -> Option<String>,
) -> Result<(), Foreign> {
    if format == Three {
        return Ok(());
    }
    rename(root, format, "")?;
    for task in tables(root.get_mut("tasks")) {
        let chaos = task.get("kind").and_then(Item::as_str) == Some("chaos");
        if chaos {
            rename(task, format, "tasks")?;
        }
        for orbit in orbits(task) {
            rename(orbit, format, "orbit")?;
            let impacts = orbit.get("pattern").and_then(Item::as_array).is_some_and(|all| !all.is_empty());
            if let Some(start) = orbit.get_mut("start").and_then(Item::as_array_mut)
                && impacts
                && format == One
            {
                in_radians(start, written);
            }
        }
    }
    Ok(())
}

/// The times t_1, t_2, …, at every second place from the first on, were radians.
fn in_radians(start: &mut Array, written: &dyn Fn(&Value) -> Option<String>) {
    for time in start.iter_mut().step_by(2) {
        let number = written(time).filter(|text| parse_rational_within(text, LIMIT_BITS).is_ok());
        if let Some(number) = number {
            let decor = time.decor().clone();
            *time = Value::from(format!("{number} rad"));
            *time.decor_mut() = decor;
        }
    }
}

/// The tables of a list, however it is written.
fn tables(list: Option<&mut Item>) -> Vec<&mut dyn TableLike> {
    match list {
        Some(Item::ArrayOfTables(all)) => all.iter_mut().map(|one| one as &mut dyn TableLike).collect(),
        Some(Item::Value(Value::Array(all))) => {
            let inline = all.iter_mut().filter_map(Value::as_inline_table_mut);
            inline.map(|one| one as &mut dyn TableLike).collect()
        }
        _ => Vec::new(),
    }
}

/// The tables of orbits in a task: `orbit`, those of `orbits`, and `orbit` in those of `starts` and
/// `branches`.
fn orbits(task: &mut dyn TableLike) -> Vec<&mut dyn TableLike> {
    let mut all: Vec<&mut dyn TableLike> = Vec::new();
    for (key, item) in task.iter_mut() {
        match key.get() {
            "orbit" => all.extend(item.as_table_like_mut()),
            "orbits" => all.extend(tables(Some(item))),
            "starts" | "branches" => {
                let starts = tables(Some(item)).into_iter();
                all.extend(starts.filter_map(|start| start.get_mut("orbit")?.as_table_like_mut()));
            }
            _ => {}
        }
    }
    all
}

/// Gives the keys of a table of this name their names of format 3.
fn rename(table: &mut dyn TableLike, format: SceneFormat, name: &str) -> Result<(), Foreign> {
    for (_, _, old, new) in RENAMED.iter().filter(|one| one.0.contains(&format) && one.1.contains(&name)) {
        if let Some((_, item)) = table.get_key_value(new) {
            let span = table.key(new).and_then(Key::span).or(item.span());
            return Err(Foreign { span, message: unknown(new, &[old]) });
        }
        if !table.contains_key(old) {
            continue;
        }
        // A key has no other way to a new name that keeps its place among the others.
        let keys: Vec<String> = table.iter().map(|(key, _)| key.to_string()).collect();
        for key in keys {
            let known = table.key(&key).cloned();
            let (Some(known), Some(item)) = (known, table.remove(&key)) else { continue };
            let known = if key == *old {
                let renamed = Key::new(*new).with_leaf_decor(known.leaf_decor().clone());
                renamed.with_dotted_decor(known.dotted_decor().clone())
            } else {
                known
            };
            table.entry_format(&known).or_insert(item);
        }
    }
    Ok(())
}
