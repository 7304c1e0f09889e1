//! Tells a chapter, while it is built, a hash of the sources that decide its results, which every shard and
//! every saved state carries, and which compiler builds it and how, which every measurement says.
//!
//! A chapter's `build.rs` is one call of [`tell`]; the chapter reads `env!("GRAZING_SOURCES")`. Whoever
//! writes a shard puts together its own hash and those of the chapters below it (`output::program`).

use std::{
    env, fs, io,
    path::{Path, PathBuf},
    process::Command,
};

/// Sets `GRAZING_SOURCES`, the hash of these files and of all files below these folders, and
/// `GRAZING_COMPILER`, for the package that is built. Paths are from the package's folder; what is not there
/// counts for nothing, as a chapter that comes from a registry alone: the lock file has its version.
///
/// # Panics
/// If a source cannot be read, or called elsewhere than in a `build.rs`.
pub fn tell(sources: &[&str]) {
    println!("cargo:rerun-if-changed=build.rs");
    let compiler = env::var_os("RUSTC").and_then(|rustc| Command::new(rustc).arg("--version").output().ok());
    // "rustc 1.90.0 (… 2025-09-14)".
    let version = compiler.and_then(|output| String::from_utf8(output.stdout).ok());
    let version = version.as_deref().and_then(|text| text.split(" (").next()).unwrap_or("an unknown rustc");
    let level = env::var("OPT_LEVEL").unwrap_or_default();
    println!("cargo:rustc-env=GRAZING_COMPILER={}, opt-level {level}", version.trim());
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo names the package's folder"));
    let mut texts = Vec::new();
    for source in sources.iter().map(Path::new).filter(|source| root.join(source).exists()) {
        println!("cargo:rerun-if-changed={}", root.join(source).display());
        collect(&root, source, &mut texts).expect("the sources can be read while they are compiled");
    }
    texts.sort();
    // FNV-1a of 64 bits, as in the base's `output::hash`.
    let bytes = texts.iter().flat_map(|(head, text)| [head.as_bytes(), text]).flatten();
    let hash = bytes.fold(0xcbf2_9ce4_8422_2325_u64, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
    });
    println!("cargo:rustc-env=GRAZING_SOURCES={hash:016x}");
}

/// Of a file, or of all files below a folder, a head and the text. They are the same on every computer: names
/// have `/` between folders, and lines may end with CR LF. Hidden files, as editors leave them, are no
/// sources.
fn collect(root: &Path, source: &Path, texts: &mut Vec<(String, Vec<u8>)>) -> io::Result<()> {
    if !root.join(source).is_dir() {
        let name: Vec<_> = source.iter().map(|part| part.to_string_lossy()).collect();
        let mut text = fs::read(root.join(source))?;
        text.retain(|&byte| byte != b'\r');
        texts.push((format!("{} {}\n", name.join("/"), text.len()), text));
        return Ok(());
    }
    for entry in fs::read_dir(root.join(source))? {
        let name = entry?.file_name();
        if !name.to_string_lossy().starts_with('.') {
            collect(root, &source.join(name), texts)?;
        }
    }
    Ok(())
}
