//! Branches that fold, close, double and end: that every event is there once and none that is none, for
//! oscillators and for machines.

use std::{
    f64::consts::{PI, TAU},
    fs,
    path::Path,
};

use serde_json::Value;

use crate::tasks::{near, number, run, task};

/// Two linear pieces, period 2π/w: a mass on a spring with a second one on one side.
const BILINEAR: &str = r#"
format = "grazing-scene 2"
title = "a second spring on one side"
[parameters]
w = 0.9
[system]
period = "2*pi/w"
mass = 1
damping = 0.05
stiffness = 1
forcing = [{ cos = 1 }]
[[walls]]
name = "second"
row = [1]
offset = 0
stiffness = 3
"#;

/// (label, parameters, row) of a task.
fn labelled(report: &Value, task: usize) -> Vec<(String, Vec<f64>, Value)> {
    let rows = report["tasks"][task]["labels"].as_array().unwrap_or_else(|| panic!("{report}"));
    let parameters = |row: &Value| row["parameters"].as_array().unwrap().iter().map(number).collect();
    rows.iter()
        .map(|row| (row["label"].as_str().unwrap().to_string(), parameters(row), row.clone()))
        .collect()
}

/// The first parameters of all labels of a kind.
fn of_kind(report: &Value, task: usize, kind: &str) -> Vec<f64> {
    let named = |label: &str| label.rsplit_once(' ').unwrap().0 == kind;
    labelled(report, task).iter().filter(|row| named(&row.0)).map(|row| row.1[0]).collect()
}

fn done(scene: &str, tasks: &[String], folder: &Path) -> Value {
    let (report, code, error) = run(scene, tasks, folder);
    assert_eq!(code, 0, "{error}{report}");
    report
}

/// A branch of doubled orbits bends back where it is born, and is followed from one flip to the other. The
/// flips come from the other branch, of period 1.
#[test]
fn a_doubled_branch_ends_at_its_flips_and_has_no_saddle_node_there() {
    let folder = tempfile::tempdir().unwrap();
    let starts = |at: f64| {
        format!("parameter = \"w\"\nrange = [0.5, 4]\nstarts = [{{ at = {at}, attractor = {{ q = 0 }} }}]")
    };
    let tasks = [task("one", "branch", &starts(1.5)), task("two", "branch", &starts(0.9))];
    let report = done(BILINEAR, &tasks, folder.path());
    let flips = of_kind(&report, 0, "flip");
    assert_eq!(flips.len(), 6);
    let mut crossings = of_kind(&report, 1, "crossing");
    crossings.sort_by(f64::total_cmp);
    assert_eq!(crossings.len(), 2, "{report}");
    near(crossings[0], flips[2], 1e-12);
    near(crossings[1], flips[3], 1e-12);
    let turns = of_kind(&report, 1, "saddle-node");
    assert_eq!(turns.len(), 2, "{turns:?}");
    assert!(turns.iter().all(|turn| crossings.iter().all(|at| (turn - at).abs() > 1e-3)), "{turns:?}");
    let row = &report["tasks"][1]["starts"][0];
    for end in ["backward", "forward"] {
        assert!(row[end].as_str().unwrap().contains("half the period"), "{row}");
    }
}

/// At each flip the doubled branch leaves across the parameter, not along it.
#[test]
fn every_flip_through_a_soft_stop_is_switched_at() {
    let folder = tempfile::tempdir().unwrap();
    let keys = "parameter = \"w\"\nrange = [0.5, 4]\n";
    let first = format!("{keys}starts = [{{ at = 1.5, attractor = {{ q = 0 }} }}]");
    let mut tasks = vec![task("p1", "branch", &first)];
    for i in 1..=6 {
        let start = format!("{{ restart = {{ file = \"p1.json\", label = \"flip {i}\", switch = true }} }}");
        tasks.push(task(&format!("sw{i}"), "branch", &format!("{keys}starts = [{start}]")));
    }
    let report = done(BILINEAR, &tasks, folder.path());
    let flips = of_kind(&report, 0, "flip");
    assert_eq!(flips.len(), 6);
    for (i, flip) in (1..).zip(flips) {
        let text = fs::read_to_string(folder.path().join(format!("sw{i}.json"))).unwrap();
        let branch: Value = serde_json::from_str(&text).unwrap();
        let points = branch["points"].as_array().unwrap();
        assert!(points.len() > 5, "flip {i}: {} points", points.len());
        near(number(&points[0]["parameters"][0]), flip, 1e-12);
        let place = |point: &Value| -> Vec<f64> {
            point["unknowns"].as_array().unwrap().iter().map(number).collect()
        };
        let (from, to) = (place(&points[0]), place(&points[1]));
        let moved = from.iter().zip(&to).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
        let along = (number(&points[1]["parameters"][0]) - flip).abs() / 3.5;
        assert!(along < 0.05 * moved, "flip {i}: {along:e} {moved:e}");
    }
}

