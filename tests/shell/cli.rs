//! The command as a user meets it: exit codes, messages, formats, files that are whole or absent.

use crate::process;

use std::{
    fs,
    io::{BufRead, BufReader, Read},
    path::Path,
    process::{Command, Output, Stdio},
};

fn command(arguments: &str) -> Command {
    let mut command = Command::new(crate::PROGRAM);
    command.args(arguments.split_whitespace());
    command
}

fn run(arguments: &str) -> (i32, String, String) {
    let Output { status, stdout, stderr } = command(arguments).output().unwrap();
    (status.code().unwrap(), String::from_utf8(stdout).unwrap(), String::from_utf8(stderr).unwrap())
}

/// The standard output of a command that must succeed in silence.
fn stdout(arguments: &str) -> String {
    let (code, out, err) = run(arguments);
    assert_eq!((code, err.as_str()), (0, ""), "grazing {arguments}");
    out
}

/// The one-line error of a command that must fail with exit code 2 and print nothing else.
fn error(arguments: &str) -> String {
    let (code, out, err) = run(arguments);
    assert_eq!((code, out.as_str()), (2, ""), "grazing {arguments}");
    assert_eq!(err.lines().count(), 1, "{err}");
    err.trim_end().strip_prefix("error: ").unwrap().to_string()
}

#[test]
fn a_figure_to_a_device_needs_a_name() {
    assert!(error("figure returns -o /dev/null").contains("give its name"));
}

#[test]
fn verify_and_check() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("c.txt");
    let file = file.to_str().unwrap();
    let out = stdout(&format!("verify 1..=30 --certificate {file}"));
    assert!(out.starts_with("Proved: Theorem 2 for every period n in 1..=30"), "{out}");
    assert_eq!(stdout(&format!("check {file}")), format!("{file}: proved, theorem2 for n = 1..=30\n"));
    let report: serde_json::Value = serde_json::from_str(&stdout("verify 8 --format json")).unwrap();
    assert_eq!(report["verdict"], "proved");
    assert_eq!(report["orbit_intervals"], 5);
    let both: serde_json::Value =
        serde_json::from_str(&stdout("verify 8 --method both --format json")).unwrap();
    assert_eq!((&both["verdict"], &both["method"]), (&"proved".into(), &"both".into()));
    assert!(
        stdout("verify 8 --method interval")
            .starts_with("Proved: Theorem 2 for period n = 8, by enclosures.")
    );
    assert!(error("verify 8 --method interval --certificate x").contains("use --method exact or both"));
    let text = fs::read_to_string(file).unwrap();
    // One thread or several, the same certificate.
    stdout(&format!("verify 1..=30 --jobs 1 --certificate {file}"));
    assert_eq!(fs::read_to_string(file).unwrap(), text);
    let line = 1 + text.lines().position(|line| line == "orbit 1/16 1/8 + +").unwrap();
    fs::write(file, text.replace("orbit 1/16 1/8 + +", "orbit 1/16 1/8 + -")).unwrap();
    let (code, out, _) = run(&format!("check {file} --format json"));
    let report: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!((code, &report["files"][0]["verdict"]), (1, &"rejected".into()));
    assert_eq!(
        report["files"][0]["reason"],
        format!("line {line}: false: c_8 has the wrong sign on (1/16, 1/8)")
    );
}

