//! `grazing word`, its certificates, and `grazing fuzz --words`, by the command.

use std::{fs, process::Command};

use serde_json::Value;

/// Exit code, standard output, standard error, in a folder.
fn run(folder: &std::path::Path, arguments: &str) -> (i32, String, String) {
    let mut command = Command::new(crate::PROGRAM);
    let output = command.current_dir(folder).args(arguments.split_whitespace()).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

#[test]
fn words_are_written_certified_and_checked() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &str| run(folder.path(), arguments);
    for (point, code) in [
        ("--r 0.9 --s 0.37", 0),
        ("--a1 -1/4 --a2 1/2", 0),
        ("--a1 3 --a2 1/2", 0),
        ("--a1 6/5 --a2 1/4", 0),
        ("--a1 -26/100..=-0.25 --a2 1/2..=51/100", 0),
        // On the boundary of period 3, across it, and where u_n = 0 on r = 1: certified as far as it goes.
        ("--a1 -1 --a2 1/2", 3),
        ("--a1 -1.01..=-0.99 --a2 1/2", 3),
        ("--r 1 --s 3/10", 3),
    ] {
        for kind in ["", " --by-theorem"] {
            let (found, out, error) = run(&format!("word {point} --certificate w.txt{kind}"));
            assert_eq!(found, code, "{point}: {error}");
            assert!(out.contains("Certificate: w.txt"), "{out}");
            let (found, out, error) = run("check w.txt");
            assert_eq!(found, 0, "{point}: {out}{error}");
            assert!(out.starts_with(if kind.is_empty() {
                "w.txt: proved, word for"
            } else {
                "w.txt: proved, word-by-theorem for"
            }));
            fs::remove_file(folder.path().join("w.txt")).unwrap();
        }
    }
    // Across regions 3 and 4 both kinds hold; across the line of period 1 nothing does, and no file is left.
    for kind in ["", " --by-theorem"] {
        let across = "word --a1 -1.415..=-1.414 --a2 0.5..=0.5001 --certificate w.txt";
        let (code, out, error) = run(&format!("{across}{kind}"));
        assert_eq!(code, 0, "{error}");
        assert!(out.contains("e*mu > 0: word DUD\n"), "{out}");
        assert_eq!(run("check w.txt").0, 0);
        fs::remove_file(folder.path().join("w.txt")).unwrap();
    }
    let (code, _, error) = run("word --a1 1..=1.5 --a2 1/4 --certificate w.txt");
    assert_eq!((code, folder.path().join("w.txt").exists()), (3, false));
    assert!(
        error.contains("no certificate: the letter of period 1 is not certain on all of the box"),
        "{error}"
    );
    for (arguments, expected) in [
        ("word --a1 1 --a2 4 --certificate w.txt", "certify the time-reversed system"),
        ("word --a1 2..=1 --a2 1/2", "the interval is reversed: write 1..=2"),
        ("word --a1 0..=1 --a2 0..=1", "a box lies in 0 < a2 <= 1"),
        ("word --a1 0..=1 --a2 1/2..=2", "a box lies in 0 < a2 <= 1"),
        ("word --a1 1 --a2 -1", "the determinant of the map of a flow is above 0"),
        ("word --a1 1 --a2 1/2 --by-theorem", "--certificate"),
        ("word --a1 3/2 --a2 1/2 --certificate w.txt", "on a line |a1| = a2 + 1"),
        ("word --r 1/2 --s 1/2", "s"),
        ("word --r 1/2 --s 0", "s"),
        ("word --r 0 --s 1/4", "the modulus is above 0"),
    ] {
        let (code, _, error) = run(arguments);
        assert_eq!(code, 2, "{arguments}: {error}");
        assert!(error.contains(expected), "{arguments}: {error}");
    }
}

