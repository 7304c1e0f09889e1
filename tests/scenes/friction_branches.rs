//! Branches of orbits among dry friction, through what changes of sticking and sliding: against a closed
//! form, and against simulations.

use std::f64::consts::{PI, TAU};

use grazing_scenes::{
    many::{
        Machine,
        simulate::{Event, Simulator},
    },
    motion::{RunEnd, Time},
    scene::Scene,
};
use serde_json::Value;

use crate::tasks::{run, task};

/// A mass on a spring and a belt, in the forcing's phase.
const BELT: &str = "format = \"grazing-scene 3\"\ntitle = \"t\"\n[parameters]\nF = 1\nN = 1.2\nk = 4\nd = 0.4\nv = 1.2\ns = 1\n\
                    [system]\nfrequency = \"1/(2*pi)\"\nstiffness = \"k\"\ndamping = \"d\"\nforcing = [{ cos = \"F\" }]\n\
                    [[friction]]\nnormal = \"N\"\ncoefficient = 1\nstatic_coefficient = \"s\"\nspeed = \"v\"\n";

fn labels(report: &Value) -> Vec<(String, f64)> {
    let rows = report["labels"].as_array().unwrap_or_else(|| panic!("{report}")).iter();
    let one = |row: &Value| {
        let name = row["label"].as_str().unwrap().rsplit_once(' ').unwrap().0.to_string();
        (name, row["parameters"][0].as_f64().unwrap())
    };
    rows.map(one).collect()
}

/// Den Hartog's motion without stops sticks beyond where at its turns X, in units of the force's amplitude,
/// is F_s: the pull there is (1 − k) X by the equation of motion of its linear part, so that F_s = X, and
/// with F_s = s F it is F = 1/(|k − 1| √(s² + tan²(√k π/2)/k)). The branch goes on beyond, stopping at each
/// turn.
#[test]
fn motions_begin_to_stick_where_den_hartog_says() {
    let folder = tempfile::tempdir().unwrap();
    for (k, s) in [(2.6f64, 1.0f64), (0.5, 1.0), (2.6, 1.3), (0.2, 1.1)] {
        let tangent = (k.sqrt() * PI / 2.0).tan();
        let wanted = 1.0 / ((k - 1.0).abs() * (s * s + tangent * tangent / k).sqrt());
        let scene = BELT
            .replace("v = 1.2", "v = 0")
            .replace("d = 0.4", "d = 0")
            .replace("k = 4", &format!("k = {k}"))
            .replace("s = 1", &format!("s = {s}"))
            .replace("N = 1.2", &format!("N = {}", 0.7 * wanted));
        let keys = format!(
            "parameter = \"N\"\nrange = [{}, {}]\nstarts = [{{ orbit = {{ pattern = [] }} }}]",
            0.6 * wanted,
            1.05 * wanted
        );
        let (report, code, error) = run(&scene, &[task("b", "branch", &keys)], folder.path());
        let report = &report["tasks"][0];
        let found = labels(report);
        println!("{k} {s}: {found:?} {wanted}");
        assert_eq!(code, 0, "{error}{report}");
        let [(name, at)] = &found[..] else { panic!("{found:?}") };
        assert_eq!(name, "crossing-sliding");
        assert!((at - wanted).abs() < 1e-10, "{k} {s}: {at} {wanted}");
        for end in ["backward", "forward"] {
            assert_eq!(report["starts"][0][end], "a parameter is at its bound", "{report}");
        }
    }
}

/// The scene's machine with this amplitude of the force.
fn forced(scene: &str, force: f64) -> Machine<f64> {
    let scene = scene.replace("F = 1\n", &format!("F = {force:e}\n"));
    Scene::from_toml(&scene, "belt.toml").unwrap().machine(&[]).unwrap()
}

