//! What a shell script relies on: exit codes that depend on the result alone, files that are whole or
//! untouched, signals that end every command with its state written.
use crate::process;

use std::{
    fs,
    io::Read,
    os::unix::fs::{PermissionsExt, symlink},
    path::Path,
    process::{Command, Stdio},
};

use process::{ended, grazing, listening, names, onto_full_disk, run, signal, unread, until};
use tempfile::tempdir;

/// A map with patterns that stay undecided.
const SINGULAR: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/maps/singular.toml");
const FOCUS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/maps/focus.toml");

/// A certificate with a false line.
fn false_certificate(folder: &Path) {
    assert_eq!(run("verify 8 --certificate good", folder).0, 0);
    let text = fs::read_to_string(folder.join("good")).unwrap();
    let damaged = text.replace("orbit 1/16 1/8 + +", "orbit 1/16 1/8 + -");
    assert_ne!(text, damaged);
    fs::write(folder.join("bad"), damaged).unwrap();
}

#[test]
fn exit_codes_do_not_depend_on_who_reads() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    false_certificate(folder);
    let cases = [
        ("check bad", 1),
        ("check good", 0),
        ("cover 8 --max-depth 3", 3),
        ("verify 8", 0),
        ("evaluate --n 8 --s 1/5", 0),
        ("classify --r 1/2 --s 1/4", 3),
        (&format!("existence {SINGULAR} --max-period 3"), 3),
        ("farey walk 300", 0),
        ("intervals 3..=100", 0),
        ("--help", 0),
        ("fuzz --n 12 --cases 1", 0),
    ];
    // A list that nobody reads ends; this one would take hours.
    assert_eq!(unread("farey walk 10000000", folder).0, 0);
    for (arguments, code) in cases {
        assert_eq!(run(arguments, folder).0, code, "{arguments}, read");
        let (unread, said) = unread(arguments, folder);
        assert_eq!(unread, code, "{arguments}, unread: {said}");
        assert!(!said.contains("Broken pipe") && !said.contains("panicked"), "{arguments}: {said}");
    }
}

#[test]
fn a_full_disk_is_a_failure_that_a_refutation_outranks() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    false_certificate(folder);
    for (arguments, wanted) in [
        ("check bad", 1),
        ("check good", 2),
        ("cover 8 --max-depth 3", 2),
        ("verify 8", 2),
        ("classify --r 1/2 --s 1/5", 2),
        ("evaluate --n 8 --s 1/5", 2),
        ("farey walk 10000000", 2),
        ("formula 4 2", 2),
        ("--help", 2),
    ] {
        let (code, said) = onto_full_disk(arguments, folder);
        assert_eq!(code, wanted, "{arguments}: {said}");
        assert!(!said.contains("panicked"), "{arguments}: {said}");
    }
    // Nothing depends on standard error.
    for (arguments, code) in [("verfy", 2), ("verify 0", 2), ("fuzz --n 12 --cases 1", 0)] {
        let full = fs::File::create("/dev/full").unwrap();
        let mut command = grazing(arguments, folder);
        assert_eq!(command.stdout(Stdio::null()).stderr(full).status().unwrap().code(), Some(code));
    }
}

/// Patterns [4] and [3] at µ = 0.02: one has a solution that passes through the wall, the other an orbit.
#[test]
fn a_refuted_row_of_a_task_is_a_refutation() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    let scene = r#"
format = "grazing-scene 1"
title = "orbits at mu = 0.02"
[system]
damping = "12/49"
stiffness = "100/2401"
[[walls]]
side = "lower"
offset = -1
harmonics = [{ cos = "1.02" }]
restitution = 1
[[tasks]]
name = "four"
kind = "validate"
orbit = { pattern = [4] }
[[tasks]]
name = "three"
kind = "validate"
orbit = { pattern = [3] }
"#;
    fs::write(folder.join("scene.toml"), scene).unwrap();
    for (arguments, code) in [("--only three", 0), ("--only four", 1), ("", 1)] {
        let arguments = format!("run scene.toml --format json {arguments}");
        let (found, out, said) = run(&arguments, folder);
        assert_eq!(found, code, "{arguments}: {out}{said}");
        assert_eq!(unread(&arguments, folder).0, code, "{arguments}, unread");
        let report: serde_json::Value = serde_json::from_str(&out).unwrap();
        let refuted = report["tasks"].as_array().unwrap().iter().any(|task| task["status"] == "refuted");
        assert_eq!(refuted, code == 1, "{out}");
    }
}

