//! Certificates of Theorem 2, of words, of chaos, of ranges and of attractors: the reader that Coq has proved
//! takes what `grazing` writes, and has the checker's verdict on damaged files.

use std::fs;
use std::path::Path;
use std::process::Command;

use super::{oracle, sampled, sources};

/// Certificates that `grazing` writes: kind and arguments.
const WRITTEN: [&[&str]; 16] = [
    &["verify", "1..=9"],
    &["verify", "17..=18"],
    &["word", "--a1=-1/4", "--a2=1/2"],
    &["word", "--a1=1/2", "--a2=1/4"],
    &["word", "--a1=-3/2", "--a2=99/100", "--max-period=9"],
    &["word", "--a1=0.3..=0.301", "--a2=1/2"],
    &["word", "--a1=-1/4", "--a2=1/2", "--by-theorem"],
    &["word", "--a1=-3/2", "--a2=99/100", "--by-theorem"],
    &["word", "--a1=1", "--a2=1", "--by-theorem"],
    &["word", "--a1=0.3..=0.301", "--a2=1/2", "--by-theorem"],
    &["word", "--a1=-21/20..=-1", "--a2=1/5..=1/4", "--by-theorem"],
    &["word", "--a1=-21/20..=-1", "--a2=1/5..=0.3", "--by-theorem"],
    &["word", "--a1=3", "--a2=1/2", "--by-theorem"],
    &["word", "--r=9/10", "--s=10/27"],
    &["word", "--r=9/10", "--s=10/27", "--by-theorem"],
    &["word", "--r=1", "--s=7/24", "--by-theorem", "--letters=6"],
];

/// Damaged files of each certificate: in `.ci/full` ten times as many.
fn damages() -> usize {
    if sampled() { 150 } else { 1500 }
}

#[test]
fn the_proved_reader_has_the_verdicts_of_the_checker() {
    let Some(build) = oracle() else { return };
    let folder = build.join("certificates");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let mut state = 0x1234_5678_9abc_def1_u64;
    let mut below = |bound: usize| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as usize % bound
    };
    let mut counts = [0_usize; 3];
    for (i, arguments) in WRITTEN.iter().enumerate() {
        let path = folder.join(format!("{i}.txt"));
        let output = Command::new(env!("CARGO_BIN_EXE_grazing"))
            .args(*arguments)
            .arg("--certificate")
            .arg(&path)
            .output()
            .unwrap();
        assert!(matches!(output.status.code(), Some(0 | 3)), "{arguments:?}: {output:?}");
        let text = fs::read_to_string(&path).unwrap();
        assert_eq!(read(&build, std::slice::from_ref(&text), &folder), ["proved"], "{arguments:?}");
        let lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let damaged: Vec<String> = (0..damages()).map(|_| damage(&lines, &mut below)).collect();
        for (text, verdict) in damaged.iter().zip(read(&build, &damaged, &folder)) {
            let checked = grazing_check::check(&mut text.as_bytes());
            if verdict.starts_with("not read") {
                counts[2] += 1;
                continue;
            }
            assert_eq!(verdict == "proved", checked.is_ok(), "{verdict}; {checked:?}\n{text}");
            counts[usize::from(checked.is_err())] += 1;
        }
    }
    println!("damaged files that are still true, refused, of another kind: {counts:?}");
    assert!(counts[0] >= 20 && counts[1] >= 1000 && 50 * counts[2] <= counts[1], "{counts:?}");
}

/// `grazing-check --proved` says of each sample what both say.
#[test]
fn the_checker_asks_the_proved_reader() {
    let Some(build) = oracle() else { return };
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let checker = Path::new(env!("CARGO_BIN_EXE_grazing")).with_file_name("grazing-check");
    if !checker.is_file() {
        let built =
            Command::new(env!("CARGO")).args(["build", "-p", "grazing-check"]).current_dir(root).status();
        assert!(built.unwrap().success());
    }
    let path = std::env::join_paths([build]).unwrap();
    let mut codes = [0; 4];
    for file in fs::read_dir(root.join("crates/checker/tests/data")).unwrap() {
        let file = file.unwrap().path();
        let output = Command::new(&checker).arg("--proved").arg(&file).env("PATH", &path).output().unwrap();
        let text = String::from_utf8(output.stdout).unwrap();
        let (checked, code) = (!text.contains(": rejected"), output.status.code().unwrap());
        assert_eq!(checked, text.contains("\n  by the proved reader: "), "{text}");
        assert_eq!(code == 0, text.ends_with(": proved\n"), "{text}");
        assert!(if checked { matches!(code, 0 | 3) } else { code == 1 }, "{text}");
        codes[code as usize] += 1;
    }
    println!("proved by both, rejected by the checker, read in part or not: {codes:?}");
    // Rejected are two that are false, and the file that says what lies there.
    assert!(codes[0] >= 6 && codes[1] == 3 && codes[3] >= 10, "{codes:?}");
}

