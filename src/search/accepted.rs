//! Certificates that the checker has accepted, with what it says of them.
//!
//! Whatever a report calls proved has one of these behind it: the type cannot be made of a text that was not
//! checked. Not here: what finds certificates, and the checker, which knows nothing of this.

use serde::{Serialize, Serializer, ser::SerializeMap};

use crate::certificate::{Checked, Rejection, check_until};

/// The text of a certificate that the checker has accepted, and what it says is proved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Accepted {
    text: String,
    checked: Checked,
}

impl Accepted {
    /// The text, if the checker accepts it. Cost: that of its kind's check.
    ///
    /// # Errors
    /// Why it does not.
    pub fn new(text: String) -> Result<Accepted, Rejection> {
        Accepted::until(text, &mut || false)
    }

    /// The same, ended early once `stop` returns true.
    ///
    /// # Errors
    /// Why it does not; an interruption.
    pub fn until(text: String, stop: &mut dyn FnMut() -> bool) -> Result<Accepted, Rejection> {
        let checked = check_until(&mut text.as_bytes(), stop)?;
        Ok(Accepted { text, checked })
    }

    /// The certificate.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// What the checker says of it.
    #[must_use]
    pub fn claim(&self) -> Claimed<'_> {
        Claimed::of(&self.checked)
    }
}

/// What a certificate proves, as the checker says it: the same names and values wherever it is quoted, in
/// `check --format json` and in the report of a run.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Claimed<'a> {
    kind: &'a str,
    title: &'a str,
    range: Option<[u64; 2]>,
    detail: Detail<'a>,
}

/// Names and values, in order.
#[derive(Debug, Clone, Copy)]
struct Detail<'a>(&'a [(&'static str, String)]);

impl Serialize for Detail<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (name, value) in self.0 {
            map.serialize_entry(name, value)?;
        }
        map.end()
    }
}

impl<'a> Claimed<'a> {
    /// Of what the checker has found.
    #[must_use]
    pub fn of(checked: &'a Checked) -> Claimed<'a> {
        Claimed {
            kind: checked.kind,
            title: checked.title,
            range: checked.range.as_ref().map(|range| [*range.start(), *range.end()]),
            detail: Detail(&checked.detail),
        }
    }

    /// A value by its name, as in `check`.
    #[must_use]
    pub fn detail(&self, name: &str) -> Option<&'a str> {
        self.detail.0.iter().find(|(known, _)| *known == name).map(|(_, value)| value.as_str())
    }
}
