//! The surface that a reader prints and types: tables that LaTeX sets, commands that the pages print, inputs
//! that are wrong.

use crate::process;

use std::{
    env, fs, io,
    path::Path,
    process::{Command, Output},
};

use process::run;

pub fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// What Python says to these arguments, run in a folder.
pub fn python(folder: &Path, arguments: &[&str]) -> io::Result<Output> {
    Command::new("python3").args(arguments).current_dir(folder).output()
}

/// Every command that writes a LaTeX table, with the awkward texts among them; `{in}` is a folder with the
/// certificates that are cited.
const TABLES: [&str; 28] = [
    "intervals 3..=9",
    "intervals 3..=9 --decimals 6",
    "intervals --two-impacts 5",
    "intervals --pattern 2,3 --decimals 4",
    "intervals --measure 3..=12",
    "word --a1 -1/4 --a2 1/2 --certificate {in}/word_1.txt",
    "word --a1 -26/100..=-1/4 --a2 1/2..=51/100",
    "word --r 0.97 --s 0.37",
    "word --r 0.97±1% --s 0.37..=0.38",
    "word --frequency 3.7Hz±1% --damping-ratio 0.1±20% --drive 10Hz --shares --cells 200",
    "word --frequency 3.7Hz±1% --damping-ratio 0.1 --drive 10Hz --decides --max-period 3",
    "classify --r 0.97+-1% --s 0.37",
    "word --r 1.25 --s 0.37 --returns",
    "word --r 0.97 --s 0.37 --returns",
    "boundary 3..=8",
    "boundary 5 --grid 3",
    "classify --r 0.99 --s 21/100",
    "classify --summary",
    "existence examples/maps/nordmark-2001.toml --max-period 5",
    "existence examples/maps/nordmark-2001.toml --max-period 5 --counts",
    "existence examples/maps/four-dimensional.toml --max-period 5",
    "existence examples/maps/singular.toml --max-period 4",
    "existence examples/maps/singular.toml --max-period 4 --uniform",
    "intervals 3..=5 --cite {in}/theorem_2#.txt --cite {in}/covers.txt",
    "boundary 3..=5 --cite {in}/covers.txt",
    "evaluate --n 5 --s 1/7 --r 0.9",
    "evaluate --n 4 --s 1/8 --bits 1000",
    "evaluate --n 1000000 --k 7 --a1 1.9999 --a2 1",
];

/// What is printed and is no table of rows.
const PRINTED: [&str; 7] = [
    "formula 9 4",
    "formula 60 7",
    "formula 12 --sentence --area 5+",
    "formula 7 --sentence",
    "run examples/scenes/nordmark-2001.toml --only period-6 --only proved-mu_gr3 -o {in}/run",
    "run examples/scenes/nordmark-2001-chaos.toml --only few -o {in}/chaos",
    "run {in}/seen.toml -o {in}/seen",
];

/// README's machine: what attracts beside the touch and at two loads, proved.
pub const SEEN: &str = r#"
format = "grazing-scene 1"
title = "what is seen"
[parameters]
F = 0.5
s = 0.3
[system]
damping = "1/10"
stiffness = "s"
forcing = [{ cos = "F" }]
[[walls]]
side = "upper"
offset = 1
restitution = 0.8
[[tasks]]
name = "touch"
kind = "grazing"
parameter = "F"
max_period = 2
prove = true
tolerance = { s = [0.28, 0.6] }
[[tasks]]
name = "loads"
kind = "diagram"
parameter = "F"
range = [0.4, 0.8]
count = 2
starts = [{ q = 0 }]
points = 20
transient = 300
prove = true
"#;

/// What every printed table and formula is set with. Without siunitx its command is a stand-in.
const PREAMBLE: &str = "\\documentclass[a4paper]{article}\\usepackage{amsmath,array,booktabs,longtable}\n\
    \\IfFileExists{siunitx.sty}{\\usepackage{siunitx}}{\\newcommand\\num[1]{$##1$}}\\begin{document}\n";

