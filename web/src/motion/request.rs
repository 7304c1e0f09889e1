//! What the page asks for: a JSON object, its values read with their ranges, or written as keys of tasks.

use std::fmt::Write;

use grazing_scenes::{Error, Result, num_rational::BigRational, number::parse_rational};
use serde_json::Value;

use super::document::{Changeable, Values, quoted};

/// What the page asks for.
pub struct Request(pub(super) Value);

impl Request {
    pub(super) fn text(&self, key: &str) -> Result<&str> {
        self.0[key].as_str().ok_or_else(|| Error::input(format!("the page's request has no text {key:?}")))
    }

    /// Whether something is asked for.
    pub(super) fn is_set(&self, key: &str) -> bool {
        self.0[key] == true
    }

    pub(super) fn number(
        &self,
        key: &str,
        default: u64,
        range: std::ops::RangeInclusive<u64>,
    ) -> Result<u64> {
        let value = match &self.0[key] {
            Value::Null => default,
            given => {
                given.as_u64().ok_or_else(|| Error::input(format!("{key} = {given}: not a whole number")))?
            }
        };
        if range.contains(&value) {
            return Ok(value);
        }
        Err(Error::input(format!("{key} = {value}: from {} to {}", range.start(), range.end())))
    }

    pub(super) fn exact(&self, key: &str) -> Result<BigRational> {
        parse_rational(self.text(key)?).map_err(|error| Error::from(error).context(key))
    }

    pub(super) fn floats(&self, key: &str) -> Vec<f64> {
        self.0[key].as_array().map_or_else(Vec::new, |all| all.iter().filter_map(Value::as_f64).collect())
    }

    pub(super) fn scene(&self) -> Result<Changeable> {
        Changeable::new(self.text("text")?, self.text("name")?)
    }

    pub(super) fn values(&self) -> Values {
        let value = |(name, value): (&String, &Value)| Some((name.clone(), value.as_str()?.to_string()));
        self.0["values"].as_object().map_or_else(Vec::new, |all| all.iter().filter_map(value).collect())
    }

    /// The values, with another one of a parameter.
    pub(super) fn values_with(&self, name: &str, value: &str) -> Values {
        let mut values = self.values();
        values.retain(|(known, _)| known != name);
        values.push((name.into(), value.into()));
        values
    }

    /// Where motions start, as an inline table of TOML.
    pub(super) fn start(&self) -> String {
        let given = &self.0["start"];
        let part = |key: &str| {
            let text = given[key].as_str().unwrap_or("0").trim();
            if text.is_empty() { "0".to_string() } else { toml(text) }
        };
        match &self.0["start"] {
            Value::String(table) => table.clone(),
            _ => format!("{{ phase = {}, q = {}, u = {} }}", part("phase"), part("q"), part("u")),
        }
    }

    /// Of a machine, the two numbers of its section, as a key of a task.
    pub(super) fn plane(&self) -> String {
        let names: Vec<String> = self.0["plane"].as_array().map_or_else(Vec::new, |all| {
            all.iter().filter_map(|name| Some(quoted(name.as_str()?))).collect()
        });
        if names.is_empty() { String::new() } else { format!("plane = [{}]\n", names.join(", ")) }
    }

    /// The phase of the section and its frame, as keys of a task.
    pub(super) fn look(&self) -> String {
        let phase = self.0["phase"].as_str().unwrap_or("0");
        let mut keys = format!("phase = {}\n", toml(phase));
        if let Some(frame) = self.0["frame"].as_str().filter(|frame| *frame != "fixed") {
            let _ = writeln!(keys, "frame = {}", quoted(frame));
        }
        keys + &self.plane()
    }

    pub(super) fn transient(&self) -> Result<u64> {
        self.number("transient", 500, 0..=1_000_000)
    }
}

/// A value as it stands in TOML: a number, a list, or text that holds an expression.
pub fn toml(text: &str) -> String {
    let bare = text.trim();
    let number =
        matches!(bare.parse::<toml_edit::Value>(), Ok(value) if value.is_integer() || value.is_float());
    if number || bare.starts_with('[') { bare.to_string() } else { quoted(bare) }
}