#[test]
fn bad_input_gets_one_line_that_says_what_to_do() {
    let cases = [
        ("verify 0", "a period is at least 1"),
        ("verify 8..=3", "the range is reversed: write 3..=8"),
        ("verify 3..8", "3..8 is ambiguous: write 3..=8, which includes both ends"),
        ("verify 3-8x", "\"8x\" is not a whole number: write N, or A..=B as in 3..=8"),
        ("verify 99999999999999999999", "99999999999999999999 is too large for a period"),
        ("fuzz --seed 1.5", "\"1.5\" is not a whole number"),
        ("farey walk 5 --from 1/2 --to 1/3", "--from 1/2 is above --to 1/3"),
        ("figure 2 --n 7", "figure 2 takes no N"),
        ("verify 300000", "`grazing verify` goes up to period 200000, not 300000"),
        ("intervals 3..=10000001", "`grazing intervals` goes up to period 10000000, not 10000001"),
        ("intervals 8 --decimals 1001", "--digits 1001 is too many: at most 1000"),
        (
            "verify 8 --certificate /nowhere/at/all",
            "cannot write /nowhere/at/all: there is no folder /nowhere/at",
        ),
        ("farey neighbours 4", "4 has no Farey neighbours: give a fraction m/n with n ≥ 2"),
        ("farey neighbours 1/0", "\"1/0\" divides by zero"),
        ("farey rank 1/2 0", "ranks are computed in F_N for 1 ≤ N ≤ 10000000000, not for N = 0"),
        ("farey walk 0", "a Farey sequence has an order of at least 1, not 0"),
        ("farey kth 12 5", "F_5 has terms 0 to 10, so none with index 12"),
        ("formula 3 3", "there is no formula for n = 3, k = 3: give 2 <= n <= 200 and 1 <= k <= n - 1"),
        (
            "formula 6 --sentence --area 2+",
            "period 6 has no area at m = 2: give 0 < 2m < n with m coprime to n",
        ),
        ("accuracy -o /dev/null/x", "cannot create /dev/null/x"),
        ("figure intervals 2", "N = 2: this figure shows periods 3 to N, with N from 3 to 40"),
    ];
    for (arguments, expected) in cases {
        let message = error(arguments);
        assert!(message.contains(expected), "grazing {arguments}: {message}");
    }
    assert_eq!(run("verfy 8").0, 2);
    assert_eq!(run("").0, 2);
    assert_eq!(run("--help").0, 0);
}

#[test]
fn formulas_and_sentences() {
    let out = stdout("formula 4 2");
    assert!(out.contains("\n  = a1*(a1 - a2 - 1)*(a1 + a2 + 1)\n"), "{out}");
    assert_eq!(stdout("formula 5 --sentence"), stdout("formula 5 --sentence --area region4 --format text"));
    let script = stdout("formula 5 --sentence --area 2- --format smtlib");
    assert!(script.starts_with("; 2- of period 5: ") && script.ends_with("(check-sat)\n"), "{script}");
    for wrong in
        ["formula 5", "formula 5 2 --sentence", "formula 5 2 --area 1+", "formula 5 --sentence --area 1"]
    {
        assert_eq!(run(wrong).0, 2, "grazing {wrong}");
    }
}

#[test]
fn every_command_documents_its_exit_codes() {
    for name in ["verify", "check", "intervals", "farey", "boundary", "figure", "formula"] {
        let help = stdout(&format!("{name} --help"));
        assert!(help.contains("Exit code "), "{name}");
    }
}

#[test]
fn table_formats_hold_the_same_rows() {
    let csv = stdout("intervals 3..=12 --decimals 6 --format csv");
    let json: serde_json::Value =
        serde_json::from_str(&stdout("intervals 3..=12 --decimals 6 --format json")).unwrap();
    let markdown = stdout("intervals 3..=12 --decimals 6 --format markdown");
    let latex = stdout("intervals 3..=12 --decimals 6 --format latex");
    let table = stdout("intervals 3..=12 --decimals 6");
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let header = reader.headers().unwrap().clone();
    assert_eq!(
        header.iter().collect::<Vec<_>>().join(" "),
        "n m sign_emu sign_gamma left right deciding left_rounded right_rounded"
    );
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), json["rows"].as_array().unwrap().len());
    let markdown: Vec<&str> = markdown.lines().skip(2).collect();
    let latex: Vec<&str> = latex.lines().filter(|line| line.contains(" & $(")).collect();
    let table: Vec<&str> = table.lines().skip(1).collect();
    assert_eq!([markdown.len(), latex.len(), table.len()], [rows.len(); 3]);
    for (index, row) in rows.iter().enumerate() {
        let cells: Vec<&str> = row.iter().collect();
        let object = &json["rows"][index];
        for (name, cell) in header.iter().zip(&cells) {
            let value = match &object[name] {
                serde_json::Value::String(text) => text.clone(),
                serde_json::Value::Null => String::new(),
                number => number.to_string(),
            };
            assert_eq!(value, *cell, "row {index}, {name}");
        }
        let words = |line: &str| {
            line.replace(['|', '&', '$', '\\'], " ").split_whitespace().map(String::from).collect::<Vec<_>>()
        };
        let expected: Vec<String> =
            cells.iter().filter(|cell| !cell.is_empty()).map(|cell| cell.to_string()).collect();
        for line in [markdown[index], table[index]] {
            assert_eq!(words(line), expected);
        }
        // In print the period stands once, the case in one cell, 0 is no fraction, and the deciding b has its
        // name.
        let sign = |cell: &str| if cell == "1" { '+' } else { '-' };
        let period = if cells[1] == "0" { format!("${}$", cells[0]) } else { String::new() };
        let end = |cell: &str| format!("${}$", if cell == "0/1" { "0" } else { cell });
        let decides =
            if cells[6].is_empty() { String::new() } else { format!("$b_{{{},{}}}$", cells[0], cells[6]) };
        let case = format!("$({},{})$", sign(cells[2]), sign(cells[3]));
        let printed = [period, case, end(cells[4]), end(cells[5]), decides, end(cells[7]), end(cells[8])];
        assert_eq!(latex[index], printed.join(" & ") + " \\\\");
    }
    let counts = stdout("intervals 1..=8 --format bfile");
    assert_eq!(counts, "1 2\n2 2\n3 3\n4 3\n5 5\n6 3\n7 7\n8 5\n");
}

