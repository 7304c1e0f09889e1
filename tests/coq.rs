//! The Coq development under `proofs/coq` builds, rests on the pinned axioms alone
//! (`check.sh`), and computes the same u_n, b_{n,k}, c_n at rational points as exact
//! arithmetic does here.
//!
//! Without `coqc` on the PATH nothing is checked and stderr says so; with
//! `GRAZING_REQUIRE_COQ=1` that is a failure.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Write;
use std::path::Path;
use std::process::Command;
use std::{env, fs};

use grazing::existence::{Case, by_definition};
use grazing::local::{Ladder, Plane, Point};
use num_rational::BigRational;
use num_traits::{One, Pow, Zero};

#[test]
fn coq_development_builds_and_agrees() {
    let Ok(version) = Command::new("coqc").arg("--version").output() else {
        let required = env::var("GRAZING_REQUIRE_COQ").is_ok_and(|v| v == "1");
        assert!(!required, "GRAZING_REQUIRE_COQ=1 but there is no coqc on the PATH");
        // Not eprintln!, which the test harness would swallow.
        let notice = "\n*** COQ PROOFS NOT CHECKED: no coqc on the PATH (Debian: apt install coq) ***\n";
        std::io::stderr().write_all(notice.as_bytes()).unwrap();
        return;
    };
    let build = Path::new(env!("CARGO_TARGET_TMPDIR")).join("coq");
    fs::create_dir_all(&build).unwrap();
    let sources = sources();
    let mut hasher = DefaultHasher::new();
    (&sources, version.stdout).hash(&mut hasher);
    let digest = hasher.finish().to_string();
    let (stamp, values) = (build.join("stamp"), build.join("values"));
    if fs::read_to_string(&stamp).ok() != Some(digest.clone()) {
        for (name, text) in &sources {
            // Unchanged files keep their time, so that make compiles only what it must.
            if fs::read_to_string(build.join(name)).ok().as_ref() != Some(text) {
                fs::write(build.join(name), text).unwrap();
            }
        }
        run(&build, "sh", &["check.sh"]);
        let printed = run(&build, "coqc", &["-Q", ".", "Grazing", "ComputeQ.v"]);
        fs::write(&values, printed).unwrap();
        fs::write(&stamp, digest).unwrap();
    }
    compare(&fs::read_to_string(values).unwrap());
}

/// The files under `proofs/coq` that the build reads, by name.
fn sources() -> BTreeMap<String, String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/coq");
    let names = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name());
    names
        .filter_map(|name| name.into_string().ok())
        .filter(|name| {
            let extension = Path::new(name).extension().and_then(|e| e.to_str());
            name == "_CoqProject" || matches!(extension, Some("v" | "sh" | "txt"))
        })
        .map(|name| (name.clone(), fs::read_to_string(folder.join(name)).unwrap()))
        .collect()
}

/// What the command prints on stdout; panics with all it prints when it fails.
fn run(folder: &Path, program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).current_dir(folder).output().unwrap();
    let (stdout, stderr) = (output.stdout, String::from_utf8_lossy(&output.stderr));
    let stdout = String::from_utf8_lossy(&stdout).into_owned();
    assert!(output.status.success(), "{program} {arguments:?} failed:\n{stdout}{stderr}");
    stdout
}

/// Compares what Coq printed with exact arithmetic, (59) and (60), and with the crate.
fn compare(printed: &str) {
    let lists: Vec<Vec<i128>> = printed.split(": list Z").map(integers).collect();
    assert_eq!(lists.iter().map(|list| list.is_empty()).collect::<Vec<_>>(), [false, false, true]);
    for row in lists[0].chunks(12) {
        let (a1, a2, n, k) = (fraction(&row[0..2]), fraction(&row[2..4]), row[4] as usize, row[5] as usize);
        let mut u = vec![BigRational::zero(), BigRational::one()];
        for j in 1..=n {
            u.push(&a1 * &u[j] - &a2 * &u[j - 1]);
        }
        let two_u = &u[n + 1] + &u[n + 1];
        let b = (&u[n] - &u[k] - Pow::pow(&a2, k) * &u[n - k]) / &u[n];
        let c = (two_u - &a1 * &u[n] - BigRational::one() - Pow::pow(&a2, n)) / &u[n];
        let found = [fraction(&row[6..8]), fraction(&row[8..10]), fraction(&row[10..12])];
        assert_eq!(found, [u[n].clone(), b, c], "row {row:?}");
    }
    let ladder = Ladder::default();
    for row in lists[1].chunks(9) {
        let point = Point::Plane(Plane::new(fraction(&row[0..2]), fraction(&row[2..4])).unwrap());
        let cases = by_definition(&ladder, &point, row[4] as u64).cases(row[4] as u64);
        let order = [Case::PlusPlus, Case::PlusMinus, Case::MinusPlus, Case::MinusMinus];
        assert_eq!(order.map(|case| i128::from(cases.contains(&case))), row[5..], "row {row:?}");
    }
}

/// The integers in a text, in order.
fn integers(text: &str) -> Vec<i128> {
    text.split(|c: char| !c.is_ascii_digit() && c != '-')
        .filter(|word| !word.is_empty())
        .map(|word| word.parse().unwrap())
        .collect()
}

/// A numerator and a denominator.
fn fraction(pair: &[i128]) -> BigRational {
    BigRational::new(pair[0].into(), pair[1].into())
}
