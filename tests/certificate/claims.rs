//! What a run's report says is proved is what the checker says of the certificates that it has written: the
//! claims word for word, and each part of a row by the claim that it stands for.

use std::{
    path::{Path, PathBuf},
    process::Command,
};

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};
use serde_json::Value;

use crate::systems::number;

/// README's machine.
const MACHINE: &str = "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\nF = 0.5\nd = 0.1\n[system]\n\
    damping = \"d\"\nstiffness = 0.3\nforcing = [{ cos = \"F\" }]\n[[stops]]\nside = \"upper\"\noffset = 1\n\
    restitution = 0.8\n";

fn json(arguments: &[&str]) -> (Value, i32) {
    let output = Command::new(crate::PROGRAM).args(arguments).output().unwrap();
    let code = output.status.code().unwrap();
    assert!([0, 3].contains(&code), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    (serde_json::from_slice(&output.stdout).unwrap(), code)
}

/// Runs tasks of a scene, and has every certificate checked by the command: the tasks, and for each file what
/// the checker says.
fn run(scene: &Path, only: &[&str], folder: &Path) -> (Vec<Value>, Vec<Value>) {
    let (scene, folder_name) = (scene.to_str().unwrap(), folder.to_str().unwrap());
    let mut arguments = vec!["run", scene, "-o", folder_name, "--format", "json"];
    arguments.extend(only.iter().flat_map(|name| ["--only", name]));
    let (report, _) = json(&arguments);
    let tasks = report["tasks"].as_array().unwrap().clone();
    let mut all = Vec::new();
    for task in &tasks {
        let claims = task["certificates"].as_array().unwrap();
        let files = task["files"].as_array().unwrap().iter().filter_map(Value::as_str);
        let written: Vec<&str> = files.filter(|file| file.ends_with(".certificate")).collect();
        assert_eq!(claims.iter().map(|one| one["file"].as_str().unwrap()).collect::<Vec<_>>(), written);
        for claim in claims {
            let path = folder.join(claim["file"].as_str().unwrap());
            let (said, code) = json(&["check", path.to_str().unwrap(), "--format", "json"]);
            let said = &said["files"][0];
            assert_eq!((code, &said["verdict"]), (0, &Value::from("proved")));
            for key in ["kind", "title", "range", "detail"] {
                assert_eq!(claim[key], said[key], "{path:?}");
            }
            all.push(claim.clone());
        }
    }
    (tasks, all)
}

fn detail<'c>(claims: &'c [Value], row: &Value, name: &str) -> &'c str {
    let file = row["certificate"].as_str().unwrap_or_else(|| panic!("proved without a certificate: {row}"));
    let claim = claims.iter().find(|claim| claim["file"] == file).unwrap();
    claim["detail"][name].as_str().unwrap_or_else(|| panic!("no {name} in {claim}"))
}

/// Whether digits that are printed as certain are so by a number and how far from it the true one may be: the
/// last of them may be rounded.
fn certain(digits: &str, middle: &BigRational, within: &BigRational) {
    let places = digits.split_once('.').map_or(0, |(_, part)| part.len() as u32);
    let unit = BigRational::new(1.into(), num_bigint::BigInt::from(10).pow(places));
    let apart = (number(digits) - middle).abs();
    assert!(&apart + within <= unit, "{digits} of {middle}");
}

/// Each part of a row of a task `validate`, of an orbit or an event.
fn row_says_what_is_proved(row: &Value, claims: &[Value], event: Option<&str>) {
    let said = |name| detail(claims, row, name);
    match event {
        Some(event) => {
            assert!(said("event").starts_with(event), "{row}");
            let [lower, upper] = ["lower", "upper"].map(|end| row[end].as_str().unwrap());
            assert_eq!(said("parameter"), format!("mu, from {lower} to {upper}"));
            let [lower, upper] = [lower, upper].map(number);
            let [middle, within] = [&upper + &lower, &upper - &lower].map(|x| x / number("2"));
            certain(row["parameter"].as_str().unwrap(), &middle, &within);
        }
        None => {
            let stable = if row["stable"] == true { "stable" } else { "unstable" };
            assert_eq!(said("stability"), stable, "{row}");
        }
    }
    let words: Vec<&str> = said("box").split(' ').collect();
    let after = |word: &str| number(words[words.iter().position(|w| *w == word).unwrap() + 1]);
    let radius = after("within");
    assert_eq!(row["only_within"].as_f64(), radius.to_f64(), "{row}");
    let within = number(words.last().unwrap());
    // In radians; two π to more digits than any of these.
    let turn = number("6.28318530717958647692528676655900576839433879875021");
    for (name, unit) in [("phases", turn), ("speeds", number("1"))] {
        let listed: Vec<&str> = said(name).split(", ").collect();
        let shown = row[name].as_array().unwrap();
        assert_eq!(shown.len(), listed.len(), "{row}");
        for (digits, listed) in shown.iter().zip(listed) {
            certain(digits.as_str().unwrap(), &(number(listed) / &unit), &(&within / &unit));
        }
    }
    let impacts = row["pattern"].as_str().unwrap().split(',').count();
    assert!(said("pattern").starts_with(&format!("{impacts} impact")), "{row}");
}