#[test]
fn limits_are_said() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    let refused = |arguments: &str| {
        let (code, out, said) = run(arguments, folder);
        assert_eq!((code, out.as_str()), (2, ""), "{arguments}");
        said
    };
    assert!(refused("verify 8 --jobs 100000").contains("four times the number of cores"));
    assert!(refused("fuzz --cases 0").contains("--cases 0: give at least 1"));
    // Words of the closed walks of n steps: 2^n − 1 with a marked step, so d p(d) over the divisors d of n
    // for p primitive patterns.
    let mut primitive = vec![0u64];
    let mut rows = 0;
    for n in 1..=30 {
        let divisors = |n: usize| (1..n).filter(move |d| n.is_multiple_of(*d));
        let repeated: u64 = divisors(n).map(|d| d as u64 * primitive[d]).sum();
        primitive.push(((1 << n) - 1 - repeated) / n as u64);
        rows += primitive[n] + divisors(n).map(|d| primitive[d]).sum::<u64>();
        if n == 9 {
            let table = run(&format!("existence {FOCUS} --max-period 9 --format csv"), folder).1;
            assert_eq!(table.lines().count() as u64, 1 + rows);
        }
    }
    let said = refused(&format!("existence {FOCUS} --max-period 30"));
    assert!(
        said.contains(&format!("--max-period 30 would write {rows} rows, and at most 10000000")),
        "{said}"
    );
    // Inputs and states without an end, or that are no files.
    for arguments in ["run /dev/zero", "existence /dev/zero"] {
        assert!(refused(arguments).contains("/dev/zero has more than 4194304 bytes"), "{arguments}");
    }
    for device in ["/dev/full", "/dev/zero", "/dev/null"] {
        for command in ["fuzz --cases 1", "cover 8"] {
            let said = refused(&format!("{command} --resume {device}"));
            assert!(
                said.contains(&format!("cannot resume from {device}: it is not a regular file")),
                "{said}"
            );
        }
    }
    assert_eq!(names(folder), [""; 0]);
}

#[test]
fn one_file_has_one_name() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("old"), "old").unwrap();
    symlink("old", folder.join("link")).unwrap();
    symlink("new", folder.join("dangling")).unwrap();
    fs::hard_link(folder.join("old"), folder.join("hard")).unwrap();
    fs::copy(FOCUS, folder.join("map.toml")).unwrap();
    for arguments in [
        "verify 8 -o old --certificate link",
        "verify 8 -o hard --certificate old",
        "verify 8 -o dangling --certificate new",
        "verify 8 -o ./new --certificate new",
        "cover 8 --certificate new --resume new",
        "fuzz --cases 1 --regressions new --resume dangling",
        "existence map.toml -o map.toml",
        "existence map.toml --dot ./map.toml",
        "existence map.toml --dot x -o x",
        "existence map.toml --pattern 1 --orbit pictures -o pictures/../pictures/orbit.csv",
    ] {
        if arguments.contains("pictures") {
            fs::create_dir(folder.join("pictures")).unwrap();
        }
        let (code, out, said) = run(arguments, folder);
        assert_eq!((code, out.as_str()), (2, ""), "{arguments}");
        assert!(said.contains("are the same file"), "{arguments}: {said}");
    }
    assert_eq!(fs::read(folder.join("old")).unwrap(), b"old");
    assert_eq!(fs::read(folder.join("map.toml")).unwrap(), fs::read(FOCUS).unwrap());
    // Devices are no files to be lost.
    assert_eq!(run("verify 8 -o /dev/null --certificate /dev/null", folder).0, 0);
}

