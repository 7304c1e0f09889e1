//! How findings are shown: values as text, rows as tables, both made from the typed fields.

use std::{fmt::Write, ops::Deref};

use serde::{Serialize, Serializer, ser::Error as _};
use serde_json::Value;

use crate::{motion::RunEnd, printable::Printable};

/// A value as it stands in a report and in a CSV file.
pub trait Shown {
    /// Its text; empty for what is absent.
    fn shown(&self) -> String;

    /// The texts of its entries, if it is a list; none for what is absent.
    fn entries(&self) -> Vec<String> {
        vec![self.shown()]
    }
}

/// The shortest decimal that is this float.
impl Shown for f64 {
    fn shown(&self) -> String {
        format!("{self:?}")
    }
}

/// "yes" or "no".
impl Shown for bool {
    fn shown(&self) -> String {
        if *self { "yes" } else { "no" }.into()
    }
}

macro_rules! shown_as_written {
    ($($type:ty)+) => {
        $(impl Shown for $type {
            fn shown(&self) -> String {
                self.to_string()
            }
        })+
    };
}
shown_as_written! { u32 u64 usize i32 i64 String &str }

impl<T: Shown> Shown for Option<T> {
    fn shown(&self) -> String {
        self.as_ref().map_or(String::new(), T::shown)
    }

    fn entries(&self) -> Vec<String> {
        self.as_ref().map_or(Vec::new(), T::entries)
    }
}

impl<T: Shown> Shown for [T] {
    fn shown(&self) -> String {
        self.entries().join(", ")
    }

    fn entries(&self) -> Vec<String> {
        self.iter().map(T::shown).collect()
    }
}

macro_rules! shown_as_slice {
    ($([$($generic:tt)+] $type:ty,)+) => {
        $(impl<$($generic)+> Shown for $type {
            fn shown(&self) -> String {
                self.as_slice().shown()
            }

            fn entries(&self) -> Vec<String> {
                self.as_slice().entries()
            }
        })+
    };
}
shown_as_slice! { [T: Shown] Vec<T>, [T: Shown, const N: usize] [T; N], }

/// Why.
impl Shown for RunEnd {
    fn shown(&self) -> String {
        self.why().into()
    }
}

/// A complex number: a pair in JSON, in text a number where it is real.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Complex(pub f64, pub f64);

impl From<(f64, f64)> for Complex {
    fn from((re, im): (f64, f64)) -> Complex {
        Complex(re, im)
    }
}

impl Shown for Complex {
    fn shown(&self) -> String {
        let Complex(re, im) = *self;
        match im {
            0.0 => re.shown(),
            _ => format!("{re:?} {} {:?}i", if im < 0.0 { '-' } else { '+' }, im.abs()),
        }
    }
}

/// An answer that rounding may decide: true, false or "marginal" in JSON.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Judgement {
    /// It is.
    Yes,
    /// It is not.
    No,
    /// Rounding decides.
    Marginal,
}

impl Serialize for Judgement {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Judgement::Yes => serializer.serialize_bool(true),
            Judgement::No => serializer.serialize_bool(false),
            Judgement::Marginal => serializer.serialize_str("marginal"),
        }
    }
}

impl Shown for Judgement {
    fn shown(&self) -> String {
        match self {
            Judgement::Yes => "yes",
            Judgement::No => "no",
            Judgement::Marginal => "marginal",
        }
        .into()
    }
}

/// A row of a table of findings.
pub trait Row {
    /// The names of its fields.
    fn fields() -> Vec<&'static str>;

    /// For each field the texts of its entries: one, unless it is a list.
    fn entries(&self) -> Vec<Vec<String>>;

    /// What a column shows, as text; none for what is absent.
    fn cell(&self, (_, field, entry): Column) -> Option<String> {
        let place = Self::fields().iter().rposition(|known| *known == field)?;
        let entries = self.entries().swap_remove(place);
        match entry {
            Some(entry) => entries.get(entry).cloned(),
            None => (!entries.is_empty()).then(|| entries.join(", ")),
        }
    }
}

/// What is absent has no entries.
impl<R: Row> Row for Option<R> {
    fn fields() -> Vec<&'static str> {
        R::fields()
    }

    fn entries(&self) -> Vec<Vec<String>> {
        self.as_ref().map_or_else(|| vec![Vec::new(); R::fields().len()], R::entries)
    }
}

