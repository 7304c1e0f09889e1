//! `grazing check`: a verdict for every file, an end when it is wanted.

use std::{
    fs,
    io::Write,
    path::Path,
    process::{Command, Stdio},
    thread,
    time::Duration,
};

const PROVED: &str = include_str!("../../crates/checker/tests/data/theorem2.txt");
const ORBIT: &str = include_str!("../../crates/checker/tests/data/orbit-4.txt");

fn grazing(arguments: &[&str]) -> Command {
    let mut command = Command::new(crate::PROGRAM);
    command.arg("check").args(arguments);
    command
}

fn file(folder: &Path, name: &str, text: &str) -> String {
    let path = folder.join(name);
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_string()
}

#[test]
fn every_file_gets_a_verdict_and_the_worst_decides() {
    let folder = tempfile::tempdir().unwrap();
    let proved = file(folder.path(), "proved", PROVED);
    let wrong = file(folder.path(), "false", &PROVED.replace("orbit 0/1 1/2 + -", "orbit 0/1 1/2 + +"));
    let missing = folder.path().join("missing").to_str().unwrap().to_string();
    for (files, expected, verdicts) in [
        (vec![&missing, &proved], 2, vec!["unreadable", "proved"]),
        (vec![&missing, &wrong, &proved], 1, vec!["unreadable", "rejected", "proved"]),
        (vec![&proved, &wrong], 1, vec!["proved", "rejected"]),
        (vec![&proved, &proved], 0, vec!["proved", "proved"]),
    ] {
        let arguments: Vec<&str> = files.into_iter().map(String::as_str).collect();
        let output = grazing(&arguments).output().unwrap();
        let text = String::from_utf8(output.stdout).unwrap();
        assert_eq!(output.status.code(), Some(expected), "{text}");
        let shown: Vec<&str> =
            text.lines().map(|line| line.split([':', ',']).nth(1).unwrap().trim()).collect();
        assert_eq!(shown, verdicts);
        let output = grazing(&arguments).args(["--format", "json"]).output().unwrap();
        assert_eq!(output.status.code(), Some(expected));
        let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let shown: Vec<&str> = report["files"]
            .as_array()
            .unwrap()
            .iter()
            .map(|file| file["verdict"].as_str().unwrap())
            .collect();
        assert_eq!(shown, verdicts);
    }
    // The same verdict, whoever reads it.
    let mut child = grazing(&[&wrong]).stdout(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    assert_eq!(child.wait().unwrap().code(), Some(1));
}

#[test]
fn json_says_in_words_what_is_proved() {
    let folder = tempfile::tempdir().unwrap();
    let orbit = file(folder.path(), "orbit", ORBIT);
    let output = grazing(&[&orbit, "--format", "json"]).output().unwrap();
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(report["format"], "grazing-check 2");
    let found = &report["files"][0];
    assert_eq!((&found["verdict"], &found["range"]), (&"proved".into(), &serde_json::json!([4, 4])));
    assert_eq!(found["detail"]["lower wall"], "-1 + 19/20 cos t, restitution 1");
    assert_eq!(found["detail"]["digest"], "8ff3296ee97e2e6716c08f3f3e068eed41c8e338d5b68e41aebedf4de995c288");
}

/// One signal ends it, also while it waits for what a pipe does not say.
#[test]
fn a_signal_ends_a_check_that_waits() {
    let mut child = grazing(&["-"]).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let mut pipe = child.stdin.take().unwrap();
    pipe.write_all(&PROVED.as_bytes()[..1000]).unwrap();
    // It listens once it is up; signals before that end it too, in another way.
    thread::sleep(Duration::from_millis(1500));
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    let output = child.wait_with_output().unwrap();
    drop(pipe);
    assert_eq!(output.status.code(), Some(3));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.starts_with("-: interrupted: line "), "{text}");
}
