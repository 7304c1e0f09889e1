//! How findings are shown: values as text, rows as tables, both made from the typed fields.

use std::fmt::Write;

use serde::{Serialize, Serializer};

use crate::printable::Printable;

/// A value as it stands in a report and in a CSV file.
pub trait Shown {
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

impl<T: Shown> Shown for Vec<T> {
    fn shown(&self) -> String {
        self.iter().map(T::shown).collect::<Vec<_>>().join(", ")
    }
}

impl<T: Shown, const N: usize> Shown for [T; N] {
    fn shown(&self) -> String {
        self.iter().map(T::shown).collect::<Vec<_>>().join(", ")
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
    /// The names of the columns.
    const COLUMNS: &'static [&'static str];

    /// One text for each column.
    fn cells(&self) -> Vec<String>;
}

/// Declares a row: a struct with `Serialize` whose fields are the columns.
macro_rules! row {
    ($(#[doc = $about:literal])+ pub struct $name:ident {
        $($(#[doc = $doc:literal])+ pub $field:ident: $type:ty,)+
    }) => {
        $(#[doc = $about])+
        #[derive(Debug, Clone, PartialEq, serde::Serialize)]
        pub struct $name { $($(#[doc = $doc])+ pub $field: $type,)+ }

        impl $crate::run::Row for $name {
            const COLUMNS: &'static [&'static str] = &[$(stringify!($field)),+];

            fn cells(&self) -> Vec<String> {
                vec![$($crate::run::Shown::shown(&self.$field)),+]
            }
        }
    };
}
pub(crate) use row;

/// The lines of a report: name and value, or a table under its name.
#[derive(Debug, Default)]
pub struct Lines(String);

impl Lines {
    /// A line.
    pub fn say(&mut self, name: &str, value: impl Shown) {
        let _ = writeln!(self.0, "  {name:<16} {}", Printable(&value.shown()));
    }

    /// A table, columns aligned to the right; "none" if it is empty.
    pub fn table<R: Row>(&mut self, name: &str, rows: &[R]) {
        if rows.is_empty() {
            return self.say(name, "none");
        }
        let _ = writeln!(self.0, "  {name}");
        let shown = |cell: String| Printable(&cell).to_string();
        let cells: Vec<Vec<String>> =
            rows.iter().map(|row| row.cells().into_iter().map(shown).collect()).collect();
        let heads = R::COLUMNS.iter().map(|name| (*name).to_string()).collect();
        let widths: Vec<usize> = (0..R::COLUMNS.len())
            .map(|i| {
                let widest = cells.iter().map(|row| row[i].chars().count()).max().unwrap_or(0);
                widest.max(R::COLUMNS[i].len())
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