/// Certificates of chaos: what is true of the motions and the growth is proved, and where a box, the range of
/// ν or the contraction is too small for the theorem, the growth is another, or the file ends elsewhere, both
/// readers refuse.
#[test]
fn the_proved_reader_has_the_verdicts_of_the_checker_on_chaos() {
    let Some(build) = oracle() else { return };
    let folder = build.join("chaos");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let scene = root.join("examples/scenes/nordmark-2001-chaos.toml");
    let output =
        Command::new(env!("CARGO_BIN_EXE_grazing")).arg("run").arg(scene).arg("-o").arg(&folder).output();
    let output = output.unwrap();
    assert!(output.status.success(), "{output:?}");
    // Not `further`: its letters are told apart by what follows, too finely for the proved function.
    let names = ["always", "before", "cell", "faster", "few", "figure10", "softer"];
    let texts: Vec<String> = names
        .iter()
        .map(|name| fs::read_to_string(folder.join(format!("{name}.certificate"))).unwrap())
        .collect();
    let (motions, others) = ("proved; reach, entropy: not read", "proved; reach, entropy, others: not read");
    for (text, verdict) in texts.iter().zip(read(&build, &texts, &folder)) {
        let claimed = !text.contains("\ncomplete no\n");
        assert_eq!(verdict, if claimed { others } else { motions }, "{text}");
    }

    let mut damaged = Vec::new();
    for (name, proved) in [("chaos-12.txt", motions), ("chaos-123.txt", others)] {
        let text = fs::read_to_string(root.join("crates/checker/tests/data").join(name)).unwrap();
        assert_eq!(read(&build, std::slice::from_ref(&text), &folder), [proved], "{name}");
        damaged.extend(false_ends(&text));
        let lines: Vec<&str> = text.lines().collect();
        let mut change = |at: usize, place: usize, word: String| {
            let mut words: Vec<&str> = lines[at].split(' ').collect();
            words[place] = &word;
            let line = words.join(" ");
            let mut lines = lines.clone();
            lines[at] = &line;
            damaged.push(lines.join("\n") + "\n");
        };
        for (at, line) in lines.iter().enumerate() {
            let words: Vec<&str> = line.split(' ').collect();
            match words[0] {
                // Each end of each box moved to its middle.
                "letter" => {
                    for place in 2..6 {
                        let of = |i: usize| words[i].parse::<f64>().unwrap();
                        let middle = (of(place) + of(place ^ 1)) / 2.0;
                        change(at, place, format!("{middle:.7}").trim_end_matches('0').to_owned());
                    }
                }
                "contraction" => change(at, 1, "0.1".to_owned()),
                "restitution" => change(at, 1, "1/9".to_owned()),
                "depth" if words[2] != "1/1" => change(at, 2, "1/10".to_owned()),
                _ => {}
            }
        }
    }
    for (text, verdict) in damaged.iter().zip(read(&build, &damaged, &folder)) {
        let checked = grazing_check::check(&mut text.as_bytes());
        assert!(verdict.starts_with("refused") && checked.is_err(), "{verdict}; {checked:?}\n{text}");
    }
    assert!(damaged.len() >= 24, "{}", damaged.len());
}

