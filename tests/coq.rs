//! The Coq development under `proofs/coq` builds, rests on the pinned axioms alone, and
//! computes the same u_n, b_{n,k}, c_n at rational points as exact arithmetic does here.
//!
//! Without `coqc` on the PATH nothing is checked and stderr says so; with
//! `GRAZING_REQUIRE_COQ=1` that is a failure.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Write;
use std::path::Path;
use std::process::Command;
use std::{env, fs};

use num_rational::BigRational;
use num_traits::{One, Pow, Zero};

#[test]
fn coq_development_builds_and_agrees() {
    let sources = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/coq");
    let build = Path::new(env!("CARGO_TARGET_TMPDIR")).join("coq");
    let Ok(version) = Command::new("coqc").arg("--version").output() else {
        let required = env::var("GRAZING_REQUIRE_COQ").is_ok_and(|v| v == "1");
        assert!(
            !required,
            "GRAZING_REQUIRE_COQ=1 but there is no coqc on the PATH"
        );
        // Not eprintln!, which the test harness would swallow.
        let notice =
            "\n*** COQ PROOFS NOT CHECKED: no coqc on the PATH (Debian: apt install coq) ***\n";
        std::io::stderr().write_all(notice.as_bytes()).unwrap();
        return;
    };
    let project = fs::read_to_string(sources.join("_CoqProject")).unwrap();
    let files: Vec<(&str, String)> = project
        .lines()
        .filter(|line| line.ends_with(".v"))
        .map(|file| (file, fs::read_to_string(sources.join(file)).unwrap()))
        .collect();
    for (file, text) in &files {
        let hole = ["Admitted.", "admit.", "Axiom ", "Parameter "]
            .iter()
            .find(|&&w| text.contains(w));
        assert_eq!(hole, None, "{file} leaves something open");
    }
    compile(&build, &files, &version.stdout);

    let mut found = String::new();
    for (file, text) in &files {
        found += &assumptions(
            text,
            &fs::read_to_string(build.join(format!("{file}.out"))).unwrap(),
        );
    }
    let pinned = fs::read_to_string(sources.join("assumptions.txt")).unwrap();
    assert_eq!(
        found, pinned,
        "assumptions differ from proofs/coq/assumptions.txt"
    );

    compare(&fs::read_to_string(build.join("ComputeQ.v.out")).unwrap());
}

/// Compiles `files` in order in `build`, keeping what each prints, unless that was done
/// before with the same sources and the same Coq.
fn compile(build: &Path, files: &[(&str, String)], version: &[u8]) {
    let mut hasher = DefaultHasher::new();
    (files, version).hash(&mut hasher);
    let digest = hasher.finish().to_string();
    let stamp = build.join("stamp");
    if fs::read_to_string(&stamp).is_ok_and(|last| last == digest) {
        return;
    }
    fs::create_dir_all(build).unwrap();
    let _ = fs::remove_file(&stamp);
    for (file, text) in files {
        fs::write(build.join(file), text).unwrap();
        let coqc = ["-q", "-Q", ".", "Grazing", file];
        let run = Command::new("coqc")
            .args(coqc)
            .current_dir(build)
            .output()
            .unwrap();
        let errors = String::from_utf8_lossy(&run.stderr);
        assert!(run.status.success(), "coqc {file} failed:\n{errors}");
        fs::write(build.join(format!("{file}.out")), run.stdout).unwrap();
    }
    fs::write(stamp, digest).unwrap();
}

/// One line "theorem: axioms" for each `Print Assumptions` of a file, from what it printed.
fn assumptions(source: &str, printed: &str) -> String {
    let mut theorems = source
        .lines()
        .filter_map(|line| line.strip_prefix("Print Assumptions ")?.strip_suffix('.'));
    let mut lines = String::new();
    for line in printed.lines() {
        if line == "Axioms:" || line == "Closed under the global context" {
            let name = theorems.next().expect("a list of axioms for each theorem");
            lines += &format!("\n{name}:");
        } else if !line.starts_with(' ') && !lines.is_empty() {
            lines += &format!(" {}", line.split(' ').next().unwrap());
        }
    }
    assert_eq!(theorems.next(), None, "a list of axioms for each theorem");
    lines.split_inclusive('\n').skip(1).collect::<String>()
        + if lines.is_empty() { "" } else { "\n" }
}

/// Compares the rows a1, a2, n, k, u_n, b_{n,k}, c_n that Coq printed with (59) and (60).
fn compare(printed: &str) {
    let integers: Vec<i128> = printed
        .split(|c: char| !c.is_ascii_digit() && c != '-')
        .filter(|word| !word.is_empty())
        .map(|word| word.parse().unwrap())
        .collect();
    assert!(
        integers.len() >= 12 && integers.len() % 12 == 0,
        "rows of twelve integers"
    );
    for row in integers.chunks(12) {
        let q = |i: usize| BigRational::new(row[i].into(), row[i + 1].into());
        let (a1, a2, n, k) = (q(0), q(2), row[4] as usize, row[5] as usize);
        let mut u = vec![BigRational::zero(), BigRational::one()];
        for j in 1..=n {
            u.push(&a1 * &u[j] - &a2 * &u[j - 1]);
        }
        let two_u = &u[n + 1] + &u[n + 1];
        let b = (&u[n] - &u[k] - Pow::pow(&a2, k) * &u[n - k]) / &u[n];
        let c = (two_u - &a1 * &u[n] - BigRational::one() - Pow::pow(&a2, n)) / &u[n];
        assert_eq!((q(6), q(8), q(10)), (u[n].clone(), b, c), "row {row:?}");
    }
}
