//! `grazing word` and `grazing classify` on boxes, by the command: verdicts, shares, witnesses, exit codes.

use std::process::Command;

use serde_json::{Value, json};

fn run(arguments: &str) -> (i32, String, String) {
    let mut command = Command::new(crate::PROGRAM);
    let output = command.args(arguments.split_whitespace()).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

fn json(arguments: &str) -> (i32, Value) {
    let (code, out, error) = run(&format!("{arguments} --format json"));
    (code, serde_json::from_str(&out).unwrap_or_else(|_| panic!("{arguments}: {out}{error}")))
}

const MACHINE: &str = "--frequency 12.3Hz±1% --damping-ratio 0.02±20% --drive 10Hz";

/// Where all points have one word it is that of a point; where not, both witnesses of a verdict are what they
/// are said to be.
#[test]
fn shares_name_points_that_the_word_at_them_confirms() {
    let (code, all) = json("word --r 0.9 --s 0.37..=0.371");
    let (_, point) = json("word --r 0.9 --s 0.3705");
    assert_eq!((code, &all["words"]), (0, &point["words"]));
    let (code, text, _) = run(&format!("word {MACHINE}"));
    assert_eq!(code, 3, "{text}");
    // In one case chaos is certain; of two it is said that it is not.
    assert!(
        text.contains("\n  (-,+) with entropy") && text.contains("\nNot decided: (+,+), (+,-)"),
        "{text}"
    );

    let (code, shares) = json(&format!("word {MACHINE} --shares --cells 400 --max-period 3"));
    assert_eq!((code, shares["cells"].as_u64()), (0, Some(399)), "{shares}");
    let chaos = &shares["chaos"][0];
    assert_eq!((&chaos["sign_emu"], &chaos["verdict"]), (&1.into(), &"differs".into()), "{chaos}");
    let bound = |i: usize| chaos["share"][i].as_str().unwrap().parse::<f64>().unwrap();
    assert!(bound(0) < bound(1) && bound(1) < bound(0) + 0.02, "{chaos}");
    for (at, expected) in [("with", true), ("without", false)] {
        let place = |i: usize| chaos[at][i].as_str().unwrap();
        let (_, word) =
            json(&format!("word --frequency {} --damping-ratio {} --drive 1", place(0), place(1)));
        assert_eq!(word["box"]["sign_gamma"], 1);
        let case = &word["words"][0]["cases"][0];
        assert_eq!((&case["sign_gamma"], &case["chaotic"]), (&1.into(), &expected.into()), "{at}: {word}");
    }
    assert_eq!(shares["chaos"][1]["verdict"], "everywhere", "{shares}");
    // More cells, narrower bounds around the same number.
    let (_, finer) = json(&format!("word {MACHINE} --shares --cells 1600"));
    let inner = |i: usize| finer["chaos"][0]["share"][i].as_str().unwrap().parse::<f64>().unwrap();
    assert!(bound(0) < inner(0) && inner(1) < bound(1), "{finer}");
}

/// Across a border, in a box however narrow, the text names two points that lie in it, exactly.
#[test]
fn witnesses_of_a_narrow_box_lie_in_it() {
    let chaotic = |ratio: f64| {
        let (_, word) = json(&format!("word --frequency {ratio} --damping-ratio 0.02 --drive 1"));
        word["words"][0]["cases"][0]["chaotic"] == true
    };
    let (mut lo, mut hi) = (1.22, 1.24);
    assert!(chaotic(lo) != chaotic(hi));
    while hi - lo > 1e-9 {
        let middle = (lo + hi) / 2.0;
        if chaotic(middle) == chaotic(lo) { lo = middle } else { hi = middle }
    }
    let asked =
        format!("word --frequency {lo}..={hi} --damping-ratio 0.02 --drive 1 --shares --max-period 4");
    let (_, text, _) = run(&asked);
    let line = text.lines().find(|line| line.contains("so at ")).unwrap_or_else(|| panic!("{text}"));
    let places: Vec<f64> = line
        .split("natural/drive = ")
        .skip(1)
        .map(|rest| rest.split(',').next().unwrap().parse().unwrap())
        .collect();
    let [with, without] = places[..] else { panic!("{line}") };
    assert!([with, without].iter().all(|place| (lo..=hi).contains(place)), "{line}: {lo} to {hi}");
    assert_eq!((chaotic(with), chaotic(without)), (true, false), "{line}");
}

#[test]
fn a_table_of_a_box_has_the_verdicts_of_its_periods() {
    let (code, table) = json(&format!("classify {MACHINE} --max-period 5"));
    assert_eq!(code, 0, "{table}");
    let row = |n: u64| table["rows"].as_array().unwrap().iter().find(|row| row["n"] == n).unwrap();
    for (n, verdict) in
        [(1, "everywhere"), (2, "everywhere"), (3, "everywhere"), (4, "differs"), (5, "nowhere")]
    {
        assert_eq!(row(n)["existence"], verdict, "{table}");
    }
    // A box of one point in r says what the point says.
    let (_, point) = json("classify --r 0.97 --s 0.37 --max-period 9");
    let (_, thin) = json("classify --r 0.97 --s 0.37..=0.3700001 --max-period 9");
    for n in 1..=9 {
        let cases = |table: &Value, with: &str| {
            let rows = table["rows"].as_array().unwrap().iter().filter(|row| row["n"] == n);
            let some = rows.filter(|row| row["existence"] == with);
            let mut cases: Vec<_> =
                some.map(|r| (r["sign_emu"].as_i64(), r["sign_gamma"].as_i64())).collect();
            cases.sort_unstable();
            cases
        };
        assert_eq!(cases(&point, "orbit"), cases(&thin, "everywhere"), "{n}");
    }
}

#[test]
fn what_cannot_be_asked_is_said() {
    for (arguments, says) in [
        ("word --frequency 12Hz --damping-ratio 0.1 --drive 10", "units of one kind, not Hz and none"),
        ("word --frequency 12Hz --damping-ratio 0.1 --drive 10rad/s", "units of one kind"),
        ("word --frequency 12Hz±200% --damping-ratio 0.1 --drive 10Hz", "above 0"),
        ("word --frequency 12Hz --damping-ratio 0.1±200% --drive 10Hz", "from 0 to 1000"),
        ("word --frequency 12Hz --damping-ratio 0.1 --drive 0Hz", "--drive"),
        ("word --frequency 1 --damping-ratio 0.1 --drive 1±1% --shares", "give --drive as one number"),
        ("classify --frequency 1 --damping-ratio 0.1 --drive 1±1%", "give it as one number"),
        ("word --r 0.99±2% --s 0.3", "for r > 1 reverse time"),
        ("word --r 0.9 --s 0.3±90%", "0 < s < 1/2"),
        ("word --r 0.9 --s 0.3 --shares", "at least one coordinate as an interval"),
        ("word --r 0.9 --s 0.3±1% --returns", "at one point"),
        ("word --r 0.9 --s 0.3±1% --certificate w.txt", "of other boxes there is one of a share"),
        ("word --r 0.9±1% --s 0.3 --shares --cells 0", "--cells 0"),
        ("word --r 0.9±1% --s 0.3 --shares --format dot", "leave out --shares"),
        ("word --frequency 1Hz --drive 1Hz", "--damping-ratio"),
        ("word --r 0.9±1% --s 0.3 --cells 7", "--shares"),
        ("word --r 0.9±1% --s 0.3 --shares --decides", "--decides"),
        ("word --r 1.1 --s 0.3 --decides", "for r > 1 reverse time"),
        ("word --r 0.9 --s 0.3 --decides --format dot", "leave out --decides"),
        ("word --r 0.9 --s 0.3 --decides --max-period 500", "--max-period 500"),
        ("word --r 0.9±1% --s 0.3 --normal", "--shares"),
        ("word --r 0.9..=0.91 --s 0.3±1% --shares --normal", "as X±Y"),
    ] {
        let (code, out, error) = run(arguments);
        assert!(code == 2 && error.contains(says), "{arguments}: {code} {out}{error}");
    }
}

/// Every change that is named is one by `word` at machines just before it and just at it, in every parameter.
#[test]
fn what_decides_is_confirmed_by_the_word_at_both_of_its_ends() {
    let machine = |values: &[String]| {
        let [f, z, d] = values else { panic!("{values:?}") };
        json(&format!("word --frequency {f} --damping-ratio {z} --drive {d}")).1
    };
    let (code, decides) =
        json("word --frequency 12.3Hz±1% --damping-ratio 0.02±20% --drive 600rpm --decides --max-period 4");
    assert!(code == 0 || code == 3, "{decides}");
    let given: Vec<(String, f64)> = decides["parameters"]
        .as_array()
        .unwrap()
        .iter()
        .map(|parameter| {
            let unit = parameter["unit"].as_str().unwrap_or("");
            (unit.to_string(), fraction(&parameter["value"]))
        })
        .collect();
    assert_eq!(
        given.iter().map(|(unit, x)| (unit.as_str(), *x)).collect::<Vec<_>>(),
        [("Hz", 12.3), ("", 0.02), ("rpm", 600.0)]
    );
    let start = [json!("123/10"), json!("1/50"), json!("600")];
    let mut confirmed = 0;
    for question in decides["questions"].as_array().unwrap() {
        let side = usize::from(question["sign_emu"] == -1);
        for change in question["changes"].as_array().unwrap() {
            let moved =
                ["frequency", "damping_ratio", "drive"].iter().position(|n| change["parameter"] == *n);
            let moved = moved.unwrap();
            let at = |value: &Value| {
                let mut values = start.clone();
                values[moved] = value.clone();
                let with_unit = |(value, (unit, _)): (&Value, &(String, f64))| {
                    format!("{}{unit}", value.as_str().unwrap())
                };
                machine(&values.iter().zip(&given).map(with_unit).collect::<Vec<_>>())
            };
            let [before, by] = ["unchanged_to", "changed_by"].map(|end| &change[end]);
            let grows = change["direction"] == 1;
            assert_eq!(fraction(before) > given[moved].1, grows, "{change}");
            if change["verdict"] != "changes" {
                continue;
            }
            let whole = change["whole_box"] == true;
            let width = (fraction(by) - fraction(before)).abs() / given[moved].1;
            assert!(width < if whole { 1e-2 } else { 1e-7 }, "{width} {change}");
            let truth = |word: &Value| match question["what"].as_str().unwrap() {
                "chaos" => {
                    let gamma = word["box"]["sign_gamma"].clone();
                    let case = &word["words"][side]["cases"][usize::from(gamma == -1)];
                    assert_eq!(case["sign_gamma"], gamma);
                    json!([gamma, case["chaotic"]])
                }
                "word" => word["words"][side]["letters"].clone(),
                _ => {
                    let periods = word["words"][side]["periods"].as_array().unwrap().clone();
                    json!(periods.contains(&question["n"]))
                }
            };
            let origin = machine(&["12.3Hz".into(), "0.02".into(), "600rpm".into()]);
            assert_eq!(truth(&at(before)), truth(&origin), "{question}");
            // Of all of the box it is said where the first machine changes, not that this one does.
            assert!(whole || truth(&at(by)) != truth(&origin), "{question}");
            confirmed += usize::from(!whole);
        }
    }
    assert!(confirmed > 12, "{confirmed}: {decides}");
}

/// An exact number as JSON has it.
fn fraction(value: &Value) -> f64 {
    let text = value.as_str().unwrap();
    let (above, below) = text.split_once('/').unwrap_or((text, "1"));
    above.parse::<f64>().unwrap() / below.parse::<f64>().unwrap()
}

/// A distribution is concentrated about its middle: within ±1 deviation are 68 % of each parameter, and what
/// is everywhere in the box is at least so likely as the cells cover.
#[test]
fn normal_shares_count_by_their_probability() {
    let (code, shares) = json("word --r 0.9 --s 0.2±0.05 --shares --normal --cells 600 --max-period 3");
    let bounds = |row: &Value| [0, 1].map(|i| row["share"][i].as_str().unwrap().parse::<f64>().unwrap());
    let row = |n: u64| {
        let rows = shares["periods"].as_array().unwrap();
        bounds(rows.iter().find(|row| row["sign_emu"] == -1 && row["n"] == n).unwrap())
    };
    // For eµ < 0 period 2 occurs where s < 1/4, one deviation above the middle, and period 3 where s < 1/6.
    let all = |[lower, upper]: [f64; 2], truth: f64| lower <= truth && truth <= upper && upper - lower < 1e-4;
    assert!(all(row(2), 0.841_344_746) && all(row(3), 0.252_492_538), "{shares}");
    assert!(all(row(1), 1.0), "{shares}");
    assert_eq!(shares["normal"]["s"], json!(["1/5", "1/20"]));
    assert_eq!(code, 0, "{shares}");
}

#[test]
fn samples_are_counted_one_by_one() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("machines.csv");
    let rows: Vec<[f64; 3]> =
        (0..40).map(|i| [12.1 + 0.01 * f64::from(i), 0.016 + 0.0002 * f64::from(i * 7 % 40), 10.0]).collect();
    let text: String = rows.iter().map(|[f, z, d]| format!("{d},x,{z:.4},{f:.2}\n")).collect();
    std::fs::write(&file, format!("drive, note, damping_ratio, frequency\n{text}")).unwrap();
    let (code, counted) = json(&format!("word --samples {} --max-period 4", file.display()));
    assert_eq!((code, &counted["samples"]), (0, &json!(40)), "{counted}");
    let truth = rows.iter().filter(|[f, z, d]| {
        let (_, word) = json(&format!("word --frequency {f:.2} --damping-ratio {z:.4} --drive {d}"));
        assert_eq!(word["box"]["sign_gamma"], 1);
        word["words"][0]["cases"][0]["chaotic"] == true
    });
    let share = format!("{:.6}", truth.count() as f64 / 40.0);
    assert_eq!(counted["chaos"][0]["share"], json!([share, share]), "{counted}");
    let (_, text, _) = run(&format!("word --samples {}", file.display()));
    assert!(text.contains("Counted, which bounds no share of others: 40 samples"), "{text}");
    for (text, says) in [
        ("frequency,drive\n1,1\n", "one of these sets: frequency,damping_ratio,drive; ratio,"),
        ("r,s\n", "no samples"),
        ("r,s\n0.9,0.3\n0.9,x\n", "sample 2"),
        ("r,s\n0.9,0.7\n", "sample 1: s from 7/10"),
        ("frequency,damping_ratio,drive\n1,0.1,0\n", "a drive of 0"),
    ] {
        std::fs::write(&file, text).unwrap();
        let (code, _, error) = run(&format!("word --samples {}", file.display()));
        assert!(code == 2 && error.contains(says), "{text}: {error}");
    }
}