/// Certificates of ranges: each sample's motions are proved, and where a range, a weight, the contraction,
/// the window, the steps of a link or the machine is wrong for the theorem both readers refuse. Of the 200
/// such files `.ci/run` tries every fifth, `.ci/full` all.
#[test]
fn the_proved_reader_has_the_verdicts_of_the_checker_on_ranges() {
    let Some(build) = oracle() else { return };
    let folder = build.join("ranges");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let data = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../checker/tests/data"));
    let others = "proved; continuity, entropy, others: not read";
    let motions = "proved; continuity, entropy: not read";
    let mut damaged = Vec::new();
    for (name, proved) in
        [("1", motions), ("12", motions), ("13", motions), ("alone", others), ("before", others)]
    {
        let text = fs::read_to_string(data.join(format!("range-{name}.txt"))).unwrap();
        assert_eq!(read(&build, std::slice::from_ref(&text), &folder), [proved], "{name}");
        damaged.extend(false_ends(&text));
        damaged.extend(damaged_ranges(&text));
    }
    // In how many pieces the checker is to prove the gap is nothing to the proved function, nor is S.
    let alone = fs::read_to_string(data.join("range-alone.txt")).unwrap();
    let unheeded = [("\npieces 32\n", "\npieces 1\n"), ("\nothers 3 2 1\n", "\nothers 1 2 1\n")];
    let unheeded = unheeded.map(|(old, new)| alone.replace(old, new));
    assert!(unheeded.iter().all(|changed| *changed != alone));
    assert_eq!(read(&build, &unheeded, &folder), [others; 2]);
    assert!(damaged.len() >= 150, "{}", damaged.len());
    let damaged: Vec<String> = damaged.into_iter().step_by(if sampled() { 5 } else { 1 }).collect();
    for (text, verdict) in damaged.iter().zip(read(&build, &damaged, &folder)) {
        let checked = grazing_check::check(&mut text.as_bytes());
        assert!(verdict.starts_with("refused") && checked.is_err(), "{verdict}; {checked:?}\n{text}");
    }
}

/// What `grazing run` writes for README's machine: an orbit up to where it nearly meets its stop between two
/// impacts, so that only where the gap rises and falls is known; and strengths in six parts, which must be.
#[test]
fn the_proved_reader_follows_a_range_to_its_end() {
    let Some(build) = oracle() else { return };
    let folder = build.join("ranges-to-the-end");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let data = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../checker/tests/data"));
    let [three, parts] =
        ["3", "parts"].map(|name| fs::read_to_string(data.join(format!("range-{name}.txt"))).unwrap());
    let all = [three.clone(), parts.clone()];
    assert_eq!(read(&build, &all, &folder), ["proved; continuity, entropy: not read"; 2]);
    assert!(all.iter().all(|text| grazing_check::check(&mut text.as_bytes()).is_ok()));
    let changes = [
        // The gap is not positive for all of these strengths.
        (
            &three,
            "\ncell 203403/1000000 1 10\nedge 2.284476512 2.284579894 ",
            "\ncell 1021/5000 1 10\nedge 2.27 2.3 ",
        ),
        (&parts, "\ncell 1/20 6 0\n", "\ncell 1/20 1 0\n"),
        // The former cell's ranges are in the latter's only after steps.
        (&parts, "\ncell 1029/16000 1 10\n", "\ncell 1029/16000 1 1\n"),
    ];
    let damaged: Vec<String> = changes.iter().map(|(text, old, new)| text.replace(old, new)).collect();
    assert!(damaged.iter().all(|text| !all.contains(text)));
    for (text, verdict) in damaged.iter().zip(read(&build, &damaged, &folder)) {
        let checked = grazing_check::check(&mut text.as_bytes());
        assert!(verdict.starts_with("refused") && checked.is_err(), "{verdict}; {checked:?}\n{text}");
    }
}

/// Certificates of attractors: each sample is proved, and where a number of it is less or more both readers
/// have the same verdict.
#[test]
fn the_proved_reader_has_the_verdicts_of_the_checker_on_attractors() {
    let Some(build) = oracle() else { return };
    let folder = build.join("attractors");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let data = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../checker/tests/data"));
    let proved = "proved";
    let mut damaged = Vec::new();
    for name in ["attractor", "attractor-wide", "attractor-several"] {
        let text = fs::read_to_string(data.join(format!("{name}.txt"))).unwrap();
        assert_eq!(read(&build, std::slice::from_ref(&text), &folder), [proved], "{name}");
        damaged.extend(damaged_attractors(&text));
    }
    let mut counts = [0_usize; 2];
    for (text, verdict) in damaged.iter().zip(read(&build, &damaged, &folder)) {
        let checked = grazing_check::check(&mut text.as_bytes());
        assert_eq!(verdict == proved, checked.is_ok(), "{verdict}; {checked:?}\n{text}");
        assert!(verdict == proved || verdict.starts_with("refused"), "{verdict}\n{text}");
        counts[usize::from(checked.is_err())] += 1;
    }
    println!("damaged attractors that are still true, refused: {counts:?}");
    assert!(counts[0] >= 40 && counts[1] >= 100, "{counts:?}");
}