/// What would stop LaTeX is looked for by hand; with `GRAZING_REQUIRE_LATEX=1` `pdflatex` sets every table,
/// with siunitx and without it, and none is wider than the text of an A4 page.
#[test]
fn latex_sets_every_table() {
    let folder = tempfile::tempdir().unwrap();
    for arguments in ["verify 3..=5 --certificate theorem_2#.txt", "cover 3..=5 --certificate covers.txt"] {
        assert_eq!(run(arguments, folder.path()).0, 0);
    }
    fs::write(folder.path().join("seen.toml"), SEEN).unwrap();
    let mut cited = 0;
    let mut document = String::from(PREAMBLE);
    let formats = TABLES.iter().flat_map(|table| {
        // What `evaluate` prints runs over many lines, which \num does not.
        let siunitx = (!table.starts_with("evaluate")).then_some((table, "latex-siunitx"));
        [(table, "latex")].into_iter().chain(siunitx)
    });
    for (index, (arguments, format)) in formats.enumerate() {
        let file = folder.path().join(format!("table{index}.tex"));
        let arguments = &arguments.replace("{in}", &folder.path().display().to_string());
        let all = format!("{arguments} --format {format} -o {}", file.display());
        let (code, _, err) = run(&all, root());
        // A table of patterns may leave some undecided: 3.
        assert!(code == 0 || code == 3, "grazing {all}: {code} {err}");
        let text = fs::read_to_string(&file).unwrap();
        cells_are_balanced(arguments, &text);
        is_for_a_journal(&all, &text);
        if arguments.contains("--certificate") {
            let caption = text.replace("\\allowbreak ", "");
            let digest = digest("word_1.txt", folder.path());
            assert!(
                caption.contains(&format!("\\texttt{{word\\_1.txt}}, SHA-256 \\texttt{{{digest}}}")),
                "{caption}"
            );
            cited += 1;
        }
        document += &format!("\\input{{table{index}}}\n");
    }
    for (index, arguments) in PRINTED.iter().enumerate() {
        let all =
            format!("{} --format latex", arguments.replace("{in}", &folder.path().display().to_string()));
        let (code, text, err) = run(&all, root());
        assert_eq!(code, 0, "grazing {all}: {err}");
        fs::write(folder.path().join(format!("printed{index}.tex")), &text).unwrap();
        document += &format!("\\input{{printed{index}}}\n");
        // Every certificate is cited by the digest of the file that was written.
        for line in text.lines().filter(|line| line.starts_with("certificate & ")) {
            let name = line.split("\\texttt{").nth(1).unwrap().split('}').next().unwrap();
            let place = arguments.rsplit('/').next().unwrap();
            let digest = digest(&format!("{place}/{name}"), folder.path());
            assert!(line.replace("\\allowbreak ", "").contains(&format!("\\texttt{{{digest}}}")), "{line}");
            cited += 1;
        }
    }
    assert!(cited >= 10, "{cited} certificates are cited");
    document += "\\end{document}\n";
    fs::write(folder.path().join("all.tex"), document).unwrap();
    if !crate::samples::asked("GRAZING_REQUIRE_LATEX", "the tables set by pdflatex") {
        return;
    }
    let latex = Command::new("pdflatex")
        .args(["-interaction=nonstopmode", "-halt-on-error", "all.tex"])
        .current_dir(folder.path())
        .output()
        .expect("pdflatex is on the path");
    let log = String::from_utf8_lossy(&latex.stdout);
    assert!(latex.status.success(), "{log}");
    assert!(!log.contains("Overfull"), "a table is too wide:\n{log}");
}

/// The SHA-256 of a file, by the system's own program.
fn digest(file: &str, folder: &Path) -> String {
    let (_, sum) = shell(&format!("sha256sum {file} || shasum -a 256 {file}"), folder);
    sum.split(' ').next().unwrap().to_string()
}

