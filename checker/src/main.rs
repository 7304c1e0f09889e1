//! `grazing-check FILE…`: the checker as a command of its own, so that nothing but this package need be trusted.
//!
//! Exit code 0: every file is proved; 1: some file is malformed or false; 2: wrong usage, or some file cannot be read; 3: none of this,
//! but something in a file is left open.

use std::{
    env,
    ffi::OsString,
    fs::File,
    io::{self, BufReader, Read},
    process::ExitCode,
};

use grazing_check::{Checked, Rejection, check};

fn main() -> ExitCode {
    let files: Vec<OsString> = env::args_os().skip(1).collect();
    if files.is_empty() || files.iter().any(|file| file == "--help" || file == "-h") {
        eprintln!("usage: grazing-check FILE…   (- is standard input)");
        return ExitCode::from(2);
    }
    let codes: Vec<u8> = files.iter().map(report).collect();
    let worst = [1, 2, 3].into_iter().find(|code| codes.contains(code));
    ExitCode::from(worst.unwrap_or(0))
}

/// Checks a file, prints its verdict, and says what exit code it asks for.
fn report(file: &OsString) -> u8 {
    let name = file.display();
    match open(file) {
        Ok(Checked { kind, range, detail, .. }) => {
            let detail = detail.map(|detail| format!(": {detail}")).unwrap_or_default();
            println!("{name}: proved, {kind} for n = {}..={}{detail}", range.start(), range.end());
            0
        }
        Err(rejection) => {
            println!("{name}: {rejection}");
            match rejection {
                Rejection::Malformed { .. } | Rejection::False { .. } => 1,
                Rejection::Unreadable { .. } => 2,
                Rejection::Undecided { .. } => 3,
            }
        }
    }
}

fn open(file: &OsString) -> Result<Checked, Rejection> {
    let input: Box<dyn Read> = if file == "-" {
        Box::new(io::stdin().lock())
    } else {
        Box::new(File::open(file).map_err(|source| Rejection::Unreadable { line: 0, source })?)
    };
    check(&mut BufReader::new(input))
}
