//! `grazing-check FILE…`: the checker as a command of its own, so that nothing but this package need be
//! trusted.

use std::{
    env,
    ffi::OsStr,
    fs::File,
    io::{self, BufReader, ErrorKind, Read, Write},
    process::{Command, ExitCode},
};

use grazing_check::{Checked, Rejection, check, overflow};

const USAGE: &str = "\
usage: grazing-check [--proved] FILE…        (- is standard input)

Proves certificates again and prints a verdict for each. Exit code: 1 if a certificate is malformed or false; else 2 if a file cannot be
read, the verdicts cannot be written, or the usage is wrong; else 3 if something is left open; else 0: all are proved.

With --proved each file that is proved is read by grazing-proved, too, whose decisions Coq has proved: it lies beside this program or on
the PATH, and `sh proofs/coq/reader.sh FOLDER` makes it. What that refuses is an error (1); what it does not read is left open (3).

grazing-check --overflow ends with a panic (exit code 101), if this program was built to notice overflows, as it should be.";

fn main() -> ExitCode {
    let mut files: Vec<_> = env::args_os().skip(1).collect();
    let again = files.first().is_some_and(|first| first == "--proved");
    if again {
        files.remove(0);
    }
    match files.first().and_then(|first| first.to_str()) {
        Some("--overflow") => println!("built without overflow checks: {} + 1 = {}", u64::MAX, overflow()),
        Some("--help" | "-h") => return if say(USAGE) { ExitCode::SUCCESS } else { ExitCode::from(2) },
        Some(option) if option.starts_with("--") => eprintln!("unknown option {option}\n{USAGE}"),
        Some(_) | None if !files.is_empty() => {
            let codes: Vec<u8> = files.iter().map(|file| verdict(file, again)).collect();
            return ExitCode::from([1, 2, 3].into_iter().find(|code| codes.contains(code)).unwrap_or(0));
        }
        _ => eprintln!("{USAGE}"),
    }
    ExitCode::from(2)
}

/// Checks a file, once more by the proved reader if that is asked for, and prints its verdict; the exit code
/// that it asks for.
fn verdict(file: &OsStr, again: bool) -> u8 {
    let (mut text, mut code) = match proved(file) {
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
    if again && code == 0 {
        let said;
        (said, code) = read_again(file);
        text = format!("{text}\n  by the proved reader: {said}");
    }
    let written = say(&format!("{}: {text}", file.display()));
    if written || code == 1 { code } else { 2 }
}

/// What `grazing-proved` says of a file, and the exit code for that.
fn read_again(file: &OsStr) -> (String, u8) {
    const NAME: &str = "grazing-proved";
    if file == "-" {
        return ("not asked, as it reads files alone".into(), 2);
    }
    let beside = env::current_exe().ok().map(|own| own.with_file_name(NAME)).filter(|path| path.is_file());
    let output = match Command::new(beside.unwrap_or(NAME.into())).arg("--").arg(file).output() {
        Ok(output) => output,
        Err(error) => {
            let hint =
                "it is made by `sh proofs/coq/reader.sh FOLDER`, and lies beside this program or on the PATH";
            return (format!("not asked, as {NAME} does not start ({error}): {hint}"), 2);
        }
    };
    let answer = String::from_utf8_lossy(&output.stdout).trim_end().to_string();
    let code = match answer.as_str() {
        _ if !output.status.success() => {
            let why = String::from_utf8_lossy(&output.stderr);
            let why = why.lines().next().unwrap_or("without a word");
            return (format!("no answer, as {NAME} failed ({}): {why}", output.status), 2);
        }
        "proved" => 0,
        _ if answer.starts_with("proved; ") || answer.starts_with("not read: ") => 3,
        _ if answer.starts_with("refused: ") => 1,
        _ => return (format!("{NAME} answers {answer:?}, which is no verdict"), 2),
    };
    (answer, code)
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