fn one_wall(length: f64) -> String {
    format!(
        "format = \"grazing-scene 1\"\ntitle = \"one wall\"\n[parameters]\nF = 1\n[system]\ndamping = 0.06\nstiffness = 5.1\n\
         forcing = [{{ cos = \"{length}*F\" }}]\n[[walls]]\nside = \"upper\"\noffset = \"{length}*23/100\"\n\
         restitution = 0.67\n"
    )
}

/// The same in any unit of length; the doubled orbit is [1, 1] though its impacts lie on both sides of phase
/// 0.
#[test]
fn what_is_on_a_branch_does_not_depend_on_the_unit_of_length() {
    let folder = tempfile::tempdir().unwrap();
    let keys = "parameter = \"F\"\nrange = [0.5, 1.5]\nstarts = [{ attractor = { q = 0, u = 0 } }]";
    let found = [1.0, 4.0, 0.25, 10.0, 0.01, 100.0].map(|length| {
        let report = done(&one_wall(length), &[task("bra", "branch", keys)], folder.path());
        assert_eq!(report["tasks"][0]["starts"][0]["pattern"], "1,1", "{report}");
        labelled(&report, 0)
    });
    let kinds: Vec<&str> = found[0].iter().map(|row| row.0.rsplit_once(' ').unwrap().0).collect();
    for kind in ["crossing", "saddle-node", "fade"] {
        assert_eq!(kinds.iter().filter(|known| **known == kind).count(), 1, "{kinds:?}");
    }
    let crossing = found[0].iter().find(|row| row.0 == "crossing 1").unwrap();
    near(crossing.1[0], 1.034_937_787_792_108, 1e-12);
    for other in &found[1..] {
        assert_eq!(other.len(), found[0].len());
        for (a, b) in found[0].iter().zip(other) {
            assert_eq!(a.0, b.0);
            near(a.1[0], b.1[0], 1e-10);
            assert_eq!(a.2["criticality"], b.2["criticality"], "{}", a.0);
        }
    }
}

/// A pair of real multipliers with product 1 hides no pair that crosses the circle. The third value is from
/// another program.
#[test]
fn every_pair_that_passes_the_unit_circle_is_found() {
    let scene = r#"
format = "grazing-scene 2"
title = "three masses"
[parameters]
F = 0.30059882421500356
[system]
period = 3.8087671749065346
mass = { diagonal = [1.1773608176876045, 1.6497448554576795, 0.8906819272429878] }
damping = [[0.1932162182943442, -0.0666847430051767, 0.0], [-0.0666847430051767, 0.24190272181182465, -0.06412990259708759], [0.0, -0.06412990259708759, 0.12410532333243374]]
stiffness = [[2.0007320687643633, -1.1709847760785124, 0.0], [-1.1709847760785124, 2.2971065281974017, -1.126121752118889], [0.0, -1.126121752118889, 1.126121752118889]]
forcing = [{ cos = ["F", 0, 0] }]
[[walls]]
name = "w"
row = [-1.0, 1.0, 0.0]
offset = -0.37218878190665144
restitution = 0.8207331042271244
"#;
    let folder = tempfile::tempdir().unwrap();
    let keys = "parameter = \"F\"\nrange = [0.2, 0.35]\n\
                starts = [{ orbit = { pattern = [1], start = [0.15, 0.16973051741635883] } }]";
    let report = done(scene, &[task("br", "branch", keys)], folder.path());
    let mut found = of_kind(&report, 0, "neimark-sacker");
    found.sort_by(f64::total_cmp);
    assert_eq!(found.len(), 3, "{found:?}");
    for (at, want) in found.iter().zip([0.226_609_804_174_66, 0.245_815_843_284, 0.323_515_507_748]) {
        near(*at, want, 1e-11);
    }
    let row = labelled(&report, 0).into_iter().find(|row| row.1[0] == found[0]).unwrap().2;
    let all = row["multipliers"].as_array().unwrap();
    let on = |one: &Value| {
        let [re, im] = [0, 1].map(|i| number(&one[i]));
        (re - 0.1757).abs() < 1e-4 && (re.hypot(im) - 1.0).abs() < 1e-9
    };
    assert!(all.iter().any(on), "{all:?}");
}