/// Several waves of batches, and a period that many batches share: the bytes are those of the rows one after
/// the other, formatted by the standard library, from the Farey tree.
#[test]
fn rows_set_in_parallel_are_in_order_and_to_the_byte() {
    use grazing_scenes::existence::{Interval, intervals, tree_intervals};
    let mut all: Vec<Interval> = tree_intervals(500).unwrap().collect();
    all.sort_by_key(|interval| (interval.n, interval.left));
    let long: Vec<Interval> = intervals(99_991).unwrap().collect();
    for (periods, digits, rows) in [("3..=500", 3, all), ("99991", 5, long)] {
        let names = ["n", "m", "sign_emu", "sign_gamma", "left", "right", "deciding"];
        let texts: Vec<[String; 7]> = rows
            .iter()
            .map(|Interval { n, m, case, left, right, deciding }| {
                let end =
                    |x: &grazing_scenes::num_rational::Ratio<u64>| format!("{}/{}", x.numer(), x.denom());
                let signs = [case.sign_emu(), case.sign_gamma()].map(|sign| sign.to_string());
                let [emu, gamma] = signs;
                let k = deciding.map_or(String::new(), |k| k.to_string());
                [n.to_string(), m.to_string(), emu, gamma, end(left), end(right), k]
            })
            .collect();
        let written = |format: &str| stdout(&format!("intervals {periods} --format {format}"));
        // Not by assert_eq!, which would print megabytes.
        let csv: String = texts.iter().map(|row| row.join(",") + "\n").collect();
        assert!(written("csv") == names.join(",") + "\n" + &csv, "{periods}");
        let json: Vec<String> = texts
            .iter()
            .map(|row| {
                let cell = |(name, text): (&&str, &String)| match text.as_str() {
                    "" => format!("\"{name}\":null"),
                    text if text.contains('/') => format!("\"{name}\":\"{text}\""),
                    text => format!("\"{name}\":{text}"),
                };
                format!("{{{}}}", names.iter().zip(row).map(cell).collect::<Vec<_>>().join(","))
            })
            .collect();
        let json = format!("{{\"format\":\"grazing-intervals 1\",\"rows\":[\n{}\n]}}\n", json.join(",\n"));
        assert!(written("json") == json, "{periods}");
        let ends = 2 * digits + 2;
        let widths = [digits, digits, 8, 10, ends, ends, 8];
        let line = |cells: Vec<&str>| {
            let cells = cells.iter().zip(widths).map(|(cell, width)| format!("{cell:>width$}"));
            cells.collect::<Vec<_>>().join("  ").trim_end().to_string() + "\n"
        };
        let table: String = texts.iter().map(|row| line(row.iter().map(String::as_str).collect())).collect();
        assert!(written("table") == line(names.to_vec()) + &table, "{periods}");
    }
}

