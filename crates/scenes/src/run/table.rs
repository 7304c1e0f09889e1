//! How findings are shown: values as text, rows as cells, both made from the typed fields.
//! Not here: how lines and tables of a report are set (`lines`).

use serde::{Serialize, Serializer};

use crate::motion::RunEnd;

/// A value as it stands in a report and in a CSV file.
pub(crate) trait Shown {
    /// Its text; empty for what is absent. Floats have at most so many significant digits, at least 1, or all
    /// that tell them from others.
    fn set(&self, digits: Option<usize>) -> String;
}

/// The shortest decimal that is this float, or the one rounded.
impl Shown for f64 {
    fn set(&self, digits: Option<usize>) -> String {
        let rounded = |digits: usize| format!("{self:.*e}", digits.max(1) - 1).parse().ok();
        // The largest of all are rounded to none.
        let finite = |x: &f64| x.is_finite();
        format!("{:?}", digits.and_then(rounded).filter(finite).unwrap_or(*self))
    }
}

/// "yes" or "no".
impl Shown for bool {
    fn set(&self, _: Option<usize>) -> String {
        if *self { "yes" } else { "no" }.into()
    }
}

macro_rules! shown_as_written {
    ($($type:ty)+) => {
        $(impl Shown for $type {
            fn set(&self, _: Option<usize>) -> String {
                self.to_string()
            }
        })+
    };
}
shown_as_written! { u32 u64 usize i32 i64 String &str }

impl<T: Shown> Shown for &T {
    fn set(&self, digits: Option<usize>) -> String {
        (*self).set(digits)
    }
}

impl<T: Shown> Shown for Option<T> {
    fn set(&self, digits: Option<usize>) -> String {
        self.as_ref().map_or(String::new(), |value| value.set(digits))
    }
}

impl<T: Shown> Shown for [T] {
    fn set(&self, digits: Option<usize>) -> String {
        self.iter().map(|value| value.set(digits)).collect::<Vec<_>>().join(", ")
    }
}

macro_rules! shown_as_slice {
    ($([$($generic:tt)+] $type:ty,)+) => {
        $(impl<$($generic)+> Shown for $type {
            fn set(&self, digits: Option<usize>) -> String {
                self.as_slice().set(digits)
            }
        })+
    };
}
shown_as_slice! { [T: Shown] Vec<T>, [T: Shown, const N: usize] [T; N], }

/// Why.
impl Shown for RunEnd {
    fn set(&self, _: Option<usize>) -> String {
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
    fn set(&self, digits: Option<usize>) -> String {
        let Complex(re, im) = *self;
        match im {
            0.0 => re.set(digits),
            _ => {
                let sign = if im < 0.0 { '-' } else { '+' };
                format!("{} {sign} {}i", re.set(digits), im.abs().set(digits))
            }
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
    fn set(&self, _: Option<usize>) -> String {
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

    /// What each shows, as text, floats with so many digits or all.
    fn cells(&self, digits: Option<usize>) -> Vec<String>;
}

/// Declares a row: a struct with `Serialize` whose fields are the columns, in this order. `with { … }` has
/// those of another row in its place.
macro_rules! row {
    ($(#[doc = $about:literal])+ $(#[derive($more:ident)])? pub struct $name:ident {
        $($(#[doc = $doc:literal])+ pub $field:ident: $type:ty,)*
        $(with {
            $(#[doc = $part_doc:literal])+ pub $part:ident: $of:ty
        }
        $($(#[doc = $last_doc:literal])+ pub $last:ident: $last_type:ty,)*)?
    }) => {
        $(#[doc = $about])+
        #[derive(Debug, Clone, PartialEq, serde::Serialize)]
        $(#[derive($more)])?
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

            fn cells(&self, digits: Option<usize>) -> Vec<String> {
                use $crate::run::Shown as _;
                let own = vec![$(self.$field.set(digits)),*];
                [own $(, $crate::run::Row::cells(&self.$part, digits), vec![$(self.$last.set(digits)),*])?].concat()
            }
        }
    };
}
pub(crate) use row;

/// What is printed as columns.
pub trait Tabular {
    /// The names of the columns.
    fn columns(&self) -> Vec<&str>;

    /// One text for each column, row by row: floats with so many significant digits, or with all that tell
    /// them from others.
    fn cells(&self, digits: Option<usize>) -> Vec<Vec<String>>;
}

impl<R: Row> Tabular for Vec<R> {
    fn columns(&self) -> Vec<&str> {
        R::fields()
    }

    fn cells(&self, digits: Option<usize>) -> Vec<Vec<String>> {
        self.iter().map(|row| row.cells(digits)).collect()
    }
}
