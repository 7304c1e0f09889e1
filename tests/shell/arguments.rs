//! Arguments: one name for each thing, numbers below 0 as values, one exit code for one thing, and what bad
//! values are told.

use std::{
    fs,
    io::Write,
    path::Path,
    process::{Command, Output, Stdio},
};

fn run(folder: &Path, arguments: &str) -> (i32, String, String) {
    ended(Command::new(crate::PROGRAM).args(arguments.split(' ')).current_dir(folder))
}

fn ended(command: &mut Command) -> (i32, String, String) {
    let Output { status, stdout, stderr } = command.output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (status.code().unwrap(), text(stdout), text(stderr))
}

/// What a thing was called once is another name of it, which no help shows.
#[test]
fn old_names_are_still_understood() {
    let folder = tempfile::tempdir().unwrap();
    for (command, now, once) in [
        ("classify --r 0.9 --s 0.37", "--max-period 4", "--max-n 4"),
        ("intervals 5", "--digits 3", "--decimals 3"),
        ("intervals --measure 5", "--digits 3", "--decimals 3"),
        ("evaluate --s 1/7", "5 2", "--n 5 --k 2"),
        ("evaluate --s 1/7", "5", "--n 5"),
        ("fuzz --cases 100 --format json", "1..=12", "--n 1..=12"),
        ("fuzz --words --cases 100 --format json", "1..=12", "--n 1..=12"),
    ] {
        let [(new, out, error), old] =
            [now, once].map(|names| run(folder.path(), &format!("{command} {names}")));
        let untimed = |text: &str| text.lines().filter(|line| !line.contains("second")).collect::<String>();
        assert_eq!((new, error.as_str()), (0, ""), "{command} {now}");
        assert_eq!((new, untimed(&out)), (old.0, untimed(&old.1)), "{command} {once}: {}", old.2);
        let name = command.split(' ').next().unwrap();
        let help = run(folder.path(), &format!("{name} --help")).1;
        let option = once.split(' ').next().unwrap();
        assert!(!help.contains(&format!("{option} ")), "{name} --help shows {option}");
    }
    for names in ["9", "--n 9"] {
        assert_eq!(run(folder.path(), &format!("figure intervals {names} -o {}.svg", names.len())).0, 0);
    }
    let picture = |name| fs::read_to_string(folder.path().join(name)).unwrap();
    assert_eq!(picture("1.svg"), picture("5.svg"));
    // Twice is an error, under whatever names.
    for twice in ["evaluate 5 --n 5 --s 1/7", "fuzz 12 --n 12 --cases 9", "figure intervals 9 --n 9"] {
        assert_eq!(run(folder.path(), twice).0, 2, "{twice}");
    }
}

