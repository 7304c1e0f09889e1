//! JSON, on the standard output and in files: every command's, every form of it and every kind of task's is
//! held against docs/schemas.

use crate::{
    process::run,
    surface::{COMMANDS, SEEN, python, root},
};

use std::{
    collections::BTreeSet,
    fs,
    path::{Path, PathBuf},
};

use serde_json::Value;

/// Outputs in JSON, at least one for each schema in docs/schemas; `@` begins the name of a file that a
/// command of the list writes itself.
const JSON: [&str; 55] = [
    "intervals 3..=5",
    "intervals 3..=5 --decimals 4",
    "intervals --pattern 3,5",
    "intervals --measure 10000..=10002",
    "word --r 0.9 --s 0.37",
    "word --r 1.25 --s 0.37 --returns",
    "word --a1=-0.3..=-0.2 --a2 0.5..=0.51",
    "boundary 3..=4",
    "boundary 3 --grid 2",
    "verify 3..=8 --certificate theorem2",
    "cover 3..=4 --certificate cover",
    "cover 8 --max-depth 3",
    "cover 5 --shard 1/2 --certificate part",
    "check theorem2 cover missing",
    "farey neighbours 3/8",
    "farey rank 3/8 10",
    "farey walk 5",
    "evaluate --n 5 --s 1/7",
    "evaluate --n 4 --s 1/8",
    "classify --r 0.99 --s 21/100",
    "classify --r 0.97+-1% --s 0.37",
    "word --r 0.97±1% --s 0.37..=0.38",
    "word --frequency 3.7Hz --damping-ratio 0.1±20% --drive 10Hz",
    "word --frequency 3.7Hz±1% --damping-ratio 0.1±20% --drive 10Hz --shares --cells 200",
    "word --frequency 222rpm±1% --damping-ratio 0.1±20% --drive 10Hz --decides --max-period 3",
    "word --r 0.97 --s 1/4 --decides --max-period 2 --cells 40",
    "decay {root}/examples/decay.csv",
    "decay {root}/examples/decay.csv --unit none",
    "classify --summary",
    "existence {root}/examples/maps/focus.toml --max-period 3",
    "existence {root}/examples/maps/singular.toml --max-period 3 --exact",
    "existence {root}/examples/maps/focus.toml --max-period 3 --counts",
    "existence {root}/examples/maps/four-dimensional.toml --max-period 3 --counts",
    "existence {root}/examples/maps/singular.toml --max-period 3 --uniform",
    "fuzz --cases 100 --n 12",
    "fuzz --words --cases 20",
    "run {root}/tests/data/kinds.toml",
    "run {root}/tests/data/kinds-machine.toml",
    "run {root}/tests/data/ends.toml",
    "run {root}/tests/data/ends-machine.toml",
    "run {root}/tests/data/measured.toml",
    "run {root}/tests/data/monitors.toml",
    "run {root}/examples/machines/belt.toml",
    "run seen.toml",
    "answer seen.toml",
    "run {root}/tests/data/recorded.toml",
    "run {root}/tests/data/kinds.toml --only basins --shard 1/2 -o rows",
    "run {root}/tests/data/kinds.toml --only map --shard 2/2 -o map-rows",
    "run {root}/tests/data/kinds.toml --dry-run",
    "merge part theorem2 -o merged",
    "merge part part -o merged",
    "merge theorem2 -o merged",
    "@branch.json",
    "@machine-branch.json",
    "@held.json",
];

/// Formats that are not JSON: what is read, and what heads or names a file of another kind.
const NOT_JSON: [&str; 16] = [
    "grazing-digits 1",
    "grazing-effects 1",
    "grazing-flow-accuracy 1",
    "grazing-long-runs 1",
    "grazing-machine-effects 1",
    "grazing-map 1",
    "grazing-orbit 1",
    "grazing-profile 1",
    "grazing-proofs 1",
    "grazing-scene 1",
    "grazing-scene 2",
    "grazing-scene 3",
    "grazing-shard 1",
    "grazing-sign-points 1",
    "grazing-signs 1",
    "grazing-simulations 1",
];

/// Kinds of tasks that the engine `many` does not do.
const NOT_OF_MACHINES: [&str; 3] = ["map", "crisis", "chaos"];

/// Every command whose help offers JSON is in the list, and every format that the sources name has a schema
/// or is known not to be JSON: a command, or a form of its output, without a schema fails here.
#[test]
fn every_command_and_every_format_has_a_schema() {
    for command in COMMANDS {
        let (_, help, _) = run(&format!("{command} --help"), root());
        let listed = JSON.iter().any(|line| line.split(' ').next() == Some(command));
        assert_eq!(help.to_lowercase().contains("json"), listed, "{command} in JSON");
    }
    let schemas: BTreeSet<String> = fs::read_dir(root().join("docs/schemas"))
        .unwrap()
        .map(|file| file.unwrap().path().file_stem().unwrap().to_string_lossy().replace(".json", ""))
        .collect();
    let chapters = ["base", "motion", "prove", "scenes", "study", "verify", "shell"];
    let (mut named, mut folders) = (BTreeSet::new(), vec![root().join("src")]);
    folders.extend(chapters.map(|chapter| root().join("crates").join(chapter).join("src")));
    while let Some(folder) = folders.pop() {
        let paths: Vec<PathBuf> = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).collect();
        for path in paths {
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|end| end == "rs") {
                named.extend(formats(&fs::read_to_string(&path).unwrap()));
            }
        }
    }
    assert!(named.len() > 30, "{named:?}");
    let others: BTreeSet<String> = NOT_JSON.map(String::from).into();
    let json: BTreeSet<String> = named.difference(&others).map(|name| name.replace(' ', "-")).collect();
    assert_eq!(json, schemas);
    assert!(others.is_subset(&named), "{named:?}");
}

