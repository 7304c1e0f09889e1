//! The surface that a reader prints and types: tables that LaTeX sets, commands that the pages print, inputs that are wrong.

mod process;

use std::{env, fs, path::Path, process::Command};

use process::run;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Every command that writes a LaTeX table, with the awkward texts among them.
const TABLES: [&str; 12] = [
    "intervals 3..=9",
    "intervals 3..=9 --decimals 6",
    "intervals --two-impacts 5",
    "intervals --pattern 2,3 --decimals 4",
    "boundary 3..=8",
    "boundary 5 --grid 3",
    "classify --r 0.99 --s 21/100",
    "classify --summary",
    "existence examples/maps/nordmark-2001.toml --max-period 5",
    "existence examples/maps/nordmark-2001.toml --max-period 5 --counts",
    "existence examples/maps/four-dimensional.toml --max-period 5",
    "existence examples/maps/singular.toml --max-period 4",
];

/// With `pdflatex` on the path every table is set, and none is wider than the text of an A4 page; without it, what would stop LaTeX is
/// looked for by hand. `GRAZING_REQUIRE_LATEX=1` makes its absence a failure.
#[test]
fn latex_sets_every_table() {
    let folder = tempfile::tempdir().unwrap();
    let mut document = String::from(
        "\\documentclass[a4paper]{article}\\usepackage{amsmath,array,booktabs,longtable}\\begin{document}\n",
    );
    for (index, arguments) in TABLES.iter().enumerate() {
        let file = folder.path().join(format!("table{index}.tex"));
        let all = format!("{arguments} --format latex -o {}", file.display());
        let (code, _, err) = run(&all, root());
        // A table of patterns may leave some undecided: 3.
        assert!(code == 0 || code == 3, "grazing {all}: {code} {err}");
        let text = fs::read_to_string(&file).unwrap();
        cells_are_balanced(arguments, &text);
        document += &format!("\\input{{table{index}}}\n");
    }
    document += "\\end{document}\n";
    fs::write(folder.path().join("all.tex"), document).unwrap();
    let latex = Command::new("pdflatex")
        .args(["-interaction=nonstopmode", "-halt-on-error", "all.tex"])
        .current_dir(folder.path())
        .output();
    let Ok(latex) = latex else {
        assert!(env::var("GRAZING_REQUIRE_LATEX").as_deref() != Ok("1"), "there is no pdflatex on the path");
        println!("no pdflatex: the tables were looked through, not set");
        return;
    };
    let log = String::from_utf8_lossy(&latex.stdout);
    assert!(latex.status.success(), "{log}");
    assert!(!log.contains("Overfull"), "a table is too wide:\n{log}");
}

/// Each row has as many columns as the table, no special character bare, braces and dollars in pairs.
fn cells_are_balanced(what: &str, text: &str) {
    let shape = text.lines().find_map(|line| line.strip_prefix("\\begin{longtable}{")).unwrap();
    let rows: Vec<&str> = text.lines().filter(|line| line.ends_with("\\\\")).collect();
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