/// A scene of a ball with a motion, and of a mass under a measured force with the task `name`; its record and
/// its stiffness are in files of their own.
fn scenes(folder: &Path, name: &str) {
    let ball = "format = \"grazing-scene 1\"\ntitle = \"a ball\"\n[system]\nforce = -1\n[[walls]]\nside = \"lower\"\n\
                offset = 0\nrestitution = 0.5\n[[tasks]]\nname = \"drop\"\nkind = \"simulate\"\nstart = { q = 0.5 }\nperiods = 1\n";
    fs::write(folder.join("ball.toml"), ball).unwrap();
    let mass = format!(
        "format = \"grazing-scene 2\"\ntitle = \"a mass\"\n[system]\nfrequency = 1\nmass = 1\ndamping = 0.5\n\
         stiffness = {{ file = \"stiff.csv\" }}\nmeasured = {{ file = \"record.csv\", harmonics = 1 }}\n[[tasks]]\n\
         name = \"{name}\"\nkind = \"simulate\"\nstart = {{ q = 0 }}\nperiods = 1\n"
    );
    fs::write(folder.join("mass.toml"), mass).unwrap();
    fs::write(folder.join("stiff.csv"), "4\n").unwrap();
    let record: String = (0..=40).map(|i| format!("{},{}\n", f64::from(i) / 20.0, i % 20)).collect();
    fs::write(folder.join("record.csv"), format!("time,force\n{record}")).unwrap();
}

