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

/// With `--proved` what is proved is read again by `grazing-proved`: its answer, or why there is none, is
/// told, and decides with the checker's.
#[cfg(unix)]
#[test]
fn what_is_proved_is_read_again_where_that_is_asked_for() {
    use std::os::unix::fs::PermissionsExt;
    let (folder, [proved, malformed, _, open, _]) = files("again");
    let reader = folder.join("grazing-proved");
    for (script, code, said) in [
        ("echo proved", 0, ": proved\n"),
        ("echo 'proved; reach, entropy: not read'", 3, ": proved; reach, entropy: not read\n"),
        ("echo 'not read: a kind'", 3, ": not read: a kind\n"),
        ("echo 'refused: line 3: no'", 1, ": refused: line 3: no\n"),
        ("echo proven", 2, "answers \"proven\", which is no verdict"),
        ("echo proved; exit 2", 2, "no answer, as grazing-proved failed (exit status: 2): without a word"),
        ("echo 'no room' >&2; exit 2", 2, "(exit status: 2): no room\n"),
        ("test \"$1\" = -- && test \"$2\" = \"$FILE\" && echo proved", 0, ": proved\n"),
        ("", 2, "does not start"),
    ] {
        if script.is_empty() {
            fs::remove_file(&reader).unwrap();
        } else {
            fs::write(&reader, format!("#!/bin/sh\n{script}\n")).unwrap();
            fs::set_permissions(&reader, fs::Permissions::from_mode(0o755)).unwrap();
        }
        let ask = |file: &Path| {
            let mut command = command();
            command.arg("--proved").arg(file).env("PATH", &folder).env("FILE", file);
            let output = command.output().unwrap();
            (output.status.code(), String::from_utf8(output.stdout).unwrap())
        };
        let (found, text) = ask(&proved);
        assert_eq!(found, Some(code), "{script}: {text}");
        assert!(text.contains("\n  by the proved reader: ") && text.contains(said), "{script}: {text}");
        // What is not proved is not read again.
        for (file, code) in [(&malformed, 1), (&open, 3)] {
            let (found, text) = ask(file);
            assert!(found == Some(code) && !text.contains("proved reader"), "{text}");
        }
    }
    let mut command = command();
    let child = command.args(["--proved", "-"]).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
    let mut child = child.unwrap();
    child.stdin.take().unwrap().write_all(THEOREM2.as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stdout).contains("reads files alone"));
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn wrong_usage_is_2_and_help_is_0() {
    let code = |arguments: &[&str]| command().args(arguments).output().unwrap().status.code();
    assert_eq!(code(&[]), Some(2));
    assert_eq!(code(&["--verbose"]), Some(2));
    assert_eq!(code(&["--proved"]), Some(2));
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