/// The names of formats that stand in a source as literals of their own: "grazing-scene 3".
fn formats(text: &str) -> impl Iterator<Item = String> {
    text.split('"').filter_map(|literal| {
        let (name, number) = literal.split_once(' ')?;
        let is_name = |c: char| c.is_ascii_lowercase() || c == '-';
        let is_one = name.starts_with("grazing-")
            && name.chars().all(is_name)
            && !number.is_empty()
            && number.chars().all(|c| c.is_ascii_digit());
        is_one.then(|| literal.to_string())
    })
}

/// The outputs of the list, written into a folder; their names there.
fn outputs(folder: &Path) -> Vec<String> {
    fs::write(folder.join("seen.toml"), SEEN).unwrap();
    let mut files = Vec::new();
    for (index, arguments) in JSON.iter().enumerate() {
        if let Some(written) = arguments.strip_prefix('@') {
            files.push(written.to_string());
            continue;
        }
        let arguments = arguments.replace("{root}", &root().display().to_string());
        let (code, out, err) = run(&format!("{arguments} --format json"), folder);
        assert!(!out.is_empty(), "grazing {arguments}: {code} {err}");
        files.push(format!("output{index}"));
        fs::write(folder.join(&files[index]), out).unwrap();
    }
    files
}

/// The kinds of tasks, as the program lists them when it is given none of them.
fn kinds(folder: &Path) -> Vec<String> {
    let known = fs::read_to_string(root().join("tests/data/ends.toml")).unwrap();
    fs::write(folder.join("kind.toml"), known.replacen("\"simulate\"", "\"none\"", 1)).unwrap();
    let (code, _, err) = run("run kind.toml", folder);
    assert_eq!(code, 2, "{err}");
    let list = err.split("is none of ").nth(1).unwrap_or_else(|| panic!("{err}"));
    list.split(';').next().unwrap().trim().split(", ").map(String::from).collect()
}

/// Of every kind of task some output has what each engine finds, and motions end in every way.
fn every_task_is_there(kinds: &[String], outputs: &[Value]) {
    let tasks = || outputs.iter().filter_map(|output| output["tasks"].as_array()).flatten();
    // Of several values or starts, some lead to nothing.
    let some = |list: &Value| list.as_array().is_some_and(|list| !list.is_empty());
    let finds = |task: &Value| task["status"] == "done" || some(&task["orbits"]) || some(&task["labels"]);
    for (kind, engine) in kinds.iter().flat_map(|kind| [(kind, "one"), (kind, "many")]) {
        let found =
            tasks().any(|task| task["kind"] == **kind && task["engine"]["name"] == engine && finds(task));
        let refused = engine == "many" && NOT_OF_MACHINES.contains(&kind.as_str());
        assert_eq!(found, !refused, "a task of kind {kind} by the engine {engine}");
    }
    for (end, engine) in ["not-smooth", "escaped"].iter().flat_map(|end| [(end, "one"), (end, "many")]) {
        let ends = tasks().filter(|task| task["end"] == **end && task["engine"]["name"] == engine);
        assert!(ends.count() > 0, "a motion that ends as {end} by the engine {engine}");
    }
}

/// With `GRAZING_REQUIRE_PYTHON=1`, by Python's `jsonschema`, every output is as its schema says, and no key
/// can be renamed, left out or given another type without the schema noticing (`tests/schemas.py`).
#[test]
fn json_is_as_its_schemas_say() {
    let folder = tempfile::tempdir().unwrap();
    let files = outputs(folder.path());
    let read = |file: &String| fs::read_to_string(folder.path().join(file)).unwrap();
    let values: Vec<Value> = files.iter().map(|file| serde_json::from_str(&read(file)).unwrap()).collect();
    every_task_is_there(&kinds(folder.path()), &values);
    if !crate::samples::asked("GRAZING_REQUIRE_PYTHON", "the JSON held against docs/schemas") {
        return;
    }
    let [script, schemas] =
        ["tests/schemas.py", "docs/schemas"].map(|path| root().join(path).display().to_string());
    let all: Vec<&str> = [&script, &schemas].into_iter().chain(&files).map(String::as_str).collect();
    let output = python(folder.path(), &all).unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{said}{}", String::from_utf8_lossy(&output.stderr));
    let damaged: usize = said.rsplit(", ").next().unwrap().split(' ').next().unwrap().parse().unwrap();
    assert!(damaged > 1000, "{said}");
}