/// A number below 0 is a value of every option, and wherever a number may stand: what is told is what is
/// wrong with it, and never that it be written otherwise.
#[test]
fn negative_numbers_are_values() {
    let folder = tempfile::tempdir().unwrap();
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/scenes/bouncing-ball.toml");
    let run_scene = format!("run {}", scene.display());
    for command in [
        "verify @",
        "verify 3 --jobs @",
        "cover @",
        "cover 3 --r-max @",
        "cover 3 --max-depth @",
        "cover 3 --jobs @",
        "intervals @",
        "intervals 3 --digits @",
        "intervals --two-impacts @",
        "intervals --measure @",
        "intervals --pattern @,3",
        "classify --r 1/2 --s 1/5 --max-period @",
        "classify --r @ --s 1/5",
        "classify --a1 1 --a2 @",
        "word --r 1/2 --s @",
        "word --r 1/2 --s 1/5 --max-period @",
        "word --r 1/2 --s 1/5 --letters @",
        "boundary @",
        "boundary 5 --m @",
        "boundary 5 --grid @",
        "boundary 5 --digits @",
        "evaluate @ --s 1/7",
        "evaluate 5 @ --s 1/7",
        "evaluate 5 --s @",
        "evaluate 5 --s 1/7 --bits @",
        "fuzz @ --cases 9",
        "fuzz --cases @",
        "fuzz --cases 9 --seed @",
        "fuzz --cases 9 --jobs @",
        "fuzz --cases 9 --definition-share @",
        "farey rank 1/2 @",
        "farey kth @ 3",
        "farey walk @",
        "formula @ 2",
        "formula 5 @",
        "sequence tips @",
        "figure intervals @",
        "figure records --r @ --s 1/5",
        "figure records --r 1/2 --s @",
        &format!("{run_scene} --jobs @"),
        &format!("{run_scene} --shard @/3 -o part"),
    ] {
        for value in ["-7", "-1/4", "-0.5", "-.5", "-3..=5"] {
            let line = command.replace('@', value);
            let (code, out, error) = run(folder.path(), &line);
            assert_eq!((code, out.as_str()), (2, ""), "grazing {line}: {error}");
            assert!(error.starts_with("error: ") && error.lines().count() == 1, "grazing {line}: {error}");
            assert!(
                !error.contains("unexpected argument") && !error.contains("tip:"),
                "grazing {line}: {error}"
            );
            // The value, or, where it is printed as a fraction, what it was given to.
            let option = command.split(' ').rev().skip_while(|word| !word.contains('@')).nth(1).unwrap();
            let given_to = option.trim_start_matches("--").replace('-', "_") + " = ";
            let named = error.contains(value.trim_start_matches('-')) || error.contains(&given_to);
            assert!(named, "grazing {line}: {error}");
        }
    }
    let (code, _, error) = run(folder.path(), &format!("{run_scene} --set a=-1/2 --dry-run"));
    assert_eq!((code, error.as_str()), (0, ""));
    let (code, out, _) = run(folder.path(), "word --a1 -0.26..=-0.25 --a2 0.5..=0.51");
    assert!(code == 0 && out.contains("word DUU"), "{out}");
    // Of what is no number nothing is said that does not help.
    let (code, _, error) = run(folder.path(), "boundary -x");
    assert!(code == 2 && error.contains("'-x'") && !error.contains("-- -x"), "{error}");
}

/// Where Theorem 1 is silent of what was asked, the exit code is 3, whichever command was asked.
#[test]
fn one_thing_has_one_exit_code() {
    let folder = tempfile::tempdir().unwrap();
    for point in ["--r 1 --s 1/4", "--a1 -3/2 --a2 1/2"] {
        for command in ["classify", "word"] {
            assert_eq!(run(folder.path(), &format!("{command} {point}")).0, 3, "{command} {point}");
        }
    }
    for command in ["classify", "word"] {
        assert_eq!(run(folder.path(), &format!("{command} --r 0.9 --s 0.37")).0, 0, "{command}");
    }
}

#[test]
fn what_is_reversed_or_given_twice_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/scenes/bouncing-ball.toml");
    let scene = scene.display();
    for (line, told) in [
        ("verify 3..2", "3..2 is reversed: write 2..=3, which includes both ends"),
        ("verify 5..=3", "the range is reversed: write 3..=5"),
        ("verify 3..8", "3..8 is ambiguous: write 3..=8"),
        (&format!("run {scene} --set a=1 --set a=2"), "a is given twice; leave one out"),
        ("boundary 5 --digits 3/8", "\"3/8\" is not a whole number"),
    ] {
        let (code, _, error) = run(folder.path(), line);
        assert!(code == 2 && error.contains(told), "grazing {line}: {error}");
    }
    for line in
        ["boundary 5 --digits x", "evaluate 5 --s 1/7 --bits x", "fuzz --cases x", "verify 3 --jobs x"]
    {
        let (_, _, error) = run(folder.path(), line);
        assert!(error.contains("not a whole number") && !error.contains("3/8"), "grazing {line}: {error}");
    }
}

/// A scene with one line in place of another.
fn scene(folder: &Path, from: &str, to: &str) -> String {
    const SCENE: &str = r#"
format = "grazing-scene 3"
title = "A driven mass and a stop"

[parameters]
d = 0.1

[system]
mass = 1
damping_ratio = "d"
stiffness = 2
forcing = [{ cos = 1 }]

[[stops]]
side = "upper"
offset = 1
restitution = 0.8

[[tasks]]
name = "motion"
kind = "simulate"
start = { q = 0 }
periods = 4

[[tasks]]
name = "attractors"
kind = "section"
starts = [{ q = 0 }]
"#;
    assert!(SCENE.contains(from));
    fs::write(folder.join("scene.toml"), SCENE.replace(from, to)).unwrap();
    "run scene.toml --only motion --dry-run".to_string()
}