#[test]
fn a_box_says_what_all_its_points_have_in_common() {
    let folder = tempfile::tempdir().unwrap();
    let json = |arguments: &str| -> (i32, Value) {
        let (code, out, error) = run(folder.path(), &format!("word {arguments} --format json"));
        (code, serde_json::from_str(&out).expect(&error))
    };
    let (code, report) = json("--a1 -26/100..=-0.25 --a2 1/2..=51/100");
    assert_eq!((code, &report["box"]["a1"][0]), (0, &Value::from("-13/50")));
    assert_eq!(report["words"][0]["periods"], Value::from(vec![1, 2, 3]));
    // b_{3,1} = 0 at a₁ = −1: the word ends before period 3.
    let (code, report) = json("--a1 -1.01..=-0.99 --a2 1/2");
    assert_eq!((code, &report["words"][0]["end"]["kind"]), (3, &Value::from("straddled")));
    assert_eq!(report["words"][0]["periods"], Value::from(vec![1, 2]));
    assert_eq!(report["words"][0]["end"]["next"], Value::from(3));
    assert_eq!(report["words"][0]["cases"][0]["entropy"]["lower_bound"], Value::from(true));
    // The line a₁ = a₂ + 1 in it: period 1 alone is certain, and not its letter.
    let (code, report) = json("--a1 1..=3/2 --a2 1/4");
    assert_eq!((code, report["words"][0]["letters"].as_str()), (3, Some("?")));
    assert_eq!(report["words"][0]["end"]["next"], Value::from(2));
    // Across regions 2 and 3 what holds for all: 2ns < 1 in region 3, at most up to n = 22 at a₁ = 0.99.
    let (code, report) = json("--a1 0.99..=1.01 --a2 1/4");
    assert_eq!((code, report["words"][0]["letters"].as_str()), (3, Some("D")));
    let letters = report["words"][1]["letters"].as_str().unwrap();
    assert!(letters.chars().all(|letter| letter == 'D') && (4..=22).contains(&letters.len()), "{letters}");
    assert_eq!(report["words"][1]["cases"][0]["entropy"]["lower_bound"], Value::from(true));
    // On a₁ = −(a₂ + 1): all odd periods, and 2.
    let (code, report) = json("--a1 -3/2 --a2 1/2 --max-period 8");
    assert_eq!((code, &report["words"][0]["end"]["kind"]), (3, &Value::from("odd")));
    assert_eq!(report["words"][0]["cases"][1]["loops"], Value::from(vec![1, 3, 5, 7]));
    assert_eq!(report["words"][1]["end"]["kind"], Value::from("complete"));
    // One point is no box.
    let (code, report) = json("--a1 -1/4 --a2 1/2..=1/2");
    assert_eq!((code, &report["box"]), (0, &Value::Null));
}

#[test]
fn fuzzing_words_resumes_and_reports() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &str| run(folder.path(), &format!("fuzz --words --definition-share 0 {arguments}"));
    let (code, out, error) = run("--cases 1 --resume state --format json");
    assert_eq!(code, 0, "{error}");
    let report: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((report["of"].as_str(), report["verdict"].as_str()), (Some("words"), Some("no disagreement")));
    let points = report["tally"]["swept"].as_u64().unwrap();
    assert!(points > 30_000, "{report}");
    // Nothing is left to do.
    let (code, out, error) = run("--cases 1 --resume state");
    assert_eq!(code, 0, "{error}");
    assert!(
        out.contains("No disagreement found. This is not a proof.") && out.contains("which is not proved"),
        "{out}"
    );
    for (arguments, expected) in [
        ("--n 3..=9", "write 1..=9"),
        ("--n 1..=2000", "from 3 to 1024"),
        ("--cases 0", "give at least 1"),
        ("--cases 1 --seed 2 --resume state", "state"),
    ] {
        let (code, _, error) = run(arguments);
        assert_eq!(code, 2, "{arguments}: {error}");
        assert!(error.contains(expected), "{arguments}: {error}");
    }
    let (code, _, error) = self::run(folder.path(), "fuzz --cases 1 --resume state");
    assert_eq!(code, 2, "{error}");
}

/// "Born in none" is said where the words end for certain, and not where they do not.
#[test]
fn no_chaos_is_said_only_where_the_words_end() {
    let run = |arguments: &str| run(std::path::Path::new("."), arguments);
    let (code, out, _) = run("word --a1 1807/1000 --a2 807/1000");
    assert_eq!(code, 3);
    assert!(out.contains("Whether chaos is born is not decided"), "{out}");
    // On the other line it is born by odd periods and 2.
    let (code, out, _) = run("word --a1 -1807/1000 --a2 807/1000");
    assert_eq!(code, 3);
    assert!(out.contains("(+,-) with entropy at least 0.609377863436006"), "{out}");
    let (code, out, _) = run("word --r 1/10 --s 4001/10000");
    assert_eq!(code, 0);
    assert!(out.contains("Chaos is born in none of the four cases (sign e*mu, sign gamma).\n"), "{out}");
    // On the circle u_n = 0 is told, too, and without a resonance.
    let (code, out, _) = run("word --r 1 --s 1/6 --format json");
    let report: Value = serde_json::from_str(&out).unwrap();
    let all: Vec<_> =
        report["resonances"].as_array().unwrap().iter().map(|row| row["period"].as_u64()).collect();
    assert_eq!((code, all), (3, vec![Some(3), Some(6), Some(9), Some(12)]));
    assert!(report["resonances"][0]["resonance"].is_null());
    let (_, out, _) = run("word --r 1 --s 1/6");
    assert!(
        out.contains("n = 3, ..., u_n = 0\nTheorem 1 is silent about patterns with such a period"),
        "{out}"
    );
    let (_, out, _) = run("word --r 1/2 --s 1/6 --format json");
    let report: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(report["resonances"][0], serde_json::json!({ "period": 3, "resonance": "first" }));
    // u_5 = 0, and Theorem 1 is silent about patterns of several impacts with the period 5.
    let (code, out, _) = run("word --r 1/10 --s 2/5");
    assert_eq!(code, 3);
    assert!(
        out.contains(
            "in none of the four cases (sign e*mu, sign gamma) by patterns without such a period.\n"
        ),
        "{out}"
    );
}
