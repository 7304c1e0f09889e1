//! How findings are shown: values as text, rows as tables, both made from the typed fields.

use std::fmt::Write;

use serde::{Serialize, Serializer};

use crate::{motion::RunEnd, printable::Printable};

/// A value as it stands in a report and in a CSV file.
pub(crate) trait Shown {
    /// Its text; empty for what is absent.
    fn shown(&self) -> String;
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
}

impl<T: Shown> Shown for [T] {
    fn shown(&self) -> String {
        self.iter().map(T::shown).collect::<Vec<_>>().join(", ")
    }
}

macro_rules! shown_as_slice {
    ($([$($generic:tt)+] $type:ty,)+) => {
        $(impl<$($generic)+> Shown for $type {
            fn shown(&self) -> String {
                self.as_slice().shown()
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
pub struct Complex(pub(crate) f64, pub(crate) f64);

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
pub(crate) trait Row {
    /// The names of its fields: the columns.
    fn fields() -> Vec<&'static str>;

    /// What each shows, as text.
    fn cells(&self) -> Vec<String>;
}

/// Declares a row: a struct with `Serialize` whose fields are the columns, in this order. `with { … }` has
/// those of another row in its place.
macro_rules! row {
    ($(#[doc = $about:literal])+ pub struct $name:ident {
        $($(#[doc = $doc:literal])+ pub $field:ident: $type:ty,)*
        $(with {
            $(#[doc = $part_doc:literal])+ pub $part:ident: $of:ty
        }
        $($(#[doc = $last_doc:literal])+ pub $last:ident: $last_type:ty,)*)?
    }) => {
        $(#[doc = $about])+
        #[derive(Debug, Clone, PartialEq, serde::Serialize)]
        pub struct $name {
            $($(#[doc = $doc])+ pub $field: $type,)*
            $($(#[doc = $part_doc])+ #[serde(flatten)] pub $part: $of,
            $($(#[doc = $last_doc])+ pub $last: $last_type,)*)?
        }

        impl $crate::run::Row for $name {
            fn fields() -> Vec<&'static str> {
                let own = vec![$(stringify!($field)),*];
                [own $(, <$of as $crate::run::Row>::fields(), vec![$(stringify!($last)),*])?].concat()
            }

            fn cells(&self) -> Vec<String> {
                use $crate::run::Shown as _;
                let own = vec![$(self.$field.shown()),*];
                [own $(, $crate::run::Row::cells(&self.$part), vec![$(self.$last.shown()),*])?].concat()
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
        self.iter().map(R::cells).collect()
    }
}

/// The lines of a report: name and value, or a table under its name.
#[derive(Debug, Default)]
pub(crate) struct Lines(String);

impl Lines {
    /// A line.
    pub fn say(&mut self, name: &str, value: impl Shown) {
        let _ = writeln!(self.0, "  {name:<16} {}", Printable(&value.shown()));
    }

    /// A line, of what is known.
    pub fn say_known<T: Shown + Clone>(&mut self, name: &str, value: &Option<T>) {
        if let Some(value) = value {
            self.say(name, value.clone());
        }
    }

    /// The fields of a row that are wanted, each a name and a text, a line each.
    pub fn fields<R: Row>(&mut self, row: &R, wanted: impl Fn(&(&'static str, String)) -> bool) {
        for (name, cell) in R::fields().into_iter().zip(row.cells()).filter(wanted) {
            self.say(name, cell);
        }
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
