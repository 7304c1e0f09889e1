//! `grazing word` and `grazing classify` on boxes, by the command: verdicts, shares, witnesses, exit codes.

use std::process::Command;

use serde_json::Value;

fn run(arguments: &str) -> (i32, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_grazing"));
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
        ("word --r 0.9 --s 0.3±1% --certificate w.txt", "there is none yet of other boxes"),
        ("word --r 0.9±1% --s 0.3 --shares --cells 0", "--cells 0"),
        ("word --r 0.9±1% --s 0.3 --shares --format dot", "leave out --shares"),
        ("word --frequency 1Hz --drive 1Hz", "--damping-ratio"),
    ] {
        let (code, out, error) = run(arguments);
        assert!(code == 2 && error.contains(says), "{arguments}: {code} {out}{error}");
    }
}
