//! Shards: put together they are what one run writes; whatever is wrong with one is said.

use std::{
    fs,
    path::Path,
    process::{Command, Output},
    sync::atomic::{AtomicU64, Ordering},
};

use grazing_scenes::{
    Monitor,
    run::{Job, Surroundings, parts},
    scene::Scene,
};
use serde_json::Value;
use tempfile::{TempDir, tempdir};

fn run(folder: &Path, arguments: &str) -> (i32, String, String) {
    let Output { status, stdout, stderr } =
        Command::new(crate::PROGRAM).args(arguments.split_whitespace()).current_dir(folder).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (status.code().unwrap(), text(stdout), text(stderr))
}

fn done(folder: &Path, arguments: &str) -> String {
    let (code, out, error) = run(folder, arguments);
    assert_eq!(code, 0, "{arguments}: {error}");
    out
}

/// Writes shards 1 to `of` of a command as `1`, `2`, …; their names, the last first.
fn shards(folder: &TempDir, command: &str, file: &str, of: u64) -> String {
    for index in 1..=of {
        done(folder.path(), &format!("{command} --shard {index}/{of} {file} {index}"));
    }
    (1..=of).rev().map(|index| format!(" {index}")).collect()
}

/// FNV-1a of 64 bits, by its definition.
fn hash(text: &str) -> u64 {
    hash_of(text.as_bytes())
}

fn hash_of(bytes: &[u8]) -> u64 {
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, step)
}

/// A shard with its last line: the number of items and a hash of all before it.
fn sealed(body: &str) -> String {
    let hash = hash(body);
    let records = body.lines().filter(|line| line.starts_with("item ")).count();
    format!("{body}end {records} {hash:016x}\n")
}

/// The program that a shard names.
fn program(shard: &str) -> String {
    let line = shard.lines().find_map(|line| line.strip_prefix("program ")).unwrap();
    line.split(' ').next().unwrap().to_string()
}

fn body(shard: &str) -> &str {
    &shard[..shard.rfind("end ").unwrap()]
}

#[test]
fn certificates_are_those_of_one_run() {
    // More shards than periods: some are empty.
    for (command, of) in
        [("verify 3..=40", 5), ("verify 1..=4", 9), ("cover 3..=9", 3), ("cover 5 --r-max 97/100", 2)]
    {
        let folder = tempdir().unwrap();
        done(folder.path(), &format!("{command} --certificate whole"));
        let files = shards(&folder, command, "--certificate", of);
        let out = done(folder.path(), &format!("merge {files} -o merged"));
        assert!(out.starts_with("merged: proved, "), "{out}");
        let read = |name| fs::read_to_string(folder.path().join(name)).unwrap();
        assert_eq!(read("merged"), read("whole"), "{command}");
        // A shard is no certificate, and says what to do with it.
        let (code, out, _) = run(folder.path(), "check 1");
        assert!(code == 1 && out.contains("grazing merge"), "{out}");
    }
}

#[test]
fn tables_are_those_of_one_run() {
    // In the second more parts than periods; the b-file's shards hold numbers.
    for (command, of) in [
        ("intervals 3..=40 --format csv --decimals 7", 4),
        ("intervals 1..=3 --format json", 7),
        ("intervals 1..=60 --format bfile", 3),
        ("intervals 9 --format latex", 2),
        ("intervals --two-impacts 3..=12 --format markdown", 3),
        ("intervals --two-impacts 3..=12 --format bfile", 2),
        ("boundary 2..=9", 3),
        ("boundary 3..=6 --grid 3 --format json --digits 20", 2),
        ("boundary 5..=6 --m 1 --format csv", 1),
    ] {
        let folder = tempdir().unwrap();
        done(folder.path(), &format!("{command} -o whole"));
        let files = shards(&folder, command, "-o", of);
        done(folder.path(), &format!("merge {files} -o merged"));
        let read = |name| fs::read_to_string(folder.path().join(name)).unwrap();
        assert_eq!(read("merged"), read("whole"), "{command}");
        let (code, out, _) = run(folder.path(), "check 1");
        assert!(code == 1 && out.contains("grazing merge"), "{out}");
        let (code, _, error) = run(folder.path(), &format!("merge {files} --format json"));
        assert!(code == 2 && error.contains("--format is for reports"), "{error}");
    }
}

