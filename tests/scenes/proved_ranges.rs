//! Orbits that are proved over a range of a parameter, against where bifurcations of the paper's oscillator
//! are known to be, and against orbits that are proved by themselves.

use std::fs;

use grazing_scenes::certificate;
use serde_json::Value;

use crate::tasks::{refused, run, task};

const EXAMPLE: &str = include_str!("../../examples/scenes/nordmark-2001-branches.toml");

/// The paper's oscillator, without the example's tasks.
pub fn nordmark() -> &'static str {
    EXAMPLE.split("[[tasks]]").next().unwrap()
}

fn end(row: &Value, name: &str) -> f64 {
    row[name].as_str().unwrap().parse().unwrap()
}

/// Both orbits of period 4 are born at a saddle-node; the stable one ends at a grazing, the other at the
/// touch. Ranges that go beyond are proved to just before.
#[test]
fn ranges_end_where_orbits_do() {
    let folder = tempfile::tempdir().unwrap();
    let keys = "orbit = { pattern = [4] }\nparameter = \"mu\"\nfrom = -0.09\nto = 0.1";
    let (report, code, error) = run(nordmark(), &[task("far", "validate", keys)], folder.path());
    assert_eq!(code, 3, "{error}");
    let found = &report["tasks"][0];
    assert!(found["reason"].as_str().unwrap().contains("which is not all"), "{report}");
    let rows = found["proofs"].as_array().unwrap();
    assert_eq!(rows.len(), 2);
    for row in rows {
        assert_eq!(row["verdict"], "proved", "{row}");
        let (lower, upper) = (end(row, "lower"), end(row, "upper"));
        let stable = row["stability"][0]["word"] == "stable";
        let last = if stable { -0.024_447_456_306 } else { 0.0 };
        assert!((0.0..1e-6).contains(&(lower + 0.084_338_470_09)), "{row}");
        assert!((0.0..1e-6).contains(&(last - upper)), "{row}");
        let ends = row["range_ends"].as_str().unwrap();
        assert!(ends.starts_with("down: Krawczyk") && ends.contains("; up: "), "{ends}");
        let text = fs::read(folder.path().join(row["certificate"].as_str().unwrap())).unwrap();
        let checked = certificate::check(&mut &text[..]).unwrap();
        assert_eq!(checked.kind, "branch");
    }
}

/// Where it says stable or unstable, the orbit that is proved at that value alone is that; the flip of period
/// 3 is between, and a parameter of the flow, too, may vary.
#[test]
fn parts_are_stable_as_orbits_at_single_values_are() {
    let folder = tempfile::tempdir().unwrap();
    let at = |mu: &str| nordmark().replace("mu = -0.05", &format!("mu = {mu}"));
    let keys = "orbit = { pattern = [3] }\nparameter = \"mu\"\nfrom = 0.003\nto = 0.01";
    let (report, code, error) = run(&at("0.005"), &[task("flip", "validate", keys)], folder.path());
    assert_eq!(code, 0, "{error}");
    let row = &report["tasks"][0]["proofs"][0];
    assert!(row["stable"].is_null() && row["range_ends"].is_null(), "{row}");
    let parts = row["stability"].as_array().unwrap();
    let words: Vec<&str> = parts.iter().map(|part| part["word"].as_str().unwrap()).collect();
    assert_eq!(words, ["unstable", "stable"]);
    let flip = 0.005_479_046_221_2;
    assert!(end(&parts[0], "to") < flip && flip < end(&parts[1], "from"), "{row}");
    assert!(end(&parts[1], "from") - end(&parts[0], "to") < 1e-4, "{row}");
    for part in parts {
        for mu in [end(part, "from"), (end(part, "from") + end(part, "to")) / 2.0, end(part, "to")] {
            let keys = "orbit = { pattern = [3] }";
            let (report, code, _) =
                run(&at(&format!("{mu:?}")), &[task("one", "validate", keys)], folder.path());
            let stable = &report["tasks"][0]["proofs"][0]["stable"];
            assert_eq!((code, stable.as_bool()), (0, Some(part["word"] == "stable")), "{mu}: {report}");
        }
    }
    let keys = "orbit = { pattern = [4] }\nparameter = \"w\"\nfrom = 4.88\nto = 4.92";
    let (report, code, error) = run(nordmark(), &[task("w", "validate", keys)], folder.path());
    assert_eq!(code, 0, "{error}");
    for row in report["tasks"][0]["proofs"].as_array().unwrap() {
        assert_eq!((row["lower"].as_str(), row["upper"].as_str()), (Some("4.88"), Some("4.92")), "{row}");
    }
}

