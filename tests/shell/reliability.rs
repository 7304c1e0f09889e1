//! Kills and damage: whatever ends a run, and whatever becomes of its saved state, the result is that of the
//! undisturbed run, or an error. With GRAZING_SAMPLES=N each kind of job is killed 4N times and its states
//! are damaged 2 N times; by default a few times.
//!
//!     GRAZING_SAMPLES=88 cargo test -p grazing-shell --test shell reliability:: -- --nocapture
use crate::process;
use crate::samples::samples;

use std::{
    collections::BTreeMap,
    fs,
    path::Path,
    process::Stdio,
    thread,
    time::{Duration, Instant},
};

use process::{ended, grazing, names};
use tempfile::tempdir;

/// What can be ended and gone on with.
struct Job {
    name: &'static str,
    /// A longer run, to be killed, and a shorter one, whose states are damaged.
    long: &'static str,
    short: &'static str,
    /// The state file.
    state: &'static str,
    /// What it is to come to: of standard output, or of a file.
    result: fn(&str, &Path) -> String,
}

const JOBS: [Job; 3] = [
    Job {
        name: "fuzz",
        long: "fuzz --n 1..=24 --seed 5 --cases 3e5 --format json --resume state",
        short: "fuzz --n 1..=8 --seed 5 --cases 20000 --format json --resume state",
        state: "state",
        result: |out, _| {
            let mut report: serde_json::Value = serde_json::from_str(out).unwrap();
            report["tally"].as_object_mut().unwrap().retain(|key, _| !key.ends_with("seconds"));
            report.to_string()
        },
    },
    Job {
        name: "cover",
        long: "cover 12..=18 --resume state --certificate result",
        short: "cover 8..=10 --resume state --certificate result",
        state: "state",
        result: |_, folder| fs::read_to_string(folder.join("result")).unwrap(),
    },
    Job {
        name: "diagram",
        long: "run scene.toml --only long",
        short: "run scene.toml --only short",
        state: "",
        result: |_, folder| {
            let files = ["long.csv", "short.csv"].map(|name| fs::read_to_string(folder.join(name)).ok());
            files.into_iter().flatten().collect()
        },
    },
];

const SCENE: &str = r#"
format = "grazing-scene 1"
title = "A ball on a moving table"
[parameters]
a = 0.45
[system]
force = "-1"
[[walls]]
side = "lower"
offset = 0
harmonics = [{ k = 1, sin = "a" }]
restitution = 0.5
[[tasks]]
name = "long"
kind = "diagram"
parameter = "a"
range = [1.0, 3.0]
count = 256
starts = [{ q = 3 }]
transient = 5
points = 6
longest = 2
[[tasks]]
name = "short"
kind = "diagram"
parameter = "a"
range = [1.0, 2.0]
count = 12
starts = [{ q = 3 }]
transient = 5
points = 6
longest = 2
"#;

/// Random numbers that are the same in every run (a multiplicative congruential generator).
struct Numbers(u128);

impl Numbers {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(0xda94_2042_e4dd_58b5);
        ((self.0 >> 64) as u64 % bound as u64) as usize
    }
}

fn trials() -> usize {
    samples(4)
}

/// The state file of a job, if there is one.
fn state(job: &Job, folder: &Path) -> Option<String> {
    let name = |name: &String| name == job.state || name.contains("checkpoint") && !name.starts_with('.');
    names(folder).into_iter().find(name)
}

/// Whether the exit code is that of a whole run: of the diagram some motions are not settled.
fn is_done(code: i32, job: &Job) -> bool {
    code == if job.name == "diagram" { 3 } else { 0 }
}

fn whole(job: &Job, arguments: &str) -> String {
    let folder = tempdir().unwrap();
    fs::write(folder.path().join("scene.toml"), SCENE).unwrap();
    let (code, out, said) = ended(grazing(arguments, folder.path()).output().unwrap());
    assert!(is_done(code, job), "{}: {said}", job.name);
    (job.result)(&out, folder.path())
}

