//! The keys of a scene: one declaration each, from which come the typed field, its reader, its default and
//! its row of the reference table.
//!
//! `keys!` declares a table of the file as a struct. A field's type says what may stand there ([`Value`]); a
//! default is TOML text, read as if it stood in the file; without one the key is required, but for `Option`.

use std::{
    cell::{Cell, RefCell},
    collections::{BTreeMap, HashSet},
    ops::Range,
    path::{Path, PathBuf},
};

use num_rational::BigRational;
use num_traits::ToPrimitive;
use toml_edit::{Item, TableLike};

use super::{
    dimension::Measured,
    expression::Expression,
    format::SceneFormat,
    grammar::LIMIT_BITS,
    quantity::{Bare, Kinds, Scale, bare, counts_cycles, has_units},
};
use crate::{
    error::{Error, Result},
    motion::Side,
    output::read_text,
    quantity::Dimension,
    source::{Source, nearest, unknown},
};

/// What the reference says of a key.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Key {
    /// Its name.
    pub name: &'static str,
    /// What may stand there.
    pub shape: fn() -> String,
    /// What holds if it is absent, as TOML text.
    pub default: Option<fn() -> String>,
    /// Whether it must be given.
    pub required: bool,
    /// What it means.
    pub about: &'static str,
    /// The table that stands there, or in a list there: what it is, and its keys.
    pub(super) table: fn() -> Option<Table>,
}

/// What a table is, and its keys.
pub(super) type Table = (&'static str, &'static [Key]);

/// A table of the file.
pub(super) trait Record: Sized {
    /// What the table is.
    const ABOUT: &'static str;
    /// Its keys, in the order of the reference.
    const KEYS: &'static [Key];

    fn fields(entry: &Entry, extra: &[&str]) -> Result<Self>;
}

/// What a scene has in place of a word that others use, or that its format does not have.
fn foreign(format: SceneFormat, path: &str, key: &str) -> Option<String> {
    let newer = |what: &str| {
        Some(format!("{what}; write format = {:?} (`grazing run --upgrade` does)", SceneFormat::Three.word()))
    };
    match (format, path, key) {
        (SceneFormat::One, "system", "mass") => return newer("in format 1 the mass is 1"),
        (SceneFormat::One, "system", "period" | "frequency") => {
            return newer("in format 1 the forcing has period 2π");
        }
        (SceneFormat::One, path, "stiffness" | "damping" | "law") if path.starts_with("stops[") => {
            return newer("walls of format 1 are rigid");
        }
        (SceneFormat::Two, path, "side") if path.starts_with("stops[") => {
            return newer(
                "a stop of format 2 is where row·q − offset is negative, row = [-1] for an upper one",
            );
        }
        (SceneFormat::Two | SceneFormat::Three, path, "walls") if path.contains("orbit") => {
            return Some("the stops of an orbit's impacts are named in `stops`".to_string());
        }
        _ if !format.has(path, key) => return newer(&format!("{} does not have it", format.word())),
        _ => {}
    }
    // What stands in a task are keys of its own, and in its `set` parameters.
    if path.starts_with("tasks[") {
        return None;
    }
    let instead = match key.to_lowercase().as_str() {
        "m" => "the mass is `mass` of [system]",
        "gravity" | "g" => "a constant force is `force` of [system], negative downwards",
        "friction" | "dry_friction" | "coulomb" => {
            "dry friction stands in [[friction]], one table for each row that slides"
        }
        "omega" | "period_of_forcing" => {
            "how often the forcing repeats is `frequency` or `period` of [system]"
        }
        "amplitude" => "the forcing is a list of harmonics in [system]: forcing = [{ cos = … }]",
        "c" if path == "system" => "the damping is `damping` of [system]",
        "zeta" | "ζ" => "the damping ratio is `damping_ratio` of [system]",
        "f" | "freq" | "hz" if path == "system" => "it is called `frequency`",
        "spring" | "k_spring" => "the spring is `stiffness` of [system]",
        "k" if path == "system" => "the spring is `stiffness` of [system]",
        "e" | "cor" if path.starts_with("stops[") => "it is called `restitution`",
        "tau" | "coefficient_of_restitution" => "it is called `restitution`",
        "gap" | "clearance" if path.starts_with("stops[") => "where it stands is `offset`",
        "wall" | "walls" | "stop" if format == SceneFormat::Three => {
            "stops stand in [[stops]], one table each"
        }
        "wall" => "walls stand in [[walls]], one table each",
        _ => return None,
    };
    Some(instead.to_string())
}