/// The drag c at which a ball thrown with restitution 9/10 meets the table at speed W of the table.
fn drag(w: f64) -> f64 {
    let r = 0.9;
    let speed = |c: f64| {
        let e = (-TAU * c).exp();
        TAU / (1.0 - e) * (1.0 + r * e) / (1.0 + r) - 1.0 / c
    };
    let (mut low, mut high) = if w > 0.0 { (1e-6, 0.3) } else { (-0.5, -1e-6) };
    for _ in 0..200 {
        let middle = (low + high) / 2.0;
        *(if speed(middle) < w { &mut low } else { &mut high }) = middle;
    }
    (low + high) / 2.0
}

/// The orbits exist where the table's speed 0.3 cos t can be W(c): between two folds, with all phases in
/// turn.
#[test]
fn a_branch_whose_phase_goes_round_once_is_closed() {
    let oscillator = "format = \"grazing-scene 1\"\ntitle = \"a ball\"\n[parameters]\nc = 0.01\n[system]\nforce = -1\n\
                      damping = \"c\"\n[[walls]]\nside = \"lower\"\n";
    let machine = "format = \"grazing-scene 2\"\ntitle = \"a ball\"\n[parameters]\nc = 0.01\n[system]\nperiod = \"2*pi\"\n\
                   mass = 1\nforce = -1\ndamping = \"c\"\n[[walls]]\nname = \"t\"\n";
    let folder = tempfile::tempdir().unwrap();
    for (scene, phase) in [(oscillator, 0.9), (machine, 0.9 / TAU)] {
        let scene = format!("{scene}offset = 0\nharmonics = [{{ sin = 0.3 }}]\nrestitution = 0.9\n");
        let keys = format!(
            "parameter = \"c\"\nrange = [-0.5, 0.3]\nstarts = [{{ orbit = {{ pattern = [1], start = [{phase}, 3.3] }} }}]"
        );
        let report = done(&scene, &[task("br", "branch", &keys)], folder.path());
        let mut folds = of_kind(&report, 0, "saddle-node");
        folds.sort_by(f64::total_cmp);
        assert_eq!(folds.len(), 2, "{folds:?}");
        near(folds[0], drag(-0.3), 1e-10);
        near(folds[1], drag(0.3), 1e-10);
        assert_eq!(report["tasks"][0]["starts"][0]["backward"], "the branch is closed", "{report}");
    }
}

