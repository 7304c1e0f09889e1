//! Tells the program which compiler built it and how: every measurement says so.

use std::{env, process::Command};

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let compiler = env::var_os("RUSTC").and_then(|rustc| Command::new(rustc).arg("--version").output().ok());
    // "rustc 1.90.0 (… 2025-09-14)".
    let version = compiler.and_then(|output| String::from_utf8(output.stdout).ok());
    let version = version.as_deref().and_then(|text| text.split(" (").next()).unwrap_or("an unknown rustc");
    let level = env::var("OPT_LEVEL").unwrap_or_default();
    println!("cargo:rustc-env=GRAZING_COMPILER={}, opt-level {level}", version.trim());
}