#[test]
fn farey_answers() {
    assert_eq!(stdout("farey neighbours 3/8"), "1/3 < 3/8 < 2/5\n");
    assert_eq!(stdout("farey rank 1/2 1000000"), "151981776196\n");
    assert_eq!(stdout("farey kth 151981776196 1000000"), "1/2\n");
    assert_eq!(stdout("farey walk 5 --from 1/3 --to 2/3"), "1/3\n2/5\n1/2\n3/5\n2/3\n");
    assert_eq!(stdout("farey walk 3 --from -1/2 --to 5/2").lines().count(), 13);
    let huge = "1267650600228229401496703205376";
    assert_eq!(stdout("farey walk 2^100 --from 0 --to 2^-100").lines().count(), 2);
    assert_eq!(
        stdout("farey neighbours 2^-100"),
        format!("0/1 < 1/{huge} < 1/{}5\n", &huge[..huge.len() - 1])
    );
    let json: serde_json::Value = serde_json::from_str(&stdout("farey walk 4 --format json")).unwrap();
    assert_eq!(json["terms"].as_array().unwrap().len(), 7);
}

#[test]
fn figure_comes_with_its_data() {
    let folder = tempfile::tempdir().unwrap();
    stdout(&format!("figure intervals --n 6 -o {}", folder.path().join("new").display()));
    let csv = fs::read_to_string(folder.path().join("new/intervals.csv")).unwrap();
    let svg = fs::read_to_string(folder.path().join("new/intervals.svg")).unwrap();
    assert_eq!(csv.lines().count(), 1 + 3 + 3 + 5 + 3);
    // One bar a row, drawn at the exact place: (1/6, 1/3) of n = 3 spans a third of the axis.
    let orange = svg.lines().filter(|line| line.contains("fill=\"#e69f00\""));
    let bars: usize = orange.map(|line| line.matches(['M']).count()).sum();
    assert_eq!(bars, 1 + 5, "five (+,+) bars and the legend");
}

/// The picture in the README is the one that the program draws today.
#[test]
fn checked_in_figure_is_current() {
    let folder = tempfile::tempdir().unwrap();
    stdout(&format!("figure intervals -o {}", folder.path().display()));
    for name in ["intervals.svg", "intervals.csv"] {
        let drawn = fs::read_to_string(folder.path().join(name)).unwrap();
        assert_eq!(
            fs::read_to_string(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs")).join(name))
                .unwrap(),
            drawn,
            "run `grazing figure intervals -o docs`"
        );
    }
}

#[test]
fn a_closed_pipe_is_no_error() {
    let mut child =
        command("farey walk 100000").stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut reader = BufReader::new(child.stdout.take().unwrap());
    let mut line = String::new();
    reader.read_line(&mut line).unwrap();
    drop(reader);
    assert_eq!(line, "0/1\n");
    assert_eq!(child.wait().unwrap().code(), Some(0));
    let mut err = String::new();
    child.stderr.unwrap().read_to_string(&mut err).unwrap();
    assert_eq!(err, "");
}

#[cfg(unix)]
#[test]
fn failure_leaves_no_file() {
    assert!(error("intervals 3..=200 --format csv -o /dev/full").contains("No space left on device"));
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("kept.csv");
    fs::write(&file, "old").unwrap();
    let mut child =
        command("intervals 3..=100000 --format csv -o").arg(&file).stderr(Stdio::piped()).spawn().unwrap();
    // Wait until it writes, then ask it to stop, as Ctrl-C does.
    while fs::read_dir(folder.path()).unwrap().count() < 2 {
        std::thread::yield_now();
    }
    Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(3));
    assert_eq!(fs::read_to_string(&file).unwrap(), "old");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "the temporary file is gone");
}

#[cfg(target_os = "linux")]
#[test]
fn interrupted_verification_says_what_is_pending() {
    let mut child = process::listening("verify 3..=1500 --format json", Path::new("."));
    process::signal(&child, &["-INT"]);
    let mut out = String::new();
    child.stdout.take().unwrap().read_to_string(&mut out).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(3));
    let report: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(report["verdict"], "interrupted");
    assert_eq!(report["periods"].as_u64().unwrap() + report["pending"].as_u64().unwrap(), 1498);
}