/// A caption, a label, rules by booktabs; cases as (−,+) and signs by name, never as columns of ±1; no
/// fraction with the denominator 1.
fn is_for_a_journal(command: &str, text: &str) {
    let printed: Vec<&str> = text.lines().filter(|line| !line.starts_with('%')).collect();
    let text = printed.join("\n");
    for needed in ["\\caption{", "}\\label{tab:", "\\toprule", "\\midrule", "\\bottomrule"] {
        assert!(text.contains(needed), "{command}: no {needed}");
    }
    for refused in ["sign} e\\mu$ &", "sign}\\gamma$ &", "$0/", "/1$", "/1}", "emu", "\\hline"] {
        assert!(!text.contains(refused), "{command}: {refused} in {text}");
    }
    let rows = text.lines().skip_while(|line| *line != "\\endfoot").skip(1);
    for cell in rows.flat_map(|row| row.split(" & ")).filter(|_| !command.starts_with("classify --summary")) {
        assert!(!["$-1$", "\\num{-1}"].contains(&cell), "{command}: {cell} in {text}");
    }
    assert_eq!(
        text.contains("\\num{"),
        command.contains("latex-siunitx") && !command.contains("--summary"),
        "{command}"
    );
}

/// What a caption cites is checked first, covers the table, and has the digest that `sha256sum` prints.
#[test]
fn a_certificate_is_checked_before_it_is_cited() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    for arguments in ["verify 3..=5 --certificate theorem2", "cover 3..=4 --certificate covers"] {
        assert_eq!(run(arguments, folder.path()).0, 0);
    }
    let text = fs::read_to_string(path("theorem2")).unwrap();
    fs::write(path("false"), text.replacen(" - +", " + +", 1)).unwrap();
    fs::write(path("longer"), text + "\n").unwrap();

    let (code, table, _) = run("intervals 3..=5 --format latex --cite theorem2", folder.path());
    let (_, sum) = shell("sha256sum theorem2 || shasum -a 256 theorem2", folder.path());
    let digest = sum.split(' ').next().unwrap();
    assert!(code == 0 && digest.len() == 64, "{sum}");
    assert!(table.replace("\\allowbreak ", "").contains(&format!("SHA-256 \\texttt{{{digest}}}")), "{table}");
    for part in ["\\caption{", "\\label{tab:intervals-3-5}", "of kind theorem2", "$n = 3, \\dots, 5$"] {
        assert!(table.contains(part), "{part}: {table}");
    }

    for (arguments, wanted, says) in [
        ("intervals 3..=5 --format latex --cite false", 1, "false cannot be cited: rejected: line "),
        ("intervals 3..=5 --format latex --cite longer", 1, "longer cannot be cited: rejected: line "),
        ("intervals 3..=5 --format latex --cite missing", 2, "cannot open missing"),
        ("intervals 3..=6 --format latex --cite theorem2", 2, "`grazing verify 3..=6 --certificate FILE`"),
        ("intervals 2..=5 --format latex --cite theorem2", 2, "list 3..=5"),
        ("intervals 3 --format latex --cite theorem2 --cite theorem2", 2, "second of kind theorem2"),
        ("intervals 3 --cite theorem2", 2, "only --format latex has a caption"),
        ("intervals 3 --format bfile --cite theorem2", 2, "only --format latex has a caption"),
        ("intervals --pattern 1,2 --format latex --cite theorem2", 2, "--pattern"),
        ("intervals 3 --format latex --cite theorem2 -o theorem2", 2, "theorem2"),
        ("boundary 3..=4 --format latex --cite theorem2", 2, "cite one of kind cover"),
        ("boundary 3..=5 --format latex --cite covers", 2, "`grazing cover 3..=5 --certificate FILE`"),
        ("boundary 3..=4 --format csv --cite covers", 2, "only --format latex has a caption"),
    ] {
        let (code, out, err) = run(arguments, folder.path());
        assert_eq!(code, wanted, "grazing {arguments}: {err}");
        assert!(out.is_empty() && err.contains(says), "grazing {arguments}: {out}{err}");
    }
    assert!(fs::read_to_string(path("theorem2")).unwrap().ends_with('\n'));
}