/// What a key may hold.
pub(super) trait Value: Sized {
    fn shape() -> String;

    /// The keys of a value that is a table of its own, or a list of such.
    fn table() -> Option<Table> {
        None
    }

    /// What an absent key without a default means, where that is allowed.
    const ABSENT: Option<fn() -> Self> = None;

    fn read(entry: &Entry) -> Result<Self>;
}

/// A value of the file on its way into the scene.
pub(super) struct Entry<'a> {
    pub(crate) scope: &'a Scope<'a>,
    /// The keys and numbers that lead to it, as in `walls[1].offset`.
    pub(crate) path: String,
    /// Where it stands.
    pub(crate) span: Option<Range<usize>>,
    pub(crate) item: Item,
}

/// What every value is read against.
pub(super) struct Scope<'a> {
    pub source: Source<'a>,
    /// The file's format, in whose words errors are told.
    pub format: SceneFormat,
    /// The names of the parameters.
    pub names: &'a [String],
    /// The stops, once they are known.
    pub stops: &'a [StopName],
    /// The units of bare numbers, and which parameters have units; none where there can be none.
    pub quantities: Option<(&'a Scale, &'a Kinds)>,
    /// What has been read.
    pub seen: &'a Seen,
}

/// A stop, as tasks name it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StopName {
    /// Its name.
    pub(crate) name: String,
    /// On which side of the one coordinate it stands, where the engine is `one`.
    pub(crate) side: Option<Side>,
}

/// What of a scene has been read.
#[derive(Debug, Default)]
pub(super) struct Seen {
    /// Where every value stands.
    pub places: RefCell<BTreeMap<String, Range<usize>>>,
    /// The files beside the scene.
    pub files: RefCell<Vec<PathBuf>>,
    /// What has units, and what it is.
    pub measured: RefCell<Vec<(String, Dimension)>>,
    /// Whether a unit of length, time or mass is written.
    pub scaled: Cell<bool>,
    /// The names that stand in expressions.
    pub used: RefCell<HashSet<String>>,
}

impl Seen {
    fn uses(&self, text: &str, names: &[String]) {
        let words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
        let known = words.filter(|word| names.iter().any(|name| name == word));
        self.used.borrow_mut().extend(known.map(str::to_string));
    }
}

impl<'a> Entry<'a> {
    pub(crate) fn new(scope: &'a Scope<'a>, path: String, span: Option<Range<usize>>, item: Item) -> Self {
        let span = item.span().or(span);
        if let Some(span) = &span {
            scope.seen.places.borrow_mut().insert(path.clone(), span.clone());
        }
        Entry { scope, path, span, item }
    }

    /// `file:line: key = value: message`.
    pub(crate) fn fail(&self, message: &str) -> Error {
        if self.path.is_empty() {
            return self.scope.source.fail(None, message);
        }
        self.scope.source.at(&self.own_path(), self.span.clone(), message)
    }

    /// Its path in the words of the file's format.
    fn own_path(&self) -> String {
        self.scope.format.path(&self.path)
    }

    pub(crate) fn table(&self) -> Result<&dyn TableLike> {
        self.item.as_table_like().ok_or_else(|| self.fail("is not a table of keys"))
    }