/// Budgets: what is too large is refused before much memory is taken, and what is large but allowed takes
/// little. The limit is on addresses, of which a process takes several times the memory that it uses.
#[test]
fn what_is_too_much_is_refused_before_it_is_in_memory() {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    let limited = |megabytes: u64, arguments: &str| {
        let program = crate::PROGRAM;
        let line = format!("ulimit -v {}; exec {program} {arguments}", megabytes << 10);
        let mut command = std::process::Command::new("sh");
        let output = command.arg("-c").arg(line).current_dir(folder).output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        (output.status.code(), String::from_utf8(output.stdout).unwrap(), said)
    };
    let head = "format = \"grazing-scene 1\"\ntitle = \"t\"\n";
    let task = |i: usize| {
        format!(
            "[[tasks]]\nname = \"t{i}\"\nkind = \"simulate\"\nstart = {{ q = 1 }}\nperiods = 1 # {}\n",
            "x".repeat(900)
        )
    };
    let wall = "[system]\nforce = -1\n[[walls]]\nside = \"lower\"\noffset = 0\nrestitution = 0.5\n";
    let tasks = |count| (0..count).map(task).collect::<String>();
    for (name, text, wanted) in [
        ("brackets.toml", format!("{head}x = [{}]\n", "[],".repeat(1_000_000)), "at most 200000"),
        ("long.toml", format!("{head}{}", "# \n".repeat(3_000_000)), "has more than 4194304 bytes"),
        (
            "names.toml",
            format!(
                "{head}[parameters]\n{}{wall}",
                (0..1001).map(|i| format!("p{i} = 1\n")).collect::<String>()
            ),
            "1001 of them: at most 1000",
        ),
        ("tasks.toml", format!("{head}{wall}{}", tasks(2000)), ""),
    ] {
        fs::write(folder.join(name), text).unwrap();
        let (code, out, said) = limited(500, &format!("run {name} --dry-run"));
        let files = if wanted.is_empty() { 1 + 4 * 2000 } else { 0 };
        assert_eq!(
            (code, out.lines().count()),
            (Some(if files > 0 { 0 } else { 2 }), files),
            "{name}: {said}"
        );
        assert!(said.contains(wanted), "{name}: {said}");
    }
    fs::write(folder.join("map.toml"), format!("x = [{}]\n", "[],".repeat(1_000_000))).unwrap();
    let (code, _, said) = limited(500, "existence map.toml");
    assert!(code == Some(2) && said.contains("at most 200000"), "{said}");
    let (code, _, said) = limited(500, "merge --files-from /dev/zero");
    assert!(
        code == Some(2) && said.contains("--files-from /dev/zero has more than 67108864 bytes"),
        "{said}"
    );
    for variable in ["RAYON_NUM_THREADS", "RAYON_RS_NUM_CPUS"] {
        for arguments in ["verify 8", "existence map.toml", "figure intervals"] {
            let mut command = grazing(arguments, folder);
            let (code, _, said) = ended(command.env(variable, "100000").output().unwrap());
            assert!(code == 2 && said.contains(&format!("{variable} 100000: at most ")), "{said}");
        }
    }
}

#[test]
fn kills_change_no_result() {
    let mut numbers = Numbers(0x1234_5678_9abc_def1);
    for job in &JOBS {
        let start = Instant::now();
        let wanted = whole(job, job.long);
        let time = start.elapsed();
        let (mut kills, mut resumed, mut runs, mut left) = (0, 0, 0, 0);
        while kills < trials() {
            let folder = tempdir().unwrap();
            let folder = folder.path();
            fs::write(folder.join("scene.toml"), SCENE).unwrap();
            for _ in 0..1 + numbers.below(6) {
                let mut child =
                    grazing(job.long, folder).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
                thread::sleep(time.mul_f64(numbers.below(1000) as f64 / 1500.0) + Duration::from_millis(2));
                child.kill().unwrap();
                // It may have been done before.
                kills += usize::from(child.wait().unwrap().code().is_none());
                resumed += usize::from(state(job, folder).is_some());
            }
            left += names(folder).iter().filter(|name| name.starts_with(".grazing-")).count();
            let (code, out, said) = ended(grazing(job.long, folder).output().unwrap());
            assert!(is_done(code, job), "{}: {said}", job.name);
            assert!((job.result)(&out, folder) == wanted, "{}: another result after a kill", job.name);
            assert!(!names(folder).iter().any(|name| name.starts_with('.')), "{:?}", names(folder));
            runs += 1;
        }
        println!(
            "{}: {kills} kills in {runs} runs, {resumed} times with a state to go on from, {left} temporary files left and removed: 0 wrong results",
            job.name
        );
    }
}