/// Nothing that a command reads is written by it, and nothing is written twice, whatever the files are
/// called.
#[test]
fn no_file_is_lost_to_another_of_the_same_command() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    scenes(folder, "record");
    assert_eq!(run("verify 8 --certificate cert", folder).0, 0);
    assert_eq!(run("fuzz --n 12 --cases 1 --resume state", folder).0, 0);
    assert_eq!(run("verify 3..=4 --shard 1/1 --certificate part", folder).0, 0);
    fs::write(folder.join("list"), "part\n").unwrap();
    symlink("cert", folder.join("link")).unwrap();
    symlink("stiff.csv", folder.join("stiffer.csv")).unwrap();
    fs::hard_link(folder.join("ball.toml"), folder.join("hard.toml")).unwrap();
    let restart = "format = \"grazing-scene 1\"\ntitle = \"t\"\n[parameters]\na = 1\n[system]\nforce = -1\n[[walls]]\nside = \"lower\"\n\
                   offset = 0\nharmonics = [{ sin = \"a\" }]\nrestitution = 0.5\n[[tasks]]\nname = \"br\"\nkind = \"branch\"\n\
                   parameter = \"a\"\nrange = [0, 1]\nstarts = [{ restart = { file = \"br-2.json\", label = \"flip 1\" } }]\n";
    fs::write(folder.join("branch.toml"), restart).unwrap();
    fs::write(folder.join("br-2.json"), "{}").unwrap();
    let before: Vec<(String, Vec<u8>)> =
        names(folder).into_iter().map(|name| (name.clone(), fs::read(folder.join(&name)).unwrap())).collect();
    let scene = fs::read_to_string(folder.join("mass.toml")).unwrap();
    for (arguments, wanted) in [
        ("verify 8 --certificate new --profile new", "are the same file"),
        ("verify 8 -o new --profile ./new", "are the same file"),
        ("verify 8 --certificate link --profile cert", "are the same file"),
        ("cover 8 --resume new --profile new", "are the same file"),
        ("fuzz --n 12 --cases 1 --resume state --profile state", "are the same file"),
        ("run ball.toml --profile hard.toml", "are the same file"),
        (
            "run ball.toml --profile drop.csv",
            "this task would write drop.csv, which is --profile drop.csv: rename",
        ),
        ("run ball.toml --profile DROP-events.csv", "would write drop-events.csv"),
        ("run mass.toml", "would write record.csv, which is the scene's file record.csv: rename"),
        ("run mass.toml --profile stiffer.csv", "are the same file"),
        ("run mass.toml --shard 1/1 -o mass.toml", "no parts"),
        ("run branch.toml", "this task would write br-N.json, which is the restart of br ./br-2.json"),
        ("merge --files-from list -o list", "are the same file"),
        ("merge part -o part", "are the same file"),
        ("check cert -o link", "are the same file"),
        ("intervals 8 --format latex --cite cert -o link", "are the same file"),
        ("verify 8 --profile -", "--profile -: standard output has the report"),
    ] {
        let (code, out, said) = run(arguments, folder);
        assert_eq!((code, out.as_str()), (2, ""), "{arguments}: {said}");
        assert!(said.contains(wanted), "{arguments}: {said}");
        assert_eq!(names(folder).len(), before.len(), "{arguments}");
        for (name, bytes) in &before {
            assert!(fs::read(folder.join(name)).unwrap() == *bytes, "{arguments} changed {name}");
        }
    }
    // The matrix, by a link that the task would write through.
    fs::write(folder.join("mass.toml"), scene.replace("\"record\"", "\"stiffer\"")).unwrap();
    let (code, _, said) = run("run mass.toml", folder);
    assert!(code == 2 && said.contains("which is the scene's file stiff.csv"), "{said}");
    // Standard streams are files too.
    let shell = |line: &str| {
        let line = line.replace("grazing", crate::PROGRAM);
        ended(Command::new("sh").arg("-c").arg(line).current_dir(folder).output().unwrap())
    };
    for line in [
        "grazing verify 8 --certificate /dev/stdout >new",
        "grazing verify 8 --certificate new >>new",
        "grazing verify 8 --certificate new 2>new; grep -q 'standard error' new && exit 2",
        "grazing run ball.toml >drop.csv",
        "grazing check - -o cert <cert",
    ] {
        let (code, _, said) = shell(line);
        assert_eq!(code, 2, "{line}: {said}");
        for name in ["new", "drop.csv"] {
            let _ = fs::remove_file(folder.join(name));
        }
    }
    assert_eq!(
        fs::read(folder.join("cert")).unwrap(),
        before.iter().find(|(name, _)| name == "cert").unwrap().1
    );
    let both = shell("grazing verify 8 --certificate new -o /dev/stdout >out 2>&1");
    assert_eq!((both.0, names(folder).contains(&"new".to_string())), (0, true), "{}", both.2);
}

/// What is printed is the scene with the names of format 3, as a file or through a pipe.
#[test]
fn an_upgrade_is_printed_and_nothing_is_written() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    scenes(folder, "swing");
    let before = names(folder);
    let old = fs::read_to_string(folder.join("ball.toml")).unwrap();
    let (code, out, said) = run("run ball.toml --upgrade", folder);
    assert_eq!((code, said.as_str()), (0, ""));
    assert_eq!(out, old.replace("grazing-scene 1", "grazing-scene 3").replace("[[walls]]", "[[stops]]"));
    fs::write(folder.join("new.toml"), &out).unwrap();
    assert_eq!(run("run new.toml --upgrade", folder).1, out);
    assert_eq!(run("run ball.toml --upgrade --dry-run", folder).0, 2);
    fs::remove_file(folder.join("new.toml")).unwrap();
    assert_eq!(names(folder), before);
}