#[test]
fn rows_of_orbits_and_events_are_their_certificates() {
    let folder = tempfile::tempdir().unwrap();
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/scenes/nordmark-2001.toml");
    let (tasks, claims) =
        run(&scene, &["period-4", "period-6", "proved-mu_pd", "proved-mu_gr4"], folder.path());
    let mut rows = 0;
    for task in &tasks {
        for row in task["proofs"].as_array().unwrap() {
            assert_eq!(row["verdict"], "proved", "{row}");
            row_says_what_is_proved(row, &claims, task["event"].as_str());
            rows += 1;
        }
    }
    assert_eq!((rows, claims.len()), (5, 5));
}

fn scenes(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/scenes").join(name)
}

/// What is said of chaos, in the report's own lines.
#[test]
fn chaos_is_said_as_its_certificate_has_it() {
    let folder = tempfile::tempdir().unwrap();
    let (tasks, claims) = run(&scenes("nordmark-2001-chaos.toml"), &["few"], folder.path());
    let [few] = &tasks[..] else { panic!("{tasks:?}") };
    assert!(few["proved"] == true && few["complete"].as_f64().is_some(), "{few}");
    let said = |name| detail(&claims, few, name);
    assert!(said("others").contains(&format!("S = {}", few["complete"])), "{few}");
    let counts = said("letters").split("; ").map(|letter| letter.split(' ').nth(1).unwrap());
    let alphabet = few["alphabet"].as_array().unwrap().iter().map(ToString::to_string);
    assert!(counts.eq(alphabet), "{few}");
    assert_eq!(said("contraction"), format!("at most {}", few["contraction"]));
    for (letter, row) in said("letters").split("; ").zip(few["letters"].as_array().unwrap()) {
        let ends =
            ["after", "before"].map(|name| row[name].as_array().unwrap().iter().map(ToString::to_string));
        let [[a, b], [p, q]] = ends.map(|both| both.collect::<Vec<_>>().try_into().unwrap());
        assert!(
            letter.contains(&format!("velocity/nu {a} to {b} first, {p} to {q} last")),
            "{letter}: {row}"
        );
    }
    let rate = few["growth"].as_str().unwrap();
    assert!(said("entropy").contains(&format!("log {rate} ")), "{few}");
    let text = Command::new(crate::PROGRAM)
        .args(["run", scenes("nordmark-2001-chaos.toml").to_str().unwrap(), "--only", "few", "-o"])
        .arg(folder.path().join("text"))
        .output()
        .unwrap();
    let text = String::from_utf8(text.stdout).unwrap();
    for name in ["window", "others"] {
        let line = text.lines().find(|line| line.trim_start().starts_with(&format!("{name} "))).unwrap();
        assert!(line.ends_with(said(name)), "{line}");
    }
}

/// What is said of ranges and of attractors that were seen.
#[test]
fn what_is_born_is_said_as_its_certificates_have_it() {
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("s.toml");
    let tasks = "[[tasks]]\nname = \"near\"\nkind = \"grazing\"\nparameter = \"F\"\nmax_period = 1\nseen = false\n\
        range = { effort = 20000 }\n\
        [[tasks]]\nname = \"hits\"\nkind = \"diagram\"\nparameter = \"F\"\nrange = [0.72, 0.74]\ncount = 2\n\
        starts = [{ q = 0 }]\nprove = true\n";
    std::fs::write(&scene, format!("{MACHINE}{tasks}")).unwrap();
    let (tasks, claims) = run(&scene, &[], folder.path());
    let [near, hits] = &tasks[..] else { panic!("{tasks:?}") };
    let rows = near["range"].as_array().unwrap().iter().filter(|row| !row["certificate"].is_null());
    let whole: Vec<&Value> = rows.filter(|row| row["cells"] == Value::Array(vec![])).collect();
    assert!(whole.len() > 2, "{near}");
    let mut others = 0;
    for row in whole {
        let (end, range) = (row["end"].as_str().unwrap(), detail(&claims, row, "parameter"));
        assert!(range.contains(end), "{row}: {range}");
        if let Some(told) = row["others"].as_str() {
            assert!(detail(&claims, row, "others").ends_with(told), "{row}");
            others += 1;
        }
    }
    assert!(others > 0, "{near}");
    let proofs = hits["proofs"].as_array().unwrap();
    assert!(!proofs.is_empty(), "{hits}");
    assert!(proofs.iter().any(|row| row["verdict"] == "proved"), "{hits}");
    for row in proofs {
        assert_eq!(row["verdict"] == "proved", !row["certificate"].is_null(), "{row}");
    }
}
