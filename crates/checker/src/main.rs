//! `grazing-check FILE…`: the checker as a command of its own, so that nothing but this package need be
//! trusted.

use std::{
    env,
    ffi::OsStr,
    fs::File,
    io::{self, BufReader, ErrorKind, Read, Write},
    process::ExitCode,
};

use grazing_check::{Checked, Rejection, check, overflow};

const USAGE: &str = "\
usage: grazing-check FILE…        (- is standard input)

Proves certificates again and prints a verdict for each. Exit code: 1 if a certificate is malformed or false; else 2 if a file cannot be
read, the verdicts cannot be written, or the usage is wrong; else 3 if something is left open; else 0: all are proved.

grazing-check --overflow ends with a panic (exit code 101), if this program was built to notice overflows, as it should be.";

fn main() -> ExitCode {
    let files: Vec<_> = env::args_os().skip(1).collect();
    match files.first().and_then(|first| first.to_str()) {
        Some("--overflow") => println!("built without overflow checks: {} + 1 = {}", u64::MAX, overflow()),
        Some("--help" | "-h") => return if say(USAGE) { ExitCode::SUCCESS } else { ExitCode::from(2) },
        Some(option) if option.starts_with("--") => eprintln!("unknown option {option}\n{USAGE}"),
        Some(_) | None if !files.is_empty() => {
            let codes: Vec<u8> = files.iter().map(|file| verdict(file)).collect();
            return ExitCode::from([1, 2, 3].into_iter().find(|code| codes.contains(code)).unwrap_or(0));
        }
        _ => eprintln!("{USAGE}"),
    }
    ExitCode::from(2)
}

/// Checks a file and prints its verdict; the exit code that it asks for.
fn verdict(file: &OsStr) -> u8 {
    let (text, code) = match proved(file) {
        Ok(checked) => (checked.to_string(), 0),
        Err(rejection) => {
            let code = match rejection {
                Rejection::Malformed { .. } | Rejection::False { .. } => 1,
                Rejection::Unreadable { .. } | Rejection::Interrupted { .. } => 2,
                Rejection::Undecided { .. } => 3,
            };
            (format!("{}: {rejection}", rejection.verdict()), code)
        }
    };
    let written = say(&format!("{}: {text}", file.display()));
    if written || code == 1 { code } else { 2 }
}

fn proved(file: &OsStr) -> Result<Checked, Rejection> {
    let unreadable = |source| Rejection::Unreadable { line: 0, source };
    let input: Box<dyn Read> =
        if file == "-" { Box::new(io::stdin()) } else { Box::new(File::open(file).map_err(unreadable)?) };
    check(&mut BufReader::new(input))
}

/// Writes a line; false if that fails, other than by a reader who has gone away.
fn say(line: &str) -> bool {
    let written = writeln!(io::stdout(), "{line}");
    written.or_else(|error| if error.kind() == ErrorKind::BrokenPipe { Ok(()) } else { Err(error) }).is_ok()
}
