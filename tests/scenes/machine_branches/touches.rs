//! Touches of stops that give way, and kinks of the drive: events of a branch, and no end of it.

use std::f64::consts::TAU;

use super::{ALONE, labels, near, number, run, task};

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

/// Runge's and Kutta's rule over a period of x″ = F sgn sin t/w² − (c x′ w + x + x³)/w², t in radians of the
/// drive, its jump at the end of a step.
fn back(w: f64, force: f64, mut x: [f64; 2]) -> [f64; 2] {
    let steps = 2000;
    let h = TAU / f64::from(steps);
    for i in 0..steps {
        let sign = if i < steps / 2 { 1.0 } else { -1.0 };
        let field = |[q, u]: [f64; 2]| [u, (sign * force - 0.3 * u * w - q - q * q * q) / (w * w)];
        let to = |k: [f64; 2], h: f64| [x[0] + h * k[0], x[1] + h * k[1]];
        let k1 = field(x);
        let k2 = field(to(k1, h / 2.0));
        let k3 = field(to(k2, h / 2.0));
        let k4 = field(to(k3, h));
        x = [0, 1].map(|j| x[j] + h / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j]));
    }
    x
}

/// A square wave, a formula in t with a jump, is a drive in two pieces: folds of the branch, over its
/// frequency and over its force, are those of a second integration.
#[test]
fn a_square_wave_is_no_kink_of_the_motion() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "format = \"grazing-scene 3\"\ntitle = \"square wave\"\n[parameters]\nw = 1.5\nF = 1\n[system]\n\
                 period = \"2*pi/w\"\ndamping = 0.3\nstiffness = 1\ncubic = 1\nforce = \"F*sign(sin(t))\"\n";
    let keys = |over: &str, range: [f64; 2], start: &str| {
        format!(
            "parameter = \"{over}\"\nrange = {range:?}\nset = {{ w = 2 }}\nstarts = [{{ {start} }}]\noptions = {{ most_step = 1 }}"
        )
    };
    let tasks = [
        task("over-w", "branch", &keys("w", [2.04, 2.12], "at = 2.05, orbit = { start = [-2.09, 0.9654] }")),
        task("over-f", "branch", &keys("F", [0.88, 0.96], "at = 0.95, orbit = { start = [-2.02, 0.9726] }")),
    ];
    let (found, code, error) = run(scene, &tasks, folder.path());
    assert_eq!(code, 0, "{error}{found}");
    for (i, name) in ["over-w", "over-f"].into_iter().enumerate() {
        let all = labels(&found["tasks"][i]);
        let folds: Vec<f64> = all
            .iter()
            .filter(|row| row.0.contains("saddle-node"))
            .map(|row| number(&row.1["parameters"][0]))
            .collect();
        assert_eq!(folds.len(), 1, "{name}: {found}");
        let file = std::fs::read_to_string(folder.path().join(format!("{name}.json"))).unwrap();
        let file: serde_json::Value = serde_json::from_str(&file).unwrap();
        for point in file["points"].as_array().unwrap() {
            let here = number(&point["parameters"][0]);
            let (w, force) = if i == 0 { (here, 1.0) } else { (2.0, here) };
            // Velocities are per unit of time in files, and per radian here.
            let z: Vec<f64> = point["unknowns"].as_array().unwrap().iter().map(number).collect();
            let [q, u] = [z[0], z[1]];
            let to = back(w, force, [q, u]);
            assert!((to[0] - q).abs() + (to[1] - u).abs() < 1e-8, "{name} {here}: {to:?} {q} {u}");
            if point["label"].as_str().is_some_and(|label| label.starts_with("saddle-node")) {
                // Differences of the second integration: a multiplier is 1.
                let step = 1e-5;
                let column = |d: [f64; 2]| {
                    let [more, less] = [1.0, -1.0].map(|s| back(w, force, [q + s * d[0], u + s * d[1]]));
                    [0, 1].map(|j| (more[j] - less[j]) / (2.0 * step))
                };
                let [a, b] = [column([step, 0.0]), column([0.0, step])];
                let fold = (1.0 - a[0]) * (1.0 - b[1]) - a[1] * b[0];
                near(fold, 0.0, 1e-6);
                near(a[0] * b[1] - a[1] * b[0], (-0.3 * TAU / w).exp(), 1e-8);
            }
        }
    }
}