const SCENE: &str = r#"
format = "grazing-scene 1"
title = "A driven mass and a stop"
[parameters]
F = 0.5
F2 = 0
[system]
damping = "1/10"
stiffness = "3/10"
forcing = [{ cos = "F" }, { k = 2, sin = "F2" }]
[[walls]]
side = "upper"
offset = 1
restitution = 0.8
[[tasks]]
name = "basins"
kind = "basins"
set = { F = 0.6 }
q = { from = -1, to = 1.2, count = 9 }
u = { from = -1, to = 1, count = 7 }
transient = 60
longest = 8
[[tasks]]
name = "over-F"
kind = "diagram"
parameter = "F"
range = [0.6, 0.9]
count = 13
starts = [{ q = 0 }, { q = 0.5, u = 0.2 }]
transient = 60
points = 12
longest = 4
branches = [{ at = 0.65, orbit = { pattern = [1] } }]
[[tasks]]
name = "plane"
kind = "basins"
plane = ["phase", "u"]
start = { q = 0.4 }
q = { from = 0, to = 1, count = 6 }
u = { from = -1, to = 1, count = 5 }
transient = 60
longest = 8
[[tasks]]
name = "map"
kind = "map"
parameter = "F"
range = [0.5, 0.9]
count = 5
second = "F2"
second_range = [0, 0.1]
second_count = 7
start = { q = 0 }
transient = 60
points = 24
longest = 8
[[tasks]]
name = "motion"
kind = "simulate"
start = { q = 0 }
periods = 4
"#;

/// Two masses: their states have another form than an oscillator's.
const MACHINE: &str = r#"
format = "grazing-scene 2"
title = "Two masses and a stop"
[system]
frequency = 0.2
mass = [[1, 0], [0, 2]]
damping = [[0.6, -0.2], [-0.2, 0.5]]
stiffness = [[3, -1], [-1, 4]]
forcing = [{ k = 1, cos = [0.9, 0] }]
[[walls]]
name = "stop"
row = [1, 0]
offset = -0.3
restitution = 0.7
[[tasks]]
name = "basins"
kind = "basins"
plane = ["q1", "u1"]
q = { from = -0.5, to = 0.5, count = 5 }
u = { from = -0.5, to = 0.5, count = 4 }
transient = 60
longest = 4
"#;

/// The files in a folder, by name.
fn contents(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let file = |entry: std::io::Result<fs::DirEntry>| {
        let path = entry.unwrap().path();
        (path.file_name().unwrap().to_str().unwrap().to_string(), fs::read(path).unwrap())
    };
    let mut all: Vec<_> = fs::read_dir(folder).unwrap().map(file).collect();
    all.sort();
    all
}

#[test]
fn tasks_of_scenes_are_those_of_one_run() {
    for (scene, task, of) in [
        (SCENE, "basins", 3),
        (SCENE, "over-F", 4),
        (SCENE, "plane", 2),
        (SCENE, "map", 3),
        (SCENE, "basins --set F=4/5", 9),
        (MACHINE, "basins", 2),
    ] {
        let folder = tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::write(path("scene.toml"), scene).unwrap();
        let command = format!("run scene.toml --only {task}");
        let whole = done(folder.path(), &format!("{command} -o whole"));
        let files = shards(&folder, &command, "-o", of);
        // The shards hold all that is needed.
        fs::remove_file(path("scene.toml")).unwrap();
        let merged = done(folder.path(), &format!("merge {files} -o merged"));
        assert_eq!(merged, whole, "{task}");
        assert!(contents(&path("whole")).len() >= 2);
        assert_eq!(contents(&path("merged")), contents(&path("whole")), "{task}");
        let left: Vec<String> = contents_names(folder.path());
        assert!(left.iter().all(|name| !name.contains("checkpoint")), "{left:?}");
        let (code, out, _) = run(folder.path(), "check 1");
        assert!(code == 1 && out.contains("grazing merge"), "{out}");
    }
}

fn contents_names(folder: &Path) -> Vec<String> {
    fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| !name.starts_with('.'))
        .collect()
}

