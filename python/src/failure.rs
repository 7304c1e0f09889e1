//! The library's errors as Python's exceptions, which are declared in `grazing/_errors.py`.

use grazing_scenes::Error;
use pyo3::prelude::*;

/// The exception that says what an error says.
pub fn raise(py: Python<'_>, error: &Error) -> PyErr {
    let kind = match () {
        () if error.is_interrupted() => "interrupted",
        () if error.is_overflow() => "overflow",
        () if error.is_io() => "io",
        () => "input",
    };
    let spot = error.spot();
    let file = spot.map(|spot| spot.file.clone());
    let line = spot.and_then(|spot| spot.line);
    let key = spot.and_then(|spot| spot.key.clone());
    let value = spot.and_then(|spot| spot.value.clone());
    let problem = spot.map(|spot| spot.problem.clone());
    let system = std::error::Error::source(error).and_then(|cause| cause.downcast_ref::<std::io::Error>());
    let number = system.and_then(std::io::Error::raw_os_error);
    made(py, (kind, error.to_string(), file, line, key, value, problem, number))
}

/// An input error without a file.
pub fn input(py: Python<'_>, message: &str) -> PyErr {
    raise(py, &Error::input(message))
}

/// A panic: an error of the library itself.
pub fn panicked(py: Python<'_>, cause: &(dyn std::any::Any + Send)) -> PyErr {
    let text = cause.downcast_ref::<&str>().map(ToString::to_string);
    let text = text.or_else(|| cause.downcast_ref::<String>().cloned()).unwrap_or_default();
    let message = format!("an error of grazing itself, please report it: {text}");
    let none = None::<String>;
    made(py, ("internal", message, none.clone(), None, none.clone(), none.clone(), none, None))
}

/// Work was asked for whose threads stayed in the process from which this one was forked.
pub fn forked(py: Python<'_>) -> PyErr {
    let message = "this process was forked from one whose threads did grazing's work, and has none of them: start \
                   processes by multiprocessing.get_context(\"spawn\"), or fork before the first long work";
    let none = None::<String>;
    made(py, ("forked", message.into(), none.clone(), None, none.clone(), none.clone(), none, None))
}

type Parts = (
    &'static str,
    String,
    Option<String>,
    Option<usize>,
    Option<String>,
    Option<String>,
    Option<String>,
    Option<i32>,
);

fn made(py: Python<'_>, parts: Parts) -> PyErr {
    let exception = py
        .import("grazing._errors")
        .and_then(|module| module.getattr("exception"))
        .and_then(|exception| exception.call1(parts));
    exception.map_or_else(|error| error, PyErr::from_value)
}