/// Flips of a bouncing ball lie on a² = (π(1−r)/(1+r))² + (2(1+r²)/(1+r)²)², down to r = 0, beyond which
/// there is no ball.
#[test]
fn a_curve_reaches_the_end_of_its_range() {
    let scene = "format = \"grazing-scene 1\"\ntitle = \"a ball\"\n[parameters]\na = 1.2\nr = 0.6\n[system]\nforce = -1\n\
                 [[walls]]\nside = \"lower\"\noffset = 0\nharmonics = [{ sin = \"a\" }]\nrestitution = \"r\"\n";
    let folder = tempfile::tempdir().unwrap();
    let first =
        "parameter = \"a\"\nrange = [0.1, 6]\nstarts = [{ at = 1.2, orbit = { pattern = [1], speed = 4 } }]";
    let curve = |label: &str| {
        format!(
            "parameter = \"a\"\nrange = [0.1, 6]\nsecond = \"r\"\nsecond_range = [0, 1]\n\
             starts = [{{ restart = {{ file = \"br.json\", label = \"{label}\" }} }}]"
        )
    };
    let tasks = [task("br", "branch", first), task("f", "branch", &curve("flip 1"))];
    done(scene, &tasks, folder.path());
    let text = fs::read_to_string(folder.path().join("f.json")).unwrap();
    let branch: Value = serde_json::from_str(&text).unwrap();
    let points = branch["points"].as_array().unwrap();
    let ends = [&points[0], &points[points.len() - 1]];
    let end = ends.iter().find(|point| number(&point["parameters"][1]) == 0.0);
    let end = end.unwrap_or_else(|| panic!("{}", branch["ends"]));
    near(number(&end["parameters"][0]), PI.hypot(2.0), 1e-9);
}

/// Between two walls the product of the multipliers is r⁴ e^{−2π/10}: where it is 1 on a curve of pitchforks
/// both are 1.
#[test]
fn a_curve_of_pitchforks_has_its_double_multipliers() {
    let scene = "format = \"grazing-scene 1\"\ntitle = \"two walls\"\n[parameters]\nD = 1.5\nr = 0.7\n[system]\n\
                 damping = \"1/10\"\nstiffness = \"1/4\"\nforcing = [{ cos = 1 }]\n[[walls]]\nside = \"lower\"\n\
                 offset = \"-D\"\nrestitution = \"r\"\n[[walls]]\nside = \"upper\"\noffset = \"D\"\nrestitution = \"r\"\n";
    let folder = tempfile::tempdir().unwrap();
    let first = "parameter = \"D\"\nrange = [0.3, 4]\nstarts = [{ orbit = { pattern = [0, 1], \
                 walls = [\"upper\", \"lower\"], start = [0.326, 1.603, 3.4678, 1.603] } }]";
    let second = "parameter = \"D\"\nrange = [0.05, 4]\nsecond = \"r\"\nsecond_range = [0.05, 1.3]\n\
                  starts = [{ restart = { file = \"br.json\", label = \"crossing 1\" } }]";
    let tasks = [task("br", "branch", first), task("pc", "branch", second)];
    let report = done(scene, &tasks, folder.path());
    let all = labelled(&report, 1);
    let double: Vec<_> = all.iter().filter(|row| row.0.starts_with("1:1-resonance")).collect();
    assert_eq!(double.len(), 1, "{all:?}");
    near(double[0].1[1], (PI / 20.0).exp(), 1e-9);
    assert!(double[0].2["criticality"].as_str().unwrap().contains("codimension two"));
}

fn shaw_and_holmes(length: f64) -> String {
    format!(
        "format = \"grazing-scene 1\"\ntitle = \"one wall\"\n[parameters]\nw = 2.7\n[system]\ndamping = \"1/(10*w)\"\n\
         stiffness = \"1/w^2\"\nforcing = [{{ cos = {length} }}]\n[[walls]]\nside = \"upper\"\noffset = \"{length}/2\"\n\
         restitution = \"4/5\"\n"
    )
}