#[test]
fn a_dry_run_lists_the_files_and_touches_none() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    scenes(folder, "swing");
    let before = names(folder);
    let (code, out, _) = run("run mass.toml --dry-run -o out/deep --profile p", folder);
    let wanted = "reads  mass.toml (the scene)\nreads  stiff.csv (the scene's file)\nreads  record.csv (the scene's file)\n\
                  writes p (--profile)\nwrites out/deep/swing-N.svg (the task swing)\nwrites out/deep/swing.svg (the task swing)\n\
                  writes out/deep/swing.csv (the task swing)\nwrites out/deep/swing-events.csv (the task swing)\n";
    assert_eq!((code, out.as_str()), (0, wanted));
    assert_eq!(names(folder), before);
    let (code, out, _) = run("run ball.toml --dry-run --format json", folder);
    let told: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!((code, &told["format"]), (0, &"grazing-files 1".into()));
    assert_eq!(told["reads"], serde_json::json!([{ "file": "ball.toml", "as": "the scene" }]));
    let written: Vec<&str> =
        told["writes"].as_array().unwrap().iter().map(|file| file["file"].as_str().unwrap()).collect();
    // What is listed is what is written, of a series some.
    assert_eq!(run("run ball.toml", folder).0, 0);
    let new: Vec<String> = names(folder).into_iter().filter(|name| !before.contains(name)).collect();
    assert!(
        !new.is_empty() && new.iter().all(|name| written.contains(&format!("./{name}").as_str())),
        "{new:?}"
    );
}

/// A pipe is opened once: its reader sees all that is written, and goes when that is over.
#[test]
fn a_pipe_is_opened_once() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    assert!(Command::new("mkfifo").arg(folder.join("pipe")).status().unwrap().success());
    let wanted = run("intervals 8", folder).1;
    for command in ["intervals 8 -o pipe", "verify 3..=200 --certificate pipe"] {
        let line =
            format!("cat pipe >got & timeout 120 {} {command}; code=$?; wait; exit $code", crate::PROGRAM);
        let (code, _, said) =
            ended(Command::new("sh").arg("-c").arg(line).current_dir(folder).output().unwrap());
        assert_eq!(code, 0, "{command}: {said}");
        let got = fs::read_to_string(folder.join("got")).unwrap();
        assert!(got == wanted || got.starts_with("grazing-certificate "), "{command}: {got}");
    }
    let said = run("fuzz --n 12 --cases 1 --resume pipe", folder).2;
    assert!(said.contains("--resume pipe: it is a pipe"), "{said}");
}

/// What others have written, names of files and of stops, headers and keys, neither moves the cursor nor
/// turns a line nor is a formula.
#[test]
fn text_of_others_is_printable_and_no_formula() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    let hostile = |text: &str| {
        text.chars().any(|c| c.is_control() && c != '\n' || ('\u{202a}'..='\u{202e}').contains(&c))
    };
    let name = "a\u{1b}[31m\u{202e}b\nc";
    fs::write(folder.join(name), "no certificate").unwrap();
    let told = |arguments: &[&str]| {
        let mut command = Command::new(crate::PROGRAM);
        ended(command.args(arguments).current_dir(folder).output().unwrap())
    };
    for arguments in [
        vec!["check", name],
        vec!["run", name],
        vec!["merge", name],
        vec!["existence", name],
        vec!["verify", "8", "--certificate", name],
    ] {
        let (_, out, said) = told(&arguments);
        assert!(!hostile(&out) && !hostile(&said), "{arguments:?}: {out:?} {said:?}");
        assert!((out + &said).contains("a\\u{1b}[31m\\u{202e}b\\nc"), "{arguments:?}");
    }
    // A key, a number and a header.
    let stop = "=HYPERLINK(1)\\u001b</text>\\\\input{x}, \\u202e\\\"q\\\"";
    let scene = |rest: &str| {
        format!(
            "format = \"grazing-scene 2\"\ntitle = \"</title>\\u001b[2J\"\n[system]\nfrequency = 0.2\nmass = 1\nstiffness = 1\n{rest}\n\
             forcing = [{{ cos = [1] }}]\n[[walls]]\nname = \"{stop}\"\nrow = [1]\noffset = 0\nrestitution = 0.5\n\
             [[tasks]]\nname = \"m\"\nkind = \"simulate\"\nstart = {{ q = 0.5 }}\nperiods = 2\n"
        )
    };
    for rest in
        ["\"a\\u001b[31m\" = 1", "damping = \"\\u001b[31m\"", "measured = { file = \"r.csv\", once = true }"]
    {
        fs::write(folder.join("s.toml"), scene(rest)).unwrap();
        fs::write(folder.join("r.csv"), "time,\u{1b}[31mforce\n").unwrap();
        let (code, out, said) = told(&["run", "s.toml"]);
        assert!(code == 2 && !hostile(&out) && !hostile(&said), "{rest}: {said:?}");
    }
    fs::write(folder.join("s.toml"), scene("")).unwrap();
    let (code, out, said) = told(&["run", "s.toml"]);
    assert!(code == 0 && !hostile(&out) && !hostile(&said), "{out:?} {said:?}");
    let events = fs::read_to_string(folder.join("m-events.csv")).unwrap();
    let written = "\"'=HYPERLINK(1)\\u{1b}</text>\\input{x}, \\u{202e}\"\"q\"\"\"";
    assert!(!hostile(&events) && events.contains(written), "{events:?}");
    // A spreadsheet reads numbers as numbers.
    assert!(events.lines().nth(1).unwrap().split(',').nth(1).unwrap().parse::<f64>().is_ok(), "{events}");
    let picture = fs::read_to_string(folder.join("m.svg")).unwrap();
    assert!(!hostile(&picture) && picture.matches("</title>").count() == 1, "{picture}");
    assert!(!picture.contains("</text>\\input"));
}