#[test]
fn scenes_are_told_apart_by_what_they_say() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("scene.toml"), SCENE).unwrap();
    let part = |scene: &str, index: u64| {
        done(folder.path(), &format!("run {scene} --only basins --shard {index}/3 -o {index}"))
    };
    (1..=3).for_each(|index| drop(part("scene.toml", index)));
    let merge = |code: i32| {
        let (found, out, error) = run(folder.path(), "merge 1 2 3 -o out");
        assert_eq!(found, code, "{out}{error}");
        error
    };
    merge(0);
    // Another name and other ends of lines are the same scene.
    fs::write(path("renamed.toml"), SCENE.replace('\n', "\r\n")).unwrap();
    part("renamed.toml", 2);
    merge(0);
    // Another content under the same name is not, though the command is the same.
    fs::write(path("scene.toml"), SCENE.replace("restitution = 0.8", "restitution = 0.7")).unwrap();
    part("scene.toml", 2);
    let error = merge(2);
    assert!(error.contains("2: it is of another content of scene.toml"), "{error}");
    assert!(error.contains("1 of 3 shards are missing: --array=2"), "{error}");
    // Nor is another value of a parameter.
    fs::write(path("scene.toml"), SCENE).unwrap();
    done(folder.path(), "run scene.toml --only basins --set F=7/10 --shard 2/3 -o 2");
    let error = merge(2);
    assert!(
        error.contains("--set F=7/10`, the others are of 3 of `grazing run SCENE --only basins`"),
        "{error}"
    );
    // A copy as text has other ends of lines, and its checksum is no longer right.
    part("scene.toml", 2);
    let good = fs::read_to_string(path("2")).unwrap();
    fs::write(path("2"), good.replace('\n', "\r\n")).unwrap();
    assert!(merge(2).contains("2: its lines end with CR LF"));
    // Records that no run comes to, with the right checksum.
    let seal = |text: String| fs::write(path("2"), sealed(body(&text))).unwrap();
    for (from, to) in [
        ("\\\"Attractor\\\":0", "\\\"Attractor\\\":9"),
        ("\"found\"", "\"lost\""),
        ("\"piece\"", "\"peace\""),
    ] {
        assert!(good.contains(from), "{from}: {good}");
        seal(good.replacen(from, to, 1));
        assert!(merge(2).contains("has a record that is not one"), "{to}");
    }
}

/// A monitor that wants an end after some units.
struct After(AtomicU64);

impl Monitor for After {
    fn advance(&self, units: u64) -> grazing_scenes::Result<()> {
        let left = self.0.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| left.checked_sub(units));
        left.map(drop).map_err(|_| grazing_scenes::Error::interrupted("enough"))
    }
}

#[test]
fn a_part_of_a_task_goes_on_from_where_it_was_ended() {
    let folder = tempdir().unwrap();
    let file = folder.path().join("checkpoint");
    // Rows and values are kept by the stretch, of which there are some.
    let text = SCENE.replace("count = 7", "count = 40").replace("count = 13", "count = 300");
    let scene = Scene::from_toml(&text, "scene.toml").unwrap();
    for (task, units, enough) in [(&scene.tasks[0], 40, 20), (&scene.tasks[1], 300, 200)] {
        let part = |monitor: &dyn Monitor, units| {
            let job = Job::new(&scene, task, Surroundings { monitor, ..Surroundings::default() }).unwrap();
            parts::part(&job, units, &file)
        };
        let whole = part(&(), 1..units).unwrap();
        assert_eq!(whole.len() as u64, units - 1);
        fs::remove_file(&file).unwrap();
        assert!(part(&After(enough.into()), 1..units).unwrap_err().is_interrupted());
        let kept = fs::read_to_string(&file).unwrap().lines().count();
        assert!(kept > 1, "{kept} lines");
        // What was counted on the way is there, too.
        assert_eq!(part(&(), 1..units).unwrap(), whole);
        // The checkpoint is of this part.
        assert!(part(&(), 0..units).unwrap_err().is_input());
        fs::remove_file(&file).unwrap();
    }
}

