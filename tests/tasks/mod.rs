//! Scenes written to a file, whose tasks the built command runs.

// Each test program uses a part of this.
#![allow(dead_code)]

use std::{
    fs,
    path::Path,
    process::{Command, Output},
};

mod paper;

use serde_json::Value;

pub use paper::PAPER_MACHINE;

/// The saddle-node and the flip of the orbit with one impact per period of a ball on a table that moves as a
/// sin t; gravity 1, restitution 3/5.
pub fn ball() -> [f64; 2] {
    let r: f64 = 0.6;
    let fold = std::f64::consts::PI * (1.0 - r) / (1.0 + r);
    [fold, fold.hypot(2.0 * (1.0 + r * r) / (1.0 + r).powi(2))]
}

/// A task in TOML.
pub fn task(name: &str, kind: &str, keys: &str) -> String {
    format!("[[tasks]]\nname = \"{name}\"\nkind = \"{kind}\"\n{keys}\n")
}

/// The report of a scene's tasks as JSON, the exit code and what was written to standard error.
pub fn run(scene: &str, tasks: &[String], folder: &Path) -> (Value, i32, String) {
    let output = output(scene, tasks, folder);
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    let report = serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{e}: {error}"));
    (report, output.status.code().unwrap(), error)
}

/// What is said of a scene that is refused: it prints no report.
pub fn refused(scene: &str, tasks: &[String], folder: &Path) -> String {
    let output = output(scene, tasks, folder);
    assert!(!output.status.success() && output.stdout.is_empty(), "{output:?}");
    String::from_utf8(output.stderr).unwrap()
}

fn output(scene: &str, tasks: &[String], folder: &Path) -> Output {
    let file = folder.join("scene.toml");
    fs::write(&file, format!("{scene}{}", tasks.concat())).unwrap();
    let mut command = Command::new(crate::PROGRAM);
    command.args(["run", "--format", "json", "-o"]).arg(folder).arg(&file).output().unwrap()
}

pub fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

pub fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} and {b} differ by {:e}", a - b);
}
