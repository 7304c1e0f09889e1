//! What Cargo does not hold of the sources: within a chapter imports point down the table of its `lib.rs`, no
//! two public types share a name, and pages keep their form.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
};

/// The folders of the chapters; the last two have no interface.
const FOLDERS: [&str; 8] = [
    "src",
    "crates/base/src",
    "crates/motion/src",
    "crates/prove/src",
    "crates/scenes/src",
    "crates/study/src",
    "crates/verify/src",
    "crates/shell/src",
];

/// The folder of the repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap()
}

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

/// Every source file: the names that lead to it from its folder, and its text without comments.
fn files() -> Vec<(Vec<String>, String)> {
    FOLDERS.iter().flat_map(|folder| files_of(folder)).collect()
}

fn files_of(folder: &str) -> Vec<(Vec<String>, String)> {
    let root = root().join(folder);
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

/// The modules of a chapter in the order of the table in its `lib.rs`, from the bottom up.
fn order(folder: &str) -> Vec<String> {
    let text = fs::read_to_string(root().join(folder).join("lib.rs")).unwrap();
    let rows = text.lines().filter_map(|line| line.strip_prefix("//! | [`")?.split(" | ").next());
    let names = rows.flat_map(|row| row.split(['`', '[', ']', ',', ' '])).filter(|name| !name.is_empty());
    names.map(ToString::to_string).collect()
}

#[test]
fn imports_point_down_the_map_of_a_chapter() {
    let mut seen = BTreeSet::new();
    for folder in ["src", "crates/base/src", "crates/motion/src", "crates/scenes/src"] {
        let order = order(folder);
        let place = |name: &str| order.iter().position(|known| known == name);
        for (names, text) in files_of(folder) {
            let Some(own) = place(&names[0]) else { continue };
            for used in heads(&text, "crate::") {
                // The root's own names, and those of chapters below.
                let Some(other) = place(used) else { continue };
                let file = names.join("/");
                assert!(other <= own, "{folder}/{file} imports from {used}, which stands above it");
                seen.insert((names[0].clone(), used.to_string()));
            }
        }
    }
    // The script has seen the imports that there must be.
    for (upper, lower) in
        [("run", "scene"), ("search", "existence"), ("many", "continuation"), ("output", "error")]
    {
        assert!(seen.contains(&(upper.to_string(), lower.to_string())), "{upper} uses {lower}");
    }
}

/// What both engines share stands below them: neither imports from the other.
#[test]
fn engines_are_siblings() {
    let mut counted = BTreeMap::new();
    for (names, text) in files_of("crates/motion/src") {
        for (own, other) in [("one", "many"), ("many", "one")] {
            if names[0] == own {
                *counted.entry(own).or_insert(0) += 1;
                assert!(!heads(&text, "crate::").contains(other), "{} imports from {other}", names.join("/"));
            }
        }
    }
    assert!(counted["one"] > 30 && counted["many"] > 30, "{counted:?}");
}

/// Chapters whose files import from those that stand before them in these lists.
const FILES: [(&str, &str, &str); 2] = [
    (
        "crates/scenes/src",
        "scene",
        "dual grammar expression dimension quantity format keys units restitution force law matrix measured walls system machine \
         linear oscillator simulate tolerance orbits sections monitors branches response rest validate chaos task scene values hidden normal \
         tolerated check wanted input upgrade family reference",
    ),
    (
        "crates/motion/src",
        "attractor",
        "dynamics section cycle confirm lyapunov wander detection observe portrait swing checkpoint basins diagram hitting touch \
         rest limit_cycle",
    ),
];

#[test]
fn files_of_a_chapter_import_from_earlier_ones() {
    for (folder, chapter, order) in FILES {
        let order: Vec<&str> = order.split_whitespace().collect();
        let place = |name: &str| order.iter().position(|known| *known == name);
        for (names, text) in files_of(folder) {
            let [of, file, ..] = &names[..] else { continue };
            if of != chapter || file == "mod" {
                continue;
            }
            let own =
                place(file).unwrap_or_else(|| panic!("{file} has no place among the files of {chapter}"));
            for used in heads(&text, "super::") {
                let known = names.len() > 2 || place(used).is_none_or(|other| other < own);
                assert!(known, "{chapter}/{file} imports from {used}");
            }
        }
    }
}

/// A kind of task is found by its word.
#[test]
fn files_of_tasks_bear_the_names_of_their_kinds() {
    let root = root();
    let table = fs::read_to_string(root.join("crates/scenes/src/scene/task.rs")).unwrap();
    let (_, table) = table.split_once("\nkinds! {").unwrap();
    let (table, _) = table.split_once('}').unwrap();
    let kinds: Vec<(&str, &str)> = table
        .lines()
        .filter_map(|line| line.trim().trim_end_matches(',').split_once(' '))
        .map(|(word, name)| (word.trim_matches('"'), name))
        .collect();
    assert!(kinds.len() >= 12, "{kinds:?}");
    for (word, name) in kinds {
        let file = root.join("crates/scenes/src/run").join(word).with_extension("rs");
        let text = fs::read_to_string(&file).unwrap_or_else(|_| panic!("{} is absent", file.display()));
        assert!(text.contains(name), "{} does not answer {name}", file.display());
    }
}

/// The clock is asked in one place, which stands still where there is none: in a browser `Instant::now` and
/// `SystemTime::now` panic.
#[test]
fn the_library_asks_the_clock_in_one_place() {
    let asks = |text: &str| ["Instant::now", "SystemTime::now"].iter().any(|call| text.contains(call));
    let library = &FOLDERS[..5];
    let found: Vec<String> = library
        .iter()
        .flat_map(|folder| files_of(folder))
        .filter(|(_, text)| asks(text))
        .map(|(names, _)| names.join("/"))
        .collect();
    assert_eq!(found, ["processor"]);
}

/// A path is a name too: the engines and what they share may say the same word, each once.
#[test]
fn every_public_type_has_a_name_of_its_own_in_its_chapter() {
    let mut places: BTreeMap<(String, String), Vec<String>> = BTreeMap::new();
    // The commands' arguments have one name each, in a module each.
    for (folder, (names, text)) in
        FOLDERS[..6].iter().flat_map(|folder| files_of(folder).into_iter().map(move |file| (folder, file)))
    {
        for line in text.lines() {
            let line = line.trim_start();
            for kind in ["struct", "enum", "trait", "type"] {
                if let Some(rest) = line.strip_prefix(&format!("pub {kind} ")) {
                    let end = rest.find(|c: char| !c.is_alphanumeric()).unwrap_or(rest.len());
                    let part = ["motion", "one", "many"].iter().find(|part| **part == names[0]);
                    let chapter = format!("{folder} {}", part.unwrap_or(&""));
                    places.entry((chapter, rest[..end].to_string())).or_default().push(names.join("/"));
                }
            }
        }
    }
    assert!(places.len() > 150, "{}", places.len());
    // Without a name: what a macro defines.
    places.retain(|(_, name), files| files.len() > 1 && !name.is_empty());
    assert!(places.is_empty(), "{places:?}");
}

/// Widths of comments and of prose.
const WIDTH: usize = 110;

/// The files below a folder of the package with this ending, but for what is built.
fn below(folder: &Path, ending: &str, all: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() {
            if !["target", "node_modules"].contains(&&*name) && !name.starts_with('.') {
                below(&path, ending, all);
            }
        } else if path.extension().is_some_and(|extension| extension == ending) {
            all.push(path);
        }
    }
}

