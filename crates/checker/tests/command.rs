//! The command `grazing-check`: verdicts and exit codes.

mod common;
#[path = "../../../tests/samples/mod.rs"]
mod samples;

use std::{
    fs,
    io::Write,
    path::{Path, PathBuf},
    process::{Command, Output, Stdio},
};

use common::{COVER, THEOREM2, with};

fn command() -> Command {
    Command::new(env!("CARGO_BIN_EXE_grazing-check"))
}

fn run(arguments: &[&Path]) -> (Option<i32>, String) {
    let Output { status, stdout, .. } = command().args(arguments).output().unwrap();
    (status.code(), String::from_utf8(stdout).unwrap())
}

/// A folder of this test's own, with a file for each verdict: proved, malformed, false, open.
fn files(name: &str) -> (PathBuf, [PathBuf; 5]) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    // The first box of the first strip.
    let open = COVER.replacen("M;", "O;", 1);
    let contents = [
        ("proved", THEOREM2.to_string()),
        ("malformed", THEOREM2.replace("range", "ranges")),
        ("false", with(THEOREM2, "orbit 0/1 1/2 + -", "orbit 0/1 1/2 + +")),
        ("open", open),
    ];
    let paths = contents.map(|(name, text)| {
        let path = folder.join(name);
        fs::write(&path, text).unwrap();
        path
    });
    let missing = folder.join("missing");
    let [proved, malformed, wrong, open] = paths;
    (folder, [proved, malformed, wrong, open, missing])
}

#[test]
fn the_worst_verdict_decides_and_every_file_gets_one() {
    let (folder, [proved, malformed, wrong, open, missing]) = files("verdicts");
    let cases: [(&[&Path], i32); 10] = [
        (&[&proved], 0),
        (&[&proved, &proved], 0),
        (&[&malformed], 1),
        (&[&wrong], 1),
        (&[&open], 3),
        (&[&missing], 2),
        (&[&proved, &open], 3),
        (&[&missing, &open, &proved], 2),
        (&[&missing, &open, &wrong, &proved], 1),
        (&[&folder, &proved], 2),
    ];
    for (files, expected) in cases {
        let (code, text) = run(files);
        assert_eq!(code, Some(expected), "{text}");
        for file in files {
            assert!(text.lines().any(|line| line.starts_with(&format!("{}: ", file.display()))), "{text}");
        }
    }
    let (_, text) = run(&[&missing, &wrong, &open, &proved]);
    let verdicts: Vec<&str> = text.lines().map(|line| line.split(": ").nth(1).unwrap()).collect();
    assert_eq!(verdicts, ["unreadable", "rejected", "undecided", "proved, theorem2 for n = 1..=14"]);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn standard_input_is_read() {
    let mut child = command().arg("-").stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(THEOREM2.as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success());
    assert_eq!(output.stdout, b"-: proved, theorem2 for n = 1..=14\n");
}

/// A verdict does not depend on who reads it.
#[test]
fn a_reader_who_goes_away_changes_no_exit_code() {
    let (folder, [proved, malformed, _, open, missing]) = files("readers");
    for (file, code) in [(&proved, 0), (&malformed, 1), (&open, 3), (&missing, 2)] {
        let mut child = command().arg(file).stdout(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        assert_eq!(child.wait().unwrap().code(), Some(code));
    }
    if let Ok(full) = fs::File::options().write(true).open("/dev/full") {
        for (file, code) in [(&proved, 2), (&malformed, 1)] {
            let status = command().arg(file).stdout(full.try_clone().unwrap()).status().unwrap();
            assert_eq!(status.code(), Some(code));
        }
    }
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn wrong_usage_is_2_and_help_is_0() {
    let code = |arguments: &[&str]| command().args(arguments).output().unwrap().status.code();
    assert_eq!(code(&[]), Some(2));
    assert_eq!(code(&["--verbose"]), Some(2));
    assert_eq!(code(&["--help"]), Some(0));
}

/// An overflow inside ends the process, and not as a verdict would. `.ci/run` runs this test with
/// optimisation too.
#[test]
fn an_overflow_is_a_panic_and_no_verdict() {
    let output = command().arg("--overflow").output().unwrap();
    assert_eq!(output.status.code(), Some(101));
    assert!(String::from_utf8_lossy(&output.stderr).contains("attempt to add with overflow"));
}