/// Each row has as many columns as the table, no special character bare, braces and dollars in pairs.
fn cells_are_balanced(what: &str, text: &str) {
    let shape = text.lines().find_map(|line| line.strip_prefix("\\begin{longtable}{")).unwrap();
    let rows = text.lines().filter(|line| line.ends_with("\\\\") && !line.starts_with("\\caption"));
    let rows: Vec<&str> = rows.collect();
    assert!(rows.len() > 1, "{what}: {text}");
    let columns = rows[0].matches(" & ").count();
    assert!(shape.len() > columns, "{what}: {shape}");
    for row in rows {
        assert_eq!(row.matches(" & ").count(), columns, "{what}: {row}");
        let (mut maths, mut depth, mut before) = (false, 0, ' ');
        for c in row.trim_end_matches("\\\\").chars() {
            let escaped = before == '\\';
            before = if escaped { ' ' } else { c };
            match c {
                _ if escaped => {}
                '$' => maths = !maths,
                '{' => depth += 1,
                '}' => depth -= 1,
                '_' | '^' | '<' | '>' | '|' => assert!(maths, "{what}: a bare {c} in {row}"),
                '#' | '%' | '~' => panic!("{what}: a bare {c} in {row}"),
                _ => assert!(c.is_ascii() || c.is_alphabetic(), "{what}: {c:?} in {row}"),
            }
        }
        assert!(!maths && depth == 0, "{what}: {row}");
    }
}

/// Runs a line as a shell would in this folder, `grazing` and `grazing-check` being the ones just built; its
/// exit code and what it printed.
fn shell(line: &str, folder: &Path) -> (i32, String) {
    let built = Path::new(crate::PROGRAM).parent().unwrap();
    let path = format!("{}:{}", built.display(), env::var("PATH").unwrap());
    let output =
        Command::new("sh").args(["-c", line]).current_dir(folder).env("PATH", path).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code().unwrap_or(-1), text(&output.stdout) + &text(&output.stderr))
}

/// A folder as a reader has it: the examples are there, and nothing else.
fn reader() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::os::unix::fs::symlink(root().join("examples"), folder.path().join("examples")).unwrap();
    folder
}

pub const COMMANDS: [&str; 22] = [
    "answer",
    "verify",
    "cover",
    "check",
    "merge",
    "intervals",
    "classify",
    "word",
    "decay",
    "existence",
    "fuzz",
    "farey",
    "boundary",
    "sequence",
    "figure",
    "formula",
    "evaluate",
    "accuracy",
    "run",
    "export",
    "completions",
    "man",
];

/// Every command's help has examples, and each runs as it is printed. Those of `accuracy` measure for long
/// and are only parsed.
#[test]
fn examples_in_the_help_run_as_printed() {
    let folder = reader();
    for command in COMMANDS {
        let (code, help, _) = run(&format!("{command} --help"), root());
        assert_eq!(code, 0);
        let examples =
            help.split("Examples:\n").nth(1).unwrap_or_else(|| panic!("{command} --help has no examples"));
        let lines: Vec<&str> = examples.lines().take_while(|line| line.starts_with("  grazing ")).collect();
        assert!(!lines.is_empty(), "{command}: {help}");
        for line in lines.iter().filter(|_| command != "accuracy") {
            let (code, printed) = shell(line, folder.path());
            assert_eq!(code, 0, "{line}: {printed}");
            assert!(!printed.contains("error"), "{line}: {printed}");
        }
    }
}

