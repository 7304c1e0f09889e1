//! Proofs in every unit of length, and of a parameter that is one: the same verdicts, and the same ends.

use grazing_scenes::certificate;
use serde_json::Value;

use crate::{
    samples::one_in,
    tasks::{run, task},
};

/// So many lengths, a length being a number times a power of ten.
fn times([factor, power]: [i32; 2], x: f64) -> String {
    format!("{}e{power}", x * f64::from(factor))
}

/// The paper's oscillator in other lengths, its parameter the amplitude of the wall, a length too.
fn scene(length: [i32; 2]) -> String {
    let (length, amplitude) = (times(length, 1.0), times(length, 0.95));
    format!(
        "format = \"grazing-scene 3\"\ntitle = \"units\"\n[parameters]\nL = \"{length}\"\nA = \"{amplitude}\"\n\
         [system]\ndamping = \"12/49\"\nstiffness = \"1/4.9^2\"\n\
         [[stops]]\nside = \"lower\"\noffset = \"-L\"\nrestitution = 1\nharmonics = [{{ k = 1, cos = \"A\" }}]\n"
    )
}

/// What is proved, in units of the length.
#[derive(Debug, PartialEq)]
struct Found {
    verdicts: Vec<String>,
    /// Speeds, values of events, ends of ranges.
    numbers: Vec<f64>,
    /// Between parts that are stable and unstable.
    flips: Vec<f64>,
}

fn found(length: [i32; 2]) -> Found {
    let of = |x: f64| times(length, x);
    let tasks = [
        task("orbit", "validate", "orbit = { pattern = [4] }"),
        task(
            "flip",
            "validate",
            &format!(
                "set = {{ A = {} }}\norbit = {{ pattern = [3] }}\nevent = \"flip\"\nparameter = \"A\"",
                of(1.005)
            ),
        ),
        task(
            "touch",
            "validate",
            &format!(
                "set = {{ A = {} }}\norbit = {{ pattern = [] }}\nevent = \"grazing\"\nparameter = \"A\"",
                of(0.999)
            ),
        ),
        task(
            "range",
            "validate",
            &format!(
                "set = {{ A = {} }}\norbit = {{ pattern = [3] }}\nparameter = \"A\"\nfrom = {}\nto = {}",
                of(1.005),
                of(1.003),
                of(1.01)
            ),
        ),
    ];
    let folder = tempfile::tempdir().unwrap();
    let (report, code, error) = run(&scene(length), &tasks, folder.path());
    assert_eq!(code, 0, "{length:?}: {error} {report}");
    let unit: f64 = of(1.0).parse().unwrap();
    let mut found = Found { verdicts: Vec::new(), numbers: Vec::new(), flips: Vec::new() };
    for task in report["tasks"].as_array().unwrap() {
        for row in task["proofs"].as_array().unwrap() {
            found.verdicts.push(format!("{} {} {}", task["task"], row["verdict"], row["stable"]));
            let number = |x: &Value| x.as_str().and_then(|x| x.parse::<f64>().ok());
            let speeds = row["speeds"].as_array().into_iter().flatten().filter_map(number);
            let ends = ["parameter", "lower", "upper"].iter().filter_map(|name| number(&row[*name]));
            let parts = row["stability"].as_array().into_iter().flatten();
            let parts = parts.flat_map(|part| [number(&part["from"]), number(&part["to"])]).flatten();
            found.numbers.extend(speeds.chain(ends).map(|x| x / unit));
            found.flips.extend(parts.map(|x| x / unit));
            let file = folder.path().join(row["certificate"].as_str().unwrap());
            let text = std::fs::read(&file).unwrap();
            certificate::check(&mut &text[..]).unwrap();
            let units = String::from_utf8(text).unwrap().contains("\nunits ");
            assert_eq!(units, length != [1, 0], "{length:?}, {}", file.display());
        }
    }
    found
}

/// From a nanometre in metres to a thousand kilometres in millimetres, and farther.
#[test]
fn what_is_proved_is_so_in_every_unit() {
    let own = found([1, 0]);
    assert_eq!(own.verdicts.len(), 5, "{own:?}");
    assert!(own.numbers.len() == 11 && own.flips.len() == 4, "{own:?}");
    let lengths = [[1, -30], [1, -9], [2, -6], [1, -3], [7, 2], [3, 5], [1, 9], [1, 30]];
    // The first and the last, and those between in larger samples.
    for length in lengths.into_iter().step_by(one_in(7)) {
        let there = found(length);
        assert_eq!(there.verdicts, own.verdicts, "{length:?}");
        // A cell at a flip is a 2048th of the range at most, or the part about it that is open.
        for (all, known, apart) in
            [(&there.numbers, &own.numbers, 1e-12), (&there.flips, &own.flips, 0.007 / 2048.0)]
        {
            assert_eq!(all.len(), known.len(), "{length:?}: {there:?} for {own:?}");
            for (x, y) in all.iter().zip(known) {
                assert!((x - y).abs() <= apart * y.abs(), "{length:?}: {x} for {y}");
            }
        }
    }
}