#[test]
fn every_output_is_tried_before_the_work_and_not_touched() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("kept"), "kept").unwrap();
    fs::write(folder.join("fixed"), "fixed").unwrap();
    fs::set_permissions(folder.join("fixed"), fs::Permissions::from_mode(0o444)).unwrap();
    // Work without end: only what is tried first can answer.
    for work in [
        "verify 3..=200000 -o",
        "verify 3..=200000 --certificate",
        "cover 3..=256 --certificate",
        "intervals 3..=10000000 -o",
        "boundary 2..=100000 -o",
        "fuzz --cases 1e16 --regressions",
        "fuzz --cases 1e16 --resume",
    ] {
        for (path, reason) in
            [("nowhere/x", "nowhere"), (".", "folder"), ("kept/x", "kept"), ("fixed", "read-only")]
        {
            if path == "fixed" && work.ends_with("resume") {
                continue;
            }
            let (code, out, said) = run(&format!("{work} {path}"), folder);
            assert_eq!((code, out.as_str()), (2, ""), "{work} {path}");
            assert!(said.contains(reason) || said.contains("regular"), "{work} {path}: {said}");
        }
    }
    let before = fs::metadata(folder.join("kept")).unwrap().modified().unwrap();
    let mut child = listening("verify 3..=200000 --certificate kept -o other", folder);
    signal(&child, &["-INT"]);
    assert_eq!(child.wait().unwrap().code(), Some(3));
    assert_eq!(fs::metadata(folder.join("kept")).unwrap().modified().unwrap(), before);
    assert_eq!(fs::read(folder.join("kept")).unwrap(), b"kept");
}

#[test]
fn files_have_the_users_mode_and_links_are_followed() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    symlink("new", folder.join("dangling")).unwrap();
    let binary = crate::PROGRAM;
    let script = format!(
        "umask 027; {binary} intervals 8 -o dangling && {binary} fuzz --n 12 --cases 1 --resume state && {binary} cover 8 --resume journal"
    );
    let mut command = Command::new("sh");
    let (code, _, said) = ended(command.arg("-c").arg(script).current_dir(folder).output().unwrap());
    assert_eq!(code, 0, "{said}");
    assert_eq!(names(folder), ["dangling", "journal", "new", "state"]);
    assert!(folder.join("dangling").is_symlink());
    for name in ["new", "state", "journal"] {
        let mode = fs::metadata(folder.join(name)).unwrap().permissions().mode() & 0o777;
        assert_eq!(mode, 0o640, "{name}: {mode:o}");
    }
    let table = run("intervals 8", folder).1;
    assert_eq!(fs::read_to_string(folder.join("new")).unwrap(), table);
    assert_eq!(run("intervals 8 -o -", folder), (0, table.clone(), String::new()));
    assert_eq!(run("intervals 8 -o /dev/stdout", folder).1, table);
    assert_eq!(names(folder).len(), 4);
    assert!(run("verify 8 --certificate -", folder).2.contains("write ./- for a file of that name"));
}

