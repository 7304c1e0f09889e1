//! Tells the program a hash of its own sources, which decide how rows are written; the library has its own.

use std::{
    env, fs, io,
    path::{Path, PathBuf},
};

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-changed=src");
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo names the package's folder"));
    let mut files = Vec::new();
    collect(&root, Path::new("src"), &mut files).expect("the sources can be read while they are compiled");
    files.sort();
    // FNV-1a, as in the library's `output::hash`.
    let hash = files
        .iter()
        .flat_map(|(name, text)| [name.as_bytes(), text])
        .flatten()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, &byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
        });
    println!("cargo:rustc-env=GRAZING_SHELL_SOURCES={hash:016x}");
}

/// Of a file, or all files below a folder, a head and the text. They are the same on every computer: names
/// have `/` between folders, and lines may end with CR LF. Hidden files, as editors leave them, are no
/// sources.
fn collect(root: &Path, source: &Path, files: &mut Vec<(String, Vec<u8>)>) -> io::Result<()> {
    if !root.join(source).is_dir() {
        let name: Vec<_> = source.iter().map(|part| part.to_string_lossy()).collect();
        let mut text = fs::read(root.join(source))?;
        text.retain(|&byte| byte != b'\r');
        files.push((format!("{} {}\n", name.join("/"), text.len()), text));
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