/// The state at phase 0 and what happens over a period, long after the start.
fn seen(force: f64) -> (f64, Vec<&'static str>) {
    let simulator = Simulator::suited(&forced(BELT, force), None, &[]).unwrap();
    let mut run = simulator.start(Time::new(0, 0.0), &[0.0], &[0.0]).unwrap();
    run.finish(Time::new(300, 0.0));
    let state = run.state();
    let mut told: Vec<(&'static str, f64)> = Vec::new();
    let end = run.record(Time::new(301, 0.0), |event| {
        let word = match event {
            Event::Stick(_) => "stick",
            Event::Release(_) => "release",
            Event::Reversal(_) => "reversal",
            _ => return,
        };
        told.push((word, TAU * event.time().unwrap().periods()));
    });
    assert_eq!(end, RunEnd::Reached);
    // What lets go with F_s = F_k may be caught and let go again within rounding.
    while let Some(i) = (0..told.len().saturating_sub(2)).find(|&i| {
        told[i + 2].1 - told[i].1 < 1e-4 && told[i].0 == told[i + 2].0 && told[i].0 != told[i + 1].0
    }) {
        told.drain(i + 1..i + 3);
    }
    (state.q()[0], told.into_iter().map(|one| one.0).collect())
}

/// The branch over the force's amplitude has all four: every point of it is where long simulations end, and
/// every label where what happens in these changes, by bisection, and changes as its name says.
#[test]
fn a_branch_over_the_force_has_its_sliding_bifurcations_where_simulations_change() {
    let folder = tempfile::tempdir().unwrap();
    let keys = "parameter = \"F\"\nrange = [0.6, 10]\nstarts = [{ attractor = { q = 0 } }]";
    let (report, code, error) = run(BELT, &[task("b", "branch", keys)], folder.path());
    let report = &report["tasks"][0];
    assert_eq!(code, 0, "{error}{report}");
    let found = labels(report);
    println!("{found:?}");
    let turned = |word: &[&'static str], less: &[&'static str]| {
        (0..word.len().max(1)).any(|turn| {
            let n = word.len();
            n == less.len() && (0..n).all(|i| word[(i + turn) % n] == less[i])
        })
    };
    let mut names = Vec::new();
    for (name, at) in &found {
        let (mut low, mut high) = (at - 2e-4, at + 2e-4);
        let (before, after) = (seen(low).1, seen(high).1);
        println!("{name} {at}: {before:?} {after:?}");
        for _ in 0..28 {
            let middle = 0.5 * (low + high);
            if turned(&seen(middle).1, &before) { low = middle } else { high = middle }
        }
        println!("  {}", low - at);
        assert!((low - at).abs() < 1e-8, "{name}: {low} {at}");
        // What the name says that it adds, on one side or the other.
        let (less, more) = if before.len() < after.len() { (before, after) } else { (after, before) };
        let count = |word: &[&'static str], what: &str| word.iter().filter(|known| **known == what).count();
        let added = ["stick", "release", "reversal"]
            .map(|what| count(&more, what) as i32 - count(&less, what) as i32);
        let wanted = match name.as_str() {
            "crossing-sliding" => [1, 1, -1],
            "switching-sliding" => [0, 0, 1],
            _ => [1, 1, 0],
        };
        assert_eq!(added, wanted, "{name}: {less:?} {more:?}");
        names.push(name.as_str());
    }
    names.sort_unstable();
    names.dedup();
    assert_eq!(names, ["adding-sliding", "crossing-sliding", "grazing-sliding", "switching-sliding"]);
    // Every sixth point, by its place at phase 0.
    let text = std::fs::read_to_string(folder.path().join("b.csv")).unwrap();
    let points: Vec<(f64, f64)> = text
        .lines()
        .skip(1)
        .filter_map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            // An empty one parts curves.
            Some((cells.get(1)?.parse().ok()?, cells.get(2)?.parse().ok()?))
        })
        .collect();
    assert!(points.len() > 60, "{}", points.len());
    for (force, place) in points.iter().step_by(6) {
        let (q, _) = seen(*force);
        assert!((q - place).abs() < 1e-10, "{force}: {q} {place}");
    }
}

/// Where something sticks all the time there is an orbit for each place: one is found, none is followed.
#[test]
fn what_sticks_for_ever_has_an_orbit_and_no_branch() {
    let folder = tempfile::tempdir().unwrap();
    let scene = BELT.replace("v = 1.2", "v = 0").replace("N = 1.2", "N = 2");
    let orbit = task("o", "orbit", "orbit = { pattern = [] }");
    let branch =
        task("b", "branch", "parameter = \"F\"\nrange = [0.6, 1.5]\nstarts = [{ attractor = { q = 0 } }]");
    let (report, code, error) = run(&scene, &[orbit, branch], folder.path());
    assert_eq!(code, 3, "{error}{report}");
    let orbits = report["tasks"][0]["orbits"].as_array().unwrap();
    assert_eq!(orbits.len(), 1, "{report}");
    let multipliers = &orbits[0]["multipliers"];
    assert!((multipliers[0][0].as_f64().unwrap() - 1.0).abs() < 1e-12, "{multipliers}");
    assert_eq!(multipliers[1][0], 0.0, "{multipliers}");
    assert_eq!(orbits[0]["stable"], "marginal", "{report}");
    let reason = report["tasks"][1]["starts"][0]["reason"].as_str().unwrap();
    assert!(reason.contains("friction friction sticks all the time"), "{reason}");
}

/// A stop among friction: the branch of an orbit with two impacts ends where one fades and where a third
/// comes, though what stands still at the stop is where friction turns, too; both where the numbers of
/// impacts of simulations change.
#[test]
fn branches_with_impacts_among_friction_end_where_simulations_gain_or_lose_one() {
    let folder = tempfile::tempdir().unwrap();
    let scene = BELT.replace("v = 1.2", "v = 0").replace("N = 1.2", "N = 0.3").replace("d = 0.4", "d = 0.2");
    let scene = format!("{scene}[[stops]]\noffset = -0.3\nrestitution = 0.7\n");
    let keys = "parameter = \"F\"\nrange = [1, 3]\nstarts = [{ attractor = { q = 0 } }]";
    let begun = scene.replace("F = 1\n", "F = 1.6\n");
    let (report, code, error) = run(&begun, &[task("b", "branch", keys)], folder.path());
    let report = &report["tasks"][0];
    assert_eq!(code, 0, "{error}{report}");
    let impacts = |force: f64| {
        let simulator = Simulator::suited(&forced(&scene, force), None, &[]).unwrap();
        let mut run = simulator.start(Time::new(0, 0.0), &[0.0], &[0.0]).unwrap();
        run.finish(Time::new(300, 0.0));
        let before = run.impacts();
        run.finish(Time::new(301, 0.0));
        run.impacts() - before
    };
    let found = labels(report);
    println!("{found:?}");
    for (name, [mut low, mut high], counts) in
        [("fade", [1.45f64, 1.5], [1, 2]), ("grazing", [1.85, 1.95], [2, 3])]
    {
        assert_eq!([impacts(low), impacts(high)], counts);
        for _ in 0..30 {
            let middle = 0.5 * (low + high);
            if impacts(middle) == counts[0] { low = middle } else { high = middle }
        }
        let known = found.iter().find(|label| label.0 == name).unwrap_or_else(|| panic!("{name}: {found:?}"));
        println!("{name} {low} {}", known.1 - low);
        assert!((known.1 - low).abs() < 1e-8, "{name}: {low} {known:?}");
    }
}
