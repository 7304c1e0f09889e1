//! Running the built command as a process: signals, closed readers, kills.

// Each test program uses a part of this.
#![allow(dead_code)]

use std::{
    fs,
    path::Path,
    process::{Child, Command, Output, Stdio},
    thread,
    time::{Duration, Instant},
};

/// The command with these arguments, split at spaces, run in a folder.
pub fn grazing(arguments: &str, folder: &Path) -> Command {
    let mut command = Command::new(crate::PROGRAM);
    command.args(arguments.split_whitespace()).current_dir(folder);
    command
}

/// Exit code, standard output, standard error.
pub fn run(arguments: &str, folder: &Path) -> (i32, String, String) {
    ended(grazing(arguments, folder).output().unwrap())
}

pub fn ended(Output { status, stdout, stderr }: Output) -> (i32, String, String) {
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (status.code().expect("no signal ended it"), text(stdout), text(stderr))
}

/// The exit code and standard error of a command nobody reads.
pub fn unread(arguments: &str, folder: &Path) -> (i32, String) {
    let mut command = grazing(arguments, folder);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    let (code, _, stderr) = ended(child.wait_with_output().unwrap());
    (code, stderr)
}

/// The exit code and standard error of a command whose output meets a full disk.
pub fn onto_full_disk(arguments: &str, folder: &Path) -> (i32, String) {
    let full = fs::File::create("/dev/full").unwrap();
    let mut command = grazing(arguments, folder);
    let child = command.stdout(full).stderr(Stdio::piped()).spawn().unwrap();
    let (code, _, stderr) = ended(child.wait_with_output().unwrap());
    (code, stderr)
}

/// Starts a command, all its streams piped, and waits until it listens to signals.
pub fn listening(arguments: &str, folder: &Path) -> Child {
    let mut command = grazing(arguments, folder);
    let mut child =
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let listens = |id| {
        let status = fs::read_to_string(format!("/proc/{id}/status")).unwrap_or_default();
        let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:"));
        let both = 1 << (2 - 1) | 1 << (15 - 1);
        caught.is_some_and(|mask| u64::from_str_radix(mask.trim(), 16).unwrap() & both == both)
    };
    // It stays open: who waits for a child closes what the child has for input, and that would end it, too.
    std::mem::forget(child.stdin.take());
    while !listens(child.id()) {
        assert!(child.try_wait().unwrap().is_none(), "grazing {arguments} ended before it listened");
        thread::sleep(Duration::from_millis(1));
    }
    child
}

/// Waits until something holds, and fails rather than wait for ever, as for a process that has ended.
pub fn until(mut holds: impl FnMut() -> bool) {
    let start = Instant::now();
    while !holds() {
        assert!(start.elapsed() < Duration::from_secs(300), "waited for five minutes in vain");
        thread::sleep(Duration::from_millis(1));
    }
}

/// Sends signals, as in "-INT", one at once after the other.
pub fn signal(child: &Child, signals: &[&str]) {
    let kills = signals.iter().map(|signal| format!("kill {signal} {}", child.id())).collect::<Vec<_>>();
    assert!(Command::new("sh").arg("-c").arg(kills.join("; ")).status().unwrap().success());
}

/// The names of the files in a folder, in order.
pub fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}