/// A damaged text, and what was done to it.
fn damaged(text: &[u8], other: &[u8], numbers: &mut Numbers) -> (&'static str, Vec<u8>) {
    let mut new = text.to_vec();
    let at = numbers.below(text.len());
    let lines: Vec<&[u8]> = text.split_inclusive(|&byte| byte == b'\n').collect();
    let (i, j) = (numbers.below(lines.len()), numbers.below(lines.len()));
    let kinds = [
        "bit flipped",
        "byte changed",
        "cut",
        "byte lost",
        "byte added",
        "zeros",
        "digit changed",
        "lines exchanged",
        "line lost",
        "line doubled",
        "end of another",
        "line of another",
    ];
    let kind = kinds[numbers.below(kinds.len())];
    let join = |lines: &[&[u8]]| lines.concat();
    match kind {
        "bit flipped" => new[at] ^= 1 << numbers.below(8),
        "byte changed" => new[at] = numbers.below(256) as u8,
        "cut" => new.truncate(at),
        "byte lost" => drop(new.remove(at)),
        "byte added" => new.insert(at, numbers.below(256) as u8),
        "zeros" => {
            let end = (at + 1 + numbers.below(64)).min(new.len());
            new[at..end].fill(0);
        }
        "digit changed" => {
            let digits: Vec<usize> = (0..new.len()).filter(|&i| new[i].is_ascii_digit()).collect();
            new[digits[numbers.below(digits.len())]] = b'0' + numbers.below(10) as u8;
        }
        "lines exchanged" => {
            let mut all = lines.clone();
            all.swap(i, j);
            new = join(&all);
        }
        "line lost" => {
            let mut all = lines.clone();
            all.remove(i);
            new = join(&all);
        }
        "line doubled" => {
            let mut all = lines.clone();
            all.insert(j, lines[i]);
            new = join(&all);
        }
        "end of another" => {
            new.truncate(at);
            new.extend(other.get(at..).unwrap_or_default());
        }
        _ => {
            let mut all = lines.clone();
            let others: Vec<&[u8]> = other.split_inclusive(|&byte| byte == b'\n').collect();
            all[i] = others[j % others.len()];
            new = join(&all);
        }
    }
    (kind, new)
}

/// A state with a right checksum at every line: only what its records say can be wrong.
fn sealed(records: &[String]) -> String {
    let fnv = |hash: u64, bytes: &[u8]| {
        bytes.iter().fold(hash, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3))
    };
    let mut before = 0u64;
    let line = |record: &String| {
        before = fnv(fnv(0xcbf2_9ce4_8422_2325, &before.to_le_bytes()), record.as_bytes());
        format!("{before:016x} {record}\n")
    };
    records.iter().map(line).collect()
}

/// The records of a state.
fn records(text: &[u8]) -> Vec<String> {
    String::from_utf8(text.to_vec()).unwrap().lines().map(|line| line[17..].to_string()).collect()
}