#[test]
fn two_processes_write_one_shard_and_a_full_disk_none() {
    let folder = tempdir().unwrap();
    fs::write(folder.path().join("scene.toml"), SCENE).unwrap();
    let command = "verify 3..=60 --shard 1/2 --certificate part";
    let start = || {
        Command::new(crate::PROGRAM)
            .args(command.split(' '))
            .current_dir(folder.path())
            .output()
            .map(|output| output.status.code())
    };
    let codes = std::thread::scope(|scope| {
        [(); 4].map(|()| scope.spawn(start)).map(|thread| thread.join().unwrap().unwrap())
    });
    assert_eq!(codes, [Some(0); 4]);
    let part = fs::read(folder.path().join("part")).unwrap();
    done(folder.path(), command);
    assert_eq!(fs::read(folder.path().join("part")).unwrap(), part);
    assert!(contents(folder.path()).iter().all(|(name, _)| !name.starts_with('.')), "no temporary is left");
    if cfg!(target_os = "linux") {
        for command in [
            "verify 3..=9 --shard 1/2 --certificate /dev/full",
            "intervals 3..=9 --shard 1/2 -o /dev/full",
            "boundary 3..=4 --shard 1/2 -o /dev/full",
        ] {
            let (code, _, error) = run(folder.path(), command);
            assert!(code == 2 && error.contains("/dev/full"), "{command}: {code} {error}");
        }
    }
}

#[test]
fn names_of_shards_can_come_from_a_list() {
    let folder = tempdir().unwrap();
    let files = shards(&folder, "intervals 3..=9 --format csv", "-o", 3);
    let list: String = files.split_whitespace().map(|name| format!("{name}\n")).collect();
    fs::write(folder.path().join("list"), list).unwrap();
    done(folder.path(), "merge --files-from list -o merged");
    // Given twice is a fault; an empty list is said.
    let (code, _, error) = run(folder.path(), "merge 2 --files-from list -o again");
    assert!(code == 2 && error.contains("it is shard 2/3 again"), "{error}");
    fs::write(folder.path().join("list"), "\n").unwrap();
    let (code, _, error) = run(folder.path(), "merge --files-from list -o again");
    assert!(code == 2 && error.contains("it names no file"), "{error}");
    let (code, _, error) = run(folder.path(), "merge --files-from absent -o again");
    assert!(code == 2 && error.contains("absent"), "{error}");
}

#[test]
fn campaigns_count_what_one_run_counts() {
    for command in ["fuzz --n 1..=12 --cases 5e5 --seed 3", "fuzz --words --n 1..=24 --cases 1e5 --seed 3"] {
        let folder = tempdir().unwrap();
        let counts = |report: &str| {
            let mut report: Value = serde_json::from_str(report).unwrap();
            let tally = report["tally"].as_object_mut().unwrap();
            tally.retain(|key, _| !key.ends_with("seconds"));
            report
        };
        let whole = counts(&done(folder.path(), &format!("{command} --format json")));
        let files = shards(&folder, command, "-o", 3);
        let merged = counts(&done(folder.path(), &format!("merge {files} --format json")));
        assert_eq!(merged, whole);
        assert!(whole["tally"]["units"].as_u64().unwrap() > 2);
    }
}

