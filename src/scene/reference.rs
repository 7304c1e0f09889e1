//! The reference of all keys as Markdown.

use std::fmt::Write;

use super::{
    input::TABLES,
    keys::{Key, Record},
    task::{KINDS, Start, TaskKeys},
};

/// Every table of a scene file with its keys: what may stand there, what holds without it, what it means.
pub fn reference() -> String {
    let mut text = String::new();
    let tasks = [("`[[tasks]]`", TaskKeys::ABOUT, TaskKeys::KEYS), ("a `start`", Start::ABOUT, Start::KEYS)];
    for &(name, about, keys) in TABLES.iter().chain(&tasks) {
        table(&mut text, name, about, keys);
    }
    for &(word, about, keys) in KINDS {
        table(&mut text, &format!("tasks with `kind = \"{word}\"`"), about, keys);
    }
    text
}

fn table(text: &mut String, name: &str, about: &str, keys: &[Key]) {
    let mut name = name.to_string();
    name[..1].make_ascii_uppercase();
    let _ = write!(
        text,
        "### {name}\n\n{}\n\n| key | value | default | |\n| --- | --- | --- | --- |\n",
        about.trim()
    );
    for key in keys {
        let default = match key.default {
            Some(default) => format!("`{}`", default()),
            None if key.required => "must be given".to_string(),
            None => String::new(),
        };
        let _ = writeln!(text, "| `{}` | {} | {default} | {} |", key.name, (key.shape)(), key.about.trim());
    }
    text.push('\n');
}
