//! `grazing cover`: killed and resumed; what is reported.

use std::{
    fs,
    path::Path,
    process::Stdio,
    thread,
    time::{Duration, Instant},
};

use grazing_base::random::Random;

use crate::process::grazing;

fn stderr_of(arguments: &str, folder: &Path, code: i32) -> String {
    let output = grazing(arguments, folder).output().unwrap();
    assert_eq!(output.status.code(), Some(code), "{arguments}");
    String::from_utf8(output.stderr).unwrap()
}

/// Killed (SIGKILL) at random instants and resumed, a run writes the certificate of an undisturbed one.
#[test]
fn a_killed_run_resumes_to_the_same_certificate() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let range = "24..=44";
    let start = Instant::now();
    assert!(
        grazing(&format!("cover {range} --jobs 2 --certificate whole"), folder)
            .output()
            .unwrap()
            .status
            .success()
    );
    let whole = start.elapsed();
    let one_job = format!("cover {range} --jobs 1 --certificate one");
    assert!(grazing(&one_job, folder).output().unwrap().status.success());
    let read = |name: &str| fs::read(folder.join(name)).unwrap();
    assert!(read("whole") == read("one"), "the certificate depends on the number of threads");
    let mut numbers = Random(3);
    for round in 0..3 {
        let (journal, out) = (format!("journal{round}"), format!("out{round}"));
        let arguments = format!("cover {range} --jobs 2 --resume {journal} --certificate {out}");
        let (mut kills, mut before) = (0, 0);
        for _ in 0..8 {
            let mut child =
                grazing(&arguments, folder).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
            thread::sleep(whole * numbers.below(300) as u32 / 1000 + Duration::from_millis(1));
            child.kill().unwrap();
            kills += u32::from(!child.wait().unwrap().success());
            // A torn record on top, whatever the kill left.
            let path = folder.join(&journal);
            let mut text = fs::read(&path).unwrap_or_default();
            let whole_lines = text.iter().rposition(|&byte| byte == b'\n').map_or(0, |at| at + 1);
            assert!(whole_lines >= before, "finished work was lost");
            before = whole_lines;
            if whole_lines > 0 {
                text.extend_from_slice(b"0123456789abcdef 44 3 rsN1");
                fs::write(&path, text).unwrap();
            }
        }
        assert!(kills > 0);
        assert!(grazing(&arguments, folder).output().unwrap().status.success());
        assert!(read(&out) == read("whole"), "round {round}");
        // All is known now, and nothing changes.
        let journal_text = read(&journal);
        assert!(grazing(&arguments, folder).output().unwrap().status.success());
        assert!(read(&out) == read("whole") && read(&journal) == journal_text);
    }
    let other = stderr_of("cover 24..=45 --resume journal0", folder, 2);
    assert!(other.contains("it belongs to another run") && other.contains("24..=45"), "{other}");
    for option in ["--max-depth 40", "--r-max 0.99999"] {
        let other = stderr_of(&format!("cover {range} --resume journal0 {option}"), folder, 2);
        assert!(other.contains("it belongs to another run"), "{option}: {other}");
    }
    fs::write(folder.join("notes"), "these are\nnot a journal\n").unwrap();
    assert!(stderr_of("cover 8 --resume notes", folder, 2).contains("it is not a saved state"));
}

#[test]
fn the_command_reports_what_is_proved() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &str| {
        let output = grazing(arguments, folder.path()).output().unwrap();
        (output.status.code().unwrap(), String::from_utf8(output.stdout).unwrap())
    };
    let (code, text) = run("cover 8 --certificate c");
    assert_eq!(code, 0);
    assert!(text.starts_with("Proved: Conjecture 1 for r <= 1 - 1/n^3 and period n = 8.\n"), "{text}");
    assert_eq!(run("check c"), (0, "c: proved, cover for n = 8..=8\n  r_max: 511/512\n".to_string()));
    let (code, text) = run("cover 8 --max-depth 4 --format json --certificate none");
    let report: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!((code, &report["verdict"]), (3, &"undecided".into()));
    let period = &report["periods"][0];
    assert!(!period["open"].as_array().unwrap().is_empty() && period["rejection"].is_string(), "{text}");
    assert!(!folder.path().join("none").exists());
    let (code, text) = run("cover 8 --max-depth 4");
    assert_eq!(code, 3);
    assert!(text.contains("    open: r in [0.") && text.contains("--format json lists them all"), "{text}");
    for (arguments, expected) in [
        ("cover 2", "covers start at period 3, not at 2"),
        ("cover 8 --r-max 1", "r_max = 1: a fraction between 0 and 1"),
        ("cover 8 --r-max 0.9", "r_max = 9/10 may lie below an area of period 8: give at least 1 - 4.9/8^3"),
        ("cover 300", "`grazing cover` goes up to period 256, not 300"),
    ] {
        let message = stderr_of(arguments, folder.path(), 2);
        assert!(message.contains(expected), "grazing {arguments}: {message}");
    }
    assert_eq!(run("cover 8 --r-max 0.9999").0, 0);
}