#[test]
fn classify_by_either_kind_of_point() {
    // a₁ = a₂ = 1/4 has r = 1/2, cos θ = 1/4: s is irrational. By (r, s): r = 1/2, s = 1/4 is a₁ = 0, a₂ =
    // 1/4.
    // Of even periods Theorem 1 is silent there.
    let silent = |arguments: &str| {
        let (code, out, err) = run(arguments);
        assert_eq!((code, err.as_str()), (3, ""), "grazing {arguments}");
        out
    };
    let polar = silent("classify --r 1/2 --s 1/4 --max-n 12 --format csv");
    let plane = silent("classify --a1 0 --a2 0.25 --max-n 12 --format csv");
    let kinds = |text: &str| {
        text.lines().map(|line| line.split(',').take(5).collect::<Vec<_>>().join(",")).collect::<Vec<_>>()
    };
    assert_eq!(kinds(&polar), kinds(&plane));
    assert!(polar.contains("\n2,singular boundary,,,,,,,first\n"), "{polar}");
    assert!(polar.contains("\n4,singular boundary,,,,,,,higher\n"), "{polar}");
    // At higher resonances it is decided that nothing is born: the exit code is 0 where there are no others.
    assert!(
        stdout("classify --r 1/2 --s 1/3 --max-n 3").contains("n = 3, u_n = 0, higher resonance: no orbit")
    );
    assert!(silent("classify --r 1 --s 1/3 --max-n 3").contains("singular boundary"));
    // In reversed time the same orbits, with k and n − k exchanged.
    let reversed = stdout("classify --a1 -6/5 --a2 4/3 --max-n 9 --format csv");
    let forward = stdout("classify --a1 -9/10 --a2 3/4 --max-n 9 --format csv");
    assert_eq!(kinds(&reversed), kinds(&forward));
    assert!(stdout("classify --a1 -6/5 --a2 4/3").contains("reversing time"));
    let json: serde_json::Value =
        serde_json::from_str(&stdout("classify --a1 3 --a2 1/2 --max-n 2 --format json")).unwrap();
    assert_eq!(json["rows"][1]["existence"], "orbit");
    assert_eq!(json["rows"][1]["large_eigenvalue"], 1, "(−,−) of period 1 in region 1: −sign eµ");
    assert_eq!(stdout("classify --summary --format csv").lines().count(), 6);
    assert!(error("classify --a1 1 --a2 0").contains("the determinant of the map of a flow is above 0"));
    assert!(error("classify --r 1/2 --s 1/2").contains("outside 0 < s < 1/2"));
    assert!(error("classify --r 1/2 --s 1/4 --max-period 0").contains("--max-period 0"));
}

#[test]
fn fuzz_resumes_and_reports() {
    let folder = tempfile::tempdir().unwrap();
    let state = folder.path().join("state.json");
    let options =
        format!("fuzz --n 1..=12 --seed 3 --jobs 1 --format json --resume {} --cases", state.display());
    let tally = |text: &str| {
        let mut report: serde_json::Value = serde_json::from_str(text).unwrap();
        let tally = report["tally"].as_object_mut().unwrap();
        tally.retain(|key, _| !key.ends_with("seconds"));
        serde_json::Value::from(tally.clone())
    };
    let first = tally(&stdout(&format!("{options} 1000")));
    let second = tally(&stdout(&format!("{options} 3e6")));
    assert!(second["units"].as_u64() > first["units"].as_u64());
    let whole = tally(&stdout("fuzz --n 1..=12 --seed 3 --jobs 2 --format json --cases 3e6"));
    assert_eq!(whole, second);
    let (code, out, _) = run("fuzz --n 12 --cases 1");
    assert!(code == 0 && out.starts_with("No disagreement found. This is not a proof.\n"), "{out}");
    assert!(
        error(&format!("{} 1000", options.replace("--seed 3", "--seed 4")))
            .contains("belongs to another run")
    );
    fs::write(&state, "{}").unwrap();
    assert!(error(&format!("{options} 1000")).contains("it is not a saved state"));
    assert!(error("fuzz --cases 0").contains("--cases 0: give at least 1"));
    assert!(error("fuzz --n 2").contains("the largest period is 2: from 3 to 4096"));
    assert!(error("fuzz --definition-share 2").contains("a number from 0 to 1"));
}

