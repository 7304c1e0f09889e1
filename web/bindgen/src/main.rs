//! Writes the JavaScript that calls the page's WebAssembly, and the WebAssembly it calls, compressed:
//! `grazing-web-bindgen FILE.wasm FOLDER`. Nothing else lives here.
//!
//! It is the library of wasm-bindgen's own tool; as a package of this workspace it has, by the lockfile, the
//! version of what the page is built with, and is built in a third of the tool's time.

use std::{
    env, fs,
    io::{Result, Write},
    path::Path,
    process::ExitCode,
};

use lzma_rust2::{LzmaOptions, LzmaWriter};
use wasm_bindgen_cli_support::Bindgen;

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [input, folder] = arguments.as_slice() else {
        eprintln!("usage: grazing-web-bindgen FILE.wasm FOLDER");
        return ExitCode::from(2);
    };
    let mut bindgen = Bindgen::new();
    let written = match bindgen.no_modules(true) {
        Ok(bindgen) => {
            bindgen.input_path(input).out_name("grazing").typescript(false).remove_producers_section(true);
            bindgen.generate(folder)
        }
        Err(error) => Err(error),
    };
    if let Err(error) = written {
        eprintln!("grazing-web-bindgen: {error:?}");
        return ExitCode::from(2);
    }
    let folder = Path::new(folder);
    if let Err(error) = compress(&folder.join("grazing_bg.wasm"), &folder.join("grazing.lzma")) {
        eprintln!("grazing-web-bindgen: {error}");
        return ExitCode::from(2);
    }
    ExitCode::SUCCESS
}

/// Writes a file as an `.lzma` file with its size in the header, which `xz --format=lzma -d` reads too; a
/// quarter shorter than gzip's. The page reads it by `page/inflate.ts`.
fn compress(from: &Path, to: &Path) -> Result<()> {
    let bytes = fs::read(from)?;
    let mut options = LzmaOptions::with_preset(9);
    // Instructions are not aligned: what matters is the byte before, not the place.
    (options.lc, options.lp, options.pb) = (4, 0, 0);
    // The longest matches, however long it takes to look for them: a 150th less.
    (options.nice_len, options.depth_limit) = (273, 1000);
    let mut writer = LzmaWriter::new(Vec::new(), &options, true, false, Some(bytes.len() as u64))?;
    writer.write_all(&bytes)?;
    fs::write(to, writer.finish()?)
}