/// The files of the package with this ending.
fn all_files(ending: &str) -> Vec<PathBuf> {
    let mut all = Vec::new();
    below(&root(), ending, &mut all);
    all.sort();
    all
}

/// Whether a line of prose cannot be broken: a row of a table, a heading, a picture, an address.
fn unbreakable(line: &str) -> bool {
    let picture = line.trim_start().starts_with("![");
    let line = line.trim_start().trim_start_matches(['/', '!']).trim_start();
    picture
        || ["#", "<"].iter().any(|start| line.starts_with(start))
        || line.starts_with('|') && line.ends_with('|')
        || line.starts_with('[') && line.contains("]: ")
        || line.contains("://")
}

/// The lines of Markdown that are prose, with their numbers: no code, no formula set apart.
fn prose<'t>(lines: impl Iterator<Item = (usize, &'t str)>) -> Vec<(usize, &'t str)> {
    let mut fenced = false;
    let (mut listed, mut blank) = (false, true);
    let mut all = Vec::new();
    for (number, line) in lines {
        let start = line.trim_start();
        let item = ["- ", "* ", "> "].iter().any(|mark| start.starts_with(mark))
            || start.split_once(". ").is_some_and(|(number, _)| number.parse::<u8>().is_ok());
        if start.starts_with("```") {
            fenced = !fenced;
        } else if !fenced && !start.is_empty() {
            listed = item || listed && (!blank || line.starts_with("  "));
            // Indented by four, and no item's continuation: set apart.
            if !line.starts_with("    ") || listed {
                all.push((number, line));
            }
        }
        blank = start.is_empty();
    }
    all
}

/// Commands write no file but those that they have named in the registry, so that none is lost to another.
#[test]
fn commands_write_what_they_have_named() {
    for (path, text) in files().iter().filter(|(path, _)| path.first().is_some_and(|first| first == "cli")) {
        for way in ["write_file(", "fs::write(", "File::create", "fs::rename", "fs::copy"] {
            assert!(!text.contains(way), "{}: {way} goes round the registry of files", path.join("/"));
        }
    }
}

#[test]
fn comments_and_prose_keep_to_one_width() {
    let mut wide = Vec::new();
    let mut seen = 0;
    let mut look = |path: &Path, lines: Vec<(usize, &str)>| {
        for (number, line) in lines {
            seen += 1;
            if line.chars().count() > WIDTH && !unbreakable(line) {
                wide.push(format!("{}:{number}: {line}", path.display()));
            }
        }
    };
    for path in all_files("rs") {
        let text = fs::read_to_string(&path).unwrap();
        let comments = (1..).zip(text.lines()).filter(|(_, line)| line.trim_start().starts_with("//"));
        look(&path, comments.collect());
    }
    for path in all_files("md") {
        let text = fs::read_to_string(&path).unwrap();
        look(&path, prose((1..).zip(text.lines())));
    }
    assert!(seen > 8_000, "{seen} lines were looked at");
    assert!(wide.is_empty(), "wider than {WIDTH} columns:\n{}", wide.join("\n"));
}