#[test]
fn what_a_kill_left_is_removed_but_not_what_another_writes() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    let writes = || {
        let child = listening("intervals 3..=10000000 --format csv -o file", folder);
        let many = names(folder).len();
        (child, many)
    };
    let temporaries =
        || names(folder).into_iter().filter(|name| name.starts_with(".grazing-")).collect::<Vec<_>>();
    // The first is of the trial whether the file can be written: the work's has something in it.
    let at_work = || {
        let written = |name: &String| fs::metadata(folder.join(name)).is_ok_and(|found| found.len() > 0);
        temporaries().first().is_some_and(written)
    };
    let (mut killed, _) = writes();
    until(at_work);
    killed.kill().unwrap();
    killed.wait().unwrap();
    let left = temporaries();
    assert_eq!(left.len(), 1);
    // The next run for another target leaves it alone, the next for the same takes it away.
    assert_eq!(run("intervals 8 -o other", folder).0, 0);
    assert_eq!(temporaries(), left);
    assert_eq!(run("intervals 8 -o file", folder).0, 0);
    assert_eq!(names(folder), ["file", "other"]);
    let (mut first, _) = writes();
    until(at_work);
    let held = temporaries();
    assert_eq!(run("intervals 9 -o file", folder).0, 0);
    assert_eq!(temporaries(), held, "its owner still writes");
    signal(&first, &["-TERM"]);
    assert_eq!(first.wait().unwrap().code(), Some(3));
    assert_eq!(names(folder), ["file", "other"]);
    assert_eq!(fs::read_to_string(folder.join("file")).unwrap(), run("intervals 9", folder).1);
}

#[test]
fn a_state_has_one_user_who_is_named() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    for (kind, arguments) in
        [("fuzz", "fuzz --cases 1e16 --resume state"), ("cover", "cover 100..=256 --resume journal")]
    {
        let state = arguments.split(' ').next_back().unwrap();
        let mut child = listening(arguments, folder);
        until(|| folder.join(state).exists());
        let (code, out, said) = run(arguments, folder);
        assert_eq!((code, out.as_str()), (2, ""), "{said}");
        assert!(said.contains(&format!("is in use by process {} (grazing {kind})", child.id())), "{said}");
        signal(&child, &["-TERM"]);
        let mut report = String::new();
        child.stdout.take().unwrap().read_to_string(&mut report).unwrap();
        let mut said = String::new();
        child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
        assert_eq!(child.wait().unwrap().code(), Some(3), "{report}{said}");
        assert!(report.starts_with("Interrupted: ") || said.contains("continue"), "{report}{said}");
    }
}

#[test]
fn an_interruption_is_said_in_json_too() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    for arguments in [
        "fuzz --cases 1e16",
        "fuzz --cases 1e16 --n 1..=4096",
        "verify 3..=200000",
        "cover 100..=256",
        "intervals 3..=10000000",
        "boundary 2..=100000 --digits 200",
        "farey walk 100000000",
        "evaluate --n 100000 --s 1/5+2^-300",
        "check -",
    ] {
        let mut child = listening(&format!("{arguments} --format json"), folder);
        signal(&child, &["-INT"]);
        let mut report = Vec::new();
        child.stdout.take().unwrap().read_to_end(&mut report).unwrap();
        assert_eq!(child.wait().unwrap().code(), Some(3), "{arguments}");
        let report: serde_json::Value = serde_json::from_slice(&report).expect(arguments);
        // `check` has a verdict for each file.
        let verdict = report.get("verdict").unwrap_or(&report["files"][0]["verdict"]);
        assert_eq!(verdict, "interrupted", "{arguments}");
    }
}

