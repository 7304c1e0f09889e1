//! What can be asked of a scene: one struct a kind of task, all kinds registered in one table.
//!
//! To add a kind: declare its keys in a file beside this one, add its line to `kinds!` and its checks to
//! `check.rs`, and write `run/<kind>.rs`.

use num_rational::BigRational;

use super::{
    branches::{BranchTask, CrisisTask, DiagramTask, MapTask},
    chaos::ChaosTask,
    keys::{Entry, Key, Record, Value, keys},
    orbits::{EventTask, GrazingTask, OrbitTask},
    response::ResponseTask,
    rest::RestTask,
    sections::{BasinsTask, SectionTask},
    simulate::SimulateTask,
    validate::ValidateTask,
};
use crate::{error::Result, source::nearest};

/// One thing to do with a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Task {
    /// What its files are called.
    pub name: String,
    /// The name it shares with others, for `--only`.
    pub group: Option<String>,
    /// Parameter values that it has in place of the scene's.
    pub set: Vec<(String, BigRational)>,
    /// What to do.
    pub kind: Kind,
    /// Where in the file it stands, as `tasks[1]`.
    pub path: String,
}

keys! {
    /// Something to do; its other keys depend on its kind.
    pub struct TaskKeys {
        /// of its files and report: letters, digits, `-` and `_`, at most 200
        name: String,
        /// one of those below
        kind: String,
        /// `--only` runs all of a group
        group: Option<String>,
        /// parameters in place of the scene's, as `{ mu = -0.05 }`
        set: Assignments = "{}",
    }
}

/// New values of parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Assignments(pub(crate) Vec<(String, BigRational)>);

impl Value for Assignments {
    fn shape() -> String {
        "table of numbers".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        let mut all = Vec::new();
        let names: Vec<&str> = entry.scope.names.iter().map(String::as_str).collect();
        entry.only(&names)?;
        for name in names {
            if let Some(value) = entry.get(name)? {
                all.push((name.to_string(), value.number()?));
            }
        }
        Ok(Assignments(all))
    }
}

/// The kinds of tasks: for each the word in the file, and its keys.
macro_rules! kinds {
    ($($word:literal $kind:ident,)+) => {
        /// What a task does.
        #[derive(Debug, Clone, PartialEq)]
        pub enum Kind { $(#[doc = concat!("`", $word, "`.")] $kind(Box<$kind>),)+ }

        impl Kind {
            /// Its word in the file.
            pub fn word(&self) -> &'static str {
                match self { $(Kind::$kind(_) => $word,)+ }
            }

            fn read(word: &str, entry: &Entry, common: &[&str]) -> Option<Result<Self>> {
                match word {
                    $($word => Some($kind::fields(entry, common).map(|task| Kind::$kind(Box::new(task)))),)+
                    _ => None,
                }
            }
        }

        /// Word, meaning and keys of every kind.
        pub(super) const KINDS: &[(&str, &str, &[Key])] = &[$(($word, $kind::ABOUT, $kind::KEYS)),+];
    };
}

impl Kind {
    /// The parameter that it varies, if it varies one.
    pub fn parameter(&self) -> Option<&str> {
        match self {
            Kind::OrbitTask(task) => task.parameter.as_deref(),
            Kind::EventTask(task) => Some(&task.parameter),
            Kind::GrazingTask(task) => Some(&task.parameter),
            Kind::BranchTask(task) => Some(&task.parameter),
            Kind::DiagramTask(task) => Some(&task.parameter),
            Kind::ResponseTask(task) => Some(&task.parameter),
            Kind::MapTask(task) => Some(&task.parameter),
            Kind::CrisisTask(task) => Some(&task.parameter),
            Kind::RestTask(task) => task.parameter.as_deref(),
            Kind::ValidateTask(task) => task.parameter.as_deref(),
            Kind::ChaosTask(task) => task.parameter.as_deref(),
            Kind::SimulateTask(_) | Kind::SectionTask(_) | Kind::BasinsTask(_) => None,
        }
    }

    /// Another that varies beside it.
    pub fn second(&self) -> Option<&str> {
        match self {
            Kind::BranchTask(task) => task.second.as_deref(),
            Kind::MapTask(task) => Some(&task.second),
            _ => None,
        }
    }
}

kinds! {
    "simulate" SimulateTask,
    "section" SectionTask,
    "basins" BasinsTask,
    "orbit" OrbitTask,
    "event" EventTask,
    "grazing" GrazingTask,
    "branch" BranchTask,
    "diagram" DiagramTask,
    "response" ResponseTask,
    "map" MapTask,
    "crisis" CrisisTask,
    "rest" RestTask,
    "validate" ValidateTask,
    "chaos" ChaosTask,
}

impl Task {
    pub(super) fn read(entry: &Entry) -> Result<Task> {
        let common: Vec<&str> = TaskKeys::KEYS.iter().map(|key| key.name).collect();
        // The kind first: only then is it known which keys there may be.
        let key = TaskKeys::KEYS.iter().find(|key| key.name == "kind");
        let word: String = entry.field(key.unwrap_or_else(|| unreachable!("tasks have a kind")))?;
        let Some(kind) = Kind::read(&word, entry, &common) else {
            let words: Vec<&str> = KINDS.iter().map(|kind| kind.0).collect();
            let near = nearest(&word, words.iter().copied());
            let near = near.map_or(String::new(), |near| format!("; the nearest is {near:?}"));
            let at = entry.get("kind")?.unwrap_or_else(|| unreachable!("it has just been read"));
            return Err(at.fail(&format!("is none of {}{near}", words.join(", "))));
        };
        let kind = kind?;
        let kind_keys = KINDS.iter().find(|known| known.0 == word).map_or(&[][..], |known| known.2);
        let extra: Vec<&str> = kind_keys.iter().map(|key| key.name).collect();
        let TaskKeys { name, group, set: Assignments(set), .. } = TaskKeys::fields(entry, &extra)?;
        // File systems hold 255 bytes, of which endings take some 40.
        if !(1..=200).contains(&name.len())
            || !name.chars().all(|c| c.is_ascii_alphanumeric() || "-_".contains(c))
        {
            let at = entry.get("name")?.unwrap_or_else(|| unreachable!("it has just been read"));
            return Err(at.fail("names files: write letters, digits, - and _, at most 200"));
        }
        Ok(Task { name, group, set, kind, path: entry.path.clone() })
    }
}