/// The name that a heading has in an address: lower case, blanks as hyphens, of other signs only `-` and `_`.
fn anchor(heading: &str) -> String {
    // Of a link its text; code without its marks.
    let mut text = String::new();
    let mut rest = heading;
    while let Some((before, link)) = rest.split_once('[') {
        let Some((name, after)) = link.split_once("](") else { break };
        text += before;
        text += name;
        rest = after.split_once(')').map_or("", |(_, after)| after);
    }
    text += rest;
    let kept = text.chars().filter(|c| c.is_alphanumeric() || [' ', '-', '_'].contains(c));
    kept.collect::<String>().trim().to_lowercase().replace(' ', "-")
}

/// The targets of all links and pictures on a page, code apart.
fn targets(text: &str) -> Vec<String> {
    let mut all = Vec::new();
    let lines = prose((1..).zip(text.lines()));
    let whole = lines.iter().map(|(_, line)| line.trim()).collect::<Vec<_>>().join(" ");
    // Between single backquotes is code.
    for part in whole.split('`').step_by(2) {
        for (at, _) in part.match_indices("](") {
            let target = part[at + 2..].split([')', ' ']).next().unwrap_or_default();
            all.push(target.to_string());
        }
    }
    // A link whose text is code is cut in two above.
    for (at, _) in whole.match_indices("`](") {
        all.push(whole[at + 3..].split([')', ' ']).next().unwrap_or_default().to_string());
    }
    all
}

#[test]
fn every_link_leads_somewhere() {
    let root = root();
    let pages: BTreeMap<PathBuf, String> = all_files("md")
        .into_iter()
        .map(|path| (path.canonicalize().unwrap(), fs::read_to_string(&path).unwrap()))
        .collect();
    let anchors = |text: &str| -> BTreeSet<String> {
        let lines = prose((1..).zip(text.lines()));
        lines
            .iter()
            .filter(|(_, line)| line.starts_with('#'))
            .map(|(_, line)| anchor(line.trim_start_matches('#')))
            .collect()
    };
    let (mut broken, mut followed) = (Vec::new(), 0);
    for (page, text) in &pages {
        for target in targets(text) {
            if target.contains("://") || target.starts_with("mailto:") {
                continue;
            }
            followed += 1;
            let (file, place) = target.split_once('#').unwrap_or((&target, ""));
            let to = if file.is_empty() {
                Ok(page.clone())
            } else {
                page.parent().unwrap().join(file).canonicalize()
            };
            let good = to.as_ref().is_ok_and(|to| {
                to.starts_with(root.canonicalize().unwrap())
                    && (place.is_empty() || pages.get(to).is_some_and(|text| anchors(text).contains(place)))
            });
            if !good {
                broken.push(format!("{}: {target}", page.display()));
            }
        }
    }
    assert!(followed > 100, "{followed} links were followed");
    assert!(broken.is_empty(), "links that lead nowhere:\n{}", broken.join("\n"));
}

/// What the article names as proved is a theorem, a statement or a file of the proofs.
#[test]
fn names_in_the_article_are_in_the_proofs() {
    let root = root();
    let proofs: BTreeMap<String, String> = fs::read_dir(root.join("proofs/coq"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "v"))
        .map(|path| (path.file_name().unwrap().to_str().unwrap().into(), fs::read_to_string(&path).unwrap()))
        .collect();
    let named: BTreeSet<&str> = proofs
        .values()
        .flat_map(|text| text.lines())
        .filter_map(|line| {
            ["Theorem ", "Definition ", "Lemma "].iter().find_map(|kind| line.strip_prefix(kind))
        })
        .filter_map(|rest| rest.split([' ', ':']).next())
        .collect();
    let article = fs::read_to_string(root.join("docs/article/article.tex")).unwrap();
    let source = article.lines().filter(|line| !line.starts_with('%')).collect::<Vec<_>>().join("\n");
    let names: BTreeSet<&str> = source
        .split("\\coq{")
        .skip(1)
        .filter_map(|rest| rest.split('}').next())
        .filter(|name| !name.contains('#'))
        .collect();
    assert!(names.len() > 30, "{} names", names.len());
    let missing: Vec<_> =
        names.into_iter().filter(|name| !named.contains(name) && !proofs.contains_key(*name)).collect();
    assert!(missing.is_empty(), "not in proofs/coq: {missing:?}");
}

/// The list of pages is complete, so that docs can be read from front to back.
#[test]
fn the_summary_lists_every_page_once() {
    let docs = root().join("docs");
    let mut listed = targets(&fs::read_to_string(docs.join("SUMMARY.md")).unwrap());
    listed.sort();
    let mut pages: Vec<String> = fs::read_dir(&docs)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.ends_with(".md") && name != "SUMMARY.md")
        .collect();
    pages.sort();
    assert_eq!(listed, pages);
}
