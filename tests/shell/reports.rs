//! Reports of `grazing run` as text: words before symbols, what matters first, each thing once.

use crate::{process::run, surface::root};

use std::fs;

/// The report of a task among those of a run, without its name.
fn of<'a>(reports: &'a str, task: &str) -> Vec<&'a str> {
    reports
        .lines()
        .skip_while(|line| *line != task)
        .skip(1)
        .take_while(|line| line.starts_with(' '))
        .collect()
}

fn has(report: &[&str], name: &str, begins: &str) {
    let line = format!("  {name:<16} {begins}");
    assert!(report.iter().any(|known| known.starts_with(&line)), "{line}: {report:#?}");
}

#[test]
fn words_come_before_symbols() {
    let folder = tempfile::tempdir().unwrap();
    let scene = root().join("tests/data/kinds.toml");
    let only = "--only grazing --only branch --only gap";
    let (code, text, err) = run(&format!("run {} {only} -o .", scene.display()), folder.path());
    assert_eq!(code, 3, "{err}");
    for sign in ["t_G", "a_G", "free 1"] {
        assert!(!text.contains(sign), "{sign}: {text}");
    }
    let grazing = of(&text, "grazing");
    has(&grazing, "orbit", "no impact");
    has(&grazing, "phase", "0.0 of the period");
    has(&grazing, "region", "3: complex eigenvalues");
    // The paper's oscillator: s is its free frequency, and r what is left of it after a period.
    let (damping, frequency): (f64, f64) = (0.6, 4.9);
    let (r, turns) =
        ((-std::f64::consts::TAU * damping / frequency).exp(), (1.0 - damping * damping).sqrt() / frequency);
    has(&grazing, "ratio", &format!("{turns:.6}: free over forcing frequency"));
    has(&grazing, "remains", &format!("{r:.6}: of a free vibration"));
    // What is born and seen, the table after the sentences, comes before the numbers of the map.
    let at = |begin: &str| grazing.iter().rposition(|line| line.trim_start().starts_with(begin)).unwrap();
    assert!(at("chaos") < at("born") && at("born") < at("seen") && at("seen") < at("local_map"));
    has(&of(&text, "branch"), "fade", "an impact has lost its speed");
    let gap = of(&text, "gap");
    assert!(gap.iter().any(|line| line.contains("2: eigenvalues in (0, 1)")), "{gap:#?}");
    // The JSON keeps the signs.
    let (_, json, _) = run(&format!("run {} {only} -o . --format json", scene.display()), folder.path());
    assert!(json.contains("\"free 1\"") && json.contains("\"region\": \"3\""), "{json}");
}

/// What is seen at a point of a table says first what it is, and columns without an entry are not there.
#[test]
fn tables_begin_with_what_matters() {
    let folder = tempfile::tempdir().unwrap();
    let scene = root().join("tests/data/kinds.toml");
    let (_, text, _) =
        run(&format!("run {} --only branch --only section -o .", scene.display()), folder.path());
    let branch = of(&text, "branch");
    let head = branch.iter().skip_while(|line| line.trim() != "labels").nth(1).unwrap();
    let names: Vec<&str> = head.split_whitespace().collect();
    assert_eq!(
        names[..7],
        ["branch", "label", "parameters", "pattern", "stable", "admissible", "criticality"]
    );
    assert!(!names.contains(&"reason") && names.contains(&"newton_steps"), "{names:?}");
    let section = of(&text, "section");
    let head = section.iter().skip_while(|line| line.trim() != "attractors").nth(1).unwrap();
    assert!(!head.contains("standard_error"), "{head}");
}

/// README's machine over its load, from two starts.
const TWO: &str = r#"
format = "grazing-scene 3"
title = "two attractors"
[parameters]
F = 0.5
[system]
damping = "1/10"
stiffness = "3/10"
forcing = [{ cos = "F" }]
[[stops]]
side = "upper"
offset = 1
restitution = 0.8
[[tasks]]
name = "loads"
kind = "diagram"
parameter = "F"
range = [0.4, 0.8]
count = 30
starts = [{ q = 0 }, { q = -5, u = 3 }]
points = 20
transient = 300
"#;

/// README's machine has two attractors at six values that follow each other: each is listed once.
#[test]
fn coexisting_attractors_are_listed_once() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("two.toml"), TWO).unwrap();
    let (code, text, err) = run("run two.toml -o .", folder.path());
    assert_eq!(code, 0, "{err}");
    let report = of(&text, "loads");
    let rows: Vec<Vec<&str>> = report
        .iter()
        .skip_while(|line| line.trim() != "coexisting")
        .skip(1)
        .take_while(|line| line.starts_with("    "))
        .map(|line| line.split_whitespace().collect())
        .collect();
    assert_eq!(rows[0], ["from", "to", "period", "impacts", "values", "lost"], "{text}");
    let (_, json, _) = run("run two.toml -o . --format json", folder.path());
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let all = json["tasks"][0]["coexisting"].as_array().unwrap();
    // In JSON a row at each value.
    let told: usize = rows[1..].iter().map(|row| row[4].parse::<usize>().unwrap()).sum();
    assert_eq!((rows.len() - 1, told), (2, all.len()), "{text}");
    let kinds: Vec<[&str; 2]> = rows[1..].iter().map(|row| [row[2], row[3]]).collect();
    assert_eq!(kinds, [["1", "0"], ["1", "1"]]);
}

