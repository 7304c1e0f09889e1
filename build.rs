//! Tells the program which compiler built it and how, which every measurement says, and a hash of the sources
//! that decide its results, which every shard and every saved state carries.

use std::{
    env, fs, io,
    path::{Path, PathBuf},
    process::Command,
};

#[allow(dead_code)]
#[path = "src/output/hash.rs"]
mod hash;

/// What decides results: the library with the data it includes, the checker, the numbers, and the versions of
/// all packages. Where checker and numbers are packages of their own, as when this one comes from a registry,
/// the lock file has their versions.
const SOURCES: [&str; 4] = ["src", "checker/src", "number/src", "Cargo.lock"];

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let compiler = env::var_os("RUSTC").and_then(|rustc| Command::new(rustc).arg("--version").output().ok());
    // "rustc 1.90.0 (… 2025-09-14)".
    let version = compiler.and_then(|output| String::from_utf8(output.stdout).ok());
    let version = version.as_deref().and_then(|text| text.split(" (").next()).unwrap_or("an unknown rustc");
    let level = env::var("OPT_LEVEL").unwrap_or_default();
    println!("cargo:rustc-env=GRAZING_COMPILER={}, opt-level {level}", version.trim());
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo names the package's folder"));
    let sources = sources(&root).expect("the sources can be read while they are compiled");
    println!("cargo:rustc-env=GRAZING_SOURCES={sources:016x}");
}

/// A hash of the names and contents of all sources. It is the same on every computer: names are in one order
/// with `/` between folders, and lines may end with CR LF.
fn sources(root: &Path) -> io::Result<u64> {
    let mut files = Vec::new();
    for source in SOURCES.map(Path::new).into_iter().filter(|source| root.join(source).exists()) {
        println!("cargo:rerun-if-changed={}", root.join(source).display());
        collect(root, source, &mut files)?;
    }
    let mut texts = Vec::new();
    for file in files {
        let name: Vec<_> = file.iter().map(|part| part.to_string_lossy()).collect();
        let mut text = fs::read(root.join(&file))?;
        text.retain(|&byte| byte != b'\r');
        texts.push((name.join("/"), text));
    }
    texts.sort();
    Ok(texts.iter().fold(hash::fnv64(b""), |before, (name, text)| {
        let head = format!("{name} {}\n", text.len());
        hash::fnv64_after(hash::fnv64_after(before, head.as_bytes()), text)
    }))
}

/// A file, or all files below a folder, by their paths from the root; hidden ones, as editors leave them, are
/// no sources.
fn collect(root: &Path, source: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    if !root.join(source).is_dir() {
        files.push(source.to_path_buf());
        return Ok(());
    }
    for entry in fs::read_dir(root.join(source))? {
        let name = entry?.file_name();
        if !name.to_string_lossy().starts_with('.') {
            collect(root, &source.join(name), files)?;
        }
    }
    Ok(())
}