/// The commands that README and the pages print with a `$`, page by page and in order, in one folder per
/// page. What a page prints below a command is what comes.
#[test]
fn commands_on_the_pages_run_as_printed() {
    let mut pages = vec![root().join("README.md")];
    pages.extend(fs::read_dir(root().join("docs")).unwrap().map(|entry| entry.unwrap().path()));
    let mut ran = 0;
    for page in pages.iter().filter(|page| page.extension().is_some_and(|end| end == "md")) {
        let (folder, text) = (reader(), fs::read_to_string(page).unwrap());
        let mut lines = text.lines().peekable();
        while let Some(line) = lines.next() {
            // A file to save under the name that its first line gives.
            if line == "```toml"
                && let Some(name) = lines.peek().and_then(|first| first.strip_prefix("# "))
            {
                let file = folder.path().join(name);
                let body: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
                fs::write(file, body.join("\n")).unwrap();
                continue;
            }
            let Some(command) = line.strip_prefix("    $ ") else { continue };
            let mut wanted = String::new();
            while let Some(next) =
                lines.peek().and_then(|next| next.strip_prefix("    ")).filter(|next| !next.starts_with('$'))
            {
                wanted += next.trim_end();
                wanted += "\n";
                lines.next();
            }
            // Other people's programs may not be there.
            if ["z3", "qepcad", "sbatch"].iter().any(|tool| command.contains(tool)) {
                continue;
            }
            let (code, printed) = shell(command, folder.path());
            assert!(code == 0 || code == 1 || code == 3, "{}: {command}: {code} {printed}", page.display());
            if !wanted.is_empty() {
                let printed: String =
                    printed.lines().map(|line| line.trim_end().to_string() + "\n").collect();
                assert_eq!(printed, wanted, "{}: {command}", page.display());
            }
            ran += 1;
        }
    }
    assert!(ran >= 5, "{ran} commands on the pages");
}

/// No line of a help text is wider than a terminal of 100 columns.
#[test]
fn help_fits_a_terminal() {
    for command in COMMANDS {
        let (_, help, _) = run(&format!("{command} --help"), root());
        for line in help.lines() {
            assert!(line.chars().count() <= 100, "{command}: {line}");
        }
    }
}

/// The list of commands, by question, has each command once; the help of `word` is at most 300 words.
#[test]
fn help_is_by_question_and_short() {
    let (code, help, _) = run("--help", root());
    assert_eq!(code, 0);
    let listed = help.lines().filter_map(|line| line.strip_prefix("  ")?.split(' ').next());
    let mut listed: Vec<&str> = listed.filter(|word| COMMANDS.contains(word)).collect();
    listed.sort_unstable();
    let mut all = COMMANDS.to_vec();
    all.sort_unstable();
    assert_eq!(listed, all);
    let (_, help, _) = run("word --help", root());
    assert!(help.split_whitespace().count() <= 300, "{}", help.split_whitespace().count());
}

/// Completions name every command, and the manual has a page for each.
#[test]
fn completions_and_manual_know_every_command() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let (code, script, _) = run(&format!("completions {name}"), folder.path());
        assert_eq!(code, 0);
        assert!(COMMANDS.iter().all(|command| script.contains(command)), "{name}");
    }
    let (code, ..) = run("man -o pages", folder.path());
    assert_eq!(code, 0);
    for command in COMMANDS {
        let page = fs::read_to_string(folder.path().join(format!("pages/grazing-{command}.1"))).unwrap();
        assert!(page.contains("Examples:") && page.contains(".SH OPTIONS"), "{command}");
    }
}

/// What nobody may answer a count with, a range of periods, an exact number, a choice, an output file, an
/// input file.
const COUNT: &[&str] =
    &["", "x", "1.5", "1e99", "99999999999999999999999", "1/0", "nan", "0x10", "٣", "1 2", "-7"];
const RANGE: &[&str] = &[
    "",
    "x",
    "0",
    "3..8",
    "8..=3",
    "3..=",
    "..=8",
    "3..=x",
    "18446744073709551616",
    "1.5",
    "3..=4..=5",
    "3--8",
];
const NUMBER: &[&str] =
    &["", "x", "1/0", "2^9999999999", "1e400000", "0x10", "1//2", "∞", "nan", "1/2/3", "2^2^9", "½"];
const CHOICE: &[&str] = &["", "foo", "TEXT", "jsonn"];
const OUTPUT: &[&str] = &["", "/nonexistent/file", "/dev/null/file", "."];
const SHARD: &[&str] =
    &["", "x", "1", "0/3", "4/3", "1/0", "-1/3", "1/", "/3", "1/2/3", "1.5/3", "1/99999999999999999999"];
