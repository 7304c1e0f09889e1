//! Shards: put together they are what one run writes; whatever is wrong with one is said.

use std::{
    fs,
    path::Path,
    process::{Command, Output},
};

use serde_json::Value;
use tempfile::{TempDir, tempdir};

fn run(folder: &Path, arguments: &str) -> (i32, String, String) {
    let Output { status, stdout, stderr } = Command::new(env!("CARGO_BIN_EXE_grazing"))
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .output()
        .unwrap();
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
    text.bytes()
        .fold(0xcbf2_9ce4_8422_2325u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3))
}

/// A shard with its last line: the number of items and a hash of all before it.
fn sealed(body: &str) -> String {
    let hash = hash(body);
    let records = body.lines().filter(|line| line.starts_with("item ")).count();
    format!("{body}end {records} {hash:016x}\n")
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

#[test]
fn what_is_wrong_with_shards_is_said() {
    let folder = tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let files = shards(&folder, "verify 3..=20", "--certificate", 6);
    let merge = |files: &str, code: i32| -> String {
        let (found, _, error) = run(folder.path(), &format!("merge {files} -o merged"));
        assert_eq!(found, code, "{files}: {error}");
        assert!(code == 1 || !path("merged").exists(), "nothing is written");
        error
    };
    assert!(merge("1 4 6", 2).contains("3 of 6 shards are missing: --array=2-3,5"));
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
    let foreign = body(&good).replace(&format!("program {}", env!("CARGO_PKG_VERSION")), "program 0.0.0");
    fs::write(path("5"), sealed(&foreign)).unwrap();
    assert!(merge(&files, 2).contains("5: its first lines are not those of a shard"), "another hash");
    let task = |program: &str| format!("task {:016x}", hash(&format!("{program} verify 3..=20")));
    let foreign = foreign.replace(&task(env!("CARGO_PKG_VERSION")), &task("0.0.0"));
    fs::write(path("5"), sealed(&foreign)).unwrap();
    assert!(merge(&files, 2).contains("5: it is by version 0.0.0, the others are by"));
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
    // A false line with a right checksum: the certificate is proved again, and is not.
    fs::write(path("5"), sealed(&body(&good).replacen(" + -", " - -", 1))).unwrap();
    let (code, out, _) = run(folder.path(), &format!("merge {files} -o merged"));
    assert!(code == 1 && out.contains("merged: rejected: line "), "{code} {out}");
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
    let program = env!("CARGO_PKG_VERSION");
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
    for (arguments, wanted) in [
        ("verify 3..=9 --shard 1/2", "--certificate"),
        ("fuzz --shard 1/2", "--output"),
        ("verify 3..=9 --shard 0/2 --certificate f", "numbered from 1 to 2"),
        ("verify 3..=9 --shard 2 --certificate f", "is not I/N"),
        ("verify 3..=9 --method interval --shard 1/2 --certificate f", "exact"),
        ("fuzz --n 1..=3 --cases 1e19 --shard 1/2 -o f", "too many"),
        ("fuzz --n 1..=2 --shard 1/2 -o f", "largest period"),
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
