//! Damaged text of every kind that is read: scenes, maps, numbers, certificates and saved states. Whatever
//! comes in, what comes out is a value or an error in words: no panic, no wrapped arithmetic (tests are built
//! with overflow checks), no work without a bound.
//!
//! `GRAZING_SAMPLES=125 cargo test -p grazing-shell --test shell parsers:: -- --nocapture` runs as
//! many of each kind as it says and prints how each went.

use crate::samples::samples;
use std::{env, fs, path::Path};

use grazing_scenes::{
    Error, Monitor, Result,
    attractor::{
        basins::{BasinGrid, basins},
        detection::Detection,
        diagram::{self, DiagramPlan, Look},
    },
    certificate,
    motion::{State, System},
    number::{parse_integer, parse_rational},
    one::simulate::{Settings, Simulator},
    pattern::Map,
    scene::Scene,
};

/// SplitMix64: the same damage on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, bound: usize) -> usize {
        (self.next() % bound.max(1) as u64) as usize
    }

    fn one<'a, T: ?Sized>(&mut self, list: &[&'a T]) -> &'a T {
        list[self.below(list.len())]
    }
}

/// What is put in the place of a number, or anywhere.
const PIECES: &[&str] = &[
    "0",
    "-0",
    "1",
    "-1",
    "2",
    "1/0",
    "0/1",
    "1/2",
    "1e400",
    "1e-400",
    "1e99999999999999999999",
    "2^100000",
    "2^-100000",
    "2^2^9",
    "9223372036854775807",
    "9223372036854775808",
    "18446744073709551615",
    "340282366920938463463374607431768211456",
    "0.000000000000000000000000000000000000000000001",
    "nan",
    "inf",
    "-",
    "+",
    ".",
    "/",
    "^",
    "((((((((",
    "))))",
    "[",
    "]",
    "{}",
    "\"",
    "\\",
    "\0",
    "\r\n",
    "\t",
    " ",
    "é",
    "\u{2212}1",
    "=",
    ",",
    "a",
    "pi",
    "mu",
    "a^64",
    "1/3^40000",
    "1e9",
    "1e18",
    "4294967296",
];