/// Shares add up, the answers stay the same, and where nothing is timed the option is refused.
#[test]
fn profiles_say_where_time_went() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("profile.csv");
    let commands = [
        "classify --r 0.99 --s 21/100",
        "classify --a1 5/4 --a2 9/10",
        "verify 3..=9 --method both",
        "boundary 5",
        "cover 3 --jobs 1",
        "fuzz --n 3..=20 --cases 3000 --seed 1",
    ];
    for arguments in commands {
        let (code, profiled, _) = run(&format!("{arguments} --profile {}", file.display()));
        // A fuzzing and a cover say how long they took.
        let timed = ["fuzz", "cover"].iter().any(|name| arguments.starts_with(name));
        assert!(code == 0 && (timed || profiled == stdout(arguments)), "{arguments}");
        let text = fs::read_to_string(&file).unwrap();
        let mut lines = text.lines();
        assert_eq!(lines.next(), Some("method,cases,time_ns,of_cases,of_time"), "{arguments}");
        let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
        let sum = |i: usize| rows.iter().map(|row| row[i].parse::<f64>().unwrap()).sum::<f64>();
        assert!(sum(1) >= 1.0 && sum(2) >= 1.0, "{arguments}: {text}");
        assert!([3, 4].iter().all(|&i| (sum(i) - 1.0).abs() < 1e-3), "{arguments}: {text}");
    }
    assert!(error("farey neighbours 1/3 --profile x").starts_with("--profile is for verify"));
}