/// What is quoted in the headline before each part of it is what the checker prints, from the trap on.
#[test]
fn the_headline_has_the_words_of_the_checker_on_attractors() {
    let headline = sources().remove("Headline.v").unwrap();
    let (_, record) = headline.split_once("Record attracts").unwrap();
    let quoted: Vec<&str> = record.split('"').skip(1).step_by(2).flat_map(str::split_whitespace).collect();
    let (_, said) = grazing_check::attractor::STATEMENT.split_once(" Then ").unwrap();
    let (said, _) = said.split_once(" It is not said").unwrap();
    assert_eq!(quoted.join(" ").to_lowercase(), said.to_lowercase());
}

/// One number of a certificate of an attractor made less or more, in many ways; and other ends.
fn damaged_attractors(text: &str) -> Vec<String> {
    let lines: Vec<&str> = text.lines().collect();
    let shorter = text.trim_end().rsplit_once('\n').unwrap().0;
    let mut damaged = vec![format!("{shorter}\n"), format!("{text}\n"), format!("{text}junk\n")];
    for (at, line) in lines.iter().enumerate() {
        let words: Vec<&str> = line.split(' ').collect();
        if ["grazing-certificate", "kind", "statement", "harmonics", "pieces"].contains(&words[0])
            || line == &"exponent none"
        {
            continue;
        }
        for place in 1..words.len() {
            let changed: Vec<String> = match (words[0], place) {
                // The ends of its ranges in the wrong order.
                ("harmonic", 3 | 5) => vec!["-1/1".into()],
                ("harmonic", _) => vec![],
                ("growth", 2) => vec!["1".into(), "3".into(), "100".into()],
                ("exponent", 3) => ["1", "8", "30", "100"].map(String::from).into(),
                _ => [[1, 2], [9, 10], [999, 1000], [1001, 1000], [11, 10], [2, 1]]
                    .map(|factor| scaled(words[place], factor))
                    .into(),
            };
            for word in changed {
                let mut words = words.clone();
                words[place] = &word;
                let line = words.join(" ");
                let mut lines = lines.clone();
                lines[at] = &line;
                damaged.push(lines.join("\n") + "\n");
            }
        }
    }
    damaged
}

/// A fraction or a decimal, times a fraction.
fn scaled(word: &str, [p, q]: [i64; 2]) -> String {
    match word.split_once('/') {
        Some((a, b)) => {
            let (a, b) = (a.parse::<i64>().unwrap() * p, b.parse::<i64>().unwrap() * q);
            let (mut d, mut r) = (a, b);
            while r != 0 {
                (d, r) = (r, d % r);
            }
            format!("{}/{}", a / d, b / d)
        }
        None => {
            let x = word.parse::<f64>().unwrap() * p as f64 / q as f64;
            format!("{x:.9}").trim_end_matches('0').trim_end_matches('.').to_owned()
        }
    }
}

/// Growth that is not, to either side, a file cut short, and one that goes on.
fn false_ends(text: &str) -> Vec<String> {
    let (before, line) = text.split_once("\ngrowth ").unwrap();
    let (rates, after) = line.split_once('\n').unwrap();
    let (lo, hi) = rates.split_once(' ').unwrap();
    let rate = |word: &str| word.parse::<f64>().unwrap();
    let with = |lo: &str, hi: &str| format!("{before}\ngrowth {lo} {hi}\n{after}");
    let above = format!("{:.6}1", rate(hi) + 0.01);
    let mut ends = vec![with(hi, &above), with(&format!("{:.6}1", rate(hi) + 0.005), &above)];
    if rate(lo) > 1.01 {
        ends.push(with("1", &format!("{:.6}1", rate(lo) - 0.005)));
    }
    let shorter = text.trim_end().rsplit_once('\n').unwrap().0;
    ends.extend([format!("{shorter}\n"), format!("{text}\n"), format!("{text}junk\n")]);
    ends
}

