//! A map as TOML: numbers read from their source text, so that 0.1 is 1/10; errors that name file, line, key
//! and value.

use num_rational::BigRational;
use toml_edit::{Item, Value};

use super::{Entry, Map, map::Key};
use crate::{
    error::Result,
    source::{Source, unknown},
};

const KEYS: [&str; 6] = ["format", "A", "B", "C", "e", "P"];
const FORMAT: &str = "grazing-map 1";

impl Map {
    /// Reads a map from the text of a TOML file; `name` leads every error message. The format is in
    /// docs/formats.md. Cost: linear in the length of the text, and that of [`Map::new`].
    ///
    /// # Errors
    /// An input error `name:line: key = value: what is wrong`, for the text's form and for every condition of
    /// [`Map::new`].
    ///
    /// ```
    /// use grazing::pattern::Map;
    /// let text = r#"
    ///     format = "grazing-map 1"
    ///     A = [[0.1, 1], ["-1/3", 0]]
    ///     B = [0, 1]
    ///     C = [1, 0]
    ///     e = { lo = "0.9", hi = "1.1" }
    /// "#;
    /// let map = Map::from_toml(text, "map.toml")?;
    /// assert_eq!(map.a()[(0, 0)].to_string(), "1/10");
    /// # Ok::<(), grazing::Error>(())
    /// ```
    pub fn from_toml(text: &str, name: &str) -> Result<Map> {
        let source = Source { text, name };
        let entries = Entries(&source);
        let document = source.document()?;
        let table = document.as_table();
        for (key, item) in table.iter() {
            if !KEYS.contains(&key) {
                let span = table.key(key).and_then(toml_edit::Key::span).or(item.span());
                return Err(source.fail(span, &unknown(key, &KEYS)));
            }
        }
        let get = |key: &'static str| {
            table.get(key).ok_or_else(|| {
                source.fail(None, &format!("there is no key {key}; a map has {}", KEYS[..5].join(", ")))
            })
        };
        let format = get("format")?;
        if format.as_str() != Some(FORMAT) {
            return Err(source.at("format", format.span(), &format!("this version reads \"{FORMAT}\"")));
        }
        let a = entries.matrix("A", get("A")?)?;
        let b = entries.vector("B", get("B")?)?;
        let c = entries.vector("C", get("C")?)?;
        let e = match get("e")?.as_value() {
            Some(value) => entries.entry("e", value)?,
            None => return Err(source.at("e", get("e")?.span(), "is not a number")),
        };
        let section = table.get("P").map(|item| entries.matrix("P", item)).transpose()?;
        Map::checked(a, b, c, e, section)
            .map_err(|(Key(key), condition)| source.at(key, table.get(key).and_then(Item::span), &condition))
    }
}

/// What a map is made of.
struct Entries<'a>(&'a Source<'a>);

impl Entries<'_> {
    fn matrix(&self, key: &str, item: &Item) -> Result<Vec<Vec<Entry>>> {
        let Some(rows) = item.as_array() else {
            return Err(self.0.at(key, item.span(), "is not an array of rows [[…], […]]"));
        };
        let row = |(i, value): (usize, &Value)| self.list(&format!("{key}[{}]", i + 1), value);
        rows.iter().enumerate().map(row).collect()
    }

    fn vector(&self, key: &str, item: &Item) -> Result<Vec<Entry>> {
        match item.as_value() {
            Some(value) => self.list(key, value),
            None => Err(self.0.at(key, item.span(), "is not an array of numbers")),
        }
    }

    fn list(&self, key: &str, value: &Value) -> Result<Vec<Entry>> {
        let Some(entries) = value.as_array() else {
            return Err(self.0.at(key, value.span(), "is not an array of numbers"));
        };
        entries.iter().enumerate().map(|(i, value)| self.entry(&format!("{key}[{}]", i + 1), value)).collect()
    }

    /// An exact number, or `{ lo = …, hi = … }`.
    fn entry(&self, key: &str, value: &Value) -> Result<Entry> {
        let Value::InlineTable(table) = value else { return Ok(self.one(key, value)?.into()) };
        if let Some((other, _)) = table.iter().find(|(key, _)| !["lo", "hi"].contains(key)) {
            return Err(self.0.at(key, value.span(), &unknown(other, &["lo", "hi"])));
        }
        let bound = |end: &str| match table.get(end) {
            Some(value) => self.one(&format!("{key}.{end}"), value),
            None => Err(self.0.at(
                key,
                value.span(),
                &format!("an interval needs both lo and hi; {end} is missing"),
            )),
        };
        Entry::between(bound("lo")?, bound("hi")?)
            .map_err(|error| self.0.at(key, value.span(), &error.to_string()))
    }

    fn one(&self, key: &str, value: &Value) -> Result<BigRational> {
        if value.is_array() {
            let message = "is an array, not a number; an interval is { lo = \"…\", hi = \"…\" }";
            return Err(self.0.at(key, value.span(), message));
        }
        self.0.exact(key, value)
    }
}
