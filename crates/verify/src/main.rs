//! The program `grazing-verify`: the commands of the theory. Everything it does is in its library.

#![deny(clippy::print_stdout, clippy::print_stderr)]

use std::process::ExitCode;

fn main() -> ExitCode {
    grazing_verify::main::<grazing_verify::Theory>()
}