const INPUT: &[&str] = &["", "/nonexistent/file", ".", "/dev/null"];

const MEASURE: &[&str] =
    &["", "x", "Hz", "1Hz2", "-1Hz", "1Hz±", "1Hz±-1%", "1Hz..=2", "2Hz..=1Hz", "1Hz±1kHz", "1Hz±200%", "1m"];

/// A command that would be right, with a hole `@`, and what must not be put there.
const HOLES: &[(&str, &[&str])] = &[
    ("verify @", RANGE),
    ("verify 3 --jobs @", COUNT),
    ("verify 3 --method @", CHOICE),
    ("verify 3 --format @", CHOICE),
    ("verify 3 --certificate @", OUTPUT),
    ("verify 3 -o @", OUTPUT),
    ("cover @", RANGE),
    ("cover 3 --r-max @", NUMBER),
    ("cover 3 --max-depth @", COUNT),
    ("cover 3 --jobs @", COUNT),
    ("cover 3 --format @", CHOICE),
    ("cover 3 --certificate @", OUTPUT),
    ("cover 3 --resume @", OUTPUT),
    ("check @", INPUT),
    ("check --format @ /dev/null", CHOICE),
    ("intervals @", RANGE),
    ("intervals 3 --digits @", COUNT),
    ("intervals 3 --decimals @", COUNT),
    ("intervals 3 --format @", CHOICE),
    ("intervals 3 -o @", OUTPUT),
    (
        "intervals --pattern @",
        &["", "x", "3", "3,", "3,5,7", "0,3", "3.5,1", "-3,5", "99999999999999999999,1"],
    ),
    ("intervals --two-impacts @", RANGE),
    ("classify --r @ --s 1/5", NUMBER),
    ("classify --r 1/2 --s @", NUMBER),
    ("classify --a1 @ --a2 1/2", NUMBER),
    ("classify --a1 1 --a2 @", NUMBER),
    ("classify --r 1/2 --s 1/5 --max-period @", COUNT),
    ("classify --r 1/2 --s 1/5 --max-n @", COUNT),
    ("classify --r 1/2 --s 1/5 --format @", CHOICE),
    ("word --r @ --s 1/5", NUMBER),
    ("word --r 1/2 --s @", NUMBER),
    ("word --r 1/2 --s 1/5 --max-period @", COUNT),
    ("word --r 1/2±1% --s 1/5 --shares --cells @", COUNT),
    ("word --r 1/2 --s 1/5 --decides --cells @", COUNT),
    ("word --samples @", INPUT),
    ("word --frequency @ --damping-ratio 0.1 --drive 10Hz", MEASURE),
    ("word --frequency 3Hz --damping-ratio @ --drive 10Hz", MEASURE),
    ("word --frequency 3Hz --damping-ratio 0.1 --drive @", MEASURE),
    ("word --r 1/2 --s 1/5 --letters @", COUNT),
    ("decay @", INPUT),
    ("decay examples/decay.csv --column @", &["", "x", "time"]),
    ("decay examples/decay.csv --from @", &["", "x", "nan", "inf", "1/2", "1e400", "9"]),
    ("decay examples/decay.csv --until @", &["", "x", "nan", "-1"]),
    ("decay examples/decay.csv --unit @", CHOICE),
    ("decay examples/decay.csv --format @", CHOICE),
    ("existence @", INPUT),
    ("existence examples/maps/focus.toml --max-period @", COUNT),
    ("existence examples/maps/focus.toml --pattern @", &["", "x", "0", "1,", "1,x", "-1", "1,0"]),
    ("existence examples/maps/focus.toml --format @", CHOICE),
    ("existence examples/maps/focus.toml --dot @", OUTPUT),
    ("fuzz --cases @", COUNT),
    ("fuzz --cases 10 --seed @", COUNT),
    ("fuzz @ --cases 10", RANGE),
    ("fuzz --cases 10 --n @", RANGE),
    ("fuzz --cases 10 --definition-share @", &["", "x", "2", "-1", "nan", "inf"]),
    ("fuzz --cases 10 --regressions @", OUTPUT),
    ("fuzz --cases 10 --resume @", OUTPUT),
    ("farey neighbours @", NUMBER),
    ("farey rank @ 5", NUMBER),
    ("farey rank 1/2 @", COUNT),
    ("farey kth @ 5", COUNT),
    ("farey kth 3 @", COUNT),
    ("farey walk @", &["", "x", "1.5", "1/0", "0", "-1"]),
    ("farey walk 5 --from @", NUMBER),
    ("farey walk 5 --to @", NUMBER),
    ("boundary @", RANGE),
    ("boundary 5 --m @", COUNT),
    ("boundary 5 --grid @", COUNT),
    ("boundary 5 --digits @", COUNT),
    ("boundary 5 --format @", CHOICE),
    ("boundary 5 --format latex --cite @", INPUT),
    ("intervals 5 --format latex --cite @", INPUT),
    ("merge @ -o out", INPUT),
    ("merge examples/maps/focus.toml -o @", OUTPUT),
    ("merge examples/maps/focus.toml --format @ -o out", CHOICE),
    ("verify 3..=8 --certificate part --shard @", SHARD),
    ("cover 3..=4 --certificate part --shard @", SHARD),
    ("fuzz --cases 100 -o part --shard @", SHARD),
    ("boundary 5 -o part --shard @", SHARD),
    ("intervals 5 -o part --shard @", SHARD),
    ("run tests/data/kinds.toml --only basins -o part --shard @", SHARD),
    ("merge --files-from @ -o out", INPUT),
    ("fuzz --words --cases @", COUNT),
    ("figure @", CHOICE),
    ("figure intervals @ -o out", COUNT),
    ("figure intervals --n @ -o out", COUNT),
    ("figure records --r @ --s 1/5 -o out", NUMBER),
    ("figure records --r 1/2 --s @ -o out", NUMBER),
    ("figure tolerance --frequency @ --damping-ratio 0.1 --drive 10Hz -o out", MEASURE),
    ("figure intervals -o @", &["/dev/null/file", "/proc/file"]),
    ("formula @ 1", COUNT),
    ("formula 3 @", COUNT),
    ("formula 5 --sentence --area @", &["", "x", "2", "2*", "0+", "9+", "region5"]),
    ("formula 5 2 --format @", CHOICE),
    ("evaluate @ --s 1/7", COUNT),
    ("evaluate 5 @ --s 1/7", COUNT),
    ("evaluate --n @ --s 1/7", COUNT),
    ("evaluate --n 5 --k @ --s 1/7", COUNT),
    ("evaluate --n 5 --s @", NUMBER),
    ("evaluate --n 5 --s 1/7 --r @", NUMBER),
    ("evaluate --n 5 --s 1/7 --bits @", COUNT),
    ("accuracy --of @", CHOICE),
    ("accuracy -o @", &["/dev/null/file"]),
    ("run @", INPUT),
    ("run examples/scenes/free.toml --only @", CHOICE),
    ("run examples/scenes/free.toml --set @", &["", "x", "x=1", "w=", "w=x", "w=1/0", "=1", "w==1"]),
    ("run examples/scenes/free.toml --format @", CHOICE),
    ("run examples/scenes/free.toml --jobs @", COUNT),
    ("run examples/scenes/free.toml -o @", &["/dev/null/file"]),
    ("figure 6 -o out --x-limits @", &["", "x", "1", "2..=1", "1..2", "1/0..=1", "-1"]),
    ("run examples/scenes/free.toml --y-limits @", &["", "x", "-1/2", "2..=1", "1..2", "0..=1"]),
    ("export @ -o table.mat", INPUT),
    ("export ball.csv -o @", &["", "table.txt", "b.", "/nonexistent/table.mat"]),
    ("completions @", CHOICE),
    ("man -o @", &["/dev/null/file"]),
    ("@", CHOICE),
];