#[test]
fn what_no_machine_has_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let system = "mass = 1\ndamping_ratio = \"d\"\nstiffness = 2\nforcing = [{ cos = 1 }]\n\n[[stops]]\nside = \"upper\"";
    let modes = "period = 1\nmodes = { frequencies = [10, 20], ratios = [0.01, -0.02], shapes = [[1, 1]] }\n\n[[stops]]\nrow = 1";
    for (from, to, told) in [
        ("periods = 4", "periods = 0", "periods = 0: is 0; a motion is followed for at least 1"),
        ("starts = [{ q = 0 }]", "starts = []", "starts = []: is empty; a motion must start somewhere"),
        ("d = 0.1", "d = -0.1", "damping_ratio = \"d\": is -0.1; a damping ratio is at least 0"),
        (system, modes, "ratios[2] = -0.02: is -0.02; a damping ratio is at least 0"),
    ] {
        let command = scene(folder, from, to);
        let command = if from.starts_with("starts") { "run scene.toml --dry-run" } else { &command };
        let (code, _, error) = run(folder, command);
        assert!(code == 2 && error.contains(told), "{to}: {error}");
        assert!(error.starts_with("error: scene.toml:"), "{error}");
    }
    let command = scene(folder, "d = 0.1", "d = 0");
    assert_eq!(run(folder, &command), (0, run(folder, &command).1, String::new()));
    // Of an oscillator a mass may be positive in the file and not where a parameter is set.
    let mass = "mass = \"1 - 2*d\"\ndamping = 0.1";
    let command = scene(folder, "mass = 1\ndamping_ratio = \"d\"", mass) + " --set d=1";
    let (code, _, error) = run(folder, &command);
    assert!(code == 2 && error.contains("\"1 - 2*d\": is -1; a mass is positive (with d = 1)"), "{error}");
    // Damping itself may be negative: a machine may feed on what drives it.
    let command = scene(folder, "damping_ratio = \"d\"", "damping = \"-d\"");
    assert_eq!(run(folder, &command).2, "");
}

/// `-` is standard input to `merge` as to other commands, a pipe or a file.
#[test]
fn a_shard_may_come_by_standard_input() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    for part in [1, 2] {
        assert_eq!(run(folder, &format!("verify 3..=9 --shard {part}/2 --certificate {part}")).0, 0);
    }
    assert_eq!(run(folder, "merge 1 2 -o whole").0, 0);
    let mut child = Command::new(crate::PROGRAM)
        .args(["merge", "2", "-", "-o", "piped"])
        .current_dir(folder)
        .stdin(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(&fs::read(folder.join("1")).unwrap()).unwrap();
    assert!(child.wait().unwrap().success());
    assert_eq!(fs::read(folder.join("piped")).unwrap(), fs::read(folder.join("whole")).unwrap());
    assert!(run(folder, "merge - - -o no").2.contains("standard input is one shard: give it once"));
    // What is wrong with it is told under that name.
    let damaged = fs::read_to_string(folder.join("1")).unwrap().replacen("item 3", "item 4", 1);
    fs::write(folder.join("damaged"), damaged).unwrap();
    let (code, _, error) = ended(
        Command::new(crate::PROGRAM)
            .args(["merge", "2", "-", "-o", "no"])
            .current_dir(folder)
            .stdin(fs::File::open(folder.join("damaged")).unwrap()),
    );
    assert!(code == 2 && error.contains("error: -: it is damaged: its checksum does not match"), "{error}");
}

/// A page of the manual says what is typed.
#[test]
fn the_manual_says_grazing_run() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    assert_eq!(run(folder, "man -o pages").0, 0);
    for (page, typed) in [("grazing-run", "grazing run"), ("grazing-farey-kth", "grazing farey kth")] {
        let text = fs::read_to_string(folder.join(format!("pages/{page}.1"))).unwrap();
        assert!(text.contains(&format!("\\fB{typed}\\fR")), "{text}");
        assert!(text.contains(&format!(".TH {page} 1  \"grazing ")), "{text}");
    }
}
