//! The sources keep to the map of `src/lib.rs`: imports point down its table, and no two public types share a
//! name.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
};

/// Below the table: what every part may use.
const BELOW: [&str; 7] = ["error", "outcome", "monitor", "processor", "random", "output", "number"];
/// Above it.
const ABOVE: [&str; 3] = ["study", "figure", "cli"];

fn sources(folder: &Path, all: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, all);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            all.push(path);
        }
    }
}

/// Every source file: the names that lead to it from `src`, and its text without comments.
fn files() -> Vec<(Vec<String>, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut all = Vec::new();
    sources(&root, &mut all);
    let read = |path: PathBuf| {
        let inside = path.strip_prefix(&root).unwrap().with_extension("");
        let names = inside.iter().map(|name| name.to_str().unwrap().to_string()).collect();
        let text = fs::read_to_string(&path).unwrap();
        let code = |line: &str| line.split("//").next().unwrap_or_default().to_string();
        (names, text.lines().map(code).collect::<Vec<_>>().join("\n"))
    };
    all.into_iter().map(read).collect()
}

/// The names that follow `prefix`, each at the head of a path or of an entry in braces.
fn heads<'t>(text: &'t str, prefix: &str) -> BTreeSet<&'t str> {
    let word = |text: &'t str| {
        let end = text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len());
        &text[..end]
    };
    let mut found = BTreeSet::new();
    for (at, _) in text.match_indices(prefix) {
        let rest = &text[at + prefix.len()..];
        let Some(list) = rest.strip_prefix('{') else {
            found.insert(word(rest));
            continue;
        };
        let (mut depth, mut begins) = (1, true);
        for (i, c) in list.char_indices() {
            match c {
                '{' => depth += 1,
                '}' if depth == 1 => break,
                '}' => depth -= 1,
                ',' if depth == 1 => begins = true,
                c if begins && c.is_alphanumeric() => {
                    found.insert(word(&list[i..]));
                    begins = false;
                }
                _ => {}
            }
        }
    }
    found
}

/// The modules in order, from the bottom up.
fn order() -> Vec<String> {
    let map = include_str!("../src/lib.rs").lines().filter_map(|line| {
        let row = line.strip_prefix("//! | [`")?;
        Some(row.split('`').next()?.to_string())
    });
    let table = map.filter(|name| name != "certificate" && name.chars().all(|c| c.is_lowercase()));
    let below = BELOW.iter().map(ToString::to_string);
    // Errors of TOML files hold numbers.
    let source = ["source".to_string()];
    let table = table.filter(|name| name != "number");
    below.chain(source).chain(table).chain(ABOVE.iter().map(ToString::to_string)).collect()
}

#[test]
fn imports_point_down_the_map() {
    let order = order();
    let place = |name: &str| order.iter().position(|known| known == name);
    let mut seen = BTreeSet::new();
    for (names, text) in files() {
        let [chapter, ..] = &names[..] else { unreachable!("a file has a name") };
        if ["lib", "main"].contains(&chapter.as_str()) {
            continue;
        }
        let own = place(chapter).unwrap_or_else(|| panic!("{chapter} is not on the map of src/lib.rs"));
        for used in heads(&text, "crate::") {
            // The root's own names: Error, Monitor, Outcome, certificate.
            let Some(other) = place(used) else { continue };
            assert!(other <= own, "{} imports from {used}, which stands above {chapter}", names.join("/"));
            seen.insert((chapter.clone(), used.to_string()));
        }
    }
    // The script has seen the imports that there must be.
    for (upper, lower) in
        [("run", "scene"), ("scene", "oscillator"), ("oscillator", "number"), ("cli", "run")]
    {
        assert!(seen.contains(&(upper.to_string(), lower.to_string())), "{upper} uses {lower}");
    }
}

/// A file of a scene imports from those that stand before it in the list of its chapter's first lines.
#[test]
fn files_of_scenes_import_from_earlier_ones() {
    let order: Vec<&str> =
        "expression keys matrix walls system machine simulate orbits sections branches validate chaos task scene \
                            values normal check input family reference"
            .split_whitespace()
            .collect();
    let place = |name: &str| order.iter().position(|known| *known == name);
    for (names, text) in files() {
        let [chapter, file] = &names[..] else { continue };
        if chapter != "scene" || file == "mod" {
            continue;
        }
        let own = place(file).unwrap_or_else(|| panic!("{file} has no place in the order of scene's files"));
        for used in heads(&text, "super::") {
            let known = place(used).is_none_or(|other| other < own);
            assert!(known, "scene/{file} imports from {used}");
        }
    }
}

#[test]
fn every_public_type_has_a_name_of_its_own() {
    let mut places: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for (names, text) in files() {
        for line in text.lines() {
            let line = line.trim_start();
            for kind in ["struct", "enum", "trait", "type"] {
                if let Some(rest) = line.strip_prefix(&format!("pub {kind} ")) {
                    let end = rest.find(|c: char| !c.is_alphanumeric()).unwrap_or(rest.len());
                    places.entry(rest[..end].to_string()).or_default().push(names.join("/"));
                }
            }
        }
    }
    assert!(places.len() > 150, "{}", places.len());
    // Without a name: what a macro defines.
    places.retain(|name, files| files.len() > 1 && !name.is_empty());
    assert!(places.is_empty(), "{places:?}");
}
