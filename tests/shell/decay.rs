//! `grazing decay`: the forms of a record, what is refused, and that what it prints goes on.

use crate::{process::run, surface::root};

use std::fs;

/// What comes of a text: the JSON, or the error.
fn decay(text: &str, options: &str) -> Result<serde_json::Value, String> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("record.csv"), text).unwrap();
    let (code, out, err) = run(&format!("decay record.csv {options} --format json"), folder.path());
    assert!(code == 0 || (code == 2 && out.is_empty() && err.lines().count() == 1), "{code} {out} {err}");
    if code == 0 { Ok(serde_json::from_str(&out).unwrap()) } else { Err(err) }
}

fn example() -> String {
    fs::read_to_string(root().join("examples/decay.csv")).unwrap()
}

/// The rows of the example, each made anew.
fn rows(row: impl Fn(&str, &str) -> String) -> String {
    example().lines().skip(1).map(|line| line.split_once(',').unwrap()).map(|(t, x)| row(t, x)).collect()
}

/// The example was made with 12.3 Hz and 0.02.
#[test]
fn every_form_of_a_record_gives_the_same() {
    let known = decay(&example(), "").unwrap();
    for (name, truth) in [("frequency", 12.3), ("damping_ratio", 0.02)] {
        let [value, deviation] = ["value", "deviation"].map(|part| known[name][part].as_f64().unwrap());
        assert!(
            (value - truth).abs() < 3.0 * deviation && deviation < 0.1 * truth,
            "{name} {value} {deviation}"
        );
    }
    let forms = [
        (rows(|t, x| format!("{t},{x}\n")), ""),
        (format!("\u{feff}Time [s];x\r\n{}", rows(|t, x| format!("{t};{x}\r\n"))), ""),
        (format!("# a beam\nx t\n{}", rows(|t, x| format!("{x} {t}\n\n"))), ""),
        (format!("t\tforce\tx\n{}", rows(|t, x| format!("{t}\t0\t{x}\n"))), "--column X"),
    ];
    for (text, options) in forms {
        assert_eq!(decay(&text, options).unwrap(), known, "{}", &text[..40]);
    }
    // Milliseconds, and no unit.
    let scaled = rows(|t, x| format!("{},{x}\n", t.parse::<f64>().unwrap() * 1e3));
    let near = |found: &serde_json::Value, factor: f64| {
        let [found, known] = [found, &known].map(|one| one["frequency"]["value"].as_f64().unwrap());
        (found / known / factor - 1.0).abs() < 1e-9
    };
    let found = decay(&scaled, "--unit ms").unwrap();
    assert!(near(&found, 1.0) && found["unit"] == "Hz", "{found}");
    let found = decay(&scaled, "--unit none").unwrap();
    assert!(near(&found, 1e-3) && found["unit"].is_null(), "{found}");
    let part = decay(&example(), "--from 0.5 --until 2").unwrap();
    assert_eq!(part["samples"], 301);
}

#[test]
fn what_is_wrong_with_a_record_is_said_with_its_line() {
    let with = |line: &str| example().replacen("0.100,", line, 1);
    for (text, options, said) in [
        (String::new(), "", "record.csv:1: holds no samples"),
        ("time,displacement\n0,1\n".into(), "", "record.csv:1: has 1 samples"),
        (with("nan,"), "", "record.csv:22: \"nan\" is not a finite number"),
        (example().replace(',', ";").replace('.', ","), "", "has a decimal comma: write 0."),
        (with("0.1 s,"), "", "write the number alone"),
        (with("0.095,"), "", "record.csv:22: the time 0.095 stands in line 21, too"),
        (with("0.01,"), "", "sort the lines by time"),
        (with("0.1,3,"), "", "record.csv:22: has 3 cells; the first line has 2"),
        (rows(|t, x| format!("{t},{x},0\n")), "", "has 3 columns without names"),
        (rows(|t, x| format!("{t},{x}\n")), "--column x", "leave out --column"),
        (
            format!("when,x\n{}", rows(|t, x| format!("{t},{x}\n"))),
            "",
            "has no column \"time\" or \"t\"; here are when, x",
        ),
        (format!("t,x,y\n{}", rows(|t, x| format!("{t},{x},0\n"))), "", "name the displacement by --column"),
        (example(), "--column y", "has no column \"y\"; here are time, displacement"),
        (example(), "--until 0.03", "record.csv: 7 samples: a decay needs at least 12"),
        (example(), "--until 0.1", "overdamped, or too short a record"),
        // From 1.5 to 3 times its amplitude the damping doubles.
        (
            rows(|t, _| {
                let t: f64 = t.parse().unwrap();
                format!("{t},{}\n", (77.3 * t).cos() * (-1.5 * t - 0.5 * (1.0 - (-3.0 * t).exp())).exp())
            }),
            "",
            "damping depends on the amplitude",
        ),
    ] {
        let error = decay(&text, options).expect_err(said);
        assert!(error.contains(said), "{said}: {error}");
    }
}

/// The last line is a command that runs, once F is there.
#[test]
fn the_options_go_on() {
    let (code, text, _) = run("decay examples/decay.csv", root());
    let line = text.trim_end().lines().last().unwrap();
    let next = line.trim().strip_prefix("grazing ").unwrap().replace(" F ", " 10Hz ");
    let (next_code, said, err) = run(&format!("{next} --cells 200"), root());
    assert!(code == 0 && (next_code == 0 || next_code == 3), "{next}: {err}");
    assert!(said.contains("Chaos is born") && said.contains("independent and normal"), "{said}");
}

/// Lengths and times of any size: every number has its digits, and the options go on as those of seconds do.
#[test]
fn no_unit_is_too_small_or_too_large() {
    let folder = tempfile::tempdir().unwrap();
    let mut words = Vec::new();
    for (long, tall) in [("", ""), ("e-40", "e-200"), ("e40", "e200")] {
        let record = rows(|t, x| format!("{t}{long},{x}{tall}\n"));
        fs::write(folder.path().join("record.csv"), record).unwrap();
        let (code, out, err) = run("decay record.csv --unit none", folder.path());
        assert_eq!(code, 0, "{err}");
        let digits = |word: &str| word.chars().any(|c| matches!(c, '1'..='9'));
        let told = out.lines().take(5).flat_map(|line| line.split([' ', ',']));
        let numbers: Vec<&str> = told.filter(|word| word.starts_with(|c: char| c.is_ascii_digit())).collect();
        assert!(numbers.len() > 8 && numbers.iter().all(|word| digits(word) && word.len() < 20), "{out}");
        let found = decay(&rows(|t, x| format!("{t}{long},{x}{tall}\n")), "--unit none").unwrap();
        let [frequency, ratio] =
            ["frequency", "damping_ratio"].map(|name| found["options"][name].as_str().unwrap());
        let drive = match long {
            "" => "10",
            "e-40" => "10e40",
            _ => "10e-40",
        };
        let options = format!("word --frequency {frequency} --damping-ratio {ratio} --drive {drive}");
        let (code, out, err) = run(&options, folder.path());
        assert!(code != 2, "{options}: {err}");
        words.push((code, out.lines().skip(1).map(String::from).collect::<Vec<_>>()));
    }
    assert!(words.iter().all(|one| *one == words[0]), "{words:?}");
}