/// Doublings from 1 to 16 impacts: at the next ones it is the last bits of the flip that decide whether the
/// branch is found. Coefficients from another program; the distances of the flips shrink by
/// Feigenbaum's number.
#[test]
fn a_cascade_is_followed_and_nothing_on_it_is_degenerate() {
    let folder = tempfile::tempdir().unwrap();
    let cascade = |length: f64, doublings: u32| {
        let keys = "parameter = \"w\"\nrange = [2.2, 2.9]\n";
        let first =
            format!("{keys}starts = [{{ at = 2.7, orbit = {{ pattern = [1], speed = {} }} }}]", 3.0 * length);
        let mut tasks = vec![task("c0", "branch", &first)];
        for i in 0..doublings {
            let start =
                format!("{{ restart = {{ file = \"c{i}.json\", label = \"flip 1\", switch = true }} }}");
            tasks.push(task(&format!("c{}", i + 1), "branch", &format!("{keys}starts = [{start}]")));
        }
        done(&shaw_and_holmes(length), &tasks, folder.path())
    };
    let report = cascade(1.0, 4);
    let flips: Vec<f64> = (0..5).map(|i| of_kind(&report, i, "flip")[0]).collect();
    let ratio = (flips[3] - flips[2]) / (flips[4] - flips[3]);
    near(ratio, 4.669, 0.05);
    assert!(report["tasks"][4]["points"].as_u64().unwrap() > 20, "{report}");
    let all = labelled(&report, 2);
    let row = |label: &str| &all.iter().find(|row| row.0 == label).unwrap().2;
    let (turn, flip) = (row("saddle-node 1"), row("flip 2"));
    // At a fold that lies 1e-7 beside a flip the unknowns are known to 1e-9 or so, and this goes with them.
    near(number(&turn["coefficient"]), -1968.5, 0.5);
    near(number(&flip["coefficient"]), 3_283_537.9, 30.0);
    assert_eq!(flip["criticality"], "supercritical");
    // A blank coefficient says why.
    let said = |row: &Value| {
        let why = row["criticality"].as_str().unwrap();
        assert!(why != "degenerate", "{row}");
        assert_eq!(row["coefficient"].is_null(), why.starts_with("none: "), "{row}");
    };
    (0..4).for_each(|task| labelled(&report, task).iter().for_each(|row| said(&row.2)));
    let other = cascade(0.25, 2);
    for task in 0..2 {
        let (one, other) = (labelled(&report, task), labelled(&other, task));
        assert_eq!(one.len(), other.len());
        for (a, b) in one.iter().zip(&other) {
            assert_eq!((&a.0, &a.2["criticality"]), (&b.0, &b.2["criticality"]));
        }
    }
    labelled(&other, 2).iter().for_each(|row| said(&row.2));
}

/// Re d = 0.235 at the end of this curve, in a 1:2 resonance: no change of sign.
#[test]
fn a_coefficient_without_meaning_makes_no_chenciner_point() {
    let scene = r#"
format = "grazing-scene 2"
title = "three masses"
[parameters]
T = 1.9320151473683986
F = 4.153532128348115
[system]
period = "T"
mass = { diagonal = [1.8844584302967116, 0.9391529918365564, 0.5611421538307966] }
damping = [[0.3953204332251776, -0.18541932580645573, 0.0], [-0.18541932580645573, 0.35563169559142205, -0.13028434056495988], [0.0, -0.13028434056495988, 0.15414126324900396]]
stiffness = [[3.5291349333254556, -2.0760279156682433, 0.0], [-2.0760279156682433, 3.534742787005933, -1.4587148713376896], [0.0, -1.4587148713376896, 1.4587148713376896]]
forcing = [{ cos = [0, 0, "F"] }]
[[walls]]
name = "w"
row = [0, 0, 1]
offset = -0.5006163191850979
restitution = 0.5502526412262536
"#;
    let folder = tempfile::tempdir().unwrap();
    let first = "parameter = \"F\"\nrange = [0.05, 30.0]\n\
                 starts = [{ orbit = { pattern = [1], start = [0.955, 0.8793390161395256] } }]";
    let second = "parameter = \"F\"\nrange = [0.01, 60.0]\nsecond = \"T\"\nsecond_range = [0.5796045442105195, 4.83]\n\
                  starts = [{ restart = { file = \"br.json\", label = \"neimark-sacker 1\" } }]\n\
                  options = { most_step = 0.02, points = 1500 }";
    let report = done(scene, &[task("br", "branch", first), task("c0", "branch", second)], folder.path());
    let resonance = of_kind(&report, 1, "1:2-resonance");
    assert_eq!(resonance.len(), 1);
    let found = of_kind(&report, 1, "chenciner");
    // Those that are some: elsewhere on the curve.
    assert_eq!(found.len(), 2, "{found:?}");
    near(found[0], 6.685_198_462_8, 1e-6);
    near(found[1], 6.198_167_592_0, 1e-6);
}

