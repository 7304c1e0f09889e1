//! Section 4 of the paper in docs/branches.md: its numbers are those of the commands it names, and round to
//! the paper's.

use std::{env, path::PathBuf, process::Command};

use serde_json::Value;

const PAGE: &str = include_str!("../../docs/branches.md");

/// The report of a scene's group section-4; with the exit code expected.
fn report(scene: &str, code: i32) -> Value {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(scene);
    let output = Command::new(crate::PROGRAM)
        .args([
            "run",
            &format!("{}/../../examples/scenes/{scene}.toml", env!("CARGO_MANIFEST_DIR")),
            "--only",
            "section-4",
            "--format",
            "json",
            "-o",
        ])
        .arg(&folder)
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(code), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(folder.join("grazing.csv").is_file());
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The value in a task's row with that pattern.
fn lookup<'v>(report: &'v Value, task: &str, pattern: &str, column: &str) -> &'v Value {
    let tasks = report["tasks"].as_array().unwrap();
    let found = tasks.iter().find(|found| found["task"] == task).unwrap();
    let rows = ["born", "found"].iter().find_map(|name| found.get(name)?.as_array()).unwrap();
    let row = rows.iter().find(|row| row["pattern"] == pattern).unwrap();
    // A column, or an entry of a list in it, from 1.
    let value = match column.split_once(' ') {
        Some((list, entry)) => &row[list][entry.parse::<usize>().unwrap() - 1],
        None => &row[column],
    };
    // A complex number is a pair; those of this page are real.
    value.get(0).filter(|_| value[1] == 0.0).unwrap_or(value)
}

/// Eleven significant digits.
fn shown(x: f64) -> String {
    format!("{x:.*}", (10 - x.abs().log10().floor() as i32).max(0) as usize)
}

#[test]
fn the_page_has_the_digits_of_the_commands_and_of_the_paper() {
    let reports = [report("nordmark-2001", 0), report("nordmark-2001-w48", 3)];
    let mut page = String::new();
    let mut section = None;
    let mut rows = 0;
    for line in PAGE.lines() {
        if line.starts_with("## ") {
            section = reports.get(usize::from(line.contains("4.1")));
        }
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let [_, quantity, task, pattern, column, paper, _, _] = cells[..] else {
            page += &format!("{line}\n");
            continue;
        };
        if quantity == "quantity" || quantity == "---" {
            page += &format!("{line}\n");
            continue;
        }
        let value = lookup(section.unwrap(), task, pattern, column);
        let here = value.as_f64().map_or_else(|| value.as_str().unwrap().to_string(), shown);
        page += &format!("| {quantity} | {task} | {pattern} | {column} | {paper} | {here} |\n");
        rows += 1;
        match (paper.parse::<f64>(), value.as_f64()) {
            (Ok(_), Some(x)) => {
                let decimals = paper.split('.').nth(1).map_or(0, str::len);
                assert_eq!(format!("{x:.decimals$}"), paper, "{quantity}");
            }
            (_, Some(x)) if paper.contains('0') => {
                assert_eq!(paper, if x > 0.0 { "> 0" } else { "< 0" }, "{quantity}")
            }
            (_, None) if !paper.is_empty() => assert_eq!(here, paper, "{quantity}"),
            _ => {}
        }
    }
    assert_eq!(rows, 22);
    if env::var_os("GRAZING_BLESS").is_some() {
        std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/branches.md"), &page).unwrap();
    } else {
        assert_eq!(
            page, PAGE,
            "write it anew with GRAZING_BLESS=1 cargo test -p grazing-shell --test scenes section4::"
        );
    }
}
