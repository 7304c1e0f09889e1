//! The `grazing` command; everything it does is in its library.

#![deny(clippy::print_stdout, clippy::print_stderr)]

use std::process::ExitCode;

fn main() -> ExitCode {
    grazing_shell::main()
}