/// The hash of sources in a shard, from the files by their definition: their names, lengths and bytes,
/// chapter by chapter. `grazing-verify` writes the same.
#[test]
fn shards_name_the_sources_of_their_program() {
    fn files(folder: &Path, name: &str, all: &mut Vec<String>) {
        for entry in fs::read_dir(folder.join(name)).unwrap() {
            let entry = entry.unwrap();
            let inner = format!("{name}/{}", entry.file_name().to_str().unwrap());
            if entry.path().is_dir() { files(folder, &inner, all) } else { all.push(inner) }
        }
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let hashed = |chapter: &str, mut names: Vec<String>, folders: &[&str]| {
        let root = &root.join(chapter);
        folders.iter().for_each(|folder| files(root, folder, &mut names));
        names.retain(|name| !name.replace("../", "").contains("/."));
        names.sort();
        let mut bytes = Vec::new();
        for name in names {
            let text = fs::read(root.join(&name)).unwrap();
            let text: Vec<u8> = text.into_iter().filter(|&byte| byte != b'\r').collect();
            bytes.extend(format!("{name} {}\n", text.len()).into_bytes());
            bytes.extend(text);
        }
        format!("{:016x}", hash_of(&bytes))
    };
    let chapters = [
        hashed("crates/base", vec!["../../Cargo.lock".into()], &["src", "../number/src"]),
        hashed(".", Vec::new(), &["src", "crates/checker/src"]),
        hashed("crates/verify", Vec::new(), &["src"]),
    ];
    let folder = tempdir().unwrap();
    done(folder.path(), "verify 3 --shard 1/1 --certificate 1");
    let shard = fs::read_to_string(folder.path().join("1")).unwrap();
    let expected = format!("{}+{:016x}", env!("CARGO_PKG_VERSION"), hash_of(chapters.concat().as_bytes()));
    assert_eq!(program(&shard), expected);
    assert_eq!(<grazing_verify::Theory as grazing_verify::Commands>::program(&[]), expected);
}

#[test]
fn what_is_wrong_with_shards_is_said() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let files = shards(&folder, "verify 3..=20", "--certificate", 6);
    let merge = |files: &str, code: i32| -> String {
        let (found, _, error) = run(folder.path(), &format!("merge {files} -o merged"));
        assert_eq!(found, code, "{files}: {error}");
        assert!(!path("merged").exists(), "nothing is written");
        error
    };
    assert!(merge("1 4 6", 2).contains("3 of 6 shards are missing: --array=2-3,5"));
    // The same for programs.
    let (code, out, _) = run(folder.path(), "merge 1 4 6 absent -o merged --format json");
    let told: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((code, &told["format"]), (2, &Value::from("grazing-merge 1")));
    assert_eq!((&told["missing"], &told["array"]), (&Value::from(vec![2, 3, 5]), &Value::from("2-3,5")));
    assert_eq!(told["of"], 6);
    assert!(
        told["faults"].as_array().unwrap().len() == 1 && told["faults"][0].to_string().contains("absent")
    );
    let error = merge(&format!("{files} absent"), 2);
    assert!(error.contains("absent") && error.contains("leave out the files named above"), "{error}");
    fs::copy(path("2"), path("again")).unwrap();
    assert!(
        merge(&format!("{files} again"), 2).contains("again: it is shard 2/6 again, after 2: leave one out")
    );
    // A damaged one counts as missing, so that it is done again.
    let good = fs::read_to_string(path("5")).unwrap();
    fs::write(path("5"), good.replacen("orbit", "orbis", 1)).unwrap();
    let error = merge(&files, 2);
    assert!(error.contains("5: it is damaged") && error.contains("--array=5\n"), "{error}");
    fs::write(path("5"), &good[..good.len() / 2]).unwrap();
    assert!(merge(&files, 2).contains("5: it is cut off"));
    // One of another version, of another task, of another cut.
    let program = program(&good);
    let foreign = body(&good).replace(&format!("program {program}"), "program 0.0.0");
    fs::write(path("5"), sealed(&foreign)).unwrap();
    assert!(merge(&files, 2).contains("5: its first lines are not those of a shard"), "another hash");
    let task = |program: &str| format!("task {:016x}", hash(&format!("{program} verify 3..=20")));
    let foreign = foreign.replace(&task(&program), &task("0.0.0"));
    fs::write(path("5"), sealed(&foreign)).unwrap();
    assert!(merge(&files, 2).contains("5: it is by version 0.0.0, the others are by"));
    // The same version, from other sources.
    let (version, sources) = program.split_once('+').unwrap();
    assert!(version == env!("CARGO_PKG_VERSION") && sources.len() == 16, "{program}");
    let other = format!("{version}+{}", "0".repeat(16));
    let foreign = body(&good).replace(&format!("program {program}"), &format!("program {other}"));
    fs::write(path("5"), sealed(&foreign.replace(&task(&program), &task(&other)))).unwrap();
    assert!(merge(&files, 2).contains(&format!("5: it is by version {other}, the others are by {program}")));
    done(folder.path(), "verify 3..=21 --shard 5/6 --certificate 5");
    assert!(
        merge(&files, 2)
            .contains("of `grazing verify 3..=21`, the others are of 6 of `grazing verify 3..=20`")
    );
    done(folder.path(), "verify 3..=20 --shard 5/7 --certificate 5");
    assert!(merge(&files, 2).contains("5: it is shard 5/7"));
    // Items that are not those of its part.
    let moved = body(&good).replace("shard 5/6", "shard 6/6");
    fs::write(path("5"), &good).unwrap();
    fs::write(path("6"), sealed(&moved)).unwrap();
    let error = merge(&files, 2);
    assert!(error.contains("6: it is damaged: item "), "{error}");
    done(folder.path(), "verify 3..=20 --shard 6/6 --certificate 6");
    // What stands there stays unless the new one is proved.
    fs::write(path("merged"), "what stood there").unwrap();
    let untrue = |text: String, wanted: &str| {
        fs::write(path("5"), sealed(&text)).unwrap();
        let (code, out, error) = run(folder.path(), &format!("merge {files} -o merged"));
        assert!(code == 1 && out.contains("merged: rejected: line "), "{code} {out} {error}");
        assert!(error.contains(wanted), "{error}");
        assert!(error.contains("error: 1 of 6 shards are false: --array=5\n"), "{error}");
        assert_eq!(fs::read_to_string(path("merged")).unwrap(), "what stood there");
        let (_, out, _) = run(folder.path(), &format!("merge {files} -o merged --format json"));
        let told: Value = serde_json::from_str(&out).unwrap();
        assert_eq!((&told["missing"], &told["array"]), (&Value::from(vec![5]), &Value::from("5")));
        assert!(told["faults"][0].as_str().unwrap().contains(wanted), "{told}");
    };
    // A period whose block is empty: that all periods are there is part of what is proved.
    let last = body(&good).lines().last().unwrap();
    let without =
        body(&good).replace(&format!("{last}\n"), &format!("{} \"\"\n", &last[..last.find(" \"").unwrap()]));
    untrue(without, "5: rejected: line ");
    // A false line with a right checksum: the certificate is proved again, and is not.
    untrue(body(&good).replacen(" + -", " - -", 1), "5: rejected: line ");
    // A pipe is given nothing that is not proved.
    let (code, out, _) = run(folder.path(), &format!("merge {files} -o /dev/null"));
    assert!(code == 1 && out.contains("/dev/null: rejected: "), "{out}");
    fs::write(path("5"), good).unwrap();
    let (code, out, error) = run(folder.path(), &format!("merge {files} -o merged"));
    assert!(code == 0 && out.contains("merged: proved, "), "{code} {out} {error}");
}