/// (A³ − A⁴)(1 − A⁴)⁻¹, its upper right entry, A being the free motion of the paper's oscillator over a
/// period.
fn together(w: f64) -> f64 {
    let (damping, stiffness) = (0.6 / w, 1.0 / (w * w));
    let turn = (stiffness - damping * damping).sqrt();
    let (decay, (sin, cos)) = ((-damping * TAU).exp(), (turn * TAU).sin_cos());
    let (a, b) = (decay * (cos + damping / turn * sin), decay * sin / turn);
    let (c, d) = (-decay * stiffness / turn * sin, decay * (cos - damping / turn * sin));
    let map = nalgebra::Matrix2::new(a, b, c, d);
    let four = map * map * map * map;
    let all = (map * map * map - four) * (nalgebra::Matrix2::identity() - four).try_inverse().unwrap();
    all[(0, 1)]
}

/// A curve of grazings of an orbit with one impact in four periods comes to the place where that impact has
/// no speed. There it is at the touch of the free motion, µ = 0, and to first order the gap three periods
/// later vanishes with that of the impact: C (A³ − A⁴)(1 − A⁴)⁻¹ B = 0.
#[test]
fn a_curve_of_grazings_says_where_an_impact_fades() {
    let folder = tempfile::tempdir().unwrap();
    let tasks = [
        task(
            "one",
            "branch",
            "parameter = \"mu\"\nrange = [-0.1, 0.01]\nstarts = [{ at = -0.05, orbit = { pattern = [4] } }]",
        ),
        task(
            "two",
            "branch",
            "parameter = \"mu\"\nrange = [-0.3, 0.2]\nsecond = \"w\"\nsecond_range = [4, 6]\n\
             starts = [{ restart = { file = \"one.json\", label = \"grazing 1\" } }]",
        ),
    ];
    let (found, code, error) = run(ALONE, &tasks, folder.path());
    assert_eq!(code, 0, "{error}{found}");
    let end = found["tasks"][1]["starts"][0]["backward"].as_str().unwrap();
    let place = end.strip_prefix("an impact loses its speed, about at ").unwrap_or_else(|| panic!("{end}"));
    let [mu, w] = place.split(", ").map(|x| x.parse().unwrap()).collect::<Vec<f64>>()[..] else {
        panic!("{end}")
    };
    let (mut low, mut high) = (4.1, 4.3);
    assert!(together(low) * together(high) < 0.0);
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        *(if together(middle) * together(low) > 0.0 { &mut low } else { &mut high }) = middle;
    }
    near(mu, 0.0, 1e-8);
    near(w, low, 1e-7);
}

/// A spring beyond a gap is one as a stop, as a stop with a law and as a force with a kink: its branches have
/// the same labels, but that no touch is told of a kink; over the gap, too, which moves the kink.
#[test]
fn a_spring_beyond_a_gap_is_one_however_it_is_written() {
    let stop = "[[stops]]\nside = \"upper\"\noffset = \"e\"\n";
    let forms = [
        (String::new(), format!("{stop}stiffness = \"b\"\n")),
        (String::new(), format!("{stop}law = \"b*d\"\n")),
        ("force = \"-b*max(q - e, 0)\"\n".to_string(), String::new()),
    ];
    let tasks = [
        task("w", "branch", "parameter = \"w\"\nrange = [0.75, 1]\nstarts = [{ attractor = { q = 0 } }]"),
        task("e", "branch", "parameter = \"e\"\nrange = [0.7, 1.4]\nstarts = [{ attractor = { q = 0 } }]"),
    ];
    let told = forms.map(|(force, stop)| {
        let folder = tempfile::tempdir().unwrap();
        let system = format!(
            "format = \"grazing-scene 3\"\ntitle = \"rig\"\nengine = \"many\"\n[parameters]\nw = 0.79\ne = 1.26\nb = 29\n[system]\n\
             period = \"2*pi/w\"\ndamping = 0.02\nstiffness = 1\nforcing = [{{ sin = \"0.7*w^2\" }}]\n{force}{stop}"
        );
        let (found, code, error) = run(&system, &tasks, folder.path());
        assert!(code == 0 || code == 3, "{error}{found}");
        let one = |task: &serde_json::Value| -> Vec<(String, f64)> {
            labels(task).iter().map(|row| (row.0.clone(), number(&row.1["parameters"][0]))).collect()
        };
        found["tasks"].as_array().unwrap().iter().map(one).collect::<Vec<_>>()
    });
    println!("{told:#?}");
    for task in 0..2 {
        assert!(told[0][task].len() > 2, "{told:?}");
        for (form, other) in told.iter().enumerate().skip(1) {
            let wanted = told[0][task].iter().filter(|(name, _)| form < 2 || !name.contains("grazing"));
            let wanted: Vec<_> = wanted.collect();
            assert_eq!(wanted.len(), other[task].len(), "{told:?}");
            for (a, b) in wanted.iter().zip(&other[task]) {
                assert_eq!(a.0, b.0, "{told:?}");
                near(a.1, b.1, 1e-9);
            }
        }
    }
}