/// Declares a row: a struct with `Serialize` whose fields are the columns. `with { … }` adds those of another
/// row; of two fields with one name it is the row's own that counts.
macro_rules! row {
    ($(#[doc = $about:literal])+ pub struct $name:ident {
        $(with { $(#[doc = $part_doc:literal])+ pub $part:ident: $of:ty })?
        $($(#[doc = $doc:literal])+ pub $field:ident: $type:ty,)+
    }) => {
        $(#[doc = $about])+
        #[derive(Debug, Clone, PartialEq, serde::Serialize)]
        pub struct $name {
            $($(#[doc = $part_doc])+ #[serde(flatten)] pub $part: $of,)?
            $($(#[doc = $doc])+ pub $field: $type,)+
        }

        impl $crate::run::Row for $name {
            fn fields() -> Vec<&'static str> {
                let mut all = Vec::new();
                $(all.extend(<$of as $crate::run::Row>::fields());)?
                all.extend([$(stringify!($field)),+]);
                all
            }

            fn entries(&self) -> Vec<Vec<String>> {
                let mut all = Vec::new();
                $(all.extend($crate::run::Row::entries(&self.$part));)?
                all.extend([$($crate::run::Shown::entries(&self.$field)),+]);
                all
            }
        }
    };
}
pub(crate) use row;

/// What is printed as columns.
pub trait Tabular {
    /// The names of the columns.
    fn columns(&self) -> Vec<&'static str>;

    /// One text for each column, row by row.
    fn cells(&self) -> Vec<Vec<String>>;
}

impl<R: Row> Tabular for Vec<R> {
    fn columns(&self) -> Vec<&'static str> {
        R::fields()
    }

    fn cells(&self) -> Vec<Vec<String>> {
        self.iter().map(|row| row.entries().iter().map(|entries| entries.join(", ")).collect()).collect()
    }
}

/// Rows of which some fields are shown, in an order and under names of their own.
#[derive(Debug, Clone, PartialEq)]
pub struct Table<R> {
    columns: &'static str,
    rows: Vec<R>,
}

impl<R> Table<R> {
    /// `columns` are a list of `field`, `name = field`, or `name = list.i` for one entry of a list.
    pub(super) fn new(columns: &'static str, rows: Vec<R>) -> Table<R> {
        Table { columns, rows }
    }

    /// Some of the rows.
    pub(super) fn filter(&self, wanted: impl Fn(&R) -> bool) -> Table<R>
    where
        R: Clone,
    {
        Table { columns: self.columns, rows: self.rows.iter().filter(|row| wanted(row)).cloned().collect() }
    }
}

impl<R> Deref for Table<R> {
    type Target = [R];

    fn deref(&self) -> &[R] {
        &self.rows
    }
}

/// A column: its name, the field that it shows, and which entry of it.
pub(super) type Column = (&'static str, &'static str, Option<usize>);

/// The columns of a list of them.
pub(super) fn columns_of(list: &'static str) -> impl Iterator<Item = Column> {
    list.split(", ").map(|text| {
        let (name, from) = text.split_once(" = ").unwrap_or((text, text));
        match from.split_once('.') {
            Some((field, entry)) => (name, field, entry.parse().ok()),
            None => (name, from, None),
        }
    })
}

impl<R: Row> Tabular for Table<R> {
    fn columns(&self) -> Vec<&'static str> {
        columns_of(self.columns).map(|(name, ..)| name).collect()
    }

    fn cells(&self) -> Vec<Vec<String>> {
        let cell = |row: &R, column| row.cell(column).unwrap_or_default();
        self.iter().map(|row| columns_of(self.columns).map(|column| cell(row, column)).collect()).collect()
    }
}

impl<R: Serialize> Serialize for Table<R> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.rows.iter().map(|row| Selected { columns: self.columns, row }))
    }
}

/// A row's columns as an object.
struct Selected<'a, R> {
    columns: &'static str,
    row: &'a R,
}

impl<R: Serialize> Serialize for Selected<'_, R> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let all = serde_json::to_value(self.row).map_err(S::Error::custom)?;
        serializer.collect_map(columns_of(self.columns).map(|column| (column.0, select(column, &all))))
    }
}

/// What a column shows of a row's fields. None of them is an object: its entries would lose their order.
pub(super) fn select((_, field, entry): Column, row: &Value) -> &Value {
    let whole = row.get(field).unwrap_or(&Value::Null);
    entry.map_or(whole, |entry| whole.get(entry).unwrap_or(&Value::Null))
}

/// The lines of a report: name and value, or a table under its name.
#[derive(Debug, Default)]
pub struct Lines(String);

impl Lines {
    /// A line.
    pub fn say(&mut self, name: &str, value: impl Shown) {
        let _ = writeln!(self.0, "  {name:<16} {}", Printable(&value.shown()));
    }

    /// A table, columns aligned to the right; "none" if it is empty.
    pub fn table<T: Tabular>(&mut self, name: &str, table: &T) {
        let shown = |cell: String| Printable(&cell).to_string();
        let cells = table.cells().into_iter().map(|row| row.into_iter().map(shown).collect());
        let cells: Vec<Vec<String>> = cells.collect();
        if cells.is_empty() {
            return self.say(name, "none");
        }
        let _ = writeln!(self.0, "  {name}");
        let heads: Vec<String> = table.columns().iter().map(ToString::to_string).collect();
        let widths: Vec<usize> = (0..heads.len())
            .map(|i| {
                let widest = cells.iter().map(|row| row[i].chars().count()).max().unwrap_or(0);
                widest.max(heads[i].len())
            })
            .collect();
        for row in std::iter::once(&heads).chain(&cells) {
            let line: Vec<String> =
                row.iter().zip(&widths).map(|(cell, &width)| format!("{cell:>width$}")).collect();
            let _ = writeln!(self.0, "    {}", line.join("  ").trim_end());
        }
    }

    /// All of them.
    pub fn text(&self) -> &str {
        &self.0
    }
}