/// The scripts of a cluster, on a computer that stands for one: `sbatch` does at once what it is sent.
#[test]
fn scripts_send_again_what_is_missing_and_what_is_false() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let scripts = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("examples/cluster");
    for name in ["campaign.sh", "array.sbatch", "merge.sbatch"] {
        let text = fs::read_to_string(scripts.join(name)).unwrap();
        let small = text.replace("SHARDS=16", "SHARDS=4").replace("3..=500", "3..=20");
        fs::write(path(name), small).unwrap();
    }
    let sbatch = r#"#!/bin/sh
for word; do
    case "$word" in
    --array=*) array=$(echo "${word#--array=}" | tr , ' ') ;;
    *.sbatch) script=$word ;;
    esac
done
echo "$script $array" >>sent
[ "$script" = merge.sbatch ] && { sh merge.sbatch >merge.log 2>&1; exit 0; }
for task in $array; do SLURM_ARRAY_TASK_ID=$task sh "$script" || exit; done
echo 1
"#;
    fs::create_dir(path("bin")).unwrap();
    fs::create_dir(path("parts")).unwrap();
    fs::write(path("bin/sbatch"), sbatch).unwrap();
    std::os::unix::fs::symlink(crate::PROGRAM, path("bin/grazing")).unwrap();
    assert!(Command::new("chmod").arg("+x").arg(path("bin/sbatch")).status().unwrap().success());
    for index in [1, 2, 4] {
        done(folder.path(), &format!("verify 3..=20 --shard {index}/4 --certificate parts/part-{index}"));
    }
    let good = fs::read_to_string(path("parts/part-2")).unwrap();
    fs::write(path("parts/part-2"), sealed(&body(&good).replacen(" + -", " - -", 1))).unwrap();
    let bin = format!("{}:{}", path("bin").display(), std::env::var("PATH").unwrap());
    let merge = Command::new("sh").arg("merge.sbatch").env("PATH", bin).current_dir(folder.path()).output();
    assert_eq!(merge.unwrap().status.code(), Some(2));
    // First the one that is missing, then the one that is false.
    let sent = fs::read_to_string(path("sent")).unwrap();
    assert_eq!(sent, "array.sbatch 3\nmerge.sbatch \narray.sbatch 2\nmerge.sbatch \n");
    done(folder.path(), "verify 3..=20 --certificate whole");
    assert_eq!(fs::read(path("theorem2.txt")).unwrap(), fs::read(path("whole")).unwrap());
}

