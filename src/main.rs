//! The `grazing` command; everything it does is in the library.

use std::process::ExitCode;

fn main() -> ExitCode {
    grazing::cli::main()
}
