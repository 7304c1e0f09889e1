//! Tasks of kind `branch` that prove what they follow, piece by piece.

use std::{fs, path::Path};

use serde_json::Value;

use crate::{
    proved_ranges::nordmark,
    tasks::{refused, run, task},
};

const KEYS: &str = "parameter = \"mu\"\nrange = [-0.09, 0.05]\nprove = true\noptions = { beyond = true }\n\
                    starts = [{ orbit = { pattern = [4] } }, { at = 0.005, orbit = { pattern = [3] } }]";

/// The rows of a CSV file by column names.
fn rows(file: &Path) -> Vec<std::collections::HashMap<String, String>> {
    csv::Reader::from_path(file).unwrap().deserialize().collect::<Result<_, _>>().unwrap()
}

fn float(text: &str) -> f64 {
    text.parse().unwrap()
}

/// Both orbits of period 4 meet in a saddle-node: two pieces. Each is proved nearly to its ends, and points
/// of the branch have the certificate of their piece but for those at the ends, and those beyond a grazing or
/// a fade, which are no orbits.
#[test]
fn pieces_are_proved_nearly_to_their_ends() {
    let folder = tempfile::tempdir().unwrap();
    let (report, code, error) = run(nordmark(), &[task("four", "branch", KEYS)], folder.path());
    assert_eq!(code, 0, "{error}");
    let proofs = report["tasks"][0]["proofs"].as_array().unwrap();
    let branches: Vec<u64> = proofs.iter().map(|row| row["branch"].as_u64().unwrap()).collect();
    assert_eq!(branches, [1, 1, 2]);
    let certificates: Vec<&str> = proofs.iter().map(|row| row["certificate"].as_str().unwrap()).collect();
    assert_eq!(certificates, ["four-1.certificate", "four-2.certificate", "four-3.certificate"]);
    let words = |row: &Value| -> Vec<String> {
        row["stability"]
            .as_array()
            .unwrap()
            .iter()
            .map(|part| part["word"].as_str().unwrap().into())
            .collect()
    };
    let mut of_four = [words(&proofs[0]), words(&proofs[1])];
    of_four.sort();
    assert_eq!(of_four, [["stable"], ["unstable"]]);
    assert_eq!(words(&proofs[2]), ["unstable", "stable"]);
    for row in proofs {
        let ends = ["from", "to"].map(|key| row[key].as_f64().unwrap());
        let proved = ["lower", "upper"].map(|key| float(row[key].as_str().unwrap()));
        let part = 1e-4 * (ends[1] - ends[0]);
        assert!(ends[0] <= proved[0] && proved[0] < ends[0] + part, "{row}");
        assert!(ends[1] - part < proved[1] && proved[1] <= ends[1], "{row}");
        let text = fs::read_to_string(folder.path().join(row["certificate"].as_str().unwrap())).unwrap();
        assert!(grazing_scenes::certificate::check(&mut text.as_bytes()).is_ok());
    }
    let points = rows(&folder.path().join("four-points.csv"));
    for point in &points {
        let at = float(&point["parameters"]);
        let own: Vec<&Value> = proofs
            .iter()
            .filter(|row| row["branch"].as_u64() == point["branch"].parse().ok())
            .filter(|row| row["certificate"] == point["certificate"].as_str())
            .collect();
        match own[..] {
            [row] => {
                let proved = ["lower", "upper"].map(|key| float(row[key].as_str().unwrap()));
                assert!(proved[0] <= at && at <= proved[1], "{point:?}");
                let stable = &point["stable"];
                assert!(stable == "marginal" || words(row).contains(&word(stable)), "{point:?}");
            }
            _ => {
                assert_eq!(point["certificate"], "");
                let near = |row: &Value| {
                    ["from", "to"].iter().any(|key| (row[*key].as_f64().unwrap() - at).abs() < 1e-6)
                };
                assert!(point["admissible"] == "no" || proofs.iter().any(near), "{point:?}");
            }
        }
    }
    assert!(points.iter().filter(|point| !point["certificate"].is_empty()).count() > 30);
    // The picture's data say the same.
    let drawn = rows(&folder.path().join("four.csv"));
    assert_eq!(drawn.len(), points.len());
    for (drawn, point) in drawn.iter().zip(&points) {
        assert_eq!(drawn["proved"] == "yes", !point["certificate"].is_empty());
    }
}

fn word(stable: &str) -> String {
    if stable == "yes" { "stable" } else { "unstable" }.into()
}

/// What is left of a piece is said: the motion without impacts is not proved.
#[test]
fn what_is_not_proved_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let keys = "parameter = \"mu\"\nrange = [-0.09, -0.01]\nprove = true\n\
                starts = [{ orbit = { pattern = [] } }]";
    let (report, code, error) = run(nordmark(), &[task("free", "branch", keys)], folder.path());
    assert_eq!(code, 3, "{error}");
    let proofs = report["tasks"][0]["proofs"].as_array().unwrap();
    assert_eq!(proofs.len(), 1);
    assert_eq!((proofs[0]["verdict"].as_str(), &proofs[0]["certificate"]), (Some("undecided"), &Value::Null));
    assert!(report["tasks"][0]["reason"].as_str().unwrap().contains("without impacts"), "{report}");
    // A branch that ends where it begins has no piece: that is no proof of it.
    let keys = "parameter = \"mu\"\nrange = [-0.09, -0.05]\ndirection = \"up\"\nprove = true\n\
                starts = [{ orbit = { pattern = [4] } }]";
    let (report, code, error) = run(nordmark(), &[task("end", "branch", keys)], folder.path());
    assert_eq!(code, 3, "{error}");
    let rows = report["tasks"][0]["proofs"].as_array().unwrap();
    assert_eq!(rows.len(), 2);
    for row in rows {
        assert_eq!(
            (&row["verdict"], &row["from"], &row["to"]),
            (&"undecided".into(), &(-0.05).into(), &(-0.05).into())
        );
        assert!(row["reason"].as_str().unwrap().contains("no two points"), "{row}");
    }
    // Without the key nothing is said.
    let keys = keys.replace("prove = true\n", "").replace("direction = \"up\"\n", "");
    let (report, code, _) = run(nordmark(), &[task("free", "branch", &keys)], folder.path());
    assert_eq!((code, &report["tasks"][0]["proofs"]), (0, &Value::Null));
}

#[test]
fn what_cannot_be_proved_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let many = nordmark().replacen("[parameters]", "engine = \"many\"\n[parameters]", 1);
    let cubic = nordmark().replace("[[stops]]", "cubic = 1\n[[stops]]");
    for (scene, expected) in
        [(many.as_str(), "prove = true: works with one degree of freedom"), (&cubic, "linear")]
    {
        let error = refused(scene, &[task("no", "branch", KEYS)], folder.path());
        assert!(error.contains(expected), "{error}");
    }
    let second = "parameter = \"mu\"\nrange = [-0.09, 0.05]\nsecond = \"d\"\nsecond_range = [0.1, 1]\nprove = true\n\
                  starts = [{ restart = { file = \"a.json\", label = \"flip 1\" } }]";
    let error = refused(nordmark(), &[task("no", "branch", second)], folder.path());
    assert!(error.contains("over one parameter"), "{error}");
}
