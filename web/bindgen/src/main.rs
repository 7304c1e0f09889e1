//! Writes the JavaScript that calls the page's WebAssembly, and the WebAssembly it calls:
//! `grazing-web-bindgen FILE.wasm FOLDER`. Nothing else lives here.
//!
//! It is the library of wasm-bindgen's own tool; as a package of this workspace it has, by the lockfile, the
//! version of what the page is built with, and is built in a third of the tool's time.

use std::{env, process::ExitCode};

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
    ExitCode::SUCCESS
}
