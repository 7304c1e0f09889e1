//! `grazing boundary`: what it prints, and what users get wrong.

use std::path::Path;

use crate::process::run;

fn stdout(arguments: &str) -> String {
    let (code, out, err) = run(arguments, Path::new("."));
    assert_eq!((code, err.as_str()), (0, ""), "grazing {arguments}");
    out
}

#[test]
fn command_prints_certified_digits() {
    let json: serde_json::Value =
        serde_json::from_str(&stdout("boundary 8 --format json --digits 15")).unwrap();
    assert_eq!(json["format"], "grazing-boundary 1");
    let rows = json["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 5);
    assert_eq!(rows[0]["lowest"], "interval");
    assert_eq!(rows[0]["deciding"], serde_json::Value::Null);
    assert_eq!(rows[3]["lowest"], "tip");
    // Of many more digits, these: 0.94489473629889703062…
    assert_eq!(rows[3]["r_lower"], "0.944894736298897");
    assert_eq!(rows[3]["r_upper"], "0.944894736298898");
    assert_eq!(rows[3]["scaled"], "28.213895");
    assert_eq!(
        stdout("boundary 9 --m 4 --format csv").lines().last().unwrap().split(',').nth(5),
        Some("region4")
    );
    let csv = stdout("boundary 3..=5 --grid 3 --format csv");
    assert_eq!(csv.lines().count(), 1 + 3 * (3 + 3 + 5));
    // b_{3,2} = 0 is a₁ + a₂ = 0.
    assert!(
        csv.contains("3,1,1,1,2,7/24,0.517638090205,0.517638090206,0.267949192431,0.267949192432\n"),
        "{csv}"
    );
}

#[test]
fn command_names_what_is_wrong() {
    let cases = [
        ("boundary 8 --m 2", "period 8 has no area at m = 2: m is 0, or at most 4 and coprime to 8"),
        ("boundary 1", "`grazing boundary` starts at period 2"),
        ("boundary 100001", "`grazing boundary` goes up to period 100000, not 100001"),
        ("boundary 8 --digits 0", "--digits 0 is out of bounds: 1 to 1000"),
        ("boundary 8 --grid 0", "--grid 0 is out of bounds: 1 to 1000000"),
    ];
    for (arguments, expected) in cases {
        let (code, out, err) = run(arguments, Path::new("."));
        assert_eq!((code, out.as_str(), err.lines().count()), (2, "", 1), "{err}");
        assert!(err.contains(expected), "grazing {arguments}: {err}");
    }
    assert!(stdout("boundary --help").contains("Exit code 0:"));
}