/// More than 400 wrong inputs: each ends with exit code 2 (a certificate that is none: 1), nothing on
/// standard output, and an error that begins with the word, names the value or what it is for, and speaks
/// neither of Rust nor of its types.
#[test]
fn wrong_inputs_are_named() {
    let folder = reader();
    let mut tried = 0;
    for (line, values) in HOLES {
        for value in *values {
            let mut command = Command::new(crate::PROGRAM);
            command.current_dir(folder.path());
            command.args(line.split(' ').map(|word| if word == "@" { value } else { word }));
            let (code, out, err) = process::ended(command.output().unwrap());
            let what = format!("grazing {} with {value:?}: {code} {out}{err}", line.replace('@', "…"));
            let no_certificate = (line.starts_with("check") || line.contains("--cite")) && code == 1;
            assert!(code == 2 || no_certificate, "{what}");
            assert!(out.is_empty() || line.starts_with("check"), "{what}");
            assert!(err.starts_with("error: ") || no_certificate, "{what}");
            for jargon in [
                "panicked",
                "invalid digit",
                "target type",
                "cannot parse",
                "ParseInt",
                "from empty string",
                "ParseFloat",
                "Some(",
                "None",
            ] {
                assert!(!err.contains(jargon), "{what}");
            }
            let option = line.split(' ').rev().skip_while(|word| *word != "@").nth(1).unwrap_or("");
            let named = if value.is_empty() {
                err.contains("''") || err.contains("\"\"")
            } else {
                err.contains(value.split(['+', '=']).next().unwrap())
            };
            assert!(
                named
                    || !option.is_empty() && err.contains(option)
                    || no_certificate
                    || err.contains("required"),
                "{what}"
            );
            tried += 1;
        }
    }
    assert!(tried >= 400, "{tried}");
    println!("{tried} wrong inputs, each named");
}