#[test]
fn evaluate_prints_certain_digits_and_the_rung() {
    let digits = "2.000000000000000000";
    assert_eq!(
        stdout("evaluate --n 3 --s 1/4 --bits 64"),
        format!(
            "b_{{3,1}}      +         exact        {digits}\nb_{{3,2}}      +         exact        {digits}\nc_3          +         exact        {digits}\n"
        )
    );
    assert_eq!(
        stdout("evaluate --n 4 --k 1 --s 1/8"),
        "b_{4,1}      singular  exact\nc_4          singular  exact\n"
    );
    assert!(
        stdout("evaluate --n 3 --k 1 --a1 -1 --a2 9/10")
            .starts_with("b_{3,1}      0         exact        0\n")
    );
    // Beside a double zero with r = 1 − 2⁻¹⁰⁰ balls begin at the length of the point. The digits are from
    // mpmath.
    let line = stdout("evaluate --n 6 --k 3 --s 1/3+2^-200 --r 1-2^-100");
    let line = line.lines().next().unwrap();
    assert!(
        line.starts_with("b_{6,3}      -         256 bits     -2.800356875037513768214828824203"),
        "{line}"
    );
    assert!(line.ends_with("e-60"), "{line}");
    // 1 − 2^1000000; Python's integers have these digits, 301030 in all.
    let line = stdout("evaluate --n 1000001 --k 1 --s 1/5 --r 1/2");
    let line = line.lines().next().unwrap();
    let digits = "-9.900656229295898250697923616301";
    assert!(line.contains(digits) && line.ends_with("e301029"), "{line}");
    let json: serde_json::Value =
        serde_json::from_str(&stdout("evaluate --n 2 --s 1/3 --format json")).unwrap();
    assert_eq!(json["values"][0]["sign"], "+");
    let largest = stdout("evaluate 18446744073709551615 7 --s 1/7 --format json");
    assert!(largest.contains(r#""n":"18446744073709551615""#), "no reader of floats may round it: {largest}");
    assert_eq!(error("evaluate --n 3 --k 3 --s 1/4"), "K = 3 is outside 1 <= K < N = 3");
    assert!(error("evaluate --n 3 --s 3/4").starts_with("s = 3/4 is outside 0 < s < 1/2"));
}

fn example(name: &str) -> String {
    format!("{}/../../examples/maps/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// The numbers of section 4.2 of the paper: which periods exist on which side, and their large eigenvalues.
#[test]
fn existence_gives_the_numbers_of_the_paper() {
    let map = example("nordmark-2001.toml");
    let json: serde_json::Value =
        serde_json::from_str(&stdout(&format!("existence {map} --max-period 4 --format json"))).unwrap();
    for (pattern, mu, leading) in [("1", 1, 32.1), ("2", 1, 4.37), ("3", 1, 0.00504), ("4", -1, 0.203)] {
        let row = json["rows"].as_array().unwrap().iter().find(|row| row["pattern"] == pattern).unwrap();
        assert_eq!((&row["sign_mu"], &row["primitive"]), (&mu.into(), &"yes".into()));
        let found: f64 = row["leading"].as_str().unwrap().parse().unwrap();
        assert!((found / leading - 1.0).abs() < 5e-3, "{pattern}: {found}");
        // −32.1/µ and so on: negative where e µ < 0, e = −1; 0.203/(−µ) is positive.
        assert_eq!(row["sign_eigenvalue"], -mu);
    }
}

/// A box across s = 1/6 says what is born on both sides and on the line; one beside it has nothing to say.
#[test]
fn a_box_across_a_resonance_says_what_is_born_there() {
    for place in [
        "--r 0.9 --s 0.16..=0.17",
        "--a1 9/10 --a2 0.8..=0.82",
        "--frequency 1Hz+-1% --damping-ratio 0.1 --drive 6Hz",
    ] {
        let (code, out, _) = run(&format!("word {place}"));
        assert!(
            code == 3 && out.contains("n = 3: s = 1/6 may be among them. Below it, for gamma > 0,"),
            "{out}"
        );
        assert!(
            out.contains("on the side that the second order decides; of a damped linear oscillator"),
            "{out}"
        );
        let (_, json, _) = run(&format!("word {place} --format json"));
        let json: serde_json::Value = serde_json::from_str(&json).unwrap();
        assert_eq!(json["resonances"], serde_json::json!([{ "period": 3, "resonance": "first" }]), "{place}");
    }
    let beside: serde_json::Value =
        serde_json::from_str(&stdout("word --r 0.9 --s 0.16..=0.165 --format json")).unwrap();
    assert_eq!(beside["resonances"], serde_json::json!([]));
}

#[test]
fn existence_names_what_it_cannot_decide() {
    let (code, out, _) = run(&format!("existence {} --max-period 4 --format csv", example("singular.toml")));
    assert_eq!(code, 3);
    for (begin, why) in [("3,", "first resonance"), ("\"1,3\",", "det D = 0")] {
        let row = out.lines().find(|line| line.starts_with(begin)).unwrap_or_else(|| panic!("{out}"));
        assert!(row.contains("undecided") && row.contains(why) && row.contains("C A^3 B = 0"), "{row}");
    }
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("zero.toml");
    let text = fs::read_to_string(example("focus.toml")).unwrap();
    fs::write(&file, text.replace("e = 1", "e = 0")).unwrap();
    let (code, out, err) = run(&format!("existence {} --max-period 1 --format csv", file.display()));
    assert_eq!((code, out.lines().count()), (3, 2));
    assert!(out.contains("nothing is claimed for either sign") && err.starts_with("note: "), "{out}{err}");
    fs::write(&file, text.replace("B =", "b =")).unwrap();
    let message = error(&format!("existence {}", file.display()));
    assert!(message.ends_with("zero.toml:4: unknown key \"b\"; the nearest known key is \"B\""), "{message}");
    assert!(error("existence nowhere.toml").contains("cannot read nowhere.toml"));
    let focus = example("focus.toml");
    assert!(error(&format!("existence {focus} --pattern 1,x")).contains("is not a pattern"));
    assert!(error(&format!("existence {focus} --max-period 0")).contains("at least 1"));
    assert!(
        error(&format!("existence {} --dot x", example("four-dimensional.toml")))
            .contains("needs a map with N = 2")
    );
    assert!(
        error(&format!("existence {} --exact", example("nordmark-2001.toml"))).contains("without intervals")
    );
}

#[test]
fn existence_lists_counts_and_prunes_alike() {
    for name in ["focus.toml", "four-dimensional.toml"] {
        let map = example(name);
        let all = stdout(&format!("existence {map} --max-period 9 --format csv"));
        let kept: Vec<&str> = all.lines().filter(|line| !line.contains(",neither,")).collect();
        let pruned = stdout(&format!("existence {map} --max-period 9 --format csv --existing"));
        assert_eq!(kept, pruned.lines().collect::<Vec<_>>());
        let counts: serde_json::Value =
            serde_json::from_str(&stdout(&format!("existence {map} --max-period 9 --counts --format json")))
                .unwrap();
        let sum = |key: &str| {
            counts["rows"].as_array().unwrap().iter().map(|row| row[key].as_u64().unwrap()).sum::<u64>()
        };
        assert_eq!(sum("patterns") as usize, all.lines().count() - 1);
        assert_eq!((sum("plus") + sum("minus")) as usize, kept.len() - 1);
    }
    let exact = stdout(&format!("existence {} --pattern 2,1 --exact --format csv", example("focus.toml")));
    assert!(
        exact.lines().nth(1).unwrap().starts_with("\"1,2\",3,2,yes,emu<0,-1,-1,-7/9,-133/90,7/9,7/6,"),
        "{exact}"
    );
}

/// Flights of four dimensions contract; beside a coordinate that grows by itself they do not; in the plane
/// nothing is left of two, but for the periods whose C AⁿB is 0.
#[test]
fn existence_says_whether_one_bound_serves_all_patterns() {
    let said = |map: &str| {
        let (code, out, _) = run(&format!("existence {map} --max-period 4 --uniform --format csv"));
        (code, out.lines().nth(1).unwrap_or_default().to_string())
    };
    let (code, row) = said(&example("four-dimensional.toml"));
    assert!(code == 0 && row.starts_with("\"1,2,3,4\",,contract,"), "{row}");
    let (code, row) = said(&example("singular.toml"));
    assert!(code == 0 && row.starts_with("\"1,2,4\",3,contract,"), "{row}");
    let folder = tempfile::tempdir().unwrap();
    for (entry, wanted) in [("-1.1", "grow,,1"), ("1", "undecided,,")] {
        let file = folder.path().join("map.toml");
        let text = format!(
            "format = \"grazing-map 1\"\nA = [[0.9, 0, 1], [0, {entry}, 0], [-0.6, 0, 0]]\nB = [0, 0, 1]\n\
             C = [1, 0, 0]\ne = 1\n"
        );
        // A coordinate with the eigenvalue 1 leaves no map to speak of; nearly 1 will do.
        std::fs::write(&file, text.replace("[0, 1, 0]", "[0, 0.9999999, 0]")).unwrap();
        let (code, row) = said(&file.display().to_string());
        assert_eq!((code, row), (if entry == "1" { 3 } else { 0 }, format!("\"1,2,3,4\",,{wanted}")));
    }
}

#[test]
fn existence_draws_graphs_and_orbits() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    stdout(&format!("existence {} --max-period 5 --dot {}", example("focus.toml"), at("g.dot")));
    let dot = fs::read_to_string(at("g.dot")).unwrap();
    assert!(
        dot.contains("digraph patterns {")
            && dot.contains("  1 -> 3 [color=\"#0072B2\"];")
            && dot.ends_with("}\n")
    );
    stdout(&format!("existence {} --pattern 1,3 --orbit {}", example("four-dimensional.toml"), at("orbit")));
    let csv = fs::read_to_string(at("orbit/orbit.csv")).unwrap();
    assert_eq!(csv.lines().next().unwrap(), "panel,sign_emu,i,k,h,x1,x2,x3,x4");
    assert_eq!(csv.lines().count(), 1 + 2 + 4);
    let svg = fs::read_to_string(at("orbit/orbit.svg")).unwrap();
    assert!(
        svg.contains("pattern (1,3): beyond the touch, <tspan font-style=\"italic\">eµ</tspan> &lt; 0"),
        "{svg}"
    );
    stdout(&format!("figure 3 -o {}", at("figure")));
    assert_eq!(fs::read_to_string(at("figure/figure3.csv")).unwrap().lines().count(), 1 + 3 * 16);
}

/// A part of `accuracy` that is whole and was measured by this program with these options is kept; one that
/// was changed, lost, or measured otherwise is measured anew.
#[test]
fn what_was_measured_is_kept() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let measure = |options: &str| {
        let out = stdout(&format!("accuracy --of effects {options} -o {}", folder.path().display()));
        out.starts_with("effects: kept as this program measured it before")
    };
    assert!(!measure("--quick"));
    let (table, measured) = (fs::read(at("effects.csv")).unwrap(), fs::read(at("measured.csv")).unwrap());
    assert!(measure("--quick"));
    assert_eq!(fs::read(at("effects.csv")).unwrap(), table);
    let text = String::from_utf8(measured.clone()).unwrap();
    assert!(text.contains("effects,effects.csv,quick,\"grazing 0."), "{text}");
    assert_eq!(text.lines().count(), 3);
    for (file, bytes) in [
        ("effects.csv", [&table[..], b"\n"].concat()),
        ("measured.csv", text.replace("quick", "full").into_bytes()),
        ("measured.csv", text.replacen("grazing 0.", "grazing 9.", 2).into_bytes()),
    ] {
        fs::write(at(file), bytes).unwrap();
        assert!(!measure("--quick"), "{file}");
    }
    fs::remove_file(at("effects.csv")).unwrap();
    assert!(!measure("--quick") && measure("--quick") && at("effects.csv").exists());
}