/// One word of a certificate of a range made wrong, in many ways.
fn damaged_ranges(text: &str) -> Vec<String> {
    let lines: Vec<&str> = text.lines().collect();
    let mut damaged = Vec::new();
    let last = lines.iter().rposition(|line| line.starts_with("cell "));
    for (at, line) in lines.iter().enumerate() {
        let words: Vec<&str> = line.split(' ').collect();
        let middle = |i: usize, j: usize| {
            let of = |i: usize| words[i].parse::<f64>().unwrap();
            format!("{:.7}", (of(i) + of(j)) / 2.0).trim_end_matches('0').to_owned()
        };
        let changes: Vec<(usize, String)> = match words[0] {
            // Each end of a range to its middle; of a cell's first both exchanged, m 0 or too large, w 0.
            "edge" => {
                let first = lines[at - 1].starts_with(['c', 'o']);
                let turned = [(1, words[2].into()), (2, words[1].into())];
                let wrong = [(3, "0".into()), (3, "2.5".into()), (4, "0".into()), (4, "-1".into())];
                let wrong = turned.into_iter().chain(wrong).filter(|_| first);
                [(1, middle(1, 2)), (2, middle(1, 2))].into_iter().chain(wrong).collect()
            }
            "contraction" => ["0.1", "1", "0"].map(|word| (1, word.into())).into(),
            "restitution" => [(1, "1/9".into()), (1, "0/1".into())].into(),
            "window" => ["0.001", "1.6", "0"].map(|word| (1, word.into())).into(),
            "side" => [(1, words[1].strip_prefix('-').map_or("-1".into(), str::to_owned))].into(),
            "harmonic" => [(3, "9/10".into()), (5, "-1/10".into())].into(),
            // An edge is gone, or one too many.
            "next" if words.len() > 2 => [(0, "next".into())].into(),
            // In range-12 the former cell's ranges are in the latter's.
            "cell" if words[3] != "0" && text.contains("\nletters 1\n") => [(3, "0".into())].into(),
            "cell" if Some(at) == last => [(1, "2/1".into()), (2, "0".into())].into(),
            _ => Vec::new(),
        };
        for (place, word) in changes {
            let mut words = words.clone();
            if words[0] == "next" {
                words.pop();
            }
            words[place] = &word;
            let line = words.join(" ");
            let mut lines = lines.clone();
            lines[at] = &line;
            damaged.push(lines.join("\n") + "\n");
        }
    }
    damaged
}

/// One or two words, marks or lines changed.
fn damage(lines: &[String], below: &mut impl FnMut(usize) -> usize) -> String {
    let mut lines = lines.to_vec();
    for _ in 0..=below(2) {
        // Rarely the head.
        let first = if below(8) == 0 || lines.len() < 7 { 0 } else { 5 };
        let at = first + below(lines.len() - first);
        let other = 5.min(lines.len() - 1);
        let other = other + below(lines.len() - other);
        match below(10) {
            0 => drop(lines.remove(at)),
            1 => lines.insert(at, lines[other].clone()),
            2 => lines.swap(at, other),
            // A mark or a letter.
            3..=5 => {
                let marks = ["+", "-", "?", "U", "D"];
                let places: Vec<usize> =
                    lines[at].char_indices().filter(|(_, c)| "+-?UD".contains(*c)).map(|(i, _)| i).collect();
                if let Some(&place) = places.get(below(places.len().max(1))) {
                    lines[at].replace_range(place..=place, marks[below(marks.len())]);
                }
            }
            _ => {
                let mut words: Vec<String> = lines[at].split(' ').map(str::to_owned).collect();
                let place = below(words.len());
                let from: Vec<&str> = lines[other].split(' ').collect();
                words[place] = match words[place].parse::<u64>() {
                    Ok(number) if below(3) > 0 => {
                        (number + 2 * below(2) as u64).saturating_sub(1).to_string()
                    }
                    _ => from[below(from.len())].to_owned(),
                };
                lines[at] = words.join(" ");
            }
        }
    }
    lines.join("\n") + "\n"
}

/// What the reader prints of each text.
fn read(build: &Path, texts: &[String], folder: &Path) -> Vec<String> {
    let mut command = Command::new(build.join("grazing-proved"));
    for (i, text) in texts.iter().enumerate() {
        let path = folder.join(format!("damaged-{i}.txt"));
        fs::write(&path, text).unwrap();
        command.arg(path);
    }
    let output = command.output().unwrap();
    assert!(output.status.success(), "{output:?}");
    let answers: Vec<String> = String::from_utf8(output.stdout).unwrap().lines().map(str::to_owned).collect();
    assert_eq!(answers.len(), texts.len());
    answers
}
