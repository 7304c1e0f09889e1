//! The reference of all keys as Markdown.

use std::fmt::Write;

use super::{
    input::FILE,
    keys::{Key, Record, Table, Value},
    matrix::{CoordinateList, MatrixValue},
    simulate::Start,
    system::TABLES,
    task::{KINDS, TaskKeys},
    units,
};

/// Every table of a scene file with its keys, nested ones after those in which they stand: what may stand
/// there, what holds without it, what it means.
pub fn reference() -> String {
    let mut text = String::new();
    let tasks = [("`[[tasks]]`", TaskKeys::ABOUT, TaskKeys::KEYS), ("a `start`", Start::ABOUT, Start::KEYS)];
    let mut written: Vec<&str> = Vec::new();
    // What it is, its keys, and the names under which it stands.
    let mut nested: Vec<(Table, Vec<&str>)> = Vec::new();
    for &(name, about, keys) in [FILE].iter().chain(TABLES).chain(&[units::TABLE]).chain(&tasks) {
        written.push(about);
        table(&mut text, name, about, keys);
    }
    for &(word, about, keys) in KINDS {
        table(&mut text, &format!("tasks with `kind = \"{word}\"`"), about, keys);
        collect(keys, &mut nested);
    }
    nested.retain(|(table, _)| !written.contains(&table.0));
    for ((about, keys), names) in nested {
        let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
        table(&mut text, &format!("inside {}", names.join(" and ")), about, keys);
    }
    text
}

/// Adds the tables below some keys, each once, with all names under which it stands.
fn collect(keys: &'static [Key], nested: &mut Vec<(Table, Vec<&'static str>)>) {
    for key in keys {
        let Some(table) = (key.table)() else { continue };
        match nested.iter_mut().find(|(known, _)| known.0 == table.0) {
            Some((_, names)) if names.contains(&key.name) => {}
            Some((_, names)) => names.push(key.name),
            None => {
                nested.push((table, vec![key.name]));
                collect(table.1, nested);
            }
        }
    }
}

fn table(text: &mut String, name: &str, about: &str, keys: &[Key]) {
    let mut name = name.to_string();
    name[..1].make_ascii_uppercase();
    let about = wrapped(about);
    let _ =
        write!(text, "### {name}\n\n{about}\n\n| key | value; default | meaning |\n| --- | --- | --- |\n");
    for key in keys {
        let default = key.default.map_or(String::new(), |default| format!("; `{}`", default()));
        let must = if key.required { "\\*" } else { "" };
        // A bar would end the cell.
        let about = key.about.trim().replace('|', "\\|");
        let _ = writeln!(text, "| `{}`{must} | {}{default} | {about} |", key.name, short(key));
    }
    text.push('\n');
}

/// What may stand there in a word, which the page explains once.
fn short(key: &Key) -> String {
    let shape = (key.shape)();
    match (key.table)() {
        Some(_) if shape.starts_with("list") => return "tables".to_string(),
        Some(_) if shape.starts_with("table") => return "table".to_string(),
        _ => {}
    }
    match shape.as_str() {
        _ if shape == MatrixValue::shape() => "matrix".to_string(),
        _ if shape == CoordinateList::shape() => "vector".to_string(),
        _ => shape
            .replace("whole number", "integer")
            .replace("true` or `false", "true`/`false")
            .replace(" or `", ", `"),
    }
}

/// The words in lines of at most 110 columns.
fn wrapped(about: &str) -> String {
    let mut text = String::new();
    let mut column = 0;
    for word in about.split_whitespace() {
        let width = word.chars().count();
        if column > 0 && column + 1 + width > 110 {
            text.push('\n');
            column = 0;
        } else if column > 0 {
            text.push(' ');
            column += 1;
        }
        text.push_str(word);
        column += width;
    }
    text
}