/// The named constants of the half that simulates that are tolerances: file, name, value.
fn tolerances(top: &Path, folder: &Path, found: &mut Vec<[String; 3]>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.strip_prefix(top).unwrap().to_string_lossy().replace('\\', "/");
        if path.is_dir() {
            tolerances(top, &path, found);
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        let code = text.split("#[cfg(test)]").next().unwrap();
        for line in code.lines().map(str::trim).filter(|line| !line.starts_with("//")) {
            let constant = line.split_once("const ").and_then(|(_, rest)| rest.split_once(": f64 = "));
            let Some((constant, value)) = constant else { continue };
            let value = value.trim_end_matches(';').replace("std::f64::consts::", "");
            let exponent =
                value.split_once("e-").is_some_and(|(head, _)| head.ends_with(|c: char| c.is_ascii_digit()));
            if exponent || value.contains("EPSILON") {
                found.push([name.clone(), constant.to_string(), value]);
            }
        }
    }
}

/// The first table of `docs/tolerances.md` has every named tolerance with its value, and no other.
#[test]
fn the_page_of_tolerances_is_that_of_the_sources() {
    let mut found = Vec::new();
    for chapter in ["crates/motion/src", "crates/scenes/src"].map(|chapter| root().join(chapter)) {
        tolerances(&chapter, &chapter, &mut found);
    }
    assert!(found.len() > 40, "{found:?}");
    let page = fs::read_to_string(root().join("docs/tolerances.md")).unwrap();
    let row = |line: &str| -> Option<[String; 3]> {
        let cells: Vec<&str> = line.split(" | ").collect();
        let code =
            |cell: &str| cell.trim_start_matches("| ").strip_prefix('`')?.strip_suffix('`').map(String::from);
        let (file, name) = (code(cells.first()?)?, code(cells.get(1)?)?);
        assert!(cells.len() == 5 && cells[3..].iter().all(|cell| cell.len() > 2), "{line}");
        file.ends_with(".rs").then(|| [file, name, cells[2].to_string()])
    };
    let mut listed: Vec<[String; 3]> = page.lines().filter_map(row).collect();
    found.sort();
    listed.sort();
    assert_eq!(listed, found);
}