/// Ends where the oscillator is not defined, or that no certificate can hold, are the range's, and ends that
/// are no decimals are rounded inwards.
#[test]
fn edges_of_parameters_end_ranges() {
    let folder = tempfile::tempdir().unwrap();
    let row = |scene: &str, keys: &str| {
        let (report, code, error) = run(scene, &[task("edge", "validate", keys)], folder.path());
        let rows = report["tasks"][0]["proofs"].as_array().unwrap().clone();
        assert!(!rows.is_empty(), "{report} {error}");
        (rows, code)
    };
    // A restitution below 0 there is not.
    let (rows, code) = row(nordmark(), "orbit = { pattern = [4] }\nparameter = \"tau\"\nfrom = -0.5");
    assert_eq!(code, 3);
    for row in &rows {
        let (lower, upper) = (end(row, "lower"), end(row, "upper"));
        assert!(row["verdict"] == "proved" && (0.0..1.0).contains(&lower) && upper == 1.0, "{row}");
        assert!(row["range_ends"].as_str().unwrap().starts_with("down: "), "{row}");
    }
    // A third is no decimal.
    let third = nordmark().replace("mu = -0.05", "mu = \"-1/30\"");
    let (rows, code) = row(&third, "orbit = { pattern = [4] }\nparameter = \"mu\"\nto = \"-2/61\"");
    assert_eq!(code, 0);
    for row in &rows {
        let ends = (row["lower"].as_str(), row["upper"].as_str());
        assert_eq!(ends, (Some("-0.03333333333333333333"), Some("-0.03278688524590163935")), "{row}");
    }
    for (keys, expected) in
        [("from = -0.05\nto = \"-0.05 + 10^-16\"", "shorter than 10^-15"), ("to = 1e10", "below 2^30")]
    {
        let keys = format!("orbit = {{ pattern = [4] }}\nparameter = \"mu\"\n{keys}");
        let (rows, code) = row(nordmark(), &keys);
        assert_eq!(code, 3);
        assert!(rows[0]["reason"].as_str().unwrap().contains(expected), "{rows:?}");
    }
}

#[test]
fn ranges_that_cannot_be_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let parameter = "orbit = { pattern = [4] }\nparameter = \"mu\"\n";
    for (keys, expected) in [
        (format!("{parameter}from = -0.01"), "is above the scene's mu"),
        (format!("{parameter}to = -0.06"), "is below the scene's mu"),
        (format!("{parameter}from = -0.05\nto = -0.05"), "a least and a greatest value"),
        (parameter.to_string(), "varies in no way"),
        (format!("{parameter}from = -0.06\nevent = \"flip\""), "leave `from` and `to` out"),
        ("orbit = { pattern = [4] }\nfrom = -0.06".into(), "has no parameter"),
        ("orbit = { pattern = [] }\nparameter = \"mu\"\nfrom = -0.06".into(), "must have an impact"),
        ("orbit = { pattern = [4] }\nparameter = \"nu\"\nfrom = -0.06".into(), "nu"),
    ] {
        let error = refused(nordmark(), &[task("v", "validate", &keys)], folder.path());
        assert!(error.contains(expected), "{keys}: {error}");
    }
}