    /// The value of a key of this table, if it is there.
    pub(crate) fn get(&self, key: &str) -> Result<Option<Entry<'a>>> {
        let table = self.table()?;
        Ok(table.get(key).map(|item| {
            let span = table.key(key).and_then(toml_edit::Key::span).or(self.span.clone());
            Entry::new(self.scope, self.below(key), span, item.clone())
        }))
    }

    /// The keys of this table with their values, in the order of the file.
    pub(crate) fn named(&self) -> Result<Vec<(String, Entry<'a>)>> {
        let names: Vec<String> = self.table()?.iter().map(|(name, _)| name.to_string()).collect();
        let one = |name: String| Ok(self.get(&name)?.map(|entry| (name, entry)));
        names.into_iter().filter_map(|name| one(name).transpose()).collect()
    }

    /// The text of a file of at most so many bytes that is named from the scene's folder, and its path.
    pub(crate) fn beside(&self, name: &str, most: u64) -> Result<(PathBuf, String)> {
        let file = Path::new(self.scope.source.name).parent().unwrap_or(Path::new("")).join(name);
        self.scope.seen.files.borrow_mut().push(file.clone());
        let text = read_text(&file, most).map_err(|error| self.fail(&error.to_string()))?;
        Ok((file, text))
    }

    /// The place of another value of the file, by its path, for errors.
    pub(crate) fn at(&self, path: &str) -> Entry<'a> {
        let span = self.scope.seen.places.borrow().get(path).cloned();
        Entry { scope: self.scope, path: path.to_string(), span, item: Item::None }
    }

    fn below(&self, key: &str) -> String {
        if self.path.is_empty() { key.to_string() } else { format!("{}.{key}", self.path) }
    }

    /// What a table has of the scene's parameters, in their order; other keys are refused.
    pub(crate) fn of_parameters<T>(&self, read: impl Fn(&Entry) -> Result<T>) -> Result<Vec<(String, T)>> {
        let names: Vec<&str> = self.scope.names.iter().map(String::as_str).collect();
        self.only(&names)?;
        let mut all = Vec::new();
        for name in names {
            if let Some(value) = self.get(name)? {
                all.push((name.to_string(), read(&value)?));
            }
        }
        Ok(all)
    }

    /// Refuses keys that are not among `known`, or that the file's format does not have.
    pub(crate) fn only(&self, known: &[&str]) -> Result<()> {
        let (table, format) = (self.table()?, self.scope.format);
        let has = |key: &str| known.contains(&key) && format.has(&self.path, key);
        let Some((key, item)) = table.iter().find(|(key, _)| !has(key)) else { return Ok(()) };
        let span = table.key(key).and_then(toml_edit::Key::span).or(item.span()).or(self.span.clone());
        let place = if self.path.is_empty() { String::new() } else { format!("{}: ", self.own_path()) };
        let message = foreign(format, &self.path, key).map_or_else(
            || {
                let here = known.iter().filter(|key| format.has(&self.path, key));
                unknown(key, &here.map(|key| format.key(&self.path, key)).collect::<Vec<_>>())
            },
            |instead| format!("unknown key {key:?}: {instead}"),
        );
        Err(self.scope.source.fail(span, &format!("{place}{message}")))
    }

    /// The value of a key, or its default.
    pub(crate) fn field<T: Value>(&self, key: &Key) -> Result<T> {
        if let Some(entry) = self.get(key.name)? {
            return T::read(&entry);
        }
        if let Some(default) = key.default {
            let text = format!("x = {}", default());
            let (source, seen) = (Source { text: &text, name: "default" }, Seen::default());
            let document = source.document()?;
            let item = document.as_table()["x"].clone();
            let scope = Scope { source: source.clone(), names: &[], seen: &seen, ..*self.scope };
            let path = self.below(key.name);
            return T::read(&Entry::new(&scope, path, None, item))
                .map_err(|error| self.fail(&error.to_string()));
        }
        let optional = !self.scope.format.requires(&self.path, key.name);
        T::ABSENT.filter(|_| optional).map(|absent| absent()).ok_or_else(|| {
            let place = if self.path.is_empty() { "a scene".into() } else { self.own_path() };
            let name = self.scope.format.key(&self.path, key.name);
            let message = format!("{place} has no key {name}, which must be given: {}", (key.shape)());
            self.scope.source.fail(self.span.clone(), &message)
        })
    }

    /// The elements of an array, or of an array of tables.
    pub(crate) fn elements(&self) -> Result<Vec<Entry<'a>>> {
        let items: Vec<Item> = match &self.item {
            Item::Value(toml_edit::Value::Array(array)) => array.iter().cloned().map(Item::Value).collect(),
            Item::ArrayOfTables(tables) => tables.iter().cloned().map(Item::Table).collect(),
            Item::Table(_) if !self.path.contains('.') => {
                let name = self.own_path();
                return Err(
                    self.fail(&format!("is one table, not a list of them: write [[{name}]] above each"))
                );
            }
            Item::Value(toml_edit::Value::InlineTable(table)) => {
                let table = table.to_string();
                return Err(self.fail(&format!("is one table, not a list of them: write [{}]", table.trim())));
            }
            _ => return Err(self.fail("is not a list […]")),
        };
        let one = |(i, item)| Entry::new(self.scope, format!("{}[{i}]", self.path), self.span.clone(), item);
        Ok((1..).zip(items).map(one).collect())
    }

    /// An exact number, in the scene's units if it has some.
    pub(crate) fn number(&self) -> Result<BigRational> {
        let value = self.item.as_value().ok_or_else(|| self.fail("is not a number"))?;
        if let Some(found) = value.as_str().map(|text| self.quantity(text, &[])).transpose()?.flatten() {
            return found.value().map_err(|error| self.fail(&error.to_string()));
        }
        self.scope.source.exact_within(&self.own_path(), value, LIMIT_BITS)
    }

    pub(crate) fn text(&self) -> Result<&str> {
        self.item.as_str().ok_or_else(|| self.fail("is not text \"…\""))
    }

    /// A number or a text: what an expression is written as, in bare numbers of the scene.
    pub(crate) fn expression(&self) -> Result<String> {
        let value = self.item.as_value().ok_or_else(|| self.fail("is not an expression"))?;
        let text = self.scope.source.number_text(value);
        let text = text.ok_or_else(|| self.fail("is not an expression: write a number, or \"…\""))?;
        self.scope.seen.uses(&text, self.scope.names);
        Ok(self.quantity(&text, self.scope.names)?.map_or(text, |found| found.text))
    }

    /// What a text with units, or with parameters that have some, is in bare numbers of the scene; none of
    /// any other. What it is a mass or a length of is checked later.
    pub(super) fn quantity(&self, text: &str, names: &[String]) -> Result<Option<Bare>> {
        let fail = |error: Error| self.fail(&error.to_string());
        let Some(quantities) = self.scope.quantities else {
            let (format, newer) = (self.scope.format, SceneFormat::Three.word());
            let why =
                format!("has a unit, which needs format = {newer:?} (`grazing run --upgrade` writes that)");
            return if format != SceneFormat::Three && has_units(text, names) {
                Err(self.fail(&why))
            } else {
                Ok(None)
            };
        };
        let Some(mut found) = bare(text, names, quantities).map_err(fail)? else { return Ok(None) };
        if counts_cycles(&self.path) {
            found.in_cycles().map_err(fail)?;
        }
        let seen = self.scope.seen;
        seen.scaled.set(seen.scaled.get() || found.scaled);
        if let Measured::Known(dimension) = found.measured {
            seen.measured.borrow_mut().push((self.path.clone(), dimension));
        }
        Ok(Some(found))
    }

    /// One of some words.
    pub(crate) fn word<T: Copy>(&self, words: &[(&'static str, T)]) -> Result<T> {
        let text = self.text()?;
        if let Some((_, value)) = words.iter().find(|(word, _)| *word == text) {
            return Ok(*value);
        }
        let all: Vec<String> = words.iter().map(|(word, _)| format!("{word:?}")).collect();
        let near = nearest(text, words.iter().map(|(word, _)| *word));
        let near = near.map_or(String::new(), |near| format!("; the nearest is {near:?}"));
        Err(self.fail(&format!("is none of {}{near}", all.join(", "))))
    }

    fn whole(&self, least: u64, most: u64) -> Result<u64> {
        let value = self.number()?;
        let whole = value.is_integer().then(|| value.to_integer().to_u64()).flatten();
        whole
            .filter(|value| (least..=most).contains(value))
            .ok_or_else(|| self.fail(&format!("is not a whole number from {least} to {most}")))
    }
}

/// Declares a table of the file; see the head of this module.
macro_rules! keys {
    ($(#[doc = $about:literal])+ pub struct $name:ident {
        $($(#[doc = $doc:literal])+ $key:ident: $type:ty $(= $default:literal)?,)*
    }) => {
        $(#[doc = $about])+
        #[derive(Debug, Clone, PartialEq)]
        pub struct $name { $($(#[doc = $doc])+ pub $key: $type,)* }

        $crate::scene::keys::record! {
            $name { $($about)+ } $($key: $type [$crate::scene::keys::default!($($default)?)] { $($doc)+ })*
        }
    };
}
pub(super) use keys;

/// Reads a struct declared elsewhere with its defaults as a table of keys.
macro_rules! read_into {
    ($(#[doc = $about:literal])+ pub struct $name:ident {
        $($(#[doc = $doc:literal])+ $key:ident: $type:ty = $default:expr,)*
    }) => {
        $crate::scene::keys::record! {
            $name { $($about)+ }
            $($key: $type [Some((|| format!("{:?}", $name::default().$key)) as fn() -> String)] { $($doc)+ })*
        }
    };
}
pub(super) use read_into;

/// Makes a struct a table of keys.
macro_rules! record {
    ($name:ident { $($about:literal)+ } $($key:ident: $type:ty [$default:expr] { $($doc:literal)+ })*) => {
        impl $crate::scene::keys::Record for $name {
            const ABOUT: &'static str = concat!($($about),+);
            const KEYS: &'static [$crate::scene::keys::Key] =
                &[$($crate::scene::keys::Key {
                    name: stringify!($key),
                    shape: <$type as $crate::scene::keys::Value>::shape,
                    default: $default,
                    required: $default.is_none() && <$type as $crate::scene::keys::Value>::ABSENT.is_none(),
                    about: concat!($($doc),+),
                    table: <$type as $crate::scene::keys::Value>::table,
                }),*];

            fn fields(
                entry: &$crate::scene::keys::Entry,
                extra: &[&str],
            ) -> $crate::error::Result<Self> {
                let known: Vec<&str> = Self::KEYS.iter().map(|key| key.name).chain(extra.iter().copied()).collect();
                entry.only(&known)?;
                let mut keys = Self::KEYS.iter();
                Ok($name { $($key: entry.field(keys.next().expect(stringify!($key)))?,)* })
            }
        }

        impl $crate::scene::keys::Value for $name {
            fn shape() -> String {
                format!("table of {}", [$(stringify!($key)),*].join(", "))
            }

            fn table() -> Option<$crate::scene::keys::Table> {
                Some((
                    <Self as $crate::scene::keys::Record>::ABOUT,
                    <Self as $crate::scene::keys::Record>::KEYS,
                ))
            }

            fn read(entry: &$crate::scene::keys::Entry) -> $crate::error::Result<Self> {
                <Self as $crate::scene::keys::Record>::fields(entry, &[])
            }
        }
    };
}
pub(super) use record;

macro_rules! default {
    () => {
        None::<fn() -> String>
    };
    ($text:literal) => {
        Some((|| $text.to_string()) as fn() -> String)
    };
}
pub(super) use default;

/// Declares a choice among words.
macro_rules! words {
    ($(#[doc = $about:literal])+ pub enum $name:ident {
        $($(#[doc = $doc:literal])+ $variant:ident = $word:literal,)+
    }) => {
        $(#[doc = $about])+
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum $name { $($(#[doc = $doc])+ $variant,)+ }

        impl $crate::scene::keys::Value for $name {
            fn shape() -> String {
                [$(concat!("`\"", $word, "\"`")),+].join(" or ")
            }

            fn read(entry: &$crate::scene::keys::Entry) -> $crate::error::Result<Self> {
                entry.word(&[$(($word, $name::$variant)),+])
            }
        }

        impl $name {
            /// Its word in the file.
            pub fn word(self) -> &'static str {
                match self { $($name::$variant => $word,)+ }
            }
        }
    };
}
pub(super) use words;

impl Value for BigRational {
    fn shape() -> String {
        "number".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        entry.number()
    }
}

impl Value for f64 {
    fn shape() -> String {
        "number".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        let value = entry.number()?.to_f64().filter(|value| value.is_finite());
        value.ok_or_else(|| entry.fail("is beyond the range of floats"))
    }
}

impl Value for u32 {
    fn shape() -> String {
        "whole number".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        Ok(entry.whole(0, u32::MAX.into())? as u32)
    }
}

impl Value for u64 {
    fn shape() -> String {
        "whole number".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        entry.whole(0, 1 << 53)
    }
}

impl Value for bool {
    fn shape() -> String {
        "`true` or `false`".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        entry.item.as_bool().ok_or_else(|| entry.fail("is neither true nor false"))
    }
}

impl Value for String {
    fn shape() -> String {
        "text".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        entry.text().map(str::to_string)
    }
}

impl Value for Expression {
    fn shape() -> String {
        "expression".to_string()
    }

    fn read(entry: &Entry) -> Result<Self> {
        let text = entry.expression()?;
        let parsed = Expression::parse(&text, entry.scope.names);
        let mut expression = parsed.map_err(|error| entry.fail(&error.to_string()))?;
        expression.key.clone_from(&entry.path);
        Ok(expression)
    }
}

/// The plural of what may stand in a list; a choice of words has none.
fn plural(shape: &str) -> String {
    match shape.split_once(" of ") {
        Some((one, rest)) => format!("{one}s of {rest}"),
        None if shape.starts_with('`') => shape.to_string(),
        None => format!("{shape}s"),
    }
}

impl<T: Value> Value for Vec<T> {
    fn shape() -> String {
        format!("list of {}", plural(&T::shape()))
    }

    fn table() -> Option<Table> {
        T::table()
    }

    fn read(entry: &Entry) -> Result<Self> {
        entry.elements()?.iter().map(T::read).collect()
    }
}

impl<T: Value> Value for Option<T> {
    fn shape() -> String {
        T::shape()
    }

    fn table() -> Option<Table> {
        T::table()
    }

    const ABSENT: Option<fn() -> Self> = Some(|| None);

    fn read(entry: &Entry) -> Result<Self> {
        T::read(entry).map(Some)
    }
}
