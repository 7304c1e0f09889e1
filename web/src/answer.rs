//! What every function gives: JSON, or why there is none.

use serde_json::{Value, json};

/// A value, or what is wrong with the input.
pub type Answer<T = Value> = Result<T, Fault>;

/// What is wrong with an input, in words for the user, and where.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// One line.
    pub message: String,
    /// The line of the input, from 1.
    pub line: Option<u64>,
    /// The key in a scene, or the argument of a function.
    pub key: Option<String>,
}

impl Fault {
    /// A fault that stands nowhere in particular.
    pub fn new(message: impl Into<String>) -> Fault {
        Fault { message: message.into(), line: None, key: None }
    }

    /// The same, of an argument.
    #[must_use]
    pub fn of(self, key: &str) -> Fault {
        Fault { key: Some(key.into()), ..self }
    }
}

impl From<grazing_scenes::Error> for Fault {
    fn from(error: grazing_scenes::Error) -> Fault {
        Fault::new(error.to_string())
    }
}

/// The JSON text of the answer to a request, which is JSON text too.
pub fn requested(request: &str, give: impl FnOnce(Value) -> Answer) -> String {
    let read = serde_json::from_str(request);
    json(read.map_err(|error| Fault::new(format!("the request is not JSON: {error}"))).and_then(give))
}

/// The JSON text of an answer.
pub fn json(answer: Answer) -> String {
    let value = answer.unwrap_or_else(
        |Fault { message, line, key }| json!({ "error": { "message": message, "line": line, "key": key } }),
    );
    value.to_string()
}