/// A tally that is none of its part, and tasks that this program gives nobody a part of.
#[test]
fn what_is_claimed_in_a_shard_is_looked_at() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let files = shards(&folder, "fuzz --n 1..=12 --cases 2e4 --seed 3", "-o", 2);
    let good = fs::read_to_string(path("1")).unwrap();
    let merge = |text: String, wanted: &str| {
        fs::write(path("1"), sealed(&text)).unwrap();
        let (code, out, error) = run(folder.path(), &format!("merge {files}"));
        assert!(code == 2 && error.contains(wanted), "{wanted}: {code} {out} {error}");
    };
    let from = good.find("\"units\":").unwrap();
    let units = &good[from..from + good[from..].find([',', '}']).unwrap()];
    merge(body(&good).replace(units, "\"units\":1"), "no run can give this tally");
    // A true tally, of fewer blocks than the part has.
    done(folder.path(), "fuzz --n 1..=12 --cases 1 --seed 3 --shard 1/1 -o short");
    let short = fs::read_to_string(path("short")).unwrap();
    let record = short.lines().find(|line| line.starts_with("item ")).unwrap();
    let head: Vec<&str> = good.lines().take(4).collect();
    merge(format!("{}\n{record}\n", head.join("\n")), "a tally of 1 blocks, where the part has ");
    // Whole, and alone of its task: but no shard is given these arguments.
    let program = program(&good);
    for words in ["fuzz --n 1..=2 --cases 9", "fuzz --regressions x", "verify 3..=9 --certificate x", "run x"]
    {
        let task = hash(&format!("{program} {words}"));
        let head =
            format!("grazing-shard 1\ncommand {words}\nprogram {program} task {task:016x}\nshard 1/1\n");
        fs::write(path("odd"), sealed(&head)).unwrap();
        let (code, out, error) = run(folder.path(), "merge odd -o merged");
        assert!(code == 2 && error.starts_with("error: "), "{words}: {code} {out} {error}");
        assert!(!path("merged").exists() && !path("x").exists(), "{words}");
    }
}

#[test]
fn wrong_use_is_named() {
    let folder = tempdir().unwrap();
    fs::write(folder.path().join("scene.toml"), SCENE).unwrap();
    for (arguments, wanted) in [
        ("verify 3..=9 --shard 1/2", "--certificate"),
        ("fuzz --shard 1/2", "--output"),
        ("verify 3..=9 --shard 0/2 --certificate f", "numbered from 1 to 2"),
        ("verify 3..=9 --shard 2 --certificate f", "is not I/N"),
        ("verify 3..=9 --method interval --shard 1/2 --certificate f", "exact"),
        ("fuzz --n 1..=3 --cases 1e19 --shard 1/2 -o f", "too many"),
        ("fuzz --n 1..=2 --shard 1/2 -o f", "largest period"),
        ("verify 3..=9 --shard 3/2 --certificate f", "numbered from 1 to 2"),
        ("intervals 3..=9 --shard 1/2", "--output"),
        ("intervals --pattern 3,5 --shard 1/2 -o f", "--pattern"),
        ("boundary 3..=9 --shard 1/2", "--output"),
        ("boundary 3..=9 --format latex --cite c --shard 1/2 -o f", "--cite"),
        ("run scene.toml --only basins --shard 1/2", "--output"),
        ("run scene.toml --only basins --shard 1/2 -o .", "this is a folder"),
        ("run scene.toml --only motion --shard 1/2 -o f", "of kind simulate, which has no parts"),
        ("run scene.toml --shard 1/2 -o f", "--shard needs one task"),
        ("merge", "FILE"),
    ] {
        let (code, _, error) = run(folder.path(), arguments);
        assert!(code == 2 && error.contains(wanted), "{arguments}: {code} {error}");
    }
    done(folder.path(), "verify 3..=9 --shard 1/1 --certificate f");
    let (code, _, error) = run(folder.path(), "merge f -o f");
    assert!(code == 2 && error.contains("-o"), "{error}");
    let (code, _, error) = run(folder.path(), "merge f");
    assert!(code == 2 && error.contains("name its file with -o"), "{error}");
}
