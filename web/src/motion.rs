//! The Oscillator panel: every picture and number of it is a task of a scene, run by the library.
//!
//! A request is a JSON object with the scene's `text`, its `name`, the `values` of its parameters as exact
//! texts, and what a view needs besides. The page adds tasks to the scene and runs them, so that the command
//! line gives the same numbers for the text that [`motion_scene`] gives. Answers are JSON objects;
//! what went wrong is `{"error": {"message", "line", "key"}}`. No file is read or written, no clock is asked.
//! Not here: the tasks themselves (`grazing_scenes::run`), drawing (`page/motion.ts`).

mod attractor;
mod born;
mod branch;
mod document;
mod open;
mod over_time;
mod request;
mod section;
mod series;
mod task;
#[cfg(test)]
mod tests;
mod theory;

use std::fmt::Write;

use grazing_scenes::{Error, Result, scene::Scene};
use serde_json::{Value, json};
use wasm_bindgen::prelude::wasm_bindgen;

pub use document::{in_unit, quoted};
pub use request::{Request, toml};

use crate::answer::{Fault, requested};

/// The scene of the paper's section 4.
const PAPER: &str = include_str!("../../examples/scenes/nordmark-2001.toml");

/// The paper's scene, as text.
#[wasm_bindgen]
pub fn motion_paper() -> String {
    json!({ "name": "nordmark-2001.toml", "text": PAPER }).to_string()
}

/// What a scene is: title, parameters with ranges of sliders, tasks, and what its own tasks look at.
/// `request` has `text` and `name`.
#[wasm_bindgen]
pub fn motion_open(request: &str) -> String {
    answered(request, open::open)
}

/// One motion: `start`, `transient`, `periods`, `samples`, `seen`.
#[wasm_bindgen]
pub fn motion_series(request: &str) -> String {
    answered(request, over_time::motion)
}

/// What a motion tends to, on the stroboscopic section: `start`, `transient`, `points`, `phase`, `frame`,
/// `plane`; if it is periodic, its multipliers.
#[wasm_bindgen]
pub fn motion_section(request: &str) -> String {
    answered(request, section::section)
}

/// What motions tend to at the values `first` to `last`, counted from 0, of `count` values of `parameter`
/// from `from` to `to`.
#[wasm_bindgen]
pub fn motion_attractor(request: &str) -> String {
    answered(request, attractor::attractor)
}

/// The grazing bifurcation in `parameter`, the orbits born there up to `max_period`, and what the theory
/// predicts of their impact speeds.
#[wasm_bindgen]
pub fn motion_born(request: &str) -> String {
    answered(request, born::born)
}

/// The branch of one orbit that is born there: `parameter`, `from`, `to`, `pattern`, `wall`, `at`, `phases`,
/// `speeds`, and the prediction, `grazing` and `slopes`.
#[wasm_bindgen]
pub fn motion_branch(request: &str) -> String {
    answered(request, branch::branch)
}

/// Impact speeds of the motion at the value `value` of `parameter`, after a transient.
#[wasm_bindgen]
pub fn motion_strikes(request: &str) -> String {
    answered(request, over_time::strikes)
}

/// Runs the scene's own task `task`: the object that `grazing run --format json` prints, and the report in
/// words.
#[wasm_bindgen]
pub fn motion_task(request: &str) -> String {
    answered(request, task::own_task)
}

/// The scene with these values and with the tasks of the page's views, for the command line.
#[wasm_bindgen]
pub fn motion_scene(request: &str) -> String {
    answered(request, scene_of_views)
}

/// A function of a request, as the page calls it.
pub fn answered(request: &str, give: impl FnOnce(&Request) -> Result<Value>) -> String {
    requested(request, |request| give(&Request(request)).map_err(|error| fault(&error)))
}

/// An error as the page shows it: the line and the key are those that lead the message, `name:line: key = …`.
fn fault(error: &Error) -> Fault {
    let mut message = error.to_string();
    if error.is_io() {
        message += ": the page reads no files; write the numbers into the scene";
    }
    let mut parts = message.splitn(3, ':');
    let line = parts.nth(1).and_then(|line| line.parse::<u64>().ok());
    let key = line.and(parts.next()).and_then(|rest| {
        let before = rest.split([':', '=']).next()?.trim();
        (!before.is_empty() && !before.contains(' ')).then(|| before.to_string())
    });
    Fault { message, line, key }
}

fn scene_of_views(request: &Request) -> Result<Value> {
    let changeable = request.scene()?;
    let (periods, samples) =
        (request.number("periods", 12, 1..=2000)?, request.number("samples", 128, 1..=1024)?);
    let mut tasks = over_time::motion_keys(request, request.transient()?, periods, samples);
    let _ = write!(tasks, "\n{}", section::section_keys(request)?);
    if request.0["parameter"].is_string() {
        let range = [request.exact("from")?, request.exact("to")?];
        let count = request.number("count", 200, 2..=100_000)?;
        let _ = write!(tasks, "\n{}", attractor::diagram_keys(request, [&range[0], &range[1]], count)?);
        let _ = write!(tasks, "\n{}", born::grazing_keys(request)?);
    }
    let text = changeable.with(&request.values(), &tasks)?;
    Scene::from_toml(&text, &changeable.name)?;
    Ok(json!({ "text": text }))
}