/// A state of a job that has come a part of the way, and one of another run, with other records.
fn partial(job: &Job) -> (Vec<u8>, Vec<u8>) {
    let folder = tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("scene.toml"), SCENE).unwrap();
    let text = match job.name {
        "fuzz" => {
            assert!(grazing(&job.short.replace("20000", "9000"), folder).output().unwrap().status.success());
            fs::read(folder.join(job.state)).unwrap()
        }
        "cover" => {
            assert!(grazing(job.short, folder).output().unwrap().status.success());
            let text = fs::read_to_string(folder.join(job.state)).unwrap();
            let lines: Vec<&str> = text.split_inclusive('\n').collect();
            lines[..lines.len() * 2 / 3].concat().into_bytes()
        }
        // Ended while it runs: the longer one has had time to begin.
        _ => loop {
            let mut child = grazing(job.short, folder).stdout(Stdio::null()).spawn().unwrap();
            while child.try_wait().unwrap().is_none() {
                let found = state(job, folder).and_then(|name| fs::read(folder.join(name)).ok());
                if found.is_some_and(|text| text.iter().filter(|&&byte| byte == b'\n').count() > 1) {
                    break;
                }
            }
            child.kill().unwrap();
            child.wait().unwrap();
            let found = state(job, folder).and_then(|name| fs::read(folder.join(name)).ok());
            if let Some(text) = found.filter(|text| records(text).len() > 1) {
                break text;
            }
        },
    };
    let mut all = records(&text);
    let last = all.len() - 1;
    all[0].push('0');
    all[last] = all[last].replace('1', "2");
    (text, sealed(&all).into_bytes())
}

#[test]
fn damaged_states_give_no_wrong_result() {
    let mut numbers = Numbers(0xfedc_ba98_7654_3211);
    for job in &JOBS {
        let wanted = whole(job, job.short);
        let (good, other) = partial(job);
        assert_eq!(good, sealed(&records(&good)).into_bytes(), "{}: the format of docs/formats.md", job.name);
        let mut answers: BTreeMap<&str, [usize; 2]> = BTreeMap::new();
        for _ in 0..2 * trials() {
            let (kind, text) = damaged(&good, &other, &mut numbers);
            let folder = tempdir().unwrap();
            let folder = folder.path();
            fs::write(folder.join("scene.toml"), SCENE).unwrap();
            let name = if job.state.is_empty() { "short.checkpoint" } else { job.state };
            fs::write(folder.join(name), &text).unwrap();
            let (code, out, said) = ended(grazing(job.short, folder).output().unwrap());
            let show = || format!("{}, {kind}: {said}\n{}", job.name, String::from_utf8_lossy(&text));
            match code {
                _ if is_done(code, job) => {
                    assert!((job.result)(&out, folder) == wanted, "a wrong result: {}", show());
                }
                2 => assert!(said.contains("cannot resume from"), "{}", show()),
                _ => panic!("exit code {code}: {}", show()),
            }
            answers.entry(kind).or_default()[usize::from(code == 2)] += 1;
        }
        println!(
            "{}: {} damaged states, 0 wrong results; [right result, refused] {answers:?}",
            job.name,
            2 * trials()
        );
    }
}

/// With right checksums, so that only the values themselves can tell: no endless loop, no sum that wraps, no
/// panic, no refutation.
#[test]
fn false_records_with_right_checksums_are_harmless() {
    let mut numbers = Numbers(0x0f0f_1e1e_2d2d_3c3d);
    let values =
        ["18446744073709551615", "9223372036854775808", "-1", "1e999", "0", "null", "", "\"x\"", "[]"];
    for job in &JOBS {
        let (good, _) = partial(job);
        let mut refused = 0;
        for _ in 0..2 * trials() {
            let mut all = records(&good);
            let i = 1 + numbers.below(all.len() - 1);
            // One number of one record becomes another.
            let bytes = all[i].as_bytes();
            let starts: Vec<usize> = (0..bytes.len())
                .filter(|&k| bytes[k].is_ascii_digit() && (k == 0 || !bytes[k - 1].is_ascii_digit()))
                .collect();
            let from = starts[numbers.below(starts.len())];
            let to = from + bytes[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
            all[i].replace_range(from..to, values[numbers.below(values.len())]);
            let folder = tempdir().unwrap();
            let folder = folder.path();
            fs::write(folder.join("scene.toml"), SCENE).unwrap();
            let name = if job.state.is_empty() { "short.checkpoint" } else { job.state };
            fs::write(folder.join(name), sealed(&all)).unwrap();
            let (code, _, said) = ended(grazing(job.short, folder).output().unwrap());
            assert!(matches!(code, 0 | 2 | 3), "{}: exit code {code}: {said}\n{}", job.name, all[i]);
            refused += usize::from(code == 2);
        }
        println!(
            "{}: {} false records with right checksums, {refused} refused, none loops or panics",
            job.name,
            2 * trials()
        );
    }
}