/// The bands of a touch and of a diagram are tables of their own, with the rows and columns of JSON.
#[test]
fn bands_are_tables_too() {
    let folder = tempfile::tempdir().unwrap();
    let touch = "[[tasks]]\nname = \"touch\"\nkind = \"grazing\"\nparameter = \"F\"\nmax_period = 1\n";
    fs::write(folder.path().join("two.toml"), format!("{TWO}{touch}")).unwrap();
    let (code, json, err) = run("run two.toml -o . --format json", folder.path());
    assert_eq!(code, 0, "{err}");
    let report: serde_json::Value = serde_json::from_str(&json).unwrap();
    for task in ["loads", "touch"] {
        let tasks = report["tasks"].as_array().unwrap();
        let found = tasks.iter().find(|known| known["task"] == task).unwrap_or_else(|| panic!("{json}"));
        let file = format!("{task}-bands.csv");
        assert!(found["files"].as_array().unwrap().iter().any(|name| name == &file), "{found}");
        let text = fs::read_to_string(folder.path().join(file)).unwrap();
        let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let columns = lines.next().unwrap();
        let (rows, lines) = (found["bands"].as_array().unwrap(), lines.collect::<Vec<_>>());
        let bands: Vec<&str> = lines.iter().map(|line| line[0]).collect();
        assert_eq!(bands, ["free", "depends", "hits"], "{text}");
        assert_eq!((rows.len(), rows[0].as_object().unwrap().len()), (lines.len(), columns.len()), "{text}");
        for (row, line) in rows.iter().zip(&lines) {
            for (column, cell) in columns.iter().zip(line) {
                let same = match &row[column] {
                    serde_json::Value::Null => cell.is_empty(),
                    serde_json::Value::String(word) => word == cell,
                    number => cell.parse().ok() == number.as_f64(),
                };
                assert!(same, "{column}: {cell:?}, not {}", row[column]);
            }
        }
    }
}

/// A table beside a task's tables says which unit each column is in; their heads have names alone.
#[test]
fn columns_have_their_units_beside_them() {
    let folder = tempfile::tempdir().unwrap();
    let scene = |force: &str, gap: &str| {
        format!(
            "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\nF = {force}\n[system]\nfrequency = 4\n\
             damping = 3\nstiffness = 800\nforcing = [{{ cos = \"F\" }}]\n[[stops]]\nside = \"upper\"\n\
             offset = {gap}\nrestitution = 0.8\n[[tasks]]\nname = \"motion\"\nkind = \"simulate\"\nperiods = 3\n\
             start = {{ q = 0 }}\n[[tasks]]\nname = \"orbits\"\nkind = \"branch\"\nparameter = \"F\"\n\
             range = [0.3, 0.5]\nstarts = [{{ attractor = {{ q = 0 }} }}]\n"
        )
    };
    let read = |file: &str| fs::read_to_string(folder.path().join(file)).unwrap();
    fs::write(folder.path().join("units.toml"), scene("\"400 mN\"", "\"5 mm\"")).unwrap();
    let (code, text, err) = run("run units.toml -o .", folder.path());
    assert_eq!(code, 0, "{err}");
    assert!(text.contains("motion-units.csv") && text.contains("orbits-units.csv"), "{text}");
    let motion = read("motion-units.csv");
    assert!(motion.starts_with("file,column,unit\nmotion.csv,time,s\nmotion.csv,q,m\nmotion.csv,u,m/s\n"));
    assert!(motion.contains("\nmotion-events.csv,radius,s\n"), "{motion}");
    // There it counts periods.
    assert!(!motion.contains("period,"), "{motion}");
    // The picture is over the unit that is written, the table is not.
    let orbits = read("orbits-units.csv");
    for line in ["orbits.csv,parameter,mN", "orbits.csv,q,m", "orbits-points.csv,parameters,N"] {
        assert!(orbits.contains(&format!("\n{line}\n")), "{line}: {orbits}");
    }
    for table in [&motion, &orbits] {
        for line in table.lines().skip(1) {
            let [file, column, _] = line.split(',').collect::<Vec<_>>()[..] else { panic!("{line}") };
            assert!(read(file).lines().next().unwrap().split(',').any(|known| known == column), "{line}");
        }
    }
    // Without units there is none, and with them no other head.
    let head = read("motion.csv").lines().next().unwrap().to_string();
    fs::write(folder.path().join("bare.toml"), scene("0.4", "0.005")).unwrap();
    fs::remove_file(folder.path().join("motion-units.csv")).unwrap();
    run("run bare.toml -o . --only motion", folder.path());
    assert_eq!(read("motion.csv").lines().next(), Some(&head[..]));
    assert!(!folder.path().join("motion-units.csv").exists());
}