/// The text with one to four places damaged.
fn damaged(text: &str, random: &mut Random) -> String {
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..1 + random.below(4) {
        let at = random.below(bytes.len() + 1);
        match random.below(8) {
            // A byte turned, taken out, or a piece put in.
            0 if at < bytes.len() => bytes[at] ^= 1 << random.below(7),
            1 if at < bytes.len() => drop(bytes.remove(at)),
            2 => drop(bytes.splice(at..at, random.one(PIECES).bytes())),
            // A number exchanged for a piece.
            3 | 4 => {
                let number = |byte: u8| byte.is_ascii_digit() || byte == b'.' || byte == b'/';
                if let Some(start) = (at..bytes.len()).find(|&i| number(bytes[i])) {
                    let end = (start..bytes.len()).find(|&i| !number(bytes[i])).unwrap_or(bytes.len());
                    drop(bytes.splice(start..end, random.one(PIECES).bytes()));
                }
            }
            // A line taken out, doubled, or moved to another place.
            5..=7 => {
                let mut lines: Vec<Vec<u8>> =
                    bytes.split_inclusive(|&b| b == b'\n').map(<[u8]>::to_vec).collect();
                if !lines.is_empty() {
                    let line = random.below(lines.len());
                    let copy = lines[line].clone();
                    match random.below(3) {
                        0 => drop(lines.remove(line)),
                        1 => lines.insert(line, copy),
                        _ => lines.insert(random.below(lines.len()), copy),
                    }
                    bytes = lines.concat();
                }
            }
            _ => {}
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

fn runs() -> usize {
    samples(400)
}

fn files(folder: &str) -> Vec<String> {
    let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join(folder);
    let mut paths: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths.iter().map(|path| fs::read_to_string(path).unwrap()).collect()
}

/// Feeds damaged texts to a reader, which says whether it took one; both must happen, or the damage is too
/// little or too much.
fn feed(what: &str, texts: &[String], read: impl Fn(&str) -> std::result::Result<(), String>) {
    for text in texts {
        read(text).unwrap_or_else(|error| panic!("{what}: the undamaged text: {error}"));
    }
    let (mut taken, mut refused) = (0, 0);
    for run in 0..runs() {
        let mut random = Random(run as u64);
        let text = damaged(&texts[random.below(texts.len())], &mut random);
        match read(&text) {
            Ok(()) => taken += 1,
            Err(error) => {
                assert!(!error.trim().is_empty(), "{what} {run}: an error without words");
                refused += 1;
            }
        }
    }
    println!("{what}: {} damaged, {taken} still readable, {refused} refused", taken + refused);
    assert!(taken > 0 && refused > 0, "{what}: {taken} taken, {refused} refused");
}

#[test]
fn damaged_scenes_are_read_or_refused() {
    feed("scenes", &files("examples/scenes"), |text| {
        let scene = Scene::from_toml(text, "scene").map_err(|error| error.to_string())?;
        for task in &scene.tasks {
            let scene = scene.for_task(task, &[]).map_err(|error| error.to_string())?;
            scene.exact(&[]).map_err(|error| error.to_string())?.rounded();
        }
        Ok(())
    });
}

#[test]
fn damaged_maps_are_read_or_refused() {
    feed("maps", &files("examples/maps"), |text| {
        Map::from_toml(text, "map").map(drop).map_err(|error| error.to_string())
    });
}

#[test]
fn damaged_numbers_are_read_or_refused() {
    let texts = ["3/8", "0.375", "1e-30", "2^-10", "3/8+2^-200", "-1/3-1e5+7", "12345678901234567890/7"]
        .map(String::from);
    feed("numbers", &texts, |text| {
        let _ = parse_integer::<u64>(text);
        parse_rational(text).map(drop).map_err(|error| error.to_string())
    });
}

#[test]
fn damaged_certificates_are_proved_or_rejected() {
    let binary = crate::PROGRAM;
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, arguments: &[&str]| {
        let file = folder.path().join(name);
        let mut all = arguments.to_vec();
        all.extend(["--certificate", file.to_str().unwrap()]);
        assert!(std::process::Command::new(binary).args(&all).output().unwrap().status.success());
        fs::read_to_string(file).unwrap()
    };
    let scene =
        Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("examples/scenes/nordmark-2001.toml");
    let orbit = ["run", scene.to_str().unwrap(), "--only", "proofs", "-o", folder.path().to_str().unwrap()];
    std::process::Command::new(binary).args(orbit).output().unwrap();
    let mut texts = vec![write("t", &["verify", "1..=9"]), write("c", &["cover", "3..=4"])];
    for name in ["period-4-1", "proved-mu_sn-1", "proved-mu_gr4-1"] {
        let path = folder.path().join(format!("{name}.certificate"));
        texts.push(fs::read_to_string(path).unwrap_or_else(|error| panic!("{name}: {error}")));
    }
    texts.push(include_str!("../../crates/checker/tests/data/machine-masses.txt").into());
    for kind in [&[][..], &["--by-theorem"]] {
        for point in [
            ["--a1", "-1/4", "--a2", "1/2"],
            ["--r", "9/10", "--s", "37/100"],
            ["--a1", "-0.26..=-0.25", "--a2", "0.5..=0.51"],
        ] {
            texts.push(write("w", &[&["word"], &point[..], kind].concat()));
        }
    }
    feed("certificates", &texts, |text| {
        certificate::check(&mut text.as_bytes()).map(drop).map_err(|rejection| rejection.to_string())
    });
}

/// Ends a job at the first thing that it would compute.
struct AtOnce;

impl Monitor for AtOnce {
    fn advance(&self, units: u64) -> Result<()> {
        if units == 0 { Err(Error::interrupted("enough")) } else { Ok(()) }
    }
}

/// A job whose checkpoint is read, then continued with this wish to go on.
type Job<'a> = &'a dyn Fn(&Path, &dyn Monitor) -> Result<()>;

/// The checkpoint of a job that is done, damaged as text, and damaged with its checksums made right again.
fn feed_checkpoints(what: &str, job: Job) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("checkpoint");
    job(&file, &()).unwrap();
    let whole = fs::read_to_string(&file).unwrap();
    let read = |text: &str| {
        fs::write(&file, text).unwrap();
        match job(&file, &AtOnce) {
            Err(error) if !error.is_interrupted() => Err(error.to_string()),
            _ => Ok(()),
        }
    };
    feed(&format!("checkpoints of {what}"), std::slice::from_ref(&whole), read);
    let (header, records) = whole.split_once('\n').unwrap();
    let records: String = records.lines().map(|line| format!("{}\n", &line[17..])).collect();
    feed(&format!("records of {what}"), &[records], |records| {
        read(&sealed([&header[17..]].into_iter().chain(records.split('\n').filter(|line| !line.is_empty()))))
    });
}

/// Lines with the checksums of a saved state: FNV-1a of the checksum before, least byte first, and of the
/// line.
fn sealed<'a>(lines: impl Iterator<Item = &'a str>) -> String {
    let mut before = 0u64;
    let line = |line: &str| {
        let bytes = before.to_le_bytes().into_iter().chain(line.bytes());
        before = bytes.fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
        });
        format!("{before:016x} {line}\n")
    };
    lines.map(line).collect()
}

/// Wells at q = −1 and 1, or at ±√(−k).
fn wells(stiffness: f64) -> Result<Simulator> {
    let system = System { damping: 0.5, stiffness, cubic: 1.0, ..System::default() };
    Simulator::new(&system, &Settings::default())
}

#[test]
fn damaged_checkpoints_are_read_or_refused() {
    let start = |q| State { t: 0.0, q, u: 0.0 };
    let plan = DiagramPlan {
        values: (0..6).map(|i| -1.0 + 0.01 * f64::from(i)).collect(),
        starts: vec![start(1.1), start(-1.1)],
        look: Look { phase: 0.0, transient: 2, points: 3, longest: 2 },
        every: 1,
    };
    feed_checkpoints("diagrams", &|file, monitor| {
        let simulator = |value| monitor.advance(0).and_then(|()| wells(value));
        diagram::sweep(&plan, simulator, "", Some(file), monitor).map(drop)
    });
    let grid = BasinGrid { q: [-1.3, 1.3], u: [0.0, 0.1], columns: 6, rows: 2 };
    let detection = Detection { transient: 20, longest: 2, ..Detection::default() };
    let simulator = wells(-1.0).unwrap();
    feed_checkpoints("basins", &|file, monitor| {
        basins(&simulator, &grid, &detection, "", Some(file), monitor).map(drop)
    });
}
