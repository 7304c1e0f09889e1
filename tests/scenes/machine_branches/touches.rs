//! Touches of stops that give way: events of a branch, and no end of it.

use std::f64::consts::TAU;

use super::{labels, near, number, run, task};

/// x″ + 2ζx′ + x = a w² sin wt above the one and below the other of two springs.
const RIG: &str = r#"
format = "grazing-scene 3"
title = "two springs"
[parameters]
w = 0.7
a = 0.6
[system]
period = "2*pi/w"
damping = 0.3
stiffness = 1
forcing = [{ sin = "a*w^2" }]
[[stops]]
side = "upper"
offset = 0.8
stiffness = 0.5
[[stops]]
side = "lower"
offset = -1.0
stiffness = 9
"#;

/// The amplitude without stops.
fn amplitude(w: f64, a: f64) -> f64 {
    a * w * w / (1.0 - w * w).hypot(0.3 * w)
}

/// The first touch of each spring: of the upper one where the amplitude says; of the lower one where the
/// motion that meets the upper one comes down so far, as a second integration finds. The first is followed in
/// both parameters.
#[test]
fn touches_of_springs_are_labelled_and_followed() {
    let folder = tempfile::tempdir().unwrap();
    let over = "parameter = \"w\"\nrange = [0.6, 0.95]\n";
    let tasks = [
        task("one", "branch", &format!("{over}starts = [{{ attractor = {{ q = 0 }} }}]")),
        task(
            "two",
            "branch",
            &format!(
                "{over}second = \"a\"\nsecond_range = [0.4, 1]\n\
                 starts = [{{ restart = {{ file = \"one.json\", label = \"grazing 1\" }} }}]"
            ),
        ),
    ];
    let (found, code, error) = run(RIG, &tasks, folder.path());
    assert_eq!(code, 0, "{error}{found}");
    let all = labels(&found["tasks"][0]);
    let names: Vec<&str> =
        all.iter().map(|row| row.0.as_str()).filter(|name| name.contains("grazing")).collect();
    assert_eq!(names, ["1 grazing 1", "1 grazing 2"], "{found}");
    let at = |i: usize| {
        number(&all.iter().filter(|row| row.0.contains("grazing")).nth(i).unwrap().1["parameters"][0])
    };
    near(amplitude(at(0), 0.6), 0.8, 1e-10);
    // How far down it comes in the end, by Runge's and Kutta's rule in short steps.
    let lowest = |w: f64| {
        let field = |t: f64, [x, v]: [f64; 2]| {
            let spring = 0.5 * (x - 0.8).max(0.0);
            [v, 0.6 * w * w * (w * t).sin() - 0.3 * v - x - spring]
        };
        let (steps, mut x, mut low) = (4000, [0.0; 2], f64::INFINITY);
        let h = TAU / w / f64::from(steps);
        for i in 0..120 * steps {
            let t = f64::from(i % steps) * h;
            let to = |x: [f64; 2], k: [f64; 2], h: f64| [x[0] + h * k[0], x[1] + h * k[1]];
            let k1 = field(t, x);
            let k2 = field(t + h / 2.0, to(x, k1, h / 2.0));
            let k3 = field(t + h / 2.0, to(x, k2, h / 2.0));
            let k4 = field(t + h, to(x, k3, h));
            let next = [0, 1].map(|j| x[j] + h / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j]));
            if i >= 119 * steps && x[1] < 0.0 && next[1] >= 0.0 {
                // The least of a parabola through both.
                low = low.min(x[0] + x[1] * x[1] * h / (2.0 * (x[1] - next[1])));
            }
            x = next;
        }
        low
    };
    near(lowest(at(1)), -1.0, 1e-6);
    // The curve of the first touch, in closed form all along.
    let curve = std::fs::read_to_string(folder.path().join("two.json")).unwrap();
    let curve: serde_json::Value = serde_json::from_str(&curve).unwrap();
    let points = curve["points"].as_array().unwrap();
    assert!(points.len() > 10);
    for point in points {
        let place = &point["parameters"];
        near(amplitude(number(&place[0]), number(&place[1])), 0.8, 1e-9);
    }
    let ends: Vec<f64> = [0, points.len() - 1].map(|i| number(&points[i]["parameters"][1])).to_vec();
    assert!(ends.contains(&0.4) && ends.contains(&1.0), "{ends:?}");
}