/// The flights that a row's pattern and times say, in periods: all positive, and their sum is the period.
fn flights(row: &Value) -> Vec<f64> {
    let pattern = row["pattern"].as_str().unwrap();
    let count = |part: &str| part.split_whitespace().next().unwrap().parse::<f64>().unwrap();
    let periods: Vec<f64> = pattern.split(',').map(count).collect();
    let times: Vec<f64> = row["phases"].as_array().unwrap().iter().map(number).collect();
    assert!((0.0..1.0).contains(&times[0]), "{row}");
    let m = times.len();
    let all: Vec<f64> = (0..m).map(|i| periods[i] + times[(i + 1) % m] - times[i]).collect();
    assert!(all.iter().all(|flight| *flight > 0.0), "{row}");
    near(all.iter().sum(), periods.iter().sum(), 1e-12);
    all
}

/// Whichever way round the impacts are counted, a row's pattern and times are those of one motion.
#[test]
fn the_pattern_and_the_times_of_a_row_fit_each_other() {
    let walls = "format = \"grazing-scene 1\"\ntitle = \"two walls\"\n[system]\ndamping = 0.1\nstiffness = 2\n\
                 forcing = [{ cos = -1 }]\n[[walls]]\nside = \"lower\"\noffset = -0.5\nrestitution = 0.8\n[[walls]]\n\
                 side = \"upper\"\noffset = 0.5\nrestitution = 0.8\n";
    let folder = tempfile::tempdir().unwrap();
    let orbit = |periods: &str| {
        let keys = format!(
            "orbit = {{ pattern = {periods}, walls = [\"lower\", \"upper\"], speed = 3, starts = 500 }}"
        );
        task("a", "orbit", &keys)
    };
    for periods in ["[0, 1]", "[1, 0]"] {
        let report = done(walls, &[orbit(periods)], folder.path());
        let rows = report["tasks"][0]["orbits"].as_array().unwrap();
        assert!(rows.len() >= 3, "{report}");
        let all: Vec<Vec<f64>> = rows.iter().map(flights).collect();
        // The symmetric orbit: half a period each way.
        let half = |flights: &Vec<f64>| flights.iter().all(|flight| (flight - 0.5).abs() < 1e-9);
        assert!(all.iter().any(half), "{all:?}");
    }
    let paper = "format = \"grazing-scene 1\"\ntitle = \"the paper's\"\n[system]\ndamping = \"12/49\"\nstiffness = \"100/2401\"\n\
                 [[walls]]\nside = \"lower\"\noffset = -1\nharmonics = [{ k = 1, cos = \"10001/10000\" }]\nrestitution = 1\n";
    for second in [6.283_149_875_937_45, -3.543_124_213_647e-5] {
        let keys = format!(
            "orbit = {{ pattern = [1, 2], start = [2.8243327463123936e-06, 2.1890682742182467e-05, {second}, \
             4.662786298573949e-05] }}"
        );
        let (report, _, error) = run(paper, &[task("o", "orbit", &keys)], folder.path());
        let rows = report["tasks"][0]["orbits"].as_array().unwrap_or_else(|| panic!("{error}{report}"));
        assert!(!rows.is_empty());
        rows.iter().for_each(|row| drop(flights(row)));
    }
}

/// The picture names every event of the table: what is one dot on paper under one text, with how many there
/// are.
#[test]
fn every_event_of_the_table_is_in_the_picture() {
    let folder = tempfile::tempdir().unwrap();
    let keys = "parameter = \"w\"\nrange = [0.5, 4]\nstarts = [{ at = 0.9, attractor = { q = 0 } }, \
                { at = 2.6, attractor = { q = 0 } }]";
    let report = done(BILINEAR, &[task("br", "branch", keys)], folder.path());
    let picture = fs::read_to_string(folder.path().join("br.svg")).unwrap();
    for kind in ["crossing", "flip", "saddle-node"] {
        let drawn: usize = picture
            .match_indices(kind)
            .map(|(at, _)| {
                let rest = picture[at + kind.len()..].trim_start();
                let count = rest.strip_prefix('×').map(|rest| rest.chars().next().unwrap());
                count.map_or(1, |digit| digit.to_digit(10).unwrap() as usize)
            })
            .sum();
        assert_eq!(drawn, of_kind(&report, 0, kind).len(), "{kind}");
    }
}