/// A task deep in its work, balls of 4096 bits, hears no signal for seconds: the report says of every task
/// how far it came.
#[test]
fn the_report_of_a_run_whose_end_was_forced_has_every_task() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    let task = |name: &str, rest: &str| format!("[[tasks]]\nname = \"{name}\"\n{rest}\n");
    let motion = "kind = \"simulate\"\nstart = { q = 0.5 }\nperiods = 2";
    let orbit = "kind = \"validate\"\nbits = 4096\norbit = { pattern = [3, 3], start = [0.0039, 0.0182, -0.1078, 0.1098] }";
    // The paper's oscillator at µ = 0.006, balls of 4096 bits.
    let scene = "format = \"grazing-scene 1\"\ntitle = \"t\"\n[system]\ndamping = \"12/49\"\nstiffness = \"100/2401\"\n\
        [[walls]]\nside = \"lower\"\noffset = -1\nharmonics = [{ cos = \"1.006\" }]\nrestitution = 1\n"
        .to_string()
        + &task("first", motion)
        + &task("long", orbit)
        + &task("last", motion);
    fs::write(folder.join("s.toml"), scene).unwrap();
    let mut child = listening("run s.toml -o out --format json", folder);
    until(|| folder.join("out/first.svg").exists());
    std::thread::sleep(std::time::Duration::from_millis(300));
    signal(&child, &["-INT"]);
    let mut report = Vec::new();
    child.stdout.take().unwrap().read_to_end(&mut report).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(3));
    let report: serde_json::Value = serde_json::from_slice(&report).unwrap();
    assert_eq!(report["format"], "grazing-run 4");
    let all: Vec<_> =
        report["tasks"].as_array().unwrap().iter().map(|task| (&task["task"], &task["status"])).collect();
    assert_eq!(
        format!("{all:?}"),
        r#"[(String("first"), String("done")), (String("long"), String("interrupted")), (String("last"), String("pending"))]"#
    );
    assert_eq!(report["tasks"][1]["reason"], "the process ended while this was under way");
    assert!(report["tasks"][0]["effects"]["piece"].as_u64() > Some(0));
}

/// Whatever it is doing, and even if what it does never ends.
#[test]
fn one_signal_ends_every_command() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    assert!(Command::new("mkfifo").arg(folder.join("fifo")).status().unwrap().success());
    for arguments in [
        "accuracy -o out",
        "accuracy --of simulations -o out",
        "check -",
        "run fifo",
        "existence fifo",
        "classify --a1 1/3+2^-90 --a2 9/10 --max-n 100000",
        "figure tips --n 400 -o out",
        "fuzz --n 1..=512 --cases 1e12",
        "fuzz --n 4096 --cases 1e12 --definition-share 1",
    ] {
        for name in ["-INT", "-TERM"] {
            let child = listening(arguments, folder);
            signal(&child, &[name]);
            let (code, _, said) = ended(child.wait_with_output().unwrap());
            assert_eq!(code, 3, "{arguments}: {said}");
            assert!(!names(folder).iter().any(|name| name.starts_with(".grazing")), "{arguments}");
        }
    }
}

#[test]
fn a_second_signal_ends_at_once_with_130() {
    let folder = tempdir().unwrap();
    // A command that waits for a file to be written cannot end in order at once, as others may before the
    // second signal.
    assert!(Command::new("mkfifo").arg(folder.path().join("fifo")).status().unwrap().success());
    for signals in [["-INT", "-TERM"], ["-TERM", "-INT"]] {
        let mut child = listening("run fifo", folder.path());
        signal(&child, &signals);
        assert_eq!(child.wait().unwrap().code(), Some(130));
    }
}
